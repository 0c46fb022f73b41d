"""The private Python environment .venv of a checkout, and its update.

A stamp file, written last, contains digests of the installed lock files and of the project. If they
are up to date, nothing is done. After an interrupted installation, the environment is created anew.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

CHECKOUT = Path(__file__).resolve().parents[1]
ENVIRONMENT = CHECKOUT / ".venv"
STAMP = ENVIRONMENT / "lispac-installed.json"
INSTALL_LOG = ENVIRONMENT / "install.log"
LOCK_FILES = {"run": "lock-run.txt", "test": "lock-test.txt", "bundle": "lock-bundle.txt"}
# The project is installed again if one of these files changes.
PROJECT_FILES = ("pyproject.toml", "lispac/version.py")


class SetupError(Exception):
    """The environment cannot be created; the message gives the reason."""


def say(line: str) -> None:
    """Prints one line of progress at once."""
    print(line, flush=True)


def use_folder(folder: Path) -> None:
    """Use the environment in another folder than .venv in this process."""
    global ENVIRONMENT, STAMP, INSTALL_LOG
    ENVIRONMENT = folder
    STAMP, INSTALL_LOG = folder / STAMP.name, folder / INSTALL_LOG.name


def home_folder() -> Path:
    """The user's home directory; for an account without one, a folder of the environment."""
    try:
        return Path.home()
    except RuntimeError:
        return ENVIRONMENT / "cache" / "home"


def user_cache(platform: str, variables: Mapping[str, str], home: Path) -> Path:
    """The program's folder in the user's cache folder."""
    if platform == "win32":
        return (
            Path(variables.get("LOCALAPPDATA") or home / "AppData" / "Local") / "lispac" / "Cache"
        )
    if platform == "darwin":
        return home / "Library" / "Caches" / "lispac"
    return Path(variables.get("XDG_CACHE_HOME") or home / ".cache") / "lispac"


def script(name: str, platform: str = sys.platform) -> str:
    """Path of a program in the environment."""
    if platform == "win32":
        return str(ENVIRONMENT / "Scripts" / f"{name}.exe")
    return str(ENVIRONMENT / "bin" / name)


def child_variables(
    variables: Mapping[str, str], cache: Path, *, testing: bool = False
) -> dict[str, str]:
    """Environment variables of all programs started here, with separate folders for their caches.

    Parameters
    ----------
    variables : mapping, the variables of this process
    cache : Path, the program's folder in the user's cache folder
    testing : bool, whether to use software OpenGL and separate settings, so that the tests do not
        depend on the graphics card and the settings of the user
    """
    own = ENVIRONMENT / "cache"
    # PYTHONPATH is removed: modules of another environment would take precedence over the locked
    # ones. Bytecode is kept in a separate folder; without it every process compiles the libraries.
    excluded = ("PYTHONPATH", "PYTHONHOME", "PYTHONDONTWRITEBYTECODE")
    kept = {k: v for k, v in variables.items() if k not in excluded}
    kept.update(
        PYTHONPYCACHEPREFIX=str(own / "bytecode"),
        HYPOTHESIS_STORAGE_DIRECTORY=str(own / "hypothesis"),
        MYPY_CACHE_DIR=str(own / "mypy"),
        RUFF_CACHE_DIR=str(own / "ruff"),
        NUMBA_CACHE_DIR=variables.get("NUMBA_CACHE_DIR") or str(cache / "numba"),
        MPLCONFIGDIR=variables.get("MPLCONFIGDIR") or str(cache / "matplotlib"),
        IPYTHONDIR=variables.get("IPYTHONDIR") or str(cache / "ipython"),
    )
    if testing:
        kept.update(
            LIBGL_ALWAYS_SOFTWARE="1",
            PYTEST_DEBUG_TEMPROOT=str(own),
            XDG_CONFIG_HOME=str(own / "config"),
            XDG_DATA_HOME=str(own / "data"),
        )
        (own / "config").mkdir(parents=True, exist_ok=True)
    return kept


def digest(*paths: Path) -> str:
    """SHA-256 over the contents of some files."""
    total = hashlib.sha256()
    for path in paths:
        total.update(path.read_bytes())
    return total.hexdigest()


def wanted_state(checkout: Path = CHECKOUT) -> dict[str, Any]:
    """Contents of the stamp if the dependencies of all kinds were installed and up to date."""
    installer = checkout / "installer"
    return {
        # Scripts of an environment contain its path, so a moved checkout needs a new environment.
        "checkout": str(checkout),
        "python": f"{sys.version} {sys.base_prefix}",
        "locks": {kind: digest(installer / name) for kind, name in LOCK_FILES.items()},
        "project": digest(*(checkout / name for name in PROJECT_FILES)),
    }


def read_stamp(path: Path) -> dict[str, Any] | None:
    """Stamp of an earlier complete installation, or None."""
    try:
        state = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return state if isinstance(state, dict) and "locks" in state else None


def steps_needed(installed: dict[str, Any] | None, wanted: dict[str, Any], kind: str) -> list[str]:
    """Which of "environment", "dependencies" and "project" must be created again.

    Parameters
    ----------
    installed : dict or None, as from `read_stamp`
    wanted : dict, as from `wanted_state`
    kind : str, key of `LOCK_FILES`; the lock for tests includes everything in the lock for running
    """
    if installed is None or any(installed.get(k) != wanted[k] for k in ("checkout", "python")):
        return ["environment", "dependencies", "project"]
    steps = []
    if installed["locks"].get(kind) != wanted["locks"][kind]:
        steps.append("dependencies")
    if installed.get("project") != wanted["project"]:
        steps.append("project")
    return steps


def write_stamp(state: dict[str, Any], path: Path) -> None:
    """Replaces the stamp atomically, so that it is either complete or absent."""
    draft = path.with_suffix(".part")
    draft.write_text(json.dumps(state, indent=1), encoding="utf-8")
    draft.replace(path)


def pip_variables(variables: Mapping[str, str]) -> dict[str, str]:
    """Environment variables of pip: no questions, and only .venv is changed."""
    return {
        **variables,
        "PIP_DISABLE_PIP_VERSION_CHECK": "1",
        "PIP_NO_INPUT": "1",
        "PIP_USER": "0",
        "PYTHONUNBUFFERED": "1",
        # pip runs rustc for its version; rustup's proxy would then create a folder in the home.
        "RUSTUP_HOME": str(ENVIRONMENT / "cache" / "rustup"),
    }


def make_environment() -> None:
    """Creates a new .venv.

    Raises
    ------
    SetupError
        There is a .venv that this script did not make, or Python cannot make one.
    """
    if (ENVIRONMENT / "pyvenv.cfg").exists() and not STAMP.exists():
        raise SetupError(
            f"{ENVIRONMENT} was not created by this script. Move or remove it, then start again."
        )
    if ENVIRONMENT.exists():
        shutil.rmtree(ENVIRONMENT)
    ENVIRONMENT.mkdir(parents=True)
    write_stamp({"state": "unfinished"}, STAMP)
    say(f"Creating the environment {ENVIRONMENT.name}")
    command = [sys.executable, "-m", "venv", str(ENVIRONMENT)]
    variables = pip_variables(os.environ)
    done = subprocess.run(command, env=variables, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SetupError(f"Python cannot create an environment: {done.stdout}{done.stderr}".strip())


def pip_progress(lines: Iterable[str], total: int, report: Callable[[str], None]) -> None:
    """Reports pip's output in a few lines: large downloads, every 25th package, and unpacking."""
    seen = 0
    for line in lines:
        text = line.strip()
        if text.startswith(("Collecting ", "Requirement already satisfied", "Ignoring ")):
            seen += 1
            if seen % 25 == 0:
                report(f"  {min(seen, total)} of {total} packages")
        elif text.startswith("Installing collected packages"):
            report("  unpacking")
        big = re.match(r"Downloading (?:\S*/)?(\S+?-\d\S*?)-\S* \((\d+)\.?\d* MB\)", text)
        if big and int(big.group(2)) >= 50:
            report(f"  downloading {big.group(1)} ({big.group(2)} MB)")


def pip_command() -> list[str]:
    """Common part of the pip commands; bytecode is compiled when needed."""
    return [script("python"), "-m", "pip", "install", "--progress-bar", "off", "--no-compile"]


def run_pip(arguments: Sequence[str], variables: Mapping[str, str], total: int) -> None:
    """Runs pip in the environment and keeps its output in the install log.

    Raises
    ------
    SetupError
        pip failed; the message contains its last lines.
    """
    output: list[str] = []

    def kept(stream: Iterable[str]) -> Iterator[str]:
        with INSTALL_LOG.open("a", encoding="utf-8") as log:
            for line in stream:
                log.write(line)
                output.append(line.rstrip())
                yield line

    with subprocess.Popen(
        [*pip_command(), *arguments],
        env=pip_variables(variables),
        cwd=CHECKOUT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
    ) as process:
        pip_progress(kept(process.stdout or ()), total, say)
    if process.returncode != 0:
        tail = "\n    ".join(line for line in output[-12:] if line)
        raise SetupError(
            f"The installation of the dependencies failed (full output of pip: {INSTALL_LOG}):"
            f"\n    {tail}\nCorrect the cause, then run the same command again."
        )


def requirement_count(lock: Path) -> int:
    """Number of packages in a lock file."""
    return len(re.findall(r"^[A-Za-z0-9][^\s=]*==", lock.read_text(encoding="utf-8"), re.MULTILINE))


def ensure_installed(kind: str, cache: Path) -> bool:
    """Installs or updates the environment for a kind of `LOCK_FILES`, if it is not up to date.

    Returns
    -------
    bool
        Whether anything was installed.
    """
    wanted = wanted_state()
    installed = read_stamp(STAMP)
    steps = steps_needed(installed, wanted, kind)
    if not steps:
        return False
    started = time.monotonic()
    if "environment" in steps:
        make_environment()
        installed = None
    locks = dict(installed["locks"]) if installed else {}
    write_stamp({"state": "unfinished"}, STAMP)  # after an interruption, all is installed again
    variables = child_variables(os.environ, cache)
    if "dependencies" in steps:
        lock = CHECKOUT / "installer" / LOCK_FILES[kind]
        total = requirement_count(lock)
        say(f"Installing {total} locked packages (the first time this takes some minutes)")
        run_pip(["--only-binary", ":all:", "--require-hashes", "-r", str(lock)], variables, total)
        # The lock for tests includes everything in the lock for running.
        kinds = ("run", "test") if kind == "test" else (kind,)
        locks = {name: wanted["locks"][name] for name in kinds}
    say("Installing LISPAC")
    project = ["--no-deps", "--no-build-isolation", "--no-index", "--editable", str(CHECKOUT)]
    run_pip(project, variables, 1)
    write_stamp({**wanted, "locks": locks}, STAMP)
    say(f"Installed in {time.monotonic() - started:.0f} s")
    return True
