"""A survey with the true boresight as its result, and the true offsets of its lines."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from lispac.project import Project
from lispac.simulation.simulated_survey import SimulatedSurvey
from lispac.survey.georeferencing import Mounting, georeference
from lispac.validation.absolute_check import AbsoluteCheck
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.static_scans import plane_of


def project_with_true_boresight(demo_project: Project, sample: Project) -> tuple[Project, Survey]:
    """The built-in survey with its true boresight as the result, with a sigma of 0.01 deg."""
    result = sample.result
    assert result is not None
    truth_deg = demo_project.truth_deg
    assert truth_deg is not None
    settings = demo_project.settings
    result = replace(
        result,
        mounting=Mounting(np.array(settings.lever_arm), np.radians(truth_deg)),
        estimated=("roll", "pitch", "yaw"),
        covariance_all=np.radians(0.01) ** 2 * np.eye(3),
    )
    project = replace(demo_project, result=result)
    return project, load_survey(project)


def true_offsets(
    truth: SimulatedSurvey, survey: Survey, name: str, fewest: int = 500
) -> dict[str, float]:
    """Mean offset of each line from a plane due to POS errors, from the points of the simulator."""
    number, normal = truth.surface_names.index(name), plane_of(name).normal
    mounting = Mounting(truth.lever_arm, truth.boresight)
    found = {}
    for line in truth.lines:
        own = line.label == number
        if np.count_nonzero(own) > fewest:
            placed = georeference(
                line.points_lidar[own], line.time[own], survey.trajectory, mounting
            )
            found[line.name] = float(((placed - line.true_points_local[own]) @ normal).mean())
    return found


def check_against_points(
    known: tuple[Project, Survey], path: Path, points: np.ndarray, **how: object
) -> AbsoluteCheck:
    np.savetxt(path, points, fmt="%.5f")
    project, _ = check_absolute(*known, path, **how)  # type: ignore[arg-type]
    assert project.absolute is not None
    return project.absolute
