"""Audit of a file of points before it is imported as a line of a project."""

from dataclasses import dataclass
from pathlib import Path

from lispac.errors import LispacError
from lispac.io.format_types import Choice, FileFormat
from lispac.io.point_reader_common import FRAME_OPTION, SCANNER_FRAME
from lispac.language import gettext_lazy
from lispac.messages import Level, Message
from lispac.progress import Progress, no_progress
from lispac.survey.audit_messages import line_messages
from lispac.survey.line_audit import LineAudit
from lispac.survey.line_source import printable
from lispac.survey.point_screening import PointScreen, PointSelection
from lispac.workflow.importing.line_points import read_chunks

MAX_AUDITED_POINTS = 20_000_000
"""Largest number of points that are read; the import checks all points."""


@dataclass(frozen=True)
class FileAudit:
    """Result of the audit of the points of a file.

    Attributes
    ----------
    audit : LineAudit
    attributes : frozenset of str
        Names of the attributes of the points.
    messages : tuple of Message
        Messages about the file, with effects that can be determined without a trajectory.
    """

    audit: LineAudit
    attributes: frozenset[str]
    messages: tuple[Message, ...]


def audit_file(
    path: Path,
    format: FileFormat,
    options: Choice,
    *,
    max_points: int = MAX_AUDITED_POINTS,
    progress: Progress = no_progress,
) -> FileAudit:
    """Read the points of a file and check them as a whole.

    Parameters
    ----------
    format : FileFormat
        A format of points.
    options : mapping
        Options of the format.
    max_points : int
        Number of points after which reading stops, which a message reports.

    Raises
    ------
    InputError
        If the file cannot be read.
    """
    resolved = format.complete_options(options)
    screen = PointScreen(
        PointSelection.of(resolved), ranged=resolved[FRAME_OPTION.name] == SCANNER_FRAME
    )
    attributes: set[str] = set()
    read, name = 0, printable(path.name)
    complete = True
    for chunk in read_chunks(format.read(path, options)):
        if read >= max_points:
            complete = False
            break
        attributes |= set(chunk.extra)
        screen(chunk.time, chunk.xyz, chunk.extra)
        read += len(chunk.time)
        progress(
            min(1.0, read / min(chunk.total or max_points, max_points)),
            gettext_lazy("Checking {file}", file=name),
        )
    audit = screen.result()
    messages = line_messages(name, audit)
    if not complete:
        note = Message("audit.first_points", Level.NOTE, {"file": name, "count": read})
        messages = (*messages, note)
    return FileAudit(audit, frozenset(attributes), messages)


def audit_messages(
    path: Path, format: FileFormat, options: Choice, *, progress: Progress = no_progress
) -> tuple[Message, ...]:
    """Messages about the points of a file; none if the points cannot be read."""
    try:
        return audit_file(path, format, options, progress=progress).messages
    except LispacError:
        return ()
