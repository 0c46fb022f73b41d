"""Signed distances between two clouds along the local normal, with confidence intervals (M3C2).

The method is that of Lague, Brodu and Leroux (2013, ISPRS Journal 82). At each core point, the
normal is computed from the reference points within a given scale. A cylinder along the normal
selects points of both clouds, and the distance is the difference between their means along the
axis. The confidence interval follows from the scatter of the points in the cylinder. Unlike the
distance to the nearest point, this distance has a sign, and noise averages out.

The interval is that of Welch (1947) for the means of two samples with unequal variances, with
Student's t, since 1.96 sigma would be too short for the few points in a cylinder. It accounts only
for the noise of the points. Errors common to all points of a line, such as POS errors, are part of
the distance itself.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.errors import InputError, NotComparable
from lispac.geometry.local_planes import local_planes_kernel
from lispac.geometry.radius_search import Cells, PointGrid, gather_within_radius
from lispac.messages import error

Array = NDArray[np.float64]

SIGMA_PER_MAD = 1.4826
"""Ratio of the standard deviation of normal noise to its median absolute deviation."""
MIN_CYLINDER_POINTS = 4
"""Smallest number of points of each cloud in a cylinder for a distance (Lague et al. 2013), and of
reference points for a normal."""


@dataclass(frozen=True, eq=False)
class NormalDistances:
    """Distances at the core points that have a distance.

    Attributes
    ----------
    cores : ndarray of shape (n, 3), metres, local frame
    distance : ndarray of shape (n,), metres
        From the reference to the compared cloud, positive in the direction of the normals.
    half_width : ndarray of shape (n,), metres
        Half the 95 % interval of each distance.
    no_distance : int
        Number of core points without a distance: too few points, or no normal.
    normals : ndarray of shape (n, 3), unit vectors, local frame
        Directions along which the distances were measured.
    at : ndarray of shape (n,), int
        Index of each of these core points among the given ones.
    """

    cores: Array
    distance: Array
    half_width: Array
    no_distance: int
    normals: Array
    at: NDArray[np.intp]

    def select_cores(self, cores: NDArray[np.intp]) -> "NormalDistances":
        """Select the distances at core points, by their numbers ``cores`` (k,), ascending."""
        return self.select_subset(np.searchsorted(self.at, cores))

    def select_subset(self, kept: NDArray[np.intp]) -> "NormalDistances":
        """Select distances by their indices ``kept``, shape (k,)."""
        return NormalDistances(
            self.cores[kept], self.distance[kept], self.half_width[kept],
            self.no_distance + len(self.at) - len(kept), self.normals[kept], self.at[kept],
        )  # fmt: skip

    @property
    def significant(self) -> float:
        """Share of the distances that differ significantly from zero at the 95 % level."""
        return float(np.mean(np.abs(self.distance) > self.half_width))


def distances_along_normal(
    compared: Array,
    reference: Array,
    cores: Array,
    *,
    facing: Array,
    normal_scale: float | Array,
    diameter: float | Array,
    depth: float | Array,
    middle: float | Array = 0.0,
    reference_depth: float | Array | None = None,
) -> NormalDistances:
    """Distance from the reference to the compared cloud at each core point.

    Parameters
    ----------
    compared, reference : ndarrays of shape (n, 3) and (m, 3), metres, same frame
    cores : ndarray of shape (k, 3), metres, local frame
        Points at which distances are measured: some of the reference points.
    facing : ndarray of shape (3,) or (k, 3)
        Direction towards which the normals are oriented, for all core points or for each.
    normal_scale : float or ndarray of shape (k,), metres
        Diameter of the sphere of reference points used for the normal.
    diameter : float or ndarray of shape (k,), metres
        Diameter of the cylinder.
    depth : float or ndarray of shape (k,), metres
        Length of the cylinder on either side of its centre.
    middle : float or ndarray of shape (k,), metres
        Position along the normal, from the core point, of the centre of the cylinder for the
        compared cloud. The cylinder for the reference is centred at the core point.
    reference_depth : float or ndarray of shape (k,), metres
        Depth of the cylinder for the reference, if it differs.

    Raises
    ------
    InputError
        If a scale, diameter or depth is not positive.
    NotComparable
        If no core point has a distance.
    """
    if reference_depth is None:
        reference_depth = depth
    _require_positive("validation.normal_scale", normal_scale)
    _require_positive("validation.cylinder_diameter", diameter)
    _require_positive("validation.cylinder_depth", depth)
    _require_positive("validation.cylinder_depth", reference_depth)
    scales, diameters, depths, middles, own_depths = (
        np.ascontiguousarray(np.broadcast_to(np.asarray(each, dtype=np.float64), len(cores)))
        for each in (normal_scale, diameter, depth, middle, reference_depth)
    )
    if not len(cores):
        raise NotComparable(error("validation.no_places"))
    # With cells as wide as the search radius, each search reads few cells.
    clouds = [
        PointGrid(points, max(float(diameters.max()), float(depths.max())) / 2).cells
        for points in (compared, reference)
    ]
    contiguous_cores = np.ascontiguousarray(cores, dtype=np.float64)
    normals = _oriented_normals(
        contiguous_cores, clouds[1], _facing_per_core(facing, len(cores)), scales / 2
    )
    samples = _cylinder_statistics(
        contiguous_cores, normals, clouds[0], clouds[1], diameters / 2, middles,
        np.column_stack([depths, own_depths]),
    )  # fmt: skip
    measured = (samples[:, :, 2] >= MIN_CYLINDER_POINTS).all(axis=1)
    if not measured.any():
        raise NotComparable(
            error(
                "validation.cylinder_too_narrow",
                needed=MIN_CYLINDER_POINTS,
                diameter=float(diameters.max()),
            )
        )
    distance, half_width = _mean_differences(samples[measured])
    return NormalDistances(
        cores[measured], distance, half_width, int(np.count_nonzero(~measured)),
        normals[measured], np.flatnonzero(measured),
    )  # fmt: skip


def _require_positive(code: str, value: float | Array) -> None:
    """Refuse values that are not positive and finite.

    Raises
    ------
    InputError
        With the message of ``code``.
    """
    values = np.asarray(value, dtype=np.float64)
    wrong = values[~((values > 0.0) & (values < np.inf))]
    if wrong.size:
        raise InputError(error(code, value=float(wrong[0])))


def reference_normals(
    reference: Array, cores: Array, facing: Array, normal_scale: float | Array
) -> Array:
    """Normals of the reference at core points, shape (k, 3), local frame; NaN where undefined.

    Parameters
    ----------
    reference, cores, facing, normal_scale
        As for `distances_along_normal`.
    """
    scales = np.ascontiguousarray(np.broadcast_to(np.asarray(normal_scale, float), len(cores)))
    cells = PointGrid(reference, float(scales.max()) / 2).cells
    cores = np.ascontiguousarray(cores, dtype=np.float64)
    return _oriented_normals(cores, cells, _facing_per_core(facing, len(cores)), scales / 2)


def _facing_per_core(facing: Array, count: int) -> Array:
    return np.ascontiguousarray(np.broadcast_to(np.asarray(facing, dtype=np.float64), (count, 3)))


@njit(nogil=True, cache=True)
def _oriented_normals(
    cores: Array, reference: Cells, facing: Array, scales: Array
) -> Array:  # pragma: no cover - compiled
    """Normals (n, 3) of the reference, oriented towards ``facing``; NaN where undefined."""
    chosen = np.full((len(cores), 3), np.nan)
    for k in range(len(cores)):
        near = gather_within_radius(reference, cores[k], scales[k])
        if near.size < MIN_CYLINDER_POINTS:
            continue
        _, normals = local_planes_kernel(reference[0], near.reshape((1, -1)), np.array([near.size]))
        side = 0.0
        for axis in range(3):
            side += normals[0, axis] * facing[k, axis]
        for axis in range(3):
            chosen[k, axis] = (1.0 if side >= 0.0 else -1.0) * normals[0, axis]
    return chosen


@njit(nogil=True, cache=True)
def _cylinder_statistics(
    cores: Array, normals: Array, compared: Cells, reference: Cells, radii: Array, middles: Array,
    depths: Array,
) -> Array:  # pragma: no cover - compiled  # fmt: skip
    """Mean, variance and number of points of each cloud in each cylinder, shape (n, 2, 3)."""
    samples = np.zeros((len(cores), 2, 3))
    for k in range(len(cores)):
        core, normal, radius = cores[k], normals[k], radii[k]
        if np.isnan(normal[0]):
            continue
        for which in range(2):
            cloud = compared if which == 0 else reference
            middle = middles[k] if which == 0 else 0.0
            depth = depths[k, which]
            found = gather_within_radius(
                cloud, core + middle * normal, np.sqrt(depth * depth + radius * radius)
            )
            count, mean, squares = 0, 0.0, 0.0
            for i in found:
                along, squared = 0.0, 0.0
                for axis in range(3):
                    off = cloud[0][i, axis] - core[axis]
                    along += off * normal[axis]
                    squared += off * off
                if squared - along * along <= radius * radius and abs(along - middle) <= depth:
                    count += 1
                    step = along - mean  # Welford 1962, to lose no digits
                    mean += step / count
                    squares += step * (along - mean)
            samples[k, which, 0] = mean
            samples[k, which, 1] = squares / max(count - 1, 1)
            samples[k, which, 2] = count
    return samples


def _mean_differences(samples: Array) -> tuple[Array, Array]:
    """Differences between the means, and half their 95 % intervals.

    Parameters
    ----------
    samples : ndarray of shape (n, 2, 3)
        Mean, variance and number of points of each cloud.
    """
    from scipy.special import stdtrit

    mean, variance, count = np.moveaxis(samples, 2, 0)
    of_mean = variance / count
    total = of_mean.sum(axis=1)
    # Points exactly on a plane have no scatter; the interval is then zero.
    scattered = total > 0.0
    freedom = np.ones(len(total))
    own = (of_mean[scattered] ** 2 / (count[scattered] - 1)).sum(axis=1)
    freedom[scattered] = total[scattered] ** 2 / own
    return mean[:, 0] - mean[:, 1], stdtrit(freedom, 0.975) * np.sqrt(total)
