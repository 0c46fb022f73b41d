"""Reading of PLY files with a time, text or binary.

Open3D reads the whole file at once and is not protected against damaged files; the licence of
plyfile is not compatible.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from lispac.errors import InputError
from lispac.io.format_types import (
    IMPOSSIBLE,
    SURE,
    Choice,
    Fact,
    FileFormat,
    FilePreview,
    PointChunk,
)
from lispac.io.point_reader_common import (
    COMMON_OPTIONS,
    HEAD_BYTES,
    POINTS_PER_CHUNK,
    TIME_FIELD_OPTION,
    TIME_UNIT_OPTION,
    head_sniffer,
    report_damage,
    require_not_empty,
)
from lispac.io.points.point_records import (
    PointRecords,
    point_chunk,
    preview_records,
    read_record_columns,
    require_xyz_fields,
)
from lispac.messages import error, note
from lispac.untrusted_values import is_whole_number

NUMPY_TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"), **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"), **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"), **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("int64", "long"), "i8"), **dict.fromkeys(("uint64", "ulong"), "u8"),
    **dict.fromkeys(("float", "float32"), "f4"), **dict.fromkeys(("double", "float64"), "f8"),
}  # fmt: skip
Element = tuple[str, int, list[tuple[str, str]]]
"""Name, count, and name and type of each property."""
BYTE_ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the first line, which is ``ply``."""
    return SURE if head[:4] in (b"ply\n", b"ply\r") else IMPOSSIBLE


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Read the header and the first points.

    Raises
    ------
    InputError
        If the file cannot be read or has no time.
    """
    records = _read_header(path)
    with report_damage(records.path, "PLY"):
        columns = next(read_record_columns(records, 10_000))
        return preview_records(PLY_FORMAT, columns, choice, records)


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read a file in chunks; other properties of the vertices keep their names and types.

    Raises
    ------
    InputError
        If the file is missing, damaged, cut short, empty, or without time.
    """
    resolved = PLY_FORMAT.complete_options(choice)
    records = _read_header(path)
    done = 0
    with report_damage(records.path, "PLY"):
        for columns in read_record_columns(records, POINTS_PER_CHUNK):
            chunk = point_chunk(columns, resolved, records.path, done=done, total=records.count)
            done += len(chunk.time)
            yield chunk


def _read_header(path: Path) -> PointRecords:
    path = require_not_empty(path, "PLY")
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    end = head.find(b"end_header")
    start = head.find(b"\n", end) + 1
    if head[:3] != b"ply" or end < 0 or not start:
        raise InputError(error("ply.header", file=str(path)))
    order, elements, comments = "", [], []
    for line in head[:end].decode("ascii", "replace").splitlines():
        words = line.split()
        if words[:1] == ["format"] and len(words) > 1:
            order = words[1]
        elif words[:1] == ["element"] and len(words) == 3:
            elements.append((words[1], _parse_count(path, words[2]), list[tuple[str, str]]()))
        elif words[:1] == ["property"] and elements:
            elements[-1][2].append((words[-1], " ".join(words[1:-1])))
        elif words[:1] in (["comment"], ["obj_info"]):
            comments.append(" ".join(words[1:]))
    if not order:
        raise InputError(error("ply.no_format", file=str(path)))
    if order not in BYTE_ORDERS:
        raise InputError(error("ply.format", file=str(path), format=order))
    for k, (name, count, properties) in enumerate(elements):
        dtype = _record_dtype(path, name, properties, BYTE_ORDERS[order])
        if name == "vertex":
            require_xyz_fields(path, dtype.names or ())
            facts: dict[str, Fact] = {"format": f"PLY, {order}"}
            if comments:
                facts["comments"] = "; ".join(comments)[:500]
            records = PointRecords(path, dtype, count, start, order == "ascii", facts)
            after = _elements_size(elements[k + 1 :], order)
            return records if after is None else records.with_counted_points(after)
        if order == "ascii":
            start = _position_after_lines(path, start, count)
        else:
            start += count * dtype.itemsize
    raise InputError(error("ply.no_vertices", file=str(path)))


def _elements_size(elements: list[Element], order: str) -> int | None:
    """Rows (text) or bytes (binary) of elements; None for binary lists, whose length varies."""
    if order == "ascii":
        return sum(count for _, count, _ in elements)
    kinds = [(count, kind) for _, count, properties in elements for _, kind in properties]
    if not all(kind in NUMPY_TYPES for _, kind in kinds):
        return None
    return sum(count * np.dtype(NUMPY_TYPES[kind]).itemsize for count, kind in kinds)


def _parse_count(path: Path, text: str) -> int:
    if not is_whole_number(text, 1 << 48):
        raise InputError(error("ply.count", file=str(path), text=text[:20]))
    return int(text)


def _record_dtype(
    path: Path, element: str, properties: list[tuple[str, str]], order: str
) -> np.dtype[Any]:
    fields: dict[str, str] = {}
    for name, kind in properties:
        file = str(path)
        if not kind:
            raise InputError(
                error("ply.property_without_type", file=file, element=element, property=name)
            )
        if kind not in NUMPY_TYPES:
            raise InputError(
                error("ply.property_type", file=file, element=element, property=name, type=kind)
            )
        if name in fields:
            raise InputError(
                error("ply.duplicate_property", file=file, element=element, property=name)
            )
        fields[name] = order + NUMPY_TYPES[kind]
    if not fields:
        raise InputError(error("ply.no_properties", file=str(path), element=element))
    return np.dtype(list(fields.items()))


def _position_after_lines(path: Path, start: int, count: int) -> int:
    with path.open("rb") as file:
        file.seek(start)
        for _ in range(count):
            if not file.readline(HEAD_BYTES):
                break
        return file.tell()


PLY_FORMAT = FileFormat(
    note("format.ply"),
    "ply",
    "points",
    (".ply",),
    (TIME_FIELD_OPTION, TIME_UNIT_OPTION, *COMMON_OPTIONS),
    sniff,
    preview_file,
    read,
)
