"""Locks between processes: one writer at a time for a folder.

A lock is held on an open file by the operating system (``flock``, ``msvcrt.locking``), which
releases it when the process ends in any way: there are no stale locks. On network folders the
server holds it, so that it works between computers. On a file system without locks nothing is
locked; `lispac.io.project.project_file` then still refuses to overwrite what was written meanwhile.
"""

import errno
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

POLL_INTERVAL = 0.05
"""Seconds between two attempts to get a lock."""
UNSUPPORTED = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP}


class AlreadyLocked(Exception):
    """Error that another holder has the lock."""


class NotALockFile(Exception):
    """Error that a link or a folder has the name of the lock file."""


@contextmanager
def file_lock(
    path: Path, *, wait: float = 0.0, waiting: Callable[[], None] = lambda: None
) -> Iterator[None]:
    """Hold a lock file, which is made for it and removed afterwards.

    Parameters
    ----------
    wait : float
        Seconds to wait for another holder; may be infinite.
    waiting : callable
        Called once when it has to wait.

    Raises
    ------
    AlreadyLocked
        Where it is still held after that time, by this process or another.
    NotALockFile
        Where a link or a folder has the name of the lock file.
    OSError
        Where the file cannot be made.
    """
    handle = _acquire_lock(path, time.monotonic() + wait, waiting)
    try:
        yield
    finally:
        if sys.platform != "win32":  # there an open file cannot be removed
            path.unlink(missing_ok=True)
        os.close(handle)


def _acquire_lock(path: Path, until: float, waiting: Callable[[], None]) -> int:
    """An open handle of the lock file, locked.

    Raises
    ------
    AlreadyLocked
        If another process holds the lock.
    NotALockFile
        If the path is a link or no regular file.
    OSError
        If the file cannot be opened.
    """
    while True:
        try:
            # No link is followed: it could lead to another place where a file would be made.
            handle = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except OSError:
            if path.is_symlink() or path.is_dir():
                raise NotALockFile(str(path)) from None
            raise
        try:
            _lock(handle)
        except OSError as failure:
            if failure.errno in UNSUPPORTED:
                return handle
            os.close(handle)
            if time.monotonic() >= until:
                raise AlreadyLocked(str(path)) from failure
            waiting()
            waiting = _do_nothing
            time.sleep(POLL_INTERVAL)
            continue
        # The last holder may have removed the file between the two steps.
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
        return None if failure.errno in UNSUPPORTED else True
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
