"""What the geometry sees: refusals with their reason, weak directions, a further line."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import POS_ERROR_MODELS, StochasticModel
from lispac.adjustment.model.target_shapes import points_local
from lispac.adjustment.result import UncontrolledObservations
from lispac.adjustment.solve.normal_equations import scaled_inverse
from lispac.design.further_line_advice import further_line_advice, further_lines
from lispac.errors import RankDeficient
from lispac.message_texts import english_text
from lispac.messages import Message, note
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
from tests.error_codes import has_code
from tests.message_codes import codes

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
UPRIGHT, LEANING = THESIS_BOARDS


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
        ((UPRIGHT,), (0, 1), "adjustment.parallel_lines_one_target"),
        (
            (UPRIGHT, replace(UPRIGHT, name="T3", centre=(-3.0, 15.0, 4.0))),
            (0, 1),
            "adjustment.parallel_lines_one_orientation",
        ),
    ],
)
def test_a_geometry_that_fails_is_refused_with_its_reason(
    pos_errors, targets, lines, reason, accepted
) -> None:
    courses = tuple(six_courses()[k] for k in lines)
    points, model = survey(targets, courses, still=True), StochasticModel(pos_errors)
    with pytest.raises(RankDeficient) as refused:
        adjust(points, PRIOR, model, accept_single_orientation=accepted)
    assert reason_of(refused.value) == reason


def reason_of(error: RankDeficient) -> str:
    """Code of the reason that an undetermined boresight has; of the error itself without one."""
    assert error.message is not None
    reason = error.message.params.get("reason")
    if reason is None:
        return error.code
    assert error.code == "adjustment.undetermined_because"
    assert isinstance(reason, Message)
    return reason.code


def there_and_back(times: int) -> tuple[Course, ...]:
    """Lines past both boards, all parallel: what pitch and yaw do to them can hardly be told."""
    pair = six_courses()[:2]
    return tuple(
        replace(course, name=f"{course.name}{k}", time=course.time + 180 * k)
        for k in range(times)
        for course in pair
    )


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("loss", ["none", "tukey"])
def test_the_classical_model_refuses_what_the_correlated_model_refuses(seed, loss) -> None:
    """Its own information grows with the points, and any angle seems known."""
    points = survey(courses=there_and_back(2), seed=seed)
    for pos_errors in POS_ERROR_MODELS:
        with pytest.raises(RankDeficient) as refused:
            adjust(points, PRIOR, StochasticModel(pos_errors, loss=loss), diagnostics=False)
        assert reason_of(refused.value) == "adjustment.parallel_lines"


def facing(degrees: float) -> Board:
    """A board beside the upright one that faces another way by so much."""
    angle = np.radians(degrees)
    normal = (np.sin(angle), -np.cos(angle), 0.0)
    return replace(UPRIGHT, name="T3", centre=(-3.0, 15.0, 4.0), normal=normal)


@pytest.mark.parametrize("pos_errors", POS_ERROR_MODELS)
@pytest.mark.parametrize(
    ("targets", "code"),
    [
        ((UPRIGHT,), "adjustment.only_plane"),
        ((UPRIGHT, facing(0)), "adjustment.parallel_planes"),
        ((UPRIGHT, facing(8)), "adjustment.parallel_planes"),
    ],
)
def test_targets_that_face_one_way_are_refused_on_any_headings(pos_errors, targets, code) -> None:
    with pytest.raises(RankDeficient, check=has_code(code)):
        adjust(survey(targets), PRIOR, StochasticModel(pos_errors), diagnostics=False)


@pytest.mark.parametrize(
    "targets",
    [
        (UPRIGHT, facing(12)),
        (UPRIGHT, facing(7), replace(facing(-7), name="T4", centre=(3.0, 15.0, 4.0))),
        (UPRIGHT, Ball("B1", (-3.0, 15.0, 4.0), 0.3)),
    ],
)
def test_targets_that_face_two_ways_are_not(targets) -> None:
    """In any order: planes 7 deg to each side of a third are 14 deg apart."""
    for some in (targets, targets[::-1]):
        adjust(survey(some), PRIOR, StochasticModel(), diagnostics=False)


def test_parts_of_a_survey_may_face_one_way() -> None:
    """Without one of two boards the other is left; that is what a cross-check asks."""
    points = survey()
    checks = cross_checks(points, PRIOR, adjust(points, PRIOR, StochasticModel()))
    assert all(c.boresight is not None for c in checks.parts if c.kind == "target")


def test_one_board_on_six_lines_answers_with_the_sigmas_it_deserves() -> None:
    """Where that is accepted: the data can tell, and the sigmas say how well."""
    one = adjust(survey((UPRIGHT,)), PRIOR, StochasticModel(), accept_single_orientation=True)
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


def test_boards_that_face_one_way_are_reported() -> None:
    points = survey((UPRIGHT, facing(0)))
    result = adjust(points, PRIOR, StochasticModel(), accept_single_orientation=True)
    assert result.observability.messages[-1] == note("adjustment.one_facing")
    assert (np.abs(result.boresight - TRUTH.boresight) < 3.5 * result.sigma).all()


def test_directions_and_condition_are_those_of_the_covariance() -> None:
    result = adjust(survey(), PRIOR, StochasticModel())
    seen = result.observability
    assert seen is not None
    information = np.linalg.inv(result.covariance)
    np.testing.assert_allclose(
        seen.directions @ np.diag(seen.eigenvalues) @ seen.directions.T, information, rtol=1e-6
    )
    assert seen.condition == pytest.approx(np.linalg.cond(information), rel=1e-6)
    weakest = ("roll", "pitch", "yaw")[int(np.argmax(np.abs(seen.directions[:, 0])))]
    assert seen.messages[0].code == "observability.directions"
    assert english_text(seen.messages[0]).startswith(f"Least precisely determined: {weakest}")


def test_sigmas_without_a_line_are_those_of_the_adjustment_without_it() -> None:
    courses = six_courses()[:2] + six_courses()[4:]
    data = survey(courses=courses)
    model = StochasticModel(surface=0.0005)
    seen = adjust(data, PRIOR, model).observability
    assert seen is not None
    for line in ("L1", "L6"):
        keep = np.array([s.line != line for s in data.sightings])
        without = adjust(data.of_sightings(keep), PRIOR, model)
        np.testing.assert_allclose(seen.sigma_without_line[line], without.sigma, rtol=0.05)


def test_a_line_that_alone_sees_an_angle_is_named() -> None:
    """Along the wall and one oblique line: pitch and yaw hang on it."""
    courses = six_courses()[:2] + six_courses()[4:5]
    seen = adjust(survey(courses=courses), PRIOR, StochasticModel()).observability
    assert seen is not None
    assert UncontrolledObservations("line", line="L5") in seen.unchecked


def test_a_further_line_brings_what_was_predicted() -> None:
    """The sigma predicted for a line, and that of the survey in which it was sailed."""
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


def test_what_was_predicted_holds_with_a_latency_too() -> None:
    """A latency is seen by how the platform moves, and the further line moves another way."""
    courses, wanted = six_courses()[:2] + six_courses()[4:5], (Parameter("latency"),)
    data, model = survey(courses=courses), StochasticModel(surface=0.0)
    result = adjust(data, PRIOR, model, parameters=wanted)
    lines = {round(np.degrees(line.heading)): line for line in further_lines(data, result)}
    more = (*courses, replace(six_courses()[2], name="L9", time=courses[-1].time + 180.0))
    sailed = adjust(survey(courses=more), PRIOR, model, parameters=wanted)
    np.testing.assert_allclose(lines[45].sigma, sailed.sigma, rtol=0.05)


def test_a_sighting_that_was_rejected_promises_nothing() -> None:
    """The further line is foretold from the sightings that the answer rests on."""
    from tests.test_robustness import shifted

    clean = survey(courses=six_courses()[:5])
    data, model = shifted(clean, 9, 0.3), StochasticModel(loss="tukey")
    result = adjust(data, PRIOR, model)
    assert result.rejected_sightings == (data.sightings[9],)
    without = data.of_sightings(np.arange(len(data.sightings)) != 9)
    plain = adjust(without, PRIOR, model)
    told = {line.heading: line.sigma for line in further_lines(data, result)}
    same = {line.heading: line.sigma for line in further_lines(without, plain)}
    assert told.keys() == same.keys()
    for heading, sigma in told.items():
        np.testing.assert_allclose(sigma, same[heading], rtol=0.005)


def test_where_no_line_helps_the_advice_says_so() -> None:
    twice = six_courses() + tuple(
        replace(c, name=f"{c.name}b", time=c.time + 600) for c in six_courses()
    )
    data = survey((UPRIGHT, LEANING, Board("T3", (0.0, -15.0, 5.0), (0.0, 1.0, 0.3))), twice)
    (found,) = further_line_advice(data, adjust(data, PRIOR, StochasticModel()))
    assert found.code == "further_line.insufficient"


def test_no_line_is_promised_to_bring_what_no_line_can() -> None:
    """A scan-angle offset known to half a degree leaves roll at half a degree, whoever sails."""
    points, held = survey(), Parameter("scan_angle_offset", np.radians(0.5))
    result = adjust(points, PRIOR, StochasticModel(), parameters=(held,))
    assert result.sigma[0] > 0.9 * np.radians(0.5)
    best = min(line.sigma[0] for line in further_lines(points, result))
    assert best > 0.95 * result.sigma[0]
    found = further_line_advice(points, result)
    assert found[0] == note(
        "further_line.prior",
        angle=note("quantity.roll"), parameters=(note("quantity.scan_angle_offset"),),
    )  # fmt: skip
    assert "further_line.insufficient" not in [each.code for each in found]


def test_the_advice_goes_on_to_the_angle_that_data_can_help() -> None:
    """What is known as well as a stated value, and no better, is named; a line is for the next."""
    courses = six_courses()[:2] + six_courses()[4:5]
    points, model = survey(courses=courses), StochasticModel(surface=0.0)
    held = Parameter("scan_angle_offset", np.radians(0.5))
    plain = further_line_advice(points, adjust(points, PRIOR, model))
    first, *rest = further_line_advice(points, adjust(points, PRIOR, model, parameters=(held,)))
    assert len(plain) == 1
    assert plain[0].params.keys() >= {"heading", "then"}
    assert first.code == "further_line.prior"
    assert list(map(english_text, rest)) == list(map(english_text, plain))


def test_a_given_value_that_matters_little_leaves_the_advice_as_it_is() -> None:
    points, held = survey(), Parameter("scan_angle_offset", np.radians(0.002))
    result = adjust(points, PRIOR, StochasticModel(), parameters=(held,))
    assert [each.value for each in result.parameters] == [None]
    assert "further_line.prior" not in [each.code for each in further_line_advice(points, result)]


def test_the_classical_model_is_advised_without_what_it_does_not_estimate() -> None:
    points, held = survey(), Parameter("scan_angle_offset", np.radians(0.5))
    model = StochasticModel("independent")
    plain = adjust(points, PRIOR, model)
    assert further_line_advice(
        points, adjust(points, PRIOR, model, parameters=(held,))
    ) == further_line_advice(points, plain)


def test_a_further_line_says_on_which_side_and_how_far_off_the_targets_are() -> None:
    """The boards lie west of where the vessel passes, 11 to 15 m from the lines."""
    courses = six_courses()[:2] + six_courses()[4:5]
    points = survey(courses=courses)
    result = adjust(points, PRIOR, StochasticModel(surface=0.0))
    lines = {round(np.degrees(line.heading)): line for line in further_lines(points, result)}
    assert not lines[0].to_starboard  # northward, west is to port
    assert lines[180].to_starboard
    assert all(10.5 < line.distance < 15.5 for line in lines.values())
    (found,) = further_line_advice(points, result)
    best = lines[round(np.degrees(found.params["heading"]))]
    side = "starboard" if best.to_starboard else "port"
    assert found.code == f"further_line.{side}_of_face"
    assert found.params["distance"] == best.distance


def test_parts_are_compared_without_what_none_of_them_sees() -> None:
    points, held = survey(), Parameter("scan_angle_offset", np.radians(0.5))
    plain = adjust(points, PRIOR, StochasticModel())
    result = adjust(points, PRIOR, StochasticModel(), parameters=(held,))
    expected = cross_checks(points, PRIOR, plain)
    found = cross_checks(points, PRIOR, result, (held,))
    for one, other in zip(expected.parts, found.parts, strict=True):
        np.testing.assert_allclose(other.significance, one.significance, rtol=0.05, atol=0.05)


@pytest.mark.parametrize("weight", [-1e-9, 0.0, np.nan])
def test_an_unknown_without_weight_is_refused(weight: float) -> None:
    """Also one whose weight rounding has made negative, beside large ones that it goes with."""
    with pytest.raises(RankDeficient, check=has_code("adjustment.singular")):
        scaled_inverse(np.array([[weight, 1e3], [1e3, 1e10]]))
