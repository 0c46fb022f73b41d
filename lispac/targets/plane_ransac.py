"""RANSAC with local sampling: planes through neighbouring points, evaluated by weighted votes."""

from math import radians

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.planes import Plane
from lispac.targets.finder_settings import FinderSettings

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# Size of the sample on which hypotheses are evaluated: of more points, every k-th one is
# used, which gives between this number and twice this number.
SAMPLE_SIZE = 4000
# Hypotheses per batch, after which the stop criterion is checked, and largest number of batches.
BATCH_SIZE, MAX_BATCHES = 128, 12
# Largest distance between the first and another corner of a triangle, as a share of the search
# radius.
MAX_TRIANGLE_SHARE = 0.5
# Points between one threshold and this number of thresholds from the plane count against it, and
# weight of these votes. A real surface has few such points, a plane across other surfaces many.
PENALTY_BAND, PENALTY_WEIGHT = 3.0, 0.3
# Angle from the expected normal at which a hypothesis has half of its score, radians.
HALF_SCORE_TILT = radians(10.0)
# Hypotheses for region growing: largest number, smallest ratio to the best score, and smallest
# difference in tilt (radians).
MAX_CONTENDERS, MIN_SCORE_RATIO, MIN_TILT_DIFFERENCE = 6, 0.7, radians(2.0)


def draw_planes(
    points: Array,
    votes: Array,
    settings: FinderSettings,
    expected_normal: Array | None,
    through: Array | None,
) -> list[Plane]:
    """Planes through three neighbouring points with the best votes (Fischler and Bolles 1981).

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
    votes : ndarray of shape (n,)
        Weight of each point.
    expected_normal : ndarray of shape (3,), local frame, or None
        Only planes within ``settings.max_tilt`` of this normal are accepted.
    through : ndarray of shape (3,), metres, local frame, or None
        A point that the plane has to contain.
    """
    rng = np.random.default_rng(settings.seed)
    step = max(1, len(points) // SAMPLE_SIZE)
    # Contiguous, so that the search is not compiled for a second memory layout
    sample, weights = (np.ascontiguousarray(values[::step]) for values in (points, votes))
    chance = np.cumsum(weights / weights.sum())
    normal = np.zeros(3) if expected_normal is None else np.asarray(expected_normal, np.float64)
    tilt_limit = settings.max_tilt if expected_normal is not None else -1.0
    fixed = np.full(3, np.nan) if through is None else through
    hypotheses = np.empty((0, 6))
    for batch in range(1, MAX_BATCHES + 1):
        first = np.minimum(np.searchsorted(chance, rng.random(BATCH_SIZE)), len(sample) - 1)
        # From the point spacing up to the size of a board: small surfaces need small triangles,
        # noisy ones large triangles, and the kind of surface is not known in advance.
        reach = settings.radius * MAX_TRIANGLE_SHARE * 2.0 ** -rng.uniform(0.0, 4.0, BATCH_SIZE)
        picks = rng.random((BATCH_SIZE, 2))
        drawn = _score_triangles(
            sample, weights, first, reach, picks, settings.threshold, normal, tilt_limit, fixed
        )
        scored = drawn[drawn[:, 0] > 0.0]
        hypotheses = np.concatenate([hypotheses, scored])
        if len(hypotheses) == 0:
            continue
        share = float(hypotheses[np.argmax(hypotheses[:, 0]), 1])
        if (1.0 - share**3) ** (batch * BATCH_SIZE) <= 1.0 - settings.stop:
            break
    return _distinct_best_planes(hypotheses, settings.threshold)


def _distinct_best_planes(hypotheses: Array, threshold: float) -> list[Plane]:
    """Hypotheses that differ from each other and are nearly as good as the best one."""
    kept: list[Plane] = []
    if len(hypotheses) == 0:
        return kept
    ranked = hypotheses[np.argsort(-hypotheses[:, 0], kind="stable")]
    for row in ranked[ranked[:, 0] >= MIN_SCORE_RATIO * ranked[0, 0]]:
        plane = Plane(row[2:5].copy(), float(row[5]))
        if all(
            plane.tilt_to(other) > MIN_TILT_DIFFERENCE
            or abs(plane.facing(other.normal).d - other.d) > 0.5 * threshold
            for other in kept
        ):
            kept.append(plane)
            if len(kept) == MAX_CONTENDERS:
                break
    return kept


@njit(nogil=True, cache=True)
def _score_triangles(
    points: Array,
    weights: Array,
    first: Indices,
    reach: Array,
    picks: Array,
    threshold: float,
    expected: Array,
    max_tilt: float,
    through: Array,
) -> Array:  # pragma: no cover - compiled
    """Score, share of the votes, normal and d of each triangle; zeros if it is unusable."""
    n = points.shape[0]
    scored_triangles = np.zeros((first.size, 6))
    near = np.empty(n, np.int64)
    limit = threshold * threshold
    beside = (PENALTY_BAND * threshold) ** 2
    total = weights.sum()
    for trial in range(first.size):
        a = points[first[trial]]
        count = 0
        for i in range(n):
            dx = points[i, 0] - a[0]
            dy = points[i, 1] - a[1]
            dz = points[i, 2] - a[2]
            if i != first[trial] and dx * dx + dy * dy + dz * dz <= reach[trial] ** 2:
                near[count] = i
                count += 1
        if count < 2:
            continue
        b = points[near[int(picks[trial, 0] * count)]]
        c = points[near[int(picks[trial, 1] * count)]]
        u = b - a
        v = c - a
        w = c - b
        normal = np.cross(u, v)
        twice_area = np.sqrt((normal * normal).sum())
        longest = max((u * u).sum(), (v * v).sum(), (w * w).sum())
        # A narrow triangle does not determine the tilt of the plane across its length.
        if longest == 0.0 or twice_area < 0.2 * longest:
            continue
        normal /= twice_area
        tilt_factor = 1.0
        if max_tilt > 0.0:
            tilt = np.arccos(min(1.0, abs((normal * expected).sum())))
            if tilt > max_tilt:
                continue
            tilt_factor = 1.0 / (1.0 + (tilt / HALF_SCORE_TILT) ** 2)
        d = -(normal * a).sum()
        if abs((normal * through).sum() + d) > threshold:  # false where it is NaN: not given
            continue
        score = 0.0
        share = 0.0
        for i in range(n):
            off = points[i, 0] * normal[0] + points[i, 1] * normal[1] + points[i, 2] * normal[2] + d
            if off * off <= limit:
                # MSAC (Torr and Zisserman 2000) with a sharper peak, as in `_fit_plane_robustly`.
                score += weights[i] * (1.0 - off * off / limit) ** 2
                share += weights[i]
            elif off * off <= beside:
                score -= weights[i] * PENALTY_WEIGHT
        score *= tilt_factor
        scored_triangles[trial, 0] = score
        scored_triangles[trial, 1] = share / total
        scored_triangles[trial, 2:5] = normal
        scored_triangles[trial, 5] = d
    return scored_triangles
