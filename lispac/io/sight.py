"""What a look at the first points of a file tells, and the doubts that numbers alone can raise."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.points import COARSEST_TIME, GEOREFERENCED, NO_SYSTEM, SCANNER, coarseness
from lispac.survey.crs import ELLIPSOID, coordinate_system
from lispac.survey.time_quality import time_quality
from lispac.survey.time_restart import counted_on, restart_of

Array = NDArray[np.float64]

FAR = 1000.0
"""Metres beyond which a vessel's scanner hardly sees."""
MANY, TYPICAL = 100, 0.99
"""Points from which on the farthest are not looked at, and the share that is."""


@dataclass(frozen=True)
class Sight:
    """What a look at the first points tells; see `sight`.

    Attributes
    ----------
    frame : str
    facts : dict
    doubts : tuple of str
    """

    frame: str
    facts: dict[str, str]
    doubts: tuple[str, ...]


def sight(
    xyz: Array, time: NDArray[Any], *, crs: str, low: Array | None = None, high: Array | None = None
) -> Sight:
    """Judge a file by its first points.

    Parameters
    ----------
    xyz : ndarray of shape (n, 3), frame and unit of the file
    time : ndarray of shape (n,), seconds
    crs : str
        What the file says of its coordinate system; empty where nothing.
    low, high : ndarray of shape (3,), frame and unit of the file
        Bounds the header states, where it does.
    """
    doubts: list[str] = []
    is_filled = (xyz[:, 0] == xyz[:, 1]) & (xyz[:, 1] == xyz[:, 2])  # no echo: 0 or -9999 say
    if is_filled.any() and not is_filled.all():
        xyz, time, low, high = xyz[~is_filled], time[~is_filled], None, None
    low = xyz.min(axis=0) if low is None else low
    high = xyz.max(axis=0) if high is None else high
    facts = {
        f"{axis} from, to": f"{low[i]:,.3f}, {high[i]:,.3f}" for i, axis in enumerate("xyz")
    } | {"time from, to": f"{time.min():.6f}, {time.max():.6f} s (first {len(time):,} points)"}
    if len(xyz) >= MANY:  # single absurd points do not tell the frame
        distance = np.linalg.norm(xyz, axis=1)
        usual = xyz[(distance <= np.quantile(distance, TYPICAL)) & (distance > 0)]
        if len(usual) and np.linalg.norm(usual, axis=1).max() < FAR:
            low, high = usual.min(axis=0), usual.max(axis=0)
    farthest = float(np.linalg.norm(np.maximum(np.abs(low), np.abs(high))))
    size = float(np.linalg.norm(high - low))
    away = float(np.linalg.norm(np.maximum(0, np.maximum(low, -high))))
    on_map = bool(crs) or farthest > 10 * FAR
    if on_map and not crs:
        doubts.append(
            f"Coordinates up to {farthest:,.0f} are too large for the scanner frame and the file "
            f"{NO_SYSTEM}: give its EPSG code."
        )
        if away == 0 and farthest < 1000 * FAR:
            doubts.append(
                "The points lie all around the origin, as a scanner's do: where these are "
                "millimetres, choose the scanner frame and that unit."
            )
    elif crs and farthest < FAR and not _is_geographic(crs):
        doubts.append(
            "The file names a coordinate system, but its coordinates are small enough for the "
            "scanner frame: check which it is."
        )
    elif not on_map and farthest > FAR:
        doubts.append(
            f"Points lie up to {farthest:,.0f} from the origin, farther than a vessel's scanner "
            "sees: check the frame and the unit (feet, millimetres?)."
        )
    elif not on_map and away > max(3 * size, 200.0):
        doubts.append(
            f"All points lie {away:,.0f} or more from the origin, so it is hardly the scanner: "
            "check the frame."
        )
    elif len(xyz) > 100 and _looks_geographic(low, high) and (high - low)[:2].max() < 0.02:
        doubts.append(
            "The first two coordinates vary by less than 0.02: these may be degrees of longitude "
            "and latitude; check the frame."
        )
    return Sight(
        GEOREFERENCED if on_map else SCANNER, facts, (*doubts, *_time_doubts(time, len(xyz)))
    )


def _time_doubts(time: NDArray[Any], count: int) -> tuple[str, ...]:
    """Doubts about ``time`` (n,), seconds as stored."""
    doubts = []
    step = coarseness(time)
    hidden = time_quality(time).resolution if time.dtype == np.float64 and count > 100 else None
    if step > COARSEST_TIME / 10:
        doubts.append(f"Times are stored with 32 bits, in steps of {step:.3g} s: export with 64.")
    elif hidden is not None and hidden > COARSEST_TIME:
        doubts.append(
            f"Times look as if they had passed through 32 bits (steps of {hidden:.3g} s): "
            "points may be put on the wrong pose; export with 64-bit time."
        )
    if np.issubdtype(time.dtype, np.integer):
        doubts.append("Times are whole numbers: check their unit.")
    elif count > 1 and (time == time[0]).all():
        doubts.append("All points looked at share one time: the file may hold no times.")
    whole = time.astype(np.float64)
    backward = int(np.count_nonzero(np.diff(counted_on(whole, restart_of(whole))) < 0))
    if backward:
        doubts.append(
            f"Times run backward {backward:,} times in the first {count:,} points; "
            "points are taken in the order of the file."
        )
    return tuple(doubts)


def _looks_geographic(low: Array, high: Array) -> bool:
    return bool(abs(low[:2]).max() <= 360 and abs(high[:2]).max() <= 360)


def _is_geographic(crs: str) -> bool:
    try:
        return coordinate_system(crs, height=ELLIPSOID).is_geographic
    except InputError:
        return False
