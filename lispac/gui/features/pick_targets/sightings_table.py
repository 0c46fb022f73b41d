"""Table of targets by lines: points, RMS and use of every sighting."""

from collections import Counter
from collections.abc import Iterable, Mapping
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

from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.project.status import ProjectState
from lispac.gui.widgets.result_tables import local_amount
from lispac.language import N_, Plural, gettext
from lispac.present.tables import COUNT, MILLIMETRES
from lispac.present.targets.sighting_quality import EXTENT_METRES, RANGE_METRES
from lispac.project import PickedSighting, Project, Target
from lispac.targets.sighting_quality import Rating, SightingQuality
from lispac.workflow.project.survey import Survey

MIN_SHOWN_SMEAR_M = 5e-5
"""Smallest effect of the prior boresight on the RMS that is shown, metres; a smaller one would be
0.0 mm."""

Role = Qt.ItemDataRole
Index = QModelIndex | QPersistentModelIndex
_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_ALIGN_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_ROLES = frozenset(
    {
        Role.DisplayRole, Role.DecorationRole, Role.CheckStateRole, Role.ForegroundRole,
        Role.TextAlignmentRole, Role.ToolTipRole,
    }
)  # fmt: skip
"""Roles for which cells have values."""
EDITED_SYMBOL = "\N{LOWER RIGHT PENCIL}"
_EMPTY_TEXT = N_("No targets yet. Hold Ctrl and click a target in the view.")
CELLS_TIP = N_(
    "A cell contains the number of points of the target found in the line, and the RMS of their "
    "distances to the plane or sphere of the sighting. After the calibration, the points of "
    "targets are found again with the estimated boresight, as in the report; their number then "
    "differs slightly from that of the pick. The symbol is the quality of the sighting; untick a "
    "cell to exclude its sighting."
)
RATING_TEXTS: dict[Rating, str] = {
    "good": N_("Quality: good"),
    "doubtful": N_("Quality: doubtful"),
    "poor": N_("Quality: poor"),
}
"""Texts of a quality."""
REASON_WORDS: Mapping[str, str] = {
    "quality.curved": N_("curved"),
    "quality.uneven": N_("uneven"),
    "quality.oblique": N_("oblique"),
    "quality.sparse": N_("gaps"),
    "quality.sphere_part": N_("partly visible"),
    "quality.few_points": N_("few points"),
    "quality.rough": N_("rough"),
    "quality.rough_without_prior": N_("rough"),
    "quality.rough_beyond_threshold": N_("rough"),
    "quality.rough_without_prior_beyond_threshold": N_("rough"),
    "quality.shows_more": N_("larger"),
    "quality.shows_less": N_("partly visible"),
    "quality.mistakable": N_("ambiguous"),
    "quality.wider": N_("other size"),
    "quality.narrower": N_("other size"),
    "quality.higher": N_("other size"),
    "quality.lower": N_("other size"),
    "quality.steeper": N_("other tilt"),
    "quality.less_steep": N_("other tilt"),
}
"""Short forms of the reasons for a doubtful or poor quality, by message code."""


class SightingsModel(QAbstractTableModel):
    """Table model with targets as rows and lines as columns; the last row is for whole lines."""

    target_use_changed = Signal(str, bool)
    line_use_changed = Signal(str, bool)
    sighting_use_changed = Signal(str, str, bool)

    def __init__(self) -> None:
        super().__init__()
        self._project: Project | None = None
        self._heading: dict[str, float] = {}
        self._qualities: Mapping[tuple[str, str], SightingQuality] = {}
        self._lines: list[str] = []
        self._colours: dict[str, tuple[int, int, int]] = {}

    def show_project(self, project: Project | None, survey: Survey | None) -> None:
        """Show another project."""
        heading = {} if survey is None else dict(survey.heading)
        if project is self._project and heading == self._heading:
            return
        self.beginResetModel()
        self._project = project
        self._lines = [] if project is None else [line.name for line in project.lines]
        self._colours = theme.line_colours(self._lines)
        self._heading = heading
        self.endResetModel()

    def show_qualities(self, qualities: Mapping[tuple[str, str], SightingQuality]) -> None:
        """Show the quality of the sightings, by the names of target and line."""
        if qualities == self._qualities:
            return  # they are emitted after every change
        self._qualities = qualities
        if self.rowCount():
            last = self.index(self.rowCount() - 1, self.columnCount() - 1)
            self.dataChanged.emit(self.index(0, 0), last)

    def quality_sentences(self, name: str, line: str) -> str:
        """Name of a sighting of doubtful or poor quality with all reasons; empty for others."""
        quality = self._qualities.get((name, line))
        if quality is None or quality.rating == "good":
            return ""
        reasons = " ".join(map(message_text, quality.reasons))
        return gettext("{target} in line {line}: {reason}", target=name, line=line, reason=reasons)

    def key(self, index: Index) -> tuple[str, str] | None:
        """Target and line of a cell; the line is empty in the column of names."""
        if not index.isValid() or index.row() >= len(self._targets):
            return None
        line = "" if index.column() == 0 else self._lines[index.column() - 1]
        return self._targets[index.row()].name, line

    def row_of(self, name: str) -> int | None:
        """Row of a target."""
        return next((k for k, t in enumerate(self._targets) if t.name == name), None)

    def column_of(self, line: str) -> int:
        """Column of a line; the column of names if there is no such line."""
        return 1 + self._lines.index(line) if line in self._lines else 0

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        """Number of rows: targets, and one for whole lines if a target is adjusted."""
        targets = len(self._targets)
        return 0 if parent.isValid() or not targets else targets + bool(self._adjusted_targets)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Number of columns: one for the names and one for each line."""
        return 0 if parent.isValid() else len(self._lines) + 1

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        """Name of a line with its heading, and its colour."""
        value = self._header_value(section, orientation, role)
        return widgets.plain_tip(value) if role == Role.ToolTipRole and value else value

    def _header_value(self, section: int, orientation: Qt.Orientation, role: int) -> Any:
        if orientation == Qt.Orientation.Vertical:
            return None
        if role == Role.TextAlignmentRole:
            return _ALIGN_LEFT if section == 0 else _ALIGN_RIGHT
        if section == 0:
            if role == Role.ToolTipRole:
                return gettext(CELLS_TIP)
            return gettext("Target: points found, RMS") if role == Role.DisplayRole else None
        line = self._lines[section - 1]
        heading = self._heading.get(line)
        if role == Role.DisplayRole:
            return line if heading is None else f"{line}  {round(heading * 57.29578) % 360}°"
        if role == Role.DecorationRole:
            return theme.swatch(self._colours[line])
        if role == Role.ToolTipRole:
            return gettext(
                "{line}: number of points, and RMS of their distances to the plane of the sighting "
                "({unit})",
                line=line, unit=units.shown_unit("mm").sign,
            )  # fmt: skip
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Flags of a cell, including whether it can be ticked."""
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if index.row() == len(self._targets):
            on_line = index.column() > 0 and self._sightings_on_line(
                self._lines[index.column() - 1]
            )
            return flags | Qt.ItemFlag.ItemIsUserCheckable if on_line else flags
        if index.column() == 0 or self._sighting(index) is not None:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def data(self, index: Index, role: int = Role.DisplayRole) -> Any:
        """Value of a cell for a role."""
        if role not in _ROLES:
            return None  # the view asks for all roles of all cells to compute the widths
        value = self._cell_value(index, role)
        return widgets.plain_tip(value) if role == Role.ToolTipRole and value else value

    def _cell_value(self, index: Index, role: int) -> Any:
        if index.row() == len(self._targets):
            return self._line_cell_value(index.column(), role)
        target = self._targets[index.row()]
        if index.column() == 0:
            if role == Role.DisplayRole and (reason := self._main_reason(target)):
                return f"{target.name} {reason}"
            return _name_cell_value(target, role)
        line = self._lines[index.column() - 1]
        sighting = target.sighting(line)
        if role == Role.TextAlignmentRole:
            return _ALIGN_RIGHT if sighting is not None else Qt.AlignmentFlag.AlignCenter
        if sighting is None:
            return _missing_cell_value(target, line, role)
        return self._sighting_cell_value(target, sighting, role)

    def setData(self, index: Index, value: Any, role: int = Role.EditRole) -> bool:
        """Emit the signal of a cell that was ticked or unticked."""
        if role != Role.CheckStateRole:
            return False
        used = Qt.CheckState(value) == Qt.CheckState.Checked
        if index.row() == len(self._targets) and index.column() > 0:
            self.line_use_changed.emit(self._lines[index.column() - 1], used)
            return True
        key = self.key(index)
        if key is None:
            return False
        if key[1]:
            self.sighting_use_changed.emit(*key, used)
        else:
            self.target_use_changed.emit(key[0], used)
        return True

    @property
    def _targets(self) -> tuple[Target, ...]:
        return () if self._project is None else self._project.targets

    @property
    def _adjusted_targets(self) -> tuple[Target, ...]:
        return tuple(target for target in self._targets if target.role == "target")

    def _sightings_on_line(self, line: str) -> list[PickedSighting]:
        """Sightings of adjustment targets on a line."""
        found = (target.sighting(line) for target in self._adjusted_targets)
        return [sighting for sighting in found if sighting is not None]

    def _line_cell_value(self, column: int, role: int) -> Any:
        if column == 0:
            values = {
                Role.DisplayRole: gettext("Whole line"),
                Role.ToolTipRole: gettext("Untick a line to exclude all its sightings"),
                Role.ForegroundRole: QBrush(QColor(theme.MUTED)),
            }
            return values.get(Role(role))
        line = self._lines[column - 1]
        sightings = self._sightings_on_line(line)
        used = sum(sighting.used for sighting in sightings)
        if role == Role.TextAlignmentRole:
            return _ALIGN_RIGHT if sightings else Qt.AlignmentFlag.AlignCenter
        if role == Role.DisplayRole:
            if not sightings:
                return "–"
            return gettext("{used:n} of {total:n} used", used=used, total=len(sightings))
        if role == Role.ForegroundRole:
            return QBrush(QColor(theme.MUTED))
        if role == Role.CheckStateRole and sightings:
            if 0 < used < len(sightings):
                return Qt.CheckState.PartiallyChecked
            return Qt.CheckState.Checked if used else Qt.CheckState.Unchecked
        if role == Role.ToolTipRole and sightings:
            return gettext(
                "{line}: untick to exclude all sightings of this line, tick to use them", line=line
            )
        return None

    def _sighting(self, index: Index) -> PickedSighting | None:
        return self._targets[index.row()].sighting(self._lines[index.column() - 1])

    def _main_reason(self, target: Target) -> str:
        keys = ((target.name, sighting.line) for sighting in target.sightings)
        return main_reason(self._qualities[key] for key in keys if key in self._qualities)

    def _sighting_cell_value(self, target: Target, sighting: PickedSighting, role: int) -> Any:
        used = target.used and sighting.used
        quality = self._qualities.get((target.name, sighting.line))
        if role == Role.DisplayRole:
            is_poor = quality is not None and quality.rating == "poor"
            light = "   " + gettext("poor") if is_poor else ""
            edited = f" {EDITED_SYMBOL}" if sighting.by_hand else ""
            count, rms = len(sighting.indices), sighting.rms
            if quality is not None and quality.smear is None:  # as in the report
                count, rms = quality.points, quality.rms
            return f"{COUNT.text(count)}\N{EN SPACE}{local_amount(rms, MILLIMETRES)}{light}{edited}"
        if role == Role.DecorationRole and quality is not None:
            return theme.quality_icon(quality.rating)
        if role == Role.CheckStateRole:
            return Qt.CheckState.Checked if sighting.used else Qt.CheckState.Unchecked
        if role == Role.ForegroundRole and not used:
            return QBrush(QColor(theme.DISABLED))
        if role == Role.ToolTipRole:
            return self._tip(target, sighting)
        return None

    def _tip(self, target: Target, sighting: PickedSighting) -> str:
        lines = [
            gettext(
                Plural(
                    "{target} in line {line}: {count:n} point picked, RMS distance to the plane "
                    "of the sighting {rms}",
                    "{target} in line {line}: {count:n} points picked, RMS distance to the plane "
                    "of the sighting {rms}",
                )
                if target.shape == "plane"
                else Plural(
                    "{target} in line {line}: {count:n} point picked, RMS distance to the sphere "
                    "of the sighting {rms}",
                    "{target} in line {line}: {count:n} points picked, RMS distance to the sphere "
                    "of the sighting {rms}",
                ),
                target=target.name, line=sighting.line, count=len(sighting.indices),
                rms=local_amount(sighting.rms, MILLIMETRES),
            )
        ]  # fmt: skip
        if (quality := self._qualities.get((target.name, sighting.line))) is not None:
            lines.append(quality_text(quality))
        if sighting.by_hand:
            edited = gettext("Points edited with the lasso")
            lines.append(f"{EDITED_SYMBOL} {edited}")
        if sighting.one_in > 1:
            lines.append(
                gettext("Subsampled: one of every {count:n} points near the seed is used",
                        count=sighting.one_in)
            )  # fmt: skip
        result = None if self._project is None else self._project.result
        for residual in () if result is None else result.sightings:
            if (residual.sighting.target, residual.sighting.line) == (target.name, sighting.line):
                lines.append(
                    gettext(
                        "RMS distance to the adjusted surface: {before} before, {after} after",
                        before=local_amount(residual.rms_before, MILLIMETRES),
                        after=local_amount(residual.rms_after, MILLIMETRES),
                    )
                )
        lines.append(gettext("Untick to exclude this sighting"))
        return "\n".join(lines)


class SightingsTable(QTableView):
    """Table view of the sightings; emits the selected sighting.

    A double click or Enter emits `sighting_activated`.
    """

    sighting_selected = Signal(str, str)
    sighting_activated = Signal(str, str)

    def __init__(self) -> None:
        super().__init__()
        self.setTabKeyNavigation(False)
        self.setObjectName("sightings_table")
        self.setAccessibleName(gettext("Targets by line"))
        self.sightings = SightingsModel()
        self.setModel(self.sightings)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setAlternatingRowColors(True)
        self.setFont(theme.tabular_font(self.font()))
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(22)
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.horizontalHeader().setMinimumSectionSize(110)
        self.selectionModel().currentChanged.connect(self._emit_selected)
        self.activated.connect(self._emit_activated)

    def show_state(self, state: ProjectState) -> None:
        """Show the project; a cell remains selected if its target is still in the same row."""
        key = self.sightings.key(self.currentIndex())
        place = self.currentIndex()
        row, column = place.row(), place.column()
        self.sightings.show_project(state.project, state.survey)
        if key is not None and self.sightings.row_of(key[0]) == row:
            self._set_current(row, column)

    def select(self, name: str) -> None:
        """Select the row of a target without emitting a signal."""
        row = self.sightings.row_of(name)
        key = self.sightings.key(self.currentIndex())
        if row is not None and (key is None or key[0] != name):
            self._set_current(row, 0)

    def go_to(self, name: str, line: str) -> None:
        """Select the cell of a sighting without emitting a signal, and scroll to it."""
        row = self.sightings.row_of(name)
        if row is not None:
            column = self.sightings.column_of(line)
            self._set_current(row, column)
            self.scrollTo(self.sightings.index(row, column))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the table, or instructions while it is empty."""
        super().paintEvent(event)
        if self.sightings.rowCount() == 0:
            painter = QPainter(self.viewport())
            painter.setPen(QColor(theme.MUTED))
            area = self.viewport().rect().adjusted(16, 8, -16, -8)
            painter.drawText(
                area, Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, gettext(_EMPTY_TEXT)
            )
            painter.end()

    def _set_current(self, row: int, column: int) -> None:
        self.selectionModel().blockSignals(True)
        self.selectionModel().setCurrentIndex(
            self.sightings.index(row, column), QItemSelectionModel.SelectionFlag.ClearAndSelect
        )
        self.selectionModel().blockSignals(False)
        self.viewport().update()

    def _emit_selected(self, current: QModelIndex, _previous: QModelIndex) -> None:
        key = self.sightings.key(current)
        if key is not None:
            self.sighting_selected.emit(*key)

    def _emit_activated(self, index: QModelIndex) -> None:
        key = self.sightings.key(index)
        if key is not None:
            self.sighting_activated.emit(*key)


def main_reason(qualities: Iterable[SightingQuality]) -> str:
    """Short form of the most frequent reason of the sightings that are not good."""
    words = Counter(
        next((REASON_WORDS[each.code] for each in quality.reasons if each.code in REASON_WORDS),
             N_("doubtful"))
        for quality in qualities
        if quality.rating != "good"
    )  # fmt: skip
    return gettext(words.most_common(1)[0][0]) if words else ""


def quality_text(quality: SightingQuality) -> str:
    """Text of the quality, its reasons and the values behind them, one on each line."""
    lines = [
        gettext(RATING_TEXTS[quality.rating]),
        *map(message_text, quality.reasons),
        gettext("Range: {range}", range=local_amount(quality.range, RANGE_METRES)),
    ]
    if quality.density is not None:
        lines.append(gettext("Density: {density:x.0} points per m²", density=quality.density))
    if quality.incidence is not None:
        lines.append(gettext("Angle of incidence: {angle:deg.0}°", angle=quality.incidence))
    if quality.extent is not None:
        width, height = (local_amount(each, EXTENT_METRES) for each in quality.extent)
        lines.append(gettext("Size: {width} × {height}", width=width, height=height))
    if quality.visible_share is not None:
        lines.append(
            gettext(
                "Extent observed: {share:percent.0} % of the extent in the other lines",
                share=quality.visible_share,
            )
        )
    if quality.smear is not None and quality.smear >= MIN_SHOWN_SMEAR_M:
        lines.append(
            gettext(
                "The prior boresight may cause up to {rms} of the RMS. Before the calibration, "
                "the quality does not include this share.",
                rms=local_amount(quality.smear, MILLIMETRES),
            )
        )
    elif quality.smear is None and quality.incidence is not None:
        lines.append(
            gettext(
                Plural(
                    "Quality computed from {count:n} point found again with the estimated "
                    "boresight, RMS {rms}",
                    "Quality computed from {count:n} points found again with the estimated "
                    "boresight, RMS {rms}",
                ),
                count=quality.points, rms=local_amount(quality.rms, MILLIMETRES),
            )
        )  # fmt: skip
    return "\n".join(lines)


def _name_cell_value(target: Target, role: int) -> Any:
    is_target = target.role == "target"
    if role == Role.DisplayRole:
        return target.name
    if role == Role.DecorationRole:
        return theme.swatch(theme.TARGET_COLOUR if is_target else theme.VALIDATION_COLOUR)
    if role == Role.CheckStateRole:
        return Qt.CheckState.Checked if target.used else Qt.CheckState.Unchecked
    if role == Role.ToolTipRole:
        role_name = (
            gettext("{target}: used in the adjustment", target=target.name)
            if is_target
            else gettext(
                "{target}: validation plane, not used in the adjustment", target=target.name
            )
        )
        return role_name + "\n" + gettext("Tick to use the target")
    return None


def _missing_cell_value(target: Target, line: str, role: int) -> Any:
    if role == Role.DisplayRole:
        return "–"
    if role == Role.ForegroundRole:
        return QBrush(QColor(theme.DISABLED))
    if role == Role.ToolTipRole:
        if line in target.missing:
            reason = gettext(
                "{target} in line {line}: {reason}",
                target=target.name, line=line, reason=message_text(target.missing[line]),
            )  # fmt: skip
        else:
            reason = gettext(
                "{target} was not searched for in line {line}", target=target.name, line=line
            )
        action = gettext(
            "To pick the target in this line only, choose the line under “Search in” in step 2 "
            "and Ctrl+click the target."
        )
        return f"{reason}\n{action}"
    return None
