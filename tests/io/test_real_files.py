"""Tests of point files written by other programs, from the test suite of laspy."""

import struct
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.format_types import SURE, FilePreview, PointChunk
from lispac.io.formats import format_of, recognise_formats
from tests.support.error_codes import has_code
from tests.support.message_codes import codes

FOLDER = Path(__file__).parents[1] / "data" / "laspy"
LAS, PLY = format_of("las"), format_of("ply")
POINTS = {
    "autzen.las": 106, "simple.copc.laz": 1065, "simple.laz": 1065, "simple1_3.las": 999,
    "test1_4.las": 1000,
}  # fmt: skip


def read(name: str) -> tuple[FilePreview, PointChunk]:
    found = LAS.preview(FOLDER / name, {})
    (chunk,) = LAS.read(FOLDER / name, found.choice)  # type: ignore[misc]
    return found, chunk


@pytest.mark.parametrize("name", POINTS)
def test_file_is_recognised_and_read_completely(name: str) -> None:
    assert recognise_formats(FOLDER / name, "points")[0] == (LAS, SURE)
    found, chunk = read(name)
    assert found.choice["frame"] == "georeferenced"
    assert len(chunk.time) == chunk.total == POINTS[name]
    assert np.isfinite(chunk.xyz).all()
    assert len(np.unique(chunk.time)) > 10
    assert {len(values) for values in chunk.extra.values()} == {POINTS[name]}


def test_every_file_in_the_folder_is_tested() -> None:
    assert {path.name for path in FOLDER.glob("*.la[sz]")} == set(POINTS)


def test_the_first_point_equals_the_published_values() -> None:
    """The expected values are printed in the documentation of libLAS and PDAL."""
    _, chunk = read("simple.laz")
    np.testing.assert_allclose(chunk.xyz[0], (637_012.24, 849_028.31, 431.66), atol=1e-6)
    assert chunk.time[0] == pytest.approx(245_380.78254962614, abs=1e-9)


@pytest.mark.parametrize("name", ["autzen.las", "simple1_3.las", "test1_4.las"])
def test_coordinates_and_times_equal_the_values_in_the_file(name: str) -> None:
    """The records are decoded here with struct, by the LAS specification."""
    content = (FOLDER / name).read_bytes()
    (start,) = struct.unpack_from("<I", content, 96)
    point_format, length = struct.unpack_from("<BH", content, 104)
    scale, offset = struct.unpack_from("<3d", content, 131), struct.unpack_from("<3d", content, 155)
    _, chunk = read(name)
    for k in (0, 50, POINTS[name] - 1):
        at = start + k * length
        steps = struct.unpack_from("<3i", content, at)
        place = [s * n + o for s, n, o in zip(scale, steps, offset, strict=True)]
        np.testing.assert_allclose(chunk.xyz[k], place, rtol=1e-15)
        (time,) = struct.unpack_from("<d", content, at + (20 if point_format < 6 else 22))
        assert chunk.time[k] == time
        (intensity,) = struct.unpack_from("<H", content, at + 12)
        assert chunk.extra["intensity"][k] == intensity


def test_copc_file_has_the_points_of_the_laz_file() -> None:
    """The COPC file is in another projection, so attributes and times are compared."""
    plain, copc = read("simple.laz")[1], read("simple.copc.laz")[1]
    for name in ("intensity", "return_number"):
        np.testing.assert_array_equal(np.sort(plain.extra[name]), np.sort(copc.extra[name]))
    np.testing.assert_array_equal(np.sort(plain.time), np.sort(copc.time))


def test_coordinate_systems_and_waveforms_are_reported() -> None:
    assert read("autzen.las")[0].choice["crs"] == "EPSG:2994"
    assert "New Mexico Central (ftUS)" in read("test1_4.las")[0].facts["coordinate system"]
    assert "Oregon LCC" in read("simple.copc.laz")[0].facts["coordinate system"]
    waves = read("simple1_3.las")[0]
    assert "assumed.waveforms" in codes(waves.assumptions)
    assert {"las.system_without_code", "las.system_not_named"} & set(codes(waves.file_warnings))


@pytest.mark.parametrize("name", ["airplane.ply", "ant.ply", "nut.ply", "sphere.ply"])
def test_meshes_without_times_are_refused(name: str) -> None:
    """The PLY examples of pyvista, written by modelling programs, have faces and no times."""
    path = Path(find_spec("pyvista").origin).parent / "examples" / name  # type: ignore[union-attr,arg-type]
    assert recognise_formats(path, "points")[0][0].key == "ply"
    for task in (PLY.preview, lambda path, choice: list(PLY.read(path, choice))):  # type: ignore[call-overload]
        with pytest.raises(InputError, check=has_code("file.no_time", file=str(path))):
            task(path, {})
