"""Tests of editing: lasso, roles, names of the undo steps, and residuals as colours."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from lispac.geometry.planes import fit_plane
from lispac.gui.project.residuals import OTHER_POINTS_COLOUR, residuals, validation_distances
from lispac.present.targets.sightings import sighting_values
from tests.gui.support import Control, Driver, Key, press, seed, wait_until_idle
from tests.support.long_runs import LONG

SHIFT = Qt.KeyboardModifier.ShiftModifier


def undo_text(driver: Driver) -> str:
    return driver.window.actions_["undo"].text().replace("&", "")


def outline(driver: Driver, points: np.ndarray) -> None:
    """Draw a rectangular lasso around points in the recording viewport."""
    pixels = driver.viewport.to_pixels(points)
    (left, top), (right, low) = pixels.min(axis=0) - 1e-6, pixels.max(axis=0) + 1e-6
    corners = np.array([(left, top), (right, top), (right, low), (left, low)])
    driver.viewport.signals.outlined.emit(corners)


def sizes(driver: Driver, name: str) -> dict[str, int]:
    return {s.line: len(s.indices) for s in driver.project.target(name).sightings}


def test_a_lasso_removes_points_from_a_sighting_and_restores_them(picked: Driver) -> None:
    window, view = picked.window, picked.viewport
    press(picked, Key.Key_L, SHIFT)
    assert "Select a target first" in window.log.toPlainText()
    assert view.mouse_mode == "navigate"
    before = sizes(picked, "T1")
    line = picked.project.target("T1").sightings[1].line
    window._select("T1", line)
    press(picked, Key.Key_L, SHIFT)
    assert view.mouse_mode == "outline"
    assert f"remove them from T1 · {line}" in view.hint
    points = window.scene.selected_points[line]
    part = points[points[:, 0] > np.median(points[:, 0])]
    outline(picked, part)
    after = sizes(picked, "T1")
    removed_count = before[line] - after[line]
    assert removed_count >= len(part)
    assert {k: v for k, v in after.items() if k != line} == {
        k: v for k, v in before.items() if k != line
    }
    assert undo_text(picked) == f"Undo removal of {removed_count:,} points from T1 · {line}"
    press(picked, Key.Key_L)
    assert "add them to T1" in view.hint
    outline(picked, points)
    assert sizes(picked, "T1")[line] >= 0.99 * before[line]
    assert undo_text(picked).startswith("Undo addition of")
    outline(picked, points + 500.0)
    assert "inside the outline" in window.log.toPlainText()
    press(picked, Key.Key_Escape)
    assert view.mouse_mode == "navigate"
    window.actions_["undo"].trigger()
    assert sizes(picked, "T1") == after
    window.actions_["undo"].trigger()
    assert sizes(picked, "T1") == before


def test_the_lasso_keeps_points_of_hidden_lines_and_outside_the_clip_box(picked: Driver) -> None:
    window, view = picked.window, picked.viewport
    before = sizes(picked, "T1")
    first, second = list(before)[:2]
    view.set_line_visible(first, False)
    window._select("T1", "")
    press(picked, Key.Key_X)
    clipping = window.tools.clipping
    clipping._set_box(clipping.box.with_side_moved(5, -1.1))  # lower the upper side into the target
    press(picked, Key.Key_L, SHIFT)
    points = window.scene.clouds[second][picked.project.target("T1").sighting(second).indices]
    low = points[points[:, 2] < points[:, 2].min() + 0.3]
    outline(picked, low)
    after = sizes(picked, "T1")
    assert after[first] == before[first]
    assert after[second] < before[second]
    removed = np.setdiff1d(
        window.document.undo_stack.command(0)._before.project.target("T1").sighting(second).indices,
        picked.project.target("T1").sighting(second).indices,
    )
    assert len(clipping.box.inside(window.scene.clouds[second][removed])) == len(removed)


def test_a_lasso_around_all_points_is_refused(picked: Driver) -> None:
    window = picked.window
    window._select("T1", "")
    press(picked, Key.Key_L, SHIFT)
    points = np.concatenate(list(window.scene.selected_points.values()))
    outline(picked, points)
    assert picked.dialogs.errors[0].code == "edit.few_points_left"
    assert not window.document.is_modified
    press(picked, Key.Key_Escape)


@LONG
def test_the_status_bar_clears_its_text_when_the_project_changes(picked: Driver) -> None:
    bar = picked.window.task_bar
    seed(picked, "T2")
    press(picked, Key.Key_Return)
    assert bar.currentMessage() == "T3: found in 6 of 6 lines"
    picked.window.controller.use_target("T1", False)
    wait_until_idle(picked)
    assert bar.currentMessage() == ""


def test_the_status_bar_and_the_log_name_the_undone_edit(picked: Driver) -> None:
    bar, log = picked.window.task_bar, picked.window.log
    picked.window.controller.rename("T1", "Quay")
    edit = picked.window.document.undo_stack.undoText()
    press(picked, Key.Key_Z, Control)
    wait_until_idle(picked)
    undone = bar.currentMessage()
    assert edit in undone
    assert undone in log.toPlainText()
    press(picked, Key.Key_Z, Control | Qt.KeyboardModifier.ShiftModifier)
    wait_until_idle(picked)
    assert edit in bar.currentMessage()
    assert bar.currentMessage() != undone


@LONG
def test_the_target_of_an_undone_edit_is_selected(picked: Driver) -> None:
    """Undone and redone edits of one target select it in the list and in the view."""
    window, stack = picked.window, picked.window.document.undo_stack
    window.controller.remove("T1")
    window._select("V1", "")
    for undone in (True, False):
        window._select("V1", "")
        press(picked, Key.Key_Z, Control if undone else Control | Qt.KeyboardModifier.ShiftModifier)
        wait_until_idle(picked)
        expected = "T1" if undone else "V1"  # nothing of a removed target can be selected
        assert (window.targets.current, window.scene.selected) == (expected, (expected, ""))
    stack.undo()
    window.controller.use_target("T2", False)
    window._select("V1", "")
    for key in (Control, Control | Qt.KeyboardModifier.ShiftModifier):
        press(picked, Key.Key_Z, key)
        wait_until_idle(picked)
        assert (window.targets.current, window.scene.selected) == ("T2", ("T2", ""))


@LONG
def test_every_edit_is_one_named_undo_step(picked: Driver) -> None:
    window, control = picked.window, picked.window.controller
    stack = window.document.undo_stack
    line = picked.project.lines[0].name
    settings = replace(picked.project.settings, lidar_sigma=0.006)

    def candidate() -> None:
        seed(picked, "T2")
        press(picked, Key.Key_Return)

    def role() -> None:
        window._select("T1", "")
        press(picked, Key.Key_F8)

    for step, words in (
        (candidate, "addition of T3"),
        (lambda: control.rename("T1", "Board"), "renaming of T1"),
        (lambda: control.rename("Board", "T1"), "renaming of Board"),
        (role, "change of role of T1"),
        (role, "change of role of T1"),
        (lambda: control.use_target("T1", False), "exclusion of T1"),
        (lambda: control.use_sighting("T2", line, False), f"exclusion of T2 in {line}"),
        (lambda: control.use_line(line, False), f"exclusion of line {line}"),
        (lambda: control.change_settings(settings), "change of LiDAR noise"),
        (lambda: control.remove("V1"), "removal of V1"),
    ):
        count, before = stack.count(), picked.project
        step()
        wait_until_idle(picked)
        assert undo_text(picked) == f"Undo {words}"
        assert stack.count() == count + 1
        after = picked.project
        window.actions_["undo"].trigger()
        assert picked.project is before
        window.actions_["redo"].trigger()
        assert picked.project is after
        picked.rest()


def test_roles_change_except_for_spheres(picked: Driver) -> None:
    window = picked.window
    press(picked, Key.Key_F8)
    assert "Select a target or validation plane first" in window.log.toPlainText()
    window._select("V1", "")
    press(picked, Key.Key_F8)
    assert picked.project.target("V1").role == "target"
    assert "V1 is now a target." in window.log.toPlainText()
    ball = replace(picked.project.target("T1"), shape="sphere")
    window.document.edit("trial", picked.project.with_target(ball))
    window._select("T1", "")
    press(picked, Key.Key_F8)
    assert picked.dialogs.errors[0].code == "target.validation_sphere"
    assert picked.project.target("T1").role == "target"


@LONG
def test_residuals_colour_the_points_of_the_targets(adjusted: Driver) -> None:
    window, view = adjusted.window, adjusted.viewport
    window.actions_["colour_residual"].trigger()
    wait_until_idle(adjusted)
    found = residuals(adjusted.project, window.document.survey)
    targets = {fit.target: fit for fit in adjusted.project.result.targets}
    for name, fit in targets.items():
        residuals_of_target = np.concatenate([found[key] for key in found if key[0] == name])
        assert np.sqrt(np.mean(residuals_of_target**2)) == pytest.approx(fit.rms_after, rel=0.25)
    assert view.shading.title == "Residual (mm), positive: nearer to the vessel"
    for fit in sighting_values(adjusted.project.result):
        # The table has the same sign; its means are those of the points used.
        mean = found[fit.target, fit.line].mean()
        assert mean == pytest.approx(fit.mean_after_m, abs=0.5 * fit.rms_after_m)
    assert {tuple(c) for c in view.shading.colours[window.document.survey.lines[0]]} == {
        OTHER_POINTS_COLOUR
    }
    places = {tuple(colour): k for k, colour in enumerate(view.shading.scale.tolist())}
    for highlight in view.highlights:
        if highlight.key not in found:
            assert highlight.key[0] == "V1"  # a validation plane: see the next test
            continue
        order = np.argsort(found[highlight.key])
        along = [places[tuple(colour)] for colour in highlight.shades[order].tolist()]
        assert (np.diff(along) >= 0).all()
    window._select("T1", "")
    window.controller.use_target("T2", False)
    wait_until_idle(adjusted)
    assert window.scene.colouring == ("residual" if adjusted.project.result else "line")


def test_a_validation_plane_is_coloured_by_the_distances_between_its_lines(
    adjusted: Driver,
) -> None:
    """The lines differ by decimetres before the calibration and by millimetres after it."""
    window, project = adjusted.window, adjusted.project
    survey = window.document.survey
    window.actions_["before"].trigger()
    window.actions_["colour_residual"].trigger()
    wait_until_idle(adjusted)
    keys = {("V1", sighting.line) for sighting in project.target("V1").used_sightings}
    shown = {each.key: each.shades for each in adjusted.viewport.highlights}
    assert all(shown[key] is not None for key in keys)
    before = validation_distances(project, survey, survey.clouds)
    after = validation_distances(project, survey, survey.placed(project, "estimated"))
    middle = survey.trajectory.position.mean(axis=0)
    for distances, clouds in (
        (before, survey.clouds), (after, survey.placed(project, "estimated"))
    ):  # fmt: skip
        points = {
            ("V1", each.line): clouds[each.line][each.indices]
            for each in project.target("V1").used_sightings
        }
        together = np.concatenate(list(points.values()))
        plane = fit_plane(together).facing(middle - together.mean(axis=0))
        for key, own in points.items():
            np.testing.assert_allclose(distances[key], plane.distances(own), rtol=0, atol=1e-9)
    spread = [np.sqrt(np.mean(np.concatenate(list(d.values())) ** 2)) for d in (before, after)]
    assert spread[1] < 0.5 * spread[0]
    colours = {key: shades.copy() for key, shades in shown.items() if key in keys}
    window.actions_["after"].trigger()
    adjusted.rest()
    later = {each.key: each.shades for each in adjusted.viewport.highlights}
    assert any((later[key] != colours[key]).any() for key in keys)


def test_without_a_result_there_are_no_residuals(picked: Driver) -> None:
    picked.window.actions_["colour_residual"].trigger()
    assert "Estimate the boresight first" in picked.window.log.toPlainText()
    assert picked.window.scene.colouring == "line"
    assert picked.window.actions_["colour_line"].isChecked()
