"""Time shifts of lines that follow from given time bases."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from lispac.errors import InputError
from lispac.io.format_types import Choice, FileFormat
from lispac.io.formats import format_of
from lispac.io.points.line_times import read_line_times
from lispac.messages import Message, error, note
from lispac.project import LineSource, Project, Reading
from lispac.survey.known_time_base import (
    KnownTimeBase,
    known_base_notes,
    matches_of_known_bases,
    no_overlap_error,
    time_base_error,
)
from lispac.survey.line_source import TIME_ROLLOVER_OPTION, printable
from lispac.survey.time_base import base_of_key, equally_good_matches
from lispac.survey.time_rollover import NO_ROLLOVER
from lispac.workflow.importing.file_reading import DEFAULT_FORMATS, format_of_line, read_trajectory

SHIFT_TOLERANCE = 1e-3
"""Largest difference of a given shift from the one that follows from the time bases, seconds."""


def known_time_base(
    format: FileFormat, path: Path, choice: Choice, option: str, *, given: bool
) -> KnownTimeBase:
    """Known time base of a file.

    Parameters
    ----------
    option : str
        Name of the option of the format for the time base.
    given : bool
        Whether the time base in ``choice`` was given by the user.

    Raises
    ------
    InputError
        If the file cannot be examined.
    """
    base_key = str(choice.get(option, ""))
    if not base_key:
        found = format.complete_options({**format.preview(path, choice).choice, **choice})
        base_key, given = str(found.get(option, "")), False
    suggested = not given and format.infers_time_base
    by_format = format.kind == "points" and format.has_time_base
    return KnownTimeBase(base_of_key(base_key) if base_key else None, given, suggested, by_format)


def has_given_time_base(trajectory: Path, reading: Reading) -> bool:
    """True if the reading options of a trajectory give a time base that its file does not specify.

    Raises
    ------
    InputError
        If the file cannot be examined.
    """
    kept = dict(reading.options)
    given = kept.pop("time", "")
    if not given:
        return False
    format = format_of(reading.format or DEFAULT_FORMATS["trajectory"])
    found = format.complete_options({**format.preview(trajectory, kept).choice, **kept})
    return given != str(found.get("time", ""))


def shift_lines_to_trajectory(
    lines: Sequence[LineSource],
    given_readings: Sequence[Reading],
    trajectory: Path,
    trajectory_reading: Reading,
    *,
    trajectory_given: bool,
) -> tuple[tuple[LineSource, ...], tuple[Message, ...]]:
    """Set the time shift of lines that follows from time bases given or defined by the format.

    Parameters
    ----------
    lines : sequence of LineSource
        Lines with complete reading options.
    given_readings : sequence of Reading
        Reading options given by the user for each line.
    trajectory_reading : Reading
        Complete reading options of the trajectory.
    trajectory_given : bool
        Whether the user gives the time base of the trajectory.

    Returns
    -------
    lines : tuple of LineSource
        Lines with the shift; lines without a known shift are unchanged.
    notes : tuple of Message

    Raises
    ------
    InputError
        If the times are not possible in the given base, or the user also gives a shift that
        differs from the one that follows from the bases, or several shifts follow from the base
        that the format defines.
    """
    bases = [dict(reading.options).get("time_base", "") for reading in given_readings]
    by_format = [format_of_line(line)[0].has_time_base for line in lines]
    if not any(bases) and not any(by_format) and not trajectory_given:
        return tuple(lines), ()
    track = read_trajectory(trajectory, trajectory_reading).time
    other = known_time_base(
        format_of(trajectory_reading.format or DEFAULT_FORMATS["trajectory"]), trajectory,
        dict(trajectory_reading.options), "time", given=trajectory_given,
    )  # fmt: skip
    shifted_lines: list[LineSource] = []
    notes: list[Message] = []
    for line, base, is_defined in zip(lines, bases, by_format, strict=True):
        shifted_lines.append(line)
        if not base and not is_defined and not trajectory_given:
            continue
        format, choice, _ = format_of_line(line)
        own = known_time_base(format, line.path, choice, "time_base", given=bool(base))
        choice = {**choice, TIME_ROLLOVER_OPTION: line.reading.time_rollover or NO_ROLLOVER}
        times = read_line_times(line.path, format, choice).sample
        if wrong := time_base_error(times, own, str(line.path)):
            raise InputError(wrong)
        found = matches_of_known_bases(times, track, own, other)
        typed = line.reading.time_shift
        if found is None:
            if own.base is None and not typed:
                file = printable(line.path.name)
                notes.append(note("import.base_assumed", file=file, base=other.message))
            continue
        if not found:
            if not typed:
                raise InputError(no_overlap_error(own, other, times, track, str(line.path)))
            continue
        shift = found[0].shift
        if own.by_format and not typed and (rivals := equally_good_matches(found)):
            shifts = [note("import.shift", shift=match.shift) for match in (found[0], *rivals)]
            raise InputError(error("import.hour_unknown", file=str(line.path), shifts=shifts))
        if typed:
            is_given = bool(base) or trajectory_given
            if is_given and all(abs(typed - match.shift) > SHIFT_TOLERANCE for match in found):
                raise InputError(
                    error(
                        "import.shift_contradicts_base",
                        file=str(line.path),
                        given=typed,
                        needed=shift,
                        base=own.message,
                        trajectory_base=other.message,
                    )
                )
        elif shift:
            shifted_lines[-1] = replace(line, reading=replace(line.reading, time_shift=shift))
            notes += known_base_notes(found, own, other, printable(line.path.name))
    return tuple(shifted_lines), tuple(notes)


def time_base_of_trajectory(project: Project) -> str:
    """Key of the time base of the trajectory; empty if it is not known."""
    reading = project.trajectory_reading
    format = format_of(reading.format or DEFAULT_FORMATS["trajectory"])
    try:
        found = known_time_base(
            format, project.trajectory, dict(reading.options), "time", given=False
        )
    except InputError:  # the file is missing, but the loaded survey does not need it
        return ""
    return "" if found.base is None else found.base.key
