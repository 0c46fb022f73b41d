"""Result of an adjustment, as text and as JSON values."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from lispac.adjustment.display_text import (
    OUTPUT_UNITS,
    QUANTITIES,
    number_with_noun,
    to_plain_text,
    variance_component_finding,
)
from lispac.adjustment.parameters import ParameterEstimate
from lispac.adjustment.result import (
    ANGLES,
    AdjustmentResult,
    ContradictedParameter,
    CrossChecks,
    PossibleCause,
    SightingReliability,
    VarianceComponent,
)
from lispac.adjustment.warnings import result_warnings
from lispac.cli.messages import warnings_as_json
from lispac.duplicate_targets import project_warnings
from lispac.message_texts import english_text, message_text
from lispac.messages import Message
from lispac.project import Project
from lispac.survey.conventions.mounting_texts import orientation_text

LABEL = 29
"""Characters before the numbers."""
SIGNIFICANCE = {
    True: "significant",
    False: "not significant",
    None: "not tested: with uncorrelated POS errors the sigmas are too small",
}
"""Whether the change of a value is significant; None where it is not tested."""


def _values_by_angle(values: Iterable[float] | None) -> dict[str, float] | None:
    if values is None:
        return None
    return {name: float(value) for name, value in zip(ANGLES, values, strict=True)}


def _degrees_by_angle(values: Any) -> dict[str, float] | None:
    return None if values is None else _values_by_angle(np.degrees(values))


def project_result_values(project: Project) -> dict[str, Any]:
    """Result of a project as plain values, in degrees and metres."""
    assert project.result is not None
    values = result_values(project.result, project.cross_checks, project_warnings(project))
    return values | {"subsample_m": project.settings.subsample}


def result_values(
    result: AdjustmentResult, checks: CrossChecks | None, also: Sequence[Message] = ()
) -> dict[str, Any]:
    """Result of an adjustment as plain values, in degrees and metres."""
    chi_square, seen = result.chi_square, result.observability
    return {
        "boresight_deg": _degrees_by_angle(result.angles),
        "rotation_body_lidar": result.mounting.rotation_body_lidar.tolist(),
        "sigma_about": "body axes" if result.mounting.axes is not None else "roll, pitch, yaw",
        "sigma_deg": _degrees_by_angle(result.sigma),
        "correlation": result.correlation.tolist(),
        "variance_factor": result.variance_factor,
        "chi_square": {
            "statistic": chi_square.statistic,
            "lower": chi_square.lower,
            "upper": chi_square.upper,
            "passed": chi_square.passed,
        },
        "iterations": result.iterations,
        "points": result.points,
        "excluded_outliers": result.excluded_outliers,
        "sightings": len(result.sightings),
        "planes": len(result.targets),
        "elapsed_s": result.elapsed,
        "pos_errors": result.model.pos_errors,
        "loss": result.model.loss,
        "surface_sigma_m": result.surface,
        "offset_sigma_m": result.offset,
        "noise_factor": result.noise_factors,
        "prior_boresight_deg": _degrees_by_angle(result.prior_angles),
        "joint_plane_rms_m": {"before": result.rms_before, "after": result.rms_after},
        "parameters": {p.name: _parameter_values(p) for p in result.parameters},
        "observability": seen
        and {
            "condition": seen.condition,
            "direction_sigma_deg": np.degrees(seen.eigenvalues**-0.5).tolist(),
            "messages": [english_text(each) for each in seen.messages],
        },
        "reliability": [_reliability_values(item) for item in result.reliability],
        "contradictions": [_contradiction_values(found) for found in result.contradictions],
        "causes": [[_cause_values(each) for each in group] for group in result.causes or ()],
        "rejected_sightings": [f"{s.target} on {s.line}" for s in result.rejected_sightings],
        "components": {
            c.name: {
                "factor": c.factor,
                "lower": c.lower,
                "upper": c.upper,
                "applied": c.applied,
            }
            for c in result.components
        },
        "cross_checks": checks and _cross_check_values(checks),
        "warnings": warnings_as_json(result_warnings(result, checks, also)),
    }


def _parameter_values(estimate: ParameterEstimate) -> dict[str, Any]:
    factor, unit = OUTPUT_UNITS[estimate.name]

    def shown(value: float | None) -> float | None:
        return None if value is None else factor * value

    return {
        "unit": unit,
        "prior": shown(estimate.prior),
        "prior_sigma": shown(estimate.prior_sigma),
        "value": shown(estimate.value),
        "sigma": shown(estimate.sigma),
        "significance": estimate.significance,
        "significant": estimate.significant,
        "reason": "" if estimate.reason is None else english_text(estimate.reason),
    }


def _contradiction_values(parameter: ContradictedParameter) -> dict[str, Any]:
    factor, unit = OUTPUT_UNITS[parameter.name]
    return {
        "name": parameter.name,
        "unit": unit,
        "change": factor * parameter.change,
        "sigma": factor * parameter.sigma,
        "w": parameter.w,
        "angle_change_deg": _degrees_by_angle(parameter.angle_change),
        "surface_sigma_m": parameter.surface_sigma,
    }


def _cause_values(cause: PossibleCause) -> dict[str, Any]:
    factor, unit = OUTPUT_UNITS.get(cause.kind, (1.0, "m"))
    if cause.kind == "line_time":
        factor, unit = OUTPUT_UNITS["latency"]
    elif cause.kind == "line_boresight":
        factor, unit = float(np.degrees(1.0)), "deg"
    return {
        "kind": cause.kind,
        "target": cause.target or None,
        "line": cause.line or None,
        "unit": unit,
        "size": (factor * cause.size).tolist(),
        "sigma": (factor * cause.sigma).tolist(),
        "angle_change_deg": _degrees_by_angle(cause.angle_change),
        "effect_m": cause.effect,
        "evidence": cause.evidence,
    }


def _reliability_values(item: SightingReliability) -> dict[str, Any]:
    return {
        "target": item.sighting.target,
        "line": item.sighting.line,
        "shift_m": item.shift,
        "w": item.w,
        "detectable_m": item.detectable,
        "effect_deg": _degrees_by_angle(item.effect),
        "redundancy": item.redundancy,
        "outliers": item.outliers,
        "largest_w": item.largest_w,
        "largest_w_time_s": item.largest_at,
        "rejected": item.rejected,
    }


def _cross_check_values(checks: CrossChecks) -> dict[str, Any]:
    return {
        "spread_lines_deg": _degrees_by_angle(checks.spread_lines),
        "spread_targets_deg": _degrees_by_angle(checks.spread_targets),
        "parts": [
            {
                "kind": part.kind,
                "part": part.part,
                "boresight_deg": _degrees_by_angle(part.boresight),
                "difference_deg": _degrees_by_angle(part.difference),
                "significance": _values_by_angle(part.significance),
                "disagrees": part.disagrees,
                "reason": "" if part.reason is None else english_text(part.reason),
            }
            for part in checks.parts
        ],
    }


def print_result(
    result: AdjustmentResult, checks: CrossChecks | None, also: Sequence[Message] = ()
) -> None:
    """Print the result of an adjustment as text."""
    chi_square = result.chi_square
    size = "large" if chi_square.statistic < chi_square.lower else "small"
    verdict = "passed" if chi_square.passed else f"failed, the given sigmas are too {size}"
    print(f"{'degrees':{LABEL}s}" + "".join(f"{name:>12s}" for name in ANGLES))
    rows = {
        "prior": np.degrees(result.prior_angles),
        "boresight": np.degrees(result.angles),
        "sigma": np.degrees(result.sigma),
        "95 %": 1.96 * np.degrees(result.sigma),
    }
    if checks is not None:
        for name, spread in (
            ("Spread, one line omitted", checks.spread_lines),
            ("Spread, one target omitted", checks.spread_targets),
        ):  # fmt: skip
            if spread is not None:
                rows[name] = np.degrees(spread)
    for name, values in rows.items():
        sign = "+" if name in ("prior", "boresight") else ""
        print(f"{name:{LABEL}s}" + "".join(f"{value:{sign}12.4f}" for value in values))
    if result.mounting.axes is not None:
        print_steep_rotation(result)
    for estimate in result.parameters:
        print(_parameter_line(estimate))
    outliers = (
        f" ({number_with_noun(result.excluded_outliers, 'outlier')} excluded)"
        if result.excluded_outliers
        else ""
    )
    print(
        f"POS errors {_error_model_text(result)}; "
        f"{number_with_noun(result.points, 'point')}{outliers}, "
        f"{number_with_noun(len(result.sightings), 'sighting')}, "
        f"{number_with_noun(len(result.targets), 'target')}, "
        f"{number_with_noun(result.iterations, 'iteration')}, {result.elapsed:.3f} s"
    )
    print(
        f"variance factor {result.variance_factor:.3f}, chi-square {chi_square.statistic:.1f} "
        f"({chi_square.lower:.1f} to {chi_square.upper:.1f}: {verdict})"
    )
    print(
        f"RMS distance from the target surfaces {result.rms_before * 1000:.1f} mm before, "
        f"{result.rms_after * 1000:.1f} mm after"
    )
    for component in result.components:
        print(_component_line(component))
    for each in result.observability.messages if result.observability else ():
        print(to_plain_text(message_text(each)))
    found = result_warnings(result, checks, also)
    if found:
        print("\nWarnings and notes:")
    for message in found:
        print(f"- {to_plain_text(message_text(message))}")


def print_steep_rotation(result: AdjustmentResult) -> None:
    """Print the rotation matrix for a steep pitch, where roll and yaw are nearly dependent."""
    print(
        "The pitch is near 90 deg: roll and yaw are hardly separable. The sigmas are those of "
        "small rotations about the body axes (forward, left, down)."
    )
    print(f"Orientation: {orientation_text(result.angles)}")
    print("Rotation matrix, LiDAR to body (forward, left, up):")
    for row in result.mounting.rotation_body_lidar:
        print("".join(f"{value:+14.8f}" for value in row))


def _error_model_text(result: AdjustmentResult) -> str:
    model = result.model
    if not model.correlated:
        return f"uncorrelated (classical), loss {model.loss}"
    return (
        f"correlated over {model.position_time:g} s (position) and {model.attitude_time:g} s "
        f"(attitude), loss {model.loss}"
    )


def _parameter_line(estimate: ParameterEstimate) -> str:
    shown = QUANTITIES[estimate.name]
    factor, places = shown.factor, f".{shown.decimals}f"
    if estimate.value is None or estimate.sigma is None:
        return "" if estimate.reason is None else to_plain_text(message_text(estimate.reason))
    return (
        f"{shown.title} {factor * estimate.value:+{places}} {shown.unit}, "
        f"sigma {factor * estimate.sigma:{places}}, prior {factor * estimate.prior:+{places}}: "
        f"{SIGNIFICANCE[estimate.significant]}"
    )


def _component_line(component: VarianceComponent) -> str:
    return (
        f"{component.name} sigmas multiplied by {component.factor:.2f} (95 % interval "
        f"{component.lower:.2f} to {component.upper:.2f}), "
        f"{message_text(variance_component_finding(component))}"
    )
