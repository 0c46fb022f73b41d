"""Export of lines, targets, planes, the trajectory or the corrected trajectory."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from lispac.messages import Message
from lispac.progress import Progress, no_progress
from lispac.project import BoresightChoice, Project
from lispac.workflow.output.corrected_trajectory import accuracy_path, write_corrected_trajectory
from lispac.workflow.output.data_export import (
    SBET_ZEROS_NOTE,
    export_planes,
    export_targets,
    export_trajectory,
    exported_planes,
    exported_targets,
    target_paths,
    trajectory_datum_note,
)
from lispac.workflow.output.georeferencing import (
    TrajectoryChoice,
    georeference_project,
    line_paths,
)
from lispac.workflow.project.output_crs import LOCAL_FRAME, output_system_of
from lispac.workflow.project.survey import Survey

ExportContent = Literal["lines", "targets", "planes", "trajectory", "corrected_trajectory"]
FILE_TYPES: dict[ExportContent, tuple[str, ...]] = {
    "lines": ("laz", "las"),
    "targets": ("laz", "las", "csv"),
    "planes": ("txt",),
    "trajectory": ("sbet", "text"),
    "corrected_trajectory": ("sbet",),
}
"""File types of each kind of export, the default one first."""


@dataclass(frozen=True)
class ExportRequest:
    """Data, destination and file type of an export.

    Attributes
    ----------
    what : {"lines", "targets", "planes", "trajectory", "corrected_trajectory"}
    output : Path
        Output folder; for a trajectory the output file. The accuracies of a corrected trajectory
        and the corrections as text are written beside it.
    which : {"prior", "estimated"}
        Boresight that is used.
    form : str
        One of `FILE_TYPES`.
    system, height, trajectory_datum, epoch
        For lines and targets, as for
        `lispac.workflow.output.georeferencing.georeference_project`.
    trajectory_choice : {"given", "corrected"}
        Trajectory with which lines are georeferenced.
    """

    what: ExportContent
    output: Path
    which: BoresightChoice = "estimated"
    form: str = "laz"
    system: str = LOCAL_FRAME
    height: str = ""
    trajectory_datum: str | None = None
    epoch: float | None = None
    trajectory_choice: TrajectoryChoice = "given"


def output_paths(project: Project, request: ExportRequest) -> list[Path]:
    """Files that an export would write.

    Raises
    ------
    ProjectError
        If there are no targets to export.
    """
    output, which = request.output, request.which
    if request.what == "lines":
        return line_paths(output, project.lines, which, request.form, request.trajectory_choice)
    if request.what == "targets":
        return target_paths(output, exported_targets(project), which, request.form)
    if request.what == "planes":
        return target_paths(output, exported_planes(project), which, request.form)
    if request.what == "corrected_trajectory":
        return [output, accuracy_path(output), _corrections_path(output)]
    return [output]


def _corrections_path(trajectory: Path) -> Path:
    return trajectory.with_name(f"{trajectory.stem}_corrections.csv")


def export(
    project: Project, survey: Survey, request: ExportRequest, *, progress: Progress = no_progress
) -> tuple[list[Path], tuple[Message, ...]]:
    """Write the data of an export request.

    Returns
    -------
    paths : list of Path
    notes : tuple of Message
        Notes on excluded data and assumptions.

    Raises
    ------
    InputError
        If the request is not valid or a file cannot be written.
    ProjectError
        As the functions of `data_export` and `georeferencing`.
    """
    form: Any = request.form
    if request.what == "lines":
        written = georeference_project(
            project, request.output, request.which, system=request.system, height=request.height,
            trajectory_datum=request.trajectory_datum, epoch=request.epoch, ending=form,
            trajectory_choice=request.trajectory_choice, progress=progress,
        )  # fmt: skip
        notes = [note for done in written for note in done.notes]
        return [done.path for done in written], tuple(dict.fromkeys(notes))
    if request.what == "targets":
        system = output_system_of(
            project, survey.trajectory, request.system, request.height,
            request.trajectory_datum, request.epoch,
        )  # fmt: skip
        paths = export_targets(
            project, survey, request.output, request.which, system=system, ending=form,
            progress=progress,
        )  # fmt: skip
        return paths, () if system is None else system.assumptions
    if request.what == "planes":
        paths = export_planes(project, survey, request.output, request.which, progress=progress)
        return paths, ()
    if request.what == "corrected_trajectory":
        done = write_corrected_trajectory(
            project, request.output, corrections=_corrections_path(request.output),
            progress=progress,
        )  # fmt: skip
        return list(done.paths), done.messages
    path = export_trajectory(project, request.output, form)
    zeros = (SBET_ZEROS_NOTE,) if form == "sbet" else ()
    return [path], (trajectory_datum_note(project), *zeros)
