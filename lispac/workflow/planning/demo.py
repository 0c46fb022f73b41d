"""Built-in survey, which is written to files and calibrated like any other survey."""

from pathlib import Path

import numpy as np

from lispac.language import gettext_lazy
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Role, Settings, Triple
from lispac.simulation.simulated_survey import POINTS_PER_SECOND, port_survey
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import pick_target
from lispac.workflow.checking.validation import validate
from lispac.workflow.planning.simulate import (
    RAW_FOLDER,
    as_triple,
    create_simulated_project,
    replaced_survey,
    require_replaceable,
    write_lines,
    write_trajectory,
)
from lispac.workflow.project.projects import save_project
from lispac.workflow.project.survey import Survey, load_survey

LIDAR_SIGMA = 0.0019
"""LiDAR noise along the normals of the two boards, metres: root mean square over all their points
in six lines, with 2.5 mm along the beam and 1.3 mm across it (0.005 deg at 15 m)."""

MARKER_FILE = "demo"
"""Name of the file in the folder ``raw`` that marks a demo, which may be replaced."""


def make_demo(
    folder: Path,
    *,
    points_per_second: float = POINTS_PER_SECOND,
    progress: Progress = no_progress,
) -> Project:
    """Simulate the built-in survey and write it as a new project with raw files but no targets.

    An earlier demo in the folder is replaced when the new files are complete.

    Parameters
    ----------
    points_per_second : float
        Pulse rate of the scanner; a lower rate gives fewer points of the same scene.

    Raises
    ------
    ProjectError
        If the folder contains anything other than a demo.
    """
    folder = Path(folder).absolute()
    require_replaceable(folder, MARKER_FILE)
    survey = port_survey(
        points_per_second=points_per_second, progress=sub_progress(progress, 0.0, 0.7)
    )
    with replaced_survey(
        folder, MARKER_FILE, "Built-in survey; each run of the demo replaces it.\n"
    ) as new:
        write_trajectory(survey, new / RAW_FOLDER)
        write_lines(survey, new / RAW_FOLDER, progress=sub_progress(progress, 0.7, 1.0))
    latitude, longitude, height = survey.origin
    settings = Settings(
        lever_arm=as_triple(survey.lever_arm),
        origin_deg_m=(float(np.degrees(latitude)), float(np.degrees(longitude)), height),
        lidar_sigma=LIDAR_SIGMA,
        pos_errors="correlated",  # like the simulated POS errors
    )
    names = [line.name for line in survey.lines]
    return create_simulated_project(folder, names, settings, np.degrees(survey.boresight))


def demo_seeds() -> dict[str, tuple[Role, Triple]]:
    """Seeds of the targets and validation planes of the built-in survey.

    Returns
    -------
    dict of name to role and position (metres, local frame)
    """
    from lispac.simulation.port_scene import TARGET_NAMES, VALIDATION_NAMES, port_scene
    from lispac.simulation.scene import Rectangle

    scene = port_scene()
    seeds: dict[str, tuple[Role, Triple]] = {}
    roles: tuple[tuple[Role, tuple[str, ...]], ...] = (
        ("target", TARGET_NAMES),
        ("validation", VALIDATION_NAMES),
    )
    for role, names in roles:
        for name in names:
            surface = scene[name]
            if isinstance(surface, Rectangle):
                seeds[name] = (role, as_triple(surface.centre))
    return seeds


def run_demo(folder: Path, *, progress: Progress = no_progress) -> tuple[Project, Survey]:
    """Simulate and calibrate the built-in survey."""
    project = make_demo(folder, progress=sub_progress(progress, 0.0, 0.4))
    return calibrate_demo(project, progress=sub_progress(progress, 0.4, 1.0))


def calibrate_demo(project: Project, *, progress: Progress = no_progress) -> tuple[Project, Survey]:
    """Load the built-in survey, pick its targets, estimate, validate and save the project."""
    survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.35))
    seeds = demo_seeds()
    for k, (name, (role, seed)) in enumerate(seeds.items()):
        step = sub_progress(
            progress, 0.35 + 0.3 * k / len(seeds), 0.35 + 0.3 * (k + 1) / len(seeds)
        )
        step(0.0, gettext_lazy("Searching for {target} in every line", target=name))
        project = pick_target(project, survey, seed, name=name, role=role)
    project = estimate(project, survey, progress=sub_progress(progress, 0.65, 0.75))
    project = validate(project, survey, progress=sub_progress(progress, 0.75, 1.0))
    project = save_project(project, expected=project.file_digest)
    progress(1.0)
    return project, survey
