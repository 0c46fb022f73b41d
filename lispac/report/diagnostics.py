"""Diagnostics of an adjustment as values of a report: parameters, observability, checks."""

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

from lispac.adjustment.diagnostics.findings import (
    UNCHECKED_SHIFT,
    critical_test_value,
    sighting_status,
    variance_component_finding,
)
from lispac.adjustment.model.parameters import OUTPUT_UNITS
from lispac.adjustment.result import (
    AdjustmentResult,
    CrossCheck,
    CrossChecks,
    Observability,
    SightingReliability,
)
from lispac.report.report_values import (
    AdditionalParameterValues,
    CrossCheckPart,
    CrossCheckValues,
    ObservabilityValues,
    SightingCheck,
    VarianceComponent,
)


def finite_or_none(value: float) -> float | None:
    """The value, or None if it is not a number: JSON has no NaN."""
    return float(value) if math.isfinite(value) else None


def parameter_values(result: AdjustmentResult) -> tuple[AdditionalParameterValues, ...]:
    """Results of the values selected for estimation besides the boresight."""
    found = []
    for estimate in result.parameters:
        factor, unit = OUTPUT_UNITS[estimate.name]
        significance = estimate.significance
        found.append(
            AdditionalParameterValues(
                name=estimate.name,
                unit=unit,
                prior=factor * estimate.prior,
                prior_sigma=_multiply_known(factor, estimate.prior_sigma),
                value=_multiply_known(factor, estimate.value),
                sigma=_multiply_known(factor, estimate.sigma),
                significance=None if significance is None else finite_or_none(significance),
                significant=estimate.significant,
                reason=estimate.reason or "",
            )
        )
    return tuple(found)


def _multiply_known(factor: float, value: float | None) -> float | None:
    return None if value is None else factor * value


def observability_values(observability: Observability | None) -> ObservabilityValues | None:
    """Observability of the angles."""
    if observability is None:
        return None
    return ObservabilityValues(
        direction_sigma_deg=_to_degrees(observability.eigenvalues**-0.5),
        directions=tuple(_as_floats(column) for column in observability.directions.T),
        condition=finite_or_none(observability.condition),
        sigma_without_line_deg={
            line: None if sigma is None else _to_degrees(sigma)
            for line, sigma in observability.sigma_without_line.items()
        },
        messages=observability.messages,
    )


def component_values(result: AdjustmentResult) -> tuple[VarianceComponent, ...]:
    """Variance components of the groups of errors."""
    return tuple(
        VarianceComponent(
            c.name, c.factor, c.lower, c.upper, c.applied, variance_component_finding(c)
        )
        for c in result.components
    )


def reliability_values(result: AdjustmentResult) -> tuple[SightingCheck, ...]:
    """Tests of every sighting; none with independent POS errors."""
    critical = critical_test_value(result) or math.inf
    points = {(s.sighting.target, s.sighting.line): s.points for s in result.sightings}
    return tuple(
        _sighting_check(item, points[item.sighting.target, item.sighting.line], critical)
        for item in result.reliability
    )


def _sighting_check(item: SightingReliability, points: int, critical: float) -> SightingCheck:
    checked = bool(item.detectable < UNCHECKED_SHIFT)
    return SightingCheck(
        target=item.sighting.target,
        line=item.sighting.line,
        points=points,
        shift_m=item.shift if checked else None,
        w=item.w if checked else None,
        detectable_m=item.detectable if checked else None,
        effect_deg=_to_degrees(item.effect) if checked else None,
        redundancy=item.redundancy,
        outliers=item.outliers,
        largest_w=item.largest_w,
        largest_w_time_s=item.largest_at,
        point_detectable_m=finite_or_none(item.point_detectable),
        weight=item.weight,
        rejected=item.rejected,
        status=sighting_status(item, critical),
        pos_error_m=_as_floats(item.pos_error[:3]),
        pos_sigma_m=_as_floats(item.pos_sigma[:3]),
        pos_sigma_after_m=_as_floats(item.pos_sigma_after[:3]),
        pos_error_deg=_to_degrees(item.pos_error[3:]),
        pos_sigma_deg=_to_degrees(item.pos_sigma[3:]),
        pos_sigma_after_deg=_to_degrees(item.pos_sigma_after[3:]),
    )


def cross_check_values(checks: CrossChecks | None) -> CrossCheckValues | None:
    """Results of the cross-checks with subsets of the data."""
    if checks is None:
        return None
    return CrossCheckValues(
        sigma_deg=_to_degrees(checks.sigma),
        spread_lines_deg=_degrees_or_none(checks.spread_lines),
        spread_targets_deg=_degrees_or_none(checks.spread_targets),
        parts=tuple(_part_values(part) for part in checks.parts),
    )


def _part_values(part: CrossCheck) -> CrossCheckPart:
    return CrossCheckPart(
        kind=part.kind,
        part=part.part,
        boresight_deg=_degrees_or_none(part.boresight),
        sigma_deg=_degrees_or_none(part.sigma),
        difference_deg=_degrees_or_none(part.difference),
        significance=None if part.significance is None else _as_floats(part.significance),
        disagrees=part.disagrees,
        reason=part.reason or "",
    )


def _as_floats(values: Iterable[float]) -> tuple[float, ...]:
    return tuple(float(value) for value in values)


def _to_degrees(values: ArrayLike) -> tuple[float, ...]:
    return _as_floats(np.degrees(values))


def _degrees_or_none(values: ArrayLike | None) -> tuple[float, ...] | None:
    return None if values is None else _to_degrees(values)
