"""HTML pages of the manual: shipped with a bundle, otherwise built from the sources and cached.

Sphinx runs as a separate program, so that it is neither loaded here nor part of a bundle.
"""

import hashlib
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path

from lispac.caches import MANUAL_FOLDER, MANUAL_MARKER_FILE, usable_cache_folder
from lispac.errors import InputError, system_reason
from lispac.installation_paths import resource_path
from lispac.language import LANGUAGES, gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress

SHIPPED_PAGES_FOLDER = "html"
"""Folder of the built pages beside their sources in a bundle."""
BUILD_PACKAGES = {"sphinx": "Sphinx", "myst_parser": "myst-parser", "furo": "furo"}
"""Packages that build the manual, with the names shown in messages."""
POLL_INTERVAL_S = 0.1
"""Time between two checks whether the build has ended, seconds."""


def manual_page(
    language: str,
    page: str = "index",
    *,
    sources: Path | None = None,
    place: Path | None = None,
    progress: Progress = no_progress,
) -> Path:
    """File of a page of the manual, which is built first if needed.

    Parameters
    ----------
    language : one of `lispac.language.LANGUAGES`
    page : name of the page without suffix; the English page is used if this language has none
    sources : Path or None
        Folder with ``conf.py``, ``en`` and ``fr``; None for the manual of this installation.
    place : Path or None
        Folder of the built pages; None for the one in the cache.

    Raises
    ------
    InputError
        If the manual is not built and cannot be built.
    Cancelled
        If the user cancels.
    """
    sources = sources or resource_path("manual")
    built = sources / SHIPPED_PAGES_FOLDER
    if not built.is_dir():
        place = place or usable_cache_folder() / MANUAL_FOLDER
        built = place / _sources_digest(sources)
        if not built.is_dir():
            _build_atomically(sources, place, built, progress)
    file = built / language / f"{page}.html"
    return file if file.is_file() else built / "en" / f"{page}.html"


def build_manual(
    sources: Path, output: Path, *, strict: bool = False, progress: Progress = no_progress
) -> None:
    """Build the pages of all languages in the subfolders ``en`` and ``fr`` of a folder.

    Parameters
    ----------
    strict : whether warnings are errors, for example broken links and missing images

    Raises
    ------
    InputError
        If the packages that build it are not installed, or the build fails.
    Cancelled
        If the user cancels.
    """
    missing = [
        name for module, name in BUILD_PACKAGES.items() if not importlib.util.find_spec(module)
    ]
    if missing:
        raise InputError(
            error("manual.not_installed", count=len(missing), packages=missing, folder=str(sources))
        )
    for k, language in enumerate(LANGUAGES):
        progress(
            k / len(LANGUAGES),
            gettext_lazy("Building the manual: {language}", language=LANGUAGES[language]),
        )
        with tempfile.TemporaryDirectory(prefix="lispac-") as scratch:
            command = [sys.executable, "-m", "sphinx", "-q", "-b", "html", "-c", str(sources)]
            command += ["-D", f"language={language}", "-d", scratch]
            command += ["-W", "--keep-going"] if strict else []
            _run_command([*command, str(sources / language), str(output / language)], progress)


def _run_command(command: list[str], progress: Progress) -> None:
    # Sphinx stops if the user's locale is not installed; the pages do not depend on it.
    variables = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "1"}
    if sys.pycache_prefix is None:  # with a separate folder for bytecode, none is left in sources
        variables["PYTHONDONTWRITEBYTECODE"] = "1"
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        # The languages are built one after the other; the output is read when the program has ended
        with subprocess.Popen(
            command, stdout=output, stderr=subprocess.STDOUT, env=variables
        ) as process:
            try:
                while process.poll() is None:
                    progress(0.5)
                    time.sleep(POLL_INTERVAL_S)
            except BaseException:
                process.kill()
                raise
        if process.returncode != 0:
            output.seek(0)
            raise InputError(error("manual.not_built", reason=output.read().strip()))


def _build_atomically(sources: Path, place: Path, built: Path, progress: Progress) -> None:
    """Build in a temporary folder and rename it, so that the result is complete or absent.

    Raises
    ------
    InputError
        If the folder cannot be written.
    """
    try:
        place.mkdir(parents=True, exist_ok=True)
        (place / MANUAL_MARKER_FILE).touch()
        draft = Path(tempfile.mkdtemp(prefix=".draft-", dir=place))
        try:
            build_manual(sources, draft, progress=progress)
            with suppress(FileExistsError):
                draft.rename(built)
        finally:
            shutil.rmtree(draft, ignore_errors=True)
    except OSError as failure:
        raise InputError(
            error("manual.not_writable", folder=str(place), reason=system_reason(failure))
        ) from failure
    for former in place.iterdir():
        if former.is_dir() and former != built and not former.name.startswith(".draft-"):
            shutil.rmtree(former, ignore_errors=True)


def _sources_digest(sources: Path) -> str:
    """Digest of all sources of the pages."""
    total = hashlib.sha256()
    for path in sorted(sources.rglob("*")):
        if path.is_file() and "__pycache__" not in path.parts:
            total.update(str(path.relative_to(sources)).encode())
            total.update(path.read_bytes())
    return total.hexdigest()[:16]
