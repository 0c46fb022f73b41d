"""One import of a line at a time, whoever starts it."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from lispac.errors import InputError, ProjectError
from lispac.locks import AlreadyLocked, NotALockFile, file_lock, is_locked
from lispac.messages import error

LOCK = ".importing"


@contextmanager
def lock_folder(folder: Path) -> Iterator[None]:
    """Hold the folder of a line; the system releases it when the process ends in any way.

    Raises
    ------
    ProjectError
        If the line is being imported already.
    InputError
        If the lock file is a link or a folder.
    """
    try:
        with file_lock(folder / LOCK):
            yield
    except AlreadyLocked as failure:
        raise ProjectError(error("store.locked", folder=str(folder))) from failure
    except NotALockFile as failure:
        raise InputError(error("lock.not_a_file", file=str(folder / LOCK))) from failure


def is_import_running(folder: Path) -> bool:
    """Whether the line is being imported at the moment."""
    return bool(is_locked(folder / LOCK))
