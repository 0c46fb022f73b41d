"""Dialogues about exported data and the script."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import QDialog, QHBoxLayout, QPlainTextEdit, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.export.actions import ACTIONS
from lispac.language import N_, gettext
from lispac.project import Project

if TYPE_CHECKING:
    from lispac.project import BoresightChoice
    from lispac.survey.trajectory import LocalTrajectory
    from lispac.workflow.output.export_request import ExportContent, ExportRequest
    from lispac.workflow.output.script import Script

SCRIPT_INTRODUCTION = N_(
    "This Python script recomputes the project from its raw files and gives the same results. You "
    "can edit it and run it without this window."
)


class ScriptDialog(QDialog):
    """Dialogue to copy or save the script of the project.

    Parameters
    ----------
    save : function that asks for a file, saves it, and returns a text; empty if nothing was saved
    """

    def __init__(
        self, script: "Script", save: Callable[[], str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("script_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["script"]))
        self._save = save
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(widgets.label(gettext(SCRIPT_INTRODUCTION), wrap=True))
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


class ExportDialogs(Questions):
    """Dialogues about exported data and the script."""

    def export(
        self,
        what: "ExportContent",
        which: "BoresightChoice",
        project: Project,
        trajectory: "LocalTrajectory",
    ) -> "ExportRequest | None":
        """Ask for the options of an export; None if cancelled."""
        from lispac.gui.features.export.export_dialog import ExportDialog

        dialog = ExportDialog(what, which, project, trajectory, self.parent)
        return dialog.request() if run_dialog(dialog) else None

    def script_file(self, start: Path) -> Path | None:
        """File for the script of the project."""
        saved = self.file_to_save(gettext("Save the script"), start, {"Python (*.py)": ".py"})
        return None if saved is None else saved[0]

    def script(self, script: "Script", save: Callable[[], str]) -> None:
        """Show the script of the project; ``save`` saves it and returns a text about it."""
        run_dialog(ScriptDialog(script, save, self.parent))
