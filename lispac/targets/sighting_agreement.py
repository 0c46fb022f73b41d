"""Test whether the surfaces found in several lines are the same target.

The lines are placed with a boresight of known uncertainty. Therefore the inclination and position
of a target may differ between lines by a certain amount. Surfaces that differ by more are different
targets (congruence test of two epochs: Pelzer 1971).
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import combinations
from math import radians, sqrt
from statistics import NormalDist
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import plane_axes
from lispac.messages import Message, note
from lispac.survey.cloud import Cloud
from lispac.targets import outline
from lispac.targets.boresight_smear import PRIOR_BORESIGHT_SIGMA
from lispac.targets.occlusion import does_plane_end_within
from lispac.targets.plane_finder import PlanePatch
from lispac.targets.sphere_finder import SpherePatch

Array = NDArray[np.float64]

SIGNIFICANCE_LEVEL = 1e-3
"""Significance level of the tests: probability of rejecting a sighting of the same surface."""
EFFECTIVE_POINTS = 4
"""Number of independent points assumed for a sighting. The scatter of its points about the plane is
mainly form error and POS error, which neighbouring points share; lines may also show different
parts of an uneven surface such as a tarpaulin."""
MAX_TESTED_POINTS = 500
"""Largest number of points of a sighting used in the tests."""
DERIVATIVE_STEP = radians(0.01)
"""Step of the numerical derivatives with respect to the boresight angles, radians."""
MIN_OVERLAP = 0.5
"""Smallest share of the points of one of two sightings inside the outline of the other one."""
MIN_COMPLETE_SIZE_RATIO = 0.8
"""Smallest ratio of the sides of an outline to the largest ones for it to count as complete."""
MAX_BOARD_SEARCH_RADIUS = 2.0
"""Radius, metres, that replaces a larger search radius in the test whether planes are boards."""
SPHERE_CENTRE_SIGMA = 0.5
"""Standard deviation of the centre of a sphere from one line, which shows only a part, in radii."""

Patch = TypeVar("Patch", bound=PlanePatch | SpherePatch)


@dataclass(frozen=True)
class PlacementAccuracy:
    """Accuracy of the positions of lines relative to each other.

    Attributes
    ----------
    boresight : float, radians
        Standard deviation of each boresight angle.
    offset : float, metres
        Standard deviation of the distance between surfaces of two lines due to other causes (POS).
    """

    boresight: float = PRIOR_BORESIGHT_SIGMA
    offset: float = 0.05


PRIOR_ACCURACY = PlacementAccuracy()
"""Accuracy of lines placed with an unconfirmed prior boresight."""


def split_by_agreement(
    found: Mapping[str, Patch],
    clouds: Mapping[str, Cloud],
    accuracy: PlacementAccuracy,
    radius: float,
    first_line: str | None,
) -> tuple[dict[str, Patch], dict[str, Message]]:
    """Separate the sightings that show the same surface from those to be rejected.

    All pairs of sightings are compared. The sighting that disagrees with most others is rejected,
    until all remaining ones agree. Planes are compared by inclination and offset, then by their
    outlines, which have to overlap. If two lines show the whole target, the outlines also have to
    be at the same position.

    Parameters
    ----------
    found : mapping of line name to PlanePatch or SpherePatch
        Their indices refer to the lines.
    clouds : mapping of line name to Cloud
    accuracy : PlacementAccuracy
        Accuracy of the positions of these lines.
    radius : float, metres
        Search radius. Outlines of large planes, and of those cut by the radius, are not compared,
        since lines may show different parts of a deck or a wall.
    first_line : str or None
        The clicked line, if known. Its sighting is never rejected.

    Returns
    -------
    kept : dict of line name to PlanePatch or SpherePatch
    rejected : dict of line name to Message
        Reasons for the rejections.
    """
    samples = {name: _SightingSample.of(found[name], clouds[name]) for name in found}
    rejected: dict[str, Message] = {}

    def reject(disagreement: "Disagreement") -> None:
        left = {name: samples[name] for name in samples if name not in rejected}
        rejected.update(_reject_minority(left, disagreement, first_line))

    reject(lambda first, second: _surface_disagreement(first, second, accuracy))
    planes = {
        name: each
        for name, each in samples.items()
        if name not in rejected and isinstance(each.patch, PlanePatch)
    }
    extents = [each.extent for each in planes.values()]
    if len(planes) > 1 and does_plane_end_within(min(radius, MAX_BOARD_SEARCH_RADIUS), extents):
        rejected |= _reject_separate_planes(planes, accuracy, first_line)
        largest = np.max([planes[n].extent for n in planes if n not in rejected], axis=0)
        reject(lambda first, second: _position_disagreement(first, second, accuracy, largest))
    return {name: patch for name, patch in found.items() if name not in rejected}, rejected


def _reject_minority(
    samples: Mapping[str, "_SightingSample"], disagreement: "Disagreement", first_line: str | None
) -> dict[str, Message]:
    """Reject sightings until all others agree; return the reasons for the rejected ones."""
    reasons: dict[str, dict[str, Message]] = {name: {} for name in samples}
    for first, second in combinations(samples, 2):
        reason = disagreement(samples[first], samples[second])
        if reason is not None:
            reasons[first][second] = reasons[second][first] = reason
    rejected: dict[str, Message] = {}
    while any(reasons.values()):
        suspects = [name for name in reasons if name != first_line and reasons[name]]
        # Of two sightings with equally many disagreements, the later one is rejected.
        worst = max(reversed(suspects), key=lambda name: len(reasons[name]))
        others = reasons.pop(worst)
        rejected[worst] = others.get(first_line or "", next(iter(others.values())))
        for name in others:
            del reasons[name][worst]
    return rejected


def _reject_separate_planes(
    planes: Mapping[str, "_SightingSample"], accuracy: PlacementAccuracy, first_line: str | None
) -> dict[str, Message]:
    """Reject planes whose outlines overlap those of the target neither directly nor indirectly.

    Two outlines also belong together if both overlap that of a third line: a post may occlude one
    half of a board in one line and the other half in another one.
    """
    overlaps = {
        frozenset((a, b)): _outline_overlap(planes[a], planes[b], accuracy)
        for a, b in combinations(planes, 2)
    }
    groups: list[set[str]] = []
    for name in planes:
        joined = [
            group
            for group in groups
            if any(overlaps[frozenset((name, other))] >= MIN_OVERLAP for other in group)
        ]
        groups = [group for group in groups if group not in joined]
        groups.append({name}.union(*joined))
    target = next(
        (group for group in groups if first_line in group),
        max(sorted(groups, key=lambda group: min(map(list(planes).index, group))), key=len),
    )
    rejected = {}
    for name in planes:
        if name not in target:
            share = max(overlaps[frozenset((name, other))] for other in target)
            rejected[name] = note("agreement.no_overlap", share=share)
    return rejected


@dataclass(frozen=True, eq=False)
class _SightingSample:
    """A patch and a sample of its points.

    ``points`` has shape (n, 3). ``moves`` has shape (3, n, 3) and contains the derivatives of the
    points with respect to the boresight angles, metres per radian.
    """

    patch: PlanePatch | SpherePatch
    points: Array
    moves: Array

    @property
    def extent(self) -> Array:
        """Width and height of a plane, shape (2,), metres."""
        assert isinstance(self.patch, PlanePatch)
        return self.patch.extent

    @classmethod
    def of(cls, patch: PlanePatch | SpherePatch, cloud: Cloud) -> "_SightingSample":
        indices = patch.indices[:: 1 + len(patch.indices) // MAX_TESTED_POINTS]
        mounting = cloud.place.mounting
        points = cloud[indices]
        turned = [
            cloud.georeferenced_with(
                mounting.with_boresight(mounting.boresight + DERIVATIVE_STEP * axis)
            )[indices]
            for axis in np.eye(3)
        ]
        return cls(patch, points, np.stack([(each - points) / DERIVATIVE_STEP for each in turned]))


def _surface_disagreement(
    reference: _SightingSample, other: _SightingSample, accuracy: PlacementAccuracy
) -> Message | None:
    """Reason why two sightings show different surfaces, without regard to their outlines."""
    first, second = reference.patch, other.patch
    if isinstance(first, PlanePatch) and isinstance(second, PlanePatch):
        return _plane_disagreement(reference, other, first, second, accuracy)
    if isinstance(first, SpherePatch) and isinstance(second, SpherePatch):
        centre_sigma = SPHERE_CENTRE_SIGMA * max(first.sphere.radius, second.sphere.radius)
        allowed = _allowed_shift(reference, other, accuracy, centre_sigma)
        distance = float(np.linalg.norm(second.centre - first.centre))
        if distance > allowed:
            return note("agreement.sphere_apart", distance=distance, limit=allowed)
    return None


def _plane_disagreement(
    reference: _SightingSample,
    other: _SightingSample,
    plane: PlanePatch,
    patch: PlanePatch,
    accuracy: PlacementAccuracy,
) -> Message | None:
    """Test inclination and offset along the normal (chi-square, three degrees of freedom)."""
    from scipy.special import chdtri

    normal = plane.plane.normal
    axes = np.vstack([plane_axes(normal), normal])
    middle = other.points.mean(axis=0)
    # Height above the reference plane as a linear function: h = slope_u u + slope_v v + offset.
    own = axes @ patch.plane.facing(normal).normal
    offset = float(plane.plane.distances(middle))
    turned = _plane_derivatives(other, axes, middle) - _plane_derivatives(reference, axes, middle)
    covariance = accuracy.boresight**2 * turned @ turned.T
    for each, rms in ((reference, plane.rms), (other, patch.rms)):
        covariance += _plane_covariance(each, axes, middle, rms)
    covariance[2, 2] += accuracy.offset**2
    statistic = np.inf
    if own[2] > 0.0:
        deviation = np.array([-own[0] / own[2], -own[1] / own[2], offset])
        statistic = float(deviation @ np.linalg.solve(covariance, deviation))
    if statistic <= chdtri(3, SIGNIFICANCE_LEVEL):
        return None
    tilt = patch.plane.tilt_to(plane.plane)
    return note("agreement.other_plane", tilt=tilt, offset=abs(offset))


def _position_disagreement(
    reference: _SightingSample, other: _SightingSample, accuracy: PlacementAccuracy, largest: Array
) -> Message | None:
    """Test the position along the surface, if both lines show all of it."""
    if any((each.extent < MIN_COMPLETE_SIZE_RATIO * largest).any() for each in (reference, other)):
        return None
    first, second = _in_plane_coordinates(reference, other)
    # Different edges of the target may be missing, as far as both outlines count as complete.
    max_missing = (1.0 - MIN_COMPLETE_SIZE_RATIO) * float(np.linalg.norm(largest))
    allowed = _allowed_shift(reference, other, accuracy, 0.0) + max_missing
    middles = [(each.min(axis=0) + each.max(axis=0)) / 2.0 for each in (first, second)]
    distance = float(np.linalg.norm(middles[1] - middles[0]))
    if distance <= allowed:
        return None
    return note("agreement.plane_beside", distance=distance, limit=allowed)


def _outline_overlap(
    reference: _SightingSample, other: _SightingSample, accuracy: PlacementAccuracy
) -> float:
    """Larger of the two shares of one outline that the other covers, within the accuracy."""
    first, second = _in_plane_coordinates(reference, other)
    cell = max(
        _allowed_shift(reference, other, accuracy, 0.0) / 2.0,
        *(outline.outline_cell_size(each, np.ones(len(each))) for each in (first, second)),
    )
    return max(
        float(outline.is_covered(first, second, cell).mean()),
        float(outline.is_covered(second, first, cell).mean()),
    )


def _in_plane_coordinates(
    reference: _SightingSample, other: _SightingSample
) -> tuple[Array, Array]:
    """Coordinates of both sightings in the plane of the first, (n, 2) and (m, 2), metres."""
    assert isinstance(reference.patch, PlanePatch)
    axes = plane_axes(reference.patch.plane.normal)
    return reference.points @ axes.T, other.points @ axes.T


def _allowed_shift(
    reference: _SightingSample,
    other: _SightingSample,
    accuracy: PlacementAccuracy,
    position_sigma: float,
) -> float:
    """Largest distance between two sightings of one target, metres.

    ``position_sigma`` is an additional standard deviation of the position of each sighting, metres.
    """
    middles = [each.moves.mean(axis=1) for each in (reference, other)]
    by_boresight = accuracy.boresight * float(np.linalg.norm(middles[1] - middles[0]))
    sigmas = -NormalDist().inv_cdf(SIGNIFICANCE_LEVEL / 2.0)
    return sigmas * sqrt(by_boresight**2 + accuracy.offset**2 + 2.0 * position_sigma**2)


def _plane_derivatives(sighting: _SightingSample, axes: Array, middle: Array) -> Array:
    """Derivatives of slopes and offset at ``middle`` by the boresight angles, shape (3, 3)."""
    design = _design_matrix(sighting.points, axes, middle)
    moves = (sighting.moves @ axes[2]).T
    solved, *_ = np.linalg.lstsq(design, moves, rcond=1e-6)
    return np.asarray(solved)


def _plane_covariance(sighting: _SightingSample, axes: Array, middle: Array, rms: float) -> Array:
    """Covariance of slopes and offset at ``middle`` of a fitted plane, shape (3, 3)."""
    design = _design_matrix(sighting.points, axes, middle)
    normal = design.T @ design / len(design)
    return np.asarray(rms**2 / EFFECTIVE_POINTS * np.linalg.pinv(normal, rcond=1e-12))


def _design_matrix(points: Array, axes: Array, middle: Array) -> Array:
    placed = (points - middle) @ axes[:2].T
    return np.column_stack([placed, np.ones(len(points))])


Disagreement = Callable[[_SightingSample, _SightingSample], Message | None]
"""Function that returns why two sightings cannot show the same target, or None if they can."""
