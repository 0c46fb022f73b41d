"""Tests of the detection of lines whose position is shifted as a whole."""

import numpy as np
import pytest

from lispac.adjustment.diagnostics.line_shifts import AXIS_COUNT, LineShiftScores
from lispac.adjustment.diagnostics.solved_equations import SolvedEquations
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.project import Project
from lispac.workflow.calibration.estimation import observations_of
from lispac.workflow.project.survey import load_survey
from tests.adjustment.test_robustness import PRIOR, survey
from tests.natural.test_targetless import few_surfaces

SHIFT = 6.0
"""Shift of a line in units of its prior sigma."""


def line_shift_scores(*shifts: float) -> LineShiftScores:
    """Return noise-free scores of lines shifted northwards by these multiples of the sigma."""
    count = len(shifts)
    differences = np.kron(np.eye(count) - 1.0 / count, np.eye(AXIS_COUNT))
    off = np.zeros(count * AXIS_COUNT)
    off[::AXIS_COUNT] = shifts
    return LineShiftScores(tuple("ABCDEF"[:count]), differences @ off, differences)


@pytest.mark.parametrize(
    ("shifts", "named"),
    [
        ((1.0, -1.0, 0.5, -0.5, 1.2, -1.2), ""),
        ((SHIFT, 0.0, 0.0, 0.0, 0.0, 0.0), "A"),
        ((SHIFT, 0.0, 0.0, -SHIFT, 0.0, 0.0), "AD"),
        # The shift moves the other lines by four sigmas each; they must not be named.
        ((4 * SHIFT, 0.0, 0.0, 0.0, 0.0, 0.0), "A"),
        # As many lines disagree as agree: only the largest shifts are named.
        ((9.0, -9.0, 9.0, -9.0, 20.0, -20.0), "EF"),
        ((SHIFT, 0.0, 0.0), "A"),
        ((SHIFT, 0.0), "AB"),
        ((0.0, 0.0), ""),
    ],
)
def test_only_shifted_lines_are_named(shifts: tuple[float, ...], named: str) -> None:
    assert "".join(line_shift_scores(*shifts).shifted_lines()) == named


def test_the_scores_without_a_line_are_those_of_the_other_lines() -> None:
    after = line_shift_scores(SHIFT, 1.0, 0.0, 0.0).without_line_shift(0)
    np.testing.assert_allclose(after.score[:AXIS_COUNT], 0.0, atol=1e-12)
    np.testing.assert_allclose(after.variance[:AXIS_COUNT], 0.0, atol=1e-12)
    # The scores of the three other lines, relative to their mean.
    np.testing.assert_allclose(after.score[AXIS_COUNT::AXIS_COUNT], np.array([2.0, -1.0, -1.0]) / 3)


@pytest.fixture(scope="module")
def here(demo_project: Project, tmp_path_factory: pytest.TempPathFactory) -> LinearisedProblem:
    survey = load_survey(demo_project)
    found = few_surfaces((demo_project, survey), tmp_path_factory).project
    prior, model = found.mounting("prior"), demo_project.settings.stochastic_model
    observations = observations_of(found, survey, mounting=found.mounting("estimated"))
    solved = SolvedEquations.of(adjust(observations, prior, model), observations, prior)
    assert solved is not None
    return solved.linearised


@pytest.mark.long
def test_scores_are_those_of_dense_matrices(here: LinearisedProblem) -> None:
    _compare_with_dense_matrices(here)


def test_scores_of_a_few_boards_are_those_of_dense_matrices() -> None:
    data = survey(1, 0.3)
    solved = SolvedEquations.of(
        adjust(data, PRIOR, StochasticModel(), diagnostics=False), data, PRIOR
    )
    assert solved is not None
    _compare_with_dense_matrices(solved.linearised)


def _compare_with_dense_matrices(here: LinearisedProblem) -> None:
    normal, problem = here.normal, here.problem
    knots, observations = problem.groups.knots, problem.observations
    assert knots is not None
    size = 6 * len(knots.time)
    own = np.zeros((size, size))
    for below, values in enumerate(normal.band):
        rows = np.arange(size - below)
        own[rows + below, rows] = own[rows, rows + below] = values[: size - below]
    whole = np.block([[normal.matrix, normal.mixed], [normal.mixed.T, own]])
    after = np.linalg.inv(whole)[len(normal.matrix) :, len(normal.matrix) :]
    weights = np.stack(
        [knots.apply_prior_precision(each.reshape(-1, 6)).reshape(-1) for each in np.eye(size)],
        axis=1,
    )
    scores = LineShiftScores.of(here)
    lines = np.array([each.line for each in observations.sightings])[observations.sighting]
    shifts = []
    for line in scores.lines:
        first = knots.left[lines == line]
        for axis in range(AXIS_COUNT):
            shift = np.zeros((len(knots.time), 6))
            shift[np.union1d(first, first + 1), axis] = 1.0
            shifts.append(shift.reshape(-1))
    moved = np.array(shifts).T
    prior = moved.T @ weights @ moved
    root = np.sqrt(np.diag(prior))
    variance = (prior - moved.T @ weights @ after @ weights @ moved) / np.outer(root, root)
    score = moved.T @ weights @ here.state.pos_corrections.reshape(-1) / root
    np.testing.assert_allclose(scores.variance, variance, rtol=0, atol=1e-7)
    np.testing.assert_allclose(scores.score, score, rtol=0, atol=1e-7)
    for k in range(len(scores.lines)):
        own = slice(AXIS_COUNT * k, AXIS_COUNT * (k + 1))
        shares = np.linalg.eigvalsh(variance[own, own])
        assert (shares > -1e-9).all()  # zero for a direction that no surface faces
        assert (shares < 1).all()
