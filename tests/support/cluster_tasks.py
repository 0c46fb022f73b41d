"""Tasks that tests give to the processes of a pool or cluster, which import only this module."""

import os
import signal
import sys
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from lispac.errors import LispacError


def kill_process_once(marker: Path, number: int) -> int:
    """Square of a number; the first call with 7 kills its process."""
    if number == 7:
        with suppress(FileExistsError):
            os.close(os.open(marker, os.O_CREAT | os.O_EXCL))
            os.kill(os.getpid(), signal.SIGTERM if sys.platform == "win32" else signal.SIGKILL)
    return number**2


def kill_process_always(number: int) -> int:
    """Square of a number; each call with 7 ends its process."""
    if number == 7:
        os._exit(1)
    return number**2


def raise_correctable_error(number: int) -> int:
    """Raise an error that the user can correct."""
    raise LispacError(f"number {number} is too large")


@dataclass
class Slow:
    """A slow task that creates a file for each call."""

    folder: Path

    def __call__(self, number: int) -> int:
        (self.folder / str(number)).touch()
        time.sleep(0.2)
        return number
