"""Choice of targets among the planes of a survey for precision and reliability.

An angle is checked if it remains determined without any single target, so that the other targets
reveal an error of that one (reliability: Baarda 1968). The targets are chosen one after the other
by the covariance that is predicted for each set from the adjustment of all planes.
"""

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.observability import MAX_CLUSTER_RATIO, MAX_SIGMA_RATIO
from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.errors import AdjustmentError
from lispac.messages import error

Array = NDArray[np.float64]

MAX_TARGETS, MIN_TARGETS, MIN_VALIDATION_PLANES = 6, 3, 4
"""Largest and smallest number of targets, and number of planes that are reserved for validation
once the targets check each other."""
MAX_SIGMA_RATIO_WITH_TARGET = 0.85
"""Largest ratio of a sigma with and without an additional target; if it is exceeded for every
angle, the plane is not added and remains for validation."""
MAX_PAIR_SIGMA_RATIO = 2.0
"""Factor on the smallest worst sigma of all pairs of planes, up to which a pair is preferred whose
planes are far apart, or are boards. The worst sigma is that of the least determined angle."""


@dataclass(frozen=True, eq=False)
class CandidatePlanes:
    """Candidate planes for targets, with their contribution to the precision.

    Attributes
    ----------
    linearised : LinearisedProblem
        Equations of all planes together with the form error of each plane, used for the choice,
        which is conservative.
    predicted : LinearisedProblem
        The same equations with the surface sigma from the adjustment of all planes, used for the
        predicted sigmas.
    centres : mapping of name to ndarray of shape (3,), metres, local frame
    whole : collection of str
        Planes that lie completely within the search radius, with the same outline in every line.
    parallel_pairs : collection of pairs of str
        Pairs of planes of the same orientation, which the adjustment would refuse.
    """

    linearised: LinearisedProblem
    predicted: LinearisedProblem
    centres: dict[str, Array]
    whole: Collection[str]
    parallel_pairs: Collection[tuple[str, str]]
    _sigmas: dict[frozenset[str], Array] = field(default_factory=dict)

    def sigma(self, names: Iterable[str]) -> Array:
        """Sigmas of roll, pitch, yaw from some of the planes, shape (3,), radians.

        Infinite if these planes do not determine the angles.
        """
        key = frozenset(names)
        if key not in self._sigmas:
            self._sigmas[key] = _sigma_of_targets(self.linearised, key)
        return self._sigmas[key]

    def predicted_sigma(self, names: Iterable[str]) -> Array:
        """Predicted sigmas of an adjustment of some of the planes, as in `sigma`.

        The adjustment may raise its sigmas if parts of the data scatter more than predicted; this
        is not predicted.
        """
        with single_blas_thread():
            return _sigma_of_targets(self.predicted, names)

    def largest_sigma_without_one_plane(self, names: Sequence[str]) -> Array:
        """Largest sigmas of roll, pitch, yaw without one of the planes, shape (3,), radians."""
        return np.max([self.sigma(set(names) - {name}) for name in names], axis=0)

    def are_mutually_checked(self, names: Sequence[str]) -> bool:
        """True if the other planes reveal an error of any one of the planes."""
        if len(names) < MIN_TARGETS or not self.are_spread(names):
            return False
        largest = self.largest_sigma_without_one_plane(names)
        return bool((largest <= MAX_SIGMA_RATIO * self.sigma(names)).all())

    def are_spread(self, names: Sequence[str]) -> bool:
        """True if no two of the planes are so close together that they act as one."""
        distances = [
            float(np.linalg.norm(self.centres[a] - self.centres[b]))
            for a, b in combinations(names, 2)
        ]
        points = self.linearised.problem.observations.points_lidar
        return min(distances) >= MAX_CLUSTER_RATIO * float(np.linalg.norm(points, axis=1).mean())


def _sigma_of_targets(linearised: LinearisedProblem, names: Iterable[str]) -> Array:
    kept = set(names)
    sightings = linearised.problem.observations.sightings
    removed = np.array([sighting.target not in kept for sighting in sightings])
    information = linearised.normal_without_sightings(removed).information(3)
    if np.linalg.eigvalsh(information)[0] <= 0.0:
        return np.full(3, np.inf)
    return np.asarray(np.sqrt(np.diag(np.linalg.inv(information))))


def choose_targets(planes: CandidatePlanes) -> list[str]:
    """Choose the planes to use as targets, in the order of the choice.

    The first two are the pair with the smallest worst sigma. Further planes are added until each
    angle is checked, then as long as a plane clearly improves an angle and enough planes remain for
    validation. A plane that is too close to a chosen one to be independent is not added.

    Raises
    ------
    AdjustmentError
        If no two planes determine the boresight.
    """
    names = list(planes.centres)
    with single_blas_thread():
        chosen = _best_pair(planes, names)
        boards = [name for name in names if name in planes.whole]
        # Boards are preferred if they determine the angles; walls are kept for validation.
        pool = boards if set(chosen) <= set(boards) else names
        while len(chosen) < min(MAX_TARGETS, len(names)):
            checked = planes.are_mutually_checked(chosen)
            spare = len(names) - MIN_VALIDATION_PLANES
            if checked and len(chosen) >= spare:
                break
            added = _best_addition(planes, chosen, pool, checked)
            if added is None and not checked and pool is boards:
                pool = names
                continue
            if added is None:
                break
            chosen.append(added)
    return chosen


def _best_pair(planes: CandidatePlanes, names: Sequence[str]) -> list[str]:
    """Pair of planes with the smallest worst sigma, that of the least determined angle.

    Pairs that are far apart, and among these pairs of boards, are preferred if their worst sigma is
    not more than `MAX_PAIR_SIGMA_RATIO` times the smallest.

    Raises
    ------
    AdjustmentError
        If all planes have the same orientation or no pair determines the angles.
    """
    worst = {
        pair: float(planes.sigma(pair).max())
        for pair in combinations(names, 2)
        if pair not in planes.parallel_pairs
    }
    if not worst:
        raise AdjustmentError(error("propose.one_orientation"))
    smallest = min(worst.values())
    if not np.isfinite(smallest):
        raise AdjustmentError(error("propose.not_determined"))
    preferences: tuple[Callable[[Sequence[str]], bool], ...] = (
        planes.are_spread, set(planes.whole).issuperset,
    )  # fmt: skip
    for is_preferred in preferences:
        preferred = {pair: sigma for pair, sigma in worst.items() if is_preferred(pair)}
        if preferred and min(preferred.values()) <= MAX_PAIR_SIGMA_RATIO * smallest:
            worst = preferred
    best = min(worst, key=worst.__getitem__)
    return list(best)


def _best_addition(
    planes: CandidatePlanes, chosen: Sequence[str], pool: Sequence[str], checked: bool
) -> str | None:
    """Plane that improves the chosen set most; None if no plane improves it enough."""
    others = [
        name
        for name in pool
        if name not in chosen and all(planes.are_spread((name, each)) for each in chosen)
    ]
    if not others:
        return None
    if not checked:
        return min(
            others,
            key=lambda name: (
                float(planes.largest_sigma_without_one_plane([*chosen, name]).max()),
                float(planes.sigma([*chosen, name]).max()),
            ),
        )
    sigma = planes.sigma(chosen)
    ratios = {name: float((planes.sigma([*chosen, name]) / sigma).min()) for name in others}
    best = min(ratios, key=ratios.__getitem__)
    return best if ratios[best] <= MAX_SIGMA_RATIO_WITH_TARGET else None
