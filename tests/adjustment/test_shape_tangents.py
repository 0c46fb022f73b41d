"""Tests of the directions in which the shape parameters of a target may change."""

import numpy as np

from lispac.adjustment.model.target_shapes import orthogonal_vectors, plane_tangents


def normals() -> np.ndarray:
    drawn = np.random.default_rng(1).normal(size=(50, 3))
    drawn = np.concatenate([drawn, np.eye(3), -np.eye(3), [[1.0, 1.0, -1e-9]]])
    return drawn / np.linalg.norm(drawn, axis=1)[:, None]


def test_tangents_are_unit_vectors_normal_to_each_other() -> None:
    frames = np.concatenate([orthogonal_vectors(normals()), normals()[:, :, None]], axis=2)
    unit = np.broadcast_to(np.eye(3), frames.shape)
    np.testing.assert_allclose(np.swapaxes(frames, 1, 2) @ frames, unit, rtol=0, atol=1e-14)
    np.testing.assert_array_equal(
        orthogonal_vectors(normals()[7]), orthogonal_vectors(normals())[7]
    )


def test_tilts_keep_the_centre_on_the_plane_and_the_offset_moves_it() -> None:
    """Compare the first-order changes of ``n . c + d`` and of ``|n|``."""
    centres = np.random.default_rng(2).normal(0, 50, (len(normals()), 3))
    tangents = plane_tangents(normals(), centres)
    at_centre = np.einsum("mi,mij->mj", centres, tangents[:, :3]) + tangents[:, 3]
    np.testing.assert_allclose(at_centre, np.tile([0, 0, 1], (len(centres), 1)), atol=1e-12)
    longer = np.einsum("mi,mij->mj", normals(), tangents[:, :3])
    np.testing.assert_allclose(longer, 0, atol=1e-14)
    np.testing.assert_allclose(np.linalg.norm(tangents[:, :3, :2], axis=1), 1, rtol=1e-12)
