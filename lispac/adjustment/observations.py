"""What goes into the adjustment: one row a point, grouped into sightings."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from lispac.errors import AdjustmentError

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Sighting:
    """One target as seen on one line."""

    target: str
    line: str


@dataclass(frozen=True, eq=False)
class Observations:
    """Nine observations a point (thesis B.3): POS position, POS attitude, LiDAR x, y, z.

    Attributes
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    position : ndarray of shape (n, 3), metres, local frame
    attitude : ndarray of shape (n, 3), radians; roll, pitch, heading
    sigma_lidar, sigma_position : ndarray of shape (n, 3), metres
        Along x, y, z and north, west, up.
    sigma_attitude : ndarray of shape (n, 3), radians
    time : ndarray of shape (n,), seconds
    sighting : ndarray of shape (n,), int
        Index into ``sightings``.
    sightings : tuple of Sighting
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

    def __len__(self) -> int:
        return len(self.time)

    @cached_property
    def targets(self) -> tuple[str, ...]:
        """Names of the targets, in the order of their first sighting."""
        return tuple(dict.fromkeys(sighting.target for sighting in self.sightings))

    @cached_property
    def target_of_sighting(self) -> NDArray[np.int64]:
        """Index into ``targets`` for each sighting, shape (sightings,)."""
        return np.array([self.targets.index(s.target) for s in self.sightings], dtype=np.int64)

    @cached_property
    def counts(self) -> NDArray[np.int64]:
        """Points of each sighting, shape (sightings,)."""
        return np.bincount(self.sighting, minlength=len(self.sightings)).astype(np.int64)

    def mean_by_sighting(self, values: Array) -> Array:
        """Mean of per-point ``values``, shape (n,) or (n, m), over each sighting."""
        columns = values.reshape(len(self), -1).T
        sums = [np.bincount(self.sighting, column, len(self.sightings)) for column in columns]
        means = np.stack(sums, axis=-1) / self.counts[:, None]
        return means[:, 0] if values.ndim == 1 else means

    def require_usable(self) -> None:
        """Refuse what cannot determine a boresight, with the reason.

        Raises
        ------
        AdjustmentError
        """
        if not self.sightings:
            raise AdjustmentError("There is no target to adjust; pick planar targets first.")
        for sighting, count in zip(self.sightings, self.counts, strict=True):
            if count < 3:
                raise AdjustmentError(
                    f"Target {sighting.target} has only {count} points on line {sighting.line}; "
                    "a plane needs at least three: pick it again or leave that line out."
                )
        for name, sigma in (
            ("LiDAR", self.sigma_lidar),
            ("position", self.sigma_position),
            ("attitude", self.sigma_attitude),
        ):
            if not (np.isfinite(sigma).all() and (sigma >= 0).all()):
                raise AdjustmentError(f"A {name} sigma is negative or not a number; correct it.")
        if not (self.sigma_lidar > 0).all():
            raise AdjustmentError("The LiDAR sigma must be larger than zero; correct it.")
