"""Reading of points as text, plain or gzipped, one point per row.

The columns are named by the first row or by the user.
"""

import gzip
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import IO, cast

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.format_types import (
    IMPOSSIBLE,
    LIKELY,
    POSSIBLE,
    SAME_TIME_BASE_NOTE,
    Choice,
    Fact,
    FileFormat,
    FilePreview,
    FormatOption,
    PointChunk,
)
from lispac.io.point_reader_common import (
    CHOOSE_TIME_BASE_ACTION,
    COMMON_OPTIONS,
    HEAD_BYTES,
    POINTS_PER_CHUNK,
    PREVIEW_POINTS,
    PREVIEW_ROWS,
    SCANNER_FRAME,
    SCANNER_UNITS,
    SECONDS_PER_UNIT,
    TIME_UNIT_OPTION,
    USE_FEET_ACTIONS,
    coordinate_scale,
    frame_facts,
    head_sniffer,
    report_damage,
    require_not_empty,
    require_usable_points,
    time_base_message,
    usable_points,
)
from lispac.io.text.text_layout import (
    REQUIRED_COLUMNS,
    SEPARATOR_CHARACTERS,
    RowLayout,
    data_rows,
    guess_layout,
)
from lispac.io.text.text_table import clock_seconds, is_clock
from lispac.io.text.text_units import (
    column_title_warnings,
    easting_unit_warnings,
    header_options,
    height_unit_of,
    require_cartesian,
    require_degrees,
    require_one_unit,
)
from lispac.io.units import TIME_UNIT_NAMES
from lispac.language import N_
from lispac.messages import Message, error, note, warning
from lispac.survey.line_source import printable

COLUMNS_OPTION = FormatOption(
    "columns",
    N_(
        "Names of the columns from the left, separated by blanks. time x y z are needed; - skips a "
        "column. Empty: as in the first row of the file."
    ),
)
SEPARATOR_OPTION = FormatOption(
    "separator", N_("Separator of the columns."), ("auto", *SEPARATOR_CHARACTERS), "auto"
)
DECIMAL_OPTION = FormatOption("decimal", N_("Decimal sign."), ("auto", "point", "comma"), "auto")
BYTES_PER_BLOCK = 8 << 20  # bytes parsed at once
GZIP_SIGNATURE, UTF16_MARKS = b"\x1f\x8b", (b"\xff\xfe", b"\xfe\xff")


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the numbers per row and the names time, x, y and z in a first row."""
    if head.startswith(GZIP_SIGNATURE):
        head = zlib.decompressobj(wbits=31).decompress(head, HEAD_BYTES)
    if b"\0" in head:
        return IMPOSSIBLE
    lines = _decode_text(head).splitlines()[:100]
    layout, rows = guess_layout(lines), data_rows(lines)
    body = rows[layout.first : -1] or rows[layout.first :]  # the last row may be incomplete
    if not body or not all(layout.is_numeric_row(row) for row in body):
        return IMPOSSIBLE
    return LIKELY if set(REQUIRED_COLUMNS) <= set(layout.names) else POSSIBLE


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Read the first rows, and detect separator, decimal sign and columns.

    Raises
    ------
    InputError
        If the file cannot be read or contains no rows of numbers.
    """
    path = require_not_empty(path, "text")
    file = printable(path.name)
    found, layout, lines = _detect_options(path)
    if not choice.get("columns"):
        require_degrees(path, layout)
    rows = data_rows(lines)
    resolved = _merge_options(found, choice)
    shown = [layout.fields(row) for row in rows[layout.first : layout.first + PREVIEW_ROWS]]
    columns = resolved["columns"].split()
    head = (
        columns if len(columns) == len(shown[0]) else [f"{k}" for k in range(1, 1 + len(shown[0]))]
    )
    preview = tuple(tuple(row) for row in (head, *shown))
    facts: dict[str, Fact] = {
        "format": note("fact.text_gzipped" if _is_gzipped(path) else "fact.text"),
        "separator": resolved["separator"],
        "decimal": resolved["decimal"],
        "columns": resolved["columns"] or note("fact.not_named"),
    }
    if not columns:
        not_named = warning("text.columns_not_named", file=file)
        return FilePreview({**facts, **frame_facts(resolved)}, preview, found, (not_named,))
    chunk = next(_read_chunks(path, resolved, PREVIEW_POINTS), None)
    if chunk is None:
        raise InputError(error("line.no_points", file=str(path)))
    require_usable_points(chunk.xyz, chunk.time, path)
    chunk = usable_points(chunk)
    metres = SCANNER_UNITS[str(choice.get("unit") or found.get("unit", "metre"))]
    crs = str(choice.get("crs", ""))
    points_check = check_first_points(metres * chunk.xyz, chunk.time, file=file, crs=crs)
    found["frame"] = points_check.frame
    units = layout.units()
    if crs and (unit := height_unit_of(units, crs)):
        found["height_unit"] = unit
    resolved = _merge_options(found, choice)
    if resolved["frame"] == SCANNER_FRAME and not choice.get("unit"):
        require_one_unit(path, layout)
    facts |= {
        **frame_facts(resolved),
        "time base": time_base_message(chunk.time, resolved["time_base"]),
        **points_check.facts,
    }
    title_lines = lines[: max(1, len(lines) - len(rows) + layout.first)]
    file_warnings = _unit_warnings(layout, title_lines, crs, file)
    if (
        not resolved["time_base"]
        and "time" in columns
        and is_clock(shown[0][columns.index("time")])
    ):
        actions = (CHOOSE_TIME_BASE_ACTION,)
        file_warnings += (warning("times.clock_without_base", file=file, actions=actions),)
    messages = tuple(column_title_warnings(path, layout, choice))
    assumptions = (
        note("assumed.time_unit", unit=TIME_UNIT_NAMES[SECONDS_PER_UNIT[resolved["time_unit"]]]),
        SAME_TIME_BASE_NOTE,
    )
    return FilePreview(
        facts, preview, found, (*file_warnings, *points_check.file_warnings), assumptions, messages
    )


def _unit_warnings(
    layout: RowLayout, title_lines: list[str], crs: str, file: str
) -> tuple[Message, ...]:
    """Warnings that the lines above the numbers specify other units than those that are used."""
    units = layout.units()
    if crs and units:
        # These name the columns, and replace the general warning.
        return easting_unit_warnings(units, crs, file)
    above = " ".join(title_lines).lower()
    feet = any(word in above for word in ("feet", "foot", "_ft", "[ft]", "(ft)"))
    if feet and "unit" not in header_options(layout):
        return (warning("points.feet_in_header", file=file, actions=USE_FEET_ACTIONS),)
    return ()


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read a file in chunks; columns besides time, x, y, z are kept under their names.

    Separator, decimal sign and column names are detected unless they are given.

    Raises
    ------
    InputError
        If the file is missing, empty, damaged, or a row does not fit the columns.
    """
    path = require_not_empty(path, "text")
    found, layout, _ = _detect_options(path)
    resolved = _merge_options(found, choice)
    if resolved["frame"] == SCANNER_FRAME and not choice.get("unit") and not choice.get("columns"):
        require_one_unit(path, layout)
    if not resolved["columns"]:
        raise InputError(error("text.columns_not_named", file=str(path)))
    scale, done = coordinate_scale(resolved), 0
    for chunk in _read_chunks(path, resolved, POINTS_PER_CHUNK):
        require_usable_points(chunk.xyz, chunk.time, path, done)
        done += len(chunk.time)
        yield PointChunk(chunk.xyz * scale, chunk.time, chunk.extra) if scale != 1 else chunk
    if not done:
        raise InputError(error("line.no_points", file=str(path)))


def _detect_options(path: Path) -> tuple[dict[str, str], RowLayout, list[str]]:
    """Detected options of a file, its layout, and its first lines.

    Raises
    ------
    InputError
        If no row has four numbers, or the columns are polar coordinates.
    """
    with report_damage(path, "text"), _opened_text(path) as file:
        lines = next(_line_blocks(file, path, HEAD_BYTES), [])[:200]
    layout = guess_layout(lines)
    if layout.first == len(data_rows(lines)):
        raise InputError(error("text.no_number_rows", file=str(path)))
    found = {
        "separator": layout.separator,
        "decimal": "comma" if layout.decimal_comma else "point",
    }
    if set(REQUIRED_COLUMNS) <= set(layout.names):
        found["columns"] = " ".join(layout.names)
        found |= header_options(layout)
    else:
        require_cartesian(path, layout)
    return found, layout, lines


def _merge_options(detected: Choice, choice: Choice) -> dict[str, str]:
    """Given options, completed by the detected ones."""
    return TEXT_FORMAT.complete_options(
        {**detected, **{name: value for name, value in choice.items() if value not in ("", "auto")}}
    )


def _read_chunks(path: Path, resolved: Choice, rows: int) -> Iterator[PointChunk]:
    names = _chosen_columns(path, resolved["columns"])
    layout = RowLayout(resolved["separator"], resolved["decimal"] == "comma")
    columns = [k for k, name in enumerate(names) if name != "-"]
    factor = SECONDS_PER_UNIT[resolved["time_unit"]]
    parts: list[NDArray[np.float64]] = []
    number = pending = 0
    with report_damage(path, "text"), _opened_text(path) as file:
        for block in _line_blocks(file, path, min(BYTES_PER_BLOCK, 100 * rows)):
            parts.append(_parse_block(path, block, number, names, columns, layout))
            number += len(block)
            pending += len(parts[-1])
            if pending >= rows:
                whole = np.concatenate(parts)
                full = pending - pending % rows
                for start in range(0, full, rows):
                    yield _point_chunk(whole[start : start + rows], names, columns, factor)
                parts, pending = [whole[full:]], pending - full
    if pending:
        yield _point_chunk(np.concatenate(parts), names, columns, factor)


def _point_chunk(
    part: NDArray[np.float64], names: Sequence[str], columns: list[int], factor: float
) -> PointChunk:
    column_of = {names[k]: column for column, k in enumerate(columns)}
    xyz = np.ascontiguousarray(part[:, [column_of["x"], column_of["y"], column_of["z"]]])
    extra = {
        name: part[:, column].copy()
        for name, column in column_of.items()
        if name not in REQUIRED_COLUMNS
    }
    return PointChunk(xyz, part[:, column_of["time"]] * factor, extra)


def _chosen_columns(path: Path, text: str) -> list[str]:
    known = (*REQUIRED_COLUMNS, "intensity")
    names = [
        name.lower() if name.lower() in known else name
        for name in text.replace(",", " ").replace(";", " ").split()
    ]
    if not names:
        raise InputError(error("text.columns_not_named", file=str(path)))
    missing = [name for name in REQUIRED_COLUMNS if name not in names]
    if missing:
        raise InputError(
            error(
                "text.columns_missing", file=str(path), names=tuple(names), missing=tuple(missing)
            )
        )
    duplicates = sorted({name for name in names if name != "-" and names.count(name) > 1})
    if duplicates:
        raise InputError(error("text.duplicate_columns", file=str(path), names=tuple(duplicates)))
    return names


def _parse_block(
    path: Path, block: list[str], number: int, names: Sequence[str], columns: list[int],
    layout: RowLayout,
) -> NDArray[np.float64]:  # fmt: skip
    """Parse the numbers of a block of lines, which follows ``number`` lines of the file.

    Raises
    ------
    InputError
        If a row does not consist of numbers.
    """
    rows = data_rows(block)
    before = 0
    if number == 0:  # column names or a point count at the top
        before = next((k for k, row in enumerate(rows) if layout.is_numeric_row(row)), len(rows))
    text = [layout.plain(row) for row in rows[before:]]
    if not text:
        return np.empty((0, len(columns)))
    _require_width(path, block, number, layout.fields(text[0]), names)
    time_column = names.index("time")
    clocks = is_clock(layout.fields(text[0])[time_column])
    try:
        return np.loadtxt(
            text, delimiter=SEPARATOR_CHARACTERS[layout.separator], usecols=columns, ndmin=2,
            comments=None, encoding=None,
            converters={time_column: clock_seconds} if clocks else None,
        )  # fmt: skip
    except ValueError as failure:
        _raise_row_error(path, block, number, before, names, columns, layout, clocks=clocks)
        raise InputError(
            error("text.not_numbers", file=str(path), reason=str(failure))
        ) from failure


def _raise_row_error(
    path: Path, block: list[str], number: int, before: int, names: Sequence[str],
    columns: list[int], layout: RowLayout, *, clocks: bool,
) -> None:  # fmt: skip
    """Raise an error that names the first faulty row of a block; return if there is none.

    Raises
    ------
    InputError
        If a row is too short, or a value is not a number.
    """
    passed = 0
    for k, line in enumerate(block, start=number + 1):
        if not data_rows([line]):
            continue
        passed += 1
        if passed <= before:
            continue
        fields = layout.fields(line)
        _require_width(path, [line], k - 1, fields, names)
        for column in columns:
            as_clock = clocks and names[column] == "time"
            try:
                (clock_seconds if as_clock else _parse_number)(fields[column])
            except ValueError:
                code = "text.not_a_clock_time" if as_clock else "text.not_a_number"
                raise InputError(
                    error(
                        code, file=str(path), row=k, column=names[column],
                        value=fields[column][:40],
                    )
                ) from None  # fmt: skip


def _parse_number(field: str) -> float:
    """Parse a number like NumPy; Python also accepts ``1_000`` and digits of other scripts.

    Raises
    ------
    ValueError
        If the text is not such a number.
    """
    if "_" in field or not field.isascii():
        raise ValueError(field)
    return float(field)


def _require_width(
    path: Path, lines: list[str], number: int, fields: list[str], names: Sequence[str]
) -> None:
    if len(fields) < len(names):
        row = number + 1 if len(lines) == 1 else number + 1 + _first_row(lines)
        raise InputError(
            error(
                "text.row_too_short", file=str(path), row=row, found=len(fields),
                needed=len(names), names=tuple(names),
            )
        )  # fmt: skip


def _first_row(lines: list[str]) -> int:
    return next((k for k, line in enumerate(lines) if data_rows([line])), 0)


def _is_gzipped(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(2) == GZIP_SIGNATURE


@contextmanager
def _opened_text(path: Path) -> Iterator[IO[bytes]]:
    with path.open("rb") as raw:
        start = raw.read(2)
        raw.seek(0)
        if start in UTF16_MARKS:
            raise InputError(error("text.utf16", file=str(path)))
        yield cast(IO[bytes], gzip.GzipFile(fileobj=raw)) if start == GZIP_SIGNATURE else raw


def _decode_text(data: bytes) -> str:
    return data.decode("utf-8-sig", errors="replace")


def _line_blocks(file: IO[bytes], path: Path, size: int) -> Iterator[list[str]]:
    """Read blocks of whole lines, ``size`` bytes at a time.

    Raises
    ------
    InputError
        If the file is not a text file with rows.
    """
    rest = b""
    while data := file.read(size):
        data = rest + data
        end = data.rfind(b"\n") + 1
        data, rest = data[:end], data[end:]
        if len(rest) > HEAD_BYTES or b"\0" in data[:HEAD_BYTES]:
            raise InputError(error("text.no_rows_of_points", file=str(path)))
        if data:
            yield _decode_text(data).split("\n")[:-1]
    if rest.strip():
        yield [_decode_text(rest)]


TEXT_FORMAT = FileFormat(
    note("format.text"), "text", "points", (".txt", ".csv", ".xyz", ".asc", ".pts", ".gz"),
    (COLUMNS_OPTION, SEPARATOR_OPTION, DECIMAL_OPTION, TIME_UNIT_OPTION, *COMMON_OPTIONS),
    sniff, preview_file, read,
)  # fmt: skip
