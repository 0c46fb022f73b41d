"""Values of the boresight angles, and tables with a column for each angle."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lispac.adjustment.result import (
    ANGLES,
)
from lispac.language import N_
from lispac.present.tables import (
    DEGREES,
    Column,
    Format,
    Table,
)
from lispac.present.text_format import TITLES

ANGLE_TITLES = tuple(TITLES[name] for name in ANGLES)


@dataclass(frozen=True)
class Angles:
    """A value for each boresight angle.

    Attributes
    ----------
    roll, pitch, yaw : degrees; significances have no unit
    """

    roll: float
    pitch: float
    yaw: float

    def __iter__(self) -> Iterator[float]:
        return iter((self.roll, self.pitch, self.yaw))


def angles(values: ArrayLike) -> Angles:
    """Numbers of roll, pitch and yaw, shape (3,), as they are."""
    return Angles(*floats(np.asarray(values, dtype=float)))


def degrees(values: ArrayLike) -> Angles:
    """Angles in radians, shape (3,), in degrees."""
    return angles(np.degrees(values))


def degrees_or_none(values: ArrayLike | None) -> Angles | None:
    """`degrees` of what may be unknown."""
    return None if values is None else degrees(values)


def finite_or_none(value: float) -> float | None:
    """The value, or None if it is not a number: JSON has no NaN."""
    return float(value) if math.isfinite(value) else None


def floats(values: Iterable[float]) -> tuple[float, ...]:
    """Numbers of Python, which `json` writes."""
    return tuple(float(value) for value in values)


def matrix(rows: Iterable[Iterable[float]]) -> tuple[tuple[float, ...], ...]:
    """Rows of `floats`."""
    return tuple(map(floats, rows))


@dataclass(frozen=True)
class AnglesRow:
    """A value for each angle, of one of several results."""

    name: str
    values: Angles | None


def angle_columns(path: str, form: Format, suffix: str = "") -> tuple[Column[Any], ...]:
    """A column for each angle; ``path`` leads to the `Angles`, ``suffix`` follows the title."""
    return tuple(Column(f"{path}.{name}", f"{TITLES[name]}{suffix}", form) for name in ANGLES)


SIGMAS = Table[AnglesRow](
    N_("Standard deviations of the angles, from the adjustment and by the jackknife"),
    (Column("name", ""), *angle_columns("values", DEGREES)),
)
