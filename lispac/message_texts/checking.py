"""Texts of messages about validation and the patch test."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- cloud distances ---------------------------------------------------------------------------
    "validation.max_distance": N_(
        "The maximum distance must be above zero, and it is {distance:m} m. Correct it."
    ),
    "validation.empty_reference": N_(
        "The reference cloud has no points, so there is no distance to it."
    ),
    "validation.compared_shape": N_(
        "The compared cloud must be an array of shape (n, 3), and its shape is {shape}."
    ),
    "validation.reference_shape": N_(
        "The reference cloud must be an array of shape (n, 3), and its shape is {shape}."
    ),
    "validation.compared_not_finite": N_(
        "{count:n} of {total:n} points of the compared cloud have coordinates that are not finite. "
        "Remove them."
    ),
    "validation.reference_not_finite": N_(
        "{count:n} of {total:n} points of the reference cloud have coordinates that are not "
        "finite. Remove them."
    ),
    "validation.unknown_model": N_("{kind}: unknown local model. Choose {kinds:choices}."),
    "validation.model_radius": N_(
        "The radius of the local model ({kind}) must be above zero, and it is {radius:m} m. "
        "Correct it."
    ),
    "validation.model_neighbours": N_(
        "The local model ({kind}) needs at least {needed:n} neighbours, and {count:n} are given. "
        "Increase their number."
    ),
    "validation.normal_scale": N_(
        "The scale of the normals must be above zero, and it is {value:m} m. Correct it."
    ),
    "validation.cylinder_diameter": N_(
        "The diameter of the cylinder must be above zero, and it is {value:m} m. Correct it."
    ),
    "validation.cylinder_depth": N_(
        "The depth of the cylinder must be above zero, and it is {value:m} m. Correct it."
    ),
    "validation.no_places": N_("There is no place to measure a distance at."),
    "validation.cylinder_too_narrow": N_(
        "No place has {needed:n} points of both clouds within a cylinder of {diameter:m.2} m. "
        "Choose a larger diameter."
    ),
    "validation.no_distances": N_("Statistics need at least one distance, and only finite ones."),
    # -- lines and references ----------------------------------------------------------------------
    "validation.no_place_in_common": N_(
        "{line} and {other} have no place in common within {reach:m} m."
    ),
    "validation.no_flat_place": N_("{line} and {other} share no flat place."),
    "validation.plane_few_points": N_(
        "A plane with its confidence interval needs at least four points of each line."
    ),
    "validation.points_in_row": N_(
        "The points of a line lie in one row and do not determine a plane."
    ),
    "validation.line_out_of_reach": N_("The line has no surface within reach of the reference."),
    "validation.no_flat_point": N_(
        "No surveyed point has a flat place of the line in front of it."
    ),
    "validation.no_place_in_both": N_(
        "No place of the reference is seen both before and after the calibration."
    ),
    # -- validation planes -------------------------------------------------------------------------
    "validation.plane_in_one_line": N_(
        "The validation plane {plane} is seen in one line only ({line}) with at least {needed:n} "
        "points. A comparison needs two lines. Pick it in another line, or choose another plane."
    ),
    "validation.plane_in_no_line": N_(
        "The validation plane {plane} is seen in no line with at least {needed:n} points. A "
        "comparison needs two lines. Pick it in other lines, or choose another plane."
    ),
    "validation.no_overlap": N_(
        "No two lines overlap on the validation plane {plane} in at least {needed:n} points, "
        "before and after. Choose a larger plane, or pick it again."
    ),
    "validation.other_lines": N_(
        "The validation plane {plane} is not in the same lines before and after the calibration. "
        "Lines with one state only: {lines:names}."
    ),
    "validation.shape_before": N_(
        "The points of {plane} in line {line} (before) must have the shape (n, 3), and theirs is "
        "{shape}."
    ),
    "validation.shape_after": N_(
        "The points of {plane} in line {line} (after) must have the shape (n, 3), and theirs is "
        "{shape}."
    ),
    "validation.not_finite_before": N_(
        "The points of {plane} in line {line} (before) have coordinates that are not finite."
    ),
    "validation.not_finite_after": N_(
        "The points of {plane} in line {line} (after) have coordinates that are not finite."
    ),
    "validation.other_points": N_(
        "Line {line} has {before:n} points on {plane} before and {after:n} after. Both states must "
        "have the same points."
    ),
    "validation.no_heading": N_("The heading of line {line}, which sees {plane}, is not given."),
    # -- repeatability -----------------------------------------------------------------------------
    "validation.repeatability_values": N_("{name}: three angles and their covariance are needed."),
    "validation.repeatability_covariance": N_(
        "{name}: the covariance is not positive definite. A calibration without uncertainty cannot "
        "be compared."
    ),
    "validation.repeatability_few": N_(
        "Repeatability needs at least two calibrations of the same mounting."
    ),
    # -- patch test --------------------------------------------------------------------------------
    "patch_test.no_pairs": N_(
        "No two of the selected lines meet at any object. Select objects that both lines of a pair "
        "see."
    ),
    "patch_test.no_roll": N_(
        "The selected objects and pairs do not determine roll. Add objects that face other ways, "
        "or lines in other directions."
    ),
    "patch_test.no_pitch": N_(
        "The selected objects and pairs do not determine pitch. Add objects that face other ways, "
        "or lines in other directions."
    ),
    "patch_test.no_yaw": N_(
        "The selected objects and pairs do not determine yaw. Add objects that face other ways, or "
        "lines in other directions."
    ),
    "patch_test.box_not_finite": N_(
        "{name}: the centre or rotation of the box is not a finite number. Correct it."
    ),
    "patch_test.box_size": N_(
        "{name}: each side of the box must be from {least:m} to {most:m} m. Correct it."
    ),
}
