"""Assignment of surveyed control to the targets of a project.

A point of a list is assigned to the target that its column ``plane`` or its own name states, else
to the target on whose surface it lies. Of a static scan, the surface of each target is found and
fitted; three points with the same covariance represent a plane, the centre represents a sphere.
The assignment follows the targets: control is assigned to targets that are added later.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.control import plane_points
from lispac.control_points import ControlFile, ControlPoint
from lispac.errors import InputError, PlaneNotFound, SphereNotFound
from lispac.geometry.planes import fit_plane, plane_axes
from lispac.geometry.spheres import fit_sphere
from lispac.language import gettext_lazy
from lispac.messages import Message, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Target, Triple
from lispac.survey.georeferencing import place_points
from lispac.targets.plane_finder import find_plane
from lispac.targets.sphere_finder import RadiusRange, find_sphere
from lispac.targets.thinning import thin_points
from lispac.workflow.control.references import open_reference, read_surface
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

MAX_SURFACE_DISTANCE = 0.3
"""Largest distance of a point from the surface of a target to which it is assigned by its place,
metres; at a range of 15 m, this corresponds to a boresight error of 1.1 deg."""
MAX_NAMED_DISTANCE = 5.0
"""Largest distance of a point from the surface of the target that it names, metres."""
EXTENT_MARGIN = 0.1
"""Largest distance of a point from the observed part of a plane, along the plane, metres."""
MIN_DISTANCE_RATIO = 2.0
"""Ratio of the distances from the second nearest and the nearest target above which the nearest
one is chosen."""
SIGMA_SPACING = 0.1
"""Spacing within which the points of a static scan have the same error, metres, as for lines."""
MIN_SCAN_POINTS = 30
"""Smallest number of points of a static scan on a target."""
SCAN_DISTANCE = 2 * MAX_SURFACE_DISTANCE
"""Largest distance from the lines at which points of a static scan are read, metres."""
MIN_SCAN_SIGMA = 1e-5
"""Smallest standard deviation of control from a static scan, metres."""


@dataclass(frozen=True, eq=False)
class TargetSurface:
    """Surface of a target as the lines show it.

    Attributes
    ----------
    target : Target
    points : ndarray of shape (n, 3), metres, local frame
    centre : ndarray of shape (3,), metres, local frame
        Mean of the points, or centre of the sphere.
    normal : ndarray of shape (3,), unit vector, local frame
        Normal of a plane; not used for a sphere.
    radius : float, metres
        Radius of a sphere; 0 for a plane.
    """

    target: Target
    points: Array
    centre: Array
    normal: Array
    radius: float

    @property
    def is_sphere(self) -> bool:
        """Whether the surface is a sphere."""
        return self.target.shape == "sphere"

    def distance(self, point: Array) -> float:
        """Distance of a point from the surface, metres; infinite beside a plane.

        Parameters
        ----------
        point : ndarray of shape (3,), metres, local frame
        """
        away = point - self.centre
        if self.is_sphere:
            from_centre = float(np.linalg.norm(away))
            return min(from_centre, abs(from_centre - self.radius))
        axes = plane_axes(self.normal)
        placed = (self.points - self.centre) @ axes.T
        along = axes @ away
        margin = EXTENT_MARGIN + float(np.sqrt(np.ptp(placed, axis=0).prod() / len(placed)))
        beside = np.hypot(*(placed - along).T).min() > margin
        return float("inf") if beside else abs(float(self.normal @ away))

    def plane_distance(self, point: Array) -> float:
        """Distance of a point from the surface without limits along a plane, metres.

        Parameters
        ----------
        point : ndarray of shape (3,), metres, local frame
        """
        away = point - self.centre
        return self.distance(point) if self.is_sphere else abs(float(self.normal @ away))


def target_surfaces(project: Project, survey: Survey) -> tuple[TargetSurface, ...]:
    """Surfaces of the targets, with the estimated boresight, or the prior one before an estimate.

    Targets to whose points no plane or sphere can be fitted have none.
    """
    mounting = project.mounting("prior" if project.result is None else "estimated")
    found = []
    for target in project.targets_of_role("target"):
        parts = []
        for each in target.sightings:
            if each.used:
                points, time = survey.scans[each.line].take(each.indices)
                poses = survey.trajectory.at(time + mounting.latency)
                parts.append(place_points(points, poses, mounting))
        if not sum(map(len, parts)):
            continue
        try:
            found.append(_surface_of(target, np.concatenate(parts)))
        except (PlaneNotFound, SphereNotFound):
            continue  # the adjustment refuses it with the reason
    return tuple(found)


def _surface_of(target: Target, points: Array) -> TargetSurface:
    if target.shape == "sphere":
        sphere = fit_sphere(points, target.sphere_radius)
        return TargetSurface(target, points, sphere.centre, np.zeros(3), sphere.radius)
    plane, centre = fit_plane(points), points.mean(axis=0)
    return TargetSurface(target, points, centre, plane.normal, 0.0)


def is_assignment_current(project: Project) -> bool:
    """Whether the control of each file was assigned to the present targets."""
    names = {target.name for target in project.targets_of_role("target")}
    return all({*file.assigned_to} == names for file in project.control)


def with_assigned_control(
    project: Project,
    survey: Survey,
    *,
    near: Project | None = None,
    progress: Progress = no_progress,
) -> Project:
    """Assign the control to targets that were added since the last assignment.

    Points that are assigned keep their target. Listed points that were not assigned are tried again
    with the surfaces of ``near``. A static scan is read again if there are new targets.

    Parameters
    ----------
    near : Project, optional
        Project with the points of the targets and the boresight with which the surfaces are
        computed; by default ``project``.
    """
    is_current = is_assignment_current(project)
    if is_current and not any(_unassigned_points(file) for file in project.control):
        return project
    surfaces = target_surfaces(near or project, survey)
    names = tuple(target.name for target in project.targets_of_role("target"))
    files = []
    for k, file in enumerate(project.control):
        step = sub_progress(progress, k / len(project.control), (k + 1) / len(project.control))
        if file.kind == "points":
            points = assigned_points(file.points, surfaces)
        else:
            points = file.points
            if new := [each for each in surfaces if each.target.name not in file.assigned_to]:
                points += _scanned_again(file, project, survey, new, step)
        files.append(replace(file, points=points, assigned_to=names))
    control = tuple(files)
    return project if control == project.control else project.with_control(control)


def _unassigned_points(file: ControlFile) -> bool:
    return file.kind == "points" and not all(point.target for point in file.points)


def _scanned_again(
    file: ControlFile,
    project: Project,
    survey: Survey,
    surfaces: Sequence[TargetSurface],
    progress: Progress,
) -> tuple[ControlPoint, ...]:
    """Control of new targets from the scan of an earlier import, if it has not changed."""
    reading = file.reading
    try:
        opened = open_reference(
            file.path, project, survey, crs=reading.crs, height=reading.height,
            trajectory_datum=reading.trajectory_datum, epoch=reading.epoch,
        )  # fmt: skip
        if opened.sha256 != file.sha256:
            reason = note("control.scan_changed", file=file.path.name)
            return tuple(_not_scanned(each, reason) for each in surfaces)
        cloud, _ = read_surface(
            opened, survey, project, SCAN_DISTANCE, sub_progress(progress, 0.0, 0.5)
        )
    except (InputError, OSError):
        reason = note("control.scan_not_readable", file=file.path.name)
        return tuple(_not_scanned(each, reason) for each in surfaces)
    return scanned_points(cloud, surfaces, sub_progress(progress, 0.5, 1.0))


def assigned_points(
    points: Sequence[ControlPoint], surfaces: Sequence[TargetSurface]
) -> tuple[ControlPoint, ...]:
    """Listed points, of which those without a target are assigned if they belong to one."""
    by_name = {each.target.name.casefold(): each for each in surfaces}
    stated = [(point.stated_target or point.name).casefold() for point in points]
    found = []
    for point, word in zip(points, stated, strict=True):
        if point.target or not surfaces:
            found.append(point)
            continue
        blank, named = replace(point, reason=None), by_name.get(word)
        if named is not None:
            found.append(_named_point(blank, named, alone=stated.count(word) == 1))
        else:
            found.append(_point_by_place(blank, surfaces))
    return tuple(found)


def _named_point(point: ControlPoint, surface: TargetSurface, *, alone: bool) -> ControlPoint:
    """Point of the target that the list names; a single point of a sphere is its centre."""
    off = surface.plane_distance(np.array(point.position))
    target = surface.target.name
    if off > MAX_NAMED_DISTANCE:
        reason = note("control.far_from_target", name=point.name, target=target, distance=off)
        return replace(point, reason=reason)
    return replace(point, target=target, is_centre=surface.is_sphere and alone)


def _point_by_place(point: ControlPoint, surfaces: Sequence[TargetSurface]) -> ControlPoint:
    """Point assigned to the target on whose surface it lies; unassigned with the reason if none."""
    place = np.array(point.position)
    distances = [each.distance(place) for each in surfaces]
    order = np.argsort(distances)
    nearest = surfaces[order[0]]
    off = distances[order[0]]
    if off > MAX_SURFACE_DISTANCE:
        if not np.isfinite(off):
            reason = note("control.beside_targets", name=point.name)
        else:
            reason = note(
                "control.far_from_target",
                name=point.name, target=nearest.target.name, distance=off,
            )  # fmt: skip
        return replace(point, reason=reason)
    if len(order) > 1:
        second = distances[order[1]]
        if second <= MAX_SURFACE_DISTANCE and second < MIN_DISTANCE_RATIO * off:
            names = [surfaces[k].target.name for k in order[:2]]
            return replace(point, reason=note("control.ambiguous", name=point.name, targets=names))
    from_centre = float(np.linalg.norm(place - nearest.centre))
    is_centre = nearest.is_sphere and from_centre < nearest.radius / 2
    return replace(point, target=nearest.target.name, is_centre=is_centre)


def scanned_points(
    cloud: Array, surfaces: Sequence[TargetSurface], progress: Progress = no_progress
) -> tuple[ControlPoint, ...]:
    """Control that represents the surfaces of the targets in a static scan.

    Parameters
    ----------
    cloud : ndarray of shape (n, 3), metres, local frame
        Points of the scan near the lines.
    """
    found: list[ControlPoint] = []
    for k, surface in enumerate(surfaces):
        progress(
            k / len(surfaces),
            gettext_lazy("Finding {target} in the static scan", target=surface.target.name),
        )
        found += _scanned_target(cloud, surface)
    return tuple(found)


def _scanned_target(cloud: Array, surface: TargetSurface) -> list[ControlPoint]:
    name, target = surface.target.name, surface.target
    reach = float(np.linalg.norm(surface.points - surface.centre, axis=1).max())
    near = cloud[np.linalg.norm(cloud - surface.centre, axis=1) <= reach + MAX_SURFACE_DISTANCE]
    try:
        if len(near) < MIN_SCAN_POINTS:
            raise PlaneNotFound(note("control.few_scan_points", target=name, count=len(near)))
        settings = target.choices.settings(
            radius=reach + MAX_SURFACE_DISTANCE, threshold=target.threshold
        )
        if surface.is_sphere:
            radius = target.sphere_radius
            allowed = RadiusRange() if radius is None else RadiusRange.of_known_radius(radius)
            patch = find_sphere(near, surface.centre, allowed, settings)
            return [_sphere_control(name, near[patch.indices], radius)]
        plane = find_plane(near, surface.centre, settings, expected_normal=surface.normal)
    except (PlaneNotFound, SphereNotFound) as failure:
        return [_not_scanned(surface, failure.reason)]
    return _plane_control(name, near[plane.indices])


def _plane_control(name: str, points: Array) -> list[ControlPoint]:
    """Three points that represent the plane through the points of a scan."""
    plane, centre = fit_plane(points), points.mean(axis=0)
    axes = plane_axes(plane.normal)
    moments, turn = np.linalg.eigh(np.cov(((points - centre) @ axes.T).T, bias=True))
    noise = float(np.sqrt(np.mean(plane.distances(points) ** 2)))
    count = max(len(thin_points(points, SIGMA_SPACING)), 3)
    sigma = max(noise * np.sqrt(3 / count), MIN_SCAN_SIGMA)
    return [
        ControlPoint(f"{name}-{k}", name, _triple(place), (sigma,) * 3)
        for k, place in enumerate(plane_points(centre, turn.T @ axes, moments), start=1)
    ]


def _sphere_control(name: str, points: Array, radius: float | None) -> ControlPoint:
    """Centre of the sphere through the points of a scan, with the covariance of its fit."""
    sphere = fit_sphere(points, radius)
    away = points - sphere.centre
    distance = np.linalg.norm(away, axis=1)
    design = away / distance[:, None]
    if radius is None:
        design = np.column_stack([design, np.ones(len(points))])
    noise = float(np.sqrt(np.mean((distance - sphere.radius) ** 2)))
    count = max(len(thin_points(points, min(SIGMA_SPACING, sphere.radius / 2))), 5)
    cofactors = np.linalg.inv(design.T @ design * (count / len(points)))[:3, :3]
    sigmas = np.maximum(noise * np.sqrt(np.diag(cofactors)), MIN_SCAN_SIGMA)
    scale = np.sqrt(np.diag(cofactors))
    correlations = cofactors / np.outer(scale, scale)
    return ControlPoint(
        f"{name}-centre", name, _triple(sphere.centre), _triple(sigmas), is_centre=True,
        correlations=_triple(correlations[[0, 0, 1], [1, 2, 2]]),
    )  # fmt: skip


def _not_scanned(surface: TargetSurface, failure: Message | str) -> ControlPoint:
    """Entry of a target without control from a scan, with the reason."""
    name = surface.target.name
    return ControlPoint(
        name, "", _triple(surface.centre), (MIN_SCAN_SIGMA,) * 3, stated_target=name,
        reason=note("control.not_in_scan", target=name, reason=failure),
    )  # fmt: skip


def _triple(values: Array) -> Triple:
    first, second, third = map(float, values)
    return first, second, third
