"""Residuals and tests of the control (Baarda 1968, Teunissen 2000).

The misclosures of the conditions have the covariance ``W`` from the control and, after the
adjustment, the cofactor matrix ``W - A C A'``, where ``C`` is the covariance of the unknowns. A
point is tested with ``w = e' P m / sqrt(e' P Q P e)``, which is also correct if the points of a
source have a common error. A common translation of all points of a source is tested in the same
way, because a wrong datum or height reference displaces all of them.

A wrong point also displaces its neighbours from the surface. The most significant error is
therefore added to the model as an unknown, and the others are tested again, until no further one is
significant (data snooping; detection, identification and adaptation of Teunissen 2000).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
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


@dataclass(frozen=True, eq=False)
class _ErrorTest:
    """Test of one error: its size, the standard deviation, and the probability of a larger one.

    Attributes
    ----------
    size, sigma : ndarray of shape (k,), metres
    p_value : float or None
        None if nothing checks the error.
    determined : ndarray of shape (k,), bool
    z : float
        Normal variate with about the same probability, which does not underflow for large errors
        (Wilson and Hilferty 1931).
    """

    size: Array
    sigma: Array
    p_value: float | None
    determined: NDArray[np.bool_]
    z: float


def assess_control(
    linearised: LinearisedProblem, sides: Array
) -> tuple[tuple[ControlResidual, ...], tuple[ControlTranslation, ...]]:
    """Compute residual, redundancy and test of each control point, and of the sources as a whole.

    Parameters
    ----------
    linearised : LinearisedProblem
        Equations at the solution.
    sides : ndarray of shape (targets,)
        Side of each target on which the vessel was, 1 or -1, as in `TargetResidual`.
    """
    equations = linearised.control
    if equations is None:
        return (), ()
    weighted, information = _weighted_residuals(equations, linearised.normal.covariance)
    redundancies = np.clip(np.diag(information @ equations.covariance), 0.0, 1.0)
    points = _point_designs(equations)
    rows = [equations.owner == k for k in range(len(points))]
    checked = [k for k, own in enumerate(rows) if redundancies[own].mean() > MIN_REDUNDANCY]
    sources = _source_designs(equations)
    designs: dict[int | str, Array] = {k: points[k] for k in checked} | sources
    tests, wrong = _identify_errors(weighted, information, designs)
    targets = linearised.problem.observations.targets
    residuals = []
    for k, own in enumerate(rows):
        side = float(sides[targets.index(equations.control.targets[k])])
        residuals.append(
            _point_residual(
                equations, k, own, redundancies, side,
                tests.get(k), contradicts=k in wrong,
            )
        )  # fmt: skip
    translations = []
    for source in sources:
        found = tests[source]
        if found.p_value is not None:
            translations.append(
                ControlTranslation(
                    source, found.size, found.sigma, found.p_value, contradicts=source in wrong
                )
            )
    return tuple(residuals), tuple(translations)


def _point_designs(equations: ControlEquations) -> list[Array]:
    """Effect of a shift of each point on the misclosures, shape (q, 1), or (q, 3) for a centre."""
    unit = np.eye(len(equations))
    return [unit[:, equations.owner == k] for k in range(len(equations.control))]


def _source_designs(equations: ControlEquations) -> dict[str, Array]:
    """Effect of a translation of each source with several points, shape (q, 3)."""
    sources = np.array(equations.control.sources)
    return {
        source: equations.by_position * (sources == source)[equations.owner][:, None]
        for source in dict.fromkeys(equations.control.sources)
        if (sources == source).sum() > 1  # else the test of the point itself
    }


def _point_residual(
    equations: ControlEquations,
    k: int,
    own: NDArray[np.bool_],
    redundancies: Array,
    side: float,
    test: _ErrorTest | None,
    *,
    contradicts: bool,
) -> ControlResidual:
    """Residual and test of point ``k``, whose equations are ``own``, shape (q,)."""
    is_centre = bool(equations.control.is_centre[k])
    misclosure = equations.misclosure[own]
    shift, spread, w = None, None, None
    if test is not None and test.p_value is not None:
        if is_centre:
            shift = float(np.linalg.norm(test.size))
            spread = float(np.sqrt(np.mean(test.sigma[test.determined] ** 2)))
            w = -NormalDist().inv_cdf(max(test.p_value / 2, 1e-300))
        else:
            shift, spread = side * float(test.size[0]), float(test.sigma[0])
            w = shift / spread
    return ControlResidual(
        name=equations.control.names[k],
        target=equations.control.targets[k],
        source=equations.control.sources[k],
        is_centre=is_centre,
        residual=float(np.linalg.norm(misclosure)) if is_centre else side * float(misclosure[0]),
        sigma=float(np.sqrt(np.diag(equations.covariance)[own].mean())),
        redundancy=float(redundancies[own].mean()),
        shift=shift,
        shift_sigma=spread,
        w=w,
        contradicts=contradicts,
    )


def _identify_errors(
    weighted: Array, information: Array, designs: Mapping[int | str, Array]
) -> tuple[dict[int | str, _ErrorTest], set[int | str]]:
    """Tests of all errors besides the significant ones, and the significant errors.

    Parameters
    ----------
    weighted : ndarray of shape (q,), per metre
    information : ndarray of shape (q, q), per square metre
    designs : mapping of int or str to ndarray of shape (q, k)
        Effects of the errors of points, by number, and of sources, by name.
    """
    wrong: set[int | str] = set()
    while True:
        tests = {
            name: _test_error(
                weighted, information, design, [designs[o] for o in designs if o in wrong - {name}]
            )
            for name, design in designs.items()
        }
        level = FAMILY_WISE_LEVEL / max(len(tests), 1)
        significant = {
            name: each.z
            for name, each in tests.items()
            if name not in wrong and each.p_value is not None and each.p_value < level
        }
        if not significant:
            return tests, wrong
        # Of a point and its source with the same significance, the source
        largest = max(significant.values())
        wrong.add([name for name, z in significant.items() if z >= largest * (1 - 1e-12)][-1])


def _test_error(
    weighted: Array, information: Array, design: Array, others: Sequence[Array]
) -> _ErrorTest:
    """Test of an error of the design (q, k), with ``others`` as further unknowns of the model."""
    right, matrix = design.T @ weighted, design.T @ information @ design
    if others:
        joint = np.concatenate(others, axis=1)
        inverse = np.linalg.pinv(
            joint.T @ information @ joint, rcond=MIN_REDUNDANCY, hermitian=True
        )
        common = design.T @ information @ joint @ inverse
        right = right - common @ (joint.T @ weighted)
        reduced = matrix - common @ (joint.T @ information @ design)
        if np.trace(reduced) < MIN_REDUNDANCY * np.trace(matrix):  # the others explain it wholly
            zero = np.zeros(len(right))
            return _ErrorTest(zero, zero + np.inf, None, zero > 0, 0.0)
        matrix = reduced
    return _test_shift(right, matrix)


def contradicting_control(
    residuals: tuple[ControlResidual, ...], translations: tuple[ControlTranslation, ...]
) -> tuple[tuple[ControlResidual, ...], tuple[ControlTranslation, ...]]:
    """Control points, the worst first, and translated sources that contradict the survey."""
    points = [each for each in residuals if each.contradicts]
    moved = tuple(each for each in translations if each.contradicts)
    return tuple(sorted(points, key=lambda each: -abs(each.w or 0.0))), moved


def _weighted_residuals(equations: ControlEquations, covariance: Array) -> tuple[Array, Array]:
    """``P m``, shape (q,), and its covariance ``P (W - A C A') P``, shape (q, q)."""
    precision, by_unknowns = equations.precision, equations.by_unknowns
    explained = precision @ by_unknowns
    information = precision - explained @ covariance @ explained.T
    return precision @ equations.misclosure, (information + information.T) / 2


def _test_shift(right: Array, information: Array) -> _ErrorTest:
    """Score test of a shift, in the directions that are determined.

    Components that are not determined are 0 with an infinite standard deviation.

    Parameters
    ----------
    right : ndarray of shape (k,), per metre
    information : ndarray of shape (k, k), per square metre
    """
    from scipy.special import chdtrc

    values, directions = np.linalg.eigh(information)
    used = values > MIN_REDUNDANCY * max(float(np.abs(values).max()), np.finfo(float).tiny)
    components = np.asarray(directions.T @ right)
    if not used.any():
        return _ErrorTest(np.zeros(len(right)), np.full(len(right), np.inf), None, used, 0.0)
    inverse = directions[:, used] / values[used]
    shift = inverse @ components[used]
    variance = (inverse * directions[:, used]).sum(axis=1)
    left_out = (directions[:, ~used] ** 2).sum(axis=1)
    determined = left_out < 0.5
    sigma = np.where(determined, np.sqrt(variance), np.inf)
    statistic, freedom = float((components[used] ** 2 / values[used]).sum()), int(used.sum())
    spread = 2.0 / (9.0 * freedom)
    z = ((statistic / freedom) ** (1 / 3) - (1.0 - spread)) / np.sqrt(spread)
    return _ErrorTest(
        np.where(determined, shift, 0.0), sigma, float(chdtrc(freedom, statistic)), determined,
        float(z),
    )  # fmt: skip
