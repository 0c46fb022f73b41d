"""Texts of messages about the adjustment."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- observations ------------------------------------------------------------------------------
    "adjustment.no_targets": N_("There is no target to adjust. Pick targets first."),
    "adjustment.few_points": Plural(
        "Target {target} has only {count:n} point on line {line}, but at least three are needed. "
        "Pick the target again, or exclude the line.",
        "Target {target} has only {count:n} points on line {line}, but at least three are needed. "
        "Pick the target again, or exclude the line.",
    ),
    "adjustment.point_not_finite": N_(
        "The coordinates of a point contain NaN or infinity. Exclude the point."
    ),
    "adjustment.position_not_finite": N_(
        "The POS position at the time of a point contains NaN or infinity. Exclude the point."
    ),
    "adjustment.attitude_not_finite": N_(
        "The POS attitude at the time of a point contains NaN or infinity. Exclude the point."
    ),
    "adjustment.time_not_finite": N_("The time of a point is NaN or infinite. Exclude the point."),
    "adjustment.point_in_scanner": N_(
        "A point lies at the origin of the scanner. Exclude the point."
    ),
    "adjustment.sigma_lidar": N_(
        "A standard deviation of the LiDAR is negative, NaN or infinite. Correct it."
    ),
    "adjustment.sigma_position": N_(
        "A standard deviation of the position is negative, NaN or infinite. Correct it."
    ),
    "adjustment.sigma_attitude": N_(
        "A standard deviation of the attitude is negative, NaN or infinite. Correct it."
    ),
    "adjustment.sigma_lidar_zero": N_(
        "The standard deviation of the LiDAR must be above zero. Correct it."
    ),
    "adjustment.budget_distances": N_(
        "The distances of the error budget must be in metres and above zero. Correct them."
    ),
    "adjustment.budget_divergence": N_(
        "The beam divergence must be from 0 to {most:x.0} mrad. Correct it."
    ),
    "adjustment.budget_incidence": N_(
        "The angle of incidence must be from 0 to {most:deg.0}°. Correct it."
    ),
    # -- geometry ----------------------------------------------------------------------------------
    "adjustment.singular": N_(
        "The points do not determine the boresight angles and the targets. Add targets or lines."
    ),
    "adjustment.shape_undetermined": N_(
        "The points of a target do not determine its shape. Pick points that are spread over it in "
        "two directions."
    ),
    "adjustment.one_line": N_(
        "All targets are observed on line {line} only, and a single line does not determine the "
        "boresight. Add lines in other directions over the same targets, or import surveyed "
        "control of them."
    ),
    "adjustment.undetermined": N_(
        "These lines and targets do not determine the boresight angles (not determined: "
        "{direction}). {action}"
    ),
    "adjustment.undetermined_because": N_(
        "These lines and targets do not determine the boresight angles (not determined: "
        "{direction}): {reason} {action}"
    ),
    "adjustment.angle_roll": N_("roll"),
    "adjustment.angle_pitch": N_("pitch"),
    "adjustment.angle_yaw": N_("yaw"),
    "adjustment.angle_with_one": N_("a combination of {first} and {second}"),
    "adjustment.angle_with_two": N_("a combination of {first}, {second} and {third}"),
    "adjustment.parallel_lines": N_("All lines are parallel."),
    "adjustment.few_directions": N_(
        "The lines and the surfaces have too few different directions."
    ),
    "adjustment.single_line": N_("{line} is the only line."),
    "adjustment.single_target": N_("{target} is the only target."),
    "adjustment.one_orientation": N_("All targets have the same orientation."),
    "adjustment.parallel_lines_one_target": N_(
        "All lines are parallel, and {target} is the only target."
    ),
    "adjustment.parallel_lines_one_orientation": N_(
        "All lines are parallel, and all targets have the same orientation."
    ),
    "adjustment.add_target": N_(
        "Add another target, or lines in other directions. With a vertical target, lines parallel "
        "to it determine roll, and lines at 45° to it determine pitch and yaw."
    ),
    "adjustment.add_orientation": N_(
        "Add a target with a different orientation, or lines in other directions. With a vertical "
        "target, lines parallel to it determine roll, and lines at 45° to it determine pitch "
        "and yaw."
    ),
    "adjustment.only_plane": N_(
        "The plane {target} is the only target, so only the different headings of the lines "
        "separate the angles. Add a target with a different orientation or a sphere; if there is "
        "none, use the setting Accept a single orientation (Estimate, Advanced)."
    ),
    "adjustment.parallel_planes": N_(
        "All targets are planes of the same orientation, so only the different headings of the "
        "lines separate the angles. Add a target with a different orientation or a sphere; if "
        "there is none, use the setting Accept a single orientation (Estimate, Advanced)."
    ),
    "adjustment.orientations_lost": N_(
        "No boresight fits the targets: the adjustment made all of them parallel by turning the "
        "boresight by {change:deg.1}°, but {first} and {second} differ by {angle:deg.0}° on single "
        "lines. Check the lever arm and the prior boresight, and that each target is the same "
        "surface on every line."
    ),
    "adjustment.refused_after_rejection": Plural(
        "One of {total:n} sightings was rejected because it disagrees with the others "
        "({sightings:names}). Without it: {reason}",
        "{count:n} of {total:n} sightings were rejected because they disagree with the others "
        "({sightings:names}). Without them: {reason}",
    ),
    "adjustment.refused_after_exclusion": Plural(
        "One of {total:n} targets was excluded because no point of it agrees with the others "
        "({targets:names}). Without it: {reason}",
        "{count:n} of {total:n} targets were excluded because no point of them agrees with "
        "the others ({targets:names}). Without them: {reason}",
    ),
    # -- iterations --------------------------------------------------------------------------------
    "adjustment.not_converged": N_(
        "The adjustment did not converge in {iterations:n} iterations (last change: {angles:deg}°"
        " in the angles, {rest:mm} mm in the other parameters). Check that each target is the "
        "same surface on every line, and check the prior boresight."
    ),
    "adjustment.diverged": N_(
        "The adjustment diverged. Check that each target is the same surface on every line, and "
        "check the prior boresight."
    ),
    "adjustment.target_disagrees": N_(
        "No point of target {target} agrees with the other targets and lines. Pick the target "
        "again, or exclude it."
    ),
    # -- values that the data contradict -----------------------------------------------------------
    "adjustment.contradicts_lever_arm": N_(
        "The best-fitting {axis} component of the lever arm differs by {change:m.4+} m from the "
        "given one, with which the boresight is not determined. Measure the lever arm again, or "
        "estimate it."
    ),
    "adjustment.contradicts_range_offset": N_(
        "The best-fitting range offset differs by {change:m.4+} m from the given one, with which "
        "the boresight is not determined. Measure the range offset again, or estimate it."
    ),
    "adjustment.contradicts_scan_angle_offset": N_(
        "The best-fitting scan-angle offset differs by {change:deg.4+}° from the given one, "
        "with which the boresight is not determined. Measure the scan-angle offset again, or "
        "estimate it."
    ),
    "adjustment.contradicts_latency": N_(
        "The best-fitting latency differs by {change:ms.2+} ms from the given one, with which the "
        "boresight is not determined. Measure the latency again, or estimate it."
    ),
    # -- observability -----------------------------------------------------------------------------
    "observability.directions": N_(
        "Least precisely determined: {weakest}, with a standard deviation of {weakest_sigma:deg.4}°"
        ". Most precisely determined: {strongest}, with {strongest_sigma:deg.4}°."
    ),
    "observability.main_lines": Plural(
        "Line {lines:names} contributes most to the determination of {angle}. Without line "
        "{line}, the standard deviation of {angle} is {without:deg.4}° instead of {sigma:deg.4}°"
        ".",
        "Lines {lines:names} contribute most to the determination of {angle}. Without line "
        "{line}, the standard deviation of {angle} is {without:deg.4}° instead of {sigma:deg.4}°"
        ".",
    ),
    "observability.largest_increases": N_(
        "Largest increases of the standard deviations if any one line is omitted: {angles:names}."
    ),
    "observability.one_sphere": Advised(
        N_("{target} is the only target, so its deformation or displacement cannot be detected."),
        N_("Add another target."),
    ),
    # -- values that are not estimated -------------------------------------------------------------
    "parameter.rotates_like_boresight": N_(
        "These lines and targets do not determine the {parameter}: it rotates the points about the "
        "scanner axis, as the boresight does. {kept}"
    ),
    "parameter.raises_all_lines": N_(
        "These lines and targets do not determine the {parameter}: on level lines it shifts the "
        "points of all lines vertically by the same amount. {kept}"
    ),
    "parameter.not_separated": N_(
        "These lines and targets do not determine the {parameter}: its effect cannot be separated "
        "from the effect of the {other} or of the target positions. {kept}"
    ),
    "parameter.kept": N_("The given value is used."),
    "parameter.kept_uncertain": N_(
        "The given value is used, and its uncertainty is included in the standard deviations of "
        "the angles."
    ),
    "parameter.not_classical": Advised(
        N_(
            "The {parameter} would be wrong if estimated with uncorrelated POS errors, so the "
            "given value is used."
        ),
        N_("To estimate it, choose correlated POS errors."),
    ),
    # -- parts of the data -------------------------------------------------------------------------
    "cross_check.no_common_target": N_("None of the remaining targets is observed on two lines."),
    # -- variance components -----------------------------------------------------------------------
    "component.larger": N_("applied: larger than the a priori value"),
    "component.smaller": N_("applied: smaller than the a priori value"),
    "component.replaces_assumed": N_("applied: replaces the assumed value"),
    "component.confirms_assumed": N_("not applied: agrees with the assumed value"),
    "component.not_determined": N_("not applied: not determined by the data"),
    "component.as_given": N_("not applied: the a priori value lies within the interval"),
    "component.too_small": N_("not applied: the change is too small or poorly determined"),
}
