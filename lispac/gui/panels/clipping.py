"""Lengths of the clip box."""

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QWidget

from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.viewport.clipping import SMALLEST, Box

TITLE = "Clip box"
HINT = (
    "Only what lies in the box is drawn, picked and measured. Drag the dots on its sides, or type "
    "its lengths."
)
NO_BOX = "–"
"""What stands for the lengths of none."""
LENGTHS = (
    ("Depth", "Length of the box across the target, metres"),
    ("Width", "Length of the box along the target, metres"),
    ("Height", "Height of the box, metres"),
)


class ClippingPanel(QWidget):
    """Three lengths, about what, and back to everything."""

    sized = Signal(object)
    """Lengths, ndarray of shape (3,), metres."""
    about_asked = Signal()
    reset_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        column = widgets.column(self)
        column.addWidget(widgets.label(HINT, "muted", wrap=True))
        form = QFormLayout()
        self.fields = []
        for word, tip in LENGTHS:
            field = widgets.number(
                f"clip_{word.lower()}", suffix=" m", decimals=2, low=SMALLEST, high=10_000,
                step=0.1, tip=tip,
            )  # fmt: skip
            field.setFixedWidth(130)
            field.setKeyboardTracking(False)
            field.valueChanged.connect(lambda _value: self.sized.emit(self.lengths))
            self.fields.append(field)
            form.addRow(say(word), field)
        column.addLayout(form)
        row = QHBoxLayout()
        self.about = widgets.button(
            "About the selection", "clip_about", tip="Lay the box about the selected target"
        )
        self.reset = widgets.button("Reset", "clip_reset", tip="Draw everything again")
        self.about.clicked.connect(lambda _on: self.about_asked.emit())
        self.reset.clicked.connect(lambda _on: self.reset_asked.emit())
        row.addWidget(self.about)
        row.addWidget(self.reset)
        row.addStretch(1)
        column.addLayout(row)
        column.addStretch(1)
        self.show_box(None)

    @property
    def lengths(self) -> np.ndarray:
        """Shape (3,), metres."""
        return np.array([field.value() for field in self.fields])

    def show_box(self, box: Box | None) -> None:
        """Show its lengths, without telling anyone."""
        for k, field in enumerate(self.fields):
            field.setEnabled(box is not None)
            field.setSpecialValueText("" if box is not None else NO_BOX)
            field.blockSignals(True)
            field.setValue(SMALLEST if box is None else 2.0 * float(box.half[k]))
            field.blockSignals(False)
        self.reset.setEnabled(box is not None)
