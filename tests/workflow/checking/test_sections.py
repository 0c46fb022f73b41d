"""Tests of sections through lines and of distances and angles between points."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lispac.errors import InputError, ProjectError
from lispac.geometry.point_measurements import measure_angle, measure_distance
from lispac.geometry.rotations import rotation_matrix
from lispac.project import Project
from lispac.targets.cross_section import (
    Section,
    common_normal,
    section_across_target,
    section_between,
)
from lispac.workflow.checking.survey_sections import (
    cut_between_points,
    normal_in_picture,
    section_at_target,
)
from lispac.workflow.project.survey import Survey
from tests.support.error_codes import has_code

numbers = st.floats(-100, 100)
places = st.tuples(numbers, numbers, numbers).map(np.array)


def sorted_rows(points: np.ndarray) -> np.ndarray:
    return points[np.lexsort(points.T)]


def test_a_long_strip_is_read_in_pieces_with_every_point_once(
    calibrated: tuple[Project, Survey],
) -> None:
    _, survey = calibrated
    cloud = survey.clouds[survey.lines[0]]
    middle = np.median(cloud.sample, axis=0)
    section = section_between(
        middle - [6.0, 0.5, 0.0], middle + [6.0, 0.5, 0.0], height=1.5, thickness=0.6
    )  # fmt: skip
    whole = section.to_section_axes(cloud.sample)
    assert len(whole) > 1000
    np.testing.assert_array_equal(sorted_rows(section.cut_points(cloud)), sorted_rows(whole))
    assert (np.abs(whole) <= [section.width / 2, section.height / 2]).all()


def test_section_axes_keep_the_scale() -> None:
    section = Section(np.array([5.0, -3.0, 1.0]), np.array([0.6, 0.8, 0.0]),
                      np.array([0.0, 0.0, 1.0]), 4.0, 2.0, 0.1)  # fmt: skip
    right, up, across = 1.25, -0.75, 0.04
    point = section.centre + right * section.right + up * section.up + across * section.across
    np.testing.assert_allclose(section.to_section_axes(point[None]), [[right, up]], atol=1e-14)
    assert len(section.to_section_axes((point + 0.02 * section.across)[None])) == 0
    assert len(section.to_section_axes((point + section.right)[None])) == 0


@pytest.mark.parametrize("level", [False, True])
def test_vessel_is_left_of_or_below_the_board(level: bool) -> None:
    centre, eye = np.array([10.0, 20.0, 3.0]), np.array([0.0, 0.0, 5.0])
    for sign in (-1, 1):
        normal = sign * np.array([0.6, 0.8, 0.0])
        section = section_across_target(centre, normal, eye, level=level)
        ahead = section.up if level else section.right
        np.testing.assert_allclose(ahead, [0.6, 0.8, 0.0], atol=1e-15)
        np.testing.assert_allclose(np.cross(section.right, section.up), section.across)
    # A horizontal target has no horizontal direction: the strip leads away from the vessel.
    flat = section_across_target(centre, np.array([0.02, 0.0, 1.0]), eye)
    np.testing.assert_allclose(flat.right, np.array([1, 2, 0]) / np.sqrt(5), atol=1e-15)


def test_common_normal_ignores_offsets_between_groups() -> None:
    rng = np.random.default_rng(1)
    board = np.column_stack([rng.normal(0, 0.002, 500), rng.uniform(-0.6, 0.6, (500, 2))])
    # A plane through all the shifted groups would be rotated by 40 degrees.
    groups = [board, board + [0.5, 0.6, 0.0], board + [1.0, 1.2, 0.0]]
    np.testing.assert_allclose(np.abs(common_normal(groups)), [1, 0, 0], atol=0.01)


def test_misalignment_is_visible_only_before_the_calibration(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    for level in (False, True):
        before, after = section_at_target(project, survey, "T1", level=level)
        assert (before.which, after.which) == ("prior", "estimated")
        assert after.spread < 0.04 < 0.15 < before.spread
        for cut in (before, after):
            assert set(cut.points) == set(survey.lines)
            clouds = survey.placed(project, cut.which)
            for line, points in cut.points.items():
                np.testing.assert_allclose(
                    sorted_rows(points),
                    sorted_rows(cut.section.to_section_axes(clouds[line].sample)), atol=1e-9,
                )  # fmt: skip
            # Trace of the board on each line near the middle
            strokes = [
                np.median(points[np.abs(points[:, 1 - level]) < 0.3][:, int(level)])
                for points in cut.points.values()
                if len(points)
            ]
            assert np.ptp(strokes) == pytest.approx(cut.spread, abs=0.03)


def test_the_distance_of_a_section_is_that_of_the_means_of_whole_sightings(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    target = project.target("T1")
    for cut in section_at_target(project, survey, "T1", offset=0.3):
        groups = {
            which: [survey.placed(project, which)[s.line][s.indices] for s in target.sightings]
            for which in (cut.which, "estimated")
        }
        along = [points.mean(axis=0) @ common_normal(groups["estimated"])
                 for points in groups[cut.which]]  # fmt: skip
        assert cut.spread == pytest.approx(np.ptp(along), abs=1e-9)


def test_the_normal_in_a_section_points_to_the_vessel(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    for target in project.targets:
        if target.shape != "plane":
            continue
        (own, *_) = [survey.scans[each.line] for each in target.sightings if len(each.indices)]
        vessel = survey.trajectory.at(np.array([own.first_time])).position[0]
        for cut in section_at_target(project, survey, target.name):
            if cut.normal is not None:
                seen = [(vessel - cut.section.centre) @ axis
                        for axis in (cut.section.right, cut.section.up)]  # fmt: skip
                assert np.dot(cut.normal, seen) > 0, target.name


def test_distances_across_a_plane_are_enlarged_by_its_slope_in_the_section(
    calibrated: tuple[Project, Survey],
) -> None:
    """A steep plane is enlarged in both sections."""
    project, survey = calibrated
    name = project.targets_of_role("validation")[0].name
    for cut in section_at_target(project, survey, name, level=True):
        assert cut.normal is not None
        assert cut.automatic_exaggeration() > 1
    after = section_at_target(project, survey, name)[-1]
    assert after.spread is not None
    flat = replace(after, normal=None)
    assert flat.automatic_exaggeration() == 1
    assert after.normal is not None
    oblique = replace(after, normal=0.6 * after.normal)
    assert oblique.automatic_exaggeration() <= after.automatic_exaggeration()


def test_sections_without_a_result_show_the_prior_only(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    alone = replace(project, result=None)
    assert [cut.which for cut in section_at_target(alone, survey, "T1")] == ["prior"]
    middle = np.median(survey.clouds[survey.lines[0]].sample, axis=0)
    (cut,) = cut_between_points(alone, survey, middle, middle + [3.0, 0.0, 0.5])
    assert cut.spread is None
    assert cut.section.width == pytest.approx(3.0)
    assert cut.section.height == pytest.approx(3.0)


def test_impossible_sections_are_refused(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    with pytest.raises(InputError, check=has_code("target.section_vertical")):
        section_between(np.zeros(3), np.array([0.0, 0.0, 4.0]))
    with pytest.raises(ProjectError, check=has_code("project.no_target", name="T9")):
        section_at_target(project, survey, "T9")
    bare = project.with_target(replace(project.target("T1"), sightings=()))
    with pytest.raises(ProjectError) as raised:
        section_at_target(bare, survey, "T1")
    assert raised.value.code == "section.no_points"


@given(places, places)
def test_a_distance_has_components_and_a_reverse_azimuth(
    first: np.ndarray, second: np.ndarray
) -> None:
    there, back = measure_distance(first, second), measure_distance(second, first)
    assert there.slope == pytest.approx(np.linalg.norm(second - first))
    assert there.slope == pytest.approx(np.hypot(there.horizontal, there.vertical))
    assert there.vertical == -back.vertical
    assert there.horizontal == back.horizontal
    if there.horizontal:
        turned = (there.azimuth - back.azimuth) % (2 * np.pi)
        assert turned == pytest.approx(np.pi)


@pytest.mark.parametrize(
    ("way", "azimuth_deg"),
    [((2, 0, 0), 0), ((0, -2, 0), 90), ((-2, 0, 0), 180), ((0, 2, 0), 270), ((0, 0, 2), 0)],
)
def test_azimuths_are_clockwise_from_north_and_undefined_vertically(
    way: tuple[int, ...], azimuth_deg: float
) -> None:
    found = measure_distance(np.ones(3), np.ones(3) + way)
    assert np.degrees(found.azimuth) == pytest.approx(azimuth_deg)
    assert (found.slope, found.vertical) == (2.0, way[2])


@given(st.floats(0, np.pi), places, st.floats(-3, 3), st.floats(-1.5, 1.5), st.floats(-3, 3))
def test_angles_do_not_depend_on_orientation(
    turned: float, corner: np.ndarray, roll: float, pitch: float, heading: float
) -> None:
    rotation = rotation_matrix(roll, pitch, heading)
    sides = np.array([[2.0, 0.0, 0.0], [3.0 * np.cos(turned), 3.0 * np.sin(turned), 0.0]])
    first, second = corner + sides @ rotation.T
    assert measure_angle(first, corner, second) == pytest.approx(turned, abs=1e-6)
    with pytest.raises(InputError, check=has_code("target.angle_same_points")):
        measure_angle(corner, corner, second)


def test_a_roof_has_no_direction_across_in_a_horizontal_section() -> None:
    section = section_across_target(
        np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([0.0, -20.0, 5.0]), level=True
    )
    assert normal_in_picture(np.array([0.0, 0.0, 1.0]), section) is None
    upright = section_across_target(
        np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([0.0, -20.0, 5.0])
    )
    seen = normal_in_picture(np.array([0.0, 0.0, 1.0]), upright)
    assert seen == pytest.approx([0.0, 1.0])
