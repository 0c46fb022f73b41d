"""Panel of the search for the best plan: limits, criterion and result."""

from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QScrollArea, QVBoxLayout, QWidget

from lispac.design.objective import CRITERIA, PlanObjective
from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.features.design.limits_form import LimitsForm
from lispac.gui.features.design.predicted_precision import sigma_text
from lispac.gui.features.design.workspace import Workspace
from lispac.gui.window.window_state import copy_fields
from lispac.language import N_, LazyText, gettext

FACTORS = {
    N_("POS errors as specified"): (1.0,),
    N_("0.5, 1 and 2 times the specified POS errors"): (0.5, 1.0, 2.0),
}


class SearchPanel(QScrollArea):
    """Form of the search, which emits the request of the user."""

    requested = Signal()
    cancel_requested = Signal()
    file_requested = Signal()

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.setObjectName("design_search")
        self.setWidgetResizable(True)
        self._work, self._busy = workspace, False
        self._found: LazyText | None = None
        self.limits = LimitsForm()
        self.criterion = widgets.ChoiceBox(
            "search_criterion",
            list(map(gettext, CRITERIA.values())),
            gettext("Quantity that the search minimises"),
        )
        self.factors = widgets.ChoiceBox(
            "search_factors",
            list(map(gettext, FACTORS)),
            gettext(
                "POS errors assumed in the search. If there are several levels, the mean "
                "result is minimised."
            ),
        )
        for choice in (self.criterion, self.factors):
            choice.setAccessibleName(choice.toolTip())
        self.plans = widgets.number(
            "search_plans", suffix="", decimals=0, low=100, high=1_000_000, step=1000,
            tip=gettext(
                "Approximate number of survey plans to evaluate, {low:n} to {high:n}. If fewer "
                "plans are possible, all are evaluated.", low=100, high=1_000_000,
            ),
        )  # fmt: skip
        self.plans.setValue(5000)
        self.plans.setGroupSeparatorShown(True)
        self.read = widgets.button(
            gettext("Open site file…"), "search_file", icon="folder-open-outline",
            tip=gettext("Read the wall, the survey system, the limits and the existing targets "
                        "from a site file"),
        )  # fmt: skip
        self.clear_file = widgets.button(
            gettext("Close site file"),
            "search_no_file",
            tip=gettext(
                "Use the wall and the survey system of the survey plan instead of those "
                "of the site file"
            ),
        )
        self.find = widgets.button(
            gettext("Find the best plan"), "search_find", primary=True,
            tip=gettext("Search in the background and replace this plan with the best one. Undo "
                        "restores this plan."),
        )  # fmt: skip
        self.cancel = widgets.button(
            gettext("Cancel"),
            "search_cancel",
            tip=gettext("Stop the search without changing the survey plan"),
        )
        self.about_file = widgets.label("", "muted", wrap=True, name="search_about_file")
        self.message_label = widgets.label("", "hint", wrap=True, name="search_message")
        self.message_label.hide()
        self.error_label = widgets.label("", "error", wrap=True, name="search_mistake")
        body = QWidget()
        left, right = QVBoxLayout(), QVBoxLayout()
        left.addWidget(self.limits)
        left.addStretch(1)
        form = QFormLayout()
        form.addRow(gettext("Quantity to minimise"), self.criterion)
        form.addRow(gettext("POS errors"), self.factors)
        form.addRow(gettext("Plans to evaluate"), self.plans)
        files = QHBoxLayout()
        files.addWidget(self.read)
        files.addWidget(self.clear_file)
        files.addStretch(1)
        buttons = QHBoxLayout()
        buttons.addWidget(self.find)
        buttons.addWidget(self.cancel)
        buttons.addStretch(1)
        right.addLayout(buttons)
        right.addWidget(self.error_label)
        right.addWidget(self.message_label)
        right.addLayout(form)
        right.addLayout(files)
        right.addWidget(self.about_file)
        right.addStretch(1)
        both = QHBoxLayout(body)
        both.setSpacing(20)
        for each in (left, right, form, files, buttons):  # else they take that of the whole
            each.setSpacing(theme.SPACING)
        both.addLayout(left, 1)
        both.addLayout(right, 1)
        self.setWidget(body)
        self.read.clicked.connect(lambda: self.file_requested.emit())
        self.clear_file.clicked.connect(self.limits.use_form)
        self.find.clicked.connect(lambda: self.requested.emit())
        self.cancel.clicked.connect(lambda: self.cancel_requested.emit())
        self.limits.changed.connect(self._check_limits)
        workspace.changed.connect(self._check_limits)
        self._check_limits()

    @property
    def objective(self) -> PlanObjective:
        """Objective of the search."""
        factors = list(FACTORS.values())[self.factors.currentIndex()]
        return PlanObjective(list(CRITERIA)[self.criterion.currentIndex()], factors)

    def show_found(self, result_text: LazyText | None) -> None:
        """Show the result of a search; None where there is none."""
        self._found = result_text
        self.message_label.setText("" if result_text is None else str(result_text))
        self.message_label.setVisible(result_text is not None)

    def copy_state_from(self, former: "SearchPanel") -> None:
        """Copy the choices and the result of another panel."""
        copy_fields(former, self)
        self.limits.copy_state_from(former.limits)
        self.show_found(former._found)

    def show_busy(self, busy: bool) -> None:
        """Enable or disable the controls while a task runs."""
        self._busy = busy
        self.cancel.setEnabled(busy)
        self._check_limits()

    def _check_limits(self) -> None:
        mistake = self.limits.input_error(self._work.titled)
        self.error_label.setText(mistake)
        self.error_label.setVisible(bool(mistake))
        self.about_file.setText(self.limits.file_text)
        self.clear_file.setEnabled(self.limits.has_file)
        self.find.update_enabled(not mistake and not self._busy)


@dataclass(frozen=True)
class SearchResult:
    """Result of a search, converted to text in the language in use.

    Attributes
    ----------
    value : float, degrees
        Of the objective.
    evaluated : int
        Number of plans.
    all_evaluated : bool
        Whether there are no others.
    """

    value: float
    objective: PlanObjective
    evaluated: int
    all_evaluated: bool

    def __str__(self) -> str:
        """The text in the language and the unit in use."""
        criterion = gettext(CRITERIA[self.objective.criterion])
        unit = units.shown_unit("°").sign
        value = sigma_text(self.value) + (unit if unit in "°′″" else f" {unit}")
        if self.all_evaluated:
            return gettext(
                "The best of all {count:n} possible plans replaces the former plan ({criterion}: "
                "{value}). Undo restores the former plan.",
                criterion=criterion, value=value, count=self.evaluated,
            )  # fmt: skip
        return gettext(
            "The best of {count:n} evaluated plans replaces the former plan ({criterion}: "
            "{value}). Not all possible plans were evaluated. Undo restores the former plan.",
            criterion=criterion, value=value, count=self.evaluated,
        )  # fmt: skip
