"""Reading of the files of a survey in their formats, and checks of a file before its use."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.io.files import message_with_file_name, require_file
from lispac.io.format_types import LIKELY, Choice, FileFormat, FilePreview, Kind
from lispac.io.formats import (
    ACCURACY_FORMATS,
    POINT_FORMATS,
    TRAJECTORY_FORMATS,
    format_of,
    is_las,
    recognise_formats,
)
from lispac.io.las.las_format import SCANNER_FRAME_ASSUMPTIONS as LAS_ASSUMPTIONS
from lispac.io.point_reader_common import (
    CHOOSE_FRAME_ACTION,
    NO_SYSTEM_CODE,
    SCANNER_FRAME,
    crs_of_options,
    require_not_empty,
)
from lispac.io.points.static_scan import has_no_time
from lispac.io.trajectory.sbet import read_sbet, read_smrmsg
from lispac.message_texts import message_text
from lispac.messages import Message, error, note, warning
from lispac.present.survey.input_file import FormatCheckValues, content_texts
from lispac.project import LineSource, Project, Reading
from lispac.survey.line_source import printable
from lispac.survey.trajectory import LocalTrajectory, Trajectory, TrajectoryAccuracy

MAX_ORIGIN_DISTANCE = 100_000.0
"""Largest distance of the first position of the trajectory from the origin of the local frame,
metres; a frame tangent to the ellipsoid at a more distant origin is not suitable."""
KIND_NAMES: Mapping[Kind, str] = {
    "trajectory": "trajectory", "accuracy": "trajectory accuracy", "points": "line",
}  # fmt: skip
"""Word for each kind of file in `lispac.io.files.require_file`."""
_WRONG_KIND_CODES: Mapping[Kind, str] = {
    "trajectory": "import.not_trajectory_format",
    "accuracy": "import.not_accuracy_format",
    "points": "import.not_line_format",
}
"""Code of the error that a format is not one of the required kind, by that kind."""
_UNKNOWN_FORMAT_CODES: Mapping[Kind, str] = {
    "trajectory": "import.unknown_trajectory_format",
    "accuracy": "import.unknown_accuracy_format",
    "points": "import.unknown_line_format",
}
"""Code of the error that a file has no known format of the required kind, by that kind."""

NOT_OF_ITS_FORMAT_CODE = "import.not_of_its_format"
"""Code of the error that a file is not of the format that its name announces."""


@dataclass(frozen=True)
class FileCheck:
    """Result of the check of a file in one format that it may have.

    Attributes
    ----------
    format : FileFormat
    confidence : float, 0 to 1
    finding : FilePreview or None
    error : Message or None
        Reason why it cannot be read in this format, if there is no preview.
    """

    format: FileFormat
    confidence: float
    finding: FilePreview | None
    error: Message | None = None

    @property
    def values(self) -> FormatCheckValues:
        """Values for JSON, with texts in the language in use."""
        found = self.finding or FilePreview({})
        options = {} if self.finding is None else self.format.complete_options(found.choice)
        return FormatCheckValues(
            self.format.key, message_text(self.format.name), self.format.kind, self.confidence,
            self.error, content_texts(found.facts), options, found.assumptions,
            (*found.file_warnings, *found.messages),
        )  # fmt: skip


def check_file(
    path: Path, kinds: tuple[Kind, ...] = ("trajectory", "accuracy", "points")
) -> list[FileCheck]:
    """Check a file in each format that it may have, the most likely first.

    At equal likelihood, formats with the extension of the file come first, then readable ones.

    Raises
    ------
    InputError
        If the file is missing or empty, of an unknown format, or a cloud without time.
    """
    path = require_not_empty(Path(path), "survey")
    found = [(format, sure) for kind in kinds for format, sure in recognise_formats(path, kind)]
    if has_no_time(path, or_text=not found):
        raise InputError(error("import.points_without_time", file=str(path)))
    if not found:
        expected = _format_of_name(path)
        if expected is not None:
            raise InputError(error(NOT_OF_ITS_FORMAT_CODE, file=str(path), format=expected.name))
        raise InputError(error("import.unknown_format", file=str(path)))
    least = min(max(sure for _, sure in found), LIKELY)
    ending = path.suffix.lower()
    return sorted(
        (_check_format(path, format, sure) for format, sure in found if sure >= least),
        key=lambda check: (
            -check.confidence, ending not in check.format.endings, check.error is not None
        ),
    )  # fmt: skip


def _format_of_name(path: Path) -> FileFormat | None:
    """The only binary format with the extension of a file; None if there is not exactly one."""
    known = [
        format
        for format in (*TRAJECTORY_FORMATS, *ACCURACY_FORMATS, *POINT_FORMATS)
        if path.suffix.lower() in format.endings
    ]
    is_text = any(option.name == "columns" for format in known for option in format.options)
    return known[0] if len(known) == 1 and not is_text else None


def _check_format(path: Path, format: FileFormat, sure: float) -> FileCheck:
    try:
        return FileCheck(format, sure, format.preview(path, {}))
    except InputError as refused:
        return FileCheck(format, sure, None, message_with_file_name(refused, path))


def preview_with_options(path: Path, format: FileFormat, given: Choice) -> FilePreview:
    """Preview of a file with options given by the user.

    If a coordinate system is given, there is no warning about a missing one, but a warning if the
    given one is not used.

    Raises
    ------
    InputError
        If the file cannot be examined in this format.
    """
    finding = format.preview(path, given)
    crs = str(given.get("crs", ""))
    if format.kind != "points" or not crs:
        return finding
    if {**finding.choice, **given}.get("frame", SCANNER_FRAME) != SCANNER_FRAME:
        kept = tuple(each for each in finding.file_warnings if each.code != NO_SYSTEM_CODE)
        return replace(finding, file_warnings=kept)
    unused = warning(
        "points.unused_system",
        file=printable(path.name),
        system=crs,
        actions=(CHOOSE_FRAME_ACTION,),
    )
    return replace(finding, file_warnings=(*finding.file_warnings, unused))


def detect_reading(path: Path, kind: Kind, reading: Reading) -> tuple[Reading, tuple[Message, ...]]:
    """Complete the reading options of a file: given options, and detected ones for the rest.

    Returns
    -------
    reading : Reading
    messages : tuple of Message
        Warnings, and a note on the options that were detected.

    Raises
    ------
    InputError
        If the file is missing, its format is not known, or an option does not belong to it.
    """
    path = require_file(Path(path), KIND_NAMES[kind])
    if reading.format:
        format = format_of(reading.format)
        if format.kind != kind:
            raise InputError(error(_WRONG_KIND_CODES[kind], file=str(path), format=format.name))
    else:
        found = recognise_formats(path, kind)
        if not found:
            raise InputError(error(_UNKNOWN_FORMAT_CODES[kind], file=str(path)))
        format = found[0][0]
    given = dict(reading.options)
    finding = preview_with_options(path, format, given)
    choice = format.complete_options({**finding.choice, **given})
    messages = list(finding.file_warnings)
    detected = [f"{name}={value}" for name, value in choice.items() if value and name not in given]
    if detected:
        file = printable(path.name)
        messages.append(
            note(DETECTED_OPTIONS_CODE, file=file, format=format.name, options=detected)
        )
    options = tuple((name, str(value)) for name, value in choice.items() if value != "")
    return replace(reading, format=format.key, options=options), tuple(messages)


DETECTED_OPTIONS_CODE = "import.read_as"
"""Code of the note on the options that were detected."""


def default_or_detected_reading(
    path: Path, kind: Kind, given_reading: Reading, *, columns: bool = False
) -> tuple[Reading, tuple[Message, ...]]:
    """Complete the reading options of a file, or keep the defaults if the file agrees with them.

    Parameters
    ----------
    columns : bool
        Whether the columns of a text file are specified.

    Raises
    ------
    InputError
        If the file has no known format or cannot be read.
    """
    if columns and not given_reading.format and not given_reading.options:
        found = recognise_formats(path, kind)
        if not found or found[0][0].key == "text":
            return given_reading, ()
    if not given_reading.format and not given_reading.options and not recognise_formats(path, kind):
        return given_reading, ()  # the default reader gives the best message for a damaged file
    reading, messages = detect_reading(path, kind, given_reading)
    default = DEFAULT_FORMATS[kind]
    own = reading.format == default and not given_reading.format and not given_reading.options
    if own and _agrees_with_default(reading, default):
        kept = tuple(each for each in messages if each.code != DETECTED_OPTIONS_CODE)
        return replace(reading, format="", options=()), kept
    return reading, messages


DEFAULT_FORMATS: Mapping[Kind, str] = {"trajectory": "sbet", "accuracy": "smrmsg", "points": "las"}
"""Default format for each kind of file, read with its default options."""

OPTIONS_WITHOUT_EFFECT = ("axes", "time", "time_base", "crs", "height_unit")
"""Options without effect on the reading of points in the LiDAR frame and of poses. Time bases have
an effect only through the time shift of a line (`shift_lines_to_trajectory`)."""


def _agrees_with_default(reading: Reading, key: str) -> bool:
    usual = {
        name: value for name, value in format_of(key).complete_options({}).items() if value != ""
    }
    found = dict(reading.options)
    return {k: v for k, v in found.items() if k not in OPTIONS_WITHOUT_EFFECT} == {
        k: v for k, v in usual.items() if k not in OPTIONS_WITHOUT_EFFECT
    }


def read_trajectory(path: Path, reading: Reading) -> Trajectory:
    """Read a trajectory, by default as SBET with Applanix's conventions.

    Raises
    ------
    InputError
        If the file cannot be read in that format.
    """
    if not reading.format:
        return read_sbet(path).with_positions_only()
    found = format_of(reading.format).read(Path(path), dict(reading.options))
    assert isinstance(found, Trajectory)
    return found.with_positions_only()


def local_trajectory(project: Project) -> tuple[LocalTrajectory, tuple[Message, ...]]:
    """Read the trajectory of a project in its local frame, with the assumptions of the reader.

    Raises
    ------
    InputError
        If the file cannot be read, or the origin of the local frame is too far away.
    """
    raw = read_trajectory(project.trajectory, project.trajectory_reading)
    frame = raw.mean_frame()
    if project.settings.origin_deg_m is not None:
        latitude, longitude, height = project.settings.origin_deg_m
        frame = LocalFrame(float(np.radians(latitude)), float(np.radians(longitude)), height)
    trajectory = LocalTrajectory.of(raw, frame, project.settings.longest_gap)
    distance = float(np.linalg.norm(trajectory.position[0]))
    if distance > MAX_ORIGIN_DISTANCE:
        raise InputError(error("import.origin_too_far", project=project.name, distance=distance))
    return trajectory, raw.assumptions


def read_accuracy(path: Path, reading: Reading) -> TrajectoryAccuracy:
    """Read the accuracies of a trajectory, by default as smrmsg.

    Raises
    ------
    InputError
        If the file cannot be read in that format.
    """
    if not reading.format:
        return read_smrmsg(path)
    found = format_of(reading.format).read(Path(path), dict(reading.options))
    assert isinstance(found, TrajectoryAccuracy)
    return found


def format_of_line(line: LineSource) -> tuple[FileFormat, Choice, tuple[Message, ...]]:
    """Format of a line, its options, and the assumptions of its reader."""
    if line.reading.format:
        format = format_of(line.reading.format)
        choice: Choice = format.complete_options(dict(line.reading.options))
        assumed: tuple[Message, ...] = (
            note("assumed.format", file=printable(line.path.name), format=format.name),
        )
        if crs_of_options(choice, line.path) is None:
            assumed += (note("assumed.scanner_frame"),)
        return format, choice, assumed
    if is_las(line.path):
        return format_of("las"), {}, LAS_ASSUMPTIONS
    options = {"columns": " ".join(line.columns)}
    return format_of("text"), options, (note("assumed.metres_in_scanner_frame"),)
