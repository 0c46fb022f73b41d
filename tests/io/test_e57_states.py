"""Tests of E57 points with states of Cartesian and spherical coordinates (ASTM E2807)."""

from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.formats import format_of
from lispac.io.points import e57
from lispac.messages import Level
from tests.support import point_files as files

E57 = format_of("e57")
POINT_COUNT = files.COUNT
VALID, INVALID = np.zeros(POINT_COUNT, dtype=int), np.full(POINT_COUNT, 2)
SECOND_HALF = np.arange(POINT_COUNT) >= POINT_COUNT // 2
CARTESIAN = {f"cartesian{axis}": files.XYZ[:, k] for k, axis in enumerate("XYZ")}
DISTANCE = np.linalg.norm(files.XYZ, axis=1)
SPHERICAL = {
    "sphericalRange": DISTANCE,
    "sphericalAzimuth": np.arctan2(files.XYZ[:, 1], files.XYZ[:, 0]),
    "sphericalElevation": np.arcsin(files.XYZ[:, 2] / DISTANCE),
}
EMPTY = {name: np.zeros(POINT_COUNT) for name in SPHERICAL}


def file(folder: Path, **fields: np.ndarray) -> Path:
    """Write a file with these fields in addition to Cartesian coordinates and times."""
    return files.e57(folder / "a.e57", more=fields)


def read(path: Path) -> tuple[np.ndarray, np.ndarray]:
    chunks = list(E57.read(path, {"time_from": "zero"}))
    return np.concatenate([c.xyz for c in chunks]), np.concatenate([c.time for c in chunks])


def excluded(path: Path) -> int:
    """Number of points that the messages count as invalid."""
    found = E57.preview(path, {}).messages
    assert all((m.code, m.level) == ("file.invalid_points", Level.NOTE) for m in found)
    assert all(m.params["total"] == POINT_COUNT for m in found)
    return sum(int(str(m.params["count"])) for m in found)


@pytest.mark.parametrize("spherical", [EMPTY, SPHERICAL])
def test_invalid_spherical_coordinates_do_not_exclude_cartesian_ones(
    tmp_path: Path, spherical: dict[str, np.ndarray]
) -> None:
    path = file(tmp_path, **spherical, sphericalInvalidState=INVALID)
    np.testing.assert_array_equal(read(path)[0], files.XYZ)
    assert excluded(path) == 0


def test_spherical_coordinates_are_used_where_cartesian_ones_are_invalid(tmp_path: Path) -> None:
    state = np.where(SECOND_HALF, 2, 0)
    wrong = np.where(SECOND_HALF[:, None], 1e6, files.XYZ)
    path = files.e57(
        tmp_path / "a.e57",
        without=tuple(CARTESIAN),
        more={f"cartesian{axis}": wrong[:, k] for k, axis in enumerate("XYZ")}
        | SPHERICAL
        | {"cartesianInvalidState": state, "sphericalInvalidState": VALID},
    )
    np.testing.assert_allclose(read(path)[0], files.XYZ, atol=1e-9)
    assert excluded(path) == 0


def test_points_without_valid_coordinates_are_excluded_and_counted(tmp_path: Path) -> None:
    """A direction without distance (state 1) is not a valid point either."""
    state = np.where(SECOND_HALF, 2, 0)
    direction = np.where(SECOND_HALF, 1, 0)
    path = file(tmp_path, **SPHERICAL, cartesianInvalidState=state, sphericalInvalidState=direction)
    xyz, time = read(path)
    np.testing.assert_array_equal(xyz, files.XYZ[~SECOND_HALF])
    assert len(time) == POINT_COUNT // 2
    assert excluded(path) == POINT_COUNT // 2
    np.testing.assert_array_equal(
        np.concatenate(list(e57.read_coordinates(path))), files.XYZ[~SECOND_HALF]
    )


def test_empty_spherical_columns_without_state_are_not_used(tmp_path: Path) -> None:
    path = file(tmp_path, **EMPTY, cartesianInvalidState=np.where(SECOND_HALF, 2, 0))
    np.testing.assert_array_equal(read(path)[0], files.XYZ[~SECOND_HALF])
    assert excluded(path) == POINT_COUNT // 2


def test_spherical_coordinates_alone_have_their_own_state(tmp_path: Path) -> None:
    path = files.e57(
        tmp_path / "a.e57",
        without=tuple(CARTESIAN),
        more=SPHERICAL
        | {"sphericalInvalidState": np.where(SECOND_HALF, 2, 0), "cartesianInvalidState": INVALID},
    )
    np.testing.assert_allclose(read(path)[0], files.XYZ[~SECOND_HALF], atol=1e-9)
    assert excluded(path) == POINT_COUNT // 2


def test_an_invalid_time_excludes_a_point_of_a_line_but_not_of_a_reference(tmp_path: Path) -> None:
    path = file(tmp_path, isTimeStampInvalid=np.where(SECOND_HALF, 1, 0))
    assert len(read(path)[0]) == excluded(path) == POINT_COUNT // 2
    assert sum(map(len, e57.read_coordinates(path))) == POINT_COUNT


def test_a_file_without_valid_points_is_refused(tmp_path: Path) -> None:
    path = file(tmp_path, **EMPTY, cartesianInvalidState=INVALID, sphericalInvalidState=INVALID)
    with pytest.raises(InputError):
        E57.preview(path, {})
