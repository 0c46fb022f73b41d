"""Text files of point correspondences, as LiMatch writes them for ODyN (EPFL).

Each row is a pair of points: ``t_i t_j x_i y_i z_i x_j y_j z_j``, with times in seconds and
coordinates in metres in the frame of the scanner. Rows before the first number and rows that begin
with the sign of a comment are headers.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from lispac.correspondences.point_pairs import PointPairs
from lispac.errors import InputError
from lispac.io.text.text_layout import COMMENT_MARKS
from lispac.io.text.text_table import (
    is_data_row,
    numbered_lines,
    parse_number,
    read_columns,
    split_fields,
)
from lispac.messages import error

COLUMN_NAMES = ("t_i", "t_j", "x_i", "y_i", "z_i", "x_j", "y_j", "z_j")
FILE_KIND = "point correspondences"


def read_correspondences(path: Path) -> PointPairs:
    """Read the pairs of a file.

    Raises
    ------
    InputError
        If the file cannot be read, has no pair, or a row has not 8 numbers.
    """
    columns = [(k, parse_number, name) for k, name in enumerate(COLUMN_NAMES)]
    values, _ = read_columns(path, _rows(path), columns)
    table = np.column_stack(values)
    return PointPairs(table[:, :2].copy(), table[:, 2:].reshape(-1, 2, 3).copy())


def _rows(path: Path) -> Iterator[tuple[int, list[str]]]:
    """Number and fields of each row of data.

    Raises
    ------
    InputError
        If a row has not 8 fields.
    """
    has_begun = False
    for row, line in numbered_lines(path, FILE_KIND):
        text = line.strip()
        if not text or text.startswith(COMMENT_MARKS):
            continue
        fields = split_fields(text)
        if not has_begun and not is_data_row(fields):
            continue
        has_begun = True
        if len(fields) != len(COLUMN_NAMES):
            raise InputError(
                error("correspondences.columns", file=str(path), row=row, found=len(fields))
            )
        yield row, fields
