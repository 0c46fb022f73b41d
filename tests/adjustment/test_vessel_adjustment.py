"""Tests of adjusting balls and plates of a real vessel survey of two lines.

The lines run in opposite directions, with the balls at 9 to 20 m. Roll is determined well, pitch
and yaw mainly by the displacement of the lines along their course.
"""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.geometry.spheres import fit_sphere, rms_from_sphere
from tests.support.long_runs import others_long
from tests.targets.test_vessel_spheres import BALLS, VESSEL, Vessel

PLATES = tuple(f"target{k}" for k in range(1, 6))
MODELS = [StochasticModel(), StochasticModel(loss="tukey")]


@pytest.fixture(scope="module")
def vessel(shared_data):
    return Vessel(shared_data)


def observations(vessel, names):
    """Return the points of the objects with the sigmas of the files.

    Coordinates of each object are relative to an origin near it, since the origin of the files is 2
    km away. The conditions compare points of one object only, so they are not affected.
    """
    rows, sightings = [], []
    for name in names:
        for line, table in vessel.rows.items():
            rows.append(table[vessel.labels[line] == name])
            sightings.append(Sighting(name, line))
    counts = [len(part) for part in rows]
    place = {name: np.round(rows[2 * k][0, :3]) for k, name in enumerate(names)}
    off = np.repeat([place[s.target] for s in sightings], counts, axis=0)
    column = np.ascontiguousarray(np.concatenate(rows).T)
    return Observations(
        points_lidar=column[4:7].T.copy(),
        position=column[16:19].T - off,
        attitude=column[10:13].T.copy(),
        sigma_lidar=column[7:10].T.copy(),
        sigma_position=column[19:22].T.copy(),
        sigma_attitude=column[13:16].T.copy(),
        time=column[3].copy(),
        sighting=np.repeat(np.arange(len(sightings)), counts),
        sightings=tuple(sightings),
        radii={name: 0.1 for name in names if name in BALLS},
    )


def agreement(vessel, mounting):
    """Return, for each ball, the distance between its centres and the RMS about one ball."""
    clouds = vessel.clouds(mounting.boresight)
    apart, rms = [], []
    for name in BALLS:
        ball_points = [cloud[vessel.labels[line] == name] for line, cloud in clouds.items()]
        first, second = (fit_sphere(points, 0.1).centre for points in ball_points)
        apart.append(np.linalg.norm(first - second))
        both = np.concatenate(ball_points)
        rms.append(rms_from_sphere(fit_sphere(both, 0.1), both))
    return np.array(apart), np.array(rms)


def millimetres_text(values):
    return ", ".join(f"{1000.0 * value:.1f}" for value in values)


def test_the_files_agree_with_the_georeferencing_equation(vessel):
    clouds = vessel.clouds(VESSEL.boresight)
    for line, rows in vessel.rows.items():
        np.testing.assert_allclose(clouds[line], rows[:, :3], atol=1e-9)


@pytest.mark.parametrize("model", others_long(MODELS), ids=lambda model: model.loss)
@pytest.mark.parametrize("names", [BALLS, (*BALLS, *PLATES)], ids=["balls", "balls and plates"])
def test_balls_agree_better_than_with_the_stored_boresight(vessel, names, model):
    result = adjust(observations(vessel, names), VESSEL, model)
    before, after = agreement(vessel, VESSEL), agreement(vessel, result.mounting)
    print(f"centres apart {millimetres_text(before[0])} -> {millimetres_text(after[0])} mm")
    print(f"RMS about one ball {millimetres_text(before[1])} -> {millimetres_text(after[1])} mm")
    moved = np.degrees(result.boresight - VESSEL.boresight)
    print(
        f"boresight {np.degrees(result.boresight).round(3)} deg, {moved.round(3)} from the stored "
        f"one, sigma {np.degrees(result.sigma).round(3)}, variance factor "
        f"{result.variance_factor:.1f}, surface {1000.0 * result.surface:.1f} mm"
    )
    assert (after[0] < 0.6 * before[0]).all()
    assert (after[1] < before[1]).all()
    assert np.sqrt(np.mean(after[1] ** 2)) < 0.6 * np.sqrt(np.mean(before[1] ** 2))
    # A small mounting error, not a solution with opposite angles
    assert np.abs(moved).max() < 2.0


@pytest.mark.parametrize("excluded", BALLS)
def test_a_ball_excluded_from_the_adjustment_agrees_better_too(vessel, excluded):
    names = [name for name in BALLS if name != excluded]
    result = adjust(observations(vessel, names), VESSEL, StochasticModel())
    k = BALLS.index(excluded)
    before, after = agreement(vessel, VESSEL)[0][k], agreement(vessel, result.mounting)[0][k]
    print(
        f"without {excluded}: its centres {1000.0 * before:.1f} -> {1000.0 * after:.1f} mm apart, "
        f"boresight {np.degrees(result.boresight).round(3)} deg, sigma "
        f"{np.degrees(result.sigma).round(3)}"
    )
    assert after < 0.7 * before


def test_the_local_origin_of_an_object_does_not_matter(vessel):
    own = observations(vessel, BALLS)
    elsewhere = replace(own, position=own.position + [3.0, -20.0, 8.0])
    one, other = (adjust(o, VESSEL, StochasticModel()) for o in (own, elsewhere))
    np.testing.assert_allclose(one.boresight, other.boresight, rtol=0, atol=1e-9)
