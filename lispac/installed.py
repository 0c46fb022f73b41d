"""Where things are: files that are not code, and what the user keeps for all projects."""

import os
import sys
from pathlib import Path

import lispac
from lispac.errors import InputError


def resource(name: str) -> Path:
    """A file or folder of the resources.

    Raises
    ------
    InputError
        Where the installation lacks it.
    """
    package = Path(lispac.__file__).parent
    # A wheel has the resources in the package, a checkout beside it.
    for folder in (package, package.parent):
        path = folder / "resources" / name
        if path.exists():
            return path
    raise InputError(f"{name} is missing from this installation; install it again.")


def window_command() -> list[str]:
    """What starts the program with the window, as the first words of a command line."""
    program = Path(sys.executable)
    # The bundle without Python has it beside the command line; elsewhere Python knows it.
    if getattr(sys, "frozen", False):
        return [str(program.with_name(f"lispac-gui{program.suffix}"))]
    return [sys.executable, "-m", "lispac.gui"]


def user_folder() -> Path:
    """What the user has made for all projects, sensors for example; it need not exist."""
    home = Path.home()
    if sys.platform == "win32":
        place = Path(os.environ.get("LOCALAPPDATA", home / "AppData" / "Local"))
    elif sys.platform == "darwin":
        place = home / "Library" / "Preferences"
    else:
        place = Path(os.environ.get("XDG_CONFIG_HOME") or home / ".config")
    return place / "lispac"
