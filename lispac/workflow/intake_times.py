"""Time base of a line relative to the trajectory during import: given, fitting or proposed."""

from dataclasses import replace

from lispac.io.formats import suggests_time
from lispac.io.line_times import LineTimes
from lispac.survey.time_base import Match, TimeBase, base_of, matches
from lispac.survey.time_quality import Coverage, coverage
from lispac.survey.time_stated import KnownTimeBase, bringing_more, following
from lispac.survey.trajectory import Trajectory
from lispac.workflow.intake_entry import Entry

SHARE_NEEDED = 0.5
"""Share of a line's points that a shift must bring inside to be proposed."""


def line_base(entry: Entry) -> KnownTimeBase:
    """What is known of what a line's times count."""
    stated = (entry.stated or {}).get("time_base", "")
    found = "" if entry.finding is None else str(entry.finding.choice.get("time_base", ""))
    key = stated or found
    return KnownTimeBase(base_of(key) if key else None, bool(stated))


def trajectory_base(entry: Entry | None) -> KnownTimeBase:
    """What is known of what a trajectory's times count."""
    key = "" if entry is None else entry.options.get("time", "")
    if entry is None or not key:
        return KnownTimeBase()
    stated = bool((entry.stated or {}).get("time", ""))
    if entry.given is not None:
        # A project keeps what was found beside what was given.
        look = next((look for look in entry.looks if look.format is entry.format), None)
        found = look.finding.choice if look is not None and look.finding is not None else {}
        stated = stated and key != found.get("time", key)
    suggested = not stated and entry.format is not None and suggests_time(entry.format)
    return KnownTimeBase(base_of(key), stated, suggested)


def with_stated_shifts(entries: tuple[Entry, ...]) -> tuple[Entry, ...]:
    """Set the shift of lines from the given time bases, and remove obsolete ones.

    As `stated_times` does it when the project is made.
    """
    trajectory = next((entry for entry in entries if entry.role == "trajectory"), None)
    if trajectory is None or not isinstance(trajectory.content, Trajectory):
        return entries
    other, track = trajectory_base(trajectory), trajectory.content.time
    settled = []
    for entry in entries:
        if entry.role == "points" and isinstance(entry.content, LineTimes):
            found = following(entry.content.sample, track, line_base(entry), other)
            if found:
                entry = replace(entry, shift=found[0].shift, follows=True)
            elif entry.follows:
                entry = replace(entry, shift=0.0, follows=False)
        settled.append(entry)
    return tuple(settled)


def line_coverage(entry: Entry, trajectory: Trajectory, longest_gap: float) -> Coverage | None:
    """How the trajectory covers what was examined of a line, its shift applied."""
    if not isinstance(entry.content, LineTimes):
        return None
    return coverage(entry.content.sample + entry.shift, trajectory.time, longest_gap)


def offered_shift(
    entry: Entry, track: Trajectory, longest_gap: float, base: TimeBase | None
) -> Match | None:
    """The shift to propose for a line, if no point lies inside or many more would.

    Never besides what is given.

    Parameters
    ----------
    base : TimeBase or None
        The trajectory's.
    """
    covered = line_coverage(entry, track, longest_gap)
    if entry.follows or covered is None or not isinstance(entry.content, LineTimes):
        return None
    if not covered.outside:
        return None
    found = fitting(entry.content, track, base)
    if covered.usable:
        best = bringing_more(found, 1 - covered.share_outside)
    else:
        best = found[0] if found else None
    if best is None or best.share < SHARE_NEEDED or abs(best.shift - entry.shift) < 1e-9:
        return None
    return best


def fitting(times: LineTimes, track: Trajectory, base: TimeBase | None) -> tuple[Match, ...]:
    """Ways to bring a line onto the trajectory: in its own base, else in any."""
    some = times.sample[:: max(1, len(times.sample) // 1000)]
    if base is not None:
        found = matches(some, track.time, trajectory_bases=(base,))
        if found and found[0].share >= SHARE_NEEDED:
            return found
    return matches(some, track.time)
