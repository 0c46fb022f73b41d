"""Whether points recovered from a georeferenced cloud lie where a profiler can measure.

A wrong height reference, time, lever arm or attitude moves the recovered points off the plane or
cone of the beams. Where they are off, each of these causes is tried, and the one that brings the
points back is named with its value.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from lispac.causes import Cause
from lispac.errors import LispacError
from lispac.messages import Action, Level, Message, Value
from lispac.survey.recovery import Recovery
from lispac.survey.scan_geometry import BeamCone, arc_of, fit_cone, fit_plane

Array = NDArray[np.float64]

MOST_POINTS = 4000
"""Points of the sample that a cause is tried with."""
FEWEST_POINTS = 200
"""Points below which nothing is said."""
MISFIT_ALLOWED = 0.005
"""Metres: smoothing of the trajectory, rounding and jitter of the times leave as much."""
MISFIT_ANGLE = 0.0005
"""Radians of beam direction, allowed besides."""
SMALLEST_ARC = 0.35
"""Radians: beams of a smaller arc do not tell a cone from a wrong recovery."""
PROFILER = 0.1
"""Misfit over range up to which a scanner may be a profiler though no cause brings it back."""
LARGEST_TURN = np.radians(2.0)
"""Between the scan plane and the axes of the scanner, which a profiler has along it."""
TURN_MISFIT = 0.01
"""Misfit over the extent of the points up to which the direction of the plane is certain."""
BETTER = 3.0
"""Factor by which a cause has to reduce the misfit to explain it."""
CLEARLY = 1.5
"""Factor between the misfits of the best cause and the next from which the best is named alone."""
HEIGHTS = np.arange(-120.0, 121.0, 2.0)
"""Metres: the geoid lies between 107 m below and 86 m above the ellipsoid."""
TIMES = (-37.0, -19.0, -18.0, -2.0, -1.0, -0.5, -0.2, -0.1, -0.05, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0,
         18.0, 19.0, 37.0)  # fmt: skip
"""Seconds: leap seconds between time bases, and what latencies come to."""
LEVERS = np.linspace(-3.0, 3.0, 25)
"""Metres: errors of a lever arm that are tried."""


@dataclass(frozen=True, eq=False)
class Sample:
    """Some points of a georeferenced line.

    Attributes
    ----------
    points_map : ndarray of shape (n, 3), in the unit and axes of the coordinate system
    time : ndarray of shape (n,), seconds, in the trajectory's time base
    """

    points_map: Array
    time: Array

    def thinned(self, most: int) -> "Sample":
        """At most ``most`` of the points, spread evenly."""
        step = max(1, -(-len(self.time) // most))
        return Sample(self.points_map[::step], self.time[::step])


@dataclass(frozen=True)
class Explanation:
    """A cause with the value that fits best.

    Attributes
    ----------
    cause : str
    value : float
        Metres or seconds to be added; 0 where the cause has none.
    misfit : float, metres
        That is left with it.
    """

    cause: str
    value: float
    misfit: float


def recovery_messages(name: str, sample: Sample, recovery: Recovery) -> tuple[Message, ...]:
    """Messages about a line whose recovered points do not lie where a profiler measures.

    Parameters
    ----------
    name : str
        Of the line.
    sample : Sample
        Points all over the line.
    recovery : Recovery
        As the line is recovered.
    """
    sample = sample.thinned(MOST_POINTS)
    if len(sample.time) < FEWEST_POINTS:
        return ()
    points = _recovered(sample, recovery)
    if points is None:
        return ()
    cone = fit_plane(points)
    distance = float(np.median(np.linalg.norm(points, axis=1)))
    allowed = MISFIT_ALLOWED + MISFIT_ANGLE * distance
    if cone.misfit <= allowed:
        turn = float(np.arccos(min(1.0, np.abs(cone.axis).max())))
        if turn < LARGEST_TURN or cone.misfit > TURN_MISFIT * arc_of(points) * distance:
            return ()
        return (
            Message(
                "recovery.boresight_used", Level.NOTE, {"line": name, "turn": turn},
                Cause.of_line(name),
            ),
        )  # fmt: skip
    if arc_of(points) > SMALLEST_ARC and fit_cone(points).misfit <= allowed:
        return ()  # a scanner with a conical mirror
    tried = sorted(_explanations(sample, recovery, points), key=lambda each: each.misfit)
    fitting = [
        each for each in tried
        if each.misfit <= min(cone.misfit / BETTER, max(allowed, CLEARLY * tried[0].misfit))
    ]  # fmt: skip
    if not fitting:
        if cone.misfit > PROFILER * distance:
            return ()  # a scanner of another kind
        return (_message(name, "recovery.unexplained", cone, None),)
    best = fitting[0]
    rivals = [each for each in fitting[1:] if each.misfit < CLEARLY * best.misfit]
    if rivals:
        causes = tuple(TITLES[each.cause] for each in (best, *rivals))
        return (_message(name, "recovery.several_causes", cone, best, {"causes": causes}),)
    return (_message(name, f"recovery.{best.cause}", cone, best),)


TITLES = {
    "height_offset": "heights", "time_offset": "time", "lever_arm_x": "lever arm X",
    "lever_arm_y": "lever arm Y", "lever_arm_z": "lever arm Z", "roll_sign": "sign of roll",
    "pitch_sign": "sign of pitch", "roll_pitch_signs": "signs of roll and pitch",
}  # fmt: skip


def _message(
    name: str, code: str, cone: BeamCone, best: Explanation | None,
    more: dict[str, Value] | None = None,
) -> Message:  # fmt: skip
    params: dict[str, Value] = {"line": name, "misfit": cone.misfit, **(more or {})}
    actions: tuple[Action, ...] = ()
    if best is not None:
        params |= {"value": best.value, "left": best.misfit}
    if best is not None and code == "recovery.height_offset":
        params["offset"] = -best.value
        value = f"{best.value:+.1f}"
        actions = (Action("set_option", {"name": "height", "value": value}),)
    return Message(code, Level.WARNING, params, Cause.of_line(name), actions)


def _explanations(sample: Sample, recovery: Recovery, points: Array) -> Iterator[Explanation]:
    """Each cause with its best value."""
    metre = recovery.system.metres[2]
    raised = replace(sample, points_map=sample.points_map + np.array([0.0, 0.0, 1.0 / metre]))
    up = _recovered(raised, recovery)
    if up is not None and len(up) == len(points):
        # A shift of the map moves recovered points in proportion.
        yield _best("height_offset", HEIGHTS, lambda value: points + value * (up - points))
    # An error of the lever arm moves all points of the LiDAR frame alike.
    for axis, title in enumerate("xyz"):
        along = recovery.mounting.rotation_body_lidar[axis]  # in the LiDAR frame
        yield _best(f"lever_arm_{title}", LEVERS, partial(_shifted, points, along))
    yield _best(
        "time_offset", np.array(TIMES),
        lambda value: _recovered(replace(sample, time=sample.time + value), recovery),
    )  # fmt: skip
    for cause, signs in (
        ("roll_sign", (-1, 1, 1)), ("pitch_sign", (1, -1, 1)), ("roll_pitch_signs", (-1, -1, 1)),
    ):  # fmt: skip
        trajectory = recovery.trajectory
        turned = replace(trajectory, attitude=trajectory.attitude * np.array(signs))
        other = replace(recovery, trajectory=turned)
        moved = _recovered(sample, other)
        if moved is not None:
            yield Explanation(cause, 0.0, fit_plane(moved).misfit)


def _shifted(points: Array, along: Array, value: float) -> Array:
    return points - value * along


def _best(cause: str, values: Array, moved: Callable[[float], Array | None]) -> Explanation:
    """The value with the smallest misfit, refined about the best of some."""

    def misfit(value: float) -> float:
        points = moved(value)
        return np.inf if points is None else fit_plane(points).misfit

    found = np.array([misfit(float(value)) for value in values])
    k = int(found.argmin())
    low = float(values[max(0, k - 1)])
    high = float(values[min(len(values) - 1, k + 1)])
    value, least = float(values[k]), float(found[k])
    for _ in range(REFINEMENTS):
        third = (high - low) / 3
        left, right = misfit(low + third), misfit(high - third)
        low, high = (low, high - third) if left < right else (low + third, high)
        nearest = low + third if left < right else high - third
        if min(left, right) < least:
            value, least = nearest, min(left, right)
    return Explanation(cause, value, least)


REFINEMENTS = 16
"""Steps of the refinement, each of which narrows the interval to two thirds."""


def _recovered(sample: Sample, recovery: Recovery) -> Array | None:
    """Points with a pose in the LiDAR frame, shape (n, 3), metres; None where there are few."""
    usable = recovery.usable(sample.time)
    if np.count_nonzero(usable) < FEWEST_POINTS:
        return None
    try:
        points = recovery.mapping.to_scanner(
            sample.points_map[usable], sample.time[usable], threads=1, strict=False
        )
    except LispacError:
        return None
    ranges = np.linalg.norm(points, axis=1)
    return np.asarray(points[np.isfinite(ranges) & (ranges > 0)])
