"""Iterations of the adjustment until the remaining change is negligible.

They have three phases: a start with a loss that does not redescend, robust iterations in which
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


class Phase(Enum):
    """Phase of the iteration, by what is estimated again from the residuals."""

    START = "start"
    """Noise and form errors, with the loss for the first iterations."""
    ROBUST = "robust"
    """Noise and form errors, with the loss of the model."""
    REFINE = "refine"
    """Nothing: the sigmas are known."""

    @classmethod
    def first(cls, model: StochasticModel, *, noise_known: bool) -> "Phase":
        """Phase in which an iteration begins."""
        loss = Loss(model.loss)
        if noise_known or not (model.correlated or loss.name != "none"):
            return cls.REFINE
        return cls.ROBUST if loss.start == loss else cls.START


class Status(Enum):
    """How near an iteration is to the solution."""

    FAR = "far"
    """Noise, form errors and outliers cannot be separated yet."""
    NEAR = "near"
    CLOSE = "close"
    """Plain IRLS steps are enough."""
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
        Limits of the expected remaining change of the same.
    """

    status: Status
    iteration: int
    change: Array
    tolerance: Array

    @classmethod
    def before_iterations(cls) -> "Convergence":
        """Convergence where nothing is known yet."""
        return cls(Status.FAR, 0, np.zeros(2), np.array([ANGLE_TOLERANCE, OTHER_TOLERANCE]))

    def after(self, iteration: int, correction: Array, *, extrapolated: bool) -> "Convergence":
        """Convergence after the next iteration.

        Parameters
        ----------
        correction : ndarray of shape (u,), radians, metres, seconds
            Of all unknowns but the POS error; the angles come first.
        extrapolated : bool
            Whether the last change is predicted, not computed: an iteration over many points is
            costly.
        """
        change = np.array([np.abs(correction[:3]).max(), np.abs(correction[3:]).max()])
        limits = tolerance = np.array([ANGLE_TOLERANCE, OTHER_TOLERANCE])
        if iteration > STRICT_ITERATIONS:
            tolerance = RELAXATION * limits
        remaining = _remaining_change(change, self.change)
        status = Status.NEAR
        if change[0] > NEAR_SOLUTION:
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
            steps = MAX_GAUSS_NEWTON_STEPS + 1  # too far off for that
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
            if tangent:  # the sigmas come from the weights as they are
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
    """Problem with noise and form errors from the residuals, and the phase that follows."""
    if convergence.status is Status.FAR:  # all points are noisy
        falling = convergence.iteration <= EARLY_ITERATIONS
        return reestimate_noise(problem, state, falling=falling), phase
    adapted = reestimate_surface_sigma(reestimate_noise(problem, state), linearised)
    if phase is Phase.START:
        return adapted, Phase.ROBUST
    same = adaptations >= MAX_ADAPTATIONS or not have_sigmas_changed(problem, adapted)
    return adapted, Phase.REFINE if same else Phase.ROBUST


def _remaining_change(change: Array, last: Array) -> Array:
    """Remaining change, extrapolated from the ratio of the last two changes."""
    rate = np.divide(change, last, out=np.full_like(change, 0.5), where=change < 0.5 * last)
    return np.asarray(change * rate / (1 - rate))
