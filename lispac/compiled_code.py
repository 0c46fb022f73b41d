"""Numba's decorator ``njit``, imported at the first call, with a cache that can be copied.

The import of Numba takes longer than that of most of the program, so that a module with compiled
functions imports it only when one of them is called.

Numba recompiles a function if the source file of this function changes, but not if a function or
constant that it uses changes in another file [1]_. After an update of the program, the cache could
therefore contain outdated machine code. To prevent this, the cache has a separate folder for each
state of the source files. Folders that have not been used for a month are removed.

Functions are compiled for a group of processors instead of this one (`portable_processor`), and the
cache does not depend on the path of the program. A cache made when the program is packaged is
therefore valid on other computers, and results are the same on all processors of the group.

References
----------
.. [1] https://numba.readthedocs.io/en/stable/user/jit.html#cache
"""

import hashlib
import os
import platform
import shutil
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from functools import cache, partial, update_wrapper
from pathlib import Path
from types import ModuleType
from typing import Any

from lispac.computing_time import compilation_timer
from lispac.version import __version__

__all__ = ["kernel", "njit"]


class CompiledFunction:
    """Function that is compiled by Numba when it is called, or read from the cache.

    Other compiled functions can call it. It has the attributes of Numba's dispatcher.

    Parameters
    ----------
    function : callable
    options : dict
        Options of ``numba.njit``.
    """

    def __init__(self, function: Callable[..., Any], options: dict[str, Any]) -> None:
        update_wrapper(self, function)
        self._options = options
        self._dispatcher: Any = None

    def __call__(self, *arguments: Any) -> Any:
        """Call the compiled function."""
        return (self._dispatcher or self.dispatcher)(*arguments)

    def __getattr__(self, name: str) -> Any:
        """Attribute of Numba's dispatcher."""
        return getattr(self.dispatcher, name)

    @property
    def dispatcher(self) -> Any:
        """Numba's dispatcher of this function."""
        with _dispatcher_lock:
            if self._dispatcher is None:
                self._dispatcher = _numba().njit(**self._options)(self.__wrapped__)
        return self._dispatcher


_dispatcher_lock = threading.RLock()


def njit(function: Callable[..., Any] | None = None, **options: Any) -> Any:
    """Decorator of compiled functions, with the options of ``numba.njit``."""
    if function is None:
        return partial(CompiledFunction, options=options)
    return CompiledFunction(function, options)


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
IMPORT_TEXT = b"from lispac.compiled_code import"
"""Text that the import statement of every file with compiled functions contains."""
FOLDER_PREFIX = "sources-"
"""Beginning of the name of each cache folder, before the digest of the sources."""
PACKAGED_CODE = "resources/compiled"
"""Cache folders that were made when the program was packaged, relative to the package's parent."""
LOCATORS = (
    "lispac.compiled_code_locator.SourceStateLocator", "UserProvidedCacheLocator",
    "InTreeCacheLocator", "UserWideCacheLocator", "IPythonCacheLocator",
)  # fmt: skip
"""Classes that find the place of a function in the cache, the first suitable one is used: for the
functions of this program, then those of Numba for functions of others."""
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
    """Cache folder for one state of the sources, marked as used; old folders are removed.

    A new folder starts with the code that was compiled when the program was packaged.
    """
    folder = parent / f"{FOLDER_PREFIX}{state}"
    is_new = not folder.is_dir()
    with suppress(OSError):  # without the cache, Numba compiles all functions again
        if is_new:
            _copy_packaged_code(folder)
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


def current_cache_folder() -> Path:
    """Cache folder of this process."""
    return Path(_numba().config.CACHE_DIR)


def _copy_packaged_code(folder: Path) -> None:
    packaged = Path(__file__).parents[1] / PACKAGED_CODE / folder.name
    if not packaged.is_dir():
        return
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as draft:
        copy = Path(draft) / "copy"
        shutil.copytree(packaged, copy)
        copy.rename(folder)  # fails if another process has been faster


def portable_processor(machine: str, system: str, features: dict[str, bool]) -> str | None:
    """LLVM name of the processors for which functions are compiled; None for this one alone.

    Parameters
    ----------
    machine, system : str
        Architecture, as from `platform.machine`, and ``sys.platform``.
    features : dict of str to bool
        Instruction sets of this processor by their LLVM names.
    """
    if machine.lower() in {"x86_64", "amd64"} and features.get("avx2") and features.get("fma"):
        return "x86-64-v3"  # Intel since 2013, AMD since 2015
    if machine.lower() == "arm64" and system == "darwin":
        return "apple-m1"
    return None


@cache
def _numba() -> ModuleType:
    """Numba with the settings of this program."""
    compilation_timer.start()
    try:
        return _configured_numba()
    finally:
        compilation_timer.end()


def _configured_numba() -> ModuleType:
    import numba
    from llvmlite import binding as llvm
    from numba import config
    from numba.core import event
    from numba.extending import typeof_impl

    # Both are set in the environment too, which Numba reads again after changes
    processor = portable_processor(
        platform.machine(), sys.platform, dict(llvm.get_host_cpu_features())
    )
    if config.CPU_NAME is None and processor is not None:
        os.environ["NUMBA_CPU_NAME"] = config.CPU_NAME = processor
        os.environ["NUMBA_CPU_FEATURES"] = config.CPU_FEATURES = ""
    # The entry points set the folder. If a module is imported without them, the cache is in the
    # folder of the byte code.
    parent = Path(config.CACHE_DIR or Path(__file__).with_name("__pycache__"))
    if parent.name.startswith(FOLDER_PREFIX):  # set by the process that started this one
        parent = parent.parent
    folder = str(cache_folder(parent, source_state(Path(__file__).parent)))
    os.environ["NUMBA_CACHE_DIR"] = config.CACHE_DIR = folder
    locators = ",".join(LOCATORS)
    os.environ["NUMBA_CACHE_LOCATOR_CLASSES"] = config.CACHE_LOCATOR_CLASSES = locators

    @typeof_impl.register(CompiledFunction)
    def _type_of_function(function: CompiledFunction, _context: Any) -> Any:
        return numba.types.Dispatcher(function.dispatcher)

    class CompilationListener(event.Listener):  # type: ignore[misc]
        def on_start(self, event: Any) -> None:
            compilation_timer.start()

        def on_end(self, event: Any) -> None:
            compilation_timer.end()

    event.register("numba:compile", CompilationListener())
    return numba
