"""Import of the lines of a project, each into a store beside ``project.json``."""

import hashlib
import json
import re
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, ProjectError, system_reason
from lispac.io.files import require_file
from lispac.io.formats import is_las
from lispac.io.las.las_export import write_header_copy
from lispac.io.value_conversion import decode_value, encode_value
from lispac.language import gettext_lazy
from lispac.message_texts import has_text
from lispac.messages import Message, as_message, error, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import LineSource, Project
from lispac.survey.georeferencing import Georeferencer, Mounting
from lispac.survey.store.column_files import file_checksum
from lispac.survey.store.layout import (
    HEADER_CHECKSUM_FILE,
    HEADER_FILE,
    MANIFEST_FILE,
    SourceFile,
    damage_reason,
)
from lispac.survey.store.line_import import ImportRecipe, remove_incomplete_parts, write_store
from lispac.survey.store.original_file import source_file_of
from lispac.survey.store.point_blocks import PointPiece
from lispac.survey.store.stored_line import StoredLine, open_store
from lispac.survey.trajectory import LocalTrajectory
from lispac.untrusted_values import InvalidContentError
from lispac.workflow.importing.file_reading import local_trajectory
from lispac.workflow.importing.line_points import DistantDuplicates, LinePoints

Array = NDArray[np.float64]

LINES_FOLDER = "lines"
"""Folder of the stored lines in the folder of the project."""


@dataclass(frozen=True, eq=False)
class ImportedLine:
    """Result of the import of one line.

    Attributes
    ----------
    stored : StoredLine
    seconds : float
        Duration of the import; 0 if the line was imported before.
    reason : Message or None
        Note with the reason if the line was imported again automatically.
    """

    stored: StoredLine
    seconds: float
    reason: Message | None = None


def import_lines(
    project: Project,
    names: Sequence[str] = (),
    *,
    again: bool = False,
    progress: Progress = no_progress,
) -> list[ImportedLine]:
    """Import the lines of a project that are not imported or have changed since.

    Parameters
    ----------
    names : sequence of str
        Names of the lines; all lines if empty.
    again : bool
        Whether to import lines again that are already imported.

    Raises
    ------
    InputError
        If a file cannot be read or does not fit the trajectory.
    ProjectError
        If there is no such line, or its store cannot be written.
    """
    known = {line.name: line for line in project.lines}
    for name in names:
        if name not in known:
            raise ProjectError(
                error("project_line.not_found", project=project.name, line=name, lines=tuple(known))
            )
    lines = [known[name] for name in (names or known)]
    progress(0.0, gettext_lazy("Reading {file}", file=project.trajectory.name))
    trajectory, _ = local_trajectory(project)
    for line in lines:  # checked before hours of reading; imported lines no longer need their file
        if again or not (line_folder(project, line) / MANIFEST_FILE).exists():
            require_file(line.path, "line")
    sizes = [line.path.stat().st_size if line.path.exists() else 0 for line in lines]
    total = sum(sizes) or 1
    imported, done = [], 0
    for line, size in zip(lines, sizes, strict=True):
        step = sub_progress(progress, done / total, (done + size) / total)
        imported.append(import_line(project, line, trajectory, again=again, progress=step))
        done += size
    return imported


def import_line(
    project: Project,
    line: LineSource,
    trajectory: LocalTrajectory,
    *,
    again: bool = False,
    progress: Progress = no_progress,
) -> ImportedLine:
    """Import one line, or continue an interrupted import.

    Raises
    ------
    InputError
        If the file is missing or cannot be read.
    ProjectError
        As `import_lines`.
    """
    folder = line_folder(project, line)
    reason: Message | None = None
    if not again:
        try:
            return ImportedLine(open_stored_line(project, line, trajectory, progress=progress), 0.0)
        except ProjectError as failure:  # damaged or made from other data: imported now
            if (folder / MANIFEST_FILE).exists():
                reason = note("import.repeated", line=line.name, reason=damage_reason(failure))
                if not line.path.exists():
                    raise InputError(
                        error(
                            "import.file_missing", file=str(line.path), line=line.name,
                            reason=failure.reason,
                        )
                    ) from failure  # fmt: skip
    require_file(line.path, "line")
    mounting = project.mounting("prior")
    started = time.monotonic()
    original = source_file_of(line.path)
    recipe = ImportRecipe(
        line.name,
        original,
        _store_dependencies(line, trajectory, mounting),
        {"mounting": mounting.without_nominal_axes.values.tolist()},
    )
    for far_copies in (False, True):
        source = _LineFileReader(
            LinePoints(line, trajectory, mounting, far_copies=far_copies), original
        )
        try:
            write_store(
                folder,
                replace(recipe, made_with={**recipe.made_with, "far_copies": far_copies}),
                source.pieces,
                Georeferencer.of(trajectory, mounting),
                source.stored_findings,
                beside=lambda columns: _store_header(line, columns),
                progress=progress,
            )
        except DistantDuplicates:
            continue
        break
    return ImportedLine(open_store(folder, line.name), time.monotonic() - started, reason)


def _store_header(line: LineSource, columns: Path) -> None:
    """Store the header of a LAS file, to write clouds of the line if the file is missing later."""
    if line.reading.format == "las" or (not line.reading.format and is_las(line.path)):
        write_header_copy(line.path, columns / HEADER_FILE)
        (columns / HEADER_CHECKSUM_FILE).write_text(
            f"{file_checksum(columns / HEADER_FILE):08x}\n", "ascii"
        )


def assumptions_of(stored: StoredLine) -> tuple[Message, ...]:
    """Assumptions of the reader of an imported line.

    Raises
    ------
    ProjectError
        If the store is damaged.
    """
    found = []
    for each in stored.manifest.assumptions:
        try:
            message = as_message(each) if isinstance(each, str) else decode_value(each, Message)
        except InvalidContentError as failure:
            raise ProjectError(error("store.audit_damaged", line=stored.name)) from failure
        if has_text(message):  # else the store is of another version
            found.append(message)
    return tuple(found)


def stored_header(stored: StoredLine) -> Path | None:
    """LAS file without points with the header of a stored line's file.

    None if the file was not LAS, or the stored header was changed.
    """
    columns = stored.folder / stored.manifest.folder
    try:
        kept = int((columns / HEADER_CHECKSUM_FILE).read_text("ascii"), 16)
        return columns / HEADER_FILE if file_checksum(columns / HEADER_FILE) == kept else None
    except (OSError, ValueError):
        return None


def is_header_damaged(stored: StoredLine) -> bool:
    """True if a header of a line's file was stored and is damaged."""
    columns = stored.folder / stored.manifest.folder
    kept = (columns / HEADER_FILE).exists() or (columns / HEADER_CHECKSUM_FILE).exists()
    return kept and stored_header(stored) is None


def open_stored_line(
    project: Project,
    line: LineSource,
    trajectory: LocalTrajectory,
    *,
    progress: Progress = no_progress,
) -> StoredLine:
    """Open an imported line that still agrees with the project.

    Raises
    ------
    ProjectError
        If the line is not imported, its import was interrupted, it is damaged, or its file or the
        settings and data of the import have changed since.
    InputError
        If its file cannot be read.
    """
    stored = open_store(line_folder(project, line), line.name, progress=progress)
    made_with = _store_dependencies(line, trajectory, project.mounting("prior"))
    refusal: Message | None = None
    for name, value in made_with.items():
        if stored.manifest.made_with.get(name) != value:
            change = error(CHANGE_CODES[name], line=line.name)
            if refusal is None:
                refusal = change
            else:
                refusal = error("import.also_changed", first=refusal, reason=change)
    if refusal is not None:
        raise ProjectError(refusal)
    try:
        same = stored.is_source_unchanged(line.path)
    except FileNotFoundError:  # an imported line no longer needs its file
        same = line.path.name == Path(stored.manifest.original.path).name
    except OSError as failure:
        raise InputError(
            error(
                "import.file_unreadable",
                file=str(line.path),
                line=line.name,
                reason=system_reason(failure),
            )
        ) from failure
    if not same:
        raise ProjectError(error("import.file_changed", line=line.name, file=str(line.path)))
    remove_incomplete_parts(stored.folder, stored.manifest)
    return stored


def line_folder(project: Project, line: LineSource) -> Path:
    """Folder of a line's store in the folder of the project."""
    plain = re.sub(r"[^A-Za-z0-9_-]", "_", line.name)
    alike = [n for n in project.lines if n.name != line.name and n.name.lower() == plain.lower()]
    if plain != line.name or alike or plain.lower() in RESERVED_FILE_NAMES:
        plain += f"-{hashlib.sha256(line.name.encode()).hexdigest()[:8]}"
    return project.folder / LINES_FOLDER / plain


RESERVED_FILE_NAMES = {
    "con",
    "prn",
    "aux",
    "nul",
    *(f"{p}{k}" for p in ("com", "lpt") for k in range(10)),
}
"""Names that Windows reserves for devices."""


CHANGE_CODES = {
    "reading": "import.reading_changed",
    "columns": "import.columns_changed",
    "trajectory": "import.trajectory_changed",
    "recovered_with": "import.mounting_changed",
    "latency": "import.latency_changed",
}
"""Code of the reason to import a line again, by the changed item of `_store_dependencies`."""


def _store_dependencies(
    line: LineSource, trajectory: LocalTrajectory, mounting: Mounting
) -> dict[str, Any]:
    """Settings and data that the content of a store depends on, as plain values."""
    on_map = LinePoints(line, trajectory, mounting).recovery is not None
    return {
        "reading": json.loads(json.dumps(encode_value(line.reading))),  # in the form read from JSON
        "columns": list(line.columns),
        "trajectory": _trajectory_fingerprint(trajectory),
        "recovered_with": mounting.without_nominal_axes.values.tolist() if on_map else None,
        "latency": mounting.latency,
    }


def _trajectory_fingerprint(trajectory: LocalTrajectory) -> str:
    frame = trajectory.frame
    digest = hashlib.sha256(f"{frame} {trajectory.longest_gap}".encode())
    for values in (trajectory.time, trajectory.position, trajectory.attitude):
        digest.update(np.ascontiguousarray(values).data)
    return digest.hexdigest()[:32]


class _LineFileReader:
    """Reader of the usable points of a line's file, with the findings of its audit."""

    def __init__(self, points: LinePoints, original: SourceFile) -> None:
        self._points, self._original = points, original

    def stored_findings(self) -> tuple[tuple[dict[str, Any], ...], dict[str, Any]]:
        """Assumptions and audit, as plain values for the store."""
        return tuple(map(encode_value, self._points.assumptions)), encode_value(
            self._points.findings
        )

    def pieces(self, first: int) -> Iterator[PointPiece]:
        """Yield the usable points from index ``first`` of the file on.

        The file is nevertheless read from its beginning, because the audit covers all points.

        Raises
        ------
        InputError
            If the file cannot be read, changes while it is read, or has no usable points.
        DistantDuplicates
            If equal points are too far apart in the file to be excluded at once.
        """
        for piece in self._points.pieces():
            if piece.read > first:
                start = int(np.searchsorted(piece.index, first))
                yield piece.rows(start, len(piece)) if start else piece
        self._require_unchanged()

    def _require_unchanged(self) -> None:
        path, then = self._points.line.path, self._original
        try:
            now = path.stat()
        except OSError as failure:
            raise InputError(error("import.file_removed", file=str(path))) from failure
        if (now.st_size, now.st_mtime_ns) != (then.size, then.modified):
            raise InputError(error("import.file_being_written", file=str(path)))
