"""Headers of LAS and LAZ that do not fit their file, refused before a library believes them.

laspy loops over records that are not there for minutes; lazrs allocates what a chunk table claims
and ends the program where that fails.
"""

import struct
from pathlib import Path

import lazrs

from lispac.errors import InputError

SIGNATURE = b"LASF"
RECORD_HEADER = 54
LASZIP = (b"laszip encoded", 22204)
COMPRESSED = 0x80
"""Bit of the point format number that marks LAZ."""
LARGEST_CHUNK = 1 << 28
"""Bytes of one chunk unpacked; writers make chunks of 50,000 points, a few megabytes."""


def require_sound_header(path: Path) -> None:
    """Refuse counts and sizes that the file is too short for.

    Offsets from the LAS 1.4 specification, table 3: header size, start of the points, number of
    variable length records, point format and record length, and from version 1.4 on the start and
    number of the extended records.

    Raises
    ------
    InputError
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(375)
    if header[:4] != SIGNATURE:
        raise InputError(
            f"{path}: cannot be read as LAS or LAZ (it does not start with LASF, as these do); "
            "check what it is, or export it again."
        )
    if len(header) < 227:
        return  # laspy says so at once
    header_size, points_start, records = struct.unpack_from("<HII", header, 94)
    sound = header_size + RECORD_HEADER * records <= points_start <= size
    if header[24:26] == b"\x01\x04" and len(header) == 375:
        extended_start, extended = struct.unpack_from("<QI", header, 235)
        sound = sound and (extended == 0 or extended_start + 60 * extended <= size)
    point_format, point_size = struct.unpack_from("<BH", header, 104)
    if sound and point_format & COMPRESSED:
        sound = _is_sound_laz(path, size, header_size, points_start, records, point_size)
    elif sound:
        _require_all_points(path, (size - points_start) // max(point_size, 1), header)
    if not sound:
        raise InputError(
            f"{path}: cannot be read as LAS or LAZ (its header does not fit its {size:,} bytes); "
            "copy or export it again."
        )


def _require_all_points(path: Path, held: int, header: bytes) -> None:
    """Refuse a file that ends before the last point that its header promises.

    Raises
    ------
    InputError
    """
    (promised,) = struct.unpack_from("<I", header, 107)
    if header[24:26] == b"\x01\x04" and len(header) >= 255:
        (promised,) = struct.unpack_from("<Q", header, 247)
    if promised > held:
        raise InputError(
            f"{path}: the file ends after point {held:,} of the {promised:,} that its header "
            "promises, so it is cut short; copy or export it again."
        )


def _is_sound_laz(
    path: Path, size: int, header_size: int, points_start: int, records: int, point_size: int
) -> bool:
    with path.open("rb") as file:
        laszip = _laszip_record(file.read(points_start), header_size, records)
        if laszip is None or size < points_start + 8:
            return laszip is None  # laspy says that the record is missing
        file.seek(points_start)
        (table,) = struct.unpack("<q", file.read(8))
        if table == -1:  # written to a stream: the offset is at the end
            file.seek(size - 8)
            (table,) = struct.unpack("<q", file.read(8))
        if not points_start + 8 <= table <= size - 8:
            return False
        file.seek(table + 4)
        (chunks,) = struct.unpack("<I", file.read(4))
        # Every chunk starts with one point as it is.
        if chunks * max(point_size, 1) > size:
            return False
        file.seek(points_start)
        try:
            record = lazrs.LazVlr(laszip)
            table_of_chunks = lazrs.read_chunk_table(file, record)
        except (lazrs.LazrsError, OSError, ValueError):
            return False
    held = sum(length for _, length in table_of_chunks)
    most = max((count for count, _ in table_of_chunks), default=0)
    return bool(
        record.item_size() == point_size
        and held <= size - points_start
        and most * point_size <= LARGEST_CHUNK
    )


def _laszip_record(head: bytes, at: int, records: int) -> bytes | None:
    """Content of LAZ's own variable length record."""
    for _ in range(records):
        if at + RECORD_HEADER > len(head):
            return None
        user, number, length = struct.unpack_from("<16sHH", head, at + 2)
        at += RECORD_HEADER
        if (user.rstrip(b"\0"), number) == LASZIP:
            return head[at : at + length]
        at += length
    return None
