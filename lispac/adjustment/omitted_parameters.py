"""Whether the data contradict a value of the mounting that was not estimated.

A lever arm that is stated wrongly hides: the angles give way, and where they do not the surfaces
seem to differ from line to line, so that every test against sigmas from the data passes. Hence the
opposite question, a score test of each value that is held (Rao 1948): would the data rather have
another one? The surfaces' sigma is taken anew with the value let go of, for it has swallowed the
error.
"""

from dataclasses import replace
from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.adaptation import with_surface
from lispac.adjustment.components import SMALLEST_SURFACE
from lispac.adjustment.observability import unseen
from lispac.adjustment.parameters import SWITCHED, Parameter
from lispac.adjustment.problem import Linearised, Problem
from lispac.adjustment.result import Contradiction

Array = NDArray[np.float64]

FAMILY = 0.01
"""Chance that anything is called wrong where nothing is."""

CRITICAL = -NormalDist().inv_cdf(FAMILY / 2 / len(SWITCHED))
"""Test value beyond which a value is contradicted; one of many may be by chance (Bonferroni)."""

OF_CONSEQUENCE = 0.5
"""Sigmas by which an angle would move at least for an error that is worth telling."""

PLAIN = 6.0
"""Test value beyond which an error is told whatever it does: the sigmas have grown with it."""


def contradictions(
    linearised: Linearised, *, least: float = OF_CONSEQUENCE
) -> tuple[Contradiction, ...]:
    """Values that the data contradict, the most surprising first (correlated model).

    What the geometry does not see is left alone.

    Parameters
    ----------
    least : float
        Sigmas by which an angle would move at least.
    """
    problem = linearised.problem
    estimated = {parameter.name for parameter in problem.parameters}
    omitted = [Parameter(name) for name in SWITCHED if name not in estimated]
    if problem.observations.pose_rate is None:
        omitted = [parameter for parameter in omitted if parameter.name != "latency"]
    if not omitted:
        return ()
    every = problem.with_parameters((*problem.parameters, *omitted))
    all_let_go = every.linearised(linearised.state, linearised.loss)
    sigma_now = np.sqrt(np.diag(linearised.normal.covariance)[:3])
    found: list[Contradiction] = []
    gone, moved = problem.parameters, np.zeros(3)
    while True:  # what is let go of first may explain what the others seem to want
        tests = [
            test for each in omitted if (test := _test(all_let_go, gone, each, moved)) is not None
        ]
        worst = max(tests, key=lambda test: abs(test.w), default=None)
        if worst is None or abs(worst.w) <= CRITICAL:
            break
        if abs(worst.w) > PLAIN or (np.abs(worst.moved) >= least * sigma_now).any():
            found.append(worst)
        gone, moved = (*gone, Parameter(worst.name)), moved + worst.moved
        omitted = [each for each in omitted if each.name != worst.name]
    return tuple(found)


def _test(
    all_let_go: Linearised, gone: tuple[Parameter, ...], parameter: Parameter, before: Array
) -> Contradiction | None:
    """A value let go of besides those that are ``gone``; None where the geometry hides it.

    Parameters
    ----------
    before : ndarray of shape (3,), radians
        What letting go of the others has moved the angles by.
    """
    let_go = _only(all_let_go, (*gone, parameter))
    if any(hidden.name == parameter.name for hidden in unseen(let_go)):
        return None
    problem = let_go.problem
    # Where the surfaces' sigma is nothing already, it has swallowed nothing.
    if problem.layout.surfaces and not _nothing(problem):
        let_go = let_go.of(with_surface(problem, let_go))
    correction, _ = let_go.normal.solve()
    k = int(np.searchsorted(problem.active, parameter.index))
    sigma = float(np.sqrt(let_go.normal.covariance[k, k]))
    moved = correction[:3] - before
    surface = float(let_go.problem.usual_surface.max())
    return Contradiction(parameter.name, float(correction[k]), sigma, moved, surface)


def _nothing(problem: Problem) -> bool:
    return float(problem.usual_surface.max()) < 2 * SMALLEST_SURFACE


def _only(every: Linearised, parameters: tuple[Parameter, ...]) -> Linearised:
    """The equations with some of the parameters, from sums with all of them."""
    problem = every.problem.with_parameters(parameters)
    columns = np.arange(every.sums.shape[1])
    wanted = np.isin(every.problem.active, problem.active)
    kept = np.r_[columns[: len(wanted)][wanted], columns[len(wanted) :]]
    return replace(every, problem=problem, sums=every.sums[:, kept[:, None], kept])
