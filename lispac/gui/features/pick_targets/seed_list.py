"""Dialogues for seeds from a list of coordinates: the list before, the result after."""

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
from lispac.geometry.frames import east_north_up
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.pick_targets.actions import ACTIONS
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.result_tables import local_amount
from lispac.gui.widgets.system_choice import CoordinateSystemFields
from lispac.language import N_, Plural, gettext
from lispac.present.tables import Column, cell_text, title_text
from lispac.present.targets.seeds import (
    ROLE_TEXTS,
    SEED_METRES,
    SEED_OUTCOMES_TABLE,
    SeedOutcomeRow,
)
from lispac.present.targets.sighting_quality import RANGE_METRES
from lispac.project import Project, Role
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.calibration.seed_lists import ListedSeed, SeedList, SeedOutcome, read_seeds
from lispac.workflow.project.coordinates import distances_from_trajectory

SEED_COLUMN_TITLES = (
    N_("Name"), N_("Role"), N_("East (m)"), N_("North (m)"), N_("Up (m)"),
    N_("Distance from trajectory (m)"), N_("Note"),
)  # fmt: skip
ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class SeedListDialog(QDialog):
    """Dialogue with the seeds of a list, from which the user ticks those to pick."""

    def __init__(
        self,
        path: Path,
        project: Project,
        trajectory: LocalTrajectory,
        search_text: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("seed_list_dialog")
        self.setWindowTitle(f"{dialog_title(ACTIONS['seed_list'])} – {path.name}")
        self.resize(900, 560)
        self._path, self._project, self._trajectory = path, project, trajectory
        self._read: SeedList | None = None
        layout = widgets.vertical_layout(self, 16)
        introduction = widgets.label(wrap=True)
        roles = gettext(
            "If the list gives no role, a name that begins with V means a validation plane and "
            "any other name means a target."
        )
        introduction.setText(f"{search_text}\n{roles}")
        layout.addWidget(introduction)
        self.columns = QLineEdit()
        self.columns.setObjectName("list_columns")
        self.columns.setToolTip(
            gettext(
                "Columns from left to right: name, x, y, z, role, or - to skip a column. If this "
                "field is empty, the column names in the file apply, or the order name, x, y, z, "
                "role if it has none."
            )
        )
        self.columns.setPlaceholderText(
            gettext("Column names in the file, otherwise name, x, y, z, role")
        )
        self.choice = CoordinateSystemFields(project, trajectory, "list", self)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        form.addRow(gettext("Columns"), self.columns)
        self.choice.add_to(form)
        layout.addLayout(form)
        self.table = _create_table(
            "seed_list_table",
            gettext("Seeds of the list"),
            [gettext(title) for title in SEED_COLUMN_TITLES],
        )
        self.table.itemChanged.connect(lambda _item: self._show_count())
        layout.addWidget(self.table, 1)
        self.message_label = widgets.label("", "muted", wrap=True, name="list_message")
        layout.addWidget(self.message_label)
        self.pick_button = widgets.button("", "pick_list", primary=True)
        self.pick_button.setDefault(True)
        self.pick_button.clicked.connect(self.accept)
        cancel = widgets.button(
            gettext("Cancel"), "cancel_list", tip=gettext("Close without searching for targets")
        )
        cancel.clicked.connect(self.reject)
        cancel.setAutoDefault(False)  # Enter starts the search, wherever the focus is
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.pick_button, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        self.choice.changed.connect(self._read_list)
        self.columns.textChanged.connect(self._read_list)
        self._read_list()

    @property
    def ticked_entries(self) -> tuple[ListedSeed, ...]:
        """Seeds chosen to be picked."""
        seeds = () if self._read is None else self._read.seeds
        checked = Qt.CheckState.Checked
        return tuple(
            seed
            for row, seed in enumerate(seeds)
            if self.table.item(row, 0).checkState() == checked
        )

    def _read_list(self) -> None:
        """Read the list with the columns and the system of the fields."""
        self._read, role = None, "error"
        columns = self.columns.text().replace(",", " ").split()
        if self.choice.waiting:
            role, text = "muted", ""
        elif self.choice.problem is not None:
            text = exception_text(self.choice.problem)
        else:
            try:
                self._read = read_seeds(
                    self._path, self._project, self._trajectory, self.choice.system, columns=columns
                )
                role, text = "muted", " ".join(map(message_text, self._read.notes))
            except LispacError as error:
                text = exception_text(error)
        self.message_label.setText(text)
        self.message_label.setProperty("role", role)
        self.message_label.style().unpolish(self.message_label)
        self.message_label.style().polish(self.message_label)
        self._fill()

    def _fill(self) -> None:
        seeds = () if self._read is None else self._read.seeds
        self.table.blockSignals(True)
        self.table.setRowCount(len(seeds))
        if seeds:
            distances = distances_from_trajectory(
                np.array([seed.place for seed in seeds]), self._trajectory
            )
        for row, seed in enumerate(seeds):
            name = _name_item(seed.name, seed.role)
            name.setFlags(name.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            name.setCheckState(Qt.CheckState.Unchecked if seed.exists else Qt.CheckState.Checked)
            name.setToolTip(gettext("Row {row:n} of the list; untick to exclude", row=seed.row))
            numbers = [
                *map(SEED_METRES.text, east_north_up(seed.place)),
                RANGE_METRES.text(distances[row]),
            ]
            comment = (
                gettext("A target with this name exists; tick to replace it") if seed.exists else ""
            )
            _set_row(self.table, row, name, seed.role, numbers, comment)
        self.table.blockSignals(False)
        self._show_count()

    def _show_count(self) -> None:
        ticked, rows = len(self.ticked_entries), self.table.rowCount()
        self.pick_button.setText(
            gettext("Search at {ticked:n} of {total:n} seeds", ticked=ticked, total=rows)
            if rows
            else gettext("Search at seeds")
        )
        self.pick_button.setEnabled(ticked > 0)


class SeedsFoundDialog(QDialog):
    """Dialogue that shows which seeds of a list led to a target."""

    def __init__(self, outcomes: Sequence[SeedOutcome], lines: int, parent: QWidget | None) -> None:
        super().__init__(parent)
        self.setObjectName("seeds_found_dialog")
        self.setWindowTitle(gettext("Targets found from seeds"))
        self.resize(860, 520)
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(widgets.label(_summary(outcomes), wrap=True, name="seeds_found"))
        columns = SEED_OUTCOMES_TABLE.columns[1:]
        heads = [*(title_text(column.title) for column in columns), gettext("Note")]
        self.table = _create_table(
            "seeds_found_table", title_text(SEED_OUTCOMES_TABLE.title), heads
        )
        self.table.setRowCount(len(outcomes))
        for k, row in enumerate(outcome.row(lines) for outcome in outcomes):
            _set_row(
                self.table, k, _name_item(row.name, row.role), row.role,
                [_number_text(column, row) for column in columns[2:]],
                "\n".join(row.notes),
            )  # fmt: skip
        layout.addWidget(self.table, 1)
        close = widgets.button(gettext("Close"), "close_found", primary=True)
        close.setDefault(True)
        close.clicked.connect(self.accept)
        row_of_buttons = QHBoxLayout()
        row_of_buttons.addStretch(1)
        row_of_buttons.addWidget(close)
        layout.addLayout(row_of_buttons)


def _summary(outcomes: Sequence[SeedOutcome]) -> str:
    """Text on the number of seeds that led to a target, and on undo."""
    found, total = sum(outcome.target is not None for outcome in outcomes), len(outcomes)
    if not found:
        return gettext(
            Plural(
                "No target was found at the seed. Check its coordinates and their system.",
                "No target was found at any of {count:n} seeds. Check their coordinates and the "
                "coordinate system.",
            ),
            count=total,
        )
    return gettext(
        Plural(
            "Targets found: {found:n} (from {count:n} seed). One undo step removes the target.",
            "Targets found: {found:n} (from {count:n} seeds). One undo step removes all of them.",
        ),
        found=found,
        count=total,
    )


def _number_text(column: Column[SeedOutcomeRow], row: SeedOutcomeRow) -> str:
    """Text of a cell, with a length in the unit of the user."""
    value, form = column.value_of(row), column.format_of(row)
    if value is None or form is None or form.unit != "mm":
        return cell_text(column, row)
    return local_amount(value, form)


def _create_table(name: str, title: str, heads: Sequence[str]) -> QTableWidget:
    table = QTableWidget(0, len(heads))
    table.setTabKeyNavigation(False)
    table.setObjectName(name)
    table.setAccessibleName(title)
    table.setHorizontalHeaderLabels(heads)
    header = table.horizontalHeader()
    header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    for column in range(2, len(heads) - 1):
        table.horizontalHeaderItem(column).setTextAlignment(ALIGN_RIGHT)
    table.verticalHeader().hide()
    table.setShowGrid(False)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setProperty("rows", True)  # no frame around a single cell, which would look like a button
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(len(heads) - 1, QHeaderView.ResizeMode.Stretch)
    table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    table.setStyleSheet("QTableWidget::item { padding: 4px 6px; }")
    return table


def _name_item(name: str, role: Role) -> QTableWidgetItem:
    colour = theme.TARGET_COLOUR if role == "target" else theme.VALIDATION_COLOUR
    return QTableWidgetItem(theme.swatch(colour), name)


def _set_row(
    table: QTableWidget, row: int, name: QTableWidgetItem, role: Role, numbers: Sequence[str],
    comment: str,
) -> None:  # fmt: skip
    items = [QTableWidgetItem(text) for text in numbers]
    for item in items:
        item.setTextAlignment(ALIGN_RIGHT)
        item.setFont(theme.tabular_font(table.font()))
    last = QTableWidgetItem(comment)
    last.setToolTip(widgets.plain_tip(comment))
    for column, item in enumerate(
        (name, QTableWidgetItem(gettext(ROLE_TEXTS[role])), *items, last)
    ):
        table.setItem(row, column, item)
