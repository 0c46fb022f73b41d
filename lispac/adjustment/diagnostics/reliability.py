"""Reliability: redundancy, tests and minimal detectable biases (Baarda 1968)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.condition_equations import (
    MountingArrays,
    PointArrays,
)
from lispac.adjustment.model.robust_loss import loss_weight
from lispac.adjustment.model.threads import run_in_chunks
from lispac.adjustment.result import SightingReliability
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.adjustment.solve.group_sums import (
    EffectArrays,
    PointWeights,
    WeightArrays,
    linearisation_pose,
    point_misclosure,
    write_group_row,
)
from lispac.compiled_code import kernel

Array = NDArray[np.float64]

CRITICAL_VALUE = 3.29
"""Critical value of the test of a point at a level of 0.1 %."""

NONCENTRALITY = 4.13
"""Shift that the test at a level of 0.1 % detects with a power of 80 %, in standard deviations."""

MIN_MEAN_WEIGHT = 0.2
"""Mean weight of the points below which a sighting is a blunder, such as another surface."""


@dataclass(frozen=True, eq=False)
class SightingTests:
    """Tests of a shift of each single sighting as a whole.

    Attributes
    ----------
    shift, sigma : ndarray of shape (sightings,), metres
        Shift from the result of all other sightings, and its standard deviation including form
        errors.
    effect : ndarray of shape (sightings, 3), radians per metre
        Change of roll, pitch and yaw per metre of an undetected shift.
    """

    shift: Array
    sigma: Array
    effect: Array

    @property
    def w(self) -> Array:
        """Test values, shape (sightings,)."""
        return self.shift / self.sigma


def sighting_tests(linearised: LinearisedProblem) -> SightingTests:
    """Test the shift of each sighting (correlated model).

    The shift is the offset of the sighting without its prior. It is computed by removing the prior
    from the solution, without a new adjustment.
    """
    problem, covariance = linearised.problem, linearised.normal.covariance
    places = np.array([place.stop - 1 for place in linearised.normal.layout.surfaces])
    prior = problem.surface_sigma[:, 2] ** 2
    after = covariance[places, places]
    # Information on the offset from the data; nearly zero if only the prior determines it
    data_information = np.maximum(1 / after - 1 / prior, 1e-9)
    shift = linearised.departures[:, 2] / after / data_information
    sigma = np.sqrt(problem.default_surface_sigmas[2] ** 2 + 1 / data_information)
    return SightingTests(shift, sigma, covariance[:3, places].T / prior[:, None])


def compute_reliability(linearised: LinearisedProblem) -> tuple[SightingReliability, ...]:
    """Compute tests and minimal detectable biases of points and sightings (correlated model)."""
    problem, normal = linearised.problem, linearised.normal
    observations, knots = problem.observations, problem.groups.knots
    assert knots is not None
    tests = sighting_tests(linearised)
    knot_covariance = normal.knot_covariance
    redundancy, w, detectable, weights = _point_reliability(
        linearised, _group_covariances(linearised, knot_covariance)
    )
    mean = observations.mean_by_sighting
    times = mean(observations.time)
    nearest = np.clip(np.searchsorted(knots.time, times), 1, len(knots.time) - 1)
    nearest -= times - knots.time[nearest - 1] < knots.time[nearest] - times
    variance = normal.pos_error_variances[0]
    prior = np.hstack([mean(observations.sigma_position), mean(observations.sigma_attitude)])
    outliers = np.bincount(observations.sighting, np.abs(w) > CRITICAL_VALUE)
    mean_redundancy, mean_weight = mean(redundancy), mean(weights)
    found = []
    for s, sighting in enumerate(observations.sightings):
        own = np.flatnonzero(observations.sighting == s)
        worst = own[np.abs(w[own]).argmax()]
        found.append(
            SightingReliability(
                sighting=sighting,
                # the state contains what is added to the reported position and attitude
                pos_error=-linearised.state.pos_corrections[nearest[s]],
                pos_sigma=prior[s],
                pos_sigma_after=np.sqrt(variance[nearest[s]]),
                shift=float(tests.shift[s]),
                w=float(tests.w[s]),
                detectable=float(NONCENTRALITY * tests.sigma[s]),
                effect=tests.effect[s] * NONCENTRALITY * tests.sigma[s],
                redundancy=float(mean_redundancy[s]),
                outliers=int(outliers[s]),
                largest_w=float(abs(w[worst])),
                largest_at=float(observations.time[worst]),
                point_detectable=float(np.median(detectable[own])),
                weight=float(mean_weight[s]),
                rejected=bool(problem.rejected_sightings[s] or mean_weight[s] < MIN_MEAN_WEIGHT),
            )
        )
    return tuple(found)


def _group_covariances(
    linearised: LinearisedProblem, knot_covariance: tuple[Array, Array]
) -> Array:
    """Covariance of the unknowns in the columns of the sums of each group, (groups, m, m)."""
    normal, groups = linearised.normal, linearised.problem.groups
    layout, a = normal.layout, len(normal.layout.active)
    covariance, by_unknowns = normal.covariance, normal.pos_error_by_unknowns
    own, beside = knot_covariance
    padded = np.zeros((layout.size + 1, layout.size + 1))
    padded[:-1, :-1] = covariance
    mixed = np.zeros((layout.size + 1, len(by_unknowns)))
    mixed[:-1] = -covariance @ by_unknowns.T
    local = np.zeros((len(groups.sighting), a + 16, a + 16))
    basis = linearised.directions
    for g, (s, k) in enumerate(zip(groups.sighting, groups.knot, strict=True)):
        index = layout.index[s]
        effects = slice(6 * k, 6 * k + 12)
        local[g, : a + 4, : a + 4] = basis[s] @ padded[np.ix_(index, index)] @ basis[s].T
        local[g, : a + 4, a + 4 :] = basis[s] @ mixed[index, effects]
        local[g, a + 4 :, : a + 4] = local[g, : a + 4, a + 4 :].T
        pose = by_unknowns[effects] @ covariance @ by_unknowns[effects].T
        pose[:6, :6] += own[k]
        pose[6:, 6:] += own[k + 1]
        pose[6:, :6] += beside[k]
        pose[:6, 6:] += beside[k].T
        local[g, a + 4 :, a + 4 :] = pose
    return local


def _point_reliability(
    linearised: LinearisedProblem, local: Array
) -> tuple[Array, Array, Array, Array]:
    """Redundancy, test value, minimal detectable bias (metres), and weight of each point."""
    problem, state = linearised.problem, linearised.state
    observations, groups = problem.observations, problem.groups
    found = np.empty((4, len(observations)))
    points, effects = PointArrays.of(observations, state.mounting), EffectArrays.of(groups, state)
    placing = MountingArrays.of(state.mounting, state.shapes)
    weighting = WeightArrays.of(PointWeights(linearised.loss, problem.scale, problem.noise))
    run_in_chunks(
        lambda first, last: _point_tests_kernel(
            first, last, points, placing, effects, weighting, problem.active, local, found
        ),
        groups.start[1:],
    )
    redundancy, w, detectable, weights = found
    return redundancy, w, detectable, weights


@kernel()
def _point_tests_kernel(  # type: ignore[no-untyped-def]
    first, last, points, placing, effects, weights, active, local, found
):
    start, fraction = effects.start, effects.fraction
    sighting, target_of_sighting = points.sighting, points.target_of_sighting
    loss, tuning, _, scale, noise = weights
    out, lidar = np.empty(20), np.empty(3)
    width = local.shape[1]
    group_row = np.empty((1, width))
    for g in range(first, last):
        for i in range(start[g], start[g + 1]):
            t = target_of_sighting[sighting[i]]
            pose = linearisation_pose(i, g, points, effects)
            misclosure, variance = point_misclosure(
                i, g, pose, points, placing, effects, out, lidar
            )
            write_group_row(i, active, fraction, out, group_row, 0)
            explained = 0.0
            for j in range(width):
                across = 0.0
                for k in range(j):
                    across += local[g, j, k] * group_row[0, k]
                explained += group_row[0, j] * (2 * across + local[g, j, j] * group_row[0, j])
            weighted = 1.0
            if loss > 0:
                weighted = loss_weight(loss, tuning, misclosure / np.sqrt(variance) / scale[t])
            variance *= noise[t] ** 2
            redundancy = min(max(1 - weighted * explained / variance, 0.0), 1.0)
            sigma = np.sqrt(variance * max(redundancy, 1e-12))
            found[0, i] = redundancy
            found[1, i] = misclosure / sigma
            found[2, i] = NONCENTRALITY * variance / sigma
            found[3, i] = weighted
