"""Proposed objects: places where lines see the same surface.

A surveyor selects a pole, a pillar, the corner of a wall. What counts of them is what moves apart
when an angle is wrong, so natural surfaces are taken that determine the angles best, upright
and level ones (`lispac.natural`), and a box is laid about each.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.natural.patch_choice import choose_patches
from lispac.natural.patches import find_patches
from lispac.patchtest.object_boxes import ObjectBox, PatchObject
from lispac.progress import Progress, no_progress, sub_progress
from lispac.survey.cloud import Cloud
from lispac.survey.trajectory import TrajectoryAccuracy

Array = NDArray[np.float64]

OBJECT_COUNT = 30
"""Objects that are proposed where there are so many."""
LARGEST, DEEP = 4.0, 1.0
"""Sides of a box about a surface, metres: along it at most, and across it."""
SMALLEST = 0.6
"""Least side, metres."""
UPRIGHT = 0.7
"""Upward part of a normal from which on a surface is level rather than upright."""
MAX_DISTANCE = 0.06
"""Farthest that a line may be off the surface, metres."""


def find_objects(
    clouds: Mapping[str, Cloud],
    accuracy: TrajectoryAccuracy,
    noise: float,
    *,
    count: int = OBJECT_COUNT,
    progress: Progress = no_progress,
) -> tuple[PatchObject, ...]:
    """Propose objects that lines share.

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
    patches = find_patches(
        clouds, noise, max(MAX_DISTANCE, 3 * noise), progress=sub_progress(progress, 0.0, 0.8)
    )
    found: list[PatchObject] = []
    progress(0.8)
    for rows in choose_patches(patches, clouds, accuracy, count).rows:
        normal = patches.normal[patches.patch[rows[0]]]
        wide = float(np.clip(2 * patches.planes.reach[rows].max(), SMALLEST, LARGEST))
        level = abs(normal[2]) >= UPRIGHT
        size = np.array([wide, wide, DEEP] if level else [DEEP, wide, wide])
        turn = float(np.arctan2(-normal[1], normal[0]))
        centre = np.asarray(patches.planes.centre[rows].mean(axis=0))
        found.append(PatchObject(f"A{len(found) + 1:02d}", ObjectBox(centre, size, turn)))
    return tuple(found)
