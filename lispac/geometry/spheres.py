"""Spheres: type, least-squares fit, and share of the surface that points cover."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.errors import SphereNotFound
from lispac.geometry.planes import MIN_SPREAD_RATIO
from lispac.messages import error

Array = NDArray[np.float64]

# Largest number of steps of the geometric fit; it usually converges in four to ten.
MAX_STEPS = 100
# Criteria for the end of the fit, relative to the size of the cap: smallest step, and largest
# radius, beyond which the cap is a plane.
STEP_TOLERANCE, MAX_RELATIVE_RADIUS = 1e-12, 1e5
MIN_DAMPING = 1e-10
# The sigma of the radius must be below a third of the radius (three sigma from zero). A known
# radius must fit on one side of the points better than on the other by three sigma.
CRITICAL_SIGMAS = 3.0
# Smallest eigenvalue of the normal matrix per point; rounding dominates below it.
MIN_EIGENVALUE_PER_POINT = 1e-13
# Mean square of residuals that are due to rounding alone, in squares of the size of the cap.
ROUNDING_MEAN_SQUARE = 1e-18


@dataclass(frozen=True, eq=False)
class Sphere:
    """The points X with ``|X - centre| = radius``.

    Attributes
    ----------
    centre : ndarray of shape (3,), metres, any frame
    radius : float, metres
    """

    centre: Array
    radius: float

    def distances(self, points: Array) -> Array:
        """Signed distance of each point from the surface, positive outside.

        Parameters
        ----------
        points : ndarray of shape (..., 3), metres, in the sphere's frame

        Returns
        -------
        ndarray of shape (...), metres
        """
        signed: Array = np.linalg.norm(points - self.centre, axis=-1) - self.radius
        return signed

    def directions(self, points: Array) -> Array:
        """Unit vectors from the centre to points (n, 3) in the sphere's frame."""
        from_centre = points - self.centre
        length = np.linalg.norm(from_centre, axis=1, keepdims=True)
        unit: Array = from_centre / np.where(length > 0.0, length, 1.0)
        return unit


def fit_sphere(
    points: Array,
    radius: float | None = None,
    weights: Array | None = None,
    start: Sphere | None = None,
) -> Sphere:
    """Fit a sphere by least squares of the distances from its surface.

    A cap is enough: a scanner sees at most half of a ball.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, any frame
    radius : float, metres, optional
        The known radius; estimated if omitted.
    weights : ndarray of shape (n,), optional
        Not negative; all equal if omitted.
    start : Sphere, optional
        Initial value. If omitted, the fit starts from the algebraic solution and, for a known
        radius, from both sides of the points; the better result is used.

    Raises
    ------
    SphereNotFound
        The radius is not positive, a coordinate is not finite, there are fewer than four points, or
        they lie in one plane. Or the cap is so flat, compared with its noise, that it does not
        determine the radius or, with a known radius, the side on which the centre lies.
    """
    if radius is not None and not (np.isfinite(radius) and radius > 0.0):
        raise SphereNotFound(error("target.sphere_radius", radius=float(radius)))
    weights = np.ones(len(points)) if weights is None else weights
    used = weights > 0.0
    points, weights = points[used], weights[used]
    if len(points) < 4:
        raise SphereNotFound(error("target.sphere_few_points", count=len(points)))
    # Centred coordinates: squares of UTM coordinates would not resolve millimetres.
    mean = weights @ points / weights.sum()
    local = points - mean
    if not np.all(np.isfinite(local)):
        raise SphereNotFound(error("target.sphere_not_finite"))
    weights = weights / weights.mean()
    spread, axes = np.linalg.eigh((local * weights[:, None]).T @ local / len(local))
    if spread[0] <= spread[2] * MIN_SPREAD_RATIO**2:
        raise SphereNotFound(error("target.sphere_in_plane"))
    # In units of the size of the cap, all tolerances are numbers without unit.
    size = float(np.sqrt(spread.sum()))
    scaled = np.ascontiguousarray(local / size)
    start_centre = None if start is None else (start.centre - mean) / size
    if radius is None:
        first = _fit_algebraically(scaled, weights)
        if start is not None and start_centre is not None:
            first = Sphere(start_centre, start.radius / size)
        sphere = _fit_free_radius(scaled, weights, first)
        return Sphere(mean + size * sphere.centre, size * sphere.radius)
    if start_centre is None:
        offset = np.sqrt(max((radius / size) ** 2 - 1.0, (0.1 * radius / size) ** 2))
        cap_normal = np.ascontiguousarray(axes[:, 0])
        centres = [
            _fit_algebraically(scaled, weights).centre,
            offset * cap_normal,
            -offset * cap_normal,
        ]
    else:
        centres = [start_centre]
    sphere = _fit_known_radius(
        scaled, weights, [Sphere(centre, radius / size) for centre in centres]
    )
    return Sphere(mean + size * sphere.centre, radius)


def rms_from_sphere(sphere: Sphere, points: Array) -> float:
    """Root mean square distance of points (n, 3) from the surface in their frame, metres."""
    return float(np.sqrt(np.mean(sphere.distances(points) ** 2)))


def cap_axis(directions: Array) -> Array:
    """Mean, shape (3,), of directions (n, 3) from a sphere's centre: unit vectors in one frame."""
    total = directions.sum(axis=0)
    length = float(np.linalg.norm(total))
    axis: Array = total / length if length > 0.0 else np.array([0.0, 0.0, 1.0])
    return axis


def visible_share(sphere: Sphere, points: Array) -> float:
    """Share of the whole surface that points (n, 3) in its frame cover, 0.5 for a full half.

    The share is the area inside the outline of the points in Lambert's equal-area projection about
    the centre of the cap, so that it does not depend on the density of the points.
    """
    from scipy.spatial import ConvexHull, QhullError

    directions = sphere.directions(points)
    axis = cap_axis(directions)
    across = np.linalg.svd(axis[None, :])[2][1:]
    cosine = np.clip(directions @ axis, -1.0, 1.0)
    placed = directions @ across.T * np.sqrt(2.0 / np.maximum(1.0 + cosine, 1e-12))[:, None]
    try:
        return float(ConvexHull(placed).volume / (4.0 * np.pi))
    except (QhullError, ValueError):  # fewer than three points, or all on one line: no area
        return 0.0


def _fit_free_radius(points: Array, weights: Array, start: Sphere) -> Sphere:
    """Fit centre and radius.

    Raises
    ------
    SphereNotFound
        If the noise is too large to determine the radius.
    """
    sphere, square, normal = _refine_sphere(points, weights, start, free=True)
    limit = MIN_EIGENVALUE_PER_POINT * len(points)
    flat = not sphere.radius < MAX_RELATIVE_RADIUS or np.linalg.eigvalsh(normal)[0] <= limit
    if not flat:
        variance = square / max(1, len(points) - 4) * float(np.linalg.inv(normal)[3, 3])
        flat = CRITICAL_SIGMAS * float(np.sqrt(variance)) > sphere.radius
    if flat:
        raise SphereNotFound(error("target.sphere_little_curved"))
    return sphere


def _fit_algebraically(points: Array, weights: Array) -> Sphere:
    """Algebraic fit ``|X|^2 = 2 c.X + k``: approximate, in one step."""
    root = np.sqrt(weights)
    rows = np.column_stack([2.0 * points, np.ones(len(points))]) * root[:, None]
    solution = np.linalg.lstsq(rows, (points**2).sum(axis=1) * root, rcond=None)[0]
    centre = solution[:3]
    return Sphere(centre, float(np.sqrt(max(solution[3] + centre @ centre, 1e-6))))


def _fit_known_radius(points: Array, weights: Array, starts: list[Sphere]) -> Sphere:
    """Fit the centre of spheres of known radius from every start.

    Raises
    ------
    SphereNotFound
        If the points do not determine the centre, or the side on which it lies.
    """
    converged = [_refine_sphere(points, weights, start, free=False) for start in starts]
    converged.sort(key=lambda fit: fit[1])
    best, square, normal = converged[0]
    if np.linalg.eigvalsh(normal)[0] <= MIN_EIGENVALUE_PER_POINT * len(points):
        raise SphereNotFound(error("target.sphere_small_part"))
    redundancy = max(1, len(points) - 3)
    uncertainty = CRITICAL_SIGMAS**2 * square / redundancy + ROUNDING_MEAN_SQUARE * len(points)
    for other, its_square, _ in converged[1:]:
        other_side = float(np.linalg.norm(other.centre - best.centre)) > 0.1 * best.radius
        if other_side and its_square - square <= uncertainty:
            raise SphereNotFound(error("target.sphere_side"))
    return best


def _refine_sphere(
    points: Array, weights: Array, start: Sphere, *, free: bool
) -> tuple[Sphere, float, Array]:
    """Sphere, weighted sum of squares and normal matrix of the converged fit."""
    centre, radius, square, normal = _minimise_distances(
        points, weights, start.centre, start.radius, free
    )
    return Sphere(centre, radius), square, normal


@njit(nogil=True, cache=True)
def _minimise_distances(
    points: Array, weights: Array, centre: Array, radius: float, free: bool
) -> tuple[Array, float, float, Array]:  # pragma: no cover - compiled
    """Gauss-Newton with the damping of Levenberg (1944) and Marquardt (1963)."""
    size = 4 if free else 3
    damping = 1e-3
    total = weights.sum()
    normal, right_side, square = _sphere_normal_equations(points, weights, centre, radius, size)
    for _ in range(MAX_STEPS):
        damped = normal + damping * total * np.eye(size)
        step = np.linalg.solve(damped, right_side)
        new_centre = centre + step[:3]
        new_radius = radius + step[3] if free else radius
        sums = _sphere_normal_equations(points, weights, new_centre, new_radius, size)
        if new_radius > 0.0 and sums[2] <= square:
            centre, radius = new_centre, new_radius
            normal, right_side, square = sums
            damping = max(0.1 * damping, MIN_DAMPING)
        else:
            damping *= 10.0
        if (
            np.sqrt((step * step).sum()) <= STEP_TOLERANCE * max(1.0, radius)
            or radius > MAX_RELATIVE_RADIUS
        ):
            break
    return centre, radius, square, normal


@njit(nogil=True, cache=True)
def _sphere_normal_equations(
    points: Array, weights: Array, centre: Array, radius: float, size: int
) -> tuple[Array, Array, float]:  # pragma: no cover - compiled
    """Normal matrix, right-hand side and sum of squares of the conditions |X - c| - r = 0."""
    normal = np.zeros((size, size))
    right_side = np.zeros(size)
    square = 0.0
    row = np.ones(4)  # negative derivatives of the condition by the centre and the radius
    for i in range(points.shape[0]):
        x = points[i, 0] - centre[0]
        y = points[i, 1] - centre[1]
        z = points[i, 2] - centre[2]
        length = np.sqrt(x * x + y * y + z * z)
        if length > 0.0:
            row[0] = x / length
            row[1] = y / length
            row[2] = z / length
        off = length - radius
        square += weights[i] * off * off
        for a in range(size):
            share = weights[i] * row[a]
            right_side[a] += share * off
            for b in range(a + 1):
                normal[a, b] += share * row[b]
    for a in range(size):
        for b in range(a):
            normal[b, a] = normal[a, b]
    return normal, right_side, square
