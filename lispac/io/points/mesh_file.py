"""Reading of meshes of a scene from PLY, OBJ or STL; the format is detected from the content.

OBJ is read here because Open3D silently omits its faces with more than three corners.
"""

import os
import re
import sys
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import nullcontext
from itertools import pairwise
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.files import library_path, require_file
from lispac.messages import error
from lispac.simulation.meshes import Mesh
from lispac.survey.point_screening import MAX_COORDINATE as LARGEST_COORDINATE

Array = NDArray[np.float64]

ENDINGS = (".ply", ".obj", ".stl")
HEAD_BYTES = 65_536
BASE_MEMORY_BYTES = 1 << 29
MEMORY_PER_FILE_BYTE = 60
"""Bytes of memory allowed to read a mesh: `BASE_MEMORY_BYTES`, and `MEMORY_PER_FILE_BYTE` for each
byte of the file. ASCII STL needs about one byte of memory for each byte of the file, binary PLY
about ten."""


class MeshReader:
    """Open3D's mesh reader in a separate process, because a damaged file may terminate it.

    Context manager that uses one process for several files and restarts it if it was terminated.
    """

    def __init__(self) -> None:
        self._pool: ProcessPoolExecutor | None = None

    def __enter__(self) -> "MeshReader":
        return self

    def __exit__(self, *_: object) -> None:
        if self._pool is not None:
            self._pool.shutdown()
        self._pool = None

    def read(self, path: Path, ending: str) -> tuple[Array, NDArray[np.int64]]:
        """Read the vertices (n, 3) and triangles (m, 3) of a file.

        Raises
        ------
        InputError
            If the process is terminated or runs out of memory.
        """
        if self._pool is None:
            self._pool = ProcessPoolExecutor(1, get_context("spawn"))
        with library_path(path, ending) as name:
            try:
                return self._pool.submit(_read_in_process, str(name)).result()
            except (BrokenProcessPool, MemoryError, RuntimeError) as failure:
                self.__exit__()
                raise InputError(error("mesh.damaged", file=str(path))) from failure


def read_mesh(
    path: Path, name: str, reflectance: float, *, reader: MeshReader | None = None
) -> Mesh:
    """Read a mesh in local coordinates: north, west, up in metres.

    Faces with more corners are split into triangles, those of OBJ from their first corner.
    Triangles without area are excluded.

    Raises
    ------
    InputError
        If the file is missing, of another kind, without triangles, cut short, or damaged.
    """
    path = require_file(Path(path), "mesh")
    ending = _mesh_ending(path)
    if ending == ".obj":
        vertices, triangles = _read_obj(path)
    else:
        with nullcontext(reader) if reader is not None else MeshReader() as used:
            vertices, triangles = used.read(path, ending)
        _require_complete(path, ending, len(triangles))
    if not len(triangles):
        raise InputError(error("mesh.no_triangles", file=str(path)))
    if triangles.min() < 0 or triangles.max() >= len(vertices):
        raise InputError(error("mesh.missing_vertex", file=str(path)))
    if not np.isfinite(vertices).all():
        raise InputError(error("mesh.not_finite", file=str(path)))
    if np.abs(vertices).max() > LARGEST_COORDINATE:
        raise InputError(error("mesh.too_far", file=str(path), limit=LARGEST_COORDINATE))
    a, b, c = (vertices[column] for column in triangles.T)
    has_area = np.linalg.norm(np.cross(b - a, c - a), axis=1) > 0
    if not has_area.any():
        raise InputError(error("mesh.no_area", file=str(path)))
    return Mesh(name, vertices, triangles[has_area], reflectance)


def _mesh_ending(path: Path) -> str:
    """File name extension of the format of a mesh, from its first bytes, else from its name.

    Raises
    ------
    InputError
        If the format is not known.
    """
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    if head[:4] in (b"ply\n", b"ply\r"):
        return ".ply"
    triangles = int.from_bytes(head[80:84], "little")
    text = head.lstrip().startswith(b"solid") and b"facet" in head
    if text or (len(head) >= 84 and path.stat().st_size == 84 + 50 * triangles):
        return ".stl"
    if re.search(rb"^v\s+[-+.\d]", head, re.MULTILINE) and b"\0" not in head:
        return ".obj"
    if path.suffix.lower() not in ENDINGS:
        raise InputError(error("mesh.format", file=str(path)))
    return path.suffix.lower()


def _require_complete(path: Path, ending: str, triangles: int) -> None:
    """Refuse a truncated file, of which Open3D would read the remaining faces without an error.

    Raises
    ------
    InputError
        If a PLY file gives fewer triangles than faces, or an ASCII STL file lacks its end.
    """
    content = path.read_bytes()
    if ending == ".ply":
        header = content[: content.find(b"end_header")]
        found = re.search(rb"[\r\n]element face (\d{1,15})[\r\n ]", header)
        if found and triangles < int(found[1]):
            raise InputError(
                error("mesh.faces_missing", file=str(path), expected=int(found[1]), count=triangles)
            )
    elif len(content) != 84 + 50 * int.from_bytes(content[80:84], "little"):
        last = content.rstrip().rpartition(b"\n")[2].strip().lower()
        if not last.startswith(b"endsolid"):
            raise InputError(error("mesh.no_end", file=str(path)))


def _read_in_process(name: str) -> tuple[Array, NDArray[np.int64]]:
    """Read vertices and triangles; runs in the separate process."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 2)  # an abort prints its own message
    os.close(null)
    import open3d

    _limit_memory(BASE_MEMORY_BYTES + MEMORY_PER_FILE_BYTE * os.path.getsize(name))
    level = open3d.utility.VerbosityLevel.Error
    with open3d.utility.VerbosityContextManager(level):
        found = open3d.io.read_triangle_mesh(Path(name))
    return np.asarray(found.vertices, dtype=float), np.asarray(found.triangles, dtype=np.int64)


def _limit_memory(extra: int) -> None:
    """Limit the memory of this process to ``extra`` further bytes; has an effect only on Linux."""
    if sys.platform == "linux":
        import resource

        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        limit = pages * resource.getpagesize() + extra
        hard = resource.getrlimit(resource.RLIMIT_AS)[1]
        resource.setrlimit(resource.RLIMIT_AS, (limit, hard))


def _read_obj(path: Path) -> tuple[Array, NDArray[np.int64]]:
    """Read the vertices (``v``) and faces (``f``) of an OBJ file.

    The first number of a corner is the index of its vertex: from 1, or negative from the last one.

    Raises
    ------
    InputError
        If a row is not a valid vertex or face.
    """  # noqa: DOC501 - its own ValueError is caught
    vertices: list[list[float]] = []
    triangles: list[tuple[int, int, int]] = []
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    for number, line in enumerate(lines, 1):
        kind, *words = line.split("#")[0].split() or [""]
        try:
            if kind == "v":
                x, y, z = (float(word) for word in words[:3])
                vertices.append([x, y, z])
            elif kind == "f":
                corners = [_vertex_index(word, len(vertices)) for word in words]
                first, *others = corners
                if len(others) < 2:
                    raise ValueError(line)
                triangles += [(first, b, c) for b, c in pairwise(others)]
        except ValueError:
            file, text = str(path), line.strip()[:40]
            if kind == "v":
                raise InputError(error("mesh.vertex", file=file, row=number, text=text)) from None
            raise InputError(error("mesh.face", file=file, row=number, text=text)) from None
    return np.array(vertices).reshape(-1, 3), np.array(triangles, dtype=np.int64).reshape(-1, 3)


def _vertex_index(word: str, known: int) -> int:
    """Index of a vertex among those read so far.

    Raises
    ------
    ValueError
        If there is no such vertex.
    """
    given = int(word.split("/")[0])
    index = given - 1 if given > 0 else known + given
    if given == 0 or not 0 <= index < known:
        raise ValueError(word)
    return index
