"""Dialogue that asks for a file with control and its standard deviations."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtWidgets import QWidget

from lispac.gui import widgets
from lispac.gui.widgets.surveyed_file_dialog import SurveyedFileDialog
from lispac.language import gettext
from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.control.control_import import DEFAULT_SIGMA


@dataclass(frozen=True)
class ControlRequest:
    """File with control and how it is read.

    Attributes
    ----------
    crs, height : coordinate systems as in `lispac control`; empty for those of the file
    sigma : float, metres
        Standard deviation of points without one, or the common one of a scan.
    common_sigma : float or None, metres
        Standard deviation of a common translation; None for that of the kind of file.
    """

    path: Path
    crs: str
    height: str
    sigma: float
    common_sigma: float | None


class ControlImportDialog(SurveyedFileDialog):
    """Dialogue for a file with control: file, coordinate system and standard deviations."""

    def __init__(
        self, project: Project, trajectory: LocalTrajectory, parent: QWidget | None = None
    ) -> None:
        super().__init__(
            project, trajectory,
            name="control",
            introduction=gettext(
                "The surveyed points become observations of the adjustment. Each row of a "
                "list has a name, three coordinates (in the local frame north, west, up) and, "
                "optionally, a standard deviation and, in a column plane, the name of the "
                "target. Other points belong to the target on whose surface they lie. Of a "
                "static scan, the surfaces of the targets are used."
            ),
            label=gettext("File"),
            browse_title=gettext("Choose the file with the control"),
            parent=parent,
        )  # fmt: skip
        self.setObjectName("control_import_dialog")
        self.setWindowTitle(gettext("Import surveyed control"))
        self.sigma = widgets.number(
            "control_sigma", suffix=" mm", decimals=1, low=0.1, high=1000, step=1,
            tip=gettext(
                "Standard deviation of each coordinate of points without one of their own. Of a "
                "scan: error common to all points, from registration and control."
            ),
        )  # fmt: skip
        self.sigma.setValue(1000 * DEFAULT_SIGMA)
        self.common_sigma = widgets.number(
            "control_common_sigma", suffix=" mm", decimals=1, low=0, high=1000, step=1,
            tip=gettext(
                "Standard deviation, on each axis, of a translation that all points of a list "
                "share, such as that of the fixed points"
            ),
        )  # fmt: skip
        self.common_sigma.setValue(0.0)
        self.form.addRow(gettext("Uncertainty of the points (1 σ)"), self.sigma)
        self.form.addRow(gettext("Common uncertainty (1 σ)"), self.common_sigma)
        self.add_buttons(widgets.button(gettext("Import"), "control_import", primary=True))

    @property
    def request(self) -> ControlRequest:
        """The file and the options as filled in."""
        common = self.common_sigma.value() / 1000
        return ControlRequest(
            self.path, *self.systems, self.sigma.value() / 1000, common if common > 0 else None
        )
