"""The final columns of a line, written from its sorted blocks."""

from contextlib import ExitStack, closing
from pathlib import Path

import numpy as np

from lispac.errors import ProjectError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import PointRate, Progress
from lispac.survey.store.block_merge import constant_attributes, merge_blocks
from lispac.survey.store.column_files import ColumnFile, ScatteredColumn
from lispac.survey.store.layout import StoredColumn
from lispac.survey.store.point_blocks import Place, Values, field_names
from lispac.survey.store.read_ahead import read_ahead
from lispac.survey.store.spatial_cells import Keys, is_drawn, stable_order
from lispac.survey.store.spool import Spool

COARSE = 1_000_000
"""Points of the coarse level at most."""

Columns = tuple[StoredColumn, ...]


def write_columns(
    spool: Spool, folder: Path, place: Place, line: str, *, progress: Progress
) -> tuple[Columns, Columns]:
    """Write all columns of a line into an empty folder.

    Returns
    -------
    own : tuple of StoredColumn
        ``xyz``, ``time``, ``number`` of each point, and ``before`` where points are excluded; the
        ``row`` of each number; the ``octaves`` of the cells and where each ``starts``; the coarse
        level.
    attributes : tuple of StoredColumn
        Of the file.

    Raises
    ------
    ProjectError
        Where the disk does not give back what was written.
    """
    points, done = spool.points, 0
    attributes = constant_attributes(spool)
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
    """All columns while they are being written."""

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
        """Write the next points; they are in order."""
        for field, file in (*self._own.items(), *self._files.items()):
            file.append(values[field])
        rows = np.arange(first, first + len(keys), dtype=np.uint32)
        self._row.put(values["number"], rows)
        new = np.append(keys[0] != self._last, keys[1:] != keys[:-1])
        self._octaves.append(keys[new])
        self._starts.append(rows[new])
        self._last = keys[-1]
        chosen = is_drawn(values["number"], self._points, COARSE)
        if not chosen.any():
            return
        coarse = {field: values[field][chosen] for field in self._coarse if field in values}
        coarse["row"] = rows[chosen]
        coarse["local"] = place(coarse["xyz"].astype(np.float64), coarse["time"])
        for field, file in self._coarse.items():
            file.append(coarse[field])

    def finish(self) -> tuple[Columns, Columns]:
        """Close all of them: the store's own and those of the attributes."""
        self._starts.append(np.array([self._points], np.uint64))
        files = (*self._own.values(), self._octaves, self._starts, *self._coarse.values())
        own = (*(file.finish() for file in files), self._row.finish())
        written = {column.name: column for column in (f.finish() for f in self._files.values())}
        return own, tuple(written.get(a.name, a) for a in self._attributes)


def attribute_file_name(number: int, attribute: str) -> str:
    """Name of the file that holds the column of an attribute."""
    plain = "".join(c if c.isascii() and c.isalnum() else "_" for c in attribute)[:40]
    return f"attribute-{number:02d}-{plain}.npy"
