"""Step 3: points, model, parameters to estimate, and the adjustment."""

from dataclasses import replace

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QButtonGroup,
    QCheckBox,
    QHBoxLayout,
    QProgressBar,
    QRadioButton,
    QToolTip,
    QWidget,
)

from lispac.adjustment.model.stochastic_model import PosErrors
from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.app.tasks import Task
from lispac.gui.app.unavailable import Unavailable, reason_text
from lispac.gui.features.estimate.adjust_model import ModelSettings
from lispac.gui.features.estimate.adjust_parameters import ParameterSwitches
from lispac.gui.project.status import ADJUST, ProjectState
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.foldable_group import FoldableGroup
from lispac.gui.widgets.number_input import require_accepted_texts, scroll_to
from lispac.gui.widgets.reserved_label import ReservedLabel
from lispac.language import N_, Plural, gettext
from lispac.messages import Message
from lispac.project import Project, Settings

DEBOUNCE_MS = 250
SPACING_UNITS = (("cm", 100.0), ("m", 1.0))
"""Units of the point spacing, with the number of units in a metre."""
POS_ERROR_MODELS: tuple[tuple[PosErrors, str, str], ...] = (
    (
        "correlated",
        N_("POS errors correlated in time"),
        N_(
            "The POS error drifts slowly, and neighbouring points share it. The standard "
            "deviations are realistic."
        ),
    ),
    (
        "independent",
        N_("Uncorrelated POS errors (classical)"),
        N_(
            "Each point has its own POS error. For comparison only: the standard deviations are "
            "several times too small."
        ),
    ),
)
POINT_COUNT_TEXT = Plural("{count:n} point", "{count:n} points")
SIGHTING_COUNT_TEXT = Plural("{count:n} sighting", "{count:n} sightings")


class AdjustPanel(QWidget):
    """Settings of the adjustment and the button that starts it."""

    settings_edited = Signal(object)
    """Settings with the value that was changed."""
    estimate_requested = Signal()
    subsample_changed = Signal(float)
    """New point spacing, metres; the points that it keeps are then counted."""
    cancel_requested = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._spacing = 0.10
        self._settings: Settings | None = None
        self._showing = False
        self._reason = Unavailable.NO_PROJECT.text
        self._project: Project | None = None
        self._counted: tuple[int | None, int, int, str] = (None, 0, 0, "")
        layout = widgets.vertical_layout(self)
        layout.setSpacing(6)
        layout.addLayout(self._distance_row())
        self.count = ReservedLabel("muted", "point_count", lines=2)
        self.count.setTextFormat(Qt.TextFormat.RichText)
        layout.addWidget(self.count)
        layout.addWidget(widgets.label(gettext("POS errors"), "heading"))
        self._models = QButtonGroup(self)
        for k, (model, title, description) in enumerate(POS_ERROR_MODELS):
            choice = QRadioButton(gettext(title))
            choice.setObjectName(f"model_{model}")
            choice.setAccessibleDescription(gettext(description))
            choice.setToolTip(gettext(description))
            choice.setChecked(k == 0)
            self._models.addButton(choice, k)
            layout.addWidget(choice)
        sentences = [gettext(sentence) for _model, _title, sentence in POS_ERROR_MODELS]
        self.model_sentence = ReservedLabel("muted", "model_sentence", texts=sentences)
        layout.addWidget(self.model_sentence)
        self.cross_check = QCheckBox(gettext("Cross-check with subsets of the data"))
        self.cross_check.setObjectName("cross_check")
        self.cross_check.setChecked(True)
        self.cross_check.setToolTip(
            gettext(
                "Repeat the adjustment with one line or one target omitted at a time, and with "
                "each half of the survey"
            )
        )
        layout.addWidget(self.cross_check)
        self.estimate = widgets.button(
            gettext("Estimate boresight"), "estimate", icon="calculator-variant-outline",
            primary=True,
            tip=gettext("Adjust boresight and targets together by least squares (F9)"),
        )  # fmt: skip
        self.estimate.clicked.connect(self._request_estimate)
        layout.addWidget(self.estimate)
        self.problem = widgets.label("", "error", wrap=True, name="adjust_problem")
        self.problem.hide()
        layout.addWidget(self.problem)
        self.show_field = widgets.button(
            gettext("Show the field"), "show_missing_field",
            tip=gettext("Scroll to the field that is not filled in and place the cursor in it"),
        )  # fmt: skip
        self.show_field.clicked.connect(self._show_missing_field)
        self.show_field.hide()
        layout.addWidget(self.show_field)
        layout.addWidget(self._progress_row())
        self.advice = widgets.label("", "muted", wrap=True, name="adjust_advice")
        layout.addWidget(self.advice)
        # Below the button, which stays in its place when they are unfolded
        self.parameters = ParameterSwitches()
        self.also = FoldableGroup(
            gettext("Additional parameters"), "fold_parameters", self.parameters
        )
        layout.addWidget(self.also)
        self.model = ModelSettings()
        self.advanced = FoldableGroup(gettext("Advanced"), "fold_advanced", self.model)
        layout.addWidget(self.advanced)
        self._debounce = QTimer(self)
        self._debounce.setSingleShot(True)
        self._debounce.setInterval(DEBOUNCE_MS)
        self._debounce.timeout.connect(lambda: self.subsample_changed.emit(self._spacing))
        self._models.idToggled.connect(lambda _id, on: self._emit_edit() if on else None)
        for each in (self.parameters, self.model):
            each.changed.connect(self._check_input)
            each.committed.connect(self._emit_edit)
        self._check_input()

    @property
    def subsample(self) -> float:
        """Point spacing, metres."""
        return self._spacing

    @property
    def pos_errors(self) -> PosErrors:
        """Chosen model of the POS errors."""
        return POS_ERROR_MODELS[self._models.checkedId()][0]

    @property
    def chosen_model(self) -> QAbstractButton:
        """The button of the chosen model."""
        return self._models.checkedButton()

    def settings(self) -> Settings | None:
        """Settings of the project with the values of the panel.

        Raises
        ------
        InputError
            If a typed value is not valid.
        """
        if self._settings is None:
            return None
        require_accepted_texts(self)
        chosen = replace(self._settings, subsample=self._spacing, pos_errors=self.pos_errors)
        chosen = self.model.with_chosen_values(self.parameters.with_chosen_values(chosen))
        chosen.require_sound()
        return chosen

    @property
    def input_error(self) -> Message | None:
        """Reason why the values of the panel cannot be used; None if they can."""
        try:
            self.settings()
        except InputError as failure:
            return failure.message
        return None

    def _request_estimate(self) -> None:
        self._debounce.stop()
        self.estimate_requested.emit()

    def _emit_edit(self) -> None:
        """Emit the settings if they are valid and were changed by the user."""
        self._check_input()
        if self._showing or not self.is_valid:
            return
        settings = self.settings()
        if settings is not None and settings != self._settings:
            self.settings_edited.emit(settings)

    def show_state(self, state: ProjectState) -> None:
        """Fill in the settings of the project if they have changed."""
        project, status = state.project, state.steps[ADJUST]
        self._reason, self._project = reason_text(state.estimate_reason), project
        self.advice.setText(status.advice)
        settings = None if project is None else project.settings
        if settings is not None and settings != self._settings:
            self._settings, self._showing = settings, True
            self._spacing = settings.subsample
            self._show_distance()
            for k, (model, _title, _sentence) in enumerate(POS_ERROR_MODELS):
                self._models.button(k).setChecked(model == settings.pos_errors)
            self.parameters.show_settings(settings)
            self.model.show_settings(settings)
            self._showing = False
        self._check_input()

    @property
    def is_valid(self) -> bool:
        """Whether all typed values are valid."""
        return self.problem.isHidden()

    def _check_input(self) -> None:
        """Show errors of the typed values, and the summaries of the folded groups."""
        self.model_sentence.setText(gettext(POS_ERROR_MODELS[self._models.checkedId()][2]))
        self.model.show_model(self.pos_errors)
        self.also.set_summary(self.parameters.summary)
        self.advanced.set_summary(self.model.summary)
        try:
            self.settings()
        except InputError as error:
            self._show_problem(exception_text(error))
        else:
            self.problem.setText("")
            self.problem.hide()
        self.show_field.setVisible(bool(self.model.missing_fields))
        self.estimate.set_reason(self._reason or self.problem.text())
        self._update_count()

    def _show_missing_field(self) -> None:
        """Unfold the group of the first missing field, scroll to it, and give it the focus."""
        field = self.model.missing_fields[0]
        self.advanced.open()
        field.setFocus(Qt.FocusReason.OtherFocusReason)
        QTimer.singleShot(0, field, lambda: scroll_to(field))

    def _show_problem(self, text: str) -> None:
        if text == self.problem.text():
            return
        hidden = self.problem.visibleRegion().isEmpty()
        self.problem.setText(text)
        self.problem.show()
        field = QApplication.focusWidget()
        if hidden and field is not None and self.isAncestorOf(field):
            # The label may be scrolled out of sight: show the text beside the field as well.
            QToolTip.showText(field.mapToGlobal(QPoint(0, field.height())), text, field)

    def show_count(self, kept: int | None, total: int, sightings: int, reason: str = "") -> None:
        """Show the number of points used, that they are being counted, or why they cannot be."""
        self._counted = (kept, total, sightings, reason)
        self._update_count()

    def _update_count(self) -> None:
        self.count.setText(self._count_text())

    def _count_text(self) -> str:
        """Rich text on the number of points of the sightings that are used."""
        kept, total, count, reason = self._counted
        if not count:
            return gettext("No targets yet: there are no points to adjust.")
        points, sightings = (
            gettext(POINT_COUNT_TEXT, count=total),
            gettext(SIGHTING_COUNT_TEXT, count=count),
        )
        if reason:  # also shown below the button
            return gettext(
                "{points} in {sightings} are not enough for an adjustment.",
                points=points, sightings=sightings,
            )  # fmt: skip
        if kept is None:
            return gettext(
                "Counting points ({points} in {sightings}) …", points=points, sightings=sightings
            )
        if (used := self._used_points()) is not None:
            return gettext(
                "Used in the adjustment: <b>{points}</b> in {sightings}.",
                points=gettext(POINT_COUNT_TEXT, count=used), sightings=sightings,
            )  # fmt: skip
        if kept == total:
            return gettext(
                "All points are used: <b>{points}</b> in {sightings}.",
                points=points, sightings=sightings,
            )  # fmt: skip
        # Approximate, since the adjustment selects the points again with the estimated boresight
        return gettext(
            "About <b>{kept:n}</b> of {points} in {sightings} are used.",
            kept=round(kept, 2 - len(str(kept))), points=points, sightings=sightings,
        )  # fmt: skip

    def _used_points(self) -> int | None:
        """Number of points of the result; None if there is no result with these settings."""
        if self._project is None or self._project.result is None:
            return None
        try:
            fits = self.settings() == self._project.settings
        except InputError:
            return None
        return self._project.result.points if fits else None

    def show_task(self, task: Task | None) -> None:
        """Show the progress of the adjustment; None if none runs."""
        self._running.setVisible(task is not None)
        if task is not None:
            self._progress.setValue(round(task.fraction * 1000))
            self.cancel.setEnabled(not task.cancel.is_set())

    def stop(self) -> None:
        """Stop the timer."""
        self._debounce.stop()

    def _progress_row(self) -> QWidget:
        self._progress = QProgressBar()
        self._progress.setObjectName("estimate_progress")
        self._progress.setRange(0, 1000)
        self.cancel = widgets.button(
            gettext("Cancel"), "cancel_estimate",
            tip=gettext("Stop the adjustment; the project stays unchanged"),
        )  # fmt: skip
        self.cancel.clicked.connect(self.cancel_requested)
        self._running = QWidget()
        running = QHBoxLayout(self._running)
        running.setContentsMargins(0, 0, 0, 0)
        running.addWidget(self._progress, 1)
        running.addWidget(self.cancel)
        self._running.hide()
        return self._running

    def _distance_row(self) -> QHBoxLayout:
        self.distance = widgets.number(
            "subsample", suffix="", decimals=1, low=0, high=1000, step=1,
            title=gettext("Point spacing"),
            tip=gettext(
                "Minimum spacing to which the points of each sighting are thinned; 0 uses all "
                "points"
            ),
        )  # fmt: skip
        self.distance.setSpecialValueText(gettext("all points"))
        self.distance.setMinimumWidth(84)
        self.unit = widgets.ChoiceBox(
            "subsample_unit",
            [unit for unit, _ in SPACING_UNITS],
            gettext("Unit of the point spacing"),
        )
        self._show_distance()
        self.distance.valueChanged.connect(self._on_distance_changed)
        self.distance.lineEdit().textChanged.connect(self._check_input)
        self.distance.committed.connect(self._emit_edit)
        self.unit.currentIndexChanged.connect(lambda: self._show_distance())
        row = QHBoxLayout()
        row.addWidget(widgets.label(gettext("Point spacing"), "heading", wrap=True), 1)
        row.addWidget(self.distance)
        row.addWidget(self.unit)
        return row

    def _show_distance(self) -> None:
        self.distance.unit, per_metre = SPACING_UNITS[self.unit.currentIndex()]
        self.distance.blockSignals(True)
        self.distance.setDecimals(1 if per_metre > 1 else 3)
        self.distance.setRange(0, 10 * per_metre)
        self.distance.setSingleStep(0.01 * per_metre)
        self.distance.setValue(self._spacing * per_metre)
        self.distance.blockSignals(False)

    def _on_distance_changed(self, value: float) -> None:
        self._spacing = value / SPACING_UNITS[self.unit.currentIndex()][1]
        self._debounce.start()
