"""Texts of messages about the import of lines: files to be imported, time bases, and the store."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- files to be imported --------------------------------------------------------------------
    "import.no_files": N_("Add the files of the survey: drop them here, or press Add files."),
    "import.no_lines_added": N_(
        "No lines have been added yet. Drop the scan files of the lines here, or press Add files."
    ),
    "import.being_examined": N_("The files are being examined."),
    "import.several_errors": Plural(
        "{first} Another file has errors.", "{first} {count:n} other files have errors."
    ),
    "import.no_trajectory": N_("The trajectory is missing. Add the SBET, or a text export of it."),
    "import.no_line": N_("There is no line. Add the scan file of at least one line."),
    "import.duplicate_line_name": N_("Two lines are named {line}. Rename a file."),
    "import.no_folder": N_("Choose a folder for the project."),
    "import.folder_has_project": N_(
        "This folder already contains a project. Choose another folder."
    ),
    "import.folder_is_file": N_("This is a file. Choose a folder for the project."),
    "import.folder_not_writable": N_("{folder}: cannot be written. Choose another folder."),
    # -- import --------------------------------------------------------------------------------
    "import.file_missing": N_(
        "{file}: this line file does not exist, but the earlier import of {line} cannot be used: "
        "{reason} Restore the file."
    ),
    "import.repeated": N_(
        "{line} was imported again, because the earlier import could not be used ({reason}). No "
        "action is needed."
    ),
    "import.reading_changed": N_(
        "{line}: the reading options of its file have changed since the import. Import the line "
        "again."
    ),
    "import.columns_changed": N_(
        "{line}: the column names of its file have changed since the import. Import the line again."
    ),
    "import.trajectory_changed": N_(
        "{line}: the trajectory, its origin or the longest gap to interpolate has changed since "
        "the import. Import the line again."
    ),
    "import.mounting_changed": N_(
        "{line}: the prior lever arm or boresight, used to recover the scanner points from the "
        "cloud, has changed since the import. Import the line again."
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
        "{file}: this file of the imported line {line} is missing. Import the line again."
    ),
    "import.part_changed": N_(
        "{file}: this file of the imported line {line} has changed (its checksum does not match). "
        "Import the line again."
    ),
    "import.no_points": N_("{file}: this line contains no points. Exclude it from the project."),
    "import.no_usable_point": N_(
        "{file}: none of its {count:n} points can be used: {not_finite:n} have NaN or infinite "
        "values, {no_range:n} have no range, {too_far:n} are beyond the maximum range, "
        "{withheld:n} are flagged as withheld, {not_selected:n} are not selected. Check the "
        "options of the line, or export it again."
    ),
    "import.other_points": N_(
        "{file}: these are not the points on which target {target} was picked, or the trajectory "
        "now covers other points. Restore the file, or create a new project."
    ),
    "import.points_missing": N_(
        "{folder}: target {target} has points that do not exist on line {line}, so the project is "
        "damaged. Restore its folder from a copy."
    ),
    "import.accuracy_times": N_(
        "{file}: its times ({first:s.1} to {last:s.1} s) do not overlap those of the trajectory "
        "({start:s.1} to {end:s.1} s). Give the accuracy file that belongs to the trajectory."
    ),
    "import.points_without_time": N_(
        "{file}: the points have no times, so the file can only serve as a reference cloud "
        "(Calibrate > Check against a reference…). To use it as a line, export it with the time of "
        "each point."
    ),
    "import.unknown_format": N_(
        "{file}: the format of this file is not recognised. Export it in a format that the "
        "manual names."
    ),
    "import.not_of_its_format": N_(
        "{file}: the file is damaged, or it is not {format} in spite of its name. Copy or export "
        "it again."
    ),
    "import.not_trajectory_format": N_(
        "{file}: {format} is not a format of a trajectory file. Choose another format."
    ),
    "import.unknown_trajectory_format": N_(
        "{file}: the file is not recognised as a trajectory file. Check that it is one, or "
        "choose its format."
    ),
    "import.not_accuracy_format": N_(
        "{file}: {format} is not a format of a trajectory accuracy file. Choose another format."
    ),
    "import.unknown_accuracy_format": N_(
        "{file}: the file is not recognised as a trajectory accuracy file. Check that it is "
        "one, or choose its format."
    ),
    "import.not_line_format": N_(
        "{file}: {format} is not a format of a line file. Choose another format."
    ),
    "import.unknown_line_format": N_(
        "{file}: the file is not recognised as a line file. Check that it is one, or choose "
        "its format."
    ),
    "import.origin_too_far": N_(
        "{project}: the origin is {distance:km} km from the trajectory. Give its latitude and "
        "longitude in degrees, or omit it."
    ),
    "import.no_attribute": N_(
        "{file}: the line cannot be split by {attribute}, because its points have no such "
        "attribute. Choose one of {known:names}."
    ),
    "import.no_attributes": N_(
        "{file}: the line cannot be split by {attribute}, because its points have no attributes. "
        "Export the file with attributes, or split the line by gaps in time."
    ),
    "import.shift_contradicts_base": N_(
        "{file}: a time shift of {given:s.3+} s is given, but the shift from {base} to the time "
        "base of the trajectory, {trajectory_base}, is {needed:s.3+} s. Give either the shift or "
        "the time base."
    ),
    "import.hour_unknown": N_(
        "{file}: the times have no full hour, and several time shifts place them on the "
        "trajectory, such as {shifts:choices}. Give the right shift, or another source of the hour "
        "(hour_from)."
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
        "{file}: times from {first:s.3} to {last:s.3} s cannot be in the given time base, {base}. "
        "Give a time base that fits ({keys:choices}), or none."
    ),
    "time_base.no_base_possible": N_(
        "{file}: times from {first:s.3} to {last:s.3} s cannot be in the given time base, {base}, "
        "and fit no other known time base. Check which column or field contains the time."
    ),
    "time_base.other_trajectory_base": N_(
        "{file}: in the time base {base} no point lies within the trajectory ({trajectory_base}), "
        "but points do if the time base of the trajectory is {options:choices}. Check the time "
        "base of the trajectory."
    ),
    "time_base.no_overlap": N_(
        "{file}: in the time base {base} no point lies within the trajectory, whose times are "
        "{trajectory_base}. Give the time base of the line, or the trajectory of the same survey."
    ),
    # -- times of lines ----------------------------------------------------------------------
    "import.read_as": N_("{file}: the file is read as {format}, with {options:names}."),
    "import.base_assumed": N_(
        "{file}: the file does not specify its time base. The times are read in the time base of "
        "the trajectory, {base}."
    ),
    "import.shift_follows": N_(
        "{file}: {shift:s.3+} s are added to the times to convert them from {base} to "
        "{trajectory_base}, the time base of the trajectory."
    ),
    "import.leap_seconds_assumed": N_(
        "{file}: neither the line nor the trajectory specifies the date, so the current number of "
        "leap seconds ({leap:n} s) is used."
    ),
    "import.other_shifts_fit": Advised(
        N_("{file}: the time shifts {shifts:choices} are also possible."),
        N_("Check the day of the survey."),
    ),
    "import.other_bases_fit": N_(
        "{file}: according to the times, the time shifts {shifts:choices} are also possible. Check "
        "the time base of the scanner."
    ),
    "import.shifted": N_("{file}: {shift:s.3+} s are added to the times."),
    "import.shift": N_("{shift:s.3+} s"),
    "import.shift_from": N_("{shift:s.3+} s ({base})"),
    "import.times_restart": N_(
        "{file}: the times restart from zero at {place}, after {last:s.3} s. {period:s.0} s are "
        "added to the later times."
    ),
    "import.times_after_restart": N_(
        "{file}: all times of the line are after {place}, where the times restart from zero. "
        "{period:s.0} s are added to them."
    ),
    "rollover.midnight": N_("midnight"),
    "rollover.week_end": N_("the end of the week"),
    "rollover.full_hour": N_("the full hour"),
    # -- files to be imported ----------------------------------------------------------------
    "import.stopped": N_(
        '{file}: the file was not read, because reading was cancelled. Press "Read again".'
    ),
    "import.not_examined": N_(
        "{file}: the file cannot be examined ({kind}: {reason}). Copy or export it again."
    ),
    "import.already_in_project": N_(
        "{file}: this file is already line {line} of the project. Exclude the file."
    ),
    "import.unlikely_format": N_(
        "{file}: the format is uncertain. If it is {format}, choose a role for the file."
    ),
    "import.several_trajectories": N_(
        "{file}: more than one file has the role of trajectory, but a project has only one. "
        "Exclude the others."
    ),
    "import.several_accuracies": N_(
        "{file}: more than one file has the role of trajectory accuracy, but a project has only "
        "one. Exclude the others."
    ),
    "import.columns_remembered": N_(
        "{file}: the columns chosen for the last file with the same layout are used."
    ),
    "import.columns_not_chosen": N_(
        "{file}: no column is assigned to {columns:names}. Choose the meaning of each column above "
        "the preview."
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
        "{file}: only the first {count:n} times of this long file were checked. The other times "
        "are checked when the project is created."
    ),
    "import.accuracy_too_short": N_(
        "{file}: the accuracies cover {first:s.1} to {last:s.1} s, not the whole trajectory "
        "({start:s.1} to {end:s.1} s). Before and after them, the first and last values are used: "
        "export the accuracies of the whole trajectory."
    ),
    "import.outside_system": N_(
        "{file}: the points lie outside the area of {system}. Choose the coordinate system of the "
        "points."
    ),
    "import.far_from_trajectory": N_(
        "{file}: in {system} the points lie {distance:km.0} km from the trajectory. Choose the "
        "coordinate system of the points."
    ),
    "import.points_outside": N_(
        "{file}: {share:percent} % of the points were recorded before or after the trajectory. "
        "They are excluded: check the time bases, or export the whole trajectory."
    ),
    "import.points_outside_sampled": N_(
        "{file}: about {share:percent} % of the points were recorded before or after the "
        "trajectory. They are excluded: check the time bases, or export the whole trajectory."
    ),
    "import.points_in_gaps": N_(
        "{file}: {share:percent} % of the points were recorded in gaps of the trajectory longer "
        "than {limit:s.1} s. They are excluded: interpolate short gaps, or export the trajectory "
        "again."
    ),
    "import.points_in_gaps_sampled": N_(
        "{file}: about {share:percent} % of the points were recorded in gaps of the trajectory "
        "longer than {limit:s.1} s. They are excluded: interpolate short gaps, or export the "
        "trajectory again."
    ),
    "import.shift_offered": N_(
        "{file}: with {shift:s.3+} s added to the times, {share:percent.1} % of the points lie "
        "within the trajectory. Check whether the times of the scanner are {base}."
    ),
    "import.outside_with_shift": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s). If the points are in {points} and the trajectory in "
        "{trajectory}, add {shift:s.3+} s to the times: {share:percent.1} % of the points then lie "
        "within it."
    ),
    "import.outside_without_shift": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s), but {share:percent.1} % do without a time shift. Clear the "
        "shift."
    ),
    "import.before_trajectory": N_(
        "{file}: the line ({first:s.1} to {last:s.1} s) ends {distance:s.0} s before the "
        "trajectory ({start:s.1} to {end:s.1} s) starts, and no other known time base fits. Give "
        "the trajectory of the same survey, or exclude the line."
    ),
    "import.after_trajectory": N_(
        "{file}: the line ({first:s.1} to {last:s.1} s) starts {distance:s.0} s after the "
        "trajectory ({start:s.1} to {end:s.1} s) ends, and no other known time base fits. Give the "
        "trajectory of the same survey, or exclude the line."
    ),
    "import.outside_with_shifts": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s). Give the time base of the points: with {shift:s.3+} s "
        "(points in {points}, trajectory in {trajectory}), {share:percent.1} % lie within it; "
        "{shifts:choices} is also possible."
    ),
    "import.nowhere_on_trajectory": N_(
        "{file}: no point lies within the trajectory (line {first:s.1} to {last:s.1} s, trajectory "
        "{start:s.1} to {end:s.1} s), or all points lie in its gaps. Check the trajectory and the "
        "time base, or exclude the line."
    ),
    "import.excluded_outside": N_(
        "{file}: {count:n} of {total:n} points were recorded before or after the trajectory. They "
        "are excluded."
    ),
    "import.excluded_in_gaps": N_(
        "{file}: {count:n} of {total:n} points were recorded in gaps of the trajectory longer than "
        "{limit:s.1} s. They are excluded."
    ),
    "import.excluded_steep": N_(
        "{file}: {count:n} of {total:n} points were recorded at a pitch above 80°, at which "
        "roll and heading cannot be separated. They are excluded."
    ),
    "import.shift_possible": Advised(
        N_(
            "{file}: with {shift:s.3+} s added to the times, {share:percent.1} % of the points lie "
            "within the trajectory."
        ),
        N_(
            "If the points are in {points} and the trajectory in {trajectory}, import the line "
            "again with this time shift."
        ),
    ),
    "import.restart_found": Advised(
        N_("{file}: the times restart from zero at {place} within the line."),
        N_("Import the line again with the option {option}."),
    ),
    "import.restart_not_needed": Advised(
        N_(
            "{file}: without the time rollover, {share:percent.1} % of the points lie within the "
            "trajectory."
        ),
        N_(
            "If the times of the trajectory restart from zero too, import the line again with the "
            "option {option}."
        ),
    ),
    "import.file_gone": N_(
        "{file}: this file no longer exists. The imported data of line {line} are used."
    ),
    # -- import --------------------------------------------------------------------------------
    "import.shift_not_needed": N_(
        "{file}: its points ({first:s.1} to {last:s.1} s with the time shift of {shift:s.3+} s) "
        "lie outside the trajectory ({start:s.1} to {end:s.1} s), but inside without the shift. "
        "Check the shift."
    ),
    "import.shift_wrong": N_(
        "{file}: with the time shift of {shift:s.3+} s, its points ({first:s.1} to {last:s.1} s) "
        "lie outside the trajectory ({start:s.1} to {end:s.1} s). Give another shift, or exclude "
        "the line."
    ),
}
