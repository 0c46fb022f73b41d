"""Texts of messages of the command line, of scripts, of the window and of the report."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- command line --------------------------------------------------------------------------
    "cli.projects_failed": Plural(
        "{count:n} of {total:n} projects failed: {names:names}. See the table for the reason.",
        "{count:n} of {total:n} projects failed: {names:names}. See the table for the reasons.",
    ),
    "cli.no_memory": N_("There is not enough memory. Use shorter lines."),
    "cli.file_failed": N_("{file}: {reason}."),
    "cli.no_folder": N_("{folder}: the folder does not exist. Check the path."),
    "cli.files_not_found": Plural(
        "{folder}: this folder does not contain {count:n} of the missing files: {names:names}. "
        "Give the folder of this file as well.",
        "{folder}: this folder does not contain {count:n} of the missing files: {names:names}. "
        "Give the folders of these files as well.",
    ),
    "cli.not_accepted": N_(
        "{project} does not meet its acceptance criteria. Check the criteria marked as not met "
        "above."
    ),
    "cli.acceptance_not_judged": N_(
        "{project} is not judged by acceptance criteria: give criteria, estimate the boresight, "
        "and compare the lines on all validation planes."
    ),
    "cli.no_dates": N_(
        "{project}: the survey dates are unknown, because the times of the lines are seconds of "
        "the day or of the week. Enter the dates."
    ),
    "cli.has_targets": Plural(
        "{project}: the project already has {count:n} target, so the proposed targets cannot be "
        "added. Show them without accepting them, or make a new project.",
        "{project}: the project already has {count:n} targets, so the proposed targets cannot be "
        "added. Show them without accepting them, or make a new project.",
    ),
    "cli.no_results": N_(
        "{project}: no method has estimated the boresight angles. Run the adjustment or the "
        "alternative methods."
    ),
    # -- former names, accepted for one version ---------------------------------------------------
    "former_name.option": N_(
        "The option {former} is now called {name}. The former name will be removed in the next "
        "version; use the new one."
    ),
    "former_name.command": N_(
        "The command {former} is now called {name}. The former name will be removed in the next "
        "version; use the new one."
    ),
    "former_name.script": N_(
        "“{former}” is now called “{name}”. The former name will be removed in the next version; "
        "change the script."
    ),
    "former_name.key": N_(
        "{file}: the key {former} is now called {name}. The former name will be removed in the "
        "next version; change the file."
    ),
    # -- scripts -------------------------------------------------------------------------------
    "script.place_or_point": N_(
        "{name}: give either a position or a point of a line as the seed of a target, not both or "
        "none."
    ),
    "script.unknown_export": N_("“{what}” cannot be exported. Choose {known:choices}."),
    "script.unknown_export_format": N_(
        "{what} cannot be exported as {form}. Choose {forms:choices}."
    ),
    "script.no_sighting": N_(
        "{target} is not observed on line {line}, so there is no sighting to exclude or restore. "
        "Check the names."
    ),
    # -- report --------------------------------------------------------------------------------
    "report.picture_format": N_(
        "{file}: the report cannot include this picture. Use a PNG or SVG file."
    ),
    "report.picture_unreadable": N_(
        "{file}: the picture cannot be read ({reason}). Check the file and its permissions."
    ),
    "report.picture_invalid": N_(
        "{file}: the picture is damaged or not supported ({reason}). Save it again as PNG or SVG."
    ),
    "report.not_typeset": N_(
        "The PDF report cannot be created ({reason}). Save the report in another format."
    ),
    # -- window --------------------------------------------------------------------------------
    "window.adjustment_cancelled": N_(
        "The adjustment was cancelled. Press Estimate to run it again."
    ),
    "window.adjustment_failed": N_("The adjustment failed. Press Estimate to run it again."),
    "window.unsaved_work_not_kept": N_(
        "A recovery copy of unsaved changes cannot be written ({reason}). Save the project to keep "
        "them."
    ),
    "window.unsaved_work_elsewhere": N_(
        "No recovery copy of unsaved changes is written, because the project is open in another "
        "window. Save the project to keep your changes."
    ),
    "window.not_saved": N_(
        "The project was not saved: {reason} Use File > Save as… to save to another folder."
    ),
    "window.picture_not_written": N_(
        "{file}: the picture cannot be written. Choose another folder."
    ),
    "window.disk_full": N_(
        "{file}: the picture cannot be written because the disk is full. Free some disk space."
    ),
    "window.no_numbers": N_(
        "{field:title}: the field is empty. Enter at least one number in {unit}."
    ),
    "window.ambiguous_comma": N_(
        "{field:title}: “{text}” may be one number or two. Separate numbers with semicolons or "
        "blanks, or write decimals with a point."
    ),
    "window.not_a_number": N_("{field:title}: “{text}” is not a number. Correct it."),
    "window.not_a_number_in": N_(
        "{field:title}: “{text}” is not a number. Enter a number in {unit}."
    ),
    "window.empty_number": N_("{field:title}: the field is empty. Enter a number."),
    "window.not_a_whole_number": N_(
        "{field:title}: “{text}” is not a whole number. Enter a number without decimals."
    ),
    "window.out_of_range": N_(
        "{field:title}: {text} {unit} is out of range. Enter a value from {low} to {high} {unit}."
    ),
    "window.name_length": N_(
        "{field:title}: a name must have 1 to {longest:n} characters. Change the name."
    ),
    "window.lidar_axes_incomplete": N_(
        "The standard deviations of the LiDAR along X, Y and Z are incomplete. Missing: "
        "{fields:names}."
    ),
    "window.lidar_beam_incomplete": N_(
        "The standard deviations of the LiDAR in range and angle are incomplete. Missing: "
        "{fields:names}."
    ),
    "window.not_a_decimal_year": N_(
        "“{text}” is not a decimal year. Enter the date as in this example: 2024.5."
    ),
    "window.no_coordinate_system": N_(
        "No coordinate system is chosen. Choose one, or enter its EPSG code."
    ),
    "window.name_taken": N_("The name {name} is already used. Give the target another name."),
    "window.plan_incomplete": N_(
        "The survey plan needs at least one target and one line. Add them first."
    ),
    "window.no_project_to_compare": N_(
        "No project is open to compare with the survey plan. Open the project of the survey in the "
        "main window."
    ),
}
