"""Step 4: comparison of the lines on validation planes, and acceptance criteria."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QFormLayout, QHBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.validate.acceptance_form import AcceptanceForm
from lispac.gui.features.validate.acceptance_outcome import AcceptanceOutcome
from lispac.gui.project.status import VALIDATE, ProjectState
from lispac.gui.widgets.foldable_group import FoldableGroup
from lispac.gui.widgets.number_input import first_input_error
from lispac.gui.widgets.tab_order import set_tab_order
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.project import Project
from lispac.validation.comparison_results import PlaneComparison
from lispac.validation.local_models import (
    DEFAULT_MODEL,
    DEFAULT_NEIGHBOURS,
    MIN_POINTS_BY_KIND,
    Kind,
    LocalModel,
)

SURFACE_MODELS: tuple[tuple[Kind, str], ...] = (
    ("plane", N_("Local plane")), ("quadric", N_("Local quadric")), ("point", N_("Nearest point")),
)  # fmt: skip


class ValidatePanel(QWidget):
    """Options of the comparison, and choice of the lines shown: before or after."""

    validate_requested = Signal()
    shown_changed = Signal(str)
    """Boresight of the lines to show in the view: "prior" or "estimated"."""
    model_changed = Signal(object)
    """`LocalModel` of the surface to which distances are to be measured."""
    acceptance_edited = Signal(object)
    """Values of the changed acceptance criterion, by its name."""
    cause_requested = Signal(object)
    """The `Cause` of a failure to show."""

    def __init__(self) -> None:
        super().__init__()
        self._shown: tuple[PlaneComparison, ...] = ()
        layout = widgets.vertical_layout(self)
        self.kind = widgets.ChoiceBox(
            "distance_to", [gettext(title) for _, title in SURFACE_MODELS],
            gettext(
                "Model of the surface between the points of a line. Use a plane for walls and "
                "boards and a quadric for curved surfaces. Distances to the nearest point include "
                "the point spacing."
            ),
        )  # fmt: skip
        self.neighbours = widgets.number(
            "distance_neighbours", suffix="", decimals=0, low=3, high=200, step=1,
            tip=gettext(
                "Number of points that the plane or quadric is fitted to (default {plane:n}, "
                "quadric {quadric:n}). More points reduce the noise, fewer points follow the "
                "surface more closely.",
                plane=DEFAULT_NEIGHBOURS["plane"], quadric=DEFAULT_NEIGHBOURS["quadric"],
            ),
        )  # fmt: skip
        self.neighbours.setValue(DEFAULT_MODEL.neighbours)
        model = QWidget()
        form = QFormLayout(model)
        form.setContentsMargins(0, 0, 0, 0)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setHorizontalSpacing(10)
        form.setVerticalSpacing(6)
        form.addRow(gettext("Surface model"), self.kind)
        form.addRow(gettext("Points per fit"), self.neighbours)
        self.comparison = FoldableGroup(gettext("Comparison"), "fold_comparison", model)
        self.kind.currentIndexChanged.connect(self._on_kind_chosen)
        self.neighbours.valueChanged.connect(lambda _value: self._emit_model())
        self.run = widgets.button(
            gettext("Validate"), "validate", icon="check-decagram-outline", primary=True,
            tip=gettext(
                "Compare the lines, cloud to cloud, on all validation planes, which are not used "
                "in the adjustment, before and after (F10)"
            ),
        )  # fmt: skip
        self.run.clicked.connect(self.validate_requested)
        layout.addWidget(self.run)
        layout.addWidget(self.comparison)
        layout.addWidget(widgets.label(gettext("Lines in the view"), "heading"))
        self.before = widgets.button(
            gettext("Before"), "show_before", tip=gettext("Lines with the prior boresight")
        )
        self.after = widgets.button(
            gettext("After"), "show_after", tip=gettext("Lines with the estimated boresight")
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
        self.acceptance = AcceptanceForm()
        self.acceptance.edited.connect(self.acceptance_edited)
        layout.addWidget(self.acceptance)
        # Texts that change with the options and criteria are below all fields, which stay in place
        self.model_difference = widgets.label("", "warning", wrap=True, name="validate_other_model")
        self.model_difference.hide()
        layout.addWidget(self.model_difference)
        self.advice = widgets.label("", wrap=True, name="validate_advice")
        layout.addWidget(self.advice)
        self.outcome = AcceptanceOutcome()
        self.outcome.cause_requested.connect(self.cause_requested)
        layout.addWidget(self.outcome)
        self.messages = widgets.label("", wrap=True, name="validate_messages")
        self.messages.hide()
        layout.addWidget(self.messages)
        self._show_model()

    @property
    def model(self) -> LocalModel:
        """The chosen model of the surface."""
        return LocalModel(SURFACE_MODELS[self.kind.currentIndex()][0], int(self.neighbours.value()))

    def show_model_difference(self, text: str) -> None:
        """Show that the comparison was made with another surface model; "" if it was not."""
        self.model_difference.setText(text)
        self.model_difference.setVisible(bool(text))

    def show_messages(self, messages: Sequence[Message]) -> None:
        """Show the warnings and notes on the comparison among those of the project."""
        texts = [message_text(each) for each in messages if each.code.startswith("validation.")]
        self.messages.setText("\n\n".join(texts))
        self.messages.setVisible(bool(texts))

    def _on_kind_chosen(self) -> None:
        kind = SURFACE_MODELS[self.kind.currentIndex()][0]
        self._fill_neighbours(kind, DEFAULT_NEIGHBOURS[kind])
        self._emit_model()

    def _emit_model(self) -> None:
        self._show_model()
        self.model_changed.emit(self.model)

    def _show_model(self) -> None:
        """Show the model in the heading, since its fields are folded."""
        model = gettext(SURFACE_MODELS[self.kind.currentIndex()][1])
        if self.neighbours.isEnabled():
            model = gettext("{model}, {count:n} points", model=model, count=self.model.neighbours)
        self.comparison.set_summary(model)

    def _fill_neighbours(self, kind: Kind, number: int) -> None:
        self.neighbours.blockSignals(True)
        self.neighbours.setRange(MIN_POINTS_BY_KIND[kind], 200)
        self.neighbours.setValue(number)
        self.neighbours.setEnabled(kind != "point")
        self.neighbours.blockSignals(False)

    def _show_last_model(self, project: Project) -> None:
        """Show the model of the last validation, once for each validation."""
        if project.validation is self._shown:
            return
        self._shown = project.validation
        if project.validation:
            model = project.validation[0].model
            self.kind.blockSignals(True)
            self.kind.setCurrentIndex([kind for kind, _ in SURFACE_MODELS].index(model.kind))
            self.kind.blockSignals(False)
            self._fill_neighbours(model.kind, model.neighbours)
            self._show_model()
            # A radius given on the command line has no field; it is kept until a new choice.
            self.model_changed.emit(model)

    def show_state(self, state: ProjectState) -> None:
        """Show the last surface model and the next action; enable the controls usable now."""
        project, status = state.project, state.steps[VALIDATE]
        if project is not None:
            self._show_last_model(project)
        self.acceptance.show_project(project)
        self.outcome.show_project(
            project, first_input_error(self.acceptance), is_validating=state.is_validating
        )
        self.acceptance.show_results(self.outcome.values)
        # Later buttons would follow all other fields of the window
        set_tab_order(self.acceptance.source, self.outcome.buttons)
        self.advice.setText(status.advice)
        busy = first_reason((state.is_busy, Unavailable.BUSY))
        self.run.set_reason(reason_text(status.reason or busy))
        self.after.setEnabled(project is not None and project.result is not None)

    def show_before_after(self, *, before: bool, after: bool) -> None:
        """Show whether the view displays the lines before or after; neither for a split view."""
        group = self.before.group()
        group.setExclusive(False)  # else one button would stay checked
        self.before.setChecked(before)
        self.after.setChecked(after)
        group.setExclusive(True)
