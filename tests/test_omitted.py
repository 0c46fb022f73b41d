"""A value of the mounting that is stated wrongly and not estimated: the data contradict it."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import norm

from lispac.adjustment.diagnostics.solved_equations import SolvedEquations
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.parameters import OPTIONAL_NAMES
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.solve.omitted_parameters import CRITICAL_VALUE, find_contradicted_parameters
from tests.test_parameters import INSERTED, KNOWN, MODEL, PRIOR, survey


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ["lever_x", "lever_y", "range_offset"])
def test_what_does_harm_is_named_first(name, seed) -> None:
    """A lever arm wrong by 10 cm passes every test against sigmas that were taken from the data."""
    result = adjust(survey(INSERTED[name], seed), PRIOR, MODEL)
    assert result.chi_square.passed
    off = np.abs(result.boresight - KNOWN.boresight)
    first = result.contradictions[0] if result.contradictions else None
    if first is None:  # then it must do none
        assert name == "range_offset"
        assert (off < 3 * result.sigma).all()
        return
    assert first.name == name
    assert abs(first.change - 0.1) < 4 * first.sigma
    mended = result.boresight + first.angle_change - KNOWN.boresight
    assert (np.abs(mended) < 4 * result.sigma).all()
    assert (np.abs(mended) <= np.maximum(off, 2 * result.sigma)).all()


@pytest.mark.parametrize(
    ("wrong", "names"),
    [
        ((0.05, 0.05, 0.0), {"lever_x", "lever_y"}),
        ((0.05, -0.05, 0.0), {"lever_x", "lever_y"}),
        ((0.04, 0.0, 0.0), {"lever_x"}),
    ],
)
def test_a_wrong_lever_arm_is_no_jump_of_good_lines(wrong, names) -> None:
    """Lines would be let go of until the rest agreed with the wrong value."""
    for seed in range(3):
        stated = replace(PRIOR, lever_arm=PRIOR.lever_arm + wrong)
        points = survey(KNOWN, 200 + seed)
        result = adjust(points, stated, MODEL)
        assert result.rejected_sightings == ()
        assert {each.name for each in result.contradictions} == names
        for each in result.contradictions:
            off = wrong["xyz".index(each.name[-1])]
            assert abs(each.change + off) < 4 * each.sigma
            assert each.change == pytest.approx(-off, abs=0.015)


def test_a_shifted_sighting_is_named_beside_a_wrong_lever_arm() -> None:
    from tests.test_robustness import shifted

    stated = replace(PRIOR, lever_arm=PRIOR.lever_arm + [0.1, 0.0, 0.0])
    points = survey(KNOWN, 221)
    result = adjust(shifted(points, 4, 0.3), stated, MODEL)
    assert result.rejected_sightings == (points.sightings[4],)
    assert [each.name for each in result.contradictions] == ["lever_x"]


def test_estimating_it_settles_the_matter() -> None:
    from lispac.adjustment.model.parameters import Parameter

    data = survey(INSERTED["lever_x"], 0)
    held = adjust(data, PRIOR, MODEL)
    estimated = adjust(data, PRIOR, MODEL, parameters=(Parameter("lever_x"),))
    assert [each.name for each in held.contradictions] == ["lever_x"]
    assert 0 < held.contradictions[0].surface_sigma < held.surface
    assert not estimated.contradictions
    # One step of a score test foretells the adjustment with the value let go of.
    (found,) = estimated.parameters
    assert held.contradictions[0].change == pytest.approx(found.value - found.prior, abs=0.002)
    moved = estimated.boresight - held.boresight
    assert np.abs(held.contradictions[0].angle_change - moved).max() < 0.3 * estimated.sigma.max()


@pytest.mark.parametrize("bent", [pytest.param(0.0, marks=pytest.mark.long), 0.003])
def test_nothing_is_contradicted_where_all_is_right(bent) -> None:
    """Surfaces that differ by 3 mm from line to line are no lever arm; 1 in 100 by chance."""
    told = 0
    for seed in range(20):
        data = survey(KNOWN, 1000 + seed)
        off = np.random.default_rng(seed).normal(0, bent, len(data.sightings))[data.sighting]
        beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
        data = replace(data, points_lidar=data.points_lidar + off[:, None] * beams)
        told += len(adjust(data, PRIOR, MODEL).contradictions)
    assert told <= 2


def test_the_level_is_that_of_all_values_together() -> None:
    assert 2 * len(OPTIONAL_NAMES) * norm.sf(CRITICAL_VALUE) == pytest.approx(0.01)


@pytest.mark.long
def test_by_chance_one_survey_in_a_hundred_contradicts_a_value() -> None:
    """Whatever it does to the angles; with a level of one value instead of all it is one in six."""
    told = 0
    for seed in range(30):
        data = survey(KNOWN, 2000 + seed)
        solved = SolvedEquations.of(adjust(data, PRIOR, MODEL, diagnostics=False), data, PRIOR)
        assert solved is not None
        told += bool(find_contradicted_parameters(solved.linearised, min_angle_change=0.0))
    assert told <= 1


def test_the_classical_model_contradicts_nothing() -> None:
    """Its sigmas are too small to judge anything by."""
    result = adjust(survey(INSERTED["lever_x"], 0), PRIOR, StochasticModel("independent"))
    assert result.contradictions == ()
