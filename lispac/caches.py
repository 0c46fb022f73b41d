"""Cache of files that the program can create again.

These are the manual, compiled code, and matplotlib's list of fonts. The user can choose the folder,
which the window and the command line share. If it cannot be written to, for example in a missing or
read-only home directory, a temporary folder is used instead. Only files created by the program are
ever removed from the cache.
"""

import os
import shutil
import sys
from collections.abc import MutableMapping
from contextlib import suppress
from functools import cache
from pathlib import Path

from lispac.errors import InputError, system_reason
from lispac.installation_paths import home_folder, temporary_folder, user_folder
from lispac.messages import Level, Message, error

CHOSEN_FOLDER_FILE = "cache-folder.txt"
"""Name of the file with the path of the chosen folder, in `user_folder`."""
CACHE_FOLDER_NAME = "lispac"
"""Name of the cache folder within the chosen or default folder."""
MANUAL_FOLDER, MANUAL_MARKER_FILE = "manual", "made-by-lispac"
"""Folder of the built manual within the cache folder, and the file that marks it as created by
this program."""
CACHE_VARIABLES = {"NUMBA_CACHE_DIR": "numba", "MPLCONFIGDIR": "matplotlib"}
"""Subfolder for the cache of another package, by the environment variable that sets its path."""


def default_folder() -> Path:
    """Folder in which programs of the user have their caches on this system."""
    home = home_folder()
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", home / "AppData" / "Local")) / "cache"
    if sys.platform == "darwin":
        return home / "Library" / "Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or home / ".cache")


def chosen_folder(config: Path | None = None) -> Path | None:
    """Folder chosen by the user for the cache; None if the default one is used.

    Parameters
    ----------
    config : Path or None
        Folder of the user's files for all projects, if it is not `user_folder`.
    """
    try:
        text = ((config or user_folder()) / CHOSEN_FOLDER_FILE).read_text(encoding="utf-8").strip()
    except (OSError, UnicodeDecodeError):
        return None
    return Path(text) if text else None


def cache_folder_in(folder: Path | None) -> Path:
    """Cache folder of the program inside a chosen folder, or inside the default one for None."""
    return (folder or default_folder()) / CACHE_FOLDER_NAME


def usable_cache_folder(config: Path | None = None) -> Path:
    """Chosen cache folder, or a temporary one if it cannot be written to."""
    return writable_or_temporary_folder(cache_folder_in(chosen_folder(config)))


def writable_or_temporary_folder(place: Path) -> Path:
    """Return a folder if it can be written to, which is tested once; otherwise a temporary one."""
    return place if _is_writable(place) else temporary_folder()


@cache
def _is_writable(place: Path) -> bool:
    home = home_folder()
    if place.is_relative_to(home) and not home.is_dir():
        return False  # the program does not create home directories
    try:
        _try_writing(place)
    except OSError:
        return False
    return True


def _try_writing(place: Path) -> None:
    """Create a folder and a file in it, and remove the file.

    Raises
    ------
    OSError
        If it cannot be written to.
    """
    place.mkdir(parents=True, exist_ok=True)
    trial = place / f".trial-{os.getpid()}"
    trial.write_bytes(b"")
    trial.unlink()


def require_writable(folder: Path) -> None:
    """Refuse a folder to which the cache cannot be written.

    Raises
    ------
    InputError
        If the folder cannot be created or written to.
    """
    place, present = cache_folder_in(folder), folder.is_dir()
    try:
        _try_writing(place)
    except OSError as failure:
        reason = system_reason(failure)
        raise InputError(
            error("cache.folder_not_writable", folder=str(folder), reason=reason)
        ) from failure
    finally:
        with suppress(OSError):
            place.rmdir()
            if not present:
                folder.rmdir()


def choose_folder(folder: Path | None, config: Path | None = None) -> None:
    """Set the cache folder, None for the default one; existing files remain.

    Raises
    ------
    InputError
        If the folder cannot be written to.
    """
    from lispac.io.files import atomic_write

    if folder == chosen_folder(config):
        return
    if folder is not None:
        require_writable(folder)
    with atomic_write((config or user_folder()) / CHOSEN_FOLDER_FILE) as path:
        path.write_text("" if folder is None else f"{folder}\n", encoding="utf-8")


def cache_size(place: Path) -> int:
    """Size of the program's files in the cache, in bytes."""
    found = 0
    for part in _cache_parts(place):
        for folder, _, names in os.walk(part):
            for name in names:
                with suppress(OSError):
                    found += os.lstat(os.path.join(folder, name)).st_size
    return found


def empty_cache(place: Path) -> None:
    """Remove the program's files from the cache, and nothing else.

    Raises
    ------
    InputError
        If a file could not be removed.
    """
    for part in _cache_parts(place):
        try:
            shutil.rmtree(part)
        except OSError as failure:
            reason = system_reason(failure)
            raise InputError(
                error("cache.not_removed", folder=str(part), reason=reason)
            ) from failure


def set_cache_variables(variables: MutableMapping[str, str]) -> Message | None:
    """Set the cache folders of other packages unless they are set to a usable folder.

    Parameters
    ----------
    variables : mutable mapping of str to str
        The environment of this process, which is changed.

    Returns
    -------
    Message or None
        A note if a temporary folder is used because the intended one cannot be written to.
    """
    folder = cache_folder_in(chosen_folder())
    place = usable_cache_folder()
    refused = [] if place == folder else [folder]
    for variable, part in CACHE_VARIABLES.items():
        current = variables.get(variable)
        if current and not _may_be_written(Path(current)):
            refused.append(Path(current))
            current = ""
        variables[variable] = current or str(place / part)
    if not refused:
        return None
    return Message(
        "cache.not_writable", Level.NOTE, {"folder": str(refused[0]), "used": str(place)}
    )


def _may_be_written(folder: Path) -> bool:
    """True if a folder can presumably be written to; it need not exist."""
    folder = folder.absolute()
    there = next(each for each in (folder, *folder.parents) if os.path.exists(each))
    return os.path.isdir(there) and os.access(there, os.W_OK | os.X_OK)


def _cache_parts(place: Path) -> list[Path]:
    parts = [place / part for part in CACHE_VARIABLES.values()]
    if (place / MANUAL_FOLDER / MANUAL_MARKER_FILE).is_file():
        parts.append(place / MANUAL_FOLDER)
    return [part for part in parts if part.is_dir() and not part.is_symlink()]
