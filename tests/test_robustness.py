"""Blunders: stray points, and a sighting that is off as a whole."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.robust_loss import LOSS_NAMES, Loss, loss_weight, robust_scale
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import fit_shapes
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solve import iteration, sighting_rejection
from lispac.adjustment.solve.blunders import Blunder
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))


def survey(seed: int, spacing: float = 0.06) -> Observations:
    generator = np.random.default_rng([7, seed])
    exact = error_free_survey(TRUTH, THESIS_BOARDS, six_courses(), spacing, generator)
    return add_errors(exact, HYDROGRAPHIC_INS, generator)


def with_outliers(clean: Observations, seed: int) -> tuple[Observations, np.ndarray]:
    """5 % of the points 0.1 to 1 m off along the beam."""
    generator = np.random.default_rng([8, seed])
    stray = generator.random(len(clean)) < 0.05
    points = clean.points_lidar.copy()
    beams = points[stray] / np.linalg.norm(points[stray], axis=1, keepdims=True)
    off = generator.uniform(0.1, 1.0, stray.sum()) * generator.choice([-1, 1], stray.sum())
    points[stray] += off[:, None] * beams
    return replace(clean, points_lidar=points), stray


def shifted(clean: Observations, sighting: int, metres: float) -> Observations:
    """One sighting displaced along its target's normal."""
    normal = fit_shapes(clean, TRUTH)[clean.target_of_sighting[sighting], :3]
    position = clean.position.copy()
    position[clean.sighting == sighting] += metres * normal
    return replace(clean, position=position)


@pytest.mark.parametrize("seed", range(3))
def test_outliers_move_no_angle_by_a_sigma(seed) -> None:
    model = StochasticModel(loss="tukey")
    clean = survey(seed)
    dirty, stray = with_outliers(clean, seed)
    before, after = adjust(clean, PRIOR, model), adjust(dirty, PRIOR, model)
    assert (np.abs(after.boresight - before.boresight) < before.sigma).all()
    found = sum(item.outliers for item in after.reliability)
    # Those of the noise itself: one in a thousand at the test's level
    assert stray.sum() <= found < stray.sum() + 0.006 * len(clean)


def test_the_losses_are_needed_and_the_sigmas_include_outliers() -> None:
    """The same points with all weighted alike, with a bounded loss, and a redescending one."""
    dirty, _ = with_outliers(survey(0), 0)
    errors, sigmas = [], []
    for loss in LOSS_NAMES:
        result = adjust(dirty, PRIOR, StochasticModel(loss=loss), diagnostics=False)
        errors.append(np.abs(result.boresight - TRUTH.boresight)[1])
        sigmas.append(result.sigma[1])
    assert errors[0] > 3 * errors[2]
    assert sigmas[0] > 2 * sigmas[1] > 4 * sigmas[2]
    assert (np.array(errors) < 3 * np.array(sigmas)).all()


def harm(clean: Observations, dirty: Observations) -> tuple[np.ndarray, AdjustmentResult]:
    """What a blunder does to the angles, in their sigmas, besides that its data are lost.

    Beside the clean survey that is not held to its target where the other was found not to be:
    a shift of unknown size takes the place of what the sighting said of it.
    """
    model = StochasticModel(loss="tukey")
    found = adjust(dirty, PRIOR, model)
    gone = [dirty.sightings.index(s) for s in found.rejected_sightings]
    with pytest.MonkeyPatch.context() as patch:
        todo = [Blunder("shift", (s,)) for s in gone]
        patch.setattr(sighting_rejection, "worst_blunder", lambda *_: todo.pop() if todo else None)
        patch.setattr(sighting_rejection, "find_restorable_blunder", lambda *_: None)
        patch.setattr(
            sighting_rejection, "find_displaced_sightings", lambda *_: np.zeros(0, dtype=np.int64)
        )
        same = adjust(clean, PRIOR, model, diagnostics=False)
    return np.abs(found.boresight - same.boresight) / same.sigma, found


@pytest.mark.parametrize("sighting", [0, 3, 7, 10])
def test_a_shifted_sighting_is_named_and_does_no_harm(sighting) -> None:
    clean = survey(20 + sighting)
    done, after = harm(clean, shifted(clean, sighting, 0.05))
    assert clean.sightings[sighting] in after.rejected_sightings
    assert {s.line for s in after.rejected_sightings} == {clean.sightings[sighting].line}
    assert (done < 0.1).all()
    found = after.reliability[sighting]
    assert abs(found.shift) == pytest.approx(0.05, abs=3 * abs(found.shift / found.w))


@pytest.mark.long  # four of twelve above
def test_whichever_sighting_is_shifted_it_is_named_and_no_other_line() -> None:
    """Each of twelve by 5 cm, twice; where its own POS error hides the shift it does little."""
    model = StochasticModel(loss="tukey")
    named = 0
    for seed in (3, 4):
        clean = survey(seed, 0.1)
        before = adjust(clean, PRIOR, model, diagnostics=False)
        for s, sighting in enumerate(clean.sightings):
            after = adjust(shifted(clean, s, 0.05), PRIOR, model)
            assert {found.line for found in after.rejected_sightings} <= {sighting.line}
            named += sighting in after.rejected_sightings
            assert (np.abs(after.boresight - before.boresight) < 2 * after.sigma).all()
    assert named >= 22


@pytest.mark.parametrize("seed", range(6))
def test_another_surface_metres_away_does_no_harm(seed) -> None:
    """It is named, or its target is seen to scatter and counts for little: both are said."""
    clean = survey(7000 + seed, 0.1)
    after = adjust(shifted(clean, 10, 3.5), PRIOR, StochasticModel(loss="tukey"))
    assert after.rejected_sightings == (clean.sightings[10],) or after.targets[1].noise > 100
    assert (np.abs(after.boresight - TRUTH.boresight) < 4 * after.sigma).all()


@pytest.mark.parametrize("loss", ["huber", "tukey"])
def test_steps_that_foresee_the_weights_lead_where_plain_ones_do(loss) -> None:
    dirty, _ = with_outliers(survey(0), 0)
    model = StochasticModel(loss=loss)
    quick = adjust(dirty, PRIOR, model, diagnostics=False)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(iteration, "MAX_GAUSS_NEWTON_STEPS", -1)
        patch.setattr(iteration, "ANGLE_TOLERANCE", 1e-13)
        plain = adjust(dirty, PRIOR, model, diagnostics=False)
    assert plain.iterations > quick.iterations
    assert np.degrees(np.abs(quick.boresight - plain.boresight)).max() < 1e-9


@pytest.mark.parametrize(("seed", "sighting", "metres"), [(1, 10, 3.5), (2, 4, -5.0), (3, 2, -5.0)])
def test_a_surface_metres_off_is_named_and_does_no_harm(seed, sighting, metres) -> None:
    """A board of a metre: the plane through its points on all lines would stand across it."""
    clean = survey(7000 + seed, 0.1)
    done, after = harm(clean, shifted(clean, sighting, metres))
    assert after.rejected_sightings == (clean.sightings[sighting],)
    assert all(target.noise < 1.5 for target in after.targets)
    assert (done < 1).all()


def test_a_start_far_off_lets_go_of_nothing() -> None:
    """Angles wrong by 8 degrees set every sighting off by metres, by different ones."""
    clean = survey(5, 0.1)
    model = StochasticModel(loss="tukey")
    far = PRIOR.with_boresight(TRUTH.boresight + np.radians([8.0, -8.0, 8.0]))
    near, found = adjust(clean, PRIOR, model), adjust(clean, far, model)
    assert not found.rejected_sightings
    assert np.degrees(np.abs(found.boresight - near.boresight)).max() < 1e-3


def jumped(clean: Observations, line: str, metres: list[float]) -> Observations:
    """The position off on one whole line, north, west, up."""
    own = np.array([s.line == line for s in clean.sightings])[clean.sighting]
    position = clean.position.copy()
    position[own] += metres
    return replace(clean, position=position)


@pytest.mark.parametrize("line", ["L2", "L4", "L5"])
def test_a_jump_of_the_position_on_a_line_is_named_and_does_no_harm(line) -> None:
    clean = survey(40 + int(line[1]), 0.1)
    done, after = harm(clean, jumped(clean, line, [0.0, 0.1, 0.05]))
    assert {s.line for s in after.rejected_sightings} == {line}
    assert (done < 1).all()


def test_boards_that_are_interchanged_on_a_line_are_named_and_do_no_harm() -> None:
    clean = survey(803, 0.1)
    first, second = (k for k, s in enumerate(clean.sightings) if s.line == "L4")
    sighting = clean.sighting.copy()
    sighting[clean.sighting == first], sighting[clean.sighting == second] = second, first
    done, after = harm(clean, replace(clean, sighting=sighting))
    assert set(after.rejected_sightings) == {clean.sightings[first], clean.sightings[second]}
    assert after.rejected_lines == ("L4",)
    assert (done < 1).all()


def test_what_was_rejected_by_mistake_is_restored() -> None:
    """With two sightings off, the first to be named may be a third one that agrees."""
    clean = survey(3, 0.1)
    dirty = shifted(shifted(clean, 2, 0.05), 5, 0.05)
    todo = [Blunder("shift", (3,))]
    with pytest.MonkeyPatch.context() as patch:
        own = sighting_rejection.worst_blunder
        patch.setattr(
            sighting_rejection, "worst_blunder", lambda *given: todo.pop() if todo else own(*given)
        )
        found = adjust(dirty, PRIOR, StochasticModel(loss="tukey"))
    assert set(found.rejected_sightings) == {clean.sightings[2], clean.sightings[5]}


def test_clean_surveys_have_no_suspects() -> None:
    """At one in a hundred by chance, none of twenty is likely."""
    model = StochasticModel(loss="tukey")
    named = [adjust(survey(100 + k, 0.12), PRIOR, model).rejected_sightings for k in range(20)]
    assert sum(map(bool, named)) <= 1, named


@pytest.mark.parametrize("name", LOSS_NAMES[1:])
def test_weights_fall_from_one_and_never_rise(name) -> None:
    loss = Loss(name)
    sizes = np.linspace(0, 10, 200)
    weights = np.array([loss_weight(loss.code, loss.tuning, z) for z in sizes])
    assert weights[0] == 1
    assert (np.diff(weights) <= 0).all()
    assert weights[-1] == (0 if name == "tukey" else pytest.approx(loss.tuning / 10))
    assert 0.5 < loss.expected_square_share < 1


def test_the_scale_is_that_of_the_majority() -> None:
    generator = np.random.default_rng(1)
    residuals = 3 * generator.standard_normal(10_000)
    residuals[:2000] += 100
    assert robust_scale(residuals) == pytest.approx(3, rel=0.4)
    assert robust_scale(0.1 * residuals[2000:]) == 1
