"""Tests of the application: documents opened by the system, file formats, home directory."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from lispac.gui.features.open_project.import_survey.import_dialog import survey_file_filters
from lispac.io.formats import ACCURACY_FORMATS, POINT_FORMATS, TRAJECTORY_FORMATS

OPEN_EVENT_SCRIPT = """
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtGui import QFileOpenEvent
from lispac.gui.window.program import Application

application, asked = Application(sys.argv[:1]), []
application.document_requested.connect(asked.append)
event = QFileOpenEvent(sys.argv[1])
assert QCoreApplication.sendEvent(application, event)
QCoreApplication.sendEvent(application, QEvent(QEvent.Type.ApplicationFontChange))
assert asked == [Path(sys.argv[1])], asked
"""


def test_a_document_opened_by_the_system_is_requested(tmp_path: Path) -> None:
    """On macOS, a double click sends an event to the running program and starts no second one."""
    done = subprocess.run(
        [sys.executable, "-c", OPEN_EVENT_SCRIPT, str(tmp_path / "project.lispac")],
        capture_output=True, text=True, check=False, timeout=120,
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr


def test_the_dialogue_shows_the_files_of_every_format() -> None:
    shown, everything = survey_file_filters().split(";;")
    patterns = shown[shown.index("(") + 1 : -1].split(" ")
    assert len(patterns) == len(set(patterns))
    for each in (*POINT_FORMATS, *TRAJECTORY_FORMATS, *ACCURACY_FORMATS):
        assert {f"*{ending}" for ending in each.endings} <= set(patterns), each.name
    assert everything.endswith(" (*)")


WINDOW_SCRIPT = """
import sys
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from lispac.gui.window import program
from lispac.gui.window.main_window import MainWindow

def inspect_window():
    windows = [w for w in QApplication.topLevelWidgets() if isinstance(w, MainWindow)]
    if not windows:  # the splash screen processes events
        QTimer.singleShot(10, inspect_window)
        return
    (window,) = windows
    print(window.log.toPlainText())
    window.settings.units = ("degrees", "millimetres")
    window.settings.sync()
    print(window.settings.folder)
    QApplication.exit(0)

program.IMPORT_DELAY_MS = 3_600_000
application = QApplication(sys.argv[:1])
QTimer.singleShot(0, inspect_window)
sys.exit(program.main([]))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the variables are those of Linux")
def test_the_window_says_that_the_home_directory_cannot_be_written(tmp_path: Path) -> None:
    own = ("NUMBA_CACHE_DIR", "MPLCONFIGDIR", "XDG_CACHE_HOME", "XDG_CONFIG_HOME")
    variables = {name: value for name, value in os.environ.items() if name not in own}
    home = tmp_path / "missing"
    variables |= {"HOME": str(home), "TMPDIR": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    done = subprocess.run(
        [sys.executable, "-c", WINDOW_SCRIPT],
        capture_output=True, text=True, check=False, timeout=60, env=variables,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    printed, folder = done.stdout.strip().rsplit("\n", 1)
    assert printed.count(f"{home / '.cache' / 'lispac'} cannot be written") == 1
    assert Path(folder).parent == tmp_path
    assert (Path(folder) / "window.ini").is_file()
    assert "cannot be written" in (Path(folder) / "lispac.log").read_text()
    assert not home.exists()
