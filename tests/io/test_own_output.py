"""Tests that exported targets, plane files and trajectories can be read back."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.text.text_export import write_trajectory_text
from lispac.io.trajectory.sbet import write_sbet
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing.file_reading import (
    check_file,
    default_or_detected_reading,
    read_trajectory,
)
from lispac.workflow.importing.line_points import read_chunks
from lispac.workflow.output.data_export import export_planes, export_targets, export_trajectory
from lispac.workflow.project.output_crs import output_system_of
from lispac.workflow.project.projects import new_project
from lispac.workflow.project.survey import Survey
from tests.support.cloud_files import states, track, two_lines
from tests.support.error_codes import has_code
from tests.support.long_runs import others_long
from tests.support.message_codes import codes

UTM = "EPSG:32619"
UNKNOWN_MOUNTING = Settings((0.0, 0.0, 0.0))
"""Settings of a user who knows neither boresight nor lever arm."""


def read_back(
    project: Project, path: Path, folder: Path, settings: Settings = UNKNOWN_MOUNTING,
    reading: Reading | None = None,
) -> tuple[Project, Survey]:  # fmt: skip
    """Create a project with an exported cloud as its only line, without further options."""
    return new_project(
        folder, trajectory=project.trajectory, trajectory_reading=project.trajectory_reading,
        lines=[LineSource("again", path, (), reading or Reading())], settings=settings,
    )  # fmt: skip


def require_same_points(survey: Survey, points: np.ndarray, time: np.ndarray) -> None:
    """Check that points and times of the line are those of the scanner, in any order."""
    scan = survey.scans["again"]
    found, times = scan.take(np.arange(len(scan)))
    own, order = np.argsort(times, kind="stable"), np.argsort(time, kind="stable")
    np.testing.assert_allclose(times[own], time[order], rtol=0, atol=1e-9)
    assert np.linalg.norm(found[own] - points[order], axis=1).max() < 1e-3


@pytest.mark.parametrize("ending", others_long(["laz", "las"]))
@pytest.mark.parametrize("system", ["local", UTM])
def test_exported_targets_are_read_back_from_las(
    calibrated: tuple[Project, Survey], tmp_path: Path, ending: Any, system: str
) -> None:
    """The line has the points of all sightings, each with the number of its line."""
    project, survey = calibrated
    from lispac.workflow.project.output_crs import output_system_of

    (path,) = export_targets(
        project, survey, tmp_path / "out", "estimated", ending=ending, names=["T1"],
        system=output_system_of(project, survey.trajectory, system),
    )  # fmt: skip
    parts = [survey.scans[s.line].take(s.indices) for s in project.target("T1").used_sightings]
    points, time = (np.concatenate([part[k] for part in parts]) for k in (0, 1))
    _, found = read_back(project, path, tmp_path / "new")
    require_same_points(found, points, time)
    las = laspy.read(path)
    sizes = np.bincount(las.point_source_id, minlength=len(survey.lines) + 1)[1:]
    own = {s.line: len(s.indices) for s in project.target("T1").used_sightings}
    assert sizes.tolist() == [own.get(line, 0) for line in survey.lines]


@pytest.mark.parametrize("system", others_long(["local", UTM, "EPSG:4979", "EPSG:4978"], 2))
def test_exported_targets_are_read_back_from_csv(
    calibrated: tuple[Project, Survey], tmp_path: Path, system: str
) -> None:
    """Scanner coordinates are read, for any system of the other coordinates."""
    project, survey = calibrated
    (path,) = export_targets(
        project, survey, tmp_path / "out", "estimated", ending="csv", names=["T1"],
        system=output_system_of(project, survey.trajectory, system),
    )  # fmt: skip
    sightings = project.target("T1").used_sightings
    parts = [survey.scans[s.line].take(s.indices) for s in sightings]
    (check, *_) = check_file(path)
    assert (check.format.key, check.confidence) == ("target", 1.0)
    _, found = read_back(project, path, tmp_path / "new")
    require_same_points(found, *(np.concatenate([part[k] for part in parts]) for k in (0, 1)))
    (chunk,) = read_chunks(check.format.read(path, {}))
    sizes = np.bincount(chunk.extra["point_source_id"])[1:]
    assert sizes.tolist() == [len(s.indices) for s in sightings]
    intensities = [survey.scans[s.line].intensities(s.indices) for s in sightings]
    np.testing.assert_allclose(chunk.extra["intensity"], np.concatenate(intensities), rtol=1e-5)


def test_a_cut_target_file_is_refused_with_its_row(
    calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    project, survey = calibrated
    (path,) = export_targets(project, survey, tmp_path, "estimated", ending="csv", names=["T1"])
    rows = path.read_text().splitlines()[:10]
    path.write_text("\n".join([*rows[:-1], rows[-1][:20]]))
    with pytest.raises(InputError, check=has_code("text.uneven_row", row=10, found=2)):
        check_file(path)[0].format.preview(path, {})


@pytest.mark.parametrize("which", others_long(["prior", "estimated"]))
def test_exported_plane_files_are_read_back_as_a_line(
    calibrated: tuple[Project, Survey], tmp_path: Path, which: Any
) -> None:
    project, survey = calibrated
    (path,) = export_planes(project, survey, tmp_path / "out", which, names=["T1"])
    (check, *_) = check_file(path)
    assert (check.format.key, check.confidence) == ("planes", 1.0)
    parts = [survey.scans[s.line].take(s.indices) for s in project.target("T1").used_sightings]
    _, found = read_back(project, path, tmp_path / "new")
    require_same_points(found, *(np.concatenate([part[k] for part in parts]) for k in (0, 1)))


@pytest.mark.parametrize("form", others_long(["sbet", "text"]))
@pytest.mark.parametrize("place_deg", [(46.8, -71.2), (0.02, 0.03), (-33.9, 179.999)])
def test_exported_trajectories_are_read_back(
    tmp_path: Path, form: Any, place_deg: tuple[float, float]
) -> None:
    """Near the equator and the prime meridian degrees could be mistaken for radians."""
    local = track(place_deg)
    latitude, longitude, height = local.frame.to_geodetic(local.position)
    known = Trajectory(local.time, latitude, longitude, height, local.attitude)
    write_sbet(tmp_path / "sbet.out", known)
    project = replace(two_lines(tmp_path), trajectory=tmp_path / "sbet.out")
    write_sbet(tmp_path / "sbet.out", known)
    path = export_trajectory(project, tmp_path / f"trajectory.{form}", form)
    (check, *_) = check_file(path)
    assert (check.format.kind, check.confidence) == ("trajectory", 1.0)
    assert check.finding is not None
    assert check.finding.choice["time"] == "gps-week"
    if form == "text":
        assert not any(
            "_down" in code or "_up" in code for code in codes(check.finding.file_warnings)
        )
    reading, _ = default_or_detected_reading(path, "trajectory", Reading())
    found = read_trajectory(path, reading)
    np.testing.assert_allclose(found.time, known.time, rtol=0, atol=1e-8)
    for name, limit in (("latitude", 1e-12), ("longitude", 1e-12), ("height", 1e-5)):
        apart = getattr(found, name) - getattr(known, name)
        apart = (apart + np.pi) % (2 * np.pi) - np.pi if name == "longitude" else apart
        assert np.abs(apart).max() < limit
    turned = (found.attitude - known.attitude + np.pi) % (2 * np.pi) - np.pi
    assert np.abs(turned).max() < 1e-10


def test_a_text_trajectory_specifies_its_time_base(tmp_path: Path) -> None:
    write_trajectory_text(tmp_path / "t.txt", states(), "utc-day")
    reading, _ = default_or_detected_reading(tmp_path / "t.txt", "trajectory", Reading())
    assert dict(reading.options)["time"] == "utc-day"
