"""Effect of an error of the given lever arm on the estimated values.

The lever arm is measured with a standard deviation of its own. An error of it changes the angles,
even though the residuals stay small, because the angles absorb most of it at the distance of the
targets. If it is not estimated, its variance is propagated to the estimated values, which stay the
same (Schmidt 1966, "consider" parameters).
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.survey.georeferencing import LEVER_ARM_NAMES, MOUNTING_VALUE_NAMES

Array = NDArray[np.float64]


def with_lever_arm_effect(
    result: AdjustmentResult, linearised: LinearisedProblem
) -> AdjustmentResult:
    """Result with the effect of the lever arm, and its variance in those of the estimated values.

    Parameters
    ----------
    linearised : LinearisedProblem
        Equations at the solution.
    """
    known = replace(result, lever_arm_effect=lever_arm_effect(linearised, result.estimated))
    return replace(known, covariance_all=known.covariance_all + known.lever_arm_covariance)


def lever_arm_effect(linearised: LinearisedProblem, estimated: tuple[str, ...]) -> Array:
    """Change of the estimated values with the given lever arm.

    Parameters
    ----------
    estimated : tuple of str
        Names of the estimated values, from `MOUNTING_VALUE_NAMES`.

    Returns
    -------
    ndarray of shape (e, 3)
        Change per metre forward, left and up in the body frame, in radians, metres or seconds per
        metre; zero for a component that is estimated.
    """
    problem = linearised.problem
    solved = {MOUNTING_VALUE_NAMES[index] for index in problem.active}
    omitted = tuple(Parameter(name) for name in LEVER_ARM_NAMES if name not in solved)
    every = problem.with_parameters((*problem.parameters, *omitted))
    return effect_of_omitted(
        every.linearised(linearised.state, linearised.loss), problem.active, estimated
    )


def effect_of_omitted(
    every: LinearisedProblem, solved: NDArray[np.int64], estimated: tuple[str, ...]
) -> Array:
    """Change of the estimated values with the given lever arm, as `lever_arm_effect`.

    Parameters
    ----------
    every : LinearisedProblem
        Equations of the solved values and of the lever arm, at the solution.
    solved : ndarray of shape (n,), int
        Indices of the solved values in `MOUNTING_VALUE_NAMES`, increasing.
    """
    effect = np.zeros((len(estimated), len(LEVER_ARM_NAMES)))
    active = every.problem.active
    is_solved = np.isin(active, solved)
    if is_solved.all():
        return effect
    information = every.normal.information(len(active))
    change = -np.linalg.solve(
        information[np.ix_(is_solved, is_solved)], information[np.ix_(is_solved, ~is_solved)]
    )
    rows = np.searchsorted(solved, [MOUNTING_VALUE_NAMES.index(name) for name in estimated])
    names = [MOUNTING_VALUE_NAMES[index] for index in active[~is_solved]]
    effect[:, [LEVER_ARM_NAMES.index(name) for name in names]] = change[rows]
    return effect
