"""Weighted sums over groups of points, from which the normal equations are assembled.

The products of the normal equations (thesis equation B.8) are summed in one pass over the points. A
group is a sighting or, if the POS error has knots, the part of a sighting between two knots. The
cost of all further steps does not depend on the number of points.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.condition_equations import (
    MountingArrays,
    PointArrays,
    adjusted_observation,
    condition_row,
    lidar_point,
    lidar_variance,
    point_pose,
)
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.robust_loss import Loss, influence_slope, loss_weight
from lispac.adjustment.model.stochastic_model import PosErrorKnots
from lispac.adjustment.model.threads import run_in_chunks
from lispac.compiled_code import kernel
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PointGroups:
    """Groups of points whose products are summed together; their points are contiguous.

    Attributes
    ----------
    start : ndarray of shape (groups + 1,), int
        Index of the first point of each group, and last the number of points.
    sighting, knot : ndarray of shape (groups,), int
        Sighting of each group, and the knot of the POS error before it.
    knots : PosErrorKnots or None
        None with independent POS errors, which are part of the variance of each point.
    """

    start: NDArray[np.int64]
    sighting: NDArray[np.int64]
    knot: NDArray[np.int64]
    knots: PosErrorKnots | None

    @property
    def pos_error_columns(self) -> int:
        """Number of columns of the POS error in the sums."""
        return 0 if self.knots is None else 12


def group_points(
    observations: Observations, knots: PosErrorKnots | None
) -> tuple[Observations, PointGroups]:
    """Sort the points by group; sightings whose points are in order of time are not copied."""
    count = 1 if knots is None else len(knots.time)
    key = observations.sighting * count
    if knots is not None:
        key += knots.left
    if (key[1:] < key[:-1]).any():
        # NumPy uses a radix sort for short integers, which is four times faster
        order = np.argsort(key.astype(np.min_scalar_type(key.max())), kind="stable")
        observations, key = observations.reordered(order), key[order]
        knots = None if knots is None else knots.reordered(order)
    start = np.flatnonzero(key[1:] != key[:-1]) + 1
    start = np.concatenate([[0], start, [len(key)]]).astype(np.int64)
    found = key[start[:-1]]
    return observations, PointGroups(start, found // count, found % count, knots)


@dataclass(frozen=True, eq=False)
class AdjustmentState:
    """State at which the conditions are linearised.

    Attributes
    ----------
    mounting : Mounting
    shapes : ndarray of shape (targets, 4), local frame
    surface : ndarray of shape (sightings, 4)
        Deviation of each sighting from the shape of its target, in the same parameters.
    pos_corrections : ndarray of shape (knots, 6), metres and radians
        Corrections at the knots that are added to the reported poses: minus the POS errors.

    The current deviations and corrections are included in the misclosures. Misclosures are
    therefore small at the solution, and so are the rounding errors of their sums.
    """

    mounting: Mounting
    shapes: Array
    surface: Array
    pos_corrections: Array


@dataclass(frozen=True, eq=False)
class PointWeights:
    """Settings of the point weights besides the given sigmas.

    Attributes
    ----------
    loss : Loss
    scale : ndarray of shape (targets,)
        Divisor of the standardised residuals in the loss function.
    noise : ndarray of shape (targets,)
        Factor on the standard deviations of the conditions.
    tangent : bool
        Use the derivative of the weighted residual for the products (Gauss-Newton step with updated
        weights, which converges fast) instead of the weight (IRLS step, from which the sigmas are
        computed).
    """

    loss: Loss
    scale: Array
    noise: Array
    tangent: bool = False


def sum_by_group(
    observations: Observations,
    groups: PointGroups,
    state: AdjustmentState,
    active: NDArray[np.int64],
    weights: PointWeights,
) -> Array:
    """Weighted sums of ``row row'`` over each group.

    Parameters
    ----------
    observations : Observations
        Observations sorted by `group_points`.
    active : ndarray of shape (a,), int
        Indices of the estimated values of the mounting.

    Returns
    -------
    ndarray of shape (groups, width, width)
        The columns are the derivatives by the active values (a) and by the shape (4), with knots
        also those by the POS error at the knot before (6) and after (6), and last the misclosure.
    """
    width = len(active) + 5 + groups.pos_error_columns
    sums = np.zeros((len(groups.sighting), width, width))
    points = PointArrays.of(observations, state.mounting)
    placing = MountingArrays.of(state.mounting, state.shapes)
    effects, weighting = EffectArrays.of(groups, state), WeightArrays.of(weights)
    run_in_chunks(
        lambda first, last: _accumulate_sums(
            first, last, points, placing, effects, weighting, active, sums
        ),
        groups.start[1:],
    )
    return np.asarray(np.tril(sums) + np.swapaxes(np.tril(sums, -1), -1, -2))


class EffectArrays(NamedTuple):
    """Effects on the misclosures of the points, as arguments of the compiled kernels.

    An effect is an estimated error that displaces the points of a group apart from the mounting:
    the form error of the surface (``surface``), or the POS error interpolated between the knots
    (``pos``). The other arrays assign points to groups and groups to knots, and interpolate.
    """

    start: NDArray[np.int64]
    knot: NDArray[np.int64]
    fraction: Array  # empty with independent POS errors
    bridge_variance: Array
    bridge_factor: Array
    surface: Array
    pos: Array

    @classmethod
    def of(cls, groups: PointGroups, state: AdjustmentState) -> "EffectArrays":
        """Take the arrays from ``groups`` and ``state``."""
        knots = groups.knots
        none = (np.zeros(0),) * 3
        between = (
            none if knots is None else (knots.fraction, knots.bridge_variance, knots.bridge_factor)
        )
        return cls(groups.start, groups.knot, *between, state.surface, state.pos_corrections)


class WeightArrays(NamedTuple):
    """`PointWeights` as arguments of the compiled kernels."""

    loss: int
    tuning: float
    tangent: bool
    scale: Array
    noise: Array

    @classmethod
    def of(cls, weights: PointWeights) -> "WeightArrays":
        """Take the arrays from ``weights``."""
        loss = weights.loss
        return cls(loss.code, loss.tuning, weights.tangent, weights.scale, weights.noise)


@kernel(inline="always")
def linearisation_pose(i, g, points, effects):  # type: ignore[no-untyped-def]
    """Pose of point ``i`` of group ``g`` at which its condition is linearised; see `point_pose`.

    On a sphere, it contains the POS corrections: an error of the position that is not small
    compared with the radius changes the normal (Pope 1972). On a plane it does not, since the
    condition is linear in the position.
    """
    pose = point_pose(i, points)
    sphere = points.spheres[points.target_of_sighting[points.sighting[i]]]
    knot, fraction, pos = effects.knot, effects.fraction, effects.pos
    if len(fraction) == 0 or not sphere:
        return pose
    px, py, pz, cr, sr, cp, sp, ch, sh = pose
    u, k = fraction[i], knot[g]
    roll = (1 - u) * pos[k, 3] + u * pos[k + 1, 3]
    pitch = (1 - u) * pos[k, 4] + u * pos[k + 1, 4]
    heading = (1 - u) * pos[k, 5] + u * pos[k + 1, 5]
    c0, s0, c1, s1 = np.cos(roll), np.sin(roll), np.cos(pitch), np.sin(pitch)
    c2, s2 = np.cos(heading), np.sin(heading)
    return (
        px + (1 - u) * pos[k, 0] + u * pos[k + 1, 0],
        py + (1 - u) * pos[k, 1] + u * pos[k + 1, 1],
        pz + (1 - u) * pos[k, 2] + u * pos[k + 1, 2],
        cr * c0 - sr * s0, sr * c0 + cr * s0,
        cp * c1 - sp * s1, sp * c1 + cp * s1,
        ch * c2 - sh * s2, sh * c2 + ch * s2,
    )  # fmt: skip


@kernel(inline="always")
def point_misclosure(  # type: ignore[no-untyped-def]
    i, g, pose, points, placing, effects, out, lidar
):
    """Misclosure of point ``i`` of group ``g`` including form and POS errors, and its variance.

    ``pose`` is that of `linearisation_pose`; ``out`` and ``lidar`` are written as in
    `condition_row`.
    """
    sphere = points.spheres[points.target_of_sighting[points.sighting[i]]]
    condition_row(i, lidar_point(i, points), pose, points, placing, out, lidar)
    xyz, sigma_lidar, beam = points.xyz, points.sigma_lidar, points.beam_sigmas
    sigma_position, sigma_attitude = points.sigma_position, points.sigma_attitude
    s, surface, knot, fraction = points.sighting[i], effects.surface, effects.knot, effects.fraction
    bridge_variance, bridge_factor, pos = (
        effects.bridge_variance,
        effects.bridge_factor,
        effects.pos,
    )
    variance = lidar_variance(i, xyz, sigma_lidar, beam, lidar)
    misclosure = out[19]
    for k in range(4):
        misclosure += out[9 + k] * surface[s, k]
    if len(fraction) > 0:
        u, before = fraction[i], knot[g]
        if not sphere:  # the pose on a sphere contains the corrections
            for k in range(6):
                misclosure += out[13 + k] * ((1 - u) * pos[before, k] + u * pos[before + 1, k])
        # Variance of the POS error about the linear interpolation between two knots
        for k in range(3):
            between = bridge_factor[k] * bridge_variance[i]
            variance += between * (out[13 + k] * sigma_position[i, k]) ** 2
            between = bridge_factor[3 + k] * bridge_variance[i]
            variance += between * (out[16 + k] * sigma_attitude[i, k]) ** 2
    else:
        for k in range(3):
            variance += (out[13 + k] * sigma_position[i, k]) ** 2
            variance += (out[16 + k] * sigma_attitude[i, k]) ** 2
    return misclosure, variance


@kernel(inline="always")
def write_group_row(i, active, fraction, out, rows, place):  # type: ignore[no-untyped-def]
    """Write the derivatives of point ``i`` to ``rows[place]``, in the columns of the sums."""
    count = len(active)
    for k in range(count):
        rows[place, k] = out[active[k]]
    for k in range(4):
        rows[place, count + k] = out[9 + k]
    if len(fraction) > 0:
        u = fraction[i]
        for k in range(6):
            rows[place, count + 4 + k] = (1 - u) * out[13 + k]
            rows[place, count + 10 + k] = u * out[13 + k]


POINTS_PER_BLOCK = 64
"""Number of points whose products are summed in one BLAS call, which halves the time."""


@kernel()
def _accumulate_sums(  # type: ignore[no-untyped-def]
    first, last, points, placing, effects, weights, active, sums
):
    start, fraction = effects.start, effects.fraction
    sighting, target_of_sighting = points.sighting, points.target_of_sighting
    xyz, sigma_lidar, beam = points.xyz, points.sigma_lidar, points.beam_sigmas
    loss, tuning, tangent, scale, noise = weights
    out, lidar = np.empty(20), np.empty(3)
    width = sums.shape[1]
    rows, weighted = np.empty((POINTS_PER_BLOCK, width)), np.empty((POINTS_PER_BLOCK, width))
    product = np.empty((width, width))
    for g in range(first, last):
        for begin in range(start[g], start[g + 1], POINTS_PER_BLOCK):
            count = min(POINTS_PER_BLOCK, start[g + 1] - begin)
            for place in range(count):
                i = begin + place
                t = target_of_sighting[sighting[i]]
                pose = linearisation_pose(i, g, points, effects)
                misclosure, variance = point_misclosure(
                    i, g, pose, points, placing, effects, out, lidar
                )
                if len(fraction) > 0:
                    # At the observed point, the noise of the derivatives and of the misclosure is
                    # correlated, which biases weakly determined unknowns. The derivatives are
                    # therefore computed at the adjusted point (Pope 1972).
                    adjusted_xyz = adjusted_observation(
                        i, xyz, sigma_lidar, beam, lidar, misclosure / variance
                    )
                    condition_row(i, adjusted_xyz, pose, points, placing, out, lidar)
                write_group_row(i, active, fraction, out, rows, place)
                rows[place, width - 1] = misclosure
                precision = 1 / (variance * noise[t] ** 2)
                pull = precision * misclosure
                if loss > 0:
                    off = misclosure / np.sqrt(variance) / scale[t]
                    loss_factor = loss_weight(loss, tuning, off)
                    pull *= loss_factor
                    precision *= influence_slope(loss, tuning, off) if tangent else loss_factor
                for k in range(width - 1):
                    weighted[place, k] = precision * rows[place, k]
                weighted[place, width - 1] = pull
            np.dot(weighted[:count].T, rows[:count], product)
            for j in range(width):
                for k in range(j + 1):
                    sums[g, j, k] += product[j, k]


def compute_residuals(
    observations: Observations, groups: PointGroups, state: AdjustmentState
) -> Array:
    """Compute distances and standardised residuals of the points.

    Returns
    -------
    ndarray of shape (2, n)
        Signed distance from the shape, metres. Misclosure including form and POS errors, divided by
        its standard deviation; `sum_by_group` computes the weights from it.
    """
    found = np.empty((2, len(observations)))
    points, effects = PointArrays.of(observations, state.mounting), EffectArrays.of(groups, state)
    placing = MountingArrays.of(state.mounting, state.shapes)
    run_in_chunks(
        lambda first, last: _residuals_kernel(first, last, points, placing, effects, found),
        groups.start[1:],
    )
    return found


@kernel()
def _residuals_kernel(  # type: ignore[no-untyped-def]
    first, last, points, placing, effects, found
):
    start = effects.start
    sighting, target_of_sighting = points.sighting, points.target_of_sighting
    spheres = points.spheres
    out, lidar = np.empty(20), np.empty(3)
    for g in range(first, last):
        for i in range(start[g], start[g + 1]):
            pose = linearisation_pose(i, g, points, effects)
            misclosure, variance = point_misclosure(
                i, g, pose, points, placing, effects, out, lidar
            )
            if spheres[target_of_sighting[sighting[i]]]:
                condition_row(
                    i, lidar_point(i, points), point_pose(i, points), points, placing, out, lidar
                )
            found[0, i] = out[19]
            found[1, i] = misclosure / np.sqrt(variance)
