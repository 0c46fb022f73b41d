"""Files of a moved project: found beside it, or at a place given by the user.

A project points at its files from its own folder. Where only one of both is moved, to another disk
or computer, the files are sought by the ends of their paths: what lay in ``raw/line1.laz`` is the
same in another place. That a line is the one that targets were picked on is told by its points
when the survey is read.
"""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path, PurePosixPath

from lispac.errors import InputError
from lispac.messages import Message, error, note
from lispac.project import Project
from lispac.survey.source import printable
from lispac.survey.store.layout import is_imported
from lispac.workflow.importing import line_folder

MOST_NAMED = 3
"""Missing files that a message names."""
MOST_LOOKED_AT = 20_000
"""Files and folders; a whole disk would be looked through for minutes."""


def missing(project: Project) -> tuple[Path, ...]:
    """Files of the project that are not there and that its survey cannot be read without.

    A line that was imported needs its file no more.
    """
    lines = (line.path for line in project.lines if not is_imported(line_folder(project, line)))
    accuracy = () if project.accuracy is None else (project.accuracy,)
    needed = dict.fromkeys((project.trajectory, *accuracy, *lines))
    return tuple(path for path in needed if not path.exists())


def with_files_in(project: Project, folder: Path) -> Project:
    """Point a project at those of its missing files that are in a folder, or in one below it.

    Raises
    ------
    InputError
        Where none of them is there.
    """
    gone = missing(project)
    ends = {path: _by_its_end(path, folder) for path in gone}
    found = {path: now for path, now in ends.items() if now is not None}
    rest = {path for path in gone if path not in found}
    found |= _by_name_alone(rest, folder) if rest else {}
    if gone and not found:
        few = len(gone) <= MOST_NAMED
        raise InputError(
            error(
                "project_files.none_found" if few else "project_files.none_of_many_found",
                folder=str(folder), count=len(gone), files=_names(gone),
            )
        )  # fmt: skip
    return _pointing(project, found)


def with_files_beside(project: Project) -> tuple[Project, tuple[Message, ...]]:
    """Point a project at missing files in its folder or beside it, and return which."""
    found: dict[Path, Path] = {}
    for path in missing(project):
        for place in (project.folder, project.folder.parent):
            now = _by_its_end(path, place)
            if now is not None:
                found[path] = now
                break
    return _pointing(project, found), tuple(map(moved_note, found.values()))


def moved_note(path: Path) -> Message:
    """The note on where a file is read from that is no longer where it was."""
    return note("project_files.moved", file=printable(path.name), folder=str(path.parent))


def with_files_of(project: Project, other: Project) -> Project:
    """Point a project at the files of another state of it, line by line, where its own are gone."""
    gone = missing(project)
    if not gone:
        return project
    now = {line.name: line.path for line in other.lines}
    pairs = [(line.path, now.get(line.name)) for line in project.lines]
    pairs += [(project.trajectory, other.trajectory)]
    if project.accuracy is not None:
        pairs += [(project.accuracy, other.accuracy)]
    return _pointing(project, {was: is_ for was, is_ in pairs if was in gone and is_ is not None})


def require_files(project: Project) -> None:
    """Refuse a project whose files are not there.

    Raises
    ------
    InputError
    """
    first, *more = missing(project) or (None,)
    if first is None:
        return
    if not more:
        raise InputError(error("project_files.one_missing", file=str(first)))
    few = len(more) <= MOST_NAMED
    raise InputError(
        error(
            "project_files.several_missing" if few else "project_files.many_missing",
            file=str(first), count=len(more), others=_names(more),
        )
    )  # fmt: skip


def _names(paths: Sequence[Path]) -> list[str]:
    return [path.name for path in paths[:MOST_NAMED]]


def _by_its_end(path: Path, folder: Path) -> Path | None:
    """The file in a folder that has as much of the former path's end as there is."""
    parts = PurePosixPath(path.as_posix()).parts
    for start in range(1, len(parts)):
        now = folder.joinpath(*parts[start:])
        if now.is_file():
            return now
    return None


def _by_name_alone(paths: set[Path], folder: Path) -> dict[Path, Path]:
    """Files below a folder of which there is only one with the name."""
    seen, places = 0, {path.name: list[Path]() for path in paths}
    for place, folders, files in os.walk(folder):
        seen += len(folders) + len(files)
        for name in places.keys() & set(files):
            places[name].append(Path(place) / name)
        if seen > MOST_LOOKED_AT:
            break
    return {path: places[path.name][0] for path in paths if len(places[path.name]) == 1}


def _pointing(project: Project, found: Mapping[Path, Path]) -> Project:
    if not found:
        return project
    accuracy = project.accuracy
    return replace(
        project,
        trajectory=found.get(project.trajectory, project.trajectory),
        accuracy=None if accuracy is None else found.get(accuracy, accuracy),
        lines=tuple(replace(line, path=found.get(line.path, line.path)) for line in project.lines),
    )
