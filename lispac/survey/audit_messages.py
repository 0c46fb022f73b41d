"""Messages about the points of a line from its audit: the object, the number, the effect."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Action, Level, Message, Value, note, warning
from lispac.survey.line_audit import (
    MIN_POINTS_PER_COARSE_TIME,
    LineAudit,
    shared_point_fraction,
)
from lispac.survey.time_base import DAY, HOUR, WEEK
from lispac.survey.trajectory import LocalTrajectory, interpolate
from lispac.warning_causes import Cause

MAX_FAR_POINT_SHARE = 0.001
"""Largest share of points beyond the largest range that gives only a note; with more, the unit of
the file or the given scanner is probably wrong."""
MIN_REPORTED_TIME_STEP_S = 0.9e-3
"""Smallest step of the point times that is reported, seconds."""
MIN_GROUP_SHARE = 0.01
"""Smallest share of the points for a separate scanner or line."""
MAX_GROUPS = 8
"""Largest number of large groups by an attribute that is assumed to number scanners or lines."""
MIN_COMMON_POINT_SHARE = 0.01
"""Smallest share of common points for which two lines are reported to repeat each other."""
MIN_COMMON_TIME_SHARE = 0.05
"""Smallest ratio of the common time to the duration of the shorter line for simultaneous lines."""
ROUNDING_OVERLAP_S = 2.0
"""Overlap in seconds that may result from the rounding of time spans to whole seconds."""
ROLLOVER_TOLERANCE_S = 1.5
"""Largest distance of both ends of a file's times from the limits of a period, for a rollover."""
LONG_PAUSE_S = 60.0
"""Pause that separates two lines, unless the vessel continued at its speed."""
MIN_TURN_RAD = np.radians(30.0)
"""Change of heading during a pause that separates two lines."""
MIN_CONTINUED_DISTANCE_RATIO = 0.5
"""Smallest ratio of the distance covered during a pause to that at constant speed for which the
vessel did not stop."""
MOTION_QUANTILE = 0.95
"""Quantile of the speeds and angular rates of a line used for the effect of a time error."""
SCANNER_ATTRIBUTES = (
    "scanner_channel", "scanner", "scanner_id", "head", "head_id", "device", "device_id",
    "sensor_id", "lidar_id",
)  # fmt: skip
"""Attributes that number scanners; other attributes number lines, or either."""


def line_messages(
    name: str,
    audit: LineAudit,
    trajectory: LocalTrajectory | None = None,
    times: NDArray[np.float64] | None = None,
) -> tuple[Message, ...]:
    """Messages about one line, or about one file without a trajectory.

    Parameters
    ----------
    name : str
        Name of the line or file.
    audit : LineAudit
    trajectory : LocalTrajectory, optional
        Needed for the effects of the motion.
    times : ndarray of shape (n,), seconds, in the trajectory's time base, optional
        Sample of the times of the line that have a pose, ascending.
    """
    if not audit.read:
        return ()
    times = np.zeros(0) if times is None else times
    found = [
        *_time_resolution_warning(name, audit, trajectory, times),
        *_excluded_point_notes(name, audit),
        *_noise_class_warning(name, audit),
        *_group_messages(name, audit),
        *_several_lines_messages(name, audit, trajectory, times),
    ]
    return tuple(found)


def shared_messages(audits: Mapping[str, LineAudit]) -> tuple[Message, ...]:
    """Messages about lines with common points, by name of the line."""
    found = []
    for (one, first), (other, second) in combinations(audits.items(), 2):
        share = shared_point_fraction(first, second)
        if share >= MIN_COMMON_POINT_SHARE:
            smaller = one if first.read < second.read else other
            found.append(
                Message(
                    "audit.shared_points",
                    Level.WARNING,
                    {"line": one, "other": other, "share": share, "smaller": smaller},
                    Cause.of_line(smaller),
                    (Action("exclude_line", {"line": smaller}),),
                )
            )
    return tuple(found)


def simultaneous_messages(
    audits: Mapping[str, LineAudit], first_times: Mapping[str, float]
) -> tuple[Message, ...]:
    """Messages about simultaneous lines: one is a copy, or from another scanner.

    Lines with identical points are reported by `shared_messages` instead.

    Parameters
    ----------
    audits : mapping of str to LineAudit
        Audits by name of the line.
    first_times : mapping of str to float, seconds
        Earliest time of each line in the trajectory's time base.
    """
    spans = {
        name: _shift_to_trajectory_time(_unrolled_spans(audit.spans), first_times[name])
        for name, audit in audits.items()
        if audit.spans
    }
    found = []
    for (one, own), (other, others) in combinations(spans.items(), 2):
        common = sum(
            max(0.0, min(end, last) - max(start, first) - ROUNDING_OVERLAP_S)
            for start, end in own
            for first, last in others
        )
        shorter = min(sum(end - start for start, end in each) for each in (own, others))
        if common < MIN_COMMON_TIME_SHARE * shorter or common == 0:
            continue
        if shared_point_fraction(audits[one], audits[other]) < MIN_COMMON_POINT_SHARE:
            params: dict[str, Value] = {"line": other, "other": one, "seconds": common}
            found.append(
                Message(
                    "audit.same_time",
                    Level.WARNING,
                    params,
                    Cause.of_line(other),
                    (Action("exclude_line", {"line": other}),),
                )
            )
    return tuple(found)


def _shift_to_trajectory_time(
    spans: Sequence[tuple[float, float]], first_time: float
) -> list[tuple[float, float]]:
    """Time spans of a file in the trajectory's time base, shifted by the line's earliest time."""
    shift = np.floor(first_time) - spans[0][0]
    return [(start + shift, end + shift) for start, end in spans]


def _time_resolution_warning(
    name: str, audit: LineAudit, trajectory: LocalTrajectory | None, times: NDArray[np.float64]
) -> Iterator[Message]:
    if (
        audit.time_step < MIN_REPORTED_TIME_STEP_S
        or audit.points_per_time < MIN_POINTS_PER_COARSE_TIME
    ):
        return
    if trajectory is None or not len(times):
        params: dict[str, Value] = {
            "line": name, "step": audit.time_step, "points": audit.points_per_time,
        }  # fmt: skip
        yield Message("audit.time_steps", Level.WARNING, params, Cause.of_line(name))
        return
    rates = np.abs(trajectory.rate_at(times))
    speed = float(np.quantile(np.linalg.norm(rates[:, :3], axis=1), MOTION_QUANTILE))
    turn = float(np.quantile(np.linalg.norm(rates[:, 3:], axis=1), MOTION_QUANTILE))
    half = audit.time_step / 2
    yield Message(
        "audit.time_resolution",
        Level.WARNING,
        {
            "line": name,
            "step": audit.time_step,
            "points": audit.points_per_time,
            "shift": half * (speed + turn * audit.mean_range),
            "turn": half * turn,
        },
        Cause.of_line(name),
    )


def _excluded_point_notes(name: str, audit: LineAudit) -> Iterator[Message]:
    subject = Cause.of_line(name)

    def excluded(count: int) -> dict[str, Any]:
        return {"line": name, "count": count, "share": count / audit.read}

    if audit.not_finite:
        yield note("audit.not_finite", subject=subject, **excluded(audit.not_finite))
    if audit.no_range:
        yield note("audit.no_range", subject=subject, **excluded(audit.no_range))
    if audit.too_far:
        many = audit.too_far > MAX_FAR_POINT_SHARE * audit.read
        params = excluded(audit.too_far)
        yield (warning if many else note)("audit.too_far", subject=subject, **params)
    if audit.duplicates:
        yield note("audit.duplicates", subject=subject, **excluded(audit.duplicates))
    if audit.withheld:
        keep = _set_option_action("withheld", "keep")
        params = excluded(audit.withheld)
        yield note("audit.withheld", subject=subject, actions=[keep], **params)
    if audit.of_classes:
        yield note("audit.of_classes", subject=subject, **excluded(audit.of_classes))
    if audit.not_selected:
        yield note("audit.not_selected", subject=subject, **excluded(audit.not_selected))


def _noise_class_warning(name: str, audit: LineAudit) -> Iterator[Message]:
    if audit.noise:
        yield Message(
            "audit.noise_classes",
            Level.WARNING,
            {"line": name, "count": sum(audit.noise.values()), "classes": tuple(audit.noise)},
            Cause.of_line(name),
            (_set_option_action("exclude_classes", " ".join(audit.noise)),),
        )


def _group_messages(name: str, audit: LineAudit) -> Iterator[Message]:
    """Messages about several scanners or lines in one file, according to an attribute."""
    for attribute, large in _find_large_groups(audit):
        code = "several_scanners" if attribute in SCANNER_ATTRIBUTES else "several_sources"
        yield Message(
            f"audit.{code}",
            Level.WARNING,
            {"line": name, "attribute": attribute, "values": tuple(large), "count": len(large)},
            Cause.of_line(name),
            (
                Action("split_line", {"line": name, "by": attribute}),
                *(_set_option_action("only", f"{attribute}={value}") for value in large[:2]),
            ),
        )


def has_several_scanners(audit: LineAudit) -> bool:
    """Whether an attribute shows that the points are from several scanners."""
    return any(attribute in SCANNER_ATTRIBUTES for attribute, _ in _find_large_groups(audit))


def _find_large_groups(audit: LineAudit) -> Iterator[tuple[str, list[str]]]:
    """Attributes that divide the points into a few large groups, and their values."""
    for attribute, counts in audit.groups.items():
        used = sum(counts.values())
        large = [value for value, count in counts.items() if count >= MIN_GROUP_SHARE * used]
        if 1 < len(large) <= MAX_GROUPS:
            yield attribute, large


def _several_lines_messages(
    name: str, audit: LineAudit, trajectory: LocalTrajectory | None, times: NDArray[np.float64]
) -> Iterator[Message]:
    """Messages about several lines in one file, separated by turns or long pauses."""
    spans = _unrolled_spans(audit.spans)
    if len(spans) < 2:
        return
    line_count = 1
    for (_, before), (after, _) in pairwise(spans):
        if trajectory is None or not len(times):
            line_count += bool(after - before > LONG_PAUSE_S)
            continue
        # The audit has the times of the file, of which only the differences are used.
        shift = times[0] - spans[0][0]
        ends = np.clip(np.array([before, after]) + shift, times[0], times[-1])
        line_count += _has_vessel_turned(trajectory, ends) or (
            after - before > LONG_PAUSE_S and not _has_vessel_continued(trajectory, ends)
        )
    if line_count > 1:
        yield Message(
            "audit.several_passes",
            Level.WARNING,
            {"line": name, "count": line_count},
            Cause.of_line(name),
            (Action("split_line", {"line": name, "by": "gap"}),),
        )


def _has_vessel_turned(trajectory: LocalTrajectory, ends: NDArray[np.float64]) -> bool:
    """Whether the vessel turned between two times, shape (2,), seconds."""
    inside = slice(
        np.searchsorted(trajectory.time, ends[0], side="right"),
        np.searchsorted(trajectory.time, ends[1]),
    )
    heading = interpolate(ends, trajectory.time, trajectory.attitude[:, 2:])[:, 0]
    turned = (heading[1] - heading[0] + np.pi) % (2 * np.pi) - np.pi
    headings_between = trajectory.attitude[inside, 2]
    return bool(
        abs(turned) > MIN_TURN_RAD
        or (len(headings_between) and np.ptp(headings_between) > MIN_TURN_RAD)
    )


def _has_vessel_continued(trajectory: LocalTrajectory, ends: NDArray[np.float64]) -> bool:
    """Whether the vessel continued at its speed between two times, shape (2,), seconds.

    This is the case during pauses of a line of which only points on certain objects were exported.
    The trajectory may have no states in between.
    """
    position = interpolate(ends, trajectory.time, trajectory.position)
    speed = np.linalg.norm(trajectory.rate_at(ends)[:, :3], axis=1).mean()
    distance = float(np.linalg.norm(position[1] - position[0]))
    return distance > MIN_CONTINUED_DISTANCE_RATIO * speed * float(ends[1] - ends[0])


def _unrolled_spans(spans: Sequence[Sequence[float]]) -> list[tuple[float, float]]:
    """Spans of times with the rollover at a full hour, midnight or end of the week resolved.

    Parameters
    ----------
    spans : sequence of (float, float), seconds
        First and last time between pauses, ascending, as in the file.
    """
    file_spans = [(start, end) for start, end in spans]
    if len(file_spans) < 2:
        return file_spans
    for period in (HOUR, DAY, WEEK):
        if (
            file_spans[0][0] <= ROLLOVER_TOLERANCE_S
            and abs(file_spans[-1][1] - period) <= ROLLOVER_TOLERANCE_S
        ):
            pauses = [after - before for (_, before), (after, _) in pairwise(file_spans)]
            k = 1 + int(np.argmax(pauses))
            after_rollover = [(start + period, end + period) for start, end in file_spans[:k]]
            # One span on both sides of the rollover
            joined = (file_spans[-1][0], after_rollover[0][1])
            return [*file_spans[k:-1], joined, *after_rollover[1:]]
    return file_spans


def _set_option_action(name: str, value: str) -> Action:
    return Action("set_option", {"name": name, "value": value})
