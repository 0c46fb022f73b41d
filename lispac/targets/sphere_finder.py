"""Find the sphere at a seed: RANSAC with local sampling, fit, trimming, checks."""

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
from lispac.targets.plane_ransac import PENALTY_BAND
from lispac.targets.region_growing import MAX_ROUNDS, ROBUST_FIT_STEPS, TRIM_LIMIT_SIGMAS
from lispac.targets.sphere_ransac import draw_spheres

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

__all__ = ["RadiusRange", "SpherePatch", "find_sphere"]

# Largest distance of a point of the sphere from the seed, in units of the largest radius.
MAX_SEED_DISTANCE_RADII = 3.0
# While the choice of points and the fit alternate: size of the sample used for the fit (of more
# points, between this number and twice this number), and factor by which the radius may be outside
# the allowed range.
FIT_SAMPLE_SIZE, RADIUS_MARGIN_FACTOR = 1000, 1.5
# Half angle of the cap that is used. Beyond it, the beams graze the sphere, and mixed pixels behind
# the rim lie near its surface.
CAP_HALF_ANGLE = radians(80.0)
# Smallest visible share of the whole surface; an unobstructed view shows half of it.
MIN_VISIBLE_SHARE = 0.08
# Largest ratio of the points inside the sphere, or up to three thresholds outside it, to the points
# on it. A mast or a bracket adds few such points, a post or a wall that touches the sphere many.
MAX_OFF_SPHERE_RATIO = 0.3
# Smallest ratio of the residuals of a plane to those of the sphere.
MIN_PLANE_RESIDUAL_RATIO = 2.0


@dataclass(frozen=True)
class RadiusRange:
    """Allowed radius of a sphere.

    Attributes
    ----------
    min, max : float, metres
        Smallest and largest radius; equal if the radius is known.
    """

    min: float = 0.05
    max: float = 0.5

    def __post_init__(self) -> None:
        if not (0.0 < self.min <= self.max < np.inf):  # never true for a NaN
            raise InputError(error("finder.radii", least=self.min, most=self.max))

    @classmethod
    def of_known_radius(cls, radius: float) -> "RadiusRange":
        """Range for a known radius, metres."""
        return cls(radius, radius)

    @property
    def known(self) -> float | None:
        """Known radius, metres, or None."""
        return self.min if self.min == self.max else None

    @property
    def radius_message(self) -> Message:
        """Description of a sphere with this radius, as part of a message."""
        if self.known is not None:
            return note("finder.sphere_of_radius", radius=self.known)
        return note("finder.sphere_of_radii", least=self.min, most=self.max)


@dataclass(frozen=True, eq=False)
class SpherePatch:
    """Points of one line that lie on one sphere.

    Attributes
    ----------
    indices : ndarray of shape (n,), int64
        Indices into the cloud of the line, ascending.
    sphere : Sphere, local frame of that cloud
    rms : float, metres
        RMS distance of the points from the sphere.
    share : float
        Share of the whole surface that the points cover.
    one_in : int
        Sampling of the points around the seed: one in this number was used.
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
    """Find the sphere on or near which the seed lies.

    Candidate spheres are drawn through neighbouring points and evaluated with the points near the
    seed; points inside a sphere reduce its score. The best spheres are fitted to the points within
    the threshold until these points no longer change. Finally, points beyond the visible cap (mixed
    pixels behind the rim) and beyond three sigma are removed.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres
        Points with a coordinate that is not finite are ignored.
    seed : ndarray of shape (3,), metres, same frame
        A point on the sphere, near it, or its centre.
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
    except PlaneNotFound as failure:  # its messages are about points only, not about planes
        raise SphereNotFound(failure.reason) from None
    distance = np.linalg.norm(points_local[near] - seed, axis=1)
    reach = MAX_SEED_DISTANCE_RADII * radius_range.max
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
    best = _best_sphere(local, radius_range, settings)
    if best is None:
        raise SphereNotFound(
            error(
                "finder.no_sphere",
                sphere=radius_range.radius_message,
                threshold=settings.threshold,
                place=seed_text(seed),
            )
        )
    sphere, on = best
    _require_sphere(local, sphere, on, radius_range, settings, seed)
    indices = np.sort(near[on])
    return patch_on_sphere(points_local, indices, radius_range)


def _best_sphere(
    local: Array, radius_range: RadiusRange, settings: FinderSettings
) -> tuple[Sphere, Indices] | None:
    """Fitted sphere with the most votes and the indices of its points; None if there is none.

    Parameters
    ----------
    local : ndarray of shape (n, 3), metres
        Points relative to the seed; those near it have more weight.
    """
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
    return None if best is None else best[1:]


def patch_on_sphere(
    points_local: Array, indices: Indices, radius_range: RadiusRange
) -> SpherePatch:
    """Patch of chosen points of a cloud.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres, local frame
    indices : ndarray of shape (k,), int

    Raises
    ------
    SphereNotFound
        If the points do not determine a sphere.
    """
    points = points_local[indices]
    sphere = fit_sphere(points, radius_range.known)
    return SpherePatch(
        indices, sphere, rms_from_sphere(sphere, points), visible_share(sphere, points)
    )


def _refine_sphere(
    points: Array, sphere: Sphere, radius_range: RadiusRange, settings: FinderSettings
) -> tuple[Sphere, Indices] | None:
    """Fit the sphere and choose its points alternately; None if this does not succeed."""
    on: Indices = np.empty(0, dtype=np.int64)
    try:
        for _ in range(MAX_ROUNDS):
            grown = _points_on_cap(points, sphere, settings.threshold)
            if np.array_equal(grown, on):
                break
            on = grown
            sample = on[:: max(1, len(on) // FIT_SAMPLE_SIZE)]
            sphere = _fit_sphere_robustly(
                points[sample], sphere, radius_range.known, settings.threshold
            )
            if (
                not radius_range.min / RADIUS_MARGIN_FACTOR
                <= sphere.radius
                <= radius_range.max * RADIUS_MARGIN_FACTOR
            ):
                return None
        on = _trim_outliers(points, on, radius_range.known, settings)
        return fit_sphere(points[on], radius_range.known), on
    except SphereNotFound:
        return None


def _points_on_cap(points: Array, sphere: Sphere, threshold: float) -> Indices:
    """Points within the threshold and on the visible cap."""
    on: Indices = np.flatnonzero(np.abs(sphere.distances(points)) <= threshold).astype(np.int64)
    directions = sphere.directions(points[on])
    visible = np.ones(len(on), dtype=bool)
    for _ in range(2):  # points behind the rim have shifted the first centre of the cap
        visible = directions @ cap_axis(directions[visible]) >= cos(CAP_HALF_ANGLE)
    return on[visible]


def _fit_sphere_robustly(
    points: Array, sphere: Sphere, radius: float | None, threshold: float
) -> Sphere:
    """Weighted fit with the biweight (Beaton and Tukey 1974).

    The fit converges to the densest layer of the points.
    """
    for _ in range(ROBUST_FIT_STEPS):
        off = sphere.distances(points) / threshold
        sphere = fit_sphere(points, radius, np.maximum(1.0 - off * off, 0.0) ** 2, sphere)
    return sphere


def _trim_outliers(
    points: Array, on: Indices, radius: float | None, settings: FinderSettings
) -> Indices:
    """Remove points beyond three sigma, with sigma from the median of the residuals."""
    residuals = np.abs(fit_sphere(points[on], radius).distances(points[on]))
    sigma = 1.4826 * float(np.median(residuals))
    kept = on[residuals <= min(settings.threshold, TRIM_LIMIT_SIGMAS * sigma)]
    # Sigma of noise-free points is zero; all of them are kept.
    return kept if len(kept) >= max(4, len(on) // 2) else on


def _sphere_votes(points: Array, votes: Array, sphere: Sphere, threshold: float) -> float:
    """Votes of the points on the sphere minus those of the points inside it."""
    off = sphere.distances(points) / threshold
    on = np.maximum(1.0 - off * off, 0.0) ** 2
    return float(votes @ (on - (off < -1.0)))


def _require_sphere(
    points: Array,
    sphere: Sphere,
    on: Indices,
    radius_range: RadiusRange,
    settings: FinderSettings,
    seed: Array,
) -> None:
    """Refuse points that do not show a sphere, with the reason.

    Raises
    ------
    SphereNotFound
        If the points are too few, show too small a part, or belong to another surface.
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
        (off > settings.threshold) & (off <= PENALTY_BAND * settings.threshold)
    )
    if np.count_nonzero(beside) > MAX_OFF_SPHERE_RATIO * len(on):
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
    if share < MIN_VISIBLE_SHARE:
        raise SphereNotFound(
            error(
                "finder.sphere_small_part",
                share=share,
                needed=MIN_VISIBLE_SHARE,
                place=seed_text(seed),
            )
        )
    flat = rms_distance(fit_plane(points[on]), points[on])
    if flat < MIN_PLANE_RESIDUAL_RATIO * rms_from_sphere(sphere, points[on]):
        raise SphereNotFound(error("finder.sphere_flat", place=seed_text(seed)))
