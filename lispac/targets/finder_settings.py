"""Settings of the plane search."""

from dataclasses import asdict, dataclass
from math import pi, radians
from typing import Any

from lispac.errors import InputError
from lispac.messages import error

THRESHOLDS, RADII = (1e-6, 100.0), (1e-3, 1e6)
"""Least and largest distance threshold and search radius, metres."""


def is_possible_search(threshold: float, radius: float) -> bool:
    """Whether planes can be searched for with a threshold and a radius, both in metres."""
    return THRESHOLDS[0] <= threshold <= THRESHOLDS[1] and RADII[0] <= radius <= RADII[1]


@dataclass(frozen=True)
class FinderSettings:
    """Settings of the plane search.

    Attributes
    ----------
    radius : float, metres
        Only points this near to the seed can belong to the patch. A wide surface, a wall or a
        tower face, is cut there.
    threshold : float, metres
        Farthest a point may lie from its plane (thesis default 0.01).
    stop : float, in (0, 1)
        Stop criterion (thesis default 0.98). Planes are drawn until the probability of having
        drawn one free of outliers, given the share of the points near the seed that the best
        plane so far holds, reaches this value.
    min_points : int
        Smallest patch that counts as found.
    max_tilt : float, radians, at most a right angle
        Largest angle between a target in one line and the same target in another, or between
        the plane and an expected normal.
    max_shift : float, metres
        Farthest the prior boresight may displace a target from one line to another.
    seed : int
        Seed of the random draws, 0 or more: the same points and settings give the same patch.
    """

    radius: float = 2.0
    threshold: float = 0.01
    stop: float = 0.98
    min_points: int = 30
    max_tilt: float = radians(15.0)
    max_shift: float = 2.5
    seed: int = 0

    def __post_init__(self) -> None:
        for name, good in (
            ("radius", RADII[0] <= self.radius <= RADII[1]),
            ("threshold", THRESHOLDS[0] <= self.threshold <= THRESHOLDS[1]),
            ("stop", 0.0 < self.stop < 1.0),
            ("min_points", self.min_points >= 3),
            ("max_tilt", 0.0 < self.max_tilt <= pi / 2),
            ("max_shift", self.max_shift >= 0.0),
            ("seed", self.seed >= 0),
        ):
            if not good:  # a NaN fails every comparison, so it ends here too
                raise InputError(error("finder.setting", name=name, value=getattr(self, name)))


@dataclass(frozen=True)
class FinderChoices:
    """Options of the finder besides threshold and radius; stored with a target.

    Attributes
    ----------
    min_points, max_tilt, stop, seed
        As of `FinderSettings`.
    """

    min_points: int = FinderSettings.min_points
    max_tilt: float = FinderSettings.max_tilt
    stop: float = FinderSettings.stop
    seed: int = FinderSettings.seed

    def __post_init__(self) -> None:
        self.settings()

    def settings(self, **others: Any) -> FinderSettings:
        """Settings with these choices.

        Raises
        ------
        InputError
            Where the finder cannot work with them.
        """
        return FinderSettings(**asdict(self), **others)


USUAL = FinderChoices()
"""Default choices."""
