"""Files in the folder of a stored line, and its manifest.

The folder contains the manifest ``store.json``, and a folder ``columns-N`` with one file in NumPy's
format for each column and, for a LAS file, its header and the checksum of the header. The manifest
is written last and renamed. Folders of columns that it does not name, such as those of an
interrupted import, are not part of the store. During the import of a line, its blocks of points are
in the folder ``spool``.
"""

import errno
import json
import os
import re
import secrets
import stat
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO
from zlib import crc32

import numpy as np

from lispac.errors import ProjectError, failure_reason, system_reason
from lispac.former_names import renamed_keys, renamed_reading
from lispac.messages import Message, error
from lispac.untrusted_values import json_values
from lispac.value_conversion import decode_value, encode_value

MANIFEST_VERSION = 3
NEW_NAMES_OF_VERSION_2 = {"": {"left_out": "excluded_points"}}
"""Names of fields of the manifest by their names in version 2, see `renamed_keys`."""
REQUIRED_COLUMNS = {"xyz", "time", "number", "row", "octaves", "starts"} | {
    f"coarse_{name}" for name in ("row", "local", "xyz", "time")
}
"""Columns that every store has."""
MAX_TYPE_NAME_LENGTH = 16
"""Largest number of characters in NumPy's name of a type."""
MANIFEST_FILE, SPOOL_FOLDER = "store.json", "spool"
COLUMNS_PREFIX, PART_SUFFIX = "columns-", ".part"
COLUMNS_FOLDER_PATTERN = re.compile(rf"{COLUMNS_PREFIX}[0-9]{{1,9}}")
HEADER_FILE, HEADER_CHECKSUM_FILE = "header.las", "header.sum"
"""Header of an imported LAS file, and its checksum, in the folder of the columns."""
PART_SUFFIX_PATTERN = rf"((\.[0-9a-f]{{16}})?{re.escape(PART_SUFFIX)})"
"""Pattern of the suffix of a file that is being written, see `replace_file_when_complete`."""
COLUMN_FILE_PATTERN = re.compile(
    rf"(({'|'.join(sorted(REQUIRED_COLUMNS))}|before|coarse_intensity"
    rf"|attribute-[0-9]{{2,}}-[A-Za-z0-9_]*)\.npy"
    rf"|{re.escape(HEADER_FILE)}|{re.escape(HEADER_CHECKSUM_FILE)}){PART_SUFFIX_PATTERN}?"
)
"""Names of the files that an import writes into the folder of its columns."""
MANIFEST_PART_PATTERN = re.compile(re.escape(MANIFEST_FILE) + PART_SUFFIX_PATTERN)
MAX_RANGE_M, MAX_TIME_S = 1e7, 1e12
"""Largest possible distance from the scanner in metres, and largest possible time in seconds."""


class DamagedStore(ProjectError):
    """The manifest of a stored line cannot be read; the line has to be imported again."""


def import_again_message(reason: Message) -> Message:
    """A message that a line has to be imported again, with the reason as its parameter."""
    return error("store.import_again", reason=reason)


def damage_reason(failure: ProjectError) -> Message | str:
    """Reason why an imported line is damaged, without the advice to import it again."""
    if failure.message is not None and failure.code == "store.import_again":
        reason = failure.message.params["reason"]
        assert isinstance(reason, Message)
        return reason
    return failure.reason


def is_link(path: Path) -> bool:
    """Whether a path is a symbolic link or, on Windows, a junction."""
    try:
        status = path.lstat()
    except OSError:
        return False
    reparse = getattr(stat, "FILE_ATTRIBUTE_REPARSE_POINT", 0)
    return stat.S_ISLNK(status.st_mode) or bool(getattr(status, "st_file_attributes", 0) & reparse)


def require_no_link(*paths: Path) -> None:
    """Refuse paths that are links, so that nothing is written or deleted in another folder.

    Raises
    ------
    ProjectError
        If one of the paths is a link.
    """
    for path in paths:
        if is_link(path):
            raise ProjectError(error("store.link", folder=str(path)))


@dataclass(frozen=True)
class StoredColumn:
    """Description of a stored column.

    Attributes
    ----------
    name : str
        Name of an attribute in the imported file, or name of a column that the store adds.
    dtype : str
        NumPy's name of the type.
    shape : tuple of int
        Of the value of one point: empty for a number.
    file : str
        Name in the folder of the columns; empty if all points have the same value.
    count : int
        Values in the file.
    size : int, bytes
    checksum : int
        CRC-32 of the whole file.
    value : number or list of numbers
        Value of all points, if there is no file.
    modified : int, nanoseconds
        Modification time of the file when it was written or last checked; 0 if unknown.
    """

    name: str
    dtype: str
    shape: tuple[int, ...] = ()
    file: str = ""
    count: int = 0
    size: int = 0
    checksum: int = 0
    value: Any = None
    modified: int = 0


@dataclass(frozen=True)
class SourceFile:
    """The file from which a line was imported, in its state at the import.

    Attributes
    ----------
    path : str
    size : int, bytes
    modified : int, nanoseconds
    fingerprint : str
        Hash of its whole content, see `lispac.survey.store.original_file`.
    """

    path: str
    size: int
    modified: int
    fingerprint: str


@dataclass(frozen=True)
class Manifest:
    """Contents of a stored line and their source.

    Attributes
    ----------
    line : str
        Name of the line.
    points : int
    excluded_points : int
        Points of the file that are not in the store.
    folder : str
        Name of the folder of the columns.
    columns : tuple of StoredColumn
        Coordinates, times and indices; see `lispac.survey.store.column_writer.write_columns`.
    attributes : tuple of StoredColumn
        Attributes of the points besides coordinates and time, under their names in the file.
    side : float, metres
        Edge length of the cubic cells.
    low, high : tuple of 3 floats, metres, local frame
        Smallest and largest coordinates of the georeferenced points.
    first_time, last_time : float, seconds, in the trajectory's time base
    reach : float, metres
        Distance from the scanner to the farthest point.
    fingerprint : str
        `Scan.fingerprint` of the points in the order of the file.
    original : SourceFile
    made_with : mapping
        Inputs other than the file that determine the content: the reading options, the trajectory,
        and the mounting if the points were recovered with it.
    placed_with : mapping
        Input that determines the spatial order: the mounting.
    assumptions : tuple of mapping
        Messages on the assumptions of the reader, as plain values; texts in a store of an earlier
        version.
    audit : mapping
        `LineAudit` of the points of the file, as plain values; empty for a line imported by a
        version without one.
    """

    line: str
    points: int
    excluded_points: int
    folder: str
    columns: tuple[StoredColumn, ...]
    attributes: tuple[StoredColumn, ...]
    side: float
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    first_time: float
    last_time: float
    reach: float
    fingerprint: str
    original: SourceFile
    made_with: Mapping[str, Any] = field(default_factory=dict)
    placed_with: Mapping[str, Any] = field(default_factory=dict)
    assumptions: tuple[Any, ...] = ()
    audit: Mapping[str, Any] = field(default_factory=dict)

    @property
    def files(self) -> tuple[StoredColumn, ...]:
        """All columns that have a file."""
        return tuple(column for column in (*self.columns, *self.attributes) if column.file)

    @property
    def bytes(self) -> int:
        """Size on disk."""
        return sum(column.size for column in self.files)


def write_manifest(folder: Path, manifest: Manifest) -> None:
    """Write the manifest and rename it to its final name, which completes the import."""
    content = encode_value(manifest)
    text = json.dumps(
        {"version": MANIFEST_VERSION, "checksum": _checksum(content), "store": content}, indent=1
    )
    write_text_atomically(folder / MANIFEST_FILE, text + "\n")


def read_manifest(folder: Path) -> Manifest | None:
    """Read the manifest in the folder of a line; None if there is none.

    Raises
    ------
    DamagedStore
        If it is damaged.
    ProjectError
        If it is of a newer version of the program.
    """
    path = folder / MANIFEST_FILE
    try:
        content = json_values(path.read_bytes())
        if content["version"] > MANIFEST_VERSION:
            raise ProjectError(error("store.newer_version", file=str(path)))
        store = content["store"]
        if content["checksum"] != _checksum(store):
            raise DamagedStore(
                import_again_message(error("store.manifest_checksum", file=str(path)))
            )
        store = renamed_keys(store, NEW_NAMES_OF_VERSION_2)
        made_with = store.get("made_with", {})
        if "reading" in made_with:
            reading = renamed_reading(made_with["reading"])
            store = store | {"made_with": made_with | {"reading": reading}}
        manifest = decode_value(store, Manifest)
        _require_valid_manifest(manifest, path)
        return manifest
    except FileNotFoundError:
        return None
    except (OSError, ValueError, KeyError, TypeError, OverflowError) as failure:
        damage = error("store.manifest_damaged", file=str(path), reason=failure_reason(failure))
        raise DamagedStore(import_again_message(damage)) from failure


def _require_valid_manifest(manifest: Manifest, path: Path) -> None:
    """Refuse manifests with impossible values, paths outside the folder or inconsistent columns.

    Raises
    ------
    DamagedStore
        If a value is impossible; the line then has to be imported again.
    """
    values = error("store.manifest_values", file=str(path))
    names = (manifest.folder, *(column.file for column in manifest.files))
    counts = [manifest.points, manifest.excluded_points]
    numbers = [
        manifest.side, manifest.reach, *manifest.low, *manifest.high, manifest.first_time,
        manifest.last_time,
    ]  # fmt: skip
    for column in (*manifest.columns, *manifest.attributes):
        counts += [column.count, column.size, column.checksum, column.modified, *column.shape]
        if len(column.dtype) > MAX_TYPE_NAME_LENGTH:
            raise DamagedStore(import_again_message(values))
        if np.dtype(column.dtype).kind not in "biuf":
            damage = error("store.column_type", file=str(path), type=column.dtype)
            raise DamagedStore(import_again_message(damage))
        if not column.file:
            np.broadcast_to(np.array(column.value, column.dtype), column.shape)
    sound = (
        min(counts) >= 0
        and np.isfinite(numbers).all()
        and all(name == Path(name).name for name in names)
        and COLUMNS_FOLDER_PATTERN.fullmatch(manifest.folder) is not None
        and 0 <= manifest.reach <= MAX_RANGE_M
        and max(abs(manifest.first_time), abs(manifest.last_time)) <= MAX_TIME_S
        and _has_mounting_values(manifest.placed_with)
        and {column.name for column in manifest.columns} >= REQUIRED_COLUMNS
        and all(isinstance(each, dict | str) for each in manifest.assumptions)
    )
    if not sound:
        raise DamagedStore(import_again_message(values))


def _has_mounting_values(placed_with: Mapping[str, Any]) -> bool:
    """Whether the mounting in ``placed_with`` is nine finite numbers, or absent."""
    values = placed_with.get("mounting", [0.0] * 9)
    return (
        isinstance(values, list)
        and len(values) == 9
        and all(type(value) in (int, float) and np.isfinite(value) for value in values)
    )


def _checksum(content: Mapping[str, Any]) -> int:
    return crc32(json.dumps(content, sort_keys=True).encode())


def require_file_sizes(folder: Path, manifest: Manifest) -> None:
    """Refuse a store if a file is missing or its size differs from that in the manifest.

    Raises
    ------
    ProjectError
        If a file is missing or its size differs; the line then has to be imported again.
    """
    for column in manifest.files:
        path = folder / manifest.folder / column.file
        size = path.stat().st_size if path.is_file() else -1
        if size != column.size:
            file, line = str(path), manifest.line
            damage = (
                error("store.part_missing", file=file, line=line)
                if size < 0
                else error("store.part_size", file=file, line=line, size=size, expected=column.size)
            )
            raise ProjectError(import_again_message(damage))


def json_with_checksum(content: Any) -> str:
    """Plain values as JSON with a checksum."""
    return json.dumps({"checksum": _checksum(content), "content": content}, indent=1)


def read_checked_json(text: str) -> Any:
    """The inverse of `json_with_checksum`.

    Raises
    ------
    ValueError
        If the text is not JSON or its checksum is wrong.
    KeyError
        If there is no checksum.
    TypeError
        If the text is JSON of another structure.
    """
    whole = json_values(text)
    if whole["checksum"] != _checksum(whole["content"]):
        raise ValueError("its checksum does not hold")
    return whole["content"]


def write_text_atomically(path: Path, text: str) -> None:
    """Write a small file, flush it to disk, and then rename it to its final name."""
    with replace_file_when_complete(path) as file:
        file.write(text.encode("utf-8"))
        flush_to_disk(file)


@contextmanager
def replace_file_when_complete(path: Path) -> Iterator[BinaryIO]:
    """Yield a new file beside ``path`` that is renamed to it when complete.

    The file has a random name and is created only if nothing with this name exists, so that links
    are never followed. A link with the name of ``path`` is replaced.
    """
    part = path.with_name(f"{path.name}.{secrets.token_hex(8)}{PART_SUFFIX}")
    with part.open("xb") as file:
        try:
            yield file
        except BaseException:
            file.close()
            part.unlink(missing_ok=True)
            raise
    try:
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def flush_to_disk(file: Any) -> None:
    """Flush a file to disk, so that no data remain in a buffer."""
    file.flush()
    os.fsync(file.fileno())


def has_import(folder: Path) -> bool:
    """Whether a folder contains an imported line, or blocks of an incomplete import."""
    return (folder / MANIFEST_FILE).exists() or (folder / SPOOL_FOLDER).is_dir()


def has_complete_import(folder: Path) -> bool:
    """Whether a folder contains a completely imported line."""
    return (folder / MANIFEST_FILE).exists()


def remove_columns(folder: Path) -> None:
    """Remove the columns of an import; a folder with other files is kept with these files."""
    with suppress(OSError):
        for path in folder.iterdir():
            if COLUMN_FILE_PATTERN.fullmatch(path.name) and not path.is_dir():
                path.unlink()
        folder.rmdir()


def remove_leftovers(folder: Path, keep: str = "") -> None:
    """Remove incomplete manifests and all folders of columns except ``keep``; keep the spool."""
    for path in columns_folders(folder):
        if path.name != keep and not is_link(path):
            remove_columns(path)
    remove_manifest_parts(folder)


def columns_folders(folder: Path) -> list[Path]:
    """Entries of a line's folder with the name of a folder of columns, links included."""
    return sorted(path for path in folder.iterdir() if COLUMNS_FOLDER_PATTERN.fullmatch(path.name))


def remove_manifest_parts(folder: Path) -> None:
    """Remove incomplete manifests of interrupted imports."""
    for path in folder.iterdir():
        if MANIFEST_PART_PATTERN.fullmatch(path.name) and (is_link(path) or path.is_file()):
            path.unlink(missing_ok=True)


@contextmanager
def writing_errors_as_project_errors(
    folder: Path, needed: Callable[[], int | None] = lambda: None
) -> Iterator[None]:
    """Convert system errors during writing to `ProjectError`.

    Parameters
    ----------
    needed : callable
        Returns the expected size of the import in bytes; None while it is unknown.

    Raises
    ------
    ProjectError
        If the disk is full or the folder cannot be written to.
    """
    try:
        yield
    except OSError as failure:
        raise ProjectError(_cannot_write_error(str(folder), failure, needed())) from failure


def _cannot_write_error(folder: str, failure: OSError, size: int | None) -> Message:
    """Message why a line cannot be written; ``size`` is the space that it needs, in bytes."""
    if failure.errno in (errno.ENOSPC, errno.EDQUOT):
        if size:
            return error("store.disk_full_size", folder=folder, size=size)
        return error("store.disk_full", folder=folder)
    if failure.errno == errno.EFBIG:
        if size:
            return error("store.file_too_large_size", folder=folder, size=size)
        return error("store.file_too_large", folder=folder)
    if failure.errno is None:
        return error("store.not_read_back", folder=folder, reason=str(failure))
    return error("store.not_writable", folder=folder, reason=system_reason(failure))
