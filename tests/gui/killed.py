"""A program in which a user renames two targets without saving, to be killed by a test.

    python -m tests.gui.killed FOLDER HOME

opens the project in FOLDER and edits it by mouse and keys, with the settings in HOME. If it is not
killed, it ends by itself.
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
"""Limit for start and edits on busy processors."""


def killed_after_editing(folder: Path) -> None:
    """Let a program edit a project, and kill it as soon as the last edit is saved."""
    home = folder.parent / "killed"
    home.mkdir()
    told = home / "told.txt"
    with told.open("w", encoding="utf-8") as out:
        program = subprocess.Popen(
            [sys.executable, "-m", "tests.gui.killed", str(folder), str(home)],
            cwd=CHECKOUT, stdout=out, stderr=subprocess.STDOUT,
            env={**os.environ, "PYTHONPATH": str(CHECKOUT)},
        )  # fmt: skip
        until = time.monotonic() + LIMIT_S
        try:
            while not _kept(folder):
                assert program.poll() is None, f"it ended by itself: {told.read_text()}"
                assert time.monotonic() < until, f"no edit is written down: {told.read_text()}"
                time.sleep(0.02)
        finally:
            program.kill()
            program.wait()
    assert program.returncode != 0, "it was killed"


def _kept(folder: Path) -> bool:
    """Test whether both edits are on the disk."""
    found = read_unsaved(folder)
    names = {target.name for target in found.targets} if found is not None else set()
    return names >= {"North wall", "South wall"}


def main() -> None:
    """Open the project, rename two targets and wait."""
    folder, home = (Path(each) for each in sys.argv[1:])
    qt_api.set_qt_api("pyside6")
    application = QApplication(sys.argv[:1])
    QTimer.singleShot(round(LIMIT_S * 1000), application.quit)
    hands = Hands(QtBot(None), VtkViewport, home)  # without a test, so it closes nothing
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
        os._exit(1)  # exit immediately: threads of the open window would wait forever
