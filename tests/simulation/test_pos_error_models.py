"""Tests of the statistics of the models of POS errors, from many draws."""

import numpy as np
import pytest

from lispac.simulation.pos_error_models import (
    CombinedModel,
    GnssOutage,
    PosErrors,
    StepErrors,
    WhiteNoise,
    combine_models,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from tests.support.long_runs import others_long

DRAW_COUNT, INTERVAL, EPOCH_COUNT = 3000, 0.5, 241
POSITION_SIGMA, ATTITUDE_SIGMA = (0.10, 0.20, 0.40), tuple(np.radians([0.01, 0.02, 0.08]))
OUTAGE_UNSMOOTHED = GnssOutage(20.0, 60.0, POSITION_SIGMA, ATTITUDE_SIGMA, smoothed=False)
OUTAGE_SMOOTHED = GnssOutage(20.0, 60.0, POSITION_SIGMA, ATTITUDE_SIGMA)
NOISE = WhiteNoise(POSITION_SIGMA, ATTITUDE_SIGMA)


def drawn(model: PosErrors, count: int = EPOCH_COUNT, draws: int = DRAW_COUNT) -> np.ndarray:
    """Return errors of shape (draws, count, 6), each divided by its given sigma."""
    streams = np.random.default_rng(11).spawn(draws)
    errors = np.stack([np.hstack(model.draw(count, INTERVAL, stream)) for stream in streams])
    return errors / np.array([*POSITION_SIGMA, *ATTITUDE_SIGMA])


@pytest.mark.parametrize(
    "model",
    others_long(
        [NOISE, OUTAGE_UNSMOOTHED, OUTAGE_SMOOTHED, CombinedModel((NOISE, OUTAGE_SMOOTHED))]
    ),
    ids=["white", "outage", "smoothed", "together"],
)
def test_errors_have_the_variance_of_the_model(model: PosErrors) -> None:
    """3000 draws give a standard deviation to 1.3 %; the limit for 241 x 6 values is 5 sigma."""
    expected = np.sqrt(model.variance(EPOCH_COUNT, INTERVAL)) / np.array(
        [*POSITION_SIGMA, *ATTITUDE_SIGMA]
    )
    found = np.sqrt((drawn(model) ** 2).mean(axis=0))
    assert expected.max() > 0.1
    np.testing.assert_allclose(found, expected, rtol=0.065, atol=1e-12)


def test_white_noise_has_no_memory() -> None:
    errors = drawn(NOISE, draws=400)
    assert abs((errors[:, 1:] * errors[:, :-1]).mean()) < 5 / np.sqrt(400 * 240 * 6)


def test_errors_grow_during_an_outage_and_end_with_it() -> None:
    time = np.arange(EPOCH_COUNT) * INTERVAL
    errors = drawn(OUTAGE_UNSMOOTHED)
    assert not errors[:, (time <= 20) | (time > 80)].any()
    at_end, half_way = (errors[:, time == t][:, 0].std(axis=0) for t in (80.0, 50.0))
    np.testing.assert_allclose(at_end, 1.0, rtol=0.065)
    np.testing.assert_allclose(half_way, [0.5**1.5] * 3 + [0.5**0.5] * 3, rtol=0.065)
    # Changes of position are correlated; attitude is a random walk.
    change = np.diff(errors[:, (time > 60) & (time <= 80)], axis=1)
    memory = (change[:, 1:] * change[:, :-1]).mean(axis=(0, 1)) / (change**2).mean(axis=(0, 1))
    assert memory[:3].min() > 0.9
    assert np.abs(memory[3:]).max() < 0.05


def test_smoothing_reduces_the_error_at_the_middle_of_an_outage() -> None:
    time = np.arange(EPOCH_COUNT) * INTERVAL
    sigma = drawn(OUTAGE_SMOOTHED).std(axis=0)
    assert time[np.argmax(sigma[:, :3].mean(axis=1))] == pytest.approx(50.0, abs=3.0)
    np.testing.assert_allclose(sigma[time == 50.0][0, :3], 1 / 8, rtol=0.065)
    np.testing.assert_allclose(sigma[time == 50.0][0, 3:], 1 / 2, rtol=0.065)
    assert sigma[time == 80.0].max() < 1e-9


def test_an_outage_between_two_samples_has_no_errors() -> None:
    assert not drawn(GnssOutage(20.1, 0.3, POSITION_SIGMA, ATTITUDE_SIGMA), draws=1).any()


def test_steps_have_the_given_frequency_and_remain() -> None:
    errors = drawn(StepErrors(POSITION_SIGMA, ATTITUDE_SIGMA, per_hour=120.0))
    changes = np.count_nonzero(np.diff(errors[..., 0], axis=1), axis=1)
    expected = 120 * 240 * INTERVAL / 3600  # 4 in 120 s
    assert changes.mean() == pytest.approx(expected, rel=0.05)
    assert changes.var() == pytest.approx(expected, rel=0.12), "as Poisson's law has it"
    np.testing.assert_allclose(errors[:, -1].std(axis=0), np.sqrt(1 - np.exp(-4)), rtol=0.065)
    assert (
        not StepErrors(POSITION_SIGMA, ATTITUDE_SIGMA, per_hour=120.0)
        .variance(EPOCH_COUNT, INTERVAL)
        .any()
    )


def test_steps_at_given_times() -> None:
    errors = drawn(StepErrors(POSITION_SIGMA, ATTITUDE_SIGMA, at=(30.0, 90.0)), draws=500)
    time = np.arange(EPOCH_COUNT) * INTERVAL
    assert not errors[:, time < 30].any()
    for inside in ((time >= 30) & (time < 90), time >= 90):
        assert (np.ptp(errors[:, inside], axis=1) == 0).all()
        np.testing.assert_allclose(errors[:, inside][:, 0].std(axis=0), 1.0, rtol=0.16)


def test_a_combined_model_is_the_sum_of_independent_errors() -> None:
    both = CombinedModel((NOISE, StepErrors(POSITION_SIGMA, ATTITUDE_SIGMA, at=(0.0,))))
    errors = drawn(both, draws=1000)
    np.testing.assert_allclose((errors**2).mean(axis=(0, 1)), 2.0, rtol=0.12)
    assert combine_models([HYDROGRAPHIC_INS]) is HYDROGRAPHIC_INS
    assert combine_models([NOISE, OUTAGE_UNSMOOTHED]) == CombinedModel((NOISE, OUTAGE_UNSMOOTHED))


@pytest.mark.parametrize(
    "model", [NOISE, OUTAGE_SMOOTHED, StepErrors(POSITION_SIGMA, ATTITUDE_SIGMA, per_hour=60.0)]
)
def test_the_same_seed_gives_the_same_errors(model: PosErrors) -> None:
    first, second, other = (
        np.hstack(model.draw(EPOCH_COUNT, INTERVAL, np.random.default_rng(seed)))
        for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(first, second)
    assert not np.array_equal(first, other)
