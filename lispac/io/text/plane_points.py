"""The 25-column plane files of the thesis prototype, read as points of a line."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from lispac.io.first_points import check_first_points
from lispac.io.format_types import IMPOSSIBLE, SURE, Choice, FileFormat, FilePreview, PointChunk
from lispac.io.point_reader_common import (
    COMMON_OPTIONS,
    SCANNER_COLUMN_ASSUMPTIONS,
    coordinate_scale,
    frame_facts,
    head_sniffer,
    preview_table,
    require_not_empty,
    require_usable_points,
    time_base_message,
)
from lispac.io.text.plane_file import N_COLUMNS, read_plane_table
from lispac.messages import note, warning
from lispac.survey.line_source import printable

EXTRA_COLUMNS = {
    "points_local": slice(1, 4), "attitude": slice(8, 11), "sigma_attitude": slice(11, 14),
    "position": slice(14, 17), "sigma_position": slice(17, 20), "plane": slice(20, 24),
}  # fmt: skip
COLUMN_NAMES = (
    "key", "X", "Y", "Z", "time", "x lidar", "y lidar", "z lidar", "roll", "pitch", "heading",
    "s roll", "s pitch", "s heading", "X pos", "Y pos", "Z pos", "s north", "s east", "s up",
    "a", "b", "c", "d", "plane",
)  # fmt: skip


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the first row: 25 numbers, of which numbers 21 to 23 are a unit normal."""
    row = head.split(b"\n", 1)[0].replace(b",", b" ").split()
    if len(row) != N_COLUMNS:
        return IMPOSSIBLE
    normal = [float(field) for field in row[20:23]]
    return SURE if abs(np.linalg.norm(normal) - 1) < 1e-3 else IMPOSSIBLE


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Preview a plane file, which is read completely because it is small.

    Raises
    ------
    InputError
        If the file cannot be read or is not a plane file.
    """
    rows = read_plane_table(require_not_empty(path, "plane"))
    file = printable(path.name)
    resolved = PLANE_FORMAT.complete_options(choice)
    points_check = check_first_points(rows[:, 5:8], rows[:, 4], file=file, crs="")
    facts = {
        "format": note("fact.planes"),
        "points": len(rows),
        **frame_facts(resolved),
        "time base": time_base_message(rows[:, 4], resolved["time_base"]),
        **points_check.facts,
    }
    file_warnings = (warning("points.of_one_target", file=file), *points_check.file_warnings)
    return FilePreview(
        facts,
        preview_table(COLUMN_NAMES, tuple(rows.T)),
        {},
        file_warnings,
        SCANNER_COLUMN_ASSUMPTIONS,
    )


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read the file as one chunk.

    Raises
    ------
    InputError
        If the file cannot be read or is not a plane file.
    """
    path = require_not_empty(path, "plane")
    scale = coordinate_scale(PLANE_FORMAT.complete_options(choice))
    rows = read_plane_table(path)
    require_usable_points(rows[:, 5:8], rows[:, 4], path)
    extra = {name: rows[:, columns].copy() for name, columns in EXTRA_COLUMNS.items()}
    yield PointChunk(rows[:, 5:8] * scale, rows[:, 4].copy(), extra, len(rows))


PLANE_FORMAT = FileFormat(
    note("format.planes"), "planes", "points", (".txt",), COMMON_OPTIONS, sniff, preview_file, read
)
