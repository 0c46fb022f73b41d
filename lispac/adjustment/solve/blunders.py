"""Detection of blunders: another surface in one line, a shifted sighting, a GNSS jump.

The null hypothesis that all sightings agree is tested against alternatives (Teunissen 2000): one
sighting is shifted as a whole, one sighting is on another surface, or the position is shifted in a
whole line. For the final test of an alternative, the sigma of the form errors is estimated without
the suspected sightings. Otherwise a blunder would increase this sigma and thereby hide itself.
"""

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.solve.adjustment_problem import (
    ALL_COMPONENTS,
    OFFSET_COMPONENT,
    AdjustmentProblem,
    LinearisedProblem,
)
from lispac.adjustment.solve.banded_cholesky import forward_substitution
from lispac.adjustment.solve.variance_components import reestimate_surface_sigma

Array = NDArray[np.float64]

FAMILY_WISE_LEVEL = 0.01
"""Family-wise probability of a false rejection."""

CANDIDATE_LEVEL = 0.05
"""Significance level of a first test, which selects candidates for the second test.

In the second test, the form errors are estimated without the candidate.
"""

MAX_CANDIDATES = 6
"""Largest number of candidates in the second test; the most significant ones are used."""

RESTORATION_LEVEL = 0.05
"""P-value above which a rejected sighting is restored."""

CONFIRMATION_LEVEL = 1e-6
"""P-value below which sightings that were excluded from the start remain rejected."""

MIN_OTHER_SIGHTINGS = 2
"""Smallest number of other sightings of the target of a rejected sighting."""

OTHER_SURFACE_P_VALUE_RATIO = 100.0
"""Ratio of p-values above which another surface is preferred to a shift."""


@dataclass(frozen=True)
class Blunder:
    """A possible blunder: kind of error and sightings affected.

    Attributes
    ----------
    kind : {"shift", "surface", "line"}
        A sighting shifted along the normal of its target; a sighting on another surface; or a shift
        of the position in all sightings of a line.
    sightings : tuple of int
        Indices of the sightings.
    """

    kind: Literal["shift", "surface", "line"]
    sightings: tuple[int, ...]

    def reject_in(self, problem: AdjustmentProblem) -> AdjustmentProblem:
        """Return the problem with these sightings rejected."""
        return problem.with_rejected(self.sightings, self._directions)

    def restore_in(self, problem: AdjustmentProblem) -> AdjustmentProblem:
        """Return the problem with these sightings restored."""
        return problem.with_restored(self.sightings, self._directions)

    @property
    def _directions(self) -> slice:
        return ALL_COMPONENTS if self.kind == "surface" else OFFSET_COMPONENT


def worst_blunder(linearised: LinearisedProblem, untested: Collection[Blunder]) -> Blunder | None:
    """Find the most significant blunder; None if all sightings agree.

    Parameters
    ----------
    untested : collection of Blunder
        Blunders that have already been restored, and are not tested again.
    """
    tested = [
        blunder for blunder in _candidate_blunders(linearised.problem) if blunder not in untested
    ]
    first = [(_score_test_p_value(linearised, blunder), blunder) for blunder in tested]
    candidates = [item for item in first if item[0] < CANDIDATE_LEVEL]
    candidates.sort(key=_weighted_p_value)
    again = [
        (_weighted_p_value((p_value, blunder)), k, blunder)
        for k, (_, blunder) in enumerate(candidates[:MAX_CANDIDATES])
        for p_value in [
            _score_test_p_value(_surfaces_from_other_sightings(linearised, blunder), blunder)
        ]
        if p_value < FAMILY_WISE_LEVEL / len(tested)
    ]
    return min(again)[-1] if again else None


def _weighted_p_value(item: tuple[float, Blunder]) -> float:
    p_value, blunder = item
    return p_value * (OTHER_SURFACE_P_VALUE_RATIO if blunder.kind == "surface" else 1.0)


def find_restorable_blunder(
    linearised: LinearisedProblem, rejected: Collection[Blunder]
) -> Blunder | None:
    """Find the rejected blunder that agrees best, if it agrees well enough to be restored."""
    p_values = [(_p_value_if_restored(linearised, blunder), blunder) for blunder in rejected]
    p_value, best = max(p_values, key=lambda item: item[0], default=(0.0, None))
    return best if p_value > RESTORATION_LEVEL else None


def find_confirmed_blunders(
    linearised: LinearisedProblem, rejected: Collection[Blunder]
) -> list[Blunder]:
    """Find the blunders excluded from the start that remain rejected.

    A blunder of kind "surface" is reduced to a shift if a shift is enough to explain it.
    """
    return [
        _reduce_to_shift(linearised, blunder)
        for blunder in rejected
        if _p_value_if_restored(linearised, blunder) < CONFIRMATION_LEVEL
    ]


def _p_value_if_restored(linearised: LinearisedProblem, blunder: Blunder) -> float:
    # A sighting whose points all have zero weight agrees with nothing.
    if not _blunder_equations(linearised, blunder)[0].any():
        return 0.0
    return _score_test_p_value(linearised.of(blunder.restore_in(linearised.problem)), blunder)


def _reduce_to_shift(linearised: LinearisedProblem, blunder: Blunder) -> Blunder:
    """Reduce a blunder to a shift if the tilts of its sighting agree with the others."""
    if blunder.kind != "surface":
        return blunder
    shift = Blunder("shift", blunder.sightings)
    without_shift = linearised.of(shift.reject_in(blunder.restore_in(linearised.problem)))
    return shift if _score_test_p_value(without_shift, blunder) > FAMILY_WISE_LEVEL else blunder


def _candidate_blunders(problem: AdjustmentProblem) -> Iterator[Blunder]:
    """Sightings and lines whose rejection leaves enough other sightings of every target."""
    observations, is_used = problem.observations, ~problem.rejected_sightings
    owners = observations.target_of_sighting
    counts = np.bincount(owners[is_used], minlength=len(observations.targets))
    spare = is_used & (counts[owners] > MIN_OTHER_SIGHTINGS)
    for s in np.flatnonzero(spare):
        yield Blunder("shift", (int(s),))
        if not observations.is_sphere[owners[s]]:
            yield Blunder("surface", (int(s),))
    for line in observations.lines:
        own = [s for s, x in enumerate(observations.sightings) if x.line == line and is_used[s]]
        # For a line with a single sighting, the shift of the sighting is tested instead.
        if len(own) > 1 and spare[own].all():
            yield Blunder("line", tuple(own))


def _surfaces_from_other_sightings(
    linearised: LinearisedProblem, blunder: Blunder
) -> LinearisedProblem:
    """Linearised problem with the surface sigma estimated from all other sightings."""
    problem = linearised.problem
    return linearised.of(
        reestimate_surface_sigma(problem, linearised.of(blunder.reject_in(problem)))
    )


def _score_test_p_value(linearised: LinearisedProblem, blunder: Blunder) -> float:
    """P-value of a blunder by a score test of its unknowns (Rao 1948)."""
    from scipy.special import chdtrc

    normal = linearised.normal
    own, by_unknowns, by_pos, right = _blunder_equations(linearised, blunder)
    half = forward_substitution(normal.factor, by_pos.T)
    mixed = by_unknowns - half.T @ normal.whitened_mixed
    information = own - half.T @ half - mixed @ normal.covariance @ mixed.T
    correction, change = normal.solve()
    right_side = right - by_unknowns @ correction - by_pos @ change.reshape(-1)
    # Directions without information, such as a shift along the boards, cannot be tested.
    values, directions = np.linalg.eigh(information)
    is_determined = values > MIN_INFORMATION_SHARE * np.diag(own).max()
    if not is_determined.any():
        return 1.0
    statistic = float(
        (((directions.T @ right_side) ** 2)[is_determined] / values[is_determined]).sum()
    )
    return float(chdtrc(int(is_determined.sum()), statistic))


MIN_INFORMATION_SHARE = 1e-6
"""Smallest share of the information that the other unknowns leave in a direction to be tested."""


def _blunder_equations(
    linearised: LinearisedProblem, blunder: Blunder
) -> tuple[Array, Array, Array, Array]:
    """Normal equations of a blunder: own block, blocks with unknowns and POS error, right side.

    The unknowns of a blunder are three shifts of the position for a line, and the offset alone or
    the tilts and the offset for a sighting.
    """
    problem, layout, sums = linearised.problem, linearised.normal.layout, linearised.sums
    groups, own = problem.groups, len(layout.active) + 4
    basis = linearised.directions
    width, count = sums.shape[1], 1 if blunder.kind == "shift" else 3
    among, right = np.zeros((count, count)), np.zeros(count)
    by_unknowns = np.zeros((count, layout.size + 1))
    by_pos = np.zeros((count, linearised.state.pos_corrections.size))
    for g in np.flatnonzero(np.isin(groups.sighting, blunder.sightings)):
        s, first = groups.sighting[g], 6 * groups.knot[g]
        size = np.zeros((width, count))
        if blunder.kind == "line":
            # The same shift of the POS position at the knots before and after
            size[own : own + 3] = size[own + 6 : own + 9] = np.eye(3)
        else:
            size[own - 4 : own] = linearised.bases.surfaces[s, :, 3 - count :]
        products = size.T @ sums[g]
        among += products @ size
        by_unknowns[:, layout.index[s]] += products[:, :own] @ basis[s]
        by_pos[:, first : first + 12] += products[:, own : own + 12]
        right -= products[:, -1]
    return among, by_unknowns[:, :-1], by_pos, right
