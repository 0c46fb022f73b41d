"""Quality of one sighting: a rating and its reasons."""

from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import Plane, extent_in_plane, plane_axes, rms_distance
from lispac.geometry.spheres import Sphere, rms_from_sphere, visible_share
from lispac.messages import Level, Message, Value, note
from lispac.targets import outline
from lispac.targets.boresight_smear import PRIOR_BORESIGHT_SIGMA, beam_intersections, remove_smear
from lispac.targets.occlusion import VISIBLE_SHARE_LIMITS, ObservedExtent

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Rating = Literal["good", "doubtful", "poor"]

# Pairs of limits: a sighting is doubtful beyond the first and poor beyond the second.
# Number of points; with fewer, outliers and random gaps in the outline dominate the plane.
POINT_COUNT_LIMITS = (200, 50)
# RMS divided by the noise: 1 with noise alone; mixed pixels add a tenth.
NOISE_RATIO_LIMITS = (2.0, 3.0)
# Ratio of the RMS to the threshold of the search above which more of the surface probably lies
# beyond the threshold; it is 0.58 if the points are spread evenly up to the threshold. A surface
# whose RMS exceeds the first limit of the noise is then rated poor.
MAX_RMS_TO_THRESHOLD = 0.5
# Angle of incidence, degrees; the beam footprint grows with 1 / cosine, to four times at 75.
INCIDENCE_LIMITS_DEG = (65.0, 75.0)
# Share of the outline with points; if half is missing, the tilt depends on the remaining parts.
COVERAGE_LIMITS = (0.7, 0.5)
# Deviation of the surface from a plane, divided by the noise of a point: the sagitta for a bend,
# and the RMS for roughness. The first limit is the noise of a single point; at the second one, the
# deviation shifts the plane by more than its noise. A sagitta of three times the noise has an RMS
# of once the noise; roughness averages out more than a bend.
SAGITTA_LIMITS, ROUGHNESS_LIMITS = (1.0, 3.0), (1.0, 1.5)
# Significance level of the tests whether a deviation exists, and whether it exceeds a limit.
TEST_LEVEL = 1e-3
TEST_LIMIT_SIGMAS = -NormalDist().inv_cdf(TEST_LEVEL)
# Share of a sphere's surface; a full view shows half of it.
SPHERE_SHARE_LIMITS = (0.2, 0.12)


@dataclass(frozen=True, eq=False)
class SightingQuality:
    """Quality of one sighting (a target on a line).

    Attributes
    ----------
    points : int
    rms : float, metres
        RMS distance of the points from the plane or sphere.
    range : float, metres
        Median distance from the scanner.
    density : float or None, points per square metre
    incidence : float or None, radians
        Mean angle between beam and normal; None if the position of the scanner is unknown.
    extent : ndarray of shape (2,) or None, metres
        Width (horizontal) and height (up the slope).
    coverage : float
        Share of the cells of the outline that contain points; for a sphere, visible share of its
        surface.
    curvature : float or None, metres
        Sagitta of the surface over its extent, in the direction of the largest curvature.
    curved : bool
        Whether the curvature is significant.
    roughness : float or None, metres
        RMS deviation of the surface from its smooth shape, without the noise of the points.
    smear : float or None, metres
        RMS of the deviations that an error of the boresight can explain. They are removed before
        RMS, curvature and roughness are rated. None if the boresight is an estimated one.
    visible_share : float or None, in [0, 1]
        Share of the extent in the other lines that this line shows; None if it cannot be compared.
    flatness : "good", "doubtful" or "poor"
        Rating by RMS, curvature and roughness alone.
    rating : "good", "doubtful" or "poor"
    reasons : tuple of Message
        Reasons for a rating other than good, the most severe first.
    """

    points: int
    rms: float
    range: float
    density: float | None
    incidence: float | None
    extent: Array | None
    coverage: float
    curvature: float | None
    curved: bool
    roughness: float | None
    rating: Rating
    reasons: tuple[Message, ...]
    smear: float | None = None
    visible_share: float | None = None
    flatness: Rating = "good"


def add_messages(quality: SightingQuality, messages: tuple[Message, ...]) -> SightingQuality:
    """Quality with additional messages; the rating is at best doubtful if there are any."""
    if not messages:
        return quality
    rating: Rating = "doubtful" if quality.rating == "good" else quality.rating
    return replace(quality, rating=rating, reasons=(*quality.reasons, *messages))


def undetermined_quality(points: int, rms: float, reason: Message) -> SightingQuality:
    """Quality of points that do not determine a plane or sphere; ``rms`` in metres."""
    return SightingQuality(
        points,
        rms,
        0.0,
        None,
        None,
        None,
        0.0,
        None,
        False,
        None,
        "poor",
        (reason,),
        flatness="poor",
    )


GradedReason = tuple[int, Message]
"""A reason with its severity: 1 doubtful, 2 poor."""


def plane_quality(
    points_lidar: Array,
    points_local: Array,
    indices: Indices,
    plane: Plane,
    noise: float,
    *,
    scanner_local: Array | None = None,
    turns_local: Array | None = None,
    boresight_sigma: float = PRIOR_BORESIGHT_SIGMA,
    threshold: float | None = None,
    observed_extent: ObservedExtent | None = None,
) -> SightingQuality:
    """Assess a plane in one line.

    Parameters
    ----------
    points_lidar, points_local : ndarray of shape (n, 3), metres
        Points of the line, in the LiDAR frame and in the local frame.
    indices : ndarray of shape (m,)
        Indices of the points of the sighting.
    plane : Plane, local frame
    noise : float, metres
        Standard deviation of a point perpendicular to the plane.
    scanner_local : ndarray of shape (3,) or (m, 3), metres, optional
        Position of the scanner when it measured the points of the sighting.
    turns_local : ndarray of shape (3, m, 3), metres per radian, optional
        Derivatives of the points of the sighting with respect to roll, pitch and yaw of the
        boresight. If given, deviations that a boresight error can explain are not rated; used as
        long as the boresight is not estimated.
    boresight_sigma : float, radians
        Sigma of each boresight angle.
    threshold : float, metres, optional
        Distance threshold of the search for the points.
    observed_extent : ObservedExtent, optional
        Comparison with the extent in other lines, if the plane ends within the search radius.
    """
    points = points_local[indices]
    ranges = np.linalg.norm(points_lidar[indices], axis=1)
    off = plane.distances(points)
    placed = (points - points.mean(axis=0)) @ plane_axes(plane.normal).T
    cell = _coverage_cell_size(placed)
    area = outline.filled_area(placed, cell)
    coverage = _outline_coverage(placed, cell)
    beams = None if scanner_local is None else points - scanner_local
    own = off
    if turns_local is not None:
        own = _without_smear(points, plane, beams, turns_local, noise, boresight_sigma)
    incidence = None if beams is None else _mean_incidence(beams, plane)
    sagitta, uncertainty, curved, uneven = _form_error(placed, own, cell)
    rms = rms_distance(plane, points)
    rms_own = float(np.sqrt(np.mean(own**2)))
    flat = _grade_roughness(rms, rms_own, noise, threshold)
    if curved:
        excess = (sagitta - TEST_LIMIT_SIGMAS * uncertainty) / noise
        flat += _grade_by_limits(excess, SAGITTA_LIMITS, note("quality.curved", sagitta=sagitta))
    flat += _grade_by_limits(uneven / noise, ROUGHNESS_LIMITS, note("quality.uneven", rms=uneven))
    found = _grade_view(len(points), incidence, coverage) + _grade_occlusion(observed_extent) + flat
    rating, reasons = _rating_of(found)
    return SightingQuality(
        len(points), rms, float(np.median(ranges)), len(points) / area, incidence,
        extent_in_plane(plane, points), coverage, sagitta, curved, uneven, rating, reasons,
        None if turns_local is None else float(np.sqrt(np.mean((off - own) ** 2))),
        None if observed_extent is None else observed_extent.share, _rating_of(flat)[0],
    )  # fmt: skip


def _without_smear(
    points: Array,
    plane: Plane,
    beams: Array | None,
    turns_local: Array,
    noise: float,
    boresight_sigma: float,
) -> Array:
    """Distances from a plane, metres, without the part that a boresight error can explain."""
    off = plane.distances(points)
    hits, turns = points, turns_local
    if beams is not None:
        hits, turns = beam_intersections(points, turns_local, off, beams, plane.normal)
    coordinates = (hits - points.mean(axis=0)) @ plane_axes(plane.normal).T
    moves = (turns @ plane.normal).T
    return remove_smear(coordinates, off, moves, noise, boresight_sigma)


def _mean_incidence(beams: Array, plane: Plane) -> float:
    """Mean angle between beams and the normal of a plane, radians, as in the adjustment."""
    cosines = np.abs(beams @ plane.normal) / np.linalg.norm(beams, axis=1)
    return float(np.mean(np.arccos(np.minimum(cosines, 1.0))))


def _grade_view(count: int, incidence: float | None, coverage: float) -> list[GradedReason]:
    """Grades of the number of points, the angle of incidence and the covered share."""
    found = _grade_point_count(count)
    if incidence is not None:
        degrees = float(np.degrees(incidence))
        found += _grade_by_limits(
            degrees, INCIDENCE_LIMITS_DEG, note("quality.oblique", angle=incidence)
        )
    found += _grade_by_limits(
        -coverage,
        (-COVERAGE_LIMITS[0], -COVERAGE_LIMITS[1]),
        note("quality.sparse", share=coverage),
    )
    return found


def sphere_quality(
    points_lidar: Array, points_local: Array, indices: Indices, sphere: Sphere, noise: float
) -> SightingQuality:
    """Assess a sphere in one line; see `plane_quality` for the parameters."""
    points = points_local[indices]
    share = visible_share(sphere, points)
    rms = rms_from_sphere(sphere, points)
    flat = _grade_roughness(rms, rms, noise, None)
    found = _grade_point_count(len(points)) + flat
    found += _grade_by_limits(
        -share,
        (-SPHERE_SHARE_LIMITS[0], -SPHERE_SHARE_LIMITS[1]),
        note("quality.sphere_part", share=share),
    )
    rating, reasons = _rating_of(found)
    ranges = np.linalg.norm(points_lidar[indices], axis=1)
    return SightingQuality(
        len(points), rms, float(np.median(ranges)), None, None, None, share, None, False, None,
        rating, reasons, flatness=_rating_of(flat)[0],
    )  # fmt: skip


def _grade_point_count(points: int) -> list[GradedReason]:
    return _grade_by_limits(
        -points,
        (-POINT_COUNT_LIMITS[0], -POINT_COUNT_LIMITS[1]),
        note("quality.few_points", count=points),
    )


def _grade_roughness(
    rms: float, own_noise: float, noise: float, threshold: float | None
) -> list[GradedReason]:
    """Grade the RMS without the effect of the boresight; messages give the RMS of the points."""
    ratio, without = rms / noise, own_noise / noise
    is_filled = threshold is not None and own_noise > MAX_RMS_TO_THRESHOLD * threshold
    if round(ratio, 1) == round(without, 1):
        code = "quality.rough_beyond_threshold" if is_filled else "quality.rough"
    else:
        code = "quality.rough_without_prior"
        if is_filled:
            code = "quality.rough_without_prior_beyond_threshold"
    params: dict[str, Value] = {"rms": rms, "ratio": ratio, "without": without}
    if threshold is not None:
        params["threshold"] = threshold
    limits = (NOISE_RATIO_LIMITS[0], NOISE_RATIO_LIMITS[0]) if is_filled else NOISE_RATIO_LIMITS
    return _grade_by_limits(without, limits, Message(code, Level.NOTE, params))


def _grade_occlusion(observed_extent: ObservedExtent | None) -> list[GradedReason]:
    if observed_extent is None:
        return []
    if observed_extent.is_far_larger:
        return [(1, observed_extent.message)]
    return _grade_by_limits(
        -observed_extent.share,
        (-VISIBLE_SHARE_LIMITS[0], -VISIBLE_SHARE_LIMITS[1]),
        observed_extent.message,
    )


def _grade_by_limits(
    value: float, limits: tuple[float, float], reason: Message
) -> list[GradedReason]:
    """Reason with its grade if a value is beyond the first limit; otherwise empty."""
    grade = int(value > limits[0]) + int(value > limits[1])
    return [(grade, reason)] if grade else []


def _rating_of(graded: list[GradedReason]) -> tuple[Rating, tuple[Message, ...]]:
    ratings: tuple[Rating, ...] = ("good", "doubtful", "poor")
    ranked = sorted(graded, key=lambda each: -each[0])
    return ratings[ranked[0][0] if ranked else 0], tuple(reason for _, reason in ranked)


def _coverage_cell_size(placed: Array) -> float:
    """Side of a cell, metres, for which a patch has no empty cells: 2.5 mean point spacings."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        spacing = np.sqrt(ConvexHull(placed).volume / len(placed))
    except QhullError:  # all in one row
        spacing = float(np.ptp(placed, axis=0).max()) / len(placed)
    return float(np.clip(2.5 * spacing, 0.02, 0.5))


def _outline_coverage(placed: Array, cell: float) -> float:
    """Share of the cells inside the convex outline that contain points."""
    from scipy.spatial import ConvexHull, QhullError

    low = placed.min(axis=0)
    cell_index = np.floor((placed - low) / cell).astype(np.int64)
    filled = np.zeros(cell_index.max(axis=0) + 1, dtype=bool)
    filled[cell_index[:, 0], cell_index[:, 1]] = True
    middles = low + (np.argwhere(np.ones_like(filled)) + 0.5) * cell
    try:
        sides = ConvexHull(placed).equations
    except QhullError:  # all in one row: it is its own outline
        return 1.0
    inside = (middles @ sides[:, :2].T <= -sides[:, 2]).all(axis=1)
    inside |= filled.ravel()
    return float(np.count_nonzero(filled) / np.count_nonzero(inside))


def _form_error(placed: Array, off: Array, cell: float) -> tuple[float, float, bool, float]:
    """Sagitta of a fitted quadric, its sigma, whether it is significant, and the roughness.

    The quadric is fitted to the means of cells, since the roughness at neighbouring points is
    correlated, while that of different cells is not.
    """
    from scipy.special import fdtrc

    cell_index = np.floor((placed - placed.min(axis=0)) / cell).astype(np.int64)
    _, key, count = np.unique(
        cell_index[:, 0] * (cell_index[:, 1].max() + 1) + cell_index[:, 1], False, True, True
    )
    key = key.reshape(-1)
    x, y, w = (np.bincount(key, values) / count for values in (*placed.T, off))
    if len(count) < 12:
        return 0.0, 0.0, False, 0.0
    root = np.sqrt(count)
    flat = np.stack([np.ones_like(x), x, y], axis=1)
    quadric = np.stack([*flat.T, x * x, x * y, y * y], axis=1)
    residuals = []
    for design in (flat, quadric):
        solved, inverse = _solve_least_squares(design, w, count.astype(float))
        residuals.append(root * (w - np.einsum("nk,k->n", design, solved)))
    _, _, _, xx, xy, yy = solved
    bends, directions = np.linalg.eigh(np.array([[2 * xx, xy], [xy, 2 * yy]]))
    lengths = np.ptp(placed @ directions, axis=0)
    sagittas = np.abs(bends) * lengths**2 / 8
    largest = int(np.argmax(sagittas))
    plain, smooth = (float(each @ each) for each in residuals)
    freedom = len(count) - 6
    ratio = (plain - smooth) / 3 / max(smooth / freedom, 1e-30)
    u, v = directions[:, largest]
    across = np.array([2 * u * u, 2 * u * v, 2 * v * v])
    spread = float(across @ inverse[3:, 3:] @ across) * smooth / freedom
    uncertainty = np.sqrt(max(spread, 0.0)) * lengths[largest] ** 2 / 8
    curved = bool(fdtrc(3, freedom, ratio) < TEST_LEVEL)
    # The scatter within cells is noise; the additional scatter of the means is due to the surface.
    within = float(np.sum((off - w[key]) ** 2)) / max(len(off) - len(count), 1)
    beyond = smooth / freedom - within
    uneven = float(np.sqrt(max(beyond, 0.0) / np.mean(count)))
    return float(sagittas[largest]), float(uncertainty), curved, uneven


def _solve_least_squares(design: Array, values: Array, weights: Array) -> tuple[Array, Array]:
    """Weighted least squares with few unknowns: solution (k,) and inverse normal matrix (k, k).

    The threads of the matrix library are not used: on a busy machine they wait for each other much
    longer than this small computation takes.
    """
    scale = np.maximum(np.abs(design).max(axis=0), 1e-12)
    scaled = design / scale
    normal = np.einsum("n,ni,nj->ij", weights, scaled, scaled)
    right = np.einsum("n,ni,n->i", weights, scaled, values)
    # Cells in one row do not determine all unknowns; the minimum-norm solution is used.
    inverse = np.linalg.pinv(normal, rcond=1e-12, hermitian=True)
    return inverse @ right / scale, inverse / np.outer(scale, scale)
