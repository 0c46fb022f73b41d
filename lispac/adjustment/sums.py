"""Weighted sums over groups of points: all that an adjustment needs of them.

The products that make up the normal equations are summed in one pass, per sighting and, where the
POS error has knots, per stretch between two of them. What follows costs the same for a thousand
points as for ten million.
"""

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from lispac.adjustment.conditions import columns, corrected, lidar_variance, row, turns
from lispac.adjustment.observations import Observations
from lispac.adjustment.robust import Loss, weight
from lispac.adjustment.stochastic import PosErrorKnots
from lispac.adjustment.threads import in_chunks
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Groups:
    """Points whose products are summed together; they lie one behind the other.

    Attributes
    ----------
    start : ndarray of shape (groups + 1,), int
        First point of each group, and the number of points.
    sighting, knot : ndarray of shape (groups,), int
        Sighting, and the knot of the POS error at the beginning of the stretch.
    knots : PosErrorKnots or None
        None in thesis mode, where the POS error is in each point's variance instead.
    """

    start: NDArray[np.int64]
    sighting: NDArray[np.int64]
    knot: NDArray[np.int64]
    knots: PosErrorKnots | None

    @property
    def shared(self) -> int:
        """Columns of the POS error in the sums."""
        return 0 if self.knots is None else 12


def grouped(
    observations: Observations, knots: PosErrorKnots | None
) -> tuple[Observations, Groups, NDArray[np.int64]]:
    """Sort the points by group.

    Returns
    -------
    observations, groups : Observations, Groups
    order : ndarray of shape (n,), int
        The points of the sorted observations in the given ones.
    """
    left = np.zeros(len(observations), dtype=np.int64) if knots is None else knots.left
    count = len(observations.sightings)
    key = left * count + observations.sighting
    order = np.argsort(key, kind="stable")
    found, start = np.unique(key[order], return_index=True)
    groups = Groups(
        np.append(start, len(key)).astype(np.int64),
        found % count,
        found // count,
        None if knots is None else knots.reordered(order),
    )
    if (np.diff(order) == 1).all():
        return observations, groups, order
    return observations.reordered(order), groups, order


@dataclass(frozen=True, eq=False)
class State:
    """Where the conditions are linearised.

    Attributes
    ----------
    mounting : Mounting
    shapes : ndarray of shape (targets, 4), local frame
    surface : ndarray of shape (sightings, 4)
        How each sighting's surface departs from its target's shape, in the same parameters.
    effects : ndarray of shape (knots, 6), metres and radians
        POS error at the knots.

    The effects found so far are added to the misclosures, so that these, and with them the
    rounding of their sums, are small at the solution.
    """

    mounting: Mounting
    shapes: Array
    surface: Array
    effects: Array


@dataclass(frozen=True, eq=False)
class Weights:
    """What makes a point's weight besides its stated sigmas.

    Attributes
    ----------
    loss : Loss
    scale : ndarray of shape (targets,)
        Standardised residuals are divided by it before the loss sees them.
    noise : ndarray of shape (targets,)
        Factor on the standard deviations of the conditions.
    """

    loss: Loss
    scale: Array
    noise: Array


def sum_by_group(
    observations: Observations,
    groups: Groups,
    state: State,
    active: NDArray[np.int64],
    weights: Weights,
) -> Array:
    """Weighted sums of ``row row'`` over each group.

    Parameters
    ----------
    observations : Observations
        Sorted by `grouped`.
    active : ndarray of shape (a,), int
        Which values of the mounting are estimated.

    Returns
    -------
    ndarray of shape (groups, width, width)
        Rows are the derivatives by the active values (a) and the shape (4), with knots those by
        the POS error at the knot before (6) and after (6), and last the misclosure.
    """
    width = len(active) + 5 + groups.shared
    sums = np.zeros((len(groups.sighting), width, width))
    arguments = (
        *columns(observations),
        observations.sighting,
        *turns(observations, state.mounting),
        state.shapes,
        state.surface,
        active,
        groups.start,
        groups.knot,
        *pos_between_knots(groups),
        state.effects,
        observations.sigma_lidar,
        observations.beam_sigmas,
        observations.sigma_position,
        observations.sigma_attitude,
        weights.loss.code,
        weights.loss.tuning,
        weights.scale,
        weights.noise**-2,
    )
    in_chunks(lambda first, last: _accumulate(first, last, *arguments, sums), groups.start[1:])
    return sums + np.swapaxes(np.tril(sums, -1), -1, -2)


def pos_between_knots(groups: Groups) -> tuple[Array, Array]:
    """Fractions of the points and variances of the bridge, as the kernels take them."""
    if groups.knots is None:
        return np.zeros(0), np.zeros(0)
    return groups.knots.fraction, groups.knots.bridge


@njit(nogil=True, cache=True, inline="always")
def residual(  # type: ignore[no-untyped-def]
    i, knot, points, shift, fraction, stray, effects, sigma_lidar, beam, sigma_position,
    sigma_attitude, out, lidar,
):  # fmt: skip
    """Misclosure with the effects applied, and the variance of its noise."""
    variance = lidar_variance(i, points, sigma_lidar, beam, lidar)
    misclosure = out[19]
    for k in range(4):
        misclosure += out[9 + k] * shift[k]
    if len(fraction) > 0:
        u = fraction[i]
        for k in range(6):
            misclosure += out[13 + k] * ((1 - u) * effects[knot, k] + u * effects[knot + 1, k])
        # What the POS error does between two knots that a straight line does not
        for k in range(3):
            between = stray[k] * u * (1 - u)
            variance += between * (out[13 + k] * sigma_position[i, k]) ** 2
            between = stray[3 + k] * u * (1 - u)
            variance += between * (out[16 + k] * sigma_attitude[i, k]) ** 2
    else:
        for k in range(3):
            variance += (out[13 + k] * sigma_position[i, k]) ** 2
            variance += (out[16 + k] * sigma_attitude[i, k]) ** 2
    return misclosure, variance


@njit(nogil=True, cache=True)
def _accumulate(  # type: ignore[no-untyped-def]
    first, last,
    points, position, attitude, rate, target, spheres, sighting,
    values, rotation, derivatives, turn, shapes, surface,
    active, start, knot, fraction, stray, effects,
    sigma_lidar, beam, sigma_position, sigma_attitude,
    loss, tuning, scale, trust, sums,
):  # fmt: skip
    out, lidar = np.empty(20), np.empty(3)
    width = sums.shape[1]
    wide = np.empty(width)
    count = len(active)
    pose = count + 4
    for g in range(first, last):
        total = sums[g]
        for i in range(start[g], start[g + 1]):
            t = target[i]
            row(
                i, points[i, 0], points[i, 1], points[i, 2], position, attitude, rate, values,
                rotation, derivatives, turn, spheres[t], shapes[t], out, lidar,
            )  # fmt: skip
            misclosure, variance = residual(
                i, knot[g], points, surface[sighting[i]], fraction, stray, effects, sigma_lidar,
                beam, sigma_position, sigma_attitude, out, lidar,
            )  # fmt: skip
            if len(fraction) > 0:
                # At the observed point the derivatives share its noise with the misclosure, which
                # biases what is seen weakly; at the adjusted one they do not (Pope 1972).
                x, y, z = corrected(i, points, sigma_lidar, beam, lidar, misclosure / variance)
                row(
                    i, x, y, z, position, attitude, rate, values, rotation, derivatives, turn,
                    spheres[t], shapes[t], out, lidar,
                )  # fmt: skip
            for k in range(count):
                wide[k] = out[active[k]]
            for k in range(4):
                wide[count + k] = out[9 + k]
            if len(fraction) > 0:
                u = fraction[i]
                for k in range(6):
                    wide[pose + k] = (1 - u) * out[13 + k]
                    wide[pose + 6 + k] = u * out[13 + k]
            wide[width - 1] = misclosure
            precision = trust[t] / variance
            if loss > 0:
                precision *= weight(loss, tuning, misclosure / np.sqrt(variance) / scale[t])
            for j in range(width):
                weighted = wide[j] * precision
                for k in range(j + 1):
                    total[j, k] += weighted * wide[k]


def standardised(observations: Observations, groups: Groups, state: State) -> Array:
    """Residual of each point over the standard deviation of its condition's noise, shape (n,).

    With the effects found so far applied; the same numbers `sum_by_group` gives its loss.
    """
    out = np.empty(len(observations))
    arguments = (
        *columns(observations), observations.sighting, *turns(observations, state.mounting),
        state.shapes, state.surface, groups.start, groups.knot,
        *pos_between_knots(groups), state.effects,
        observations.sigma_lidar, observations.beam_sigmas, observations.sigma_position,
        observations.sigma_attitude, out,
    )  # fmt: skip
    in_chunks(lambda first, last: _standardised(first, last, *arguments), groups.start[1:])
    return out


@njit(nogil=True, cache=True)
def _standardised(  # type: ignore[no-untyped-def]
    first, last,
    points, position, attitude, rate, target, spheres, sighting,
    values, rotation, derivatives, turn, shapes, surface,
    start, knot, fraction, stray, effects,
    sigma_lidar, beam, sigma_position, sigma_attitude, standardised,
):  # fmt: skip
    out, lidar = np.empty(20), np.empty(3)
    for g in range(first, last):
        for i in range(start[g], start[g + 1]):
            t = target[i]
            row(
                i, points[i, 0], points[i, 1], points[i, 2], position, attitude, rate, values,
                rotation, derivatives, turn, spheres[t], shapes[t], out, lidar,
            )  # fmt: skip
            misclosure, variance = residual(
                i, knot[g], points, surface[sighting[i]], fraction, stray, effects, sigma_lidar,
                beam, sigma_position, sigma_attitude, out, lidar,
            )  # fmt: skip
            standardised[i] = misclosure / np.sqrt(variance)
