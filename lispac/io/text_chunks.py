"""Points as text, plain or gzipped: one point a row, columns named by its first row or the user."""

import gzip
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import IO, cast

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.points import (
    CHOOSE_TIME_BASE,
    CHUNK,
    HEAD,
    PLACE,
    PREVIEW,
    ROWS,
    SCANNER,
    SCANNER_UNITS,
    SECONDS,
    TIME_UNIT,
    USE_FEET,
    place_facts,
    plainly,
    require_filled,
    require_points,
    scale_of,
    sniffer,
    time_base,
    usable_points,
)
from lispac.io.registry import (
    LIKELY,
    NOT,
    POSSIBLE,
    SAME_TIME_BASE,
    Choice,
    Fact,
    Finding,
    Format,
    Option,
    PointChunk,
)
from lispac.io.sight import sight
from lispac.io.text_layout import REQUIRED, SEPARATORS, Layout, layout_of, rows_of
from lispac.io.text_table import clock, is_clock
from lispac.io.text_units import (
    header_options,
    height_unit_of,
    require_cartesian,
    require_degrees,
    require_one_unit,
    unit_doubts,
    unit_messages,
)
from lispac.io.units import TIME_UNIT_NAMES
from lispac.language import N_
from lispac.messages import Message, error, note, warning
from lispac.survey.source import printable

COLUMNS = Option(
    "columns",
    N_(
        "Names of the columns from the left, separated by blanks. time x y z are needed; - skips a "
        "column. Empty: as in the first row of the file."
    ),
)
SEPARATOR = Option("separator", N_("Separator of the columns."), ("auto", *SEPARATORS), "auto")
DECIMAL = Option("decimal", N_("Decimal sign."), ("auto", "point", "comma"), "auto")
BLOCK = 8 << 20  # bytes parsed at once
GZIP, UTF16 = b"\x1f\x8b", (b"\xff\xfe", b"\xfe\xff")


@sniffer
def sniff(head: bytes, path: Path) -> float:
    """Rows of four numbers or more; likely where a first row names time, x, y and z."""
    if head.startswith(GZIP):
        head = zlib.decompressobj(wbits=31).decompress(head, HEAD)
    if b"\0" in head:
        return NOT
    lines = _text(head).splitlines()[:100]
    layout, rows = layout_of(lines), rows_of(lines)
    body = rows[layout.first : -1] or rows[layout.first :]  # the last row may be cut
    if not body or not all(layout.is_numbers(row) for row in body):
        return NOT
    return LIKELY if set(REQUIRED) <= set(layout.names) else POSSIBLE


def look(path: Path, choice: Choice) -> Finding:
    """Read the first rows, and propose separator, decimal sign and columns.

    Raises
    ------
    InputError
        Where the file cannot be read or holds no rows of numbers.
    """
    path = require_filled(path, "text")
    file = printable(path.name)
    found, layout, lines = _detected(path)
    if not choice.get("columns"):
        require_degrees(path, layout)
    rows = rows_of(lines)
    settled = _settled(found, choice)
    shown = [layout.fields(row) for row in rows[layout.first : layout.first + ROWS]]
    columns = settled["columns"].split()
    head = (
        columns if len(columns) == len(shown[0]) else [f"{k}" for k in range(1, 1 + len(shown[0]))]
    )
    preview = tuple(tuple(row) for row in (head, *shown))
    facts: dict[str, Fact] = {
        "format": note("fact.text_gzipped" if _is_packed(path) else "fact.text"),
        "separator": settled["separator"],
        "decimal": settled["decimal"],
        "columns": settled["columns"] or note("fact.not_named"),
    }
    if not columns:
        not_named = warning("text.columns_not_named", file=file)
        return Finding({**facts, **place_facts(settled)}, preview, found, (not_named,))
    chunk = next(_chunks(path, settled, PREVIEW), None)
    if chunk is None:
        raise InputError(error("line.no_points", file=str(path)))
    require_points(chunk.xyz, chunk.time, path)
    chunk = usable_points(chunk)
    metres = SCANNER_UNITS[str(choice.get("unit") or found.get("unit", "metre"))]
    crs = str(choice.get("crs", ""))
    seen = sight(metres * chunk.xyz, chunk.time, file=file, crs=crs)
    found["frame"] = seen.frame
    units = layout.units()
    if crs and (unit := height_unit_of(units, crs)):
        found["height_unit"] = unit
    settled = _settled(found, choice)
    if settled["frame"] == SCANNER and not choice.get("unit"):
        require_one_unit(path, layout)
    facts |= {
        **place_facts(settled),
        "time base": time_base(chunk.time, settled["time_base"]),
        **seen.facts,
    }
    above = " ".join(lines[: max(1, len(lines) - len(rows) + layout.first)]).lower()
    feet = any(word in above for word in ("feet", "foot", "_ft", "[ft]", "(ft)"))
    doubts: tuple[Message, ...] = ()
    if feet and "unit" not in header_options(layout):
        doubts = (warning("points.feet_in_header", file=file, actions=USE_FEET),)
    if crs and units:
        doubts = unit_doubts(units, crs, file)  # the names say which, and which does not fit
    if not settled["time_base"] and "time" in columns and is_clock(shown[0][columns.index("time")]):
        actions = (CHOOSE_TIME_BASE,)
        doubts += (warning("times.clock_without_base", file=file, actions=actions),)
    messages = tuple(unit_messages(path, layout, choice))
    assumptions = (
        note("assumed.time_unit", unit=TIME_UNIT_NAMES[SECONDS[settled["time_unit"]]]),
        SAME_TIME_BASE,
    )
    return Finding(facts, preview, found, (*doubts, *seen.doubts), assumptions, messages)


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read in chunks; columns beyond time, x, y, z go along under their names.

    Separator, decimal sign and names of columns are those of the file where not chosen.

    Raises
    ------
    InputError
        Where the file is missing, empty, damaged, or a row does not fit the columns.
    """
    path = require_filled(path, "text")
    found, layout, _ = _detected(path)
    settled = _settled(found, choice)
    if settled["frame"] == SCANNER and not choice.get("unit") and not choice.get("columns"):
        require_one_unit(path, layout)
    if not settled["columns"]:
        raise InputError(error("text.columns_not_named", file=str(path)))
    scale, done = scale_of(settled), 0
    for chunk in _chunks(path, settled, CHUNK):
        require_points(chunk.xyz, chunk.time, path, done)
        done += len(chunk.time)
        yield PointChunk(chunk.xyz * scale, chunk.time, chunk.extra) if scale != 1 else chunk
    if not done:
        raise InputError(error("line.no_points", file=str(path)))


def _detected(path: Path) -> tuple[dict[str, str], Layout, list[str]]:
    """Options as the file shows them, its layout, and the first lines.

    Raises
    ------
    InputError
        Where no row has four numbers.
    """
    with plainly(path, "text"), _opened(path) as file:
        lines = next(_blocks(file, path, HEAD), [])[:200]
    layout = layout_of(lines)
    if layout.first == len(rows_of(lines)):
        raise InputError(error("text.no_number_rows", file=str(path)))
    found = {
        "separator": layout.separator,
        "decimal": "comma" if layout.decimal_comma else "point",
    }
    if set(REQUIRED) <= set(layout.names):
        found["columns"] = " ".join(layout.names)
        found |= header_options(layout)
    else:
        require_cartesian(path, layout)
    return found, layout, lines


def _settled(found: Choice, choice: Choice) -> dict[str, str]:
    """Chosen options; detected values for the others and for auto."""
    return TEXT.settled(
        {**found, **{name: value for name, value in choice.items() if value not in ("", "auto")}}
    )


def _chunks(path: Path, settled: Choice, rows: int) -> Iterator[PointChunk]:
    names = _columns(path, settled["columns"])
    layout = Layout(settled["separator"], settled["decimal"] == "comma")
    wanted = [k for k, name in enumerate(names) if name != "-"]
    factor = SECONDS[settled["time_unit"]]
    parts: list[NDArray[np.float64]] = []
    number = held = 0
    with plainly(path, "text"), _opened(path) as file:
        for block in _blocks(file, path, min(BLOCK, 100 * rows)):
            parts.append(_parsed(path, block, number, names, wanted, layout))
            number += len(block)
            held += len(parts[-1])
            if held >= rows:
                whole = np.concatenate(parts)
                full = held - held % rows
                for start in range(0, full, rows):
                    yield _chunk(whole[start : start + rows], names, wanted, factor)
                parts, held = [whole[full:]], held - full
    if held:
        yield _chunk(np.concatenate(parts), names, wanted, factor)


def _chunk(
    part: NDArray[np.float64], names: Sequence[str], wanted: list[int], factor: float
) -> PointChunk:
    at = {names[k]: column for column, k in enumerate(wanted)}
    xyz = np.ascontiguousarray(part[:, [at["x"], at["y"], at["z"]]])
    extra = {name: part[:, column].copy() for name, column in at.items() if name not in REQUIRED}
    return PointChunk(xyz, part[:, at["time"]] * factor, extra)


def _columns(path: Path, text: str) -> list[str]:
    known = (*REQUIRED, "intensity")
    names = [
        name.lower() if name.lower() in known else name
        for name in text.replace(",", " ").replace(";", " ").split()
    ]
    if not names:
        raise InputError(error("text.columns_not_named", file=str(path)))
    missing = [name for name in REQUIRED if name not in names]
    if missing:
        raise InputError(
            error(
                "text.columns_missing", file=str(path), names=tuple(names), missing=tuple(missing)
            )
        )
    twice = sorted({name for name in names if name != "-" and names.count(name) > 1})
    if twice:
        raise InputError(error("text.duplicate_columns", file=str(path), names=tuple(twice)))
    return names


def _parsed(
    path: Path, block: list[str], number: int, names: Sequence[str], wanted: list[int],
    layout: Layout,
) -> NDArray[np.float64]:  # fmt: skip
    """Numbers of a block of lines, of which ``number`` came before.

    Raises
    ------
    InputError
        Where a row is not of numbers.
    """
    rows = rows_of(block)
    before = 0
    if number == 0:  # names of columns, or a count of points, at the head
        before = next((k for k, row in enumerate(rows) if layout.is_numbers(row)), len(rows))
    text = [layout.plain(row) for row in rows[before:]]
    if not text:
        return np.empty((0, len(wanted)))
    _require_width(path, block, number, layout.fields(text[0]), names)
    at = names.index("time")
    clocks = is_clock(layout.fields(text[0])[at])
    try:
        return np.loadtxt(
            text, delimiter=SEPARATORS[layout.separator], usecols=wanted, ndmin=2, comments=None,
            converters={at: clock} if clocks else None, encoding=None,
        )  # fmt: skip
    except ValueError as failure:
        _name_the_row(path, block, number, before, names, wanted, layout, clocks=clocks)
        raise InputError(
            error("text.not_numbers", file=str(path), reason=str(failure))
        ) from failure


def _name_the_row(
    path: Path, block: list[str], number: int, before: int, names: Sequence[str],
    wanted: list[int], layout: Layout, *, clocks: bool,
) -> None:  # fmt: skip
    """Find the row of a block with an error.

    Raises
    ------
    InputError
    """
    passed = 0
    for k, line in enumerate(block, start=number + 1):
        if not rows_of([line]):
            continue
        passed += 1
        if passed <= before:
            continue
        fields = layout.fields(line)
        _require_width(path, [line], k - 1, fields, names)
        for column in wanted:
            as_clock = clocks and names[column] == "time"
            try:
                (clock if as_clock else _plain_number)(fields[column])
            except ValueError:
                code = "text.not_a_clock_time" if as_clock else "text.not_a_number"
                raise InputError(
                    error(
                        code, file=str(path), row=k, column=names[column],
                        value=fields[column][:40],
                    )
                ) from None  # fmt: skip


def _plain_number(field: str) -> float:
    """A number as NumPy reads it: Python also takes ``1_000`` and digits of other scripts.

    Raises
    ------
    ValueError
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
    return next((k for k, line in enumerate(lines) if rows_of([line])), 0)


def _is_packed(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(2) == GZIP


@contextmanager
def _opened(path: Path) -> Iterator[IO[bytes]]:
    with path.open("rb") as raw:
        start = raw.read(2)
        raw.seek(0)
        if start in UTF16:
            raise InputError(error("text.utf16", file=str(path)))
        yield cast(IO[bytes], gzip.GzipFile(fileobj=raw)) if start == GZIP else raw


def _text(data: bytes) -> str:
    return data.decode("utf-8-sig", errors="replace")


def _blocks(file: IO[bytes], path: Path, size: int) -> Iterator[list[str]]:
    """Whole lines, ``size`` bytes at once; never more than a bounded rest is carried over.

    Raises
    ------
    InputError
        Where the file is not text in rows.
    """
    rest = b""
    while data := file.read(size):
        data = rest + data
        end = data.rfind(b"\n") + 1
        data, rest = data[:end], data[end:]
        if len(rest) > HEAD or b"\0" in data[:HEAD]:
            raise InputError(error("text.no_rows_of_points", file=str(path)))
        if data:
            yield _text(data).split("\n")[:-1]
    if rest.strip():
        yield [_text(rest)]


TEXT = Format(
    note("format.text"), "text", "points", (".txt", ".csv", ".xyz", ".asc", ".pts", ".gz"),
    (COLUMNS, SEPARATOR, DECIMAL, TIME_UNIT, *PLACE), sniff, look, read,
)  # fmt: skip
