"""Cause of a warning, which the window opens, selects and shows."""

from dataclasses import dataclass
from typing import Literal

CauseKind = Literal["line", "target", "sighting", "parameter", "field", "page", "step", "result"]


@dataclass(frozen=True)
class Cause:
    """Object that a warning is about.

    Attributes
    ----------
    kind : {"line", "target", "sighting", "parameter", "field", "page", "step", "result"}
    name : str
        Of the line or target; of a value of the mounting, as `CALIBRATION` has it; of a setting; of
        a page of the diagnostics; of a step. Empty for the result as a whole.
    line : str
        Of a sighting.
    """

    kind: CauseKind
    name: str = ""
    line: str = ""

    @classmethod
    def of_line(cls, name: str) -> "Cause":
        """A line as a whole."""
        return cls("line", name)

    @classmethod
    def of_target(cls, name: str) -> "Cause":
        """A target or validation plane on all its lines."""
        return cls("target", name)

    @classmethod
    def of_sighting(cls, target: str, line: str) -> "Cause":
        """A target on one line."""
        return cls("sighting", target, line)

    @classmethod
    def of_parameter(cls, name: str) -> "Cause":
        """A value of the mounting that is estimated, or could be."""
        return cls("parameter", name)

    @classmethod
    def of_field(cls, name: str) -> "Cause":
        """A setting, by its name in the project."""
        return cls("field", name)

    @classmethod
    def of_page(cls, name: str) -> "Cause":
        """A page of the diagnostics."""
        return cls("page", name)

    @classmethod
    def of_step(cls, name: str) -> "Cause":
        """A step of the work."""
        return cls("step", name)


RESULT = Cause("result")
"""The result as a whole: the angles and their sigmas."""
