"""Condition equations of surveyed control, as part of the normal equations.

A surveyed point on a plane satisfies ``n . x + d = 0``, one on a sphere ``|x - c| - r = 0``, and a
surveyed centre of a sphere ``x - c = 0`` (three equations). The conditions contain the shapes of
the targets, but no value of the mounting, and they are not weighted by the loss function. They are
further conditions of the Gauss-Helmert model of the points (thesis B.3).
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy
from numpy.typing import NDArray

from lispac.adjustment.model.control import Control
from lispac.adjustment.model.observations import Observations

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ControlEquations:
    """Linearised condition equations of the control.

    Attributes
    ----------
    control : Control
        The points used.
    owner : ndarray of shape (q,), int
        Point of each equation, as an index into ``control``.
    by_unknowns : ndarray of shape (q, u)
        Derivatives by the unknowns of the normal equations.
    by_position : ndarray of shape (q, 3)
        Derivatives by the position of the own point: unit vectors, no unit, local frame.
    misclosure : ndarray of shape (q,), metres
    """

    control: Control
    owner: NDArray[np.int64]
    by_unknowns: Array
    by_position: Array
    misclosure: Array

    def __len__(self) -> int:
        return len(self.misclosure)

    @cached_property
    def covariance(self) -> Array:
        """Covariance of the misclosures from the control alone, shape (q, q), square metres."""
        design = np.zeros((len(self), len(self.control), 3))
        design[np.arange(len(self)), self.owner] = self.by_position
        spread = design.reshape(len(self), -1)
        return np.asarray(spread @ self.control.covariance @ spread.T)

    @cached_property
    def precision(self) -> Array:
        """Inverse of ``covariance``, shape (q, q), per square metre."""
        factor = scipy.linalg.cho_factor(self.covariance)
        inverse = scipy.linalg.cho_solve(factor, np.eye(len(self)))
        return np.asarray((inverse + inverse.T) / 2)

    @cached_property
    def matrix(self) -> Array:
        """Contribution to the normal matrix, shape (u, u)."""
        return np.asarray(self.by_unknowns.T @ self.precision @ self.by_unknowns)

    @cached_property
    def right(self) -> Array:
        """Contribution to the right-hand side, shape (u,)."""
        return np.asarray(-self.by_unknowns.T @ (self.precision @ self.misclosure))

    @cached_property
    def quadratic(self) -> float:
        """Contribution to ``v' P v``."""
        return float(self.misclosure @ self.precision @ self.misclosure)


def linearise_control(
    observations: Observations,
    shapes: Array,
    tangents: list[Array],
    places: tuple[slice, ...],
    size: int,
    used: NDArray[np.bool_],
) -> ControlEquations | None:
    """Linearise the control of some targets; None if there is none.

    Parameters
    ----------
    shapes : ndarray of shape (targets, 4)
        Shapes relative to the origins of their targets.
    tangents : list of ndarray of shape (4, 3) or (4, 4)
        Tangent vectors of each shape, in columns.
    places : tuple of slice
        Unknowns of each shape.
    size : int
        Number of unknowns.
    used : ndarray of shape (targets,), bool
        Targets whose control is used.
    """
    if observations.control is None:
        return None
    number = {target: k for k, target in enumerate(observations.targets)}
    keep = [target in number and used[number[target]] for target in observations.control.targets]
    if not any(keep):
        return None
    control = observations.control.where(np.array(keep))
    owner, rows, normals, misclosures = [], [], [], []
    for i, target in enumerate(control.targets):
        k = number[target]
        point = control.positions[i] - observations.origin_of_target[k]
        by_shape, by_position, misclosure = _conditions(
            point, shapes[k], sphere=bool(observations.is_sphere[k]),
            centre=bool(control.is_centre[i]),
        )  # fmt: skip
        row = np.zeros((len(misclosure), size))
        row[:, places[k]] = by_shape @ tangents[k]
        owner += [i] * len(misclosure)
        rows.append(row)
        normals.append(by_position)
        misclosures.append(misclosure)
    return ControlEquations(
        control, np.array(owner), np.concatenate(rows), np.concatenate(normals),
        np.concatenate(misclosures),
    )  # fmt: skip


def _conditions(
    point: Array, shape: Array, *, sphere: bool, centre: bool
) -> tuple[Array, Array, Array]:
    """Derivatives by the shape (k, 4) and by the point (k, 3), and misclosures (k,), metres.

    Parameters
    ----------
    point : ndarray of shape (3,), metres
    shape : ndarray of shape (4,)
        In the same frame as the point.
    """
    if centre:
        by_shape = np.zeros((3, 4))
        by_shape[:, :3] = -np.eye(3)
        return by_shape, np.eye(3), point - shape[:3]
    if sphere:
        away = point - shape[:3]
        distance = float(np.linalg.norm(away))
        normal = away / distance if distance > 0 else np.array([0.0, 0.0, 1.0])
        return np.array([[*-normal, -1.0]]), normal[None], np.array([distance - shape[3]])
    normal = shape[:3]
    return np.array([[*point, 1.0]]), normal[None].copy(), np.array([normal @ point + shape[3]])
