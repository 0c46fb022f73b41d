"""Tests of the layout of the results."""

from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from lispac.gui.features.estimate.results_panel import ResultsPanel
from lispac.gui.widgets.mounting_texts import CONVENTION_NAME_TEXT


def test_the_convention_is_named_once(qtbot: QtBot) -> None:
    panel = ResultsPanel()
    qtbot.addWidget(panel)
    texts = [label.text() for label in panel.findChildren(QLabel)]
    assert sum(CONVENTION_NAME_TEXT in text for text in texts) == 1
