"""Distances between the lines on each validation plane, before and after the adjustment."""

from html import escape
from typing import Literal

import numpy as np
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication, QIcon
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

from lispac.acceptance import Verdict, planes_to_show
from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.features.validate import pairs_table
from lispac.gui.project.status import ProjectState
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.gui.widgets.result_tables import spreadsheet_text
from lispac.language import N_, gettext, number
from lispac.message_texts import message_text
from lispac.present.acceptance import AcceptanceValues, failed_texts, verdict_text
from lispac.present.validation import (
    BOTH_PROFILES_TABLE,
    HISTOGRAM_TABLE,
    ValidationPlane,
    distance_steps,
    histogram_bins,
)
from lispac.project import Project
from lispac.validation.comparison_results import DistanceStatistics, PlaneComparison
from lispac.validation.distance_bins import merge_bins
from lispac.validation.distance_profile import DistanceProfile

ProfileAxis = Literal["height", "range"]
"""Horizontal axis of a distance profile."""


def histogram_bar_text(comparison: PlaneComparison, low: float, high: float) -> str:
    """Text on the distances in a bar of the histogram, from ``low`` to ``high`` metres."""
    edges = comparison.bin_edges
    beyond = high >= float(edges[-1]) * (1.0 - 1e-9)
    middles = 0.5 * (edges[:-1] + edges[1:])
    inside, up_to = [], []
    for counts in (comparison.counts_before, comparison.counts_after):
        inside.append(int(counts[(middles > low) & (middles < high)].sum()))
        up_to.append(int(counts[middles < high].sum()) / max(int(counts.sum()), 1))
    if beyond:
        reach = gettext("{start} and beyond", start=units.local_amount(1000 * low, "mm", ".4g"))
    else:
        start = units.local_figure(1000 * low, "mm", ".4g")
        reach = f"{start}–{units.local_amount(1000 * high, 'mm', '.4g')}"
    return gettext(
        "{reach}: {before:n} points before ({up_to_before:percent.1} % cumulative), {after:n} "
        "points after ({up_to_after:percent.1} % cumulative)",
        reach=reach, before=inside[0], up_to_before=up_to[0], after=inside[1],
        up_to_after=up_to[1],
    )  # fmt: skip


def profile_bin_text(profile: DistanceProfile, axis: ProfileAxis, place: float) -> str:
    """Text on the distances at a height or range ``place``, metres."""
    k = int(np.clip(np.searchsorted(profile.edges, place) - 1, 0, len(profile.n) - 1))
    low, high = profile.edges[k : k + 2]
    start, end = units.local_figure(low, "m", ".1f"), units.local_amount(high, "m", ".1f")
    if axis == "height":
        reach = gettext("Height {start}–{end}", start=start, end=end)
    else:
        reach = gettext("Range {start}–{end}", start=start, end=end)
    count = int(profile.n[k])
    if not np.isfinite(profile.median_before[k]):
        return gettext("{reach}: too few distances ({count:n})", reach=reach, count=count)
    return gettext(
        "{reach}: median {median_before} → {median_after}, 95th percentile {p95_before} → "
        "{p95_after}, {count:n} distances",
        reach=reach,
        median_before=_millimetres(profile.median_before[k]),
        median_after=_millimetres_with_unit(profile.median_after[k]),
        p95_before=_millimetres(profile.p95_before[k]),
        p95_after=_millimetres_with_unit(profile.p95_after[k]),
        count=count,
    )


def _millimetres(metres: float) -> str:
    return units.local_figure(1000 * metres, "mm", ".1f")


def _millimetres_with_unit(metres: float) -> str:
    return units.local_amount(1000 * metres, "mm", ".1f")


def histogram_text(comparison: PlaneComparison, shown: float, bars: int) -> str:
    """Histogram as a tab-separated table: edges (mm), number of points before and after.

    Parameters
    ----------
    shown : float, metres
        Width of the visible range, which contains at most ``bars`` bars.
    """
    edges, before = merge_bins(comparison.bin_edges, comparison.counts_before, shown, bars)
    _, after = merge_bins(comparison.bin_edges, comparison.counts_after, shown, bars)
    bins = histogram_bins(edges.tolist(), before.tolist(), after.tolist())
    return spreadsheet_text(HISTOGRAM_TABLE, bins)


def profiles_text(comparison: PlaneComparison) -> str:
    """Distances as a function of height and range, as a tab-separated table."""
    plane = ValidationPlane.of(comparison)
    steps = [
        *distance_steps("height", plane.by_height), *distance_steps("range", plane.by_range)
    ]  # fmt: skip
    return spreadsheet_text(BOTH_PROFILES_TABLE, steps)


_COLUMNS = (
    (N_("Plane"), N_("Validation plane")),
    (
        N_("Pairs"),
        N_(
            "Pairs of lines in n, RMS, 95 % and histogram, of all compared pairs. Only "
            "reciprocal pairs (run in opposite directions, ⇄) are counted, if there are any; the "
            "others are in the table of pairs."
        ),
    ),
    (N_("n"), N_("Number of distances between points of one line and the surface of another")),
    # Units in a second line, so that all columns fit on a small screen
    (N_("RMS\n({unit})"), N_("Root mean square distance, before → after")),
    (N_("95 %\n({unit})"), N_("95 % of the distances are smaller, before → after")),
)
"""Heading and tooltip of each column."""
VERDICT_QUALITIES: dict[Verdict, str] = {"pass": "good", "fail": "poor"}
"""Quality whose icon shows a verdict beside the name of a plane; a plane not judged has none."""
_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
LOW_PLOT_PX = 280
"""Height of the plot below which the histogram has no title and legend, pixels."""
_WIDTH_SHARES = (5, 6)
"""Initial shares of the width for tables and plot."""
PLOT_TITLES = (N_("Histogram"), N_("Histogram, percent"), N_("Distance by height, range"))
PERCENT_PLOT, PROFILE_PLOT = 1, 2
"""Indices of two of the plots in `PLOT_TITLES`."""
ZOOM_HINT = N_("Wheel: zoom. Drag: move. Double-click: show all.")
POOLED_PLANE_TIPS = {
    "reciprocal pairs": N_(
        "{plane}: distances of {pooled:n} of {total:n} pairs of lines, the reciprocal ones (⇄), "
        "{model}"
    ),
    "all pairs": N_("{plane}: distances between all pairs of lines, {model}"),
}
"""Tips of a plane, by the pairs of lines whose distances are pooled."""
LEGEND_TEMPLATES = (
    N_("before: n {count:n}\nmedian {median}, RMS {rms}, 95 % {p95} {unit}"),
    N_("after: n {count:n}\nmedian {median}, RMS {rms}, 95 % {p95} {unit}"),
)
"""Entries of the legend of the histogram before and after, as in the report."""


class HistogramsPanel(QWidget):
    """Validation: tables of planes and pairs of lines, and the histograms of one plane."""

    plane_selected = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._comparisons: tuple[PlaneComparison, ...] = ()
        self._failed: set[str] = set()
        self.canvas: QWidget | None = None
        self._drawing = IdleTask(self._redraw_selected, self)
        self._stack = QStackedLayout(self)
        empty = QWidget()
        layout = widgets.vertical_layout(empty)
        layout.addWidget(
            widgets.label(
                gettext(
                    "No comparison yet. Pick validation planes, estimate the boresight, then press "
                    "Validate in step 4."
                ),
                "muted", wrap=True, name="histograms_empty",
            )
        )  # fmt: skip
        layout.addStretch(1)
        self._stack.addWidget(empty)
        filled = QSplitter(Qt.Orientation.Horizontal)
        filled.setObjectName("comparison_splitter")
        filled.setContentsMargins(4, 2, 4, 2)
        filled.setChildrenCollapsible(False)
        self.table = _create_table()
        self.table.viewport().installEventFilter(self)
        self.table.itemSelectionChanged.connect(self._on_plane_selected)
        self.table.clicked.connect(self._announce_plane)  # a row that was selected already
        self.pairs = pairs_table.create_pairs_table()
        self.tabs = QTabWidget()
        self.tabs.setObjectName("comparison_tabs")
        self.tabs.addTab(self.table, gettext("Planes"))
        self.tabs.addTab(self.pairs, gettext("Pairs of lines"))
        filled.addWidget(self.tabs)
        plots = QWidget()
        beside = QHBoxLayout(plots)
        beside.setContentsMargins(0, 0, 0, 0)
        self._plots = QVBoxLayout()
        self._plots.setSpacing(2)
        tools = self._create_tools()
        beside.addLayout(self._plots, 1)
        beside.addLayout(tools)
        filled.addWidget(plots)
        for part, share in enumerate(_WIDTH_SHARES):
            filled.setStretchFactor(part, share)
        self._parts = filled
        self._stack.addWidget(filled)
        self._plot_form = True, False
        """Whether the plot is too low for a legend, and whether it is wide."""

    def _create_tools(self) -> QVBoxLayout:
        self.plot = widgets.ChoiceBox(
            "comparison_plot", [gettext(plot) for plot in PLOT_TITLES],
            gettext(
                "Number of points by distance, share of the points by distance, or distance "
                "against height and range. After a calibration the distances should not grow with "
                "height or range."
            ),
        )  # fmt: skip
        self.plot.setMinimumContentsLength(len(PLOT_TITLES[PROFILE_PLOT]))
        self.plot.currentIndexChanged.connect(self._redraw_selected)
        self.reading = widgets.label(
            gettext(ZOOM_HINT), "muted", wrap=True, name="comparison_reading"
        )
        # A long text is wrapped, so that it does not narrow the plot.
        self.reading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.copy_picture = widgets.button(
            gettext("Copy picture"), "copy_plot",
            tip=gettext("Copy the plot as shown to the clipboard"),
        )  # fmt: skip
        self.copy_picture.clicked.connect(self._copy_picture)
        self.copy_numbers = widgets.button(
            gettext("Copy numbers"), "copy_numbers",
            tip=gettext("Copy the data of the plot to the clipboard, as a table for a spreadsheet"),
        )  # fmt: skip
        self.copy_numbers.clicked.connect(self._copy_numbers)
        self._colours = widgets.label("", name="comparison_colours", rich=True)
        column = QVBoxLayout()
        column.setSpacing(4)
        column.addWidget(self.plot)
        buttons = QHBoxLayout()
        buttons.addWidget(self.copy_picture)
        buttons.addWidget(self.copy_numbers)
        column.addLayout(buttons)
        column.addWidget(self._colours)
        column.addWidget(self.reading)
        column.addStretch(1)
        return column

    @property
    def current(self) -> str | None:
        """Name of the plane whose histograms are drawn."""
        each = self._current_comparison
        return None if each is None else each.name

    @property
    def _current_comparison(self) -> PlaneComparison | None:
        rows = self.table.selectionModel().selectedRows()
        return self._comparisons[rows[0].row()] if rows else None

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep the selected row visible in a lower table."""
        if watched is self.table.viewport() and event.type() == QEvent.Type.Resize:
            self.table.scrollTo(self.table.currentIndex())
        return super().eventFilter(watched, event)

    def _adapt_to_plot_size(self) -> None:
        """Arrange title and legend for the size of the plot, or name the colours beside it."""
        from lispac.report.figures import is_wide

        is_low = self.canvas.height() < LOW_PLOT_PX
        form = is_low, is_wide(self.canvas.figure)
        if form != self._plot_form:
            self._plot_form = form
            self._colours.setVisible(is_low)
            self._drawing.start()

    def show_state(self, state: ProjectState) -> None:
        """Show the comparisons of the project."""
        comparisons = () if state.project is None else state.project.validation
        self._stack.setCurrentIndex(1 if comparisons else 0)
        if comparisons is self._comparisons:
            failed = self._failed
            self._show_verdicts(state.project)
            if self._failed - failed and self.current not in self._failed:
                self._select_row(self._worst_row())
                self._redraw_selected()
            return
        if self.canvas is None:
            self._parts.setSizes([share * self.width() for share in _WIDTH_SHARES])
        self._comparisons = comparisons
        self.table.blockSignals(True)
        self.table.setRowCount(len(comparisons))
        font = theme.tabular_font(self.table.font())
        for row, each in enumerate(comparisons):
            tip = _plane_tip(each)
            for column, text in enumerate(_comparison_texts(each)):
                item = QTableWidgetItem(text)
                item.setFont(font)
                if column:
                    item.setTextAlignment(_ALIGN_RIGHT)
                item.setToolTip(widgets.plain_tip(tip))
                self.table.setItem(row, column, item)
        self.table.clearSelection()
        self.table.blockSignals(False)
        self._show_verdicts(state.project)
        if comparisons:
            self._select_row(self._worst_row())
            self._drawing.start()

    def _worst_row(self) -> int:
        """Row of the plane with the largest RMS after the calibration, of those that fail if any.

        Raises
        ------
        ValueError
            If there are no planes.
        """
        (worst,) = planes_to_show(
            {each.name: each.after.rms for each in self._comparisons}, self._failed, 1
        )
        return [each.name for each in self._comparisons].index(worst)

    def _select_row(self, row: int) -> None:
        """Select a plane without emitting a signal."""
        self.table.blockSignals(True)
        self.table.selectRow(row)
        self.table.blockSignals(False)
        self.table.scrollTo(self.table.currentIndex())

    def _show_verdicts(self, project: Project | None) -> None:
        """Show whether each plane meets the acceptance criteria."""
        if project is None:
            return
        judgement = project.judgement
        values = AcceptanceValues.of(judgement)
        self._failed = {
            each.name for each in self._comparisons if judgement.verdict_on(each.name) == "fail"
        }
        for row, each in enumerate(self._comparisons):
            item = self.table.item(row, 0)
            verdict = judgement.verdict_on(each.name)
            quality = VERDICT_QUALITIES.get(verdict)
            item.setIcon(QIcon() if quality is None else theme.quality_icon(quality))
            text = gettext("Acceptance: {verdict}", verdict=verdict_text(verdict))
            lines = [_plane_tip(each), text, *failed_texts(values, each.name)]
            item.setToolTip(widgets.plain_tip("\n".join(lines)))
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{each.name}. {text}")

    def select(self, name: str) -> None:
        """Draw the histograms of one plane without emitting a signal."""
        names = [each.name for each in self._comparisons]
        if name in names and self.current != name:
            self._select_row(names.index(name))
            self._draw(self._comparisons[names.index(name)])

    def _on_plane_selected(self) -> None:
        if self._current_comparison is not None:
            self._draw(self._current_comparison)
            self._announce_plane()

    def _announce_plane(self) -> None:
        if self.current is not None:
            self.plane_selected.emit(self.current)

    def _redraw_selected(self) -> None:
        if self._current_comparison is not None:
            self._draw(self._current_comparison)

    def _draw(self, comparison: PlaneComparison) -> None:
        # Imported here, so that the start of the window does not wait for it.
        from lispac.report.distance_profiles import profile_figure
        from lispac.report.histograms import STATE_COLOURS, histogram_figure

        self.pairs.show_rows(pairs_table.pair_rows(comparison))
        self.tabs.setTabText(1, gettext("Pairs of lines on {plane}", plane=comparison.name))
        canvas = self._plot_canvas()
        self._colours.setText(
            "&nbsp; ".join(
                f"<span style='color:{colour}'>■</span> {escape(state)}"
                for colour, state in zip(
                    STATE_COLOURS, (gettext("before"), gettext("after")), strict=True
                )
            )
        )
        if self.plot.currentIndex() == PROFILE_PLOT:
            profile_figure(comparison, canvas.figure)
        else:
            share = self.plot.currentIndex() == PERCENT_PLOT
            histogram_figure(comparison, canvas.figure, share=share, titled=not self._plot_form[0])
        self._show_units(canvas.figure)
        self._zooming.set_home(zooms_vertically=self.plot.currentIndex() == PROFILE_PLOT)
        self.reading.setText(gettext(ZOOM_HINT))
        canvas.draw_idle()
        canvas.setAccessibleName(
            gettext(
                "{plot}: distances on {plane}, before in blue and after in brown",
                plot=gettext(PLOT_TITLES[self.plot.currentIndex()]),
                plane=comparison.name,
            )
        )

    def _show_units(self, figure) -> None:
        from lispac.gui.widgets.ticks import convert_axis_units

        is_profile = self.plot.currentIndex() == PROFILE_PLOT
        legends = () if is_profile or not units.is_converted("mm") else figure.legends
        if legends and self._current_comparison is not None:
            each = self._current_comparison
            for text, template, state in zip(
                legends[0].get_texts(), LEGEND_TEMPLATES, (each.before, each.after), strict=True
            ):
                text.set_text(_statistics_text(template, state))
        for axes in figure.axes:
            convert_axis_units(axes.xaxis, "m" if is_profile else "mm")
            if is_profile:
                convert_axis_units(axes.yaxis, "mm")

    def _plot_canvas(self):
        if self.canvas is None:
            from lispac.gui.widgets.chart import Chart
            from lispac.gui.widgets.plot_zoom import PlotZoom

            self.canvas = Chart(260, 100)
            self.canvas.setObjectName("histogram_canvas")
            self._zooming = PlotZoom(self.canvas)
            canvas, leave = self.canvas, lambda _event: self.reading.setText(gettext(ZOOM_HINT))
            connections = (
                canvas.mpl_connect("motion_notify_event", self._show_values_at),
                canvas.mpl_connect("axes_leave_event", leave),
                canvas.mpl_connect("resize_event", lambda _event: self._adapt_to_plot_size()),
            )
            # The mouse may leave the canvas after the label was deleted
            self.reading.destroyed.connect(
                lambda: [canvas.mpl_disconnect(each) for each in connections]
            )
            self._plots.addWidget(self.canvas, 1)
        return self.canvas

    def _show_values_at(self, event) -> None:
        """Show the values under the mouse."""
        comparison, axes = self._current_comparison, event.inaxes
        if comparison is None or axes is None:
            return
        if self.plot.currentIndex() == PROFILE_PLOT:
            profiles: tuple[tuple[ProfileAxis, DistanceProfile | None], ...] = (
                ("height", comparison.by_height), ("range", comparison.by_range)
            )  # fmt: skip
            drawn = [(axis, each) for axis, each in profiles if each is not None]
            for place, (axis, profile) in zip(axes.figure.axes, drawn, strict=False):
                if place is axes:
                    self.reading.setText(profile_bin_text(profile, axis, event.xdata))
            return
        edges = axes.patches[0].get_data().edges
        k = int(edges.searchsorted(event.xdata, side="right")) - 1
        if 0 <= k < len(edges) - 1:
            low, high = edges[k] / 1000.0, edges[k + 1] / 1000.0
            self.reading.setText(histogram_bar_text(comparison, low, high))

    def _copy_picture(self) -> None:
        if self.canvas is not None:
            QGuiApplication.clipboard().setPixmap(self.canvas.picture())
            self.reading.setText(gettext("The picture was copied to the clipboard"))

    def _copy_numbers(self) -> None:
        comparison = self._current_comparison
        if comparison is None or self.canvas is None:
            return
        if self.plot.currentIndex() == PROFILE_PLOT:
            text = profiles_text(comparison)
        else:
            from lispac.report.histograms import MAX_BARS

            low, high = self.canvas.figure.axes[0].get_xlim()
            text = histogram_text(comparison, (high - low) / 1000.0, MAX_BARS)
        QGuiApplication.clipboard().setText(text)
        self.reading.setText(gettext("The numbers were copied to the clipboard"))


def _statistics_text(template: str, state: DistanceStatistics) -> str:
    median, rms, p95 = (
        units.local_figure(1000 * value, "mm", ".1f")
        for value in (state.median, state.rms, state.p95)
    )
    return gettext(
        template, count=state.n, median=median, rms=rms, p95=p95, unit=units.local_sign("mm")
    )


def _plane_tip(each: PlaneComparison) -> str:
    model = message_text(each.model.name)
    return gettext(
        POOLED_PLANE_TIPS[each.pooled_from], plane=each.name, model=model,
        pooled=_pooled_pairs(each), total=len(each.pairs),
    )  # fmt: skip


def _pooled_pairs(each: PlaneComparison) -> int:
    """Number of pairs of lines in the statistics of a plane."""
    if each.pooled_from == "all pairs":
        return len(each.pairs)
    return sum(pair.reciprocal for pair in each.pairs)


def _comparison_texts(each: PlaneComparison) -> list[str]:
    def change(*states: float) -> str:
        before, after = (units.local_figure(1000 * each, "mm", ".1f") for each in states)
        return f"{before} → {after}"

    return [
        each.name,
        gettext("{pooled:n} of {total:n}", pooled=_pooled_pairs(each), total=len(each.pairs)),
        number(each.before.n, 0),
        change(each.before.rms, each.after.rms),
        change(each.before.p95, each.after.p95),
    ]


def _create_table() -> QTableWidget:
    table = QTableWidget(0, len(_COLUMNS))
    table.setTabKeyNavigation(False)
    table.setObjectName("comparison_table")
    table.setAccessibleName(gettext("Validation planes before and after"))
    unit = units.local_sign("mm")
    table.setHorizontalHeaderLabels([gettext(title, unit=unit) for title, _ in _COLUMNS])
    for column, (_, tip) in enumerate(_COLUMNS):
        head = table.horizontalHeaderItem(column)
        head.setToolTip(gettext(tip))
        if column:
            head.setTextAlignment(_ALIGN_RIGHT)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(22)
    table.setShowGrid(False)
    table.setAlternatingRowColors(True)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.horizontalHeader().setHighlightSections(False)
    table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    table.setSizeAdjustPolicy(QAbstractItemView.SizeAdjustPolicy.AdjustToContents)
    return table
