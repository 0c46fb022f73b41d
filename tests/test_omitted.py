"""A value of the mounting that is stated wrongly and not estimated: the data contradict it."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.solver import adjust
from lispac.adjustment.stochastic import StochasticModel
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
    mended = result.boresight + first.moved - KNOWN.boresight
    assert (np.abs(mended) < 4 * result.sigma).all()
    assert (np.abs(mended) <= np.maximum(off, 2 * result.sigma)).all()


def test_estimating_it_settles_the_matter() -> None:
    from lispac.adjustment.parameters import Parameter

    data = survey(INSERTED["lever_x"], 0)
    held = adjust(data, PRIOR, MODEL)
    estimated = adjust(data, PRIOR, MODEL, parameters=(Parameter("lever_x"),))
    assert [each.name for each in held.contradictions] == ["lever_x"]
    assert not estimated.contradictions
    # One step of a score test foretells the adjustment with the value let go of.
    (found,) = estimated.parameters
    assert held.contradictions[0].change == pytest.approx(found.value - found.prior, abs=0.002)
    moved = estimated.boresight - held.boresight
    assert np.abs(held.contradictions[0].moved - moved).max() < 0.3 * estimated.sigma.max()


@pytest.mark.parametrize("bent", [0.0, 0.003])
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


def test_thesis_mode_contradicts_nothing() -> None:
    """Its sigmas are too small to judge anything by."""
    result = adjust(survey(INSERTED["lever_x"], 0), PRIOR, StochasticModel("independent"))
    assert result.contradictions == ()
