"""Comparison of the velocities of a text trajectory with the motion of its positions.

The velocities are not needed for the trajectory, but reveal a wrong unit or coordinate system of
the positions.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.text.text_table import parse_number, read_columns
from lispac.io.trajectory.trajectory_columns import Column
from lispac.io.trajectory.trajectory_facts import MIN_SPEED_FOR_COURSE, TrajectoryMotion
from lispac.io.units import METRES_PER_UNIT
from lispac.messages import Level, Message, Value
from lispac.survey.line_source import printable

_VELOCITY_COLUMN_NAMES = {
    "east_velocity": ("eastvelocity", "velocityeast", "eastvel", "veleast", "veast", "ve"),
    "north_velocity": ("northvelocity", "velocitynorth", "northvel", "velnorth", "vnorth", "vn"),
}
SPEED_TOLERANCE = 0.05
"""Largest accepted deviation from 1 of the median ratio of both speeds."""
FOOT_M = 0.3048
"""Metres; US survey feet do not differ within `SPEED_TOLERANCE`."""


def velocity_columns(names: Sequence[str], units: Sequence[str]) -> tuple[Column, ...]:
    """Columns of east and north velocity; empty if one is missing.

    Parameters
    ----------
    units : sequence of str
        Unit of length of each named column; empty if not known.
    """
    bare = ["".join(c for c in name.lower() if c.isalnum()) for name in names]
    found = []
    for role, known in _VELOCITY_COLUMN_NAMES.items():
        index = next((k for k, name in enumerate(bare) if name in known), None)
        if index is None:
            return ()
        found.append(Column(role, index, names[index], units[index]))
    return tuple(found)


def speed_warnings(
    path: Path,
    rows: Sequence[tuple[int, list[str]]],
    velocities: Sequence[Column],
    motion: TrajectoryMotion,
) -> tuple[Message, ...]:
    """Warning if the speed from the positions differs from the velocities of the same rows."""
    if not velocities:
        return ()
    try:
        columns = [(column.index, parse_number, column.name) for column in velocities]
        (east, north), _ = read_columns(path, iter(rows), columns)
    except InputError:
        return ()  # columns that are not used may have any content
    factor = METRES_PER_UNIT.get(velocities[0].unit)
    recorded = np.hypot(east, north)[motion.index] * (factor or 1.0)
    moving = recorded > MIN_SPEED_FOR_COURSE
    if np.count_nonzero(moving) < 20:
        return ()
    ratio = float(np.median(motion.speed[moving] / recorded[moving]))
    by_feet = min(abs(ratio / FOOT_M - 1), abs(ratio * FOOT_M - 1)) < SPEED_TOLERANCE
    # Velocities in an unknown unit may be in knots; only feet and metres can be distinguished.
    if abs(ratio - 1) <= SPEED_TOLERANCE or (factor is None and not by_feet):
        return ()
    code = "trajectory.speed_differs_by_feet" if by_feet else "trajectory.speed_differs"
    params: dict[str, Value] = {
        "file": printable(path.name), "ratio": ratio, "east": velocities[0].name,
        "north": velocities[1].name,
    }  # fmt: skip
    return (Message(code, Level.WARNING, params),)
