"""Lock of a project folder, and the digest by which changes by other programs are detected."""

import hashlib
import math
import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from lispac.errors import InputError, ProjectError
from lispac.io.files import write_error
from lispac.locks import AlreadyLocked, NotALockFile, file_lock
from lispac.messages import error

PROJECT_FILE_NAME = "project.json"
LOCK_NAME = ".project.lock"
SAVE_WAIT_S = 2.0
"""Seconds that a save waits for another program."""
NO_TIME_LIMIT = math.inf

_lock_counts: dict[tuple[str, int], int] = {}
"""Number of times that each thread of this process holds the lock of each project."""


@contextmanager
def project_lock(
    folder: Path, *, wait: float = SAVE_WAIT_S, waiting: Callable[[], None] = lambda: None
) -> Iterator[None]:
    """Lock a project folder for writing; a thread that holds the lock can acquire it again.

    Parameters
    ----------
    wait : float
        Seconds to wait for another program that holds it.
    waiting : callable
        Called once if the lock is not free.

    Raises
    ------
    ProjectError
        If another program still holds the lock after that time.
    InputError
        If the folder cannot be written, or the lock file is a link or a folder.
    """  # noqa: DOC501 - `write_error` makes an InputError
    key = os.path.realpath(folder), threading.get_ident()
    if key in _lock_counts:
        _lock_counts[key] += 1
        try:
            yield
        finally:
            _lock_counts[key] -= 1
        return
    lock = file_lock(folder / LOCK_NAME, wait=wait, waiting=waiting)
    try:
        lock.__enter__()
    except AlreadyLocked as failure:
        raise ProjectError(error("project.locked", folder=str(folder))) from failure
    except NotALockFile as failure:
        raise InputError(error("lock.not_a_file", file=str(folder / LOCK_NAME))) from failure
    except OSError as failure:
        raise write_error(folder / PROJECT_FILE_NAME, failure) from failure
    _lock_counts[key] = 1
    try:
        yield
    finally:
        del _lock_counts[key]
        lock.__exit__(None, None, None)


def content_digest(content: bytes) -> str:
    """Digest of the content of a project file, used to detect changes."""
    return hashlib.sha256(content).hexdigest()
