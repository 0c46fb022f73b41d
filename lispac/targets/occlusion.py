"""Visible share of a target in a sighting, compared with the other lines.

If a post hides half of a board, the other half still forms a patch with a complete outline. Only
the comparison with other lines shows that a part is occluded.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import fit_plane, plane_axes
from lispac.messages import Message, note

Array = NDArray[np.float64]

MAX_EXTENT_RATIO = 1.5
"""Extent of a plane, in search radii, from which on the search radius cuts the plane."""
VISIBLE_SHARE_LIMITS = (0.7, 0.5)
"""Visible shares below which a sighting is doubtful and poor; the same limits apply where points
are missing inside the outline."""
MIN_OTHER_LINES = 3
"""Smallest number of other lines for which a single far larger extent is considered wrong."""


@dataclass(frozen=True, eq=False)
class ObservedExtent:
    """Extent of a target in one line, compared with the other lines.

    Attributes
    ----------
    size, size_in_others : ndarray of shape (2,), metres
        Width (horizontal) and height (up the slope) in this line and in the other lines.
    share : float, in [0, 1]
        Share of the extent in the other lines that this line shows.
    is_far_larger : bool
        Whether this line shows far more than each of several other lines.
    """

    size: Array
    size_in_others: Array
    share: float
    is_far_larger: bool

    @property
    def message(self) -> Message:
        """Message that the line shows less than the other lines, or implausibly more."""
        width, height = (
            (float(here), float(there))
            for here, there in zip(self.size, self.size_in_others, strict=True)
        )
        sides = []
        if self.is_far_larger:
            if width[0] > width[1]:
                sides.append(note("quality.width_alone", here=width[0], there=width[1]))
            if height[0] > height[1]:
                sides.append(note("quality.height_alone", here=height[0], there=height[1]))
            return note("quality.shows_more", sides=sides)
        if width[0] < 0.9 * width[1]:
            sides.append(note("quality.width_of", here=width[0], there=width[1]))
        if height[0] < 0.9 * height[1]:
            sides.append(note("quality.height_of", here=height[0], there=height[1]))
        return note("quality.shows_less", share=self.share, sides=sides)


def does_plane_end_within(radius: float, extents: Sequence[Array]) -> bool:
    """Whether a plane ends within the search radius, by its extents on the lines, in metres."""
    return max(float(extent.max()) for extent in extents) < MAX_EXTENT_RATIO * radius


def compare_observed_extents(
    sightings: Sequence[Array], reliable: Sequence[bool], separation: float
) -> tuple[ObservedExtent | None, ...]:
    """Compare the extent of a plane in each line with that in the other lines.

    Parameters
    ----------
    sightings : sequence of ndarray of shape (n, 3), metres
        Points of the plane in each line; the lines nearly coincide.
    reliable : sequence of bool
        Whether each sighting is reliable, so that others may be compared with it.
    separation : float, metres
        Remaining displacement between two lines.

    Returns
    -------
    tuple of ObservedExtent or None
        None if there is no other line to compare with.

    Raises
    ------
    PlaneNotFound
        If the points of a line form no plane.
    """
    normals = np.stack([fit_plane(points).normal for points in sightings])
    normals *= np.where(normals @ normals[0] < 0.0, -1.0, 1.0)[:, None]
    normal = normals.mean(axis=0)
    axes = plane_axes(normal / np.linalg.norm(normal))
    placed = [points @ axes.T for points in sightings]
    low = np.stack([points.min(axis=0) for points in placed])
    high = np.stack([points.max(axis=0) for points in placed])
    size = high - low
    found: list[ObservedExtent | None] = []
    for k in range(len(placed)):
        others = np.flatnonzero([j != k and used for j, used in enumerate(reliable)])
        if not len(others):
            found.append(None)
            continue
        areas = size[others].prod(axis=1)
        largest, enough = float(areas.max()), len(others) >= MIN_OTHER_LINES
        is_far_larger = enough and largest < VISIBLE_SHARE_LIMITS[0] * float(size[k].prod())
        all_but_largest = np.delete(others, areas.argmax())
        if (
            enough
            and float(size[all_but_largest].prod(axis=1).max()) < VISIBLE_SHARE_LIMITS[0] * largest
        ):
            others = all_but_largest
        # Each line may show another part of it; where they do not quite meet, together they
        # seem to show more than there is.
        together = high[others].max(axis=0) - low[others].min(axis=0) - 2.0 * separation
        size_in_others = np.maximum(size[others].max(axis=0), together)
        share = np.minimum(size[k] / np.maximum(size_in_others, 1e-9), 1.0).prod()
        found.append(ObservedExtent(size[k], size_in_others, float(share), is_far_larger))
    return tuple(found)
