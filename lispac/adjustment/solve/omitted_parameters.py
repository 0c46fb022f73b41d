"""Tests of the given values of the mounting that are not estimated.

The effect of a wrong lever arm is absorbed by the angles and by the sigma of the form errors, so
that tests with sigmas estimated from the data do not detect it. Each fixed parameter is therefore
checked by a score test (Rao 1948). The sigma of the form errors is estimated again with the
parameter freed, because it may have absorbed the error.
"""

from dataclasses import replace
from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.parameters import OPTIONAL_NAMES, Parameter
from lispac.adjustment.result import ContradictedParameter
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.determinability import find_undetermined_parameters
from lispac.adjustment.solve.variance_components import MIN_SURFACE_SIGMA, reestimate_surface_sigma

Array = NDArray[np.float64]

FAMILY_WISE_LEVEL = 0.01
"""Family-wise probability of a false alarm."""

CRITICAL_VALUE = -NormalDist().inv_cdf(FAMILY_WISE_LEVEL / 2 / len(OPTIONAL_NAMES))
"""Test value beyond which a parameter is contradicted (Bonferroni)."""

MIN_ANGLE_CHANGE_SIGMAS = 0.5
"""Smallest change of an angle, in sigmas, for which a contradicted value is reported."""

ALWAYS_REPORTED_TEST_VALUE = 6.0
"""Test value above which a contradicted value is always reported.

Such an error has also increased the sigmas with which the change of the angles is compared.
"""


def find_contradicted_parameters(
    linearised: LinearisedProblem, *, min_angle_change: float = MIN_ANGLE_CHANGE_SIGMAS
) -> tuple[ContradictedParameter, ...]:
    """Find values that the data contradict, the most significant first (correlated model).

    Parameters that the geometry does not determine are not tested.

    Parameters
    ----------
    min_angle_change : float, no unit
        Smallest change of an angle over its sigma for which a value is reported.
    """
    problem = linearised.problem
    estimated = {parameter.name for parameter in problem.parameters}
    omitted = [Parameter(name) for name in OPTIONAL_NAMES if name not in estimated]
    if problem.observations.pose_rate is None:
        omitted = [parameter for parameter in omitted if parameter.name != "latency"]
    if not omitted:
        return ()
    every = problem.with_parameters((*problem.parameters, *omitted))
    all_freed = every.linearised(linearised.state, linearised.loss)
    sigma_now = np.sqrt(np.diag(linearised.normal.covariance)[:3])
    found: list[ContradictedParameter] = []
    others, moved = problem.parameters, np.zeros(3)
    while True:  # the parameter freed first may explain the contradictions of the others
        tests = [
            test
            for each in omitted
            if (test := _test_omitted_parameter(all_freed, others, each, moved)) is not None
        ]
        worst = max(tests, key=lambda test: abs(test.w), default=None)
        if worst is None or abs(worst.w) <= CRITICAL_VALUE:
            break
        if (
            abs(worst.w) > ALWAYS_REPORTED_TEST_VALUE
            or (np.abs(worst.angle_change) >= min_angle_change * sigma_now).any()
        ):
            found.append(worst)
        others, moved = (*others, Parameter(worst.name)), moved + worst.angle_change
        omitted = [each for each in omitted if each.name != worst.name]
    return tuple(found)


def _test_omitted_parameter(
    all_freed: LinearisedProblem, others: tuple[Parameter, ...], parameter: Parameter, before: Array
) -> ContradictedParameter | None:
    """Test one more value besides those in ``others``; None if it is undetermined.

    Parameters
    ----------
    before : ndarray of shape (3,), radians
        Change of the angles by the parameters freed before.
    """
    freed = _restrict_parameters(all_freed, (*others, parameter))
    if any(each.name == parameter.name for each in find_undetermined_parameters(freed)):
        return None
    problem = freed.problem
    # A sigma of the form errors of about zero has not absorbed an error.
    if problem.layout.surfaces and not _are_surfaces_exact(problem):
        freed = freed.of(reestimate_surface_sigma(problem, freed))
    correction, _ = freed.normal.solve()
    k = int(np.searchsorted(problem.active, parameter.index))
    sigma = float(np.sqrt(freed.normal.covariance[k, k]))
    moved = correction[:3] - before
    surface = float(freed.problem.default_surface_sigmas.max())
    return ContradictedParameter(parameter.name, float(correction[k]), sigma, moved, surface)


def _are_surfaces_exact(problem: AdjustmentProblem) -> bool:
    return float(problem.default_surface_sigmas.max()) < 2 * MIN_SURFACE_SIGMA


def _restrict_parameters(
    every: LinearisedProblem, parameters: tuple[Parameter, ...]
) -> LinearisedProblem:
    """Normal equations of some of the parameters, from sums with all of them."""
    problem = every.problem.with_parameters(parameters)
    columns = np.arange(every.sums.shape[1])
    is_kept = np.isin(every.problem.active, problem.active)
    kept = np.r_[columns[: len(is_kept)][is_kept], columns[len(is_kept) :]]
    return replace(every, problem=problem, sums=every.sums[:, kept[:, None], kept])
