"""Shifts of lines on a validation plane, compared with their uncertainty.

The median signed distances between the lines of a plane give the shift of each line from the
others, and that of a group of lines from the others. The first shows an error of one line. The
second shows an error of the boresight, with which the distances on the plane have several modes.
The standard deviation of a shift includes the POS errors of the lines, the covariance of the
boresight, the form error of the surface and the noise, by the general law of propagation of
variances (Mikhail 1976, Observations and Least Squares). POS errors hardly change during one line;
those of two lines are correlated by the time between them.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.point_sensitivity import sensitivity
from lispac.adjustment.result import AdjustmentResult
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES
from lispac.survey.trajectory import Poses
from lispac.validation.absolute_check import NORMAL_QUANTILE_975
from lispac.validation.comparison_results import LineShift, PairComparison, SignedStatistics

Array = NDArray[np.float64]

DIRECTIONS_PER_PLACE = 2
"""Each place is measured from both lines, so that only half of the distances are independent."""


@dataclass(frozen=True, eq=False)
class LineErrors:
    """Effects of the errors of a line on its distances along the normal of a plane.

    Attributes
    ----------
    time : float, seconds
        Median time of the points on the plane.
    duration : float, seconds
        Time from the first to the last of these points.
    by_position, by_attitude : ndarrays of shape (n, 3), metres
        Displacement of n points by an error of one sigma in north, west, up and in roll, pitch,
        heading.
    by_boresight : ndarray of shape (n, e), metres
        Displacement by one sigma of each of e independent combinations of the estimated values.
    surface : float, metres
        Standard deviation of the form error of the surface.
    """

    time: float
    duration: float
    by_position: Array
    by_attitude: Array
    by_boresight: Array
    surface: float

    @classmethod
    def of(
        cls,
        result: AdjustmentResult,
        points_lidar: Array,
        time: Array,
        poses: Poses,
        sigmas: tuple[Array, Array],
        normal: Array,
        *,
        pose_rate: Array | None = None,
    ) -> "LineErrors":
        """Effects of the errors of a line at some of its points.

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        time : ndarray of shape (n,), seconds
        poses : Poses
            Pose of the POS at each point.
        sigmas : pair of ndarrays of shape (n, 3), metres and radians
            Given standard deviations of position and attitude at each point.
        normal : ndarray of shape (3,), unit vector, local frame
        pose_rate : ndarray of shape (n, 6), metres and radians per second, optional
        """
        moves = sensitivity(
            points_lidar, poses, result.mounting,
            np.broadcast_to(normal, (len(points_lidar), 3)), pose_rate=pose_rate,
        )  # fmt: skip
        _, position, attitude = result.sigma_factors
        names, covariance = result.mounting_covariance()
        values, vectors = np.linalg.eigh(covariance)
        mixtures = vectors * np.sqrt(np.maximum(values, 0.0))
        estimated = [MOUNTING_VALUE_NAMES.index(name) for name in names]
        return cls(
            float(np.median(time)),
            float(np.ptp(time)),
            position * moves.by_position * sigmas[0],
            attitude * moves.by_attitude * sigmas[1],
            moves.by_mounting[:, estimated] @ mixtures,
            float(result.surfaces[2]),
        )


@dataclass(frozen=True, eq=False)
class PlaneErrors:
    """Errors of all lines on a plane, and correlation times of position and attitude, seconds."""

    lines: Mapping[str, LineErrors]
    correlation_times: tuple[float, float]

    def covariance(self, lines: Sequence[str]) -> Array:
        """Covariance of the mean displacements of n lines, shape (n, n), square metres."""
        errors = [self.lines[line] for line in lines]
        time = np.array([each.time for each in errors])
        position, attitude, boresight = (
            np.array([getattr(each, name).mean(axis=0) for each in errors])
            for name in ("by_position", "by_attitude", "by_boresight")
        )
        correlations = [
            np.exp(-np.abs(time[:, None] - time) / tau) for tau in self.correlation_times
        ]
        return np.asarray(
            correlations[0] * (position @ position.T)
            + correlations[1] * (attitude @ attitude.T)
            + boresight @ boresight.T
            + np.diag([each.surface**2 for each in errors])
        )

    def variation(self, line: str) -> float:
        """Standard deviation of the largest change of a line's displacement over the plane, metres.

        Includes the change of the POS errors with time and that of their effects, and of the effect
        of the boresight, with place.
        """
        errors = self.lines[line]
        variance = 0.0
        for effects, tau in zip(
            (errors.by_position, errors.by_attitude), self.correlation_times, strict=True
        ):
            change = 2.0 * (1.0 - np.exp(-errors.duration / tau))
            variance += change * float((effects**2).max(axis=0).sum())
        for effects in (errors.by_position, errors.by_attitude, errors.by_boresight):
            variance += float((np.ptp(effects, axis=0) ** 2).sum())
        return sqrt(variance)


def line_shifts(pairs: Iterable[PairComparison], errors: PlaneErrors) -> tuple[LineShift, ...]:
    """Shifts of each line from the others on a plane, then of groups of several lines.

    The groups are the possible divisions of the lines in the order of their offsets.

    Parameters
    ----------
    pairs : compared pairs of lines; those without signed distances are not used
    """
    known = [
        (pair, pair.after.signed)
        for pair in pairs
        if pair.after.signed is not None and {pair.line_a, pair.line_b} <= errors.lines.keys()
    ]
    lines = list(dict.fromkeys(line for pair, _ in known for line in (pair.line_a, pair.line_b)))
    single = {line: _shift_of({line}, known, errors) for line in lines}
    ordered = sorted(lines, key=lambda line: single[line].offset)
    groups = [
        _shift_of(set(ordered[size:]), known, errors)
        for size in range(2, len(ordered) - 1)
        if _crossing(set(ordered[size:]), known)
    ]
    # Of two lines, both have the same shift.
    return (*(single[line] for line in lines[: 1 if len(lines) == 2 else None]), *groups)


def _is_reciprocal(group: set[str], pairs: Sequence[PairComparison]) -> bool:
    """Whether a group has all lines in one direction, and its complement those in the other."""
    reciprocal = [pair for pair in pairs if pair.reciprocal]
    lines = {line for pair in pairs for line in (pair.line_a, pair.line_b)}
    with_other = {line for pair in reciprocal for line in (pair.line_a, pair.line_b)}
    return lines == with_other and all(
        (pair.line_a in group) != (pair.line_b in group) for pair in reciprocal
    )


def _crossing(
    group: set[str], known: Sequence[tuple[PairComparison, SignedStatistics]]
) -> list[tuple[PairComparison, SignedStatistics]]:
    """Pairs of a line of the group and another one."""
    return [each for each in known if (each[0].line_a in group) != (each[0].line_b in group)]


def _shift_of(
    group: set[str], known: Sequence[tuple[PairComparison, SignedStatistics]], errors: PlaneErrors
) -> LineShift:
    """Mean distance of the lines of a group from the others, over all pairs with one of each."""
    pairs = _crossing(group, known)
    lines = list(dict.fromkeys(line for pair, _ in pairs for line in (pair.line_a, pair.line_b)))
    weights, offset, noise = np.zeros(len(lines)), 0.0, 0.0
    for pair, signed in pairs:
        sign = 1.0 if pair.line_a in group else -1.0
        offset += sign * signed.median / len(pairs)
        weights[lines.index(pair.line_a)] += sign / len(pairs)
        weights[lines.index(pair.line_b)] -= sign / len(pairs)
        noise += (sigma_of_median(signed) / len(pairs)) ** 2
    variance = float(weights @ errors.covariance(lines) @ weights) + noise
    in_order = dict.fromkeys(line for pair, _ in known for line in (pair.line_a, pair.line_b))
    return LineShift(
        tuple(line for line in in_order if line in lines and line in group),
        tuple(line for line in in_order if line in lines and line not in group),
        offset,
        sqrt(max(variance, 0.0)),
        _is_reciprocal(group, [pair for pair, _ in known]),
    )


def sigma_of_median(signed: SignedStatistics) -> float:
    """Standard deviation of the median of signed distances due to their scatter, metres."""
    scatter = max(signed.robust_sigma, signed.half_width / NORMAL_QUANTILE_975)
    # Kendall and Stuart: the median of normal values has pi / 2 times the variance of the mean.
    return scatter * sqrt(pi / 2.0 / max(signed.n / DIRECTIONS_PER_PLACE, 1.0))
