"""Lock of the folder of a line: only one process can import the line at a time."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from lispac.errors import InputError, ProjectError
from lispac.locks import AlreadyLocked, NotALockFile, file_lock, is_locked
from lispac.messages import error

LOCK_FILE = ".importing"


@contextmanager
def lock_folder(folder: Path) -> Iterator[None]:
    """Lock the folder of a line; the operating system removes the lock if the process ends.

    Raises
    ------
    ProjectError
        If the line is already being imported.
    InputError
        If the lock file is a link or a folder.
    """
    try:
        with file_lock(folder / LOCK_FILE):
            yield
    except AlreadyLocked as failure:
        raise ProjectError(error("store.locked", folder=str(folder))) from failure
    except NotALockFile as failure:
        raise InputError(error("lock.not_a_file", file=str(folder / LOCK_FILE))) from failure


def is_import_running(folder: Path) -> bool:
    """Whether the line is being imported at the moment."""
    return bool(is_locked(folder / LOCK_FILE))
