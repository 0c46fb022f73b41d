"""Helpers for tests of the import dialogue: drop files, wait for their examination."""

from collections.abc import Sequence
from pathlib import Path

import laspy
import numpy as np
from PySide6.QtCore import QCoreApplication, QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from tests.gui.support import WAIT_MS, Demo, finish_layouts


def drop(widget: QWidget, paths: Sequence[Path]) -> None:
    """Send the events of a file drop to a widget."""
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    actions, buttons = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton
    no_keys = Qt.KeyboardModifier.NoModifier
    entering = QDragEnterEvent(QPoint(20, 20), actions, mime, buttons, no_keys)
    QCoreApplication.sendEvent(widget, entering)
    assert entering.isAccepted()
    dropping = QDropEvent(QPointF(20, 20), actions, mime, buttons, no_keys)
    QCoreApplication.sendEvent(widget, dropping)
    assert dropping.isAccepted()
    QCoreApplication.processEvents()


def rest(bot: QtBot, dialog: ImportDialog) -> None:
    """Wait until every file has been examined."""
    QCoreApplication.processEvents()
    bot.waitUntil(lambda: not dialog.work.busy, timeout=WAIT_MS)
    QCoreApplication.processEvents()
    finish_layouts()


def raw(demo: Demo) -> list[Path]:
    project = demo.project
    assert project.accuracy is not None
    return [project.trajectory, project.accuracy, *(line.path for line in project.lines)]


def shifted(line: Path, to: Path, seconds: float) -> Path:
    las = laspy.read(line)
    las.gps_time = np.asarray(las.gps_time) + seconds
    las.write(to)
    return to


def texts(dialog: ImportDialog, column: int) -> list[str]:
    table = dialog.table
    found = []
    for row in range(table.rowCount()):
        combo = table.cellWidget(row, column)
        found.append(combo.currentText() if combo else table.item(row, column).text())
    return found
