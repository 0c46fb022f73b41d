"""Distances between two lines where the scene is flat, without calibration.

The method corresponds to the relative accuracy of airborne surveys in the overlap of swaths
(Heidemann 2018, USGS Lidar Base Specification: "interswath accuracy, smooth surface"). Here
distances are measured along the normal instead of vertically, so that walls can be used as well as
ground: in cylinders along the normal of the first line (M3C2: Lague et al. 2013), to the nearest
surface of the second line.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import NotComparable
from lispac.geometry.point_tree import PointTree
from lispac.messages import error
from lispac.validation.cylinder_diameters import (
    DIAMETER_FACTOR,
    MAX_DIAMETER_M,
    candidate_places,
    cylinder_diameters,
    select_separate_places,
    twelfth_neighbour_distance,
)
from lispac.validation.normal_distance import SIGMA_PER_MAD
from lispac.validation.reference_places import (
    NORMAL_SPHERE_FACTOR,
    is_reference_flat,
    measure_to_surface,
)

Array = NDArray[np.float64]

Facing = Literal["all", "level", "upright", "sloped"]
FACINGS: tuple[Facing, ...] = ("all", "level", "upright", "sloped")
"""Orientations of surfaces: all, ground, walls, and those in between."""
MIN_GROUND_NORMAL_UP, MAX_WALL_NORMAL_UP = np.cos(np.radians(10.0)), np.sin(np.radians(10.0))
"""Limits of the vertical component of the normal: slopes up to 10 deg are ground, as in the USGS
specification; surfaces within 10 deg of the vertical are walls."""
MAX_LINE_POINTS = 300_000
"""Largest number of points of a line that are used: every n-th point of the line."""


@dataclass(frozen=True, eq=False)
class LineDifference:
    """Signed distances of the first of two lines from the second, at common places.

    Attributes
    ----------
    first, second : str
    place : ndarray of shape (n, 3), metres, local frame
    distance : ndarray of shape (n,), metres
        Along the normal, positive where the first line is nearer to the vessel, as on validation
        planes.
    half_width : ndarray of shape (n,), metres
        Half the 95 % interval, from the noise of the points.
    normal : ndarray of shape (n, 3), unit vectors, local frame
    """

    first: str
    second: str
    place: Array
    distance: Array
    half_width: Array
    normal: Array

    def facing(self, facing: Facing) -> "LineDifference":
        """Differences on surfaces of one orientation."""
        up = np.abs(self.normal[:, 2])
        own = {
            "all": np.ones(len(up), dtype=bool),
            "level": up >= MIN_GROUND_NORMAL_UP,
            "upright": up <= MAX_WALL_NORMAL_UP,
            "sloped": (up < MIN_GROUND_NORMAL_UP) & (up > MAX_WALL_NORMAL_UP),
        }[facing]
        return LineDifference(
            self.first, self.second, self.place[own], self.distance[own], self.half_width[own],
            self.normal[own],
        )  # fmt: skip


@dataclass(frozen=True)
class DifferenceStatistics:
    """Statistics of the differences at some places.

    Attributes
    ----------
    places : int
    median : float or None, metres
        Median along the normal, positive if the first line is nearer to the vessel; None for
        several pairs, for which the sign has no meaning.
    rmsd : float, metres
        Root mean square of the differences.
    robust_sigma : float or None, metres
        1.4826 times the median absolute deviation from the median; None if there is no median.
    p95, largest : float, metres
        95th percentile and maximum of the absolute differences.
    significant : float, in [0, 1]
        Share of the places whose difference exceeds the half-width of its 95 % interval.
    """

    places: int
    median: float | None
    rmsd: float
    robust_sigma: float | None
    p95: float
    largest: float
    significant: float

    @classmethod
    def of(cls, distance: Array, half_width: Array) -> "DifferenceStatistics":
        """Summarise the differences at some places.

        Parameters
        ----------
        distance, half_width : ndarray of shape (n,), metres
            Differences, and half-widths of their 95 % intervals.
        """
        size, median = np.abs(distance), float(np.median(distance))
        return cls(
            len(distance),
            median,
            float(np.sqrt(np.mean(distance**2))),
            SIGMA_PER_MAD * float(np.median(np.abs(distance - median))),
            float(np.percentile(size, 95.0)),
            float(size.max()),
            float(np.mean(size > half_width)),
        )


def compare_lines(
    first: tuple[str, Array],
    second: tuple[str, Array],
    vessel: Array,
    *,
    noise: float,
    reach: float,
) -> LineDifference:
    """Compare two lines wherever the first is flat and the second has points nearby.

    Parameters
    ----------
    first, second : name, and ndarray of shape (n, 3), metres, local frame
        Finite points.
    vessel : ndarray of shape (3,), metres, local frame
        Position on the side from which surfaces are observed.
    noise : float, metres
        Sigma of the LiDAR.
    reach : float, metres
        Largest possible distance between the lines.

    Raises
    ------
    NotComparable
        If the lines have no flat place in common.
    """
    (one, surface), (other, points) = first, second
    surface, points = (each[:: -(-len(each) // MAX_LINE_POINTS) or 1] for each in (surface, points))
    places = candidate_places(surface)
    diameters = cylinder_diameters(PointTree(points), places, reach)
    near = np.flatnonzero(np.isfinite(diameters))
    if not len(near):
        raise NotComparable(
            error("validation.no_place_in_common", line=one, other=other, reach=reach)
        )
    own_diameters = np.minimum(
        DIAMETER_FACTOR * twelfth_neighbour_distance(PointTree(surface), places[near]),
        MAX_DIAMETER_M,
    )
    selected, widths = select_separate_places(
        places[near], np.maximum(diameters[near], own_diameters)
    )
    cores = places[near][selected]
    roughest = 3 * noise
    flat = is_reference_flat(surface, cores, NORMAL_SPHERE_FACTOR * widths, roughest)
    if not flat.any():
        raise NotComparable(error("validation.no_flat_place", line=one, other=other))
    cores, widths = cores[flat], widths[flat]
    try:
        found = measure_to_surface(
            points, points, surface, cores, facing=vessel - cores, diameters=widths, reach=reach,
            roughest=roughest,
        ).before  # fmt: skip
    except NotComparable as reason:  # about one line and a reference
        raise NotComparable(error("validation.no_flat_place", line=one, other=other)) from reason
    return LineDifference(one, other, found.cores, -found.distance, found.half_width, found.normals)
