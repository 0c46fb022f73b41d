"""Import of a line: blocks are read and spooled, then written in spatial order, then the manifest.

Only a few blocks are in memory at any time. If the import is interrupted, the folder contains
either the previous store, the new one, or none. The next import of the same file reuses blocks that
are complete.
"""

from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from lispac.errors import LispacError, ProjectError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import PointRate, Progress, no_progress, sub_progress
from lispac.survey.store.column_writer import write_columns
from lispac.survey.store.file_times import with_file_times
from lispac.survey.store.import_lock import LOCK_FILE, lock_folder
from lispac.survey.store.layout import (
    COLUMNS_PREFIX,
    MANIFEST_FILE,
    SPOOL_FOLDER,
    DamagedStore,
    Manifest,
    SourceFile,
    StoredColumn,
    columns_folders,
    is_link,
    read_manifest,
    remove_columns,
    remove_leftovers,
    require_no_link,
    write_manifest,
    writing_errors_as_project_errors,
)
from lispac.survey.store.point_blocks import Place, PointPiece, gather_blocks
from lispac.survey.store.read_ahead import read_ahead
from lispac.survey.store.spool import Spool, SpoolSummary, remove_spool
from lispac.value_conversion import encode_value

READING_PROGRESS_SHARE = 0.6
"""Share of the reading of the file in the progress of an import."""
BYTES_PER_POINT = 100
"""Disk space of a LAS point with all its attributes during the import, in the block and in the
columns together."""

Pieces = Callable[[int], Iterator[PointPiece]]
"""Function that yields the points of a file from an index on."""
Findings = Callable[[], tuple[tuple[dict[str, Any], ...], dict[str, Any]]]
"""Function that returns the assumptions and the audit as plain values, after a file was read."""


@dataclass(frozen=True)
class ImportRecipe:
    """All inputs that determine a stored line.

    Attributes
    ----------
    line : str
        Name of the line.
    original : SourceFile
        The imported file.
    made_with, placed_with : dict of plain values
        See `Manifest`.
    """

    line: str
    original: SourceFile
    made_with: dict[str, Any]
    placed_with: dict[str, Any]


def write_store(
    folder: Path,
    recipe: ImportRecipe,
    pieces: Pieces,
    place: Place,
    findings: Findings = lambda: ((), {}),
    *,
    beside: Callable[[Path], None] = lambda folder: None,
    progress: Progress = no_progress,
) -> Manifest:
    """Import a line into its folder; an earlier import is kept until this one is complete.

    Parameters
    ----------
    folder : Path
        Folder of the line.
    pieces : callable
        Yields the points of the file from an index on. It has to yield the same points each time.
    place : callable
        Georeferences points, for the spatial order.
    findings : callable
        Returns, after the file was read, the assumptions of the reader and the audit of the points,
        as plain values.
    beside : callable
        Writes further files into the folder of the columns.

    Raises
    ------
    ProjectError
        If the folder cannot be written, the disk is full, or another import of the line runs.
    InputError
        If the file cannot be read.
    LispacError
        Errors of ``pieces``, ``place`` and ``beside``.
    """
    require_no_link(folder.parent, folder, folder / SPOOL_FOLDER)
    new_folders = _missing_folders(folder)
    try:
        with writing_errors_as_project_errors(folder):
            folder.mkdir(parents=True, exist_ok=True)
            require_no_link(*columns_folders(folder))
            with lock_folder(folder):
                current = _current_columns_folder(folder)
                remove_leftovers(folder, keep=current)
                return _import_line(
                    folder, recipe, pieces, place, findings, beside, current, progress
                )
    except LispacError:
        _remove_empty_folders(new_folders)
        raise


def _import_line(
    folder: Path,
    recipe: ImportRecipe,
    pieces: Pieces,
    place: Place,
    findings: Findings,
    beside: Callable[[Path], None],
    current: str,
    progress: Progress,
) -> Manifest:
    spool: Spool | None = None
    new: Path | None = None
    expected = _ExpectedSize()
    try:
        with writing_errors_as_project_errors(folder, expected.bytes):
            spool = Spool(folder, encode_value(recipe))
            reading = sub_progress(progress, 0.0, READING_PROGRESS_SHARE)
            end = _fill_spool(spool, recipe, pieces, place, findings, expected, reading)
            new = _make_columns_folder(folder, current)
            own, attributes = write_columns(
                spool,
                new,
                place,
                recipe.line,
                progress=sub_progress(progress, READING_PROGRESS_SHARE, 1.0),
            )
            manifest = _build_manifest(spool, recipe, new.name, own, attributes, end)
            beside(new)
            manifest = with_file_times(folder, manifest)
            write_manifest(folder, manifest)
    except BaseException as failure:
        # If the manifest was written before the failure, the line is imported.
        if new is not None and _current_columns_folder(folder) != new.name:
            remove_columns(new)
        # Blocks are kept for the next import only after an interruption, not after an error.
        if spool is not None and isinstance(failure, LispacError):
            spool.remove()
        raise
    spool.remove()
    remove_leftovers(folder, keep=new.name)
    return manifest


def _make_columns_folder(folder: Path, current: str) -> Path:
    """Make the folder of new columns, with the next unused number."""
    number = int(current.removeprefix(COLUMNS_PREFIX) or 0) + 1
    while True:
        new = folder / f"{COLUMNS_PREFIX}{number}"
        try:
            new.mkdir()
        except FileExistsError:
            number += 1
        else:
            return new


def _build_manifest(
    spool: Spool,
    recipe: ImportRecipe,
    folder: str,
    stored_columns: tuple[StoredColumn, ...],
    attributes: tuple[StoredColumn, ...],
    end: SpoolSummary,
) -> Manifest:
    blocks = spool.blocks
    low = np.min([block.low for block in blocks], axis=0).tolist()
    high = np.max([block.high for block in blocks], axis=0).tolist()
    return Manifest(
        line=recipe.line,
        points=spool.points,
        excluded_points=end.read - spool.points,
        folder=folder,
        columns=stored_columns,
        attributes=attributes,
        side=blocks[0].side,
        low=(low[0], low[1], low[2]),
        high=(high[0], high[1], high[2]),
        first_time=min(block.times[0] for block in blocks),
        last_time=max(block.times[1] for block in blocks),
        reach=max(block.reach for block in blocks),
        fingerprint=spool.running.fingerprint,
        original=recipe.original,
        made_with=recipe.made_with,
        placed_with=recipe.placed_with,
        assumptions=end.assumptions,
        audit=end.audit,
    )


def _fill_spool(
    spool: Spool,
    recipe: ImportRecipe,
    pieces: Pieces,
    place: Place,
    findings: Findings,
    expected: "_ExpectedSize",
    progress: Progress,
) -> SpoolSummary:
    """Spool the points that are not spooled yet, and return the summary of the whole file.

    Raises
    ------
    ProjectError
        If the file has no points.
    """
    known = spool.read_end
    if known is not None:
        return known
    read, pace = spool.next_index, None
    source = pieces(spool.next_index)
    gathered = gather_blocks(source, spool.points, spool.running, recipe.original.path)
    with closing(read_ahead(gathered)) as ahead:
        for block, piece in ahead:
            if pace is None:
                pace = PointRate(
                    gettext_lazy("Reading {line}", line=recipe.line), piece.total, spool.next_index
                )
                expected.points = piece.total
            read = piece.read
            progress(read / piece.total if piece.total else 0.0, pace.step(read))
            if block is not None:
                spool.add(block, place)
    if not spool.points:
        raise ProjectError(error("store.no_points", file=recipe.original.path))
    assumptions, audit = findings()
    end = SpoolSummary(read, assumptions, audit)
    spool.mark_complete(end)
    return end


def remove_incomplete_parts(folder: Path, manifest: Manifest) -> None:
    """Remove incomplete parts of a store unless the line is being imported."""
    parts = {MANIFEST_FILE, LOCK_FILE, manifest.folder}
    if is_link(folder.parent) or is_link(folder):
        return
    try:
        if all(path.name in parts for path in folder.iterdir()):
            return
        with lock_folder(folder):
            remove_leftovers(folder, keep=manifest.folder)
            remove_spool(folder)
    except (OSError, ProjectError):
        return  # the folder may be read-only


class _ExpectedSize:
    """Expected disk space of an import, after the number of points is known."""

    points: int | None = None

    def bytes(self) -> int | None:
        """Expected bytes; None if the number of points is unknown."""
        return None if self.points is None else self.points * BYTES_PER_POINT


def _current_columns_folder(folder: Path) -> str:
    """Name of the folder of valid columns, empty if none; a damaged manifest is removed."""
    try:
        manifest = read_manifest(folder)
    except DamagedStore:
        (folder / MANIFEST_FILE).unlink(missing_ok=True)
        return ""
    return "" if manifest is None else manifest.folder


def _missing_folders(folder: Path) -> list[Path]:
    """The folder and its parent folder, as far as they do not exist yet."""
    return [path for path in (folder, folder.parent) if not path.exists()]


def _remove_empty_folders(folders: list[Path]) -> None:
    for path in folders:
        try:
            path.rmdir()
        except OSError:  # it is not empty, or was never made
            return
