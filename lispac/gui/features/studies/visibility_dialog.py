"""Dialogue with charts of the visibility of systematic errors on a board."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import spreadsheet_text, window_columns, window_rows
from lispac.language import N_, degree_signs, gettext
from lispac.present.tables import title_text
from lispac.present.text_format import sentence_text

if TYPE_CHECKING:
    from lispac.present.planning.visibility import ComparedConfiguration
    from lispac.simulation.visibility_study import VisibilityStudy

READING_HINT = N_("Move the mouse over the chart to read values")
SITE_NAMES = {"terrestrial": N_("Terrestrial site"), "marine": N_("Marine site")}


class VisibilityDialog(StudyDialog):
    """Dialogue that shows one site, one error and one criterion at a time.

    Parameters
    ----------
    studies : results, one for each site
    """

    def __init__(self, studies: "Sequence[VisibilityStudy]", parent: QWidget | None = None) -> None:
        from lispac.present.planning.visibility import CONFIGURATIONS_TABLE as TABLE
        from lispac.present.planning.visibility import CRITERIA, systematic_error_label

        table = DiagnosticsTable("visibility_table", title_text(TABLE.title), window_columns(TABLE))
        super().__init__(
            "visibility", dialog_title(ACTIONS["visibility"]),
            gettext(
                "One board is scanned on six lines with one systematic error at a time and no "
                "noise. The chart shows at which inclinations and on which lines the error is "
                "visible. Shaded: inclinations accepted by the type I criterion; dashed: best "
                "inclination. The results are compared with those of Shahraji's thesis, which "
                "introduced the criteria."
            ),
            table, parent,
        )  # fmt: skip
        self._studies = tuple(studies)
        self._criteria = tuple(CRITERIA)
        self._reasons: list[str] = []
        self._summary = ""
        self.site = widgets.ChoiceBox(
            "visibility_site", [gettext(SITE_NAMES[each.site.name]) for each in studies],
            gettext(
                "Terrestrial site: scanner 2.5 m above a board on the ground. Marine site: vessel "
                "15 m from a quay 5 m high."
            ),
        )  # fmt: skip
        self.error = widgets.ChoiceBox(
            "visibility_error", [systematic_error_label(each) for each in studies[0].site.errors],
            gettext("Systematic error to show"),
        )  # fmt: skip
        self.criterion = widgets.ChoiceBox(
            "visibility_criterion", [gettext(each.title) for each in CRITERIA.values()],
            gettext("Criterion shown in the chart"),
        )  # fmt: skip
        choices = QHBoxLayout()
        for choice in (self.site, self.error, self.criterion):
            choice.setSizeAdjustPolicy(choice.SizeAdjustPolicy.AdjustToContents)
            choices.addWidget(choice)
        choices.addStretch(1)
        self.body.insertLayout(1, choices)
        self.reading = widgets.label(gettext(READING_HINT), "muted", name="visibility_reading")
        self.reading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.body.insertWidget(self.body.indexOf(self._buttons), self.reading)
        self.copy_numbers.setToolTip(
            gettext("Copy the values of the chart as a table for a spreadsheet")
        )
        self.site.currentIndexChanged.connect(self._on_site_changed)
        self.error.currentIndexChanged.connect(lambda _index: self._draw())
        table.itemSelectionChanged.connect(self._on_row_selected)
        self.criterion.currentIndexChanged.connect(lambda _index: self._draw())
        canvas = self.figure().canvas
        connections = (
            canvas.mpl_connect("motion_notify_event", self._show_values_at),
            canvas.mpl_connect("axes_leave_event", lambda _event: self._clear_reading()),
        )
        # The mouse may leave the canvas after the label was deleted
        self.reading.destroyed.connect(
            lambda: [canvas.mpl_disconnect(each) for each in connections]
        )
        self.resize(1180, 860)
        self._on_site_changed()

    @property
    def _study(self) -> "VisibilityStudy":
        return self._studies[self.site.currentIndex()]

    @property
    def _chart_selection(self) -> "tuple[VisibilityStudy, str, str]":
        """Study, error and criterion that the chart shows."""
        study = self._study
        return (
            study,
            study.site.errors[self.error.currentIndex()],
            self._criteria[self.criterion.currentIndex()],
        )

    def _on_site_changed(self) -> None:
        from lispac.present.planning.visibility import (
            CONFIGURATIONS_TABLE,
            compared_configurations,
            fewest_lines_text,
            systematic_error_label,
        )

        found = self._study
        self.error.blockSignals(True)
        chosen = self.error.currentIndex()
        self.error.clear()
        self.error.addItems([systematic_error_label(each) for each in found.site.errors])
        self.error.setCurrentIndex(min(chosen, self.error.count() - 1))
        self.error.blockSignals(False)
        rows = compared_configurations(found, found.site.errors)
        self._reasons = [_reason_text(row) for row in rows]
        with degree_signs():
            self._summary = fewest_lines_text(found)
        self.show_rows(
            window_rows(
                CONFIGURATIONS_TABLE, rows, key=lambda row: (row.best.error, ""),
                marked=lambda row: row.thesis.reason is not None, tip=_reason_text,
            )
        )  # fmt: skip
        self._draw()

    def _on_row_selected(self) -> None:
        key = self.table.key(self.table.currentRow())
        if key is not None:
            self.error.setCurrentIndex(self._study.site.errors.index(key[0]))

    def _draw(self) -> None:
        from lispac.present.planning.visibility import systematic_error_label
        from lispac.report.visibility_figures import visibility_figure

        found, error, criterion = self._chart_selection
        with degree_signs():
            visibility_figure(found, error, criterion, self.figure())
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(f"{self.criterion.currentText()}, {self.error.currentText()}")
        self._clear_reading()
        texts = [self._summary]
        if reason := self._reasons[self.error.currentIndex()]:
            name = systematic_error_label(error)
            texts.insert(
                0,
                gettext(
                    "{error}, difference from Shahraji's thesis: {reason}",
                    error=name,
                    reason=reason,
                ),
            )
        self.message_label.setText("\n".join(texts))

    def _clear_reading(self) -> None:
        self.reading.setText(gettext(READING_HINT))

    def _show_values_at(self, event) -> None:
        """Show the values of the lines under the mouse."""
        from lispac.present.planning.visibility import values_at_inclination

        if event.inaxes is not None:
            with degree_signs():
                self.reading.setText(values_at_inclination(*self._chart_selection, event.xdata))

    def numbers(self) -> str:
        """Values of the chart as text, tabs between the columns."""
        from lispac.present.planning.visibility import criterion_table

        return spreadsheet_text(*criterion_table(*self._chart_selection))


def _reason_text(row: "ComparedConfiguration") -> str:
    return "" if row.thesis.reason is None else sentence_text(row.thesis.reason)
