"""Tests of georeferencing the lines of a project: accuracy, excluded points, clean-up."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import Cancelled, InputError, ProjectError
from lispac.io.las.las_chunks import LAS_FORMAT
from lispac.io.las.las_crs import read_header_crs
from lispac.io.las.mounting_record import MountingRecord
from lispac.io.point_reader_common import crs_of_options
from lispac.io.project.project_file import write_project
from lispac.io.trajectory.sbet import write_sbet
from lispac.message_texts import message_text
from lispac.messages import Level, note
from lispac.progress import Step
from lispac.project import LineSource, Project, Reading
from lispac.survey.crs import coordinate_system
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.scanner_frame_recovery import RecoverySetup, recover_scanner_points
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing.file_reading import local_trajectory
from lispac.workflow.importing.line_import import import_lines
from lispac.workflow.importing.line_points import read_line
from lispac.workflow.output.georeferencing import georeference_project
from tests.support.cloud_files import (
    LINE_POINTS,
    MOUNTING,
    states,
    two_lines,
)
from tests.support.command_errors import command_error
from tests.support.error_codes import has_code
from tests.support.message_codes import is_shown
from tests.support.point_files import COUNT

UTM = "EPSG:32619"


@pytest.fixture
def project(tmp_path: Path) -> Project:
    return two_lines(tmp_path)


def test_georeferenced_lines_are_converted_back_to_the_scanner_frame(
    project: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """From the scanner frame to UTM LAZ and back: within 0.2 mm."""
    done = georeference_project(project, tmp_path / "out", "prior", system=UTM)
    assert [item.path.name for item in done] == ["L1_prior.laz", "L2_prior.laz"]
    assert [item.points for item in done] == [LINE_POINTS, COUNT]
    trajectory = local_trajectory(project)[0]
    raw = laspy.read(tmp_path / "raw.laz")
    written = laspy.read(done[0].path)
    np.testing.assert_array_equal(written.gps_time, raw.gps_time)  # times of the file, not shifted
    choice = LAS_FORMAT.preview(done[0].path, {}).choice
    system = crs_of_options(LAS_FORMAT.complete_options(choice))
    assert system is not None
    chunks = (replace(c, time=c.time + 18.0) for c in LAS_FORMAT.read(done[0].path, choice))
    recovery = RecoverySetup(system, trajectory, project.mounting("prior"))
    back = np.concatenate([part.xyz for part, _ in recover_scanner_points(chunks, recovery)])
    worst = np.linalg.norm(back - raw.xyz, axis=1).max()
    with capsys.disabled():
        print(f"\nscanner, UTM LAZ, scanner: within {1e3 * worst:.4f} mm")
    assert worst < 2e-4
    ply = laspy.read(done[1].path)
    assert "ring" in ply.point_format.extra_dimension_names


def test_a_line_without_its_file_is_read_from_the_store(project: Project, tmp_path: Path) -> None:
    project.folder.mkdir()
    import_lines(project, ["L1"])
    raw = laspy.read(tmp_path / "raw.laz")
    (tmp_path / "raw.laz").unlink()
    (done,) = georeference_project(project, tmp_path / "out", "prior", system=UTM, lines=["L1"])
    assert done.points == LINE_POINTS
    written = laspy.read(done.path)
    order, own = np.argsort(written.gps_time), np.argsort(raw.gps_time)
    np.testing.assert_allclose(
        np.array(written.gps_time)[order], np.array(raw.gps_time)[own], rtol=0, atol=1e-9
    )
    mapper = ScannerPointConverter(
        coordinate_system(UTM), local_trajectory(project)[0], project.mounting("prior")
    )
    expected = mapper.to_map(raw.xyz, np.array(raw.gps_time) + 18.0)[own]
    np.testing.assert_allclose(written.xyz[order], expected, rtol=0, atol=1e-4)
    for name in raw.point_format.dimension_names:
        if name not in ("X", "Y", "Z", "gps_time"):
            np.testing.assert_array_equal(np.array(written[name])[order], np.array(raw[name])[own])
    (tmp_path / "other.ply").unlink()
    with pytest.raises(InputError, match=r"other\.ply") as refused:
        georeference_project(project, tmp_path / "new", "prior", system=UTM)
    assert refused.value.code == "file.not_found"


def test_a_georeferenced_cloud_is_written_with_another_boresight(
    project: Project, tmp_path: Path
) -> None:
    """Write a UTM cloud that was made with the prior again, with the estimated boresight.

    The default system is that of the cloud. The points are those made directly from the
    scanner frame.
    """
    (first,) = georeference_project(project, tmp_path / "out", "prior", system=UTM, lines=["L1"])
    choice = LAS_FORMAT.preview(first.path, {}).choice
    reading = Reading("las", tuple((k, str(v)) for k, v in choice.items()), 18.0)
    better = replace(
        project, lines=(LineSource("again", first.path, (), reading),),
    )  # fmt: skip
    turned = MOUNTING.with_boresight(MOUNTING.boresight + np.radians([0.3, -0.2, 0.5]))

    class Estimated(Project):
        def mounting(self, which):
            return turned if which == "estimated" else super().mounting(which)

    better = Estimated(**{name: getattr(better, name) for name in better.__dataclass_fields__})
    (done,) = georeference_project(better, tmp_path / "new", "estimated")
    raw, new = laspy.read(tmp_path / "raw.laz"), laspy.read(done.path)
    assert read_header_crs(new.header).text == UTM
    mapper = ScannerPointConverter(coordinate_system(UTM), local_trajectory(project)[0], turned)
    expected = mapper.to_map(raw.xyz, np.array(raw.gps_time) + 18.0)
    assert np.linalg.norm(new.xyz - expected, axis=1).max() < 2.5e-4
    np.testing.assert_array_equal(new["amplitude"], raw["amplitude"])


def test_points_without_a_pose_are_counted_and_skipped(project: Project, tmp_path: Path) -> None:
    times = states().time
    raw = laspy.read(tmp_path / "raw.laz")
    raw.gps_time[:40] = times[0] - 100
    raw.gps_time[40:60] = times[-1] + 100
    raw.write(tmp_path / "raw.laz")
    known = states()
    kept = (known.time < 400_020) | (known.time > 400_023)
    with_gap = Trajectory(known.time[kept], known.latitude[kept], known.longitude[kept],
                          known.height[kept], known.attitude[kept])  # fmt: skip
    write_sbet(tmp_path / "sbet.out", with_gap)
    (done,) = georeference_project(project, tmp_path / "out", "prior", system=UTM, lines=["L1"])
    time = np.array(raw.gps_time)[60:] + 18.0 + MOUNTING.latency
    holes = (
        with_gap.time[with_gap.time < 400_020.01].max(),
        with_gap.time[with_gap.time > 400_022.99].min(),
    )
    in_gap = np.count_nonzero((time > holes[0]) & (time < holes[1]))
    assert (done.outside, done.in_gaps) == (60, in_gap)
    assert in_gap > 0
    file = "L1_prior.laz"
    assert done.notes[:2] == (
        note("import.excluded_outside", file=file, count=60, total=LINE_POINTS),
        note("export.excluded_in_gaps", file=file, count=in_gap, total=LINE_POINTS),
    )
    written = laspy.read(done.path)
    assert len(written) == done.points == LINE_POINTS - 60 - in_gap
    keep = (time <= holes[0]) | (time >= holes[1])
    np.testing.assert_array_equal(written.intensity, np.array(raw.intensity)[60:][keep])


def test_a_missing_or_unknown_system_or_line_is_refused(project: Project, tmp_path: Path) -> None:
    with pytest.raises(InputError, check=has_code("export.no_system", zone="EPSG:32619")):
        georeference_project(project, tmp_path / "out", "prior")
    with pytest.raises(InputError, check=has_code("crs.unknown")):
        georeference_project(project, tmp_path / "out", "prior", system="EPSG:999999")
    with pytest.raises(ProjectError, check=has_code("project_line.not_found", line="L7")):
        georeference_project(project, tmp_path / "out", "prior", system=UTM, lines=["L7"])
    with pytest.raises(ProjectError, check=lambda e: e.code == "project.not_estimated"):
        georeference_project(project, tmp_path / "out", system=UTM)
    assert not (tmp_path / "out").exists()


def test_lines_are_written_in_the_local_frame(project: Project, tmp_path: Path) -> None:
    (done,) = georeference_project(
        project, tmp_path / "out", "prior", system="local", lines=["L1"], ending="las"
    )
    las = laspy.read(done.path)
    assert las.header.parse_crs() is None
    raw = laspy.read(tmp_path / "raw.laz")
    mapper = ScannerPointConverter(None, local_trajectory(project)[0], project.mounting("prior"))
    expected = mapper.to_map(raw.xyz, np.array(raw.gps_time) + 18.0)
    np.testing.assert_allclose(las.xyz, expected, rtol=0, atol=0.51e-4)


def test_the_raw_files_are_not_overwritten(project: Project, tmp_path: Path) -> None:
    (tmp_path / "raw.laz").rename(tmp_path / "L1_prior.laz")
    line = replace(project.lines[0], path=tmp_path / "L1_prior.laz")
    with pytest.raises(InputError) as raised:
        georeference_project(replace(project, lines=(line,)), tmp_path, "prior", system=UTM)
    assert raised.value.code == "export.own_file"


@pytest.mark.parametrize("when", [1, 2, 3])
def test_a_cancelled_export_leaves_no_files(project: Project, tmp_path: Path, when: int) -> None:
    calls = 0

    def stop(fraction: float, step: Step | None = None) -> None:
        nonlocal calls
        calls += 1
        if calls > when:
            raise Cancelled

    with pytest.raises(Cancelled):
        georeference_project(project, tmp_path / "a" / "out", "prior", system=UTM, progress=stop)
    assert not (tmp_path / "a").exists()


def test_a_failed_export_keeps_existing_files(project: Project, tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "L1_prior.laz").write_bytes(b"older")
    (tmp_path / "other.ply").write_bytes(b"ply\nbroken")
    with pytest.raises(InputError, match=r"other\.ply"):
        georeference_project(project, out, "prior", system=UTM)
    assert [path.name for path in out.iterdir()] == ["L1_prior.laz"]
    assert (out / "L1_prior.laz").read_bytes() == b"older"


@pytest.fixture
def small_disk() -> Iterator[None]:
    """Limit the size of files to 40 kB, to simulate a full disk."""
    resource = pytest.importorskip("resource")  # not on Windows
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, before[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize("ending", ["las", "laz"])
def test_an_export_to_a_full_disk_leaves_no_files(
    project: Project, tmp_path: Path, small_disk: None, ending: str
) -> None:
    with pytest.raises(InputError, match=f"L1_prior.{ending}: ") as refused:
        georeference_project(project, tmp_path / "out", "prior", system=UTM, ending=ending)
    assert refused.value.code == "las.not_writable"
    assert not (tmp_path / "out").exists()


def test_georeference_command(
    project: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    raw = laspy.read(tmp_path / "raw.laz")
    raw.gps_time[:5] = 0.0
    raw.write(tmp_path / "raw.laz")
    write_project(project)
    words = ["georeference", str(project.folder), "--output", str(tmp_path / "out"),
             "--boresight", "prior"]  # fmt: skip
    assert command_error(*words).code == "export.no_system"
    assert main([*words, "--crs", UTM, "--lines", "L1", "--format", "las", "--json"]) == 0
    out, err = capsys.readouterr()
    (line,) = json.loads(out)["lines"]
    assert line == {
        "file": str(tmp_path / "out" / "L1_prior.las"), "points": LINE_POINTS - 5, "outside": 5,
        "in_gaps": 0,
    }  # fmt: skip
    outside = note("import.excluded_outside", file="L1_prior.las", count=5, total=LINE_POINTS)
    assert message_text(outside) in err
    assert is_shown("assumed.heights_not_named", err)
    assert main([*words, "--crs", "local"]) == 0
    out, err = capsys.readouterr()
    assert out.split("\n")[1] == f"{tmp_path / 'out' / 'L2_prior.laz'}  {COUNT} points"
    assert message_text(note("assumed.local_frame")) in err


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("system", ["local", UTM, "EPSG:2249", "EPSG:4979"])
def test_an_exported_cloud_gives_its_points_in_the_scanner_frame(
    project: Project, tmp_path: Path, system: str, ending: str
) -> None:
    """The mounting in its header is used instead of the prior of the project."""
    (done,) = georeference_project(
        project, tmp_path / "out", "prior", system=system, lines=["L1"], ending=ending
    )
    found = LAS_FORMAT.preview(done.path, {})
    assert found.choice["frame"] == "georeferenced"
    options = tuple((name, str(value)) for name, value in found.choice.items())
    line = LineSource("L1", done.path, (), Reading("las", options, 18.0))
    other = project.mounting("prior").with_boresight(np.radians([0.1, 2.0, -1.0]))
    trajectory = local_trajectory(project)[0]
    scan, messages = read_line(line, trajectory, other)
    raw = laspy.read(tmp_path / "raw.laz")
    np.testing.assert_allclose(scan.points_lidar, raw.xyz, rtol=0, atol=1e-3)
    assert [each.code for each in messages.recovery] == ["recovery.recorded_mounting"]
    note = messages.recovery[0].params
    made = project.mounting("prior").boresight
    assert [note["roll"], note["pitch"], note["yaw"]] == pytest.approx(list(made), abs=1e-12)


def test_another_lever_arm_than_that_of_the_cloud_is_reported(
    project: Project, tmp_path: Path
) -> None:
    (done,) = georeference_project(project, tmp_path / "out", "prior", system=UTM, lines=["L1"])
    line = LineSource(
        "L1", done.path, (), Reading("las", (("frame", "georeferenced"), ("crs", UTM)), 18.0)
    )
    prior = project.mounting("prior")
    other = replace(prior, lever_arm=prior.lever_arm + [0.0, 0.3, 0.0])
    scan, found = read_line(line, local_trajectory(project)[0], other)
    warning = found.recovery[1]
    assert (warning.code, warning.level) == ("recovery.other_lever_arm", Level.WARNING)
    assert warning.params["off"] == pytest.approx(0.3)
    raw = laspy.read(tmp_path / "raw.laz")
    np.testing.assert_allclose(scan.points_lidar, raw.xyz, rtol=0, atol=1e-3)


@pytest.mark.parametrize(
    "damage", [b"", b"{", b"[]", b'{"version": 9}', b'{"version": 1, "lever_arm_m": [1e9, 0, 0]}']
)
def test_a_damaged_mounting_record_is_not_used(
    project: Project, tmp_path: Path, damage: bytes
) -> None:
    (done,) = georeference_project(
        project, tmp_path / "out", "prior", system="local", lines=["L1"], ending="las"
    )
    cloud = laspy.read(done.path)
    for record in cloud.header.vlrs:
        if record.user_id == "LISPAC" and record.record_id == 2:
            record.record_data = damage
    cloud.write(done.path)
    assert MountingRecord.read(done.path) is None
    with pytest.raises(InputError, check=has_code("las.local_frame")):
        LAS_FORMAT.preview(done.path, {})


def test_an_exported_cloud_is_exported_again(project: Project, tmp_path: Path) -> None:
    """From the local frame to UTM: the points are equal to those of a direct export."""
    (local,) = georeference_project(
        project, tmp_path / "local", "prior", system="local", lines=["L1"], ending="las"
    )
    options = tuple((k, str(v)) for k, v in LAS_FORMAT.preview(local.path, {}).choice.items())
    line = LineSource("L1", local.path, (), Reading("las", options, 18.0))
    (again,) = georeference_project(
        replace(project, lines=(line,)), tmp_path / "again", "prior", system=UTM, ending="las"
    )
    (direct,) = georeference_project(
        project, tmp_path / "map", "prior", system=UTM, lines=["L1"], ending="las"
    )
    one, other = laspy.read(again.path), laspy.read(direct.path)
    np.testing.assert_allclose(one.xyz, other.xyz, rtol=0, atol=1e-3)
    np.testing.assert_array_equal(one.intensity, other.intensity)
