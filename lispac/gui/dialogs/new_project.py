"""A new project: its files and what the user knows of the mounting."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import theme
from lispac.gui.panels import widgets
from lispac.project import LineSource, Settings

SELF_DESCRIBING = (".las", ".laz", ".e57", ".ply", ".pcd")
"""Endings of files that name their columns themselves."""
NEEDED_COLUMNS = ("time", "x", "y", "z")


@dataclass(frozen=True)
class NewProjectRequest:
    """What `create_project` is to be called with."""

    folder: Path
    trajectory: Path
    accuracy: Path | None
    lines: tuple[LineSource, ...]
    settings: Settings


class NewProjectDialog(QDialog):
    """Fields on one page; OK stays grey until they make sense, and says why."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("new_project_dialog")
        self.setWindowTitle("New project")
        self.setMinimumWidth(640)
        outer = QVBoxLayout(self)
        outer.setSpacing(12)
        outer.setContentsMargins(18, 16, 18, 14)
        outer.addLayout(self._files())
        outer.addWidget(_rule("Mounting"))
        outer.addLayout(self._mounting())
        outer.addWidget(_rule("Uncertainties"))
        outer.addLayout(self._uncertainties())
        self.reason = QLabel()
        self.reason.setObjectName("new_reason")
        self.reason.setWordWrap(True)
        self.reason.setProperty("role", "error")
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        self.ok.setText("Create project")
        self.ok.setObjectName("new_ok")
        self.ok.setProperty("primary", True)
        for standard in self.buttons.buttons():
            standard.setIcon(QIcon())
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        bottom = QHBoxLayout()
        bottom.addWidget(self.reason, 1)
        bottom.addWidget(self.buttons)
        outer.addLayout(bottom)
        self._align_labels()
        self._check()

    def add_lines(self, paths: Sequence[Path]) -> None:
        """Append scan files that are not in the list yet."""
        known = {self.lines.item(k).text() for k in range(self.lines.count())}
        for path in paths:
            if str(path) not in known:
                self.lines.addItem(str(path))
        self._check()

    def problem(self) -> str:
        """Why a project cannot be made of this; empty where it can."""
        if not self.folder.text().strip():
            return "Choose a folder for the project."
        if (Path(self.folder.text().strip()) / "project.json").exists():
            return "There is a project in this folder already."
        trajectory = self.trajectory.text().strip()
        if not trajectory:
            return "Choose the trajectory: SBET, or a text export."
        for field, what in ((self.trajectory, "trajectory"), (self.accuracy, "accuracy file")):
            name = field.text().strip()
            if name and not Path(name).is_file():
                return f"The {what} is not there: {name}"
        paths = self._paths()
        if not paths:
            return "Add the raw scan file of at least one line."
        gone = [path.name for path in paths if not path.is_file()]
        if gone:
            return f"A line's file is not there: {gone[0]}"
        stems = [path.stem for path in paths]
        twice = [stem for stem in stems if stems.count(stem) > 1]
        if twice:
            return f"Two lines are named {twice[0]}; give their files different names."
        if self._has_text():
            missing = [name for name in NEEDED_COLUMNS if name not in self._column_names()]
            if missing:
                return f"Name the columns of the text files; missing: {', '.join(missing)}."
        return ""

    def request(self) -> NewProjectRequest:
        """What the fields say."""
        accuracy = self.accuracy.text().strip()
        columns = self._column_names()
        lines = tuple(
            LineSource(path.stem, path, () if path.suffix.lower() in SELF_DESCRIBING else columns)
            for path in self._paths()
        )
        origin = self.origin.value() if self.origin_given.isChecked() else None
        settings = Settings(
            lever_arm=self.lever_arm.value(),
            boresight_deg=self.boresight.value(),
            origin_deg_m=origin,
            position_sigma=self.position_sigma.value(),
            attitude_sigma_deg=self.attitude_sigma.value(),
            lidar_sigma=self.lidar_sigma.value() / 1000,
        )
        return NewProjectRequest(
            folder=Path(self.folder.text().strip()),
            trajectory=Path(self.trajectory.text().strip()),
            accuracy=Path(accuracy) if accuracy else None,
            lines=lines,
            settings=settings,
        )

    def _files(self) -> QFormLayout:
        form = _form()
        self.folder = self._path_row(form, "Project folder", "new_folder", _ask_folder)
        self.trajectory = self._path_row(
            form,
            "Trajectory",
            "new_trajectory",
            _ask_file("Trajectory", "*.sbet *.out *.txt *.csv *.asc *.pos"),
        )
        self.accuracy = self._path_row(
            form, "Accuracy", "new_accuracy", _ask_file("Accuracy", "*.out *.smrmsg *.txt")
        )
        self.accuracy.setPlaceholderText("optional; else the sigmas below hold at all times")
        self.lines = QListWidget()
        self.lines.setObjectName("new_lines")
        self.lines.setAccessibleName("Scan files of the lines")
        self.lines.setFixedHeight(112)
        self.lines.setTextElideMode(Qt.TextElideMode.ElideLeft)
        add = widgets.button(
            "Add…",
            "new_add_lines",
            tip="LAS, LAZ, E57, PLY, PCD or text; in the scanner frame, or on the map with a "
            "coordinate system",
        )
        remove = widgets.button("Remove", "new_remove_lines")
        add.clicked.connect(self._add_lines)
        remove.clicked.connect(self._remove_lines)
        side = QVBoxLayout()
        side.addWidget(add)
        side.addWidget(remove)
        side.addStretch(1)
        row = QHBoxLayout()
        row.addWidget(self.lines, 1)
        row.addLayout(side)
        form.addRow("Lines", row)
        self.columns = QLineEdit("time x y z")
        self.columns.setObjectName("new_columns")
        self.columns.setToolTip(
            "Names of the columns of text files from the left: time (seconds), x, y, z (metres), "
            "intensity; any other name passes a column over"
        )
        self.columns.textChanged.connect(self._check)
        form.addRow("Text columns", self.columns)
        return form

    def _mounting(self) -> QFormLayout:
        form = _form()
        self.lever_arm = widgets.lever_arm_fields("new_lever_arm")
        self.boresight = widgets.boresight_fields("new_boresight")
        form.addRow("Lever arm", self.lever_arm)
        form.addRow("Prior boresight", self.boresight)
        self.origin_given = QCheckBox("Set the origin of the local frame")
        self.origin_given.setObjectName("new_origin_given")
        self.origin_given.setToolTip("Without it, the mean position of the trajectory is used")
        self.origin = widgets.Triple(
            ("Latitude", "Longitude", "Height"),
            [
                _plain("new_latitude", " °", 8, -90, 90),
                _plain("new_longitude", " °", 8, -180, 360),
                _plain("new_height", " m", 3, -1000, 10000),
            ],
        )
        self.origin.setEnabled(False)
        self.origin_given.toggled.connect(self.origin.setEnabled)
        form.addRow(" ", self.origin_given)
        form.addRow("Origin", self.origin)
        return form

    def _uncertainties(self) -> QFormLayout:
        form = _form()
        usual = Settings(lever_arm=(0.0, 0.0, 0.0))
        self.lidar_sigma = widgets.number(
            "new_lidar_sigma", suffix=" mm", decimals=1, low=0.1, high=1000, step=0.5,
            tip="Standard deviation of one LiDAR point on each axis, millimetres",
        )  # fmt: skip
        self.lidar_sigma.setValue(usual.lidar_sigma * 1000)
        self.lidar_sigma.setMaximumWidth(140)
        self.position_sigma = widgets.Triple(
            ("North", "East", "Down"),
            [_plain(f"new_sigma_{axis}", " m", 4, 0, 100) for axis in ("n", "e", "d")],
        )
        self.position_sigma.set_value(usual.position_sigma)
        self.attitude_sigma = widgets.Triple(
            ("Roll", "Pitch", "Heading"),
            [_plain(f"new_sigma_{axis}", " °", 4, 0, 90) for axis in ("roll", "pitch", "heading")],
        )
        self.attitude_sigma.set_value(usual.attitude_sigma_deg)
        form.addRow("LiDAR noise (1 σ)", self.lidar_sigma)
        form.addRow("Position (1 σ)", self.position_sigma)
        form.addRow("Attitude (1 σ)", self.attitude_sigma)
        return form

    def _align_labels(self) -> None:
        """One column of labels through all sections."""
        forms = self.findChildren(QFormLayout)
        labels = [
            item.widget()
            for form in forms
            for row in range(form.rowCount())
            if (item := form.itemAt(row, QFormLayout.ItemRole.LabelRole)) is not None
        ]
        widest = max(each.sizeHint().width() for each in labels)
        for each in labels:
            each.setMinimumWidth(widest)

    def _path_row(self, form: QFormLayout, words: str, name: str, ask) -> QLineEdit:
        field = QLineEdit()
        field.setObjectName(name)
        field.setAccessibleName(words)
        field.textChanged.connect(self._check)
        browse = widgets.button("Browse…", f"{name}_browse")
        browse.setAutoDefault(False)

        def chosen() -> None:
            path = ask(self, field.text())
            if path:
                field.setText(path)

        browse.clicked.connect(chosen)
        row = QHBoxLayout()
        row.addWidget(field, 1)
        row.addWidget(browse)
        form.addRow(words, row)
        return field

    def _add_lines(self) -> None:
        start = str(Path(self.trajectory.text()).parent) if self.trajectory.text() else ""
        names, _ = QFileDialog.getOpenFileNames(
            self, "Scan files of the lines", start,
            "Scans (*.las *.laz *.e57 *.ply *.pcd *.txt *.xyz *.csv *.asc *.gz);;All files (*)",
        )  # fmt: skip
        self.add_lines([Path(name) for name in names])

    def _remove_lines(self) -> None:
        for item in self.lines.selectedItems() or [self.lines.item(self.lines.count() - 1)]:
            if item is not None:
                self.lines.takeItem(self.lines.row(item))
        self._check()

    def _paths(self) -> list[Path]:
        return [Path(self.lines.item(k).text()) for k in range(self.lines.count())]

    def _has_text(self) -> bool:
        return any(path.suffix.lower() not in SELF_DESCRIBING for path in self._paths())

    def _column_names(self) -> tuple[str, ...]:
        return tuple(self.columns.text().lower().replace(",", " ").split())

    def _check(self) -> None:
        if not hasattr(self, "ok"):
            return
        problem = self.problem()
        self.reason.setText(problem)
        self.ok.setEnabled(not problem)
        self.columns.setEnabled(self._has_text())
        typed = not self.accuracy.text().strip()
        self.position_sigma.setEnabled(typed)
        self.attitude_sigma.setEnabled(typed)


def _form() -> QFormLayout:
    form = QFormLayout()
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    form.setHorizontalSpacing(14)
    form.setVerticalSpacing(theme.SPACE)
    return form


def _rule(text: str) -> QLabel:
    made = widgets.label(text, "heading")
    made.setIndent(0)
    made.setContentsMargins(0, 6, 0, 0)
    return made


def _plain(name: str, suffix: str, decimals: int, low: float, high: float):
    return widgets.number(
        name, suffix=suffix, decimals=decimals, low=low, high=high, step=10.0 ** (1 - decimals)
    )


def _ask_folder(parent: QWidget, start: str) -> str:
    return QFileDialog.getExistingDirectory(parent, "Project folder", start)


def _ask_file(what: str, endings: str):
    def ask(parent: QWidget, start: str) -> str:
        name, _ = QFileDialog.getOpenFileName(
            parent, what, start, f"{what} ({endings});;All files (*)"
        )
        return name

    return ask
