"""Texts of warnings about targets and the result of an adjustment."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

_CONTRADICTED = N_(
    "The data contradict the given {parameter}. They fit a value {change} (± {sigma}, w {w:x.1+}), "
    "which would change {angles:names}. Measure it again, or estimate it."
)
_CONTRADICTED_ALONE = N_(
    "The data contradict the given {parameter}. They fit a value {change} (± {sigma}, w {w:x.1+}). "
    "Measure it again, or estimate it."
)
_MOUNTING = ("lever_x", "lever_y", "lever_z", "range_offset", "scan_angle_offset", "latency")

TEXTS: Mapping[str, Template] = {
    # -- targets and files -------------------------------------------------------------------
    "targets.counted_twice": Plural(
        "Targets have points in common: {pairs:names}. These points count twice, so the standard "
        "deviations of the angles are too small. Exclude one of the two.",
        "Targets have points in common: {pairs:names}. These points count twice, so the standard "
        "deviations of the angles are too small. Exclude one target of each pair.",
    ),
    "targets.no_independent_check": Plural(
        "A validation plane has points in common with a target: {pairs:names}. It does not check "
        "the angles independently. Exclude one of the two.",
        "Validation planes have points in common with targets: {pairs:names}. They do not check "
        "the angles independently. Exclude one of each pair.",
    ),
    "targets.single_line_targets": N_(
        "Excluded, because only one line shows them: {sightings:names}. Set seeds on other lines, "
        "or remove these targets."
    ),
    "targets.proposal_unchecked": N_(
        "The scene has no targets that check each other. Use the targetless method, which adjusts "
        "many small surfaces, or put up boards."
    ),
    "data.same_on_lines": N_("{reason} The same applies to {lines:names}."),
    # -- angles ------------------------------------------------------------------------------
    "adjustment.independent_pos_errors": N_(
        "The POS errors are uncorrelated (classical), whereas neighbouring points have nearly the "
        "same error. The standard deviations of the angles are several times too small. Use "
        "correlated POS errors."
    ),
    "adjustment.large_sigma": N_(
        "Standard deviations are large (1 sigma): {angles:names}. Add targets with other "
        "orientations, or lines in other directions."
    ),
    "adjustment.large_sigma_unseen": N_(
        "Standard deviations are large (1 sigma): {angles:names}. They include the uncertainty of "
        "values that these lines and targets do not determine: {parameters:names}. Give smaller "
        "standard deviations for these values, or do not estimate them."
    ),
    "adjustment.one_target": N_(
        "{target} is the only target. The angles are separated by the line headings alone, and "
        "nothing shows whether the target is bent or has moved. Add a target with another "
        "orientation."
    ),
    "adjustment.one_facing": N_(
        "All targets are nearly parallel, so the angles are separated by the line headings alone. "
        "Add a target with another orientation."
    ),
    "adjustment.high_correlation": N_(
        "The correlation of {first} and {second} is {correlation:x.2+}, so they can hardly be "
        "separated. Add a target with another orientation, or lines in other directions."
    ),
    "adjustment.high_correlation_parameter": N_(
        "The correlation of {first} and {second} is {correlation:x.2+}, so they can hardly be "
        "separated. Give the standard deviation of the prior {second}, or do not estimate it."
    ),
    "adjustment.steep_pitch": N_(
        "The boresight pitch is steep, so roll and yaw can hardly be separated. The standard "
        "deviations are those of small rotations about the body axes. Use the rotation matrix "
        "instead of the three angles."
    ),
    "adjustment.surface_held": N_(
        "The surface sigma is fixed at 0, so no sighting is tested against the others. Estimate it "
        "from the data to test them."
    ),
    "adjustment.surfaces_differ": N_(
        "Between lines, the targets deviate by {sigma:mm.1} mm (1 sigma) from their common shape, "
        "more than the given standard deviations explain. The chi-square test allows for it. Check "
        "for rough or bent targets and for errors outside the model; flat boards do not deviate so "
        "much."
    ),
    "adjustment.surfaces_displaced": N_(
        "Between lines, the targets are displaced by {offset:mm.1} mm and tilted by {tilt:mm.1} mm "
        "(1 sigma), more than the given standard deviations explain. The chi-square test allows "
        "for it. Check whether targets moved, and for errors outside the model."
    ),
    "adjustment.shorter_times": N_(
        "With the given correlation times of the POS errors (position {position:s} s, attitude "
        "{attitude:s} s) the residuals are too large for the chi-square test. With "
        "{used_position:s} s and {used_attitude:s} s they pass it, and the standard deviations are "
        "computed with these."
    ),
    "adjustment.sigmas_raised": N_(
        "Parts of the data scatter more than the error model predicts. Standard deviations are "
        "increased: {angles:names}."
    ),
    "adjustment.cross_check": N_(
        "Parts of the data disagree by more than chance explains: {parts:names}. Compare their "
        "angles under Cross-checks."
    ),
    "adjustment.refused_since": N_(
        "A later estimate was refused: {reason} The angles are those of the estimate before it."
    ),
    # -- what cannot be checked --------------------------------------------------------------
    "adjustment.line_unchecked": Plural(
        "Without line {lines:names} the angles are not determined, so its errors cannot be "
        "detected. Add lines.",
        "If any one of the lines {lines:names} is omitted, the angles are not determined, so its "
        "errors cannot be detected. Add lines.",
    ),
    "adjustment.target_unchecked": Plural(
        "Without target {targets:names} the angles are not determined, so its errors cannot be "
        "detected. Add targets.",
        "If any one of the targets {targets:names} is omitted, the angles are not determined, so "
        "its errors cannot be detected. Add targets.",
    ),
    "adjustment.targets_clustered": N_(
        "All targets lie within {size:percent.0} % of their distance from the scanner, so errors "
        "of a line cannot be detected. Add targets at other places."
    ),
    "adjustment.carried_by_one": N_(
        "The angles depend on one sighting whose errors cannot be detected: {sightings:names}. Add "
        "targets or lines."
    ),
    # -- sightings, targets and points -------------------------------------------------------
    "adjustment.released": Plural(
        "Rejected, because the other sightings contradict it: {sightings:names}. Check its points "
        "and the trajectory there. Exclude it if its points are on another surface.",
        "Rejected, because the other sightings contradict them: {sightings:names}. Check their "
        "points and the trajectory there. Exclude those whose points are on another surface.",
    ),
    "adjustment.sighting_disagrees": Plural(
        "The other sightings contradict it, but it is used: {sightings:names}. Check its points "
        "and the trajectory there.",
        "The other sightings contradict them, but they are used: {sightings:names}. Check their "
        "points and the trajectory there.",
    ),
    "adjustment.target_excluded": N_(
        "Excluded, because none of their points agrees with the other targets and lines: "
        "{targets:names}. Pick these targets again, or remove them."
    ),
    "adjustment.target_cut": N_(
        "Lines show different parts of a surface that is not shown to be flat, so only the common "
        "part is used: {targets:names}. Pick smaller targets."
    ),
    "adjustment.target_parts": N_(
        "Excluded, because lines show different parts of the surface and it is not shown to be "
        "flat: {targets:names}. Pick a part that two lines show."
    ),
    "adjustment.strays_full_weight": N_(
        "Outliers: {count:n} of {points:n} points, where chance explains about {expected:n}; most "
        "of them on {target}, line {line} ({here:n} of {sighting_points:n}). They have full "
        "weight. Choose a robust loss."
    ),
    "adjustment.strays_reduced_weight": N_(
        "Outliers: {count:n} of {points:n} points, where chance explains about {expected:n}; most "
        "of them on {target}, line {line} ({here:n} of {sighting_points:n}). They have less "
        "weight than other points."
    ),
    "adjustment.strays_no_weight": N_(
        "Outliers: {count:n} of {points:n} points, where chance explains about {expected:n}; most "
        "of them on {target}, line {line} ({here:n} of {sighting_points:n}). They have little or "
        "no weight."
    ),
    "adjustment.another_surface": Plural(
        "The points of {targets:names} deviate from their surface by {factor:x.1} times the LiDAR "
        "noise and have little weight. Check whether all lines show the same surface.",
        "The points of {targets:names} deviate from their surfaces by up to {factor:x.1} times the "
        "LiDAR noise and have little weight. Check whether all lines show the same surfaces.",
    ),
    "adjustment.noise": Plural(
        "Residuals on {targets:names} are larger than the LiDAR noise or correlated over the "
        "surface, as with {factor:x.1} times the given noise. The surface is rough or curved, or "
        "the given LiDAR sigma is too small. The standard deviations of the angles are computed "
        "with the noise found.",
        "Residuals on {targets:names} are larger than the LiDAR noise or correlated over the "
        "surface, as with up to {factor:x.1} times the given noise. The surfaces are rough or "
        "curved, or the given LiDAR sigma is too small. The standard deviations of the angles are "
        "computed with the noise found.",
    ),
    "adjustment.not_flat": Plural(
        "Residuals on {targets:names} are larger than the LiDAR noise or correlated over the "
        "surface, as with {factor:x.1} times the given noise. The target is probably not flat, and "
        "these lines are too few to detect the effect: the angles may be off by more than their "
        "standard deviations. Add lines, or use flat targets.",
        "Residuals on {targets:names} are larger than the LiDAR noise or correlated over the "
        "surface, as with up to {factor:x.1} times the given noise. The targets are probably not "
        "flat, and these lines are too few to detect the effect: the angles may be off by more "
        "than their standard deviations. Add lines, or use flat targets.",
    ),
    "adjustment.radii_differ": N_(
        "The radius of {target} differs between lines, from {smallest:mm.1} to {largest:mm.1} mm, "
        "and no single error explains it. Check the signs of the attitude, the latency and the "
        "points of the target."
    ),
    "adjustment.radii_roll_sign": N_(
        "The radius of {target} differs between lines, from {smallest:mm.1} to {largest:mm.1} mm. "
        "The radii agree with the opposite sign of roll. Check the sign convention of the file."
    ),
    "adjustment.radii_pitch_sign": N_(
        "The radius of {target} differs between lines, from {smallest:mm.1} to {largest:mm.1} mm. "
        "The radii agree with the opposite sign of pitch. Check the sign convention of the file."
    ),
    "adjustment.radii_roll_pitch_signs": N_(
        "The radius of {target} differs between lines, from {smallest:mm.1} to {largest:mm.1} mm. "
        "The radii agree with the opposite signs of roll and pitch. Check the sign convention of "
        "the file."
    ),
    "adjustment.radii_parameter": N_(
        "The radius of {target} differs between lines, from {smallest:mm.1} to {largest:mm.1} mm. "
        "The radii agree with another value of the mounting: {cause}. Measure it again."
    ),
    # -- errors behind the residuals ---------------------------------------------------------
    **{f"adjustment.contradicted_{name}": _CONTRADICTED for name in _MOUNTING},
    **{f"adjustment.contradicted_{name}_alone": _CONTRADICTED_ALONE for name in _MOUNTING},
    "change.larger": N_("larger by {amount}"),
    "change.smaller": N_("smaller by {amount}"),
    "adjustment.cause_not_located": N_(
        "The residuals contradict the model, and the lines are too few to identify the cause. "
        "Possible causes: {causes:names}. Add lines."
    ),
    "adjustment.several_causes": N_(
        "The residuals contradict the model. These causes explain them about equally well, the "
        "first one best: {causes:names}. Check each of them."
    ),
    "adjustment.known_cause": N_(
        "The residuals contradict the model. The cause is known from the data: {cause} (see the "
        "warning about it). Correct the data first."
    ),
    "adjustment.known_cause_or_others": N_(
        "The residuals contradict the model. The cause is known from the data: {cause} (see the "
        "warning about it); without it these would explain them: {causes:names}. Correct the data "
        "first."
    ),
    "adjustment.line_boresight": N_(
        "Line {line} fits another boresight than the other lines ({differences:names}). It may be "
        "of a second scanner, or the mounting moved. Calibrate it separately, or exclude it."
    ),
    "adjustment.line_position": N_(
        "The position on line {line} is off by {shift:mm.1} mm. Check the trajectory there, or "
        "exclude the line."
    ),
    "adjustment.line_jumped": Plural(
        "All targets are off on line {lines:names}. The position may have jumped there, targets "
        "may be confused, or a given value of the mounting may be wrong.",
        "All targets are off on the lines {lines:names}. The position may have jumped there, "
        "targets may be confused, or a given value of the mounting may be wrong.",
    ),
    "adjustment.line_times_early": N_(
        "The point times of line {line} are {offset:ms.2} ms early. Check the time base and the "
        "time shift of the line, or exclude it."
    ),
    "adjustment.line_times_late": N_(
        "The point times of line {line} are {offset:ms.2} ms late. Check the time base and the "
        "time shift of the line, or exclude it."
    ),
    "adjustment.target_not_flat": N_(
        "The residuals contradict the model. Most likely target {target} is not one flat surface "
        "for all lines. Exclude it, or pick a smaller part of it."
    ),
    "adjustment.sighting_cause": N_(
        "The residuals contradict the model. The most likely cause: {cause}. Check the points and "
        "the trajectory there."
    ),
}
