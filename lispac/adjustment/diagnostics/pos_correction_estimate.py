"""Corrections of the POS from a solved adjustment."""

from lispac.adjustment.model.pos_corrections import PosCorrections
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem


def estimate_pos_corrections(linearised: LinearisedProblem) -> PosCorrections | None:
    """Corrections of the POS at the knots, with their covariance; None without common POS errors.

    The knots are in the time base of the points. With the estimated latency they are moved to that
    of the trajectory.

    Parameters
    ----------
    linearised : LinearisedProblem
        Linearised at the solution.
    """
    problem, state = linearised.problem, linearised.state
    knots, model = problem.groups.knots, problem.model
    if knots is None:
        return None
    own, beside = linearised.normal.pos_error_variances
    return PosCorrections(
        knots.time + state.mounting.latency,
        state.pos_corrections,
        own**0.5,
        knots.sigma,
        beside,
        model.position_time,
        model.attitude_time,
        model.knot_interval,
    )
