"""Condition equations of the points and their Jacobians.

A point of a plane satisfies ``n . X + d = 0``, and a point of a sphere ``|X - c| - r = 0``, with
``X = P + R_local_body (R_body_lidar x + lever_arm)`` (thesis equations 4.1 and 4.4). Each point
gives one condition, so that ``B Q B'`` is diagonal, with one variance per point.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations, half_angle_tangents
from lispac.adjustment.model.threads import run_over_points
from lispac.compiled_code import kernel
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

# Columns of `Conditions.rows`
MOUNTING_COLUMNS = slice(0, 9)  # derivatives by the values of the mounting
RANGE_OFFSET_COLUMN = 6  # the cosine of the angle of incidence, with a sign
SHAPE_COLUMNS = slice(9, 13)  # by a, b, c, d of a plane, or centre and radius of a sphere
POSE_COLUMNS = slice(13, 19)  # by POS position (3) and roll, pitch, heading
MISCLOSURE_COLUMN = 19
COLUMN_COUNT = 20


@dataclass(frozen=True, eq=False)
class Conditions:
    """Linearised condition equations of all points.

    Attributes
    ----------
    rows : ndarray of shape (n, 20)
        Derivatives by mounting, shape and POS state, and the misclosure (metres).
    by_lidar : ndarray of shape (n, 3)
        Derivatives by LiDAR x, y, z.
    """

    rows: Array
    by_lidar: Array

    @property
    def misclosure(self) -> Array:
        """Signed distance of each point to its plane or sphere, shape (n,), metres."""
        return self.rows[:, MISCLOSURE_COLUMN]


def linearise(observations: Observations, mounting: Mounting, shapes: Array) -> Conditions:
    """Compute misclosure and Jacobians of every point.

    Parameters
    ----------
    shapes : ndarray of shape (targets, 4), local frame
        Unit normal and offset (metres) of each plane, centre and radius (metres) of each sphere.
    """
    rows, by_lidar = np.empty((len(observations), COLUMN_COUNT)), np.empty((len(observations), 3))
    points, placing = PointArrays.of(observations, mounting), MountingArrays.of(mounting, shapes)
    run_over_points(
        lambda first, last: _linearise_kernel(first, last, points, placing, rows, by_lidar),
        len(observations),
    )
    return Conditions(rows, by_lidar)


def evaluate_columns(
    observations: Observations, mounting: Mounting, shapes: Array, columns: slice
) -> Array:
    """Some columns of `linearise`, computed with less memory, shape (n, columns).

    Parameters
    ----------
    shapes : ndarray of shape (targets, 4), local frame
        As in `linearise`.
    columns : slice
        Range of the columns.
    """
    out = np.empty((len(observations), columns.stop - columns.start))
    points, placing = PointArrays.of(observations, mounting), MountingArrays.of(mounting, shapes)
    run_over_points(
        lambda first, last: _evaluate_columns_kernel(
            first, last, points, placing, columns.start, out
        ),
        len(observations),
    )
    return out


def misclosures(observations: Observations, mounting: Mounting, shapes: Array) -> Array:
    """Signed distance of each point to its plane or sphere, shape (n,), metres.

    Parameters
    ----------
    shapes : ndarray of shape (targets, 4), local frame
        As in `linearise`.
    """
    return evaluate_columns(observations, mounting, shapes, slice(MISCLOSURE_COLUMN, COLUMN_COUNT))[
        :, 0
    ]


def incidence_angles(observations: Observations, mounting: Mounting, shapes: Array) -> Array:
    """Angle between the beam of each point and the normal of its surface, shape (n,), radians.

    Parameters
    ----------
    shapes : ndarray of shape (targets, 4), local frame
        As in `linearise`.
    """
    column = slice(RANGE_OFFSET_COLUMN, RANGE_OFFSET_COLUMN + 1)
    cosines = np.abs(evaluate_columns(observations, mounting, shapes, column)[:, 0])
    return np.arccos(np.minimum(cosines, 1.0))


class PointArrays(NamedTuple):
    """Arrays of point data, as arguments of the compiled kernels.

    Functions that are inlined into a kernel must read the arrays from the tuple before any branch.
    Numba counts references to all arrays of a tuple that is used in a branch, for each point, which
    takes longer than the arithmetic.
    """

    xyz: Array  # in the LiDAR frame
    position: Array
    half_tangents: Array  # of the halves of roll, pitch, heading
    rate: Array  # without rows if unknown
    sighting: NDArray[np.int64]
    target_of_sighting: NDArray[np.int64]
    origins: Array  # of each target
    spheres: NDArray[np.bool_]  # whether each target is a sphere
    sigma_lidar: Array
    beam_sigmas: bool
    sigma_position: Array
    sigma_attitude: Array

    @classmethod
    def of(cls, observations: Observations, mounting: Mounting) -> "PointArrays":
        """Take the columns of ``observations``, with the remaining latency applied to the poses."""
        position, tangents = observations.position, observations.half_angle_tangents
        rate, late = observations.pose_rate, mounting.latency - observations.latency
        if rate is None:
            rate = np.zeros((0, 6))
        elif late != 0:
            position = position + late * rate[:, :3]
            tangents = half_angle_tangents(observations.attitude + late * rate[:, 3:])
        return cls(
            observations.points_lidar,
            position,
            tangents,
            rate,
            observations.sighting,
            observations.target_of_sighting,
            observations.origin_of_target,
            observations.is_sphere,
            observations.sigma_lidar,
            observations.beam_sigmas,
            observations.sigma_position,
            observations.sigma_attitude,
        )


class MountingArrays(NamedTuple):
    """Arrays of mounting and shapes, as arguments of the compiled kernels."""

    values: Array
    rotation: Array
    derivatives: Array
    turn: Array  # by the scan-angle offset
    shapes: Array

    @classmethod
    def of(cls, mounting: Mounting, shapes: Array) -> "MountingArrays":
        """Compute the rotations; ``shapes`` of shape (targets, 4) as in `linearise`."""
        return cls(
            mounting.values,
            mounting.rotation_body_lidar,
            mounting.rotation_derivatives,
            rotation_matrix(mounting.scan_angle_offset, 0.0, 0.0),
            shapes,
        )


@kernel(inline="always")
def lidar_point(i, points):  # type: ignore[no-untyped-def]
    """LiDAR coordinates of point ``i``."""
    return points.xyz[i, 0], points.xyz[i, 1], points.xyz[i, 2]


@kernel(inline="always")
def point_pose(i, points):  # type: ignore[no-untyped-def]
    """Position of point ``i`` relative to its target, and cosines and sines of its attitude."""
    position, origins, tangents = points.position, points.origins, points.half_tangents
    t = points.target_of_sighting[points.sighting[i]]
    r, p, h = tangents[i, 0], tangents[i, 1], tangents[i, 2]
    by_r, by_p, by_h = 1 / (1 + r * r), 1 / (1 + p * p), 1 / (1 + h * h)
    return (
        position[i, 0] - origins[t, 0],
        position[i, 1] - origins[t, 1],
        position[i, 2] - origins[t, 2],
        (1 - r * r) * by_r, 2 * r * by_r,
        (1 - p * p) * by_p, 2 * p * by_p,
        (1 - h * h) * by_h, 2 * h * by_h,
    )  # fmt: skip


@kernel(inline="always")
def condition_row(  # type: ignore[no-untyped-def]
    i, xyz, pose, points, placing, out, lidar
):
    """Jacobian row of point ``i`` with LiDAR coordinates ``xyz`` and the pose from `point_pose`.

    Written to ``out`` (20) and ``lidar`` (3).
    """
    rx, ry, rz = xyz
    px, py, pz, cr, sr, cp, sp, ch, sh = pose
    values, rotation, derivatives = placing.values, placing.rotation, placing.derivatives
    turn, shapes, rate = placing.turn, placing.shapes, points.rate
    t = points.target_of_sighting[points.sighting[i]]
    # Read before anything is written, so that the compiler need not read them again
    s0, s1, s2, s3 = shapes[t, 0], shapes[t, 1], shapes[t, 2], shapes[t, 3]
    sphere = points.spheres[t]
    distance = np.sqrt(rx * rx + ry * ry + rz * rz)
    stretch = values[6] / distance
    # Turned by the scan-angle offset (about x), then with the range offset
    ty, tz = turn[1, 1] * ry + turn[1, 2] * rz, turn[2, 1] * ry + turn[2, 2] * rz
    x, y, z = rx * (1 + stretch), ty * (1 + stretch), tz * (1 + stretch)
    b0 = rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z + values[3]
    b1 = rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z + values[4]
    b2 = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z + values[5]
    # The point after each turn of the attitude
    r0, r1, r2 = b0, cr * b1 - sr * b2, sr * b1 + cr * b2
    p0, p1, p2 = cp * r0 + sp * r2, r1, -sp * r0 + cp * r2
    h0, h1, h2 = ch * p0 + sh * p1, -sh * p0 + ch * p1, p2
    x0, x1, x2 = px + h0, py + h1, pz + h2
    if sphere:
        n0, n1, n2 = x0 - s0, x1 - s1, x2 - s2
        norm = np.sqrt(n0 * n0 + n1 * n1 + n2 * n2)
        n0, n1, n2 = n0 / norm, n1 / norm, n2 / norm
        out[9], out[10], out[11], out[12] = -n0, -n1, -n2, -1.0
        out[19] = norm - s3
    else:
        n0, n1, n2 = s0, s1, s2
        out[9], out[10], out[11], out[12] = x0, x1, x2, 1.0
        out[19] = n0 * x0 + n1 * x1 + n2 * x2 + s3
    # The normal in the frames between the three rotations: m3 after Rz(-h), m2 after Ry(p), m1 in
    # the body frame; u in the LiDAR frame.
    m30, m31, m32 = ch * n0 - sh * n1, sh * n0 + ch * n1, n2
    m20, m21, m22 = cp * m30 - sp * m32, m31, sp * m30 + cp * m32
    m10, m11, m12 = m20, cr * m21 + sr * m22, -sr * m21 + cr * m22
    u0 = m10 * rotation[0, 0] + m11 * rotation[1, 0] + m12 * rotation[2, 0]
    u1 = m10 * rotation[0, 1] + m11 * rotation[1, 1] + m12 * rotation[2, 1]
    u2 = m10 * rotation[0, 2] + m11 * rotation[1, 2] + m12 * rotation[2, 2]
    for k in range(3):
        out[k] = (
            m10 * (derivatives[k, 0, 0] * x + derivatives[k, 0, 1] * y + derivatives[k, 0, 2] * z)
            + m11 * (derivatives[k, 1, 0] * x + derivatives[k, 1, 1] * y + derivatives[k, 1, 2] * z)
            + m12 * (derivatives[k, 2, 0] * x + derivatives[k, 2, 1] * y + derivatives[k, 2, 2] * z)
        )
    out[3], out[4], out[5] = m10, m11, m12
    out[6] = (u0 * rx + u1 * ty + u2 * tz) / distance
    out[7] = u2 * y - u1 * z  # u . (e_x x x)
    out[13], out[14], out[15] = n0, n1, n2
    out[16] = m22 * r1 - m21 * r2  # m2 . (e_x x r)
    out[17] = m30 * p2 - m32 * p0  # m3 . (e_y x p)
    out[18] = n0 * h1 - n1 * h0  # n . (-e_z x h)
    out[8] = 0.0
    if len(rate) > 0:
        for k in range(6):
            out[8] += out[13 + k] * rate[i, k]
    # Inverse of the scan-angle rotation; the range offset moves the point along its beam
    v1, v2 = turn[1, 1] * u1 + turn[2, 1] * u2, turn[1, 2] * u1 + turn[2, 2] * u2
    along = (u0 * rx + v1 * ry + v2 * rz) * stretch / (distance * distance)
    lidar[0] = u0 * (1 + stretch) - rx * along
    lidar[1] = v1 * (1 + stretch) - ry * along
    lidar[2] = v2 * (1 + stretch) - rz * along


@kernel()
def _linearise_kernel(  # type: ignore[no-untyped-def]
    first, last, points, placing, rows, by_lidar
):
    """Write the results of `condition_row` for the points from ``first`` to ``last``."""
    for i in range(first, last):
        point_xyz, pose = lidar_point(i, points), point_pose(i, points)
        condition_row(i, point_xyz, pose, points, placing, rows[i], by_lidar[i])


@kernel()
def _evaluate_columns_kernel(  # type: ignore[no-untyped-def]
    first, last, points, placing, begin, selected
):
    out, lidar = np.empty(20), np.empty(3)
    for i in range(first, last):
        point_xyz, pose = lidar_point(i, points), point_pose(i, points)
        condition_row(i, point_xyz, pose, points, placing, out, lidar)
        for k in range(selected.shape[1]):
            selected[i, k] = out[begin + k]


@kernel(inline="always")
def adjusted_observation(i, xyz, sigma, beam, lidar, pull):  # type: ignore[no-untyped-def]
    """Adjusted LiDAR coordinates of point ``i``.

    ``pull`` is the misclosure divided by its variance; the correction is ``-Q B'`` times this.
    """
    x, y, z = xyz[i, 0], xyz[i, 1], xyz[i, 2]
    if not beam:
        return (
            x - pull * lidar[0] * sigma[i, 0] ** 2,
            y - pull * lidar[1] * sigma[i, 1] ** 2,
            z - pull * lidar[2] * sigma[i, 2] ** 2,
        )
    along = (lidar[0] * x + lidar[1] * y + lidar[2] * z) / (x * x + y * y + z * z)
    far, near = sigma[i, 0] ** 2, sigma[i, 1] ** 2
    stretch = 1 - pull * along * (far - near)
    return (
        x * stretch - pull * lidar[0] * near,
        y * stretch - pull * lidar[1] * near,
        z * stretch - pull * lidar[2] * near,
    )


@kernel(inline="always")
def lidar_variance(i, xyz, sigma, beam, lidar):  # type: ignore[no-untyped-def]
    """Variance of the condition of point ``i`` from the LiDAR noise, square metres."""
    if not beam:
        return (
            (lidar[0] * sigma[i, 0]) ** 2
            + (lidar[1] * sigma[i, 1]) ** 2
            + (lidar[2] * sigma[i, 2]) ** 2
        )
    x, y, z = xyz[i, 0], xyz[i, 1], xyz[i, 2]
    along = lidar[0] * x + lidar[1] * y + lidar[2] * z
    along = along * along / (x * x + y * y + z * z)
    across = lidar[0] ** 2 + lidar[1] ** 2 + lidar[2] ** 2 - along
    # Both directions across the beam have the same sigma.
    return along * sigma[i, 0] ** 2 + across * sigma[i, 1] ** 2
