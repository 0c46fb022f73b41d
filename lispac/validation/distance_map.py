"""Map of the signed distances between two lines, over the two axes of their plane.

Unlike a histogram, the map distinguishes a tilt from noise, and a bent board from a POS error. Each
cell has the distance along the normal (M3C2: Lague et al. 2013) at the point nearest to its centre,
in a cylinder as wide as the cell. The distances before and after the calibration are measured at
the same points and drawn at their positions after the calibration.
"""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from lispac.errors import NotComparable
from lispac.geometry.planes import LEVEL_LIMIT_RAD, fit_plane, plane_axes
from lispac.targets.thinning import thin_points
from lispac.untrusted_values import ArrayShape
from lispac.validation.normal_distance import NormalDistances, distances_along_normal

Array = NDArray[np.float64]

CELL_SIDE_PER_SPACING = 4.0
"""Side of a cell as a multiple of the point spacing of the sparser line."""
NORMAL_SPHERE_FACTOR = 2.0
"""Diameter of the sphere of points used for a normal, as a multiple of the side of a cell."""
MAX_CELLS = 1_500
"""Largest number of cells in the rectangle around the common part of two lines."""
STORED_DECIMALS = 6
"""Number of stored decimals of values in metres: micrometres."""


@dataclass(frozen=True, eq=False)
class DistanceMap:
    """Distances of the first line from the second, cell by cell.

    Attributes
    ----------
    line_a, line_b : str
    cell : float, metres
        Side of the square cells.
    across, up : ndarrays of shape (n,), metres
        Centres of the cells that have a distance, relative to the lower left corner as seen from
        the vessel: along the horizontal direction in the plane, and up its slope. On a horizontal
        plane, towards east and towards north.
    before, after : ndarrays of shape (n,), metres
        Positive where the first line lies nearer to the vessel.
    is_horizontal : bool
        Whether the plane is horizontal. False in comparisons of earlier versions.
    """

    line_a: str
    line_b: str
    cell: float
    across: Annotated[Array, ArrayShape("n")]
    up: Annotated[Array, ArrayShape("n")]
    before: Annotated[Array, ArrayShape("n")]
    after: Annotated[Array, ArrayShape("n")]
    is_horizontal: bool = False


def distance_map(
    lines: tuple[str, str],
    ours: tuple[Array, Array],
    theirs: tuple[Array, Array],
    common: NDArray[np.bool_],
    *,
    facing: Array,
    spacing: float,
    reach: tuple[float, float],
) -> DistanceMap | None:
    """Map the distances of the first of two lines from the second.

    Parameters
    ----------
    lines : pair of str
        Names of the lines.
    ours, theirs : pairs of ndarray of shape (n, 3), metres, local frame
        All points of the first and of the second line on the plane, before and after.
    common : ndarray of shape (n,), bool
        Points of the second line in the common part.
    facing : ndarray of shape (3,)
        Direction towards the vessel.
    spacing : float, metres
        Distance between the points of the sparser line in its sparse direction.
    reach : pair of float, metres
        Largest distance between the two lines, before and after.

    Returns
    -------
    DistanceMap, or None if no cell has enough points of both lines
    """
    after = theirs[1][common]
    normal = fit_plane(after).facing(facing).normal
    axes = plane_axes(normal, LEVEL_LIMIT_RAD)
    is_horizontal = bool(np.hypot(normal[0], normal[1]) < np.sin(LEVEL_LIMIT_RAD))
    if is_horizontal:
        axes[0] *= -1.0  # east, which is to the right on a map
    flat = after @ axes.T
    corner = flat.min(axis=0)
    flat = flat - corner
    cell = max(
        CELL_SIDE_PER_SPACING * spacing, float(np.sqrt(np.prod(flat.max(axis=0)) / MAX_CELLS))
    )
    chosen = thin_points(np.column_stack([flat, np.zeros(len(flat))]), cell)
    found: list[NormalDistances] = []
    try:
        for compared, reference, depth in zip(ours, theirs, reach, strict=True):
            found.append(
                distances_along_normal(
                    compared, reference, reference[common][chosen], facing=facing,
                    normal_scale=NORMAL_SPHERE_FACTOR * cell, diameter=cell, depth=depth + cell,
                )
            )  # fmt: skip
    except NotComparable:
        return None
    measured = np.intersect1d(found[0].at, found[1].at)
    if not len(measured):
        return None
    before, after = (
        np.round(state.select_cores(measured).distance, STORED_DECIMALS) for state in found
    )
    middles = cell * (np.floor(flat[chosen[measured]] / cell) + 0.5)
    across, up = np.round(middles, STORED_DECIMALS).T
    return DistanceMap(
        *lines, round(cell, STORED_DECIMALS), across, up, before, after, is_horizontal
    )
