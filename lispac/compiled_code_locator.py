"""Place of compiled functions in the cache, independent of the path of the program.

Numba imports this module by its name, which is in ``NUMBA_CACHE_LOCATOR_CLASSES``.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from numba.core.caching import UserProvidedCacheLocator


class SourceStateLocator(UserProvidedCacheLocator):  # type: ignore[misc]
    """Place that depends on the module; the cache folder is for one state of all sources."""

    @classmethod
    def from_function(
        cls, py_func: Callable[..., Any], py_file: str
    ) -> UserProvidedCacheLocator | None:
        """Locator for a function of this program; None for functions of other packages."""
        if py_func.__module__.partition(".")[0] != "lispac":
            return None
        return super().from_function(py_func, py_file)

    @classmethod
    def get_suitable_cache_subpath(cls, py_file: str) -> str:
        """Subfolder for the functions of a source file."""
        return "_".join(Path(py_file).parent.relative_to(Path(__file__).parent).parts)

    def get_source_stamp(self) -> str:
        """Constant, since the cache folder changes with the sources."""
        return ""
