"""Tests of estimated lever arm, offsets and latency, and of parameters that are kept."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter, mounting_value_name
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.errors import InputError
from lispac.messages import note
from lispac.project import Settings
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from tests.support.long_runs import LONG, others_long

TRUE_MOUNTING = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUE_MOUNTING.with_boresight(np.zeros(3))
MODEL = StochasticModel(loss="tukey")
MOUNTINGS_WITH_ERROR = {
    "lever_x": replace(TRUE_MOUNTING, lever_arm=TRUE_MOUNTING.lever_arm + [0.1, 0, 0]),
    "lever_y": replace(TRUE_MOUNTING, lever_arm=TRUE_MOUNTING.lever_arm + [0, 0.1, 0]),
    "range_offset": replace(TRUE_MOUNTING, range_offset=0.1),
    "latency": replace(TRUE_MOUNTING, latency=0.005),
}


def survey(truth: Mounting, seed: int, **changes: object) -> Observations:
    generator = np.random.default_rng([9, seed])
    exact = error_free_survey(truth, THESIS_BOARDS, six_courses(), 0.05, generator)
    noisy = add_errors(exact, HYDROGRAPHIC_INS, generator)
    return average_points_in_cells(noisy, PRIOR, 0.1)


@pytest.mark.parametrize("seed", others_long(range(4)))
@pytest.mark.parametrize("name", list(MOUNTINGS_WITH_ERROR))
def test_an_inserted_error_is_found_within_three_sigma(name, seed) -> None:
    truth = MOUNTINGS_WITH_ERROR[name]
    result = adjust(survey(truth, seed), PRIOR, MODEL, parameters=(Parameter(name),))
    (found,) = result.parameters
    assert found.value is not None, found.reason
    value = truth.values[Parameter(name).index]
    assert abs(found.value - value) < 3 * found.sigma
    assert (np.abs(result.boresight - TRUE_MOUNTING.boresight) < 3.5 * result.sigma).all()
    assert result.mounting.values[Parameter(name).index] == found.value


@LONG
@pytest.mark.parametrize("count", others_long([10, 24]))
def test_an_estimated_range_offset_is_unbiased_with_correct_sigmas(count: int) -> None:
    """The curvature of a flat board determines the range offset, so small biases matter."""
    ratios = []
    for seed in range(count):
        result = adjust(
            survey(MOUNTINGS_WITH_ERROR["range_offset"], 100 + seed), PRIOR, MODEL,
            parameters=(Parameter("range_offset"),), diagnostics=False,
        )  # fmt: skip
        (found,) = result.parameters
        ratios.append((found.value - 0.1) / found.sigma)
    assert abs(np.mean(ratios)) < 3 / np.sqrt(count)
    assert 0.6 < np.std(ratios) < 1.5


@pytest.mark.parametrize("sigma", [None, np.radians(0.5)])
def test_a_scan_angle_offset_cannot_be_separated_from_roll(sigma) -> None:
    truth = replace(TRUE_MOUNTING, scan_angle_offset=np.radians(1.0))
    result = adjust(
        survey(truth, 0), PRIOR, MODEL, parameters=(Parameter("scan_angle_offset", sigma),)
    )
    (found,) = result.parameters
    assert found.value is None
    assert found.sigma is None
    assert found.reason is not None
    assert found.reason.code == "parameter.rotates_like_boresight"
    kept = note("parameter.kept" if sigma is None else "parameter.kept_uncertain")
    assert found.reason.params["kept"] == kept
    assert found.prior == 0.0
    assert "scan_angle_offset" not in result.estimated
    if sigma is None:
        assert result.mounting.scan_angle_offset == 0
    else:  # the uncertainty of the offset is that of roll
        assert result.sigma[0] > 0.9 * sigma


def test_level_lines_do_not_determine_the_height_of_the_lever_arm() -> None:
    """It raises all lines and targets alike (thesis, C.2.5)."""
    exact = error_free_survey(
        TRUE_MOUNTING, THESIS_BOARDS, six_courses(), 0.1, np.random.default_rng(1)
    )
    attitude = exact.attitude.copy()
    middle = exact.mean_by_sighting(attitude)
    attitude[:] = middle[exact.sighting] * [0, 0, 1]
    from lispac.adjustment.model.target_shapes import points_local
    from lispac.survey.georeferencing import to_lidar
    from lispac.survey.trajectory import Poses

    places = points_local(exact, TRUE_MOUNTING)
    level = replace(
        exact,
        attitude=attitude,
        points_lidar=to_lidar(places, Poses(exact.position, attitude), TRUE_MOUNTING),
    )
    parameters = (Parameter("lever_x"), Parameter("lever_z"))
    result = adjust(level, PRIOR, MODEL, parameters=parameters)
    x, z = result.parameters
    assert x.value == pytest.approx(-0.2, abs=1e-6)
    assert z.value is None
    assert z.reason is not None
    assert z.reason.code == "parameter.raises_all_lines"
    assert result.mounting.lever_arm[2] == PRIOR.lever_arm[2]


def test_a_known_lever_arm_keeps_its_prior() -> None:
    """With a prior sigma of 0.5 mm and an error of 10 cm the result stays near the prior."""
    truth = MOUNTINGS_WITH_ERROR["lever_x"]
    loose = adjust(survey(truth, 1), PRIOR, MODEL, parameters=(Parameter("lever_x", 0.5),))
    tight = adjust(survey(truth, 1), PRIOR, MODEL, parameters=(Parameter("lever_x", 0.0005),))
    assert loose.parameters[0].value == pytest.approx(-0.1, abs=0.02)
    assert tight.parameters[0].value == pytest.approx(-0.2, abs=0.003)
    assert abs(loose.parameters[0].significance) > 10


def test_an_absent_error_is_not_significant() -> None:
    values = [
        adjust(
            survey(TRUE_MOUNTING, seed),
            PRIOR,
            MODEL,
            parameters=(Parameter("lever_x"),),
            diagnostics=False,
        ).parameters[0]
        for seed in range(6)
    ]
    assert sum(abs(value.significance) > 1.96 for value in values) <= 1


def test_latency_is_not_estimated_without_rates() -> None:
    without_rates = replace(survey(TRUE_MOUNTING, 0), pose_rate=None)
    (found,) = adjust(without_rates, PRIOR, MODEL, parameters=(Parameter("latency"),)).parameters
    assert found.value is None


@pytest.mark.parametrize(
    "parameters",
    [(Parameter("roll"),), (Parameter("lever_x", -1.0),), (Parameter("lever_x"),) * 2],
)
def test_invalid_parameters_are_refused(parameters) -> None:
    with pytest.raises(InputError):
        Settings(lever_arm=(0.0, 0.0, 0.0), parameters=parameters).require_sound()


@pytest.mark.parametrize("name", ["latency", "lever_z", "range_offset"])
@pytest.mark.parametrize("sigma", [None, 0.01])
def test_the_classical_model_estimates_only_the_boresight(name, sigma) -> None:
    """On the harbour survey its height of the lever arm was wrong by 7 sigma."""
    model, points = StochasticModel("independent"), survey(TRUE_MOUNTING, 0)
    result = adjust(points, PRIOR, model, parameters=(Parameter(name, sigma),))
    (found,) = result.parameters
    assert found.value is None
    assert found.significant is None
    assert found.reason == note("parameter.not_classical", parameter=mounting_value_name(name))
    plain = adjust(points, PRIOR, model)
    np.testing.assert_array_equal(result.boresight, plain.boresight)
    np.testing.assert_array_equal(result.mounting.values[3:], PRIOR.values[3:])
