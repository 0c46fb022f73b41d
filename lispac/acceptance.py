"""Acceptance criteria of a calibration, and the judgement of its results by them."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.identity import MAX_FIELD_LENGTH, cleaned_text
from lispac.messages import error, note
from lispac.validation.comparison_results import PlaneComparison

Verdict = Literal["pass", "fail", "not judged"]
Quantity = Literal["roll", "pitch", "yaw", "rms", "p95", "offset"]
PLANE_QUANTITIES: tuple[Quantity, ...] = ("rms", "p95", "offset")
"""Judged values of a validation plane."""

ANGLE_LIMITS_DEG, LENGTH_LIMITS_M = (1e-6, 10.0), (1e-5, 10.0)
"""Smallest and largest accepted criterion: standard deviations, degrees; distances, metres."""


@dataclass(frozen=True)
class AcceptanceCriteria:
    """Largest values with which a calibration is accepted; None if a value is not judged.

    Attributes
    ----------
    roll_sigma_deg, pitch_sigma_deg, yaw_sigma_deg : float, degrees, optional
        Standard deviation of each estimated angle.
    rms : float, metres, optional
        RMS of the distances between the lines on each validation plane after the calibration, as in
        `PlaneComparison.after`.
    p95 : float, metres, optional
        95th percentile of the same distances.
    offset : float, metres, optional
        Absolute value of the median signed distance between two lines on each validation plane
        after the calibration, as in `SignedStatistics`, for every pair of lines.
    source : str
        Document that gives the criteria, such as a contract or a standard.
    """

    roll_sigma_deg: float | None = None
    pitch_sigma_deg: float | None = None
    yaw_sigma_deg: float | None = None
    rms: float | None = None
    p95: float | None = None
    offset: float | None = None
    source: str = ""

    @property
    def is_empty(self) -> bool:
        """Whether no value is judged."""
        return all(getattr(self, name) is None for name in LIMIT_NAMES)

    def changed(self, **values: float | str | None) -> "AcceptanceCriteria":
        """Copy with the given values.

        Raises
        ------
        InputError
            If a limit is not positive or too large, or the source cannot be printed in a report.
        """
        edited = replace(self, **values)  # type: ignore[arg-type]
        field = note("acceptance_field.source")
        source = cleaned_text(field, edited.source, longest=MAX_FIELD_LENGTH)
        edited = replace(edited, source=source)
        edited.require_sound()
        return edited

    def require_sound(self) -> None:
        """Refuse values that `changed` would refuse.

        Raises
        ------
        InputError
            If a limit is not positive or too large, or the source cannot be printed in a report.
        """
        cleaned_text(note("acceptance_field.source"), self.source, longest=MAX_FIELD_LENGTH)
        for name in LIMIT_NAMES:
            value = getattr(self, name)
            is_angle = name.endswith("_deg")
            low, high = ANGLE_LIMITS_DEG if is_angle else LENGTH_LIMITS_M
            if value is None or low <= value <= high:
                continue
            shown = np.radians((value, low, high)) if is_angle else (value, low, high)
            value, low, high = map(float, shown)
            raise InputError(
                error(
                    "settings.angle_out_of_range" if is_angle else "settings.length_out_of_range",
                    setting=note(f"acceptance_field.{name.removesuffix('_deg')}"),
                    value=value, least=low, most=high,
                )
            )  # fmt: skip


NO_CRITERIA = AcceptanceCriteria()
FIELD_NAMES = tuple(field.name for field in fields(AcceptanceCriteria))
LIMIT_NAMES = FIELD_NAMES[:-1]


@dataclass(frozen=True)
class AcceptanceCheck:
    """One value of a calibration and its limit.

    Attributes
    ----------
    quantity : str
        An angle, or ``rms``, ``p95`` or ``offset`` of a validation plane.
    limit : float
    value : float or None
        Degrees for angles, metres otherwise; None if there are not enough data.
    plane : str
        Validation plane; empty for angles, and if no plane has been compared.
    lines : tuple of str
        Pair of lines with the largest offset.
    """

    quantity: Quantity
    limit: float
    value: float | None
    plane: str = ""
    lines: tuple[str, ...] = ()

    @property
    def verdict(self) -> Verdict:
        """Whether the value is within its limit."""
        if self.value is None:
            return "not judged"
        return "pass" if self.value <= self.limit else "fail"


@dataclass(frozen=True)
class Acceptance:
    """Judgement of a calibration by its acceptance criteria.

    Attributes
    ----------
    criteria : AcceptanceCriteria
    checks : tuple of AcceptanceCheck
        Empty without criteria.
    planes : tuple of str
        Names of the validation planes, with those that could not be compared.
    excluded : tuple of str
        Names of the validation planes that the user excluded; the verdict does not include them.
    """

    criteria: AcceptanceCriteria
    checks: tuple[AcceptanceCheck, ...]
    planes: tuple[str, ...]
    excluded: tuple[str, ...] = ()

    @property
    def verdict(self) -> Verdict:
        """Verdict on the calibration: passed only if all criteria could be judged."""
        return _joint_verdict(self.checks)

    def verdict_on(self, plane: str) -> Verdict:
        """Verdict on a validation plane."""
        return _joint_verdict([each for each in self.checks if each.plane == plane])


def _joint_verdict(checks: Sequence[AcceptanceCheck]) -> Verdict:
    verdicts = {check.verdict for check in checks}
    if "fail" in verdicts:
        return "fail"
    return "pass" if verdicts == {"pass"} else "not judged"


def judge_calibration(
    criteria: AcceptanceCriteria,
    sigma: NDArray[np.float64] | None,
    validation: Sequence[PlaneComparison],
    not_compared: Iterable[str] = (),
    excluded: Iterable[str] = (),
) -> Acceptance:
    """Judge a calibration by its acceptance criteria.

    Parameters
    ----------
    sigma : ndarray of shape (3,), radians
        Standard deviations of the estimated roll, pitch, yaw; None if nothing is estimated.
    not_compared : names of the validation planes that could not be compared
    excluded : names of the validation planes that are not used
    """
    checks = []
    sigmas_deg = [None] * 3 if sigma is None else np.degrees(sigma).tolist()
    angles: tuple[Quantity, ...] = ("roll", "pitch", "yaw")
    for angle, value in zip(angles, sigmas_deg, strict=True):
        limit = getattr(criteria, f"{angle}_sigma_deg")
        if limit is not None:
            checks.append(AcceptanceCheck(angle, limit, value))
    others = tuple(not_compared)
    for plane in validation:
        checks += _plane_checks(criteria, plane)
    for name in others if validation or others else ("",):
        for quantity in PLANE_QUANTITIES:
            limit = getattr(criteria, quantity)
            if limit is not None:
                checks.append(AcceptanceCheck(quantity, limit, None, name))
    names = (*(plane.name for plane in validation), *others)
    return Acceptance(criteria, tuple(checks), names, tuple(excluded))


def _plane_checks(criteria: AcceptanceCriteria, plane: PlaneComparison) -> list[AcceptanceCheck]:
    checks = []
    if criteria.rms is not None:
        checks.append(AcceptanceCheck("rms", criteria.rms, plane.after.rms, plane.name))
    if criteria.p95 is not None:
        checks.append(AcceptanceCheck("p95", criteria.p95, plane.after.p95, plane.name))
    if criteria.offset is not None:
        largest = largest_offset(plane)
        known = [pair for pair in plane.pairs if pair.after.signed is not None]
        if largest is not None:
            value, lines = largest
            checks.append(AcceptanceCheck("offset", criteria.offset, value, plane.name, lines))
        judged = {line for pair in known for line in (pair.line_a, pair.line_b)}
        if not known or any(not {p.line_a, p.line_b} <= judged for p in plane.pairs):
            # A pair may lack common points if both lines are compared with others
            checks.append(AcceptanceCheck("offset", criteria.offset, None, plane.name))
    return checks


def largest_offset(plane: PlaneComparison) -> tuple[float, tuple[str, str]] | None:
    """Largest offset of two lines on a plane after the calibration, metres, and the two lines.

    None if no pair of lines has enough points in common.
    """
    offsets = [
        (abs(pair.after.signed.median), (pair.line_a, pair.line_b))
        for pair in plane.pairs
        if pair.after.signed is not None
    ]
    return max(offsets, key=lambda each: each[0], default=None)


def planes_to_show(rms: Mapping[str, float], failed: Collection[str], count: int) -> frozenset[str]:
    """Names of up to ``count`` validation planes with which to judge a calibration.

    Planes that failed come before all others, planes with a larger RMS before those with a smaller.

    Parameters
    ----------
    rms : mapping from the names of the planes to their RMS after the calibration, metres
    failed : names of the planes that failed
    """
    order = sorted(rms, key=lambda name: (name in failed, rms[name]), reverse=True)
    return frozenset(order[:count])
