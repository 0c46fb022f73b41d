"""Tests of observability: undetermined geometries, weak directions, advice on further lines."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.observability import MIN_LINE_SIGMA_RATIO
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust, adjust_or_explain
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import POS_ERROR_MODELS, StochasticModel
from lispac.adjustment.model.target_shapes import points_local
from lispac.adjustment.result import ANGLES, AdjustmentResult, UncontrolledObservations
from lispac.adjustment.solve.normal_equations import scaled_inverse
from lispac.adjustment.solve.solver import with_agreeing_targets
from lispac.cli.messages import option_hint
from lispac.design.further_line_advice import further_line_advice, further_lines
from lispac.errors import NotConverged, RankDeficient, TargetDisagrees
from lispac.message_texts import english_text
from lispac.messages import Message, error, note
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    Ball,
    Board,
    Course,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting, to_lidar
from lispac.survey.trajectory import Poses
from lispac.warning_causes import Cause
from tests.adjustment.test_robustness import shifted
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import codes

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
UPRIGHT_BOARD, LEANING_BOARD = THESIS_BOARDS


def survey(targets=THESIS_BOARDS, courses=None, seed: int = 0, still: bool = False) -> Observations:
    generator = np.random.default_rng([4, seed])
    exact = error_free_survey(TRUTH, targets, courses or six_courses(), 0.05, generator)
    if still:
        attitude = exact.mean_by_sighting(exact.attitude)[exact.sighting] * [0, 0, 1]
        scan = to_lidar(points_local(exact, TRUTH), Poses(exact.position, attitude), TRUTH)
        exact = replace(exact, attitude=attitude, points_lidar=scan)
    return average_points_in_cells(add_errors(exact, HYDROGRAPHIC_INS, generator), PRIOR, 0.1)


@pytest.mark.parametrize("accepted", [False, True])
@pytest.mark.parametrize("pos_errors", POS_ERROR_MODELS)
@pytest.mark.parametrize(
    ("targets", "lines", "reason"),
    [
        (THESIS_BOARDS, (0,), "adjustment.one_line"),
        ((UPRIGHT_BOARD,), (0, 1), "adjustment.parallel_lines_one_target"),
        (
            (UPRIGHT_BOARD, replace(UPRIGHT_BOARD, name="T3", centre=(-3.0, 15.0, 4.0))),
            (0, 1),
            "adjustment.parallel_lines_one_orientation",
        ),
    ],
)
def test_an_undetermined_geometry_is_refused_with_its_reason(
    pos_errors, targets, lines, reason, accepted
) -> None:
    courses = tuple(six_courses()[k] for k in lines)
    points, model = survey(targets, courses, still=True), StochasticModel(pos_errors)
    with pytest.raises(RankDeficient) as refused:
        adjust(points, PRIOR, model, accept_single_orientation=accepted)
    assert reason_of(refused.value) == reason


def reason_of(error: RankDeficient) -> str:
    """Return the code of the reason, or of the error itself if it has no reason."""
    assert error.message is not None
    reason = error.message.params.get("reason")
    if reason is None:
        return error.code
    assert error.code == "adjustment.undetermined_because"
    assert isinstance(reason, Message)
    return reason.code


def there_and_back(times: int) -> tuple[Course, ...]:
    """Return parallel lines past both boards, which hardly determine pitch and yaw."""
    pair = six_courses()[:2]
    return tuple(
        replace(course, name=f"{course.name}{k}", time=course.time + 180 * k)
        for k in range(times)
        for course in pair
    )


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("loss", ["none", "tukey"])
def test_the_classical_model_refuses_what_the_correlated_model_refuses(seed, loss) -> None:
    """The information of its own covariance grows with the points and seems sufficient."""
    points = survey(courses=there_and_back(2), seed=seed)
    for pos_errors in POS_ERROR_MODELS:
        with pytest.raises(RankDeficient) as refused:
            adjust(points, PRIOR, StochasticModel(pos_errors, loss=loss), diagnostics=False)
        assert reason_of(refused.value) == "adjustment.parallel_lines"


def facing(degrees: float) -> Board:
    """Return a board beside the upright one, turned by an angle."""
    angle = np.radians(degrees)
    normal = (np.sin(angle), -np.cos(angle), 0.0)
    return replace(UPRIGHT_BOARD, name="T3", centre=(-3.0, 15.0, 4.0), normal=normal)


@pytest.mark.parametrize("pos_errors", POS_ERROR_MODELS)
@pytest.mark.parametrize(
    ("targets", "code"),
    [
        ((UPRIGHT_BOARD,), "adjustment.only_plane"),
        ((UPRIGHT_BOARD, facing(0)), "adjustment.parallel_planes"),
        ((UPRIGHT_BOARD, facing(8)), "adjustment.parallel_planes"),
    ],
)
def test_parallel_targets_are_refused_for_any_headings(pos_errors, targets, code) -> None:
    with pytest.raises(RankDeficient, check=has_code(code)):
        adjust(survey(targets), PRIOR, StochasticModel(pos_errors), diagnostics=False)


@LONG
@pytest.mark.parametrize("accepted", others_long([False, True]))
def test_planes_made_parallel_by_a_wrong_lever_arm_are_no_reason(accepted: bool) -> None:
    """The boards differ by 45 deg; only the adjusted planes have one orientation."""
    wrong = replace(PRIOR, lever_arm=PRIOR.lever_arm + [5.0, 0.0, 0.0])
    model = StochasticModel("independent", loss="none")
    with pytest.raises(NotConverged) as failure:
        adjust_or_explain(
            survey(), wrong, model, diagnostics=False, accept_single_orientation=accepted
        )
    assert failure.value.code == "estimate.possible_cause"
    assert failure.value.message.subject == Cause.of_field("lever_arm")
    reason, cause = (failure.value.message.params[name] for name in ("reason", "cause"))
    assert reason.code == "adjustment.orientations_lost"
    assert {reason.params["first"], reason.params["second"]} == {"T1", "T2"}
    assert np.degrees(reason.params["angle"]) == pytest.approx(45, abs=2)
    assert np.degrees(reason.params["change"]) <= 180
    change = cause.params["change"]
    assert change.code == "cause.smaller"
    assert change.params["parameter"] == note("quantity.lever_x")
    assert change.params["amount"].params["value"] == pytest.approx(5.0, abs=0.01)


def test_a_refusal_names_the_sightings_rejected_before_it() -> None:
    points = shifted(survey((UPRIGHT_BOARD, facing(0))), 8, 0.3)
    with pytest.raises(RankDeficient) as refused:
        adjust(points, PRIOR, StochasticModel(loss="tukey"))
    assert refused.value.code == "adjustment.refused_after_rejection"
    params = refused.value.message.params
    assert (params["count"], params["total"]) == (1, 12)
    off = points.sightings[8]
    assert list(params["sightings"]) == [note("item.sighting", target=off.target, line=off.line)]
    assert params["reason"].code == "adjustment.parallel_planes"
    assert option_hint(refused.value.message) == "--accept-single-orientation"


def test_a_refusal_names_the_targets_excluded_before_it() -> None:
    points = survey((UPRIGHT_BOARD, facing(0), LEANING_BOARD))

    def refuse(some: Observations) -> AdjustmentResult:
        if "T2" in some.targets:
            raise TargetDisagrees(error("adjustment.target_disagrees", target="T2"), "T2")
        return adjust(some, PRIOR, StochasticModel(), diagnostics=False)

    with pytest.raises(RankDeficient) as refused:
        with_agreeing_targets(points, refuse, may_exclude=True)
    assert refused.value.code == "adjustment.refused_after_exclusion"
    params = refused.value.message.params
    assert (params["count"], params["total"], list(params["targets"])) == (1, 3, ["T2"])
    assert params["reason"].code == "adjustment.parallel_planes"


@pytest.mark.parametrize(
    "targets",
    [
        (UPRIGHT_BOARD, facing(12)),
        (UPRIGHT_BOARD, facing(7), replace(facing(-7), name="T4", centre=(3.0, 15.0, 4.0))),
        (UPRIGHT_BOARD, Ball("B1", (-3.0, 15.0, 4.0), 0.3)),
    ],
)
def test_targets_with_two_orientations_are_accepted(targets) -> None:
    """The order does not matter; planes at 7 deg to either side of a third differ by 14 deg."""
    for some in (targets, targets[::-1]):
        adjust(survey(some), PRIOR, StochasticModel(), diagnostics=False)


def test_cross_checks_may_have_one_orientation() -> None:
    """A cross-check without one of two boards is left with a single target."""
    points = survey()
    checks = cross_checks(points, PRIOR, adjust(points, PRIOR, StochasticModel()))
    assert all(c.boresight is not None for c in checks.parts if c.kind == "target")


def test_one_accepted_board_has_larger_sigmas_and_a_correct_result() -> None:
    """A single orientation is accepted by the setting."""
    one = adjust(survey((UPRIGHT_BOARD,)), PRIOR, StochasticModel(), accept_single_orientation=True)
    two = adjust(survey(), PRIOR, StochasticModel())
    assert (one.sigma > two.sigma).all()
    assert one.observability.messages[-1] == note("adjustment.one_target", target="T1")
    assert "adjustment.one_target" not in codes(two.observability.messages)
    assert (np.abs(one.boresight - TRUTH.boresight) < 3.5 * one.sigma).all()


def test_the_inclination_of_a_sphere_is_not_reported() -> None:
    ball = Ball("B1", (0.0, 15.0, 4.0), 0.3)
    result = adjust(survey((ball,)), PRIOR, StochasticModel())
    assert result.observability.messages[-1] == note("observability.one_sphere", target="B1")
    first = six_courses()[0]
    twice = (first, replace(first, name="L2", time=first.time + 90))
    undetermined = has_code("adjustment.undetermined_because", action=note("adjustment.add_target"))
    with pytest.raises(RankDeficient, check=undetermined):
        adjust(survey((ball,), twice, still=True), PRIOR, StochasticModel())


def test_parallel_boards_are_reported() -> None:
    points = survey((UPRIGHT_BOARD, facing(0)))
    result = adjust(points, PRIOR, StochasticModel(), accept_single_orientation=True)
    assert result.observability.messages[-1] == note("adjustment.one_facing")
    assert (np.abs(result.boresight - TRUTH.boresight) < 3.5 * result.sigma).all()


def test_directions_and_condition_agree_with_the_covariance() -> None:
    result = adjust(survey(), PRIOR, StochasticModel())
    observability = result.observability
    assert observability is not None
    information = np.linalg.inv(result.covariance)
    np.testing.assert_allclose(
        observability.directions @ np.diag(observability.eigenvalues) @ observability.directions.T,
        information,
        rtol=1e-6,
    )
    assert observability.condition == pytest.approx(np.linalg.cond(information), rel=1e-6)
    weakest = ("roll", "pitch", "yaw")[int(np.argmax(np.abs(observability.directions[:, 0])))]
    message = observability.messages[0]
    assert message.code == "observability.directions"
    named = message.params["weakest"]
    assert isinstance(named, Message)
    assert named.params.get("first", named) == note(f"adjustment.angle_{weakest}")
    for which, column in (("weakest", 0), ("strongest", 2)):
        # A direction named by one angle has the sigma of the table of angles.
        name = message.params[which]
        alone = [k for k, angle in enumerate(("roll", "pitch", "yaw"))
                 if name == note(f"adjustment.angle_{angle}")]  # fmt: skip
        expected = result.sigma[alone[0]] if alone else observability.eigenvalues[column] ** -0.5
        assert message.params[f"{which}_sigma"] == pytest.approx(expected)


def test_sigmas_without_a_line_agree_with_an_adjustment_without_it() -> None:
    courses = six_courses()[:2] + six_courses()[4:]
    data = survey(courses=courses)
    model = StochasticModel(surface=0.0005)
    observability = adjust(data, PRIOR, model).observability
    assert observability is not None
    for line in ("L1", "L6"):
        keep = np.array([s.line != line for s in data.sightings])
        without = adjust(data.of_sightings(keep), PRIOR, model)
        np.testing.assert_allclose(observability.sigma_without_line[line], without.sigma, rtol=0.05)


def test_the_largest_increase_without_a_line_is_stated() -> None:
    """All angles are named: those that depend on a line, and the increase of the others."""
    result = adjust(survey(), PRIOR, StochasticModel())
    assert result.observability is not None
    without = result.observability.sigma_without_line
    named = {
        english_text(each.params["angle"])
        for each in result.observability.messages
        if each.code == "observability.main_lines"
    }
    items = [
        each
        for message in result.observability.messages
        if message.code == "observability.largest_increases"
        for each in message.params["angles"]
    ]
    assert len(items) + len(named) == len(ANGLES)
    for k, angle in enumerate(ANGLES):
        ratios = {line: sigma[k] / result.sigma[k] for line, sigma in without.items()}
        largest = max(ratios, key=lambda line: ratios[line])
        if ratios[largest] > MIN_LINE_SIGMA_RATIO:
            assert angle in named
            continue
        (item,) = (each for each in items if english_text(each.params["angle"]) == angle)
        assert item.params["line"] == largest
        assert item.params["increase"] == pytest.approx(ratios[largest] - 1.0)


def test_a_line_that_alone_determines_an_angle_is_named() -> None:
    """Of two lines along the wall and an oblique one, pitch and yaw depend on the oblique one."""
    courses = six_courses()[:2] + six_courses()[4:5]
    observability = adjust(survey(courses=courses), PRIOR, StochasticModel()).observability
    assert observability is not None
    assert UncontrolledObservations("line", line="L5") in observability.unchecked


@pytest.mark.parametrize(("distance", "clustered"), [(0.3, True), (1.5, False)])
def test_targets_close_together_are_named(distance: float, clustered: bool) -> None:
    """Three boards of different orientation, 15 m from the scanner."""
    normals = ((0.0, -1.0, 0.0), (0.0, -1.0, 1.0), (0.6, -1.0, 0.2))
    boards = tuple(
        Board(f"T{k}", (distance * k, 15.0, 5.0), normal) for k, normal in enumerate(normals)
    )
    result = adjust(survey(boards), PRIOR, StochasticModel())
    assert result.observability is not None
    found = result.observability.unchecked
    assert [each.kind for each in found] == ["clustered"] * clustered
    assert all(each.size == pytest.approx(0.6 / 14.0, rel=0.15) for each in found)
    serious = codes([each for each in result_warnings(result, None) if each.is_serious])
    assert ("adjustment.targets_clustered" in serious) == clustered


@pytest.mark.parametrize(("turn_deg", "is_carried"), [(5.0, True), (15.0, False)])
def test_a_sighting_on_which_angles_depend_alone_is_named(
    turn_deg: float, is_carried: bool
) -> None:
    """Two lines along the wall, two slightly turned ones, and T1 alone on an oblique line."""
    first, second, third, fourth, oblique, _ = six_courses()
    turn = np.radians(turn_deg)
    courses = (
        first, second, replace(third, heading=turn), replace(fourth, heading=np.pi + turn), oblique,
    )  # fmt: skip
    data = survey(courses=courses)
    data = data.of_sightings(
        np.array([each.line != "L5" or each.target == "T1" for each in data.sightings])
    )
    result = adjust(data, PRIOR, StochasticModel())
    assert result.observability is not None
    carried = [each for each in result.observability.unchecked if each.line]
    expected = UncontrolledObservations("sighting", "T1", "L5", ("pitch", "yaw"))
    assert carried == [expected] * is_carried
    if is_carried:
        serious = codes([each for each in result_warnings(result, None) if each.is_serious])
        assert "adjustment.carried_by_one" in serious
    assert (ratio_without(data, result, line="L5") > 4.0).tolist() == [False, *[is_carried] * 2]


def ratio_without(
    data: Observations, result: AdjustmentResult, line: str = "", targets: Iterable[str] = ()
) -> np.ndarray:
    """Return the sigmas of an adjustment without a line or targets, divided by those with them."""
    omitted = np.array([each.line == line or each.target in targets for each in data.sightings])
    without = adjust(
        data.of_sightings(~omitted), PRIOR, StochasticModel(), accept_single_orientation=True,
        test_model=False,
    )  # fmt: skip
    return without.sigma / result.with_formal_sigmas.sigma


@pytest.mark.parametrize(("slope", "is_carried"), [(0.3, True), (1.0, False)])
def test_a_target_on_which_an_angle_depends_alone_is_named(slope: float, is_carried: bool) -> None:
    """A board that is nearly level hardly determines the pitch; one that leans 45 deg does."""
    boards = (UPRIGHT_BOARD, replace(LEANING_BOARD, normal=(0.0, -slope, 1.0)))
    data = survey(boards)
    result = adjust(data, PRIOR, StochasticModel())
    assert result.observability is not None
    carried = UncontrolledObservations("sighting", "T1", angles=("pitch", "yaw"))
    assert result.observability.unchecked == (carried,) * is_carried
    serious = codes([each for each in result_warnings(result, None) if each.is_serious])
    assert ("adjustment.carried_by_one" in serious) == is_carried
    ratios = [ratio_without(data, result, targets=[name]) for name in ("T1", "T2")]
    assert (np.array(ratios) > 4.0).tolist() == [[False, is_carried, is_carried], [False] * 3]


@pytest.mark.parametrize(("distance", "is_named"), [(0.4, True), (3.0, False)])
def test_two_targets_that_act_as_one_beside_a_third_are_named(
    distance: float, is_named: bool
) -> None:
    """An error common to the upright and the leaning board would not be detected."""
    boards = (
        UPRIGHT_BOARD, replace(UPRIGHT_BOARD, name="T2", centre=(0.8 + distance, 15.0, 5.0)),
        Board("T3", (6.8, 15.0, 5.0), (0.0, -0.3, 1.0)),
    )  # fmt: skip
    data = survey(boards, six_courses()[:4])
    result = adjust(data, PRIOR, StochasticModel())
    assert result.observability is not None
    found = [each for each in result.observability.unchecked if each.kind == "clustered"]
    assert [each.targets for each in found] == [("T1", "T2")] * is_named
    serious = codes([each for each in result_warnings(result, None) if each.is_serious])
    assert ("adjustment.targets_act_as_one" in serious) == is_named
    ratio = ratio_without(data, result, targets=["T1", "T2"])
    assert ratio.max() > 4.0
    assert all("pitch" in each.angles for each in found)


def test_predicted_sigmas_of_a_further_line_are_obtained() -> None:
    """The predicted sigmas agree with those of a survey that has the line."""
    courses = six_courses()[:2] + six_courses()[4:5]
    data = survey(courses=courses)
    model = StochasticModel(surface=0.0)
    result = adjust(data, PRIOR, model)
    lines = {round(np.degrees(line.heading)): line for line in further_lines(data, result)}
    more = (*courses, replace(six_courses()[2], name="L9", time=courses[-1].time + 180.0))
    sailed = adjust(survey(courses=more), PRIOR, model)
    np.testing.assert_allclose(lines[45].sigma, sailed.sigma, rtol=0.25)
    assert (lines[45].sigma < result.sigma).all()
    (found,) = further_line_advice(data, result)
    assert found.code in ("further_line.port_of_face", "further_line.starboard_of_face")
    assert found.params["target"] == "T1"


def test_predicted_sigmas_of_a_further_line_with_a_latency() -> None:
    """A latency depends on the motion of the platform, which differs on the further line."""
    courses, parameters = six_courses()[:2] + six_courses()[4:5], (Parameter("latency"),)
    data, model = survey(courses=courses), StochasticModel(surface=0.0)
    result = adjust(data, PRIOR, model, parameters=parameters)
    lines = {round(np.degrees(line.heading)): line for line in further_lines(data, result)}
    more = (*courses, replace(six_courses()[2], name="L9", time=courses[-1].time + 180.0))
    sailed = adjust(survey(courses=more), PRIOR, model, parameters=parameters)
    np.testing.assert_allclose(lines[45].sigma, sailed.sigma, rtol=0.05)


def test_a_rejected_sighting_does_not_affect_the_prediction() -> None:
    """Further lines are predicted from the sightings that are used."""
    from tests.adjustment.test_robustness import shifted

    clean = survey(courses=six_courses()[:5])
    data, model = shifted(clean, 9, 0.3), StochasticModel(loss="tukey")
    result = adjust(data, PRIOR, model)
    assert result.rejected_sightings == (data.sightings[9],)
    without = data.of_sightings(np.arange(len(data.sightings)) != 9)
    plain = adjust(without, PRIOR, model)
    predicted = {line.heading: line.sigma for line in further_lines(data, result)}
    expected = {line.heading: line.sigma for line in further_lines(without, plain)}
    assert predicted.keys() == expected.keys()
    for heading, sigma in predicted.items():
        np.testing.assert_allclose(sigma, expected[heading], rtol=0.005)


@LONG
def test_the_advice_says_if_no_line_helps() -> None:
    twice = six_courses() + tuple(
        replace(c, name=f"{c.name}b", time=c.time + 600) for c in six_courses()
    )
    data = survey(
        (UPRIGHT_BOARD, LEANING_BOARD, Board("T3", (0.0, -15.0, 5.0), (0.0, 1.0, 0.3))), twice
    )
    (found,) = further_line_advice(data, adjust(data, PRIOR, StochasticModel()))
    assert found.code == "further_line.insufficient"


def test_the_prediction_of_further_lines_respects_the_prior() -> None:
    """A scan-angle offset with a prior sigma of 0.5 deg limits roll on any line."""
    points, offset_prior = survey(), Parameter("scan_angle_offset", np.radians(0.5))
    result = adjust(points, PRIOR, StochasticModel(), parameters=(offset_prior,))
    assert result.sigma[0] > 0.9 * np.radians(0.5)
    best = min(line.sigma[0] for line in further_lines(points, result))
    assert best > 0.95 * result.sigma[0]
    found = further_line_advice(points, result)
    assert found[0] == note(
        "further_line.prior",
        angle=note("quantity.roll"), parameters=(note("quantity.scan_angle_offset"),),
    )  # fmt: skip
    assert "further_line.insufficient" not in [each.code for each in found]


def test_the_advice_skips_an_angle_limited_by_a_prior() -> None:
    """An angle limited by a prior is named; the advised line is for the next angle."""
    courses = six_courses()[:2] + six_courses()[4:5]
    points, model = survey(courses=courses), StochasticModel(surface=0.0)
    offset_prior = Parameter("scan_angle_offset", np.radians(0.5))
    plain = further_line_advice(points, adjust(points, PRIOR, model))
    first, *rest = further_line_advice(
        points, adjust(points, PRIOR, model, parameters=(offset_prior,))
    )
    assert len(plain) == 1
    assert plain[0].params.keys() >= {"heading", "then"}
    assert first.code == "further_line.prior"
    assert list(map(english_text, rest)) == list(map(english_text, plain))


def test_a_prior_of_small_effect_does_not_change_the_advice() -> None:
    points, offset_prior = survey(), Parameter("scan_angle_offset", np.radians(0.002))
    result = adjust(points, PRIOR, StochasticModel(), parameters=(offset_prior,))
    assert [each.value for each in result.parameters] == [None]
    assert "further_line.prior" not in [each.code for each in further_line_advice(points, result)]


def test_the_advice_of_the_classical_model_ignores_other_parameters() -> None:
    points, offset_prior = survey(), Parameter("scan_angle_offset", np.radians(0.5))
    model = StochasticModel("independent")
    plain = adjust(points, PRIOR, model)
    assert further_line_advice(
        points, adjust(points, PRIOR, model, parameters=(offset_prior,))
    ) == further_line_advice(points, plain)


def test_a_further_line_has_side_and_distance_of_the_targets() -> None:
    """The boards are to the west of the lines, at 11 to 15 m."""
    courses = six_courses()[:2] + six_courses()[4:5]
    points = survey(courses=courses)
    result = adjust(points, PRIOR, StochasticModel(surface=0.0))
    lines = {round(np.degrees(line.heading)): line for line in further_lines(points, result)}
    assert not lines[0].to_starboard  # on a northward line, west is to port
    assert lines[180].to_starboard
    assert all(10.5 < line.distance < 15.5 for line in lines.values())
    (found,) = further_line_advice(points, result)
    best = lines[round(np.degrees(found.params["heading"]))]
    side = "starboard" if best.to_starboard else "port"
    assert found.code == f"further_line.{side}_of_face"
    assert found.params["distance"] == best.distance


def test_cross_checks_ignore_the_prior_of_a_common_parameter() -> None:
    points, offset_prior = survey(), Parameter("scan_angle_offset", np.radians(0.5))
    plain = adjust(points, PRIOR, StochasticModel())
    result = adjust(points, PRIOR, StochasticModel(), parameters=(offset_prior,))
    expected = cross_checks(points, PRIOR, plain)
    found = cross_checks(points, PRIOR, result, (offset_prior,))
    for one, other in zip(expected.parts, found.parts, strict=True):
        np.testing.assert_allclose(other.significance, one.significance, rtol=0.05, atol=0.05)


@pytest.mark.parametrize("weight", [-1e-9, 0.0, np.nan])
def test_a_matrix_with_an_unknown_without_weight_is_refused(weight: float) -> None:
    """Rounding can make the weight negative beside large correlated ones."""
    with pytest.raises(RankDeficient, check=has_code("adjustment.singular")):
        scaled_inverse(np.array([[weight, 1e3], [1e3, 1e10]]))
