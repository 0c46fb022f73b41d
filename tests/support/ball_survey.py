"""Simulated small survey of balls, a leaning board and a wall, written to files."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import rotation_matrix
from lispac.io.las.las_format import write_points
from lispac.io.trajectory.sbet import write_sbet
from lispac.project import LineSource, Project, Settings
from lispac.simulation.closed_form_survey import Course, SeaMotion, six_courses
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Trajectory
from lispac.workflow.project.projects import create_project
from lispac.workflow.project.survey import Survey, load_survey

FRAME = LocalFrame(np.radians(46.8), np.radians(-71.2), 0.0)
BORESIGHT_DEG = (0.3, -0.8, 0.4)
LEVER_ARM = (-0.2, 0.05, 2.2)
BALLS = {
    "S1": (np.array([0.0, 14.0, 6.0]), 0.15),
    "S2": (np.array([1.4, 12.5, 4.0]), 0.15),
    "S3": (np.array([-1.6, 13.5, 8.0]), 0.2),
}
BOARD = (np.array([1.6, 15.0, 8.0]), np.array([0.0, -np.sqrt(0.5), np.sqrt(0.5)]), 0.6)
WALL = 16.0  # metres to the west of the courses
NOISE = 0.002  # metres, along the beam
NAMES = [*BALLS, "board", "wall"]
MIDDLE = np.array([0.0, 14.0, 6.0])  # of the site
# profiles a second, and seconds before and after the middle is abeam
PROFILES, HALF_DURATION = 40.0, 4.0


@dataclass(frozen=True, eq=False)
class BallSurvey:
    """A project without targets, its survey, and the object that each point of a line is on."""

    project: Project
    survey: Survey
    labels: dict[str, np.ndarray]

    def seed(self, name: str, line: str = "L1") -> tuple[float, float, float]:
        """A point in the middle of the points of an object on a line."""
        on = self.survey.clouds[line][self.labels[line] == NAMES.index(name)]
        north, west, up = on[np.argmin(np.linalg.norm(on - on.mean(axis=0), axis=1))]
        return float(north), float(west), float(up)


def make_ball_survey(folder: Path) -> BallSurvey:
    """Six lines past three balls, a board and a wall, without POS errors."""
    rng = np.random.default_rng(5)
    sea, mounting = SeaMotion.draw(rng), Mounting(np.array(LEVER_ARM), np.radians(BORESIGHT_DEG))
    states, lines, labels = [], [], {}
    for course in sorted(six_courses(), key=_abeam):
        time = _abeam(course) + np.arange(-HALF_DURATION - 0.5, HALF_DURATION + 0.5, 0.005)
        states.append(np.column_stack([time, *_sail(course, sea, time)]))
        points, times, labels[course.name] = _profiles(states[-1], course, mounting, rng)
        lines.append(LineSource(course.name, folder / "raw" / f"{course.name}.laz"))
        write_points(lines[-1].path, points, times, np.full(len(times), 1000.0))
    table = np.concatenate(states)
    latitude, longitude, height = FRAME.to_geodetic(table[:, 1:4])
    sbet = folder / "raw" / "trajectory.sbet"
    write_sbet(sbet, Trajectory(table[:, 0], latitude, longitude, height, table[:, 4:]))
    settings = Settings(
        lever_arm=LEVER_ARM,
        origin_deg_m=(np.degrees(FRAME.latitude), np.degrees(FRAME.longitude), 0.0),
        lidar_sigma=NOISE,
        position_sigma=(0.002, 0.002, 0.002),
        attitude_sigma_deg=(0.002, 0.002, 0.002),
    )
    project = create_project(folder / "balls", trajectory=sbet, lines=lines, settings=settings)
    return BallSurvey(project, load_survey(project), labels)


def _abeam(course: Course) -> float:
    return float(course.time + MIDDLE @ course.direction / course.speed)


def _sail(course: Course, sea: SeaMotion, time: np.ndarray) -> tuple[np.ndarray, ...]:
    motion = sea.at(time)
    along = (time - course.time)[:, None] * course.speed * course.direction
    attitude = motion[:, 3:] + [0.0, 0.0, course.heading]
    return tuple(np.hstack([along + motion[:, :3], attitude]).T)


def _profiles(states, course, mounting, rng):
    """LiDAR points, times and labels of a line."""
    time = _abeam(course) + np.arange(-HALF_DURATION, HALF_DURATION, 1.0 / PROFILES)
    pose = np.stack([np.interp(time, states[:, 0], column) for column in states[:, 1:].T], axis=1)
    up = np.radians(np.arange(4.0, 36.0, 0.08))
    angle = np.concatenate([up, np.pi - up])
    beams = np.stack([np.zeros_like(angle), np.cos(angle), np.sin(angle)], axis=1)
    rotation = rotation_matrix(*pose[:, 3:].T)
    scanner = pose[:, :3] + rotation @ mounting.lever_arm
    rays = np.einsum("nij,mj->nmi", rotation @ mounting.rotation_body_lidar, beams)
    reach, label = _first_hit(scanner[:, None, :], rays)
    is_hit = np.isfinite(reach)
    noisy = reach[is_hit] + rng.normal(0.0, NOISE, np.count_nonzero(is_hit))
    points = noisy[:, None] * np.broadcast_to(beams, (*reach.shape, 3))[is_hit]
    return points, np.broadcast_to(time[:, None], reach.shape)[is_hit], label[is_hit]


def _first_hit(origin, rays):
    ranges = []
    for centre, radius in BALLS.values():
        to = centre - origin
        along = (rays * to).sum(axis=-1)
        discriminant = radius**2 - ((to**2).sum(axis=-1) - along**2)
        hit = (discriminant >= 0.0) & (along > 0.0)
        ranges.append(np.where(hit, along - np.sqrt(np.maximum(discriminant, 0.0)), np.inf))
    centre, normal, half = BOARD
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = ((centre - origin) @ normal) / (rays @ normal)
        beside = origin + reach[..., None] * rays - centre
        across = np.cross(normal, [1.0, 0.0, 0.0])
        on = (np.abs(beside[..., 0]) <= half) & (np.abs(beside @ across) <= half) & (reach > 0.0)
        ranges.append(np.where(on, reach, np.inf))
        reach = (WALL - origin[..., 1]) / rays[..., 1]
        beside = origin + reach[..., None] * rays
        on = (reach > 0.0) & (np.abs(beside[..., 0]) < 3.0) & (beside[..., 2] < 10.0)
        ranges.append(np.where(on, reach, np.inf))
    return np.min(ranges, axis=0), np.argmin(ranges, axis=0)
