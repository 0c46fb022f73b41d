"""Section through all lines: its options and its picture."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.appearance import theme
from lispac.gui.features.inspect.section_titles import (
    AHEAD_LABEL,
    ALONG_LABEL,
    HEIGHT_LABEL,
    RIGHT_LABEL,
)
from lispac.gui.viewport.base import Colour
from lispac.language import N_, gettext, number
from lispac.present.checking.validation import PairOffset
from lispac.project import BoresightChoice
from lispac.workflow.checking.survey_sections import EXAGGERATIONS, SectionPoints

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLE = N_("Section")
ORIENTATION_TITLES = (N_("Vertical"), N_("Horizontal"))
"""Titles of the orientations of a section."""
EMPTY_TEXT = N_(
    "Select a target to show a section of all lines across it, or cut a section between two "
    "points. Lines that are shifted or tilted against each other indicate a wrong boresight."
)
ZOOM_HINT = N_("Wheel: zoom. Drag: move. Double-click: show all.")
OFFSET_HINT = N_(
    "Offset in a title: that of the two lines in brackets on the whole plane, as in the table of "
    "the pairs of lines (step 4) and in the report. After the calibration they have the largest "
    "offset of all pairs."
)
PRINT_DPI = 200


MIN_PRINT_HEIGHT_INCHES = 3.2
"""Smallest height of a saved picture, whose titles need more space than a low panel has."""
MIN_TEXT_WIDTH_PX = 260
"""Width with which the whole text without a section is visible in a low panel, pixels."""
LOW_PANEL_PX = 230
"""Height of the panel below which the titles of the axes are small, pixels."""


class SectionPanel(QWidget):
    """Options of the section and its picture; emits `changed`."""

    changed = Signal()
    """An option was changed."""
    points_requested = Signal()
    picture_requested = Signal()
    copy_requested = Signal()
    enlarged = Signal(bool)
    """The user wants a higher panel, or the initial height."""

    def __init__(self) -> None:
        super().__init__()
        self.through = widgets.label("", "heading", name="section_through")
        self.orientation = widgets.ChoiceBox(
            "section_laid", [gettext(title) for title in ORIENTATION_TITLES],
            gettext(
                "A vertical section shows height against distance and reveals errors of roll "
                "and pitch. A horizontal section shows the lines from above and reveals errors "
                "of yaw."
            ),
        )  # fmt: skip
        factors = [number(each, 0) for each in EXAGGERATIONS]
        self.exaggeration_choice = widgets.ChoiceBox(
            "section_exaggeration", [gettext("Automatic"), *factors],
            gettext(
                "Factor by which distances across the surface are drawn larger, so that small "
                "distances between lines are visible; between two points, that of heights"
            ),
        )  # fmt: skip
        self.thickness = widgets.number(
            "section_thickness", suffix=" m", decimals=2, low=0.01, high=50, step=0.05,
            tip=gettext("Thickness of the section"),
        )  # fmt: skip
        self.size = widgets.number(
            "section_size", suffix=" m", decimals=1, low=0.2, high=200, step=0.5,
            tip=gettext("Height of the section, and its width at a target"),
        )  # fmt: skip
        self.thickness.setValue(0.20)
        self.size.setValue(2.0)
        self.points = widgets.button(
            gettext("Between two points"), "section_points",
            tip=gettext("Cut a section between two clicked points"),
        )  # fmt: skip
        self.save_picture = widgets.button(
            gettext("Save…"), "section_save",
            tip=gettext("Save the section as shown, as PNG, SVG or PDF"),
        )  # fmt: skip
        self.copy_picture = widgets.button(
            gettext("Copy"), "section_copy",
            tip=gettext("Copy the section as shown to the clipboard"),
        )  # fmt: skip
        self.text_label = widgets.label(
            gettext(EMPTY_TEXT), "muted", wrap=True, name="section_text"
        )
        self.enlarge = widgets.enlarge_button("enlarge_section")
        self._arrange()
        self.canvas: QWidget | None = None
        self._is_low = True
        self._drawn_size = 0.0, 0.0
        """Width and height of the figure for which the section was drawn, inches."""
        self.enlarge.toggled.connect(self.enlarged)
        self.orientation.currentIndexChanged.connect(lambda _index: self.changed.emit())
        self.exaggeration_choice.currentIndexChanged.connect(self._redraw)
        self.thickness.valueChanged.connect(lambda _value: self.changed.emit())
        self.size.valueChanged.connect(lambda _value: self.changed.emit())
        self.points.clicked.connect(lambda _on: self.points_requested.emit())
        self.save_picture.clicked.connect(lambda _on: self.picture_requested.emit())
        self.copy_picture.clicked.connect(lambda _on: self.copy_requested.emit())
        self._allow_pictures(False)

    def _arrange(self) -> None:
        """Place the options on the left, and the text or the picture on the right."""
        buttons = QHBoxLayout()
        buttons.setSpacing(4)
        for each in (self.points, self.save_picture, self.copy_picture):
            buttons.addWidget(each)
        form = QFormLayout()
        head = QHBoxLayout()
        head.addWidget(self.through, 1)
        head.addWidget(self.enlarge)
        form.addRow(head)
        form.addRow(gettext("Cutting plane"), self.orientation)
        form.addRow(gettext("Exaggeration"), self.exaggeration_choice)
        sizes = QHBoxLayout()
        sizes.setSpacing(4)
        for each in (self.thickness, self.size):
            sizes.addWidget(each)
        form.addRow(gettext("Thickness, size"), sizes)
        form.setVerticalSpacing(2)
        self._left = QVBoxLayout()
        self._left.setSpacing(2)
        self._left.addLayout(form)
        self._left.addLayout(buttons)
        self._left.addStretch(1)
        side = QWidget()
        side.setLayout(self._left)
        side.setFixedWidth(side.minimumSizeHint().width() + 8)
        self._left.setContentsMargins(8, 2, 4, 2)
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 4, 0)
        self._row.addWidget(side)
        # Shown instead of the picture, since there is no space for the text beside the options.
        self._row.addWidget(self.text_label, 1)
        self.text_label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.text_label.setContentsMargins(16, 0, 16, 0)
        self.text_label.setMinimumWidth(MIN_TEXT_WIDTH_PX)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Make the titles of the axes smaller in a low panel."""
        super().resizeEvent(event)
        if (is_low := self.height() < LOW_PANEL_PX) != self._is_low:
            self._is_low = is_low
            self._redraw()

    def _fill_resized_plots(self) -> None:
        """Draw the section for another size of its plots."""
        width, height = self.canvas.figure.get_size_inches()
        if (size := (round(width, 1), round(height, 1))) != self._drawn_size:
            self._drawn_size = size
            self._redraw()

    @property
    def is_horizontal(self) -> bool:
        """Whether the section is horizontal."""
        return self.orientation.currentIndex() == 1

    @property
    def exaggeration(self) -> float | None:
        """Chosen factor across the surface; None for the automatic one."""
        chosen = self.exaggeration_choice.currentIndex()
        return EXAGGERATIONS[chosen - 1] if chosen > 0 else None

    @property
    def has_section(self) -> bool:
        """Whether a section is displayed."""
        return bool(self.through.text())

    def figure_for_print(self) -> "Figure":
        """Figure of the section with its title, which another thread may save."""
        from matplotlib.figure import Figure

        shown = self.canvas.figure
        width, height = shown.get_size_inches()
        size = width, max(height, MIN_PRINT_HEIGHT_INCHES)
        printed = Figure(figsize=size, dpi=PRINT_DPI, layout="constrained")
        with theme.paper_colours():
            self._draw(printed, labelled=True)
        for axes, shown_axes in zip(printed.axes, shown.axes, strict=True):
            axes.set(xlim=shown_axes.get_xlim(), ylim=shown_axes.get_ylim())
        printed.suptitle(self.through.text(), fontsize=11, parse_math=False)
        return printed

    def _allow_pictures(self, allowed: bool) -> None:
        reason = reason_text(first_reason((not allowed, Unavailable.NO_SECTION)))
        self.save_picture.set_reason(reason)
        self.copy_picture.set_reason(reason)

    def show_nothing(self, reason: str) -> None:
        """Show why there is no section."""
        self.through.setText("")
        self.text_label.setText(reason)
        self.text_label.show()
        self._allow_pictures(False)
        if self.canvas is not None:
            self.canvas.blank()
            self.canvas.hide()

    def show_cuts(
        self,
        through: str,
        cuts: Sequence[SectionPoints],
        colours: Mapping[str, Colour],
        offsets: Mapping[BoresightChoice, PairOffset],
        *,
        target: bool,
    ) -> None:
        """Show a section before and after the adjustment.

        Parameters
        ----------
        offsets : offset of two lines in the validation, of each cut that has one
        through : text that describes the position of the section
        target : whether the section is across a target, and not between two points
        """
        title = through
        self.through.setText(title)
        self.orientation.setEnabled(target)
        self.text_label.hide()
        self._make_canvas()
        across = RIGHT_LABEL if self.is_horizontal else AHEAD_LABEL
        upward = AHEAD_LABEL if self.is_horizontal else HEIGHT_LABEL
        axes = (across, upward) if target else (ALONG_LABEL, HEIGHT_LABEL)
        self._shown = cuts, colours, axes, offsets
        self._starts_at_left = not target
        self._redraw()
        self.canvas.show()
        self._allow_pictures(True)
        self.canvas.setAccessibleName(gettext("Section of the lines: {section}", section=title))

    def _redraw(self) -> None:
        if self.canvas is not None and self.has_section:
            self._draw(self.canvas.figure, labelled=not self._is_low)
            self._zooming.set_home()
            self.canvas.draw_idle()

    def _draw(self, figure: "Figure", *, labelled: bool) -> None:
        # Imported here, so that the start of the window does not wait for Matplotlib.
        from lispac.gui.features.inspect.section_figure import draw_section

        draw_section(
            *self._shown, figure, exaggeration=self.exaggeration,
            starts_at_left=self._starts_at_left, labelled=labelled,
        )  # fmt: skip

    def _make_canvas(self) -> None:
        if self.canvas is not None:
            return
        from lispac.gui.widgets.chart import Chart
        from lispac.gui.widgets.plot_zoom import PlotZoom

        self.canvas = Chart(300, 110, theme.PAPER)
        self.canvas.setObjectName("section_canvas")
        tip = f"{gettext(ZOOM_HINT)}\n{gettext(OFFSET_HINT)}"
        self.canvas.setToolTip(widgets.wrapped_tip(tip))
        self._zooming = PlotZoom(self.canvas)
        self.canvas.mpl_connect("resize_event", lambda _event: self._fill_resized_plots())
        self._row.addWidget(self.canvas, 1)
