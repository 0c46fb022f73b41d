"""Points stored as records of fields after a text header, as in PLY and PCD."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.format_types import (
    SAME_TIME_BASE_NOTE,
    Choice,
    Fact,
    FileFormat,
    FilePreview,
    PointChunk,
)
from lispac.io.point_counts import Flags, Rows, count_records, count_rows
from lispac.io.point_reader_common import (
    PREVIEW_POINTS,
    SECONDS_PER_UNIT,
    coordinate_scale,
    find_time_field,
    frame_facts,
    preview_table,
    require_usable_points,
    time_base_message,
    time_base_warnings,
    time_resolution,
    usable_points,
)
from lispac.io.units import TIME_UNIT_NAMES
from lispac.messages import Message, error, note, warning
from lispac.survey.line_source import printable
from lispac.survey.point_screening import MAX_COORDINATE

BYTES_PER_READ = 1 << 28  # bytes of records read at once
Columns = Mapping[str, NDArray[Any]]


@dataclass(frozen=True)
class PointRecords:
    """Position, fields and number of the point records of a file.

    Attributes
    ----------
    path : Path
    dtype : numpy.dtype
        Structured: the fields of one point, in the byte order of the file.
    count : int
        Number of points to read.
    start : int
        Byte at which the points begin.
    ascii : bool
        Whether the points are text, one per row.
    facts : mapping of str to Fact
        Other contents of the header.
    messages : tuple of Message
        Warnings about the number of points.
    """

    path: Path
    dtype: np.dtype[Any]
    count: int
    start: int
    ascii: bool
    facts: Mapping[str, Fact]
    messages: tuple[Message, ...] = ()

    def with_counted_points(self, after: int = 0) -> "PointRecords":
        """Records with all points in the file, if its header specifies fewer.

        Parameters
        ----------
        after : int
            Bytes, or rows of text, of other elements after the points in the file.
        """
        if self.ascii:
            columns = sum(max(1, np.prod(kind.shape)) for kind, *_ in self._dtype_fields)
            counts = count_rows(self.path, self.start, int(columns), self.count, after)
        else:
            end = self.path.stat().st_size - after
            counts = count_records(
                self.path, self.start, end, self.dtype.itemsize, self.count, self._are_points
            )
        if counts.stored < self.count:
            return self
        return replace(self, count=counts.stored, messages=counts.messages(self.path))

    @property
    def _dtype_fields(self) -> list[tuple[Any, ...]]:
        return list((self.dtype.fields or {}).values())

    def _are_points(self, rows: Rows) -> Flags:
        """Flags of records (n, size) with usable coordinates, or three NaN for a missing return."""
        values = rows.view(self.dtype)[:, 0]
        xyz = np.stack([values[axis].astype(np.float64) for axis in "xyz"], axis=1)
        with np.errstate(invalid="ignore"):
            usable = (np.abs(xyz) <= MAX_COORDINATE).all(axis=1)
        return np.asarray(usable | np.isnan(xyz).all(axis=1))

    def require_whole(self) -> None:
        """Refuse a header that states more points than the file contains.

        Raises
        ------
        InputError
            If the header specifies no points, or more than fit into the file.
        """
        if not self.count:
            raise InputError(error("file.no_points", file=str(self.path)))
        min_record_bytes = 2 * len(self.dtype.names or ()) if self.ascii else self.dtype.itemsize
        stored = (self.path.stat().st_size - self.start) // min_record_bytes
        if stored < self.count - (1 if self.ascii else 0):
            available = max(stored, 0)
            raise InputError(
                error("file.points_no_room", file=str(self.path), header=self.count, room=available)
            )


def read_record_columns(records: PointRecords, rows: int) -> Iterator[Columns]:
    """Read the columns of up to ``rows`` points at a time, as stored.

    Raises
    ------
    InputError
        If the file ends early.
    """
    records.require_whole()
    rows = max(1, min(rows, BYTES_PER_READ // records.dtype.itemsize))
    with records.path.open("rb") as file:
        file.seek(records.start)
        done = 0
        while done < records.count:
            count = min(rows, records.count - done)
            block = (
                _read_text(file, records, count, done)
                if records.ascii
                else _read_binary(file, records, count)
            )
            if len(block) != count:
                raise InputError(
                    error(
                        "file.points_missing", file=str(records.path), header=records.count,
                        held=done + len(block),
                    )
                )  # fmt: skip
            done += count
            yield {name: block[name] for name in records.dtype.names or ()}


def _read_binary(file: IO[bytes], records: PointRecords, count: int) -> NDArray[Any]:
    data = file.read(count * records.dtype.itemsize)
    return np.frombuffer(data[: len(data) // records.dtype.itemsize * records.dtype.itemsize],
                         records.dtype)  # fmt: skip


def _read_text(file: IO[bytes], records: PointRecords, count: int, done: int) -> NDArray[Any]:
    lines = []
    for _ in range(count):
        line = file.readline(1 << 16)
        if not line:
            break
        lines.append(line.decode("ascii", "replace"))
    if not lines:
        return np.empty(0, records.dtype)
    try:
        return np.loadtxt(lines, dtype=records.dtype, ndmin=1, comments=None)
    except ValueError as failure:
        for number, text in enumerate(lines, start=done + 1):
            try:
                np.loadtxt([text], dtype=records.dtype, ndmin=1, comments=None)
            except ValueError:
                raise InputError(
                    error(
                        "file.point_not_numbers", file=str(records.path), point=number,
                        text=text.strip()[:60], values=len(records.dtype.names or ()),
                    )
                ) from failure  # fmt: skip
        raise


def point_chunk(
    columns: Columns, choice: Choice, path: Path, *, done: int, total: int | None
) -> PointChunk:
    """Make a chunk from columns, of which some are named x, y, z and a time.

    Raises
    ------
    InputError
        If there is no time or a value is not a number.
    """
    name = find_time_field(path, tuple(columns), str(choice["time_field"]))
    if columns[name].ndim > 1:
        raise InputError(error("file.several_values", file=str(path), field=name))
    xyz = np.stack([columns[axis].astype(np.float64) for axis in "xyz"], axis=1)
    time = columns[name]
    factor = SECONDS_PER_UNIT[choice["time_unit"]]
    in_seconds = time * np.float32(factor) if time.dtype == np.float32 else time * factor
    require_usable_points(xyz, in_seconds, path, done)
    extra = {
        key: np.ascontiguousarray(values).astype(values.dtype.newbyteorder("="), copy=False)
        for key, values in columns.items()
        if key not in ("x", "y", "z", name)
    }
    return PointChunk(xyz * coordinate_scale(choice), in_seconds.astype(np.float64), extra, total)


def require_xyz_fields(path: Path, names: tuple[str, ...]) -> None:
    """Refuse records without the fields x, y and z.

    Raises
    ------
    InputError
        If one of the three fields is missing.
    """
    if missing := [axis for axis in "xyz" if axis not in names]:
        raise InputError(
            error("file.no_coordinates", file=str(path), axes=tuple(missing), fields=tuple(names))
        )


def preview_records(
    format_: FileFormat, columns: Columns, choice: Choice, records: PointRecords
) -> FilePreview:
    """Facts and warnings of the first points."""
    path, count = records.path, records.count
    given_choice, choice = choice, format_.complete_options(choice)
    first = {name: values[:PREVIEW_POINTS] for name, values in columns.items()}
    field = find_time_field(path, tuple(first), str(choice["time_field"]))
    chunk = point_chunk(first, {**choice, "unit": "metre"}, path, done=0, total=count)
    chunk = usable_points(chunk)
    stored_time = first[field]
    file = printable(path.name)
    points_check = check_first_points(chunk.xyz, chunk.time, file=file, crs=str(choice["crs"]))
    file_warnings = list(points_check.file_warnings)
    step = time_resolution(stored_time, SECONDS_PER_UNIT[choice["time_unit"]])
    if step > 1e-4 and not any(each.code == "times.coarse" for each in file_warnings):
        file_warnings.append(warning("times.coarse", file=file, step=step))
    if np.issubdtype(stored_time.dtype, np.integer) and choice["time_unit"] == "second":
        file_warnings.append(warning("times.whole_numbers", file=file))
    farthest = float(np.abs(chunk.xyz).max())
    coordinate_step = float(np.spacing(np.float32(farthest)))
    if any(first[axis].dtype == np.float32 for axis in "xyz") and coordinate_step > 1e-3:
        file_warnings.append(
            warning("points.coordinates_32_bits", file=file, step=coordinate_step, largest=farthest)
        )
    found = {"frame": points_check.frame, "time_field": field}
    resolved = format_.complete_options({**found, **given_choice})
    return FilePreview(
        {
            **records.facts,
            "points": count,
            **frame_facts(resolved),
            "time base": time_base_message(chunk.time, str(choice["time_base"])),
            **points_check.facts,
            "fields": ", ".join(first),
        },
        preview_table(tuple(first), tuple(first.values())),
        found,
        (*file_warnings, *time_base_warnings(chunk.time, str(choice["time_base"]), file)),
        (
            note(
                "assumed.time_field", field=field,
                unit=TIME_UNIT_NAMES[SECONDS_PER_UNIT[choice["time_unit"]]],
            ),
            SAME_TIME_BASE_NOTE,
        ),
        records.messages,
    )  # fmt: skip
