"""Checks of the picked planes against each other: orientation of targets, place of others."""

from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.errors import PlaneNotFound
from lispac.geometry.planes import fit_plane
from lispac.messages import Message, note
from lispac.project import PickedSighting, Project, Target
from lispac.survey.cloud import Cloud
from lispac.warning_causes import Cause
from lispac.workflow.project.survey import Survey

MAX_POINTS_PER_TARGET = 500
"""Largest number of points of a target used for its orientation."""
MAX_JOINT_RMS_RATIO = 1.5
"""Largest ratio of the RMS of one plane fitted to two surfaces and that of a plane for each."""


def have_targets_single_orientation(project: Project, survey: Survey) -> bool:
    """True if several planes are used, all of one orientation that the user has not accepted.

    The sighting with the most points of each plane is used, placed with the prior boresight. The
    estimation repeats the check with the adjusted planes.
    """
    used = [
        target
        for target in project.targets_of_role("target")
        if target.used and target.used_sightings
    ]
    if len(used) < 2 or project.settings.accept_single_orientation:
        return False
    if any(target.shape == "sphere" for target in used):
        return False
    normals = [_normal(target, survey) for target in used]
    known = [each for each in normals if each is not None]
    if len(known) < len(normals):
        return False  # the quality of the sighting reports this
    return have_one_orientation(np.array(known), np.zeros(len(known), dtype=bool))


def _normal(target: Target, survey: Survey) -> NDArray[np.float64] | None:
    """Normal of the sighting with the most points, shape (3,); None if it is not known."""
    sighting = max(target.used_sightings, key=lambda each: len(each.indices), default=None)
    cloud = None if sighting is None else survey.clouds.get(sighting.line)
    if sighting is None or cloud is None:
        return None
    try:
        return fit_plane(_sample(cloud, sighting)).normal
    except PlaneNotFound:
        return None


def validation_planes_on_targets(project: Project, survey: Survey) -> Iterator[Message]:
    """Notes on validation planes that lie in the plane of a target.

    Such a plane has other points than the target, but checks the angles in the same orientation.
    There is no note on it if another validation plane checks them in another orientation.
    """
    compared = [t for t in project.targets_of_role("validation") if t.used]
    planes = [t for t in project.targets_of_role("target") if t.used and t.shape == "plane"]
    same = [
        (plane, [each.name for each in planes if _lie_in_one_plane(plane, each, survey)])
        for plane in compared
    ]
    others = [_normal(plane, survey) for plane, names in same if not names]
    for plane, names in same:
        normal = _normal(plane, survey) if names else None
        is_checked = normal is not None and any(
            other is not None
            and not have_one_orientation(np.array([normal, other]), np.zeros(2, dtype=bool))
            for other in others
        )
        if names and not is_checked:
            yield note(
                "targets.validation_in_plane",
                plane=plane.name, targets=tuple(names), subject=Cause.of_target(plane.name),
            )  # fmt: skip


def _lie_in_one_plane(one: Target, other: Target, survey: Survey) -> bool:
    """Whether one plane fits two targets, on the line with the most points of both.

    On one line, an error of the boresight or of the position moves both alike.
    """
    pairs = [
        (a, b)
        for a, b in product(one.used_sightings, other.used_sightings)
        if a.line == b.line and a.line in survey.clouds
    ]
    if not pairs:
        return False
    best = max(pairs, key=lambda pair: min(len(each.indices) for each in pair))
    cloud = survey.clouds[best[0].line]
    count = min(MAX_POINTS_PER_TARGET, *(len(each.indices) for each in best))
    points = [_sample(cloud, each, count) for each in best]
    try:
        own = max(_plane_rms(each) for each in points)
        return _plane_rms(np.concatenate(points)) <= MAX_JOINT_RMS_RATIO * own
    except PlaneNotFound:
        return False  # the quality of the sighting reports this


def _sample(
    cloud: Cloud, sighting: PickedSighting, count: int = MAX_POINTS_PER_TARGET
) -> NDArray[np.float64]:
    """At most ``count`` points placed with the prior boresight, shape (n, 3), metres."""
    return cloud[sighting.indices[:: -(-len(sighting.indices) // count)]]


def _plane_rms(points: NDArray[np.float64]) -> float:
    return float(np.sqrt(np.mean(fit_plane(points).distances(points) ** 2)))
