"""Opening and creating projects in a script."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from lispac.former_names import accept_script_names
from lispac.progress import Progress, no_progress
from lispac.project import LineSource, Reading, Settings, Triple
from lispac.scripting.open_project import OpenProject
from lispac.simulation.simulated_survey import POINTS_PER_SECOND
from lispac.survey.line_source import DEFAULT_READING
from lispac.workflow.planning.demo import make_demo
from lispac.workflow.project import projects
from lispac.workflow.project.moved_files import with_files_in

AnyPath = str | Path


@accept_script_names
def new(
    folder: AnyPath,
    *,
    lines: Sequence[AnyPath | LineSource],
    trajectory: AnyPath,
    lever_arm: Triple,
    accuracy: AnyPath | None = None,
    line_reading: Reading = DEFAULT_READING,
    trajectory_reading: Reading = DEFAULT_READING,
    accuracy_reading: Reading = DEFAULT_READING,
    resolved: bool = False,
    truth_deg: Triple | None = None,
    progress: Progress = no_progress,
    **settings: Any,
) -> OpenProject:
    """Make a project from raw lines and a trajectory, as ``lispac new`` does.

    Parameters
    ----------
    folder : path
        New folder for the project.
    lines : sequence of path or LineSource
        Scan files; each line is named after its file unless a `lispac.LineSource` names it.
    trajectory : path
    lever_arm : metres, body frame (forward, left, up)
    accuracy : path, optional
        File with the accuracies of the trajectory, for example smrmsg.
    line_reading, trajectory_reading, accuracy_reading : Reading
        Options of the formats; ``lispac inspect FILE`` lists them.
    resolved : bool
        Whether the reading options are complete, as in a script of a project. Nothing is then
        detected from the files.
    truth_deg : degrees, optional
        True boresight of a simulated survey.
    progress : callable
        Function that receives the progress of each step: a fraction and a text.
    **settings
        Fields of `lispac.Settings`: ``boresight_deg=(0, 0, 180)``, ``lidar_sigma=0.005`` ...

    Raises
    ------
    LispacError
        If a file or a setting cannot be used; the folder is then removed.
    """
    project, survey = projects.new_project(
        Path(folder),
        trajectory=Path(trajectory).absolute(),
        lines=[_line_source(line, line_reading) for line in lines],
        settings=Settings(lever_arm, **settings),
        accuracy=None if accuracy is None else Path(accuracy).absolute(),
        truth_deg=truth_deg,
        trajectory_reading=trajectory_reading,
        accuracy_reading=accuracy_reading,
        resolved=resolved,
        progress=progress,
    )
    return OpenProject(project, survey, progress=progress)


def open(
    folder: AnyPath, *, files: AnyPath | None = None, progress: Progress = no_progress
) -> OpenProject:
    """Open a project by its folder; its lines are read by the first step that needs them.

    Parameters
    ----------
    files : path, optional
        Present folder of the survey's files, if they or the project were moved.

    Raises
    ------
    ProjectError
        If there is no project, or its file is damaged.
    InputError
        If no missing file is in ``files``.
    """
    project = projects.open_project(Path(folder))
    if files is not None:
        project = with_files_in(project, Path(files))
    return OpenProject(project, progress=progress)


def demo(
    folder: AnyPath,
    *,
    points_per_second: float = POINTS_PER_SECOND,
    progress: Progress = no_progress,
) -> OpenProject:
    """Make the built-in simulated survey without targets; an earlier one is replaced.

    Parameters
    ----------
    points_per_second : float
        Pulse rate of the scanner; a lower rate makes a smaller survey of the same quay.

    Raises
    ------
    ProjectError
        If the folder contains anything other than a demo.
    """
    made = make_demo(Path(folder), points_per_second=points_per_second, progress=progress)
    return OpenProject(made, progress=progress)


def _line_source(line: AnyPath | LineSource, reading: Reading) -> LineSource:
    if isinstance(line, LineSource):
        return line
    path = Path(line).absolute()
    return LineSource(path.stem, path, reading=reading)
