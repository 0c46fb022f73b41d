"""Reading of PCD files of the Point Cloud Library with a time: text, binary or compressed (LZF).

Open3D's legacy reader ignores the time. Its tensor reader reads the whole file at once and is not
protected against damaged files. No other dependency reads PCD, so it is read here.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
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
from lispac.io.point_counts import PointCounts
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
    Columns,
    PointRecords,
    point_chunk,
    preview_records,
    read_record_columns,
    require_xyz_fields,
)
from lispac.messages import error, note
from lispac.untrusted_values import INTEGER_LIMIT, is_whole_number

NUMPY_TYPES = {
    ("I", 1): "<i1", ("I", 2): "<i2", ("I", 4): "<i4", ("I", 8): "<i8",
    ("U", 1): "<u1", ("U", 2): "<u2", ("U", 4): "<u4", ("U", 8): "<u8",
    ("F", 4): "<f4", ("F", 8): "<f8",
}  # fmt: skip
REQUIRED_KEYS = ("FIELDS", "SIZE", "TYPE", "POINTS", "DATA")
MAX_EXPANSION = 300
"""Largest accepted ratio of unpacked to packed bytes. LZF unpacks three bytes to at most 264, so
that a larger ratio means a wrong header."""


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the first lines: PCD files name their version and fields there."""
    start = head[:2048]
    return (
        SURE
        if b"VERSION" in start and b"FIELDS" in start and b"\0" not in start[:20]
        else IMPOSSIBLE
    )


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Read the header and the first points.

    Raises
    ------
    InputError
        If the file cannot be read or has no time.
    """
    records, kind = _read_header(path)
    with report_damage(records.path, "PCD"):
        columns = _without_missing_returns(next(_read_columns(records, kind, 100_000)))
        return preview_records(PCD_FORMAT, columns, choice, records)


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read a file in chunks; other fields keep their names and types.

    A point with three NaN coordinates is excluded: PCL marks missing returns in this way.

    Raises
    ------
    InputError
        If the file is missing, damaged, cut short, empty, or without time.
    """
    resolved = PCD_FORMAT.complete_options(choice)
    records, kind = _read_header(path)
    done = 0
    with report_damage(records.path, "PCD"):
        for columns in _read_columns(records, kind, POINTS_PER_CHUNK):
            returns = _without_missing_returns(columns)
            if len(returns["x"]):
                yield point_chunk(returns, resolved, records.path, done=done, total=records.count)
            done += len(columns["x"])


def _without_missing_returns(columns: Columns) -> Columns:
    missing = np.isnan(columns["x"]) & np.isnan(columns["y"]) & np.isnan(columns["z"])
    return (
        {name: values[~missing] for name, values in columns.items()} if missing.any() else columns
    )


def _read_columns(records: PointRecords, kind: str, rows: int) -> Iterator[Columns]:
    blocks = (
        read_record_columns(records, rows)
        if kind != "binary_compressed"
        else _read_compressed(records, rows)
    )
    for columns in blocks:
        yield {name: values for name, values in columns.items() if not name.startswith("_")}


def _read_header(path: Path) -> tuple[PointRecords, str]:
    path = require_not_empty(path, "PCD")
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    entries: dict[str, list[str]] = {}
    start = 0
    while "DATA" not in entries:
        end = head.find(b"\n", start) + 1
        if not end:
            raise InputError(error("pcd.header", file=str(path)))
        words = head[start:end].decode("ascii", "replace").split()
        if words and not words[0].startswith("#"):
            entries[words[0].upper()] = words[1:]
        start = end
    if missing := [name for name in REQUIRED_KEYS if not entries.get(name)]:
        raise InputError(error("pcd.header_incomplete", file=str(path), entries=tuple(missing)))
    kind = entries["DATA"][0].lower()
    if kind not in ("ascii", "binary", "binary_compressed"):
        raise InputError(error("pcd.data_kind", file=str(path), kind=kind[:20]))
    try:
        dtype, count = _record_dtype(path, entries), _parse_whole_number(entries["POINTS"][0])
    except ValueError as failure:
        raise InputError(
            error("pcd.header_damaged", file=str(path), reason=str(failure))
        ) from failure
    if count < 0:
        raise InputError(error("pcd.point_count", file=str(path), header=count))
    require_xyz_fields(path, dtype.names or ())
    facts: dict[str, Fact] = {"format": f"PCD, {kind}"}
    view = entries.get("VIEWPOINT", [])
    if view and view != ["0", "0", "0", "1", "0", "0", "0"]:
        facts["viewpoint"] = note("fact.viewpoint", values=" ".join(view)[:100])
    records = PointRecords(path, dtype, count, start, kind == "ascii", facts)
    return _with_unpacked_count(
        records
    ) if kind == "binary_compressed" else records.with_counted_points(), kind


def _record_dtype(path: Path, entries: Mapping[str, list[str]]) -> np.dtype[Any]:
    names, sizes, kinds = entries["FIELDS"], entries["SIZE"], entries["TYPE"]
    counts = entries.get("COUNT", ["1"] * len(names))
    fields: list[tuple[str, str] | tuple[str, str, tuple[int]]] = []
    for k, (name, size, kind, many) in enumerate(zip(names, sizes, kinds, counts, strict=True)):
        number = _parse_whole_number(many)
        if (kind.upper(), _parse_whole_number(size)) not in NUMPY_TYPES or not 1 <= number <= 4096:
            raise InputError(
                error(
                    "pcd.field_type", file=str(path), field=name[:20], type=kind[:5],
                    size=size[:5], number=many[:9],
                )
            )  # fmt: skip
        numpy_type = NUMPY_TYPES[kind.upper(), _parse_whole_number(size)]
        key = f"_{k}" if name == "_" else name  # padding has no name
        fields.append((key, numpy_type) if number == 1 else (key, numpy_type, (number,)))
    if len({field[0] for field in fields}) != len(fields):
        raise InputError(error("pcd.duplicate_field", file=str(path)))
    return np.dtype(fields)


def _parse_whole_number(text: str) -> int:
    """Parse an integer in a header.

    Raises
    ------
    ValueError
        If the text is not an integer; the message is the text.
    """
    if not is_whole_number(text.removeprefix("-"), INTEGER_LIMIT):
        raise ValueError(text[:20])
    return int(text)


def _with_unpacked_count(records: PointRecords) -> PointRecords:
    """Records with the unpacked number of points, if it is larger than that of the header."""
    with records.path.open("rb") as file:
        file.seek(records.start + 4)
        data = file.read(4)
    if len(data) < 4:
        return records
    stored, rest = divmod(int.from_bytes(data, "little"), records.dtype.itemsize)
    if rest or stored <= records.count:
        return records
    counts = PointCounts(records.count, stored)
    return replace(records, count=stored, messages=counts.messages(records.path))


def _read_compressed(records: PointRecords, rows: int) -> Iterator[Columns]:
    """Read compressed data, which is unpacked completely: it has one field after the other.

    Raises
    ------
    InputError
        If the data are damaged or missing.
    """
    path, size = records.path, records.path.stat().st_size
    if not records.count:
        raise InputError(error("file.no_points", file=str(path)))
    with path.open("rb") as file:
        file.seek(records.start)
        lengths = np.frombuffer(file.read(8), "<u4")
        packed = np.frombuffer(file.read(), np.uint8)
    whole = records.count * records.dtype.itemsize
    if len(lengths) != 2 or lengths[0] > len(packed) or lengths[1] != whole:
        raise InputError(
            error("pcd.compressed_size", file=str(path), header=records.count, size=size)
        )
    packed = packed[: int(lengths[0])]
    if whole > MAX_EXPANSION * len(packed):
        raise InputError(error("pcd.compressed_damaged", file=str(path)))
    data = np.empty(whole, np.uint8)
    if _unpack_lzf(packed, data) != whole:
        raise InputError(error("pcd.compressed_damaged", file=str(path)))
    columns, position = {}, 0
    for name in records.dtype.names or ():
        field = records.dtype.fields[name][0] if records.dtype.fields else np.dtype("u1")
        length = field.itemsize * records.count
        shape = (records.count, *field.shape)
        columns[name] = data[position : position + length].view(field.base).reshape(shape)
        position += length
    for start in range(0, records.count, rows):
        yield {name: values[start : start + rows] for name, values in columns.items()}


@njit(nogil=True, cache=True)
def _unpack_lzf(packed: NDArray[np.uint8], data: NDArray[np.uint8]) -> int:
    """Unpack LZF; returns the number of bytes written, or -1 if the packed bytes are not valid."""
    i = o = 0
    while i < len(packed):
        control = int(packed[i])
        i += 1
        if control < 32:  # a run of ``control + 1`` literal bytes
            length = control + 1
            if i + length > len(packed) or o + length > len(data):
                return -1
            for k in range(length):
                data[o + k] = packed[i + k]
            i += length
        else:  # a copy of bytes already written
            length = control >> 5
            if length == 7:
                if i >= len(packed):
                    return -1
                length += int(packed[i])
                i += 1
            if i >= len(packed):
                return -1
            back = ((control & 31) << 8) + int(packed[i]) + 1
            i += 1
            length += 2
            if back > o or o + length > len(data):
                return -1
            for k in range(length):
                data[o + k] = data[o - back + k]
        o += length
    return o


PCD_FORMAT = FileFormat(
    note("format.pcd"),
    "pcd",
    "points",
    (".pcd",),
    (TIME_FIELD_OPTION, TIME_UNIT_OPTION, *COMMON_OPTIONS),
    sniff,
    preview_file,
    read,
)
