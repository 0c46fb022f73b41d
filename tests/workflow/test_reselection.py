"""Tests of the repeated selection of points with the estimated boresight."""

import numpy as np
import pytest

from tests.studies.false_warnings import spinning, spinning_boresight_deg


@pytest.mark.parametrize("seed", [25, pytest.param(8, marks=pytest.mark.long)])
def test_a_board_is_not_replaced_by_the_wall_behind_it(seed: int) -> None:
    """Of a spinning scanner, the wall has twenty times the points of the board."""
    result, _ = spinning(seed)
    assert {each.sighting.target for each in result.sightings} == {"T1", "T2", "V1"}
    boards = [each for each in result.sightings if each.sighting.target != "V1"]
    assert max(each.points for each in boards) < 300
    error = np.degrees(result.boresight) - spinning_boresight_deg(seed)
    assert (np.abs(error) < 3 * np.degrees(result.sigma)).all()
