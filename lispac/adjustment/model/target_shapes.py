"""The shapes of the targets: planes and spheres, four numbers each.

A plane is a unit normal and an offset, a sphere a centre and a radius. Both may only be changed in
certain directions: a normal stays a unit vector (in the thesis by the constraint 4.5), a known
radius stays as it is.
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

MIN_FOR_MAJORITY = 3
"""Sightings of a target among which there is a majority."""

SMALLEST_EXTENT = 1e-3
"""Metres: a sighting whose points coincide has no tilt, but its equations must have a solution."""


def points_local(observations: Observations, mounting: Mounting) -> Array:
    """The points placed with ``mounting``, shape (n, 3), metres, local."""
    planes = np.tile([0.0, 0.0, 1.0, 0.0], (len(observations.targets), 1))
    # The Jacobian of a plane by (a, b, c) is the point itself.
    return evaluate_columns(observations.as_planes(), mounting, planes, slice(9, 12))


def target_centroids(observations: Observations, mounting: Mounting) -> Array:
    """Mean point of each target placed with ``mounting``, shape (targets, 3), metres, local."""
    means = observations.mean_by_sighting(points_local(observations, mounting))
    owners, counts = observations.target_of_sighting, observations.counts
    total = np.bincount(owners, counts)
    return np.stack([np.bincount(owners, counts * m) / total for m in means.T], axis=1)


def moments_by_sighting(observations: Observations, mounting: Mounting) -> Array:
    """Sums of the products of (x, y, z, 1) of each sighting, shape (sightings, 4, 4), metres."""
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
    """Observations with the coordinates of each target relative to its origin.

    The origin of the local frame may be kilometres off; a turn of a plane about it would be
    a large shift.

    Parameters
    ----------
    origins : ndarray of shape (targets, 3), metres, local
        What is taken from the positions.
    """
    of_sightings = origins[observations.target_of_sighting]
    return replace(
        observations, position=observations.position - of_sightings[observations.sighting]
    )


def shapes_relative_to(shapes: Array, origins: Array, is_sphere: NDArray[np.bool_]) -> Array:
    """Shapes relative to ``origins``, shape (targets, 4); the inverse with minus these.

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

    All lines together would give a wrong radius if the boresight is off by degrees.
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
    """Least-squares shape of each target through its points placed with ``mounting``.

    Returns
    -------
    ndarray of shape (targets, 4), local frame

    Raises
    ------
    SphereNotFound
        Where the points of a sphere do not determine it.
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

    Of each target the plane of that sighting alone which lies nearest to half of the others. A
    board of a metre that is metres off on one line would have the plane through all its points
    stand across the board.

    Parameters
    ----------
    fitted : ndarray of shape (targets, 4)
        As by `fit_shapes`: what spheres, and targets with too few sightings for a majority, keep.

    Returns
    -------
    ndarray of shape (targets, 4), local frame
    """
    points = points_local(observations, mounting)
    shapes = fitted.copy()
    for k in range(len(shapes)):
        indices = np.flatnonzero(observations.target_of_sighting == k)
        if observations.is_sphere[k] or len(indices) < MIN_FOR_MAJORITY:
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

    All in any frame. Pixar's construction (Duff et al. 2017): smooth in the normal but for one
    sign.
    """
    x, y, z = np.moveaxis(normals, -1, 0)
    sign = np.where(z >= 0, 1.0, -1.0)
    a = -1 / (sign + z)
    b = x * y * a
    columns = [1 + sign * x * x * a, b, sign * b, sign + y * y * a, -sign * x, -y]
    return np.stack(columns, axis=-1).reshape(*x.shape, 3, 2)


def plane_tangents(normals: Array, centres: Array) -> Array:
    """Tangents of planes: two rotations about ``centres`` and a shift, shape (m, 4, 3).

    About the centre instead of the origin, so that turns and shift are nearly independent.

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
    """Tangents of a sphere: centre, and radius where unknown, shape (4, 3) or (4, 4)."""
    return np.eye(4)[:, : 3 if known_radius else 4]


def surface_tangents(normals: Array, moments: Array, spheres: NDArray[np.bool_]) -> Array:
    """Tangents of the departures of sightings from their shapes, metres at their border.

    Parameters
    ----------
    normals : ndarray of shape (m, 3), local frame
        Of the planes; of no meaning where a sighting is of a sphere.
    moments : ndarray of shape (m, 4, 4)
        As in `centres_and_extents`.
    spheres : ndarray of shape (m,), bool
        Sightings that may only lie in or out along the radius.

    Returns
    -------
    ndarray of shape (m, 4, 3)
    """
    tangents = np.zeros((len(normals), 4, 3))
    tangents[spheres, 3, 2] = -1
    centres, extents = centres_and_extents(moments[~spheres])
    planes = plane_tangents(normals[~spheres], centres)
    planes[:, :, :2] /= np.maximum(extents, SMALLEST_EXTENT)[:, None, None]
    tangents[~spheres] = planes
    return tangents


def centres_and_extents(moments: Array) -> tuple[Array, Array]:
    """Mean points and extents of points from their weighted moments.

    Parameters
    ----------
    moments : ndarray of shape (m, 4, 4)
        Sums of the products of (x, y, z, 1), metres.

    Returns
    -------
    centres : ndarray of shape (m, 3), metres
    extents : ndarray of shape (m,), metres
        From the centre to the border: a uniform square of half-width a has a mean squared
        distance of 2/3 a^2.
    """
    weight = moments[:, 3, 3]
    centres = moments[:, :3, 3] / weight[:, None]
    squares = np.trace(moments[:, :3, :3], axis1=1, axis2=2) / weight
    spread = squares - (centres**2).sum(axis=1)
    return centres, np.sqrt(np.maximum(1.5 * spread, 0.0))


def apply_shape_changes(shapes: Array, changes: Array, is_sphere: NDArray[np.bool_]) -> Array:
    """Shapes after ``changes``, shape (targets, 4), with normals of unit length.

    Parameters
    ----------
    shapes, changes : ndarray of shape (targets, 4), local frame
    is_sphere : ndarray of shape (targets,), bool
    """
    new = shapes + changes
    length = np.where(is_sphere, 1.0, np.linalg.norm(new[:, :3], axis=1))
    return np.asarray(new / length[:, None])
