"""Tests of proposed targets, and of finding a target again, with the real dialogues."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDoubleSpinBox,
    QLabel,
    QPushButton,
    QTableView,
    QTableWidget,
)

from lispac.gui.features.pick_targets.proposal_dialog import ProposedTargetsDialog
from lispac.project import Project
from lispac.workflow.calibration.proposal_acceptance import (
    remove_picked_surfaces,
    with_accepted_targets,
)
from lispac.workflow.calibration.proposals import Proposal, propose_targets
from tests.gui.support import Demo, Driver, Left, click, open_step

TARGETS_STEP = 1
"""Index of the step of the workflow."""


@pytest.fixture(scope="module")
def proposal(demo: Demo) -> Proposal:
    """Proposed targets of the demo."""
    return propose_targets(demo.project, demo.survey)


def use_next_dialog(driver: Driver, use_dialog: Callable[[QDialog], None]) -> None:
    """Call ``use_dialog`` with the next modal dialogue."""

    def inspect_window() -> None:
        dialog = QApplication.activeModalWidget()
        if dialog is None:
            QTimer.singleShot(50, inspect_window)
        else:
            use_dialog(dialog)

    QTimer.singleShot(50, inspect_window)


def press(driver: Driver, dialog: QDialog, name: str) -> None:
    driver.bot.mouseClick(dialog.findChild(QPushButton, name), Left)


def test_some_proposed_targets_are_accepted_and_undone_in_one_step(opened: Driver) -> None:
    open_step(opened, TARGETS_STEP)
    before = opened.project
    shown_content = []

    def use_dialog(dialog: QDialog) -> None:
        table = dialog.findChild(QTableWidget, "proposal_table")
        rows = range(table.rowCount())
        shown_content.append([[table.item(row, k).text() for k in range(4)] for row in rows])
        shown_content.append(dialog.findChild(object, "proposal_sigmas").text())
        table.item(0, 0).setCheckState(Qt.CheckState.Unchecked)
        press(opened, dialog, "accept_proposal")

    use_next_dialog(opened, use_dialog)
    click(opened, opened.window.targets.propose)
    assert opened.window.runner.busy
    assert not opened.window.targets.propose.isEnabled()
    opened.rest()
    rows, sigmas = shown_content
    assert [row[1] for row in rows].count("Validation plane") >= 4
    assert all(row[3] for row in rows)
    assert "roll 0." in sigmas
    names = [target.name for target in opened.project.targets]
    assert names == [row[0] for row in rows][1:]
    assert opened.window.document.undo_stack.undoText() == "addition of proposed targets"
    opened.window.document.undo_stack.undo()
    assert opened.project is before


def test_the_return_key_accepts_the_proposed_targets(opened: Driver, proposal: Proposal) -> None:
    """Enter accepts, as in other dialogues; rejecting would discard a minute of work."""
    dialog = ProposedTargetsDialog(proposal)
    with opened.bot.waitExposed(dialog):
        dialog.open()
    dialog.table.setFocus()
    opened.bot.keyClick(dialog.table, Qt.Key.Key_Tab)
    assert dialog.focusWidget() is dialog.accept_button
    dialog.table.setFocus()
    opened.bot.keyClick(dialog.table, Qt.Key.Key_Return)
    assert dialog.result() == QDialog.DialogCode.Accepted
    dialog.deleteLater()


def test_the_tab_key_leads_out_of_every_table(opened: Driver) -> None:
    tables = opened.window.findChildren(QTableView)
    assert len(tables) > 5
    assert [table.objectName() for table in tables if table.tabKeyNavigation()] == []


def test_a_proposal_rejected_or_cancelled_changes_nothing(opened: Driver) -> None:
    open_step(opened, TARGETS_STEP)
    before = opened.project
    use_next_dialog(opened, lambda dialog: press(opened, dialog, "reject_proposal"))
    click(opened, opened.window.targets.propose)
    opened.rest()
    assert opened.project is before
    click(opened, opened.window.targets.propose)
    opened.bot.waitUntil(lambda: opened.window.runner.current.fraction > 0)
    opened.window.actions_["cancel"].trigger()
    opened.rest()
    assert opened.project is before
    assert not opened.window.document.undo_stack.canUndo()
    assert opened.window.targets.propose.isEnabled()


def test_existing_targets_are_not_proposed_and_names_are_unique(
    demo: Demo, proposal: Proposal
) -> None:
    remaining = remove_picked_surfaces(demo.picked, proposal)
    assert len(remaining.targets) < len(proposal.targets)
    assert set(remaining.picked) <= {"T1", "T2"}
    existing_names = {target.name for target in demo.picked.targets}
    assert existing_names.isdisjoint(target.name for target in remaining.targets)
    assert set(remaining.reasons) == {target.name for target in remaining.targets}
    project, new_names = with_accepted_targets(
        demo.picked, remaining, {target.name for target in remaining.targets}
    )
    assert new_names == tuple(target.name for target in remaining.targets), "as the list shows them"
    names = [target.name for target in project.targets]
    assert len(set(names)) == len(names) == len(demo.picked.targets) + len(new_names)
    for target in demo.picked.targets:
        assert project.target(target.name) is target


@pytest.mark.parametrize(
    ("known", "words"),
    [
        (0, "deviations of the boresight with the proposed targets: roll 0.0"),
        (1, "with the proposed and the existing targets (A1): roll 0.0"),
        (9, "already targets or validation planes: A1, A2"),
    ],
)
def test_the_heading_names_the_targets_of_the_sigmas(
    qtbot, demo: Demo, proposal: Proposal, known: int, words: str
) -> None:
    targets = [target for target in proposal.targets if target.role == "target"][:known]
    named = tuple(replace(target, name=f"A{k + 1}") for k, target in enumerate(targets))
    dialog = ProposedTargetsDialog(
        remove_picked_surfaces(replace(demo.project, targets=named), proposal)
    )
    qtbot.addWidget(dialog)
    assert words in dialog.findChild(QLabel, "proposal_sigmas").text()
    names = [dialog.table.item(row, 0).text() for row in range(dialog.table.rowCount())]
    assert names[0] == ("V1" if known == 9 else "T1")


def test_a_proposal_with_nothing_ticked_cannot_be_accepted(qtbot, proposal: Proposal) -> None:
    dialog = ProposedTargetsDialog(proposal)
    qtbot.addWidget(dialog)
    for row in range(dialog.table.rowCount()):
        dialog.table.item(row, 0).setCheckState(Qt.CheckState.Unchecked)
    assert dialog.ticked_entries == ()
    assert not dialog.accept_button.isEnabled()


def find_again(driver: Driver, threshold_mm: float, radius: float) -> Project:
    """Find the selected target again with the menu, and return the project."""

    def use_dialog(dialog: QDialog) -> None:
        dialog.findChild(QDoubleSpinBox, "again_threshold").setValue(threshold_mm)
        dialog.findChild(QDoubleSpinBox, "again_radius").setValue(radius)
        press(driver, dialog, "again_find")

    use_next_dialog(driver, use_dialog)
    driver.window.actions_["find_again"].trigger()
    driver.rest()
    return driver.project


def test_a_target_is_found_again_with_other_settings(picked: Driver) -> None:
    open_step(picked, TARGETS_STEP)
    picked.window.targets.table.clearSelection()
    assert not picked.window.actions_["find_again"].isEnabled()
    line = picked.project.target("T1").sightings[0].line
    picked.window.controller.use_sighting("T1", line, False)
    picked.rest()
    picked.window.targets.select("T1")
    picked.bot.waitUntil(picked.window.actions_["find_again"].isEnabled)
    before = picked.project
    assert find_again(picked, 15, 1.5) is before  # a candidate, not accepted yet
    candidate = picked.window.controller.candidate
    assert (candidate.threshold, candidate.radius) == (0.015, 1.5)
    click(picked, picked.window.targets.candidate.accept)
    target = picked.project.target("T1")
    assert (target.threshold, target.radius) == (0.015, 1.5)
    assert not target.sighting(line).used
    assert picked.window.document.undo_stack.undoText() == "detection of T1"
