"""Points as read from a file, and blocks of fixed size into which they are gathered."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, ProjectError
from lispac.messages import error
from lispac.survey.store.fingerprint import RunningFingerprint
from lispac.survey.store.layout import StoredColumn

Array = NDArray[np.float64]
Place = Callable[[Array, Array], Array]
"""Function that georeferences points: takes coordinates in the LiDAR frame, shape (n, 3), metres,
and times, shape (n,), seconds; returns coordinates in the local frame, shape (n, 3), metres."""

BLOCK_POINTS = 1_000_000
"""Number of points that are georeferenced, sorted and spooled at once."""
MAX_POINTS_PER_LINE = 2**32 - 1
"""Largest number of points of a line, since their numbers have 32 bits."""
POINT_COLUMNS = (
    StoredColumn("xyz", "<f4", (3,)),
    StoredColumn("time", "<f8"),
    StoredColumn("number", "<u4"),
    StoredColumn("before", "<u4"),
)
"""Columns of every point: its coordinates in the LiDAR frame, its time, its number in the line, and
the number of excluded points before it in the file."""

Values = dict[str, NDArray[Any]]
"""Values of points by field: the names of `POINT_COLUMNS`, and `field_names` of the attributes."""


@dataclass(frozen=True, eq=False)
class PointPiece:
    """Piece of the points of a line, in the order of its file.

    Attributes
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    time : ndarray of shape (n,), seconds, in the trajectory's time base
    index : ndarray of shape (n,), int64
        Index of each point in its file, from 0, where excluded points are counted as well.
    extra : mapping of str to ndarray of shape (n, ...)
        Attributes of the points, by their names in the file.
    read : int
        Points of the file up to here, including excluded ones.
    total : int or None
        Number of points in the file, if given in it.
    """

    points_lidar: Array
    time: Array
    index: NDArray[np.int64]
    extra: Mapping[str, NDArray[Any]]
    read: int
    total: int | None = None

    def __len__(self) -> int:
        return len(self.time)

    def rows(self, start: int, stop: int) -> "PointPiece":
        """A part of it."""
        part = slice(start, stop)
        extra = {name: values[part] for name, values in self.extra.items()}
        return replace(
            self, points_lidar=self.points_lidar[part], time=self.time[part],
            index=self.index[part], extra=extra,
        )  # fmt: skip


@dataclass(eq=False)
class PointBlock:
    """Block into which points are gathered, up to `BLOCK_POINTS` of them.

    Attributes
    ----------
    first : int
        Number of the first point in the line.
    columns : tuple of StoredColumn
        Attributes of the file.
    running : RunningFingerprint
        Fingerprint of the line up to the last point of the block.
    points_lidar : ndarray of shape (BLOCK_POINTS, 3), metres, LiDAR frame
    time : ndarray of shape (BLOCK_POINTS,), seconds
        Only the first ``count`` elements of both arrays are in use.
    """

    first: int
    columns: tuple[StoredColumn, ...]
    running: RunningFingerprint
    points_lidar: Array = field(default_factory=lambda: np.empty((BLOCK_POINTS, 3)))
    time: Array = field(default_factory=lambda: np.empty(BLOCK_POINTS))
    count: int = 0
    next_index: int = 0
    """Index in the file after the last point."""

    def __post_init__(self) -> None:
        own = {column.name: column for column in POINT_COLUMNS}
        self._values = {
            field: np.empty((BLOCK_POINTS, *column.shape), column.dtype)
            for field, column in (own | field_names(self.columns)).items()
        }

    def add(self, piece: PointPiece) -> None:
        """Add the points of a piece, at most `free_points`."""
        rows = slice(self.count, self.count + len(piece))
        self.points_lidar[rows], self.time[rows] = piece.points_lidar, piece.time
        numbers = np.arange(len(piece)) + (self.first + self.count)
        values = self._values
        values["xyz"][rows], values["time"][rows] = piece.points_lidar, piece.time
        values["number"][rows], values["before"][rows] = numbers, piece.index - numbers
        for field_name, column in field_names(self.columns).items():
            values[field_name][rows] = piece.extra[column.name]
        self.running = self.running.after(piece.points_lidar, piece.time)
        self.count = rows.stop
        self.next_index = int(piece.index[-1]) + 1

    @property
    def values(self) -> Values:
        """Values of the points added so far, by field."""
        return {field: values[: self.count] for field, values in self._values.items()}

    @property
    def free_points(self) -> int:
        """Number of points that the block can still take."""
        return BLOCK_POINTS - self.count


def field_names(attributes: tuple[StoredColumn, ...]) -> dict[str, StoredColumn]:
    """Attributes of a file by field names, which differ from the names of `POINT_COLUMNS`."""
    return {f"attribute{k}": column for k, column in enumerate(attributes)}


def attribute_columns(piece: PointPiece, source: str) -> tuple[StoredColumn, ...]:
    """Descriptions of the attributes of a file, from one piece of its points.

    Raises
    ------
    InputError
        If an attribute is neither a number nor an array of numbers.
    """
    columns = []
    for name, values in piece.extra.items():
        if values.dtype.kind not in "biuf" or len(values) != len(piece):
            raise InputError(error("store.attribute", file=source, attribute=name))
        dtype = values.dtype.newbyteorder("<")
        columns.append(StoredColumn(name, dtype.str, values.shape[1:]))
    return tuple(columns)


def require_same_attributes(
    piece: PointPiece, columns: tuple[StoredColumn, ...], source: str
) -> None:
    """Refuse points with other attributes than those before them.

    Raises
    ------
    InputError
        If an attribute is missing, new or of another type.
    """
    found = attribute_columns(piece, source)
    if set(found) != set(columns):
        names = {c.name for c in found} ^ {c.name for c in columns}
        point = int(piece.index[0]) + 1
        if names:
            changed = tuple(sorted(names))
            raise InputError(
                error("store.attributes_change", file=source, point=point, attributes=changed)
            )
        raise InputError(error("store.attribute_types_change", file=source, point=point))


def gather_blocks(
    pieces: Iterator[PointPiece], first: int, running: RunningFingerprint, source: str
) -> Iterator[tuple[PointBlock | None, PointPiece]]:
    """Gather pieces into blocks; a piece that does not fill a block is yielded with None.

    Parameters
    ----------
    first : int
        Number in the line of the first point.
    running : RunningFingerprint
        Fingerprint of the points before it.
    source : str
        Name of the file for error messages.

    Raises
    ------
    InputError
        If attributes change within the line.
    ProjectError
        If a line has more points than can be numbered.
    """
    block: PointBlock | None = None
    columns: tuple[StoredColumn, ...] | None = None
    last: PointPiece | None = None
    for piece in pieces:
        last, start = piece, 0
        if len(piece):
            if columns is None:
                columns = attribute_columns(piece, source)
            require_same_attributes(piece, columns, source)
            if piece.index[-1] >= MAX_POINTS_PER_LINE:
                raise ProjectError(
                    error("store.too_many_points", file=source, limit=MAX_POINTS_PER_LINE)
                )
        filled = False
        while start < len(piece):
            assert columns is not None
            if block is None:
                block = PointBlock(first, columns, running)
            stop = min(len(piece), start + block.free_points)
            block.add(piece.rows(start, stop))
            start = stop
            if not block.free_points:
                yield block, piece
                first, running, block, filled = first + block.count, block.running, None, True
        if not filled:
            yield None, piece
    if block is not None and last is not None:
        yield block, last
