"""Texts of parts of messages: quantities, and items of lists."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    "item.list_row": N_("{file}, row {row:n}: {name}"),
    "item.more": Plural("{count:n} more", "{count:n} more"),
    # -- quantities --------------------------------------------------------------------------
    "quantity.north": N_("north"),
    "quantity.east": N_("east"),
    "quantity.down": N_("down"),
    "quantity.roll": N_("roll"),
    "quantity.pitch": N_("pitch"),
    "quantity.yaw": N_("yaw"),
    "quantity.heading": N_("heading"),
    "quantity.x_rotation": N_("X rotation"),
    "quantity.y_rotation": N_("Y rotation"),
    "quantity.z_rotation": N_("Z rotation"),
    "quantity.lever_x": N_("lever arm X"),
    "quantity.lever_y": N_("lever arm Y"),
    "quantity.lever_z": N_("lever arm Z"),
    "quantity.range_offset": N_("range offset"),
    "quantity.scan_angle_offset": N_("scan-angle offset"),
    "quantity.latency": N_("latency"),
    "amount.m": N_("{value:m.4} m"),
    "amount.deg": N_("{value:deg.4}°"),
    "amount.ms": N_("{value:ms.2} ms"),
    "change.m": N_("{value:m.4+} m"),
    "change.deg": N_("{value:deg.4+}°"),
    "change.ms": N_("{value:ms.2+} ms"),
    "item.range_offset": N_("range offset {value:m.4+} m"),
    "item.scan_angle_offset": N_("scan-angle offset {value:deg.4+}°"),
    "item.latency": N_("latency {value:ms.4+} ms"),
    # -- sightings and targets ---------------------------------------------------------------
    "item.sighting": N_("{target} on line {line}"),
    "item.sighting_shifted": N_(
        "{target} on line {line} (displaced by {shift:mm.1} mm, test value w = {w:x.1+})"
    ),
    "item.sighting_angles": N_("{target} on line {line} ({angles:names})"),
    "item.target_angles": N_("{target} ({angles:names})"),
    "item.target_sightings": Plural(
        "{count:n} sighting of targets", "{count:n} sightings of targets"
    ),
    "item.plane_sightings": Plural(
        "{count:n} sighting of validation planes", "{count:n} sightings of validation planes"
    ),
    "item.doubtful": Plural("{count:n} doubtful", "{count:n} doubtful"),
    "item.poor": Plural("{count:n} poor", "{count:n} poor"),
    "item.share_of_points": N_("{share:percent.0} % of the points of {target}"),
    "item.points_in_common": N_("{one} with {other} ({share:percent.0} % on {line})"),
    "item.apart": N_(
        "{distance:mm.0} mm and {angle:deg.2}° at an inclination of {inclination:deg.0}°"
    ),
    "item.other_surface": N_("{line} (at {places:n} of {total:n} places, {distance:m.2} m away)"),
    "item.mean_distance": N_("{name} ({mean:mm.1+} mm, ± {interval:mm.1} mm)"),
    # -- angles ------------------------------------------------------------------------------
    "item.assumed_lidar": N_("LiDAR noise {sigma:mm.1} mm"),
    "item.assumed_position": N_(
        "position {north:m.3} m, {east:m.3} m, {down:m.3} m (north, east, down)"
    ),
    "item.assumed_attitude": N_(
        "attitude {roll:deg.4}°, {pitch:deg.4}°, {heading:deg.4}° (roll, pitch, heading)"
    ),
    "item.angle_sigma": N_("{angle} {sigma:deg.2}°"),
    "item.sigma_increase": N_("{angle} {increase:percent.0} % (without {line})"),
    "item.angle_raised": N_("{angle} from {before:deg.4} to {after:deg.4}°"),
    "item.angle_predicted": N_("{angle} {sigma:deg.4} instead of {predicted:deg.4}°"),
    "item.angle_difference": N_("{angle} {difference:deg.2+}°"),
    "item.angle_changed": N_(
        "{angle} by {change:deg.4+}° ({ratio:x.1} times its standard deviation)"
    ),
    "item.without_line": N_(
        "without line {name} ({angle} {difference:deg.4+}°, {ratio:x.1} times its standard "
        "deviation)"
    ),
    "item.without_target": N_(
        "without target {name} ({angle} {difference:deg.4+}°, {ratio:x.1} times its standard "
        "deviation)"
    ),
    "item.halves": N_(
        "second minus first half of the data ({angle} {difference:deg.4+}°, {ratio:x.1} times "
        "its standard deviation)"
    ),
    "item.half_difference": N_(
        "{angle} {difference:deg.4+|interval}° ± {interval:deg.4|difference}° (criterion "
        "{limit:deg.4}°)"
    ),
    "suspect.heights": N_("heights"),
    "suspect.time": N_("time"),
    "suspect.roll_sign": N_("sign of roll"),
    "suspect.pitch_sign": N_("sign of pitch"),
    "suspect.attitude_signs": N_("signs of roll and pitch"),
    # -- causes of residuals -----------------------------------------------------------------
    "cause.larger": N_("{parameter} larger by {amount}"),
    "cause.smaller": N_("{parameter} smaller by {amount}"),
    "cause.opposite_sign": N_("{parameter} of the opposite sign, changed by {amount}"),
    "cause.line_boresight": N_("different boresight angles on line {line}"),
    "cause.line_position": N_("position error of {shift:mm.1} mm on line {line}"),
    "cause.times_early": N_("point times of line {line} {offset:ms.2} ms early"),
    "cause.times_late": N_("point times of line {line} {offset:ms.2} ms late"),
    "cause.sighting_surface": N_("another surface instead of {target} on line {line}"),
    "cause.target_surface": N_("target {target} is not one flat surface"),
    "cause.sighting_shift": N_("target {target} displaced by {shift:mm.1} mm on line {line}"),
    "cause.several_scanners": N_("points of several scanners in one line"),
    "cause.several_sources": N_("points of several sources in one line"),
    "cause.same_time": N_("several lines recorded at the same time"),
    "cause.time_resolution": N_("point times of low resolution"),
    "cause.height_offset": N_("a constant error of the heights"),
    "cause.time_offset": N_("a constant error of the point times"),
    "cause.lever_arm": N_("a cloud computed with another lever arm"),
    "cause.attitude_sign": N_("a wrong sign of the attitude"),
    "cause.off_the_beams": N_("recovered points that do not lie on the scanner beams"),
    "cause.position_held": N_("positions that are repeated while the vessel moves"),
    "cause.rate_too_low": N_("a trajectory with too low a rate"),
    "cause.trajectory_gap": N_("a gap of the trajectory"),
}
