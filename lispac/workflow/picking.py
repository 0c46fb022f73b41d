"""From a seed to a target: the plane in every line."""

import itertools
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound, ProjectError
from lispac.progress import Progress, no_progress
from lispac.project import PickedSighting, Project, Role, Target, Triple
from lispac.targets.across_lines import find_in_lines
from lispac.targets.finder import FinderSettings, PlanePatch, find_plane
from lispac.workflow.survey import Survey

DEFAULT_RADII: dict[Role, tuple[float, ...]] = {"target": (2.0,), "validation": (4.0, 10.0, 20.0)}
"""Metres about the seed, tried in turn until two lines have the plane.

A board fits into two metres. A validation plane is a piece of a wall or a tower, where more points
tell more, and the place given for its middle may be hidden from the lines or out of their reach.
"""


def find(
    project: Project,
    survey: Survey,
    seed: Triple | NDArray[np.float64],
    *,
    name: str,
    role: Role = "target",
    line: str | None = None,
    first_line: str | None = None,
    threshold: float | None = None,
    radius: float | None = None,
    progress: Progress = no_progress,
) -> Target:
    """Find the plane at a seed: what `pick` would add.

    Parameters
    ----------
    seed : metres, local frame
    line : str, optional
        Seek in this line only; the other sightings of a target of that name are kept.
    first_line : str, optional
        The line the seed was clicked on, where that is known.
    threshold : float, metres, optional
        RANSAC distance threshold.
    radius : float, metres, optional
        Search radius about the seed; `DEFAULT_RADII` where not given.

    Raises
    ------
    PlaneNotFound
    """
    radii = DEFAULT_RADII[role] if radius is None else (radius,)
    settings = FinderSettings(
        threshold=project.settings.threshold if threshold is None else threshold, radius=radii[0]
    )
    centre = np.asarray(seed, dtype=float)
    place: Triple = (float(centre[0]), float(centre[1]), float(centre[2]))
    if line is not None:
        if line not in survey.clouds:
            raise ProjectError(
                f"{project.name}: there is no line {line}; the lines are {', '.join(survey.lines)}."
            )
        patch = find_plane(survey.clouds[line], centre, settings)
        sighting = _sighting(survey, line, patch)
        return _with_sighting(project, name, role, place, settings, sighting)
    found, missing, radius = _in_lines(survey, centre, settings, radii, first_line, progress)
    sightings = tuple(_sighting(survey, n, found[n]) for n in survey.lines if n in found)
    return Target(name, role, place, settings.threshold, radius, sightings, missing)


def pick(
    project: Project,
    survey: Survey,
    seed: Triple | NDArray[np.float64],
    *,
    name: str,
    role: Role = "target",
    line: str | None = None,
    threshold: float | None = None,
    radius: float | None = None,
    progress: Progress = no_progress,
) -> Project:
    """Find the plane at a seed in every line (or one) and add it to the project.

    Raises
    ------
    PlaneNotFound
    """
    target = find(
        project, survey, seed, name=name, role=role, line=line,
        threshold=threshold, radius=radius, progress=progress,
    )  # fmt: skip
    return project.with_target(target)


def next_name(project: Project, role: Role) -> str:
    """First free name: T1, T2 ... for targets, V1, V2 ... for validation planes."""
    taken = {target.name for target in project.targets}
    letter = "T" if role == "target" else "V"
    return next(f"{letter}{k}" for k in itertools.count(1) if f"{letter}{k}" not in taken)


def _sighting(survey: Survey, line: str, patch: PlanePatch) -> PickedSighting:
    fingerprint = survey.scans[line].fingerprint
    return PickedSighting(line, patch.indices, patch.rms, fingerprint=fingerprint)


def _in_lines(
    survey: Survey,
    seed: NDArray[np.float64],
    settings: FinderSettings,
    radii: tuple[float, ...],
    first_line: str | None,
    progress: Progress,
) -> tuple[dict[str, PlanePatch], dict[str, str], float]:
    """Patches, reasons and radius of the first radius that two lines answer to.

    Where none does, those of the radius that most lines answer to, the smallest of these.
    """
    best: tuple[dict[str, PlanePatch], dict[str, str], float] | None = None
    refusal: PlaneNotFound | None = None
    for radius in radii:
        try:
            found, missing = find_in_lines(
                survey.clouds,
                seed,
                replace(settings, radius=radius),
                first_line=first_line,
                progress=progress,
            )
        except PlaneNotFound as error:
            refusal = refusal or error
            continue
        if best is None or len(found) > len(best[0]):
            best = (found, missing, radius)
        if len(found) >= 2:
            break
    if best is None:
        raise refusal or PlaneNotFound("There is no line to seek a plane in.")
    return best


def _with_sighting(
    project: Project,
    name: str,
    role: Role,
    seed: Triple,
    settings: FinderSettings,
    sighting: PickedSighting,
) -> Target:
    known = next((target for target in project.targets if target.name == name), None)
    if known is not None and known.role != role:
        raise ProjectError(
            f"{project.name}: {name} is a {known.role} already; pick it in the same role, or give "
            "another name."
        )
    if known is None:
        return Target(name, role, seed, settings.threshold, settings.radius, (sighting,), {})
    order = [line.name for line in project.lines]
    kept = [s for s in known.sightings if s.line != sighting.line]
    sightings = sorted([*kept, sighting], key=lambda s: order.index(s.line))
    missing = {line: reason for line, reason in known.missing.items() if line != sighting.line}
    return replace(known, sightings=tuple(sightings), missing=missing)
