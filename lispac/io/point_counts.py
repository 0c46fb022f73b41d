"""Number of points in a file, compared with the number specified in its header.

Wrong counts in headers come from recorders that were stopped before they wrote the count, and from
programs that append points without updating it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Level, Message, Value

Rows = NDArray[np.uint8]
Flags = NDArray[np.bool_]
BYTES_PER_BLOCK = 1 << 22
"""Bytes searched at once for records that are not zero."""
SAMPLED_RECORDS = 10_000
"""Records beyond the header count that are checked for plausible values."""
MIN_PLAUSIBLE_SHARE = 0.5
"""Smallest share of plausible records for data beyond the header count to be read as points."""


@dataclass(frozen=True)
class PointCounts:
    """Number of points according to the header and in the file.

    Attributes
    ----------
    header : int
        Number of points in the header.
    stored : int
        Number of points in the file, which are read.
    legacy : int
        Second, 32-bit number of points in a LAS 1.4 header; 0 if there is none.
    unread : int
        Bytes after the counted points that do not look like points.
    """

    header: int
    stored: int
    legacy: int = 0
    unread: int = 0

    def messages(self, path: Path) -> tuple[Message, ...]:
        """Warnings and notes about counts that do not fit the file."""
        found: list[Message] = []
        counts: dict[str, Value] = {"file": path.name, "header": self.header, "held": self.stored}
        if self.stored not in (self.header, self.legacy):
            found.append(Message("file.header_count", Level.WARNING, counts))
        elif self.legacy and self.legacy != self.header:
            legacy = {**counts, "legacy": self.legacy}
            found.append(Message("file.legacy_count", Level.NOTE, legacy))
        if self.unread:
            unread = {**counts, "bytes": self.unread}
            found.append(Message("file.unread_bytes", Level.WARNING, unread))
        return tuple(found)


def count_records(
    path: Path, start: int, end: int, size: int, header: int, is_point: Callable[[Rows], Flags]
) -> PointCounts:
    """Count fixed-size records; records of zeros at the end are padding.

    Parameters
    ----------
    start, end : int
        First byte of the records and the byte after the last one.
    size : int
        Bytes of a record.
    header : int
        Number of records in the header.
    is_point : callable
        Function of records (n, size) that returns flags (n,) of those with plausible values.
    """
    stored = max(0, end - start) // size
    if stored <= header:
        return PointCounts(header, stored)
    stored = _count_without_padding(path, start, size, header, stored)
    if stored == header:
        return PointCounts(header, header)
    rows = np.memmap(path, np.uint8, "r", start, (stored, size))
    numbers = np.unique(
        np.linspace(header, stored - 1, min(SAMPLED_RECORDS, stored - header)).astype(int)
    )
    if is_point(np.array(rows[numbers])).mean() >= MIN_PLAUSIBLE_SHARE:
        return PointCounts(header, stored)
    return PointCounts(header, header, unread=end - start - header * size)


def count_rows(path: Path, start: int, columns: int, header: int, after: int) -> PointCounts:
    """Count rows of text; rows beyond the header count are points if their columns match.

    Parameters
    ----------
    start : int
        Byte at which the first point begins.
    columns : int
        Number of values of a point.
    header : int
        Number of points in the header.
    after : int
        Number of rows with other elements after the points.
    """
    rows = matching = length = used = 0
    with path.open("rb") as file:
        file.seek(start)
        for line in file:
            length += len(line)
            if not line.strip():
                continue
            if rows < header or (rows == matching and len(line.split()) == columns):
                matching, used = matching + 1, length
            rows += 1
    stored = min(matching, max(header, rows - after))
    unread = length - used if rows - after > stored else 0
    return PointCounts(header, stored, unread=unread)


def _count_without_padding(path: Path, start: int, size: int, header: int, stored: int) -> int:
    """Number of records up to the last one after ``header`` that is not zero."""
    step = max(1, BYTES_PER_BLOCK // size)
    rows = np.memmap(path, np.uint8, "r", start, (stored, size))
    while stored > header:
        first = max(header, stored - step)
        used = np.flatnonzero(rows[first:stored].any(axis=1))
        if len(used):
            return first + int(used[-1]) + 1
        stored = first
    return stored
