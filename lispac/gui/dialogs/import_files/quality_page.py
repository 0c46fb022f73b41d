"""The trajectory's quality: one figure at a time, drawn when it is looked at."""

from PySide6.QtCore import Signal
from PySide6.QtGui import QFont, QFontMetrics
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QVBoxLayout, QWidget

from lispac.gui import theme
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.workflow.intake import Intake

NAMES = ("Accuracies", "Track", "Speed and attitude")
_TIPS = (
    "Standard deviations of position and attitude over time",
    "The way of the vessel on a map, the lines in their colours",
    "Speed, roll and pitch, heading over time",
)


class QualityPage(QWidget):
    """Buttons to choose the figure, and its canvas."""

    drawn = Signal()

    def __init__(self) -> None:
        super().__init__()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 8, 10, 8)
        layout.setSpacing(theme.SPACE)
        row = QHBoxLayout()
        row.setSpacing(0)
        self.choice = QButtonGroup(self)
        for k, (name, tip) in enumerate(zip(NAMES, _TIPS, strict=True)):
            made = widgets.button(name, f"quality_{k}", tip=tip)
            made.setCheckable(True)
            made.setAutoDefault(False)
            made.setProperty("segment", True)
            bold = QFont(made.font())
            bold.setBold(True)
            made.setMinimumWidth(QFontMetrics(bold).horizontalAdvance(name) + 24)
            self.choice.addButton(made, k)
            row.addWidget(made)
        row.addSpacing(14)
        self._hint = widgets.label("Shaded: the lines.", "muted")
        row.addWidget(self._hint)
        row.addStretch(1)
        layout.addLayout(row)
        self._empty = widgets.label(
            "Add the trajectory: its accuracies, its track and its motion appear here.",
            "muted", wrap=True, name="quality_empty",
        )  # fmt: skip
        layout.addWidget(self._empty)
        self._layout = layout
        self.canvas: QWidget | None = None
        self._intake: Intake | None = None
        self._stale = True
        self.choice.button(0).setChecked(True)
        self.choice.idClicked.connect(lambda _id: self._draw(anew=True))

    def show_intake(self, intake: Intake) -> None:
        """Draw what there is, now or when the page is shown."""
        before = self._intake
        self._intake = intake
        if before is None or _seen(before) != _seen(intake):
            self._stale = True
        if self.isVisible():
            self._draw()

    def showEvent(self, event) -> None:
        """Draw what has changed while it was out of sight."""
        super().showEvent(event)
        self._draw()

    def _draw(self, anew: bool = False) -> None:
        if self._intake is None or not (self._stale or anew):
            return
        ready = self._intake.track is not None
        self._empty.setVisible(not ready)
        self._hint.setVisible(ready)
        for each in self.choice.buttons():
            each.setEnabled(ready)
        if self.canvas is not None:
            self.canvas.setVisible(ready)
        self._stale = False
        if not ready:
            return
        # Imported here, so that the start of the dialogue does not wait for it.
        from lispac.gui.dialogs.import_files.quality_figures import PAGES, Quality
        from lispac.gui.panels.chart import Chart

        if self.canvas is None:
            self.canvas = Chart(300, 180, theme.PAPER)
            self.canvas.setObjectName("quality_canvas")
            self._layout.addWidget(self.canvas, 1)
        quality = Quality.of(self._intake)
        assert quality is not None
        name = NAMES[self.choice.checkedId()]
        self._hint.setText(say("Coloured: the lines." if name == "Track" else "Shaded: the lines."))
        PAGES[name](quality, self.canvas.figure)
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(say(f"{name} of the trajectory over time, lines marked"))
        self.drawn.emit()


def _seen(intake: Intake) -> tuple[object, ...]:
    """What the figures rest on; entries are compared by identity."""
    lines = tuple((id(line.content), line.shift, intake.names[line.path]) for line in intake.lines)
    base = intake.time_base
    return id(intake.track), id(intake.sigmas), lines, intake.longest_gap, base
