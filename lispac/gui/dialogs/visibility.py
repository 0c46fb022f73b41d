"""Which board and which lines show which systematic error: charts to choose from and read off."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QWidget

from lispac.gui.dialogs.study import StudyDialog
from lispac.gui.language import say, say_all
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row

if TYPE_CHECKING:
    from lispac.simulation.visibility_study import Visibility

COLUMNS = (
    Column("Error", "With its size", words=True),
    Column("Kept (deg)", "Inclinations that Type I keeps", words=True),
    Column("Thesis keeps", "By its appendix C and section 3.9", words=True),
    Column("Best (deg)", "Inclination at which the lines differ most", words=True),
    Column("Thesis's best", "By its table 3.2 and section 3.9", words=True),
    Column("Lines that differ", "Headings; lines joined by / show the same, one of them is enough",
           words=True),
    Column("Thesis's lines", "By its table 3.2 and section 4.4.1.1", words=True),
    Column("Inclination is", "Beside the thesis; the row's tip says why it differs", words=True),
    Column("Lines are", "Beside the thesis", words=True),
)  # fmt: skip
READ = "Move the mouse over the chart to read values off"


class VisibilityDialog(StudyDialog):
    """One site, one error and one criterion at a time.

    Parameters
    ----------
    found : of each site
    """

    def __init__(self, found: "Sequence[Visibility]", parent: QWidget | None = None) -> None:
        from lispac.report.visibility_figures import CRITERIA, error_in_words

        table = DiagnosticsTable("visibility_table", "Best configurations", COLUMNS)
        super().__init__(
            "visibility", "Visibility of errors",
            "One board on six lines, with one systematic error at a time and no noise: at which "
            "inclination and on which lines is the error seen? Shaded is what Type I keeps, dashed "
            "the best.",
            table, parent,
        )  # fmt: skip
        self._found = tuple(found)
        self._criteria = tuple(CRITERIA)
        self._why: list[str] = []
        self._for_all = ""
        self.site = widgets.Choice(
            "visibility_site", [each.site.name.capitalize() for each in found],
            "A vehicle 2.5 m above a board on the ground, or a vessel 15 m from a quay 5 m high",
        )  # fmt: skip
        self.error = widgets.Choice(
            "visibility_error", [error_in_words(each) for each in found[0].site.errors],
            "Which systematic error is there",
        )  # fmt: skip
        self.criterion = widgets.Choice(
            "visibility_criterion", [each.title for each in CRITERIA.values()], "What is drawn"
        )
        choices = QHBoxLayout()
        for choice in (self.site, self.error, self.criterion):
            choice.setSizeAdjustPolicy(choice.SizeAdjustPolicy.AdjustToContents)
            choices.addWidget(choice)
        choices.addStretch(1)
        self.body.insertLayout(1, choices)
        self.reading = widgets.label(READ, "muted", name="visibility_reading")
        self.reading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.body.insertWidget(self.body.indexOf(self._buttons), self.reading)
        self.copy_numbers.setToolTip(
            say("Copy what the chart is drawn from as a table for a spreadsheet")
        )
        self.site.currentIndexChanged.connect(self._another_site)
        self.error.currentIndexChanged.connect(lambda _index: self._draw())
        table.itemSelectionChanged.connect(self._row_selected)
        self.criterion.currentIndexChanged.connect(lambda _index: self._draw())
        canvas = self.figure().canvas
        heard = (
            canvas.mpl_connect("motion_notify_event", self._read),
            canvas.mpl_connect("axes_leave_event", lambda _event: self.reading.setText(say(READ))),
        )
        # Where the words go first, the mouse may still leave the canvas
        self.reading.destroyed.connect(lambda: [canvas.mpl_disconnect(each) for each in heard])
        self.resize(1180, 860)
        self._another_site()

    @property
    def _shown(self) -> "Visibility":
        return self._found[self.site.currentIndex()]

    @property
    def _drawn(self) -> "tuple[Visibility, str, str]":
        found = self._shown
        return (
            found,
            found.site.errors[self.error.currentIndex()],
            self._criteria[self.criterion.currentIndex()],
        )

    def _another_site(self) -> None:
        from lispac.report.visibility_figures import error_in_words
        from lispac.report.visibility_tables import all_errors_in_words, comparison_table

        found = self._shown
        self.error.blockSignals(True)
        chosen = self.error.currentIndex()
        self.error.clear()
        self.error.addItems(say_all(error_in_words(each) for each in found.site.errors))
        self.error.setCurrentIndex(min(chosen, self.error.count() - 1))
        self.error.blockSignals(False)
        rows = comparison_table(found, found.site.errors).rows
        self._why = [why for *_, why in rows]
        self._for_all = all_errors_in_words(found)
        self.show_rows(
            [
                Row([Cell(cell) for cell in cells], key=(error, ""), marked=bool(why), tip=why)
                for error, (*cells, why) in zip(found.site.errors, rows, strict=True)
            ]
        )
        self._draw()

    def _row_selected(self) -> None:
        key = self.table.key(self.table.currentRow())
        if key is not None:
            self.error.setCurrentIndex(self._shown.site.errors.index(key[0]))

    def _draw(self) -> None:
        from lispac.report.visibility_figures import error_in_words, visibility_figure

        found, error, criterion = self._drawn
        visibility_figure(found, error, criterion, self.figure(), say)
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(f"{self.criterion.currentText()}, {self.error.currentText()}")
        self.reading.setText(say(READ))
        why = self._why[self.error.currentIndex()]
        about = f"{error_in_words(error)} beside the thesis: {why}\n" if why else ""
        self.said.setText(say(f"{about}{self._for_all}"))

    def _read(self, event) -> None:
        """Say what the lines show under the mouse."""
        from lispac.report.visibility_tables import reading

        if event.inaxes is not None:
            self.reading.setText(say(reading(*self._drawn, event.xdata)))

    def numbers(self) -> str:
        """What the chart is drawn from."""
        from lispac.report.visibility_tables import plot_table

        table = plot_table(*self._drawn)
        lines = [[column.title for column in table.columns], *table.rows]
        return "\n".join("\t".join(map(say, line)) for line in lines) + "\n"
