"""Writing of georeferenced lines as LAS or LAZ in chunks, with all attributes.

Reading, georeferencing and writing run in parallel; only a few chunks are in memory, whatever the
length of the line.
"""

import os
from collections import deque
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import closing
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.format_types import PointChunk
from lispac.io.las.las_export import CloudWriter, RecordLayout, open_cloud_writer
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import PointRate, Progress, no_progress
from lispac.survey.line_source import DEFAULT_READING, Reading, printable
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.point_screening import MAX_RANGE_M, is_within_range
from lispac.survey.scanner_frame_recovery import RecoverySetup

if TYPE_CHECKING:
    from laspy import ScaleAwarePointRecord

Array = NDArray[np.float64]

MAX_WAITING_CHUNKS = 3
"""Largest number of chunks that are read and not yet written."""


@dataclass(frozen=True)
class WrittenLine:
    """Result of writing a line as a cloud.

    Attributes
    ----------
    path : Path
    points : int
        Number of points written.
    outside, in_gaps : int
        Number of points excluded because they have no pose: outside the time span of the
        trajectory, or in a gap (or at attitudes too steep to be interpolated).
    excluded : int
        Number of points excluded because they are beyond the range of the scanner or at its origin.
    messages : tuple of Message
        Notes on data of the source that are not kept, and assumptions.
    """

    path: Path
    points: int
    outside: int = 0
    in_gaps: int = 0
    excluded: int = 0
    messages: tuple[Message, ...] = ()

    @property
    def notes(self) -> tuple[Message, ...]:
        """Notes on excluded points, and the messages."""
        found, file = [], printable(self.path.name)
        total = self.points + self.outside + self.in_gaps
        if self.outside:
            found.append(
                note("import.excluded_outside", file=file, count=self.outside, total=total)
            )
        if self.in_gaps:
            found.append(
                note("export.excluded_in_gaps", file=file, count=self.in_gaps, total=total)
            )
        return (*found, *self.messages)


@dataclass(frozen=True, eq=False)
class _GeoreferencedChunk:
    """Records of a chunk for the writer, and numbers of excluded points as in `WrittenLine`."""

    records: "ScaleAwarePointRecord"
    outside: int
    in_gaps: int
    excluded: int


def write_cloud(
    chunks: Iterable[PointChunk],
    temporary: Path,
    path: Path,
    mapping: ScannerPointConverter,
    pattern: Callable[[PointChunk], RecordLayout],
    *,
    reading: Reading = DEFAULT_READING,
    recovery: RecoverySetup | None = None,
    max_range: float = MAX_RANGE_M,
    compressed: bool = True,
    is_trajectory_corrected: bool = False,
    progress: Progress = no_progress,
) -> WrittenLine:
    """Georeference the chunks of one line and write them.

    Parameters
    ----------
    chunks : iterable of PointChunk
        Chunks in the LiDAR frame, from a file or a store, with the times of the source.
    temporary, path : Path
        File that is written, and the final name.
    mapping : ScannerPointConverter
        Converter to the selected coordinate system, with the selected mounting.
    pattern : callable
        Function of the first chunk that returns the layout of the records.
    reading : Reading
        Reading options, which convert the times of the source to the time base of the trajectory;
        the times of the source are written.
    recovery : RecoverySetup, optional
        Georeferencing with which the chunks were made, if they are not in the LiDAR frame.
    max_range : float, metres
        Largest distance from the scanner of points recovered from a georeferenced cloud.
    is_trajectory_corrected : bool
        Whether the trajectory of ``mapping`` is the corrected one; stored in the file.

    Raises
    ------
    InputError
        If no point has a pose, a point lies outside the coordinate system, or the file cannot
        be written.
    """
    source = iter(chunks)
    first = next(source, None)
    if first is None:
        raise InputError(error("export.no_points", line=path.stem))
    chosen, total = pattern(first), first.total
    source = chain((first,), source)
    del first  # so that it is not kept in memory
    place = _ChunkGeoreferencer(mapping, reading, recovery, max_range)
    pace = PointRate(gettext_lazy("Writing {file}", file=path.name), total)
    outside = in_gaps = excluded = 0
    with (
        open_cloud_writer(
            temporary,
            chosen,
            mapping.system,
            mapping.centre,
            mounting=mapping.mounting,
            frame=mapping.trajectory.frame,
            compressed=compressed,
            shown=path,
            is_trajectory_corrected=is_trajectory_corrected,
        ) as cloud,
        closing(_write_chunks(source, cloud, place)) as written,
    ):
        for done in written:
            outside, in_gaps = outside + done.outside, in_gaps + done.in_gaps
            excluded += done.excluded
            count = cloud.count + outside + in_gaps + excluded
            # A text file does not specify its number of points.
            progress(min(count / total, 1.0) if total else 0.5, pace.step(count))
        count = cloud.count
    if not count:
        known = mapping.trajectory.time
        raise InputError(
            error(
                "export.outside_trajectory",
                line=path.stem,
                count=outside + in_gaps,
                start=float(known[0]),
                end=float(known[-1]),
            )
        )
    return WrittenLine(path, count, outside, in_gaps, excluded, chosen.notes)


def _write_chunks(
    chunks: Iterable[PointChunk], cloud: CloudWriter, place: "_ChunkGeoreferencer"
) -> Generator[_GeoreferencedChunk]:
    """Georeference and write chunks in parallel; yield each of them when it is written."""
    workers = ThreadPoolExecutor(os.cpu_count(), "place")
    writer = ThreadPoolExecutor(1, "write")
    waiting: deque[Future[_GeoreferencedChunk]] = deque()
    try:
        for chunk in chunks:
            placed = workers.submit(place, cloud, chunk)
            waiting.append(writer.submit(_write_records, cloud, placed))
            if len(waiting) > MAX_WAITING_CHUNKS:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()
    finally:
        # Running tasks finish before the file is closed; waiting tasks are cancelled.
        workers.shutdown(cancel_futures=True)
        writer.shutdown(cancel_futures=True)


def _write_records(
    cloud: CloudWriter, placed: "Future[_GeoreferencedChunk]"
) -> _GeoreferencedChunk:
    done = placed.result()
    if len(done.records):
        cloud.write(done.records)
    return done


@dataclass(frozen=True, eq=False)
class _ChunkGeoreferencer:
    """Function that georeferences a chunk in a worker thread."""

    mapping: ScannerPointConverter
    reading: Reading
    recovery: RecoverySetup | None
    max_range: float

    def __call__(self, cloud: CloudWriter, chunk: PointChunk) -> _GeoreferencedChunk:
        moved = self.reading.to_trajectory_time(chunk.time)
        trajectory, latency = self.mapping.trajectory, self.mapping.mounting.latency
        usable = trajectory.covers(moved + latency)
        if self.recovery is not None:
            usable &= self.recovery.has_pose(moved)
        lost = len(usable) - int(np.count_nonzero(usable))
        outside = excluded = 0
        if lost:
            first, last = trajectory.time[[0, -1]] - latency
            outside = min(lost, int(np.count_nonzero(~((moved >= first) & (moved <= last)))))
        xyz, stamps, chosen = chunk.xyz, chunk.time, None
        if lost:
            xyz, stamps, moved, chosen = xyz[usable], stamps[usable], moved[usable], usable
        if self.recovery is not None:
            xyz = self.recovery.points_lidar(xyz, moved, threads=1)
            near = is_within_range(xyz, self.max_range)
            if not near.all():
                xyz, stamps, moved = xyz[near], stamps[near], moved[near]
                excluded = int(np.count_nonzero(~near))
                usable[usable] = near
                chosen = usable
        points = self.mapping.to_map(xyz, moved, threads=1)
        records = cloud.records(points, stamps, chunk.extra, chosen)
        return _GeoreferencedChunk(records, outside, lost - outside, excluded)
