"""Values of the boresight angles, and tables with a column for each angle."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lispac.adjustment.result import (
    ANGLES,
)
from lispac.language import N_
from lispac.present.tables import (
    Column,
    Format,
    Table,
    ratio,
)
from lispac.present.text_format import VALUE_TITLES, title

ANGLE_TITLES = tuple(VALUE_TITLES[name] for name in ANGLES)

ROTATION_ENTRY = ratio(8).signed
"""Format of the entries of a rotation matrix."""


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
    """Convert three values, shape (3,), to `Angles` without changing their unit."""
    return Angles(*floats(np.asarray(values, dtype=float)))


def degrees(values: ArrayLike) -> Angles:
    """Convert angles in radians, shape (3,), to `Angles` in degrees."""
    return angles(np.degrees(values))


def degrees_or_none(values: ArrayLike | None) -> Angles | None:
    """Convert as `degrees`; return None for None."""
    return None if values is None else degrees(values)


def finite_or_none(value: float) -> float | None:
    """Return the value, or None if it is NaN or infinite, which JSON cannot represent."""
    return float(value) if math.isfinite(value) else None


def floats(values: Iterable[float]) -> tuple[float, ...]:
    """Convert to Python floats, since `json` cannot write those of NumPy."""
    return tuple(float(value) for value in values)


def matrix(rows: Iterable[Iterable[float]]) -> tuple[tuple[float, ...], ...]:
    """Convert the rows of a matrix to tuples of Python floats."""
    return tuple(map(floats, rows))


@dataclass(frozen=True)
class AnglesRow:
    """Table row with the name of a result and its values for the angles; None if unknown."""

    name: str
    values: Angles | None


def angle_columns(
    path: str, form: Format | Callable[[Any], Format], unknown: str = ""
) -> tuple[Column[Any], ...]:
    """Column for each angle.

    Parameters
    ----------
    path : str
        Path of the field of the row that contains the `Angles`.
    unknown : str
        English text for unknown values; a dash if empty.
    """
    return tuple(
        Column(f"{path}.{name}", VALUE_TITLES[name], form, unknown=unknown) for name in ANGLES
    )


CORRELATION_FORMAT = ratio(2).signed
"""Format of correlations in a figure; the table has another decimal."""
CORRELATIONS_TABLE = Table[AnglesRow](
    N_("Correlations"), (Column("name", ""), *angle_columns("values", ratio(3).signed))
)


def correlation_rows(correlation: Iterable[ArrayLike]) -> list[AnglesRow]:
    """Rows of a correlation matrix of the three angles, shape (3, 3)."""
    return [
        AnglesRow(title(name), angles(row)) for name, row in zip(ANGLES, correlation, strict=True)
    ]
