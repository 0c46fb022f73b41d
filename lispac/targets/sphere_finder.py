"""From a seed to the sphere it lies on: RANSAC with local sampling, fit, trimming, checks."""

from dataclasses import dataclass
from math import cos, radians

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, PlaneNotFound, SphereNotFound
from lispac.geometry.planes import fit_plane, rms_distance
from lispac.geometry.radius_search import PointGrid
from lispac.geometry.spheres import (
    Sphere,
    cap_axis,
    fit_sphere,
    rms_from_sphere,
    visible_share,
)
from lispac.messages import Message, error, note
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.plane_finder import neighbourhood_of, require_seed, seed_text
from lispac.targets.plane_ransac import BESIDE
from lispac.targets.region_growing import MAX_ROUNDS, ROBUST_ROUNDS, TRIM
from lispac.targets.sphere_ransac import draw_spheres

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

__all__ = ["RadiusRange", "SpherePatch", "find_sphere"]

# The farthest from the seed, in largest radii, at which a point can belong to its ball.
REACH = 3.0
# While points and sphere are chosen in turns, so many points are enough for the fit, and a radius
# that leaves the searched range by this factor will not return.
FIT_POINTS, MARGIN = 1000, 1.5
# Half angle of the cap that is kept. Beyond it the beam only grazes the ball, and the mixed pixels
# behind its rim come near the surface again.
CAP = radians(80.0)
# Least share of the whole surface; a full view shows half of it.
MIN_SHARE = 0.08
# Points inside the ball, or outside it by up to three thresholds, as a share of those on it. A mast
# or a bracket adds a few, a post or a wall that the sphere only touches goes on all around.
MAX_BESIDE = 0.3
# A sphere must be this much nearer to its points than a plane is.
BETTER_THAN_FLAT = 2.0


@dataclass(frozen=True)
class RadiusRange:
    """Allowed radius of a ball.

    Attributes
    ----------
    min, max : float, metres
        The span of radii to accept; equal where the radius is known.
    """

    min: float = 0.05
    max: float = 0.5

    def __post_init__(self) -> None:
        if not (0.0 < self.min <= self.max < np.inf):  # never true for a NaN
            raise InputError(error("finder.radii", least=self.min, most=self.max))

    @classmethod
    def of_known_radius(cls, radius: float) -> "RadiusRange":
        """A ball of known radius, metres."""
        return cls(radius, radius)

    @property
    def known(self) -> float | None:
        """The known radius, metres, or None."""
        return self.min if self.min == self.max else None

    @property
    def radius_message(self) -> Message:
        """A sphere of such a radius as part of a message."""
        if self.known is not None:
            return note("finder.sphere_of_radius", radius=self.known)
        return note("finder.sphere_of_radii", least=self.min, most=self.max)


@dataclass(frozen=True, eq=False)
class SpherePatch:
    """The points of one line that lie on one sphere.

    Attributes
    ----------
    indices : ndarray of shape (n,), int64
        Into the line's cloud, ascending.
    sphere : Sphere, local frame of that cloud
    rms : float, metres
        Of the points to the sphere.
    share : float
        Share of the whole surface that the points span.
    one_in : int
        Of how many points about the seed one was examined.
    """

    indices: Indices
    sphere: Sphere
    rms: float
    share: float
    one_in: int = 1

    @property
    def centre(self) -> Array:
        """Centre of the sphere, shape (3,), metres, local frame."""
        return self.sphere.centre


def find_sphere(
    points_local: Array,
    seed: Array,
    radius_range: RadiusRange,
    settings: FinderSettings,
    *,
    index: PointGrid | None = None,
) -> SpherePatch:
    """Find the sphere that the seed lies on, or near.

    Spheres are drawn through neighbouring points and judged by the points near the seed; points
    inside a sphere speak against it. The best ones are fitted to the points within the threshold
    until these no longer change. Then what lies beyond the visible cap (mixed pixels behind the
    rim) and beyond three sigma is trimmed.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres
        Points with a missing coordinate are passed over.
    seed : ndarray of shape (3,), metres, same frame
        On the ball, near it, or its centre.
    radius_range : RadiusRange
    settings : FinderSettings
    index : PointGrid, optional
        Prepared cells of the same points.

    Raises
    ------
    SphereNotFound
        No points, too few points, or no such sphere at the seed.
    """
    try:
        seed = require_seed(seed)
        near = neighbourhood_of(points_local, seed, settings, index=index)
    except PlaneNotFound as failure:  # its messages are about points, not about planes
        raise SphereNotFound(failure.reason) from None
    distance = np.linalg.norm(points_local[near] - seed, axis=1)
    reach = REACH * radius_range.max
    near = near[distance <= reach]
    if len(near) < settings.min_points:
        raise SphereNotFound(
            error(
                "finder.sphere_few_nearby",
                count=len(near),
                radius=reach,
                sphere=radius_range.radius_message,
                needed=settings.min_points,
                place=seed_text(seed),
            )
        )
    # Far from the origin of the survey the products would lose digits.
    local = points_local[near] - seed
    spread = 2.0 * radius_range.min
    votes = 1.0 / (1.0 + ((local**2).sum(axis=1) / spread**2)) ** 2
    hypotheses = draw_spheres(local, votes, radius_range.min, radius_range.max, settings)
    best: tuple[float, Sphere, Indices] | None = None
    for hypothesis in hypotheses:
        converged = _refine_sphere(local, hypothesis, radius_range, settings)
        if converged is None:
            continue
        sphere, on = converged
        merit = _sphere_votes(local, votes, sphere, settings.threshold)
        if best is None or merit > best[0]:
            best = merit, sphere, on
    if best is None:
        raise SphereNotFound(
            error(
                "finder.no_sphere",
                sphere=radius_range.radius_message,
                threshold=settings.threshold,
                place=seed_text(seed),
            )
        )
    _, sphere, on = best
    _require_ball(local, sphere, on, radius_range, settings, seed)
    indices = np.sort(near[on])
    return patch_on_sphere(points_local, indices, radius_range)


def patch_on_sphere(
    points_local: Array, indices: Indices, radius_range: RadiusRange
) -> SpherePatch:
    """The patch that chosen points of a cloud form.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres, local frame
    indices : ndarray of shape (k,), int

    Raises
    ------
    SphereNotFound
        They do not determine a sphere.
    """
    points = points_local[indices]
    sphere = fit_sphere(points, radius_range.known)
    return SpherePatch(
        indices, sphere, rms_from_sphere(sphere, points), visible_share(sphere, points)
    )


def _refine_sphere(
    points: Array, sphere: Sphere, radius_range: RadiusRange, settings: FinderSettings
) -> tuple[Sphere, Indices] | None:
    """The sphere fitted and its points chosen in turns; None where that leads nowhere."""
    on: Indices = np.empty(0, dtype=np.int64)
    try:
        for _ in range(MAX_ROUNDS):
            grown = _points_on_cap(points, sphere, settings.threshold)
            if np.array_equal(grown, on):
                break
            on = grown
            sample = on[:: max(1, len(on) // FIT_POINTS)]
            sphere = _fit_sphere_robustly(
                points[sample], sphere, radius_range.known, settings.threshold
            )
            if not radius_range.min / MARGIN <= sphere.radius <= radius_range.max * MARGIN:
                return None
        on = _trim_outliers(points, on, radius_range.known, settings)
        return fit_sphere(points[on], radius_range.known), on
    except SphereNotFound:
        return None


def _points_on_cap(points: Array, sphere: Sphere, threshold: float) -> Indices:
    """Points within the threshold and on the visible side."""
    on: Indices = np.flatnonzero(np.abs(sphere.distances(points)) <= threshold).astype(np.int64)
    directions = sphere.directions(points[on])
    visible = np.ones(len(on), dtype=bool)
    for _ in range(2):  # what lies behind the rim has drawn the first middle towards itself
        visible = directions @ cap_axis(directions[visible]) >= cos(CAP)
    return on[visible]


def _fit_sphere_robustly(
    points: Array, sphere: Sphere, radius: float | None, threshold: float
) -> Sphere:
    """Weighted fit with the biweight (Beaton and Tukey 1974).

    It converges to the densest layer of the points.
    """
    for _ in range(ROBUST_ROUNDS):
        off = sphere.distances(points) / threshold
        sphere = fit_sphere(points, radius, np.maximum(1.0 - off * off, 0.0) ** 2, sphere)
    return sphere


def _trim_outliers(
    points: Array, on: Indices, radius: float | None, settings: FinderSettings
) -> Indices:
    """Remove points beyond three sigma, the sigma taken from the middle of the residuals."""
    residuals = np.abs(fit_sphere(points[on], radius).distances(points[on]))
    sigma = 1.4826 * float(np.median(residuals))
    kept = on[residuals <= min(settings.threshold, TRIM * sigma)]
    # Noise-free points have no sigma; then all of them are kept.
    return kept if len(kept) >= max(4, len(on) // 2) else on


def _sphere_votes(points: Array, votes: Array, sphere: Sphere, threshold: float) -> float:
    """Votes of the points on the sphere, less those inside it."""
    off = sphere.distances(points) / threshold
    on = np.maximum(1.0 - off * off, 0.0) ** 2
    return float(votes @ (on - (off < -1.0)))


def _require_ball(
    points: Array,
    sphere: Sphere,
    on: Indices,
    radius_range: RadiusRange,
    settings: FinderSettings,
    seed: Array,
) -> None:
    """Refuse points that are not those of a ball, with the reason.

    Raises
    ------
    SphereNotFound
    """
    if len(on) < settings.min_points:
        raise SphereNotFound(
            error(
                "finder.sphere_few_points",
                count=len(on),
                needed=settings.min_points,
                threshold=settings.threshold,
                place=seed_text(seed),
            )
        )
    if not 0.999999 * radius_range.min <= sphere.radius <= 1.000001 * radius_range.max:
        raise SphereNotFound(
            error(
                "finder.sphere_other_radius",
                radius=sphere.radius,
                sphere=radius_range.radius_message,
                place=seed_text(seed),
            )
        )
    if sphere.distances(np.zeros(3)) > sphere.radius:
        raise SphereNotFound(
            error(
                "finder.sphere_far",
                distance=float(sphere.distances(np.zeros(3))),
                place=seed_text(seed),
            )
        )
    off = sphere.distances(points)
    beside = (off < -settings.threshold) | (
        (off > settings.threshold) & (off <= BESIDE * settings.threshold)
    )
    if np.count_nonzero(beside) > MAX_BESIDE * len(on):
        raise SphereNotFound(
            error(
                "finder.sphere_continues",
                count=len(on),
                beside=int(np.count_nonzero(beside)),
                sphere=radius_range.radius_message,
                place=seed_text(seed),
            )
        )
    share = visible_share(sphere, points[on])
    if share < MIN_SHARE:
        raise SphereNotFound(
            error("finder.sphere_small_part", share=share, needed=MIN_SHARE, place=seed_text(seed))
        )
    flat = rms_distance(fit_plane(points[on]), points[on])
    if flat < BETTER_THAN_FLAT * rms_from_sphere(sphere, points[on]):
        raise SphereNotFound(error("finder.sphere_flat", place=seed_text(seed)))
