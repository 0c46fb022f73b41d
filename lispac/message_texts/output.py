"""Texts of messages about exported files and reports."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- export --------------------------------------------------------------------------------
    "export.no_points": N_("{line}: this line contains no points. Exclude it from the export."),
    "export.outside_trajectory": N_(
        "{line}: none of its {count:n} points was recorded during the trajectory ({start:s.1} to "
        "{end:s.1} s). Check the date and the time base, or exclude the line."
    ),
    "export.trajectory_datum": N_(
        "Latitude, longitude and height are in the datum and at the epoch of {file}. The exported "
        "file does not specify them."
    ),
    "export.epoch": N_(
        "Coordinates are at the epoch of the trajectory; they are not transformed to another epoch."
    ),
    "export.sbet_zeros": N_(
        "Accelerations and wander angle in the SBET are zero, and so are velocities and rates if "
        "the trajectory does not contain them."
    ),
    "export.own_file": N_(
        "{file} is an input file of the survey and must not be overwritten. Choose another name or "
        "folder."
    ),
    "export.own_trajectory": N_(
        "{file} is the trajectory of the survey and must not be overwritten. Choose another name."
    ),
    "export.sphere": N_(
        "{target} is a sphere, but a plane file can only contain planes. Exclude it from the "
        "export."
    ),
    "export.no_planar_target": N_(
        "{project}: there is no planar target to export. Pick one first."
    ),
    "export.no_target": N_("{project}: there is no target to export. Pick one first."),
    "export.bad_epoch": N_(
        "The epoch {epoch} is not a decimal year. Give the date as in this example: 2024.5."
    ),
    "export.epoch_without_datum": N_(
        "The epoch {epoch} has no effect without the datum of the trajectory. Give the datum too "
        "(for example EPSG:7912 for ITRF2014), or omit the epoch."
    ),
    "export.different_datums": N_(
        "The trajectory datum differs between lines ({datums:names}). Choose the datum and epoch "
        "to use."
    ),
    "export.local_frame_options": N_(
        "Heights, datum and epoch cannot be chosen for the local frame. Give a coordinate system, "
        "or omit them."
    ),
    "export.no_system": N_(
        "No coordinate system is given, and the lines specify none. Give its EPSG code ({zone} is "
        "the UTM zone of the trajectory), or {local} for the local frame (north, west, up)."
    ),
    "export.different_systems": N_(
        "The lines are in different coordinate systems ({systems:names}). Choose the coordinate "
        "system of the export."
    ),
    # -- corrections ---------------------------------------------------------------------------
    "corrections.uncorrelated": N_(
        "{project}: the trajectory cannot be corrected because the boresight was estimated with "
        "uncorrelated POS errors. Estimate with correlated POS errors."
    ),
    "corrections.former_result": N_(
        "{project}: the result was estimated by an earlier version and does not contain the "
        "corrections of the trajectory. Estimate again."
    ),
    "corrections.undetermined": N_(
        "{project}: the data determine no component of the POS error, so the trajectory cannot be "
        "corrected."
    ),
    "corrections.other_trajectory": N_(
        "{file}: the trajectory ({start:s.1} to {end:s.1} s) does not contain the times of the "
        "estimate ({first:s.1} to {last:s.1} s), so it cannot be corrected. Estimate again."
    ),
    "corrections.prior_boresight": N_(
        "The corrected trajectory belongs to the estimated boresight and cannot be used with the "
        "prior one. Choose the estimated boresight or the given trajectory."
    ),
    "corrections.same_file": N_(
        "{file} is given for two different files. Choose another name for one of them."
    ),
    "corrections.support": Plural(
        "The corrections are estimated in one interval with sightings, from {start:s.1} to "
        "{end:s.1} s. Elsewhere they are predicted, and they decay with the correlation times of "
        "{position:s} s (position) and {attitude:s} s (attitude).",
        "The corrections are estimated in {count:n} intervals with sightings, from {start:s.1} to "
        "{end:s.1} s. Elsewhere they are predicted, and they decay with the correlation times of "
        "{position:s} s (position) and {attitude:s} s (attitude).",
    ),
    "corrections.not_determined": N_(
        "The data do not determine all components of position and attitude. Not corrected: "
        "{names:names}."
    ),
    "corrections.velocities": N_(
        "Velocities and angular rates in the corrected trajectory are those of the given one, the "
        "velocities along north, west and up. The smrmsg contains zeros as accuracies of "
        "velocities."
    ),
    # -- report --------------------------------------------------------------------------------
    "report.ending": N_(
        "{file}: a report can be written as {formats:choices}. Use one of these file extensions."
    ),
    "report.format": N_("A report cannot be written as {format}. Choose {formats:choices}."),
    # -- report_template -----------------------------------------------------------------------
    "report_template.not_toml": N_(
        "{file}: this report template is not a TOML file ({reason}). Write lines such as company = "
        '"Levés du Fleuve".'
    ),
    "report_template.unknown_key": N_(
        "{file}: {key} is not a key of a report template. Use one of these: {keys:names}."
    ),
    "report_template.not_text": N_(
        "{file}: {key} must be text in quotation marks. Correct the value."
    ),
    "report_template.refused": N_("{file}: the report template cannot be used. {reason}"),
    "report_template.no_page": N_("There is no page size {page}. Choose one of {pages:choices}."),
    "report_template.no_extent": N_(
        "There is no report of the extent {extent}. Choose one of {extents:choices}."
    ),
    "report_template.no_language": N_(
        "There is no report in the language {language}. Choose one of {languages:choices}."
    ),
    "report_template.logo_elsewhere": N_(
        "The logo {logo} is not in the folder of the template. Copy the picture into this folder."
    ),
    "report_template.logo_format": N_(
        "{logo}: this file is not a PNG or SVG picture. Choose a PNG or SVG picture as the logo."
    ),
    "report_template.long_text": N_(
        "{key} is longer than {limit:n} characters or contains a character that cannot be printed. "
        "Correct it."
    ),
    # -- georeferenced lines -----------------------------------------------------------------
    "export.excluded_in_gaps": N_(
        "{file}: {count:n} of {total:n} points were recorded in gaps of the trajectory or at a "
        "pitch above 80°. They are excluded."
    ),
    "export.file_gone": N_(
        "{line}: its file no longer exists. The points, attributes and header records stored at "
        "the import are exported."
    ),
    "export.file_and_header_gone": N_(
        "{line}: its file no longer exists. The points are exported with all their attributes, but "
        "without other header records and without the scales and descriptions of extra attributes."
    ),
    "export.waveforms": N_(
        "{file}: the waveforms are not exported, only the references of the points to them. The "
        "directions in these references are those of the source file."
    ),
    "export.column_excluded": N_(
        "The column {column} contains neither numbers nor flags. It is excluded from the export."
    ),
}
