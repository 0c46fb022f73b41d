"""Chunks of compressed points in LAZ, and the number of points in them.

A chunk table gives the bytes of each chunk and, for chunks of variable size, its number of points.
With chunks of fixed size, only the number of points in the last chunk is unknown. Point formats
from 6 on store it after the first record of the chunk. For the others it is found by decoding: the
right number of points uses exactly the bytes that the encoder wrote.
"""

import io
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import lazrs

VLR_HEADER_BYTES = 54
LASZIP_RECORD_ID = (b"laszip encoded", 22204)
MAX_CHUNK_BYTES = 1 << 28
"""Largest accepted size of an unpacked chunk, bytes; chunks of 50,000 points have a few MB."""
CHUNK_OVERHEAD_BYTES = 4096
"""Bytes that a chunk may use in addition to its points."""
LAYERED_COMPRESSOR = 3
"""Code of the compressor for point formats from 6 on."""
LAYERS_BY_ITEM_TYPE = {10: 9, 11: 1, 12: 2, 13: 1}
"""Number of layers of each item of a record (point, RGB, RGB with NIR, waveform), by item type.
Each extra byte has a layer of its own (LAZ specification 1.4)."""
EXTRA_BYTES_ITEM_TYPE = 14


@dataclass(frozen=True)
class LazChunks:
    """Positions of the chunks of a LAZ file.

    Attributes
    ----------
    path : Path
    start : int
        Byte at which the first chunk begins.
    record : bytes
        Content of LAZ's variable length record.
    table : tuple of (int, int)
        Points and bytes of each chunk; with a fixed chunk size the last may have fewer points.
    """

    path: Path
    start: int
    record: bytes
    table: tuple[tuple[int, int], ...]

    def points(self, header: int) -> int:
        """Number of points in all chunks.

        Parameters
        ----------
        header : int
            Number of points in the header, which is tried first.

        Raises
        ------
        lazrs.LazrsError
            If the last chunk is damaged.
        """
        laz = lazrs.LazVlr(self.record)
        whole = sum(count for count, _ in self.table)
        if laz.uses_variable_size_chunks() or not self.table:
            return int(whole)
        limit, length = self.table[-1]
        before = whole - limit
        with self.path.open("rb") as file:
            file.seek(self.start + sum(size for _, size in self.table[:-1]))
            data = file.read(length)
        if self.record[0] == LAYERED_COMPRESSOR:
            (last,) = struct.unpack_from("<I", data, laz.item_size())
            return int(before + last) if 0 < last <= limit else header
        return int(before + _CompressedLastChunk(data, self.record).points(header - before, limit))


@dataclass(frozen=True)
class _CompressedLastChunk:
    """Last chunk of a LAZ file, as stored; its number of points is unknown."""

    data: bytes
    record: bytes

    def points(self, likely: int, limit: int) -> int:
        """Find the number of points whose decoding uses all bytes; ``likely`` is tried first.

        Raises
        ------
        lazrs.LazrsError
            If no number of points uses exactly all bytes.
        """
        if 0 < likely <= limit and self._can_decode(likely) and not self._can_decode(likely, 1):
            return likely
        low, high = 0, limit
        while low < high:
            middle = (low + high + 1) // 2
            low, high = (middle, high) if self._can_decode(middle, 1) else (low, middle - 1)
        if not self._can_decode(low + 1):
            raise lazrs.LazrsError("the last chunk is damaged")
        return low + 1

    def _can_decode(self, count: int, missing: int = 0) -> bool:
        """True if ``count`` points can be decoded without the last ``missing`` bytes."""
        laz = lazrs.LazVlr(self.record)
        stream = io.BytesIO()
        stream.write(struct.pack("<q", 8 + len(self.data)) + self.data)
        lazrs.write_chunk_table(stream, [(laz.chunk_size(), len(self.data))], laz)
        stream.seek(0)
        decoder = lazrs.LasZipDecompressor(stream, self.record)
        stream.truncate(8 + len(self.data) - missing)
        try:
            decoder.decompress_many(bytearray(count * laz.item_size()))
        except lazrs.LazrsError:
            return False
        return True


def read_chunk_table(
    path: Path, header_size: int, points_start: int, records: int, point_size: int
) -> LazChunks | None:
    """Read the chunk table; None if it does not fit the file.

    The sizes are checked because lazrs allocates the memory that a chunk table states and
    terminates the program if the allocation fails.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        record = _laszip_record(file.read(points_start), header_size, records)
        if record is None or size < points_start + 8:
            return None
        file.seek(points_start)
        (table,) = struct.unpack("<q", file.read(8))
        if table == -1:  # written to a stream: the offset is at the end
            file.seek(size - 8)
            (table,) = struct.unpack("<q", file.read(8))
        if not points_start + 8 <= table <= size - 8:
            return None
        file.seek(table + 4)
        (chunks,) = struct.unpack("<I", file.read(4))
        # Every chunk starts with one uncompressed point.
        if chunks * max(point_size, 1) > size:
            return None
        file.seek(points_start)
        try:
            laz = lazrs.LazVlr(record)
            found = tuple(entry for entry in lazrs.read_chunk_table(file, laz) if entry[1])
        except (lazrs.LazrsError, OSError, ValueError):
            return None
        if record[0] == LAYERED_COMPRESSOR and not _do_layers_fit(
            file, points_start + 8, record, found
        ):
            return None
    total_size = sum(length for _, length in found)
    largest = max((count for count, _ in found), default=0)
    sound = (
        laz.item_size() == point_size
        and total_size <= size - points_start
        and largest * point_size <= MAX_CHUNK_BYTES
        # Random bits compress to little more than their own size; lazrs panics if a chunk has far
        # more bytes than its points can use.
        and all(length <= 2 * count * point_size + CHUNK_OVERHEAD_BYTES for count, length in found)
    )
    return LazChunks(path, points_start + 8, record, found) if sound else None


def _do_layers_fit(
    file: BinaryIO, at: int, record: bytes, table: tuple[tuple[int, int], ...]
) -> bool:
    """True if the layers of each chunk lie within it; lazrs allocates the sizes they state.

    A layered chunk contains its first point, the number of points, the layer sizes and the layers.
    """
    (items,) = struct.unpack_from("<H", record, 32)
    layers = point = 0
    for kind, size, _ in struct.iter_unpack("<3H", record[34 : 34 + 6 * items]):
        layers += size if kind == EXTRA_BYTES_ITEM_TYPE else LAYERS_BY_ITEM_TYPE.get(kind, 0)
        point += size
    head = point + 4 + 4 * layers
    for _, length in table:
        file.seek(at + point + 4)
        sizes = file.read(4 * layers)
        if (
            len(sizes) < 4 * layers
            or head + sum(v for (v,) in struct.iter_unpack("<I", sizes)) > length
        ):
            return False
        at += length
    return True


def _laszip_record(head: bytes, at: int, records: int) -> bytes | None:
    """Content of LAZ's own variable length record."""
    for _ in range(records):
        if at + VLR_HEADER_BYTES > len(head):
            return None
        user, number, length = struct.unpack_from("<16sHH", head, at + 2)
        at += VLR_HEADER_BYTES
        if (user.rstrip(b"\0"), number) == LASZIP_RECORD_ID:
            return head[at : at + length]
        at += length
    return None
