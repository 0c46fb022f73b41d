"""Texts of messages about the adjustment."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- observations ------------------------------------------------------------------------------
    "adjustment.no_targets": N_("There is no target to adjust. Pick targets first."),
    "adjustment.few_points": Plural(
        "Target {target} has only {count:n} point in line {line}, and at least three are needed. "
        "Pick it again, or exclude that line.",
        "Target {target} has only {count:n} points in line {line}, and at least three are needed. "
        "Pick it again, or exclude that line.",
    ),
    "adjustment.point_not_finite": N_(
        "The coordinates of a point contain NaN or infinity. Exclude the point."
    ),
    "adjustment.position_not_finite": N_(
        "The position at a point contains NaN or infinity. Exclude the point."
    ),
    "adjustment.attitude_not_finite": N_(
        "The attitude at a point contains NaN or infinity. Exclude the point."
    ),
    "adjustment.time_not_finite": N_("The time of a point is NaN or infinite. Exclude the point."),
    "adjustment.point_in_scanner": N_(
        "A point lies at the origin of the scanner. Exclude the point."
    ),
    "adjustment.sigma_lidar": N_(
        "A standard deviation of the LiDAR is negative, NaN or infinite. Correct it."
    ),
    "adjustment.sigma_position": N_(
        "A standard deviation of the position is negative, NaN or infinite. Correct it."
    ),
    "adjustment.sigma_attitude": N_(
        "A standard deviation of the attitude is negative, NaN or infinite. Correct it."
    ),
    "adjustment.sigma_lidar_zero": N_(
        "The standard deviation of the LiDAR must be above zero. Correct it."
    ),
    "adjustment.budget_distances": N_(
        "The error budget needs distances in metres, each above zero. Correct them."
    ),
    # -- geometry ----------------------------------------------------------------------------------
    "adjustment.singular": N_(
        "The points do not determine the boresight and the targets. Add targets or lines."
    ),
    "adjustment.shape_undetermined": N_(
        "The points of a target do not determine its shape. Pick points that are spread over it in "
        "two directions."
    ),
    "adjustment.one_line": N_(
        "All sightings are in line {line}, and a surface seen once fits any boresight. Add lines "
        "in other directions over the same targets."
    ),
    "adjustment.undetermined": N_(
        "These lines and targets do not determine the boresight, mainly not {direction}. {action}"
    ),
    "adjustment.undetermined_because": N_(
        "These lines and targets do not determine the boresight, mainly not {direction}. {reason} "
        "{action}"
    ),
    "adjustment.angle_roll": N_("roll"),
    "adjustment.angle_pitch": N_("pitch"),
    "adjustment.angle_yaw": N_("yaw"),
    "adjustment.angle_with_one": N_("{first} together with {second}"),
    "adjustment.angle_with_two": N_("{first} together with {second} and {third}"),
    "adjustment.parallel_lines": N_("All lines run parallel."),
    "adjustment.single_target": N_("{target} is the only target."),
    "adjustment.one_orientation": N_("All targets face the same way."),
    "adjustment.parallel_lines_one_target": N_(
        "All lines run parallel, and {target} is the only target."
    ),
    "adjustment.parallel_lines_one_orientation": N_(
        "All lines run parallel, and all targets face the same way."
    ),
    "adjustment.add_target": N_(
        "Add another target, or lines in other directions: a vertical target determines roll on "
        "lines along it, pitch and yaw on lines at 45 deg to it."
    ),
    "adjustment.add_orientation": N_(
        "Add a target with a different orientation, or lines in other directions: a vertical "
        "target determines roll on lines along it, pitch and yaw on lines at 45 deg to it."
    ),
    "adjustment.only_plane": N_(
        "{target} is the only target and a plane: only the headings of the lines separate the "
        "angles. Add a target with a different orientation, or a sphere. If there is none, choose "
        '"Accept targets that all face one way" under Advanced (--accept-one-facing at the command '
        "line)."
    ),
    "adjustment.parallel_planes": N_(
        "All targets are planes that face the same way: only the headings of the lines separate "
        "the angles. Add a target with a different orientation, or a sphere. If there is none, "
        'choose "Accept targets that all face one way" under Advanced (--accept-one-facing at the '
        "command line)."
    ),
    # -- iterations --------------------------------------------------------------------------------
    "adjustment.not_converged": N_(
        "The adjustment did not converge in {iterations:n} iterations (last change: {angles:deg} "
        "deg in the angles, {rest:mm} mm in the other values). Check that each target is the same "
        "surface in every line, and check the prior boresight."
    ),
    "adjustment.diverged": N_(
        "The adjustment diverged. Check that each target is the same surface in every line, and "
        "check the prior boresight."
    ),
    "adjustment.target_disagrees": N_(
        "No point of target {target} agrees with the other targets and lines. Pick the target "
        "again, or exclude it."
    ),
    # -- values that the data contradict -----------------------------------------------------------
    "adjustment.contradicts_lever_arm": N_(
        "The data contradict the given {axis} of the lever arm: they fit a value that differs by "
        "{change:m.4+} m, and with the given value they do not determine the boresight. Measure it "
        "again, or estimate it."
    ),
    "adjustment.contradicts_range_offset": N_(
        "The data contradict the given range offset: they fit a value that differs by "
        "{change:m.4+} m, and with the given value they do not determine the boresight. Measure it "
        "again, or estimate it."
    ),
    "adjustment.contradicts_scan_angle_offset": N_(
        "The data contradict the given scan-angle offset: they fit a value that differs by "
        "{change:deg.4+} deg, and with the given value they do not determine the boresight. "
        "Measure it again, or estimate it."
    ),
    "adjustment.contradicts_latency": N_(
        "The data contradict the given latency: they fit a value that differs by {change:ms.2+} "
        "ms, and with the given value they do not determine the boresight. Measure it again, or "
        "estimate it."
    ),
    # -- observability -----------------------------------------------------------------------------
    "observability.directions": N_(
        "The weakest direction is {weakest}, with a standard deviation of {weakest_sigma:deg.3} "
        "deg. The strongest is {strongest}, with {strongest_sigma:deg.3} deg."
    ),
    "observability.main_lines": Plural(
        "Mainly line {lines:names} determines {angle}. Without {line}, its standard deviation is "
        "{without:deg} deg instead of {sigma:deg} deg.",
        "Mainly lines {lines:names} determine {angle}. Without {line}, its standard deviation is "
        "{without:deg} deg instead of {sigma:deg} deg.",
    ),
    "observability.no_main_line": N_(
        "The standard deviation of {angle} does not depend on any single line."
    ),
    "observability.one_sphere": N_(
        "{target} is the only target, so that a deformation or displacement of it cannot be "
        "detected. Add another target."
    ),
    # -- values that are not estimated -------------------------------------------------------------
    "parameter.rotates_like_boresight": N_(
        "These lines and targets do not determine the {parameter}: like the boresight, it rotates "
        "the points about the axis of the scanner. {kept}"
    ),
    "parameter.raises_all_lines": N_(
        "These lines and targets do not determine the {parameter}: on level lines it moves the "
        "points of all lines up or down alike. {kept}"
    ),
    "parameter.not_separated": N_(
        "These lines and targets do not determine the {parameter}: its effect cannot be separated "
        "from that of {other} or of the positions of the targets. {kept}"
    ),
    "parameter.kept": N_("The given value is used."),
    "parameter.kept_uncertain": N_(
        "The given value is used, and its standard deviation is part of those of the angles."
    ),
    "parameter.not_classical": N_(
        "With uncorrelated POS errors, the {parameter} would be wrong and its standard deviation "
        "far too small. The given value is used. To estimate it, use correlated POS errors."
    ),
    # -- parts of the data -------------------------------------------------------------------------
    "cross_check.no_common_target": N_("No target is left on two lines."),
    # -- variance components -----------------------------------------------------------------------
    "component.larger": N_("applied: larger than given"),
    "component.smaller": N_("applied: smaller than given"),
    "component.not_determined": N_("not applied: not determined by the data"),
    "component.as_given": N_("not applied: the given value lies within the interval"),
    "component.too_small": N_("not applied: too small a change, or too weakly determined"),
}
