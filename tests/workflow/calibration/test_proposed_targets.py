"""Tests of proposed targets: rippled sheets, natural planes, planes of a drone survey."""

import json
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from itertools import combinations, product
from pathlib import Path
from typing import cast

import numpy as np
import pytest

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.cli.main import main
from lispac.duplicate_targets import MAX_SIGMA_DIFFERENCE, prediction_warnings
from lispac.errors import AdjustmentError, RankDeficient, TargetNotFound
from lispac.project import Project, Target
from lispac.simulation.scene import tilted_rectangle, upright_rectangle
from lispac.simulation.simulated_survey import SimulatedSurvey
from lispac.survey.cloud import CloudInMemory
from lispac.survey.scan import Scan
from lispac.targets.plane_detection import DetectedPlane
from lispac.targets.sighting_quality import SightingQuality, undetermined_quality
from lispac.workflow.calibration import proposals
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.proposals import propose_targets
from lispac.workflow.calibration.sighting_assessment import sighting_qualities
from lispac.workflow.calibration.target_choice import CandidatePlanes
from lispac.workflow.checking.validation import validate
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.error_codes import has_code
from tests.support.few_lines import site_of_few_lines
from tests.support.finder_scenes import WALL, Site, rippled, site
from tests.support.long_runs import LONG
from tests.targets.test_finder_sites import board, wall


@pytest.fixture
def detected(monkeypatch: pytest.MonkeyPatch) -> list[DetectedPlane]:
    """Return the list of planes that are detected for a proposal."""
    found: list[DetectedPlane] = []
    usual = proposals.detect_planes

    def kept(*arguments: object, **also: object) -> tuple[DetectedPlane, ...]:
        planes = usual(*arguments, **also)  # type: ignore[arg-type]
        found.extend(planes)
        return planes

    monkeypatch.setattr(proposals, "detect_planes", kept)
    return found


@cache
def with_sheet() -> Site:
    """Return a site with an upright board, a leaning one and a rippled sheet off a wall."""
    return site(
        [
            board(),
            tilted_rectangle("T2", (-2.6, WALL, 7.5), 1.23, 1.0, 270, 45),
            *rippled("sheet", (2.6, WALL, 8.0), 1.4, 1.2),
            wall(0.5),
        ]
    )


@cache
def with_deck() -> Site:
    """Return a site with two boards and a level deck at grazing incidence, off a wall."""
    return site(
        [
            board(),
            tilted_rectangle("T2", (-2.6, WALL, 7.5), 1.23, 1.0, 270, 45),
            tilted_rectangle("deck", (2.6, WALL, 6.5), 1.6, 1.6, 270, 88),
            wall(0.5),
        ]
    )


def mostly_on(scene_site: Site, name: str, indices: Mapping[str, np.ndarray]) -> bool:
    return bool(
        np.median([scene_site.on(line, name)[own].mean() for line, own in indices.items()]) > 0.5
    )


@pytest.mark.long
@pytest.mark.parametrize("noise", [0.0017, 0.0025])
def test_a_rippled_sheet_is_detected_and_not_proposed(
    detected: list[DetectedPlane], noise: float
) -> None:
    """Its RMS is below three times the noise, because the threshold limits the residuals."""
    scene_site = with_sheet()
    project, survey = scene_site.opened((1, -1, 1), noise=noise)
    proposal = propose_targets(project, survey)
    shown = {
        name: [
            mostly_on(
                scene_site, name, {line: patch.indices for line, patch in plane.found.items()}
            )
            for plane in detected
        ].count(True)
        for name in ("T1", "T2", "sheet", "wall")
    }
    assert shown["sheet"] >= 1, shown
    proposed = [
        {
            name
            for name in shown
            if mostly_on(scene_site, name, {s.line: s.indices for s in target.sightings})
        }
        for target in proposal.targets
    ]
    assert {"T1"} in proposed
    assert {"T2"} in proposed
    assert {"sheet"} not in proposed, proposed
    for target in proposal.targets:
        assert all(s.rms < 3 * project.settings.used_lidar_sigma for s in target.sightings)


@pytest.mark.long
def test_a_plane_of_poor_quality_on_most_lines_is_not_proposed(
    detected: list[DetectedPlane], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The deck is flat, but the angle of incidence is 78 to 81 deg."""
    qualities: list[Mapping[tuple[str, str], SightingQuality]] = []

    def kept(project: Project, survey: Survey) -> Mapping[tuple[str, str], SightingQuality]:
        qualities.append(sighting_qualities(project, survey))
        return qualities[-1]

    monkeypatch.setattr(proposals, "sighting_qualities", kept)
    scene_site = with_deck()
    project, survey = scene_site.opened((1, -1, 1))
    proposal = propose_targets(project, survey)
    (deck,) = [
        k
        for k, plane in enumerate(detected)
        if mostly_on(
            scene_site, "deck", {line: patch.indices for line, patch in plane.found.items()}
        )
    ]
    ratings = [each.rating for (name, _), each in qualities[0].items() if name == f"P{deck + 1}"]
    flat = [each.flatness for (name, _), each in qualities[0].items() if name == f"P{deck + 1}"]
    assert ratings.count("poor") >= len(ratings) / 2
    assert "poor" not in flat
    assert len(proposal.targets) == 3
    for target in proposal.targets:
        assert not mostly_on(scene_site, "deck", {s.line: s.indices for s in target.sightings})


@pytest.mark.parametrize(
    ("poor", "rough", "use"),
    [(0, 0, "any"), (1, 1, "any"), (0, 2, "not flat"), (2, 0, "at need"), (2, 2, "not flat"),
     (3, 1, "poor"), (4, 0, "poor")],
)  # fmt: skip
def test_use_of_a_plane_by_its_quality(poor: int, rough: int, use: str) -> None:
    usual = replace(undetermined_quality(500, 0.002, "oblique"), flatness="good")
    lines = {
        f"L{k + 1}": replace(
            usual,
            rating="poor" if k < poor else "doubtful",
            flatness="poor" if k < rough else "good",
        )
        for k in range(4)
    }
    plane_use = proposals._assess_plane(lines)
    assert plane_use.use == use
    assert plane_use.poor == tuple(lines)[:poor]
    assert plane_use.reason == ("oblique" if poor else "")


def test_a_site_with_a_rippled_sheet_only_is_refused_with_its_reason() -> None:
    surfaces = [*rippled("T1", (0.0, WALL, 8.0), 1.4, 1.2), wall(0.5)]
    scene_site = site(surfaces, lines=4, pulses_per_second=60_000.0)
    project, survey = scene_site.opened()
    with pytest.raises(TargetNotFound) as raised:
        propose_targets(project, survey)
    assert raised.value.code == "propose.few_flat_surfaces"
    assert raised.value.message is not None
    assert raised.value.message.params["count"] == raised.value.message.params["uneven"] == 1


def adjusted_with(
    project: Project, survey: Survey, targets: tuple[Target, ...]
) -> AdjustmentResult:
    """Return the result of an adjustment with only these planes as targets."""
    bare = replace(project, targets=tuple(replace(each, role="target") for each in targets))
    result = estimate(replace(bare, result=None), survey, cross_check=False).result
    assert result is not None
    return result


def normalised_differences(first: AdjustmentResult, second: AdjustmentResult) -> np.ndarray:
    """Return differences of roll, pitch, yaw over their combined sigmas."""
    return np.abs(first.boresight - second.boresight) / np.hypot(first.sigma, second.sigma)


@pytest.mark.long
def test_planes_are_added_if_boards_do_not_determine_an_angle() -> None:
    """Two boards of similar orientation, a wall and a roof, on two opposite lines."""
    scene_site = site(
        [
            board(),
            tilted_rectangle("T2", (-2.0, WALL, 8.0), 1.23, 1.2, 270, 15),
            tilted_rectangle("roof", (3.4, WALL + 0.2, 8.5), 4.0, 4.5, 270, 50),
            wall(0.5),
        ],
        lines=2,
    )
    project, survey = scene_site.opened((1, -1, 1))
    proposal = propose_targets(project, survey)
    shown = {
        target: name
        for target in proposal.targets
        for name in ("T1", "T2", "roof", "wall")
        if mostly_on(scene_site, name, {s.line: s.indices for s in target.sightings})
    }
    chosen = tuple(target for target in shown if target.role == "target")
    boards = tuple(target for target, name in shown.items() if name in ("T1", "T2"))
    assert len(boards) == 2
    assert {shown[target] for target in chosen} - {"T1", "T2"}
    with pytest.raises(RankDeficient):
        adjusted_with(project, survey, boards)
    result = adjusted_with(project, survey, chosen)
    assert (np.abs(result.boresight - scene_site.boresight) < 3 * result.sigma).all()


@LONG
def test_parallel_planes_are_proposed_if_accepted() -> None:
    """Two upright boards, one a little behind the other; refused without the setting."""
    boards = [
        upright_rectangle(f"T{k}", (k - 1.5, WALL - k / 2), 7.0, 8.2, 1.2, 270) for k in (1, 2)
    ]
    scene_site = site(boards, lines=3, pulses_per_second=50_000.0)
    project, survey = scene_site.opened((1, -1, 1))
    with pytest.raises(AdjustmentError) as caught:
        propose_targets(project, survey)
    assert caught.value.code == "propose.one_orientation"
    accepted = replace(project.settings, accept_single_orientation=True)
    project = project.with_settings(accepted)
    proposal = propose_targets(project, survey)
    assert [target.name for target in proposal.targets] == ["T1", "T2"]
    for reason in proposal.reasons.values():
        if reason.code == "propose.target":
            assert reason.params["without"] >= 1.02 * reason.params["sigma"]
    result = estimate(replace(project, targets=proposal.targets), survey, cross_check=False).result
    assert result is not None
    assert (np.abs(result.boresight - scene_site.boresight) < 3.5 * result.sigma).all()


@pytest.mark.long
def test_in_the_classical_model_the_same_boards_are_proposed() -> None:
    project, survey = site_of_few_lines().opened((1, -1, 1))
    thesis = project.with_settings(replace(project.settings, pos_errors="independent"))
    usual, proposal = propose_targets(project, survey), propose_targets(thesis, survey)
    for one, other in zip(usual.targets, proposal.targets, strict=True):
        assert (one.name, one.seed) == (other.name, other.seed)
    # Independent POS errors per point average out, so roll seems far too precise.
    assert proposal.sigma[0] < 0.7 * usual.sigma[0]


@LONG
def test_targets_close_to_each_other_are_not_proposed_together() -> None:
    """Two of four boards are 0.65 m apart, less than a twentieth of their distance to the lines."""
    boards = [
        tilted_rectangle(f"T{k}", (north, WALL, 7.0), 0.6, 1.0, 270 + across, lean)
        for k, (north, across, lean) in enumerate(
            [(-2.6, 0, 5), (0.0, 20, 45), (0.65, -20, 40), (2.6, -30, 10)]
        )
    ]
    project, survey = site(boards, lines=4, pulses_per_second=60_000.0).opened((1, -1, 1))
    proposal = propose_targets(project, survey)
    seeds = [np.array(each.seed) for each in proposal.targets if each.role == "target"]
    assert len(seeds) == 3
    assert min(np.linalg.norm(one - other) for one, other in combinations(seeds, 2)) > 1.5
    assert "targets.proposal_unchecked" not in [each.code for each in proposal.warnings]


@cache
def with_eight_boards() -> Site:
    """Return a site with eight boards of similar orientation."""
    facing = [(0, 3), (0, 6), (3, 0), (-3, 0), (6, 3), (-6, 3), (3, 6), (35, 0)]
    boards = [
        tilted_rectangle(
            f"T{k}", (2.0 * (k % 4) - 3, WALL, 6.0 + 2 * (k // 4)), 1.1, 1.0, 270 + across, lean
        )
        for k, (across, lean) in enumerate(facing)
    ]
    return site(boards, lines=4, pulses_per_second=40_000.0)


def test_boards_are_proposed_while_each_adds_information() -> None:
    """Four of the boards remain for validation."""
    project, survey = with_eight_boards().opened((1, -1, 1))
    proposal = propose_targets(project, survey)
    assert [target.name for target in proposal.targets] == [
        "T1", "T2", "T3", "T4", "V1", "V2", "V3", "V4",
    ]  # fmt: skip
    for name in ("T1", "T2", "T3", "T4"):
        reason = proposal.reasons[name]
        assert reason.code == "propose.target"
        (k,) = (
            k
            for k, angle in enumerate(ANGLES)
            if reason.params["angle"] == mounting_value_name(angle)
        )
        assert reason.params["sigma"] == proposal.sigma[k] < cast(float, reason.params["without"])


@pytest.mark.long
def test_a_target_that_is_probably_not_flat_is_replaced(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first adjustment finds this for T1, that without it for no target."""
    chosen: list[list[str]] = []
    usual = proposals.choose_targets

    def kept(planes: CandidatePlanes) -> list[str]:
        chosen.append(usual(planes))
        return chosen[-1]

    monkeypatch.setattr(proposals, "choose_targets", kept)
    monkeypatch.setattr(
        proposals, "probably_not_flat", lambda _: frozenset({"T1"} if len(chosen) == 1 else ())
    )
    project, survey = with_eight_boards().opened((1, -1, 1))
    proposal = propose_targets(project, survey)
    first, second = chosen
    assert len(second) >= 3
    assert first[0] not in second
    # It is not proposed for validation either.
    assert len(proposal.targets) == 7
    assert "targets.proposal_not_flat" not in [each.code for each in proposal.warnings]


@pytest.mark.long
def test_natural_planes_give_the_same_result_as_boards(
    calibrated: tuple[Project, Survey], port: SimulatedSurvey
) -> None:
    """The points on the boards and near their edges are removed from the port survey."""
    project, survey = calibrated
    boards = np.flatnonzero([name in ("T1", "T2") for name in port.surface_names])
    corners = np.array([port.targets["T1"], port.targets["T2"]])
    scans, clouds = {}, {}
    for line in port.lines:
        scan = survey.scans[line.name]
        assert isinstance(scan, Scan)
        assert len(scan) == len(line.label)
        near = np.linalg.norm(line.true_points_local[:, None] - corners, axis=2).min(axis=1) < 1.2
        kept = ~np.isin(line.label, boards) & ~(near & (line.label < 0))
        scans[line.name] = Scan(scan.points_lidar[kept], scan.time[kept])
        clouds[line.name] = CloudInMemory.of(
            scans[line.name], survey.trajectory, project.mounting("prior")
        )
    bare = replace(survey, scans=scans, clouds=clouds)
    proposal = propose_targets(replace(project, targets=(), result=None), bare)
    roles = [target.role for target in proposal.targets]
    assert roles.count("target") >= 2
    assert roles.count("validation") >= 4
    for target in proposal.targets:
        for centre in corners:
            assert np.linalg.norm(target.seed - centre) > 0.3
    truth = np.radians(project.truth_deg)
    chosen = tuple(target for target in proposal.targets if target.role == "target")
    assert project.result is not None
    for targets in (chosen, proposal.targets):
        result = adjusted_with(project, bare, targets)
        print(len(targets), np.degrees(result.boresight - truth), np.degrees(result.sigma))
        assert (normalised_differences(result, project.result) < 2.5).all()
        assert (np.abs(result.boresight - truth) < 3 * result.sigma).all()


def drone_project(data: Path, folder: Path) -> Path:
    place = json.loads((data / "site.json").read_text())
    sigmas = ["--position-sigma", ".02", ".02", ".02", "--attitude-sigma", ".015", ".015", ".015"]
    new = ["new", str(folder), "--trajectory", str(data / "trajectory.sbet"), "--lever-arm"]
    new += [*map(str, place["lever_arm_m"]), "--origin", *map(str, place["origin_deg_m"])]
    new += [*sigmas, "--lidar-sigma", ".02", *map(str, sorted(data.glob("*.laz")))]
    assert main(new) == 0
    return folder


@pytest.mark.long
def test_planes_of_a_drone_survey_are_proposed(
    shared_data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A truck, with lines 0.5 m apart before the calibration, against its reference."""
    folder = drone_project(shared_data / "lanl_truck", tmp_path / "truck")
    assert main(["propose", str(folder), "--accept"]) == 0
    project = open_project(folder)
    survey = load_survey(project)
    targets, validation = project.targets_of_role("target"), project.targets_of_role("validation")
    assert len(targets) >= 3
    qualities = sighting_qualities(project, survey)
    for target in project.targets:
        uneven = [qualities[target.name, s.line].flatness != "good" for s in target.sightings]
        assert np.mean(uneven) < proposals.MAX_POOR_SHARE, target.name
    for one, other in combinations(targets, 2):
        assert np.linalg.norm(np.subtract(one.seed, other.seed)) > 1.5
    for plane, target in product(validation, targets):
        for one, other in product(plane.sightings, target.sightings):
            shared = np.isin(one.indices, other.indices).any()
            assert one.line != other.line or not shared, (plane.name, target.name)
    solved = estimate(project, survey, cross_check=False)
    result = solved.result
    assert result is not None
    # All flat planes that the lines have in common may be needed as targets.
    assert validation or "no validation plane" in capsys.readouterr().out
    assert not validation or validate(solved, survey).not_compared == {}
    assert project.prediction is not None
    ratio = result.sigma / project.prediction.sigma
    warning_codes = [message.code for message in prediction_warnings(solved)]
    assert bool(warning_codes) == bool((np.abs(ratio - 1) > MAX_SIGMA_DIFFERENCE).any())
    reference = json.loads((shared_data / "lanl_truck" / "reference.json").read_text())
    off = np.degrees(result.boresight) - reference["boresight_deg"]
    sigma = np.hypot(np.degrees(result.sigma), reference["repeatability_deg"])
    assert (np.abs(off) < 2 * sigma).all(), off


@pytest.mark.long
def test_a_tent_is_not_proposed(shared_data: Path, tmp_path: Path) -> None:
    """The cloth is not flat compared with the noise; its results are wrong by 0.2 deg."""
    project = open_project(drone_project(shared_data / "lanl_tent", tmp_path / "tent"))
    with pytest.raises(TargetNotFound, check=has_code("propose.few_flat_surfaces")):
        propose_targets(project, load_survey(project))
