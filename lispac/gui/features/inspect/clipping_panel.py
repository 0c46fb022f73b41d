"""Panel of the clip box."""

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.viewport.clipping import MIN_SIDE_M, Box
from lispac.language import N_, gettext

TITLE = N_("Clip box")
HINT = N_(
    "Only points inside the box are drawn, picked and measured. Drag the handles on its sides, or "
    "enter its lengths."
)
NO_BOX_TEXT = "–"
"""Text shown instead of the lengths while there is no box."""
LENGTH_FIELDS = (
    ("depth", N_("Depth"), N_("Length of the box perpendicular to the target")),
    ("width", N_("Width"), N_("Length of the box along the target")),
    ("height", N_("Height"), N_("Height of the box")),
)
"""Key, title and tooltip of each field."""


class ClippingPanel(QWidget):
    """The three lengths of the box, and buttons that place and remove it."""

    lengths_changed = Signal(object)
    """Lengths, ndarray of shape (3,), metres."""
    fit_requested = Signal()
    reset_requested = Signal()

    def __init__(self) -> None:
        super().__init__()
        column = widgets.vertical_layout(self)
        column.setContentsMargins(12, 4, 12, 4)
        column.addWidget(widgets.label(gettext(HINT), "muted", wrap=True))
        lengths = QHBoxLayout()
        self.fields = []
        for key, title, tip in LENGTH_FIELDS:
            field = widgets.number(
                f"clip_{key}", suffix=" m", decimals=2, low=MIN_SIDE_M, high=10_000,
                step=0.1, tip=gettext(tip),
            )  # fmt: skip
            field.setFixedWidth(130)
            field.setKeyboardTracking(False)
            field.valueChanged.connect(lambda _value: self.lengths_changed.emit(self.lengths))
            self.fields.append(field)
            title_label = widgets.label(gettext(title))
            title_label.setBuddy(field)
            lengths.addWidget(title_label)
            lengths.addWidget(field)
            lengths.addSpacing(8)
        lengths.addStretch(1)
        column.addLayout(lengths)
        row = QHBoxLayout()
        self.about = widgets.button(
            gettext("Place around selection"), "clip_about",
            tip=gettext("Place the box around the selected target"),
        )  # fmt: skip
        self.reset = widgets.button(
            gettext("Reset"), "clip_reset", tip=gettext("Remove the box and show all points")
        )
        self.about.clicked.connect(lambda _on: self.fit_requested.emit())
        self.reset.clicked.connect(lambda _on: self.reset_requested.emit())
        row.addWidget(self.about)
        row.addWidget(self.reset)
        row.addStretch(1)
        column.addLayout(row)
        column.addStretch(1)
        self.show_box(None)

    @property
    def lengths(self) -> np.ndarray:
        """Lengths of the box, shape (3,), metres."""
        return np.array([field.value() for field in self.fields])

    def show_box(self, box: Box | None) -> None:
        """Show the lengths of the box without emitting a signal."""
        for k, field in enumerate(self.fields):
            field.setEnabled(box is not None)
            field.setSpecialValueText("" if box is not None else NO_BOX_TEXT)
            field.blockSignals(True)
            field.setValue(MIN_SIDE_M if box is None else 2.0 * float(box.half[k]))
            field.blockSignals(False)
        self.reset.setEnabled(box is not None)
