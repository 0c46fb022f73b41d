"""The report from the window: its details."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from lispac.workflow.survey_dates import survey_dates

if TYPE_CHECKING:
    from lispac.gui.main_window import MainWindow


class Reporting(QObject):
    """Joined to the window's parts."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._document, self._dialogs = window.document, window.dialogs
        window.report.report_asked.connect(window.life.export_report)
        for panel in (window.data, window.report):
            panel.details_asked.connect(self.ask_details)

    def ask_details(self) -> None:
        """Ask who, when and with what: one undo step."""
        project = self._document.project
        if project is None:
            return
        survey = self._document.survey if self._document.survey_is_current else None
        answer = self._dialogs.identity(
            project.identity, lambda: "" if survey is None else survey_dates(project, survey)
        )
        current = self._document.project  # a task may have ended meanwhile
        if answer is not None and current is not None and answer != current.identity:
            self._document.edit("details for the report", current.with_identity(answer))
