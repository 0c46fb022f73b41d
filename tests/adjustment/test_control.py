"""Tests of surveyed control as observations of the adjustment."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.diagnostics.control_tests import contradicting_control
from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.solved_equations import SolvedEquations
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.control import Control, plane_points
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.stochastic_model import POS_ERROR_MODELS, StochasticModel
from lispac.adjustment.model.target_shapes import (
    apply_shape_changes,
    fit_shapes,
    relative_to_origins,
    target_centroids,
)
from lispac.adjustment.solve import solver
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem
from lispac.adjustment.solve.variance_components import estimate_variance_components
from lispac.errors import AdjustmentError, RankDeficient
from lispac.geometry.planes import fit_plane, plane_axes
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Ball,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from tests.studies.control_coverage import (
    BOARDS,
    MODEL,
    PRIOR,
    SIGMA,
    SINGLE_LINE_BOARDS,
    TRUTH,
    control_on,
    study,
)
from tests.support.long_runs import others_long
from tests.support.surveys import TARGETS, disturbed, planar_survey

BALL = Ball("S1", (1.5, 12.0, 3.0), 0.1, radius_known=False)
LEVER_Z = (Parameter("lever_z"),)


def survey(targets=BOARDS, seed: int = 1, *, courses=None, exact: bool = False) -> Observations:
    """Observations of the targets without control."""
    generator = np.random.default_rng(seed)
    plain = error_free_survey(TRUTH, targets, courses or six_courses(), 0.06, generator)
    return plain if exact else add_errors(plain, HYDROGRAPHIC_INS, generator)


def centre_of(ball: Ball, sigma: float = SIGMA) -> Control:
    """Surveyed centre of a ball, without error."""
    return Control.of(
        ["C1"], [ball.name], np.array([ball.centre]), sigma**2 * np.eye(3)[None],
        is_centre=np.array([True]),
    )  # fmt: skip


def joined(*parts: Control, common_sigmas=None) -> Control:
    """Control of several parts as one source."""
    positions = np.concatenate([part.positions for part in parts])
    count = len(positions)
    return Control.of(
        [name for part in parts for name in part.names],
        [target for part in parts for target in part.targets],
        positions,
        np.array([np.diag(s**2) for part in parts for s in part.sigmas]).reshape(count, 3, 3),
        is_centre=np.concatenate([part.is_centre for part in parts]),
        sources=["file"] * count,
        common_sigmas=common_sigmas,
    )


def moved(control: Control, shifts: np.ndarray) -> Control:
    """Control displaced by ``shifts``, shape (n, 3) or (3,), metres."""
    return replace(control, positions=control.positions + shifts)


# -- closed loop and Jacobians ---------------------------------------------------------------


@pytest.mark.parametrize("model", POS_ERROR_MODELS)
@pytest.mark.parametrize("radius_known", [False, True])
def test_the_truth_is_recovered_without_noise(model: str, radius_known: bool) -> None:
    ball = replace(BALL, radius_known=radius_known)
    targets = (*THESIS_BOARDS, ball)
    on_ball = Control.of(
        ["B1"], [ball.name], np.array([ball.centre]) + [[0.0, -0.06, 0.08]],
        SIGMA**2 * np.eye(3)[None],
    )  # fmt: skip
    control = joined(control_on(THESIS_BOARDS), centre_of(ball), on_ball)
    exact = replace(survey(targets, exact=True), control=control)
    # A prior height of the lever arm that is wrong by 3 cm
    prior = replace(TRUTH, lever_arm=TRUTH.lever_arm + [0.0, 0.0, 0.03 * (model == "correlated")])
    prior = prior.with_boresight(TRUTH.boresight + np.radians(0.5))
    result = adjust(exact, prior, StochasticModel(model, surface=0.0005), parameters=LEVER_Z)
    np.testing.assert_allclose(result.boresight, TRUTH.boresight, rtol=0, atol=1e-9)
    np.testing.assert_allclose(result.mounting.lever_arm, TRUTH.lever_arm, rtol=0, atol=1e-9)
    np.testing.assert_allclose([each.residual for each in result.control], 0.0, atol=1e-9)
    assert len(result.control) == len(control)


@pytest.mark.parametrize("radius", [0.05, 0.2])
def test_position_errors_of_half_the_radius_of_spheres_have_linear_effects(radius: float) -> None:
    """The positions of an exact survey are displaced; the control is at the true centres.

    The adjustment removes the displacement except for a small share, because its expectation is
    zero. That share does not depend on its size, although it changes the normals of the spheres.
    """
    places = ((1.5, 12.0, 3.0), (-2.0, 13.0, 6.0), (0.5, 14.0, 9.0))
    balls = tuple(Ball(f"S{k}", place, radius) for k, place in enumerate(places, start=1))
    control = joined(*map(centre_of, balls))
    exact = error_free_survey(TRUTH, balls, six_courses(), radius / 10, np.random.default_rng(3))
    effects = []
    for share in (0.005, 0.5):
        shift = share * radius * np.array([0.6, 0.64, 0.48])
        displaced = replace(
            exact, position=exact.position + shift, control=control,
            sigma_position=np.full_like(exact.sigma_position, 0.1),
        )  # fmt: skip
        result = adjust(displaced, PRIOR, MODEL, diagnostics=False)
        effects.append((result.boresight - TRUTH.boresight) / share)
    np.testing.assert_allclose(effects[1], effects[0], rtol=0, atol=0.01 * np.abs(effects).max())
    assert np.abs(effects[1] * 0.5).max() < 0.2 * result.sigma[2]


def test_jacobians_agree_with_differences() -> None:
    ball = replace(BALL, name="S2")
    control = joined(
        control_on(THESIS_BOARDS),
        centre_of(ball),
        Control.of(["B1"], ["S2"], [[1.5, 11.93, 3.09]], SIGMA**2 * np.eye(3)[None]),
        common_sigmas={"file": 0.01},
    )
    data = replace(survey((*THESIS_BOARDS, ball)), control=control)
    data = relative_to_origins(data, target_centroids(data, TRUTH))
    problem = AdjustmentProblem.of(data, TRUTH, MODEL)
    state = problem.start(TRUTH, fit_shapes(data, TRUTH))
    linearised = problem.linearised(state)
    equations = linearised.control
    assert equations is not None

    def misclosures(shapes: np.ndarray, positions: np.ndarray) -> np.ndarray:
        other = problem.with_control(replace(control, positions=positions))
        # The same unknowns, evaluated at other shapes and positions
        there = other.control_equations(
            replace(state, shapes=shapes), other.sums_by_sighting(linearised.sums), linearised.bases
        )
        assert there is not None
        return there.misclosure

    step = 1e-6
    for k, place in enumerate(linearised.normal.layout.shapes):
        for j, unknown in enumerate(range(place.start, place.stop)):
            change = np.zeros_like(state.shapes)
            change[k] = step * linearised.bases.shapes[k][:, j]
            there, back = (
                misclosures(
                    apply_shape_changes(state.shapes, sign * change, data.is_sphere),
                    control.positions,
                )
                for sign in (1, -1)
            )
            np.testing.assert_allclose(
                equations.by_unknowns[:, unknown], (there - back) / (2 * step), atol=1e-8
            )
    assert not equations.by_unknowns[:, : len(problem.active)].any()
    for i in range(len(control)):
        for axis in range(3):
            change = np.zeros_like(control.positions)
            change[i, axis] = step
            there, back = (
                misclosures(state.shapes, control.positions + s * change) for s in (1, -1)
            )
            own = equations.by_position[:, axis] * (equations.owner == i)
            np.testing.assert_allclose(own, (there - back) / (2 * step), atol=1e-7)


def test_three_points_represent_a_fitted_plane() -> None:
    """The normal matrix of the plane is that of all its points."""
    generator = np.random.default_rng(3)
    board = THESIS_BOARDS[1]
    points = board.points_on_board(*generator.uniform([[-0.6], [-0.2]], [[0.6], [0.3]], (2, 50)))
    plane, centre = fit_plane(points), points.mean(axis=0)
    axes = plane_axes(plane.normal)
    moments, turn = np.linalg.eigh(np.cov(((points - centre) @ axes.T).T, bias=True))
    three = plane_points(centre, turn.T @ axes, moments)

    def information(some: np.ndarray, sigma: float) -> np.ndarray:
        design = np.column_stack([(some - centre) @ axes.T, np.ones(len(some))])
        return design.T @ design / sigma**2

    expected = information(points, 0.002)
    np.testing.assert_allclose(
        information(three, 0.002 * np.sqrt(3 / 50)), expected, atol=1e-9 * expected.max()
    )
    np.testing.assert_allclose(plane.distances(three), 0.0, atol=1e-12)


# -- statistics ------------------------------------------------------------------------------


def test_results_without_control_are_unchanged() -> None:
    """An empty control, and control of other targets, change no digit."""
    data = survey()
    plain = adjust(data, PRIOR, MODEL)
    other = control_on(BOARDS)
    other = replace(other, targets=("T9",) * len(other))
    for control in (other, other.where(np.zeros(len(other), dtype=bool))):
        result = adjust(replace(data, control=control), PRIOR, MODEL)
        assert (result.boresight == plain.boresight).all()
        assert (result.covariance == plain.covariance).all()
        assert result.chi_square == plain.chi_square
        assert result.degrees_of_freedom == plain.degrees_of_freedom
        assert result.control == () == result.control_translations


def test_freedom_and_statistic_contain_the_control() -> None:
    data, control = survey(), control_on(BOARDS)
    plain, result = (adjust(replace(data, control=some), PRIOR, MODEL) for some in (None, control))
    assert result.degrees_of_freedom == plain.degrees_of_freedom + len(control)
    assert result.sigma[0] < plain.sigma[0]
    solved = SolvedEquations.of(result, replace(data, control=control), PRIOR)
    assert solved is not None
    equations = solved.linearised.control
    assert equations is not None
    # Redundancy numbers of the control, and their sum from the share of the unknowns
    explained = equations.by_unknowns @ solved.linearised.normal.covariance
    explained = explained @ equations.by_unknowns.T @ equations.precision
    expected = 1 - np.diag(explained)
    found = np.array([each.redundancy for each in result.control])
    np.testing.assert_allclose(found, expected, atol=1e-4)
    assert ((found > 0) & (found < 1)).all()


def test_test_values_agree_with_an_adjustment_without_the_point() -> None:
    """The shift is the distance from the surface that all other observations give."""
    board = BOARDS[0]
    control = control_on(BOARDS)
    control = moved(control, 0.004 * np.eye(len(control))[0][:, None] * board.facing)
    data = survey()
    model = StochasticModel(surface=0.002)
    whole = adjust(
        replace(data, control=control), PRIOR, model, noise=dict.fromkeys(data.targets, 1.0)
    )
    first = whole.control[0]
    others = control.where(np.arange(len(control)) > 0)
    solved = SolvedEquations.of(
        adjust(replace(data, control=others), PRIOR, model, noise=whole.noise_factors),
        replace(data, control=others), PRIOR,
    )  # fmt: skip
    assert solved is not None
    assert first.shift is not None
    assert first.shift_sigma is not None
    k = data.targets.index(board.name)
    shape, tangent = solved.linearised.state.shapes[k], solved.linearised.bases.shapes[k]
    point = control.positions[0] - solved.origins[k]
    row = np.array([*point, 1.0]) @ tangent
    place = solved.linearised.normal.layout.shapes[k]
    variance = row @ solved.linearised.normal.covariance[place, place] @ row + SIGMA**2
    side = np.sign(shape[:3] @ board.facing)
    assert first.shift == pytest.approx(side * (shape[:3] @ point + shape[3]), abs=2e-6)
    assert first.shift_sigma == pytest.approx(np.sqrt(variance), rel=1e-3)
    assert first.w == pytest.approx(first.shift / first.shift_sigma)
    assert first.residual == pytest.approx(first.redundancy * first.shift, rel=1e-2)


def test_the_sign_is_positive_on_the_side_of_the_vessel() -> None:
    control = control_on(BOARDS)
    facing = {board.name: board.facing for board in BOARDS}
    near = 0.01 * np.array([facing[target] for target in control.targets])
    near[1::2] = 0.0
    result = adjust(replace(survey(exact=True), control=moved(control, near)), PRIOR, MODEL)
    assert all(each.residual > 0 for each in result.control[::2])


def test_a_common_error_has_a_full_covariance() -> None:
    """A common translation of 1 m makes the control as good as relative control only."""
    data, control = survey(), joined(control_on(BOARDS))
    free = joined(control, common_sigmas={"file": 100.0})
    shifted = moved(free, np.array([3.0, -2.0, 5.0]))
    first, second = (adjust(replace(data, control=some), PRIOR, MODEL) for some in (free, shifted))
    # The translation is estimated with the control, so that it changes nothing else.
    np.testing.assert_allclose(second.boresight, first.boresight, atol=2e-3 * first.sigma.min())
    np.testing.assert_allclose(second.sigma, first.sigma, rtol=1e-3)
    own = adjust(replace(data, control=control), PRIOR, MODEL)
    assert (own.sigma <= first.sigma * (1 + 1e-9)).all()
    assert contradicting_control(second.control, second.control_translations) == ((), ())


@pytest.mark.parametrize("model", POS_ERROR_MODELS)
def test_results_do_not_depend_on_order_or_origin(model: str) -> None:
    data, control = survey(), joined(control_on(BOARDS), common_sigmas={"file": 0.004})
    shift = np.array([812.0, -455.0, 31.0])
    order = np.random.default_rng(2).permutation(len(control))
    coordinates = (3 * order[:, None] + np.arange(3)).reshape(-1)
    mixed = Control(
        tuple(control.names[k] for k in order), tuple(control.targets[k] for k in order),
        control.positions[order] + shift, control.is_centre[order],
        control.covariance[np.ix_(coordinates, coordinates)],
        tuple(control.sources[k] for k in order),
    )  # fmt: skip
    stochastic = StochasticModel(model)
    first = adjust(replace(data, control=control), PRIOR, stochastic)
    there = replace(data, position=data.position + shift, control=mixed)
    other = adjust(there, PRIOR, stochastic)
    np.testing.assert_allclose(other.boresight, first.boresight, rtol=0, atol=1e-8)
    np.testing.assert_allclose(other.sigma, first.sigma, rtol=1e-6)
    by_name = {each.name: each for each in other.control}
    for each in first.control:
        assert by_name[each.name].residual == pytest.approx(each.residual, abs=1e-7)
        assert by_name[each.name].w == pytest.approx(each.w, abs=1e-4)


# -- what becomes determined -----------------------------------------------------------------


def test_control_determines_the_height_of_the_lever_arm() -> None:
    """Without roll and pitch of the vessel, the lines alone do not show the height."""
    prior = replace(TRUTH, lever_arm=TRUTH.lever_arm + [0.0, 0.0, 0.25])
    data = disturbed(planar_survey(TRUTH, scatter=False), correlated=True, seed=4)
    alone = adjust(data, prior, StochasticModel(), parameters=LEVER_Z).parameters[0]
    assert alone.value is None
    assert alone.reason is not None
    assert alone.reason.code == "parameter.raises_all_lines"
    corners = 0.5 * np.array([[-1, -1], [-1, 1], [1, -1], [1, 1]])
    generator, rows, names = np.random.default_rng(5), [], []
    for name, (centre, normal) in TARGETS.items():
        axes = np.array([[1.0, 0.0, 0.0], np.cross(normal, [1.0, 0.0, 0.0])])
        rows.append(centre + corners @ axes + SIGMA * generator.normal(size=(4, 3)))
        names += [name] * 4
    control = Control.of(
        [f"C{k}" for k in range(8)], names, np.concatenate(rows),
        np.tile(SIGMA**2 * np.eye(3), (8, 1, 1)),
    )  # fmt: skip
    result = adjust(replace(data, control=control), prior, StochasticModel(), parameters=LEVER_Z)
    found = result.parameters[0]
    assert found.value is not None
    assert found.sigma is not None
    assert found.sigma < 0.025
    assert abs(found.value - TRUTH.lever_arm[2]) < 3.5 * found.sigma
    assert contradicting_control(result.control, result.control_translations) == ((), ())


def test_control_allows_planes_of_one_orientation() -> None:
    """A bent or moved wall would show in its control."""
    walls = (THESIS_BOARDS[0], replace(THESIS_BOARDS[0], name="T3", centre=(6.0, 15.0, 4.0)))
    data = survey(walls)
    with pytest.raises(RankDeficient) as failure:
        adjust(data, TRUTH, MODEL)
    assert failure.value.reason.code == "adjustment.parallel_planes"
    result = adjust(replace(data, control=control_on(walls)), TRUTH, MODEL)
    assert (np.abs(result.boresight - TRUTH.boresight) < 4 * result.sigma).all()
    few = control_on(walls).where(np.array([True, True, *[False] * 6]))
    with pytest.raises(RankDeficient):  # two points do not fix a plane
        adjust(replace(data, control=few), TRUTH, MODEL)


def test_control_determines_the_angles_on_one_heading() -> None:
    boards = SINGLE_LINE_BOARDS
    data = survey(boards, courses=six_courses()[:1])
    with pytest.raises(RankDeficient) as failure:
        adjust(data, TRUTH, MODEL)
    assert failure.value.reason.code == "adjustment.one_line"
    control = control_on(boards, generator=np.random.default_rng(5))
    result = adjust(replace(data, control=control), TRUTH, MODEL)
    assert (np.abs(result.boresight - TRUTH.boresight) < 4 * result.sigma).all()


def test_control_on_one_heading_is_refused_if_an_angle_is_not_determined() -> None:
    """One point or one board on one line determines no yaw and no pitch."""
    data = survey(SINGLE_LINE_BOARDS, courses=six_courses()[:1])
    control = control_on(SINGLE_LINE_BOARDS)
    for keep in (np.arange(len(control)) == 0, np.arange(len(control)) < 4):
        with pytest.raises(RankDeficient) as failure:
            adjust(replace(data, control=control.where(keep)), TRUTH, MODEL)
        assert failure.value.reason.code == "adjustment.undetermined_because"
        assert failure.value.reason.params["reason"].code == "adjustment.single_line"
        direction = failure.value.reason.params["direction"]
        assert direction.code != "adjustment.angle_roll"


def test_control_on_vertical_targets_does_not_determine_the_height_of_the_lever_arm() -> None:
    data = disturbed(planar_survey(TRUTH, scatter=False), correlated=True, seed=4)
    centre, normal = TARGETS["T1"]
    assert normal[2] == 0.0
    axes = np.array([[1.0, 0.0, 0.0], np.cross(normal, [1.0, 0.0, 0.0])])
    corners = 0.5 * np.array([[-1, -1], [-1, 1], [1, -1], [1, 1]])
    control = Control.of(
        [f"C{k}" for k in range(4)], ["T1"] * 4, centre + corners @ axes,
        np.tile(SIGMA**2 * np.eye(3), (4, 1, 1)),
    )  # fmt: skip
    result = adjust(replace(data, control=control), TRUTH, StochasticModel(), parameters=LEVER_Z)
    found = result.parameters[0]
    assert found.value is None
    assert found.reason is not None
    assert found.reason.code == "parameter.raises_all_lines"
    assert len(result.control) == 4


# -- contradictions --------------------------------------------------------------------------


@pytest.mark.parametrize("size", others_long([0.03, 0.5]))
def test_a_wrong_point_is_named(size: float) -> None:
    control = control_on(BOARDS, generator=np.random.default_rng(7))
    shifts = np.zeros((len(control), 3))
    shifts[2] = size * BOARDS[0].facing
    data = survey()
    result = adjust(replace(data, control=moved(control, shifts)), PRIOR, MODEL)
    points, translated = contradicting_control(result.control, result.control_translations)
    assert [each.name for each in points] == [control.names[2]]  # not its neighbours
    assert not translated
    assert all(abs(each.w) < 4 for each in result.control if not each.contradicts)
    assert points[0].shift == pytest.approx(size, abs=4 * points[0].shift_sigma)
    warnings = [
        each
        for each in result_warnings(result, None)
        if each.code == "adjustment.control_contradicts"
    ]
    assert warnings[0].params["name"] == control.names[2]
    # The wrong point does not increase the sigma of the form errors, nor reject sightings.
    plain = adjust(data, PRIOR, MODEL)
    assert result.surface == plain.surface
    assert result.rejected_sightings == plain.rejected_sightings == ()


@pytest.mark.parametrize("sizes", [(0.03, 0.04), (0.5, -0.02)])
def test_several_wrong_points_are_named(sizes: tuple[float, float]) -> None:
    """Also a small error beside a large one."""
    control = control_on(BOARDS, generator=np.random.default_rng(7))
    shifts = np.zeros((len(control), 3))
    for k, board, size in zip((2, 5), BOARDS, sizes, strict=False):
        shifts[k] = size * board.facing
    result = adjust(replace(survey(), control=moved(control, shifts)), PRIOR, MODEL)
    points, translated = contradicting_control(result.control, result.control_translations)
    assert {each.name for each in points} == {control.names[2], control.names[5]}
    assert not translated
    for point in points:
        size = sizes[control.names.index(point.name) == 5]
        assert point.shift == pytest.approx(size, abs=4 * point.shift_sigma)


def test_a_wrong_point_of_a_displaced_source_is_named_with_it() -> None:
    control = joined(control_on(BOARDS, generator=np.random.default_rng(7)))
    shifts = np.tile([0.0, 0.0, 0.3], (len(control), 1))
    shifts[3] += 0.1 * BOARDS[0].facing
    result = adjust(replace(survey(), control=moved(control, shifts)), PRIOR, MODEL)
    points, translated = contradicting_control(result.control, result.control_translations)
    assert [each.name for each in points] == [control.names[3]]
    (found,) = translated
    assert (np.abs(found.translation - shifts[0]) < 4 * found.sigma).all()


def test_a_wrong_height_reference_is_named_as_a_whole() -> None:
    control = joined(control_on(BOARDS, generator=np.random.default_rng(7)))
    shift = np.array([0.0, 0.0, 0.3])
    result = adjust(replace(survey(), control=moved(control, shift)), PRIOR, MODEL)
    points, translated = contradicting_control(result.control, result.control_translations)
    assert not points
    (found,) = translated
    assert np.isfinite(found.sigma).all()
    assert (np.abs(found.translation - shift) < 4 * found.sigma).all()
    codes = [each.code for each in result_warnings(result, None)]
    assert codes.count("adjustment.control_translated") == 1


def test_a_wrong_sphere_centre_is_named() -> None:
    targets = (*BOARDS, replace(BALL, radius_known=True))
    control = joined(control_on(BOARDS), centre_of(BALL))
    shifts = np.zeros((len(control), 3))
    shifts[-1] = [0.05, -0.03, 0.04]
    result = adjust(replace(survey(targets), control=moved(control, shifts)), PRIOR, MODEL)
    points, _ = contradicting_control(result.control, result.control_translations)
    assert [each.name for each in points] == ["C1"]
    assert points[0].shift == pytest.approx(np.linalg.norm(shifts[-1]), abs=0.02)


def test_correct_control_is_rarely_named() -> None:
    """At a level of 1 %, one false alarm in twelve surveys has a probability of 11 %."""
    found = []
    for seed in range(12):
        control = control_on(BOARDS, generator=np.random.default_rng(seed))
        result = adjust(replace(survey(seed=seed), control=control), TRUTH, MODEL)
        found.append(contradicting_control(result.control, result.control_translations))
    assert sum(bool(points or translated) for points, translated in found) <= 1


# -- parts of the data -----------------------------------------------------------------------


def test_a_target_takes_its_control_along() -> None:
    data = replace(survey(), control=control_on(BOARDS))
    result = adjust(data, PRIOR, MODEL)
    checks = {(part.kind, part.part): part for part in cross_checks(data, PRIOR, result).parts}
    name = BOARDS[1].name
    kept = np.array([target != name for target in data.control.targets])
    without = replace(data.without_targets([name]), control=data.control.where(kept))
    model = replace(result.model, surface=result.surface, offset=result.surfaces[2])
    again = adjust(
        without, PRIOR, model, noise=result.noise_factors, diagnostics=False,
        accept_single_orientation=True,
    )  # fmt: skip
    part = checks["target", name]
    assert part.boresight is not None
    np.testing.assert_allclose(part.boresight, again.boresight, atol=1e-9)


def test_all_points_are_used_with_control(monkeypatch) -> None:
    """The solution of a sample, and the last iterations with all points, contain the control."""
    data = replace(survey(), control=control_on(BOARDS))
    whole = adjust(data, PRIOR, StochasticModel(surface=0.001))
    monkeypatch.setattr(solver, "SAMPLE_SIZE", len(data) // 2)
    sampled = adjust(data, PRIOR, StochasticModel(surface=0.001))
    assert sampled.points == whole.points == len(data)
    assert len(sampled.control) == len(whole.control)
    assert (np.abs(sampled.boresight - whole.boresight) < 0.3 * whole.sigma).all()


def test_variance_components_do_not_scale_the_control() -> None:
    """The likelihood at factors of the solution is that of a problem with scaled sigmas."""
    from lispac.adjustment.solve.variance_components import _RestrictedLikelihood

    walls = survey(courses=six_courses()[:1])
    data = replace(walls, control=control_on(BOARDS, generator=np.random.default_rng(5)))
    result = adjust(data, TRUTH, StochasticModel(surface=0.001))
    solved = SolvedEquations.of(result, data, TRUTH)
    assert solved is not None
    linearised = solved.linearised
    factors = np.log([1.3, 0.8, 1.2])
    scaled = linearised.problem.with_scaled_sigmas(*np.exp(factors)).linearised(linearised.state)
    gains = [
        _RestrictedLikelihood(some)(np.array(given))
        for some, given in (
            (linearised, [*factors, 0.0]), (linearised, [0.0] * 4), (scaled, [0.0] * 4),
        )
    ]  # fmt: skip
    # The constant part of the likelihood: sigmas as given, once in the factors, once in the sums
    counts = np.array([len(data), *[3 * len(linearised.problem.groups.knots.time)] * 2])
    assert gains[0] - 2 * counts @ factors == pytest.approx(
        gains[2], abs=0.02 * abs(gains[0] - gains[1])
    )
    assert estimate_variance_components(linearised).components[0].lower < 1.0


# -- bad input -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"positions": np.full((12, 3), np.nan)}, "control.position_not_finite"),
        ({"covariance": np.zeros((36, 36))}, "control.sigma_not_positive"),
        ({"is_centre": np.ones(12, dtype=bool)}, "control.centre_of_plane"),
    ],
)
def test_bad_control_is_refused(change, code: str) -> None:
    control = replace(control_on(BOARDS), **change)
    with pytest.raises(AdjustmentError) as failure:
        adjust(replace(survey(), control=control), PRIOR, MODEL)
    assert failure.value.reason.code == code


# -- coverage --------------------------------------------------------------------------------


@pytest.mark.parametrize(("common", "single_line"), [(0.0, False), (0.01, False), (0.005, True)])
def test_most_intervals_contain_the_truth(common: float, single_line: bool) -> None:
    """Bounds of the binomial distribution at one in a thousand."""
    count = 12
    found = study(count, common=common, single_line=single_line, workers=1)
    fewest = scipy.stats.binom.ppf(0.0005, count, 0.95) / count
    assert (found.hits >= fewest).all(), found


@pytest.mark.long
@pytest.mark.timeout(7200)
@pytest.mark.parametrize(("common", "single_line"), [(0.0, False), (0.01, False), (0.005, True)])
def test_coverage_of_300_surveys_with_control(common: float, single_line: bool) -> None:
    found = study(300, common=common, single_line=single_line)
    print(found)
    assert (found.hits.mean() > 0.93) & (found.hits.mean() < 0.97), found
    # Of one value, 300 intervals have a standard error of 1.3 %.
    assert ((found.hits > 0.91) & (found.hits < 0.99)).all(), found
