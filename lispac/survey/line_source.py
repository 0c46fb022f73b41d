"""Files of a survey: their location and how they are read."""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.former_names import accept_script_names, renamed_options
from lispac.survey.time_rollover import resolve_rollover, restore_rollover

TIME_ROLLOVER_OPTION = "time_rollover"
"""Name of the option for the time rollover of a line, which all point formats have."""
INVALID_SURROGATES = re.compile(r"[\ud800-\udc7f\udd00-\udfff]")
"""Pattern of surrogates that do not represent a byte of a file name in Python."""


def printable(name: str) -> str:
    """A file name as text that can be shown and stored: bytes that are not UTF-8 are replaced."""
    whole = INVALID_SURROGATES.sub("\ufffd", name)
    return whole.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


@accept_script_names
@dataclass(frozen=True)
class Reading:
    """Options for reading a file.

    Attributes
    ----------
    format : str
        Key of the format; empty for the default formats: SBET, smrmsg, LAS or LAZ in the LiDAR
        frame, text with named columns.
    options : tuple of (str, str)
        Information that the file does not contain, determined when the project was created.
    time_shift : float, seconds
        Added to the times of a line to bring them into the trajectory's time base.
    """

    format: str = ""
    options: tuple[tuple[str, str], ...] = ()
    time_shift: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "options", renamed_options(self.options))

    @property
    def time_rollover(self) -> str:
        """Kind of the time rollover of a line, such as midnight; empty if there is none."""
        return dict(self.options).get(TIME_ROLLOVER_OPTION, "")

    def to_trajectory_time(self, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """Convert times (n,) of a line, seconds, from its file to the trajectory's time base."""
        resolved = resolve_rollover(times, self.time_rollover)
        return resolved + self.time_shift if self.time_shift else resolved

    def to_file_time(self, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """The inverse of `to_trajectory_time`, except for rounding."""
        return restore_rollover(
            times - self.time_shift if self.time_shift else times, self.time_rollover
        )


DEFAULT_READING = Reading()
"""Default: no options and no time shift."""


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
    reading: Reading = DEFAULT_READING
