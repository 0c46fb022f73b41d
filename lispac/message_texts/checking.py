"""Texts of messages about validation, references, and results of the alternative methods."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- cloud distances ---------------------------------------------------------------------------
    "validation.max_distance": N_(
        "The maximum distance is {distance:m} m, but it must be above zero. Correct it."
    ),
    "validation.empty_reference": N_(
        "The reference cloud has no points, so no distances can be computed. Choose another "
        "reference."
    ),
    "validation.compared_shape": N_(
        "The array of the compared cloud has the shape {shape}, but (n, 3) is required. Correct it."
    ),
    "validation.reference_shape": N_(
        "The array of the reference cloud has the shape {shape}, but (n, 3) is required. Correct "
        "it."
    ),
    "validation.compared_not_finite": N_(
        "{count:n} of {total:n} points of the compared cloud have coordinates that are NaN or "
        "infinite. Remove them."
    ),
    "validation.reference_not_finite": N_(
        "{count:n} of {total:n} points of the reference cloud have coordinates that are NaN or "
        "infinite. Remove them."
    ),
    "validation.unknown_model": N_(
        "There is no local surface model {kind}. Choose {kinds:choices}."
    ),
    "validation.model_radius": N_(
        "The radius of the local surface model ({kind}) is {radius:m} m, but it must be above "
        "zero. Correct it."
    ),
    "validation.model_neighbours": N_(
        "The local surface model ({kind}) needs at least {needed:n} neighbouring points, but "
        "{count:n} are given. Increase the number."
    ),
    "validation.normal_scale": N_(
        "The diameter of the neighbourhood used to compute the normals is {value:m} m, but it must "
        "be above zero. Correct it."
    ),
    "validation.cylinder_diameter": N_(
        "The diameter of the search cylinder is {value:m} m, but it must be above zero. Correct it."
    ),
    "validation.cylinder_depth": N_(
        "The depth of the search cylinder is {value:m} m, but it must be above zero. Correct it."
    ),
    "validation.no_places": N_(
        "There are no core points, so no distances can be computed. Give at least one core point."
    ),
    "validation.cylinder_too_narrow": N_(
        "No core point has {needed:n} points of both clouds within a cylinder of {diameter:m.2} m. "
        "Choose a larger diameter."
    ),
    "validation.no_distances": N_(
        "Statistics need at least one distance, and all distances must be finite. Remove "
        "distances that are NaN or infinite."
    ),
    # -- lines and references ----------------------------------------------------------------------
    "validation.no_place_in_common": N_(
        "Lines {line} and {other} do not overlap within {reach:m} m, so they cannot be compared. "
        "Choose lines that overlap."
    ),
    "validation.no_flat_place": N_(
        "Lines {line} and {other} have no flat area in common, so they cannot be compared. Choose "
        "lines that cover the same flat area."
    ),
    "validation.plane_few_points": N_(
        "A plane with a confidence interval needs at least four points of each line. Choose a "
        "larger plane."
    ),
    "validation.points_in_row": N_(
        "The points of a line lie on one straight line and do not determine a plane. Choose a "
        "larger plane."
    ),
    "validation.line_out_of_reach": N_(
        "No surface of the line lies within the search distance of the reference. Increase the "
        "search distance, or choose a reference that the line covers."
    ),
    "validation.no_flat_point": N_(
        "No surveyed point lies opposite a flat area of the line. Survey points on flat areas "
        "that the line covers."
    ),
    "validation.no_place_in_both": N_(
        "No location of the reference is covered by the line both before and after the "
        "calibration. Increase the search distance, or choose a larger reference."
    ),
    # -- validation planes -------------------------------------------------------------------------
    "validation.plane_in_one_line": N_(
        "Only line {line} has at least {needed:n} points on the validation plane {plane}, but a "
        "comparison needs two lines. Pick the plane on another line, or choose another plane."
    ),
    "validation.plane_in_no_line": N_(
        "No line has at least {needed:n} points on the validation plane {plane}, and a comparison "
        "needs two lines. Pick the plane on other lines, or choose another plane."
    ),
    "validation.no_overlap": N_(
        "No two lines have at least {needed:n} points in a common area of the validation plane "
        "{plane}, before and after the calibration. Choose a larger plane, or pick this plane "
        "again."
    ),
    "validation.plane_edited": N_(
        "The validation plane {plane} was added or changed after the last validation. Validate "
        "again to compare the lines on it."
    ),
    "validation.other_lines": N_(
        "The validation plane {plane} has points on different lines before and after the "
        "calibration (lines in one of the two states only: {lines:names}). Give points of the "
        "same lines for both states."
    ),
    "validation.shape_before": N_(
        "The array of the points of {plane} on line {line} (before the calibration) has the shape "
        "{shape}, but (n, 3) is required. Correct it."
    ),
    "validation.shape_after": N_(
        "The array of the points of {plane} on line {line} (after the calibration) has the shape "
        "{shape}, but (n, 3) is required. Correct it."
    ),
    "validation.not_finite_before": N_(
        "Points of {plane} on line {line} (before the calibration) have coordinates that are NaN "
        "or infinite. Remove these points from both states."
    ),
    "validation.not_finite_after": N_(
        "Points of {plane} on line {line} (after the calibration) have coordinates that are NaN "
        "or infinite. Remove these points from both states."
    ),
    "validation.other_points": N_(
        "Line {line} has {before:n} points on {plane} before the calibration and {after:n} after "
        "it. Give the same points for both states."
    ),
    "validation.no_heading": N_(
        "The heading of line {line}, which has points on {plane}, is not given. Give the heading."
    ),
    # -- repeatability -----------------------------------------------------------------------------
    "validation.repeatability_values": N_(
        "{name}: a calibration must have three angles and their covariance matrix to be compared. "
        "Give all of them."
    ),
    "validation.repeatability_covariance": N_(
        "{name}: the covariance matrix of the angles is not valid (not positive definite), so "
        "this calibration cannot be compared. Correct the matrix."
    ),
    "validation.repeatability_few": N_(
        "Repeatability is computed from at least two calibrations of the same mounting. Add a "
        "calibration."
    ),
    # -- patch test --------------------------------------------------------------------------------
    "patch_test.no_pairs": N_(
        "No object is covered by two of the selected lines. Select objects that both lines of a "
        "pair cover."
    ),
    "patch_test.no_roll": N_(
        "The selected objects and line pairs do not determine roll. Add objects with other "
        "orientations, or lines in other directions."
    ),
    "patch_test.no_pitch": N_(
        "The selected objects and line pairs do not determine pitch. Add objects with other "
        "orientations, or lines in other directions."
    ),
    "patch_test.no_yaw": N_(
        "The selected objects and line pairs do not determine yaw. Add objects with other "
        "orientations, or lines in other directions."
    ),
    "patch_test.box_not_finite": N_(
        "{name}: the centre or rotation of the box contains NaN or infinity. Correct it."
    ),
    "patch_test.box_size": N_(
        "{name}: each side of the box must be from {least:m} to {most:m} m. Correct it."
    ),
    "patch_test.basis": Plural(
        "The result is based on {count:n} object and {lines:n} lines.",
        "The result is based on {count:n} objects and {lines:n} lines.",
    ),
    "patch_test.mismatch_reduced": N_(
        "The calibration reduces the mismatch between lines from {before:mm.1} mm (prior "
        "boresight) to {after:mm.1} mm. The mismatch is a robust RMS distance, on which distances "
        "above {limit:mm.0} mm have little influence."
    ),
    "patch_test.mismatch": N_(
        "The mismatch between lines after the calibration is {after:mm.1} mm (robust RMS, little "
        "influence of distances above {limit:mm.0} mm). With the prior boresight the lines do not "
        "overlap at the objects."
    ),
    "patch_test.no_sigma": Plural(
        "No standard deviations are computed, because the result is based on only {count:n} "
        "object. At least {needed:n} objects are needed.",
        "No standard deviations are computed, because the result is based on only {count:n} "
        "objects. At least {needed:n} objects are needed.",
    ),
    "patch_test.not_converged": N_(
        "The patch test did not converge: the angles were still changing at the last iteration."
    ),
    "patch_test.order_matters": N_(
        "Determined one after another instead of together, the angles differ: {angle} changes by "
        "{difference:deg.4}°."
    ),
    "patch_test.object_disagrees": N_(
        "Object {object} disagrees with the other objects: alone, it gives a {angle} that differs "
        "by {difference:deg.4+}° (up to {usual:deg.4}° is usual)."
    ),
    "patch_test.not_met": N_("No two of the lines overlap at these objects: {objects:names}."),
    # -- targetless --------------------------------------------------------------------------------
    "targetless.basis": N_(
        "The result is based on {used:n} of {total:n} natural surfaces that several lines cover. "
        "Matching iterations: {rounds:n}."
    ),
    "targetless.with_targets": N_(
        "Targets adjusted together with the natural surfaces: {targets:n}."
    ),
    "targetless.not_converged": N_(
        "The matching did not converge: in the last iteration the angles still changed by more "
        "than {share:percent.0} % of their standard deviations."
    ),
    "targetless.lines_disagree": N_("Lines that disagree with the others: {lines:names}."),
    "targetless.kept": Plural(
        "The project had no targets of its own. The result is now its boresight, and the natural "
        "surface is its target.",
        "The project had no targets of its own. The result is now its boresight, and the {count:n} "
        "natural surfaces are its targets.",
    ),
    "targetless.kept_beside": N_(
        "The project has targets of its own, so the result was saved as that of an alternative "
        "method. To make it the boresight of the project, exclude the targets and run the "
        "targetless method again."
    ),
    # -- methods -----------------------------------------------------------------------------------
    "method.targets": N_("targets"),
    "method.natural_planes": N_("natural planes"),
    "method.targetless": N_("targetless method"),
    "method.patch_test": N_("patch test"),
    "method.correspondences": N_("point correspondences"),
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
        "All methods use the same lines and share their trajectory errors, so agreement is no "
        "proof of accuracy. A significant difference does indicate an error, because its standard "
        "deviation tends to be too large."
    ),
    # -- reference ---------------------------------------------------------------------------------
    "absolute.after_nearer": N_(
        "After the calibration the lines are on average {mean:mm.1} mm (± {interval:mm.1} mm, 95 "
        "%) nearer to the vessel than the reference. {finding}"
    ),
    "absolute.after_farther": N_(
        "After the calibration the lines are on average {mean:mm.1} mm (± {interval:mm.1} mm, 95 "
        "%) farther from the vessel than the reference. {finding}"
    ),
    "absolute.before_nearer": N_(
        "Before the calibration the lines were on average {mean:mm.1} mm nearer to the vessel than "
        "the reference (± {interval:mm.1} mm, 95 %, without the uncertainty of the prior "
        "boresight). {finding}"
    ),
    "absolute.before_farther": N_(
        "Before the calibration the lines were on average {mean:mm.1} mm farther from the vessel "
        "than the reference (± {interval:mm.1} mm, 95 %, without the uncertainty of the prior "
        "boresight). {finding}"
    ),
    "absolute.explained": N_(
        "The uncertainties of reference, POS and boresight explain this difference."
    ),
    "absolute.not_explained": N_(
        "The uncertainties of reference, POS and boresight do not explain this difference."
    ),
    "absolute.explained_before": N_(
        "The uncertainties of reference and POS explain this difference."
    ),
    "absolute.not_explained_before": N_(
        "The uncertainties of reference and POS do not explain this difference."
    ),
    "absolute.no_line_off": N_(
        "After the calibration no single line deviates from the reference by more than its "
        "uncertainty explains."
    ),
    "absolute.rms": N_(
        "The RMS of all distances to the reference is {before:mm.1} mm before and {after:mm.1} mm "
        "after the calibration. The uncertainty of the reference ({reference:mm.1} mm) explains "
        "{share:percent.0} % of the RMS after it; {expected:mm.1} mm are expected from reference, "
        "POS and boresight together."
    ),
    "absolute.other_surface": N_(
        "Another surface lies within {distance:m} m of the reference: {lines:names}. The nearest "
        "surface is used, which is the wrong one if a line is displaced by more than half the "
        "distance between the two."
    ),
    "absolute.former_version": Advised(
        N_(
            "This check was made by an earlier version, and its result is wrong where a wall "
            "stands behind the reference."
        ),
        N_("Repeat the check."),
    ),
    "absolute.scan_error": N_(
        "The standard deviation of the reference is treated as one error common to all points of "
        "the scan, such as a registration error. The noise of individual points averages out."
    ),
    "absolute.point_errors": N_("The errors of the surveyed points are treated as independent."),
    "absolute.lines_alike": N_(
        "In the mean and RMS over all lines each line has the same weight, because all points of a "
        "line share its POS error. Medians and percentiles are computed from all distances."
    ),
    # -- surface of a line -------------------------------------------------------------------------
    "surface.nearest_point": N_("nearest point"),
    "surface.plane": N_("local plane through {count:n} points"),
    "surface.plane_within": N_("local plane through the points within {radius:m} m"),
    "surface.quadric": N_("local quadric through {count:n} points"),
    "surface.quadric_within": N_("local quadric through the points within {radius:m} m"),
}
