"""Do the sigmas hold? How many surveys of the plan to simulate, and what they said."""

from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QFormLayout, QHBoxLayout, QScrollArea, QVBoxLayout, QWidget

from lispac.design.monte_carlo import ENOUGH
from lispac.gui import theme
from lispac.gui.carrying import fill_in
from lispac.gui.design.angles_table import AnglesTable
from lispac.gui.language import say
from lispac.gui.panels import widgets

MOST = 5000
HINT = (
    "Every survey has boards off their shape, LiDAR noise, POS errors that drift and a rolling "
    "vessel, and is adjusted as a real one. Their answers scatter about the truth: as much as "
    "foretold, or not. The surveys are of the plan as it stands when they begin."
)


@dataclass(frozen=True)
class Asked:
    """A campaign, as it was asked for."""

    surveys: int
    seed: int
    flatness_known: bool


class SurveysPanel(QScrollArea):
    """Asks for a campaign, and shows its answer."""

    asked = Signal()
    cancel_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("design_surveys")
        self.setWidgetResizable(True)
        self.surveys = widgets.number(
            "surveys_count", suffix="", decimals=0, low=ENOUGH, high=MOST, step=100,
            tip=f"How many surveys to simulate and adjust, {ENOUGH} to {MOST:,}",
        )  # fmt: skip
        self.surveys.setValue(200)
        self.seed = widgets.number(
            "surveys_seed", suffix="", decimals=0, low=0, high=999_999_999, step=1,
            tip="Seed of chance: another one gives other surveys, the same one the same",
        )  # fmt: skip
        self.seed.setValue(2027)
        for field in (self.surveys, self.seed):
            field.setGroupSeparatorShown(field is self.surveys)
        self.flatness = QCheckBox(say("The adjustment is told how flat the targets are"))
        self.flatness.setObjectName("surveys_flatness")
        self.flatness.setToolTip(
            say("Otherwise it takes their flatness from the data, as with a real survey")
        )
        self.start = widgets.button(
            "Simulate surveys", "surveys_start", primary=True,
            tip="Simulate and adjust them in the background; the plan stays as it is",
        )  # fmt: skip
        self.cancel = widgets.button(
            "Cancel", "surveys_cancel",
            tip=f"Stop; {ENOUGH} surveys or more that are finished are shown",
        )  # fmt: skip
        self.answer = AnglesTable("surveys_answer", HINT)
        body = QWidget()
        both, left = QHBoxLayout(body), QVBoxLayout()
        form = QFormLayout()
        form.addRow(say("Surveys"), self.surveys)
        form.addRow(say("Seed"), self.seed)
        buttons = QHBoxLayout()
        buttons.addWidget(self.start)
        buttons.addWidget(self.cancel)
        buttons.addStretch(1)
        left.addLayout(form)
        left.addWidget(self.flatness)
        left.addLayout(buttons)
        left.addStretch(1)
        both.setSpacing(20)
        for each in (left, form, buttons):  # else they take that of the whole
            each.setSpacing(theme.SPACE)
        both.addLayout(left, 2)
        both.addWidget(self.answer, 3)
        self.setWidget(body)
        self.start.clicked.connect(lambda: self.asked.emit())
        self.cancel.clicked.connect(lambda: self.cancel_asked.emit())

    def take_over(self, former: "SurveysPanel") -> None:
        """Take what another one would ask for, and the answer that it shows."""
        fill_in(former, self)
        self.answer.take_over(former.answer)

    @property
    def wanted(self) -> Asked:
        """What is asked for."""
        return Asked(
            round(self.surveys.value()), round(self.seed.value()), self.flatness.isChecked()
        )

    def show_busy(self, busy: bool) -> None:
        """Whether work runs."""
        self.cancel.setEnabled(busy)
        self.start.allow(not busy)
