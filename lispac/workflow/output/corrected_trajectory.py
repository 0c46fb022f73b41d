"""Trajectory corrected by the adjustment: corrections, SBET and accuracies."""

from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.pos_corrections import CorrectionsAtTimes, PosCorrections
from lispac.errors import InputError
from lispac.io.files import atomic_write
from lispac.io.text.corrections_file import TO_APPLANIX_AXES, write_corrections
from lispac.io.trajectory.sbet import write_sbet, write_smrmsg
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.project import Project
from lispac.survey.trajectory import TrajectoryAccuracy
from lispac.workflow.importing.file_reading import local_trajectory, read_trajectory
from lispac.workflow.output.data_export import SBET_ZEROS_NOTE, trajectory_datum_note
from lispac.workflow.output.georeferencing import require_no_overwrite
from lispac.workflow.output.pos_corrections import corrections_at, pos_corrections, support_notes

Array = NDArray[np.float64]

MAX_STEP_S, STEPS_PER_CORRELATION_TIME = 1.0, 20
"""Longest interval between the records of the corrections outside the sighted intervals, seconds,
and smallest number of intervals per correlation time."""
TIME_DECIMALS = 6
"""Decimals of the times of the records, seconds."""


@dataclass(frozen=True, eq=False)
class WrittenTrajectory:
    """Files of a corrected trajectory, and the corrections in them.

    Attributes
    ----------
    trajectory, accuracy : Path
        SBET and smrmsg.
    corrections_file : Path or None
        Text file of the corrections.
    estimate : PosCorrections
        Corrections at the knots of the adjustment.
    corrections : CorrectionsAtTimes
        Corrections at the records of the smrmsg and of the text file.
    messages : tuple of Message
        Notes on the support of the corrections and the conventions of the files.
    """

    trajectory: Path
    accuracy: Path
    corrections_file: Path | None
    estimate: PosCorrections
    corrections: CorrectionsAtTimes
    messages: tuple[Message, ...]

    @property
    def paths(self) -> tuple[Path, ...]:
        """All files."""
        further = () if self.corrections_file is None else (self.corrections_file,)
        return (self.trajectory, self.accuracy, *further)


def accuracy_path(trajectory: Path) -> Path:
    """Path of the smrmsg that belongs to a corrected SBET, unless another one is given."""
    return trajectory.with_name(f"{trajectory.stem}_smrmsg.out")


def write_corrected_trajectory(
    project: Project,
    output: Path,
    *,
    accuracy: Path | None = None,
    corrections: Path | None = None,
    progress: Progress = no_progress,
) -> WrittenTrajectory:
    """Write the corrected trajectory as SBET with its smrmsg, and the corrections as text.

    All files appear together at the end; after an error none is left.

    Parameters
    ----------
    output : Path
        SBET with Applanix's conventions.
    accuracy : Path, optional
        smrmsg with the standard deviations after the adjustment; `accuracy_path` by default.
    corrections : Path, optional
        Text file of the corrections; not written by default.

    Raises
    ------
    ProjectError
        As for `pos_corrections`.
    InputError
        If the trajectory cannot be read or is not that of the result, or a file cannot be written,
        is an input file of the project or has the name of another one.
    """
    estimate = pos_corrections(project)
    paths = [output, accuracy or accuracy_path(output)]
    paths += [] if corrections is None else [corrections]
    for k, path in enumerate(paths):
        if path.resolve() in [other.resolve() for other in paths[:k]]:
            raise InputError(error("corrections.same_file", file=str(path)))
    require_no_overwrite(project, paths)
    progress(0.0, gettext_lazy("Reading {file}", file=project.trajectory.name))
    local, _ = local_trajectory(project)
    raw = read_trajectory(project.trajectory, project.trajectory_reading)
    at_states = corrections_at(project, local, raw.time)
    at_records = corrections_at(project, local, _record_times(estimate, raw.time))
    position, attitude = np.split(np.abs(at_records.sigma * TO_APPLANIX_AXES), 2, axis=1)
    progress(0.5, gettext_lazy("Writing {file}", file=output.name))
    with ExitStack() as stack:
        temporary = [stack.enter_context(atomic_write(path)) for path in paths]
        write_sbet(temporary[0], raw.corrected(at_states.correction, local.frame))
        write_smrmsg(temporary[1], TrajectoryAccuracy(at_records.time, position, attitude))
        if corrections is not None:
            write_corrections(temporary[2], at_records, estimate, project.trajectory.name)
    progress(1.0)
    return WrittenTrajectory(
        paths[0],
        paths[1],
        corrections,
        estimate,
        at_records,
        (
            *support_notes(estimate),
            note("corrections.velocities"),
            trajectory_datum_note(project),
            SBET_ZEROS_NOTE,
        ),
    )


def _record_times(found: PosCorrections, states: Array) -> Array:
    """Times of the records: the knots, and a regular grid over the whole trajectory, seconds."""
    step = min(MAX_STEP_S, float(found.correlation_times.min()) / STEPS_PER_CORRELATION_TIME)
    first, last = float(states[0]), float(states[-1])
    grid = np.append(np.arange(first, last, step), last)
    knots = found.time[(found.time >= first) & (found.time <= last)]
    return np.unique(np.round(np.concatenate([grid, knots]), TIME_DECIMALS))
