"""Simulate one survey of a plan with all its points and errors.

It is independent of the prediction (`lispac.design.prediction`), except for how many points a
sighting has: the boards lie off their shape, the LiDAR has noise, the POS errors drift, and the
vessel rolls.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations, Sighting
from lispac.design.plan import Plan
from lispac.design.prediction import MIN_POINTS, UNSEEN, expected_point_count
from lispac.errors import RankDeficient
from lispac.simulation.closed_form_survey import (
    Ball,
    Board,
    SeaMotion,
    add_errors,
    error_free_record,
    observations_of_records,
    scanner_position_abeam,
)

Array = NDArray[np.float64]


def simulate_plan(
    plan: Plan, generator: np.random.Generator, *, perfect: bool = False, calm: bool = False
) -> Observations:
    """Simulate one survey of a plan as observations of the adjustment.

    Parameters
    ----------
    perfect : bool
        Targets, scanner and POS without any error.
    calm : bool
        The vessel neither rolls nor drifts off its lines.

    Raises
    ------
    RankDeficient
        No target is visible on any line.
    """
    system, rows, sightings = plan.system, [], []
    sea = SeaMotion.draw(generator)
    if calm:
        sea = replace(sea, sigma=0.0 * sea.sigma)
    for target in plan.targets:
        flatness = plan.flatness if target.flatness is None else target.flatness
        for course in plan.courses:
            scanner = scanner_position_abeam(system.mounting, target, course)
            count = expected_point_count(system, target, course, scanner)
            if count < MIN_POINTS:
                continue
            off = (0.0 if perfect else flatness) * generator.standard_normal(3)
            points = _simulate_target_points(target, count, off, generator, scanner)
            rows.append(error_free_record(system.mounting, course, sea, points))
            sightings.append(Sighting(target.name, course.name))
    if not rows:
        raise RankDeficient(UNSEEN)
    exact = observations_of_records(
        rows, sightings, plan.targets, system.pos, system.scanner.range_sigma
    )
    sigma = exact.sigma_lidar.copy()
    ranges = np.linalg.norm(exact.points_lidar, axis=1)
    sigma[:, 1:] = system.scanner.angle_sigma * ranges[:, None]
    exact = replace(exact, sigma_lidar=sigma, beam_sigmas=True)
    return exact if perfect else add_errors(exact, system.pos, generator)


def _simulate_target_points(
    target: Board | Ball, count: float, off: Array, generator: np.random.Generator, scanner: Array
) -> Array:
    """Points of one sighting, one in each field of an even grid, as a scanner lays them.

    Parameters
    ----------
    off : ndarray of shape (3,), metres
        How far this line sees the target off its shape: two borders lifted, and the whole.

    Returns
    -------
    ndarray of shape (about ``count``, 3), metres, local
    """
    # The visible part of a ball is the disc in the square that the grid covers.
    side = round(np.sqrt(count * 4 / np.pi if isinstance(target, Ball) else count))
    fields = np.stack(np.divmod(np.arange(side**2), side))
    u, v = 2 * (fields + generator.uniform(0, 1, fields.shape)) / side - 1
    if isinstance(target, Ball):
        points = target.cap(target.visible_radius * u, target.visible_radius * v, scanner)
        return points + off[2] * (points - np.array(target.centre)) / target.radius
    points = target.points_on_board(u * target.width / 2, v * target.height / 2)
    return np.asarray(points + (u * off[0] + v * off[1] + off[2])[:, None] * target.facing)
