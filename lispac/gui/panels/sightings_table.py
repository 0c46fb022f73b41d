"""Targets by lines: points and RMS of every sighting, and which of them take part."""

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QBrush, QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView

from lispac.gui import theme, units
from lispac.gui.language import say, say_message
from lispac.gui.panels import widgets
from lispac.messages import note
from lispac.project import PickedSighting, Project, Target
from lispac.targets.quality import SightingQuality
from lispac.workflow.survey import Survey

Role = Qt.ItemDataRole
Index = QModelIndex | QPersistentModelIndex
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
EDITED = "\N{LOWER RIGHT PENCIL}"
_EMPTY = "No targets yet. Hold Ctrl and click a target in the view: one row for each appears here."
_NAME_TIP = "Tick to let the whole target take part"


class SightingsModel(QAbstractTableModel):
    """First column the target, then one for each line; the last row is for whole lines."""

    target_used = Signal(str, bool)
    line_used = Signal(str, bool)
    sighting_used = Signal(str, str, bool)

    def __init__(self) -> None:
        super().__init__()
        self._project: Project | None = None
        self._heading: dict[str, float] = {}
        self._qualities: Mapping[tuple[str, str], SightingQuality] = {}
        self._lines: list[str] = []
        self._colours: dict[str, tuple[int, int, int]] = {}

    def show_project(self, project: Project | None, survey: Survey | None) -> None:
        """Show another value."""
        self.beginResetModel()
        self._project = project
        self._lines = [] if project is None else [line.name for line in project.lines]
        self._colours = theme.line_colours(self._lines)
        self._heading = {} if survey is None else dict(survey.heading)
        self.endResetModel()

    def show_qualities(self, qualities: Mapping[tuple[str, str], SightingQuality]) -> None:
        """Show how good the sightings are, by the names of target and line."""
        self._qualities = qualities
        if self.rowCount():
            last = self.index(self.rowCount() - 1, self.columnCount() - 1)
            self.dataChanged.emit(self.index(0, 0), last)

    def key(self, index: Index) -> tuple[str, str] | None:
        """(target, line) of a cell; line "" for the name's column."""
        if not index.isValid() or index.row() >= len(self._targets):
            return None
        line = "" if index.column() == 0 else self._lines[index.column() - 1]
        return self._targets[index.row()].name, line

    def row_of(self, name: str) -> int | None:
        """Row of a target."""
        return next((k for k, t in enumerate(self._targets) if t.name == name), None)

    def column_of(self, line: str) -> int:
        """Column of a line; that of the names where there is no such line."""
        return 1 + self._lines.index(line) if line in self._lines else 0

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        """One for each target, and one for the lines where any is adjusted."""
        targets = len(self._targets)
        return 0 if parent.isValid() or not targets else targets + bool(self._adjusted)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """One for the names, and one for each line."""
        return 0 if parent.isValid() else len(self._lines) + 1

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        """Name of a line with its heading, and its colour."""
        said = _said(self._head(section, orientation, role))
        tip = role == Role.ToolTipRole and said is not None
        return widgets.plain_tip(units.signs(said, "mm", figures=False)) if tip else said

    def _head(self, section: int, orientation: Qt.Orientation, role: int) -> Any:
        if orientation == Qt.Orientation.Vertical:
            return None
        if role == Role.TextAlignmentRole:
            return _LEFT if section == 0 else _RIGHT
        if section == 0:
            return "Target" if role == Role.DisplayRole else None
        line = self._lines[section - 1]
        heading = self._heading.get(line)
        if role == Role.DisplayRole:
            return line if heading is None else f"{line}  {round(heading * 57.29578) % 360}°"
        if role == Role.DecorationRole:
            return theme.swatch(self._colours[line])
        if role == Role.ToolTipRole:
            return f"{line}: points and RMS about the sighting's own plane, in millimetres"
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """What can be ticked."""
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if index.row() == len(self._targets):
            on_line = index.column() > 0 and self._on_line(self._lines[index.column() - 1])
            return flags | Qt.ItemFlag.ItemIsUserCheckable if on_line else flags
        if index.column() == 0 or self._sighting(index) is not None:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def data(self, index: Index, role: int = Role.DisplayRole) -> Any:
        """What a cell shows."""
        said = _said(self._of(index, role))
        is_tip = role == Role.ToolTipRole and said is not None
        return widgets.plain_tip(said) if is_tip else said

    def _of(self, index: Index, role: int) -> Any:
        if index.row() == len(self._targets):
            return self._of_line(index.column(), role)
        target = self._targets[index.row()]
        if index.column() == 0:
            return _of_name(target, role)
        line = self._lines[index.column() - 1]
        sighting = target.sighting(line)
        if role == Role.TextAlignmentRole:
            return _RIGHT if sighting is not None else Qt.AlignmentFlag.AlignCenter
        if sighting is None:
            return _of_missing(target, line, role)
        return self._of_sighting(target, sighting, role)

    def setData(self, index: Index, value: Any, role: int = Role.EditRole) -> bool:
        """Take over a tick."""
        if role != Role.CheckStateRole:
            return False
        used = Qt.CheckState(value) == Qt.CheckState.Checked
        if index.row() == len(self._targets) and index.column() > 0:
            self.line_used.emit(self._lines[index.column() - 1], used)
            return True
        key = self.key(index)
        if key is None:
            return False
        if key[1]:
            self.sighting_used.emit(*key, used)
        else:
            self.target_used.emit(key[0], used)
        return True

    @property
    def _targets(self) -> tuple[Target, ...]:
        return () if self._project is None else self._project.targets

    @property
    def _adjusted(self) -> tuple[Target, ...]:
        return tuple(target for target in self._targets if target.role == "target")

    def _on_line(self, line: str) -> list[PickedSighting]:
        """Sightings of adjustment targets on a line."""
        found = (target.sighting(line) for target in self._adjusted)
        return [sighting for sighting in found if sighting is not None]

    def _of_line(self, column: int, role: int) -> Any:
        if column == 0:
            words = {
                Role.DisplayRole: "Whole line",
                Role.ToolTipRole: "Untick a line to leave out all targets on it",
                Role.ForegroundRole: QBrush(QColor(theme.MUTED)),
            }
            return words.get(Role(role))
        line = self._lines[column - 1]
        sightings = self._on_line(line)
        used = sum(sighting.used for sighting in sightings)
        if role == Role.TextAlignmentRole:
            return _RIGHT if sightings else Qt.AlignmentFlag.AlignCenter
        if role == Role.DisplayRole:
            return f"{used} of {len(sightings)} used" if sightings else "–"
        if role == Role.ForegroundRole:
            return QBrush(QColor(theme.MUTED))
        if role == Role.CheckStateRole and sightings:
            if 0 < used < len(sightings):
                return Qt.CheckState.PartiallyChecked
            return Qt.CheckState.Checked if used else Qt.CheckState.Unchecked
        if role == Role.ToolTipRole and sightings:
            return f"{line}: untick to leave out every target on it, tick to use them all"
        return None

    def _sighting(self, index: Index) -> PickedSighting | None:
        return self._targets[index.row()].sighting(self._lines[index.column() - 1])

    def _of_sighting(self, target: Target, sighting: PickedSighting, role: int) -> Any:
        used = target.used and sighting.used
        quality = self._qualities.get((target.name, sighting.line))
        if role == Role.DisplayRole:
            light = "   poor" if quality is not None and quality.light == "poor" else ""
            edited = f" {EDITED}" if sighting.by_hand else ""
            return f"{len(sighting.indices):,}   {_mm(sighting.rms)}{light}{edited}"
        if role == Role.DecorationRole and quality is not None:
            return theme.light(quality.light)
        if role == Role.CheckStateRole:
            return Qt.CheckState.Checked if sighting.used else Qt.CheckState.Unchecked
        if role == Role.ForegroundRole and not used:
            return QBrush(QColor(theme.DISABLED))
        if role == Role.ToolTipRole:
            return self._tip(target, sighting)
        return None

    def _tip(self, target: Target, sighting: PickedSighting) -> str:
        lines = [
            f"{target.name} on {sighting.line}: {len(sighting.indices):,} points, "
            f"{_mm(sighting.rms)} RMS about their own plane"
        ]
        if (quality := self._qualities.get((target.name, sighting.line))) is not None:
            lines += [quality_words(quality)]
        if sighting.by_hand:
            lines.append(f"{EDITED} Points edited with the lasso; they stay as they were chosen")
        if sighting.one_in > 1:
            lines.append(f"Drawn from one in {sighting.one_in} of the many points about the seed")
        result = None if self._project is None else self._project.result
        for residual in () if result is None else result.sightings:
            if (residual.sighting.target, residual.sighting.line) == (target.name, sighting.line):
                lines.append(
                    f"Distance to the adjusted plane: {_mm(residual.rms_before)} RMS "
                    f"before, {_mm(residual.rms_after)} after"
                )
        lines.append("Untick to leave this sighting out")
        return "\n".join(lines)


class SightingsTable(QTableView):
    """The table; a selected cell tells which sighting it is."""

    sighting_selected = Signal(str, str)

    def __init__(self) -> None:
        super().__init__()
        self.setTabKeyNavigation(False)
        self.setObjectName("sightings_table")
        self.setAccessibleName(say("Targets by lines"))
        self.sightings = SightingsModel()
        self.setModel(self.sightings)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setAlternatingRowColors(True)
        self.setFont(theme.tabular(self.font()))
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(26)
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.horizontalHeader().setMinimumSectionSize(110)
        self.selectionModel().currentChanged.connect(self._moved)

    def show_project(self, project: Project | None, survey: Survey | None) -> None:
        """Show another value; the selected cell stays selected where it still is."""
        key = self.sightings.key(self.currentIndex())
        place = self.currentIndex()
        row, column = place.row(), place.column()
        self.sightings.show_project(project, survey)
        if key is not None and self.sightings.row_of(key[0]) == row:
            self._set_current(row, column)

    def select(self, name: str) -> None:
        """Select a target's row by its name, without telling anyone."""
        row = self.sightings.row_of(name)
        key = self.sightings.key(self.currentIndex())
        if row is not None and (key is None or key[0] != name):
            self._set_current(row, 0)

    def go_to(self, name: str, line: str) -> None:
        """Select the cell of a sighting, without telling anyone, and scroll to it."""
        row = self.sightings.row_of(name)
        if row is not None:
            column = self.sightings.column_of(line)
            self._set_current(row, column)
            self.scrollTo(self.sightings.index(row, column))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the table, or what to do for one."""
        super().paintEvent(event)
        if self.sightings.rowCount() == 0:
            painter = QPainter(self.viewport())
            painter.setPen(QColor(theme.MUTED))
            area = self.viewport().rect().adjusted(16, 8, -16, -8)
            painter.drawText(
                area, Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, say(_EMPTY)
            )
            painter.end()

    def _set_current(self, row: int, column: int) -> None:
        self.selectionModel().blockSignals(True)
        self.selectionModel().setCurrentIndex(
            self.sightings.index(row, column), QItemSelectionModel.SelectionFlag.ClearAndSelect
        )
        self.selectionModel().blockSignals(False)
        self.viewport().update()

    def _moved(self, current: QModelIndex, _previous: QModelIndex) -> None:
        key = self.sightings.key(current)
        if key is not None:
            self.sighting_selected.emit(*key)


def _mm(metres: float) -> str:
    return units.amount(1000 * metres, "mm", ".1f")


def quality_words(quality: SightingQuality) -> str:
    """The light, its reasons and the figures behind them, a line each."""
    figures = [f"range {units.amount(quality.range, 'm', '.1f')}"]
    if quality.density is not None:
        figures.append(f"{quality.density:,.0f} points per m²")
    if quality.incidence is not None:
        figures.append(f"{quality.incidence * 57.29578:.0f}° from the normal")
    if quality.extent is not None:
        wide, high = quality.extent
        figures.append(f"{units.figure(wide, 'm', '.2f')} × {units.amount(high, 'm', '.2f')}")
    if quality.share_shown is not None:
        figures.append(f"{100 * quality.share_shown:.0f} % of what the other lines show")
    lines = [f"Quality: {quality.light}", *quality.reasons, ", ".join(figures)]
    if quality.smear is not None:
        lines.append(
            f"Up to {_mm(quality.smear)} (RMS) may be the error of the rough boresight; "
            "it does not count before the calibration"
        )
    elif quality.incidence is not None:
        lines.append(
            f"Judged with the estimated boresight, from {quality.points:,} points with an RMS of "
            f"{_mm(quality.rms)}"
        )
    return "\n".join(lines)


def _said(value: Any) -> Any:
    return say(value) if isinstance(value, str) else value


def _of_name(target: Target, role: int) -> Any:
    is_target = target.role == "target"
    if role == Role.DisplayRole:
        return target.name
    if role == Role.DecorationRole:
        return QColor(*(theme.TARGET_COLOUR if is_target else theme.VALIDATION_COLOUR))
    if role == Role.CheckStateRole:
        return Qt.CheckState.Checked if target.used else Qt.CheckState.Unchecked
    if role == Role.ToolTipRole:
        what = "takes part in the adjustment" if is_target else "validation plane, takes no part"
        return f"{target.name}: {what}\n{_NAME_TIP}"
    return None


def _of_missing(target: Target, line: str, role: int) -> Any:
    if role == Role.DisplayRole:
        return "–"
    if role == Role.ForegroundRole:
        return QBrush(QColor(theme.DISABLED))
    if role == Role.ToolTipRole:
        reason = target.missing.get(line)
        first = (
            f"{target.name} on {line}: not searched for on this line"
            if reason is None
            else say_message(
                note("project.not_found_on_line", target=target.name, line=line, reason=reason)
            )
        )
        return (
            f"{first}\nTo seed this line alone, choose it under “Seek on” in step 2 and Ctrl+click."
        )
    return None
