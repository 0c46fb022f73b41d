"""Tests that no other surface is mistaken for a target on a line that does not show it.

The simulated sites have a wall, a deck or a similar board near the target.
The prior boresight is off by 0, 0.1, 1 or 2 degrees on every axis.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from lispac.errors import TargetNotFound
from lispac.project import Project, Target
from lispac.simulation.scene import Surface, tilted_rectangle, upright_rectangle
from lispac.targets.plane_finder import patch_of
from lispac.targets.sighting_agreement import PlacementAccuracy, split_by_agreement
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.project.survey import Survey
from tests.support.finder_scenes import WALL, Site, site
from tests.support.long_runs import others_long
from tests.targets.test_finder_sites import board, wall

LINE_WITHOUT_TARGET = "L4"
SCENES: dict[str, list[Surface]] = {
    "wall 0.3 m behind": [board(), wall(0.3)],
    "wall askew": [board(250), wall(0.5)],
    "wall across": [tilted_rectangle("T1", (0.0, WALL, 8.0), 1.23, 1.0, 270, 45), wall(0.5)],
    "deck at a wall": [
        tilted_rectangle("T1", (0.0, WALL + 1.0, 7.0), 3.0, 2.0, 270, 75),
        wall(0.5),
    ],
    "deck below": [
        tilted_rectangle("T1", (0.0, WALL + 0.6, 8.0), 1.23, 1.0, 270, 60),
        tilted_rectangle("T3", (0.0, WALL + 0.8, 7.2), 3.0, 2.0, 270, 70),
        wall(0.5),
    ],
    "similar board beside": [
        upright_rectangle("T1", (0.0, WALL), 7.4, 8.62, 1.0, 270),
        upright_rectangle("T2", (1.3, WALL), 7.4, 8.62, 1.0, 270),
        wall(0.5),
    ],
    "similar board behind": [
        upright_rectangle("T1", (0.0, WALL), 7.4, 8.62, 1.0, 270),
        upright_rectangle("T2", (0.2, WALL - 0.35), 7.4, 8.62, 1.0, 270),
        wall(1.2),
    ],
}
SHORT_SELECTION = {
    ("wall across", (0.0, 0.0, 0.0)), ("deck below", (1.0, -1.0, 1.0)),
    ("similar board beside", (2.0, -2.0, 2.0)),
}  # fmt: skip
OFF_DEG = [(0.0, 0.0, 0.0), (0.1, -0.1, 0.1), (1.0, -1.0, 1.0), (2.0, -2.0, 2.0)]


@cache
def scenery(name: str) -> Site:
    return site(SCENES[name], absent_from=LINE_WITHOUT_TARGET)


def clicked_point(scene_site: Site, survey: Survey, line: str) -> np.ndarray:
    on = np.flatnonzero(scene_site.on(line, "T1"))
    truly = scene_site.echoes[line].true_points_local[on]
    nearest = np.argmin(np.linalg.norm(truly - truly.mean(axis=0) - [-0.2, 0.0, -0.2], axis=1))
    return survey.clouds[line][on[[nearest]]][0]


def typed_seed(scene_site: Site) -> np.ndarray:
    truly = scene_site.echoes["L3"].true_points_local[scene_site.on("L3", "T1")]
    return np.asarray(truly.mean(axis=0) + [0.1, 0.05, 0.1])


def require_right(scene_site: Site, target: Target) -> None:
    """Require that every sighting contains points on the true plane of the target."""
    truth = next(s for s in scene_site.scene.surfaces if s.name == "T1")
    for sighting in target.sightings:
        points = scene_site.echoes[sighting.line].true_points_local[sighting.indices]
        plane = patch_of(points, np.arange(len(points)), truth.normal).plane
        assert sighting.line != LINE_WITHOUT_TARGET, target.missing
        assert np.degrees(np.arccos(min(1.0, plane.normal @ truth.normal))) < 2.0, sighting.line
        assert abs(plane.distances(truth.centre)) < 0.05, sighting.line
    assert len(target.sightings) >= 3


@pytest.mark.parametrize(
    ("name", "off_deg"),
    [
        pytest.param(name, off, marks=() if (name, off) in SHORT_SELECTION else pytest.mark.long)
        for name in SCENES
        for off in OFF_DEG
    ],
)
def test_a_line_without_the_target_has_no_sighting(
    name: str, off_deg: tuple[float, float, float]
) -> None:
    """The seed is a click on one line, or coordinates that belong to no line."""
    scene_site = scenery(name)
    project, survey = scene_site.opened(off_deg)
    require_right(
        scene_site,
        find_target(
            project, survey, clicked_point(scene_site, survey, "L3"), name="T1", first_line="L3"
        ),
    )
    require_right(scene_site, find_target(project, survey, typed_seed(scene_site), name="T1"))


@cache
def few_lines(count: int) -> Site:
    """A board 0.3 m before a wall, which line L2 does not show."""
    return site([board(), wall(0.3)], lines=count, absent_from="L2")


@pytest.mark.parametrize("lines", others_long([2, 3]))
@pytest.mark.parametrize(
    "off_deg", [off if off in OFF_DEG[::2] else pytest.param(off, marks=pytest.mark.long)
                for off in OFF_DEG],
)  # fmt: skip
def test_the_wall_seen_in_more_lines_does_not_replace_the_board(
    lines: int, off_deg: tuple[float, float, float]
) -> None:
    """Few lines are not roughly aligned before the search; the typed seed is 5 cm off the board."""
    scene_site = few_lines(lines)
    project, survey = scene_site.opened(off_deg)
    on_board = scene_site.echoes["L1"].true_points_local[scene_site.on("L1", "T1")]
    target = find_target(project, survey, on_board.mean(axis=0) + [0.1, 0.05, 0.1], name="T1")
    assert [sighting.line for sighting in target.sightings] == ["L1", "L3"][: lines - 1]
    assert list(target.missing) == ["L2"]
    for sighting in target.sightings:
        assert scene_site.on(sighting.line, "T1")[sighting.indices].mean() > 0.95


def two_boards() -> tuple[Site, Project, Survey, Target]:
    scene_site = scenery("similar board beside")
    project, survey = scene_site.opened((1.0, -1.0, 1.0))
    target = find_target(
        project, survey, clicked_point(scene_site, survey, "L3"), name="T1", first_line="L3"
    )
    return scene_site, project, survey, target


def test_a_click_on_another_surface_adds_no_sighting() -> None:
    """The user clicks the similar board on the line that lacks the target."""
    scene_site, project, survey, target = two_boards()
    on = np.flatnonzero(scene_site.on(LINE_WITHOUT_TARGET, "T2"))
    seed = survey.clouds[LINE_WITHOUT_TARGET][on[[len(on) // 2]]][0]
    with pytest.raises(TargetNotFound):
        find_target(project.with_target(target), survey, seed, name="T1", line=LINE_WITHOUT_TARGET)
    alone = find_target(project, survey, seed, name="T2", line=LINE_WITHOUT_TARGET)
    assert [s.line for s in alone.sightings] == [LINE_WITHOUT_TARGET]


def test_a_click_on_the_same_surface_adds_a_sighting() -> None:
    scene_site, project, survey, target = two_boards()
    fewer = replace(target, sightings=tuple(s for s in target.sightings if s.line != "L6"))
    on = np.flatnonzero(scene_site.on("L6", "T1"))
    seed = survey.clouds["L6"][on[[len(on) // 2]]][0]
    again = find_target(project.with_target(fewer), survey, seed, name="T1", line="L6")
    assert {s.line for s in again.sightings} == {s.line for s in target.sightings}


@pytest.mark.parametrize(("off_deg", "agrees"), [(0.3, True), (2.0, False)])
def test_the_limit_follows_from_the_accuracy_of_the_placement(off_deg: float, agrees: bool) -> None:
    """Lines displaced by an error of the boresight, judged as accurate to 0.2 deg."""
    scene_site = scenery("wall 0.3 m behind")
    _, survey = scene_site.opened((off_deg, -off_deg, off_deg))
    lines = ["L1", "L2", "L3"]
    clouds = {line: survey.clouds[line] for line in lines}
    found = {
        line: replace(
            patch_of(clouds[line][on], np.arange(len(on)), np.array([0.0, 1.0, 0.0])), indices=on
        )
        for line, on in ((line, np.flatnonzero(scene_site.on(line, "T1"))) for line in lines)
    }
    kept, rejected = split_by_agreement(
        found, clouds, PlacementAccuracy(np.radians(0.2)), 2.0, "L1"
    )
    assert (set(kept) == set(lines)) is agrees
    assert set(kept) | set(rejected) == set(lines)
    assert "L1" in kept
    # With the accuracy of an unconfirmed prior the same displacement is possible.
    assert not split_by_agreement(found, clouds, PlacementAccuracy(np.radians(2.0)), 2.0, "L1")[1]
