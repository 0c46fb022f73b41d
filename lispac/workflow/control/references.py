"""References for the check of the lines: a static scan, or surveyed points and planes."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, PlaneNotFound
from lispac.geometry.planes import Plane, extent_in_plane, fit_plane, plane_axes
from lispac.io.points.static_scan import StaticScan, has_at_most_rows, open_static_scan
from lispac.io.text.seed_file import MAX_ROWS, ListedPoint, read_point_list
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note, warning
from lispac.progress import Progress, no_progress
from lispac.project import Project
from lispac.survey.crs import CoordinateSystem, coordinate_system
from lispac.survey.store.spatial_cells import MAX_HALVINGS, is_number_in_sample
from lispac.survey.trajectory import LocalTrajectory
from lispac.validation.absolute_check import Kind
from lispac.workflow.project.coordinates import (
    columns_note,
    distances_from_trajectory,
    is_local,
    require_near_trajectory,
    to_local_frame,
)
from lispac.workflow.project.output_crs import LOCAL_FRAME, output_system_of, trajectory_datum_of
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]

MAX_SCAN_POINTS = 2_000_000
"""Largest number of points of a static scan in the area of the lines; more points are sampled."""
MAX_PLAUSIBLE_SIGMA = 0.2
"""Largest plausible sigma of a surveyed point, metres; a larger one is probably in millimetres."""
MIN_CELL_SIZE = 1.0
"""Smallest side of the cells that mark the area of the lines, metres."""


@dataclass(frozen=True, eq=False)
class PlaneReference:
    """A plane through surveyed points.

    Attributes
    ----------
    name : str
    points : ndarray of shape (k, 3), metres, local frame
    plane : Plane
    sigma : float, metres
        Standard deviation of the plane at the centre of its points.
    """

    name: str
    points: Array
    plane: Plane
    sigma: float

    @property
    def width(self) -> float:
        """Shorter side of the extent of its points, metres."""
        return float(extent_in_plane(self.plane, self.points).min())

    def grid(self, spacing: float) -> Array:
        """Grid on the plane within the hull of its points, shape (n, 3), metres, local frame.

        Parameters
        ----------
        spacing : float, metres
            Spacing of the grid.
        """
        from scipy.spatial import Delaunay

        axes, middle = plane_axes(self.plane.normal), self.points.mean(axis=0)
        middle = middle - self.plane.distances(middle) * self.plane.normal
        flat = (self.points - middle) @ axes.T
        low, high = flat.min(axis=0), flat.max(axis=0)
        across, up = (np.arange(low[k], high[k] + spacing / 2, spacing) for k in range(2))
        places = np.stack(np.meshgrid(across, up), axis=-1).reshape(-1, 2)
        return middle + places[Delaunay(flat).find_simplex(places) >= 0] @ axes


@dataclass(frozen=True, eq=False)
class Reference:
    """A reference in the local frame.

    Attributes
    ----------
    path : Path
    size_bytes : int, sha256 : str
    kind : {"scan", "points"}
    system : str
        Coordinate system as text.
    sigma : float, metres
        Standard deviation common to all points of a scan, or the median of those of the surveyed
        points and planes.
    notes : tuple of Message
        Notes on the reading, and warnings about the reference.
    surface : ndarray of shape (n, 3), metres, local frame
        Points of a scan in the area of the lines; empty for surveyed points.
    names : tuple of str
        Names of surveyed points that do not belong to a plane.
    places : ndarray of shape (k, 3), metres, local frame
        Positions of these points.
    sigmas : ndarray of shape (k,), metres
        Standard deviations of these points.
    planes : tuple of PlaneReference
    """

    path: Path
    size_bytes: int
    sha256: str
    kind: Kind
    system: str
    sigma: float
    notes: tuple[Message, ...]
    surface: Array
    names: tuple[str, ...]
    places: Array
    sigmas: Array
    planes: tuple[PlaneReference, ...]


def read_reference(
    path: Path,
    project: Project,
    survey: Survey,
    *,
    sigma: float,
    search_distance: float,
    crs: str = "",
    height: str = "",
    trajectory_datum: str | None = None,
    epoch: float | None = None,
    progress: Progress = no_progress,
) -> Reference:
    """Read a reference and bring it into the local frame.

    Parameters
    ----------
    sigma : float, metres
        Standard deviation of the scan, or of points without a sigma in the list.
    search_distance : float, metres
        Largest distance from the lines at which points of a scan are read.
    crs : str
        Coordinate system, or ``local``; if empty, the one in the file, else the local frame.

    Raises
    ------
    InputError
        If the file or its coordinates cannot be used.
    """
    opened = open_reference(
        path, project, survey, crs=crs, height=height, trajectory_datum=trajectory_datum,
        epoch=epoch,
    )  # fmt: skip
    path, notes = opened.path, opened.notes
    file_facts = (path, opened.size_bytes, opened.sha256)
    if opened.is_list:
        points, columns = read_listed_points(opened, survey.trajectory)
        names, places, sigmas, planes, messages = _group_points(points, sigma, path)
        messages += sigma_warnings([point for point, _ in points])
        usual = float(np.median([*sigmas, *(p.sigma for p in planes)]))
        return Reference(
            *file_facts, "points", opened.system_name, usual, (*notes, columns, *messages),
            np.zeros((0, 3)), names, places, sigmas, planes,
        )  # fmt: skip
    surface, used = read_surface(opened, survey, project, search_distance, progress)
    nothing = np.zeros((0, 3))
    return Reference(
        *file_facts,
        "scan",
        opened.system_name,
        sigma,
        (*notes, used),
        surface,
        (),
        nothing,
        np.zeros(0),
        (),
    )


@dataclass(frozen=True, eq=False)
class OpenedReference:
    """A file of a reference with its coordinate system, before its points are read.

    Attributes
    ----------
    path : Path
    size_bytes : int
    sha256 : str
    scan : StaticScan
    is_list : bool
        Whether the file is a list of surveyed points instead of a scan.
    system : CoordinateSystem or None
        None for the local frame.
    notes : tuple of Message
        Assumptions about the file, and warnings.
    """

    path: Path
    size_bytes: int
    sha256: str
    scan: StaticScan
    is_list: bool
    system: CoordinateSystem | None
    notes: tuple[Message, ...]

    @property
    def system_name(self) -> str:
        """Coordinate system as text."""
        return "the local frame" if self.system is None else self.system.name


def open_reference(
    path: Path,
    project: Project,
    survey: Survey,
    *,
    crs: str = "",
    height: str = "",
    trajectory_datum: str | None = None,
    epoch: float | None = None,
) -> OpenedReference:
    """Open a reference and determine its coordinate system; the options are as in `read_reference`.

    Raises
    ------
    InputError
        If the file or its coordinate system cannot be used.
    """
    path = Path(path)
    found = open_static_scan(path)
    listed = not found.system and _is_control_point_list(path, found)
    if not crs and found.system and not height and trajectory_datum is None:
        system = _system_of_file(found, project, epoch)
    else:
        chosen = crs or found.system or LOCAL_FRAME
        system = output_system_of(
            project, survey.trajectory, chosen, height, trajectory_datum, epoch
        )
    notes: tuple[Message, ...] = (
        note("assumed.local_frame")
        if system is None
        else note("assumed.list_system", system=system.name),
        *(() if system is None else system.assumptions),
        *(each for each in found.messages if not (crs and each.actions)),
    )
    with path.open("rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    return OpenedReference(path, path.stat().st_size, digest, found, listed, system, notes)


def _system_of_file(
    found: StaticScan, project: Project, epoch: float | None
) -> CoordinateSystem | None:
    """Coordinate system that a file specifies, with the datum with which the lines are read."""
    datum, year = trajectory_datum_of(project.lines)
    return coordinate_system(
        found.system, height_unit=found.height_unit, trajectory_datum=datum,
        epoch=year if epoch is None else epoch,
    )  # fmt: skip


def _is_control_point_list(path: Path, scan: StaticScan) -> bool:
    return not scan.is_cloud and has_at_most_rows(path, MAX_ROWS)


def read_listed_points(
    opened: OpenedReference, trajectory: LocalTrajectory
) -> tuple[list[tuple[ListedPoint, Array]], Message]:
    """Read surveyed points with their positions in the local frame, and a note on the columns.

    Raises
    ------
    InputError
        If the list is not valid, or a point is too far from the trajectory.
    """
    path, system = opened.path, opened.system
    geographic = system is not None and system.is_geographic
    metres = (1.0, 1.0, 1.0) if system is None else system.metres
    found = read_point_list(
        path, local=is_local(system), degrees=geographic, check=True, metres=metres
    )
    placed = []
    for number, point in enumerate(found.points, start=1):
        name = point.name or f"P{number}"
        where = f"{path}, row {point.row}: {name}"
        place = require_near_trajectory(np.array(point.coordinates), system, trajectory, where)
        placed.append((point, place))
    return placed, columns_note(found, system)


def _group_points(
    points: Sequence[tuple[ListedPoint, Array]], sigma: float, path: Path
) -> tuple[tuple[str, ...], Array, Array, tuple[PlaneReference, ...], list[Message]]:
    """Group surveyed points into single points and planes, with warnings about uneven planes."""
    alone = [(p.name or f"P{k}", x, sigma if p.sigma is None else p.sigma)
             for k, (p, x) in enumerate(points, start=1) if not p.plane]  # fmt: skip
    together: dict[str, list[tuple[Array, float]]] = {}
    for point, place in points:
        if point.plane:
            own = sigma if point.sigma is None else point.sigma
            together.setdefault(point.plane, []).append((place, own))
    planes, uneven = [], []
    for name, some in together.items():
        plane, off = _plane_reference(
            name, np.array([x for x, _ in some]), [s for _, s in some], path
        )
        planes.append(plane)
        if off is not None:
            uneven.append(off)
    return (
        tuple(name for name, _, _ in alone),
        np.array([x for _, x, _ in alone]).reshape(-1, 3),
        np.array([s for _, _, s in alone]),
        tuple(planes),
        uneven,
    )


def sigma_warnings(points: Sequence[ListedPoint]) -> list[Message]:
    """Warning about standard deviations that are probably not in metres, if there are any."""
    large = [
        (point.name or f"P{k}", point.sigma)
        for k, point in enumerate(points, start=1)
        if point.sigma is not None and point.sigma > MAX_PLAUSIBLE_SIGMA
    ]
    if not large:
        return []
    name, sigma = large[0]
    limit = MAX_PLAUSIBLE_SIGMA
    return [warning("reference.large_sigma", count=len(large), name=name, sigma=sigma, limit=limit)]


def _plane_reference(
    name: str, points: Array, sigmas: Sequence[float], path: Path
) -> tuple[PlaneReference, Message | None]:
    """Fit a plane to surveyed points, with a warning about a point that does not lie on it.

    Raises
    ------
    InputError
        If the points do not determine a plane.
    """
    from scipy.spatial import Delaunay, QhullError

    if len(points) < 3:
        raise InputError(
            error("check.few_plane_points", file=str(path), plane=name, count=len(points))
        )
    own = np.maximum(np.array(sigmas), 1e-6)
    try:
        plane = fit_plane(points, 1 / own**2)
        Delaunay((points - points.mean(axis=0)) @ plane_axes(plane.normal).T)
    except (PlaneNotFound, QhullError) as failure:
        raise InputError(error("check.points_in_one_row", file=str(path), plane=name)) from failure
    flat = (points - points.mean(axis=0)) @ plane_axes(plane.normal).T
    design = np.column_stack([np.ones(len(points)), flat])
    covariance = np.linalg.inv(design.T @ (design / own[:, None] ** 2))
    off = plane.distances(points)
    worst = int(np.argmax(np.abs(off) / own))
    found = PlaneReference(name, points, plane, float(np.sqrt(covariance[0, 0])))
    if abs(off[worst]) <= 3 * own[worst]:
        return found, None
    distance, own_sigma = abs(off[worst]), own[worst]
    return found, warning("reference.plane_off", plane=name, distance=distance, sigma=own_sigma)


def read_surface(
    opened: OpenedReference,
    survey: Survey,
    project: Project,
    search_distance: float,
    progress: Progress,
) -> tuple[Array, Message]:
    """Read the part of a scan in the area of the lines, with a note on the number of its points.

    Parameters
    ----------
    search_distance : float, metres
        Largest distance of the points from the lines.

    Raises
    ------
    InputError
        If no point of the scan is near the lines.
    """
    scan, system = opened.scan, opened.system
    seen = _CoveredCells.of(survey, project, search_distance)
    parts: list[Array] = []
    numbers: list[NDArray[np.int64]] = []
    done = kept = halvings = 0
    for chunk in scan.coordinate_chunks(local=is_local(system)):
        placed = to_local_frame(chunk, system, survey.trajectory)
        if not done:
            _require_same_site(scan.path, chunk, placed, system, survey.trajectory)
        own = np.arange(done, done + len(chunk))
        good = seen.contains(placed)
        if halvings:
            good &= is_number_in_sample(own, halvings)
        parts.append(placed[good])
        numbers.append(own[good])
        done, kept = done + len(chunk), kept + int(good.sum())
        while kept > MAX_SCAN_POINTS and halvings < MAX_HALVINGS:
            halvings += 1
            chosen = [is_number_in_sample(some, halvings) for some in numbers]
            parts = [part[which] for part, which in zip(parts, chosen, strict=True)]
            numbers = [some[which] for some, which in zip(numbers, chosen, strict=True)]
            kept = sum(map(len, parts))
        progress(
            0.5, gettext_lazy("Reading {file}: {count:n} points", file=scan.path.name, count=done)
        )
    if not kept:
        raise InputError(
            error("check.reference_elsewhere", file=str(scan.path), distance=search_distance)
        )
    used = note(
        "reference.points_used_sample" if halvings else "reference.points_used",
        file=scan.path.name, used=kept, total=done, one_in=2**halvings,
    )  # fmt: skip
    return np.concatenate(parts), used


def _require_same_site(
    path: Path, chunk: Array, placed: Array, system: CoordinateSystem | None,
    trajectory: LocalTrajectory,
) -> None:  # fmt: skip
    """Refuse a scan whose first chunk has no point near the trajectory, as one of another site."""
    step = max(1, len(placed) // 1000)
    nearest = int(np.argmin(distances_from_trajectory(placed[::step], trajectory)))
    require_near_trajectory(chunk[::step][nearest], system, trajectory, f"{path}")


@dataclass(frozen=True, eq=False)
class _CoveredCells:
    """Cells of the local frame that contain points of the lines, and neighbouring cells."""

    side: float
    low: Array
    counts: NDArray[np.int64]
    cells: NDArray[np.int64]

    @classmethod
    def of(cls, survey: Survey, project: Project, search_distance: float) -> "_CoveredCells":
        side = max(MIN_CELL_SIZE, search_distance)
        seen = [
            np.unique(np.floor(cloud.sample / side).astype(np.int64), axis=0)
            for clouds in (
                survey.clouds,
                *(() if project.result is None else (survey.placed(project, "estimated"),)),
            )
            for cloud in clouds.values()
        ]
        cells = np.unique(np.concatenate(seen), axis=0)
        low = cells.min(axis=0) - 1
        counts = cells.max(axis=0) + 2 - low
        offsets = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3), axis=-1).reshape(-1, 3)
        neighbours = [np.ravel_multi_index((cells - low + offset).T, counts) for offset in offsets]
        return cls(side, low, counts, np.unique(np.concatenate(neighbours)))

    def contains(self, points: Array) -> NDArray[np.bool_]:
        """Flags of points, shape (n, 3), that lie in the cells; False for points not finite."""
        at = np.floor(points / self.side) - self.low
        inside = np.asarray(((at >= 0) & (at < self.counts)).all(axis=1))
        found = np.zeros(len(points), dtype=bool)
        keys = np.ravel_multi_index(at[inside].astype(np.int64).T, self.counts)
        where = np.minimum(np.searchsorted(self.cells, keys), len(self.cells) - 1)
        found[inside] = self.cells[where] == keys
        return found
