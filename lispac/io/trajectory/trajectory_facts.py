"""Facts on a trajectory for the preview, and warnings about contradictions in its motion."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.frames import ECCENTRICITY_SQUARED, SEMI_MAJOR_AXIS
from lispac.io.format_types import Fact
from lispac.messages import Action, Level, Message, note, warning
from lispac.survey.known_time_base import base_message
from lispac.survey.line_source import printable
from lispac.survey.time_base import base_of_key, plausible_bases
from lispac.survey.time_quality import assess_times
from lispac.survey.trajectory import DEFAULT_LONGEST_GAP_S

Array = NDArray[np.float64]

MIN_TIME_STEP_S = 1e-6
"""Smallest plausible time step, seconds; shorter steps indicate meaningless times."""
MIN_SPEED_FOR_COURSE = 0.3
"""Smallest speed for a meaningful course over ground, metres per second."""

MAX_CARRIER_SPEED = 350.0
"""Largest speed of any carrier of a survey, metres per second."""

MAX_VESSEL_SPEED = 60.0
"""Largest plausible speed of a vessel, metres per second; beyond it a wrong unit is more likely."""

MAX_VELOCITIES = 10_000
"""Largest number of states of a block used for velocities; of more states, every n-th."""

SWAP_COORDINATES_ACTION = Action(
    "swap_coordinates", {"name": "order", "value": "longitude-latitude"}
)
CHOOSE_TIME_BASE_ACTION = Action("choose_time_base", {"name": "time"})


@dataclass(frozen=True, eq=False)
class TrajectoryMotion:
    """Velocities from positions.

    Attributes
    ----------
    index : ndarray of shape (n,)
        Index in the block of the state in the middle of each difference.
    north, east, up : ndarray of shape (n,), metres a second
    """

    index: NDArray[np.int64]
    north: Array
    east: Array
    up: Array

    @property
    def speed(self) -> Array:
        """Horizontal speed, shape (n,), metres a second."""
        return np.hypot(self.north, self.east)

    @property
    def course(self) -> Array:
        """Course over ground, shape (n,), radians clockwise from true north."""
        return np.arctan2(self.east, self.north)


def motion_of(time: Array, latitude: Array, longitude: Array, height: Array) -> TrajectoryMotion:
    """Velocities from positions over half a second around each state.

    The interval is shorter in a block of a few seconds. If the states are farther apart, neighbours
    are used. Velocities are not computed across gaps.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    latitude, longitude : ndarray of shape (n,), radians
    height : ndarray of shape (n,), metres
    """
    count = len(time)
    if count < 3:
        empty = np.zeros(0)
        return TrajectoryMotion(np.zeros(0, dtype=np.int64), empty, empty, empty)
    with np.errstate(all="ignore"):
        half_interval = min(0.25, float(time[-1] - time[0]) / 8)
        index = np.arange(1, count - 1, 1 + count // MAX_VELOCITIES)
        before = np.minimum(np.searchsorted(time, time[index] - half_interval), index - 1)
        after = np.maximum(
            np.searchsorted(time, time[index] + half_interval, side="right") - 1, index + 1
        )
        after = np.minimum(after, count - 1)
        span = time[after] - time[before]
        sin = np.sin(latitude[index])
        root = np.sqrt(1 - ECCENTRICITY_SQUARED * sin**2)
        meridian = SEMI_MAJOR_AXIS * (1 - ECCENTRICITY_SQUARED) / root**3 + height[index]
        parallel = (SEMI_MAJOR_AXIS / root + height[index]) * np.cos(latitude[index])
        longitude_change = wrap_angle(longitude[after] - longitude[before])
        north = (latitude[after] - latitude[before]) * meridian / span
        east = longitude_change * parallel / span
        up = (height[after] - height[before]) / span
        # The state has to be in the middle: in a turn, the velocity would differ otherwise.
        offset = np.abs((time[after] + time[before]) / 2 - time[index])
        sound = np.isfinite(north) & np.isfinite(east) & np.isfinite(up)
        sound &= (span > 0) & (span < 2 * DEFAULT_LONGEST_GAP_S) & (offset < 0.1 * span)
    return TrajectoryMotion(index[sound], north[sound], east[sound], up[sound])


def wrap_angle(angle: Array) -> Array:
    """Wrap each ``angle``, radians, to -pi to pi, in the same shape."""
    return np.remainder(angle + np.pi, 2 * np.pi) - np.pi


def trajectory_facts(
    time: Array, latitude: Array, longitude: Array, height: Array, speed: Array
) -> dict[str, Fact]:
    """Facts on time span, rate, area, heights and speed of a sample of states.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    latitude, longitude : ndarray of shape (n,), radians
    height : ndarray of shape (n,), metres
    speed : ndarray of shape (m,), metres a second
        Speed of some of the states.
    """
    facts = span_facts(time)
    steps = np.diff(time)
    steps = steps[(steps >= MIN_TIME_STEP_S) & (steps <= DEFAULT_LONGEST_GAP_S)]
    if len(steps):
        facts["Rate"] = note("fact.rate", rate=len(steps) / steps.sum())
    facts["Latitude"] = note("fact.geographic", low=latitude.min(), high=latitude.max())
    facts["Longitude"] = note("fact.geographic", low=longitude.min(), high=longitude.max())
    facts["Height"] = note("fact.lengths", low=height.min(), high=height.max())
    if len(speed):
        facts["Speed"] = note("fact.speeds", low=speed.min(), high=speed.max())
    return facts


def span_facts(time: Array) -> dict[str, Fact]:
    """Facts on start, end and duration of ``time``, shape (n,), seconds."""
    start, end = float(time[0]), float(time[-1])
    long = end - start >= 3600
    return {
        "Start": note("fact.time", time=start),
        "End": note("fact.time", time=end),
        "Duration": note("fact.hours" if long else "fact.seconds", duration=end - start),
    }


def time_warnings(time: Array, base_key: str, file: str) -> tuple[Message, ...]:
    """Warnings about the times of a sample in the order of the file.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    base_key : str
        Key of the time base used.
    file : str
        Name of the file.
    """
    file_warnings = list(assess_times(time).messages(file))
    bases = plausible_bases(time)
    start, end = float(time.min()), float(time.max())
    if not bases:
        file_warnings.append(warning("trajectory.no_time_base", file=file, start=start, end=end))
    elif base_key not in {base.key for base in bases}:
        file_warnings.append(
            warning(
                "trajectory.other_time_base", file=file, start=start, end=end, base=base_key,
                bases=tuple(base.key for base in bases), actions=(CHOOSE_TIME_BASE_ACTION,),
            )
        )  # fmt: skip
    else:
        # Any time of day or week may be UTC, so these bases are not listed.
        known = base_of_key(base_key)
        others = [
            base_message(base)
            for base in bases
            if base is not known and (base.period is None or base.period != known.period)
            if not (base.utc and base.period is not None)
        ]
        if others:
            file_warnings.append(
                warning(
                    "times.several_bases", file=file, base=base_message(known), bases=others,
                    actions=(CHOOSE_TIME_BASE_ACTION,),
                )
            )  # fmt: skip
    return (*file_warnings, *gap_warnings(time, DEFAULT_LONGEST_GAP_S, file))


GAPS_CODE = "trajectory.gaps"
"""Code of the warning about gaps."""


def gap_warnings(time: Array, longest_gap: float, file: str) -> tuple[Message, ...]:
    """Warning about gaps longer than ``longest_gap``.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    longest_gap : float, seconds
    file : str
        Name of the file.
    """
    steps = np.diff(time)
    if not len(steps) or float(steps.max()) <= longest_gap:
        return ()
    wide = int((steps > longest_gap).sum())
    longest = float(steps.max())
    return (warning(GAPS_CODE, file=file, count=wide, limit=longest_gap, longest=longest),)


def course_warnings(
    motions: Sequence[tuple[TrajectoryMotion, TrajectoryMotion]],
    headings: Sequence[Array],
    file: str,
) -> tuple[Message, ...]:
    """Warnings if the course over ground contradicts headings, positions or the unit.

    Parameters
    ----------
    motions : sequence of (TrajectoryMotion, TrajectoryMotion)
        Motion of each block of consecutive states, as read and with latitude and longitude
        exchanged.
    headings : sequence of ndarray of shape (n,), radians
        Headings of each block.
    file : str
        Name of the file.
    """
    speeds = np.concatenate([motion.speed for motion, _ in motions] or [np.zeros(0)])
    median_speed = float(np.median(speeds)) if len(speeds) else 0.0
    if median_speed > MAX_CARRIER_SPEED:
        return (warning("trajectory.impossible_speed", file=file, speed=median_speed),)
    found: tuple[Message, ...] = ()
    if median_speed > MAX_VESSEL_SPEED:
        found = (warning("trajectory.fast", file=file, speed=median_speed),)
    elif len(speeds) and float(speeds.max()) > MAX_VESSEL_SPEED:
        largest = float(speeds.max())
        found = (warning("trajectory.jumps", file=file, speed=median_speed, largest=largest),)
    return (*found, *_heading_warnings(motions, headings, file))


CONTRADICTING_DIFFERENCE_RAD, CONFIRMING_DIFFERENCE_RAD = np.radians(30.0), np.radians(10.0)
"""Median differences of heading and course, radians: a larger one than the first contradicts the
unit used, and a smaller one than the second confirms the other unit."""


def angle_unit_messages(
    path: Path, motion: TrajectoryMotion, heading: Array, unit: float
) -> tuple[Message, ...]:
    """Warning if the headings agree with the course only in the other unit (degrees or radians).

    Parameters
    ----------
    heading : ndarray of shape (n,), radians
        Headings as read in the unit used.
    unit : float, radians
        Size of the unit used.
    """
    degree = float(np.radians(1.0))
    other = 1.0 if unit == degree else degree
    if unit not in (1.0, degree):
        return ()
    own, turned = (
        _heading_differences([motion], [heading * factor]) for factor in (1.0, other / unit)
    )
    if len(own) < 20 or len(turned) < 20:
        return ()
    if (
        np.median(np.abs(own)) < CONTRADICTING_DIFFERENCE_RAD
        or np.median(np.abs(turned)) > CONFIRMING_DIFFERENCE_RAD
    ):
        return ()
    code = "trajectory.angles_in_radians" if unit == degree else "trajectory.angles_in_degrees"
    difference = float(np.median(np.abs(own)))
    file = printable(path.name)
    return (Message(code, Level.WARNING, {"file": file, "difference": difference}),)


def _heading_warnings(
    motions: Sequence[tuple[TrajectoryMotion, TrajectoryMotion]],
    headings: Sequence[Array],
    file: str,
) -> tuple[Message, ...]:
    differences = [
        _heading_differences([pair[which] for pair in motions], headings) for which in (0, 1)
    ]
    if min(len(difference) for difference in differences) < 20:
        return (warning("trajectory.too_slow", file=file),)
    own, exchanged = (float(np.median(np.abs(difference))) for difference in differences)
    if own > np.pi / 4 and exchanged < np.pi / 8 and exchanged < own / 3:
        return (warning("trajectory.exchanged", file=file, actions=(SWAP_COORDINATES_ACTION,)),)
    if own > 3 * np.pi / 4:
        return (warning("trajectory.heading_backward", file=file),)
    if own > np.pi / 4:
        return (warning("trajectory.heading_differs", file=file, difference=own),)
    return ()


def _heading_differences(motions: Sequence[TrajectoryMotion], headings: Sequence[Array]) -> Array:
    found = [
        wrap_angle(motion.course - heading[motion.index])[motion.speed > MIN_SPEED_FOR_COURSE]
        for motion, heading in zip(motions, headings, strict=True)
    ]
    return np.concatenate(found) if found else np.zeros(0)
