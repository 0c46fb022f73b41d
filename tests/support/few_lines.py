"""Small survey of three short lines past two boards."""

from dataclasses import replace
from functools import cache

import numpy as np

from lispac.project import Project
from lispac.simulation.scene import tilted_rectangle
from lispac.survey.georeferencing import Mounting
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import pick_target
from lispac.workflow.project.survey import Survey
from tests.support.finder_scenes import WALL, Site, site
from tests.targets.test_finder_sites import board


@cache
def site_of_few_lines() -> Site:
    """An upright and a leaning board with some 1,500 points on each line."""
    leaning = tilted_rectangle("T2", (-2.6, WALL, 7.5), 1.23, 1.0, 270, 45)
    return site([board(), leaning], lines=3, pulses_per_second=50_000.0)


@cache
def picked() -> tuple[Project, Survey]:
    """The survey with both boards as targets and no result; values that tests may share."""
    project, survey = site_of_few_lines().opened()
    for surface in site_of_few_lines().scene.surfaces:
        north, west, up = map(float, surface.centre)
        project = pick_target(project, survey, (north, west, up), name=surface.name)
    return project, survey


@cache
def picked_and_estimated() -> tuple[Project, Survey]:
    """The same survey with the true boresight as the result."""
    project, survey = picked()
    project = estimate(project, survey, cross_check=False)
    assert project.result is not None
    mounting = Mounting(np.array(project.settings.lever_arm), site_of_few_lines().boresight)
    return project.with_result(replace(project.result, mounting=mounting)), survey


def on_board(name: str, across: float, up: float) -> np.ndarray:
    """True place on a board, metres from its centre along it and up the slope, shape (3,)."""
    surface = site_of_few_lines().scene[name]
    along = np.cross(surface.normal, surface.across)
    return np.asarray(surface.centre + across * surface.across + up * along)
