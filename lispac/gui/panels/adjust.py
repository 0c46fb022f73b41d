"""Step 3: how many points, which model of the POS errors, and the adjustment."""

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QHBoxLayout,
    QProgressBar,
    QRadioButton,
    QWidget,
)

from lispac.adjustment.stochastic import PosErrors
from lispac.gui.panels import widgets
from lispac.gui.status import StepStatus
from lispac.gui.tasks import Task
from lispac.project import Project

DEBOUNCE_MS = 250
UNITS = (("cm", 100.0), ("m", 1.0))
MODELS: tuple[tuple[PosErrors, str, str], ...] = (
    (
        "correlated",
        "Correlated in time",
        "The POS error drifts slowly, so neighbouring points share it. For boards and other "
        "truly flat targets: more accurate, and sigmas that hold.",
    ),
    (
        "independent",
        "Independent for each point",
        "Every point has a POS error of its own, as in the thesis. Safer on rough natural "
        "surfaces, but the sigmas come out several times too small.",
    ),
)


class AdjustPanel(QWidget):
    """Settings of the adjustment and the button that starts it."""

    estimate_asked = Signal(float, str)
    """Subsampling distance in metres, model of the POS errors."""
    subsample_changed = Signal(float)
    """The distance rests: count the points it would keep."""
    cancel_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._metres = 0.10
        self._shown_settings: object = None
        layout = widgets.column(self)
        layout.addWidget(widgets.label("Distance between points kept", "heading"))
        layout.addLayout(self._distance_row())
        self.count = widgets.label("", "muted", wrap=True, name="point_count")
        layout.addWidget(self.count)
        layout.addWidget(widgets.label("POS errors", "heading"))
        self._models = QButtonGroup(self)
        for k, (model, title, sentence) in enumerate(MODELS):
            choice = QRadioButton(title)
            choice.setObjectName(f"model_{model}")
            choice.setAccessibleDescription(sentence)
            choice.setChecked(k == 0)
            self._models.addButton(choice, k)
            layout.addWidget(choice)
            row = QHBoxLayout()
            row.setContentsMargins(22, 0, 0, 4)
            row.addWidget(widgets.label(sentence, "muted", wrap=True))
            layout.addLayout(row)
        self.estimate = widgets.button(
            "Estimate boresight", "estimate", icon="calculator-variant-outline", primary=True,
            tip="Adjust boresight and planes together by least squares (F9)",
        )  # fmt: skip
        self.estimate.clicked.connect(self.ask)
        layout.addWidget(self.estimate)
        self._progress = QProgressBar()
        self._progress.setObjectName("estimate_progress")
        self._progress.setRange(0, 1000)
        self.cancel = widgets.button("Cancel", "cancel_estimate", tip="Stop; nothing is changed")
        self.cancel.clicked.connect(self.cancel_asked)
        running = QHBoxLayout()
        running.addWidget(self._progress, 1)
        running.addWidget(self.cancel)
        self._running = QWidget()
        self._running.setLayout(running)
        running.setContentsMargins(0, 0, 0, 0)
        self._running.hide()
        layout.addWidget(self._running)
        self.advice = widgets.label("", "muted", wrap=True, name="adjust_advice")
        layout.addWidget(self.advice)
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(DEBOUNCE_MS)
        self._rest.timeout.connect(lambda: self.subsample_changed.emit(self._metres))

    @property
    def subsample(self) -> float:
        """Metres."""
        return self._metres

    @property
    def pos_errors(self) -> PosErrors:
        """The chosen model."""
        return MODELS[self._models.checkedId()][0]

    def ask(self) -> None:
        """Ask for an adjustment with what is chosen."""
        if self.estimate.isEnabled():
            self._rest.stop()
            self.estimate_asked.emit(self._metres, self.pos_errors)

    def show_project(self, project: Project | None, status: StepStatus, busy: bool) -> None:
        """Fill in the project's settings where they changed."""
        self.estimate.allow(status.ready and not busy)
        self.advice.setText(status.advice)
        settings = None if project is None else project.settings
        if settings is None or settings == self._shown_settings:
            return
        self._shown_settings = settings
        self._metres = settings.subsample
        self._show_distance()
        for k, (model, _title, _sentence) in enumerate(MODELS):
            self._models.button(k).setChecked(model == settings.pos_errors)

    def show_count(self, kept: int | None, total: int, sightings: int) -> None:
        """The live count; None while it is being counted."""
        if not sightings:
            self.count.setText("No target yet, so no points to thin.")
        elif kept is None:
            self.count.setText(f"Counting … ({total:,} points in {sightings} sightings)")
        else:
            self.count.setText(
                f"<b>{kept:,}</b> of {total:,} points take part, in {sightings} sightings."
            )

    def show_task(self, task: Task | None) -> None:
        """Progress of the adjustment, where one runs."""
        self._running.setVisible(task is not None)
        if task is not None:
            self._progress.setValue(round(task.fraction * 1000))
            self.cancel.setEnabled(not task.cancel.is_set())

    def stop(self) -> None:
        """Stop the timer."""
        self._rest.stop()

    def _distance_row(self) -> QHBoxLayout:
        self.distance = widgets.number(
            "subsample", suffix="", decimals=1, low=0, high=1000, step=1,
            tip="Points of a sighting nearer to each other than this are thinned; 0 keeps all",
        )  # fmt: skip
        self.distance.setSpecialValueText("all points")
        self.distance.setMinimumWidth(110)
        self.unit = QComboBox()
        self.unit.setObjectName("subsample_unit")
        self.unit.addItems([unit for unit, _ in UNITS])
        self.unit.setToolTip("Unit of the distance")
        self._show_distance()
        self.distance.valueChanged.connect(self._distance_changed)
        self.unit.currentIndexChanged.connect(lambda: self._show_distance())
        row = QHBoxLayout()
        row.addWidget(self.distance)
        row.addWidget(self.unit)
        row.addStretch(1)
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
