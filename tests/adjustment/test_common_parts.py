"""Tests of a large surface of which the lines show different parts: used whole or cut."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.common_target_parts import find_common_parts
from lispac.adjustment.model.observations import Observations
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Board,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import place_points
from lispac.survey.trajectory import Poses
from tests.studies.coverage_of_errors import MODEL, PRIOR, TRUTH

WALL = Board("wall", (0.0, 18.0, 5.0), (0.0, -1.0, 0.2), 8.0, 3.0)
SPACING = 0.05
LINES_OF_THE_NORTH_PART = ("L1", "L3", "L5")
"""Lines that show the northern part of the wall; the others show the southern part."""


def wall_survey(seed: int, *, bend: float = 0.0, overlap: float = 0.0) -> Observations:
    """Survey of two boards and a wall with a sagitta of ``bend`` metres over its width.

    Parameters
    ----------
    overlap : float, metres
        Width of the part in the middle that all lines show.
    """
    generator = np.random.default_rng([38, seed])
    exact = error_free_survey(TRUTH, (*THESIS_BOARDS, WALL), six_courses(), SPACING, generator)
    poses = Poses(exact.position, exact.attitude)
    points = place_points(exact.points_lidar, poses, TRUTH)
    beams = place_points(1.1 * exact.points_lidar, poses, TRUTH) - points
    beams /= np.linalg.norm(beams, axis=1)[:, None]
    on_wall = np.array([each.target == "wall" for each in exact.sightings])[exact.sighting]
    first = np.array([each.line in LINES_OF_THE_NORTH_PART for each in exact.sightings])[
        exact.sighting
    ]
    north = points[:, 0]
    off = bend * (2 * north / WALL.width) ** 2 / (beams @ WALL.facing)
    along = exact.points_lidar / np.linalg.norm(exact.points_lidar, axis=1)[:, None]
    bent = replace(exact, points_lidar=exact.points_lidar + (on_wall * off)[:, None] * along)
    shown = np.where(first, north > -overlap / 2, north < overlap / 2)
    return add_errors(bent, HYDROGRAPHIC_INS, generator).where(~on_wall | shown)


def test_a_flat_wall_is_used_whole() -> None:
    data = wall_survey(1)
    kept, parts = find_common_parts(data, TRUTH)
    assert parts == ()
    assert kept is data


def test_the_common_part_of_a_bent_wall_is_used() -> None:
    data = wall_survey(1, bend=0.05, overlap=1.6)
    kept, ((wall),) = find_common_parts(data, TRUTH)
    assert wall.target == "wall"
    assert set(wall.lines) == set(data.lines)
    assert wall.share == pytest.approx(
        0.33, abs=0.06
    )  # the common 1.6 m of the 4.8 m that each line shows
    on_wall = np.array([each.target == "wall" for each in kept.sightings])[kept.sighting]
    points = place_points(kept.points_lidar, Poses(kept.position, kept.attitude), TRUTH)[on_wall]
    assert np.abs(points[:, 0]).max() < 1.6 / 2 + 0.5


def test_one_of_two_parts_shown_by_three_lines_each_is_used() -> None:
    data = wall_survey(1, bend=0.05)
    kept, ((wall),) = find_common_parts(data, TRUTH)
    assert wall.lines in (LINES_OF_THE_NORTH_PART, ("L2", "L4", "L6"))
    assert wall.share == pytest.approx(0.5, abs=0.05)
    result = adjust(kept, PRIOR, MODEL)
    assert (np.abs(result.boresight - TRUTH.boresight) < 3.5 * result.sigma).all()


def test_a_bent_wall_without_a_common_part_is_excluded_and_the_rest_estimated() -> None:
    data = wall_survey(1, bend=0.05)
    twice = [s.target != "wall" or s.line in ("L1", "L2") for s in data.sightings]
    kept, ((wall),) = find_common_parts(data.of_sightings(np.array(twice)), TRUTH)
    assert (wall.share, wall.lines) == (0.0, ())
    assert kept.targets == ("T1", "T2")
    result = replace(adjust(kept, PRIOR, MODEL), common_parts=(wall,))
    assert (np.abs(result.boresight - TRUTH.boresight) < 3.5 * result.sigma).all()
    assert "adjustment.target_parts" in {each.code for each in result_warnings(result, None)}


def test_boards_shown_completely_are_not_cut() -> None:
    data = wall_survey(2).without_targets(["wall"])
    assert find_common_parts(data, TRUTH) == (data, ())
