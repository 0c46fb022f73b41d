"""Distances between the lines on each validation plane, before and after the adjustment."""

from collections.abc import Sequence
from html import escape
from typing import Literal

import numpy as np
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QGuiApplication, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QSplitter,
    QStackedLayout,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.appearance import units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.validate import pairs_table
from lispac.gui.features.validate.planes_table import P95, PAIRS, PlanesTable
from lispac.gui.project.status import OUTDATED_RESULT_NOTE, ProjectState
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.gui.widgets.result_tables import spreadsheet_text
from lispac.language import N_, gettext
from lispac.present.checking.acceptance import (
    AcceptanceCriteriaValues,
    AcceptanceValues,
    failed_texts,
)
from lispac.present.checking.distance_bins import (
    BOTH_PROFILES_TABLE,
    HISTOGRAM_TABLE,
    distance_steps,
    histogram_bins,
)
from lispac.present.checking.validation import (
    WINDOW_PAIRS_TABLE,
    PairValues,
    ValidationPlane,
)
from lispac.validation.comparison_results import DistanceStatistics, PlaneComparison
from lispac.validation.distance_bins import merge_bins
from lispac.validation.distance_profile import DistanceProfile

EMPTY_TEXT = N_(
    "No comparison yet. Pick validation planes, estimate the boresight, then press Validate in "
    "step 4."
)
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


LOW_PLOT_PX = 280
"""Height of the plot below which the histogram has no title and legend, pixels."""
MIN_PLOT_PX = 100
"""Smallest height of the plot, pixels."""
MIN_STACKED_HEIGHT_PX = 340
"""Height of the panel from which the pairs of lines are below the planes, pixels."""
MIN_TABLE_WIDTH_PX = 250
"""Width of the table of planes with the names, RMS and offsets, pixels."""
PLOT_TITLES = (
    N_("Histogram"),
    N_("Histogram (%)"),
    N_("By height, range"),
    N_("Pairs of lines"),
)
PERCENT_PLOT, PROFILE_PLOT, PAIRS_VIEW = 1, 2, 3
"""Indices in `PLOT_TITLES`; the last one is a table."""
PAIRS_HINT = N_(
    "Offsets are positive if the first line is nearer to the vessel. ⇄: reciprocal lines, run in "
    "opposite directions."
)
PAIR_COLOURS_HINT = N_("Orange: larger than before the calibration. Red: larger than the limit.")
"""Added if a value has one of these colours."""
ZOOM_HINT = N_("Wheel: zoom. Drag: move. Double-click: show all.")
LEGEND_TEMPLATES = (
    N_("before: n {count:n}\nmedian {median}, RMS {rms}, 95 % {p95} {unit}"),
    N_("after: n {count:n}\nmedian {median}, RMS {rms}, 95 % {p95} {unit}"),
)
"""Entries of the legend of the histogram before and after, as in the report."""


class _ReadingLabel(QLabel):
    """Text below the table of planes; it uses only the space that the table leaves."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("comparison_reading")
        self.setProperty("role", "muted")
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self.setContentsMargins(4, 4, 4, 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint nothing where even the first line would be cut off."""
        if self.contentsRect().height() >= self.fontMetrics().height():
            super().paintEvent(event)

    def hasHeightForWidth(self) -> bool:
        """Return False: the height of the text would make the table lower."""
        return False


class HistogramsPanel(QWidget):
    """Validation: table of the planes; histograms, profiles or pairs of lines of the selected one.

    The worst plane is selected by itself after each validation.
    """

    plane_selected = Signal(str)
    """Another plane was selected, by the user or as the worst one."""
    plane_activated = Signal(str)
    """The user double-clicked a plane, or pressed Enter on it."""
    used_changed = Signal(str, bool)
    """The user excluded or included a plane."""
    enlarged = Signal(bool)
    """The user wants a higher panel, or the initial height."""

    def __init__(self) -> None:
        super().__init__()
        self._comparisons: tuple[PlaneComparison, ...] = ()
        self._values: AcceptanceValues | None = None
        self._fitted_width = 0
        self._listed: tuple[PlaneComparison | None, AcceptanceCriteriaValues | None] = None, None
        """Plane and criteria of the listed pairs of lines."""
        self._has_coloured_pairs = False
        self.canvas: QWidget | None = None
        self._drawn: tuple[PlaneComparison | None, int] = None, 0
        """Plane and index of the plot of the picture."""
        self._drawing = IdleTask(self._redraw_selected, self)
        # The other panels show the new validation first
        self._announcing = IdleTask(self._announce_plane, self)
        self._stack = QStackedLayout(self)
        empty = QWidget()
        layout = widgets.vertical_layout(empty)
        self._empty = widgets.label(
            gettext(EMPTY_TEXT), "muted", wrap=True, name="histograms_empty"
        )
        layout.addWidget(self._empty)
        layout.addStretch(1)
        self._stack.addWidget(empty)
        filled = QSplitter(Qt.Orientation.Horizontal)
        filled.setObjectName("comparison_splitter")
        filled.setContentsMargins(4, 0, 4, 0)
        filled.setChildrenCollapsible(False)
        filled.addWidget(self._create_planes())
        filled.addWidget(self._create_views())
        filled.setStretchFactor(1, 1)
        self._parts = filled
        # Beside all parts, so that the choice stays under the mouse when they are arranged
        whole = QWidget()
        row = QHBoxLayout(whole)
        row.setContentsMargins(0, 0, 4, 0)
        row.setSpacing(4)
        row.addWidget(filled, 1)
        row.addLayout(self._create_tools())
        self._stack.addWidget(whole)
        self._plot_form = True, False
        """Whether the plot is too low for a legend, and whether it is wide."""

    def _create_planes(self) -> QWidget:
        """Table of the planes, and a text on the selected one or on the plot under the mouse."""
        self.table = PlanesTable()
        self.table.plane_selected.connect(self._on_plane_selected)
        self.table.used_changed.connect(self.used_changed)
        self.table.activated.connect(lambda _index: self.plane_activated.emit(self.current))
        self.reading = _ReadingLabel()
        planes = QWidget()
        column = QVBoxLayout(planes)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.table)
        column.addWidget(self.reading, 1)
        planes.setMinimumWidth(MIN_TABLE_WIDTH_PX)
        return planes

    def _create_views(self) -> QWidget:
        """Plot or pairs of lines of the selected plane."""
        self.pairs = pairs_table.create_pairs_table()
        self._views = QStackedWidget()
        plots = QWidget()
        self._plots = QVBoxLayout(plots)
        self._plots.setContentsMargins(0, 0, 0, 0)
        self._views.addWidget(plots)
        self._views.addWidget(self.pairs)
        self.model_difference = widgets.label(
            "", "warning", wrap=True, name="comparison_other_model"
        )
        self.model_difference.hide()
        details = QWidget()
        column = QVBoxLayout(details)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.model_difference)
        column.addWidget(self._views, 1)
        return details

    def _create_tools(self) -> QVBoxLayout:
        """Choice and buttons: beside the plots and the table because the panel is low."""
        self.plot = widgets.ChoiceBox(
            "comparison_plot", [gettext(plot) for plot in PLOT_TITLES],
            gettext(
                "Number of points by distance, share of the points by distance, distance against "
                "height and range, or a table of the pairs of lines. After a calibration the "
                "distances should not grow with height or range."
            ),
        )  # fmt: skip
        self.plot.setSizeAdjustPolicy(self.plot.SizeAdjustPolicy.AdjustToContents)
        self.plot.currentIndexChanged.connect(self._show_chosen_view)
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
        # It is shown and hidden during the layout of the plot, too late to get a place of its own
        policy = self._colours.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self._colours.setSizePolicy(policy)
        self.zoom = widgets.button(
            gettext("Zoom to"), "zoom_to_plane",
            tip=gettext("Zoom to the selected plane in the 3D view, as a double-click on its row"),
        )  # fmt: skip
        self.zoom.clicked.connect(lambda _on: self.plane_activated.emit(self.current))
        self.enlarge = widgets.enlarge_button("enlarge_histograms")
        self.enlarge.toggled.connect(self._on_enlarged)
        last = QHBoxLayout()
        last.addWidget(self.zoom, 1)
        last.addWidget(self.enlarge)
        tools = QVBoxLayout()
        tools.setSpacing(2)
        for each in (self.plot, self.copy_picture, self.copy_numbers):
            tools.addWidget(each)
        tools.addLayout(last)
        tools.addWidget(self._colours)
        tools.addStretch(1)
        return tools

    def show_model_difference(self, text: str) -> None:
        """Show that the comparison was made with another surface model; "" if it was not."""
        self.model_difference.setText(text)
        self.model_difference.setVisible(bool(text))

    @property
    def current(self) -> str | None:
        """Name of the plane whose histograms are drawn."""
        each = self._current_comparison
        return None if each is None else each.name

    @property
    def _current_comparison(self) -> PlaneComparison | None:
        return self.table.current_comparison

    def _adapt_to_plot_size(self) -> None:
        """Arrange title and legend for the size of the plot, or name the colours beside it."""
        from lispac.report.figures import is_wide

        is_low = self.canvas.height() < LOW_PLOT_PX
        form = is_low, is_wide(self.canvas.figure)
        if form != self._plot_form:
            self._plot_form = form
            self._show_colours()
            self._drawing.start()

    def _show_colours(self) -> None:
        """Show the colours beside a low plot, which has no legend."""
        self._colours.setVisible(self._plot_form[0] and self.plot.currentIndex() != PAIRS_VIEW)

    def show_state(self, state: ProjectState) -> None:
        """Show the comparisons of the project."""
        comparisons = () if state.project is None else state.project.validation
        self._stack.setCurrentIndex(1 if comparisons else 0)
        self._empty.setText(
            gettext("The lines are being compared on the validation planes.")
            if state.is_validating
            else message_text(OUTDATED_RESULT_NOTE)
            if state.is_outdated
            else gettext(EMPTY_TEXT)
        )
        is_new, failed = comparisons is not self._comparisons, self.table.failed
        shown = self._same_plane(comparisons) if is_new else None
        if is_new:
            self._comparisons = comparisons
            self.table.show_planes(comparisons)
        if state.project is None or not comparisons:
            return
        self._values = AcceptanceValues.of(state.project.judgement)
        self.table.show_verdicts(state.project)
        self._fit_table()
        fails_now = self.table.failed - failed and self.current not in self.table.failed
        if is_new or fails_now:
            self.table.select(shown or self.table.worst_plane())
            if shown is None:
                self._announcing.start()
            self._blank_other_picture()
            self._drawing.start()
        else:
            self._show_judgement()

    def _same_plane(self, comparisons: Sequence[PlaneComparison]) -> str | None:
        """Name of the plane that is shown, if other planes or its name were edited.

        None after a new validation, of which the worst plane is shown.
        """
        shown = self._current_comparison
        if shown is None:
            return None
        return next((each.name for each in comparisons if each.pairs is shown.pairs), None)

    def _on_enlarged(self, is_enlarged: bool) -> None:
        """Request another height; parts beside each other first, since they need less height."""
        if not is_enlarged:
            self._arrange(is_high=False)
            QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
        self.enlarged.emit(is_enlarged)

    def _fit_table(self) -> None:
        """Give the table the width of its columns, and the rest to the plot.

        A width that the user has chosen is kept until the columns need another one.
        """
        width = self.table.sizeHint().width()
        if width != self._fitted_width:
            self._fitted_width = width
            self._arrange()

    def _arrange(self, *, is_high: bool | None = None) -> None:
        """Place the many columns of the pairs below the planes if the panel is high enough.

        If it is low, the planes leave the width of their last columns to the pairs.
        """
        if is_high is None:
            is_high = self.height() >= MIN_STACKED_HEIGHT_PX
        is_pairs = self.plot.currentIndex() == PAIRS_VIEW
        is_stacked = is_pairs and is_high
        orientation = Qt.Orientation.Vertical if is_stacked else Qt.Orientation.Horizontal
        self._parts.setOrientation(orientation)
        for column in (P95, PAIRS):
            self.table.setColumnHidden(column, is_pairs and not is_stacked)
        whole, first = self._parts.width(), self.table.sizeHint().width()
        if is_stacked:
            line = self.reading.fontMetrics().lineSpacing()
            whole, first = self._parts.height(), self.table.sizeHint().height() + 2 * line
        elif is_pairs:  # the low table has a scroll bar, and its numbers are not to be cut
            first += self.table.verticalScrollBar().sizeHint().width()
        self._parts.setSizes([first, max(whole - first, 1)])
        self._show_judgement()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Arrange the parts again if the panel has become high or low."""
        super().resizeEvent(event)
        was_high = event.oldSize().height() >= MIN_STACKED_HEIGHT_PX
        if was_high != (self.height() >= MIN_STACKED_HEIGHT_PX):
            self._arrange()

    def _show_judgement(self) -> None:
        """Show the values of the selected plane and of its pairs of lines that exceed a limit."""
        comparison, values = self._current_comparison, self._values
        if comparison is None or values is None:
            return
        listed, criteria = self._listed
        if listed is not comparison or criteria != values.criteria:
            self._listed = comparison, values.criteria
            rows = pairs_table.pair_rows(comparison, values.criteria)
            self.pairs.show_rows(rows)
            self._has_coloured_pairs = any(row.quality for row in rows)
        self._show_idle_reading()

    def _show_idle_reading(self) -> None:
        """Show the signs of pairs, and the values that exceed a limit or what the mouse does."""
        comparison, values = self._current_comparison, self._values
        failures = (
            () if comparison is None or values is None else failed_texts(values, comparison.name)
        )
        is_table = self.plot.currentIndex() == PAIRS_VIEW
        texts = [*failures] if is_table or failures else [gettext(ZOOM_HINT)]
        if is_table:
            colours = [gettext(PAIR_COLOURS_HINT)] if self._has_coloured_pairs else []
            texts.insert(0, " ".join([gettext(PAIRS_HINT), *colours]))
        self.reading.setText("\n".join(texts))
        self.reading.setToolTip(widgets.wrapped_tip("\n".join(texts if is_table else failures)))

    def select(self, name: str) -> None:
        """Draw the histograms of one plane without emitting a signal."""
        self._announcing.stop()  # the selection is newer than the validation
        if self.current != name and self.table.select(name):
            self._redraw_selected()

    def _on_plane_selected(self, name: str) -> None:
        self._redraw_selected()
        self.plane_selected.emit(name)

    def _announce_plane(self) -> None:
        if self.current is not None:
            self.plane_selected.emit(self.current)

    def _show_chosen_view(self, index: int) -> None:
        is_table = index == PAIRS_VIEW
        if is_table != bool(self._views.currentIndex()):
            self._views.setCurrentIndex(int(is_table))
            self._show_colours()
            self._arrange()
        no_plot = first_reason((is_table, Unavailable.NO_PLOT))
        self.copy_picture.set_reason(reason_text(no_plot))
        self._redraw_selected()

    def _redraw_selected(self) -> None:
        if self._current_comparison is not None:
            self._draw(self._current_comparison)

    def _blank_other_picture(self) -> None:
        """Show no picture instead of one that is not of the selected plane and plot."""
        drawn = self._current_comparison, self.plot.currentIndex()
        if self.canvas is not None and drawn != self._drawn:
            self.canvas.blank()
        self._drawn = drawn

    def _draw(self, comparison: PlaneComparison) -> None:
        # Imported here, so that the start of the window does not wait for it.
        from lispac.report.distance_profiles import profile_figure
        from lispac.report.histograms import STATE_COLOURS, histogram_figure

        self._show_judgement()
        if self.plot.currentIndex() == PAIRS_VIEW:
            return
        canvas = self._plot_canvas()
        self._blank_other_picture()
        states = gettext("before"), gettext("after")
        self._colours.setText(
            "&nbsp; ".join(
                f"<span style='color:{canvas.shown_colour(colour)}'>■</span> {escape(state)}"
                for colour, state in zip(STATE_COLOURS, states, strict=True)
            )
        )
        self._colours.setMinimumWidth(self._colours.sizeHint().width())  # rich text is cut
        if self.plot.currentIndex() == PROFILE_PLOT:
            profile_figure(comparison, canvas.figure)
            if self._plot_form[0]:
                _shorten_profile_texts(canvas.figure)
        else:
            share = self.plot.currentIndex() == PERCENT_PLOT
            histogram_figure(comparison, canvas.figure, share=share, titled=not self._plot_form[0])
        self._show_units(canvas.figure)
        limits = [axes.get_xlim() for axes in canvas.figure.axes]
        if self.plot.currentIndex() != PROFILE_PLOT:
            furthest = 1000.0 * float(comparison.bin_edges[-1])
            limits = [(0.0, max(furthest, shown[1])) for shown in limits]
        self._zooming.set_home(zooms_vertically=False, limits=limits)
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

            self.canvas = Chart(260, MIN_PLOT_PX)
            self.canvas.setObjectName("histogram_canvas")
            self.canvas.setToolTip(gettext(ZOOM_HINT))
            self._zooming = PlotZoom(self.canvas)
            canvas, leave = self.canvas, lambda _event: self._show_idle_reading()
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
        elif self.plot.currentIndex() == PAIRS_VIEW:
            text = spreadsheet_text(WINDOW_PAIRS_TABLE, map(PairValues.of, comparison.pairs))
        else:
            from lispac.report.histograms import MAX_BARS

            low, high = self.canvas.figure.axes[0].get_xlim()
            text = histogram_text(comparison, (high - low) / 1000.0, MAX_BARS)
        QGuiApplication.clipboard().setText(text)
        self.reading.setText(gettext("The numbers were copied to the clipboard"))


def _shorten_profile_texts(figure) -> None:
    """Leave the height of a low figure to the curves."""
    figure.suptitle("")  # the plane is selected in the table
    if figure.axes[0].get_ylabel():
        figure.axes[0].set_ylabel(
            gettext("(mm, log)"), fontsize=figure.axes[0].yaxis.label.get_fontsize()
        )


def _statistics_text(template: str, state: DistanceStatistics) -> str:
    median, rms, p95 = (
        units.local_figure(1000 * value, "mm", ".1f")
        for value in (state.median, state.rms, state.p95)
    )
    return gettext(
        template, count=state.n, median=median, rms=rms, p95=p95, unit=units.local_sign("mm")
    )
