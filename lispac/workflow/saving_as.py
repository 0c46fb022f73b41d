"""Saving a project in another folder, with the lines that were imported into it."""

import shutil
from dataclasses import replace
from pathlib import Path

from lispac.errors import InputError, ProjectError
from lispac.io.project_file import FILE_NAME, write_project
from lispac.progress import Progress, no_progress
from lispac.project import Project
from lispac.survey.cloud import Cloud, CloudOnDisk, Line
from lispac.survey.store.layout import MANIFEST
from lispac.survey.store.reading import StoredLine
from lispac.workflow.importing import HEADER, kept_header, line_folder
from lispac.workflow.projects import taken_back
from lispac.workflow.survey import Survey

PIECE = 1 << 24  # bytes copied at once


def save_project_as(
    project: Project, survey: Survey, folder: Path, *, progress: Progress = no_progress
) -> tuple[Project, Survey]:
    """Save a project in a folder of its own; what it was opened from stays as it is.

    The survey's files stay where they are; lines that were imported into the project are copied, so
    that they are there where their files are gone.

    Returns
    -------
    project : Project
        In that folder.
    survey : Survey
        That reads its lines from there.

    Raises
    ------
    ProjectError
        Where the folder holds a project already.
    InputError
        Where it cannot be written; nothing is left there then.
    """
    folder = Path(folder).absolute()
    if (folder / FILE_NAME).exists():
        raise ProjectError(f"{folder}: there is a project here already; choose another folder.")
    moved = replace(project, folder=folder)
    scans, clouds = dict(survey.scans), dict(survey.clouds)
    on_disk = {name: scan for name, scan in scans.items() if isinstance(scan, StoredLine)}
    total, done = sum(scan.manifest.bytes for scan in on_disk.values()) or 1, 0
    with taken_back(moved):
        try:
            for line in moved.lines:
                if line.name not in on_disk:
                    continue
                stored = on_disk[line.name]
                there = line_folder(moved, line)
                _copy(stored, there, done, total, progress)
                done += stored.manifest.bytes
                _point_to(scans, clouds, line.name, replace(stored, folder=there))
        except OSError as error:
            raise InputError(
                f"{folder}: the project cannot be written here ({error.strerror or error}); "
                "choose another folder."
            ) from error
        write_project(moved)
    return moved, replace(survey, scans=scans, clouds=clouds)


def _point_to(
    scans: dict[str, Line], clouds: dict[str, Cloud], name: str, stored: StoredLine
) -> None:
    scans[name] = stored
    cloud = clouds[name]
    if isinstance(cloud, CloudOnDisk):
        clouds[name] = CloudOnDisk(stored, cloud.place)


def _copy(stored: StoredLine, there: Path, done: int, total: int, progress: Progress) -> None:
    """Copy a stored line; what makes it count, the manifest, comes last."""
    manifest = stored.manifest
    (there / manifest.folder).mkdir(parents=True)
    names = [f"{manifest.folder}/{column.file}" for column in manifest.files]
    if kept_header(stored) is not None:
        names.append(f"{manifest.folder}/{HEADER}")
    for name in [*names, MANIFEST]:
        with (stored.folder / name).open("rb") as source, (there / name).open("wb") as copy:
            while piece := source.read(PIECE):
                progress(min(done / total, 1.0), f"Copying {stored.name}")
                copy.write(piece)
                done += len(piece)
        shutil.copystat(stored.folder / name, there / name)
