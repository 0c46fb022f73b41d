"""Reading of lists of target coordinates, as exported by a total station or a spreadsheet.

Each row is a point with three coordinates and optionally a name and a role. The meaning of the
columns is taken from a header row, else from their order.
"""

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from lispac.errors import InputError, ProjectError
from lispac.io.text.text_layout import COLUMN_MEANINGS, COMMENT_MARKS
from lispac.io.text.text_table import (
    HEMISPHERE_SIGNS,
    SEPARATOR_NAMES,
    is_number,
    numbered_lines,
    parse_coordinate,
    split_fields,
)
from lispac.io.units import (
    INTERNATIONAL_FOOT_M,
    UNITS,
    UNKNOWN,
    direction_of,
    split_title,
    title_unit,
)
from lispac.messages import Message, error
from lispac.picked_targets import Role, require_target_name

FILE_KIND = "coordinate list"
MAX_ROWS = 1_000
"""Largest number of rows; a longer file is considered a cloud and not a list of targets."""
NAME, ROLE, UNUSED = "name", "role", "-"
COORDINATES = ("x", "y", "z")
USED_COLUMNS = (NAME, *COORDINATES, ROLE)
"""Meanings of the columns that are used."""
SIGMA, PLANE = "sigma", "plane"
AXIS_SIGMAS = ("sigma x", "sigma y", "sigma z")
"""Columns with the standard deviation of each coordinate, in the order of the coordinates."""
CHECK_COLUMN_NAMES = {
    **{
        f"{word}{axis}": f"sigma {axis}"
        for word in ("s", "sigma", "sigma_", "sigma ", "std", "std_", "std ", "s_")
        for axis in "xyz"
    },
    **dict.fromkeys(("sigma", "s", "std", "stdev", "accuracy", "uncertainty"), SIGMA),
    **dict.fromkeys(("plane", "surface", "face"), PLANE),
}
"""Meanings of further columns of a list of check points, by the column name."""
_COLUMN_NAMES = {
    **dict.fromkeys(("name", "point", "pointname", "pointid", "pt", "id", "no", "nr", "number",
                     "target", "pointno", "station", "label"), NAME),
    **dict.fromkeys(("role", "use", "kind"), ROLE),
}  # fmt: skip
LOCAL_AXIS_NAMES = {"north": "x", "n": "x", "northing": "x", "west": "y", "w": "y"}
"""Column names with another meaning in the local frame: x points north and y west."""
ROLES_BY_WORD: dict[str, Role] = {
    **dict.fromkeys(("target", "t", "adjustment"), "target"),
    **dict.fromkeys(("validation", "v", "check", "validation plane"), "validation"),
}


@dataclass(frozen=True)
class ListedPoint:
    """One row of a list.

    Attributes
    ----------
    row : int
        Row number in the file, from 1.
    name : str
        Empty if the list has no names.
    role : {"target", "validation"} or None
        As in the list; None if not given.
    coordinates : three of float, in the order and unit of their coordinate system
    sigma : float or None, metres
        Standard deviation of a check point, if given in the list; the root mean square of
        ``axis_sigmas`` if the list gives these.
    plane : str
        Name of the plane that a check point shares with others; empty for a single point.
    axis_sigmas : three of float or None, metres
        Standard deviations of the three coordinates, if given in the list.
    """

    row: int
    name: str
    role: Role | None
    coordinates: tuple[float, float, float]
    sigma: float | None = None
    plane: str = ""
    axis_sigmas: tuple[float, float, float] | None = None


@dataclass(frozen=True)
class PointList:
    """Points and columns of a list file.

    Attributes
    ----------
    columns : tuple of str
        Meaning of the columns from the left: one of `USED_COLUMNS`, for check points also ``sigma``
        and ``plane``, or ``-`` for an unused column.
    are_columns_given : bool
        Whether a header row or the caller gives the meanings; otherwise their order does.
    """

    path: Path
    points: tuple[ListedPoint, ...]
    columns: tuple[str, ...]
    are_columns_given: bool


def read_point_list(
    path: Path,
    *,
    columns: Sequence[str] = (),
    local: bool = True,
    degrees: bool = False,
    check: bool = False,
    metres: Sequence[float] = (1.0, 1.0, 1.0),
) -> PointList:
    """Read a list of target coordinates.

    Parameters
    ----------
    columns : sequence of str
        Meanings of the columns, to override the file; names not in `USED_COLUMNS` are unused
        columns.
    local : bool
        Whether coordinates are in the local frame: x is then north and y west; otherwise x is
        easting or longitude and y northing or latitude.
    degrees : bool
        Whether degrees, minutes and seconds are accepted.
    check : bool
        Whether these are check points, which may have columns ``sigma`` (metres) and ``plane``.
    metres : three of float
        Metres in the unit of each axis of the coordinate system; values with another unit in the
        column title are converted to that unit.

    Raises
    ------
    InputError
        If the list is not valid; the message names the row, if there is one.
    """
    path = Path(path)
    rows = _data_rows(path)
    first = next(rows, None)
    if first is None:
        raise InputError(error("seeds.no_coordinates", file=str(path)))
    separator = separator_of(first[1])
    are_given = True
    factors: Mapping[str, float] = {}
    if columns:
        meanings = _require_complete_columns(
            path, None, tuple(_column_meaning(word, local) for word in columns)
        )
        if not _is_numeric_row(first[1], separator, meanings, degrees):
            first = None  # a row of column names
    elif names := header_meanings(first[1], separator, local=local):
        if check:
            names = _with_check_columns(names, split_fields(first[1], separator))
        meanings = _require_complete_columns(path, first[0], names)
        titles = dict(zip(meanings, split_fields(first[1], separator), strict=True))
        factors, first = _column_factors(path, titles, metres, degrees), None
    else:
        meanings, are_given = _meanings_by_order(path, *first, separator, check), False
    points: list[ListedPoint] = []
    letters: dict[int, set[str]] = {k: set() for k, name in enumerate(meanings) if name == UNUSED}
    for number, row_text in (*((first,) if first else ()), *rows):
        if first is None and not points:
            separator = separator_of(row_text)  # may differ for names
        fields = split_fields(row_text, separator)
        points.append(_parse_point(path, number, fields, meanings, degrees, factors))
        for k, found in letters.items():
            found.add(fields[k].strip().upper() if k < len(fields) else "")
    if not points:
        raise InputError(error("seeds.only_names", file=str(path)))
    for k, found in letters.items() if degrees else ():
        if found <= {*HEMISPHERE_SIGNS, "O"}:
            raise InputError(
                error(
                    "seeds.hemispheres", file=str(path), column=k + 1, letters=tuple(sorted(found))
                )
            )
    _require_unique_points(path, points)
    return PointList(path, tuple(points), meanings, are_given)


def is_point_list(path: Path) -> bool:
    """True if a file is a list of named points and not a line or a trajectory."""
    try:
        found = read_point_list(path)
    except (InputError, OSError):
        return False
    return NAME in found.columns and any(not is_number(point.name) for point in found.points)


def _data_rows(path: Path) -> Iterator[tuple[int, str]]:
    """Rows that are neither empty nor comments; a comment at the top may have the column names.

    Raises
    ------
    InputError
        If there are too many rows for a list of targets.
    """
    count = 0
    for number, line in numbered_lines(path, FILE_KIND):
        text = line.strip()
        if not text.strip(' ,;\t"'):
            continue
        if text.startswith(COMMENT_MARKS):
            bare = text.lstrip("#%/ ")
            if count or not header_meanings(bare, separator_of(bare), local=True):
                continue
            text = bare
        count += 1
        if count > MAX_ROWS:
            raise InputError(error("seeds.too_many_rows", file=str(path), most=MAX_ROWS))
        yield number, text


def separator_of(row: str) -> str:
    """Name of the separator of the columns in a row; ``auto`` if no name fits."""
    whole = split_fields(row)
    return next(
        (name for name in SEPARATOR_NAMES if name != "auto" and split_fields(row, name) == whole),
        "auto",
    )


def _column_meaning(word: str, local: bool) -> str:
    bare = split_title(word)[0].lower()
    joined = re.sub(r"[\s_.#-]+", "", bare)
    if local and joined in LOCAL_AXIS_NAMES:
        return LOCAL_AXIS_NAMES[joined]
    if joined in ("e", "east", "easting", "lon", "longitude", "lat", "latitude") and local:
        return f"{joined}?"
    found = _COLUMN_NAMES.get(joined) or COLUMN_MEANINGS.get(bare, UNUSED)
    return found if found in USED_COLUMNS else UNUSED


def header_meanings(row: str, separator: str, *, local: bool) -> tuple[str, ...]:
    """Meanings of the column names in a row.

    Empty if the row has a number, or fewer than two names are known.
    """
    fields = split_fields(row, separator)
    if any(is_number(field) for field in fields):
        return ()
    meanings = tuple(_column_meaning(field, local) for field in fields)
    return meanings if sum(name != UNUSED for name in meanings) >= 2 else ()


def _with_check_columns(meanings: Sequence[str], names: Sequence[str]) -> tuple[str, ...]:
    """Column meanings with those that only check points use."""
    bare = (split_title(name)[0].lower() for name in names)
    return tuple(
        CHECK_COLUMN_NAMES.get(name, UNUSED) if known == UNUSED else known
        for known, name in zip(meanings, bare, strict=True)
    )


def _require_complete_columns(
    path: Path, row: int | None, meanings: tuple[str, ...]
) -> tuple[str, ...]:
    """Refuse columns that do not contain each of the three coordinates once.

    Parameters
    ----------
    row : int or None
        Row of the file with the column names; None if the user gives them.

    Raises
    ------
    InputError
        If a coordinate has no column or several, or a column has another axis.
    """
    if other_axes := [name.rstrip("?") for name in meanings if name.endswith("?")]:
        raise InputError(_columns_error("other_axes", path, row, other_axes))
    if missing := [name for name in COORDINATES if name not in meanings]:
        raise InputError(_columns_error("columns_missing", path, row, missing))
    if duplicates := [name for name in USED_COLUMNS if meanings.count(name) > 1]:
        raise InputError(_columns_error("duplicate_columns", path, row, duplicates))
    return meanings


_COLUMN_ERRORS = {
    "other_axes": ("seeds.other_axes", "seeds.other_axes_in_row"),
    "columns_missing": ("seeds.columns_missing", "seeds.columns_missing_in_row"),
    "duplicate_columns": ("seeds.duplicate_columns", "seeds.duplicate_columns_in_row"),
}
"""Codes of errors about columns: if the user names them, and if a row of the file names them."""


def _columns_error(what: str, path: Path, row: int | None, names: Sequence[str]) -> Message:
    given, in_row = _COLUMN_ERRORS[what]
    if row is None:
        return error(given, file=str(path), names=tuple(names))
    return error(in_row, file=str(path), row=row, names=tuple(names))


def _is_numeric_row(row: str, separator: str, meanings: Sequence[str], degrees: bool) -> bool:
    fields = split_fields(row, separator)
    return any(
        name in COORDINATES and k < len(fields)
        and parse_coordinate(fields[k], degrees=degrees) is not None
        for k, name in enumerate(meanings)
    )  # fmt: skip


def _meanings_by_order(
    path: Path, row: int, text: str, separator: str, check: bool
) -> tuple[str, ...]:
    """Meanings of the columns by their order: name, x, y, z, role.

    For check points: name, x, y, z, sigma, plane; without a name there is no sigma either.

    Raises
    ------
    InputError
        If the order is unknown.
    """
    fields = split_fields(text, separator)
    numbers = [is_number(field) for field in fields]
    count = sum(numbers)
    if check and len(fields) in (5, 6) and all(numbers[1:5]):
        return (NAME, *COORDINATES, SIGMA, PLANE)[: len(fields)]
    if numbers[:3] == [True] * 3 and count == 3:
        start = 0
    elif numbers[1:4] == [True] * 3 and count - numbers[0] == 3:
        start = 1
    else:
        code = "seeds.too_few_numbers" if count < 3 else "seeds.order_unclear"
        raise InputError(error(code, file=str(path), row=row, found=count, total=len(fields)))
    rest = fields[start + 3 :]
    has_role = bool(rest) and rest[0].lower() in ROLES_BY_WORD
    return (
        ((NAME,) if start else ())
        + COORDINATES
        + (((ROLE,) if has_role else (UNUSED,)) if rest else ())
    )


def _column_factors(
    path: Path, titles: Mapping[str, str], metres: Sequence[float], degrees: bool
) -> dict[str, float]:
    """Factor of each column, for the unit and direction in its title.

    Raises
    ------
    InputError
        If a unit is not known or does not suit the column.
    """
    factors: dict[str, float] = {}
    sigmas = [(name, 1.0) for name in (SIGMA, *AXIS_SIGMAS)]
    for name, axis_metres in (*zip(COORDINATES, metres, strict=True), *sigmas):
        title = titles.get(name, "")
        unit = title_unit(title)
        angle = degrees and name in COORDINATES[:2]
        if angle:
            is_reversed = direction_of(title) == ("west" if name == "x" else "south")
            factors[name] = -1.0 if is_reversed else 1.0
        if not unit or (unit in ("dms", "ddmm") and angle):
            continue
        kind = "angle" if angle else "length"
        if unit == UNKNOWN or UNITS[unit].kind != kind:
            code = "seeds.not_an_angle" if angle else "seeds.not_a_length"
            raise InputError(error(code, file=str(path), column=title))
        unit_si = UNITS["deg"].si if angle else axis_metres
        is_of_system = (
            unit == "ft" and abs(axis_metres / INTERNATIONAL_FOOT_M - 1) < 1e-5
        )  # or US survey feet
        if not is_of_system:
            factors[name] = factors.get(name, 1.0) * UNITS[unit].si / unit_si
    return factors


GEOGRAPHIC_LIMITS = {"x": (360.0, "NS"), "y": (90.0, "EW")}
"""Largest longitude and latitude, degrees, and the hemispheres of the other coordinate."""


def _parse_point(
    path: Path, row: int, fields: list[str], meanings: Sequence[str], degrees: bool,
    factors: Mapping[str, float],
) -> ListedPoint:  # fmt: skip
    column_of = {name: k for k, name in enumerate(meanings) if name != UNUSED}
    needed = 1 + max(column_of[name] for name in (NAME, *COORDINATES) if name in column_of)
    if len(fields) < needed:
        raise InputError(
            error(
                "seeds.row_too_short", file=str(path), row=row, found=len(fields), needed=needed,
                names=meanings,
            )
        )  # fmt: skip
    values = []
    for axis in COORDINATES:
        field = fields[column_of[axis]]
        value = parse_coordinate(field, degrees=degrees)
        if degrees and axis in GEOGRAPHIC_LIMITS and value is not None:
            limit, others = GEOGRAPHIC_LIMITS[axis]
            ends = {field.strip().upper()[:1], field.strip().upper()[-1:]}
            if abs(value * factors.get(axis, 1.0)) > limit or ends & set(others):
                value = None
        if value is None:
            raise InputError(
                error(
                    "seeds.unusable_coordinate", file=str(path), row=row, axis=axis,
                    value=field[:40],
                )
            )  # fmt: skip
        values.append(value * factors.get(axis, 1.0))
    name = fields[column_of[NAME]].strip() if NAME in column_of else ""
    if NAME in column_of:
        try:
            require_target_name(name)
        except ProjectError as failure:
            raise InputError(
                error("seeds.invalid_name", file=str(path), row=row, reason=failure.reason)
            ) from failure
    word = (
        fields[column_of[ROLE]].strip().lower()
        if ROLE in column_of and column_of[ROLE] < len(fields)
        else ""
    )
    if word and word not in ROLES_BY_WORD:
        raise InputError(error("seeds.unknown_role", file=str(path), row=row, role=word[:40]))
    x, y, z = values
    sigma, plane = (
        fields[column_of[what]].strip()
        if what in column_of and column_of[what] < len(fields)
        else ""
        for what in (SIGMA, PLANE)
    )
    sigma_metres = _parse_sigma(path, row, sigma)
    if sigma_metres is not None:
        sigma_metres *= factors.get(SIGMA, 1.0)
    axis_sigmas = None
    if all(what in column_of and column_of[what] < len(fields) for what in AXIS_SIGMAS):
        each = [_parse_sigma(path, row, fields[column_of[what]].strip()) for what in AXIS_SIGMAS]
        sx, sy, sz = (
            (value or 0.0) * factors.get(what, 1.0)
            for value, what in zip(each, AXIS_SIGMAS, strict=True)
        )
        if all(value is not None for value in each):
            axis_sigmas = sx, sy, sz
            sigma_metres = math.sqrt((sx**2 + sy**2 + sz**2) / 3)
    return ListedPoint(
        row, name, ROLES_BY_WORD[word] if word else None, (x, y, z), sigma_metres, plane,
        axis_sigmas,
    )  # fmt: skip


def _parse_sigma(path: Path, row: int, text: str) -> float | None:
    if not text:
        return None
    value = parse_coordinate(text)
    if value is None or value < 0.0:
        raise InputError(error("seeds.invalid_sigma", file=str(path), row=row, value=text[:40]))
    return value


def _require_unique_points(path: Path, points: Sequence[ListedPoint]) -> None:
    """Refuse a list with two points of the same name or position.

    Raises
    ------
    InputError
        If a name or a position occurs twice.
    """
    names: dict[str, int] = {}
    places: dict[tuple[float, float, float], int] = {}
    for point in points:
        if point.name and point.name in names:
            raise InputError(
                error(
                    "seeds.duplicate_name", file=str(path), row=point.row, name=point.name,
                    other=names[point.name],
                )
            )  # fmt: skip
        if point.coordinates in places:
            raise InputError(
                error(
                    "seeds.duplicate_place", file=str(path), row=point.row,
                    other=places[point.coordinates],
                )
            )  # fmt: skip
        names[point.name], places[point.coordinates] = point.row, point.row
