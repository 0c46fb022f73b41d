"""Number of records in the data packets of an E57 file (ASTM E2807, 9.3), without its XML.

libE57 reads the number of records specified in the XML. The packets contain the number of bytes of
each field, which shows whether there are more records.
"""

import re
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any

PAGE_BYTES, PAYLOAD_BYTES = 1024, 1020
"""Bytes of a page, and bytes before its checksum."""
DATA_PACKET_TYPE = 1
"""Type code of a packet with data, and of a section with packets."""
MAX_PADDING_BITS = 64
"""Largest number of bits to which packed integers are padded."""


def excess_records(path: Path, points: list[Any]) -> Iterator[tuple[int, int]]:
    """Specified and actual number of records of each vector that contains more than specified.

    Parameters
    ----------
    points : list of libe57.CompressedVectorNode
        Vectors of points of all scans, in the order of the file.
    """
    with path.open("rb") as file:
        offsets = _vector_offsets(file)
        if len(offsets) != len(points):
            return
        for node, offset in zip(points, offsets, strict=True):
            counted, bits = int(node.childCount()), _field_bits(node)
            stored = counted
            for total, width in zip(_stream_bytes(file, offset), bits, strict=False):
                padding_bits = 0 if width in (32, 64) else MAX_PADDING_BITS
                if width:
                    stored = max(stored, (8 * total - padding_bits) // width)
                    if not padding_bits:
                        break
            if stored > counted:
                yield counted, stored


def _field_bits(node: Any) -> list[int]:
    """Number of bits of one value of each field; 0 if it varies, as for text."""
    from pye57 import libe57

    prototype = libe57.StructureNode(node.prototype())
    found = []
    for k in range(prototype.childCount()):
        field = prototype.get(k)
        kind = field.type()
        if kind == libe57.E57_FLOAT:
            single = libe57.FloatNode(field).precision() == libe57.E57_SINGLE
            found.append(32 if single else 64)
        elif kind == libe57.E57_INTEGER:
            whole = libe57.IntegerNode(field)
            found.append((whole.maximum() - whole.minimum()).bit_length())
        elif kind == libe57.E57_SCALED_INTEGER:
            scaled = libe57.ScaledIntegerNode(field)
            found.append((scaled.maximum() - scaled.minimum()).bit_length())
        else:
            found.append(0)
    return found


def _vector_offsets(file: IO[bytes]) -> list[int]:
    """Physical file offset of each vector of points, from the XML."""
    file.seek(24)
    start, length = struct.unpack("<QQ", file.read(16))
    xml = _read_logical(file, _logical_position(start), length)
    tags = re.findall(rb"<points\b[^>]*>", xml)
    found = [re.search(rb'fileOffset="(\d+)"', tag) for tag in tags]
    return [int(each[1]) for each in found if each]


def _stream_bytes(file: IO[bytes], offset: int) -> list[int]:
    """Bytes of each field in all data packets of a vector that begins at a physical offset."""
    position = _logical_position(offset)
    head = _read_logical(file, position, 32)
    if len(head) < 32 or head[0] != DATA_PACKET_TYPE:
        return []
    length, first = struct.unpack_from("<QQ", head, 8)
    end, position = position + length, _logical_position(first)
    totals: list[int] = []
    while position + 4 <= end:
        head = _read_logical(file, position, 6)
        if len(head) < 6:
            break
        kind, _, size, streams = struct.unpack("<BBHH", head)
        if kind == DATA_PACKET_TYPE:
            lengths = struct.unpack(f"<{streams}H", _read_logical(file, position + 6, 2 * streams))
            totals = [a + b for a, b in zip(totals or [0] * streams, lengths, strict=True)]
        position += size + 1
    return totals


def _logical_position(physical: int) -> int:
    page, within = divmod(physical, PAGE_BYTES)
    return page * PAYLOAD_BYTES + within


def _read_logical(file: IO[bytes], logical: int, count: int) -> bytes:
    """Read bytes from a logical offset, without the checksums between them."""
    page, within = divmod(logical, PAYLOAD_BYTES)
    pages = -(-(within + count) // PAYLOAD_BYTES)
    file.seek(page * PAGE_BYTES)
    data = file.read(pages * PAGE_BYTES)
    plain = b"".join(data[k : k + PAYLOAD_BYTES] for k in range(0, len(data), PAGE_BYTES))
    return plain[within : within + count]
