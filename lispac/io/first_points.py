"""Frame and bounds of the first points of a file, and warnings about their values."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.format_types import Fact
from lispac.io.point_reader_common import (
    CHOOSE_FRAME_ACTION,
    CHOOSE_SYSTEM_ACTION,
    COARSEST_TIME_RESOLUTION_S,
    GEOREFERENCED_FRAME,
    NO_SYSTEM_CODE,
    SCANNER_FRAME,
    time_resolution,
    usable_mask,
)
from lispac.messages import Message, note, warning
from lispac.survey.crs import ELLIPSOID_HEIGHTS, coordinate_system
from lispac.survey.point_screening import MAX_COORDINATE
from lispac.survey.time_quality import assess_times
from lispac.survey.time_rollover import find_rollover, resolve_rollover

Array = NDArray[np.float64]

USUAL_SCANNER_RANGE_M = 1000.0
"""Range that the points of a scanner on a vessel rarely exceed, metres."""
MIN_POINTS_FOR_QUANTILE, DISTANCE_QUANTILE = 100, 0.99
"""Number of points from which on the farthest are ignored, and the share that is examined."""


@dataclass(frozen=True)
class FirstPointsCheck:
    """Frame and bounds of the first points; see `check_first_points`.

    Attributes
    ----------
    frame : str
    facts : dict of str to Fact
    file_warnings : tuple of Message
    """

    frame: str
    facts: dict[str, Fact]
    file_warnings: tuple[Message, ...]


def check_first_points(
    xyz: Array,
    time: NDArray[Any],
    *,
    file: str,
    crs: str,
    low: Array | None = None,
    high: Array | None = None,
) -> FirstPointsCheck:
    """Check the frame and the numbers of the first points of a file.

    Parameters
    ----------
    xyz : ndarray of shape (n, 3), frame and unit of the file
    time : ndarray of shape (n,), seconds
    file : str
        Name of the file.
    crs : str
        Coordinate system, specified in the file or by the user; empty if none.
    low, high : ndarray of shape (3,), frame and unit of the file
        Bounds specified in the header, if any.
    """
    usable = usable_mask(xyz, time)
    if not usable.all():  # their number is reported where all points are read
        low = high = None
        if usable.any():
            xyz, time = xyz[usable], time[usable]
        else:
            xyz = np.nan_to_num(xyz).clip(-MAX_COORDINATE, MAX_COORDINATE)
    is_filled = (xyz[:, 0] == xyz[:, 1]) & (xyz[:, 1] == xyz[:, 2])  # no echo: 0 or -9999
    if is_filled.any() and not is_filled.all():
        xyz, time, low, high = xyz[~is_filled], time[~is_filled], None, None
    low = xyz.min(axis=0) if low is None else low
    high = xyz.max(axis=0) if high is None else high
    facts: dict[str, Fact] = {
        f"{axis} from, to": note("fact.interval", low=low[i], high=high[i])
        for i, axis in enumerate("xyz")
    }
    facts["time from, to"] = note("fact.times", low=time.min(), high=time.max(), count=len(time))
    if len(xyz) >= MIN_POINTS_FOR_QUANTILE:  # single outliers do not determine the frame
        distance = np.linalg.norm(xyz, axis=1)
        usual = xyz[(distance <= np.quantile(distance, DISTANCE_QUANTILE)) & (distance > 0)]
        if len(usual) and np.linalg.norm(usual, axis=1).max() < USUAL_SCANNER_RANGE_M:
            low, high = usual.min(axis=0), usual.max(axis=0)
    farthest = float(np.linalg.norm(np.maximum(np.abs(low), np.abs(high))))
    on_map = bool(crs) or farthest > 10 * USUAL_SCANNER_RANGE_M
    file_warnings = (
        *_frame_warnings(low, high, len(xyz), on_map=on_map, crs=crs, file=file),
        *_time_warnings(time, len(xyz), file),
    )
    return FirstPointsCheck(GEOREFERENCED_FRAME if on_map else SCANNER_FRAME, facts, file_warnings)


def _frame_warnings(
    low: Array, high: Array, count: int, *, on_map: bool, crs: str, file: str
) -> tuple[Message, ...]:
    """Warnings that the coordinates do not suit the frame.

    Parameters
    ----------
    low, high : ndarray of shape (3,), frame and unit of the file
        Bounds without single outliers.
    count : int
        Number of points.
    on_map : bool
        Whether the points are taken for georeferenced ones.
    """
    farthest = float(np.linalg.norm(np.maximum(np.abs(low), np.abs(high))))
    size = float(np.linalg.norm(high - low))
    away = float(np.linalg.norm(np.maximum(0, np.maximum(low, -high))))
    file_warnings: list[Message] = []
    if on_map and not crs:
        file_warnings.append(
            warning(NO_SYSTEM_CODE, file=file, largest=farthest, actions=(CHOOSE_SYSTEM_ACTION,))
        )
        if away == 0 and farthest < 1000 * USUAL_SCANNER_RANGE_M:
            file_warnings.append(
                warning("points.around_origin", file=file, actions=(CHOOSE_FRAME_ACTION,))
            )
    elif crs and farthest < USUAL_SCANNER_RANGE_M and not _is_geographic(crs):
        file_warnings.append(
            warning("points.small_coordinates", file=file, actions=(CHOOSE_FRAME_ACTION,))
        )
    elif not on_map and farthest > USUAL_SCANNER_RANGE_M:
        file_warnings.append(
            warning(
                "points.far_from_origin",
                file=file,
                distance=farthest,
                actions=(CHOOSE_FRAME_ACTION,),
            )
        )
    elif not on_map and away > max(3 * size, 200.0):
        file_warnings.append(
            warning(
                "points.away_from_origin", file=file, distance=away, actions=(CHOOSE_FRAME_ACTION,)
            )
        )
    elif count > 100 and _is_likely_geographic(low, high) and (high - low)[:2].max() < 0.02:
        file_warnings.append(warning("points.degrees", file=file, actions=(CHOOSE_FRAME_ACTION,)))
    return tuple(file_warnings)


def _time_warnings(time: NDArray[Any], count: int, file: str) -> tuple[Message, ...]:
    """Warnings about ``time`` (n,), seconds as stored."""
    file_warnings = []
    step = time_resolution(time)
    resolution = assess_times(time).resolution if time.dtype == np.float64 and count > 100 else None
    if step > COARSEST_TIME_RESOLUTION_S / 10:
        file_warnings.append(warning("times.coarse", file=file, step=step))
    elif resolution is not None and resolution > COARSEST_TIME_RESOLUTION_S:
        file_warnings.append(warning("times.coarse", file=file, step=resolution))
    if np.issubdtype(time.dtype, np.integer):
        file_warnings.append(warning("times.whole_numbers", file=file))
    elif count > 1 and (time == time[0]).all():
        file_warnings.append(warning("times.all_equal", file=file))
    whole = time.astype(np.float64)
    backward = int(np.count_nonzero(np.diff(resolve_rollover(whole, find_rollover(whole))) < 0))
    if backward:
        file_warnings.append(
            warning("times.decreasing_points", file=file, count=backward, total=count)
        )
    return tuple(file_warnings)


def _is_likely_geographic(low: Array, high: Array) -> bool:
    return bool(abs(low[:2]).max() <= 360 and abs(high[:2]).max() <= 360)


def _is_geographic(crs: str) -> bool:
    try:
        return coordinate_system(crs, height=ELLIPSOID_HEIGHTS).is_geographic
    except InputError:
        return False
