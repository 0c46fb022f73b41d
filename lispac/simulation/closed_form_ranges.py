"""Ranges to a plane or a sphere in closed form (thesis 3.4.2).

The georeferencing equation contains all errors, and the range follows from the condition that the
georeferenced point lies on the surface. No rays are cast, so that the results can be used to check
the ray casting.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.rotations import rotation_matrix
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]


def range_to_plane(plane: Array, beams_lidar: Array, poses: Poses, mounting: Mounting) -> Array:
    """Range that the scanner records on an unbounded plane.

    Parameters
    ----------
    plane : ndarray of shape (4,) or (n, 4)
        Unit normal and distance: ``a x + b y + c z + d = 0``, local, metres.
    beams_lidar : ndarray of shape (n, 3), unit vectors, LiDAR frame
        Directions as recorded by the scanner.
    poses : Poses of n points
        True poses, at the times of the points plus the latency.
    mounting : Mounting
        The true mounting.

    Returns
    -------
    ndarray of shape (n,), metres
        Infinite if the beam points away from the plane or is parallel to it.
    """
    origins, directions = beam_rays(beams_lidar, poses, mounting)
    normal, d = plane[..., :3], plane[..., 3]
    slope = _row_products(normal, directions)
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = -(_row_products(normal, origins) + d) / slope
    return np.where(distance > 0, distance - mounting.range_offset, np.inf)


def range_to_sphere(
    centre: Array, radius: float, beams_lidar: Array, poses: Poses, mounting: Mounting
) -> Array:
    """Range that the scanner records on a sphere, to the nearer of the two intersections.

    Parameters
    ----------
    centre : ndarray of shape (3,), metres, local
    radius : float, metres
    beams_lidar, poses, mounting
        See `range_to_plane`.

    Returns
    -------
    ndarray of shape (n,), metres
        Infinite if the beam misses the sphere.
    """
    origins, directions = beam_rays(beams_lidar, poses, mounting)
    offset = origins - centre
    along = _row_products(offset, directions)
    offset_abeam = np.linalg.norm(np.cross(offset, directions), axis=-1)
    half = np.sqrt(np.maximum(radius**2 - offset_abeam**2, 0.0))
    near, far = -along - half, -along + half
    distance = np.where(near > 0, near, far)
    is_hit = (offset_abeam < radius) & (distance > 0)
    return np.where(is_hit, distance - mounting.range_offset, np.inf)


def beam_rays(beams_lidar: Array, poses: Poses, mounting: Mounting) -> tuple[Array, Array]:
    """Origins and true directions of the beams.

    Parameters
    ----------
    beams_lidar : ndarray of shape (n, 3), unit vectors, LiDAR frame
        Directions as recorded by the scanner.

    Returns
    -------
    origins : ndarray of shape (n, 3), metres, local
    directions : ndarray of shape (n, 3), unit vectors, local
    """
    turn = rotation_matrix(mounting.scan_angle_offset, 0.0, 0.0)
    beams_body = beams_lidar @ (mounting.rotation_body_lidar @ turn).T
    rotation_local_body = rotation_matrix(*poses.attitude.T)
    directions = np.einsum("nij,nj->ni", rotation_local_body, beams_body)
    origins = poses.position + rotation_local_body @ mounting.lever_arm
    return origins, directions


def _row_products(first: Array, second: Array) -> Array:
    """Scalar products of the rows, shape (n,)."""
    return np.einsum("...i,...i->...", first, second)
