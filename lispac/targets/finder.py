"""From a seed to the plane it lies on: RANSAC with local sampling, growth, trimming, fit."""

from dataclasses import dataclass, field
from math import radians

import numpy as np
from numba import njit
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
from lispac.geometry.neighbours import PointGrid, nearest_point, points_within
from lispac.geometry.planes import (
    Plane,
    extent_in_plane,
    fit_plane,
    in_plane_axes,
    plane_through,
    rms_distance,
)
from lispac.targets import outline

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# Hypotheses are scored on at most this many points; the patch itself is taken from all of them.
SAMPLE = 4000
# A batch of hypotheses, after which the stop criterion is looked at, and the most batches.
BATCH, MOST_BATCHES = 128, 12
# The distance from the seed within which a point counts fully when planes compete for it, metres.
NEAR = 0.25
# The widest triangle, as a share of the search radius, from which a hypothesis is drawn.
LOCAL = 0.5
# Rounds of growing and fitting; they settle in two to five.
MOST_ROUNDS = 12
# Points beside the plane, up to so many thresholds off, speak against it: a plane that cuts across
# other surfaces has them on both sides, a surface of its own does not.
BESIDE, AGAINST = 3.0, 0.3
# A cell of the patch is kept when its share of points on the plane is at least this part of the
# share around the seed; where another surface runs through the plane it is far smaller.
PURE = 0.6
# How much a hypothesis may lean from the expected normal before it counts half, radians.
LEAN = radians(10.0)
# Hypotheses grown to see which carries farthest: how many, how good beside the best by votes, and
# how much they must differ in tilt (radians).
CONTENDERS, WORTH, APART = 6, 0.7, radians(2.0)
# Steps of the weighted fit in one round of growing.
ROBUST_ROUNDS = 5
# Noise is normal: beyond three sigma a point is more likely to be a mixed pixel.
TRIM = 3.0


@dataclass(frozen=True)
class FinderSettings:
    """How a plane is sought.

    Attributes
    ----------
    radius : float, metres
        Only points this near to the seed can belong to the patch. A wide surface, a wall or a
        tower face, is cut there.
    threshold : float, metres
        Farthest a point may lie from its plane (thesis default 0.01).
    stop : float, in (0, 1)
        Stop criterion (thesis default 0.98). Planes are drawn until the probability of having
        drawn one free of outliers, given the share of the points near the seed that the best
        plane so far holds, reaches this value.
    min_points : int
        Smallest patch that counts as found.
    max_tilt : float, radians
        Largest angle between a target in one line and the same target in another, or between
        the plane and an expected normal.
    max_shift : float, metres
        Farthest the prior boresight may displace a target from one line to another.
    seed : int
        Seed of the random draws: the same points and settings give the same patch.
    """

    radius: float = 2.0
    threshold: float = 0.01
    stop: float = 0.98
    min_points: int = 30
    max_tilt: float = field(default=radians(15.0))
    max_shift: float = 2.5
    seed: int = 0

    def __post_init__(self) -> None:
        for name, good in (
            ("radius", self.radius > 0.0),
            ("threshold", self.threshold > 0.0),
            ("stop", 0.0 < self.stop < 1.0),
            ("min_points", self.min_points >= 3),
            ("max_tilt", self.max_tilt > 0.0),
            ("max_shift", self.max_shift >= 0.0),
        ):
            if not good:  # a NaN fails every comparison, so it ends here too
                raise PlaneNotFound(
                    f"The plane finder cannot work with {name} = {getattr(self, name)}."
                )


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
    centre : ndarray of shape (3,), metres
        Mean of the points.
    extent : ndarray of shape (2,), metres
        Width (level) and height (up the slope).
    """

    indices: Indices
    plane: Plane
    rms: float
    centre: Array
    extent: Array


def find_plane(
    points_local: Array,
    seed: Array,
    settings: FinderSettings,
    *,
    index: PointGrid | None = None,
    expected_normal: Array | None = None,
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
    expected_normal : ndarray of shape (3,), optional
        Only planes within ``settings.max_tilt`` of this normal are taken.

    Raises
    ------
    PlaneNotFound
        No points, too few points, or no plane within the radius of the seed.
    """
    seed = checked_seed(seed)
    near = neighbourhood(points_local, seed, settings, index=index)
    points = points_local[near]
    # The seed itself may float before the surface; the nearest point is on something real.
    reach = np.linalg.norm(points - points[0], axis=1)
    # The far field still votes, but its many points cannot outvote the few around the seed.
    votes = 1.0 / (1.0 + (reach / NEAR) ** 2) ** 1.5
    # A seed on a point is a click on a surface, and only a plane through it is meant.
    clicked = points[0] if float(np.linalg.norm(points[0] - seed)) <= settings.threshold else None
    return extract(
        points,
        near,
        votes,
        settings,
        describe_seed(seed),
        expected_normal=expected_normal,
        through=clicked,
    )


def checked_seed(seed: Array) -> Array:
    """The seed as an array of three numbers; raises PlaneNotFound when it is not one."""
    seed = np.asarray(seed, dtype=np.float64)
    if seed.shape != (3,) or not np.all(np.isfinite(seed)):
        raise PlaneNotFound("The seed must be three numbers: north, west and up, in metres.")
    return seed


def describe_seed(seed: Array) -> str:
    """The seed in the words of the messages."""
    return f"({seed[0]:.2f}, {seed[1]:.2f}, {seed[2]:.2f})"


def neighbourhood(
    points_local: Array,
    centre: Array,
    settings: FinderSettings,
    *,
    index: PointGrid | None = None,
) -> Indices:
    """Indices of the points within the radius of ``centre``, the nearest first.

    In this order every later step is the same for the same points, whatever order they came in.

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
        where = f"within {settings.radius:g} m of {describe_seed(centre)}"
        if len(near) > 0:
            raise PlaneNotFound(
                f"Only {len(near)} points lie {where}, fewer than the {settings.min_points} "
                "a target needs; move the seed or enlarge the radius."
            )
        _, distance = nearest_point(points_local, centre)
        raise PlaneNotFound(
            f"No points lie {where}"
            + (f"; the nearest is {distance:.2f} m away." if np.isfinite(distance) else ".")
        )
    points = points_local[near]
    squared = ((points - centre) ** 2).sum(axis=1)
    order = np.lexsort((points[:, 2], points[:, 1], points[:, 0], squared))
    ordered: Indices = near[order]
    return ordered


def extract(
    points: Array,
    indices: Indices,
    votes: Array,
    settings: FinderSettings,
    where: str,
    *,
    expected_normal: Array | None = None,
    through: Array | None = None,
) -> PlanePatch:
    """The patch that gathers most votes.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres
        The neighbourhood, in an order that does not depend on the file's.
    indices : ndarray of shape (n,)
        Their places in the line's cloud.
    votes : ndarray of shape (n,)
        How much each point has to say about which plane is meant.
    settings : FinderSettings
    where : str
        For the messages.
    expected_normal : ndarray of shape (3,), optional
    through : ndarray of shape (3,), metres, optional
        A point that the plane must hold.

    Raises
    ------
    PlaneNotFound
    """
    origin = points[0]
    local = points - origin
    held = None if through is None else through - origin
    contenders = _draw(local, votes, settings, expected_normal, held)
    if not contenders:
        raise PlaneNotFound(
            f"No plane within {settings.threshold:g} m holds the points around {where}."
        )
    on = _grow(local, votes, _strongest(local, votes, contenders, settings, held), settings, held)
    on = _trimmed(local, on, settings)
    if len(on) < settings.min_points:
        raise PlaneNotFound(
            f"The flat patch around {where} has only {len(on)} points, fewer than "
            f"{settings.min_points}; a wider threshold than {settings.threshold:g} m may help."
        )
    plane = fit_plane(points[on])
    if expected_normal is not None:
        plane = plane.facing(expected_normal)
        if plane.tilt_to(plane_through(origin, expected_normal)) > settings.max_tilt:
            raise PlaneNotFound(f"The plane around {where} is inclined otherwise than expected.")
    return _patch(points[on], np.sort(indices[on]), plane)


def patch_of(points_local: Array, indices: Indices, direction: Array) -> PlanePatch:
    """The patch that chosen points of a cloud form, its normal on the side of ``direction``."""
    points = points_local[indices]
    return _patch(points, indices, fit_plane(points).facing(direction))


def _patch(points: Array, indices: Indices, plane: Plane) -> PlanePatch:
    return PlanePatch(
        indices=indices,
        plane=plane,
        rms=rms_distance(plane, points),
        centre=points.mean(axis=0),
        extent=extent_in_plane(plane, points),
    )


def _draw(
    points: Array,
    votes: Array,
    settings: FinderSettings,
    expected_normal: Array | None,
    through: Array | None,
) -> list[Plane]:
    """The best planes through three neighbouring points (Fischler and Bolles 1981), by votes."""
    rng = np.random.default_rng(settings.seed)
    step = max(1, len(points) // SAMPLE)
    sample, weights = points[::step], votes[::step]
    chance = np.cumsum(weights / weights.sum())
    normal = np.zeros(3) if expected_normal is None else np.asarray(expected_normal, np.float64)
    most = settings.max_tilt if expected_normal is not None else -1.0
    held = np.full(3, np.nan) if through is None else through
    hypotheses = np.empty((0, 6))
    for batch in range(1, MOST_BATCHES + 1):
        first = np.minimum(np.searchsorted(chance, rng.random(BATCH)), len(sample) - 1)
        # From the spacing of points up to the size of a board: small faces need small triangles,
        # noisy ones wide triangles, and which it is nobody knows beforehand.
        reach = settings.radius * LOCAL * 2.0 ** -rng.uniform(0.0, 4.0, BATCH)
        picks = rng.random((BATCH, 2))
        drawn = _judge(sample, weights, first, reach, picks, settings.threshold, normal, most, held)
        scored = drawn[drawn[:, 0] > 0.0]
        hypotheses = np.concatenate([hypotheses, scored])
        if len(hypotheses) == 0:
            continue
        share = float(hypotheses[np.argmax(hypotheses[:, 0]), 1])
        if (1.0 - share**3) ** (batch * BATCH) <= 1.0 - settings.stop:
            break
    return _contenders(hypotheses, settings.threshold)


def _contenders(hypotheses: Array, threshold: float) -> list[Plane]:
    """The best hypotheses that differ and are nearly as good as the very best."""
    kept: list[Plane] = []
    if len(hypotheses) == 0:
        return kept
    ranked = hypotheses[np.argsort(-hypotheses[:, 0], kind="stable")]
    for row in ranked[ranked[:, 0] >= WORTH * ranked[0, 0]]:
        plane = Plane(row[2:5].copy(), float(row[5]))
        if all(
            plane.tilt_to(other) > APART
            or abs(plane.facing(other.normal).d - other.d) > 0.5 * threshold
            for other in kept
        ):
            kept.append(plane)
            if len(kept) == CONTENDERS:
                break
    return kept


def _grow(
    points: Array, votes: Array, plane: Plane, settings: FinderSettings, through: Array | None
) -> Indices:
    """Points connected with the votes on the plane, fitted and grown in turns."""
    on: Indices = np.empty(0, dtype=np.int64)
    for _ in range(MOST_ROUNDS):
        grown = _connected_on(points, votes, plane, settings.threshold)
        if len(grown) < 3 or np.array_equal(grown, on):
            break
        fitted = _robust_plane(points[grown], plane, settings.threshold)
        # A larger surface nearby must not draw the plane off the point that was clicked.
        if through is not None and abs(float(fitted.distances(through))) > settings.threshold:
            on = grown if len(on) == 0 else on
            break
        on, plane = grown, fitted
    return on


def _strongest(
    points: Array,
    votes: Array,
    contenders: list[Plane],
    settings: FinderSettings,
    through: Array | None,
) -> Plane:
    """The contender that has grown to the most points near its plane.

    Near the seed alone several planes of different tilt may look alike; how far each one carries
    tells them apart.
    """
    if len(contenders) == 1:
        return contenders[0]
    step = max(1, len(points) // SAMPLE)
    sample, weights = points[::step], votes[::step]
    best_merit, best = -1.0, contenders[0]
    for plane in contenders:
        on = _grow(sample, weights, plane, settings, through)
        if len(on) < 3:
            continue
        fitted = _robust_plane(sample[on], plane, settings.threshold)
        off = fitted.distances(sample[on]) / settings.threshold
        merit = float((np.maximum(1.0 - off * off, 0.0) ** 2).sum())
        if merit > best_merit:
            best_merit, best = merit, fitted
    return best


def _robust_plane(points: Array, plane: Plane, threshold: float) -> Plane:
    """Weighted fit with Tukey's biweight, which settles on the densest layer of the points.

    A plain fit of everything within the threshold is content with a tilted plane that
    fills the threshold evenly, where surfaces are uneven or run into each other.
    """
    for _ in range(ROBUST_ROUNDS):
        off = plane.distances(points) / threshold
        weights = np.maximum(1.0 - off * off, 0.0) ** 2
        if np.count_nonzero(weights) < 3:
            break
        plane = fit_plane(points, weights)
    return plane


def _connected_on(points: Array, votes: Array, plane: Plane, threshold: float) -> Indices:
    off = np.abs(plane.distances(points))
    band = np.flatnonzero(off <= BESIDE * threshold)
    on = off[band] <= threshold
    if np.count_nonzero(on) < 3:
        return band[on]
    placed = points[band] @ in_plane_axes(plane.normal).T
    weights = votes[band] * on
    cell = outline.cell_size(placed[on], weights[on])
    share = outline.share_in_cell(placed, on, cell)
    on &= share >= PURE * np.average(share, weights=weights)
    if np.count_nonzero(on) < 3:
        return band[on]
    return band[on][outline.connected(placed[on], weights[on], cell)]


def _trimmed(points: Array, on: Indices, settings: FinderSettings) -> Indices:
    """Drop what lies beyond three sigma, the sigma taken from the middle of the residuals."""
    if len(on) < 3:
        return on
    plane = fit_plane(points[on])
    residuals = plane.distances(points[on])
    sigma = 1.4826 * float(np.median(np.abs(residuals)))
    limit = min(settings.threshold, TRIM * sigma)
    kept = on[np.abs(residuals) <= limit]
    # Noise-free points have no sigma; then all of them are kept.
    return kept if len(kept) >= max(3, len(on) // 2) else on


@njit(nogil=True, cache=True)
def _judge(
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
    """Score, share of the votes, and plane (normal, d) of each triangle; zeros for a useless one."""
    n = points.shape[0]
    judged = np.zeros((first.size, 6))
    near = np.empty(n, np.int64)
    limit = threshold * threshold
    beside = (BESIDE * threshold) ** 2
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
        # A sliver says nothing about the plane across its length.
        if longest == 0.0 or twice_area < 0.2 * longest:
            continue
        normal /= twice_area
        trust = 1.0
        if max_tilt > 0.0:
            tilt = np.arccos(min(1.0, abs((normal * expected).sum())))
            if tilt > max_tilt:
                continue
            trust = 1.0 / (1.0 + (tilt / LEAN) ** 2)
        d = -(normal * a).sum()
        if abs((normal * through).sum() + d) > threshold:  # never for a missing one, a NaN
            continue
        score = 0.0
        share = 0.0
        for i in range(n):
            off = (
                points[i, 0] * normal[0] + points[i, 1] * normal[1] + points[i, 2] * normal[2] + d
            )
            if off * off <= limit:
                # MSAC (Torr and Zisserman 2000) with a sharper peak, as in `_robust_plane`.
                score += weights[i] * (1.0 - off * off / limit) ** 2
                share += weights[i]
            elif off * off <= beside:
                score -= weights[i] * AGAINST
        score *= trust
        judged[trial, 0] = score
        judged[trial, 1] = share / total
        judged[trial, 2:5] = normal
        judged[trial, 5] = d
    return judged
