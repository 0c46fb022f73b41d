"""Tests of the LiDAR patch test on surveys with known boresight."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import AdjustmentError, InputError
from lispac.patchtest.block_equations import linearise_blocks
from lispac.patchtest.line_mismatch import Mismatch, curve_minimum, pair_blocks
from lispac.patchtest.line_pairs import pair_kind, pairs_of_lines
from lispac.patchtest.mismatch_minimisation import minimise_mismatch
from lispac.patchtest.object_boxes import ObjectBox, PatchObject, object_of_box
from lispac.patchtest.object_sample import ObjectSample
from lispac.patchtest.patch_test_result import PatchTestResult
from lispac.present.json_values import json_values
from lispac.project import Project
from lispac.simulation.simulated_survey import port_survey
from lispac.survey.cloud import CloudInMemory
from lispac.survey.georeferencing import place_points, to_lidar
from lispac.survey.scan import Scan
from lispac.survey.trajectory import Poses
from lispac.workflow.calibration.method_runs import patch_test_result
from lispac.workflow.calibration.patch_test import (
    PlacedObjects,
    find_angle,
    find_boresight,
    line_pairs,
    place_objects,
    propose_objects,
)
from lispac.workflow.planning.simulate import RAW_FOLDER, as_triple, write_lines, write_trajectory
from lispac.workflow.project.projects import create_project, open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.cli.test_cli import run_json
from tests.support.command_errors import refused_with
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG
from tests.support.message_codes import codes
from tests.workflow.test_reference_surveys import angles, make

Opened = tuple[Project, Survey]

OBJECT_COUNT = 12
"""Number of objects; fewer than the default to save time."""
MAST = PatchObject("mast", ObjectBox(np.array([9.0, -17.0, 15.5]), np.array([1.6, 1.6, 10.0])))
"""A pole 12 cm thick on the pier of the built-in scene."""


@pytest.fixture(scope="module")
def thinned(denser_project: Project) -> Opened:
    """Return the built-in survey with a third of its points, without targets."""
    return denser_project, load_survey(denser_project)


@pytest.fixture(scope="module")
def placed_objects(thinned: Opened) -> PlacedObjects:
    return propose_objects(*thinned, count=OBJECT_COUNT)


@pytest.fixture(scope="module")
def clean(thinned: Opened, placed_objects: PlacedObjects) -> PatchTestResult:
    return find_boresight(*thinned, placed_objects)


def truth(project: Project) -> np.ndarray:
    return np.radians(project.truth_deg)


def error(found: PatchTestResult, project: Project) -> np.ndarray:
    """Return the error of the boresight over its sigma."""
    assert found.sigma is not None
    return np.abs(found.boresight - truth(project)) / found.sigma


def test_each_angle_is_within_three_sigma_of_the_truth(
    thinned: Opened, clean: PatchTestResult
) -> None:
    assert (error(clean, thinned[0]) < 3).all()
    assert clean.sigma is not None
    assert np.degrees(clean.sigma).max() < 0.03
    assert clean.converged
    assert clean.disagreeing_objects == ()
    assert clean.lines == thinned[1].lines
    assert clean.mismatch < 0.5 * clean.mismatch_before
    # Both methods find the same minimum.
    assert np.degrees(np.abs(clean.separate_boresight - clean.boresight)).max() < 1e-3


@pytest.mark.long
def test_a_prior_with_errors_of_two_degrees_gives_the_same_result(
    thinned: Opened, clean: PatchTestResult
) -> None:
    project, survey = thinned
    wrong = tuple(float(v) for v in np.array(project.truth_deg) + [2.0, -2.0, 2.0])
    project = project.with_settings(replace(project.settings, boresight_deg=wrong))
    survey = survey.with_prior(project.mounting("prior"))
    found = find_boresight(project, survey, propose_objects(project, survey, count=OBJECT_COUNT))
    assert (error(found, project) < 3).all()
    assert clean.sigma is not None
    assert (np.abs(found.boresight - clean.boresight) < clean.sigma).all()


@pytest.mark.long  # a prior that is wrong by two degrees cuts them again too
def test_objects_placed_with_a_wrong_boresight_are_cut_again(
    thinned: Opened, placed_objects: PlacedObjects, clean: PatchTestResult
) -> None:
    off = placed_objects.boresight + np.radians([0.3, -0.3, 0.3])
    found = find_boresight(*thinned, place_objects(*thinned, placed_objects.objects, off))
    assert clean.sigma is not None
    assert (np.abs(found.boresight - clean.boresight) < clean.sigma).all()


@LONG
def test_a_box_placed_with_a_wrong_boresight_is_moved(
    thinned: Opened, placed_objects: PlacedObjects
) -> None:
    """With a prior that is wrong by two degrees the mast appears a metre from its place."""
    project, survey = thinned
    right = truth(project)
    off = right + np.radians([2.0, -2.0, 2.0])
    sample = place_objects(project, survey, [MAST], right).sample
    best = max(sample.observed, key=lambda each: np.count_nonzero(each.inside))
    inside = np.arange(best.begin, best.end)[best.inside]
    move = (sample.placed_points(off) - sample.placed_points(right))[inside].mean(axis=0)
    assert np.linalg.norm(move) > 0.8
    there = replace(MAST, box=replace(MAST.box, centre=MAST.box.centre + move))
    both = placed_objects.joined_with(place_objects(project, survey, [there], off))
    assert np.isnan(both.boresight).all()
    *others, mast = both.moved_to_boresight(right)
    assert np.linalg.norm(mast.box.centre - MAST.box.centre) < 0.1
    for each, before in zip(others, placed_objects.objects, strict=True):
        assert np.linalg.norm(each.box.centre - before.box.centre) < 0.1
    found = find_boresight(project, survey, both, start=placed_objects.boresight)
    assert MAST.name not in found.objects_without_pairs
    assert (error(found, project) < 3).all()


def test_one_pole_determines_the_pitch_of_reciprocal_lines(thinned: Opened) -> None:
    project, survey = thinned
    start = truth(project) + np.radians([0.0, 0.4, 0.0])
    pole = place_objects(project, survey, [MAST], start)
    pairs = line_pairs(survey, {"reciprocal"})
    found = find_angle(pole, pole.blocks({"mast"}, pairs), start, 1)
    # Three pairs of lines with 12 mm each; the visible part of the mast is 14 m above the lines
    sigma = np.degrees(0.012 / np.sqrt(2 * 3) / 14.0)
    assert abs(np.degrees(found.boresight[1] - truth(project)[1])) < 3 * sigma
    assert (found.boresight[[0, 2]] == start[[0, 2]]).all()


def test_a_pole_on_reciprocal_lines_does_not_determine_yaw(thinned: Opened) -> None:
    """A yaw moves the pole alike on both lines, as they pass it at the same side and distance."""
    project, survey = thinned
    pole = place_objects(project, survey, [MAST], truth(project))
    pairs = line_pairs(survey, {"reciprocal"})
    with pytest.raises(AdjustmentError, check=has_code("patch_test.no_yaw")):
        find_angle(pole, pole.blocks({"mast"}, pairs), truth(project), 2)


def flat(tilt: np.ndarray, off: float, place_: np.ndarray) -> np.ndarray:
    """Return a plane grid of points, moved along its normal."""
    u, v = np.meshgrid(np.linspace(-1, 1, 21), np.linspace(-1, 1, 21))
    normal = tilt / np.linalg.norm(tilt)
    first = np.cross(normal, [0.3, 0.5, 0.8])
    first /= np.linalg.norm(first)
    along = np.outer(u.ravel(), first) + np.outer(v.ravel(), np.cross(normal, first))
    return place_ + along + off * normal


def sample_of(thinned: Opened, groups: dict[str, np.ndarray], box: ObjectBox) -> ObjectSample:
    """Return a sample of local points, scanned by lines with the true boresight."""
    project, survey = thinned
    mounting = project.mounting("prior").with_boresight(truth(project))
    scans, clouds = {}, {}
    for name, points in groups.items():
        time = np.linspace(survey.scans[name].first_time, survey.scans[name].last_time, len(points))
        time = 0.5 * (time[0] + time[-1]) + 0.02 * (time - time[0])
        lidar = to_lidar(points, survey.trajectory.at(time), mounting)
        scans[name] = Scan(np.ascontiguousarray(lidar), time, None, ())
        clouds[name] = CloudInMemory.of(scans[name], survey.trajectory, mounting)
    return ObjectSample.of([PatchObject("plane", box)], clouds, scans)


LEANING_NORMAL = np.array([0.2, 1.0, 0.3])


def two_planes(thinned: Opened, off: float, tilt: np.ndarray = LEANING_NORMAL) -> Mismatch:
    names = list(thinned[1].scans)[:2]
    middle = np.array([5.0, -16.0, 6.0])
    groups = {n: flat(tilt, k * off, middle) for k, n in enumerate(names)}
    sample = sample_of(thinned, groups, ObjectBox(middle, np.array([3.0, 3.0, 3.0])))
    return Mismatch(
        sample, pair_blocks(sample, pairs_of_lines({n: 0.0 for n in names})), scale=100.0
    )


@pytest.mark.parametrize("off", [0.0, 0.004, 0.05])
def test_the_mismatch_of_two_planes_is_their_distance(thinned: Opened, off: float) -> None:
    assert two_planes(thinned, off)(truth(thinned[0])) == pytest.approx(off, abs=1e-6)


def test_the_mismatch_of_distant_planes_is_limited_by_the_scale(thinned: Opened) -> None:
    mismatch = two_planes(thinned, 0.05).with_scale(0.05)
    assert mismatch(truth(thinned[0])) == pytest.approx(0.05 / np.sqrt(2), rel=1e-3)


def test_the_gradient_agrees_with_differences_of_the_mean_square(thinned: Opened) -> None:
    mismatch = two_planes(thinned, 0.02).with_scale(0.05)
    at, step = truth(thinned[0]), 1e-5
    found = linearise_blocks(mismatch, at)
    for k, axis in enumerate(np.eye(3)):
        ends = [0.5 * mismatch.mean_squares(at + sign * step * axis)[0] for sign in (1, -1)]
        central = (ends[0] - ends[1]) / (2 * step)
        assert found.gradient[0, k] == pytest.approx(central, rel=0.02, abs=1e-6)


def test_pos_errors_change_the_gradient_as_predicted(thinned: Opened) -> None:
    mismatch = two_planes(thinned, 0.02).with_scale(100.0)
    at, sample = truth(thinned[0]), mismatch.sample
    found = linearise_blocks(mismatch, at, pos_errors=True)
    error = np.array([0.003, -0.002, 0.004, 2e-4, -1e-4, 1e-4])
    rows = mismatch.blocks[0].second.points
    position, attitude = sample.poses.position.copy(), sample.poses.attitude.copy()
    position[rows] += error[:3]
    attitude[rows] += error[3:]
    moved = replace(sample, poses=Poses(position, attitude))
    other = Mismatch(moved, mismatch.blocks, 100.0)
    change = linearise_blocks(other, at).gradient[0] - found.gradient[0]
    # Terms of second order: the derivatives change with the attitude.
    np.testing.assert_allclose(change, found.pos_derivatives[0, 1] @ error, rtol=0.05, atol=2e-4)


def test_an_object_shifted_on_one_line_is_named(
    thinned: Opened, placed_objects: PlacedObjects, clean: PatchTestResult
) -> None:
    project, survey = thinned
    sample = placed_objects.sample
    moved = max(sample.observed, key=lambda each: each.end - each.begin)
    mounting = project.mounting("prior").with_boresight(truth(project))
    rows = moved.points
    poses = Poses(sample.poses.position[rows], sample.poses.attitude[rows])
    points = sample.points_lidar.copy()
    shifted = place_points(points[rows], poses, mounting) + [0.2, 0.2, 0.2]
    points[rows] = to_lidar(shifted, poses, mounting)
    found = find_boresight(
        project, survey, replace(placed_objects, sample=replace(sample, points_lidar=points))
    )
    assert [each.name for each in found.disagreeing_objects] == [moved.object.name]
    (message,) = (each for each in found.messages if each.code == "patch_test.object_disagrees")
    assert message.params["object"] == moved.object.name
    assert (error(found, project) < 3).all()


def test_few_objects_have_no_sigma(thinned: Opened, placed_objects: PlacedObjects) -> None:
    few = place_objects(*thinned, placed_objects.objects[:4], placed_objects.boresight)
    found = find_boresight(*thinned, few)
    assert found.sigma is None
    assert "patch_test.no_sigma" in codes(found.messages)


def test_level_ground_alone_does_not_determine_yaw(thinned: Opened) -> None:
    ground = two_planes(thinned, 0.02, np.array([0.0, 0.0, 1.0]))
    with pytest.raises(AdjustmentError, check=has_code("patch_test.no_yaw")):
        minimise_mismatch(ground.sample, ground.blocks, truth(thinned[0]), (2,))


def test_a_clear_minimum_of_a_curve_is_found_and_ripples_are_ignored() -> None:
    values = np.radians(np.linspace(-0.5, 0.5, 21))
    dip = 0.02 + 5.0 * np.abs(values - 0.002) ** 2 * 1e3
    assert curve_minimum(values, dip) == pytest.approx(0.002, abs=1e-5)
    assert curve_minimum(values, dip[::-1]) == pytest.approx(-0.002, abs=1e-5)
    level = 0.093 + 0.001 * np.cos(40 * values * 57)
    assert curve_minimum(values, level) is None
    assert curve_minimum(values, 0.05 + values) is None, "it falls towards an end"
    assert curve_minimum(values[:2], dip[:2]) is None
    assert curve_minimum(values, np.where(values > 0.004, np.nan, dip)) is None


def test_objects_without_pairs_of_lines_are_refused(thinned: Opened) -> None:
    nowhere = PatchObject("air", ObjectBox(np.array([0.0, 0.0, 100.0]), np.array([2.0, 2.0, 2.0])))
    with pytest.raises(AdjustmentError, check=has_code("patch_test.no_pairs")):
        find_boresight(*thinned, place_objects(*thinned, [nowhere], truth(thinned[0])))


@pytest.mark.parametrize(
    ("first", "second", "kind"),
    [
        (0, 180, "reciprocal"), (350, 160, "reciprocal"), (0, 201, "oblique"),
        (45, 135, "crossing"),
        (10, 355, "same direction"), (0, 40, "oblique"), (315, 45, "crossing"),
    ],
)  # fmt: skip
def test_kinds_of_pairs(first: float, second: float, kind: str) -> None:
    assert pair_kind(np.radians(first), np.radians(second)) == kind
    assert pair_kind(np.radians(second), np.radians(first)) == kind


def test_a_box_turns_clockwise() -> None:
    box = ObjectBox(np.zeros(3), np.array([4.0, 1.0, 2.0]), np.radians(30.0))
    ahead = np.array([np.cos(np.radians(30.0)), -np.sin(np.radians(30.0)), 0.0])  # y is west
    points = np.array([1.9 * ahead, 1.9 * ahead * [1, -1, 1], [0, 0, 1.1], 2.1 * ahead])
    assert box.inside(points).tolist() == [True, False, False, False]
    assert box.inside(points, 0.2)[2:].all()


def test_a_box_without_a_size_is_refused() -> None:
    with pytest.raises(InputError, check=has_code("patch_test.box_size", name="pole")):
        object_of_box("pole", ObjectBox(np.zeros(3), np.array([1.0, 0.0, 1.0])))
    with pytest.raises(InputError, check=has_code("patch_test.box_not_finite")):
        object_of_box("pole", ObjectBox(np.array([np.nan, 0, 0]), np.ones(3)))


@LONG
def test_the_patchtest_command_gives_the_same_result(
    capsys: pytest.CaptureFixture[str], thinned: Opened, clean: PatchTestResult
) -> None:
    folder = thinned[0].folder
    numbers = run_json(capsys, "patchtest", folder, "--count", OBJECT_COUNT)
    np.testing.assert_allclose(
        angles(numbers, "boresight_deg"), np.degrees(clean.boresight), atol=1e-9
    )
    assert numbers["messages"] == json_values(clean.messages)
    assert open_project(folder).alternative_results == ()
    # An object of five numbers is not a box.
    assert main(["patchtest", str(folder), "--object", "pole=1,2,3,4,5"]) == 2
    assert "is not NAME=N,W,U,A,L,H" in capsys.readouterr().err
    assert main(["patchtest", str(folder), "--lines", "nobody"]) == 2
    assert "there is no line nobody" in capsys.readouterr().err
    refused_with(
        "patch_test.box_size", "patchtest", folder, "--object", "pole=9,-17,15,1,1,0", name="pole"
    )


@LONG
def test_a_result_with_sigmas_is_saved(
    capsys: pytest.CaptureFixture[str],
    thinned: Opened,
    placed_objects: PlacedObjects,
    tmp_path: Path,
) -> None:
    folder = tmp_path / "copy"
    shutil.copytree(thinned[0].folder, folder)
    numbers = run_json(capsys, "patchtest", folder, "--count", 8, "--save")
    kept = open_project(folder).alternative_result("patch test")
    assert kept is not None
    np.testing.assert_allclose(np.degrees(kept.boresight), angles(numbers, "boresight_deg"))
    np.testing.assert_allclose(np.degrees(kept.sigma), angles(numbers, "sigma_deg"))
    assert kept.surfaces == len(numbers["objects"])
    assert json_values(kept.messages) == numbers["messages"]
    few = find_boresight(
        *thinned, placed_objects.select_objects({each.name for each in placed_objects.objects[:4]})
    )
    with pytest.raises(AdjustmentError) as raised:
        patch_test_result(few)
    assert raised.value.code == "estimate.patch_test_without_sigma"


@pytest.mark.long
def test_sigmas_agree_with_errors_of_simulated_surveys(tmp_path: Path) -> None:
    """In sixty surveys the root mean square of error over sigma was 1.0 to 1.1."""
    found = []
    for seed in range(201, 217):
        simulated = port_survey(points_per_second=20_000.0, seed=seed)
        folder = tmp_path / str(seed)
        trajectory, accuracy = write_trajectory(simulated, folder / RAW_FOLDER)
        lines = write_lines(simulated, folder / RAW_FOLDER)
        latitude, longitude, height = simulated.origin
        base = port_settings(simulated.lever_arm, latitude, longitude, height)
        project = create_project(
            folder, trajectory=trajectory, lines=lines, accuracy=accuracy, settings=base,
            truth_deg=as_triple(np.degrees(simulated.boresight)),
        )  # fmt: skip
        survey = load_survey(project)
        result = find_boresight(project, survey, propose_objects(project, survey))
        found.append((result.boresight - truth(project)) / result.sigma)
    rms = np.sqrt((np.array(found) ** 2).mean(axis=0))
    # Limits of 99.9 % for the root mean square of 16 values of unit variance
    assert ((rms > 0.5) & (rms < 1.6)).all(), rms


def port_settings(lever_arm: np.ndarray, latitude: float, longitude: float, height: float):
    from lispac.project import Settings

    origin = (float(np.degrees(latitude)), float(np.degrees(longitude)), height)
    return Settings(lever_arm=as_triple(lever_arm), origin_deg_m=origin, lidar_sigma=0.0019)


@pytest.mark.long
def test_harbour_patch_test_by_command(
    capsys: pytest.CaptureFixture[str], shared_data: Path, tmp_path: Path
) -> None:
    data, project = shared_data / "harbour", tmp_path / "harbour"
    known = json.loads((data / "truth.json").read_text())["boresight_deg"]
    make(
        capsys, data, project, "--trajectory-accuracy", data / "smrmsg.out", "--lidar-sigma", 0.003
    )
    numbers = run_json(capsys, "patchtest", project)
    off = np.abs(angles(numbers, "boresight_deg") - known)
    assert (off < 3 * angles(numbers, "sigma_deg")).all(), off
    assert numbers["sigma_deg"]["pitch"] < 0.03
