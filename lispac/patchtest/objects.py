"""Objects found by themselves: places where lines see the same surface.

A surveyor looks for a pole, a pillar, the corner of a wall. What counts of them is what moves apart
when an angle is wrong, so natural surfaces are taken that tell most of the three angles, upright
and level ones (`lispac.natural`), and a box is laid about each.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.natural.choice import chosen
from lispac.natural.patches import patches_of
from lispac.patchtest.boxes import Box, PatchObject
from lispac.progress import Progress, no_progress, part
from lispac.survey.cloud import Cloud
from lispac.survey.trajectory import TrajectoryAccuracy

Array = NDArray[np.float64]

COUNT = 30
"""Objects that are proposed where there are so many."""
LARGEST, DEEP = 4.0, 1.0
"""Sides of a box about a surface, metres: along it at most, and across it."""
SMALLEST = 0.6
"""Least side, metres."""
UPRIGHT = 0.7
"""Upward part of a normal from which on a surface is level rather than upright."""
OFF = 0.06
"""Farthest that a line may be off the surface, metres."""


def proposed(
    clouds: Mapping[str, Cloud],
    accuracy: TrajectoryAccuracy,
    noise: float,
    *,
    count: int = COUNT,
    progress: Progress = no_progress,
) -> tuple[PatchObject, ...]:
    """Objects that lines share.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        Placed so that they nearly meet.
    accuracy : TrajectoryAccuracy
    noise : float, metres
        Sigma of the LiDAR.
    count : int
        Most of them.
    """
    patches = patches_of(clouds, noise, max(OFF, 3 * noise), progress=part(progress, 0.0, 0.8))
    found: list[PatchObject] = []
    progress(0.8)
    for rows in chosen(patches, clouds, accuracy, count).rows:
        normal = patches.normal[patches.patch[rows[0]]]
        wide = float(np.clip(2 * patches.planes.reach[rows].max(), SMALLEST, LARGEST))
        level = abs(normal[2]) >= UPRIGHT
        size = np.array([wide, wide, DEEP] if level else [DEEP, wide, wide])
        turn = float(np.arctan2(-normal[1], normal[0]))
        centre = np.asarray(patches.planes.centre[rows].mean(axis=0))
        found.append(PatchObject(f"A{len(found) + 1:02d}", Box(centre, size, turn)))
    return tuple(found)
