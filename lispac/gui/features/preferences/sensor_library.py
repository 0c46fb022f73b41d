"""Page with the sensor library: specifications, sources, editing of user-defined sensors."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QHBoxLayout,
    QHeaderView,
    QMessageBox,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance import units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.appearance.units import Base
from lispac.gui.features.preferences.sensor_editor import NEW_POS, NEW_SCANNER, SensorEditor
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.sensor_choice import SOLUTION_NAMES
from lispac.io.config.sensor_file import (
    PosAccuracy,
    PosSpecification,
    ScannerSpecification,
    SensorSpecification,
)
from lispac.language import N_, gettext
from lispac.workflow.planning.sensors import (
    MAX_TEXT_LENGTH,
    Sensor,
    read_library,
    remove_sensor,
    source_text,
)

COLUMN_TITLES = (N_("Sensor"), N_("Standard deviations (1 σ)"), N_("Source"))
AnySensor = Sensor[ScannerSpecification] | Sensor[PosSpecification]


class SensorLibraryPage(QWidget):
    """Table of sensors, with buttons to add, copy, edit and remove user-defined ones.

    Each user-defined sensor is a file, which is written at each edit.

    Parameters
    ----------
    folder : folder of the user-defined sensors
    """

    changed = Signal()

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder = folder
        self._sensors: list[AnySensor] = []
        layout = widgets.vertical_layout(self, 12)
        layout.addWidget(
            widgets.label(
                gettext(
                    "The standard deviations are those specified by the manufacturers. Check "
                    "values marked as not verified against the data sheet of your instrument."
                ),
                "muted",
                wrap=True,
            )
        )
        self.table = QTableWidget(0, len(COLUMN_TITLES))
        self.table.setTabKeyNavigation(False)
        self.table.setObjectName("sensor_table")
        self.table.setAccessibleName(gettext("Sensors"))
        self.table.setHorizontalHeaderLabels([gettext(head) for head in COLUMN_TITLES])
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.setWordWrap(True)
        header = self.table.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        tight, wide = QHeaderView.ResizeMode.ResizeToContents, QHeaderView.ResizeMode.Stretch
        for k, mode in enumerate((tight, tight, wide)):
            header.setSectionResizeMode(k, mode)
        layout.addWidget(self.table, 1)
        self.message_label = widgets.label("", "error", wrap=True, name="sensor_message")
        layout.addWidget(self.message_label)
        layout.addLayout(self._buttons())
        self.table.itemSelectionChanged.connect(self._enable_controls)
        self.table.itemDoubleClicked.connect(
            lambda _item: self._edit() if self._is_user_defined else None
        )
        self._fill()

    @property
    def current(self) -> AnySensor | None:
        """The selected sensor."""
        row = self.table.currentRow()
        return self._sensors[row] if 0 <= row < len(self._sensors) else None

    def select(self, name: str) -> None:
        """Select a sensor by its name."""
        names = [sensor.name for sensor in self._sensors]
        if name in names:
            self.table.setCurrentCell(names.index(name), 0)

    @property
    def _is_user_defined(self) -> bool:
        return self.current is not None and self.current.is_user_defined

    def _buttons(self) -> QHBoxLayout:
        self.add_scanner = widgets.button(gettext("Add scanner…"), "sensor_add_scanner")
        self.add_pos = widgets.button(gettext("Add INS/GNSS…"), "sensor_add_pos")
        self.copy = widgets.button(
            gettext("Copy…"), "sensor_copy",
            tip=gettext("Create a user-defined sensor with these specifications"),
        )  # fmt: skip
        self.edit = widgets.button(
            gettext("Edit…"), "sensor_edit",
            tip=gettext("Edit a user-defined sensor. To change another sensor, copy it first."),
        )  # fmt: skip
        self.remove = widgets.button(
            gettext("Remove…"), "sensor_remove", tip=gettext("Remove a user-defined sensor")
        )
        row = QHBoxLayout()
        for each, slot in (
            (self.add_scanner, lambda: self._open_editor(NEW_SCANNER)),
            (self.add_pos, lambda: self._open_editor(NEW_POS)),
            (self.copy, self._copy),
            (self.edit, self._edit),
            (self.remove, self._remove),
        ):
            each.setAutoDefault(False)
            each.clicked.connect(lambda _=False, slot=slot: slot())
            row.addWidget(each)
        row.addStretch(1)
        return row

    def _fill(self, name: str = "") -> None:
        found = read_library(self._folder)
        self._sensors = [*found.scanners, *found.pos]
        self.message_label.setText("\n".join(message_text(each) for each in found.messages))
        self.message_label.setVisible(bool(found.messages))
        self.table.setRowCount(len(self._sensors))
        for row, sensor in enumerate(self._sensors):
            sigmas, source = sensor_texts(sensor.figures)
            title = sensor.figures.title
            if sensor.is_user_defined:
                title = gettext("{sensor} (user-defined)", sensor=title)
            for column, text in enumerate((title, sigmas, source)):
                item = QTableWidgetItem(text)
                item.setTextAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
                item.setToolTip(widgets.plain_tip(text))
                self.table.setItem(row, column, item)
        self.select(name)
        self._enable_controls()

    def _enable_controls(self) -> None:
        self.copy.setEnabled(self.current is not None)
        self.edit.setEnabled(self._is_user_defined)
        self.remove.setEnabled(self._is_user_defined)

    def _copy(self) -> None:
        if self.current is not None:
            figures = self.current.figures
            excess = max(
                len(gettext("{sensor} (user-defined)", sensor=figures.title)) - MAX_TEXT_LENGTH, 0
            )
            title = figures.title[: len(figures.title) - excess]
            self._open_editor(
                replace(figures, title=gettext("{sensor} (user-defined)", sensor=title))
            )

    def _edit(self) -> None:
        if self.current is not None:
            self._open_editor(self.current.figures, self.current.name)

    def _remove(self) -> None:
        if self.current is None or not self._confirm_deletion(self.current.figures.title):
            return
        try:
            remove_sensor(self._folder, self.current)
        except InputError as error:
            self.message_label.setText(exception_text(error))
            self.message_label.show()
            return
        row = self.table.currentRow()
        self._fill()
        self.table.setCurrentCell(min(row, len(self._sensors) - 1), 0)
        self.table.setFocus()
        self.changed.emit()

    def _confirm_deletion(self, title: str) -> bool:
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC",
            gettext("Remove {sensor} from the library?", sensor=title),
            QMessageBox.StandardButton.Cancel, self,
        )  # fmt: skip
        box.setObjectName("remove_sensor")
        box.setInformativeText(
            gettext(
                "The sensor is removed permanently, even if you cancel the settings. Projects "
                "that use the sensor keep its specifications."
            )
        )
        remove = box.addButton(gettext("Remove"), QMessageBox.ButtonRole.DestructiveRole)
        box.setDefaultButton(QMessageBox.StandardButton.Cancel)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        return chosen is remove

    def _open_editor(self, figures: SensorSpecification, name: str = "") -> None:
        editor = SensorEditor(self._folder, figures, name, self)
        if editor.exec() == QDialog.DialogCode.Accepted:
            self._fill(editor.name)
            self.changed.emit()
        editor.deleteLater()


def sensor_texts(figures: SensorSpecification) -> tuple[str, str]:
    """Texts of the standard deviations and of their sources, a line for each solution."""
    if isinstance(figures, ScannerSpecification):
        text = gettext(
            "range {range}, direction {direction}, divergence {divergence:x.2} mrad",
            range=_values_text([1000 * figures.range_sigma], "mm", ".1f"),
            direction=_values_text([figures.angle_sigma_deg], "°", ".4f"),
            divergence=figures.divergence_mrad,
        )
        return text, source_text(figures)
    named = [(gettext(SOLUTION_NAMES[each.name]), each) for each in figures.states]
    sigmas = [
        gettext("{solution}: {text}", solution=solution, text=_sigmas_text(state))
        for solution, state in named
    ]
    sources = [
        gettext("{solution}: {text}", solution=solution, text=source_text(state))
        for solution, state in named
    ]
    return "\n".join(sigmas), "\n".join(sources)


def _sigmas_text(state: PosAccuracy) -> str:
    position = _values_text(state.position_sigma, "m", ".3f")
    return f"{position}, {_values_text(state.attitude_sigma_deg, '°', '.3f')}"


def _values_text(values: Sequence[float], base: Base, form: str) -> str:
    """Values in the unit that the user has chosen: ``0.010 / 0.010 / 0.020 m``."""
    sign = units.shown_unit(base).sign
    text = " / ".join(units.localised(units.figure(value, base, form)) for value in values)
    return text + (sign if sign in "°′″" else f"\N{NO-BREAK SPACE}{sign}")
