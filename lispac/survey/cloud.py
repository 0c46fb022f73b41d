"""Lines georeferenced in the local frame; only the required regions are read.

Points are identified by their number, which is their index in the line in the order of the file.
Picked points are stored by these numbers, for lines in memory as well as on disk.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.radius_search import points_within
from lispac.survey.georeferencing import Georeferencer, Mounting
from lispac.survey.scan import Scan
from lispac.survey.store.spatial_cells import MAX_HALVINGS, is_number_in_sample
from lispac.survey.store.stored_line import StoredLine
from lispac.survey.trajectory import LocalTrajectory

Array = NDArray[np.float64]
Numbers = NDArray[np.int64]

MAX_REGION_POINTS = 4_000_000
"""Largest number of points of a region. If a region has more, a uniform random sample is used: one
half, one quarter and so on of its points, the same ones for a line in memory and on disk."""

MAX_PROBES, MIN_NEAR_PROBES, PROBE_SEARCH_MARGIN_M = 50_000, 50, 1.0
"""Largest number of points of a line used to estimate its displacement by another mounting,
smallest number of them near a region, and distance around the region that counts as near."""
MARGIN_FACTOR, MIN_MARGIN_M = 1.25, 0.05
"""Safety margin of the estimated displacement: a factor, and a length that is added."""


@dataclass(frozen=True, eq=False)
class SphereRegion:
    """Points of a line within a sphere.

    Attributes
    ----------
    numbers : ndarray of shape (n,), ascending
    points : ndarray of shape (n, 3), metres, local frame
    one_in : int
        Sampling: one in this number of the points is included; 1 if all are.
    """

    numbers: Numbers
    points: Array
    one_in: int = 1


class Line(Protocol):
    """One line in the LiDAR frame, in memory (`survey.scan.Scan`) or on disk (`StoredLine`)."""

    def __len__(self) -> int: ...
    @property
    def fingerprint(self) -> str:
        """Identification of the points, by which stored point numbers can be verified."""

    @property
    def first_time(self) -> float:
        """Seconds, in the trajectory's time base."""

    @property
    def last_time(self) -> float:
        """Seconds, in the trajectory's time base."""

    def take(self, numbers: Numbers) -> tuple[Array, Array]:
        """Points (n, 3) by ``numbers`` (n,), metres, LiDAR frame, and their times (n,), seconds."""

    def intensities(self, numbers: Numbers) -> Array | None:
        """Intensities by ``numbers``, both of shape (n,), if the line has any."""


class Cloud(Protocol):
    """A line georeferenced in the local frame."""

    @property
    def place(self) -> Georeferencer:
        """Transformation of the points into the local frame."""

    def __len__(self) -> int: ...
    def __getitem__(self, numbers: Numbers) -> Array:
        """Points by their numbers, shape (n, 3), metres."""

    def within(self, centre: Array, radius: float, *, limit: int | None = None) -> SphereRegion:
        """Points within a sphere; a uniform random sample if there are more than ``limit``.

        Parameters
        ----------
        centre : ndarray of shape (3,), metres, local frame
        radius : float, metres
        limit : int or None
            By default `MAX_REGION_POINTS`.
        """

    @property
    def sample(self) -> Array:
        """Fixed sample of the line for display: (n, 3), metres, local frame."""

    @property
    def sample_time(self) -> Array:
        """Times of the sample, shape (n,), seconds."""

    @property
    def sample_range(self) -> Array:
        """Ranges of the sample, shape (n,), metres."""

    @property
    def sample_intensity(self) -> Array | None:
        """Intensities of the sample, shape (n,), as in the file, if the line has any."""

    def sample_lidar(self, numbers: Numbers) -> tuple[Array, Array]:
        """Points of the sample, selected by their index in it; see `Line.take`."""

    def georeferenced_with(self, mounting: Mounting) -> "Cloud":
        """The line georeferenced with another boresight and lever arm."""


@dataclass(frozen=True, eq=False)
class CloudInMemory:
    """A line that is completely in memory.

    Attributes
    ----------
    scan : Scan
    place : Georeferencer
        Georeferences the points in the local frame.
    ordered : ndarray of shape (n, 3), metres, local frame
        All points with the mounting ``ordered_with``, used for searching.
    ordered_with : Mounting
        Mounting with which the line was first georeferenced.
    """

    scan: Scan
    place: Georeferencer
    ordered: Array
    ordered_with: Mounting

    @classmethod
    def of(cls, scan: Scan, trajectory: LocalTrajectory, mounting: Mounting) -> "CloudInMemory":
        """Georeference a line."""
        place = Georeferencer.of(trajectory, mounting)
        return cls(scan, place, place(scan.points_lidar, scan.time), mounting)

    def __len__(self) -> int:
        return len(self.scan)

    def __getitem__(self, numbers: Numbers) -> Array:
        if self.place.mounting is self.ordered_with:
            return self.ordered[numbers]
        return self.place(*self.scan.take(numbers))

    def within(self, centre: Array, radius: float, *, limit: int | None = None) -> SphereRegion:
        """See `Cloud`."""
        margin = self._largest_move and _largest_move_near(
            *self._probe_positions, centre, radius, self._largest_move
        )
        numbers = points_within(self.ordered, centre, radius + margin)
        points = self[numbers]
        if margin:
            inside = points_within(points, centre, radius)
            numbers, points = numbers[inside], points[inside]
        halvings = 0
        while len(numbers) > (limit or MAX_REGION_POINTS) and halvings < MAX_HALVINGS:
            halvings += 1
            kept = is_number_in_sample(numbers, halvings)
            numbers, points = numbers[kept], points[kept]
        return SphereRegion(numbers, points, 2**halvings)

    @cached_property
    def sample(self) -> Array:
        """All points, shape (n, 3), metres, local frame."""
        if self.place.mounting is self.ordered_with:
            return self.ordered
        return self.place(self.scan.points_lidar, self.scan.time)

    @property
    def sample_time(self) -> Array:
        """See `Cloud`."""
        return self.scan.time

    @property
    def sample_range(self) -> Array:
        """See `Cloud`."""
        return np.asarray(np.linalg.norm(self.scan.points_lidar, axis=1))

    @property
    def sample_intensity(self) -> Array | None:
        """See `Cloud`."""
        return self.scan.intensity

    def sample_lidar(self, numbers: Numbers) -> tuple[Array, Array]:
        """See `Cloud`."""
        return self.scan.take(numbers)

    def georeferenced_with(self, mounting: Mounting) -> "CloudInMemory":
        """See `Cloud`."""
        place = Georeferencer.of(self.place.trajectory, mounting)
        return CloudInMemory(self.scan, place, self.ordered, self.ordered_with)

    @cached_property
    def _largest_move(self) -> float:
        return self.place.largest_displacement(self.ordered_with, self.scan.reach)

    @cached_property
    def _probe_positions(self) -> tuple[Array, Array]:
        numbers = np.arange(0, len(self), 1 + len(self) // MAX_PROBES)
        return self.ordered[numbers], self[numbers]


@dataclass(frozen=True, eq=False)
class CloudOnDisk:
    """An imported line on disk.

    Attributes
    ----------
    stored : StoredLine
    place : Georeferencer
        Georeferences the points in the local frame.
    """

    stored: StoredLine
    place: Georeferencer

    def __len__(self) -> int:
        return len(self.stored)

    def __getitem__(self, numbers: Numbers) -> Array:
        return self.place(*self.stored.take(numbers))

    def within(self, centre: Array, radius: float, *, limit: int | None = None) -> SphereRegion:
        """See `Cloud`."""
        margin = self._largest_move and _largest_move_near(
            *self._probe_positions, centre, radius, self._largest_move
        )
        rows, points, halvings = self.stored.sampled_within(
            centre, radius, self.place, margin=margin, limit=limit or MAX_REGION_POINTS
        )
        numbers = self.stored.numbers(rows)
        # Within a cell, numbers increase: sorting in runs takes a third of the time.
        order = np.argsort(numbers, kind="stable")
        return SphereRegion(numbers[order], points[order], 2**halvings)

    @cached_property
    def sample(self) -> Array:
        """Coarse sample of the stored line, shape (n, 3), metres, local frame."""
        coarse = self.stored.coarse
        if not self._largest_move:
            return np.asarray(coarse.points_local)
        return self.place(np.asarray(coarse.points_lidar, dtype=np.float64), coarse.time)

    @property
    def sample_time(self) -> Array:
        """See `Cloud`."""
        return self.stored.coarse.time

    @property
    def sample_range(self) -> Array:
        """See `Cloud`."""
        points = np.asarray(self.stored.coarse.points_lidar, dtype=np.float64)
        return np.asarray(np.linalg.norm(points, axis=1))

    @property
    def sample_intensity(self) -> Array | None:
        """See `Cloud`."""
        intensity = self.stored.coarse.intensity
        return None if intensity is None else np.asarray(intensity, dtype=np.float64)

    def sample_lidar(self, numbers: Numbers) -> tuple[Array, Array]:
        """See `Cloud`."""
        coarse = self.stored.coarse
        points = np.asarray(coarse.points_lidar[numbers], dtype=np.float64)
        return points, np.asarray(coarse.time[numbers], dtype=np.float64)

    def georeferenced_with(self, mounting: Mounting) -> "CloudOnDisk":
        """See `Cloud`."""
        return CloudOnDisk(self.stored, Georeferencer.of(self.place.trajectory, mounting))

    @cached_property
    def _largest_move(self) -> float:
        then = Mounting.of_values(np.array(self.stored.manifest.placed_with["mounting"]))
        return self.place.largest_displacement(then, self.stored.manifest.reach)

    @cached_property
    def _probe_positions(self) -> tuple[Array, Array]:
        coarse = self.stored.coarse
        numbers = np.arange(0, len(coarse.time), 1 + len(coarse.time) // MAX_PROBES)
        before = np.asarray(coarse.points_local[numbers], dtype=np.float64)
        return before, self.place(*self.sample_lidar(numbers))


def _largest_move_near(
    before: Array, after: Array, centre: Array, radius: float, max_shift: float
) -> float:
    """Largest displacement of points near a place, metres.

    It is estimated from points of the line near the place, given by their positions ``before`` and
    ``after``, shape (n, 3), and is usually far below ``max_shift``, the displacement of the
    farthest point of the line.
    """
    near = ((after - centre) ** 2).sum(axis=1) <= (radius + PROBE_SEARCH_MARGIN_M) ** 2
    if np.count_nonzero(near) < MIN_NEAR_PROBES:
        return max_shift
    moved = float(np.sqrt(((after[near] - before[near]) ** 2).sum(axis=1).max()))
    return min(max_shift, MARGIN_FACTOR * moved + MIN_MARGIN_M)


def place_clouds(clouds: Mapping[str, Cloud], mounting: Mounting) -> dict[str, Cloud]:
    """Georeference all lines with another mounting."""
    return {name: cloud.georeferenced_with(mounting) for name, cloud in clouds.items()}
