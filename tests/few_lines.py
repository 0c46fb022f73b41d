"""Three short lines by two boards, made and picked in a moment."""

from dataclasses import replace
from functools import cache

import numpy as np

from lispac.project import Project
from lispac.simulation.scene import tilted_rectangle
from lispac.survey.georeferencing import Mounting
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import pick_target
from lispac.workflow.project.survey import Survey
from tests.finder_scenes import WALL, Site, site
from tests.test_finder_sites import board


@cache
def site_of_few_lines() -> Site:
    """An upright board and a leaning one, some 1,500 points a line on both together."""
    leaning = tilted_rectangle("T2", (-2.6, WALL, 7.5), 1.23, 1.0, 270, 45)
    return site([board(), leaning], lines=3, pulses_per_second=50_000.0)


@cache
def picked() -> tuple[Project, Survey]:
    """Both boards as targets, nothing estimated; values, so that tests may share them."""
    project, survey = site_of_few_lines().opened()
    for surface in site_of_few_lines().scene.surfaces:
        north, west, up = map(float, surface.centre)
        project = pick_target(project, survey, (north, west, up), name=surface.name)
    return project, survey


@cache
def answered() -> tuple[Project, Survey]:
    """The same with the true boresight as the estimated one."""
    project, survey = picked()
    project = estimate(project, survey, cross_check=False)
    assert project.result is not None
    mounting = Mounting(np.array(project.settings.lever_arm), site_of_few_lines().boresight)
    return project.with_result(replace(project.result, mounting=mounting)), survey


def on_board(name: str, across: float, up: float) -> np.ndarray:
    """A true place on a board, metres from its middle along it and up the slope, shape (3,)."""
    surface = site_of_few_lines().scene[name]
    along = np.cross(surface.normal, surface.across)
    return np.asarray(surface.centre + across * surface.across + up * along)
