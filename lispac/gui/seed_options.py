"""What the next seed is to make, as the panel of the targets has it."""

from dataclasses import dataclass
from typing import Any

from lispac.project import Role, Shape
from lispac.targets.expected import ExpectedTarget
from lispac.targets.settings import USUAL, FinderChoices


@dataclass(frozen=True)
class SeedOptions:
    """Options of the target search.

    Attributes
    ----------
    line : the only line to search, or None for all
    selected : name of the selected target; with ``line`` it gets the sighting
    threshold, radius : metres, None for the usual ones
    """

    role: Role = "target"
    line: str | None = None
    selected: str | None = None
    threshold: float | None = None
    radius: float | None = None
    shape: Shape = "plane"
    sphere_radius: float | None = None
    expected: ExpectedTarget | None = None
    choices: FinderChoices = USUAL

    @property
    def how(self) -> dict[str, Any]:
        """For `lispac.workflow.picking.find`: the search settings, without names."""
        return {
            "shape": self.shape, "sphere_radius": self.sphere_radius, "expected": self.expected,
            "threshold": self.threshold, "radius": self.radius, "choices": self.choices,
        }  # fmt: skip
