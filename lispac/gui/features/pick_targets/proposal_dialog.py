"""Dialogue with the proposed targets: a list to tick, accept or reject."""

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
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance import theme, units
from lispac.gui.features.pick_targets.actions import ACTIONS
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.workflow.calibration.proposals import Proposal

ROLE_NAMES = {"target": N_("Target"), "validation": N_("Validation plane")}
COLUMN_TITLES = (N_("Name"), N_("Role"), N_("Lines"), N_("Reason"))


class ProposedTargetsDialog(QDialog):
    """Dialogue with proposed targets and validation planes and reasons, initially all ticked."""

    def __init__(self, proposal: Proposal, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("proposal_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["propose"]))
        self.resize(860, 420)
        self._proposal = proposal
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(widgets.label(_introduction(proposal), wrap=True, name="proposal_sigmas"))
        warnings = widgets.label("", "warning", wrap=True, name="proposal_warnings")
        warnings.setText("\n".join(map(message_text, proposal.warnings)))
        warnings.setVisible(bool(proposal.warnings))
        layout.addWidget(warnings)
        self.table = QTableWidget(len(proposal.targets), 4)
        self.table.setTabKeyNavigation(False)
        self.table.setObjectName("proposal_table")
        self.table.setAccessibleName(gettext("Proposed targets and validation planes"))
        self.table.setHorizontalHeaderLabels([gettext(head) for head in COLUMN_TITLES])
        self.table.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft)
        self.table.verticalHeader().hide()
        self.table.setShowGrid(False)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setProperty("rows", True)  # no frame around a cell, like a button
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._fill(proposal)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(3, QHeaderView.ResizeMode.Stretch)
        # The heights of the rows depend on the final width of the reasons.
        self.table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.setStyleSheet("QTableWidget::item { padding: 4px 6px; }")
        self.table.itemChanged.connect(lambda _item: self._show_count())
        layout.addWidget(self.table, 1)
        self.accept_button = widgets.button(
            "", "accept_proposal", primary=True, tip=gettext("Add the ticked targets and planes")
        )
        self.accept_button.setDefault(True)
        self.accept_button.clicked.connect(self.accept)
        reject = widgets.button(
            gettext("Reject all"),
            "reject_proposal",
            tip=gettext("Close without adding targets or planes"),
        )
        reject.setAutoDefault(False)  # Enter accepts, wherever the focus is
        reject.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.accept_button, reject):
            row.addWidget(each)
        layout.addLayout(row)
        self._show_count()

    @property
    def ticked_entries(self) -> tuple[str, ...]:
        """Names of the ticked targets and planes."""
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
            name.setToolTip(gettext("Untick to exclude this target or plane"))
            role = QTableWidgetItem(gettext(ROLE_NAMES[target.role]))
            lines = [sighting.line for sighting in target.sightings]
            count_item = QTableWidgetItem(str(len(lines)))
            count_item.setToolTip(
                widgets.plain_tip(gettext("Observed on lines: {lines:names}", lines=lines))
            )
            text = message_text(proposal.reasons[target.name])
            reason = QTableWidgetItem(text)
            reason.setToolTip(widgets.plain_tip(text))
            for column, item in enumerate((name, role, count_item, reason)):
                self.table.setItem(row, column, item)

    def _show_count(self) -> None:
        ticked, total = len(self.ticked_entries), self.table.rowCount()
        self.accept_button.setText(
            gettext("Add {ticked:n} of {total:n} surfaces", ticked=ticked, total=total)
        )
        self.accept_button.setEnabled(ticked > 0)


def _introduction(proposal: Proposal) -> str:
    """Predicted standard deviations, and the purpose of the validation planes."""
    return "\n".join(
        [
            _targets_text(proposal),
            gettext(
                "Validation planes are not used in the adjustment; they only serve to check that "
                "the lines agree. Untick the targets and planes that you do not want to add."
            ),
        ]
    )


def _targets_text(proposal: Proposal) -> str:
    """Text on the predicted precision, or that all useful targets are picked."""
    if not any(target.role == "target" for target in proposal.targets):
        return gettext(
            "No more targets are proposed because all suitable surfaces are already targets or "
            "validation planes: {targets:names}.",
            targets=proposal.picked,
        )
    sigmas = dict(zip(ANGLES, map(_angle_text, proposal.sigma), strict=True))
    if proposal.picked:
        return gettext(
            "Predicted standard deviations of the boresight with the proposed and the existing "
            "targets ({targets:names}): roll {roll}, pitch {pitch}, yaw {yaw}.",
            targets=proposal.picked, **sigmas,
        )  # fmt: skip
    return gettext(
        "Predicted standard deviations of the boresight with the proposed targets: roll {roll}, "
        "pitch {pitch}, yaw {yaw}.",
        **sigmas,
    )


def _angle_text(radians: float) -> str:
    """Text of an angle in the unit that the user has chosen."""
    sign = units.shown_unit("°").sign
    value = units.localised(units.figure(degrees(radians), "°", ".3f"))
    return value + (sign if sign in "°′″" else f"\N{NO-BREAK SPACE}{sign}")
