"""Export of targets and the trajectory for other programs."""

from collections.abc import Iterable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations, Sighting
from lispac.errors import InputError, ProjectError
from lispac.geometry.planes import fit_plane
from lispac.io.files import atomic_write
from lispac.io.format_types import PointChunk
from lispac.io.las.las_export import layout_of_columns, open_cloud_writer
from lispac.io.text.plane_file import write_plane_file
from lispac.io.text.text_export import (
    LINE_AND_TIME_COLUMNS,
    SCANNER_COLUMN_NAMES,
    coordinate_names,
    write_table,
    write_trajectory_text,
)
from lispac.io.trajectory.sbet import write_sbet
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.project import BoresightChoice, Project, Target
from lispac.survey.crs import CoordinateSystem
from lispac.survey.georeferencing import georeference
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.workflow.importing.file_reading import read_trajectory
from lispac.workflow.importing.given_time_bases import time_base_of_trajectory
from lispac.workflow.output.georeferencing import require_no_overwrite
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]
PointsEnding = Literal["laz", "las", "csv"]
TrajectoryFormat = Literal["sbet", "text"]


@dataclass(frozen=True, eq=False)
class _TargetPoints:
    """All points of a target, the lines one after the other."""

    points_lidar: Array
    time: Array
    line: NDArray[np.int64]
    intensity: Array | None


def export_targets(
    project: Project,
    survey: Survey,
    output: Path,
    which: BoresightChoice = "estimated",
    *,
    system: CoordinateSystem | None = None,
    ending: PointsEnding = "laz",
    names: Sequence[str] = (),
    progress: Progress = no_progress,
) -> list[Path]:
    """Write the points of every target and validation plane, one file each.

    LAS and LAZ files contain the number of the line, from 1, as point source ID, and the scanner's
    x, y, z as extra bytes; CSV files contain the name of the line.

    Parameters
    ----------
    output : Path
        Output folder.
    system : CoordinateSystem, optional
        Coordinate system of the output; the local frame by default.
    names : sequence of str
        Names of the targets; all by default.

    Raises
    ------
    ProjectError
        If there is no such target, or nothing has been estimated.
    InputError
        If the folder cannot be written.
    """
    mapper = ScannerPointConverter(system, survey.trajectory, project.mounting(which))
    targets = exported_targets(project, names)
    paths = target_paths(output, targets, which, ending)
    require_no_overwrite(project, paths)
    with ExitStack() as stack:
        for k, (target, path) in enumerate(zip(targets, paths, strict=True)):
            progress(k / len(targets), gettext_lazy("Writing {file}", file=path.name))
            own = _target_points(target, survey)
            placed = mapper.to_map(own.points_lidar, own.time)
            temporary = stack.enter_context(atomic_write(path))
            if ending == "csv":
                _write_csv(temporary, own, placed, survey.lines, system)
            else:
                _write_las(temporary, path, own, placed, mapper)
        progress(1.0)
    return paths


def export_planes(
    project: Project,
    survey: Survey,
    output: Path,
    which: BoresightChoice = "estimated",
    *,
    names: Sequence[str] = (),
    progress: Progress = no_progress,
) -> list[Path]:
    """Write the points of every planar target as a 25-column plane file, in the local frame.

    Range and scan-angle offset are applied to the scanner coordinates and the latency to the times,
    so that only lever arm and boresight are needed to compute the local coordinates in the file.

    Raises
    ------
    ProjectError
        If there is no such target, it is a sphere, or nothing has been estimated.
    InputError
        If the folder cannot be written.
    """
    mounting = project.mounting(which)
    spheres = [name for name in names if project.target(name).shape == "sphere"]
    if spheres:
        raise ProjectError(error("export.sphere", target=spheres[0]))
    targets = exported_planes(project, names)
    if not targets:
        raise ProjectError(error("export.no_planar_target", project=project.name))
    paths = target_paths(output, targets, which, "txt")
    require_no_overwrite(project, paths)
    with ExitStack() as stack:
        for k, (target, path) in enumerate(zip(targets, paths, strict=True)):
            progress(k / len(targets), gettext_lazy("Writing {file}", file=path.name))
            own = _target_points(target, survey)
            points = georeference(own.points_lidar, own.time, survey.trajectory, mounting)
            poses = survey.trajectory.at(own.time + mounting.latency)
            sigma_position, sigma_attitude = survey.accuracy.at(own.time + mounting.latency)
            lines, sighting = np.unique(own.line, return_inverse=True)
            observations = Observations(
                points_lidar=mounting.corrected(own.points_lidar),
                position=poses.position,
                attitude=poses.attitude,
                sigma_lidar=np.full((len(points), 3), project.settings.used_lidar_sigma),
                sigma_position=sigma_position,
                sigma_attitude=sigma_attitude,
                time=own.time + mounting.latency,
                sighting=sighting.reshape(-1),
                sightings=tuple(Sighting(target.name, survey.lines[n]) for n in lines),
            )
            plane = fit_plane(points).facing(poses.position.mean(axis=0) - points.mean(axis=0))
            write_plane_file(
                stack.enter_context(atomic_write(path)), observations, target.name, points,
                np.append(plane.normal, plane.d),
            )  # fmt: skip
        progress(1.0)
    return paths


def export_trajectory(project: Project, output: Path, form: TrajectoryFormat = "sbet") -> Path:
    """Write the trajectory as SBET with Applanix's conventions, or as text.

    Raises
    ------
    InputError
        If the trajectory cannot be read, or the file cannot be written or is one of the project.
    """
    if output.exists() and output.samefile(project.trajectory):
        raise InputError(error("export.own_trajectory", file=str(output)))
    require_no_overwrite(project, [output])
    trajectory = read_trajectory(project.trajectory, project.trajectory_reading)
    if form == "sbet":
        write_sbet(output, trajectory)
    else:
        with atomic_write(output) as temporary:
            write_trajectory_text(temporary, trajectory, time_base_of_trajectory(project))
    return output


SBET_ZEROS_NOTE = note("export.sbet_zeros")
"""Note on the fields of an SBET that are written as zeros."""


def trajectory_datum_note(project: Project) -> Message:
    """Note on datum and epoch of an exported trajectory."""
    return note("export.trajectory_datum", file=project.trajectory.name)


def target_paths(
    output: Path, targets: Iterable[Target], which: BoresightChoice, ending: str
) -> list[Path]:
    """Files that are written to a folder for some targets, in their order."""
    return [output / f"{target.name}_{which}.{ending}" for target in targets]


def exported_planes(project: Project, names: Sequence[str] = ()) -> list[Target]:
    """Planar targets that are written, by default all.

    Raises
    ------
    ProjectError
        If there is no such target or none with points.
    """
    return [target for target in exported_targets(project, names) if target.shape == "plane"]


def exported_targets(project: Project, names: Sequence[str] = ()) -> list[Target]:
    """Targets that are written, by default all.

    Raises
    ------
    ProjectError
        If there is no such target or none with points.
    """
    chosen = [project.target(name) for name in names] or list(project.targets)
    found = [target for target in chosen if target.sightings]
    if not found:
        raise ProjectError(error("export.no_target", project=project.name))
    return found


def _target_points(target: Target, survey: Survey) -> _TargetPoints:
    """Points of the used sightings, or of all sightings if none is used."""
    parts = target.used_sightings or target.sightings
    scans = [survey.scans[sighting.line] for sighting in parts]
    chosen = [sighting.indices for sighting in parts]
    scanned = [scan.take(numbers) for scan, numbers in zip(scans, chosen, strict=True)]
    found = [scan.intensities(numbers) for scan, numbers in zip(scans, chosen, strict=True)]
    intensities = [values for values in found if values is not None]
    return _TargetPoints(
        np.concatenate([points for points, _ in scanned]),
        np.concatenate([times for _, times in scanned]),
        np.repeat([survey.lines.index(s.line) for s in parts], [len(i) for i in chosen]),
        np.concatenate(intensities) if len(intensities) == len(scans) else None,
    )


def _write_csv(
    path: Path,
    points: _TargetPoints,
    placed: Array,
    lines: Sequence[str],
    system: CoordinateSystem | None,
) -> None:
    names, formats = coordinate_names(system)
    columns = [np.array(lines)[points.line], points.time, *placed.T, *points.points_lidar.T]
    titles = [*LINE_AND_TIME_COLUMNS, *names, *SCANNER_COLUMN_NAMES]
    forms = ["s", ".9f", *formats, ".5f", ".5f", ".5f"]
    if points.intensity is not None:
        columns.append(points.intensity)
        titles.append("intensity")
        forms.append("g")
    write_table(path, titles, columns, forms)


def _write_las(
    path: Path, shown: Path, points: _TargetPoints, placed: Array, mapper: ScannerPointConverter
) -> None:
    scanner = {f"{axis}_lidar": points.points_lidar[:, k] for k, axis in enumerate("xyz")}
    extra: dict[str, NDArray[Any]] = {
        "point_source_id": (points.line + 1).astype(np.uint16),
        **scanner,
    }
    if points.intensity is not None:
        extra["intensity"] = points.intensity
    pattern = layout_of_columns(PointChunk(placed, points.time, extra, len(placed)))
    with open_cloud_writer(
        path,
        pattern,
        mapper.system,
        placed.mean(axis=0),
        mounting=mapper.mounting,
        frame=mapper.trajectory.frame,
        compressed=shown.suffix == ".laz",
        shown=shown,
    ) as cloud:
        cloud.write(cloud.records(placed, points.time, extra))
