"""What each source of error does to a point at a distance."""

from PySide6.QtWidgets import QWidget

from lispac.gui.dialogs.study import StudyDialog
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.report.budget_values import Budget

PARTS = (
    ("Horiz.", "In the plane of north and west", "horizontal_m"),
    ("Vert.", "Upwards", "vertical_m"),
    ("Across", "Across the beam", "across_beam_m"),
)


class BudgetDialog(StudyDialog):
    """A row for each source, for one direction of the beam at a time."""

    def __init__(self, budget: Budget, parent: QWidget | None = None) -> None:
        columns = (
            Column("Source", "What makes a point uncertain", words=True),
            *(
                Column(f"{name} {far:g} m (cm)", f"{tip}, 1 sigma, {far:g} m from the scanner")
                for far in budget.distances_m
                for name, tip, _ in PARTS
            ),
        )
        table = DiagnosticsTable("budget_table", "Error budget", columns)
        super().__init__(
            "budget", "Error budget",
            "What each source of error does to a point, as a standard deviation in centimetres, by "
            "the derivatives of the adjustment.",
            table, parent,
        )  # fmt: skip
        self._budget = budget
        self.beam = widgets.Choice(
            "budget_beam", [f"Beam {each.beam}" for each in budget.beams], "Where the beam points"
        )
        self.beam.currentIndexChanged.connect(self._show)
        self.body.insertWidget(1, self.beam)
        self.said.setText(say("\n".join(budget.in_words)))
        self.resize(1120, 620)
        self._show()

    def _show(self) -> None:
        beam = self._budget.beams[self.beam.currentIndex()]
        sums = (beam.before, beam.after)
        rows = []
        for each in (*beam.sources, *sums):
            figures = (
                [number(None, "")] * (self.table.columnCount() - 1)
                if each.at_distance is None
                else [
                    number(getattr(spread, name), ".2f", 100.0)
                    for spread in each.at_distance
                    for _, _, name in PARTS
                ]
            )
            tip = "How well it is known is not stated" if each.at_distance is None else ""
            rows.append(Row((Cell(each.source), *figures), marked=each in sums, tip=tip))
        self.show_rows(rows)
