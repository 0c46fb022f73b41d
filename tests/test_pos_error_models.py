"""Every model of POS errors has the statistics that it claims, from many draws."""

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

DRAWS, INTERVAL, COUNT = 3000, 0.5, 241
POSITION, ATTITUDE = (0.10, 0.20, 0.40), tuple(np.radians([0.01, 0.02, 0.08]))
OUTAGE = GnssOutage(20.0, 60.0, POSITION, ATTITUDE, smoothed=False)
SMOOTHED = GnssOutage(20.0, 60.0, POSITION, ATTITUDE)
NOISE = WhiteNoise(POSITION, ATTITUDE)


def drawn(model: PosErrors, count: int = COUNT, draws: int = DRAWS) -> np.ndarray:
    """Errors, shape (draws, count, 6), each divided by the sigma put in."""
    streams = np.random.default_rng(11).spawn(draws)
    errors = np.stack([np.hstack(model.draw(count, INTERVAL, stream)) for stream in streams])
    return errors / np.array([*POSITION, *ATTITUDE])


@pytest.mark.parametrize(
    "model",
    [NOISE, OUTAGE, SMOOTHED, CombinedModel((NOISE, SMOOTHED))],
    ids=["white", "outage", "smoothed", "together"],
)
def test_the_given_variance_is_that_of_the_errors(model: PosErrors) -> None:
    """3000 draws know a standard deviation to 1.3 %; five sigma are taken for 241 x 6 of them."""
    stated = np.sqrt(model.variance(COUNT, INTERVAL)) / np.array([*POSITION, *ATTITUDE])
    found = np.sqrt((drawn(model) ** 2).mean(axis=0))
    assert stated.max() > 0.1
    np.testing.assert_allclose(found, stated, rtol=0.065, atol=1e-12)


def test_white_noise_has_no_memory() -> None:
    errors = drawn(NOISE, draws=400)
    assert abs((errors[:, 1:] * errors[:, :-1]).mean()) < 5 / np.sqrt(400 * 240 * 6)


def test_an_outage_drifts_with_the_power_three_halves_and_ends() -> None:
    time = np.arange(COUNT) * INTERVAL
    errors = drawn(OUTAGE)
    assert not errors[:, (time <= 20) | (time > 80)].any()
    at_end, half_way = (errors[:, time == t][:, 0].std(axis=0) for t in (80.0, 50.0))
    np.testing.assert_allclose(at_end, 1.0, rtol=0.065)
    np.testing.assert_allclose(half_way, [0.5**1.5] * 3 + [0.5**0.5] * 3, rtol=0.065)
    # Position is smooth, its speed having a memory; attitude is a random walk.
    change = np.diff(errors[:, (time > 60) & (time <= 80)], axis=1)
    memory = (change[:, 1:] * change[:, :-1]).mean(axis=(0, 1)) / (change**2).mean(axis=(0, 1))
    assert memory[:3].min() > 0.9
    assert np.abs(memory[3:]).max() < 0.05


def test_smoothing_leaves_an_eighth_in_the_middle() -> None:
    time = np.arange(COUNT) * INTERVAL
    sigma = drawn(SMOOTHED).std(axis=0)
    assert time[np.argmax(sigma[:, :3].mean(axis=1))] == pytest.approx(50.0, abs=3.0)
    np.testing.assert_allclose(sigma[time == 50.0][0, :3], 1 / 8, rtol=0.065)
    np.testing.assert_allclose(sigma[time == 50.0][0, 3:], 1 / 2, rtol=0.065)
    assert sigma[time == 80.0].max() < 1e-9


def test_an_outage_between_two_samples_does_nothing() -> None:
    assert not drawn(GnssOutage(20.1, 0.3, POSITION, ATTITUDE), draws=1).any()


def test_jumps_come_as_often_as_given_and_stay() -> None:
    errors = drawn(StepErrors(POSITION, ATTITUDE, per_hour=120.0))
    changes = np.count_nonzero(np.diff(errors[..., 0], axis=1), axis=1)
    expected = 120 * 240 * INTERVAL / 3600  # 4 in 120 s
    assert changes.mean() == pytest.approx(expected, rel=0.05)
    assert changes.var() == pytest.approx(expected, rel=0.12), "as Poisson's law has it"
    np.testing.assert_allclose(errors[:, -1].std(axis=0), np.sqrt(1 - np.exp(-4)), rtol=0.065)
    assert not StepErrors(POSITION, ATTITUDE, per_hour=120.0).variance(COUNT, INTERVAL).any()


def test_jumps_at_given_times() -> None:
    errors = drawn(StepErrors(POSITION, ATTITUDE, at=(30.0, 90.0)), draws=500)
    time = np.arange(COUNT) * INTERVAL
    assert not errors[:, time < 30].any()
    for inside in ((time >= 30) & (time < 90), time >= 90):
        assert (np.ptp(errors[:, inside], axis=1) == 0).all()
        np.testing.assert_allclose(errors[:, inside][:, 0].std(axis=0), 1.0, rtol=0.16)


def test_together_is_the_sum_of_independent_parts() -> None:
    both = CombinedModel((NOISE, StepErrors(POSITION, ATTITUDE, at=(0.0,))))
    errors = drawn(both, draws=1000)
    np.testing.assert_allclose((errors**2).mean(axis=(0, 1)), 2.0, rtol=0.12)
    assert combine_models([HYDROGRAPHIC_INS]) is HYDROGRAPHIC_INS
    assert combine_models([NOISE, OUTAGE]) == CombinedModel((NOISE, OUTAGE))


@pytest.mark.parametrize("model", [NOISE, SMOOTHED, StepErrors(POSITION, ATTITUDE, per_hour=60.0)])
def test_the_same_seed_gives_the_same_errors(model: PosErrors) -> None:
    first, second, other = (
        np.hstack(model.draw(COUNT, INTERVAL, np.random.default_rng(seed))) for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(first, second)
    assert not np.array_equal(first, other)
