"""Writing of the final columns of a line from its sorted blocks.

The blocks are merged one bucket at a time.
"""

from collections.abc import Iterator
from contextlib import ExitStack, closing
from pathlib import Path

import numpy as np

from lispac.errors import ProjectError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import PointRate, Progress
from lispac.survey.store.column_files import ColumnFile, ScatteredColumn
from lispac.survey.store.layout import StoredColumn
from lispac.survey.store.point_blocks import Place, Values, field_names
from lispac.survey.store.read_ahead import read_ahead
from lispac.survey.store.spatial_cells import Keys, is_in_coarse_sample, stable_order
from lispac.survey.store.spool import Spool

MAX_COARSE_POINTS = 1_000_000
"""Largest number of points in the coarse sample of a line."""
Columns = tuple[StoredColumn, ...]
BUCKET_POINTS = 1 << 20
"""Approximate number of points in a bucket, of which a few are in memory at once."""
KEY_SAMPLING_STEP = 1024
"""Interval, in points, of the keys that are sampled to divide the blocks into buckets."""


def write_columns(
    spool: Spool, folder: Path, place: Place, line: str, *, progress: Progress
) -> tuple[Columns, Columns]:
    """Write all columns of a line into an empty folder.

    Returns
    -------
    own : tuple of StoredColumn
        ``xyz``, ``time`` and ``number`` of each point, and ``before`` if points are excluded; the
        ``row`` of each number; the keys of the ``octaves`` and the row at which each ``starts``;
        the coarse sample.
    attributes : tuple of StoredColumn
        Attributes of the imported file.

    Raises
    ------
    ProjectError
        If fewer points are read from the blocks than were written to them.
    """
    points, done = spool.points, 0
    attributes = _constant_attributes(spool)
    with ExitStack() as stack:
        writer = _ColumnsWriter(stack, folder, attributes, points, spool.next_index != points)
        buckets = stack.enter_context(closing(read_ahead(merge_blocks(spool))))
        pace = PointRate(gettext_lazy("Sorting the points of {line}", line=line), points)
        for keys, values in buckets:
            progress(done / points, pace.step(done))
            order = stable_order(keys)
            ordered = {field: some.take(order, axis=0) for field, some in values.items()}
            writer.add(keys[order], ordered, done, place)
            done += len(keys)
        if done != points:
            raise ProjectError(
                error("store.points_lost", folder=str(folder.parent), read=done, points=points)
            )
        progress(1.0, gettext_lazy("Sorting the points of {line}: writing to disk", line=line))
        return writer.finish()


class _ColumnsWriter:
    """Writer of all columns of a line."""

    def __init__(
        self, stack: ExitStack, folder: Path, attributes: Columns, points: int, gaps: bool
    ) -> None:
        def column(name: str, dtype: str, *shape: int) -> ColumnFile:
            return stack.enter_context(ColumnFile(folder, f"{name}.npy", name, dtype, shape))

        self._points, self._last = points, np.uint64(2**64 - 1)
        self._attributes = attributes
        self._own = {
            "xyz": column("xyz", "<f4", 3), "time": column("time", "<f8"),
            "number": column("number", "<u4"),
        }  # fmt: skip
        if gaps:
            self._own["before"] = column("before", "<u4")
        self._row = ScatteredColumn(folder, "row.npy", "row", "<u4", points)
        self._octaves, self._starts = column("octaves", "<u8"), column("starts", "<u8")
        self._coarse = {
            "row": column("coarse_row", "<u4"), "local": column("coarse_local", "<f8", 3),
            "xyz": column("coarse_xyz", "<f4", 3), "time": column("coarse_time", "<f8"),
        }  # fmt: skip
        self._files: dict[str, ColumnFile] = {}
        for k, (field, attribute) in enumerate(field_names(attributes).items()):
            if attribute.value is None:
                name, kind, shape = attribute.name, attribute.dtype, attribute.shape
                self._files[field] = stack.enter_context(
                    ColumnFile(folder, attribute_file_name(k, name), name, kind, shape)
                )
                if name == "intensity":
                    self._coarse[field] = column("coarse_intensity", kind, *shape)

    def add(self, keys: Keys, values: Values, first: int, place: Place) -> None:
        """Write the next points, which are sorted by key, as the rows from ``first``."""
        for field, file in (*self._own.items(), *self._files.items()):
            file.append(values[field])
        rows = np.arange(first, first + len(keys), dtype=np.uint32)
        self._row.put(values["number"], rows)
        new = np.append(keys[0] != self._last, keys[1:] != keys[:-1])
        self._octaves.append(keys[new])
        self._starts.append(rows[new])
        self._last = keys[-1]
        chosen = is_in_coarse_sample(values["number"], self._points, MAX_COARSE_POINTS)
        if not chosen.any():
            return
        coarse = {field: values[field][chosen] for field in self._coarse if field in values}
        coarse["row"] = rows[chosen]
        coarse["local"] = place(coarse["xyz"].astype(np.float64), coarse["time"])
        for field, file in self._coarse.items():
            file.append(coarse[field])

    def finish(self) -> tuple[Columns, Columns]:
        """Finish all files; descriptions of the store's columns and of the attributes."""
        self._starts.append(np.array([self._points], np.uint64))
        files = (*self._own.values(), self._octaves, self._starts, *self._coarse.values())
        own = (*(file.finish() for file in files), self._row.finish())
        written = {column.name: column for column in (f.finish() for f in self._files.values())}
        return own, tuple(written.get(a.name, a) for a in self._attributes)


def attribute_file_name(number: int, attribute: str) -> str:
    """Name of the file with the column of an attribute."""
    plain = "".join(c if c.isascii() and c.isalnum() else "_" for c in attribute)[:40]
    return f"attribute-{number:02d}-{plain}.npy"


def merge_blocks(spool: Spool) -> Iterator[tuple[Keys, Values]]:
    """Yield keys and values bucket by bucket, each in the order of the blocks.

    No key of a bucket is smaller than a key of the buckets before it. After a stable sort of each
    bucket, all points are ordered by key and, for equal keys, by number.

    Yields
    ------
    keys : ndarray of shape (n,)
    values : of n points
        Without the columns that are constant in the whole line.
    """
    attributes = field_names(_constant_attributes(spool))
    varying = {field: column for field, column in attributes.items() if column.value is None}
    edges = _bucket_edges(spool)
    bounds = np.stack(
        [
            np.append(np.searchsorted(spool.keys(block.number), edges), block.count)
            for block in spool.blocks
        ]
    )
    for k in range(len(edges)):
        parts: list[tuple[Keys, Values]] = []
        # The points of a bucket with a single key are already in order: they are yielded in parts.
        has_single_key = k + 1 < len(edges) and edges[k + 1] == edges[k] + np.uint64(1)
        for number, (start, stop) in enumerate(bounds[:, k : k + 2].tolist()):
            if start == stop:
                continue
            keys, values = spool.slice_of(number, start, stop)
            for field, column in field_names(spool.blocks[number].columns).items():
                if field in varying and column.value is not None:
                    values[field] = np.full(
                        (len(keys), *column.shape), column.value, dtype=column.dtype
                    )
            parts.append((keys, values))
            if has_single_key and sum(len(keys) for keys, _ in parts) >= BUCKET_POINTS:
                yield _join_parts(parts)
                parts = []
        if parts:
            yield _join_parts(parts)


def _bucket_edges(spool: Spool) -> Keys:
    """First key of each bucket, from samples of all blocks."""
    # Copied, because a view would keep all keys in memory.
    samples = [spool.keys(block.number)[::KEY_SAMPLING_STEP].copy() for block in spool.blocks]
    edges = np.sort(np.concatenate(samples))[:: max(1, BUCKET_POINTS // KEY_SAMPLING_STEP)]
    heavy = edges[1:][edges[1:] == edges[:-1]]
    return np.unique(np.concatenate([np.zeros(1, np.uint64), edges, heavy + np.uint64(1)]))


def _constant_attributes(spool: Spool) -> tuple[StoredColumn, ...]:
    """The attributes, with their value if all points of all blocks have the same value."""
    found = []
    for same in zip(*(block.columns for block in spool.blocks), strict=True):
        first = same[0]
        # Compared as text, so that -0 and 0 differ.
        if any(str(column.value) != str(first.value) for column in same):
            first = StoredColumn(first.name, first.dtype, first.shape)
        found.append(first)
    return tuple(found)


def _join_parts(parts: list[tuple[Keys, Values]]) -> tuple[Keys, Values]:
    if len(parts) == 1:
        return parts[0]
    keys = np.concatenate([keys for keys, _ in parts])
    return keys, {f: np.concatenate([values[f] for _, values in parts]) for f in parts[0][1]}
