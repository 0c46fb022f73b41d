"""Dialogue with the error budget: the effect of each error source on a point."""

from PySide6.QtWidgets import QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import gettext
from lispac.message_texts import message_text
from lispac.present.error_budget import ErrorBudgetValues, budget_table


class BudgetDialog(StudyDialog):
    """Dialogue with a row for each error source, for one direction of the beam at a time."""

    def __init__(self, budget: ErrorBudgetValues, parent: QWidget | None = None) -> None:
        columns = window_columns(budget_table(budget, budget.beams[0])[0])
        table = DiagnosticsTable("budget_table", gettext("Error budget"), columns)
        super().__init__(
            "budget", dialog_title(ACTIONS["budget"]),
            gettext(
                "The table shows the standard deviation of a georeferenced point due to each "
                "error source, in centimetres. It is propagated with the derivatives used in the "
                "adjustment."
            ),
            table, parent,
        )  # fmt: skip
        self._budget = budget
        self.beam = widgets.ChoiceBox(
            "budget_beam",
            [gettext("Beam direction: {direction}", direction=each.beam) for each in budget.beams],
            gettext("Direction of the beam"),
        )
        self.beam.currentIndexChanged.connect(self._show)
        self.body.insertWidget(1, self.beam)
        self.message_label.setText("\n".join(map(message_text, budget.messages)))
        self.resize(1120, 620)
        self._show()

    def _show(self) -> None:
        beam = self._budget.beams[self.beam.currentIndex()]
        missing = gettext(
            "The uncertainty of this source was not given, so the budget does not include it."
        )
        self.show_rows(
            window_rows(
                *budget_table(self._budget, beam),
                marked=lambda row: row in (beam.before, beam.after),
                tip=lambda row: missing if row.at_distance is None else "",
            )
        )
