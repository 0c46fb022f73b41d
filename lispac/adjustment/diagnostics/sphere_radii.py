"""Test whether a sphere has the same radius in all lines, and find the cause of a difference.

The vessel moves during the second or two in which a sphere is scanned. A wrong sign of the
attitude, a wrong latency or a wrong range offset therefore distorts the points and changes the
radius, by a different amount in every line. Planes do not show this.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.result import RadiusDiscrepancy
from lispac.errors import SphereNotFound
from lispac.geometry.spheres import fit_sphere
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]
RadiiAndSigmas = tuple[Array, Array]
"""Radius of one sphere on each line and its standard deviation, (lines,) each, metres."""
Correction = Callable[[Observations, Mounting], tuple[Observations, Mounting]]

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
    spheres = {
        target: observations.where(observations.target_of_sighting[observations.sighting] == k)
        for k, target in enumerate(observations.targets)
        if observations.is_sphere[k]
    }
    radii = {target: _radius_by_line(own, mounting) for target, own in spheres.items()}
    differing = {
        target: each
        for target, each in radii.items()
        if each is not None and _do_radii_differ(each)
    }
    if not differing:
        return ()
    tested = [own for target, own in spheres.items() if radii[target] is not None]
    cause, value = _find_cause(tested, mounting)
    return tuple(
        RadiusDiscrepancy(target, float(each[0].min()), float(each[0].max()), cause, value)
        for target, each in differing.items()
    )


def _find_cause(spheres: list[Observations], mounting: Mounting) -> tuple[str, float]:
    """Simplest error with whose correction the radii of every sphere agree, and its value.

    An error of the attitude, latency or range affects all spheres. One wrong sign is preferred to
    two, and signs to values, which have a free parameter. The cause is empty if none corrects all.
    """
    for causes in _CAUSES_BY_SIMPLICITY:
        tried: list[tuple[float, str, float]] = []
        for cause, value, correct in causes:
            after = [_radius_by_line(*correct(each, mounting)) for each in spheres]
            if all(each is not None and not _do_radii_differ(each) for each in after):
                total = sum(_radius_chi_square(each) for each in after if each is not None)
                tried.append((total, cause, value))
        if tried:
            _, cause, value = min(tried)
            return cause, value
    return "", 0.0


def _radius_by_line(observations: Observations, mounting: Mounting) -> RadiiAndSigmas | None:
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


def _radius_chi_square(radii_and_sigmas: RadiiAndSigmas) -> float:
    """Weighted sum of squared deviations from the mean radius, no unit."""
    radii, sigmas = radii_and_sigmas
    weights = 1.0 / (sigmas**2 + ADDED_RADIUS_SIGMA**2)
    mean = weights @ radii / weights.sum()
    return float(weights @ (radii - mean) ** 2)


def _do_radii_differ(radii_and_sigmas: RadiiAndSigmas) -> bool:
    from scipy.special import chdtri

    freedom = len(radii_and_sigmas[0]) - 1
    return _radius_chi_square(radii_and_sigmas) > chdtri(freedom, TEST_LEVEL)


def _with_signs(
    signs: tuple[int, int, int], observations: Observations, mounting: Mounting
) -> tuple[Observations, Mounting]:
    return replace(observations, attitude=observations.attitude * np.array(signs)), mounting


def _with_latency(
    change: float, observations: Observations, mounting: Mounting
) -> tuple[Observations, Mounting]:
    if observations.pose_rate is None:
        return observations, mounting
    shift = change * observations.pose_rate
    moved = replace(
        observations, position=observations.position + shift[:, :3],
        attitude=observations.attitude + shift[:, 3:],
    )  # fmt: skip
    return moved, mounting


def _with_range_offset(
    change: float, observations: Observations, mounting: Mounting
) -> tuple[Observations, Mounting]:
    return observations, replace(mounting, range_offset=mounting.range_offset + change)


_CAUSES_BY_SIMPLICITY: tuple[list[tuple[str, float, Correction]], ...] = (
    [
        ("roll_sign", 0.0, partial(_with_signs, (-1, 1, 1))),
        ("pitch_sign", 0.0, partial(_with_signs, (1, -1, 1))),
    ],
    [("roll_pitch_signs", 0.0, partial(_with_signs, (-1, -1, 1)))],
    [
        *(("latency", float(each), partial(_with_latency, each)) for each in LATENCY_CHANGES),
        *(
            ("range_offset", float(each), partial(_with_range_offset, each))
            for each in RANGE_OFFSET_CHANGES
        ),
    ],
)
"""Possible causes, each with its value and a function that corrects the error, the simplest
first."""
