"""Meshes as parts of a scene: Open3D finds the triangles, ranges have double precision.

Ray casting in Open3D uses single precision: the resolution of a range is 1e-6 m at 20 m and 1e-5 m
at 100 m. Open3D is therefore used only to find the triangle that a ray hits; the range is computed
from the plane of the triangle.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Mesh:
    """A surface of triangles, visible from both sides.

    Attributes
    ----------
    name : str
    vertices : ndarray of shape (k, 3), metres, local
    triangles : ndarray of shape (m, 3)
        Indices into the vertices.
    reflectance : float, in [0, 1]
    """

    name: str
    vertices: Array
    triangles: NDArray[np.int64]
    reflectance: float = 0.4

    def distance(self, points_local: Array) -> Array:
        """Signed distance of points from the plane of the nearest triangle, shape (n,), metres.

        The distance is positive on the side from which the corners are in anticlockwise order.
        """
        caster = MeshCaster.of([self])
        near = np.asarray(points_local) - caster.middle
        found = caster.scene.compute_closest_points(near.astype(np.float32))
        number = found["primitive_ids"].numpy().astype(np.int64)
        return np.sum((near - caster.corners[number]) * caster.normals[number], axis=1)


@dataclass(frozen=True, eq=False)
class MeshCaster:
    """All meshes of a scene, prepared for ray casting.

    Attributes
    ----------
    middle : ndarray of shape (3,), metres, local
        Origin of the coordinates in Open3D, near the meshes because of the single precision.
    corners : ndarray of shape (m, 3), metres from the middle, local
        First corner of each triangle, mesh after mesh.
    normals : ndarray of shape (m, 3), unit vectors, local
    first : ndarray of shape (meshes,)
        Number of each mesh's first triangle.
    """

    scene: Any
    middle: Array
    corners: Array
    normals: Array
    first: NDArray[np.int64]

    @classmethod
    def of(cls, meshes: Sequence[Mesh]) -> "MeshCaster":
        """Prepare meshes for ray casting."""
        from open3d.t.geometry import RaycastingScene

        scene = RaycastingScene()
        every = np.concatenate([mesh.vertices for mesh in meshes])
        middle = (every.min(axis=0) + every.max(axis=0)) / 2
        corners, normals, first = [], [], [0]
        for mesh in meshes:
            vertices = mesh.vertices - middle
            scene.add_triangles(vertices.astype(np.float32), mesh.triangles.astype(np.uint32))
            a, b, c = (vertices[column] for column in mesh.triangles.T)
            normal = np.cross(b - a, c - a)
            corners.append(a)
            normals.append(normal / np.linalg.norm(normal, axis=1, keepdims=True))
            first.append(first[-1] + len(a))
        # Open3D builds its tree with the first rays, which is not safe in several threads.
        scene.cast_rays(np.zeros((1, 6), dtype=np.float32))
        return cls(
            scene, middle, np.concatenate(corners), np.concatenate(normals), np.array(first[:-1])
        )

    def intersect(
        self, origins: Array, directions: Array, max_range: float
    ) -> tuple[Array, NDArray[np.int64], Array]:
        """Nearest mesh along each ray.

        Parameters
        ----------
        origins, directions : ndarray of shape (n, 3), metres and unit vectors, local

        Returns
        -------
        ranges : ndarray of shape (n,), metres; infinite where nothing is hit
        numbers : ndarray of shape (n,)
            Index of the mesh; -1 where nothing is hit.
        cosines : ndarray of shape (n,)
            Cosine of the angle of incidence.
        """
        near = origins - self.middle
        found = self.scene.cast_rays(np.hstack([near, directions]).astype(np.float32))
        hit = np.flatnonzero(np.isfinite(found["t_hit"].numpy()))
        number = found["geometry_ids"].numpy()[hit].astype(np.int64)
        triangle = self.first[number] + found["primitive_ids"].numpy()[hit]
        normal = self.normals[triangle]
        slope = np.sum(directions[hit] * normal, axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            distance = np.sum((self.corners[triangle] - near[hit]) * normal, axis=1) / slope
        # A triangle parallel to the ray gives no range, though Open3D may report a hit.
        good = (distance > 0) & (distance < max_range)
        ranges = np.full(len(origins), np.inf)
        numbers = np.full(len(origins), -1)
        cosines = np.zeros(len(origins))
        kept = hit[good]
        ranges[kept], numbers[kept] = distance[good], number[good]
        cosines[kept] = np.abs(slope[good])
        return ranges, numbers, cosines
