"""Tests of the warnings panel: its messages, and the selection of the cause of a message."""

import threading
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPushButton, QWidget

from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.estimate.adjust_panel import AdjustPanel
from lispac.gui.features.pick_targets import target_actions
from lispac.gui.features.warnings.warnings_panel import (
    ACTION_LINE,
    INCOMPLETE_TEXT,
    NO_PROJECT_TEXT,
    NO_WARNINGS_TEXT,
    TITLE,
    WAITING_TEXT,
    level_counts_text,
)
from lispac.gui.project.status import ADJUST, DATA, TARGETS
from lispac.language import gettext
from lispac.messages import Action, Level, Message, error, is_routine, note, warning
from lispac.project import Project
from lispac.validation.comparison_results import LineShift, TwoModes
from lispac.warning_causes import Cause
from lispac.workflow.project.projects import save_project
from tests.gui.support import (
    WAIT_MS,
    Control,
    Demo,
    Driver,
    Key,
    Left,
    click,
    finish_layouts,
    press,
    wait_until_idle,
)
from tests.support.long_runs import LONG

Role = Qt.ItemDataRole


OUT_OF_DATE = note("project.out_of_date", subject=Cause.of_step("Adjust"))


def listed(driver: Driver) -> tuple[Message, ...]:
    """Messages of the panel, once they belong to the current project."""
    driver.rest()
    driver.bot.waitUntil(lambda: driver.window.warning_list.is_current, timeout=WAIT_MS)
    panel = driver.window.warnings
    driver.bot.waitUntil(lambda: panel.is_filled, timeout=WAIT_MS)
    texts = [
        panel.list.item(row).text().removesuffix(f"\n{ACTION_LINE}")
        for row in range(panel.list.count())
    ]
    assert texts == [message_text(each) for each in panel.messages]
    return panel.messages


def row_of(driver: Driver, text: str) -> int:
    rows = [k for k, each in enumerate(listed(driver)) if text in message_text(each)]
    assert len(rows) == 1, (text, [each.code for each in listed(driver)])
    return rows[0]


def open_list(driver: Driver) -> None:
    if not in_front(driver, TITLE):
        click(driver, driver.window.warnings_button)
    assert in_front(driver, TITLE)


def click_row(driver: Driver, row: int) -> None:
    open_list(driver)
    shown, routine = driver.window.warnings.list, driver.window.warnings.routine
    if shown.isRowHidden(row):
        click(driver, routine)
    finish_layouts()
    shown.scrollToItem(shown.item(row))
    finish_layouts()
    place = shown.visualItemRect(shown.item(row)).center()
    driver.bot.mouseClick(shown.viewport(), Left, pos=place)


def in_front(driver: Driver, title: str) -> bool:
    dock = {**driver.window.docks, **driver.window.panel_windows}[title]
    return dock.isVisible() and not dock.visibleRegion().isEmpty()


def has_focus(widget: QWidget) -> bool:
    return widget.isVisible() and QApplication.focusWidget() is widget


def in_view(driver: Driver, points: np.ndarray) -> bool:
    """Whether these points are the last ones that the view was fitted to."""
    fitted = [arguments[0] for name, arguments in driver.viewport.calls if name == "fit"]
    return np.array_equal(fitted[-1], points)


def with_few_points(project: Project) -> Project:
    target = project.target("T1")
    first = target.sightings[0]
    few = replace(first, indices=first.indices[:40])
    return project.with_target(replace(target, sightings=(few, *target.sightings[1:])))


def test_the_panel_explains_itself_without_a_project(driver: Driver) -> None:
    assert not driver.window.warnings_button.isVisible()
    press(driver, Key.Key_F12)
    assert in_front(driver, TITLE)
    assert driver.window.warnings.empty.text() == NO_PROJECT_TEXT
    assert driver.window.warnings.empty.isVisible()


def test_the_status_bar_counts_warnings_and_opens_the_list(adjusted: Driver) -> None:
    found = listed(adjusted)
    assert {each.level for each in found} == {Level.NOTE}
    routine = sum(map(is_routine, found))
    assert 0 < routine < len(found)
    counts = f"{len(found) - routine} notes"
    assert adjusted.window.warnings_button.text() == counts
    bad = (*found, warning("report.not_calibrated"))
    adjusted.window.warnings_button.show_warnings(bad)
    assert adjusted.window.warnings_button.text() == f"1 warning, {counts}"
    open_list(adjusted)
    assert has_focus(adjusted.window.warnings.list)
    click(adjusted, adjusted.window.warnings_button)
    assert not in_front(adjusted, TITLE)
    open_list(adjusted)
    icons = {
        adjusted.window.warnings.list.item(row).data(Role.AccessibleTextRole).partition(":")[0]
        for row in range(len(found))
    }
    assert icons == {"Note"}


def test_routine_notes_are_shown_on_request(adjusted: Driver) -> None:
    found, panel = listed(adjusted), adjusted.window.warnings
    click(adjusted, adjusted.window.warnings_button)
    rows = range(len(found))
    assert [panel.list.isRowHidden(row) for row in rows] == list(map(is_routine, found))
    click(adjusted, panel.routine)
    assert not any(panel.list.isRowHidden(row) for row in rows)
    click(adjusted, panel.routine)
    panel.show_warnings([each for each in found if is_routine(each)])
    assert not panel.routine.isVisible()
    assert not panel.list.isRowHidden(0), "without other messages, they are always shown"


def test_a_click_on_a_sighting_selects_its_cell_and_shows_it(picked: Driver) -> None:
    picked.window.document.edit("less", with_few_points(picked.project))
    line = picked.project.target("T1").sightings[0].line
    click_row(picked, row_of(picked, "The sighting has only 40 points."))
    window = picked.window
    assert in_front(picked, "Targets by line")
    assert has_focus(window.table)
    assert window.table.sightings.key(window.table.currentIndex()) == ("T1", line)
    assert window.scene.selected == ("T1", line)
    assert in_view(picked, window.scene.selected_points[line])


def test_enter_acts_like_a_click(picked: Driver) -> None:
    """Select the row with the arrow keys and press Enter."""
    picked.window.document.edit("less", with_few_points(picked.project))
    row = row_of(picked, "The sighting has only 40 points.")
    press(picked, Key.Key_F12)
    shown = picked.window.warnings.list
    assert has_focus(shown)
    picked.bot.keyClick(shown, Key.Key_Home)
    for _ in range(row):
        picked.bot.keyClick(shown, Key.Key_Down)
    assert shown.currentRow() == row
    picked.bot.keyClick(shown, Key.Key_Return)
    assert has_focus(picked.window.table)
    assert picked.window.scene.selected == ("T1", picked.project.target("T1").sightings[0].line)


def test_the_warning_of_an_excluded_target_selects_its_row(picked: Driver) -> None:
    picked.window.controller.use_target("T2", False)
    click_row(picked, row_of(picked, "Target T2 is excluded."))
    assert picked.window.workflow.opened == TARGETS
    assert has_focus(picked.window.targets.table)
    assert picked.window.targets.current == "T2"


@LONG
def test_the_warning_of_a_zero_lever_arm_focuses_its_field(picked: Driver) -> None:
    settings = replace(picked.project.settings, lever_arm=(0.0, 0.0, 0.0))
    picked.window.document.edit("zero", picked.project.with_settings(settings))
    picked.window.docks["Workflow"].close()
    click_row(picked, row_of(picked, "The lever arm is zero"))
    assert in_front(picked, "Workflow")
    assert picked.window.workflow.opened == DATA
    assert has_focus(picked.window.data.lever_arm.fields[0])


@LONG
def test_the_warning_of_a_scanner_far_below_focuses_its_z(picked: Driver) -> None:
    settings = replace(picked.project.settings, lever_arm=(1.2, 0.3, -2.1))
    picked.window.document.edit("below", picked.project.with_settings(settings))
    click_row(picked, row_of(picked, "2.10 m below the POS centre"))
    assert has_focus(picked.window.data.lever_arm.fields[2])


def test_the_note_of_a_line_selects_and_shows_it(picked: Driver, demo: Demo) -> None:
    """A note of the reader refers to the file of a line."""
    line = picked.project.lines[2]
    outside = note("import.excluded_outside", file=line.path.name, count=12, total=100)
    survey, text = replace(demo.survey, notes=(*demo.survey.notes, outside)), message_text(outside)
    picked.window.document.set_survey(picked.project, survey)
    found = listed(picked)[row_of(picked, text)]
    assert (found.level, found.subject) == (Level.NOTE, Cause.of_line(line.name))
    click_row(picked, row_of(picked, text))
    assert picked.window.workflow.opened == DATA
    assert has_focus(picked.window.data.lines)
    assert picked.window.data.lines.currentItem().text() == line.name
    assert in_view(picked, demo.survey.clouds[line.name].sample)


def test_the_group_of_a_cause_is_unfolded(adjusted: Driver) -> None:
    panel, workflow = adjusted.window.adjust, adjusted.window.workflow
    assert isinstance(panel, AdjustPanel)
    for cause, field in (
        (Cause.of_parameter("lever_z"), panel.parameters.switches["lever_z"]),
        (Cause.of_field("surface"), panel.model.surface),
        (Cause.of_field("pos_errors"), panel.chosen_model),
    ):
        workflow.open(DATA)
        adjusted.window.cause_navigation.show_cause(cause)
        assert workflow.opened == ADJUST
        assert has_focus(field)


def test_the_page_of_a_cause_is_raised(adjusted: Driver) -> None:
    adjusted.window.cause_navigation.show_cause(Cause.of_page("Cross-checks"))
    assert in_front(adjusted, "Diagnostics")
    assert adjusted.window.diagnostics.current.title == "Cross-checks"
    adjusted.window.cause_navigation.show_cause(Cause("result"))
    assert in_front(adjusted, "Results")
    assert has_focus(adjusted.window.results.angles)


def test_a_cause_that_no_longer_exists_is_ignored(adjusted: Driver) -> None:
    before = QApplication.focusWidget()
    adjusted.window.cause_navigation.show_cause(Cause.of_sighting("gone", "nowhere"))
    assert QApplication.focusWidget() is before


def test_the_list_is_updated_by_edits_undo_and_a_new_result(
    adjusted: Driver, demo: Demo, estimated: Project
) -> None:
    adjusted.window.document.open(replace(estimated, cross_checks=None), demo.survey)
    adjusted.rest()
    line = adjusted.project.target("T1").sightings[0].line
    expected = note(
        "report.left_out_target_on_lines",
        target="T1", lines=(line,), subject=Cause.of_target("T1"),
    )  # fmt: skip
    assert expected not in listed(adjusted)
    adjusted.window.controller.use_sighting("T1", line, False)
    assert adjusted.window.warnings.head.text() == WAITING_TEXT
    wait_until_idle(adjusted)
    assert expected in listed(adjusted)
    adjusted.window.document.undo_stack.undo()
    assert expected not in listed(adjusted)


def test_a_refused_estimate_is_reported(adjusted: Driver) -> None:
    for target in adjusted.project.targets_of_role("target"):
        adjusted.window.controller.use_target(target.name, False)
    wait_until_idle(adjusted)
    assert adjusted.window.document.refusal
    first = listed(adjusted)[0]
    refusal = adjusted.window.document.refusal
    assert first == warning("project.refused", reason=refusal, subject=Cause.of_step("Adjust"))
    click_row(adjusted, 0)
    assert adjusted.window.workflow.opened == ADJUST


@LONG
def test_a_result_removed_by_an_edit_is_reported_until_it_is_restored(
    adjusted: Driver,
) -> None:
    settings = replace(adjusted.project.settings, lidar_sigma=0.004)
    assert OUT_OF_DATE not in listed(adjusted)
    adjusted.window.controller.change_settings(settings)
    click_row(adjusted, row_of(adjusted, message_text(OUT_OF_DATE)))
    assert adjusted.window.workflow.opened == ADJUST
    assert has_focus(adjusted.window.workflow.headers[ADJUST])
    adjusted.window.document.undo_stack.undo()
    assert OUT_OF_DATE not in listed(adjusted)


def test_a_new_project_without_a_result_is_not_reported_as_out_of_date(
    adjusted: Driver, demo: Demo
) -> None:
    adjusted.window.document.open(demo.picked, demo.survey)
    assert OUT_OF_DATE not in listed(adjusted)


def test_gaps_of_the_trajectory_are_reported(picked: Driver, demo: Demo) -> None:
    """The note is that of the import dialogue."""
    track = demo.survey.trajectory
    late = track.time + np.where(np.arange(len(track.time)) > 500, 7.0, 0.0)
    survey = replace(demo.survey, trajectory=replace(track, time=late))
    picked.window.document.set_survey(picked.project, survey)
    (found,) = [each for each in listed(picked) if each.code == "project.trajectory_gaps"]
    assert found.params["longest"] == pytest.approx(7.0, abs=0.05)
    assert found.level is Level.NOTE


def test_a_failed_recovery_copy_is_listed(picked: Driver) -> None:
    picked.window.recovery_copies._on_write_failed(OSError("The disk is full"))
    (found,) = [each for each in listed(picked) if each.code == "project.storage"]
    problem = error("window.unsaved_work_not_kept", reason="The disk is full")
    assert found.params["reason"] == problem
    assert found.level is Level.WARNING


def test_an_empty_list_reports_no_warnings(picked: Driver) -> None:
    listed(picked)
    picked.window.warnings.show_warnings(())
    picked.window.warnings_button.show_warnings(())
    press(picked, Key.Key_F12)
    assert picked.window.warnings.empty.text() == NO_WARNINGS_TEXT
    assert picked.window.warnings_button.text() == "No messages"


def test_the_window_is_not_blocked_by_the_list(adjusted: Driver, monkeypatch) -> None:
    """The event loop runs until the warnings are gathered, each time for less than half a second.

    The time is that of the processor, so that other programs do not add to it.
    """
    from lispac.gui.features.warnings import warning_list

    gather, goes_on = warning_list.warnings_of, threading.Event()

    def slow(*arguments, **named):
        assert goes_on.wait(WAIT_MS / 1000)
        return gather(*arguments, **named)

    def turn() -> float:
        before = time.thread_time()
        QApplication.processEvents()
        return time.thread_time() - before

    listed(adjusted)
    monkeypatch.setattr(warning_list, "warnings_of", slow)
    adjusted.window.warning_list.update()
    turns = [turn() for _ in range(100)]
    assert not adjusted.window.warning_list.is_current
    goes_on.set()
    while not adjusted.window.warning_list.is_current:
        turns.append(turn())
        time.sleep(0.001)
    assert max(turns) < 0.5


@LONG
def test_the_button_of_the_message_on_the_lidar_noise_uses_the_noise_found(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    noisy = replace(
        estimated, cross_checks=None, result=replace(estimated.result, lidar_noise_ratio=0.5)
    )
    driver.window.document.open(noisy, demo.survey)
    row = row_with_code(driver, "adjustment.lidar_noise_conservative")
    open_list(driver)
    panel = driver.window.warnings
    panel.list.scrollToItem(panel.list.item(row))
    driver.rest()
    button = panel.findChild(QPushButton, "message_use_lidar_noise")
    place = button.mapTo(panel.list.viewport(), button.rect().center())
    assert panel.list.visualItemRect(panel.list.item(row)).contains(place)
    click(driver, button)
    driver.rest()
    given = noisy.settings.used_lidar_sigma
    assert driver.project.settings.lidar_sigma == pytest.approx(0.5 * given)
    press(driver, Key.Key_Z, Control)
    assert driver.project.settings == noisy.settings


def test_actions_on_files_have_no_button(driver: Driver) -> None:
    message = note("assumed.las_time", actions=(Action("set_option", {"name": "a", "value": 1}),))
    panel = driver.window.warnings
    panel.show_warnings([message])
    assert panel.list.count() == 1
    assert panel.findChildren(QPushButton) == []


def row_with_code(driver: Driver, code: str) -> int:
    (row,) = (k for k, each in enumerate(listed(driver)) if each.code == code)
    return row


def test_a_shift_of_a_line_on_a_validation_plane_is_listed(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    plane = validated.validation[0]
    lines = tuple(dict.fromkeys(name for p in plane.pairs for name in (p.line_a, p.line_b)))
    for offset, count in ((0.001, 0), (0.1, 1)):
        shift = LineShift(lines[:1], lines[1:], offset, 0.01)
        changed = replace(validated, validation=(replace(plane, shifts=(shift,)),))
        driver.window.document.open(changed, demo.survey)
        found = [each for each in listed(driver) if each.code == "validation.line_shifted"]
        assert len(found) == count
    click_row(driver, row_of(driver, message_text(found[0])))
    assert driver.window.data.lines.currentItem().text() == lines[0]


def test_two_groups_of_distances_on_a_validation_plane_are_listed(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    (plane,) = validated.validation
    (first, *others) = plane.pairs
    modes = TwoModes(0.04, 0.002, 0.3, 1e-9)
    bimodal = replace(plane, pairs=(replace(first, modes=modes), *others))
    driver.window.document.open(replace(validated, validation=(bimodal,)), demo.survey)
    row = row_with_code(driver, "validation.two_modes")
    message = driver.window.warnings.messages[row]
    assert message.level is Level.WARNING
    assert (message.params["target"], message.params["distance"]) == (plane.name, 0.04)
    click_row(driver, row)
    assert driver.window.scene.selected[0] == plane.name


@LONG
def test_a_reopened_project_shows_the_same_messages(
    driver: Driver, demo_copy: Path, demo: Demo, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Until all its sightings are rated, the number of messages is marked as incomplete."""
    save_project(replace(demo.picked, folder=demo_copy))
    window = driver.window
    window.open_project(demo_copy)
    driver.rest()
    press(driver, Key.Key_F9)
    driver.rest()
    press(driver, Key.Key_F10)
    driver.rest()
    assert driver.project.validation
    press(driver, Key.Key_S, Control)
    driver.rest()
    before, counts = listed(driver), window.warnings_button.text()
    assert any(each.code.startswith("project.doubtful") for each in before)
    assess, goes_on = target_actions.assess_sightings, threading.Event()

    def slow(*arguments, **named):
        assert goes_on.wait(WAIT_MS / 1000)
        return assess(*arguments, **named)

    monkeypatch.setattr(target_actions, "assess_sightings", slow)
    former = driver.project
    window.open_project(demo_copy)
    button, panel = window.warnings_button, window.warnings
    driver.bot.waitUntil(
        lambda: (
            driver.project is not former
            and window.warning_list.is_current
            and "project.import_note" in {each.code for each in panel.messages}
            and window.runner.active
        ),
        timeout=WAIT_MS,
    )
    incomplete = gettext(INCOMPLETE_TEXT, counts=level_counts_text(panel.messages))
    assert len(panel.messages) < len(before)
    assert panel.head.text().startswith(incomplete)
    assert button.text().endswith(" …")
    assert incomplete in button.toolTip()
    goes_on.set()
    assert listed(driver) == before
    assert driver.project.result is not None
    assert button.text() == counts
    assert panel.head.text().startswith(counts)
