"""Import of surveyed control from a list of points or a static scan."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from lispac.control_points import ControlFile, ControlPoint, ControlReading, with_control_file
from lispac.errors import InputError, ProjectError
from lispac.io.text.seed_file import ListedPoint
from lispac.messages import Message, error
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Triple
from lispac.survey.crs import CoordinateSystem
from lispac.workflow.control.control_assignment import (
    SCAN_DISTANCE,
    assigned_points,
    scanned_points,
    target_surfaces,
)
from lispac.workflow.control.references import (
    open_reference,
    read_listed_points,
    read_surface,
    sigma_warnings,
)
from lispac.workflow.project.coordinates import is_local
from lispac.workflow.project.survey import Survey

DEFAULT_SIGMA = 0.005
"""Default standard deviation of control, metres."""


def import_control(
    project: Project,
    survey: Survey,
    path: Path,
    *,
    sigma: float = DEFAULT_SIGMA,
    common_sigma: float | None = None,
    crs: str = "",
    height: str = "",
    trajectory_datum: str | None = None,
    epoch: float | None = None,
    progress: Progress = no_progress,
) -> tuple[Project, tuple[Message, ...]]:
    """Import control from a list of points or a static scan; a file of the same name is replaced.

    Parameters
    ----------
    path : Path
        List of points: name, x, y, z, and optionally standard deviations and the name of the target
        in a column ``plane``; or a static scan (LAS, LAZ, E57, PTS, text).
    sigma : float, metres
        Standard deviation of each coordinate of points without one in the list. Of a scan, the
        standard deviation common to all its points, if ``common_sigma`` is not given.
    common_sigma : float or None, metres
        Standard deviation, on each axis, of an error that all points of the file share, such as
        that of the registration or of the fixed points.
    crs, height, trajectory_datum, epoch
        As in `lispac.workflow.control.references.read_reference`.

    Returns
    -------
    project : Project
        Project with the control.
    notes : tuple of Message
        Notes on the reading, and warnings about the control.

    Raises
    ------
    ProjectError
        If the project has no targets.
    InputError
        If the file cannot be read or is not at the site of the survey, or a standard deviation is
        not valid.
    """
    _require_sigma(sigma)
    surfaces = target_surfaces(project, survey)
    if not surfaces:
        raise ProjectError(error("control.no_targets", project=project.name))
    opened = open_reference(
        path, project, survey, crs=crs, height=height, trajectory_datum=trajectory_datum,
        epoch=epoch,
    )  # fmt: skip
    notes: tuple[Message, ...] = opened.notes
    if opened.is_list:
        listed, columns = read_listed_points(opened, survey.trajectory)
        blank = tuple(
            ControlPoint(
                point.name or f"P{number}", "", (float(place[0]), float(place[1]), float(place[2])),
                _local_sigmas(point, sigma, opened.system), stated_target=point.plane,
            )
            for number, (point, place) in enumerate(listed, start=1)
        )  # fmt: skip
        points = assigned_points(blank, surfaces)
        notes += (columns, *sigma_warnings([point for point, _ in listed]))
        common = common_sigma or 0.0
    else:
        cloud, used = read_surface(
            opened, survey, project, SCAN_DISTANCE, sub_progress(progress, 0.0, 0.5)
        )
        points = scanned_points(cloud, surfaces, sub_progress(progress, 0.5, 1.0))
        notes += (used,)
        common = sigma if common_sigma is None else common_sigma
    file = ControlFile(
        opened.path, opened.size_bytes, opened.sha256, "points" if opened.is_list else "scan",
        opened.system_name, survey.trajectory.frame.origin_deg_m, float(common), points,
        ControlReading(crs, height, trajectory_datum, epoch),
        tuple(target.name for target in project.targets_of_role("target")),
    )  # fmt: skip
    file.require_sound()
    notes += tuple(point.reason for point in points if point.reason is not None)
    progress(1.0)
    former = {
        point.name: point.used
        for each in project.control
        if each.path.name == file.path.name
        for point in each.points
    }
    points = tuple(replace(each, used=former.get(each.name, True)) for each in file.points)
    file = replace(file, points=points)
    return project.with_control(with_control_file(project.control, file)), notes


def _local_sigmas(point: ListedPoint, sigma: float, system: CoordinateSystem | None) -> Triple:
    """Standard deviations north, west and up of a listed point, metres."""
    if point.axis_sigmas is None:
        own = sigma if point.sigma is None else point.sigma
        return own, own, own
    first, second, third = point.axis_sigmas
    if is_local(system):  # north, west, up
        return first, second, third
    assert system is not None
    if system.crs.is_geocentric:  # no axis is that of the local frame
        assert point.sigma is not None
        return point.sigma, point.sigma, point.sigma
    return second, first, third  # east, north, up


def _require_sigma(sigma: float) -> None:
    """Refuse a standard deviation that is not positive.

    Raises
    ------
    InputError
        If it is not.
    """
    if not 0.0 < sigma < np.inf:
        raise InputError(error("control.sigma", sigma=sigma))
