"""Types for the formats of files: options, previews, chunks of points.

A format has a name, file extensions, a test of how likely a file is of this format,
options that may be needed, and how to read it. The import dialogue, the command line and the
tests all work on this list; nothing else knows which formats there are.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import Message, error, note
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

Kind = Literal["trajectory", "accuracy", "points"]
Choice = Mapping[str, Any]
"""Options by name, given by the user or detected."""
Fact = str | int | Message
"""Fact found in a file: a text of the file itself, a count, or a message."""
SAME_TIME_BASE = note("assumed.same_time_base")

SURE, LIKELY, POSSIBLE, NOT = 1.0, 0.7, 0.3, 0.0
"""How sure a format is of a file: its magic or structure fits it alone; structure and values fit;
nothing speaks against it; it is not one."""


@dataclass(frozen=True)
class FormatOption:
    """Reading option that a file does not specify itself.

    Attributes
    ----------
    name : str
        As in the project file and at the command line.
    meaning : str
        One sentence for the dialogue, marked for translation.
    choices : tuple of str
        Choices; empty for free text (for example a column mapping).
    default : str
        Used if neither the user nor the detection gives another value.
    """

    name: str
    meaning: str
    choices: tuple[str, ...] = ()
    default: str = ""


@dataclass(frozen=True)
class FilePreview:
    """Preview of a file: facts, detected options and warnings.

    Attributes
    ----------
    facts : mapping of str to Fact
        For the preview: header entries, counts, spans, frame, unit, time base.
    rows : tuple of tuple of str
        First rows, the names of the columns at the head.
    choice : mapping
        Options as detected.
    file_warnings : tuple of Message
        Warnings about how the file is read, to be checked before importing.
    assumptions : tuple of Message
        What the reader assumes with these options: frame, unit, signs, time base.
    messages : tuple of Message
        Warnings and notes about the content of the file.
    """

    facts: Mapping[str, Fact]
    rows: tuple[tuple[str, ...], ...] = ()
    choice: Choice = None  # type: ignore[assignment]
    file_warnings: tuple[Message, ...] = ()
    assumptions: tuple[Message, ...] = ()
    messages: tuple[Message, ...] = ()

    def __post_init__(self) -> None:
        if self.choice is None:
            object.__setattr__(self, "choice", {})


@dataclass(frozen=True, eq=False)
class PointChunk:
    """A chunk of points of a line, as the file has them.

    Attributes
    ----------
    xyz : ndarray of shape (n, 3), frame and unit of the file
        As in the assumptions of the reader.
    time : ndarray of shape (n,), seconds, in the file's time base
    extra : mapping of str to ndarray of shape (n, ...)
        Whatever else the file has, under its own names and types; ``intensity`` where there is one.
    total : int or None
        Number of points in the file, if given in it.
    """

    xyz: NDArray[np.float64]
    time: NDArray[np.float64]
    extra: Mapping[str, NDArray[Any]]
    total: int | None = None


@dataclass(frozen=True)
class FileFormat:
    """A file format with its reader.

    Attributes
    ----------
    name : Message
        As in the dialogue: Applanix SBET.
    key : str
        As in the project file and at the command line: ``sbet``.
    kind : {"trajectory", "accuracy", "points"}
    endings : tuple of str
        Lower case, with the dot.
    options : tuple of FormatOption
    sniff : callable
        Path to how sure the format is that the file is one of its own; reads the beginning alone
        and never fails on whatever bytes it finds.
    preview : callable
        Path and options to a `FilePreview`; reads as little as that takes.
    read : callable
        Path and options to a `Trajectory` or `TrajectoryAccuracy`; for points, to an iterator of
        `PointChunk` of about a million points each.
    read_from : callable or None
        Path, options and the index of a point to the chunks from that point on, where the format
        knows a way that does not read all before it.
    """

    name: Message
    key: str
    kind: Kind
    endings: tuple[str, ...]
    options: tuple[FormatOption, ...]
    sniff: Callable[[Path], float]
    preview: Callable[[Path, Choice], FilePreview]
    read: Callable[[Path, Choice], Trajectory | TrajectoryAccuracy | Iterator[PointChunk]]
    read_from: Callable[[Path, Choice, int], Iterator[PointChunk]] | None = None

    def resolved(self, choice: Choice) -> dict[str, str]:
        """All options: those of ``choice``, and defaults for the others.

        Raises
        ------
        InputError
            Where there is no such option or choice.
        """
        known = {option.name: option for option in self.options}
        for name, value in choice.items():
            if name not in known:
                raise InputError(error("formats.unknown_option", format=self.name, option=name))
            choices = known[name].choices
            if choices and value not in choices:
                raise InputError(
                    error(
                        "formats.invalid_choice", format=self.name, option=name, value=str(value),
                        choices=choices,
                    )
                )  # fmt: skip
        return {name: choice.get(name, option.default) for name, option in known.items()}
