"""Dialogue to check the signs of roll and pitch against the known motion of the vessel."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.chart import Chart
from lispac.gui.widgets.plot_zoom import PlotZoom
from lispac.language import N_, gettext

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
        "Compare the curves with a turn or a wave that you know. If a curve is reversed, create "
        "the project again with the other sign under Reading options."
    ),
}
"""What to do if a sign is wrong, by the place where the dialogue is opened."""
WIDTH_PX, HEIGHT_PX = 900, 620


class SignCheckDialog(QDialog):
    """Dialogue with the curves of roll, pitch and heading and the signs they must have.

    Parameters
    ----------
    place : key of `CORRECTIONS`
    """

    def __init__(self, record: "AttitudeRecord", place: str, parent: QWidget | None = None) -> None:
        from lispac.gui.features.open_project.import_survey.quality_figures import draw_signs

        super().__init__(parent)
        self.setObjectName("sign_check_dialog")
        self.setWindowTitle(gettext(TITLE))
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(widgets.label(gettext(EXPECTED_TEXT), "heading", wrap=True))
        layout.addWidget(widgets.label(gettext(CORRECTIONS[place]), wrap=True))
        self.canvas = Chart(300, 180, theme.PAPER)
        self.canvas.setObjectName("sign_check_canvas")
        self.canvas.setAccessibleName(gettext("Roll, pitch and heading over time"))
        self.canvas.setToolTip(gettext("Wheel: zoom. Drag: move. Double-click: show all."))
        draw_signs(record, self.canvas.figure)
        self._zooming = PlotZoom(self.canvas)
        self._zooming.set_home(zooms_vertically=False)
        layout.addWidget(self.canvas, 1)
        layout.addWidget(
            widgets.label(gettext("Shaded areas: times of the lines"), "muted", wrap=True)
        )
        layout.addWidget(widgets.label(gettext(ADJUSTMENT_TEXT), wrap=True))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout.addWidget(buttons)
        screen = self.screen().availableGeometry()
        self.resize(min(WIDTH_PX, screen.width() - 40), min(HEIGHT_PX, screen.height() - 60))
