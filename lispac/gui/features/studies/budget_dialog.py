"""Dialogue with the error budget: the effect of each error source on a point."""

from PySide6.QtWidgets import QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number_cell
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.report.budget_values import ErrorBudgetValues

COMPONENT_COLUMNS = (
    (
        N_("Horizontal error (cm) at {distance:m.0} m"),
        N_("Horizontal error, 1 σ, {distance:m.0} m from the scanner"),
        "horizontal_m",
    ),
    (
        N_("Vertical error (cm) at {distance:m.0} m"),
        N_("Vertical error, 1 σ, {distance:m.0} m from the scanner"),
        "vertical_m",
    ),
    (
        N_("Error across beam (cm) at {distance:m.0} m"),
        N_("Error across the beam, 1 σ, {distance:m.0} m from the scanner"),
        "across_beam_m",
    ),
)
"""Titles and tips of the columns, and the values that they show."""


class BudgetDialog(StudyDialog):
    """A row for each error source, for one direction of the beam at a time."""

    def __init__(self, budget: ErrorBudgetValues, parent: QWidget | None = None) -> None:
        columns = (
            Column(gettext("Source"), gettext("Source of error"), is_text=True),
            *(
                Column(gettext(title, distance=far), gettext(tip, distance=far))
                for far in budget.distances_m
                for title, tip, _ in COMPONENT_COLUMNS
            ),
        )
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
        sums = (beam.before, beam.after)
        rows = []
        for each in (*beam.sources, *sums):
            figures = (
                [number_cell(None, "")] * (self.table.columnCount() - 1)
                if each.at_distance is None
                else [
                    number_cell(getattr(spread, name), ".2f", 100.0)
                    for spread in each.at_distance
                    for _, _, name in COMPONENT_COLUMNS
                ]
            )
            tip = (
                gettext(
                    "The uncertainty of this source was not given, so the budget does not "
                    "include it."
                )
                if each.at_distance is None
                else ""
            )
            rows.append(Row((Cell(str(each.source)), *figures), marked=each in sums, tip=tip))
        self.show_rows(rows)
