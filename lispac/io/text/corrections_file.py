"""Text file of the corrections of a trajectory."""

from pathlib import Path

import numpy as np

from lispac.adjustment.model.pos_corrections import CorrectionsAtTimes, PosCorrections
from lispac.survey.line_source import printable
from lispac.version import __version__

TO_APPLANIX_AXES = np.array([1.0, -1.0, -1.0, 1.0, -1.0, 1.0])
"""Factors from north, west, up, roll, pitch (bow down) and heading to north, east, down, roll,
pitch (bow up) and heading."""
COMPONENT_NAMES = ("north", "east", "down", "roll", "pitch", "heading")
UNITS = ("m",) * 3 + ("deg",) * 3
COLUMN_NAMES = (
    "time (s)",
    *(f"{name} ({unit})" for name, unit in zip(COMPONENT_NAMES, UNITS, strict=True)),
    *(f"sigma {name} ({unit})" for name, unit in zip(COMPONENT_NAMES, UNITS, strict=True)),
    "supported",
)
HEADER = """\
# Corrections of the trajectory {trajectory}, written by LISPAC {version}.
# Corrected value = value of the trajectory + correction; sigma is its standard deviation after the adjustment.
# Time as in the trajectory; north, east and down along the axes of the project's local frame, in metres;
# roll positive starboard down, pitch positive bow up, heading clockwise, in degrees (Applanix).
# supported: sighted = targets were measured at this time; predicted = from the sightings before and after it;
# none = not supported by the data, the correction is zero.
# Stochastic model: first-order Gauss-Markov, correlation times {position:g} s (position), {attitude:g} s (attitude).
# Not corrected, because the data do not determine it: {omitted}
"""  # noqa: E501 - lines of the file
"""Lines above the table."""
INTERVAL = "# Sighted interval: {:.3f} to {:.3f} s\n"
ROW = "{:.6f}" + ",{:.6f},{:.6f},{:.6f},{:.8f},{:.8f},{:.8f}" * 2 + ",{}\n"


def write_corrections(
    path: Path, corrections: CorrectionsAtTimes, estimate: PosCorrections, trajectory: str
) -> None:
    """Write corrections and their standard deviations as CSV, below lines that start with ``#``.

    These lines state the conventions, the sighted intervals and the components that are not
    corrected. Corrections are written to 0.001 mm and 1e-8 deg in Applanix's axes and signs.
    The column ``supported`` is ``sighted`` in a sighted interval, ``predicted`` elsewhere, and
    ``none`` where all corrections are zero because the data do not support them.

    Parameters
    ----------
    trajectory : str
        Name of the file of the trajectory.
    """
    signs = TO_APPLANIX_AXES * np.repeat([1.0, np.degrees(1.0)], 3)
    supported = np.where(
        corrections.sighted,
        "sighted",
        np.where(corrections.supported.any(axis=1), "predicted", "none"),
    )
    values = np.column_stack(
        [
            corrections.time,
            corrections.correction * signs + 0.0,  # no negative zeros
            corrections.sigma * np.abs(signs),
        ]
    )
    with path.open("w", encoding="utf-8", errors="replace", newline="\n") as file:
        file.write(_header(estimate, trajectory))
        file.write(",".join(COLUMN_NAMES) + "\n")
        file.writelines(
            ROW.format(*row, each) for row, each in zip(values.tolist(), supported, strict=True)
        )


def _header(estimate: PosCorrections, trajectory: str) -> str:
    names = [
        name
        for name, determined in zip(COMPONENT_NAMES, estimate.determined, strict=True)
        if not determined
    ]
    lines = HEADER.format(
        trajectory=printable(trajectory),
        version=__version__,
        position=estimate.position_time,
        attitude=estimate.attitude_time,
        omitted=", ".join(names) or "none",
    )
    intervals = (INTERVAL.format(first, last) for first, last in estimate.sighted_intervals)
    return lines + "".join(intervals)
