"""Formats of trajectories and of their accuracies, for the list in `lispac.io.formats`."""

from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.files import file_kind_message, require_file
from lispac.io.format_types import (
    IMPOSSIBLE,
    LIKELY,
    POSSIBLE,
    SURE,
    Choice,
    Fact,
    FileFormat,
    FilePreview,
    FormatOption,
    Kind,
)
from lispac.io.text.text_table import SEPARATOR_NAMES
from lispac.io.trajectory.ascii_trajectory import (
    ATTITUDE_CHOICES,
    DEFAULT_OPTIONS,
    LENGTH_CHOICES,
    POSITION_CHOICES,
    preview_ascii,
    read_ascii,
    sniff_ascii,
)
from lispac.io.trajectory.cidco_states import (
    ORIGIN_OPTION,
    preview_sigmas,
    preview_states,
    read_sigmas,
    read_states,
    sniff_states,
)
from lispac.io.trajectory.exail import (
    preview_exail,
    preview_exail_accuracy,
    read_exail,
    read_exail_accuracy,
    sniff_exail,
    sniff_exail_accuracy,
)
from lispac.io.trajectory.pospac_text import (
    preview_pospac,
    preview_pospac_accuracy,
    read_pospac,
    read_pospac_accuracy,
    sniff_pospac,
    sniff_pospac_accuracy,
)
from lispac.io.trajectory.sbet import (
    SMRMSG_RECORD_BYTES,
    VELOCITY_AXES,
    SbetOptions,
    is_smrmsg,
    read_sbet,
    read_smrmsg,
)
from lispac.io.trajectory.sbet_detection import (
    RECORD_BYTES,
    detect_byte_order,
    detect_sbet,
    sbet_fit_at_end,
)
from lispac.io.trajectory.trajectory_preview import accuracy_facts, refusal_warning
from lispac.language import N_
from lispac.messages import Message, note, warning
from lispac.survey.line_source import printable
from lispac.survey.time_base import TIME_BASE_KEYS
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

SBET_COLUMNS = (
    N_("time"),
    N_("latitude"),
    N_("longitude"),
    N_("height"),
    N_("velocity x"),
    N_("velocity y"),
    N_("velocity z"),
    N_("roll"),
    N_("pitch"),
    N_("heading"),
    N_("wander"),
    N_("acceleration x"),
    N_("acceleration y"),
    N_("acceleration z"),
    N_("rate x"),
    N_("rate y"),
    N_("rate z"),
)
SMRMSG_COLUMNS = (
    N_("time"),
    N_("north"),
    N_("east"),
    N_("down"),
    N_("velocity north"),
    N_("velocity east"),
    N_("velocity down"),
    N_("roll"),
    N_("pitch"),
    N_("heading"),
)

PITCH_OPTION = FormatOption(
    "pitch", N_("Direction of the bow for positive pitch."), ("bow-up", "bow-down"), "bow-up"
)
ROLL_OPTION = FormatOption(
    "roll",
    N_("Side that is down for positive roll. Starboard down is port up."),
    ("starboard-down", "port-down"),
    "starboard-down",
)
TIME_OPTION = FormatOption("time", N_("Time base."), TIME_BASE_KEYS, "gps-week")


def _sniff_sbet(path: Path) -> float:
    try:
        size = Path(path).stat().st_size
    except OSError:
        return IMPOSSIBLE
    if size < 2 * RECORD_BYTES:
        return IMPOSSIBLE
    byte_order, fit = detect_byte_order(path)
    end = sbet_fit_at_end(path, byte_order)
    if fit == 1:
        # A truncated or padded file is still an SBET; its reader reports the error.
        whole = size % RECORD_BYTES == 0 and byte_order == "little-endian" and end == 1
        return SURE if whole else LIKELY
    return POSSIBLE if min(fit, end) > 0 else IMPOSSIBLE


def _preview_sbet(path: Path, choice: Choice) -> FilePreview:
    found = detect_sbet(path)
    rows = tuple(tuple(f"{value:.10g}" for value in row) for row in found.head)
    options = asdict(found.options) | dict(choice)
    assumptions = SbetOptions(**options).assumptions()
    return FilePreview(
        found.facts, (SBET_COLUMNS, *rows), options, found.file_warnings, assumptions
    )


def _read_sbet(path: Path, choice: Choice) -> Trajectory:
    return read_sbet(path, SbetOptions(**SBET_FORMAT.complete_options(choice)))


def _first_smrmsg_records(path: Path) -> NDArray[np.float64]:
    try:
        with Path(path).open("rb") as file:
            data = file.read(1000 * SMRMSG_RECORD_BYTES)
    except OSError:
        return np.zeros((0, 10))
    whole = len(data) // SMRMSG_RECORD_BYTES * SMRMSG_RECORD_BYTES
    return np.frombuffer(data[:whole], dtype="<f8").reshape(-1, 10)


def _sniff_smrmsg(path: Path) -> float:
    head = _first_smrmsg_records(path)
    if not is_smrmsg(head):
        # In the other byte order it is still an smrmsg; its reader reports the error.
        return LIKELY if is_smrmsg(head.byteswap()) else IMPOSSIBLE
    return SURE if Path(path).stat().st_size % SMRMSG_RECORD_BYTES == 0 else LIKELY


def _preview_smrmsg(path: Path, choice: Choice) -> FilePreview:
    size = require_file(Path(path), "smrmsg").stat().st_size
    head = _first_smrmsg_records(path)
    rows = tuple(tuple(f"{value:.6g}" for value in row) for row in head[:5])
    file_warnings: list[Message] = []
    file, kind = printable(path.name), file_kind_message("smrmsg")
    if not size:
        file_warnings.append(warning("file.empty", file=file, kind=kind))
    elif rest := size % SMRMSG_RECORD_BYTES:
        file_warnings.append(
            warning(
                "file.partial_record", file=file, kind=kind, size=size, record=SMRMSG_RECORD_BYTES,
                rest=rest,
            )
        )  # fmt: skip
    facts: dict[str, Fact] = {"Records": size // SMRMSG_RECORD_BYTES}
    if len(head) and not file_warnings:
        try:
            found, warnings = accuracy_facts(read_smrmsg(path), file)
            facts |= found
            file_warnings += warnings
        except InputError as refused:
            file_warnings.append(refusal_warning(refused, path))
    return FilePreview(facts, (SMRMSG_COLUMNS, *rows), dict(choice), tuple(file_warnings))


def _read_smrmsg(path: Path, choice: Choice) -> TrajectoryAccuracy:
    return read_smrmsg(path)


def _make_format(
    name: Message,
    key: str,
    kind: Kind,
    endings: tuple[str, ...],
    options: tuple[FormatOption, ...],
    sniff: Callable[[Path], float],
    preview: Callable[[Path, Choice], FilePreview],
    read: Callable[[Path, Choice], Trajectory | TrajectoryAccuracy],
    *,
    has_time_base: bool = False,
) -> FileFormat:
    """Make a format that refuses unknown options before it examines or reads a file."""

    def preview_checked(path: Path, choice: Choice) -> FilePreview:
        """Make the preview of a file after a check of the options."""
        made.complete_options(choice)
        return preview(Path(path), choice)

    def read_checked(path: Path, choice: Choice) -> Trajectory | TrajectoryAccuracy:
        made.complete_options(choice)
        return read(Path(path), choice)

    made = FileFormat(
        name, key, kind, endings, options, sniff, preview_checked, read_checked,
        has_time_base=has_time_base,
    )  # fmt: skip
    return made


SBET_FORMAT = _make_format(
    note("format.sbet"),
    "sbet",
    "trajectory",
    (".out", ".sbet"),
    (
        FormatOption(
            "heading",
            N_("Whether the wander angle is subtracted from the platform heading."),
            ("minus-wander", "as-is"),
            "minus-wander",
        ),
        PITCH_OPTION,
        ROLL_OPTION,
        FormatOption(
            "axes",
            N_("Axes of the velocities. They are used to check the heading."),
            ("unknown", *VELOCITY_AXES),
            "unknown",
        ),
        TIME_OPTION,
        FormatOption("unit", N_("Unit of all angles."), ("radians", "degrees"), "radians"),
        FormatOption(
            "order",
            N_("Order of latitude and longitude."),
            ("latitude-longitude", "longitude-latitude"),
            "latitude-longitude",
        ),
        FormatOption(
            "byte_order", N_("Byte order."), ("little-endian", "big-endian"), "little-endian"
        ),
    ),
    _sniff_sbet,
    _preview_sbet,
    _read_sbet,
)

GRID_SYSTEM_OPTION = FormatOption(
    "crs",
    N_("Coordinate system of eastings and northings where there is no latitude (EPSG:...)."),
)
EXAIL_OPTIONS = (
    FormatOption(PITCH_OPTION.name, PITCH_OPTION.meaning, PITCH_OPTION.choices, "bow-down"),
    ROLL_OPTION,
    FormatOption(TIME_OPTION.name, TIME_OPTION.meaning, TIME_OPTION.choices, "unix"),
    GRID_SYSTEM_OPTION,
)
EXAIL_FORMAT = _make_format(
    note("format.exail"),
    "exail-text",
    "trajectory",
    (".txt", ".csv"),
    EXAIL_OPTIONS,
    sniff_exail,
    preview_exail,
    read_exail,
    has_time_base=True,  # the exports contain dates, or are in UTC
)

POSPAC_OPTIONS = (TIME_OPTION, GRID_SYSTEM_OPTION)
POSPAC_FORMAT = _make_format(
    note("format.pospac"),
    "pospac-text",
    "trajectory",
    (".txt", ".csv"),
    POSPAC_OPTIONS,
    sniff_pospac,
    preview_pospac,
    read_pospac,
)

ASCII_FORMAT = _make_format(
    note("format.ascii"),
    "ascii-trajectory",
    "trajectory",
    (".txt", ".csv", ".asc", ".pos", ".dat"),
    (
        FormatOption(
            "columns",
            N_(
                "Columns from the left: time, date, latitude, longitude, easting, northing, "
                "height, roll, pitch, heading; - skips a column."
            ),
            (),
            DEFAULT_OPTIONS["columns"],
        ),
        FormatOption("separator", N_("Separator of the columns."), SEPARATOR_NAMES, "auto"),
        FormatOption(
            "header",
            N_("Rows to skip at the beginning. auto: up to the first row of numbers."),
            (),
            "auto",
        ),
        FormatOption(
            "position",
            N_("Unit of latitude and longitude."),
            POSITION_CHOICES,
            "degrees",
        ),
        FormatOption(
            "attitude", N_("Unit of roll, pitch and heading."), ATTITUDE_CHOICES, "degrees"
        ),
        FormatOption(
            "grid_unit",
            N_(
                "Unit of eastings and northings. Empty: that of the coordinate system; feet are "
                "those of the coordinate system where it is in feet."
            ),
            LENGTH_CHOICES,
        ),
        FormatOption(
            "heights",
            N_(
                "Unit of heights. Empty: that of the coordinate system where it has heights, else "
                "metres."
            ),
            LENGTH_CHOICES,
        ),
        PITCH_OPTION,
        ROLL_OPTION,
        FormatOption(
            "heading", N_("North from which the heading counts."), ("true", "grid"), "true"
        ),
        FormatOption("crs", N_("Coordinate system of eastings and northings, such as EPSG:32619.")),
        TIME_OPTION,
    ),
    sniff_ascii,
    preview_ascii,
    read_ascii,
)

CIDCO_STATES_FORMAT = _make_format(
    note("format.cidco_states"),
    "cidco-states",
    "trajectory",
    (),
    (ORIGIN_OPTION, TIME_OPTION),
    sniff_states,
    preview_states,
    read_states,
)
CIDCO_ACCURACY_FORMAT = _make_format(
    note("format.cidco_sigmas"),
    "cidco-sigmas",
    "accuracy",
    (),
    (),
    sniff_states,
    preview_sigmas,
    read_sigmas,
)

SMRMSG_FORMAT = _make_format(
    note("format.smrmsg"),
    "smrmsg",
    "accuracy",
    (".out", ".smrmsg"),
    (),
    _sniff_smrmsg,
    _preview_smrmsg,
    _read_smrmsg,
)
EXAIL_ACCURACY_FORMAT = _make_format(
    note("format.exail_sigmas"),
    "exail-sigmas",
    "accuracy",
    (".txt", ".csv"),
    EXAIL_OPTIONS,
    sniff_exail_accuracy,
    preview_exail_accuracy,
    read_exail_accuracy,
)
POSPAC_ACCURACY_FORMAT = _make_format(
    note("format.pospac_sigmas"),
    "pospac-sigmas",
    "accuracy",
    (".txt", ".csv"),
    POSPAC_OPTIONS,
    sniff_pospac_accuracy,
    preview_pospac_accuracy,
    read_pospac_accuracy,
)
