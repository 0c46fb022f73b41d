"""Tests of the corrected trajectory: independent readers, georeferenced lines, refusals."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest
from pyproj import Transformer

import lispac
from lispac.adjustment.result import AdjustmentResult
from lispac.cli.main import main
from lispac.errors import InputError, LispacError, ProjectError
from lispac.geometry.frames import LocalFrame
from lispac.io.las.mounting_record import MountingRecord
from lispac.project import LineSource, Project, Reading
from lispac.survey.georeferencing import georeference
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.file_reading import local_trajectory, read_trajectory
from lispac.workflow.output.corrected_trajectory import (
    WrittenTrajectory,
    write_corrected_trajectory,
)
from lispac.workflow.output.export import write_report
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.output.pos_corrections import corrected_trajectory, corrections_at
from lispac.workflow.project.projects import new_project
from lispac.workflow.project.survey import Survey
from tests.support.command_errors import refused_with
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG
from tests.support.message_codes import codes

NED_SIGNS = np.array([1.0, -1.0, -1.0, 1.0, -1.0, 1.0])


@pytest.fixture(scope="module")
def written(
    calibrated: tuple[Project, Survey], tmp_path_factory: pytest.TempPathFactory
) -> WrittenTrajectory:
    folder = tmp_path_factory.mktemp("corrected")
    return write_corrected_trajectory(
        calibrated[0], folder / "c.sbet", corrections=folder / "c.csv"
    )


@pytest.fixture
def project(calibrated: tuple[Project, Survey]) -> Project:
    return calibrated[0]


def result_of(project: Project) -> AdjustmentResult:
    assert project.result is not None
    return project.result


def sbet(path: Path) -> np.ndarray:
    """Records of an SBET, read without the program, shape (n, 17)."""
    return np.fromfile(path, "<f8").reshape(-1, 17)


def position_by_proj(records: np.ndarray, frame: LocalFrame) -> np.ndarray:
    """North, west, up of SBET records, computed by PROJ, shape (n, 3)."""
    latitude, longitude, height = frame.origin_deg_m
    pipeline = Transformer.from_pipeline(
        "+proj=pipeline +step +proj=cart +ellps=WGS84 +step +proj=topocentric +ellps=WGS84 "
        f"+lon_0={longitude!r} +lat_0={latitude!r} +h_0={height!r}"
    )
    east, north, up = pipeline.transform(records[:, 2], records[:, 1], records[:, 3], radians=True)
    return np.stack([north, -east, up], axis=1)


def test_an_independent_reader_finds_the_corrections_in_the_sbet(
    project: Project, written: WrittenTrajectory
) -> None:
    before, after = sbet(project.trajectory), sbet(written.trajectory)
    np.testing.assert_array_equal(after[:, 0], before[:, 0])
    trajectory, _ = local_trajectory(project)
    expected = corrections_at(project, trajectory, before[:, 0]).correction
    moved = position_by_proj(after, trajectory.frame) - position_by_proj(before, trajectory.frame)
    np.testing.assert_allclose(moved, expected[:, :3], rtol=0, atol=2e-8)
    turned = (after[:, 7:10] - before[:, 7:10]) * [1.0, -1.0, 1.0]
    # Heading and level at the vessel differ from those of the local frame by some 1e-5 rad
    np.testing.assert_allclose(turned, expected[:, 3:], rtol=0, atol=2e-8)
    assert np.abs(expected[:, :3]).max() > 5e-3
    assert np.abs(expected[:, 3:]).max() > 2e-5


def test_the_smrmsg_contains_the_sigmas_after_the_adjustment(
    project: Project, written: WrittenTrajectory
) -> None:
    records = np.fromfile(written.accuracy, "<f8").reshape(-1, 10)
    found = written.corrections
    np.testing.assert_array_equal(records[:, 0], found.time)
    np.testing.assert_allclose(records[:, 1:4], found.sigma[:, :3], rtol=1e-12)
    np.testing.assert_allclose(np.radians(records[:, 7:10] / 60), found.sigma[:, 3:], rtol=1e-12)
    assert project.accuracy is not None
    given = np.fromfile(project.accuracy, "<f8").reshape(-1, 10)
    prior = np.stack([np.interp(found.time, given[:, 0], column) for column in given.T], axis=1)
    own = found.supported[:, 2]
    assert (records[own, 3] < prior[own, 3]).all()
    determined = written.estimate.determined
    np.testing.assert_allclose(
        records[:, 1:4][:, ~determined[:3]], prior[:, 1:4][:, ~determined[:3]], rtol=1e-9
    )


def test_the_text_file_contains_the_corrections_and_where_they_are_supported(
    written: WrittenTrajectory,
) -> None:
    assert written.corrections_file is not None
    lines = written.corrections_file.read_text(encoding="utf-8").splitlines()
    header = [line for line in lines if line.startswith("#")]
    rows = list(csv.DictReader(lines[len(header) :]))
    found, degrees = written.corrections, np.repeat([1.0, np.degrees(1.0)], 3)
    assert [float(row["time (s)"]) for row in rows] == pytest.approx(found.time.tolist(), abs=1e-6)
    names = list(rows[0])
    values = np.array([[float(row[name]) for name in names[1:13]] for row in rows])
    expected = np.hstack([found.correction * NED_SIGNS * degrees, found.sigma * degrees])
    off = np.abs(values - expected)
    assert off[:, [0, 1, 2, 6, 7, 8]].max() < 5.1e-7
    assert off[:, [3, 4, 5, 9, 10, 11]].max() < 5.1e-9
    intervals = written.estimate.sighted_intervals
    stated = [line for line in header if line.startswith("# Sighted interval: ")]
    assert [float(line.split()[3]) for line in stated] == pytest.approx(
        intervals[:, 0].tolist(), abs=6e-4
    )
    for row, time in zip(rows, found.time, strict=True):
        inside = bool(((time >= intervals[:, 0]) & (time <= intervals[:, 1])).any())
        assert row["supported"] == ("sighted" if inside else "predicted")


def test_lines_are_georeferenced_with_the_corrected_trajectory(
    calibrated: tuple[Project, Survey], written: WrittenTrajectory, tmp_path: Path
) -> None:
    """They are where the corrected SBET, used as the trajectory, places their points."""
    project, survey = calibrated
    name = project.lines[0].name
    (done,) = georeference_project(
        project, tmp_path, system="local", lines=[name], trajectory_choice="corrected"
    )
    assert done.path.name == f"{name}_estimated_corrected.laz"
    assert "corrections.support" in codes(done.messages)
    points = laspy.read(done.path)
    raw = laspy.read(project.lines[0].path)
    from_sbet = LocalTrajectory.of(
        read_trajectory(written.trajectory, Reading()),
        survey.trajectory.frame,
        project.settings.longest_gap,
    )
    times = np.array(points.gps_time)
    np.testing.assert_array_equal(times, np.array(raw.gps_time))
    expected = georeference(raw.xyz, times, from_sbet, project.mounting("estimated"))
    assert np.abs(points.xyz - expected).max() < 2e-4
    given = georeference(raw.xyz, times, survey.trajectory, project.mounting("estimated"))
    assert np.linalg.norm(points.xyz - given, axis=1).mean() > 2e-3


@LONG
def test_a_cloud_states_that_its_trajectory_was_corrected(project: Project, tmp_path: Path) -> None:
    name = project.lines[0].name
    for choice in ("corrected", "given"):
        (done,) = georeference_project(
            project, tmp_path, system="EPSG:32619", lines=[name], trajectory_choice=choice
        )
        record = MountingRecord.read(done.path)
        assert record is not None
        assert record.is_trajectory_corrected == (choice == "corrected")
        _, survey = new_project(
            tmp_path / choice, trajectory=project.trajectory, accuracy=project.accuracy,
            lines=[LineSource("again", done.path)], settings=project.settings,
        )  # fmt: skip
        warned = "recovery.corrected_trajectory" in codes(survey.messages)
        assert warned == (choice == "corrected")


def test_corrections_of_other_states_are_added_between_the_given_ones(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    found = corrected_trajectory(project, survey.trajectory)
    added = corrections_at(project, survey.trajectory, survey.trajectory.time).correction
    np.testing.assert_array_equal(found.position, survey.trajectory.position + added[:, :3])
    np.testing.assert_array_equal(found.attitude, survey.trajectory.attitude + added[:, 3:])


def test_states_without_corrections_are_unchanged(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    raw = read_trajectory(project.trajectory, project.trajectory_reading)
    corrections = np.zeros((len(raw.time), 6))
    corrections[100] = 1e-3
    found = raw.corrected(corrections, survey.trajectory.frame)
    for name in ("latitude", "longitude", "height", "attitude"):
        same = np.isclose(getattr(found, name), getattr(raw, name), rtol=0, atol=0)
        assert np.unique(np.nonzero(~same)[0]).tolist() == [100]
    assert raw.corrected(np.zeros((len(raw.time), 6)), survey.trajectory.frame) is raw


def _independent(project: Project) -> Project:
    result = result_of(project)
    model = replace(result.model, pos_errors="independent")
    return replace(project, result=replace(result, model=model, pos_corrections=None))


def _undetermined(project: Project) -> Project:
    found = result_of(project).pos_corrections
    assert found is not None
    nothing = replace(found, sigma=found.prior_sigma)
    return replace(project, result=replace(result_of(project), pos_corrections=nothing))


def _of_another_day(project: Project) -> Project:
    found = result_of(project).pos_corrections
    assert found is not None
    moved = replace(found, time=found.time + 86400.0)
    return replace(project, result=replace(result_of(project), pos_corrections=moved))


@pytest.mark.parametrize(
    ("change", "kind", "code"),
    [
        (lambda p: p.without_results(), ProjectError, "project.not_estimated"),
        (_independent, ProjectError, "corrections.uncorrelated"),
        (
            lambda p: replace(p, result=replace(p.result, pos_corrections=None)),
            ProjectError,
            "corrections.former_result",
        ),
        (_undetermined, ProjectError, "corrections.undetermined"),
        (_of_another_day, InputError, "corrections.other_trajectory"),
    ],
)
def test_a_result_without_corrections_is_refused(
    project: Project, tmp_path: Path, change, kind: type[LispacError], code: str
) -> None:
    changed = change(project)
    with pytest.raises(kind, check=has_code(code)):
        write_corrected_trajectory(changed, tmp_path / "c.sbet")
    with pytest.raises(kind, check=has_code(code)):
        georeference_project(
            changed, tmp_path / "lines", system="local", trajectory_choice="corrected"
        )
    assert not list(tmp_path.iterdir())


def test_the_prior_boresight_is_refused(project: Project, tmp_path: Path) -> None:
    with pytest.raises(InputError, check=has_code("corrections.prior_boresight")):
        georeference_project(
            project, tmp_path, "prior", system="local", trajectory_choice="corrected"
        )


def test_files_are_not_overwritten_and_none_is_left_after_an_error(
    project: Project, tmp_path: Path
) -> None:
    with pytest.raises(InputError, check=has_code("export.own_file")):
        write_corrected_trajectory(project, project.trajectory)
    with pytest.raises(InputError, check=has_code("corrections.same_file")):
        write_corrected_trajectory(
            project, tmp_path / "c.sbet", corrections=tmp_path / "." / "c.sbet"
        )
    (tmp_path / "folder").mkdir()
    with pytest.raises(InputError, check=has_code("file.is_folder")):
        write_corrected_trajectory(project, tmp_path / "c.sbet", corrections=tmp_path / "folder")
    assert [path.name for path in tmp_path.iterdir()] == ["folder"]


def test_the_command_writes_the_files_and_prints_the_support(
    project: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["trajectory", str(project.folder), "--output", str(tmp_path / "c.sbet")]
    words += ["--corrections", str(tmp_path / "c.csv"), "--accuracy", str(tmp_path / "a.out")]
    assert main(words) == 0
    out = capsys.readouterr().out
    assert "Corrections of the trajectory" in out
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.out", "c.csv", "c.sbet"]
    assert main([*words, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [each["component"] for each in data["components"]] == [
        "north", "east", "down", "roll", "pitch", "heading",
    ]  # fmt: skip
    found = result_of(project).pos_corrections
    assert found is not None
    assert len(data["sighted_intervals"]) == len(found.sighted_intervals)
    refused_with(
        "corrections.prior_boresight", "georeference", project.folder, "--output", tmp_path / "g",
        "--boresight", "prior", "--trajectory", "corrected", "--crs", "local",
    )  # fmt: skip


@LONG
def test_the_report_has_the_largest_corrections_of_the_file(
    calibrated: tuple[Project, Survey], written: WrittenTrajectory, tmp_path: Path
) -> None:
    project, survey = calibrated
    write_report(project, survey, tmp_path / "r.json")
    found = json.loads((tmp_path / "r.json").read_text())["trajectory_corrections"]
    with (written.trajectory.parent / "c.csv").open() as file:
        rows = [row for row in csv.reader(file) if not row[0].startswith("#")]
    numbers = np.array([row[:-1] for row in rows[1:]], dtype=float)
    named = dict(zip(rows[0][:-1], numbers.T, strict=True))
    inside = np.zeros(len(rows) - 1, dtype=bool)
    for interval in found["sighted_intervals"]:
        inside |= (named["time (s)"] >= interval["first_s"]) & (
            named["time (s)"] <= interval["last_s"]
        )
    assert inside.any()
    for each in found["components"]:
        column = next(name for name in named if name.startswith(each["component"]))
        # The report has the knots, the file the records of the trajectory, which lie between them
        assert np.abs(named[column][inside]).max() == pytest.approx(
            each["largest_correction"], rel=0.02, abs=1e-6
        )
    write_report(replace(project, result=None), survey, tmp_path / "none.json")
    assert json.loads((tmp_path / "none.json").read_text())["trajectory_corrections"] is None


def test_scripts_write_the_corrected_trajectory(project: Project, tmp_path: Path) -> None:
    opened = lispac.open(project.folder)
    paths = opened.export("corrected_trajectory", tmp_path / "c.sbet")
    assert [path.name for path in paths] == ["c.sbet", "c_smrmsg.out", "c_corrections.csv"]
    assert all(path.is_file() for path in paths)
