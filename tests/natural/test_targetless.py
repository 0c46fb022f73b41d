"""Tests of the boresight from natural surfaces alone, against known truth."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.errors import AdjustmentError
from lispac.geometry.rotations import rotation_matrix
from lispac.io.project.project_file import read_project, write_project
from lispac.messages import note
from lispac.method_comparison import method_results, missing_methods
from lispac.project import Project
from lispac.survey.cloud import CloudInMemory
from lispac.survey.georeferencing import Mounting, place_points, to_lidar
from lispac.survey.scan import Scan
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.method_runs import with_targetless_result
from lispac.workflow.calibration.picking import pick_target
from lispac.workflow.calibration.targetless import TargetlessResult, targetless
from lispac.workflow.output.export import write_report
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.cli.test_cli import run, run_json
from tests.support.long_runs import LONG
from tests.support.sharing import make_once
from tests.workflow.test_reference_surveys import angles, make

Opened = tuple[Project, Survey]
Disturb = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


FEW_SURFACES = 16
"""Number of surfaces to adjust: as accurate as all, and faster."""
WATER_DIVISOR = 10
"""Number of points of the scene per point of the water."""


@pytest.fixture(scope="module")
def thinned(demo_project: Project) -> Opened:
    """The built-in survey with a sixth of its points and without targets."""
    assert not demo_project.targets
    return demo_project, load_survey(demo_project)


@pytest.fixture(scope="module")
def clean(thinned: Opened, tmp_path_factory: pytest.TempPathFactory) -> TargetlessResult:
    return few_surfaces(thinned, tmp_path_factory)


def few_surfaces(thinned: Opened, factory: pytest.TempPathFactory) -> TargetlessResult:
    """Return the result of the unchanged scene, which other test modules use too."""
    return make_once(
        factory, "few surfaces", lambda _folder: targetless(*thinned, count=FEW_SURFACES)
    )


def error(found: TargetlessResult, project: Project) -> np.ndarray:
    """Return the errors of roll, pitch and yaw in degrees."""
    return np.degrees(found.result.boresight) - project.truth_deg


def with_scans(opened: Opened, change: Callable[[str, Scan], Scan]) -> Opened:
    project, survey = opened
    scans = {name: change(name, scan) for name, scan in survey.scans.items()}
    mounting = project.mounting("prior")
    clouds = {
        name: CloudInMemory.of(scan, survey.trajectory, mounting) for name, scan in scans.items()
    }
    return project, replace(survey, scans=scans, clouds=clouds)


def true_mounting(project: Project) -> Mounting:
    return project.mounting("prior").with_boresight(np.radians(project.truth_deg))


def test_each_angle_is_within_three_sigma_of_the_truth(
    thinned: Opened, clean: TargetlessResult
) -> None:
    off = np.abs(error(clean, thinned[0])) / np.degrees(clean.result.sigma)
    assert (off < 3).all(), off
    assert np.degrees(clean.result.sigma).max() < 0.02
    assert clean.disagreeing_lines == ()
    assert len(clean.messages) == 1 + (not clean.converged)
    assert clean.candidates >= len(clean.project.targets)
    assert clean.result.observability is not None


def test_eigenvalues_of_the_observability_match_the_covariance(clean: TargetlessResult) -> None:
    """Both include an increase of the sigmas by the scatter of subsets."""
    observability = clean.result.observability
    assert observability is not None
    spread = np.linalg.eigvalsh(clean.result.covariance)
    np.testing.assert_allclose(1 / observability.eigenvalues, spread[::-1], rtol=1e-9)


@LONG
@pytest.mark.parametrize(
    "off", [(2.0, -2.0, 2.0), pytest.param((-2.0, 2.0, -2.0), marks=pytest.mark.long)]
)
def test_a_prior_two_degrees_off_gives_the_same_result(
    thinned: Opened, clean: TargetlessResult, off: tuple[float, float, float]
) -> None:
    project, survey = thinned
    wrong = tuple(float(a + b) for a, b in zip(project.truth_deg, off, strict=True))
    project = project.with_settings(replace(project.settings, boresight_deg=wrong))
    found = targetless(project, survey.with_prior(project.mounting("prior")), count=FEW_SURFACES)
    assert (np.abs(error(found, project)) < 3 * np.degrees(found.result.sigma)).all()
    # The surfaces are cut elsewhere from the same scene: only noise may differ.
    moved = np.abs(found.result.boresight - clean.result.boresight)
    assert (moved < found.result.sigma).all(), np.degrees(moved)


def leaves_and_waves(opened: Opened, truth: Mounting) -> Opened:
    """Replace all points north of the middle by foliage, and add water with waves."""
    survey, rng = opened[1], np.random.default_rng(3)
    middle = np.median(np.concatenate([c.sample[:, 0] for c in survey.clouds.values()]))

    def change(name: str, scan: Scan) -> Scan:
        poses = survey.trajectory.at(scan.time)
        north = place_points(scan.points_lidar, poses, truth)[:, 0] > middle
        stretch = 1 + np.where(north, rng.uniform(-0.06, 0.06, len(north)), 0.0)
        leaves = scan.points_lidar * stretch[:, None]
        some = np.sort(rng.choice(len(scan.time), len(scan.time) // WATER_DIVISOR, replace=False))
        time, poses = scan.time[some], survey.trajectory.at(scan.time[some])
        water = poses.position + rng.uniform(-15.0, 15.0, (len(some), 3))
        water[:, 2] = 0.08 * np.sin(1.2 * water[:, 0] + 0.7 * water[:, 1] - 2.0 * time)
        water[:, 2] += rng.normal(0.0, 0.01, len(some))
        points = np.concatenate([leaves, to_lidar(water, poses, truth)])
        both = np.concatenate([scan.time, time])
        order = np.argsort(both, kind="stable")
        return Scan(np.ascontiguousarray(points[order]), both[order], None, scan.assumptions)

    return with_scans(opened, change)


def jumped(opened: Opened, truth: Mounting, wrong: str) -> Opened:
    """Shift one line by 5 cm, as by a jump of the GNSS between two lines."""

    def change(name: str, scan: Scan) -> Scan:
        if name != wrong:
            return scan
        poses = opened[1].trajectory.at(scan.time)
        moved = place_points(scan.points_lidar, poses, truth) + [0.03, -0.04, 0.0]
        return Scan(
            np.ascontiguousarray(to_lidar(moved, poses, truth)),
            scan.time, scan.intensity, scan.assumptions,
        )  # fmt: skip

    return with_scans(opened, change)


@pytest.mark.long
def test_foliage_and_water_have_little_effect(thinned: Opened, clean: TargetlessResult) -> None:
    """`test_targetless_clutter` measures the effect on many surveys."""
    found = targetless(*leaves_and_waves(thinned, true_mounting(thinned[0])), count=FEW_SURFACES)
    off, sigma = np.abs(error(found, thinned[0])), np.degrees(found.result.sigma)
    assert (off < 3 * sigma).all(), (off, sigma)
    assert (found.result.sigma < 3 * clean.result.sigma).all()
    planes = np.array([target.plane for target in found.result.targets])
    heights = np.array([target.seed[2] for target in found.project.targets])
    assert not ((np.abs(planes[:, 2]) > 0.95) & (heights < 0.5)).any(), "water was taken"


@LONG
def test_a_line_with_a_position_jump_is_named(thinned: Opened, clean: TargetlessResult) -> None:
    project, survey = thinned
    wrong = list(survey.scans)[2]
    found = targetless(*jumped(thinned, true_mounting(project), wrong), count=FEW_SURFACES)
    off, sigma = np.abs(error(found, project)), np.degrees(found.result.sigma)
    assert (off < 3 * sigma).all(), (off, sigma)
    assert found.disagreeing_lines == (wrong,)
    assert found.messages[-1] == note("targetless.lines_disagree", lines=(wrong,))


def test_one_line_and_lines_without_overlap_are_refused(thinned: Opened) -> None:
    project, survey = thinned
    name, other = list(survey.scans)[:2]
    alone = replace(survey, scans={name: survey.scans[name]}, clouds={name: survey.clouds[name]})
    with pytest.raises(AdjustmentError) as raised:
        targetless(project, alone)
    assert raised.value.code == "targetless.single_line"
    turn = rotation_matrix(np.pi, 0.0, 0.0)  # one line scans to the other side

    def change(each: str, scan: Scan) -> Scan:
        if each == name:
            return scan
        return Scan(scan.points_lidar @ turn.T, scan.time, None, scan.assumptions)

    project, apart = with_scans(thinned, change)
    pair = replace(
        apart,
        scans={k: apart.scans[k] for k in (name, other)},
        clouds={k: apart.clouds[k] for k in (name, other)},
    )
    with pytest.raises(AdjustmentError) as raised:
        targetless(project, pair)
    assert raised.value.code == "targetless.few_surfaces"


@LONG
def test_two_lines_give_a_warning(denser_project: Project) -> None:
    """On the two real surveys of two lines the result is off by several sigmas."""
    project, survey = denser_project, load_survey(denser_project)
    pair = list(survey.scans)[::2][:2]
    two = replace(
        survey,
        scans={name: survey.scans[name] for name in pair},
        clouds={name: survey.clouds[name] for name in pair},
    )
    found = targetless(project, two, count=FEW_SURFACES)
    assert (np.abs(error(found, project)) < 3 * np.degrees(found.result.sigma)).all()
    serious = {each.code for each in result_warnings(found.result, None) if each.is_serious}
    assert "adjustment.line_unchecked" in serious


@pytest.mark.long
def test_harbour_from_the_command_line(
    capsys: pytest.CaptureFixture[str], shared_data: Path, tmp_path: Path
) -> None:
    data, project = shared_data / "harbour", tmp_path / "harbour"
    truth = json.loads((data / "truth.json").read_text())["boresight_deg"]
    make(
        capsys, data, project, "--trajectory-accuracy", data / "smrmsg.out", "--lidar-sigma", 0.003
    )
    numbers = run_json(capsys, "targetless", project)
    off = np.abs(angles(numbers, "boresight_deg") - truth)
    assert (off < 3 * angles(numbers, "sigma_deg")).all(), off
    assert numbers["disagreeing_lines"] == []
    assert open_project(project).result is None


@LONG
def test_targets_and_natural_surfaces_are_combined(thinned: Opened) -> None:
    """Points of a target's board are not used twice."""
    project, survey = thinned
    for name in ("T1", "T2"):
        project = pick_target(project, survey, demo_seeds()[name][1], name=name)
    project = estimate(project, survey, cross_check=False)
    found = targetless(project, survey, count=8, with_targets=True)
    assert found.targets == len(project.targets_of_role("target"))
    names = [target.name for target in found.project.targets]
    assert names[: found.targets] == [target.name for target in project.targets_of_role("target")]
    assert len(set(names)) == len(names) <= found.targets + 8
    assert note("targetless.with_targets", targets=2) in found.messages
    off = np.abs(error(found, project)) / np.degrees(found.result.sigma)
    assert (off < 3).all(), off
    assert project.result is not None
    assert (found.result.sigma < project.result.sigma).all()
    points_of_targets = {
        (sighting.line, number)
        for target in found.project.targets[: found.targets]
        for sighting in target.sightings
        for number in sighting.indices.tolist()
    }
    for surface in found.project.targets[found.targets :]:
        for sighting in surface.sightings:
            assert not any(
                (sighting.line, n) in points_of_targets for n in sighting.indices.tolist()
            )


def test_invalid_combinations_are_refused(
    capsys: pytest.CaptureFixture[str], thinned: Opened, tmp_path: Path
) -> None:
    with pytest.raises(AdjustmentError) as raised:
        targetless(*thinned, count=FEW_SURFACES, with_targets=True)
    assert raised.value.code == "targetless.no_target"
    code, out, err = run(capsys, "targetless", tmp_path, "--save", "--with-targets")
    assert (code, out) == (2, "")
    assert "not independent" in err


def test_an_accepted_result_is_the_boresight_of_a_project_without_targets(
    thinned: Opened, clean: TargetlessResult, tmp_path: Path
) -> None:
    project, survey = thinned
    kept = with_targetless_result(project, clean)
    assert kept.is_targetless
    assert kept.result is not None
    np.testing.assert_array_equal(kept.mounting("estimated").boresight, clean.result.boresight)
    assert [each.name for each in kept.targets] == [each.name for each in clean.project.targets]
    assert kept.alternative_results == ()
    assert [each.method for each in method_results(kept)] == ["targetless"]
    assert "targetless" not in missing_methods(kept)
    write_project(replace(kept, folder=tmp_path))
    assert read_project(tmp_path).is_targetless
    write_report(kept, survey, tmp_path / "report.json")
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["calibrated"]
    codes = {each["code"] for each in report["warnings"]}
    assert "report.not_calibrated" not in codes
    assert {each.code for each in clean.messages} <= codes
    # Another run replaces the first.
    again = with_targetless_result(kept, clean)
    assert len(again.targets) == len(kept.targets)


def test_an_accepted_result_is_kept_beside_the_targets(
    thinned: Opened, clean: TargetlessResult
) -> None:
    project, survey = thinned
    picked = pick_target(project, survey, demo_seeds()["T1"][1], name="T1")
    kept = with_targetless_result(picked, clean)
    assert kept.result is None
    assert kept.targets == picked.targets
    assert [each.method for each in kept.alternative_results] == ["targetless"]
    plane = replace(picked.target("T1"), role="validation")
    kept = with_targetless_result(replace(project, targets=(plane,)), clean)
    assert kept.is_targetless
    assert kept.targets_of_role("validation") == (plane,)
    same_name = replace(plane, name=clean.project.targets[0].name)
    with pytest.raises(AdjustmentError) as raised:
        with_targetless_result(replace(project, targets=(same_name,)), clean)
    assert raised.value.code == "targetless.name_taken"
