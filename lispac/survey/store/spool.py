"""Temporary sorted blocks of points during the import of a line.

A block has three files: the sort keys, the columns (without those that are constant in the block),
and a summary, which is written last. Blocks without a summary are ignored. After an interruption,
reading continues after the last complete block if the file and all other inputs are unchanged.
"""

import json
import re
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from math import prod
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError
from lispac.messages import error
from lispac.survey.store.column_files import file_checksum
from lispac.survey.store.fingerprint import RunningFingerprint
from lispac.survey.store.layout import (
    PART_SUFFIX_PATTERN,
    SPOOL_FOLDER,
    StoredColumn,
    is_link,
    json_with_checksum,
    read_checked_json,
    replace_file_when_complete,
    write_text_atomically,
)
from lispac.survey.store.point_blocks import (
    BLOCK_POINTS,
    POINT_COLUMNS,
    Place,
    PointBlock,
    Values,
    field_names,
)
from lispac.survey.store.spatial_cells import (
    Keys,
    choose_cell_side,
    corners_and_reach,
    order_keys,
    stable_order,
)
from lispac.value_conversion import decode_value, encode_value

READING_ERRORS = (OSError, ValueError, KeyError, TypeError, RecursionError)
"""Errors that a missing or damaged file of the spool raises."""
RECIPE_FILE, COMPLETION_FILE = "recipe.json", "complete.json"
SPOOL_VERSION = 3
SPOOL_FILE_PATTERN = re.compile(
    rf"(block-[0-9]{{5,}}\.(keys|columns|json)|{re.escape(RECIPE_FILE)}|{re.escape(COMPLETION_FILE)})"
    rf"{PART_SUFFIX_PATTERN}?"
)
"""Pattern of the names of the files of a spool; other files are not removed."""


@dataclass(frozen=True)
class SpooledBlock:
    """Summary of a spooled block.

    Attributes
    ----------
    number : int
        Number of the block, from 0.
    count : int
        Number of points.
    next_index : int
        Index in the imported file after the last point.
    running : RunningFingerprint
        Fingerprint of the line up to the last point.
    side : float, metres
        Edge length of the cells by which the points are sorted.
    low, high : list of 3 floats, metres, local frame
        Smallest and largest coordinates.
    times : list of 2 floats, seconds
        First and last.
    reach : float, metres
        Distance from the scanner to the farthest point.
    columns : tuple of StoredColumn
        Attributes of the imported file, with their value if all points of the block have the same.
    checksums : list of 2 int
        CRC-32 of the files of keys and of columns.
    """

    number: int
    count: int
    next_index: int
    running: RunningFingerprint
    side: float
    low: list[float]
    high: list[float]
    times: list[float]
    reach: float
    columns: tuple[StoredColumn, ...]
    checksums: list[int]


@dataclass(frozen=True)
class SpoolSummary:
    """Number of points, messages and audit of a file that was read completely.

    Attributes
    ----------
    read : int
        Points of the file, including excluded ones.
    assumptions : tuple of mapping
        Messages as plain values; texts if an earlier version wrote the file.
    audit : mapping
        `LineAudit` of the points as plain values.
    """

    read: int
    assumptions: tuple[Any, ...] = ()
    audit: Mapping[str, Any] = field(default_factory=dict)


def remove_spool(folder: Path) -> None:
    """Remove the spool of a line; a folder with other files is kept with these files."""
    spool = folder / SPOOL_FOLDER
    if is_link(spool):
        return
    with suppress(OSError):
        for path in spool.iterdir():
            if SPOOL_FILE_PATTERN.fullmatch(path.name):
                path.unlink()
        spool.rmdir()


class Spool:
    """The blocks of one line.

    Parameters
    ----------
    folder : Path
        Of the line.
    recipe : mapping
        All inputs that determine the blocks. Blocks made from other inputs are removed.
    """

    def __init__(self, folder: Path, recipe: Mapping[str, Any]) -> None:
        self.folder = folder / SPOOL_FOLDER
        self.blocks: list[SpooledBlock] = []
        content = json.dumps({"version": SPOOL_VERSION, "block": BLOCK_POINTS, **recipe}, indent=1)
        try:
            known = (self.folder / RECIPE_FILE).read_text(encoding="utf-8")
        except (OSError, ValueError):
            known = ""
        if known != content:
            self.remove()
            self.folder.mkdir(parents=True, exist_ok=True)
            write_text_atomically(self.folder / RECIPE_FILE, content)
        self._find_blocks()

    @property
    def points(self) -> int:
        """Points in all blocks."""
        return sum(block.count for block in self.blocks)

    @property
    def next_index(self) -> int:
        """Index in the file at which reading continues."""
        return self.blocks[-1].next_index if self.blocks else 0

    @property
    def running(self) -> RunningFingerprint:
        """Checksums of all blocks."""
        return self.blocks[-1].running if self.blocks else RunningFingerprint()

    @property
    def read_end(self) -> SpoolSummary | None:
        """Summary of the imported file; None if it is not yet read to its end."""
        try:
            content = read_checked_json((self.folder / COMPLETION_FILE).read_text(encoding="utf-8"))
            if content.pop("points") != self.points:
                return None
            return decode_value(content, SpoolSummary)
        except READING_ERRORS:
            return None

    def mark_complete(self, end: SpoolSummary) -> None:
        """Record that the imported file was read to its end."""
        content = {"points": self.points, **encode_value(end)}
        write_text_atomically(self.folder / COMPLETION_FILE, json_with_checksum(content))

    def add(self, block: PointBlock, place: Place) -> None:
        """Georeference, sort and write a block."""
        points_lidar, time = block.points_lidar[: block.count], block.time[: block.count]
        points_local = place(points_lidar, time)
        side = self.blocks[0].side if self.blocks else choose_cell_side(points_local)
        low, high, reach = corners_and_reach(points_lidar, points_local)
        values = block.values
        keys = order_keys(points_local, values["number"], side)
        order = stable_order(keys)
        number = len(self.blocks)
        columns = tuple(
            _column_with_constant(column, values[field])
            for field, column in field_names(block.columns).items()
        )
        checksums = [
            self._write(number, "keys", [keys[order]]),
            self._write(
                number,
                "columns",
                (values[field].take(order, axis=0) for field in _columns_on_disk(columns)),
            ),
        ]
        spooled = SpooledBlock(
            number,
            block.count,
            block.next_index,
            block.running,
            side,
            low.tolist(),
            high.tolist(),
            [float(time.min()), float(time.max())],
            float(reach),
            columns,
            checksums,
        )
        write_text_atomically(self._path(number, "json"), json_with_checksum(encode_value(spooled)))
        self.blocks.append(spooled)

    def keys(self, number: int) -> Keys:
        """Sorted keys of a block, shape (n,)."""
        return np.fromfile(self._path(number, "keys"), np.uint64)

    def slice_of(self, number: int, start: int, stop: int) -> tuple[Keys, Values]:
        """Keys and values of a part of a block, without the columns that are constant in it.

        Raises
        ------
        ProjectError
            If a file of the block is too short.
        """
        block, count = self.blocks[number], stop - start
        keys = np.fromfile(self._path(number, "keys"), np.uint64, count, offset=8 * start)
        values, offset = {}, 0
        with self._path(number, "columns").open("rb") as file:
            for field, column in _columns_on_disk(block.columns).items():
                kind = np.dtype((column.dtype, column.shape))
                file.seek(offset + start * kind.itemsize)
                numbers = np.fromfile(file, column.dtype, count * prod(column.shape))
                values[field] = numbers.reshape(-1, *column.shape)
                offset += block.count * kind.itemsize
        if any(len(column) != count for column in (keys, *values.values())):
            folder = str(self.folder.parent)
            raise ProjectError(error("store.block_cut_short", folder=folder, block=number))
        return keys, values

    def remove(self) -> None:
        """Remove the spool from disk."""
        remove_spool(self.folder.parent)
        self.blocks = []

    def _find_blocks(self) -> None:
        while (found := self._read_sound_block(len(self.blocks))) is not None:
            self.blocks.append(found)
        kept = {
            self._path(block.number, kind).name
            for block in self.blocks
            for kind in BLOCK_FILE_SUFFIXES
        }
        kept |= {RECIPE_FILE, COMPLETION_FILE}
        for path in self.folder.iterdir():
            if path.name not in kept and SPOOL_FILE_PATTERN.fullmatch(path.name):
                path.unlink()

    def _read_sound_block(self, number: int) -> SpooledBlock | None:
        """Read a block of an earlier import; None if it is missing or a checksum is wrong."""
        try:
            content = read_checked_json(self._path(number, "json").read_text(encoding="utf-8"))
            sums = [file_checksum(self._path(number, kind)) for kind in ("keys", "columns")]
            if sums != content["checksums"]:
                return None
            return decode_value(content, SpooledBlock)
        except READING_ERRORS:
            return None

    def _write(self, number: int, kind: str, columns: Iterable[NDArray[Any]]) -> int:
        """Write a file of a block and return its checksum."""
        path, checksum = self._path(number, kind), 0
        with replace_file_when_complete(path) as file:
            for values in columns:
                data = values.reshape(-1).view(np.uint8).data
                file.write(data)
                checksum = crc32(data, checksum)
        return checksum

    def _path(self, number: int, kind: str) -> Path:
        return self.folder / f"block-{number:05d}.{kind}"


FIRST_COMPARED_POINTS = 1000
BLOCK_FILE_SUFFIXES = ("keys", "columns", "json")


def _columns_on_disk(columns: tuple[StoredColumn, ...]) -> dict[str, StoredColumn]:
    """Columns of a block that are not constant, by field; only these are on disk."""
    own = {column.name: column for column in POINT_COLUMNS}
    return own | {f: column for f, column in field_names(columns).items() if column.value is None}


def _column_with_constant(column: StoredColumn, values: NDArray[Any]) -> StoredColumn:
    """The column, with its value if all points have the same finite value."""
    bits = values.view(f"u{values.itemsize}").reshape(len(values), -1)
    # Bits are compared, so that -0 and 0 differ. JSON has no NaN or infinity.
    for part in (bits[:FIRST_COMPARED_POINTS], bits):  # usually, the first points differ already
        if (part != bits[0]).any() or not np.isfinite(values[0]).all():
            return StoredColumn(column.name, column.dtype, column.shape)
    return StoredColumn(column.name, column.dtype, column.shape, value=values[0].tolist())
