"""Dialogue that asks for a file with control and its standard deviations."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QFormLayout, QHBoxLayout, QLineEdit, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.number_input import NumberDialog
from lispac.gui.widgets.system_choice import HEIGHT_PLACEHOLDER, system_box, system_text
from lispac.language import N_, gettext
from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.control.control_import import DEFAULT_SIGMA
from lispac.workflow.project.output_crs import LOCAL_FRAME

SYSTEM_OF_FILE_TEXT = N_("System of the file, or local frame if it has none")


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


class ControlImportDialog(NumberDialog):
    """Dialogue for a file with control: file, coordinate system and standard deviations."""

    def __init__(
        self, project: Project, trajectory: LocalTrajectory, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("control_import_dialog")
        self.setWindowTitle(gettext("Import surveyed control"))
        self.setMinimumWidth(620)
        self._start = project.folder.parent
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(
            widgets.label(
                gettext(
                    "The surveyed points become observations of the adjustment. Each row of a "
                    "list has a name, three coordinates (in the local frame north, west, up) and, "
                    "optionally, a standard deviation and, in a column plane, the name of the "
                    "target. Other points belong to the target on whose surface they lie. Of a "
                    "static scan, the surfaces of the targets are used."
                ),
                wrap=True,
            )
        )
        self.file = QLineEdit()
        self.file.setObjectName("control_file")
        self.file.setPlaceholderText(gettext("LAS, LAZ, E57, PTS or text file"))
        browse = widgets.button(
            gettext("Browse…"), "control_browse", tip=gettext("Choose the file with the control")
        )
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        row = QHBoxLayout()
        row.addWidget(self.file, 1)
        row.addWidget(browse)
        self.system = system_box("control_system", project, trajectory, local_first=True)
        known = self.system.findData("")
        if known >= 0:  # the control may have another system than the lines
            self.system.removeItem(known)
        self.system.insertItem(0, gettext(SYSTEM_OF_FILE_TEXT), "")
        self.system.setCurrentIndex(0)
        self.height = QLineEdit()
        self.height.setObjectName("control_height")
        self.height.setPlaceholderText(gettext(HEIGHT_PLACEHOLDER))
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
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(gettext("File"), row)
        form.addRow(gettext("Coordinate system"), self.system)
        form.addRow(gettext("Vertical system"), self.height)
        form.addRow(gettext("Uncertainty of the points (1 σ)"), self.sigma)
        form.addRow(gettext("Common uncertainty (1 σ)"), self.common_sigma)
        layout.addLayout(form)
        self.accept_button = widgets.button(gettext("Import"), "control_import", primary=True)
        self.accept_button.setDefault(True)
        self.accept_button.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), "control_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.accept_button, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        self._form = form
        self.file.textChanged.connect(self._show)
        self.system.currentTextChanged.connect(self._show)
        self._show()

    @property
    def request(self) -> ControlRequest:
        """The file and the options as filled in."""
        code = system_text(self.system)
        height = self.height.text().strip() if code != LOCAL_FRAME else ""
        common = self.common_sigma.value() / 1000
        return ControlRequest(
            Path(self.file.text().strip()), code, height, self.sigma.value() / 1000,
            common if common > 0 else None,
        )  # fmt: skip

    def _show(self) -> None:
        self.accept_button.setEnabled(bool(self.file.text().strip()))
        self._form.setRowVisible(self.height, system_text(self.system) not in ("", LOCAL_FRAME))

    def _browse(self) -> None:
        name, _ = QFileDialog.getOpenFileName(
            self, gettext("Choose the file with the control"), str(self._start),
            ";;".join(
                [
                    gettext(
                        "Scans and lists of points ({patterns})",
                        patterns="*.las *.laz *.e57 *.txt *.csv *.asc *.xyz *.pts",
                    ),
                    gettext("All files (*)"),
                ]
            ),
        )  # fmt: skip
        if name:
            self.file.setText(name)
