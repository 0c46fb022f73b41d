"""Common parts of large targets of which the lines show different parts: a deck, a long wall.

If the whole surface is flat, the parts lie in one plane and all points are used. If it is not shown
to be flat, the planes of different parts may differ. Then only the part that most lines show is
used, or the parts of the largest group of overlapping lines. A target of which no two lines show
the same part is excluded. Flatness is tested by fitting a quadric (variable-order surface fitting:
Besl and Jain 1988).
"""

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import CommonCoverage, Observations
from lispac.adjustment.model.target_shapes import points_local
from lispac.geometry.planes import fit_plane, plane_axes
from lispac.survey.georeferencing import Mounting
from lispac.targets import outline

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

MIN_OVERLAP = 0.5
"""Smallest share of the points of one of two sightings that lie within the other.

Below it, the two sightings show different parts.
"""
MIN_COMMON_POINTS, MIN_COMMON_SHARE = 30, 0.1
"""Smallest number of points of a line in the common part, and smallest share of its sighting."""
CURVATURE_SIGMAS = 3.0
"""Number of its standard deviations added to the curvature: uncertain flatness is not accepted."""
MAX_SAGITTA_SIGMAS = 1.0
"""Largest sagitta over the whole surface, in standard deviations of the LiDAR noise."""


def find_common_parts(
    observations: Observations, mounting: Mounting
) -> tuple[Observations, tuple[CommonCoverage, ...]]:
    """Keep the points of the common parts of all targets, and list the targets that were reduced.

    Parameters
    ----------
    mounting : Mounting
        Mounting with which the lines nearly agree.
    """
    points = points_local(observations, mounting)
    keep = np.ones(len(observations), dtype=bool)
    found = []
    for k, target in enumerate(observations.targets):
        if observations.is_sphere[k]:
            continue
        own = np.flatnonzero(observations.target_of_sighting[observations.sighting] == k)
        line = observations.sighting[own]
        common = _common_part_of_target(points[own], line)
        if common is None or _is_flat(points[own], line, observations.sigma_lidar[own]):
            continue
        enough = [s for s in np.unique(line) if _is_part_large_enough(common[line == s])]
        common &= np.isin(line, enough if len(enough) >= 2 else [])
        keep[own] = common
        lines = tuple(observations.sightings[s].line for s in enough) if common.any() else ()
        found.append(CommonCoverage(target, float(common.mean()), lines))
    return (observations.where(keep) if found else observations), tuple(found)


def _common_part_of_target(points: Array, sighting: NDArray[np.int64]) -> Flags | None:
    """Mask of the points of the common part; None if all sightings show about the same part.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
    sighting : ndarray of shape (n,), int
    """
    placed = points @ plane_axes(fit_plane(points).normal).T
    parts = [np.flatnonzero(sighting == s) for s in np.unique(sighting)]
    cell = max(outline.outline_cell_size(placed[own], np.ones(len(own))) for own in parts)
    shows = np.zeros((len(parts), len(points)), dtype=bool)
    for k, own in enumerate(parts):
        shows[k] = outline.is_covered(placed, placed[own], cell)
    # Share of the points of sighting i (columns) that sighting k (rows) shows
    share = np.stack([shows[:, own].mean(axis=1) for own in parts], axis=1)
    groups = _connected_groups(np.maximum(share, share.T) >= MIN_OVERLAP)
    if len(groups) == 1:
        return None
    by_majority = shows.sum(axis=0) > len(parts) / 2
    largest = max(groups, key=len)
    if sum(_is_part_large_enough(by_majority[own]) for own in parts) > len(largest):
        return by_majority
    return np.isin(np.arange(len(points)), np.concatenate([parts[k] for k in largest]))


def _is_part_large_enough(common: Flags) -> bool:
    return bool(common.sum() >= MIN_COMMON_POINTS and common.mean() >= MIN_COMMON_SHARE)


def _connected_groups(alike: Flags) -> list[list[int]]:
    """Connected components of the graph with the symmetric adjacency matrix ``alike``, (n, n)."""
    groups: list[list[int]] = []
    for k in range(len(alike)):
        joined = [group for group in groups if alike[k, group].any()]
        groups = [group for group in groups if group not in joined]
        groups.append(sorted([k, *(each for group in joined for each in group)]))
    return groups


def _is_flat(points: Array, sighting: NDArray[np.int64], sigma: Array) -> bool:
    """Whether the data show that a surface is flat over its whole extent.

    One quadric is fitted to all sightings together with a separate plane for each sighting, because
    errors of boresight and POS tilt and displace each sighting as a whole.
    """
    plane = fit_plane(points)
    placed = (points - points.mean(axis=0)) @ plane_axes(plane.normal).T
    scale = float(np.ptp(placed, axis=0).max()) / 2.0
    u, v = placed.T / scale
    columns = np.column_stack([u * u, u * v, v * v])
    off = plane.distances(points)
    for s in np.unique(sighting):
        own = sighting == s
        design = np.column_stack([np.ones(own.sum()), u[own], v[own]])
        joined = np.column_stack([columns[own], off[own]])
        solved, *_ = np.linalg.lstsq(design, joined, rcond=None)
        left = joined - design @ solved
        columns[own], off[own] = left[:, :3], left[:, 3]
    normal = columns.T @ columns
    inverse = np.linalg.pinv(normal, rcond=1e-12, hermitian=True)
    bends = inverse @ (columns.T @ off)
    noise = float(np.sqrt(np.mean((off - columns @ bends) ** 2)))
    spread = noise * np.sqrt(np.maximum(np.diag(inverse), 0.0))
    # u and v range over at most 2, so that a coefficient equals the sagitta of its term.
    sagitta = float(np.max(np.abs(bends) + CURVATURE_SIGMAS * spread))
    return sagitta <= MAX_SAGITTA_SIGMAS * float(np.sqrt(np.mean(sigma**2)))
