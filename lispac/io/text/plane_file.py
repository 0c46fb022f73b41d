"""The 25-column plane file of the thesis prototype: one planar target, all its sightings.

Columns: key; X, Y, Z local; time; x, y, z LiDAR; roll, pitch, heading (radians) and their sigmas;
POS position local and its sigmas (north, east, vertical); plane a, b, c, d; plane number.
"""

import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations, Sighting
from lispac.errors import InputError
from lispac.io.compressed_files import require_uncompressed
from lispac.io.files import atomic_write, require_file
from lispac.messages import error

N_COLUMNS = 25
LINE_GAP_S = 10.0
"""Smallest time without points between two lines, seconds. The scanner crosses a board in about a
second, and a vessel needs longer than this to turn for the next line."""


def read_plane_files(
    paths: Sequence[Path], lidar_sigma: float, *, line_gap: float = LINE_GAP_S
) -> tuple[Observations, NDArray[np.float64]]:
    """Read plane files into observations; gaps in time separate the sightings.

    Parameters
    ----------
    lidar_sigma : float, metres, on each axis
    line_gap : float, seconds

    Returns
    -------
    observations : Observations
    planes : ndarray of shape (targets, 4)
        Initial planes in the files, local frame.

    Raises
    ------
    InputError
        If a file is missing, empty, or not 25 columns of numbers.
    """
    if not paths:
        raise InputError(error("planes.none_given"))
    tables = [read_plane_table(Path(path)) for path in paths]
    names = _distinct_names([Path(path).stem for path in paths])
    target = np.repeat(np.arange(len(tables)), [len(table) for table in tables])
    rows = np.concatenate(tables)
    line = _line_numbers(rows[:, 4], line_gap)
    groups, sighting = np.unique(np.stack([target, line]), axis=1, return_inverse=True)
    observations = Observations(
        points_lidar=np.ascontiguousarray(rows[:, 5:8]),
        position=np.ascontiguousarray(rows[:, 14:17]),
        attitude=np.ascontiguousarray(rows[:, 8:11]),
        sigma_lidar=np.full((len(rows), 3), lidar_sigma),
        sigma_position=np.ascontiguousarray(rows[:, 17:20]),
        sigma_attitude=np.ascontiguousarray(rows[:, 11:14]),
        time=rows[:, 4].copy(),
        sighting=sighting.reshape(-1).astype(np.int64),
        sightings=tuple(Sighting(names[t], f"L{n + 1}") for t, n in groups.T),
    )
    return observations, np.stack([table[0, 20:24] for table in tables])


def write_plane_file(
    path: Path,
    observations: Observations,
    target: str,
    points_local: NDArray[np.float64],
    plane: NDArray[np.float64],
) -> None:
    """Write the observations of one target as a plane file.

    Parameters
    ----------
    target : str
        One of ``observations.targets``.
    points_local : ndarray of shape (n, 3), metres, local frame
        Georeferenced points, in the order of the observations.
    plane : ndarray of shape (4,)
    """
    number = observations.targets.index(target)
    is_of_target = observations.target_of_sighting[observations.sighting] == number
    count = int(is_of_target.sum())
    rows = np.column_stack(
        [
            np.arange(count),
            points_local[is_of_target],
            observations.time[is_of_target],
            observations.points_lidar[is_of_target],
            observations.attitude[is_of_target],
            observations.sigma_attitude[is_of_target],
            observations.position[is_of_target],
            observations.sigma_position[is_of_target],
            np.tile(plane, (count, 1)),
            np.full(count, number + 1),
        ]
    )
    with atomic_write(path) as temporary:
        np.savetxt(temporary, rows, fmt="%.12f")


def read_plane_table(path: Path) -> NDArray[np.float64]:
    """Read all rows of a plane file, shape (n, 25).

    Raises
    ------
    InputError
        If the file is missing, empty, or not 25 columns of numbers with a unit normal.
    """
    require_uncompressed(require_file(path, "plane"))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # an empty file is refused below
            with path.open(encoding="utf-8-sig") as file:
                table = np.loadtxt(file, ndmin=2, delimiter="," if _has_comma(path) else None)
    except (ValueError, UnicodeDecodeError) as failure:
        raise InputError(
            error("planes.not_numbers", file=str(path), columns=N_COLUMNS, reason=str(failure))
        ) from failure
    if table.size == 0:
        raise InputError(error("planes.no_points", file=str(path)))
    if table.shape[1] != N_COLUMNS:
        raise InputError(
            error("planes.other_columns", file=str(path), columns=N_COLUMNS, found=table.shape[1])
        )
    if not np.isfinite(table).all():
        row = int(np.argmax(~np.isfinite(table).all(axis=1))) + 1
        raise InputError(error("planes.not_finite", file=str(path), row=row))
    normal = float(np.linalg.norm(table[0, 20:23]))
    if not np.isclose(normal, 1, atol=1e-3):
        raise InputError(error("planes.normal_length", file=str(path), length=normal))
    return np.asarray(table)


def _has_comma(path: Path) -> bool:
    with path.open("rb") as file:
        return b"," in file.readline()


def _distinct_names(stems: list[str]) -> list[str]:
    if len(set(stems)) == len(stems):
        return stems
    return [f"{stem}-{number}" for number, stem in enumerate(stems, start=1)]


def _line_numbers(time: NDArray[np.float64], gap: float) -> NDArray[np.int64]:
    """Line number of each point, from gaps in time; the targets of a line share its number."""
    order = np.argsort(time, kind="stable")
    number = np.empty(len(time), dtype=np.int64)
    number[order] = np.concatenate([[0], np.cumsum(np.diff(time[order]) > gap)])
    return number
