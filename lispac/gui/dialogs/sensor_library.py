"""The library of sensors: all of them in a table with their sources, and one's own to edit."""

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
from lispac.gui import units
from lispac.gui.dialogs.import_files.sensor_choice import SOLUTIONS
from lispac.gui.dialogs.sensor_editor import NEW_POS, NEW_SCANNER, SensorEditor
from lispac.gui.language import say, say_all
from lispac.gui.panels import widgets
from lispac.io.sensor_file import Figures, PosFigures, PosState, ScannerFigures
from lispac.workflow.sensors import LONGEST, Sensor, library, origin_of, remove

HEADS = ("Sensor", "1 σ", "Source")
AnySensor = Sensor[ScannerFigures] | Sensor[PosFigures]


class SensorLibraryPage(QWidget):
    """Adds, copies, edits and removes at once: each sensor is a file.

    Parameters
    ----------
    folder : of the user's own sensors
    """

    changed = Signal()

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder = folder
        self._sensors: list[AnySensor] = []
        layout = widgets.column(self, 12)
        layout.addWidget(
            widgets.label(
                "What makers state of their instruments, one standard deviation. Where it says so, "
                "hold the figures against the data sheet of yours.",
                "muted", wrap=True,
            )
        )  # fmt: skip
        self.table = QTableWidget(0, len(HEADS))
        self.table.setTabKeyNavigation(False)
        self.table.setObjectName("sensor_table")
        self.table.setAccessibleName(say("Sensors"))
        self.table.setHorizontalHeaderLabels(say_all(HEADS))
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
        self.said = widgets.label("", "error", wrap=True, name="sensor_said")
        layout.addWidget(self.said)
        layout.addLayout(self._buttons())
        self.table.itemSelectionChanged.connect(self._enable)
        self.table.itemDoubleClicked.connect(lambda _item: self._edit() if self._own else None)
        self._fill()

    @property
    def current(self) -> AnySensor | None:
        """The sensor that is selected."""
        row = self.table.currentRow()
        return self._sensors[row] if 0 <= row < len(self._sensors) else None

    def select(self, name: str) -> None:
        """Select a sensor by its name."""
        names = [sensor.name for sensor in self._sensors]
        if name in names:
            self.table.setCurrentCell(names.index(name), 0)

    @property
    def _own(self) -> bool:
        return self.current is not None and self.current.own

    def _buttons(self) -> QHBoxLayout:
        self.add_scanner = widgets.button("Add scanner…", "sensor_add_scanner")
        self.add_pos = widgets.button("Add INS/GNSS…", "sensor_add_pos")
        self.copy = widgets.button(
            "Copy…", "sensor_copy", tip="A sensor of your own that begins with these figures"
        )
        self.edit = widgets.button("Edit…", "sensor_edit", tip="Your own only; copy the others")
        self.remove = widgets.button("Remove…", "sensor_remove", tip="Your own only")
        row = QHBoxLayout()
        for each, slot in (
            (self.add_scanner, lambda: self._ask(NEW_SCANNER)),
            (self.add_pos, lambda: self._ask(NEW_POS)),
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
        found = library(self._folder)
        self._sensors = [*found.scanners, *found.pos]
        self.said.setText("\n".join(say(remark) for remark in found.remarks))
        self.said.setVisible(bool(found.remarks))
        self.table.setRowCount(len(self._sensors))
        for row, sensor in enumerate(self._sensors):
            sigmas, source = told(sensor.figures)
            title = sensor.figures.title + (say(" (your own)") if sensor.own else "")
            for column, text in enumerate((title, sigmas, source)):
                item = QTableWidgetItem(text)
                item.setTextAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
                item.setToolTip(widgets.plain_tip(text))
                self.table.setItem(row, column, item)
        self.select(name)
        self._enable()

    def _enable(self) -> None:
        self.copy.setEnabled(self.current is not None)
        self.edit.setEnabled(self._own)
        self.remove.setEnabled(self._own)

    def _copy(self) -> None:
        if self.current is not None:
            figures = self.current.figures
            ending = say(" (own)")
            self._ask(replace(figures, title=figures.title[: LONGEST - len(ending)] + ending))

    def _edit(self) -> None:
        if self.current is not None:
            self._ask(self.current.figures, self.current.name)

    def _remove(self) -> None:
        if self.current is None or not self._sure(self.current.figures.title):
            return
        try:
            remove(self._folder, self.current)
        except InputError as error:
            self.said.setText(say(str(error)))
            self.said.show()
            return
        row = self.table.currentRow()
        self._fill()
        self.table.setCurrentCell(min(row, len(self._sensors) - 1), 0)
        self.table.setFocus()
        self.changed.emit()

    def _sure(self, title: str) -> bool:
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC", say(f"Remove {title} from the library?"),
            QMessageBox.StandardButton.Cancel, self,
        )  # fmt: skip
        box.setObjectName("remove_sensor")
        box.setInformativeText(
            say(
                "Its figures go for good, also where the settings are cancelled. "
                "Projects keep theirs."
            )
        )
        sure = box.addButton(say("Remove"), QMessageBox.ButtonRole.DestructiveRole)
        box.setDefaultButton(QMessageBox.StandardButton.Cancel)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        return chosen is sure

    def _ask(self, figures: Figures, name: str = "") -> None:
        editor = SensorEditor(self._folder, figures, name, self)
        if editor.exec() == QDialog.DialogCode.Accepted:
            self._fill(editor.name)
            self.changed.emit()
        editor.deleteLater()


def told(figures: Figures) -> tuple[str, str]:
    """The sigmas and where they are from, a line for each GNSS solution."""
    if isinstance(figures, ScannerFigures):
        return (
            units.signs(
                say(
                    f"range {units.figure(1000 * figures.range_sigma, 'mm', '.1f')} mm, direction "
                    f"{units.figure(figures.angle_sigma_deg, '°', '.4f')}°, "
                    f"beam {figures.divergence_mrad:.2f} mrad"
                ),
                "mm",
                "°",
            ),
            origin_of(figures, say),
        )
    return (
        "\n".join(f"{say(SOLUTIONS[each.name])}: {_sigmas(each)}" for each in figures.states),
        "\n".join(
            f"{say(SOLUTIONS[each.name])}: {origin_of(each, say)}" for each in figures.states
        ),
    )


def _sigmas(state: PosState) -> str:
    position = " / ".join(say(units.figure(value, "m", ".3f")) for value in state.position_sigma)
    attitude = " / ".join(
        say(units.figure(value, "°", ".3f")) for value in state.attitude_sigma_deg
    )
    return units.signs(f"{position} m, {attitude}°", "m", "°")
