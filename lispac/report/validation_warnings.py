"""Warnings about the acceptance of a calibration, and about distributions of distances."""

from collections.abc import Iterator, Sequence
from math import radians

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.messages import Message, note, warning
from lispac.present.acceptance import AcceptanceCheckValues, AcceptanceValues
from lispac.present.validation import LineShiftValues, ValidationPlane
from lispac.warning_causes import RESULT_CAUSE, Cause

VALIDATE_STEP = Cause.of_step("Validate")
FALSE_WARNING_LEVEL = 0.01
"""Probability of any warning about the distances on the planes of a project without errors."""


def acceptance_warnings(values: AcceptanceValues) -> Iterator[Message]:
    """Warnings about criteria that are not met, and notes on what is not judged."""
    for check in values.checks:
        if check.verdict == "fail":
            yield _failure(check)
    unknown = [check for check in values.checks if check.verdict == "not judged"]
    if unknown:
        planes = tuple(dict.fromkeys(check.plane for check in unknown if check.plane))
        if planes:
            yield note("acceptance.planes_not_judged", planes=planes, subject=VALIDATE_STEP)
        else:
            yield note("acceptance.not_judged", subject=VALIDATE_STEP)
    missing = values.criteria.missing
    if values.checks and missing:
        criteria = tuple(note(f"acceptance_field.{name}") for name in missing)
        yield note("acceptance.criteria_missing", criteria=criteria, subject=VALIDATE_STEP)


def _failure(check: AcceptanceCheckValues) -> Message:
    assert check.value is not None
    if check.unit == "deg":
        return warning(
            "acceptance.angle_sigma",
            angle=mounting_value_name(check.quantity), sigma=radians(check.value),
            limit=radians(check.limit), subject=RESULT_CAUSE,
        )  # fmt: skip
    where = Cause.of_target(check.plane)
    if check.quantity == "rms":
        return warning(
            "acceptance.rms", target=check.plane, rms=check.value, limit=check.limit, subject=where
        )
    line, other = check.lines
    return warning(
        "acceptance.offset",
        target=check.plane, line=line, other=other, offset=check.value, limit=check.limit,
        subject=where,
    )  # fmt: skip


def distribution_warnings(planes: Sequence[ValidationPlane]) -> Iterator[Message]:
    """Warnings about shifted lines and distances with two modes on validation planes.

    All tests together have the significance level `FALSE_WARNING_LEVEL` (Bonferroni). Of the shifts
    on a plane, which are caused by the same errors, only the most significant one is reported.
    """
    from scipy.special import ndtri

    tests = sum(_possible_groups(plane) + len(plane.pairs) for plane in planes if plane.shifts)
    if not tests:
        return
    level = FALSE_WARNING_LEVEL / tests
    limit = -float(ndtri(level / 2.0))
    for plane in planes:
        where = Cause.of_target(plane.name)
        significant = [each for each in plane.shifts if abs(each.offset_m) > limit * each.sigma_m]
        if significant:
            yield _shift_warning(plane.name, max(significant, key=_significance), limit)
        for pair in plane.pairs:
            modes = pair.modes
            if modes is not None and (
                modes.probability < level and modes.distance_m > limit * modes.sigma_m
            ):
                yield warning(
                    "validation.two_modes",
                    target=plane.name, line=pair.line_a, other=pair.line_b,
                    distance=modes.distance_m, share=modes.share, limit=limit * modes.sigma_m,
                    subject=where,
                )  # fmt: skip


def _possible_groups(plane: ValidationPlane) -> int:
    """Number of ways to divide the lines of a plane into two groups, of which some were tested."""
    lines = {line for shift in plane.shifts for line in (*shift.lines, *shift.others)}
    return int(2 ** (len(lines) - 1)) - 1


def _significance(shift: LineShiftValues) -> float:
    return abs(shift.offset_m) / shift.sigma_m if shift.sigma_m else float("inf")


def _shift_warning(plane: str, shift: LineShiftValues, limit: float) -> Message:
    offset, explained = abs(shift.offset_m), limit * shift.sigma_m
    if len(shift.lines) > 1 or shift.reciprocal:
        return warning(
            "validation.directions_shifted" if shift.reciprocal else "validation.groups_shifted",
            target=plane, lines=shift.lines, others=shift.others, offset=offset, limit=explained,
            subject=Cause.of_target(plane),
        )  # fmt: skip
    (line,) = shift.lines
    return warning(
        "validation.line_shifted",
        target=plane, line=line, others=shift.others, offset=offset, limit=explained,
        subject=Cause.of_target(plane),
    )  # fmt: skip
