"""Extension of a plane to the edge of its surface by region growing."""

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import Plane, fit_plane, plane_axes
from lispac.targets import outline
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.plane_ransac import PENALTY_BAND, SAMPLE_SIZE

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# A cell belongs to the patch if its share of points on the plane is at least this fraction of the
# share around the seed; it is far smaller where another surface intersects the plane.
MIN_ON_PLANE_RATIO = 0.6
# Rounds of growing and fitting; they converge in two to five.
MAX_ROUNDS = 12
# Steps of the weighted fit in one round of growing.
ROBUST_FIT_STEPS = 5
# Largest residual of a point of the plane, in sigmas. Beyond it, a point is more likely a mixed
# pixel than a point with normal noise.
TRIM_LIMIT_SIGMAS = 3.0


def grow_plane(
    points: Array, votes: Array, plane: Plane, settings: FinderSettings, through: Array | None
) -> Indices:
    """Extend a plane to connected points; growing and fitting alternate.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
    votes : ndarray of shape (n,)
        Weight of each point.
    through : ndarray of shape (3,), metres, local frame, or None
        A point that the plane has to contain.

    Returns
    -------
    ndarray of shape (k,), int
        Indices of the points on the plane.
    """
    on: Indices = np.empty(0, dtype=np.int64)
    for _ in range(MAX_ROUNDS):
        grown = _connected_points_on_plane(points, votes, plane, settings.threshold)
        if len(grown) < 3 or np.array_equal(grown, on):
            break
        fitted = _fit_plane_robustly(points[grown], plane, settings.threshold)
        # A larger surface nearby must not pull the plane away from the clicked point.
        if through is not None and abs(float(fitted.distances(through))) > settings.threshold:
            on = grown if len(on) == 0 else on
            break
        on, plane = grown, fitted
    return on


def grow_best_contender(
    points: Array,
    votes: Array,
    contenders: list[Plane],
    settings: FinderSettings,
    through: Array | None,
) -> Plane:
    """Grow several candidate planes and return the one with most points near its plane.

    Planes of different tilt may fit the points near the seed equally well; their extents
    distinguish them.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
    votes : ndarray of shape (n,)
        Weight of each point.
    through : ndarray of shape (3,), metres, local frame, or None
        A point that the plane has to contain.
    """
    if len(contenders) == 1:
        return contenders[0]
    step = max(1, len(points) // SAMPLE_SIZE)
    sample, weights = points[::step], votes[::step]
    best_merit, best = -1.0, contenders[0]
    for plane in contenders:
        on = grow_plane(sample, weights, plane, settings, through)
        if len(on) < 3:
            continue
        fitted = _fit_plane_robustly(sample[on], plane, settings.threshold)
        off = fitted.distances(sample[on]) / settings.threshold
        merit = float((np.maximum(1.0 - off * off, 0.0) ** 2).sum())
        if merit > best_merit:
            best_merit, best = merit, fitted
    return best


def _fit_plane_robustly(points: Array, plane: Plane, threshold: float) -> Plane:
    """Weighted fit with the biweight (Beaton and Tukey 1974).

    The fit converges to the densest layer of the points. Where surfaces are rough or intersect, an
    unweighted fit of all points within the threshold could give a tilted plane with residuals
    spread evenly over the threshold.
    """
    for _ in range(ROBUST_FIT_STEPS):
        off = plane.distances(points) / threshold
        weights = np.maximum(1.0 - off * off, 0.0) ** 2
        if np.count_nonzero(weights) < 3:
            break
        plane = fit_plane(points, weights)
    return plane


def _connected_points_on_plane(
    points: Array, votes: Array, plane: Plane, threshold: float
) -> Indices:
    off = np.abs(plane.distances(points))
    band = np.flatnonzero(off <= PENALTY_BAND * threshold)
    on = off[band] <= threshold
    if np.count_nonzero(on) < 3:
        return band[on]
    placed = points[band] @ plane_axes(plane.normal).T
    weights = votes[band] * on
    cell = outline.outline_cell_size(placed[on], weights[on])
    share = outline.share_in_cell(placed, on, cell)
    on &= share >= MIN_ON_PLANE_RATIO * np.average(share, weights=weights)
    if np.count_nonzero(on) < 3:
        return band[on]
    return band[on][outline.is_connected(placed[on], weights[on], cell)]


def trim_outliers(points: Array, on: Indices, settings: FinderSettings) -> Indices:
    """Remove points beyond three sigma, with sigma from the median of the residuals.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
    on : ndarray of shape (k,), int
        Indices of the points that are on the plane.

    Returns
    -------
    ndarray of shape (m,), int
    """
    if len(on) < 3:
        return on
    plane = fit_plane(points[on])
    residuals = plane.distances(points[on])
    sigma = 1.4826 * float(np.median(np.abs(residuals)))
    limit = min(settings.threshold, TRIM_LIMIT_SIGMAS * sigma)
    kept = on[np.abs(residuals) <= limit]
    # Sigma of noise-free points is zero; all of them are kept.
    return kept if len(kept) >= max(3, len(on) // 2) else on
