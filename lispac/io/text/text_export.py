"""Writing of points and trajectories as text for other programs, with units in the header."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error
from lispac.survey.crs import CoordinateSystem
from lispac.survey.time_base import TIME_BASE_KEYS
from lispac.survey.trajectory import Trajectory
from lispac.untrusted_values import as_csv_cell

TRAJECTORY_HEADER = (
    "# Trajectory written by LISPAC.",
    "# Time as in the source; latitude and longitude in degrees, height in metres above the "
    "ellipsoid;",
    "# roll positive starboard down, pitch positive bow up, heading clockwise from true north, in "
    "degrees (Applanix).",
    "time latitude longitude height roll pitch heading",
)
"""Lines above the numbers; the last one has the column names of `ascii_trajectory`."""
TIME_BASE_LABEL = " Time base: "
"""Text at the end of the first line, followed by the key of the time base, if it is known."""
TRAJECTORY_OPTIONS = {
    "columns": TRAJECTORY_HEADER[-1], "position": "degrees", "attitude": "degrees",
    "roll": "starboard-down", "pitch": "bow-up", "heading": "true",
}  # fmt: skip
"""Options of `lispac.io.trajectory.ascii_trajectory` to read an exported trajectory."""

LINE_AND_TIME_COLUMNS = ("line", "time (s)")
SCANNER_COLUMN_NAMES = ("x lidar (m)", "y lidar (m)", "z lidar (m)")
"""Column names of an exported target, by which `lispac.io.text.target_points` recognises it."""


def options_in_header(lines: Sequence[str]) -> dict[str, str]:
    """Options to read a trajectory that this program has written; empty for another file.

    Parameters
    ----------
    lines : sequence of str
        First lines of the file.
    """
    if not lines or not lines[0].startswith(TRAJECTORY_HEADER[0]):
        return {}
    base = lines[0].strip().rpartition(TIME_BASE_LABEL)[2]
    return TRAJECTORY_OPTIONS | ({"time": base} if base in TIME_BASE_KEYS else {})


def write_table(
    path: Path, names: Sequence[str], columns: Sequence[NDArray[Any]], formats: Sequence[str]
) -> None:
    """Write columns as CSV with a header row.

    Parameters
    ----------
    names : sequence of str
        Column names with units, without commas or quotes.
    columns : sequence of ndarray of shape (n,)
        Numbers or text.
    formats : sequence of str
        Python format specification of each column: ``.4f``, ``d``, ``s``.

    Raises
    ------
    InputError
        If a name or text contains characters that would separate columns or rows in CSV.
    """
    texts = [name for name in names] + [
        str(value) for column in columns if column.dtype.kind == "U" for value in np.unique(column)
    ]
    for text in texts:
        if any(character in text for character in ',"\n\r'):
            raise InputError(error("text.not_for_csv", file=path.name, text=text))
    shown = [np.array([as_csv_cell(v) for v in c]) if c.dtype.kind == "U" else c for c in columns]
    row = ",".join("{:" + form + "}" for form in formats) + "\n"
    with path.open("w", encoding="utf-8", errors="replace", newline="") as file:
        file.write(",".join(names) + "\n")
        file.writelines(row.format(*values) for values in zip(*shown, strict=True))


def coordinate_names(system: CoordinateSystem | None) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of the coordinates of a system with their units, and formats for 0.1 mm."""
    if system is None:
        return ("north (m)", "west (m)", "up (m)"), (".4f", ".4f", ".4f")
    code = system.crs.to_epsg()
    epsg_label = f" EPSG:{code}" if code else ""
    height_unit = system.height.rpartition("(")[2].rstrip(")")
    if system.is_geographic:
        names = (
            f"longitude{epsg_label} (deg)",
            f"latitude{epsg_label} (deg)",
            f"height ({height_unit})",
        )
        return names, (".9f", ".9f", ".4f")
    if system.crs.is_geocentric:
        return (f"X{epsg_label} (m)", f"Y{epsg_label} (m)", f"Z{epsg_label} (m)"), (
            ".4f",
            ".4f",
            ".4f",
        )
    names = (
        f"east{epsg_label} ({system.unit})",
        f"north{epsg_label} ({system.unit})",
        f"height ({height_unit})",
    )
    return names, (".4f", ".4f", ".4f")


def write_trajectory_text(path: Path, trajectory: Trajectory, time_base: str = "") -> None:
    """Write a trajectory as text in degrees and metres with Applanix's signs, as the header states.

    Positions are written to 0.01 mm, attitudes to 1e-9 deg.

    Parameters
    ----------
    time_base : str
        Key of the time base; empty if it is not known.
    """
    signs = np.array([1.0, -1.0, 1.0])  # pitch is positive bow down in the program
    attitude = np.degrees(trajectory.attitude * signs)
    attitude[:, 2] %= 360
    rows = np.column_stack(
        [
            trajectory.time,
            np.degrees(trajectory.latitude),
            np.degrees(trajectory.longitude_within_half_turn),
            trajectory.height,
            attitude,
        ]
    )
    with path.open("w", encoding="utf-8", errors="replace", newline="\n") as file:
        first, *others = TRAJECTORY_HEADER
        base = f"{TIME_BASE_LABEL}{time_base}" if time_base else ""
        file.write("\n".join([first + base, *others]) + "\n")
        np.savetxt(file, rows, fmt="%.9f %.11f %.11f %.5f %.9f %.9f %.9f")
