"""What takes long to make is made by one process of a run and found by the others."""

import os
import pickle
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pytest

Made = TypeVar("Made")


def once(
    factory: pytest.TempPathFactory, name: str, make: Callable[[Path], Made], *, pause: float = 0.1
) -> Made:
    """What ``make`` gives for a folder: called in the process that asks first, once a run.

    The others wait for it. Where it fails, the next one tries, and so fails as well.

    Parameters
    ----------
    name : str
        Of the folder, which ``make`` may make; every process is given the same.
    make : callable
        Its answer goes to the other processes as a file.
    pause : float, seconds
        Between two looks at whether the other process is done.
    """
    root = factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        root = root.parent
    answer, making = root / f"{name}.made", root / f"{name}.making"
    while not answer.is_file():
        try:
            making.mkdir()
        except FileExistsError:
            time.sleep(pause)
            continue
        try:
            if not answer.is_file():  # the other process was done between the two looks
                made = make(root / name)
                whole = root / f"{name}.writing"
                whole.write_bytes(pickle.dumps(made))
                whole.replace(answer)
                return made
        finally:
            making.rmdir()
    return pickle.loads(answer.read_bytes())  # type: ignore[no-any-return]
