"""Signed distance between two clouds along the local normal, each with its confidence (M3C2).

After Lague, Brodu and Leroux (2013, ISPRS Journal 82): at each core point the normal comes from the
points of the reference within a scale; a cylinder along it takes points of either cloud, and the
distance is that between the two means along the axis. Its interval follows from the scatter of the
points in the cylinder. Unlike the distance to the nearest point it has a sign, and noise averages
out.

The interval is that of Welch (1947) for the means of two samples of unequal scatter, with
Student's t: with few points in a cylinder the usual 1.96 sigma would be too short. It covers the
noise of the points alone; what the points of a line have in common, the POS error, is what the
distance measures.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.errors import InputError, NotComparable
from lispac.geometry.nearest_neighbours import local_planes_kernel
from lispac.geometry.radius_search import Cells, PointGrid, gather_within_radius
from lispac.messages import error

Array = NDArray[np.float64]

NMAD = 1.4826
"""Standard deviation of normal noise over its median absolute deviation."""
FEWEST = 4
"""Points of either cloud in a cylinder below which there is no distance (Lague et al. 2013)."""


@dataclass(frozen=True, eq=False)
class NormalDistances:
    """Distances at the core points that have one.

    Attributes
    ----------
    cores : ndarray of shape (n, 3), metres, local frame
    distance : ndarray of shape (n,), metres
        Of the compared cloud from the reference, positive on the side the normals point to.
    half_width : ndarray of shape (n,), metres
        Half the 95 % interval of each distance.
    no_distance : int
        Core points that had none: too few points, or none that make a normal.
    normals : ndarray of shape (n, 3), unit vectors, local frame
        Along which each was measured.
    at : ndarray of shape (n,), int
        Which of the core points that were given have one.
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
        """Some of the distances, by their own numbers, ``kept`` (k,)."""
        return NormalDistances(
            self.cores[kept], self.distance[kept], self.half_width[kept],
            self.no_distance + len(self.at) - len(kept), self.normals[kept], self.at[kept],
        )  # fmt: skip

    @property
    def significant(self) -> float:
        """Share of the distances that differ from zero with 95 % confidence."""
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
        Where distances are measured: some of the reference points.
    facing : ndarray of shape (3,) or (k, 3)
        Direction on whose side all normals are taken, or that of each core.
    normal_scale : float or ndarray of shape (k,), metres
        Diameter of the sphere whose reference points make the normal, or that of each core.
    diameter : float or ndarray of shape (k,), metres
        Of the cylinder, or of that of each core.
    depth : float or ndarray of shape (k,), metres
        How far the cylinder reaches on either side of its middle, or that of each.
    middle : float or ndarray of shape (k,), metres
        How far along the normal from each core that of the compared cloud lies; the reference's
        lies at the core.
    reference_depth : float or ndarray of shape (k,), metres
        Depth for the reference, where it is another.

    Raises
    ------
    InputError
        A scale, diameter or depth that is not positive.
    NotComparable
        No core point has a distance.
    """
    for code, value in (
        ("validation.normal_scale", normal_scale), ("validation.cylinder_diameter", diameter),
        ("validation.cylinder_depth", depth),
        ("validation.cylinder_depth", depth if reference_depth is None else reference_depth),
    ):  # fmt: skip
        values = np.asarray(value, dtype=np.float64)
        wrong = values[~((values > 0.0) & (values < np.inf))]
        if wrong.size:
            raise InputError(error(code, value=float(wrong[0])))
    scales, diameters, depths, middles, own_depths = (
        np.ascontiguousarray(np.broadcast_to(np.asarray(each, dtype=np.float64), len(cores)))
        for each in (
            normal_scale, diameter, depth, middle,
            depth if reference_depth is None else reference_depth,
        )
    )  # fmt: skip
    if not len(cores):
        raise NotComparable(error("validation.no_places"))
    # A cell as wide as a query is read whole with few others.
    clouds = [
        PointGrid(points, max(float(diameters.max()), float(depths.max())) / 2).cells
        for points in (compared, reference)
    ]
    cores_in_a_row = np.ascontiguousarray(cores, dtype=np.float64)
    normals = _oriented_normals(
        cores_in_a_row, clouds[1], _facing_per_core(facing, len(cores)), scales / 2
    )
    samples = _cylinder_statistics(
        cores_in_a_row, normals, clouds[0], clouds[1], diameters / 2, middles,
        np.column_stack([depths, own_depths]),
    )  # fmt: skip
    measured = (samples[:, :, 2] >= FEWEST).all(axis=1)
    if not measured.any():
        raise NotComparable(
            error("validation.cylinder_too_narrow", needed=FEWEST, diameter=float(diameters.max()))
        )
    distance, half_width = _mean_differences(samples[measured])
    return NormalDistances(
        cores[measured], distance, half_width, int(np.count_nonzero(~measured)),
        normals[measured], np.flatnonzero(measured),
    )  # fmt: skip


def reference_normals(
    reference: Array, cores: Array, facing: Array, normal_scale: float | Array
) -> Array:
    """Normals of the reference at core points, shape (k, 3), local frame; not a number for none.

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
    """Normals (n, 3) of the reference on the side of ``facing``; not a number where none."""
    chosen = np.full((len(cores), 3), np.nan)
    for k in range(len(cores)):
        near = gather_within_radius(reference, cores[k], scales[k])
        if near.size < FEWEST:
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
    """Mean, variance and number (n, 2, 3) of either cloud's points in each core's cylinder."""
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
                along, beside = 0.0, 0.0
                for axis in range(3):
                    off = cloud[0][i, axis] - core[axis]
                    along += off * normal[axis]
                    beside += off * off
                if beside - along * along <= radius * radius and abs(along - middle) <= depth:
                    count += 1
                    step = along - mean  # Welford 1962: no digits are lost
                    mean += step / count
                    squares += step * (along - mean)
            samples[k, which, 0] = mean
            samples[k, which, 1] = squares / max(count - 1, 1)
            samples[k, which, 2] = count
    return samples


def _mean_differences(samples: Array) -> tuple[Array, Array]:
    """Differences of the means and half their 95 % intervals.

    Parameters
    ----------
    samples : ndarray of shape (n, 2, 3)
        Mean, variance and number of points of either cloud.
    """
    from scipy.special import stdtrit

    mean, variance, count = np.moveaxis(samples, 2, 0)
    of_mean = variance / count
    total = of_mean.sum(axis=1)
    # Without any scatter (points that are exactly on a plane) there is nothing to be unsure of.
    scattered = total > 0.0
    freedom = np.ones(len(total))
    own = (of_mean[scattered] ** 2 / (count[scattered] - 1)).sum(axis=1)
    freedom[scattered] = total[scattered] ** 2 / own
    return mean[:, 0] - mean[:, 1], stdtrit(freedom, 0.975) * np.sqrt(total)
