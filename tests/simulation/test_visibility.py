"""Tests of the visibility criteria of the thesis, against its text and closed formulas."""

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.geometry.planes import Plane, plane_through
from lispac.present.planning.visibility import CRITERIA, fewest_lines_text
from lispac.report.visibility_figures import visibility_figure
from lispac.simulation.closed_form_survey import Course
from lispac.simulation.thesis_comparison import compare_with_thesis, do_fewest_lines_agree
from lispac.simulation.thesis_site import (
    ERROR_FREE_MOUNTING,
    ERROR_SIZES,
    HEADINGS_DEG,
    LINES,
    MARINE_SITE,
    TERRESTRIAL_SITE,
    board_plane,
    is_on_board,
    mounting_with_error,
    simulate_board,
)
from lispac.simulation.visibility_criteria import (
    PointsShape,
    angular_deviation,
    centroidal_distance,
    normalise_distances,
    orthogonal_distance,
    points_shape,
    type_one_criterion,
)
from lispac.simulation.visibility_study import TYPE_ONE_THRESHOLD, VisibilityStudy, study_visibility
from lispac.survey.georeferencing import place_points, to_lidar
from lispac.survey.trajectory import Poses
from tests.cli.test_cli import run, run_json
from tests.support.long_runs import LONG, others_long

ERROR = float(np.radians(2.0))
UPRIGHT_BOARD = MARINE_SITE.board(0.0)


@pytest.fixture(scope="module")
def terrestrial() -> VisibilityStudy:
    return study_visibility(TERRESTRIAL_SITE)


@pytest.fixture(scope="module")
def marine() -> VisibilityStudy:
    return study_visibility(MARINE_SITE)


def cloud(error: str, heading: int, inclination_deg: float = 0.0, share: float = 1.0) -> np.ndarray:
    """Return the points of the board of the marine site on one line."""
    course = LINES[HEADINGS_DEG.index(heading)]
    return simulate_board(
        MARINE_SITE, course, np.radians(inclination_deg), mounting_with_error(error, share)
    )


def apart(error: str, headings: tuple[int, int], share: float = 1.0) -> tuple[float, float]:
    """Return offset (metres) and angle (degrees) between two lines on the upright board."""
    one, other = (points_shape(cloud(error, heading, share=share)) for heading in headings)
    reference = board_plane(UPRIGHT_BOARD)
    shift = orthogonal_distance(one, reference) - orthogonal_distance(other, reference)
    return abs(shift), float(np.degrees(one.plane.tilt_to(other.plane)))


# --- the criteria themselves


def test_a_board_is_planar_but_a_stick_or_a_ball_is_not() -> None:
    rng = np.random.default_rng(1)
    grid = np.array([(u, v, 0.0) for u in range(21) for v in range(21)])
    assert points_shape(grid).planarity == pytest.approx(1.0)
    assert points_shape(grid * [1.0, 0.1, 1.0]).planarity == pytest.approx(0.01)
    assert points_shape(rng.normal(size=(20000, 3))).planarity < 0.05


def test_distances_are_normalised_as_in_equation_3_4() -> None:
    assert normalise_distances(np.array([0.2, 0.3, 0.7])) == pytest.approx([0.0, 0.2, 1.0])
    assert np.isnan(normalise_distances(np.array([0.2, np.nan, 0.7]))[1])
    assert normalise_distances(np.full(3, 0.1)) == pytest.approx([0.0, 0.0, 0.0])
    found = type_one_criterion(np.array([1.0, 0.5, 1.0, np.nan]), np.array([0.0, 0.5, 1.0, np.nan]))
    assert found == pytest.approx([1.0, 0.25, 0.0, 0.0])


def test_deviations_of_a_rotated_and_shifted_plane() -> None:
    """For both directions of the normal, and far from the origin (figure 3.10 omits d)."""
    turned = Plane(np.array([0.0, -np.cos(0.1), np.sin(0.1)]), 0.0)
    reference = plane_through(np.array([0.0, 15.0, 5.0]), np.array([0.0, -1.0, 0.0]))
    centroid = np.array([3.0, 14.8, 7.0])
    for plane in (turned, turned.flipped()):
        shape = PointsShape(centroid, np.array([1.0, 1.0, 0.0]), plane)
        assert angular_deviation(shape, reference) == pytest.approx(0.1)
        assert orthogonal_distance(shape, reference) == pytest.approx(0.2)
    assert centroidal_distance(shape, np.array([3.0, 15.0, 5.0])) == pytest.approx(np.sqrt(4.04))


def test_point_on_board_matches_the_area_test_of_the_thesis() -> None:
    """Section 3.4.3: the four triangles to the corners have the area of the board."""
    rng = np.random.default_rng(2)
    board = TERRESTRIAL_SITE.board(np.radians(-40.0))
    normal, centre = np.array(board.normal), np.array(board.centre)
    up = np.cross(np.array([1.0, 0.0, 0.0]), normal)
    axes = np.array([[1.0, 0.0, 0.0], up])
    corners = centre + np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]) @ axes
    points = centre + rng.uniform(-0.8, 0.8, (500, 2)) @ axes
    sides = [corners[k] - points for k in range(4)], [corners[k - 3] - points for k in range(4)]
    areas = sum(np.linalg.norm(np.cross(a, b), axis=1) / 2 for a, b in zip(*sides, strict=True))
    assert 100 < np.sum(areas < 1 + 1e-9) < 400
    assert np.array_equal(is_on_board(points, board), areas < 1 + 1e-9)


# --- the simulated points


def test_a_roll_error_rotates_an_upright_board_about_the_line() -> None:
    """Points (y, z) are on the line y cos e - z sin e = r, where e is the roll error.

    A positive roll error raises beams to the left. The board is hit higher than the recorded angle,
    so its points appear too low: the board appears rotated about the scanner by e at any range.
    """
    reference = board_plane(UPRIGHT_BOARD)
    points = cloud("roll", 0)
    assert points[:, 1] * np.cos(ERROR) - points[:, 2] * np.sin(ERROR) == pytest.approx(
        np.full(len(points), 15.0), abs=1e-9
    )
    shape = points_shape(points)
    assert angular_deviation(shape, reference) == pytest.approx(ERROR, abs=1e-9)
    shift = 15.0 - (15.0 + shape.centroid[2] * np.sin(ERROR)) / np.cos(ERROR)
    assert orthogonal_distance(shape, reference) == pytest.approx(shift, abs=1e-9)
    assert shift == pytest.approx(-5.5 * ERROR, rel=0.1), "to first order height times angle"


@pytest.mark.parametrize("heading", HEADINGS_DEG)
def test_a_lever_arm_error_shifts_the_board_along_its_normal(heading: int) -> None:
    turn = np.radians(heading)
    for error, axis in {
        "lever_x": (np.cos(turn), -np.sin(turn), 0.0),
        "lever_y": (np.sin(turn), np.cos(turn), 0.0),
        "lever_z": (0.0, 0.0, 1.0),
    }.items():
        shape, board = (
            points_shape(cloud(error, heading, 30.0)),
            MARINE_SITE.board(np.radians(30.0)),
        )
        reference = board_plane(board)
        # Points computed without the error are shifted by minus the error.
        expected = -0.1 * np.dot(axis, board.normal)
        assert orthogonal_distance(shape, reference) == pytest.approx(expected, abs=1e-9)
        assert angular_deviation(shape, reference) == pytest.approx(0.0, abs=1e-7)


def truly(points: np.ndarray, course: Course, error: str) -> np.ndarray:
    """Return the true positions of points that were georeferenced without the error."""
    # Profiles are normal to the line, so the scanner was abeam of the computed point.
    attitude = np.tile([0.0, 0.0, course.heading], (len(points), 1))
    poses = Poses((points @ course.direction)[:, None] * course.direction, attitude)
    return place_points(
        to_lidar(points, poses, ERROR_FREE_MOUNTING), poses, mounting_with_error(error)
    )


@pytest.mark.parametrize("error", ERROR_SIZES)
def test_true_points_are_on_the_board(error: str) -> None:
    course, board = LINES[2], TERRESTRIAL_SITE.board(0.3)
    points = simulate_board(TERRESTRIAL_SITE, course, 0.3, mounting_with_error(error), "struck")
    assert len(points) > 100
    true = truly(points, course, error)
    assert board_plane(board).distances(true) == pytest.approx(np.zeros(len(true)), abs=1e-9)
    assert is_on_board(true, board).all()
    assert np.abs(board_plane(board).distances(points)).max() > 1e-3, "but not as placed"


def test_deviations_are_zero_without_an_error() -> None:
    for course in LINES:
        points = simulate_board(TERRESTRIAL_SITE, course, -0.5, mounting_with_error("roll", 0.0))
        shape, board = points_shape(points), TERRESTRIAL_SITE.board(-0.5)
        assert orthogonal_distance(shape, board_plane(board)) == pytest.approx(0.0, abs=1e-12)
        assert angular_deviation(shape, board_plane(board)) == pytest.approx(0.0, abs=1e-7)
        assert is_on_board(points, board).all()


# --- what section 4.4.1.1 states of an upright board


@pytest.mark.parametrize(
    ("headings", "shown", "hidden"),
    [
        ((0, 180), ["roll"], ["pitch", "yaw"]),
        ((45, 225), ["roll", "pitch"], ["yaw"]),
        ((315, 135), ["roll", "pitch"], ["yaw"]),
        ((45, 135), ["yaw"], ["pitch"]),
        ((315, 225), ["yaw"], ["pitch"]),
    ],
)
def test_pairs_of_lines_reveal_or_conceal_errors_of_angles(
    headings: tuple[int, int], shown: list[str], hidden: list[str]
) -> None:
    for error in shown:
        shift, turn = apart(error, headings)
        assert shift > (0.5 if error == "yaw" else 0.25), (error, shift)
        # A yaw error rotates the board about the vertical in the same direction on both lines.
        assert turn < 0.1 if error == "yaw" else turn > 2.8, (error, turn)
    for error in hidden:
        assert apart(error, headings) == pytest.approx((0.0, 0.0), abs=1e-6), error


def test_no_pair_of_lines_reveals_the_z_lever_arm(terrestrial: VisibilityStudy) -> None:
    shift, turn = terrestrial.visibility_spread("lever_z")
    is_visible = np.isfinite(shift)
    assert is_visible.sum() == 14
    assert shift[is_visible] == pytest.approx(np.zeros(14), abs=1e-9)
    assert np.degrees(turn[is_visible]) == pytest.approx(np.zeros(14), abs=1e-5)
    # The error shifts all lines equally.
    off = terrestrial.orthogonal_distance[TERRESTRIAL_SITE.errors.index("lever_z"), 0]
    assert np.nanmax(np.abs(off)) == pytest.approx(0.1, abs=1e-9)


def test_a_scan_angle_offset_acts_like_roll(terrestrial: VisibilityStudy) -> None:
    """Section 3.5.2: both rotate the points in the same way."""
    roll, scan = (TERRESTRIAL_SITE.errors.index(name) for name in ("roll", "scan_angle_offset"))
    for values in (terrestrial.orthogonal_distance, terrestrial.angular_deviation):
        assert values[roll] == pytest.approx(values[scan], abs=1e-9, nan_ok=True)


# --- Type I


def test_type_one_is_strong_at_minus_60_and_weak_at_60(terrestrial: VisibilityStudy) -> None:
    """Figure 3.9 and section 3.4.4.1: deviations are largest where the board is along the beams."""
    at = {round(np.degrees(each)): j for j, each in enumerate(TERRESTRIAL_SITE.inclinations)}
    roll = TERRESTRIAL_SITE.errors.index("roll")
    assert terrestrial.type_one[roll, :, at[-60]].min() > TYPE_ONE_THRESHOLD
    assert terrestrial.type_one[roll, :, at[60]].max() < 0.5
    farthest = np.nanargmax(terrestrial.centroidal_distance[roll, 2])
    assert np.degrees(TERRESTRIAL_SITE.inclinations[farthest]) == pytest.approx(40.0)


def test_points_on_a_real_board_move_at_most_by_range_times_error() -> None:
    """Beams aimed at the nominal board deviate more at grazing incidence."""
    course, mounting = LINES[3], mounting_with_error("roll")
    for degrees in (-60, 0, 30, 40):
        points = simulate_board(TERRESTRIAL_SITE, course, np.radians(degrees), mounting, "struck")
        moved = np.linalg.norm(points - truly(points, course, "roll"), axis=1)
        assert len(points) > 20
        assert moved.max() < 6.0 * ERROR
    aimed = simulate_board(TERRESTRIAL_SITE, course, np.radians(40), mounting)
    centre = np.array(TERRESTRIAL_SITE.board(np.radians(40)).centre)
    assert centroidal_distance(points_shape(aimed), centre) > 1.0


# --- tables 3.1 to 3.3 and section 3.9


def test_pitch_has_the_possible_configurations_of_table_3_1(terrestrial: VisibilityStudy) -> None:
    best = terrestrial.best_configuration("pitch")
    assert set(map(frozenset, best.groups)) == {
        frozenset((0, 180)), frozenset((45, 135)), frozenset((225, 315)),
    }  # fmt: skip
    assert np.degrees([best.kept[0], best.kept[-1]]) == pytest.approx([-90.0, 20.0])


def test_best_configurations_compared_with_table_3_2(terrestrial: VisibilityStudy) -> None:
    """As computed, the lines agree for all eight errors and the inclination for five."""
    rows = {each.best.error: each for each in compare_with_thesis(terrestrial)}
    assert all(each.lines_agree for each in rows.values())
    differing = {error for error, each in rows.items() if not each.inclination_agrees}
    assert differing == {"roll", "range_offset", "scan_angle_offset"}
    assert all(bool(rows[error].reason) == (error in differing) for error in rows)
    assert rows["lever_z"].best.inclination is None


@LONG
@pytest.mark.parametrize("distance", others_long([4.0, 8.0]))
def test_the_comparison_does_not_depend_on_values_missing_in_the_thesis(distance: float) -> None:
    """The thesis gives no distance for its terrestrial site; other values give the same results."""
    site = replace(
        TERRESTRIAL_SITE, distance=distance, angle_step=float(np.radians(0.4)), profile_spacing=0.07
    )
    found = study_visibility(site)
    rows = compare_with_thesis(found)
    assert all(each.lines_agree for each in rows)
    assert [each.best.error for each in rows if not each.inclination_agrees] == [
        "roll", "range_offset", "scan_angle_offset",
    ]  # fmt: skip
    assert do_fewest_lines_agree(found)


def test_lines_for_all_errors_equal_those_of_table_3_3(terrestrial: VisibilityStudy) -> None:
    assert do_fewest_lines_agree(terrestrial)
    assert "the same as the 4" in fewest_lines_text(terrestrial)


@LONG
def test_the_marine_site_compared_with_section_3_9(marine: VisibilityStudy) -> None:
    rows = {each.best.error: each for each in compare_with_thesis(marine)}
    assert all(each.lines_agree for each in rows.values())
    assert {error for error, each in rows.items() if not each.inclination_agrees} == {"roll"}
    # Among the inclinations of the thesis, the upright one is best for all three.
    for error in MARINE_SITE.errors:
        assert marine.best_configuration(error, (0.0, np.pi / 2)).inclination == pytest.approx(0.0)


def test_the_given_reason_for_roll_is_true(terrestrial: VisibilityStudy) -> None:
    """Lines hardly differ for boards normal to the beams; the thesis uses one of these."""
    shift = dict(
        zip(
            np.degrees(TERRESTRIAL_SITE.inclinations).round(),
            terrestrial.visibility_spread("roll")[0],
            strict=True,
        )
    )
    assert min(shift, key=lambda at: np.nan_to_num(shift[at], nan=9.0)) == -20
    assert shift[-40] < 0.6 * shift[20]
    offset = terrestrial.visibility_spread("range_offset")[0]
    assert offset[TERRESTRIAL_SITE.inclinations.index(np.radians(-60))] < 0.2 * np.nanmax(offset)


# --- files


def test_the_command_writes_the_tables_it_prints(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    found = run_json(capsys, "visibility", "marine", "--output", tmp_path, "--error", "yaw")
    assert found["thesis"][0]["lines_agree"] is True
    assert sorted(Path(each).name for each in found["files"]) == sorted(
        ["marine-values.csv", "marine-best.csv", *(f"marine-yaw-{name}.png" for name in CRITERIA)]
    )
    with (tmp_path / "marine-values.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 6 * 28
    (row,) = (r for r in rows if r["Line (deg)"] == "45" and r["Inclination (deg)"] == "0")
    shape = points_shape(cloud("yaw", 45))
    assert float(row["Signed orthogonal distance (m)"]) == pytest.approx(
        orthogonal_distance(shape, board_plane(UPRIGHT_BOARD)), abs=1e-6
    )
    assert {r["Type I criterion (0 to 1)"] for r in rows if r["Points"] == "0"} == {"0.0000"}
    assert {r["Planarity"] for r in rows if r["Points"] == "0"} == {""}


@LONG
def test_a_real_board_is_not_compared_with_the_thesis(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    found = run_json(
        capsys, "visibility", "marine", "--output", tmp_path, "--error", "pitch", "--hit-beams"
    )
    assert found["beams"] == "struck"
    assert found["thesis"] == []
    assert found["best"][0]["inclination_deg"] == 0
    assert "marine-best.csv" not in {Path(each).name for each in found["files"]}


def test_the_angular_deviation_has_no_sign() -> None:
    """Lines rotated by 2 deg in opposite directions have equal deviations but differ by 4 deg."""
    one, other = (points_shape(cloud("roll", heading)) for heading in (0, 180))
    reference = board_plane(UPRIGHT_BOARD)
    assert angular_deviation(one, reference) == pytest.approx(ERROR, abs=1e-9)
    assert angular_deviation(other, reference) == pytest.approx(ERROR, abs=1e-9)
    assert one.plane.tilt_to(other.plane) == pytest.approx(2 * ERROR, abs=1e-9)


def test_an_error_not_studied_for_the_site_is_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    code, _, err = run(capsys, "visibility", "marine", "--output", tmp_path, "--error", "lever-x")
    assert code == 2
    assert "the marine site has roll, pitch, yaw only" in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("criterion", CRITERIA)
def test_figures_have_all_lines_and_can_be_drawn_again(
    terrestrial: VisibilityStudy, criterion: str
) -> None:
    figure = visibility_figure(terrestrial, "lever_z", criterion)
    assert visibility_figure(terrestrial, "pitch", criterion, figure) is figure
    (axes,) = figure.axes
    drawn = [line for line in axes.lines if line.get_label() in map("{}°".format, HEADINGS_DEG)]
    values = CRITERIA[criterion].values(terrestrial)[TERRESTRIAL_SITE.errors.index("pitch")]
    for line, expected in zip(drawn, values, strict=True):
        assert np.array_equal(line.get_ydata(), expected, equal_nan=True)


def test_errors_without_a_suitable_inclination_show_the_thesis_only(
    terrestrial: VisibilityStudy,
) -> None:
    without_type_one = replace(terrestrial, type_one=0 * terrestrial.type_one)
    assert without_type_one.kept_inclinations("pitch") == ()
    assert without_type_one.best_configuration("pitch").inclination is None
    (axes,) = visibility_figure(without_type_one, "pitch", "orthogonal-distance").axes
    assert not axes.patches, "nothing is shaded"
    (pitch,) = (
        each for each in compare_with_thesis(without_type_one) if each.best.error == "pitch"
    )
    assert not pitch.inclination_agrees
    assert pitch.reason is not None
    assert len(pitch.reason.params["differences"]) == 1
