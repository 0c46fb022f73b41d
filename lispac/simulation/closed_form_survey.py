"""Simulation of surveys of boards and spheres in closed form, within a few milliseconds.

No rays are cast. The points lie on a grid over each target, and the time of each point is that at
which the scan profile of the passing vessel contains it. This is sufficient for an adjustment, so
that thousands of surveys can be simulated, while a single survey of the port scene takes a minute.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations, Sighting
from lispac.compiled_code import njit
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS, PosErrorModel
from lispac.survey.georeferencing import Mounting, to_lidar
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Board:
    """A flat rectangular target.

    Attributes
    ----------
    centre, normal : tuple of float, metres, local; the normal points to the vessel
    width, height : float, metres
    flatness : float or None, metres
        Standard deviation of the form error in one line; None for that of the plan
        (`lispac.design.plan.Plan.flatness`).
    control_sigma : float or None, metres
        Standard deviation on each axis of the surveyed corners; None if they are not surveyed.
    """

    name: str
    centre: tuple[float, float, float]
    normal: tuple[float, float, float]
    width: float = 1.23
    height: float = 1.22
    flatness: float | None = None
    control_sigma: float | None = None

    def points(
        self, spacing: float, generator: np.random.Generator, scanner: Array | None = None
    ) -> Array:
        """Points of the board on a grid with a random origin, shape (n, 3), metres, local.

        Parameters
        ----------
        spacing : float, metres
            Distance between the points.
        scanner : ndarray of shape (3,), metres, local, optional
            Not used, since the whole board is visible from any position in front of it.
        """
        u, v = (
            np.arange(-side / 2 + start, side / 2, spacing)
            for side, start in zip(
                (self.width, self.height), generator.uniform(0, spacing, 2), strict=True
            )
        )
        u, v = np.meshgrid(u, v)
        return self.points_on_board(u.ravel(), v.ravel())

    def grid(self, k: int) -> Array:
        """Grid of ``k`` x ``k`` points with the centre and the second moments of the whole board.

        The plane is determined as precisely as by all points of the board.

        Returns
        -------
        ndarray of shape (k * k, 3), metres, local
        """
        middles = (np.arange(k) + 0.5) / k - 0.5
        middles /= np.sqrt(1 - 1 / k**2)  # moments of the whole board
        u, v = np.meshgrid(self.width * middles, self.height * middles)
        return self.points_on_board(u.ravel(), v.ravel())

    @property
    def control_points(self) -> Array:
        """The four corners, which a survey of the board measures, shape (4, 3), metres, local."""
        u, v = np.array([[-1, 1, 1, -1], [-1, -1, 1, 1]]) / 2
        return self.points_on_board(self.width * u, self.height * v)

    @property
    def facing(self) -> Array:
        """Unit normal, shape (3,), local."""
        return np.asarray(np.array(self.normal) / np.linalg.norm(self.normal))

    @property
    def across(self) -> Array:
        """Horizontal unit vector along the width, shape (3,), local."""
        normal = self.facing
        # All edges of a horizontal board are horizontal: north and west are used.
        across = np.cross([1.0, 0.0, 0.0] if abs(normal[2]) > 0.999 else [0.0, 0.0, 1.0], normal)
        return np.asarray(across / np.linalg.norm(across))

    def points_on_board(self, u: Array, v: Array) -> Array:
        """Points ``u`` across and ``v`` up (n,) from the centre, shape (n, 3), metres, local."""
        across = self.across
        up = np.cross(self.facing, across)
        return np.asarray(np.array(self.centre) + u[:, None] * across + v[:, None] * up)


MIN_INCIDENCE_COSINE = np.cos(np.radians(75.0))
"""Cosine of the largest angle of incidence on a board; beyond it, points are few and poor."""

MAX_SPHERE_INCIDENCE = np.radians(80.0)
"""Largest angle of incidence on a sphere, radians; beyond it, the beams graze the sphere."""


@dataclass(frozen=True)
class Ball:
    """A spherical target.

    Attributes
    ----------
    centre : tuple of float, metres, local
    radius : float, metres
    radius_known : bool
        Whether the adjustment uses the radius as known.
    flatness : float or None, metres
        See `Board`.
    control_sigma : float or None, metres
        Standard deviation on each axis of the surveyed centre; None if it is not surveyed.
    """

    name: str
    centre: tuple[float, float, float]
    radius: float = 0.1
    radius_known: bool = True
    flatness: float | None = None
    control_sigma: float | None = None

    def points(self, spacing: float, generator: np.random.Generator, scanner: Array) -> Array:
        """Points of the cap that faces the scanner, shape (n, 3), metres, local.

        Like the beams of a scanner, they lie on a grid perpendicular to the line of sight, with a
        random origin; on the surface they are sparser towards the rim.

        Parameters
        ----------
        spacing : float, metres
            Distance between the points.
        scanner : ndarray of shape (3,), metres, local
            Position of the scanner.
        """
        rim = self.visible_radius
        u, v = (np.arange(-rim + start, rim, spacing) for start in generator.uniform(0, spacing, 2))
        u, v = np.meshgrid(u, v)
        return self.cap(u.ravel(), v.ravel(), scanner)

    def grid(self, k: int, scanner: Array) -> Array:
        """Points of the sphere on a ``k`` x ``k`` grid across the line of sight; see `points`."""
        middles = self.visible_radius * (2 * (np.arange(k) + 0.5) / k - 1)
        u, v = np.meshgrid(middles, middles)
        return self.cap(u.ravel(), v.ravel(), scanner)

    @property
    def control_points(self) -> Array:
        """The centre, which a survey of the sphere determines, shape (1, 3), metres, local."""
        return np.array([self.centre])

    @property
    def visible_radius(self) -> float:
        """Radius of the visible part, perpendicular to the line of sight, metres."""
        return float(self.radius * np.sin(MAX_SPHERE_INCIDENCE))

    def cap(self, u: Array, v: Array, scanner: Array) -> Array:
        """Points of the sphere at offsets across and up relative to the line of sight.

        Parameters
        ----------
        u, v : ndarray of shape (n,), metres
        scanner : ndarray of shape (3,), metres, local
            Position of the scanner.

        Returns
        -------
        ndarray of shape (m, 3), metres, local
        """
        towards = scanner - np.array(self.centre)
        towards /= np.linalg.norm(towards)
        across = np.cross([0.0, 0.0, 1.0], towards)
        across /= np.linalg.norm(across)
        up = np.cross(towards, across)
        visible = u**2 + v**2 <= self.visible_radius**2
        u, v = u[visible, None], v[visible, None]
        depth = np.sqrt(self.radius**2 - u**2 - v**2)
        return np.asarray(np.array(self.centre) + u * across + v * up + depth * towards)


@dataclass(frozen=True)
class Course:
    """A straight line at constant speed.

    Attributes
    ----------
    heading : float, radians clockwise from north
    abeam : tuple of float, metres, local
        Position of the vessel at ``time``.
    time : float, seconds
    speed : float, metres per second
    """

    name: str
    heading: float
    abeam: tuple[float, float]
    time: float
    speed: float = 1.0

    @property
    def direction(self) -> Array:
        """Unit vector ahead, shape (3,), local."""
        return np.array([np.cos(self.heading), -np.sin(self.heading), 0.0])


THESIS_BOARDS = (
    Board("T1", (0.8, 15.0, 5.0), (0.0, -1.0, 0.0)),
    Board("T2", (-0.8, 15.0, 5.0), (0.0, -1.0, 1.0)),
)
"""An upright and a leaning board 15 m from the vessel and 5 m above it (thesis 4.4)."""


def six_courses(interval: float = 90.0, speed: float = 0.8) -> tuple[Course, ...]:
    """The six lines of the thesis (figure 3.3), all through the local origin.

    One line starts every ``interval`` seconds, at a speed in metres per second.
    """
    return tuple(
        Course(f"L{k + 1}", float(np.radians(heading_deg)), (0.0, 0.0), 50.0 + k * interval, speed)
        for k, heading_deg in enumerate((0, 180, 45, 225, 315, 135))
    )


@dataclass(frozen=True, eq=False)
class SeaMotion:
    """Motion of the vessel relative to its course: sines with random periods and phases.

    Attributes
    ----------
    sigma : ndarray of shape (6,), metres and radians
        Standard deviations of drift north, drift west, heave, roll, pitch and yaw.
    frequency : ndarray of shape (6, sines), radians per second
    phase : ndarray of shape (6, sines), radians
    """

    sigma: Array
    frequency: Array
    phase: Array

    @classmethod
    def draw(cls, generator: np.random.Generator, sines: int = 3) -> "SeaMotion":
        """Draw the motion of a small vessel in a harbour."""
        sigma = np.array([0.03, 0.03, 0.05, *np.radians([0.9, 0.35, 0.3])])
        period = generator.uniform(4.0, 9.0, (6, sines))
        return cls(sigma, 2 * np.pi / period, generator.uniform(0, 2 * np.pi, (6, sines)))

    def at(self, time: Array) -> Array:
        """Motion at ``time`` (n,), seconds; shape (n, 6), metres and radians."""
        waves = np.sin(time[:, None, None] * self.frequency + self.phase)
        return np.asarray(self.sigma * waves.sum(axis=2) * np.sqrt(2 / self.phase.shape[1]))

    def rate(self, time: Array) -> Array:
        """Rate of the motion at ``time`` (n,), shape (n, 6), metres and radians per second."""
        waves = self.frequency * np.cos(time[:, None, None] * self.frequency + self.phase)
        return np.asarray(self.sigma * waves.sum(axis=2) * np.sqrt(2 / self.phase.shape[1]))


def error_free_survey(
    mounting: Mounting,
    targets: Sequence[Board | Ball],
    courses: Sequence[Course],
    spacing: float,
    generator: np.random.Generator,
    *,
    pos: PosErrorModel = HYDROGRAPHIC_INS,
    lidar_sigma: float = 0.003,
) -> Observations:
    """Simulate error-free observations.

    Parameters
    ----------
    mounting : Mounting
        The true mounting.
    spacing : float, metres
        Distance between the points of a target.
    pos : PosErrorModel
        Gives the standard deviations of the POS in the observations.
    lidar_sigma : float, metres
        Standard deviation on each axis in the observations.
    """
    sea = SeaMotion.draw(generator)
    rows, sightings = [], []
    for target in targets:
        for course in courses:
            points = target.points(
                spacing, generator, scanner_position_abeam(mounting, target, course)
            )
            rows.append(error_free_record(mounting, course, sea, points))
            sightings.append(Sighting(target.name, course.name))
    return observations_of_records(rows, sightings, targets, pos, lidar_sigma)


def error_free_record(mounting: Mounting, course: Course, sea: SeaMotion, points: Array) -> Array:
    """Error-free record of scanner and POS for points (n, 3), local, along a course.

    Returns
    -------
    ndarray of shape (n, 16)
        Point in the LiDAR frame, position, attitude, their rates (6), time.
    """
    # The profile is perpendicular to the course and contains a point that is abeam of the scanner.
    along = (points - [*course.abeam, 0.0]) @ course.direction - mounting.lever_arm[0]
    time = course.time + along / course.speed
    scan = to_lidar(points, _vessel_poses(course, sea, time + mounting.latency), mounting)
    poses = _vessel_poses(course, sea, time)
    rate = sea.rate(time)
    rate[:, :3] += course.speed * course.direction
    return np.column_stack([scan, poses.position, poses.attitude, rate, time])


def observations_of_records(
    rows: Sequence[Array],
    sightings: Sequence[Sighting],
    targets: Sequence[Board | Ball],
    pos: PosErrorModel,
    lidar_sigma: float,
) -> Observations:
    """Observations from records of `error_free_record`; arguments as in `error_free_survey`."""
    table = np.concatenate(rows)
    count, sighted = len(table), {sighting.target for sighting in sightings}
    return Observations(
        points_lidar=np.ascontiguousarray(table[:, :3]),
        position=np.ascontiguousarray(table[:, 3:6]),
        attitude=np.ascontiguousarray(table[:, 6:9]),
        pose_rate=np.ascontiguousarray(table[:, 9:15]),
        sigma_lidar=np.full((count, 3), lidar_sigma),
        sigma_position=np.tile(pos.sigma_position, (count, 1)),
        sigma_attitude=np.tile(pos.sigma_attitude, (count, 1)),
        time=table[:, 15].copy(),
        sighting=np.repeat(np.arange(len(sightings)), [len(part) for part in rows]),
        sightings=tuple(sightings),
        radii={
            target.name: target.radius if target.radius_known else None
            for target in targets
            if isinstance(target, Ball) and target.name in sighted
        },
    )


def scanner_position_abeam(mounting: Mounting, target: Board | Ball, course: Course) -> Array:
    """Scanner position with the target's centre abeam, on a calm sea, shape (3,), metres, local."""
    foot, centre = np.array([*course.abeam, 0.0]), np.array(target.centre)
    left = np.array([np.sin(course.heading), np.cos(course.heading), 0.0])
    _, lateral, above = mounting.lever_arm
    along = ((centre - foot) @ course.direction) * course.direction
    return np.asarray(foot + along + lateral * left + [0.0, 0.0, above])


def _vessel_poses(course: Course, sea: SeaMotion, time: Array) -> Poses:
    motion = sea.at(time)
    position = (time - course.time)[:, None] * course.speed * course.direction + motion[:, :3]
    position[:, :2] += course.abeam
    return Poses(position, motion[:, 3:] + [0.0, 0.0, course.heading])


def add_errors(
    exact: Observations, pos: PosErrorModel, generator: np.random.Generator
) -> Observations:
    """Add white LiDAR noise and time-correlated POS errors to a survey."""
    return replace(
        exact,
        points_lidar=exact.points_lidar + _lidar_noise(exact, generator),
        position=exact.position
        + exact.sigma_position * gauss_markov_drift(exact.time, pos.time_position, generator),
        attitude=exact.attitude
        + exact.sigma_attitude * gauss_markov_drift(exact.time, pos.time_attitude, generator),
    )


def _lidar_noise(exact: Observations, generator: np.random.Generator) -> Array:
    draws = generator.standard_normal(exact.points_lidar.shape)
    if not exact.beam_sigmas:
        return np.asarray(draws * exact.sigma_lidar)
    beam = exact.points_lidar / np.linalg.norm(exact.points_lidar, axis=1)[:, None]
    noise = draws * exact.sigma_lidar[:, 1:2]
    range_noise = generator.standard_normal((len(beam), 1)) * exact.sigma_lidar[:, :1]
    along = np.einsum("ni,ni->n", noise, beam)[:, None]
    return np.asarray(noise + (range_noise - along) * beam)


def gauss_markov_drift(
    time: Array, correlation_time: float, generator: np.random.Generator
) -> Array:
    """Three first-order Gauss-Markov processes of unit variance at any times, shape (n, 3).

    Parameters
    ----------
    time : ndarray of shape (n,), seconds, in any order
    correlation_time : float, seconds
    """
    order = np.argsort(time, kind="stable")
    draws = generator.standard_normal((len(time), 3))
    _filter_gauss_markov(np.diff(time[order]) / correlation_time, draws)
    drifting = np.empty_like(draws)
    drifting[order] = draws
    return drifting


@njit(nogil=True, cache=True)
def _filter_gauss_markov(steps, draws):  # type: ignore[no-untyped-def]
    for i in range(len(steps)):
        kept = np.exp(-steps[i])
        fresh = np.sqrt(-np.expm1(-2 * steps[i]))
        for k in range(draws.shape[1]):
            draws[i + 1, k] = kept * draws[i, k] + fresh * draws[i + 1, k]
