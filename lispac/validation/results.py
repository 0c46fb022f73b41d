"""The figures a comparison of lines leaves behind: values that the project file can hold."""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lispac.errors import InputError


@dataclass(frozen=True)
class DistanceStatistics:
    """Summary of unsigned distances.

    Attributes
    ----------
    n : int
    mean, median, rms, p68, p95, p99, maximum : float, metres
        ``p68`` is the 68th percentile, and so on.
    """

    n: int
    mean: float
    median: float
    rms: float
    p68: float
    p95: float
    p99: float
    maximum: float

    @classmethod
    def of(cls, distances: ArrayLike) -> "DistanceStatistics":
        """Summarise distances, shape (n,), metres.

        Raises
        ------
        InputError
            There is none, or one is not a finite number.
        """
        values = np.abs(np.asarray(distances, dtype=np.float64))
        if values.size == 0 or not np.isfinite(values).all():
            raise InputError("Statistics need at least one distance and only finite ones.")
        median, p68, p95, p99 = np.percentile(values, (50.0, 68.0, 95.0, 99.0))
        return cls(
            n=int(values.size),
            mean=float(values.mean()),
            median=float(median),
            rms=float(np.sqrt(np.mean(values**2))),
            p68=float(p68),
            p95=float(p95),
            p99=float(p99),
            maximum=float(values.max()),
        )

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers, for JSON."""
        return asdict(self)

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> "DistanceStatistics":
        """The inverse of `to_dict`."""
        return cls(**data)


@dataclass(frozen=True, eq=False)
class PairComparison:
    """Two lines on one plane: distances of each to the other, both directions together.

    Attributes
    ----------
    line_a, line_b : str
    reciprocal : bool
        The lines were run in opposite directions, within 20 degrees.
    before, after : DistanceStatistics
        With the prior and with the estimated boresight, of the same points.
    """

    line_a: str
    line_b: str
    reciprocal: bool
    before: DistanceStatistics
    after: DistanceStatistics

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers and strings, for JSON."""
        return asdict(self)

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> "PairComparison":
        """The inverse of `to_dict`."""
        return cls(
            line_a=data["line_a"],
            line_b=data["line_b"],
            reciprocal=data["reciprocal"],
            before=DistanceStatistics.from_dict(data["before"]),
            after=DistanceStatistics.from_dict(data["after"]),
        )


@dataclass(frozen=True, eq=False)
class PlaneComparison:
    """One validation plane, before and after.

    Attributes
    ----------
    name : str
    pairs : tuple of PairComparison
        Every pair of lines that overlaps, reciprocal pairs first.
    not_compared : tuple of (str, str)
        Pairs of lines that both saw the plane but hardly the same part of it.
    pooled_from : str
        "reciprocal pairs" or "all pairs": whose distances make the histograms and the statistics.
    bin_edges : ndarray of shape (k + 1,), metres
    counts_before, counts_after : ndarray of shape (k,), int64
        The last bin also holds the distances beyond it.
    before, after : DistanceStatistics
    """

    name: str
    pairs: tuple[PairComparison, ...]
    not_compared: tuple[tuple[str, str], ...]
    pooled_from: str
    bin_edges: NDArray[np.float64]
    counts_before: NDArray[np.int64]
    counts_after: NDArray[np.int64]
    before: DistanceStatistics
    after: DistanceStatistics

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers, strings and lists, for JSON."""
        return {
            "name": self.name,
            "pairs": [pair.to_dict() for pair in self.pairs],
            "not_compared": [list(pair) for pair in self.not_compared],
            "pooled_from": self.pooled_from,
            "bin_edges": self.bin_edges.tolist(),
            "counts_before": self.counts_before.tolist(),
            "counts_after": self.counts_after.tolist(),
            "before": self.before.to_dict(),
            "after": self.after.to_dict(),
        }

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> "PlaneComparison":
        """The inverse of `to_dict`."""
        return cls(
            name=data["name"],
            pairs=tuple(PairComparison.from_dict(pair) for pair in data["pairs"]),
            not_compared=tuple((a, b) for a, b in data["not_compared"]),
            pooled_from=data["pooled_from"],
            bin_edges=np.asarray(data["bin_edges"], dtype=np.float64),
            counts_before=np.asarray(data["counts_before"], dtype=np.int64),
            counts_after=np.asarray(data["counts_after"], dtype=np.int64),
            before=DistanceStatistics.from_dict(data["before"]),
            after=DistanceStatistics.from_dict(data["after"]),
        )
