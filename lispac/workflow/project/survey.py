"""Loading of a project's survey: trajectory and lines are read, checked and georeferenced."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, ProjectError
from lispac.io.format_types import SAME_TIME_BASE_NOTE, Kind
from lispac.io.formats import format_of, is_las
from lispac.io.las.las_chunks import point_count
from lispac.language import gettext_lazy
from lispac.messages import Level, Message, Value, error, note
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.audit_messages import line_messages, shared_messages, simultaneous_messages
from lispac.survey.cloud import Cloud, CloudInMemory, CloudOnDisk, Line, place_clouds
from lispac.survey.georeferencing import Georeferencer, Mounting
from lispac.survey.line_audit import LineAudit
from lispac.survey.line_source import printable
from lispac.survey.point_screening import parse_largest_range
from lispac.survey.scan import Scan
from lispac.survey.store.layout import has_import
from lispac.survey.store.stored_line import MAX_ROUNDING_SHARE, StoredLine
from lispac.survey.time_quality import accuracy_coverage_warning
from lispac.survey.trajectory import LocalTrajectory, TrajectoryAccuracy
from lispac.survey.trajectory_sampling import held_position_messages, interpolation_messages
from lispac.targets.rough_alignment import Alignment, align_lines
from lispac.untrusted_values import InvalidContentError
from lispac.value_conversion import decode_value
from lispac.warning_causes import Cause
from lispac.workflow.importing.file_reading import (
    DEFAULT_FORMATS,
    local_trajectory,
    read_accuracy,
)
from lispac.workflow.importing.line_import import assumptions_of, import_line, line_folder
from lispac.workflow.importing.line_points import LineFindings, read_line
from lispac.workflow.project.moved_files import require_files

MAX_PLAUSIBLE_SIGMA_M, MAX_PLAUSIBLE_SIGMA_RAD = 1e4, np.pi
"""Largest plausible standard deviations of a POS, metres and radians; exporters write larger values
where there is no solution."""
DATA_STEP = Cause.of_step("Data")
"""Cause of messages about the data in general, which leads to their step in the window."""
MAX_POINTS_IN_MEMORY = 4_000_000
"""Number of points above which a line is imported into the project's store. Smaller lines are read
into memory when the project is opened, with 64 bytes per point."""
SAMPLED_RUNS, POINTS_PER_RUN = 64, 16
"""Number of places of a line, and of consecutive points at each, whose times are compared with the
states of the trajectory."""
AUDIT_TIMES_PER_LINE = 1001
"""Number of times of a line at which the motion of the vessel is evaluated for the audit."""
TEXT_BYTES_PER_POINT = 40
"""Approximate number of bytes of a point in a file without a point count."""


@dataclass(frozen=True, eq=False)
class LineFile:
    """Points of a line in memory, as read from its file.

    Attributes
    ----------
    key : tuple
        Values that the reading depends on, besides the trajectory.
    """

    key: tuple[object, ...]
    scan: Scan
    findings: LineFindings


@dataclass(frozen=True, eq=False)
class SurveyFiles:
    """What was read from the files of a survey, except from its imported lines.

    Attributes
    ----------
    key : tuple
        Values that the trajectory depends on.
    trajectory : LocalTrajectory
    assumptions : tuple of Message
        Assumptions of the reader of the trajectory.
    lines : mapping of str to LineFile
        Lines in memory, by name.
    """

    key: tuple[object, ...]
    trajectory: LocalTrajectory
    assumptions: tuple[Message, ...]
    lines: Mapping[str, LineFile] = field(default_factory=dict)

    @classmethod
    def of(cls, project: Project, former: "SurveyFiles | None") -> "SurveyFiles":
        """Files of a project: the former ones if the trajectory is the same; else only that.

        Raises
        ------
        InputError
            If the trajectory cannot be read.
        """
        key = _trajectory_key(project)
        if former is not None and former.key == key:
            return former
        return cls(key, *local_trajectory(project))

    def line(self, name: str, key: tuple[object, ...]) -> LineFile | None:
        """Line that was read with the same key; None if there is none."""
        found = self.lines.get(name)
        return found if found is not None and found.key == key else None


@dataclass(frozen=True, eq=False)
class Survey:
    """The data of a project: large lines on disk, small ones in memory.

    Attributes
    ----------
    scans : points of each line by its name
    clouds : lines in the local frame, placed with the prior mounting, by name
    heading : median heading of the vessel on each line, radians
    notes : tuple of Message
        Notes on assumptions and excluded data from the reading of the files.
    messages : tuple of Message
        Warnings and notes about the content of the files.
    excluded : mapping of str to int
        Number of points in the file of each line that are not used; only lines with such points.
    files : SurveyFiles or None
        What `load_survey` can use again after an edit of the project.
    """

    trajectory: LocalTrajectory
    accuracy: TrajectoryAccuracy
    scans: Mapping[str, Line]
    clouds: Mapping[str, Cloud]
    heading: Mapping[str, float]
    notes: tuple[Message, ...]
    messages: tuple[Message, ...] = ()
    excluded: Mapping[str, int] = field(default_factory=dict)
    files: SurveyFiles | None = None

    @property
    def lines(self) -> tuple[str, ...]:
        """Names of the lines in the project's order."""
        return tuple(self.scans)

    @property
    def headings_deg(self) -> dict[str, float]:
        """Median heading of the vessel on each line, degrees, 0 to 360."""
        return {name: float(np.degrees(heading)) % 360 for name, heading in self.heading.items()}

    def placed(self, project: Project, which: Literal["prior", "estimated"]) -> Mapping[str, Cloud]:
        """Point clouds of the lines, georeferenced with the prior or the estimated mounting."""
        if which == "prior":
            return self.clouds
        return place_clouds(self.clouds, project.mounting(which))

    def displayed_clouds(
        self,
        project: Project,
        which: Literal["prior", "estimated"],
        *,
        progress: Progress = no_progress,
    ) -> Mapping[str, Cloud]:
        """Lines as in `placed`, with samples for the display prepared."""
        clouds = self.placed(project, which)
        for k, (name, cloud) in enumerate(clouds.items()):
            progress(
                k / len(clouds), gettext_lazy("Computing the point positions of {line}", line=name)
            )
            assert len(cloud.sample)
        return clouds

    @cached_property
    def alignment(self) -> Alignment:
        """Lines aligned for the search for targets; computed on first access (some seconds)."""
        return align_lines(self.clouds)

    def lidar_sigma(self, settings: Settings) -> float:
        """Sigma of a LiDAR point on a surface of any orientation, metres.

        If the noise is given along and across the beam, it is the larger of the two at the median
        range of the survey.
        """
        if settings.lidar_beam_sigma is None:
            return settings.used_lidar_sigma
        along, angle_deg = settings.lidar_beam_sigma
        ranges = np.concatenate([cloud.sample_range for cloud in self.clouds.values()])
        return max(along, float(np.nanmedian(ranges) * np.radians(angle_deg)))

    def with_prior(self, mounting: Mounting) -> "Survey":
        """Survey with the same data placed with another prior mounting."""
        return replace(self, clouds=place_clouds(self.clouds, mounting))


def data_key(project: Project) -> tuple[object, ...]:
    """Key of all values that the loaded data depend on."""
    settings = project.settings
    return (
        project.trajectory,
        project.trajectory_reading,
        project.accuracy,
        project.lines,
        settings.lever_arm,
        settings.boresight_deg,
        settings.origin_deg_m,
        settings.used_position_sigma,
        settings.used_attitude_sigma_deg,
        settings.range_offset,
        settings.scan_angle_offset_deg,
        settings.latency,
        settings.longest_gap,
    )


def load_survey(
    project: Project, *, former: Survey | None = None, progress: Progress = no_progress
) -> Survey:
    """Read all files to which the project refers.

    Imported lines are opened from their store. A line is imported again if its import was
    interrupted, or if its file or the settings and data of the import have changed. Lines with
    large files are imported.

    Parameters
    ----------
    former : Survey, optional
        Survey of the project before an edit. A file is not read again unless it, or the settings
        on which its reading depends, have changed.

    Raises
    ------
    InputError
        If a file is missing, damaged, or does not fit the others.
    ProjectError
        If a line has to be imported and its store cannot be written.
    """
    require_files(project)
    progress(0.0, gettext_lazy("Reading {file}", file=project.trajectory.name))
    files = SurveyFiles.of(project, None if former is None else former.files)
    trajectory, line_files = files.trajectory, {}
    accuracy, of_accuracy = trajectory_accuracy(project, trajectory)
    read = (*project.reading_warnings, *_with_shift_notes(project, files.assumptions), *of_accuracy)
    messages = (*_file_messages(project), *trajectory.messages)
    messages += _accuracy_messages(project, accuracy)
    audits: dict[str, LineAudit] = {}
    scans: dict[str, Line] = {}
    clouds: dict[str, Cloud] = {}
    heading: dict[str, float] = {}
    for k, line in enumerate(project.lines):
        step = sub_progress(
            progress, 0.1 + 0.9 * k / len(project.lines), 0.1 + 0.9 * (k + 1) / len(project.lines)
        )
        key = _line_key(project, line)
        scan, cloud, of_line, found = _open_line(
            project, line, trajectory, files.line(line.name, key), step
        )
        if isinstance(scan, Scan) and found is not None:
            line_files[line.name] = LineFile(key, scan, found)
        read += of_line
        if found is None:
            messages += (_not_checked_note(line.name),)
        else:
            audits[line.name] = found.audit
            times = np.linspace(scan.first_time, scan.last_time, AUDIT_TIMES_PER_LINE)
            times = times[trajectory.covers(times)]
            messages += line_messages(line.name, found.audit, trajectory, times)
            messages += found.recovery
        messages += _range_messages(line, scan)
        scans[line.name], clouds[line.name] = scan, cloud
        heading[line.name] = _median_heading(trajectory, scan)
        _require_picked_points(project, line, scan)
    messages += shared_messages(audits)
    first_times = {name: scan.first_time for name, scan in scans.items()}
    messages += simultaneous_messages(audits, first_times)
    sampled = {name: _sample_times(scan) for name, scan in scans.items()}
    dense = {name: partial(getattr, cloud, "sample_time") for name, cloud in clouds.items()}
    messages += interpolation_messages(trajectory, accuracy, sampled, dense)
    messages += held_position_messages(trajectory, accuracy, sampled)
    progress(1.0)
    unused = {
        name: audit.read - audit.not_selected - len(scans[name]) for name, audit in audits.items()
    }
    notes = tuple(each for each in dict.fromkeys(read) if not each.is_serious)
    warnings = tuple(
        replace(each, subject=each.subject or file_cause(project, each))
        for each in dict.fromkeys(read)
        if each.is_serious
    )
    return Survey(
        trajectory, accuracy, scans, clouds, heading, notes, messages + warnings,
        {name: count for name, count in unused.items() if count > 0},
        replace(files, lines=line_files),
    )  # fmt: skip


def _trajectory_key(project: Project) -> tuple[object, ...]:
    """Key of all that the trajectory in the local frame depends on."""
    settings = project.settings
    return (
        project.trajectory, _file_state(project.trajectory), project.trajectory_reading,
        settings.origin_deg_m, settings.longest_gap,
    )  # fmt: skip


def _line_key(project: Project, line: LineSource) -> tuple[object, ...]:
    """Key of all that the points of a line depend on, besides the trajectory."""
    settings = project.settings
    key = (line, _file_state(line.path), settings.latency)
    if not line.reading.format:  # in the scanner frame
        return key
    return (
        *key, settings.lever_arm, settings.boresight_deg, settings.range_offset,
        settings.scan_angle_offset_deg,
    )  # fmt: skip


def _file_state(path: Path) -> tuple[int, ...]:
    """Numbers that change when a file is written; none for a missing file."""
    try:
        state = path.stat()
    except OSError:
        return ()
    return state.st_dev, state.st_ino, state.st_size, state.st_mtime_ns, state.st_ctime_ns


def file_cause(project: Project, about: Message) -> Cause:
    """Cause of a message about a file: the line of the file, else the data in general."""
    lines = [
        line for line in project.lines
        if about.params.get("file") in (printable(line.path.name), str(line.path))
    ]  # fmt: skip
    return Cause.of_line(lines[0].name) if len(lines) == 1 else DATA_STEP


def _range_messages(line: LineSource, scan: Line) -> tuple[Message, ...]:
    """Warning about points of a stored line that the present range limit excludes."""
    if not isinstance(scan, StoredLine):
        return ()
    limit = parse_largest_range(dict(line.reading.options).get("max_range", ""))
    if scan.reach <= limit * (1.0 + MAX_ROUNDING_SHARE):
        return ()
    params: dict[str, Value] = {"line": line.name, "distance": scan.reach, "limit": limit}
    return (Message("audit.beyond_range", Level.WARNING, params, Cause.of_line(line.name)),)


def _not_checked_note(name: str) -> Message:
    return Message("audit.not_checked", Level.NOTE, {"line": name}, Cause.of_line(name))


def _file_messages(project: Project) -> tuple[Message, ...]:
    """Messages of the readers about the files of a project that can be examined."""
    files: list[tuple[Kind, Path, Reading, Cause]] = [
        ("trajectory", project.trajectory, project.trajectory_reading, DATA_STEP)
    ]
    if project.accuracy is not None:
        files.append(("accuracy", project.accuracy, project.accuracy_reading, DATA_STEP))
    for line in project.lines:
        if not line.columns:
            files.append(("points", line.path, line.reading, Cause.of_line(line.name)))
    found: list[Message] = []
    for kind, path, reading, subject in files:
        format = format_of(reading.format or DEFAULT_FORMATS[kind])
        try:
            messages = format.messages(path, dict(reading.options))
        except InputError:  # the reader reports this error if the file is needed
            continue
        found += [replace(each, subject=each.subject or subject) for each in messages]
    return tuple(dict.fromkeys(found))


def _with_shift_notes(project: Project, assumed: tuple[Message, ...]) -> tuple[Message, ...]:
    """Assumptions, and notes on the time shifts of lines, if there are any."""
    shifted = [line for line in project.lines if line.reading.time_shift]
    if not shifted:
        return assumed
    kept = (
        note("assumed.same_time_base_shifted") if each == SAME_TIME_BASE_NOTE else each
        for each in assumed
    )
    shifts = (
        note("assumed.time_shift", file=printable(line.path.name), shift=line.reading.time_shift)
        for line in shifted
    )
    return (*kept, *shifts)


def trajectory_accuracy(
    project: Project, trajectory: LocalTrajectory
) -> tuple[TrajectoryAccuracy, tuple[Message, ...]]:
    """Standard deviations of the trajectory, from their file or the settings, and messages.

    Raises
    ------
    InputError
        If the file cannot be read, or does not overlap with the trajectory.
    """
    if project.accuracy is not None:
        accuracy = read_accuracy(project.accuracy, project.accuracy_reading)
        _require_overlap(accuracy, trajectory, project.accuracy)
        file = printable(project.accuracy.name)
        too_short = accuracy_coverage_warning(accuracy.time, trajectory.time, file)
        return accuracy, () if too_short is None else (too_short,)
    typed = TrajectoryAccuracy.constant(
        np.array(project.settings.used_position_sigma),
        np.radians(project.settings.used_attitude_sigma_deg),
    )
    is_assumed = set(project.settings.assumed_sigmas) - {"LiDAR"}
    code = "assumed.accuracy" if is_assumed else "assumed.constant_accuracy"
    return typed, (note(code),)


def _accuracy_messages(project: Project, accuracy: TrajectoryAccuracy) -> tuple[Message, ...]:
    """Warning about standard deviations that are not plausible for a POS, if there are any."""
    if project.accuracy is None:
        return ()
    far = (accuracy.position > MAX_PLAUSIBLE_SIGMA_M).any(axis=1)
    turned = (accuracy.attitude > MAX_PLAUSIBLE_SIGMA_RAD).any(axis=1)
    count = int((far | turned).sum())
    if not count:
        return ()
    params: dict[str, Value] = {
        "file": project.accuracy.name, "count": count, "share": count / len(accuracy.time),
    }  # fmt: skip
    return (Message("accuracy.too_large", Level.WARNING, params, DATA_STEP),)


def _open_line(
    project: Project,
    line: LineSource,
    trajectory: LocalTrajectory,
    known: LineFile | None,
    progress: Progress,
) -> tuple[Line, Cloud, tuple[Message, ...], LineFindings | None]:
    """Open a line from its store or file; returns it, its cloud, notes on its reading, and audit.

    The file is not read if its content is ``known``.

    Raises
    ------
    ProjectError
        If the audit of the store is damaged.
    """
    mounting = project.mounting("prior")
    if _belongs_on_disk(project, line):
        imported = import_line(project, line, trajectory, progress=progress)
        stored = imported.stored
        cloud = CloudOnDisk(stored, Georeferencer.of(trajectory, mounting))
        notes = assumptions_of(stored)
        if imported.reason:
            notes = (imported.reason, *notes)
        if not line.path.exists():
            notes += (note("import.file_gone", file=str(line.path), line=line.name),)
        try:
            found = (
                decode_value(stored.manifest.audit, LineFindings) if stored.manifest.audit else None
            )
        except InvalidContentError as failure:
            raise ProjectError(error("store.audit_damaged", line=line.name)) from failure
        return stored, cloud, notes, found
    if known is None:
        progress(0.0, gettext_lazy("Reading {file}", file=line.path.name))
        scan, found = read_line(line, trajectory, mounting)
    else:
        scan, found = known.scan, known.findings
    progress(0.7, gettext_lazy("Georeferencing {line}", line=line.name))
    placed = CloudInMemory.of(scan, trajectory, mounting)
    return scan, placed, scan.assumptions, found


def _belongs_on_disk(project: Project, line: LineSource) -> bool:
    """True if a line is imported already, or too large to be read into memory."""
    if has_import(line_folder(project, line)):
        return True
    return line.path.is_file() and _estimate_point_count(line.path) > MAX_POINTS_IN_MEMORY


def _estimate_point_count(path: Path) -> int:
    """Approximate number of points of a line."""
    if is_las(path):
        try:
            return point_count(path)
        except InputError:
            return 0
    return path.stat().st_size // TEXT_BYTES_PER_POINT


def _require_picked_points(project: Project, line: LineSource, scan: Line) -> None:
    for target in project.targets:
        sighting = target.sighting(line.name)
        if sighting is not None and sighting.fingerprint not in ("", scan.fingerprint):
            raise InputError(error("import.other_points", file=str(line.path), target=target.name))
        if sighting is not None and len(sighting.indices) and sighting.indices.max() >= len(scan):
            raise ProjectError(
                error(
                    "import.points_missing",
                    folder=str(project.folder),
                    target=target.name,
                    line=line.name,
                )
            )


def _require_overlap(accuracy: TrajectoryAccuracy, trajectory: LocalTrajectory, path: Path) -> None:
    if accuracy.time[-1] < trajectory.time[0] or accuracy.time[0] > trajectory.time[-1]:
        raise InputError(
            error(
                "import.accuracy_times",
                file=str(path),
                first=float(accuracy.time[0]),
                last=float(accuracy.time[-1]),
                start=float(trajectory.time[0]),
                end=float(trajectory.time[-1]),
            )
        )


def _sample_times(scan: Line) -> NDArray[np.float64]:
    """Times of some runs of consecutive points spread over a line, shape (n,), seconds."""
    starts = np.linspace(0, max(0, len(scan) - POINTS_PER_RUN), SAMPLED_RUNS).astype(np.int64)
    numbers = np.unique(starts[:, None] + np.arange(min(POINTS_PER_RUN, len(scan))))
    return scan.take(numbers)[1]


def _median_heading(trajectory: LocalTrajectory, scan: Line) -> float:
    # A few hundred states determine the course of a line.
    times = np.linspace(scan.first_time, scan.last_time, 201)
    return float(np.median(trajectory.at(times).attitude[:, 2]))
