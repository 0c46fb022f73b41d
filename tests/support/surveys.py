"""Small surveys with known truth, simulated in closed form."""

from dataclasses import replace

import numpy as np

from lispac.adjustment.model.observations import Observations, Sighting
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.georeferencing import Mounting, Poses, to_lidar

HEADINGS_DEG = (0, 180, 45, 225, 315, 135)
TARGETS = {
    "T1": (np.array([0.6, 15.0, 5.0]), np.array([0.0, -1.0, 0.0])),
    "T2": (np.array([-0.6, 15.0, 5.0]), np.array([0.0, -np.sqrt(0.5), np.sqrt(0.5)])),
}


def planar_survey(
    mounting: Mounting,
    *,
    points: int = 100,
    headings_deg: tuple[float, ...] = HEADINGS_DEG,
    targets: tuple[str, ...] = ("T1", "T2"),
    scatter: bool = True,
    seed: int = 7,
) -> Observations:
    """Exact points of flat boards 15 m from six lines; every point of a line has its own pose.

    Without ``scatter`` the vessel moves exactly along its course, level.

    The sigmas are those of the noise added by `disturbed`.
    """
    rng = np.random.default_rng(seed)
    rows: list[np.ndarray] = []
    sightings = []
    for target in targets:
        centre, normal = TARGETS[target]
        across = np.array([1.0, 0, 0])
        along = np.cross(normal, across)
        for k, heading in enumerate(headings_deg):
            u, v = rng.uniform(-0.6, 0.6, (2, points))
            local = centre + u[:, None] * across + v[:, None] * along
            course = np.array([np.cos(np.radians(heading)), -np.sin(np.radians(heading)), 0])
            motion = rng.normal(0, 1.0, (2, points, 3)) * scatter
            attitude = np.radians([0, 0, heading]) + 0.01 * motion[0]
            # The scanner measures across the course, so the vessel is abeam of the point.
            position = course * (local @ course)[:, None] + 0.05 * motion[1]
            time = 100.0 * k + rng.uniform(0, 1, points) + 2 * targets.index(target)
            scan = to_lidar(local, Poses(position, attitude), mounting)
            rows.append(np.column_stack([scan, position, attitude, time]))
            sightings.append(Sighting(target, f"L{k + 1}"))
    table = np.concatenate(rows)
    count = len(table)
    return Observations(
        points_lidar=np.ascontiguousarray(table[:, :3]),
        position=np.ascontiguousarray(table[:, 3:6]),
        attitude=np.ascontiguousarray(table[:, 6:9]),
        sigma_lidar=np.full((count, 3), 0.003),
        sigma_position=np.tile([0.012, 0.012, 0.02], (count, 1)),
        sigma_attitude=np.tile(np.radians([0.008, 0.008, 0.012]), (count, 1)),
        time=table[:, 9].copy(),
        sighting=np.repeat(np.arange(len(sightings)), points),
        sightings=tuple(sightings),
    )


def disturbed(
    observations: Observations,
    *,
    correlated: bool,
    seed: int,
    correlation_times: tuple[float, float] = (300.0, 600.0),
) -> Observations:
    """Add noise of the given sigmas; POS errors drift in time (correlated) or are independent."""
    rng = np.random.default_rng(seed)

    def pos_error(sigma: np.ndarray, correlation_time: float) -> np.ndarray:
        if correlated:
            return sigma * gauss_markov(observations.time, correlation_time, rng)
        return sigma * rng.normal(size=sigma.shape)

    position_time, attitude_time = correlation_times
    return replace(
        observations,
        points_lidar=observations.points_lidar
        + observations.sigma_lidar * rng.normal(size=observations.sigma_lidar.shape),
        position=observations.position + pos_error(observations.sigma_position, position_time),
        attitude=observations.attitude + pos_error(observations.sigma_attitude, attitude_time),
    )


def gauss_markov(time: np.ndarray, correlation_time: float, rng: np.random.Generator) -> np.ndarray:
    """Three components of a unit first-order Gauss-Markov process at given times, shape (n, 3)."""
    order = np.argsort(time)
    kept = np.exp(-np.diff(time[order]) / correlation_time)
    fresh = np.sqrt(1 - kept**2)
    draws = rng.normal(size=(len(time), 3))
    values = np.empty_like(draws)
    values[0] = draws[0]
    for k in range(1, len(time)):
        values[k] = kept[k - 1] * values[k - 1] + fresh[k - 1] * draws[k]
    drifting = np.empty_like(values)
    drifting[order] = values
    return drifting


def turned(normal: np.ndarray, degrees: float) -> np.ndarray:
    """A normal rotated about all axes by the given degrees."""
    return rotation_matrix(*np.full(3, np.radians(degrees))) @ normal
