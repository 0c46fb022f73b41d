"""The cache: what the program can make again (built-in survey, manual, compiled code, fonts).

Its place is the user's choice, for the window and the command line alike; where that cannot be
written, as in a home directory that is missing or read-only, a temporary folder takes its place.
Nothing that the program has not put there is ever removed from it.
"""

import os
import shutil
import sys
from collections.abc import MutableMapping
from contextlib import suppress
from functools import cache
from pathlib import Path

from lispac.errors import InputError, system_reason
from lispac.installed import home_folder, temporary_folder, user_folder
from lispac.messages import Level, Message, error

CHOICE = "cache-folder.txt"
"""Beside what else the user has for all projects."""
NAME = "lispac"
"""Of our folder in the chosen one."""
DEMO = "demo"
MANUAL, MANUAL_MARK = "manual", "made-by-lispac"
"""Folder of the built manual, and the file in it that marks its owner."""
VARIABLES = {"NUMBA_CACHE_DIR": "numba", "MPLCONFIGDIR": "matplotlib"}
"""Parts of the cache that other packages fill, by the variable that sets their place."""


def usual_folder() -> Path:
    """The user's cache folder, as the system has it."""
    home = home_folder()
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", home / "AppData" / "Local")) / "cache"
    if sys.platform == "darwin":
        return home / "Library" / "Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or home / ".cache")


def chosen_folder(config: Path | None = None) -> Path | None:
    """The folder that was chosen; None for the usual one.

    Parameters
    ----------
    config : Path or None
        Folder of what the user has for all projects, where it is another than `user_folder`.
    """
    try:
        text = ((config or user_folder()) / CHOICE).read_text(encoding="utf-8").strip()
    except (OSError, UnicodeDecodeError):
        return None
    return Path(text) if text else None


def place_in(folder: Path | None) -> Path:
    """Where the cache lies when this folder is chosen; None for the usual one."""
    return (folder or usual_folder()) / NAME


def cache_place(config: Path | None = None) -> Path:
    """Where the cache lies: as chosen, or temporary where that cannot be written."""
    return writable_or_temporary(place_in(chosen_folder(config)))


def writable_or_temporary(place: Path) -> Path:
    """A folder where it can be written, which it is tried for once; else a temporary one."""
    return place if _can_be_written(place) else temporary_folder()


@cache
def _can_be_written(place: Path) -> bool:
    home = home_folder()
    if place.is_relative_to(home) and not home.is_dir():
        return False  # a home directory is not for this program to make
    try:
        place.mkdir(parents=True, exist_ok=True)
        trial = place / f".trial-{os.getpid()}"
        trial.write_bytes(b"")
        trial.unlink()
    except OSError:
        return False
    return True


def require_writable(folder: Path) -> None:
    """Refuse a folder that no cache can be written to.

    Raises
    ------
    InputError
    """
    place, present = place_in(folder), folder.is_dir()
    try:
        place.mkdir(parents=True, exist_ok=True)
        trial = place / f".trial-{os.getpid()}"
        trial.write_bytes(b"")
        trial.unlink()
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


def choose(folder: Path | None, config: Path | None = None) -> None:
    """Keep the cache in a folder from now on, None for the usual one; what there is stays.

    Raises
    ------
    InputError
        Where it cannot be written.
    """
    from lispac.io.files import written_whole

    if folder == chosen_folder(config):
        return
    if folder is not None:
        require_writable(folder)
    with written_whole((config or user_folder()) / CHOICE) as path:
        path.write_text("" if folder is None else f"{folder}\n", encoding="utf-8")


def size(place: Path) -> int:
    """Bytes of what the program has put there."""
    found = 0
    for part in _parts(place):
        for folder, _, names in os.walk(part):
            for name in names:
                with suppress(OSError):
                    found += os.lstat(os.path.join(folder, name)).st_size
    return found


def empty(place: Path) -> None:
    """Remove what the program has put there, and nothing else.

    Raises
    ------
    InputError
        Where something of it could not be removed.
    """
    for part in _parts(place):
        try:
            shutil.rmtree(part)
        except OSError as failure:
            reason = system_reason(failure)
            raise InputError(
                error("cache.not_removed", folder=str(part), reason=reason)
            ) from failure


def use(variables: MutableMapping[str, str]) -> Message | None:
    """Set the cache folders of other packages; usable existing settings are kept.

    Parameters
    ----------
    variables : mutable mapping of str to str
        The environment of this process, which is changed.

    Returns
    -------
    Message or None
        A note where something is kept in a temporary folder because its own cannot be written.
    """
    wanted = place_in(chosen_folder())
    place = cache_place()
    refused = [] if place == wanted else [wanted]
    for variable, part in VARIABLES.items():
        given = variables.get(variable)
        if given and not _may_be_written(Path(given)):
            refused.append(Path(given))
            given = ""
        variables[variable] = given or str(place / part)
    if not refused:
        return None
    return Message(
        "cache.not_writable", Level.NOTE, {"folder": str(refused[0]), "used": str(place)}
    )


def _may_be_written(folder: Path) -> bool:
    """Whether nothing speaks against writing to a folder, which need not exist."""
    folder = folder.absolute()
    there = next(each for each in (folder, *folder.parents) if os.path.exists(each))
    return os.path.isdir(there) and os.access(there, os.W_OK | os.X_OK)


def _parts(place: Path) -> list[Path]:
    parts = [place / part for part in VARIABLES.values()]
    # A folder called demo may be anybody's; ours is marked.
    if (place / DEMO / "raw" / DEMO).is_file():
        parts.append(place / DEMO)
    if (place / MANUAL / MANUAL_MARK).is_file():
        parts.append(place / MANUAL)
    return [part for part in parts if part.is_dir() and not part.is_symlink()]
