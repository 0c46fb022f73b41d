"""``lispac locate``: set the new location of the files of a project."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.console import opened_project
from lispac.errors import InputError
from lispac.message_texts import message_text
from lispac.messages import error

if TYPE_CHECKING:
    from lispac.project import Project


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "folder",
        type=Path,
        metavar="FOLDER",
        help="folder to search for the files, including its subfolders",
    )


def run(arguments: Namespace) -> None:
    """Set the paths of the files that are found in the folder, and save the project.

    Raises
    ------
    InputError
        If the folder does not exist or files are still missing; the files found are saved.
    """
    from lispac.workflow.project.moved_files import file_moved_note, missing_files, with_files_in
    from lispac.workflow.project.projects import open_project_with_notes, save_project

    if not arguments.folder.is_dir():
        raise InputError(error("cli.no_folder", folder=str(arguments.folder)))
    with opened_project(arguments.project, change=True):
        before, notes = open_project_with_notes(arguments.project)
        for note in notes:
            print(message_text(note))
        after = with_files_in(before, arguments.folder.absolute())
        save_project(after)
    for path in sorted(_project_files(after) - _project_files(before)):
        print(message_text(file_moved_note(path)))
    missing = missing_files(after)
    if missing:
        folder, names = str(arguments.folder), [path.name for path in missing]
        raise InputError(error("cli.files_not_found", folder=folder, count=len(names), names=names))
    if after is before and not notes:
        print("No file is missing.")


def _project_files(project: Project) -> set[Path]:
    accuracy = () if project.accuracy is None else (project.accuracy,)
    return {project.trajectory, *accuracy, *(line.path for line in project.lines)}
