"""Texts of messages about picking targets and estimating the boresight."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- estimate ------------------------------------------------------------------------------
    "estimate.needed": N_("{project}: no boresight has been estimated yet. Estimate it first."),
    "estimate.no_common_target": N_(
        "No target is used on two lines ({targets:names}), so the lines cannot be compared. "
        "Seed each target on other lines too."
    ),
    "estimate.no_target": N_("{project}: there is no target to adjust. Pick planar targets first."),
    "estimate.one_line": N_(
        "All sightings are on line {line}. A surface observed from one line only fits any "
        "boresight. Add lines in other directions over the same targets."
    ),
    "estimate.no_common_part": N_(
        "The lines show different parts of every target ({targets:names}), and these parts are "
        "not flat enough to be one plane. Seed surfaces that the lines share."
    ),
    "estimate.possible_cause": N_("{reason} Possible cause: {cause}"),
    "estimate.point_spacing": N_("Give the point spacings in metres, 0 for all points."),
    "estimate.lever_arm_sigma": N_(
        "The standard deviations of the lever arm must be zero or more. Correct them."
    ),
    "estimate.few_validation_planes": N_(
        "{project}: at least two validation planes that two lines see are needed. Pick more of "
        "them, with different orientations."
    ),
    "estimate.patch_test_without_sigma": N_(
        "The patch test has no standard deviation, so its result cannot be compared with "
        "others. Add objects, and find all three angles again."
    ),
    # -- patch_test ----------------------------------------------------------------------------
    "patch_test.single_line": N_(
        "{project}: there is only one line, so nothing can be compared. Add lines in other "
        "directions over the same scene."
    ),
    "patch_test.nothing_shared": N_(
        "{project}: the lines share no flat surface. Draw boxes around objects that two lines see."
    ),
    # -- targetless ----------------------------------------------------------------------------
    "targetless.single_line": N_(
        "{project}: there is only one line, so nothing can be compared. Add lines in other "
        "directions over the same scene."
    ),
    "targetless.few_surfaces": Plural(
        "{project}: the lines share only {count:n} flat surface, and at least {least:n} are "
        "needed. Add lines that overlap, or put up targets.",
        "{project}: the lines share only {count:n} flat surfaces, and at least {least:n} are "
        "needed. Add lines that overlap, or put up targets.",
    ),
    "targetless.no_target": N_(
        "{project}: there is no target to adjust with the scene. Pick one, or leave the targets "
        "out."
    ),
    # -- pick ----------------------------------------------------------------------------------
    "pick.points_changed": N_(
        "{target}: its points on {line} were chosen in another file, or the trajectory now "
        "covers other points of that file. Restore the file, or pick the target again."
    ),
    "pick.no_such_point": N_(
        "{name}: {line} has points 0 to {last:n}, but point {number:n} is requested."
    ),
    "pick.no_line_plane": N_("There is no line in which to search for a plane."),
    "pick.no_line_sphere": N_("There is no line in which to search for a sphere."),
    "pick.is_target": N_(
        "{project}: {target} is already a target. Pick it in the same role, or give another name."
    ),
    "pick.is_validation_plane": N_(
        "{project}: {target} is already a validation plane. Pick it in the same role, or give "
        "another name."
    ),
    "pick.is_plane": N_(
        "{target} is already a plane. Pick it with the same shape, or give another name."
    ),
    "pick.is_sphere": N_(
        "{target} is already a sphere. Pick it with the same shape, or give another name."
    ),
    "pick.radius_unknown": N_(
        "{target} is a sphere of unknown radius. Pick it without a radius, or give another name."
    ),
    "pick.other_radius": N_(
        "{target} has a radius of {radius:m} m. Pick it with the same radius, or give another name."
    ),
    "pick.name_taken": N_(
        "{file}, row {row:n}: the project already has a {target}. Give it another name in the "
        "list, or choose to replace it."
    ),
    "pick.none_found": Plural(
        "{file}: no target was found at the seed. {target} (row {row:n}): {reason}",
        "{file}: no target was found at any of the {count:n} seeds. {target} (row {row:n}): "
        "{reason}",
    ),
    "pick.some_not_found": Plural(
        "{file}: no target was found at {count:n} of the {total:n} seeds: {seeds:names} (row "
        "{rows:names}). The table gives the reason. The others are saved.",
        "{file}: no target was found at {count:n} of the {total:n} seeds: {seeds:names} (rows "
        "{rows:names}). The table gives the reasons. The others are saved.",
    ),
    "pick.too_many_numbers": N_(
        "The list of point numbers has more than {limit:n} points. Correct it."
    ),
    "pick.not_a_number": N_(
        "The list of point numbers has '{text}', which is neither a number nor a first number "
        "and a count, such as 12+40."
    ),
    # -- edit ----------------------------------------------------------------------------------
    "edit.few_points_left": Plural(
        "{target} on {line} would keep only {count:n} point. Untick the sighting in the table "
        "instead.",
        "{target} on {line} would keep only {count:n} points. Untick the sighting in the table "
        "instead.",
    ),
    "edit.no_surface_left": N_(
        "{target}: the points that would be left do not form a surface. {reason}"
    ),
    "edit.no_name": N_("A target needs a name. {target} keeps its name."),
    "edit.name_taken": N_("There is already a target named {name}. Give {target} another name."),
    # -- section -------------------------------------------------------------------------------
    "section.no_points": N_(
        "{target} has no points on any line, so no section can be cut through it."
    ),
    # -- propose -------------------------------------------------------------------------------
    "propose.few_flat_surfaces": Plural(
        "{project}: only {count:n} flat surface is seen on two lines or more ({uneven:n} others "
        "are not flat, {poor:n} are seen poorly), and two are needed. Set seeds on the targets, "
        "put up boards, or use the targetless method.",
        "{project}: only {count:n} flat surfaces are seen on two lines or more ({uneven:n} "
        "others are not flat, {poor:n} are seen poorly), and two are needed. Set seeds on the "
        "targets, put up boards, or use the targetless method.",
    ),
    "propose.one_orientation": N_(
        "All flat surfaces found face the same way, which does not determine the boresight. Put "
        "up a board of another inclination, or set seeds by hand."
    ),
    "propose.not_determined": N_(
        "No two of the planes found determine the boresight. Put up a board of another "
        "inclination, or set seeds by hand."
    ),
    # -- error budget ------------------------------------------------------------------------------
    "budget.geometry": N_(
        "Standard deviations of a point for a level vessel that heads north; distances are from "
        "the scanner. Horizontal and across the beam are root sums of squares of two directions."
    ),
    "budget.pos": N_(
        "POS: median of the accuracies on the lines, {north:mm.1}, {east:mm.1}, {up:mm.1} mm "
        "(north, east, up) and {roll:deg.4}, {pitch:deg.4}, {heading:deg.4} deg (roll, pitch, "
        "heading)."
    ),
    "budget.boresight": N_(
        "Boresight before is not a standard deviation, but the distance between points placed with "
        "the prior and with the estimated angles. Boresight after follows from their covariance."
    ),
    "budget.lidar_per_axis": N_(
        "The LiDAR noise is given per axis. Given for range and beam direction, it would grow with "
        "the distance."
    ),
    "budget.lever_arm_estimated": N_(
        "Of the lever arm only the estimated components are included, with their covariance."
    ),
    "budget.lever_arm_unknown": N_(
        "The uncertainty of the lever arm is not given and not included."
    ),
    "budget.latency": N_(
        "Latency: at the speed of the lines, {speed:x.1} m/s, and their RMS rotation rates, "
        "{roll:deg.2}, {pitch:deg.2}, {heading:deg.2} deg/s (roll, pitch, heading)."
    ),
    "budget.no_latency": N_("A latency was not estimated and is not included."),
    "propose.target": N_(
        "Seen on {lines:n} lines. Without it the standard deviation of {angle} would be "
        "{without:deg.3} deg instead of {sigma:deg.3} deg."
    ),
    "propose.target_needed": N_(
        "Seen on {lines:n} lines. Without it the angles are not determined."
    ),
    "propose.validation_plane": N_(
        "Plane of {area:x.1} m², seen on {lines:n} lines, {height:m.0} m high."
    ),
    "propose.validation_plane_reciprocal": N_(
        "Plane of {area:x.1} m², seen on {lines:n} lines, reciprocal ones among them, "
        "{height:m.0} m high."
    ),
    "propose.validation_plane_poor": N_("{plane} Poor on {lines:names}: {reason}"),
}
