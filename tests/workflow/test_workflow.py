"""Tests of the steps from picking to validation on the built-in survey with its known truth."""

import json
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.stochastic_model import POS_ERROR_MODELS, PosErrors, StochasticModel
from lispac.errors import LispacError
from lispac.geometry.frames import LocalFrame
from lispac.messages import note
from lispac.project import Project
from lispac.simulation.simulated_survey import port_survey
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from lispac.value_conversion import encode_value
from lispac.workflow.calibration import estimation as calibration
from lispac.workflow.calibration import picking
from lispac.workflow.checking.validation import validate
from lispac.workflow.output import export
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.output_crs import LOCAL_FRAME
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.long_runs import LONG


def test_noise_free_survey_determines_the_boresight() -> None:
    """Two degrees per axis are found to 1e-6 deg from the labelled points of the simulator."""
    survey = port_survey(boresight_deg=(2.0, 2.0, 2.0), noise=False, pos_errors=False)
    path = survey.trajectory
    attitude = np.stack([path.roll, path.pitch, path.heading], axis=1)
    raw = Trajectory(path.time, path.latitude, path.longitude, path.height, attitude)
    trajectory = LocalTrajectory.of(raw, LocalFrame(*survey.origin))
    rows, sightings = [], []
    for target in survey.targets:
        label = survey.surface_names.index(target)
        for line in survey.lines:
            own = line.label == label
            rows.append((line.points_lidar[own], line.time[own]))
            sightings.append(Sighting(target, line.name))
    points = np.concatenate([row[0] for row in rows])
    time = np.concatenate([row[1] for row in rows])
    poses = trajectory.at(time)
    observations = Observations(
        points,
        poses.position,
        poses.attitude,
        np.full(points.shape, 0.003),
        np.full(points.shape, 0.012),
        np.full(points.shape, np.radians(0.008)),
        time,
        np.repeat(np.arange(len(sightings)), [len(row[1]) for row in rows]),
        tuple(sightings),
    )
    for pos_errors in POS_ERROR_MODELS:
        result = adjust(
            observations, Mounting(survey.lever_arm, np.zeros(3)), StochasticModel(pos_errors)
        )
        np.testing.assert_allclose(np.degrees(result.boresight), 2.0, rtol=0, atol=1e-6)


def test_every_line_yields_both_targets(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    for name in ("T1", "T2"):
        assert {s.line for s in project.target(name).sightings} == set(survey.lines)


def test_truth_is_in_the_confidence_interval(calibrated: tuple[Project, Survey]) -> None:
    """The built-in survey is one sample, so the interval is three sigma."""
    project, _ = calibrated
    assert project.result is not None
    assert project.truth_deg is not None
    error = np.degrees(project.result.boresight) - project.truth_deg
    assert (np.abs(error) < 3 * np.degrees(project.result.sigma)).all(), error
    assert np.degrees(project.result.sigma).max() < 0.05


def test_every_validation_plane_is_better_after(calibrated: tuple[Project, Survey]) -> None:
    project, _ = calibrated
    assert [comparison.name for comparison in project.validation] == ["V1", "V2", "V3", "V4", "V5"]
    for comparison in project.validation:
        assert comparison.after.rms < 0.5 * comparison.before.rms, comparison.name


def test_saved_project_opens_the_same(calibrated: tuple[Project, Survey], copy: Project) -> None:
    project, _ = calibrated
    assert copy.result is not None
    assert project.result is not None
    np.testing.assert_array_equal(copy.result.boresight, project.result.boresight)
    np.testing.assert_array_equal(copy.result.covariance, project.result.covariance)
    assert copy.settings == project.settings
    assert [t.name for t in copy.targets] == [t.name for t in project.targets]
    for ours, theirs in zip(copy.targets, project.targets, strict=True):
        for one, other in zip(ours.sightings, theirs.sightings, strict=True):
            np.testing.assert_array_equal(one.indices, other.indices)
    assert copy.lines[0].path == copy.folder / "raw" / project.lines[0].path.name
    assert encode_value(copy.validation) == encode_value(project.validation)
    reloaded = load_survey(copy)
    again = calibration.estimate(copy, reloaded)
    assert again.result is not None
    np.testing.assert_array_equal(again.result.boresight, project.result.boresight)


def test_edits_discard_dependent_results(calibrated: tuple[Project, Survey]) -> None:
    project, _ = calibrated
    assert project.without_target("V1").result is project.result
    assert project.without_target("V1").validation == project.validation[1:]
    assert project.without_target("T1").result is None
    assert project.with_target(replace(project.target("T1"), used=False)).result is None
    assert project.with_settings(replace(project.settings, lidar_sigma=0.01)).result is None
    as_target = replace(project.target("V1"), role="target")
    assert project.with_target(as_target).result is None


@pytest.mark.parametrize("pos_errors", POS_ERROR_MODELS)
def test_the_count_equals_the_points_of_the_adjustment(
    calibrated: tuple[Project, Survey], pos_errors: PosErrors
) -> None:
    project, survey = calibrated
    settings = replace(project.settings, pos_errors=pos_errors)
    count = calibration.count_points(project, survey, settings)
    result = calibration.estimate(
        project, survey, settings=settings, reselections=0, cross_check=False
    ).result
    assert result is not None
    assert count == result.points


@LONG
def test_repeated_selection_does_not_change_clean_boards(
    calibrated: tuple[Project, Survey],
) -> None:
    """The boards are passed too fast for the prior to smear their points."""
    project, survey = calibrated
    assert project.result is not None
    picks = calibration.estimate(project, survey, reselections=0).result
    assert picks is not None
    moved = np.abs(picks.boresight - project.result.boresight) / project.result.sigma
    assert (moved < 0.3).all(), moved


@LONG
def test_estimating_twice_gives_the_same_result(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    again = calibration.estimate(project, survey)
    assert again.targets is project.targets
    assert again.result is not None
    assert project.result is not None
    np.testing.assert_array_equal(again.result.boresight, project.result.boresight)


def test_a_line_can_have_its_own_seed(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    line = survey.lines[2]
    target = project.target("T1")
    without_sighting = replace(
        target,
        sightings=tuple(s for s in target.sightings if s.line != line),
        missing={line: note("finder.not_alike")},
    )
    own = target.sighting(line)
    assert own is not None
    seed = survey.clouds[line][own.indices].mean(axis=0)
    found = picking.find_target(
        project.with_target(without_sighting), survey, seed, name="T1", line=line
    )
    assert [s.line for s in found.sightings] == list(survey.lines)
    assert found.missing == {}
    sighting = found.sighting(line)
    assert sighting is not None
    shared = np.intersect1d(sighting.indices, own.indices)
    assert len(shared) > 0.95 * len(own.indices)


@LONG
def test_a_plane_that_cannot_be_compared_does_not_stop_the_others(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    plane = project.target("V1")
    on_one_line = replace(plane, sightings=plane.sightings[:1])
    validated = validate(project.with_target(on_one_line), survey)
    assert [c.name for c in validated.validation] == ["V2", "V3", "V4", "V5"]
    reason = validated.not_compared["V1"]
    assert reason.code == "validation.plane_in_one_line"
    found = export.report_content_of(validated, survey).warnings
    reasons = [each.params["reason"] for each in found if each.code == "report.not_compared"]
    assert reasons == [reason]


def test_georeferenced_files_have_the_positions_of_the_project(
    calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    project, survey = calibrated
    written = georeference_project(project, tmp_path, "estimated", system=LOCAL_FRAME)
    assert len(written) == len(survey.lines)
    placed = survey.placed(project, "estimated")
    for done, line in zip(written, survey.lines, strict=True):
        np.testing.assert_allclose(laspy.read(done.path).xyz, placed[line].sample, atol=0.00051)


@pytest.mark.long  # `test_cli` covers the command line
def test_reports_are_written_in_all_formats(
    calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    project, survey = calibrated
    assert project.result is not None
    for ending in export.REPORT_ENDINGS:
        export.write_report(project, survey, tmp_path / f"report{ending}")
    assert (tmp_path / "report.pdf").read_bytes().startswith(b"%PDF")
    numbers = json.loads((tmp_path / "report.json").read_text())
    assert f"{np.degrees(project.result.boresight[1]):.10f}"[:8] in json.dumps(numbers)
    with pytest.raises(LispacError) as raised:
        export.write_report(project, survey, tmp_path / "report.docx")
    assert raised.value.code == "report.ending"
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "report.html", "report.json", "report.pdf", "report.zip",
    ]  # fmt: skip


def test_default_names_are_the_first_free_ones(calibrated: tuple[Project, Survey]) -> None:
    project, _ = calibrated
    assert picking.next_name(project, "target") == "T3"
    assert picking.next_name(project.without_target("V2"), "validation") == "V2"
    assert set(demo_seeds()) == {target.name for target in project.targets}
