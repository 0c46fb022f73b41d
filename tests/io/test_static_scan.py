"""Tests of clouds without times, as written by other libraries."""

from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.points.static_scan import open_static_scan
from tests.support import point_files
from tests.support.error_codes import has_code
from tests.support.point_files import XYZ


def places(path: Path, *, local: bool = True) -> np.ndarray:
    return np.concatenate(list(open_static_scan(path).coordinate_chunks(local=local)))


def test_e57_without_time_has_its_poses_applied(tmp_path: Path) -> None:
    pytest.importorskip("pye57")
    half = np.sqrt(0.5)  # a quarter turn about z: x becomes y
    path = point_files.e57(
        tmp_path / "scan.e57", timed=False, quaternion=(half, 0, 0, half), translation=(100, 200, 3)
    )
    turned = np.column_stack([-XYZ[:, 1], XYZ[:, 0], XYZ[:, 2]]) + (100, 200, 3)
    np.testing.assert_allclose(places(path), turned, atol=1e-9)


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
def test_las_without_time_is_read(tmp_path: Path, name: str) -> None:
    header = laspy.LasHeader(version="1.2", point_format=2)
    header.scales = np.full(3, 1e-4)
    las = laspy.LasData(header)
    las.xyz = XYZ
    las.write(tmp_path / name)
    np.testing.assert_allclose(places(tmp_path / name), XYZ, atol=1e-4)


@pytest.mark.parametrize(
    ("head", "order", "separator"),
    [
        ("", "xyz", " "),
        ("x y z", "xyz", " "),
        ("up;north;west", "zxy", ";"),
        ("# made by a tripod\n", "xyz", ","),
        ("intensity,x,y,z", "ixyz", ","),
    ],
)
def test_texts_without_time_are_read(tmp_path: Path, head: str, order: str, separator: str) -> None:
    columns = {"x": XYZ[:, 0], "y": XYZ[:, 1], "z": XYZ[:, 2], "i": np.arange(len(XYZ))}
    rows = np.column_stack([columns[name] for name in order])
    path = tmp_path / "scan.txt"
    text = [separator.join(f"{value:.4f}" for value in row) for row in rows]
    path.write_text("\n".join([*([head] if head else []), *text]))
    np.testing.assert_allclose(places(path), XYZ, atol=1e-9)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "file.empty"),
        ("# nothing\n", "static_scan.no_coordinates"),
        ("1 2\n3 4\n", "static_scan.too_few_coordinates"),
        ("1,5 2,5 3,5\n2,5 3,5 4,5\n", "static_scan.decimal_commas"),
        ("1 2 3\n4 5\n", "file.damaged"),
        ("1 2 3\n4 5 inf\n", "static_scan.unusable_coordinate"),
    ],
)
def test_unsuitable_texts_are_refused(tmp_path: Path, text: str, code: str) -> None:
    path = tmp_path / "scan.txt"
    path.write_text(text)
    with pytest.raises(InputError, check=has_code(code)):
        places(path)
