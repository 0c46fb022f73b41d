"""Check the bundle and the commands of the README on a minimal Debian.

    sudo .venv/bin/python -m tests.extras.clean_root bundle     build it, copy it in, run it there
    sudo .venv/bin/python -m tests.extras.clean_root readme     demo and test from a fresh clone

debootstrap makes a minimal root once; each run works in a copy of it, in a chroot with its own
mounts, which end with it. The log contains the steps with their times and the size of the root.
Files that are needed to reach package servers (certificates, pip's settings) are copied with
--give.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
NETWORK = ["/etc/resolv.conf", "/etc/hosts"]
# Libraries that the installation page of the manual requires for the bundle
LIBRARIES = (
    "libgl1 libegl1 libglx-mesa0 libx11-xcb1 libwayland-cursor0 libwayland-egl1 libfontconfig1 "
    "libusb-1.0-0 fonts-dejavu-core"
)
PATH = "/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
SCREEN = "xvfb"
DESKTOP = "desktop-file-utils shared-mime-info libglib2.0-bin"
FIND_PYTHON = "for name in python3 python; do if command -v $name; then exit 1; fi; done"
# Xvfb keeps the contents of the screen in a file, which is read from outside.
START_SCREEN = "mkdir -p /tmp/screen; Xvfb :7 -screen 0 1600x1000x24 -fbdir /tmp/screen & sleep 3"


class RootError(Exception):
    """A check failed; the message says why."""


def say(line: str) -> None:
    """Print a line of the log without buffering."""
    print(line, flush=True)


def megabytes(folder: Path) -> float:
    """Size of a folder on the disk, MB."""
    done = subprocess.run(
        ["du", "-s", "--one-file-system", "-B1000", str(folder)],
        capture_output=True,
        text=True,
        check=False,
    )
    return int(done.stdout.split()[0]) / 1e3


def mirror_of_this_machine() -> str:
    """Package server that apt uses on this machine."""
    for path in [Path("/etc/apt/sources.list"), *Path("/etc/apt/sources.list.d").glob("*")]:
        if path.is_file():
            found = re.search(r"https?://\S+/debian/?(?=\s|$)", path.read_text(), re.MULTILINE)
            if found:
                return found.group()
    raise RootError("apt names no Debian server here; give one with --mirror.")


class Root:
    """Folder with a Debian system that runs in a chroot.

    Parameters
    ----------
    folder : Path
    arguments : sequence of str
        Files of this machine that are copied into the root.
    """

    def __init__(self, folder: Path, arguments: Sequence[str]) -> None:
        self.folder, self.arguments = folder, arguments

    def make(self, base: Path, suite: str, mirror: str) -> None:
        """Copy the minimal system, which is made first if it does not exist."""
        if not (base / "etc" / "debian_version").exists():
            began = time.monotonic()
            shutil.rmtree(base, ignore_errors=True)
            subprocess.run(
                ["debootstrap", "--variant=minbase", suite, str(base), mirror],
                check=True,
                stdout=subprocess.DEVNULL,
            )
            say(f"debootstrap: {time.monotonic() - began:.0f} s")
        shutil.rmtree(self.folder, ignore_errors=True)
        subprocess.run(["cp", "-a", str(base), str(self.folder)], check=True)
        self.give()
        say(f"minimal {suite}: {megabytes(self.folder):.0f} MB")

    def give(self) -> None:
        """Copy the given files, again after an installation, because packages may replace them.

        They are not mounted, because packages in the root must not write to this machine.
        """
        for path in self.arguments:
            there = self.folder / path.lstrip("/")
            there.parent.mkdir(parents=True, exist_ok=True)
            there.unlink(missing_ok=True)
            shutil.copy(path, there)

    def command(self, script: str) -> list[str]:
        """Command that runs a shell script in the root, with its own mounts and environment."""
        place = shlex.quote(str(self.folder))
        mounts = [
            "mount --make-rprivate /",
            f"mount -t proc proc {place}/proc",
            f"mount -t tmpfs -o mode=755 tmpfs {place}/dev",
            f"mkdir {place}/dev/shm",
            f"mount -t tmpfs tmpfs {place}/dev/shm",
            f"mkdir {place}/dev/pts",
            f"mount -t devpts -o newinstance,ptmxmode=666 devpts {place}/dev/pts",
            f"ln -s pts/ptmx {place}/dev/ptmx",
            f"ln -s /proc/self/fd {place}/dev/fd",
        ]
        devices = {"null": 3, "zero": 5, "full": 7, "random": 8, "urandom": 9}
        for name, minor in devices.items():
            mounts.append(f"mknod -m 666 {place}/dev/{name} c 1 {minor}")
        kept = ("PIP_CERT", "SSL_CERT")  # variables with the paths of certificates
        passed = [f"{name}={value}" for name, value in os.environ.items() if name.startswith(kept)]
        passed += ["HOME=/root", f"PATH={PATH}", "LANG=C.UTF-8"]
        inside = shlex.join(["chroot", str(self.folder), "env", "-i", *passed, "sh", "-ec", script])
        whole = " && ".join([*mounts, f"exec {inside}"])
        # Processes that still run when the script ends, such as the screen, are killed
        return ["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-ec", whole]

    def run(self, what: str, script: str) -> str:
        """Run a shell script in the root, log its time, and return its output.

        Raises
        ------
        RootError
            If the script fails.
        """
        began = time.monotonic()
        done = subprocess.run(
            self.command(script),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            check=False,
        )
        if done.returncode != 0:
            tail = "\n    ".join(done.stdout.splitlines()[-40:])
            raise RootError(f"{what} failed with {done.returncode}:\n    {tail}")
        say(f"{what}: {time.monotonic() - began:.1f} s, root {megabytes(self.folder):.0f} MB")
        return done.stdout

    def install(self, packages: str) -> None:
        """Install packages of the distribution."""
        update = "export DEBIAN_FRONTEND=noninteractive; apt-get -qq update"
        command = f"{update}; apt-get -qq install -y --no-install-recommends {packages}"
        self.run(f"apt-get install {packages}", command)
        self.give()


def picture(root: Root, output: Path) -> int:
    """Write a picture of the screen as PNG; return its number of colours."""
    import numpy as np
    from matplotlib.image import imsave

    raw = (root.folder / "tmp" / "screen" / "Xvfb_screen0").read_bytes()
    head = np.frombuffer(raw[:100], dtype=">u4")  # X11's XWDFile.h
    size, width, height, per_line, colours = (int(head[i]) for i in (0, 4, 5, 12, 19))
    begin = size + 12 * colours
    rows = np.frombuffer(raw[begin : begin + per_line * height], dtype=np.uint8)
    pixels = rows.reshape(height, per_line)[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1]
    imsave(output, np.ascontiguousarray(pixels))
    return len(np.unique(pixels.reshape(-1, 3), axis=0))


def window(root: Root, command: str, output: Path, seconds: float = 150) -> None:
    """Open the window on a virtual screen and save a picture of it.

    Raises
    ------
    RootError
        If the program ends or draws nothing.
    """
    script = f"{START_SCREEN}; export DISPLAY=:7; exec {command} > /tmp/window.log 2>&1"
    began, found = time.monotonic(), 0
    with subprocess.Popen(root.command(script), stdout=subprocess.DEVNULL) as process:
        try:
            while time.monotonic() - began < seconds and found < 500:
                time.sleep(5)
                if process.poll() is not None:
                    log_text = (root.folder / "tmp" / "window.log").read_text(errors="replace")
                    raise RootError(f"{command} ended with {process.returncode}:\n{log_text}")
                if (root.folder / "tmp" / "screen" / "Xvfb_screen0").exists():
                    found = picture(root, output)
            shown = time.monotonic() - began
            time.sleep(15)
            found = picture(root, output)
        finally:
            process.kill()
    if found < 500:
        raise RootError(f"{command}: the screen has {found} colours only, see {output}")
    log_text = (root.folder / "tmp" / "window.log").read_text(errors="replace").strip()
    say(f"{command}: shows its points after {shown:.0f} s, {found} colours: {output}")
    if log_text:
        say(f"    it says: {log_text[:500]}")


def check_bundle(root: Root, folder: Path, output: Path) -> None:
    """Run the command line, the window and the report of a bundle in a root without Python.

    Parameters
    ----------
    root : a minimal root
    folder : Path, the unpacked bundle
    output : Path, folder for the report and the pictures
    """
    subprocess.run(["cp", "-a", str(folder), str(root.folder / "opt")], check=True)
    here = f"/opt/{folder.name}"
    root.run("there is no Python", FIND_PYTHON)
    version = root.run("lispac --version", f"{here}/lispac --version").strip()
    say(f"    {version}; the bundle has {megabytes(folder):.0f} MB")
    root.install(LIBRARIES)
    lacking = root.run(
        "every library finds those it needs",
        f"find {here}/_internal -name '*.so*' -type f > /tmp/libraries; "
        f"export LD_LIBRARY_PATH={here}/_internal; "
        'while read -r file; do ldd "$file" 2>/dev/null | grep "not found" | '
        'sed "s|^|$file|"; done < /tmp/libraries; true',
    )
    if lacking.strip():
        raise RootError(f"Libraries are missing:\n{lacking}")
    pages = f"{here}/_internal/resources/manual/html"
    root.run("the manual is built", f"test -s {pages}/en/index.html -a -s {pages}/fr/index.html")
    project = "/root/demo"
    printed = root.run(
        "lispac demo --no-window", f"{here}/lispac demo --output {project} --no-window"
    )
    say("    " + "\n    ".join(printed.splitlines()[-12:]))
    again = f"cd /tmp; {here}/lispac estimate {project}"
    root.run("lispac estimate, compiled before", again)
    shutil.copy(root.folder / project.lstrip("/") / "report.pdf", output / "report.pdf")
    root.install(SCREEN)
    root.run("there is still no Python", FIND_PYTHON)
    window(root, f"{here}/lispac-gui {project}/project.lispac", output / "window.png")
    root.run("install.sh /usr/local", f"{here}/install.sh /usr/local; lispac --version")
    root.install(DESKTOP)
    kind = root.run(
        "the desktop knows a project",
        "/opt/lispac-*/install.sh /usr/local; "
        "desktop-file-validate /usr/local/share/applications/lispac.desktop; "
        f"gio info -a standard::content-type {project}/project.lispac; "
        "gio mime application/x-lispac-project",
    )
    if "application/x-lispac-project" not in kind or "lispac.desktop" not in kind:
        raise RootError(f"The file type is not tied to the program:\n{kind}")
    root.run("uninstall.sh", "/usr/local/lib/lispac/uninstall.sh /usr/local; ! command -v lispac")
    remaining = root.run("what is left", "find /usr/local -iname '*lispac*'").strip()
    if remaining:
        raise RootError(f"uninstall.sh leaves {remaining}")


def check_readme(root: Root, output: Path, tests: Sequence[str]) -> None:
    """Run both commands of the README in a fresh clone.

    Parameters
    ----------
    root : a minimal root; Python and git, which a reader has, are installed in it
    output : Path, folder for the report
    tests : arguments of the second command; empty for all tests
    """
    root.install("python3 git ca-certificates")
    bare = root.folder / "srv" / "lispac.git"
    subprocess.run(["git", "clone", "-q", "--bare", str(CHECKOUT), str(bare)], check=True)
    clone = "cd /root; git -c safe.directory='*' clone -q /srv/lispac.git lispac"
    root.run("git clone", clone)
    say(root.run("bootstrap.py demo", "cd /root/lispac; python3 installer/bootstrap.py demo"))
    shutil.copy(root.folder / "root/.cache/lispac/demo/report.pdf", output / "readme-report.pdf")
    root.run("bootstrap.py demo again", "cd /root/lispac; python3 installer/bootstrap.py demo")
    command = shlex.join(["python3", "installer/bootstrap.py", "test", *tests])
    printed = root.run("bootstrap.py test", f"cd /root/lispac; {command}")
    say("    " + "\n    ".join(printed.splitlines()[-8:]))
    root.run("the clone is clean", 'cd /root/lispac; [ -z "$(git status --porcelain)" ]')


def parser() -> argparse.ArgumentParser:
    """Argument parser of this script."""
    form = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    form.add_argument("what", choices=("bundle", "readme"))
    form.add_argument("--work", type=Path, default=CHECKOUT / "build" / "clean-root")
    form.add_argument("--bundle", type=Path, help="a bundle that is built already")
    form.add_argument("--suite", default="bookworm")
    form.add_argument("--mirror", help="Debian server (usual: the one apt asks here)")
    form.add_argument("--give", action="append", default=[], metavar="FILE")
    form.add_argument("--test", action="append", default=[], help="for bootstrap.py test")
    return form


def built() -> Path:
    """Build the bundle with its command, and return its folder."""
    began = time.monotonic()
    command = [sys.executable, str(CHECKOUT / "installer" / "bootstrap.py"), "bundle"]
    subprocess.run(command, check=True)
    say(f"bootstrap.py bundle: {time.monotonic() - began:.0f} s")
    folders = [path for path in (CHECKOUT / "dist").glob("lispac-*-linux-*") if path.is_dir()]
    return max(folders, key=lambda path: path.stat().st_mtime)


def main() -> int:
    """Run one of the checks; return the exit code."""
    options = parser().parse_args()
    began = time.monotonic()
    options.work.mkdir(parents=True, exist_ok=True)
    root = Root(options.work / options.what, [*NETWORK, *options.give])
    try:
        root.make(options.work / "base", options.suite, options.mirror or mirror_of_this_machine())
        if options.what == "bundle":
            check_bundle(root, (options.bundle or built()).absolute(), options.work)
        else:
            check_readme(root, options.work, options.test)
    except (RootError, OSError, subprocess.CalledProcessError) as error:
        print(error, file=sys.stderr)
        return 1
    say(f"{options.what}: all of it {time.monotonic() - began:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
