"""Recovery of points in the scanner frame from a georeferenced cloud.

Most software exports points in map coordinates, not in the scanner frame. With the trajectory,
lever arm and boresight from which the cloud was computed, the exact inverse of
`lispac.survey.georeferencing` gives the points in the scanner frame, and the calibration is the
same as with raw data. Errors of the cloud (its stored resolution, a strip adjustment, a smoothed or
different trajectory) remain in these points.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import Message, error, note
from lispac.survey.crs import CoordinateSystem
from lispac.survey.georeferencing import Mounting
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.trajectory import LocalTrajectory

Array = NDArray[np.float64]

MAX_PLAUSIBLE_RANGE_M = 5000.0
"""Largest plausible distance of a point from the scanner."""


class MapPointChunk(Protocol):
    """Chunk of points of a file: a dataclass with at least these fields."""

    __dataclass_fields__: ClassVar[dict[str, Any]]

    @property
    def xyz(self) -> Array:
        """Shape (n, 3), in the frame and unit of the file."""

    @property
    def time(self) -> Array:
        """Shape (n,), seconds, in the trajectory's time base."""

    @property
    def extra(self) -> Any:
        """Other attributes of each point in the file."""


ChunkT = TypeVar("ChunkT", bound=MapPointChunk)


@dataclass(frozen=True, eq=False)
class RecoverySetup:
    """Trajectory, mounting and system from which the cloud was made.

    Attributes
    ----------
    system : CoordinateSystem
        Coordinate system of the cloud.
    trajectory : LocalTrajectory
        Trajectory from which the cloud was computed, not a better one from later processing.
    mounting : Mounting
        Lever arm, boresight and offsets with which the cloud was computed.
    path : Path, optional
        Path of the cloud, for messages.
    """

    system: CoordinateSystem
    trajectory: LocalTrajectory
    mounting: Mounting
    path: Path | None = None

    @property
    def assumptions(self) -> tuple[Message, ...]:
        """Assumptions of the recovery."""
        return (*self.system.assumptions, note("assumed.cloud_made_with"))

    @cached_property
    def mapping(self) -> ScannerPointConverter:
        """Conversion between scanner frame and map in both directions."""
        return ScannerPointConverter(self.system, self.trajectory, self.mounting)

    def has_pose(self, time: Array) -> NDArray[np.bool_]:
        """Whether each time has a pose, shape (n,): inside the trajectory and not in a gap.

        Parameters
        ----------
        time : ndarray of shape (n,), seconds, in the trajectory's time base
        """
        return self.trajectory.covers(time + self.mounting.latency)

    def points_lidar(self, points_crs: Array, time: Array, *, threads: int | None = None) -> Array:
        """Recover points in the LiDAR frame, shape (n, 3), metres.

        The results for single points outside the coordinate system are not finite.

        Parameters
        ----------
        points_crs : ndarray of shape (n, 3), in the unit and axes of ``system``
        time : ndarray of shape (n,), seconds, in the trajectory's time base

        Raises
        ------
        InputError
            If a time lies outside the trajectory, if most points lie outside the coordinate system,
            or if half of the points are beyond the range of any scanner.
        """
        points_lidar = self.mapping.to_scanner(points_crs, time, threads=threads, strict=False)
        if 2 * np.count_nonzero(np.isfinite(points_lidar[:, 0])) < len(points_lidar):
            self.mapping.to_scanner(points_crs, time, threads=threads)
        require_within_reach(points_lidar, self)
        return points_lidar


def recover_scanner_points(
    chunks: Iterable[ChunkT], recovery: RecoverySetup
) -> Iterator[tuple[ChunkT, int]]:
    """Convert georeferenced points back to the scanner frame, chunk by chunk.

    Only one chunk is in memory at a time.

    Yields
    ------
    chunk
        The chunk with ``xyz`` in the LiDAR frame, metres, without points that have no pose.
    lost : int
        Number of points of the chunk that are excluded because they have no pose.

    Raises
    ------
    InputError
        If points are beyond the range of any scanner, because the coordinate system, the height
        reference or the time base is wrong.
    """
    for chunk in chunks:
        usable = recovery.has_pose(chunk.time)
        lost = int(np.count_nonzero(~usable))
        if lost:
            chunk = _select_rows(chunk, usable)
        points_lidar = recovery.points_lidar(chunk.xyz, chunk.time)
        yield replace(chunk, xyz=points_lidar), lost


def require_within_reach(points_lidar: Array, recovery: RecoverySetup) -> None:
    """Refuse points if half of them are beyond the range of any scanner.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame

    Raises
    ------
    InputError
        If fewer than half of the points are within `MAX_PLAUSIBLE_RANGE_M`.
    """
    if not len(points_lidar):
        return
    near = np.einsum("ij,ij->i", points_lidar, points_lidar) <= MAX_PLAUSIBLE_RANGE_M**2
    if 2 * np.count_nonzero(near) < len(near):
        if recovery.path is None:
            raise InputError(
                error(
                    "survey.points_too_far",
                    limit=MAX_PLAUSIBLE_RANGE_M,
                    system=recovery.system.name,
                )
            )
        raise InputError(
            error(
                "survey.points_of_file_too_far",
                file=str(recovery.path),
                limit=MAX_PLAUSIBLE_RANGE_M,
                system=recovery.system.name,
            )
        )


EXAMINED_POINTS = 10_000
"""Approximate number of points of a line that are checked."""


def require_scanner_frame(points_lidar: Array, path: Path) -> None:
    """Refuse points in the assumed LiDAR frame if half of them are beyond any scanner's range.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres
    path : Path
        Path of the line, for messages.

    Raises
    ------
    InputError
        If fewer than half of the points are within `MAX_PLAUSIBLE_RANGE_M`.
    """
    sample = points_lidar[:: max(1, len(points_lidar) // EXAMINED_POINTS)]
    near = np.einsum("ij,ij->i", sample, sample) <= MAX_PLAUSIBLE_RANGE_M**2
    if 2 * np.count_nonzero(near) < len(near):
        raise InputError(
            error(
                "survey.not_scanner_frame",
                file=str(path),
                limit=MAX_PLAUSIBLE_RANGE_M,
                farthest=float(np.sqrt((sample**2).sum(axis=1).max())),
            )
        )


def _select_rows(chunk: ChunkT, chosen: NDArray[np.bool_]) -> ChunkT:
    kept: Callable[[Any], Any] = lambda values: values[chosen]  # noqa: E731
    return replace(
        chunk,
        xyz=kept(chunk.xyz),
        time=kept(chunk.time),
        extra={name: kept(values) for name, values in chunk.extra.items()},
    )
