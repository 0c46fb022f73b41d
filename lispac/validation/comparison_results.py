"""Statistics of a comparison of lines, as stored in the project file."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lispac.errors import InputError
from lispac.messages import error
from lispac.untrusted_values import ArrayShape
from lispac.validation.distance_map import DistanceMap
from lispac.validation.distance_profile import DistanceProfile
from lispac.validation.local_models import SIX_POINT_PLANE, LocalModel
from lispac.validation.normal_distance import SIGMA_PER_MAD, NormalDistances
from lispac.validation.plane_offset import PlaneOffset

OUTLIER_LIMIT_SIGMAS = 3.0
"""Number of robust sigmas above the median beyond which a distance is counted as an outlier."""


@dataclass(frozen=True)
class DistanceStatistics:
    """Summary of unsigned distances.

    Attributes
    ----------
    n : int
    mean, median, rms, p68, p95, p99, maximum : float, metres
        ``p68`` is the 68th percentile, and so on.
    robust_sigma : float, metres, optional
        1.4826 times the median absolute deviation from the median.
    outliers : int, optional
        Number of distances more than three robust sigmas above the median. They are included in
        all other statistics. Like ``robust_sigma``, None in comparisons of earlier versions.
    """

    n: int
    mean: float
    median: float
    rms: float
    p68: float
    p95: float
    p99: float
    maximum: float
    robust_sigma: float | None = None
    outliers: int | None = None

    @classmethod
    def of(cls, distances: ArrayLike) -> "DistanceStatistics":
        """Summarise distances, shape (n,), metres.

        Raises
        ------
        InputError
            If there is no distance, or one is not a finite number.
        """
        values = np.abs(np.asarray(distances, dtype=np.float64))
        if values.size == 0 or not np.isfinite(values).all():
            raise InputError(error("validation.no_distances"))
        median, p68, p95, p99 = np.percentile(values, (50.0, 68.0, 95.0, 99.0))
        robust = SIGMA_PER_MAD * float(np.median(np.abs(values - median)))
        return cls(
            n=int(values.size),
            mean=float(values.mean()),
            median=float(median),
            rms=float(np.sqrt(np.mean(values**2))),
            p68=float(p68),
            p95=float(p95),
            p99=float(p99),
            maximum=float(values.max()),
            robust_sigma=robust,
            outliers=int(np.count_nonzero(values > median + OUTLIER_LIMIT_SIGMAS * robust)),
        )


@dataclass(frozen=True)
class SignedStatistics:
    """Summary of signed distances along the normal (M3C2) with their confidence intervals.

    Attributes
    ----------
    n : int
        Number of places.
    mean, median, robust_sigma : float, metres
        From the second line to the first, positive where the first is nearer to the vessel.
    half_width : float, metres
        Median over the places of half the 95 % interval.
    significant : float, in [0, 1]
        Share of the places whose distance differs significantly from zero.
    rms : float, metres, optional
        None in comparisons of earlier versions.
    """

    n: int
    mean: float
    median: float
    robust_sigma: float
    half_width: float
    significant: float
    rms: float | None = None

    @classmethod
    def of(cls, distances: Sequence[NormalDistances]) -> "SignedStatistics":
        """Summarise all distances together."""
        distance = np.concatenate([each.distance for each in distances])
        half_width = np.concatenate([each.half_width for each in distances])
        median = float(np.median(distance))
        return cls(
            n=len(distance),
            mean=float(distance.mean()),
            median=median,
            robust_sigma=SIGMA_PER_MAD * float(np.median(np.abs(distance - median))),
            half_width=float(np.median(half_width)),
            significant=float(np.mean(np.abs(distance) > half_width)),
            rms=float(np.sqrt(np.mean(distance**2))),
        )


@dataclass(frozen=True)
class PairState:
    """Comparison of two lines on one plane with one boresight.

    Attributes
    ----------
    distances : DistanceStatistics
        Cloud to cloud, both directions together.
    signed : SignedStatistics, optional
        Along the normal; None if no place has enough points of both lines.
    planes : PlaneOffset, optional
        From the second line's plane to the first's; None if no plane fits one of the lines.
    """

    distances: DistanceStatistics
    signed: SignedStatistics | None = None
    planes: PlaneOffset | None = None


@dataclass(frozen=True)
class TwoModes:
    """Two modes of the signed distances of a pair of lines.

    Attributes
    ----------
    distance : float, metres
        Between the centres of the two parts.
    sigma : float, metres
        Standard deviation of this distance, if only POS errors, the error of the boresight and the
        noise cause it.
    share : float, in (0, 0.5]
        Share of the places in the smaller part.
    probability : float, in [0, 1]
        Probability of so few distances between the centres if there is one mode.
    """

    distance: float
    sigma: float
    share: float
    probability: float


@dataclass(frozen=True)
class LineShift:
    """Mean distance of some lines from others on a plane after the calibration.

    Attributes
    ----------
    lines, others : tuple of str
    offset : float, metres
        Positive where ``lines`` are nearer to the vessel than ``others``.
    sigma : float, metres
        Standard deviation of the offset.
    reciprocal : bool
        Whether these are all lines in one direction, and those in the opposite direction.
    """

    lines: tuple[str, ...]
    others: tuple[str, ...]
    offset: float
    sigma: float
    reciprocal: bool = False


@dataclass(frozen=True, eq=False)
class PairComparison:
    """Comparison of two lines on one plane, with the prior and with the estimated boresight.

    Attributes
    ----------
    line_a, line_b : str
    reciprocal : bool
        Whether the lines were run in opposite directions, within 20 degrees.
    before, after : PairState
        Computed from the same points.
    modes : TwoModes, optional
        If the signed distances after the calibration have two modes.
    """

    line_a: str
    line_b: str
    reciprocal: bool
    before: PairState
    after: PairState
    modes: TwoModes | None = None


@dataclass(frozen=True, eq=False)
class PlaneComparison:
    """Comparison of the lines on a validation plane before and after the calibration.

    Attributes
    ----------
    name : str
    pairs : tuple of PairComparison
        Every pair of lines that overlaps, reciprocal pairs first.
    not_compared : tuple of (str, str)
        Pairs of lines that both show the plane but have too few points in common.
    pooled_from : str
        Pairs used in the histograms and the statistics: "all pairs", or "reciprocal pairs" in
        comparisons of earlier versions.
    bin_edges : ndarray of shape (k + 1,), metres
    counts_before, counts_after : ndarray of shape (k,), int64
        The last bin includes the distances beyond it.
    before, after : DistanceStatistics
    model : LocalModel
        Model of the surface to which the distances were measured.
    by_height, by_range : DistanceProfile, optional
        Distances against height and against range from the scanner.
    maps : tuple of DistanceMap
        Signed distances over the plane, for the pairs with the largest offsets after the
        calibration. Comparisons of earlier versions have reciprocal pairs among them.
    shifts : tuple of LineShift
        Of each line, and of groups of lines, after the calibration. Empty in comparisons of earlier
        versions.
    """

    name: str
    pairs: tuple[PairComparison, ...]
    not_compared: tuple[tuple[str, str], ...]
    pooled_from: str
    bin_edges: Annotated[NDArray[np.float64], ArrayShape("k+1")]
    counts_before: Annotated[NDArray[np.int64], ArrayShape("k")]
    counts_after: Annotated[NDArray[np.int64], ArrayShape("k")]
    before: DistanceStatistics
    after: DistanceStatistics
    model: LocalModel = SIX_POINT_PLANE
    by_height: DistanceProfile | None = None
    by_range: DistanceProfile | None = None
    maps: tuple[DistanceMap, ...] = ()
    shifts: tuple[LineShift, ...] = ()
