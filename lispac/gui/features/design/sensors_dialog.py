"""Dialogue to choose the sensors of a survey plan from the library."""

from pathlib import Path

from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.sensor_choice import SensorChoice
from lispac.io.config.sensor_file import PosAccuracy, ScannerSpecification
from lispac.language import gettext
from lispac.workflow.planning.sensors import read_library

Sensors = tuple[ScannerSpecification | None, PosAccuracy | None]


class PlanSensorsDialog(QDialog):
    """Choice of scanner and INS/GNSS; the plan keeps its values where none is chosen.

    Parameters
    ----------
    folder : of the user's own sensors
    """

    def __init__(self, folder: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("plan_sensors")
        self.setWindowTitle(gettext("Sensors of the survey plan"))
        self.setMinimumWidth(520)
        self._scanner: ScannerSpecification | None = None
        self._pos: PosAccuracy | None = None
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(
            widgets.label(
                gettext(
                    "The standard deviations of the chosen sensors are copied to the survey plan. "
                    "If no sensor is chosen, the survey plan keeps its values."
                ),
                wrap=True,
            )
        )
        self.choice = SensorChoice(read_library(folder), "plan")
        self.choice.scanner_chosen.connect(self._set_scanner)
        self.choice.pos_chosen.connect(self._set_pos)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        form.addRow(gettext("Scanner"), self.choice.scanner)
        form.addRow("", self.choice.scanner_origin)
        form.addRow(gettext("INS/GNSS"), self.choice.pos)
        form.addRow("", self.choice.pos_origin)
        layout.addLayout(form)
        self.take = widgets.button(gettext("Use these sensors"), "plan_sensors_take", primary=True)
        self.take.setDefault(True)
        self.take.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), "plan_sensors_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.take, cancel):
            row.addWidget(each)
        layout.addLayout(row)

    @property
    def sensors(self) -> Sensors:
        """The chosen sensors; None where the plan keeps its values."""
        scanner, pos = self.choice.names
        return (self._scanner if scanner else None, self._pos if pos else None)

    def _set_scanner(self, figures: ScannerSpecification) -> None:
        self._scanner = figures

    def _set_pos(self, state: PosAccuracy) -> None:
        self._pos = state
