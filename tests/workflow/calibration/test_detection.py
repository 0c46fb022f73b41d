"""Tests of automatic target detection and of the proposed targets."""

import json
from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.progress import Step
from lispac.project import Project
from lispac.simulation.scene import tilted_rectangle
from lispac.targets.flat_patches import find_flat_patches, voxel_side
from lispac.targets.plane_detection import COARSE_VOXEL_SIDE, detect_planes
from lispac.targets.plane_finder import FinderSettings
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.proposals import propose_targets
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.survey import Survey
from tests.support.finder_scenes import WALL, precision_and_recall, rippled, site
from tests.targets.test_finder import SharedSurvey
from tests.targets.test_finder_sites import scenery


def test_flat_patches_agree_with_the_scene():
    """A board 5 cm before a wall is a separate patch of the size of the board."""
    scene_site = scenery("5 cm proud")
    cloud, board = scene_site.clouds()["L1"], scene_site.on("L1", "T1")
    found = find_flat_patches(cloud, 0.01)
    large = [patch for patch in found.patches if patch.area > 0.3]
    assert len(large) == 2
    assert large[0].area > 50.0
    np.testing.assert_allclose(large[1].extent, [1.23, 1.22], atol=0.1)
    np.testing.assert_allclose(large[1].centre, cloud[board].mean(axis=0), atol=0.05)
    assert np.degrees(large[1].plane.tilt_to(large[0].plane)) < 0.5


def test_points_without_flat_surface_have_no_patch():
    rng = np.random.default_rng(0)
    assert find_flat_patches(rng.uniform(0, 3, (20_000, 3)), 0.01).patches == ()
    assert find_flat_patches(np.empty((0, 3)), 0.01).patches == ()
    assert find_flat_patches(np.full((50, 3), np.nan), 0.01).patches == ()


def test_both_similar_targets_are_detected_on_every_line_and_kept_apart():
    scene_site = scenery("similar targets")
    clouds = {line: cloud for line, cloud in scene_site.clouds((1, 1, 1)).items() if line < "L5"}
    clouds["L9"] = np.empty((0, 3))
    planes = detect_planes(clouds, FinderSettings())
    for name in ("T1", "T2"):
        own = [
            plane
            for plane in planes
            if scene_site.on(plane.line, name)[plane.found[plane.line].indices].mean() > 0.5
        ]
        assert len(own) == 1
        assert set(own[0].found) == {"L1", "L2", "L3", "L4"}
        assert "L9" in own[0].missing
        for line, patch in own[0].found.items():
            assert min(precision_and_recall(patch.indices, scene_site.on(line, name))) > 0.95


def test_pieces_of_one_surface_count_once_for_the_limit_of_surfaces():
    """A folded tarpaulin consists of pieces that are larger than the board beside it."""
    folds = rippled("sheet", (-0.6, WALL, 7.8), 3.2, 1.6, period=1.4, slope_deg=7.0)
    scene_site = site(
        [tilted_rectangle("T1", (2.6, WALL, 7.5), 1.0, 0.7, 270, 40), *folds], lines=2
    )
    clouds, settings = scene_site.clouds(), FinderSettings(threshold=0.06)
    voxel = voxel_side(settings.threshold, COARSE_VOXEL_SIDE)
    pieces = [
        patch
        for line in clouds
        for patch in find_flat_patches(clouds[line], settings.threshold, voxel=voxel).patches
        if patch.area > 0.7  # area of the board
    ]
    assert len(pieces) > 2
    reports: list[tuple[float, str]] = []
    planes = detect_planes(
        clouds, settings, max_surfaces=2,
        progress=lambda fraction, step=None: reports.append((fraction, str(step or ""))),
    )  # fmt: skip
    fractions = [fraction for fraction, _ in reports]
    assert fractions == sorted(fractions)
    assert len([step for _, step in reports if step]) == 3, "detection, and a step for each surface"
    shown = [
        {
            name
            for name in ("T1", "sheet")
            if all(
                min(precision_and_recall(patch.indices, scene_site.on(line, name))) > 0.9
                for line, patch in plane.found.items()
            )
        }
        for plane in planes
    ]
    assert shown == [{"sheet"}, {"T1"}]


@pytest.mark.long
def test_the_demo_is_calibrated_with_the_proposed_targets(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    fractions = [0.0]

    def progress(fraction: float, _: Step | None = None) -> None:
        fractions.append(fraction)

    proposal = propose_targets(project, survey, progress=progress)
    assert np.diff(sorted(fractions)).max() < 0.2
    assert fractions[-1] == 1.0
    targets = [target for target in proposal.targets if target.role == "target"]
    validation = [target for target in proposal.targets if target.role == "validation"]
    seeds = {name: np.array(seed) for name, (_, seed) in demo_seeds().items()}
    boards = {
        min(seeds, key=lambda name: np.linalg.norm(seeds[name] - target.seed)) for target in targets
    }
    assert boards >= {"T1", "T2"}
    assert len(validation) >= 4
    assert set(proposal.reasons) == {target.name for target in proposal.targets}
    for target in proposal.targets:
        assert len(target.sightings) >= 2
        for sighting in target.sightings:
            assert sighting.rms < 3 * 0.0028, (target.name, sighting.line)
    for plane in validation:  # not used as targets
        for target in targets:
            for sighting in target.sightings:
                other = plane.sighting(sighting.line)
                assert other is None or not np.isin(other.indices, sighting.indices).any()
    heights = [plane.seed[2] for plane in validation]
    assert max(heights) - min(heights) > 15.0
    for name in [target.name for target in project.targets]:
        project = project.without_target(name)
    for target in proposal.targets:
        project = project.with_target(target)
    result = estimate(project, survey).result
    error = np.degrees(result.boresight) - project.truth_deg
    assert (np.abs(error) < 3 * np.degrees(result.sigma)).all(), (error, np.degrees(result.sigma))


@pytest.mark.long
@pytest.mark.parametrize(("name", "least"), [("lanl_truck", 2), ("lanl_tent", 2)])
def test_natural_planes_are_detected(shared_data: Path, name: str, least: int) -> None:
    """With the reference boresight, the surfaces of the drone survey are sharp planes."""
    survey = SharedSurvey(shared_data / name)
    reference = json.loads((shared_data / name / "reference.json").read_text())["boresight_deg"]
    planes = detect_planes(survey.clouds(reference), FinderSettings(threshold=0.04))
    assert len(planes) >= least
    for plane in planes:
        print(name, plane.centre.round(2), round(plane.area, 1), len(plane.found))
        for patch in plane.found.values():
            assert patch.rms < 3 * 0.02


def test_proposed_targets_are_not_added_to_existing_ones(
    copy: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["propose", str(copy.folder), "--accept"]) == 1
    assert "(without --accept)" in capsys.readouterr().err
