"""Displacement of a point by the uncertainty of the boresight, as values and tables.

A small change of the angles with covariance C rotates the point cloud by a vector w = J (change of
the angles), whose covariance is W = J C J'. It moves a point at distance d in direction u by
d (w x u).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.language import N_, gettext, gettext_lazy
from lispac.present.tables import CENTIMETRES, PLAIN_CENTIMETRES, Column, Format, Table
from lispac.present.text_format import title

EFFECT_DISTANCES_M = (10.0, 50.0, 100.0)
"""Distances of the point from the scanner."""

WORST_DIRECTION = "worst direction"
"""Name of the displacement by all angles together."""

FACTOR_95_1D = 1.96
FACTOR_95_2D = 2.45
"""Factors from one sigma to the 95 % level in one and in two dimensions (IHO S-44)."""


@dataclass(frozen=True)
class DisplacementByAngle:
    """Displacement of a point caused by one sigma of an angle, at each of `EFFECT_DISTANCES_M`.

    For the angle "worst direction": root mean square displacement by the errors of all angles
    together, for the direction of the beam in which it is largest.
    """

    angle: str
    displacement_m: tuple[float, ...]


@dataclass(frozen=True)
class S44Contribution:
    """Contribution of the boresight to the uncertainty of a point, for the worst beam.

    Horizontal (THU) and vertical (TVU), at the 95 % level of IHO S-44, for a level vessel.
    """

    distance_m: float
    thu95_m: float
    tvu95_m: float


def angle_displacements(result: AdjustmentResult) -> tuple[DisplacementByAngle, ...]:
    """Displacements by the sigma of each angle, and by all angles together in the worst direction.

    The mean square length of the displacement is d^2 (trace W - u' W u). It is largest if u is the
    eigenvector of the smallest eigenvalue of W.
    """
    eigenvalues = np.linalg.eigvalsh(_turn_covariance(result))
    rates = [*result.sigma, math.sqrt(eigenvalues[1] + eigenvalues[2])]
    return tuple(
        DisplacementByAngle(name, tuple(float(rate * distance) for distance in EFFECT_DISTANCES_M))
        for name, rate in zip((*ANGLES, WORST_DIRECTION), rates, strict=True)
    )


def s44_contributions(result: AdjustmentResult) -> tuple[S44Contribution, ...]:
    """Contribution of the boresight to THU and TVU at each of `EFFECT_DISTANCES_M`.

    The variance of the displacement along a unit vector e is d^2 (u x e)' W (u x e). If e points
    upwards, u x e is horizontal, so the largest vertical variance is d^2 times the largest
    eigenvalue of the horizontal part of W. If e may be any horizontal direction, u x e may be any
    unit vector, so the largest horizontal variance is d^2 times the largest eigenvalue of W.
    """
    turns = _turn_covariance(result)
    horizontal = FACTOR_95_2D * math.sqrt(np.linalg.eigvalsh(turns)[-1])
    vertical = FACTOR_95_1D * math.sqrt(np.linalg.eigvalsh(turns[:2, :2])[-1])
    return tuple(
        S44Contribution(distance, horizontal * distance, vertical * distance)
        for distance in EFFECT_DISTANCES_M
    )


def _turn_covariance(result: AdjustmentResult) -> NDArray[np.float64]:
    """Covariance W of the rotation vector in the body frame, shape (3, 3), radians squared."""
    rotation = result.mounting.rotation_body_lidar
    turning = result.mounting.rotation_derivatives @ rotation.T  # skew matrices of J's columns
    jacobian = np.stack([turning[:, 2, 1], turning[:, 0, 2], turning[:, 1, 0]])
    return np.asarray(jacobian @ result.covariance @ jacobian.T)


S44_TABLE = Table[S44Contribution](
    N_("Uncertainty by IHO S-44: contribution of the boresight alone, 95 %"),
    (
        Column("distance_m", N_("Distance"), Format("m", 0)),
        Column("thu95_m", "THU", CENTIMETRES),
        Column("tvu95_m", "TVU", CENTIMETRES),
    ),
)


def _angle_text(effect: DisplacementByAngle) -> str:
    if effect.angle == WORST_DIRECTION:
        return gettext("All three angles together, worst case")
    return title(effect.angle)


def _displacement_at(k: int) -> Callable[[DisplacementByAngle], float]:
    return lambda effect: effect.displacement_m[k]


DISPLACEMENTS_TABLE = Table[DisplacementByAngle](
    N_("Displacement of a point caused by a boresight error of 1 sigma (cm)"),
    (
        Column(_angle_text, N_("Angle")),
        *(
            Column(
                _displacement_at(k),
                gettext_lazy("at {distance:m.0} m", distance=distance),
                PLAIN_CENTIMETRES,
            )
            for k, distance in enumerate(EFFECT_DISTANCES_M)
        ),
    ),
)
