"""Numba's decorator ``njit``, with a cache in which no code is older than the program.

Numba makes the machine code of a function again when the file of this function changes, not when a
function or constant that was compiled into it does and lies in another file [1]_. After an update
of the program, such code would go on computing as before the update. The cache has therefore one
folder for each state of the source files; folders that no run has used for a month are removed.

References
----------
.. [1] https://numba.readthedocs.io/en/stable/user/jit.html#cache
"""

import hashlib
import os
import shutil
import time
from contextlib import suppress
from functools import partial
from pathlib import Path

from numba import config, njit

from lispac import __version__

__all__ = ["kernel", "njit"]

kernel = partial(
    njit, nogil=True, cache=True, error_model="numpy",
    fastmath={"contract", "reassoc", "nsz", "arcp"},
)  # fmt: skip
"""Decorator of what is compiled for a pass over all points; NumPy's way with errors and sums in any
order halve its time."""

PACKAGES = (
    "adjustment", "geometry", "io", "natural", "simulation", "survey", "targets", "validation",
)  # fmt: skip
"""Packages with compiled functions."""
MARK = b"lispac.compiled_code"
"""Text in the import of each file with compiled functions."""
PREFIX = "sources-"
UNUSED_S = 30 * 86_400.0


def source_state(folder: Path) -> str:
    """Hexadecimal digest of the contents of all files with compiled functions.

    Parameters
    ----------
    folder : Path
        Folder of the package `lispac`; a bundle has no source files but a version.
    """
    state = hashlib.blake2b(__version__.encode(), digest_size=8)
    for package in PACKAGES:
        for place, folders, names in os.walk(folder / package):
            folders.sort()
            for name in sorted(names):
                if name.endswith(".py"):
                    content = Path(place, name).read_bytes()
                    if MARK in content:
                        state.update(content)
    return state.hexdigest()


def cache_folder(parent: Path, state: str) -> Path:
    """Folder of the cache for one state of the sources, marked as used; old ones are removed."""
    folder = parent / f"{PREFIX}{state}"
    is_new = not folder.is_dir()
    with suppress(OSError):  # without the cache everything is compiled, which Numba sees to
        folder.mkdir(parents=True, exist_ok=True)
        os.utime(folder)
    if is_new:
        with suppress(OSError):
            for other in parent.glob(f"{PREFIX}*"):
                if time.time() - other.stat().st_mtime > UNUSED_S and not other.is_symlink():
                    shutil.rmtree(other, ignore_errors=True)
    return folder


def _set_cache_folder() -> None:
    """Set the folder in Numba, and in the environment, from which Numba may read it again."""
    # Set by the entry points; a module imported alone has its cache beside its byte code.
    parent = Path(config.CACHE_DIR or Path(__file__).with_name("__pycache__"))
    if parent.name.startswith(PREFIX):  # set by the process that started this one
        parent = parent.parent
    folder = str(cache_folder(parent, source_state(Path(__file__).parent)))
    os.environ["NUMBA_CACHE_DIR"] = config.CACHE_DIR = folder


_set_cache_folder()
