"""Formats of SBET and smrmsg files."""

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
    FilePreview,
    FormatOption,
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
from lispac.io.trajectory.trajectory_options import (
    PITCH_OPTION,
    ROLL_OPTION,
    TIME_OPTION,
    trajectory_format,
)
from lispac.io.trajectory.trajectory_preview import accuracy_facts, refusal_warning
from lispac.language import N_
from lispac.messages import Message, note, warning
from lispac.survey.line_source import printable
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


SBET_FORMAT = trajectory_format(
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

SMRMSG_FORMAT = trajectory_format(
    note("format.smrmsg"),
    "smrmsg",
    "accuracy",
    (".out", ".smrmsg"),
    (),
    _sniff_smrmsg,
    _preview_smrmsg,
    _read_smrmsg,
)
