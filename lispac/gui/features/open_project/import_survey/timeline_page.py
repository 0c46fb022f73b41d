"""Page with the timeline of the import, messages about times and their suggested actions."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QScrollArea, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.features.open_project.import_survey.message_list import MessageList
from lispac.gui.features.open_project.import_survey.timeline import TimelineView
from lispac.language import Plural, gettext
from lispac.messages import Action, Level, Message
from lispac.workflow.importing.input_files import InputFiles


class TimelinePage(QWidget):
    """Timeline, messages about lines that are not covered, and the longest interpolated gap."""

    action_chosen = Signal(object, object)
    """Path, and `Action`."""
    shift_all_requested = Signal()
    gap_changed = Signal(float)
    file_selected = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 8, 10, 8)
        layout.setSpacing(theme.SPACING)
        self.messages = MessageList("import_time_messages")
        self.messages.action_chosen.connect(self._on_action_chosen)
        layout.addWidget(self.messages)
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
            tip=gettext(
                "Longest gap of the trajectory that is interpolated, in seconds. Points in longer "
                "gaps are excluded."
            ),
        )  # fmt: skip
        self.gap.setKeyboardTracking(False)
        self.gap.valueChanged.connect(self.gap_changed)
        label = widgets.label(gettext("Longest interpolated gap"))
        label.setBuddy(self.gap)
        self.lost = widgets.label("", "muted", name="import_lost")
        self.all = widgets.button("", "import_shift_all", icon="clock-fast")
        self.all.setAutoDefault(False)
        self.all.clicked.connect(self.shift_all_requested)
        bottom.addWidget(label)
        bottom.addWidget(self.gap)
        bottom.addSpacing(12)
        bottom.addWidget(self.lost, 1)
        bottom.addWidget(self.all)
        layout.addLayout(bottom)
        self._owners: list[Path] = []

    def show_files(self, input_files: InputFiles, current: Path | None) -> None:
        """Draw the bars and list the messages."""
        self.view.show_files(input_files, current)
        self.gap.blockSignals(True)
        self.gap.setValue(input_files.longest_gap)
        self.gap.blockSignals(False)
        self.gap.setEnabled(input_files.project is None)
        found: list[tuple[Path, Message]] = []
        for line in input_files.lines:
            for message in input_files.time_messages(line):
                params = {**message.params, "file": input_files.names[line.path]}
                found.append((line.path, replace(message, params=params)))
        found.sort(key=lambda pair: pair[1].level is not Level.ERROR)
        self._owners = [path for path, _ in found]
        fine = ""
        if input_files.trajectory_content is not None and input_files.lines:
            fine = gettext(
                Plural("The trajectory covers the line.", "The trajectory covers all lines."),
                count=len(input_files.lines),
            )
        self.messages.setVisible(bool(found or fine))
        self.messages.show_messages([message for _, message in found], fine)
        self.lost.setText(_share_in_gaps(input_files))
        offered = input_files.proposed_shifts
        self.all.setVisible(len(offered) > 1)
        shifts = {shift for _, shift in offered}
        if len(shifts) == 1:
            self.all.setText(
                gettext(
                    "Add {shift:s.3+} s to the times of {count:n} uncovered lines",
                    shift=offered[0][1], count=len(offered),
                )
            )  # fmt: skip
        else:
            self.all.setText(
                gettext("Shift the times of {count:n} uncovered lines", count=len(offered))
            )

    def _on_action_chosen(self, action: Action, place: int) -> None:
        self.action_chosen.emit(self._owners[place], action)


def _share_in_gaps(input_files: InputFiles) -> str:
    """Share of the points of all lines in gaps that are not interpolated."""
    found = [
        covered for line in input_files.lines if (covered := input_files.coverage(line)) is not None
    ]
    count = sum(covered.count for covered in found)
    if not count:
        return ""
    share = sum(covered.in_gaps for covered in found) / count
    return gettext("Points excluded in longer gaps: {share:percent.1} %", share=share)
