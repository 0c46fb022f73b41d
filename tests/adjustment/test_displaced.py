"""Tests of targets displaced from line to line: offsets with a separate sigma."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Board,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from tests.adjustment.test_robustness import PRIOR, TRUTH, jumped, shifted
from tests.support.long_runs import LONG

FIVE_BOARDS = (
    *THESIS_BOARDS,
    Board("T3", (3.0, 25.0, 2.0), (-0.6, -1.0, 0.2)),
    Board("T4", (-5.0, 12.0, 0.5), (0.7, -1.0, 0.6)),
    Board("T5", (2.0, 10.0, -1.0), (0.0, -0.2, 1.0)),
)
MODEL = StochasticModel(loss="tukey")


def survey(
    seed: int, displaced: float = 0.0, boards: tuple[Board, ...] = FIVE_BOARDS
) -> Observations:
    """Survey whose sightings are displaced along the beams by normal deviates."""
    generator = np.random.default_rng([99, seed])
    exact = error_free_survey(TRUTH, boards, six_courses(), 0.12, generator)
    data = add_errors(exact, HYDROGRAPHIC_INS, generator)
    off = generator.normal(0, displaced, len(data.sightings))[data.sighting]
    beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
    return replace(data, points_lidar=data.points_lidar + off[:, None] * beams)


def few_are_rejected(results: list[AdjustmentResult]) -> None:
    """Check that few sightings are rejected and that errors agree with their sigmas."""
    let_go = [bool(result.rejected_sightings) for result in results]
    assert sum(let_go) <= len(results) / 3
    ratios = np.array([(result.boresight - TRUTH.boresight) / result.sigma for result in results])
    lower, upper = np.sqrt(scipy.stats.chi2.ppf([0.0005, 0.9995], len(results)) / len(results))
    spread = np.sqrt((ratios**2).mean(axis=0))
    assert ((spread > lower) & (spread < upper)).all(), spread


@LONG
def test_good_sightings_of_displaced_boards_are_not_rejected() -> None:
    """With one sigma for offsets and tilts, four surveys of five would reject sightings."""
    results = [
        adjust(survey(400 + k, 0.005), PRIOR, MODEL, diagnostics=False) for k in (0, 2, 7, 8)
    ]
    few_are_rejected(results)
    offsets = [result.offset for result in results if result.offset is not None]
    assert len(offsets) >= 2
    assert all(0.001 < offset < 0.010 for offset in offsets)
    assert all(result.surface < 0.001 for result in results)


@pytest.mark.long
def test_good_sightings_of_displaced_boards_are_not_rejected_in_many_surveys() -> None:
    few_are_rejected([adjust(survey(400 + k, 0.005), PRIOR, MODEL) for k in range(24)])


@pytest.mark.parametrize("boards", [pytest.param(THESIS_BOARDS, marks=LONG), FIVE_BOARDS])
def test_boards_without_displacement_have_no_offset_sigma(boards) -> None:
    for seed in range(5000, 5003):
        found = adjust(survey(seed, 0.0, boards), PRIOR, MODEL, diagnostics=False)
        assert found.offset is None


@pytest.mark.long
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("boards", [THESIS_BOARDS, FIVE_BOARDS])
def test_boards_without_displacement_have_no_offset_sigma_in_many_surveys(boards) -> None:
    for seed in range(5000, 5060):
        assert adjust(survey(seed, 0.0, boards), PRIOR, MODEL).offset is None


@pytest.mark.parametrize("boards", [pytest.param(THESIS_BOARDS, marks=LONG), FIVE_BOARDS])
def test_one_displaced_sighting_is_a_blunder_and_no_offset_sigma(boards) -> None:
    clean = survey(700, 0.0, boards)
    found = adjust(shifted(clean, 8, 0.05), PRIOR, MODEL)
    assert found.offset is None
    assert found.rejected_sightings == (clean.sightings[8],)


@LONG
def test_a_displaced_line_is_rejected_and_no_offset_sigma() -> None:
    clean = survey(700)
    found = adjust(jumped(clean, "L6", [0.0, 0.1, 0.05]), PRIOR, MODEL)
    assert found.offset is None
    assert found.rejected_lines == ("L6",)


@LONG
@pytest.mark.parametrize("boards", [pytest.param(THESIS_BOARDS, marks=LONG), FIVE_BOARDS])
def test_a_wrong_lever_arm_is_not_mistaken_for_displaced_targets(boards) -> None:
    wrong_prior = replace(PRIOR, lever_arm=PRIOR.lever_arm + [0.1, 0.0, 0.0])
    found = adjust(survey(701, 0.0, boards), wrong_prior, MODEL)
    assert found.offset is None
    assert [each.name for each in found.contradictions] == ["lever_x"]


@pytest.mark.long
def test_a_wrong_lever_arm_and_a_blunder_are_detected_with_displaced_targets() -> None:
    clean = survey(407, 0.005)
    wrong_prior = replace(PRIOR, lever_arm=PRIOR.lever_arm + [0.1, 0.0, 0.0])
    assert [each.name for each in adjust(clean, wrong_prior, MODEL).contradictions] == ["lever_x"]
    assert clean.sightings[8] in adjust(shifted(clean, 8, 0.06), PRIOR, MODEL).rejected_sightings


@pytest.mark.long
def test_cross_checks_use_the_sigmas_of_the_whole_survey() -> None:
    """A part alone hardly determines the sigmas; no part disagrees with the whole."""
    data = survey(407, 0.005)
    checks = cross_checks(data, PRIOR, adjust(data, PRIOR, MODEL))
    assert not checks.disagreements


@LONG
def test_the_estimated_offset_sigma_can_be_given() -> None:
    data = survey(407, 0.005)
    whole = adjust(data, PRIOR, MODEL, diagnostics=False)
    assert whole.offset is not None
    tilts, also, offset = whole.surfaces
    assert tilts == also == whole.surface
    given_model = replace(MODEL, surface=tilts, offset=offset)
    same = adjust(data, PRIOR, given_model, diagnostics=False)
    assert same.offset == offset
    assert np.abs(same.boresight - whole.boresight).max() < 0.05 * whole.sigma.min()
