"""Texts of warnings about targets and the result of an adjustment."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

_CONTRADICTED_TEXT = N_(
    "The given {parameter} disagrees with the data: the best-fitting value, {change} (± {sigma}, "
    "test value w = {w:x.1+}), would change {angles:names}. Measure the {parameter} again, or "
    "estimate it."
)
_CONTRADICTED_ALONE_TEXT = N_(
    "The given {parameter} disagrees with the data: the best-fitting value is {change} (± {sigma}, "
    "test value w = {w:x.1+}). Measure the {parameter} again, or estimate it."
)
"""Texts for a given value that the data contradict: with its effect on the angles, and without."""
_MOUNTING_PARAMETERS = (
    "lever_x",
    "lever_y",
    "lever_z",
    "range_offset",
    "scan_angle_offset",
    "latency",
)

TEXTS: Mapping[str, Template] = {
    # -- targets and files -------------------------------------------------------------------
    "targets.counted_twice": Plural(
        "Targets have points in common: {pairs:names}. These points count twice and make the "
        "standard deviations of the angles too small, so exclude one of the two.",
        "Targets have points in common: {pairs:names}. These points count twice and make the "
        "standard deviations of the angles too small, so exclude one target of each pair.",
    ),
    "targets.no_independent_check": Advised(
        Plural(
            "A validation plane has points in common with a target and does not check the angles "
            "independently: {pairs:names}.",
            "Validation planes have points in common with targets and do not check the angles "
            "independently: {pairs:names}.",
        ),
        Plural(
            "Exclude one of the two.",
            "Exclude one of each pair.",
        ),
    ),
    "targets.validation_in_plane": Advised(
        N_(
            "Validation plane {plane} lies in the plane of {targets:names}, so it checks the "
            "angles with other points, but in the same orientation."
        ),
        N_("Add a validation plane in another orientation."),
    ),
    "targets.single_line_targets": Advised(
        N_("Targets observed on one line only are excluded: {sightings:names}."),
        N_("Set seeds for them on other lines, or remove these targets."),
    ),
    "targets.proposal_unchecked": N_(
        "The proposed targets are too few or too close together to detect errors in the data. Use "
        "the targetless method, which adjusts many small surfaces, or put up boards."
    ),
    "targets.proposal_not_flat": Plural(
        "Too few flat surfaces remain without target {targets:names}, which is therefore proposed "
        "although it is probably not flat. Use the targetless method, which adjusts many small "
        "surfaces, or put up boards.",
        "Too few flat surfaces remain without targets {targets:names}, which are therefore "
        "proposed although they are probably not flat. Use the targetless method, which adjusts "
        "many small surfaces, or put up boards.",
    ),
    "targets.no_validation_plane": N_(
        "No flat surface besides the targets can be compared between lines, so no validation "
        "plane is proposed. Pick a flat surface that two lines cover, or put up boards."
    ),
    "targets.sigma_below_prediction": N_(
        "Standard deviations of the result are more than {limit:percent.0} % smaller than "
        "predicted when the targets were proposed ({angles:names}), and may be too small: they "
        "contain the noise and the form errors of the targets only. Check the residuals of the "
        "targets, or use more targets and lines."
    ),
    "targets.sigma_above_prediction": Advised(
        N_(
            "Standard deviations are more than {limit:percent.0} % larger than predicted when the "
            "targets were proposed: {angles:names}."
        ),
        N_("For a higher precision, use more targets or lines."),
    ),
    "data.same_on_lines": N_("{reason} The same warning applies to {lines:names}."),
    # -- angles ------------------------------------------------------------------------------
    "adjustment.independent_pos_errors": N_(
        "The adjustment assumes uncorrelated POS errors (classical), which makes the standard "
        "deviations of the angles several times too small. Choose correlated POS errors."
    ),
    "adjustment.estimated_lever_arm_differs": N_(
        "The estimated {parameter} differs from the given one: it is {change} (± {sigma}). The "
        "angles are valid only with the estimated value, so correct the given one, or measure it "
        "again."
    ),
    "adjustment.large_sigma": N_(
        "Standard deviations are large (1 sigma): {angles:names}. Add targets with other "
        "orientations, or lines in other directions."
    ),
    "adjustment.large_sigma_unseen": N_(
        "Standard deviations are large (1 sigma: {angles:names}), because these lines and targets "
        "do not determine some given values: {parameters:names}. Give smaller standard deviations "
        "for these values, or do not estimate them."
    ),
    "adjustment.one_target": Advised(
        N_(
            "{target} is the only target, so only the headings of the lines separate the angles, "
            "and its deformation or displacement cannot be detected."
        ),
        N_("Add a target with another orientation."),
    ),
    "adjustment.one_facing": Advised(
        N_(
            "All targets are nearly parallel, so the angles are separated only by the different "
            "headings of the lines."
        ),
        N_("Add a target with another orientation."),
    ),
    "adjustment.high_correlation": Advised(
        N_(
            "The correlation of {first} and {second} is {correlation:x.2+}, so they can hardly be "
            "separated."
        ),
        N_("Add a target with another orientation, or lines in other directions."),
    ),
    "adjustment.high_correlation_parameter": Advised(
        N_(
            "The correlation of {first} and {second} is {correlation:x.2+}, so they can hardly be "
            "separated."
        ),
        N_("Give the standard deviation of the prior {second}, or do not estimate it."),
    ),
    "adjustment.steep_pitch": N_(
        "The boresight pitch exceeds 60°, so roll and yaw can hardly be separated; the standard "
        "deviations are those of small rotations about the body axes. Use the rotation matrix "
        "instead of the three angles."
    ),
    "adjustment.surface_held": Advised(
        N_(
            "The form error of the targets is fixed at 0, so the sightings are not tested against "
            "each other."
        ),
        N_("Estimate the form error from the data to test them."),
    ),
    "adjustment.surfaces_differ": Advised(
        N_(
            "The shapes of the targets differ between lines by {sigma:mm.1} mm (1 sigma), more "
            "than the standard deviations used explain."
        ),
        N_("Check for rough or bent targets, and for errors that are not in the error model."),
    ),
    "adjustment.surfaces_displaced": Advised(
        N_(
            "The targets are displaced by {offset:mm.1} mm and tilted by {tilt:mm.1} mm between "
            "lines (1 sigma), more than the standard deviations used explain."
        ),
        N_("Check whether targets moved, and check for errors that are not in the error model."),
    ),
    "adjustment.shorter_times": N_(
        "With correlation times of the POS errors of {position:s} s (position) and {attitude:s} s "
        "(attitude), the residuals fail the chi-square test. Angles and standard deviations are "
        "computed with {used_position:s} s and {used_attitude:s} s, with which they pass it."
    ),
    "adjustment.shorter_times_sigmas": N_(
        "With correlation times of the POS errors of {position:s} s (position) and {attitude:s} s "
        "(attitude), the residuals fail the chi-square test. They pass it with {used_position:s} s "
        "and {used_attitude:s} s, which are used and change the standard deviations: "
        "{angles:names}."
    ),
    "adjustment.sigmas_raised": N_(
        "Taken together, the angles computed from subsets of the data scatter more than the error "
        "model predicts, even if each of them agrees. The standard deviations were increased and "
        "are given with the result: {angles:names}."
    ),
    "adjustment.lever_arm_uncertainty": Advised(
        N_(
            "The standard deviation of the given lever arm ({x:mm.0}, {y:mm.0}, {z:mm.0} mm) "
            "increases those of the angles: {angles:names}."
        ),
        N_("Measure it more precisely, or estimate it."),
    ),
    "adjustment.sigmas_raised_conservative": N_(
        "The residuals are smaller than the standard deviations used predict, but angles computed "
        "from subsets of the data scatter more. The standard deviations were therefore increased "
        "and are given with the result: {angles:names}."
    ),
    "adjustment.lidar_noise": Advised(
        N_(
            "The residuals show a LiDAR noise of {measured:mm.2} mm (1 sigma) instead of the "
            "{given:mm.2} mm used."
        ),
        N_("Use the noise of the residuals and estimate again."),
    ),
    "adjustment.lidar_noise_ratio": Advised(
        N_("The residuals show a LiDAR noise of {ratio:x.2} times the one used."),
        N_("Use the noise of the residuals and estimate again."),
    ),
    "adjustment.lidar_noise_conservative": Advised(
        N_(
            "The residuals show a LiDAR noise of {measured:mm.2} mm (1 sigma), less than the "
            "{given:mm.2} mm with which the standard deviations of the angles are computed."
        ),
        N_("Use the noise of the residuals and estimate again."),
    ),
    "adjustment.lidar_noise_ratio_conservative": Advised(
        N_(
            "The residuals show a LiDAR noise of {ratio:x.2} times the one with which the "
            "standard deviations of the angles are computed."
        ),
        N_("Use the noise of the residuals and estimate again."),
    ),
    "adjustment.lidar_noise_assumed": Advised(
        N_(
            "The residuals show a LiDAR noise of {measured:mm.2} mm (1 sigma); no value was given, "
            "and {given:mm.2} mm was assumed."
        ),
        N_("Use the noise of the residuals and estimate again."),
    ),
    "adjustment.lidar_noise_assumed_conservative": Advised(
        N_(
            "The residuals show a LiDAR noise of {measured:mm.2} mm (1 sigma), less than the "
            "assumed {given:mm.2} mm with which the standard deviations of the angles are computed."
        ),
        N_("Use the noise of the residuals and estimate again."),
    ),
    "adjustment.assumed_sigmas": Advised(
        N_(
            "Standard deviations are assumed values that could not be replaced by estimates from "
            "the data: {groups:names}."
        ),
        N_("Enter the values of the data sheet or of the processing report in step 1."),
    ),
    "adjustment.cross_check": Advised(
        N_("Angles computed from subsets of the data differ significantly: {parts:names}."),
        N_("Compare these angles under Cross-checks."),
    ),
    "adjustment.cross_check_uncovered": N_(
        "Angles computed from subsets of the data differ by more than their standard deviations "
        "explain: {parts:names}. Check these observations under Cross-checks, or add "
        "lines and targets."
    ),
    "adjustment.refused_since": N_(
        "The last adjustment was not possible: {reason} The angles shown are those of the previous "
        "adjustment."
    ),
    # -- data that cannot be checked ---------------------------------------------------------
    "adjustment.line_unchecked": Plural(
        "Without line {lines:names} the angles are not determined, so errors of this line cannot "
        "be detected. Add lines.",
        "Without any one of the lines {lines:names} the angles are not determined, so errors of "
        "these lines cannot be detected. Add lines.",
    ),
    "adjustment.target_unchecked": Plural(
        "Without target {targets:names} the angles are not determined, so errors of this target "
        "cannot be detected. Add targets.",
        "Without any one of the targets {targets:names} the angles are not determined, so errors "
        "of these targets cannot be detected. Add targets.",
    ),
    "adjustment.targets_clustered": N_(
        "The targets extend over only {size:percent.0} % of their distance from the scanner, too "
        "little to detect errors of a line. Add targets at other places."
    ),
    "adjustment.targets_act_as_one": Plural(
        "Targets {targets:names} are so close together that they act as one target, on which "
        "alone {angles:names} depends. Add targets at other places.",
        "Targets {targets:names} are so close together that they act as one target, on which "
        "alone {angles:names} depend. Add targets at other places.",
    ),
    "adjustment.carried_by_one": N_(
        "Angles depend on single targets or sightings whose errors cannot be detected: "
        "{sightings:names}. Add targets or lines."
    ),
    # -- sightings, targets and points -------------------------------------------------------
    "adjustment.released": Advised(
        Plural(
            "A sighting disagrees with the others and was rejected: {sightings:names}.",
            "Some sightings disagree with the others and were rejected: {sightings:names}.",
        ),
        Plural(
            "Check its points and the trajectory at that time, or exclude the sighting if it is on "
            "another surface.",
            "Check their points and the trajectory at these times, or exclude sightings on another "
            "surface.",
        ),
    ),
    "adjustment.sighting_disagrees": Advised(
        Plural(
            "A sighting disagrees with the others but is used: {sightings:names}.",
            "Some sightings disagree with the others but are used: {sightings:names}.",
        ),
        Plural(
            "Check its points and the trajectory at that time.",
            "Check their points and the trajectory at these times.",
        ),
    ),
    "adjustment.control_contradicts": N_(
        "Control point {name} lies {shift:mm.1} mm (± {sigma:mm.1} mm, test value w = {w:x.1+}) "
        "from the surface of {target} that all other observations give. Check its coordinates and "
        "its name and that the target was not moved, or exclude the point and estimate again."
    ),
    "adjustment.control_translated": N_(
        "The control of {source} is displaced as a whole from all other observations: "
        "{components:names}. Check its coordinate system, height reference and epoch, or the lever "
        "arm of the POS, or exclude this control and estimate again."
    ),
    "adjustment.target_excluded": Advised(
        N_(
            "Targets were excluded because none of their points agrees with the other targets and "
            "lines: {targets:names}."
        ),
        N_("Pick these targets again, or remove them."),
    ),
    "adjustment.target_cut": Advised(
        N_(
            "The lines cover different areas of these targets, which may not be flat, so only the "
            "common area is used: {targets:names}."
        ),
        N_("Pick smaller targets."),
    ),
    "adjustment.target_parts": Advised(
        N_(
            "Targets were excluded because the lines cover different areas of them, and they may "
            "not be flat: {targets:names}."
        ),
        N_("Pick an area that two lines cover."),
    ),
    "adjustment.strays_full_weight": Advised(
        N_(
            "{count:n} of {points:n} points are outliers ({expected:n} expected by chance), most "
            "of them on {target}, line {line} ({here:n} of {sighting_points:n}), with full weight."
        ),
        N_("Choose a robust loss function."),
    ),
    "adjustment.strays_reduced_weight": N_(
        "{count:n} of {points:n} points are outliers ({expected:n} expected by chance), most of "
        "them on {target}, line {line} ({here:n} of {sighting_points:n}). They have less weight "
        "than other points."
    ),
    "adjustment.strays_no_weight": N_(
        "{count:n} of {points:n} points are outliers ({expected:n} expected by chance), most of "
        "them on {target}, line {line} ({here:n} of {sighting_points:n}). They have little or no "
        "weight."
    ),
    "adjustment.another_surface": Advised(
        Plural(
            "The points of target {targets:names} deviate from its surface by {factor:x.1} times "
            "the LiDAR noise and have little weight.",
            "The points of targets {targets:names} deviate from their surfaces by up to "
            "{factor:x.1} times the LiDAR noise and have little weight.",
        ),
        Plural(
            "Check whether the target is the same surface on all lines.",
            "Check whether each target is the same surface on all lines.",
        ),
    ),
    "adjustment.noise": Plural(
        "The residuals on {targets:names} indicate {factor:x.1} times the LiDAR noise used: the "
        "surface is rough or curved, or that LiDAR sigma is too small. The standard "
        "deviations of the angles are computed with the larger noise.",
        "The residuals on {targets:names} indicate up to {factor:x.1} times the LiDAR noise used: "
        "the surfaces are rough or curved, or that LiDAR sigma is too small. The standard "
        "deviations of the angles are computed with the larger noise.",
    ),
    "adjustment.not_flat": Plural(
        "Target {targets:names} is probably not flat (residuals {factor:x.1} times the given "
        "noise), so the errors of the angles may exceed their standard deviations. Add lines, or "
        "use flat targets.",
        "Targets {targets:names} are probably not flat (residuals up to {factor:x.1} times the "
        "given noise), so the errors of the angles may exceed their standard deviations. Add "
        "lines, or use flat targets.",
    ),
    "adjustment.signs_agree": N_(
        "The residuals confirm the signs of roll and pitch that the import assumed. With the "
        "opposite sign of roll, pitch or both, the residuals are at least {ratio:x.0} times as "
        "large, or the adjustment does not converge."
    ),
    "adjustment.radii_differ": N_(
        "The radius of sphere {target} differs between lines, from {smallest:mm.1} to "
        "{largest:mm.1} mm, and no single error explains it. Check the signs of the attitude, the "
        "latency and the points of the target."
    ),
    "adjustment.radii_roll_sign": N_(
        "The radius of sphere {target} differs between lines, from {smallest:mm.1} to "
        "{largest:mm.1} mm, but agrees with the opposite sign of roll. Check the sign convention "
        "of the file."
    ),
    "adjustment.radii_pitch_sign": N_(
        "The radius of sphere {target} differs between lines, from {smallest:mm.1} to "
        "{largest:mm.1} mm, but agrees with the opposite sign of pitch. Check the sign convention "
        "of the file."
    ),
    "adjustment.radii_roll_pitch_signs": N_(
        "The radius of sphere {target} differs between lines, from {smallest:mm.1} to "
        "{largest:mm.1} mm, but agrees with the opposite signs of roll and pitch. Check the sign "
        "convention of the file."
    ),
    "adjustment.radii_parameter": N_(
        "The radius of sphere {target} differs between lines, from {smallest:mm.1} to "
        "{largest:mm.1} mm, but agrees with one changed mounting parameter ({cause}). Measure this "
        "parameter again."
    ),
    "cause.wrong_roll_sign": Advised(
        N_(
            "Roll has the wrong sign: with the opposite sign the adjustment converges, and the "
            "residuals agree with the error model."
        ),
        N_("Check the sign convention of the trajectory file."),
    ),
    "cause.wrong_pitch_sign": Advised(
        N_(
            "Pitch has the wrong sign: with the opposite sign the adjustment converges, and the "
            "residuals agree with the error model."
        ),
        N_("Check the sign convention of the trajectory file."),
    ),
    "cause.wrong_roll_pitch_signs": Advised(
        N_(
            "Roll and pitch have the wrong signs: with the opposite signs the adjustment "
            "converges, and the residuals agree with the error model."
        ),
        N_("Check the sign convention of the trajectory file."),
    ),
    "cause.wrong_value": Advised(
        N_(
            "{change}, with which the adjustment converges and the residuals agree with the error "
            "model."
        ),
        N_("Measure this parameter again."),
    ),
    # -- causes of the residuals -------------------------------------------------------------
    "adjustment.explained_by_value": Advised(
        N_(
            "The given {parameter} causes most of the residuals, so that notes on residuals, "
            "sightings and differences between parts of the data are omitted."
        ),
        N_("Correct or estimate it, then estimate again."),
    ),
    **{f"adjustment.contradicted_{name}": _CONTRADICTED_TEXT for name in _MOUNTING_PARAMETERS},
    **{
        f"adjustment.contradicted_{name}_alone": _CONTRADICTED_ALONE_TEXT
        for name in _MOUNTING_PARAMETERS
    },
    "change.larger": N_("larger by {amount}"),
    "change.smaller": N_("smaller by {amount}"),
    "change.opposite_sign": N_("of the opposite sign, changed by {amount}"),
    "adjustment.cause_not_located": Advised(
        N_(
            "The residuals do not agree with the error model, and the lines are too few to "
            "separate these possible causes: {causes:names}."
        ),
        N_("Add lines."),
    ),
    "adjustment.cause_not_identified": Advised(
        N_(
            "The residuals do not agree with the error model, and the lines are too few to "
            "identify the cause."
        ),
        N_("Add lines."),
    ),
    "adjustment.several_causes": Advised(
        N_(
            "Several causes explain almost equally well why the residuals do not agree with the "
            "error model, the most likely first: {causes:names}."
        ),
        N_("Check each of them."),
    ),
    "adjustment.known_cause": Advised(
        N_(
            "The residuals do not agree with the error model because of the imported data: {cause} "
            "(see the warning about it)."
        ),
        N_("Correct the data first."),
    ),
    "adjustment.known_cause_or_others": Advised(
        N_(
            "The residuals do not agree with the error model because of the imported data: {cause} "
            "(see the warning about it); other possible causes: {causes:names}."
        ),
        N_("Correct the data first."),
    ),
    "adjustment.line_boresight": N_(
        "The boresight angles of line {line} differ from those of the other lines "
        "({differences:names}); it may come from a second scanner, or the mounting moved. "
        "Calibrate the line separately, or exclude it."
    ),
    "adjustment.line_position": Advised(
        N_("The positions on line {line} are in error by {shift:mm.1} mm."),
        N_("Check the trajectory during this line, or exclude the line."),
    ),
    "adjustment.line_jumped": Advised(
        Plural(
            "All targets are displaced on line {lines:names}.",
            "All targets are displaced on lines {lines:names}.",
        ),
        N_(
            "Check first for a jump in the position, confused targets or a wrong mounting "
            "parameter."
        ),
    ),
    "adjustment.line_times_early": Advised(
        N_("The point times of line {line} are {offset:ms.2} ms early."),
        N_("Check the time base and the time shift of the line, or exclude the line."),
    ),
    "adjustment.line_times_late": Advised(
        N_("The point times of line {line} are {offset:ms.2} ms late."),
        N_("Check the time base and the time shift of the line, or exclude the line."),
    ),
    "adjustment.target_not_flat": Advised(
        N_(
            "The residuals do not agree with the error model, most likely because target {target} "
            "is not the same flat surface on all lines."
        ),
        N_("Exclude the target, or pick a smaller area of it."),
    ),
    "adjustment.sighting_cause": Advised(
        N_("The residuals do not agree with the error model; most likely cause: {cause}."),
        N_("Check the points and the trajectory at that time."),
    ),
}
