"""Tests that bad files of points are refused with one sentence, by the program's errors."""

import os
import re
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pyproj import CRS

from lispac.errors import InputError
from lispac.io.formats import POINT_FORMATS
from lispac.io.point_reader_common import crs_of_options
from lispac.io.points.line_times import read_line_times
from lispac.messages import error
from lispac.survey.point_screening import PointScreen, PointSelection
from tests.support import point_files as files
from tests.support.error_codes import has_code
from tests.support.message_codes import codes

FORMATS = {format_.key: format_ for format_ in POINT_FORMATS}
NAMES = list(files.VALID_FILES)
ENDINGS_WITH_SIGNATURE = (".las", ".laz", ".e57", ".ply", ".pcd", ".pcap")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Write each valid file; tests must not change them."""
    folder = tmp_path_factory.mktemp("valid")
    return {name: write(folder / name) for name, (_, write) in files.VALID_FILES.items()}


def refusal_text(path: Path, name: str, choice: dict[str, Any] | None = None) -> str:
    """Return code and text of the error for a bad file; the text must name the file."""
    format_ = FORMATS[files.VALID_FILES[name][0]]
    with pytest.raises(InputError) as refused:
        for _ in format_.read(path, choice or {}):
            pass
    sentence = str(refused.value)
    assert sentence.startswith(str(path))
    assert "\n" not in sentence
    assert sentence.endswith(".")
    return f"{refused.value.code} {sentence}"


def damaged(tmp_path: Path, name: str, data: bytes) -> Path:
    path = tmp_path / name
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("name", NAMES)
def test_missing_files_folders_and_empty_files_are_refused(tmp_path: Path, name: str) -> None:
    assert "file.not_found" in refusal_text(tmp_path / "absent" / name, name)
    assert "file.folder" in refusal_text(tmp_path, name)
    assert re.search("is empty", refusal_text(damaged(tmp_path, name, b""), name))
    format_ = FORMATS[files.VALID_FILES[name][0]]
    for path in (tmp_path / "absent", tmp_path, tmp_path / name):
        assert format_.sniff(path) == 0


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("share", [0.05, 0.5, 0.97])
def test_truncated_files_are_refused(
    tmp_path: Path, made: dict[str, Path], name: str, share: float
) -> None:
    data = made[name].read_bytes()
    kept = data[: int(len(data) * share) - 3]  # not at the end of a record
    if made[name].suffix in (".csv", ".txt"):
        # Text cut within its last number remains valid, so it is cut within a row.
        row = kept.rfind(b"\n") + 1
        kept = kept[: row or None].rstrip() + b"\n1.5 2.5"
    refusal_text(damaged(tmp_path, name, kept), name)


@pytest.mark.parametrize("name", [name for name in NAMES if name[1:] in ENDINGS_WITH_SIGNATURE])
def test_files_with_a_wrong_signature_are_refused(
    tmp_path: Path, made: dict[str, Path], name: str
) -> None:
    path = damaged(tmp_path, name, b"XXXX" * 40 + made[name].read_bytes()[160:])
    assert FORMATS[files.VALID_FILES[name][0]].sniff(path) == 0
    assert re.match(
        r"(las\.signature|(e57|pcd|ply|capture)\.header|pcd\.header_incomplete) ",
        refusal_text(path, name),
    )


def test_a_wrong_byte_order_is_refused(tmp_path: Path, made: dict[str, Path]) -> None:
    swapped = np.fromfile(made["cidco"], "<f8").astype(">f8").tobytes()
    path = damaged(tmp_path, "cidco", swapped)
    assert FORMATS["cidco"].sniff(path) == 0
    assert re.search("byte order|not usable numbers", refusal_text(path, "cidco"))
    head, rows = made["a.ply"].read_bytes().split(b"end_header\n")
    wrong = head.replace(b"little", b"big") + b"end_header\n" + rows
    assert "not usable numbers" in refusal_text(damaged(tmp_path, "a.ply", wrong), "a.ply")


def indices_not_finite(path: Path, name: str) -> list[int]:
    """Return the indices of points that are excluded as not finite."""
    format = FORMATS[files.VALID_FILES[name][0]]
    screen = PointScreen(PointSelection(), ranged=True)
    used = [screen(c.time, c.xyz, c.extra) for c in format.read(path, {})]
    found = np.flatnonzero(~np.concatenate(used)).tolist()
    assert screen.result().not_finite == len(found)
    return found


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e200])
@pytest.mark.parametrize("column", ["x", "time"])
def test_points_that_are_not_finite_are_excluded(tmp_path: Path, value: float, column: str) -> None:
    xyz, time = files.XYZ.copy(), files.TIME.copy()
    if column == "x":
        xyz[6, 0] = value
    else:
        time[6] = value
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(time)}\nproperty double x\nproperty double y\nproperty double z\n"
        "property double time\nend_header\n"
    )
    data = head.encode() + np.column_stack([xyz, time]).astype("<f8").tobytes()
    assert indices_not_finite(damaged(tmp_path, "a.ply", data), "a.ply") == [6]
    rows = "\n".join(f"{t} {x} {y} {z}" for t, (x, y, z) in zip(time, xyz, strict=True))
    text = damaged(tmp_path, "a.csv", b"time x y z\n" + rows.encode() + b"\n")
    assert indices_not_finite(text, "a.csv") == [6]
    records = np.fromfile(files.cidco(tmp_path / "cidco"), "<f8").reshape(-1, 22)
    records[6, 4 if column == "x" else 3] = value
    assert indices_not_finite(damaged(tmp_path, "cidco", records.tobytes()), "cidco") == [6]
    if column == "time":
        las = laspy.read(files.las(tmp_path / "a.las"))
        las.gps_time[6] = value
        las.write(tmp_path / "b.las")
        assert indices_not_finite(tmp_path / "b.las", "a.las") == [6]


def test_points_without_time_are_refused(tmp_path: Path) -> None:
    for name in ("a.ply", "a.pcd"):
        path = files.cloud(tmp_path / name, time=False)
        refusal = refusal_text(path, name)
        assert "file.no_time" in refusal
        assert "(fields: x, y, z and ring)" in refusal
        files.cloud(path)
        refusal = refusal_text(path, name, {"time_field": "when"})
        assert "file.no_such_field" in refusal
        assert "when" in refusal
    path = files.text(tmp_path / "a.csv", "{x} {y} {z} {ring}")
    assert "column names: time" in refusal_text(path, "a.csv", {"columns": "x y z ring"})
    assert "has no column names" in refusal_text(path, "a.csv")


def test_times_that_are_all_zero_are_refused(tmp_path: Path) -> None:
    header = laspy.LasHeader(point_format=1, version="1.2")
    las = laspy.LasData(header)
    las.x = np.arange(2000.0)
    las.write(tmp_path / "a.las")
    with pytest.raises(InputError) as refused:
        read_line_times(tmp_path / "a.las", FORMATS["las"], {})
    assert refused.value.message == error(
        "file.one_time", file=str(tmp_path / "a.las"), count=2000, time=0.0
    )


def test_times_of_32_bits_are_refused_or_reported(tmp_path: Path) -> None:
    head = (
        "ply\nformat binary_little_endian 1.0\nelement vertex 60\nproperty float x\n"
        "property float y\nproperty float z\nproperty float time\nend_header\n"
    )
    rows = np.column_stack([files.XYZ, files.TIME]).astype("<f4")
    path = damaged(tmp_path, "a.ply", head.encode() + rows.tobytes())
    assert "file.time_32_bits" in refusal_text(path, "a.ply")
    path = files.e57(tmp_path / "a.e57", start=1.0, stamps=files.TIME, single=True)
    assert "file.time_32_bits" in refusal_text(path, "a.e57")
    las = laspy.read(files.las(tmp_path / "a.las"))
    doubled = laspy.LasData(las.header, las.points[np.repeat(np.arange(60), 5)])
    doubled.gps_time = np.linspace(400_000, 400_001, 300).astype(np.float32)
    doubled.write(tmp_path / "b.las")
    file_warnings = FORMATS["las"].preview(tmp_path / "b.las", {}).file_warnings
    assert "times.coarse" in codes(file_warnings)


def warnings_of(tmp_path: Path, xyz: np.ndarray, crs: str = "", scale: float = 1e-4) -> list[str]:
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, scale), np.floor(xyz.min(axis=0))
    if crs:
        header.add_crs(CRS(crs))
    las = laspy.LasData(header)
    las.x, las.y, las.z = xyz.T
    las.gps_time = np.linspace(400_000, 400_001, len(xyz))
    las.write(tmp_path / "a.las")
    return codes(FORMATS["las"].preview(tmp_path / "a.las", {}).file_warnings)


def test_warnings_about_place_and_unit(tmp_path: Path) -> None:
    near = np.random.default_rng(0).normal(0, 10, (500, 3))
    assert warnings_of(tmp_path, near) == []
    assert warnings_of(tmp_path, near + [350_000, 5e6, 0], "EPSG:32619") == []
    assert warnings_of(tmp_path, near + [350_000, 5e6, 0]) == ["points.no_system"]
    assert warnings_of(tmp_path, near * 60) == ["points.far_from_origin"]  # millimetres or feet
    assert "points.around_origin" in warnings_of(tmp_path, near * 1000)
    assert "points.away_from_origin" in warnings_of(tmp_path, near + [600, 100, 0])
    assert "points.resolution_in_feet" in warnings_of(tmp_path, near, scale=0.0003048)
    assert "points.coarse_coordinates" in warnings_of(tmp_path, near, scale=0.01)
    assert "points.degrees" in warnings_of(tmp_path, near * [1e-5, 1e-5, 1] + [7, 50, 0])


def test_unknown_coordinate_systems_are_reported(tmp_path: Path) -> None:
    near = np.random.default_rng(0).normal(0, 10, (500, 3)) + [350_000, 5e6, 0]
    warnings_of(tmp_path, near)
    las = FORMATS["las"]
    found = las.preview(tmp_path / "a.las", {})
    assert found.choice["frame"] == "georeferenced"
    with pytest.raises(InputError, check=has_code("crs.none_given")):
        crs_of_options(las.complete_options(found.choice))
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.vlrs.append(laspy.vlrs.known.WktCoordinateSystemVlr("PROJCS[damaged"))
    data = laspy.LasData(header)
    data.x, data.y, data.z = near.T
    data.gps_time = np.linspace(0, 1, len(near))
    data.write(tmp_path / "b.las")
    file_warnings = las.preview(tmp_path / "b.las", {}).file_warnings
    assert "las.unknown_wkt" in codes(file_warnings)


def test_laz_with_a_wrong_number_of_chunks_is_refused(
    tmp_path: Path, made: dict[str, Path]
) -> None:
    """Without the check, the library aborts the process when it allocates them."""
    data = bytearray(made["b.laz"].read_bytes())
    start = int.from_bytes(data[96:100], "little")
    table = int.from_bytes(data[start : start + 8], "little")
    data[table + 4 : table + 8] = b"\xff" * 4
    path = damaged(tmp_path, "b.laz", bytes(data))
    assert "las.header" in refusal_text(path, "b.laz")
    chunk_size = data.find(b"laszip encoded") - 2 + 54 + 12
    data = bytearray(made["b.laz"].read_bytes())
    data[chunk_size : chunk_size + 4] = b"\xff\xff\xff\x7f"
    path = damaged(tmp_path, "b.laz", bytes(data))
    assert "las.header" in refusal_text(path, "b.laz")


def test_ply_lists_utf16_text_and_empty_fields_are_refused(
    tmp_path: Path, made: dict[str, Path]
) -> None:
    data = made["a.ply"].read_bytes().replace(b"property double z", b"property list uchar int z")
    assert "ply.property_type" in refusal_text(damaged(tmp_path, "a.ply", data), "a.ply")
    text = damaged(tmp_path, "a.csv", made["a.csv"].read_text().encode("utf-16"))
    assert "save it as UTF-8" in refusal_text(text, "a.csv")
    gap = made["a.csv"].read_text().splitlines()
    gap[5] = re.sub(r",[^,]*,", ",,", gap[5], count=1)
    text = damaged(tmp_path, "a.csv", "\n".join(gap).encode())
    assert 'row 6: x is ""' in refusal_text(text, "a.csv")


@pytest.mark.parametrize("name", ["a.las", "a.laz", "a.ply"])
def test_a_file_cut_while_it_is_read_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    """The file is cut after the first chunk, for example by a lost drive."""
    xyz = np.random.default_rng(0).normal(0, 10, (200_000, 3))
    time = np.linspace(400_000, 400_100, len(xyz))
    path = tmp_path / name
    if name == "a.ply":
        head = "ply\nformat binary_little_endian 1.0\nelement vertex 200000\n" + "".join(
            f"property double {field}\n" for field in ("x", "y", "z", "time")
        )
        rows = np.column_stack([xyz, time]).astype("<f8")
        path.write_bytes(head.encode() + b"end_header\n" + rows.tobytes())
    else:
        header = laspy.LasHeader(point_format=6, version="1.4")
        header.scales = np.full(3, 1e-4)
        las = laspy.LasData(header)
        las.x, las.y, las.z = xyz.T
        las.gps_time = time
        las.write(path)
    for module in ("points.ply", "las.las_chunks"):
        monkeypatch.setattr(f"lispac.io.{module}.POINTS_PER_CHUNK", 10_000)
    chunks = FORMATS[files.VALID_FILES[name][0]].read(path, {})
    next(chunks)
    os.truncate(path, path.stat().st_size // 3)
    with pytest.raises(InputError) as refused:
        list(chunks)
    codes = {"file.points_missing", "las.header", "file.damaged"}
    assert refused.value.code in codes


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps files from being removed while open")
def test_a_file_removed_while_it_is_read_is_read_to_its_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, made: dict[str, Path]
) -> None:
    """An open file keeps its content; the next reading reports that it is missing."""
    monkeypatch.setattr("lispac.io.points.ply.POINTS_PER_CHUNK", 10)
    path = damaged(tmp_path, "a.ply", made["a.ply"].read_bytes())
    chunks = FORMATS["ply"].read(path, {})
    first_count = len(next(chunks).time)
    path.unlink()
    assert first_count + sum(len(chunk.time) for chunk in chunks) == files.COUNT
    assert "file.not_found" in refusal_text(path, "a.ply")


@settings(max_examples=100, deadline=None, suppress_health_check=list(HealthCheck))
@given(data=st.binary(max_size=3000))
def test_recognition_of_formats_accepts_any_bytes(
    tmp_path_factory: pytest.TempPathFactory, data: bytes
) -> None:
    path = tmp_path_factory.getbasetemp() / "any.bin"
    path.write_bytes(data)
    for format_ in POINT_FORMATS:
        assert 0 <= format_.sniff(path) <= 1
