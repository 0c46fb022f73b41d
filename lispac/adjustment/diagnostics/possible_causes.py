"""Compare the errors that may cause residuals that contradict the model.

Each candidate is one kind of error in one place: a wrong value of the mounting, such as the
latency; the position, the boresight or the times of one line; the shift or the surface of one
sighting; or the surface of one target. It adds unknowns to the adjustment, with a
normal prior whose standard deviation is the typical size of such errors. The evidence for a
candidate is twice the logarithm of its Bayes factor against a model without errors (Kass and
Raftery 1995). The sigma of the form errors is set to its most likely value for each candidate.
Otherwise an error such as a wrong lever arm, which increases this sigma, would be hidden by it.

The unknowns of all candidates are eliminated together, so that the cost is that of a few solutions
of the normal equations.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from lispac.adjustment.model.parameters import OPTIONAL_NAMES, Parameter
from lispac.adjustment.result import PossibleCause
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.banded_cholesky import forward_substitution
from lispac.adjustment.solve.variance_components import MAX_SURFACE_SIGMA

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

PRIOR_ERROR_SIGMAS = {
    "lever_x": 0.1, "lever_y": 0.1, "lever_z": 0.1, "range_offset": 0.1,
    "scan_angle_offset": float(np.radians(0.5)), "latency": 0.02, "line_position": 0.2,
    "line_boresight": float(np.radians(1.0)), "line_time": 0.2, "sighting_shift": 0.2,
    "sighting_surface": 0.2,
}  # fmt: skip
"""Typical size of each kind of error, metres, radians or seconds.

The evidence changes only with its logarithm.
"""
TARGET_FORM_SIGMAS = (0.01, 0.03, 0.1)
"""Trial sigmas of the differences between sightings of a target that is not flat, metres."""
STRONG_EVIDENCE = 6.0
"""Difference of evidence from which a candidate is clearly better than another.

A Bayes factor of 20, "strong" evidence according to Kass and Raftery (1995).
"""
VERY_STRONG_EVIDENCE = 10.0
"""Smallest evidence for an error: a Bayes factor of 150, "very strong" evidence."""
MIN_RMS_EFFECT = 1.5e-4
"""Smallest RMS effect of an error on the points not explained by other unknowns, metres.

Even a good board is bent by more than this within a sighting, which is not modelled.
"""
MAX_CAUSES = 3
"""Largest number of errors that are searched for, one after the other."""
MAX_CANDIDATES = 4
"""Largest number of candidates named for one error."""
MIN_TRIED_SURFACE_SIGMA, TRIED_SIGMA_COUNT = 1e-4, 13
"""Smallest sigma of the form errors that is tried, metres, and number of sigmas that are tried.

The largest one is `MAX_SURFACE_SIGMA`.
"""
AXIS_COUNT = 3
"""Number of axes of a position, of angles of a boresight, and of components of a surface."""
LINE_UNKNOWNS = 2 * AXIS_COUNT
"""Number of unknowns of the position and of the boresight of a line."""


def find_possible_causes(linearised: LinearisedProblem) -> tuple[tuple[PossibleCause, ...], ...]:
    """Find the errors that may cause the residuals, the most likely first.

    Parameters
    ----------
    linearised : LinearisedProblem
        Equations of the correlated model at its solution. Rejected sightings are included, since an
        error of a sighting is one of the candidates.

    Returns
    -------
    tuple of tuple of PossibleCause
        One tuple for each error: the best candidate, followed by those that are not clearly worse.
        Empty if the residuals need no explanation.
    """
    problem = linearised.problem
    if not (problem.model.correlated and problem.layout.surfaces):
        return ()
    equations = _CandidateEquations.of(linearised)
    solutions = [equations.solve_without_errors(sigma) for sigma in _trial_surface_sigmas(problem)]
    found: list[tuple[PossibleCause, ...]] = []
    given: tuple[_ModelError, ...] = ()
    angle_change = np.zeros(AXIS_COUNT)
    while len(found) < MAX_CAUSES:
        without = _maximise_likelihood(solutions, given)[0]
        scored = [
            (evidence - without, solution, each)
            for each in equations.candidates
            if each.has_own_unknowns(given)
            for evidence, solution in [_maximise_likelihood(solutions, (*given, each))]
        ]
        scored.sort(key=lambda item: -item[0])
        if not scored or scored[0][0] < VERY_STRONG_EVIDENCE:
            break
        if scored[0][1].unexplained_effect((*given, scored[0][2])) < MIN_RMS_EFFECT:
            break
        fitting = _best_of_each_cause(
            item for item in scored if scored[0][0] - item[0] < STRONG_EVIDENCE
        )
        found.append(
            tuple(
                solution.cause((*given, each), evidence, angle_change)
                for evidence, solution, each in fitting[:MAX_CANDIDATES]
            )
        )
        given = (*given, scored[0][2])
        angle_change = scored[0][1].angles_with(given)
    return tuple(found)


def _best_of_each_cause(scored: Iterable["_ScoredCandidate"]) -> list["_ScoredCandidate"]:
    """Keep the best candidate of each kind and place, since a target has one for each sigma."""
    found: dict[tuple[str, str, str], _ScoredCandidate] = {}
    for item in scored:
        found.setdefault((item[2].kind, item[2].target, item[2].line), item)
    return list(found.values())


def _maximise_likelihood(
    solutions: Sequence["_ErrorFreeSolution"], errors: tuple["_ModelError", ...]
) -> tuple[float, "_ErrorFreeSolution"]:
    """Maximum of twice the log likelihood with some errors, and the solution that gives it."""
    if not errors:
        best = max(solutions, key=lambda each: each.base)
        return best.base, best
    columns, scale = _join_candidates(errors)
    blocks = np.ix_(columns, columns)
    # All solutions at once: single factorisations of small matrices take most of the time.
    factor = np.linalg.cholesky(
        np.stack([each.information[blocks] for each in solutions]) * np.outer(scale, scale)
        + np.eye(len(scale))
    )
    score = np.stack([each.score[columns] for each in solutions]) * scale
    half = np.linalg.solve(factor, score[:, :, None])[:, :, 0]
    gain = (half**2).sum(axis=1) - 2 * np.log(np.diagonal(factor, axis1=1, axis2=2)).sum(axis=1)
    values = np.array([each.base for each in solutions]) + gain
    place = int(np.argmax(values))
    shares = sum(2 * np.log(each.share) for each in errors)
    return float(values[place] + shares), solutions[place]


def _trial_surface_sigmas(problem: AdjustmentProblem) -> Iterator[Array]:
    """Trial sigmas of tilts and offsets, each of shape (3,), metres."""
    usual = problem.default_surface_sigmas
    if problem.model.surface is not None:
        yield usual
        return
    for sigma in np.geomspace(MIN_TRIED_SURFACE_SIGMA, MAX_SURFACE_SIGMA, TRIED_SIGMA_COUNT):
        yield np.full(AXIS_COUNT, sigma)
        if problem.has_own_offsets:
            yield np.array([*usual[:2], sigma])


@dataclass(frozen=True, eq=False)
class _ModelError:
    """A possible error of the data, and the columns of its unknowns in the joint equations."""

    kind: str
    target: str
    line: str
    columns: Indices
    share: float
    """Prior probability of this place; all places of a kind of error are equally likely."""
    sigma: float
    """Prior standard deviation of each unknown."""

    @property
    def scale(self) -> Array:
        """Prior standard deviations, shape (k,)."""
        return np.full(len(self.columns), self.sigma)

    def has_own_unknowns(self, others: Sequence["_ModelError"]) -> bool:
        """Whether the candidate shares no unknowns with the others."""
        return not any(np.isin(self.columns, other.columns).any() for other in others)


@dataclass(frozen=True, eq=False)
class _CandidateEquations:
    """Normal equations with all candidates, with POS errors eliminated, without surface priors.

    Attributes
    ----------
    matrix, right : ndarray of shape (n, n) and (n,)
    base : ndarray of shape (b,), int
        Unknowns of the model without errors; the surfaces come last.
    errors : ndarray of shape (c,), int
        Columns of the unknowns of the candidates. Those of sightings are the surface unknowns.
    departures : ndarray of shape (surfaces,), metres
        As in `LinearisedProblem`.
    effect : ndarray of shape (c, c)
        Quadratic form that gives the mean square effect on the misclosures.
    weight : float, 1 / metres^2
        Sum of the weights of all misclosures.
    """

    matrix: Array
    right: Array
    base: Indices
    errors: Indices
    departures: Array
    effect: Array
    weight: float
    candidates: tuple[_ModelError, ...]

    @classmethod
    def of(cls, linearised: LinearisedProblem) -> "_CandidateEquations":
        problem = linearised.problem
        omitted = _omitted_parameters(problem)
        every = problem.with_parameters((*problem.parameters, *omitted)).linearised(
            linearised.state, linearised.loss
        )
        layout = every.normal.layout
        surfaces = np.arange(layout.surfaces[0].start, layout.size)
        departures = every.departures.reshape(-1)
        precision = every.problem.surface_sigma.reshape(-1) ** -2.0
        matrix, right, mixed = _add_line_errors(every)
        matrix[surfaces, surfaces] -= precision
        right[surfaces] += departures * precision
        own = np.searchsorted(layout.active, [each.index for each in omitted]).astype(np.int64)
        base = np.setdiff1d(np.arange(layout.size), own)
        errors = np.concatenate([own, surfaces, np.arange(layout.size, len(matrix))])
        offset = len(layout.active) + 3  # its derivative is 1 or -1, so that weights are summed
        weight = float(every.sums[:, offset, offset].sum())
        effect = matrix[np.ix_(errors, errors)] / weight
        half = forward_substitution(every.normal.factor, mixed.T)
        matrix -= half.T @ half
        right -= half.T @ every.normal.whitened_pos_right
        candidates = tuple(_build_candidates(every.problem, [each.name for each in omitted]))
        return cls(
            (matrix + matrix.T) / 2, right, base, errors, departures, effect, weight, candidates
        )

    def solve_without_errors(self, sigma: Array) -> "_ErrorFreeSolution":
        """Solve the model without errors, with sigmas of tilts and offset, shape (3,), metres."""
        base, errors = self.base, self.errors
        precision = np.tile(sigma**-2.0, len(self.departures) // AXIS_COUNT)
        matrix = self.matrix[np.ix_(base, base)]
        right = self.right[base]
        surfaces = np.arange(len(base) - len(precision), len(base))
        matrix[surfaces, surfaces] += precision
        right[surfaces] -= self.departures * precision
        scale = 1 / np.sqrt(np.diag(matrix))
        factor = np.linalg.cholesky(matrix * np.outer(scale, scale))
        crossed = self.matrix[np.ix_(base, errors)] * scale[:, None]
        half = scipy.linalg.solve_triangular(
            factor, np.column_stack([crossed, right * scale]), lower=True
        )
        by_errors, own = half[:, :-1], half[:, -1]
        angles = np.zeros((len(base), AXIS_COUNT))
        angles[:AXIS_COUNT] = np.diag(scale[:AXIS_COUNT])
        back = scipy.linalg.solve_triangular(factor, angles, lower=True)
        likelihood = float(
            own @ own
            - 2 * np.log(np.diag(factor) / scale).sum()
            + np.log(precision).sum()
            - self.departures**2 @ precision
        )
        return _ErrorFreeSolution(
            self.matrix[np.ix_(errors, errors)] - by_errors.T @ by_errors,
            self.right[errors] - by_errors.T @ own,
            likelihood,
            back.T @ own,
            back.T @ by_errors,
            self.effect,
            self.weight,
        )


@dataclass(frozen=True, eq=False)
class _ErrorFreeSolution:
    """Solution without errors for one sigma of the form errors, with scores of the candidates.

    Attributes
    ----------
    information, score : ndarray of shape (c, c) and (c,)
        Normal matrix and right-hand side of the unknowns of the candidates, with all other unknowns
        eliminated.
    base : float
        Twice the log likelihood without errors, up to a constant.
    angles : ndarray of shape (3,), radians
        Correction of roll, pitch, yaw without errors.
    by_errors : ndarray of shape (3, c)
        Decrease of this correction per unit of each unknown of the candidates.
    effect : ndarray of shape (c, c)
        As in `_CandidateEquations`.
    weight : float, 1 / metres^2
        As in `_CandidateEquations`.
    """

    information: Array
    score: Array
    base: float
    angles: Array
    by_errors: Array
    effect: Array
    weight: float

    def unexplained_effect(self, errors: tuple[_ModelError, ...]) -> float:
        """RMS effect of the last error that the other errors do not explain, metres."""
        columns, size, _ = self._sizes(errors)
        last = errors[-1].columns
        own = size[len(columns) - len(last) :]
        return float(np.sqrt(own @ self.information[np.ix_(last, last)] @ own / self.weight))

    def angles_with(self, errors: tuple[_ModelError, ...]) -> Array:
        """Correction of roll, pitch, yaw with some errors, shape (3,), radians."""
        columns, size, _ = self._sizes(errors)
        return self.angles - self.by_errors[:, columns] @ size

    def cause(
        self, errors: tuple[_ModelError, ...], evidence: float, before: Array
    ) -> PossibleCause:
        """Describe the last of some errors, with its size estimated together with the others.

        Parameters
        ----------
        before : ndarray of shape (3,), radians
            Correction of roll, pitch, yaw with only the other errors.
        """
        columns, size, covariance = self._sizes(errors)
        last = errors[-1]
        own = slice(len(columns) - len(last.columns), None)
        effect = size[own] @ self.effect[np.ix_(last.columns, last.columns)] @ size[own]
        return PossibleCause(
            last.kind,
            last.target,
            last.line,
            size[own],
            np.sqrt(np.diag(covariance)[own]),
            self.angles_with(errors) - before,
            float(np.sqrt(effect)),
            evidence,
        )

    def _sizes(self, errors: tuple[_ModelError, ...]) -> tuple[Indices, Array, Array]:
        """Columns of some errors, their most likely sizes (k,) and their covariance (k, k)."""
        columns, scale = _join_candidates(errors)
        precision, score = self._posterior(columns, scale)
        covariance = np.linalg.inv(precision) * np.outer(scale, scale)
        return columns, covariance @ (score / scale), covariance

    def _posterior(self, columns: Indices, scale: Array) -> tuple[Array, Array]:
        """Precision and score of unknowns in units of their prior standard deviations."""
        information = self.information[np.ix_(columns, columns)] * np.outer(scale, scale)
        return information + np.eye(len(columns)), self.score[columns] * scale


def _join_candidates(errors: tuple[_ModelError, ...]) -> tuple[Indices, Array]:
    columns = np.concatenate([each.columns for each in errors])
    return columns, np.concatenate([each.scale for each in errors])


def _omitted_parameters(problem: AdjustmentProblem) -> list[Parameter]:
    """Values of the mounting that are not estimated; the latency only if it can be."""
    estimated = {parameter.name for parameter in problem.parameters}
    return [
        Parameter(name)
        for name in OPTIONAL_NAMES
        if name not in estimated
        and not (name == "latency" and problem.observations.pose_rate is None)
    ]


def _build_candidates(problem: AdjustmentProblem, omitted: Sequence[str]) -> Iterator[_ModelError]:
    """Build all candidates; columns in the order of `_CandidateEquations.errors`."""
    observations = problem.observations

    def candidate(kind: str, target: str, line: str, columns: Indices, share: float) -> _ModelError:
        return _ModelError(kind, target, line, columns, share, PRIOR_ERROR_SIGMAS[kind])

    for k, name in enumerate(omitted):
        yield candidate(name, "", "", np.array([k]), 1.0)
    first, count = len(omitted), len(observations.sightings)
    spheres = observations.is_sphere[observations.target_of_sighting]
    of_target: dict[str, list[Indices]] = {}
    for s, sighting in enumerate(observations.sightings):
        own = first + AXIS_COUNT * s + np.arange(AXIS_COUNT)
        where = sighting.target, sighting.line
        of_target.setdefault(sighting.target, []).append(own[2:] if spheres[s] else own)
        yield candidate("sighting_shift", *where, own[2:], 1 / count)
        if not spheres[s]:
            yield candidate("sighting_surface", *where, own, 1 / count)
    for target, parts in of_target.items():
        share = 1 / (len(of_target) * len(TARGET_FORM_SIGMAS))
        for sigma in TARGET_FORM_SIGMAS:
            yield _ModelError("target_surface", target, "", np.concatenate(parts), share, sigma)
    first, count = first + AXIS_COUNT * count, len(observations.lines)
    has_times = observations.pose_rate is not None
    for k, line in enumerate(observations.lines):
        own = first + (LINE_UNKNOWNS + has_times) * k + np.arange(LINE_UNKNOWNS + has_times)
        yield candidate("line_position", "", line, own[:AXIS_COUNT], 1 / count)
        yield candidate("line_boresight", "", line, own[AXIS_COUNT:LINE_UNKNOWNS], 1 / count)
        if has_times:
            yield candidate("line_time", "", line, own[LINE_UNKNOWNS:], 1 / count)


def _add_line_errors(linearised: LinearisedProblem) -> tuple[Array, Array, Array]:
    """Normal equations with position, boresight and, if observable, latency of each line added.

    Returns
    -------
    matrix, right : ndarray of shape (u + k lines, u + k lines) and (u + k lines,)
        Equations with ``k`` more unknowns per line, 6 or 7.
    mixed : ndarray of shape (u + k lines, 6 knots)
        Block of the normal matrix between these unknowns and the POS error.
    """
    problem, normal, sums = linearised.problem, linearised.normal, linearised.sums
    observations, groups, layout = problem.observations, problem.groups, normal.layout
    own, lines = len(layout.active) + 4, observations.lines
    of_sighting = np.array([lines.index(each.line) for each in observations.sightings])
    latency = np.flatnonzero(layout.active == Parameter("latency").index)
    unknowns = LINE_UNKNOWNS + len(latency)
    size = np.zeros((sums.shape[1], unknowns))
    size[latency, LINE_UNKNOWNS:] = 1.0
    # The same shift of the POS position at the knots before and after
    size[own : own + AXIS_COUNT, :AXIS_COUNT] = size[
        own + 6 : own + 6 + AXIS_COUNT, :AXIS_COUNT
    ] = np.eye(AXIS_COUNT)
    size[:AXIS_COUNT, AXIS_COUNT:LINE_UNKNOWNS] = np.eye(AXIS_COUNT)
    products = np.einsum("wc,gwv->gcv", size, sums)
    basis = linearised.directions
    added = layout.size + unknowns * len(lines)
    matrix, right = np.zeros((added + 1, added + 1)), np.zeros(added)
    mixed = np.zeros((added, linearised.state.pos_corrections.size))
    matrix[: layout.size, : layout.size], right[: layout.size] = normal.matrix, normal.right
    mixed[: layout.size] = normal.mixed
    index = np.where(layout.index == layout.size, added, layout.index)
    for g, (sighting, knot) in enumerate(zip(groups.sighting, groups.knot, strict=True)):
        first = layout.size + unknowns * of_sighting[sighting]
        place = slice(first, first + unknowns)
        crossed = products[g, :, :own] @ basis[sighting]
        matrix[place, index[sighting]] += crossed
        matrix[index[sighting], place] += crossed.T
        matrix[place, place] += products[g] @ size
        mixed[place, 6 * knot : 6 * knot + 12] += products[g, :, own : own + 12]
        right[place] -= products[g, :, -1]
    return matrix[:-1, :-1], right, mixed


_ScoredCandidate = tuple[float, _ErrorFreeSolution, _ModelError]
"""Evidence for a candidate, and the solution and candidate."""
