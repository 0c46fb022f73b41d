"""The points of every target selected again with the boresight found so far."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import TargetNotFound
from lispac.language import gettext_lazy
from lispac.progress import Progress, no_progress
from lispac.project import PickedSighting, Project, Target
from lispac.survey.cloud import Cloud
from lispac.targets.agreement import PlacementAccuracy
from lispac.targets.smear import ROUGHLY_OFF
from lispac.workflow.survey import Survey
from lispac.workflow.target_search import MET_SHIFT, TargetSearch

Array = NDArray[np.float64]

ESTIMATED = PlacementAccuracy(ROUGHLY_OFF)
"""Of lines that an adjustment has placed; the first one used points smeared by the prior."""

NARROWED = 2 / 3
"""Share of the pick's threshold that is left once the boresight no longer smears the surface: two
LiDAR sigma where the pick took three. For planes alone: what displaces the profiles of a sphere is
the motion of the vessel, and that stays."""


def reselect(project: Project, survey: Survey, *, progress: Progress = no_progress) -> Project:
    """Search again for every used target, in lines placed with the estimated boresight.

    A sighting that is not found again keeps its points, and so does one that was edited by hand. No
    sighting is added: which lines a
    target is used in is the user's choice.
    """
    clouds = survey.placed(project, "estimated")
    used = [target for target in project.of_role("target") if target.used_sightings]
    for k, target in enumerate(used):
        progress(
            k / len(used),
            gettext_lazy("Reselecting the points of {target}", target=target.name),
        )
        again = selected_again(target, survey.clouds, clouds)
        project = replace(
            project,
            targets=tuple(again if other is target else other for other in project.targets),
        )
    return project


def selected_again(
    target: Target,
    before: Mapping[str, Cloud],
    after: Mapping[str, Cloud],
    *,
    narrowed: float = NARROWED,
) -> Target:
    """The used sightings of a target, searched for in lines with another boresight.

    Parameters
    ----------
    before, after : lines by name, as the target was picked in them and as they are placed now
    narrowed : float
        Share of the threshold of the pick; that of a sphere stays.
    """
    line, seed = _moved_seed(target, before, after)
    narrowed = narrowed if target.shape == "plane" else 1.0
    settings = target.choices.settings(
        threshold=narrowed * target.threshold, radius=target.radius, max_shift=MET_SHIFT
    )
    lines = {sighting.line: after[sighting.line] for sighting in target.used_sightings}
    try:
        found, _ = TargetSearch.of(target).in_lines(
            lines, seed, settings, first_line=line, accuracy=ESTIMATED
        )
    except TargetNotFound:
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


def _moved_seed(
    target: Target, before: Mapping[str, Cloud], after: Mapping[str, Cloud]
) -> tuple[str, Array]:
    """The seed moves as the sighting's point nearest to it does; that point's line and the seed."""
    seed = np.array(target.seed)
    nearest: list[tuple[float, str, int]] = []
    for sighting in target.used_sightings:
        apart = np.linalg.norm(before[sighting.line][sighting.indices] - seed, axis=1)
        k = int(np.argmin(apart))
        nearest.append((float(apart[k]), sighting.line, int(sighting.indices[k])))
    _, line, number = min(nearest)
    own = np.array([number])
    return line, seed + after[line][own][0] - before[line][own][0]
