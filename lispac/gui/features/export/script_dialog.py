"""Dialogue with the script that reproduces the project."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import QDialog, QHBoxLayout, QPlainTextEdit, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance import theme
from lispac.gui.features.export.actions import ACTIONS
from lispac.language import N_, gettext
from lispac.message_texts import message_text

if TYPE_CHECKING:
    from lispac.workflow.output.script import Script

INTRODUCTION = N_(
    "This Python script recomputes the project from its raw files and gives the same results. You "
    "can edit it and run it without this window."
)


class ScriptDialog(QDialog):
    """Dialogue to copy or save the script of the project.

    Parameters
    ----------
    save : asks for a file, saves, and returns a text about it; empty where nothing was saved
    """

    def __init__(
        self, script: "Script", save: Callable[[], str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("script_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["script"]))
        self._save = save
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(widgets.label(gettext(INTRODUCTION), wrap=True))
        if script.messages:
            messages = widgets.label(wrap=True, name="script_messages")
            messages.setText("\n".join(map(message_text, script.messages)))
            layout.addWidget(messages)
        self.text = QPlainTextEdit(script.text)
        self.text.setObjectName("script_text")
        self.text.setAccessibleName(gettext("Script"))
        self.text.setReadOnly(True)
        self.text.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        layout.addWidget(self.text, 1)
        self.message_label = widgets.label("", "muted", name="script_message")
        copy = widgets.button(gettext("Copy"), "script_copy", tip=gettext("Copy the script"))
        copy.clicked.connect(self._copy)
        keep = widgets.button(gettext("Save…"), "script_save", icon="content-save", primary=True)
        keep.clicked.connect(self._save_script)
        close = widgets.button(gettext("Close"), "script_close")
        close.clicked.connect(self.accept)
        row = QHBoxLayout()
        row.setSpacing(theme.SPACING)
        row.addWidget(self.message_label, 1)
        for button in (copy, keep, close):
            button.setAutoDefault(False)
            row.addWidget(button)
        layout.addLayout(row)
        screen = self.screen().availableGeometry()
        self.resize(min(920, screen.width()), min(820, screen.height() - 60))
        self.text.setFocus()

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text.toPlainText())
        self.message_label.setText(gettext("Script copied"))

    def _save_script(self) -> None:
        if text := self._save():
            self.message_label.setText(text)
