"""Texts of messages about picking targets, estimating the boresight, and alternative methods."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- estimate ------------------------------------------------------------------------------
    "estimate.needed": N_(
        "{project}: the boresight angles have not been estimated. Run Estimate first."
    ),
    "estimate.no_common_target": N_(
        "No target is observed on two lines ({targets:names}), so the lines cannot be compared. "
        "Set a seed for each target on other lines too."
    ),
    "estimate.no_target": N_("{project}: there is no target to adjust. Pick planar targets first."),
    "estimate.one_line": N_(
        "All targets are observed on line {line} only, and a single line does not determine the "
        "boresight. Add lines in other directions over the same targets, or import surveyed "
        "control of them."
    ),
    "estimate.no_common_part": N_(
        "The lines cover different areas of every target ({targets:names}), and these areas are "
        "not flat enough to form one plane. Set seeds on surfaces that several lines cover."
    ),
    "estimate.possible_cause": N_("{reason} Possible cause: {cause}"),
    "estimate.point_spacing": N_(
        "Each point spacing must be zero or more, in metres. Give at least one; 0 means all points."
    ),
    "estimate.lever_arm_sigma": N_(
        "The standard deviations of the lever arm must be zero or more. Correct them."
    ),
    "estimate.few_validation_planes": N_(
        "{project}: at least two validation planes that are observed on two lines are needed. Pick "
        "more validation planes, with different orientations."
    ),
    "estimate.patch_test_without_sigma": N_(
        "The patch test result has no standard deviations, so it cannot be compared with other "
        "methods. Add objects, and run the patch test again for all three angles."
    ),
    # -- patch_test ----------------------------------------------------------------------------
    "patch_test.single_line": N_(
        "{project}: the project has only one line, so lines cannot be compared. Add lines in other "
        "directions over the same scene."
    ),
    "patch_test.nothing_shared": N_(
        "{project}: no flat surface is covered by two lines. Draw boxes around objects that two "
        "lines cover."
    ),
    # -- correspondences -----------------------------------------------------------------------
    "correspondences.columns": N_(
        "{file}, row {row:n}: the row has {found:n} columns, but point correspondences have 8: two "
        "times, then x, y, z of both points. Export them again as t_i t_j x_i y_i z_i x_j y_j z_j."
    ),
    "correspondences.outside": N_(
        "{file}: {count:n} of {total:n} pairs have no position of the trajectory at one of their "
        "times ({first:s} to {last:s} s; trajectory {start:s} to {end:s} s). Convert the times to "
        "the time base of the trajectory."
    ),
    "correspondences.few": Plural(
        "There is only {count:n} usable pair of points, and {least:n} are needed. Add pairs.",
        "There are only {count:n} usable pairs of points, and {least:n} are needed. Add pairs.",
    ),
    "correspondences.most_rejected": N_(
        "{rejected:n} of {count:n} pairs of points disagree with the others, so no boresight was "
        "estimated. Check the frame and the times of the pairs, the lever arm and the given noise."
    ),
    "correspondences.not_converged": N_(
        "The adjustment of the point correspondences did not converge in {iterations:n} "
        "iterations. Check the frame and the times of the pairs."
    ),
    "correspondences.undetermined": N_(
        "The point correspondences do not determine {angles:names}. Add pairs between lines in "
        "other directions."
    ),
    "correspondences.noise_range": N_(
        "The noise of the pairs must be from {low:mm} to {high:mm} mm. Correct it."
    ),
    "correspondences.basis": Plural(
        "{used:n} of {count:n} pair of points was used, between {lines:n} lines.",
        "{used:n} of {count:n} pairs of points were used, between {lines:n} lines.",
    ),
    "correspondences.noise": N_(
        "Noise of a coordinate difference of a pair, estimated from the residuals: {noise:mm.1} "
        "mm. Errors that neighbouring pairs have in common are not part of it, so that the "
        "standard deviations may be too small if the matching has such errors."
    ),
    "correspondences.noise_too_small": N_(
        "The residuals of the point correspondences are {ratio:x.2} times as large as the given "
        "noise, {noise:mm.1} mm, so that the standard deviations are too small. Estimate the "
        "noise, or give a larger one."
    ),
    "correspondences.distance": N_(
        "RMS distance of the points of a pair: {before:mm.1} mm with the prior boresight, "
        "{after:mm.1} mm with the result; POS errors not removed."
    ),
    "correspondences.not_used": N_(
        "{count:n} of {total:n} pairs of {file} were not used: {outside:n} without a position of "
        "the trajectory, {repeated:n} repeated, {origin:n} with a point at the scanner."
    ),
    # -- targetless ----------------------------------------------------------------------------
    "targetless.single_line": N_(
        "{project}: the project has only one line, so lines cannot be compared. Add lines in other "
        "directions over the same scene."
    ),
    "targetless.undetermined": N_(
        "{project}: the surfaces of the scene and these lines do not determine the boresight "
        "angles (not determined: {direction}): {reason} Add lines in other directions over the "
        "same scene, or put up boards with other orientations."
    ),
    "targetless.no_result": N_(
        "{project}: the adjustment of the surfaces of the scene has no result: {reason} Check the "
        "prior boresight and the trajectory of each line, add lines in other directions, or put up "
        "boards."
    ),
    "targetless.few_surfaces": Plural(
        "{project}: only {count:n} flat surface is covered by several lines, and at least "
        "{least:n} are needed. Add overlapping lines, or put up targets.",
        "{project}: only {count:n} flat surfaces are covered by several lines, and at least "
        "{least:n} are needed. Add overlapping lines, or put up targets.",
    ),
    "targetless.name_taken": Plural(
        "The natural surfaces are named N001, N002 and so on, and there is already a target named "
        "{names:names}. Give it another name.",
        "The natural surfaces are named N001, N002 and so on, and there are already targets named "
        "{names:names}. Give them other names.",
    ),
    "targetless.no_target": N_(
        "{project}: there is no target to adjust together with the natural surfaces. Pick a "
        "target, or run the targetless method without targets."
    ),
    # -- pick ----------------------------------------------------------------------------------
    "pick.points_changed": N_(
        "{target}: its points on {line} were picked in another file, or the trajectory now covers "
        "other points of the file. Restore the file, or pick the target again."
    ),
    "pick.no_such_point": N_(
        "{name}: there is no point {number:n} on {line}; its points are numbered from 0 to "
        "{last:n}. Correct the number."
    ),
    "pick.no_line_plane": N_(
        "There is no line in which to search for a plane. Import a line first."
    ),
    "pick.no_line_sphere": N_(
        "There is no line in which to search for a sphere. Import a line first."
    ),
    "pick.is_target": N_(
        "{project}: there is already a target named {target}. Pick it as a target again, or give "
        "the validation plane another name."
    ),
    "pick.is_validation_plane": N_(
        "{project}: there is already a validation plane named {target}. Pick it as a validation "
        "plane again, or give the target another name."
    ),
    "pick.is_plane": N_(
        "There is already a plane named {target}. Pick it as a plane again, or give the sphere "
        "another name."
    ),
    "pick.is_sphere": N_(
        "There is already a sphere named {target}. Pick it as a sphere again, or give the plane "
        "another name."
    ),
    "pick.radius_unknown": N_(
        "There is already a sphere of unknown radius named {target}. Pick it without a radius, or "
        "give the new sphere another name."
    ),
    "pick.other_radius": N_(
        "There is already a sphere named {target} with a radius of {radius:m} m. Pick it with the "
        "same radius, or give the new sphere another name."
    ),
    "pick.name_taken": N_(
        "{file}, row {row:n}: the project already has a target named {target}. Give it another "
        "name in the list, or choose to replace the target of the project."
    ),
    "pick.none_found": Plural(
        "{file}: no target was found at the seed. {target} (row {row:n}): {reason}",
        "{file}: no target was found at any of the {count:n} seeds. {target} (row {row:n}): "
        "{reason}",
    ),
    "pick.some_not_found": Plural(
        "{file}: no target was found at {count:n} of the {total:n} seeds (reason in the table): "
        "{seeds:names} (row {rows:names}). The targets found at the other seeds are saved; set "
        "the missing seeds again.",
        "{file}: no target was found at {count:n} of the {total:n} seeds (reasons in the table): "
        "{seeds:names} (rows {rows:names}). The targets found at the other seeds are saved; set "
        "the missing seeds again.",
    ),
    "pick.too_many_numbers": N_(
        "The list of point numbers has more than {limit:n} points. Correct it."
    ),
    "pick.not_a_number": N_(
        "The list of point numbers contains '{text}', which is neither a point number nor a range "
        "such as 12+40 (first number + count). Correct it."
    ),
    # -- edit ----------------------------------------------------------------------------------
    "edit.few_points_left": Plural(
        "Only {count:n} point of {target} would be left on {line}. To exclude the sighting, clear "
        "its check box in the table.",
        "Only {count:n} points of {target} would be left on {line}. To exclude the sighting, "
        "clear its check box in the table.",
    ),
    "edit.no_surface_left": N_(
        "{target}: the remaining points do not form a plane or a sphere. {reason}"
    ),
    "edit.no_name": N_(
        "A target must have a name, so target {target} keeps its present name. Enter a name."
    ),
    "edit.name_taken": N_("There is already a target named {name}. Give {target} another name."),
    # -- section -------------------------------------------------------------------------------
    "section.no_points": N_(
        "{target} has no points on any line, so no cross-section can be drawn. Pick the target "
        "first."
    ),
    # -- propose -------------------------------------------------------------------------------
    "propose.few_flat_surfaces": Plural(
        "{project}: only {count:n} flat surface is observed on at least two lines, and two are "
        "needed ({uneven:n} other surfaces are not flat, {poor:n} are poorly observed). Set seeds "
        "on the targets, put up boards, or use the targetless method.",
        "{project}: only {count:n} flat surfaces are observed on at least two lines, and two are "
        "needed ({uneven:n} other surfaces are not flat, {poor:n} are poorly observed). Set seeds "
        "on the targets, put up boards, or use the targetless method.",
    ),
    "propose.undetermined": N_(
        "{project}: the flat surfaces found and these lines do not determine the boresight angles "
        "(not determined: {direction}): {reason} Add lines in other directions, put up boards with "
        "other orientations, or use the targetless method."
    ),
    "propose.no_result": N_(
        "{project}: the adjustment of the flat surfaces found has no result: {reason} Set seeds on "
        "the targets, put up boards, or use the targetless method."
    ),
    "propose.one_orientation": N_(
        "All flat surfaces found have the same orientation, so they do not determine the "
        "boresight. Put up a board with another tilt, or set seeds by hand."
    ),
    "propose.not_determined": N_(
        "No pair of the planes found determines the boresight. Put up a board with another tilt, "
        "or set seeds by hand."
    ),
    # -- error budget ------------------------------------------------------------------------------
    "budget.geometry": N_(
        "The table gives standard deviations of a point for a level vessel heading north, by "
        "distance from the scanner. The horizontal error and the error across the beam are root "
        "sums of squares over two directions."
    ),
    "budget.pos": N_(
        "POS errors are the median accuracies on the lines: {north:m.3}, {east:m.3}, {up:m.3} m "
        "(north, east, down) and {roll:deg.4}, {pitch:deg.4}, {heading:deg.4}° (roll, pitch, "
        "heading)."
    ),
    "budget.boresight": N_(
        '"Boresight before calibration" is the distance between points computed with the prior and '
        "with the estimated angles, not a standard deviation, so that the total before calibration "
        'is a root mean square error. "Boresight after calibration" is computed from the '
        "covariance of the estimated angles."
    ),
    "budget.lidar_per_axis": N_(
        "The LiDAR noise has fixed values along x, y and z, so it does not grow with the distance. "
        "Noise given in range and beam angle would grow with the distance."
    ),
    "budget.footprint": N_(
        "The beam footprint is computed for a divergence of {divergence:x.2} mrad and an angle of "
        "incidence of {incidence:deg.0}°. Along the beam, it is proportional to the tangent of "
        "this angle."
    ),
    "budget.footprint_unknown": N_(
        "The beam footprint is not included, because the beam divergence is not given."
    ),
    "budget.lever_arm_estimated": N_(
        "Only the components of the lever arm that are estimated or have a standard deviation are "
        "included."
    ),
    "budget.lever_arm_unknown": N_(
        "The uncertainty of the lever arm is not included, because it is not given."
    ),
    "budget.latency": N_(
        "The latency error is computed for the speed of the lines, {speed:x.1} m/s, and their RMS "
        "rotation rates, {roll:deg.2}, {pitch:deg.2}, {heading:deg.2}°/s (roll, pitch, heading)."
    ),
    "budget.no_latency": N_(
        "The latency error is not included, because the latency was not estimated."
    ),
    # -- reasons for proposed targets ------------------------------------------------------
    "propose.check_movable": N_(
        "Check that no proposed surface is on a movable object (crane, moored vessel, gate)."
    ),
    "propose.target": N_(
        "Observed on {lines:n} lines. Without this target the standard deviation of {angle} would "
        "be {without:deg.4}° instead of {sigma:deg.4}°."
    ),
    "propose.target_checks": N_(
        "Observed on {lines:n} lines. It checks the other targets; without it the standard "
        "deviations of the angles would increase by less than {share:percent.0} %."
    ),
    "propose.target_needed": N_(
        "Observed on {lines:n} lines. Without this target the angles are not determined."
    ),
    "propose.target_oblique": N_(
        "{target} The beams are oblique on {lines:names}, up to {angle:deg.0}° from the normal."
    ),
    "propose.validation_plane": N_(
        "On a plane of {area:x.1} m² in total, at a height of {height:m.0} m, observed on "
        "{lines:n} lines."
    ),
    "propose.validation_plane_reciprocal": N_(
        "On a plane of {area:x.1} m² in total, at a height of {height:m.0} m, observed on "
        "{lines:n} lines, including reciprocal lines."
    ),
    "propose.validation_plane_poor": N_("{plane} Poorly observed on {lines:names}: {reason}"),
}
