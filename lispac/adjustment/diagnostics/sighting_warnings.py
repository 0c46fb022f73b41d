"""Warnings about sightings and targets: disagreement, outliers, noise."""

from collections.abc import Callable, Iterator, Sequence

from lispac.adjustment.diagnostics.findings import (
    MAX_DETECTABLE_BIAS,
    critical_test_value,
    exceedance_limit,
    sighting_status,
)
from lispac.adjustment.model.observations import Sighting
from lispac.adjustment.result import (
    AdjustmentResult,
    CrossChecks,
    SightingReliability,
    TargetResidual,
)
from lispac.messages import Message, note, shortened_list, warning
from lispac.warning_causes import Cause

NOISE_FACTOR_LIMIT = 2.0
"""Noise factor above which a warning is given; smaller excesses are tenths of a millimetre."""

FORM_FACTOR_LIMIT = 2**0.5
"""Noise factor above which the form errors have a larger variance than the LiDAR noise."""

OTHER_SURFACE_FACTOR = 30.0
"""Noise factor above which a target must contain another surface; rough ground reaches about 15."""

OUTLIER_PROBABILITY = 0.001
"""Probability that a point exceeds the critical value of its test by chance."""

USUAL_OUTLIER_SHARE = 0.005
"""Usual share of outliers; no warning is given below it."""

MAX_WRONG_LINE_SHARE = 0.2
"""Share of wrong lines above which the other lines are not reliable either."""

MIN_SHIFT_TEST_VALUE = 2.0
"""Test value below which a shift does not explain why a sighting was rejected."""


def contradicted_sighting_warnings(
    result: AdjustmentResult, _: CrossChecks | None
) -> Iterator[Message]:
    """Warnings about sightings that disagree with the others, rejected or not."""
    critical = critical_test_value(result)
    if critical is None:
        return
    tested = [(sighting_status(item, critical), item) for item in result.reliability]
    rejected = [item for status, item in tested if status == "rejected"]
    if rejected:
        yield note(
            "adjustment.released",
            count=len(rejected),
            sightings=_sorted_sighting_items(rejected),
            subject=_worst_sighting_subject(rejected),
        )
    disagreeing = [item for status, item in tested if status == "disagrees"]
    if disagreeing:
        yield note(
            "adjustment.sighting_disagrees",
            count=len(disagreeing),
            sightings=_sorted_sighting_items(disagreeing),
            subject=_worst_sighting_subject(disagreeing),
        )


def _sorted_sighting_items(items: list[SightingReliability]) -> tuple[str | Message, ...]:
    """Sightings for a message, the largest test value first."""
    return shortened_list(
        [_tested_sighting_item(item) for item in sorted(items, key=lambda item: -abs(item.w))]
    )


def _worst_sighting_subject(items: list[SightingReliability]) -> Cause:
    return _sighting_subject(max(items, key=lambda item: abs(item.w)).sighting)


def _sighting_subject(sighting: Sighting) -> Cause:
    return Cause.of_sighting(sighting.target, sighting.line)


def _tested_sighting_item(item: SightingReliability) -> Message:
    if not item.detectable < MAX_DETECTABLE_BIAS or abs(item.w) < MIN_SHIFT_TEST_VALUE:
        return _sighting_item(item.sighting)  # not checked, or tilted rather than shifted
    return note(
        "item.sighting_shifted",
        target=item.sighting.target, line=item.sighting.line,
        shift=float(abs(item.shift)), w=float(item.w),
    )  # fmt: skip


OUTLIER_CODES = {
    "none": "adjustment.strays_full_weight",
    "huber": "adjustment.strays_reduced_weight",
    "tukey": "adjustment.strays_no_weight",
}
"""Code of the warning for each loss, which determines the weight of outliers."""


def outlier_warnings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    """Warning if there are more outliers than expected by chance."""
    counts = {(s.sighting.target, s.sighting.line): s.points for s in result.sightings}
    tested = [
        (item.sighting, item.outliers, counts[item.sighting.target, item.sighting.line])
        for item in result.reliability
    ]
    many, points = sum(each[1] for each in tested), sum(each[2] for each in tested)
    limit = exceedance_limit(points, OUTLIER_PROBABILITY)
    if many <= max(float(limit), USUAL_OUTLIER_SHARE * points):
        return
    worst, here, of = max(tested, key=lambda each: each[1] / each[2])
    yield note(
        OUTLIER_CODES[result.model.loss],
        count=many, points=points, expected=max(1, round(OUTLIER_PROBABILITY * points)),
        target=worst.target, line=worst.line, here=here, sighting_points=of,
        subject=_sighting_subject(worst),
    )  # fmt: skip


def noise_warnings(result: AdjustmentResult, _: CrossChecks | None) -> Iterator[Message]:
    """Warning about targets whose points scatter more than the LiDAR noise explains."""
    worst_first = sorted(result.targets, key=lambda target: -target.noise)
    other = [t for t in worst_first if t.noise > OTHER_SURFACE_FACTOR]
    if other:
        yield note(
            "adjustment.another_surface",
            count=len(other), targets=shortened_list([t.target for t in other]),
            factor=float(other[0].noise), subject=Cause.of_target(other[0].target),
        )  # fmt: skip
    rough = [t for t in worst_first if _is_rough(t)]
    if not rough:
        return
    # With an assumed LiDAR sigma, the noise does not show whether the target is flat.
    is_lidar_known = "LiDAR" not in result.unestimated_sigmas
    bent = [t for t in rough if is_lidar_known and t.target in probably_not_flat(result)]
    if bent:
        yield _noise_message(warning, "adjustment.not_flat", bent, form_error_factor)
    if others := [t for t in rough if t not in bent]:
        yield _noise_message(note, "adjustment.noise", others, lambda target: target.noise)


def probably_not_flat(result: AdjustmentResult) -> frozenset[str]:
    """Targets with form errors larger than the given noise that the sigmas do not contain.

    With lines that no other line checks, leave-out results cannot raise the sigmas.
    """
    geometry = result.observability
    if geometry is None or not any(each.kind == "line" for each in geometry.unchecked):
        return frozenset()
    return frozenset(
        each.target
        for each in result.targets
        if _is_rough(each) and form_error_factor(each) > FORM_FACTOR_LIMIT
    )


def _is_rough(target: TargetResidual) -> bool:
    return NOISE_FACTOR_LIMIT < target.noise <= OTHER_SURFACE_FACTOR


def form_error_factor(target: TargetResidual) -> float:
    """Ratio of the noise by form errors to the given one; that of all noise if it is unknown."""
    return target.noise if target.noise_of_form is None else target.noise_of_form


def _noise_message(
    make: Callable[..., Message], code: str, targets: Sequence[TargetResidual],
    factor_of: Callable[[TargetResidual], float],
) -> Message:  # fmt: skip
    worst = max(targets, key=factor_of)
    return make(
        code,
        count=len(targets), targets=shortened_list([t.target for t in targets]),
        factor=float(factor_of(worst)), subject=Cause.of_target(worst.target),
    )  # fmt: skip


def _sighting_item(sighting: Sighting) -> Message:
    """Sighting as an item of a list."""
    return note("item.sighting", target=sighting.target, line=sighting.line)
