"""Layout of a text file of numbers: separator, decimal sign, column names."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from lispac.io.point_reader_common import TIME_FIELD_NAMES
from lispac.io.text.text_table import DECIMAL_COMMA_ROW, is_clock
from lispac.io.units import (
    ANGLE_UNIT_CODES,
    is_units_row,
    split_title,
    title_unit,
    titles_with_units,
)

REQUIRED_COLUMNS = ("time", "x", "y", "z")
SEPARATOR_CHARACTERS = {"blank": None, "comma": ",", "semicolon": ";", "tab": "\t"}
COMMENT_MARKS = ("#", "%", "//")
TIME_BASE_OF_COLUMN_NAME = {
    **dict.fromkeys(("time_tai", "tai_time", "tai", "ptp_time", "time_ptp"), "tai"),
    **dict.fromkeys(("time_unix", "unix_time", "unix", "posix_time"), "unix"),
}
"""Keys of time bases by the names of time columns that imply them; lower case."""
COLUMN_MEANINGS = {
    **dict.fromkeys(("x", "easting", "east", "e", "lon", "longitude"), "x"),
    **dict.fromkeys(("y", "northing", "north", "n", "lat", "latitude"), "y"),
    **dict.fromkeys(("z", "height", "h", "elevation", "up", "u"), "z"),
    **dict.fromkeys((*TIME_FIELD_NAMES, "sow", "seconds", *TIME_BASE_OF_COLUMN_NAME), "time"),
    **dict.fromkeys(("intensity", "i", "scalar_intensity", "reflectance"), "intensity"),
}
"""Meanings of common column names; lower case, without the unit."""
POLAR_COLUMN_NAMES = {
    "range", "distance", "slant_range", "slant range", "azimuth", "horizontal_angle",
    "horizontal angle", "vertical_angle", "vertical angle", "scan_angle", "scan angle",
}  # fmt: skip
"""Column names of points in polar coordinates."""
POLAR_ANGLE_NAMES = {"elevation"}
"""Names that mean an angle in files with columns in `POLAR_COLUMN_NAMES`."""


@dataclass(frozen=True)
class RowLayout:
    """Layout that converts rows of text into numbers.

    Attributes
    ----------
    separator : str
        One of `SEPARATOR_CHARACTERS`.
    decimal_comma : bool
    names : tuple of str
        Meaning of each column, or its name if the meaning is not known, or ``-`` if it is not read;
        empty if no row above the numbers has names.
    first : int
        Number of rows before the first row of numbers.
    titles : tuple of str
        Column titles of the file, with units from a row below the names.
    """

    separator: str
    decimal_comma: bool
    names: tuple[str, ...] = ()
    first: int = 0
    titles: tuple[str, ...] = ()

    def plain(self, row: str) -> str:
        """Convert a row to a form that `float` reads: no quotes, and decimal points."""
        row = row.replace('"', "")
        return row.replace(",", ".") if self.decimal_comma else row

    def fields(self, row: str) -> list[str]:
        """Split a row into columns."""
        return [
            field.strip() for field in self.plain(row).split(SEPARATOR_CHARACTERS[self.separator])
        ]

    def units(self) -> dict[str, str]:
        """Unit in the title of each column that has one; see `title_unit`."""
        units = zip(self.names, map(title_unit, self.titles), strict=True)
        return {name: unit for name, unit in units if unit and name != "-"}

    def is_numeric_row(self, row: str) -> bool:
        """True if a row has four or more numbers, and more numbers than other fields.

        A time as hh:mm:ss counts as a number.
        """
        numbers = [_is_number(field) or is_clock(field) for field in self.fields(row)]
        return sum(numbers) >= max(len(REQUIRED_COLUMNS), len(numbers) // 2 + 1)


def data_rows(lines: Sequence[str]) -> list[str]:
    """Rows that are neither empty nor comments."""
    stripped = (line.strip("\r\n ") for line in lines)
    return [line for line in stripped if line and not line.startswith(COMMENT_MARKS)]


def guess_layout(lines: Sequence[str]) -> RowLayout:
    """Guess the layout from the first lines; ``first`` is their count if none has numbers."""
    rows = data_rows(lines)
    for first, row in enumerate(rows):
        for separator, decimal_comma in _layout_candidates(row):
            layout = RowLayout(separator, decimal_comma)
            if layout.is_numeric_row(row):
                titles = _column_titles(lines, row, separator, len(layout.fields(row)))
                return RowLayout(
                    separator, decimal_comma, _column_meanings(titles), first, tuple(titles)
                )
    return RowLayout("blank", False, (), len(rows))


def _layout_candidates(row: str) -> list[tuple[str, bool]]:
    if ";" in row:
        return [("semicolon", "." not in row and "," in row)]
    if "\t" in row:
        return [("tab", "." not in row and "," in row)]
    if "," in row:
        # 1,5 2,5 is two numbers with decimal commas; 1.5, 2.5 and 1,2,3,4 are lists.
        comma_is_decimal = "." not in row and bool(DECIMAL_COMMA_ROW.search(row))
        return [("blank", True)] if comma_is_decimal else [("comma", False)]
    return [("blank", False)]


def _column_titles(lines: Sequence[str], row: str, separator: str, columns: int) -> list[str]:
    """Column titles from one of the four lines above the numbers, which may be a comment.

    Units in a row between names and numbers are appended to the names.
    """
    written = [bare for line in lines if (bare := line.strip("\r\n ")).strip()]
    units: list[str] = []
    for line in reversed(written[: written.index(row)][-4:]):
        fields = split_names(line, separator, columns)
        if fields and is_units_row(fields) and not units:
            units = fields
        elif fields:
            return titles_with_units(fields, units) if units else fields
    return []


def split_names(line: str, separator: str, columns: int) -> list[str]:
    """Column names in a line, which may be a comment; empty if their number does not fit."""
    plain = line.strip("\r\n ").lstrip("#%/ ").replace('"', "")
    fields = [field.strip() for field in plain.split(SEPARATOR_CHARACTERS[separator])]
    if len(fields) != columns:
        fields = plain.replace(",", " ").replace(";", " ").split()
    numbers = any(_is_number(field) or is_clock(field) for field in fields)
    return fields if len(fields) == columns and not numbers else []


def name_without_unit(field: str) -> str:
    """A column name in lower case, without its unit."""
    return split_title(field)[0].strip().lower()


def ambiguous_columns(titles: Sequence[str]) -> dict[str, list[str]]:
    """Groups of titles with the same meaning, unless exactly one of them is the name itself."""
    found: dict[str, list[str]] = {}
    for title in titles:
        if meaning := COLUMN_MEANINGS.get(name_without_unit(title)):
            found.setdefault(meaning, []).append(title)
    return {
        meaning: own
        for meaning, own in found.items()
        if len(own) > 1 and [name_without_unit(title) for title in own].count(meaning) != 1
    }


def _column_meanings(fields: Sequence[str]) -> tuple[str, ...]:
    """Meanings of column names; the exact name of a column takes precedence over synonyms.

    An elevation in a file with a range or an azimuth, or in degrees, is an angle and not a height.
    """
    base_names = [name_without_unit(field) for field in fields]
    is_polar = not POLAR_COLUMN_NAMES.isdisjoint(base_names)
    angles = [title_unit(field) in ANGLE_UNIT_CODES for field in fields]
    chosen: dict[str, int] = {}
    for k, bare in enumerate(base_names):
        if COLUMN_MEANINGS.get(bare) == bare:
            chosen.setdefault(bare, k)
    for k, bare in enumerate(base_names):
        is_angle = (is_polar and bare in POLAR_ANGLE_NAMES) or (
            COLUMN_MEANINGS.get(bare) == "z" and angles[k]
        )
        if bare in COLUMN_MEANINGS and not is_angle:
            chosen.setdefault(COLUMN_MEANINGS[bare], k)
    names: list[str] = []
    for k, (bare, field) in enumerate(zip(base_names, fields, strict=True)):
        is_chosen = bare in COLUMN_MEANINGS and chosen.get(COLUMN_MEANINGS[bare]) == k
        name = COLUMN_MEANINGS[bare] if is_chosen else re.sub(r"\s+", "_", field) or "-"
        names.append(name if name not in names and (is_chosen or name not in chosen) else "-")
    return tuple(names)


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return True
