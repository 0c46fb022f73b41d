"""Reading of CIDCO's binary points for boresight calibration: 22 little-endian float64 a point.

X, Y, Z local; time; x, y, z LiDAR and their sigmas; roll, pitch, heading (radians) and their
sigmas; POS position local and its sigmas. The points are read in the LiDAR frame; the other values
are kept as attributes.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.format_types import IMPOSSIBLE, LIKELY, Choice, FileFormat, FilePreview, PointChunk
from lispac.io.point_reader_common import (
    COMMON_OPTIONS,
    POINTS_PER_CHUNK,
    PREVIEW_POINTS,
    SCANNER_COLUMN_ASSUMPTIONS,
    coordinate_scale,
    frame_facts,
    head_sniffer,
    preview_table,
    report_damage,
    require_not_empty,
    require_usable_points,
    time_base_message,
    usable_mask,
)
from lispac.messages import error, note
from lispac.survey.line_source import printable

N_COLUMNS = 22
RECORD_BYTES = 8 * N_COLUMNS
EXTRA_COLUMNS = {
    "points_local": slice(0, 3), "sigma_lidar": slice(7, 10), "attitude": slice(10, 13),
    "sigma_attitude": slice(13, 16), "position": slice(16, 19), "sigma_position": slice(19, 22),
}  # fmt: skip
COLUMN_NAMES = (
    "X", "Y", "Z", "time", "x lidar", "y lidar", "z lidar", "sx", "sy", "sz", "roll", "pitch",
    "heading", "s roll", "s pitch", "s heading", "X pos", "Y pos", "Z pos", "s X", "s Y", "s Z",
)  # fmt: skip
MAX_LEVER_ARM_M = 50.0  # metres between POS and LiDAR on any vessel


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the geometry: the distance from POS to point agrees with the LiDAR range."""
    if path.stat().st_size % RECORD_BYTES:
        return IMPOSSIBLE
    records = np.frombuffer(head[: len(head) // RECORD_BYTES * RECORD_BYTES], "<f8").reshape(
        -1, N_COLUMNS
    )
    return LIKELY if len(records) and _are_consistent_records(records).all() else IMPOSSIBLE


def _are_consistent_records(records: NDArray[np.float64]) -> NDArray[np.bool_]:
    sigmas = records[:, [7, 8, 9, 13, 14, 15, 19, 20, 21]]
    angles = records[:, 10:13]
    with np.errstate(all="ignore"):  # other files give arbitrary numbers
        distance = np.linalg.norm(records[:, 0:3] - records[:, 16:19], axis=1)
        lidar_range = np.linalg.norm(records[:, 4:7], axis=1)
        finite = np.isfinite(records).all(axis=1)
        is_near = np.abs(distance - lidar_range) < MAX_LEVER_ARM_M
        sound = (sigmas >= 0).all(axis=1) & (np.abs(angles) < 2 * np.pi + 1e-6).all(axis=1)
        return finite & is_near & sound & (lidar_range < 1e4) & (np.abs(records[:, 3]) < 1e10)


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Read the first points.

    Raises
    ------
    InputError
        If the file cannot be read or does not contain such records.
    """
    path = require_not_empty(path, "CIDCO")
    resolved = CIDCO_FORMAT.complete_options(choice)
    records = next(record_chunks(path, PREVIEW_POINTS))
    points_check = check_first_points(
        records[:, 4:7], records[:, 3], file=printable(path.name), crs=""
    )
    facts = {
        "format": note("fact.cidco"),
        "points": path.stat().st_size // RECORD_BYTES,
        **frame_facts(resolved),
        "time base": time_base_message(records[:, 3], resolved["time_base"]),
        **points_check.facts,
    }
    assumptions = (note("assumed.cidco_columns"), *SCANNER_COLUMN_ASSUMPTIONS)
    return FilePreview(
        facts,
        preview_table(COLUMN_NAMES, tuple(records.T)),
        {},
        points_check.file_warnings,
        assumptions,
    )


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read the points in chunks.

    Raises
    ------
    InputError
        If the file is missing, cut short, empty, or does not contain such records.
    """
    path = require_not_empty(path, "CIDCO")
    scale, total = (
        coordinate_scale(CIDCO_FORMAT.complete_options(choice)),
        path.stat().st_size // RECORD_BYTES,
    )
    for records in record_chunks(path, POINTS_PER_CHUNK):
        extra = {name: records[:, columns].copy() for name, columns in EXTRA_COLUMNS.items()}
        yield PointChunk(records[:, 4:7] * scale, records[:, 3].copy(), extra, total)


def record_chunks(path: Path, rows: int) -> Iterator[NDArray[np.float64]]:
    """Read all records in blocks of shape (n, 22).

    Raises
    ------
    InputError
        If the file is cut short or its records are inconsistent.
    """
    size = path.stat().st_size
    if size % RECORD_BYTES:
        raise InputError(
            error(
                "cidco.cut_short",
                file=str(path),
                bytes=size,
                record=RECORD_BYTES,
                rest=size % RECORD_BYTES,
            )
        )
    with report_damage(path, "CIDCO binary"), path.open("rb") as file:
        done = 0
        while data := file.read(rows * RECORD_BYTES):
            whole = len(data) // RECORD_BYTES * RECORD_BYTES
            records = np.frombuffer(data[:whole], "<f8").reshape(-1, N_COLUMNS).astype(np.float64)
            require_usable_points(records[:, 4:7], records[:, 3], path, done)
            usable = usable_mask(records[:, 4:7], records[:, 3])
            bad = usable & ~_are_consistent_records(records)
            if bad.any():
                point = done + int(np.argmax(bad)) + 1
                raise InputError(error("cidco.inconsistent_point", file=str(path), point=point))
            done += len(records)
            yield records


CIDCO_FORMAT = FileFormat(
    note("format.cidco"), "cidco", "points", (), COMMON_OPTIONS, sniff, preview_file, read
)
