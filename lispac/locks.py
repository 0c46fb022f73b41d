"""Locks between processes: one writer at a time for a folder.

The operating system holds a lock on an open file (``flock``, ``msvcrt.locking``) and releases it
when the process ends for any reason, so that there are no stale locks. On network folders the
server holds the lock, which therefore works between computers. On a file system without locks
nothing is locked; `lispac.io.project.project_file` still refuses to overwrite a project that
another program has changed.
"""

import errno
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

POLL_INTERVAL_S = 0.05
"""Seconds between two attempts to get a lock."""
NO_LOCK_SUPPORT_ERRNOS = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP}
"""Error numbers of a lock on a file system without locks."""


class AlreadyLocked(Exception):
    """The lock is held by another process or thread."""


class NotALockFile(Exception):
    """A link or a folder has the name of the lock file."""


@contextmanager
def file_lock(
    path: Path, *, wait: float = 0.0, waiting: Callable[[], None] = lambda: None
) -> Iterator[None]:
    """Hold a lock in a ``with`` block; the lock file is created, and removed except on Windows.

    Parameters
    ----------
    wait : float
        Seconds to wait while another process or thread holds the lock; may be infinite.
    waiting : callable
        Called once if the lock is not available immediately.

    Raises
    ------
    AlreadyLocked
        If the lock is still held after that time, by this process or another one.
    NotALockFile
        If a link or a folder has the name of the lock file.
    OSError
        If the file cannot be created.
    """
    handle = _acquire_lock(path, time.monotonic() + wait, waiting)
    try:
        yield
    finally:
        if sys.platform != "win32":  # an open file cannot be removed on Windows
            path.unlink(missing_ok=True)
        os.close(handle)


def _acquire_lock(path: Path, until: float, waiting: Callable[[], None]) -> int:
    """Open the lock file, lock it, and return its handle.

    Raises
    ------
    AlreadyLocked
        If another process or thread still holds the lock at the time ``until``.
    NotALockFile
        If the path is a link or a folder.
    OSError
        If the file cannot be opened.
    """
    while True:
        try:
            # Links are not followed: a file could be created in another folder.
            handle = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except OSError:
            if path.is_symlink() or path.is_dir():
                raise NotALockFile(str(path)) from None
            raise
        try:
            _lock(handle)
        except OSError as failure:
            if failure.errno in NO_LOCK_SUPPORT_ERRNOS:
                return handle
            os.close(handle)
            if time.monotonic() >= until:
                raise AlreadyLocked(str(path)) from failure
            waiting()
            waiting = _do_nothing
            time.sleep(POLL_INTERVAL_S)
            continue
        # The previous holder may have removed the file between opening and locking.
        try:
            if os.path.samestat(os.fstat(handle), path.stat()):
                return handle
        except FileNotFoundError:
            pass
        os.close(handle)


def _do_nothing() -> None:
    pass


def try_lock(handle: int) -> bool:
    """Try to lock an open file, and return whether it is locked; closing it unlocks it."""
    try:
        _lock(handle)
    except OSError:
        return False
    return True


def is_locked(path: Path) -> bool | None:
    """True if a lock file is held; None if its file system has no locks."""
    try:
        handle = os.open(path, os.O_RDWR | getattr(os, "O_NOFOLLOW", 0))
    except OSError:
        return False
    try:
        _lock(handle)
    except OSError as failure:
        return None if failure.errno in NO_LOCK_SUPPORT_ERRNOS else True
    finally:
        os.close(handle)
    return False


if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> None:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)

else:
    import fcntl

    def _lock(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
