"""The condition every point obeys, its Jacobians, and their sums over sightings.

``F = n . X + d = 0`` with ``X = P + R_local_body (R_body_lidar x + lever_arm)`` (thesis equations
4.1 and 4.4). One point gives one condition, so ``B Q B'`` is diagonal: one variance a point, and
the products that make up the normal equations can be summed in one pass. The sums are kept per
sighting, which is all either stochastic model needs, whatever the number of points.
"""

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from lispac.adjustment.observations import Observations
from lispac.geometry.rotations import rotation_derivatives
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

BORESIGHT = slice(0, 3)  # dF by roll, pitch, yaw
PLANE = slice(3, 7)  # dF by a, b, c, d
POSE = slice(7, 13)  # dF by POS position (3) and roll, pitch, heading
MISCLOSURE = 13
WIDTH = 14


@dataclass(frozen=True, eq=False)
class Conditions:
    """Linearised conditions point by point: for tests, residuals and diagnostics.

    Attributes
    ----------
    rows : ndarray of shape (n, 14)
        Derivatives by boresight, plane and POS state, and the misclosure (metres).
    by_lidar : ndarray of shape (n, 3)
        Derivatives by LiDAR x, y, z.
    """

    rows: Array
    by_lidar: Array

    @property
    def misclosure(self) -> Array:
        """Signed distance of each point to its plane, shape (n,), metres."""
        return self.rows[:, MISCLOSURE]


def linearise(observations: Observations, mounting: Mounting, planes: Array) -> Conditions:
    """Misclosure and Jacobians of every point.

    Parameters
    ----------
    planes : ndarray of shape (targets, 4)
        Unit normal and offset (metres) of each target, local frame.
    """
    rows, by_lidar = np.empty((len(observations), WIDTH)), np.empty((len(observations), 3))
    _linearise(
        *_columns(observations), *_rotation_and_derivatives(mounting), planes, rows, by_lidar
    )
    return Conditions(rows, by_lidar)


def sum_by_sighting(
    observations: Observations,
    mounting: Mounting,
    planes: Array,
    effects: Array,
    *,
    pose_in_variance: bool,
) -> Array:
    """Weighted sums of ``row row'`` over each sighting.

    Parameters
    ----------
    planes : ndarray of shape (targets, 4)
    effects : ndarray of shape (sightings, 6), metres and radians
        POS error of each sighting found so far; its effect is added to the misclosures, so that
        these, and with them the rounding of their sums, are small at the solution.
    pose_in_variance : bool
        Whether the variance of a condition holds the POS error (thesis mode: independent from
        point to point) or the LiDAR noise alone.

    Returns
    -------
    ndarray of shape (sightings, 14, 14)
    """
    sums = np.zeros((len(observations.sightings), WIDTH, WIDTH))
    _accumulate(
        *_columns(observations),
        *_rotation_and_derivatives(mounting),
        planes,
        effects,
        observations.sigma_lidar,
        observations.sigma_position,
        observations.sigma_attitude,
        pose_in_variance,
        sums,
    )
    return sums + np.swapaxes(np.tril(sums, -1), -1, -2)


def _columns(observations: Observations) -> tuple[NDArray[np.generic], ...]:
    return (
        observations.points_lidar,
        observations.position,
        observations.attitude,
        observations.sighting,
        observations.target_of_sighting,
    )


def _rotation_and_derivatives(mounting: Mounting) -> tuple[Array, Array, Array]:
    return (
        mounting.rotation_body_lidar,
        rotation_derivatives(*mounting.boresight),
        np.asarray(mounting.lever_arm, dtype=float),
    )


@njit(nogil=True, cache=True, inline="always")
def _row(i, points, position, attitude, rotation, derivatives, lever_arm, plane, row, lidar):  # type: ignore[no-untyped-def]
    cr, sr = np.cos(attitude[i, 0]), np.sin(attitude[i, 0])
    cp, sp = np.cos(attitude[i, 1]), np.sin(attitude[i, 1])
    ch, sh = np.cos(attitude[i, 2]), np.sin(attitude[i, 2])
    # The normal seen from the frames the three turns pass through: m3 after Rz(-h), m2 after
    # Ry(p), m1 in the body frame.
    n0, n1, n2 = plane[0], plane[1], plane[2]
    m30, m31, m32 = ch * n0 - sh * n1, sh * n0 + ch * n1, n2
    m20, m21, m22 = cp * m30 - sp * m32, m31, sp * m30 + cp * m32
    m10, m11, m12 = m20, cr * m21 + sr * m22, -sr * m21 + cr * m22
    x, y, z = points[i, 0], points[i, 1], points[i, 2]
    b0 = rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z + lever_arm[0]
    b1 = rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z + lever_arm[1]
    b2 = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z + lever_arm[2]
    # The point after each turn
    r0, r1, r2 = b0, cr * b1 - sr * b2, sr * b1 + cr * b2
    p0, p1, p2 = cp * r0 + sp * r2, r1, -sp * r0 + cp * r2
    h0, h1, h2 = ch * p0 + sh * p1, -sh * p0 + ch * p1, p2
    for k in range(3):
        d = derivatives[k]
        row[k] = (
            m10 * (d[0, 0] * x + d[0, 1] * y + d[0, 2] * z)
            + m11 * (d[1, 0] * x + d[1, 1] * y + d[1, 2] * z)
            + m12 * (d[2, 0] * x + d[2, 1] * y + d[2, 2] * z)
        )
        lidar[k] = m10 * rotation[0, k] + m11 * rotation[1, k] + m12 * rotation[2, k]
    row[3], row[4], row[5] = position[i, 0] + h0, position[i, 1] + h1, position[i, 2] + h2
    row[6] = 1.0
    row[7], row[8], row[9] = n0, n1, n2
    row[10] = m22 * r1 - m21 * r2  # m2 . (e_x x r)
    row[11] = m30 * p2 - m32 * p0  # m3 . (e_y x p)
    row[12] = n0 * h1 - n1 * h0  # n . (-e_z x h)
    row[13] = n0 * row[3] + n1 * row[4] + n2 * row[5] + plane[3]


@njit(nogil=True, cache=True)
def _linearise(  # type: ignore[no-untyped-def]
    points, position, attitude, sighting, target_of_sighting,
    rotation, derivatives, lever_arm, planes, rows, by_lidar,
):  # fmt: skip
    for i in range(len(points)):
        plane = planes[target_of_sighting[sighting[i]]]
        _row(
            i, points, position, attitude, rotation, derivatives, lever_arm, plane,
            rows[i], by_lidar[i],
        )  # fmt: skip


@njit(nogil=True, cache=True)
def _accumulate(  # type: ignore[no-untyped-def]
    points, position, attitude, sighting, target_of_sighting,
    rotation, derivatives, lever_arm, planes, effects,
    sigma_lidar, sigma_position, sigma_attitude, pose_in_variance, sums,
):  # fmt: skip
    row, lidar = np.empty(14), np.empty(3)
    for i in range(len(points)):
        s = sighting[i]
        plane = planes[target_of_sighting[s]]
        _row(i, points, position, attitude, rotation, derivatives, lever_arm, plane, row, lidar)
        for k in range(6):
            row[13] += row[7 + k] * effects[s, k]
        variance = 0.0
        for k in range(3):
            variance += (lidar[k] * sigma_lidar[i, k]) ** 2
            if pose_in_variance:
                variance += (row[7 + k] * sigma_position[i, k]) ** 2
                variance += (row[10 + k] * sigma_attitude[i, k]) ** 2
        for j in range(14):
            weighted = row[j] / variance
            for k in range(j + 1):
                sums[s, j, k] += weighted * row[k]
