"""How the lines lie on the trajectory in time, and what mends it where they do not."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QScrollArea, QVBoxLayout, QWidget

from lispac.gui import theme
from lispac.gui.dialogs.import_files.remarks_view import RemarksView
from lispac.gui.dialogs.import_files.timeline import TimelineView
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.messages import Action, Level, Message
from lispac.workflow.intake import Intake


class TimelinePage(QWidget):
    """The timeline, a sentence for each line that is not covered, and the longest gap bridged."""

    remedy_chosen = Signal(object, object)
    """Path, and `Action`."""
    shift_all_asked = Signal()
    gap_changed = Signal(float)
    file_selected = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 8, 10, 8)
        layout.setSpacing(theme.SPACE)
        self.remarks = RemarksView("import_time_remarks")
        self.remarks.remedy_chosen.connect(self._remedy)
        layout.addWidget(self.remarks)
        self.view = TimelineView()
        self.view.file_selected.connect(self.file_selected)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.StyledPanel)
        area.setAlignment(Qt.AlignmentFlag.AlignTop)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setStyleSheet(f"QScrollArea {{ background: {theme.PAPER}; }}")
        area.setWidget(self.view)
        layout.addWidget(area, 1)
        bottom = QHBoxLayout()
        self.gap = widgets.number(
            "import_longest_gap", suffix=" s", decimals=2, low=0.01, high=3600, step=0.5,
            tip="Longest gap between two states of the trajectory that a straight line bridges, "
            "seconds; points in longer gaps are left out",
        )  # fmt: skip
        self.gap.setKeyboardTracking(False)
        self.gap.valueChanged.connect(self.gap_changed)
        said = widgets.label("Longest gap bridged")
        said.setBuddy(self.gap)
        self.lost = widgets.label("", "muted", name="import_lost")
        self.all = widgets.button("", "import_shift_all", icon="clock-fast")
        self.all.setAutoDefault(False)
        self.all.clicked.connect(self.shift_all_asked)
        bottom.addWidget(said)
        bottom.addWidget(self.gap)
        bottom.addSpacing(12)
        bottom.addWidget(self.lost, 1)
        bottom.addWidget(self.all)
        layout.addLayout(bottom)
        self._owners: list[Path] = []

    def show_intake(self, intake: Intake, current: Path | None) -> None:
        """Draw the bars and say what is wrong."""
        self.view.show_intake(intake, current)
        self.gap.blockSignals(True)
        self.gap.setValue(intake.longest_gap)
        self.gap.blockSignals(False)
        self.gap.setEnabled(intake.into is None)
        found: list[tuple[Path, Message]] = []
        for line in intake.lines:
            for message in intake.time_remarks(line):
                params = {**message.params, "file": intake.names[line.path]}
                found.append((line.path, replace(message, params=params)))
        found.sort(key=lambda pair: pair[1].level is not Level.ERROR)
        self._owners = [path for path, _ in found]
        lines = len(intake.lines)
        what = "every line" if lines != 1 else "the line"
        fine = f"The trajectory covers {what}." if intake.track is not None and lines else ""
        self.remarks.setVisible(bool(found or fine))
        self.remarks.show_remarks([message for _, message in found], fine)
        self.lost.setText(say(_lost(intake)))
        offered = intake.shifts_offered
        self.all.setVisible(len(offered) > 1)
        if offered:
            shifts = {shift for _, shift in offered}
            words = f"Add {offered[0][1]:+,.3f} s to" if len(shifts) == 1 else "Shift"
            self.all.setText(say(f"{words} all {len(offered)} lines outside"))

    def _remedy(self, action: Action, place: int) -> None:
        self.remedy_chosen.emit(self._owners[place], action)


def _lost(intake: Intake) -> str:
    """What the gaps cost, over all lines."""
    found = [covered for line in intake.lines if (covered := intake.coverage(line)) is not None]
    count = sum(covered.count for covered in found)
    if not count:
        return ""
    share = 100 * sum(covered.in_gaps for covered in found) / count
    return f"{share:.1f} % of the points lie in longer gaps"
