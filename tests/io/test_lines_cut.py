"""Tests of files that are cut or incomplete, and of the times of such lines."""

import os
import struct
from collections.abc import Sequence
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.io.format_types import PointChunk
from lispac.io.formats import format_of
from lispac.io.las import las_chunks
from lispac.io.las import las_format as las
from lispac.io.las.las_export import layout_of_columns, open_cloud_writer
from lispac.io.las.las_header_check import require_sound_header
from lispac.io.point_counts import PointCounts
from lispac.io.points import line_times, point_records
from lispac.messages import error
from lispac.survey.georeferencing import Mounting
from tests.support import point_files as files
from tests.support.error_codes import has_code

LAS = format_of("las")


def written(path: Path, count: int, centre: Sequence[float] = (0, 0, 0)) -> tuple[Path, int, int]:
    """Write points around a centre; return path, offset of the points and bytes of a point."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, 1e-4), np.array(centre)
    data = laspy.LasData(header)
    xyz = np.random.default_rng(0).normal(0, 10, (count, 3)) + centre
    data.x, data.y, data.z = xyz.T
    data.gps_time = np.linspace(400_000, 400_100, count)
    data.write(path)
    with laspy.open(path) as reader:
        return path, reader.header.offset_to_point_data, reader.header.point_format.size


@pytest.mark.parametrize("kept", [10_000, 10_500])
def test_a_file_cut_between_two_points_while_read_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kept: int
) -> None:
    """The remaining points are valid; only the count shows the cut."""
    monkeypatch.setattr("lispac.io.las.las_chunks.POINTS_PER_CHUNK", 1000)
    path, start, size = written(tmp_path / "a.las", 20_000)
    chunks = LAS.read(path, {})
    next(chunks)
    os.truncate(path, start + kept * size)
    with pytest.raises(InputError) as refused:
        list(chunks)
    assert refused.value.message == error(
        "file.points_missing", file=str(path), header=20_000, held=kept
    )


@pytest.mark.parametrize("kept", [150, 100])
def test_a_file_cut_after_the_header_check_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kept: int
) -> None:
    path, start, size = written(tmp_path / "a.las", 200)

    def checked_and_cut(path: Path) -> PointCounts:
        counts = require_sound_header(path)
        os.truncate(path, start + kept * size)
        return counts

    monkeypatch.setattr(las_chunks, "require_sound_header", checked_and_cut)
    monkeypatch.setattr(las_chunks, "POINTS_PER_CHUNK", 100)
    with pytest.raises(InputError) as refused:
        las.read_scan(path)
    assert refused.value.message == error(
        "file.points_missing", file=str(path), header=200, held=kept
    )


def test_streamed_laz_is_read(tmp_path: Path) -> None:
    """The offset of the chunk table is at the end of the file."""
    path = files.las(tmp_path / "a.laz")
    content = bytearray(path.read_bytes())
    (start,) = struct.unpack_from("<I", content, 96)
    table = content[start : start + 8]
    content[start : start + 8] = struct.pack("<q", -1)
    path.write_bytes(content + table)
    (chunk,) = LAS.read(path, {})
    np.testing.assert_allclose(chunk.xyz, files.XYZ, atol=1e-9)
    path.write_bytes(content + struct.pack("<q", 1 << 40))
    with pytest.raises(InputError) as refused:
        list(LAS.read(path, {}))
    assert refused.value.code == "las.header"


def test_points_outside_the_range_of_las_are_refused(tmp_path: Path) -> None:
    """LAS stores coordinates as 32-bit multiples of the resolution."""
    path = tmp_path / "a.las"
    points, time = np.zeros((2, 3)), np.arange(2.0)
    pattern = layout_of_columns(PointChunk(points, time, {}))
    mounting, frame = Mounting(np.zeros(3), np.zeros(3)), LocalFrame(0.8, -1.2, 0.0)
    with open_cloud_writer(
        path, pattern, None, np.zeros(3), mounting=mounting, frame=frame, compressed=False
    ) as cloud:
        cloud.write(cloud.records(points, time, {}))
        points[1, 0] = 1e9
        with pytest.raises(InputError) as refused:
            cloud.records(points, time, {})
    reach = 2**31 * laspy.read(path).header.scales[0]
    assert refused.value.message == error("las.too_far", file="a.las", limit=round(reach))


def test_missing_points_at_the_end_of_a_block_are_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(point_records, "BYTES_PER_READ", 32)  # one point of four numbers
    path = tmp_path / "a.ply"
    fields = "".join(f"property double {name}\n" for name in ("x", "y", "z", "time"))
    path.write_text(
        f"ply\nformat ascii 1.0\nelement vertex 2\n{fields}end_header\n1 2 3 10\n", newline="\n"
    )
    with pytest.raises(InputError) as refused:
        list(format_of("ply").read(path, {}))
    assert refused.value.message == error("file.points_missing", file=str(path), header=2, held=1)


def test_an_inconsistent_cidco_record_is_refused(tmp_path: Path) -> None:
    path = files.cidco(tmp_path / "line")
    rows = np.fromfile(path).reshape(-1, 22)
    rows[6, 0] += 500  # the local point is 500 m off the one of the scanner
    rows.tofile(path)
    with pytest.raises(InputError) as refused:
        list(format_of("cidco").read(path, {}))
    assert refused.value.message == error("cidco.inconsistent_point", file=str(path), point=7)


@pytest.mark.parametrize("most", [10, 1000])
def test_times_of_a_line_on_the_map(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, most: int
) -> None:
    """Distant points are an error in the scanner frame only, in whole and in sampled files."""
    monkeypatch.setattr(line_times, "MAX_POINTS_READ_WHOLE", most)
    monkeypatch.setattr(line_times, "POINTS_PER_BLOCK", 30)
    monkeypatch.setattr("lispac.io.las.las_chunks.POINTS_PER_CHUNK", 16)
    path, _, _ = written(tmp_path / "a.las", 60, [350_000, 5e6, 0])
    found = line_times.read_line_times(path, LAS, {"frame": "georeferenced"})
    assert (found.start, found.end, found.count) == (400_000, 400_100, 60)
    assert found.whole == (most > 60)
    with pytest.raises(InputError, check=has_code("survey.not_scanner_frame")):
        line_times.read_line_times(path, LAS, {"frame": "scanner"})


def test_a_long_line_without_usable_times_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(line_times, "MAX_POINTS_READ_WHOLE", 10)
    monkeypatch.setattr(line_times, "POINTS_PER_BLOCK", 30)
    path = files.las(tmp_path / "a.las")
    data = laspy.read(path)
    data.gps_time = np.full(files.COUNT, np.nan)
    data.write(path)
    with pytest.raises(InputError) as refused:
        line_times.read_line_times(path, LAS, {})
    assert refused.value.message == error("line.no_usable_time", file=str(path))


def test_a_line_without_valid_points_is_refused(tmp_path: Path) -> None:
    path = files.e57(tmp_path / "a.e57", invalid=True, none_valid_of=files.COUNT)
    with pytest.raises(InputError) as refused:
        line_times.read_line_times(path, format_of("e57"), {})
    assert refused.value.message == error("line.no_points", file=str(path))
