"""Reading of E57 files with time stamps, one scan after the other."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.first_points import check_first_points
from lispac.io.format_types import (
    IMPOSSIBLE,
    SAME_TIME_BASE_NOTE,
    SURE,
    Choice,
    Fact,
    FileFormat,
    FilePreview,
    FormatOption,
    PointChunk,
)
from lispac.io.point_reader_common import (
    COMMON_OPTIONS,
    GEOREFERENCED_FRAME,
    POINTS_PER_CHUNK,
    PREVIEW_POINTS,
    coordinate_scale,
    frame_facts,
    head_sniffer,
    preview_table,
    report_damage,
    require_not_empty,
    time_base_message,
    time_base_warnings,
    usable_points,
)
from lispac.io.points.e57_scans import Scan, find_scans, invalid_count, opened_e57, stored_points
from lispac.language import N_
from lispac.messages import Level, Message, Value, error, note, warning
from lispac.survey.line_source import printable

Array = NDArray[np.float64]

FROM_SCAN_START, FROM_ZERO = "start", "zero"
TIME_FROM_OPTION = FormatOption(
    "time_from",
    N_("Time from which time stamps count: the start of their scan, as in the standard, or zero."),
    (FROM_SCAN_START, FROM_ZERO), FROM_SCAN_START,
)  # fmt: skip
SECONDS_PER_DAY = 86_400.0


@head_sniffer
def sniff(head: bytes, path: Path) -> float:
    """Likelihood by the signature: E57 files start with the name of the format."""
    return SURE if head[:8] == b"ASTM-E57" else IMPOSSIBLE


def preview_file(path: Path, choice: Choice) -> FilePreview:
    """Read the metadata of the scans, and the first points.

    Raises
    ------
    InputError
        If the file cannot be read or has no time stamps.
    """
    path = require_not_empty(path, "E57")
    with report_damage(path, "E57"), opened_e57(path) as image:
        scans = find_scans(image, path)
        system = _text_field(image.root(), "coordinateMetadata")
        writer = _text_field(image.root(), "e57LibraryVersion")
        # Scans without valid points are skipped, as when the points are read.
        candidates = (
            (scan, columns)
            for scan in scans
            for columns in stored_points(image, scan, path, PREVIEW_POINTS, 0)
        )
        scan, stored = next(candidates, (scans[0], None))
        candidates.close()
        invalid = sum(invalid_count(image, scan) for scan in scans)
    if stored is None:
        raise InputError(error("file.no_points", file=str(path)))
    count = sum(scan.count for scan in scans)
    stamps = stored["timeStamp"]
    file_warnings: list[Message] = []
    file = printable(path.name)
    found = {"time_from": FROM_SCAN_START, "crs": system}
    if stamps.max() > SECONDS_PER_DAY:
        found["time_from"] = FROM_ZERO
        file_warnings.append(warning("e57.large_time_stamps", file=file, time=float(stamps[0])))
    elif not all(scan.start for scan in scans):
        found["time_from"] = FROM_ZERO
        file_warnings.append(warning("e57.start_not_stated", file=file))
    if any(scan.has_pose for scan in scans):
        file_warnings.append(warning("e57.poses", file=file))
    base = "gps-full" if {**found, **choice}["time_from"] == FROM_SCAN_START else ""
    found["time_base"] = base
    posed = usable_points(
        _point_chunk(stored, scan, {"frame": GEOREFERENCED_FRAME, **found}, count)
    )
    points_check = check_first_points(posed.xyz, posed.time, file=file, crs=system)
    found["frame"] = points_check.frame
    resolved = E57_FORMAT.complete_options({**found, **choice})
    time = posed.time
    facts: dict[str, Fact] = {
        "format": "E57",
        "points": note("fact.points_in_scans", points=count, scans=len(scans)),
        "coordinate system": system[:200] or note("fact.none"),
        **frame_facts(resolved),
        "time base": time_base_message(time, resolved["time_base"]),
        **points_check.facts,
        "fields": ", ".join(scan.fields),
        "written by": writer or note("fact.not_specified"),
    }
    assumptions = (
        (note("assumed.time_stamps_from_scan"),)
        if resolved["time_from"] == FROM_SCAN_START
        else (note("assumed.time_stamps_as_they_are"), SAME_TIME_BASE_NOTE)
    )
    names = tuple(stored)
    return FilePreview(
        facts,
        preview_table(names, tuple(stored.values())),
        {name: value for name, value in found.items() if value},
        (*file_warnings, *points_check.file_warnings, *time_base_warnings(time, base, file)),
        assumptions,
        _invalid_point_messages(path, invalid, count),
    )


def read(path: Path, choice: Choice) -> Iterator[PointChunk]:
    """Read scan by scan in chunks, without the points that the file marks as invalid.

    Spherical coordinates are used for points without valid Cartesian ones. The poses of the scans
    are applied to georeferenced points but not to points in the scanner frame.

    Raises
    ------
    InputError
        If the file is missing, damaged, empty, or without time stamps.
    """
    path = require_not_empty(path, "E57")
    resolved = E57_FORMAT.complete_options(choice)
    done = 0
    with report_damage(path, "E57"), opened_e57(path) as image:
        scans = find_scans(image, path)
        total = sum(scan.count for scan in scans)
        if resolved["time_from"] == FROM_SCAN_START and not all(scan.start for scan in scans):
            raise InputError(error("e57.no_start", file=str(path)))
        for scan in scans:
            for stored in stored_points(image, scan, path, POINTS_PER_CHUNK, done):
                done += len(stored["timeStamp"])
                yield _point_chunk(stored, scan, resolved, total)


def read_coordinates(path: Path) -> Iterator[Array]:
    """Coordinates of the valid points, shape (n, 3), with the poses of the scans applied.

    Raises
    ------
    InputError
        If the file is missing, damaged or empty.
    """
    path = require_not_empty(path, "E57")
    with report_damage(path, "E57"), opened_e57(path) as image:
        for scan in find_scans(image, path, timed=False):
            for stored in stored_points(image, scan, path, POINTS_PER_CHUNK, 0, timed=False):
                xyz = np.stack([stored[axis] for axis in "xyz"], axis=1)
                yield xyz @ scan.rotation.T + scan.translation


def read_file_crs(path: Path) -> tuple[str, tuple[Message, ...]]:
    """Coordinate system specified in the file, empty if there is none, and messages.

    Raises
    ------
    InputError
        If the file is damaged.
    """
    path = require_not_empty(path, "E57")
    with report_damage(path, "E57"), opened_e57(path) as image:
        scans = find_scans(image, path, timed=False)
        invalid = sum(invalid_count(image, scan, timed=False) for scan in scans)
        total = sum(scan.count for scan in scans)
        system = _text_field(image.root(), "coordinateMetadata")
    return system, _invalid_point_messages(path, invalid, total)


def _invalid_point_messages(path: Path, count: int, total: int) -> tuple[Message, ...]:
    params: dict[str, Value] = {"file": path.name, "count": count, "total": total}
    return (Message("file.invalid_points", Level.NOTE, params),) if count else ()


def _point_chunk(
    stored: Mapping[str, NDArray[Any]], scan: Scan, resolved: Choice, total: int
) -> PointChunk:
    xyz = np.stack([stored[axis] for axis in "xyz"], axis=1)
    if resolved["frame"] == GEOREFERENCED_FRAME:
        xyz = xyz @ scan.rotation.T + scan.translation
    else:
        xyz = xyz * coordinate_scale(resolved)
    time = stored["timeStamp"].astype(np.float64)
    if resolved["time_from"] == FROM_SCAN_START:
        time = time + scan.start
    own_fields = (*"xyz", "timeStamp")
    extra = {name: values for name, values in stored.items() if name not in own_fields}
    return PointChunk(xyz, time, extra, total)


def _text_field(root: Any, name: str) -> str:
    return str(root[name].value()).strip() if root.isDefined(name) else ""


E57_FORMAT = FileFormat(
    note("format.e57"),
    "e57",
    "points",
    (".e57",),
    (TIME_FROM_OPTION, *COMMON_OPTIONS),
    sniff,
    preview_file,
    read,
)
