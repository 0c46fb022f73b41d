"""Headers of PCD, PLY and E57 that contradict themselves or promise what is not there."""

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io import e57, pcd
from lispac.io.point_formats import POINTS
from tests import point_files as files

FORMATS = {format_.key: format_ for format_ in POINTS}
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
SOUND = {"pcd": PCD, "ply": PLY}
DAMAGED = "the header of this PCD file is damaged"


def said(path: Path, key: str, choice: dict[str, Any] | None = None) -> str:
    """What reading says, without the name of the file."""
    with pytest.raises(InputError) as refused:
        list(FORMATS[key].read(path, choice or {}))
    return str(refused.value).removeprefix(f"{path}: ")


def written(folder: Path, key: str, old: str = "", new: str = "") -> Path:
    """The sound file of text, with one thing changed."""
    assert old in SOUND[key], "the test changes nothing"
    path = folder / f"a.{key}"
    path.write_text(SOUND[key].replace(old, new, 1), newline="\n")
    return path


@pytest.mark.parametrize("key", SOUND)
def test_the_files_these_are_made_from_are_sound(tmp_path: Path, key: str) -> None:
    """In PLY the points come after the rows of another element."""
    (chunk,) = FORMATS[key].read(written(tmp_path, key), {})
    np.testing.assert_array_equal(chunk.xyz, [[1, 2, 3], [4, 5, 6]])
    np.testing.assert_array_equal(chunk.time, [10, 11])


@pytest.mark.parametrize(
    ("key", "old", "new", "sentence"),
    [
        ("pcd", "DATA ascii\n1 2 3 10\n4 5 6 11\n", "",
         "this is not PCD: its header is missing or damaged."),
        ("pcd", "DATA ascii", "DATA hex", "the PCD data kind hex is not known."),
        ("pcd", "DATA ascii", "DATA", "the PCD data kind missing is not known."),
        ("pcd", "SIZE 8 8 8 8\n", "",
         "the header of this PCD file has no SIZE; it is damaged: export it again."),
        ("pcd", "TYPE F F F F", "TYPE F F F X",
         f"{DAMAGED} (field timestamp of type X, size 8, 1); export it again."),
        ("pcd", "COUNT 1 1 1 1", "COUNT 1 1 1 0",
         f"{DAMAGED} (field timestamp of type F, size 8, 0); export it again."),
        ("pcd", "x y z timestamp", "x y y timestamp",
         f"{DAMAGED} (two fields of one name); export it again."),
        ("pcd", "POINTS 2", "POINTS -2", f"{DAMAGED} (points -2)."),
        ("pcd", PCD[PCD.index("POINTS 2"):], "POINTS 0\nDATA ascii\n",
         "this line holds no points; leave it out."),
        ("pcd", "x y z timestamp", "x y up timestamp",
         "the points have no z (fields: x, y, up, timestamp); export them with coordinates and "
         "time."),
        ("pcd", "COUNT 1 1 1 1", "COUNT 1 1 1 2",
         "point 1 reads '1 2 3 10', which is not 4 numbers as the header says; copy or export it "
         "again."),
        ("ply", "format ascii 1.0\n", "", "the PLY format missing is not known."),
        ("ply", "element vertex", "element corner", "this PLY file has no vertices."),
        ("ply", "vertex 2", "vertex -2", "the header of this PLY file is damaged (count -2)."),
        ("ply", "vertex 2", f"vertex {2**49}",
         f"the header of this PLY file is damaged (count {2**49})."),
        ("ply", PLY[PLY.index("vertex 2"):],
         PLY[PLY.index("vertex 2"):].replace("vertex 2", "vertex 0").partition("1 2 3")[0],
         "this line holds no points; leave it out."),
        ("ply", "double z", "double y", "vertex has two properties y; export it again."),
        ("ply", "property double view\n", "", "camera has no properties; export it again."),
        ("ply", "double time", "real time",
         "vertex has the property time of type real, which no point of a line has; export points "
         "alone, without faces."),
        ("ply", "camera 2", "camera 9",
         "the header promises 2 points, the file has room for 0; it is cut short: copy or export "
         "it again."),
        ("ply", "4 5 6 11\n", "",
         "the header promises 2 points, the file holds 1; copy or export it again."),
        ("ply", "4 5 6 11", "4 5 6",
         "point 2 reads '4 5 6', which is not 4 numbers as the header says; copy or export it "
         "again."),
    ],
)  # fmt: skip
def test_a_header_that_cannot_be_is_refused(
    tmp_path: Path, key: str, old: str, new: str, sentence: str
) -> None:
    assert said(written(tmp_path, key, old, new), key) == sentence


def test_a_time_of_two_values_a_point_is_refused(tmp_path: Path) -> None:
    path = written(tmp_path, "pcd", "COUNT 1 1 1 1", "COUNT 1 1 1 2")
    path.write_text(path.read_text().replace(" 10\n", " 10 0\n").replace(" 11\n", " 11 0\n"))
    assert said(path, "pcd") == "the field timestamp holds more than one value a point."


def test_a_viewpoint_is_told_and_not_applied(tmp_path: Path) -> None:
    path = written(tmp_path, "pcd", "0 0 0 1 0 0 0", "5 6 7 1 0 0 0")
    assert FORMATS["pcd"].look(path, {}).facts["viewpoint"] == (
        "5 6 7 1 0 0 0 (stated, not applied)"
    )
    (chunk,) = FORMATS["pcd"].read(path, {})
    np.testing.assert_array_equal(chunk.xyz[0], [1, 2, 3])


def test_doubts_about_what_is_stored_too_coarsely(tmp_path: Path) -> None:
    """A float of 32 bits near 20,000 has steps of 2 mm, near 5,000 s of 0.5 ms (IEEE 754)."""
    path = written(tmp_path, "ply", "property double x", "property float x")
    path.write_text(path.read_text().replace("4 5 6", "20000 5 6"))
    assert any(
        doubt == "Coordinates are stored with 32 bits, in steps of 2 mm at 20,000: the points are "
        "no better than that; export with 64."
        for doubt in FORMATS["ply"].look(path, {}).doubts
    )
    path = written(tmp_path, "ply", "property double time", "property float time")
    assert not any("32 bits" in doubt for doubt in FORMATS["ply"].look(path, {}).doubts)
    path.write_text(path.read_text().replace("6 11", "6 5000"))
    assert any(
        doubt.startswith("Times are stored with 32 bits, in steps of 0.00049 s")
        for doubt in FORMATS["ply"].look(path, {}).doubts
    )
    path = written(tmp_path, "ply", "property double time", "property int time")
    doubts = FORMATS["ply"].look(path, {}).doubts
    assert "The time time is in whole numbers: state its unit." in doubts
    doubts = FORMATS["ply"].look(path, {"time_unit": "millisecond"}).doubts
    assert "The time time is in whole numbers: state its unit." not in doubts


def compressed(folder: Path, count: int, packed: bytes, whole: int | None = None) -> Path:
    path = folder / "a.pcd"
    head = PCD[: PCD.index("1 2 3 10")].replace("POINTS 2", f"POINTS {count}")
    lengths = struct.pack("<2I", len(packed), 32 * count if whole is None else whole)
    path.write_bytes(head.replace("ascii", "binary_compressed").encode() + lengths + packed)
    return path


def test_compressed_points_that_make_no_sense(tmp_path: Path) -> None:
    damaged = "the compressed points are damaged; copy or export it again."
    numbers = np.array([[1, 4], [2, 5], [3, 6], [10, 11]], dtype="<f8").tobytes()
    plain = b"\x1f" + numbers[:32] + b"\x1f" + numbers[32:]  # two runs of bytes as they are
    (chunk,) = FORMATS["pcd"].read(compressed(tmp_path, 2, plain), {})
    np.testing.assert_array_equal(chunk.xyz, [[1, 2, 3], [4, 5, 6]])
    # Bytes again that were never written; runs beyond the end; too few; and a bomb.
    for packed in (b"\x20\x05" + plain, plain[:-1], plain[:33], b"\xe0", b"\xe0\x01", b"\x20"):
        assert said(compressed(tmp_path, 2, packed), "pcd") == damaged
    assert said(compressed(tmp_path, 1_000_000, plain), "pcd") == damaged
    assert "do not fit the header" in said(compressed(tmp_path, 2, plain, 63), "pcd")
    assert said(compressed(tmp_path, 0, b""), "pcd") == "this line holds no points; leave it out."


def test_a_chunk_without_a_return_is_passed_over(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pcd, "CHUNK", 1)
    path = written(tmp_path, "pcd", "1 2 3 10", "nan nan nan 10")
    (chunk,) = FORMATS["pcd"].read(path, {})
    np.testing.assert_array_equal(chunk.xyz, [[4, 5, 6]])
    np.testing.assert_array_equal(chunk.time, [11])


def test_e57_without_points_times_or_coordinates(tmp_path: Path) -> None:
    none = files.e57(tmp_path / "none.e57", count=0, scans=1)
    assert said(none, "e57") == "this file holds no points; leave it out."
    timeless = files.e57(tmp_path / "timeless.e57", timed=False)
    assert said(timeless, "e57") == (
        "the points have no timeStamp (fields: cartesianX, cartesianY, cartesianZ, rowIndex), so "
        "they cannot be put on the trajectory; export with time stamps."
    )
    flat = files.e57(tmp_path / "flat.e57", without=("cartesianZ",))
    assert said(flat, "e57") == "the points have no coordinates; export the file again."


def test_e57_scans_of_different_fields(tmp_path: Path) -> None:
    path = files.e57(tmp_path / "a.e57", first_without=("rowIndex",))
    assert said(path, "e57") == "its scans have different fields; export them one by one."


@pytest.mark.parametrize(
    ("parts", "expected"),
    [
        ((), lambda xyz: xyz),
        (("translation",), lambda xyz: xyz + [1, 2, 3]),
        (("rotation",), lambda xyz: xyz[:, [1, 0, 2]] * [-1, 1, 1]),
        (None, lambda xyz: xyz),
    ],
)
def test_e57_poses_of_which_parts_are_left_out(
    tmp_path: Path, parts: tuple[str, ...] | None, expected: Any
) -> None:
    """A part left out is none; the quaternion turns by 90 deg about z."""
    half = np.sqrt(0.5)
    path = files.e57(
        tmp_path / "a.e57", quaternion=(half, 0, 0, half), translation=(1, 2, 3), pose_parts=parts
    )
    read = np.concatenate(list(e57.places(path)))
    np.testing.assert_allclose(read, expected(files.XYZ), atol=1e-12)


def test_e57_with_a_quaternion_that_is_no_rotation(tmp_path: Path) -> None:
    path = files.e57(tmp_path / "a.e57", quaternion=(0.5, 0, 0, 0))
    assert said(path, "e57") == (
        "cannot be read as E57 (the quaternion of a pose has length 0.500); copy or export it "
        "again."
    )


def test_e57_whose_first_scan_has_no_valid_point(tmp_path: Path) -> None:
    """Such a scan is passed over, by the look at the file too."""
    path = files.e57(tmp_path / "a.e57", invalid=True, none_valid_of=30)
    found = FORMATS["e57"].look(path, {})
    assert found.facts["points"] == "60 in 2 scans"
    (chunk,) = FORMATS["e57"].read(path, {})
    np.testing.assert_allclose(chunk.xyz, files.XYZ[30::2], atol=1e-9)
    path = files.e57(tmp_path / "b.e57", invalid=True, none_valid_of=60)
    with pytest.raises(InputError) as refused:
        FORMATS["e57"].look(path, {})
    assert str(refused.value) == f"{path}: this line holds no points; leave it out."


def crc32c(data: bytes) -> int:
    """Castagnoli's checksum (RFC 3720, appendix B.4), bit by bit."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def test_e57_that_promises_more_points_than_it_holds(tmp_path: Path) -> None:
    """With checksums that hold: each page of 1,020 bytes is followed by its own."""
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
    assert said(path, "e57") == ("a scan promises 90 points and holds 60; copy or export it again.")
