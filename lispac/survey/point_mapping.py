"""Fast conversion between scanner coordinates and map coordinates.

PROJ is used to fit and check a `SmoothMap` around the trajectory. Points that it does not cover,
beyond the range of the scanner or at the cell boundaries of a geoid grid, are converted by PROJ
individually. All results agree with PROJ within `MAP_ACCURACY_M`.
"""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from threading import Lock
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.survey import kernels
from lispac.survey.crs import CoordinateSystem
from lispac.survey.georeferencing import Mounting, kernel_arguments, outside_trajectory_error
from lispac.survey.smooth_map import SmoothMap, fit_smooth_map
from lispac.survey.trajectory import LocalTrajectory

Array = NDArray[np.float64]

PIECE_POINTS = 1 << 17
"""Number of points that a thread processes at a time."""
MIN_FIT_REACH_M, MAX_FIT_REACH_M = 512.0, 8192.0
"""Smallest and largest distance from the trajectory for which polynomials are fitted."""


class ScannerPointConverter:
    """Converts points between the frame of a scanner and a coordinate system.

    Threads may share a converter. The polynomials can also be used with another mounting; see
    `with_mounting`.

    Parameters
    ----------
    system : CoordinateSystem or None
        None for the local frame itself.
    trajectory : LocalTrajectory
    mounting : Mounting
    """

    def __init__(
        self, system: CoordinateSystem | None, trajectory: LocalTrajectory, mounting: Mounting
    ) -> None:
        self.system = system
        self.trajectory = trajectory
        self.mounting = mounting
        self._arguments = kernel_arguments(trajectory, mounting)
        self._fits = _FittedMaps(system, trajectory) if system is not None else None

    def with_mounting(self, mounting: Mounting) -> "ScannerPointConverter":
        """Conversion with another mounting."""
        other = ScannerPointConverter(None, self.trajectory, mounting)
        other.system, other._fits = self.system, self._fits
        return other

    @property
    def centre(self) -> Array:
        """Middle of the trajectory in the coordinate system, shape (3,)."""
        position = self.trajectory.position
        middle = (position.min(axis=0) + position.max(axis=0)) / 2
        if self.system is None:
            return np.asarray(middle)
        return self.system.from_local(middle[None, :], self.trajectory.frame)[0]

    def fit_to(self, points_lidar: Array) -> SmoothMap | None:
        """Polynomials for points with these ranges; None for the local frame.

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        """
        if self._fits is None:
            return None
        farthest = float(np.sqrt(kernels.bounds_and_reach(points_lidar)[2]))
        lever = float(np.linalg.norm(self.mounting.lever_arm))
        return self._fits.to_map(farthest + lever + abs(self.mounting.range_offset))

    def to_map(self, points_lidar: Array, time: Array, *, threads: int | None = None) -> Array:
        """Georeference points, shape (n, 3), in the unit and axes of ``system``.

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        time : ndarray of shape (n,), seconds, in the trajectory's time base
        threads : int, optional
            By default all cores.

        Raises
        ------
        InputError
            If a time lies outside the trajectory or a point outside the coordinate system.
        """
        points_lidar = np.ascontiguousarray(self.mounting.corrected(points_lidar), dtype=float)
        time = np.ascontiguousarray(time, dtype=float)
        points = np.empty_like(points_lidar)
        fit = self.fit_to(points_lidar)

        def run(start: int) -> None:
            rows = slice(start, start + PIECE_POINTS)
            if fit is None:
                good = kernels.georeference_in_place(
                    points_lidar[rows], time[rows], *self._arguments, points[rows]
                )
                self._require_inside_trajectory(bool(good), time[rows])
                return
            missed = np.zeros(len(time[rows]), dtype=np.bool_)
            count = kernels.georeference_to_map(
                points_lidar[rows], time[rows], *self._arguments, *fit.tables, points[rows], missed
            )
            self._require_inside_trajectory(count >= 0, time[rows])
            if count and self.system is not None:
                exact = self.system.from_local(points[rows][missed], self.trajectory.frame)
                points[rows][missed] = exact

        _run_in_parallel(run, len(time), threads)
        return points

    def to_scanner(
        self, points_map: Array, time: Array, *, threads: int | None = None, strict: bool = True
    ) -> Array:
        """The inverse of `to_map`, shape (n, 3), metres, LiDAR frame.

        Parameters
        ----------
        strict : bool
            Whether points outside the coordinate system raise an error; otherwise their results
            are not finite.

        Raises
        ------
        InputError
            See `to_map`.
        """
        points = np.array(points_map, dtype=float, order="C")
        time = np.ascontiguousarray(time, dtype=float)
        fit = self._fits.to_local(points) if self._fits is not None else None

        def run(start: int) -> None:
            rows = slice(start, start + PIECE_POINTS)
            piece = points[rows]
            if fit is not None and self.system is not None:
                missed = fit.apply(piece)
                if missed.any():
                    piece[missed] = self.system.to_local(
                        piece[missed], self.trajectory.frame, strict=strict
                    )
            good = kernels.to_scanner_in_place(piece, time[rows], *self._arguments, piece)
            self._require_inside_trajectory(bool(good), time[rows])

        _run_in_parallel(run, len(time), threads)
        return np.asarray(self.mounting.raw_points(points))

    def _require_inside_trajectory(self, inside: bool, time: Array) -> None:
        if not inside:
            raise outside_trajectory_error(time + self.mounting.latency, self.trajectory)


class _FittedMaps:
    """Polynomials for the surroundings of a trajectory, fitted on demand and cached."""

    def __init__(self, system: CoordinateSystem, trajectory: LocalTrajectory) -> None:
        self._system = system
        self._frame = trajectory.frame
        self._low = trajectory.position.min(axis=0)
        self._high = trajectory.position.max(axis=0)
        self._lock = Lock()
        self._forward: dict[float, SmoothMap] = {}
        self._backward: dict[float, SmoothMap] = {}

    def to_map(self, reach: float) -> SmoothMap:
        """Local frame to map, within ``reach`` metres of the trajectory."""
        with self._lock:
            known = [each for each in self._forward if each >= min(reach, MAX_FIT_REACH_M)]
            if known:
                return self._forward[min(known)]
            needed_reach = _next_standard_reach(reach)
            self._forward[needed_reach] = fit_smooth_map(
                lambda local: self._system.from_local(local, self._frame, strict=False),
                self._low - needed_reach,
                self._high + needed_reach,
                metres_in=np.ones(3),
                metres_out=np.array(self._system.metres),
            )
            return self._forward[needed_reach]

    def to_local(self, points_map: Array) -> SmoothMap:
        """Map to local frame, around the trajectory and, if not too far away, these points."""
        low, high, _ = kernels.bounds_and_reach(points_map)
        with self._lock:
            for known_reach in sorted(self._backward):
                if self._backward[known_reach].covers(low, high) or known_reach >= MAX_FIT_REACH_M:
                    return self._backward[known_reach]
            reach = 2 * max(self._backward) if self._backward else MIN_FIT_REACH_M
            while True:
                self._backward[reach] = fit = self._fit_map_to_local(reach)
                if fit.covers(low, high) or reach >= MAX_FIT_REACH_M or not len(points_map):
                    return fit
                reach *= 2

    def _fit_map_to_local(self, reach: float) -> SmoothMap:
        low, high = self._low - reach, self._high + reach
        shares = product(np.linspace(0, 1, 7), repeat=3)
        places = low + np.array(list(shares)) * (high - low)
        on_map = self._system.from_local(places, self._frame, strict=False)
        on_map = on_map[np.isfinite(on_map).all(axis=1)]
        if not len(on_map):  # the site is outside the map: the caller reports the points
            on_map = np.array([[-1.0] * 3, [1.0] * 3])  # a box, for there is no fit about a point
        return fit_smooth_map(
            lambda points: self._system.to_local(points, self._frame, strict=False),
            on_map.min(axis=0),
            on_map.max(axis=0),
            metres_in=np.array(self._system.metres),
            metres_out=np.ones(3),
        )


def _next_standard_reach(reach: float) -> float:
    standard = MIN_FIT_REACH_M
    while standard < min(reach, MAX_FIT_REACH_M):
        standard *= 2
    return standard


def _run_in_parallel(run: Callable[[int], Any], count: int, threads: int | None) -> None:
    starts = range(0, count, PIECE_POINTS)
    if len(starts) <= 1 or threads == 1:
        for start in starts:
            run(start)
        return
    with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
        for _ in pool.map(run, starts):
            pass
