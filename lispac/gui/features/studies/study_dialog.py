"""Dialogues with the result of a study: text, table and plot to copy."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPoint, QSize, Signal
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QDialog, QHBoxLayout, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance import units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable, Row
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.present.calibration.calibrations import HISTORY_TABLE
from lispac.present.calibration.error_budget import ErrorBudgetValues, budget_table
from lispac.present.calibration.subsampling import SUBSAMPLING_TABLE, SubsamplingValues
from lispac.present.checking.line_differences import (
    ALL_PAIRS_TITLE,
    FACING_TEXTS,
    LINE_DIFFERENCES_TABLE,
    difference_title,
)
from lispac.project import BoresightChoice
from lispac.validation.line_differences import LineDifference
from lispac.workflow.checking.calibration_history import CalibrationHistory
from lispac.workflow.checking.line_quality import LineQuality

HEADER_HEIGHT_PX, ROW_HEIGHT_PX, MAX_ROWS = 64, 24, 10
"""Height of the table header and of a row, pixels, and limit of rows for the table height."""
SCREEN_MARGIN_PX = 40
"""Part of the width and of the height of the screen that a dialogue does not use, pixels."""
MIN_TABLE_HEIGHT_PX, MIN_PLOT_HEIGHT_PX = HEADER_HEIGHT_PX + 3 * ROW_HEIGHT_PX, 180
"""Smallest heights of table and plot on a small screen, pixels."""
LINE_QUALITY_INTRODUCTIONS: dict[BoresightChoice, str] = {
    "prior": N_(
        "The table shows the differences between each pair of lines on flat surfaces, along the "
        "surface normal and with the prior boresight. Select a row to show it in the map and in "
        "the 3D view. The project is not changed."
    ),
    "estimated": N_(
        "The table shows the differences between each pair of lines on flat surfaces, along the "
        "surface normal and with the estimated boresight. Select a row to show it in the map and "
        "in the 3D view. The project is not changed."
    ),
}


class StudyDialog(QDialog):
    """Dialogue with a table and optional text and plot; it does not change the project.

    Parameters
    ----------
    name : name of the dialogue, used in the names of its widgets
    title, introduction : texts in the language of the user
    """

    def __init__(
        self,
        name: str,
        title: str,
        introduction: str,
        table: DiagnosticsTable,
        parent: QWidget | None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName(f"{name}_dialog")
        self.setWindowTitle(title)
        self.table = table
        self.body: QVBoxLayout = widgets.vertical_layout(self, 16)
        self.body.addWidget(widgets.label(introduction, wrap=True))
        self.body.addWidget(table, 1)
        self.message_label = widgets.label("", wrap=True, name=f"{name}_message")
        self.body.addWidget(self.message_label)
        self.canvas: QWidget | None = None
        self.copy_numbers = widgets.button(
            gettext("Copy numbers"),
            f"{name}_numbers",
            tip=gettext("Copy the table to the clipboard for a spreadsheet"),
        )
        self.copy_numbers.clicked.connect(
            lambda: QGuiApplication.clipboard().setText(self.numbers())
        )
        self.copy_picture = widgets.button(
            gettext("Copy picture"),
            f"{name}_picture",
            tip=gettext("Copy the plot to the clipboard as displayed"),
        )
        self.copy_picture.clicked.connect(self._copy_picture)
        self.copy_picture.hide()
        close = widgets.button(gettext("Close"), f"{name}_close", primary=True)
        close.setDefault(True)
        close.clicked.connect(self.accept)
        row = QHBoxLayout()
        row.addWidget(self.copy_numbers)
        row.addWidget(self.copy_picture)
        row.addStretch(1)
        row.addWidget(close)
        self._buttons = row
        self.body.addLayout(row)

    @property
    def available_size(self) -> QSize:
        """Size of the screen without its margin, pixels."""
        return self.screen().availableGeometry().size() - QSize(SCREEN_MARGIN_PX, SCREEN_MARGIN_PX)

    def show_rows(self, rows: Sequence[Row]) -> None:
        """Show rows in the table, whose height grows with their number up to a limit."""
        self.table.show_rows(rows)
        self.table.setMinimumHeight(HEADER_HEIGHT_PX + ROW_HEIGHT_PX * min(len(rows), MAX_ROWS))
        if self.isVisible():
            self._fit_width()
            self._keep_on_screen()

    def showEvent(self, event: QShowEvent) -> None:
        """Fit the dialogue to the table and to the screen."""
        super().showEvent(event)
        self._fit_width()
        self._fit_height()
        self._keep_on_screen()

    def _fit_width(self) -> None:
        """Widen the dialogue to the table, but not beyond the screen."""
        around, header = self.body.contentsMargins(), self.table.horizontalHeader()
        frame = 2 * self.table.frameWidth() + self.table.verticalScrollBar().sizeHint().width()
        # The sections do not have their final widths yet; the last one is stretched and not
        # narrower than the default.
        widths = [
            max(header.sectionSizeHint(column), self.table.sizeHintForColumn(column)) + 1
            for column in range(header.count())
        ]
        width = sum(widths[:-1]) + max(widths[-1], header.defaultSectionSize())
        width += frame + around.left() + around.right()
        width = min(width, self.available_size.width())
        if width > self.width():
            self.resize(width, self.height())

    def _fit_height(self) -> None:
        """Lower the dialogue to the height of the screen, so that its buttons are visible."""
        available = self.available_size.height()
        parts = [(self.table, MIN_TABLE_HEIGHT_PX)]
        if self.canvas is not None:
            parts.insert(0, (self.canvas, MIN_PLOT_HEIGHT_PX))
        for part, min_height in parts:
            excess = self.body.minimumHeightForWidth(self.width()) - available
            if excess > 0:
                part.setMinimumHeight(max(min_height, part.minimumHeight() - excess))
                self.body.invalidate()
        # The minimum of Qt assumes that texts are wrapped at the smallest width
        self.setMinimumHeight(min(self.body.minimumHeightForWidth(self.width()), available))
        if self.height() > available:
            self.resize(self.width(), available)

    def _keep_on_screen(self) -> None:
        """Move the dialogue so that all of it is on the screen, after it became larger."""
        screen, place = self.screen().availableGeometry(), self.geometry()
        place.moveRight(min(place.right(), screen.right() - SCREEN_MARGIN_PX // 2))
        place.moveBottom(min(place.bottom(), screen.bottom() - SCREEN_MARGIN_PX // 2))
        place.moveTopLeft(QPoint(max(place.left(), screen.left()), max(place.top(), screen.top())))
        self.move(place.topLeft() - (self.geometry().topLeft() - self.pos()))

    def numbers(self) -> str:
        """Table as text for a spreadsheet."""
        return self.table.as_text()

    def figure(self):
        """The figure of the plot below the table."""
        if self.canvas is None:
            from lispac.gui.widgets.chart import Chart

            self.canvas = Chart(560, 340)
            self.body.insertWidget(self.body.indexOf(self._buttons), self.canvas, 2)
            self.copy_picture.show()
        return self.canvas.figure

    def _copy_picture(self) -> None:
        if self.canvas is not None:
            QGuiApplication.clipboard().setPixmap(self.canvas.picture())


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
                current=lambda row: row in (beam.before, beam.after),
                tip=lambda row: missing if row.at_distance is None else "",
            )
        )


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


class LineQualityDialog(StudyDialog):
    """Dialogue with a row for each pair of lines and surface orientation, and a map of one row.

    It leaves the 3D view usable, in which the places of the selected row are marked.
    """

    row_selected = Signal(str, object)
    """Title of the selected row, and its places, ndarray of shape (n, 3), metres."""

    def __init__(self, quality: LineQuality, parent: QWidget | None = None) -> None:
        title = dialog_title(ACTIONS["line_quality"])
        table = DiagnosticsTable(
            "line_quality_table", title, window_columns(LINE_DIFFERENCES_TABLE)
        )
        super().__init__(
            "line_quality", title, gettext(LINE_QUALITY_INTRODUCTIONS[quality.which]), table, parent
        )
        self.quality, self._values = quality, quality.rows()
        self.show_rows(window_rows(LINE_DIFFERENCES_TABLE, self._values))
        self.message_label.setText("\n".join(map(message_text, quality.not_compared)))
        self.message_label.setVisible(bool(quality.not_compared))
        self.table.itemSelectionChanged.connect(self._show_selected)
        facing = FACING_TEXTS["all"]
        self._draw(quality.pairs, gettext(ALL_PAIRS_TITLE, facing=gettext(facing)))
        self.resize(900, 760)

    def copy_state_from(self, former: "LineQualityDialog") -> None:
        """Take over the geometry, the order and the selected row of a former dialogue."""
        self.restoreGeometry(former.saveGeometry())
        order = former.table.horizontalHeader()
        self.table.sortItems(order.sortIndicatorSection(), order.sortIndicatorOrder())
        if former.table.selected_row is not None:
            self.table.selectRow(former.table.currentRow())

    def _show_selected(self) -> None:
        """Show the places of the selected row in the map, and announce them."""
        number = self.table.selected_row
        if number is None:
            return
        row = self._values[number]
        pairs, title = self.quality.places(row), difference_title(row)
        self._draw(pairs, title)
        self.row_selected.emit(title, np.concatenate([pair.place for pair in pairs]))

    def _draw(self, pairs: Sequence[LineDifference], title: str) -> None:
        # Matplotlib is imported late, so that the window starts without it.
        from lispac.report.line_map import line_difference_map

        line_difference_map(self.quality.pairs, self.figure(), shown=pairs, title=title)
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(
            gettext("Map of the differences between lines: {title}", title=title)
        )


class SubsamplingDialog(StudyDialog):
    """Dialogue with a row for each point spacing."""

    def __init__(
        self, results: Sequence[SubsamplingValues], used: float, parent: QWidget | None = None
    ) -> None:
        title = dialog_title(ACTIONS["subsampling"])
        table = DiagnosticsTable("subsampling_table", title, window_columns(SUBSAMPLING_TABLE))
        super().__init__(
            "subsampling", title,
            gettext(
                "Each row is an adjustment of the same sightings with another point spacing, with "
                "the correlation times and form errors of the result. Points of a sighting share "
                "the POS errors, so below some spacing more points take time but do not reduce the "
                "standard deviations. The project is not changed."
            ),
            table, parent,
        )  # fmt: skip
        self.show_rows(
            window_rows(SUBSAMPLING_TABLE, results, current=lambda row: row.distance_m == used)
        )
        self.message_label.setText(
            gettext(
                "The highlighted row has the point spacing of the project settings, {spacing} "
                "{unit}.",
                spacing=units.localised(units.figure(used, "m", ".2f")),
                unit=units.shown_unit("m").sign,
            )
        )
        self.message_label.setVisible(any(each.distance_m == used for each in results))
        self.resize(860, 330)
