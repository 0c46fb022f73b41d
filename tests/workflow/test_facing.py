"""Tests of the warning about targets with the same orientation before an estimate."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.errors import RankDeficient
from lispac.project import PickedSighting, Project
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.orientation_check import have_targets_single_orientation
from lispac.workflow.checking.warnings import warnings_of
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
