"""Cloud-to-cloud distance with a local plane, after CloudCompare.

The distance to the nearest point of the other cloud depends on the point spacing of that cloud as
much as on the surface. CloudCompare's "local modelling" (Girardeau-Montaut, the tool of thesis
section 4.5.4) fits a plane or a quadric by least squares to the nearest reference point and its
neighbours, and measures the distance to this surface instead. CloudCompare uses the smaller of the
two distances, so that a poorly shaped neighbourhood, or a point beyond the edge of the reference,
never increases the result. A validation uses the distance to the surface where there is one.
"""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lispac.errors import InputError
from lispac.geometry.point_tree import PointTree
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress
from lispac.validation.local_models import SIX_POINT_PLANE, LocalModel, LocalSurfaces

_CHUNK_POINTS = 50_000
"""Number of compared points that a thread processes at once."""

COMPARED_CODES = ("validation.compared_shape", "validation.compared_not_finite")
REFERENCE_CODES = ("validation.reference_shape", "validation.reference_not_finite")
"""Codes of the messages that a cloud has a wrong shape, or coordinates that are not finite."""


def cloud_to_cloud(
    compared: ArrayLike,
    reference: ArrayLike | PointTree,
    *,
    model: LocalModel = SIX_POINT_PLANE,
    surfaces: LocalSurfaces | None = None,
    up_to_nearest: bool = True,
    max_distance: float | None = None,
    progress: Progress = no_progress,
) -> NDArray[np.float64]:
    """Distance of each compared point to the reference cloud.

    Parameters
    ----------
    compared : array of shape (n, 3), metres
    reference : array of shape (m, 3), metres, or PointTree
        In the same frame; a tree if several clouds are compared with it. If it has fewer points
        than the model has neighbours, the model is fitted to all of them; if these are too few for
        the model, the distance to the nearest point is used.
    model : LocalModel
        Model of the surface between the reference points.
    surfaces : LocalSurfaces, optional
        Surfaces of this model at all points of the tree, if several clouds are compared with it.
    up_to_nearest : bool
        If true, a distance is at most that to the nearest point, as in CloudCompare. Where the
        points are closer together than their noise, such distances are too small, because the
        nearest point is one with a large error.
    max_distance : float, metres, optional
        Compared points without a reference point within this distance get NaN.

    Returns
    -------
    ndarray of shape (n,), metres, unsigned

    Raises
    ------
    InputError
        If a cloud is not (n, 3) or contains NaN or infinity, if the reference is empty, or if the
        maximum distance is not positive.

    Notes
    -----
    Where the neighbours lie on one straight line, no plane is defined and the distance to the
    nearest point is used (CloudCompare uses the plane that its solver happens to return). A quadric
    is a height over the plane through its points, where CloudCompare takes the height along the
    coordinate axis nearest to that plane's normal, which is larger on oblique surfaces.
    """
    compared = _finite_cloud(compared, COMPARED_CODES)
    if not isinstance(reference, PointTree):
        reference = _finite_cloud(reference, REFERENCE_CODES)
    if max_distance is not None and not max_distance > 0.0:
        raise InputError(error("validation.max_distance", distance=max_distance))
    if len(compared) == 0:
        return np.empty(0)
    if len(reference) == 0:
        raise InputError(error("validation.empty_reference"))

    limit = np.inf if max_distance is None else max_distance
    progress(0.0, gettext_lazy("Indexing the point clouds"))
    measured = partial(
        _chunk_distances, model=model, surfaces=surfaces, up_to_nearest=up_to_nearest, limit=limit
    )
    if len(compared) > _CHUNK_POINTS:
        return _distances_in_threads(compared, reference, measured, progress)
    tree = reference if isinstance(reference, PointTree) else PointTree(reference)
    found = measured(compared, tree)
    progress(1.0, gettext_lazy("Computing distances"))
    return found


def _distances_in_threads(
    compared: NDArray[np.float64],
    reference: NDArray[np.float64] | PointTree,
    measured: Callable[[NDArray[np.float64], PointTree], NDArray[np.float64]],
    progress: Progress,
) -> NDArray[np.float64]:
    """Distances of many points, in chunks that threads measure."""
    starts = range(0, len(compared), _CHUNK_POINTS)
    pool = ThreadPoolExecutor(max(2, min(os.cpu_count() or 1, len(starts))))
    try:
        # The places are searched for in spatial order, in which the processor's cache is used.
        ordering = pool.submit(PointTree, compared)
        tree = reference if isinstance(reference, PointTree) else PointTree(reference)
        places = ordering.result()
        distances = np.empty(len(compared))

        def measure(start: int) -> None:
            chunk = slice(start, start + _CHUNK_POINTS)
            distances[places.order[chunk]] = measured(places.points[chunk], tree)

        tasks = [pool.submit(measure, start) for start in starts]
        for done, task in enumerate(tasks, start=1):
            task.result()
            progress(0.2 + 0.8 * done / len(tasks), gettext_lazy("Computing distances"))
    finally:
        # After a cancellation, chunks that have not started are not computed.
        pool.shutdown(cancel_futures=True)
    return distances


def _chunk_distances(
    compared: NDArray[np.float64], reference: PointTree, model: LocalModel,
    surfaces: LocalSurfaces | None, up_to_nearest: bool, limit: float,
) -> NDArray[np.float64]:  # fmt: skip
    """Distances (n,) of one spatially coherent chunk."""
    distances, nearest = reference.nearest(compared, limit)
    found = np.isfinite(distances)
    distances[~found] = np.nan
    if found.any():
        if surfaces is None:
            to_surface = model.distances(compared[found], nearest[found], reference)
        else:
            to_surface = surfaces.distances(compared[found], nearest[found])
        if up_to_nearest:
            to_surface = np.fmin(distances[found], to_surface)  # fmin: NaN is "no surface"
        distances[found] = np.where(np.isfinite(to_surface), to_surface, distances[found])
    return distances


def _finite_cloud(points: ArrayLike, codes: tuple[str, str]) -> NDArray[np.float64]:
    """Points as a contiguous (n, 3) array of finite numbers.

    Raises
    ------
    InputError
        If they are not.
    """
    shape, not_finite = codes
    cloud = np.ascontiguousarray(points, dtype=np.float64)
    if cloud.ndim != 2 or cloud.shape[1] != 3:
        raise InputError(error(shape, shape=str(cloud.shape)))
    bad = int(np.count_nonzero(~np.isfinite(cloud).all(axis=1)))
    if bad:
        raise InputError(error(not_finite, count=bad, total=len(cloud)))
    return cloud
