"""Texts of messages about the files of a survey and their points."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- trajectory accuracy -----------------------------------------------------------------
    "accuracy.too_large": N_(
        "{file}: {count:n} records ({share:percent.2} %) have standard deviations over 10,000 m or "
        "180 deg, as exporters write them where there is no solution. Points at these times have "
        "no weight in the adjustment. Export the file again, or check the solution at these times."
    ),
    # -- points of a line --------------------------------------------------------------------
    "audit.time_resolution": N_(
        "{line}: point times are in steps of {step:ms} ms, with {points:n} points to each step. "
        "Positions of points are off by up to {shift:mm} mm and attitudes by up to {turn:deg} deg, "
        "which does not average out. Export the line with exact times (64 bits)."
    ),
    "audit.time_steps": N_(
        "{line}: point times are in steps of {step:ms} ms, with {points:n} points to each step. "
        "Positions and attitudes of points are off by the motion within half a step, which does "
        "not average out. Export the line with exact times (64 bits)."
    ),
    "audit.first_points": N_(
        "{file}: the first {count:n} points were checked. The import checks all of them."
    ),
    "file.split": N_("The file becomes {count:n} lines: {lines:names}."),
    "audit.not_finite": N_(
        "{line}: {count:n} points ({share:percent.2} %) have values that are not numbers. "
        "They are excluded."
    ),
    "audit.no_range": N_(
        "{line}: {count:n} points ({share:percent.2} %) have no range or one value for x, y and z: "
        "shots without an echo. "
        "They are excluded."
    ),
    "audit.too_far": N_(
        "{line}: {count:n} points ({share:percent.2} %) lie beyond the largest range of the "
        "scanner. They are excluded."
    ),
    "audit.duplicates": N_(
        "{line}: {count:n} points ({share:percent.2} %) are exact copies of other points. "
        "They are excluded."
    ),
    "audit.withheld": N_(
        "{line}: {count:n} points ({share:percent.2} %) have the withheld flag. They are excluded."
    ),
    "audit.of_classes": N_(
        "{line}: {count:n} points ({share:percent.2} %) are excluded by their class."
    ),
    "audit.not_selected": N_(
        "{line}: {count:n} points ({share:percent.2} %) do not meet the conditions given for the "
        "line. They are excluded."
    ),
    "audit.beyond_range": N_(
        "{line}: the imported points reach {distance:km.1} km from the scanner, farther than its "
        "largest range of {limit:km.1} km. Results from these points are wrong. Check the file of "
        "the line, then import the line again."
    ),
    "audit.not_checked": N_(
        "{line} was imported by an earlier version, which did not check its points. "
        "Import the line again."
    ),
    "audit.noise_classes": N_(
        "{line}: {count:n} points are classified as noise (class {classes:names}). "
        "They may lie off the targets. Exclude these classes."
    ),
    "audit.several_scanners": N_(
        "{line}: the file holds points of {count:n} scanners ({attribute} {values:names}). "
        "Each scanner has its own boresight and lever arm, so one boresight for all is wrong. "
        "Split the line, or use one scanner."
    ),
    "audit.several_sources": N_(
        "{line}: the file holds points of {count:n} sources ({attribute} {values:names}): "
        "several passes or several scanners. Passes that count as one line are not compared with "
        "each other, and one boresight does not fit several scanners. Split the line, or use one "
        "source."
    ),
    "audit.several_passes": N_(
        "{line}: the file holds {count:n} passes, separated by pauses in which the vessel turned. "
        "They count as one line and are not compared with each other. Split the line."
    ),
    "trajectory.rate_too_low": N_(
        "{line}: the trajectory has {rate:hz} states a second, too few for its motion. Between the "
        "states the interpolation is off by up to {shift:mm} mm and {turn:deg} deg, "
        "{share:percent} % of the stated accuracy. Export the trajectory at a higher rate."
    ),
    # -- recovery of georeferenced lines -----------------------------------------------------
    "recovery.height_offset": N_(
        "{line}: the heights less those of the trajectory are {offset:m.1} m, as with heights "
        "above sea level and an ellipsoidal trajectory. The recovered points do not lie on the "
        "beams of the scanner (off by {misfit:mm} mm), and the angles will be wrong. Give the "
        "vertical reference, or {value:m.1} m to be added."
    ),
    "recovery.time_offset": N_(
        "{line}: the points fit the beams of the scanner only with {value:s} s added to their "
        "times. The recovered points are off by {misfit:mm} mm, and the angles will be wrong. "
        "Check the time base of the line."
    ),
    "recovery.lever_arm_x": N_(
        "{line}: the points fit the beams of the scanner only with {value:m.2} m added to the "
        "lever arm forward. The cloud was made with another lever arm (recovered points are off "
        "by {misfit:mm} mm). Give the lever arm that made the cloud."
    ),
    "recovery.lever_arm_y": N_(
        "{line}: the points fit the beams of the scanner only with {value:m.2} m added to the "
        "lever arm to the left. The cloud was made with another lever arm (recovered points are "
        "off by {misfit:mm} mm). Give the lever arm that made the cloud."
    ),
    "recovery.lever_arm_z": N_(
        "{line}: the points fit the beams of the scanner only with {value:m.2} m added to the "
        "lever arm up. The cloud was made with another lever arm (recovered points are off by "
        "{misfit:mm} mm). Give the lever arm that made the cloud."
    ),
    "recovery.roll_sign": N_(
        "{line}: the points fit the beams of the scanner only with the opposite sign of roll (off"
        " by {misfit:mm} mm otherwise). The angles will be wrong. Check the signs of the "
        "trajectory."
    ),
    "recovery.pitch_sign": N_(
        "{line}: the points fit the beams of the scanner only with the opposite sign of pitch "
        "(off by {misfit:mm} mm otherwise). The angles will be wrong. Check the signs of the "
        "trajectory."
    ),
    "recovery.roll_pitch_signs": N_(
        "{line}: the points fit the beams of the scanner only with the opposite signs of roll and"
        " pitch (off by {misfit:mm} mm otherwise). The angles will be wrong. Check the signs of "
        "the trajectory."
    ),
    "recovery.several_causes": N_(
        "{line}: the recovered points do not lie on the beams of the scanner (off by {misfit:mm} "
        "mm), and the angles will be wrong. Several causes explain it: {causes:names}. Check "
        "them."
    ),
    "recovery.unexplained": N_(
        "{line}: the recovered points do not lie on the beams of the scanner (off by {misfit:mm} "
        "mm). No single error of heights, time, lever arm or signs explains it: the cloud may "
        "have been made with another trajectory, or adjusted. The angles may be wrong."
    ),
    "recovery.recorded_mounting": N_(
        "{line}: the cloud says how it was made (boresight roll {roll:deg.4}, pitch {pitch:deg.4}, "
        "yaw {yaw:deg.4} deg). The points of the scanner are recovered with these values."
    ),
    "recovery.other_lever_arm": N_(
        "{line}: the cloud was made with the lever arm {x:m.3}, {y:m.3}, {z:m.3} m, which differs "
        "by {off:mm} mm from the prior one. The points are recovered with the former, but the "
        "estimate uses the latter. Correct the lever arm if it was the same scanner."
    ),
    "recovery.boresight_used": N_(
        "{line}: the recovered beams lie in a plane turned by {turn:deg.1} deg from the axes of "
        "the scanner. If the scanner measures along its axes, the cloud was made with another "
        "boresight than the prior one. Give that boresight as the prior."
    ),
    "audit.shared_points": N_(
        "{line} and {other} have points in common ({share:percent.1} % of the smaller line). "
        "Points that count twice make the standard deviations too small. Exclude {smaller}."
    ),
    "audit.same_time": N_(
        "{line} and {other} overlap in time by {seconds:n} s. If they come from one scanner, "
        "one of them is a copy and makes the standard deviations too small. If they come from "
        "two scanners, each has boresight angles of its own. Exclude one of them."
    ),
    "text.unit_overridden": N_(
        "{file}: the columns {stated:names} state a unit, but {option} is set to {given}. The "
        "values are read in the unit that is set, and all results depend on it. Check the option."
    ),
    "text.two_columns": N_(
        "{file}: the columns {columns:names} have the same meaning. {used} is used. State the "
        "columns if that is the wrong one."
    ),
    "text.magnetic_heading": N_(
        "{file}: column {column} is a magnetic heading by its title. All headings are off by the "
        "magnetic declination. Export the true heading."
    ),
    "text.unknown_unit": N_(
        "{file}: the unit in the title of column {column} is not known. {used} are taken. Check it."
    ),
    "trajectory.angles_in_radians": N_(
        "{file}: heading and course differ by {difference:deg.0} deg, but agree if the angles are "
        "radians. The angles are read as degrees, so all results will be wrong. Set radians."
    ),
    "trajectory.angles_in_degrees": N_(
        "{file}: heading and course differ by {difference:deg.0} deg, but agree if the angles are "
        "degrees. The angles are read as radians, so all results will be wrong. Set degrees."
    ),
    "trajectory.rates_not_used": N_(
        "The velocities or angular rates of the trajectory contradict its states in {names:names}. "
        "These are interpolated linearly. Check the export of velocities and rates."
    ),
    "trajectory.no_position": N_(
        "{count:n} states of the trajectory have no position (latitude and longitude are 0, as "
        "before the GNSS has a fix). They are excluded. Start the export at the first fix."
    ),
    "las.scale": N_(
        "{file}: the coordinates are in steps (scale factors) of {scale:names}, which cannot be "
        "right. Export the file again."
    ),
    "file.is_folder": N_("{file}: there is a folder of this name. Choose another name."),
    "file.is_device": N_(
        "{file}: this is a device or a pipe, and no file can be written in its place. Choose "
        "another name."
    ),
    "file.bad_name": N_(
        "{file}: this cannot be the name of a file (it has a character that no name may have). "
        "Choose another name."
    ),
    "store.audit_damaged": N_(
        "{line}: what the import found in the points is damaged. Import the line again."
    ),
    "file.header_count": N_(
        "{file}: the header counts {header:n} points, but the file holds {held:n}. All of them "
        "are read. Export the file again before another program reads it."
    ),
    "file.legacy_count": N_(
        "{file}: the two point counts of the header differ ({header:n} and {legacy:n}). The file "
        "holds {held:n} points, and all are read."
    ),
    "file.unread_bytes": N_(
        "{file}: {bytes:n} bytes follow the {held:n} points and do not look like points. They are "
        "not read. Export the file again if points are missing."
    ),
    "file.two_systems": N_(
        "{file}: the header states two coordinate systems. {used} applies by its WKT bit, {other} "
        "does not. If the points are in the second one, they are placed wrongly: set it as the "
        "coordinate system (option crs)."
    ),
    "file.unusable_system": N_(
        "{file}: the coordinate system that applies by the header cannot be used. {system}, which "
        "the header states as well, is used."
    ),
    "file.invalid_points": N_(
        "{file}: {count:n} of {total:n} points are marked as invalid in the file. They are not "
        "used."
    ),
}
