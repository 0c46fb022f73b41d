"""Tests of the cause of radii that differ between lines."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.diagnostics.sphere_radii import find_radius_discrepancies
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.simulation.closed_form_survey import (
    Ball,
    Course,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from tests.adjustment.test_vessel_adjustment import observations
from tests.support.long_runs import others_long
from tests.targets.test_vessel_spheres import BALLS as SPHERES
from tests.targets.test_vessel_spheres import VESSEL, Vessel

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
BALLS = tuple(
    Ball(f"S{k}", centre, 0.15, radius_known=False)
    for k, centre in enumerate([(0.8, 15.0, 5.0), (-3.0, 12.0, 3.0), (4.0, 17.0, 6.0)])
)
LARGE_BALLS = tuple(replace(ball, radius=0.6) for ball in BALLS)
NEAR_AND_FAR = tuple(
    replace(course, abeam=(0.0, west))
    for course, west in zip(six_courses(), (0.0, 0.0, 5.0, 5.0, 9.0, 9.0), strict=True)
)
"""Lines at distances of 3 to 17 m from the balls."""


def survey(
    seed: int,
    mounting: Mounting = TRUTH,
    balls: tuple[Ball, ...] = BALLS,
    courses: tuple[Course, ...] = six_courses(),
    spacing: float = 0.01,
) -> Observations:
    generator = np.random.default_rng([7, seed])
    exact = error_free_survey(mounting, balls, courses, spacing, generator)
    return add_errors(exact, HYDROGRAPHIC_INS, generator)


def changed(data: Observations, cause: str) -> Observations:
    signs = np.array([-1, 1, 1] if cause == "roll_sign" else [1, -1, 1])
    return replace(data, attitude=data.attitude * signs)


@pytest.mark.parametrize("seed", range(10))
def test_radii_of_a_survey_without_errors_agree(seed: int) -> None:
    assert find_radius_discrepancies(survey(seed), TRUTH) == ()


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("cause", ["roll_sign", "pitch_sign"])
def test_a_wrong_sign_of_the_attitude_is_named(seed: int, cause: str) -> None:
    found = find_radius_discrepancies(changed(survey(seed), cause), TRUTH)
    assert {each.cause for each in found} == {cause}
    for each in found:
        assert each.largest - each.smallest > 0.01


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize(
    ("cause", "value", "tolerance", "courses"),
    others_long(
        [
            # On slow lines, a ball is crossed in several seconds, during which the vessel rolls.
            ("latency", 0.25, 0.05, six_courses(speed=0.4)),
            # The radius is larger by the ratio of the offset to the range, which differs by line.
            ("range_offset", 0.2, 0.01, NEAR_AND_FAR),
            ("range_offset", -0.15, 0.01, NEAR_AND_FAR),
        ],
        2,
    ),
)
def test_a_wrong_latency_or_range_offset_is_named(
    seed: int, cause: str, value: float, tolerance: float, courses: tuple[Course, ...]
) -> None:
    data = survey(seed, replace(TRUTH, **{cause: value}), LARGE_BALLS, courses, 0.04)
    found = find_radius_discrepancies(data, TRUTH)
    assert {each.cause for each in found} == {cause}
    for each in found:
        assert each.value == pytest.approx(value, abs=tolerance)
    assert find_radius_discrepancies(survey(seed, TRUTH, LARGE_BALLS, courses, 0.04), TRUTH) == ()


def test_an_error_of_one_line_is_not_attributed_to_a_sign() -> None:
    data = survey(0)
    own = np.array([each.line == "L2" for each in data.sightings])[data.sighting]
    points = np.where(own[:, None], data.points_lidar * [1.3, 1.0, 1.0], data.points_lidar)
    found = find_radius_discrepancies(replace(data, points_lidar=points), TRUTH)
    assert all(each.cause == "" for each in found)


def test_two_wrong_signs_are_named_if_no_single_one_explains_the_radii() -> None:
    data = survey(1)
    turned = replace(data, attitude=data.attitude * np.array([-1, -1, 1]))
    found = find_radius_discrepancies(turned, TRUTH)
    assert {each.cause for each in found} == {"roll_pitch_signs"}


@pytest.mark.parametrize("seed", [2, 3])
def test_all_balls_have_the_same_cause(seed: int) -> None:
    """On two lines, single balls would also fit two wrong signs or a latency."""
    data = survey(seed, courses=six_courses()[:2], spacing=0.015)
    found = find_radius_discrepancies(changed(data, "roll_sign"), TRUTH)
    assert len(found) > 1
    assert {each.cause for each in found} == {"roll_sign"}


def test_the_pitch_sign_of_a_real_survey_is_named(shared_data: Path) -> None:
    """The recorded pitch has the opposite sign; the true radius of the three balls is 0.1 m."""
    data = observations(Vessel(shared_data), SPHERES)
    found = find_radius_discrepancies(data, VESSEL)
    assert {each.target: each.cause for each in found} == dict.fromkeys(SPHERES, "pitch_sign")
    turned = replace(data, attitude=data.attitude * np.array([1, -1, 1]))
    assert find_radius_discrepancies(turned, VESSEL) == ()


def test_the_result_of_an_adjustment_has_radius_discrepancies() -> None:
    data = average_points_in_cells(changed(survey(1, spacing=0.02), "pitch_sign"), TRUTH, 0.02)
    # Without a search for correlation times, none of which explains a wrong sign
    result = adjust(data, TRUTH, StochasticModel(loss="tukey"), test_model=False)
    assert {each.cause for each in result.radius_discrepancies} == {"pitch_sign"}
    discrepancies = [
        each for each in result_warnings(result, None) if each.code.startswith("adjustment.radii_")
    ]
    assert all(each.is_serious for each in discrepancies)
    assert discrepancies
    assert adjust(data, TRUTH, StochasticModel(), diagnostics=False).radius_discrepancies == ()
