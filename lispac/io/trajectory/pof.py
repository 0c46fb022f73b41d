"""Reading of RIEGL POF trajectories (position and orientation file).

RIEGL does not publish the format. The layout is that of the public reader ``pos`` (docs.rs/pos,
module ``pof``), whose tests contain values of a file of RiPROCESS: a header of little-endian
numbers after 27 bytes of text, then at the offset given in the header one record for each state:
time, longitude, latitude, height, roll, pitch and yaw, and the distance from version 1.1 on, each
as float64; angles are in degrees. Signs and ellipsoid are not documented.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, failure_reason
from lispac.io.files import require_file, require_increasing, require_numbers
from lispac.io.format_types import IMPOSSIBLE, LIKELY, SURE, Choice, Fact, FilePreview
from lispac.io.trajectory.trajectory_checks import (
    require_attitude,
    require_heights,
    require_time_base,
)
from lispac.io.trajectory.trajectory_columns import sign_note
from lispac.io.trajectory.trajectory_facts import (
    course_warnings,
    motion_of,
    time_warnings,
    trajectory_facts,
)
from lispac.io.trajectory.trajectory_options import (
    PITCH_OPTION,
    ROLL_OPTION,
    TIME_OPTION,
    trajectory_format,
)
from lispac.io.trajectory.trajectory_preview import refusal_warning, sign_assumed_warning
from lispac.language import N_
from lispac.messages import Message, error, note, warning
from lispac.survey.known_time_base import base_message
from lispac.survey.line_source import printable
from lispac.survey.time_base import base_of_key, plausible_bases, unroll_times
from lispac.survey.trajectory import Trajectory

Array = NDArray[np.float64]

_HEADER = np.dtype(
    [
        ("title", "S27"), ("major", "<u2"), ("minor", "<u2"), ("offset", "<u4"), ("year", "<u2"),
        ("month", "<u2"), ("day", "<u2"), ("count", "<i8"), ("limits", "<f8", (3, 2)),
        ("intervals", "<f8", 3), ("time_unit", "u1"), ("time_system", "u1"),
    ]
)  # fmt: skip
"""Beginning of the header; names of the project and the devices follow."""
_LIMITS = np.array([[360.0, 360.0], [90.0, 90.0], [1e5, 1e5]])
"""Largest longitude and latitude, degrees, and height, metres, in the header."""
_TIME_SPANS = {1: "day", 2: "week"}
"""Part of the key of a time base by the code in the header; 0 counts from an unknown start."""
_TIME_SYSTEMS = {0: "gps", 1: "utc"}
"""Part of the key of a time base by the code in the header; 2 is unknown."""
_COLUMNS = (
    N_("time"), N_("longitude"), N_("latitude"), N_("height"), N_("roll"), N_("pitch"),
    N_("heading"), N_("distance"),
)  # fmt: skip
_EDGE_RECORDS = 30_000
"""Number of records at the beginning that are examined for the preview."""


@dataclass(frozen=True)
class PofHeader:
    """Header of a POF.

    Attributes
    ----------
    version : (int, int)
    date : str
    offset : int, bytes before the first record
    count : int, number of records
    time : str
        Key of the time base; empty if the times count from an unknown start.
    is_gps_assumed : whether the header does not say whether the times are GPS time or UTC
    """

    version: tuple[int, int]
    date: str
    offset: int
    count: int
    time: str
    is_gps_assumed: bool

    @property
    def columns(self) -> int:
        """Number of float64 in a record."""
        return 8 if self.version[1] >= 1 else 7


def read_header(path: Path) -> PofHeader | None:
    """Header of a POF; None if the file is none, or cannot be read."""
    try:
        with Path(path).open("rb") as file:
            data = file.read(_HEADER.itemsize)
    except OSError:
        return None
    if len(data) < _HEADER.itemsize:
        return None
    (head,) = np.frombuffer(data, _HEADER)
    low, high = head["limits"].T
    with np.errstate(invalid="ignore"):
        is_sound = bool(
            (low <= high).all()
            and (np.abs(head["limits"]) <= _LIMITS).all()
            and (head["intervals"] >= 0).all()
        )
    is_dated = 1980 <= head["year"] < 2100 and 1 <= head["month"] <= 12 and 1 <= head["day"] <= 31
    is_known = head["major"] == 1 and head["time_unit"] <= 2 and head["time_system"] <= 2
    if not (is_sound and is_dated and is_known and head["count"] > 0):
        return None
    if not _HEADER.itemsize <= head["offset"] < 1e6:
        return None
    span, system = int(head["time_unit"]), int(head["time_system"])
    return PofHeader(
        (int(head["major"]), int(head["minor"])),
        f"{head['year']:04d}-{head['month']:02d}-{head['day']:02d}",
        int(head["offset"]),
        int(head["count"]),
        f"{_TIME_SYSTEMS.get(system, 'gps')}-{_TIME_SPANS[span]}" if span else "",
        system not in _TIME_SYSTEMS,
    )


def sniff_pof(path: Path) -> float:
    """Likelihood that a file is a POF, by its header and its size."""
    header = read_header(path)
    if header is None:
        return IMPOSSIBLE
    whole = header.offset + 8 * header.columns * header.count
    return SURE if Path(path).stat().st_size == whole else LIKELY


def read_pof(path: Path, choice: Choice) -> Trajectory:
    """Read a POF.

    Raises
    ------
    InputError
        If the file is missing, cut short or not a POF, or contains impossible values.
    """
    header, records = _records(path)
    return _trajectory(path, header, records, choice)


def preview_pof(path: Path, choice: Choice) -> FilePreview:
    """Facts, first records and warnings of a POF, from its beginning.

    Raises
    ------
    InputError
        If the file is missing or not a POF.
    """
    header = _require_header(path)
    file = printable(path.name)
    facts: dict[str, Fact] = {
        "Records": header.count,
        "Header": f"POF {header.version[0]}.{header.version[1]}",
        "Date of mission": header.date,
    }
    found: list[Message] = []
    try:
        _, records = _records(path, _EDGE_RECORDS)
    except InputError as refused:
        return FilePreview(facts, (), {}, (refusal_warning(refused, path),))
    columns = _COLUMNS[: records.shape[1]]
    rows = (columns, *(tuple(f"{value:.10g}" for value in row) for row in records[:5]))
    options = {"time": _time_key(header, records[:, 0])} | dict(choice)
    if not header.time:
        found.append(warning("trajectory.pof_unknown_start", file=file))
    elif header.is_gps_assumed:
        found.append(warning("trajectory.pof_gps_assumed", file=file))
    for angle, option in (("roll", ROLL_OPTION), ("pitch", PITCH_OPTION)):
        if angle not in choice:
            found.append(sign_assumed_warning(path, angle, option.default))
    try:
        first = _trajectory(path, header, records, options)
    except InputError as refused:
        return FilePreview(facts, rows, options, (*found, refusal_warning(refused, path)))
    motion, exchanged = (
        motion_of(first.time, *places, first.height)
        for places in (
            (first.latitude, first.longitude), (first.longitude, first.latitude),
        )
    )  # fmt: skip
    facts |= trajectory_facts(
        first.time, first.latitude, first.longitude, first.height, motion.speed
    )
    found += time_warnings(first.time, options["time"], file)
    found += course_warnings([(motion, exchanged)], [first.attitude[:, 2]], file)
    return FilePreview(facts, rows, options, tuple(found), first.assumptions)


def _require_header(path: Path) -> PofHeader:
    path = require_file(Path(path), "POF")
    if not path.stat().st_size:
        raise InputError(error("file.empty", file=str(path), kind="POF"))
    header = read_header(path)
    if header is None:
        raise InputError(error("trajectory.pof_header", file=str(path)))
    return header


def _records(path: Path, most: int | None = None) -> tuple[PofHeader, Array]:
    """Header and records, shape (n, 7) or (n, 8), or the first ``most`` of them.

    Raises
    ------
    InputError
        If the file is not a POF, is cut short, or contains values that are not numbers.
    """
    header = _require_header(path)
    record, size = 8 * header.columns, path.stat().st_size - header.offset
    if size % record:
        raise InputError(
            error(
                "file.partial_record", file=str(path), kind="POF", size=size, record=record,
                rest=size % record,
            )
        )  # fmt: skip
    found = size // record
    if found != header.count:
        raise InputError(
            error("trajectory.pof_count", file=str(path), count=found, expected=header.count)
        )
    if header.count < 2:
        raise InputError(error("trajectory.pof_one_record", file=str(path)))
    count = header.count if most is None else min(most, header.count)
    try:
        numbers = np.fromfile(path, "<f8", count * header.columns, offset=header.offset)
    except (OSError, ValueError, MemoryError) as failure:
        raise InputError(
            error("file.not_readable", file=str(path), reason=failure_reason(failure))
        ) from failure
    records = numbers.astype(np.float64, copy=False).reshape(-1, header.columns)
    require_numbers(records, path, "POF")
    return header, records


def _time_key(header: PofHeader, time: Array) -> str:
    """Key of the time base in the header, or else of the first that is possible."""
    if header.time:
        return header.time
    possible = plausible_bases(time)
    return possible[0].key if possible else TIME_OPTION.default


def _trajectory(path: Path, header: PofHeader, records: Array, choice: Choice) -> Trajectory:
    time, starts = unroll_times(records[:, 0])
    key = choice.get("time", _time_key(header, records[:, 0]))
    require_increasing(time, path, "POF")
    require_time_base(path, time, base_of_key(key))
    longitude, latitude = np.radians(records[:, 1:3]).T
    bad = (np.abs(latitude) > np.pi / 2) | (np.abs(longitude) > 2 * np.pi)
    if bad.any():
        k = int(np.argmax(bad))
        raise InputError(
            error(
                "trajectory.pof_not_on_earth", file=str(path), record=k + 1,
                latitude=float(latitude[k]), longitude=float(longitude[k]),
            )
        )  # fmt: skip
    height = records[:, 3]
    require_heights(path, height)
    roll, pitch, heading = np.radians(records[:, 4:7]).T
    require_attitude(path, time, (roll, pitch, heading))
    signs = {
        "roll": choice.get("roll", ROLL_OPTION.default),
        "pitch": choice.get("pitch", PITCH_OPTION.default),
    }
    attitude = np.stack(
        [
            -roll if signs["roll"] == "port-down" else roll,
            -pitch if signs["pitch"] == "bow-up" else pitch,
            heading,
        ],
        axis=1,
    )
    assumptions = (
        note("assumed.pof"),
        note("assumed.time_base", base=base_message(base_of_key(key))),
        *map(sign_note, signs.values()),
        note("assumed.heading_true"),
        note("assumed.ellipsoidal_heights"),
    )
    if starts:
        assumptions += (note("assumed.time_rollover", count=starts),)
    return Trajectory(time, latitude, longitude, height, attitude, assumptions)


POF_FORMAT = trajectory_format(
    note("format.pof"),
    "pof",
    "trajectory",
    (".pof",),
    (PITCH_OPTION, ROLL_OPTION, TIME_OPTION),
    sniff_pof,
    preview_pof,
    read_pof,
    has_time_base=True,  # the header gives it
)
