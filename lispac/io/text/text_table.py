"""Rows of text as columns of numbers: separators, angles, clock times and dates."""

import csv
import math
import os
import re
from calendar import timegm
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, system_reason
from lispac.io.compressed_files import require_uncompressed
from lispac.io.files import require_file
from lispac.messages import error

Array = NDArray[np.float64]

SEPARATOR_NAMES = ("auto", "comma", "semicolon", "tab", "blank")
ROWS_PER_BLOCK = 50_000
MAX_LINE_LENGTH = 20_000
"""Largest number of characters of a row; longer lines indicate a file that is not a table."""

DECIMAL_COMMA_ROW = re.compile(r"\d,\d+\s+-?\d+,\d")
"""Pattern of a row with decimal commas and columns separated by blanks, for rows without points."""

_CLOCK_PATTERN = re.compile(r"(\d{1,2}):(\d{1,2}):(\d{1,2}(?:[.,]\d*)?)Z?")
_DATE_PATTERN = re.compile(r"(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})")
_NUMBER_PATTERN = re.compile(r"[-+]?(\d+[.,]?\d*|[.,]\d+)([eEdD][-+]?\d+)?")
_DMS_SEPARATORS = re.compile("[°º'’′\"”″:dms]+|\\s+")


def first_lines(path: Path, count: int = 200) -> list[str]:
    """First lines of a text file; empty if it is not text, without raising an error.

    A file with NUL bytes or with lines longer than `MAX_LINE_LENGTH` is not text.
    """
    try:
        with Path(path).open("rb") as file:
            head = file.read(256 * 1024)
    except OSError:
        return []
    text = head.decode(_encoding(head), errors="replace")
    if "\0" in text:
        return []
    lines = text.splitlines()[:count]
    return [] if any(len(line) > MAX_LINE_LENGTH for line in lines) else lines


UTF16_ENCODINGS = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}
"""Byte order marks of UTF-16 text, which some Windows programs write."""


def _encoding(head: bytes) -> str:
    return "utf-16" if head[:2] in UTF16_ENCODINGS else "utf-8-sig"


def encoding_of(path: Path) -> str:
    """Encoding of a text file, detected from its first bytes.

    Raises
    ------
    OSError
        If the file cannot be read.
    """
    with Path(path).open("rb") as file:
        return _encoding(file.read(2))


def last_lines(path: Path, size: int) -> list[str]:
    """Lines after the first line end in the last ``size`` bytes; none if the file is unreadable."""
    try:
        with Path(path).open("rb") as file:
            mark = file.read(2)
            start = max(0, file.seek(0, os.SEEK_END) - size)
            file.seek(start + start % 2)
            text = file.read().decode(UTF16_ENCODINGS.get(mark, "utf-8"), errors="replace")
    except OSError:
        return []
    return text.splitlines()[1:]


def numbered_lines(path: Path, what: str) -> Iterator[tuple[int, str]]:
    """Number and content of each line, without line end.

    Raises
    ------
    InputError
        If the file cannot be read or is not text.
    """
    path = require_file(Path(path), what)
    if path.stat().st_size == 0:
        raise InputError(error("text.empty", file=str(path)))
    require_uncompressed(path)
    try:
        with path.open(encoding=encoding_of(path), errors="replace", newline=None) as file:
            number = 0
            while line := file.readline(MAX_LINE_LENGTH + 1):
                number += 1
                if len(line) > MAX_LINE_LENGTH or "\0" in line:
                    raise InputError(error("text.not_text", file=str(path), row=number))
                yield number, line.rstrip("\r\n")
    except OSError as failure:
        reason = system_reason(failure)
        raise InputError(error("text.not_read_to_end", file=str(path), reason=reason)) from failure


def split_fields(line: str, separator: str = "auto") -> list[str]:
    """Split a row; ``auto`` uses the semicolon, tab or comma if there is one, else blanks.

    With ``auto``, commas between digits are decimal signs if blanks separate the numbers and no
    field has a point. Fields may be in quotes, as spreadsheets write them.
    """
    if '"' in line and _OPENING_QUOTE.search(line):
        return _split_quoted(line, separator)
    if separator == "auto":
        separator = next(
            (name for name, mark in _SEPARATOR_CHARACTERS.items() if mark in line), "blank"
        )
        if separator == "comma" and "." not in line and DECIMAL_COMMA_ROW.search(line):
            separator = "blank"
    if separator == "blank":
        return line.split()
    return [field.strip() for field in line.strip(" \r\n").split(_SEPARATOR_CHARACTERS[separator])]


_SEPARATOR_CHARACTERS = {"semicolon": ";", "tab": "\t", "comma": ","}
_OPENING_QUOTE = re.compile(r'(?:^|[;,\t])\s*"')
"""Pattern of a quote that opens a field; other quotes mean seconds of arc."""


def _split_quoted(line: str, separator: str) -> list[str]:
    if separator == "auto":
        outside_quotes = re.sub('"[^"]*"', "", line)
        separator = next(
            (name for name, mark in _SEPARATOR_CHARACTERS.items() if mark in outside_quotes),
            "blank",
        )
    mark = _SEPARATOR_CHARACTERS.get(separator, " ")
    row = next(csv.reader([line.strip(" \r\n")], delimiter=mark, skipinitialspace=True), [])
    return [field.strip() for field in row]


def is_number(field: str) -> bool:
    """True if a field is one number in digits, with a decimal point or comma."""
    return _NUMBER_PATTERN.fullmatch(field.strip()) is not None


def is_data_row(fields: Sequence[str]) -> bool:
    """True if the first field of a row is a number, a clock time or a date."""
    first = fields[0] if fields else ""
    return is_number(first) or bool(_CLOCK_PATTERN.match(first)) or bool(_DATE_PATTERN.match(first))


def parse_number(field: str) -> float:
    """Parse a number with a decimal point or comma and an exponent after e, E, d or D."""
    return float(field.replace(",", ".").replace("D", "e").replace("d", "e"))


def degrees_minutes_seconds(field: str) -> float:
    """Decimal degrees of ``45 30 15.5 N``, ``-73°12'08"`` or ``W073:12:08``.

    Raises
    ------
    ValueError
        If the text has another form, or both a sign and a hemisphere.
    """
    text = field.strip().upper()
    # In 12D30M05S the last letter marks the seconds; a second S would be the hemisphere.
    marked = "D" in text and "M" in text and text.count("S") == 1
    hemisphere = ""
    if text[:1] and text[0] in "NSEW":
        hemisphere, text = text[0], text[1:]
    elif text[-1:] and text[-1] in "NSEW" and not (marked and text[-1] == "S"):
        hemisphere, text = text[-1], text[:-1]
    text = text.strip()
    negative = text.startswith("-")
    if negative and hemisphere in ("S", "W"):
        raise ValueError(f"{field!r} has both a sign and a hemisphere")
    sign = -1.0 if negative or hemisphere in ("S", "W") else 1.0
    bare = re.sub(r"(?<=\d)-(?=\d)", " ", text.lstrip("+-"))
    parts = [part for part in _DMS_SEPARATORS.split(bare.lower()) if part]
    if not 1 <= len(parts) <= 3:
        raise ValueError(f"{field!r} is not degrees, minutes and seconds")
    values = [parse_number(part) for part in parts]
    if any(value < 0 for value in values) or any(value >= 60 for value in values[1:]):
        raise ValueError(f"{field!r} is not degrees, minutes and seconds")
    return sign * sum(value / 60**k for k, value in enumerate(values))


def degrees_and_minutes(field: str) -> float:
    """Decimal degrees of ``4830.2533`` (ddmm.mmmm, as in NMEA 0183): 48 degrees, 30.2533 minutes.

    A hemisphere may precede or follow the number.

    Raises
    ------
    ValueError
        If the text has another form, or both a sign and a hemisphere.
    """
    text = field.strip().upper()
    letters = text[:1] + text[-1:]
    found = [letter for letter in letters if letter in HEMISPHERE_SIGNS]
    value = parse_number(text.strip("NSEW "))
    if len(found) > 1 or (found and value < 0):
        raise ValueError(f"{field!r} has both a sign and a hemisphere")
    degrees, minutes = divmod(abs(value), 100.0)
    if minutes >= 60:
        raise ValueError(f"{field!r} is not degrees and minutes")
    return math.copysign(degrees + minutes / 60, value) * (
        HEMISPHERE_SIGNS[found[0]] if found else 1.0
    )


def parse_with_hemisphere(parse: Callable[[str], float], field: str, *, letters: str) -> float:
    """Parse a coordinate with an optional hemisphere, which must be one of ``letters``.

    Raises
    ------
    ValueError
        If the text is not such a coordinate.
    """
    text = field.strip().upper()
    if {text[:1], text[-1:]} & (set(HEMISPHERE_SIGNS) - set(letters)) and not _has_seconds_letter(
        text
    ):
        raise ValueError(f"{field!r} is not a coordinate of {' or '.join(letters)}")
    return parse(field)


def _has_seconds_letter(text: str) -> bool:
    """True if the last letter marks the seconds, as in ``12D30M05S``."""
    return text[:1] not in HEMISPHERE_SIGNS and "D" in text and "M" in text and text.count("S") == 1


def hemisphere_sign(field: str, letter_o: str = "") -> float:
    """Sign of a hemisphere: 1 for N and E, -1 for S and W.

    Parameters
    ----------
    letter_o : {"", "E", "W"}
        Meaning of the letter O: *Ost* in German, *ouest* in French; empty if it is not known.

    Raises
    ------
    ValueError
        If the text is not a hemisphere.
    """
    word = field.strip().upper()
    letter = letter_o if letter_o and word == "O" else {"OST": "E", "OUEST": "W"}.get(word, word)
    if letter[:1] not in HEMISPHERE_SIGNS:
        raise ValueError(f"{field!r} is not a hemisphere")
    return HEMISPHERE_SIGNS[letter[:1]]


HEMISPHERE_SIGNS = {"N": 1.0, "S": -1.0, "E": 1.0, "W": -1.0}


def parse_coordinate(field: str, *, degrees: bool = False) -> float | None:
    """Parse one coordinate with a decimal point or comma and any Unicode minus sign.

    Parameters
    ----------
    degrees : bool
        Whether degrees, minutes and seconds are also accepted.

    Returns
    -------
    float, or None where it is not a finite number
    """
    text = field.strip().replace("\N{MINUS SIGN}", "-")
    try:
        value = parse_number(text) if is_number(text) else None
        if value is None and degrees:
            value = degrees_minutes_seconds(text)
    except (ValueError, OverflowError):
        return None
    return value if value is not None and math.isfinite(value) else None


def find_coordinates(text: str) -> tuple[str, str, str] | None:
    """Three numbers in a text, for example copied from a list; None if it contains other text."""
    fields = split_fields(text.replace("\N{MINUS SIGN}", "-"))
    if len(fields) != 3 or not all(is_number(field) for field in fields):
        return None
    return fields[0], fields[1], fields[2]


def clock_seconds(field: str) -> float:
    """Seconds of the day of ``14:03:07.250``.

    Raises
    ------
    ValueError
        If the text is not a time of day.
    """
    match = _CLOCK_PATTERN.fullmatch(field.strip())
    if not match:
        raise ValueError(f"{field!r} is not a time as hh:mm:ss")
    hours, minutes, seconds = int(match[1]), int(match[2]), parse_number(match[3])
    if hours > 24 or minutes > 59 or seconds >= 61:
        raise ValueError(f"{field!r} is not a time as hh:mm:ss")
    return 3600.0 * hours + 60.0 * minutes + seconds


def is_clock(field: str) -> bool:
    """True if a field is a time as hh:mm:ss."""
    return _CLOCK_PATTERN.fullmatch(field.strip()) is not None


def date_seconds(field: str) -> float:
    """Seconds since 1970-01-01 at the start of ``2024-05-31``, leap seconds not counted.

    Raises
    ------
    ValueError
        If the text is not a date.
    """
    match = _DATE_PATTERN.fullmatch(field.strip())
    if not match:
        raise ValueError(f"{field!r} is not a date as yyyy-mm-dd")
    year, month, day = (int(part) for part in match.groups())
    if not (1 <= month <= 12 and 1 <= day <= 31):
        raise ValueError(f"{field!r} is not a date as yyyy-mm-dd")
    return float(timegm((year, month, day, 0, 0, 0)))


def read_columns(
    path: Path,
    rows: Iterator[tuple[int, list[str]]],
    columns: Sequence[tuple[int, Callable[[str], float], str]],
) -> tuple[list[Array], NDArray[np.int64]]:
    """Read columns of numbers from rows of fields.

    Parameters
    ----------
    rows : iterator of (row number, fields)
    columns : sequence of (index, parser, name)

    Returns
    -------
    columns : list of ndarray of shape (n,)
    numbers : ndarray of shape (n,)
        Row in the file of each entry.

    Raises
    ------
    InputError
        If a field is missing or cannot be read; the message names the row and the column.
    """
    width = max(index for index, _, _ in columns) + 1
    blocks: list[Array] = []
    numbers: list[NDArray[np.int64]] = []
    while block := list(islice(rows, ROWS_PER_BLOCK)):
        for row, fields in block:
            if len(fields) < width:
                raise InputError(
                    error(
                        "text.too_few_columns", file=str(path), row=row, found=len(fields),
                        needed=width,
                    )
                )  # fmt: skip
        values = [
            _parse_values([fields[index] for _, fields in block], parse)
            for index, parse, _ in columns
        ]
        bad = ~np.isfinite(values)
        if bad.any():
            k = int(np.argmax(bad.any(axis=0)))
            index, _, name = columns[int(np.argmax(bad[:, k]))]
            row, fields = block[k]
            value = fields[index][:40]
            raise InputError(
                error("text.unusable_value", file=str(path), row=row, column=name, value=value)
            )
        blocks.append(np.array(values))
        numbers.append(np.array([row for row, _ in block]))
    if not blocks:
        raise InputError(error("text.no_rows", file=str(path)))
    return list(np.hstack(blocks)), np.concatenate(numbers)


def _parse_values(fields: list[str], parse: Callable[[str], float]) -> Array:
    """Parse the values of fields; NaN for a field that cannot be read."""
    if parse is parse_number:
        for quick in (float, parse_number):
            try:
                return np.fromiter(map(quick, fields), dtype=np.float64, count=len(fields))
            except (ValueError, OverflowError):
                pass  # decimal commas are tried next, then single fields to find the invalid one
    values = np.full(len(fields), np.nan)
    for k, field in enumerate(fields):
        with suppress(ValueError, OverflowError):
            values[k] = parse(field)
    return values
