"""Tests that texts from files are shown as plain text, even if they look like HTML."""

import re

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QLineEdit, QMessageBox
from pytestqt.qtbot import QtBot

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.widgets.error_box import error_box
from tests.gui.french_support import texts
from tests.gui.support import Driver, labels_that_guess, open_step

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


def test_a_backslash_in_a_name_is_not_doubled(adjusted: Driver, qtbot: QtBot) -> None:
    """A target cannot have such a name; the message gives it as typed."""
    name, table = r"Quai\nord", adjusted.window.targets.table
    open_step(adjusted, 1)
    table.setCurrentCell(0, 0)
    table.setFocus()
    adjusted.bot.keyClick(table, Qt.Key.Key_F2)
    editor = table.findChild(QLineEdit)
    editor.selectAll()
    adjusted.bot.keyClicks(editor, name)
    adjusted.bot.keyClick(editor, Qt.Key.Key_Return)
    adjusted.bot.waitUntil(lambda: bool(adjusted.dialogs.errors))
    box = error_box(None, adjusted.dialogs.errors.pop())
    qtbot.addWidget(box)
    found = [text for text in texts(box) if "Quai" in text]
    assert found
    assert [text for text in found if name not in text] == []


@pytest.mark.parametrize("text", [PICTURE, "<b>L1</b>\nsecond", "plain & simple", "a < b"])
def test_tooltips_escape_html(text: str) -> None:
    tip = widgets.plain_tip(text)
    if Qt.mightBeRichText(text):
        assert "<img" not in tip
        assert "<b>" not in tip
    else:
        assert tip == text
