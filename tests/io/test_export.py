"""Tests of exported targets, plane files and trajectories, read by independent readers."""

import csv
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest
from pyproj import CRS

from lispac.adjustment.model.observations import Observations
from lispac.cli.main import main
from lispac.errors import InputError, ProjectError
from lispac.io.formats import format_of, recognise_formats
from lispac.io.text.plane_file import read_plane_files
from lispac.io.trajectory.sbet import read_sbet, write_sbet
from lispac.message_texts import english_text
from lispac.messages import note
from lispac.project import Project, Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.georeferencing import place_points
from lispac.survey.trajectory import Poses, Trajectory
from lispac.workflow.output.data_export import (
    SBET_ZEROS_NOTE,
    export_planes,
    export_targets,
    export_trajectory,
)
from lispac.workflow.output.export_request import ExportRequest, export
from lispac.workflow.project.output_crs import output_system_of
from lispac.workflow.project.survey import Survey
from tests.support.command_errors import refused_with
from tests.support.few_lines import picked
from tests.support.long_runs import LONG, others_long

UTM = "EPSG:32619"


def expected(project: Project, survey: Survey, name: str, which: str) -> dict[str, np.ndarray]:
    """Points of a target on each line by the reference formula."""
    mounting = project.mounting(which)
    parts = {}
    for sighting in project.target(name).used_sightings:
        scan = survey.scans[sighting.line]
        time = scan.time[sighting.indices]
        poses = survey.trajectory.at(time + mounting.latency)
        parts[sighting.line] = place_points(scan.points_lidar[sighting.indices], poses, mounting)
    return parts


@pytest.mark.parametrize("which", ["prior", "estimated"])
@pytest.mark.parametrize("ending", ["laz", "las"])
def test_targets_as_las(
    calibrated: tuple[Project, Survey], tmp_path: Path, which: str, ending: str
) -> None:
    project, survey = calibrated
    system = coordinate_system(UTM)
    paths = export_targets(project, survey, tmp_path, which, system=system, ending=ending)
    assert [path.name for path in paths] == [
        f"{target.name}_{which}.{ending}" for target in project.targets
    ]
    for target, path in zip(project.targets, paths, strict=True):
        las = laspy.read(path)
        assert las.header.parse_crs() == CRS(UTM)
        for line, local in expected(project, survey, target.name, which).items():
            own = np.array(las.point_source_id) == survey.lines.index(line) + 1
            on_map = system.from_local(local, survey.trajectory.frame)
            np.testing.assert_allclose(las.xyz[own], on_map, rtol=0, atol=0.61e-4)
            sighting = target.sighting(line)
            assert sighting is not None
            scan = survey.scans[line]
            np.testing.assert_array_equal(las.gps_time[own], scan.time[sighting.indices])
            scanner = np.stack([las[f"{axis}_lidar"][own] for axis in "xyz"], axis=1)
            np.testing.assert_array_equal(scanner, scan.points_lidar[sighting.indices])


@pytest.mark.parametrize(
    ("code", "header"),
    [
        ("", ["north (m)", "west (m)", "up (m)"]),
        (UTM, ["east EPSG:32619 (metre)", "north EPSG:32619 (metre)", "height (metre)"]),
        ("EPSG:4979", ["longitude EPSG:4979 (deg)", "latitude EPSG:4979 (deg)", "height (metre)"]),
        ("EPSG:4978", ["X EPSG:4978 (m)", "Y EPSG:4978 (m)", "Z EPSG:4978 (m)"]),
    ],
)
def test_targets_as_csv(
    calibrated: tuple[Project, Survey], tmp_path: Path, code: str, header: list[str]
) -> None:
    project, survey = calibrated
    system = coordinate_system(code) if code else None
    (path,) = export_targets(
        project, survey, tmp_path, "estimated", system=system, ending="csv", names=["T1"]
    )
    with path.open(newline="") as file:
        rows = list(csv.reader(file))
    assert rows[0] == [
        "line", "time (s)", *header, "x lidar (m)", "y lidar (m)", "z lidar (m)", "intensity",
    ]  # fmt: skip
    parts = expected(project, survey, "T1", "estimated")
    assert [row[0] for row in rows[1:]] == [n for n, part in parts.items() for _ in part]
    local = np.concatenate(list(parts.values()))
    found = np.array([row[2:5] for row in rows[1:]], dtype=float)
    if system is None:
        np.testing.assert_allclose(found, local, rtol=0, atol=0.51e-4)
    else:
        back = system.to_local(found, survey.trajectory.frame)
        np.testing.assert_allclose(back, local, rtol=0, atol=1.2e-4)


@pytest.mark.parametrize("which", others_long(["prior", "estimated"]))
def test_plane_files(calibrated: tuple[Project, Survey], tmp_path: Path, which: str) -> None:
    """25 columns: lever arm and boresight suffice to georeference the scanner points."""
    project, survey = calibrated
    if which == "prior":  # with all values of a mounting
        known = {"range_offset": 0.02, "scan_angle_offset_deg": 0.1, "latency": 0.003}
        project = replace(project, settings=replace(project.settings, **known))
    mounting = project.mounting(which)
    paths = export_planes(project, survey, tmp_path, which)
    assert len(paths) == len(project.targets)
    plain = replace(mounting, range_offset=0.0, scan_angle_offset=0.0, latency=0.0)
    for target, path in zip(project.targets, paths, strict=True):
        rows = np.loadtxt(path)
        assert rows.shape[1] == 25
        placed = place_points(rows[:, 5:8], Poses(rows[:, 14:17], rows[:, 8:11]), plain)
        np.testing.assert_allclose(placed, rows[:, 1:4], rtol=0, atol=1e-9)
        parts = expected(project, survey, target.name, which)
        local = np.concatenate(list(parts.values()))
        np.testing.assert_allclose(rows[:, 1:4], local, rtol=0, atol=1e-9)
        misclosures = rows[:, 1:4] @ rows[0, 20:23] + rows[0, 23]
        assert np.linalg.norm(rows[0, 20:23]) == pytest.approx(1)
        assert misclosures.mean() == pytest.approx(0, abs=1e-9)
    observations, _ = read_plane_files(paths, 0.005)
    assert isinstance(observations, Observations)
    assert len(observations.targets) == len(project.targets)


def test_impossible_exports_are_refused(calibrated: tuple[Project, Survey], tmp_path: Path) -> None:
    project, survey = calibrated
    with pytest.raises(ProjectError, check=lambda e: e.code == "project.no_target"):
        export_targets(project, survey, tmp_path / "out", names=["X"])
    with pytest.raises(ProjectError) as raised:
        export_targets(replace(project, targets=()), survey, tmp_path / "out", "prior")
    assert raised.value.code == "export.no_target"
    with pytest.raises(ProjectError, check=lambda e: e.code == "project.not_estimated"):
        export_planes(replace(project, result=None), survey, tmp_path / "out")
    ball = replace(project.target("T1"), shape="sphere")
    with pytest.raises(ProjectError) as raised:
        export_planes(project.with_target(ball), survey, tmp_path / "o", "prior", names=["T1"])
    assert raised.value.code == "export.sphere"
    with pytest.raises(InputError) as raised:
        export_trajectory(project, project.trajectory)
    assert raised.value.code == "export.own_trajectory"
    assert not list(tmp_path.iterdir())


def test_points_without_intensity_are_written_without_it(tmp_path: Path) -> None:
    """A column of zeros would be mistaken for dark points."""
    project, survey = picked()
    paths = export_targets(project, survey, tmp_path / "csv", "prior", ending="csv", names=["T2"])
    with paths[0].open(newline="") as file:
        titles, *rows = csv.reader(file)
    assert titles == [
        "line", "time (s)", "north (m)", "west (m)", "up (m)",
        "x lidar (m)", "y lidar (m)", "z lidar (m)",
    ]  # fmt: skip
    assert len(rows) == sum(len(s.indices) for s in project.target("T2").sightings)
    las = laspy.read(export_targets(project, survey, tmp_path, "prior", ending="las")[0])
    assert len(las.points) == sum(len(s.indices) for s in project.target("T1").sightings)
    assert not np.asarray(las.intensity).any()


def test_spheres_alone_give_no_plane_file(tmp_path: Path) -> None:
    project, survey = picked()
    balls = tuple(replace(target, shape="sphere") for target in project.targets)
    with pytest.raises(ProjectError) as caught:
        export_planes(replace(project, targets=balls), survey, tmp_path / "out", "prior")
    assert caught.value.code == "export.no_planar_target"
    assert not (tmp_path / "out").exists()


def test_assumptions_are_reported_with_the_written_files(tmp_path: Path) -> None:
    project, survey = picked()
    out = tmp_path / "out"
    paths, notes = export(project, survey, ExportRequest("targets", out, "prior", "las"))
    assert [path.name for path in paths] == ["T1_prior.las", "T2_prior.las"]
    assert notes == ()  # metres from the origin of the survey
    request = ExportRequest("targets", tmp_path / "map", "prior", "las", "EPSG:32619")
    _, notes = export(project, survey, request)
    system = output_system_of(project, survey.trajectory, "EPSG:32619")
    assert system is not None
    assert notes == system.assumptions
    assert notes
    paths, notes = export(project, survey, ExportRequest("planes", out, "prior"))
    assert ([path.name for path in paths], notes) == (["T1_prior.txt", "T2_prior.txt"], ())
    (tmp_path / "own").mkdir()
    moving = turning(tmp_path / "own")
    for form, velocities in (("sbet", True), ("text", False)):
        path = tmp_path / f"new.{form}"
        paths, notes = export(moving, survey, ExportRequest("trajectory", path, form=form))
        assert paths == [path]
        assert notes[0] == note("export.trajectory_datum", file="own.sbet")
        assert (SBET_ZEROS_NOTE in notes) == velocities


def turning(folder: Path) -> Project:
    """Make a project with only a trajectory, of a turning vessel."""
    time = 400_000.123456 + np.arange(300) / 200
    raw = Trajectory(
        time, 0.8 + 1e-8 * np.arange(300), -1.3 + 2e-8 * np.arange(300), np.linspace(-20, 3, 300),
        np.stack([0.1 * np.sin(time), 0.05 * np.cos(time), np.linspace(6.1, 6.5, 300)], axis=1),
        velocity=np.tile([12.7, -17.8, 15.3], (300, 1)),
    )  # fmt: skip
    write_sbet(
        folder / "own.sbet", replace(raw, attitude_rate=np.gradient(raw.attitude, time, axis=0))
    )
    return Project(
        folder=folder / "project",
        trajectory=folder / "own.sbet",
        lines=(),
        settings=Settings((0.0, 0.0, 0.0)),
    )


def test_trajectory_as_sbet_and_as_text(tmp_path: Path) -> None:
    project = turning(tmp_path)
    before = read_sbet(project.trajectory)
    sbet = read_sbet(export_trajectory(project, tmp_path / "out" / "new.sbet"))
    for name in ("time", "latitude", "longitude", "height", "attitude", "velocity"):
        np.testing.assert_array_equal(getattr(sbet, name), getattr(before, name))
    assert before.attitude_rate is not None
    assert sbet.attitude_rate is not None
    assert np.abs(before.attitude_rate).max(axis=0).min() > 0.01
    np.testing.assert_allclose(sbet.attitude_rate, before.attitude_rate, rtol=0, atol=1e-13)
    path = export_trajectory(project, tmp_path / "out" / "new.txt", "text")
    rows = np.loadtxt(path, skiprows=4)
    np.testing.assert_allclose(rows[:, 0], before.time, rtol=0, atol=1e-9)
    np.testing.assert_allclose(rows[:, 1], np.degrees(before.latitude), rtol=0, atol=1e-11)
    np.testing.assert_allclose(rows[:, 5], -np.degrees(before.attitude[:, 1]), rtol=0, atol=1e-9)
    assert rows[:, 6].max() > 359
    assert rows[:, 6].min() < 1
    # The reader of the program recognises the columns by name, and its defaults are right.
    ((format, _), *_) = recognise_formats(path, "trajectory")
    assert format.key == "ascii-trajectory"
    again = format_of("ascii-trajectory").read(path, format.preview(path, {}).choice)
    assert isinstance(again, Trajectory)
    np.testing.assert_allclose(again.attitude[:, :2], before.attitude[:, :2], rtol=0, atol=1e-10)
    np.testing.assert_allclose(
        np.unwrap(again.attitude[:, 2]) % 6.283185307179586,
        np.unwrap(before.attitude[:, 2]) % 6.283185307179586, rtol=0, atol=1e-9,
    )  # fmt: skip
    np.testing.assert_allclose(again.latitude, before.latitude, rtol=0, atol=1e-12)
    np.testing.assert_allclose(again.height, before.height, rtol=0, atol=1e-5)


@LONG
def test_exports_from_the_command_line(
    copy: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = str(copy.folder)

    def run(*words: object) -> tuple[int, str, str]:
        code = main(["export", folder, *map(str, words)])
        return code, *capsys.readouterr()

    code, out, _ = run("--what", "targets", "--format", "csv", "--crs", UTM, "--output",
                       tmp_path / "t", "--targets", "T1", "V1")  # fmt: skip
    assert code == 0
    assert [Path(line).name for line in out.split()] == ["T1_estimated.csv", "V1_estimated.csv"]
    code, out, err = run("--what", "trajectory", "--output", tmp_path / "t" / "a.sbet")
    assert code == 0
    assert english_text(SBET_ZEROS_NOTE) in err
    assert (tmp_path / "t" / "a.sbet").exists()
    code, out, _ = run("--what", "planes", "--output", tmp_path / "p", "--boresight", "prior")
    assert code == 0
    assert len(list((tmp_path / "p").glob("*_prior.txt"))) == len(copy.targets)
    for words in (
        ("--what", "planes", "--format", "laz", "--output", tmp_path / "x"),
        ("--what", "planes", "--crs", UTM, "--output", tmp_path / "x"),
        ("--what", "trajectory", "--crs", UTM, "--output", tmp_path / "x"),
        ("--what", "trajectory", "--targets", "T1", "--output", tmp_path / "x"),
    ):
        code, _, err = run(*words)
        assert code == 2
        assert "export" in err
    words = ("--what", "targets", "--crs", "EPSG:99999", "--output", tmp_path / "x")
    refused_with("crs.unknown", "export", folder, *words, system="EPSG:99999")
    assert not (tmp_path / "x").exists()
