"""Dialogue with the calibrations of a system over time: table and control chart."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog, angle_columns
from lispac.gui.widgets.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number_cell
from lispac.language import N_, gettext, short_date
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.workflow.checking.calibration_history import (
    CalibratedSystem,
    CalibrationHistory,
    HistoryEntry,
    change_message,
)

EFFECT_DISTANCE_M = 50.0
"""Distance from the scanner of the point whose displacement is in the table, metres."""

DIFFERENCE_COLUMNS = (
    (
        N_("Δ roll (σ)"),
        N_(
            "Roll minus the mean of earlier calibrations, divided by the standard deviation of the "
            "difference"
        ),
    ),
    (
        N_("Δ pitch (σ)"),
        N_(
            "Pitch minus the mean of earlier calibrations, divided by the standard deviation of "
            "the difference"
        ),
    ),
    (
        N_("Δ yaw (σ)"),
        N_(
            "Yaw minus the mean of earlier calibrations, divided by the standard deviation of the "
            "difference"
        ),
    ),
)
"""Titles and tips of the columns of differences."""


class HistoryDialog(StudyDialog):
    """Dialogue that shows one system at a time, initially the one with most calibrations."""

    def __init__(
        self,
        histories: Sequence[CalibrationHistory],
        messages: Sequence[Message],
        parent: QWidget | None = None,
    ) -> None:
        title = dialog_title(ACTIONS["history"])
        table = DiagnosticsTable("history_table", title, _columns())
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
        self.system.addItems([_system_name(each.system) for each in histories])
        self.system.setSizeAdjustPolicy(self.system.SizeAdjustPolicy.AdjustToContents)
        self.system.currentIndexChanged.connect(self._show)
        self.body.insertWidget(1, self.system)
        self.resize(1260, 820)
        self._show()

    def _show(self) -> None:
        from lispac.report.control_charts import control_chart_figure

        history = self._histories[self.system.currentIndex()]
        self.show_rows([_row(each) for each in history.entries])
        messages = map(message_text, (*history.messages, *self._notes))
        self.message_label.setText("\n".join(messages))
        self.message_label.setVisible(bool(self.message_label.text()))
        control_chart_figure(
            [each.day for each in history.entries],
            [each.charted for each in history.entries],
            self.figure(),
        )
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(
            gettext("Control chart of {system}", system=_system_name(history.system))
        )


def _system_name(system: CalibratedSystem) -> str:
    """Names of vessel, scanner and INS/GNSS."""
    return gettext("unnamed system") if system == CalibratedSystem() else system.full_name


def _columns() -> list[Column]:
    return [
        Column(gettext("Date"), gettext("First day of the survey"), is_text=True),
        Column(gettext("Calibration"), gettext("Name of the calibration project"), is_text=True),
        *angle_columns(),
        *(Column(gettext(title), gettext(tip)) for title, tip in DIFFERENCE_COLUMNS),
        Column(
            gettext("Displacement at {distance:m.0} m (cm)", distance=EFFECT_DISTANCE_M),
            gettext(
                "Largest displacement of a point at this distance from the scanner, caused by "
                "the change of the boresight since the earlier calibrations"
            ),
        ),
        Column(
            gettext("Result"),
            gettext(
                "The mounting is reported as moved if the change of one angle, or of the three "
                "angles together, exceeds 3 σ"
            ),
            is_text=True,
        ),
    ]


def _row(entry: HistoryEntry) -> Row:
    charted = entry.charted
    found, change = charted.calibration, charted.change
    angles, sigmas = np.degrees(found.boresight), np.degrees(found.sigma)
    cells = [
        Cell(entry.day.isoformat(), shown=short_date(entry.day)),
        Cell(found.name),
    ]
    for angle, sigma in zip(angles, sigmas, strict=True):
        cells += [number_cell(angle, "+.4f"), number_cell(sigma, ".4f")]
    if change is None:
        cells += [number_cell(None, "")] * 4
    else:
        cells += [number_cell(value, "+.1f") for value in change.significance]
        cells.append(number_cell(change.largest_displacement(EFFECT_DISTANCE_M), ".1f", 100.0))
    if change is None:
        result = gettext("first calibration")
    else:
        result = (
            gettext("mounting has moved") if charted.has_moved else gettext("no significant change")
        )
    return Row(
        (*cells, Cell(result)), marked=charted.has_moved, tip=message_text(change_message(entry))
    )
