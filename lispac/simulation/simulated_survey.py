"""Simulation of a whole survey from one seed: motion, scene, POS and scanner with errors."""

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import rotation_angles, rotation_matrix
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress
from lispac.simulation.motion_source import MotionSource, RecordedTrajectory, SailedTrajectory
from lispac.simulation.port_scene import (
    LOCAL_ORIGIN,
    TARGET_NAMES,
    VALIDATION_NAMES,
    port_scene,
    six_lines,
)
from lispac.simulation.pos_error_models import PosErrors
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.simulation.scanner import Echoes, Scanner, scan_scene
from lispac.simulation.scene import Rectangle, Scene, Sphere
from lispac.simulation.vessel_motion import VesselMotion
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

POS_HEIGHT = 1.1  # metres above the water
LEVER_ARM = (-0.242, 0.061, 2.173)  # metres, body
BORESIGHT_DEG = (0.27, -1.14, 0.36)  # roll, pitch, yaw
POINTS_PER_SECOND = 150_000.0


@dataclass(frozen=True, eq=False)
class SimulatedLine:
    """One line as the scanner recorded it.

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
        Intersections of the beams with the surfaces.
    """

    name: str
    heading_deg: float
    time: Array
    points_lidar: Array
    true_points_local: Array
    intensity: NDArray[np.uint16]
    label: NDArray[np.int16]


@dataclass(frozen=True, eq=False)
class SimulatedTrajectory:
    """Trajectory reported by the POS, and the true one.

    Attributes
    ----------
    time : ndarray of shape (n,), GPS seconds of week
    latitude, longitude : ndarray of shape (n,), radians
    height : ndarray of shape (n,), metres above the ellipsoid
    roll, pitch, heading : ndarray of shape (n,), radians
        Relative to North-West-Up at the vessel, in the program's convention; heading in (-pi, pi].
    sigma_position : ndarray of shape (n, 3), metres; north, east, up
    sigma_attitude : ndarray of shape (n, 3), radians; roll, pitch, heading
        Standard deviations reported by the POS.
    interval : float, seconds
        Time between two states.
    true_position_local : ndarray of shape (n, 3), metres, local
    true_attitude : ndarray of shape (n, 3), radians
        Roll, pitch, heading relative to the axes of the local frame, without jumps.
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
    interval: float
    true_position_local: Array
    true_attitude: Array


@dataclass(frozen=True, eq=False)
class SurveySetup:
    """All inputs of a survey besides its seed.

    Attributes
    ----------
    origin : tuple of float
        Latitude and longitude (radians) and ellipsoidal height (metres) of the local frame.
    scene : Scene
    targets, validation : tuple of str
        Names of the rectangles and spheres of the scene used as targets and validation planes.
    motion_source : MotionSource
    pos : PosErrors
    scanner : Scanner
    mounting : Mounting
        The true mounting.
    """

    origin: tuple[float, float, float]
    scene: Scene
    targets: tuple[str, ...]
    validation: tuple[str, ...]
    motion_source: MotionSource
    pos: PosErrors
    scanner: Scanner
    mounting: Mounting


@dataclass(frozen=True, eq=False)
class SimulatedSurvey:
    """A whole simulated survey with the true values.

    Attributes
    ----------
    origin : tuple of float
        Latitude and longitude (radians) and ellipsoidal height (metres) of the local frame.
    mounting : Mounting
        The true mounting.
    targets, validation : dict of name to ndarray of shape (3,), metres, local
        Seed on each: the centre of a plane, or the point of a sphere that faces the vessel.
    """

    origin: tuple[float, float, float]
    mounting: Mounting
    trajectory: SimulatedTrajectory
    lines: tuple[SimulatedLine, ...]
    targets: dict[str, Array]
    validation: dict[str, Array]
    scene: Scene

    @property
    def lever_arm(self) -> Array:
        """True lever arm, shape (3,), metres, body."""
        return self.mounting.lever_arm

    @property
    def boresight(self) -> Array:
        """True roll, pitch, yaw, shape (3,), radians."""
        return self.mounting.boresight

    @property
    def surface_names(self) -> tuple[str, ...]:
        """Names of the surfaces; the labels of points are indices into them."""
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
    """Simulate the six lines of the built-in survey of a small port.

    Parameters
    ----------
    points_per_second : float
        Pulses per second of the profiler over its whole rotation; a fifth of them lie in the window
        towards the quay.
    boresight_deg : tuple of float
        True roll, pitch, yaw.
    seed, noise, pos_errors, progress
        See `simulate_survey`.
    """
    setup = SurveySetup(
        LOCAL_ORIGIN, port_scene(), TARGET_NAMES, VALIDATION_NAMES,
        SailedTrajectory(six_lines(), POS_HEIGHT), HYDROGRAPHIC_INS, Scanner(points_per_second),
        Mounting(np.array(LEVER_ARM), np.radians(boresight_deg)),
    )  # fmt: skip
    return simulate_survey(setup, seed=seed, noise=noise, pos_errors=pos_errors, progress=progress)


def simulate_survey(
    setup: SurveySetup,
    *,
    seed: int,
    noise: bool = True,
    pos_errors: bool = True,
    progress: Progress = no_progress,
) -> SimulatedSurvey:
    """Simulate a survey.

    The result depends only on the arguments. The motion of the vessel depends only on its source
    and on the seed, so that surveys with and without noise or POS errors can be compared point by
    point.

    Parameters
    ----------
    noise : bool
        Whether the scanner has range and angle noise and mixed echoes at edges.
    pos_errors : bool
        Whether the POS has errors. Without noise and POS errors, every point georeferenced with the
        true mounting lies on its surface.

    Raises
    ------
    InputError
        If the trajectory does not cover the lines.
    """
    source, scene = setup.motion_source, setup.scene
    if isinstance(source, RecordedTrajectory):
        source.require_stretches_covered(setup.mounting.latency)
    legs = source.legs
    sea, errors, *scanners = np.random.default_rng(seed).spawn(2 + len(legs))
    motion = source.motion(sea)
    _require_trajectory_covers(motion, setup.mounting.latency)
    trajectory = _reported_trajectory(setup, motion, errors if pos_errors else None)
    states = (trajectory.time, motion.position, motion.attitude)
    if scene.meshes is not None:
        progress(0.0)  # created once, before the threads start

    def record(i: int) -> Echoes:
        start, stop = motion.recorded[i]
        recorded = (source.start + start, source.start + stop)
        generator = scanners[i] if noise else None
        side = legs[i].starboard
        return scan_scene(setup.scanner, scene, states, recorded, side, setup.mounting, generator)

    lines = []
    with ThreadPoolExecutor(min(os.cpu_count() or 1, len(legs))) as pool:
        for i, echoes in enumerate(pool.map(record, range(len(legs)))):
            lines.append(SimulatedLine(legs[i].name, legs[i].heading_deg, *vars(echoes).values()))
            progress(
                (i + 1) / len(legs),
                gettext_lazy(
                    "Simulated lines: {count:n} of {total:n}", count=i + 1, total=len(legs)
                ),
            )
    return SimulatedSurvey(
        setup.origin,
        setup.mounting,
        trajectory,
        tuple(lines),
        _surface_seeds(setup, setup.targets, motion),
        _surface_seeds(setup, setup.validation, motion),
        scene,
    )


def _require_trajectory_covers(motion: VesselMotion, latency: float) -> None:
    first = min(start for start, _ in motion.recorded) + latency
    last = max(stop for _, stop in motion.recorded) + latency
    if first < motion.time[0] or last > motion.time[-1]:
        raise InputError(error("simulation.latency", latency=latency))


def _surface_seeds(
    setup: SurveySetup, names: tuple[str, ...], motion: VesselMotion
) -> dict[str, Array]:
    """Seeds on surfaces: centres of rectangles, points of spheres towards the mean position."""
    seeds = {}
    for name in names:
        surface = setup.scene[name]
        if isinstance(surface, Rectangle):
            seeds[name] = surface.centre.copy()
        elif isinstance(surface, Sphere):
            towards = motion.position.mean(axis=0) - surface.centre
            seeds[name] = surface.centre + surface.radius * towards / np.linalg.norm(towards)
    return seeds


def _nearest_rows(time: Array, even: Array, values: Array) -> Array:
    """Rows of evenly sampled values nearest to given times, shape (n, k)."""
    if len(time) == len(even):
        return values
    # Values are not interpolated, which would reduce the standard deviation of white noise.
    return values[np.rint(time / (even[1] - even[0])).astype(np.intp)]


def _reported_trajectory(
    setup: SurveySetup, motion: VesselMotion, generator: np.random.Generator | None
) -> SimulatedTrajectory:
    """Convert true states to POS output: geodetic, attitude relative to the local level."""
    time, interval = motion.time, motion.interval
    # A recorded trajectory may have gaps: errors are drawn for all times and taken at its states.
    even = np.arange(round((time[-1] - time[0]) / interval) + 1) * interval
    position_error, attitude_error = np.zeros((2, len(time), 3))
    if generator is not None:
        errors = setup.pos.draw(len(even), interval, generator)
        position_error, attitude_error = (
            _nearest_rows(time - time[0], even, each) for each in errors
        )
    sigma = np.sqrt(_nearest_rows(time - time[0], even, setup.pos.variance(len(even), interval)))
    frame = LocalFrame(*setup.origin)
    latitude, longitude, _ = frame.to_geodetic(motion.position)
    rotation_level_local = np.swapaxes(frame.rotation_local_level(latitude, longitude), -1, -2)
    attitude = rotation_angles(rotation_level_local @ rotation_matrix(*motion.attitude.T))
    roll, pitch, heading = (attitude + attitude_error).T
    latitude, longitude, height = frame.to_geodetic(motion.position + position_error)
    return SimulatedTrajectory(
        setup.motion_source.start + motion.time,
        latitude,
        longitude,
        height,
        roll,
        pitch,
        np.pi - (np.pi - heading) % (2 * np.pi),
        sigma[:, :3],
        sigma[:, 3:],
        interval,
        motion.position,
        motion.attitude,
    )
