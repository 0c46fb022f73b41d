"""Tests of meshes in a simulated scene: ranges, occlusion, and reading of mesh files."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.points.mesh_file import MeshReader, read_mesh
from lispac.messages import error
from lispac.simulation.meshes import Mesh, MeshCaster
from lispac.simulation.scene import Rectangle, Scene, Sphere, tilted_rectangle
from tests.support.long_runs import LONG

DISTANT_PLACE = np.array([4_000.0, -7_000.0, 60.0])
"""A place where single precision has steps of 0.5 mm."""


@pytest.fixture(scope="module")
def reader() -> Iterator[MeshReader]:
    """Reader of meshes whose process serves all tests; starting one takes seconds."""
    with MeshReader() as started:
        yield started


def as_mesh(rectangle: Rectangle, pieces: int = 6) -> Mesh:
    """Return a rectangle as triangles."""
    along = np.cross(rectangle.normal, rectangle.across)
    u, v = (
        np.linspace(-side / 2, side / 2, pieces + 1) for side in (rectangle.width, rectangle.height)
    )
    grid = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1).reshape(-1, 2)
    vertices = rectangle.centre + grid[:, :1] * rectangle.across + grid[:, 1:] * along
    first = np.add.outer(np.arange(pieces) * (pieces + 1), np.arange(pieces)).ravel()
    right, up, both = first + pieces + 1, first + 1, first + pieces + 2
    triangles = np.concatenate([np.stack([first, right, both], 1), np.stack([first, both, up], 1)])
    return Mesh(rectangle.name, vertices, triangles, rectangle.reflectance)


def write_mesh(path: Path, mesh: Mesh) -> None:
    """Write a mesh with Open3D."""
    import open3d

    written = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(mesh.vertices),
        open3d.utility.Vector3iVector(mesh.triangles.astype(np.int32)),
    )
    written.compute_triangle_normals()
    open3d.io.write_triangle_mesh(str(path), written)


def rays(target: np.ndarray, count: int, seed: int = 5) -> tuple[np.ndarray, np.ndarray]:
    """Return rays from 15 to 80 m away to the neighbourhood of a point."""
    generator = np.random.default_rng(seed)
    away = generator.standard_normal((count, 3))
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    origins = target + away * generator.uniform(15, 80, (count, 1))
    directions = target + generator.uniform(-1.5, 1.5, (count, 3)) - origins
    return origins, directions / np.linalg.norm(directions, axis=1, keepdims=True)


@pytest.mark.parametrize("middle", [np.zeros(3), DISTANT_PLACE], ids=["near", "far"])
def test_ranges_to_a_mesh_equal_those_to_its_rectangle(middle: np.ndarray) -> None:
    board = tilted_rectangle("board", tuple(middle), 2.0, 2.0, 70, 30)
    origins, directions = rays(middle, 40_000)
    exact, label, cosine = Scene.of([board]).intersect(origins, directions)
    ranges, mesh_label, mesh_cosine = Scene.of([as_mesh(board)]).intersect(origins, directions)
    both = (label == 0) & (mesh_label == 0)
    # Single precision only decides at the edge, where few rays fall
    assert np.count_nonzero(label != mesh_label) < 5
    assert np.count_nonzero(both) > 5_000
    # At grazing incidence rounding of the vertices changes the range by 1e-12 m over the cosine
    error = np.abs(ranges[both] - exact[both])
    assert (error * cosine[both]).max() < 1e-11
    assert error[cosine[both] > 0.05].max() < 1e-9
    np.testing.assert_allclose(mesh_cosine[both], cosine[both], atol=1e-9)


def test_ranges_of_open3d_alone_are_less_accurate() -> None:
    """The ranges of Open3D have errors above the 1e-6 m that are required."""
    board = tilted_rectangle("board", (0.0, 60.0, 5.0), 2.0, 2.0, 90, 30)
    origins, directions = rays(board.centre, 40_000)
    exact, label, cosine = Scene.of([board]).intersect(origins, directions)
    caster = MeshCaster.of([as_mesh(board)])
    single = caster.scene.cast_rays(
        np.hstack([origins - caster.middle, directions]).astype(np.float32)
    )["t_hit"].numpy()
    good = (label == 0) & np.isfinite(single) & (cosine > 0.2)
    assert 1e-6 < np.abs(single[good] - exact[good]).max() < 1e-4


def test_the_nearest_surface_is_hit() -> None:
    near, far = (
        tilted_rectangle(name, (0.0, west, 0.0), 4.0, 4.0, 90, 0)
        for name, west in (("a", 5), ("b", 9))
    )
    origins, directions = np.zeros((3, 3)), np.array([[0, 1, 0], [0.2, 1, 0], [0, -1, 0]], float)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    ball = Sphere("ball", np.array([0.0, 7.0, 0.0]), 0.5)
    for surfaces, names in (
        ([as_mesh(near), far, ball], ["a", "a", None]),
        ([near, as_mesh(far), ball], ["a", "a", None]),
        ([as_mesh(far), ball], ["ball", "b", None]),
        ([as_mesh(far), as_mesh(near)], ["a", "a", None]),
    ):  # fmt: skip
        scene = Scene.of(surfaces)
        ranges, labels, _ = scene.intersect(origins, directions)
        assert [scene.names[k] if k >= 0 else None for k in labels] == names
        assert np.isinf(ranges[2])
    assert Scene.of([as_mesh(far)]).intersect(origins, directions, 8.0)[1].max() == -1


def test_distance_to_a_mesh() -> None:
    board = tilted_rectangle("board", (1.0, 6.0, 2.0), 3.0, 2.0, 90, 20)
    points = board.centre + np.array([[0.3, 0, 0.1], [-0.5, 0.02, 0.2], [0, -0.04, 0]])
    np.testing.assert_allclose(
        np.abs(as_mesh(board).distance(points)), np.abs(board.distance(points)), atol=1e-9
    )


@pytest.mark.parametrize("ending", [".ply", ".obj", ".stl"])
def test_mesh_files(ending: str, reader: MeshReader, tmp_path: Path) -> None:
    board = as_mesh(tilted_rectangle("board", (1.0, 6.0, 2.0), 3.0, 2.0, 90, 20))
    path = tmp_path / f"board{ending}"
    write_mesh(path, board)
    mesh = read_mesh(path, "board", 0.5, reader=reader)
    corners, expected = mesh.vertices[mesh.triangles], board.vertices[board.triangles]
    np.testing.assert_allclose(corners, expected, atol=1e-5)
    assert (mesh.name, mesh.reflectance) == ("board", 0.5)


OBJ = """# a wall of one face, and a gable counted back from the last vertex
v -2 -15 6
v 2 -15 6
v 2 -17 9
v -2 -17 9
f 1//1 2//1 3//1 4//1
v 0 -17 11
f -2/7 -3/8 -1/9
"""


def area(mesh: Mesh) -> float:
    a, b, c = (mesh.vertices[column] for column in mesh.triangles.T)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


@LONG
def test_faces_with_more_than_three_corners_are_read(tmp_path: Path) -> None:
    """Areas computed by hand: 4 m by the root of 2**2 + 3**2, and half of 4 m by 2 m."""
    path = tmp_path / "house.obj"
    path.write_text(OBJ)
    assert area(read_mesh(path, "house", 0.5)) == pytest.approx(4 * np.sqrt(13) + 4, abs=1e-12)
    path = tmp_path / "wall.ply"
    path.write_text(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "-2 -15 6\n2 -15 6\n2 -17 9\n-2 -17 9\n4 0 1 2 3\n"
    )
    assert area(read_mesh(path, "wall", 0.5)) == pytest.approx(4 * np.sqrt(13), abs=1e-12)


@pytest.mark.parametrize(
    "wrong", ["v 1 2", "v 1 2 x", "f 1 2 9", "f 0 1 2", "f 1 2 -7", "f", "f 1 2"]
)
def test_an_invalid_obj_row_is_named(wrong: str, tmp_path: Path) -> None:
    path = tmp_path / "cut.obj"
    path.write_text(f"v 0 0 0\nv 1 0 0\nv 1 1 0\n{wrong}\n")
    with pytest.raises(InputError) as refused:
        read_mesh(path, "m", 0.4)
    code = "mesh.vertex" if wrong.startswith("v") else "mesh.face"
    assert refused.value.message == error(code, file=str(path), row=4, text=wrong)


def stl_text(mesh: Mesh) -> bytes:
    """Return a mesh as ASCII STL, which Open3D does not write."""
    corners = mesh.vertices[mesh.triangles]
    facets = "".join(
        "facet normal 0 0 1\nouter loop\n"
        + "".join(f"vertex {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in each)
        + "endloop\nendfacet\n"
        for each in corners
    )
    return f"solid board\n{facets}endsolid board\n".encode()


@pytest.mark.parametrize("kind", ["text.ply", "binary.ply", "text.stl", "binary.stl"])
def test_a_mesh_that_is_cut_short_is_refused(kind: str, reader: MeshReader, tmp_path: Path) -> None:
    """Open3D alone would return the faces before the cut."""
    mesh = as_mesh(tilted_rectangle("board", (3.0, 2.0, 1.0), 2.0, 1.0, 70, 30))
    path, cut = tmp_path / f"whole.{kind[-3:]}", tmp_path / f"cut.{kind[-3:]}"
    write_mesh(path, mesh)
    if kind == "text.stl":
        path.write_bytes(stl_text(mesh))
    elif kind == "text.ply":
        rows = [f"{x} {y} {z}" for x, y, z in mesh.vertices]
        rows += [f"3 {a} {b} {c}" for a, b, c in mesh.triangles]
        path.write_text(
            f"ply\nformat ascii 1.0\nelement vertex {len(mesh.vertices)}\nproperty double x\n"
            f"property double y\nproperty double z\nelement face {len(mesh.triangles)}\n"
            "property list uchar int vertex_indices\nend_header\n" + "\n".join(rows) + "\n"
        )
    whole = path.read_bytes()
    codes = {"mesh.faces_missing", "mesh.no_end", "mesh.damaged", "mesh.no_triangles"}
    found = read_mesh(path, "m", 0.5, reader=reader)
    assert len(found.triangles) == len(mesh.triangles)
    for bytes_cut in (15, 40, 75, 300):
        cut.write_bytes(whole[:-bytes_cut])
        with pytest.raises(InputError) as refused:
            read_mesh(cut, "m", 0.5, reader=reader)
        assert refused.value.code in codes


@LONG
def test_files_without_a_valid_mesh_are_refused(reader: MeshReader, tmp_path: Path) -> None:
    def of_triangle(first: str, last: str) -> Path:
        path = tmp_path / f"{first}.obj"
        path.write_text(f"v {first}\nv 1 0 0\nv {last}\nf 1 2 3\n")
        return path

    cloud = tmp_path / "cloud.ply"
    cloud.write_text(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n0 0 0\n"
    )
    other = tmp_path / "scene.dae"
    other.write_text("x")
    for path, code in (
        (cloud, "mesh.no_triangles"), (other, "mesh.format"),
        (tmp_path / "none.stl", "file.not_found"),
        (of_triangle("nan 0 0", "1 1 0"), "mesh.not_finite"),
        (of_triangle("1e160 0 0", "1 1 0"), "mesh.too_far"),
        (of_triangle("0 0 0", "2 0 0"), "mesh.no_area"),
    ):  # fmt: skip
        with pytest.raises(InputError) as refused:
            read_mesh(path, "m", 0.4, reader=reader)
        assert refused.value.code == code
