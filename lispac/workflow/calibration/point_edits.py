"""Manual adding and removing of points of a target's sightings."""

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound, ProjectError
from lispac.geometry.planes import fit_plane, rms_distance
from lispac.geometry.spheres import fit_sphere, rms_from_sphere
from lispac.messages import error
from lispac.project import PickedSighting, Target
from lispac.survey.cloud import Cloud

Array = NDArray[np.float64]
PointSelector = Callable[[Array], NDArray[np.bool_]]
"""Function of points (n, 3) that returns flags of the selected ones."""

MIN_POINTS_PER_SIGHTING = 10
"""Smallest number of points that a sighting must keep."""
EDIT_MARGIN = 2.0
"""Distance by which an added point may be farther from the centre of a sighting than its farthest
point, metres."""


def without_points(
    target: Target, clouds: Mapping[str, Cloud], chosen: PointSelector, line: str = ""
) -> tuple[Target, int]:
    """Remove points from a target's sightings, or from the one on ``line``.

    Parameters
    ----------
    clouds : lines as placed when the points were selected

    Returns
    -------
    Target, and number of points removed

    Raises
    ------
    ProjectError
        If a sighting would keep fewer than `MIN_POINTS_PER_SIGHTING` points, or points that do not
        determine a plane.
    """

    def edited(sighting: PickedSighting, cloud: Cloud) -> NDArray[np.int64]:
        kept = sighting.indices[~chosen(cloud[sighting.indices])]
        if len(kept) < min(MIN_POINTS_PER_SIGHTING, len(sighting.indices)):
            raise ProjectError(
                error(
                    "edit.few_points_left", target=target.name, line=sighting.line, count=len(kept)
                )
            )
        return kept

    return _edit_sightings(target, clouds, edited, line)


def with_points(
    target: Target, clouds: Mapping[str, Cloud], chosen: PointSelector, line: str = ""
) -> tuple[Target, int]:
    """Add points near their surface to a target's sightings, or to the one on ``line``.

    Points are added only within the target's threshold of the surface of the sighting and not much
    farther from its centre than its own points (`EDIT_MARGIN`), because a selection on the screen
    also contains points behind it.

    Parameters, returns
    -------------------
    See `without_points`; the number is that of points added.
    """

    def edited(sighting: PickedSighting, cloud: Cloud) -> NDArray[np.int64]:
        own = cloud[sighting.indices]
        centre = own.mean(axis=0)
        radius = float(np.linalg.norm(own - centre, axis=1).max()) + EDIT_MARGIN
        around = cloud.within(centre, radius)
        near = np.abs(_surface_distances(target, own, around.points)) <= target.threshold
        added = around.numbers[near][chosen(around.points[near])]
        return np.union1d(sighting.indices, added)

    return _edit_sightings(target, clouds, edited, line)


def _edit_sightings(
    target: Target,
    clouds: Mapping[str, Cloud],
    edited: Callable[[PickedSighting, Cloud], NDArray[np.int64]],
    line: str,
) -> tuple[Target, int]:
    sightings, changed = [], 0
    for sighting in target.sightings:
        if line in ("", sighting.line) and sighting.line in clouds:
            cloud = clouds[sighting.line]
            indices = edited(sighting, cloud)
            if len(indices) != len(sighting.indices):
                changed += abs(len(indices) - len(sighting.indices))
                rms = _surface_rms(target, cloud[indices])
                sighting = replace(sighting, indices=indices, rms=rms, by_hand=True)
        sightings.append(sighting)
    return (replace(target, sightings=tuple(sightings)), changed) if changed else (target, 0)


def _surface_distances(target: Target, sighting_points: Array, points: Array) -> Array:
    if target.shape == "sphere":
        return fit_sphere(sighting_points, target.sphere_radius).distances(points)
    return fit_plane(sighting_points).distances(points)


def _surface_rms(target: Target, points: Array) -> float:
    if target.shape == "sphere":
        return rms_from_sphere(fit_sphere(points, target.sphere_radius), points)
    try:
        return rms_distance(fit_plane(points), points)
    except PlaneNotFound as failure:
        raise ProjectError(
            error("edit.no_surface_left", target=target.name, reason=failure.reason)
        ) from None
