"""Diagnostics of an adjustment as values of a report: parameters, observability, checks."""

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

from lispac.adjustment.critical import critical_w
from lispac.adjustment.result import (
    AdjustmentResult,
    CrossCheck,
    CrossChecks,
    Observability,
    SightingReliability,
)
from lispac.adjustment.shown import STATED, UNCHECKED, component_finding, standing
from lispac.report.values import (
    CheckedPart,
    CrossChecked,
    ExtraParameter,
    ObservabilityValues,
    SightingCheck,
    VarianceComponent,
)


def number(value: float) -> float | None:
    """The value, or None where it is not a number: JSON has no NaN."""
    return float(value) if math.isfinite(value) else None


def parameters_of(result: AdjustmentResult) -> tuple[ExtraParameter, ...]:
    """Results of the values selected for estimation besides the boresight."""
    found = []
    for estimate in result.parameters:
        factor, unit = STATED[estimate.name]
        significance = estimate.significance
        found.append(
            ExtraParameter(
                name=estimate.name,
                unit=unit,
                prior=factor * estimate.prior,
                prior_sigma=_times(factor, estimate.prior_sigma),
                value=_times(factor, estimate.value),
                sigma=_times(factor, estimate.sigma),
                significance=None if significance is None else number(significance),
                significant=estimate.significant,
                reason=estimate.reason or "",
            )
        )
    return tuple(found)


def _times(factor: float, value: float | None) -> float | None:
    return None if value is None else factor * value


def seen(observability: Observability | None) -> ObservabilityValues | None:
    """Observability of the angles."""
    if observability is None:
        return None
    return ObservabilityValues(
        direction_sigma_deg=_degrees(observability.eigenvalues**-0.5),
        directions=tuple(_floats(column) for column in observability.directions.T),
        condition=number(observability.condition),
        sigma_without_line_deg={
            line: None if sigma is None else _degrees(sigma)
            for line, sigma in observability.sigma_without_line.items()
        },
        in_words=observability.remarks,
    )


def components_of(result: AdjustmentResult) -> tuple[VarianceComponent, ...]:
    """Variance components of the groups of errors."""
    return tuple(
        VarianceComponent(c.name, c.factor, c.lower, c.upper, c.applied, component_finding(c))
        for c in result.components
    )


def reliability_of(result: AdjustmentResult) -> tuple[SightingCheck, ...]:
    """Tests of every sighting; none in thesis mode."""
    critical = critical_w(result) or math.inf
    points = {(s.sighting.target, s.sighting.line): s.points for s in result.sightings}
    return tuple(
        _sighting(item, points[item.sighting.target, item.sighting.line], critical)
        for item in result.reliability
    )


def _sighting(item: SightingReliability, points: int, critical: float) -> SightingCheck:
    checked = bool(item.detectable < UNCHECKED)
    return SightingCheck(
        target=item.sighting.target,
        line=item.sighting.line,
        points=points,
        shift_m=item.shift if checked else None,
        w=item.w if checked else None,
        detectable_m=item.detectable if checked else None,
        effect_deg=_degrees(item.effect) if checked else None,
        redundancy=item.redundancy,
        strays=item.strays,
        largest_w=item.largest_w,
        largest_w_time_s=item.largest_at,
        point_detectable_m=number(item.point_detectable),
        weight=item.weight,
        released=item.released,
        in_words=standing(item, critical),
        pos_error_m=_floats(item.pos_error[:3]),
        pos_sigma_m=_floats(item.pos_sigma[:3]),
        pos_sigma_after_m=_floats(item.pos_sigma_after[:3]),
        pos_error_deg=_degrees(item.pos_error[3:]),
        pos_sigma_deg=_degrees(item.pos_sigma[3:]),
        pos_sigma_after_deg=_degrees(item.pos_sigma_after[3:]),
    )


def cross_checked(checks: CrossChecks | None) -> CrossChecked | None:
    """Results of parts of the data."""
    if checks is None:
        return None
    return CrossChecked(
        sigma_deg=_degrees(checks.sigma),
        spread_lines_deg=_known_degrees(checks.spread_lines),
        spread_targets_deg=_known_degrees(checks.spread_targets),
        parts=tuple(_part(part) for part in checks.parts),
    )


def _part(part: CrossCheck) -> CheckedPart:
    return CheckedPart(
        kind=part.kind,
        part=part.without,
        boresight_deg=_known_degrees(part.boresight),
        sigma_deg=_known_degrees(part.sigma),
        difference_deg=_known_degrees(part.difference),
        significance=None if part.significance is None else _floats(part.significance),
        disagrees=part.disagrees,
        reason=part.reason or "",
    )


def _floats(values: Iterable[float]) -> tuple[float, ...]:
    return tuple(float(value) for value in values)


def _degrees(values: ArrayLike) -> tuple[float, ...]:
    return _floats(np.degrees(values))


def _known_degrees(values: ArrayLike | None) -> tuple[float, ...] | None:
    return None if values is None else _degrees(values)
