"""Numba's decorator ``njit``, with a cache that never contains code of an earlier version.

Numba recompiles a function if the source file of this function changes, but not if a function or
constant that it uses changes in another file [1]_. After an update of the program, the cache could
therefore contain outdated machine code. To prevent this, the cache has a separate folder for each
state of the source files. Folders that have not been used for a month are removed.

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
"""Decorator of compiled functions that process all points of a line. Division by zero is handled as
in NumPy, and floating-point operations may be reordered; this halves the computing time."""

COMPILED_PACKAGES = (
    "adjustment", "geometry", "io", "natural", "simulation", "survey", "targets", "validation",
)  # fmt: skip
"""Packages with compiled functions."""
IMPORT_TEXT = b"lispac.compiled_code"
"""Text that the import statement of every file with compiled functions contains."""
FOLDER_PREFIX = "sources-"
"""Beginning of the name of each cache folder, before the digest of the sources."""
MAX_UNUSED_TIME_S = 30 * 86_400.0
"""Time without use after which a cache folder is removed, seconds: 30 days."""


def source_state(folder: Path) -> str:
    """Hexadecimal digest of the version and of all source files with compiled functions.

    Parameters
    ----------
    folder : Path
        Folder of the package `lispac`.
    """
    state = hashlib.blake2b(__version__.encode(), digest_size=8)
    for package in COMPILED_PACKAGES:
        for place, folders, names in os.walk(folder / package):
            folders.sort()
            for name in sorted(names):
                if name.endswith(".py"):
                    content = Path(place, name).read_bytes()
                    if IMPORT_TEXT in content:
                        state.update(content)
    return state.hexdigest()


def cache_folder(parent: Path, state: str) -> Path:
    """Cache folder for one state of the sources, marked as used; old folders are removed."""
    folder = parent / f"{FOLDER_PREFIX}{state}"
    is_new = not folder.is_dir()
    with suppress(OSError):  # without the cache, Numba compiles all functions again
        folder.mkdir(parents=True, exist_ok=True)
        os.utime(folder)
    if is_new:
        with suppress(OSError):
            for other in parent.glob(f"{FOLDER_PREFIX}*"):
                if (
                    time.time() - other.stat().st_mtime > MAX_UNUSED_TIME_S
                    and not other.is_symlink()
                ):
                    shutil.rmtree(other, ignore_errors=True)
    return folder


def _set_cache_folder() -> None:
    """Set the cache folder in Numba and in the environment, which Numba may read again later."""
    # The entry points set the folder. If a module is imported without them, the cache is in the
    # folder of the byte code.
    parent = Path(config.CACHE_DIR or Path(__file__).with_name("__pycache__"))
    if parent.name.startswith(FOLDER_PREFIX):  # set by the process that started this one
        parent = parent.parent
    folder = str(cache_folder(parent, source_state(Path(__file__).parent)))
    os.environ["NUMBA_CACHE_DIR"] = config.CACHE_DIR = folder


_set_cache_folder()
