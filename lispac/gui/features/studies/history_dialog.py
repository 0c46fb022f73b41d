"""Dialogue with the calibrations of a system over time: table and control chart."""

from collections.abc import Sequence

from PySide6.QtWidgets import QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import gettext
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.present.calibrations import HISTORY_TABLE
from lispac.workflow.checking.calibration_history import CalibrationHistory


class HistoryDialog(StudyDialog):
    """Dialogue that shows one system at a time, initially the one with most calibrations."""

    def __init__(
        self,
        histories: Sequence[CalibrationHistory],
        messages: Sequence[Message],
        parent: QWidget | None = None,
    ) -> None:
        title = dialog_title(ACTIONS["history"])
        table = DiagnosticsTable("history_table", title, window_columns(HISTORY_TABLE))
        super().__init__(
            "history", title,
            gettext(
                "Each calibration is compared with the mean of the earlier ones. A system is a "
                "combination of vessel, scanner and INS/GNSS, as named in the details for the "
                "report."
            ),
            table, parent,
        )  # fmt: skip
        self._histories, self._notes = tuple(histories), tuple(messages)
        self.system = widgets.ChoiceBox("history_system", [""], gettext("System to show"))
        self.system.clear()
        self.system.addItems([each.system.full_name for each in histories])
        self.system.setSizeAdjustPolicy(self.system.SizeAdjustPolicy.AdjustToContents)
        self.system.currentIndexChanged.connect(self._show)
        self.body.insertWidget(1, self.system)
        self.resize(1260, 820)
        self._show()

    def _show(self) -> None:
        from lispac.report.control_charts import control_chart_figure

        history = self._histories[self.system.currentIndex()]
        self.show_rows(
            window_rows(
                HISTORY_TABLE,
                history.calibrations,
                marked=lambda row: row.moved,
                tip=lambda row: message_text(row.message),
            )
        )
        messages = map(message_text, (*history.messages, *self._notes))
        self.message_label.setText("\n".join(messages))
        self.message_label.setVisible(bool(self.message_label.text()))
        control_chart_figure(history.calibrations, self.figure())
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(
            gettext("Control chart of {system}", system=history.system.full_name)
        )
