"""Lines as text: one point a row, columns named by the user."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.files import require_file
from lispac.io.las import require_finite
from lispac.io.text_table import clock, is_clock
from lispac.survey.scan import Scan

REQUIRED = ("time", "x", "y", "z")
ASSUMPTIONS = ("text coordinates are metres in the LiDAR frame",)


def read_text_scan(path: Path, columns: Sequence[str]) -> Scan:
    """Read one line from a text file, separated by blanks, tabs, commas or semicolons.

    Parameters
    ----------
    columns : sequence of str
        Name of each column from the left: ``time``, ``x``, ``y``, ``z`` are needed, ``intensity``
        is used, any other name (``-``, say) passes a column over. Rows that start with ``#``, and
        a first row of names, are passed over. The time may be seconds, or as hh:mm:ss.

    Raises
    ------
    InputError
        Where a column is missing or a row is not numbers.
    """
    path = require_file(Path(path), "text")
    names = [name.strip().lower() for name in columns]
    missing = [name for name in REQUIRED if name not in names]
    if missing:
        raise InputError(
            f"{path}: the column names given ({', '.join(names) or 'none'}) lack "
            f"{', '.join(missing)}; name every column of the file from the left."
        )
    twice = sorted(
        {name for name in names if name in (*REQUIRED, "intensity") and names.count(name) > 1}
    )
    if twice:
        raise InputError(f"{path}: two columns are named {', '.join(twice)}; name each once.")
    wanted = [name for name in (*REQUIRED, "intensity") if name in names]
    indices = [names.index(name) for name in wanted]
    rows: list[list[float]] = []
    at = names.index("time")
    with path.open(encoding="utf-8-sig", errors="replace") as lines:
        for number, line in enumerate(lines, start=1):
            fields = line.replace(",", " ").replace(";", " ").split()
            if not fields or fields[0].startswith("#"):
                continue
            if len(fields) < len(names):
                raise InputError(
                    f"{path}, row {number:,}: {len(fields)} columns where {len(names)} were named "
                    f"({', '.join(names)}); copy or export it again where it is cut short, or "
                    "name the columns the file has."
                )
            try:
                rows.append([_value(fields[index], index == at) for index in indices])
            except ValueError as error:
                if not rows and not any(character.isdigit() for character in fields[0]):
                    continue  # a row of names
                raise InputError(
                    f"{path}, row {number:,}: {error}; rows must be numbers."
                ) from error
    if not rows:
        raise InputError(f"{path}: this line holds no points; leave it out.")
    table = np.array(rows)
    points, time = np.ascontiguousarray(table[:, 1:4]), table[:, 0].copy()
    require_finite(points, time, path)
    return Scan(points, time, table[:, 4].copy() if len(wanted) > 4 else None, ASSUMPTIONS)


def _value(field: str, is_time: bool) -> float:
    return clock(field) if is_time and is_clock(field) else float(field)
