"""Surveyed control: points on targets and centres of spheres, with their covariance.

Control enters the adjustment as observations with their own covariance, like the points of a
weighted datum (Caspary 1987).
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from lispac.errors import AdjustmentError
from lispac.messages import error

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Control:
    """Surveyed points that lie on a target or are the centre of a sphere.

    Attributes
    ----------
    names : tuple of str
    targets : tuple of str
        Target of each point.
    positions : ndarray of shape (n, 3), metres, local frame
    is_centre : ndarray of shape (n,), bool
        Whether each point is the centre of a sphere instead of a point on the surface.
    covariance : ndarray of shape (3 n, 3 n), square metres, local frame
        Covariance of all coordinates, point by point.
    sources : tuple of str
        Survey, such as a file, from which each point comes. The points of one source may have a
        common error.
    """

    names: tuple[str, ...]
    targets: tuple[str, ...]
    positions: Array
    is_centre: NDArray[np.bool_]
    covariance: Array
    sources: tuple[str, ...]

    @classmethod
    def of(
        cls,
        names: Sequence[str],
        targets: Sequence[str],
        positions: Array,
        covariances: Array,
        *,
        is_centre: NDArray[np.bool_] | None = None,
        sources: Sequence[str] | None = None,
        common_sigmas: Mapping[str, float] | None = None,
    ) -> "Control":
        """Create control whose points have only a common translation of their source in common.

        Parameters
        ----------
        positions : ndarray of shape (n, 3), metres, local frame
        covariances : ndarray of shape (n, 3, 3), square metres, local frame
            Covariance of each point without the common error.
        is_centre : ndarray of shape (n,), bool, optional
            By default, all points lie on surfaces.
        sources : sequence of str, optional
            By default, all points have one source without a name.
        common_sigmas : mapping of str to float, metres, optional
            Standard deviation, on each axis, of the translation that all points of a source share;
            0 by default.
        """
        count = len(names)
        origin = tuple(sources) if sources is not None else ("",) * count
        covariance = np.zeros((count, 3, count, 3))
        each = np.arange(count)
        covariance[each, :, each, :] = covariances
        for source, sigma in (common_sigmas or {}).items():
            own = np.array(origin) == source
            shared = np.outer(own, own)[:, None, :, None] * np.eye(3)[None, :, None, :]
            covariance += sigma**2 * shared
        centres = np.zeros(count, dtype=bool) if is_centre is None else np.asarray(is_centre)
        return cls(
            tuple(names), tuple(targets), np.array(positions, dtype=float).reshape(-1, 3), centres,
            covariance.reshape(3 * count, 3 * count), origin,
        )  # fmt: skip

    def __len__(self) -> int:
        return len(self.names)

    @cached_property
    def sigmas(self) -> Array:
        """Standard deviations of the coordinates, shape (n, 3), metres."""
        return np.sqrt(np.diag(self.covariance)).reshape(-1, 3)

    def where(self, keep: NDArray[np.bool_]) -> "Control":
        """Points selected by ``keep``, shape (n,)."""
        own = np.flatnonzero(keep)
        coordinates = (3 * own[:, None] + np.arange(3)).reshape(-1)
        return Control(
            tuple(self.names[k] for k in own),
            tuple(self.targets[k] for k in own),
            self.positions[own],
            self.is_centre[own],
            self.covariance[np.ix_(coordinates, coordinates)],
            tuple(self.sources[k] for k in own),
        )

    def require_usable(self, spheres: Collection[str]) -> None:
        """Raise an error if a coordinate or a standard deviation is not valid.

        Parameters
        ----------
        spheres : collection of str
            Names of the targets that are spheres.

        Raises
        ------
        AdjustmentError
            The position or the standard deviation of a point is not valid, or a point is the centre
            of a target that is not a sphere.
        """
        for k, name in enumerate(self.names):
            sigmas = self.sigmas[k]
            if not np.isfinite(self.positions[k]).all():
                raise AdjustmentError(error("control.position_not_finite", name=name))
            if not (np.isfinite(sigmas).all() and (sigmas > 0).all()):
                raise AdjustmentError(error("control.sigma_not_positive", name=name))
            if self.is_centre[k] and self.targets[k] not in spheres:
                raise AdjustmentError(
                    error("control.centre_of_plane", name=name, target=self.targets[k])
                )


def plane_points(centre: Array, axes: Array, moments: Array) -> Array:
    """Three points that represent a fitted plane, shape (3, 3), metres, local frame.

    With independent errors of ``sigma * sqrt(3 / n)`` along the normal, where ``sigma`` is the
    noise of the ``n`` fitted points, they have the covariance of the fit: they have the same
    centroid, and the same second moments per point, as the fitted points.

    Parameters
    ----------
    centre : ndarray of shape (3,), metres, local frame
        Centroid of the fitted points.
    axes : ndarray of shape (2, 3), unit vectors, local frame
        Principal axes of the fitted points in the plane.
    moments : ndarray of shape (2,), square metres
        Mean squared distances of the fitted points from the centroid along the axes.
    """
    turns = np.radians([90.0, 210.0, 330.0])
    unit = np.sqrt(2.0) * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return np.asarray(centre + (unit * np.sqrt(moments)) @ axes)
