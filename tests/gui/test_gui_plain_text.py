"""Tests that texts from files are shown as plain text, even if they look like HTML."""

import re

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QMessageBox
from pytestqt.qtbot import QtBot

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.widgets.error_box import error_box
from tests.gui.support import Driver, labels_that_guess

NAME_WITH_IMAGE = '<img src="https://example.org/x.png"> line'


def is_plain(label: QLabel) -> bool:
    return label.textFormat() == Qt.TextFormat.PlainText


def test_labels_and_message_boxes_show_names_as_plain_text(qtbot: QtBot) -> None:
    label = widgets.label()
    box = widgets.MessageBox(QMessageBox.Icon.Question, "LISPAC", NAME_WITH_IMAGE)
    box.setInformativeText(NAME_WITH_IMAGE)
    error = error_box(None, InputError(f"{NAME_WITH_IMAGE}: cannot be read; export it again."))
    for each in (label, box, error):
        qtbot.addWidget(each)
    assert is_plain(label)
    for each in (box, error):
        shown = [inner for inner in each.findChildren(QLabel) if NAME_WITH_IMAGE in inner.text()]
        assert shown
        assert all(map(is_plain, shown))


def test_no_label_of_the_window_detects_html(adjusted: Driver) -> None:
    assert labels_that_guess(adjusted.window) == []
    plain = [label for label in adjusted.window.findChildren(QLabel) if is_plain(label)]
    assert len(plain) > 50
    assert [label.text() for label in plain if re.search(r"</?\w+>", label.text())] == []


@pytest.mark.parametrize("text", [NAME_WITH_IMAGE, "<b>L1</b>\nsecond", "plain & simple", "a < b"])
def test_tooltips_load_no_resources(text: str) -> None:
    tip = widgets.plain_tip(text)
    if Qt.mightBeRichText(text):
        assert "<img" not in tip
        assert "<b>" not in tip
    else:
        assert tip == text
