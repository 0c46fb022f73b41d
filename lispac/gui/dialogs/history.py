"""The calibrations of a vessel's system over the years, in a table and as a control chart."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from lispac.adjustment.result import ANGLES
from lispac.gui.dialogs.study import StudyDialog
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.language import short_date
from lispac.workflow.history import Entry, History, verdict

AT = 50.0
"""Metres, where the table says what a difference does to a point."""

COLUMNS = (
    Column("Day", "First day of the survey", words=True),
    Column("Calibration", "Its project", words=True),
    *(
        Column(f"{angle.capitalize()}{what} (deg)", f"{tip} of {angle}, degrees", base="°")
        for angle in ANGLES
        for what, tip in (("", "Estimated value"), (" ±", "1 sigma"))
    ),
    *(
        Column(f"Δ {angle} (sigmas)", f"{angle.capitalize()} less the mean of the calibrations "
               "before, over the sigma of that difference")
        for angle in ANGLES
    ),
    Column(f"Moves at {AT:.0f} m (cm)", "How far a point is from where the mean of the "
           "calibrations before puts it, at most"),
    Column("Verdict", "Beyond three sigmas, the angles taken together, the mounting has moved",
           words=True),
)  # fmt: skip


class HistoryDialog(StudyDialog):
    """One system at a time, that with most calibrations first."""

    def __init__(
        self, histories: Sequence[History], remarks: Sequence[str], parent: QWidget | None = None
    ) -> None:
        table = DiagnosticsTable("history_table", "Calibrations over the years", COLUMNS)
        super().__init__(
            "history", "Calibrations over the years",
            "Each calibration is held against the mean of those before it. A system is a vessel "
            "with its scanner and INS/GNSS, as named in the details for the report.",
            table, parent,
        )  # fmt: skip
        self._histories, self._remarks = tuple(histories), tuple(remarks)
        self.system = widgets.Choice(
            "history_system", [each.system.in_words for each in histories],
            "Whose calibrations are shown",
        )  # fmt: skip
        self.system.setSizeAdjustPolicy(self.system.SizeAdjustPolicy.AdjustToContents)
        self.system.currentIndexChanged.connect(self._show)
        self.body.insertWidget(1, self.system)
        self.resize(1260, 820)
        self._show()

    def _show(self) -> None:
        from lispac.report.control_charts import control_figure

        history = self._histories[self.system.currentIndex()]
        self.show_rows([_row(each) for each in history.entries])
        self.said.setText(say("\n".join((*history.remarks, *self._remarks))))
        self.said.setVisible(bool(self.said.text()))
        control_figure(
            [each.day for each in history.entries],
            [each.charted for each in history.entries],
            self.figure(),
            say,
        )
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(say(f"Control chart of {history.system.in_words}"))


def _row(entry: Entry) -> Row:
    charted = entry.charted
    found, change = charted.calibration, charted.change
    angles, sigmas = np.degrees(found.boresight), np.degrees(found.sigma)
    cells = [Cell(entry.day.isoformat(), shown=short_date(entry.day)), Cell(found.name)]
    for angle, sigma in zip(angles, sigmas, strict=True):
        cells += [number(angle, "+.4f"), number(sigma, ".4f")]
    if change is None:
        cells += [number(None, "")] * 4
    else:
        cells += [number(value, "+.1f") for value in change.significance]
        cells.append(number(change.displacement(AT), ".1f", 100.0))
    word = "first" if change is None else "has moved" if charted.moved else "agrees"
    return Row((*cells, Cell(word)), marked=charted.moved, tip=verdict(entry))
