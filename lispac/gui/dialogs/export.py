"""What to export, with which boresight, in which coordinates, and where."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QVBoxLayout,
    QWidget,
)

from lispac.errors import InputError, LispacError
from lispac.gui import theme
from lispac.gui.dialogs.system_choice import HEIGHTS, REST_MS, system_box, system_text
from lispac.gui.language import say, say_all, say_sentences
from lispac.gui.panels import widgets
from lispac.installed import expanded
from lispac.messages import error
from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.export_request import (
    ENDINGS,
    ExportRequest,
    What,
    system_of,
)
from lispac.workflow.exporting import EPOCH_WORDS, trajectory_datum_words
from lispac.workflow.georeferencing import Which
from lispac.workflow.target_systems import DOUBT, LOCAL, own_datum

THINGS: dict[What, str] = {
    "lines": "Georeferenced lines, all attributes kept",
    "targets": "Points of targets and validation planes",
    "planes": "Plane files of the targets (25 columns)",
    "trajectory": "Trajectory",
}
FORMS = {
    "laz": "LAZ (compressed)", "las": "LAS", "csv": "CSV", "txt": "Text", "sbet": "SBET (.out)",
    "text": "Text (.txt)",
}  # fmt: skip
BORESIGHTS: dict[Which, str] = {"estimated": "Estimated", "prior": "Prior"}


class ExportDialog(QDialog):
    """Asks what to export."""

    def __init__(
        self,
        what: What,
        which: Which,
        project: Project,
        trajectory: LocalTrajectory,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("export_dialog")
        self.setWindowTitle(say("Export"))
        self._project, self._trajectory = project, trajectory
        self.what = widgets.Choice("export_what", list(THINGS.values()), "What to write")
        self.boresight = widgets.Choice(
            "export_boresight", list(BORESIGHTS.values()), "Boresight the points are placed with"
        )
        self.system = system_box("export_system", project, trajectory)
        self.height = QLineEdit()
        self.height.setObjectName("export_height")
        self.height.setPlaceholderText(say(HEIGHTS))
        self.height.setToolTip(
            say("EPSG code of a vertical system, path of a geoid grid (.gtx, .tif), or ellipsoid")
        )
        self.datum, self.epoch = QLineEdit(), QLineEdit()
        self.datum.setObjectName("export_datum")
        self.datum.setPlaceholderText(say("As the coordinate system, nothing is shifted"))
        self.datum.setToolTip(
            say("Geographic system of the trajectory: EPSG:7912 for ITRF2014, say")
        )
        self.epoch.setObjectName("export_epoch")
        self.epoch.setPlaceholderText(say("Where datums drift apart: 2024.5, say"))
        self.epoch.setToolTip(say("Date of the survey as a decimal year (yr)"))
        self._preset_datum()
        self.said = widgets.label("", "muted", wrap=True, name="export_said")
        self.form = QComboBox()
        self.form.setObjectName("export_form")
        self.folder = QLineEdit(str(project.folder / "export"))
        self.folder.setObjectName("export_folder")
        self.folder.setMinimumWidth(420)
        browse = widgets.button("Browse…", "export_browse", icon="folder-open-outline")
        browse.clicked.connect(self._browse)
        place = QHBoxLayout()
        place.setSpacing(theme.SPACE)
        place.addWidget(self.folder, 1)
        place.addWidget(browse)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACE)
        self._rows = form
        form.addRow(say("Export"), self.what)
        form.addRow(say("Boresight"), self.boresight)
        form.addRow(say("Coordinates"), self.system)
        form.addRow(say("Heights"), self.height)
        form.addRow(say("Trajectory datum"), self.datum)
        form.addRow(say("Epoch (yr)"), self.epoch)
        form.addRow("", self.said)
        form.addRow(say("File format"), self.form)
        form.addRow(say("Folder"), place)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        ok.setText(say("Export"))
        ok.setProperty("primary", True)
        for button in self.buttons.buttons():
            button.setIcon(QIcon())
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 14, 16, 14)
        layout.setSpacing(theme.SPACE * 2)
        layout.addLayout(form)
        layout.addStretch(1)
        layout.addWidget(self.buttons)
        self._settle = QTimer(self)
        self._settle.setSingleShot(True)
        self._settle.setInterval(REST_MS)
        self._settle.timeout.connect(self._judge)
        self.what.currentIndexChanged.connect(self._show_fields)
        self.system.editTextChanged.connect(self._typed)
        for field in (self.height, self.datum, self.epoch):
            field.textChanged.connect(self._typed)
        self.folder.textChanged.connect(self._judge)
        if project.result is None:
            self.boresight.setCurrentIndex(list(BORESIGHTS).index("prior"))
            self.boresight.setEnabled(False)
            self.boresight.setToolTip(say("Nothing is estimated yet"))
        else:
            self.boresight.setCurrentIndex(list(BORESIGHTS).index(which))
        self.what.setCurrentIndex(list(THINGS).index(what))
        self._show_fields()

    def request(self) -> ExportRequest:
        """What was asked for."""
        what, form = self._what, self._form
        # A relative name is meant beside the project, not where the program was started.
        output = self._project.folder / expanded(Path(self.folder.text().strip()))
        if what == "trajectory":
            ending = ".out" if form == "sbet" else ".txt"
            output = output / f"{self._project.trajectory.stem}_export{ending}"
        which = list(BORESIGHTS)[self.boresight.currentIndex()]
        try:
            datum, epoch = self._shift()
        except InputError:  # said in the dialogue, which does not go on with it
            datum, epoch = None, None
        return ExportRequest(
            what, output, which, form, self._system_text, self._height, datum, epoch
        )

    def _preset_datum(self) -> None:
        """Take over what the lines are read with; where they differ, it has to be said."""
        self._differ = False
        try:
            datum, epoch = own_datum(self._project.lines)
        except LispacError:
            self._differ = True
            return
        self.datum.setText(datum)
        self.epoch.setText("" if epoch is None else repr(epoch))

    def _shift(self) -> tuple[str | None, float | None]:
        """Datum and epoch of the trajectory as the fields say; None as the lines' files."""
        if not self.datum.isEnabled():
            return None, None
        text = self.epoch.text().strip().replace(",", ".")
        try:
            epoch = float(text) if text else None
        except ValueError:
            raise InputError(error("window.not_a_decimal_year", text=text)) from None
        datum = self.datum.text().strip()
        return (None if self._differ and not datum else datum), epoch

    @property
    def _height(self) -> str:
        return self.height.text().strip() if self.height.isEnabled() else ""

    @property
    def _what(self) -> What:
        return list(THINGS)[self.what.currentIndex()]

    @property
    def _form(self) -> str:
        return ENDINGS[self._what][self.form.currentIndex()]

    @property
    def _system_text(self) -> str:
        return system_text(self.system)

    def _show_fields(self) -> None:
        what = self._what
        on_map = what in ("lines", "targets")
        for field in (self.system, self.height, self.datum, self.epoch):
            self._rows.setRowVisible(field, on_map)
        self._rows.setRowVisible(self.boresight, what != "trajectory")
        self.form.clear()
        self.form.addItems(say_all([FORMS[ending] for ending in ENDINGS[what]]))
        self.form.setEnabled(len(ENDINGS[what]) > 1)
        self._judge()
        self.adjustSize()

    def _typed(self) -> None:
        if self.system.findText(self.system.currentText()) >= 0 and not self.height.text():
            self._judge()  # chosen, not typed
            return
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setEnabled(False)
        self._settle.start()

    def _judge(self) -> None:
        """Say what the coordinates mean, or what is wrong with them."""
        self._settle.stop()
        local = self._system_text == LOCAL
        self.height.setEnabled(not local)
        for field in (self.datum, self.epoch):  # the lines' own system has them already
            field.setEnabled(not local and bool(self._system_text))
        good = bool(self.folder.text().strip())
        try:
            meaning = self._meaning()
            text = " ".join(say_sentences(meaning))
            role = "error" if any(DOUBT in each for each in meaning) else "muted"
        except LispacError as error:
            text, role, good = say(str(error)), "error", False
        self.said.setText(text)
        self.said.setProperty("role", role)
        self.said.style().unpolish(self.said)
        self.said.style().polish(self.said)
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setEnabled(good)

    def _meaning(self) -> Sequence[str]:
        if self._what == "trajectory":
            return [trajectory_datum_words(self._project)]
        local = ["Metres North, West and Up from the project's origin."]
        if self._what == "planes":
            return local
        height = self._height
        found = system_of(
            self._project, self._trajectory, self._system_text, height, *self._shift()
        )
        if found is None:
            return local
        return [*(found.assumptions or (found.name,)), EPOCH_WORDS]

    def _browse(self) -> None:
        chosen = QFileDialog.getExistingDirectory(
            self, say("Folder to export to"), self.folder.text()
        )
        if chosen:
            self.folder.setText(chosen)
