"""Observability of the angles: eigenvalues, weak directions, unchecked parts of the data."""

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.excess_scatter import sigmas_without
from lispac.adjustment.result import ANGLES, Observability, UncontrolledObservations
from lispac.adjustment.solve.adjustment_problem import LinearisedProblem
from lispac.adjustment.solve.determinability import (
    ANGLE_CODES,
    MAX_ANGLE_SIGMA,
    angle_combination,
    have_targets_one_orientation,
)
from lispac.adjustment.solve.normal_equations import scaled_inverse
from lispac.messages import Message, note
from lispac.progress import Progress, no_progress

Array = NDArray[np.float64]

MAX_SIGMA_RATIO = 4.0
"""Ratio of the sigma of an angle without a sighting or target to that with it, above which the
angle depends on it alone: an error of it is then hardly visible in the others."""
MAX_CHECK_SIGMA = np.radians(0.1)
"""Largest sigma of an angle without a target, radians, with which the others check the angle well
enough; a survey that is less precise has a warning (`MAX_ANGLE_SIGMA_DEG`)."""
MAX_CLUSTER_RATIO = 0.05
"""Ratio of the largest distance between targets to the range below which they act as one target.

POS errors, beam directions and errors of a line are then the same for all of them.
"""
MAX_TESTED_SIGHTINGS = 100
"""Largest number of sightings for which the dependence of angles on single ones is examined."""
MIN_LINE_SIGMA_RATIO = 1.25
"""Ratio of the sigma of an angle without a line to that with it above which the line is named."""


def assess_observability(
    linearised: LinearisedProblem,
    *,
    angle_sigma_factors: Array | None = None,
    covariance: Array | None = None,
    added_variance: Array | None = None,
    origins: Array | None = None,
    progress: Progress = no_progress,
) -> Observability:
    """Assess how well lines and targets determine the three angles.

    Parameters
    ----------
    angle_sigma_factors : ndarray of shape (3,), no unit, optional
        Factors by which the sigmas of the angles are raised.
    covariance : ndarray of shape (3, 3), radians squared, optional
        Covariance of the estimated angles, if it is not that of ``linearised`` with the factors.
    added_variance : ndarray of shape (3,), radians squared, optional
        Part of the variances of the angles that is due to the given lever arm. It is also added to
        the variances without a line.
    origins : ndarray of shape (targets, 3), metres, local, optional
        Centres of the targets.
    """
    factors = np.ones(3) if angle_sigma_factors is None else angle_sigma_factors
    added = np.zeros(3) if added_variance is None else added_variance
    information = linearised.normal.information(3) / np.outer(factors, factors)
    if covariance is not None:
        information = scaled_inverse(covariance)
    eigenvalues, directions = np.linalg.eigh(information)
    sigma = np.sqrt(np.diag(np.linalg.inv(information)))
    observations = linearised.problem.observations
    without = {}
    for k, line in enumerate(observations.lines):
        progress(k / len(observations.lines))
        omitted = np.array([sighting.line == line for sighting in observations.sightings])
        own = _sigmas_without_groups(linearised, omitted)
        without[line] = None if own is None else np.sqrt((factors * own) ** 2 + added)
    notes = (
        _extreme_directions_note(eigenvalues, directions, sigma),
        *_main_lines_by_angle(sigma, without),
        *_one_orientation_notes(linearised),
    )  # fmt: skip
    condition = float(eigenvalues[2] / eigenvalues[0])
    unchecked = (
        tuple(_find_unchecked_parts(linearised, without, origins))
        if linearised.problem.model.correlated
        else ()
    )
    return Observability(eigenvalues, directions, condition, without, notes, unchecked)


def _find_unchecked_parts(
    linearised: LinearisedProblem, without: dict[str, Array | None], origins: Array | None
) -> Iterator[UncontrolledObservations]:
    """Find lines, targets and sightings whose errors would not be detected by the others."""
    observations = linearised.problem.observations
    needed = [line for line, sigma in without.items() if sigma is None]
    yield from (UncontrolledObservations("line", line=line) for line in needed)
    count = len(observations.sightings)
    whole = sigmas_without(linearised, np.zeros(count, dtype=bool))
    if whole is None:
        return

    def dependent_angles(omitted: NDArray[np.bool_], least: float = 0.0) -> tuple[str, ...] | None:
        """Angles with a much larger sigma without some sightings; None if undetermined."""
        sigma = sigmas_without(linearised, omitted)
        if sigma is None or sigma.max() > MAX_ANGLE_SIGMA:
            return None
        depends = (sigma > MAX_SIGMA_RATIO * whole) & (sigma > least)
        return tuple(np.array(ANGLES)[depends].tolist())

    def needed_parts(
        part: NDArray[np.int64], candidates: NDArray[np.int64], least: float = 0.0
    ) -> Iterator[tuple[int, tuple[str, ...] | None]]:
        """Parts without which `dependent_angles` finds an angle, with its result.

        ``part`` contains the part of each sighting. A standard deviation is largest without all
        candidates. If no angle depends on all together, none depends on one of them, and hundreds
        of parts are tested by a few solutions.
        """
        angles = dependent_angles(np.isin(part, candidates), least)
        if angles == ():
            return
        if len(candidates) == 1:
            yield int(candidates[0]), angles
            return
        for half in np.array_split(candidates, 2):
            yield from needed_parts(part, half, least)

    targets = observations.targets
    if len(targets) > 1:
        part, candidates = observations.target_of_sighting, np.arange(len(targets))
        for k, angles in needed_parts(part, candidates, MAX_CHECK_SIGMA):
            if angles is None:
                yield UncontrolledObservations("target", targets[k])
            else:
                yield UncontrolledObservations("sighting", targets[k], angles=angles)
    if len(targets) > 1 and origins is not None:
        for members, size in _target_clusters(linearised, origins):
            names = tuple(np.array(targets)[members].tolist())
            if len(members) == len(targets):
                yield UncontrolledObservations("clustered", size=size)
                continue
            own = np.isin(observations.target_of_sighting, members)
            angles = dependent_angles(own, MAX_CHECK_SIGMA)
            if angles != ():
                yield UncontrolledObservations(
                    "clustered", angles=angles or ANGLES, size=size, targets=names
                )
    if needed or count > MAX_TESTED_SIGHTINGS:
        return
    for k, carried in needed_parts(np.arange(count), np.arange(count)):
        if carried:
            sighting = observations.sightings[k]
            yield UncontrolledObservations("sighting", sighting.target, sighting.line, carried)


def _target_clusters(
    linearised: LinearisedProblem, origins: Array
) -> Iterator[tuple[NDArray[np.int64], float]]:
    """Targets that are so close together that they act as one: indices, and relative extent.

    The extent is the largest distance between two of them divided by the mean range of the points.
    """
    from scipy.cluster.hierarchy import fcluster, linkage
    from scipy.spatial.distance import pdist

    points = linearised.problem.observations.points_lidar
    spacing = pdist(origins) / np.linalg.norm(points, axis=1).mean()
    if spacing.max() < MAX_CLUSTER_RATIO:
        yield np.arange(len(origins)), float(spacing.max())
        return
    label = fcluster(linkage(spacing, "complete"), MAX_CLUSTER_RATIO, "distance")
    for k in np.unique(label):
        members = np.flatnonzero(label == k)
        if len(members) > 1:
            yield (
                members,
                float(pdist(origins[members]).max() / pdist(origins).max() * spacing.max()),
            )


def _one_orientation_notes(linearised: LinearisedProblem) -> Iterator[Message]:
    """Notes on geometries that determine the angles but do not check them."""
    observations = linearised.problem.observations
    targets = observations.targets
    if len(targets) == 1:
        if observations.is_sphere[0]:
            yield note("observability.one_sphere", target=targets[0])
        else:
            yield note("adjustment.one_target", target=targets[0])
    elif have_targets_one_orientation(linearised):
        yield note("adjustment.one_facing")


def _sigmas_without_groups(linearised: LinearisedProblem, mask: NDArray[np.bool_]) -> Array | None:
    min_lines = 2 if linearised.control is None else 1
    if len({s.line for s, g in zip(linearised.problem.observations.sightings, mask, strict=True)
            if not g}) < min_lines:  # fmt: skip
        return None
    information = linearised.normal_without_sightings(mask).information(3)
    if np.linalg.eigvalsh(information)[0] < MAX_ANGLE_SIGMA**-2:
        return None
    return np.asarray(np.sqrt(np.diag(np.linalg.inv(information))))


def _extreme_directions_note(eigenvalues: Array, directions: Array, sigma: Array) -> Message:
    weakest, weakest_sigma = _direction(eigenvalues[0], directions[:, 0], sigma)
    strongest, strongest_sigma = _direction(eigenvalues[2], directions[:, 2], sigma)
    return note(
        "observability.directions",
        weakest=weakest, weakest_sigma=weakest_sigma,
        strongest=strongest, strongest_sigma=strongest_sigma,
    )  # fmt: skip


def _direction(eigenvalue: float, direction: Array, sigma: Array) -> tuple[Message, float]:
    """Name of a direction and its standard deviation.

    A direction that is named by one angle has the standard deviation of this angle, which is given
    elsewhere; that of the eigenvector differs slightly.
    """
    name = angle_combination(direction)
    for k, angle in enumerate(ANGLES):
        if name == note(ANGLE_CODES[angle]):
            return name, float(sigma[k])
    return name, float(eigenvalue**-0.5)


def _main_lines_by_angle(sigma: Array, without: dict[str, Array | None]) -> Iterator[Message]:
    """Notes on the lines that each angle depends on most."""
    for k, angle in enumerate(ANGLES):
        grown = _sigma_ratios(k, sigma, without)
        lines = sorted(
            (line for line in grown if grown[line] > MIN_LINE_SIGMA_RATIO), key=lambda x: -grown[x]
        )
        if lines:
            now = float(sigma[k])
            yield note(
                "observability.main_lines",
                count=len(lines), lines=lines, angle=note(ANGLE_CODES[angle]), line=lines[0],
                without=grown[lines[0]] * now, sigma=now,
            )  # fmt: skip
    yield from largest_increases_note(sigma, without)


def largest_increases_note(sigma: Array, without: Mapping[str, Array | None]) -> Iterator[Message]:
    """Note on the largest increase of the sigma of each angle that no line mainly determines.

    Parameters
    ----------
    sigma : ndarray of shape (3,), radians
    without : as in `Observability.sigma_without_line`
    """
    increases = []
    for k, angle in enumerate(ANGLES):
        grown = _sigma_ratios(k, sigma, without)
        if not grown or len(grown) < len(without):
            continue
        line = max(grown, key=lambda each: grown[each])
        if grown[line] <= MIN_LINE_SIGMA_RATIO:
            increase, name = max(0.0, grown[line] - 1.0), note(ANGLE_CODES[angle])
            increases.append(note("item.sigma_increase", angle=name, increase=increase, line=line))
    if increases:
        yield note("observability.largest_increases", angles=increases)


def _sigma_ratios(k: int, sigma: Array, without: Mapping[str, Array | None]) -> dict[str, float]:
    """Ratio of the sigma of angle ``k`` without each line to that with all lines."""
    return {line: float(own[k] / sigma[k]) for line, own in without.items() if own is not None}
