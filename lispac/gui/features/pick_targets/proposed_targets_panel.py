"""Panel with the proposed targets: a list to tick, accept or reject."""

from collections.abc import Collection
from math import degrees
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHBoxLayout,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
)

from lispac.adjustment.result import ANGLES
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.widgets.reserved_label import ReservedLabel
from lispac.gui.widgets.result_tables import local_amount
from lispac.gui.widgets.tab_order import ENTER_KEYS
from lispac.language import N_, Plural, gettext
from lispac.picked_targets import Triple
from lispac.present.tables import DEGREES

if TYPE_CHECKING:
    from lispac.workflow.calibration.proposals import Proposal

ROLE_NAMES = {"target": N_("Target"), "validation": N_("Validation plane")}
COLUMN_TITLES = (N_("Name"), N_("Role"), N_("Lines"))
TITLE = N_("Proposed targets")
ZOOM_TIP = N_("Double-click to zoom to it in the 3D view")
ROW_HEIGHT_PX = 22
"""Height of a row of the table, pixels."""


class ProposedTargetsPanel(QFrame):
    """Proposed targets and validation planes, to be ticked and added or all rejected."""

    accepted = Signal()
    rejected = Signal()
    ticks_changed = Signal()
    selected = Signal(str)
    """Another row was selected; its name."""
    zoom_requested = Signal(str)
    """The user double-clicked a row; its name."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("proposal_box")
        self.setProperty("role", "candidate")
        self._proposal: Proposal | None = None
        self._others: tuple[str, ...] = ()
        """Used targets of the project that are not among the proposed surfaces."""
        layout = widgets.vertical_layout(self, 10)
        layout.addWidget(widgets.label(gettext(TITLE), "heading"))
        self._sigmas = widgets.label("", wrap=True, name="proposal_sigmas")
        self._warnings = widgets.label("", "warning", wrap=True, name="proposal_warnings")
        self.table = _ProposalTable(len(COLUMN_TITLES))
        self.table.itemChanged.connect(self._on_ticked)
        self.table.itemSelectionChanged.connect(self._on_selected)
        self.table.cellDoubleClicked.connect(
            lambda row, _column: self.zoom_requested.emit(self.table.item(row, 0).text())
        )
        self.table.accepted.connect(self._accept)
        # A panel that is scrolled to its end would move if it became lower
        self.reason = ReservedLabel(name="proposal_reason")
        for each in (self._warnings, self.table):
            layout.addWidget(each)
        self.accept_button = widgets.button(
            "", "accept_proposal", primary=True, tip=gettext("Add the ticked targets and planes")
        )
        self.accept_button.clicked.connect(self._accept)
        self.reject_button = widgets.button(
            gettext("Reject all"),
            "reject_proposal",
            tip=gettext("Close without adding targets or planes"),
        )
        self.reject_button.clicked.connect(self.rejected)
        row = QHBoxLayout()
        row.addWidget(self.accept_button, 1)
        row.addWidget(self.reject_button)
        # Texts that change are below the buttons, which then stay in place
        layout.addLayout(row)
        layout.addWidget(self.reason)
        layout.addWidget(self._sigmas)
        self._note = widgets.label("", "muted", wrap=True, name="proposal_note")
        layout.addWidget(self._note)

    def show_proposal(
        self,
        proposal: "Proposal",
        unticked: Collection[Triple] = (),
        existing: Collection[str] = (),
    ) -> None:
        """Show a proposal; the targets with the ``unticked`` seeds are not ticked.

        Parameters
        ----------
        existing : targets of the project that the adjustment uses
        """
        name = self.current
        self._others = tuple(each for each in existing if each not in proposal.picked)
        self._proposal = proposal
        self._warnings.setText("\n".join(map(message_text, proposal.warnings)))
        self._warnings.setVisible(bool(proposal.warnings))
        self._note.setText("\n".join(map(message_text, proposal.notes)))
        self.reason.reserve([self._reason_of(target.name) for target in proposal.targets])
        self.table.blockSignals(True)
        self._fill(proposal, unticked)
        names = [target.name for target in proposal.targets]
        self.table.selectRow(names.index(name) if name in names else 0)
        self.table.blockSignals(False)
        self.table.fit_height()
        self._on_ticked()
        self._on_selected()

    @property
    def current(self) -> str | None:
        """Name of the selected target or plane."""
        rows = self.table.selectionModel().selectedRows()
        return self.table.item(rows[0].row(), 0).text() if rows else None

    @property
    def ticked_entries(self) -> tuple[str, ...]:
        """Names of the ticked targets and planes."""
        checked = Qt.CheckState.Checked
        items = (self.table.item(row, 0) for row in range(self.table.rowCount()))
        return tuple(item.text() for item in items if item.checkState() == checked)

    def _accept(self) -> None:
        if self.ticked_entries:
            self.accepted.emit()

    def _fill(self, proposal: "Proposal", unticked: Collection[Triple]) -> None:
        self.table.setRowCount(len(proposal.targets))
        for row, target in enumerate(proposal.targets):
            is_target = target.role == "target"
            colour = theme.TARGET_COLOUR if is_target else theme.VALIDATION_COLOUR
            name = QTableWidgetItem(theme.swatch(colour), target.name)
            name.setFlags(name.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            ticked = target.seed not in unticked
            name.setCheckState(Qt.CheckState.Checked if ticked else Qt.CheckState.Unchecked)
            name.setToolTip(gettext("Untick to exclude this target or plane"))
            role = QTableWidgetItem(gettext(ROLE_NAMES[target.role]))
            role.setToolTip(gettext(ZOOM_TIP))
            lines = [sighting.line for sighting in target.sightings]
            count_item = QTableWidgetItem(str(len(lines)))
            count_item.setToolTip(
                widgets.plain_tip(gettext("Observed on lines: {lines:names}", lines=lines))
            )
            for column, item in enumerate((name, role, count_item)):
                self.table.setItem(row, column, item)

    def _on_selected(self) -> None:
        if self._proposal is not None and (name := self.current) is not None:
            self.reason.setText(self._reason_of(name))
            self.selected.emit(name)

    def _reason_of(self, name: str) -> str:
        assert self._proposal is not None
        summary = message_text(self._proposal.reasons[name])
        return gettext("{title}: {summary}", title=name, summary=summary)

    def _on_ticked(self) -> None:
        ticked, total = len(self.ticked_entries), self.table.rowCount()
        self.accept_button.setText(
            gettext("Add {ticked:n} of {total:n}", ticked=ticked, total=total)
        )
        self.accept_button.setEnabled(ticked > 0)
        if self._proposal is not None:
            self._sigmas.setText(_targets_text(self._proposal, self.ticked_entries, self._others))
        self.ticks_changed.emit()


class _ProposalTable(QTableWidget):
    """Table as high as its rows, in which Enter accepts and Space ticks the selected row."""

    accepted = Signal()

    def __init__(self, columns: int) -> None:
        super().__init__(0, columns)
        self.setTabKeyNavigation(False)
        self.setObjectName("proposal_table")
        self.setAccessibleName(gettext("Proposed targets and validation planes"))
        self.setHorizontalHeaderLabels([gettext(head) for head in COLUMN_TITLES])
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(ROW_HEIGHT_PX)
        self.setShowGrid(False)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setProperty("rows", True)  # no frame around a cell, like a button
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        header = self.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)

    def fit_height(self) -> None:
        """Make the table as high as its rows."""
        head = self.horizontalHeader().sizeHint().height()
        self.setFixedHeight(head + ROW_HEIGHT_PX * self.rowCount() + 4)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Accept with Enter; tick or untick the current row with Space, in any column."""
        name = self.item(self.currentRow(), 0)
        if event.key() in ENTER_KEYS:
            self.accepted.emit()
        elif event.key() == Qt.Key.Key_Space and name is not None:
            checked = name.checkState() == Qt.CheckState.Checked
            name.setCheckState(Qt.CheckState.Unchecked if checked else Qt.CheckState.Checked)
        else:
            super().keyPressEvent(event)


def _targets_text(proposal: "Proposal", ticked: Collection[str], others: Collection[str]) -> str:
    """Text on the precision predicted with the ticked targets, or that all are picked already."""
    if not any(target.role == "target" for target in proposal.targets):
        return gettext(
            "No more targets are proposed because all suitable surfaces are already targets or "
            "validation planes: {targets:names}.",
            targets=proposal.picked,
        )
    sigma = proposal.predicted_sigma(ticked)
    if not np.isfinite(sigma).all():
        return gettext("The ticked targets do not determine the boresight. Tick more targets.")
    sigmas = dict(zip(ANGLES, map(_angle_text, sigma), strict=True))
    if proposal.picked:
        predicted = gettext(
            "Predicted standard deviations of the boresight with the ticked targets and "
            "{targets:names}: roll {roll}, pitch {pitch}, yaw {yaw}.",
            targets=proposal.picked, **sigmas,
        )  # fmt: skip
    else:
        predicted = gettext(
            "Predicted standard deviations of the boresight with the ticked targets: roll {roll}, "
            "pitch {pitch}, yaw {yaw}.",
            **sigmas,
        )
    if not others:
        return predicted
    without = gettext(
        Plural(
            "The search did not propose {targets:names}; with it, the real values will be smaller.",
            "The search did not propose {targets:names}; with them, the real values will be "
            "smaller.",
        ),
        targets=tuple(others), count=len(others),
    )  # fmt: skip
    return f"{predicted} {without}"


def _angle_text(radians: float) -> str:
    """Text of an angle in the unit that the user has chosen."""
    return local_amount(degrees(radians), DEGREES)
