"""Search for one sphere in every line, starting from one seed.

The surroundings of the sphere predict its position in the other lines. There the search is
repeated, and the sphere is compared with the reference by its position and, if the radius is
unknown, by its radius.
"""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound, SphereNotFound
from lispac.geometry.radius_search import PointGrid
from lispac.messages import Message, error
from lispac.progress import Progress, no_progress
from lispac.targets.cloud_shift import CloudShift
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.line_search import (
    ShapeSearch,
    WeightedSurroundings,
    best_match,
    find_shifts_into_line,
    search_target_in_lines,
    surroundings_of_patch,
)
from lispac.targets.plane_finder import require_seed
from lispac.targets.sphere_finder import RadiusRange, SpherePatch, find_sphere

Array = NDArray[np.float64]

# Distance from the predicted position at which a sphere has half of its score, metres.
HALF_SCORE_OFFSET = 0.2
# Largest ratio of the radii of two sightings of one sphere. A sphere of 0.10 m, scanned in a tenth
# of a second from a pitching vessel, had radii of 0.08 m and 0.14 m.
MAX_RADIUS_RATIO = 2.0


def find_spheres_in_lines(
    clouds: Mapping[str, Array],
    seed: Array,
    radius_range: RadiusRange,
    settings: FinderSettings,
    *,
    first_line: str | None = None,
    indices: Mapping[str, PointGrid] | None = None,
    progress: Progress = no_progress,
) -> tuple[dict[str, SpherePatch], dict[str, Message]]:
    """Find the sphere at the seed in every line.

    Parameters
    ----------
    clouds : mapping of line name to ndarray of shape (n, 3), metres, one local frame
    seed : ndarray of shape (3,), metres, local frame
        A point on the sphere, near it, or its centre.
    radius_range : RadiusRange
    settings : FinderSettings
    first_line : str, optional
        The clicked line, used as the reference. If omitted, the line with a point at the seed;
        otherwise the line whose sphere is nearest to the seed. If this sphere is missing in some
        lines, the reference is the one of the nearest three whose sphere is found in most lines.
    indices : mapping of line name to PointGrid, optional
        Prepared cells; lines without them are read completely.
    progress : Progress

    Returns
    -------
    found : dict of line name to SpherePatch
    missing : dict of line name to Message
        Reason why the target was not found in a line.

    Raises
    ------
    SphereNotFound
        The clicked line has no such sphere at the seed, or no line has.
    """
    try:
        seed = require_seed(seed)
    except PlaneNotFound as failure:
        raise SphereNotFound(failure.reason) from None
    grids = indices or {}

    def follow(first_line: str, first: SpherePatch) -> Callable[[str], SpherePatch]:
        cloud, grid = clouds[first_line], grids.get(first_line)
        around = surroundings_of_patch(cloud, grid, first.indices, first.centre, seed, settings)
        return lambda name: _find_in_line(
            clouds[name], grids.get(name), first, around, seed, radius_range, settings
        )

    shape = ShapeSearch(
        no_line="finder.no_line_for_sphere",
        in_no_line="finder.no_sphere_in_lines",
        error=SphereNotFound,
        find=lambda name: find_sphere(
            clouds[name], seed, radius_range, settings, index=grids.get(name)
        ),
        distance=lambda _, patch: max(0.0, float(patch.sphere.distances(seed))),
        follow=follow,
    )
    return search_target_in_lines(clouds, grids, seed, shape, first_line, progress)


def _find_in_line(
    cloud: Array,
    grid: PointGrid | None,
    first: SpherePatch,
    around: WeightedSurroundings,
    seed: Array,
    radius_range: RadiusRange,
    settings: FinderSettings,
) -> SpherePatch:
    def match(shift: CloudShift) -> tuple[SpherePatch, float]:
        """Sphere at the predicted position, and a score of its agreement with the reference.

        Raises
        ------
        SphereNotFound
            If its radius differs too much.
        """
        predicted = first.centre + shift.vector
        patch = find_sphere(cloud, predicted, radius_range, settings, index=grid)
        ratio = patch.sphere.radius / first.sphere.radius
        larger = max(ratio, 1.0 / ratio)
        if larger > MAX_RADIUS_RATIO:
            raise SphereNotFound(
                error(
                    "finder.radius_differs",
                    radius=patch.sphere.radius,
                    expected=first.sphere.radius,
                )
            )
        off = float(np.linalg.norm(patch.centre - predicted))
        likeness = 1.0 / (1.0 + (off / HALF_SCORE_OFFSET) ** 2) / larger
        return patch, shift.score * likeness

    shifts = find_shifts_into_line(cloud, grid, around, seed, settings)
    return best_match(shifts, match, _two_spheres_error)


def _two_spheres_error(best: SpherePatch, other: SpherePatch) -> Message | None:
    """Message if two different spheres were found; None if both are the same sphere."""
    distance = float(np.linalg.norm(best.centre - other.centre))
    if distance <= 0.5 * best.sphere.radius:
        return None
    return error("finder.two_spheres", distance=distance)
