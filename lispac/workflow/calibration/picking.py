"""Picking of a target at a seed: search for its plane or sphere in every line."""

import itertools
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError, TargetNotFound
from lispac.messages import Message, error
from lispac.progress import Progress, no_progress
from lispac.project import (
    PickedSighting,
    Project,
    Role,
    Shape,
    Target,
    Triple,
    require_valid_target,
)
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices
from lispac.targets.plane_finder import FinderSettings
from lispac.targets.sighting_agreement import split_by_agreement
from lispac.targets.sphere_finder import SpherePatch
from lispac.workflow.calibration.target_search import DEFAULT_RADII as DEFAULT_RADII
from lispac.workflow.calibration.target_search import Patch, SearchPlace, TargetSearch
from lispac.workflow.project.survey import Survey


def find_target(
    project: Project,
    survey: Survey,
    seed: Triple | NDArray[np.float64],
    *,
    name: str,
    role: Role = "target",
    shape: Shape = "plane",
    sphere_radius: float | None = None,
    line: str | None = None,
    first_line: str | None = None,
    threshold: float | None = None,
    radius: float | None = None,
    expected: ExpectedTarget | None = None,
    choices: FinderChoices = DEFAULT_CHOICES,
    progress: Progress = no_progress,
) -> Target:
    """Find the target at a seed, without adding it to the project.

    Parameters
    ----------
    seed : ndarray of shape (3,) or three floats, metres, local frame
    sphere_radius : float, metres, optional
        Radius of a sphere, if it is known.
    line : str, optional
        Only line to search; the other sightings of a target of that name are kept.
    first_line : str, optional
        Line in which the seed was clicked, if it is known.
    threshold : float, metres, optional
        RANSAC distance threshold; by default that of the project, or a larger one for spheres.
    radius : float, metres, optional
        Search radius about the seed; by default those of `TargetSearch.search_radii` in turn.
    expected : ExpectedTarget, optional
        Expected size and inclination of a plane, with which the detected planes are compared.
    choices : FinderChoices
        Finder options, for example the smallest number of points and the largest tilt; stored with
        the target.

    Raises
    ------
    TargetNotFound
        If no target is found in any line.
    ProjectError
        If there is no such line, the shape does not suit the role, or the sighting in ``line``
        does not suit the existing target.
    """
    search = TargetSearch(shape, sphere_radius)
    radii = search.search_radii(role) if radius is None else (radius,)
    if threshold is None:
        threshold = search.threshold(project.settings.threshold)
    settings = choices.settings(threshold=threshold, radius=radii[0])
    centre = np.asarray(seed, dtype=float)
    at: Triple = (float(centre[0]), float(centre[1]), float(centre[2]))
    target = Target(
        name, role, at, threshold, radii[0], (), shape=shape, sphere_radius=sphere_radius,
        expected=expected if shape == "plane" else None, choices=choices,
    )  # fmt: skip
    require_valid_target(target)
    if line is not None:
        return _with_sighting_of_line(project, survey, search, target, line, settings)
    found, missing, radius = _find_in_lines(
        survey, search, centre, settings, radii, first_line, progress
    )
    sightings = tuple(_picked_sighting(survey, n, found[n]) for n in survey.lines if n in found)
    return replace(target, radius=radius, sightings=sightings, missing=missing)


def _with_sighting_of_line(
    project: Project,
    survey: Survey,
    search: TargetSearch,
    target: Target,
    line: str,
    settings: FinderSettings,
) -> Target:
    """Target with the sighting found in one line; the others are those of the project.

    Raises
    ------
    ProjectError
        If there is no such line, or the sighting does not suit the target of the project.
    """
    if line not in survey.clouds:
        raise ProjectError(
            error("project_line.not_found", project=project.name, line=line, lines=survey.lines)
        )
    known = next((each for each in project.targets if each.name == target.name), None)
    if known is not None:
        _require_same_kind(project, known, target)
    place = SearchPlace.of(survey.alignment, np.asarray(target.seed), line, settings.radius)
    patch = search.find_at_seed(place.clouds[line], place.seed, settings)
    if known is not None:
        _require_same_surface(known, search, place, line, patch)
    if known is not None and target.expected is not None:
        known = replace(known, expected=target.expected)
    return _with_sighting(project, known or target, _picked_sighting(survey, line, patch))


def pick_target(
    project: Project,
    survey: Survey,
    seed: Triple | NDArray[np.float64],
    *,
    name: str,
    role: Role = "target",
    shape: Shape = "plane",
    sphere_radius: float | None = None,
    line: str | None = None,
    threshold: float | None = None,
    radius: float | None = None,
    expected: ExpectedTarget | None = None,
    choices: FinderChoices = DEFAULT_CHOICES,
    progress: Progress = no_progress,
) -> Project:
    """Find the target at a seed in all lines or one and add it; parameters as for `find_target`.

    Raises
    ------
    TargetNotFound
        If no target is found in any line.
    ProjectError
        As `find_target`.
    """
    target = find_target(
        project, survey, seed, name=name, role=role, shape=shape,
        sphere_radius=sphere_radius, line=line, threshold=threshold, radius=radius,
        expected=expected, choices=choices, progress=progress,
    )  # fmt: skip
    return project.with_target(target)


def spheres_of(target: Target, survey: Survey) -> dict[str, SpherePatch]:
    """Sphere fitted to the points of each sighting, placed with the prior boresight.

    Raises
    ------
    SphereNotFound
        If the points of a sighting do not determine a sphere.
    """
    search = TargetSearch.for_target(target)
    found = {
        sighting.line: search.patch_of_points(survey.clouds[sighting.line], sighting.indices)
        for sighting in target.sightings
    }
    return {line: patch for line, patch in found.items() if isinstance(patch, SpherePatch)}


def _require_same_surface(
    known: Target, search: TargetSearch, place: SearchPlace, line: str, patch: Patch
) -> None:
    """Refuse to add a sighting of another surface to a target.

    Raises
    ------
    TargetNotFound
        If the new sighting disagrees with those of the other lines.
    """
    found: dict[str, Patch] = {}
    for sighting in known.used_sightings:
        if sighting.line != line:
            cloud = place.clouds[sighting.line]
            found[sighting.line] = search.patch_of_points(cloud, sighting.indices)
    found[line] = patch  # the new sighting is last: of two that disagree, the last is rejected
    _, rejected = split_by_agreement(found, place.clouds, place.accuracy, known.radius, None)
    if line in rejected:
        raise TargetNotFound(
            error("project.not_found_on_line", target=known.name, line=line, reason=rejected[line])
        )


def point_position(project: Project, survey: Survey, line: str, number: int) -> NDArray[np.float64]:
    """Position of a point of a line, placed with the prior boresight.

    Returns
    -------
    ndarray of shape (3,), metres, local frame

    Raises
    ------
    ProjectError
        If there is no such line or point.
    """
    _require_point_numbers(project.name, survey, line, np.array([number]))
    return survey.clouds[line][np.array([number])][0]


def require_survey_points(survey: Survey, target: Target) -> None:
    """Refuse a target whose points do not exist, or whose lines have changed since the pick.

    Raises
    ------
    ProjectError
        If a point does not exist, a line has changed or the target is not valid.
    """
    require_valid_target(target)
    for sighting in target.sightings:
        _require_point_numbers(target.name, survey, sighting.line, sighting.indices)
        if sighting.fingerprint not in ("", survey.scans[sighting.line].fingerprint):
            raise ProjectError(error("pick.points_changed", target=target.name, line=sighting.line))


def _require_point_numbers(
    what: str, survey: Survey, line: str, numbers: NDArray[np.int64]
) -> None:
    if line not in survey.scans:
        raise ProjectError(
            error("project_line.not_found", project=what, line=line, lines=survey.lines)
        )
    count = len(survey.scans[line])
    if len(numbers) and not 0 <= numbers.min() <= numbers.max() < count:
        raise ProjectError(
            error(
                "pick.no_such_point",
                name=what,
                line=line,
                last=count - 1,
                number=int(numbers.min() if numbers.min() < 0 else numbers.max()),
            )
        )


def next_name(project: Project, role: Role) -> str:
    """First free name: T1, T2 ... for targets, V1, V2 ... for validation planes."""
    used_names = {target.name for target in project.targets}
    letter = "T" if role == "target" else "V"
    return next(f"{letter}{k}" for k in itertools.count(1) if f"{letter}{k}" not in used_names)


def _picked_sighting(survey: Survey, line: str, patch: Patch) -> PickedSighting:
    fingerprint = survey.scans[line].fingerprint
    return PickedSighting(
        line, patch.indices, patch.rms, fingerprint=fingerprint, one_in=patch.one_in
    )


def _find_in_lines(
    survey: Survey,
    search: TargetSearch,
    seed: NDArray[np.float64],
    settings: FinderSettings,
    radii: tuple[float, ...],
    first_line: str | None,
    progress: Progress,
) -> tuple[Mapping[str, Patch], dict[str, Message], float]:
    """Search with increasing radii until a target is found on two lines.

    Returns the patches found by line, the reasons for the other lines, and the radius. If no radius
    gives two lines, the result is that of the smallest radius with the most lines.
    """
    best: tuple[Mapping[str, Patch], dict[str, Message], float] | None = None
    refusal: TargetNotFound | None = None
    for radius in radii:
        place = SearchPlace.of(survey.alignment, seed, first_line, radius)
        tried = replace(settings, radius=radius, max_shift=place.max_shift)
        try:
            found, missing = search.find_in_lines(
                place.clouds, place.seed, tried,
                first_line=place.line, accuracy=place.accuracy, progress=progress,
            )  # fmt: skip
        except TargetNotFound as failure:
            refusal = refusal or failure
            continue
        if best is None or len(found) > len(best[0]):
            best = (found, missing, radius)
        if len(found) >= 2:
            break
    if best is None:
        raise refusal or TargetNotFound(
            error("pick.no_line_plane" if search.shape == "plane" else "pick.no_line_sphere")
        )
    return best


def _require_same_kind(project: Project, known: Target, again: Target) -> None:
    if known.role != again.role:
        raise ProjectError(
            error(
                "pick.is_target" if known.role == "target" else "pick.is_validation_plane",
                project=project.name,
                target=known.name,
            )
        )
    TargetSearch.for_target(again).require_same(known)


def _with_sighting(project: Project, target: Target, sighting: PickedSighting) -> Target:
    order = [line.name for line in project.lines]
    kept = [s for s in target.sightings if s.line != sighting.line]
    sightings = sorted([*kept, sighting], key=lambda s: order.index(s.line))
    missing = {line: reason for line, reason in target.missing.items() if line != sighting.line}
    return replace(target, sightings=tuple(sightings), missing=missing)
