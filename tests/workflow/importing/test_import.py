"""Tests of importing the lines of a project into its store."""

import json
import os
import shutil
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import Cancelled, InputError, ProjectError
from lispac.io.las.las_format import write_points
from lispac.io.project.project_file import write_project
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.georeferencing import Georeferencer, Mounting, georeference
from lispac.survey.store import point_blocks, spool
from lispac.survey.store.original_file import source_file_of
from lispac.survey.store.stored_line import StoredLine
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.file_reading import local_trajectory
from lispac.workflow.importing.line_import import (
    _LineFileReader,
    assumptions_of,
    import_line,
    import_lines,
    line_folder,
    open_stored_line,
)
from lispac.workflow.importing.line_points import LinePoints, read_line
from lispac.workflow.project.projects import create_project, open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.command_errors import command_error, refused_with
from tests.support.error_codes import has_code
from tests.support.message_codes import codes
from tests.support.store_lines import stop_at


@pytest.fixture(scope="module")
def calibrated(denser_calibrated: tuple[Project, Survey]) -> tuple[Project, Survey]:
    """A survey with many points a line."""
    return denser_calibrated


@pytest.fixture(scope="module")
def survey(calibrated: tuple[Project, Survey]) -> Survey:
    """Return the survey read from the files, without a store."""
    return calibrated[1]


@pytest.fixture
def project(calibrated: tuple[Project, Survey], tmp_path: Path) -> Project:
    """Return a project of two lines of the built-in survey, without targets."""
    source = calibrated[0]
    return create_project(
        tmp_path / "project", trajectory=source.trajectory, lines=source.lines[:2],
        settings=replace(source.settings, boresight_deg=(0.4, -1.0, 0.3)),
    )  # fmt: skip


@pytest.fixture(scope="module")
def trajectory(calibrated: tuple[Project, Survey]) -> LocalTrajectory:
    """Return the trajectory of the built-in survey."""
    return local_trajectory(calibrated[0])[0]


def in_file_order(stored: StoredLine) -> np.ndarray:
    """Return the row numbers of a stored line in the order of its file."""
    return stored.rows(np.arange(len(stored)))


def test_imported_lines_are_those_read_from_the_files(project: Project) -> None:
    survey = load_survey(project)
    imported = import_lines(project)
    assert [item.stored.name for item in imported] == list(survey.lines)
    for item in imported:
        stored, scan = item.stored, survey.scans[item.stored.name]
        rows = in_file_order(stored)
        assert stored.fingerprint == scan.fingerprint
        assert assumptions_of(stored) == scan.assumptions
        np.testing.assert_array_equal(stored.time[rows], scan.time)
        np.testing.assert_allclose(stored.points_lidar[rows], scan.points_lidar, atol=8e-6)
        np.testing.assert_array_equal(stored.intensity[rows], scan.intensity)
        assert "return_number" in stored.extra
        assert stored.folder.parent == project.folder / "lines"


def test_a_region_of_an_imported_line_has_the_points_of_the_file(project: Project) -> None:
    survey = load_survey(project)
    (item,) = import_lines(project, ["L1_000"])
    stored, cloud = item.stored, survey.clouds["L1_000"].sample
    place = Georeferencer.of(survey.trajectory, project.mounting("prior"))
    for k in (0, 50_000, 100_000):
        centre = cloud[k] + 0.3
        rows, local = stored.within(centre, 1.5, place, margin=1e-4)
        away = np.linalg.norm(cloud - centre, axis=1)
        # Rounding of the coordinates decides about points at the edge.
        inner, outer = np.flatnonzero(away < 1.5 - 2e-5), np.flatnonzero(away < 1.5 + 2e-5)
        numbers = np.sort(stored.numbers(rows))
        assert np.isin(inner, numbers).all()
        assert np.isin(numbers, outer).all()
        np.testing.assert_allclose(local, cloud[stored.numbers(rows)], atol=2e-5)
    assert len(inner) > 100


def test_no_point_moves_farther_than_the_margin(project: Project, trajectory) -> None:
    (item,) = import_lines(project, ["L1_000"])
    rows = slice(None, None, 50)
    points = item.stored.points_lidar[rows].astype(float)
    time = np.array(item.stored.time[rows])
    prior = project.mounting("prior")
    before = Georeferencer.of(trajectory, prior)(points, time)
    rng = np.random.default_rng(5)
    shares = []
    for k in range(30):
        step = rng.normal(0, 1, 9) * [0.05, 0.05, 0.05, 0.1, 0.1, 0.1, 0.05, 0.02, 0.01]
        step[rng.random(9) < 0.5 * (k % 2)] = 0
        mounting = Mounting.of_values(prior.values + step)
        place = Georeferencer.of(trajectory, mounting)
        moved = np.linalg.norm(place(points, time) - before, axis=1).max()
        margin = place.largest_displacement(prior, item.stored.manifest.reach)
        assert moved <= margin + 1e-9
        shares.append(moved / margin if margin else 1.0)
    assert np.median(shares) > 0.3, "not larger than need be"
    assert Georeferencer.of(trajectory, prior).largest_displacement(prior, 100.0) == 0


def test_georeferencer_agrees_with_georeference(survey: Survey, project: Project) -> None:
    scan = survey.scans["L1_000"]
    mounting = replace(
        project.mounting("prior"), range_offset=0.02, scan_angle_offset=0.01, latency=0.003
    )
    expected = georeference(scan.points_lidar, scan.time, survey.trajectory, mounting)
    found = Georeferencer.of(survey.trajectory, mounting)(scan.points_lidar, scan.time)
    np.testing.assert_array_equal(found, expected)
    with pytest.raises(InputError, check=has_code("survey.outside_trajectory")):
        Georeferencer.of(survey.trajectory, mounting)(scan.points_lidar, scan.time + 1e6)


def test_a_second_import_only_removes_temporary_files(project: Project) -> None:
    first, _ = import_lines(project)
    # The files of an import that was killed after the manifest was written.
    (first.stored.folder / "spool").mkdir()
    (first.stored.folder / "spool" / "block-00000.keys").write_bytes(b"left")
    (first.stored.folder / "columns-9").mkdir()
    assert [item.seconds for item in import_lines(project)] == [0.0, 0.0]
    assert {path.name for path in first.stored.folder.iterdir()} == {"columns-1", "store.json"}
    again = import_lines(project, ["L2_180"], again=True)
    assert again[0].seconds > 0


@pytest.mark.parametrize("when", [1, 3, 4])
def test_a_cancelled_import_can_be_continued(
    project: Project, trajectory, monkeypatch, when: int
) -> None:
    for module in (point_blocks, spool):
        monkeypatch.setattr(module, "BLOCK_POINTS", 50_000)
    line = project.lines[0]
    whole = import_line(project, line, trajectory).stored.manifest
    shutil.rmtree(project.folder / "lines")
    with pytest.raises(Cancelled):
        import_line(project, line, trajectory, progress=stop_at(when))
    with pytest.raises(ProjectError) as refused:
        open_stored_line(project, line, trajectory)
    assert refused.value.code == "store.interrupted"
    again = import_line(project, line, trajectory).stored.manifest
    assert [c.checksum for c in again.files] == [c.checksum for c in whole.files]


def test_an_interrupted_command_explains_how_to_continue(
    project: Project, monkeypatch, capsys
) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(spool.Spool, "mark_complete", stop)
    assert main(["import", str(project.folder)]) == 1
    printed = capsys.readouterr().err
    assert "lispac import" in printed
    assert "lispac: interrupted." in printed
    monkeypatch.undo()
    assert main(["import", str(project.folder), "--check", "--json"]) == 0
    lines = json.loads(capsys.readouterr().out)["lines"]
    assert {name: line["points"] for name, line in lines.items()} == {
        "L1_000": 144_507, "L2_180": 142_668,
    }  # fmt: skip


def test_a_store_is_checked_without_its_file(project: Project, survey: Survey, capsys) -> None:
    own = write_line(project.folder / "own.laz", survey.scans["L1_000"])
    other = write_line(project.folder / "other.laz", survey.scans["L2_180"])
    write_project(replace(project, lines=(own, other)))
    assert main(["import", str(project.folder), "--lines", "own"]) == 0
    own.path.unlink()
    assert main(["import", str(project.folder), "--check", "--lines", "own"]) == 0
    assert "imported already" in capsys.readouterr().out
    (column,) = line_folder(project, own).glob("columns-*/time.npy")
    content = bytearray(column.read_bytes())
    content[-3] ^= 4
    column.write_bytes(content)
    refusal = command_error("import", project.folder, "--check", "--lines", "own")
    assert refusal.code == "import.file_missing"
    other.path.unlink()  # not imported: reported before anything is read
    refused_with("file.not_found", "import", project.folder, file=str(other.path))


def test_command_prints_points_and_size(project: Project, capsys) -> None:
    assert main(["import", str(project.folder), "--lines", "L1_000"]) == 0
    out = capsys.readouterr().out
    assert "L1_000" in out
    assert "144,507 points" in out
    assert main(["import", str(project.folder), "--lines", "L1_000"]) == 0
    assert "imported already" in capsys.readouterr().out
    refused_with("project_line.not_found", "import", project.folder, "--lines", "L9", line="L9")


def test_progress_shows_rate_and_time_remaining(project: Project, trajectory, monkeypatch) -> None:
    monkeypatch.setattr("lispac.progress.MIN_RATE_TIME_S", 0.0)
    steps: list[tuple[float, str]] = []
    import_line(
        project,
        project.lines[0],
        trajectory,
        progress=lambda f, step=None: steps.append((f, str(step))),
    )
    assert any("M points/s" in words and "left" in words for _, words in steps)
    fractions = [fraction for fraction, _ in steps]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0


def write_line(path: Path, scan, shift: float = 0.0) -> LineSource:
    """Write a scan to a LAS file and return it as a line."""
    write_points(path, scan.points_lidar, scan.time + shift, scan.intensity)
    return LineSource(path.stem, path)


def test_changes_since_the_import_are_detected(
    project: Project, survey: Survey, trajectory
) -> None:
    own = write_line(project.folder / "own.laz", survey.scans["L1_000"])
    project = replace(project, lines=(own,))
    import_line(project, own, trajectory)
    status = own.path.stat()
    os.utime(own.path, ns=(status.st_atime_ns, status.st_mtime_ns + 10**9))
    open_stored_line(project, own, trajectory)  # copied, with the same content

    slower = replace(own, reading=Reading(time_shift=0.5))
    with pytest.raises(ProjectError) as raised:
        open_stored_line(project, slower, trajectory)
    assert raised.value.code == "import.reading_changed"
    assert raised.value.message.params["line"] == "own"
    with pytest.raises(ProjectError) as raised:
        open_stored_line(project, own, replace(trajectory, position=trajectory.position + 1))
    assert raised.value.code == "import.trajectory_changed"
    late = replace(project, settings=replace(project.settings, latency=0.01))
    with pytest.raises(ProjectError) as raised:
        open_stored_line(late, own, trajectory)
    assert raised.value.code == "import.latency_changed"
    turned = replace(project, settings=replace(project.settings, boresight_deg=(5.0, 0, 0)))
    open_stored_line(turned, own, trajectory)  # changes only the order of points

    write_line(own.path, survey.scans["L2_180"])
    with pytest.raises(ProjectError) as raised:
        open_stored_line(project, own, trajectory)
    assert raised.value.code == "import.file_changed"
    assert len(import_line(project, own, trajectory).stored) == len(survey.scans["L2_180"])
    own.path.unlink()
    open_stored_line(project, own, trajectory)  # the store does not need its file
    assert import_lines(project)[0].seconds == 0.0
    with pytest.raises(InputError, match=r"own\.laz") as refused:
        import_lines(project, again=True)
    assert refused.value.code == "file.not_found"


def test_a_line_with_a_damaged_column_is_imported_again(
    project: Project, survey: Survey, trajectory
) -> None:
    own = write_line(project.folder / "again.laz", survey.scans["L1_000"])
    project = replace(project, lines=(own,))
    first = import_line(project, own, trajectory).stored
    path = first.folder / first.manifest.folder / "xyz.npy"
    content = bytearray(path.read_bytes())
    content[5000] ^= 1
    path.write_bytes(content)
    os.rename(own.path, own.path.with_suffix(".away"))
    with pytest.raises(InputError) as raised:
        import_line(project, own, trajectory)
    assert raised.value.code == "import.file_missing"
    assert "xyz.npy" in str(raised.value)
    os.rename(own.path.with_suffix(".away"), own.path)
    notes = load_survey(project).notes
    (repeated,) = [each for each in notes if each.code == "import.repeated"]
    assert repeated.params["line"] == "again"
    assert repeated.params["reason"].params["file"].endswith("xyz.npy")
    open_stored_line(project, own, trajectory).require_sound()
    assert "import.repeated" not in codes(load_survey(project).notes)


def test_points_without_a_pose_are_skipped_and_counted(survey: Survey, project, trajectory) -> None:
    """Points before the trajectory and in a gap longer than the limit."""
    scan = survey.scans["L1_000"]
    start = np.quantile(scan.time, 0.3)
    gap = (trajectory.time > start + 2) & (trajectory.time < start + 4)
    kept = (trajectory.time > start) & ~gap
    short = LocalTrajectory(
        trajectory.frame, trajectory.time[kept], trajectory.position[kept],
        trajectory.attitude[kept],
    )  # fmt: skip
    stored = import_line(project, project.lines[0], short).stored
    inside = short.covers(scan.time)
    assert 0 < stored.manifest.excluded_points == np.count_nonzero(~inside)
    rows = in_file_order(stored)
    np.testing.assert_array_equal(stored.time[rows], scan.time[inside])
    np.testing.assert_array_equal(stored.indices_in_file(rows), np.flatnonzero(inside))
    counts = [each.params["count"] for each in assumptions_of(stored) if "count" in each.params]
    assert sum(counts) == stored.manifest.excluded_points


def test_a_refused_line_outside_the_trajectory_leaves_no_files(
    survey: Survey, project, trajectory
) -> None:
    early = write_line(project.folder / "early.laz", survey.scans["L1_000"], -7200.0)
    before = sorted(project.folder.rglob("*"))
    with pytest.raises(InputError, check=has_code("import.before_trajectory")):
        import_line(replace(project, lines=(early,)), early, trajectory)
    assert sorted(project.folder.rglob("*")) == before


def test_a_refused_damaged_file_leaves_no_files(survey: Survey, project, trajectory) -> None:
    own = write_line(project.folder / "own.las", survey.scans["L1_000"])
    os.truncate(own.path, own.path.stat().st_size // 2)
    before = sorted(project.folder.rglob("*"))
    with pytest.raises(InputError, match=r"own\.las"):
        import_line(replace(project, lines=(own,)), own, trajectory)
    assert sorted(project.folder.rglob("*")) == before


@pytest.mark.parametrize("change", ["changed", "removed"])
def test_a_file_that_changes_during_the_import_is_refused(
    survey: Survey, project, trajectory, change: str
) -> None:
    own = write_line(project.folder / "own.las", survey.scans["L1_000"])
    original = source_file_of(own.path)
    source = _LineFileReader(
        LinePoints(own, trajectory, project.mounting("prior")), original
    ).pieces(0)
    assert len(next(source)) == len(survey.scans["L1_000"])
    if change == "changed":
        os.utime(own.path, ns=(0, original.modified + 1))
    else:
        own.path.unlink()
    with pytest.raises(InputError) as raised:
        next(source)
    codes = {"changed": "import.file_being_written", "removed": "import.file_removed"}
    assert raised.value.code == codes[change]
    assert "own.las" in str(raised.value)


def test_a_line_on_the_map_is_converted_to_the_scanner_frame(
    survey: Survey, project, trajectory
) -> None:
    scan = survey.scans["L1_000"]
    mounting = project.mounting("prior")
    system = coordinate_system("EPSG:32619")
    local = georeference(scan.points_lidar, scan.time, trajectory, mounting)
    header = laspy.LasHeader(point_format=6, version="1.4")
    on_map = system.from_local(local, trajectory.frame)
    header.scales, header.offsets = np.full(3, 1e-4), np.floor(on_map.mean(axis=0))
    las = laspy.LasData(header)
    las.x, las.y, las.z = on_map.T
    las.gps_time = scan.time
    path = project.folder / "map.laz"
    las.write(path)
    options = (("frame", "georeferenced"), ("crs", "EPSG:32619"))
    line = LineSource("map", path, reading=Reading("las", options))
    project = replace(project, lines=(line,))
    stored = import_line(project, line, trajectory).stored
    rows = in_file_order(stored)
    assert np.abs(stored.points_lidar[rows] - scan.points_lidar).max() < 2e-4
    assert stored.fingerprint == read_line(line, trajectory, mounting)[0].fingerprint
    turned = replace(project, settings=replace(project.settings, boresight_deg=(0.0, 0.0, 0.0)))
    with pytest.raises(ProjectError) as raised:
        open_stored_line(turned, line, trajectory)
    assert raised.value.code == "import.mounting_changed"


def test_a_text_line_with_named_columns_is_imported(survey: Survey, project, trajectory) -> None:
    scan = survey.scans["L1_000"]
    table = np.column_stack([scan.time, scan.points_lidar, scan.intensity])[:20_000]
    path = project.folder / "line.txt"
    np.savetxt(path, table, fmt=["%.9f", "%.4f", "%.4f", "%.4f", "%d"])
    line = LineSource("line", path, ("time", "x", "y", "z", "intensity"))
    stored = import_line(replace(project, lines=(line,)), line, trajectory).stored
    read, _ = read_line(line, trajectory, project.mounting("prior"))
    assert (stored.fingerprint, len(stored)) == (read.fingerprint, 20_000)
    np.testing.assert_array_equal(stored.intensity[in_file_order(stored)], read.intensity)


def test_folders_of_lines_are_distinct_on_every_operating_system(project: Project) -> None:
    names = ("Wall", "wall", "Kai/Süd", "Kai_S_d", "con", "..", "a b")
    lines = tuple(LineSource(name, Path("a.las")) for name in names)
    project = replace(project, lines=lines)
    folders = [line_folder(project, line) for line in lines]
    assert len({str(folder).lower() for folder in folders}) == len(names)
    assert {folder.parent for folder in folders} == {project.folder / "lines"}
    assert all(folder.name.isascii() for folder in folders)


def test_a_project_with_imported_lines_is_opened(project: Project) -> None:
    import_lines(project)
    assert open_project(project.folder).lines == project.lines


def test_the_longest_gap_is_that_of_the_project_settings(project: Project) -> None:
    settings = replace(project.settings, longest_gap=0.7)
    assert isinstance(settings, Settings)
    assert local_trajectory(replace(project, settings=settings))[0].longest_gap == 0.7
    assert isinstance(project.mounting("prior"), Mounting)
