"""Iterations of the adjustment until the remaining change is negligible."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.robust_loss import Loss
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.group_sums import AdjustmentState
from lispac.adjustment.solve.noise_estimation import (
    have_sigmas_changed,
    reestimate_noise,
    with_noise_blocks,
)
from lispac.adjustment.solve.variance_components import reestimate_surface_sigma
from lispac.errors import NotConverged, RankDeficient
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress

Array = NDArray[np.float64]

MAX_ITERATIONS = 200
ANGLE_TOLERANCE, OTHER_TOLERANCE = 1e-11, 1e-8
"""Limits of the expected remaining change: of an angle (rad), of another unknown (rad, m, s)."""

NEAR_SOLUTION = 1e-5
"""Change of an angle (rad) below which noise, form errors and outliers can be separated."""

STRICT_ITERATIONS, RELAXATION = 60, np.array([1e3, 1e5])
"""Iterations after which the limits are relaxed by these factors: to 1e-6 deg, and to 1 mm for a
sighting whose points alternate between a small weight and none."""

IRLS_TOLERANCE_RATIO = 100
"""Multiple of the limits below which plain IRLS steps are used; the sigmas come from these."""

MAX_GAUSS_NEWTON_STEPS = 10
"""Gauss-Newton steps with updated weights, after which plain IRLS steps are used."""

EARLY_ITERATIONS = 10
"""Iterations far from the solution in which the estimated noise may decrease."""

MAX_ADAPTATIONS = 12
"""Times that noise and surfaces are taken from the data; a limit between two of their values would
be crossed for ever."""


@dataclass(frozen=True, eq=False)
class IterationResult:
    """Solution at the last iteration.

    Attributes
    ----------
    path : ndarray of shape (iterations, 3), radians
        Roll, pitch, yaw after each iteration.
    """

    linearised: LinearisedProblem
    state: AdjustmentState
    path: Array


def iterate(
    problem: AdjustmentProblem,
    state: AdjustmentState,
    progress: Progress,
    earlier: Array | None = None,
    *,
    noise_known: bool = False,
) -> IterationResult:
    """Iterate until the remaining change is negligible.

    Parameters
    ----------
    earlier : ndarray of shape (iterations, 3), radians, optional
        Roll, pitch, yaw after the iterations before.
    noise_known : bool
        Whether the sigmas from the data are in the problem already.

    Raises
    ------
    NotConverged
        If the change is still above the tolerance after `MAX_ITERATIONS`.
    RankDeficient
        If a parameter is not determined.
    LinAlgError
        Where a step cannot be solved for.
    """
    final = Loss(problem.model.loss)
    if not noise_known:
        problem = with_noise_blocks(problem)
    loss = final if noise_known else final.start
    weighted = final.name != "none"
    loss_final = noise_known or not (problem.model.correlated or weighted)
    adaptations, steps, nearly = 0, 0, False
    limits = np.array([ANGLE_TOLERANCE, OTHER_TOLERANCE])
    last = np.zeros(2)
    path = [] if earlier is None else list(earlier)
    for iteration in range(1, MAX_ITERATIONS + 1):
        progress(
            iteration / MAX_ITERATIONS,
            gettext_lazy("Adjusting: iteration {number:n}", number=iteration),
        )
        # IRLS converges slowly unless the linearisation includes the change of the weights.
        gauss_newton = loss_final and weighted and not nearly and (noise_known or steps > 0)
        gauss_newton = gauss_newton and steps <= MAX_GAUSS_NEWTON_STEPS
        try:
            linearised = problem.linearised(state, loss, tangent=gauss_newton)
            state, correction = linearised.next_state()
        except (RankDeficient, np.linalg.LinAlgError):
            if not gauss_newton:
                raise
            steps = MAX_GAUSS_NEWTON_STEPS + 1  # too far off for that
            continue
        path.append(state.mounting.boresight)
        change = np.array([np.abs(correction[:3]).max(), np.abs(correction[3:]).max()])
        if change[0] > NEAR_SOLUTION:
            if not loss_final:  # far from the solution all points are noisy
                problem = reestimate_noise(problem, state, falling=iteration <= EARLY_ITERATIONS)
        elif not loss_final:
            adapted = reestimate_surface_sigma(reestimate_noise(problem, state), linearised)
            adaptations += 1
            same = adaptations >= MAX_ADAPTATIONS or not have_sigmas_changed(problem, adapted)
            loss_final = loss == final and same
            problem, loss = adapted, final
        else:
            steps += 1
            relaxation = np.array([1.0, 1.0]) if iteration <= STRICT_ITERATIONS else RELAXATION
            # An iteration over many points is costly: the last change is predicted, not computed.
            to_come = _remaining_change(change, last)
            left = to_come if noise_known else change
            nearly = bool((to_come < IRLS_TOLERANCE_RATIO * limits).all())
            if (left < relaxation * limits).all():
                if gauss_newton:  # the sigmas come from the weights as they are
                    linearised = problem.linearised(state, loss)
                return IterationResult(linearised, state, np.array(path))
        last = change
    raise NotConverged(
        error(
            "adjustment.not_converged",
            iterations=MAX_ITERATIONS,
            angles=float(change[0]),
            rest=float(change[1]),
        )
    )


def _remaining_change(change: Array, last: Array) -> Array:
    """Remaining change, extrapolated from the ratio of the last two changes."""
    rate = np.minimum(change / np.maximum(last, np.finfo(float).tiny), 0.5)
    return np.asarray(change * rate / (1 - rate))
