"""Tests of the check of assumed signs of roll and pitch by the residuals."""

from dataclasses import replace

import pytest

from lispac.adjustment.diagnostics.failure_causes import REJECTION_LEVEL
from lispac.adjustment.diagnostics.sign_check import sign_agreement
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.messages import Message
from lispac.survey.georeferencing import place_points, to_lidar
from lispac.survey.trajectory import Poses
from tests.adjustment.test_failure_causes import PRIOR
from tests.adjustment.test_sphere_radii import TRUTH, survey


def agreement(data: Observations) -> Message | None:
    data = average_points_in_cells(data, TRUTH, 0.02)
    result = adjust(data, PRIOR, StochasticModel(loss="tukey"))
    assert not result.is_model_rejected(REJECTION_LEVEL)
    return sign_agreement(data, PRIOR, result, ())


def with_motion(data: Observations, share: float) -> Observations:
    """Return the survey of the same points from a vessel with a share of the roll and pitch."""
    poses = Poses(data.position, data.attitude)
    place = place_points(data.points_lidar, poses, TRUTH)
    attitude = data.attitude * [share, share, 1.0]
    points = to_lidar(place, Poses(data.position, attitude), TRUTH)
    return replace(data, points_lidar=points, attitude=attitude)


@pytest.mark.parametrize(("share", "is_confirmed"), [(1.0, True), (1e-3, False)])
def test_the_signs_are_confirmed_only_if_the_vessel_rolls_and_pitches(
    share: float, is_confirmed: bool
) -> None:
    found = agreement(with_motion(survey(0, spacing=0.02), share))
    assert (found is not None) == is_confirmed
    if found is not None:
        assert found.code == "adjustment.signs_agree"
        assert found.params["ratio"] > 2.0
