"""Import of surveyed control: reading, and assignment of its points to the targets of a project.

A point of a list is assigned to the target that its column ``plane`` or its own name states, else
to the target on whose surface it lies. Of a static scan, the surface of each target is found and
fitted; three points with the same covariance represent a plane, the centre represents a sphere.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.control import plane_points
from lispac.control_points import ControlFile, ControlPoint, with_control_file
from lispac.errors import InputError, PlaneNotFound, ProjectError, SphereNotFound
from lispac.geometry.planes import fit_plane, plane_axes
from lispac.geometry.spheres import fit_sphere
from lispac.io.text.seed_file import ListedPoint
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Target, Triple
from lispac.survey.crs import CoordinateSystem
from lispac.targets.plane_finder import find_plane
from lispac.targets.sphere_finder import RadiusRange, find_sphere
from lispac.targets.thinning import thin_points
from lispac.workflow.checking.references import (
    open_reference,
    read_listed_points,
    read_surface,
    sigma_warnings,
)
from lispac.workflow.project.coordinates import is_local
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

DEFAULT_SIGMA = 0.005
"""Default standard deviation of control, metres."""
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


def import_control(
    project: Project,
    survey: Survey,
    path: Path,
    *,
    sigma: float = DEFAULT_SIGMA,
    common_sigma: float | None = None,
    crs: str = "",
    height: str = "",
    trajectory_datum: str | None = None,
    epoch: float | None = None,
    progress: Progress = no_progress,
) -> tuple[Project, tuple[Message, ...]]:
    """Import control from a list of points or a static scan; a file of the same name is replaced.

    Parameters
    ----------
    path : Path
        List of points: name, x, y, z, and optionally standard deviations and the name of the target
        in a column ``plane``; or a static scan (LAS, LAZ, E57, PTS, text).
    sigma : float, metres
        Standard deviation of each coordinate of points without one in the list. Of a scan, the
        standard deviation common to all its points, if ``common_sigma`` is not given.
    common_sigma : float or None, metres
        Standard deviation, on each axis, of an error that all points of the file share, such as
        that of the registration or of the fixed points.
    crs, height, trajectory_datum, epoch
        As in `lispac.workflow.checking.references.read_reference`.

    Returns
    -------
    project : Project
        Project with the control.
    notes : tuple of Message
        Notes on the reading, and warnings about the control.

    Raises
    ------
    ProjectError
        If the project has no targets.
    InputError
        If the file cannot be read or is not at the site of the survey, or a standard deviation is
        not valid.
    """
    _require_sigma(sigma)
    surfaces = target_surfaces(project, survey)
    opened = open_reference(
        path, project, survey, crs=crs, height=height, trajectory_datum=trajectory_datum,
        epoch=epoch,
    )  # fmt: skip
    notes: tuple[Message, ...] = opened.notes
    if opened.is_list:
        listed, columns = read_listed_points(opened, survey.trajectory)
        points = _assigned_points(listed, surfaces, sigma, opened.system)
        notes += (columns, *sigma_warnings([point for point, _ in listed]))
        common = common_sigma or 0.0
    else:
        cloud, used = read_surface(
            opened, survey, project, 2 * MAX_SURFACE_DISTANCE, sub_progress(progress, 0.0, 0.5)
        )
        points = _scanned_points(cloud, surfaces, sub_progress(progress, 0.5, 1.0))
        notes += (used,)
        common = sigma if common_sigma is None else common_sigma
    file = ControlFile(
        opened.path, opened.size_bytes, opened.sha256, "points" if opened.is_list else "scan",
        opened.system_name, survey.trajectory.frame.origin_deg_m, float(common), points,
    )  # fmt: skip
    file.require_sound()
    notes += tuple(point.reason for point in points if point.reason is not None)
    progress(1.0)
    former = {
        point.name: point.used
        for each in project.control
        if each.path.name == file.path.name
        for point in each.points
    }
    points = tuple(replace(each, used=former.get(each.name, True)) for each in file.points)
    file = replace(file, points=points)
    return project.with_control(with_control_file(project.control, file)), notes


def target_surfaces(project: Project, survey: Survey) -> tuple[TargetSurface, ...]:
    """Surfaces of the targets, with the estimated boresight, or the prior one before an estimate.

    Raises
    ------
    ProjectError
        If the project has no target with points.
    """
    clouds = survey.placed(project, "prior" if project.result is None else "estimated")
    found = []
    for target in project.targets_of_role("target"):
        parts = [clouds[each.line][each.indices] for each in target.sightings if each.used]
        if not sum(map(len, parts)):
            continue
        points = np.concatenate(parts)
        try:
            found.append(_surface_of(target, points))
        except (PlaneNotFound, SphereNotFound):
            continue  # the adjustment refuses it with the reason
    if not found:
        raise ProjectError(error("control.no_targets", project=project.name))
    return tuple(found)


def _surface_of(target: Target, points: Array) -> TargetSurface:
    if target.shape == "sphere":
        sphere = fit_sphere(points, target.sphere_radius)
        return TargetSurface(target, points, sphere.centre, np.zeros(3), sphere.radius)
    plane, centre = fit_plane(points), points.mean(axis=0)
    return TargetSurface(target, points, centre, plane.normal, 0.0)


def _assigned_points(
    listed: Sequence[tuple[ListedPoint, Array]],
    surfaces: Sequence[TargetSurface],
    sigma: float,
    system: CoordinateSystem | None,
) -> tuple[ControlPoint, ...]:
    """Points of a list with their targets."""
    by_name = {each.target.name.casefold(): each for each in surfaces}
    stated = [point.plane or point.name for point, _ in listed]
    found = []
    for number, ((point, place), word) in enumerate(zip(listed, stated, strict=True), start=1):
        named = by_name.get(word.casefold())
        alone = stated.count(word) == 1
        name = point.name or f"P{number}"
        sigmas = _local_sigmas(point, sigma, system)
        position: Triple = (float(place[0]), float(place[1]), float(place[2]))
        blank = ControlPoint(name, "", position, sigmas)
        if named is not None:
            found.append(_named_point(blank, place, named, alone=alone))
        else:
            found.append(_point_by_place(blank, place, surfaces))
    return tuple(found)


def _named_point(
    point: ControlPoint, place: Array, surface: TargetSurface, *, alone: bool
) -> ControlPoint:
    """Point of the target that the list names; a single point of a sphere is its centre."""
    off = surface.plane_distance(place)
    target = surface.target.name
    if off > MAX_NAMED_DISTANCE:
        reason = note("control.far_from_target", name=point.name, target=target, distance=off)
        return replace(point, reason=reason)
    return replace(point, target=target, is_centre=surface.is_sphere and alone)


def _point_by_place(
    point: ControlPoint, place: Array, surfaces: Sequence[TargetSurface]
) -> ControlPoint:
    """Point assigned to the target on whose surface it lies; unassigned with the reason if none."""
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


def _local_sigmas(point: ListedPoint, sigma: float, system: CoordinateSystem | None) -> Triple:
    """Standard deviations north, west and up of a listed point, metres."""
    if point.axis_sigmas is None:
        own = sigma if point.sigma is None else point.sigma
        return own, own, own
    first, second, third = point.axis_sigmas
    if is_local(system):  # north, west, up
        return first, second, third
    assert system is not None
    if system.crs.is_geocentric:  # no axis is that of the local frame
        assert point.sigma is not None
        return point.sigma, point.sigma, point.sigma
    return second, first, third  # east, north, up


def _scanned_points(
    cloud: Array, surfaces: Sequence[TargetSurface], progress: Progress
) -> tuple[ControlPoint, ...]:
    """Control that represents the surfaces of the targets in a static scan."""
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
        centre = surface.centre
        position: Triple = (float(centre[0]), float(centre[1]), float(centre[2]))
        reason = note("control.not_in_scan", target=name, reason=failure.reason)
        sigmas = (DEFAULT_SIGMA,) * 3
        return [ControlPoint(name, "", position, sigmas, reason=reason)]
    return _plane_control(name, near[plane.indices])


def _plane_control(name: str, points: Array) -> list[ControlPoint]:
    """Three points that represent the plane through the points of a scan."""
    plane, centre = fit_plane(points), points.mean(axis=0)
    axes = plane_axes(plane.normal)
    moments, turn = np.linalg.eigh(np.cov(((points - centre) @ axes.T).T, bias=True))
    noise = float(np.sqrt(np.mean(plane.distances(points) ** 2)))
    count = max(len(thin_points(points, SIGMA_SPACING)), 3)
    sigma = max(noise * np.sqrt(3 / count), 1e-5)
    return [
        ControlPoint(
            f"{name}-{k}", name, (float(place[0]), float(place[1]), float(place[2])), (sigma,) * 3
        )
        for k, place in enumerate(plane_points(centre, turn.T @ axes, moments), start=1)
    ]


def _sphere_control(name: str, points: Array, radius: float | None) -> ControlPoint:
    """Centre of the sphere through the points of a scan, with the standard deviations of its fit.

    The covariances between the axes are not kept; the largest eigenvalue is used for all axes.
    """
    sphere = fit_sphere(points, radius)
    away = points - sphere.centre
    distance = np.linalg.norm(away, axis=1)
    design = away / distance[:, None]
    if radius is None:
        design = np.column_stack([design, np.ones(len(points))])
    noise = float(np.sqrt(np.mean((distance - sphere.radius) ** 2)))
    count = max(len(thin_points(points, min(SIGMA_SPACING, sphere.radius / 2))), 5)
    cofactors = np.linalg.inv(design.T @ design * (count / len(points)))[:3, :3]
    sigma = max(noise * float(np.sqrt(np.linalg.eigvalsh(cofactors)[-1])), 1e-5)
    x, y, z = map(float, sphere.centre)
    return ControlPoint(f"{name}-centre", name, (x, y, z), (sigma,) * 3, is_centre=True)


def _require_sigma(sigma: float) -> None:
    """Refuse a standard deviation that is not positive.

    Raises
    ------
    InputError
        If it is not.
    """
    if not 0.0 < sigma < np.inf:
        raise InputError(error("control.sigma", sigma=sigma))
