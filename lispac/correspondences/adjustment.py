"""Adjustment of point correspondences: pairs of measured points of the same place.

The two points of a pair, measured at different times, have the same position in the local frame
(Brun, Cucci and Skaloud 2022). Each pair gives three conditions ``X_i - X_j = 0``, with the same
georeferencing, derivatives and POS error model as the conditions of the targets. The correlated POS
errors are estimated together with the boresight. The noise of the pairs, which contains that of the
LiDAR and the error of the matching, is the same in all directions and is estimated from the
residuals by default. Wrong pairs are weighted down (Huber 1964), then rejected by a test.
"""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.condition_equations import (
    MISCLOSURE_COLUMN,
    POSE_COLUMNS,
    evaluate_columns,
    linearise,
)
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import MAX_PARAMETER_SIGMAS, mounting_value_names
from lispac.adjustment.model.stochastic_model import PosErrorKnots, StochasticModel
from lispac.adjustment.result import ANGLES
from lispac.errors import AdjustmentError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress, sub_progress
from lispac.survey.georeferencing import Mounting

if TYPE_CHECKING:
    from scipy.sparse import csr_array, dia_array

Array = NDArray[np.float64]

BORESIGHT_COLUMNS = slice(0, 3)
"""Columns of the derivatives by roll, pitch and yaw, of those by the mounting."""
MIN_PAIRS = 20
"""Smallest number of pairs, from which the noise can be estimated and wrong pairs be found."""
MAX_KNOTS = 250
"""Largest number of knots of the POS error. The deviation from the linear interpolation between
them is added to the noise; with 2 s between knots and a correlation time of 300 s, its standard
deviation is at most 6 % of that of the POS error."""
MAX_ITERATIONS = 30
CONVERGENCE_RAD = 1e-9
"""Change of an angle below which the iteration ends, radians: 0.1 micrometres at 100 m."""
CONVERGENCE_NOISE = 1e-4
"""Relative change of the noise below which the iteration ends."""
ROUGH_CONVERGENCE_RAD, ROUGH_CONVERGENCE_NOISE = 1e-6, 0.01
"""Changes below which the start and the iteration with Huber's weights end."""
MIN_SIGMA_M = 1e-7
"""Smallest noise of a pair, metres; zero would give an infinite weight."""
MEDIAN_LENGTH = 1.5382
"""Median length of a vector with three independent standard normal components."""
HUBER_LENGTH = 2.7955
"""Standardised length from which pairs are weighted down, exceeded by 5 % of correct pairs."""
REJECTION_LENGTH = 4.0331
"""Standardised length from which pairs are rejected, exceeded by 0.1 % of correct pairs."""
TRUNCATED_VARIANCE = 0.9949
"""Variance of the components of a correct pair that is not rejected, in that of the noise."""
MAX_REJECTED_SHARE = 0.5
"""Largest share of rejected pairs; with more the estimate could be that of the wrong pairs."""


@dataclass(frozen=True, eq=False)
class CorrespondenceEstimate:
    """Result of an adjustment of point correspondences.

    Attributes
    ----------
    boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    covariance : ndarray of shape (3, 3), square radians
    used : ndarray of shape (n,), bool
        Pairs that were not rejected.
    noise : float, metres
        Standard deviation of a coordinate difference of a pair without the POS errors.
    is_noise_estimated : bool
    variance_factor : float
        Variance factor of the given noise; 1 if it was estimated.
    rms_before, rms_after : float, metres
        Root mean square distance of the points of the used pairs with the prior and the estimated
        boresight; POS errors are not removed.
    """

    boresight: Array
    covariance: Array
    used: NDArray[np.bool_]
    noise: float
    is_noise_estimated: bool
    variance_factor: float
    rms_before: float
    rms_after: float

    @property
    def sigma(self) -> Array:
        """Standard deviations of roll, pitch and yaw, shape (3,), radians."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))


@dataclass(frozen=True, eq=False)
class _PairConditions:
    """Linearised conditions of all pairs, three rows for each.

    Attributes
    ----------
    by_boresight : ndarray of shape (n, 3, 3), metres per radian
        Derivatives of the difference of each coordinate by roll, pitch, yaw.
    by_pos : sparse array of shape (3 n, 6 knots)
        Derivatives by the corrections of the poses at the knots.
    bridge : ndarray of shape (n, 3), square metres
        Variance of the deviation of the POS error from the linear interpolation.
    difference : ndarray of shape (n, 3), metres
    """

    by_boresight: Array
    by_pos: "csr_array"
    bridge: Array
    difference: Array


@dataclass(frozen=True, eq=False)
class _State:
    """State of the iteration.

    Attributes
    ----------
    noise : float, metres
    weight : ndarray of shape (n,)
        Weight of each pair besides that of its noise; 0 if it is rejected.
    """

    mounting: Mounting
    noise: float
    weight: Array


@dataclass(frozen=True, eq=False)
class _Solution:
    """Solution of the linearised equations.

    Attributes
    ----------
    change : ndarray of shape (3,), radians
    covariance : ndarray of shape (3, 3), square radians
    residual : ndarray of shape (n, 3), metres
        Differences that remain with the changed boresight and the corrected poses.
    redundancy : float
        Number of weighted conditions minus the trace of their hat matrix.
    """

    change: Array
    covariance: Array
    residual: Array
    redundancy: float


def adjust_correspondences(
    ends: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    noise: float | None = None,
    progress: Progress = no_progress,
) -> CorrespondenceEstimate:
    """Estimate the boresight from pairs of points.

    Parameters
    ----------
    ends : Observations
        The first points of all n pairs, then their second points, as points of one target; the
        LiDAR noise is not used.
    mounting : Mounting
        Prior mounting; all values except the boresight are kept.
    noise : float, metres, optional
        Standard deviation of a coordinate difference of a pair; by default it is estimated.

    Raises
    ------
    AdjustmentError
        If there are fewer than `MIN_PAIRS` pairs, most are wrong, the adjustment does not converge
        or the pairs do not determine an angle.
    """
    count = len(ends) // 2
    if count < MIN_PAIRS:
        raise AdjustmentError(error("correspondences.few", count=count, least=MIN_PAIRS))
    progress(0.0, gettext_lazy("Adjusting point correspondences"))
    knots = _coarse_knots(ends, model)
    first = _pair_differences(ends, mounting)
    mounting = _robust_start(ends, mounting)
    lengths = np.linalg.norm(_pair_differences(ends, mounting), axis=1)
    start = max(float(np.median(lengths)) / MEDIAN_LENGTH, MIN_SIGMA_M)
    state = _State(mounting, start if noise is None else noise, np.ones(count))
    state, _ = _iterate(
        ends, state, knots, with_noise=noise is None, robust=True,
        progress=sub_progress(progress, 0.1, 0.5),
    )  # fmt: skip
    state, solution = _iterate(
        ends, state, knots, with_noise=noise is None, robust=False,
        progress=sub_progress(progress, 0.5, 1.0),
    )  # fmt: skip
    mounting, used = state.mounting, state.weight > 0
    _require_determined(solution.covariance)
    factor = 1.0
    if noise is not None:
        bridge = _linearise(ends, mounting, knots).bridge
        squares = (solution.residual**2 / (noise**2 + bridge))[used]
        factor = float(squares.sum() / solution.redundancy)
    after = _pair_differences(ends, mounting)
    return CorrespondenceEstimate(
        mounting.boresight,
        solution.covariance,
        used,
        state.noise,
        noise is None,
        factor,
        _root_mean_square(first[used]),
        _root_mean_square(after[used]),
    )


def _root_mean_square(differences: Array) -> float:
    return float(np.sqrt((differences**2).sum(axis=1).mean()))


def _require_determined(covariance: Array) -> None:
    sigma = np.sqrt(np.diag(covariance))
    weak = ~(sigma <= MAX_PARAMETER_SIGMAS[:3])
    if weak.any():
        names = [name for name, is_weak in zip(ANGLES, weak, strict=True) if is_weak]
        raise AdjustmentError(
            error("correspondences.undetermined", angles=mounting_value_names(names))
        )


def _coarse_knots(ends: Observations, model: StochasticModel) -> PosErrorKnots:
    """Knots of the POS error, at most `MAX_KNOTS`."""
    interval = model.knot_interval
    while True:
        cell = np.unique(np.floor(ends.time / interval))
        if len(np.union1d(cell, cell + 1)) <= MAX_KNOTS:
            return PosErrorKnots.of(ends, model, interval)
        interval *= 1.5


def _planes(direction: int) -> Array:
    """Plane through the origin whose misclosure is a coordinate, shape (1, 4)."""
    return np.concatenate([np.eye(3)[direction], [0.0]])[None]


def _pair_differences(ends: Observations, mounting: Mounting) -> Array:
    """Difference of the two points of each pair in the local frame, shape (n, 3), metres."""
    column = slice(MISCLOSURE_COLUMN, MISCLOSURE_COLUMN + 1)
    points = np.column_stack(
        [evaluate_columns(ends, mounting, _planes(k), column)[:, 0] for k in range(3)]
    )
    return _first_minus_second(points)


def _first_minus_second(of_ends: Array) -> Array:
    """Values of the first points of all pairs minus those of the second ones; (2 n, ...) given."""
    count = len(of_ends) // 2
    return np.asarray(of_ends[:count] - of_ends[count:])


def _condition_rows(ends: Observations, mounting: Mounting) -> Array:
    """Rows of `linearise` for the three coordinates of each point, shape (2 n, 3, columns)."""
    return np.stack([linearise(ends, mounting, _planes(k)).rows for k in range(3)], axis=1)


def _linearise(ends: Observations, mounting: Mounting, knots: PosErrorKnots) -> _PairConditions:
    from scipy.sparse import coo_array

    count = len(ends) // 2
    rows = _condition_rows(ends, mounting)
    by_pose = rows[:, :, POSE_COLUMNS]  # (2 n, 3, 6)
    sign = np.repeat([1.0, -1.0], count)
    variance = knots.bridge_factor * np.hstack([ends.sigma_position, ends.sigma_attitude]) ** 2
    bridge = np.einsum("pkc,pc->pk", by_pose**2, variance * knots.bridge_variance[:, None])
    condition = 3 * np.tile(np.arange(count), 2)[:, None, None] + np.arange(3)[:, None]
    entries, row_numbers, columns = [], [], []
    for knot, share in ((knots.left, 1 - knots.fraction), (knots.left + 1, knots.fraction)):
        entries.append((by_pose * (sign * share)[:, None, None]).ravel())
        row_numbers.append(np.broadcast_to(condition, by_pose.shape).ravel())
        columns.append(
            np.broadcast_to(
                6 * knot.astype(np.int64)[:, None, None] + np.arange(6), by_pose.shape
            ).ravel()
        )
    by_pos = coo_array(
        (np.concatenate(entries), (np.concatenate(row_numbers), np.concatenate(columns))),
        shape=(3 * count, 6 * len(knots.time)),
    ).tocsr()
    return _PairConditions(
        _first_minus_second(rows[:, :, BORESIGHT_COLUMNS]),
        by_pos,
        bridge[:count] + bridge[count:],
        _first_minus_second(rows[:, :, MISCLOSURE_COLUMN]),
    )


def _robust_start(ends: Observations, mounting: Mounting) -> Mounting:
    """Boresight with the smallest sum of distances, without POS errors.

    The prior boresight may be wrong by degrees, and a third of the pairs may be wrong.
    """
    for _ in range(MAX_ITERATIONS):
        rows = _condition_rows(ends, mounting)
        by_boresight = _first_minus_second(rows[:, :, BORESIGHT_COLUMNS])
        difference = _first_minus_second(rows[:, :, MISCLOSURE_COLUMN])
        length = np.linalg.norm(difference, axis=1)
        weight = 1 / np.maximum(length, max(1e-3 * float(np.median(length)), MIN_SIGMA_M))
        normal = np.einsum("n,nki,nkj->ij", weight, by_boresight, by_boresight)
        right = np.einsum("n,nki,nk->i", weight, by_boresight, difference)
        # The length of the derivatives by an undetermined angle is negligible
        values, vectors = np.linalg.eigh(normal)
        kept = values > 1e-12 * max(values[-1], np.finfo(float).tiny)
        change = -vectors[:, kept] @ ((vectors[:, kept].T @ right) / values[kept])
        mounting = mounting.with_boresight(mounting.boresight + change)
        if np.abs(change).max() < ROUGH_CONVERGENCE_RAD:
            break
    return mounting


def _iterate(
    ends: Observations, state: _State, knots: PosErrorKnots,
    *, with_noise: bool, robust: bool, progress: Progress,
) -> tuple[_State, _Solution]:  # fmt: skip
    """Iterate boresight, POS errors and noise with Huber's weights, or with rejected pairs.

    Parameters
    ----------
    with_noise : whether the noise is estimated

    Raises
    ------
    AdjustmentError
        If the iteration does not converge, or most pairs are rejected.
    """
    count = len(ends) // 2
    for k in range(MAX_ITERATIONS):
        progress(k / MAX_ITERATIONS)
        conditions = _linearise(ends, state.mounting, knots)
        variance = state.noise**2 + conditions.bridge
        solution = _solve(conditions, knots, state.weight[:, None] / variance)
        length = np.linalg.norm(solution.residual / np.sqrt(variance), axis=1)
        weight = np.minimum(1.0, HUBER_LENGTH / np.maximum(length, 1e-12))
        if not robust:
            weight = (length <= REJECTION_LENGTH).astype(float)
            if k >= MAX_ITERATIONS // 2:  # a pair at the limit could be rejected by turns
                weight = np.minimum(weight, state.weight)
            if 1 - weight.mean() > MAX_REJECTED_SHARE:
                rejected = count - int(weight.sum())
                raise AdjustmentError(
                    error("correspondences.most_rejected", rejected=rejected, count=count)
                )
        noise = state.noise
        if with_noise:
            noise = max(noise * _noise_factor(state, solution, variance, robust), MIN_SIGMA_M)
        former = state
        mounting = state.mounting.with_boresight(state.mounting.boresight + solution.change)
        state = _State(mounting, noise, weight)
        change = float(np.abs(solution.change).max())
        noise_change = abs(noise - former.noise) / noise
        if robust:  # it only has to find the correct pairs
            is_settled = change <= ROUGH_CONVERGENCE_RAD and noise_change <= ROUGH_CONVERGENCE_NOISE
        else:
            is_settled = (
                change <= CONVERGENCE_RAD
                and noise_change <= CONVERGENCE_NOISE
                and np.array_equal(weight, former.weight)
            )
        if is_settled:
            break
    else:
        if not robust:
            raise AdjustmentError(error("correspondences.not_converged", iterations=MAX_ITERATIONS))
    if robust:
        limit = REJECTION_LENGTH * state.noise / former.noise
        state = replace(state, weight=(length <= limit).astype(float))
    return state, solution


def _noise_factor(state: _State, solution: _Solution, variance: Array, robust: bool) -> float:
    """Factor from the noise of the state to that of its residuals."""
    if not robust:
        squares = (state.weight[:, None] * solution.residual**2 / variance).sum()
        return float(np.sqrt(squares / solution.redundancy / TRUNCATED_VARIANCE))
    length = np.linalg.norm(solution.residual / np.sqrt(variance), axis=1)
    # Residuals are smaller than the noise by the share that the unknowns fit
    share = min(solution.redundancy / (3 * state.weight.sum()), 1.0)
    return float(np.median(length)) / MEDIAN_LENGTH / np.sqrt(max(share, 1e-3))


def _solve(conditions: _PairConditions, knots: PosErrorKnots, precision: Array) -> _Solution:
    """Solve the linearised equations with the prior of the POS errors.

    Parameters
    ----------
    precision : ndarray of shape (n, 3), per square metre
    """
    from scipy.sparse import diags_array

    count, pos_count = len(precision), conditions.by_pos.shape[1]
    diagonal = diags_array(precision.ravel())
    boresight = conditions.by_boresight.reshape(3 * count, 3)
    difference = conditions.difference.ravel()
    weighted = diagonal @ conditions.by_pos
    size = 3 + pos_count
    normal = np.zeros((size, size))
    normal[:3, :3] = boresight.T @ (diagonal @ boresight)
    normal[:3, 3:] = (weighted.T @ boresight).T
    normal[3:, :3] = normal[:3, 3:].T
    normal[3:, 3:] = (conditions.by_pos.T @ weighted).toarray()
    right = np.concatenate(
        [boresight.T @ (precision.ravel() * difference), weighted.T @ difference]
    )
    prior = _prior_precision(knots)
    normal[3:, 3:] += prior.toarray()
    # Scaled, since angles and lengths have units of different sizes
    diagonal_elements = np.diag(normal)
    scale = 1 / np.sqrt(np.where(diagonal_elements > 0, diagonal_elements, 1.0))
    normal *= scale[:, None] * scale
    normal[np.diag_indices(3)] += REGULARISATION
    inverse = _inverse_of_positive_definite(normal) * scale[:, None] * scale
    found = -inverse @ right
    residual = difference + boresight @ found[:3] + conditions.by_pos @ found[3:]
    effective = float((precision > 0).sum())
    # The normal matrix is the sum of the observed part and of the prior
    trace = size - float(prior.multiply(inverse[3:, 3:]).sum())
    return _Solution(
        found[:3],
        0.5 * (inverse[:3, :3] + inverse[:3, :3].T),
        residual.reshape(count, 3),
        max(effective - trace, 1e-9),
    )


REGULARISATION = 1e-14
"""Added to the scaled diagonal of the angles, so that an undetermined angle gets a very large
standard deviation, by which it is recognised, instead of a singular matrix."""


def _inverse_of_positive_definite(matrix: Array) -> Array:
    """Inverse by Cholesky's factors, which takes half of the time of a solution for all columns.

    Raises
    ------
    AdjustmentError
        If the matrix is singular, which only the angles can cause.
    """
    from scipy.linalg.lapack import dpotrf, dpotri

    factor, failed_at = dpotrf(matrix, lower=True, clean=False)
    if failed_at:
        raise AdjustmentError(
            error("correspondences.undetermined", angles=mounting_value_names(ANGLES))
        )
    inverse, _ = dpotri(factor, lower=True, overwrite_c=True)
    lower = np.tril(inverse, -1)
    return np.asarray(lower + lower.T + np.diag(np.diag(inverse)))


def _prior_precision(knots: PosErrorKnots) -> "dia_array":
    """Prior precision matrix of the corrections at all knots, (6 knots, 6 knots)."""
    from scipy.sparse import diags_array

    beside = knots.precision_beside.ravel()
    return diags_array([beside, knots.precision_diagonal.ravel(), beside], offsets=[-6, 0, 6])
