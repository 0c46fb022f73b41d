"""Dialogue to check the signs of roll and pitch against the known motion of the vessel."""

from dataclasses import replace
from typing import TYPE_CHECKING, Literal

import numpy as np
from PySide6.QtWidgets import QCheckBox, QDialog, QDialogButtonBox, QHBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.chart import Chart
from lispac.gui.widgets.plot_zoom import PlotZoom
from lispac.language import N_, gettext
from lispac.workflow.project.attitude_signs import SignedAngle

if TYPE_CHECKING:
    from lispac.gui.features.open_project.import_survey.quality_figures import AttitudeRecord

TITLE = N_("Signs of roll and pitch")
EXPECTED_TEXT = N_(
    "While the vessel heels to starboard, roll must be positive. While the bow rises, pitch must "
    "be positive."
)
ADJUSTMENT_TEXT = N_(
    "The adjustment with cross-checks also tests the signs: it compares the residuals with those "
    "of the opposite signs. The result is in Messages."
)
CORRECTIONS = {
    "import": N_(
        "Compare the curves with a turn or a wave that you know. If a curve is reversed, choose "
        "the other sign under Reading options."
    ),
    "project": N_(
        "Compare the curves with a turn or a wave that you know. If a curve is reversed, tick it "
        "below the curves and press Change the signs."
    ),
    "new project": N_(
        "Compare the curves with a turn or a wave that you know. If a curve is reversed, create "
        "the project again (File > New project) with the same files: select the trajectory in the "
        "list and choose the other sign under Reading options. The signs of this project cannot "
        "be changed, because the points of its georeferenced lines were computed with them."
    ),
}
"""What to do if a sign is wrong, by the place where the dialogue is opened; "new project" if a
project does not permit the correction."""
REVERSAL_TITLES: dict[SignedAngle, str] = {
    "roll": N_("Roll is reversed"),
    "pitch": N_("Pitch is reversed"),
}
REVERSAL_TIP = N_("Turns the curve around, as it would be with the other sign")
COLUMNS: dict[SignedAngle, int] = {"roll": 0, "pitch": 1}
"""Columns of `AttitudeRecord.attitude`."""
WIDTH_PX, HEIGHT_PX = 900, 620


class SignCheckDialog(QDialog):
    """Dialogue with the curves of roll, pitch and heading and the signs they must have.

    It is accepted if the user changes signs of the project.

    Parameters
    ----------
    place : where the dialogue is opened: "import" or "project"
    reversible : angles whose signs can be changed in the project
    """

    def __init__(
        self,
        record: "AttitudeRecord",
        place: Literal["import", "project"],
        parent: QWidget | None = None,
        reversible: tuple[SignedAngle, ...] = (),
    ) -> None:
        super().__init__(parent)
        self.setObjectName("sign_check_dialog")
        self.setWindowTitle(gettext(TITLE))
        self._record = record
        self.reversals: dict[SignedAngle, QCheckBox] = {}
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(widgets.label(gettext(EXPECTED_TEXT), "heading", wrap=True))
        correction = "new project" if place == "project" and not reversible else place
        layout.addWidget(widgets.label(gettext(CORRECTIONS[correction]), wrap=True))
        self.canvas = Chart(300, 180, theme.PAPER)
        self.canvas.setObjectName("sign_check_canvas")
        self.canvas.setAccessibleName(gettext("Roll, pitch and heading over time"))
        self.canvas.setToolTip(gettext("Wheel: zoom. Drag: move. Double-click: show all."))
        self._zooming = PlotZoom(self.canvas)
        self._draw()
        layout.addWidget(self.canvas, 1)
        layout.addWidget(
            widgets.label(gettext("Shaded areas: times of the lines"), "muted", wrap=True)
        )
        self.reversals = {angle: self._create_reversal(angle) for angle in reversible}
        if reversible:
            row = QHBoxLayout()
            for box in self.reversals.values():
                row.addWidget(box)
            row.addStretch(1)
            layout.addLayout(row)
        layout.addWidget(widgets.label(gettext(ADJUSTMENT_TEXT), wrap=True))
        layout.addWidget(self._create_buttons())
        screen = self.screen().availableGeometry()
        self.resize(min(WIDTH_PX, screen.width() - 40), min(HEIGHT_PX, screen.height() - 60))

    @property
    def reversed_angles(self) -> tuple[SignedAngle, ...]:
        """Angles whose curves the user has turned around."""
        return tuple(angle for angle, box in self.reversals.items() if box.isChecked())

    def _create_reversal(self, angle: SignedAngle) -> QCheckBox:
        box = QCheckBox(gettext(REVERSAL_TITLES[angle]))
        box.setObjectName(f"reverse_{angle}")
        box.setToolTip(gettext(REVERSAL_TIP))
        box.toggled.connect(self._on_reversed)
        return box

    def _create_buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        self.change = widgets.button(
            gettext("Change the signs"), "change_signs",
            tip=gettext(
                "Reads the trajectory with the other sign. The targets keep their points; the "
                "results are removed. Undo with Ctrl+Z."
            ),
        )  # fmt: skip
        self.change.setEnabled(False)
        self.change.clicked.connect(self.accept)
        if self.reversals:
            buttons.addButton(self.change, QDialogButtonBox.ButtonRole.ActionRole)
        return buttons

    def _on_reversed(self) -> None:
        self.change.setEnabled(bool(self.reversed_angles))
        self._draw()

    def _draw(self) -> None:
        """Draw the curves, those of the reversed angles turned around."""
        from lispac.gui.features.open_project.import_survey.quality_figures import draw_signs

        signs = np.ones(3)
        signs[[COLUMNS[angle] for angle in self.reversed_angles]] = -1.0
        record = replace(self._record, attitude=signs * self._record.attitude)
        draw_signs(record, self.canvas.figure)
        self._zooming.set_home(zooms_vertically=False)
        self.canvas.draw_idle()
