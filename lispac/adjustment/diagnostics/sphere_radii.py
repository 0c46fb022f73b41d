"""Test whether a sphere has the same radius in all lines, and find the cause of a difference.

The vessel moves during the second or two in which a sphere is scanned. A wrong sign of the
attitude, a wrong latency or a wrong range offset therefore distorts the points and changes the
radius, by a different amount in every line. Planes do not show this.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.result import RadiusDiscrepancy
from lispac.errors import SphereNotFound
from lispac.geometry.spheres import fit_sphere
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]

MIN_RADIUS_POINTS = 20
"""Smallest number of points of a sighting from which a radius is computed."""
TEST_LEVEL = 1e-3
"""Significance level of the test that the radii differ."""
ADDED_RADIUS_SIGMA = 0.003
"""Standard deviation added to that of each radius, metres; smaller differences do not matter."""
LATENCY_CHANGES = np.linspace(-0.3, 0.3, 61)
"""Changes of the latency that are tried, seconds."""
RANGE_OFFSET_CHANGES = np.linspace(-0.2, 0.2, 81)
"""Changes of the range offset that are tried, metres."""


def find_radius_discrepancies(
    observations: Observations, mounting: Mounting
) -> tuple[RadiusDiscrepancy, ...]:
    """Find spheres whose radii differ between lines by more than the noise explains.

    Parameters
    ----------
    observations : Observations
        Observations with positions in the local frame.
    mounting : Mounting
        Adjusted mounting.
    """
    found = []
    for k, target in enumerate(observations.targets):
        if not observations.is_sphere[k]:
            continue
        own = observations.where(observations.target_of_sighting[observations.sighting] == k)
        radii = _radius_by_line(own, mounting)
        if radii is None or not _do_radii_differ(*radii):
            continue
        candidates = [
            (cause, value, other)
            for cause, value, changed, trial_mounting in _candidate_corrections(own, mounting)
            if (other := _radius_by_line(changed, trial_mounting)) is not None
        ]
        best = min(candidates, key=lambda each: _radius_chi_square(*each[2]), default=None)
        smallest, largest = float(radii[0].min()), float(radii[0].max())
        if best is None or _do_radii_differ(*best[2]):
            found.append(RadiusDiscrepancy(target, smallest, largest))
        else:
            found.append(RadiusDiscrepancy(target, smallest, largest, best[0], best[1]))
    return tuple(found)


def _radius_by_line(observations: Observations, mounting: Mounting) -> tuple[Array, Array] | None:
    """Radius of one sphere and its sigma, (lines,), metres; None with fewer than two lines."""
    points = place_points(
        observations.points_lidar, Poses(observations.position, observations.attitude), mounting
    )
    radii, sigmas = [], []
    for s in range(len(observations.sightings)):
        own = points[observations.sighting == s]
        if len(own) < MIN_RADIUS_POINTS:
            continue
        try:
            sphere = fit_sphere(own)
        except SphereNotFound:
            continue
        design = np.column_stack([sphere.directions(own), np.ones(len(own))])
        residuals = sphere.distances(own)
        variance = residuals @ residuals / (len(own) - 4)
        radii.append(sphere.radius)
        sigmas.append(np.sqrt(variance * np.linalg.inv(design.T @ design)[3, 3]))
    return (np.array(radii), np.array(sigmas)) if len(radii) >= 2 else None


def _radius_chi_square(radii: Array, sigmas: Array) -> float:
    """Weighted sum of squared deviations from the mean radius, no unit."""
    weights = 1.0 / (sigmas**2 + ADDED_RADIUS_SIGMA**2)
    mean = weights @ radii / weights.sum()
    return float(weights @ (radii - mean) ** 2)


def _do_radii_differ(radii: Array, sigmas: Array) -> bool:
    from scipy.special import chdtri

    return _radius_chi_square(radii, sigmas) > chdtri(len(radii) - 1, TEST_LEVEL)


def _candidate_corrections(
    observations: Observations, mounting: Mounting
) -> Iterator[tuple[str, float, Observations, Mounting]]:
    """Candidate causes, their value, and observations and mounting with the error corrected."""
    for cause, signs in (
        ("roll_sign", (-1, 1, 1)), ("pitch_sign", (1, -1, 1)), ("roll_pitch_signs", (-1, -1, 1)),
    ):  # fmt: skip
        turned = observations.attitude * np.array(signs)
        yield cause, 0.0, replace(observations, attitude=turned), mounting
    if observations.pose_rate is not None:
        for late in LATENCY_CHANGES:
            off = late * observations.pose_rate
            moved = replace(
                observations, position=observations.position + off[:, :3],
                attitude=observations.attitude + off[:, 3:],
            )  # fmt: skip
            yield "latency", float(late), moved, mounting
    for offset in RANGE_OFFSET_CHANGES:
        longer = replace(mounting, range_offset=mounting.range_offset + float(offset))
        yield "range_offset", float(offset), observations, longer
