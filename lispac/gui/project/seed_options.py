"""Options of the next seed, as set in the panel of the targets."""

from dataclasses import dataclass
from typing import Any

from lispac.project import Role, Shape
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices


@dataclass(frozen=True)
class SeedOptions:
    """Target to search for, and the options of the search.

    Attributes
    ----------
    line : the only line to search, or None for all lines
    selected : name of the selected target, to which the sighting is added if ``line`` is given
    threshold, radius : metres; None for the default
    """

    role: Role = "target"
    line: str | None = None
    selected: str | None = None
    threshold: float | None = None
    radius: float | None = None
    shape: Shape = "plane"
    sphere_radius: float | None = None
    expected: ExpectedTarget | None = None
    choices: FinderChoices = DEFAULT_CHOICES

    @property
    def finder_arguments(self) -> dict[str, Any]:
        """Options for `picking.find_target`, independent of the target's name."""
        return {
            "shape": self.shape, "sphere_radius": self.sphere_radius, "expected": self.expected,
            "threshold": self.threshold, "radius": self.radius, "choices": self.choices,
        }  # fmt: skip
