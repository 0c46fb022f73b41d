"""Making, opening and saving projects."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from lispac.errors import InputError, ProjectError
from lispac.io.files import require_file
from lispac.io.project_file import FILE_NAME, read_project, write_project
from lispac.project import LineSource, Project, Settings, Triple


def create_project(
    folder: Path,
    *,
    trajectory: Path,
    lines: Sequence[LineSource],
    settings: Settings,
    accuracy: Path | None = None,
    truth_deg: Triple | None = None,
) -> Project:
    """Make a project folder that points at the survey's files.

    Raises
    ------
    ProjectError
        Where the folder already holds a project.
    InputError
        Where a file is missing or a setting makes no sense.
    """
    folder = Path(folder).absolute()
    if (folder / FILE_NAME).exists():
        raise ProjectError(f"{folder}: there is a project here already; choose another folder.")
    if not lines:
        raise InputError("A project needs at least one line; name its scan file.")
    names = [line.name for line in lines]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"Two lines are named {name}; give their files different names.")
    require_file(trajectory, "trajectory")
    if accuracy is not None:
        require_file(accuracy, "trajectory accuracy")
    for line in lines:
        require_file(line.path, "line")
    check_settings(settings)
    project = Project(
        folder=folder,
        trajectory=Path(trajectory).absolute(),
        lines=tuple(LineSource(n.name, Path(n.path).absolute(), n.columns) for n in lines),
        settings=settings,
        accuracy=None if accuracy is None else Path(accuracy).absolute(),
        truth_deg=truth_deg,
    )
    write_project(project)
    return project


def open_project(folder: Path) -> Project:
    """Open a project by its folder or its ``project.json``.

    Raises
    ------
    ProjectError
    """
    return read_project(folder)


def save_project(project: Project) -> None:
    """Save a project into its folder.

    Raises
    ------
    InputError
        Where the folder cannot be written.
    """
    write_project(project)


def check_settings(settings: Settings) -> None:
    """Refuse settings that make no sense.

    Raises
    ------
    InputError
    """
    numbers = {
        "lever arm": settings.lever_arm,
        "boresight": settings.boresight_deg,
        "origin": settings.origin_deg_m or (0.0,),
        "position sigma": settings.position_sigma,
        "attitude sigma": settings.attitude_sigma_deg,
        "LiDAR sigma": (settings.lidar_sigma,),
        "subsampling distance": (settings.subsample,),
    }
    for name, values in numbers.items():
        if not np.isfinite(values).all():
            raise InputError(f"The {name} is not a number; correct it.")
    if min(*settings.position_sigma, *settings.attitude_sigma_deg, settings.subsample) < 0:
        raise InputError("A sigma or the subsampling distance is negative; correct it.")
    if settings.lidar_sigma <= 0:
        raise InputError("The LiDAR sigma must be larger than zero; correct it.")
    if np.abs(settings.boresight_deg).max() > 360:
        raise InputError("A prior boresight angle is beyond 360 deg; give degrees.")
    if np.linalg.norm(settings.lever_arm) > 100:
        raise InputError("The lever arm is longer than 100 m; give metres.")
    if settings.origin_deg_m is not None and abs(settings.origin_deg_m[0]) > 90:
        raise InputError("The origin's latitude is beyond 90 deg; give LAT LON HEIGHT in degrees.")
