"""Tests of shifts of lines and of two modes on validation planes, on surveys with known errors."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.messages import Message
from lispac.present.checking.validation import ValidationPlane
from lispac.project import Project
from lispac.report.validation_warnings import FALSE_WARNING_LEVEL, distribution_warnings
from lispac.simulation.closed_form_survey import (
    Board,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import place_points
from lispac.survey.trajectory import Poses
from lispac.validation.line_shifts import LineErrors, PlaneErrors
from lispac.validation.normal_distance import NormalDistances
from lispac.validation.plane_comparison import PlaneComparison, compare_plane
from lispac.validation.two_modes import find_two_modes
from lispac.workflow.checking.validation import validate
from lispac.workflow.project.survey import Survey
from tests.studies.coverage_of_errors import MODEL, PRIOR, TARGETS, TRUTH
from tests.support.long_runs import LONG
from tests.support.report_sample import sample_project

VALIDATION_BOARDS = (
    Board("V1", (2.0, 16.0, 4.0), (0.0, -1.0, 0.0), 3.0, 2.0),
    Board("V2", (-3.0, 18.0, 3.0), (-0.5, -1.0, 0.3), 3.0, 2.0),
    Board("V3", (0.0, 14.0, 1.5), (0.0, -1.0, 1.0), 3.0, 2.0),
)
ROLL, PITCH_AND_YAW = (1.0, 0.0, 0.0), (0.0, 1.0, 1.0)
SPACING = 0.06
HEADINGS = {course.name: course.heading for course in six_courses()}
Change = Callable[[Observations], Observations]


def unchanged(data: Observations) -> Observations:
    return data


def validated(
    seed: int,
    *,
    change: Change = unchanged,
    boresight_error_deg: float = 0.0,
    angles: tuple[float, float, float] = PITCH_AND_YAW,
    lines: tuple[str, ...] = (),
) -> tuple[PlaneComparison, ...]:
    """Estimate from the targets of a simulated survey, and compare the lines on other boards.

    ``change`` is an error of the observations of the boards, after the estimation.
    """
    chance = np.random.default_rng(seed)
    exact = error_free_survey(TRUTH, (*TARGETS, *VALIDATION_BOARDS), six_courses(), SPACING, chance)
    data = add_errors(exact, HYDROGRAPHIC_INS, chance)
    names = np.array([sighting.target for sighting in data.sightings])
    of_targets = np.flatnonzero(np.char.startswith(names, "T"))
    averaged = average_points_in_cells(
        part_of(data, of_targets), PRIOR, 0.1, longest=MODEL.knot_interval, no_outliers=True
    )
    result = adjust(averaged, PRIOR, MODEL, diagnostics=False)
    wrong = result.boresight + np.radians(boresight_error_deg) * np.array(angles)
    result = replace(result, mounting=result.mounting.with_boresight(wrong))
    compared_lines = np.array([not lines or each.line in lines for each in data.sightings])
    boards = change(data)
    return tuple(
        compared(boards, np.flatnonzero((names == board.name) & compared_lines), result, board)
        for board in VALIDATION_BOARDS
    )


def part_of(data: Observations, sightings: np.ndarray) -> Observations:
    kept = np.isin(data.sighting, sightings)
    numbers = np.zeros(len(data.sightings), dtype=int)
    numbers[sightings] = np.arange(len(sightings))
    return replace(
        data,
        **{
            name: getattr(data, name)[kept]
            for name in (
                "points_lidar", "position", "attitude", "sigma_lidar", "sigma_position",
                "sigma_attitude", "time",
            )
        },
        sighting=numbers[data.sighting[kept]],
        sightings=tuple(data.sightings[k] for k in sightings),
    )  # fmt: skip


def compared(data: Observations, sightings: np.ndarray, result, board: Board) -> PlaneComparison:
    before, after, errors = {}, {}, {}
    for k in sightings:
        own, line = data.sighting == k, data.sightings[k].line
        poses = Poses(data.position[own], data.attitude[own])
        before[line] = place_points(data.points_lidar[own], poses, PRIOR)
        after[line] = place_points(data.points_lidar[own], poses, result.mounting)
        errors[line] = LineErrors.of(
            result, data.points_lidar[own], data.time[own], poses,
            (data.sigma_position[own], data.sigma_attitude[own]), board.facing,
        )  # fmt: skip
    plane_errors = PlaneErrors(errors, (MODEL.position_time, MODEL.attitude_time))
    return compare_plane(
        board.name, before, after, HEADINGS, facing=board.facing, errors=plane_errors
    )


def warnings_of(planes: tuple[PlaneComparison, ...]) -> list[Message]:
    return list(distribution_warnings([ValidationPlane.of(each) for each in planes]))


def ratios_of(planes: tuple[PlaneComparison, ...]) -> list[float]:
    return [shift.offset / shift.sigma for plane in planes for shift in plane.shifts]


@LONG
def test_right_surveys_give_no_warning_and_offsets_within_their_sigmas() -> None:
    ratios = []
    for seed in range(4):
        planes = validated(seed)
        assert warnings_of(planes) == []
        ratios += ratios_of(planes)
    assert len(ratios) == 4 * len(VALIDATION_BOARDS) * 9  # six lines, and three groups
    assert 0.3 < np.sqrt(np.mean(np.square(ratios))) < 1.1


@pytest.mark.long
def test_right_surveys_seldom_give_a_warning() -> None:
    surveys = 300
    false = sum(bool(warnings_of(validated(seed))) for seed in range(1000, 1000 + surveys))
    print(f"\nfalse warnings in {surveys} surveys: {false}")
    assert false <= FALSE_WARNING_LEVEL * surveys + 2.3 * np.sqrt(FALSE_WARNING_LEVEL * surveys)


@LONG
def test_a_wrong_boresight_divides_the_lines_into_two_groups() -> None:
    found = warnings_of(validated(1, boresight_error_deg=0.3))
    assert {each.code for each in found} == {"validation.groups_shifted"}
    assert {each.params["target"] for each in found} >= {"V1", "V2"}
    # Pitch and yaw of the same size shift the two diagonal courses in opposite directions.
    for each in found:
        sides = [set(each.params["lines"]), set(each.params["others"])]
        assert any({"L3", "L4"} <= side for side in sides)
        assert any({"L5", "L6"} <= side for side in sides)
        assert each.params["offset"] > each.params["limit"] > 0


def test_two_reciprocal_lines_with_a_wrong_boresight_are_named_as_directions() -> None:
    found = warnings_of(validated(1, boresight_error_deg=0.5, lines=("L3", "L4"), angles=ROLL))
    assert "validation.directions_shifted" in {each.code for each in found}
    for each in found:
        assert {*each.params["lines"], *each.params["others"]} == {"L3", "L4"}


def test_a_biased_line_is_named() -> None:
    def shifted(data: Observations) -> Observations:
        own = np.array([each.line == "L3" for each in data.sightings])[data.sighting]
        return replace(data, position=data.position + own[:, None] * np.array([0.0, 0.15, 0.0]))

    found = warnings_of(validated(2, change=shifted))
    of_line = [each for each in found if each.code == "validation.line_shifted"]
    assert "V1" in {each.params["target"] for each in of_line}
    assert {each.params["line"] for each in of_line} == {"L3"}
    for each in of_line:
        assert each.params["offset"] == pytest.approx(0.15, abs=0.06)
        assert "L3" not in each.params["others"]


@LONG
def test_a_jump_of_the_trajectory_within_a_line_gives_two_modes() -> None:
    def jumped(data: Observations) -> Observations:
        own = np.array([s.line == "L5" for s in data.sightings])[data.sighting]
        late = np.zeros(len(own), dtype=bool)
        for k, sighting in enumerate(data.sightings):
            part = data.sighting == k
            if sighting.line == "L5":
                late |= part & (data.time > np.median(data.time[part]))
        return replace(
            data, position=data.position + (own & late)[:, None] * np.array([0.0, 0.12, 0.0])
        )

    planes = validated(3, change=jumped)
    found = [each for each in warnings_of(planes) if each.code == "validation.two_modes"]
    assert found
    for each in found:
        assert "L5" in (each.params["line"], each.params["other"])
        assert each.params["share"] > 0.2
        assert each.params["distance"] > each.params["limit"]


def _distances(values: np.ndarray) -> NormalDistances:
    count = len(values)
    return NormalDistances(
        np.zeros((count, 3)), values, np.full(count, 0.002), 0, np.zeros((count, 3)),
        np.arange(count),
    )  # fmt: skip


@pytest.mark.parametrize(
    "draw",
    [
        lambda chance: chance.normal(0, 0.01, 200),
        lambda chance: chance.uniform(-0.01, 0.01, 200),
        lambda chance: np.r_[chance.normal(0, 0.001, 195), chance.uniform(0.05, 0.1, 5)],
        lambda chance: chance.exponential(0.01, 200),
    ],
    ids=["normal", "uniform, as with a tilt", "outliers", "exponential"],
)
def test_one_mode_is_seldom_taken_for_two(draw) -> None:
    chance = np.random.default_rng(5)
    found = [find_two_modes(_distances(draw(chance)), 0.0) for _ in range(500)]
    # Three standard deviations of a share of 1 % in 500 draws
    assert sum(each is not None for each in found) <= 12


def test_two_modes_have_their_distance_and_share() -> None:
    chance = np.random.default_rng(6)
    values = np.r_[chance.normal(0.0, 0.002, 150), chance.normal(0.03, 0.002, 50)]
    found = find_two_modes(_distances(values), 0.004)
    assert found is not None
    assert found.distance == pytest.approx(0.03, abs=0.001)
    assert found.share == pytest.approx(0.25, abs=0.01)
    assert found.sigma == pytest.approx(0.004, abs=0.0005)
    assert found.probability < 1e-6


def test_equal_distances_have_one_mode() -> None:
    assert find_two_modes(_distances(np.zeros(50)), 0.0) is None


def test_a_validated_project_names_lines_that_a_wrong_boresight_shifts(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    assert all(plane.shifts for plane in project.validation)
    assert warnings_of(project.validation) == []
    assert project.result is not None
    mounting = project.result.mounting
    wrong = mounting.with_boresight(mounting.boresight + np.radians([0.0, 0.25, 0.0]))
    planes = tuple(
        replace(target, used=target.role == "target" or target.name == "V2")
        for target in project.targets
    )
    worse = replace(project, targets=planes, result=replace(project.result, mounting=wrong))
    found = warnings_of(validate(worse, survey).validation)
    (one,) = found
    assert one.params["target"] == "V2"
    # Pitch moves points at the height of the planes by the sign of the heading.
    assert one.code in ("validation.directions_shifted", "validation.groups_shifted")


def test_planes_of_earlier_versions_have_no_shifts_and_no_warnings(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    assert all(plane.shifts == () for plane in project.validation)
    assert warnings_of(project.validation) == []


def test_a_plane_with_few_points_is_not_compared_as_before(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    kept = []
    for target in project.targets:
        sightings = tuple(
            replace(each, indices=each.indices[: 0 if k else 5])
            for k, each in enumerate(target.sightings)
        )
        is_cut = target.name == "V1"
        use = target.role == "target" or target.name in ("V1", "V2")
        kept.append(replace(target, used=use, sightings=sightings if is_cut else target.sightings))
    found = validate(replace(project, targets=tuple(kept)), survey)
    assert found.not_compared["V1"].code == "validation.plane_in_no_line"
    assert [plane.name for plane in found.validation] == ["V2"]
