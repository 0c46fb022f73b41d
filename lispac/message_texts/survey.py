"""Texts of messages about coordinate systems, times, points and conventions of a survey."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- coordinate systems ------------------------------------------------------------------------
    "crs.points_outside": Plural(
        "The point at ({x:x.3}; {y:x.3}; {z:x.3}) lies outside {system} or its geoid grid. Check "
        "the coordinate system.",
        "{count:n} points lie outside {system} or its geoid grid, the first at ({x:x.3}; {y:x.3}; "
        "{z:x.3}). Check the coordinate system.",
    ),
    "crs.unusable": N_(
        "{system}: PROJ cannot use this coordinate system ({reason}). Give its EPSG code, "
        "EPSG:32619 for example."
    ),
    "crs.local_frame": N_(
        "{system}: a local frame needs the latitude, longitude and height of its origin. Give them "
        "as in local:46.8,-71.2,20."
    ),
    "crs.not_tied_to_earth": N_(
        "{system}: this coordinate system is not tied to the Earth. Give the EPSG code of the "
        "coordinate system of the points."
    ),
    "crs.geocentric_height": N_(
        "{system}: geocentric coordinates have no vertical reference. Leave the vertical reference "
        "empty."
    ),
    "crs.none_given": N_(
        "The points name no coordinate system. Give its EPSG code, EPSG:32619 for example."
    ),
    "crs.unknown": N_(
        "{system}: PROJ does not know this coordinate system. Give its EPSG code, EPSG:32619 for "
        "example, or its WKT."
    ),
    "crs.not_vertical": N_(
        '{height}: {system} is not a vertical coordinate system. Give "ellipsoid", the EPSG code '
        "of a vertical system, or a geoid grid (.gtx, .tif)."
    ),
    "crs.meant_elsewhere": N_(
        "{system} is meant for {area}, but the trajectory is at latitude {latitude:deg.1}, "
        "longitude {longitude:deg.1} deg. Check the system; the UTM zone there is {zone}."
    ),
    "crs.unknown_unit": N_("{unit}: unknown unit of heights. Choose {units:choices}."),
    "crs.not_geographic": N_(
        "{datum}: not a geographic coordinate system. Give the datum of the trajectory as one, "
        "EPSG:7912 (ITRF2014) for example."
    ),
    "crs.no_datum": N_("{system}: this coordinate system names no datum. Give its EPSG code."),
    "crs.other_ellipsoid": N_(
        "{system} is on the ellipsoid {ellipsoid}, not on that of satellite positioning. Give the "
        "datum of the trajectory, EPSG:4979 (WGS 84) for example."
    ),
    "crs.no_operation": N_(
        "PROJ knows no transformation from {source} to {target}, and no grid file provides one. "
        "Give a system whose datum is tied to {target} (epsg.org lists them), or another datum of "
        "the trajectory, or none where both are in one datum."
    ),
    "crs.datum_ensemble": N_(
        "PROJ knows no transformation from {source} to {target}: {datum} stands for all its "
        "realizations, and only each of these is tied to {target}. Give the system on the "
        "realization of the survey (the latest: {systems:choices}) with the date of the survey as "
        "a decimal year."
    ),
    "crs.datum_ensemble_heights": N_(
        "PROJ knows no transformation from {source} to {target}: {datum} stands for all its "
        "realizations, and only each of these is tied to {target}. Give the system on the "
        "realization of the survey (the latest: {systems:choices}) with the date of the survey as "
        "a decimal year. Give the vertical reference separately."
    ),
    "crs.grids_missing": Plural(
        "The transformation from {source} to {target} needs the grid file {grids:names}, which is "
        "not on this computer and is not downloaded. Put it into {folder}, or export the points "
        "with ellipsoidal heights in the datum of the trajectory.",
        "The transformation from {source} to {target} needs the grid files {grids:names}, which "
        "are not on this computer and are not downloaded. Put them into {folder}, or export the "
        "points with ellipsoidal heights in the datum of the trajectory.",
    ),
    "crs.grids_missing_geoid": Plural(
        "The transformation from {source} to {target} needs the grid file {grids:names}, which is "
        "not on this computer and is not downloaded. Give the geoid as a file (.gtx, .tif), put "
        "the grid file into {folder}, or export the points with ellipsoidal heights in the datum "
        "of the trajectory.",
        "The transformation from {source} to {target} needs the grid files {grids:names}, which "
        "are not on this computer and are not downloaded. Give the geoid as a file (.gtx, .tif), "
        "put the grid files into {folder}, or export the points with ellipsoidal heights in the "
        "datum of the trajectory.",
    ),
    "crs.grid_missing": N_(
        "The transformation from {source} to {target} needs a grid file that is not on this "
        "computer and is not downloaded. Put it into {folder}, or export the points with "
        "ellipsoidal heights in the datum of the trajectory."
    ),
    "crs.grid_missing_geoid": N_(
        "The transformation from {source} to {target} needs a grid file that is not on this "
        "computer and is not downloaded. Give the geoid as a file (.gtx, .tif), put the grid file "
        "into {folder}, or export the points with ellipsoidal heights in the datum of the "
        "trajectory."
    ),
    "crs.epoch_missing": N_(
        "The transformation from {source} to {target} changes with time. Give the date of the "
        "survey (its epoch) as a decimal year, epoch=2024.5 for example."
    ),
    "crs.geoid_not_found": N_("{file}: this geoid grid does not exist. Check the path."),
    "crs.geoid_path": N_(
        "{file}: PROJ accepts no commas or quotation marks in a path. Rename the grid file or its "
        "folder."
    ),
    "crs.geoid_unreadable": N_(
        "{file}: this file cannot be read as a geoid grid. Give a grid of PROJ (.gtx or GeoTIFF)."
    ),
    # -- times -------------------------------------------------------------------------------------
    "time.unknown_base": N_("{base}: unknown time base. Choose {bases:choices}."),
    "time.no_date": N_(
        "Times in the time base {base} start again and do not give the date. Give the date of the "
        "survey."
    ),
    # -- trajectory and points ---------------------------------------------------------------------
    "survey.outside_trajectory": N_(
        "Points from {first:s.3} to {last:s.3} s lie outside the trajectory ({start:s.3} to "
        "{end:s.3} s). Check that both have the same time base."
    ),
    "survey.trajectory_without_position": N_(
        "No state of the trajectory has a position: latitude and longitude are 0 everywhere. "
        "Export it from the first GNSS fix on."
    ),
    "survey.trajectory_steep": N_(
        "The pitch of the trajectory exceeds {limit:deg.0} deg most of the time, where roll and "
        "heading cannot be separated. Export it for a body frame whose X axis is level (vessel or "
        "reference frame, not that of a tilted IMU)."
    ),
    "survey.points_too_far": N_(
        "Half of the points are more than {limit:m.0} m from the scanner with {system}. Check the "
        "coordinate system and its unit, and that points and trajectory have the same time base."
    ),
    "survey.points_of_file_too_far": N_(
        "{file}: half of the points are more than {limit:m.0} m from the scanner with {system}. "
        "Check the coordinate system and its unit, and that points and trajectory have the same "
        "time base."
    ),
    "survey.not_scanner_frame": N_(
        "{file}: half of the points are more than {limit:m.0} m from the origin (up to "
        "{farthest:m.0} m), so they are not in the scanner frame. Give no frame, or "
        "frame=georeferenced and the coordinate system. Check the unit."
    ),
    "survey.not_a_condition": N_(
        "{text}: not a condition for points. Give ATTRIBUTE=VALUE or ATTRIBUTE=LOW:HIGH, "
        "scanner_channel=0 or time=1200:1260 for example."
    ),
    "survey.not_classes": N_("{text}: not a list of classes. Give numbers, 7 18 for example."),
    "survey.not_a_range": N_("{text}: not a maximum range. Give metres, 250 for example."),
    "survey.unknown_attribute": N_(
        "{name}: the points have no attribute of this name to select by. They have {names:names}."
    ),
    "survey.vector_attribute": N_(
        "{name}: this attribute has several values per point, so it cannot select points. Choose "
        "another attribute."
    ),
    # -- conventions of other programs -------------------------------------------------------------
    "survey.unknown_direction": N_(
        "{word}: not a direction on a vessel. Choose {directions:choices}."
    ),
    "survey.axes_not_spanning": N_(
        "The axes {axes:names} do not span space. Give directions along three different lines."
    ),
    "survey.axes_on_one_line": N_(
        "X ({x}) and Y ({y}) lie on one line. Give directions along two different lines."
    ),
    "survey.axes_left_handed": N_(
        "{system}: the body axes (X {x}, Y {y}, Z {z}) are left-handed. No rotation leads to them "
        "from scanner axes that are kept. Choose scanner axes that are turned with the body axes."
    ),
    "survey.direction_forward": N_("forward"),
    "survey.direction_aft": N_("aft"),
    "survey.direction_port": N_("port"),
    "survey.direction_starboard": N_("starboard"),
    "survey.direction_up": N_("up"),
    "survey.direction_down": N_("down"),
    "survey.matrix_only": N_(
        "{system}: no angles are available for this program, only a matrix. Use the matrix."
    ),
    "survey.matrix_shape": N_(
        "A rotation needs three rows of three finite numbers. Correct the matrix."
    ),
    "survey.not_a_rotation": N_(
        "The matrix is not a rotation: its rows deviate by {deviation:x} from being orthogonal and "
        "of length one. Give at least six decimals, and no scale."
    ),
    "survey.matrix_mirrors": N_(
        "The matrix mirrors (determinant -1) instead of rotating: one axis has the wrong sign. "
        "Check the directions of the axes."
    ),
    "survey.unknown_program": N_(
        "{name}: there is no convention of this name. Choose {names:choices}."
    ),
    "survey.matrix_not_numbers": N_(
        "{where}: {word} is not a number. Give a matrix of 3x3 or 4x4 numbers."
    ),
    "survey.matrix_count": N_(
        "{where}: {count:n} numbers do not make a 3x3 or 4x4 matrix. Give 9 or 16 numbers."
    ),
    "survey.matrix_last_row": N_(
        "{where}: the last row of a 4x4 matrix must be 0 0 0 1. Give the matrix by rows, not by "
        "columns."
    ),
    "survey.lever_arm_not_finite": N_(
        "{where}: a number of the lever arm is not finite. Correct it."
    ),
}
