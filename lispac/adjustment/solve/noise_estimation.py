"""Estimate the noise of the points of each target from their residuals.

The residuals on a rough surface are larger than the LiDAR noise. They are also correlated between
neighbouring points, since the irregularities of the surface are larger than the point spacing, so
that many points contain no more information than a few. The correlation is estimated from sums of
residuals over blocks of the surface. The variance of such a sum is larger than for independent
points by a factor, the design effect (Kish 1965).
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.robust_loss import robust_scale
from lispac.adjustment.model.target_shapes import points_local
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.group_sums import AdjustmentState
from lispac.geometry.planes import fit_plane, plane_axes
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

BLOCKS_PER_SIDE = 4
"""Number of blocks along each side of a sighting.

A compromise between the number of blocks and the number of points in each.
"""

MAX_SELECTED_ROWS = 500_000
"""Largest number of points that are copied at a time, 0.1 GB."""

MAX_SCALED_RESIDUAL = 3.0
"""Largest scaled residual that affects the noise; larger ones are clipped, or their sighting is
not used."""

NORMAL_MEDIAN = 0.6745
"""Median absolute value of a standard normal variable."""
TRUNCATED_NORMAL_VARIANCE = 0.9733
"""Variance of a standard normal variable within `MAX_SCALED_RESIDUAL`."""

CRITICAL_COVARIANCE_SIGMAS = 2.0
"""Critical value of the covariance between lines, in standard deviations."""

MIN_DISPLACEMENT_RATIO = 3.0
"""Smallest offset of a displaced sighting, in units of the robust scale of the target's residuals.

Only another surface or a gross error of the position displaces a single sighting by so much. A
prior boresight that is wrong by degrees displaces all sightings, and increases the scale.
"""

MAX_NOISE_SPREAD = 1.5
"""Largest ratio of the noise of two targets that is attributed to the LiDAR, not to a surface."""

SIGMA_TOLERANCE = 0.01
"""Relative change of an estimated sigma below which it has converged."""


def reestimate_noise(
    problem: AdjustmentProblem, state: AdjustmentState, *, may_decrease: bool = True
) -> AdjustmentProblem:
    """Return the problem with the noise estimated again from its residuals.

    If ``may_decrease`` is false, the noise of a target cannot decrease, which prevents an endless
    alternation of noise and solution.
    """
    updated = _noise_from_residuals(problem, state)
    if may_decrease:
        return updated
    return replace(
        updated,
        noise=np.maximum(updated.noise, problem.noise),
        scale=np.maximum(updated.scale, problem.scale),
    )


def _noise_from_residuals(problem: AdjustmentProblem, state: AdjustmentState) -> AdjustmentProblem:
    observations, residuals = problem.observations, problem.residuals(state)[1]
    near = None
    if problem.model.loss != "none":
        near = is_point_on_target(observations, residuals)
        problem = replace(problem, scale=target_noise_scales(observations, residuals, near))
    if problem.known_noise or not problem.model.correlated:
        return problem
    noise = target_noise_factors(observations, residuals, problem.blocks, near)
    return replace(problem, noise=noise)


def lidar_noise_ratio(linearised: LinearisedProblem) -> float | None:
    """Ratio of the LiDAR noise in the residuals to the given one.

    The variance of a point is the sum of the LiDAR variance and the variance of the POS error
    between two knots. With a LiDAR share ``s`` of the variance on average, a mean square ``f`` of
    the standardised residuals corresponds to a ratio whose square is ``(f - 1 + s) / s``. The
    variance factor is not used, because it also contains the POS errors at the knots.

    Returns
    -------
    float or None
        None if POS errors are independent, so that the shares are not separate; or if the residuals
        are larger than predicted on some of the targets only, whose surfaces are then rough.
    """
    problem, state = linearised.problem, linearised.state
    if not problem.model.correlated:
        return None
    if problem.noise.max() > MAX_NOISE_SPREAD * problem.noise.min():
        return None
    usual, doubled = (
        np.abs(each.residuals(state)[1]) for each in (problem, problem.with_scaled_sigmas(2, 1, 1))
    )
    scale = np.median(usual) / NORMAL_MEDIAN
    near = (usual <= MAX_SCALED_RESIDUAL * scale) & (doubled > 0)
    share = float(np.mean(((usual[near] / doubled[near]) ** 2 - 1) / 3))
    square = (float(np.mean(usual[near] ** 2)) / TRUNCATED_NORMAL_VARIANCE - 1 + share) / share
    return float(np.sqrt(square)) if square > 0 else None


def have_sigmas_changed(one: AdjustmentProblem, other: AdjustmentProblem) -> bool:
    """Whether a sigma estimated from the data has changed enough to justify an iteration."""
    pairs = ((one.noise, other.noise), (one.scale, other.scale),
             (one.surface_sigma, other.surface_sigma))  # fmt: skip
    return any(bool((np.abs(a - b) > SIGMA_TOLERANCE * b).any()) for a, b in pairs)


def with_noise_blocks(problem: AdjustmentProblem) -> AdjustmentProblem:
    """Problem with the blocks of the surfaces from which correlated noise is estimated."""
    if len(problem.blocks) or problem.known_noise or not problem.model.correlated:
        return problem
    return replace(problem, blocks=assign_surface_blocks(problem.observations, problem.prior))


def assign_surface_blocks(observations: Observations, mounting: Mounting) -> NDArray[np.int64]:
    """Block number of each point, shape (n,), with sixteen blocks per sighting.

    The points are georeferenced with ``mounting``.
    """
    points = points_local(observations, mounting)
    block = np.empty(len(points), dtype=np.int64)
    for s in range(len(observations.sightings)):
        own = np.flatnonzero(observations.sighting == s)
        centred = points[own] - points[own].mean(axis=0)
        variances, directions = np.linalg.eigh(np.cov(centred.T))
        # Half-width of a uniform distribution: sqrt(3) times its standard deviation.
        reach = np.sqrt(3 * np.maximum(variances[1:], np.finfo(float).tiny))
        place = (centred @ directions[:, 1:] / reach + 1) / 2 * BLOCKS_PER_SIDE
        row, column = np.clip(np.floor(place), 0, BLOCKS_PER_SIDE - 1).astype(np.int64).T
        block[own] = BLOCKS_PER_SIDE**2 * s + BLOCKS_PER_SIDE * row + column
    return block


def target_noise_scales(
    observations: Observations, residuals: Array, near: NDArray[np.bool_]
) -> Array:
    """Robust scale of each target's standardised residuals, at least 1, shape (targets,).

    Parameters
    ----------
    near : ndarray of shape (n,), bool
        From `is_point_on_target`.
    """
    target = observations.target_of_sighting[observations.sighting]
    each = range(len(observations.targets))
    return np.array([robust_scale(residuals[near & (target == k)]) for k in each])


def target_noise_factors(
    observations: Observations,
    residuals: Array,
    blocks: NDArray[np.int64],
    near: NDArray[np.bool_] | None,
    *,
    denser: float = 1.0,
) -> Array:
    """Ratio of the noise of each target to the given one, at least 1, shape (targets,).

    Parameters
    ----------
    residuals : ndarray of shape (n,)
        Residuals divided by the standard deviations of their conditions.
    blocks : ndarray of shape (n,), int
        From `assign_surface_blocks`.
    near : ndarray of shape (n,), bool, or None
        From `is_point_on_target` if a robust loss is used, None otherwise.
    denser : float
        Ratio of the number of points of the adjustment to that of the given points; the design
        effect increases with it.
    """
    target = observations.target_of_sighting[observations.sighting]
    factors = np.empty(len(observations.targets))
    for k in range(len(factors)):
        mine = target == k if near is None else near & (target == k)
        own = residuals[mine]
        size = max(1.0, float(np.sqrt(np.mean(own**2)))) if near is None else robust_scale(own)
        clipped = (
            own / size
            if near is None
            else np.clip(own / size, -MAX_SCALED_RESIDUAL, MAX_SCALED_RESIDUAL)
        )
        effect = 1 + denser * (_design_effect(clipped, blocks[mine]) - 1)
        factors[k] = size * np.sqrt(effect)
    return factors


def form_error_noise(
    observations: Observations, mounting: Mounting, residuals: Array, targets: NDArray[np.bool_]
) -> Array:
    """Ratio of the noise explained by form errors of planes to the given one, at least 1.

    A form error is the same in every line. POS errors that remain in the residuals may look
    similar, but differ from line to line. The variance of the form error is therefore the
    covariance between lines of the mean residuals in blocks of the surface. A plane is first
    removed from the residuals of each line.

    Parameters
    ----------
    mounting : Mounting
        Estimated mounting.
    residuals : ndarray of shape (n,)
        As in `target_noise_factors`.
    targets : ndarray of shape (targets,), bool
        Whether each target is examined; only planes.

    Returns
    -------
    ndarray of shape (targets,)
        Noise factors as from `target_noise_factors`; NaN for targets that are not examined.
    """
    factors = np.full(len(observations.targets), np.nan)
    if not targets.any():
        return factors
    for k in np.flatnonzero(targets):
        sightings = np.flatnonzero(observations.target_of_sighting == k)
        rows = np.concatenate([np.flatnonzero(observations.sighting == s) for s in sightings])
        place = _places_on_plane(observations, mounting, rows)
        own = residuals[rows]
        size = robust_scale(own)
        np.clip(own, -MAX_SCALED_RESIDUAL * size, MAX_SCALED_RESIDUAL * size, out=own)
        lengths = observations.counts[sightings]
        ends = np.cumsum(lengths)
        for part in map(slice, [0, *ends[:-1]], ends):
            own[part] = _remove_plane_trend(place[part], own[part])
        size = robust_scale(own)
        shape = len(sightings), BLOCKS_PER_SIDE**2
        index = _plane_blocks(place)
        index += np.repeat(np.arange(shape[0]) * shape[1], lengths)
        counts = np.bincount(index, minlength=shape[0] * shape[1]).reshape(shape)
        sums = np.bincount(index, own, shape[0] * shape[1]).astype(float).reshape(shape)
        factors[k] = _form_noise_factor(counts, sums, size)
    return factors


def _places_on_plane(
    observations: Observations, mounting: Mounting, rows: NDArray[np.int64]
) -> Array:
    """Coordinates of points within the plane fitted to them, shape (len(rows), 2), metres.

    The rows are evaluated in parts, because a selection copies all columns of the observations.
    """
    points = np.empty((len(rows), 3))
    for start in range(0, len(rows), MAX_SELECTED_ROWS):
        part = slice(start, start + MAX_SELECTED_ROWS)
        points[part] = points_local(observations.reordered(rows[part]), mounting)
    return points @ plane_axes(fit_plane(points).normal).T


def _remove_plane_trend(place: Array, residuals: Array) -> Array:
    """Residuals (n,) minus their best-fitting plane; ``place`` of shape (n, 2), metres."""
    design = np.column_stack([np.ones(len(place)), place - place.mean(axis=0)])
    return np.asarray(residuals - design @ np.linalg.lstsq(design, residuals, rcond=None)[0])


def _plane_blocks(place: Array) -> NDArray[np.int64]:
    """Block number of each point of one plane, shape (n,); the blocks are the same in all lines."""
    block = _blocks_along_side(place[:, 0])
    block *= BLOCKS_PER_SIDE
    block += _blocks_along_side(place[:, 1])
    return block


def _blocks_along_side(place: Array) -> NDArray[np.int64]:
    """Block of each point along one side; computed in place, since there may be millions."""
    lowest, highest = np.percentile(place, [1, 99])
    block = BLOCKS_PER_SIDE * (place - lowest)
    block /= highest - lowest
    np.clip(block, 0, BLOCKS_PER_SIDE - 1, out=block)
    return block.astype(np.int64)


def _form_noise_factor(counts: NDArray[np.int64], sums: Array, size: float) -> float:
    """Noise factor from the covariance between lines of the block means.

    Parameters
    ----------
    counts : ndarray of shape (lines, blocks), int
        Number of points in each block.
    sums : ndarray of shape (lines, blocks)
        Sum of the standardised residuals in each block.
    size : float
        Robust scale of the standardised residuals.
    """
    first, second = np.triu_indices(len(counts), 1)
    products = sums[first] * sums[second]
    pairs = float((counts[first] * counts[second]).sum())
    if not pairs or products.sum() <= CRITICAL_COVARIANCE_SIGMAS * np.sqrt((products**2).sum()):
        return size
    points_of_block = float((counts**2).sum() / counts.sum())
    return float(np.sqrt(size**2 + points_of_block * products.sum() / pairs))


def find_displaced_sightings(observations: Observations, residuals: Array) -> NDArray[np.int64]:
    """Find sightings that are displaced from their target much more than most others.

    Parameters
    ----------
    residuals : ndarray of shape (n,)
        As in `target_noise_factors`.

    Returns
    -------
    ndarray of shape (k,), int
    """
    found = []
    for k in range(len(observations.targets)):
        off = _relative_sighting_offsets(observations, residuals, k)
        found += [s for s, size in off.items() if size > MIN_DISPLACEMENT_RATIO]
    return np.array(found, dtype=np.int64)


def is_point_on_target(observations: Observations, residuals: Array) -> NDArray[np.bool_]:
    """Whether each point belongs to a sighting that is not displaced as a whole, shape (n,).

    Displaced sightings, on another surface or metres away, must not affect the estimated noise.

    Parameters
    ----------
    residuals : ndarray of shape (n,)
        As in `target_noise_factors`.
    """
    near = np.zeros(len(observations.sightings), dtype=bool)
    for k in range(len(observations.targets)):
        off = _relative_sighting_offsets(observations, residuals, k)
        near[[s for s, size in off.items() if size <= MAX_SCALED_RESIDUAL]] = True
    return near[observations.sighting]


def _relative_sighting_offsets(
    observations: Observations, residuals: Array, target: int
) -> dict[int, float]:
    """Median absolute residual of each sighting, divided by the robust scale of the target."""
    own = [
        (int(s), np.abs(residuals[observations.sighting == s]))
        for s in np.flatnonzero(observations.target_of_sighting == target)
    ]
    size = robust_scale(np.concatenate([sizes for _, sizes in own]))
    return {s: float(np.median(sizes)) / size for s, sizes in own}


def _design_effect(residuals: Array, blocks: NDArray[np.int64]) -> float:
    """Ratio of the variance of sums over blocks to that for independent residuals.

    The result is 1 if the ratio is not significantly larger than 1.
    """
    counts = np.bincount(blocks)
    sums = np.bincount(blocks, residuals)[counts > 0]
    square = float(np.mean(residuals**2))
    if square == 0:
        return 1.0
    effect = float(np.mean(sums**2 / counts[counts > 0])) / square
    return effect if effect > 1 + 2 * np.sqrt(2 / len(sums)) else 1.0
