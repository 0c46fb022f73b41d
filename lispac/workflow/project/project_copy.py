"""Saving a project in another folder, with the lines that were imported into it."""

import os
import shutil
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from zlib import crc32

from lispac.errors import InputError, ProjectError, system_reason
from lispac.io.project.project_file import PROJECT_FILE_NAME, SIGHTINGS_FOLDER, write_project
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress
from lispac.project import Project
from lispac.survey.cloud import Cloud, CloudOnDisk, Line
from lispac.survey.store.import_lock import LOCK_FILE, lock_folder
from lispac.survey.store.layout import (
    HEADER_CHECKSUM_FILE,
    HEADER_FILE,
    MANIFEST_FILE,
    columns_folders,
    is_link,
    remove_columns,
    remove_manifest_parts,
    require_no_link,
    write_manifest,
)
from lispac.survey.store.stored_line import StoredLine
from lispac.workflow.importing.line_import import LINES_FOLDER, line_folder, stored_header
from lispac.workflow.project.projects import removed_on_failure
from lispac.workflow.project.survey import Survey

COPY_PIECE_BYTES = 1 << 24
"""Number of bytes that are copied at once."""
UNFINISHED_MARK = ".saving"
"""File in the folder of a copied line: the copy is invalid until the project is written."""


def save_project_as(
    project: Project, survey: Survey, folder: Path, *, progress: Progress = no_progress
) -> tuple[Project, Survey]:
    """Save a project in another folder; the original remains unchanged.

    The files of the survey stay in their place. Imported lines are copied, so that they are
    available even if their files are missing.

    Returns
    -------
    project : Project
        Project in the new folder.
    survey : Survey
        Survey that reads its lines from the new folder.

    Raises
    ------
    ProjectError
        If the folder holds a project already or is a file, or a line is damaged or was imported
        again since it was opened.
    InputError
        If it cannot be written; files written until then are removed.
    """  # noqa: DOC501 - `_not_writable_error` makes an InputError
    folder = Path(folder).absolute()
    try:
        if (folder / PROJECT_FILE_NAME).exists():
            raise ProjectError(error("project_folder.exists", folder=str(folder)))
        if folder.is_file():
            raise ProjectError(error("project_folder.is_file", folder=str(folder)))
    except OSError as failure:  # no permission to read the folder, or its name is too long
        raise _not_writable_error(folder, failure) from failure
    copy = replace(project, folder=folder)
    scans, clouds = dict(survey.scans), dict(survey.clouds)
    on_disk = {name: scan for name, scan in scans.items() if isinstance(scan, StoredLine)}
    places = {line.name: line_folder(copy, line) for line in copy.lines if line.name in on_disk}
    total, done = sum(scan.manifest.bytes for scan in on_disk.values()) or 1, 0
    with removed_on_failure(copy), ExitStack() as stack:
        try:
            if places or (folder / LINES_FOLDER).is_dir():
                stack.enter_context(_marked_unfinished(folder))
            for name, destination in places.items():
                stored = on_disk[name]
                _copy_line(stored, destination, done, total, progress)
                done += stored.manifest.bytes
                _use_stored_line(scans, clouds, name, replace(stored, folder=destination))
        except OSError as failure:
            raise _not_writable_error(folder, failure) from failure
        with _remove_points_on_failure(folder):
            digest = write_project(copy, expected="")
    return replace(copy, file_digest=digest), replace(survey, scans=scans, clouds=clouds)


def _not_writable_error(folder: Path, failure: OSError) -> InputError:
    reason = system_reason(failure)
    return InputError(error("project_folder.not_writable", folder=str(folder), reason=reason))


@contextmanager
def _remove_points_on_failure(folder: Path) -> Iterator[None]:
    """Remove the files of points again if the project cannot be written.

    Raises
    ------
    InputError
        If the project cannot be written.
    """
    sightings = folder / SIGHTINGS_FOLDER
    new = not sightings.exists()
    try:
        yield
    except InputError:
        if new:
            shutil.rmtree(sightings, ignore_errors=True)
        raise


@contextmanager
def _marked_unfinished(folder: Path) -> Iterator[None]:
    """Treat the lines copied into a folder as unfinished until the project is written.

    `_copy_line` marks each copy; the marks are removed here. The remains of an earlier, interrupted
    save are removed first: only files of the program in folders with the mark.

    Raises
    ------
    ProjectError
        If another save into the folder is in progress.
    """
    lines = folder / LINES_FOLDER
    require_no_link(lines)
    lines.mkdir(parents=True, exist_ok=True)
    with ExitStack() as locks:
        try:
            locks.enter_context(lock_folder(lines))
        except ProjectError as failure:
            raise ProjectError(error("project_folder.being_saved", folder=str(folder))) from failure
        _remove_unfinished(lines)
        try:
            yield
        except BaseException:
            _remove_unfinished(lines)
            raise
        for mark in lines.glob(f"*/{UNFINISHED_MARK}"):
            mark.unlink(missing_ok=True)
    with suppress(OSError):  # left behind on systems that cannot remove open files
        (lines / LOCK_FILE).unlink(missing_ok=True)


def _remove_unfinished(lines: Path) -> None:
    for mark in lines.glob(f"*/{UNFINISHED_MARK}"):
        store = mark.parent
        if is_link(store):
            continue
        for columns in columns_folders(store):
            if not is_link(columns):
                remove_columns(columns)
        remove_manifest_parts(store)
        for name in (MANIFEST_FILE, UNFINISHED_MARK):
            (store / name).unlink(missing_ok=True)
        if not any(store.iterdir()):
            store.rmdir()


def _use_stored_line(
    scans: dict[str, Line], clouds: dict[str, Cloud], name: str, stored: StoredLine
) -> None:
    scans[name] = stored
    cloud = clouds[name]
    if isinstance(cloud, CloudOnDisk):
        clouds[name] = CloudOnDisk(stored, cloud.place)


def _copy_line(
    stored: StoredLine, destination: Path, done: int, total: int, progress: Progress
) -> None:
    """Copy a stored line and verify it; the manifest is copied last.

    Raises
    ------
    ProjectError
        If the line has been imported again or is damaged, or the destination contains files.
    """
    manifest = stored.manifest
    require_no_link(destination.parent, destination)
    if destination.is_dir() and any(destination.iterdir()):
        raise ProjectError(error("project_folder.has_files", folder=str(destination)))
    destination.mkdir(exist_ok=True)
    (destination / UNFINISHED_MARK).touch()
    (destination / manifest.folder).mkdir()
    checksums: dict[str, int | None] = {column.file: column.checksum for column in manifest.files}
    if stored_header(stored) is not None:
        checksums |= {HEADER_FILE: None, HEADER_CHECKSUM_FILE: None}
    for name, checksum in checksums.items():
        path, found = stored.folder / manifest.folder / name, 0
        try:
            source = path.open("rb")
        except FileNotFoundError as failure:
            raise stored.reimport_error_or(
                ProjectError(error("import.part_missing", file=str(path), line=stored.name))
            ) from failure
        place = destination / manifest.folder / name
        with source, place.open("xb") as copy:
            then = os.fstat(source.fileno())  # the file may be renamed or deleted during the copy
            while piece := source.read(COPY_PIECE_BYTES):
                progress(min(done / total, 1.0), gettext_lazy("Copying {line}", line=stored.name))
                copy.write(piece)
                found = crc32(piece, found)
                done += len(piece)
        if checksum is not None and found != checksum:
            raise stored.reimport_error_or(
                ProjectError(error("import.part_changed", file=str(path), line=stored.name))
            )
        os.utime(place, ns=(then.st_atime_ns, then.st_mtime_ns))
    write_manifest(destination, manifest)
