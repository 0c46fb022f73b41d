"""Creation, opening and saving of projects."""

import shutil
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from lispac.errors import InputError, ProjectError
from lispac.identity import EMPTY_IDENTITY, Identity
from lispac.io.files import require_file
from lispac.io.project.project_file import (
    PROJECT_FILE_NAME,
    UNSAVED_NAME,
    project_folder,
    read_project,
    read_unsaved,
    write_project,
)
from lispac.io.project.project_lock import NO_TIME_LIMIT, project_lock
from lispac.messages import Message, error
from lispac.progress import Progress, no_progress
from lispac.project import LineSource, Project, Reading, Settings, Triple
from lispac.survey.line_source import DEFAULT_READING
from lispac.workflow.importing.file_reading import default_or_detected_reading
from lispac.workflow.importing.given_time_bases import (
    has_given_time_base,
    shift_lines_to_trajectory,
)
from lispac.workflow.importing.line_import import LINES_FOLDER, line_folder
from lispac.workflow.importing.line_split import split_line
from lispac.workflow.importing.time_rollovers import resolve_time_rollovers
from lispac.workflow.project.moved_files import with_files_beside
from lispac.workflow.project.survey import Survey, load_survey


def create_project(
    folder: Path,
    *,
    trajectory: Path,
    lines: Sequence[LineSource],
    settings: Settings,
    accuracy: Path | None = None,
    truth_deg: Triple | None = None,
    trajectory_reading: Reading = DEFAULT_READING,
    accuracy_reading: Reading = DEFAULT_READING,
    identity: Identity = EMPTY_IDENTITY,
    messages: tuple[Message, ...] = (),
    reading_warnings: tuple[Message, ...] = (),
) -> Project:
    """Create a project folder that refers to the files of the survey.

    Raises
    ------
    ProjectError
        If the folder already holds a project.
    InputError
        If a file is missing, there is no line, two lines have the same name, or a setting is not
        valid.
    """
    folder = Path(folder).absolute()
    require_file(trajectory, "trajectory")
    if accuracy is not None:
        require_file(accuracy, "trajectory accuracy")
    for line in lines:
        require_file(line.path, "line")
    settings.require_sound()
    project = Project(
        folder=folder,
        trajectory=Path(trajectory).absolute(),
        lines=tuple(replace(n, path=Path(n.path).absolute()) for n in lines),
        settings=settings,
        accuracy=None if accuracy is None else Path(accuracy).absolute(),
        truth_deg=truth_deg,
        trajectory_reading=trajectory_reading,
        accuracy_reading=accuracy_reading,
        identity=identity,
        data_messages=messages,
        reading_warnings=reading_warnings,
    )
    _require_new_folder(project)
    digest = write_project(project, expected="")
    return replace(project, file_digest=digest)


def _require_new_folder(project: Project) -> None:
    if (project.folder / PROJECT_FILE_NAME).exists():
        raise ProjectError(error("project_folder.exists", folder=str(project.folder)))
    if not project.lines:
        raise InputError(error("project_line.none"))
    _require_line_names(project)


def _require_line_names(project: Project) -> None:
    names = [line.name for line in project.lines]
    for name in names:
        if names.count(name) > 1:
            raise InputError(error("project_line.same_name", line=name))


def new_project(
    folder: Path,
    *,
    trajectory: Path,
    lines: Sequence[LineSource],
    settings: Settings,
    accuracy: Path | None = None,
    truth_deg: Triple | None = None,
    trajectory_reading: Reading = DEFAULT_READING,
    accuracy_reading: Reading = DEFAULT_READING,
    identity: Identity = EMPTY_IDENTITY,
    resolved: bool = False,
    split_by: str = "",
    progress: Progress = no_progress,
) -> tuple[Project, Survey]:
    """Read the survey to check its files, then create its project.

    The reading options are completed here, from given and detected values; the survey's notes list
    what was detected. The project keeps the warnings about it.

    Parameters
    ----------
    truth_deg : degrees, optional
        True boresight of a simulated survey.
    resolved : bool
        Whether the reading options are already complete, as in an existing project.
    split_by : str
        Attribute, or ``gap``, by which files are split into lines; see `split_line`.

    Raises
    ------
    ProjectError
        If the folder contains a project already.
    InputError
        As for `create_project` and `load_survey`; a folder created for the project is then removed.
    """
    settings.require_sound()
    draft = Project(
        folder=Path(folder).absolute(),
        trajectory=trajectory,
        lines=tuple(lines),
        settings=settings,
        accuracy=accuracy,
    )
    _require_new_folder(draft)
    notes: tuple[Message, ...] = ()
    known = tuple(lines)
    if not resolved:
        known, trajectory_reading, accuracy_reading, notes = complete_readings(
            known, trajectory, trajectory_reading, accuracy, accuracy_reading
        )
    if split_by:
        known = tuple(part for line in known for part in split_line(line, split_by))
    draft = replace(
        draft, lines=known, trajectory_reading=trajectory_reading,
        accuracy_reading=accuracy_reading, reading_warnings=_warnings_of(notes),
    )  # fmt: skip
    _require_line_names(draft)
    with removed_on_failure(draft):
        survey = load_survey(draft, progress=progress)
        project = create_project(
            folder, trajectory=trajectory, lines=known, settings=settings, accuracy=accuracy,
            truth_deg=truth_deg, trajectory_reading=trajectory_reading,
            accuracy_reading=accuracy_reading, identity=identity, messages=survey.messages,
            reading_warnings=draft.reading_warnings,
        )  # fmt: skip
    return project, _with_notes(survey, notes)


def _warnings_of(messages: Iterable[Message]) -> tuple[Message, ...]:
    return tuple(each for each in messages if each.is_serious)


def _with_notes(survey: Survey, messages: Iterable[Message]) -> Survey:
    """Survey with the notes among the messages added; its own messages include the warnings."""
    added = (each for each in messages if not each.is_serious)
    return replace(survey, notes=(*added, *survey.notes))


def complete_readings(
    lines: Sequence[LineSource],
    trajectory: Path,
    trajectory_reading: Reading,
    accuracy: Path | None,
    accuracy_reading: Reading,
) -> tuple[tuple[LineSource, ...], Reading, Reading, tuple[Message, ...]]:
    """Complete the given reading options of all files of a new project with detected ones.

    Returns
    -------
    lines, trajectory_reading, accuracy_reading : complete
    notes : tuple of Message

    Raises
    ------
    InputError
        If a file cannot be read, or does not agree with the given options.
    """
    base_given = bool(dict(trajectory_reading.options).get("time"))
    trajectory_reading, notes = default_or_detected_reading(
        trajectory, "trajectory", trajectory_reading
    )
    if accuracy is not None:
        accuracy_reading, extra = default_or_detected_reading(
            accuracy, "accuracy", accuracy_reading
        )
        notes += extra
    known, extra = _lines_with_readings(lines)
    notes += extra
    known, extra = shift_lines_to_trajectory(
        known, [line.reading for line in lines], trajectory, trajectory_reading,
        trajectory_given=base_given,
    )  # fmt: skip
    return known, trajectory_reading, accuracy_reading, notes + extra


def with_lines_added(
    project: Project, lines: Sequence[LineSource], *, progress: Progress = no_progress
) -> tuple[Project, Survey]:
    """Add lines to a project and read its survey.

    Targets and the result are kept; the results of alternative methods, which use all lines, are
    cleared. The reading options are completed as in `new_project`. The project on disk is not
    changed.

    Raises
    ------
    ProjectError
        If the project already has a line with the same file and reading options.
    InputError
        If a line has the name of another line, or cannot be read; data imported for it are then
        removed.
    """
    for line in lines:
        for known in project.lines:
            if known.path == Path(line.path).absolute() and known.reading == line.reading:
                raise ProjectError(
                    error("project_line.known", file=str(line.path), line=known.name)
                )
    added, notes = _lines_with_readings(lines)
    added, extra = shift_lines_to_trajectory(
        added, [line.reading for line in lines], project.trajectory, project.trajectory_reading,
        trajectory_given=has_given_time_base(project.trajectory, project.trajectory_reading),
    )  # fmt: skip
    notes += extra
    edited = replace(
        project,
        lines=(*project.lines, *(replace(n, path=Path(n.path).absolute()) for n in added)),
        alternative_results=(),
        reading_warnings=(*project.reading_warnings, *_warnings_of(notes)),
    )
    _require_line_names(edited)
    with removed_on_failure(edited):
        survey = load_survey(edited, progress=progress)
    edited = edited.with_data_messages(survey.messages)
    return edited, _with_notes(survey, notes)


def _lines_with_readings(
    lines: Sequence[LineSource],
) -> tuple[tuple[LineSource, ...], tuple[Message, ...]]:
    """Lines with complete reading options, and messages about their files."""
    known: list[LineSource] = []
    notes: tuple[Message, ...] = ()
    for line in lines:
        named = bool(line.columns)
        reading, extra = default_or_detected_reading(
            line.path, "points", line.reading, columns=named
        )
        known.append(replace(line, reading=reading))
        notes += extra
    counted, extra = resolve_time_rollovers(known)
    return counted, notes + extra


@contextmanager
def removed_on_failure(project: Project) -> Iterator[None]:
    """Remove the newly imported lines of a project if the ``with`` block fails.

    Files that were in the folder before are kept.
    """
    stores = [line_folder(project, line) for line in project.lines]
    new = [store for store in stores if not store.exists()]
    made = [path for path in (project.folder / LINES_FOLDER, project.folder) if not path.exists()]
    try:
        yield
    except BaseException:
        for store in new:
            shutil.rmtree(store, ignore_errors=True)
        for path in made:
            if path.is_dir() and not any(path.iterdir()):
                path.rmdir()
        raise


def open_project(folder: Path) -> Project:
    """Open a project by its folder, its ``project.json`` or the file that opens it.

    Missing files are searched for in the folder of the project and in the one that contains it.

    Raises
    ------
    ProjectError
        If there is no valid project.
    """
    return open_project_with_notes(folder)[0]


@contextmanager
def locked_project(
    folder: Path, *, waiting: Callable[[], None] = lambda: None
) -> Iterator[Project]:
    """Open a project, locked against changes by other programs until the block ends.

    If another program is changing the project, the function waits.

    Parameters
    ----------
    waiting : callable
        Called once if it has to wait.

    Raises
    ------
    ProjectError
        If there is no valid project, or another program has locked it.
    InputError
        If the folder cannot be written.
    """
    place = project_folder(folder)
    with project_lock(place, wait=NO_TIME_LIMIT, waiting=waiting):
        yield open_project(place)


def open_project_with_notes(folder: Path) -> tuple[Project, tuple[Message, ...]]:
    """Open a project, with notes on files that were found elsewhere.

    Raises
    ------
    ProjectError
        If there is no valid project.
    """
    return with_files_beside(read_project(folder))


@dataclass(frozen=True, eq=False)
class UnsavedProject:
    """Unsaved state of a project, recovered after a crash.

    Attributes
    ----------
    kept, saved : float, seconds since 1970
        Times at which the unsaved state and the project were written.
    """

    project: Project
    kept: float
    saved: float


def read_unsaved_project(folder: Path) -> UnsavedProject | None:
    """Read the unsaved project after a crash; None if there is none.

    Raises
    ------
    ProjectError
        If it is damaged.
    """
    project = read_unsaved(folder)
    if project is None:
        return None
    project, _ = with_files_beside(project)
    kept, saved = (folder / name for name in (UNSAVED_NAME, PROJECT_FILE_NAME))
    return UnsavedProject(project, kept.stat().st_mtime, saved.stat().st_mtime)


def require_folder(project: Project) -> None:
    """Refuse an open project whose folder no longer exists.

    Saving would create a new folder at the old place, without the lines and the trajectory.

    Raises
    ------
    InputError
        If it was moved, renamed or removed meanwhile.
    """
    if not project.folder.is_dir():
        raise InputError(error("project_folder.gone", folder=str(project.folder)))


def save_project(project: Project, *, expected: str | None = None) -> Project:
    """Save a project into its folder; parameters and errors as `write_project`.

    Returns
    -------
    Project
        With the digest of its new file.
    """
    return replace(project, file_digest=write_project(project, expected=expected))
