"""Visibility of every error on every line and inclination of a site; best configurations.

The rule is that of the thesis (3.5.2), which applies it visually. Starting from the vertical board,
an inclination is kept if the type I criterion reaches a threshold on every line. The best of these
inclinations is that at which the lines differ most in both type II criteria. Lines with the same
effect form a group, and a configuration has one line of each group, which gives the eight
combinations of table 3.1.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
from lispac.progress import Progress, no_progress
from lispac.simulation.thesis_site import (
    HEADINGS_DEG,
    LINES,
    Beams,
    ThesisSite,
    board_plane,
    mounting_with_error,
    simulate_board,
)
from lispac.simulation.visibility_criteria import (
    angular_deviation,
    centroidal_distance,
    normalise_distances,
    orthogonal_distance,
    points_shape,
    type_one_criterion,
)

Array = NDArray[np.float64]

TYPE_ONE_THRESHOLD = 0.75
"""Threshold of the type I criterion. The thesis gives no number, only "near 1"."""
MAX_GROUP_DIFFERENCE = 0.1
"""Largest difference between lines with the same effect, as a share of the largest value."""
NEGLIGIBLE_DIFFERENCES = 0.001, np.radians(0.02)
"""Negligible differences of orthogonal distance (metres) and angular deviation (radians)."""


@dataclass(frozen=True, eq=False)
class VisibilityStudy:
    """Criteria of all errors, lines and inclinations of a site.

    Attributes
    ----------
    points : ndarray of int, shape (errors, lines, inclinations)
    planarity, type_one : ndarray of that shape
        NaN and 0, respectively, if there are no points on the board.
    centroidal_distance, orthogonal_distance : ndarray of that shape, metres
    angular_deviation : ndarray of that shape, radians
    """

    site: ThesisSite
    beams: Beams
    points: NDArray[np.int64]
    planarity: Array
    centroidal_distance: Array
    type_one: Array
    orthogonal_distance: Array
    angular_deviation: Array

    def best_configuration(
        self, error: str, considered: tuple[float, float] = (-np.inf, np.inf)
    ) -> "BestConfiguration":
        """The best configuration for an error.

        Parameters
        ----------
        considered : tuple of float, radians
            Lowest and highest inclination that may be chosen.
        """
        kept = self.kept_inclinations(error)
        low, high = considered
        chosen = self._most_visible_inclination(
            error, [each for each in kept if low <= each <= high]
        )
        if chosen is None:
            return BestConfiguration(error, kept, None, (HEADINGS_DEG,))
        return BestConfiguration(
            error, kept, self.site.inclinations[chosen], self.groups(error, chosen)
        )

    def kept_inclinations(self, error: str) -> tuple[float, ...]:
        """Consecutive inclinations, from the upright board, that the criterion keeps, radians."""
        good = (self.type_one[self.site.errors.index(error)] >= TYPE_ONE_THRESHOLD).all(axis=0)
        upright = int(np.argmin(np.abs(self.site.inclinations)))
        if not good[upright]:
            return ()
        low = high = upright
        while low > 0 and good[low - 1]:
            low -= 1
        while high < len(good) - 1 and good[high + 1]:
            high += 1
        return self.site.inclinations[low : high + 1]

    def visibility_spread(self, error: str) -> tuple[Array, Array]:
        """Range of the type II criteria over the lines, each of shape (inclinations,).

        Orthogonal distance in metres and angular deviation in radians; NaN if a line has no points.
        """
        k = self.site.errors.index(error)
        return np.ptp(self.orthogonal_distance[k], 0), np.ptp(self.angular_deviation[k], 0)

    def _most_visible_inclination(self, error: str, kept: Sequence[float]) -> int | None:
        """Index of the inclination at which the lines differ most; None if they do not differ.

        Both criteria have equal weights: each difference is divided by the largest among these
        inclinations.
        """
        among = [j for j, each in enumerate(self.site.inclinations) if each in kept]
        score = np.zeros(len(among))
        for spread, least in zip(
            self.visibility_spread(error), NEGLIGIBLE_DIFFERENCES, strict=True
        ):
            largest = spread[among].max(initial=0.0)
            if largest > least:
                score += spread[among] / largest
        return among[int(np.argmax(score))] if score.any() else None

    def groups(self, error: str, inclination: int) -> tuple[tuple[int, ...], ...]:
        """Groups of lines with the same effect at an inclination, as headings in degrees.

        Parameters
        ----------
        inclination : int
            Index of the inclination.
        """
        k = self.site.errors.index(error)
        shown = [
            (
                values[k, :, inclination],
                max(least, MAX_GROUP_DIFFERENCE * np.abs(values[k, :, inclination]).max()),
            )
            for values, least in zip(
                (self.orthogonal_distance, self.angular_deviation),
                NEGLIGIBLE_DIFFERENCES,
                strict=True,
            )
        ]
        groups: list[list[int]] = []
        for line in range(len(HEADINGS_DEG)):
            for group in groups:
                if all(abs(values[line] - values[group[0]]) < limit for values, limit in shown):
                    group.append(line)
                    break
            else:
                groups.append([line])
        return tuple(tuple(HEADINGS_DEG[line] for line in group) for group in groups)


@dataclass(frozen=True)
class BestConfiguration:
    """The best configuration for one error.

    Attributes
    ----------
    kept : tuple of float, radians
        Inclinations that the type I criterion accepts.
    inclination : float, radians
        None if the lines do not differ at any of them: the error is invisible.
    groups : tuple of tuple of int, degrees
        Headings of lines with the same effect; one line of each group is needed.
    """

    error: str
    kept: tuple[float, ...]
    inclination: float | None
    groups: tuple[tuple[int, ...], ...]

    @property
    def lines(self) -> tuple[int, ...]:
        """Headings (deg) of the first line of each group; empty if the error is invisible."""
        return () if self.inclination is None else tuple(group[0] for group in self.groups)

    def is_visible_on(self, lines: Sequence[int]) -> bool:
        """Whether the error is visible on these lines: they contain one of each group."""
        return self.inclination is not None and all(
            set(group) & set(lines) for group in self.groups
        )


def study_visibility(
    site: ThesisSite, beams: Beams = "aimed", *, progress: Progress = no_progress
) -> VisibilityStudy:
    """Simulate every error on every line and inclination.

    Centroidal distances are normalised over all errors of a site together. For a single error with
    nearly constant distance, equation 3.4 would stretch insignificant differences to the range from
    0 to 1. The thesis does not specify this; its figure 3.18 contains three errors.
    """
    shape = len(site.errors), len(LINES), len(site.inclinations)
    points = np.zeros(shape, dtype=np.int64)
    values = np.full((4, *shape), np.nan)
    for e, error in enumerate(site.errors):
        mounting = mounting_with_error(error)
        for j, inclination in enumerate(site.inclinations):
            progress((e + j / shape[2]) / shape[0])
            board = site.board(inclination)
            plane = board_plane(board)
            for k, course in enumerate(LINES):
                cloud = simulate_board(site, course, inclination, mounting, beams)
                points[e, k, j] = len(cloud)
                try:
                    found = points_shape(cloud)
                except PlaneNotFound:
                    continue  # no points, or only points on one straight line
                values[:, e, k, j] = (
                    found.planarity,
                    centroidal_distance(found, np.array(board.centre)),
                    orthogonal_distance(found, plane),
                    angular_deviation(found, plane),
                )
    progress(1.0)
    planarity, centroidal, orthogonal, angular = values
    good = type_one_criterion(planarity, normalise_distances(centroidal))
    return VisibilityStudy(site, beams, points, planarity, centroidal, good, orthogonal, angular)


def fewest_sufficient_lines(
    configurations: Sequence[BestConfiguration],
) -> tuple[tuple[int, ...], ...]:
    """Smallest sets of lines that show every visible error, as headings in degrees."""
    visible = [best for best in configurations if best.inclination is not None]
    for count in range(1, len(HEADINGS_DEG) + 1):
        enough = tuple(
            lines
            for lines in combinations(HEADINGS_DEG, count)
            if all(best.is_visible_on(lines) for best in visible)
        )
        if enough:
            return enough
    return ()
