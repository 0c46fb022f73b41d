"""Simulated point correspondences: places of rough terrain measured twice from crossing lines."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations, Sighting
from lispac.simulation.closed_form_survey import gauss_markov_drift
from lispac.survey.georeferencing import Mounting, to_lidar
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]

TRUE_MOUNTING = Mounting(np.array([-0.186, 0.038, 2.419]), np.radians([0.4, -1.3, 0.7]))
LINE_SECONDS, TURN_SECONDS, SPEED = 40.0, 60.0, 2.0
HEADINGS = np.radians([0.0, 180.0, 90.0, 270.0])
POSITION_SIGMA = np.array([0.01, 0.01, 0.015])
ATTITUDE_SIGMA = np.radians([0.005, 0.005, 0.01])


@dataclass(frozen=True, eq=False)
class SimulatedPairs:
    """Pairs with their true positions.

    Attributes
    ----------
    ends : Observations
        The first points of all pairs, then their second points.
    line : ndarray of shape (2 n,), int
    """

    ends: Observations
    line: NDArray[np.int64]


def poses_at(time: Array, line: NDArray[np.int64]) -> Poses:
    """True poses of a vessel that rolls and pitches on its lines, which cross in the middle."""
    within = time - line * (LINE_SECONDS + TURN_SECONDS)
    along = SPEED * (within - 0.5 * LINE_SECONDS)
    heading = HEADINGS[line]
    # Heading is clockwise; y points west
    position = np.column_stack([along * np.cos(heading), -along * np.sin(heading), 0.0 * along])
    position[:, 2] = 0.1 * np.sin(2 * np.pi * within / 7.0)
    attitude = np.column_stack(
        [
            np.radians(3.0) * np.sin(2 * np.pi * within / 6.0 + line),
            np.radians(2.0) * np.sin(2 * np.pi * within / 5.0),
            heading + np.radians(1.0) * np.sin(2 * np.pi * within / 11.0),
        ]
    )
    return Poses(position, attitude)


def simulate_pairs(
    seed: int,
    count: int = 600,
    *,
    noise: float = 0.03,
    pos_factor: float = 1.0,
    wrong: float = 0.0,
    lines: int = 4,
    mounting: Mounting = TRUE_MOUNTING,
) -> SimulatedPairs:
    """Pairs of points, each measured on two lines from within 60 m.

    Parameters
    ----------
    noise : float, metres
        Standard deviation of each coordinate of a measured point.
    pos_factor : float
        Factor on the POS errors, whose accuracy is given without it.
    wrong : float
        Share of pairs whose second point is another place, up to 3 m away.
    """
    generator = np.random.default_rng(seed)
    places = generator.uniform([-40, -40, -12], [40, 40, -3], (count, 3))
    first = generator.integers(0, lines, count)
    second = (first + generator.integers(1, max(lines, 2), count)) % lines
    line = np.concatenate([first, second])
    within = generator.uniform(1.0, LINE_SECONDS - 1.0, 2 * count)
    time = within + line * (LINE_SECONDS + TURN_SECONDS)
    true = poses_at(time, line)
    seen = np.tile(places, (2, 1))
    mistaken = np.arange(2 * count) >= 2 * count - round(wrong * count)
    seen[mistaken] += generator.uniform(-3.0, 3.0, (int(mistaken.sum()), 3))
    points = to_lidar(seen, true, mounting)
    points += noise / np.sqrt(2) * generator.standard_normal(points.shape)
    drift = [gauss_markov_drift(time, each, generator) for each in (300.0, 600.0)]
    position = true.position + pos_factor * POSITION_SIGMA * drift[0]
    attitude = true.attitude + pos_factor * ATTITUDE_SIGMA * drift[1]
    ends = Observations(
        points_lidar=points,
        position=position,
        attitude=attitude,
        sigma_lidar=np.zeros_like(points),
        sigma_position=np.tile(POSITION_SIGMA, (2 * count, 1)),
        sigma_attitude=np.tile(ATTITUDE_SIGMA, (2 * count, 1)),
        time=time,
        sighting=np.zeros(2 * count, dtype=np.int64),
        sightings=(Sighting("", ""),),
    )
    return SimulatedPairs(ends, line)
