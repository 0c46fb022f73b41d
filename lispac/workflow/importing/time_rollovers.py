"""Time rollovers of lines, at midnight or at the end of the week."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from lispac.io.format_types import Choice, FileFormat, PointChunk
from lispac.io.points.line_times import read_line_times
from lispac.messages import Message
from lispac.project import LineSource
from lispac.survey.line_source import TIME_ROLLOVER_OPTION, printable
from lispac.survey.time_rollover import NO_ROLLOVER, ROLLOVER_PERIODS_S, rollover_note
from lispac.workflow.importing.file_reading import format_of_line

ROLLOVER_MARGIN = 6 * 3600.0
"""Time before and after midnight or the end of the week, seconds. A line whose first points are
farther from both is assumed not to reach them, and its other times are not checked."""


def resolve_time_rollovers(
    lines: Sequence[LineSource],
) -> tuple[tuple[LineSource, ...], tuple[Message, ...]]:
    """Detect time rollovers of lines from their times.

    Returns
    -------
    lines : tuple of LineSource
        The lines, with the option for the time rollover set if one was detected.
    notes : tuple of Message

    Raises
    ------
    InputError
        If a file cannot be read.
    """
    resolved: list[LineSource] = []
    notes: list[Message] = []
    for line in lines:
        resolved.append(line)
        if line.reading.time_rollover == NO_ROLLOVER:
            continue
        format, choice, _ = format_of_line(line)
        if not line.reading.time_rollover and not _is_near_rollover(format, choice, line):
            continue
        choice = {**choice, TIME_ROLLOVER_OPTION: line.reading.time_rollover}
        times = read_line_times(line.path, format, choice)
        if not times.rollover:
            continue
        options = dict(line.reading.options) | {TIME_ROLLOVER_OPTION: times.rollover}
        resolved[-1] = replace(line, reading=replace(line.reading, options=tuple(options.items())))
        notes.append(rollover_note(times.sample, times.rollover, printable(line.path.name)))
    return tuple(resolved), tuple(notes)


def _is_near_rollover(format: FileFormat, choice: Choice, line: LineSource) -> bool:
    """True if the first times are close enough to a rollover to check the others."""
    chunks = format.read(line.path, choice)
    assert isinstance(chunks, Iterator)
    first = next(chunks, None)
    if not isinstance(first, PointChunk) or not len(first.time):
        return False
    time = first.time
    return any(
        bool(
            (
                (time >= 0) & (time < period) & (np.minimum(time, period - time) < ROLLOVER_MARGIN)
            ).any()
        )
        for period in ROLLOVER_PERIODS_S.values()
    )
