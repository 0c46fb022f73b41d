"""Tests of the possible cause that is named when an adjustment does not converge."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.diagnostics.failure_causes import find_failure_causes, find_wrong_value
from lispac.adjustment.diagnostics.possible_causes import VERY_STRONG_EVIDENCE
from lispac.adjustment.least_squares import adjust, adjust_or_explain
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.errors import Cancelled, NotConverged
from lispac.messages import note
from tests.adjustment.test_observability import PRIOR as BOARDS_PRIOR
from tests.adjustment.test_observability import survey as boards_survey
from tests.adjustment.test_sphere_radii import TRUTH, changed, survey

MODEL = StochasticModel(loss="tukey")
PRIOR = TRUTH.with_boresight(np.zeros(3))


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.long)])
def test_a_wrong_roll_sign_in_a_survey_of_balls_is_named(seed: int) -> None:
    """The radii of the balls are unknown, and no other cause fits."""
    data = changed(survey(seed, spacing=0.03), "roll_sign")
    with pytest.raises(NotConverged) as raised:
        adjust_or_explain(data, PRIOR, MODEL)
    assert raised.value.code == "estimate.possible_cause"
    params = raised.value.message.params
    assert params["cause"] == note("cause.wrong_roll_sign")
    assert params["reason"].code == "adjustment.not_converged"


def test_no_cause_is_named_if_none_fits() -> None:
    """Roll has the wrong sign, and the points of three lines are distorted too."""
    data = changed(survey(1, spacing=0.03), "roll_sign")
    off = np.array([each.line in ("L1", "L2", "L3") for each in data.sightings])[data.sighting]
    points = np.where(off[:, None], data.points_lidar * [1.0, 1.3, 1.0], data.points_lidar)
    assert find_failure_causes(replace(data, points_lidar=points), PRIOR, MODEL) == ()


def test_a_lever_arm_that_displaces_whole_targets_is_found() -> None:
    wrong = replace(BOARDS_PRIOR, lever_arm=BOARDS_PRIOR.lever_arm + [1.0, 0.0, 0.0])
    data = boards_survey()
    result = adjust(data, wrong, MODEL, diagnostics=False)
    assert result.rms_after > 0.1
    cause = find_wrong_value(data, wrong, MODEL, result)
    assert cause is not None
    assert (cause.kind, cause.target, cause.line) == ("lever_x", "", "")
    assert abs(cause.size[0] + 1.0) < 4 * cause.sigma[0] < 0.2
    corrected = adjust(data, BOARDS_PRIOR, MODEL, diagnostics=False)
    change = corrected.boresight - result.boresight
    np.testing.assert_allclose(cause.angle_change, change, atol=4 * corrected.sigma.max())
    assert cause.evidence > VERY_STRONG_EVIDENCE


def test_a_correct_mounting_has_no_wrong_value() -> None:
    data = boards_survey()
    result = adjust(data, BOARDS_PRIOR, MODEL, diagnostics=False)
    assert find_wrong_value(data, BOARDS_PRIOR, MODEL, result) is None


def test_the_search_for_a_wrong_value_can_be_cancelled() -> None:
    data = boards_survey()
    result = adjust(data, BOARDS_PRIOR, MODEL, diagnostics=False)

    def cancel(_fraction: float, _step: object = "") -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        find_wrong_value(data, BOARDS_PRIOR, MODEL, result, progress=cancel)
