"""Importing a line: read and spooled block by block, then written in order, then declared.

At no time is more in memory than a few blocks. Whatever interrupts the work, the folder holds
either the store that was there before, or the new one, or none; blocks that are complete are used
again by the next import of the same file.
"""

from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from lispac.errors import LispacError, ProjectError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Pace, Progress, no_progress, part
from lispac.survey.store.ahead import read_ahead
from lispac.survey.store.layout import (
    COLUMNS,
    MANIFEST,
    SPOOL,
    Column,
    DamagedStore,
    Manifest,
    SourceFile,
    columns_folders,
    is_link,
    plainly_written,
    read_manifest,
    remove_columns,
    remove_leftovers,
    require_no_link,
    write_manifest,
)
from lispac.survey.store.lock import LOCK, locked
from lispac.survey.store.ordering import write_columns
from lispac.survey.store.pieces import Piece, Place, blocks_of
from lispac.survey.store.spool import Spool, SpoolSummary, remove_spool
from lispac.survey.store.stamps import stamped

READING_SHARE = 0.6
"""Part of the time that reading takes, for the progress."""
BYTES_PER_POINT = 100
"""Bytes of an imported LAS point with all its attributes: block and columns together."""

Pieces = Callable[[int], Iterator[Piece]]
"""Gives the points of a file from an index on."""
Findings = Callable[[], tuple[tuple[dict[str, Any], ...], dict[str, Any]]]
"""Gives the assumptions and the audit as plain values, once a file is read."""


@dataclass(frozen=True)
class Recipe:
    """All that a stored line follows from.

    Attributes
    ----------
    line : str
        Name of the line.
    original : SourceFile
        The file.
    made_with, placed_with : dict of plain values
        See `Manifest`.
    """

    line: str
    original: SourceFile
    made_with: dict[str, Any]
    placed_with: dict[str, Any]


def write_store(
    folder: Path,
    recipe: Recipe,
    pieces: Pieces,
    place: Place,
    findings: Findings = lambda: ((), {}),
    *,
    beside: Callable[[Path], None] = lambda folder: None,
    progress: Progress = no_progress,
) -> Manifest:
    """Import a line into its folder; an earlier import of it stays until this one is complete.

    Parameters
    ----------
    folder : Path
        Of the line.
    pieces : callable
        Gives the points of the file from an index on. It has to give the same points every time.
    place : callable
        Puts points into the local frame for the order in space.
    findings : callable
        Gives, once the file is read, what was assumptions, in words, and the audit of its
        points, as plain values.
    beside : callable
        Puts into the folder of the columns what is to be kept besides them.

    Raises
    ------
    ProjectError
        Where the folder cannot be written, the disk is full, or another import of the line runs.
    InputError
        Where the file cannot be read.
    LispacError
        What ``pieces``, ``place`` and ``beside`` raise.
    """
    require_no_link(folder.parent, folder, folder / SPOOL)
    made = _made_folders(folder)
    try:
        with plainly_written(folder):
            folder.mkdir(parents=True, exist_ok=True)
            require_no_link(*columns_folders(folder))
            with locked(folder):
                current = _current(folder)
                remove_leftovers(folder, keep=current)
                return _import(folder, recipe, pieces, place, findings, beside, current, progress)
    except LispacError:
        _remove_empty(made)
        raise


def _import(
    folder: Path,
    recipe: Recipe,
    pieces: Pieces,
    place: Place,
    findings: Findings,
    beside: Callable[[Path], None],
    current: str,
    progress: Progress,
) -> Manifest:
    spool: Spool | None = None
    new: Path | None = None
    expected = _Expected()
    try:
        with plainly_written(folder, expected.bytes):
            spool = Spool(folder, asdict(recipe))
            reading = part(progress, 0.0, READING_SHARE)
            end = _fill(spool, recipe, pieces, place, findings, expected, reading)
            new = _new_columns(folder, current)
            own, attributes = write_columns(
                spool, new, place, recipe.line, progress=part(progress, READING_SHARE, 1.0)
            )
            manifest = _manifest(spool, recipe, new.name, own, attributes, end)
            beside(new)
            manifest = stamped(folder, manifest)
            write_manifest(folder, manifest)
    except BaseException as failure:
        # Where it stopped after the manifest, the line is imported
        if new is not None and _current(folder) != new.name:
            remove_columns(new)
        # A file that cannot be read and a disk that is full get nothing from a half kept for later.
        if spool is not None and isinstance(failure, LispacError):
            spool.remove()
        raise
    spool.remove()
    remove_leftovers(folder, keep=new.name)
    return manifest


def _new_columns(folder: Path, current: str) -> Path:
    """Make the folder of new columns, with the next number that nothing there has."""
    number = int(current.removeprefix(COLUMNS) or 0) + 1
    while True:
        new = folder / f"{COLUMNS}{number}"
        try:
            new.mkdir()
        except FileExistsError:
            number += 1
        else:
            return new


def _manifest(
    spool: Spool,
    recipe: Recipe,
    folder: str,
    own: tuple[Column, ...],
    attributes: tuple[Column, ...],
    end: SpoolSummary,
) -> Manifest:
    blocks = spool.blocks
    low = np.min([block.low for block in blocks], axis=0).tolist()
    high = np.max([block.high for block in blocks], axis=0).tolist()
    return Manifest(
        line=recipe.line,
        points=spool.points,
        left_out=end.read - spool.points,
        folder=folder,
        columns=own,
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


def _fill(
    spool: Spool,
    recipe: Recipe,
    pieces: Pieces,
    place: Place,
    findings: Findings,
    expected: "_Expected",
    progress: Progress,
) -> SpoolSummary:
    """Spool what is not spooled yet, and give what is known of the whole file.

    Raises
    ------
    ProjectError
        Where there is no point in it.
    """
    known = spool.end
    if known is not None:
        return known
    read, pace = spool.next_index, None
    source = pieces(spool.next_index)
    gathered = blocks_of(source, spool.points, spool.running, recipe.original.path)
    with closing(read_ahead(gathered)) as ahead:
        for block, piece in ahead:
            if pace is None:
                pace = Pace(
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
    spool.complete(end)
    return end


def tidy(folder: Path, manifest: Manifest) -> None:
    """Remove what is not part of a complete store, where nobody is importing the line."""
    parts = {MANIFEST, LOCK, manifest.folder}
    if is_link(folder.parent) or is_link(folder):
        return
    try:
        if all(path.name in parts for path in folder.iterdir()):
            return
        with locked(folder):
            remove_leftovers(folder, keep=manifest.folder)
            remove_spool(folder)
    except (OSError, ProjectError):
        return  # it may be read without being written


class _Expected:
    """Disk space of an import, once the number of points is known."""

    points: int | None = None

    def bytes(self) -> int | None:
        """None where it has not."""
        return None if self.points is None else self.points * BYTES_PER_POINT


def _current(folder: Path) -> str:
    """Folder of the columns that count; one that is damaged does not."""
    try:
        manifest = read_manifest(folder)
    except DamagedStore:
        (folder / MANIFEST).unlink(missing_ok=True)
        return ""
    return "" if manifest is None else manifest.folder


def _made_folders(folder: Path) -> list[Path]:
    """Those of the folder and the one above that are not there yet."""
    return [path for path in (folder, folder.parent) if not path.exists()]


def _remove_empty(folders: list[Path]) -> None:
    for path in folders:
        try:
            path.rmdir()
        except OSError:  # it holds something, or was never made
            return
