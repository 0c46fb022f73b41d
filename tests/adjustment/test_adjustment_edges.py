"""Tests of the edge cases of the adjustment: refusals, no convergence and poor geometry."""

from dataclasses import replace

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from lispac.adjustment.diagnostics import excess_scatter
from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.excess_scatter import excess_variance, raise_sigmas_by_scatter
from lispac.adjustment.diagnostics.solved_equations import SolvedEquations
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.parameters import OPTIONAL_NAMES, Parameter
from lispac.adjustment.model.robust_loss import Loss
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import fit_shapes
from lispac.adjustment.model.threads import run_in_chunks, single_blas_thread
from lispac.adjustment.solve import iteration, solver
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.blunders import (
    Blunder,
    find_confirmed_blunders,
    find_restorable_blunder,
    worst_blunder,
)
from lispac.adjustment.solve.determinability import require_determined
from lispac.adjustment.solve.omitted_parameters import find_contradicted_parameters
from lispac.adjustment.solve.variance_components import (
    _RestrictedLikelihood,
    most_likely_surface_sigma,
)
from lispac.errors import AdjustmentError, NotConverged, RankDeficient, TargetDisagrees
from lispac.messages import note
from lispac.simulation.closed_form_survey import (
    Ball,
    Board,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from tests.adjustment.test_robustness import PRIOR, TRUTH, shifted, survey, with_outliers
from tests.studies import coverage_of_errors
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long
from tests.support.surveys import planar_survey

MODEL = StochasticModel()
ROBUST = StochasticModel(loss="tukey")
LEVEL = Mounting(np.array([-0.2, 0.04, 2.4]), np.zeros(3))


def _linearised(
    data: Observations, model: StochasticModel = MODEL, parameters: tuple[Parameter, ...] = ()
) -> LinearisedProblem:
    """Linearise at the true mounting, so that only the data can be wrong."""
    problem = AdjustmentProblem.of(data, TRUTH, model, parameters)
    return problem.linearised(problem.start(TRUTH, fit_shapes(data, TRUTH)), Loss(model.loss))


@pytest.fixture(scope="module")
def few() -> Observations:
    return survey(1, 0.3)


def test_observations_without_points_are_refused(few: Observations) -> None:
    none = few.where(np.zeros(len(few), dtype=bool))
    with pytest.raises(AdjustmentError, check=has_code("adjustment.no_targets")):
        adjust(none, PRIOR, MODEL)


@pytest.mark.parametrize(
    ("name", "value", "code"),
    [
        ("points_lidar", np.nan, "adjustment.point_not_finite"),
        ("position", np.inf, "adjustment.position_not_finite"),
        ("attitude", np.nan, "adjustment.attitude_not_finite"),
        ("time", np.nan, "adjustment.time_not_finite"),
        ("points_lidar", 0.0, "adjustment.point_in_scanner"),
    ],
)
def test_invalid_point_values_are_refused(
    few: Observations, name: str, value: float, code: str
) -> None:
    values = getattr(few, name).copy()
    values[3] = value
    with pytest.raises(AdjustmentError, check=has_code(code)):
        replace(few, **{name: values}).require_usable()
    few.require_usable()


def test_the_convergence_error_reports_the_remaining_change(
    few: Observations, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(iteration, "MAX_ITERATIONS", 2)
    with pytest.raises(
        NotConverged, check=has_code("adjustment.not_converged", iterations=2)
    ) as refused:
        adjust(few, PRIOR, MODEL)
    assert refused.value.message is not None
    assert 0 < refused.value.message.params["angles"] < 0.1
    assert 0 < refused.value.message.params["rest"] < 1.0


def test_a_singular_step_is_reported_as_divergence(
    few: Observations, monkeypatch: pytest.MonkeyPatch
) -> None:
    def singular(self: LinearisedProblem) -> None:
        raise np.linalg.LinAlgError

    monkeypatch.setattr(LinearisedProblem, "next_state", singular)
    with pytest.raises(NotConverged, check=has_code("adjustment.diverged")):
        adjust(few, PRIOR, MODEL)


def test_irls_steps_replace_failing_steps_with_updated_weights(
    few: Observations, monkeypatch: pytest.MonkeyPatch
) -> None:
    usual, failed = adjust(few, PRIOR, ROBUST, diagnostics=False), []
    own = AdjustmentProblem.linearised

    def failing(self, *arguments, tangent=False):
        if tangent:
            failed.append(True)
            raise np.linalg.LinAlgError
        return own(self, *arguments)

    monkeypatch.setattr(AdjustmentProblem, "linearised", failing)
    plain = adjust(few, PRIOR, ROBUST, diagnostics=False)
    assert failed
    assert np.degrees(np.abs(plain.boresight - usual.boresight)).max() < 1e-6


def test_parallel_lines_are_refused_with_two_inclinations() -> None:
    """The message names the parallel lines: the targets face different directions."""
    level = planar_survey(LEVEL, headings_deg=(0, 180), scatter=False)
    level = replace(level, sigma_attitude=10.0 * level.sigma_attitude)
    problem = AdjustmentProblem.of(level, LEVEL, MODEL)
    state = problem.start(LEVEL, fit_shapes(level, LEVEL))
    with pytest.raises(
        RankDeficient,
        check=has_code("adjustment.undetermined_because", reason=note("adjustment.parallel_lines")),
    ):
        require_determined(problem.linearised(state))


def test_a_wrong_lever_arm_that_makes_the_angles_undetermined_is_named() -> None:
    """The lever arm makes the surfaces differ; with such vague attitudes no angle is determined."""
    wrong = replace(PRIOR, lever_arm=PRIOR.lever_arm + [1.0, 0.0, 0.0])
    with pytest.raises(RankDeficient) as refused:
        adjust(survey(1, 0.15).with_scaled_sigmas(1.0, 1.0, 50.0), wrong, MODEL)
    assert refused.value.code == "adjustment.contradicts_lever_arm"
    assert refused.value.message is not None
    assert refused.value.message.params["axis"] == "X"
    assert refused.value.message.params["change"] == pytest.approx(-1.0, abs=0.05)


def test_undetermined_angles_without_a_wrong_given_value_are_refused(few: Observations) -> None:
    vague = few.with_scaled_sigmas(1.0, 1.0, 1000.0)
    with pytest.raises(RankDeficient, check=has_code("adjustment.undetermined")):
        solver._require_still_determined(_linearised(vague))


def test_a_sighting_without_weight_is_neither_a_blunder_nor_restored(few: Observations) -> None:
    """A sighting metres off its surface cannot be tested: it is neither a blunder nor restored."""
    sighting = 4
    usual = fit_shapes(few, TRUTH)
    dirty = shifted(few, sighting, 30.0)
    problem = AdjustmentProblem.of(dirty, TRUTH, ROBUST)
    here = problem.linearised(problem.start(TRUTH, usual), Loss("tukey"))
    off = Blunder("surface", (sighting,))
    assert find_restorable_blunder(here, [off]) is None
    assert find_restorable_blunder(here, [Blunder("surface", (0,))]) is not None
    found = worst_blunder(here, ())
    assert found is None or sighting not in found.sightings


def _balls(metres: float) -> Observations:
    """Six lines past three balls; the third sighting is displaced to the west by ``metres``."""
    places = ((0.0, 15.0, 5.0), (1.5, 12.0, 3.0), (-1.5, 20.0, 7.0))
    balls = [Ball(f"S{k + 1}", place, 0.3, True) for k, place in enumerate(places)]
    generator = np.random.default_rng(3)
    exact = error_free_survey(TRUTH, balls, six_courses(), 0.05, generator)
    clean = add_errors(exact, HYDROGRAPHIC_INS, generator)
    position = clean.position.copy()
    position[clean.sighting == 2] += [0.0, metres, 0.0]
    return replace(clean, position=position)


def test_a_displaced_ball_is_confirmed_as_shifted() -> None:
    """A sphere has no tilt to test."""
    dirty, usual = _balls(0.4), fit_shapes(_balls(0.0), TRUTH)
    problem = AdjustmentProblem.of(dirty, TRUTH, MODEL)
    here = problem.linearised(problem.start(TRUTH, usual))
    rejected = [Blunder("shift", (2,)), Blunder("shift", (9,))]
    assert find_confirmed_blunders(here, rejected) == [Blunder("shift", (2,))]


@pytest.mark.parametrize("metres", others_long([0.5, 3.0]))
def test_a_displaced_ball_is_rejected_and_does_not_bias_the_result(metres: float) -> None:
    near = TRUTH.with_boresight(TRUTH.boresight + np.radians([0.2, -0.2, 0.2]))
    clean, dirty = (adjust(_balls(off), near, ROBUST) for off in (0.0, metres))
    assert clean.rejected_sightings == ()
    assert dirty.rejected_sightings == (Sighting("S1", "L3"),)
    assert (np.abs(dirty.boresight - clean.boresight) < 0.1 * clean.sigma).all()


def test_estimated_values_are_not_contradicted(few: Observations) -> None:
    """Without the rates of the trajectory there is no latency to estimate."""
    wrong = replace(TRUTH, lever_arm=TRUTH.lever_arm + [0.3, 0.0, 0.0])
    data, start = replace(few, pose_rate=None), fit_shapes(few, wrong)
    problem = AdjustmentProblem.of(data, wrong, MODEL)
    found = find_contradicted_parameters(problem.linearised(problem.start(wrong, start)))
    assert "lever_x" in {each.name for each in found}
    free = problem.with_parameters(
        tuple(Parameter(name) for name in OPTIONAL_NAMES if name != "latency")
    )
    assert find_contradicted_parameters(free.linearised(free.start(wrong, start))) == ()


@pytest.mark.parametrize(
    ("one", "other"),
    [((), (Parameter("lever_x", 1e-6),)), ((Parameter("lever_x"),), (Parameter("lever_x", 1e4),))],
)
def test_the_sigma_of_a_given_value_enters_the_likelihood(
    few: Observations, one: tuple[Parameter, ...], other: tuple[Parameter, ...]
) -> None:
    """A tiny sigma acts like a fixed value, a huge sigma like a free parameter."""
    likelihoods = [
        _RestrictedLikelihood(_linearised(few, parameters=each)) for each in (one, other)
    ]
    factors = np.log([1.3, 0.7, 1.5, 1.0])
    rises = [likelihood(factors) - likelihood(np.zeros(4)) for likelihood in likelihoods]
    assert rises[1] == pytest.approx(rises[0], rel=1e-4)
    free = _RestrictedLikelihood(_linearised(few, parameters=(Parameter("lever_x", 0.01),)))
    assert free(factors) - free(np.zeros(4)) != pytest.approx(rises[0], rel=1e-4)


def test_variance_factors_of_a_single_round_are_reported_and_used(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The sigmas of the position are five times too small; one round is not enough to converge."""
    monkeypatch.setattr(solver, "MAX_COMPONENT_ROUNDS", 1)
    scaled = survey(1, 0.3).with_scaled_sigmas(1.0, 0.2, 1.0)
    found = adjust(scaled, PRIOR, MODEL, components=True, diagnostics=False)
    position = found.components[1]
    assert position.applied
    assert position.lower < 5.0 < position.upper
    assert position.used == pytest.approx(position.factor, rel=0.2)


def test_chunks_cover_all_points_and_no_chunk_is_empty() -> None:
    called: list[tuple[int, int]] = []
    run_in_chunks(lambda first, last: called.append((first, last)), np.zeros(0, np.int64))
    assert called == []
    run_in_chunks(lambda first, last: called.append((first, last)), np.array([5, 9]))
    assert called == [(0, 2)]
    called.clear()
    run_in_chunks(lambda first, last: called.append((first, last)), np.arange(1, 40_001))
    first, last = np.array(sorted(called)).T
    assert len(called) == 16
    np.testing.assert_array_equal([*first, 40_000], [0, *last])
    assert np.ptp(last - first) <= 2


def test_the_scatter_of_only_two_parts_is_not_reported(
    few: Observations, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two parts of a kind are too few for a jackknife."""
    solved = SolvedEquations.of(adjust(few, PRIOR, MODEL), few, PRIOR)
    assert solved is not None
    assert excess_variance(solved.linearised, solved.origins).shape == (3,)
    monkeypatch.setattr(excess_scatter, "PARTS_PER_LINE", 2)
    np.testing.assert_array_equal(excess_variance(solved.linearised, solved.origins), np.zeros(3))


ADJACENT_BOARDS = (
    Board("T1", (0.0, 15.0, 5.0), (0.0, -1.0, 0.0)),
    Board("T2", (3.0, 14.0, 3.0), (0.0, -1.0, 1.0)),
    Board("T3", (-3.0, 16.0, 6.0), (1.0, -2.0, 0.0)),
    Board("T4", (6.0, 15.0, 4.0), (-3.0, -5.0, 2.0)),
)


def test_the_excess_variance_agrees_with_adjustments_without_each_target(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Two sightings displaced; the jackknife minus the predicted variances (Tukey, Hausman)."""
    monkeypatch.setattr(
        excess_scatter, "PARTS_PER_LINE", 2
    )  # too few parts for a scatter of the lines
    generator = np.random.default_rng(5)
    exact = error_free_survey(TRUTH, ADJACENT_BOARDS, six_courses(), 0.5, generator)
    data = shifted(add_errors(exact, HYDROGRAPHIC_INS, generator), 2, 0.02)
    model = replace(MODEL, surface=0.001)
    whole = adjust(data, TRUTH, model, diagnostics=False)
    parts = []
    for target in data.targets:
        kept = np.array([each.target != target for each in data.sightings])
        parts.append(adjust(data.of_sightings(kept), TRUTH, model, diagnostics=False))
    off = np.array([part.boresight - whole.boresight for part in parts])
    predicted = np.array([part.sigma**2 - whole.sigma**2 for part in parts])
    expected = 3 / 4 * np.maximum((off**2 - predicted).sum(axis=0), 0.0)
    solved = SolvedEquations.of(whole, data, TRUTH)
    assert solved is not None
    more = excess_variance(solved.linearised, solved.origins)
    np.testing.assert_allclose(more, expected, rtol=0.01)
    assert np.count_nonzero(expected) == 2
    raised = raise_sigmas_by_scatter(whole, solved.linearised, solved.origins)
    np.testing.assert_allclose(raised.sigma**2, whole.sigma**2 + more)
    np.testing.assert_allclose(raised.correlation_all, whole.correlation_all)


@pytest.mark.parametrize("loss", ["huber", "tukey"])
def test_the_tangent_equations_include_the_change_of_the_weights(
    few: Observations, loss: str
) -> None:
    """Reference: difference quotients; with constant weights the matrix is wrong by a tenth."""
    outliers, _ = with_outliers(few, 3)
    model = StochasticModel(loss=loss, surface=0.001)
    solved = SolvedEquations.of(adjust(outliers, PRIOR, model, diagnostics=False), outliers, PRIOR)
    assert solved is not None
    here, step = solved.linearised.tangent, 1e-6
    mounting = here.state.mounting

    def pull(turn: np.ndarray) -> np.ndarray:
        moved = mounting.with_boresight(mounting.boresight + turn)
        state = replace(here.state, mounting=moved)
        return here.problem.linearised(state, Loss(loss)).normal.right

    for k, turn in enumerate(step * np.eye(3)):
        change = (pull(-turn)[k] - pull(turn)[k]) / (2 * step)
        assert here.normal.matrix[k, k] == pytest.approx(change, rel=0.01)


def test_the_remaining_change_is_the_sum_of_a_geometric_series() -> None:
    last, change = np.array([8.0, 10.0, 0.0, 4.0]), np.array([4.0, 1.0, 1.0, 4.0])
    # 2 + 1 + ..., 0.1 + 0.01 + ..., with a ratio of at most one half
    np.testing.assert_allclose(iteration._remaining_change(change, last), [4.0, 1 / 9, 1.0, 4.0])


def test_matrix_products_use_a_single_blas_thread() -> None:
    with threadpool_limits(limits=3), single_blas_thread():
        inside = [each for each in threadpool_info() if each["user_api"] == "blas"]
    assert inside
    assert [each["num_threads"] for each in inside] == [1] * len(inside)


@pytest.mark.parametrize(("lines", "named"), [(("L1", "L3"), False), (("L1", "L3", "L5"), True)])
def test_neither_of_two_sightings_of_a_target_is_rejected(
    lines: tuple[str, ...], named: bool
) -> None:
    """A target with a single remaining sighting could not be checked."""
    whole = survey(1, 0.3)
    data = whole.of_sightings(np.array([each.line in lines for each in whole.sightings]))
    problem = AdjustmentProblem.of(shifted(data, 1, 0.3), TRUTH, replace(MODEL, surface=0.001))
    here = problem.linearised(problem.start(TRUTH, fit_shapes(data, TRUTH)))
    assert worst_blunder(here, ()) == (Blunder("shift", (1,)) if named else None)


def test_the_chi_square_statistic_is_the_quadratic_form_of_the_equations(few: Observations) -> None:
    """Contributions: points, POS errors, surfaces and a given value, each over its sigma."""
    data, off = shifted(few, 2, 0.02), replace(TRUTH, lever_arm=TRUTH.lever_arm + [0.02, 0.0, 0.0])
    parameters = (Parameter("lever_x", 0.01),)
    result = adjust(data, off, MODEL, parameters=parameters, diagnostics=False)
    solved = SolvedEquations.of(result, data, off, parameters)
    assert solved is not None
    assert np.abs(solved.linearised.departures).max() > 0
    assert result.chi_square.statistic == pytest.approx(
        solved.linearised.normal.quadratic, rel=1e-6
    )


def test_a_contradiction_needs_a_minimum_effect_on_the_angles(
    few: Observations,
) -> None:
    wrong = replace(TRUTH, lever_arm=TRUTH.lever_arm + [0.04, 0.0, 0.0])
    problem = AdjustmentProblem.of(few, wrong, MODEL)
    first = problem.linearised(problem.start(wrong, fit_shapes(few, wrong)))
    here = problem.linearised(first.next_state()[0])
    (found,) = find_contradicted_parameters(here, min_angle_change=1.0)
    assert 3.5 < abs(found.w) < 5.5  # above 6 it is reported whatever its effect on the angles
    sigmas = np.abs(found.angle_change / np.sqrt(np.diag(here.normal.covariance)[:3])).max()
    assert sigmas > 1.0
    assert find_contradicted_parameters(here, min_angle_change=1.01 * sigmas) == ()


def test_the_surface_sigma_maximises_the_restricted_likelihood(few: Observations) -> None:
    """Reference: restricted likelihood (Patterson and Thompson 1971) with new equations."""
    data = shifted(shifted(few, 2, 0.004), 7, -0.003)
    problem = AdjustmentProblem.of(data, TRUTH, MODEL)
    state = problem.start(TRUTH, fit_shapes(data, TRUTH))

    def unlikely(sigma: float) -> float:
        here = problem.with_surface_sigma(sigma)
        normal = here.linearised(state).normal
        fitted = normal.reduced_right_side @ normal.covariance @ normal.reduced_right_side
        return float(
            np.linalg.slogdet(normal.reduced_matrix)[1]
            + 2 * np.log(here.surface_sigma).sum()
            + normal.quadratic
            - fitted
        )

    found = most_likely_surface_sigma(problem.linearised(state))
    assert 0.0002 < found < 0.01
    assert unlikely(found) < min(unlikely(0.8 * found), unlikely(1.25 * found))


@LONG
def test_a_target_without_weight_is_excluded_and_the_rest_is_estimated() -> None:
    """As when none of its points agrees with the other targets; cross-checks exclude it too."""
    prior, model = coverage_of_errors.PRIOR, coverage_of_errors.MODEL
    data = coverage_of_errors.survey("none", 3)
    own = data.target_of_sighting[data.sighting] == data.targets.index("T5")
    weightless = replace(data, sigma_lidar=np.where(own[:, None], 1e160, data.sigma_lidar))
    result = adjust(weightless, prior, model)
    assert result.excluded_targets == ("T5",)
    without = adjust(data.without_targets(["T5"]), prior, model)
    assert result.boresight == pytest.approx(without.boresight, abs=1e-12)
    checks = cross_checks(weightless, prior, result)
    assert "T5" not in {part.part for part in checks.parts}
    assert "adjustment.target_excluded" in {
        message.code for message in result_warnings(result, checks)
    }
    # With too few targets for a comparison, the adjustment is refused with the reason.
    two = weightless.without_targets([name for name in data.targets if name not in ("T1", "T5")])
    with pytest.raises(TargetDisagrees) as caught:
        adjust(two, prior, model)
    assert caught.value.target == "T5"
