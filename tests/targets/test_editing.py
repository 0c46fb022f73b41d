"""Tests of manually adding and removing points of sightings."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.errors import ProjectError
from lispac.io.project.project_file import read_project, write_project
from lispac.project import PickedSighting, Project, Target
from lispac.simulation.scene import Sphere
from lispac.workflow.calibration.point_edits import (
    EDIT_MARGIN,
    MIN_POINTS_PER_SIGHTING,
    with_points,
    without_points,
)
from lispac.workflow.calibration.reselection import reselect_targets
from lispac.workflow.project.survey import Survey
from tests.support.error_codes import has_code
from tests.support.few_lines import picked
from tests.support.finder_scenes import WALL, site


def test_removed_points_can_be_added_again(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    clouds, whole = survey.placed(project, "estimated"), project.target("T1")
    line = whole.sightings[2].line
    level = float(clouds[line][whole.sightings[2].indices][:, 2].mean())
    less, count = without_points(whole, clouds, lambda points: points[:, 2] > level, line)
    for before, after in zip(whole.sightings, less.sightings, strict=True):
        if before.line != line:
            assert after is before
            continue
        assert after.by_hand
        assert after.fingerprint == before.fingerprint
        assert len(before.indices) - len(after.indices) == count > 100
        kept = clouds[line][after.indices]
        assert kept[:, 2].max() <= level
        centred = kept - kept.mean(axis=0)
        rms = np.linalg.svd(centred, compute_uv=False)[2] / np.sqrt(len(kept))
        assert after.rms == pytest.approx(rms, rel=1e-6)
    # All points near the plane are restored; points of the wall behind are not added.
    more, back = with_points(less, clouds, lambda points: np.ones(len(points), bool), line)
    sighting = more.sighting(line)
    assert sighting is not None
    found = set(sighting.indices.tolist())
    original = set(whole.sightings[2].indices.tolist())
    assert len(original - found) <= 0.01 * len(original)
    assert back == len(found) - len(less.sightings[2].indices)
    points = clouds[line][sighting.indices]
    centre, _, axes = points.mean(axis=0), *np.linalg.svd(points - points.mean(axis=0))[1:]
    assert np.abs((points - centre) @ axes[2]).max() < 2 * whole.threshold
    assert np.linalg.norm(points - centre, axis=1).max() < 1.2 + EDIT_MARGIN


def test_all_given_lines_are_edited_and_an_empty_selection_changes_nothing(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    target = project.target("T1")
    less, count = without_points(target, survey.clouds, lambda p: p[:, 2] > np.median(p[:, 2]))
    assert all(sighting.by_hand for sighting in less.sightings)
    removed = [len(a.indices) - len(b.indices)
               for a, b in zip(target.sightings, less.sightings, strict=True)]  # fmt: skip
    assert sum(removed) == count
    assert min(removed) > 0
    same, none = without_points(target, survey.clouds, lambda p: np.zeros(len(p), bool))
    assert same is target
    assert none == 0
    shown = {line: survey.clouds[line] for line in survey.lines[:2]}
    less, _ = without_points(target, shown, lambda p: p[:, 2] > np.median(p[:, 2]))
    assert [s.line for s in less.sightings if s.by_hand] == list(survey.lines[:2])


def test_removing_all_points_of_a_sighting_is_refused(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    with pytest.raises(ProjectError) as raised:
        without_points(
            project.target("T1"),
            survey.clouds,
            lambda p: np.arange(len(p)) >= MIN_POINTS_PER_SIGHTING - 1,
        )
    assert raised.value.code == "edit.few_points_left"


def test_edited_sightings_are_not_reselected_and_are_stored(
    calibrated: tuple[Project, Survey], copy: Project
) -> None:
    project, survey = calibrated
    target = project.target("T1")
    line = target.sightings[0].line
    less, _ = without_points(target, survey.clouds, lambda p: p[:, 2] > np.median(p[:, 2]), line)
    edited = replace(project, targets=tuple(less if t is target else t for t in project.targets))
    again = reselect_targets(edited, survey).target("T1")
    np.testing.assert_array_equal(again.sightings[0].indices, less.sightings[0].indices)
    assert len(again.sightings[1].indices) > 0
    whole = reselect_targets(project, survey).target("T1")
    assert len(whole.sightings[0].indices) > 1.5 * len(less.sightings[0].indices)
    write_project(replace(copy, targets=edited.targets))
    read = read_project(copy.folder).target("T1")
    assert [s.by_hand for s in read.sightings] == [s.line == line for s in read.sightings]
    np.testing.assert_array_equal(read.sightings[0].indices, less.sightings[0].indices)


def test_only_points_near_the_surface_of_a_ball_are_added() -> None:
    """Half of the points are removed and restored; the RMS is that of a sphere of known radius."""
    centre, radius = np.array([0.0, WALL, 8.0]), 0.4
    ball = Sphere("T1", centre, radius, 200.0)
    scene_site = site([ball], lines=2, pulses_per_second=200_000.0)
    _, survey = scene_site.opened()
    sightings = tuple(
        PickedSighting(line, np.flatnonzero(scene_site.on(line, "T1")), 0.002)
        for line in survey.lines
    )
    target = Target(
        "S1", "target", (0.0, WALL, 8.0), 0.02, 1.0, sightings, shape="sphere",
        sphere_radius=radius,
    )  # fmt: skip
    less, count = without_points(target, survey.clouds, lambda p: p[:, 2] > 8.0)
    assert count > 50
    more, back = with_points(less, survey.clouds, lambda p: np.ones(len(p), bool))
    assert back >= 0.9 * count
    for line, whole, low, again in zip(
        survey.lines, sightings, less.sightings, more.sightings, strict=True
    ):
        points = survey.clouds[line][low.indices]
        assert points[:, 2].max() <= 8.0
        assert len(again.indices) >= 0.95 * len(whole.indices)
        off = np.linalg.norm(survey.clouds[line][again.indices] - centre, axis=1) - radius
        assert np.ptp(off) < 0.1
        assert 0.001 < again.rms < 0.01


def test_remaining_points_on_one_straight_line_are_refused() -> None:
    project, survey = picked()
    target = project.target("T1")
    one = target.sightings[0]
    twice = replace(one, indices=np.repeat(one.indices[:1], 2 * MIN_POINTS_PER_SIGHTING))
    thin = replace(target, sightings=(twice,))
    first = iter([True])
    with pytest.raises(ProjectError, check=has_code("edit.no_surface_left", target="T1")):
        without_points(
            thin, survey.clouds, lambda p: np.arange(len(p)) < (1 if next(first, False) else 0)
        )
