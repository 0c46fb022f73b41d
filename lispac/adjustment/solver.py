"""The least-squares adjustment of boresight and planes (thesis B.3)."""

import time
from dataclasses import dataclass

import numpy as np
import scipy.linalg
import scipy.stats
from numpy.typing import NDArray

from lispac.adjustment.conditions import Groups, linearise, sum_by_group
from lispac.adjustment.observations import Observations
from lispac.adjustment.result import (
    AdjustmentResult,
    ChiSquare,
    SightingResidual,
    TargetResidual,
)
from lispac.adjustment.stochastic import PosErrorKnots, StochasticModel
from lispac.errors import NotConverged, RankDeficient
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

MAX_ITERATIONS = 100
ANGLES_SETTLED, PLANES_SETTLED = 1e-11, 1e-8
"""Largest change of an angle (rad) and of a plane parameter (rad, m) in the last iteration."""

WORST_SIGMA = np.radians(5.0)
"""An angle that the geometry cannot tell to better than this is not determined by it: the mounting
is known to a few degrees from looking at it."""


@dataclass(frozen=True, eq=False)
class _Step:
    correction: Array  # boresight (3), then 3 per plane
    effects: Array  # correction of the POS error at its knots, shape (knots, 6)
    covariance: Array
    quadratic: float  # v' P v at the linearisation point


def adjust(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    planes: Array | None = None,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Find the boresight that makes each target's points, over all lines, one plane.

    Gauss-Helmert model with unit normals kept exactly: a plane moves by two turns of its normal
    and its offset. The products summed over groups of points carry all the points say, so an
    iteration costs one pass over them and a small solve.

    Parameters
    ----------
    mounting : Mounting
        Lever arm, and the prior boresight as the starting value.
    planes : ndarray of shape (targets, 4), optional
        Starting planes; fitted to the points placed with the prior boresight where not given.

    Raises
    ------
    AdjustmentError
        Where a sighting has too few points.
    RankDeficient
        Where lines and targets do not determine the boresight.
    NotConverged
    """
    started = time.perf_counter()
    observations.require_usable()
    fitted = fit_planes(observations, mounting)
    centres = _centres(observations, mounting)
    current = fitted if planes is None else planes / np.linalg.norm(planes[:, :3], axis=1)[:, None]
    knots = PosErrorKnots.of(observations, model) if model.pos_errors == "correlated" else None
    groups = Groups.of(observations, knots)
    boresight = np.array(mounting.boresight, dtype=float)
    effects = np.zeros((0 if knots is None else len(knots.time), 6))
    for iteration in range(1, MAX_ITERATIONS + 1):
        progress(iteration / MAX_ITERATIONS, f"Adjusting: iteration {iteration}")
        tangents = _tangents(current, centres)
        step = _solve(
            observations, mounting.with_boresight(boresight), current, tangents, groups, effects
        )
        boresight = boresight + step.correction[:3]
        effects = effects + step.effects
        current = _moved(current, tangents, step.correction[3:].reshape(-1, 3))
        angles, turns = np.abs(step.correction[:3]).max(), np.abs(step.correction[3:]).max()
        if angles < ANGLES_SETTLED and turns < PLANES_SETTLED:
            break
    else:
        raise NotConverged(
            f"The adjustment did not settle in {MAX_ITERATIONS} iterations (last change "
            f"{np.degrees(angles):.1e} deg); check that each target is "
            "the same plane on every line, and the prior boresight."
        )
    # The last correction is below any figure shown, so what it was computed from describes the
    # solution.
    freedom = len(observations) - 3 - 3 * len(observations.targets)
    lower, upper = scipy.stats.chi2.ppf([0.025, 0.975], freedom) if freedom > 0 else (0.0, 0.0)
    adjusted = mounting.with_boresight(boresight)
    targets, sightings, rms = _residuals(
        observations, linearise(observations, mounting, fitted).misclosure,
        linearise(observations, adjusted, current).misclosure, current,
    )  # fmt: skip
    return AdjustmentResult(
        boresight=boresight,
        prior_boresight=np.array(mounting.boresight, dtype=float),
        covariance=step.covariance,
        model=model,
        variance_factor=step.quadratic / freedom if freedom > 0 else float("nan"),
        degrees_of_freedom=freedom,
        chi_square=ChiSquare(step.quadratic, float(lower), float(upper)),
        iterations=iteration,
        targets=targets,
        sightings=sightings,
        rms_before=rms[0],
        rms_after=rms[1],
        elapsed=time.perf_counter() - started,
    )


def fit_planes(observations: Observations, mounting: Mounting) -> Array:
    """Least-squares plane of each target through its points placed with ``mounting``.

    Returns
    -------
    ndarray of shape (targets, 4), unit normal and offset, local frame
    """
    points_local = _points_local(observations, mounting)
    target = observations.target_of_sighting[observations.sighting]
    planes = np.empty((len(observations.targets), 4))
    for k in range(len(observations.targets)):
        own = points_local[target == k]
        centre = own.mean(axis=0)
        normal = np.linalg.eigh(np.cov((own - centre).T))[1][:, 0]
        planes[k] = *normal, -normal @ centre
    return planes


def _points_local(observations: Observations, mounting: Mounting) -> Array:
    any_plane = np.tile([0.0, 0.0, 1.0, 0.0], (len(observations.targets), 1))
    # The Jacobian by (a, b, c) is the point itself.
    return linearise(observations, mounting, any_plane).rows[:, 3:6]


def _centres(observations: Observations, mounting: Mounting) -> Array:
    """Mean point of each target, shape (targets, 3), metres."""
    points_local = _points_local(observations, mounting)
    target = observations.target_of_sighting[observations.sighting]
    counts = np.bincount(target)
    return np.stack([np.bincount(target, column) / counts for column in points_local.T], axis=1)


def _tangents(planes: Array, centres: Array) -> Array:
    """Basis of the allowed changes of each plane, shape (targets, 4, 3).

    Two turns of the normal about the target's centre and a shift along it: about the centre
    instead of the origin, so that turns and shift are nearly independent.
    """
    tangents = np.zeros((len(planes), 4, 3))
    for tangent, plane, centre in zip(tangents, planes, centres, strict=True):
        tangent[:3, :2] = scipy.linalg.null_space(plane[None, :3])
        tangent[3, :2] = -centre @ tangent[:3, :2]
        tangent[3, 2] = 1
    return tangents


def _moved(planes: Array, tangents: Array, corrections: Array) -> Array:
    moved = planes + np.einsum("kij,kj->ki", tangents, corrections)
    return np.asarray(moved / np.linalg.norm(moved[:, :3], axis=1)[:, None])


def _solve(
    observations: Observations,
    mounting: Mounting,
    planes: Array,
    tangents: Array,
    groups: Groups,
    effects: Array,
) -> _Step:
    sums = sum_by_group(observations, mounting, planes, groups, effects)
    # The parameters behind the seven columns of boresight and plane
    own = np.zeros((len(planes), 7, 3 + 3 * len(planes)))
    own[:, :3, :3] = np.eye(3)
    for k, tangent in enumerate(tangents):
        own[k, 3:, 3 + 3 * k : 6 + 3 * k] = tangent
    own = own[groups.target]
    normal = np.einsum("gip,gij,gjq->pq", own, sums[:, :7, :7], own, optimize=True)
    right = -np.einsum("gip,gi->p", own, sums[:, :7, -1])
    quadratic = float(sums[:, -1, -1].sum())
    if groups.knots is None:
        covariance = _covariance(normal)
        correction = scipy.linalg.solve(normal, right, assume_a="pos")
        return _Step(correction, effects, covariance, quadratic - float(correction @ right))
    # The POS error is eliminated first: its normal matrix is banded, for a group couples two
    # neighbouring knots and so does the prior.
    shared = np.einsum("gip,gij->gpj", own, sums[:, :7, 7:19])
    band, mixed, pull = _pos_error_equations(groups.knots, groups.knot, sums, shared, effects)
    factor = scipy.linalg.cholesky_banded(band, lower=True)
    solved = scipy.linalg.cho_solve_banded((factor, True), np.column_stack([mixed.T, pull]))
    reduced = normal - mixed @ solved[:, :-1]
    reduced_right = right - mixed @ solved[:, -1]
    covariance = _covariance(reduced)
    correction = scipy.linalg.solve(reduced, reduced_right, assume_a="pos")
    change = solved[:, -1] - solved[:, :-1] @ correction
    quadratic += float((groups.knots.weighted(effects) * effects).sum())
    quadratic -= float(correction @ right + change @ pull)
    return _Step(correction, change.reshape(-1, 6), covariance, quadratic)


def _pos_error_equations(
    knots: PosErrorKnots,
    knot_of_group: NDArray[np.int64],
    sums: Array,
    shared: Array,
    effects: Array,
) -> tuple[Array, Array, Array]:
    """Normal equations of the POS error at its knots.

    Returns
    -------
    band : ndarray of shape (12, knots * 6)
        Lower diagonals of the normal matrix, as LAPACK wants them.
    mixed : ndarray of shape (parameters, knots * 6)
        The part of the normal matrix shared with boresight and planes.
    pull : ndarray of shape (knots * 6,)
        Right-hand side.
    """
    unknowns = effects.size
    band = np.zeros((12, unknowns))
    band[0] = knots.precision_diagonal.reshape(-1)
    band[6, : unknowns - 6] = knots.precision_beside.reshape(-1)
    mixed = np.zeros((shared.shape[1], unknowns))
    pull = -knots.weighted(effects).reshape(-1)
    for total, part, knot in zip(sums, shared, knot_of_group, strict=True):
        first = 6 * knot
        for j in range(12):
            band[: 12 - j, first + j] += total[7 + j : 19, 7 + j]
        mixed[:, first : first + 12] += part
        pull[first : first + 12] -= total[7:19, -1]
    return band, mixed, pull


def _covariance(normal: Array) -> Array:
    """Covariance of the boresight: everything else eliminated.

    Raises
    ------
    RankDeficient
    """
    try:
        rest = scipy.linalg.cho_factor(normal[3:, 3:])
    except np.linalg.LinAlgError as error:
        raise RankDeficient(
            "A target's plane is not determined by its points; pick points that spread over it "
            "in two directions."
        ) from error
    reduced = normal[:3, :3] - normal[:3, 3:] @ scipy.linalg.cho_solve(rest, normal[3:, :3])
    eigenvalues, directions = np.linalg.eigh((reduced + reduced.T) / 2)
    if eigenvalues[0] < max(1 / WORST_SIGMA**2, 1e-12 * eigenvalues[2]):
        share = np.abs(directions[:, 0])
        angle = ("roll", "pitch", "yaw")[int(np.argmax(share))]
        raise RankDeficient(
            f"These lines and targets do not determine the boresight (mainly {angle}); add a "
            "target of another inclination, or lines in other directions: a vertical target shows "
            "roll on lines 0/180, pitch on 45/225 and yaw on 45/135 deg to it."
        )
    return np.asarray(np.linalg.inv(reduced))


def _residuals(
    observations: Observations, before: Array, after: Array, planes: Array
) -> tuple[tuple[TargetResidual, ...], tuple[SightingResidual, ...], tuple[float, float]]:
    squares = observations.mean_by_sighting(np.stack([before**2, after**2], axis=1))
    means = observations.mean_by_sighting(after)
    sightings = tuple(
        SightingResidual(sighting, int(count), float(b), float(a), float(mean))
        for sighting, count, (b, a), mean in zip(
            observations.sightings, observations.counts, np.sqrt(squares), means, strict=True
        )
    )
    targets = []
    for k, name in enumerate(observations.targets):
        own = observations.target_of_sighting == k
        counts = observations.counts[own]
        b, a = np.sqrt(counts @ squares[own] / counts.sum())
        targets.append(TargetResidual(name, int(counts.sum()), float(b), float(a), planes[k]))
    both = np.sqrt(observations.counts @ squares / len(observations))
    return tuple(targets), sightings, (float(both[0]), float(both[1]))
