"""Build the bundle for this system in dist/; run by `installer/bootstrap.py bundle`."""

from __future__ import annotations

import argparse
import compileall
import json
import os
import platform
import py_compile
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Iterable, Sequence
from pathlib import Path

from bundling import desktop, licences, names, sizes, trimming

BUILD_FOLDER = names.CHECKOUT / "build" / "bundle"
DIST_FOLDER = names.CHECKOUT / "dist"
SPEC_FILE = Path(__file__).with_name("lispac.spec")
INNO_SETUP_PROGRAMS = ("iscc", r"C:\Program Files (x86)\Inno Setup 6\ISCC.exe")


class BundleError(Exception):
    """The bundle cannot be distributed; the message gives the reason."""


def say(line: str) -> None:
    """Prints one line of progress at once."""
    print(line, flush=True)


def system_name() -> str:
    """System and processor in the name of the bundle, such as linux-x86_64 or macos-arm64."""
    system = {"win32": "windows", "darwin": "macos"}.get(sys.platform, "linux")
    machine = platform.machine().lower()
    return f"{system}-{'x86_64' if machine == 'amd64' else machine}"


def bundle_name() -> str:
    """Name of the folder of the bundle, and of its archive or installer without the suffix."""
    return f"{names.COMMAND_LINE_PROGRAM}-{names.version()}-{system_name()}"


def run_pyinstaller() -> None:
    """Run PyInstaller, which writes build/bundle/dist.

    Raises
    ------
    BundleError
        If PyInstaller fails.
    """
    shutil.rmtree(BUILD_FOLDER / "dist", ignore_errors=True)
    command = [sys.executable, "-m", "PyInstaller", "--noconfirm", "--log-level", "ERROR"]
    command += [
        "--workpath",
        str(BUILD_FOLDER / "work"),
        "--distpath",
        str(BUILD_FOLDER / "dist"),
        str(SPEC_FILE),
    ]
    done = subprocess.run(command, cwd=names.CHECKOUT, check=False)
    if done.returncode != 0:
        raise BundleError("PyInstaller failed; its messages are above.")


def build_manual() -> None:
    """Build the pages of the manual in build/bundle/manual, from where PyInstaller's spec reads.

    Raises
    ------
    BundleError
        If the manual is not complete or contains an error.
    """
    from lispac.errors import InputError
    from lispac.workflow.output import manual

    shutil.rmtree(BUILD_FOLDER / "manual", ignore_errors=True)
    try:
        manual.build_manual(
            names.CHECKOUT / "resources" / "manual", BUILD_FOLDER / "manual", strict=True
        )
    except InputError as error:
        raise BundleError(str(error)) from error


def compile_functions() -> None:
    """Compile the program's functions into build/bundle/compiled, for the cache of a new user.

    Raises
    ------
    BundleError
        If a function cannot be compiled.
    """
    shutil.rmtree(BUILD_FOLDER / "compiled", ignore_errors=True)
    variables = {**os.environ, "NUMBA_CACHE_DIR": str(BUILD_FOLDER / "compiled")}
    command = [sys.executable, "-m", "lispac.workflow.planning.precompile"]
    if subprocess.call(command, cwd=names.CHECKOUT, env=variables) != 0:
        raise BundleError("The functions cannot be compiled; the reason is above.")


def contents() -> list[Path]:
    """Source paths of the files that PyInstaller put into the bundle."""
    return sources_of(
        json.loads((BUILD_FOLDER / "work" / "lispac" / "contents.json").read_text("utf-8"))
    )


def sources_of(listed: Iterable[trimming.Entry]) -> list[Path]:
    """Source files of PyInstaller's entries, without links and entries that have no file."""
    found = [Path(source) for _place, source, kind in listed if source and kind != "SYMLINK"]
    return [path for path in found if path.is_absolute()]


def compile_sources(package: Path) -> None:
    """Compile the modules that are stored as files, because a bundle never writes bytecode."""
    unchecked = py_compile.PycInvalidationMode.UNCHECKED_HASH
    prefix, sys.pycache_prefix = sys.pycache_prefix, None  # write the bytecode beside the modules
    try:
        compileall.compile_dir(package, quiet=1, invalidation_mode=unchecked)
    finally:
        sys.pycache_prefix = prefix


def strip_symbols(folder: Path) -> None:
    """Remove the debugging symbols from large libraries.

    Libraries in a folder *.libs are skipped: auditwheel has moved their sections, and strip would
    damage them.
    """
    for path in sorted(folder.rglob("*.so*")):
        movable = not path.parent.name.endswith(".libs") and not path.is_symlink()
        if movable and path.stat().st_size > 1e6:
            subprocess.run(["strip", "--strip-unneeded", str(path)], check=True)


def share_one_file(programs: Sequence[Path]) -> None:
    """Replace identical programs by hard links to one file, which saves space.

    Raises
    ------
    BundleError
        If the programs differ.
    """
    first, *others = programs
    for other in others:
        if other.read_bytes() != first.read_bytes():
            raise BundleError(
                f"{other.name} and {first.name} differ, but both come from one start script."
            )
        other.unlink()
        os.link(first, other)


def require_fit(folder: Path) -> None:
    """Check that a bundle contains no forbidden files and reports the right version.

    Raises
    ------
    BundleError
        If the bundle contains a forbidden file, or reports another version.
    """
    places = [path.relative_to(folder).as_posix() for path in folder.rglob("*")]
    found = trimming.unwanted(places)
    if found:
        raise BundleError(
            "The bundle contains files that are not allowed: " + ", ".join(sorted(found)[:10])
        )
    program = folder / f"{names.COMMAND_LINE_PROGRAM}{sysconfig.get_config_var('EXE') or ''}"
    # The program is run without this environment, except for the variable that Windows requires.
    kept = {name: os.environ[name] for name in ("SYSTEMROOT",) if name in os.environ}
    done = subprocess.run(
        [str(program), "--version"], capture_output=True, text=True, check=False, env=kept
    )
    if done.stdout.strip() != f"lispac {names.version()}":
        raise BundleError(f"{program} has a wrong version: {done.stdout}{done.stderr}")


def archive(folder: Path) -> Path:
    """Pack the folder as .tar.xz with files in a fixed order and without owners."""
    packed = folder.with_name(folder.name + ".tar.xz")
    draft = packed.with_name(packed.name + ".part")
    command = ["tar", "--create", "--file", str(draft), "--use-compress-program", "xz -T0 -6"]
    command += ["--sort=name", "--owner=0", "--group=0", "--numeric-owner", "--directory"]
    subprocess.run([*command, str(folder.parent), folder.name], check=True)
    draft.replace(packed)
    return packed


def finish_linux(folder: Path) -> None:
    """Strip the libraries, link the two programs and add the desktop files for Linux."""
    strip_symbols(folder)
    share_one_file([folder / name for name in names.PROGRAMS])
    desktop.write_into(folder)


def finish_macos(app: Path, made: Path) -> None:
    """Copy the licences into the .app and compile its modules, as in the folder.

    PyInstaller makes the .app from the folder before the folder has licences and bytecode.

    Parameters
    ----------
    app : Path; its data and the modules stored as files are in Contents/Resources
    made : Path, the folder that PyInstaller wrote
    """
    inside = app / "Contents" / "Resources"
    shutil.copy(made / licences.FILE_NAME, inside)
    compile_sources(inside / "lispac")


def installer_command() -> list[str] | None:
    """Command that makes the installer for Windows or macOS; None if its tool is missing."""
    here = names.CHECKOUT / "installer"
    if sys.platform == "darwin":
        return ["sh", str(here / "macos" / "make-dmg.sh")]
    found = next((path for path in map(shutil.which, INNO_SETUP_PROGRAMS) if path), None)
    return [found, str(here / "windows" / "lispac.iss")] if found else None


def write_names(folder: Path) -> None:
    """Write the shared names into files that the scripts for Windows and macOS include."""
    values = {**names.shared(), "BundleFolder": str(folder), "BundleName": bundle_name()}
    BUILD_FOLDER.mkdir(parents=True, exist_ok=True)
    (BUILD_FOLDER / "names.iss").write_text(names.for_inno_setup(values), encoding="utf-8-sig")
    (BUILD_FOLDER / "names.sh").write_text(names.for_shell(values), encoding="utf-8")


def build(*, packed: bool) -> Path:
    """Build the bundle; returns its folder in dist/.

    Raises
    ------
    BundleError
        If a program fails, or the bundle is not as required.
    LicenceMissingError
        If a component has no licence text.
    """
    say("Building the manual")
    build_manual()
    say("Compiling functions (about two minutes)")
    compile_functions()
    say("Collecting the files (about a minute)")
    run_pyinstaller()
    made = BUILD_FOLDER / "dist" / names.COMMAND_LINE_PROGRAM
    say("Collecting the licences")
    site = Path(sysconfig.get_path("purelib"))
    found = licences.collected(contents(), site, names.CHECKOUT, licences.read_notices())
    (made / licences.FILE_NAME).write_text(licences.written(found), encoding="utf-8")
    compile_sources(made / "_internal" / "lispac")
    if sys.platform == "linux":
        finish_linux(made)
    if sys.platform == "darwin":
        finish_macos(BUILD_FOLDER / "dist" / f"{names.PROGRAM_NAME}.app", made)
    require_fit(made)
    folder = DIST_FOLDER / bundle_name()
    shutil.rmtree(folder, ignore_errors=True)
    DIST_FOLDER.mkdir(exist_ok=True)
    made.rename(folder)
    print_sizes(folder, len(found))
    write_names(folder)
    if packed:
        pack(folder)
    return folder


def print_sizes(folder: Path, licensed: int) -> None:
    """Print the table of sizes and the number of components with licences."""
    for line in sizes.table(sizes.by_part(folder)):
        say(line)
    say(f"{licensed} components with their licences in {licences.FILE_NAME}")


def pack(folder: Path) -> None:
    """Make the archive (Linux) or the installer (Windows, macOS) from the folder.

    Raises
    ------
    BundleError
        If Inno Setup is not installed on Windows.
    """
    if sys.platform == "linux":
        say("Packing (some minutes)")
        packed = archive(folder)
        say(f"{packed.relative_to(names.CHECKOUT)}: {packed.stat().st_size / 1e6:.0f} MB")
        return
    command = installer_command()
    if command is None:
        raise BundleError(
            "Inno Setup 6 is not installed. The folder is complete, but there is no installer."
        )
    subprocess.run(command, check=True)


def main(arguments: Iterable[str] | None = None) -> int:
    """Runs the build; returns the exit code."""
    form = argparse.ArgumentParser(description=__doc__)
    form.add_argument("--no-archive", action="store_true", help="the folder only, unpacked")
    options = form.parse_args(None if arguments is None else list(arguments))
    try:
        folder = build(packed=not options.no_archive)
    except (BundleError, licences.LicenceMissingError) as error:
        print(error, file=sys.stderr)
        return 1
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"The bundle cannot be made: {error}", file=sys.stderr)
        return 1
    say(f"The bundle is {folder.relative_to(names.CHECKOUT)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
