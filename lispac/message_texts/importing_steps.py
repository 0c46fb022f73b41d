"""Texts of messages about importing the lines of a project."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- import --------------------------------------------------------------------------------
    "import.file_missing": N_(
        "{file}: this line file does not exist, but {line} must be imported again. Restore the "
        "file. The earlier import was refused: {reason}"
    ),
    "import.repeated": N_(
        "{line} was imported again. The earlier import was refused ({reason}). Nothing needs to "
        "be done."
    ),
    "import.reading_changed": N_(
        "{line}: how its file is read has changed since the import. Import the line again."
    ),
    "import.columns_changed": N_(
        "{line}: the names of its columns have changed since the import. Import the line again."
    ),
    "import.trajectory_changed": N_(
        "{line}: the trajectory, its origin or its longest gap has changed since the import. "
        "Import the line again."
    ),
    "import.mounting_changed": N_(
        "{line}: the prior mounting, with which its points are brought back to the scanner, has "
        "changed since the import. Import the line again."
    ),
    "import.latency_changed": N_(
        "{line}: the latency has changed since the import. Import the line again."
    ),
    "import.also_changed": N_("{first} Also: {reason}"),
    "import.file_unreadable": N_(
        "{file}: the file of {line} cannot be read ({reason}), so it is not known whether it "
        "has changed since the import. Restore the file, or remove the line from the project."
    ),
    "import.file_changed": N_(
        "{line}: {file} has changed since the import. Import the line again."
    ),
    "import.file_removed": N_(
        "{file}: the file was removed while it was being imported. Restore it and import it again."
    ),
    "import.file_being_written": N_(
        "{file}: the file changed while it was being imported. Import it again when no program "
        "writes to it."
    ),
    "import.part_missing": N_(
        "{file}: this part of the imported line {line} is missing. Import the line again."
    ),
    "import.part_changed": N_(
        "{file}: this part of the imported line {line} has changed (its checksum does not "
        "match). Import the line again."
    ),
    "import.no_points": N_("{file}: this line holds no points. Leave it out."),
    "import.no_usable_point": N_(
        "{file}: none of its {count:n} points can be used: {not_finite:n} have values that are "
        "not numbers, {no_range:n} have no range, {too_far:n} are too far, {withheld:n} are "
        "withheld, {not_selected:n} are not selected. Check the options of the line, or export "
        "it again."
    ),
    "import.other_points": N_(
        "{file}: these are not the points on which {target} was picked, or the trajectory now "
        "covers other points. Restore the file, or create a new project."
    ),
    "import.points_missing": N_(
        "{folder}: {target} has points that {line} does not have, so the project is damaged. "
        "Restore its folder from a copy."
    ),
    "import.accuracy_times": N_(
        "{file}: its times ({first:s.1} to {last:s.1} s) do not overlap those of the trajectory "
        "({start:s.1} to {end:s.1} s). Give the accuracy file that belongs to the trajectory."
    ),
    "import.points_without_time": N_(
        "{file}: its points have no times, so it cannot be a line. Export it with the time of "
        "each point. As it is, it can serve as a reference to check the lines against (Validate "
        "> Check against a reference…, lispac check)."
    ),
    "import.unknown_format": N_(
        "{file}: the format of this file is not recognised. Export it in a format that the "
        "manual names, or choose its format."
    ),
    "import.not_trajectory_format": N_(
        "{file}: {format} is not a format of a trajectory file. Choose another format."
    ),
    "import.unknown_trajectory_format": N_(
        "{file}: not recognised as a trajectory file. `lispac look` shows what it may be; "
        "otherwise give its format."
    ),
    "import.not_accuracy_format": N_(
        "{file}: {format} is not a format of a trajectory accuracy file. Choose another format."
    ),
    "import.unknown_accuracy_format": N_(
        "{file}: not recognised as a trajectory accuracy file. `lispac look` shows what it may "
        "be; otherwise give its format."
    ),
    "import.not_line_format": N_(
        "{file}: {format} is not a format of a line file. Choose another format."
    ),
    "import.unknown_line_format": N_(
        "{file}: not recognised as a line file. `lispac look` shows what it may be; otherwise "
        "give its format."
    ),
    "import.origin_too_far": N_(
        "{project}: the origin is {distance:km} km from the trajectory. Give its latitude and "
        "longitude in degrees, or leave it out."
    ),
    "import.no_attribute": N_(
        "{file}: its points have no attribute {attribute} to split by. They have {known:names}."
    ),
    "import.no_attributes": N_(
        "{file}: its points have no attribute {attribute} to split by, nor any other."
    ),
    "import.shift_contradicts_base": N_(
        "{file}: a time shift of {given:s.3+} s is given, but {needed:s.3+} s bring its times "
        "from {base} to {trajectory_base}, the time base of the trajectory. Give either the "
        "shift or the time base."
    ),
    # -- time_base -----------------------------------------------------------------------------
    "time_base.gps_week": N_("GPS seconds of the week"),
    "time_base.gps_day": N_("GPS seconds of the day"),
    "time_base.utc_day": N_("UTC seconds of the day"),
    "time_base.utc_week": N_("UTC seconds of the week"),
    "time_base.gps_adjusted": N_("adjusted standard GPS time (minus 1e9)"),
    "time_base.gps_full": N_("GPS seconds since 1980-01-06"),
    "time_base.unix": N_("UTC seconds since 1970-01-01"),
    "time_base.tai": N_("TAI seconds since 1970-01-01 (PTP)"),
    "time_base.utc_hour": N_("UTC seconds of the hour"),
    "time_base.unknown": N_("not known"),
    "time_base.given": N_("{base} (as given)"),
    "time_base.suggested": N_("{base} (as its values suggest)"),
    "time_base.of_file": N_("{base} (as read from the file)"),
    "time_base.not_possible": N_(
        "{file}: times from {first:s.3} to {last:s.3} s cannot be {base}, as given. Their values "
        "fit {keys:choices}. Give one of these time bases, or none."
    ),
    "time_base.no_base_possible": N_(
        "{file}: times from {first:s.3} to {last:s.3} s cannot be {base}, as given, and they fit "
        "no known time base. Check which column or field holds the time."
    ),
    "time_base.other_trajectory_base": N_(
        "{file}: read as {base}, none of the points lies within the trajectory, whose times are "
        "{trajectory_base}. They would with {options:choices}. Check the time base of the "
        "trajectory, and give it."
    ),
    "time_base.no_overlap": N_(
        "{file}: read as {base}, none of the points lies within the trajectory, whose times are "
        "{trajectory_base}. Give the time base of the times, or the trajectory of the same "
        "survey."
    ),
    # -- times of lines ----------------------------------------------------------------------
    "import.read_as": N_("{file}: read as {format}, with {options:names}."),
    "import.base_assumed": N_(
        "{file}: the file does not state its time base. The times are read in the time base of the "
        "trajectory, {base}."
    ),
    "import.shift_follows": N_(
        "{file}: {shift:s.3+} s are added to the times to bring them from {base} to "
        "{trajectory_base}, the time base of the trajectory."
    ),
    "import.leap_seconds_assumed": N_(
        "{file}: neither the line nor the trajectory states the date, so the leap seconds of today "
        "({leap:n} s) are used."
    ),
    "import.other_shifts_fit": N_(
        "{file}: {shifts:choices} would fit as well. Check the day of the survey."
    ),
    "import.other_bases_fit": N_(
        "{file}: by the times alone, {shifts:choices} would fit as well. Check which time base the "
        "scanner wrote."
    ),
    "import.shifted": N_("{file}: {shift:s.3+} s are added to the times."),
    "import.shift": N_("{shift:s.3+} s"),
    "import.shift_from": N_("{shift:s.3+} s ({base})"),
    "import.times_restart": N_(
        "{file}: the times restart at {place}, after {last:s.3} s. {period:s.0} s are added to the "
        "times after it."
    ),
    "import.times_after_restart": N_(
        "{file}: all times are after {place}. {period:s.0} s are added to them."
    ),
    "rollover.midnight": N_("midnight"),
    "rollover.week_end": N_("the end of the week"),
    "rollover.full_hour": N_("the full hour"),
    # -- files to be imported ----------------------------------------------------------------
    "import.stopped": N_('{file}: not read because reading was stopped. Press "Read again".'),
    "import.not_examined": N_("{file}: the file cannot be examined ({kind}: {reason})."),
    "import.already_in_project": N_("{file}: this file is already line {line} of the project."),
    "import.unlikely_format": N_(
        "{file}: the format is uncertain. It may be {format}; if so, choose its role."
    ),
    "import.several_trajectories": N_(
        "{file}: more than one file has the role of the trajectory, but a project has one. Leave "
        "the others out."
    ),
    "import.several_accuracies": N_(
        "{file}: more than one file has the role of the accuracy, but a project has one. Leave "
        "the others out."
    ),
    "import.columns_remembered": N_(
        "{file}: the columns are those chosen for the last file with the same layout."
    ),
    "import.columns_not_chosen": N_(
        "{file}: no column is assigned to {columns:names}. Choose above the preview what each "
        "column is."
    ),
    "column.time": N_("time"),
    "column.x": N_("X coordinate"),
    "column.y": N_("Y coordinate"),
    "column.z": N_("Z coordinate"),
    "column.position": N_("latitude and longitude (or easting and northing)"),
    "column.height": N_("height"),
    "column.roll": N_("roll"),
    "column.pitch": N_("pitch"),
    "column.heading": N_("heading"),
    "import.first_times": N_(
        "{file}: the file is long. The first {count:n} times were checked; the others are checked "
        "when the project is created."
    ),
    "import.accuracy_too_short": N_(
        "{file}: the accuracies cover {first:s.1} to {last:s.1} s, not the whole trajectory "
        "({start:s.1} to {end:s.1} s). Outside, the first and last values are used."
    ),
    "import.outside_system": N_(
        "{file}: the points lie outside {system}. Choose the coordinate system of the points."
    ),
    "import.far_from_trajectory": N_(
        "{file}: in {system} the points lie {distance:km.0} km from the trajectory. Choose the "
        "coordinate system of the points."
    ),
    "import.points_outside": N_(
        "{file}: {share:percent} % of the points lie before or after the trajectory. They are "
        "excluded."
    ),
    "import.points_outside_sampled": N_(
        "{file}: about {share:percent} % of the points lie before or after the trajectory. They "
        "are excluded."
    ),
    "import.points_in_gaps": N_(
        "{file}: {share:percent} % of the points lie in gaps of the trajectory longer than "
        "{limit:s.1} s. They are excluded."
    ),
    "import.points_in_gaps_sampled": N_(
        "{file}: about {share:percent} % of the points lie in gaps of the trajectory longer than "
        "{limit:s.1} s. They are excluded."
    ),
    "import.shift_offered": N_(
        "{file}: with {shift:s.3+} s added to the times, {share:percent.1} % of the points lie "
        "within the trajectory. Check whether the scanner wrote {base}."
    ),
    "import.outside_with_shift": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s). If the points are in {points} and the trajectory in "
        "{trajectory}, add {shift:s.3+} s: then {share:percent.1} % of the points lie within it."
    ),
    "import.outside_without_shift": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s). Without a time shift, {share:percent.1} % of the points lie "
        "within it. Clear the shift."
    ),
    "import.before_trajectory": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s). The line ends {distance:s.0} s before the trajectory starts, "
        "and no known time base brings it inside. Give the trajectory of the same survey, or leave "
        "the line out."
    ),
    "import.after_trajectory": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s). The line starts {distance:s.0} s after the trajectory ends, "
        "and no known time base brings it inside. Give the trajectory of the same survey, or leave "
        "the line out."
    ),
    "import.outside_with_shifts": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s). If the points are in {points} and the trajectory in "
        "{trajectory}, add {shift:s.3+} s: then {share:percent.1} % of the points lie within it. "
        "By the times alone, {shifts:choices} would fit as well. Give the time base of the points."
    ),
    "import.nowhere_on_trajectory": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s), or all lie in its gaps. Check the trajectory and the time "
        "base, or leave the line out."
    ),
    "import.excluded_outside": N_(
        "{file}: {count:n} of {total:n} points lie before or after the trajectory. They are "
        "excluded."
    ),
    "import.excluded_in_gaps": N_(
        "{file}: {count:n} of {total:n} points lie in gaps of the trajectory longer than "
        "{limit:s.1} s. They are excluded."
    ),
    "import.excluded_steep": N_(
        "{file}: {count:n} of {total:n} points were measured at a pitch beyond 80 deg, where roll "
        "and heading cannot be separated. They are excluded."
    ),
    "import.shift_possible": N_(
        "{file}: with {shift:s.3+} s added to the times, {share:percent.1} % of the points lie "
        "within the trajectory. If the points are in {points} and the trajectory in {trajectory}, "
        "import the line again with this time shift."
    ),
    "import.restart_found": N_(
        "{file}: the times restart at {place} within the line. Import the line again with the "
        "option {option}."
    ),
    "import.restart_not_needed": N_(
        "{file}: without the time rollover, {share:percent.1} % of the points lie within the "
        "trajectory. If the times of the trajectory restart too, import the line again with the "
        "option {option}."
    ),
    "import.file_gone": N_(
        "{file}: this file no longer exists. {line} is used as it was imported from it."
    ),
    # -- import --------------------------------------------------------------------------------
    "import.shift_not_needed": N_(
        "{file}: shifted by {shift:s.3+} s, its points ({first:s.1} to {last:s.1} s) lie "
        "outside the trajectory ({start:s.1} to {end:s.1} s). Without the shift they lie "
        "inside. Check the shift."
    ),
    "import.shift_wrong": N_(
        "{file}: shifted by {shift:s.3+} s, its points ({first:s.1} to {last:s.1} s) lie "
        "outside the trajectory ({start:s.1} to {end:s.1} s). Give another shift, or leave the "
        "line out."
    ),
}
