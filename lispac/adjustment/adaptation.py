"""Noise and surfaces taken from the data between two iterations."""

from dataclasses import replace

import numpy as np

from lispac.adjustment.components import OFFSETS, TILTS, surface_sigma
from lispac.adjustment.noise import at_target, noise_factors, scale_of_targets
from lispac.adjustment.problem import Linearised, Problem
from lispac.adjustment.sums import State

SCALE_SETTLED = 0.01
"""Relative change of a sigma that is taken from the data."""


def with_noise(problem: Problem, state: State, *, falling: bool = True) -> Problem:
    """The same problem with the noise that its residuals show.

    Without ``falling`` it keeps what it has where that is larger: noise and answer may chase each
    other for ever.
    """
    told = _noise_of(problem, state)
    if falling:
        return told
    return replace(
        told,
        noise=np.maximum(told.noise, problem.noise),
        scale=np.maximum(told.scale, problem.scale),
    )


def _noise_of(problem: Problem, state: State) -> Problem:
    observations, residuals = problem.observations, problem.residuals(state)[1]
    near = None
    if problem.model.loss != "none":
        near = at_target(observations, residuals)
        problem = replace(problem, scale=scale_of_targets(observations, residuals, near))
    if not problem.model.correlated:
        return problem
    noise = noise_factors(observations, residuals, problem.blocks, near)
    return replace(problem, noise=noise)


def with_surface(problem: Problem, linearised: Linearised) -> Problem:
    """The same problem with the sigma of form errors estimated, unless it was given."""
    if not problem.model.correlated or problem.model.surface is not None:
        return problem
    if not problem.own_offsets:
        return problem.with_surface(surface_sigma(linearised))
    tilts, offsets = (surface_sigma(linearised, some) for some in (TILTS, OFFSETS))
    return problem.with_surface(np.array([tilts, tilts, offsets]))


def differ(one: Problem, other: Problem) -> bool:
    """Whether a sigma from the data differs by more than the tolerance."""
    pairs = ((one.noise, other.noise), (one.scale, other.scale),
             (one.surface_sigma, other.surface_sigma))  # fmt: skip
    return any(bool((np.abs(a - b) > SCALE_SETTLED * b).any()) for a, b in pairs)
