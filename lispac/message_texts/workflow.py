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
        "{project}: a comparison with true values is possible only for a simulated survey that has "
        "been validated. Validate the survey first."
    ),
    # -- check ---------------------------------------------------------------------------------
    "check.reference_sigma": N_(
        "The standard deviation of the reference is {sigma:m} m, but it must be zero or more. "
        "Correct it."
    ),
    "check.search_distance": N_(
        "The search distance is {distance:m} m, but it must be above 0 and at most 10 m. Correct "
        "it."
    ),
    "check.no_flat_place": Plural(
        "{file}: no line has a flat area within {distance:m} m of this reference. Check the "
        "coordinates of the reference, or increase the search distance.",
        "{file}: no line has {count:n} flat areas within {distance:m} m of this reference. Check "
        "the coordinates of the reference, or increase the search distance.",
    ),
    "check.no_surveyed_point_near": N_(
        "No surveyed point lies within {distance:m} m of a flat area of this line, before and "
        "after the calibration. Survey points where the line has a higher point density, or "
        "increase the search distance."
    ),
    "check.no_reference_near": N_(
        "The reference has no flat surface within {distance:m} m of this line. Scan the area "
        "covered by the line, or increase the search distance."
    ),
    "check.few_places": N_(
        "Only {places:n} of {tried:n} flat areas of the reference within {distance:m} m of this "
        "line have enough of its points before and after the calibration; {least:n} are needed. "
        "Scan a larger part of the area covered by the line, where its point density is higher, or "
        "increase the search distance."
    ),
    "check.few_plane_points": Plural(
        "{file}: the plane {plane} has only {count:n} point, but a plane needs three. Survey more "
        "points on it, or omit the plane to check the points alone.",
        "{file}: the plane {plane} has only {count:n} points, but a plane needs three. Survey "
        "more points on it, or omit the plane to check the points alone.",
    ),
    "check.points_in_one_row": N_(
        "{file}: the points of the plane {plane} lie on one straight line. Survey another point "
        "beside this line."
    ),
    "check.reference_elsewhere": N_(
        "{file}: no point of this scan lies within {distance:m} m of the points of the lines. "
        "Check the coordinate system of the scan."
    ),
    "check.no_common_place": N_(
        "{project}: no two lines have a common flat area within {distance:m} m of each other. "
        "Increase the search distance, or add lines over the same scene."
    ),
    # -- reference -----------------------------------------------------------------------------
    "reference.points_used": N_(
        "{file}: {used:n} of {total:n} points lie in the area of the lines and are used."
    ),
    "reference.points_used_sample": N_(
        "{file}: {used:n} of {total:n} points are used, which is one in {one_in:n} of the points "
        "in the area of the lines."
    ),
    "reference.large_sigma": Plural(
        "Point {name} has a standard deviation of {sigma:m} m, but more than {limit:m} m is rare "
        "for surveyed points. If the values are in millimetres, correct the list, which is read in "
        "metres.",
        "{count:n} points have standard deviations above {limit:m} m, which is rare for surveyed "
        "points; {name} has {sigma:m} m. If the values are in millimetres, correct the list, which "
        "is read in metres.",
    ),
    "reference.plane_off": N_(
        "A point of plane {plane} lies {distance:mm.1} mm from the plane fitted to all of its "
        "points, but its standard deviation is {sigma:mm.1} mm. Check the coordinates in the list."
    ),
    # -- coordinates ---------------------------------------------------------------------------
    "coordinates.swapped_local": N_(
        "{name}: the coordinates {values} are far from the trajectory in the local frame, but near "
        "it when swapped. Give {first} first, then {second}."
    ),
    "coordinates.swapped_geographic": N_(
        "{name}: the coordinates {values} are far from the trajectory in {system}, but near it "
        "when swapped. Give longitude first, then latitude."
    ),
    "coordinates.swapped_geocentric": N_(
        "{name}: the coordinates {values} are far from the trajectory in {system}, but near it "
        "when swapped. Give X first, then Y."
    ),
    "coordinates.swapped_projected": N_(
        "{name}: the coordinates {values} are far from the trajectory in {system}, but near it "
        "when swapped. Give easting first, then northing."
    ),
    "coordinates.outside_system": N_(
        "{name}: the coordinates {values} lie outside the area of {system}. Check the coordinate "
        "system and the order of the coordinates."
    ),
    "coordinates.too_far": N_(
        "{name}: in {system} the coordinates {values} are {distance:km} km from the trajectory. "
        "Check the coordinate system and the order of the coordinates."
    ),
    "coordinates.outside_local": N_(
        "{name}: the coordinates {values} are impossible in the local frame. Give metres "
        "{axes:names} from its origin, or a coordinate system."
    ),
    "coordinates.too_far_local": N_(
        "{name}: in the local frame the coordinates {values} are {distance:km} km from the "
        "trajectory. Give metres {axes:names} from its origin, or a coordinate system."
    ),
    # -- project_folder ------------------------------------------------------------------------
    "project_folder.exists": N_(
        "{folder}: there is already a project in this folder. Choose another folder."
    ),
    "project_folder.is_file": N_("{folder} is a file. Choose another name for the project folder."),
    "project_folder.gone": N_(
        "{folder}: the project folder no longer exists. Restore it with the same name at the same "
        "location, then save."
    ),
    "project_folder.not_writable": N_(
        "{folder}: the project cannot be written in this folder ({reason}). Choose another folder."
    ),
    "project_folder.being_saved": N_(
        "{folder}: another window or command is saving a project in this folder. Wait until it has "
        "finished, or choose another folder."
    ),
    "project_folder.has_files": N_(
        "{folder}: this folder already contains other files. Choose another folder, or remove the "
        "files."
    ),
    # -- project_line --------------------------------------------------------------------------
    "project_line.none": N_("A project needs at least one line. Give the point file of a line."),
    "project_line.same_name": N_("Two lines are named {line}. Give their files different names."),
    "project_line.known": N_(
        "{file}: this file is already line {line} of the project. Choose another file."
    ),
    "project_line.not_found": N_(
        "{project}: there is no line {line}. Choose one of {lines:names}."
    ),
    # -- project_files -------------------------------------------------------------------------
    "project_files.none_found": Plural(
        "{folder}: the missing file ({files:names}) is not in this folder or its subfolders. "
        "Choose the folder that contains it.",
        "{folder}: none of the {count:n} missing files ({files:names}) is in this folder or its "
        "subfolders. Choose the folder that contains them.",
    ),
    "project_files.moved": N_("{file} was moved and is now read from {folder}."),
    "project_files.one_missing": N_(
        "{file}: this file does not exist. Restore it, or give its new location."
    ),
    "project_files.several_missing": N_(
        "{file}: this file does not exist; also missing: {others:names}. Restore all of them, or "
        "give their new location."
    ),
    # -- repeat ----------------------------------------------------------------------------
    "repeat.same_lines": N_(
        "{name} has the same lines as {other}, so the two calibrations are not independent. The "
        "statistics of all calibrations count them once."
    ),
    "repeat.shared_lines": Plural(
        "{name} has {count:n} line in common with {other}, so the two calibrations are not "
        "independent. They agree better than two separate surveys would, and their mean is less "
        "certain than its standard deviation indicates.",
        "{name} has {count:n} lines in common with {other}, so the two calibrations are not "
        "independent. They agree better than two separate surveys would, and their mean is less "
        "certain than its standard deviation indicates.",
    ),
    "repeat.lever_arm": N_(
        "{name} and {other} use different lever arms, which may cause part of the difference in "
        "the angles."
    ),
    "repeat.pos_errors": N_(
        "{name} and {other} use different POS error models, so their standard deviations are not "
        "comparable."
    ),
    # -- script ----------------------------------------------------------------------------
    "script.missing_files": N_(
        "The script needs these files, which are missing: {files:names}. Restore them before you "
        "run the script."
    ),
    "script.estimate_refused": N_(
        "The project contains estimated angles, but they cannot be estimated again now: {reason}"
    ),
    "script.other_angles": N_(
        "The angles of this script differ from those of the project by up to {difference:deg.4}°"
        " ({angle}), because the project was estimated with other points or in another version. "
        "Run Estimate again in the project to get the angles of the script."
    ),
    "script.no_reference": N_(
        "The reference {file} was not found next to the lines. Enter its path in the step "
        "project.check, with its sigma and crs if they were given, and remove the # before the "
        "step."
    ),
    "script.other_check": N_(
        "The check against {file} gives different results in this script, because its coordinates "
        "are assumed to be in {system}. Enter crs, sigma and the other options of the original "
        "check in the step project.check."
    ),
    # -- history ---------------------------------------------------------------------------
    "history.no_folder": N_("{folder}: this folder does not exist. Check the path."),
    "history.no_permission": N_(
        "{folder}: you do not have permission to read this folder. Check its permissions."
    ),
    "history.no_project": N_(
        "No project was found in {folders:names}. Choose a folder that contains projects."
    ),
    "history.none": N_(
        "These folders contain no calibration with a result and a date. Estimate the boresight of "
        "a project and enter its survey dates."
    ),
    "history.none_of_vessel": N_(
        "These folders contain no calibration of {vessel} with a result and a date. Estimate the "
        "boresight of a project and enter its survey dates."
    ),
    "history.none_and_excluded": N_("{reason} A project is not used: {excluded}"),
    "history.excluded": N_("A project is not used: {reason}"),
    "history.same_lines": N_("{folder} is not used, because it has the same lines as {other}."),
    "history.unnamed_system": N_(
        "The vessel, scanner and INS/GNSS of these projects are not specified, so the projects may "
        "belong to different systems. Enter them under Details for the report."
    ),
    "history.first": N_("{name} is the first calibration of the series."),
    "history.moved": N_(
        "{name} differs significantly from the earlier calibrations, most in {difference}: the "
        "mounting has moved, or one of the calibrations is wrong. A new series begins with "
        "{name}: check the mounting and the calibrations."
    ),
    "history.within_limits": N_(
        "{name} is within the control limits of the earlier calibrations. Largest difference: "
        "{difference}."
    ),
    "history.no_result": N_("{project} has no estimated boresight."),
    "history.no_date": N_("{project} has no survey date. Enter it in the details for the report."),
    "history.no_day": N_(
        "{project}: its survey dates ({dates}) contain no complete date such as 2026-03-04. Enter "
        "one in the details for the report."
    ),
    # -- repeat --------------------------------------------------------------------------------
    "repeat.given_twice": N_("{folder}: this project was given twice. Give each project once."),
    # -- sensor --------------------------------------------------------------------------------
    "sensor.no_scanner": N_(
        "There is no scanner named {name} in the library. Give one of {known:names}."
    ),
    "sensor.no_pos": N_("There is no POS named {name} in the library. Give one of {known:names}."),
    "sensor.no_solution": N_(
        "{name}: choose the GNSS solution whose standard deviations are to be used: "
        "{known:choices}."
    ),
    "sensor.no_sigmas": N_(
        "No standard deviations are given. Give them for at least one GNSS solution."
    ),
    "sensor.no_title": N_("A sensor needs a title. Enter maker and model."),
    "sensor.no_source": N_(
        "The source of the specifications is missing. Enter it, for example a data sheet with its "
        "date."
    ),
    "sensor.long_text": N_(
        "A title or a source must be one line of at most {limit:n} characters. Shorten it."
    ),
    "sensor.title_taken": N_(
        "There is already a sensor with the title {title}. Enter another title."
    ),
    "sensor.supplied": N_(
        "{title} is supplied with the program and cannot be removed. Remove only sensors that you "
        "added."
    ),
    "sensor.not_removed": N_(
        "{file}: this file cannot be removed ({reason}). Check its permissions."
    ),
    # -- manual --------------------------------------------------------------------------------
    "manual.not_installed": Plural(
        "The manual cannot be built, because {packages:names} is not installed. Start the "
        "program with installer/bootstrap.py run, or read the texts in {folder}.",
        "The manual cannot be built, because {packages:names} are not installed. Start the "
        "program with installer/bootstrap.py run, or read the texts in {folder}.",
    ),
    "manual.not_built": N_(
        "The manual could not be built ({reason}). Read its text files in the folder "
        "resources/manual, and report this error."
    ),
    "manual.not_writable": N_(
        "{folder}: the manual cannot be written in this folder ({reason}). Free some disk space, "
        "or choose another cache folder in the settings."
    ),
    # -- check ---------------------------------------------------------------------------------
    "check.line_not_compared": N_("{line}: {reason}"),
    "check.points_not_compared": N_(
        "No line has a flat area within {distance:m} m of {points:names}. No comparison is made "
        "there."
    ),
    # -- project_files -------------------------------------------------------------------------
    "project_files.many_missing": N_(
        "{file}: this file does not exist, and {count:n} other files are missing too "
        "({others:names} among them). Restore them, or give their new location."
    ),
    "project_files.none_of_many_found": N_(
        "{folder}: none of the {count:n} missing files ({files:names} among them) is in this "
        "folder or its subfolders. Choose the folder that contains them."
    ),
}
