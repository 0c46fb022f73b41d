"""The condition every point obeys, its Jacobians, and their sums over sightings.

``F = n . X + d = 0`` with ``X = P + R_local_body (R_body_lidar x + lever_arm)`` (thesis equations
4.1 and 4.4). One point gives one condition, so ``B Q B'`` is diagonal: one variance a point, and
the products that make up the normal equations can be summed in one pass. The sums are kept per
group of points (a target, and with it the stretch between two knots of the POS error), which is
all either stochastic model needs, whatever the number of points.
"""

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from lispac.adjustment.observations import Observations
from lispac.adjustment.stochastic import PosErrorKnots
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


@dataclass(frozen=True, eq=False)
class Groups:
    """Points whose products are summed together.

    Attributes
    ----------
    group : ndarray of shape (n,), int
        Group of each point.
    target : ndarray of shape (groups,), int
    knot : ndarray of shape (groups,), int
        Knot of the POS error at the beginning of the group's stretch.
    knots : PosErrorKnots or None
        None in thesis mode, where the POS error is in each point's variance instead.
    """

    group: NDArray[np.int64]
    target: NDArray[np.int64]
    knot: NDArray[np.int64]
    knots: PosErrorKnots | None

    @classmethod
    def of(cls, observations: Observations, knots: PosErrorKnots | None) -> "Groups":
        """Group by target, and by stretch of the POS error where it has knots."""
        target = observations.target_of_sighting[observations.sighting]
        left = np.zeros(len(target), dtype=np.int64) if knots is None else knots.left
        count = len(observations.targets)
        key, group = np.unique(left * count + target, return_inverse=True)
        return cls(group.reshape(-1).astype(np.int64), key % count, key // count, knots)


def sum_by_group(
    observations: Observations, mounting: Mounting, planes: Array, groups: Groups, effects: Array
) -> Array:
    """Weighted sums of ``row row'`` over each group.

    Parameters
    ----------
    planes : ndarray of shape (targets, 4)
    groups : Groups
        With knots, the variance of a condition holds the LiDAR noise alone; without, the POS
        error too.
    effects : ndarray of shape (knots, 6), metres and radians
        POS error at the knots found so far; its effect is added to the misclosures, so that
        these, and with them the rounding of their sums, are small at the solution.

    Returns
    -------
    ndarray of shape (groups, width, width)
        Rows are the derivatives by boresight (3) and plane (4), with knots those by the POS error
        at the knot before (6) and after (6), and last the misclosure.
    """
    knots = groups.knots
    width = 8 if knots is None else 20
    sums = np.zeros((len(groups.target), width, width))
    _accumulate(
        *_columns(observations),
        *_rotation_and_derivatives(mounting),
        planes,
        groups.group,
        knots is not None,
        np.zeros(0, dtype=np.int64) if knots is None else knots.left,
        np.zeros(0) if knots is None else knots.fraction,
        effects,
        observations.sigma_lidar,
        observations.sigma_position,
        observations.sigma_attitude,
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
    rotation, derivatives, lever_arm, planes,
    group, has_knots, left, fraction, effects,
    sigma_lidar, sigma_position, sigma_attitude, sums,
):  # fmt: skip
    row, lidar = np.empty(14), np.empty(3)
    width = sums.shape[1]
    wide = np.empty(width)
    for i in range(len(points)):
        plane = planes[target_of_sighting[sighting[i]]]
        _row(i, points, position, attitude, rotation, derivatives, lever_arm, plane, row, lidar)
        variance = 0.0
        for k in range(3):
            variance += (lidar[k] * sigma_lidar[i, k]) ** 2
        for k in range(7):
            wide[k] = row[k]
        misclosure = row[13]
        if has_knots:
            u, knot = fraction[i], left[i]
            for k in range(6):
                by_pose = row[7 + k]
                wide[7 + k] = (1 - u) * by_pose
                wide[13 + k] = u * by_pose
                misclosure += by_pose * ((1 - u) * effects[knot, k] + u * effects[knot + 1, k])
        else:
            for k in range(3):
                variance += (row[7 + k] * sigma_position[i, k]) ** 2
                variance += (row[10 + k] * sigma_attitude[i, k]) ** 2
        wide[width - 1] = misclosure
        total = sums[group[i]]
        for j in range(width):
            weighted = wide[j] / variance
            for k in range(j + 1):
                total[j, k] += weighted * wide[k]
