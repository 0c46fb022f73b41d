"""What the system asks of the running program."""

import os
import subprocess
import sys
from pathlib import Path

from lispac.gui.dialogs.import_files.dialog import survey_files
from lispac.io.formats import ACCURACIES, POINTS, TRAJECTORIES

ASKED = """
import sys
from pathlib import Path
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtGui import QFileOpenEvent
from lispac.gui.app import Application

application, asked = Application(sys.argv[:1]), []
application.document_asked.connect(asked.append)
event = QFileOpenEvent(sys.argv[1])
assert QCoreApplication.sendEvent(application, event)
QCoreApplication.sendEvent(application, QEvent(QEvent.Type.ApplicationFontChange))
assert asked == [Path(sys.argv[1])], asked
"""


def test_a_document_that_the_system_asks_for_is_told(tmp_path: Path) -> None:
    """A double click starts no second program on macOS: the one that runs is told."""
    done = subprocess.run(
        [sys.executable, "-c", ASKED, str(tmp_path / "project.lispac")],
        capture_output=True, text=True, check=False, timeout=120,
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr


def test_the_dialogue_shows_the_files_of_every_format() -> None:
    shown, everything = survey_files().split(";;")
    patterns = shown[shown.index("(") + 1 : -1].split(" ")
    assert len(patterns) == len(set(patterns))
    for each in (*POINTS, *TRAJECTORIES, *ACCURACIES):
        assert {f"*{ending}" for ending in each.endings} <= set(patterns), each.name
    assert everything.endswith(" (*)")
