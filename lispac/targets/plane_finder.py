"""Find the plane at a seed: RANSAC with local sampling, region growing, trimming, fit."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
from lispac.geometry.frames import east_north_up
from lispac.geometry.planes import (
    Plane,
    extent_in_plane,
    fit_plane,
    plane_axes,
    plane_through,
    rms_distance,
)
from lispac.geometry.radius_search import PointGrid, nearest_point, points_within
from lispac.messages import Message, error, note
from lispac.targets import outline
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.plane_ransac import draw_planes
from lispac.targets.region_growing import grow_best_contender, grow_plane, trim_outliers

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

__all__ = ["FinderSettings", "PlanePatch", "find_plane"]

# Distance from the seed within which points have full weight in the choice of the plane, metres.
FULL_VOTE_DISTANCE = 0.25
# Number of points near the seed whose median is the clicked position.
POINTS_PER_CLICK = 15


@dataclass(frozen=True, eq=False)
class PlanePatch:
    """Points of one line that lie on one plane.

    Attributes
    ----------
    indices : ndarray of shape (n,), int64
        Indices into the cloud of the line, ascending.
    plane : Plane, local frame of that cloud
    rms : float, metres
        RMS distance of the points from the plane.
    centre : ndarray of shape (3,), metres, local frame
        Mean of the points.
    extent : ndarray of shape (2,), metres
        Width (level) and height (up the slope).
    one_in : int
        Sampling of the points around the seed: one in this number was used.
    """

    indices: Indices
    plane: Plane
    rms: float
    centre: Array
    extent: Array
    one_in: int = 1


def find_plane(
    points_local: Array,
    seed: Array,
    settings: FinderSettings,
    *,
    index: PointGrid | None = None,
    expected_normal: Array | None = None,
    points_at_seed: Array | None = None,
) -> PlanePatch:
    """Find the plane on which the seed lies.

    Candidate planes are drawn through three neighbouring points. Points near the seed have more
    weight in their evaluation than distant ones, so that a small board is preferred to the wall
    behind it. The best plane is extended to the points within the threshold that are connected with
    the seed and fitted to them; this is repeated until the points no longer change. Finally, points
    beyond three sigma (mixed pixels at the edges) are removed.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres
        Points with a coordinate that is not finite are ignored.
    seed : ndarray of shape (3,), metres, same frame
    settings : FinderSettings
    index : PointGrid, optional
        Prepared cells of the same points.
    expected_normal : ndarray of shape (3,), local frame, optional
        Only planes within ``settings.max_tilt`` of this normal are accepted.
    points_at_seed : ndarray of shape (m, 3), metres, local frame, optional
        If ``points_local`` is a sample: all points of the line close to the seed, the nearest
        first. They only determine the clicked place; as votes they would have too much weight.

    Raises
    ------
    PlaneNotFound
        No points, too few points, or no plane within the radius of the seed.
    """
    seed = require_seed(seed)
    near = neighbourhood_of(points_local, seed, settings, index=index)
    points = points_local[near]
    about = points if points_at_seed is None or not len(points_at_seed) else points_at_seed
    # The seed itself may lie in front of the surface; the nearest point is on a surface.
    reach = np.linalg.norm(points - about[0], axis=1)
    # Distant points also vote, but with a weight that gives the few points near the seed priority.
    votes = 1.0 / (1.0 + (reach / FULL_VOTE_DISTANCE) ** 2) ** 2
    # A seed on a point was clicked on a surface: only a plane through this point is accepted.
    clicked = float(np.linalg.norm(about[0] - seed)) <= settings.threshold
    return extract_patch(
        points,
        near,
        votes,
        settings,
        seed,
        expected_normal=expected_normal,
        through=_surface_point_at_seed(about) if clicked else None,
    )


def _surface_point_at_seed(points: Array) -> Array:
    """Position of the clicked surface: the median of several points, since a single one is noisy.

    With a board three sigma in front of a wall, a single point of the board could also belong to
    the wall.
    """
    nearest = points[:POINTS_PER_CLICK]
    nearest = nearest[np.linalg.norm(nearest - points[0], axis=1) <= FULL_VOTE_DISTANCE]
    return points[0] if len(nearest) < POINTS_PER_CLICK // 2 else np.median(nearest, axis=0)


def require_seed(seed: Array) -> Array:
    """Seed as an array of shape (3,), metres, local frame.

    Raises
    ------
    PlaneNotFound
        If the seed does not consist of three finite numbers.
    """
    seed = np.asarray(seed, dtype=np.float64)
    if seed.shape != (3,) or not np.all(np.isfinite(seed)):
        raise PlaneNotFound(error("finder.seed"))
    return seed


def seed_text(seed: Array) -> Message:
    """Seed, shape (3,), metres, local frame, as part of a message."""
    east, north, up = map(float, east_north_up(seed))
    return note("finder.seed_position", east=east, north=north, up=up)


def with_seed_position(message: Message) -> Message:
    """Message about a search, with the seed as `seed_text` gives it, not as former versions did."""
    params = {
        name: with_seed_position(value) if isinstance(value, Message) else value
        for name, value in message.params.items()
    }
    place = [params.get(axis) for axis in ("north", "west", "up")]
    if message.code == "finder.place" and all(isinstance(value, int | float) for value in place):
        return seed_text(np.array(place, dtype=np.float64))
    return replace(message, params=params)


def neighbourhood_of(
    points_local: Array,
    centre: Array,
    settings: FinderSettings,
    *,
    index: PointGrid | None = None,
) -> Indices:
    """Indices (k,) of the points within the radius of ``centre``, the nearest first.

    With this order, all later steps are independent of the order of the points in the file.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres, local frame
    centre : ndarray of shape (3,), metres, local frame

    Raises
    ------
    PlaneNotFound
        If there are fewer than ``settings.min_points``.
    """
    if index is None:
        near = points_within(points_local, centre, settings.radius)
    else:
        near = index.within(centre, settings.radius)
    if len(near) < settings.min_points:
        radius, place = settings.radius, seed_text(centre)
        if len(near) > 0:
            raise PlaneNotFound(
                error(
                    "finder.few_points",
                    count=len(near),
                    radius=radius,
                    needed=settings.min_points,
                    place=place,
                )
            )
        _, distance = nearest_point(points_local, centre)
        if np.isfinite(distance):
            raise PlaneNotFound(
                error("finder.no_points", radius=radius, distance=float(distance), place=place)
            )
        raise PlaneNotFound(error("finder.no_points_near", radius=radius, place=place))
    points = points_local[near]
    squared = ((points - centre) ** 2).sum(axis=1)
    order = np.argsort(squared)
    if (np.diff(squared[order]) == 0.0).any():  # ties are rare, and sorting them takes time
        order = np.lexsort((points[:, 2], points[:, 1], points[:, 0], squared))
    ordered: Indices = near[order]
    return ordered


def extract_patch(
    points: Array,
    indices: Indices,
    votes: Array,
    settings: FinderSettings,
    seed: Array,
    *,
    expected_normal: Array | None = None,
    through: Array | None = None,
) -> PlanePatch:
    """Extract the patch with most votes.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        Points of the neighbourhood, in an order that does not depend on the file.
    indices : ndarray of shape (n,)
        Indices of these points in the cloud of the line.
    votes : ndarray of shape (n,)
        Weight of each point in the choice of the plane.
    settings : FinderSettings
    seed : ndarray of shape (3,), metres, local frame
        Used in messages.
    expected_normal : ndarray of shape (3,), local frame, optional
    through : ndarray of shape (3,), metres, local frame, optional
        A point that the plane has to contain.

    Raises
    ------
    PlaneNotFound
        If no plane has enough points, or its normal differs from the expected one.
    """
    origin = points[0]
    local = points - origin
    fixed = None if through is None else through - origin
    contenders = draw_planes(local, votes, settings, expected_normal, fixed)
    if not contenders:
        raise PlaneNotFound(
            error("finder.no_plane", threshold=settings.threshold, place=seed_text(seed))
        )
    best = grow_best_contender(local, votes, contenders, settings, fixed)
    on = grow_plane(local, votes, best, settings, fixed)
    on = trim_outliers(local, on, settings)
    if len(on) < settings.min_points:
        raise PlaneNotFound(
            error(
                "finder.plane_few_points",
                count=len(on),
                needed=settings.min_points,
                threshold=settings.threshold,
                place=seed_text(seed),
            )
        )
    plane = fit_plane(points[on])
    if expected_normal is not None:
        plane = plane.facing(expected_normal)
        if plane.tilt_to(plane_through(origin, expected_normal)) > settings.max_tilt:
            raise PlaneNotFound(error("finder.other_tilt", place=seed_text(seed)))
    return _build_patch(points[on], np.sort(indices[on]), plane)


def patch_of(points_local: Array, indices: Indices, direction: Array) -> PlanePatch:
    """Patch of chosen points of a cloud, with its normal on the side of ``direction``.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres, local frame
    indices : ndarray of shape (k,), int
    direction : ndarray of shape (3,), local frame
    """
    points = points_local[indices]
    return _build_patch(points, indices, fit_plane(points).facing(direction))


def extend_sample_patch(points_local: Array, sample_points: Array, plane: Plane) -> PlanePatch:
    """Extend a patch found in a sample to all points of the cloud.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres
    sample_points : ndarray of shape (m, 3), metres, local frame
        Points of the patch in the sample, without outliers.
    plane : Plane
        Plane through these points.
    """
    near = np.abs(plane.distances(points_local)) <= np.abs(plane.distances(sample_points)).max()
    indices = np.flatnonzero(near)
    axes = plane_axes(plane.normal)
    placed, shown = points_local[indices] @ axes.T, sample_points @ axes.T
    # Cells as wide as the spacing of the sample: points beyond its outline are not included.
    spacing = outline.outline_cell_size(shown, np.ones(len(shown))) / 3.0
    return patch_of(points_local, indices[outline.is_covered(placed, shown, spacing)], plane.normal)


def _build_patch(points: Array, indices: Indices, plane: Plane) -> PlanePatch:
    return PlanePatch(
        indices=indices,
        plane=plane,
        rms=rms_distance(plane, points),
        centre=points.mean(axis=0),
        extent=extent_in_plane(plane, points),
    )
