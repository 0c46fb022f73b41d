"""Chunked reading of the coordinates of clouds without time, for example from a tripod.

Supported are LAS and LAZ of any point format, E57 with the poses of its scans applied, PTS, and
text with three columns of coordinates. The format is detected from the content.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.format_types import IMPOSSIBLE
from lispac.io.las import las_chunks
from lispac.io.point_reader_common import HEAD_BYTES, report_damage, require_not_empty
from lispac.io.points import e57, pcd, ply
from lispac.io.text import pts
from lispac.io.text.seed_file import header_meanings, separator_of
from lispac.io.text.text_layout import COMMENT_MARKS, SEPARATOR_CHARACTERS
from lispac.io.text.text_table import UTF16_ENCODINGS, is_number, numbered_lines, split_fields
from lispac.messages import Message, error
from lispac.survey.point_screening import MAX_COORDINATE

Array = NDArray[np.float64]

FILE_KIND = "static scan"
ROWS_CHECKED = 20
"""Rows of a text that are checked for times."""


@dataclass(frozen=True)
class StaticScan:
    """A cloud without time.

    Attributes
    ----------
    path : Path
    system : str
        Coordinate system specified in the file; empty if there is none.
    height_unit : str
        Unit of heights specified in the file; empty if there is none.
    messages : tuple of Message
        Warnings and notes about the file.
    """

    path: Path
    system: str = ""
    height_unit: str = ""
    messages: tuple[Message, ...] = ()

    @property
    def is_cloud(self) -> bool:
        """True if the file is certainly a cloud; a text file may also be a list of points."""
        return bool(_scan_kind(self.path))

    def coordinate_chunks(self, *, local: bool) -> Iterator[Array]:
        """Coordinates, shape (n, 3), in the file's own system, about a million at a time.

        Parameters
        ----------
        local : bool
            Whether a text file's columns may be named after the axes of the local frame.

        Raises
        ------
        InputError
            If the file is damaged, empty, or contains values that are not coordinates.
        """
        known = {
            "las": las_chunks.read_coordinates,
            "e57": e57.read_coordinates,
            "pts": pts.read_coordinates,
        }
        if kind := _scan_kind(self.path):
            chunks = known[kind](self.path)
        else:
            chunks = iter([_read_text(self.path, local)])
        count = 0
        for chunk in chunks:
            good = (np.abs(chunk) <= MAX_COORDINATE).all(axis=1)
            if not good.all():
                point = count + int(np.argmin(good)) + 1
                raise InputError(
                    error("static_scan.unusable_coordinate", file=str(self.path), point=point)
                )
            count += len(chunk)
            yield chunk
        if not count:
            raise InputError(error("static_scan.no_points", file=str(self.path)))


def open_static_scan(path: Path) -> StaticScan:
    """Open a cloud without reading its points.

    Raises
    ------
    InputError
        If the file is missing, empty, damaged, or in a format that is not read without time.
    """
    path = require_not_empty(Path(path), FILE_KIND)
    kind = _scan_kind(path)
    if kind == "las":
        header_crs = las_chunks.read_file_crs(path)
        return StaticScan(path, header_crs.text, header_crs.height_unit, header_crs.messages)
    if kind == "e57":
        system, messages = e57.read_file_crs(path)
        return StaticScan(path, system, messages=messages)
    return StaticScan(path)


def _scan_kind(path: Path) -> str:
    """Format by the content: ``las``, ``e57`` or ``pts``; empty for other text.

    Raises
    ------
    InputError
        If it is a cloud in a format that is not read without time.
    """
    if las_chunks.sniff(path) > IMPOSSIBLE:
        return "las"
    if e57.sniff(path) > IMPOSSIBLE:
        return "e57"
    other = pts.is_ptx(path) or any(each.sniff(path) > IMPOSSIBLE for each in (ply, pcd))
    if not other and pts.is_pts(path):
        return "pts"
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    if other or (b"\0" in head and head[:2] not in UTF16_ENCODINGS):
        raise InputError(error("static_scan.other_format", file=str(path)))
    return ""


def _read_text(path: Path, local: bool) -> Array:
    """Read the columns x, y, z named in a header row, else the first three columns.

    Raises
    ------
    InputError
        If no row has three coordinates, or they have decimal commas.
    """
    rows = (
        (number, line) for number, line in numbered_lines(path, FILE_KIND)
        if line.strip() and not line.strip().startswith(COMMENT_MARKS)
    )  # fmt: skip
    first = next(rows, None)
    if first is None:
        raise InputError(error("static_scan.no_coordinates", file=str(path)))
    separator = separator_of(first[1])
    names = header_meanings(first[1], separator, local=local)
    above = first[0] if names else first[0] - 1
    sample = next(rows, first) if names else first
    separator = separator_of(sample[1])
    fields = split_fields(sample[1], separator)
    if names:
        columns = [names.index(axis) for axis in "xyz" if axis in names]
    else:
        columns = [k for k, field in enumerate(fields) if is_number(field)][:3]
    if len(columns) < 3 or max(columns) >= len(fields):
        raise InputError(error("static_scan.too_few_coordinates", file=str(path), row=sample[0]))
    if any("," in fields[k] for k in columns):
        raise InputError(error("static_scan.decimal_commas", file=str(path), row=sample[0]))
    with report_damage(path, f"text of a {FILE_KIND}"), path.open(encoding="utf-8-sig") as file:
        return np.loadtxt(
            file, delimiter=SEPARATOR_CHARACTERS.get(separator), usecols=columns, skiprows=above,
            ndmin=2, comments=list(COMMENT_MARKS),
        )  # fmt: skip


def has_no_time(path: Path, *, or_text: bool) -> bool:
    """True if a file is a cloud without time: PTS, or text whose first rows have only x, y, z.

    Parameters
    ----------
    or_text : bool
        Whether text other than PTS is examined; it is otherwise not a cloud.
    """
    if pts.has_point_count(path) or not or_text:
        return pts.has_point_count(path)
    try:
        texts = (line.strip() for _, line in islice(numbered_lines(path, FILE_KIND), ROWS_CHECKED))
        rows = [split_fields(text) for text in texts if text and not text.startswith(COMMENT_MARKS)]
    except InputError:
        return False
    body = rows[1:]  # below a row of names
    return bool(body) and all(len(row) == 3 and all(map(is_number, row)) for row in body)


def has_at_most_rows(path: Path, limit: int) -> bool:
    """True if a text file has at most ``limit`` lines."""
    return len(list(islice(numbered_lines(path, FILE_KIND), limit + 1))) <= limit
