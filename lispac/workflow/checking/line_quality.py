"""Differences between the lines of a survey with the current georeferencing."""

from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, NotComparable
from lispac.language import gettext_lazy
from lispac.messages import Level, Message, as_message, error
from lispac.present.checking.line_differences import LineDifferenceValues
from lispac.progress import Progress, no_progress
from lispac.project import BoresightChoice, Project
from lispac.survey.cloud import Cloud
from lispac.validation.line_differences import (
    FACINGS,
    DifferenceStatistics,
    Facing,
    LineDifference,
    compare_lines,
)
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

SEARCH_DISTANCE = 1.0
"""Largest distance between lines, metres: an error of 0.5 deg of the prior boresight displaces a
wall at 60 m by half a metre."""
MIN_PLACES = 10
"""Smallest number of places for a statistic."""


@dataclass(frozen=True, eq=False)
class LineQuality:
    """Differences between the lines of a survey.

    Attributes
    ----------
    which : boresight with which the lines are placed, prior or estimated
    pairs : differences of all pairs of lines that share a flat place
    not_compared : reasons why other pairs are not compared
    """

    which: BoresightChoice
    pairs: tuple[LineDifference, ...]
    not_compared: tuple[Message, ...]

    def statistics_of_pair(
        self, pair: LineDifference, facing: Facing = "all"
    ) -> DifferenceStatistics | None:
        """Statistics of a pair; None if there are too few places of that orientation."""
        own = pair.facing(facing)
        return _difference_statistics([own])

    def pooled_statistics(self, facing: Facing = "all") -> DifferenceStatistics | None:
        """Statistics of all pairs, with equal weight for each place."""
        statistics = _difference_statistics([pair.facing(facing) for pair in self.pairs])
        return statistics and replace(statistics, median=None, robust_sigma=None)

    def places(self, row: LineDifferenceValues) -> tuple[LineDifference, ...]:
        """Differences of which a row gives the statistics."""
        return tuple(
            pair.facing(row.facing)
            for pair in self.pairs
            if row.first == row.second or (pair.first, pair.second) == (row.first, row.second)
        )

    def rows(self) -> list[LineDifferenceValues]:
        """All statistics: of each pair, then of all pairs together."""
        found = [
            LineDifferenceValues.of(pair.first, pair.second, facing, statistics)
            for pair in self.pairs
            for facing in FACINGS
            if (statistics := self.statistics_of_pair(pair, facing)) is not None
        ]
        if len(self.pairs) > 1:
            found += [
                LineDifferenceValues.of("all", "all", facing, statistics)
                for facing in FACINGS
                if (statistics := self.pooled_statistics(facing)) is not None
            ]
        return found


def _difference_statistics(parts: list[LineDifference]) -> DifferenceStatistics | None:
    distance = np.concatenate([each.distance for each in parts])
    if len(distance) < MIN_PLACES:
        return None
    return DifferenceStatistics.of(distance, np.concatenate([each.half_width for each in parts]))


def line_quality(
    project: Project,
    survey: Survey,
    *,
    which: BoresightChoice = "prior",
    search_distance: float = SEARCH_DISTANCE,
    progress: Progress = no_progress,
) -> LineQuality:
    """Compare all pairs of lines of a survey on flat places, before or after the calibration.

    Parameters
    ----------
    which : boresight with which the lines are placed, prior or estimated
    search_distance : float, metres
        Largest distance between two lines.

    Raises
    ------
    InputError
        If ``search_distance`` is out of range.
    NotComparable
        If no two lines share a flat place.
    ProjectError
        If ``which`` is "estimated" and there is no result.
    """
    if not 0.0 < search_distance <= 10.0:
        raise InputError(error("check.search_distance", distance=search_distance))
    clouds = survey.placed(project, which)
    points = {name: _finite_sample(cloud) for name, cloud in clouds.items()}
    pairs = list(combinations(points, 2))
    found, missed = [], []
    for k, (one, other) in enumerate(pairs):
        progress(k / len(pairs), gettext_lazy("Comparing {one} and {other}", one=one, other=other))
        vessel = _mean_vessel_position(survey, one, other)
        try:
            found.append(
                compare_lines(
                    (one, points[one]), (other, points[other]), vessel,
                    noise=survey.lidar_sigma(project.settings), reach=search_distance,
                )
            )  # fmt: skip
        except NotComparable as failure:
            missed.append(replace(as_message(failure.reason), level=Level.NOTE))
    if not found:
        raise NotComparable(
            error("check.no_common_place", project=project.name, distance=search_distance)
        )
    progress(1.0)
    return LineQuality(which, tuple(found), tuple(missed))


def _finite_sample(cloud: Cloud) -> Array:
    sample = cloud.sample
    return np.ascontiguousarray(sample[np.isfinite(sample).all(axis=1)])


def _mean_vessel_position(survey: Survey, *lines: str) -> Array:
    """Mean position of the vessel while it scanned some lines, shape (3,), metres."""
    times = np.concatenate(
        [np.linspace(survey.scans[n].first_time, survey.scans[n].last_time, 21) for n in lines]
    )
    middle: Array = survey.trajectory.at(times).position.mean(axis=0)
    return middle
