"""Sets up LISPAC in this checkout and starts it; requires only Python.

    python3 installer/bootstrap.py demo       calibrate the demonstration survey
    python3 installer/bootstrap.py run        open the program (and a project folder, if given)
    python3 installer/bootstrap.py test       run linting, typing, import rules and tests
    python3 installer/bootstrap.py lint       run the same checks without the tests
    python3 installer/bootstrap.py benchmark  run the benchmarks and print times
    python3 installer/bootstrap.py bundle     build a folder in dist/ that runs without Python

The first start creates the environment .venv in the checkout and installs the locked dependencies;
later starts use them. Only .venv and the user's cache folder are written (and, on Linux as root,
missing system packages are installed); `bundle` writes to build/ and dist/.
"""

from __future__ import annotations

import argparse
import ctypes
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

if __name__ == "__main__":  # no bytecode in the checkout; tests import this module and keep theirs
    sys.dont_write_bytecode = True
import environment
import system_packages
from environment import SetupError, say, script

OLDEST_PYTHON = (3, 11)
NEWEST_PYTHON = (3, 14)  # newest version for which the locked dependencies have wheels
PROCESS_OPTIONS = ["--numprocesses=2", "--dist=loadfile", "--no-loadscope-reorder"]
PRECOMPILE_MODULE = "lispac.workflow.planning.precompile"
HANG_OPTIONS = [
    "--max-worker-restart=0", "-o", "faulthandler_timeout=330",
    "-o", "faulthandler_exit_on_timeout=true",
]  # fmt: skip


def unsupported_python_text(version: tuple[int, int]) -> str | None:
    """Reason why this Python is not supported, or None."""
    if OLDEST_PYTHON <= version <= NEWEST_PYTHON:
        return None
    span = f"{OLDEST_PYTHON[0]}.{OLDEST_PYTHON[1]} to {NEWEST_PYTHON[0]}.{NEWEST_PYTHON[1]}"
    return (
        f"LISPAC needs Python {span}, but this is {version[0]}.{version[1]}. "
        "Start this script with a supported version, for example python3.12 installer/bootstrap.py"
    )


def has_display(platform: str, variables: Mapping[str, str]) -> bool:
    """Whether a window can open: on Linux, whether Wayland is set or the X server answers."""
    if platform in ("win32", "darwin") or variables.get("WAYLAND_DISPLAY"):
        return True
    if not variables.get("DISPLAY"):
        return False
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return False
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if not display:
        return False
    x11.XCloseDisplay(ctypes.c_void_p(display))
    return True


def ensure_system(kind: str) -> None:
    """On Linux, installs missing system packages or raises an error with the command for it."""
    if not sys.platform.startswith("linux"):
        return
    missing = system_packages.missing_packages(for_tests=kind == "test")
    root, apt_get = system_packages.is_root(), shutil.which("apt-get")
    system_packages.ensure_packages(missing, root=root, apt_get=apt_get, say=say)


def lint_commands() -> list[tuple[str, list[str]]]:
    """Name and command line of each check that `lint` runs, and `test` before the tests."""
    python, cache = script("python"), str(environment.ENVIRONMENT / "cache" / "import-linter")
    return [
        ("ruff check", [python, "-m", "ruff", "check", "."]),
        ("ruff format", [python, "-m", "ruff", "format", "--check", "."]),
        ("mypy", [python, "-m", "mypy"]),
        ("translations", [python, "installer/catalogues.py", "check"]),
        ("import rules", [script("lint-imports"), "--no-logo", "--cache-dir", cache]),
    ]


def check_commands(command: str, arguments: Sequence[str]) -> list[tuple[str, list[str]]]:
    """Name and command line of every step of `test`, `lint` or `benchmark`, in order."""
    cache = environment.ENVIRONMENT / "cache" / "pytest"
    # A test that hangs fails with the traceback of every thread instead of blocking the run. If it
    # hangs outside Python, for example in an open dialog, its process ends with these tracebacks.
    pytest = [script("python"), "-m", "pytest", "-o", f"cache_dir={cache}", "--timeout=300"]
    if command == "lint":
        return lint_commands()
    if command == "benchmark":
        options = ["tests/benchmarks", "--benchmark-enable", "--capture=no", "-m", ""]
        return [("benchmarks", [*pytest, *options, *arguments])]
    # Each process runs whole test files, because their tests share data that are slow to make, in
    # the order of tests/conftest.py. Selected tests run in one process, for debugging.
    chosen = arguments or [*PROCESS_OPTIONS, *HANG_OPTIONS]
    return [*lint_commands(), ("pytest", [*pytest, *chosen])]


def run_checks(
    commands: Sequence[tuple[str, list[str]]],
    variables: Mapping[str, str],
    compiler: Sequence[str] = (),
) -> int:
    """Runs the commands in the checkout until one fails; returns its exit code, or 0.

    Parameters
    ----------
    commands : sequence of tuple of name and command line
    variables : mapping, environment variables
    compiler : sequence of str, optional
        Command that runs beside all commands except the last one, which waits for it. It compiles
        the functions of the program, which otherwise every test process would do at the same time.
    """
    compilation = (
        subprocess.Popen(compiler, cwd=environment.CHECKOUT, env=dict(variables))
        if compiler
        else None
    )
    try:
        for name, command in commands:
            if compilation and command is commands[-1][1]:
                compilation.wait()
            say(f"== {name}")
            code = subprocess.call(command, cwd=environment.CHECKOUT, env=dict(variables))
            if code != 0:
                say(f"{name} failed: {shlex.join(command)}")
                return code if code > 0 else 1
    finally:
        if compilation:
            compilation.terminate()
            compilation.wait()
    return 0


def demo_command(output: Path, display: bool) -> list[str]:
    """Command line of the demo, with its window where there is a display."""
    command = [script("lispac"), "demo", "--output", str(output)]
    return command if display else [*command, "--no-window"]


def parser() -> argparse.ArgumentParser:
    """Parser of the command line of this script."""
    form = argparse.RawDescriptionHelpFormatter
    top = argparse.ArgumentParser(
        prog="bootstrap.py", description=__doc__, formatter_class=form, allow_abbrev=False
    )
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    demo = commands.add_parser("demo", help="calibrate the demonstration survey")
    demo.add_argument("--output", type=Path, metavar="DIR", help="folder for survey and report")
    run = commands.add_parser("run", help="start the program")
    run.add_argument("project", nargs="?", metavar="PROJECT", help="project folder to open")
    bundle = commands.add_parser("bundle", help="build a folder in dist/ that runs without Python")
    bundle.add_argument(
        "--no-archive", action="store_true", help="build the folder only, no archive"
    )
    commands.add_parser("lint", help="run linting, typing, import rules and translation checks")
    for name, text in (("test", "run all checks and tests"), ("benchmark", "run the benchmarks")):
        check = commands.add_parser(
            name, help=text, usage=f"bootstrap.py {name} [PYTEST ARGUMENT...]"
        )
        check.set_defaults(takes_rest=True)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one command; returns the exit code."""
    complaint = unsupported_python_text(sys.version_info[:2])
    if complaint:
        print(complaint, file=sys.stderr)
        return 1
    form = parser()
    options, rest = form.parse_known_args(arguments)
    if rest and not getattr(options, "takes_rest", False):
        form.error(f"unrecognized arguments: {' '.join(rest)}")
    kind = {"demo": "run", "run": "run", "bundle": "bundle"}.get(options.command, "test")
    if kind == "bundle":
        environment.use_folder(environment.CHECKOUT / "build" / "bundle-env")
    cache = environment.user_cache(sys.platform, os.environ, environment.home_folder())
    try:
        ensure_system(kind)
        is_new = environment.ensure_installed(kind, cache)
        variables = environment.child_variables(os.environ, cache, testing=kind == "test")
        if kind == "test":
            compiler = [script("python"), "-m", PRECOMPILE_MODULE]
            whole = options.command == "test" and not rest
            return run_checks(
                check_commands(options.command, rest), variables, compiler if whole else ()
            )
        if kind == "bundle":
            command = [script("python"), "-m", "bundling.build"]
            command += ["--no-archive"] if options.no_archive else []
            return subprocess.call(command, cwd=environment.CHECKOUT / "installer", env=variables)
        display = has_display(sys.platform, os.environ)
        if options.command == "demo":
            output = options.output or cache / "demo"
            return subprocess.call(demo_command(output, display), env=variables)
        if not display:
            raise SetupError(
                "No display was found, so the window cannot open. `demo` runs without a display."
            )
        if is_new:
            say("Compiling functions (once, one to two minutes)")
            subprocess.call([script("python"), "-m", PRECOMPILE_MODULE], env=variables)
        project = [options.project] if options.project else []
        return subprocess.call([script("python"), "-m", "lispac.gui", *project], env=variables)
    except (SetupError, system_packages.PackagesMissingError) as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("Stopped. Run the same command again to continue.", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
