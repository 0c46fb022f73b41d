"""Types for the formats of files: options, previews, chunks of points.

A format has a name, file extensions, a function that estimates the likelihood that a file is of
this format, reading options, and functions that read it. The import dialog, the command line and
the tests obtain the formats from the list in `lispac.io.formats` only.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
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
"""Fact found in a file: a text from the file, a count, or a message."""
SAME_TIME_BASE_NOTE = note("assumed.same_time_base")

SURE, LIKELY, POSSIBLE, IMPOSSIBLE = 1.0, 0.7, 0.3, 0.0
"""Likelihoods that a file is of a format: its signature or structure is unique to the format; its
structure and values fit; nothing contradicts the format; it is not of the format."""


@dataclass(frozen=True)
class FormatOption:
    """Reading option that a file does not specify itself.

    Attributes
    ----------
    name : str
        Name in the project file and on the command line.
    meaning : str
        One sentence for the import dialog, marked for translation.
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
        Header entries, counts, time span, frame, unit, time base.
    rows : tuple of tuple of str
        Column names, then the first rows.
    choice : mapping
        Options as detected.
    file_warnings : tuple of Message
        Warnings about how the file is read, to be checked before importing.
    assumptions : tuple of Message
        Assumptions of the reader with these options: frame, unit, signs, time base.
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

    def with_messages(self, messages: Iterable[Message]) -> "FilePreview":
        """Preview with further messages about the content of the file, each only once."""
        return replace(self, messages=tuple(dict.fromkeys((*self.messages, *messages))))


@dataclass(frozen=True, eq=False)
class PointChunk:
    """A chunk of points of a line, as returned by the reader of its format.

    Attributes
    ----------
    xyz : ndarray of shape (n, 3), frame of the file, metres or the unit of its coordinate system
        Metres in the scanner frame.
    time : ndarray of shape (n,), seconds, in the file's time base
    extra : mapping of str to ndarray of shape (n, ...)
        Other attributes with the names and types of the file; ``intensity`` if there is one.
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
        Name in the dialog, for example Applanix SBET.
    key : str
        Name in the project file and on the command line: ``sbet``.
    kind : {"trajectory", "accuracy", "points"}
    endings : tuple of str
        Lower case, with the dot.
    options : tuple of FormatOption
    sniff : callable
        Function of the path that returns the likelihood that the file is of this format. Reads only
        the beginning of the file and raises no error, whatever the file contains.
    preview : callable
        Function of path and options that returns a `FilePreview`; reads as little as possible.
    read : callable
        Function of path and options that returns a `Trajectory` or `TrajectoryAccuracy`; for
        points, an iterator of `PointChunk` of about a million points each.
    read_from : callable or None
        Function of path, options and point index that returns the chunks from that point on without
        reading all points before it; None if the format does not allow this.
    read_messages : callable or None
        Function of path and options that returns the messages of the preview without its values;
        None if this takes as long.
    has_time_base : bool
        Whether the files of a format of trajectories specify their time base. Otherwise it is
        inferred. For a format of points, whether the format defines the base, so that lines are
        shifted to the trajectory without a question; LAS and others may specify it.
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
    read_messages: Callable[[Path, Choice], tuple[Message, ...]] | None = None
    has_time_base: bool = False

    @property
    def infers_time_base(self) -> bool:
        """Whether the time base of its trajectories is inferred."""
        return self.kind == "trajectory" and not self.has_time_base

    def messages(self, path: Path, choice: Choice) -> tuple[Message, ...]:
        """Messages of the preview of a file.

        Raises
        ------
        InputError
            If the file cannot be read.
        """
        if self.read_messages is not None:
            return self.read_messages(path, choice)
        return self.preview(path, choice).messages

    def complete_options(self, choice: Choice) -> dict[str, str]:
        """Complete options: those of ``choice``, and defaults for the others.

        Raises
        ------
        InputError
            If an option or its value does not exist.
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
