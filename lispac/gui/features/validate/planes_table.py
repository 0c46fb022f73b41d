"""Table of the validation planes: verdict, and the values that are compared with the criteria."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QContextMenuEvent, QFont, QIcon
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QMenu,
    QSizePolicy,
    QTableWidget,
    QTableWidgetItem,
)

from lispac.acceptance import (
    AcceptanceCriteria,
    Quantity,
    Verdict,
    planes_to_show,
)
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.widgets.marked_cells import MarkedCells
from lispac.gui.widgets.result_tables import (
    local_amount,
    local_cell_text,
    local_number,
    window_columns,
)
from lispac.language import N_, gettext
from lispac.present.checking.acceptance import AcceptanceValues, failed_texts, verdict_text
from lispac.present.checking.validation import WINDOW_PLANES_TABLE, ValidationPlane
from lispac.present.tables import MILLIMETRES, title_text
from lispac.project import Project
from lispac.validation.comparison_results import PlaneComparison

NAME, RMS, OFFSET, P95, PAIRS = range(5)
"""Columns of `WINDOW_PLANES_TABLE`."""
_COLUMN_QUANTITIES: dict[Quantity, int] = {"rms": RMS, "p95": P95, "offset": OFFSET}
VERDICT_QUALITIES: dict[Verdict, str] = {"pass": "good", "fail": "poor"}
"""Quality whose icon shows a verdict beside the name of a plane; a plane not judged has none."""
_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
ROW_HEIGHT_PX = 18
POOLED_PLANE_TIPS = {
    "reciprocal pairs": N_(
        "{plane}: RMS, 95 % and histogram of {pooled:n} of {total:n} pairs of lines only, the "
        "reciprocal ones (⇄), from an earlier version of the program; {model}"
    ),
    "all pairs": N_("{plane}: distances between all pairs of lines, {model}"),
}
"""Tips of a plane, by the pairs of lines whose distances are pooled."""


class PlanesTable(QTableWidget):
    """Validation planes with their verdicts; values that exceed their limit are highlighted."""

    plane_selected = Signal(str)
    """The user selected a plane, or clicked the selected one."""
    used_changed = Signal(str, bool)
    """The user excluded the selected plane, or included an excluded one, in the context menu."""

    def __init__(self) -> None:
        super().__init__(0, len(WINDOW_PLANES_TABLE.columns))
        self.failed: frozenset[str] = frozenset()
        """Names of the planes that fail an acceptance criterion."""
        self._comparisons: tuple[PlaneComparison, ...] = ()
        self._excluded: tuple[str, ...] = ()
        self.setTabKeyNavigation(False)
        self.setObjectName("comparison_table")
        self.setAccessibleName(title_text(WINDOW_PLANES_TABLE.title))
        self.verticalHeader().hide()
        self.verticalHeader().setMinimumSectionSize(ROW_HEIGHT_PX)
        self.verticalHeader().setDefaultSectionSize(ROW_HEIGHT_PX)
        self.setShowGrid(False)
        self.setItemDelegate(MarkedCells(self))
        self.setAlternatingRowColors(True)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.setSizeAdjustPolicy(QAbstractItemView.SizeAdjustPolicy.AdjustToContents)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._show_heads(AcceptanceCriteria())
        self.viewport().installEventFilter(self)
        self.itemSelectionChanged.connect(self._announce_plane)
        self.clicked.connect(self._announce_plane)  # a row that was selected already

    @property
    def current_comparison(self) -> PlaneComparison | None:
        """Comparison of the selected plane."""
        rows = self.selectionModel().selectedRows()
        return self._comparisons[rows[0].row()] if rows else None

    def sizeHint(self) -> QSize:
        """Size of all rows and columns; that of Qt has the header before its texts were set."""
        height = self.horizontalHeader().sizeHint().height() + self.verticalHeader().length()
        return QSize(super().sizeHint().width(), height + 2 * self.frameWidth())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep the selected row visible in a lower table."""
        if watched is self.viewport() and event.type() == QEvent.Type.Resize:
            self.scrollTo(self.currentIndex())
        return super().eventFilter(watched, event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to exclude the selected plane and to include the excluded ones."""
        place = event.globalPos()
        if event.reason() == QContextMenuEvent.Reason.Keyboard:
            row = self.visualRect(self.currentIndex())
            place = self.viewport().mapToGlobal(row.center())
        menu = QMenu(self)
        menu.setObjectName("planes_menu")
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        if (selected := self.current_comparison) is not None:
            name = selected.name
            text = gettext("Exclude {plane}", plane=name.replace("&", "&&"))
            menu.addAction(text, lambda: self.used_changed.emit(name, False))
        for name in self._excluded:
            text = gettext("Include {plane}", plane=name.replace("&", "&&"))
            menu.addAction(text, lambda name=name: self.used_changed.emit(name, True))
        menu.popup(place)

    def show_planes(self, comparisons: Sequence[PlaneComparison]) -> None:
        """Show the planes; none is selected."""
        self._comparisons = tuple(comparisons)
        self.blockSignals(True)
        self.setRowCount(len(comparisons))
        font = theme.tabular_font(self.font())
        for row, each in enumerate(comparisons):
            values = ValidationPlane.of(each)
            for column, shown in enumerate(WINDOW_PLANES_TABLE.columns):
                item = QTableWidgetItem(local_cell_text(shown, values))
                item.setFont(font)
                if column:
                    item.setTextAlignment(_ALIGN_RIGHT)
                item.setToolTip(widgets.wrapped_tip(_plane_tip(each)))
                self.setItem(row, column, item)
        self.clearSelection()
        self.blockSignals(False)

    def select(self, name: str) -> bool:
        """Select a plane without emitting a signal; return whether there is one of that name."""
        names = [each.name for each in self._comparisons]
        if name not in names:
            return False
        self.blockSignals(True)
        self.selectRow(names.index(name))
        self.blockSignals(False)
        self.scrollTo(self.currentIndex())
        return True

    def worst_plane(self) -> str:
        """Plane with the largest RMS after the calibration, of those that fail if any.

        Raises
        ------
        ValueError
            If there are no planes.
        """
        (worst,) = planes_to_show(
            {each.name: each.after.rms for each in self._comparisons}, self.failed, 1
        )
        return worst

    def show_verdicts(self, project: Project) -> None:
        """Show the limits, and whether each plane meets them."""
        self._excluded = tuple(
            plane.name for plane in project.targets_of_role("validation") if not plane.used
        )
        judgement = project.judgement
        values = AcceptanceValues.of(judgement)
        self.failed = frozenset(
            each.name for each in self._comparisons if judgement.verdict_on(each.name) == "fail"
        )
        self._show_heads(judgement.criteria)
        exceeded = {
            (check.plane, _COLUMN_QUANTITIES[check.quantity])
            for check in judgement.checks
            if check.verdict == "fail" and check.quantity in _COLUMN_QUANTITIES
        }
        for row, each in enumerate(self._comparisons):
            verdict = judgement.verdict_on(each.name)
            for column in _COLUMN_QUANTITIES.values():
                _highlight(self.item(row, column), (each.name, column) in exceeded)
            reasons = failed_texts(values, each.name)
            tip = widgets.wrapped_tip("\n".join([_plane_tip(each), *reasons]))
            for column in range(NAME + 1, self.columnCount()):
                self.item(row, column).setToolTip(tip)
            item = self.item(row, NAME)
            quality = VERDICT_QUALITIES.get(verdict)
            item.setIcon(QIcon() if quality is None else theme.quality_icon(quality))
            text = gettext("Acceptance: {verdict}", verdict=verdict_text(verdict))
            item.setToolTip(widgets.wrapped_tip("\n".join([_plane_tip(each), text, *reasons])))
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{each.name}. {text}")

    def _show_heads(self, criteria: AcceptanceCriteria) -> None:
        limits = {RMS: criteria.rms, P95: criteria.p95, OFFSET: criteria.offset}
        for column, shown in enumerate(window_columns(WINDOW_PLANES_TABLE)):
            limit = limits.get(column)
            # Units or limits in a second line, so that all columns fit on a small screen
            text = shown.title.replace(" (", "\n(")
            if limit is not None:
                figure = local_number(limit, MILLIMETRES.nonzero(limit))
                text = gettext("{title}\nlimit {limit}", title=shown.title, limit=figure)
            head = QTableWidgetItem(text)
            head.setToolTip(widgets.wrapped_tip(shown.tip))
            if column:
                head.setTextAlignment(_ALIGN_RIGHT)
            self.setHorizontalHeaderItem(column, head)
        self.updateGeometry()

    def _announce_plane(self) -> None:
        if self.current_comparison is not None:
            self.plane_selected.emit(self.current_comparison.name)


def _highlight(item: QTableWidgetItem, is_exceeded: bool) -> None:
    font = QFont(item.font())
    font.setBold(is_exceeded)
    item.setFont(font)
    item.setForeground(theme.colour("error") if is_exceeded else QBrush())


def _plane_tip(each: PlaneComparison) -> str:
    model = message_text(each.model.name)
    pooled = gettext(
        POOLED_PLANE_TIPS[each.pooled_from], plane=each.name, model=model,
        pooled=sum(pair.reciprocal for pair in each.pairs), total=len(each.pairs),
    )  # fmt: skip
    values = ValidationPlane.of(each)
    if values.largest_offset_m is None or values.former_offset_m is None:
        return pooled
    offset = gettext(
        "Largest offset: {lines}, {before} before, {after} after",
        lines=values.largest_offset_lines,
        before=local_amount(values.former_offset_m, MILLIMETRES),
        after=local_amount(values.largest_offset_m, MILLIMETRES),
    )
    return f"{pooled}\n{offset}"
