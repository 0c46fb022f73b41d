"""Licences of all components of a bundle in one file; a missing licence stops the build."""

from __future__ import annotations

import re
import subprocess
import sys
import sysconfig
import tomllib
from collections.abc import Iterable, Mapping
from importlib.metadata import Distribution, distributions
from pathlib import Path
from typing import Any

BUNDLING_FOLDER = Path(__file__).resolve().parent
TEXT_FOLDER = BUNDLING_FOLDER / "licences"
NOTICES_FILE = TEXT_FOLDER / "notices.toml"
SEPARATOR_LINE = "=" * 78
LICENCE_FILE_PATTERN = re.compile(r"(licen[cs]e|copying|notice|copyright)", re.IGNORECASE)
PYTHON_NAME = "Python"
PROJECT_NAME = "LISPAC"
FILE_NAME = "LICENSES.txt"
MANUAL_PAGE_PACKAGES = ("furo", "pygments", "snowballstemmer", "sphinx", "sphinx-basic-ng")
"""Packages whose scripts, style sheets and images are part of the manual's pages."""


class LicenceMissingError(Exception):
    """A component has no licence text; the message names it and the action."""


def normalised(name: str) -> str:
    """Normalised name of a distribution: lower case, with hyphens."""
    return re.sub(r"[-_.]+", "-", name).lower()


def owners(site: Path) -> dict[str, Distribution]:
    """Distribution (installed package) of each file of an environment, by the path of the file.

    Parameters
    ----------
    site : Path, folder site-packages
    """
    found: dict[str, Distribution] = {}
    for distribution in distributions(path=[str(site)]):
        for file in distribution.files or ():
            found[str(site / file)] = distribution
    return found


def texts_of(distribution: Distribution, notices: Mapping[str, Any]) -> list[str]:
    """Licence texts of a distribution: those that it contains, and those from the notices.

    Raises
    ------
    LicenceMissingError
        If neither the distribution nor the notices contain a licence text.
    """
    name = distribution.metadata["Name"]
    found = []
    for file in distribution.files or ():
        # A licence file in the metadata or in the folder of the code, but not a module of that name
        if LICENCE_FILE_PATTERN.search(file.name) and file.suffix.lower() in (
            "",
            ".txt",
            ".md",
            ".rst",
        ):
            path = Path(str(distribution.locate_file(file)))
            if path.is_file():
                found.append(path.read_text(encoding="utf-8", errors="replace").strip())
    added = notices.get("distribution", {}).get(normalised(name), {})
    if "note" in added:
        found.insert(0, added["note"].strip())
    found += [_text(file) for file in added.get("texts", ())]
    if not found:
        raise LicenceMissingError(
            f"{name} comes without the text of its licence: add it to {NOTICES_FILE.name} beside "
            f"the other texts in {TEXT_FOLDER}."
        )
    return found


def library_notice(file_name: str, notices: Mapping[str, Any]) -> Mapping[str, str] | None:
    """Entry of the notices for a library inside a wheel, found by the beginning of its file name.

    File names on Windows lack the prefix ``lib``.
    """
    for row in notices["library"]:
        if re.match(row["file"], file_name) or re.match(row["file"], f"lib{file_name}"):
            return row
    return None


def is_foreign(path: Path) -> bool:
    """Whether a file is a library in a wheel by other authors than those of the wheel."""
    name = path.name
    if ".so" not in name and path.suffix not in (".dll", ".dylib"):
        return False
    # auditwheel and delvewheel put such libraries into a folder *.libs, delocate into .dylibs
    brought = path.parent.name == ".dylibs" or path.parent.name.endswith(".libs")
    return brought or re.match(r"(lib)?(vtk[a-z]|tbb)", name) is not None


def debian_copyright(library: Path) -> tuple[str, str]:
    """Package name and licence text of a library of this Debian or Ubuntu system.

    Raises
    ------
    LicenceMissingError
        If no package of the system contains the library and its licence.
    """
    real = str(library.resolve())
    for path in dict.fromkeys((real, real.removeprefix("/usr"), str(library))):
        try:
            done = subprocess.run(["dpkg", "-S", path], capture_output=True, text=True, check=False)
        except FileNotFoundError:
            break
        if done.returncode == 0:
            package = done.stdout.partition(":")[0]
            file = Path("/usr/share/doc") / package / "copyright"
            if file.is_file():
                return package, file.read_text(encoding="utf-8", errors="replace").strip()
    raise LicenceMissingError(
        f"{library}: no package of this system contains its licence; build the bundle on Debian or "
        f"Ubuntu, or add the library to {NOTICES_FILE}."
    )


def read_notices() -> dict[str, Any]:
    """Content of the notices file."""
    return tomllib.loads(NOTICES_FILE.read_text(encoding="utf-8"))


def collected(
    sources: Iterable[Path], site: Path, checkout: Path, notices: Mapping[str, Any]
) -> dict[str, list[str]]:
    """Licence texts of all components of a bundle, by component name and version.

    Parameters
    ----------
    sources : iterable of Path, source files of the bundle
    site : Path, site-packages of the environment that contains them
    checkout : Path, checkout of LISPAC
    notices : result of `read_notices`

    Raises
    ------
    LicenceMissingError
        If a component has no licence text, or a file belongs to no known component.
    """
    owned = owners(site)
    found: dict[str, list[str]] = {}
    parts: dict[str, Distribution] = {}
    libraries: set[str] = set()
    for source in sorted(set(sources)):
        distribution = owned.get(str(source))
        if is_foreign(source):
            notice = library_notice(source.name, notices)
            if notice is None:
                raise LicenceMissingError(f"{source.name}: add its licence to {NOTICES_FILE}.")
            libraries.add(_row(notice))
        if distribution is not None:
            parts.setdefault(normalised(distribution.metadata["Name"]), distribution)
        elif _is_python(source) or _is_of_lispac(source, checkout, site):
            continue
        elif source.is_relative_to(site):
            raise LicenceMissingError(f"{source} belongs to no package that states its licence.")
        else:
            package, text = debian_copyright(source)
            found[f"{package} (system library)"] = [text]
    for distribution in owned.values():
        name = normalised(distribution.metadata["Name"])
        # Both programs contain PyInstaller's loader, and the manual's pages contain scripts and
        # style sheets of the packages in MANUAL_PAGE_PACKAGES
        if name in ("pyinstaller", *MANUAL_PAGE_PACKAGES):
            parts[name] = distribution
    for distribution in parts.values():
        title = f"{distribution.metadata['Name']} {distribution.version}"
        found[title] = texts_of(distribution, notices)
    found[PROJECT_NAME] = [(checkout / "LICENSE").read_text(encoding="utf-8").strip()]
    found[f"{PYTHON_NAME} {sys.version_info[0]}.{sys.version_info[1]}"] = [_python_licence()]
    if libraries:
        rows = sorted(libraries | {_row(row) for row in notices["inside"]})
        shared = [f"{name}\n\n{_text(name)}" for name in notices["shared_texts"]]
        found["Libraries inside these packages"] = ["\n".join(rows), *shared]
    return found


def written(found: Mapping[str, list[str]]) -> str:
    """Content of the licence file: a list of names, then each text below its name."""
    names = sorted(found, key=lambda name: (not name.startswith(PROJECT_NAME), name.lower()))
    lines = ["Components of this program and their licences.", ""]
    lines += [f"  {name}" for name in names]
    for name in names:
        lines += ["", SEPARATOR_LINE, name, SEPARATOR_LINE, "", "\n\n".join(found[name])]
    return "\n".join(lines) + "\n"


def _row(notice: Mapping[str, str]) -> str:
    return f"{notice['name']}: {notice['licence']}. {notice['copyright']}"


def _text(name: str) -> str:
    return (TEXT_FOLDER / name).read_text(encoding="utf-8").strip()


def _is_of_lispac(source: Path, checkout: Path, site: Path) -> bool:
    # The environment may be in the checkout
    return source.is_relative_to(checkout) and not source.is_relative_to(site)


def _is_python(source: Path) -> bool:
    # On Windows and macOS the libraries of Python are in its folder, not among system libraries
    home = sysconfig.get_path("stdlib") if sys.platform == "linux" else sys.base_prefix
    stdlib = Path(home).resolve()
    # Installed packages are in a subfolder of the standard library
    packages = {"site-packages", "dist-packages"} & set(source.parts)
    inside = source.resolve().is_relative_to(stdlib) and not packages
    return inside or source.name.startswith(("libpython", "python3"))


def _python_licence() -> str:
    """Licence text of the Python standard library.

    Raises
    ------
    LicenceMissingError
        If no licence file is found beside the standard library.
    """
    stdlib = Path(sysconfig.get_path("stdlib"))
    version = f"python{sys.version_info[0]}.{sys.version_info[1]}"
    debian = Path("/usr/share/doc") / version / "copyright"
    for path in (stdlib / "LICENSE.txt", Path(sys.base_prefix) / "LICENSE.txt", debian):
        if path.is_file():
            return path.read_text(encoding="utf-8").strip()
    raise LicenceMissingError(f"Python's own licence is not in {stdlib}.")
