"""Tests of the readers of points, on files of independent writers."""

import gzip
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.format_types import FileFormat, FilePreview, PointChunk
from lispac.io.formats import POINT_FORMATS
from lispac.io.las import las_chunks
from lispac.io.las.las_format import read_scan
from lispac.io.point_reader_common import crs_of_options
from lispac.io.points import pcd, point_records
from lispac.io.text import text_chunks
from lispac.message_texts import fact_text
from tests.support import point_files as files
from tests.support.error_codes import has_code
from tests.support.message_codes import codes
from tests.support.velodyne_packets import resting_points

FORMATS = {format_.key: format_ for format_ in POINT_FORMATS}
RNG = np.random.default_rng(8)


def whole(format_: FileFormat, path: Path, choice: dict[str, Any] | None = None) -> PointChunk:
    """Read a file completely, with the options of its preview."""
    found = format_.preview(path, choice or {})
    chunks = list(format_.read(path, {**found.choice, **(choice or {})}))
    assert all(isinstance(chunk, PointChunk) for chunk in chunks)
    return PointChunk(
        np.concatenate([chunk.xyz for chunk in chunks]),
        np.concatenate([chunk.time for chunk in chunks]),
        {name: np.concatenate([c.extra[name] for c in chunks]) for name in chunks[0].extra},
        chunks[0].total,
    )


@pytest.fixture(params=files.VALID_FILES)
def valid(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[FileFormat, Path]:
    key, write = files.VALID_FILES[request.param]
    return FORMATS[key], write(tmp_path / request.param)


def expected(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the coordinates, times and rings given to the writer."""
    if path.name == "a.pcap":
        return resting_points()
    kept = np.arange(files.COUNT)
    if path.name == "a.e57":
        kept = kept[kept % 2 == 0]
    if path.name == "d.pcd":
        kept = kept[kept % 10 != 9]
    time = files.TIME
    if path.suffix == ".e57":
        time = time - 400_000 + 1.4e9
    elif path.name in ("b.ply", "b.pcd"):
        time = time - 400_000
    return files.XYZ[kept], time[kept], files.RING[kept]


def test_points_are_read_as_written(valid: tuple[FileFormat, Path]) -> None:
    format_, path = valid
    read = whole(format_, path)
    xyz, time, ring = expected(path)
    # Open3D writes six digits, and Velodyne's manual rounds the heights of the lasers; the other
    # writers store exact values.
    coarse = 6e-5 if path.name in ("b.ply", "a.pcap") else 1e-7
    np.testing.assert_allclose(read.xyz, xyz, rtol=0, atol=coarse)
    np.testing.assert_allclose(read.time, time, rtol=0, atol=2e-6)
    assert read.xyz.dtype == read.time.dtype == np.float64
    if name := next((name for name in ("ring", "rowIndex") if name in read.extra), ""):
        np.testing.assert_array_equal(read.extra[name], ring)
    else:
        assert path.name in ("d.pcd", "cidco", "plane.txt", "target.csv")
    assert read.total in (None, files.COUNT)


def test_every_format_recognises_its_own_files(valid: tuple[FileFormat, Path]) -> None:
    format_, path = valid
    scores = {other.key: other.sniff(path) for other in POINT_FORMATS}
    assert max(scores, key=lambda key: scores[key]) == format_.key
    assert sorted(scores.values())[-2] <= 0.3 < scores[format_.key]


def test_an_examination_reports_frame_unit_time_base_and_assumptions(
    valid: tuple[FileFormat, Path],
) -> None:
    format_, path = valid
    found = format_.preview(path, {})
    assert isinstance(found, FilePreview)
    assert {"frame", "unit", "time base", "format"} <= set(found.facts)
    assert found.assumptions
    assert len(found.rows) == 11
    assert len({len(row) for row in found.rows}) == 1
    format_.complete_options(found.choice)
    assert all(fact_text(fact) for fact in found.facts.values())


def test_no_format_of_points_recognises_other_files(shared_data: Path) -> None:
    for name in ("harbour/trajectory.sbet", "harbour/smrmsg.out", "harbour/site.json"):
        assert {format_.sniff(shared_data / name) for format_ in POINT_FORMATS} == {0.0}


@pytest.mark.parametrize("point_format", [1, 3, 4, 5, 6, 7, 8, 9, 10])
def test_every_las_point_format_with_time_is_read(tmp_path: Path, point_format: int) -> None:
    version = "1.2" if point_format < 4 else "1.3" if point_format < 6 else "1.4"
    path = files.las(tmp_path / "a.las", point_format, version)
    read = whole(FORMATS["las"], path)
    np.testing.assert_array_equal(read.time, files.TIME)
    names = set(laspy.PointFormat(point_format).dimension_names) - {"X", "Y", "Z", "gps_time"}
    assert set(read.extra) == names | {"ring"}
    with laspy.open(path) as reader:
        points = reader.read()
    for name in read.extra:
        np.testing.assert_array_equal(read.extra[name], np.asarray(points[name]))


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("point_format", [4, 5, 9, 10])
def test_points_with_waveforms_are_read(tmp_path: Path, point_format: int, ending: str) -> None:
    """LAZ with several scanner channels mixes up waveform attributes, but no others."""
    version = "1.3" if point_format < 6 else "1.4"
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales = np.full(3, 1e-4)
    header.global_encoding.waveform_data_packets_external = True
    las = laspy.LasData(header)
    las.x, las.y, las.z = files.XYZ.T
    las.gps_time = files.TIME
    las.intensity = files.RING
    las.wavepacket_index[:] = 1
    las.wavepacket_offset = 60 + 256 * np.arange(files.COUNT)
    las.wavepacket_size[:] = 256
    if point_format > 5:
        las.scanner_channel = np.arange(files.COUNT) % 4
    las.write(tmp_path / f"a.{ending}")
    found = FORMATS["las"].preview(tmp_path / f"a.{ending}", {})
    assert "assumed.waveforms" in codes(found.assumptions)
    assert ("assumed.waveforms_mixed_up" in codes(found.assumptions)) == (
        ending == "laz" and point_format > 5
    )
    read = whole(FORMATS["las"], tmp_path / f"a.{ending}")
    np.testing.assert_allclose(read.xyz, files.XYZ, atol=1e-9)
    np.testing.assert_array_equal(read.time, files.TIME)
    np.testing.assert_array_equal(read.extra["intensity"], files.RING)
    np.testing.assert_array_equal(read.extra["wavepacket_index"], np.ones(files.COUNT))


@pytest.mark.parametrize("name", ["a.las", "a.laz"])
def test_las_is_read_from_any_point(tmp_path: Path, name: str) -> None:
    """LAZ has chunks of 50,000 points: starts inside chunks, at their borders and ends."""
    count = 120_000
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 1e-4)
    las = laspy.LasData(header)
    las.x, las.y, las.z = RNG.normal(0, 10, (3, count))
    las.gps_time = np.linspace(400_000, 400_100, count)
    las.intensity = np.arange(count) % 60_000
    las.write(tmp_path / name)
    whole_line = whole(FORMATS["las"], tmp_path / name)
    read_from = FORMATS["las"].read_from
    assert read_from is not None
    for first in (0, 1, 49_999, 50_000, 77_777, count - 1):
        chunks = list(read_from(tmp_path / name, {}, first))
        for part, field in (("xyz", whole_line.xyz), ("time", whole_line.time)):
            rest = np.concatenate([getattr(chunk, part) for chunk in chunks])
            np.testing.assert_array_equal(rest, field[first:])
        intensity = np.concatenate([chunk.extra["intensity"] for chunk in chunks])
        np.testing.assert_array_equal(intensity, whole_line.extra["intensity"][first:])
        assert {chunk.total for chunk in chunks} == {count}
    assert list(read_from(tmp_path / name, {}, count)) == []


def test_reading_from_a_point_does_not_decode_previous_chunks(tmp_path: Path) -> None:
    """Bytes of the first LAZ chunk are destroyed; the others are read."""
    path = files.las(tmp_path / "a.laz")
    las = laspy.read(path)
    las.points = laspy.ScaleAwarePointRecord(
        np.tile(las.points.array, 3000), las.point_format, las.header.scales, las.header.offsets
    )
    las.gps_time = np.linspace(400_000, 400_100, len(las.points))
    las.write(path)
    sound = whole(FORMATS["las"], path)
    with laspy.open(path) as reader:
        start = reader.header.offset_to_point_data
    content = bytearray(path.read_bytes())
    content[start + 8 + 100 : start + 8 + 4000] = RNG.integers(0, 256, 3900, np.uint8).tobytes()
    path.write_bytes(content)
    read_from = FORMATS["las"].read_from
    assert read_from is not None
    rest = np.concatenate([chunk.time for chunk in read_from(path, {}, 60_000)])
    np.testing.assert_array_equal(rest, sound.time[60_000:])


@pytest.mark.parametrize("point_format", [0, 2])
def test_las_without_time_is_refused(tmp_path: Path, point_format: int) -> None:
    path = files.las(tmp_path / "a.las", point_format, "1.2")
    for attempt in (lambda: FORMATS["las"].preview(path, {}), lambda: whole(FORMATS["las"], path)):
        with pytest.raises(InputError, check=has_code("las.no_gps_time")):
            attempt()


def test_time_base_and_system_of_a_las_header(tmp_path: Path) -> None:
    path = files.las(tmp_path / "a.las", crs="EPSG:2949+6647", adjusted=True)
    found = FORMATS["las"].preview(path, {})
    assert found.choice["time_base"] == "gps-adjusted"
    assert "CGVD2013" in found.facts["coordinate system"]
    assert "times.base_contradicted" in codes(found.file_warnings)  # seconds of the week
    assert "points.small_coordinates" in codes(found.file_warnings)
    with pytest.raises(InputError, check=has_code("crs.grid_missing_geoid")):  # of CGVD2013
        crs_of_options(FORMATS["las"].complete_options(found.choice))
    resolved = FORMATS["las"].complete_options({**found.choice, "height": "ellipsoid"})
    system = crs_of_options(resolved)
    assert system is not None
    assert "MTM" in system.name


def test_las_is_read_as_the_scan_reader_does(shared_data: Path) -> None:
    path = shared_data / "lanl_tent" / "line2.laz"
    read, scan = whole(FORMATS["las"], path), read_scan(path)
    np.testing.assert_array_equal(read.xyz, scan.points_lidar)
    np.testing.assert_array_equal(read.time, scan.time)


def test_chunks_are_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The last chunk has the remaining points, and no point is lost."""
    for module in (las_chunks, pcd, text_chunks):
        monkeypatch.setattr(module, "POINTS_PER_CHUNK", 16)
    monkeypatch.setattr(text_chunks, "BYTES_PER_BLOCK", 300)
    for name in ("a.las", "b.laz", "a.pcd", "b.pcd", "c.pcd", "a.csv", "b.csv.gz"):
        key, write = files.VALID_FILES[name]
        chunks = list(FORMATS[key].read(write(tmp_path / name), {}))
        assert [len(chunk.time) for chunk in chunks] == [16, 16, 16, 12], name
        np.testing.assert_allclose(np.concatenate([c.xyz for c in chunks]), files.XYZ, atol=1e-7)


def test_other_units_of_a_scanner_are_converted_to_metres(valid: tuple[FileFormat, Path]) -> None:
    format_, path = valid
    scanner = {"frame": "scanner"}
    metres, feet = whole(format_, path, scanner), whole(format_, path, scanner | {"unit": "foot"})
    small = whole(format_, path, scanner | {"unit": "millimetre"})
    np.testing.assert_allclose(feet.xyz, metres.xyz * 0.3048)
    np.testing.assert_allclose(small.xyz, metres.xyz / 1000)


@pytest.mark.parametrize(
    ("row", "head", "choice"),
    [
        ("{x:.4f} {y:.4f} {z:.4f} {ring} {t:.6f}", "", {"columns": "x y z ring time"}),
        ("{t:.6f};{x:.4f};{y:.4f};{z:.4f}", "GPSTime;X [m];Y [m];Z [m]", {}),
        ("{x:.4f} {y:.4f} {z:.4f} {t:.6f}", "//X Y Z GpsTime\n60", {}),
        ('"{t:.6f}","{x:.4f}","{y:.4f}","{z:.4f}"', '"time","easting","northing","height"', {}),
        ("{t:.6f}\t{x:.4f}\t{y:.4f}\t{z:.4f}\tgood", "time\tx\ty\tz\t-", {}),
        ("{t:.6f}, {x:.4f}, {y:.4f}, {z:.4f}", "# time, x, y, z", {}),
    ],
)
def test_text_layouts(tmp_path: Path, row: str, head: str, choice: dict[str, str]) -> None:
    read = whole(FORMATS["text"], files.text(tmp_path / "a.txt", row, head), choice)
    np.testing.assert_array_equal(read.xyz, files.XYZ)
    np.testing.assert_array_equal(read.time, files.TIME)


def test_decimal_commas_are_read(tmp_path: Path) -> None:
    path = files.text(tmp_path / "a.csv", "{t:.6f};{x:.4f};{y:.4f};{z:.4f}", "time;x;y;z")
    path.write_text(path.read_text().replace(".", ","))
    found = FORMATS["text"].preview(path, {})
    assert (found.choice["separator"], found.choice["decimal"]) == ("semicolon", "comma")
    np.testing.assert_array_equal(whole(FORMATS["text"], path).xyz, files.XYZ)


def test_time_in_other_units(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_text("t x y z\n" + "".join(f"{k}000000 1 2 {k}\n" for k in range(5)))
    read = whole(FORMATS["text"], path, {"time_unit": "nanosecond"})
    np.testing.assert_allclose(read.time, np.arange(5) / 1000)


def test_e57_poses_are_applied_in_georeferenced_frames(tmp_path: Path) -> None:
    half = np.sqrt(0.5)
    path = files.e57(
        tmp_path / "a.e57", quaternion=(half, 0, 0, half), translation=(1, 2, 3), spherical=True
    )
    read = whole(FORMATS["e57"], path)
    np.testing.assert_allclose(read.xyz, files.XYZ, atol=1e-9)
    posed = whole(FORMATS["e57"], path, {"frame": "georeferenced"})
    turned = np.stack([-files.XYZ[:, 1], files.XYZ[:, 0], files.XYZ[:, 2]], axis=1) + [1, 2, 3]
    np.testing.assert_allclose(posed.xyz, turned, atol=1e-9)
    assert "e57.poses" in codes(FORMATS["e57"].preview(path, {}).file_warnings)


def test_absolute_time_stamps_of_e57(tmp_path: Path) -> None:
    path = files.e57(tmp_path / "a.e57", stamps=files.TIME)
    found = FORMATS["e57"].preview(path, {})
    assert found.choice["time_from"] == "zero"
    assert "e57.large_time_stamps" in codes(found.file_warnings)
    np.testing.assert_allclose(whole(FORMATS["e57"], path).time, files.TIME)
    without_absolute_time = files.e57(tmp_path / "b.e57", start=0.0)
    assert FORMATS["e57"].preview(without_absolute_time, {}).choice["time_from"] == "zero"
    with pytest.raises(InputError, check=has_code("e57.no_start")):
        list(FORMATS["e57"].read(without_absolute_time, {}))


def test_cidco_and_plane_files_keep_their_poses(tmp_path: Path) -> None:
    read = whole(FORMATS["cidco"], files.cidco(tmp_path / "c"))
    np.testing.assert_array_equal(read.extra["attitude"][0], [0.01, 0.02, 1.2])
    np.testing.assert_allclose(
        read.extra["points_local"] - read.extra["position"], files.XYZ, atol=1e-12
    )
    read = whole(FORMATS["planes"], files.planes(tmp_path / "p.txt"))
    np.testing.assert_array_equal(read.extra["plane"][3], [0.6, 0.8, 0.0, -3.0])


def test_real_cidco_files(shared_data: Path) -> None:
    paths = [path for path in (shared_data / "cidco").rglob("*1") if path.is_file()]
    assert len(paths) == 4
    for path in paths:
        read = whole(FORMATS["cidco"], path)
        assert len(read.time) == path.stat().st_size / 176
        assert 5 < np.median(np.linalg.norm(read.xyz, axis=1)) < 50


def test_unknown_options_are_refused(tmp_path: Path) -> None:
    path = files.las(tmp_path / "a.las")
    unknown = has_code("formats.unknown_option", option="colour")
    with pytest.raises(InputError, check=unknown):
        list(FORMATS["las"].read(path, {"colour": "red"}))
    invalid = has_code("formats.invalid_choice", option="unit", value="cubit")
    with pytest.raises(InputError, check=invalid) as refused:
        list(FORMATS["las"].read(path, {"unit": "cubit"}))
    assert refused.value.message is not None
    assert refused.value.message.params["choices"][:2] == ("metre", "foot")


def test_gzip_is_recognised_by_its_bytes(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_bytes(gzip.compress(b"time x y z\n1 2 3 4\n2 3 4 5\n"))
    assert len(whole(FORMATS["text"], path).time) == 2


def test_records_are_read_in_bounded_pieces(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(point_records, "BYTES_PER_READ", 100)
    sizes = [len(c.time) for c in FORMATS["ply"].read(files.cloud(tmp_path / "a.ply"), {})]
    assert sum(sizes) == files.COUNT
    assert max(sizes) < 10
