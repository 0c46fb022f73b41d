"""Tests of proposed targets on random scenes without boards."""

from dataclasses import replace
from itertools import combinations, product

import numpy as np
import pytest

from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.duplicate_targets import MAX_SIGMA_DIFFERENCE, prediction_warnings
from lispac.errors import RankDeficient, TargetNotFound
from lispac.messages import error, note
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.proposal_acceptance import with_accepted_targets
from lispac.workflow.calibration.proposals import (
    MAX_POOR_SHARE,
    UNCHECKED_TARGET_CODES,
    propose_targets,
)
from lispac.workflow.calibration.sighting_assessment import sighting_qualities
from lispac.workflow.calibration.target_choice import MIN_TARGETS
from lispac.workflow.calibration.targetless import targetless
from lispac.workflow.checking.validation import validate
from tests.studies.natural_scenes import form_factors, natural_site, opened, study
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long

SCENE_GOOD = 6
"""Six lines and many flat surfaces."""
SCENE_OVERLAP = 28
"""Six lines; two detected planes have points in common."""
SCENE_THREE_SURFACES = 5
"""Six lines and three flat surfaces."""
SCENE_NOT_FLAT = 7
"""Four lines and one flat surface."""
SCENE_TWO_SURFACES = 10
"""Two flat surfaces."""
SCENE_OPPOSITE_LINES = 11
"""Two opposite lines whose flat surfaces do not determine yaw."""


@pytest.mark.long
def test_proposed_targets_are_controlled_and_have_the_predicted_sigmas() -> None:
    site = natural_site(SCENE_GOOD)
    project, survey = opened(site, np.array([1.0, -1.0, 1.0]))
    proposal = propose_targets(project, survey)
    targets = [target for target in proposal.targets if target.role == "target"]
    planes = [target for target in proposal.targets if target.role == "validation"]
    assert len(targets) >= MIN_TARGETS
    assert planes
    assert proposal.warnings == ()
    for plane, target in product(planes, targets):
        for one, other in product(plane.sightings, target.sightings):
            assert one.line != other.line or not np.isin(one.indices, other.indices).any()
    qualities = sighting_qualities(replace(project, targets=planes), survey)
    for plane in planes:
        uneven = [qualities[plane.name, s.line].flatness != "good" for s in plane.sightings]
        assert np.mean(uneven) < MAX_POOR_SHARE
    accepted, _ = with_accepted_targets(project, proposal, [each.name for each in proposal.targets])
    solved = estimate(accepted, survey, cross_check=False)
    result = solved.result
    assert result is not None
    assert result.sigma == pytest.approx(proposal.sigma, rel=MAX_SIGMA_DIFFERENCE)
    assert prediction_warnings(solved) == ()
    assert validate(solved, survey).not_compared == {}
    assert (np.abs(result.boresight - site.boresight) < 3.3 * result.sigma).all()
    # Each angle is determined without any single target.
    one_way = project.with_settings(replace(project.settings, accept_single_orientation=True))
    for kept in combinations(targets, len(targets) - 1):
        part = estimate(replace(one_way, targets=kept), survey, cross_check=False).result
        assert part is not None
        assert (part.sigma < 5 * result.sigma).all()


@LONG
def test_a_plane_with_points_of_a_target_is_not_proposed_for_validation() -> None:
    """In this scene, a detected plane continues a target on all lines."""
    site = natural_site(SCENE_OVERLAP)
    project, survey = opened(site, np.random.default_rng([35, SCENE_OVERLAP]).normal(0, 1.0, 3))
    proposal = propose_targets(project, survey)
    roles = [target.role for target in proposal.targets]
    assert roles == ["target"] * 3 + ["validation"] * 2
    for target, plane in product(proposal.targets[:3], proposal.targets[3:]):
        for one, other in product(target.sightings, plane.sightings):
            assert one.line != other.line or not np.isin(one.indices, other.indices).any()


@LONG
def test_missing_validation_planes_are_reported() -> None:
    project, survey = opened(natural_site(SCENE_THREE_SURFACES), np.array([1.0, -1.0, 1.0]))
    proposal = propose_targets(project, survey)
    assert [target.role for target in proposal.targets] == ["target"] * 3
    assert [message.code for message in proposal.warnings] == ["targets.no_validation_plane"]


@LONG
@pytest.mark.parametrize(("scene", "rough"), others_long([(41, {"T1", "T3"}), (37, set())]))
def test_form_factors_of_simulated_surfaces(scene: int, rough: set[str]) -> None:
    """In scene 37 all proposed surfaces are flat, in scene 41 T1 and T3 are rough."""
    site = natural_site(scene)
    project, survey = opened(site, np.random.default_rng([35, scene]).normal(0, 1.0, 3))
    targets = propose_targets(project, survey).targets
    factors = form_factors(site, replace(project, targets=targets))
    assert {name for name, factor in factors.items() if factor >= 1} == rough


def test_a_scene_without_flat_surfaces_is_refused() -> None:
    project, survey = opened(natural_site(SCENE_NOT_FLAT), np.zeros(3))
    with pytest.raises(TargetNotFound, check=has_code("propose.few_flat_surfaces")):
        propose_targets(project, survey)


def test_parallel_lines_are_refused_and_the_targetless_method_works() -> None:
    """The targetless method, which the message suggests, gives a result."""
    site = natural_site(SCENE_OPPOSITE_LINES)
    project, survey = opened(site, np.array([1.0, -1.0, 1.0]))
    with pytest.raises(RankDeficient) as raised:
        propose_targets(project, survey)
    assert raised.value.message == error(
        "propose.undetermined",
        project=project.name,
        direction=note("adjustment.angle_yaw"),
        reason=note("adjustment.parallel_lines"),
    )
    found = targetless(project, survey).result
    assert (np.abs(found.boresight - site.boresight) < 3 * found.sigma).all()


@LONG
def test_targets_without_mutual_control_are_reported() -> None:
    """The scene has two flat surfaces only, and neither alone determines the angles."""
    project, survey = opened(natural_site(SCENE_TWO_SURFACES), np.zeros(3))
    proposal = propose_targets(project, survey)
    assert [target.role for target in proposal.targets].count("target") == 2
    codes = [warning.code for warning in proposal.warnings]
    assert UNCHECKED_TARGET_CODES & set(codes)
    assert "targets.proposal_unchecked" in codes


@LONG
@pytest.mark.parametrize(
    ("scene", "bent"), [(64, ()), pytest.param(73, ("T1", "T3"), marks=pytest.mark.long)]
)
def test_only_true_form_errors_are_reported(scene: int, bent: tuple[str, ...]) -> None:
    """Both scenes have two lines; in scene 64 POS errors make a flat target look bent."""
    project, survey = opened(
        natural_site(scene), np.random.default_rng([35, scene]).normal(0, 1.0, 3)
    )
    proposal = propose_targets(project, survey)
    solved = estimate(replace(project, targets=proposal.targets), survey)
    assert solved.result is not None
    assert any(target.noise > 2 for target in solved.result.targets)
    found = [
        message for message in result_warnings(solved.result, solved.cross_checks)
        if message.code == "adjustment.not_flat"
    ]  # fmt: skip
    assert [message.params["targets"] for message in found] == ([bent] if bent else [])
    # There are no other surfaces to replace them.
    named = [
        message.params["targets"] for message in proposal.warnings
        if message.code == "targets.proposal_not_flat"
    ]  # fmt: skip
    assert named == ([list(bent)] if bent else [])


@pytest.mark.long
@pytest.mark.timeout(3600)
def test_intervals_have_the_stated_coverage_on_two_hundred_scenes() -> None:
    results = [each for each in study(200) if each.error is not None]
    assert len(results) >= 150
    without_warning = [each for each in results if not each.serious]
    assert len(without_warning) >= 60
    covered, covered_without_warning = (
        np.mean([np.abs(each.error) < 1.96 * each.sigma for each in some], axis=0)
        for some in (results, without_warning)
    )
    print(
        f"{len(without_warning)} of {len(results)} scenes without a serious warning: "
        f"{covered_without_warning}"
    )
    assert ((covered >= 0.90) & (covered <= 0.98)).all(), covered
    assert (covered_without_warning >= 0.93).all(), covered_without_warning
    ratio = np.array([each.sigma / each.predicted for each in results])
    print(f"stated over predicted, median {np.median(ratio, axis=0)}")
    assert (np.abs(np.median(ratio, axis=0) - 1) < MAX_SIGMA_DIFFERENCE).all()
