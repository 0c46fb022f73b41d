"""Paths of resources, of the program, and of the user's own files."""

import os
import stat
import sys
import tempfile
from contextlib import suppress
from functools import cache
from pathlib import Path

from lispac.errors import InputError
from lispac.messages import error


def resource_path(name: str) -> Path:
    """Path of a file or folder of the resources.

    Raises
    ------
    InputError
        If it is missing in the installation.
    """
    package = Path(__file__).parent
    # The resources are inside the package in a wheel, and beside it in a checkout.
    for folder in (package, package.parent):
        path = folder / "resources" / name
        if path.exists():
            return path
    raise InputError(error("installation.file_missing", name=name))


def window_command() -> list[str]:
    """Command that starts the program with the window, without further arguments."""
    program = Path(sys.executable)
    # In the bundle, which has no Python, the window program is beside the command-line program.
    if getattr(sys, "frozen", False):
        return [str(program.with_name(f"lispac-gui{program.suffix}"))]
    return [sys.executable, "-m", "lispac.gui"]


def home_folder() -> Path:
    """Home directory of the user according to the system, whether or not it exists.

    For an account without a home directory, as in a container, it is `temporary_folder`.
    """
    try:
        return Path.home()
    except RuntimeError:
        return temporary_folder()


def expand_user(path: Path) -> Path:
    """Path with ``~`` expanded; unchanged if there is no such user."""
    with suppress(RuntimeError):
        return path.expanduser()
    return path


@cache
def temporary_folder() -> Path:
    """Temporary folder to which only this user can write.

    The folder is the same in every run, unless another user has a folder of this name. Compiled
    code is read from it, so a folder to which others can write is never used.
    """
    user = f"-{os.getuid()}" if hasattr(os, "getuid") else ""
    folder = Path(tempfile.gettempdir()) / f"lispac{user}"
    with suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    return folder if _is_private(folder) else Path(tempfile.mkdtemp(prefix="lispac-"))


def _is_private(folder: Path) -> bool:
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode):
        return False
    if not hasattr(os, "getuid"):  # on Windows each user has a separate folder of temporary files
        return True
    return found.st_uid == os.getuid() and not found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def user_folder() -> Path:
    """Folder of the user's files for all projects, such as sensors; it need not exist."""
    home = home_folder()
    if sys.platform == "win32":
        place = Path(os.environ.get("LOCALAPPDATA", home / "AppData" / "Local"))
    elif sys.platform == "darwin":
        place = home / "Library" / "Preferences"
    else:
        place = Path(os.environ.get("XDG_CONFIG_HOME") or home / ".config")
    return place / "lispac"
