"""Texts of messages about exported files and reports."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- export --------------------------------------------------------------------------------
    "export.no_points": N_("{line}: this line holds no points. Leave it out."),
    "export.outside_trajectory": N_(
        "{line}: none of its {count:n} points lies within the trajectory ({start:s.1} to "
        "{end:s.1} s). Check the date and the time base, or leave the line out."
    ),
    "export.trajectory_datum": N_(
        "Latitude, longitude and height are as in {file}: in its datum and at its epoch, which the "
        "exported file does not specify."
    ),
    "export.epoch": N_(
        "Coordinates are at the epoch of the trajectory, not transformed to another one."
    ),
    "export.sbet_zeros": N_(
        "Velocities, accelerations, rates and wander angle in the SBET are zero."
    ),
    "export.own_file": N_("{file} is a file of the survey itself. Choose another name or folder."),
    "export.own_trajectory": N_(
        "{file} is the trajectory of the survey itself. Choose another name."
    ),
    "export.sphere": N_("{target} is a sphere, which a plane file cannot hold. Leave it out."),
    "export.no_planar_target": N_(
        "{project}: there is no planar target to export. Pick one first."
    ),
    "export.no_target": N_("{project}: there is no target to export. Pick one first."),
    "export.bad_epoch": N_("The epoch {epoch} is not a date as a decimal year, such as 2024.5."),
    "export.epoch_without_datum": N_(
        "The epoch {epoch} has no effect without the datum of the trajectory. Give the datum "
        "too (for example EPSG:7912 for ITRF2014), or leave the epoch out."
    ),
    "export.different_datums": N_(
        "The lines are read with different datums of the trajectory ({datums:names}). Choose "
        "which datum and epoch to use."
    ),
    "export.local_frame_options": N_(
        "The local frame has its own heights and datum. Give a coordinate system, or leave out "
        "heights, datum and epoch."
    ),
    "export.no_system": N_(
        "No coordinate system is given and the lines specify none. Give its EPSG code ({zone} "
        "is the UTM zone of the trajectory), or {local} for the local frame (North, West, Up)."
    ),
    "export.different_systems": N_(
        "The lines are in different coordinate systems ({systems:names}). Choose which one to "
        "write."
    ),
    # -- report --------------------------------------------------------------------------------
    "report.ending": N_(
        "{file}: a report is written as {formats:choices}. Use one of these endings."
    ),
    "report.format": N_("A report is written as {formats:choices}, not as {format}."),
    # -- report_template -----------------------------------------------------------------------
    "report_template.not_toml": N_(
        "{file}: this report template is not a TOML file ({reason}). It holds lines such as "
        'company = "Levés du Fleuve".'
    ),
    "report_template.unknown_key": N_(
        "{file}: a report template has no {key}. It can have {keys:names}."
    ),
    "report_template.not_text": N_("{file}: {key} must be text in quotation marks."),
    "report_template.refused": N_("{file}: the report template cannot be used. {reason}"),
    "report_template.no_page": N_("There is no page size {page}. Choose one of {pages:choices}."),
    "report_template.no_language": N_(
        "There is no report in the language {language}. Choose one of {languages:choices}."
    ),
    "report_template.logo_elsewhere": N_(
        "The logo {logo} is not in the folder of the template. Copy the picture into it."
    ),
    "report_template.logo_format": N_(
        "{logo}: a logo must be a PNG or SVG picture, and this file is neither."
    ),
    "report_template.long_text": N_(
        "{key} is longer than {limit:n} characters or holds a character that cannot be printed. "
        "Change it."
    ),
    # -- georeferenced lines -----------------------------------------------------------------
    "export.excluded_in_gaps": N_(
        "{file}: {count:n} of {total:n} points lie in gaps of the trajectory or were measured at a "
        "pitch beyond 80 deg. They are excluded."
    ),
    "export.file_gone": N_(
        "{line}: its file no longer exists. Points, attributes and records of the header are those "
        "kept at the import."
    ),
    "export.file_and_header_gone": N_(
        "{line}: its file no longer exists. The points have all their attributes, but other "
        "records of the header, and the scales and descriptions of its extra attributes, are not "
        "kept."
    ),
    "export.waveforms": N_(
        "{file}: the references of the points to waveforms are kept, the waveforms are not. Their "
        "directions are those of the source."
    ),
    "export.column_excluded": N_(
        "The column {column} holds neither numbers nor flags. It is excluded."
    ),
}
