"""Step 4: how far apart the lines are on planes that took no part, before and after."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QWidget

from lispac.gui.panels import widgets
from lispac.gui.status import StepStatus
from lispac.project import Project


class ValidatePanel(QWidget):
    """Runs the comparison and switches the clouds."""

    validate_asked = Signal()
    shown_changed = Signal(str)
    """Clouds are wanted with the "prior" or the "estimated" boresight."""

    def __init__(self) -> None:
        super().__init__()
        layout = widgets.column(self)
        layout.addWidget(
            widgets.label(
                "The lines are compared with each other, cloud to cloud, on planes that took no "
                "part in the adjustment.", "hint", wrap=True,
            )
        )  # fmt: skip
        self.advice = widgets.label("", wrap=True, name="validate_advice")
        layout.addWidget(self.advice)
        self.run = widgets.button(
            "Validate", "validate", icon="check-decagram-outline", primary=True,
            tip="Compare the lines on every validation plane, before and after (F10)",
        )  # fmt: skip
        self.run.clicked.connect(self.validate_asked)
        layout.addWidget(self.run)
        layout.addWidget(widgets.label("Lines in the view", "heading"))
        self.before = widgets.button(
            "Before", "show_before", tip="Lines placed with the prior boresight"
        )
        self.after = widgets.button(
            "After", "show_after", tip="Lines placed with the estimated boresight"
        )
        group = QButtonGroup(self)
        row = QHBoxLayout()
        row.setSpacing(0)
        for each, which in ((self.before, "prior"), (self.after, "estimated")):
            each.setCheckable(True)
            each.setProperty("segment", True)
            each.clicked.connect(lambda _=False, which=which: self.shown_changed.emit(which))
            group.addButton(each)
            row.addWidget(each)
        self.before.setChecked(True)
        layout.addLayout(row)

    def show_project(self, project: Project | None, status: StepStatus, busy: bool) -> None:
        """What can be done now."""
        self.advice.setText(status.advice)
        self.run.allow(status.ready and not busy)
        self.after.setEnabled(project is not None and project.result is not None)

    def show_which(self, which: str) -> None:
        """Which clouds the view shows."""
        (self.after if which == "estimated" else self.before).setChecked(True)
