"""Warnings about the result of an adjustment that matter for the use of the angles.

The command line, the window and the report show the same warnings. Each rule is a function in
`WARNING_RULES`.
"""

from collections.abc import Callable, Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.cause_warnings import (
    KnownError,
    main_wrong_value,
    warnings_about_causes,
)
from lispac.adjustment.diagnostics.control_tests import contradicting_control
from lispac.adjustment.diagnostics.sighting_warnings import (
    contradicted_sighting_warnings,
    noise_warnings,
    outlier_warnings,
)
from lispac.adjustment.model.parameters import (
    amount_with_unit,
    change_text,
    changed_value,
    has_opposite_sign,
    mounting_value_name,
    mounting_value_names,
)
from lispac.adjustment.model.stochastic_model import (
    ASSUMED_ATTITUDE_SIGMA_DEG,
    ASSUMED_LIDAR_SIGMA,
    ASSUMED_POSITION_SIGMA,
)
from lispac.adjustment.result import ANGLES, AdjustmentResult, CrossCheck, CrossChecks, SigmaGroup
from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.messages import Level, Message, Value, note, shortened_list, sort_by_importance, warning
from lispac.warning_causes import RESULT_CAUSE, Cause

Array = NDArray[np.float64]

MAX_ANGLE_SIGMA_DEG = 0.1
"""Largest sigma of an angle without a warning, degrees; at 100 m, 0.1 deg correspond to 17 cm."""

MIN_REPORTED_SIGMA_FACTOR = 1.05
"""Factor on a sigma above which a note reports that it was raised."""

SCATTER_SIGNIFICANCE_LEVEL = 0.005
"""Probability of a warning about differences between parts of the data if the model is correct."""

MAX_DIFFERENCE_SIGMAS = 3.0
"""Largest difference between the result without a part and that of all data, in sigmas, that
leads to a note instead of a warning if it is significant."""

MAX_LEVER_ARM_ERROR_M = 0.1
"""Error of a component of the lever arm, metres, that is too large for a measuring error."""

HIGH_CORRELATION = 0.9
"""Correlation above which mainly the sum or the difference of two angles is determined."""

MAX_FLAT_FORM_SIGMA = 0.005
"""Largest sigma of the form errors of flat boards, metres."""

LARGE_RESIDUAL_CODES = {
    "adjustment.noise", "adjustment.not_flat", "adjustment.cause_not_located",
    "adjustment.cause_not_identified",
}  # fmt: skip
"""Codes of messages on large residuals. If there is one of them, the messages on the noise of all
targets are omitted."""
LIDAR_NOISE_CODES = {
    "adjustment.lidar_noise", "adjustment.lidar_noise_ratio", "adjustment.lidar_noise_assumed",
    "adjustment.lidar_noise_conservative", "adjustment.lidar_noise_ratio_conservative",
    "adjustment.lidar_noise_assumed_conservative",
}  # fmt: skip
"""Codes of the notes on a LiDAR noise in the residuals that differs from the given one."""


def result_warnings(
    result: AdjustmentResult, checks: CrossChecks | None, also: Iterable[Message] = ()
) -> tuple[Message, ...]:
    """All warnings about a result, then the notes; ``also`` are messages about its data."""
    also = tuple(also)
    found = [message for rule in WARNING_RULES for message in rule(result, checks)]
    all_found = (*also, *warnings_about_causes(result, KnownError.largest_among(also), found))
    if any(each.code in LARGE_RESIDUAL_CODES for each in all_found):
        all_found = tuple(each for each in all_found if each.code not in LIDAR_NOISE_CODES)
    return sort_by_importance(all_found)


def wrong_value_of(result: AdjustmentResult) -> Message | None:
    """Warning about the given value of the mounting that causes most residuals, if any."""
    return main_wrong_value(result_warnings(result, None))


def _uncorrelated_warning(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if not result.model.correlated:
        yield warning("adjustment.independent_pos_errors", subject=Cause.of_field("pos_errors"))


def _steep_pitch_note(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if result.mounting.axes is not None:
        yield note("adjustment.steep_pitch", subject=RESULT_CAUSE)


def has_form_errors(result: AdjustmentResult) -> bool:
    """Whether larger form errors than those of flat boards were estimated."""
    return result.model.surface is None and float(result.surfaces.max()) > MAX_FLAT_FORM_SIGMA


def _surface_notes(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if not has_form_errors(result):
        return
    largest = float(result.surfaces.max())
    page = Cause.of_page("Sightings")
    if result.offset == largest:
        tilt = float(result.surface)
        yield note("adjustment.surfaces_displaced", offset=largest, tilt=tilt, subject=page)
    else:
        yield note("adjustment.surfaces_differ", sigma=largest, subject=page)


def _large_sigma_warnings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    large = [
        note("item.angle_sigma", angle=mounting_value_name(angle), sigma=float(sigma))
        for angle, sigma in zip(ANGLES, result.sigma, strict=True)
        if np.degrees(sigma) > MAX_ANGLE_SIGMA_DEG
    ]
    if not large:
        return
    unseen = [
        each.name
        for each in result.parameters
        if each.value is None and each.prior_sigma is not None
    ]
    if unseen:
        yield warning(
            "adjustment.large_sigma_unseen",
            angles=large, parameters=mounting_value_names(unseen), subject=RESULT_CAUSE,
        )  # fmt: skip
    else:
        yield warning("adjustment.large_sigma", angles=large, subject=RESULT_CAUSE)


def _changed_lever_arm_warnings(
    result: AdjustmentResult, _: CrossChecks | None
) -> Iterator[Message]:
    """Warn that an estimated lever arm differs from the given one by more than it is measured."""
    for each in result.parameters:
        if not each.name.startswith("lever_") or each.value is None or each.sigma is None:
            continue
        change = each.value - each.prior
        if abs(change) > max(MAX_LEVER_ARM_ERROR_M, MAX_DIFFERENCE_SIGMAS * each.sigma):
            yield warning(
                "adjustment.estimated_lever_arm_differs",
                parameter=mounting_value_name(each.name),
                change=change_text(
                    each.name,
                    change,
                    has_opposite_sign=has_opposite_sign(each.prior, change, each.sigma),
                ),
                sigma=amount_with_unit(each.name, each.sigma),
                subject=Cause.of_parameter(each.name),
            )


def _one_orientation_warning(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    targets = result.targets
    if not have_one_orientation(
        np.array([target.plane[:3] for target in targets]),
        np.array([target.sphere for target in targets]),
    ):
        return
    first = targets[0].target
    if len(targets) == 1:
        yield warning("adjustment.one_target", target=first, subject=Cause.of_target(first))
    else:
        yield warning("adjustment.one_facing", subject=Cause.of_target(first))


def _correlation_notes(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    matrix, names = result.correlation_all, result.estimated
    for i, first in enumerate(names):
        for j in range(i + 1, len(names)):
            if abs(matrix[i, j]) > HIGH_CORRELATION:
                of_angles = j < len(ANGLES)
                yield note(
                    "adjustment.high_correlation"
                    if of_angles
                    else "adjustment.high_correlation_parameter",
                    first=mounting_value_name(first),
                    second=mounting_value_name(names[j]),
                    correlation=float(matrix[i, j]),
                    subject=Cause.of_page("Correlations")
                    if of_angles
                    else Cause.of_parameter(names[j]),
                )


def _exact_surface_note(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if result.model.correlated and result.model.surface == 0:
        yield note("adjustment.surface_held", subject=Cause.of_field("surface"))


def _cross_check_messages(
    result: AdjustmentResult, checks: CrossChecks | None
) -> Iterator[Message]:
    """Warning about differences that no increased sigma covers, and note on the other ones."""
    parts = [part for part in checks.parts if part.disagrees] if checks else []
    halves = [part for part in parts if part.kind == "half"]
    # The two halves are compared with each other, so that one message is enough.
    parts = [*(part for part in parts if part.kind != "half"), *halves[-1:]]
    uncovered, covered = [], []
    for part in parts:
        assert part.significance is not None
        significance = np.abs(part.significance)
        if (exceeding := significance * _is_uncovered(result, checks, part)).any():
            uncovered.append(_disagreeing_part_item(part, int(exceeding.argmax())))
        else:
            covered.append(_disagreeing_part_item(part, int(significance.argmax())))
    page = Cause.of_page("Cross-checks")
    if uncovered:
        yield warning(
            "adjustment.cross_check_uncovered", parts=shortened_list(uncovered), subject=page
        )
    if covered:
        yield note("adjustment.cross_check", parts=shortened_list(covered), subject=page)


def _is_uncovered(
    result: AdjustmentResult, checks: CrossChecks | None, part: CrossCheck
) -> NDArray[np.bool_]:
    """Whether the sigma of each angle does not cover the result without a part, (3,).

    The difference is significant, it exceeds `MAX_DIFFERENCE_SIGMAS` sigmas, and the sigma was
    not raised, because too few parts can be omitted. Halves are not considered: each consists
    of few lines, which hardly determine some angles. The level of each test is that of all tests
    divided by their number (Bonferroni, Dunn 1961).
    """
    from scipy.special import ndtri

    if (
        checks is None or part.kind == "half" or not result.model.correlated
        or part.significance is None or part.difference is None
    ):  # fmt: skip
        return np.zeros(3, dtype=bool)
    tests = len(ANGLES) * sum(each.significance is not None for each in checks.parts)
    factors = np.ones(3) if result.angle_sigma_factors is None else result.angle_sigma_factors
    return np.asarray(
        (np.abs(part.significance) > -ndtri(SCATTER_SIGNIFICANCE_LEVEL / (2 * tests)))
        & (np.abs(part.difference) > MAX_DIFFERENCE_SIGMAS * result.sigma)
        & (factors <= MIN_REPORTED_SIGMA_FACTOR)
    )


PART_CODES = {
    "line": "item.without_line", "target": "item.without_target", "half": "item.halves",
}  # fmt: skip
"""Code of the name of a part of the data by its kind."""


def _disagreeing_part_item(part: CrossCheck, k: int) -> Message:
    """Cross-check as an item of a list, with the difference of angle ``k``."""
    assert part.significance is not None
    assert part.difference is not None
    return note(
        PART_CODES[part.kind],
        name=part.part,
        angle=mounting_value_name(ANGLES[k]),
        difference=float(part.difference[k]),
        ratio=float(abs(part.significance[k])),
    )


def _unchecked_part_warnings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    """Warnings about lines, targets and sightings whose errors cannot be detected."""
    if result.observability is None:
        return
    found = result.observability.unchecked
    lines = [each.line for each in found if each.kind == "line"]
    targets = [each.target for each in found if each.kind == "target"]
    if lines:
        yield warning(
            "adjustment.line_unchecked",
            count=len(lines), lines=lines, subject=Cause.of_line(lines[0]),
        )  # fmt: skip
    if targets:
        yield warning(
            "adjustment.target_unchecked",
            count=len(targets), targets=targets, subject=Cause.of_target(targets[0]),
        )  # fmt: skip
    for each in found:
        if each.kind == "clustered" and each.targets:
            yield warning(
                "adjustment.targets_act_as_one",
                count=len(each.angles), targets=each.targets,
                angles=mounting_value_names(each.angles),
                subject=Cause.of_target(each.targets[0]),
            )  # fmt: skip
        elif each.kind == "clustered":
            yield warning(
                "adjustment.targets_clustered", size=float(each.size), subject=RESULT_CAUSE
            )
    carried = [each for each in found if each.kind == "sighting"]
    if carried:
        sightings = [
            note(
                "item.sighting_angles",
                target=each.target, line=each.line, angles=mounting_value_names(each.angles),
            )
            if each.line
            else note(
                "item.target_angles", target=each.target, angles=mounting_value_names(each.angles)
            )
            for each in carried
        ]  # fmt: skip
        yield warning(
            "adjustment.carried_by_one",
            sightings=shortened_list(sightings),
            subject=(
                Cause.of_sighting(carried[0].target, carried[0].line)
                if carried[0].line
                else Cause.of_target(carried[0].target)
            ),
        )


_TRANSLATION_CODES = (
    "control.translation_north", "control.translation_west", "control.translation_up",
)  # fmt: skip


def _control_warnings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    """Warnings about surveyed points that contradict the survey."""
    points, moved = contradicting_control(result.control, result.control_translations)
    for each in moved:
        components = [
            note(code, size=float(size), sigma=float(sigma))
            for code, size, sigma in zip(
                _TRANSLATION_CODES, each.translation, each.sigma, strict=True
            )
            if np.isfinite(sigma)
        ]
        yield warning(
            "adjustment.control_translated",
            source=each.source, components=components, subject=RESULT_CAUSE,
        )  # fmt: skip
    for point in points:
        assert point.shift is not None
        assert point.shift_sigma is not None
        assert point.w is not None
        yield warning(
            "adjustment.control_contradicts",
            name=point.name, target=point.target, shift=abs(point.shift), sigma=point.shift_sigma,
            w=point.w, subject=Cause.of_target(point.target),
        )  # fmt: skip


def _excluded_target_notes(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if excluded := result.excluded_targets:
        first = Cause.of_target(excluded[0])
        yield note("adjustment.target_excluded", targets=shortened_list(excluded), subject=first)


def _common_part_warnings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    """Notes on targets that were reduced or excluded because the lines show different parts."""
    cut = [each for each in result.common_parts if each.share > 0.0]
    excluded = [each.target for each in result.common_parts if each.share == 0.0]
    if cut:
        shares = [
            note("item.share_of_points", share=float(each.share), target=each.target)
            for each in cut
        ]
        first = Cause.of_target(cut[0].target)
        yield note("adjustment.target_cut", targets=shortened_list(shares), subject=first)
    if excluded:
        first = Cause.of_target(excluded[0])
        yield note("adjustment.target_parts", targets=shortened_list(excluded), subject=first)


RADIUS_CAUSE_CODES = {
    "": "adjustment.radii_differ",
    "roll_sign": "adjustment.radii_roll_sign",
    "pitch_sign": "adjustment.radii_pitch_sign",
    "roll_pitch_signs": "adjustment.radii_roll_pitch_signs",
}
"""Code for each cause of `RadiusDiscrepancy`; other causes are values of the mounting."""


def _radius_warnings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    for each in result.radius_discrepancies:
        target = Cause.of_target(each.target)
        code = RADIUS_CAUSE_CODES.get(each.cause, "adjustment.radii_parameter")
        params: dict[str, Value] = {
            "target": each.target, "smallest": float(each.smallest), "largest": float(each.largest)
        }  # fmt: skip
        if each.cause not in RADIUS_CAUSE_CODES:
            params["cause"] = changed_value(each.cause, each.value)
        yield Message(code, Level.WARNING, params, target)


def _correlation_time_note(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if result.given_correlation_times is None:
        return
    position, attitude = result.given_correlation_times
    params: dict[str, Value] = {
        "position": float(position), "attitude": float(attitude),
        "used_position": float(result.model.position_time),
        "used_attitude": float(result.model.attitude_time),
    }  # fmt: skip
    code = "adjustment.shorter_times"
    if result.sigma_at_given_times is not None:
        code = "adjustment.shorter_times_sigmas"
        params["angles"] = [
            note(
                "item.angle_predicted",
                angle=mounting_value_name(angle), sigma=float(used), predicted=float(given),
            )
            for angle, used, given in zip(
                ANGLES, result.sigma, result.sigma_at_given_times, strict=True
            )
        ]  # fmt: skip
    yield Message(code, Level.NOTE, params, Cause.of_field("position_time"))


def _raised_sigma_note(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if result.angle_sigma_factors is None:
        return
    raised = [
        note(
            "item.angle_raised",
            angle=mounting_value_name(angle),
            before=float(before),
            after=float(after),
        )
        for angle, before, after, factor in zip(
            ANGLES,
            result.with_formal_sigmas.sigma,
            result.with_exact_lever_arm.sigma,
            result.angle_sigma_factors,
            strict=True,
        )
        if factor > MIN_REPORTED_SIGMA_FACTOR
    ]
    if raised:
        page = Cause.of_page("Cross-checks")
        is_conservative = result.chi_square.outcome == "conservative"
        yield note(
            "adjustment.sigmas_raised_conservative"
            if is_conservative
            else "adjustment.sigmas_raised",
            angles=raised, subject=page,
        )  # fmt: skip


def _lever_arm_note(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    """Note that the sigmas of the given lever arm increase those of the angles."""
    if (sigma := result.model.lever_arm_sigma) is None:
        return
    exact = result.with_exact_lever_arm.sigma
    increased = [
        note(
            "item.angle_raised",
            angle=mounting_value_name(angle),
            before=float(before),
            after=float(after),
        )
        for angle, before, after in zip(ANGLES, exact, result.sigma, strict=True)
        if after > MIN_REPORTED_SIGMA_FACTOR * before
    ]
    if increased:
        yield note(
            "adjustment.lever_arm_uncertainty",
            x=float(sigma[0]), y=float(sigma[1]), z=float(sigma[2]), angles=increased,
            subject=Cause.of_field("lever_arm"),
        )  # fmt: skip


def has_raised_sigmas(result: AdjustmentResult) -> bool:
    """Whether the sigma of an angle was raised by an amount that is reported."""
    return any(_raised_sigma_note(result, None))


_SIGMA_FIELDS: dict[SigmaGroup, str] = {
    "LiDAR": "lidar_sigma", "POS position": "position_sigma", "POS attitude": "attitude_sigma_deg",
}  # fmt: skip


def _assumed_sigma_note(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    if groups := result.unestimated_sigmas:
        north, east, down = ASSUMED_POSITION_SIGMA
        roll, pitch, heading = map(float, np.radians(ASSUMED_ATTITUDE_SIGMA_DEG))
        items = {
            "LiDAR": note("item.assumed_lidar", sigma=ASSUMED_LIDAR_SIGMA),
            "POS position": note("item.assumed_position", north=north, east=east, down=down),
            "POS attitude": note("item.assumed_attitude", roll=roll, pitch=pitch, heading=heading),
        }
        assumed = [items[group] for group in groups]
        field = Cause.of_field(_SIGMA_FIELDS[groups[0]])
        yield note("adjustment.assumed_sigmas", groups=assumed, subject=field)


def _method_messages(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    yield from result.messages


WARNING_RULES: tuple[Callable[[AdjustmentResult, CrossChecks | None], Iterator[Message]], ...] = (
    _uncorrelated_warning,
    _large_sigma_warnings,
    _changed_lever_arm_warnings,
    _one_orientation_warning,
    _correlation_notes,
    _control_warnings,
    _exact_surface_note,
    _surface_notes,
    _steep_pitch_note,
    contradicted_sighting_warnings,
    outlier_warnings,
    noise_warnings,
    _cross_check_messages,
    _unchecked_part_warnings,
    _excluded_target_notes,
    _common_part_warnings,
    _radius_warnings,
    _correlation_time_note,
    _raised_sigma_note,
    _lever_arm_note,
    _assumed_sigma_note,
    _method_messages,
)
"""Functions that give warnings and notes about a result and its cross-checks."""


def outdated_result_warning(reason: Message | str) -> Message:
    """Warning that a result is out of date because a later estimate failed, with the reason."""
    return warning("adjustment.refused_since", reason=reason, subject=RESULT_CAUSE)
