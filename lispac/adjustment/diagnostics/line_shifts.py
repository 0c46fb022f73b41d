"""Test for lines whose position is shifted as a whole, as by a GNSS jump between lines.

The POS error takes a jump up as far as its prior allows, and as lines are seen against each other,
it pushes the other lines the other way. Whether a line's POS error has a mean b of its own is a
score test (Rao 1948): with the estimated errors e, their prior precision W, their covariance C
after the adjustment, and the line's knots G, the score G'We has the variance Q = G'(W - WCW)G
where nothing is shifted. A shift that is named becomes an unknown, which takes its push off the
others.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.adjustment.solve.banded_cholesky import forward_substitution

Array = NDArray[np.float64]

TEST_LEVEL = 0.001
"""Chance that a line is named where nothing is shifted, as in the tests of points and sightings
(Baarda 1968): positions that are two sigmas off by themselves are no jump."""
MIN_DATA_SHARE = 0.05
"""Smallest share of the information on a shift that must come from the data, not the prior, for a
direction to be tested."""
AXES = 3
"""North, west, up."""


@dataclass(frozen=True, eq=False)
class LineShiftScores:
    """Score tests of a position shift of each line.

    Attributes
    ----------
    lines : tuple of str
    score : ndarray of shape (3 lines,)
        Divided by the root of the prior's own, so that all have one unit.
    variance : ndarray of shape (3 lines, 3 lines)
        From 0, no information, to 1, full information.
    """

    lines: tuple[str, ...]
    score: Array
    variance: Array

    @classmethod
    def of(cls, here: LinearisedProblem) -> "LineShiftScores":
        """Compute the score of every line.

        Parameters
        ----------
        here : LinearisedProblem
            Of the correlated model, at its solution.
        """
        problem, normal = here.problem, here.normal
        observations, knots = problem.observations, problem.groups.knots
        assert knots is not None
        lines = tuple(observations.lines)
        place = {line: k for k, line in enumerate(lines)}
        of_sighting = np.array([place[each.line] for each in observations.sightings])
        line = of_sighting[problem.groups.sighting]
        shifts = np.zeros((len(lines), AXES, len(knots.time), 6))
        for k in range(len(lines)):
            own = problem.groups.knot[line == k]
            for axis in range(AXES):
                shifts[k, axis, own, axis] = shifts[k, axis, own + 1, axis] = 1.0
        weighted = np.array([[knots.apply_prior_precision(each) for each in own] for own in shifts])
        size = len(lines) * AXES
        flat, given = weighted.reshape(size, -1), shifts.reshape(size, -1)
        half = forward_substitution(normal.factor, flat.T)
        through = half.T @ normal.whitened_mixed
        after = half.T @ half + through @ normal.covariance @ through.T
        prior = flat @ given.T
        root = np.sqrt(np.diag(prior))
        variance = (prior - after) / np.outer(root, root)
        score = flat @ here.state.effects.reshape(-1) / root
        return cls(lines, score, (variance + variance.T) / 2)

    def p_value_of_shift(self, k: int) -> float:
        """P-value of the score of a line."""
        from scipy.special import chdtrc

        own, (information, directions) = self._columns_of_line(k), self._information_shares(k)
        along = directions.T @ self.score[own]
        return (
            float(chdtrc(len(information), (along**2 / information).sum()))
            if len(information)
            else 1.0
        )

    def without_line_shift(self, k: int) -> "LineShiftScores":
        """Scores of the other lines with the shift of one line as an unknown."""
        own, (information, directions) = self._columns_of_line(k), self._information_shares(k)
        share = self.variance[:, own] @ (directions / information) @ directions.T
        return LineShiftScores(
            self.lines,
            self.score - share @ self.score[own],
            self.variance - share @ self.variance[own],
        )

    def shifted_lines(self) -> tuple[str, ...]:
        """Find the lines whose position is shifted.

        Only differences of lines are observed: of two that do not agree both are named, and of more
        less than half.
        """
        count, scores, found = len(self.lines), self, set[int]()
        while len(found) < max(1, (count - 1) // 2):
            chances = {k: scores.p_value_of_shift(k) for k in range(count) if k not in found}
            worst = min(chances, key=chances.__getitem__)
            if chances[worst] >= TEST_LEVEL:
                break
            found.add(worst)
            scores = scores.without_line_shift(worst)
        if found and count == 2:
            return self.lines
        return tuple(self.lines[k] for k in sorted(found))

    def _columns_of_line(self, k: int) -> slice:
        return slice(AXES * k, AXES * (k + 1))

    def _information_shares(self, k: int) -> tuple[Array, Array]:
        """Eigenvalues and directions of the information on the shift of a line."""
        own = self._columns_of_line(k)
        shares, directions = np.linalg.eigh(self.variance[own, own])
        enough = shares > MIN_DATA_SHARE
        return shares[enough], directions[:, enough]
