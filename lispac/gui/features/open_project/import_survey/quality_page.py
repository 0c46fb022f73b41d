"""Page with the quality of the trajectory: one figure at a time, drawn when visible."""

from PySide6.QtCore import Signal
from PySide6.QtGui import QFont, QFontMetrics
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.language import N_, gettext
from lispac.workflow.importing.input_files import InputFiles

ACCURACIES, TRACK, MOTION = "accuracies", "track", "motion"
FIGURE_TITLES = {
    ACCURACIES: N_("Accuracies"),
    TRACK: N_("Track"),
    MOTION: N_("Speed and attitude"),
}
"""Labels of the figures."""
_FIGURE_TIPS = {
    ACCURACIES: N_("Standard deviations of position and attitude over time"),
    TRACK: N_("Track of the vessel on a map, with the lines in their colours"),
    MOTION: N_("Speed, roll, pitch and heading over time"),
}


class QualityPage(QWidget):
    """Page with the diagrams of the trajectory quality, and buttons to choose a diagram."""

    drawn = Signal()

    def __init__(self) -> None:
        super().__init__()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 8, 10, 8)
        layout.setSpacing(theme.SPACING)
        row = QHBoxLayout()
        row.setSpacing(0)
        self.choice = QButtonGroup(self)
        for k, (key, label) in enumerate(FIGURE_TITLES.items()):
            name = gettext(label)
            made = widgets.button(name, f"quality_{k}", tip=gettext(_FIGURE_TIPS[key]))
            made.setCheckable(True)
            made.setAutoDefault(False)
            made.setProperty("segment", True)
            bold = QFont(made.font())
            bold.setBold(True)
            made.setMinimumWidth(QFontMetrics(bold).horizontalAdvance(name) + 24)
            self.choice.addButton(made, k)
            row.addWidget(made)
        row.addSpacing(14)
        self._hint = widgets.label(gettext("Shaded areas: times of the lines"), "muted")
        row.addWidget(self._hint)
        row.addStretch(1)
        layout.addLayout(row)
        self._empty = widgets.label(
            gettext("Add a trajectory to see its accuracies, track and motion."),
            "muted",
            wrap=True,
            name="quality_empty",
        )
        layout.addWidget(self._empty)
        self._layout = layout
        self.canvas: QWidget | None = None
        self._input_files: InputFiles | None = None
        self._outdated = True
        self.choice.button(0).setChecked(True)
        self.choice.idClicked.connect(lambda _id: self._draw(anew=True))

    def show_files(self, input_files: InputFiles) -> None:
        """Draw the trajectory, now or when the page is shown."""
        before = self._input_files
        self._input_files = input_files
        if before is None or _drawn_data(before) != _drawn_data(input_files):
            self._outdated = True
        if self.isVisible():
            self._draw()

    def showEvent(self, event) -> None:
        """Draw changes made while the page was hidden."""
        super().showEvent(event)
        self._draw()

    def _draw(self, anew: bool = False) -> None:
        if self._input_files is None or not (self._outdated or anew):
            return
        ready = self._input_files.trajectory_content is not None
        self._empty.setVisible(not ready)
        self._hint.setVisible(ready)
        for each in self.choice.buttons():
            each.setEnabled(ready)
        if self.canvas is not None:
            self.canvas.setVisible(ready)
        self._outdated = False
        if not ready:
            return
        # Matplotlib is imported late, so that the dialogue starts without it.
        from lispac.gui.features.open_project.import_survey.quality_figures import (
            DRAW_FUNCTIONS,
            TrajectoryQuality,
        )
        from lispac.gui.widgets.chart import Chart

        if self.canvas is None:
            self.canvas = Chart(300, 180, theme.PAPER)
            self.canvas.setObjectName("quality_canvas")
            self._layout.addWidget(self.canvas, 1)
        quality = TrajectoryQuality.of(self._input_files)
        assert quality is not None
        key = list(FIGURE_TITLES)[self.choice.checkedId()]
        self._hint.setText(
            gettext("Coloured sections: lines")
            if key == TRACK
            else gettext("Shaded areas: times of the lines")
        )
        DRAW_FUNCTIONS[key](quality, self.canvas.figure)
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(gettext(_FIGURE_TIPS[key]))
        self.drawn.emit()


def _drawn_data(input_files: InputFiles) -> tuple[object, ...]:
    """Key of the data in the figures, which are drawn again if it changes."""
    lines = tuple(
        (id(line.content), line.shift, input_files.names[line.path]) for line in input_files.lines
    )
    base = input_files.time_base
    return (
        id(input_files.trajectory_content),
        id(input_files.accuracy_content),
        lines,
        input_files.longest_gap,
        base,
    )
