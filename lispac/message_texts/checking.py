"""Texts of messages about validation and the patch test."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

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
    "patch_test.basis": Plural(
        "The result is based on {count:n} object and {lines:n} lines.",
        "The result is based on {count:n} objects and {lines:n} lines.",
    ),
    "patch_test.mismatch_reduced": N_(
        "The mismatch (robust RMS distance between lines, at most {limit:mm.0} mm) decreases from "
        "{before:mm.1} mm with the prior boresight to {after:mm.1} mm."
    ),
    "patch_test.mismatch": N_(
        "The mismatch (robust RMS distance between lines, at most {limit:mm.0} mm) is "
        "{after:mm.1} mm. With the prior boresight the lines do not meet at the objects."
    ),
    "patch_test.no_sigma": Plural(
        "There are no standard deviations: {count:n} object is too few to know how much the result "
        "would change with others. At least {needed:n} are needed.",
        "There are no standard deviations: {count:n} objects are too few to know how much the "
        "result would change with others. At least {needed:n} are needed.",
    ),
    "patch_test.not_converged": N_("The angles were still changing when the search ended."),
    "patch_test.order_matters": N_(
        "Found one after another, the angles end elsewhere: {angle} differs by {difference:deg.3} "
        "deg."
    ),
    "patch_test.object_disagrees": N_(
        "{object} disagrees: its own minimum of {angle} is off by {difference:deg.3+} deg, and "
        "{usual:deg.3} deg would be usual."
    ),
    "patch_test.not_met": N_("No two of the lines meet at {objects:names}."),
    # -- targetless --------------------------------------------------------------------------------
    "targetless.basis": N_(
        "The result is based on {used:n} of {total:n} natural surfaces that lines share. Rounds of "
        "matching: {rounds:n}."
    ),
    "targetless.with_targets": N_("Targets adjusted with them: {targets:n}."),
    "targetless.not_converged": N_(
        "In the last round of matching, the angles still changed by more than {share:percent.0} % "
        "of their standard deviations."
    ),
    "targetless.lines_disagree": N_("Lines that disagree with the others: {lines:names}."),
    # -- methods -----------------------------------------------------------------------------------
    "method.targets": N_("targets"),
    "method.natural_planes": N_("natural planes"),
    "method.targetless": N_("targetless method"),
    "method.patch_test": N_("patch test"),
    "methods.agree": N_(
        "No significant difference between the {method} and the {other}: a point at "
        "{distance:m.0} m moves by {displacement:mm.0} mm."
    ),
    "methods.differ": N_(
        "Significant difference between the {method} and the {other} in {angles:names}: a point at "
        "{distance:m.0} m moves by {displacement:mm.0} mm."
    ),
    "methods.differ_together": N_(
        "Significant difference between the {method} and the {other} in all angles together: a "
        "point at {distance:m.0} m moves by {displacement:mm.0} mm."
    ),
    "methods.same_lines": N_(
        "All methods use the same lines, so no comparison shows an error of the trajectory that "
        "affects them alike. The standard deviations of the differences are rather too large: a "
        "difference indicates an error, but agreement is no proof."
    ),
    # -- reference ---------------------------------------------------------------------------------
    "absolute.after_nearer": N_(
        "After the calibration all lines together lie {mean:mm.1} mm nearer to the vessel than the "
        "reference on average, ± {interval:mm.1} mm (95 %). {finding}"
    ),
    "absolute.after_farther": N_(
        "After the calibration all lines together lie {mean:mm.1} mm farther from the vessel than "
        "the reference on average, ± {interval:mm.1} mm (95 %). {finding}"
    ),
    "absolute.before_nearer": N_(
        "Before the calibration they lay {mean:mm.1} mm nearer to the vessel, ± {interval:mm.1} mm "
        "(95 %) without the uncertainty of the prior boresight, which is unknown. {finding}"
    ),
    "absolute.before_farther": N_(
        "Before the calibration they lay {mean:mm.1} mm farther from the vessel, ± "
        "{interval:mm.1} mm (95 %) without the uncertainty of the prior boresight, which is "
        "unknown. {finding}"
    ),
    "absolute.explained": N_("This is no more than reference, POS and boresight explain."),
    "absolute.not_explained": N_("This is more than reference, POS and boresight explain."),
    "absolute.explained_before": N_("This is no more than reference and POS explain."),
    "absolute.not_explained_before": N_("This is more than reference and POS explain."),
    "absolute.no_line_off": N_(
        "After the calibration no single line is off by more than its errors explain."
    ),
    "absolute.rms": N_(
        "The RMS of all distances is {before:mm.1} mm before and {after:mm.1} mm after. The "
        "uncertainty of the reference ({reference:mm.1} mm) explains {share:percent.0} % of the "
        "latter; {expected:mm.1} mm are expected from reference, POS and boresight together."
    ),
    "absolute.other_surface": N_(
        "Another surface lies behind or in front of the one measured, within {distance:m} m of the "
        "reference: {lines:names}. The one nearest to the reference is used, which is the wrong "
        "one for a line that is off by more than half that distance."
    ),
    "absolute.former_version": N_(
        "This check was made by an earlier version, which used the mean of all surfaces within the "
        "search distance. It is wrong where a wall stands behind the reference. Repeat it."
    ),
    "absolute.scan_error": N_(
        "The standard deviation of the reference counts as one error that all points of the scan "
        "share, such as that of its registration. The noise of its single points averages out."
    ),
    "absolute.point_errors": N_("Each surveyed point counts with an error of its own."),
    "absolute.lines_alike": N_(
        "In the values of all lines together, means and RMS count each line alike, because its "
        "places share its POS error. Medians and percentiles are those of all places."
    ),
    # -- surface of a line -------------------------------------------------------------------------
    "surface.nearest_point": N_("nearest point"),
    "surface.plane": N_("local plane through {count:n} points"),
    "surface.plane_within": N_("local plane through the points within {radius:m} m"),
    "surface.quadric": N_("local quadric through {count:n} points"),
    "surface.quadric_within": N_("local quadric through the points within {radius:m} m"),
}
