"""Opening a project's survey: trajectory and lines read, checked and georeferenced."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.progress import Progress, no_progress, part
from lispac.project import LineSource, Project
from lispac.survey.georeferencing import georeference
from lispac.survey.scan import Scan
from lispac.survey.time_base import matches, sentence
from lispac.survey.time_quality import coverage
from lispac.survey.trajectory import LocalTrajectory, TrajectoryAccuracy
from lispac.workflow.reading import read_accuracy, read_line, read_trajectory

Array = NDArray[np.float64]

FARTHEST_ORIGIN = 100_000.0
"""Metres; beyond, a plane tangent at the origin is no frame for the site."""


@dataclass(frozen=True, eq=False)
class Survey:
    """The data of a project, in memory.

    Attributes
    ----------
    scans : points of each line by its name
    clouds : ndarray of shape (n, 3) by line, metres, local frame
        Placed with the prior boresight.
    heading : median heading of the vessel on each line, radians
    notes : tuple of str
        What was assumed or left out while reading, in words.
    """

    trajectory: LocalTrajectory
    accuracy: TrajectoryAccuracy
    scans: Mapping[str, Scan]
    clouds: Mapping[str, Array]
    heading: Mapping[str, float]
    notes: tuple[str, ...]

    @property
    def lines(self) -> tuple[str, ...]:
        """Names of the lines in the project's order."""
        return tuple(self.scans)

    def placed(
        self,
        project: Project,
        which: Literal["prior", "estimated"],
        *,
        progress: Progress = no_progress,
    ) -> Mapping[str, Array]:
        """Points of every line, local frame, with the prior or the estimated boresight."""
        if which == "prior":
            return self.clouds
        mounting = project.mounting(which)
        count = len(self.scans)
        return {
            name: georeference(
                scan.points_lidar, scan.time, self.trajectory, mounting,
                progress=part(progress, k / count, (k + 1) / count),
            )
            for k, (name, scan) in enumerate(self.scans.items())
        }  # fmt: skip


def load_survey(project: Project, *, progress: Progress = no_progress) -> Survey:
    """Read everything the project points at.

    Raises
    ------
    InputError
        Where a file is missing, damaged, or does not fit the others.
    """
    progress(0.0, f"Reading {project.trajectory.name}")
    raw = read_trajectory(project.trajectory, project.trajectory_reading)
    frame = _frame(project) or raw.mean_frame()
    trajectory = LocalTrajectory.of(raw, frame, project.settings.longest_gap)
    _require_near(trajectory, project)
    notes = list(raw.assumptions)
    if project.accuracy is not None:
        accuracy = read_accuracy(project.accuracy, project.accuracy_reading)
        _require_overlap(accuracy, trajectory, project.accuracy)
    else:
        accuracy = TrajectoryAccuracy.constant(
            np.array(project.settings.position_sigma),
            np.radians(project.settings.attitude_sigma_deg),
        )
        notes.append("POS accuracies are the typed ones, the same at all times")
    scans: dict[str, Scan] = {}
    clouds: dict[str, Array] = {}
    heading: dict[str, float] = {}
    mounting = project.mounting("prior")
    for k, line in enumerate(project.lines):
        step = part(
            progress, 0.1 + 0.9 * k / len(project.lines), 0.1 + 0.9 * (k + 1) / len(project.lines)
        )
        step(0.0, f"Reading {line.path.name}")
        scan = read_line(line, trajectory, mounting)
        scan, note = _inside(scan, trajectory, line.path)
        notes += [*scan.assumptions, *note]
        step(0.7, f"Georeferencing {line.name}")
        clouds[line.name] = georeference(scan.points_lidar, scan.time, trajectory, mounting)
        scans[line.name] = scan
        heading[line.name] = _median_heading(trajectory, scan)
        _require_picked_on(project, line, scan)
    progress(1.0, "Survey loaded")
    return Survey(trajectory, accuracy, scans, clouds, heading, tuple(dict.fromkeys(notes)))


def _frame(project: Project) -> LocalFrame | None:
    if project.settings.origin_deg_m is None:
        return None
    latitude, longitude, height = project.settings.origin_deg_m
    return LocalFrame(float(np.radians(latitude)), float(np.radians(longitude)), height)


def _require_near(trajectory: LocalTrajectory, project: Project) -> None:
    distance = float(np.linalg.norm(trajectory.position[0]))
    if distance > FARTHEST_ORIGIN:
        raise InputError(
            f"{project.name}: the origin is {distance / 1000:,.0f} km from the trajectory; give "
            "its latitude and longitude in degrees, or leave it out."
        )


def _require_picked_on(project: Project, line: LineSource, scan: Scan) -> None:
    for target in project.targets:
        sighting = target.sighting(line.name)
        if sighting is not None and sighting.fingerprint not in ("", scan.fingerprint):
            raise InputError(
                f"{line.path}: these are not the points {target.name} was picked on (or the "
                "trajectory covers others of them now); bring the file back, or make a new project."
            )


def _require_overlap(accuracy: TrajectoryAccuracy, trajectory: LocalTrajectory, path: Path) -> None:
    if accuracy.time[-1] < trajectory.time[0] or accuracy.time[0] > trajectory.time[-1]:
        raise InputError(
            f"{path}: its times ({accuracy.time[0]:.1f} to {accuracy.time[-1]:.1f} s) do not meet "
            f"those of the trajectory ({trajectory.time[0]:.1f} to {trajectory.time[-1]:.1f} s); "
            "give the accuracy file that belongs to it."
        )


def _inside(scan: Scan, trajectory: LocalTrajectory, path: Path) -> tuple[Scan, tuple[str, ...]]:
    inside = trajectory.covers(scan.time)
    if inside.all() and not trajectory.has_gaps:
        return scan, ()
    if not inside.any():
        told = sentence(matches(scan.time[:: max(1, len(scan) // 1000)], trajectory.time))
        raise InputError(
            f"{path}: its points ({scan.time.min():.1f} to {scan.time.max():.1f} s) lie outside "
            f"the trajectory ({trajectory.time[0]:.1f} to {trajectory.time[-1]:.1f} s); "
            f"check the date and the time base, or leave the line out. {told}"
        )
    kept = Scan(
        scan.points_lidar[inside],
        scan.time[inside],
        None if scan.intensity is None else scan.intensity[inside],
        scan.assumptions,
    )
    lost = len(scan) - len(kept)
    if lost == 0:
        return scan, ()
    covered = coverage(scan.time, trajectory.time, trajectory.longest_gap)
    parts = []
    if covered.outside:
        parts.append(f"{covered.outside:,} points outside the trajectory's time")
    if covered.in_gaps:
        parts.append(
            f"{covered.in_gaps:,} points in a gap of the trajectory longer than "
            f"{trajectory.longest_gap:g} s"
        )
    if steep := lost - covered.outside - covered.in_gaps:
        parts.append(f"{steep:,} points where the trajectory's pitch is beyond 80 deg")
    return kept, (f"{path.name}: {' and '.join(parts)}, of {len(scan):,}, are left out",)


def _median_heading(trajectory: LocalTrajectory, scan: Scan) -> float:
    # A few hundred states tell the course of a line.
    times = np.linspace(scan.time.min(), scan.time.max(), 201)
    return float(np.median(trajectory.at(times).attitude[:, 2]))
