"""Test whether results without parts of the data scatter more than predicted, and raise the sigmas.

The stochastic model contains noise, POS errors and form errors. Other effects are not modelled:
different calibrations of the beams, small time errors within a revolution of the scanner, or fabric
and grass that look different in two lines. They affect many neighbouring points in the same way.

The angles are therefore computed again without one part of the data at a time. If the model is
correct, the variance of the difference from the whole result is the difference of the variances
(Hausman 1978). If the differences are larger, the excess variance is added to the variances of the
angles (jackknife, Tukey 1958).

- For natural planes, the parts are places of the scene and sections of each line.
- For picked targets, of which there are few, the parts are whole lines and whole targets. The
  excess is added only if it is significant. A part that determines an angle nearly alone has a
  difference with a large variance; the differences are then divided by their predicted sigmas.

A part is omitted by subtracting its sums from the normal equations, with one solution per part. The
equations include the change of the weights with the solution. With fixed weights, the results would
scatter too little.
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

MAX_SCENE_PARTS = 12
"""Largest number of parts of the scene along its greatest length; each has at least one surface."""
PARTS_PER_LINE = 4
"""Number of parts of each line, with similar numbers of groups of points."""
MIN_PARTS = 3
"""Smallest number of parts for an estimate of their scatter."""
TEST_LEVEL = 0.15
"""Significance level of the test that raises the sigmas.

Preliminary tests of this kind have levels of 0.1 to 0.25 (Bancroft 1964), because sigmas that are
too small are worse than sigmas that are too large.
"""
MAX_VARIANCE_RATIO = 3.0
"""Largest ratio of the variance of the difference without a part to the variance of the whole.

A part with a larger ratio determines the angle nearly alone. The result without it has a much
larger sigma, so that its difference, in radians, says little about the whole result.
"""
MIN_VARIANCE_RATIO = 1e-3
"""Smallest ratio, as above, of a part whose difference is divided by its predicted sigma."""
FREE_SHAPE_SIGMA = 10.0
"""Prior sigma of the shapes, metres and radians.

It keeps the equations regular if no point of a target remains.
"""


def raise_sigmas_by_scatter(
    result: AdjustmentResult,
    linearised: LinearisedProblem,
    origins: Array,
    *,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Result with the sigmas of its angles raised by the excess scatter of parts of the scene.

    Parameters
    ----------
    linearised, origins : as in `lispac.adjustment.diagnostics.solved_equations.SolvedEquations`
    """
    added = excess_variance(linearised, origins, progress=progress)
    variance = np.diag(result.with_exact_lever_arm.covariance)
    return with_raised_sigmas(result, np.sqrt(1.0 + added / variance))


def with_raised_sigmas(result: AdjustmentResult, factors: Array) -> AdjustmentResult:
    """Result with the sigmas of its angles multiplied by factors (3,)."""
    whole = np.ones(len(result.covariance_all))
    whole[:3] = factors
    by_lever_arm = result.lever_arm_covariance
    return replace(
        result,
        covariance_all=(result.covariance_all - by_lever_arm) * np.outer(whole, whole)
        + by_lever_arm,
        angle_sigma_factors=factors
        if result.angle_sigma_factors is None
        else factors * result.angle_sigma_factors,
    )


def excess_variance(
    linearised: LinearisedProblem, origins: Array, *, progress: Progress = no_progress
) -> Array:
    """Excess variance of the angles that the model does not predict, shape (3,), square radians.

    Parameters
    ----------
    linearised, origins : as in `lispac.adjustment.diagnostics.solved_equations.SolvedEquations`
    """
    added, tangent = np.zeros(3), linearised.tangent
    with single_blas_thread():
        try:
            whole = _change_without_groups(tangent, np.zeros(len(linearised.sums), dtype=bool))
        except (AdjustmentError, np.linalg.LinAlgError):
            return added  # there is no whole result to compare with
        for parts in _place_and_section_groups(linearised, origins):
            differences, predicted = _leave_out_differences(tangent, whole, parts, progress)
            added += _variance_beyond_prediction(differences, predicted)
    return added


def leave_out_sigma_factors(linearised: LinearisedProblem) -> Array:
    """Factors on the sigmas of the angles from omitting lines and targets, (3,), no unit.

    A factor is 1 if the scatter of the results without one line, or without one target, is not
    significantly larger than predicted.

    Parameters
    ----------
    linearised : LinearisedProblem
        Equations of the correlated model at its solution.
    """
    tangent = linearised.tangent
    with single_blas_thread():
        try:
            whole = _change_without_groups(tangent, np.zeros(len(linearised.sums), dtype=bool))
        except (AdjustmentError, np.linalg.LinAlgError):
            return np.ones(3)
        added = np.zeros(3)
        for parts in _line_and_target_groups(linearised):
            differences, predicted = _leave_out_differences(tangent, whole, parts, no_progress)
            added += _significant_excess(differences, predicted, whole[1])
    return np.asarray(np.sqrt(1.0 + added / whole[1]))


def _significant_excess(differences: Array, predicted: Array, variance: Array) -> Array:
    """Excess variance of the angles from parts of one kind, shape (3,), square radians.

    Parameters
    ----------
    differences, predicted : ndarray of shape (parts, 3)
        Differences without each part, and their predicted variances.
    variance : ndarray of shape (3,)
        Variances of the angles of the whole result.
    """
    checked = predicted <= MAX_VARIANCE_RATIO * variance
    own, expected = differences * checked, predicted * checked
    excess = (
        (checked.sum(axis=0) >= MIN_PARTS)
        * _is_scatter_significant(own, expected)
        * _variance_beyond_prediction(own, expected)
    )
    relative = np.zeros(3)
    for angle in np.flatnonzero(~checked.all(axis=0)):
        informative = predicted[:, angle] > MIN_VARIANCE_RATIO * variance[angle]
        ratios = differences[informative, angle] ** 2 / predicted[informative, angle]
        if _is_scatter_significant(np.sqrt(ratios)[:, None], np.ones((len(ratios), 1)))[0]:
            relative[angle] = max(float(ratios.mean()) - 1.0, 0.0)
    return np.maximum(excess, relative * variance)


def _line_and_target_groups(linearised: LinearisedProblem) -> Iterator[list[Flags]]:
    """Groups of points to omit: whole lines, and whole targets."""
    observations, sighting = linearised.problem.observations, linearised.problem.groups.sighting
    target = observations.target_of_sighting[sighting]
    line = np.array([observations.lines.index(s.line) for s in observations.sightings])[sighting]
    yield [line == k for k in range(len(observations.lines))]
    yield [target == k for k in range(len(observations.targets))]


def _is_scatter_significant(differences: Array, predicted: Array) -> NDArray[np.bool_]:
    """Whether the scatter in each column is significantly larger than predicted, shape (columns,).

    Differences and predicted variances have the shape (parts, columns).

    The ratio of the sum of squared differences to the sum of predicted variances, multiplied by the
    degrees of freedom, has approximately a chi-square distribution. The degrees of freedom are the
    effective number of parts (Satterthwaite 1946) minus one. The largest difference is also tested
    alone (Bonferroni), since a single line may be wrong.
    """
    from scipy.special import chdtri

    if len(differences) < MIN_PARTS:
        return np.zeros(differences.shape[1], dtype=bool)
    total = predicted.sum(axis=0)
    effective = total**2 / np.maximum((predicted**2).sum(axis=0), np.finfo(float).tiny)
    freedom = np.maximum(effective - 1.0, 1.0)
    together = (differences**2).sum(axis=0) > total * chdtri(freedom, TEST_LEVEL) / freedom
    largest = (differences**2 > predicted * chdtri(1.0, TEST_LEVEL / len(differences))).any(axis=0)
    return np.asarray(together | largest)


def _place_and_section_groups(
    linearised: LinearisedProblem, origins: Array
) -> Iterator[list[Flags]]:
    """Groups of points to omit: places of the scene, and sections of each line."""
    problem = linearised.problem
    groups, observations = problem.groups, problem.observations
    assert groups.knots is not None
    target = observations.target_of_sighting[groups.sighting]
    along = np.linalg.svd(origins - origins.mean(axis=0), full_matrices=False)[2][0]
    places = np.array_split(np.argsort(origins @ along), min(MAX_SCENE_PARTS, len(origins)))
    yield [np.isin(target, place) for place in places]
    names = np.array([observations.lines.index(each.line) for each in observations.sightings])
    line, time = names[groups.sighting], groups.knots.time[groups.knot]
    for k in range(len(observations.lines)):
        own = line == k
        ends = np.quantile(time[own], np.arange(1, PARTS_PER_LINE) / PARTS_PER_LINE)
        section = np.searchsorted(ends, time, side="right")
        yield [own & (section == part) for part in range(PARTS_PER_LINE)]


def _leave_out_differences(
    linearised: LinearisedProblem,
    whole: tuple[Array, Array],
    parts: list[Flags],
    progress: Progress,
) -> tuple[Array, Array]:
    """Angles without each part minus those of the whole, and predicted variances, (parts, 3) each.

    Parts without which there is no solution are omitted from both arrays.
    """
    found = []
    for part in parts:
        progress(0.9, gettext_lazy("Repeating the adjustment with subsets of the data"))
        with suppress(AdjustmentError, np.linalg.LinAlgError):
            found.append(_change_without_groups(linearised, part))
    differences = np.array([angles - whole[0] for angles, _ in found]).reshape(-1, 3)
    predicted = np.array([np.maximum(variance - whole[1], 0.0) for _, variance in found])
    return differences, predicted.reshape(-1, 3)


def _variance_beyond_prediction(differences: Array, predicted: Array) -> Array:
    """Jackknife variance in excess of the prediction, shape (3,), square radians; at least 0."""
    if len(differences) < MIN_PARTS:
        return np.zeros(3)
    share = (len(differences) - 1) / len(differences)
    return np.asarray(share * np.maximum((differences**2 - predicted).sum(axis=0), 0.0))


def sigmas_without(linearised: LinearisedProblem, sightings: Flags) -> Array | None:
    """Sigmas of the angles without some sightings, shape (3,), radians; None if undetermined.

    Parameters
    ----------
    sightings : ndarray of shape (sightings,), bool
        Sightings to omit.
    """
    try:
        return np.asarray(
            np.sqrt(
                _change_without_groups(linearised, sightings[linearised.problem.groups.sighting])[1]
            )
        )
    except (AdjustmentError, np.linalg.LinAlgError):
        return None


def _change_without_groups(linearised: LinearisedProblem, part: Flags) -> tuple[Array, Array]:
    """Change of the angles without some groups of points, and their variances, (3,) each."""
    normal = linearised.normal_without_groups(part).eliminate_surfaces
    shapes = np.arange(len(normal.layout.active), len(normal.matrix))
    matrix = normal.matrix.copy()
    matrix[shapes, shapes] += FREE_SHAPE_SIGMA**-2
    normal = replace(normal, matrix=matrix)
    covariance = scaled_inverse(normal.reduced_matrix)
    return (covariance @ normal.reduced_right_side)[:3], np.diag(covariance)[:3].copy()
