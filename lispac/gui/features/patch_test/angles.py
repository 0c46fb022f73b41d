"""The three angles of a patch test: a slider, a field and a search button for each."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QGridLayout, QSlider, QWidget

from lispac.gui import widgets
from lispac.gui.widgets.elided_label import ElidedLabel
from lispac.gui.widgets.number_field import NumberField
from lispac.gui.widgets.result_tables import local_amount
from lispac.language import N_, gettext, join_items
from lispac.patchtest.mismatch_minimisation import ANGLE_NAMES
from lispac.present.calibration.adjustment import SHORT_ANGLE_SIGNS
from lispac.present.calibration.patch_test import PatchTestValues
from lispac.present.tables import DEGREES, MILLIMETRES

Array = NDArray[np.float64]

SLIDER_STEP_DEG = 0.001
"""Step of a slider, degrees."""
SLIDER_RANGE_DEG = 3.0
"""Range of a slider to either side of its start, degrees; a field accepts any angle."""
RESULT_RANGE_DEG = 0.3
"""Range of a slider after a search, degrees; a pixel is then a few thousandths of a degree."""
ANGLE_TITLES = (N_("Roll"), N_("Pitch"), N_("Yaw"))
_SLIDER_NAMES = (N_("Change the roll"), N_("Change the pitch"), N_("Change the yaw"))
_FIELD_TIPS = (
    N_("Boresight roll that is applied to the lines in the pictures"),
    N_("Boresight pitch that is applied to the lines in the pictures"),
    N_("Boresight yaw that is applied to the lines in the pictures"),
)
_SEARCH_TIPS = (
    N_("Find the roll at which the mismatch of the ticked objects is smallest"),
    N_("Find the pitch at which the mismatch of the ticked objects is smallest"),
    N_("Find the yaw at which the mismatch of the ticked objects is smallest"),
)


class PatchAngles(QWidget):
    """Sliders and fields of three angles; emits `angle_changed` when the user changes one."""

    angle_changed = Signal(int)
    """An angle was changed: 0 roll, 1 pitch, 2 yaw."""
    find_requested = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self._start = np.zeros(3)
        self._boresight = np.zeros(3)
        self.sliders: list[QSlider] = []
        self.fields: list[NumberField] = []
        self.find_buttons: list[widgets.Button] = []
        self.result_labels = [ElidedLabel() for _ in ANGLE_NAMES]
        for angle, label in zip(ANGLE_NAMES, self.result_labels, strict=True):
            label.setObjectName(f"patch_{angle}_found")
            label.setProperty("role", "muted")
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(0)
        for k, angle in enumerate(ANGLE_NAMES):
            slider = QSlider(Qt.Orientation.Horizontal)
            slider.setObjectName(f"patch_{angle}_slider")
            slider.setAccessibleName(gettext(_SLIDER_NAMES[k]))
            slider.setToolTip(
                gettext("Drag, or use the arrow keys (0.001°) or Page Up and Page Down (0.01°)")
            )
            slider.setRange(
                -round(SLIDER_RANGE_DEG / SLIDER_STEP_DEG),
                round(SLIDER_RANGE_DEG / SLIDER_STEP_DEG),
            )
            slider.setSingleStep(1)
            slider.setPageStep(10)
            slider.setMinimumWidth(70)
            field = widgets.number(
                f"patch_{angle}", suffix=" °", decimals=4, low=-360, high=360, step=SLIDER_STEP_DEG,
                tip=gettext(_FIELD_TIPS[k]),
            )  # fmt: skip
            find = widgets.button(
                gettext("Find this angle"), f"patch_find_{angle}", tip=gettext(_SEARCH_TIPS[k])
            )  # fmt: skip
            title = widgets.label(gettext(ANGLE_TITLES[k]))
            title.setBuddy(field)
            grid.addWidget(title, 2 * k, 0)
            grid.addWidget(slider, 2 * k, 1)
            grid.addWidget(field, 2 * k, 2)
            grid.addWidget(find, 2 * k, 3)
            grid.addWidget(self.result_labels[k], 2 * k + 1, 0, 1, 4)
            slider.valueChanged.connect(lambda value, k=k: self._on_slider_moved(k, value))
            field.valueChanged.connect(lambda value, k=k: self._on_typed(k, value))
            find.clicked.connect(lambda _on, k=k: self.find_requested.emit(k))
            self.sliders.append(slider)
            self.fields.append(field)
            self.find_buttons.append(find)
        grid.setColumnStretch(1, 1)

    @property
    def boresight(self) -> Array:
        """Roll, pitch and yaw as set, shape (3,), radians."""
        return self._boresight.copy()

    def set_start(self, boresight: Array, reach: float = SLIDER_RANGE_DEG) -> None:
        """Set all angles and centre the sliders on them, without emitting a signal.

        Parameters
        ----------
        reach : float, degrees
            Range of the sliders to either side.
        """
        self._start = np.array(boresight, dtype=float)
        for slider in self.sliders:
            slider.blockSignals(True)
            slider.setRange(-round(reach / SLIDER_STEP_DEG), round(reach / SLIDER_STEP_DEG))
            slider.blockSignals(False)
        self.set_angles(boresight)

    def copy_state_from(self, former: "PatchAngles") -> None:
        """Copy the angles and the ranges of the sliders of a former window."""
        self.set_start(former._start, former.sliders[0].maximum() * SLIDER_STEP_DEG)
        self.set_angles(former._boresight)

    def set_angles(self, boresight: Array) -> None:
        """Set all angles without emitting a signal."""
        self._boresight = np.array(boresight, dtype=float)
        for k in range(3):
            self._show_angle(k)

    def show_found(self, values: PatchTestValues | None) -> None:
        """Show angles found, their standard deviations, effects on the lines and signs."""
        for name, label, sign in zip(
            ANGLE_NAMES, self.result_labels, map(gettext, SHORT_ANGLE_SIGNS), strict=True
        ):
            if values is None:
                label.setText(sign)
                label.setToolTip("")
                continue
            angle = local_amount(getattr(values.boresight_deg, name), DEGREES.signed)
            if values.sigma_deg is None:
                text = gettext("result {angle}, no standard deviation", angle=angle)
            else:
                sigma = local_amount(getattr(values.sigma_deg, name), DEGREES)
                text = gettext("result {angle} ± {sigma} (1 σ)", angle=angle, sigma=sigma)
            distance = local_amount(getattr(values.misalignment_m, name), MILLIMETRES)
            effect = gettext("0.01° = {distance}", distance=distance)
            label.setText(join_items((text, effect, sign)))
            label.setToolTip(
                gettext(
                    "{result}. An error of 0.01° in this angle misaligns the lines by {distance} "
                    "on the objects.",
                    result=text,
                    distance=distance,
                )
            )

    def set_reason(self, reason: str) -> None:
        """Disable the search buttons with the reason in their tips; an empty text enables them."""
        for find in self.find_buttons:
            find.set_reason(reason)

    def _on_slider_moved(self, angle: int, steps: int) -> None:
        self._set_angle(angle, float(self._start[angle] + np.radians(steps * SLIDER_STEP_DEG)))

    def _on_typed(self, angle: int, degrees: float) -> None:
        self._set_angle(angle, float(np.radians(degrees)))

    def _set_angle(self, angle: int, value: float) -> None:
        self._boresight[angle] = value
        self._show_angle(angle)
        self.angle_changed.emit(angle)

    def _show_angle(self, angle: int) -> None:
        degrees = float(np.degrees(self._boresight[angle]))
        steps = round((degrees - float(np.degrees(self._start[angle]))) / SLIDER_STEP_DEG)
        for shown, value in ((self.fields[angle], degrees), (self.sliders[angle], steps)):
            if shown.hasFocus() and shown is self.fields[angle] and shown.value() == value:
                continue  # the user is typing in it
            shown.blockSignals(True)
            shown.setValue(value)
            shown.blockSignals(False)
