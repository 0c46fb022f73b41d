"""Seeds from a list of coordinates: what is read before, and what was found after."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QFormLayout,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.errors import LispacError
from lispac.gui import theme
from lispac.gui.dialogs.system_choice import SystemChoice
from lispac.gui.language import say, say_all, say_message, say_sentences
from lispac.gui.panels import widgets
from lispac.language import gettext
from lispac.project import Project, Role
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.coordinates import away
from lispac.workflow.seed_lists import ListedSeed, Outcome, SeedList, read_seeds

ROLES: dict[Role, str] = {"target": "Target", "validation": "Validation plane"}
READ = ("Name", "Role", "North (m)", "West (m)", "Up (m)", "Off the track (m)", "Remark")
FOUND = ("Name", "Role", "Lines", "Points", "Remark")
Right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class SeedListDialog(QDialog):
    """Shows what is read from a list, to be ticked in; nothing is sought before that."""

    def __init__(
        self,
        path: Path,
        project: Project,
        trajectory: LocalTrajectory,
        how: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("seed_list_dialog")
        self.setWindowTitle(say(f"Seeds from {path.name}"))
        self.resize(900, 560)
        self._path, self._project, self._trajectory = path, project, trajectory
        self._read: SeedList | None = None
        layout = widgets.column(self, 16)
        layout.addWidget(
            widgets.label(
                f"{how} The role is that of the list, or goes by the name: what begins with V is a "
                "validation plane.",
                wrap=True,
            )
        )
        self.columns = QLineEdit()
        self.columns.setObjectName("list_columns")
        self.columns.setToolTip(
            say(
                "What the columns hold, from the left: name, x, y, z, role, and - for one "
                "that is not "
                "used. Empty: as the file names them, else in that order"
            )
        )
        self.columns.setPlaceholderText(say("As the file names them, else name, x, y, z, role"))
        self.choice = SystemChoice(project, trajectory, "list", self)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACE)
        form.addRow(say("Columns"), self.columns)
        self.choice.add_to(form)
        layout.addLayout(form)
        self.table = _table("seed_list_table", "Seeds that were read", READ)
        self.table.itemChanged.connect(lambda _item: self._count())
        layout.addWidget(self.table, 1)
        self.said = widgets.label("", "muted", wrap=True, name="list_said")
        layout.addWidget(self.said)
        self.pick_button = widgets.button("", "pick_list", primary=True)
        self.pick_button.setDefault(True)
        self.pick_button.clicked.connect(self.accept)
        cancel = widgets.button("Cancel", "cancel_list", tip="Pick nothing")
        cancel.clicked.connect(self.reject)
        cancel.setAutoDefault(False)  # Enter picks, wherever the focus is
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_order(self.pick_button, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        self.choice.changed.connect(self._look)
        self.columns.textChanged.connect(self._look)
        self._look()

    @property
    def ticked(self) -> tuple[ListedSeed, ...]:
        """Seeds that are to be picked."""
        seeds = () if self._read is None else self._read.seeds
        checked = Qt.CheckState.Checked
        return tuple(
            seed
            for row, seed in enumerate(seeds)
            if self.table.item(row, 0).checkState() == checked
        )

    def _look(self) -> None:
        """Read the list as the fields say."""
        self._read, role = None, "error"
        columns = self.columns.text().replace(",", " ").split()
        if self.choice.waiting:
            role, text = "muted", ""
        elif self.choice.problem is not None:
            text = say(str(self.choice.problem))
        else:
            try:
                self._read = read_seeds(
                    self._path, self._project, self._trajectory, self.choice.system, columns=columns
                )
                role, text = "muted", " ".join(say_sentences(self._read.notes))
            except LispacError as error:
                text = say(str(error))
        self.said.setText(text)
        self.said.setProperty("role", role)
        self.said.style().unpolish(self.said)
        self.said.style().polish(self.said)
        self._fill()

    def _fill(self) -> None:
        seeds = () if self._read is None else self._read.seeds
        self.table.blockSignals(True)
        self.table.setRowCount(len(seeds))
        if seeds:
            distances = away(np.array([seed.place for seed in seeds]), self._trajectory)
        for row, seed in enumerate(seeds):
            name = _name(seed.name, seed.role)
            name.setFlags(name.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            name.setCheckState(Qt.CheckState.Unchecked if seed.taken else Qt.CheckState.Checked)
            name.setToolTip(say(f"Row {seed.row} of the list; untick to leave it out"))
            numbers = [f"{value:.3f}" for value in seed.place] + [f"{distances[row]:.1f}"]
            remark = "Picked already; tick to replace" if seed.taken else ""
            _set_row(self.table, row, name, ROLES[seed.role], numbers, remark)
        self.table.blockSignals(False)
        self._count()

    def _count(self) -> None:
        count = len(self.ticked)
        rows = self.table.rowCount()
        self.pick_button.setText(say(f"Pick {count} of {rows}" if rows else "Pick"))
        self.pick_button.setEnabled(count > 0)


class SeedsFoundDialog(QDialog):
    """What came of the seeds of a list."""

    def __init__(self, outcomes: Sequence[Outcome], lines: int, parent: QWidget | None) -> None:
        super().__init__(parent)
        self.setObjectName("seeds_found_dialog")
        self.setWindowTitle(say("Seeds picked"))
        self.resize(860, 520)
        found = [outcome for outcome in outcomes if outcome.target is not None]
        text = f"{len(found)} of {len(outcomes)} seeds led to a target."
        if found:
            text += " One undo step takes all of them back."
        layout = widgets.column(self, 16)
        layout.addWidget(widgets.label(text, wrap=True, name="seeds_found"))
        self.table = _table("seeds_found_table", "What was found", FOUND)
        self.table.setRowCount(len(outcomes))
        for row, outcome in enumerate(outcomes):
            seed, target = outcome.seed, outcome.target
            if target is None:
                numbers, remarks = ["none", ""], [outcome.reason]
            else:
                points = sum(len(sighting.indices) for sighting in target.sightings)
                numbers = [f"{len(target.sightings)} of {lines}", f"{points:,}"]
                missing = [
                    gettext("Not on {line}: {reason}", line=line, reason=say_message(why))
                    for line, why in target.missing.items()
                ]
                remarks = [outcome.reason, *missing]
            _set_row(
                self.table, row, _name(seed.name, seed.role), ROLES[seed.role], numbers,
                "\n".join(remark for remark in remarks if remark),
            )  # fmt: skip
        layout.addWidget(self.table, 1)
        close = widgets.button("Close", "close_found", primary=True)
        close.setDefault(True)
        close.clicked.connect(self.accept)
        row_of_buttons = QHBoxLayout()
        row_of_buttons.addStretch(1)
        row_of_buttons.addWidget(close)
        layout.addLayout(row_of_buttons)


def _table(name: str, words: str, heads: Sequence[str]) -> QTableWidget:
    table = QTableWidget(0, len(heads))
    table.setTabKeyNavigation(False)
    table.setObjectName(name)
    table.setAccessibleName(say(words))
    table.setHorizontalHeaderLabels(say_all(list(heads)))
    header = table.horizontalHeader()
    header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    for column in range(2, len(heads) - 1):
        table.horizontalHeaderItem(column).setTextAlignment(Right)
    table.verticalHeader().hide()
    table.setShowGrid(False)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setProperty("rows", True)  # no frame about one cell: it looked like a button
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(len(heads) - 1, QHeaderView.ResizeMode.Stretch)
    table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    table.setStyleSheet("QTableWidget::item { padding: 4px 6px; }")
    return table


def _name(name: str, role: Role) -> QTableWidgetItem:
    colour = theme.TARGET_COLOUR if role == "target" else theme.VALIDATION_COLOUR
    return QTableWidgetItem(theme.swatch(colour), name)


def _set_row(
    table: QTableWidget, row: int, name: QTableWidgetItem, role: str, numbers: Sequence[str],
    remark: str,
) -> None:  # fmt: skip
    items = [QTableWidgetItem(say(number)) for number in numbers]
    for item in items:
        item.setTextAlignment(Right)
        item.setFont(theme.tabular(table.font()))
    last = QTableWidgetItem(say(remark))
    last.setToolTip(widgets.plain_tip(say(remark)))
    for column, item in enumerate((name, QTableWidgetItem(say(role)), *items, last)):
        table.setItem(row, column, item)
