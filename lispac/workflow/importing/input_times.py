"""Time shifts that bring the times of a line onto the trajectory before the import."""

from dataclasses import replace

from lispac.io.points.line_times import LineTimes
from lispac.survey.known_time_base import (
    KnownTimeBase,
    clearly_better_match,
    matches_of_known_bases,
)
from lispac.survey.time_base import (
    TimeBase,
    TimeMatch,
    base_of_key,
    equally_good_matches,
    find_time_matches,
)
from lispac.survey.time_quality import TrajectoryCoverage, assess_coverage
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing.input_file import InputFile

MIN_SHARE_ON_TRAJECTORY = 0.5
"""Smallest share of a line's points that a proposed time shift must bring onto the trajectory."""


def line_time_base(file: InputFile) -> KnownTimeBase:
    """Known time base of a line."""
    given = (file.given_options or {}).get("time_base", "")
    found = "" if file.finding is None else str(file.finding.choice.get("time_base", ""))
    key = given or found
    by_format = file.format is not None and file.format.has_time_base
    return KnownTimeBase(base_of_key(key) if key else None, bool(given), by_format=by_format)


def trajectory_time_base(file: InputFile | None) -> KnownTimeBase:
    """Known time base of a trajectory."""
    key = "" if file is None else file.options.get("time", "")
    if file is None or not key:
        return KnownTimeBase()
    given = bool((file.given_options or {}).get("time", ""))
    if file.project_reading is not None:
        # A project stores detected options together with given ones.
        check = next((check for check in file.checks if check.format is file.format), None)
        found = check.finding.choice if check is not None and check.finding is not None else {}
        given = given and key != found.get("time", key)
    suggested = not given and file.format is not None and file.format.infers_time_base
    return KnownTimeBase(base_of_key(key), given, suggested)


def with_time_base_shifts(files: tuple[InputFile, ...]) -> tuple[InputFile, ...]:
    """Apply the shifts that follow from given time bases, and remove those that do not.

    `shift_lines_to_trajectory` does the same when the project is made.
    """
    trajectory = next((file for file in files if file.role == "trajectory"), None)
    if trajectory is None or not isinstance(trajectory.content, Trajectory):
        return files
    other, track = trajectory_time_base(trajectory), trajectory.content.time
    resolved = []
    for file in files:
        if file.role == "points" and isinstance(file.content, LineTimes):
            found = matches_of_known_bases(file.content.sample, track, line_time_base(file), other)
            is_unclear = line_time_base(file).by_format and found and equally_good_matches(found)
            if found and not is_unclear:
                file = replace(file, shift=found[0].shift, shift_follows_bases=True)
            elif file.shift_follows_bases:
                file = replace(file, shift=0.0, shift_follows_bases=False)
        resolved.append(file)
    return tuple(resolved)


def line_coverage(
    file: InputFile, trajectory: Trajectory, longest_gap: float
) -> TrajectoryCoverage | None:
    """Coverage of the examined points of a line by the trajectory, with the time shift applied."""
    if not isinstance(file.content, LineTimes):
        return None
    return assess_coverage(file.content.sample + file.shift, trajectory.time, longest_gap)


def proposed_shift(
    file: InputFile, track: Trajectory, longest_gap: float, base: TimeBase | None
) -> TimeMatch | None:
    """Time shift that brings clearly more points of a line onto the trajectory; None without one.

    No shift is proposed for a line within the trajectory, or whose shift follows from given time
    bases.

    Parameters
    ----------
    base : TimeBase or None
        Time base of the trajectory.
    """
    covered = line_coverage(file, track, longest_gap)
    if file.shift_follows_bases or covered is None or not isinstance(file.content, LineTimes):
        return None
    if not covered.outside:
        return None
    found = matching_shifts(file.content, track, base)
    if covered.usable:
        best = clearly_better_match(found, 1 - covered.share_outside)
    else:
        best = found[0] if found else None
    if best is None or best.share < MIN_SHARE_ON_TRAJECTORY or abs(best.shift - file.shift) < 1e-9:
        return None
    return best


def matching_shifts(
    times: LineTimes, track: Trajectory, base: TimeBase | None
) -> tuple[TimeMatch, ...]:
    """Time shifts that bring a line onto the trajectory.

    The shifts are those for ``base``, the time base of the trajectory, if it is known and at least
    `MIN_SHARE_ON_TRAJECTORY` of the points are on the trajectory with the best of them. Otherwise
    they are those for all time bases.
    """
    some = times.sample[:: max(1, len(times.sample) // 1000)]
    if base is not None:
        found = find_time_matches(some, track.time, trajectory_bases=(base,))
        if found and found[0].share >= MIN_SHARE_ON_TRAJECTORY:
            return found
    return find_time_matches(some, track.time)
