"""Tests of proposed targets, and of finding a target again, with the real dialogues."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import (
    QDialog,
    QDoubleSpinBox,
    QLabel,
    QPushButton,
    QTableView,
    QTableWidget,
)

from lispac.gui.appearance import theme
from lispac.gui.features.pick_targets.proposed_targets_panel import ProposedTargetsPanel
from lispac.gui.project.scene import proposed_key
from lispac.progress import Progress
from lispac.project import Project
from lispac.workflow.calibration.proposal_acceptance import (
    remove_picked_surfaces,
    with_accepted_targets,
)
from lispac.workflow.calibration.proposals import Proposal, propose_targets
from lispac.workflow.project.survey import Survey
from tests.gui.support import (
    Demo,
    Driver,
    Left,
    click,
    double_click,
    open_step,
    seed,
    use_next_dialog,
)
from tests.support.long_runs import LONG

TARGETS_STEP = 1
"""Index of the step of the workflow."""


SEARCH = "lispac.workflow.calibration.proposals.propose_targets"
FOUND: list[Proposal] = []
"""Proposals of searches in the window with the demo."""


@pytest.fixture(scope="module")
def proposal(demo: Demo) -> Proposal:
    """Proposed targets of the demo, if possible of a search in the window; it takes ten seconds."""
    return FOUND[0] if FOUND else propose_targets(demo.project, demo.survey)


def press(driver: Driver, dialog: QDialog, name: str) -> None:
    driver.bot.mouseClick(dialog.findChild(QPushButton, name), Left)


def propose(driver: Driver) -> QTableWidget:
    """Press the button, wait, and return the table of the proposal."""
    open_step(driver, TARGETS_STEP)
    click(driver, driver.window.targets.propose)
    driver.rest()
    return driver.window.targets.proposal.table


@pytest.fixture
def table(opened: Driver, proposal: Proposal, monkeypatch: pytest.MonkeyPatch) -> QTableWidget:
    """The table of the proposal, whose search is that of an earlier test of this file."""
    with monkeypatch.context() as patch:
        patch.setattr(SEARCH, lambda *_arguments, **_named: proposal)
        return propose(opened)


def cells(table: QTableWidget, column: int) -> list[str]:
    return [table.item(row, column).text() for row in range(table.rowCount())]


@LONG
def test_some_proposed_targets_are_accepted_and_undone_in_one_step(
    opened: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    def search(project: Project, survey: Survey, *, progress: Progress) -> Proposal:
        FOUND.append(propose_targets(project, survey, progress=progress))
        return FOUND[-1]

    monkeypatch.setattr(SEARCH, search)
    before = opened.project
    table = propose(opened)
    panel = opened.window.targets.proposal
    assert cells(table, 1).count("Validation plane") >= 4
    sigmas = panel.findChild(QLabel, "proposal_sigmas")
    assert "roll 0." in sigmas.text()
    with_all = sigmas.text()
    assert opened.project is before
    proposed = cells(table, 0)
    opened.bot.keyClick(table, Qt.Key.Key_Space)  # unticks the first one
    assert sigmas.text() != with_all
    click(opened, panel.accept_button)
    opened.rest()
    assert not panel.isVisible()
    assert [target.name for target in opened.project.targets] == proposed[1:]
    assert opened.project.prediction is not None
    assert "T1" not in opened.project.prediction.targets
    assert opened.window.document.undo_stack.undoText() == "addition of proposed targets"
    opened.window.document.undo_stack.undo()
    assert opened.project is before


def test_proposed_targets_are_shown_in_the_scene_and_selected_with_the_keys(
    opened: Driver, table: QTableWidget
) -> None:
    view, names = opened.viewport, cells(table, 0)
    assert {marker.label for marker in view.markers} == {f"{name}?" for name in names}
    assert {each.key[0] for each in view.highlights} == {proposed_key(name) for name in names}
    reason = opened.window.targets.proposal.reason
    reasons = set()
    for name in names:
        assert view.selected == (proposed_key(name), "")
        assert name in reason.text()
        assert reason.hasHeightForWidth(), "not cut off"
        reasons.add(reason.text())
        opened.bot.keyClick(table, Qt.Key.Key_Down)
    assert len(reasons) == len(names)
    assert [each.label for each in view.markers if each.is_selected] == [f"{names[-1]}?"]
    view.calls.clear()
    double_click(opened, table, len(names) - 1, 1)
    (zoomed,) = [arguments[0] for call, arguments in view.calls if call == "fit"]
    shown = [each.points for each in view.highlights if each.key[0] == proposed_key(names[-1])]
    assert len(zoomed) == sum(map(len, shown))
    opened.bot.keyClick(table, Qt.Key.Key_Space)
    opened.rest()
    grey = {marker.label for marker in view.markers if marker.colour == theme.UNUSED_COLOUR}
    assert grey == {f"{names[-1]}?"}
    view.widget.resize(1, 1)
    view.calls.clear()
    opened.window.scene.select_proposed(names[0])
    ((_, (fitted,)),) = [call for call in view.calls if call[0] == "fit"]
    key = proposed_key(names[0])
    own = np.concatenate([each.points for each in view.highlights if each.key[0] == key])
    assert np.ptp(fitted, axis=0) == pytest.approx(5 * np.ptp(own, axis=0)), "with surroundings"


def test_the_buttons_stay_in_place_when_another_row_is_selected(
    opened: Driver, table: QTableWidget
) -> None:
    panel = opened.window.targets.proposal
    places, needed = set(), set()
    for _ in range(table.rowCount()):
        opened.rest()
        buttons = (panel.accept_button, panel.reject_button)
        places.add(tuple(each.mapTo(opened.window, QPoint()).toTuple() for each in buttons))
        unreserved = QLabel(panel.reason.text())
        unreserved.setWordWrap(True)
        needed.add(unreserved.heightForWidth(panel.reason.width()))
        opened.bot.keyClick(table, Qt.Key.Key_Down)
    assert len(needed) > 1, "the descriptions have different heights"
    assert len(places) == 1


def test_the_return_key_accepts_the_proposed_targets(opened: Driver, table: QTableWidget) -> None:
    """Enter accepts; rejecting would discard a minute of work."""
    names = cells(table, 0)
    assert opened.window.focusWidget() is table
    opened.bot.keyClick(table, Qt.Key.Key_Tab)
    assert opened.window.focusWidget() is opened.window.targets.proposal.accept_button
    opened.bot.keyClick(table, Qt.Key.Key_Return)
    opened.rest()
    assert [target.name for target in opened.project.targets] == names


def test_a_target_picked_meanwhile_is_no_longer_proposed(
    opened: Driver, table: QTableWidget
) -> None:
    count = table.rowCount()
    opened.bot.keyClick(table, Qt.Key.Key_End, Qt.KeyboardModifier.ControlModifier)
    opened.bot.keyClick(table, Qt.Key.Key_Space)
    seed(opened, "T1")
    click(opened, opened.window.targets.candidate.accept)
    opened.rest()
    assert [target.name for target in opened.project.targets] == ["T1"]
    assert table.rowCount() == count - 1
    assert "T1" not in cells(table, 0)
    ticked = opened.window.targets.proposal.ticked_entries
    assert ticked == tuple(cells(table, 0)[:-1]), "still unticked"


def test_a_candidate_has_another_name_than_the_proposed_targets(
    opened: Driver, table: QTableWidget
) -> None:
    view, names = opened.viewport, cells(table, 0)
    proposed = [proposed_key(name) for name in names]
    seed(opened, "T1")
    candidate = opened.window.controller.candidate
    assert candidate.name in names
    others = cells(table, 0)
    assert len(others) == len(names) - 1, "its surface is no longer proposed"
    keys = {each.key[0] for each in view.highlights}
    assert keys == {*map(proposed_key, others), candidate.name}
    labels = [marker.label for marker in view.markers]
    assert sorted(labels) == sorted(f"{name}?" for name in (*others, candidate.name))
    assert candidate.name not in others
    assert view.selected == (candidate.name, "")
    click(opened, opened.window.targets.candidate.reject)
    opened.rest()
    assert {each.key[0] for each in view.highlights} == set(proposed)


def test_the_tab_key_leads_out_of_every_table(opened: Driver) -> None:
    tables = opened.window.findChildren(QTableView)
    assert len(tables) > 5
    assert [table.objectName() for table in tables if table.tabKeyNavigation()] == []


def test_a_proposal_rejected_or_cancelled_changes_nothing(
    opened: Driver, table: QTableWidget
) -> None:
    before = opened.project
    assert table.rowCount() > 0
    click(opened, opened.window.targets.proposal.reject_button)
    opened.rest()
    assert opened.project is before
    assert opened.viewport.markers == []
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
    ("picked_count", "words"),
    [
        (0, "deviations of the boresight with the ticked targets: roll 0.0"),
        (1, "with the ticked targets and A1: roll 0.0"),
        (9, "already targets or validation planes: A1, A2"),
    ],
)
def test_the_heading_names_the_targets_of_the_sigmas(
    qtbot, demo: Demo, proposal: Proposal, picked_count: int, words: str
) -> None:
    targets = [target for target in proposal.targets if target.role == "target"][:picked_count]
    named = tuple(replace(target, name=f"A{k + 1}") for k, target in enumerate(targets))
    panel = ProposedTargetsPanel()
    qtbot.addWidget(panel)
    panel.show_proposal(remove_picked_surfaces(replace(demo.project, targets=named), proposal))
    assert words in panel.findChild(QLabel, "proposal_sigmas").text()
    names = cells(panel.table, 0)
    assert names[0] == ("V1" if picked_count == 9 else "T1")


def test_the_heading_names_the_targets_that_the_sigmas_do_not_include(
    qtbot, demo: Demo, proposal: Proposal
) -> None:
    first = next(target for target in proposal.targets if target.role == "target")
    project = replace(demo.project, targets=(replace(first, name="A1"),))
    panel = ProposedTargetsPanel()
    qtbot.addWidget(panel)
    shown = panel.findChild(QLabel, "proposal_sigmas")
    left = remove_picked_surfaces(project, proposal)
    panel.show_proposal(left, (), ["A1"])
    without = shown.text()
    panel.show_proposal(left, (), ["A1", "Q7"])
    assert shown.text().startswith(without)
    assert "Q7" in shown.text().removeprefix(without)


def test_a_proposal_with_nothing_ticked_cannot_be_accepted(qtbot, proposal: Proposal) -> None:
    panel = ProposedTargetsPanel()
    qtbot.addWidget(panel)
    panel.show_proposal(proposal)
    for row in range(panel.table.rowCount()):
        panel.table.item(row, 0).setCheckState(Qt.CheckState.Unchecked)
    assert panel.ticked_entries == ()
    assert not panel.accept_button.isEnabled()


def find_again(driver: Driver, threshold_mm: float, radius: float) -> Project:
    """Find the selected target again with the menu, and return the project."""

    def use_dialog(dialog: QDialog) -> None:
        dialog.findChild(QDoubleSpinBox, "again_threshold").setValue(threshold_mm)
        dialog.findChild(QDoubleSpinBox, "again_radius").setValue(radius)
        press(driver, dialog, "again_find")

    use_next_dialog(use_dialog)
    driver.window.actions_["find_again"].trigger()
    driver.rest()
    return driver.project


@LONG
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
    assert picked.window.document.undo_stack.undoText() == "addition of T1"
