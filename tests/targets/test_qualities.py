"""Tests of the ratings of all sightings of a project, before and after the calibration."""

import json
from dataclasses import replace
from math import radians

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.project import Project
from lispac.targets.boresight_smear import PRIOR_BORESIGHT_SIGMA, remove_smear
from lispac.targets.sighting_quality import plane_quality
from lispac.workflow.calibration.sighting_assessment import assess_sightings, sighting_qualities
from lispac.workflow.project.survey import Survey
from tests.support.message_codes import codes
from tests.targets.test_quality import NOISE, board, fit_plane


def with_fewer(project: Project, name: str, line: str, kept: int) -> Project:
    """Return the project with one sighting reduced to its first points."""
    target = project.target(name)
    sightings = tuple(
        replace(s, indices=s.indices[:kept]) if s.line == line else s for s in target.sightings
    )
    edited = project.with_target(replace(target, sightings=sightings))
    return replace(edited, result=project.result)


def test_every_sighting_of_the_demo_is_rated(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    after = sighting_qualities(project, survey)
    before = sighting_qualities(replace(project, result=None), survey)
    keys = {(t.name, s.line) for t in project.targets for s in t.sightings}
    assert set(before) == set(after) == keys
    targets = {target.name for target in project.targets_of_role("target")}
    # Validation planes are not selected again: they are rated as picked, before and after.
    assert all((after[key].smear is None) == (key[0] in targets) for key in keys)
    assert all(quality.smear < 0.004 for quality in before.values())
    # A tilted board seen from the side has steep incidence angles and is still not curved.
    for key in keys:
        assert after[key].rating != "poor", (key, after[key].words)
        assert not after[key].curvature > 0.006, (key, after[key].words)
        assert before[key].rating == after[key].rating, (key, before[key].words, after[key].words)


def test_unchanged_sightings_are_not_assessed_again(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    known = assess_sightings(project, survey)
    first = project.targets[0]
    line = first.sightings[0].line
    again = assess_sightings(with_fewer(project, first.name, line, 40), survey, known=known)
    assert {key[0] for key, each in again.items() if each is not known[key]} == {first.name}
    assert (
        assess_sightings(replace(project, result=None), survey, known=known).keys() == known.keys()
    )
    moved = replace(project, result=None)
    targets = {target.name for target in project.targets_of_role("target")}
    for key, each in assess_sightings(moved, survey, known=known).items():
        # A changed mounting changes the points of targets, not those of validation planes.
        assert (each is not known[key]) == (key[0] in targets)


def test_two_points_are_poor_with_the_reason(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    target = project.targets[0]
    line = target.sightings[0].line
    few = with_fewer(replace(project, result=None), target.name, line, 2)
    quality = sighting_qualities(few, survey)[target.name, line]
    assert quality.rating == "poor"
    assert codes(quality.reasons) == ["target.plane_few_points"]


def smeared(bend: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return a board deformed as by a yaw error of 1 deg, and the derivatives of its points.

    The vessel yaws while it passes: the effect of the yaw error grows with the square of the
    position along the board.
    """
    points = board(lambda x, z: bend * (x / 0.6) ** 2)
    moves = np.zeros((3, len(points), 3))
    moves[2, :, 1] = (points[:, 0] / 0.6) ** 2 * 0.5  # metres per radian
    return points + radians(1.0) * moves[2], moves


def test_deformation_that_the_prior_explains_is_not_called_curvature():
    points, moves = smeared()
    plane, every = fit_plane(points), np.arange(len(points))
    uncorrected = plane_quality(points, points, every, plane, NOISE)
    assert uncorrected.curved
    assert uncorrected.rating == "poor"
    corrected = plane_quality(points, points, every, plane, NOISE, turns_local=moves)
    assert corrected.rating == "good", corrected.words
    assert corrected.smear == pytest.approx(0.3 * radians(1.0) * 0.5, rel=0.1)
    # A deformation larger than the prior allows is one of the board itself.
    points, moves = smeared(bend=0.06)
    plane = fit_plane(points)
    assert plane_quality(points, points, every, plane, NOISE, turns_local=moves / 20).curved


def test_smear_is_not_removed_from_a_plane_seen_for_an_instant():
    rng = np.random.default_rng(2)
    placed = rng.uniform(-0.6, 0.6, (2000, 2))
    off = 0.02 * placed[:, 0] ** 2
    off -= off.mean()
    moves = np.column_stack([placed @ [3.0, 1.0], placed @ [0.5, 9.0], np.full(2000, 20.0)])
    remaining = remove_smear(placed, off, moves, NOISE, PRIOR_BORESIGHT_SIGMA)
    np.testing.assert_allclose(np.sqrt(np.mean(remaining**2)), np.std(off), rtol=0.02)


def test_terminal_prints_the_rating_of_each_sighting(
    denser_copy: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = str(denser_copy.folder)
    assert main(["estimate", folder, "--no-cross-checks", "--json"]) == 0
    qualities = json.loads(capsys.readouterr().out)["qualities"]
    assert {each["rating"] for each in qualities} <= {"good", "doubtful"}
    for each in qualities:
        assert each["points"] > 50
        assert len(each["reasons"]) == (each["rating"] != "good") or each["reasons"]
        assert 0 < each["incidence_deg"] < 90
        assert each["visible_share"] is None or 0.9 < each["visible_share"] <= 1
    assert {each["target"] for each in qualities if each["visible_share"] is not None} >= {
        "T1",
        "T2",
    }
