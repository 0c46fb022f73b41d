"""A stored line: its columns are memory-mapped arrays, which are read from disk when accessed."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError, system_reason
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress
from lispac.survey.store.column_files import file_checksum, map_column
from lispac.survey.store.file_times import replace_manifest, with_file_times
from lispac.survey.store.import_lock import is_import_running
from lispac.survey.store.layout import (
    SPOOL_FOLDER,
    Manifest,
    StoredColumn,
    import_again_message,
    read_manifest,
    require_file_sizes,
)
from lispac.survey.store.original_file import is_original_unchanged
from lispac.survey.store.point_blocks import Place
from lispac.survey.store.row_runs import (
    Runs,
    gather_values,
    row_runs,
    rows_of_runs,
    select_within_sphere,
    split_runs,
)
from lispac.survey.store.spatial_cells import (
    MAX_HALVINGS,
    Keys,
    is_octave_in_sample,
    octave_runs_in_sphere,
)

Array = NDArray[np.float64]

MAX_CANDIDATE_RATIO = 4
"""Largest ratio of the points in the cells around a sphere to the limit of points in the sphere.
Above it, the sphere is assumed to have more points than the limit."""
PLACED_POINTS_PER_STEP = 1 << 16
"""Largest number of points that are georeferenced at once. The arrays of so many points are reused
from the memory of the process; larger ones are new pages, which take a fifth of the time."""
MAX_LOCAL_COORDINATE_M = 1e8
"""Largest possible coordinate in a local frame."""
RANGE_TOLERANCE_M = 1e-6
"""Tolerance of the check of coordinates against the largest range, for ranges near zero."""
MAX_ROUNDING_SHARE = 2.0**-23
"""Largest displacement of a point by rounding its coordinates to 32 bits after the points were
sorted, as a share of its range."""


@dataclass(frozen=True, eq=False)
class LineSample:
    """Uniform random sample of a line, which is displayed before the line itself is read.

    Attributes
    ----------
    rows : ndarray of shape (n,)
        Rows of the points in the line, increasing.
    points_local : ndarray of shape (n, 3), metres, local frame
        Georeferenced with the mounting that was used at the import.
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    time : ndarray of shape (n,), seconds
    intensity : ndarray of shape (n,) or None
    """

    rows: NDArray[Any]
    points_local: Array
    points_lidar: NDArray[np.float32]
    time: Array
    intensity: NDArray[Any] | None


CHECKED_POINTS_PER_STEP = 1_000_000
"""Number of points whose values are checked at once."""


@dataclass(frozen=True, eq=False)
class StoredLine:
    """One line on disk, with the interface of `lispac.survey.scan.Scan`.

    Rows are in spatial order. `numbers` converts them to numbers in the order of the file, by which
    picked points are stored, and `rows` converts numbers to rows.

    Attributes
    ----------
    folder : Path
    manifest : Manifest
    """

    folder: Path
    manifest: Manifest

    def __len__(self) -> int:
        return self.manifest.points

    @property
    def name(self) -> str:
        """Name of the line."""
        return self.manifest.line

    @property
    def fingerprint(self) -> str:
        """Fingerprint of the points in the order of the file; picks are stored with it."""
        return self.manifest.fingerprint

    @cached_property
    def points_lidar(self) -> NDArray[np.float32]:
        """All points, shape (n, 3), metres, LiDAR frame."""
        return self._stored_column("xyz")

    @cached_property
    def time(self) -> Array:
        """Times, shape (n,), seconds, in the trajectory's time base."""
        return self._stored_column("time")

    @cached_property
    def extra(self) -> Mapping[str, NDArray[Any]]:
        """Attributes of the file under its own names, shape (n, ...) each."""
        return {c.name: self._mapped_column(c, len(self)) for c in self.manifest.attributes}

    @property
    def intensity(self) -> NDArray[Any] | None:
        """Intensities in the file's own type, shape (n,), if it has any."""
        return self.extra.get("intensity")

    @cached_property
    def coarse(self) -> LineSample:
        """Uniform random sample of at most a million points of the line."""
        intensity = None
        if "coarse_intensity" in self._columns:
            intensity = self._stored_column("coarse_intensity")
        elif self.intensity is not None:  # the same for all points
            intensity = self.intensity[: len(self._stored_column("coarse_row"))]
        rows, xyz, time = (self._stored_column(f"coarse_{name}") for name in ("row", "xyz", "time"))
        self._require_points(xyz, time)
        self._require_numbers_below(rows, len(self))
        local = self._stored_column("coarse_local")
        # The extent of the trajectory is not known here: only impossible coordinates are refused.
        if not np.isfinite(local).all() or (np.abs(local) > MAX_LOCAL_COORDINATE_M).any():
            raise self._damage_error()
        return LineSample(rows, local, xyz, time, intensity)

    def numbers(self, rows: NDArray[Any]) -> NDArray[np.int64]:
        """Numbers, shape (n,), in the order of the file, of the points in ``rows``, shape (n,)."""
        return self._values_at("number", rows)

    def rows(self, numbers: NDArray[Any]) -> NDArray[np.int64]:
        """Rows, shape (n,), of the points with the given numbers; the inverse of `numbers`."""
        return self._values_at("row", numbers)

    def _values_at(self, name: str, at: NDArray[Any]) -> NDArray[np.int64]:
        """Values of the column ``number`` or ``row`` at the given indices.

        Raises
        ------
        ProjectError
            If an index or a value is not that of a point of this line.
        """
        column = self._stored_column(name)
        self._require_numbers_below(at, len(column))
        found = column[at].astype(np.int64)
        self._require_numbers_below(found, len(self))
        return np.asarray(found)

    def _require_numbers_below(self, rows: NDArray[Any], count: int) -> None:
        if len(rows) and not (rows.min() >= 0 and rows.max() < count):
            raise self._damage_error()

    def _require_points(self, points_lidar: NDArray[Any], time: NDArray[Any]) -> None:
        """Refuse coordinates above the largest range of the manifest, and times outside its limits.

        Raises
        ------
        ProjectError
            If a coordinate or a time is outside the limits of the manifest.
        """
        if not len(time):
            return
        limit = self.manifest.reach * (1 + MAX_ROUNDING_SHARE) + RANGE_TOLERANCE_M
        early, late = self.manifest.first_time, self.manifest.last_time
        if not (np.abs(points_lidar).max() <= limit and early <= time.min() <= time.max() <= late):
            raise self._damage_error()

    def _damage_error(self) -> ProjectError:
        return ProjectError(import_again_message(error("store.values", line=self.name)))

    def indices_in_file(self, rows: NDArray[Any]) -> NDArray[np.int64]:
        """Indices in the imported file of ``rows``, both (n,); excluded points are counted."""
        numbers = self.numbers(rows)
        if "before" in self._columns:
            numbers += self._stored_column("before")[rows]
        return numbers

    @property
    def reach(self) -> float:
        """Distance of the farthest point from the scanner, metres."""
        return self.manifest.reach

    @property
    def first_time(self) -> float:
        """Seconds, in the trajectory's time base."""
        return self.manifest.first_time

    @property
    def last_time(self) -> float:
        """Seconds, in the trajectory's time base."""
        return self.manifest.last_time

    def take(self, numbers: NDArray[Any]) -> tuple[Array, Array]:
        """Points, shape (n, 3), metres, LiDAR frame, and times, shape (n,), by their `numbers`."""
        rows = self.rows(numbers)
        points, time = self.points_lidar[rows], np.asarray(self.time[rows])
        self._require_points(points, time)
        return points.astype(np.float64), time

    def intensities(self, numbers: NDArray[Any]) -> Array | None:
        """Intensities, shape (n,), by their `numbers`, if there are any."""
        if self.intensity is None:
            return None
        return self.intensity[self.rows(numbers)].astype(np.float64)

    def near(self, centre: Array, radius: float, *, margin: float = 0.0, halvings: int = 0) -> Runs:
        """Runs of rows with all points within a sphere, and further points around it.

        Parameters
        ----------
        centre : ndarray of shape (3,), metres, local frame
        radius : float, metres
        margin : float, metres
            Largest displacement of a point since the import, for example by another boresight.
        halvings : int
            1 for a uniform random sample of half of the points, 2 for a quarter, and so on.

        Returns
        -------
        ndarray of shape (k, 2)
            See `Runs`.
        """
        centre = np.asarray(centre, dtype=np.float64)
        reach = radius + margin + MAX_ROUNDING_SHARE * self.manifest.reach
        found = octave_runs_in_sphere(self._octaves, self.manifest.side, centre, float(reach))
        if halvings:
            every = rows_of_runs(found)
            every = every[is_octave_in_sample(self._octaves[every], halvings)]
            found = np.column_stack([every, every + 1])
        return row_runs(self._starts, found)

    def within(
        self,
        centre: Array,
        radius: float,
        place: Place,
        *,
        margin: float = 0.0,
    ) -> tuple[NDArray[np.int64], Array]:
        """All points within a sphere, georeferenced again.

        Parameters
        ----------
        place : callable
            Georeferences points.
        centre, radius, margin
            See `near`.

        Returns
        -------
        rows : ndarray of shape (n,), increasing
        points_local : ndarray of shape (n, 3), metres, local frame
        """
        rows, inside, _ = self.sampled_within(centre, radius, place, margin=margin)
        return rows, inside

    def sampled_within(
        self,
        centre: Array,
        radius: float,
        place: Place,
        *,
        margin: float = 0.0,
        limit: int | None = None,
    ) -> tuple[NDArray[np.int64], Array, int]:
        """Points as `within`, but a uniform random sample if there are more than ``limit``.

        Returns
        -------
        rows : ndarray of shape (n,), increasing
        points_local : ndarray of shape (n, 3), metres, local frame
        halvings : int
            Smallest number of halvings with at most ``limit`` points; 0 if all points are included.
        """
        halvings = 0
        while limit and halvings < MAX_HALVINGS:
            runs = self.near(centre, radius, margin=margin, halvings=halvings)
            if (runs[:, 1] - runs[:, 0]).sum() <= MAX_CANDIDATE_RATIO * limit:
                break
            halvings += 1
        rows, points = self._placed_within(centre, radius, place, margin, halvings)
        if limit is None:
            return rows, points, halvings
        if len(rows) > limit:
            octave = np.searchsorted(self._starts, rows.astype(np.uint64), side="right") - 1
            octaves = self._octaves[octave]
            while len(rows) > limit and halvings < MAX_HALVINGS:
                halvings += 1
                kept = is_octave_in_sample(octaves, halvings)
                rows, points, octaves = rows[kept], points[kept], octaves[kept]
            return rows, points, halvings
        while halvings > 0:
            finer = self._placed_within(centre, radius, place, margin, halvings - 1)
            if len(finer[0]) > limit:
                break
            (rows, points), halvings = finer, halvings - 1
        return rows, points, halvings

    def _placed_within(
        self, centre: Array, radius: float, place: Place, margin: float, halvings: int
    ) -> tuple[NDArray[np.int64], Array]:
        """Points of a sample, with the given number of halvings, within a sphere."""
        middle = np.asarray(centre, dtype=np.float64)
        found = [(np.zeros(0, np.int64), np.zeros((0, 3)))]
        for group in split_runs(
            self.near(centre, radius, margin=margin, halvings=halvings), PLACED_POINTS_PER_STEP
        ):
            points, time = (
                gather_values(values, group) for values in (self.points_lidar, self.time)
            )
            self._require_points(points, time)
            placed = place(points.astype(np.float64), time)
            found.append(select_within_sphere(placed, group, middle, float(radius)))
        rows = np.concatenate([rows for rows, _ in found])
        return rows, np.concatenate([points for _, points in found])

    def require_sound(self, progress: Callable[[float], None] = lambda done: None) -> None:
        """Read the whole store, compare the checksums, and check the values of all points.

        Raises
        ------
        ProjectError
            If a file is missing or damaged, or contains invalid points.
        """
        done = 0
        for column in self.manifest.files:
            path = self.folder / self.manifest.folder / column.file
            try:
                _require_checksum(path, column.checksum)
            except ProjectError as failure:
                raise self.reimport_error_or(failure) from failure
            done += column.size
            progress(done / self.manifest.bytes)
        for first in range(0, len(self), CHECKED_POINTS_PER_STEP):
            rows = slice(first, first + CHECKED_POINTS_PER_STEP)
            self._require_points(self.points_lidar[rows], self.time[rows])

    def is_source_unchanged(self, path: Path) -> bool:
        """Whether the file at ``path`` is the imported one, unchanged (`OSError` if unreadable)."""
        return is_original_unchanged(self.manifest.original, path)

    @cached_property
    def _columns(self) -> Mapping[str, Any]:
        return {column.name: column for column in self.manifest.columns}

    def _stored_column(self, name: str) -> NDArray[Any]:
        column = self._columns[name]
        return self._mapped_column(column, column.count)

    def _mapped_column(self, column: StoredColumn, count: int) -> NDArray[Any]:
        try:
            return map_column(self.folder / self.manifest.folder, column, count)
        except ProjectError as failure:
            raise self.reimport_error_or(failure) from failure

    def reimport_error_or(self, failure: ProjectError) -> ProjectError:
        """Error that the line was imported again after it was opened; ``failure`` if it was not."""
        if _is_manifest_current(self.folder, self.manifest):
            return failure
        return ProjectError(error("store.imported_again", line=self.name))

    @cached_property
    def _octaves(self) -> Keys:
        octaves = np.array(self._stored_column("octaves"))
        if (octaves[1:] <= octaves[:-1]).any():
            raise self._damage_error()
        return octaves

    @cached_property
    def _starts(self) -> Keys:
        starts = np.array(self._stored_column("starts"))
        sound = len(starts) == len(self._octaves) + 1 and starts[0] == 0
        if not sound or starts[-1] != len(self) or (starts[1:] <= starts[:-1]).any():
            raise self._damage_error()
        return starts


def open_store(folder: Path, line: str, *, progress: Progress = no_progress) -> StoredLine:
    """Open an imported line and check its manifest, its order, and its file sizes and times.

    If a file was written after the import, or the store was copied, the whole store is read and
    compared with its checksums.

    Raises
    ------
    ProjectError
        If the line is not imported, its import was interrupted, or it is damaged.
    FileNotFoundError
        If a file is removed during the check.
    """
    manifest = read_manifest(folder)
    if manifest is None:
        if is_import_running(folder):
            raise ProjectError(error("store.being_imported", line=line))
        if (folder / SPOOL_FOLDER).is_dir():
            raise ProjectError(error("store.interrupted", line=line))
        raise ProjectError(error("store.not_imported", line=line))
    if manifest.line != line:
        other = error("store.other_line", folder=str(folder), found=manifest.line, line=line)
        raise ProjectError(import_again_message(other))
    stored = StoredLine(folder, manifest)
    try:
        require_file_sizes(folder, manifest)
        for column in manifest.columns:
            if column.name in ("octaves", "starts"):
                _require_checksum(folder / manifest.folder / column.file, column.checksum)
        now = with_file_times(folder, manifest)
        if now != manifest:
            stored.require_sound(
                lambda done: progress(done, gettext_lazy("Checking {line}", line=line))
            )
            replace_manifest(folder, manifest, now)
    except (ProjectError, FileNotFoundError):
        if not _is_manifest_current(folder, manifest):  # imported again between the two checks
            return open_store(folder, line, progress=progress)
        raise
    return stored


def _is_manifest_current(folder: Path, manifest: Manifest) -> bool:
    """Whether the manifest on disk names the same columns as one read earlier, or is missing."""
    try:
        now = read_manifest(folder)
    except ProjectError:
        return True
    return now is None or now.folder == manifest.folder


def _require_checksum(path: Path, checksum: int) -> None:
    try:
        sound = file_checksum(path) == checksum
    except OSError as failure:
        reason = system_reason(failure)
        raise ProjectError(
            error("store.part_not_readable", file=str(path), reason=reason)
        ) from failure
    if not sound:
        raise ProjectError(import_again_message(error("store.part_changed", file=str(path))))
