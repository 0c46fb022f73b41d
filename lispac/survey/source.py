"""The files of a survey: where they are and how they are read."""

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Reading:
    """How a file is read.

    Attributes
    ----------
    format : str
        Key of its format; empty for the program's own ways: SBET, smrmsg, LAS or LAZ in the LiDAR
        frame, text with named columns.
    options : tuple of (str, str)
        What the file does not say, as settled when the project was made.
    time_shift : float, seconds
        Added to the times of a line to bring them into the trajectory's time base.
    """

    format: str = ""
    options: tuple[tuple[str, str], ...] = ()
    time_shift: float = 0.0


USUAL = Reading()
"""The program's own way."""


@dataclass(frozen=True)
class LineSource:
    """A raw scan file.

    Attributes
    ----------
    columns : tuple of str
        Names of the columns of a text file; empty for LAS and LAZ.
    """

    name: str
    path: Path
    columns: tuple[str, ...] = ()
    reading: Reading = USUAL
