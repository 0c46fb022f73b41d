"""Export dialogue: content, boresight, coordinates, file format and folder."""

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
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import ask_to_replace
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.export.actions import ACTIONS
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.number_input import parse_number
from lispac.gui.widgets.system_choice import (
    CHECK_DELAY_MS,
    HEIGHT_PLACEHOLDER,
    HEIGHT_TIP,
    system_box,
    system_text,
)
from lispac.installation_paths import expand_user
from lispac.language import N_, gettext
from lispac.messages import Message, error, note
from lispac.project import BoresightChoice, Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.output.data_export import trajectory_datum_note
from lispac.workflow.output.export_request import (
    FILE_TYPES,
    ExportContent,
    ExportRequest,
    output_paths,
)
from lispac.workflow.output.georeferencing import TrajectoryChoice
from lispac.workflow.output.pos_corrections import pos_corrections, support_notes
from lispac.workflow.project.output_crs import LOCAL_FRAME, output_system_of, trajectory_datum_of

CONTENT_TITLES: dict[ExportContent, str] = {
    "lines": N_("Georeferenced lines with all attributes"),
    "targets": N_("Points of targets and validation planes"),
    "planes": N_("Points of the target planes (text, 25 columns)"),
    "trajectory": N_("Trajectory"),
    "corrected_trajectory": N_("Corrected trajectory, with accuracies and corrections"),
}
FORMAT_TITLES = {
    "laz": N_("LAZ (compressed)"), "las": "LAS", "csv": "CSV", "txt": N_("Text (.txt)"),
    "sbet": "SBET (.out)", "text": N_("Text (.txt)"),
}  # fmt: skip
BORESIGHT_TITLES: dict[BoresightChoice, str] = {
    "estimated": N_("Estimated boresight"),
    "prior": N_("Prior boresight"),
}
TRAJECTORY_TITLES: dict[TrajectoryChoice, str] = {
    "given": N_("Given trajectory"),
    "corrected": N_("Trajectory corrected by the adjustment"),
}


class ExportDialog(QDialog):
    """Dialogue for an export of a project."""

    def __init__(
        self,
        what: ExportContent,
        which: BoresightChoice,
        project: Project,
        trajectory: LocalTrajectory,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("export_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["targets" if what == "planes" else what]))
        self._project, self._trajectory = project, trajectory
        self.what = widgets.ChoiceBox(
            "export_what",
            [gettext(each) for each in CONTENT_TITLES.values()],
            gettext("Data to export"),
        )
        self.boresight = widgets.ChoiceBox(
            "export_boresight", [gettext(each) for each in BORESIGHT_TITLES.values()],
            gettext("Boresight angles used to georeference the points"),
        )  # fmt: skip
        self.trajectory = widgets.ChoiceBox(
            "export_trajectory", [gettext(each) for each in TRAJECTORY_TITLES.values()],
            gettext("Trajectory used to georeference the points"),
        )  # fmt: skip
        self.system = system_box("export_system", project, trajectory)
        self.height = QLineEdit()
        self.height.setObjectName("export_height")
        self.height.setPlaceholderText(gettext(HEIGHT_PLACEHOLDER))
        self.height.setToolTip(gettext(HEIGHT_TIP))
        self.datum, self.epoch = QLineEdit(), QLineEdit()
        self.datum.setObjectName("export_datum")
        self.datum.setPlaceholderText(gettext("Same as the coordinate system (no datum shift)"))
        self.datum.setToolTip(
            gettext("Geographic system of the trajectory, such as EPSG:7912 for ITRF2014")
        )
        self.epoch.setObjectName("export_epoch")
        self.epoch.setPlaceholderText(
            gettext("Decimal year for a time-dependent datum shift, such as 2024.5")
        )
        self.epoch.setToolTip(gettext("Date of the survey as a decimal year"))
        self._preset_datum()
        self.message_label = widgets.label("", "muted", wrap=True, name="export_message")
        self.form = QComboBox()
        self.form.setObjectName("export_form")
        self.folder = QLineEdit(str(project.folder / "export"))
        self.folder.setObjectName("export_folder")
        self.folder.setMinimumWidth(420)
        self._arrange()
        self._debounce = QTimer(self)
        self._debounce.setSingleShot(True)
        self._debounce.setInterval(CHECK_DELAY_MS)
        self._debounce.timeout.connect(self._check_input)
        self.what.currentIndexChanged.connect(self._show_fields)
        self.system.editTextChanged.connect(self._on_typed)
        for field in (self.height, self.datum, self.epoch):
            field.textChanged.connect(self._on_typed)
        self.folder.textChanged.connect(self._check_input)
        for choice in (self.boresight, self.trajectory):
            choice.currentIndexChanged.connect(self._check_input)
        if project.result is None:
            self.boresight.setCurrentIndex(list(BORESIGHT_TITLES).index("prior"))
            self.boresight.setEnabled(False)
            self.boresight.setToolTip(
                gettext(
                    "Only the prior boresight can be used because no boresight has been estimated "
                    "yet"
                )
            )
        else:
            self.boresight.setCurrentIndex(list(BORESIGHT_TITLES).index(which))
        self.what.setCurrentIndex(list(CONTENT_TITLES).index(what))
        self._show_fields()

    def _arrange(self) -> None:
        """Place the fields in a form above the buttons."""
        browse = widgets.button(gettext("Browse…"), "export_browse", icon="folder-open-outline")
        browse.clicked.connect(self._browse)
        place = QHBoxLayout()
        place.setSpacing(theme.SPACING)
        place.addWidget(self.folder, 1)
        place.addWidget(browse)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        self._rows = form
        form.addRow(gettext("Data"), self.what)
        form.addRow(gettext("Boresight"), self.boresight)
        form.addRow(gettext("Trajectory"), self.trajectory)
        form.addRow(gettext("Coordinate system"), self.system)
        form.addRow(gettext("Vertical system"), self.height)
        form.addRow(gettext("Trajectory datum"), self.datum)
        form.addRow(gettext("Epoch (year)"), self.epoch)
        form.addRow("", self.message_label)
        form.addRow(gettext("File format"), self.form)
        form.addRow(gettext("Folder"), place)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        ok.setText(gettext("Export"))
        ok.setProperty("primary", True)
        for button in self.buttons.buttons():
            button.setIcon(QIcon())
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 14, 16, 14)
        layout.setSpacing(theme.SPACING * 2)
        layout.addLayout(form)
        layout.addStretch(1)
        layout.addWidget(self.buttons)

    def request(self) -> ExportRequest:
        """The export as filled in."""
        what, form = self._content, self._file_format
        # A relative path refers to the project folder, not to the working directory.
        output = self._project.folder / expand_user(Path(self.folder.text().strip()))
        if what == "trajectory":
            ending = ".out" if form == "sbet" else ".txt"
            output = output / f"{self._project.trajectory.stem}_export{ending}"
        elif what == "corrected_trajectory":
            output = output / f"{self._project.trajectory.stem}_corrected.out"
        which = list(BORESIGHT_TITLES)[self.boresight.currentIndex()]
        try:
            datum, epoch = self._datum_and_epoch()
        except InputError:  # shown by the dialogue, which cannot be accepted
            datum, epoch = None, None
        return ExportRequest(
            what, output, which, form, self._system_text, self._height, datum, epoch,
            self._trajectory_choice,
        )  # fmt: skip

    def accept(self) -> None:
        """Close the dialogue, after a question if files would be replaced."""
        try:
            paths = output_paths(self._project, self.request())
        except LispacError:  # reported by the export
            paths = []
        existing = [path for path in paths if path.exists()]
        if not existing or ask_to_replace(existing, self):
            super().accept()

    def _preset_datum(self) -> None:
        """Fill in datum and epoch of the lines; leave them empty if the lines differ."""
        self._datums_differ = False
        try:
            datum, epoch = trajectory_datum_of(self._project.lines)
        except LispacError:
            self._datums_differ = True
            return
        self.datum.setText(datum)
        self.epoch.setText("" if epoch is None else repr(epoch))

    def _datum_and_epoch(self) -> tuple[str | None, float | None]:
        """Datum and epoch of the trajectory from the fields; None for those of the line files."""
        if not self.datum.isEnabled():
            return None, None
        text = self.epoch.text().strip()
        epoch = parse_number(text)
        if text and epoch is None:
            raise InputError(error("window.not_a_decimal_year", text=text))
        datum = self.datum.text().strip()
        return (None if self._datums_differ and not datum else datum), epoch

    @property
    def _height(self) -> str:
        return self.height.text().strip() if self.height.isEnabled() else ""

    @property
    def _content(self) -> ExportContent:
        return list(CONTENT_TITLES)[self.what.currentIndex()]

    @property
    def _trajectory_choice(self) -> TrajectoryChoice:
        choices = list(TRAJECTORY_TITLES)
        return choices[self.trajectory.currentIndex()] if self._content == "lines" else "given"

    @property
    def _file_format(self) -> str:
        return FILE_TYPES[self._content][self.form.currentIndex()]

    @property
    def _system_text(self) -> str:
        return system_text(self.system)

    def _show_fields(self) -> None:
        what = self._content
        on_map = what in ("lines", "targets")
        for field in (self.system, self.height, self.datum, self.epoch):
            self._rows.setRowVisible(field, on_map)
        self._rows.setRowVisible(self.trajectory, what == "lines")
        self._rows.setRowVisible(self.boresight, what not in ("trajectory", "corrected_trajectory"))
        self.form.clear()
        self.form.addItems([gettext(FORMAT_TITLES[ending]) for ending in FILE_TYPES[what]])
        self.form.setEnabled(len(FILE_TYPES[what]) > 1)
        self._check_input()
        self.adjustSize()

    def _on_typed(self) -> None:
        if self.system.findText(self.system.currentText()) >= 0 and not self.height.text():
            self._check_input()  # chosen, not typed
            return
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setEnabled(False)
        self._debounce.start()

    def _check_input(self) -> None:
        """Show the meaning of the coordinate settings, or the error in them."""
        self._debounce.stop()
        local = self._system_text == LOCAL_FRAME
        self.height.setEnabled(not local)
        for field in (self.datum, self.epoch):  # the lines already have this system
            field.setEnabled(not local and bool(self._system_text))
        good = bool(self.folder.text().strip())
        try:
            meaning = self._describe_coordinates()
            text = " ".join(map(_sentence, meaning))
            serious = any(isinstance(each, Message) and each.is_serious for each in meaning)
            role = "error" if serious else "muted"
        except LispacError as error:
            text, role, good = exception_text(error), "error", False
        self.message_label.setText(text)
        self.message_label.setProperty("role", role)
        self.message_label.style().unpolish(self.message_label)
        self.message_label.style().polish(self.message_label)
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setEnabled(good)

    def _describe_coordinates(self) -> Sequence[str | Message]:
        if self._content == "trajectory":
            return [trajectory_datum_note(self._project)]
        if self._content == "corrected_trajectory":
            return [
                *support_notes(pos_corrections(self._project)),
                trajectory_datum_note(self._project),
            ]
        return [*self._describe_trajectory(), *self._describe_system()]

    def _describe_trajectory(self) -> Sequence[Message]:
        if self._trajectory_choice == "given":
            return []
        if list(BORESIGHT_TITLES)[self.boresight.currentIndex()] == "prior":
            raise InputError(error("corrections.prior_boresight"))
        return support_notes(pos_corrections(self._project))

    def _describe_system(self) -> Sequence[str | Message]:
        local = [
            gettext(
                "The coordinates are north, west and up, in metres from the origin of the project"
            )
        ]
        if self._content == "planes":
            return local
        height = self._height
        found = output_system_of(
            self._project, self._trajectory, self._system_text, height, *self._datum_and_epoch()
        )
        if found is None:
            return local
        assumptions = found.assumptions or (found.name,)
        return [*assumptions, note("export.epoch")]

    def _browse(self) -> None:
        chosen = QFileDialog.getExistingDirectory(
            self, gettext("Export folder"), self.folder.text()
        )
        if chosen:
            self.folder.setText(chosen)


def _sentence(text: str | Message) -> str:
    return message_text(text) if isinstance(text, Message) else f"{text}."
