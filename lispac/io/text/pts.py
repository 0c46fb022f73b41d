"""Reading of Leica PTS: text of points without time, in blocks that begin with a point count.

A row has x, y, z and optionally intensity and red, green, blue, separated by blanks. Cyclone writes
one or several blocks; other programs write one block, sometimes without the count. Intensities
(-2048 to 2047, 0 to 255 or 0 to 1) and colours are ignored. The file specifies no coordinate system
or unit; metres are assumed unless a system is given.
"""

import re
from collections.abc import Iterator
from itertools import chain, islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.point_reader_common import POINTS_PER_CHUNK
from lispac.io.text.text_layout import COMMENT_MARKS
from lispac.io.text.text_table import is_number, numbered_lines, parse_number, read_columns
from lispac.messages import error
from lispac.untrusted_values import is_whole_number

Array = NDArray[np.float64]
Row = tuple[int, str]

ENDING = ".pts"

_COUNT_PATTERN = re.compile(r"[0-9]{1,15}")
_XYZ_COLUMNS = tuple((k, parse_number, axis) for k, axis in enumerate("xyz"))


def read_coordinates(path: Path) -> Iterator[Array]:
    """Read only the coordinates, shape (n, 3), in the file's unit, about a million at a time.

    Raises
    ------
    InputError
        If the file is missing, empty or cut short, a point count does not fit, or a row does not
        consist of numbers.
    """
    rows: Iterator[Row] = (
        (row, text) for row, line in numbered_lines(path, "PTS")
        if (text := line.strip()) and not text.startswith(COMMENT_MARKS)
    )  # fmt: skip
    first = next(rows, None)
    if first is None:
        return
    rows = chain([first], rows)
    if _is_point(first[1]):
        yield from _read_uncounted(path, rows)
        return
    head = count = 0
    for row, text in rows:
        _require_count(path, row, text, head, count)
        head, count, done, width = row, int(text), 0, 0
        while done < count:
            block = list(islice(rows, min(POINTS_PER_CHUNK, count - done)))
            if not block:
                raise InputError(
                    error("pts.points_missing", file=str(path), held=done, points=count, head=head)
                )
            width = width or max(3, len(block[0][1].split()))
            _require_no_count(path, block, head, count, done)
            _require_rows(path, block, width)
            yield _block_coordinates(path, block)
            done += len(block)


def has_point_count(path: Path) -> bool:
    """True if a file begins with a point count, and its ending or first point is that of PTS."""
    first, second = _first_rows(path, 2)
    if not _COUNT_PATTERN.fullmatch(first):
        return False
    return path.suffix.lower() == ENDING or _is_pts_point(second)


def is_pts(path: Path) -> bool:
    """True if a file is PTS, by its first rows or its ending."""
    if has_point_count(path):
        return True
    (first,) = _first_rows(path, 1)
    words = sum(not is_number(field) for field in first.split())
    table = len(re.split("[,;]", first)) >= 3 or words >= 3
    return path.suffix.lower() == ENDING and not table


def is_ptx(path: Path) -> bool:
    """True if a text is PTX: scan columns and rows, then poses in rows of 3 and 4 numbers."""
    rows = _first_rows(path, 10)
    if not all(_COUNT_PATTERN.fullmatch(row) for row in rows[:2]):
        return False
    widths = [len(row.split()) if _is_point(row) else 0 for row in rows[2:]]
    return widths == [3] * 4 + [4] * 4


def _first_rows(path: Path, count: int) -> list[str]:
    """First rows that are neither empty nor comments, padded with empty rows."""
    try:
        texts = (text for _, line in numbered_lines(path, "PTS") if (text := line.strip()))
        rows = list(islice((text for text in texts if not text.startswith(COMMENT_MARKS)), count))
    except InputError:
        rows = []
    return rows + [""] * (count - len(rows))


def _is_pts_point(text: str) -> bool:
    """True if a row is x, y, z, optionally with intensity and a colour of 0 to 255."""
    fields = text.split()
    if not _is_point(text) or len(fields) not in (3, 7):
        return False
    return all(is_whole_number(field, 255) for field in fields[4:])


def _is_point(text: str) -> bool:
    fields = text.split()
    return len(fields) >= 3 and all(is_number(field) for field in fields)


def _read_uncounted(path: Path, rows: Iterator[Row]) -> Iterator[Array]:
    """Read all rows as one block, because there is no point count.

    Raises
    ------
    InputError
        If a row is not valid.
    """
    width = 0
    while block := list(islice(rows, POINTS_PER_CHUNK)):
        width = width or len(block[0][1].split())
        _require_rows(path, block, width)
        yield _block_coordinates(path, block)


def _require_count(path: Path, row: int, text: str, head: int, count: int) -> None:
    """Refuse a row that is not a point count where the next block begins, after that of ``head``.

    Raises
    ------
    InputError
        If the row is not a single integer.
    """
    if _COUNT_PATTERN.fullmatch(text):
        return
    if head:
        raise InputError(
            error("pts.count_expected", file=str(path), row=row, points=count, head=head)
        )
    raise InputError(error("pts.no_count", file=str(path), row=row, text=text[:40]))


def _require_no_count(path: Path, block: list[Row], head: int, count: int, done: int) -> None:
    """Refuse a point count inside a block, where a point is expected.

    Raises
    ------
    InputError
        If a row of the block is a single integer.
    """
    for k, (row, text) in enumerate(block, start=done):
        if _COUNT_PATTERN.fullmatch(text):
            raise InputError(
                error("pts.early_count", file=str(path), row=row, held=k, points=count, head=head)
            )


def _require_rows(path: Path, block: list[Row], width: int) -> None:
    """Refuse rows with another number of columns than the first of their block, or with commas.

    Raises
    ------
    InputError
        If a row contains a comma or semicolon, or its number of columns is not ``width``.
    """
    for row, text in block:
        if "," in text or ";" in text:
            raise InputError(error("pts.separators", file=str(path), row=row))
        columns = len(text.split())
        if columns != width:
            raise InputError(
                error("pts.columns", file=str(path), row=row, count=columns, width=width)
            )


def _block_coordinates(path: Path, block: list[Row]) -> Array:
    """Read the first three columns; `read_columns` names the row with an invalid number.

    Raises
    ------
    InputError
        If a coordinate is not a number.
    """
    try:
        return np.loadtxt([text for _, text in block], usecols=(0, 1, 2), comments=None, ndmin=2)
    except ValueError:
        fields = ((row, text.split()) for row, text in block)
        return np.stack(read_columns(path, fields, _XYZ_COLUMNS)[0], axis=1)
