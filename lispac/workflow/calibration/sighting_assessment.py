"""Assessment of the quality of each sighting of a project."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import LispacError
from lispac.geometry.planes import extent_in_plane, fit_plane
from lispac.geometry.spheres import fit_sphere
from lispac.language import gettext_lazy
from lispac.messages import Message, as_message, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import PickedSighting, Project, Role, Target
from lispac.survey.georeferencing import Georeferencer, directions_to_lidar
from lispac.targets.boresight_smear import PRIOR_BORESIGHT_SIGMA, ROUGH_BORESIGHT_SIGMA
from lispac.targets.expected_target import deviations_from_expected
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.occlusion import ObservedExtent, compare_observed_extents, does_plane_end_within
from lispac.targets.sighting_quality import (
    SightingQuality,
    add_messages,
    plane_quality,
    sphere_quality,
    undetermined_quality,
)
from lispac.targets.similar_surfaces import nearest_similar_surface
from lispac.workflow.calibration.reselection import reselect_target
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

SightingKey = tuple[str, str]
"""Names of target and line."""

DERIVATIVE_STEP = 1e-5
"""Change of an angle, radians, for the numerical derivatives of point positions."""
MAX_SEARCHED_POINTS = 50_000
"""Largest number of points around a sighting in which similar surfaces are searched for."""


@dataclass(frozen=True, eq=False)
class AssessedQuality:
    """Quality of a sighting, with the data it was assessed from.

    Attributes
    ----------
    indices : ndarray of shape (n,), int
        Picked points of the sighting.
    compared_sightings : tuple of (ndarray of int, bool)
        Picked points of each sighting of the target, and whether the sighting is used.
    dependencies : tuple of object
        All other values that the quality depends on.
    """

    quality: SightingQuality
    indices: NDArray[np.int64]
    compared_sightings: tuple[tuple[NDArray[np.int64], bool], ...]
    dependencies: tuple[object, ...]

    def is_current(self, project: Project, target: Target, sighting: PickedSighting) -> bool:
        """True if the quality was assessed from the present state of the sighting."""
        now = _compared_sightings(target)
        return (
            self.indices is sighting.indices
            and len(self.compared_sightings) == len(now)
            and all(
                a[0] is b[0] and a[1] == b[1]
                for a, b in zip(self.compared_sightings, now, strict=True)
            )
            and self.dependencies == _quality_dependencies(project, target)
        )


def assess_sightings(
    project: Project,
    survey: Survey,
    *,
    known: Mapping[SightingKey, AssessedQuality] | None = None,
    progress: Progress = no_progress,
) -> dict[SightingKey, AssessedQuality]:
    """Assess every sighting of a project; valid ``known`` results are kept.

    Before the calibration, the picked points are assessed, and deviations that an error of the
    approximate boresight can explain are ignored. After it, the points of targets are selected
    again in the calibrated lines with the threshold of the pick, because the adjustment does not
    use the picked points either. For validation planes, the picked points are always assessed.
    """
    known = known or {}
    judged: dict[SightingKey, AssessedQuality] = {}
    placings = {
        role: _SurveyPlacement.of(project, survey, estimated=_is_selected_again(project, role))
        for role in {target.role for target in project.targets}
    }
    placed = survey.placed(project, "estimated") if project.result is not None else None
    for k, target in enumerate(project.targets):
        step = sub_progress(progress, k / len(project.targets), (k + 1) / len(project.targets))
        step(0.0, gettext_lazy("Assessing the sightings of {target}", target=target.name))
        kept = {
            key: known[key]
            for key in ((target.name, sighting.line) for sighting in target.sightings)
            if key in known
        }
        if all(
            (target.name, s.line) in kept
            and kept[target.name, s.line].is_current(project, target, s)
            for s in target.sightings
        ):
            judged |= kept
            continue
        now = target
        if placed is not None and _is_selected_again(project, target.role):
            sightings = tuple(replace(s, used=True) for s in target.sightings)
            every = replace(target, sightings=sightings, used=True)
            now = reselect_target(every, survey.clouds, placed, threshold_factor=1.0)
            step(0.2)
        found = _target_qualities(
            project, survey, placings[target.role], target, now.sightings, step
        )
        for picked, quality in zip(target.sightings, found, strict=True):
            judged[target.name, picked.line] = AssessedQuality(
                quality,
                picked.indices,
                _compared_sightings(target),
                _quality_dependencies(project, target),
            )
    return judged


def _is_selected_again(project: Project, role: Role) -> bool:
    return project.result is not None and role == "target"


def assess_target(project: Project, survey: Survey, target: Target) -> dict[str, SightingQuality]:
    """Quality of each sighting of a target by line, before or after a calibration."""
    judged = assess_sightings(replace(project, targets=(target,)), survey)
    return {line: each.quality for (_, line), each in judged.items()}


def sighting_qualities(
    project: Project,
    survey: Survey,
    *,
    known: Mapping[SightingKey, AssessedQuality] | None = None,
    progress: Progress = no_progress,
) -> dict[SightingKey, SightingQuality]:
    """Quality of every sighting, by the names of target and line; see `assess_sightings`."""
    judged = assess_sightings(project, survey, known=known, progress=progress)
    return {key: each.quality for key, each in judged.items()}


@dataclass(frozen=True, eq=False)
class _SurveyPlacement:
    """Placement of points and scanner positions, with the derivatives by each boresight angle.

    After the calibration, targets are placed with the estimated mounting; in all other cases the
    mounting is the one that approximately aligns the lines. Its error bends planes scanned from a
    moving vessel; the derivatives serve to ignore deviations that such an error can explain.

    Attributes
    ----------
    points, scanner : placement of points, and of the origin of the LiDAR frame
    turned : placement with each angle changed by `DERIVATIVE_STEP`; empty if not needed
    boresight_sigma : largest error of the boresight, radians
    is_nearly_aligned : whether the lines agree within the errors of a rough alignment
    """

    points: Georeferencer
    scanner: Georeferencer
    turned: tuple[Georeferencer, ...]
    boresight_sigma: float
    is_nearly_aligned: bool

    @classmethod
    def of(cls, project: Project, survey: Survey, *, estimated: bool) -> "_SurveyPlacement":
        """Placement with the estimated mounting, or with that of the approximate alignment."""
        mounting = project.mounting("estimated") if estimated else survey.alignment.mounting
        # A range offset does not affect the position of the scanner.
        scanner = replace(mounting, range_offset=0.0, scan_angle_offset=0.0)
        turned = (
            mounting.with_boresight(mounting.boresight + step)
            for step in DERIVATIVE_STEP * np.eye(3)
        )
        return cls(
            Georeferencer.of(survey.trajectory, mounting),
            Georeferencer.of(survey.trajectory, scanner),
            tuple(Georeferencer.of(survey.trajectory, each) for each in turned)
            if not estimated
            else (),
            ROUGH_BORESIGHT_SIGMA
            if estimated or survey.alignment.is_aligned
            else PRIOR_BORESIGHT_SIGMA,
            estimated or survey.alignment.is_aligned,
        )


@dataclass(frozen=True, eq=False)
class _SightingPoints:
    """Points of a sighting: in the LiDAR frame, their times, and placed in the local frame."""

    lidar: Array
    time: Array
    local: Array

    @classmethod
    def of(
        cls, survey: Survey, placing: _SurveyPlacement, sighting: PickedSighting
    ) -> "_SightingPoints":
        lidar, time = survey.scans[sighting.line].take(sighting.indices)
        return cls(lidar, time, placing.points(lidar, time))


def _target_qualities(
    project: Project,
    survey: Survey,
    placing: _SurveyPlacement,
    target: Target,
    sightings: tuple[PickedSighting, ...],
    progress: Progress,
) -> list[SightingQuality]:
    """Quality of each selected sighting; the sightings of ``target`` are those that were picked."""
    seen = [_SightingPoints.of(survey, placing, sighting) for sighting in sightings]
    shown: list[ObservedExtent | None] = [None] * len(seen)
    if target.shape == "plane" and placing.is_nearly_aligned:
        shown = _observed_parts(target, placing, seen)
    judged = []
    for k, (sighting, each, extent) in enumerate(zip(sightings, seen, shown, strict=True)):
        progress(0.3 + 0.7 * k / len(seen))
        judged.append(_sighting_quality(project, placing, target, sighting, each, extent))
    if target.shape == "plane" and not placing.is_nearly_aligned:
        judged = [
            add_messages(quality, _ambiguity_note(target, survey, sighting))
            for quality, sighting in zip(judged, sightings, strict=True)
        ]
    return judged


def _ambiguity_note(
    target: Target, survey: Survey, sighting: PickedSighting
) -> tuple[Message, ...]:
    """Note on another surface that could be confused with the target, if there is one."""
    cloud = survey.alignment.clouds[sighting.line]
    points = cloud[sighting.indices]
    try:
        plane = fit_plane(points)
    except LispacError:  # reported with the quality of the sighting
        return ()
    reach = FinderSettings().max_shift
    about = cloud.within(points.mean(axis=0), reach + target.radius, limit=MAX_SEARCHED_POINTS)
    distance = nearest_similar_surface(about.points, points, plane, target.threshold, reach)
    if distance is None:
        return ()
    return (note("quality.mistakable", distance=distance),)


def _observed_parts(
    target: Target, placing: _SurveyPlacement, seen: list[_SightingPoints]
) -> list[ObservedExtent | None]:
    """Part of a plane observed in each line.

    None for all lines if the search radius cuts the plane in one of them.
    """
    planes: dict[int, Array] = {}
    extents = []
    for k, each in enumerate(seen):
        try:
            extents.append(extent_in_plane(fit_plane(each.local), each.local))
        except LispacError:  # reported with that sighting
            continue
        planes[k] = each.local
    shown: list[ObservedExtent | None] = [None] * len(seen)
    if len(planes) < 2 or not does_plane_end_within(target.radius, extents):
        return shown
    ranges = [float(np.median(np.linalg.norm(seen[k].lidar, axis=1))) for k in planes]
    found = compare_observed_extents(
        list(planes.values()),
        [target.sightings[k].used for k in planes],
        placing.boresight_sigma * max(ranges),
    )
    for k, each_shown in zip(planes, found, strict=True):
        shown[k] = each_shown
    return shown


def _sighting_quality(
    project: Project,
    placing: _SurveyPlacement,
    target: Target,
    sighting: PickedSighting,
    seen: _SightingPoints,
    shown: ObservedExtent | None,
) -> SightingQuality:
    every = np.arange(len(seen.local))
    try:
        if target.shape == "sphere":
            sphere = fit_sphere(seen.local, target.sphere_radius)
            noise = _normal_sigma(project, placing, seen, sphere.directions(seen.local))
            return sphere_quality(seen.lidar, seen.local, every, sphere, noise)
        plane = fit_plane(seen.local)
        noise = _normal_sigma(project, placing, seen, np.tile(plane.normal, (len(every), 1)))
    except LispacError as error:
        return undetermined_quality(len(every), sighting.rms, as_message(error.reason))
    turns = None
    if placing.turned:
        turned = [each(seen.lidar, seen.time) for each in placing.turned]
        turns = np.stack([(points - seen.local) / DERIVATIVE_STEP for points in turned])
    quality = plane_quality(
        seen.lidar, seen.local, every, plane, noise,
        scanner_local=placing.scanner(np.zeros_like(seen.lidar), seen.time), turns_local=turns,
        boresight_sigma=placing.boresight_sigma,
        threshold=None if sighting.by_hand else target.threshold, observed_extent=shown,
    )  # fmt: skip
    if target.expected is None or quality.extent is None:
        return quality
    return add_messages(
        quality, deviations_from_expected(target.expected, quality.extent, plane.normal)
    )


def _normal_sigma(
    project: Project, placing: _SurveyPlacement, seen: _SightingPoints, normals_local: Array
) -> float:
    """Sigma of the points of a sighting along the normals of their surface, metres.

    Parameters
    ----------
    normals_local : ndarray of shape (n, 3), unit vectors
    """
    mounting = placing.points.mounting
    poses = placing.points.trajectory.at(seen.time + mounting.latency)
    normals_lidar = directions_to_lidar(normals_local, poses, mounting)
    return project.settings.lidar_noise.normal_sigma(seen.lidar, normals_lidar)


def unexpected_deviations(target: Target, survey: Survey) -> dict[str, tuple[Message, ...]]:
    """Messages on deviations of each sighting from the expected target, by line."""
    messages: dict[str, tuple[Message, ...]] = {}
    for sighting in target.sightings if target.expected is not None else ():
        assert target.expected is not None
        points = survey.clouds[sighting.line][sighting.indices]
        plane = fit_plane(points)
        found = deviations_from_expected(
            target.expected, extent_in_plane(plane, points), plane.normal
        )
        if found:
            messages[sighting.line] = found
    return messages


def _compared_sightings(target: Target) -> tuple[tuple[NDArray[np.int64], bool], ...]:
    """Point indices and flag of use of all sightings of a target, which a quality depends on."""
    return tuple((sighting.indices, sighting.used) for sighting in target.sightings)


def _quality_dependencies(project: Project, target: Target) -> tuple[object, ...]:
    """Values that a quality depends on in addition to the points."""
    estimated = _is_selected_again(project, target.role)
    mounting = project.mounting("estimated" if estimated else "prior")
    return (
        target.shape, target.sphere_radius, target.radius, target.expected,
        target.threshold, project.settings.lidar_noise, estimated, *mounting.values.tolist(),
    )  # fmt: skip
