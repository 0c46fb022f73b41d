"""Proposed objects of a patch test: boxes around surfaces that several lines see.

Lines disagree most, for a given error of an angle, at surfaces with a suitable orientation and
position. The proposal therefore selects the natural planes that determine the angles best
(`lispac.natural.patch_choice`), and puts a box around each. Users can define further objects, such
as a pole, a pillar or the corner of a wall.
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

MAX_OBJECTS = 30
"""Largest number of proposed objects."""
MAX_BOX_SIDE, BOX_DEPTH = 4.0, 1.0
"""Largest side of a box along its surface, and side across the surface, metres."""
MIN_BOX_SIDE = 0.6
"""Smallest side of a box along its surface, metres."""
MIN_LEVEL_NORMAL_UP = 0.7
"""Smallest absolute vertical component of the unit normal of a surface that counts as level."""
MAX_SURFACE_DISTANCE = 0.06
"""Largest distance of a line from the surface, metres, unless three LiDAR sigmas are larger."""


def find_objects(
    clouds: Mapping[str, Cloud],
    accuracy: TrajectoryAccuracy,
    noise: float,
    *,
    count: int = MAX_OBJECTS,
    progress: Progress = no_progress,
) -> tuple[PatchObject, ...]:
    """Propose objects that are seen in several lines.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        Georeferenced well enough that the lines nearly agree.
    accuracy : TrajectoryAccuracy
    noise : float, metres
        Sigma of the LiDAR.
    count : int
        Largest number of objects.
    """
    patches = find_patches(
        clouds,
        noise,
        max(MAX_SURFACE_DISTANCE, 3 * noise),
        progress=sub_progress(progress, 0.0, 0.8),
    )
    found: list[PatchObject] = []
    progress(0.8)
    for rows in choose_patches(patches, clouds, accuracy, count).rows:
        normal = patches.normal[patches.patch[rows[0]]]
        wide = float(np.clip(2 * patches.planes.reach[rows].max(), MIN_BOX_SIDE, MAX_BOX_SIDE))
        level = abs(normal[2]) >= MIN_LEVEL_NORMAL_UP
        size = np.array([wide, wide, BOX_DEPTH] if level else [BOX_DEPTH, wide, wide])
        turn = float(np.arctan2(-normal[1], normal[0]))
        centre = np.asarray(patches.planes.centre[rows].mean(axis=0))
        found.append(PatchObject(f"A{len(found) + 1:02d}", ObjectBox(centre, size, turn)))
    return tuple(found)
