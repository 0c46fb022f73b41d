"""Pairs of lines that the patch test compares."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

Kind = Literal["reciprocal", "crossing", "same direction", "oblique"]

MAX_RECIPROCAL_DEVIATION, MAX_SAME_DIRECTION_DEVIATION = np.radians(20.0), np.radians(20.0)
"""Largest deviation of the headings of a pair from opposite and from equal headings, radians."""
CROSSING_ANGLES = (np.radians(60.0), np.radians(120.0))
"""Smallest and largest angle between the headings of crossing lines, radians."""


@dataclass(frozen=True)
class LinePair:
    """Names of two lines, and the relation of their headings.

    Attributes
    ----------
    first, second : str
    kind : {"reciprocal", "crossing", "same direction", "oblique"}
    """

    first: str
    second: str
    kind: Kind

    @property
    def lines(self) -> tuple[str, str]:
        """Both names."""
        return self.first, self.second

    @property
    def name(self) -> str:
        """Name as displayed."""
        return f"{self.first} / {self.second}"


def pair_kind(first: float, second: float) -> Kind:
    """Relation of two lines by their headings.

    Parameters
    ----------
    first, second : float, radians
        Headings of the vessel while it scanned the same object.
    """
    between = abs((first - second + np.pi) % (2 * np.pi) - np.pi)
    if between >= np.pi - MAX_RECIPROCAL_DEVIATION:
        return "reciprocal"
    if between <= MAX_SAME_DIRECTION_DEVIATION:
        return "same direction"
    if CROSSING_ANGLES[0] <= between <= CROSSING_ANGLES[1]:
        return "crossing"
    return "oblique"


def pairs_of_lines(heading: Mapping[str, float]) -> tuple[LinePair, ...]:
    """All pairs of lines, reciprocal ones first.

    Parameters
    ----------
    heading : mapping of line name to radians
    """
    order = ("reciprocal", "crossing", "oblique", "same direction")
    found = [LinePair(a, b, pair_kind(heading[a], heading[b])) for a, b in combinations(heading, 2)]
    return tuple(sorted(found, key=lambda pair: order.index(pair.kind)))
