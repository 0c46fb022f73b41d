"""Tests of georeferenced clouds as LAS and LAZ: attributes, coordinate systems, progress."""

import re
from pathlib import Path

import laspy
import numpy as np
import pytest
from pyproj import CRS

from lispac.errors import InputError
from lispac.io.format_types import PointChunk
from lispac.io.las.las_chunks import LAS_FORMAT
from lispac.io.las.las_crs import read_header_crs
from lispac.io.las.las_export import layout_of_columns, layout_of_las
from lispac.io.point_reader_common import crs_of_options
from lispac.messages import error, note
from lispac.progress import Step
from lispac.survey.crs import CoordinateSystem, coordinate_system
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.scanner_frame_recovery import RecoverySetup, recover_scanner_points
from lispac.workflow.output.cloud_export import write_cloud
from tests.support.cloud_files import (
    MOUNTING,
    TIMED_FORMATS,
    folded_geoid,
    one_by_one,
    sweep,
    track,
    written_las,
)
from tests.support.long_runs import others_long

UTM = "EPSG:32619"
SMALL = 3000


def to_las(
    source: Path, path: Path, system: CoordinateSystem | None, *, chunk: PointChunk | None = None
) -> laspy.LasData:
    """Georeference a LAS file along the test track."""
    mapper = ScannerPointConverter(system, track(), MOUNTING)
    chunks = LAS_FORMAT.read(source, LAS_FORMAT.complete_options({})) if chunk is None else [chunk]
    write_cloud(
        chunks, path, path, mapper, lambda _: layout_of_las(source),
        compressed=path.suffix == ".laz",
    )  # fmt: skip
    return laspy.read(path)


@pytest.mark.parametrize("ending", others_long(["las", "laz"]))
@pytest.mark.parametrize("number", TIMED_FORMATS)
def test_all_attributes_of_all_point_formats_are_kept(
    tmp_path: Path, number: int, ending: str
) -> None:
    points, time = sweep(track(), SMALL)
    source = tmp_path / "raw.las"
    before = written_las(source, number, points, time, standard_time=number % 2 == 0)
    system = coordinate_system(UTM)
    if ending == "laz" and number in (9, 10):
        with pytest.raises(InputError) as refused:
            to_las(source, tmp_path / "map.laz", system)
        assert refused.value.message == error(
            "las.waveform_channels", file=str(tmp_path / "map.laz"), format=number
        )
        before.scanner_channel[:] = 2
        before.write(source)
    after = to_las(source, tmp_path / f"map.{ending}", system)
    names = list(before.point_format.dimension_names)
    assert list(after.point_format.dimension_names) == names
    assert after.header.point_format == before.header.point_format
    # All bytes are equal except for the coordinates.
    for name in before.points.array.dtype.names:
        if name not in ("X", "Y", "Z"):
            np.testing.assert_array_equal(after.points.array[name], before.points.array[name])
    expected = one_by_one(system, track(), before.xyz, time)
    np.testing.assert_allclose(after.xyz, expected, rtol=0, atol=0.5001e-4 + 1e-5)
    header = after.header
    assert header.version == before.header.version
    assert header.global_encoding.gps_time_type == before.header.global_encoding.gps_time_type
    assert (header.file_source_id, header.system_identifier) == (17, "a scanner")
    assert header.point_count == SMALL
    np.testing.assert_allclose(header.mins, after.xyz.min(axis=0), atol=1e-9)
    np.testing.assert_allclose(header.maxs, after.xyz.max(axis=0), atol=1e-9)
    counts = np.bincount(np.array(before.return_number), minlength=16)[1:]
    return_count = 15 if header.version.minor >= 4 else 5
    np.testing.assert_array_equal(
        header.number_of_points_by_return[:return_count], counts[:return_count]
    )
    own = [record for record in header.vlrs if record.user_id == "someone"]
    assert [record.record_data for record in own] == [b"kept as it is"]
    if header.version.minor >= 4:
        assert [e.record_data for e in after.evlrs or []] == [b"e" * 70]
    assert read_header_crs(header).text == UTM
    assert header.parse_crs() == CRS(UTM)
    wkt = [record for record in header.vlrs if record.record_id == 2112]
    assert len(wkt) == 1
    assert header.global_encoding.wkt == (number >= 6)
    assert any(record.record_id == 34735 for record in header.vlrs) == (number < 6)


@pytest.mark.parametrize("number", TIMED_FORMATS)
def test_unpacked_attributes_are_written_unchanged(tmp_path: Path, number: int) -> None:
    """A store or another reader gives columns by name; some points are outside the trajectory."""
    points, time = sweep(track(), SMALL)
    source, path = tmp_path / "raw.las", tmp_path / "map.las"
    before = written_las(source, number, points, time)
    time[::7] -= 1e5
    columns = {
        name: np.array(before[name])
        for name in before.point_format.dimension_names
        if name not in ("X", "Y", "Z", "gps_time")
    }
    after = to_las(source, path, None, chunk=PointChunk(points, time, columns, SMALL))
    kept = np.arange(SMALL) % 7 != 0
    for name in before.points.array.dtype.names:
        if name not in ("X", "Y", "Z"):
            np.testing.assert_array_equal(after.points.array[name], before.points.array[name][kept])


def test_point_formats_without_time_are_refused(tmp_path: Path) -> None:
    for number in (0, 2):
        header = laspy.LasHeader(point_format=number, version="1.2")
        las = laspy.LasData(header)
        las.x, las.y, las.z = np.random.default_rng(0).normal(size=(3, 10))
        las.write(tmp_path / "timeless.las")
        with pytest.raises(InputError) as refused:
            to_las(tmp_path / "timeless.las", tmp_path / "map.laz", coordinate_system(UTM))
        assert refused.value.message == error(
            "las.no_gps_time", file=str(tmp_path / "timeless.las"), format=number
        )


def test_old_point_formats_in_version_14_have_geotiff_keys(tmp_path: Path) -> None:
    points, time = sweep(track(), SMALL)
    source = tmp_path / "raw.las"
    written_las(source, 3, points, time, version="1.4")
    after = to_las(source, tmp_path / "map.laz", coordinate_system(UTM))
    assert after.header.parse_crs() == CRS(UTM)
    assert not after.header.global_encoding.wkt


@pytest.mark.parametrize("number", others_long([3, 6]))
@pytest.mark.parametrize(
    ("code", "height"),
    others_long(
        [
            ("EPSG:2949", ""),
            ("EPSG:4979", ""),
            ("EPSG:4326", ""),
            ("EPSG:4978", ""),
            ("EPSG:2264", ""),
            ("EPSG:2949", "grid"),
            ("EPSG:2949+5713", "grid"),
            ("+proj=tmerc +lat_0=46 +lon_0=-71 +datum=WGS84", ""),
        ],
        lambda value: value[0] in ("EPSG:2949", "EPSG:4979", "EPSG:4326", "EPSG:2949+5713"),
    ),
)
def test_written_clouds_can_be_read_back(
    tmp_path: Path, code: str, height: str, number: int
) -> None:
    """The header is sufficient, except for the geoid grid, which a header cannot name."""
    points, time = sweep(track(), SMALL)
    source = tmp_path / "raw.las"
    before = written_las(source, number, points, time)
    grid = str(folded_geoid(tmp_path / "folded.gtx")) if height else ""
    system = coordinate_system(code, height=grid)
    path = tmp_path / "map.laz"
    after = to_las(source, path, system)
    expected = one_by_one(system, track(), before.xyz, time)
    metres = np.array(system.metres)
    assert np.abs((after.xyz - expected) * metres).max() < 0.6e-4
    assert (np.asarray(after.header.scales) * metres <= 1.2e-4).all()
    choice = {**LAS_FORMAT.preview(path, {}).choice, "height": grid}
    if number < 6 and code == "EPSG:4326":
        choice["frame"] = "georeferenced"
    found = crs_of_options(LAS_FORMAT.complete_options(choice))
    assert found is not None
    trajectory = track()
    recovery = RecoverySetup(found, trajectory, MOUNTING)
    parts = [
        part.xyz for part, _ in recover_scanner_points(LAS_FORMAT.read(path, choice), recovery)
    ]
    assert np.linalg.norm(np.concatenate(parts) - before.xyz, axis=1).max() < 2e-4


def test_heights_with_a_code_are_in_the_header(tmp_path: Path) -> None:
    """EPSG:5703 needs a grid that may be absent, so only the header is written and read here."""
    from lispac.io.las.las_crs_writer import write_crs

    for number, version in ((3, "1.2"), (6, "1.4")):
        header = laspy.LasHeader(point_format=number, version=version)
        write_crs(header, CRS("EPSG:6347+5703"))
        las = laspy.LasData(header)
        las.x = las.y = las.z = np.zeros(1)
        las.write(tmp_path / "heights.las")
        read = laspy.read(tmp_path / "heights.las").header
        assert (
            read_header_crs(read).text == "EPSG:6347+5703"
            or CRS(read_header_crs(read).text).sub_crs_list[1].to_epsg() == 5703
        )
        if number < 6:
            keys = {k.id: k.value_offset for r in read.vlrs if r.record_id == 34735
                    for k in r.geo_keys}  # fmt: skip
            assert (keys[3072], keys[4096], keys[4099]) == (6347, 5703, 9001)


def test_other_columns_become_extra_bytes(tmp_path: Path) -> None:
    """Columns of every type are read back bit by bit."""
    points, time = sweep(track(), 500)
    rng = np.random.default_rng(4)
    extra = {
        "intensity": rng.uniform(0, 1, 500),
        "red": rng.integers(0, 65536, 500).astype(np.uint16),
        "return_number": rng.integers(1, 5, 500).astype(np.uint8),
        "ring": rng.integers(0, 64, 500).astype(np.int16),
        "is_valid": rng.integers(0, 2, 500).astype(bool),
        "normal": rng.normal(0, 1, (500, 3)),
        "a name that is longer than thirty-two bytes": rng.normal(0, 1, 500).astype(np.float32),
        "a name that is longer than thirty-two letters": rng.integers(0, 9, 500),
        "gps_time": time + 1,
        "remark": np.array(["x"] * 500),
    }
    chunk = PointChunk(points, time, extra, 500)
    pattern = layout_of_columns(chunk)
    assert pattern.notes == (note("export.column_excluded", column="remark"),)
    path = tmp_path / "map.laz"
    mapper = ScannerPointConverter(coordinate_system(UTM), track(), MOUNTING)
    write_cloud([chunk], path, path, mapper, layout_of_columns)
    after = laspy.read(path)
    assert after.point_format.id == 7
    np.testing.assert_array_equal(after.gps_time, time)
    np.testing.assert_array_equal(after.red, extra["red"])
    np.testing.assert_array_equal(after.return_number, extra["return_number"])
    np.testing.assert_array_equal(after.number_of_returns, 1)
    for name in ("ring", "is_valid"):
        np.testing.assert_array_equal(after[name], extra[name])
    np.testing.assert_array_equal(after["source_intensity"], extra["intensity"])
    np.testing.assert_array_equal(after.intensity, np.rint(extra["intensity"]))
    for k in range(3):
        np.testing.assert_array_equal(after[f"normal_{k + 1}"], extra["normal"][:, k])
    long = [name for name in after.point_format.extra_dimension_names if name.startswith("a name")]
    assert len(long) == len(set(long)) == 2
    np.testing.assert_array_equal(after["source_gps_time"], time + 1)


def test_values_too_large_for_their_dimension_are_refused(tmp_path: Path) -> None:
    points, time = sweep(track(), 200)
    returns = np.ones(200, np.uint8)
    first = PointChunk(points[:100], time[:100], {"return_number": returns[:100]}, 200)
    second = PointChunk(points[100:], time[100:], {"return_number": returns[100:] + 40}, 200)
    path = tmp_path / "map.laz"
    mapper = ScannerPointConverter(coordinate_system(UTM), track(), MOUNTING)
    with pytest.raises(InputError) as refused:
        write_cloud([first, second], path, path, mapper, layout_of_columns)
    assert refused.value.message == error(
        "las.value_too_large", file="map.laz", column="return_number", value=41, limit=15
    )


def test_progress_shows_the_rate_and_the_time_remaining(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("lispac.progress.MIN_RATE_TIME_S", 0.0)
    points, time = sweep(track(), 40_000)
    parts = np.array_split(np.arange(len(time)), 20)
    chunks = (PointChunk(points[k], time[k], {}, len(time)) for k in parts)
    steps: list[tuple[float, str]] = []
    path = tmp_path / "map.laz"
    mapper = ScannerPointConverter(coordinate_system(UTM), track(), MOUNTING)

    def listen(fraction: float, step: Step | None = None) -> None:
        steps.append((fraction, str(step)))

    write_cloud(chunks, path, path, mapper, layout_of_columns, progress=listen)
    fractions = [fraction for fraction, _ in steps]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    assert len(steps) == 20
    assert re.search(r"map\.laz: .* points, .* M points/s, .* left", steps[5][1])


def test_waveforms_are_not_written_and_reported(tmp_path: Path) -> None:
    points, time = sweep(track(), SMALL)
    source = tmp_path / "raw.las"
    las = written_las(source, 9, points, time)
    las.header.global_encoding.waveform_data_packets_internal = True
    assert las.evlrs is not None
    las.evlrs.append(laspy.VLR("LASF_Spec", 65535, "waveforms", b"w" * 100))
    las.write(source)
    pattern = layout_of_las(source)
    assert pattern.notes == (note("export.waveforms", file="raw.las"),)
    after = to_las(source, tmp_path / "map.las", coordinate_system(UTM))
    assert not after.header.global_encoding.waveform_data_packets_internal
    assert [record.record_data for record in after.evlrs or []] == [b"e" * 70]


def test_a_line_without_points_is_refused(tmp_path: Path) -> None:
    mapper = ScannerPointConverter(coordinate_system(UTM), track(), MOUNTING)
    path = tmp_path / "L1.las"
    with pytest.raises(InputError) as caught:
        write_cloud([], path, path, mapper, layout_of_columns)
    assert caught.value.code == "export.no_points"
    assert not path.exists()


def test_points_before_the_trajectory_are_counted_and_not_written(tmp_path: Path) -> None:
    points, time = sweep(track(), 600)
    early = PointChunk(points[:200], time[:200] - 7200.0, {}, 800)
    inside = PointChunk(points, time, {}, 800)
    mapper = ScannerPointConverter(coordinate_system(UTM), track(), MOUNTING)
    path = tmp_path / "L1.las"
    done = write_cloud([early, inside], path, path, mapper, layout_of_columns)
    assert (done.points, done.outside) == (600, 200)
    assert len(laspy.read(path).points) == 600
    with pytest.raises(InputError) as caught:
        write_cloud([early, early], path, path, mapper, layout_of_columns)
    assert caught.value.code == "export.outside_trajectory"
    assert caught.value.message is not None
    assert caught.value.message.params == {
        "line": "L1", "count": 400, "start": 400_000.0, "end": 400_060.0
    }  # fmt: skip
