"""The script that makes the project again: to read, to copy and to save."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import QDialog, QHBoxLayout, QPlainTextEdit, QWidget

from lispac.gui import theme
from lispac.gui.language import say
from lispac.gui.panels import widgets

if TYPE_CHECKING:
    from lispac.workflow.script import Script

WORDS = (
    "These steps make the project as it stands again from its raw files, in Python, with the same "
    "numbers. They can be edited and run without the window."
)


class ScriptDialog(QDialog):
    """Shown until it is closed; nothing in it changes the project.

    Parameters
    ----------
    save : asks where to, saves, and says where; empty where nothing was saved
    """

    def __init__(
        self, script: "Script", save: Callable[[], str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("script_dialog")
        self.setWindowTitle(say("Script of this project"))
        self._save = save
        layout = widgets.column(self, 16)
        layout.addWidget(widgets.label(WORDS, wrap=True))
        if script.remarks:
            layout.addWidget(
                widgets.label("\n".join(script.remarks), wrap=True, name="script_remarks")
            )
        self.text = QPlainTextEdit(script.text)
        self.text.setObjectName("script_text")
        self.text.setAccessibleName(say("Script"))
        self.text.setReadOnly(True)
        self.text.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        layout.addWidget(self.text, 1)
        self.said = widgets.label("", "muted", name="script_said")
        copy = widgets.button("Copy", "script_copy", tip="Copy the script")
        copy.clicked.connect(self._copy)
        keep = widgets.button("Save…", "script_save", icon="content-save", primary=True)
        keep.clicked.connect(self._keep)
        close = widgets.button("Close", "script_close")
        close.clicked.connect(self.accept)
        row = QHBoxLayout()
        row.setSpacing(theme.SPACE)
        row.addWidget(self.said, 1)
        for button in (copy, keep, close):
            button.setAutoDefault(False)
            row.addWidget(button)
        layout.addLayout(row)
        screen = self.screen().availableGeometry()
        self.resize(min(920, screen.width()), min(820, screen.height() - 60))
        self.text.setFocus()

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text.toPlainText())
        self.said.setText(say("The script is copied"))

    def _keep(self) -> None:
        if said := self._save():
            self.said.setText(say(said))
