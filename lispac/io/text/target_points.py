"""Reading of targets that this program has exported as CSV, as points of a line."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.format_types import (
    IMPOSSIBLE,
    SAME_TIME_BASE_NOTE,
    SURE,
    Choice,
    FileFormat,
    FilePreview,
    PointChunk,
)
from lispac.io.point_reader_common import (
    COMMON_OPTIONS,
    coordinate_scale,
    frame_facts,
    head_sniffer,
    preview_table,
    report_damage,
    require_not_empty,
    require_usable_points,
    time_base_message,
)
from lispac.io.text.text_export import LINE_AND_TIME_COLUMNS, SCANNER_COLUMN_NAMES
from lispac.messages import error, note, warning
from lispac.survey.line_source import printable

SCANNER_X_COLUMN = 5
"""Index of the column with the scanner's x, after line, time and three coordinates in a coordinate
system or the local frame."""
INTENSITY_COLUMN = 8


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the column names of an exported target."""
    names = head.split(b"\n", 1)[0].decode("utf-8").strip().split(",")
    return SURE if _are_target_columns(names) else IMPOSSIBLE


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Preview a target file, which is read completely because it is small.

    Raises
    ------
    InputError
        If the file cannot be read or is damaged.
    """
    chunk = _read_points(require_not_empty(path, "target"))
    file = printable(path.name)
    resolved = TARGET_FORMAT.complete_options(choice)
    points_check = check_first_points(chunk.xyz, chunk.time, file=file, crs="")
    facts = {
        "format": note("fact.target"),
        "points": len(chunk.time),
        **frame_facts(resolved),
        "time base": time_base_message(chunk.time, resolved["time_base"]),
        **points_check.facts,
    }
    rows = preview_table(("time", "x lidar", "y lidar", "z lidar"), (chunk.time, *chunk.xyz.T))
    file_warnings = (warning("points.of_one_target", file=file), *points_check.file_warnings)
    return FilePreview(
        facts, rows, {}, file_warnings, (note("assumed.scanner_coordinates"), SAME_TIME_BASE_NOTE)
    )


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read the file as one chunk, with the lines numbered from 1 as ``point_source_id``.

    Raises
    ------
    InputError
        If the file cannot be read or is damaged.
    """
    path = require_not_empty(path, "target")
    scale = coordinate_scale(TARGET_FORMAT.complete_options(choice))
    chunk = _read_points(path)
    require_usable_points(chunk.xyz, chunk.time, path)
    yield PointChunk(chunk.xyz * scale, chunk.time, chunk.extra, chunk.total)


def _are_target_columns(names: Sequence[str]) -> bool:
    lidar = tuple(names[SCANNER_X_COLUMN : SCANNER_X_COLUMN + 3])
    return tuple(names[:2]) == LINE_AND_TIME_COLUMNS and lidar == SCANNER_COLUMN_NAMES


def _read_points(path: Path) -> PointChunk:
    """Read the points in the LiDAR frame.

    Raises
    ------
    InputError
        If the file contains no points or a row is not valid.
    """
    with report_damage(path, "a target as CSV"), path.open(encoding="utf-8") as file:
        names = file.readline().strip().split(",")
        rows = [line.rstrip("\r\n").split(",") for line in file]
    if not _are_target_columns(names):
        raise InputError(error("text.not_a_target", file=str(path)))
    if not rows:
        raise InputError(error("line.no_points", file=str(path)))
    for number, row in enumerate(rows, start=2):
        if len(row) != len(names):
            raise InputError(
                error(
                    "text.uneven_row", file=str(path), row=number, found=len(row),
                    needed=len(names),
                )
            )  # fmt: skip
    with report_damage(path, "a target as CSV"):
        values = np.array([row[1:] for row in rows], dtype=float)
    _, first, line = np.unique([row[0] for row in rows], return_index=True, return_inverse=True)
    order = np.argsort(np.argsort(first))
    extra = {"point_source_id": (order[line.reshape(-1)] + 1).astype(np.uint16)}
    if len(names) > INTENSITY_COLUMN:
        extra["intensity"] = values[:, INTENSITY_COLUMN - 1].copy()
    xyz = np.ascontiguousarray(values[:, SCANNER_X_COLUMN - 1 : SCANNER_X_COLUMN + 2])
    return PointChunk(xyz, values[:, 0].copy(), extra, len(rows))


TARGET_FORMAT = FileFormat(
    note("format.target"), "target", "points", (".csv",), COMMON_OPTIONS, sniff, preview_file, read
)
