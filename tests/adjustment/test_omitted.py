"""Tests of mounting values that are wrong and not estimated: the data contradict them."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import norm

from lispac.adjustment.diagnostics.solved_equations import SolvedEquations
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import OPTIONAL_NAMES
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.solve.omitted_parameters import CRITICAL_VALUE, find_contradicted_parameters
from tests.adjustment.test_parameters import (
    MODEL,
    MOUNTINGS_WITH_ERROR,
    PRIOR,
    TRUE_MOUNTING,
    survey,
)
from tests.support.long_runs import LONG, others_long


@pytest.mark.parametrize("seed", others_long(range(2)))
@pytest.mark.parametrize("name", others_long(["lever_x", "lever_y", "range_offset"]))
def test_a_harmful_wrong_value_is_named_first(name, seed) -> None:
    """The chi-square test passes despite an error of 10 cm, because sigmas are estimated."""
    result = adjust(survey(MOUNTINGS_WITH_ERROR[name], seed), PRIOR, MODEL)
    assert result.chi_square.passed
    off = np.abs(result.boresight - TRUE_MOUNTING.boresight)
    first = result.contradictions[0] if result.contradictions else None
    if first is None:  # then the error must be harmless
        assert name == "range_offset"
        assert (off < 3 * result.sigma).all()
        return
    assert first.name == name
    assert abs(first.change - 0.1) < 4 * first.sigma
    corrected = result.boresight + first.angle_change - TRUE_MOUNTING.boresight
    assert (np.abs(corrected) < 4 * result.sigma).all()
    assert (np.abs(corrected) <= np.maximum(off, 2 * result.sigma)).all()


@pytest.mark.parametrize(
    ("wrong", "names"),
    others_long(
        [
            ((0.05, 0.05, 0.0), {"lever_x", "lever_y"}),
            ((0.05, -0.05, 0.0), {"lever_x", "lever_y"}),
            ((0.04, 0.0, 0.0), {"lever_x"}),
        ]
    ),
)
@pytest.mark.parametrize("seed", others_long(range(200, 203)))
def test_a_wrong_lever_arm_causes_no_rejected_sightings(wrong, names, seed) -> None:
    """Sightings must not be rejected until the others agree with the wrong value."""
    wrong_prior = replace(PRIOR, lever_arm=PRIOR.lever_arm + wrong)
    result = adjust(survey(TRUE_MOUNTING, seed), wrong_prior, MODEL, test_model=False)
    assert result.rejected_sightings == ()
    assert {each.name for each in result.contradictions} == names
    for each in result.contradictions:
        off = wrong["xyz".index(each.name[-1])]
        assert abs(each.change + off) < 4 * each.sigma
        assert each.change == pytest.approx(-off, abs=0.015)


def test_a_shifted_sighting_is_named_beside_a_wrong_lever_arm() -> None:
    from tests.adjustment.test_robustness import shifted

    wrong_prior = replace(PRIOR, lever_arm=PRIOR.lever_arm + [0.1, 0.0, 0.0])
    points = survey(TRUE_MOUNTING, 221)
    result = adjust(shifted(points, 4, 0.3), wrong_prior, MODEL, test_model=False)
    assert result.rejected_sightings == (points.sightings[4],)
    assert [each.name for each in result.contradictions] == ["lever_x"]


def test_an_estimated_lever_arm_is_not_contradicted() -> None:
    from lispac.adjustment.model.parameters import Parameter

    data = survey(MOUNTINGS_WITH_ERROR["lever_x"], 0)
    unchanged = adjust(data, PRIOR, MODEL)
    estimated = adjust(data, PRIOR, MODEL, parameters=(Parameter("lever_x"),))
    assert [each.name for each in unchanged.contradictions] == ["lever_x"]
    assert 0 < unchanged.contradictions[0].surface_sigma < unchanged.surface
    assert not estimated.contradictions
    # One step of a score test predicts the adjustment with the value estimated.
    (found,) = estimated.parameters
    assert unchanged.contradictions[0].change == pytest.approx(found.value - found.prior, abs=0.002)
    moved = estimated.boresight - unchanged.boresight
    assert (
        np.abs(unchanged.contradictions[0].angle_change - moved).max() < 0.3 * estimated.sigma.max()
    )


def solved_equations(data: Observations) -> SolvedEquations:
    """Equations at the solution, without the diagnostics, which take most of the time."""
    solved = SolvedEquations.of(adjust(data, PRIOR, MODEL, diagnostics=False), data, PRIOR)
    assert solved is not None
    return solved


@LONG
@pytest.mark.parametrize("bent", [pytest.param(0.0, marks=pytest.mark.long), 0.003])
def test_correct_values_are_not_contradicted(bent) -> None:
    """Form errors of 3 mm per line must not look like a lever arm; 1 in 100 by chance."""
    count = 0
    for seed in range(10):
        data = survey(TRUE_MOUNTING, 1000 + seed)
        off = np.random.default_rng(seed).normal(0, bent, len(data.sightings))[data.sighting]
        beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
        data = replace(data, points_lidar=data.points_lidar + off[:, None] * beams)
        count += len(find_contradicted_parameters(solved_equations(data).linearised))
    assert count <= 1


def test_the_significance_level_is_for_all_values_together() -> None:
    assert 2 * len(OPTIONAL_NAMES) * norm.sf(CRITICAL_VALUE) == pytest.approx(0.01)


@pytest.mark.long
def test_one_survey_in_a_hundred_contradicts_a_value_by_chance() -> None:
    """Without a limit on the angle change; the level of a single value would give one in six."""
    count = 0
    for seed in range(30):
        data = survey(TRUE_MOUNTING, 2000 + seed)
        linearised = solved_equations(data).linearised
        count += bool(find_contradicted_parameters(linearised, min_angle_change=0.0))
    assert count <= 1


def test_the_classical_model_contradicts_nothing() -> None:
    """Its sigmas are too small for a test."""
    result = adjust(
        survey(MOUNTINGS_WITH_ERROR["lever_x"], 0), PRIOR, StochasticModel("independent")
    )
    assert result.contradictions == ()
