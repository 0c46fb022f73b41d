"""Shift between two lines around a seed, caused by a wrong boresight.

A wrong boresight places the same target at a different position in each line. Its surroundings are
displaced in the same way, so the translation that aligns the surroundings of the target in one line
with the other line predicts the position of the target there.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.radius_search import cell_keys, finite_bounds

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# Sides of the voxels from coarse to fine, metres. Voxels up to two voxels from a filled one count
# as close to it.
VOXEL_SIDES = (0.2, 0.1, 0.05)
# Largest number of candidates passed from one voxel size to the next, and smallest distance
# between them, in voxels.
MAX_CANDIDATES = 24
MIN_SEPARATION_VOXELS = 1.5


@dataclass(frozen=True, eq=False)
class CloudShift:
    """Translation of one cloud onto another, with a score.

    Attributes
    ----------
    vector : ndarray of shape (3,), metres, local frame
        Vector to be added to the points of the first cloud.
    score : float
        Weighted mean closeness of the points of the first cloud to the second cloud, from 0 to 1,
        minus a reduction for the length of the translation.
    """

    vector: Array
    score: float


def find_shifts(
    first: Array, weights: Array, second: Array, max_shift: float, *, prefer_small: float = 0.02
) -> list[CloudShift]:
    """Find translations of the first cloud onto the second, the best first.

    All translations no longer than ``max_shift`` are tried on coarse voxels; the best of them are
    refined on finer voxels.

    Parameters
    ----------
    first : ndarray of shape (n, 3), metres, local frame
    weights : ndarray of shape (n,)
    second : ndarray of shape (m, 3), metres, local frame
        Has to extend beyond the first cloud by ``max_shift`` on every side.
    max_shift : float, metres
    prefer_small : float
        Reduction of the score per metre of translation. Along a wall, where all translations fit
        equally well, the smallest one is preferred.

    Returns
    -------
    list of CloudShift
        Translations that differ from each other; empty if nothing matches.
    """
    origin = first.mean(axis=0)
    first, second = first - origin, second - origin
    steps = int(np.ceil(max_shift / VOXEL_SIDES[0]))
    axis = np.arange(-steps, steps + 1) * VOXEL_SIDES[0]
    tried: Array = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)
    tried = tried[np.linalg.norm(tried, axis=1) <= max_shift + 0.5 * VOXEL_SIDES[0]]
    found: list[CloudShift] = []
    for level, voxel in enumerate(VOXEL_SIDES):
        if level > 0:
            around = np.stack(np.meshgrid(*[[-voxel, 0.0, voxel]] * 3, indexing="ij"), axis=-1)
            tried = np.concatenate([s.vector + around.reshape(-1, 3) for s in found])
            steps_tried = np.unique(np.round(tried / voxel).astype(np.int64), axis=0)
            tried = np.asarray(steps_tried * voxel, dtype=np.float64)
        scores = _shift_scores(first, weights, second, tried, voxel)
        scores -= prefer_small * np.linalg.norm(tried, axis=1)
        found = _distinct_best_shifts(
            tried, scores, MIN_SEPARATION_VOXELS * voxel if level < 2 else 2.0 * VOXEL_SIDES[0]
        )
        if not found:
            return []
    return found


def rate_shifts(
    first: Array, weights: Array, second: Array, vectors: Array, *, prefer_small: float = 0.02
) -> list[CloudShift]:
    """Scores of given translations, computed as in `find_shifts`.

    Parameters
    ----------
    first, second : ndarrays of shape (n, 3) and (m, 3), metres, local frame
    weights : ndarray of shape (n,)
    vectors : ndarray of shape (k, 3), metres, local frame
    """
    if len(vectors) == 0:
        return []
    origin = first.mean(axis=0)
    scores = _shift_scores(first - origin, weights, second - origin, vectors, VOXEL_SIDES[-1])
    scores -= prefer_small * np.linalg.norm(vectors, axis=1)
    return [CloudShift(vector, float(score)) for vector, score in zip(vectors, scores, strict=True)]


def _shift_scores(first: Array, weights: Array, second: Array, tried: Array, voxel: float) -> Array:
    (own, own_high), (other, other_high), (step, step_high) = map(
        finite_bounds, (first, second, tried)
    )
    low = np.minimum(own + step, other) - 3.0 * voxel
    high = np.maximum(own_high + step_high, other_high) + 3.0 * voxel
    shape = np.ceil((high - low) / voxel).astype(np.int64) + 1
    field = _closeness_field(second, low, voxel, shape)
    heap, mass = _voxel_means(first, weights, voxel)
    return _mean_closeness(field, (heap - low) / voxel, mass / mass.sum(), tried / voxel)


def voxel_numbers(points: Array, voxel: float) -> Indices:
    """Number of the voxel of each point (n, 3), local frame.

    The voxel grid is fixed in the local frame and does not depend on the points.
    """
    return cell_keys(points, voxel * np.floor(finite_bounds(points)[0] / voxel), voxel)[0]


def _voxel_means(points: Array, weights: Array, voxel: float) -> tuple[Array, Array]:
    """Mean point and mean weight of each voxel, so that dense parts have no more influence."""
    _, group, count = np.unique(
        voxel_numbers(points, voxel), return_inverse=True, return_counts=True
    )
    mean = np.stack([np.bincount(group, points[:, k]) / count for k in range(3)], axis=1)
    mass = np.bincount(group, weights) / count
    return mean, mass


def _distinct_best_shifts(tried: Array, scores: Array, min_distance: float) -> list[CloudShift]:
    kept: list[CloudShift] = []
    free = scores > 0.0
    for i in np.argsort(-scores, kind="stable"):
        if scores[i] <= 0.0 or len(kept) == MAX_CANDIDATES:
            break
        if free[i]:
            kept.append(CloudShift(tried[i], float(scores[i])))
            free &= ((tried - tried[i]) ** 2).sum(axis=1) > min_distance * min_distance
    return kept


@njit(nogil=True, cache=True)
def _closeness_field(
    points: Array, low: Array, voxel: float, shape: Indices
) -> NDArray[np.float32]:  # pragma: no cover - compiled
    """Closeness to the nearest filled voxel: 1 inside, falling to 0 at 2.5 voxels."""
    field = np.zeros((shape[0], shape[1], shape[2]), np.float32)
    kernel = np.empty((5, 5, 5), np.float32)
    for i in range(5):
        for j in range(5):
            for k in range(5):
                squared = (i - 2) ** 2 + (j - 2) ** 2 + (k - 2) ** 2
                kernel[i, j, k] = max(0.0, 1.0 - squared / 6.25)
    for n in range(points.shape[0]):
        x = int((points[n, 0] - low[0]) / voxel)
        y = int((points[n, 1] - low[1]) / voxel)
        z = int((points[n, 2] - low[2]) / voxel)
        if field[x, y, z] == 1.0:
            continue
        for i in range(5):
            for j in range(5):
                for k in range(5):
                    value = kernel[i, j, k]
                    if value > field[x + i - 2, y + j - 2, z + k - 2]:
                        field[x + i - 2, y + j - 2, z + k - 2] = value
    return field


@njit(nogil=True, cache=True)
def _mean_closeness(
    field: NDArray[np.float32], places: Array, mass: Array, steps: Array
) -> Array:  # pragma: no cover - compiled
    """Weighted mean of the closeness at the places, shifted by each of the steps, in voxels.

    Most steps are integers. The voxels of the places are then computed only once and shifted by
    integer addition, which takes a third of the time.
    """
    flat = field.reshape(-1)
    scores = np.zeros(steps.shape[0])
    voxel_index = np.empty(places.shape[0], np.int64)
    fraction, last = np.empty(3), np.full(3, -1.0)
    for t in range(steps.shape[0]):
        moved = 0
        for k in range(3):
            whole_step = np.floor(steps[t, k] + 1e-6)
            fraction[k] = steps[t, k] - whole_step
            moved = moved * field.shape[k] + int(whole_step)
        if np.abs(fraction - last).max() > 1e-6:
            last[:] = fraction
            for n in range(places.shape[0]):
                voxel_index[n] = 0
                for k in range(3):
                    voxel_index[n] = voxel_index[n] * field.shape[k] + int(
                        places[n, k] + fraction[k]
                    )
        total = 0.0
        for n in range(places.shape[0]):
            total += mass[n] * flat[voxel_index[n] + moved]
        scores[t] = total
    return scores
