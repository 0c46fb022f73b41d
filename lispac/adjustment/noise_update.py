"""Estimate noise and surface sigmas from the residuals between two iterations."""

from dataclasses import replace

import numpy as np

from lispac.adjustment.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.group_sums import AdjustmentState
from lispac.adjustment.noise_estimation import (
    is_point_on_target,
    target_noise_factors,
    target_noise_scales,
)
from lispac.adjustment.variance_components import OFFSETS, TILTS, most_likely_surface_sigma

SIGMA_TOLERANCE = 0.01
"""Relative change of an estimated sigma below which it has converged."""


def reestimate_noise(
    problem: AdjustmentProblem, state: AdjustmentState, *, falling: bool = True
) -> AdjustmentProblem:
    """Return the problem with the noise re-estimated from its residuals.

    Without ``falling`` it keeps what it has where that is larger: noise and solution may chase each
    other for ever.
    """
    updated = _noise_from_residuals(problem, state)
    if falling:
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


def reestimate_surface_sigma(
    problem: AdjustmentProblem, linearised: LinearisedProblem
) -> AdjustmentProblem:
    """Return the problem with surface sigmas estimated from the data where none were given."""
    if not problem.model.correlated or problem.model.surface is not None:
        return problem
    if not problem.own_offsets:
        return problem.with_surface_sigma(most_likely_surface_sigma(linearised))
    tilts, offsets = (most_likely_surface_sigma(linearised, some) for some in (TILTS, OFFSETS))
    return problem.with_surface_sigma(np.array([tilts, tilts, offsets]))


def have_sigmas_changed(one: AdjustmentProblem, other: AdjustmentProblem) -> bool:
    """Whether a sigma estimated from the data has changed enough to justify an iteration."""
    pairs = ((one.noise, other.noise), (one.scale, other.scale),
             (one.surface_sigma, other.surface_sigma))  # fmt: skip
    return any(bool((np.abs(a - b) > SIGMA_TOLERANCE * b).any()) for a, b in pairs)
