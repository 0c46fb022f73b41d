"""The three angles of a patch test: a slider, a field and a search for each."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QGridLayout, QSlider, QWidget

from lispac.gui import units
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.patchtest.optimise import ANGLES

Array = NDArray[np.float64]

FINE = 0.001
"""Degrees of a step of the slider."""
FAR = 3.0
"""Degrees to either side of where it began that a slider reaches; a field takes any angle."""
NEAR = 0.3
"""The same once an angle was found: a pixel is then some thousandths."""
WORDS = ("Roll", "Pitch", "Yaw")


class PatchAngles(QWidget):
    """Three sliders with their fields; `turned` tells of each move."""

    turned = Signal(int)
    """An angle was turned: 0 roll, 1 pitch, 2 yaw."""
    find_asked = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self._start = np.zeros(3)
        self._boresight = np.zeros(3)
        self.sliders: list[QSlider] = []
        self.fields: list[widgets.NumberField] = []
        self.finds: list[widgets.Button] = []
        self.found = [
            widgets.label("", "muted", wrap=True, name=f"patch_{angle}_found") for angle in ANGLES
        ]
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(0)
        for k, angle in enumerate(ANGLES):
            slider = QSlider(Qt.Orientation.Horizontal)
            slider.setObjectName(f"patch_{angle}_slider")
            slider.setAccessibleName(say(f"Turn the {angle}"))
            slider.setToolTip(say("Drag, or arrows for 0.001° and Page up and down for 0.01°"))
            slider.setRange(-round(FAR / FINE), round(FAR / FINE))
            slider.setSingleStep(1)
            slider.setPageStep(10)
            slider.setMinimumWidth(70)
            field = widgets.number(
                f"patch_{angle}", suffix=" °", decimals=4, low=-360, high=360, step=FINE,
                tip=f"{WORDS[k]} with which the lines are placed in the pictures",
            )  # fmt: skip
            find = widgets.button(
                "Find this angle", f"patch_find_{angle}",
                tip=f"Turn the {angle} alone to where the mismatch of all ticked objects is "
                "smallest",
            )  # fmt: skip
            word = widgets.label(WORDS[k])
            word.setBuddy(field)
            grid.addWidget(word, 2 * k, 0)
            grid.addWidget(slider, 2 * k, 1)
            grid.addWidget(field, 2 * k, 2)
            grid.addWidget(find, 2 * k, 3)
            grid.addWidget(self.found[k], 2 * k + 1, 1, 1, 3)
            slider.valueChanged.connect(lambda value, k=k: self._slid(k, value))
            field.valueChanged.connect(lambda value, k=k: self._typed(k, value))
            find.clicked.connect(lambda _on, k=k: self.find_asked.emit(k))
            self.sliders.append(slider)
            self.fields.append(field)
            self.finds.append(find)
        grid.setColumnStretch(1, 1)

    @property
    def boresight(self) -> Array:
        """Roll, pitch and yaw as they are turned, shape (3,), radians."""
        return self._boresight.copy()

    def start_at(self, boresight: Array, reach: float = FAR) -> None:
        """Put the sliders' middles and all angles there; nobody is told.

        Parameters
        ----------
        reach : float, degrees
            Of the sliders, to either side.
        """
        self._start = np.array(boresight, dtype=float)
        for slider in self.sliders:
            slider.blockSignals(True)
            slider.setRange(-round(reach / FINE), round(reach / FINE))
            slider.blockSignals(False)
        self.turn_to(boresight)

    def turn_to(self, boresight: Array) -> None:
        """Set all angles; nobody is told."""
        self._boresight = np.array(boresight, dtype=float)
        for k in range(3):
            self._show(k)

    def show_found(
        self, boresight: Array | None, sigma: Array | None = None, curvature: Array | None = None
    ) -> None:
        """Write beside each angle what was found, its sigma where it has one, and what it costs.

        Parameters
        ----------
        curvature : ndarray of shape (3,), metres per radian
            By how much the lines part when an angle is turned away.
        """
        for k, label in enumerate(self.found):
            if boresight is None:
                label.setText("")
                continue
            value = units.figure(float(np.degrees(boresight[k])), "°", "+.4f")
            if sigma is None:
                words = f"found {value}°, no sigma"
            else:
                spread = units.figure(float(np.degrees(sigma[k])), "°", ".4f")
                words = f"found {value} ± {spread}°"
            told = [units.signs(say(words), "°")]
            if curvature is not None:
                parted = units.amount(1000 * float(np.radians(0.01) * curvature[k]), "mm", ".1f")
                told.append(say(f"0.01 deg error = {parted} misalignment"))
            label.setText("; ".join(told))

    def allow(self, allowed: bool) -> None:
        """Let the angles be searched for, or not; they can be turned in either case."""
        for find in self.finds:
            find.allow(allowed)

    def _slid(self, angle: int, steps: int) -> None:
        self._take(angle, float(self._start[angle] + np.radians(steps * FINE)))

    def _typed(self, angle: int, degrees: float) -> None:
        self._take(angle, float(np.radians(degrees)))

    def _take(self, angle: int, value: float) -> None:
        self._boresight[angle] = value
        self._show(angle)
        self.turned.emit(angle)

    def _show(self, angle: int) -> None:
        degrees = float(np.degrees(self._boresight[angle]))
        steps = round((degrees - float(np.degrees(self._start[angle]))) / FINE)
        for shown, value in ((self.fields[angle], degrees), (self.sliders[angle], steps)):
            if shown.hasFocus() and shown is self.fields[angle] and shown.value() == value:
                continue  # being typed into
            shown.blockSignals(True)
            shown.setValue(value)
            shown.blockSignals(False)
