"""Tests of the coordinate system of an export: that of the input clouds, or required."""

import shutil
import struct
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.project.project_file import write_project
from lispac.io.trajectory.sbet import write_sbet
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing.file_reading import local_trajectory
from lispac.workflow.output.export_request import ExportRequest, export
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.project.output_crs import output_system_of, trajectory_datum_of
from lispac.workflow.project.survey import load_survey
from tests.support.cloud_files import MOUNTING, sweep, track, written_las
from tests.support.command_errors import command_error

NAD83, UTM, ITRF = "EPSG:6348", "EPSG:32619", "EPSG:7912"
Made = Callable[..., Project]


def flat_geoid(path: Path, height: float) -> Path:
    """Write a geoid grid of constant height around Quebec in NOAA's format."""
    values = np.full(12, height, ">f4").tobytes()
    path.write_bytes(struct.pack(">4d2i", 45.0, -73.0, 1.0, 1.0, 3, 4) + values)
    return path


def on_map(**changes: str) -> Reading:
    """Return the reading of a georeferenced cloud."""
    options = {
        "frame": "georeferenced", "unit": "metre", "crs": NAD83, "height": "", "height_unit": "",
        "trajectory_datum": "", "epoch": "", "time_base": "gps-week",
    }  # fmt: skip
    return Reading("las", tuple({**options, **changes}.items()))


@pytest.fixture
def raw(tmp_path: Path) -> Project:
    """A project of one line in the scanner frame."""
    local = track()
    latitude, longitude, height = local.frame.to_geodetic(local.position)
    write_sbet(
        tmp_path / "sbet.out",
        Trajectory(local.time, latitude, longitude, height, local.attitude),
    )
    points, time = sweep(local, 2000)
    written_las(tmp_path / "raw.las", 6, points, time, extra=False)
    settings = Settings(
        tuple(MOUNTING.lever_arm), tuple(np.degrees(MOUNTING.boresight)), None,
        range_offset=MOUNTING.range_offset,
        scan_angle_offset_deg=float(np.degrees(MOUNTING.scan_angle_offset)),
        latency=MOUNTING.latency,
    )  # fmt: skip
    line = LineSource("raw", tmp_path / "raw.las", (), Reading("las"))
    return Project(
        folder=tmp_path / "raw", trajectory=tmp_path / "sbet.out", lines=(line,), settings=settings
    )


@pytest.fixture
def cloud(raw: Project, tmp_path: Path) -> Callable[..., LineSource]:
    """Return a function that georeferences the line and returns it as an input line."""

    def made(
        name: str, epoch: float | None = None, code: str = NAD83, **options: str
    ) -> LineSource:
        (done,) = georeference_project(
            raw, tmp_path / "made", "prior", system=code, height=options.get("height", ""),
            trajectory_datum="" if epoch is None else ITRF, epoch=epoch, ending="las",
        )  # fmt: skip
        path = tmp_path / f"{name}.las"
        shutil.copy(done.path, path)
        if epoch is not None:
            options |= {"trajectory_datum": ITRF, "epoch": str(epoch)}
        return LineSource(name, path, (), on_map(crs=code, **options))

    return made


@pytest.fixture
def dated(raw: Project, cloud: Callable[..., LineSource], tmp_path: Path) -> Project:
    """A line in NAD83(2011) with a trajectory in ITRF2014 at 2023.5."""
    return replace(raw, folder=tmp_path / "dated", lines=(cloud("one", 2023.5),))


def largest_difference(one: Path, two: Path) -> float:
    """Return the largest difference of two clouds in metres."""
    return float(np.abs(laspy.read(one).xyz - laspy.read(two).xyz).max())


@pytest.mark.parametrize("what", ["epoch", "datum", "geoid", "unit"])
def test_lines_with_different_systems_are_not_exported_together(
    raw: Project, cloud: Callable[..., LineSource], tmp_path: Path, what: str
) -> None:
    if what == "geoid":
        grid = str(flat_geoid(tmp_path / "geoid.gtx", -32.0))
        lines = (cloud("one", code=UTM, height=grid), cloud("two", code=UTM))
    elif what == "unit":
        lines = (cloud("one", code=UTM), cloud("two", code=UTM))
        feet = laspy.read(lines[1].path)
        feet.z = np.asarray(feet.z) / 0.3048
        feet.write(lines[1].path)
        lines = (lines[0], replace(lines[1], reading=on_map(crs=UTM, height_unit="foot")))
    else:
        lines = (cloud("one", 2023.5), cloud("two", 2010.0 if what == "epoch" else None))
    project = replace(raw, folder=tmp_path / "two", lines=lines)
    with pytest.raises(InputError) as raised:
        georeference_project(project, tmp_path / "out", "prior")
    assert raised.value.code == "export.different_systems"
    assert "one: " in str(raised.value)
    assert "two: " in str(raised.value)
    assert not (tmp_path / "out").exists()
    for line in lines:  # a single line is exported unchanged
        (done,) = georeference_project(
            project, tmp_path / "alone", "prior", lines=[line.name], ending="las"
        )
        assert largest_difference(done.path, line.path) < 2e-4


def test_an_epoch_without_effect_is_no_difference(
    raw: Project, cloud: Callable[..., LineSource], tmp_path: Path
) -> None:
    lines = (
        cloud("one", code=UTM),
        replace(cloud("two", code=UTM), reading=on_map(crs=UTM, epoch="2020.5")),
    )
    project = replace(raw, folder=tmp_path / "two", lines=lines)
    assert len(georeference_project(project, tmp_path / "out", "prior")) == 2


def test_a_code_is_exported_with_the_datum_of_the_lines(dated: Project, tmp_path: Path) -> None:
    source = dated.lines[0].path
    assert trajectory_datum_of(dated.lines) == (ITRF, 2023.5)
    dated.folder.mkdir()
    survey = load_survey(dated)
    for system in ("", NAD83):
        request = ExportRequest("lines", tmp_path / f"out{system[-4:]}", "prior", "las", system)
        (path,), notes = export(dated, survey, request)
        assert largest_difference(path, source) < 2e-4
        assert any(each.params.get("datum") == "ITRF2014" for each in notes)
    found = output_system_of(dated, survey.trajectory, NAD83)  # the same for targets
    assert found is not None
    assert any(each.params.get("datum") == "ITRF2014" for each in found.assumptions)
    request = ExportRequest("lines", tmp_path / "none", "prior", "las", NAD83, trajectory_datum="")
    (path,), notes = export(dated, survey, request)  # an empty datum requests no transformation
    assert largest_difference(path, source) > 1.0
    assert "assumed.datum" in {each.code for each in notes}


def test_lines_of_two_datums_need_a_given_one(
    raw: Project, cloud: Callable[..., LineSource], tmp_path: Path
) -> None:
    lines = (cloud("one", 2023.5), cloud("two", 2010.0))
    project = replace(raw, folder=tmp_path / "two", lines=lines)
    with pytest.raises(InputError) as raised:
        georeference_project(project, tmp_path / "out", "prior", system=NAD83)
    assert raised.value.code == "export.different_datums"
    done = georeference_project(
        project, tmp_path / "out", "prior", system=NAD83, trajectory_datum=ITRF, epoch=2023.5,
        ending="las",
    )  # fmt: skip
    assert largest_difference(done[0].path, lines[0].path) < 2e-4


def test_an_epoch_is_used_or_refused(
    raw: Project, dated: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (moved,) = georeference_project(dated, tmp_path / "o", "prior", epoch=2010.0, ending="las")
    (other,) = georeference_project(
        dated, tmp_path / "p", "prior", system=NAD83, trajectory_datum=ITRF, epoch=2010.0,
        ending="las",
    )  # fmt: skip
    assert largest_difference(moved.path, other.path) == 0
    assert 0.1 < largest_difference(moved.path, dated.lines[0].path) < 0.5
    trajectory, _ = local_trajectory(raw)
    for system, epoch, code in (
        (UTM, 2020.5, "export.epoch_without_datum"),
        ("local", 2020.5, "export.local_frame_options"),
        (UTM, 99999.0, "export.bad_epoch"),
        (UTM, -5.0, "export.bad_epoch"),
    ):
        with pytest.raises(InputError) as raised:
            output_system_of(raw, trajectory, system, epoch=epoch)
        assert raised.value.code == code
    raw.folder.mkdir()
    write_project(raw)
    arguments = [str(raw.folder), "--output", str(tmp_path / "q"), "--boresight", "prior"]
    refusal = command_error("georeference", *arguments, "--crs", UTM, "--epoch", "2020.5")
    assert refusal.code == "export.epoch_without_datum"
