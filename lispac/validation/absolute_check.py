"""Distances of the lines from an independent reference, and possible causes.

A comparison between lines reveals only their differences. A comparison with a static scan or with
surveyed points also reveals errors that all lines have in common, but it includes the errors of
the reference. Every mean is therefore given with its standard deviation, which combines the
uncertainty of the reference, the POS errors of the line and the covariance of the boresight. POS
errors hardly change during one line, so a larger number of points does not average them out.

The value for all lines together is the mean of the means of the lines, so that a dense line has the
same weight as a sparse one. The POS error shared by all places of a line is larger than the scatter
of these places; the lines, not the places, are independent of each other.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.former_names import accept_script_names
from lispac.messages import Message
from lispac.validation.comparison_results import DistanceStatistics, SignedStatistics
from lispac.validation.normal_distance import NormalDistances
from lispac.validation.reference_places import CorePointDistances

Array = NDArray[np.float64]
Kind = Literal["scan", "points"]

NORMAL_QUANTILE_975 = 1.96
"""Half the width of the 95 % interval of a normal variable, in standard deviations."""
HISTOGRAM_BINS = 60
"""Number of bins of the histogram of signed distances."""
TAIL_PERCENTAGE = 0.5
"""Percentage of the distances beyond each end of the histogram; the end bins contain them."""
MIN_HISTOGRAM_RANGE_M = 1e-6
"""Smallest range of the histogram."""
MIN_OTHER_SURFACE_SHARE = 0.1
"""Smallest share of the places of a line with a second surface within reach that is reported."""
ALL_LINES = "all lines"
"""Name of the comparison of all lines together."""


@dataclass(frozen=True)
class SigmaSources:
    """Standard deviations by their source, metres.

    Attributes
    ----------
    reference : float, metres
    position, attitude : float, metres
        From the accuracies of the POS.
    boresight : float or None, metres
        From the covariance of the estimated values; None for the prior boresight, whose covariance
        is unknown.
    scatter : float, metres
        Contribution of the scatter of the places of a line to its mean; 0 for other values.
    """

    reference: float
    position: float
    attitude: float
    boresight: float | None
    scatter: float = 0.0

    @property
    def total(self) -> float:
        """Standard deviation of all sources together, metres."""
        parts = (self.reference, self.position, self.attitude, self.boresight or 0.0, self.scatter)
        return float(np.sqrt(np.sum(np.square(parts))))


@dataclass(frozen=True)
class AbsoluteState:
    """Distances of the lines from the reference with one boresight.

    Each line has the same weight in the means and the RMS; medians and percentiles are taken over
    all places.

    Attributes
    ----------
    distances : DistanceStatistics
        Unsigned.
    signed : SignedStatistics
        From the reference to the line, positive where the line is nearer to the vessel.
    mean_sigma : SigmaSources
        Standard deviation of the signed mean, by source.
    rms_expected : SigmaSources
        RMS that these errors alone would cause, by source.
    """

    distances: DistanceStatistics
    signed: SignedStatistics
    mean_sigma: SigmaSources
    rms_expected: SigmaSources

    @property
    def interval_95(self) -> float:
        """Half the 95 % interval of the signed mean, metres."""
        return NORMAL_QUANTILE_975 * self.mean_sigma.total

    @property
    def significant(self) -> bool:
        """Whether the mean differs from zero at 95 %."""
        return abs(self.signed.mean) > self.interval_95

    @property
    def reference_share(self) -> float:
        """Share of the mean square distance that the reference's own errors explain, in [0, 1]."""
        if self.distances.rms == 0.0:
            return 0.0
        return float(min(1.0, (self.rms_expected.reference / self.distances.rms) ** 2))


@dataclass(frozen=True)
class LineCheck:
    """Distances of one or all lines from the reference, before and after the calibration."""

    line: str
    before: AbsoluteState
    after: AbsoluteState


@dataclass(frozen=True)
class PointCheck:
    """Mean distance of the lines from a surveyed point, or from a plane through several points.

    Attributes
    ----------
    name : str
    lines : int
    sigma : float, metres
        Standard deviation of the point, or of the plane at its centre.
    before, after : float, metres
        Signed mean distance before and after the calibration.
    interval_95 : float or None, metres
        Half the 95 % interval of the mean after the calibration; None if unknown.
    """

    name: str
    lines: int
    sigma: float
    before: float
    after: float
    interval_95: float | None = None


@dataclass(frozen=True)
class OtherSurface:
    """Second surface of a line near the reference: number of places and typical distance.

    Attributes
    ----------
    line : str
    places : int
        Number of places with a second surface.
    distance : float, metres
        Median distance between the measured surface and the second one.
    """

    line: str
    places: int
    distance: float


@accept_script_names
@dataclass(frozen=True)
class AbsoluteCheck:
    """Comparison of the lines with a reference, before and after the calibration.

    Attributes
    ----------
    reference : str
        Name of its file.
    size_bytes : int, sha256 : str
        Size and hash of that file when it was read.
    kind : {"scan", "points"}
    system : str
        Assumed coordinate system, as text.
    sigma : float, metres
        Standard deviation of the reference: for a scan, of an error common to all its points; for
        surveyed points, whose errors are independent, the typical value.
    search_distance : float, metres
        Largest distance from the reference at which points of a line were searched for.
    lines : tuple of LineCheck
    all_lines : LineCheck
    not_compared : tuple of Message
        Lines, and surveyed points or planes, that were not compared, with the reason.
    bin_edges : tuple of k + 1 float, metres
        Edges of the histogram of the signed distances of all lines.
    counts_before, counts_after : tuples of k int
        Counts of the bins; the first and last bins include the distances beyond them.
    points : tuple of PointCheck
        Empty for a scan.
    other_surfaces : tuple of OtherSurface or None
        Lines that often have a second surface within reach; None if unknown.
    """

    reference: str
    size_bytes: int
    sha256: str
    kind: Kind
    system: str
    sigma: float
    search_distance: float
    lines: tuple[LineCheck, ...]
    all_lines: LineCheck
    not_compared: tuple[Message, ...]
    bin_edges: tuple[float, ...]
    counts_before: tuple[int, ...]
    counts_after: tuple[int, ...]
    points: tuple[PointCheck, ...] = ()
    other_surfaces: tuple[OtherSurface, ...] | None = ()


@dataclass(frozen=True, eq=False)
class LinePlaces:
    """Measured places of a line, and how errors of the boresight and the POS shift them.

    Attributes
    ----------
    line : str
    time : float, seconds
        Median time of the places.
    measured : CorePointDistances
        Distances at n places.
    group : ndarray of shape (n,), int
        Number of the part of the reference to which each place belongs; errors of different parts
        are independent.
    by_position, by_attitude : ndarrays of shape (n, 3), metres
        Shift of each distance by an error of one sigma in north, west, up and in roll, pitch,
        heading.
    by_boresight : ndarray of shape (n, e), metres
        Shift by one sigma of each of e independent combinations of the estimated values.
    """

    line: str
    time: float
    measured: CorePointDistances
    group: NDArray[np.intp]
    by_position: Array
    by_attitude: Array
    by_boresight: Array

    def select_places(self, kept: NDArray[np.bool_]) -> "LinePlaces":
        """Select the places of the line where ``kept``, shape (n,), is true."""
        places = np.flatnonzero(kept)
        measured = CorePointDistances(
            self.measured.before.select_subset(places), self.measured.after.select_subset(places),
            self.measured.to_other_surface[places],
        )  # fmt: skip
        return replace(
            self, measured=measured, group=self.group[kept], by_position=self.by_position[kept],
            by_attitude=self.by_attitude[kept], by_boresight=self.by_boresight[kept],
        )  # fmt: skip


def check_lines(
    lines: Sequence[LinePlaces], group_sigma: Array, correlation_times: tuple[float, float]
) -> tuple[tuple[LineCheck, ...], LineCheck]:
    """Compare each line, and all lines together, with the reference.

    Parameters
    ----------
    group_sigma : ndarray of shape (g,), metres
        Standard deviation of each part of the reference; all places on a part have the same error.
    correlation_times : pair of float, seconds
        Correlation times of the position and attitude errors of the POS. Lines that are surveyed
        within such a time have most of these errors in common.
    """
    each = tuple(_line_check(line.line, [line], group_sigma, correlation_times) for line in lines)
    return each, _line_check(ALL_LINES, lines, group_sigma, correlation_times)


def shared_histogram(
    lines: Sequence[LinePlaces],
) -> tuple[tuple[float, ...], tuple[int, ...], tuple[int, ...]]:
    """Histogram of all signed distances: edges in metres, counts before, and counts after."""
    before, after = (np.concatenate(values) for values in _distances_before_after(lines))
    ends = np.percentile(
        np.concatenate([before, after]), (TAIL_PERCENTAGE, 100.0 - TAIL_PERCENTAGE)
    )
    low, high = float(min(ends[0], 0.0)), float(max(ends[1], 0.0))
    edges = np.linspace(low, max(high, low + MIN_HISTOGRAM_RANGE_M), HISTOGRAM_BINS + 1)
    counts = (
        tuple(int(n) for n in np.histogram(np.clip(d, edges[0], edges[-1]), edges)[0])
        for d in (before, after)
    )
    counts_before, counts_after = counts
    return tuple(map(float, edges)), counts_before, counts_after


def check_points(
    lines: Sequence[LinePlaces],
    names: Sequence[str],
    group_sigma: Array,
    correlation_times: tuple[float, float],
) -> tuple[PointCheck, ...]:
    """Mean over the lines for each measured part of the reference; see `check_lines`."""
    found = []
    for group, (name, sigma) in enumerate(zip(names, group_sigma, strict=True)):
        own = [
            line.select_places(line.group == group) for line in lines if (line.group == group).any()
        ]
        if own:
            mean = _line_check(name, own, group_sigma, correlation_times)
            found.append(
                PointCheck(
                    name, len(own), float(sigma), mean.before.signed.mean, mean.after.signed.mean,
                    mean.after.interval_95,
                )
            )  # fmt: skip
    return tuple(found)


def find_other_surfaces(lines: Sequence[LinePlaces]) -> tuple[OtherSurface, ...]:
    """Find the lines that have a second surface within reach at many of their places."""
    found = []
    for line in lines:
        gaps = line.measured.to_other_surface
        gaps = gaps[np.isfinite(gaps)]
        if len(gaps) >= MIN_OTHER_SURFACE_SHARE * len(line.group):
            found.append(OtherSurface(line.line, len(gaps), float(np.median(gaps))))
    return tuple(found)


def _distances_before_after(lines: Sequence[LinePlaces]) -> tuple[list[Array], list[Array]]:
    return (
        [line.measured.before.distance for line in lines],
        [line.measured.after.distance for line in lines],
    )


def _line_check(
    name: str,
    lines: Sequence[LinePlaces],
    group_sigma: Array,
    correlation_times: tuple[float, float],
) -> LineCheck:
    # Weight of each place in the mean of the means of the lines
    weights = np.concatenate([_equal_weights(line) / len(lines) for line in lines])
    parts = [np.bincount(line.group, minlength=len(group_sigma)) for line in lines]
    share = np.mean([part / part.sum() for part in parts], axis=0)
    shifts = [np.concatenate(values) for values in _derivatives_by_source(lines)]
    of_rms = SigmaSources(
        float(np.sqrt(share @ group_sigma**2)),
        *(float(np.sqrt(weights @ (move**2).sum(axis=1))) for move in shifts),
    )
    of_mean = SigmaSources(
        float(np.sqrt(share**2 @ group_sigma**2)),
        _pos_sigma_of_mean([line.by_position for line in lines], lines, correlation_times[0]),
        _pos_sigma_of_mean([line.by_attitude for line in lines], lines, correlation_times[1]),
        float(np.linalg.norm(weights @ shifts[2])),
    )
    states = []
    for state_name, distances in zip(
        ("before", "after"), _distances_before_after(lines), strict=True
    ):
        found = [getattr(line.measured, state_name) for line in lines]
        scatter = float(np.linalg.norm([_scatter_sigma(each) for each in found])) / len(lines)
        rms = float(np.sqrt(weights @ np.concatenate(distances) ** 2))
        boresight = of_mean.boresight, of_rms.boresight
        if state_name == "before":
            boresight = None, None
        states.append(
            AbsoluteState(
                replace(
                    DistanceStatistics.of(np.concatenate(distances)),
                    mean=float(weights @ np.abs(np.concatenate(distances))),
                    rms=rms,
                ),
                replace(
                    SignedStatistics.of(found),
                    mean=float(weights @ np.concatenate(distances)),
                    rms=rms,
                ),
                replace(of_mean, scatter=scatter, boresight=boresight[0]),
                replace(of_rms, boresight=boresight[1]),
            )
        )
    return LineCheck(name, *states)


def _equal_weights(line: LinePlaces) -> Array:
    """Equal weights of the places in the mean of a line."""
    return np.full(len(line.group), 1.0 / len(line.group))


def _scatter_sigma(distances: NormalDistances) -> float:
    """Sigma of the mean of a line due to the scatter of its places, metres."""
    within = float(np.sum((distances.distance - distances.distance.mean()) ** 2))
    # A single place has no scatter; its own interval gives its uncertainty.
    own = float(np.sum((distances.half_width / NORMAL_QUANTILE_975) ** 2))
    return float(np.sqrt(max(within, own))) / len(distances.distance)


def _derivatives_by_source(lines: Sequence[LinePlaces]) -> tuple[list[Array], ...]:
    return (
        [line.by_position for line in lines],
        [line.by_attitude for line in lines],
        [line.by_boresight for line in lines],
    )


def _pos_sigma_of_mean(
    moves: list[Array], lines: Sequence[LinePlaces], correlation_time: float
) -> float:
    """Sigma of the mean due to POS errors that are constant in a line but drift between lines."""
    means = np.array([move.mean(axis=0) for move in moves]) / len(moves)
    time = np.array([line.time for line in lines])
    correlations = np.exp(-np.abs(time[:, None] - time) / correlation_time)
    return float(np.sqrt(max(0.0, float(np.einsum("ik,ij,jk->", means, correlations, means)))))
