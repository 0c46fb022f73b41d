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

PICTURE = '<img src="https://example.org/x.png"> line'


def is_plain(label: QLabel) -> bool:
    return label.textFormat() == Qt.TextFormat.PlainText


def test_labels_and_message_boxes_show_plain_text(qtbot: QtBot) -> None:
    label = widgets.label()
    box = widgets.MessageBox(QMessageBox.Icon.Question, "LISPAC", PICTURE)
    box.setInformativeText(PICTURE)
    error = error_box(None, InputError(f"{PICTURE}: cannot be read; export it again."))
    for each in (label, box, error):
        qtbot.addWidget(each)
    assert is_plain(label)
    for each in (box, error):
        shown = [inner for inner in each.findChildren(QLabel) if PICTURE in inner.text()]
        assert shown
        assert all(map(is_plain, shown))


def test_no_label_of_the_window_guesses_its_text_format(adjusted: Driver) -> None:
    assert labels_that_guess(adjusted.window) == []
    plain = [label for label in adjusted.window.findChildren(QLabel) if is_plain(label)]
    assert len(plain) > 50
    assert [label.text() for label in plain if re.search(r"</?\w+>", label.text())] == []


@pytest.mark.parametrize("text", [PICTURE, "<b>L1</b>\nsecond", "plain & simple", "a < b"])
def test_tooltips_escape_html(text: str) -> None:
    tip = widgets.plain_tip(text)
    if Qt.mightBeRichText(text):
        assert "<img" not in tip
        assert "<b>" not in tip
    else:
        assert tip == text
