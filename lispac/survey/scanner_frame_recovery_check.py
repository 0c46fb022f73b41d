"""Check whether points converted back to the scanner frame lie on its scan surfaces.

These are a plane or a cone for a profiler, and one cone per laser for a spinning scanner. A wrong
height reference, time, lever arm or attitude displaces the recovered points from these surfaces.
Each of these causes is then tested, and the one that explains the displacement is reported with its
value.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import LispacError
from lispac.messages import Action, Level, Message, Value, note
from lispac.survey.beam_geometry import (
    BeamCone,
    beam_direction_spread,
    fit_cone,
    fit_cones,
    fit_plane,
)
from lispac.survey.scanner_frame_recovery import RecoverySetup
from lispac.warning_causes import Cause

Array = NDArray[np.float64]

MAX_TESTED_POINTS = 4000
"""Largest number of points with which a cause is tested."""
MIN_TESTED_POINTS = 200
"""Smallest number of points for a result."""
MAX_RESIDUAL_M = 0.005
"""Largest residual due to trajectory smoothing, rounding and jitter of the times."""
MAX_ANGULAR_RESIDUAL_RAD = 0.0005
"""Additional tolerance of the beam direction."""
MIN_BEAM_SPREAD_RAD = 0.35
"""Smallest `beam_direction_spread` that distinguishes a cone from a wrong recovery."""
MAX_PROFILER_RESIDUAL_RATIO = 0.1
"""Largest ratio of residual to range for a possible profiler if no cause explains the residual."""
MAX_PLANE_TURN_RAD = np.radians(2.0)
"""Largest angle between the normal of the scan plane and the nearest axis of the scanner."""
MAX_PLANE_RESIDUAL_RATIO = 0.01
"""Largest ratio of the residual to the extent of the points for a reliable scan plane."""
MIN_RESIDUAL_REDUCTION = 3.0
"""Smallest factor by which a cause has to reduce the residual."""
UNAMBIGUOUS_RESIDUAL_RATIO = 1.5
"""Smallest ratio of the residuals of the second and the best cause to report the best one only."""
TESTED_HEIGHT_OFFSETS_M = np.arange(-120.0, 121.0, 2.0)
"""Height offsets to be tested; the geoid is 107 m below to 86 m above the ellipsoid."""
TESTED_TIME_OFFSETS_S = (
    -37.0, -19.0, -18.0, -2.0, -1.0, -0.5, -0.2, -0.1, -0.05,
    0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 18.0, 19.0, 37.0,
)  # fmt: skip
"""Time offsets to be tested: leap seconds between time bases, and possible latencies."""
TESTED_LEVER_ARM_ERRORS_M = np.linspace(-3.0, 3.0, 25)
"""Errors of the lever arm to be tested."""
RING_ATTRIBUTES = ("ring", "ring_number", "laser_id", "laser_number", "laser", "beam_id", "channel")
"""Attributes that number the lasers of a spinning scanner."""
MAX_RINGS = 256
"""Largest number of values of an attribute that is assumed to number lasers."""


@dataclass(frozen=True, eq=False)
class LineSample:
    """Sample of the points of a georeferenced line.

    Attributes
    ----------
    points_map : ndarray of shape (n, 3), in the unit and axes of the coordinate system
    time : ndarray of shape (n,), seconds, in the trajectory's time base
    ring : ndarray of shape (n,), int, or None
        Number of the laser of a spinning scanner, if the file contains it.
    """

    points_map: Array
    time: Array
    ring: NDArray[np.int64] | None = None

    @classmethod
    def joined(cls, parts: Sequence["LineSample"]) -> "LineSample":
        """One sample of several parts of a line; their lasers numbered from 0."""
        points = np.concatenate([each.points_map for each in parts])
        time = np.concatenate([each.time for each in parts])
        rings = [each.ring for each in parts if each.ring is not None]
        if len(rings) < len(parts):
            return cls(points, time)
        values, ring = np.unique(np.concatenate(rings), return_inverse=True)
        if not 1 < len(values) <= MAX_RINGS:
            return cls(points, time)
        return cls(points, time, ring.astype(np.int64))

    def where(self, chosen: NDArray[np.bool_] | slice) -> "LineSample":
        """Some of the points.

        Parameters
        ----------
        chosen : ndarray of shape (n,), bool, or slice
        """
        ring = None if self.ring is None else self.ring[chosen]
        return LineSample(self.points_map[chosen], self.time[chosen], ring)

    def thinned(self, limit: int) -> "LineSample":
        """At most ``limit`` of the points, spread evenly."""
        return self.where(slice(None, None, max(1, -(-len(self.time) // limit))))


def ring_numbers(attributes: Mapping[str, NDArray[Any]]) -> NDArray[np.int64] | None:
    """Number of the laser of each point, shape (n,); None if no attribute contains it."""
    for name in RING_ATTRIBUTES:
        if name in attributes and np.issubdtype(attributes[name].dtype, np.integer):
            return np.asarray(attributes[name], dtype=np.int64)
    return None


@dataclass(frozen=True)
class ResidualCause:
    """A cause with the value that fits best.

    Attributes
    ----------
    cause : str
    value : float
        Correction to be added, metres or seconds; 0 if the cause has no value.
    residual : float, metres
        Residual after this correction.
    """

    cause: str
    value: float
    residual: float


def recovery_messages(
    name: str, sample: LineSample, recovery: RecoverySetup
) -> tuple[Message, ...]:
    """Messages about a line whose recovered points are not on scan surfaces of its scanner.

    There is also a message if they are, but the scan plane is not normal to an axis of the scanner.

    Parameters
    ----------
    name : str
        Name of the line.
    sample : LineSample
        Points from the whole line.
    recovery : RecoverySetup
        Setup with which the line is recovered.
    """
    sample = sample.thinned(MAX_TESTED_POINTS)
    if len(sample.time) < MIN_TESTED_POINTS:
        return ()
    recovered = _recover_sample(sample, recovery)
    if recovered is None:
        return ()
    points = recovered.points
    shapes = tuple(_possible_beam_shapes(recovered))
    fitted = [shape(recovered) for shape in shapes]
    distance = float(np.median(np.linalg.norm(points, axis=1)))
    allowed = MAX_RESIDUAL_M + MAX_ANGULAR_RESIDUAL_RAD * distance
    first = fitted[0]
    if recovered.ring is None and first.residual <= allowed:
        turn = float(np.arccos(min(1.0, np.abs(first.axis).max())))
        if (
            turn < MAX_PLANE_TURN_RAD
            or first.residual > MAX_PLANE_RESIDUAL_RATIO * beam_direction_spread(points) * distance
        ):
            return ()
        return (
            Message(
                "recovery.boresight_used", Level.NOTE, {"line": name, "turn": turn},
                Cause.of_line(name),
            ),
        )  # fmt: skip
    if any(each.residual <= allowed for each in fitted):
        return ()
    explanations_by_shape = [
        sorted(_evaluate_causes(sample, recovery, recovered, shape), key=lambda each: each.residual)
        for shape in shapes
    ]
    for cone, explanations in zip(fitted, explanations_by_shape, strict=True):
        if fitting := _sufficient_explanations(cone, explanations, allowed):
            return (_causes_message(name, cone if np.isfinite(cone.residual) else first, fitting),)
    # A larger residual may be due to two errors or a rough trajectory, up to a limit.
    if len(shapes) == 1 or first.residual <= MAX_PROFILER_RESIDUAL_RATIO * distance:
        limit = max(allowed, UNAMBIGUOUS_RESIDUAL_RATIO * explanations_by_shape[0][0].residual)
        if fitting := _sufficient_explanations(first, explanations_by_shape[0], limit):
            return (_causes_message(name, first, fitting),)
    if recovered.ring is None and first.residual > MAX_PROFILER_RESIDUAL_RATIO * distance:
        return ()  # a scanner of another kind
    return (_residual_warning(name, "recovery.unexplained", first, None),)


def _sufficient_explanations(
    cone: BeamCone, tried: list[ResidualCause], limit: float
) -> list[ResidualCause]:
    """Explanations that reduce the residual enough, and to at most ``limit``."""
    return [
        each
        for each in tried
        if each.residual <= min(cone.residual / MIN_RESIDUAL_REDUCTION, limit)
    ]


def _causes_message(name: str, cone: BeamCone, fitting: list[ResidualCause]) -> Message:
    """Message with the causes that explain the residual, the best first."""
    best = fitting[0]
    rivals = [
        each for each in fitting[1:] if each.residual < UNAMBIGUOUS_RESIDUAL_RATIO * best.residual
    ]
    if rivals:
        causes = tuple(CAUSE_NAMES[each.cause] for each in (best, *rivals))
        return _residual_warning(name, "recovery.several_causes", cone, best, {"causes": causes})
    return _residual_warning(name, f"recovery.{best.cause}", cone, best)


@dataclass(frozen=True, eq=False)
class _RecoveredPoints:
    """Points of a sample in the LiDAR frame.

    Attributes
    ----------
    points : ndarray of shape (n, 3), metres
    ring : ndarray of shape (n,), int, or None
    """

    points: Array
    ring: NDArray[np.int64] | None


BeamFit = Callable[[_RecoveredPoints], BeamCone]
"""Function that fits a scan surface to recovered points."""


def _fit_beam_plane(points: _RecoveredPoints) -> BeamCone:
    return fit_plane(points.points)


def _fit_beam_cone(points: _RecoveredPoints) -> BeamCone:
    """Fit a cone; its residual is infinite if the beams spread too little to determine it."""
    cone = fit_cone(points.points)
    return (
        cone
        if beam_direction_spread(points.points) > MIN_BEAM_SPREAD_RAD
        else replace(cone, residual=np.inf)
    )


def _fit_beam_cones(points: _RecoveredPoints) -> BeamCone:
    assert points.ring is not None
    return fit_cones(points.points, points.ring)


def _possible_beam_shapes(points: _RecoveredPoints) -> Iterator[BeamFit]:
    """Functions that fit the scan surfaces that the beams can have."""
    if points.ring is not None:
        yield _fit_beam_cones
        return
    yield _fit_beam_plane
    yield _fit_beam_cone


CAUSE_NAMES = {
    "height_offset": note("suspect.heights"),
    "time_offset": note("suspect.time"),
    "lever_arm_x": note("quantity.lever_x"),
    "lever_arm_y": note("quantity.lever_y"),
    "lever_arm_z": note("quantity.lever_z"),
    "roll_sign": note("suspect.roll_sign"),
    "pitch_sign": note("suspect.pitch_sign"),
    "roll_pitch_signs": note("suspect.attitude_signs"),
}
"""Names of the causes, as parts of messages."""


def _residual_warning(
    name: str, code: str, cone: BeamCone, best: ResidualCause | None,
    extra: dict[str, Value] | None = None,
) -> Message:  # fmt: skip
    params: dict[str, Value] = {"line": name, "misfit": cone.residual, **(extra or {})}
    actions: tuple[Action, ...] = ()
    if best is not None:
        params |= {"value": best.value, "left": best.residual}
    if best is not None and code == "recovery.height_offset":
        params["offset"] = -best.value
        value = f"{best.value:+.1f}"
        actions = (Action("set_option", {"name": "height", "value": value}),)
    return Message(code, Level.WARNING, params, Cause.of_line(name), actions)


def _evaluate_causes(
    sample: LineSample, recovery: RecoverySetup, recovered: _RecoveredPoints, shape: BeamFit
) -> Iterator[ResidualCause]:
    """Evaluate each cause with its best value."""
    points = recovered.points
    metre = recovery.system.metres[2]
    raised = replace(sample, points_map=sample.points_map + np.array([0.0, 0.0, 1.0 / metre]))
    up = _recover_sample(raised, recovery)
    if up is not None and len(up.points) == len(points):
        # A shift of the map moves recovered points in proportion.
        per_metre = up.points - points
        yield _best_explanation(
            "height_offset", TESTED_HEIGHT_OFFSETS_M,
            lambda value: replace(recovered, points=points + value * per_metre), shape,
        )  # fmt: skip
    # An error of the lever arm moves all points of the LiDAR frame alike.
    for axis, title in enumerate("xyz"):
        along = recovery.mounting.rotation_body_lidar[axis]  # in the LiDAR frame
        yield _best_explanation(
            f"lever_arm_{title}",
            TESTED_LEVER_ARM_ERRORS_M,
            partial(_shift_points, recovered, along),
            shape,
        )
    yield _best_explanation(
        "time_offset", np.array(TESTED_TIME_OFFSETS_S),
        lambda value: _recover_sample(replace(sample, time=sample.time + value), recovery), shape,
    )  # fmt: skip
    for cause, signs in (
        ("roll_sign", (-1, 1, 1)), ("pitch_sign", (1, -1, 1)), ("roll_pitch_signs", (-1, -1, 1)),
    ):  # fmt: skip
        trajectory = recovery.trajectory
        turned = replace(trajectory, attitude=trajectory.attitude * np.array(signs))
        other = replace(recovery, trajectory=turned)
        moved = _recover_sample(sample, other)
        if moved is not None:
            yield ResidualCause(cause, 0.0, shape(moved).residual)


def _shift_points(points: _RecoveredPoints, along: Array, value: float) -> _RecoveredPoints:
    return replace(points, points=points.points - value * along)


def _best_explanation(
    cause: str,
    values: Array,
    points_with_value: Callable[[float], _RecoveredPoints | None],
    shape: BeamFit,
) -> ResidualCause:
    """Value of a cause with the smallest residual, refined around the best of given values."""

    def residual(value: float) -> float:
        found = points_with_value(value)
        return np.inf if found is None else shape(found).residual

    found = np.array([residual(float(value)) for value in values])
    k = int(found.argmin())
    low = float(values[max(0, k - 1)])
    high = float(values[min(len(values) - 1, k + 1)])
    value, smallest = float(values[k]), float(found[k])
    for _ in range(REFINEMENT_STEPS):
        third = (high - low) / 3
        left, right = residual(low + third), residual(high - third)
        low, high = (low, high - third) if left < right else (low + third, high)
        nearest = low + third if left < right else high - third
        if min(left, right) < smallest:
            value, smallest = nearest, min(left, right)
    return ResidualCause(cause, value, smallest)


REFINEMENT_STEPS = 16
"""Steps of the refinement, each of which narrows the interval to two thirds."""


def _recover_sample(sample: LineSample, recovery: RecoverySetup) -> _RecoveredPoints | None:
    """Points with a pose in the LiDAR frame; None if there are too few."""
    usable = recovery.has_pose(sample.time)
    if np.count_nonzero(usable) < MIN_TESTED_POINTS:
        return None
    sample = sample.where(usable)
    try:
        points = recovery.mapping.to_scanner(
            sample.points_map, sample.time, threads=1, strict=False
        )
    except LispacError:
        return None
    ranges = np.linalg.norm(points, axis=1)
    kept = np.isfinite(ranges) & (ranges > 0)
    return _RecoveredPoints(points[kept], None if sample.ring is None else sample.ring[kept])
