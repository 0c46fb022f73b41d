"""Solution of an adjustment, and its result."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.condition_equations import incidence_angles, misclosures
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import ParameterEstimate
from lispac.adjustment.model.target_shapes import shapes_relative_to
from lispac.adjustment.result import (
    AdjustmentResult,
    ChiSquare,
    SightingResidual,
    SigmaGroup,
    TargetResidual,
    VarianceComponent,
)
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.group_sums import AdjustmentState
from lispac.adjustment.solve.noise_estimation import form_error_noise
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Solution:
    """Solution of an adjustment.

    Attributes
    ----------
    linearised : LinearisedProblem
        Equations of the last iteration. Its corrections are negligible, so that covariances and
        statistics computed from these equations describe the solution.
    state : AdjustmentState
        State after the last iteration.
    path : ndarray of shape (iterations, 3), radians
        As in `IterationResult`.
    fitted : ndarray of shape (targets, 4)
        Shapes fitted with the prior mounting.
    origins : ndarray of shape (targets, 3), metres, local
        Origin of the coordinates of each target.
    fixed : tuple of ParameterEstimate
        Parameters that the geometry does not determine.
    components : tuple of VarianceComponent
        Empty if they were not requested.
    assumed : tuple of {"LiDAR", "POS position", "POS attitude"}
        Groups of errors whose sigmas nobody gave.
    """

    linearised: LinearisedProblem
    state: AdjustmentState
    path: Array
    fitted: Array
    origins: Array
    fixed: tuple[ParameterEstimate, ...]
    components: tuple[VarianceComponent, ...]
    assumed: tuple[SigmaGroup, ...] = ()

    def result(self) -> AdjustmentResult:
        """Result of the adjustment, without diagnostics."""
        from scipy.special import chdtri

        problem, normal, state = self.linearised.problem, self.linearised.normal, self.state
        observations, layout = problem.observations, normal.layout
        unknowns = len(layout.active) + sum(s.stop - s.start for s in layout.shapes)
        known = sum(p.sigma is not None for p in problem.parameters)
        control = 0 if self.linearised.control is None else len(self.linearised.control)
        freedom = len(observations) + control + known - unknowns
        lower, upper = chdtri(freedom, [0.975, 0.025]) if freedom > 0 else (0.0, 0.0)
        after, standardised = problem.residuals(state)
        statistic = _weighted_residual_sum(self.linearised, state, standardised)
        form_noise = _form_error_noise(problem, state, standardised)
        targets, sightings, rms = _residual_statistics(
            observations, misclosures(observations, problem.prior, self.fitted), after,
            incidence_angles(observations, state.mounting, state.shapes),
            shapes_relative_to(state.shapes, -self.origins, observations.is_sphere),
            problem.noise, form_noise,
        )  # fmt: skip
        estimates = _parameter_estimates(problem, state, normal.covariance, self.fixed)
        shown = [
            0,
            1,
            2,
            *(MOUNTING_VALUE_NAMES.index(e.name) for e in estimates if e.value is not None),
        ]
        places = np.searchsorted(layout.active, sorted(shown))
        surfaces = problem.default_surface_sigmas
        return AdjustmentResult(
            mounting=state.mounting,
            prior_boresight=np.array(problem.prior.boresight, dtype=float),
            estimated=tuple(MOUNTING_VALUE_NAMES[k] for k in sorted(shown)),
            covariance_all=normal.covariance[np.ix_(places, places)],
            parameters=estimates,
            path=self.path,
            model=problem.model,
            variance_factor=statistic / freedom if freedom > 0 else float("nan"),
            degrees_of_freedom=freedom,
            chi_square=ChiSquare(statistic, float(lower), float(upper)),
            iterations=len(self.path),
            targets=targets,
            sightings=sightings,
            rms_before=rms[0],
            rms_after=rms[1],
            surface=float(surfaces[0]) if layout.surfaces else 0.0,
            offset=float(surfaces[2]) if problem.has_own_offsets else None,
            observability=None,
            reliability=(),
            components=self.components,
            elapsed=0.0,
            excluded_outliers=observations.excluded_outliers,
            causes=(),
            assumed_sigmas=self.assumed,
        )


def _weighted_residual_sum(
    linearised: LinearisedProblem, state: AdjustmentState, residuals: Array
) -> float:
    """``v' P v`` with the given sigmas, without the weights of the loss function."""
    problem = linearised.problem
    statistic = float(residuals @ residuals)
    if problem.groups.knots is not None:
        weighted = problem.groups.knots.apply_prior_precision(state.pos_corrections)
        statistic += float((weighted * state.pos_corrections).sum())
    if problem.layout.surfaces:
        statistic += float(((linearised.departures / problem.surface_sigma) ** 2).sum())
    if linearised.control is not None:
        statistic += linearised.control.quadratic
    off = state.mounting.values - problem.prior.values
    return statistic + sum(
        (float(off[p.index]) / p.sigma) ** 2 for p in problem.parameters if p.sigma is not None
    )


def _parameter_estimates(
    problem: AdjustmentProblem,
    state: AdjustmentState,
    covariance: Array,
    fixed: tuple[ParameterEstimate, ...],
) -> tuple[ParameterEstimate, ...]:
    undetermined = {estimate.name for estimate in fixed}
    found = list(fixed)
    for parameter in problem.parameters:
        if parameter.name in undetermined:
            continue
        k = int(np.searchsorted(problem.active, parameter.index))
        prior = float(problem.prior.values[parameter.index])
        value = float(state.mounting.values[parameter.index])
        sigma = float(np.sqrt(covariance[k, k]))
        # Test of the value from the data alone against the given one
        information = sigma**-2 - (0.0 if parameter.sigma is None else parameter.sigma**-2)
        spread = sigma**2 * np.sqrt(max(information, 0.0))
        found.append(
            ParameterEstimate(
                parameter.name, prior, parameter.sigma, value, sigma,
                _significance(value - prior, spread) if problem.model.correlated else None,
            )
        )  # fmt: skip
    return tuple(sorted(found, key=lambda estimate: MOUNTING_VALUE_NAMES.index(estimate.name)))


def _significance(change: float, sigma: float) -> float:
    return float(change / sigma) if sigma > 0 else 0.0


def _form_error_noise(
    problem: AdjustmentProblem, state: AdjustmentState, standardised: Array
) -> Array:
    """Evaluate `form_error_noise` for planes with more than the given noise; NaN for others."""
    of_interest = (problem.noise > 1) & ~problem.observations.is_sphere
    return form_error_noise(problem.observations, state.mounting, standardised, of_interest)


def _vessel_side(vessel: Array, shape: Array, *, is_sphere: bool) -> int:
    """Side of a plane on which the vessel was: 1 if its normal points there, else -1.

    Spheres are seen from outside, where distances are positive.

    Parameters
    ----------
    vessel : ndarray of shape (3,), metres, local frame
        Mean position of the vessel.
    shape : ndarray of shape (4,), local frame
    """
    return 1 if is_sphere or vessel @ shape[:3] + shape[3] >= 0.0 else -1


def _residual_statistics(
    observations: Observations,
    before: Array,
    after: Array,
    incidence: Array,
    shapes: Array,
    noise: Array,
    of_form: Array,
) -> tuple[tuple[TargetResidual, ...], tuple[SightingResidual, ...], tuple[float, float]]:
    mean = observations.mean_by_sighting
    vessel = mean(observations.position)
    squares = np.stack([mean(before**2), mean(after**2)], axis=1)
    means = np.stack([mean(after), mean(incidence)], axis=1)
    sightings = tuple(
        SightingResidual(sighting, int(count), float(b), float(a), float(mean), float(angle))
        for sighting, count, (b, a), (mean, angle) in zip(
            observations.sightings, observations.counts, np.sqrt(squares), means, strict=True
        )
    )
    targets = []
    for k, name in enumerate(observations.targets):
        own = observations.target_of_sighting == k
        counts = observations.counts[own]
        b, a = np.sqrt(counts @ squares[own] / counts.sum())
        targets.append(
            TargetResidual(
                name, int(counts.sum()), float(b), float(a), shapes[k],
                bool(observations.is_sphere[k]), float(noise[k]),
                None if np.isnan(of_form[k]) else float(of_form[k]),
                _vessel_side(
                    vessel[own].mean(axis=0), shapes[k], is_sphere=bool(observations.is_sphere[k])
                ),
            )
        )  # fmt: skip
    both = np.sqrt(observations.counts @ squares / len(observations))
    return tuple(targets), sightings, (float(both[0]), float(both[1]))
