"""Tests of files whose header has another number of points than the file."""

import struct
from collections.abc import Iterator
from pathlib import Path

import laspy
import lazrs
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.formats import format_of
from lispac.io.las import las_chunks
from lispac.io.las.las_format import read_scan
from lispac.io.points.line_times import read_line_times
from lispac.messages import Level, Message, error
from tests.io.test_points_damaged_headers import crc32c
from tests.support import point_files as files
from tests.support.long_runs import others_long

COUNT_OFFSET, LEGACY_COUNT_OFFSET = 247, 107
"""Byte offsets of both counts in a LAS 1.4 header; before 1.4 only the second exists."""


def las(path: Path, count: int, point_format: int = 6, version: str = "1.4") -> Path:
    """Write points at regular times with laspy."""
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales = np.full(3, 1e-4)
    data = laspy.LasData(header)
    data.x, data.y, data.z = places(count).T
    if "gps_time" in header.point_format.dimension_names:
        data.gps_time = times(count)
    data.write(path)
    return path


def places(count: int) -> np.ndarray:
    return np.random.default_rng(4).normal(0, 10, (count, 3)).round(4)


def times(count: int) -> np.ndarray:
    return 300_000 + np.arange(count) / 1000


def with_header_counts(path: Path, count: int, legacy: int | None = None) -> Path:
    """Change the counts in the header of a file."""
    content = bytearray(path.read_bytes())
    if content[24:26] == b"\x01\x04":
        struct.pack_into("<Q", content, COUNT_OFFSET, count)
        if legacy is not None:
            struct.pack_into("<I", content, LEGACY_COUNT_OFFSET, legacy)
    else:
        struct.pack_into("<I", content, LEGACY_COUNT_OFFSET, count)
    path.write_bytes(content)
    return path


def with_bytes_appended(path: Path, after: bytes, records: int = 0) -> Path:
    """Append bytes after the points; as extended records if their number is given."""
    content = bytearray(path.read_bytes())
    if records:
        struct.pack_into("<QI", content, 235, len(content), records)
    path.write_bytes(content + after)
    return path


def read(path: Path, key: str = "las") -> tuple[np.ndarray, np.ndarray]:
    """Return coordinates and times of all points."""
    chunks = list(format_of(key).read(path, {}))
    return np.concatenate([c.xyz for c in chunks]), np.concatenate([c.time for c in chunks])


def messages(path: Path, key: str = "las") -> list[Message]:
    """Messages of the preview; a format may read them without the preview."""
    found = format_of(key).preview(path, {}).messages
    assert format_of(key).messages(path, {}) == found
    return list(found)


def require_all_read(path: Path, count: int) -> None:
    """Check all functions that read points or their number."""
    xyz, time = read(path)
    np.testing.assert_allclose(xyz, places(count), atol=1e-6)
    np.testing.assert_array_equal(time, times(count))
    scan = read_scan(path)
    np.testing.assert_array_equal(scan.points_lidar, xyz)
    np.testing.assert_array_equal(scan.time, time)
    assert las_chunks.point_count(path) == count
    assert format_of("las").preview(path, {}).facts["points"] == count
    found = read_line_times(path, format_of("las"), {})
    assert (found.count, found.end) == (count, times(count)[-1])


FORMATS_AND_VERSIONS = [(1, "1.2"), (3, "1.3"), (1, "1.4"), (6, "1.4"), (7, "1.4")]


@pytest.mark.parametrize(("point_format", "version"), FORMATS_AND_VERSIONS)
@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("counted", others_long([0, 1, 700, 1499], lambda counted: counted == 700))
def test_all_points_are_read_if_the_header_counts_fewer(
    tmp_path: Path, ending: str, point_format: int, version: str, counted: int
) -> None:
    path = las(tmp_path / f"a.{ending}", 1500, point_format, version)
    with_header_counts(path, counted, legacy=counted)
    require_all_read(path, 1500)
    (message,) = messages(path)
    assert (message.code, message.level) == ("file.header_count", Level.WARNING)
    assert (message.params["header"], message.params["held"]) == (counted, 1500)


@pytest.mark.parametrize(("point_format", "version"), FORMATS_AND_VERSIONS)
@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize(
    "count", others_long([1, 2, 1500, 50_000, 50_001], lambda count: count in (1, 50_001))
)
def test_correct_counts_have_no_message(
    tmp_path: Path, ending: str, point_format: int, version: str, count: int
) -> None:
    """Includes LAZ files whose last chunk has 50,000 points or one point."""
    path = las(tmp_path / f"a.{ending}", count, point_format, version)
    assert las_chunks.point_count(path) == count
    assert messages(path) == []


@pytest.mark.parametrize(
    ("counted", "stored"), others_long([(50_000, 100_000), (99_999, 100_000), (7, 50_001)])
)
@pytest.mark.parametrize("point_format", others_long([1, 6]))
def test_laz_points_are_counted_over_several_chunks(
    tmp_path: Path, point_format: int, counted: int, stored: int
) -> None:
    path = with_header_counts(las(tmp_path / "a.laz", stored, point_format), counted, legacy=0)
    assert las_chunks.point_count(path) == stored
    np.testing.assert_array_equal(read(path)[1], times(stored))
    assert [message.params["held"] for message in messages(path)] == [stored]


@pytest.mark.parametrize("counted", [0, 900, 1500])
@pytest.mark.parametrize("point_format", [1, 6])
def test_laz_chunks_of_variable_size_are_counted(
    tmp_path: Path, point_format: int, counted: int
) -> None:
    """The chunk table has the number of points of each chunk."""
    plain = las(tmp_path / "a.las", 1500, point_format)
    content = plain.read_bytes()
    start, size = (
        struct.unpack_from("<I", content, 96)[0],
        struct.unpack_from("<H", content, 105)[0],
    )
    record = lazrs.LazVlr.new_for_compression(point_format, 0, True)
    vlr = struct.pack("<H16sHH32s", 0, b"laszip encoded", 22204, len(record.record_data()), b"")
    head = bytearray(content[:start] + vlr + bytes(record.record_data()))
    struct.pack_into("<II", head, 96, len(head), struct.unpack_from("<I", head, 100)[0] + 1)
    head[104] |= 0x80
    path = tmp_path / "a.laz"
    with path.open("w+b") as file:
        file.write(head)
        compressor = lazrs.LasZipCompressor(file, record)
        compressor.reserve_offset_to_chunk_table()
        for first, last in ((0, 400), (400, 1100), (1100, 1500)):
            compressor.compress_many(content[start + first * size : start + last * size])
            compressor.finish_current_chunk()
        compressor.done()
    with_header_counts(path, counted, legacy=0)
    require_all_read(path, 1500)
    assert len(messages(path)) == (counted != 1500)


def test_a_correct_legacy_count_is_a_note(tmp_path: Path) -> None:
    """LAS 1.4 whose 64-bit count is zero or wrong: all points are read, with a note."""
    for counted in (0, 2000):
        path = with_header_counts(las(tmp_path / "a.las", 1500, 1), counted, legacy=1500)
        require_all_read(path, 1500)
        (message,) = messages(path)
        assert (message.code, message.level) == ("file.legacy_count", Level.NOTE)


def test_a_legacy_count_that_differs_is_a_note(tmp_path: Path) -> None:
    path = with_header_counts(las(tmp_path / "a.las", 1500, 1), 1500, legacy=40)
    require_all_read(path, 1500)
    (message,) = messages(path)
    assert (message.code, message.params["legacy"]) == ("file.legacy_count", 40)


@pytest.mark.parametrize("counted", [0, 700, 1500])
def test_extended_records_are_not_points(tmp_path: Path, counted: int) -> None:
    path = las(tmp_path / "a.las", 1500)
    record = struct.pack("<H16sHQ32s", 0, b"own", 1, 3000, b"") + bytes(range(1, 251)) * 12
    with_header_counts(with_bytes_appended(path, record, 1), counted)
    require_all_read(path, 1500)
    assert [m.params["held"] for m in messages(path)] == [1500] * (counted != 1500)


def test_reserved_space_is_not_read_as_points(tmp_path: Path) -> None:
    """Recorders reserve space for points, and may stop before they write the count."""
    for counted in (1500, 0):
        path = with_header_counts(
            with_bytes_appended(las(tmp_path / "a.las", 1500), bytes(30 * 5000)), counted
        )
        require_all_read(path, 1500)
        assert [m.code for m in messages(path)] == ["file.header_count"] * (counted == 0)


def test_other_bytes_after_the_points_are_reported(tmp_path: Path) -> None:
    noise = np.random.default_rng(0).integers(1, 255, 3000, dtype=np.uint8).tobytes()
    path = with_bytes_appended(las(tmp_path / "a.las", 1500), noise)
    require_all_read(path, 1500)
    (message,) = messages(path)
    assert (message.code, message.params["bytes"]) == ("file.unread_bytes", 3000)


def test_an_incomplete_last_record_is_ignored(tmp_path: Path) -> None:
    """The recorder stopped: the count is zero and the last record is incomplete."""
    path = with_header_counts(las(tmp_path / "a.las", 1500), 0)
    path.write_bytes(path.read_bytes()[:-11])
    assert las_chunks.point_count(path) == 1499
    np.testing.assert_array_equal(read(path)[1], times(1499))
    assert messages(path)[0].params["held"] == 1499


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("point_format", [1, 6])
def test_missing_points_are_refused(tmp_path: Path, ending: str, point_format: int) -> None:
    path = with_header_counts(las(tmp_path / f"a.{ending}", 1500, point_format), 2000, legacy=0)
    for task in (lambda: read(path), lambda: read_scan(path), lambda: messages(path)):
        with pytest.raises(InputError) as refused:
            task()
        assert refused.value.message == error(
            "file.points_missing", file=str(path), header=2000, held=1500
        )


def test_all_points_of_a_reference_without_times_are_read(tmp_path: Path) -> None:
    for ending in ("las", "laz"):
        path = with_header_counts(las(tmp_path / f"a.{ending}", 600, 0, "1.2"), 200)
        np.testing.assert_allclose(
            np.concatenate(list(las_chunks.read_coordinates(path))), places(600), atol=1e-6
        )


HEADERS = {
    "a.ply": ("element vertex 60", "element vertex {}"),
    "b.ply": ("element vertex 60", "element vertex {}"),
    "c.ply": ("element vertex 60", "element vertex {}"),
    "a.pcd": ("POINTS 60", "POINTS {}"),
    "b.pcd": ("POINTS 60", "POINTS {}"),
    "c.pcd": ("POINTS 60", "POINTS {}"),
    "d.pcd": ("POINTS 60", "POINTS {}"),
}


@pytest.mark.parametrize("counted", [0, 25, 59])
@pytest.mark.parametrize("name", HEADERS)
def test_all_points_of_ply_and_pcd_are_read(tmp_path: Path, name: str, counted: int) -> None:
    key, write = files.VALID_FILES[name]
    path = write(tmp_path / name)
    whole = read(path, key)
    assert messages(path, key) == []
    old, new = HEADERS[name]
    content = path.read_bytes()
    assert old.encode() in content
    path.write_bytes(content.replace(old.encode(), new.format(counted).encode(), 1))
    for values, expected in zip(read(path, key), whole, strict=True):
        np.testing.assert_array_equal(values, expected)
    (message,) = messages(path, key)
    assert message.code == "file.header_count"
    assert (message.params["header"], message.params["held"]) == (counted, 60)


def faces(text: bool) -> Iterator[bytes]:
    """Yield parts of a PLY file of three points and two faces."""
    kind = "ascii" if text else "binary_little_endian"
    yield (
        f"ply\nformat {kind} 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nproperty double time\nelement face 2\n"
        "property list uchar int vertex_indices\nend_header\n"
    ).encode()
    rows = [(1, 2, 3, 10), (4, 5, 6, 11), (7, 8, 9, 12)]
    for row in rows:
        yield " ".join(map(str, row)).encode() + b"\n" if text else struct.pack("<4d", *row)
    for _ in range(2):
        yield b"3 0 1 2\n" if text else struct.pack("<B3i", 3, 0, 1, 2)


@pytest.mark.parametrize("text", [True, False])
def test_faces_of_ply_are_not_points(tmp_path: Path, text: bool) -> None:
    path = tmp_path / "a.ply"
    path.write_bytes(b"".join(faces(text)))
    np.testing.assert_array_equal(read(path, "ply")[1], [10, 11, 12])
    assert messages(path, "ply") == []


def test_e57_that_counts_fewer_points_than_it_holds_is_refused(tmp_path: Path) -> None:
    """libE57 reads only the counted points; pages of 1,020 bytes have a checksum each."""
    path = files.e57(tmp_path / "a.e57", scans=1)
    paged = path.read_bytes()
    plain = b"".join(paged[k : k + 1020] for k in range(0, len(paged), 1024))
    assert b'recordCount="60"' in plain
    plain = plain.replace(b'recordCount="60"', b'recordCount="20"')
    path.write_bytes(
        b"".join(
            plain[k : k + 1020] + struct.pack(">I", crc32c(plain[k : k + 1020]))
            for k in range(0, len(plain), 1020)
        )
    )
    for task in (lambda: read(path, "e57"), lambda: messages(path, "e57")):
        with pytest.raises(InputError) as refused:
            task()
        assert refused.value.message == error(
            "e57.points_not_counted", file=str(path), header=20, held=60
        )
