"""Test whether parts of the data scatter more than predicted; raise the sigmas if so.

The stochastic model knows noise, POS errors and uneven surfaces. It does not know beams that are
calibrated unlike, times that are a little off within a turn of the scanner, or cloth and grass that
two lines see differently; what these do to neighbouring points they do to many of them at once. So
places of the scene are omitted one after the other, and sections of each line: the results
scatter as much as the model predicts where it holds (the variance of a difference is the difference
of the variances, Hausman 1978), and by more where it does not. What is more is added, by the
jackknife (Tukey 1958).

There are few picked targets: whole lines and whole targets are omitted, and what is
more is added only where chance does not explain it.

A part is omitted by subtracting its sums from the normal equations: one solution for each part.
The weights follow each solution (Newton): if they were fixed, the results of parts would scatter
too little.
"""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.adjustment.solve.normal_equations import scaled_inverse
from lispac.errors import AdjustmentError
from lispac.language import gettext_lazy
from lispac.progress import Progress, no_progress

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

SCENE_PARTS = 12
"""Largest number of parts of the scene along its greatest length, of one surface at least."""
LINE_PARTS = 4
"""Parts of each line, of as many groups of points each."""
MIN_PARTS = 3
"""Smallest number of parts for an estimate of their scatter."""
TEST_LEVEL = 0.15
"""Significance level of the test that raises sigmas. Sigmas that an undetected effect leaves too
small are worse than some that are too large, so that a preliminary test of this kind has a level of
0.1 to 0.25 (Bancroft 1964)."""
MAX_LEVERAGE = 3.0
"""Largest variance of the difference without a part, over that of the whole, at which the result
without it says something of the whole; a part with more carries the angle alone."""
SIMULATED_SETS = 500
"""Simulated sets of differences for the expected excess; its standard error is a few percent."""
FREE_SHAPE_SIGMA = 10.0
"""Metres and radians: sigma of a shape that no point may be left of."""


def raise_sigmas_by_scatter(
    result: AdjustmentResult,
    here: LinearisedProblem,
    origins: Array,
    *,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Result with the sigmas of its angles raised by the scatter of parts of the scene.

    Parameters
    ----------
    here, origins : as in `lispac.adjustment.diagnostics.solved_equations.SolvedEquations`
    """
    added = excess_variance(here, origins, progress=progress)
    return with_raised_sigmas(result, np.sqrt(1.0 + added / np.diag(result.covariance)))


def with_raised_sigmas(result: AdjustmentResult, factors: Array) -> AdjustmentResult:
    """Result with the sigmas of its angles multiplied by factors (3,)."""
    whole = np.ones(len(result.covariance_all))
    whole[:3] = factors
    return replace(
        result,
        covariance_all=result.covariance_all * np.outer(whole, whole),
        angle_sigma_factors=factors
        if result.angle_sigma_factors is None
        else factors * result.angle_sigma_factors,
    )


def excess_variance(
    here: LinearisedProblem, origins: Array, *, progress: Progress = no_progress
) -> Array:
    """Variance of the angles that the model does not predict, shape (3,), square radians.

    Parameters
    ----------
    here, origins : as in `lispac.adjustment.diagnostics.solved_equations.SolvedEquations`
    """
    added, tangent = np.zeros(3), here.tangent
    with single_blas_thread():
        try:
            whole = _change_without_groups(tangent, np.zeros(len(here.sums), dtype=bool))
        except (AdjustmentError, np.linalg.LinAlgError):
            return added  # without a whole to compare with, nothing is known
        for parts in _place_and_stretch_groups(here, origins):
            differences, predicted = _leave_out_differences(tangent, whole, parts, progress)
            added += _variance_beyond_prediction(differences, predicted)
    return added


def leave_out_sigma_factors(here: LinearisedProblem) -> Array:
    """Factors on the sigmas of the angles from omitting lines and targets, (3,), no unit.

    Each is 1 where chance explains how the results without one line, or one target, scatter.

    Parameters
    ----------
    here : LinearisedProblem
        Of the correlated model, at its solution.
    """
    tangent = here.tangent
    with single_blas_thread():
        try:
            whole = _change_without_groups(tangent, np.zeros(len(here.sums), dtype=bool))
        except (AdjustmentError, np.linalg.LinAlgError):
            return np.ones(3)
        added = np.zeros(3)
        for parts in _line_and_target_groups(here):
            differences, predicted = _leave_out_differences(tangent, whole, parts, no_progress)
            checked = predicted <= MAX_LEVERAGE * whole[1]
            differences, predicted = differences * checked, predicted * checked
            enough = checked.sum(axis=0) >= MIN_PARTS
            added += (
                enough
                * _is_scatter_significant(differences, predicted)
                * _variance_beyond_prediction(differences, predicted)
            )
    return np.asarray(np.sqrt(1.0 + added / whole[1]))


def expected_sigma_factors(here: LinearisedProblem, omitted: Flags) -> Array:
    """Expected factors of `leave_out_sigma_factors` where the model holds, shape (3,), no unit.

    Chance raises the sigmas of some surveys, and the more the fewer parts there are. The expected
    excess variance is computed from normal deviates with the predicted variances.

    Parameters
    ----------
    here : LinearisedProblem
        As in `leave_out_sigma_factors`.
    omitted : ndarray of shape (groups,), bool
        Groups of points that do not take part.
    """
    chance = np.random.default_rng(0)
    added = np.zeros(3)
    with single_blas_thread():
        try:
            whole = _change_without_groups(here, omitted)
        except (AdjustmentError, np.linalg.LinAlgError):
            return np.ones(3)
        for parts in _line_and_target_groups(here):
            left = [part | omitted for part in parts if (part & ~omitted).any()]
            _, predicted = _leave_out_differences(here, whole, left, no_progress)
            checked = predicted <= MAX_LEVERAGE * whole[1]
            predicted = predicted * checked
            drawn = chance.normal(size=(SIMULATED_SETS, *predicted.shape)) * np.sqrt(predicted)
            excess = [
                _is_scatter_significant(each, predicted)
                * _variance_beyond_prediction(each, predicted)
                for each in drawn
            ]
            added += (checked.sum(axis=0) >= MIN_PARTS) * np.mean(excess, axis=0)
    return np.asarray(np.sqrt(1.0 + added / whole[1]))


def _line_and_target_groups(here: LinearisedProblem) -> Iterator[list[Flags]]:
    """Groups of points to omit: whole lines, and whole targets."""
    observations, sighting = here.problem.observations, here.problem.groups.sighting
    target = observations.target_of_sighting[sighting]
    line = np.array([observations.lines.index(s.line) for s in observations.sightings])[sighting]
    yield [line == k for k in range(len(observations.lines))]
    yield [target == k for k in range(len(observations.targets))]


def _is_scatter_significant(differences: Array, predicted: Array) -> NDArray[np.bool_]:
    """Whether the scatter of each angle is significant, shape (3,).

    The sum of the squares over that of the variances has about a chi-square distribution, with as
    the effective degrees of freedom of the parts (Satterthwaite 1946), minus one for their mean.
    The largest difference is tested by itself as well (Bonferroni): one line may be wrong alone.
    """
    from scipy.special import chdtri

    if len(differences) < MIN_PARTS:
        return np.zeros(3, dtype=bool)
    total = predicted.sum(axis=0)
    effective = total**2 / np.maximum((predicted**2).sum(axis=0), np.finfo(float).tiny)
    freedom = np.maximum(effective - 1.0, 1.0)
    together = (differences**2).sum(axis=0) > total * chdtri(freedom, TEST_LEVEL) / freedom
    largest = (differences**2 > predicted * chdtri(1.0, TEST_LEVEL / len(differences))).any(axis=0)
    return np.asarray(together | largest)


def _place_and_stretch_groups(here: LinearisedProblem, origins: Array) -> Iterator[list[Flags]]:
    """Groups of points to omit: places of the scene, and sections of each line."""
    problem = here.problem
    groups, observations = problem.groups, problem.observations
    assert groups.knots is not None
    target = observations.target_of_sighting[groups.sighting]
    along = np.linalg.svd(origins - origins.mean(axis=0), full_matrices=False)[2][0]
    places = np.array_split(np.argsort(origins @ along), min(SCENE_PARTS, len(origins)))
    yield [np.isin(target, place) for place in places]
    names = np.array([observations.lines.index(each.line) for each in observations.sightings])
    line, time = names[groups.sighting], groups.knots.time[groups.knot]
    for k in range(len(observations.lines)):
        own = line == k
        ends = np.quantile(time[own], np.arange(1, LINE_PARTS) / LINE_PARTS)
        stretch = np.searchsorted(ends, time, side="right")
        yield [own & (stretch == part) for part in range(LINE_PARTS)]


def _leave_out_differences(
    here: LinearisedProblem, whole: tuple[Array, Array], parts: list[Flags], progress: Progress
) -> tuple[Array, Array]:
    """Angles without a part less those of the whole, and their variances, (parts, 3) each.

    Excludes parts that the result depends on: its sigma includes this already.
    """
    found = []
    for part in parts:
        progress(0.9, gettext_lazy("Repeating the adjustment with subsets of the data"))
        with suppress(AdjustmentError, np.linalg.LinAlgError):
            found.append(_change_without_groups(here, part))
    differences = np.array([angles - whole[0] for angles, _ in found]).reshape(-1, 3)
    predicted = np.array([np.maximum(variance - whole[1], 0.0) for _, variance in found])
    return differences, predicted.reshape(-1, 3)


def _variance_beyond_prediction(differences: Array, predicted: Array) -> Array:
    """Variance of the parts beyond the prediction, shape (3,), square radians."""
    if len(differences) < MIN_PARTS:
        return np.zeros(3)
    share = (len(differences) - 1) / len(differences)
    return np.asarray(share * np.maximum((differences**2 - predicted).sum(axis=0), 0.0))


def sigmas_without(here: LinearisedProblem, sightings: Flags) -> Array | None:
    """Sigmas of the angles without some sightings, shape (3,), radians; None where there are none.

    Parameters
    ----------
    sightings : ndarray of shape (sightings,), bool
        Omitted parts.
    """
    try:
        return np.asarray(
            np.sqrt(_change_without_groups(here, sightings[here.problem.groups.sighting])[1])
        )
    except (AdjustmentError, np.linalg.LinAlgError):
        return None


def _change_without_groups(here: LinearisedProblem, part: Flags) -> tuple[Array, Array]:
    """Change of the angles without some groups of points, and their variances, (3,) each."""
    normal = here.normal_without_groups(part).eliminate_surfaces
    shapes = np.arange(len(normal.layout.active), len(normal.matrix))
    matrix = normal.matrix.copy()
    matrix[shapes, shapes] += FREE_SHAPE_SIGMA**-2
    normal = replace(normal, matrix=matrix)
    covariance = scaled_inverse(normal.reduced_matrix)
    return (covariance @ normal.reduced_right_side)[:3], np.diag(covariance)[:3].copy()
