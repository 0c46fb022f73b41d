"""Panel of simulated surveys, which check the predicted standard deviations."""

from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QFormLayout, QHBoxLayout, QScrollArea, QVBoxLayout, QWidget

from lispac.design.monte_carlo import MIN_SURVEYS
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.features.design.angles_table import AnglesTable
from lispac.gui.window.window_state import copy_fields
from lispac.language import N_, gettext

MAX_SURVEYS = 5000
HINT = N_(
    "Each survey is simulated with form errors of the targets, LiDAR noise, correlated POS errors "
    "and vessel roll, and then adjusted like a real survey. The scatter of the estimated angles "
    "about the true angles is compared with the predicted standard deviations."
)


@dataclass(frozen=True)
class SimulationRequest:
    """Number and kind of the surveys to simulate."""

    surveys: int
    seed: int
    flatness_known: bool


class SurveysPanel(QScrollArea):
    """Form of the simulation and table of its result."""

    requested = Signal()
    cancel_requested = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("design_surveys")
        self.setWidgetResizable(True)
        self.surveys = widgets.number(
            "surveys_count", suffix="", decimals=0, low=MIN_SURVEYS, high=MAX_SURVEYS, step=100,
            tip=gettext(
                "Number of surveys to simulate and adjust, {low:n} to {high:n}",
                low=MIN_SURVEYS, high=MAX_SURVEYS,
            ),
        )  # fmt: skip
        self.surveys.setValue(200)
        self.seed = widgets.number(
            "surveys_seed", suffix="", decimals=0, low=0, high=999_999_999, step=1,
            tip=gettext(
                "Seed of the random number generator; the same seed gives the same surveys"
            ),
        )  # fmt: skip
        self.seed.setValue(2027)
        for field in (self.surveys, self.seed):
            field.setGroupSeparatorShown(field is self.surveys)
        self.flatness = QCheckBox(gettext("Use the known form error of the targets"))
        self.flatness.setObjectName("surveys_flatness")
        self.flatness.setToolTip(
            gettext(
                "If not ticked, the adjustment estimates the form error from the data, as in "
                "a real survey"
            )
        )
        self.start = widgets.button(
            gettext("Simulate surveys"), "surveys_start", primary=True,
            tip=gettext("Simulate and adjust the surveys in the background"),
        )  # fmt: skip
        self.cancel = widgets.button(
            gettext("Cancel"), "surveys_cancel",
            tip=gettext("Stop the simulation. The result is shown if at least {count:n} surveys "
                        "are finished.",
                        count=MIN_SURVEYS),
        )  # fmt: skip
        self.result_table = AnglesTable("surveys_result", gettext(HINT))
        body = QWidget()
        both, left = QHBoxLayout(body), QVBoxLayout()
        form = QFormLayout()
        form.addRow(gettext("Number of surveys"), self.surveys)
        form.addRow(gettext("Random seed"), self.seed)
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
            each.setSpacing(theme.SPACING)
        both.addLayout(left, 2)
        both.addWidget(self.result_table, 3)
        self.setWidget(body)
        self.start.clicked.connect(lambda: self.requested.emit())
        self.cancel.clicked.connect(lambda: self.cancel_requested.emit())

    def copy_state_from(self, former: "SurveysPanel") -> None:
        """Copy the choices and the result of another panel."""
        copy_fields(former, self)
        self.result_table.copy_state_from(former.result_table)

    @property
    def simulation_request(self) -> SimulationRequest:
        """Number and kind of surveys, from the fields."""
        return SimulationRequest(
            round(self.surveys.value()), round(self.seed.value()), self.flatness.isChecked()
        )

    def show_busy(self, busy: bool) -> None:
        """Enable or disable the controls while a task runs."""
        self.cancel.setEnabled(busy)
        self.start.update_enabled(not busy)
