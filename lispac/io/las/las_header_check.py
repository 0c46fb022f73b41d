"""Checks of LAS and LAZ headers against the file, before a library reads it.

If the header is wrong, laspy loops over missing records for minutes and reads only as many points
as the header states. lazrs allocates the memory that a chunk table states and terminates the
program if the allocation fails.
"""

import struct
from dataclasses import replace
from pathlib import Path

import lazrs
import numpy as np

from lispac.errors import InputError
from lispac.io.las.laz_chunks import VLR_HEADER_BYTES, read_chunk_table
from lispac.io.point_counts import Flags, PointCounts, Rows, count_records
from lispac.messages import error

SIGNATURE = b"LASF"
COMPRESSION_BIT = 0x80
"""Bit of the point format number that marks LAZ."""
INTERNAL_WAVEFORMS_BIT = 0x02
"""Bit of the global encoding: waveforms follow the points."""
SCALE_LIMITS = (1e-12, 1000.0)
"""Smallest and largest accepted scale of coordinates, metres, feet or degrees."""
TIME_OFFSETS = {1: 20, 3: 20, 4: 20, 5: 20, 6: 22, 7: 22, 8: 22, 9: 22, 10: 22}
"""Byte offset of gps_time in a record, by point format."""
MAX_TIME_S = 1e11
SECONDS_PER_WEEK = 604_800.0


def require_sound_header(path: Path) -> PointCounts:
    """Refuse sizes that do not fit the file, and count its points.

    Offsets are those of the LAS 1.4 specification, table 3: header size, start of the points,
    number of variable length records, point format and record length, number of points, and from
    version 1.4 on the start and number of the extended records and the 64-bit number of points.

    Raises
    ------
    InputError
        If the file has no LAS signature, or its header does not fit its size.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(375)
    if header[:4] != SIGNATURE:
        raise InputError(error("las.signature", file=str(path)))
    counts = _count_points(path, size, header) if len(header) >= 227 else None
    if counts is None:
        raise InputError(error("las.header", file=str(path), size=size))
    return counts


def _count_points(path: Path, size: int, header: bytes) -> PointCounts | None:
    """Count the points by header and by file; None if the sizes do not fit.

    Raises
    ------
    InputError
        If points are missing or the scales of the coordinates are not valid.
    """
    scales = struct.unpack_from("<3d", header, 131)
    if not all(SCALE_LIMITS[0] <= scale <= SCALE_LIMITS[1] for scale in scales):
        raise InputError(error("las.scale", file=str(path), scale=[f"{each:g}" for each in scales]))
    header_size, points_start, records = struct.unpack_from("<HII", header, 94)
    point_format, point_size, count = struct.unpack_from("<BHI", header, 104)
    legacy, end = 0, size
    if not (header_size + VLR_HEADER_BYTES * records <= points_start <= size and point_size):
        return None
    if header[24:26] >= b"\x01\x03" and header[6] & INTERNAL_WAVEFORMS_BIT and len(header) >= 235:
        (waveforms,) = struct.unpack_from("<Q", header, 227)
        end = waveforms if points_start < waveforms < end else end
    if header[24:26] >= b"\x01\x04" and len(header) == 375:
        legacy = count
        extended_start, extended, count = struct.unpack_from("<QIQ", header, 235)
        if extended:
            if extended_start + 60 * extended > size:
                return None
            end = extended_start if points_start < extended_start < end else end
    if point_format & COMPRESSION_BIT:
        counts = _count_chunk_points(
            path, header_size, points_start, records, point_size, count or legacy
        )
    else:
        first = _first_time(path, points_start, point_format)
        counts = count_records(
            path,
            points_start,
            end,
            point_size,
            count or legacy,
            lambda rows: _are_plausible_records(
                rows, point_format, first if count or legacy else None
            ),
        )
    if counts is None:
        return None
    counts = replace(counts, header=count, legacy=legacy)
    if counts.stored < count and counts.stored != legacy:
        raise InputError(
            error("file.points_missing", file=str(path), header=count, held=counts.stored)
        )
    return counts


def _count_chunk_points(
    path: Path, header_size: int, points_start: int, records: int, point_size: int, count: int
) -> PointCounts | None:
    chunks = read_chunk_table(path, header_size, points_start, records, point_size)
    if chunks is None:
        return None
    try:
        return PointCounts(count, chunks.points(count))
    except (lazrs.LazrsError, struct.error):
        return None


def _first_time(path: Path, points_start: int, point_format: int) -> float | None:
    """Time of the first record, seconds; None if records have no time."""
    if point_format not in TIME_OFFSETS:
        return None
    with path.open("rb") as file:
        file.seek(points_start + TIME_OFFSETS[point_format])
        value = file.read(8)
    return float(struct.unpack("<d", value)[0]) if len(value) == 8 else None


def _are_plausible_records(rows: Rows, point_format: int, first: float | None) -> Flags:
    """Flags of records (n, size) that may be points: their time is within a week of the first.

    In point formats without time, all records that are not zero may be points.
    """
    if point_format not in TIME_OFFSETS:
        return np.asarray(rows.any(axis=1))
    offset = TIME_OFFSETS[point_format]
    time = rows[:, offset : offset + 8].copy().view("<f8")[:, 0]
    with np.errstate(invalid="ignore", over="ignore"):
        usable = np.abs(time) <= MAX_TIME_S
        if first is not None and abs(first) <= MAX_TIME_S:
            usable &= np.abs(time - first) <= SECONDS_PER_WEEK
    return np.asarray(usable & ((time == 0) | (np.abs(time) > 1e-9)))
