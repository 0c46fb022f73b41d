import os
import struct
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.files import atomic_write, message_with_file_name
from lispac.io.format_types import PointChunk
from lispac.io.formats import format_of
from lispac.io.las.las_format import read_scan, write_points
from lispac.io.project.project_file import read_project, write_project
from lispac.io.text.plane_file import read_plane_files, write_plane_file
from lispac.io.trajectory.sbet import read_sbet, read_smrmsg, write_sbet, write_smrmsg
from lispac.messages import error
from lispac.survey.georeferencing import Mounting, Poses, place_points
from lispac.survey.trajectory import TrajectoryAccuracy
from tests.support.error_codes import has_code
from tests.support.message_codes import codes
from tests.support.report_sample import sample_project


def sbet_records(count: int = 10) -> np.ndarray:
    records = np.zeros((count, 17))
    records[:, 0] = 1000 + 0.005 * np.arange(count)
    records[:, 1], records[:, 2], records[:, 3] = 0.79, -1.28, 5.0
    records[:, 7], records[:, 8] = 0.01, 0.02
    records[:, 9], records[:, 10] = 1.5, 0.25
    return records


def test_sbet_is_read_as_applanix_writes_it(tmp_path: Path) -> None:
    path = tmp_path / "a.sbet"
    path.write_bytes(b"".join(struct.pack("<17d", *row) for row in sbet_records()))
    trajectory = read_sbet(path)
    np.testing.assert_allclose(trajectory.attitude, np.tile([0.01, -0.02, 1.25], (10, 1)))
    np.testing.assert_allclose(trajectory.time, sbet_records()[:, 0])
    assert codes(trajectory.assumptions) == ["assumed.applanix", "assumed.same_time_base"]


def test_sbet_round_trip(tmp_path: Path) -> None:
    sbet_records().tofile(tmp_path / "a.sbet")
    first = read_sbet(tmp_path / "a.sbet")
    write_sbet(tmp_path / "b.sbet", first)
    second = read_sbet(tmp_path / "b.sbet")
    for name in ("time", "latitude", "longitude", "height", "attitude"):
        np.testing.assert_array_equal(getattr(first, name), getattr(second, name))


def _damage(records: np.ndarray, kind: str) -> bytes:
    if kind == "nan":
        records[4, 8] = np.nan
    elif kind == "backward":
        records[5, 0] = records[3, 0]
    elif kind == "degrees":
        records[:, 1] = 45.5
    elif kind == "one":
        records = records[:1]
    data = records.tobytes()
    return {"empty": b"", "truncated": data[:-20]}.get(kind, data)


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        ("empty", "file.empty"),
        ("truncated", "file.partial_record"),
        ("nan", "file.record_not_finite"),
        ("backward", "file.time_order_record"),
        ("degrees", "sbet.in_degrees"),
        ("one", "at least two"),
    ],
)
def test_an_invalid_sbet_is_refused(tmp_path: Path, kind: str, expected: str) -> None:
    path = tmp_path / "bad.sbet"
    path.write_bytes(_damage(sbet_records(), kind))
    with pytest.raises(InputError) as refused:
        read_sbet(path)
    assert expected in f"{refused.value.code} {refused.value}"
    assert str(path) in str(refused.value)
    assert "\n" not in str(refused.value)


def test_missing_file_and_folder_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError) as refused:
        read_sbet(tmp_path / "none.sbet")
    assert refused.value.message == error(
        "file.not_found", file=str(tmp_path / "none.sbet"), kind="SBET"
    )
    with pytest.raises(InputError) as refused:
        read_sbet(tmp_path)
    assert refused.value.code == "file.folder"


def test_smrmsg_round_trip_in_arc_minutes(tmp_path: Path) -> None:
    attitude = np.radians([[0.008, 0.008, 0.012], [0.01, 0.01, 0.02]])
    accuracy = TrajectoryAccuracy(
        np.array([0.0, 1.0]), np.array([[0.01] * 3, [0.02] * 3]), attitude
    )
    write_smrmsg(tmp_path / "smrmsg.out", accuracy)
    stored = np.fromfile(tmp_path / "smrmsg.out").reshape(-1, 10)
    np.testing.assert_allclose(stored[0, 7:], [0.48, 0.48, 0.72])
    back = read_smrmsg(tmp_path / "smrmsg.out")
    np.testing.assert_allclose(back.attitude, attitude)
    position, _ = back.at(np.array([-5.0, 0.5, 9.0]))
    np.testing.assert_allclose(position[:, 0], [0.01, 0.015, 0.02])


def points(count: int = 50) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(0)
    return (
        rng.uniform(-30, 30, (count, 3)).round(4),
        np.linspace(486_000, 486_001, count),
        rng.integers(0, 65535, count).astype(float),
    )


@pytest.mark.parametrize("name", ["a.las", "a.laz"])
def test_las_round_trip(tmp_path: Path, name: str) -> None:
    xyz, time, intensity = points()
    write_points(tmp_path / name, xyz, time, intensity)
    scan = read_scan(tmp_path / name)
    np.testing.assert_allclose(scan.points_lidar, xyz, atol=1e-9)
    np.testing.assert_array_equal(scan.time, time)
    np.testing.assert_array_equal(scan.intensity, intensity)


def las_file(path: Path, *, point_format: int, version: str, count: int) -> Path:
    las = laspy.LasData(laspy.LasHeader(point_format=point_format, version=version))
    las.x = np.arange(count, dtype=float)
    las.write(path)
    return path


def test_las_without_gps_time_is_refused(tmp_path: Path) -> None:
    path = las_file(tmp_path / "a.las", point_format=0, version="1.2", count=3)
    with pytest.raises(InputError) as refused:
        read_scan(path)
    assert refused.value.message == error("las.no_gps_time", file=str(path), format=0)


def test_empty_las_is_refused(tmp_path: Path) -> None:
    path = las_file(tmp_path / "a.las", point_format=6, version="1.4", count=0)
    with pytest.raises(InputError) as refused:
        read_scan(path)
    assert refused.value.message == error("file.no_points", file=str(path))


@pytest.mark.parametrize("name", ["a.las", "a.laz"])
@pytest.mark.parametrize("kept", [0, 10, 300, 600])
def test_damaged_las_is_refused(tmp_path: Path, name: str, kept: int) -> None:
    xyz, time, _ = points(2000)
    write_points(tmp_path / name, xyz, time)
    data = (tmp_path / name).read_bytes()
    (tmp_path / name).write_bytes(data[:kept])
    with pytest.raises(InputError, match=name):
        read_scan(tmp_path / name)


def test_an_invalid_las_header_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.laz"
    path.write_bytes(b"LASF" + bytes(range(256)) * 4)
    with pytest.raises(InputError) as refused:
        read_scan(path)
    assert refused.value.code == "las.scale"


TEXT_FILES = {
    "blank.txt": "1.0 2.0 3.0 4.0 9\n1.5 2.5 3.5 4.5 9\n",
    "comma.csv": "time,x,y,z,intensity\n1.0,2.0,3.0,4.0,9\n1.5,2.5,3.5,4.5,9\n",
    "semicolon.txt": "# made elsewhere\n1.0;2.0;3.0;4.0;9\n\n1.5;2.5;3.5;4.5;9\n",
}


def text_chunks(path: Path, columns: tuple[str, ...]) -> list[PointChunk]:
    chunks = format_of("text").read(path, {"columns": " ".join(columns)})
    return [chunk for chunk in chunks if isinstance(chunk, PointChunk)]


@pytest.mark.parametrize("name", TEXT_FILES)
def test_text_line(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text(TEXT_FILES[name])
    (chunk,) = text_chunks(tmp_path / name, ("time", "x", "y", "z", "intensity"))
    np.testing.assert_array_equal(chunk.xyz, [[2, 3, 4], [2.5, 3.5, 4.5]])
    np.testing.assert_array_equal(chunk.time, [1.0, 1.5])
    np.testing.assert_array_equal(chunk.extra["intensity"], [9, 9])


def test_text_columns_in_any_order_and_ignored_columns(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("7 4.0 3.0 2.0 1.0\n")
    (chunk,) = text_chunks(tmp_path / "a.txt", ("-", "z", "y", "x", "time"))
    np.testing.assert_array_equal(chunk.xyz, [[2, 3, 4]])
    assert "intensity" not in chunk.extra


@pytest.mark.parametrize(
    ("text", "columns", "code"),
    [
        ("1 2 3 4\n", ("time", "x", "y"), "text.columns_missing"),
        ("1 2 3 4\n", (), "text.columns_not_named"),
        ("1 2 3 4\n", ("time", "x", "x", "y", "z"), "text.duplicate_columns"),
        ("1 2 3 4\n1 2 3\n", ("time", "x", "y", "z"), "text.row_too_short"),
        ("1 2 3 4\n1 2 x 4\n", ("time", "x", "y", "z"), "text.not_a_number"),
        ("1 2 nan 4\n", ("time", "x", "y", "z"), "file.points_not_usable"),
        ("# nothing\n", ("time", "x", "y", "z"), "text.no_number_rows"),
    ],
)
def test_bad_text_is_refused(
    tmp_path: Path, text: str, columns: tuple[str, ...], code: str
) -> None:
    (tmp_path / "a.txt").write_text(text)
    with pytest.raises(InputError, check=has_code(code)):
        text_chunks(tmp_path / "a.txt", columns)


def plane_row(time: float, key: int = 0) -> list[float]:
    return [
        key, 0, 15, 5, time, 0, 15, 5, 0, 0, 0, 1e-4, 1e-4, 2e-4, 0, 0, 0, 0.01, 0.01, 0.02,
        0, 1, 0, -15, 1,
    ]  # fmt: skip


def test_plane_file_sightings_are_distinguished_by_gaps_in_time(tmp_path: Path) -> None:
    first = [plane_row(t) for t in (0.0, 0.5, 1.0, 60.0, 60.5, 61.0)]
    second = [plane_row(t) for t in (61.5, 62.0, 2.0)]  # the same lines, observed a little later
    np.savetxt(tmp_path / "T1.txt", first)
    np.savetxt(tmp_path / "T2.txt", second)
    observations, planes = read_plane_files([tmp_path / "T1.txt", tmp_path / "T2.txt"], 0.003)
    named = [(s.target, s.line) for s in observations.sightings]
    assert named == [("T1", "L1"), ("T1", "L2"), ("T2", "L1"), ("T2", "L2")]
    assert observations.counts.tolist() == [3, 3, 1, 2]
    np.testing.assert_array_equal(planes, [[0, 1, 0, -15], [0, 1, 0, -15]])


def test_plane_files_of_one_name_are_distinguished(tmp_path: Path) -> None:
    paths = [tmp_path / day / "T1.txt" for day in ("may", "june")]
    for path in paths:
        path.parent.mkdir()
        np.savetxt(path, [plane_row(t) for t in (0.0, 0.5)])
    observations, _ = read_plane_files(paths, 0.003)
    assert [each.target for each in observations.sightings] == ["T1-1", "T1-2"]
    with pytest.raises(InputError) as refused:
        read_plane_files([], 0.003)
    assert refused.value.code == "planes.none_given"


def test_a_file_without_read_permission_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The permission is simulated, because a superuser may read every file."""
    monkeypatch.setattr("lispac.io.files.os.access", lambda *_: False)
    path = tmp_path / "plane.txt"
    np.savetxt(path, [plane_row(0.0)])
    with pytest.raises(InputError) as refused:
        read_plane_files([path], 0.003)
    assert refused.value.code == "file.no_permission"
    assert str(refused.value).startswith(f"{path}: ")


def test_plane_file_round_trip(shared_data: Path, tmp_path: Path) -> None:
    path = shared_data / "prototype" / "c" / "plane2.txt"
    observations, planes = read_plane_files([path], 0.0031)
    mounting = Mounting(np.array([-0.597, 0.081, 0.356]), np.radians([0, 45, 0]))
    local = place_points(
        observations.points_lidar, Poses(observations.position, observations.attitude), mounting
    )
    stored = np.loadtxt(path)
    write_plane_file(tmp_path / "plane.txt", observations, "plane2", local, planes[0])
    written = np.loadtxt(tmp_path / "plane.txt")
    columns = [c for c in range(25) if c not in (1, 2, 3, 24)]
    np.testing.assert_allclose(written[:, columns], stored[:, columns], atol=1e-11)
    np.testing.assert_allclose(written[:, 1:4], local, atol=1e-11)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("1 2 3\n", "planes.other_columns"),
        ("", "planes.no_points"),
        ("a b c\n", "planes.not_numbers"),
        (" ".join(["1"] * 25) + "\n", "planes.normal_length"),
        (" ".join(["nan"] * 25) + "\n", "planes.not_finite"),
    ],
)
def test_bad_plane_file_is_refused(tmp_path: Path, text: str, code: str) -> None:
    (tmp_path / "plane.txt").write_text(text)
    with pytest.raises(InputError, match=r"plane\.txt") as refused:
        read_plane_files([tmp_path / "plane.txt"], 0.003)
    assert refused.value.code == code


def test_a_failed_write_keeps_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("old")

    def write_half() -> None:
        with atomic_write(path) as temporary:
            temporary.write_text("half")
            raise ValueError("broken")

    with pytest.raises(ValueError, match="broken"):
        write_half()
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]


def test_temporary_files_of_a_killed_save_are_removed(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    write_project(project)
    folder = project.folder
    old = (".project-a1_b2c3d.part.json", ".project-zzzzzzzz.part.json")
    others = (
        ".project-a1_b2c3d.part.json.bak", ".project-short.part.json", "project-a1_b2c3d.json",
        ".project-notes-of-mine.json", ".Project-a1_b2c3d.part.json", ".project-20260101.json",
        ".project-young123.part.json",
    )  # fmt: skip
    for open_or_save in (lambda: read_project(folder), lambda: write_project(project)):
        for name in (*old, *others):
            (folder / name).write_text("half")
            if name != others[-1]:
                os.utime(folder / name, (1e9, 1e9))
        (folder / ".project-folder12.part.json").mkdir(exist_ok=True)
        os.utime(folder / ".project-folder12.part.json", (1e9, 1e9))
        open_or_save()
        remaining = {path.name for path in folder.iterdir() if "roject-" in path.name}
        assert remaining == {*others, ".project-folder12.part.json"}


def test_writing_below_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError) as refused, atomic_write(tmp_path / "file" / "a.txt"):
        pass
    assert refused.value.code == "file.not_writable"


def test_an_error_about_a_file_has_its_name_instead_of_its_path(tmp_path: Path) -> None:
    path = tmp_path / "none.sbet"
    with pytest.raises(InputError) as refused:
        read_sbet(path)
    assert refused.value.message is not None
    assert refused.value.message.params["file"] == str(path)
    message = message_with_file_name(refused.value, path)
    assert (message.code, message.params["file"]) == (refused.value.code, "none.sbet")
    without = InputError(error("file.epoch", epoch="x"))
    assert message_with_file_name(without, path) == without.message
    named = message_with_file_name(InputError("A reason."), path)
    assert named == error("file.refused", file="none.sbet", reason="A reason.")
