"""Meshes of a scene from PLY, OBJ or STL."""

from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.files import require_file
from lispac.simulation.meshes import Mesh

ENDINGS = (".ply", ".obj", ".stl")


def read_mesh(path: Path, name: str, reflectance: float) -> Mesh:
    """Read a mesh in local coordinates: north, west, up in metres.

    Triangles without area are left out.

    Raises
    ------
    InputError
        Where the file is missing, of another kind, or holds no triangle.
    """
    path = require_file(Path(path), "mesh")
    if path.suffix.lower() not in ENDINGS:
        raise InputError(f"{path}: a mesh ends in .ply, .obj or .stl; export it as one of these.")
    import open3d

    with open3d.utility.VerbosityContextManager(open3d.utility.VerbosityLevel.Error):
        found = open3d.io.read_triangle_mesh(path)
    vertices = np.asarray(found.vertices, dtype=float)
    triangles = np.asarray(found.triangles, dtype=np.int64)
    if not len(triangles):
        raise InputError(f"{path}: no triangles are in it; export the mesh, not its points.")
    if not np.isfinite(vertices).all():
        raise InputError(f"{path}: a vertex is not a number; export the mesh again.")
    a, b, c = (vertices[column] for column in triangles.T)
    wide = np.linalg.norm(np.cross(b - a, c - a), axis=1) > 0
    if not wide.any():
        raise InputError(f"{path}: all its triangles are without area; export the mesh again.")
    return Mesh(name, vertices, triangles[wide], reflectance)
