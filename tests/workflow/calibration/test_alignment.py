"""Tests of the coarse alignment of lines before any target is picked."""

import json
from pathlib import Path

import numpy as np
import pytest

from lispac.simulation.scene import Rectangle, upright_rectangle
from lispac.survey.cloud import Cloud, CloudInMemory, place_clouds
from lispac.survey.georeferencing import Mounting
from lispac.survey.scan import Scan
from lispac.targets.rough_alignment import Alignment, align_lines
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.sighting_assessment import assess_target
from lispac.workflow.calibration.target_search import SearchPlace
from lispac.workflow.project.survey import Survey
from tests.support.finder_scenes import WALL, Site, site
from tests.support.long_runs import LONG
from tests.targets.test_finder import SharedSurvey

OFF_DEG = [(0, 0, 0), (2, 2, 2), (-2, 2, -2), (2, -2, 2), (-2, -2, -2), (1, -2, 0.5)]


def lines_of(folder: Path) -> tuple[dict[str, Cloud], np.ndarray, np.ndarray]:
    """Clouds of a reference survey without boresight, its lever arm and the true angles."""
    survey = SharedSurvey(folder)
    truth_path = folder / ("truth.json" if (folder / "truth.json").exists() else "reference.json")
    mounting = Mounting(np.array(survey.site["lever_arm_m"]), np.zeros(3))
    clouds = {
        name: CloudInMemory.of(scan, survey.trajectory, mounting)
        for name, scan in survey.scans.items()
    }
    return clouds, mounting.lever_arm, np.array(json.loads(truth_path.read_text())["boresight_deg"])


def off_deg(alignment: Alignment, truth: np.ndarray) -> np.ndarray:
    return np.degrees(alignment.mounting.boresight) - truth


@LONG
@pytest.mark.parametrize("offs", [OFF_DEG[1:3], pytest.param(OFF_DEG, marks=pytest.mark.long)])
def test_six_harbour_lines_are_aligned_from_any_prior(
    shared_data: Path, offs: list[tuple[float, float, float]]
) -> None:
    clouds, arm, truth = lines_of(shared_data / "harbour")
    for off in [-truth, *offs]:
        found = align_lines(place_clouds(clouds, Mounting(arm, np.radians(truth + off))))
        assert found.is_aligned
        assert np.abs(off_deg(found, truth)).max() < 0.05, off


@pytest.mark.parametrize(("name", "most"), [("lanl_truck", 0.1), ("lanl_tent", 0.3)])
def test_two_drone_lines_are_aligned(shared_data: Path, name: str, most: float) -> None:
    """A vehicle and a tent on opposite lines, displaced by half a metre and more.

    In one direction of the three angles, a quarter of a degree moves the tent by only three
    centimetres, which limits the accuracy.
    """
    clouds, _, truth = lines_of(shared_data / name)
    found = align_lines(clouds)
    assert found.is_aligned
    assert found.matched_share_before < 0.75
    assert np.abs(off_deg(found, truth)).max() < most


def test_the_demo_is_aligned_and_a_click_moves_with_its_line(calibrated: tuple) -> None:
    project, survey = calibrated
    assert survey.alignment.is_aligned
    assert np.abs(off_deg(survey.alignment, project.truth_deg)).max() < 0.05
    sighting = project.target("T1").sightings[2]
    number = sighting.indices[len(sighting.indices) // 2][None]
    clicked = survey.clouds[sighting.line][number][0]
    moved = survey.alignment.clouds[sighting.line][number][0]
    assert np.linalg.norm(moved - clicked) > 0.1
    for line in (sighting.line, None):
        place = SearchPlace.of(survey.alignment, clicked, line, 2.0)
        assert place.line == sighting.line
        np.testing.assert_allclose(place.seed, moved, atol=1e-9)
    # Coordinates that are not a point of a line are taken as the true place of the target.
    typed = SearchPlace.of(survey.alignment, clicked + [0.0, 0.0, 50.0], None, 2.0)
    assert typed.line is None
    np.testing.assert_array_equal(typed.seed, clicked + [0.0, 0.0, 50.0])


def quay_wall(*more: Rectangle) -> Site:
    """Two opposite lines along a wall without other surfaces."""
    return site(
        [upright_rectangle("wall", (0.0, WALL - 0.3), 0.0, 12.0, 30.0, 270), *more], lines=2
    )


SIMILAR_BOARDS = [
    upright_rectangle(f"T{k + 1}", (k - 0.5, WALL), 7.4, 8.2, 0.6, 270) for k in range(2)
]


@pytest.mark.parametrize("off", [(0.0, 0.0, 2.0), (2.0, -2.0, 1.0), (-1.0, 2.0, -2.0)])
def test_angles_that_one_wall_does_not_determine_stay_near_the_prior(
    off: tuple[float, float, float],
) -> None:
    scene_site = quay_wall(*SIMILAR_BOARDS)
    _, survey = scene_site.opened(off)
    found = survey.alignment
    assert found.matched_share > 0.9
    assert not found.determined
    assert not found.is_aligned
    moved = np.degrees(found.mounting.boresight - scene_site.boresight) - off
    # The wall determines roll; the noise does not move the other angles far.
    assert abs(moved[0] + off[0]) < 0.3
    assert np.abs(moved[1:]).max() < 1.0


def test_a_second_solution_is_reported_where_the_scene_is_ambiguous() -> None:
    scene_site = quay_wall(*SIMILAR_BOARDS)
    project, survey = scene_site.opened((0.0, 0.0, 2.0))
    clicked = survey.clouds["L1"][np.flatnonzero(scene_site.on("L1", "T1"))].mean(axis=0)
    assessed = assess_target(project, survey, find_target(project, survey, clicked, name="T1"))
    for quality in assessed.values():
        assert quality.rating == "doubtful"
        # A metre apart, as with a boresight that is off by two degrees.
        (mistakable,) = [r for r in quality.reasons if r.code == "quality.mistakable"]
        assert mistakable.params["distance"] == pytest.approx(1.0, abs=0.1)
    alone = quay_wall(SIMILAR_BOARDS[0])
    project, survey = alone.opened((0.0, 0.0, 2.0))
    clicked = survey.clouds["L1"][np.flatnonzero(alone.on("L1", "T1"))].mean(axis=0)
    assessed = assess_target(project, survey, find_target(project, survey, clicked, name="T1"))
    assert [quality.rating for quality in assessed.values()] == ["good", "good"]


def test_lines_without_common_surfaces_are_not_moved(calibrated: tuple) -> None:
    _, survey = calibrated
    first, second = list(survey.clouds.values())[:2]
    assert isinstance(first, CloudInMemory)
    assert isinstance(second, CloudInMemory)
    rng = np.random.default_rng(0)
    shrubs = Scan(rng.uniform(-20.0, 20.0, (20_000, 3)), second.scan.time[:20_000])
    apart = CloudInMemory.of(shrubs, second.place.trajectory, second.place.mounting)
    found = align_lines({"L1": first, "L2": apart})
    assert not found.is_aligned
    assert align_lines({"L1": first}).clouds == {"L1": first}


def test_a_survey_is_aligned_once(calibrated: tuple, monkeypatch: pytest.MonkeyPatch) -> None:
    survey: Survey = calibrated[1]
    assert survey.alignment is survey.alignment
    other = survey.with_prior(survey.alignment.mounting)
    assert other.alignment is not survey.alignment
    assert other.alignment.matched_share_before > 0.9
