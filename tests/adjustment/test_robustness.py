"""Tests of the robustness to outliers and blunders of whole sightings."""

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
from tests.support.long_runs import LONG, others_long

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))


def survey(seed: int, spacing: float = 0.06) -> Observations:
    generator = np.random.default_rng([7, seed])
    exact = error_free_survey(TRUTH, THESIS_BOARDS, six_courses(), spacing, generator)
    return add_errors(exact, HYDROGRAPHIC_INS, generator)


def with_outliers(clean: Observations, seed: int) -> tuple[Observations, np.ndarray]:
    """Displace 5 % of the points by 0.1 to 1 m along the beam."""
    generator = np.random.default_rng([8, seed])
    is_outlier = generator.random(len(clean)) < 0.05
    points = clean.points_lidar.copy()
    beams = points[is_outlier] / np.linalg.norm(points[is_outlier], axis=1, keepdims=True)
    off = generator.uniform(0.1, 1.0, is_outlier.sum()) * generator.choice(
        [-1, 1], is_outlier.sum()
    )
    points[is_outlier] += off[:, None] * beams
    return replace(clean, points_lidar=points), is_outlier


def shifted(clean: Observations, sighting: int, metres: float) -> Observations:
    """Displace one sighting along the normal of its target."""
    normal = fit_shapes(clean, TRUTH)[clean.target_of_sighting[sighting], :3]
    position = clean.position.copy()
    position[clean.sighting == sighting] += metres * normal
    return replace(clean, position=position)


@pytest.mark.parametrize("seed", others_long(range(3)))
def test_outliers_change_no_angle_by_one_sigma(seed) -> None:
    model = StochasticModel(loss="tukey")
    clean = survey(seed)
    dirty, is_outlier = with_outliers(clean, seed)
    before, after = adjust(clean, PRIOR, model), adjust(dirty, PRIOR, model)
    assert (np.abs(after.boresight - before.boresight) < before.sigma).all()
    found = sum(item.outliers for item in after.reliability)
    # At the level of the test, one point in a thousand is rejected by chance.
    assert is_outlier.sum() <= found < is_outlier.sum() + 0.006 * len(clean)


def test_robust_losses_reduce_errors_and_sigmas_reflect_outliers() -> None:
    """The same points with equal weights, with a bounded loss and with a redescending loss."""
    dirty, _ = with_outliers(survey(0), 0)
    errors, sigmas = [], []
    for loss in LOSS_NAMES:
        result = adjust(dirty, PRIOR, StochasticModel(loss=loss), diagnostics=False)
        errors.append(np.abs(result.boresight - TRUTH.boresight)[1])
        sigmas.append(result.sigma[1])
    assert errors[0] > 3 * errors[2]
    assert sigmas[0] > 2 * sigmas[1] > 4 * sigmas[2]
    assert (np.array(errors) < 3 * np.array(sigmas)).all()


def effect_in_sigmas(
    clean: Observations, dirty: Observations
) -> tuple[np.ndarray, AdjustmentResult]:
    """Return the effect of a blunder on the angles, in sigmas, besides the loss of its data.

    The clean survey is adjusted with the sightings free that were rejected in the other: an unknown
    shift replaces their contribution.
    """
    model = StochasticModel(loss="tukey")
    found = adjust(dirty, PRIOR, model)
    rejected = [dirty.sightings.index(s) for s in found.rejected_sightings]
    with pytest.MonkeyPatch.context() as patch:
        todo = [Blunder("shift", (s,)) for s in rejected]
        patch.setattr(sighting_rejection, "worst_blunder", lambda *_: todo.pop() if todo else None)
        patch.setattr(sighting_rejection, "find_restorable_blunder", lambda *_: None)
        patch.setattr(
            sighting_rejection, "find_displaced_sightings", lambda *_: np.zeros(0, dtype=np.int64)
        )
        same = adjust(clean, PRIOR, model, diagnostics=False)
    return np.abs(found.boresight - same.boresight) / same.sigma, found


@pytest.mark.parametrize("sighting", others_long([0, 3, 7, 10], 2))
def test_a_shifted_sighting_is_rejected_without_effect_on_the_angles(sighting) -> None:
    clean = survey(20 + sighting)
    done, after = effect_in_sigmas(clean, shifted(clean, sighting, 0.05))
    assert clean.sightings[sighting] in after.rejected_sightings
    assert {s.line for s in after.rejected_sightings} == {clean.sightings[sighting].line}
    assert (done < 0.1).all()
    found = after.reliability[sighting]
    assert abs(found.shift) == pytest.approx(0.05, abs=3 * abs(found.shift / found.w))


@pytest.mark.long  # four of twelve above
def test_any_shifted_sighting_is_rejected_and_no_other_line() -> None:
    """Each of twelve is shifted by 5 cm on two surveys; its POS error may hide a shift."""
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


@pytest.mark.parametrize("seed", others_long(range(6), 2))
def test_another_surface_metres_away_has_no_effect_on_the_angles(seed) -> None:
    """The sighting is rejected, or its target is very noisy and has little weight."""
    clean = survey(7000 + seed, 0.1)
    after = adjust(shifted(clean, 10, 3.5), PRIOR, StochasticModel(loss="tukey"))
    assert after.rejected_sightings == (clean.sightings[10],) or after.targets[1].noise > 100
    assert (np.abs(after.boresight - TRUTH.boresight) < 4 * after.sigma).all()


@pytest.mark.parametrize("loss", ["huber", "tukey"])
def test_steps_with_updated_weights_converge_to_the_irls_result(loss) -> None:
    dirty, _ = with_outliers(survey(0), 0)
    model = StochasticModel(loss=loss)
    quick = adjust(dirty, PRIOR, model, diagnostics=False)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(iteration, "MAX_GAUSS_NEWTON_STEPS", -1)
        patch.setattr(iteration, "ANGLE_TOLERANCE", 1e-13)
        plain = adjust(dirty, PRIOR, model, diagnostics=False)
    assert plain.iterations > quick.iterations
    assert np.degrees(np.abs(quick.boresight - plain.boresight)).max() < 1e-9


@LONG
def test_outliers_of_metres_with_a_loss_that_keeps_them_do_not_break_the_adjustment() -> None:
    """A trial without the cause of the residuals diverges; it is then not considered."""
    data, chance = survey(5, 0.1), np.random.default_rng(5)
    along = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
    off = (chance.random(len(data)) < 0.05) * chance.normal(0, 5, len(data))
    dirty = replace(data, points_lidar=data.points_lidar + off[:, None] * along)
    found = adjust(dirty, PRIOR, StochasticModel(loss="huber"))
    assert (np.abs(found.boresight - TRUTH.boresight) < 4 * found.sigma).all()


@pytest.mark.parametrize(
    ("seed", "sighting", "metres"), others_long([(1, 10, 3.5), (2, 4, -5.0), (3, 2, -5.0)], 2)
)
def test_a_surface_metres_off_is_rejected_without_effect(seed, sighting, metres) -> None:
    """The board is 1 m wide: a plane through all its points would stand across it."""
    clean = survey(7000 + seed, 0.1)
    done, after = effect_in_sigmas(clean, shifted(clean, sighting, metres))
    assert after.rejected_sightings == (clean.sightings[sighting],)
    assert all(target.noise < 1.5 for target in after.targets)
    assert (done < 1).all()


def test_a_poor_start_rejects_no_sighting() -> None:
    """Angles wrong by 8 degrees displace every sighting by a different number of metres."""
    clean = survey(5, 0.1)
    model = StochasticModel(loss="tukey")
    far = PRIOR.with_boresight(TRUTH.boresight + np.radians([8.0, -8.0, 8.0]))
    near, found = adjust(clean, PRIOR, model), adjust(clean, far, model)
    assert not found.rejected_sightings
    assert np.degrees(np.abs(found.boresight - near.boresight)).max() < 1e-3


def jumped(clean: Observations, line: str, metres: list[float]) -> Observations:
    """Displace the positions of one whole line (north, west, up)."""
    own = np.array([s.line == line for s in clean.sightings])[clean.sighting]
    position = clean.position.copy()
    position[own] += metres
    return replace(clean, position=position)


@pytest.mark.parametrize("line", others_long(["L2", "L4", "L5"]))
def test_a_line_with_a_position_jump_is_rejected_without_effect(line) -> None:
    clean = survey(40 + int(line[1]), 0.1)
    done, after = effect_in_sigmas(clean, jumped(clean, line, [0.0, 0.1, 0.05]))
    assert {s.line for s in after.rejected_sightings} == {line}
    assert (done < 1).all()


def test_interchanged_boards_on_a_line_are_rejected_without_effect() -> None:
    clean = survey(803, 0.1)
    first, second = (k for k, s in enumerate(clean.sightings) if s.line == "L4")
    sighting = clean.sighting.copy()
    sighting[clean.sighting == first], sighting[clean.sighting == second] = second, first
    done, after = effect_in_sigmas(clean, replace(clean, sighting=sighting))
    assert set(after.rejected_sightings) == {clean.sightings[first], clean.sightings[second]}
    assert after.rejected_lines == ("L4",)
    assert (done < 1).all()


def test_a_sighting_rejected_by_mistake_is_restored() -> None:
    """With two blunders, the first rejected sighting may be a third one that agrees."""
    clean = survey(3, 0.1)
    dirty = shifted(shifted(clean, 2, 0.05), 5, 0.05)
    todo = [Blunder("shift", (3,))]
    with pytest.MonkeyPatch.context() as patch:
        own = sighting_rejection.worst_blunder
        patch.setattr(
            sighting_rejection,
            "worst_blunder",
            lambda *arguments: todo.pop() if todo else own(*arguments),
        )
        found = adjust(dirty, PRIOR, StochasticModel(loss="tukey"))
    assert set(found.rejected_sightings) == {clean.sightings[2], clean.sightings[5]}


@pytest.mark.parametrize(("count", "most"), others_long([(6, 0), (20, 1)]))
def test_clean_surveys_have_no_rejected_sightings(count: int, most: int) -> None:
    """At a level of 1 %, more rejections among so many surveys are unlikely."""
    model = StochasticModel(loss="tukey")
    named = [adjust(survey(100 + k, 0.12), PRIOR, model).rejected_sightings for k in range(count)]
    assert sum(map(bool, named)) <= most, named


@pytest.mark.parametrize("name", LOSS_NAMES[1:])
def test_weights_decrease_from_one(name) -> None:
    loss = Loss(name)
    sizes = np.linspace(0, 10, 200)
    weights = np.array([loss_weight(loss.code, loss.tuning, z) for z in sizes])
    assert weights[0] == 1
    assert (np.diff(weights) <= 0).all()
    assert weights[-1] == (0 if name == "tukey" else pytest.approx(loss.tuning / 10))
    assert 0.5 < loss.expected_square_share < 1


def test_scale_is_that_of_the_majority_of_residuals() -> None:
    generator = np.random.default_rng(1)
    residuals = 3 * generator.standard_normal(10_000)
    residuals[:2000] += 100
    assert robust_scale(residuals) == pytest.approx(3, rel=0.4)
    assert robust_scale(0.1 * residuals[2000:]) == 1
