"""Screening of the points of a line: which points are used, which are excluded and why.

Import into the store, reading into memory and georeferencing from the file all use this screening,
so that they use the same points.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error
from lispac.survey import screening_kernels as kernels
from lispac.survey.line_audit import (
    SKETCH_HASHES,
    LineAudit,
    time_grid_step,
    time_spans,
    usual_time_step,
)

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

MAX_COORDINATE, MAX_TIME_S = 1e9, 1e11
"""Largest possible coordinate, in any unit, and largest possible time in seconds."""
MIN_RANGE_M = 0.001
"""Smallest range; points nearer to the optical centre are pulses without an echo."""
MAX_RANGE_M = 10_000.0
"""Largest range of any scanner."""
NOISE_CLASSES = (7, 18)
"""Low and high noise (ASPRS LAS 1.4 R15, table 17)."""
GROUP_ATTRIBUTES = (
    "scanner_channel", "point_source_id", "user_data", "scanner", "scanner_id", "head", "head_id",
    "device", "device_id", "sensor_id", "lidar_id",
)  # fmt: skip
"""Attributes that distinguish scanners or lines in one file."""
MAX_GROUP_VALUES = 64
"""Largest number of values of such an attribute; one with more has another meaning."""
TIMES_PER_CHUNK, MAX_TIME_CHUNKS = 1000, 20
"""Largest number of times per chunk, and of chunks, used to detect the resolution of the times."""
RANGE_SAMPLING_STEP = 101
"""One point in this number is used for the mean range."""


@dataclass(frozen=True)
class AttributeCondition:
    """A range of values of an attribute, or of the time.

    Attributes
    ----------
    name : str
        Name of the attribute; ``time`` for the times in the file's time base.
    low, high : float
        Limits, both inclusive.
    """

    name: str
    low: float
    high: float

    def __str__(self) -> str:
        if self.low == self.high:
            return f"{self.name}={self.low:.15g}"
        return f"{self.name}={self.low:.15g}:{self.high:.15g}"


@dataclass(frozen=True)
class PointSelection:
    """User-defined selection of points of a file.

    Attributes
    ----------
    keep_withheld : bool
        Whether points with the withheld flag are used.
    excluded_classes : tuple of int
    only : tuple of AttributeCondition
        Only points that meet all these conditions are used.
    max_range : float, metres
        Largest distance from the scanner.
    """

    keep_withheld: bool = False
    excluded_classes: tuple[int, ...] = ()
    only: tuple[AttributeCondition, ...] = ()
    max_range: float = MAX_RANGE_M

    @classmethod
    def of(cls, choice: Mapping[str, Any]) -> "PointSelection":
        """Selection according to the options of a format.

        Raises
        ------
        InputError
            If an option is invalid.
        """
        return cls(
            choice.get("withheld", "exclude") == "keep",
            _parse_classes(str(choice.get("exclude_classes", ""))),
            parse_conditions(str(choice.get("only", ""))),
            parse_largest_range(str(choice.get("max_range", ""))),
        )


def parse_conditions(text: str) -> tuple[AttributeCondition, ...]:
    """Conditions as ``NAME=VALUE`` or ``NAME=LOW:HIGH``, separated by spaces.

    Raises
    ------
    InputError
        If a part is not such a condition.
    """
    found = []
    for part in text.split():
        name, sign, values = part.partition("=")
        low, colon, high = values.partition(":")
        try:
            found.append(
                AttributeCondition(name.lower(), float(low), float(high if colon else low))
            )
        except ValueError:
            sign = ""
        if not sign or not name:
            raise InputError(error("survey.not_a_condition", text=part))
    return tuple(found)


def _parse_classes(text: str) -> tuple[int, ...]:
    try:
        return tuple(int(part) for part in re.split(r"[ ,;]+", text.strip()) if part)
    except ValueError:
        raise InputError(error("survey.not_classes", text=text)) from None


def parse_largest_range(text: str) -> float:
    """Largest range of a scanner, metres, from the text of its option.

    Raises
    ------
    InputError
        If the text is not a positive length.
    """
    try:
        value = float(text) if text.strip() else MAX_RANGE_M
    except ValueError:
        value = 0.0
    if not 0 < value <= MAX_COORDINATE:
        raise InputError(error("survey.not_a_range", text=text))
    return value


@dataclass(eq=False)
class PointScreen:
    """Exclusion of invalid and unwanted points of one line, with statistics of all points.

    Parameters
    ----------
    selection : PointSelection
    ranged : bool
        Whether coordinates are in the scanner frame, so that ranges can be checked.
    far_copies : bool
        Whether to find copies at any distance in the file. This needs 16 bytes of memory per point;
        otherwise the memory is constant.
    """

    selection: PointSelection
    ranged: bool
    far_copies: bool = False
    _counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros(6, np.int64))
    _excluded: NDArray[np.int64] = field(default_factory=lambda: np.zeros(3, np.int64))
    _read: int = 0

    def __post_init__(self) -> None:
        self._tables = np.zeros((2, kernels.WINDOW_SLOTS), np.uint64)
        self._fill = np.array([0, 0, int(self.far_copies)])
        self._latest = np.full(1, -np.inf)
        self._tail = np.zeros((0, 4), np.uint64)
        self._hashes, self._hash_counts = np.zeros(0, np.uint64), np.zeros(0, np.int64)
        self._threshold = np.uint64(np.iinfo(np.uint64).max)
        self._last = np.full(1, np.nan)
        self._gaps = np.zeros(kernels.GAP_BINS, np.int64)
        self._sums = np.zeros(kernels.GAP_BINS)
        self._seconds = np.zeros(0, np.int64)
        self._first_returns = self._changes = 0
        self._groups: dict[str, dict[int, int]] = {}
        self._noise: dict[int, int] = {}
        self._range_sum, self._range_count = 0.0, 0
        self._some_times: list[Array] = []

    def __call__(self, time: Array, xyz: Array, extra: Mapping[str, NDArray[Any]]) -> Mask:
        """Whether each point of the next chunk is used, shape (n,).

        Parameters
        ----------
        time : ndarray of shape (n,), seconds, in the file's time base
        xyz : ndarray of shape (n, 3)
            Metres in the scanner frame, or in the unit of the map.
        extra : mapping of str to ndarray of shape (n, ...)
            Attributes of the points, with the names in the file.

        Raises
        ------
        InputError
            If a condition uses an attribute that is not in the file.
        """
        time = np.ascontiguousarray(time, dtype=np.float64)
        xyz = np.ascontiguousarray(xyz, dtype=np.float64)
        status = self._status_by_selection(time, extra)
        farthest = self.selection.max_range if self.ranged else -1.0
        self._counts += kernels.screen_values(
            time, xyz, MIN_RANGE_M, farthest, MAX_COORDINATE, MAX_TIME_S, status
        )
        self._read += len(time)
        self._mark_duplicates(time, xyz, status)
        used = status == kernels.KEPT
        self._update_audit(time, extra, used)
        if self.ranged:
            self.add_ranges(xyz[::RANGE_SAMPLING_STEP][used[::RANGE_SAMPLING_STEP]])
        return used

    def screen_recovered(self, points_lidar: Array) -> Mask:
        """Whether each point recovered from map coordinates is used, shape (n,); counts others.

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        """
        status, counts = _status_by_range(points_lidar, self.selection.max_range)
        self._counts += counts
        used = status == kernels.KEPT
        self.add_ranges(points_lidar[::RANGE_SAMPLING_STEP][used[::RANGE_SAMPLING_STEP]])
        return np.asarray(used)

    def add_ranges(self, points_lidar: Array) -> None:
        """Include points (n, 3), metres, LiDAR frame, in the mean range."""
        self._range_sum += float(np.sqrt((points_lidar**2).sum(axis=1)).sum())
        self._range_count += len(points_lidar)

    def result(self) -> LineAudit:
        """Audit of all chunks so far."""
        counts = [int(count) for count in self._counts]
        times = int(self._hash_counts.sum())
        return LineAudit(
            read=self._read,
            not_finite=counts[kernels.NOT_FINITE],
            no_range=counts[kernels.NO_RANGE],
            too_far=counts[kernels.TOO_FAR],
            duplicates=counts[kernels.DUPLICATE],
            withheld=int(self._excluded[0]),
            of_classes=int(self._excluded[1]),
            not_selected=int(self._excluded[2]),
            noise={str(k): count for k, count in sorted(self._noise.items())},
            first_returns=self._first_returns,
            distinct_times=self._changes,
            time_step=self._time_step(),
            groups={
                name: {str(value): count for value, count in sorted(found.items())}
                for name, found in self._groups.items()
                if 1 < len(found) <= MAX_GROUP_VALUES
            },
            spans=time_spans(self._seconds),
            mean_range=self._range_sum / max(self._range_count, 1),
            # Halved, because readers of JSON may convert larger integers to floating point.
            sketch=(self._hashes[:SKETCH_HASHES] >> np.uint64(1)).tolist(),
            repeated=1.0 - len(self._hashes) / times if times else 0.0,
        )

    def _time_step(self) -> float:
        """Step of the times if they are coarse, seconds; otherwise 0.

        Points recorded once per rotation of the mirror have gaps of one rotation even if their
        times are fine. The step is therefore that of the grid on which all times lie, if any.
        """
        step = usual_time_step(self._gaps, self._sums, self._changes)
        grid = time_grid_step(np.concatenate(self._some_times)) if step else 0.0
        return min(step, grid) if grid else step

    # -- parts -------------------------------------------------------------------------------

    def _status_by_selection(
        self, time: Array, extra: Mapping[str, NDArray[Any]]
    ) -> NDArray[np.uint8]:
        """Status of each point by flags, classes and conditions, shape (n,)."""
        status = np.zeros(len(time), np.uint8)
        if "withheld" in extra and not self.selection.keep_withheld:
            withheld = np.asarray(extra["withheld"])
            if withheld.any():
                self._exclude(status, withheld != 0, 0)
        if self.selection.excluded_classes and "classification" in extra:
            self._exclude(
                status, np.isin(extra["classification"], self.selection.excluded_classes), 1
            )
        if self.selection.only:
            is_selected = np.ones(len(time), dtype=bool)
            for condition in self.selection.only:
                values = _attribute_values(condition.name, time, extra)
                is_selected &= (values >= condition.low) & (values <= condition.high)
            self._exclude(status, ~is_selected, 2)
        return status

    def _exclude(self, status: NDArray[np.uint8], chosen: Mask, reason: int) -> None:
        new = chosen & (status == kernels.KEPT)
        status[new] = kernels.EXCLUDED
        self._excluded[reason] += int(np.count_nonzero(new))

    def _mark_duplicates(self, time: Array, xyz: Array, status: NDArray[np.uint8]) -> None:
        if self.far_copies:
            while 2 * (self._fill[0] + len(time)) > self._tables.shape[1]:
                larger = kernels.doubled_table(self._tables[self._fill[1]])
                self._tables = np.stack([larger, np.zeros_like(larger)])
                self._fill[1] = 0
        sampled = np.empty(len(time), np.uint64)
        bits = time.view(np.uint64), xyz.view(np.uint64)
        found, count = kernels.mark_duplicates(
            time, *bits, status, self._latest, self._tail, self._tables, self._fill,
            self._threshold, sampled,
        )  # fmt: skip
        last = slice(max(0, len(time) - kernels.MAX_RUN_POINTS), None)
        self._tail = np.column_stack([bits[0][last], bits[1][last]])
        self._counts[kernels.DUPLICATE] += found
        self._counts[kernels.KEPT] -= found
        self._add_hashes(*_smallest_hashes(sampled[:count]))

    def _add_hashes(self, hashes: NDArray[np.uint64], counts: NDArray[np.int64]) -> None:
        """Add hashes of a chunk, ascending, to the sketch, and their counts, both of shape (n,)."""
        together = np.concatenate([self._hashes, hashes[:SKETCH_HASHES]])
        distinct, places = np.unique(together, return_inverse=True)
        sums = np.zeros(len(distinct), np.int64)
        np.add.at(sums, places, np.concatenate([self._hash_counts, counts[:SKETCH_HASHES]]))
        self._hashes, self._hash_counts = distinct[:SKETCH_HASHES], sums[:SKETCH_HASHES]
        if len(self._hashes) == SKETCH_HASHES:
            self._threshold = self._hashes[-1]

    def _update_audit(self, time: Array, extra: Mapping[str, NDArray[Any]], used: Mask) -> None:
        first = used
        returns = np.asarray(extra["return_number"]) if "return_number" in extra else None
        if returns is not None and len(returns) and returns.max() > 1:
            first = used & (returns <= 1)
        seconds = np.empty(len(time), np.int64)
        points, changes, entries = kernels.time_steps(
            time, first, self._last, self._gaps, self._sums, seconds
        )
        self._first_returns += points
        self._changes += changes
        self._seconds = np.union1d(self._seconds, seconds[:entries])
        if len(self._some_times) < MAX_TIME_CHUNKS:
            self._some_times.append(time[first][:: 1 + len(time) // TIMES_PER_CHUNK])
        all_used = bool(used.all())
        for name in GROUP_ATTRIBUTES:
            if name in extra and len(self._groups.setdefault(name, {})) <= MAX_GROUP_VALUES:
                values = np.asarray(extra[name])
                _add_value_counts(self._groups[name], values if all_used else values[used])
        if "classification" in extra:
            classes = np.asarray(extra["classification"])
            largest = int(classes.max(initial=0))
            for noise in NOISE_CLASSES if largest >= min(NOISE_CLASSES) else ():
                count = int(np.count_nonzero((classes == noise) & used))
                if count:
                    self._noise[noise] = self._noise.get(noise, 0) + count


def _smallest_hashes(hashes: NDArray[np.uint64]) -> tuple[NDArray[np.uint64], NDArray[np.int64]]:
    """Smallest distinct hashes, at least `SKETCH_HASHES` if there are so many; their counts."""
    enough = 2 * SKETCH_HASHES
    if len(hashes) > 4 * enough:  # sorting all hashes would take longer than all other steps
        values, times = np.unique(
            hashes[hashes <= np.partition(hashes, enough)[enough]], return_counts=True
        )
        if len(values) >= SKETCH_HASHES:
            return values, times
    return np.unique(hashes, return_counts=True)


def is_within_range(points_lidar: Array, max_range: float) -> Mask:
    """Whether the range of each point is at most the largest one, shape (n,).

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    max_range : float, metres
    """
    return np.asarray(_status_by_range(points_lidar, max_range)[0] == kernels.KEPT)


def _status_by_range(
    points_lidar: Array, max_range: float
) -> tuple[NDArray[np.uint8], NDArray[np.int64]]:
    """Status of each point by its range, and the number of points by status."""
    status = np.zeros(len(points_lidar), np.uint8)
    counts = kernels.screen_values(
        np.zeros(len(points_lidar)), np.ascontiguousarray(points_lidar), MIN_RANGE_M, max_range,
        MAX_COORDINATE, MAX_TIME_S, status,
    )  # fmt: skip
    return status, counts


def _attribute_values(name: str, time: Array, extra: Mapping[str, NDArray[Any]]) -> NDArray[Any]:
    if name == "time":
        return time
    names = {each.lower(): each for each in extra}
    if name not in names:
        raise InputError(error("survey.unknown_attribute", name=name, names=("time", *extra)))
    values = np.asarray(extra[names[name]])
    if values.ndim > 1:
        raise InputError(error("survey.vector_attribute", name=name))
    return values


def _add_value_counts(value_counts: dict[int, int], values: NDArray[Any]) -> None:
    """Add the number of points with each value; attributes with fractions are ignored."""
    if values.ndim != 1 or not len(values):
        return
    low, high = values.min(), values.max()
    if low == high and low == int(low):  # most files have a single value, which is quick to detect
        value_counts[int(low)] = value_counts.get(int(low), 0) + len(values)
        return
    if values.dtype.kind == "f":
        if not (values == np.floor(values)).all():
            return
        values = values.astype(np.int64)
    if values.dtype.itemsize <= 2 and values.dtype.kind == "u":
        counts = np.bincount(values)
        pairs = [(int(value), int(counts[value])) for value in np.flatnonzero(counts)]
    else:
        different, counts = np.unique(values, return_counts=True)
        pairs = list(zip(different.tolist(), counts.tolist(), strict=True))
    for value, count in pairs[: MAX_GROUP_VALUES + 1]:
        value_counts[value] = value_counts.get(value, 0) + count
