"""Tests of surveys with few lines, in which targets, objects or plans have missing parts."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from lispac.design.plan_choices import thesis_plan
from lispac.design.site import Site, Wall
from lispac.errors import AdjustmentError, NotComparable, ProjectError
from lispac.io.config.plan_file import TitledPlan
from lispac.messages import note, warning
from lispac.targets.expected_target import ExpectedTarget
from lispac.workflow.calibration.estimation import complete_result, estimate
from lispac.workflow.calibration.patch_test import propose_objects
from lispac.workflow.calibration.picking import find_target, pick_target
from lispac.workflow.calibration.proposal_acceptance import (
    remove_picked_surfaces,
    with_accepted_targets,
)
from lispac.workflow.calibration.proposals import Proposal
from lispac.workflow.checking.survey_sections import section_at_target
from lispac.workflow.checking.validation import validate
from lispac.workflow.planning.plan_comparison import compare_with_plan
from lispac.workflow.project.survey import Survey
from tests.support.few_lines import on_board, picked, picked_and_estimated
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import codes


def with_lines_only(survey: Survey, *lines: str) -> Survey:
    """Return the survey with some of its lines."""
    return replace(
        survey,
        scans={name: survey.scans[name] for name in lines},
        clouds={name: survey.clouds[name] for name in lines},
        heading={name: survey.heading[name] for name in lines},
    )


def test_a_new_pick_on_one_line_keeps_the_other_lines_of_a_target() -> None:
    project, survey = picked()
    before = project.target("T2")
    seed = survey.clouds["L2"][before.sightings[1].indices].mean(axis=0)
    expected = ExpectedTarget(1.23, 1.0, radians(45.0))
    edited = pick_target(project, survey, seed, name="T2", line="L2", expected=expected)
    after = edited.target("T2")
    assert after.expected == expected
    assert after.seed == before.seed
    assert [each.line for each in after.sightings] == ["L1", "L2", "L3"]
    assert after.sightings[0] is before.sightings[0]
    assert after.sightings[2] is before.sightings[2]
    # A further pick without expected values keeps them.
    assert pick_target(edited, survey, seed, name="T2", line="L2").target("T2").expected == expected


def test_the_smallest_radius_is_used_if_no_second_line_has_points() -> None:
    """Radii of 4, 10 and 20 m are tried for a validation plane."""
    project, survey = picked()
    alone = with_lines_only(survey, "L1")
    place = on_board("T1", 0.0, 0.0)
    found = find_target(replace(project, targets=()), alone, place, name="V1", role="validation")
    assert found.radius == 4.0
    assert [each.line for each in found.sightings] == ["L1"]


@LONG
def test_a_section_of_a_sphere_has_no_separation_of_lines() -> None:
    """Unlike a plane, a sphere has no single normal to measure the separation along."""
    project, survey = picked_and_estimated()
    for cut in section_at_target(project, survey, "T1", level=True, size=2.0, thickness=0.2):
        assert cut.spread is not None
    ball = replace(project.target("T1"), shape="sphere")
    round_one = replace(project, targets=(ball,))
    for cut in section_at_target(round_one, survey, "T1", level=True, size=2.0, thickness=0.2):
        assert cut.spread is None


def test_planes_on_single_lines_are_refused_by_name() -> None:
    project, survey = picked_and_estimated()
    planes = tuple(
        replace(each, role="validation", sightings=each.sightings[:1]) for each in project.targets
    )
    with pytest.raises(NotComparable) as caught:
        validate(replace(project, targets=planes), survey)
    for name in ("T1", "T2"):
        assert name in str(caught.value)


def test_objects_of_a_single_line_are_refused() -> None:
    project, survey = picked()
    with pytest.raises(AdjustmentError) as caught:
        propose_objects(project, with_lines_only(survey, "L2"))
    assert caught.value.code == "patch_test.single_line"


def test_lines_without_common_surfaces_have_no_objects() -> None:
    """The points of each line are anywhere, as over water, without neighbours in other lines."""
    project, survey = picked()
    rng = np.random.default_rng(4)
    scans = {
        name: replace(scan, points_lidar=rng.uniform(-15, 15, scan.points_lidar.shape))
        for name, scan in survey.scans.items()
    }
    clouds = {
        name: type(cloud).of(scans[name], survey.trajectory, project.mounting("prior"))
        for name, cloud in survey.clouds.items()
    }
    with pytest.raises(AdjustmentError) as caught:
        propose_objects(project, replace(survey, scans=scans, clouds=clouds))
    assert caught.value.code == "patch_test.nothing_shared"


def test_a_result_without_observability_gets_no_advice() -> None:
    project, survey = picked_and_estimated()
    assert project.result is not None
    bare = project.with_result(replace(project.result, observability=None))
    advised = complete_result(bare, bare, survey, cross_check=False)
    assert advised.result is bare.result
    with_advice = complete_result(project, project, survey, cross_check=False)
    assert with_advice.result is not None
    assert with_advice.result.observability is not None
    assert project.result.observability is not None
    more = len(with_advice.result.observability.messages) - len(
        project.result.observability.messages
    )
    assert more in (0, 1)


def test_picked_targets_are_not_proposed_again() -> None:
    """The same boards are proposed under other names; those used as targets are listed."""
    project, survey = picked()
    seeds = {each.name: on_board(each.name, 0.0, 0.0) for each in project.targets}
    found = tuple(
        find_target(project, survey, seed, name=f"{name[0]}{9 - k}")
        for k, (name, seed) in enumerate(seeds.items())
    )
    plane = replace(found[1], role="validation")
    reasons = {each.name: note("propose.target_needed", lines=3) for each in found}
    proposal = Proposal((found[0], plane), reasons, lambda _names: np.zeros(3))
    remaining = remove_picked_surfaces(project, proposal)
    assert (remaining.targets, remaining.picked) == ((), ("T1",))
    bare = replace(project, targets=project.targets[:1])
    remaining = remove_picked_surfaces(bare, proposal)
    assert [(each.name, each.role) for each in remaining.targets] == [("V1", "validation")]
    assert remaining.reasons == {"V1": note("propose.target_needed", lines=3)}
    line = plane.sightings[0]
    target = next(s for s in bare.targets[0].sightings if s.line == line.line)
    common = target.indices[: len(line.indices) // 20]
    mixed = replace(line, indices=np.union1d(line.indices, common))
    overlapping = replace(plane, sightings=(mixed, *plane.sightings[1:]))
    shared = replace(proposal, targets=(found[0], overlapping))
    assert remove_picked_surfaces(bare, shared).targets == ()
    accepted, names = with_accepted_targets(bare, remaining, ["V1", "no such name"])
    assert names == ("V1",)
    assert [each.name for each in accepted.targets] == ["T1", "V1"]


@pytest.fixture
def planned() -> TitledPlan:
    """Return a plan of boards T1 and T2 at the quay and six lines."""
    wall = Wall((0.0, -15.0, 7.5), 270.0)
    plan = thesis_plan(Site(wall.middle, 270.0))
    named = [replace(each, name=f"T{k}") for k, each in enumerate(plan.targets, start=1)]
    return TitledPlan("Quay", plan.with_targets(named), wall)


def test_comparing_a_plan_needs_an_estimated_boresight(planned: TitledPlan) -> None:
    with pytest.raises(ProjectError) as caught:
        compare_with_plan(*picked(), planned)
    assert caught.value.code == "estimate.needed"


def test_planned_control_that_was_not_used_is_named(planned: TitledPlan) -> None:
    project, survey = picked_and_estimated()
    plan = planned.plan
    surveyed = [replace(target, control_sigma=0.002) for target in plan.targets]
    found = compare_with_plan(project, survey, replace(planned, plan=plan.with_targets(surveyed)))
    without = compare_with_plan(project, survey, planned)
    assert found.surveyed_sigma_deg == without.surveyed_sigma_deg
    (cost,) = [each for each in found.messages if each not in without.messages]
    missing = cost.params["missing"]
    assert missing.code == "plan_survey.control_not_used"
    assert missing.params["targets"] == ("T1", "T2")


def test_a_partly_surveyed_plan_may_not_determine_the_boresight(planned: TitledPlan) -> None:
    """Of the plan, one board and two opposite lines exist; the costs of the rest are listed."""
    project, survey = picked_and_estimated()
    one = project.target("T1")
    few = replace(project, targets=(replace(one, sightings=one.sightings[:2]),))
    found = compare_with_plan(few, with_lines_only(survey, "L1", "L2"), planned)
    assert found.surveyed_sigma_deg is None
    assert "does not determine" in found.summary_texts[0]
    assert found.missing_targets == ("T2",)
    assert len(found.missing_lines) == 4
    costs = [each.params.get("missing", each) for each in found.messages[-5:]]
    assert codes(costs) == ["plan_survey.line_not_surveyed"] * 4 + ["plan_survey.target_not_used"]
    unsurveyed = [planned.plan.lines[each.params["line"] - 1] for each in costs[:4]]
    assert tuple(line.name for line in unsurveyed) == found.missing_lines
    assert [each.params["heading"] for each in costs[:4]] == pytest.approx(
        [radians(line.heading_deg) for line in unsurveyed]
    )
    assert costs[4].params["target"] == "T2"
    assert "plan_survey.smaller_sigma" not in codes(found.messages)
    assert found.rows[1].values is None


@pytest.mark.parametrize(
    ("shift", "count", "code"),
    others_long([(0.0, 1, "adjustment.only_plane"), (40.0, None, "estimate.possible_cause")]),
)
def test_warnings_about_files_are_no_cause_of_too_few_targets(
    shift: float, count: int | None, code: str
) -> None:
    """In the second case, wrong times of a line make its points contradict the others."""
    project, survey = picked()
    first = survey.scans["L1"]
    scans = {**survey.scans, "L1": replace(first, time=first.time + shift)}
    survey = replace(survey, scans=scans, messages=(warning("sbet.zero_rates", file="a.sbet"),))
    with pytest.raises(AdjustmentError) as refused:
        estimate(replace(project, targets=project.targets[:count]), survey)
    assert refused.value.code == code
