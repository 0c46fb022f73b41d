"""Reading of the usable points of a line in the LiDAR frame, with an audit of all its points.

The import into the store and the reading into memory both use `LinePoints`, so that a line has the
same points in both cases.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.format_types import Choice, PointChunk
from lispac.io.las.mounting_record import MountingRecord
from lispac.io.point_reader_common import crs_of_options, require_distinct_times
from lispac.messages import Level, Message, error
from lispac.project import LineSource
from lispac.survey.audit_messages import has_several_scanners
from lispac.survey.georeferencing import Mounting
from lispac.survey.line_audit import LineAudit
from lispac.survey.line_source import printable
from lispac.survey.point_screening import PointScreen, PointSelection
from lispac.survey.scan import Scan
from lispac.survey.scanner_frame_recovery import RecoverySetup, require_scanner_frame
from lispac.survey.scanner_frame_recovery_check import LineSample, recovery_messages, ring_numbers
from lispac.survey.store.point_blocks import PointPiece
from lispac.survey.time_quality import (
    TrajectoryCoverage,
    assess_coverage,
    exclusion_notes,
    join_coverages,
)
from lispac.survey.trajectory import LocalTrajectory
from lispac.warning_causes import Cause
from lispac.workflow.importing.file_reading import format_of_line
from lispac.workflow.importing.time_shift_advice import outside_trajectory_message, shift_gain_note

Array = NDArray[np.float64]

TIMES_PER_CHUNK = 100
"""Approximate number of times of each chunk that are kept for messages about the time shift."""
SAMPLE_POINTS_PER_CHUNK, MAX_SAMPLED_CHUNKS = 4000, 50
"""Largest numbers of points of a chunk and of chunks that are kept to check the recovery of a
georeferenced line."""
MAX_DISTANT_COPY_SHARE = 0.01
"""Estimated share of distant copies of points above which a line is read again without them."""


@dataclass(frozen=True)
class LineFindings:
    """Findings in the points of a line.

    Attributes
    ----------
    audit : LineAudit
    recovery : tuple of Message
        Messages about the recovery of the scanner points of a georeferenced line.
    """

    audit: LineAudit
    recovery: tuple[Message, ...] = ()


class DistantDuplicates(Exception):
    """Raised if a line has copies of points far apart in the file; it is then read again."""


LEVER_ARM_TOLERANCE = 0.001
"""Difference from the project's lever arm above which that of a cloud is reported, metres."""


def mounting_of_cloud(line: LineSource, prior: Mounting) -> tuple[Mounting, tuple[Message, ...]]:
    """Mounting with which a georeferenced cloud was made, and messages about it.

    Clouds written by this program contain it in their header; for others the prior is assumed.

    Parameters
    ----------
    prior : Mounting
        Prior mounting of the project.
    """
    record = MountingRecord.read(line.path)
    if record is None:
        return prior, ()
    made, subject = record.mounting, Cause.of_line(line.name)
    roll, pitch, yaw = (float(angle) for angle in made.without_nominal_axes.boresight)
    found = [
        Message(
            "recovery.recorded_mounting", Level.NOTE,
            {"line": line.name, "roll": roll, "pitch": pitch, "yaw": yaw}, subject,
        )
    ]  # fmt: skip
    if record.is_trajectory_corrected:
        found.append(
            Message(
                "recovery.corrected_trajectory", Level.WARNING, {"line": line.name}, subject,
            )
        )  # fmt: skip
    off = made.lever_arm - prior.lever_arm
    if np.linalg.norm(off) > LEVER_ARM_TOLERANCE:
        x, y, z = (float(value) for value in made.lever_arm)
        found.append(
            Message(
                "recovery.other_lever_arm", Level.WARNING,
                {"line": line.name, "x": x, "y": y, "z": z, "off": float(np.linalg.norm(off))},
                subject,
            )
        )  # fmt: skip
    return made, tuple(found)


class LinePoints:
    """Reader of the usable points of a line in chunks; recovers scanner points from a cloud.

    Parameters
    ----------
    line : LineSource
    trajectory : LocalTrajectory
    mounting : Mounting
        Prior mounting; a georeferenced cloud is assumed to be made with it unless the file contains
        another one.
    attributes : sequence of str or None
        Attributes that are kept if the file has them; None for all.
    far_copies : bool
        See `PointScreen`.

    Raises
    ------
    InputError
        If an option does not belong to the format.
    """

    def __init__(
        self,
        line: LineSource,
        trajectory: LocalTrajectory,
        mounting: Mounting,
        *,
        attributes: Sequence[str] | None = None,
        far_copies: bool = False,
    ) -> None:
        self.line, self.trajectory = line, trajectory
        self._attributes, self._far_copies = attributes, far_copies
        self._latency = mounting.latency
        self._format, self._choice, assumptions = format_of_line(line)
        resolved = self._format.complete_options(self._choice)
        self._selection = PointSelection.of(resolved)
        system = crs_of_options(resolved, line.path)
        self.recovery: RecoverySetup | None = None
        self._recorded: tuple[Message, ...] = ()
        if system is not None:
            made, self._recorded = mounting_of_cloud(line, mounting)
            self.recovery = RecoverySetup(system, trajectory, made, line.path)
            self._latency = made.latency
            assumptions += self.recovery.assumptions
        self._assumptions = assumptions
        self._screen: PointScreen
        self._covered: list[TrajectoryCoverage] = []
        self._times: list[Array] = []
        self._samples: list[LineSample] = []
        self._without_pose = 0

    def pieces(self) -> Iterator[PointPiece]:
        """Read the points in file order; ``index`` is the index of each point in the file.

        Raises
        ------
        InputError
            If the file is missing or damaged, or has no usable points.
        DistantDuplicates
            At the end, if distant copies of points were found and are not excluded.
        """
        self._screen = PointScreen(
            self._selection, ranged=self.recovery is None, far_copies=self._far_copies
        )
        self._covered, self._times, self._samples, self._without_pose = [], [], [], 0
        read = used = 0
        for chunk in read_chunks(self._format.read(self.line.path, self._choice)):
            index = np.arange(read, read + len(chunk.time))
            read += len(chunk.time)
            piece = self._usable_piece(chunk, index, read)
            used += len(piece)
            yield piece
        if not used:
            raise InputError(self._no_points_message(read))
        times = np.concatenate(self._times)
        require_distinct_times(
            float(np.nanmin(times)), float(np.nanmax(times)), read, self.line.path
        )
        if not self._far_copies and self._screen.result().repeated > MAX_DISTANT_COPY_SHARE:
            raise DistantDuplicates

    @property
    def audit(self) -> LineAudit:
        """Audit of the points read so far; valid after the first of `pieces`."""
        return self._screen.result()

    @property
    def findings(self) -> "LineFindings":
        """Findings in the points; valid after they have been read."""
        return LineFindings(self.audit, self.recovery_messages)

    @property
    def recovery_messages(self) -> tuple[Message, ...]:
        """Messages about the recovery of a georeferenced line; none for other lines."""
        if self.recovery is None or not self._samples:
            return ()
        if has_several_scanners(self.audit):
            return self._recorded  # one mounting does not fit them; the audit reports this
        whole = LineSample.joined(self._samples)
        return (*self._recorded, *recovery_messages(self.line.name, whole, self.recovery))

    @property
    def assumptions(self) -> tuple[Message, ...]:
        """Assumptions of the reader, and a note on points without a pose."""
        if not self._without_pose:
            return self._assumptions
        excluded = exclusion_notes(
            join_coverages(self._covered), self._without_pose, printable(self.line.path.name)
        )
        times = np.concatenate(self._times) if self._times else np.zeros(0)
        advice = shift_gain_note(self.line, times[np.isfinite(times)], self.trajectory.time)
        return (*self._assumptions, *excluded, *(() if advice is None else (advice,)))

    # -- parts -------------------------------------------------------------------------------

    def _usable_piece(self, chunk: PointChunk, index: NDArray[np.int64], read: int) -> PointPiece:
        """Usable points of a chunk, in the LiDAR frame and the trajectory's time base."""
        if self.recovery is None:
            require_scanner_frame(chunk.xyz, self.line.path)
        time = self.line.reading.to_trajectory_time(chunk.time)
        used = self._screen(chunk.time, chunk.xyz, chunk.extra) & self._pose_mask(time)
        points = chunk.xyz if used.all() else chunk.xyz[used]
        if self.recovery is not None:
            self._keep_sample(points, time[used], used, chunk.extra)
            points = self.recovery.points_lidar(points, time[used])
            near = self._screen.screen_recovered(points)
            if not near.all():
                points = points[near]
                used[used] = near
        names = chunk.extra if self._attributes is None else self._attributes
        extra = {name: chunk.extra[name] for name in names if name in chunk.extra}
        if not used.all():
            extra = {name: values[used] for name, values in extra.items()}
            time, index = time[used], index[used]
        return PointPiece(points, time, index, extra, read, chunk.total)

    def _keep_sample(
        self, points_map: Array, time: Array, used: NDArray[np.bool_],
        attributes: Mapping[str, NDArray[Any]],
    ) -> None:  # fmt: skip
        """Keep some points of a georeferenced line, to check their recovery."""
        if len(self._samples) >= MAX_SAMPLED_CHUNKS:
            return
        step = slice(None, None, 1 + len(time) // SAMPLE_POINTS_PER_CHUNK)
        ring = ring_numbers(attributes)
        if ring is not None:
            ring = ring[used][step].copy()
        self._samples.append(LineSample(points_map[step].copy(), time[step].copy(), ring))

    def _pose_mask(self, time: Array) -> NDArray[np.bool_]:
        """Mask of the times (n,), in the trajectory's time base, with a pose; counts the others."""
        finite = time[np.isfinite(time)]
        # Copied, because a view would keep the whole chunk in memory.
        self._times.append(time[:: max(1, len(time) // TIMES_PER_CHUNK)].copy())
        self._times += [finite.min(keepdims=True), finite.max(keepdims=True)] if len(finite) else []
        posed = self.trajectory.covers(time)
        if self._latency:
            posed &= self.trajectory.covers(time + self._latency)
        self._covered.append(
            assess_coverage(finite, self.trajectory.time, self.trajectory.longest_gap)
        )
        self._without_pose += int(np.count_nonzero(~posed)) - (len(time) - len(finite))
        return posed

    def _no_points_message(self, read: int) -> Message:
        """Message with the reason why no point can be used."""
        path = self.line.path
        if not read:
            return error("import.no_points", file=str(path))
        audit = self.audit
        times = np.concatenate(self._times)
        times = times[np.isfinite(times)]
        if self._without_pose and len(times):
            return outside_trajectory_message(self.line.reading, times, self.trajectory.time, path)
        return error(
            "import.no_usable_point", file=str(path), count=read, not_finite=audit.not_finite,
            no_range=audit.no_range, too_far=audit.too_far, withheld=audit.withheld,
            not_selected=audit.of_classes + audit.not_selected,
        )  # fmt: skip


def read_chunks(chunks: Any) -> Iterator[PointChunk]:
    """Yield the chunks of points that the reader of a format returns."""
    assert isinstance(chunks, Iterator)
    yield from chunks


def read_line(
    line: LineSource, trajectory: LocalTrajectory, mounting: Mounting
) -> tuple[Scan, LineFindings]:
    """Read one line into memory in the LiDAR frame, with the findings in its points.

    Parameters
    ----------
    trajectory : LocalTrajectory
    mounting : Mounting
        Prior mounting, with which a georeferenced cloud is assumed to be made.

    Raises
    ------
    InputError
        If the file cannot be read.
    """
    for far_copies in (False, True):
        points = LinePoints(
            line, trajectory, mounting, attributes=("intensity",), far_copies=far_copies
        )
        try:
            pieces = list(points.pieces())
        except DistantDuplicates:
            continue
        break
    intensity = None
    if all("intensity" in piece.extra for piece in pieces):
        intensity = np.concatenate([piece.extra["intensity"] for piece in pieces]).astype(float)
    scan = Scan(
        np.concatenate([piece.points_lidar for piece in pieces]),
        np.concatenate([piece.time for piece in pieces]),
        intensity,
        points.assumptions,
    )
    return scan, points.findings


def screen_chunks(chunks: Iterator[PointChunk], choice: Choice, path: Path) -> Iterator[PointChunk]:
    """Chunks with only the selected points of a file, as stored in it.

    Raises
    ------
    InputError
        If an option of the selection is not valid.
    """
    ranged = crs_of_options(choice, path) is None
    screen = PointScreen(PointSelection.of(choice), ranged=ranged)

    for chunk in chunks:
        if ranged:
            require_scanner_frame(chunk.xyz, path)
        yield select_points(chunk, screen(chunk.time, chunk.xyz, chunk.extra))


def select_points(chunk: PointChunk, chosen: NDArray[np.bool_]) -> PointChunk:
    """Selected points of a chunk; attributes packed in a record remain packed.

    Parameters
    ----------
    chosen : ndarray of shape (n,), bool
    """
    if chosen.all():
        return chunk
    packed = getattr(chunk.extra, "rows", None)
    extra: Mapping[str, NDArray[Any]] = (
        packed(chosen)
        if packed is not None
        else {name: values[chosen] for name, values in chunk.extra.items()}
    )
    return replace(chunk, xyz=chunk.xyz[chosen], time=chunk.time[chosen], extra=extra)
