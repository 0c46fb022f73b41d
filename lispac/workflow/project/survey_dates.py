"""Dates of a survey, by the times of its lines."""

from collections.abc import Callable
from datetime import UTC, datetime
from functools import cache

import numpy as np
from numpy.typing import NDArray

from lispac.errors import LispacError
from lispac.io.formats import format_of
from lispac.io.points.line_times import read_line_times
from lispac.project import LineSource, Project
from lispac.survey.known_time_base import KnownTimeBase
from lispac.survey.line_source import TIME_ROLLOVER_OPTION
from lispac.survey.time_base import GPS_EPOCH, TimeBase, leap_seconds_at_gps, to_gps
from lispac.survey.time_rollover import NO_ROLLOVER
from lispac.workflow.importing.file_reading import DEFAULT_FORMATS, format_of_line
from lispac.workflow.importing.given_time_bases import known_time_base
from lispac.workflow.project.survey import Survey


def survey_dates(project: Project, survey: Survey | None = None) -> str:
    """First and last day (UTC) of the lines, as text; empty if some times are undetermined.

    Parameters
    ----------
    survey : Survey, optional
        Loaded survey, whose times are used; if None, the files are examined, large ones by samples.
    """
    days: set[str] = set()

    @cache
    def track_base() -> KnownTimeBase:
        reading = project.trajectory_reading
        return known_time_base(
            format_of(reading.format or DEFAULT_FORMATS["trajectory"]), project.trajectory,
            dict(reading.options), "time", given=False,
        )  # fmt: skip

    for line in project.lines:
        try:
            found = _line_days(line, survey, track_base)
        except (LispacError, OSError):
            return ""  # it is a suggestion; reading errors are reported elsewhere
        if not found:
            return ""
        days |= found
    return " to ".join(sorted({min(days), max(days)})) if days else ""


def _line_days(
    line: LineSource, survey: Survey | None, track_base: Callable[[], KnownTimeBase]
) -> set[str]:
    """First and last day of a line; empty if its time base is not known.

    The trajectory's times may contain the date if those of the line do not.
    """
    format, choice, _ = format_of_line(line)
    if survey is None:
        rollover = {TIME_ROLLOVER_OPTION: line.reading.time_rollover or NO_ROLLOVER}
        times = read_line_times(line.path, format, {**choice, **rollover}).sample
        moved = line.reading.to_trajectory_time(times)
    else:
        scan = survey.scans[line.name]
        moved = np.array([scan.first_time, scan.last_time])
        times = line.reading.to_file_time(moved)
    own = known_time_base(format, line.path, choice, "time_base", given=False)
    for known, seconds in ((own, times), (track_base(), moved)):
        if known.base is not None and known.base.period is None and known.fits(seconds):
            return _utc_days(seconds, known.base)
    return set()


def _utc_days(times: NDArray[np.float64], base: TimeBase) -> set[str]:
    gps = to_gps(np.array([times.min(), times.max()]), base)
    utc = gps - leap_seconds_at_gps(gps) + GPS_EPOCH
    return {f"{datetime.fromtimestamp(float(at), UTC):%Y-%m-%d}" for at in utc}
