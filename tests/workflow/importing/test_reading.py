"""Tests of projects made from other formats: recognised at import, read the same afterwards."""

import json
from pathlib import Path

import laspy
import numpy as np
import pytest
from pyproj import CRS

from lispac.cli.main import main
from lispac.errors import InputError
from lispac.io.trajectory.sbet import read_sbet
from lispac.message_texts import message_text
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.file_reading import check_file
from lispac.workflow.project.projects import new_project, open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.command_errors import command_error, is_refusal
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG

APPLIED_BORESIGHT_DEG = (0.5, -1.0, 0.7)
"""Boresight (deg) that other software made the clouds with."""


def write_cloud(path: Path, points: np.ndarray, time: np.ndarray, code: int) -> Path:
    """Write a LAZ file as other programs do, with laspy alone."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, 1e-4), np.floor(points.mean(axis=0))
    header.add_crs(CRS.from_epsg(code))
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.WEEK_TIME
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.gps_time = time
    las.write(path)
    return path


@pytest.fixture(scope="module")
def clouds(calibrated: tuple[Project, Survey], tmp_path_factory) -> list[LineSource]:
    """Two lines of the built-in survey as georeferenced clouds made with another boresight."""
    project, survey = calibrated
    mounting = Mounting(np.array(project.settings.lever_arm), np.radians(APPLIED_BORESIGHT_DEG))
    system = coordinate_system("EPSG:32619")
    folder = tmp_path_factory.mktemp("clouds")
    sources = []
    for name in survey.lines[:2]:
        scan = survey.scans[name]
        local = georeference(scan.points_lidar, scan.time, survey.trajectory, mounting)
        points = system.from_local(local, survey.trajectory.frame)
        sources.append(
            LineSource(name, write_cloud(folder / f"{name}.laz", points, scan.time, 32619))
        )
    return sources


def test_georeferenced_lines_are_converted_back_to_the_scanner_frame(
    calibrated, clouds, tmp_path
) -> None:
    project, survey = calibrated
    settings = Settings(lever_arm=project.settings.lever_arm, boresight_deg=APPLIED_BORESIGHT_DEG)
    made, read = new_project(
        tmp_path / "map", trajectory=project.trajectory, lines=clouds, settings=settings
    )
    assert dict(made.lines[0].reading.options)["frame"] == "georeferenced"
    assert any("EPSG:32619" in message_text(note) for note in read.notes)
    for name in read.lines:
        own = survey.scans[name]
        off = np.linalg.norm(read.scans[name].points_lidar - own.points_lidar, axis=1)
        assert off.max() < 2e-4
        np.testing.assert_array_equal(read.scans[name].time, own.time)
    again = load_survey(open_project(made.folder))
    name = read.lines[0]
    assert again.scans[name].fingerprint == read.scans[name].fingerprint


def test_raw_lines_are_read_as_own_format(calibrated, tmp_path) -> None:
    project, survey = calibrated
    made, read = new_project(
        tmp_path / "raw", trajectory=project.trajectory, lines=project.lines[:1],
        settings=Settings(lever_arm=project.settings.lever_arm), accuracy=project.accuracy,
    )  # fmt: skip
    assert made.lines[0].reading == made.trajectory_reading == Reading()
    name = project.lines[0].name
    assert read.scans[name].fingerprint == survey.scans[name].fingerprint


@LONG
def test_a_trajectory_as_text_gives_the_same_poses(calibrated, tmp_path) -> None:
    project, _ = calibrated
    own = read_sbet(project.trajectory)
    path = tmp_path / "trajectory.txt"
    rows = np.column_stack([
        own.time, np.degrees(own.latitude), np.degrees(own.longitude), own.height,
        np.degrees(own.attitude * [1, -1, 1]),
    ])  # fmt: skip
    head = "time latitude longitude height roll pitch heading"
    np.savetxt(path, rows, fmt="%.12f", header=head, comments="")
    found = check_file(path, ("trajectory",))[0]
    assert found.format.key == "ascii-trajectory"
    made, read = new_project(
        tmp_path / "text", trajectory=path, lines=project.lines[:1],
        settings=Settings(lever_arm=project.settings.lever_arm),
        trajectory_reading=Reading(
            "ascii-trajectory", (("columns", head), ("attitude", "degrees"), ("pitch", "bow-up"))
        ),
    )  # fmt: skip
    assert dict(made.trajectory_reading.options)["pitch"] == "bow-up"
    expected = LocalTrajectory.of(own, own.mean_frame()).at(own.time[::97])
    poses = read.trajectory.at(own.time[::97])
    np.testing.assert_allclose(poses.position, expected.position, atol=1e-4)
    np.testing.assert_allclose(poses.attitude, expected.attitude, atol=1e-8)


def test_lines_in_another_time_base_are_refused_with_a_suggested_shift(
    calibrated, tmp_path
) -> None:
    project, survey = calibrated
    name, source = project.lines[0].name, project.lines[0].path
    las = laspy.read(source)
    las.gps_time = np.asarray(las.gps_time) - 86_400 * 2
    las.write(tmp_path / "early.laz")
    line = LineSource(name, tmp_path / "early.laz")
    options = {
        "trajectory": project.trajectory,
        "settings": Settings(lever_arm=project.settings.lever_arm),
    }
    with pytest.raises(InputError, check=has_code("import.outside_with_shifts", shift=172_800.0)):
        new_project(tmp_path / "no", lines=[line], **options)
    assert not (tmp_path / "no").exists()
    shifted = LineSource(name, line.path, reading=Reading(time_shift=86_400 * 2))
    _, read = new_project(tmp_path / "yes", lines=[shifted], **options)
    np.testing.assert_allclose(read.scans[name].time, survey.scans[name].time, atol=1e-6)


def test_inspect_reports_the_format_of_a_file(calibrated, clouds, capsys) -> None:
    project, _ = calibrated
    assert main(["inspect", str(clouds[0].path)]) == 0
    printed = capsys.readouterr().out
    assert "certainly LAS or LAZ" in printed
    assert "crs=EPSG:32619" in printed
    assert main(["inspect", str(project.trajectory), "--json"]) == 0
    formats = json.loads(capsys.readouterr().out)["formats"]
    assert formats[0]["format"] == "sbet"
    assert formats[0]["options"]["pitch"] == "bow-up"
    assert any("ellipsoidal" in each["text"] for each in formats[0]["assumptions"])


@pytest.mark.parametrize(
    ("options", "refusal"),
    [
        (["--line-option", "frame=moon"], "formats.invalid_choice"),
        (["--line-format", "fax"], "formats.unknown"),
        (["--trajectory-format", "las"], "import.not_trajectory_format"),
        (["--trajectory-option", "colour=red"], "formats.unknown_option"),
    ],
)
def test_invalid_import_options_are_refused(calibrated, tmp_path, options, refusal) -> None:
    project, _ = calibrated
    line = str(project.lines[0].path)
    command = ["new", str(tmp_path / "p"), line, "--trajectory", str(project.trajectory)]
    assert is_refusal(command_error(*command, "--lever-arm", "0", "0", "1", *options), refusal)
    assert not (tmp_path / "p").exists()


@pytest.mark.parametrize(
    ("content", "refusal"),
    [
        ("", "file is empty."),
        ("x y z\n1 2 3\n4 5 6\n", "import.points_without_time"),
        ("1.5;2.5;3.5\n4.5;5.5;6.5\n", "import.points_without_time"),
    ],
)
def test_reason_why_a_file_is_not_a_line_is_reported(tmp_path, content, refusal) -> None:
    path = tmp_path / "quay.txt"
    path.write_text(content)
    assert is_refusal(command_error("inspect", path), refusal)


def test_a_file_of_unknown_format_is_refused(tmp_path) -> None:
    path = tmp_path / "notes.doc"
    path.write_bytes(b"\x00\x01nothing" * 40)
    assert command_error("inspect", path).code == "import.unknown_format"


@pytest.mark.parametrize("ending", [".laz", ".E57", ".sbet"])
def test_a_file_that_is_not_what_its_name_says_is_called_damaged(tmp_path, ending) -> None:
    path = tmp_path / f"L1{ending}"
    path.write_text("These are words.\n")
    refusal = command_error("inspect", path).message
    assert refusal.code == "import.not_of_its_format"
    assert str(refusal.params["file"]).endswith(path.name)
