"""The shapes of the targets: planes and spheres, four numbers each.

A plane is a unit normal and an offset, a sphere a centre and a radius. Both may only be changed in
certain directions: a normal stays a unit vector, a known radius stays as it is.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.conditions import evaluate
from lispac.adjustment.observations import Observations
from lispac.geometry.spheres import fit_sphere
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

SMALLEST_EXTENT = 1e-3
"""Metres: a sighting whose points coincide has no tilt, but its equations must have a solution."""


def points_local(observations: Observations, mounting: Mounting) -> Array:
    """The points placed with ``mounting``, shape (n, 3), metres, local."""
    planes = np.tile([0.0, 0.0, 1.0, 0.0], (len(observations.targets), 1))
    # The Jacobian of a plane by (a, b, c) is the point itself.
    return evaluate(observations.as_planes(), mounting, planes, slice(9, 12))


def about_targets(observations: Observations, mounting: Mounting) -> tuple[Observations, Array]:
    """The same points, each target counted from its own middle.

    The origin of the local frame may be kilometres off; a turn of a plane about it would be
    a large shift.

    Returns
    -------
    observations : Observations
    origins : ndarray of shape (targets, 3), metres, local
        What was taken from the positions.
    """
    means = observations.mean_by_sighting(points_local(observations, mounting))
    owners, counts = observations.target_of_sighting, observations.counts
    total = np.bincount(owners, counts)
    origins = np.stack([np.bincount(owners, counts * m) / total for m in means.T], axis=1)
    position = observations.position - origins[owners[observations.sighting]]
    return replace(observations, position=position), origins


def counted_from(shapes: Array, origins: Array, is_sphere: NDArray[np.bool_]) -> Array:
    """Shapes counted from ``origins``, shape (targets, 4); with minus these, back again."""
    new = shapes.copy()
    new[is_sphere, :3] -= origins[is_sphere]
    new[~is_sphere, 3] += (shapes[:, :3] * origins).sum(axis=1)[~is_sphere]
    return new


def usual_radii(observations: Observations, mounting: Mounting) -> Observations:
    """The same with unknown radii taken for known: the median of what each line alone says.

    All lines together, misplaced by a boresight that is off by degrees, would say a wrong one.
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


def orthogonal(normal: Array) -> Array:
    """Two unit vectors at right angles to a unit normal and to each other, shape (3, 2).

    Pixar's construction (Duff et al. 2017): smooth in the normal but for one sign.
    """
    x, y, z = (float(value) for value in normal)
    sign = 1.0 if z >= 0 else -1.0
    a = -1 / (sign + z)
    b = x * y * a
    return np.array([[1 + sign * x * x * a, b], [sign * b, sign + y * y * a], [-sign * x, -y]])


def plane_tangent(normal: Array, centre: Array) -> Array:
    """Two turns of a plane's normal about ``centre`` and a shift along it, shape (4, 3).

    About the centre instead of the origin, so that turns and shift are nearly independent.
    """
    tangent = np.zeros((4, 3))
    tangent[:3, :2] = orthogonal(normal)
    tangent[3, :2] = -centre @ tangent[:3, :2]
    tangent[3, 2] = 1
    return tangent


def sphere_tangent(*, known_radius: bool) -> Array:
    """Centre, and radius where it is unknown: shape (4, 3) or (4, 4)."""
    return np.eye(4)[:, : 3 if known_radius else 4]


def surface_tangent(normal: Array, centre: Array, extent: float) -> Array:
    """How one sighting of a plane may depart from it, shape (4, 3), in metres at its border."""
    tangent = plane_tangent(normal, centre)
    tangent[:, :2] /= max(extent, SMALLEST_EXTENT)
    return tangent


SPHERE_SURFACE = np.array([[0.0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, -1]])
"""A sighting of a sphere may only lie in or out along the radius."""


def centre_and_extent(moments: Array) -> tuple[Array, float]:
    """Mean point and reach of points from their weighted moments.

    Parameters
    ----------
    moments : ndarray of shape (4, 4)
        Sum of the products of (x, y, z, 1), metres.

    Returns
    -------
    centre : ndarray of shape (3,), metres
    extent : float, metres
        From the centre to the border: a uniform square of half-width a has a mean squared
        distance of 2/3 a^2.
    """
    centre = moments[:3, 3] / moments[3, 3]
    spread = np.trace(moments[:3, :3]) / moments[3, 3] - centre @ centre
    return centre, float(np.sqrt(max(1.5 * spread, 0.0)))


def moved(shapes: Array, changes: Array, is_sphere: NDArray[np.bool_]) -> Array:
    """Shapes after ``changes``, shape (targets, 4), with normals of unit length."""
    new = shapes + changes
    length = np.where(is_sphere, 1.0, np.linalg.norm(new[:, :3], axis=1))
    return np.asarray(new / length[:, None])
