"""Tests of spheres in the window: choice of the shape, candidate, list of targets."""

import pytest
from PySide6.QtWidgets import QLabel

from lispac.gui.appearance import units
from lispac.gui.project.status import TARGETS
from lispac.gui.viewport.base import PickedPoint
from lispac.gui.widgets.number_field import NumberField
from lispac.project import Project
from tests.gui.support import Driver, Left, click, open_step
from tests.support.ball_survey import BallSurvey, make_ball_survey


@pytest.fixture(scope="module")
def balls(tmp_path_factory) -> BallSurvey:
    return make_ball_survey(tmp_path_factory.mktemp("balls"))


@pytest.fixture
def opened(driver: Driver, balls: BallSurvey) -> Driver:
    driver.window.document.open(balls.project, balls.survey)
    driver.rest()
    return driver


def seed(driver: Driver, balls: BallSurvey, name: str, line: str = "L1") -> None:
    position = balls.seed(name, line)
    driver.viewport.signals.seed_clicked.emit(PickedPoint(line, position))
    driver.rest()


def detail(driver: Driver) -> str:
    label = driver.window.targets.candidate.findChild(QLabel, "candidate_detail")
    return label.text().replace("\u00a0", " ")


def accept_candidate(driver: Driver) -> Project:
    click(driver, driver.window.targets.candidate.accept)
    driver.rest()
    return driver.project


@pytest.mark.parametrize(("radius", "text"), [(0.15, "Known radius: 0.15 m"), (0.0, "Radius: 0.1")])
def test_a_sphere_is_seeded_with_and_without_its_radius(opened, balls, radius, text):
    panel = opened.window.targets
    panel.shape_choice.setCurrentIndex(1)
    panel._sphere_radius.setValue(radius)
    assert panel._threshold.specialValueText() == "default (30\u00a0mm)"
    seed(opened, balls, "S1")
    assert "RMS distance to the sphere" in detail(opened)
    assert text in detail(opened)
    assert "% of the surface is observed" in detail(opened)
    target = accept_candidate(opened).target("T1")
    assert (target.shape, target.sphere_radius) == ("sphere", radius or None)
    assert panel.table.item(0, 2).text() == "sphere"
    assert panel.table.item(0, 3).text() == "6 of 6"


def test_the_radius_of_a_sphere_is_shown_in_the_chosen_unit(opened, balls):
    panel = opened.window.targets
    panel.shape_choice.setCurrentIndex(1)
    panel._sphere_radius.setValue(0.15)
    units.set_units("degrees", "feet")
    try:
        seed(opened, balls, "S1")
        assert f"Known radius: {0.15 / 0.3048:g} ft" in detail(opened)
        assert " m " not in detail(opened)
    finally:
        units.set_units("degrees", "metres")


def test_a_seed_on_a_single_line_keeps_the_shape_of_the_target(opened, balls):
    panel = opened.window.targets
    panel.shape_choice.setCurrentIndex(1)
    panel._sphere_radius.setValue(0.15)
    seed(opened, balls, "S1")
    accept_candidate(opened)
    panel.shape_choice.setCurrentIndex(0)
    panel.select("T1")
    panel.line_choice.setCurrentText("L3")
    seed(opened, balls, "S1", "L3")
    target = accept_candidate(opened).target("T1")
    assert (target.shape, target.sphere_radius) == ("sphere", 0.15)
    assert len(target.sightings) == 6


def test_spheres_are_mentioned_where_there_are_some(opened, balls):
    panel = opened.window.targets
    open_step(opened, TARGETS)
    assert panel.table.isColumnHidden(2)
    panel.shape_choice.setCurrentIndex(1)
    seed(opened, balls, "S1")
    accept_candidate(opened)
    assert not panel.table.isColumnHidden(2)


def test_only_a_target_can_be_a_sphere(opened, balls):
    panel = opened.window.targets
    open_step(opened, TARGETS)
    opened.bot.mouseClick(panel.settings.head, Left)
    assert not panel._sphere_radius.isVisible()
    panel.shape_choice.setCurrentIndex(1)
    assert panel._sphere_radius.isVisible()
    assert panel._sphere_radius.isEnabled()
    assert "click a sphere" in panel.hint.text()
    panel.set_role("validation")
    assert not panel.shape_choice.isEnabled()
    assert not panel._sphere_radius.isEnabled()
    assert (panel.shape, panel.sphere_radius) == ("plane", None)
    assert panel._threshold.specialValueText() == "default (10\u00a0mm)"
    radius = panel.findChild(NumberField, "search_radius")
    assert radius.text() == "default (4.0\u00a0m)"
    panel.set_role("target")
    assert radius.text() == "default (2.0\u00a0m)"
    assert panel.shape == "sphere"
