"""Tests of the predicted sigmas and point counts of a plan, against simulated surveys."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.stochastic_model import PosErrors, StochasticModel
from lispac.adjustment.solve.normal_equations import MAX_UNELIMINATED_SURFACES
from lispac.design.monte_carlo import simulate_plan
from lispac.design.plan import Line, Plan, System, line_pattern
from lispac.design.prediction import expected_point_count, predict, predicted_equations
from lispac.errors import RankDeficient
from lispac.present.planning.design_results import SimulationValues
from lispac.simulation.closed_form_survey import Ball, Board, scanner_position_abeam
from lispac.simulation.scanner import Scanner, scan_scene
from lispac.simulation.scene import Scene, upright_rectangle
from tests.studies.prediction_study import PLAN, compared
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG


@pytest.mark.parametrize(("model", "perfect"), [("correlated", False), ("independent", True)])
def test_the_adjustment_has_the_predicted_sigmas(model: PosErrors, perfect: bool) -> None:
    """One survey with all points and no waves; rolling changes the sigma of pitch by 1 to 3 %.

    With errors in the data the sigmas of uncorrelated POS errors (classical) are up to 3 % smaller,
    because the derivatives share the noise of the points. Without errors, the correlated model
    estimates that the points have no noise.
    """
    observations = simulate_plan(PLAN, np.random.default_rng(5), perfect=perfect, calm=True)
    pos = PLAN.system.pos
    plan = replace(PLAN, system=System(pos_errors=model))
    stochastic_model = StochasticModel(
        model, pos.time_position, pos.time_attitude, surface=plan.flatness
    )
    result = adjust(observations, plan.system.mounting, stochastic_model, diagnostics=False)
    assert predict(plan).sigma == pytest.approx(result.sigma, rel=0.01)


def crossing_lines_with_control(control_sigma: float | None) -> Plan:
    """Plan with two crossing lines, in which control matters, a sphere and two boards."""
    ball = Ball("S1", (1.5, -14.0, 4.0), 0.2)
    targets = [replace(each, control_sigma=control_sigma) for each in (*PLAN.targets, ball)]
    return PLAN.with_targets(targets).with_lines(PLAN.lines[1:3])


def test_the_adjustment_with_control_has_the_predicted_sigmas() -> None:
    """The mean of ten surveys without waves: the noise of a sphere is estimated within 3 %."""
    plan, without = crossing_lines_with_control(0.002), crossing_lines_with_control(None)
    pos = plan.system.pos
    model = StochasticModel("correlated", pos.time_position, pos.time_attitude, plan.flatness)
    sigmas = []
    for seed in range(10):
        observations = simulate_plan(plan, np.random.default_rng(seed), calm=True)
        assert observations.control is not None
        assert len(observations.control) == 4 + 4 + 1
        result = adjust(observations, plan.system.mounting, model, diagnostics=False)
        sigmas.append(result.sigma)
    assert predict(plan).sigma == pytest.approx(np.mean(sigmas, axis=0), rel=0.01)
    assert (predict(plan).sigma < 0.97 * predict(without).sigma).any()
    assert predict(plan.without_control()).sigma == pytest.approx(predict(without).sigma)


def lines_with_uncertain_lever_arm() -> Plan:
    """Plan with four lines and a lever arm that is measured within 2 and 3 cm."""
    system = replace(PLAN.system, lever_arm_sigma=(0.02, 0.02, 0.03))
    return replace(PLAN.with_lines(PLAN.lines[:4]), system=system)


def test_the_adjustment_has_the_sigmas_predicted_with_those_of_the_lever_arm() -> None:
    plan = lines_with_uncertain_lever_arm()
    exact = replace(plan, system=replace(plan.system, lever_arm_sigma=(0.0, 0.0, 0.0)))
    pos = plan.system.pos
    observations = simulate_plan(plan, np.random.default_rng(5), calm=True)
    for each, sigma in ((plan, plan.system.lever_arm_sigma), (exact, None)):
        model = StochasticModel(
            "correlated", pos.time_position, pos.time_attitude, plan.flatness,
            lever_arm_sigma=sigma,
        )  # fmt: skip
        result = adjust(observations, plan.system.mounting, model, diagnostics=False)
        assert predict(each).sigma == pytest.approx(result.sigma, rel=0.02)
    assert (predict(plan).sigma > 1.2 * predict(exact).sigma).any()


@pytest.mark.parametrize(
    ("count", "workers"), [(40, 1), pytest.param(300, 2, marks=pytest.mark.long)]
)
def test_surveys_scatter_as_predicted_with_a_wrong_lever_arm(count: int, workers: int) -> None:
    """The limits are those of the chi-square and binomial distributions at 0.1 %."""
    plan = lines_with_uncertain_lever_arm()
    found = compared(plan, count, flatness_known=True, workers=workers)
    print(SimulationValues.of(found))
    assert found.failed == 0
    lower, upper = np.sqrt(scipy.stats.chi2.ppf([0.0005, 0.9995], count) / count)
    ratio = found.empirical_sigma / found.predicted
    assert ((ratio > lower) & (ratio < upper)).all(), SimulationValues.of(found)
    fewest = scipy.stats.binom.ppf(0.0005, count, 0.95) / count
    assert (found.interval_coverage >= fewest).all(), SimulationValues.of(found)


def test_planned_control_without_errors_lies_on_the_targets() -> None:
    plan = crossing_lines_with_control(0.002)
    observations = simulate_plan(plan, np.random.default_rng(5), perfect=True)
    mounting = plan.system.mounting
    start = mounting.with_boresight(mounting.boresight + np.radians([0.1, -0.2, 0.3]))
    pos = plan.system.pos
    model = StochasticModel("correlated", pos.time_position, pos.time_attitude, plan.flatness)
    result = adjust(observations, start, model)
    assert np.abs(result.boresight - mounting.boresight).max() < 1e-9
    assert max(abs(each.residual) for each in result.control) < 1e-9
    wide = crossing_lines_with_control(10.0)  # control that is less precise than all else
    assert predict(wide).sigma == pytest.approx(
        predict(crossing_lines_with_control(None)).sigma, rel=1e-4
    )


@LONG
@pytest.mark.parametrize(
    ("count", "workers"), [(30, 1), pytest.param(300, 2, marks=pytest.mark.long)]
)
def test_surveys_with_control_scatter_as_predicted(count: int, workers: int) -> None:
    """The limits are those of the chi-square and binomial distributions at 0.1 %."""
    found = compared(
        crossing_lines_with_control(0.002), count, flatness_known=True, workers=workers
    )
    assert found.failed == 0
    lower, upper = np.sqrt(scipy.stats.chi2.ppf([0.0005, 0.9995], count) / count)
    ratio = found.empirical_sigma / found.predicted
    assert ((ratio > lower) & (ratio < upper)).all(), SimulationValues.of(found)
    fewest = scipy.stats.binom.ppf(0.0005, count, 0.95) / count
    assert (found.interval_coverage >= fewest).all(), SimulationValues.of(found)


def test_the_expected_point_count_agrees_with_a_simulated_scan() -> None:
    """A profiler passes on a calm sea."""
    system = System(scanner=Scanner(60_000.0))
    surface = upright_rectangle("T1", (0.0, -12.0), 4.0, 5.5, 1.8, 270)
    board = Board("T1", (0.0, -12.0, 4.75), (0.0, 1.0, 0.0), 1.8, 1.5)
    for line in line_pattern((0, 45, 135), 12.0):
        plan = Plan((board,), (line,), board.centre, system)
        (course,) = plan.courses
        time = course.time + np.linspace(-20, 20, 4001)
        position = (time - course.time)[:, None] * course.speed * course.direction
        position[:, :2] += course.abeam
        attitude = np.tile([0.0, 0.0, course.heading], (len(time), 1))
        echoes = scan_scene(
            system.scanner, Scene.of([surface]), (time, position, attitude),
            (float(time[0]), float(time[-1])), line.starboard, system.mounting, None,
        )  # fmt: skip
        count = expected_point_count(
            system, board, course, scanner_position_abeam(system.mounting, board, course)
        )
        profiles = len(np.unique(np.round(echoes.time * system.scanner.turns_per_second)))
        # The number of points per profile may differ by one
        assert abs(count - len(echoes.time)) <= profiles + len(echoes.time) / profiles
        assert count > 0.9 * len(echoes.time)


def test_boards_that_face_away_or_are_too_far_have_no_points() -> None:
    away = Board("T3", (0.0, -15.0, 5.0), (0.0, -1.0, 0.0))
    assert predict(PLAN.with_targets([away])).points == {}
    assert not predict(PLAN.with_targets([away])).determined
    with pytest.raises(RankDeficient, check=has_code("design.no_sightings")):
        predicted_equations(PLAN.with_targets([away]))
    near = replace(PLAN, system=System(scanner=Scanner(150_000.0, max_range=20.0)))
    far = near.with_lines((Line(0.0, 30.0), *near.lines))
    assert {line for _, line in predict(far).points} == {f"L{k}" for k in range(2, 8)}


def test_one_line_or_one_heading_determines_no_angle() -> None:
    one = predict(PLAN.with_lines([Line(0.0)]))
    assert not one.determined
    assert np.isinf(one.sigma).all()
    assert np.isnan(one.correlation).all()
    assert not predict(PLAN.with_lines([Line(0.0), Line(0.0)])).determined


def test_more_data_never_increase_a_sigma() -> None:
    """A further target, a further line and a better POS are tested."""
    usual = predict(PLAN).sigma
    more = (*PLAN.targets, Board("T3", (3.0, -15.0, 9.0), (0.3, 1.0, 0.3)))
    assert (predict(PLAN.with_targets(more)).sigma <= usual * (1 + 1e-9)).all()
    assert (predict(PLAN.with_lines((*PLAN.lines, Line(20.0)))).sigma <= usual * (1 + 1e-9)).all()
    better = replace(PLAN, system=PLAN.system.with_pos_scaled(0.5))
    assert (predict(better).sigma < usual).all()
    assert (predict(PLAN.with_lines(PLAN.lines[:5])).sigma >= usual).all()


def test_the_prediction_does_not_depend_on_the_heading_of_the_site() -> None:
    """The sigmas of the POS are the same to the north and to the west."""
    turn = np.radians(37.0)
    matrix = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])

    def turned(vector: tuple[float, float, float]) -> tuple[float, float, float]:
        north, west = matrix @ vector[:2]
        return float(north), float(west), vector[2]

    boards = [
        replace(t, centre=turned(t.centre), normal=turned(t.normal))
        for t in PLAN.targets
        if isinstance(t, Board)
    ]
    lines = [replace(line, heading_deg=line.heading_deg + 37.0) for line in PLAN.lines]
    other = replace(PLAN, targets=tuple(boards), lines=tuple(lines), middle=turned(PLAN.middle))
    assert predict(other).sigma == pytest.approx(predict(PLAN).sigma, rel=1e-6)


@pytest.mark.parametrize("lines", [1, 2])
def test_elimination_agrees_with_a_dense_matrix(lines: int) -> None:
    """The inverse of one matrix of all unknowns does not depend on the order of elimination."""
    ball = Ball("S1", (0.0, -13.0, 6.0), 0.2, radius_known=False)
    plan = PLAN.with_targets((*PLAN.targets, ball)).with_lines(PLAN.lines * lines)
    normal = predicted_equations(plan).normal
    surfaces, knots = len(normal.layout.surfaces), len(normal.pos_right)
    assert (len(normal.eliminate_surfaces.matrix) < len(normal.matrix)) == (
        surfaces > MAX_UNELIMINATED_SURFACES
    )
    below = np.zeros((knots, knots))
    for k, diagonal in enumerate(normal.band):
        below += np.diag(diagonal[: knots - k], -k)
    of_knots = below + below.T - np.diag(np.diag(below))
    whole = np.block([[normal.matrix, normal.mixed], [normal.mixed.T, of_knots]])
    scale = 1 / np.sqrt(np.diag(whole))
    covariance = np.linalg.inv(whole * np.outer(scale, scale)) * np.outer(scale, scale)
    expected = np.linalg.inv(covariance[:3, :3])
    size = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    assert np.abs((normal.information(3) - expected) / size).max() < 1e-9
    assert np.sqrt(np.diag(covariance)[:3]) == pytest.approx(predict(plan).sigma, rel=1e-9)
    kept = len(normal.eliminate_surfaces.matrix)
    solution = np.linalg.solve(whole * np.outer(scale, scale), scale * np.append(
        np.ones(len(normal.matrix)), np.arange(knots)
    ))[:kept] * scale[:kept]  # fmt: skip
    pushed = replace(normal, right=np.ones(len(normal.matrix)), pos_right=np.arange(knots) * 1.0)
    correction, _ = pushed.eliminate_surfaces.solve()
    assert correction == pytest.approx(solution, rel=1e-6)


def test_spheres_determine_the_boresight() -> None:
    balls = (
        Ball("S1", (0.0, -15.0, 5.0), 0.3),
        Ball("S2", (4.0, -14.0, 2.0), 0.3, radius_known=False),
    )
    found = predict(PLAN.with_targets(balls))
    assert found.determined
    assert set(found.points) == {(b.name, f"L{k}") for b in balls for k in range(1, 7)}


def test_forty_surveys_scatter_as_predicted() -> None:
    """The limits are those of the chi-square distribution at 0.1 % for each angle."""
    count = 40
    found = compared(PLAN, count, flatness_known=True, workers=1)
    lower, upper = np.sqrt(scipy.stats.chi2.ppf([0.0005, 0.9995], count) / count)
    ratio = found.empirical_sigma / found.predicted
    assert ((ratio > lower) & (ratio < upper)).all(), SimulationValues.of(found)
    assert found.mean_formal_sigma == pytest.approx(found.predicted, rel=0.02)


@pytest.mark.long
@pytest.mark.timeout(7200)
@pytest.mark.parametrize("flatness_known", [True, False])
def test_a_thousand_surveys_scatter_as_predicted(flatness_known: bool) -> None:
    found = compared(PLAN, 1000, flatness_known=flatness_known)
    print(SimulationValues.of(found))
    assert found.empirical_sigma == pytest.approx(found.predicted, rel=0.08)
