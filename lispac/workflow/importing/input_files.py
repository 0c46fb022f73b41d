"""Files to be imported: sorted by role, checked against each other.

An `InputFiles` is an immutable value; each edit in the window makes a new one. Files are examined
in `input_file`, and the messages about them are in `input_file_messages`.
"""

import os
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Literal

from lispac.identity import EMPTY_IDENTITY, Identity
from lispac.installation_paths import expand_user, home_folder
from lispac.io.format_types import POSSIBLE, Kind
from lispac.io.project.project_file import PROJECT_FILE_NAME, is_project_file
from lispac.messages import Action, Level, Message, error, note
from lispac.project import LineSource, Project, Settings
from lispac.survey.known_time_base import KnownTimeBase
from lispac.survey.line_source import DEFAULT_READING, Reading, printable
from lispac.survey.time_base import TimeBase, plausible_bases
from lispac.survey.time_quality import TrajectoryCoverage
from lispac.survey.trajectory import DEFAULT_LONGEST_GAP_S, Trajectory, TrajectoryAccuracy
from lispac.workflow.importing.input_columns import with_meaning
from lispac.workflow.importing.input_file import InputFile
from lispac.workflow.importing.input_file_messages import (
    BRIDGE_GAPS_CODE,
    OPTION_SETTING_ACTIONS,
    already_in_project_error,
    file_messages,
    time_messages,
    without_project_changes,
)
from lispac.workflow.importing.input_times import (
    line_coverage,
    proposed_shift,
    trajectory_time_base,
    with_time_base_shifts,
)

State = Literal["pending", "fine", "warning", "error", "out"]

MAX_FILES_PER_FOLDER = 500
"""Largest number of files taken from one folder; a survey rarely has more."""


@dataclass(frozen=True)
class ImportRequest:
    """Arguments for the creation of a new project."""

    folder: Path
    trajectory: Path
    accuracy: Path | None
    lines: tuple[LineSource, ...]
    settings: Settings
    trajectory_reading: Reading = DEFAULT_READING
    accuracy_reading: Reading = DEFAULT_READING
    identity: Identity = EMPTY_IDENTITY


def find_project(paths: Iterable[Path]) -> Path | None:
    """First project among files and folders, which is opened instead of imported."""
    for path in paths:
        if is_project_file(path):
            return path
        if (path / PROJECT_FILE_NAME).is_file():
            return path
    return None


def collect_files(paths: Iterable[Path]) -> tuple[Path, ...]:
    """Files among the paths, and files directly in folders among them.

    Hidden files in folders are skipped, and at most `MAX_FILES_PER_FOLDER` are taken from each.
    """
    found: list[Path] = []
    for path in paths:
        if path.is_dir():
            inside = sorted(p for p in path.iterdir() if p.is_file() and p.name[:1] != ".")
            found += inside[:MAX_FILES_PER_FOLDER]
        else:
            found.append(path)
    return tuple(dict.fromkeys(path.absolute() for path in found))


@dataclass(frozen=True, eq=False)
class InputFiles:
    """Files to be imported, each with its role, and the longest gap of the trajectory.

    Attributes
    ----------
    files : tuple of InputFile
        Files in the order in which they were added.
    longest_gap : float, seconds
    project : Project or None
        Project to which lines are added; None for a new project.
    """

    files: tuple[InputFile, ...] = ()
    longest_gap: float = DEFAULT_LONGEST_GAP_S
    project: Project | None = None

    @classmethod
    def of_project(cls, project: Project) -> "InputFiles":
        """Input files for an open project, which already has a trajectory and accuracies."""
        files = [
            InputFile(
                project.trajectory, role="trajectory", project_reading=project.trajectory_reading
            )
        ]
        if project.accuracy is not None:
            files.append(
                InputFile(
                    project.accuracy, role="accuracy", project_reading=project.accuracy_reading
                )
            )
        return cls(tuple(files), project.settings.longest_gap, project)

    # -- edits -------------------------------------------------------------------------------

    def with_files(self, paths: Iterable[Path]) -> "InputFiles":
        """Add files that are not in the list yet, without examining them."""
        known = {file.path for file in self.files}
        new = tuple(InputFile(path) for path in paths if path not in known)
        return replace(self, files=self.files + new)

    def without_file(self, path: Path) -> "InputFiles":
        """Remove a file from the list, unless it belongs to the open project."""
        kept = tuple(e for e in self.files if e.path != path or e.project_reading is not None)
        return replace(self, files=kept)

    def with_changed_file(self, file: InputFile) -> "InputFiles":
        """Replace a file by its changed state."""
        files = tuple(file if e.path == file.path else e for e in self.files)
        return replace(self, files=with_time_base_shifts(files))

    def with_role(self, path: Path, role: Kind | None) -> "InputFiles":
        """Change the role of a file, with its most likely format; requires a new examination."""
        file = self.file(path)
        if role == file.role or file.project_reading is not None:
            return self
        changed = replace(
            file, role=role, given_options=None, finding=None, remembered=False, shift=0.0
        )
        changed = replace(changed, format=next(iter(changed.formats), None))
        return self.with_changed_file(replace(changed, pending=role is not None, content=None))

    def with_format(self, path: Path, key: str) -> "InputFiles":
        """Read a file in another format; requires a new examination."""
        file = self.file(path)
        chosen = next(format for format in file.formats if format.key == key)
        return self.with_changed_file(
            replace(
                file, format=chosen, given_options=None, finding=None, pending=True,
                remembered=False,
            )
        )  # fmt: skip

    def with_option(self, path: Path, name: str, value: str) -> "InputFiles":
        """Set an option of a file; requires a new examination."""
        file = self.file(path)
        given = dict(file.given_options or {}) | {name: value}
        return self.with_changed_file(replace(file, given_options=given, pending=True))

    def with_column(self, path: Path, column: int, meaning: str) -> "InputFiles":
        """Set the meaning of a column; requires a new examination."""
        file = self.file(path)
        tokens = with_meaning(file.columns, column, meaning)
        changed = self.with_option(path, "columns", " ".join(tokens))
        return changed.with_changed_file(replace(changed.file(path), remembered=False))

    def with_action(self, path: Path, action: Action) -> "InputFiles":
        """Apply an action of a message; a file whose options change has to be read again.

        Actions that ask the user for a value have no effect here.
        """
        params, file = action.params, self.file(path)
        if action.code in OPTION_SETTING_ACTIONS:
            return self.with_option(path, str(params["name"]), str(params["value"]))
        match action.code:
            case code if code == BRIDGE_GAPS_CODE:
                return replace(self, longest_gap=_require_number(params["gap"]))
            case "shift_times":
                return self.with_changed_file(replace(file, shift=_require_number(params["shift"])))
            case "clear_shift":
                return self.with_changed_file(replace(file, shift=0.0))
            case "leave_out":
                return self.with_role(path, None)
            case "split_line":
                return self.with_changed_file(replace(file, split_by=str(params["by"])))
            case "keep_one_line":
                return self.with_changed_file(replace(file, split_by=""))
            case "detect_columns":
                given = {k: v for k, v in (file.given_options or {}).items() if k != "columns"}
                changed = replace(file, given_options=given, remembered=False, finding=None)
                return self.with_changed_file(replace(changed, pending=True))
        return self

    def with_shift_for_all(self) -> "InputFiles":
        """Apply the proposed time shifts of all lines."""
        changed = self
        for file, shift in self.proposed_shifts:
            changed = changed.with_changed_file(replace(file, shift=shift))
        return changed

    def with_resolved_role(self, path: Path) -> "InputFiles":
        """Determine an ambiguous role of a file from the other files.

        A text that may be a trajectory is a line if another file is certainly the trajectory.
        """
        file = self.file(path)
        surest = {
            e.path: e.checks[0].confidence for e in self.files_of_role("trajectory") if e.checks
        }
        if file.role != "trajectory" or "points" not in file.roles or len(surest) < 2:
            return self
        if surest[path] <= POSSIBLE and max(surest.values()) > POSSIBLE:
            return self.with_role(path, "points")
        return self

    # -- content -----------------------------------------------------------------------------

    def file(self, path: Path) -> InputFile:
        """File with a given path."""
        return next(file for file in self.files if file.path == path)

    def files_of_role(self, role: Kind) -> tuple[InputFile, ...]:
        """Files that have a role, in their order."""
        return tuple(file for file in self.files if file.role == role)

    @property
    def trajectory(self) -> InputFile | None:
        """File of the trajectory, the first if there are several."""
        return next(iter(self.files_of_role("trajectory")), None)

    @property
    def accuracy(self) -> InputFile | None:
        """File of the accuracies of the trajectory."""
        return next(iter(self.files_of_role("accuracy")), None)

    @property
    def lines(self) -> tuple[InputFile, ...]:
        """Files of lines."""
        return self.files_of_role("points")

    @property
    def trajectory_content(self) -> Trajectory | None:
        """Trajectory read from its file; None if it has not been read."""
        file = self.trajectory
        content = None if file is None else file.content
        return content if isinstance(content, Trajectory) else None

    @property
    def accuracy_content(self) -> TrajectoryAccuracy | None:
        """Accuracies read from their file; None if they have not been read."""
        file = self.accuracy
        content = None if file is None else file.content
        return content if isinstance(content, TrajectoryAccuracy) else None

    @property
    def _base(self) -> KnownTimeBase:
        return trajectory_time_base(self.trajectory)

    @property
    def time_base(self) -> TimeBase | None:
        """Time base of the trajectory: that of its options, else the most plausible for its times.

        None if its options have none and its times have not been read or do not fit any.
        """
        if self._base.base is not None:
            return self._base.base
        return (
            next(iter(plausible_bases(self.trajectory_content.time)), None)
            if self.trajectory_content is not None
            else None
        )

    @cached_property
    def names(self) -> dict[Path, str]:
        """Name of each line: that of its file, preceded by that of the folder if not unique."""
        stems = [printable(file.path.stem) for file in self.lines]
        stems += [line.name for line in self._project_lines]
        return {
            file.path: (
                printable(file.path.stem)
                if stems.count(printable(file.path.stem)) == 1
                else printable(f"{file.path.parent.name}_{file.path.stem}")
            )
            for file in self.lines
        }

    @property
    def _project_lines(self) -> tuple[LineSource, ...]:
        return () if self.project is None else self.project.lines

    def coverage(self, file: InputFile) -> TrajectoryCoverage | None:
        """Coverage of a line by the trajectory; None until both have been read."""
        return (
            None
            if self.trajectory_content is None
            else line_coverage(file, self.trajectory_content, self.longest_gap)
        )

    @cached_property
    def _messages(self) -> dict[Path, tuple[Message, ...]]:
        counts = len(self.files_of_role("trajectory")), len(self.files_of_role("accuracy"))
        found = {
            file.path: file_messages(file, self.trajectory, *counts, self.longest_gap)
            for file in self.files
        }
        if self.project is None:
            return found
        known = {line.path: line.name for line in self.project.lines}
        return {
            file.path: already_in_project_error(file, known)
            or without_project_changes(file, found[file.path])
            for file in self.files
        }

    def messages(self, file: InputFile) -> tuple[Message, ...]:
        """All messages about a file, errors first."""
        return self._messages[file.path]

    def time_messages(self, file: InputFile) -> tuple[Message, ...]:
        """Messages about the times of a line relative to those of the trajectory."""
        if self.trajectory_content is None or file.role != "points":
            return ()
        return tuple(time_messages(file, self.trajectory_content, self.longest_gap, self._base))

    def state_of_file(self, file: InputFile) -> State:
        """State of a file in the import."""
        if file.pending:
            return "pending"
        levels = {message.level for message in self.messages(file)}
        if Level.ERROR in levels:
            return "error"
        if file.role is None:
            return "out"
        return "warning" if Level.WARNING in levels else "fine"

    @cached_property
    def proposed_shifts(self) -> tuple[tuple[InputFile, float], ...]:
        """Time shifts proposed for lines with points outside the trajectory (`proposed_shift`)."""
        track = self.trajectory_content
        if track is None:
            return ()
        found = []
        for file in self.lines:
            best = proposed_shift(file, track, self.longest_gap, self._base.base)
            if best is not None:
                found.append((file, best.shift))
        return tuple(found)

    # -- new project -------------------------------------------------------------------------

    def import_problem(self, folder: str) -> Message | None:
        """Reason why no project can be made; None if one can."""
        return self.files_problem() or folder_problem(folder)

    def files_problem(self) -> Message | None:
        """Reason why the files cannot be imported; None if they can."""
        if not self.files:
            return note("import.no_files")
        if any(file.pending for file in self.files):
            return note("import.being_examined")
        wrong = [file for file in self.files if file.role and self.state_of_file(file) == "error"]
        if wrong:
            first = self.messages(wrong[0])[0]
            if len(wrong) == 1:
                return first
            return error("import.several_errors", first=first, count=len(wrong) - 1)
        if self.trajectory is None:
            return error("import.no_trajectory")
        if not self.lines:
            return error("import.no_line")
        names = [line.name for line in (*self.sources(), *self._project_lines)]
        duplicates = [name for name in names if names.count(name) > 1]
        if not duplicates:
            return None
        return error("import.duplicate_line_name", line=duplicates[0])

    def request(self, folder: Path, settings: Settings) -> ImportRequest:
        """Arguments for the new project; valid only if `import_problem` is None."""
        trajectory, accuracy = self.trajectory, self.accuracy
        assert trajectory is not None
        return ImportRequest(
            folder=folder,
            trajectory=trajectory.path,
            accuracy=None if accuracy is None else accuracy.path,
            lines=self.sources(),
            settings=replace(settings, longest_gap=self.longest_gap),
            trajectory_reading=trajectory.reading,
            accuracy_reading=DEFAULT_READING if accuracy is None else accuracy.reading,
        )

    def sources(self) -> tuple[LineSource, ...]:
        """Sources of the lines, for the project."""
        return tuple(
            line
            for file in self.lines
            for line in file.parts(LineSource(self.names[file.path], file.path, (), file.reading))
        )

    @property
    def column_mappings(self) -> dict[str, str]:
        """Chosen columns by the key of the layout of their files, for later imports."""
        return {
            file.layout: " ".join(file.columns)
            for file in self.files
            if file.role is not None and "columns" in (file.given_options or {}) and file.layout
        }


def folder_problem(folder: str) -> Message | None:
    """Reason why no project can be made in a folder; None if it can."""
    if not folder.strip():
        return note("import.no_folder")
    place = expand_user(Path(folder.strip()))
    if (place / PROJECT_FILE_NAME).exists():
        return error("import.folder_has_project")
    if place.is_file():
        return error("import.folder_is_file")
    existing = next((p for p in (place, *place.parents) if p.exists()), None)
    if existing is None or not os.access(existing, os.W_OK):
        return error("import.folder_not_writable", folder=str(existing or place))
    return None


def _require_number(value: object) -> float:
    """Parameter of an action, which must be a number."""
    assert isinstance(value, float | int)
    return float(value)


def proposed_folder(input_files: InputFiles) -> Path | None:
    """Folder that a project can be created in, as a suggestion; None if there is none.

    It is beside the folders of the data or, if that cannot be written, in the home folder.
    """
    used = [file for file in (input_files.trajectory, *input_files.lines) if file is not None]
    if not used:
        return None
    folders = {file.path.parent for file in used}
    data = used[0].path.parent
    with suppress(ValueError):  # files on two drives
        common = Path(os.path.commonpath(folders))
        data = common if common.name else data  # not the root of the drive
    beside = data.parent if data in folders else data
    for folder in (beside, home_folder()):
        for number in ("", *(f"-{k}" for k in range(2, 20))):
            place = folder / f"{data.name}-boresight{number}"
            if not folder_problem(str(place)) and not place.exists():
                return place
    return None
