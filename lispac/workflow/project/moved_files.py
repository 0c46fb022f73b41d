"""Search for the files of a moved project, near the project or in a folder given by the user.

A project refers to its files by paths. If the project or the files are moved, the files are found
by the ends of their paths, for example ``raw/line1.laz``. In a folder given by the user, the other
files are also found by their names in all subfolders, if a name occurs only once. When the survey
is read, the points of a line are checked to make sure that targets were picked in the same file.
"""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path, PurePosixPath

from lispac.errors import InputError
from lispac.messages import Message, error, note
from lispac.project import Project
from lispac.survey.line_source import printable
from lispac.survey.store.layout import has_complete_import
from lispac.workflow.importing.line_import import line_folder

MAX_LISTED_FILES = 3
"""Largest number of missing files named in a message."""
MAX_SEARCHED_FILES = 20_000
"""Number of files and folders after which a search by name ends; the search of a whole disk would
take minutes."""


def missing_files(project: Project) -> tuple[Path, ...]:
    """Missing files of the project that are needed to read its survey.

    An imported line no longer needs its file.
    """
    lines = (
        line.path for line in project.lines if not has_complete_import(line_folder(project, line))
    )
    accuracy = () if project.accuracy is None else (project.accuracy,)
    needed = dict.fromkeys((project.trajectory, *accuracy, *lines))
    return tuple(path for path in needed if not path.exists())


def with_files_in(project: Project, folder: Path) -> Project:
    """Update the paths of missing files that are found in a folder, by path end or unique name.

    Raises
    ------
    InputError
        If none of the missing files is found.
    """
    missing = missing_files(project)
    ends = {path: _find_by_path_end(path, folder) for path in missing}
    found = {path: now for path, now in ends.items() if now is not None}
    rest = {path for path in missing if path not in found}
    found |= _find_by_name(rest, folder) if rest else {}
    if missing and not found:
        is_short = len(missing) <= MAX_LISTED_FILES
        raise InputError(
            error(
                "project_files.none_found" if is_short else "project_files.none_of_many_found",
                folder=str(folder), count=len(missing), files=_file_names(missing),
            )
        )  # fmt: skip
    return _with_paths(project, found)


def with_files_beside(project: Project) -> tuple[Project, tuple[Message, ...]]:
    """Update the paths of missing files that are found near the project, with a note on each.

    The files are searched for by the ends of their paths, in the project's folder and in the folder
    that contains it.
    """
    found: dict[Path, Path] = {}
    for path in missing_files(project):
        for place in (project.folder, project.folder.parent):
            now = _find_by_path_end(path, place)
            if now is not None:
                found[path] = now
                break
    return _with_paths(project, found), tuple(map(file_moved_note, found.values()))


def file_moved_note(path: Path) -> Message:
    """Note on the new path of a file that was moved."""
    return note("project_files.moved", file=printable(path.name), folder=str(path.parent))


def with_files_of(project: Project, other: Project) -> Project:
    """Replace the paths of missing files by those in another state of the project.

    Lines are matched by name.
    """
    missing = missing_files(project)
    if not missing:
        return project
    now = {line.name: line.path for line in other.lines}
    pairs = [(line.path, now.get(line.name)) for line in project.lines]
    pairs += [(project.trajectory, other.trajectory)]
    if project.accuracy is not None:
        pairs += [(project.accuracy, other.accuracy)]
    changed = {old: new for old, new in pairs if old in missing and new is not None}
    return _with_paths(project, changed)


def require_files(project: Project) -> None:
    """Refuse a project with missing files.

    Raises
    ------
    InputError
        If a file of the project is missing.
    """
    first, *others = missing_files(project) or (None,)
    if first is None:
        return
    if not others:
        raise InputError(error("project_files.one_missing", file=str(first)))
    is_short = len(others) <= MAX_LISTED_FILES
    raise InputError(
        error(
            "project_files.several_missing" if is_short else "project_files.many_missing",
            file=str(first), count=len(others), others=_file_names(others),
        )
    )  # fmt: skip


def _file_names(paths: Sequence[Path]) -> list[str]:
    return [path.name for path in paths[:MAX_LISTED_FILES]]


def _find_by_path_end(path: Path, folder: Path) -> Path | None:
    """File in or below a folder whose path has the longest common end with the former path."""
    parts = PurePosixPath(path.as_posix()).parts
    for start in range(1, len(parts)):
        now = folder.joinpath(*parts[start:])
        if now.is_file():
            return now
    return None


def _find_by_name(paths: set[Path], folder: Path) -> dict[Path, Path]:
    """Files in or below a folder whose names occur only once there, by their former paths.

    Only about the first `MAX_SEARCHED_FILES` files and folders are searched.
    """
    seen, places = 0, {path.name: list[Path]() for path in paths}
    for place, folders, files in os.walk(folder):
        seen += len(folders) + len(files)
        for name in places.keys() & set(files):
            places[name].append(Path(place) / name)
        if seen > MAX_SEARCHED_FILES:
            break
    return {path: places[path.name][0] for path in paths if len(places[path.name]) == 1}


def _with_paths(project: Project, paths: Mapping[Path, Path]) -> Project:
    if not paths:
        return project
    accuracy = project.accuracy
    return replace(
        project,
        trajectory=paths.get(project.trajectory, project.trajectory),
        accuracy=None if accuracy is None else paths.get(accuracy, accuracy),
        lines=tuple(replace(line, path=paths.get(line.path, line.path)) for line in project.lines),
    )
