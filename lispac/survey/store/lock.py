"""One import of a line at a time, whoever starts it."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from lispac.errors import ProjectError
from lispac.locks import LockTaken, file_lock, is_locked
from lispac.messages import error

LOCK = ".importing"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Hold the folder of a line; the system releases it when the process ends in any way.

    Raises
    ------
    ProjectError
        Where the line is being imported already.
    """
    try:
        with file_lock(folder / LOCK):
            yield
    except LockTaken as failure:
        raise ProjectError(error("store.locked", folder=str(folder))) from failure


def is_held(folder: Path) -> bool:
    """Whether the line is being imported at the moment."""
    return bool(is_locked(folder / LOCK))
