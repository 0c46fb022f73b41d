"""Tests of reading PTS files of CloudCompare, Open3D and other writers, and of refusals."""

import os
import subprocess
from pathlib import Path

import numpy as np
import open3d as o3d
import pytest

from lispac.errors import InputError
from lispac.io.points.static_scan import open_static_scan
from lispac.io.text import pts
from lispac.workflow.importing.file_reading import check_file
from tests.support.error_codes import has_code
from tests.support.point_files import RING, XYZ
from tests.support.static_scans import write_pts


def places(path: Path) -> np.ndarray:
    return np.concatenate(list(open_static_scan(path).coordinate_chunks(local=True)))


def test_pts_of_cloudcompare_is_read(cloudcompare: str, tmp_path: Path) -> None:
    """The file has intensity, colour and a comment with the names of columns."""
    rows = np.column_stack([XYZ, RING, RING, RING, RING])
    np.savetxt(tmp_path / "scan.asc", rows, fmt="%.9g")
    subprocess.run(
        [cloudcompare, "-SILENT", "-AUTO_SAVE", "OFF", "-C_EXPORT_FMT", "ASC", "-PREC", "9",
         "-ADD_HEADER", "-ADD_PTS_COUNT", "-EXT", "pts", "-O", "scan.asc",
         "-SAVE_CLOUDS", "FILE", "scan.pts"],
        cwd=tmp_path,
        env=os.environ | {"QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": str(tmp_path)},
        check=True,
        capture_output=True,
        timeout=60,
    )  # fmt: skip
    head = (tmp_path / "scan.pts").read_text().splitlines()[:3]
    assert str(len(XYZ)) in head
    assert len(head[-1].split()) == 7
    # CloudCompare stores coordinates in single precision.
    np.testing.assert_allclose(places(tmp_path / "scan.pts"), XYZ, atol=2e-6)


def test_pts_of_open3d_is_read(tmp_path: Path) -> None:
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(XYZ))
    assert o3d.io.write_point_cloud(str(tmp_path / "scan.pts"), cloud)
    np.testing.assert_allclose(places(tmp_path / "scan.pts"), XYZ, atol=1e-9)


@pytest.mark.parametrize("more", [0, 1, 4])
def test_points_agree_with_the_reader_of_vtk(tmp_path: Path, more: int) -> None:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkPTSReader

    path = write_pts(tmp_path / "scan.pts", [XYZ], more=more)
    reader = vtkPTSReader()
    reader.SetFileName(str(path))
    reader.Update()
    theirs = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
    assert len(theirs) >= len(XYZ) - 2  # VTK 9 skips the first two points
    np.testing.assert_allclose(places(path)[-len(theirs) :], theirs, atol=2e-6)
    np.testing.assert_allclose(places(path), XYZ, atol=1e-9)


def test_blocks_of_any_size_are_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pts, "POINTS_PER_CHUNK", 7)
    path = write_pts(tmp_path / "SCAN.PTS", [XYZ[:14], XYZ[:0], XYZ[14:15], XYZ[15:]])
    chunks = list(open_static_scan(path).coordinate_chunks(local=True))
    assert max(map(len, chunks)) == 7
    np.testing.assert_allclose(np.concatenate(chunks), XYZ, atol=1e-9)


def test_blanks_tabs_empty_rows_and_windows_line_ends_are_read(tmp_path: Path) -> None:
    path = tmp_path / "scan.pts"
    path.write_bytes(b"2   \r\n  1.5\t-2 3e1 -2048 \r\n\r\n4 5 6 2047\r\n1\r\n7 8 9\r\n\r\n")
    np.testing.assert_array_equal(places(path), [[1.5, -2, 30], [4, 5, 6], [7, 8, 9]])


def test_pts_without_a_point_count_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """All rows are points, as meshing programs and scripts write them."""
    monkeypatch.setattr(pts, "POINTS_PER_CHUNK", 7)
    path = write_pts(tmp_path / "scan.pts", [XYZ], more=4)
    count, rows = path.read_text().split("\n", 1)
    assert count == str(len(XYZ))
    path.write_text(rows)
    np.testing.assert_allclose(places(path), XYZ, atol=1e-9)


def test_pts_as_a_line_is_refused_without_times(tmp_path: Path) -> None:
    path = write_pts(tmp_path / "scan.pts", [XYZ], more=4)
    with pytest.raises(InputError) as raised:
        check_file(path)
    assert raised.value.code == "import.points_without_time"


@pytest.mark.parametrize(
    ("text", "code", "params"),
    [
        ("", "file.empty", {}),
        ("\n \n", "static_scan.no_points", {}),
        ("0\n", "static_scan.no_points", {}),
        ("2\n1 2 3\n4 y 6\n", "text.unusable_value", {"row": 3, "column": "y", "value": "y"}),
        ("2\n1 2 3\n4 5 nan\n", "static_scan.unusable_coordinate", {"point": 2}),
        ("2\n1 2 3\n4 1e300 6\n", "static_scan.unusable_coordinate", {"point": 2}),
        ("\0\1\2\3", "text.not_text", {"row": 1}),
    ],
)
def test_files_without_valid_points_are_refused(
    tmp_path: Path, text: str, code: str, params: dict[str, object]
) -> None:
    path = tmp_path / "scan.pts"
    path.write_text(text)
    with pytest.raises(InputError, check=has_code(code, **params)) as refused:
        places(path)
    sentence = str(refused.value)
    assert sentence.startswith(str(path))
    assert sentence.endswith(".")


@pytest.mark.parametrize(
    ("text", "code", "params"),
    [
        ("2\n1 2 3\n", "pts.points_missing", {"held": 1, "points": 2, "head": 1}),
        ("1\n1 2 3\n9\n", "pts.points_missing", {"held": 0, "points": 9, "head": 3}),
        ("2\n1 2 3 4\n1 2 3", "pts.columns", {"row": 3, "count": 3, "width": 4}),
        ("1\n1 2\n", "pts.columns", {"row": 2, "count": 2, "width": 3}),
        ("1\n1 2 3\n4 5 6\n", "pts.count_expected", {"row": 3, "points": 1, "head": 1}),
        (
            "3\n1 2 3\n1\n4 5 6\n", "pts.early_count",
            {"row": 3, "held": 1, "points": 3, "head": 1},
        ),
        ("1 2 3\n4 5\n", "pts.columns", {"row": 2, "count": 2, "width": 3}),
        ("1 2 3\n4 5 6\n1\n7 8 9\n", "pts.columns", {"row": 3, "count": 1, "width": 3}),
        ("1 2 3\n4,5 5 6\n", "pts.separators", {"row": 2}),
        ("1 2\n", "pts.no_count", {"row": 1, "text": "1 2"}),
        ("1,000\n", "pts.no_count", {"row": 1, "text": "1,000"}),
        ("-1\n", "pts.no_count", {"row": 1, "text": "-1"}),
        ("9" * 5000 + "\n", "pts.no_count", {"row": 1, "text": "9" * 40}),
        ("2\n1 2 3\n1,5 2,5 3,5\n", "pts.separators", {"row": 3}),
        ("//X;Y;Z\n1\n1.5;2.5;3.5\n", "pts.separators", {"row": 3}),
    ],
)  # fmt: skip
def test_invalid_blocks_are_refused(
    tmp_path: Path, text: str, code: str, params: dict[str, object]
) -> None:
    path = tmp_path / "scan.pts"
    path.write_text(text)
    with pytest.raises(InputError) as refused:
        places(path)
    assert refused.value.code == code
    assert refused.value.message is not None
    assert refused.value.message.params == {"file": str(path), **params}


def test_a_file_cut_within_a_block_is_refused(tmp_path: Path) -> None:
    """A cut within the last number would give another valid number and is not detected."""
    path = write_pts(tmp_path / "scan.pts", [XYZ[:5]])
    whole = path.read_bytes()
    for size in range(whole.index(b"\n"), whole.rstrip().rindex(b" ")):
        path.write_bytes(whole[:size])
        with pytest.raises(InputError):
            places(path)
