"""The report from the window: its details."""

from PySide6.QtWidgets import QLabel, QLineEdit, QPlainTextEdit, QPushButton, QWidget

from lispac.identity import NAMES
from tests.gui.support import Driver, Key, Left, click, open_step, type_into
from tests.gui.test_gui_seed_at import hand

REPORT = 4


def field(dialog: QWidget, name: str) -> QLineEdit | QPlainTextEdit:
    return dialog.findChild(QLineEdit, f"identity_{name}") or dialog.findChild(
        QPlainTextEdit, f"identity_{name}"
    )


def test_details_are_one_undo_step(adjusted: Driver) -> None:
    before = adjusted.project
    open_step(adjusted, REPORT)

    def answer(dialog: QWidget) -> None:
        for name in NAMES:
            type_into(adjusted, field(dialog, name), f"the {name}")
        adjusted.bot.mouseClick(dialog.findChild(QPushButton, "identity_keep"), Left)

    hand(adjusted, answer)
    click(adjusted, adjusted.window.report.details)
    assert [getattr(adjusted.project.identity, name) for name in NAMES] == [
        f"the {name}" for name in NAMES
    ]
    assert adjusted.project.result is before.result
    assert adjusted.window.document.undo_stack.undoText() == "details for the report"
    assert adjusted.window.document.is_modified
    adjusted.window.document.undo_stack.undo()
    assert adjusted.project is before


def test_what_is_wrong_is_said_and_cancel_changes_nothing(opened: Driver) -> None:
    open_step(opened, 0)
    before = opened.project

    def answer(dialog: QWidget) -> None:
        said, keep = (
            dialog.findChild(QLabel, "identity_said"),
            dialog.findChild(QPushButton, "identity_keep"),
        )
        type_into(opened, field(dialog, "vessel"), "V" * 201)
        assert said.text().startswith("Vessel: longer than 200 letters")
        assert not keep.isEnabled()
        type_into(opened, field(dialog, "vessel"), "V")
        assert said.text() == ""
        assert keep.isEnabled()
        opened.bot.mouseClick(dialog.findChild(QPushButton, "identity_dates_of_lines"), Left)
        assert "do not tell the date" in said.text()
        assert field(dialog, "dates").text() == ""
        opened.bot.keyClick(dialog, Key.Key_Escape)

    hand(opened, answer)
    click(opened, opened.window.data.details)
    assert opened.project is before
    assert opened.window.document.undo_stack.count() == 0
