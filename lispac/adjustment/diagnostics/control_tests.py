"""Residuals and tests of the control (Baarda 1968, Teunissen 2000).

The misclosures of the conditions have the covariance ``W`` from the control and, after the
adjustment, the cofactor matrix ``W - A C A'``, where ``C`` is the covariance of the unknowns. A
point is tested with ``w = e' P m / sqrt(e' P Q P e)``, which is also correct if the points of a
source have a common error. A common translation of all points of a source is tested in the same
way, because a wrong datum or height reference displaces all of them.
"""

from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.result import ControlResidual, ControlTranslation
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.adjustment.solve.control_equations import ControlEquations

Array = NDArray[np.float64]

FAMILY_WISE_LEVEL = 0.01
"""Family-wise probability that correct control is reported as contradicting the survey."""

MIN_REDUNDANCY = 1e-6
"""Redundancy below which nothing checks a point; it has no test."""


def control_residuals(linearised: LinearisedProblem, sides: Array) -> tuple[ControlResidual, ...]:
    """Compute residual, redundancy and test of each control point.

    Parameters
    ----------
    linearised : LinearisedProblem
        Equations at the solution.
    sides : ndarray of shape (targets,)
        Side of each target on which the vessel was, 1 or -1, as in `TargetResidual`.
    """
    equations = linearised.control
    if equations is None:
        return ()
    weighted, information = _weighted_residuals(equations, linearised.normal.covariance)
    redundancies = np.diag(information @ equations.covariance)
    targets = linearised.problem.observations.targets
    found = []
    for k, name in enumerate(equations.control.names):
        own = np.flatnonzero(equations.owner == k)
        side = float(sides[targets.index(equations.control.targets[k])])
        mean_redundancy = float(np.clip(redundancies[own].mean(), 0.0, 1.0))
        shift, spread, w = None, None, None
        if mean_redundancy > MIN_REDUNDANCY:
            shift, spread, w = _test_blunder(weighted[own], information[np.ix_(own, own)])
        misclosure = equations.misclosure[own]
        is_centre = bool(equations.control.is_centre[k])
        found.append(
            ControlResidual(
                name=name,
                target=equations.control.targets[k],
                source=equations.control.sources[k],
                is_centre=is_centre,
                residual=float(np.linalg.norm(misclosure)) if is_centre
                else side * float(misclosure[0]),
                sigma=float(np.sqrt(np.diag(equations.covariance)[own].mean())),
                redundancy=mean_redundancy,
                shift=shift if shift is None or is_centre else side * shift,
                shift_sigma=spread,
                w=w if w is None or is_centre else side * w,
            )
        )  # fmt: skip
    return tuple(found)


def control_translations(linearised: LinearisedProblem) -> tuple[ControlTranslation, ...]:
    """Test a common translation of the control of each source with several points."""
    equations = linearised.control
    if equations is None:
        return ()
    weighted, information = _weighted_residuals(equations, linearised.normal.covariance)
    sources = np.array(equations.control.sources)
    found = []
    for source in dict.fromkeys(equations.control.sources):
        if (sources == source).sum() < 2:
            continue  # the test of the point itself
        design = equations.by_position * (sources == source)[equations.owner][:, None]
        shift, sigma, p_value, _ = _test_shift(design.T @ weighted, design.T @ information @ design)
        if p_value is not None:
            found.append(ControlTranslation(source, shift, sigma, p_value))
    return tuple(found)


def contradicting_control(
    residuals: tuple[ControlResidual, ...], translations: tuple[ControlTranslation, ...]
) -> tuple[tuple[ControlResidual, ...], tuple[ControlTranslation, ...]]:
    """Control points and translated sources that contradict the survey.

    If a translation is more significant than the worst point of its source, the source is reported
    instead of its points, which may all be correct relative to each other.
    """
    tests = len(residuals) + len(translations)
    if not tests:
        return (), ()
    level = FAMILY_WISE_LEVEL / tests
    points = [each for each in residuals if each.p_value is not None and each.p_value < level]
    smallest: dict[str, float] = {}
    for each in points:
        assert each.p_value is not None
        smallest[each.source] = min(smallest.get(each.source, 1.0), each.p_value)
    moved = tuple(
        each
        for each in translations
        if each.p_value < level and each.p_value <= smallest.get(each.source, 1.0)
    )
    sources = {each.source for each in moved}
    points = [each for each in points if each.source not in sources]
    return tuple(sorted(points, key=lambda each: -abs(each.w or 0.0))), moved


def _weighted_residuals(equations: ControlEquations, covariance: Array) -> tuple[Array, Array]:
    """``P m``, shape (q,), and its covariance ``P (W - A C A') P``, shape (q, q)."""
    precision, by_unknowns = equations.precision, equations.by_unknowns
    explained = precision @ by_unknowns
    information = precision - explained @ covariance @ explained.T
    return precision @ equations.misclosure, (information + information.T) / 2


def _test_blunder(
    right: Array, information: Array
) -> tuple[float | None, float | None, float | None]:
    """Size, its standard deviation, and test value of a blunder with one or three components."""
    shift, sigma, p_value, determined = _test_shift(right, information)
    if p_value is None:
        return None, None, None
    if len(right) == 1:
        return float(shift[0]), float(sigma[0]), float(shift[0] / sigma[0])
    size = float(np.linalg.norm(shift))
    spread = float(np.sqrt(np.mean(sigma[determined] ** 2)))
    return size, spread, -NormalDist().inv_cdf(max(p_value / 2, 1e-300))


def _test_shift(
    right: Array, information: Array
) -> tuple[Array, Array, float | None, NDArray[np.bool_]]:
    """Score test of a shift, in the directions that are determined.

    Parameters
    ----------
    right : ndarray of shape (k,), per metre
    information : ndarray of shape (k, k), per square metre

    Returns
    -------
    shift, sigma : ndarray of shape (k,), metres
        Zero shift and infinite sigma of components that are not determined.
    p_value : float or None
        None if no direction is determined.
    determined : ndarray of shape (k,), bool
    """
    from scipy.special import chdtrc

    values, directions = np.linalg.eigh(information)
    used = values > MIN_REDUNDANCY * max(float(np.abs(values).max()), np.finfo(float).tiny)
    components = np.asarray(directions.T @ right)
    if not used.any():
        return np.zeros(len(right)), np.full(len(right), np.inf), None, used
    inverse = directions[:, used] / values[used]
    shift = inverse @ components[used]
    variance = (inverse * directions[:, used]).sum(axis=1)
    left_out = (directions[:, ~used] ** 2).sum(axis=1)
    determined = left_out < 0.5
    sigma = np.where(determined, np.sqrt(variance), np.inf)
    statistic = float((components[used] ** 2 / values[used]).sum())
    return (
        np.where(determined, shift, 0.0), sigma, float(chdtrc(int(used.sum()), statistic)),
        determined,
    )  # fmt: skip
