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
        "has changed since the import. Restore the file, or remove it."
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
        "Its times from {first:s.3} to {last:s.3} s cannot be {base}, as given. Their values "
        "fit {keys:choices}. Give one of these time bases, or none."
    ),
    "time_base.no_base_possible": N_(
        "Its times from {first:s.3} to {last:s.3} s cannot be {base}, as given, and they fit no "
        "known time base. Check which column or record is the time."
    ),
    "time_base.other_trajectory_base": N_(
        "In {base} none of its points lies within the trajectory, whose times are "
        "{trajectory_base}. They would with {options:choices}. Check the time base of the "
        "trajectory, and give it."
    ),
    "time_base.no_overlap": N_(
        "In {base} none of its points lies within the trajectory, whose times are "
        "{trajectory_base}. Give the time base of the times, or the trajectory of the same "
        "survey."
    ),
    # -- import --------------------------------------------------------------------------------
    "import.time_base_refused": N_("{file}: {reason}"),
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
