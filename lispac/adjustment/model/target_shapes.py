"""Shapes of the targets: planes and spheres, four numbers each.

A plane is given by a unit normal and an offset, a sphere by a centre and a radius. Corrections are
restricted to tangent directions, so that a normal keeps unit length (in the thesis by the
constraint 4.5) and a known radius is not changed.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.condition_equations import evaluate_columns
from lispac.adjustment.model.observations import Observations
from lispac.errors import PlaneNotFound
from lispac.geometry.planes import fit_plane
from lispac.geometry.spheres import fit_sphere
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

MIN_MAJORITY_SIGHTINGS = 3
"""Smallest number of sightings of a target that can have a majority."""

MIN_EXTENT = 1e-3
"""Smallest extent used for a sighting, metres.

The tilts of a sighting whose points coincide would otherwise be singular.
"""


def points_local(observations: Observations, mounting: Mounting) -> Array:
    """Points georeferenced with ``mounting``, shape (n, 3), metres, local frame."""
    planes = np.tile([0.0, 0.0, 1.0, 0.0], (len(observations.targets), 1))
    # The Jacobian of a plane by (a, b, c) is the point itself.
    return evaluate_columns(observations.as_planes(), mounting, planes, slice(9, 12))


def target_centroids(observations: Observations, mounting: Mounting) -> Array:
    """Mean georeferenced point of each target, shape (targets, 3), metres, local frame."""
    means = observations.mean_by_sighting(points_local(observations, mounting))
    owners, counts = observations.target_of_sighting, observations.counts
    total = np.bincount(owners, counts)
    return np.stack([np.bincount(owners, counts * m) / total for m in means.T], axis=1)


def moments_by_sighting(observations: Observations, mounting: Mounting) -> Array:
    """Sums of the products of (x, y, z, 1) in metres of each sighting, shape (sightings, 4, 4)."""
    points = points_local(observations, mounting)
    means = observations.mean_by_sighting(points)
    centred = points - means[observations.sighting]
    moments = np.zeros((len(means), 4, 4))
    for i in range(3):
        for j in range(i + 1):
            squares = observations.mean_by_sighting(centred[:, i] * centred[:, j])
            moments[:, i, j] = moments[:, j, i] = squares + means[:, i] * means[:, j]
    moments[:, :3, 3] = moments[:, 3, :3] = means
    moments[:, 3, 3] = 1
    return moments * observations.counts[:, None, None]


def relative_to_origins(observations: Observations, origins: Array) -> Observations:
    """Observations with coordinates relative to an origin for each target.

    The origin of the local frame may be kilometres away, and a rotation of a plane about it would
    shift the plane by a large amount.

    Parameters
    ----------
    origins : ndarray of shape (targets, 3), metres, local
        Origin of each target, subtracted from the positions.
    """
    together = observations.origin_of_target + origins
    return replace(observations, origins=dict(zip(observations.targets, together, strict=True)))


def shapes_relative_to(shapes: Array, origins: Array, is_sphere: NDArray[np.bool_]) -> Array:
    """Shapes relative to ``origins``, shape (targets, 4); negative origins give the inverse.

    Parameters
    ----------
    shapes : ndarray of shape (targets, 4), local frame
    origins : ndarray of shape (targets, 3), metres, local
    is_sphere : ndarray of shape (targets,), bool
    """
    new = shapes.copy()
    new[is_sphere, :3] -= origins[is_sphere]
    new[~is_sphere, 3] += (shapes[:, :3] * origins).sum(axis=1)[~is_sphere]
    return new


def with_median_radii(observations: Observations, mounting: Mounting) -> Observations:
    """Observations with unknown radii fixed to the median of the radii of single lines.

    A sphere fitted to all lines would have a wrong radius if the boresight is wrong by degrees.
    """
    unknown = [name for name, radius in observations.radii.items() if radius is None]
    if not unknown:
        return observations
    points = points_local(observations, mounting)
    found = dict(observations.radii)
    for name in unknown:
        found[name] = float(
            np.median(
                [
                    fit_sphere(points[observations.sighting == s]).radius
                    for s, sighting in enumerate(observations.sightings)
                    if sighting.target == name
                ]
            )
        )
    return replace(observations, radii=found)


def fit_shapes(observations: Observations, mounting: Mounting) -> Array:
    """Fit a shape to the points of each target, georeferenced with ``mounting``.

    Returns
    -------
    ndarray of shape (targets, 4), local frame

    Raises
    ------
    SphereNotFound
        The points of a sphere do not determine it.
    """
    points = points_local(observations, mounting)
    target = observations.target_of_sighting[observations.sighting]
    shapes = np.empty((len(observations.targets), 4))
    for k, name in enumerate(observations.targets):
        own = points[target == k]
        if observations.is_sphere[k]:
            sphere = fit_sphere(own, observations.radii[name])
            shapes[k] = *sphere.centre, sphere.radius
            continue
        centre = own.mean(axis=0)
        normal = np.linalg.eigh(np.cov((own - centre).T))[1][:, 0]
        shapes[k] = *normal, -normal @ centre
    return shapes


def fit_majority_shapes(observations: Observations, mounting: Mounting, fitted: Array) -> Array:
    """Initial planes on which most sightings agree, unaffected by the others.

    A plane is fitted to each sighting of a target, and the plane with the smallest median distance
    from all sightings is chosen. A plane fitted to all points would be useless if a board of a
    metre is displaced by metres in one line.

    Parameters
    ----------
    fitted : ndarray of shape (targets, 4)
        Shapes from `fit_shapes`, used for spheres and for targets with too few sightings for a
        majority.

    Returns
    -------
    ndarray of shape (targets, 4), local frame
    """
    points = points_local(observations, mounting)
    shapes = fitted.copy()
    for k in range(len(shapes)):
        indices = np.flatnonzero(observations.target_of_sighting == k)
        if observations.is_sphere[k] or len(indices) < MIN_MAJORITY_SIGHTINGS:
            continue
        clouds = [points[observations.sighting == s] for s in indices]
        agreed = np.inf
        for cloud in clouds:
            try:
                plane = fit_plane(cloud)
            except PlaneNotFound:  # a single straight line of points
                continue
            off = [np.median(np.abs(plane.distances(other))) for other in clouds]
            if (usual := float(np.median(off))) < agreed:
                agreed, shapes[k] = usual, (*plane.normal, plane.d)
    return shapes


def orthogonal_vectors(normals: Array) -> Array:
    """Two unit vectors at right angles to unit normals (..., 3) and to each other, (..., 3, 2).

    Normals and results are in the same frame. The construction (Duff et al. 2017) is a smooth
    function of the normal, except where the sign of its z component changes.
    """
    x, y, z = np.moveaxis(normals, -1, 0)
    sign = np.where(z >= 0, 1.0, -1.0)
    a = -1 / (sign + z)
    b = x * y * a
    columns = [1 + sign * x * x * a, b, sign * b, sign + y * y * a, -sign * x, -y]
    return np.stack(columns, axis=-1).reshape(*x.shape, 3, 2)


def plane_tangents(normals: Array, centres: Array) -> Array:
    """Tangents of planes: two rotations about ``centres`` and a shift, shape (m, 4, 3).

    With rotations about the centre instead of the origin, rotations and shift are nearly
    uncorrelated.

    Parameters
    ----------
    normals : ndarray of shape (m, 3), unit vectors, local frame
    centres : ndarray of shape (m, 3), metres, local frame
    """
    tangents = np.zeros((len(normals), 4, 3))
    tangents[:, :3, :2] = orthogonal_vectors(normals)
    tangents[:, 3, :2] = -np.einsum("mi,mij->mj", centres, tangents[:, :3, :2])
    tangents[:, 3, 2] = 1
    return tangents


def sphere_tangent(*, known_radius: bool) -> Array:
    """Tangents of a sphere: centre, and radius if unknown, shape (4, 3) or (4, 4)."""
    return np.eye(4)[:, : 3 if known_radius else 4]


def surface_tangents(normals: Array, moments: Array, spheres: NDArray[np.bool_]) -> Array:
    """Tangents of the deviations of sightings from their shapes, in metres at the border.

    Parameters
    ----------
    normals : ndarray of shape (m, 3), local frame
        Normals of the planes; not used for spheres.
    moments : ndarray of shape (m, 4, 4)
        As in `centres_and_extents`.
    spheres : ndarray of shape (m,), bool
        Sightings of spheres, which can only deviate along the radius.

    Returns
    -------
    ndarray of shape (m, 4, 3)
    """
    tangents = np.zeros((len(normals), 4, 3))
    tangents[spheres, 3, 2] = -1
    centres, extents = centres_and_extents(moments[~spheres])
    planes = plane_tangents(normals[~spheres], centres)
    planes[:, :, :2] /= np.maximum(extents, MIN_EXTENT)[:, None, None]
    tangents[~spheres] = planes
    return tangents


def centres_and_extents(moments: Array) -> tuple[Array, Array]:
    """Compute mean points and extents from the weighted moments of points.

    Parameters
    ----------
    moments : ndarray of shape (m, 4, 4)
        Sums of the products of (x, y, z, 1), with coordinates in metres.

    Returns
    -------
    centres : ndarray of shape (m, 3), metres
    extents : ndarray of shape (m,), metres
        Distance from the centre to the border, computed as for a uniform square: with the
        half-width a, the mean squared distance from the centre is 2/3 a^2.
    """
    weight = moments[:, 3, 3]
    centres = moments[:, :3, 3] / weight[:, None]
    squares = np.trace(moments[:, :3, :3], axis1=1, axis2=2) / weight
    spread = squares - (centres**2).sum(axis=1)
    return centres, np.sqrt(np.maximum(1.5 * spread, 0.0))


def apply_shape_changes(shapes: Array, changes: Array, is_sphere: NDArray[np.bool_]) -> Array:
    """Add ``changes`` to shapes and normalise the normals; shape (targets, 4).

    Parameters
    ----------
    shapes, changes : ndarray of shape (targets, 4), local frame
    is_sphere : ndarray of shape (targets,), bool
    """
    new = shapes + changes
    length = np.where(is_sphere, 1.0, np.linalg.norm(new[:, :3], axis=1))
    return np.asarray(new / length[:, None])
