"""Repeated selection of the points of each target with the estimated boresight."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import TargetNotFound
from lispac.language import gettext_lazy
from lispac.progress import Progress, no_progress
from lispac.project import PickedSighting, Project, Target
from lispac.survey.cloud import Cloud
from lispac.targets.boresight_smear import ROUGH_BORESIGHT_SIGMA
from lispac.targets.plane_finder import PlanePatch
from lispac.targets.sighting_agreement import PlacementAccuracy, split_by_agreement
from lispac.targets.sphere_finder import SpherePatch
from lispac.workflow.calibration.target_search import (
    ALIGNED_MAX_SHIFT,
    CLICK_RADIUS,
    TargetSearch,
)
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

ESTIMATED_ACCURACY = PlacementAccuracy(ROUGH_BORESIGHT_SIGMA)
"""Accuracy of lines placed with an adjusted boresight. It is not better than roughly aligned,
because the first adjustment used points selected with the prior boresight."""

THRESHOLD_FACTOR = 2 / 3
"""Factor on the threshold of the pick once boresight errors no longer smear the surface: two LiDAR
sigmas instead of three. It applies only to planes, because the profiles of a sphere are displaced
by the motion of the vessel, which remains."""

THRESHOLD_SIGMAS = 3.0
"""Threshold of the pick in standard deviations of the LiDAR noise."""


def reselect_targets(
    project: Project, survey: Survey, *, progress: Progress = no_progress
) -> Project:
    """Search every used target again, in lines placed with the estimated boresight.

    Sightings that are not found again or that were edited by hand keep their points, and so do all
    of a target if another surface is found on most lines. No sighting is added, because the user
    chooses the lines in which a target is used.
    """
    clouds = survey.placed(project, "estimated")
    used = [target for target in project.targets_of_role("target") if target.used_sightings]
    for k, target in enumerate(used):
        progress(
            k / len(used),
            gettext_lazy("Reselecting the points of {target}", target=target.name),
        )
        again = reselect_target(target, survey.clouds, clouds)
        project = replace(
            project,
            targets=tuple(again if other is target else other for other in project.targets),
        )
    return project


def reselect_target(
    target: Target,
    before: Mapping[str, Cloud],
    after: Mapping[str, Cloud],
    *,
    threshold_factor: float = THRESHOLD_FACTOR,
) -> Target:
    """Search the used sightings of a target again, in lines placed differently.

    Parameters
    ----------
    before, after : lines by name, as placed when the target was picked and as placed now
    threshold_factor : float
        Factor on the threshold of the pick; not applied to spheres.
    """
    line, seed = _moved_seed(target, before, after)
    factor = threshold_factor if target.shape == "plane" else 1.0
    settings = target.choices.settings(
        threshold=factor * target.threshold, radius=target.radius, max_shift=ALIGNED_MAX_SHIFT
    )
    lines = {sighting.line: after[sighting.line] for sighting in target.used_sightings}
    search = TargetSearch.for_target(target)
    try:
        found, _ = search.find_in_lines(
            lines, seed, settings, first_line=line, accuracy=ESTIMATED_ACCURACY
        )
    except TargetNotFound:
        return target
    if not _is_same_target(search, target, found, after):
        return target
    return replace(
        target,
        sightings=tuple(
            PickedSighting(
                s.line,
                found[s.line].indices,
                found[s.line].rms,
                s.used,
                one_in=found[s.line].one_in,
            )
            if s.line in found and not s.by_hand
            else s
            for s in target.sightings
        ),
    )


def _is_same_target(
    search: TargetSearch,
    target: Target,
    found: Mapping[str, PlanePatch | SpherePatch],
    after: Mapping[str, Cloud],
) -> bool:
    """Whether the surface found again is that of most sightings before.

    Behind a small board, a wall has more points than the board, and would replace it on all lines.
    A single sighting that was on another surface than the others is corrected; of two sightings,
    neither is known to be right.
    """
    # Both selections are of one line: boresight and POS do not move one against the other.
    accuracy = PlacementAccuracy(boresight=0.0, offset=target.threshold / THRESHOLD_SIGMAS)
    other_surface = []
    for sighting in target.used_sightings:
        cloud = after[sighting.line]
        if sighting.line not in found:
            continue
        try:
            before = search.patch_of_points(cloud, sighting.indices)
        except TargetNotFound:
            continue
        patches: dict[str, PlanePatch | SpherePatch] = {
            "before": before, "again": found[sighting.line],
        }  # fmt: skip
        clouds = dict.fromkeys(patches, cloud)
        _, rejected = split_by_agreement(patches, clouds, accuracy, target.radius, "before")
        other_surface.append(bool(rejected))
    return 2 * sum(other_surface) < len(other_surface) or not other_surface


def _moved_seed(
    target: Target, before: Mapping[str, Cloud], after: Mapping[str, Cloud]
) -> tuple[str, Array]:
    """Line of the sighting point nearest to the seed, and the seed moved with that point.

    If the seed was not on the points (a typed seed and a wrong prior boresight), the point in their
    middle is the seed: another surface may be nearer to the moved seed.
    """
    seed = np.array(target.seed)
    nearest: list[tuple[float, str, int]] = []
    for sighting in target.used_sightings:
        distances = np.linalg.norm(before[sighting.line][sighting.indices] - seed, axis=1)
        k = int(np.argmin(distances))
        nearest.append((float(distances[k]), sighting.line, int(sighting.indices[k])))
    distance, line, number = min(nearest)
    if distance > CLICK_RADIUS:
        indices = next(each.indices for each in target.used_sightings if each.line == line)
        points = after[line][indices]
        middle = np.linalg.norm(points - points.mean(axis=0), axis=1)
        return line, points[np.argmin(middle)]
    own = np.array([number])
    return line, seed + after[line][own][0] - before[line][own][0]
