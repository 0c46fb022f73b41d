"""Automatic detection of planes and search for them in every line.

Flat patches are detected in every line. Patches of several lines at about the same place are
considered one surface. For each surface, a point near its centre is used like a clicked seed:
`planes_across_lines.find_in_lines` searches for the plane in all lines.
"""

import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from lispac.errors import TargetNotFound
from lispac.language import gettext_lazy
from lispac.messages import Message
from lispac.progress import Progress, no_progress, sub_progress, without_steps
from lispac.targets.flat_patches import FlatPatch, find_flat_patches, voxel_side
from lispac.targets.plane_finder import FinderSettings, PlanePatch
from lispac.targets.planes_across_lines import find_in_lines

Array = NDArray[np.float64]

PatchesAndReasons = tuple[Mapping[str, PlanePatch], Mapping[str, Message]]
"""Patch of each line, and reason for each line without one."""
PlaneSearch = Callable[[Array, str, Progress], PatchesAndReasons]
"""Search for the plane at a seed in all lines, starting with the line of this name."""


class IndexedPoints(Protocol):
    """Points that can be accessed by index: an array, or a line on disk."""

    def __getitem__(self, indices: NDArray[np.int64], /) -> Array: ...


# Side of the voxels of the coarse search, metres; a board of half a metre still covers 25 voxels.
COARSE_VOXEL_SIDE = 0.1
# Smallest area (square metres) and mean width (metres) of a candidate: posts and rails
# are narrow strips.
MIN_AREA, MIN_WIDTH = 0.4, 0.3
# Largest number of surfaces searched for in the lines. A smeared or rough surface is detected in
# pieces that differ between lines; pieces of a surface that was already found do not count.
MAX_SURFACES = 12
# Area, square metres, above which larger surfaces are not preferred, since the search radius cuts
# them.
MAX_RANKED_AREA = 12.0
# Share of common points from which on two planes are considered the same.
MIN_COMMON_POINT_SHARE = 0.2


@dataclass(frozen=True, eq=False)
class DetectedPlane:
    """A plane that several lines show.

    Attributes
    ----------
    seed : ndarray of shape (3,), metres, local
    line : str
        Line of which the seed is a point.
    area : float, square metres
        Area of the whole surface in this line, including parts beyond the search radius.
    found : mapping of line name to PlanePatch
    missing : mapping of line name to Message
        Reason why the plane was not found in a line.
    """

    seed: Array
    line: str
    area: float
    found: Mapping[str, PlanePatch]
    missing: Mapping[str, Message]

    @property
    def centre(self) -> Array:
        """Mean of the centres of the sightings, shape (3,), metres, local frame."""
        return np.asarray(np.mean([patch.centre for patch in self.found.values()], axis=0))


def detect_planes(
    clouds: Mapping[str, Array],
    settings: FinderSettings,
    *,
    lines: Mapping[str, IndexedPoints] | None = None,
    find: PlaneSearch | None = None,
    max_surfaces: int = MAX_SURFACES,
    progress: Progress = no_progress,
) -> tuple[DetectedPlane, ...]:
    """Detect planes that at least two lines show, those on most lines first.

    Parameters
    ----------
    clouds : mapping of line name to ndarray of shape (n, 3), metres, one local frame
        Placed with the prior boresight; for lines on disk, a sample.
    settings : FinderSettings
    lines : mapping of line name to points by their index, optional
        Points that the indices of the planes refer to; by default ``clouds``.
    find : callable, optional
        Searches for the plane at a seed, shape (3,), in all lines, starting with the named one; by
        default `planes_across_lines.find_in_lines` in ``clouds``.
    max_surfaces : int
        Largest number of surfaces to search for in the lines.
    """
    lines = clouds if lines is None else lines
    find = find or (
        lambda seed, line, step: find_in_lines(
            clouds, seed, settings, first_line=line, progress=step
        )
    )
    voxel = voxel_side(settings.threshold, COARSE_VOXEL_SIDE)
    progress(0.0, gettext_lazy("Detecting planes in every line"))
    with ThreadPoolExecutor(max(1, min(os.cpu_count() or 1, len(clouds)))) as pool:
        planes = pool.map(
            lambda cloud: find_flat_patches(cloud, settings.threshold, voxel=voxel).patches,
            clouds.values(),
        )
        patches = {
            name: [patch for patch in found if _is_large_enough(patch)]
            for name, found in zip(clouds, planes, strict=True)
        }
    detected: list[DetectedPlane] = []
    surfaces = _distinct_surfaces(patches, settings)
    followed, max_surfaces = 0, min(max_surfaces, len(surfaces))
    for line, patch in surfaces:
        if followed == max_surfaces:
            break
        # The centre of a surface may be a hole, so the point nearest to it is used.
        seed = patch.points[np.argmin(np.linalg.norm(patch.points - patch.centre, axis=1))]
        if any(
            _plane_contains_seed(plane, lines[line], line, seed, settings) for plane in detected
        ):
            continue
        start, stop = (0.4 + 0.6 * (followed + k) / max_surfaces for k in (0, 1))
        followed += 1
        text = gettext_lazy(
            "Searching for plane {number:n} of at most {count:n} in every line",
            number=followed, count=max_surfaces,
        )  # fmt: skip
        progress(start, text)
        try:
            found, missing = find(seed, line, without_steps(sub_progress(progress, start, stop)))
        except TargetNotFound:
            continue
        if len(found) >= 2 and not any(_are_planes_equal(plane.found, found) for plane in detected):
            detected.append(DetectedPlane(seed, line, patch.area, found, missing))
    progress(1.0)
    return tuple(sorted(detected, key=lambda plane: (-len(plane.found), -plane.area)))


def _is_large_enough(patch: FlatPatch) -> bool:
    return patch.area >= MIN_AREA and patch.area / patch.extent.max() >= MIN_WIDTH


def _distinct_surfaces(
    patches: Mapping[str, list[FlatPatch]], settings: FinderSettings
) -> list[tuple[str, FlatPatch]]:
    """One patch of each surface, ordered by the number of lines that show it, then by area."""
    every = [(line, patch) for line, own in patches.items() for patch in own]
    shown = []
    for _, patch in every:
        alike = {
            line
            for line, other in every
            if np.linalg.norm(other.centre - patch.centre) <= settings.max_shift
            and other.plane.tilt_to(patch.plane) <= settings.max_tilt
            and 0.3 <= other.area / patch.area <= 3.0
        }
        shown.append(len(alike))
    order = sorted(
        range(len(every)), key=lambda k: (-shown[k], -min(every[k][1].area, MAX_RANKED_AREA))
    )
    kept: list[tuple[str, FlatPatch]] = []
    for k in order:
        line, patch = every[k]
        if not any(_are_likely_one_surface(patch, other, line == of) for of, other in kept):
            kept.append((line, patch))
    return kept


def _are_likely_one_surface(patch: FlatPatch, other: FlatPatch, same_line: bool) -> bool:
    """Whether two patches are likely the same surface, if lines may be displaced by a metre."""
    if same_line:
        return patch is other
    distance = float(np.linalg.norm(patch.centre - other.centre))
    # A tilt of three degrees and a shift of one metre between lines are common.
    return (
        distance <= max(1.2, 0.25 * float(other.extent.max()))
        and 0.4 <= patch.area / other.area <= 2.5
        and np.degrees(patch.plane.tilt_to(other.plane)) <= 8.0
    )


def _plane_contains_seed(
    plane: DetectedPlane, points: IndexedPoints, line: str, seed: Array, settings: FinderSettings
) -> bool:
    patch = plane.found.get(line)
    if patch is None or abs(float(patch.plane.distances(seed))) > settings.threshold:
        return False
    return float(np.linalg.norm(points[patch.indices] - seed, axis=1).min()) < COARSE_VOXEL_SIDE


def _are_planes_equal(first: Mapping[str, PlanePatch], second: Mapping[str, PlanePatch]) -> bool:
    shared = [
        np.isin(second[line].indices, first[line].indices, assume_unique=True).mean()
        for line in first
        if line in second
    ]
    return bool(shared) and float(np.median(shared)) >= MIN_COMMON_POINT_SHARE
