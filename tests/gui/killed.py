"""A program process that renames two targets without saving, to be killed by a test.

    python -m tests.gui.killed FOLDER HOME

opens the project in FOLDER and edits it by mouse and keys, with its settings in HOME. The process
ends by itself after `LIMIT_S` seconds if it is not killed.
"""

import os
import subprocess
import sys
import time
import traceback
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qt_compat import qt_api
from pytestqt.qtbot import QtBot

from lispac.gui.viewport.vtk_viewport import VtkViewport
from lispac.io.project.project_file import read_unsaved
from tests.gui.by_hand import Hands, open_by_keys, rename
from tests.gui.support import click

CHECKOUT = Path(__file__).resolve().parents[2]
LIMIT_S = 120.0
"""Time limit for starting and editing, on busy processors."""


def killed_after_editing(folder: Path) -> None:
    """Start a program that edits a project, and kill it once the last edit is on the disk."""
    home = folder.parent / "killed"
    home.mkdir()
    output_path = home / "told.txt"
    with output_path.open("w", encoding="utf-8") as out:
        program = subprocess.Popen(
            [sys.executable, "-m", "tests.gui.killed", str(folder), str(home)],
            cwd=CHECKOUT, stdout=out, stderr=subprocess.STDOUT,
            env={**os.environ, "PYTHONPATH": str(CHECKOUT)},
        )  # fmt: skip
        until = time.monotonic() + LIMIT_S
        try:
            while not _kept(folder):
                assert program.poll() is None, f"it ended by itself: {output_path.read_text()}"
                assert time.monotonic() < until, (
                    f"no edit is written down: {output_path.read_text()}"
                )
                time.sleep(0.02)
        finally:
            program.kill()
            program.wait()
    assert program.returncode != 0, "it was killed"


def _kept(folder: Path) -> bool:
    """Whether both edits are in the unsaved work on the disk."""
    found = read_unsaved(folder)
    names = {target.name for target in found.targets} if found is not None else set()
    return names >= {"North wall", "South wall"}


def main() -> None:
    """Open the project, rename two targets, and wait."""
    folder, home = (Path(each) for each in sys.argv[1:])
    qt_api.set_qt_api("pyside6")
    application = QApplication(sys.argv[:1])
    QTimer.singleShot(round(LIMIT_S * 1000), application.quit)
    hands = Hands(QtBot(None), VtkViewport, home)  # a bot without a test closes no widgets
    open_by_keys(hands, folder)
    click(hands, hands.window.workflow.headers[1])
    rename(hands, 0, "North wall")
    rename(hands, 1, "South wall")
    application.exec()


if __name__ == "__main__":
    try:
        main()
    except BaseException:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)  # a normal exit would wait for the threads of the window for ever
