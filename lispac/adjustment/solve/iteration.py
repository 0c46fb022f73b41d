"""Iterations of the adjustment until the remaining change is negligible.

There are three phases: a start with a loss that is not redescending, robust iterations in which
noise and form errors are estimated from the residuals, and a refinement in which these are fixed.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.robust_loss import Loss
from lispac.adjustment.model.stochastic_model import StochasticModel
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
"""Largest expected remaining change of an angle (rad) and of another unknown (rad, m, s)."""

MAX_NEAR_ANGLE_CHANGE = 1e-5
"""Change of an angle (rad) below which noise, form errors and outliers can be separated."""

STRICT_ITERATIONS, RELAXATION_FACTORS = 60, np.array([1e3, 1e5])
"""Number of iterations after which the limits are relaxed, and factors of this relaxation.

The relaxed limits are about 1e-6 deg for the angles, and 1 mm for other unknowns, such as those of
a sighting whose points alternate between a small weight and none.
"""

IRLS_TOLERANCE_RATIO = 100
"""Multiple of the limits below which IRLS steps are used, from which the sigmas are computed."""

MAX_GAUSS_NEWTON_STEPS = 10
"""Largest number of Gauss-Newton steps with updated weights, after which IRLS steps are used."""

EARLY_ITERATIONS = 10
"""Number of iterations far from the solution in which the estimated noise may decrease."""

MAX_ADAPTATIONS = 12
"""Largest number of times that noise and form errors are estimated again near the solution.

Otherwise the iteration could alternate between two values for ever.
"""


class Phase(Enum):
    """Phase of the iteration."""

    START = "start"
    """Noise and form errors are estimated again, with the loss for the first iterations."""
    ROBUST = "robust"
    """Noise and form errors are estimated again, with the loss of the model."""
    REFINE = "refine"
    """Noise and form errors are fixed."""

    @classmethod
    def first(cls, model: StochasticModel, *, noise_known: bool) -> "Phase":
        """Phase in which the iteration begins."""
        loss = Loss(model.loss)
        if noise_known or not (model.correlated or loss.name != "none"):
            return cls.REFINE
        return cls.ROBUST if loss.start == loss else cls.START


class Status(Enum):
    """Distance of an iteration from the solution."""

    FAR = "far"
    """Noise, form errors and outliers cannot be separated yet."""
    NEAR = "near"
    """Noise, form errors and outliers can be separated."""
    CLOSE = "close"
    """IRLS steps are sufficient."""
    CONVERGED = "converged"


@dataclass(frozen=True, eq=False)
class Convergence:
    """Convergence after an iteration.

    Attributes
    ----------
    status : Status
    iteration : int
    change : ndarray of shape (2,)
        Largest change of an angle (rad) and of another unknown (rad, m, s).
    tolerance : ndarray of shape (2,)
        Largest expected remaining change of the same unknowns for convergence.
    """

    status: Status
    iteration: int
    change: Array
    tolerance: Array

    @classmethod
    def before_iterations(cls) -> "Convergence":
        """Initial value before the first iteration."""
        return cls(Status.FAR, 0, np.zeros(2), np.array([ANGLE_TOLERANCE, OTHER_TOLERANCE]))

    def after(self, iteration: int, correction: Array, *, extrapolated: bool) -> "Convergence":
        """Convergence after the next iteration.

        Parameters
        ----------
        correction : ndarray of shape (u,), radians, metres, seconds
            Corrections of all unknowns except the POS error; the angles come first.
        extrapolated : bool
            Compare the predicted remaining change with the tolerance, instead of the change of this
            iteration. This saves an iteration over many points.
        """
        change = np.array([np.abs(correction[:3]).max(), np.abs(correction[3:]).max()])
        limits = tolerance = np.array([ANGLE_TOLERANCE, OTHER_TOLERANCE])
        if iteration > STRICT_ITERATIONS:
            tolerance = RELAXATION_FACTORS * limits
        remaining = _remaining_change(change, self.change)
        status = Status.NEAR
        if change[0] > MAX_NEAR_ANGLE_CHANGE:
            status = Status.FAR
        elif ((remaining if extrapolated else change) < tolerance).all():
            status = Status.CONVERGED
        elif (remaining < IRLS_TOLERANCE_RATIO * limits).all():
            status = Status.CLOSE
        return Convergence(status, iteration, change, tolerance)


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
        Roll, pitch, yaw after the iterations of an earlier call.
    noise_known : bool
        Whether the problem already contains the sigmas estimated from the data.

    Raises
    ------
    NotConverged
        The change is still above the tolerance after `MAX_ITERATIONS`.
    RankDeficient
        A parameter is not determined.
    LinAlgError
        The equations of a step cannot be solved.
    """
    final = Loss(problem.model.loss)
    phase = Phase.first(problem.model, noise_known=noise_known)
    if not noise_known:
        problem = with_noise_blocks(problem)
    convergence, adaptations, steps = Convergence.before_iterations(), 0, 0
    may_be_tangent, first_tangent = final.name != "none", 0 if noise_known else 1
    path = [] if earlier is None else list(earlier)
    for iteration in range(1, MAX_ITERATIONS + 1):
        label = gettext_lazy("Adjusting: iteration {number:n}", number=iteration)
        progress(iteration / MAX_ITERATIONS, label)
        # IRLS converges slowly unless the linearisation includes the change of the weights.
        tangent = may_be_tangent and first_tangent <= steps <= MAX_GAUSS_NEWTON_STEPS
        tangent = tangent and phase is Phase.REFINE and convergence.status is not Status.CLOSE
        loss = final.start if phase is Phase.START else final
        try:
            linearised = problem.linearised(state, loss, tangent=tangent)
            state, correction = linearised.next_state()
        except (RankDeficient, np.linalg.LinAlgError):
            if not tangent:
                raise
            steps = MAX_GAUSS_NEWTON_STEPS + 1  # too far from the solution for such steps
            continue
        path.append(state.mounting.boresight)
        convergence = convergence.after(iteration, correction, extrapolated=noise_known)
        is_near = convergence.status is not Status.FAR
        if phase is not Phase.REFINE:
            adaptations += is_near
            problem, phase = _adapt_sigmas(
                problem, phase, state, linearised, convergence, adaptations
            )
        elif convergence.status is Status.CONVERGED:
            if tangent:  # the sigmas are computed from the weights of an IRLS step
                linearised = problem.linearised(state, loss)
            return IterationResult(linearised, state, np.array(path))
        else:
            steps += is_near
    angles, rest = convergence.change.tolist()
    raise NotConverged(
        error("adjustment.not_converged", iterations=MAX_ITERATIONS, angles=angles, rest=rest)
    )


def _adapt_sigmas(
    problem: AdjustmentProblem,
    phase: Phase,
    state: AdjustmentState,
    linearised: LinearisedProblem,
    convergence: Convergence,
    adaptations: int,
) -> tuple[AdjustmentProblem, Phase]:
    """Estimate noise and form errors from the residuals; also return the next phase."""
    if convergence.status is Status.FAR:  # form errors cannot be separated from noise yet
        may_decrease = convergence.iteration <= EARLY_ITERATIONS
        return reestimate_noise(problem, state, may_decrease=may_decrease), phase
    adapted = reestimate_surface_sigma(reestimate_noise(problem, state), linearised)
    if phase is Phase.START:
        return adapted, Phase.ROBUST
    same = adaptations >= MAX_ADAPTATIONS or not have_sigmas_changed(problem, adapted)
    return adapted, Phase.REFINE if same else Phase.ROBUST


def _remaining_change(change: Array, last: Array) -> Array:
    """Remaining change, extrapolated from the ratio of the last two changes."""
    rate = np.divide(change, last, out=np.full_like(change, 0.5), where=change < 0.5 * last)
    return np.asarray(change * rate / (1 - rate))
