"""Corrections of a project's trajectory from its result, and notes on their support."""

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.pos_corrections import CorrectionsAtTimes, PosCorrections
from lispac.errors import InputError, ProjectError
from lispac.messages import Message, error, note
from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.project.survey import trajectory_accuracy

Array = NDArray[np.float64]


def pos_corrections(project: Project) -> PosCorrections:
    """Corrections of the POS from the result of a project.

    An edit removes the result that depends on it, so that a result is never out of date.

    Raises
    ------
    ProjectError
        If nothing has been estimated, the POS errors were uncorrelated, the result is of an earlier
        version, or the data determine no component.
    """
    if (result := project.result) is None:
        raise ProjectError(error("project.not_estimated", project=project.name))
    if not result.model.correlated:
        raise ProjectError(error("corrections.uncorrelated", project=project.name))
    if (found := result.pos_corrections) is None:
        raise ProjectError(error("corrections.former_result", project=project.name))
    if not found.determined.any():
        raise ProjectError(error("corrections.undetermined", project=project.name))
    return found


def corrections_at(
    project: Project, trajectory: LocalTrajectory, time: Array
) -> CorrectionsAtTimes:
    """Corrections of a trajectory at chosen times.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds

    Raises
    ------
    ProjectError
        As for `pos_corrections`.
    InputError
        If the trajectory or its accuracies are not those of the result.
    """
    found = pos_corrections(project)
    first, last = found.time[0] + found.knot_interval, found.time[-1] - found.knot_interval
    start, end = float(trajectory.time[0]), float(trajectory.time[-1])
    if first < start or last > end:
        raise InputError(
            error(
                "corrections.other_trajectory", file=project.trajectory.name,
                first=float(first), last=float(last), start=start, end=end,
            )
        )  # fmt: skip
    accuracy, _ = trajectory_accuracy(project, trajectory)
    assert project.result is not None
    _, position_factor, attitude_factor = project.result.sigma_factors
    position, attitude = accuracy.at(time)
    return found.at(time, np.hstack([position_factor * position, attitude_factor * attitude]))


def corrected_trajectory(project: Project, trajectory: LocalTrajectory) -> LocalTrajectory:
    """Trajectory of a project with its corrections.

    Raises
    ------
    ProjectError
        As for `pos_corrections`.
    InputError
        As for `corrections_at`.
    """
    return trajectory.corrected(corrections_at(project, trajectory, trajectory.time).correction)


def support_notes(found: PosCorrections) -> tuple[Message, ...]:
    """Notes on the times and components in which the data support the corrections."""
    intervals = found.sighted_intervals
    notes = [
        note(
            "corrections.support",
            count=len(intervals),
            start=float(intervals[0, 0]),
            end=float(intervals[-1, 1]),
            position=found.position_time,
            attitude=found.attitude_time,
        )
    ]
    if names := undetermined_components(found):
        notes.append(note("corrections.not_determined", names=names))
    return tuple(notes)


def undetermined_components(found: PosCorrections) -> tuple[Message, ...]:
    """Names of the components that are not corrected: north, east, down, roll, pitch, heading."""
    names = ("north", "east", "down", "roll", "pitch", "heading")
    pairs = zip(names, found.determined, strict=True)
    return tuple(note(f"quantity.{name}") for name, determined in pairs if not determined)
