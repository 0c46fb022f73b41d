"""Each validation plane: distances between the lines before and after."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QStackedLayout,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import theme
from lispac.gui.panels import widgets
from lispac.project import Project
from lispac.validation.results import PlaneComparison

_HEADS = ("Plane", "n", "Median", "RMS", "95th percentile")
_TIPS = (
    "Validation plane",
    "Distances between points of one line and the surface of another",
    "Median distance, millimetres, before → after",
    "Root mean square distance, millimetres, before → after",
    "95 % of the distances are smaller, millimetres, before → after",
)
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


def preload() -> None:
    """Import Matplotlib, which takes half a second: to be called in the worker."""

    import lispac.report.profiles  # noqa: F401


class HistogramsPanel(QWidget):
    """A row of figures for each plane, and the two histograms of the selected one."""

    plane_selected = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._comparisons: tuple[PlaneComparison, ...] = ()
        self._stack = QStackedLayout(self)
        empty = QWidget()
        layout = widgets.column(empty)
        layout.addWidget(
            widgets.label(
                "No comparison yet. Pick validation planes, estimate, then press Validate in "
                "step 4: the distances between the lines before and after appear here.",
                "muted", wrap=True, name="histograms_empty",
            )
        )  # fmt: skip
        layout.addStretch(1)
        self._stack.addWidget(empty)
        filled = QWidget()
        self._row = QHBoxLayout(filled)
        self._row.setContentsMargins(6, 6, 6, 6)
        self.table = _table()
        self.table.itemSelectionChanged.connect(self._selected)
        left = QVBoxLayout()
        self.plot = widgets.Choice(
            "comparison_plot", ("Histogram", "Against height and range"),
            "What is drawn of the plane: how often each distance occurs, or how the distances grow "
            "with height and range (before a calibration they do, after it they should not)",
        )  # fmt: skip
        self.plot.currentIndexChanged.connect(self._selected_again)
        left.addWidget(self.plot)
        left.addWidget(self.table)
        self._row.addLayout(left)
        self._stack.addWidget(filled)
        self.canvas: QWidget | None = None

    @property
    def current(self) -> str | None:
        """Name of the plane whose histograms are drawn."""
        rows = self.table.selectionModel().selectedRows()
        return self._comparisons[rows[0].row()].name if rows else None

    def show_project(self, project: Project | None) -> None:
        """Show the comparisons, where there are some."""
        comparisons = () if project is None else project.validation
        self._stack.setCurrentIndex(1 if comparisons else 0)
        if comparisons is self._comparisons:
            return
        self._comparisons = comparisons
        self.table.blockSignals(True)
        self.table.setRowCount(len(comparisons))
        for row, each in enumerate(comparisons):
            for column, text in enumerate(_texts(each)):
                item = QTableWidgetItem(text)
                item.setFont(theme.tabular(self.table.font()))
                if column:
                    item.setTextAlignment(_RIGHT)
                item.setToolTip(f"{each.name}: {each.pooled_from} of lines, {each.model.in_words}")
                self.table.setItem(row, column, item)
        self.table.clearSelection()
        self.table.blockSignals(False)
        if comparisons:
            self.select(comparisons[0].name)

    def select(self, name: str) -> None:
        """Draw one plane's histograms, without telling anyone."""
        names = [each.name for each in self._comparisons]
        if name in names and self.current != name:
            self.table.blockSignals(True)
            self.table.selectRow(names.index(name))
            self.table.blockSignals(False)
            self._draw(self._comparisons[names.index(name)])

    def _selected(self) -> None:
        name = self.current
        if name is not None:
            self._draw(next(each for each in self._comparisons if each.name == name))
            self.plane_selected.emit(name)

    def _selected_again(self) -> None:
        name = self.current
        if name is not None:
            self._draw(next(each for each in self._comparisons if each.name == name))

    def _draw(self, comparison: PlaneComparison) -> None:
        # Imported here, so that the start of the window does not wait for it.
        from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg

        from lispac.report.figures import histogram_figure
        from lispac.report.profiles import profile_figure

        draw = profile_figure if self.plot.currentIndex() else histogram_figure
        if self.canvas is None:
            figure = draw(comparison)
            self.canvas = FigureCanvasQTAgg(figure)
            self.canvas.setObjectName("histogram_canvas")
            self.canvas.setMinimumSize(260, 140)
            self._row.addWidget(self.canvas, 1)
        else:
            draw(comparison, figure=self.canvas.figure)
            self.canvas.draw_idle()
        what = "against height and range" if self.plot.currentIndex() else "as histograms"
        self.canvas.setAccessibleName(
            f"Distances on {comparison.name} {what}, before in blue and after in brown"
        )


def _texts(each: PlaneComparison) -> list[str]:
    def change(before: float, after: float) -> str:
        return f"{before * 1000:.1f} → {after * 1000:.1f} mm"

    return [
        each.name,
        f"{each.before.n:,}",
        change(each.before.median, each.after.median),
        change(each.before.rms, each.after.rms),
        change(each.before.p95, each.after.p95),
    ]


def _table() -> QTableWidget:
    table = QTableWidget(0, len(_HEADS))
    table.setObjectName("comparison_table")
    table.setAccessibleName("Validation planes before and after")
    table.setHorizontalHeaderLabels(list(_HEADS))
    for column, tip in enumerate(_TIPS):
        head = table.horizontalHeaderItem(column)
        head.setToolTip(tip)
        if column:
            head.setTextAlignment(_RIGHT)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(26)
    table.setShowGrid(False)
    table.setAlternatingRowColors(True)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.horizontalHeader().setHighlightSections(False)
    table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    table.setSizeAdjustPolicy(QAbstractItemView.SizeAdjustPolicy.AdjustToContents)
    return table
