"""Test for lines whose position is shifted as a whole, for example by a GNSS jump between lines.

The estimated POS error absorbs part of such a jump, and displaces the other lines in the opposite
direction. A score test (Rao 1948) checks whether the POS error of a line has a mean other than
zero. Let e be the estimated POS errors, W their prior precision, C their covariance after the
adjustment, and G the matrix of unit shifts of a line at its knots. Without a shift, the score G'We
has the variance Q = G'(W - WCW)G. The shift of a line that is found is then treated as an unknown,
which removes its effect on the scores of the other lines.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.adjustment.solve.banded_cholesky import forward_substitution

Array = NDArray[np.float64]

TEST_LEVEL = 0.001
"""Significance level of the test of a line (Baarda 1968).

It is low, because a position error of two sigmas is not a jump.
"""
MIN_DATA_SHARE = 0.05
"""Smallest share of the data, not the prior, in the information on a direction that is tested."""
AXIS_COUNT = 3
"""Number of axes: north, west, up."""


@dataclass(frozen=True, eq=False)
class LineShiftScores:
    """Score tests of a position shift of each line.

    Attributes
    ----------
    lines : tuple of str
    score : ndarray of shape (3 lines,)
        Scores, divided by the square root of their prior information, no unit.
    variance : ndarray of shape (3 lines, 3 lines)
        Covariance of ``score``, with a diagonal from 0 (no information from the data) to 1.
    """

    lines: tuple[str, ...]
    score: Array
    variance: Array

    @classmethod
    def of(cls, linearised: LinearisedProblem) -> "LineShiftScores":
        """Compute the score of every line.

        Parameters
        ----------
        linearised : LinearisedProblem
            Equations of the correlated model at its solution.
        """
        problem, normal = linearised.problem, linearised.normal
        observations, knots = problem.observations, problem.groups.knots
        assert knots is not None
        lines = tuple(observations.lines)
        place = {line: k for k, line in enumerate(lines)}
        of_sighting = np.array([place[each.line] for each in observations.sightings])
        line = of_sighting[problem.groups.sighting]
        shifts = np.zeros((len(lines), AXIS_COUNT, len(knots.time), 6))
        for k in range(len(lines)):
            own = problem.groups.knot[line == k]
            for axis in range(AXIS_COUNT):
                shifts[k, axis, own, axis] = shifts[k, axis, own + 1, axis] = 1.0
        weighted = np.array([[knots.apply_prior_precision(each) for each in own] for own in shifts])
        size = len(lines) * AXIS_COUNT
        flat, given = weighted.reshape(size, -1), shifts.reshape(size, -1)
        half = forward_substitution(normal.factor, flat.T)
        through = half.T @ normal.whitened_mixed
        after = half.T @ half + through @ normal.covariance @ through.T
        prior = flat @ given.T
        root = np.sqrt(np.diag(prior))
        variance = (prior - after) / np.outer(root, root)
        score = flat @ linearised.state.pos_corrections.reshape(-1) / root
        return cls(lines, score, (variance + variance.T) / 2)

    def p_value_of_shift(self, k: int) -> float:
        """P-value of the test of a line."""
        from scipy.special import chdtrc

        own, (information, directions) = self._columns_of_line(k), self._information_shares(k)
        along = directions.T @ self.score[own]
        return (
            float(chdtrc(len(information), (along**2 / information).sum()))
            if len(information)
            else 1.0
        )

    def without_line_shift(self, k: int) -> "LineShiftScores":
        """Scores of the other lines, with the shift of line ``k`` as an unknown."""
        own, (information, directions) = self._columns_of_line(k), self._information_shares(k)
        share = self.variance[:, own] @ (directions / information) @ directions.T
        return LineShiftScores(
            self.lines,
            self.score - share @ self.score[own],
            self.variance - share @ self.variance[own],
        )

    def shifted_lines(self) -> tuple[str, ...]:
        """Find the lines whose position is shifted.

        Only differences between lines are observed. Of two lines that disagree, both are returned;
        of more lines, fewer than half.
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
        return slice(AXIS_COUNT * k, AXIS_COUNT * (k + 1))

    def _information_shares(self, k: int) -> tuple[Array, Array]:
        """Eigenvalues and eigenvectors of the information on the shift of a line.

        Directions with a share below `MIN_DATA_SHARE` are omitted.
        """
        own = self._columns_of_line(k)
        shares, directions = np.linalg.eigh(self.variance[own, own])
        enough = shares > MIN_DATA_SHARE
        return shares[enough], directions[:, enough]
