"""Times of a line before its import: all times of a short line, a sample of a long line."""

import time as clock
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.format_types import Choice, FileFormat, PointChunk
from lispac.io.las.las_chunks import opened_las, point_count
from lispac.io.point_reader_common import (
    FRAME_OPTION,
    SCANNER_FRAME,
    coordinate_scale,
    report_damage,
    require_distinct_times,
    usable_points,
)
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress
from lispac.survey.line_source import TIME_ROLLOVER_OPTION
from lispac.survey.scanner_frame_recovery import require_scanner_frame
from lispac.survey.time_rollover import ROLLOVER_PERIODS_S, find_rollover, resolve_rollover

Array = NDArray[np.float64]

TIMES_IN_SAMPLE = 20_000
"""Approximate number of times kept of a long line: one every 180 ms for a line of one hour."""
MAX_POINTS_READ_WHOLE = 3_000_000
"""Largest number of points of a LAS or LAZ file that is read completely; of larger files, blocks
distributed over the file are read."""
SAMPLED_BLOCKS, POINTS_PER_BLOCK = 40, 500
"""Number of blocks read of a large file, and points of each block."""
TIMES_PER_POSITION = 10
"""Number of points examined for their time per point examined for its position."""
TIME_LIMIT_S = 15.0
"""Seconds after which reading stops; the remaining points are checked at the import."""


@dataclass(frozen=True, eq=False)
class LineTimes:
    """Times of a line's points, in the time base of the file.

    Attributes
    ----------
    sample : ndarray of shape (n,), seconds, in the file's time base, in the order of the file
        Continued across a time rollover.
    start, end : float, seconds
        Earliest and latest time of the examined points.
    count : int or None
        Number of points of the file, if read completely or given in its header.
    whole : bool
        Whether every point was examined, so that start and end are certain.
    reached_end : bool
        Whether the end of the file was examined.
    place : ndarray of shape (3,), frame and unit of the file
        Coordinates of one point; used only if they are georeferenced.
    rollover : str
        Time rollover, given or detected (`lispac.survey.time_rollover`); empty if there is none.
    """

    sample: Array
    start: float
    end: float
    count: int | None
    whole: bool
    reached_end: bool
    place: Array
    rollover: str = ""


def read_line_times(
    path: Path, format: FileFormat, choice: Choice, *, progress: Progress = no_progress
) -> LineTimes:
    """Read the times of a line: all times of a short line, a sample of a long line.

    Raises
    ------
    InputError
        If the file cannot be read with these options, or is read in the scanner frame but its
        points are not in that frame.
    """
    given = str(choice.get(TIME_ROLLOVER_OPTION, ""))
    resolved = format.complete_options(choice)
    scanner = resolved[FRAME_OPTION.name] == SCANNER_FRAME
    if format.key == "las" and (count := point_count(path)) > MAX_POINTS_READ_WHOLE:
        found, places = _sample_times(path, count, progress)
        if scanner:
            require_scanner_frame(places * coordinate_scale(resolved), path)
        return _resolve_rollover(found, given)
    chunks = format.read(path, choice)
    assert isinstance(chunks, Iterator)
    return _resolve_rollover(_read_times(path, chunks, scanner, progress), given)


def _resolve_rollover(line_times: LineTimes, given: str) -> LineTimes:
    rollover = given or find_rollover(
        np.append(line_times.sample, [line_times.start, line_times.end])
    )
    if rollover not in ROLLOVER_PERIODS_S:
        return line_times
    # The earliest and the latest stored time are on both sides of the rollover; the sample may lack
    # one of them.
    ends = np.append(line_times.sample, [line_times.start, line_times.end])
    resolved = resolve_rollover(ends, rollover)
    return replace(
        line_times, sample=resolved[:-2], start=float(resolved.min()), end=float(resolved.max()),
        rollover=rollover,
    )  # fmt: skip


def _read_times(
    path: Path, chunks: Iterator[PointChunk], scanner: bool, progress: Progress
) -> LineTimes:
    started, done, read = clock.monotonic(), 0, 0
    parts: list[Array] = []
    place = np.zeros(3)
    start, end, ended, total = np.inf, -np.inf, True, None
    for whole in chunks:
        read += len(whole.time)
        chunk = usable_points(whole)
        if not len(chunk.time):
            continue
        if not done:
            if scanner:
                require_scanner_frame(chunk.xyz, path)
            place = np.asarray(chunk.xyz[len(chunk.xyz) // 2], dtype=np.float64)
        done += len(chunk.time)
        start, end = min(start, float(chunk.time.min())), max(end, float(chunk.time.max()))
        parts.append(np.asarray(chunk.time[:: max(1, len(chunk.time) // TIMES_IN_SAMPLE)]))
        total = chunk.total
        progress(
            done / max(total or 2 * done, 1),
            gettext_lazy("Examining {file}: {count:n} points", file=path.name, count=done),
        )
        if clock.monotonic() - started > TIME_LIMIT_S:
            ended = total is not None and read >= total
            break
    if not done:
        raise InputError(error("line.no_points", file=str(path)))
    if ended:
        require_distinct_times(start, end, done, path)
    sample = np.concatenate(parts)
    sample = sample[:: max(1, len(sample) // TIMES_IN_SAMPLE)]
    return LineTimes(sample, start, end, read if ended else total, ended, ended, place)


def _sample_times(path: Path, count: int, progress: Progress) -> tuple[LineTimes, Array]:
    """Times of points spread over a long line, and coordinates (n, 3) of some, file units.

    Raises
    ------
    InputError
        If no time is usable.
    """
    parts, places = [], []
    with report_damage(path, "LAS or LAZ"), opened_las(path) as reader:
        for k, first in enumerate(
            np.linspace(0, count - POINTS_PER_BLOCK, SAMPLED_BLOCKS).astype(int)
        ):
            progress(
                k / SAMPLED_BLOCKS,
                gettext_lazy(
                    "Examining {file}: {count:n} of {total:n} places",
                    file=path.name,
                    count=k,
                    total=SAMPLED_BLOCKS,
                ),
            )
            reader.seek(int(first))
            points = reader.read_points(POINTS_PER_BLOCK)
            parts.append(np.array(points.gps_time, dtype=np.float64))
            xyz = np.stack([points.x, points.y, points.z], axis=1)
            places.append(np.asarray(xyz[::TIMES_PER_POSITION], dtype=np.float64))
    times = np.concatenate(parts)
    times = times[np.isfinite(times)]
    if not len(times):
        raise InputError(error("line.no_usable_time", file=str(path)))
    places_read = np.concatenate(places)
    start, end = float(times.min()), float(times.max())
    return LineTimes(times, start, end, count, False, True, places_read[0]), places_read
