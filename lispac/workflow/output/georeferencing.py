"""Georeferencing of the lines of a project, one LAS or LAZ file each."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np

from lispac.errors import InputError, ProjectError
from lispac.io.files import atomic_write, require_file
from lispac.io.format_types import PointChunk
from lispac.io.las.las_export import RecordLayout, layout_of_las
from lispac.io.point_reader_common import POINTS_PER_CHUNK
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import BoresightChoice, LineSource, Project, Reading
from lispac.survey.crs import CoordinateSystem
from lispac.survey.line_source import DEFAULT_READING
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.scanner_frame_recovery import RecoverySetup
from lispac.survey.store.stored_line import StoredLine
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.file_reading import local_trajectory
from lispac.workflow.importing.line_chunks import LineChunks
from lispac.workflow.importing.line_import import line_folder, open_stored_line, stored_header
from lispac.workflow.importing.line_points import mounting_of_cloud
from lispac.workflow.output.cloud_export import WrittenLine, write_cloud
from lispac.workflow.output.pos_corrections import (
    corrected_trajectory,
    pos_corrections,
    support_notes,
)
from lispac.workflow.project.output_crs import output_system

Ending = Literal["laz", "las"]
TrajectoryChoice = Literal["given", "corrected"]
"""Trajectory with which points are georeferenced."""


def georeference_project(
    project: Project,
    output: Path,
    which: BoresightChoice = "estimated",
    *,
    system: str = "",
    height: str = "",
    trajectory_datum: str | None = None,
    epoch: float | None = None,
    lines: Sequence[str] = (),
    ending: Ending = "laz",
    sources: Mapping[str, Iterable[PointChunk]] | None = None,
    trajectory_choice: TrajectoryChoice = "given",
    progress: Progress = no_progress,
) -> list[WrittenLine]:
    """Write the lines of a project as LAS or LAZ in a coordinate system.

    All files appear together at the end; after an error or cancellation none is left.

    Parameters
    ----------
    output : Path
        Output folder, created if needed.
    system : str
        As for `lispac.survey.crs.coordinate_system`, or ``local``; if empty, the system of the
        lines if they are georeferenced.
    height, trajectory_datum, epoch
        As for `lispac.survey.crs.coordinate_system`; datum and epoch are by default those with
        which the lines are read.
    lines : sequence of str
        Names of the lines; all by default.
    sources : mapping of str to iterable of PointChunk, optional
        Chunks of lines to use instead of their files, by line name. Points are in the LiDAR frame,
        and times as in the file. A line whose file is missing is read from its store.
    trajectory_choice : {"given", "corrected"}
        Whether to use the trajectory as it is or corrected by the adjustment, which needs the
        estimated boresight. The file names and a record in the files name the corrected one.

    Raises
    ------
    InputError
        If the coordinate system is not known or not given, a file cannot be read, or the disk is
        full.
    ProjectError
        If there is no such line, nothing has been estimated, or there are no corrections.
    """
    is_corrected = trajectory_choice == "corrected"
    if is_corrected and which == "prior":
        raise InputError(error("corrections.prior_boresight"))
    mounting = project.mounting(which)
    chosen = [LineChunks.of(line) for line in _chosen_lines(project, lines)]
    trajectory, _ = local_trajectory(project)
    target = output_system(chosen, trajectory, system, height, trajectory_datum, epoch)
    lines_written = [chunks.line for chunks in chosen]
    paths = line_paths(output, lines_written, which, ending, trajectory_choice)
    require_no_overwrite(project, paths)
    used = corrected_trajectory(project, trajectory) if is_corrected else trajectory
    support = support_notes(pos_corrections(project)) if is_corrected else ()
    converter = ScannerPointConverter(target, used, mounting)
    stores, stored_layouts = _stored_lines(project, chosen, trajectory, sources or {})
    sizes = [c.line.path.stat().st_size + 1 if c.line.path.exists() else 1 for c in chosen]
    written: list[WrittenLine] = []
    with _new_folders_removed_after_failure(output), ExitStack() as stack:
        for k, (chunks, path) in enumerate(zip(chosen, paths, strict=True)):
            start, stop = sum(sizes[:k]) / sum(sizes), sum(sizes[: k + 1]) / sum(sizes)
            step = sub_progress(progress, start, stop)
            step(0.0, gettext_lazy("Writing {file}", file=path.name))
            own = stores.get(chunks.line.name)
            done = write_cloud(
                chunks if own is None else own,
                stack.enter_context(atomic_write(path)),
                path,
                converter,
                _layout_function(chunks, stored_layouts.get(chunks.line.name)),
                reading=chunks.line.reading,
                recovery=_recovery_of(project, chunks, trajectory) if own is None else None,
                compressed=ending == "laz",
                is_trajectory_corrected=is_corrected,
                progress=step,
            )
            messages = _missing_file_notes(chunks.line.name, stored_layouts)
            written.append(
                replace(done, messages=(*support, *done.messages, *_assumptions(target), *messages))
            )
        progress(1.0)
    return written


def _stored_lines(
    project: Project,
    chosen: Iterable[LineChunks],
    trajectory: LocalTrajectory,
    sources: Mapping[str, Iterable[PointChunk]],
) -> tuple[dict[str, Iterable[PointChunk]], dict[str, RecordLayout | None]]:
    """Chunks to use instead of the files of the lines, and layouts of those from stores, by name.

    A line has chunks in ``sources``, or from its store if its file is missing.
    """
    stores, layouts = dict(sources), {}
    for chunks in chosen:
        if not chunks.line.path.exists() and chunks.line.name not in stores:
            stored = open_stored_line(project, chunks.line, trajectory)
            stores[chunks.line.name] = stored_chunks(stored, chunks.line.reading)
            layouts[chunks.line.name] = _stored_layout(stored, chunks.line.path)
    return stores, layouts


@contextmanager
def _new_folders_removed_after_failure(output: Path) -> Iterator[None]:
    """Remove the output folder and those above it after an error, if they are new and empty."""
    made = _folders_to_create(output)
    try:
        yield
    except BaseException:
        for folder in made:
            if folder.is_dir() and not any(folder.iterdir()):
                folder.rmdir()
        raise


def _recovery_of(
    project: Project, chunks: LineChunks, trajectory: LocalTrajectory
) -> RecoverySetup | None:
    """Georeferencing with which the points of a file were made; None in the LiDAR frame."""
    if chunks.system is None:
        return None
    made_with, _ = mounting_of_cloud(chunks.line, project.mounting("prior"))
    return RecoverySetup(chunks.system, trajectory, made_with, chunks.line.path)


def _missing_file_notes(
    line: str, stored_layouts: Mapping[str, RecordLayout | None]
) -> tuple[Message, ...]:
    """Note that a line was read from its store because its file is missing."""
    if line not in stored_layouts:
        return ()
    is_kept = stored_layouts[line] is not None
    return (note("export.file_gone" if is_kept else "export.file_and_header_gone", line=line),)


def _stored_layout(stored: StoredLine, path: Path) -> RecordLayout | None:
    """Record layout of the line's file, if it was stored during the import."""
    header = stored_header(stored)
    try:
        return None if header is None else layout_of_las(header, path)
    except InputError:
        return None  # damaged: all points are stored, and missing data are reported


def _layout_function(
    chunks: LineChunks, kept: RecordLayout | None
) -> Callable[[PointChunk], RecordLayout]:
    return chunks.pattern if kept is None else lambda first: kept


def _chosen_lines(project: Project, names: Sequence[str]) -> list[LineSource]:
    known = {line.name: line for line in project.lines}
    for name in names:
        if name not in known:
            raise ProjectError(
                error("project_line.not_found", project=project.name, line=name, lines=tuple(known))
            )
    found = [line for name, line in known.items() if not names or name in names]
    for line in found:
        if line.path.exists() or not line_folder(project, line).is_dir():
            require_file(line.path, "line")
    return found


def stored_chunks(stored: StoredLine, reading: Reading = DEFAULT_READING) -> Iterator[PointChunk]:
    """Chunks of an imported line, in spatial order.

    Parameters
    ----------
    reading : Reading
        Reading options, whose effect on times is reversed to restore the times of the file (to the
        last digit of a double).
    """
    for start in range(0, len(stored), POINTS_PER_CHUNK):
        rows = slice(start, start + POINTS_PER_CHUNK)
        yield PointChunk(
            np.asarray(stored.points_lidar[rows], dtype=np.float64),
            reading.to_file_time(np.array(stored.time[rows])),
            {name: np.asarray(values[rows]) for name, values in stored.extra.items()},
            len(stored),
        )


def _assumptions(target: CoordinateSystem | None) -> tuple[Message, ...]:
    return (note("assumed.local_frame"),) if target is None else target.assumptions


def line_paths(
    output: Path,
    lines: Iterable[LineSource],
    which: BoresightChoice,
    ending: str,
    trajectory_choice: TrajectoryChoice,
) -> list[Path]:
    """Files that `georeference_project` writes to a folder for some lines, in their order."""
    suffix = f"{which}_corrected" if trajectory_choice == "corrected" else which
    return [output / f"{line.name}_{suffix}.{ending}" for line in lines]


def require_no_overwrite(project: Project, paths: Sequence[Path]) -> None:
    """Refuse to overwrite the files of the project.

    Raises
    ------
    InputError
        If a path is that of a line, of the trajectory or of its accuracy.
    """
    own = [line.path for line in project.lines] + [project.trajectory]
    if project.accuracy is not None:
        own.append(project.accuracy)
    for path in paths:
        if any(path.exists() and other.exists() and path.samefile(other) for other in own):
            raise InputError(error("export.own_file", file=str(path)))


def _folders_to_create(folder: Path) -> list[Path]:
    """Folders that will be created, the innermost first."""
    folder = Path(folder)
    return [place for place in (folder, *folder.parents) if not place.exists()]
