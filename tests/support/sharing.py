"""Test data that one process of a run makes and the other processes reuse."""

import os
import pickle
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pytest

Made = TypeVar("Made")


def make_once(
    factory: pytest.TempPathFactory, name: str, make: Callable[[Path], Made], *, pause: float = 0.1
) -> Made:
    """Result of ``make`` for a folder, computed once a run by the first process that needs it.

    The other processes wait. If ``make`` fails, the next process tries again, and fails too.

    Parameters
    ----------
    name : str
        Name of the folder, which ``make`` may create; the same for all processes.
    make : callable
        Its result is given to the other processes in a file.
    pause : float, seconds
        Between two checks whether the other process is done.
    """
    root = factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        root = root.parent
    result_path, making = root / f"{name}.made", root / f"{name}.making"
    while not result_path.is_file():
        try:
            making.mkdir()
        except FileExistsError:
            time.sleep(pause)
            continue
        try:
            if not result_path.is_file():  # the other process finished between the two checks
                made = make(root / name)
                whole = root / f"{name}.writing"
                whole.write_bytes(pickle.dumps(made))
                whole.replace(result_path)
                return made
        finally:
            making.rmdir()
    return pickle.loads(result_path.read_bytes())  # type: ignore[no-any-return]
