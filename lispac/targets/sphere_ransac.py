"""RANSAC with local sampling: spheres through neighbouring points, evaluated by weighted votes."""

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.spheres import Sphere
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.plane_ransac import BATCH_SIZE, MAX_BATCHES, PENALTY_BAND, PENALTY_WEIGHT

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# Hypotheses are evaluated on all nearest points and on a sample of those farther away, so that a
# sphere with some hundred points is not thinned like a wall with a hundred thousand.
MAX_NEAREST_POINTS, MAX_FARTHER_POINTS = 2500, 2500
# The radius of a hypothesis from four noisy points may be outside the range by this fraction.
RADIUS_MARGIN_SHARE = 0.25
# Hypotheses to refine: largest number, smallest ratio to the best score, and smallest distance
# between their centres as a fraction of the radius.
MAX_CONTENDERS, MIN_SCORE_RATIO, MIN_CENTRE_DISTANCE = 8, 0.6, 0.25


def draw_spheres(
    points: Array, votes: Array, lower: float, upper: float, settings: FinderSettings
) -> list[Sphere]:
    """Spheres through neighbouring points with the best votes (Fischler and Bolles 1981).

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame, the nearest to the seed first
    votes : ndarray of shape (n,)
    lower, upper : float, metres
        Range of radii. If both are equal, the radius is known and a hypothesis is computed from
        three points, otherwise from four.
    settings : FinderSettings
    """
    rng = np.random.default_rng(settings.seed)
    step = max(1, -(-(len(points) - MAX_NEAREST_POINTS) // MAX_FARTHER_POINTS))
    sample = np.concatenate([points[:MAX_NEAREST_POINTS], points[MAX_NEAREST_POINTS::step]])
    weights = np.concatenate([votes[:MAX_NEAREST_POINTS], step * votes[MAX_NEAREST_POINTS::step]])
    chance = np.cumsum(weights / weights.sum())
    known = lower == upper
    need = 3 if known else 4
    radius_limits = np.array([lower, upper]) * (
        1.0 if known else np.array([1.0 - RADIUS_MARGIN_SHARE, 1.0 + RADIUS_MARGIN_SHARE])
    )
    hypotheses = np.empty((0, 6))
    for batch in range(1, MAX_BATCHES + 1):
        first = np.minimum(np.searchsorted(chance, rng.random(BATCH_SIZE)), len(sample) - 1)
        # From a part of the smallest sphere up to the diameter of the largest one.
        reach = np.exp(rng.uniform(np.log(0.5 * lower), np.log(2.0 * upper), BATCH_SIZE))
        picks = rng.random((BATCH_SIZE, 3))
        drawn = _score_spheres(
            sample, weights, first, reach, picks, settings.threshold, radius_limits, known
        )
        hypotheses = np.concatenate([hypotheses, drawn[drawn[:, 0] > 0.0]])
        if len(hypotheses) == 0:
            continue
        share = float(hypotheses[np.argmax(hypotheses[:, 0]), 1])
        if (1.0 - share**need) ** (batch * BATCH_SIZE) <= 1.0 - settings.stop:
            break
    return _distinct_best_spheres(hypotheses)


def _distinct_best_spheres(hypotheses: Array) -> list[Sphere]:
    """Hypotheses that differ from each other and are nearly as good as the best one."""
    kept: list[Sphere] = []
    if len(hypotheses) == 0:
        return kept
    ranked = hypotheses[np.argsort(-hypotheses[:, 0], kind="stable")]
    for row in ranked[ranked[:, 0] >= MIN_SCORE_RATIO * ranked[0, 0]]:
        sphere = Sphere(row[2:5].copy(), float(row[5]))
        if all(
            np.linalg.norm(sphere.centre - other.centre) > MIN_CENTRE_DISTANCE * other.radius
            for other in kept
        ):
            kept.append(sphere)
            if len(kept) == MAX_CONTENDERS:
                break
    return kept


@njit(nogil=True, cache=True)
def _score_spheres(
    points: Array,
    weights: Array,
    first: Indices,
    reach: Array,
    picks: Array,
    threshold: float,
    radius_limits: Array,
    known: bool,
) -> Array:  # pragma: no cover - compiled
    """Score, share of the votes, centre and radius of each hypothesis; zeros if unusable."""
    n = points.shape[0]
    scored_spheres = np.zeros((first.size, 6))
    near = np.empty(n, np.int64)
    centres = np.empty((2, 3))
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
        if count < 3:
            continue
        u = points[near[int(picks[trial, 0] * count)]] - a
        v = points[near[int(picks[trial, 1] * count)]] - a
        w = points[near[int(picks[trial, 2] * count)]] - a
        uu = (u * u).sum()
        vv = (v * v).sum()
        ww = (w * w).sum()
        normal = np.cross(u, v)
        square = (normal * normal).sum()
        # A narrow triangle does not determine the curvature across its length.
        if square < 0.01 * max(uu, vv) ** 2 or square == 0.0:
            continue
        if known:
            radius = radius_limits[0]
            middle = np.cross(uu * v - vv * u, normal) / (2.0 * square)
            left = radius * radius - (middle * middle).sum()
            if left < 0.0:
                continue
            up = normal * np.sqrt(left / square)
            centres[0] = middle + up
            centres[1] = middle - up
            sides = 2
        else:
            # The centre is as far from the first point as from each of the others.
            volume = (w * normal).sum()
            if abs(volume) < 1e-3 * max(uu, vv, ww) ** 1.5:
                continue
            centres[0] = (uu * np.cross(v, w) + vv * np.cross(w, u) + ww * normal) / (2.0 * volume)
            radius = np.sqrt((centres[0] * centres[0]).sum())
            if radius < radius_limits[0] or radius > radius_limits[1]:
                continue
            sides = 1
        for side in range(sides):
            c = a + centres[side]
            score = 0.0
            share = 0.0
            for i in range(n):
                dx = points[i, 0] - c[0]
                dy = points[i, 1] - c[1]
                dz = points[i, 2] - c[2]
                off = np.sqrt(dx * dx + dy * dy + dz * dz) - radius
                if off > PENALTY_BAND * threshold:
                    continue
                if abs(off) <= threshold:
                    # MSAC (Torr and Zisserman 2000) with a sharper peak, as for planes.
                    score += weights[i] * (1.0 - (off / threshold) ** 2) ** 2
                    share += weights[i]
                elif off > 0.0:
                    score -= weights[i] * PENALTY_WEIGHT
                else:
                    score -= weights[i]  # a sphere is solid: there are no points inside it
            if score > scored_spheres[trial, 0]:
                scored_spheres[trial, 0] = score
                scored_spheres[trial, 1] = share / total
                scored_spheres[trial, 2:5] = c
                scored_spheres[trial, 5] = radius
    return scored_spheres
