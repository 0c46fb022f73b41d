"""System libraries that Qt, VTK and Open3D require on Linux, and how to install them.

A wheel contains its own libraries except those that belong to the system: OpenGL, X11, fonts. The
dynamic loader is used to check whether a library is present, so that the check works on every
distribution; only the package names to install are those of Debian and Ubuntu.
"""

from __future__ import annotations

import ctypes
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

# A package that a distribution renamed is listed under both names, the newer one first.
LIBRARIES: dict[str, tuple[str, ...]] = {
    # OpenGL, and Mesa's software renderer for machines without a graphics card
    "libGL.so.1": ("libgl1",),
    "libEGL.so.1": ("libegl1",),
    "libGLX_mesa.so.0": ("libglx-mesa0",),
    # X11 as used by Qt and VTK
    "libX11.so.6": ("libx11-6",),
    "libX11-xcb.so.1": ("libx11-xcb1",),
    "libXcursor.so.1": ("libxcursor1",),
    "libXext.so.6": ("libxext6",),
    "libXrender.so.1": ("libxrender1",),
    # Qt's xcb platform plugin
    "libxcb.so.1": ("libxcb1",),
    "libxcb-cursor.so.0": ("libxcb-cursor0",),
    "libxcb-glx.so.0": ("libxcb-glx0",),
    "libxcb-icccm.so.4": ("libxcb-icccm4",),
    "libxcb-image.so.0": ("libxcb-image0",),
    "libxcb-keysyms.so.1": ("libxcb-keysyms1",),
    "libxcb-randr.so.0": ("libxcb-randr0",),
    "libxcb-render.so.0": ("libxcb-render0",),
    "libxcb-render-util.so.0": ("libxcb-render-util0",),
    "libxcb-shape.so.0": ("libxcb-shape0",),
    "libxcb-shm.so.0": ("libxcb-shm0",),
    "libxcb-sync.so.1": ("libxcb-sync1",),
    "libxcb-util.so.1": ("libxcb-util1",),
    "libxcb-xfixes.so.0": ("libxcb-xfixes0",),
    "libxcb-xkb.so.1": ("libxcb-xkb1",),
    "libxkbcommon.so.0": ("libxkbcommon0",),
    "libxkbcommon-x11.so.0": ("libxkbcommon-x11-0",),
    # Qt itself
    "libbrotlidec.so.1": ("libbrotli1",),
    "libdbus-1.so.3": ("libdbus-1-3",),
    "libfontconfig.so.1": ("libfontconfig1",),
    "libfreetype.so.6": ("libfreetype6",),
    "libglib-2.0.so.0": ("libglib2.0-0t64", "libglib2.0-0"),
    "libgssapi_krb5.so.2": ("libgssapi-krb5-2",),
    "libz.so.1": ("zlib1g",),
    "libzstd.so.1": ("libzstd1",),
    # Open3D
    "libgomp.so.1": ("libgomp1",),
    "libidn2.so.0": ("libidn2-0",),
    "libudev.so.1": ("libudev1",),
    "libusb-1.0.so.0": ("libusb-1.0-0",),
}
FONTS = ("fonts-dejavu-core",)
VIRTUAL_SCREEN = ("xvfb",)
PDF_READER = ("poppler-utils",)  # the tests read the report with pdftotext
FONT_FOLDERS = ("/usr/share/fonts", "/usr/local/share/fonts")


class Missing(NamedTuple):
    """A missing system component: its description and the possible names of its package."""

    what: str
    package: tuple[str, ...]


class PackagesMissingError(Exception):
    """The system lacks libraries and this script may not, or cannot, install them."""


def library_loads(soname: str) -> bool:
    """Whether the dynamic loader finds the library."""
    try:
        ctypes.CDLL(soname)
    except OSError:
        return False
    return True


def fonts_exist() -> bool:
    """Whether there is at least one scalable font; without any, Qt draws no text."""
    return any(
        path.suffix.lower() in (".ttf", ".otf", ".ttc")
        for folder in FONT_FOLDERS
        for path in Path(folder).rglob("*")
    )


def venv_works() -> bool:
    """Whether this Python can make environments; Debian keeps that in a package of its own."""
    # In a process of its own: the attempt must not change this one.
    command = [sys.executable, "-c", "import venv, ensurepip; ensurepip.version()"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def missing_packages(
    *,
    for_tests: bool,
    loads: Callable[[str], bool] = library_loads,
    has_fonts: Callable[[], bool] = fonts_exist,
    which: Callable[[str], str | None] = shutil.which,
    has_venv: Callable[[], bool] = venv_works,
) -> list[Missing]:
    """Missing components of this Linux system; tests replace the callables that query it."""
    missing = [Missing(so, package) for so, package in LIBRARIES.items() if not loads(so)]
    if not has_fonts():
        missing.append(Missing("a scalable font", FONTS))
    if for_tests and which("Xvfb") is None:
        missing.append(Missing("the virtual screen Xvfb", VIRTUAL_SCREEN))
    if for_tests and which("pdftotext") is None:
        missing.append(Missing("the PDF reader pdftotext", PDF_READER))
    if not has_venv():
        version = f"{sys.version_info[0]}.{sys.version_info[1]}"
        missing.append(Missing("Python's venv module", (f"python{version}-venv", "python3-venv")))
    return missing


def apt_knows(package: str) -> bool:
    """Whether apt can install a package of this name (a purely virtual name does not count)."""
    command = ["apt-cache", "show", "--no-all-versions", package]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def choose_names(missing: Sequence[Missing], knows: Callable[[str], bool] = apt_knows) -> list[str]:
    """Package names for apt-get, each once.

    Of several names, the first that apt knows is used. If apt knows none because its lists were
    never fetched, the last is used: it is the older name, which newer systems still provide.
    """
    chosen = []
    for need in missing:
        known = (name for name in need.package[:-1] if knows(name))
        name = next(known, need.package[-1])
        if name not in chosen:
            chosen.append(name)
    return chosen


def install_command(packages: Sequence[str]) -> list[str]:
    """Command that installs the packages without questions."""
    return ["apt-get", "install", "-y", "--no-install-recommends", *packages]


def is_root() -> bool:
    """Whether this process may install packages."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def ensure(
    missing: Sequence[Missing],
    *,
    root: bool,
    apt_get: str | None,
    say: Callable[[str], None],
) -> None:
    """Installs missing packages as root; otherwise raises an error with the command to run.

    Parameters
    ----------
    missing : sequence of Missing
    root : bool, whether this process may install packages
    apt_get : path of apt-get, or None on a system without it
    say : receives one line of progress

    Raises
    ------
    PackagesMissingError
        The user has to install something; the message holds the exact command.
    """
    if not missing:
        return
    shown = [need.what for need in missing[:4]]
    more = len(missing) - len(shown)
    what = ", ".join(shown) + (f" and {more} more" if more else "")
    if apt_get is None:
        names = " ".join(choose_names(missing, knows=lambda _name: False))
        raise PackagesMissingError(
            f"This system lacks {what}.\n"
            "Install them with its package manager and start again. "
            f"Names of the packages on Debian and Ubuntu:\n    {names}"
        )
    if not root:
        command = shlex.join(["sudo", *install_command(choose_names(missing))])
        raise PackagesMissingError(
            f"This system lacks {what}.\n"
            "Only an administrator can install them. Run this command, then start again:\n"
            f"    sudo apt-get update && {command}"
        )
    say(f"System libraries: {len(missing)} missing, installing with apt-get")
    run_apt([apt_get, "update"])
    run_apt([apt_get, *install_command(choose_names(missing))[1:]])


def run_apt(command: Sequence[str]) -> None:
    """Runs one apt-get command; on failure raises with the last lines it printed."""
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive", "LC_ALL": "C"}
    # apt-get must not wait for an answer to questions about the time zone or the keyboard.
    done = subprocess.run(
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        tail = "\n    ".join(done.stdout.strip().splitlines()[-10:])
        raise PackagesMissingError(f"{shlex.join(command)} failed:\n    {tail}")
