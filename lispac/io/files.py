"""Opening files with plain errors, and writing them so that a crash leaves no half."""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError


def require_file(path: Path, what: str) -> Path:
    """Give the path back where it is a file that can be read; ``what`` names its role.

    Raises
    ------
    InputError
    """
    path = Path(path)
    if not path.exists():
        raise InputError(f"{path}: there is no such {what} file; check the path.")
    if not path.is_file():
        raise InputError(f"{path}: this is a folder, not a {what} file.")
    if not os.access(path, os.R_OK):
        raise InputError(f"{path}: this {what} file cannot be read; check its permissions.")
    return path


def read_records(path: Path, columns: int, what: str) -> NDArray[np.float64]:
    """Read a file of little-endian float64 records.

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
    records = np.fromfile(path, dtype="<f8").reshape(-1, columns)
    bad = ~np.isfinite(records).all(axis=1)
    if bad.any():
        raise InputError(
            f"{path}: {what} record {int(np.argmax(bad)) + 1:,} holds a value that is not a "
            f"number ({int(bad.sum()):,} such records); export it again."
        )
    return records.astype(np.float64, copy=False)


def require_increasing(time: NDArray[np.float64], path: Path, what: str) -> None:
    """Refuse times that stand still or run backwards.

    Raises
    ------
    InputError
    """
    steps = np.diff(time)
    if (steps <= 0).any():
        k = int(np.argmax(steps <= 0)) + 1
        raise InputError(
            f"{path}: time runs from {time[k - 1]:.6f} to {time[k]:.6f} s at {what} record "
            f"{k + 1:,}; times must increase: sort the file or export it again."
        )


@contextmanager
def written_whole(path: Path) -> Iterator[Path]:
    """Yield a temporary name beside ``path`` and rename it to ``path`` when all went well.

    Raises
    ------
    InputError
        Where the folder cannot be written.
    """
    path = Path(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(
            prefix=f".{path.stem}-", suffix=path.suffix, dir=path.parent
        )
        os.close(handle)
    except OSError as error:
        raise InputError(
            f"{path}: cannot be written ({error.strerror}); choose another folder."
        ) from error
    temporary = Path(name)
    try:
        yield temporary
        # mkstemp makes files private; give the result the permissions of any new file.
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        temporary.replace(path)
    except OSError as error:
        raise InputError(f"{path}: cannot be written ({error.strerror}).") from error
    finally:
        temporary.unlink(missing_ok=True)
