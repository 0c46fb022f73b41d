"""Settings of the plane search."""

from dataclasses import asdict, dataclass
from math import pi, radians
from typing import Any

from lispac.errors import InputError
from lispac.messages import error

THRESHOLD_LIMITS, RADIUS_LIMITS = (1e-6, 100.0), (1e-3, 1e6)
"""Smallest and largest distance threshold and search radius, metres."""


def is_possible_search(threshold: float, radius: float) -> bool:
    """Whether planes can be searched for with a threshold and a radius, both in metres."""
    return (
        THRESHOLD_LIMITS[0] <= threshold <= THRESHOLD_LIMITS[1]
        and RADIUS_LIMITS[0] <= radius <= RADIUS_LIMITS[1]
    )


@dataclass(frozen=True)
class FinderSettings:
    """Settings of the plane search.

    Attributes
    ----------
    radius : float, metres
        Search radius: only points within this distance of the seed can belong to the patch. Larger
        surfaces, such as a wall or the face of a tower, are cut there.
    threshold : float, metres
        Largest distance of a point from its plane (thesis default 0.01).
    stop : float, in (0, 1)
        RANSAC confidence (thesis default 0.98). Samples are drawn until the probability that at
        least one of them is free of outliers reaches this value, given the share of inliers of the
        best plane so far.
    min_points : int
        Smallest number of points of a patch.
    max_tilt : float, radians, at most pi/2
        Largest angle between the normals of a target in two lines, or between the normal of the
        plane and an expected one.
    max_shift : float, metres
        Largest displacement of a target between two lines with the prior boresight.
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
            ("radius", RADIUS_LIMITS[0] <= self.radius <= RADIUS_LIMITS[1]),
            ("threshold", THRESHOLD_LIMITS[0] <= self.threshold <= THRESHOLD_LIMITS[1]),
            ("stop", 0.0 < self.stop < 1.0),
            ("min_points", self.min_points >= 3),
            ("max_tilt", 0.0 < self.max_tilt <= pi / 2),
            ("max_shift", self.max_shift >= 0.0),
            ("seed", self.seed >= 0),
        ):
            if not good:  # comparisons with NaN are false, so NaN is refused here as well
                raise InputError(error("finder.setting", name=name, value=getattr(self, name)))


@dataclass(frozen=True)
class FinderChoices:
    """Options of the finder besides threshold and radius; stored with a target.

    Attributes
    ----------
    min_points, max_tilt, stop, seed
        See `FinderSettings`.
    """

    min_points: int = FinderSettings.min_points
    max_tilt: float = FinderSettings.max_tilt
    stop: float = FinderSettings.stop
    seed: int = FinderSettings.seed

    def __post_init__(self) -> None:
        self.settings()

    def settings(self, **others: Any) -> FinderSettings:
        """Settings with these choices, and with the other settings given by name.

        Raises
        ------
        InputError
            If the settings are invalid.
        """
        return FinderSettings(**asdict(self), **others)


DEFAULT_CHOICES = FinderChoices()
"""Default choices."""
