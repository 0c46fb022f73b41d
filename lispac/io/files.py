"""Opening files with plain errors, and writing them so that a crash leaves no half."""

import errno
import math
import os
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.packed import require_unpacked
from lispac.locks import is_locked, try_lock
from lispac.messages import error
from lispac.survey.time_quality import time_quality


def require_file(path: Path, what: str) -> Path:
    """Give the path back where it is a file that can be read; ``what`` names its role.

    Text may be compressed by gzip; other compressed files and archives are refused.

    Raises
    ------
    InputError
    """
    path = Path(path)
    try:
        there = path.exists()
    except (OSError, ValueError):  # a name that is too long, or has a null character
        there = False
    if not there:
        raise InputError(f"{path}: there is no such {what} file; check the path.")
    if not path.is_file():
        raise InputError(f"{path}: this is a {_kind(path)}, not a {what} file; choose a file.")
    if not os.access(path, os.R_OK):
        raise InputError(f"{path}: this {what} file cannot be read; check its permissions.")
    require_unpacked(path, text=True)
    return path


def _kind(path: Path) -> str:
    """What a path is that is no file."""
    kinds = {
        "named pipe (FIFO)": Path.is_fifo, "socket": Path.is_socket,
        "device": Path.is_char_device, "disk device": Path.is_block_device,
    }  # fmt: skip
    return next((name for name, is_kind in kinds.items() if is_kind(path)), "folder")


@contextmanager
def plain_name(path: Path, ending: str = "") -> Iterator[Path]:
    """Yield a name of a file for libraries that need UTF-8, or an ending, in names of files.

    Parameters
    ----------
    ending : str
        Lower case, with the dot; any where empty.
    """
    try:
        str(path).encode("utf-8")
        plain = not ending or path.suffix.lower() == ending
    except UnicodeEncodeError:
        plain = False
    if plain:
        yield path
        return
    with tempfile.TemporaryDirectory(prefix="lispac-") as folder:
        link = Path(folder) / f"file{ending or '.bin'}"
        try:
            link.symlink_to(path.resolve())
        except OSError:  # Windows asks for a right to make links
            shutil.copyfile(path, link)
        yield link


def read_records(
    path: Path, columns: int, what: str, *, byte_order: str = "<"
) -> NDArray[np.float64]:
    """Read a file of float64 records, little-endian (``<``) unless told otherwise (``>``).

    Returns
    -------
    ndarray of shape (n, columns)

    Raises
    ------
    InputError
        Where the file is missing, empty, cut short or holds values that are not numbers.
    """
    require_file(path, what)
    size, record = path.stat().st_size, 8 * columns
    if size == 0:
        raise InputError(f"{path}: this {what} file is empty; export it again.")
    if size % record:
        raise InputError(
            f"{path}: {size:,} bytes are not a whole number of {record}-byte {what} records "
            f"(the last one has {size % record}); the file is cut short or not {what}: "
            "copy or export it again."
        )
    try:
        records = np.fromfile(path, dtype=f"{byte_order}f8").reshape(-1, columns)
    except (OSError, ValueError, MemoryError) as error:
        raise InputError(
            f"{path}: this {what} file cannot be read to its end ({error}); "
            "check that the disk is there and nothing else writes to it."
        ) from error
    bad = ~np.isfinite(records).all(axis=1)
    if bad.any():
        raise InputError(
            f"{path}: {what} record {int(np.argmax(bad)) + 1:,} holds a value that is not a "
            f"number ({such(int(bad.sum()), 'record')}); export it again."
        )
    return records.astype(np.float64, copy=False)


def require_increasing(
    time: NDArray[np.float64], path: Path, what: str, numbers: NDArray[np.int64] | None = None
) -> None:
    """Refuse times that stand still or run backwards.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    what : str
        What a time belongs to: ``SBET record`` is said with its number.
    numbers : ndarray of shape (n,), optional
        Row in the file of each time, where that is not its place among the times.

    Raises
    ------
    InputError
    """
    quality = time_quality(time)
    if quality.first_disorder is None:
        return
    k = quality.first_disorder
    place = f"row {numbers[k]:,}" if numbers is not None else f"{what} record {k + 1:,}"
    if quality.resolution is not None:
        raise InputError(
            f"{path}: times stand on steps of {quality.resolution:g} s from {place} on, "
            "as if they had gone through 32-bit numbers; export with 64-bit times."
        )
    counted = [
        f"{count:,} {kind}"
        for count, kind in ((quality.duplicates, "repeat"), (quality.backward, "run backward"))
        if count
    ]
    raise InputError(
        f"{path}: time runs from {time[k - 1]:.6f} to {time[k]:.6f} s at {place} "
        f"({' and '.join(counted)} of {len(time):,}); times must increase: sort the file or "
        "export it again."
    )


def such(count: int, noun: str) -> str:
    """How many of them there are: ``1 such point``, ``2 such points``."""
    return f"{count:,} such {noun}{'' if count == 1 else 's'}"


def without_path(sentence: str, path: Path) -> str:
    """A sentence for where the file is named already."""
    for name in (f"{path}: ", f"{path}, "):
        if sentence.startswith(name):
            rest = sentence[len(name) :]
            return rest[:1].upper() + rest[1:]
    return sentence


TEMPORARY = ".part"
"""Before the suffix of the temporary name of a file that is being written."""


@contextmanager
def written_whole(path: Path) -> Iterator[Path]:
    """Yield a temporary name beside ``path`` and rename it to ``path`` when all went well.

    Where it did not, neither the file nor a folder made for it is left.

    Raises
    ------
    InputError
        Where the folder cannot be written, the disk is full, or ``path`` is a folder or a device.
    """  # noqa: DOC501 - `not_written` makes an InputError
    path = Path(path)
    made: list[Path] = []
    try:
        made = [folder for folder in path.parents if not folder.exists()]
        if path.exists() and not path.is_file():
            code = "file.is_folder" if path.is_dir() else "file.is_device"
            raise InputError(error(code, file=str(path)))
        remove_abandoned(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(
            prefix=f".{path.stem}-", suffix=f"{TEMPORARY}{path.suffix}", dir=path.parent
        )
    except ValueError as failure:  # a null character, or half of a pair of characters
        raise InputError(error("file.bad_name", file=repr(str(path)))) from failure
    except OSError as failure:
        remove_empty(made)
        raise not_written(path, failure) from failure
    temporary = Path(name)
    # The lock shows others that somebody writes it. Windows renames no file that is open.
    if sys.platform == "win32" or not try_lock(handle):
        os.close(handle)
        handle = -1
    try:
        yield temporary
        # mkstemp makes files private; give the result the permissions of any new file.
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        temporary.replace(path)
    except OSError as failure:
        raise not_written(path, failure) from failure
    finally:
        temporary.unlink(missing_ok=True)
        if handle >= 0:
            os.close(handle)
        remove_empty(made)


ABANDONED_AFTER, LOCKED_AFTER = 60.0, 0.1
"""Seconds without a change after which nobody is still writing a file, and after which one who
writes it has locked it, on systems where this is done."""


def remove_abandoned(path: Path) -> None:
    """Remove what `written_whole` left beside ``path`` where it was killed."""
    named = re.compile(
        rf"\.{re.escape(path.stem)}-[a-z0-9_]{{8}}{TEMPORARY}{re.escape(path.suffix)}"
    )
    try:
        with os.scandir(path.parent) as entries:
            found = [entry for entry in entries if named.fullmatch(entry.name)]
        for entry in found:
            age = time.time() - entry.stat(follow_symlinks=False).st_mtime
            if entry.is_file(follow_symlinks=False) and age > _patience(Path(entry.path)):
                os.unlink(entry.path)
    except OSError:
        return  # a folder that may be read only, or somebody else was faster


def _patience(path: Path) -> float:
    """Seconds that a temporary file may stand unchanged before it counts as abandoned."""
    locked = None if sys.platform == "win32" else is_locked(path)
    return {True: math.inf, False: LOCKED_AFTER, None: ABANDONED_AFTER}[locked]


def not_written(path: Path, error: OSError) -> InputError:
    """Make the error of a file that cannot be written."""
    remedy = "choose another folder"
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        remedy = f"make room on the disk or {remedy}"
    return InputError(f"{path}: cannot be written ({error.strerror or error}); {remedy}.")


def remove_empty(folders: list[Path]) -> None:
    """Remove folders, the innermost first, up to one that holds something."""
    for folder in folders:
        try:
            folder.rmdir()
        except OSError:
            return
