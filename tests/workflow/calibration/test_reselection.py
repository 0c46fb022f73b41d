"""Tests of the repeated selection of points with the estimated boresight."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.project import PickedSighting, Target
from lispac.simulation.scene import tilted_rectangle
from lispac.workflow.calibration.reselection import reselect_target
from lispac.workflow.project.survey import Survey
from tests.studies.false_warnings import spinning
from tests.support.finder_scenes import WALL, Site, site
from tests.support.long_runs import LONG

BOARD = (0.0, WALL, 7.0)
LINES = 3
THRESHOLD = 0.015


def board_before_wall(distance: float) -> Site:
    """A board 1.2 m wide, ``distance`` metres before a wall."""
    wall = tilted_rectangle("wall", (0.0, WALL - distance, 7.0), 8.0, 5.0, 270, 0)
    board = tilted_rectangle("T1", BOARD, 1.2, 0.9, 270, 0)
    return site([board, wall], lines=LINES, pulses_per_second=30_000.0)


def picked(seen: Site, survey: Survey, surfaces: dict[str, str], one_in: int = 1) -> Target:
    """Target with every ``one_in``-th point of a surface near the seed, by line."""
    sightings = []
    for line, surface in surfaces.items():
        cloud = survey.clouds[line]
        near = np.linalg.norm(cloud[np.arange(len(cloud))] - np.array(BOARD), axis=1) < 0.8
        indices = np.flatnonzero(seen.on(line, surface) & near)[::one_in]
        sightings.append(PickedSighting(line, indices, 0.003))
    return Target("T1", "target", BOARD, THRESHOLD, 1.5, tuple(sightings))


def shares_on_board(seen: Site, target: Target) -> list[float]:
    return [float(seen.on(each.line, "T1")[each.indices].mean()) for each in target.sightings]


def require_all_board_points(seen: Site, third: Target, again: Target) -> None:
    """Require the points of the board, of which ``third`` has every third one, without the wall."""
    assert min(shares_on_board(seen, again)) > 0.95
    for before, after in zip(third.sightings, again.sightings, strict=True):
        assert len(after.indices) > 2 * len(before.indices)


@pytest.mark.parametrize("distance", [0.1, 0.15, 0.3])
def test_points_of_a_board_are_selected_again_and_none_of_the_wall(distance: float) -> None:
    seen = board_before_wall(distance)
    _, survey = seen.opened()
    target = picked(seen, survey, dict.fromkeys(seen.echoes, "T1"), one_in=3)
    again = reselect_target(target, survey.clouds, survey.clouds)
    require_all_board_points(seen, target, again)


def test_a_sighting_of_the_wall_is_corrected_if_the_others_are_of_the_board() -> None:
    seen = board_before_wall(0.3)
    _, survey = seen.opened()
    target = picked(seen, survey, {"L1": "wall", "L2": "T1", "L3": "T1"})
    again = reselect_target(target, survey.clouds, survey.clouds)
    assert min(shares_on_board(seen, again)) > 0.95


@pytest.mark.parametrize("distance", [0.1, 0.3])
def test_the_board_is_selected_again_if_the_seed_is_on_the_wall(distance: float) -> None:
    """After a wrong prior boresight, a typed seed is beside the points of the target."""
    seen = board_before_wall(distance)
    _, survey = seen.opened()
    target = picked(seen, survey, dict.fromkeys(seen.echoes, "T1"), one_in=3)
    moved = replace(target, seed=(2.0, WALL - distance, 7.0))
    again = reselect_target(moved, survey.clouds, survey.clouds)
    require_all_board_points(seen, target, again)


def test_a_board_is_kept_if_the_wall_is_found_again() -> None:
    """The seed is beside the board, on the wall, but close to a point of the board."""
    seen = board_before_wall(0.05)
    _, survey = seen.opened()
    target = picked(seen, survey, dict.fromkeys(seen.echoes, "T1"))
    moved = replace(target, seed=(0.65, WALL - 0.05, 7.0))
    assert shares_on_board(seen, reselect_target(moved, survey.clouds, survey.clouds)) == [1.0] * 3


def test_neither_of_two_sightings_on_different_surfaces_is_changed() -> None:
    """Two lines do not show which of the surfaces is the target."""
    seen = board_before_wall(0.3)
    _, survey = seen.opened()
    target = picked(seen, survey, {"L1": "wall", "L2": "T1"})
    again = reselect_target(target, survey.clouds, survey.clouds)
    assert shares_on_board(seen, again) == [0.0, 1.0]


def test_points_of_the_wall_are_removed_from_a_board() -> None:
    """Every fourth point of the selection is on the wall, as after a wrong prior boresight."""
    seen = board_before_wall(0.05)
    _, survey = seen.opened()
    board = picked(seen, survey, dict.fromkeys(seen.echoes, "T1"))
    wall = picked(seen, survey, dict.fromkeys(seen.echoes, "wall"))
    mixed = tuple(
        replace(each, indices=np.union1d(each.indices, other.indices[: len(each.indices) // 3]))
        for each, other in zip(board.sightings, wall.sightings, strict=True)
    )
    assert max(shares_on_board(seen, replace(board, sightings=mixed))) < 0.85
    again = reselect_target(replace(board, sightings=mixed), survey.clouds, survey.clouds)
    assert min(shares_on_board(seen, again)) > 0.95


@pytest.mark.parametrize("off_deg", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.5, -0.5, 1.0)])
def test_a_board_picked_with_a_wrong_prior_is_selected_again(off_deg: tuple[float, ...]) -> None:
    """The wrong angles displace and smear the board until the estimate is used."""
    seen = board_before_wall(0.3)
    _, wrong = seen.opened(off_deg)
    _, right = seen.opened()
    target = picked(seen, right, dict.fromkeys(seen.echoes, "T1"), one_in=3)
    seed = wrong.clouds["L1"][target.sightings[0].indices].mean(axis=0)
    again = reselect_target(replace(target, seed=tuple(seed)), wrong.clouds, right.clouds)
    require_all_board_points(seen, target, again)


@LONG
@pytest.mark.parametrize("seed", [25, pytest.param(8, marks=pytest.mark.long)])
def test_a_board_before_a_wall_keeps_its_points_with_a_spinning_scanner(seed: int) -> None:
    """The wall has twenty times the points of the board."""
    found = spinning(seed, points_per_second=30_000, cross_check=False)
    result = found.result
    assert result is not None
    assert {each.sighting.target for each in result.sightings} == {"T1", "T2", "V1"}
    boards = [each for each in result.sightings if each.sighting.target != "V1"]
    assert max(each.points for each in boards) < 300
    assert (np.abs(found.error) < 3 * found.sigma).all()
