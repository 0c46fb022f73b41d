"""Tests of PCD, PLY and E57 files with contradictory or incomplete headers."""

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.formats import POINT_FORMATS
from lispac.io.points import e57, pcd
from lispac.messages import error, note, warning
from tests.support import point_files as files
from tests.support.message_codes import codes

FORMATS = {format_.key: format_ for format_ in POINT_FORMATS}
PCD = """VERSION 0.7
FIELDS x y z timestamp
SIZE 8 8 8 8
TYPE F F F F
COUNT 1 1 1 1
WIDTH 2
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS 2
DATA ascii
1 2 3 10
4 5 6 11
"""
PLY = """ply
format ascii 1.0
element camera 2
property double view
element vertex 2
property double x
property double y
property double z
property double time
end_header
7
8
1 2 3 10
4 5 6 11
"""
VALID_FILES = {"pcd": PCD, "ply": PLY}


def refused_with(path: Path, key: str, code: str, **params: Any) -> None:
    """Check the message of the error that reading a file raises."""
    with pytest.raises(InputError) as refused:
        list(FORMATS[key].read(path, {}))
    assert refused.value.message == error(code, file=str(path), **params)
    assert str(refused.value).startswith(f"{path}: ")


def written(folder: Path, key: str, old: str = "", new: str = "") -> Path:
    """Write the valid text file with one replacement."""
    assert old in VALID_FILES[key], "the test changes nothing"
    path = folder / f"a.{key}"
    path.write_text(VALID_FILES[key].replace(old, new, 1), newline="\n")
    return path


@pytest.mark.parametrize("key", VALID_FILES)
def test_the_unchanged_files_are_read(tmp_path: Path, key: str) -> None:
    """The PLY file has another element before the points."""
    (chunk,) = FORMATS[key].read(written(tmp_path, key), {})
    np.testing.assert_array_equal(chunk.xyz, [[1, 2, 3], [4, 5, 6]])
    np.testing.assert_array_equal(chunk.time, [10, 11])


FIELD_PARAMS = {"field": "timestamp", "size": "8"}


@pytest.mark.parametrize(
    ("key", "old", "new", "code", "params"),
    [
        ("pcd", "DATA ascii\n1 2 3 10\n4 5 6 11\n", "", "pcd.header", {}),
        ("pcd", "DATA ascii", "DATA hex", "pcd.data_kind", {"kind": "hex"}),
        ("pcd", "DATA ascii", "DATA", "pcd.header_incomplete", {"entries": ("DATA",)}),
        ("pcd", "SIZE 8 8 8 8\n", "", "pcd.header_incomplete", {"entries": ("SIZE",)}),
        ("pcd", "TYPE F F F F", "TYPE F F F X",
         "pcd.field_type", {**FIELD_PARAMS, "type": "X", "number": "1"}),
        ("pcd", "COUNT 1 1 1 1", "COUNT 1 1 1 0",
         "pcd.field_type", {**FIELD_PARAMS, "type": "F", "number": "0"}),
        ("pcd", "SIZE 8 8 8 8", "SIZE 8 8 8 x", "pcd.header_damaged",
         {"reason": "x"}),
        ("pcd", "x y z timestamp", "x y y timestamp", "pcd.duplicate_field", {}),
        ("pcd", "POINTS 2", "POINTS -2", "pcd.point_count", {"header": -2}),
        ("pcd", PCD[PCD.index("POINTS 2"):], "POINTS 0\nDATA ascii\n", "file.no_points", {}),
        ("pcd", "x y z timestamp", "x y up timestamp", "file.no_coordinates",
         {"axes": ("z",), "fields": ("x", "y", "up", "timestamp")}),
        ("pcd", "COUNT 1 1 1 1", "COUNT 1 1 1 2", "file.point_not_numbers",
         {"point": 1, "text": "1 2 3 10", "values": 4}),
        ("ply", "format ascii 1.0\n", "", "ply.no_format", {}),
        ("ply", "format ascii 1.0\n", "format text 1.0\n", "ply.format", {"format": "text"}),
        ("ply", "element vertex", "element corner", "ply.no_vertices", {}),
        ("ply", "vertex 2", "vertex -2", "ply.count", {"text": "-2"}),
        ("ply", "vertex 2", f"vertex {2**49}", "ply.count", {"text": str(2**49)}),
        ("ply", PLY[PLY.index("vertex 2"):],
         PLY[PLY.index("vertex 2"):].replace("vertex 2", "vertex 0").partition("1 2 3")[0],
         "file.no_points", {}),
        ("ply", "double z", "double y", "ply.duplicate_property",
         {"element": "vertex", "property": "y"}),
        ("ply", "property double view\n", "", "ply.no_properties", {"element": "camera"}),
        ("ply", "double time", "real time", "ply.property_type",
         {"element": "vertex", "property": "time", "type": "real"}),
        ("ply", "double time", "time", "ply.property_without_type",
         {"element": "vertex", "property": "time"}),
        ("ply", "camera 2", "camera 9", "file.points_no_room", {"header": 2, "room": 0}),
        ("ply", "4 5 6 11\n", "", "file.points_missing", {"header": 2, "held": 1}),
        ("ply", "4 5 6 11", "4 5 6", "file.point_not_numbers",
         {"point": 2, "text": "4 5 6", "values": 4}),
    ],
)  # fmt: skip
def test_an_invalid_header_is_refused(
    tmp_path: Path, key: str, old: str, new: str, code: str, params: dict[str, Any]
) -> None:
    refused_with(written(tmp_path, key, old, new), key, code, **params)


def test_a_time_of_two_values_a_point_is_refused(tmp_path: Path) -> None:
    path = written(tmp_path, "pcd", "COUNT 1 1 1 1", "COUNT 1 1 1 2")
    path.write_text(path.read_text().replace(" 10\n", " 10 0\n").replace(" 11\n", " 11 0\n"))
    refused_with(path, "pcd", "file.several_values", field="timestamp")


def test_a_viewpoint_is_reported_and_not_applied(tmp_path: Path) -> None:
    path = written(tmp_path, "pcd", "0 0 0 1 0 0 0", "5 6 7 1 0 0 0")
    assert FORMATS["pcd"].preview(path, {}).facts["viewpoint"] == (
        note("fact.viewpoint", values="5 6 7 1 0 0 0")
    )
    (chunk,) = FORMATS["pcd"].read(path, {})
    np.testing.assert_array_equal(chunk.xyz[0], [1, 2, 3])


def test_coarse_coordinates_and_times_are_reported(tmp_path: Path) -> None:
    """A 32-bit float has steps of 2 mm near 20,000 m and of 0.5 ms near 5,000 s (IEEE 754)."""
    path = written(tmp_path, "ply", "property double x", "property float x")
    path.write_text(path.read_text().replace("4 5 6", "20000 5 6"))
    (coarse,) = (
        each for each in FORMATS["ply"].preview(path, {}).file_warnings
        if each.code == "points.coordinates_32_bits"
    )  # fmt: skip
    assert coarse.params["step"] == 2.0**-9
    assert coarse.params["largest"] == 20_000
    path = written(tmp_path, "ply", "property double time", "property float time")
    assert codes(FORMATS["ply"].preview(path, {}).file_warnings) == []
    path.write_text(path.read_text().replace("6 11", "6 5000"))
    expected = warning("times.coarse", file=path.name, step=2.0**-11)
    assert expected in FORMATS["ply"].preview(path, {}).file_warnings
    path = written(tmp_path, "ply", "property double time", "property int time")
    file_warnings = FORMATS["ply"].preview(path, {}).file_warnings
    assert "times.whole_numbers" in codes(file_warnings)
    file_warnings = FORMATS["ply"].preview(path, {"time_unit": "millisecond"}).file_warnings
    assert "times.whole_numbers" not in codes(file_warnings)


def compressed(folder: Path, count: int, packed: bytes, whole: int | None = None) -> Path:
    path = folder / "a.pcd"
    head = PCD[: PCD.index("1 2 3 10")].replace("POINTS 2", f"POINTS {count}")
    lengths = struct.pack("<2I", len(packed), 32 * count if whole is None else whole)
    path.write_bytes(head.replace("ascii", "binary_compressed").encode() + lengths + packed)
    return path


def test_damaged_compressed_points_are_refused(tmp_path: Path) -> None:
    numbers = np.array([[1, 4], [2, 5], [3, 6], [10, 11]], dtype="<f8").tobytes()
    plain = b"\x1f" + numbers[:32] + b"\x1f" + numbers[32:]  # two runs of literal bytes
    (chunk,) = FORMATS["pcd"].read(compressed(tmp_path, 2, plain), {})
    np.testing.assert_array_equal(chunk.xyz, [[1, 2, 3], [4, 5, 6]])
    # References to bytes not yet written; runs beyond the end; too few bytes; a decompression bomb.
    for packed in (b"\x20\x05" + plain, plain[:-1], plain[:33], b"\xe0", b"\xe0\x01", b"\x20"):
        refused_with(compressed(tmp_path, 2, packed), "pcd", "pcd.compressed_damaged")
    refused_with(compressed(tmp_path, 1_000_000, plain), "pcd", "pcd.compressed_damaged")
    path = compressed(tmp_path, 2, plain, 63)
    refused_with(path, "pcd", "pcd.compressed_size", header=2, size=path.stat().st_size)
    refused_with(compressed(tmp_path, 0, b""), "pcd", "file.no_points")


def test_a_chunk_without_returns_is_skipped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pcd, "POINTS_PER_CHUNK", 1)
    path = written(tmp_path, "pcd", "1 2 3 10", "nan nan nan 10")
    (chunk,) = FORMATS["pcd"].read(path, {})
    np.testing.assert_array_equal(chunk.xyz, [[4, 5, 6]])
    np.testing.assert_array_equal(chunk.time, [11])


def test_e57_without_points_times_or_coordinates_is_refused(tmp_path: Path) -> None:
    none = files.e57(tmp_path / "none.e57", count=0, scans=1)
    refused_with(none, "e57", "file.no_points")
    timeless = files.e57(tmp_path / "timeless.e57", timed=False)
    fields = ("cartesianX", "cartesianY", "cartesianZ", "rowIndex")
    refused_with(timeless, "e57", "e57.no_time", fields=fields)
    flat = files.e57(tmp_path / "flat.e57", without=("cartesianZ",))
    refused_with(flat, "e57", "e57.no_coordinates")


def test_e57_scans_of_different_fields_are_refused(tmp_path: Path) -> None:
    path = files.e57(tmp_path / "a.e57", first_without=("rowIndex",))
    refused_with(path, "e57", "e57.different_fields")


@pytest.mark.parametrize(
    ("parts", "expected"),
    [
        ((), lambda xyz: xyz),
        (("translation",), lambda xyz: xyz + [1, 2, 3]),
        (("rotation",), lambda xyz: xyz[:, [1, 0, 2]] * [-1, 1, 1]),
        (None, lambda xyz: xyz),
    ],
)
def test_e57_poses_with_missing_parts(
    tmp_path: Path, parts: tuple[str, ...] | None, expected: Any
) -> None:
    """A missing part is the identity; the quaternion turns by 90 deg about z."""
    half = np.sqrt(0.5)
    path = files.e57(
        tmp_path / "a.e57", quaternion=(half, 0, 0, half), translation=(1, 2, 3), pose_parts=parts
    )
    read = np.concatenate(list(e57.read_coordinates(path)))
    np.testing.assert_allclose(read, expected(files.XYZ), atol=1e-12)


def test_e57_with_an_invalid_quaternion_is_refused(tmp_path: Path) -> None:
    path = files.e57(tmp_path / "a.e57", quaternion=(0.5, 0, 0, 0))
    refused_with(path, "e57", "e57.pose", norm=0.5)


def test_an_e57_scan_without_valid_points_is_skipped(tmp_path: Path) -> None:
    """The preview skips such a scan too."""
    path = files.e57(tmp_path / "a.e57", invalid=True, none_valid_of=30)
    found = FORMATS["e57"].preview(path, {})
    assert found.facts["points"] == note("fact.points_in_scans", points=60, scans=2)
    (chunk,) = FORMATS["e57"].read(path, {})
    np.testing.assert_allclose(chunk.xyz, files.XYZ[30::2], atol=1e-9)
    path = files.e57(tmp_path / "b.e57", invalid=True, none_valid_of=60)
    with pytest.raises(InputError) as refused:
        FORMATS["e57"].preview(path, {})
    assert refused.value.message == error("file.no_points", file=str(path))


def crc32c(data: bytes) -> int:
    """Return the CRC-32C of bytes (RFC 3720, appendix B.4)."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def test_e57_that_counts_more_points_than_it_holds_is_refused(tmp_path: Path) -> None:
    """The checksums are valid: one after each page of 1,020 bytes."""
    path = files.e57(tmp_path / "a.e57", scans=1)
    paged = path.read_bytes()
    plain = b"".join(paged[k : k + 1020] for k in range(0, len(paged), 1024))
    plain = plain.replace(b'recordCount="60"', b'recordCount="90"')
    path.write_bytes(
        b"".join(
            plain[k : k + 1020] + struct.pack(">I", crc32c(plain[k : k + 1020]))
            for k in range(0, len(plain), 1020)
        )
    )
    refused_with(path, "e57", "e57.points_missing", header=90, held=60)
