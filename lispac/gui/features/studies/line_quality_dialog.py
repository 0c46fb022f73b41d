"""Dialogue with the differences between lines: table and map."""

from PySide6.QtWidgets import QWidget

from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.line_differences import LINE_DIFFERENCES_TABLE
from lispac.workflow.checking.line_quality import LineQuality
from lispac.workflow.output.georeferencing import BoresightChoice

INTRODUCTIONS: dict[BoresightChoice, str] = {
    "prior": N_(
        "The table shows the differences between each pair of lines on flat surfaces, along the "
        "surface normal and with the prior boresight. The project is not changed."
    ),
    "estimated": N_(
        "The table shows the differences between each pair of lines on flat surfaces, along the "
        "surface normal and with the estimated boresight. The project is not changed."
    ),
}


class LineQualityDialog(StudyDialog):
    """Dialogue with a row for each pair of lines and surface orientation, and a map."""

    def __init__(self, quality: LineQuality, parent: QWidget | None = None) -> None:
        title = dialog_title(ACTIONS["line_quality"])
        table = DiagnosticsTable(
            "line_quality_table", title, window_columns(LINE_DIFFERENCES_TABLE)
        )
        super().__init__(
            "line_quality", title, gettext(INTRODUCTIONS[quality.which]), table, parent
        )
        self.show_rows(window_rows(LINE_DIFFERENCES_TABLE, quality.rows()))
        self.message_label.setText("\n".join(map(message_text, quality.not_compared)))
        self.message_label.setVisible(bool(quality.not_compared))
        self._draw(quality)
        self.resize(900, 760)

    def _draw(self, quality: LineQuality) -> None:
        # Matplotlib is imported late, so that the window starts without it.
        from lispac.report.line_map import line_difference_map

        line_difference_map(quality.pairs, self.figure())
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(gettext("Map of the differences between lines"))
