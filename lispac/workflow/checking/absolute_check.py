"""Check of the lines against a reference: a static scan, or surveyed points and planes."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.point_sensitivity import sensitivity
from lispac.errors import InputError, NotComparable, ProjectError
from lispac.geometry.point_tree import PointTree
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES
from lispac.targets.thinning import thin_points
from lispac.validation.absolute_check import (
    AbsoluteCheck,
    LinePlaces,
    PointCheck,
    check_lines,
    check_points,
    find_other_surfaces,
    shared_histogram,
)
from lispac.validation.cylinder_diameters import (
    DIAMETER_FACTOR,
    MAX_DIAMETER_M,
    MIN_DIAMETER_M,
    candidate_places,
    cylinder_diameters,
    select_separate_places,
    twelfth_neighbour_distance,
)
from lispac.validation.normal_distance import NormalDistances
from lispac.validation.reference_places import (
    NORMAL_SPHERE_FACTOR,
    CorePointDistances,
    is_reference_flat,
    measure_to_points,
    measure_to_surface,
)
from lispac.workflow.control.references import Reference, read_reference
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

DEFAULT_SIGMA = 0.005
"""Default sigma of a reference, metres."""
SEARCH_DISTANCE = 1.0
"""Largest distance of line points from the reference, metres; at a range of 50 m, this corresponds
to a boresight error of 1.1 deg."""
POINTS_PER_DIAMETER, CYLINDERS_PER_WIDTH = 4, 5
"""Sampling of a surveyed plane: points along the diameter of a cylinder, and cylinders along the
shorter side of the plane."""
MIN_PLACES = {"scan": 30, "points": 1}
"""Smallest number of places of a line for a result."""


def check_absolute(
    project: Project,
    survey: Survey,
    path: Path,
    *,
    crs: str = "",
    height: str = "",
    trajectory_datum: str | None = None,
    epoch: float | None = None,
    sigma: float = DEFAULT_SIGMA,
    search_distance: float = SEARCH_DISTANCE,
    progress: Progress = no_progress,
) -> tuple[Project, tuple[Message, ...]]:
    """Measure every line against a reference, with the prior and the estimated boresight.

    Parameters
    ----------
    path : Path
        A static scan (LAS, LAZ, E57, PTS, text), or a list of check points: name, x, y, z, and
        optionally sigma and the name of the plane that a point shares with others.
    crs : str
        Coordinate system of the reference, or ``local``; if empty, the one specified in the file,
        else the local frame. Height, datum and epoch as for `lispac.survey.crs.coordinate_system`.
    sigma : float, metres
        Standard deviation of the reference. For a scan, the part common to all points (registration
        and control); for a list, that of points without a sigma.
    search_distance : float, metres
        Largest distance of line points from the reference.

    Returns
    -------
    project : Project
        Project with the check.
    notes : tuple of Message
        Notes on the reading of the reference, and warnings about it.

    Raises
    ------
    ProjectError
        If nothing has been estimated.
    InputError
        If the reference cannot be read or is not at the site of the survey.
    NotComparable
        If no line has points on the reference.
    """
    _require_possible(project, sigma, search_distance)
    reference = read_reference(
        path, project, survey, sigma=sigma, search_distance=search_distance, crs=crs, height=height,
        trajectory_datum=trajectory_datum, epoch=epoch, progress=sub_progress(progress, 0.0, 0.3),
    )  # fmt: skip
    clouds = _lines_near_reference(project, survey, reference, search_distance)
    where = _ComparisonPlaces.of(
        reference, survey, survey.lidar_sigma(project.settings), search_distance
    )
    lines, not_compared = _compare_lines(
        project, survey, clouds, where, path.name, sub_progress(progress, 0.3, 1.0)
    )
    if not lines:
        raise NotComparable(
            error(
                "check.no_flat_place",
                file=str(path),
                count=MIN_PLACES[reference.kind],
                distance=search_distance,
            )
        )
    times = project.settings.position_time, project.settings.attitude_time
    each, together = check_lines(lines, where.sigmas, times)
    points: tuple[PointCheck, ...] = ()
    if reference.kind == "points":
        points = check_points(lines, where.names, where.sigmas, times)
        if missed := sorted(set(where.names) - {p.name for p in points}):
            not_compared.append(
                note("check.points_not_compared", distance=search_distance, points=missed)
            )
    edges, before, after = shared_histogram(lines)
    check = AbsoluteCheck(
        path.name, reference.size_bytes, reference.sha256, reference.kind, reference.system,
        reference.sigma, search_distance, each, together, tuple(not_compared), edges, before, after,
        points, find_other_surfaces(lines),
    )  # fmt: skip
    progress(1.0)
    return project.with_absolute(check), reference.notes


def _require_possible(project: Project, sigma: float, search_distance: float) -> None:
    if project.result is None:
        raise ProjectError(error("estimate.needed", project=project.name))
    if not 0.0 <= sigma < np.inf:
        raise InputError(error("check.reference_sigma", sigma=sigma))
    if not 0.0 < search_distance <= 10.0:
        raise InputError(error("check.search_distance", distance=search_distance))


@dataclass(frozen=True, eq=False)
class _LineNearReference:
    """Points of a line that may lie on the reference, placed with both boresights."""

    line: str
    numbers: NDArray[np.int64]
    before: Array
    after: Array


def _lines_near_reference(
    project: Project, survey: Survey, reference: Reference, search_distance: float
) -> list[_LineNearReference]:
    everything = [reference.surface, reference.places, *(p.points for p in reference.planes)]
    points = np.concatenate(everything)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    radius = float(np.linalg.norm(points - centre, axis=1).max()) + 2 * search_distance
    placed = survey.placed(project, "estimated")
    clouds = []
    for line, cloud in survey.clouds.items():
        region = cloud.within(centre, radius)
        clouds.append(
            _LineNearReference(line, region.numbers, region.points, placed[line][region.numbers])
        )
    return clouds


@dataclass(frozen=True, eq=False)
class _ComparisonPlaces:
    """Surfaces and places of a reference at which the lines are compared.

    Attributes
    ----------
    reference : Reference
    candidates : ndarray of shape (k, 3), metres, local frame
        Possible places on a scan; empty for surveyed points.
    diameters : ndarray of shape (k,), metres
        Diameters of the cylinders that the density of the scan requires at these places.
    names : tuple of str
        Names of the surveyed points, then of the planes; empty for a scan.
    sigmas : ndarray of shape (m,), metres
        Standard deviation of the scan, or those of the surveyed points, then of the planes.
    vessel : ndarray of shape (3,), metres, local frame
        Mean position of the vessel.
    search_distance : float, metres
        Largest distance of line points from the reference.
    roughest : float, metres
        Largest roughness of the reference at a place.
    """

    reference: Reference
    candidates: Array
    diameters: Array
    names: tuple[str, ...]
    sigmas: Array
    vessel: Array
    search_distance: float
    roughest: float

    @classmethod
    def of(
        cls, reference: Reference, survey: Survey, lidar_sigma: float, search_distance: float
    ) -> "_ComparisonPlaces":
        planes, surface = reference.planes, reference.surface
        places = candidate_places(surface) if len(surface) else surface
        own = (
            twelfth_neighbour_distance(PointTree(surface), places) if len(surface) else np.zeros(0)
        )
        return cls(
            reference, places, np.minimum(DIAMETER_FACTOR * own, MAX_DIAMETER_M),
            (*reference.names, *(plane.name for plane in planes)),
            np.array([reference.sigma]) if reference.kind == "scan"
            else np.array([*reference.sigmas, *(plane.sigma for plane in planes)]),
            survey.trajectory.position.mean(axis=0), search_distance,
            3 * max(reference.sigma, lidar_sigma),
        )  # fmt: skip

    def surfaces(self, tree: PointTree) -> Iterator[tuple[Array, Array, Array, int]]:
        """Surfaces near which a line has points.

        Yields for each surface its points, the places on it, the diameters there (from the density
        of line and reference), and its index in ``sigmas``.
        """
        diameters = cylinder_diameters(tree, self.candidates, self.search_distance)
        near = np.flatnonzero(np.isfinite(diameters))
        if len(near):
            both = np.maximum(diameters, self.diameters)[near]
            chosen, wide = select_separate_places(self.candidates[near], both)
            surface, cores = self.reference.surface, self.candidates[near][chosen]
            flat = is_reference_flat(surface, cores, NORMAL_SPHERE_FACTOR * wide, self.roughest)
            yield surface, cores[flat], wide[flat], 0
        for k, plane in enumerate(self.reference.planes):
            # A plane is flat at any width, so the diameter may be increased for a sparse line.
            side = float(np.clip(plane.width / CYLINDERS_PER_WIDTH, MIN_DIAMETER_M, MAX_DIAMETER_M))
            diameters = cylinder_diameters(tree, plane.grid(side), self.search_distance)
            if np.isfinite(diameters).any():
                side = max(side, float(np.nanmedian(diameters)))
                grid = plane.grid(side / POINTS_PER_DIAMETER)
                cores = grid[thin_points(grid, side)]
                yield grid, cores, np.full(len(cores), side), len(self.reference.names) + k


def _compare_lines(
    project: Project,
    survey: Survey,
    clouds: Sequence[_LineNearReference],
    where: _ComparisonPlaces,
    file_name: str,
    progress: Progress,
) -> tuple[list[LinePlaces], list[Message]]:
    """Compare all lines, and return notes on those that cannot be compared."""
    lines, not_compared = [], list[Message]()
    for k, cloud in enumerate(clouds):
        progress(
            k / len(clouds),
            gettext_lazy("Comparing {line} with {file}", line=cloud.line, file=file_name),
        )
        try:
            lines.append(_compare_line(project, survey, cloud, where))
        except NotComparable as failure:
            not_compared.append(
                note("check.line_not_compared", line=cloud.line, reason=failure.reason)
            )
    return lines, not_compared


def _compare_line(
    project: Project, survey: Survey, cloud: _LineNearReference, where: _ComparisonPlaces
) -> LinePlaces:
    """Compare a line with the whole reference.

    Raises
    ------
    NotComparable
        If there are too few places; the message suggests an action.
    """
    found: list[tuple[CorePointDistances, NDArray[np.intp]]] = []
    tree, tried = PointTree(cloud.after), 0
    for surface, cores, diameters, group in where.surfaces(tree):
        tried += len(cores)
        try:
            measured = measure_to_surface(
                cloud.before, cloud.after, surface, cores, facing=where.vessel - cores,
                diameters=diameters, reach=where.search_distance, roughest=where.roughest,
            )  # fmt: skip
        except NotComparable:
            continue
        found.append((measured, np.full(len(measured.after.distance), group)))
    places = where.reference.places
    wide = cylinder_diameters(tree, places, where.search_distance)
    if (near := np.flatnonzero(np.isfinite(wide))).size:
        tried += len(near)
        try:
            alone = measure_to_points(
                cloud.before, cloud.after, places[near], facing=where.vessel - places[near],
                diameters=wide[near], reach=where.search_distance, roughest=where.roughest,
            )  # fmt: skip
            found.append((alone, near[alone.after.at]))
        except NotComparable:
            pass
    count = sum(len(group) for _, group in found)
    if count < MIN_PLACES[where.reference.kind]:
        raise NotComparable(_too_few_message(where, count, tried))
    measured = CorePointDistances(
        _concatenate_distances([each.before for each, _ in found]),
        _concatenate_distances([each.after for each, _ in found]),
        np.concatenate([each.to_other_surface for each, _ in found]),
    )
    return _place_sensitivities(
        project, survey, cloud, measured, np.concatenate([g for _, g in found])
    )


def _too_few_message(where: _ComparisonPlaces, count: int, tried: int) -> Message:
    """Message with the reason why a line cannot be compared, and a suggested action."""
    if where.reference.kind == "points":
        return error("check.no_surveyed_point_near", distance=where.search_distance)
    if not tried:
        return error("check.no_reference_near", distance=where.search_distance)
    return error(
        "check.few_places", places=count, tried=tried, distance=where.search_distance,
        least=MIN_PLACES["scan"],
    )  # fmt: skip


def _concatenate_distances(several: Sequence[NormalDistances]) -> NormalDistances:
    return NormalDistances(
        np.concatenate([each.cores for each in several]),
        np.concatenate([each.distance for each in several]),
        np.concatenate([each.half_width for each in several]),
        sum(each.no_distance for each in several),
        np.concatenate([each.normals for each in several]),
        np.concatenate([each.at for each in several]),
    )


def _place_sensitivities(
    project: Project, survey: Survey, cloud: _LineNearReference, measured: CorePointDistances,
    group: NDArray[np.intp],
) -> LinePlaces:  # fmt: skip
    """Distances at the places of a line, with the effects of POS and mounting errors on them.

    The effects are those on the point of the line nearest to each place.
    """
    result = project.result
    assert result is not None
    mounting = result.mounting
    tree = PointTree(cloud.after)
    _, found = tree.nearest(measured.after.cores)
    nearest = tree.order[found]
    points_lidar, time = survey.scans[cloud.line].take(cloud.numbers[nearest])
    moves = sensitivity(
        points_lidar, survey.trajectory.at(time + mounting.latency), mounting,
        measured.after.normals, pose_rate=survey.trajectory.rate_at(time + mounting.latency),
    )  # fmt: skip
    sigma_position, sigma_attitude = survey.accuracy.at(time)
    _, position, attitude = result.sigma_factors
    names, covariance = result.mounting_covariance()
    values, vectors = np.linalg.eigh(covariance)
    mixtures = vectors * np.sqrt(np.maximum(values, 0.0))
    estimated = [MOUNTING_VALUE_NAMES.index(name) for name in names]
    return LinePlaces(
        cloud.line,
        float(np.median(time)),
        measured,
        group,
        position * moves.by_position * sigma_position,
        attitude * moves.by_attitude * sigma_attitude,
        moves.by_mounting[:, estimated] @ mixtures,
    )
