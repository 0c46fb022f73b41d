"""Tests of the main window by mouse and keys, with a recording viewport."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractItemView, QLineEdit

from lispac.errors import PlaneNotFound, ProjectError
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.validate.planes_table import RMS
from lispac.gui.viewport.base import PickedPoint
from lispac.messages import note
from lispac.validation.local_models import DEFAULT_MODEL, LocalModel
from tests.gui.support import (
    Control,
    Demo,
    Driver,
    Key,
    Left,
    click,
    click_check,
    estimate,
    open_step,
    press,
    seed,
    sentence,
    wait_until_idle,
)
from tests.support.long_runs import LONG

# -- seeds -------------------------------------------------------------------------------------


def test_a_seed_highlights_the_plane_on_every_line_and_enter_accepts(opened: Driver):
    seed(opened, "T1")
    assert {h.key for h in opened.viewport.highlights} == {
        ("T1", line.name) for line in opened.project.lines
    }
    assert [m.label for m in opened.viewport.markers] == ["T1?"]
    assert opened.window.targets.candidate.isVisible()
    assert "6 of 6 lines" in opened.window.targets.candidate.detail.text()
    assert opened.project.targets == ()
    press(opened, Key.Key_Return)
    assert [t.name for t in opened.project.targets] == ["T1"]
    wait_until_idle(opened)
    assert [m.label for m in opened.viewport.markers] == ["T1"]
    assert not opened.window.targets.candidate.isVisible()
    assert sentence(opened, 1) == "1 target: second target required"


def test_escape_rejects_the_candidate(opened: Driver):
    before = opened.project
    seed(opened, "T1")
    press(opened, Key.Key_Escape)
    wait_until_idle(opened)
    assert opened.project is before
    assert opened.viewport.highlights == []
    assert not opened.window.document.undo_stack.canUndo()


def test_a_pick_is_one_undo_step(opened: Driver):
    seed(opened, "T1")
    click(opened, opened.window.targets.candidate.accept)
    assert opened.window.actions_["undo"].text() == "&Undo addition of T1"
    press(opened, Key.Key_Z, Control)
    assert opened.project.targets == ()
    assert opened.window.table.sightings.rowCount() == 0
    press(opened, Key.Key_Y, Control)
    assert [t.name for t in opened.project.targets] == ["T1"]


def test_a_validation_plane_by_key_gets_its_own_name_and_colour(opened: Driver):
    press(opened, Key.Key_F7)
    assert opened.window.targets.role == "validation"
    seed(opened, "V1")
    press(opened, Key.Key_Return)
    assert [(t.name, t.role) for t in opened.project.targets] == [("V1", "validation")]
    press(opened, Key.Key_F6)
    seed(opened, "T1")
    press(opened, Key.Key_Return)
    opened.rest()
    halos = {h.key[0]: h.halo for h in opened.viewport.highlights}
    assert halos == {"T1": theme.TARGET_COLOUR, "V1": theme.VALIDATION_COLOUR}
    for highlight in opened.viewport.highlights:
        assert highlight.colour == opened.viewport.colours[highlight.key[1]]


def test_a_missing_sighting_is_seeded_on_its_line(opened: Driver, demo: Demo):
    whole = demo.picked.target("T1")
    line = demo.survey.lines[2]
    without = replace(
        whole,
        sightings=tuple(s for s in whole.sightings if s.line != line),
        missing={line: note("finder.not_alike")},
    )
    opened.window.document.edit("pick", demo.project.with_target(without))
    open_step(opened, 1)
    panel, table = opened.window.targets, opened.window.table
    cell = table.sightings.index(0, 3)
    assert table.sightings.data(cell) == "–"
    assert message_text(note("finder.not_alike")) in table.sightings.data(
        cell, Qt.ItemDataRole.ToolTipRole
    )
    opened.bot.mouseClick(
        panel.table.viewport(),
        Left,
        pos=panel.table.visualItemRect(panel.table.item(0, 1)).center(),
    )
    panel.line_choice.setFocus()
    for _ in range(3):
        opened.bot.keyClick(panel.line_choice, Key.Key_Down)
    assert panel.line == line
    seed(opened, "T1")
    press(opened, Key.Key_Return)
    assert len(opened.project.target("T1").sightings) == 6
    assert opened.project.target("T1").missing == {}
    assert len(opened.project.targets) == 1


def test_a_click_without_a_point_or_plane_changes_nothing(opened: Driver):
    before = opened.project
    opened.viewport.click_empty()
    assert "No point under" in opened.window.task_bar.currentMessage()
    first = opened.window.document.survey.lines[0]
    opened.viewport.signals.seed_clicked.emit(PickedPoint(first, (0.0, 0.0, 500.0)))
    opened.rest()
    assert isinstance(opened.dialogs.errors[0], PlaneNotFound)
    assert opened.project is before


# -- editing the list ----------------------------------------------------------------------------


def test_rename_by_keyboard_keeps_the_order_and_refuses_an_existing_name(picked: Driver):
    open_step(picked, 1)
    table = picked.window.targets.table
    table.setCurrentCell(0, 0)
    table.setFocus()

    def type_name(name: str) -> None:
        picked.bot.keyClick(table, Key.Key_F2)
        editor = table.findChild(QLineEdit)
        editor.selectAll()
        picked.bot.keyClicks(editor, name)
        picked.bot.keyClick(editor, Key.Key_Return)
        picked.rest()

    type_name("Quay board")
    picked.bot.waitUntil(lambda: table.state() != table.State.EditingState)
    assert [t.name for t in picked.project.targets] == ["Quay board", "T2", "V1"]
    type_name("T2")
    assert isinstance(picked.dialogs.errors[0], ProjectError)
    assert [t.name for t in picked.project.targets] == ["Quay board", "T2", "V1"]
    assert table.item(0, 0).text() == "Quay board"
    # The refused name can be corrected
    picked.bot.waitUntil(lambda: [e.text() for e in table.findChildren(QLineEdit)] == ["T2"])
    picked.bot.keyClick(table.findChild(QLineEdit), Key.Key_Escape)
    picked.bot.waitUntil(lambda: table.state() != table.State.EditingState)
    assert [t.name for t in picked.project.targets] == ["Quay board", "T2", "V1"]


def test_remove_by_key(picked: Driver):
    open_step(picked, 1)
    table = picked.window.targets.table
    table.setFocus()
    table.selectRow(1)
    picked.bot.keyClick(table, Key.Key_Delete)
    assert [t.name for t in picked.project.targets] == ["T1", "V1"]


def test_a_sighting_is_excluded_by_its_check_box(picked: Driver):
    table = picked.window.table
    click_check(picked, table, table.sightings.index(0, 2))
    line = picked.project.lines[1].name
    assert not picked.project.target("T1").sighting(line).used
    assert picked.window.targets.table.item(0, 3).text() == "5 of 6"
    click_check(picked, table, table.sightings.index(1, 0))
    assert not picked.project.target("T2").used
    assert sentence(picked, 1) == "1 target: second target required"


def test_a_clicked_cell_is_selected_and_enter_goes_to_its_sighting(picked: Driver):
    table = picked.window.table
    place = table.visualRect(table.sightings.index(1, 1))
    picked.viewport.calls.clear()
    picked.bot.mouseClick(table.viewport(), Left, pos=place.center() + QPoint(20, 0))
    line = picked.project.lines[0].name
    assert picked.viewport.selected == ("T2", line)
    assert "fit" not in [name for name, _ in picked.viewport.calls]
    picked.bot.keyClick(table, Key.Key_Return)
    fitted = [arguments for name, arguments in picked.viewport.calls if name == "fit"]
    (points,) = fitted[-1]
    assert len(points) == len(picked.project.target("T2").sighting(line).indices)
    assert picked.window.targets.current == "T2"


def test_the_first_picture_of_a_project_has_its_targets(driver: Driver, demo: Demo) -> None:
    scene, view = driver.window.scene, driver.viewport
    counts: list[int] = []
    scene.drawn.connect(lambda: QTimer.singleShot(0, lambda: counts.append(len(view.highlights))))
    driver.window.document.open(demo.picked, demo.survey)
    driver.rest()
    assert counts[0] == len(view.highlights) > 0


# -- adjusting, validating, reporting ------------------------------------------------------------


def count_text(driver: Driver) -> str:
    driver.bot.waitUntil(
        lambda: "Counting" not in driver.window.adjust.count.text(), timeout=30_000
    )
    return driver.window.adjust.count.text()


def test_the_point_count_depends_on_the_subsampling_distance(picked: Driver):
    open_step(picked, 2)
    panel = picked.window.adjust
    ten_cm = count_text(picked)
    panel.distance.setFocus()
    panel.distance.selectAll()
    picked.bot.keyClicks(panel.distance, "30")
    picked.bot.waitUntil(lambda: count_text(picked) != ten_cm, timeout=30_000)
    kept = int(count_text(picked).split("</b>")[0].removeprefix("About <b>").replace(",", ""))
    assert 50 < kept < 1000
    assert panel.subsample == pytest.approx(0.30)
    panel.unit.setCurrentIndex(1)
    assert panel.distance.value() == pytest.approx(0.30)
    assert picked.project.settings.subsample == 0.10  # the project is edited only by Estimate


def test_a_count_that_fails_is_reported_once(picked: Driver, monkeypatch):
    def broken(*_):
        raise OSError(5, "Input/output error", "lines/L1")

    monkeypatch.setattr("lispac.workflow.calibration.estimation.count_points", broken)
    open_step(picked, 2)
    picked.window.adjust.distance.selectAll()
    picked.bot.keyClicks(picked.window.adjust.distance, "30")
    picked.bot.waitUntil(lambda: bool(picked.dialogs.errors), timeout=30_000)
    picked.bot.wait(300)
    assert [error.strerror for error in picked.dialogs.errors] == ["Input/output error"]
    monkeypatch.undo()
    picked.dialogs.errors.clear()
    picked.window.adjust.distance.selectAll()
    picked.bot.keyClicks(picked.window.adjust.distance, "20")
    picked.bot.waitUntil(lambda: count_text(picked).startswith("About"), timeout=30_000)
    assert not picked.dialogs.errors


def test_estimate_shows_angles_near_the_truth_and_the_lines_after(picked: Driver):
    open_step(picked, 2)
    click(picked, picked.window.adjust.estimate)
    picked.rest()
    result = picked.project.result
    truth = picked.project.truth_deg
    off = np.abs(np.degrees(result.boresight) - truth)
    assert (off < 4 * np.degrees(result.sigma)).all()
    table = picked.window.results.angles
    assert table.item(1, 1).text() == f"{np.degrees(result.boresight[1]):+.4f}".replace("-", "−")
    assert table.item(4, 1).text() == f"{truth[1]:+.4f}".replace("-", "−")
    # The thinned survey has too few points for the noise of each target
    assert result.chi_square.outcome == "failed"
    assert sentence(picked, 2) == "done, chi-square test failed"
    assert picked.window.scene.which == "estimated"
    after = picked.viewport.clouds[picked.project.lines[0].name]
    open_step(picked, 3)
    click(picked, picked.window.validate.before)
    before = picked.viewport.clouds[picked.project.lines[0].name]
    assert np.abs(after - before).max() > 0.05
    press(picked, Key.Key_B)
    assert picked.viewport.clouds[picked.project.lines[0].name] is after
    assert picked.window.actions_["after"].isChecked()
    press(picked, Key.Key_Z, Control)
    assert picked.project.result is None
    wait_until_idle(picked)
    assert picked.viewport.clouds[picked.project.lines[0].name] is before
    assert not picked.window.actions_["after"].isEnabled()


@LONG
def test_a_seed_on_the_estimated_lines_is_searched_in_the_prior_lines(picked: Driver):
    estimate(picked)
    line = picked.project.lines[1].name
    sighting = picked.project.target("T2").sighting(line)
    press(picked, Key.Key_F6)
    picked.viewport.click(line, int(sighting.indices[len(sighting.indices) // 2]))
    picked.rest()
    found = picked.window.controller.candidate
    shared = np.intersect1d(found.sighting(line).indices, sighting.indices)
    assert len(shared) > 0.9 * len(sighting.indices)
    place = picked.window.document.survey.clouds[line][sighting.indices]
    assert np.linalg.norm(place - found.seed, axis=1).min() < 1e-9


@LONG
def test_cancel_changes_nothing_and_estimate_runs_afterwards(picked: Driver):
    before = picked.project
    open_step(picked, 2)
    picked.window.adjust.cross_check.setChecked(False)
    click(picked, picked.window.adjust.estimate)
    assert picked.window.adjust.cancel.isVisible()
    click(picked, picked.window.adjust.cancel)
    picked.rest()
    assert picked.project is before
    assert not picked.window.document.undo_stack.canUndo()
    assert "cancelled" in picked.window.log.toPlainText()
    click(picked, picked.window.adjust.estimate)
    picked.rest()
    assert picked.project.result is not None
    assert picked.window.adjust.estimate.hasFocus()


def test_an_edit_cancels_the_adjustment_of_the_former_project(picked: Driver):
    press(picked, Key.Key_F9)
    picked.window.controller.use_target("T2", False)
    picked.rest()
    assert picked.project.result is None
    assert not picked.project.target("T2").used


@LONG
def test_validation_fills_the_histograms_and_the_report(picked: Driver, tmp_path: Path):
    estimate(picked)
    open_step(picked, 3)
    click(picked, picked.window.validate.run)
    picked.rest()
    (comparison,) = picked.project.validation
    assert comparison.after.rms < comparison.before.rms
    assert sentence(picked, 3) == "1 plane compared, not judged"
    panel = picked.window.histograms
    assert panel.isVisible()
    assert panel.current == "V1"
    assert panel.table.item(0, RMS).text() == (
        f"{comparison.before.rms * 1000:.1f} → {comparison.after.rms * 1000:.1f}"
    )
    axes = panel.canvas.figure.axes[0]
    assert len(axes.patches) + len(axes.collections) >= 2
    panel.plot.setFocus()
    QTest.keyClick(panel.plot, Qt.Key.Key_End)  # pairs of lines
    QTest.keyClick(panel.plot, Qt.Key.Key_Up)
    assert [axes.get_xlabel() for axes in panel.canvas.figure.axes] == ["Height (m)", "Range (m)"]

    click(picked, picked.window.validate.comparison.head)
    picked.window.validate.kind.setFocus()
    QTest.keyClick(picked.window.validate.kind, Qt.Key.Key_Down)
    assert picked.window.validate.neighbours.value() == 60
    click(picked, picked.window.validate.run)
    picked.rest()
    assert picked.project.validation[0].model == LocalModel("quadric", 60)
    assert "local quadric through 60 points" in panel.table.item(0, 0).toolTip()
    assert picked.window.document.undo_stack.undoText() == (
        "validation with local quadrics through 60 points"
    )
    # The fields are those of the shown plots.
    picked.window.document.undo_stack.undo()
    picked.rest()
    assert picked.window.validate.model == DEFAULT_MODEL
    assert picked.window.validation.distance_to == DEFAULT_MODEL
    picked.window.document.undo_stack.redo()
    picked.rest()
    assert picked.window.validate.model == LocalModel("quadric", 60)

    open_step(picked, 4)
    for name in ("calibration.json", "calibration.html"):
        picked.dialogs.path = tmp_path / name
        click(picked, picked.window.report.report)
        picked.rest()
    assert picked.dialogs.errors == []
    content = json.loads((tmp_path / "calibration.json").read_text())
    assert "boresight" in json.dumps(content)
    page = (tmp_path / "calibration.html").read_text()
    assert "before the calibration" in page
    assert "picture" not in {name for name, _ in picked.viewport.calls}, "they have own views"
    assert picked.window.scene.which == "estimated"


def test_unavailable_steps_are_disabled_with_an_explanation(opened: Driver):
    open_step(opened, 2)
    assert not opened.window.adjust.estimate.isEnabled()
    assert "targets first" in opened.window.adjust.advice.text()
    open_step(opened, 3)
    assert not opened.window.validate.run.isEnabled()
    assert not opened.window.validate.after.isEnabled()
    open_step(opened, 4)
    assert not opened.window.report.report.isEnabled()
    assert opened.window.report.lines.isEnabled()


def test_cells_of_the_table_are_not_editable(picked: Driver):
    triggers = picked.window.results.angles.editTriggers()
    assert triggers == QAbstractItemView.EditTrigger.NoEditTriggers
