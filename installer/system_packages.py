"""System packages that the program and its tests require on Linux, and their installation.

The wheels of Qt, VTK and Open3D contain their libraries except those that belong to the system,
such as OpenGL and X11. The dynamic loader is used to check whether such a library is present, so
that the check works on every distribution; the names of packages are those of Debian and Ubuntu.
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

# Names of the package that contains each library: if it was renamed, the newer name is first.
LIBRARY_PACKAGES: dict[str, tuple[str, ...]] = {
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
FONT_PACKAGES = ("fonts-dejavu-core",)
VIRTUAL_SCREEN_PACKAGES = ("xvfb",)
PDF_READER_PACKAGES = ("poppler-utils",)  # the tests read the report with pdftotext
FONT_FOLDERS = ("/usr/share/fonts", "/usr/local/share/fonts")


class MissingComponent(NamedTuple):
    """Missing component of the system, with its description and the names of its package.

    `choose_names` selects the name to install.
    """

    description: str
    package_names: tuple[str, ...]


class PackagesMissingError(Exception):
    """The system lacks packages that could not be installed; the message gives the reason."""


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
    """Whether this Python can create environments; on Debian a separate package is required."""
    # Tested in another process, so that the modules are not imported into this one.
    command = [sys.executable, "-c", "import venv, ensurepip; ensurepip.version()"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def missing_packages(
    *,
    for_tests: bool,
    loads: Callable[[str], bool] = library_loads,
    has_fonts: Callable[[], bool] = fonts_exist,
    which: Callable[[str], str | None] = shutil.which,
    has_venv: Callable[[], bool] = venv_works,
) -> list[MissingComponent]:
    """Missing components of this Linux system; the callables that query it can be replaced."""
    missing = [
        MissingComponent(so, package) for so, package in LIBRARY_PACKAGES.items() if not loads(so)
    ]
    if not has_fonts():
        missing.append(MissingComponent("a scalable font", FONT_PACKAGES))
    if for_tests and which("Xvfb") is None:
        missing.append(MissingComponent("the virtual screen Xvfb", VIRTUAL_SCREEN_PACKAGES))
    if for_tests and which("pdftotext") is None:
        missing.append(MissingComponent("the PDF reader pdftotext", PDF_READER_PACKAGES))
    if not has_venv():
        version = f"{sys.version_info[0]}.{sys.version_info[1]}"
        missing.append(
            MissingComponent("Python's venv module", (f"python{version}-venv", "python3-venv"))
        )
    return missing


def apt_knows(package: str) -> bool:
    """Whether the lists of apt contain this name, as that of a package or as a virtual one."""
    command = ["apt-cache", "show", "--no-all-versions", package]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def choose_names(
    missing: Sequence[MissingComponent], knows: Callable[[str], bool] = apt_knows
) -> list[str]:
    """Package name of each component for apt-get, without repetitions.

    Of several names, the first that apt knows is used, otherwise the last one. That is the older or
    more general name, which newer systems still provide; it is also used if the lists of apt were
    never fetched.
    """
    chosen = []
    for component in missing:
        known = (name for name in component.package_names[:-1] if knows(name))
        name = next(known, component.package_names[-1])
        if name not in chosen:
            chosen.append(name)
    return chosen


def install_command(packages: Sequence[str]) -> list[str]:
    """Command that installs packages without asking for confirmation."""
    return ["apt-get", "install", "-y", "--no-install-recommends", *packages]


def is_root() -> bool:
    """Whether this process runs as root, so that it may install packages."""
    return hasattr(os, "geteuid") and os.geteuid() == 0


def ensure_packages(
    missing: Sequence[MissingComponent],
    *,
    root: bool,
    apt_get: str | None,
    say: Callable[[str], None],
) -> None:
    """Installs the packages of missing components, if this process runs as root and has apt-get.

    Parameters
    ----------
    missing : sequence of MissingComponent
    root : bool, whether this process runs as root
    apt_get : path of apt-get, or None on a system without it
    say : function that prints one line of progress

    Raises
    ------
    PackagesMissingError
        If the user has to install the packages, with the command (or, without apt-get, the names of
        the packages), or if apt-get failed.
    """
    if not missing:
        return
    shown = [component.description for component in missing[:4]]
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
    """Runs one apt-get command.

    Raises
    ------
    PackagesMissingError
        If it failed; the message contains the last lines of its output.
    """
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
