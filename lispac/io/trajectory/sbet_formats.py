"""Formats of SBET and smrmsg files, and detection of the reading options of an SBET.

An SBET has no header. Order of the positions, unit and byte order are detected from the size of the
numbers; frames and signs from the motion (`lispac.io.trajectory.sbet_motion`).
"""

import os
from dataclasses import asdict, dataclass, replace
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
from lispac.io.trajectory.sbet_motion import detect_signs, detect_velocity_frame
from lispac.io.trajectory.trajectory_facts import (
    TrajectoryMotion,
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
from lispac.io.trajectory.trajectory_preview import accuracy_facts, refusal_warning
from lispac.language import N_
from lispac.messages import Message, error, note, warning
from lispac.survey.line_source import printable
from lispac.survey.time_base import plausible_bases, unroll_times
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

Array = NDArray[np.float64]

RECORD_BYTES = 17 * 8
EDGE_RECORDS = 100
NUMPY_BYTE_ORDERS = {"little-endian": "<", "big-endian": ">"}
RECORDS_PER_BLOCK, MAX_BLOCKS = 1000, 60
"""Records of a block (five seconds at 200 Hz), and largest number of blocks read from a file."""


MAX_TIMES = 1_000_000
"""Largest number of times examined for disorder and gaps; of more times, every n-th."""


@dataclass(frozen=True)
class SbetDetection:
    """Detected options of an SBET, facts for the preview, and warnings.

    Attributes
    ----------
    head : ndarray of shape (n, 17)
        First records, as stored.
    """

    options: SbetOptions
    facts: dict[str, Fact]
    file_warnings: tuple[Message, ...]
    head: Array


def sample_blocks(path: Path, byte_order: str = "<") -> tuple[list[Array], int]:
    """Read blocks of consecutive records spread over the file, and count the records.

    Returns
    -------
    list of ndarray of shape (n, 17)
    int
    """
    try:
        whole = Path(path).stat().st_size // RECORD_BYTES
        records = np.memmap(path, dtype=f"{byte_order}f8", mode="r", shape=(whole, 17))
        if whole <= RECORDS_PER_BLOCK * MAX_BLOCKS:
            starts = np.array([0])
            length = whole
        else:
            starts, length = (
                np.linspace(0, whole - RECORDS_PER_BLOCK, MAX_BLOCKS).astype(np.int64),
                RECORDS_PER_BLOCK,
            )
        return [np.array(records[k : k + length], dtype=np.float64) for k in starts], whole
    except (OSError, ValueError):
        return [], 0


def _sample_times(path: Path, byte_order: str, count: int) -> Array:
    """Times of all records, or of every n-th record of a large file."""
    mark = "<" if byte_order == "little-endian" else ">"
    records = np.memmap(path, dtype=f"{mark}f8", mode="r", shape=(count, 17))
    return np.array(records[:: 1 + count // MAX_TIMES, 0], dtype=np.float64)


def sbet_fit(records: Array) -> float:
    """Likelihood that consecutive records of shape (n, 17) are an SBET.

    Returns
    -------
    float
        1 for an SBET in radians; 0.6 for one in degrees, with latitude and longitude exchanged, or
        with some records out of order; else 0.
    """
    if len(records) < 2 or not np.isfinite(records).all():
        return 0.0
    time, steps = records[:, 0], np.diff(records[:, 0])
    size = np.abs(records)
    # Only tiny numbers indicate other data read as float64.
    has_position = bool((size[:, 1:3] > 1e-9).any())
    is_plausible_motion = bool(size[:, 3].max() < 2e4 and size[:, 4:7].max() < 1000)
    if not (plausible_bases(time) and has_position and is_plausible_motion and size.max() < 1e11):
        return 0.0
    if (
        (steps > 0).all()
        and steps.max() < 60
        and (size[:, 1].max() <= np.pi / 2 and size[:, 2].max() <= 2 * np.pi)
        and (size[:, 7:9].max() <= np.pi and size[:, 9:11].max() <= 1000)
    ):
        return 1.0
    ordered = float(np.mean((steps >= 0) & (steps < 60)))
    exchanged = size[:, 1].max() <= 2 * np.pi and size[:, 2].max() <= np.pi / 2
    are_positions = exchanged or (size[:, 1].max() <= 90 and size[:, 2].max() <= 360)
    are_angles = size[:, 7:9].max() <= 180 and size[:, 9:11].max() <= 1000
    return 0.6 if ordered >= 0.8 and are_positions and are_angles else 0.0


def detect_byte_order(path: Path) -> tuple[str, float]:
    """Byte order in which the first records fit an SBET better, and the likelihood."""
    scores = {name: sbet_fit(_edge_records(path, mark)) for name, mark in NUMPY_BYTE_ORDERS.items()}
    best = max(scores, key=lambda name: scores[name])
    return best, scores[best]


def sbet_fit_at_end(path: Path, byte_order: str) -> float:
    """Likelihood that the last complete records are an SBET."""
    return sbet_fit(_edge_records(path, NUMPY_BYTE_ORDERS[byte_order], last=True))


def _edge_records(path: Path, mark: str, *, last: bool = False) -> Array:
    """Read the first or the last hundred records; none if the file cannot be read."""
    try:
        with Path(path).open("rb") as file:
            if last:
                whole = file.seek(0, os.SEEK_END) // RECORD_BYTES
                file.seek(max(0, whole - EDGE_RECORDS) * RECORD_BYTES)
            content = file.read(EDGE_RECORDS * RECORD_BYTES)
    except OSError:
        return np.zeros((0, 17))
    content = content[: len(content) // RECORD_BYTES * RECORD_BYTES]
    return np.frombuffer(content, dtype=f"{mark}f8").reshape(-1, 17)


def detect_sbet(path: Path) -> SbetDetection:
    """Examine an SBET and detect its options.

    Raises
    ------
    InputError
        If the file is missing, empty or shorter than two records.
    """
    path = require_file(Path(path), "SBET")
    size = path.stat().st_size
    if not size:
        raise InputError(error("text.empty", file=str(path)))
    if size < 2 * RECORD_BYTES:
        raise InputError(error("sbet.too_short", file=str(path), bytes=size))
    file_warnings: list[Message] = []
    file = printable(path.name)
    byte_order, _ = detect_byte_order(path)
    options = SbetOptions(byte_order=byte_order)
    if byte_order == "big-endian":
        file_warnings.append(warning("sbet.big_endian", file=file))
    blocks, count = sample_blocks(path, "<" if byte_order == "little-endian" else ">")
    if not blocks:
        raise InputError(error("sbet.not_readable", file=str(path)))
    head = blocks[0][:5]
    if size % RECORD_BYTES:
        file_warnings.append(
            warning(
                "file.partial_record", file=file, kind=file_kind_message("SBET"), size=size,
                record=RECORD_BYTES, rest=size % RECORD_BYTES,
            )
        )  # fmt: skip
    facts: dict[str, Fact] = {"Records": count}
    sound = [block[np.isfinite(block).all(axis=1)] for block in blocks]
    lost = sum(len(block) for block in blocks) - sum(len(block) for block in sound)
    if lost:
        file_warnings.append(warning("sbet.not_finite", file=file, count=lost))
    usable = [block for block in sound if len(block) > 2]
    if not usable or max(float(np.abs(block).max()) for block in usable) > 1e11:
        file_warnings.append(warning("sbet.other_format", file=file))
        return SbetDetection(options, facts, tuple(file_warnings), head)
    time = _sample_times(path, options.byte_order, count)
    if not np.isfinite(time).all():
        time = np.concatenate([block[:, 0] for block in usable])
    return _detect_from_blocks(usable, options, facts, file_warnings, head, time, file)


def _detect_from_blocks(
    blocks: list[Array],
    options: SbetOptions,
    facts: dict[str, Fact],
    file_warnings: list[Message],
    head: Array,
    time: Array,
    file: str,
) -> SbetDetection:
    """Detect the options from blocks of finite records and a sample of the times."""
    table = np.vstack(blocks)
    options, found = _detect_unit_and_order(table, options, file)
    file_warnings += found
    if options.unit == "degrees":
        blocks = [_block_in_radians(block) for block in blocks]
    motions = [_block_motions(block) for block in blocks]
    options, facts["Velocities"], found = detect_velocity_frame(blocks, motions, options, file)
    file_warnings += found
    if options.order == "longitude-latitude":
        blocks = [block[:, [0, 2, 1, *range(3, 17)]] for block in blocks]
        motions = [(exchanged, own) for own, exchanged in motions]
    options, facts["Roll and pitch"], found = detect_signs(blocks, options, file)
    file_warnings += found
    bases = plausible_bases(table[:, 0])
    if bases:
        options = replace(options, time=bases[0].key)
    table = np.vstack(blocks)
    latitude, longitude, height = table[:, 1:4].T
    speed = np.concatenate([own.speed for own, _ in motions])
    facts.update(trajectory_facts(unroll_times(time)[0], latitude, longitude, height, speed))
    wander = table[:, 10]
    facts["Wander angle"] = note("fact.angles", low=wander.min(), high=wander.max())
    file_warnings += time_warnings(unroll_times(time)[0], options.time, file)
    if options.order == "latitude-longitude":
        headings = [
            block[:, 9] - (block[:, 10] if options.heading == "minus-wander" else 0)
            for block in blocks
        ]
        file_warnings += course_warnings(motions, headings, file)
    return SbetDetection(options, facts, tuple(file_warnings), head)


def _detect_unit_and_order(
    table: Array, options: SbetOptions, file: str
) -> tuple[SbetOptions, list[Message]]:
    """Detect degrees, and latitude and longitude exchanged if a latitude is out of range."""
    first, second = (float(np.abs(table[:, k]).max()) for k in (1, 2))
    if max(first, second) > 2 * np.pi:
        if max(first, second) > 360:
            return options, [warning("sbet.not_angles", file=file, largest=max(first, second))]
        found = [warning("sbet.degrees_assumed", file=file)]
        if np.abs(table[:, 9]).max() <= 2 * np.pi:
            found.append(warning("sbet.heading_in_radians", file=file))
        return replace(options, unit="degrees"), found
    if first > np.pi / 2 and second <= np.pi / 2:
        return replace(options, order="longitude-latitude"), [
            warning("sbet.longitude_first", file=file)
        ]
    return options, []


def _block_in_radians(block: Array) -> Array:
    block = block.copy()
    block[:, [1, 2, 7, 8, 9, 10]] = np.radians(block[:, [1, 2, 7, 8, 9, 10]])
    return block


def _block_motions(block: Array) -> tuple[TrajectoryMotion, TrajectoryMotion]:
    """Velocities from positions, as stored and with latitude and longitude exchanged."""
    time, first, second, height = block[:, :4].T
    return motion_of(time, first, second, height), motion_of(time, second, first, height)


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
    has_messages=False,
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
    has_messages=False,
)
