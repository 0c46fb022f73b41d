"""What is proposed: a list to tick in, accept or reject."""

from math import degrees

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QHBoxLayout,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.adjustment.result import ANGLES
from lispac.adjustment.shown import listed
from lispac.gui import theme, units
from lispac.gui.language import say, say_all, say_message
from lispac.gui.panels import widgets
from lispac.workflow.proposing import Proposal

ROLES = {"target": "Target", "validation": "Validation plane"}


class ProposalDialog(QDialog):
    """Targets and validation planes with the reason of each; all are ticked at first."""

    def __init__(self, proposal: Proposal, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("proposal_dialog")
        self.setWindowTitle(say("Proposed targets"))
        self.resize(860, 420)
        self._proposal = proposal
        layout = widgets.column(self, 16)
        layout.addWidget(widgets.label(_said(proposal), wrap=True, name="proposal_sigmas"))
        warnings = widgets.label("", "warning", wrap=True, name="proposal_warnings")
        warnings.setText("\n".join(map(say_message, proposal.warnings)))
        warnings.setVisible(bool(proposal.warnings))
        layout.addWidget(warnings)
        self.table = QTableWidget(len(proposal.targets), 4)
        self.table.setTabKeyNavigation(False)
        self.table.setObjectName("proposal_table")
        self.table.setAccessibleName(say("Proposed targets and validation planes"))
        self.table.setHorizontalHeaderLabels(say_all(["Name", "Role", "Lines", "Why"]))
        self.table.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft)
        self.table.verticalHeader().hide()
        self.table.setShowGrid(False)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setProperty("rows", True)  # no frame about one cell: it looked like a button
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._fill(proposal)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(3, QHeaderView.ResizeMode.Stretch)
        # Rows follow the width the reasons get in the end.
        self.table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.setStyleSheet("QTableWidget::item { padding: 4px 6px; }")
        self.table.itemChanged.connect(lambda _item: self._count())
        layout.addWidget(self.table, 1)
        self.accept_button = widgets.button(
            "", "accept_proposal", primary=True, tip="Add the ticked ones to the project"
        )
        self.accept_button.setDefault(True)
        self.accept_button.clicked.connect(self.accept)
        reject = widgets.button("Reject", "reject_proposal", tip="Add nothing")
        reject.setAutoDefault(False)  # Enter accepts, wherever the focus is
        reject.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_order(self.accept_button, reject):
            row.addWidget(each)
        layout.addLayout(row)
        self._count()

    @property
    def ticked(self) -> tuple[str, ...]:
        """Names of those that are to be added."""
        checked = Qt.CheckState.Checked
        return tuple(
            target.name
            for row, target in enumerate(self._proposal.targets)
            if self.table.item(row, 0).checkState() == checked
        )

    def _fill(self, proposal: Proposal) -> None:
        for row, target in enumerate(proposal.targets):
            is_target = target.role == "target"
            colour = theme.TARGET_COLOUR if is_target else theme.VALIDATION_COLOUR
            name = QTableWidgetItem(theme.swatch(colour), target.name)
            name.setFlags(name.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            name.setCheckState(Qt.CheckState.Checked)
            name.setToolTip(say("Untick to leave it out"))
            lines = ", ".join(sighting.line for sighting in target.sightings)
            seen = QTableWidgetItem(str(len(target.sightings)))
            seen.setToolTip(widgets.plain_tip(say(f"Seen on {lines}")))
            why = QTableWidgetItem(say(proposal.reasons[target.name]))
            why.setToolTip(widgets.plain_tip(say(proposal.reasons[target.name])))
            for column, item in enumerate(
                (name, QTableWidgetItem(say(ROLES[target.role])), seen, why)
            ):
                self.table.setItem(row, column, item)

    def _count(self) -> None:
        count = len(self.ticked)
        self.accept_button.setText(say(f"Accept {count} of {self.table.rowCount()}"))
        self.accept_button.setEnabled(count > 0)


def _said(proposal: Proposal) -> str:
    return (
        f"{_targets_said(proposal)} Validation planes take no part in the adjustment; the lines "
        "are compared on them. Untick what you do not want."
    )


def _targets_said(proposal: Proposal) -> str:
    """What the targets give, or that there are no further ones."""
    picked = listed(proposal.picked) if proposal.picked else ""
    if not any(target.role == "target" for target in proposal.targets):
        return f"No further targets are proposed: what would serve is picked already ({picked})."
    sigmas = ", ".join(
        f"{angle} {units.amount(degrees(value), '°', '.3f')}"
        for angle, value in zip(ANGLES, proposal.sigma, strict=True)
    )
    also = f" and of {picked}, picked already" if picked else ""
    return f"Standard deviations of the boresight from all targets proposed{also}: {sigmas}."
