"""Texts of messages about coordinate systems, times, points and conventions of a survey."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- coordinate systems ------------------------------------------------------------------------
    "crs.points_outside": Plural(
        "The point at ({x:x.3}; {y:x.3}; {z:x.3}) lies outside the area of use of {system} "
        "or outside its geoid grid. Check the coordinate system.",
        "{count:n} points lie outside the area of use of {system} or outside its geoid grid, the "
        "first at ({x:x.3}; {y:x.3}; {z:x.3}). Check the coordinate system.",
    ),
    "crs.unusable": N_(
        "{system}: PROJ cannot use this coordinate system ({reason}). Give its EPSG code, for "
        "example EPSG:32619."
    ),
    "crs.local_frame": N_(
        "{system}: a local frame needs the latitude, longitude and height of its origin. Give them "
        "as in this example: local:46.8,-71.2,20."
    ),
    "crs.not_tied_to_earth": N_(
        "{system}: this coordinate system has no defined position on Earth. Give the EPSG code of "
        "the coordinate system of the points."
    ),
    "crs.geocentric_height": N_(
        "{system}: geocentric coordinates have no vertical reference. Leave the vertical reference "
        "empty."
    ),
    "crs.none_given": N_(
        "The points have no coordinate system. Give its EPSG code, for example EPSG:32619."
    ),
    "crs.unknown": N_(
        "{system}: PROJ does not know this coordinate system. Give its EPSG code, for example "
        "EPSG:32619, or its WKT."
    ),
    "crs.not_vertical": N_(
        '{height}: {system} is not a vertical coordinate system. Give "ellipsoid", the EPSG code '
        "of a vertical system, or a geoid grid (.gtx, .tif)."
    ),
    "crs.meant_elsewhere": N_(
        "The trajectory (latitude {latitude:deg.1}, longitude {longitude:deg.1}°) lies outside "
        "the area of {system}: {area}. Check the coordinate system; the UTM zone of the trajectory "
        "is {zone}."
    ),
    "crs.unknown_unit": N_("There is no unit of height {unit}. Choose {units:choices}."),
    "crs.not_geographic": N_(
        "{datum}: this is not a geographic coordinate system. Give the datum of the trajectory as "
        "a geographic system, for example EPSG:7912 (ITRF2014)."
    ),
    "crs.no_datum": N_(
        "{system}: this coordinate system does not specify a datum. Give its EPSG code."
    ),
    "crs.other_ellipsoid": N_(
        "{system} uses the ellipsoid {ellipsoid}, which satellite positioning does not use. Give "
        "the datum of the trajectory, for example EPSG:4979 (WGS 84)."
    ),
    "crs.no_operation": N_(
        "PROJ knows no transformation from {source} to {target}, and no grid file provides one. "
        "Give a system with a known transformation (see epsg.org), another datum of the "
        "trajectory, or no system if both have the same datum."
    ),
    "crs.datum_ensemble": N_(
        "PROJ knows no transformation from {source} to {target}, because {datum} comprises several "
        "realizations, each with its own transformation to {target}. Give the system in the "
        "realization of the survey (the latest: {systems:choices}) and the survey date as a "
        "decimal year."
    ),
    "crs.datum_ensemble_heights": N_(
        "PROJ knows no transformation from {source} to {target}, because {datum} comprises several "
        "realizations. Give the system in the realization of the survey (the latest: "
        "{systems:choices}), the survey date as a decimal year and, separately, the vertical "
        "reference."
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
        "The transformation from {source} to {target} depends on time. Give the survey date "
        "(epoch) as a decimal year, for example epoch=2024.5."
    ),
    "crs.geoid_not_found": N_("{file}: this geoid grid does not exist. Check the path."),
    "crs.geoid_path": N_(
        "{file}: the path of a geoid grid must not contain commas or quotation marks. Rename the "
        "grid file or its folder."
    ),
    "crs.geoid_unreadable": N_(
        "{file}: this file cannot be read as a geoid grid. Choose a grid in a PROJ format (.gtx or "
        "GeoTIFF)."
    ),
    # -- times -------------------------------------------------------------------------------------
    "time.unknown_base": N_("There is no time base {base}. Choose {bases:choices}."),
    "time.no_date": N_(
        "Times in the time base {base} do not contain the date. Give the survey date."
    ),
    # -- trajectory and points ---------------------------------------------------------------------
    "survey.outside_trajectory": N_(
        "Points from {first:s.3} to {last:s.3} s lie outside the trajectory ({start:s.3} to "
        "{end:s.3} s). Check that points and trajectory have the same time base."
    ),
    "survey.trajectory_without_position": N_(
        "The trajectory contains no positions: latitude and longitude are 0 everywhere. Export it "
        "from the first GNSS fix on."
    ),
    "survey.trajectory_steep": N_(
        "The pitch of the trajectory exceeds {limit:deg.0}° most of the time, so roll and "
        "heading cannot be separated. Export the trajectory for a vessel or reference frame with a "
        "level X axis, not for the frame of a tilted IMU."
    ),
    "survey.points_too_far": N_(
        "In {system}, half of the points are more than {limit:m.0} m from the scanner. Check the "
        "coordinate system and its unit, and check that points and trajectory have the same time "
        "base."
    ),
    "survey.points_of_file_too_far": N_(
        "{file}: in {system}, half of the points are more than {limit:m.0} m from the scanner. "
        "Check the coordinate system and its unit, and check that points and trajectory have the "
        "same time base."
    ),
    "survey.not_scanner_frame": N_(
        "{file}: half of the points are more than {limit:m.0} m from the origin (up to "
        "{farthest:m.0} m), so they are not in the scanner frame. Check the unit, omit the option "
        "frame, or give frame=georeferenced and the coordinate system."
    ),
    "survey.not_a_condition": N_(
        "“{text}” is not a condition for selecting points. Give ATTRIBUTE=VALUE or "
        "ATTRIBUTE=LOW:HIGH, for example scanner_channel=0 or time=1200:1260."
    ),
    "survey.not_classes": N_(
        "“{text}” is not a list of class numbers. Give numbers, for example 7 18."
    ),
    "survey.not_a_range": N_(
        "“{text}” is not a maximum range. Give a number of metres, for example 250."
    ),
    "survey.unknown_attribute": N_(
        "The points have no attribute {name}, so they cannot be selected by it. Choose one of "
        "{names:names}."
    ),
    "survey.vector_attribute": N_(
        "{name}: this attribute has several values per point, so it cannot select points. Choose "
        "another attribute."
    ),
    # -- conventions of other programs -------------------------------------------------------------
    "survey.unknown_direction": N_(
        "“{word}” is not a direction on a vessel. Choose {directions:choices}."
    ),
    "survey.axes_not_spanning": N_(
        "The axes {axes:names} do not form a three-dimensional system. Give three directions that "
        "are not parallel or opposite."
    ),
    "survey.axes_on_one_line": N_(
        "X ({x}) and Y ({y}) are parallel or opposite. Give two other directions."
    ),
    "survey.axes_left_handed": N_(
        "{system}: the body axes (X {x}, Y {y}, Z {z}) are left-handed, so no rotation leads from "
        "unchanged scanner axes to them. Choose scanner axes that are turned together with the "
        "body axes."
    ),
    "survey.direction_forward": N_("forward"),
    "survey.direction_aft": N_("aft"),
    "survey.direction_port": N_("port"),
    "survey.direction_starboard": N_("starboard"),
    "survey.direction_up": N_("up"),
    "survey.direction_down": N_("down"),
    "survey.matrix_only": N_(
        "{system}: the boresight for this program is available only as a matrix, not as angles. "
        "Use the matrix."
    ),
    "survey.matrix_shape": N_(
        "A rotation matrix must have three rows of three finite numbers. Correct the matrix."
    ),
    "survey.not_a_rotation": N_(
        "The matrix is not a rotation: its rows deviate by {deviation:x} from orthogonal unit "
        "vectors. Give at least six decimals, without a scale factor."
    ),
    "survey.matrix_mirrors": N_(
        "The matrix is a reflection (determinant -1), not a rotation: one axis has the wrong sign. "
        "Check the directions of the axes."
    ),
    "survey.unknown_program": N_("There is no convention named {name}. Choose {names:choices}."),
    "survey.matrix_not_numbers": N_(
        "{where}: {word} is not a number. Give a matrix of 3x3 or 4x4 numbers."
    ),
    "survey.matrix_count": N_(
        "{where}: the matrix has {count:n} numbers. Give 9 numbers for a 3x3 matrix or 16 numbers "
        "for a 4x4 matrix."
    ),
    "survey.matrix_last_row": N_(
        "{where}: the last row of a 4x4 matrix must be 0 0 0 1. Give the matrix row by row, not "
        "column by column."
    ),
    "survey.lever_arm_not_finite": N_(
        "{where}: a component of the lever arm is NaN or infinite. Correct it."
    ),
}
