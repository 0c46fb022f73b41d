"""The built-in survey: a vessel, its POS and its profiler in a small port, from one seed."""

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import angles_of, rotation_matrix
from lispac.progress import Progress, no_progress
from lispac.simulation.port import ORIGIN, TARGETS, VALIDATION, port_scene, six_passes
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS, PosErrorModel
from lispac.simulation.scanner import Echoes, Scanner, scan
from lispac.simulation.scene import Rectangle, Scene
from lispac.simulation.vessel import RATE, Motion, sail
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

START = 2 * 86400 + 15 * 3600.0  # GPS seconds of week: a Tuesday afternoon
POS_HEIGHT = 1.1  # metres above the water
LEVER_ARM = (-0.242, 0.061, 2.173)  # metres, body
BORESIGHT_DEG = (0.27, -1.14, 0.36)  # roll, pitch, yaw
POINTS_PER_SECOND = 150_000.0


@dataclass(frozen=True, eq=False)
class SimulatedLine:
    """One pass as the scanner recorded it.

    Attributes
    ----------
    name : str
    heading_deg : float
    time : ndarray of shape (n,), GPS seconds of week
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    intensity : ndarray of shape (n,)
    label : ndarray of shape (n,)
        Index into the survey's surface names; -1 for an echo mixed from two surfaces.
    true_points_local : ndarray of shape (n, 3), metres, local
        Where the beam met the surface.
    """

    name: str
    heading_deg: float
    time: Array
    points_lidar: Array
    intensity: NDArray[np.uint16]
    label: NDArray[np.int16]
    true_points_local: Array


@dataclass(frozen=True, eq=False)
class SimulatedTrajectory:
    """What the POS reports, and the truth beside it.

    Attributes
    ----------
    time : ndarray of shape (n,), GPS seconds of week
    latitude, longitude : ndarray of shape (n,), radians
    height : ndarray of shape (n,), metres above the ellipsoid
    roll, pitch, heading : ndarray of shape (n,), radians
        Against North-West-Up at the vessel, in the program's convention; heading in (-pi, pi].
    sigma_position : ndarray of shape (3,), metres; north, east, up
    sigma_attitude : ndarray of shape (3,), radians; roll, pitch, heading
    true_position_local : ndarray of shape (n, 3), metres, local
    true_attitude : ndarray of shape (n, 3), radians
        Roll, pitch, heading against the axes of the local frame, without jumps.
    """

    time: Array
    latitude: Array
    longitude: Array
    height: Array
    roll: Array
    pitch: Array
    heading: Array
    sigma_position: Array
    sigma_attitude: Array
    true_position_local: Array
    true_attitude: Array


@dataclass(frozen=True, eq=False)
class SimulatedSurvey:
    """A whole survey with its truth.

    Attributes
    ----------
    origin : tuple of float
        Latitude and longitude (radians) and ellipsoidal height (metres) of the local frame.
    lever_arm : ndarray of shape (3,), metres, body
    boresight : ndarray of shape (3,), radians
        True roll, pitch, yaw.
    targets, validation : dict of name to ndarray of shape (3,), metres, local
        Centre of each plane: a seed.
    """

    origin: tuple[float, float, float]
    lever_arm: Array
    boresight: Array
    trajectory: SimulatedTrajectory
    lines: tuple[SimulatedLine, ...]
    targets: dict[str, Array]
    validation: dict[str, Array]
    scene: Scene

    @property
    def surface_names(self) -> tuple[str, ...]:
        """Names the labels of the points stand for."""
        return self.scene.names


def port_survey(
    *,
    seed: int = 2019,
    points_per_second: float = POINTS_PER_SECOND,
    boresight_deg: tuple[float, float, float] = BORESIGHT_DEG,
    noise: bool = True,
    pos_errors: bool = True,
    progress: Progress = no_progress,
) -> SimulatedSurvey:
    """Simulate the six passes of the port survey.

    The same arguments give the same arrays. The vessel's motion depends on the seed alone, so
    surveys with and without noise or POS errors can be compared point by point.

    Parameters
    ----------
    points_per_second : float
        Pulses per second of the profiler over its whole turn; the window toward the quay
        takes a fifth of them.
    boresight_deg : tuple of float
        True roll, pitch, yaw.
    noise : bool
        Whether the scanner has range and angle noise and mixed echoes at edges.
    pos_errors : bool
        Whether the POS errs. Without noise and POS errors, georeferencing with the true
        mounting puts every point onto its surface.
    """
    sea, errors, *scanners = np.random.default_rng(seed).spawn(8)
    scene, passes = port_scene(), six_passes()
    scanner = Scanner(points_per_second)
    mounting = Mounting(np.array(LEVER_ARM), np.radians(boresight_deg))
    motion = sail(passes, POS_HEIGHT, sea)
    trajectory = _report(motion, HYDROGRAPHIC_INS, errors if pos_errors else None)
    states = (trajectory.time, motion.position, motion.attitude)

    def record(i: int) -> Echoes:
        recorded = (START + motion.recorded[i][0], START + motion.recorded[i][1])
        generator = scanners[i] if noise else None
        side = passes[i].starboard
        return scan(scanner, scene, states, recorded, side, mounting, generator)

    lines = []
    with ThreadPoolExecutor(min(os.cpu_count() or 1, len(passes))) as pool:
        for i, echoes in enumerate(pool.map(record, range(len(passes)))):
            heading_deg = float(np.degrees(passes[i].heading))
            lines.append(
                SimulatedLine(
                    f"L{i + 1}_{heading_deg:03.0f}",
                    heading_deg,
                    echoes.time,
                    echoes.points_lidar,
                    echoes.intensity,
                    echoes.label,
                    echoes.true_points_local,
                )
            )
            progress((i + 1) / len(passes), f"Scanned line {i + 1} of {len(passes)}")
    return SimulatedSurvey(
        ORIGIN,
        mounting.lever_arm,
        mounting.boresight,
        trajectory,
        tuple(lines),
        _centres(scene, TARGETS),
        _centres(scene, VALIDATION),
        scene,
    )


def _centres(scene: Scene, names: tuple[str, ...]) -> dict[str, Array]:
    surfaces = {name: scene[name] for name in names}
    return {name: s.centre.copy() for name, s in surfaces.items() if isinstance(s, Rectangle)}


def _report(
    motion: Motion, model: PosErrorModel, generator: np.random.Generator | None
) -> SimulatedTrajectory:
    """Turn true states into what the POS says: geodetic, against the level at the vessel."""
    count = len(motion.time)
    position_error, attitude_error = np.zeros((count, 3)), np.zeros((count, 3))
    if generator is not None:
        position_error, attitude_error = model.draw(count, 1 / RATE, generator)
    frame = LocalFrame(*ORIGIN)
    latitude, longitude, _ = frame.to_geodetic(motion.position)
    rotation_level_local = np.swapaxes(frame.rotation_local_level(latitude, longitude), -1, -2)
    attitude = angles_of(rotation_level_local @ rotation_matrix(*motion.attitude.T))
    roll, pitch, heading = (attitude + attitude_error).T
    latitude, longitude, height = frame.to_geodetic(motion.position + position_error)
    return SimulatedTrajectory(
        START + motion.time,
        latitude,
        longitude,
        height,
        roll,
        pitch,
        np.pi - (np.pi - heading) % (2 * np.pi),
        np.array(model.sigma_position),
        np.array(model.sigma_attitude),
        motion.position,
        motion.attitude,
    )
