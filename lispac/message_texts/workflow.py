"""Texts of messages about projects, checks, the history and the sensors."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- validate ------------------------------------------------------------------------------
    "validate.no_planes": N_(
        "{project}: there is no validation plane. Pick planes that are not used in the adjustment."
    ),
    "validate.also": N_("{first} Also: {reason}"),
    "validate.not_simulated": N_(
        "{project}: only a simulated survey that has been validated can be compared with its "
        "true values."
    ),
    # -- check ---------------------------------------------------------------------------------
    "check.reference_sigma": N_(
        "The standard deviation of the reference must be zero or more, but it is {sigma:m} m."
    ),
    "check.search_distance": N_(
        "The search distance must be more than 0 and at most 10 m, but it is {distance:m} m."
    ),
    "check.no_flat_place": Plural(
        "{file}: no line has a flat place within {distance:m} m of this reference. Check its "
        "coordinates, or increase the search distance.",
        "{file}: no line has {count:n} flat places within {distance:m} m of this reference. "
        "Check its coordinates, or increase the search distance.",
    ),
    "check.no_surveyed_point_near": N_(
        "No surveyed point has a flat place of this line within {distance:m} m before and after "
        "the calibration. Survey points where it is denser, or increase the search distance."
    ),
    "check.no_reference_near": N_(
        "The reference has no flat surface within {distance:m} m of this line. Scan the area "
        "that the line covers, or increase the search distance."
    ),
    "check.few_places": N_(
        "{places:n} of {tried:n} flat places of the reference within {distance:m} m of this "
        "line have enough of its points before and after the calibration, but {least:n} are "
        "needed. Scan more of what the line has seen and where it is denser, or increase the "
        "search distance."
    ),
    "check.few_plane_points": Plural(
        "{file}: the plane {plane} has {count:n} point, and a plane needs three. Survey more "
        "points on it, or leave the plane out to check the points alone.",
        "{file}: the plane {plane} has {count:n} points, and a plane needs three. Survey more "
        "points on it, or leave the plane out to check the points alone.",
    ),
    "check.points_in_one_row": N_(
        "{file}: the points of the plane {plane} lie on one straight line. Survey a point "
        "beside it."
    ),
    "check.reference_elsewhere": N_(
        "{file}: no point of this scan lies within {distance:m} m of what the lines have seen. "
        "Check its coordinate system."
    ),
    "check.no_common_place": N_(
        "{project}: no two lines share a flat place within {distance:m} m of each other. "
        "Increase the search distance, or add lines over the same scene."
    ),
    # -- reference -----------------------------------------------------------------------------
    "reference.points_used": N_("{file}: {used:n} of {total:n} points lie where the lines are."),
    "reference.points_used_sample": N_(
        "{file}: {used:n} of {total:n} points are used, one in {one_in:n} of those where the lines "
        "are."
    ),
    "reference.large_sigma": Plural(
        "Point {name} has a standard deviation of {sigma:m} m, and surveyed points rarely have "
        "more than {limit:m} m. The list is read in metres: correct it if they are millimetres.",
        "{count:n} points have standard deviations of more than {limit:m} m, which is rare for "
        "surveyed points: {name} has {sigma:m} m. The list is read in metres: correct it if they "
        "are millimetres.",
    ),
    "reference.plane_off": N_(
        "A point of plane {plane} lies {distance:mm.1} mm off the plane through all of its points, "
        "and its standard deviation is {sigma:mm.1} mm. Check the list."
    ),
    # -- coordinates ---------------------------------------------------------------------------
    "coordinates.swapped_local": N_(
        "{name}: the coordinates {values} do not lie near the trajectory in the local frame, "
        "but exchanged they do. Give north first, then west."
    ),
    "coordinates.swapped_geographic": N_(
        "{name}: the coordinates {values} do not lie near the trajectory in {system}, but "
        "exchanged they do. Give longitude first, then latitude."
    ),
    "coordinates.swapped_geocentric": N_(
        "{name}: the coordinates {values} do not lie near the trajectory in {system}, but "
        "exchanged they do. Give X first, then Y."
    ),
    "coordinates.swapped_projected": N_(
        "{name}: the coordinates {values} do not lie near the trajectory in {system}, but "
        "exchanged they do. Give easting first, then northing."
    ),
    "coordinates.outside_system": N_(
        "{name}: the coordinates {values} lie outside {system}. Check the coordinate system and "
        "the order of the numbers."
    ),
    "coordinates.too_far": N_(
        "{name}: in {system} the coordinates {values} are {distance:km} km from the trajectory. "
        "Check the coordinate system and the order of the numbers."
    ),
    "coordinates.outside_local": N_(
        "{name}: the coordinates {values} lie outside the local frame. Give metres north, west "
        "and up from its origin, or a coordinate system."
    ),
    "coordinates.too_far_local": N_(
        "{name}: in the local frame the coordinates {values} are {distance:km} km from the "
        "trajectory. Give metres north, west and up from its origin, or a coordinate system."
    ),
    # -- project_folder ------------------------------------------------------------------------
    "project_folder.exists": N_(
        "{folder}: there is already a project in this folder. Choose another folder."
    ),
    "project_folder.is_file": N_(
        "{folder} is a file. Give the folder of the project another name."
    ),
    "project_folder.gone": N_(
        "{folder}: the folder of the project is no longer there. Restore it with this location "
        "and name, then save."
    ),
    "project_folder.not_writable": N_(
        "{folder}: the project cannot be written there ({reason}). Choose another folder."
    ),
    "project_folder.being_saved": N_(
        "{folder}: another window or command is saving a project in this folder. Wait for it, "
        "or choose another folder."
    ),
    "project_folder.has_files": N_(
        "{folder}: this folder holds files that no unfinished save has left. Choose another "
        "folder, or remove the files."
    ),
    # -- project_line --------------------------------------------------------------------------
    "project_line.none": N_("A project needs at least one line. Give its scan file."),
    "project_line.same_name": N_("Two lines are named {line}. Give their files different names."),
    "project_line.known": N_("{file}: this file is already the line {line}."),
    "project_line.not_found": N_(
        "{project}: there is no line {line}. The lines are {lines:names}."
    ),
    # -- project_files -------------------------------------------------------------------------
    "project_files.none_found": Plural(
        "{folder}: the missing file ({files:names}) is not in this folder or in one below it. "
        "Choose the folder that it is in now.",
        "{folder}: none of the {count:n} missing files ({files:names}) is in this folder or in "
        "one below it. Choose the folder that they are in now.",
    ),
    "project_files.moved": N_("{file} was moved and is now read from {folder}."),
    "project_files.one_missing": N_(
        "{file}: this file does not exist. Restore it, or give its new location: lispac locate, "
        "or open the project in the window."
    ),
    "project_files.several_missing": N_(
        "{file}: this file does not exist, and {others:names} are missing too. Restore them, or "
        "give their new location: lispac locate, or open the project in the window."
    ),
    # -- history -------------------------------------------------------------------------------
    "repeat.same_lines": N_(
        "{name} has the same lines as {other}: the two are not independent, and all together "
        "counts them once."
    ),
    "repeat.shared_lines": Plural(
        "{name} has {count:n} line in common with {other}, so the two are not independent: they "
        "agree better than two surveys would, and their mean is less certain than stated.",
        "{name} has {count:n} lines in common with {other}, so the two are not independent: they "
        "agree better than two surveys would, and their mean is less certain than stated.",
    ),
    "repeat.lever_arm": N_(
        "{name} has another lever arm than {other}: part of the difference may come from it."
    ),
    "repeat.pos_errors": N_(
        "{name} and {other} have different models of the POS errors: their sigmas are not "
        "comparable."
    ),
    "script.missing_files": N_("The script needs files that are missing: {files:names}."),
    "script.estimate_refused": N_(
        "The project has angles, but they cannot be estimated now: {reason}"
    ),
    "script.other_angles": N_(
        "The angles of the project differ from those of this script, by up to "
        "{difference:deg.4} deg ({angle}): they follow from points selected earlier, or from "
        "another version. Estimate again in the project to get those of the script."
    ),
    "script.no_reference": N_(
        "The reference {file} was not found beside the lines. Enter its path in the step "
        "project.check, with its sigma and crs if they were given, and remove the #."
    ),
    "script.other_check": N_(
        "The check against {file} gives other numbers here: its coordinates were assumed in "
        "{system}. Enter crs, sigma and other options of that check in the step project.check."
    ),
    "history.no_folder": N_("{folder}: there is no such folder."),
    "history.no_permission": N_(
        "{folder}: there is no permission to read this folder. Check its permissions."
    ),
    "history.no_project": N_(
        "{folders:names}: there is no project in it. Give a folder that holds projects."
    ),
    "history.none": N_("There is no calibration with a result and a date in these folders."),
    "history.none_of_vessel": N_(
        "There is no calibration of {vessel} with a result and a date in these folders."
    ),
    "history.none_and_excluded": N_("{reason} Not used: {excluded}"),
    "history.excluded": N_("Not used: {reason}"),
    "history.same_lines": N_("Not used: {folder}, which has the same lines as {other}."),
    "history.unnamed_system": N_(
        "These projects do not name vessel, scanner and INS/GNSS: whether they belong to one "
        "system is not known. Enter them in the details for the report."
    ),
    "history.first": N_("{name} is the first."),
    "history.moved": N_(
        "{name} differs from the earlier ones, most in {difference}: the mounting has moved, or "
        "one of the calibrations is wrong. A new series begins."
    ),
    "history.within_limits": N_(
        "{name} lies within the limits of the earlier ones; largest difference: {difference}."
    ),
    "history.no_result": N_("{project} has no result yet."),
    "history.no_date": N_(
        "{project} has no date. Set it with lispac identity {project} --dates, or in Details "
        "for the report."
    ),
    "history.no_day": N_(
        "{project}: its dates ({dates}) contain no day like 2026-03-04. Set one with lispac "
        "identity {project} --dates, or in Details for the report."
    ),
    # -- repeat --------------------------------------------------------------------------------
    "repeat.given_twice": N_("{folder}: this project is given twice."),
    # -- sensor --------------------------------------------------------------------------------
    "sensor.no_scanner": N_(
        "There is no scanner named {name} in the library. Give one of {known:names}."
    ),
    "sensor.no_pos": N_("There is no POS named {name} in the library. Give one of {known:names}."),
    "sensor.no_solution": N_(
        "{name}: the GNSS solution for its standard deviations is missing. Give one of "
        "{known:names}."
    ),
    "sensor.no_sigmas": N_(
        "No standard deviations are given. Give them for at least one GNSS solution."
    ),
    "sensor.no_title": N_("A sensor needs a title: maker and model."),
    "sensor.no_source": N_(
        "Give the source of the specifications, for example a data sheet with its date."
    ),
    "sensor.long_text": N_("A title or a source must be one line of at most {limit:n} characters."),
    "sensor.title_taken": N_("There is already a sensor {title}. Give another title."),
    "sensor.supplied": N_("{title} comes with the program and cannot be removed."),
    "sensor.not_removed": N_("{file}: this file cannot be removed ({reason})."),
    # -- manual --------------------------------------------------------------------------------
    "manual.not_installed": Plural(
        "The manual cannot be built, because {packages:names} is not installed. Start the "
        "program with installer/bootstrap.py run, or read the texts in {folder}.",
        "The manual cannot be built, because {packages:names} are not installed. Start the "
        "program with installer/bootstrap.py run, or read the texts in {folder}.",
    ),
    "manual.not_built": N_(
        "The manual could not be built ({reason}). Read its texts in the folder "
        "resources/manual, and report this error."
    ),
    "manual.not_writable": N_(
        "{folder}: the manual cannot be written there ({reason}). Make room, or choose another "
        "cache folder in the settings."
    ),
    # -- check ---------------------------------------------------------------------------------
    "check.line_not_compared": N_("{line}: {reason}"),
    "check.points_not_compared": N_(
        "No line has a flat place within {distance:m} m of {points:names}."
    ),
    # -- project_files -------------------------------------------------------------------------
    "project_files.many_missing": N_(
        "{file}: this file does not exist, and {count:n} other files are missing too "
        "({others:names} among them). Restore them, or give their new location: lispac locate, "
        "or open the project in the window."
    ),
    "project_files.none_of_many_found": N_(
        "{folder}: none of the {count:n} missing files ({files:names} among them) is in this "
        "folder or in one below it. Choose the folder that they are in now."
    ),
}
