"""Columns as files in NumPy's format, written in pieces and read by memory mapping."""

import os
import tokenize
from io import BytesIO
from pathlib import Path
from types import TracebackType
from typing import Any
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError, failure_reason
from lispac.messages import error
from lispac.survey.store.fingerprint import combine_crc32
from lispac.survey.store.layout import StoredColumn, flush_to_disk, import_again_message

NPY_HEADER_BYTES = 128
"""Size of the header. It does not depend on the number of values, as the header is written last."""
PIECE_BYTES = 1 << 24  # bytes read or filled at once
WINDOW_VALUES = 1 << 24  # values mapped at once for writing


class ColumnFile:
    """Column being written whose number of points is known only at the end.

    It is used in a ``with`` statement. A file that is not finished has no header and is invalid.
    """

    def __init__(self, folder: Path, file: str, name: str, dtype: str, shape: Any = ()) -> None:
        self._path, self._name = folder / file, name
        self._dtype, self._shape = np.dtype(dtype), tuple(shape)
        self._file = self._path.open("xb")
        self._file.write(bytes(NPY_HEADER_BYTES))
        self._count = self._checksum = self._bytes = 0

    def append(self, values: NDArray[Any]) -> None:
        """Write the values of the next points, shape (n, ...)."""
        data = np.ascontiguousarray(values, dtype=self._dtype).reshape(-1).view(np.uint8).data
        self._file.write(data)
        self._checksum = crc32(data, self._checksum)
        self._bytes += len(data)
        self._count += len(values)

    def finish(self) -> StoredColumn:
        """Write the header and flush the file to disk."""
        header = npy_header(self._dtype, (self._count, *self._shape))
        self._file.seek(0)
        self._file.write(header)
        flush_to_disk(self._file)
        # The values follow the header; their checksum is already known.
        checksum = combine_crc32(crc32(header), self._checksum, self._bytes)
        size = NPY_HEADER_BYTES + self._bytes
        return StoredColumn(
            self._name, self._dtype.str, self._shape, self._path.name, self._count, size, checksum
        )  # fmt: skip

    def __enter__(self) -> "ColumnFile":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._file.close()


class ScatteredColumn:
    """Column whose values are written in any order; the file has its full size from the start.

    If a full disk were noticed only when a mapped file is filled, the operating system would
    terminate the program instead of reporting an error.
    """

    def __init__(self, folder: Path, file: str, name: str, dtype: str, count: int) -> None:
        self._path, self._name, self._dtype = folder / file, name, np.dtype(dtype)
        self._count = count
        with self._path.open("xb") as column:
            column.write(npy_header(self._dtype, (count,)))
            left = count * self._dtype.itemsize
            while left > 0:
                left -= column.write(bytes(min(left, PIECE_BYTES)))

    def put(self, places: NDArray[Any], values: NDArray[Any]) -> None:
        """Write ``values`` at the indices ``places``, both of shape (n,)."""
        # Mapped again for each call and window, because mapped pages count as used memory.
        windows = places // WINDOW_VALUES
        for window in np.unique(windows).tolist():
            start = window * WINDOW_VALUES
            length = min(WINDOW_VALUES, self._count - start)
            offset = NPY_HEADER_BYTES + start * self._dtype.itemsize
            mapped = np.memmap(self._path, self._dtype, "r+", offset, length)
            inside = windows == window
            mapped[places[inside] - start] = values[inside]

    def finish(self) -> StoredColumn:
        """Flush the file to disk."""
        with self._path.open("r+b") as column:
            os.fsync(column.fileno())
        size = self._path.stat().st_size
        return StoredColumn(
            self._name, self._dtype.str, (), self._path.name, self._count, size,
            file_checksum(self._path),
        )  # fmt: skip


def npy_header(dtype: np.dtype[Any], shape: tuple[int, ...]) -> bytes:
    """Header of a file in NumPy's format."""
    header = BytesIO()
    description = {
        "descr": np.lib.format.dtype_to_descr(dtype), "fortran_order": False, "shape": shape,
    }  # fmt: skip
    np.lib.format.write_array_header_1_0(header, description)
    content = header.getvalue()
    assert len(content) == NPY_HEADER_BYTES, "a column of numbers has a header of one fixed size"
    return content


def file_checksum(path: Path) -> int:
    """CRC-32 of a file."""
    checksum = 0
    with path.open("rb") as file:
        while piece := file.read(PIECE_BYTES):
            checksum = crc32(piece, checksum)
    return checksum


def map_column(folder: Path, column: StoredColumn, count: int) -> NDArray[Any]:
    """Memory-mapped values of a column, shape (count, ...), read from disk when accessed.

    Raises
    ------
    ProjectError
        If the file cannot be read, or its type or shape differs from the manifest.
    """
    shape = (count, *column.shape)
    if not column.file:
        value = np.array(column.value, dtype=column.dtype)
        return np.broadcast_to(value, shape)
    path = folder / column.file
    try:
        # Not `np.load`, which also opens archives and pickles.
        values: NDArray[Any] = np.lib.format.open_memmap(path, mode="r")
        is_right = values.shape == shape and values.dtype == np.dtype(column.dtype)
    except (
        OSError, ValueError, EOFError, MemoryError, OverflowError, SyntaxError, tokenize.TokenError,
    ) as failure:  # fmt: skip
        reason = failure_reason(failure)
        reason = reason.split("\n")[0] if isinstance(reason, str) else reason
        raise ProjectError(
            import_again_message(error("store.part_damaged", file=str(path), reason=reason))
        ) from failure
    if not is_right:
        found = error(
            "store.part_type", file=str(path), type=str(values.dtype), shape=str(values.shape)
        )
        raise ProjectError(import_again_message(found))
    # A plain array on the same memory, because slices of `numpy.memmap` are slower.
    return np.asarray(values)
