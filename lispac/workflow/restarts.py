"""Lines whose own times start again at midnight or at the end of the week."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from lispac.io.line_times import line_times
from lispac.io.registry import Choice, Format, PointChunk
from lispac.messages import Message
from lispac.project import LineSource
from lispac.survey.source import RESTART, printable
from lispac.survey.time_restart import NONE, PERIODS, restart_message
from lispac.workflow.file_reading import format_of_line

NEAR = 6 * 3600.0
"""Seconds from a midnight or the end of a week that no line reaches which its first points are
farther from."""


def lines_counted_on(
    lines: Sequence[LineSource],
) -> tuple[tuple[LineSource, ...], tuple[Message, ...]]:
    """Determine from the times of lines whether they have a time rollover.

    Returns
    -------
    lines : tuple of LineSource
        Lines with a time rollover, with the option for it.
    notes : tuple of Message

    Raises
    ------
    InputError
        Where a file cannot be read.
    """
    settled: list[LineSource] = []
    notes: list[Message] = []
    for line in lines:
        settled.append(line)
        if line.reading.restart == NONE:
            continue
        format, choice, _ = format_of_line(line)
        if not line.reading.restart and not _near(format, choice, line):
            continue
        choice = {**choice, RESTART: line.reading.restart}
        times = line_times(line.path, format, choice)
        if not times.restart:
            continue
        options = dict(line.reading.options) | {RESTART: times.restart}
        settled[-1] = replace(line, reading=replace(line.reading, options=tuple(options.items())))
        notes.append(restart_message(times.sample, times.restart, printable(line.path.name)))
    return tuple(settled), tuple(notes)


def _near(format: Format, choice: Choice, line: LineSource) -> bool:
    """Whether the first points are near enough to a rollover to examine the others."""
    chunks = format.read(line.path, choice)
    assert isinstance(chunks, Iterator)
    first = next(chunks, None)
    if not isinstance(first, PointChunk) or not len(first.time):
        return False
    time = first.time
    return any(
        bool(((time >= 0) & (time < period) & (np.minimum(time, period - time) < NEAR)).any())
        for period in PERIODS.values()
    )
