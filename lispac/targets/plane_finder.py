"""Find the plane at a seed: RANSAC with local sampling, growth, trimming, fit."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
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

# The distance from the seed within which a point counts fully when planes compete for it, metres.
FULL_VOTE_DISTANCE = 0.25
# Points whose middle is the place that was clicked.
CLICKED_POINTS = 15


@dataclass(frozen=True, eq=False)
class PlanePatch:
    """The points of one line that lie on one plane.

    Attributes
    ----------
    indices : ndarray of shape (n,), int64
        Into the line's cloud, ascending.
    plane : Plane, local frame of that cloud
    rms : float, metres
        Of the points to the plane.
    centre : ndarray of shape (3,), metres, local frame
        Mean of the points.
    extent : ndarray of shape (2,), metres
        Width (level) and height (up the slope).
    one_in : int
        Of how many points about the seed one was examined.
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
    beside: Array | None = None,
) -> PlanePatch:
    """Find the plane that the seed lies on.

    Every plane is drawn from three neighbouring points and judged by the points near the seed
    more than by those far off, so a small board is not lost to the wall behind it. The best one
    grows over the points within the threshold that are connected with the seed, is fitted to
    them, and grows again until the points no longer change; then what lies beyond three sigma
    (mixed pixels at the edges) is trimmed.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres
        Points with a missing coordinate are passed over.
    seed : ndarray of shape (3,), metres, same frame
    settings : FinderSettings
    index : PointGrid, optional
        Prepared cells of the same points.
    expected_normal : ndarray of shape (3,), local frame, optional
        Only planes within ``settings.max_tilt`` of this normal are taken.
    beside : ndarray of shape (m, 3), metres, local frame, optional
        Where ``points_local`` are a sample: all of the line's points close to the seed, the nearest
        first. They mark the clicked place and have no vote: it would have too much weight.

    Raises
    ------
    PlaneNotFound
        No points, too few points, or no plane within the radius of the seed.
    """
    seed = require_seed(seed)
    near = neighbourhood_of(points_local, seed, settings, index=index)
    points = points_local[near]
    about = points if beside is None or not len(beside) else beside
    # The seed itself may float before the surface; the nearest point is on something real.
    reach = np.linalg.norm(points - about[0], axis=1)
    # The far field still votes, but its many points cannot outvote the few around the seed.
    votes = 1.0 / (1.0 + (reach / FULL_VOTE_DISTANCE) ** 2) ** 2
    # A seed on a point is a click on a surface, and only a plane through it is meant.
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
    """Where the surface is that was clicked: a single point of a noisy line may be off it.

    Of a board that stands three sigma before a wall the outermost points would also suit the wall.
    """
    nearest = points[:CLICKED_POINTS]
    nearest = nearest[np.linalg.norm(nearest - points[0], axis=1) <= FULL_VOTE_DISTANCE]
    return points[0] if len(nearest) < CLICKED_POINTS // 2 else np.median(nearest, axis=0)


def require_seed(seed: Array) -> Array:
    """The seed as an array of three numbers, metres, local frame: shape (3,).

    Raises
    ------
    PlaneNotFound
        When it is not one.
    """
    seed = np.asarray(seed, dtype=np.float64)
    if seed.shape != (3,) or not np.all(np.isfinite(seed)):
        raise PlaneNotFound(error("finder.seed"))
    return seed


def seed_text(seed: Array) -> Message:
    """The seed, shape (3,), metres, local frame, as part of a message."""
    north, west, up = map(float, seed)
    return note("finder.place", north=north, west=west, up=up)


def neighbourhood_of(
    points_local: Array,
    centre: Array,
    settings: FinderSettings,
    *,
    index: PointGrid | None = None,
) -> Indices:
    """Indices (k,) of the points within the radius of ``centre``, the nearest first.

    In this order every later step is the same for the same points, whatever order they came in.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres, local frame
    centre : ndarray of shape (3,), metres, local frame

    Raises
    ------
    PlaneNotFound
        There are fewer than ``settings.min_points``.
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
    if (np.diff(squared[order]) == 0.0).any():  # ties are rare, and to order them takes long
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
    """The patch that gathers most votes.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        The neighbourhood, in an order that does not depend on the file's.
    indices : ndarray of shape (n,)
        Their places in the line's cloud.
    votes : ndarray of shape (n,)
        Weight of each point in the choice of the plane.
    settings : FinderSettings
    seed : ndarray of shape (3,), metres, local frame
        For the messages.
    expected_normal : ndarray of shape (3,), local frame, optional
    through : ndarray of shape (3,), metres, local frame, optional
        A point that the plane must hold.

    Raises
    ------
    PlaneNotFound
        If no plane has enough points, or it is not as expected.
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
    """The patch that chosen points of a cloud form, its normal on the side of ``direction``.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres, local frame
    indices : ndarray of shape (k,), int
    direction : ndarray of shape (3,), local frame
    """
    points = points_local[indices]
    return _build_patch(points, indices, fit_plane(points).facing(direction))


def extend_sample_patch(points_local: Array, some: Array, plane: Plane) -> PlanePatch:
    """The patch that all points of a cloud form where some of them do.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres
    some : ndarray of shape (m, 3), metres, local frame
        A sample of the patch, trimmed.
    plane : Plane
        Through that sample.
    """
    near = np.abs(plane.distances(points_local)) <= np.abs(plane.distances(some)).max()
    indices = np.flatnonzero(near)
    axes = plane_axes(plane.normal)
    placed, shown = points_local[indices] @ axes.T, some @ axes.T
    # Cells as wide as the sample is spaced: what is beyond its outline stays out.
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
