"""Against which reference the lines are to be checked, and what came of it."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtWidgets import (
    QDialog,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QWidget,
)

from lispac.gui import theme
from lispac.gui.dialogs.study import StudyDialog
from lispac.gui.dialogs.system_choice import HEIGHTS, system_box, system_text
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.project import Project
from lispac.report.absolute_values import Absolute, AgainstReference, LineAgainstReference
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.absolute import REACH, SIGMA
from lispac.workflow.target_systems import LOCAL

AS_STATED = "As the file says, else the local frame"
COLUMNS = (
    Column("Line", "Each line that saw the reference, and all of them", words=True),
    Column("Places", "Where line and reference were compared, the same before and after"),
    *(
        Column(f"{name} {state} (mm)", f"{tip}, {state} the calibration, millimetres", base="mm")
        for state in ("before", "after")
        for name, tip in (
            ("Mean", "Mean distance from the reference, positive towards the vessel"),
            ("± 95 %", "What the mean may be off by, with POS, reference and boresight"),
            ("RMS", "Root mean square distance"),
        )
    ),
    Column("Finding", "Whether the mean after the calibration is within its 95 %", words=True),
)


@dataclass(frozen=True)
class CheckRequest:
    """What is to be checked.

    Attributes
    ----------
    crs, height : as `lispac check` takes them; empty as the file says
    sigma : float, metres
        Of the reference, where it states none.
    reach : float, metres
        How far from the reference a line is looked for.
    """

    path: Path
    crs: str
    height: str
    sigma: float
    reach: float


class CheckDialog(QDialog):
    """A file, its coordinates and how good it is."""

    def __init__(
        self, project: Project, trajectory: LocalTrajectory, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("check_dialog")
        self.setWindowTitle(say("Check against a reference"))
        self.setMinimumWidth(620)
        self._start = project.folder.parent
        layout = widgets.column(self, 16)
        layout.addWidget(
            widgets.label(
                "The lines are compared with a static scan of the site, or with surveyed points: a "
                "list with name, three coordinates, and perhaps the sigma and the plane that each "
                "point lies on with others.", wrap=True,
            )
        )  # fmt: skip
        self.file = QLineEdit()
        self.file.setObjectName("check_file")
        self.file.setPlaceholderText(say("LAS, LAZ, E57, PTS or text"))
        browse = widgets.button("Browse…", "check_browse", tip="Choose the reference")
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        row = QHBoxLayout()
        row.addWidget(self.file, 1)
        row.addWidget(browse)
        self.system = system_box("check_system", project, trajectory, local_first=True)
        known = self.system.findData("")
        if known >= 0:  # what the lines are in says nothing of the reference
            self.system.removeItem(known)
        self.system.insertItem(0, say(AS_STATED), "")
        self.system.setCurrentIndex(0)
        self.height = QLineEdit()
        self.height.setObjectName("check_height")
        self.height.setPlaceholderText(say(HEIGHTS))
        self.sigma = widgets.number(
            "check_sigma", suffix=" mm", decimals=1, low=0, high=1000, step=1,
            tip="1 sigma of the reference: of a scan what all its points share (registration and "
            "control), of a list that of each point it states none for",
        )  # fmt: skip
        self.sigma.setValue(1000 * SIGMA)
        self.reach = widgets.number(
            "check_reach", suffix=" m", decimals=2, low=0.05, high=20, step=0.25,
            tip="How far from the reference a line is looked for: more than the prior boresight "
            "puts it off",
        )  # fmt: skip
        self.reach.setValue(REACH)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACE)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(say("Reference"), row)
        form.addRow(say("Coordinates"), self.system)
        form.addRow(say("Heights"), self.height)
        form.addRow(say("Reference ± 1 sigma"), self.sigma)
        form.addRow(say("Looked for within"), self.reach)
        layout.addLayout(form)
        self.check = widgets.button("Check", "check_run", primary=True)
        self.check.setDefault(True)
        self.check.clicked.connect(self.accept)
        cancel = widgets.button("Cancel", "check_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_order(self.check, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        self._form = form
        self.file.textChanged.connect(self._show)
        self.system.currentTextChanged.connect(self._show)
        self._show()

    @property
    def request(self) -> CheckRequest:
        """What is filled in."""
        code = system_text(self.system)
        height = self.height.text().strip() if code != LOCAL else ""
        return CheckRequest(
            Path(self.file.text().strip()), code, height, self.sigma.value() / 1000,
            self.reach.value(),
        )  # fmt: skip

    def _show(self) -> None:
        self.check.setEnabled(bool(self.file.text().strip()))
        self._form.setRowVisible(self.height, system_text(self.system) not in ("", LOCAL))

    def _browse(self) -> None:
        name, _ = QFileDialog.getOpenFileName(
            self, say("Reference"), str(self._start),
            say("Scans and lists of points (*.las *.laz *.e57 *.txt *.csv *.asc *.xyz *.pts);;"
            "All files (*)"),
        )  # fmt: skip
        if name:
            self.file.setText(name)


class CheckedDialog(StudyDialog):
    """How far each line is from the reference, before and after."""

    def __init__(self, found: Absolute, parent: QWidget | None = None) -> None:
        from lispac.report.absolute_figure import absolute_figure

        table = DiagnosticsTable("check_table", "Lines against the reference", COLUMNS)
        super().__init__(
            "checked", f"Check against {found.reference}",
            "Distances of the lines from the reference along its normal, positive towards the "
            "vessel. The report has them too.",
            table, parent,
        )  # fmt: skip
        self.show_rows([_row(each) for each in (*found.lines, found.together)])
        unseen = [f"Not compared: {reason}" for reason in found.not_compared]
        self.said.setText(say("\n".join([*found.in_words, *unseen])))
        absolute_figure(found, say, self.figure())
        self.resize(1000, 760)


def _row(line: LineAgainstReference) -> Row:
    after = line.after
    cells = [Cell(line.line), number(after.distances.n, ",.0f")]
    for state in (line.before, after):
        cells += _figures(state)
    word = "differs" if after.mean_significant else "agrees"
    return Row((*cells, Cell(word)), marked=after.mean_significant)


def _figures(state: AgainstReference) -> list[Cell]:
    return [
        number(state.signed.mean_m, "+.1f", 1000.0),
        number(state.mean_interval95_m, ".1f", 1000.0),
        number(state.distances.rms_m, ".1f", 1000.0),
    ]
