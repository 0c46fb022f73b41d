"""Predicted sigmas of a survey, computed with the equations of the adjustment.

The sigmas of a least-squares adjustment depend on the positions of the points, not on their errors,
so that no errors are simulated. On each target, a few points with larger weights represent all
points that the scanner would measure. The equations of the adjustment
(`lispac.adjustment.solve.adjustment_problem`) are linearised once, at the true values.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.lever_arm_uncertainty import effect_of_omitted
from lispac.adjustment.model.control import Control
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.result import ANGLES
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.determinability import MAX_ANGLE_SIGMA
from lispac.adjustment.solve.normal_equations import scaled_inverse
from lispac.design.plan import Plan, System
from lispac.errors import RankDeficient
from lispac.messages import error
from lispac.simulation.closed_form_survey import (
    MIN_INCIDENCE_COSINE,
    Ball,
    Board,
    Course,
    scanner_position_abeam,
)
from lispac.survey.georeferencing import LEVER_ARM_NAMES, to_lidar
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]

GRID_POINTS_PER_SIDE = 4
"""Number of representative points along each side of a board; twice as many for a ball.

Their second moments equal those of the board. With more points, no sigma changes by as much as 1 %.
"""

MIN_FLATNESS = 1e-6
"""Flatness used for a target specified as perfectly flat, metres."""

MIN_SIGHTING_POINTS = 20
"""Smallest number of points of a sighting."""

UNDETERMINED_MESSAGE = error("design.undetermined")
NO_SIGHTINGS_MESSAGE = error("design.no_sightings")


@dataclass(frozen=True, eq=False)
class Prediction:
    """Predicted precision of a plan.

    Attributes
    ----------
    information : ndarray of shape (3, 3), per square radian
        Normal matrix of roll, pitch and yaw, with all other unknowns eliminated and the sigmas of
        the lever arm included.
    points : dict of (target, line) to float
        Expected number of points of each sighting, without sightings that are too oblique or have
        too few points.
    """

    information: Array
    points: dict[tuple[str, str], float]

    @property
    def determined(self) -> bool:
        """Whether every combination of the angles has a sigma of at most `MAX_ANGLE_SIGMA`."""
        return bool(np.linalg.eigvalsh(self.information)[0] >= MAX_ANGLE_SIGMA**-2)

    @property
    def covariance(self) -> Array:
        """Covariance of roll, pitch and yaw, (3, 3), square radians; infinite if undetermined."""
        if not self.determined:
            return np.full((3, 3), np.inf)
        return np.asarray(np.linalg.inv(self.information))

    @property
    def sigma(self) -> Array:
        """Standard deviations of roll, pitch, yaw, shape (3,), radians."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    @property
    def correlation(self) -> Array:
        """Correlations of roll, pitch, yaw, shape (3, 3); NaN where undetermined."""
        if not self.determined:
            return np.full((3, 3), np.nan)
        return np.asarray(self.covariance / np.outer(self.sigma, self.sigma))


def predict(plan: Plan) -> Prediction:
    """Predict the sigmas of roll, pitch and yaw of a survey."""
    found = _PlanSightings.of(plan)
    if not found.sightings:
        return Prediction(np.zeros((3, 3)), {})
    with single_blas_thread():
        try:
            information = found.information()
        except (RankDeficient, np.linalg.LinAlgError):
            information = np.zeros((3, 3))
    return Prediction(information, found.points)


def predicted_equations(plan: Plan) -> LinearisedProblem:
    """Predicted normal equations of the adjustment of a survey.

    Raises
    ------
    RankDeficient
        No target is visible on any line.
    """
    found = _PlanSightings.of(plan)
    if not found.sightings:
        raise RankDeficient(NO_SIGHTINGS_MESSAGE)
    with single_blas_thread():
        return found.linearised()


@dataclass(frozen=True, eq=False)
class _PlanSightings:
    """Sightings of a plan: representative points and the number of points each represents."""

    plan: Plan
    sightings: list[Sighting]
    points: dict[tuple[str, str], float]
    places: list[Array]
    on_course: list[Course]

    @classmethod
    def of(cls, plan: Plan) -> "_PlanSightings":
        found = cls(plan, [], {}, [], [])
        courses = plan.courses
        for target in plan.targets:
            places = target.grid(GRID_POINTS_PER_SIDE) if isinstance(target, Board) else None
            for course in courses:
                scanner = scanner_position_abeam(plan.system.mounting, target, course)
                count = expected_point_count(plan.system, target, course, scanner)
                if count < MIN_SIGHTING_POINTS:
                    continue
                sighting = Sighting(target.name, course.name)
                found.sightings.append(sighting)
                found.points[target.name, course.name] = count
                if isinstance(target, Ball):
                    places = target.grid(2 * GRID_POINTS_PER_SIDE, scanner)
                assert places is not None
                found.places.append(places)
                found.on_course.append(course)
        return found

    def observations(self) -> Observations:
        """Observations of the representative points from a level vessel."""
        system, counts = self.plan.system, [len(place) for place in self.places]
        places = np.concatenate(self.places)
        direction, heading, at_abeam, time, speed = (
            np.repeat(np.array(values), counts, axis=0)
            for values in zip(
                *(
                    (c.direction, c.heading, (*c.abeam, 0.0), c.time, c.speed)
                    for c in self.on_course
                ),
                strict=True,
            )
        )
        # Profiles are at right angles to the course: a point is measured when the scanner is abeam.
        along = np.einsum("ni,ni->n", places - at_abeam, direction)
        along -= system.mounting.lever_arm[0]
        position = at_abeam + along[:, None] * direction
        attitude = np.stack([np.zeros_like(heading), np.zeros_like(heading), heading], axis=1)
        scan = to_lidar(places, Poses(position, attitude), system.mounting)
        ranges, scanner, count = np.linalg.norm(scan, axis=1), system.scanner, len(scan)
        across = scanner.angle_sigma * ranges
        balls = {t.name: t for t in self.plan.targets if isinstance(t, Ball)}
        names = {sighting.target for sighting in self.sightings}
        return Observations(
            points_lidar=scan,
            position=position,
            attitude=attitude,
            pose_rate=np.hstack([speed[:, None] * direction, np.zeros((count, 3))]),
            sigma_lidar=np.stack([np.full(count, scanner.range_sigma), across, across], axis=1),
            sigma_position=np.tile(system.pos.sigma_position, (count, 1)),
            sigma_attitude=np.tile(system.pos.sigma_attitude, (count, 1)),
            time=time + along / speed,
            sighting=np.repeat(np.arange(len(counts)), counts),
            sightings=tuple(self.sightings),
            beam_sigmas=True,
            radii={
                name: ball.radius if ball.radius_known else None
                for name, ball in balls.items()
                if name in names
            },
            control=planned_control([t for t in self.plan.targets if t.name in names]),
        )

    def information(self) -> Array:
        """Normal matrix of roll, pitch and yaw, shape (3, 3), per square radian.

        The sigmas of the lever arm decrease it.
        """
        exact = self.linearised()
        information = exact.normal.information(3)
        sigma = self.plan.system.lever_arm_sigma
        if not any(sigma) or np.linalg.eigvalsh(information)[0] < MAX_ANGLE_SIGMA**-2:
            return information
        every = self.linearised(tuple(Parameter(name) for name in LEVER_ARM_NAMES))
        moves = effect_of_omitted(every, exact.problem.active, ANGLES) * sigma
        return scaled_inverse(scaled_inverse(information) + moves @ moves.T)

    def linearised(self, parameters: tuple[Parameter, ...] = ()) -> LinearisedProblem:
        """Equations at the truth, each point weighted by the number of points it represents."""
        plan, observations = self.plan, self.observations()
        pos = plan.system.pos
        own_flatness = any(target.flatness is not None for target in plan.targets)
        flatness = max(plan.flatness, MIN_FLATNESS) if own_flatness else plan.flatness
        model = StochasticModel(
            plan.system.pos_errors, pos.time_position, pos.time_attitude, surface=flatness
        )
        targets = {target.name: target for target in plan.targets}
        shapes = np.stack([_target_shape_vector(targets[name]) for name in observations.targets])
        problem = AdjustmentProblem.of(observations, plan.system.mounting, model, parameters)
        for name, target in targets.items():
            own = [k for k, s in enumerate(self.sightings) if s.target == name]
            if own and target.flatness is not None:
                flatness = max(target.flatness, MIN_FLATNESS)
                problem = problem.with_sighting_surface_sigma(own, flatness)
        linearised = problem.linearised(problem.start(plan.system.mounting, shapes))
        represented = np.array(list(self.points.values())) / observations.counts
        weights = represented[problem.groups.sighting]
        return replace(linearised, sums=linearised.sums * weights[:, None, None])


def planned_control(
    targets: Sequence[Board | Ball], generator: np.random.Generator | None = None
) -> Control | None:
    """Surveyed points of some targets; None if none is surveyed.

    Parameters
    ----------
    generator : numpy.random.Generator, optional
        Source of the errors of the points; without it, they have none.
    """
    surveyed = [(t, t.control_sigma) for t in targets if t.control_sigma is not None]
    if not surveyed:
        return None
    points = [target.control_points for target, _ in surveyed]
    counts = [len(each) for each in points]
    positions = np.concatenate(points)
    sigmas = np.repeat([sigma for _, sigma in surveyed], counts)
    if generator is not None:
        positions += sigmas[:, None] * generator.standard_normal(positions.shape)
    owners = [target for (target, _), count in zip(surveyed, counts, strict=True)
              for target in [target] * count]  # fmt: skip
    return Control.of(
        [f"{target.name} {k}" for k, target in enumerate(owners, start=1)],
        [target.name for target in owners],
        positions,
        sigmas[:, None, None] ** 2 * np.eye(3),
        is_centre=np.array([isinstance(target, Ball) for target in owners]),
    )


def _target_shape_vector(target: Board | Ball) -> Array:
    """Plane (normal, offset) or sphere (centre, radius) as in the adjustment, shape (4,)."""
    if isinstance(target, Ball):
        return np.array([*target.centre, target.radius])
    return np.array([*target.facing, -target.facing @ np.array(target.centre)])


def expected_point_count(
    system: System, target: Board | Ball, course: Course, scanner_place: Array
) -> float:
    """Expected number of points of a profiler on a target in one line; 0 if it is not visible.

    The projected area of the target, ``A cos(i)`` with the angle of incidence ``i``, is divided by
    the area per point, ``(v dt) (r da)``. Here ``v`` is the speed of the vessel, ``r`` the range,
    ``dt = 1 / profiles`` the time between profiles, and ``da = 2 pi profiles / pulses`` the angle
    between pulses, with the numbers of profiles and pulses per second.

    Parameters
    ----------
    scanner_place : ndarray of shape (3,), metres, local
        From `lispac.simulation.closed_form_survey.scanner_position_abeam`.
    """
    ray = np.array(target.centre) - scanner_place
    distance = float(np.linalg.norm(ray))
    if distance > system.scanner.max_range:
        return 0.0
    if isinstance(target, Ball):
        area = np.pi * target.visible_radius**2
    else:
        facing = -float(ray @ target.facing) / distance
        if facing < MIN_INCIDENCE_COSINE:
            return 0.0
        area = target.width * target.height * facing
    step = 2 * np.pi * system.scanner.turns_per_second / system.scanner.pulses_per_second
    return area * system.scanner.turns_per_second / (course.speed * step * distance)
