"""Panel of simulated surveys, which verify the predicted standard deviations, and its table."""

from dataclasses import dataclass

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QGridLayout,
    QHBoxLayout,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from lispac.design.monte_carlo import MIN_SURVEYS
from lispac.design.plan import Plan
from lispac.gui import widgets
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.appearance import theme
from lispac.gui.widgets.field_transfer import copy_fields
from lispac.language import N_, LazyText, gettext
from lispac.present.planning.design_results import (
    ANGLES_BY_ROW_TABLE,
    PlanComparison,
    SimulationValues,
)
from lispac.present.tables import cell_text, title_text

OUT_OF_DATE_TEXT = N_(
    "This result is out of date because the survey plan was changed. Run the computation again."
)


AnglesResult = SimulationValues | PlanComparison


class AnglesTable(QWidget):
    """Table of roll, pitch and yaw; shows a hint until there is a result."""

    def __init__(self, name: str, hint: str) -> None:
        super().__init__()
        self.setObjectName(name)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.head = widgets.label("", "heading", wrap=True, name=f"{name}_head")
        self.hint = widgets.label(hint, "muted", wrap=True)
        self.messages = widgets.label("", "hint", wrap=True, name=f"{name}_words")
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(18)
        self._grid.setVerticalSpacing(3)
        self._grid.setColumnStretch(len(ANGLES_BY_ROW_TABLE.columns), 1)
        layout.addWidget(self.head)
        layout.addWidget(self.hint)
        layout.addLayout(self._grid)
        layout.addWidget(self.messages)
        layout.addStretch(1)
        self.outdated = widgets.label(
            gettext(OUT_OF_DATE_TEXT), "warning", wrap=True, name=f"{name}_out_of_date"
        )
        layout.insertWidget(1, self.outdated)
        for each in (self.head, self.outdated, self.messages):
            each.hide()
        self._plan: Plan | None = None
        self._shown: tuple[LazyText, AnglesResult, Plan] | None = None

    def set_current_plan(self, plan: Plan) -> None:
        """Mark the result as out of date if it belongs to another plan."""
        self.outdated.setVisible(self._plan is not None and self._plan is not plan)

    def show_result(self, head: LazyText, result: AnglesResult, plan: Plan) -> None:
        """Show the result for a plan under a heading."""
        self._clear()
        self._plan, self._shown = plan, (head, result, plan)
        self.head.setText(str(head))
        columns = ANGLES_BY_ROW_TABLE.columns
        heads = [title_text(column.title) for column in columns]
        rows = [[cell_text(column, each) for column in columns] for each in result.rows]
        for row, (name, *cells) in enumerate([heads, *rows]):
            self._grid.addWidget(widgets.label(name, "muted"), row, 0)
            for column, (angle, cell) in enumerate(zip(heads[1:], cells, strict=True), start=1):
                shown = widgets.label(cell, "" if row else "muted")
                shown.setFont(theme.tabular_font(shown.font()))
                if row:
                    shown.setAccessibleName(f"{name}, {angle}")
                self._grid.addWidget(shown, row, column, Qt.AlignmentFlag.AlignRight)
        self.messages.setText("\n".join(result.summary_texts))
        self.hint.hide()
        for each in (self.head, self.messages):
            each.show()

    def copy_state_from(self, former: "AnglesTable") -> None:
        """Copy the result of another table."""
        if former._shown is not None:
            self.show_result(*former._shown)

    @property
    def cells(self) -> list[list[str]]:
        """Texts of the cells, row by row, with their titles."""
        found: dict[int, list[str]] = {}
        for k in range(self._grid.count()):
            row = self._grid.getItemPosition(k)[0]
            found.setdefault(row, []).append(self._grid.itemAt(k).widget().text())
        return [found[row] for row in sorted(found)]

    def _clear(self) -> None:
        while self._grid.count():
            widget = self._grid.takeAt(0).widget()
            widget.hide()
            widget.deleteLater()


MAX_SURVEYS = 5000
SIMULATION_HINT = N_(
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
        self.result_table = AnglesTable("surveys_result", gettext(SIMULATION_HINT))
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
        for each in (left, form, buttons):  # else the outer spacing applies
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
        self.start.set_reason(reason_text(first_reason((busy, Unavailable.BUSY))))
