"""Tests that errors put into simulated surveys are named as the cause of the residuals."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.diagnostics.cause_warnings import (
    main_wrong_value,
    warnings_about_causes,
    without_explained,
)
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult, PossibleCause, UncontrolledObservations
from lispac.message_texts.former_codes import former_code
from lispac.messages import Level, Message, note, warning
from lispac.present.calibration.adjustment import large_residuals_text
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from lispac.value_conversion import decode_value, encode_value
from lispac.warning_causes import Cause
from tests.support.long_runs import others_long

TRUE_MOUNTING = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUE_MOUNTING.with_boresight(np.zeros(3))
MODEL = StochasticModel(loss="tukey")
WRONG_MOUNTINGS = {
    "lever_x": (replace(TRUE_MOUNTING, lever_arm=TRUE_MOUNTING.lever_arm + [0.1, 0, 0]), 0.1),
    "lever_y": (replace(TRUE_MOUNTING, lever_arm=TRUE_MOUNTING.lever_arm + [0, 0.1, 0]), 0.1),
    "lever_z": (replace(TRUE_MOUNTING, lever_arm=TRUE_MOUNTING.lever_arm + [0, 0, 0.3]), 0.3),
    "range_offset": (replace(TRUE_MOUNTING, range_offset=0.15), 0.15),
    "latency": (replace(TRUE_MOUNTING, latency=0.02), 0.02),
}
"""True mountings that differ from the prior by one value, and the difference."""
Place = tuple[str, str, str]


def error_free_observations(
    mounting: Mounting, seed: int
) -> tuple[Observations, np.random.Generator]:
    generator = np.random.default_rng([9, seed])
    return error_free_survey(mounting, THESIS_BOARDS, six_courses(), 0.05, generator), generator


def survey(kind: str, seed: int) -> tuple[Observations, Place]:
    """Return a survey with one error, and the cause that should be named."""
    data, generator = error_free_observations(
        WRONG_MOUNTINGS[kind][0] if kind in WRONG_MOUNTINGS else TRUE_MOUNTING, seed
    )
    chance = np.random.default_rng([77, seed])
    line = data.lines[chance.integers(len(data.lines))]
    on_line = np.array([each.line == line for each in data.sightings])[data.sighting]
    place = (kind, "", "")
    if kind == "line_boresight":
        turned = TRUE_MOUNTING.boresight + np.radians(chance.choice([-0.3, 0.3], 3))
        second, _ = error_free_observations(TRUE_MOUNTING.with_boresight(turned), seed)
        points = np.where(on_line[:, None], second.points_lidar, data.points_lidar)
        data, place = replace(data, points_lidar=points), (kind, "", line)
    elif kind == "line_position":
        shift = chance.normal(size=3)
        shift *= 0.15 / np.linalg.norm(shift)
        position = data.position + on_line[:, None] * shift
        data, place = replace(data, position=position), (kind, "", line)
    elif kind == "line_time":
        late = 0.1 * on_line[:, None] * data.pose_rate
        data = replace(data, position=data.position + late[:, :3],
                       attitude=data.attitude + late[:, 3:])  # fmt: skip
        place = (kind, "", line)
    elif kind == "sighting_shift":
        k = chance.integers(len(data.sightings))
        beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
        points = data.points_lidar + 0.08 * (data.sighting == k)[:, None] * beams
        sighting = data.sightings[k]
        data, place = replace(data, points_lidar=points), (kind, sighting.target, sighting.line)
    return average_points_in_cells(add_errors(data, HYDROGRAPHIC_INS, generator), PRIOR, 0.1), place


def cause_groups(result: AdjustmentResult) -> list[list[Place]]:
    assert result.causes is not None
    return [[(each.kind, each.target, each.line) for each in group] for group in result.causes]


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize("kind", list(WRONG_MOUNTINGS))
def test_a_wrong_value_of_the_mounting_is_named_alone(kind: str, seed: int) -> None:
    data, place = survey(kind, seed)
    result = adjust(data, PRIOR, MODEL)
    assert cause_groups(result) == [[place]]
    assert result.causes is not None
    ((cause,),) = result.causes
    assert (
        abs(cause.size[0] - WRONG_MOUNTINGS[kind][1])
        < 4 * cause.sigma[0] + 0.1 * WRONG_MOUNTINGS[kind][1]
    )
    wide = adjust(data, PRIOR, MODEL, parameters=(Parameter(kind),))
    moved = wide.boresight - result.boresight
    assert (
        np.abs(cause.angle_change - moved).max()
        < 0.4 * wide.sigma.max() + 0.05 * np.abs(moved).max()
    )
    assert cause_groups(wide) == []
    found = [each for each in result_warnings(result, None) if each.is_serious]
    assert f"contradicted_{kind}" in map(former_code, found)


@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(seed, marks=pytest.mark.long) for seed in (1, 2))]
)
@pytest.mark.parametrize(
    "kind", others_long(["line_boresight", "line_position", "line_time", "sighting_shift"])
)
def test_an_error_in_one_place_is_named_or_listed(kind: str, seed: int) -> None:
    data, place = survey(kind, seed)
    result = adjust(data, PRIOR, MODEL)
    (group,) = cause_groups(result) or [[place]]  # an error along the boards has no effect
    assert place in group
    assert not any(code.startswith("adjustment.contradicted_") for code in _codes(result))
    if len(group) > 1:
        assert "adjustment.several_causes" in _codes(result)


def test_two_components_of_the_lever_arm_are_both_named() -> None:
    data, generator = error_free_observations(
        replace(TRUE_MOUNTING, lever_arm=TRUE_MOUNTING.lever_arm + [0.06, -0.05, 0]), 3
    )
    result = adjust(
        average_points_in_cells(add_errors(data, HYDROGRAPHIC_INS, generator), PRIOR, 0.1),
        PRIOR,
        MODEL,
    )
    assert {group[0][0] for group in cause_groups(result)} == {"lever_x", "lever_y"}
    assert result.causes is not None
    corrected = (
        result.boresight
        + sum(group[0].angle_change for group in result.causes)
        - TRUE_MOUNTING.boresight
    )
    assert (np.abs(corrected) < 4 * result.sigma).all()


@pytest.mark.parametrize("rough", others_long([0.0, 0.003], lambda rough: rough > 0))
def test_a_survey_without_errors_has_no_cause(rough: float) -> None:
    assert _false_alarms(range(1000, 1008), rough) == 0


@pytest.mark.long
@pytest.mark.parametrize("rough", [0.0, 0.003])
def test_at_most_one_of_a_hundred_surveys_without_errors_has_a_cause(rough: float) -> None:
    assert _false_alarms(range(2000, 2100), rough) <= 1


def _false_alarms(seeds: range, rough: float) -> int:
    """Count surveys with a cause that have form errors of size ``rough`` only."""
    found = 0
    for seed in seeds:
        data, _ = survey("", seed)
        off = np.random.default_rng(seed).normal(0, rough, len(data.sightings))[data.sighting]
        beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
        data = replace(data, points_lidar=data.points_lidar + off[:, None] * beams)
        found += bool(cause_groups(adjust(data, PRIOR, MODEL)))
    return found


@pytest.mark.long
@pytest.mark.parametrize(
    "kind", [*WRONG_MOUNTINGS, "line_boresight", "line_position", "line_time", "sighting_shift"]
)
def test_the_right_cause_is_named_in_nearly_every_survey(kind: str) -> None:
    """Of 20 surveys, another cause is named alone in at most one."""
    counts: Counter[str] = Counter()
    for seed in range(100, 120):
        data, place = survey(kind, seed)
        found = cause_groups(adjust(data, PRIOR, MODEL))
        if not found:
            counts["none"] += 1
        else:
            counts["listed" if place in found[0] else "wrong"] += 1
    print(f"{kind}: {dict(counts)}")
    assert counts["wrong"] <= 1
    assert counts["listed"] >= (20 if kind in WRONG_MOUNTINGS else 12)


def test_advice_on_targets_is_omitted_if_a_wrong_value_causes_most_of_the_residuals() -> None:
    data, _ = survey("lever_y", 1)
    result = adjust(data, PRIOR, MODEL)
    assert result.causes is not None
    ((cause,),) = result.causes
    others = [warning("adjustment.large_sigma"), note("adjustment.sigmas_raised")]
    for share, is_omitted in ((1.0, True), (0.3, False)):
        some = replace(result, causes=((replace(cause, effect=share * result.rms_after),),))
        codes = {each.code for each in warnings_about_causes(some, None, others)}
        assert "adjustment.contradicted_lever_y" in codes
        assert "adjustment.sigmas_raised" in codes
        assert ("adjustment.large_sigma" not in codes) == is_omitted
    assert result.observability is not None
    # With too few lines the cause is not located, so that the warning has to stay
    unchecked = (UncontrolledObservations("line", line=data.lines[0]),)
    few = replace(
        result, observability=replace(result.observability, unchecked=unchecked),
        causes=((replace(cause, effect=result.rms_after),),),
    )  # fmt: skip
    assert "adjustment.large_sigma" in {
        each.code for each in warnings_about_causes(few, None, others)
    }


def test_one_note_replaces_what_a_wrong_value_explains() -> None:
    data, _ = survey("lever_y", 1)
    result = adjust(data, PRIOR, MODEL)
    assert result.causes is not None
    ((cause,),) = result.causes
    others = [
        note("acceptance.cause_geometry"), note("report.noise_differs"),
        note("project.poor_sighting"), note("report.not_validated"),
    ]  # fmt: skip
    for share, is_explained in ((0.9, True), (0.3, False)):
        some = replace(result, causes=((replace(cause, effect=share * result.rms_after),),))
        messages = (*warnings_about_causes(some, None, []), *others)
        found = without_explained(messages)
        assert (main_wrong_value(found) is not None) == is_explained
        if is_explained:
            assert [each.code for each in found] == [
                "adjustment.contradicted_lever_y", "report.not_validated",
                "adjustment.explained_by_value",
            ]  # fmt: skip
            assert found[-1].subject == Cause.of_parameter("lever_y")
            assert without_explained(found) == found
        else:
            assert found == messages
        text = str(large_residuals_text(some))
        assert ("lever arm Y" in text) == is_explained


@pytest.mark.parametrize(
    ("given", "code"), [(0.15, "change.opposite_sign"), (0.0, "change.smaller")]
)
def test_a_value_of_the_opposite_sign_is_named(given: float, code: str) -> None:
    """The true lever arm X is 0.15 m smaller than zero."""
    true = replace(TRUE_MOUNTING, lever_arm=np.array([-0.15, 0.04, 2.4]))
    wrong = replace(PRIOR, lever_arm=np.array([given, 0.04, 2.4]))
    data, generator = error_free_observations(true, 0)
    seen = average_points_in_cells(add_errors(data, HYDROGRAPHIC_INS, generator), wrong, 0.1)
    (found,) = (
        each for each in result_warnings(adjust(seen, wrong, MODEL), None)
        if each.code.startswith("adjustment.contradicted_lever_x")
    )  # fmt: skip
    change = found.params["change"]
    assert isinstance(change, Message)
    assert change.code == code


@pytest.mark.parametrize(("kind", "is_far"), [("lever_z", True), ("latency", False)])
def test_an_estimated_lever_arm_far_from_the_given_one_is_a_warning(
    kind: str, is_far: bool
) -> None:
    """Its sign may have been typed wrong; the angles are of no use with the given value."""
    data, _ = survey(kind, 0)
    freed = (Parameter("lever_z"), Parameter("latency"))
    result = adjust(data, PRIOR, MODEL, parameters=freed)
    found = [
        each for each in result_warnings(result, None)
        if each.code == "adjustment.estimated_lever_arm_differs"
    ]  # fmt: skip
    assert [each.level for each in found] == [Level.WARNING] * is_far
    assert [each.subject for each in found] == [Cause.of_parameter("lever_z")] * is_far


@pytest.mark.parametrize(
    ("code", "effect", "explained"),
    others_long(
        [
            ("recovery.height_offset", 0.6, True),
            ("audit.several_scanners", None, True),
            ("audit.time_resolution", 0.001, False),
            ("audit.noise_classes", None, False),
        ]
    ),
)
def test_an_error_known_from_the_data_replaces_a_contradicted_value(
    code: str, effect: float | None, explained: bool
) -> None:
    """If its effect is large enough, it would make a correct lever arm look wrong."""
    data, _ = survey("lever_y", 1)
    result = adjust(data, PRIOR, MODEL)
    also = warning(code) if effect is None else warning(code, shift=effect)
    codes = set(map(former_code, result_warnings(result, None, [also])))
    assert code in codes
    assert ("known_cause" in codes) == explained
    assert ("contradicted_lever_y" in codes) != explained


def test_the_classical_model_and_fixed_surfaces_have_no_cause() -> None:
    data, _ = survey("lever_x", 0)
    assert cause_groups(adjust(data, PRIOR, StochasticModel("independent"))) == []
    assert cause_groups(adjust(data, PRIOR, StochasticModel(surface=0.0))) == []


def test_no_cause_is_named_if_too_few_lines_distinguish_them() -> None:
    """The POS error of an uncontrolled line has the effect of a wrong lever arm."""
    data, _ = survey("lever_x", 0)
    result = adjust(data, PRIOR, MODEL)
    assert result.observability is not None
    unchecked = (UncontrolledObservations("line", line=data.lines[0]),)  # as with two lines
    result = replace(result, observability=replace(result.observability, unchecked=unchecked))

    def cause(kind: str, line: str = "") -> PossibleCause:
        return PossibleCause(
            kind, "", line, np.full(3, 0.1), np.full(3, 0.01), np.zeros(3), 0.02, 12.0
        )

    lever, of_line = cause("lever_x"), cause("line_boresight", data.lines[0])
    unclear = replace(result, causes=((lever, of_line),))
    assert "adjustment.cause_not_identified" in _codes(unclear)
    assert not any("cause." in str(each.params) for each in result_warnings(unclear, None))
    clear = [
        each for each in result_warnings(replace(result, causes=((lever,), (of_line,) * 2)), None)
        if each.code == "adjustment.cause_not_located"
    ]  # fmt: skip
    assert len(clear) == 1
    (phrase,) = clear[0].params["causes"]
    assert phrase.params["parameter"] == note("quantity.lever_x")


def test_causes_are_kept_with_the_result() -> None:
    result = adjust(survey("line_position", 0)[0], PRIOR, MODEL)
    kept = decode_value(encode_value(result), AdjustmentResult)
    assert cause_groups(kept) == cause_groups(result) != []
    content = encode_value(result)
    del content["causes"]  # a result of an earlier version
    assert decode_value(content, AdjustmentResult).causes is None


def _codes(result: AdjustmentResult) -> set[str]:
    return {each.code for each in result_warnings(result, None)}
