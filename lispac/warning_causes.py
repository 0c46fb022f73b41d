"""Cause of a warning: the object that the window opens and selects for the user."""

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
        Name of the line, target, value of the mounting (as in `MOUNTING_VALUE_NAMES`), setting,
        page of the diagnostics or step. Empty for the result as a whole.
    line : str
        Line of a sighting; empty for other kinds.
    """

    kind: CauseKind
    name: str = ""
    line: str = ""

    @classmethod
    def of_line(cls, name: str) -> "Cause":
        """Cause that is a line as a whole."""
        return cls("line", name)

    @classmethod
    def of_target(cls, name: str) -> "Cause":
        """Cause that is a target or validation plane on all its lines."""
        return cls("target", name)

    @classmethod
    def of_sighting(cls, target: str, line: str) -> "Cause":
        """Cause that is a target on one line."""
        return cls("sighting", target, line)

    @classmethod
    def of_parameter(cls, name: str) -> "Cause":
        """Cause that is a value of the mounting that is or could be estimated."""
        return cls("parameter", name)

    @classmethod
    def of_field(cls, name: str) -> "Cause":
        """Cause that is a setting, by its name in the project."""
        return cls("field", name)

    @classmethod
    def of_page(cls, name: str) -> "Cause":
        """Cause that is a page of the diagnostics."""
        return cls("page", name)

    @classmethod
    def of_step(cls, name: str) -> "Cause":
        """Cause that is a step of the workflow."""
        return cls("step", name)


RESULT_CAUSE = Cause("result")
"""Cause that is the result as a whole: the angles and their sigmas."""
