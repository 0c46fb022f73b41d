"""Observations of the adjustment: one row per point, grouped into sightings."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.control import Control
from lispac.adjustment.model.threads import run_over_points
from lispac.compiled_code import kernel
from lispac.errors import AdjustmentError
from lispac.messages import error

Array = NDArray[np.float64]

MIN_SAMPLED_POINTS = 200  # a sighting with fewer points in a sample keeps all its points


@dataclass(frozen=True)
class Sighting:
    """Sighting of a target: the points of one target in one line."""

    target: str
    line: str


@dataclass(frozen=True)
class CommonCoverage:
    """Common part of a target of which the lines show different parts; only this part is used.

    Attributes
    ----------
    target : str
    share : float
        Share of the target's points in the common part; 0 if the target is excluded.
    lines : tuple of str
        Lines whose sightings are used.
    """

    target: str
    share: float
    lines: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Observations:
    """Nine observations per point (thesis B.3): POS position, POS attitude, LiDAR x, y, z.

    Attributes
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    position : ndarray of shape (n, 3), metres, local frame
    attitude : ndarray of shape (n, 3), radians; roll, pitch, heading
    sigma_lidar, sigma_position : ndarray of shape (n, 3), metres
        Standard deviations along x, y, z and along north, west, up.
    sigma_attitude : ndarray of shape (n, 3), radians
    time : ndarray of shape (n,), seconds
    sighting : ndarray of shape (n,), int
        Index into ``sightings``.
    sightings : tuple of Sighting
    beam_sigmas : bool
        Whether the columns of ``sigma_lidar`` are along the beam and in two directions across it,
        instead of along x, y, z.
    pose_rate : ndarray of shape (n, 6) or None, metres and radians per second
        Derivative of position and attitude by time, needed to estimate the latency.
    latency : float, seconds
        Latency that is already applied to ``position`` and ``attitude``.
    radii : mapping of str to float or None
        Radius in metres of each target that is a sphere, None if unknown; other targets are planes.
    time_separation : ndarray of shape (n,) or None, seconds
        Mean time between two of the points averaged into one; None for single points.
    excluded_outliers : int
        Number of points that are outliers of their sighting and were excluded before averaging.
    origins : mapping of str to ndarray of shape (3,), metres, local frame
        Origin of the coordinates of each target in the condition equations, zero if not given.
        ``position`` is not relative to it, because a relative copy would need as much memory.
    control : Control or None
        Surveyed points on the targets; those of targets without points are not used.
    """

    points_lidar: Array
    position: Array
    attitude: Array
    sigma_lidar: Array
    sigma_position: Array
    sigma_attitude: Array
    time: Array
    sighting: NDArray[np.int64]
    sightings: tuple[Sighting, ...]
    beam_sigmas: bool = False
    pose_rate: Array | None = None
    latency: float = 0.0
    radii: Mapping[str, float | None] = field(default_factory=dict)
    excluded_outliers: int = 0
    time_separation: Array | None = None
    origins: Mapping[str, Array] = field(default_factory=dict)
    control: Control | None = None

    def __len__(self) -> int:
        return len(self.time)

    @cached_property
    def targets(self) -> tuple[str, ...]:
        """Names of the targets, in the order of their first sighting."""
        return tuple(dict.fromkeys(sighting.target for sighting in self.sightings))

    @cached_property
    def target_of_sighting(self) -> NDArray[np.int64]:
        """Index into ``targets`` for each sighting, shape (sightings,)."""
        number = {target: k for k, target in enumerate(self.targets)}
        return np.array([number[s.target] for s in self.sightings], dtype=np.int64)

    @cached_property
    def lines(self) -> tuple[str, ...]:
        """Names of the lines, in the order of their first sighting."""
        return tuple(dict.fromkeys(sighting.line for sighting in self.sightings))

    @cached_property
    def is_sphere(self) -> NDArray[np.bool_]:
        """Whether each target is a sphere, shape (targets,)."""
        return np.array([target in self.radii for target in self.targets], dtype=bool)

    def with_scaled_sigmas(self, lidar: float, position: float, attitude: float) -> "Observations":
        """Observations with factors applied to the given sigmas.

        Parameters
        ----------
        lidar, position, attitude : float
            Factors, no unit.
        """
        if lidar == position == attitude == 1.0:
            return self
        return replace(
            self,
            sigma_lidar=lidar * self.sigma_lidar,
            sigma_position=position * self.sigma_position,
            sigma_attitude=attitude * self.sigma_attitude,
        )

    def as_planes(self) -> "Observations":
        """Observations with every target treated as a plane."""
        return replace(self, radii={}) if self.radii else self

    def reordered(self, order: NDArray[np.int64]) -> "Observations":
        """Points in another order, or a selection, by index (k,); ``sightings`` is unchanged."""
        columns: dict[str, Any] = {
            column.name: values.take(order, axis=0)
            for column in fields(self)
            if isinstance(values := getattr(self, column.name), np.ndarray)
        }
        return replace(self, **columns)

    def sample(self, share: float) -> NDArray[np.bool_]:
        """Mask of about this share of the points, shape (n,), independent of their order."""
        bits = np.ascontiguousarray(self.points_lidar).view(np.uint64)
        mixed = bits[:, 0] ^ (bits[:, 1] << np.uint64(1)) ^ (bits[:, 2] << np.uint64(2))
        mixed = (mixed ^ (mixed >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
        mixed = (mixed ^ (mixed >> np.uint64(32))) * np.uint64(0x94D049BB133111EB)
        chosen = (mixed >> np.uint64(40)).astype(np.float64) < share * 2**24
        # A sighting with few points keeps all of them.
        scarce = (
            np.bincount(self.sighting[chosen], minlength=len(self.sightings)) < MIN_SAMPLED_POINTS
        )
        return np.asarray(chosen | scarce[self.sighting])

    def where(self, keep: NDArray[np.bool_]) -> "Observations":
        """Points selected by ``keep``, shape (n,); sightings without points are dropped."""
        part = self.reordered(np.flatnonzero(keep))
        kept = np.unique(part.sighting)
        return replace(
            part,
            sighting=np.searchsorted(kept, part.sighting),
            sightings=tuple(self.sightings[k] for k in kept),
        )

    def of_sightings(self, keep: NDArray[np.bool_]) -> "Observations":
        """Points of the sightings selected by ``keep``, shape (sightings,)."""
        return self.where(keep[self.sighting])

    def without_targets(self, names: Collection[str]) -> "Observations":
        """Observations without the targets of these names."""
        if not names:
            return self
        return self.of_sightings(np.array([s.target not in names for s in self.sightings]))

    @property
    def with_own_control(self) -> "Observations":
        """Observations with the control of their targets only; without control if there is none."""
        if self.control is None:
            return self
        keep = np.array([target in self.targets for target in self.control.targets], dtype=bool)
        return replace(self, control=self.control.where(keep) if keep.any() else None)

    @cached_property
    def origin_of_target(self) -> Array:
        """Origin of each target, shape (targets, 3), metres, local frame."""
        origins = [self.origins.get(target, np.zeros(3)) for target in self.targets]
        return np.reshape(np.asarray(origins, dtype=np.float64), (-1, 3))

    @cached_property
    def half_angle_tangents(self) -> Array:
        """`half_angle_tangents` of the attitude, shape (n, 3), no unit."""
        return half_angle_tangents(self.attitude)

    @cached_property
    def counts(self) -> NDArray[np.int64]:
        """Number of points of each sighting, shape (sightings,)."""
        return np.bincount(self.sighting, minlength=len(self.sightings)).astype(np.int64)

    def mean_by_sighting(self, values: Array) -> Array:
        """Mean of per-point ``values``, shape (n,) or (n, m), over each sighting."""
        columns = values.reshape(len(self), -1).T
        sums = [np.bincount(self.sighting, column, len(self.sightings)) for column in columns]
        means = np.stack(sums, axis=-1) / self.counts[:, None]
        return means[:, 0] if values.ndim == 1 else means

    def require_usable(self) -> None:
        """Raise an error if the observations cannot be adjusted.

        Raises
        ------
        AdjustmentError
            There is no target, a sighting has too few points, or a value is invalid.
        """
        if not self.sightings:
            raise AdjustmentError(error("adjustment.no_targets"))
        for sighting, count in zip(self.sightings, self.counts, strict=True):
            if count < 3:
                raise AdjustmentError(
                    error(
                        "adjustment.few_points",
                        target=sighting.target,
                        line=sighting.line,
                        count=count,
                    )
                )
        for code, values in (
            ("adjustment.point_not_finite", self.points_lidar),
            ("adjustment.position_not_finite", self.position),
            ("adjustment.attitude_not_finite", self.attitude),
            ("adjustment.time_not_finite", self.time),
        ):
            if not np.isfinite(values).all():
                raise AdjustmentError(error(code))
        x, y, z = self.points_lidar.T
        if not ((x != 0) | (y != 0) | (z != 0)).all():
            raise AdjustmentError(error("adjustment.point_in_scanner"))
        for code, sigma in (
            ("adjustment.sigma_lidar", self.sigma_lidar),
            ("adjustment.sigma_position", self.sigma_position),
            ("adjustment.sigma_attitude", self.sigma_attitude),
        ):
            if not (np.isfinite(sigma).all() and (sigma >= 0).all()):
                raise AdjustmentError(error(code))
        if not (self.sigma_lidar > 0).all():
            raise AdjustmentError(error("adjustment.sigma_lidar_zero"))
        if self.control is not None:
            self.control.require_usable(self.radii)


def half_angle_tangents(attitude: Array) -> Array:
    """Tangents of the halves of roll, pitch and heading.

    Cosine and sine of the angle follow from the tangent ``t`` as ``(1 - t^2) / (1 + t^2)`` and
    ``2 t / (1 + t^2)``, to the precision of a number. They need half the memory of cosines and
    sines, and a fraction of the time of trigonometric functions.

    Parameters
    ----------
    attitude : ndarray of shape (n, 3), radians

    Returns
    -------
    ndarray of shape (n, 3), no unit
    """
    tangents = np.empty((len(attitude), 3))
    run_over_points(
        lambda first, last: _fill_half_angle_tangents(first, last, attitude, tangents),
        len(attitude),
    )
    return tangents


@kernel()
def _fill_half_angle_tangents(first, last, attitude, tangents):  # type: ignore[no-untyped-def]
    for i in range(first, last):
        for k in range(3):
            tangents[i, k] = np.tan(attitude[i, k] / 2)
