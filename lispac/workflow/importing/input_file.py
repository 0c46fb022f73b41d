"""A file to be imported: its format, its options and its content.

An `InputFile` is an immutable value. `examine_file` and `reexamine_file` return a new one; they
read the file, so they run in the worker thread.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from lispac.errors import Cancelled, InputError, LispacError
from lispac.io.files import message_with_file_name
from lispac.io.format_types import POSSIBLE, FileFormat, FilePreview, Kind
from lispac.io.formats import format_of
from lispac.io.points.line_times import LineTimes, read_line_times
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import LineSource
from lispac.survey.crs import coordinate_system
from lispac.survey.line_audit import LineAudit
from lispac.survey.line_source import Reading, printable
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.workflow.importing.file_audit import audit_file
from lispac.workflow.importing.file_reading import (
    DEFAULT_FORMATS,
    FileCheck,
    check_file,
    preview_with_options,
)
from lispac.workflow.importing.input_columns import (
    column_meanings,
    has_column_names,
    has_columns,
    layout_key,
    missing_columns,
)
from lispac.workflow.importing.line_split import parts_of_line

Content = Trajectory | TrajectoryAccuracy | LineTimes


@dataclass(frozen=True)
class LineLocation:
    """Location of a georeferenced line.

    Attributes
    ----------
    system : str
        Name of its coordinate system.
    latitude, longitude : float, radians
        Position of one of its points.
    error : Message or None
        Reason why the position cannot be determined.
    """

    system: str = ""
    latitude: float = 0.0
    longitude: float = 0.0
    error: Message | None = None


@dataclass(frozen=True, eq=False)
class InputFile:
    """A file to be imported, with its role and options.

    Attributes
    ----------
    checks : tuple of FileCheck
        Checks of the file in each format that it may have, the most likely first; empty before the
        examination and for unknown formats.
    role : {"trajectory", "accuracy", "points"} or None
        None excludes the file.
    format : FileFormat or None
    given_options : mapping of str to str
        Options given by the user.
    finding : FilePreview or None
        Preview with these options; if they do not fit the file, the last valid preview.
    content : Trajectory, TrajectoryAccuracy, LineTimes or None
    error : Message or None
        Reason why the file cannot be used.
    shift : float, seconds
        Time shift, added to the times of a line.
    shift_follows_bases : bool
        Whether the shift follows from given time bases.
    place : LineLocation or None
        Location of a georeferenced line.
    pending : bool
        Whether the file has to be examined, for the first time or after a change of its options.
    remembered : bool
        Whether the columns are those chosen for an earlier file with the same layout.
    project_reading : Reading or None
        Reading options in an open project; role, format and options cannot be changed then.
    audit : LineAudit or None
        Audit of the points of a line.
    split_by : str
        Criterion by which the file is split into lines, as for `split_line`; empty for one line.
    """

    path: Path
    checks: tuple[FileCheck, ...] = ()
    role: Kind | None = None
    format: FileFormat | None = None
    given_options: Mapping[str, str] | None = None
    finding: FilePreview | None = None
    content: Content | None = None
    error: Message | None = None
    shift: float = 0.0
    shift_follows_bases: bool = False
    place: LineLocation | None = None
    pending: bool = True
    remembered: bool = False
    project_reading: Reading | None = None
    audit: LineAudit | None = None
    split_by: str = ""

    @property
    def formats(self) -> tuple[FileFormat, ...]:
        """Possible formats of the file in its role, the most likely first."""
        return tuple(check.format for check in self.checks if check.format.kind == self.role)

    @property
    def roles(self) -> tuple[Kind, ...]:
        """Possible roles of the file by its formats, the most likely first."""
        return tuple(dict.fromkeys(check.format.kind for check in self.checks))

    @property
    def options(self) -> dict[str, str]:
        """Values of all options: given, else detected, else default."""
        if self.format is None:
            return {}
        found = {} if self.finding is None else dict(self.finding.choice)
        known = {option.name: option.default for option in self.format.options}
        resolved = known | found | dict(self.given_options or {})
        return {name: str(resolved[name]) for name in known}

    @property
    def columns(self) -> tuple[str, ...]:
        """Meaning of each column of a text file, from the left; empty for other files."""
        if self.format is None or not has_columns(self.format):
            return ()
        given = (self.given_options or {}).get("columns", "")
        return column_meanings(self.format, self.finding, given)

    @property
    def reading(self) -> Reading:
        """Reading options given by the user; `complete_readings` detects the others again."""
        given = {} if self.given_options is None else dict(self.given_options)
        if self.format is None or (not given and self.format in self.formats[:1]):
            return Reading("", (), self.shift)
        return Reading(self.format.key, tuple(given.items()), self.shift)

    @property
    def layout(self) -> str:
        """Key of the layout of a text file, to recognise similar ones; empty for other files."""
        check = next((check for check in self.checks if check.format is self.format), None)
        return "" if check is None else layout_key(check)

    def parts(self, line: LineSource) -> tuple[LineSource, ...]:
        """Lines of the file: ``line`` itself, or the lines into which it is split."""
        if not self.split_by or self.audit is None or self.format is None:
            return (line,)
        return parts_of_line(line, self.audit, self.split_by, self.format.key)

    @property
    def is_georeferenced(self) -> bool:
        """True if the file is a line in map coordinates."""
        return self.role == "points" and self.options.get("frame") == "georeferenced"


def examine_file(
    path: Path, mappings: Mapping[str, str] | None = None, *, progress: Progress = no_progress
) -> InputFile:
    """Examine a file for the first time.

    Parameters
    ----------
    mappings : mapping of str to str
        Columns chosen for earlier text files, by the key of their layout.
    """
    progress(0.0, gettext_lazy("Examining {file}", file=path.name))
    try:
        found = check_file(path)
    except LispacError as refused:
        return InputFile(path, error=message_with_file_name(refused, path), pending=False)
    first = found[0]
    input_file = InputFile(path, tuple(found), first.format.kind, first.format)
    if first.confidence <= POSSIBLE and path.suffix.lower() not in first.format.endings:
        unlikely = note(
            "import.unlikely_format", file=printable(path.name), format=first.format.name
        )
        return replace(input_file, role=None, format=None, error=unlikely, pending=False)
    for check in found:
        columns = (mappings or {}).get(layout_key(check), "")
        if columns and not has_column_names(check):
            input_file = replace(
                input_file, role=check.format.kind, format=check.format, remembered=True,
                given_options={"columns": columns},
            )  # fmt: skip
            break
    return reexamine_file(input_file, progress=progress)


def examine_project_file(input_file: InputFile, *, progress: Progress = no_progress) -> InputFile:
    """Examine a file of an open project for the first time, with the project's options."""
    progress(0.0, gettext_lazy("Examining {file}", file=input_file.path.name))
    assert input_file.role is not None
    assert input_file.project_reading is not None
    try:
        found = check_file(input_file.path, (input_file.role,))
    except LispacError as refused:
        return replace(
            input_file, error=message_with_file_name(refused, input_file.path), pending=False
        )
    format = format_of(input_file.project_reading.format or DEFAULT_FORMATS[input_file.role])
    given = dict(input_file.project_reading.options)
    return reexamine_file(
        replace(input_file, checks=tuple(found), format=format, given_options=given or None),
        progress=progress,
    )


def reexamine_file(input_file: InputFile, *, progress: Progress = no_progress) -> InputFile:
    """Examine a file again with its present role, format and options.

    Raises
    ------
    Cancelled
        If the user cancels.
    """
    input_file = replace(input_file, pending=False, error=None, content=None, place=None)
    if input_file.role is None or input_file.format is None:
        return input_file
    if input_file.finding is None or not input_file.given_options:
        input_file = _with_preview(input_file, {})
    assert input_file.format is not None
    missing = missing_columns(input_file.format, input_file.columns)
    if missing:
        file = printable(input_file.path.name)
        return replace(input_file, error=error(COLUMNS_NOT_CHOSEN_CODE, file=file, columns=missing))
    if input_file.given_options:
        input_file = _with_preview(input_file, dict(input_file.given_options))
    if input_file.error or input_file.finding is None:
        return input_file
    progress(0.1, gettext_lazy("Reading {file}", file=input_file.path.name))
    try:
        return _with_content(input_file, progress)
    except Cancelled:
        raise
    except LispacError as refused:
        return replace(input_file, error=message_with_file_name(refused, input_file.path))


COLUMNS_NOT_CHOSEN_CODE = "import.columns_not_chosen"
"""Code of the error that the user has to choose the meanings of the columns."""


def _with_preview(input_file: InputFile, given: dict[str, str]) -> InputFile:
    assert input_file.format is not None
    known = next((check for check in input_file.checks if check.format is input_file.format), None)
    if not given and known is not None:
        # Without given options, the preview of the first check applies.
        return replace(input_file, finding=known.finding, error=known.error)
    try:
        return replace(
            input_file, finding=preview_with_options(input_file.path, input_file.format, given)
        )
    except LispacError as refused:
        kept = input_file.finding or (None if known is None else known.finding)
        return replace(
            input_file, finding=kept, error=message_with_file_name(refused, input_file.path)
        )


def _with_content(input_file: InputFile, progress: Progress) -> InputFile:
    assert input_file.format is not None
    if input_file.role == "points":
        reading = sub_progress(progress, 0.1, 0.5)
        times = read_line_times(
            input_file.path, input_file.format, input_file.options, progress=reading
        )
        place = input_file.place
        if input_file.is_georeferenced:
            # The times of a line do not depend on its coordinate system, so they are read even if
            # the system is not known.
            place = _line_location(input_file, times)
        found = audit_file(
            input_file.path,
            input_file.format,
            input_file.options,
            progress=sub_progress(progress, 0.5, 1.0),
        )
        finding = input_file.finding
        if finding is not None:
            finding = finding.with_messages(found.messages)
        return replace(input_file, content=times, place=place, finding=finding, audit=found.audit)
    content = input_file.format.read(input_file.path, input_file.options)
    assert isinstance(content, Trajectory | TrajectoryAccuracy)
    if isinstance(content, Trajectory):
        content = content.with_positions_only()
        if content.messages and input_file.finding is not None:
            finding = input_file.finding.with_messages(content.messages)
            input_file = replace(input_file, finding=finding)
    return replace(input_file, content=content)


def _line_location(input_file: InputFile, times: LineTimes) -> LineLocation:
    options, file = input_file.options, printable(input_file.path.name)
    try:
        epoch = options.get("epoch", "").strip()
        system = coordinate_system(
            options.get("crs", ""),
            height=options.get("height", ""),
            height_unit=options.get("height_unit", ""),
            trajectory_datum=options.get("trajectory_datum", ""),
            epoch=float(epoch) if epoch else None,
        )
        latitude, longitude, _ = system.to_geodetic(times.place[None, :])
    except InputError as refused:
        return LineLocation(error=error("file.coordinate_system", file=file, reason=refused.reason))
    except ValueError:
        return LineLocation(error=error("file.epoch", epoch=options["epoch"]))
    if not np.isfinite([latitude[0], longitude[0]]).all():
        outside = error("import.outside_system", file=file, system=system.name)
        return LineLocation(system.name, error=outside)
    return LineLocation(system.name, float(latitude[0]), float(longitude[0]))
