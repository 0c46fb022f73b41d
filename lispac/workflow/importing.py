"""Importing the lines of a project: each becomes a store beside ``project.json``."""

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
from lispac.foreign_values import InvalidContentError
from lispac.io.files import require_file
from lispac.io.formats import is_las
from lispac.io.las_export import write_header_alone
from lispac.io.values import decoded, encoded
from lispac.language import gettext_lazy
from lispac.message_texts import has_text
from lispac.messages import Message, as_message, error, note
from lispac.progress import Progress, no_progress, part
from lispac.project import LineSource, Project
from lispac.survey.georeferencing import Georeferencer, Mounting
from lispac.survey.store.columns import checksum_of
from lispac.survey.store.layout import HEADER, HEADER_SUM, MANIFEST, SourceFile, damage_of
from lispac.survey.store.original import original_of
from lispac.survey.store.pieces import Piece
from lispac.survey.store.reading import StoredLine, open_store
from lispac.survey.store.writing import Recipe, tidy, write_store
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.file_reading import local_trajectory
from lispac.workflow.line_points import FarCopies, LinePoints

Array = NDArray[np.float64]

LINES = "lines"
"""Folder of the stored lines, in that of the project."""


@dataclass(frozen=True, eq=False)
class Imported:
    """One imported line.

    Attributes
    ----------
    stored : StoredLine
    seconds : float
        That the import took; 0 where the line was imported already.
    reason : Message or None
        Note that it was imported again automatically, with the reason.
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
) -> list[Imported]:
    """Import lines of a project; those that are imported as they are now stay.

    Parameters
    ----------
    names : sequence of str
        Of the lines; none means all of them.
    again : bool
        Import what is imported already, too.

    Raises
    ------
    InputError
        Where a file cannot be read or does not fit the trajectory.
    ProjectError
        Where there is no such line, or its store cannot be written.
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
    for line in lines:  # before hours of reading others; what is imported needs its file no more
        if again or not (line_folder(project, line) / MANIFEST).exists():
            require_file(line.path, "line")
    sizes = [line.path.stat().st_size if line.path.exists() else 0 for line in lines]
    total = sum(sizes) or 1
    imported, done = [], 0
    for line, size in zip(lines, sizes, strict=True):
        step = part(progress, done / total, (done + size) / total)
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
) -> Imported:
    """Import one line; where that was interrupted before, it goes on from there.

    Raises
    ------
    InputError
    ProjectError
        As `import_lines`.
    """
    folder = line_folder(project, line)
    reason: Message | None = None
    if not again:
        try:
            return Imported(stored_line(project, line, trajectory, progress=progress), 0.0)
        except ProjectError as failure:  # damaged or made from something else: it is made now
            if (folder / MANIFEST).exists():
                reason = note("import.repeated", line=line.name, reason=damage_of(failure))
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
    original = original_of(line.path)
    recipe = Recipe(
        line.name,
        original,
        _made_with(line, trajectory, mounting),
        {"mounting": mounting.plain.values.tolist()},
    )
    for far_copies in (False, True):
        source = _Source(LinePoints(line, trajectory, mounting, far_copies=far_copies), original)
        try:
            write_store(
                folder,
                replace(recipe, made_with={**recipe.made_with, "far_copies": far_copies}),
                source.pieces,
                Georeferencer.of(trajectory, mounting),
                source.findings,
                beside=lambda columns: _keep_header(line, columns),
                progress=progress,
            )
        except FarCopies:
            continue
        break
    return Imported(open_store(folder, line.name), time.monotonic() - started, reason)


def _keep_header(line: LineSource, columns: Path) -> None:
    """Keep the header and records of a LAS file, for export when the file is missing."""
    if line.reading.format == "las" or (not line.reading.format and is_las(line.path)):
        write_header_alone(line.path, columns / HEADER)
        (columns / HEADER_SUM).write_text(f"{checksum_of(columns / HEADER):08x}\n", "ascii")


def assumptions_of(stored: StoredLine) -> tuple[Message, ...]:
    """What the reader of an imported line takes for granted.

    Raises
    ------
    ProjectError
        Where the store is damaged.
    """
    found = []
    for each in stored.manifest.assumptions:
        try:
            message = as_message(each) if isinstance(each, str) else decoded(each, Message)
        except InvalidContentError as failure:
            raise ProjectError(error("store.audit_damaged", line=stored.name)) from failure
        if has_text(message):  # else of another version
            found.append(message)
    return tuple(found)


def kept_header(stored: StoredLine) -> Path | None:
    """The LAS file without points that holds the header of a stored line's file.

    None where it had none, or what was kept of it has changed since.
    """
    columns = stored.folder / stored.manifest.folder
    try:
        kept = int((columns / HEADER_SUM).read_text("ascii"), 16)
        return columns / HEADER if checksum_of(columns / HEADER) == kept else None
    except (OSError, ValueError):
        return None


def header_is_damaged(stored: StoredLine) -> bool:
    """Whether the header of a stored line's file was kept, but cannot be used."""
    columns = stored.folder / stored.manifest.folder
    kept = (columns / HEADER).exists() or (columns / HEADER_SUM).exists()
    return kept and kept_header(stored) is None


def stored_line(
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
        Where the line is not imported, its import was interrupted, it is damaged, or its file or
        what it was made with has changed since.
    InputError
        Where its file cannot be read.
    """
    stored = open_store(line_folder(project, line), line.name, progress=progress)
    made_with = _made_with(line, trajectory, project.mounting("prior"))
    refusal: Message | None = None
    for name, value in made_with.items():
        if stored.manifest.made_with.get(name) != value:
            change = error(CHANGES[name], line=line.name)
            if refusal is None:
                refusal = change
            else:
                refusal = error("import.also_changed", first=refusal, reason=change)
    if refusal is not None:
        raise ProjectError(refusal)
    try:
        same = stored.is_of(line.path)
    except FileNotFoundError:  # the store needs its file no more
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
    tidy(stored.folder, stored.manifest)
    return stored


def line_folder(project: Project, line: LineSource) -> Path:
    """Folder of a line's store in the folder of the project."""
    plain = re.sub(r"[^A-Za-z0-9_-]", "_", line.name)
    alike = [n for n in project.lines if n.name != line.name and n.name.lower() == plain.lower()]
    if plain != line.name or alike or plain.lower() in RESERVED:
        plain += f"-{hashlib.sha256(line.name.encode()).hexdigest()[:8]}"
    return project.folder / LINES / plain


RESERVED = {"con", "prn", "aux", "nul", *(f"{p}{k}" for p in ("com", "lpt") for k in range(10))}
"""Names that Windows gives to nothing but devices."""


CHANGES = {
    "reading": "import.reading_changed",
    "columns": "import.columns_changed",
    "trajectory": "import.trajectory_changed",
    "recovered_with": "import.mounting_changed",
    "latency": "import.latency_changed",
}


def _made_with(line: LineSource, trajectory: LocalTrajectory, mounting: Mounting) -> dict[str, Any]:
    """What the content of a store follows from besides the file, as plain values."""
    on_map = LinePoints(line, trajectory, mounting).recovery is not None
    return {
        "reading": json.loads(json.dumps(encoded(line.reading))),  # as it comes back
        "columns": list(line.columns),
        "trajectory": _fingerprint(trajectory),
        "recovered_with": mounting.plain.values.tolist() if on_map else None,
        "latency": mounting.latency,
    }


def _fingerprint(trajectory: LocalTrajectory) -> str:
    frame = trajectory.frame
    digest = hashlib.sha256(f"{frame} {trajectory.longest_gap}".encode())
    for values in (trajectory.time, trajectory.position, trajectory.attitude):
        digest.update(np.ascontiguousarray(values).data)
    return digest.hexdigest()[:32]


class _Source:
    """The usable points of a line's file, from any of them on, and what was found in them."""

    def __init__(self, points: LinePoints, original: SourceFile) -> None:
        self._points, self._original = points, original

    def findings(self) -> tuple[tuple[dict[str, Any], ...], dict[str, Any]]:
        """The assumptions and the audit, as plain values."""
        return tuple(map(encoded, self._points.assumptions)), encoded(self._points.found)

    def pieces(self, first: int) -> Iterator[Piece]:
        """Give the usable points from index ``first`` of the file on.

        The file is read from its beginning all the same: the audit covers all of it.

        Raises
        ------
        InputError
            Where the file cannot be read, changes meanwhile, or none of its points can be used.
        FarCopies
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
