"""Tests that small files with large counts are refused before memory is allocated."""

import struct
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.io.las.las_header_check import require_sound_header
from lispac.io.points.mesh_file import MeshReader, read_mesh
from lispac.io.project.project_file import SIGHTINGS_FOLDER, read_project
from lispac.project import Project
from lispac.simulation.meshes import Mesh
from tests.simulation.test_meshes import write_mesh
from tests.support.long_runs import others_long

LAYER_COUNT = 9
"""Number of layers of point format 6."""


def compressed(path: Path, points: int) -> None:
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 0.001)
    las = laspy.LasData(header)
    for name in ("x", "y", "z", "gps_time"):
        las[name] = np.random.default_rng(1).uniform(0, 10, points)
    las.write(str(path))


def test_laz_layers_larger_than_the_file_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.laz"
    compressed(path, 200)
    assert require_sound_header(path).stored == 200
    content = bytearray(path.read_bytes())
    (start,) = struct.unpack_from("<I", content, 96)
    sizes = start + 8 + 30 + 4  # chunk table offset, first point and point count come before
    for layer in range(LAYER_COUNT):
        changed = bytearray(content)
        struct.pack_into("<I", changed, sizes + 4 * layer, 2**31)
        path.write_bytes(changed)
        with pytest.raises(InputError):
            require_sound_header(path)


def test_laz_chunks_larger_than_their_points_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.laz"
    compressed(path, 2000)
    content = bytearray(path.read_bytes())
    record = content.index(b"laszip encoded") - 2 + 54
    struct.pack_into("<I", content, record + 12, 1)
    path.write_bytes(content)
    with pytest.raises(InputError):
        require_sound_header(path)


@pytest.mark.parametrize("scale", [0.0, -1.0, 1e308, 1e-320, float("nan")])
def test_invalid_scale_factors_are_refused(tmp_path: Path, scale: float) -> None:
    path = tmp_path / "a.laz"
    compressed(path, 200)
    content = bytearray(path.read_bytes())
    struct.pack_into("<d", content, 131, scale)
    path.write_bytes(content)
    with pytest.raises(InputError) as refused:
        require_sound_header(path)
    assert refused.value.code == "las.scale"


@pytest.mark.parametrize(
    "count", others_long([b"2199023255552", b"9223372036854775807", b"300000000"])
)
def test_a_mesh_that_crashes_its_reader_is_refused(tmp_path: Path, count: bytes) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0]], dtype=float)
    good, bad = tmp_path / "good.ply", tmp_path / "bad.ply"
    write_mesh(good, Mesh("m", corners, np.array([[0, 1, 2]])))
    content = good.read_bytes()
    with MeshReader() as reader:
        bad.write_bytes(content.replace(b"element vertex 3", b"element vertex " + count))
        with pytest.raises(InputError):
            read_mesh(bad, "m", 0.4, reader=reader)
        assert len(read_mesh(good, "m", 0.4, reader=reader).triangles) == 1


def test_sightings_of_a_wrong_size_are_refused(copy: Project) -> None:
    path = next((copy.folder / SIGHTINGS_FOLDER).glob("*.npz"))
    with np.load(path) as arrays:
        found = dict(arrays)
    name = sorted(found)[0]
    np.savez_compressed(path, **(found | {name: np.zeros(3_000_000, np.int64)}))
    assert path.stat().st_size < 10_000_000
    with pytest.raises(ProjectError):
        read_project(copy.folder)
    np.savez_compressed(path, **(found | {name: found[name][:-1]}))
    with pytest.raises(ProjectError):
        read_project(copy.folder)
