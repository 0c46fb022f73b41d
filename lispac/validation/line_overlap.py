"""Points of a line that are comparable with another line, and sparsity of the lines."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.validation.footprint import Footprint, common_plane_frame

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]


class LineOverlap:
    """Which points of one line lie inside another line's footprint in both states.

    Parameters
    ----------
    before, after : mapping of line name to ndarray of shape (n, 3), metres, local frame
        The same points in the same order.
    """

    def __init__(self, before: Mapping[str, Array], after: Mapping[str, Array]) -> None:
        self._states: list[tuple[dict[str, Array], dict[str, Footprint]]] = []
        for clouds in (before, after):
            origin, axes = common_plane_frame(list(clouds.values()))
            flat = {line: (cloud - origin) @ axes.T for line, cloud in clouds.items()}
            self._states.append((flat, {line: Footprint(uv) for line, uv in flat.items()}))
        self.normal: Array = np.cross(axes[0], axes[1])
        """Of the plane after, shape (3,), of either sign."""

    def of(self, line: str, other: str) -> Bools:
        """Mask (n,) over the points of ``line``."""
        masks = [footprints[other].contains(flat[line]) for flat, footprints in self._states]
        both: Bools = masks[0] & masks[1]
        return both

    def spacing(self, *lines: str) -> float:
        """Distance between neighbouring points where they are sparse, of the sparsest, metres."""
        return max(self._states[-1][1][line].cell for line in lines)
