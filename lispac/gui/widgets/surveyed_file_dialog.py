"""Base of the dialogues that ask for a file with surveyed points or a scan of the site."""

from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QFormLayout, QHBoxLayout, QLineEdit, QPushButton, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.number_input import NumberDialog
from lispac.gui.widgets.system_choice import HEIGHT_PLACEHOLDER, system_box, system_text
from lispac.language import N_, gettext
from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.project.output_crs import LOCAL_FRAME

MIN_WIDTH_PX, MARGIN_PX = 620, 16
SYSTEM_OF_FILE_TEXT = N_("System of the file, or local frame if it has none")


class SurveyedFileDialog(NumberDialog):
    """Dialogue with a file, its coordinate system and its vertical system.

    Derived classes add their rows to `form` and the buttons with `add_buttons`.

    Parameters
    ----------
    name : str
        Prefix of the object names of the fields.
    label : str
        Label of the file.
    browse_title : str
        Title of the dialogue that chooses the file.
    """

    def __init__(
        self, project: Project, trajectory: LocalTrajectory, *, name: str, introduction: str,
        label: str, browse_title: str, parent: QWidget | None = None,
    ) -> None:  # fmt: skip
        super().__init__(parent)
        self.setMinimumWidth(MIN_WIDTH_PX)
        self._name, self._browse_title, self._start = name, browse_title, project.folder.parent
        self._layout = widgets.vertical_layout(self, MARGIN_PX)
        self._layout.addWidget(widgets.introduction(introduction, MIN_WIDTH_PX - 2 * MARGIN_PX))
        self.file = QLineEdit()
        self.file.setObjectName(f"{name}_file")
        self.file.setPlaceholderText(gettext("LAS, LAZ, E57, PTS or text file"))
        browse = widgets.button(gettext("Browse…"), f"{name}_browse", tip=browse_title)
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        row = QHBoxLayout()
        row.addWidget(self.file, 1)
        row.addWidget(browse)
        self.system = system_box(f"{name}_system", project, trajectory, local_first=True)
        known = self.system.findData("")
        if known >= 0:  # the file may have another system than the lines
            self.system.removeItem(known)
        self.system.insertItem(0, gettext(SYSTEM_OF_FILE_TEXT), "")
        self.system.setCurrentIndex(0)
        self.height = QLineEdit()
        self.height.setObjectName(f"{name}_height")
        self.height.setPlaceholderText(gettext(HEIGHT_PLACEHOLDER))
        self.form = QFormLayout()
        self.form.setVerticalSpacing(theme.SPACING)
        self.form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.form.addRow(label, row)
        self.form.addRow(gettext("Coordinate system"), self.system)
        self.form.addRow(gettext("Vertical system"), self.height)
        self._layout.addLayout(self.form)

    def add_buttons(self, accept: QPushButton) -> None:
        """Add the button that accepts the dialogue, enabled with a file, and Cancel."""
        self.accept_button = accept
        accept.setDefault(True)
        accept.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), f"{self._name}_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(accept, cancel):
            row.addWidget(each)
        self._layout.addLayout(row)
        self.file.textChanged.connect(self._show)
        self.system.currentTextChanged.connect(self._show)
        self._show()

    @property
    def path(self) -> Path:
        """The chosen file."""
        return Path(self.file.text().strip())

    @property
    def systems(self) -> tuple[str, str]:
        """Horizontal and vertical coordinate system; empty for those of the file."""
        code = system_text(self.system)
        return code, self.height.text().strip() if code != LOCAL_FRAME else ""

    def _show(self) -> None:
        self.accept_button.setEnabled(bool(self.file.text().strip()))
        self.form.setRowVisible(self.height, system_text(self.system) not in ("", LOCAL_FRAME))

    def _browse(self) -> None:
        name, _ = QFileDialog.getOpenFileName(
            self, self._browse_title, str(self._start),
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
