"""Options and checks shared by all readers of points."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import wraps
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import Cancelled, InputError, LispacError, system_reason
from lispac.io.files import file_kind_message, require_file
from lispac.io.format_types import (
    IMPOSSIBLE,
    SAME_TIME_BASE_NOTE,
    Choice,
    Fact,
    FormatOption,
    PointChunk,
)
from lispac.io.units import LENGTH_UNIT_NAMES
from lispac.language import N_
from lispac.messages import Action, Message, error, note, warning
from lispac.survey.crs import METRES_PER_UNIT, CoordinateSystem, coordinate_system
from lispac.survey.known_time_base import base_message
from lispac.survey.line_source import TIME_ROLLOVER_OPTION
from lispac.survey.point_screening import MAX_COORDINATE, MAX_TIME_S
from lispac.survey.time_base import TIME_BASE_KEYS, base_of_key, plausible_bases
from lispac.survey.time_rollover import ROLLOVER_KEYS

Array = NDArray[np.float64]

POINTS_PER_CHUNK = 1_000_000
PREVIEW_POINTS = 10_000
"""Number of points that are read for a preview."""
PREVIEW_ROWS = 10
"""Number of points shown in a preview."""
HEAD_BYTES = 65_536
"""Bytes at the beginning of a file that are read to detect its format."""

SCANNER_FRAME, GEOREFERENCED_FRAME = "scanner", "georeferenced"
FRAME_OPTION = FormatOption(
    "frame", N_("Frame of the coordinates: that of the scanner, or the map."),
    (SCANNER_FRAME, GEOREFERENCED_FRAME), SCANNER_FRAME,
)  # fmt: skip
SCANNER_UNITS = METRES_PER_UNIT | {
    "millimetre": 1e-3, "centimetre": 1e-2, "kilometre": 1e3, "inch": 0.3048 / 12,
    "yard": 3 * 0.3048, "fathom": 6 * 0.3048,
}  # fmt: skip
UNIT_OPTION = FormatOption(
    "unit", N_("Unit of coordinates in the scanner frame."), tuple(SCANNER_UNITS), "metre"
)
CRS_OPTION = FormatOption(
    "crs", N_("Coordinate system of georeferenced points: EPSG code, such as EPSG:32619, or WKT.")
)
HEIGHT_OPTION = FormatOption(
    "height",
    N_(
        "Vertical reference: ellipsoid, EPSG code of a vertical system, path of a geoid grid, or "
        "metres to be added, with their sign. Empty: as in the coordinate system."
    ),
)
HEIGHT_UNIT_OPTION = FormatOption(
    "height_unit",
    N_("Unit of heights. Empty: as in the coordinate system."),
    ("", *METRES_PER_UNIT),
)
DATUM_OPTION = FormatOption(
    "trajectory_datum",
    N_("Geographic system of the trajectory, such as EPSG:7912. Empty: that of the points."),
)
EPOCH_OPTION = FormatOption(
    "epoch", N_("Date of the survey as a decimal year, where the datums move against each other.")
)
TIME_BASE_OPTION = FormatOption(
    "time_base", N_("Time base. Empty: as in the file."), ("", *TIME_BASE_KEYS)
)
ROLLOVER_OPTION = FormatOption(
    TIME_ROLLOVER_OPTION, N_("Moment of the time rollover. Empty: detected from the times."),
    ("", *ROLLOVER_KEYS),
)  # fmt: skip
WITHHELD_OPTION = FormatOption(
    "withheld", N_("Points with the withheld flag: exclude or use them."), ("exclude", "keep"),
    "exclude",
)  # fmt: skip
EXCLUDE_CLASSES_OPTION = FormatOption(
    "exclude_classes", N_("Classes of points to exclude, such as 7 18 for noise. Empty: none.")
)
ONLY_OPTION = FormatOption(
    "only",
    N_(
        "Use only points with these attributes, such as scanner_channel=0 or time=1200:1260. "
        "Empty: all points."
    ),
)
MAX_RANGE_OPTION = FormatOption(
    "max_range", N_("Largest range of the scanner in metres. Empty: 10000.")
)
COMMON_OPTIONS = (
    FRAME_OPTION, UNIT_OPTION, CRS_OPTION, HEIGHT_OPTION, HEIGHT_UNIT_OPTION, DATUM_OPTION,
    EPOCH_OPTION, TIME_BASE_OPTION, ROLLOVER_OPTION, WITHHELD_OPTION, EXCLUDE_CLASSES_OPTION,
    ONLY_OPTION, MAX_RANGE_OPTION,
)  # fmt: skip
"""Options of every reader: frame and coordinate system, time base, and selection of points."""

SECONDS_PER_UNIT = {
    "second": 1.0, "millisecond": 1e-3, "microsecond": 1e-6, "nanosecond": 1e-9,
    "minute": 60.0, "hour": 3600.0,
}  # fmt: skip
TIME_FIELD_OPTION = FormatOption(
    "time_field", N_("Name of the field with the time. Empty: one of the usual names.")
)
TIME_UNIT_OPTION = FormatOption(
    "time_unit", N_("Unit of the time."), tuple(SECONDS_PER_UNIT), "second"
)
TIME_FIELD_NAMES = (
    "time", "gps_time", "gpstime", "timestamp", "time_stamp", "t", "scalar_gpstime",
    "scalar_gps_time", "scalar_time", "scalar_timestamp",
)  # fmt: skip
"""Names of the field with the time, lower case, in order of precedence."""

COARSEST_TIME_RESOLUTION_S = 1e-3
"""Coarsest accepted time resolution, seconds: a vessel that turns at 10 deg/s turns by 0.01 deg."""
CHOOSE_SYSTEM_ACTION = Action("choose_system", {"name": CRS_OPTION.name})
CHOOSE_FRAME_ACTION = Action("choose_frame", {"name": FRAME_OPTION.name})
CHOOSE_TIME_BASE_ACTION = Action("choose_time_base", {"name": TIME_BASE_OPTION.name})
USE_FEET_ACTIONS = (
    Action("use_feet", {"name": UNIT_OPTION.name, "value": "foot"}),
    Action("use_us_survey_feet", {"name": UNIT_OPTION.name, "value": "us-survey-foot"}),
)
SCANNER_COLUMN_ASSUMPTIONS = (
    note("assumed.scanner_coordinates"), note("assumed.other_columns_kept"), SAME_TIME_BASE_NOTE,
)  # fmt: skip
"""Assumptions about files with coordinates in several frames, of which the scanner's are read."""
NO_SYSTEM_CODE = "points.no_system"
"""Code of the warning that a file does not specify a coordinate system."""


def crs_of_options(choice: Choice, path: Path | None = None) -> CoordinateSystem | None:
    """Coordinate system of complete options; None for points in the scanner frame.

    Parameters
    ----------
    path : Path, optional
        File that the options belong to, for messages.

    Raises
    ------
    InputError
        If the system is not known or the options contradict each other.
    """
    if choice[FRAME_OPTION.name] == SCANNER_FRAME:
        return None
    epoch = str(choice[EPOCH_OPTION.name]).strip()
    try:
        year = float(epoch) if epoch else None
    except ValueError:
        raise InputError(error("file.epoch", epoch=epoch)) from None
    try:
        return coordinate_system(
            choice[CRS_OPTION.name],
            height=choice[HEIGHT_OPTION.name],
            height_unit=choice[HEIGHT_UNIT_OPTION.name],
            trajectory_datum=choice[DATUM_OPTION.name],
            epoch=year,
        )
    except InputError as failure:
        if path is None:
            raise
        raise InputError(
            error("file.coordinate_system", file=str(path), reason=failure.reason)
        ) from failure


def coordinate_scale(choice: Choice) -> float:
    """Factor from coordinates in the scanner frame to metres; 1 for other frames."""
    return (
        SCANNER_UNITS[choice[UNIT_OPTION.name]]
        if choice[FRAME_OPTION.name] == SCANNER_FRAME
        else 1.0
    )


def frame_facts(choice: Choice) -> dict[str, Fact]:
    """Facts about frame and unit for the preview, from complete options."""
    if choice[FRAME_OPTION.name] == SCANNER_FRAME:
        metres = SCANNER_UNITS[choice[UNIT_OPTION.name]]
        unit = LENGTH_UNIT_NAMES[metres]
        return {
            "frame": note("fact.scanner_frame"),
            "unit": unit if metres == 1.0 else note("fact.converted_unit", unit=unit),
        }
    return {"frame": note("fact.georeferenced"), "unit": note("fact.unit_of_system")}


@contextmanager
def report_damage(path: Path, what: str) -> Iterator[None]:
    """Convert errors of a library on a damaged file into one InputError.

    All exceptions are caught, because libraries raise errors of any type on damaged bytes. Only
    calls of libraries and decoders should be inside this context.

    Raises
    ------
    InputError
        If a library fails on the file.
    """  # noqa: DOC501 - what passes through is not its own
    try:
        yield
    except (LispacError, Cancelled):
        raise
    except OSError as failure:
        if failure.errno is None:  # raised by gzip for damaged data
            raise damaged_file_error(path, what, failure) from failure
        reason = system_reason(failure)
        raise InputError(error("file.not_readable", file=str(path), reason=reason)) from failure
    except Exception as failure:
        raise damaged_file_error(path, what, failure) from failure


def damaged_file_error(path: Path, what: str, failure: Exception) -> InputError:
    """Make the error of a file that a decoder cannot read; ``what`` names its format."""
    reason = " ".join(str(failure).split())[:120] or type(failure).__name__
    return InputError(
        error("file.damaged", file=str(path), kind=file_kind_message(what), reason=reason)
    )


def head_sniffer(likelihood_of_head: Callable[[bytes, Path], float]) -> Callable[[Path], float]:
    """Decorator that applies a detection to the first bytes of a file and raises no error."""

    @wraps(likelihood_of_head)
    def sniff(path: Path) -> float:
        try:
            if not Path(path).is_file():
                return IMPOSSIBLE
            with Path(path).open("rb") as file:
                return likelihood_of_head(file.read(HEAD_BYTES), Path(path))
        except Exception:  # a file of another format may cause any error in a parser
            return IMPOSSIBLE

    return sniff


def require_not_empty(path: Path, what: str) -> Path:
    """Return the path if it is a readable file that is not empty.

    Raises
    ------
    InputError
        If the file is missing, unreadable or empty.
    """
    path = require_file(Path(path), what)
    if path.stat().st_size == 0:
        raise InputError(error("file.empty", file=str(path), kind=file_kind_message(what)))
    return path


def find_time_field(path: Path, names: Sequence[str], requested: str) -> str:
    """Name of the field that holds the time.

    Raises
    ------
    InputError
        If there is none.
    """
    if requested:
        if requested in names:
            return requested
        raise InputError(
            error("file.no_such_field", file=str(path), field=requested, fields=tuple(names))
        )
    for usual in TIME_FIELD_NAMES:
        for name in names:
            if name.lower() == usual:
                return name
    raise InputError(error("file.no_time", file=str(path), fields=tuple(names)))


MAX_UNUSABLE_SHARE = 0.25
"""Share of values that are not usable numbers above which a file is refused."""
MAX_UNDECIDED_POINTS = 10
"""Largest number of points that is too small to determine the byte order."""


def require_usable_points(xyz: Array, time: NDArray[Any], path: Path, first: int = 0) -> None:
    """Refuse points with many values that are not usable numbers, and times that are too coarse.

    Single points with such values are excluded later, by `lispac.survey.point_screening`.

    Parameters
    ----------
    xyz : ndarray of shape (n, 3), frame and unit of the file
    time : ndarray of shape (n,), seconds
        With the type in the file, from which the resolution follows.
    first : int
        Number of points of the file before these.

    Raises
    ------
    InputError
        If more than `MAX_UNUSABLE_SHARE` of the points are not usable, or the times are too coarse.
    """
    if not (_are_within_limit(xyz, MAX_COORDINATE) and _are_within_limit(time, MAX_TIME_S)):
        good = usable_mask(xyz, time)
        bad = int((~good).sum())
        if bad > MAX_UNUSABLE_SHARE * len(good):
            point, file = first + int(np.argmin(good)) + 1, str(path)
            if len(good) > MAX_UNDECIDED_POINTS:
                raise InputError(error("file.points_byte_order", file=file, point=point, count=bad))
            raise InputError(error("file.points_not_usable", file=file, point=point, count=bad))
        time = time[good]
    step = time_resolution(time)
    if step > COARSEST_TIME_RESOLUTION_S:
        largest = float(np.max(np.abs(time)))
        raise InputError(error("file.time_32_bits", file=str(path), time=largest, step=step))


def require_distinct_times(start: float, end: float, count: int, path: Path) -> None:
    """Refuse a line whose points all have the same time, if it has many points.

    Parameters
    ----------
    start, end : float, seconds
        Earliest and latest time of the points.
    count : int
        Number of points of the line.

    Raises
    ------
    InputError
        If at least `MIN_EQUAL_TIMES` points all have the same time.
    """
    if count >= MIN_EQUAL_TIMES and start == end:
        raise InputError(error("file.one_time", file=str(path), count=count, time=start))


MIN_EQUAL_TIMES = 1000
"""Number of points with the same time from which a file is considered to be without times."""


def usable_mask(xyz: Array, time: NDArray[Any]) -> NDArray[np.bool_]:
    """Mask of the points with usable coordinates and times, shape (n,).

    Parameters
    ----------
    xyz : ndarray of shape (n, 3), frame and unit of the file
    time : ndarray of shape (n,), seconds
    """
    return np.asarray(
        (np.abs(xyz) <= MAX_COORDINATE).all(axis=1) & (np.abs(time) <= MAX_TIME_S), dtype=bool
    )


def usable_points(chunk: PointChunk) -> PointChunk:
    """Select the points of a chunk whose coordinates and times are usable numbers."""
    good = usable_mask(chunk.xyz, chunk.time)
    if good.all():
        return chunk
    extra = {name: values[good] for name, values in chunk.extra.items()}
    return replace(chunk, xyz=chunk.xyz[good], time=chunk.time[good], extra=extra)


def _are_within_limit(values: NDArray[Any], limit: float) -> bool:
    """True if all values are numbers with magnitudes up to ``limit``."""
    return not len(values) or bool(values.min() >= -limit and values.max() <= limit)


def time_resolution(time: NDArray[Any], seconds: float = 1.0) -> float:
    """Resolution of ``time`` (n,) stored as float32, seconds; zero for other types."""
    finite = time[np.isfinite(time)] if time.dtype == np.float32 else time[:0]
    if not len(finite):
        return 0.0
    return float(np.spacing(np.float32(np.max(np.abs(finite))))) * seconds


def time_base_message(time: NDArray[np.float64], base_key: str) -> Message:
    """Message about the base of ``time`` (n,), seconds: the given base, or those that fit."""
    if base_key:
        return note("fact.time_base_specified", base=base_message(base_of_key(base_key)))
    fitting = tuple(map(base_message, plausible_bases(time)))
    return note("fact.time_bases_fitting", bases=fitting) if fitting else note("fact.not_specified")


def time_base_warnings(time: NDArray[np.float64], base_key: str, file: str) -> tuple[Message, ...]:
    """Warning that ``time`` (n,), seconds, contradicts the base specified in ``file``."""
    if not base_key or not len(time):
        return ()
    possible = plausible_bases(time)
    if base_key in {each.key for each in possible}:
        return ()
    fitting = tuple(base_message(each) for each in possible)
    base, first, actions = (
        base_message(base_of_key(base_key)),
        float(time[0]),
        (CHOOSE_TIME_BASE_ACTION,),
    )
    if not fitting:
        return (
            warning("times.base_impossible", file=file, base=base, time=first, actions=actions),
        )
    return (
        warning(
            "times.base_contradicted", file=file, base=base, time=first, bases=fitting,
            actions=actions,
        ),
    )  # fmt: skip


def preview_table(
    names: Sequence[str], columns: Sequence[NDArray[Any]]
) -> tuple[tuple[str, ...], ...]:
    """Table of the first rows as text, with the column names in the first row."""
    rows = zip(*(column[:PREVIEW_ROWS].tolist() for column in columns), strict=True)
    return (tuple(names), *(tuple(_value_text(value) for value in row) for row in rows))


def _value_text(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6f}".rstrip("0").rstrip(".") if abs(value) >= 1e-3 else f"{value:g}"
    return str(value)
