"""Tests of the warnings about targets of one orientation and validation planes on targets."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.errors import RankDeficient
from lispac.project import PickedSighting, Project
from lispac.warning_causes import Cause
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.orientation_check import (
    have_targets_single_orientation,
    validation_planes_on_targets,
)
from lispac.workflow.checking.warnings import warnings_of
from lispac.workflow.output.export import report_content_of
from lispac.workflow.project.survey import Survey
from tests.support.error_codes import has_code
from tests.support.few_lines import picked


def with_targets_only(project: Project, *names: str) -> Project:
    """The project with only these targets and without a result."""
    targets = tuple(replace(each, role="target") for each in project.targets if each.name in names)
    return replace(project, targets=targets, result=None, validation=())


def test_the_warning_agrees_with_the_refusal_of_the_estimate(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    faces_one_way = {}
    for names in (("T1", "T2"), ("T1", "V1"), ("T1", "V5"), ("T2", "V1"), ("V1", "V2")):
        few = with_targets_only(project, *names)
        faces_one_way[names] = have_targets_single_orientation(few, survey)
        assert faces_one_way[names] == (
            "project.one_facing" in [each.code for each in warnings_of(few, survey)]
        )
        if faces_one_way[names]:
            with pytest.raises(RankDeficient, check=has_code("adjustment.parallel_planes")):
                estimate(few, survey, cross_check=False)
        else:
            estimate(few, survey, cross_check=False)
    assert set(faces_one_way.values()) == {True, False}


def test_one_target_or_an_accepted_orientation_gives_no_warning(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    one_orientation = with_targets_only(project, "T1", "V1")
    assert have_targets_single_orientation(
        one_orientation, survey
    ) != have_targets_single_orientation(with_targets_only(project, "T1"), survey)
    accepted = one_orientation.with_settings(
        replace(one_orientation.settings, accept_single_orientation=True)
    )
    assert not have_targets_single_orientation(accepted, survey)
    assert "project.one_facing" not in [each.code for each in warnings_of(project, survey)]


def test_balls_and_missing_lines_give_no_warning() -> None:
    """Two parallel boards give a warning, except if other targets may have another orientation."""
    project, survey = picked()
    upright = project.target("T1")
    one_orientation = replace(project, targets=(upright, replace(upright, name="parallel")))
    assert have_targets_single_orientation(one_orientation, survey)
    ball = replace(upright, name="ball", shape="sphere", sphere_radius=0.145)
    assert not have_targets_single_orientation(one_orientation.with_target(ball), survey)
    assert not have_targets_single_orientation(
        one_orientation.with_target(project.target("T2")), survey
    )
    fullest = max(upright.sightings, key=lambda each: len(each.indices)).line
    remaining = {name: cloud for name, cloud in survey.clouds.items() if name != fullest}
    assert not have_targets_single_orientation(one_orientation, replace(survey, clouds=remaining))


def test_points_on_one_straight_line_have_no_orientation() -> None:
    project, survey = picked()
    upright = project.target("T1")
    row = PickedSighting("L1", np.repeat(upright.sightings[0].indices[:1], 9), 0.0)
    thin = replace(upright, name="thin", sightings=(row,))
    assert not have_targets_single_orientation(replace(project, targets=(upright, thin)), survey)


def test_a_validation_plane_on_the_surface_of_a_target_is_named(
    calibrated: tuple[Project, Survey],
) -> None:
    """Also without common points; a parallel plane at another place is another surface."""
    project, survey = calibrated
    assert list(validation_planes_on_targets(project, survey)) == []
    board = project.target("T1")
    ordered = {
        each.line: each.indices[np.argsort(survey.clouds[each.line][each.indices][:, 0])]
        for each in board.sightings
    }
    halves = [
        tuple(
            replace(each, indices=np.sort(np.array_split(ordered[each.line], 2)[k]))
            for each in board.sightings
        )
        for k in range(2)
    ]
    half = replace(board, sightings=halves[0])
    other_half = replace(board, name="V9", role="validation", sightings=halves[1])
    both = replace(project, targets=(half, project.target("T2"), other_half))
    (found,) = validation_planes_on_targets(both, survey)
    assert found.params == {"plane": "V9", "targets": ("T1",)}
    assert found.subject == Cause.of_target("V9")
    assert found in warnings_of(both, survey)
    assert found in report_content_of(both, survey).warnings
    swapped = replace(other_half, sightings=project.target("V1").sightings)
    assert not list(validation_planes_on_targets(both.with_target(swapped), survey))
    unused = replace(half, used=False)
    assert not list(validation_planes_on_targets(both.with_target(unused), survey))
    # A plane beside the targets: V1 has the orientation of T1, T2 leans
    for name, is_named in (("V1", True), ("T2", False)):
        beside = replace(project.target(name), name="V8", role="validation")
        more = replace(project, targets=(half, other_half, beside))
        assert bool(list(validation_planes_on_targets(more, survey))) == is_named
