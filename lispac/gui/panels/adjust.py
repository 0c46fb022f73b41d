"""Step 3: how many points, which model, which values to estimate, and the adjustment."""

from dataclasses import replace

from PySide6.QtCore import QPoint, QTimer, Signal
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

from lispac.adjustment.shown import counted
from lispac.adjustment.stochastic import PosErrors
from lispac.errors import InputError
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.adjust_model import ModelSettings
from lispac.gui.panels.adjust_parameters import ParameterSwitches
from lispac.gui.panels.fields import Fold
from lispac.gui.status import StepStatus
from lispac.gui.tasks import Task
from lispac.project import Project, Settings

DEBOUNCE_MS = 250
UNITS = (("cm", 100.0), ("m", 1.0))
MODELS: tuple[tuple[PosErrors, str, str], ...] = (
    (
        "correlated",
        "Correlated in time",
        "The POS error drifts slowly, so neighbouring points share it. The sigmas are realistic.",
    ),
    (
        "independent",
        "Uncorrelated POS errors (classical)",
        "Every point has a POS error of its own. For comparison only: the sigmas come out several "
        "times too small.",
    ),
)


class AdjustPanel(QWidget):
    """Settings of the adjustment and the button that starts it."""

    estimate_asked = Signal(object, bool)
    """Settings, whether to cross-check."""
    subsample_changed = Signal(float)
    """The distance rests: count the points it would keep."""
    cancel_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._metres = 0.10
        self._settings: Settings | None = None
        self._ready = False
        self._project: Project | None = None
        self._counted: tuple[int | None, int, int, str] = (None, 0, 0, "")
        layout = widgets.column(self)
        layout.setSpacing(6)
        layout.addLayout(self._distance_row())
        self.count = widgets.label("", "muted", wrap=True, name="point_count", rich=True)
        layout.addWidget(self.count)
        layout.addWidget(widgets.label("POS errors", "heading"))
        self._models = QButtonGroup(self)
        for k, (model, title, sentence) in enumerate(MODELS):
            choice = QRadioButton(say(title))
            choice.setObjectName(f"model_{model}")
            choice.setAccessibleDescription(say(sentence))
            choice.setToolTip(say(sentence))
            choice.setChecked(k == 0)
            self._models.addButton(choice, k)
            layout.addWidget(choice)
        self.model_sentence = widgets.label("", "muted", wrap=True, name="model_sentence")
        layout.addWidget(self.model_sentence)
        self.parameters = ParameterSwitches()
        self.also = Fold("Additional parameters", "fold_parameters", self.parameters)
        layout.addWidget(self.also)
        self.model = ModelSettings()
        self.advanced = Fold("Advanced", "fold_advanced", self.model)
        layout.addWidget(self.advanced)
        self.cross_check = QCheckBox(say("Cross-check with parts of the data"))
        self.cross_check.setObjectName("cross_check")
        self.cross_check.setChecked(True)
        self.cross_check.setToolTip(
            say(
                "Adjust again without each line and each target, and each half of the "
                "survey by itself"
            )
        )
        layout.addWidget(self.cross_check)
        self.problem = widgets.label("", "error", wrap=True, name="adjust_problem")
        self.problem.hide()
        layout.addWidget(self.problem)
        self.estimate = widgets.button(
            "Estimate boresight", "estimate", icon="calculator-variant-outline", primary=True,
            tip="Adjust boresight and targets together by least squares (F9)",
        )  # fmt: skip
        self.estimate.clicked.connect(self.ask)
        layout.addWidget(self.estimate)
        layout.addWidget(self._running_row())
        self.advice = widgets.label("", "muted", wrap=True, name="adjust_advice")
        layout.addWidget(self.advice)
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(DEBOUNCE_MS)
        self._rest.timeout.connect(lambda: self.subsample_changed.emit(self._metres))
        self._models.idToggled.connect(lambda _id, on: self._check() if on else None)
        self.parameters.changed.connect(self._check)
        self.model.changed.connect(self._check)
        self._check()

    @property
    def subsample(self) -> float:
        """Metres."""
        return self._metres

    @property
    def pos_errors(self) -> PosErrors:
        """The chosen model."""
        return MODELS[self._models.checkedId()][0]

    @property
    def chosen_model(self) -> QAbstractButton:
        """The button of the chosen model."""
        return self._models.checkedButton()

    def settings(self) -> Settings | None:
        """The project's settings with what is chosen here.

        Raises
        ------
        InputError
            Where something typed makes no sense.
        """
        if self._settings is None:
            return None
        chosen = replace(self._settings, subsample=self._metres, pos_errors=self.pos_errors)
        chosen = self.model.settings_of(self.parameters.settings_of(chosen))
        chosen.require_sound()
        return chosen

    def ask(self) -> None:
        """Ask for an adjustment with what is chosen."""
        if self.estimate.isEnabled():
            self._rest.stop()
            self.estimate_asked.emit(self.settings(), self.cross_check.isChecked())

    def show_project(self, project: Project | None, status: StepStatus, busy: bool) -> None:
        """Fill in the project's settings where they changed."""
        self._ready, self._project = status.ready and not busy, project
        self.advice.setText(say(status.advice))
        settings = None if project is None else project.settings
        if settings is not None and settings != self._settings:
            self._settings = settings
            self._metres = settings.subsample
            self._show_distance()
            for k, (model, _title, _sentence) in enumerate(MODELS):
                self._models.button(k).setChecked(model == settings.pos_errors)
            self.parameters.show_settings(settings)
            self.model.show_settings(settings)
        self._check()

    @property
    def sound(self) -> bool:
        """Whether everything typed makes sense."""
        return self.problem.isHidden()

    def _check(self) -> None:
        """Say what is wrong with what is typed, and what is folded away."""
        self.model_sentence.setText(say(MODELS[self._models.checkedId()][2]))
        self.model.show_model(self.pos_errors)
        self.also.set_summary(self.parameters.summary)
        self.advanced.set_summary(self.model.summary)
        try:
            self.settings()
        except InputError as error:
            self._tell(str(error))
        else:
            self.problem.setText("")
            self.problem.hide()
        self.estimate.allow(self._ready and self.sound)
        self._say_count()

    def _tell(self, sentence: str) -> None:
        if say(sentence) == self.problem.text():
            return
        hidden = self.problem.visibleRegion().isEmpty()
        self.problem.setText(say(sentence))
        self.problem.show()
        field = QApplication.focusWidget()
        if hidden and field is not None and self.isAncestorOf(field):
            # The label may be scrolled out of sight; the sentence is wanted where one types.
            QToolTip.showText(field.mapToGlobal(QPoint(0, field.height())), say(sentence), field)

    def show_count(self, kept: int | None, total: int, sightings: int, reason: str = "") -> None:
        """The live count; None while it is being counted, or where ``reason`` says why not."""
        self._counted = (kept, total, sightings, reason)
        self._say_count()

    def _say_count(self) -> None:
        kept, total, sightings, reason = self._counted
        seen = counted(sightings, "sighting")
        if not sightings:
            self.count.setText(say("No target yet, so no points to thin."))
        elif reason:  # said below the button, too
            self.count.setText(say(f"{counted(total, 'point')} in {seen}: not enough to adjust."))
        elif kept is None:
            self.count.setText(say(f"Counting … ({counted(total, 'point')} in {seen})"))
        elif (took := self._took_part()) is not None:
            self.count.setText(say(f"<b>{counted(took, 'point')}</b> took part, in {seen}."))
        elif kept == total:
            self.count.setText(say(f"<b>All {total:,}</b> points take part, in {seen}."))
        else:  # about: Estimate selects the points again with the boresight found
            near = round(kept, 2 - len(str(kept)))
            self.count.setText(
                say(f"About <b>{near:,}</b> of {total:,} points take part, in {seen}.")
            )

    def _took_part(self) -> int | None:
        """Points of the project's result; None where there is none for what is chosen."""
        if self._project is None or self._project.result is None:
            return None
        try:
            fits = self.settings() == self._project.settings
        except InputError:
            return None
        return self._project.result.points if fits else None

    def show_task(self, task: Task | None) -> None:
        """Progress of the adjustment, where one runs."""
        self._running.setVisible(task is not None)
        if task is not None:
            self._progress.setValue(round(task.fraction * 1000))
            self.cancel.setEnabled(not task.cancel.is_set())

    def stop(self) -> None:
        """Stop the timer."""
        self._rest.stop()

    def _running_row(self) -> QWidget:
        self._progress = QProgressBar()
        self._progress.setObjectName("estimate_progress")
        self._progress.setRange(0, 1000)
        self.cancel = widgets.button("Cancel", "cancel_estimate", tip="Stop; nothing is changed")
        self.cancel.clicked.connect(self.cancel_asked)
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
            tip="Points of a sighting nearer to each other than this are thinned; 0 keeps all",
        )  # fmt: skip
        self.distance.setSpecialValueText(say("all points"))
        self.distance.setMinimumWidth(84)
        self.unit = widgets.Choice(
            "subsample_unit", [unit for unit, _ in UNITS], "Unit of the distance"
        )
        self._show_distance()
        self.distance.valueChanged.connect(self._distance_changed)
        self.unit.currentIndexChanged.connect(lambda: self._show_distance())
        row = QHBoxLayout()
        row.addWidget(widgets.label("Point spacing", "heading"))
        row.addStretch(1)
        row.addWidget(self.distance)
        row.addWidget(self.unit)
        return row

    def _show_distance(self) -> None:
        _, per_metre = UNITS[self.unit.currentIndex()]
        self.distance.blockSignals(True)
        self.distance.setDecimals(1 if per_metre > 1 else 3)
        self.distance.setRange(0, 10 * per_metre)
        self.distance.setSingleStep(0.01 * per_metre)
        self.distance.setValue(self._metres * per_metre)
        self.distance.blockSignals(False)

    def _distance_changed(self, value: float) -> None:
        self._metres = value / UNITS[self.unit.currentIndex()][1]
        self._rest.start()
