"""Opening of files with clear errors, and atomic writing: a crash leaves no partial file."""

import errno
import math
import os
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError, LispacError, failure_reason, system_reason
from lispac.io.compressed_files import require_uncompressed
from lispac.locks import is_locked, try_lock
from lispac.messages import Message, error, note
from lispac.survey.line_source import printable
from lispac.survey.time_quality import assess_times
from lispac.untrusted_values import MAX_QUANTITY

TRANSLATED_FILE_KINDS: Mapping[str, Message] = {
    "line": note("file.kind_line"),
    "trajectory": note("file.kind_trajectory"),
    "trajectory accuracy": note("file.kind_accuracy"),
    "survey": note("file.kind_survey"),
    "text": note("file.kind_text"),
    "Exail text": note("file.kind_exail_text"),
    "POSPac text": note("file.kind_pospac_text"),
    "Inertial Explorer text": note("file.kind_inertial_explorer_text"),
    "CIDCO binary": note("file.kind_cidco"),
    "LAS or LAZ": note("file.kind_las"),
    "packet capture": note("file.kind_capture"),
    "plane": note("file.kind_plane"),
    "target": note("file.kind_target"),
    "a target as CSV": note("file.kind_target_csv"),
    "coordinate list": note("file.kind_coordinate_list"),
    "point correspondences": note("file.kind_correspondences"),
    "static scan": note("file.kind_static_scan"),
    "text of a static scan": note("file.kind_static_scan_text"),
    "mesh": note("file.kind_mesh"),
    "scene": note("file.kind_scene"),
    "scanner": note("file.kind_scanner"),
    "vessel": note("file.kind_vessel"),
    "plan": note("file.kind_plan"),
    "report template": note("file.kind_report_template"),
    "logo": note("file.kind_logo"),
    "certificate": note("file.kind_certificate"),
}
"""Kinds of files whose names are translated; other kinds are names of formats."""


def file_kind_message(what: str) -> Message | str:
    """Kind of a file, as the parameter ``kind`` of a message: ``line``, ``SBET``."""
    return TRANSLATED_FILE_KINDS.get(what, what)


def require_file(path: Path, what: str) -> Path:
    """Return the path if it is a readable file; ``what`` names its role in messages.

    Text may be compressed with gzip; other compressed files and archives are refused.

    Raises
    ------
    InputError
        If it is missing, not a regular file, unreadable or compressed in another way.
    """
    path, kind = Path(path), file_kind_message(what)
    try:
        exists = path.exists()
    except PermissionError as failure:  # of a folder on the way
        raise InputError(error("file.no_permission", file=str(path), kind=kind)) from failure
    except (OSError, ValueError):  # a name that is too long, or has a null character
        exists = False
    if not exists:
        raise InputError(error("file.not_found", file=str(path), kind=kind))
    if not path.is_file():
        raise InputError(_not_a_file_message(path, kind))
    if not os.access(path, os.R_OK):
        raise InputError(error("file.no_permission", file=str(path), kind=kind))
    try:
        require_uncompressed(path, text=True)
    except OSError as failure:
        reason = system_reason(failure)
        raise InputError(error("file.not_readable", file=str(path), reason=reason)) from failure
    return path


def _not_a_file_message(path: Path, kind: Message | str) -> Message:
    """Message that a path is a folder or another thing instead of a file."""
    if path.is_fifo():
        return error("file.pipe", file=str(path), kind=kind)
    if path.is_socket():
        return error("file.socket", file=str(path), kind=kind)
    if path.is_char_device():
        return error("file.device", file=str(path), kind=kind)
    if path.is_block_device():
        return error("file.disk", file=str(path), kind=kind)
    return error("file.folder", file=str(path), kind=kind)


@contextmanager
def library_path(path: Path, ending: str = "") -> Iterator[Path]:
    """Yield a path with a UTF-8 name or a given ending, for libraries that require it.

    Parameters
    ----------
    ending : str
        Required file name ending, lower case with the dot; empty for any ending.
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
        except OSError:  # Windows requires a privilege to create links
            shutil.copyfile(path, link)
        yield link


def read_records(
    path: Path, columns: int, what: str, *, byte_order: str = "<"
) -> NDArray[np.float64]:
    """Read a file of float64 records, little-endian (``<``) by default or big-endian (``>``).

    Returns
    -------
    ndarray of shape (n, columns)

    Raises
    ------
    InputError
        If the file is missing, empty or cut short, or contains values that are not numbers or are
        impossibly large.
    """
    require_file(path, what)
    size, record, kind = path.stat().st_size, 8 * columns, file_kind_message(what)
    if size == 0:
        raise InputError(error("file.empty", file=str(path), kind=kind))
    if size % record:
        raise InputError(
            error(
                "file.partial_record", file=str(path), kind=kind, size=size, record=record,
                rest=size % record,
            )
        )  # fmt: skip
    try:
        records = np.fromfile(path, dtype=f"{byte_order}f8").reshape(-1, columns)
    except (OSError, ValueError, MemoryError) as failure:
        raise InputError(
            error("file.not_readable", file=str(path), reason=failure_reason(failure))
        ) from failure
    require_numbers(records, path, what)
    return records.astype(np.float64, copy=False)


def require_numbers(records: NDArray[np.float64], path: Path, what: str) -> None:
    """Refuse records with NaN, infinite or impossibly large values.

    Parameters
    ----------
    records : ndarray of shape (n, k)
        In the order of the file; ``what`` names its kind in messages.

    Raises
    ------
    InputError
        If a record contains such a value.
    """
    if records.size and records.min() >= -MAX_QUANTITY and records.max() <= MAX_QUANTITY:
        return
    kind = file_kind_message(what)
    bad = ~np.isfinite(records).all(axis=1)
    if bad.any():
        first, count = int(np.argmax(bad)) + 1, int(bad.sum())
        raise InputError(
            error("file.record_not_finite", file=str(path), kind=kind, record=first, count=count)
        )
    huge = (np.abs(records) > MAX_QUANTITY).any(axis=1)
    if huge.any():
        first = int(np.argmax(huge)) + 1
        raise InputError(error("file.record_too_large", file=str(path), kind=kind, record=first))


def require_increasing(
    time: NDArray[np.float64], path: Path, what: str, numbers: NDArray[np.int64] | None = None
) -> None:
    """Refuse times that do not strictly increase.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    what : str
        Kind of the file, for messages: ``SBET``.
    numbers : ndarray of shape (n,), optional
        Row in the file of each time, if it differs from the index of the time.

    Raises
    ------
    InputError
        If a time is not later than the one before.
    """
    quality = assess_times(time)
    if quality.first_disorder is None:
        return
    k, file, kind = quality.first_disorder, str(path), file_kind_message(what)
    row = None if numbers is None else int(numbers[k])
    if quality.resolution is not None:
        step = quality.resolution
        if row is not None:
            raise InputError(error("file.time_steps_row", file=file, row=row, step=step))
        raise InputError(
            error("file.time_steps_record", file=file, kind=kind, record=k + 1, step=step)
        )
    before, after, total = float(time[k - 1]), float(time[k]), len(time)
    repeated, backward = quality.duplicates, quality.backward
    if row is not None:
        raise InputError(
            error(
                "file.time_order_row", file=file, row=row, before=before, after=after, total=total,
                repeated=repeated, backward=backward,
            )
        )  # fmt: skip
    raise InputError(
        error(
            "file.time_order_record", file=file, kind=kind, record=k + 1, before=before,
            after=after, total=total, repeated=repeated, backward=backward,
        )
    )  # fmt: skip


def message_with_file_name(failure: LispacError, path: Path) -> Message:
    """Message of an error about a file, with the name of the file instead of its path."""
    name = printable(path.name)
    message = failure.message
    if message is None:
        return error("file.refused", file=name, reason=str(failure))
    if message.params.get("file") != str(path):
        return message
    return replace(message, params={**message.params, "file": name})


TEMPORARY_NAME_PART = ".part"
"""Part of the temporary name of a file that is being written, before its suffix."""


@contextmanager
def atomic_write(path: Path) -> Iterator[Path]:
    """Yield a temporary name beside ``path``; rename it to ``path`` if no error occurs.

    After an error, the temporary file and the folders created for it are removed.

    Raises
    ------
    InputError
        If the folder cannot be written, the disk is full, or ``path`` is a folder or a device.
    """  # noqa: DOC501 - `write_error` makes an InputError
    path = Path(path)
    new_folders: list[Path] = []
    try:
        new_folders = [folder for folder in path.parents if not folder.exists()]
        if path.exists() and not path.is_file():
            code = "file.is_folder" if path.is_dir() else "file.is_device"
            raise InputError(error(code, file=str(path)))
        remove_abandoned_files(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(
            prefix=f".{path.stem}-", suffix=f"{TEMPORARY_NAME_PART}{path.suffix}", dir=path.parent
        )
    except ValueError as failure:
        raise bad_name_error(path) from failure
    except OSError as failure:
        remove_empty_folders(new_folders)
        raise write_error(path, failure) from failure
    temporary = Path(name)
    # The lock tells other programs that the file is in use. Windows cannot rename open files.
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
        raise write_error(path, failure) from failure
    finally:
        temporary.unlink(missing_ok=True)
        if handle >= 0:
            os.close(handle)
        remove_empty_folders(new_folders)


ABANDONED_AFTER_S, UNLOCKED_ABANDONED_AFTER_S = 60.0, 5.0
"""Seconds without a change after which a temporary file is considered abandoned: if locks cannot be
checked, and if the file is not locked (a program that writes a file locks it within this time, also
on a busy machine)."""


def remove_abandoned_files(path: Path) -> None:
    """Remove the temporary files that interrupted writing left beside ``path``."""
    named = re.compile(
        rf"\.{re.escape(path.stem)}-[a-z0-9_]{{8}}{TEMPORARY_NAME_PART}{re.escape(path.suffix)}"
    )
    try:
        with os.scandir(path.parent) as entries:
            found = [entry for entry in entries if named.fullmatch(entry.name)]
        for entry in found:
            age = time.time() - entry.stat(follow_symlinks=False).st_mtime
            if entry.is_file(follow_symlinks=False) and age > _abandonment_delay(Path(entry.path)):
                os.unlink(entry.path)
    except OSError:
        return  # the folder is read-only, or another program removed the file first


def _abandonment_delay(path: Path) -> float:
    """Seconds without a change after which a temporary file is considered abandoned."""
    locked = None if sys.platform == "win32" else is_locked(path)
    return {True: math.inf, False: UNLOCKED_ABANDONED_AFTER_S, None: ABANDONED_AFTER_S}[locked]


def bad_name_error(path: Path) -> InputError:
    """Make the error of a file name with a null character or an unpaired surrogate."""
    return InputError(error("file.bad_name", file=repr(str(path))))


def write_error(path: Path, failure: OSError) -> InputError:
    """Make the error of a file that cannot be written."""
    reason = system_reason(failure)
    if failure.errno in (errno.ENOSPC, errno.EDQUOT):
        return InputError(error("file.disk_full", file=str(path)))
    return InputError(error("file.not_writable", file=str(path), reason=reason))


def remove_empty_folders(folders: list[Path]) -> None:
    """Remove empty folders, the innermost first, up to the first that is not empty."""
    for folder in folders:
        try:
            folder.rmdir()
        except (OSError, ValueError):  # it is not empty, or its name is not valid
            return
