"""Each validation plane: distances between the lines before and after."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QSizePolicy,
    QSplitter,
    QStackedLayout,
    QTableWidget,
    QTableWidgetItem,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import theme, units
from lispac.gui.language import say, say_all
from lispac.gui.panels import distances, pairs_table, widgets
from lispac.gui.turns import Turn
from lispac.project import Project
from lispac.validation.results import DistanceStatistics, PlaneComparison

_HEADS = ("Plane", "n", "Median (mm)", "RMS (mm)", "95 % (mm)")
_TIPS = (
    "Validation plane",
    "Distances between points of one line and the surface of another",
    "Median distance, millimetres, before → after",
    "Root mean square distance, millimetres, before → after",
    "95 % of the distances are smaller, millimetres, before → after",
)
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_SHARES = (3, 4)
"""Of the width, for the tables and for the plot, until the user moves the handle between them."""
PLOTS = ("Histogram", "Histogram, shares", "Against height and range")
AGAINST = PLOTS.index("Against height and range")
ZOOM = "Wheel: closer or farther; drag: move; double click: all of it"
AGAINST_WORDS = {"Height (m)": "height", "Range (m)": "range"}


def preload() -> None:
    """Import Matplotlib, which takes half a second: to be called in the worker."""
    import lispac.report.histograms  # noqa: F401
    import lispac.report.profiles  # noqa: F401


class HistogramsPanel(QWidget):
    """A row of figures for each plane and for each pair of lines, and the plots of one plane."""

    plane_selected = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._comparisons: tuple[PlaneComparison, ...] = ()
        self._drawing = Turn(self._selected_again, self)
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
        filled = QSplitter(Qt.Orientation.Horizontal)
        filled.setObjectName("comparison_splitter")
        filled.setContentsMargins(6, 6, 6, 6)
        filled.setChildrenCollapsible(False)
        self.table = _table()
        self.table.itemSelectionChanged.connect(self._selected)
        self.pairs = pairs_table.pairs_table()
        self.tabs = QTabWidget()
        self.tabs.setObjectName("comparison_tabs")
        self.tabs.addTab(self.table, say("Planes"))
        self.tabs.addTab(self.pairs, say("Pairs of lines"))
        filled.addWidget(self.tabs)
        plots = QWidget()
        self._plots = QVBoxLayout(plots)
        self._plots.setContentsMargins(0, 0, 0, 0)
        self._plots.setSpacing(2)
        self._plots.addLayout(self._tools())
        self._plots.addWidget(self.reading)
        filled.addWidget(plots)
        for part, share in enumerate(_SHARES):
            filled.setStretchFactor(part, share)
        self._parts = filled
        self._stack.addWidget(filled)
        self.canvas: QWidget | None = None

    def _tools(self) -> QHBoxLayout:
        self.plot = widgets.Choice(
            "comparison_plot", PLOTS,
            "What is drawn of the plane: how often each distance occurs, which share of the points "
            "has it, or how the distances grow with height and range (before a calibration they "
            "do, after it they should not)",
        )  # fmt: skip
        self.plot.setMinimumContentsLength(len(PLOTS[AGAINST]))
        self.plot.currentIndexChanged.connect(self._selected_again)
        self.reading = widgets.label(ZOOM, "muted", name="comparison_reading")
        # What it says is to be cut off rather than to widen the plot.
        self.reading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.copy_picture = widgets.button(
            "Copy picture", "copy_plot", tip="Copy the plot as it is shown to the clipboard"
        )
        self.copy_picture.clicked.connect(self._copy_picture)
        self.copy_numbers = widgets.button(
            "Copy numbers", "copy_numbers",
            tip="Copy what the plot is drawn from to the clipboard, as a table for a spreadsheet",
        )  # fmt: skip
        self.copy_numbers.clicked.connect(self._copy_numbers)
        row = QHBoxLayout()
        row.addWidget(self.plot)
        row.addStretch(1)
        row.addWidget(self.copy_picture)
        row.addWidget(self.copy_numbers)
        return row

    @property
    def current(self) -> str | None:
        """Name of the plane whose histograms are drawn."""
        each = self._current
        return None if each is None else each.name

    @property
    def _current(self) -> PlaneComparison | None:
        rows = self.table.selectionModel().selectedRows()
        return self._comparisons[rows[0].row()] if rows else None

    def show_project(self, project: Project | None) -> None:
        """Show the comparisons, where there are some."""
        comparisons = () if project is None else project.validation
        self._stack.setCurrentIndex(1 if comparisons else 0)
        if comparisons is self._comparisons:
            return
        if self.canvas is None:
            self._parts.setSizes([share * self.width() for share in _SHARES])
        self._comparisons = comparisons
        self.table.blockSignals(True)
        self.table.setRowCount(len(comparisons))
        font = theme.tabular(self.table.font())
        for row, each in enumerate(comparisons):
            tip = say(f"{each.name}: {each.pooled_from} of lines, {each.model.in_words}")
            for column, text in enumerate(_texts(each)):
                item = QTableWidgetItem(say(text) if column else text)
                item.setFont(font)
                if column:
                    item.setTextAlignment(_RIGHT)
                item.setToolTip(widgets.plain_tip(tip))
                self.table.setItem(row, column, item)
        self.table.clearSelection()
        self.table.blockSignals(False)
        if comparisons:
            self.table.blockSignals(True)
            self.table.selectRow(0)
            self.table.blockSignals(False)
            self._drawing.start()

    def select(self, name: str) -> None:
        """Draw one plane's histograms, without telling anyone."""
        names = [each.name for each in self._comparisons]
        if name in names and self.current != name:
            self.table.blockSignals(True)
            self.table.selectRow(names.index(name))
            self.table.blockSignals(False)
            self._draw(self._comparisons[names.index(name)])

    def _selected(self) -> None:
        if self._current is not None:
            self._draw(self._current)
            self.plane_selected.emit(self._current.name)

    def _selected_again(self) -> None:
        if self._current is not None:
            self._draw(self._current)

    def _draw(self, comparison: PlaneComparison) -> None:
        # Imported here, so that the start of the window does not wait for it.
        from lispac.report.histograms import histogram_figure
        from lispac.report.profiles import profile_figure

        self.pairs.show_rows(pairs_table.pair_rows(comparison))
        self.tabs.setTabText(1, say(f"Pairs of lines on {comparison.name}"))
        canvas = self._canvas()
        if self.plot.currentIndex() == AGAINST:
            profile_figure(comparison, canvas.figure, say)
        else:
            histogram_figure(
                comparison, canvas.figure, share=self.plot.currentIndex() == 1, say=say
            )
        self._show_units(canvas.figure)
        self._zooming.keep(upright=self.plot.currentIndex() == AGAINST)
        self.reading.setText(say(ZOOM))
        canvas.draw_idle()
        canvas.setAccessibleName(
            say(
                f"Distances on {comparison.name}, {PLOTS[self.plot.currentIndex()].lower()}, "
                "before in blue "
                "and after in brown"
            )
        )

    def _show_units(self, figure) -> None:
        from lispac.gui.panels.ticks import in_units

        against = self.plot.currentIndex() == AGAINST
        legend = None if against or not units.differs("mm") else figure.axes[0].get_legend()
        if legend is not None and self._current is not None:
            each = self._current
            for text, words in zip(
                legend.get_texts(), (_words("before", each.before), _words("after", each.after)),
                strict=True,
            ):  # fmt: skip
                text.set_text(units.signs(say(words), "mm"))
        for axes in figure.axes:
            in_units(axes.xaxis, "m" if against else "mm")
            if against:
                in_units(axes.yaxis, "mm")

    def _canvas(self):
        if self.canvas is None:
            from lispac.gui.panels.chart import Chart
            from lispac.gui.panels.zooming import Zooming

            self.canvas = Chart(260, 120)
            self.canvas.setObjectName("histogram_canvas")
            self._zooming = Zooming(self.canvas)
            canvas, leave = self.canvas, lambda _event: self.reading.setText(say(ZOOM))
            heard = (
                canvas.mpl_connect("motion_notify_event", self._read),
                canvas.mpl_connect("axes_leave_event", leave),
            )
            # Where the words go first, the mouse may still leave the canvas
            self.reading.destroyed.connect(lambda: [canvas.mpl_disconnect(each) for each in heard])
            self._plots.insertWidget(1, self.canvas, 1)
        return self.canvas

    def _read(self, event) -> None:
        """Say what is under the mouse."""
        comparison, axes = self._current, event.inaxes
        if comparison is None or axes is None:
            return
        if self.plot.currentIndex() == AGAINST:
            what = {say(label): word for label, word in AGAINST_WORDS.items()}.get(
                axes.get_xlabel(), ""
            )
            profile = comparison.by_height if what == "height" else comparison.by_range
            if profile is not None:
                words = distances.profile_words(profile, what, event.xdata)
                self.reading.setText(units.signs(say(words), "mm", "m"))
            return
        edges = axes.patches[0].get_data().edges
        k = int(edges.searchsorted(event.xdata, side="right")) - 1
        if 0 <= k < len(edges) - 1:
            low, high = edges[k] / 1000.0, edges[k + 1] / 1000.0
            words = distances.histogram_words(comparison, low, high)
            self.reading.setText(units.signs(say(words), "mm"))

    def _copy_picture(self) -> None:
        if self.canvas is not None:
            QGuiApplication.clipboard().setPixmap(self.canvas.picture())
            self.reading.setText(say("The picture is in the clipboard"))

    def _copy_numbers(self) -> None:
        comparison = self._current
        if comparison is None or self.canvas is None:
            return
        if self.plot.currentIndex() == AGAINST:
            text = distances.profiles_text(comparison)
        else:
            from lispac.report.histograms import BARS

            low, high = self.canvas.figure.axes[0].get_xlim()
            text = distances.histogram_text(comparison, (high - low) / 1000.0, BARS)
        QGuiApplication.clipboard().setText(text)
        self.reading.setText(say("The numbers are in the clipboard, ready for a spreadsheet"))


def _words(state: str, each: DistanceStatistics) -> str:
    """Of the legend, as the report says them."""
    a, b, c = (units.figure(1000 * v, "mm", ".1f") for v in (each.median, each.rms, each.p95))
    return f"{state}: n {each.n:,}\nmedian {a}, RMS {b}, 95 % {c} mm"


def _texts(each: PlaneComparison) -> list[str]:
    def change(*states: float) -> str:
        before, after = (units.figure(1000 * each, "mm", ".1f") for each in states)
        return f"{before} → {after}"

    return [
        each.name,
        f"{each.before.n:,}",
        change(each.before.median, each.after.median),
        change(each.before.rms, each.after.rms),
        change(each.before.p95, each.after.p95),
    ]


def _table() -> QTableWidget:
    table = QTableWidget(0, len(_HEADS))
    table.setTabKeyNavigation(False)
    table.setObjectName("comparison_table")
    table.setAccessibleName(say("Validation planes before and after"))
    # Units in a second line: all columns are seen on a small screen
    heads = [units.signs(each, "mm", figures=False) for each in say_all(list(_HEADS))]
    table.setHorizontalHeaderLabels([head.replace(" (", "\n(") for head in heads])
    for column, tip in enumerate(_TIPS):
        head = table.horizontalHeaderItem(column)
        head.setToolTip(units.signs(say(tip), "mm", figures=False))
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
