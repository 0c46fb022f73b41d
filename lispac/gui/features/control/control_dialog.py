"""Dialogue with the control of a project: use, residuals, estimates with and without it."""

from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QHBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.control.actions import ACTIONS
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import gettext
from lispac.present.calibration.control import (
    CONTROL_COMPARISON_TABLE,
    CONTROL_TABLE,
    ControlPointValues,
    ControlValues,
)
from lispac.present.tables import title_text
from lispac.project import Project

USED_TITLE = "Used"
"""English title of the column that the ticks replace."""
NextStep = Literal["", "import", "remove"]
COMPARISON_HEIGHT_PX = 150
"""Height of the table of estimates, pixels."""


@dataclass(frozen=True)
class ControlChoice:
    """Choice of the user.

    Attributes
    ----------
    used : tuple of str
        Names of the points whose use is ticked.
    next_step : {"", "import", "remove"}
        Import a file, or remove ``file``.
    file : str
        File of the selected point; empty if none is selected.
    """

    used: tuple[str, ...]
    next_step: NextStep = ""
    file: str = ""


class ControlDialog(QDialog):
    """Table of the control with a tick for each point, and the estimates with and without it."""

    def __init__(self, project: Project, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("control_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["control"]))
        self._values = ControlValues.of(project)
        self._next_step: NextStep = ""
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(
            widgets.label(
                gettext(
                    "The ticked points are observations of the adjustment. A residual is positive "
                    "on the side of the vessel. Changes are applied when the dialogue is closed, "
                    "and an existing result is then estimated again."
                ),
                wrap=True,
            )
        )
        table = CONTROL_TABLE.without(USED_TITLE)
        self.table = DiagnosticsTable(
            "control_table", title_text(table.title), window_columns(table)
        )
        self.table.show_rows(
            window_rows(
                table, self._values.points, marked=lambda row: bool(row.contradicts), tip=_tip
            )
        )
        self._add_ticks()
        layout.addWidget(self.table, 1)
        self.comparison = DiagnosticsTable(
            "control_comparison",
            title_text(CONTROL_COMPARISON_TABLE.title),
            window_columns(CONTROL_COMPARISON_TABLE),
        )
        self.comparison.show_rows(window_rows(CONTROL_COMPARISON_TABLE, self._values.comparison))
        self.comparison.setFixedHeight(COMPARISON_HEIGHT_PX)
        self.comparison.setVisible(bool(self._values.comparison))
        layout.addWidget(self.comparison)
        self.import_button = widgets.button(
            gettext("Import…"), "control_add", tip=gettext("Import a list of points or a scan")
        )
        self.remove_button = widgets.button(
            gettext("Remove file"), "control_remove",
            tip=gettext("Remove all points of the file of the selected point"),
        )  # fmt: skip
        close = widgets.button(gettext("Close"), "control_close", primary=True)
        close.setDefault(True)
        self.import_button.clicked.connect(lambda: self._finish("import"))
        self.remove_button.clicked.connect(lambda: self._finish("remove"))
        close.clicked.connect(lambda: self._finish(""))
        row = QHBoxLayout()
        row.addWidget(self.import_button)
        row.addWidget(self.remove_button)
        row.addStretch(1)
        row.addWidget(close)
        layout.addLayout(row)
        self.table.itemSelectionChanged.connect(self._show_selection)
        self._show_selection()
        self.resize(900, 560)

    @property
    def choice(self) -> ControlChoice:
        """The ticked points, and what is to be done next."""
        ticked = tuple(
            self._point(row).name
            for row in range(self.table.rowCount())
            if self.table.item(row, 0).checkState() == Qt.CheckState.Checked
        )
        row = self.table.currentRow()
        return ControlChoice(ticked, self._next_step, "" if row < 0 else self._point(row).source)

    def _add_ticks(self) -> None:
        """Add a tick to the first cell of each point that is assigned to a target."""
        for row in range(self.table.rowCount()):
            item, point = self.table.item(row, 0), self._point(row)
            if point.target is None:
                continue
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Checked if point.used else Qt.CheckState.Unchecked)

    def _point(self, row: int) -> ControlPointValues:
        return self._values.points[self.table.item(row, 0).data(Qt.ItemDataRole.UserRole)]

    def _show_selection(self) -> None:
        self.remove_button.setEnabled(self.table.currentRow() >= 0)

    def _finish(self, next_step: NextStep) -> None:
        self._next_step = next_step
        self.accept()


def _tip(point: ControlPointValues) -> str:
    return message_text(point.reason) if point.reason is not None else point.source
