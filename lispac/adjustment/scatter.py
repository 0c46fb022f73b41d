"""Whether parts of the data differ by more than the sigmas foresee, and sigmas that say so.

The stochastic model knows noise, POS errors and uneven surfaces. It does not know beams that are
calibrated unlike, times that are a little off within a turn of the scanner, or cloth and grass that
two lines see differently; what these do to neighbouring points they do to many of them at once. So
places of the scene are left out one after the other, and stretches of each line: the answers
scatter as much as the model foresees where it holds (the variance of a difference is the difference
of the variances, Hausman 1978), and by more where it does not. What is more is added, by the
jackknife (Tukey 1958).

A part is left out by taking its sums from Newton's equations at the solution: one solve a part.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.blas import one_thread
from lispac.adjustment.normal import inverse
from lispac.adjustment.problem import Linearised
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solved import Solved
from lispac.errors import AdjustmentError
from lispac.progress import Progress, no_progress

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

PLACES = 12
"""Parts of the scene along its greatest length, a surface each where there are no more."""
STRETCHES = 4
"""Parts of each line, of as many groups of points each."""
FEWEST = 3
"""Parts below which nothing is said of their scatter."""
LOOSE = 10.0
"""Metres and radians: sigma of a shape that no point may be left of."""


def with_scatter(
    result: AdjustmentResult, solved: Solved, *, progress: Progress = no_progress
) -> AdjustmentResult:
    """The result with the sigmas of its angles raised by what parts of the data tell."""
    more = unforeseen(solved, progress=progress)
    factors = np.ones(len(result.covariance_all))
    factors[:3] = np.sqrt(1.0 + more / np.diag(result.covariance))
    return replace(result, covariance_all=result.covariance_all * np.outer(factors, factors))


def unforeseen(solved: Solved, *, progress: Progress = no_progress) -> Array:
    """Variance of the angles that the model does not foresee, shape (3,), square radians."""
    here, more = solved.here, np.zeros(3)
    with one_thread():
        try:
            whole = _without(here, np.zeros(len(here.sums), dtype=bool))
        except (AdjustmentError, np.linalg.LinAlgError):
            return more  # without a whole to compare with, nothing is known
        for parts in _kinds(here, solved.origins):
            more += _beyond(here, whole, parts, progress)
    return more


def _kinds(here: Linearised, origins: Array) -> Iterator[list[Flags]]:
    """Groups of points to leave out: places of the scene, and stretches of each line."""
    problem = here.problem
    groups, observations = problem.groups, problem.observations
    assert groups.knots is not None
    target = observations.target_of_sighting[groups.sighting]
    along = np.linalg.svd(origins - origins.mean(axis=0), full_matrices=False)[2][0]
    places = np.array_split(np.argsort(origins @ along), min(PLACES, len(origins)))
    yield [np.isin(target, place) for place in places]
    names = np.array([observations.lines.index(each.line) for each in observations.sightings])
    line, time = names[groups.sighting], groups.knots.time[groups.knot]
    for k in range(len(observations.lines)):
        own = line == k
        ends = np.quantile(time[own], np.arange(1, STRETCHES) / STRETCHES)
        stretch = np.searchsorted(ends, time, side="right")
        yield [own & (stretch == part) for part in range(STRETCHES)]


def _beyond(
    here: Linearised, whole: tuple[Array, Array], parts: list[Flags], progress: Progress
) -> Array:
    """By how much parts scatter more than foreseen, shape (3,), square radians."""
    found = []
    for part in parts:
        progress(0.9, "Leaving out parts of the data")
        try:
            found.append(_without(here, part))
        except (AdjustmentError, np.linalg.LinAlgError):
            continue  # the answer hangs on this part: its sigma says so already
    if len(found) < FEWEST:
        return np.zeros(3)
    differences = np.array([answer - whole[0] for answer, _ in found])
    foreseen = np.array([np.maximum(variance - whole[1], 0.0) for _, variance in found])
    share = (len(found) - 1) / len(found)
    return np.asarray(share * np.maximum((differences**2 - foreseen).sum(axis=0), 0.0))


def _without(here: Linearised, part: Flags) -> tuple[Array, Array]:
    """Change of the angles without some groups of points, and their variances, (3,) each."""
    normal = here.without_groups(part).without_surfaces
    shapes = np.arange(len(normal.layout.active), len(normal.matrix))
    matrix = normal.matrix.copy()
    matrix[shapes, shapes] += LOOSE**-2
    normal = replace(normal, matrix=matrix)
    covariance = inverse(normal.reduced)
    return (covariance @ normal.reduced_right)[:3], np.diag(covariance)[:3].copy()
