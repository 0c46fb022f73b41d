"""Tests of the design window: mouse, keys and files."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QComboBox, QLineEdit

from lispac.design.prediction import predict
from lispac.gui.features.design import edits
from lispac.gui.features.design.plan_tables import TARGET_FIELDS
from lispac.gui.features.design.window import DesignWindow
from lispac.gui.viewport.base import PickedPoint
from lispac.io.config.plan_file import read_plan
from tests.gui.design_support import (
    NoModifier,
    Shift,
    drag,
    middle_of,
    mouse_move,
    plan,
    predicted,
    shown,
    type_cell,
    wait_for_plan,
)
from tests.gui.support import WAIT_MS, Control, Driver, Key, Left, press
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import is_shown


def test_the_window_starts_with_the_thesis_plan_and_its_predicted_sigmas(
    driver: Driver, design: DesignWindow
) -> None:
    assert len(plan(design).targets) == 2
    assert len(plan(design).lines) == 6
    # The manual's table: two boards, six lines.
    assert shown(design) == pytest.approx([0.0122, 0.0300, 0.0236], abs=1e-4)
    driver.bot.waitUntil(lambda: "Least precisely determined" in design.results.messages.text())
    assert "pitch" in design.results.messages.text().split(";")[0]
    assert design.results.thesis["yaw"].text() == design.results.sigma["yaw"].text()
    driver.bot.waitUntil(lambda: not design.results.predictor.active)
    assert design.results.gain_table.rowCount() == 8
    assert "L6" in design.results.points.text()
    assert "9 min for 6 lines" in design.results.minutes.text()
    assert not design.isWindowModified()


def test_roll_improves_while_a_line_is_dragged_farther_away(
    driver: Driver, design: DesignWindow
) -> None:
    view, before = design.plan_view, shown(design)
    start = middle_of(view, 0)
    stop = view.pixel(view.place(start) - np.array([10.0, 0.0]))
    shown_sigmas = drag(driver, view, start, stop)
    assert len(set(shown_sigmas)) == 3, "the sigma follows the mouse"
    assert plan(design).lines[0].distance == pytest.approx(25.0, abs=0.3)
    assert shown(design) == predicted(design)
    assert shown(design)[0] < before[0]
    assert str(design.workspace.history.undo_name) == "Move line 1"
    assert design.isWindowModified()
    driver.bot.keyClick(design, Key.Key_Z, Control)
    assert plan(design).lines[0].distance == 15.0
    assert "Move line 1" in design.task_bar.currentMessage()
    assert shown(design) == before
    assert not design.isWindowModified()
    driver.bot.keyClick(design, Key.Key_Y, Control)
    assert plan(design).lines[0].distance == pytest.approx(25.0, abs=0.3)


@pytest.mark.parametrize(("modifier", "whole"), others_long([(NoModifier, True), (Shift, False)]))
def test_dragging_the_arrow_of_a_line_turns_it(
    driver: Driver, design: DesignWindow, modifier, whole: bool
) -> None:
    view = design.plan_view
    _, tip = view._line_pixels(0, view._line_ends()[0])
    place = view.place(tip)
    turn = np.radians(-22.0)  # clockwise seen from above is positive
    east, north = place
    to = np.array([east * np.cos(turn) + north * np.sin(turn),
                   north * np.cos(turn) - east * np.sin(turn)])  # fmt: skip
    drag(driver, view, tip, view.pixel(to), modifier)
    heading = plan(design).lines[0].heading_deg
    assert (heading % 5.0 == 0.0) is whole
    assert heading == pytest.approx(338.0, abs=3.0 if whole else 0.6)
    assert str(design.workspace.history.undo_name) == "Turn line 1"


def test_escape_cancels_a_drag(driver: Driver, design: DesignWindow) -> None:
    view = design.wall_view
    before = design.workspace.titled
    spot = view._target_rect(edits.placed_targets(before)[0]).center()
    driver.bot.mousePress(view, Left, pos=spot.toPoint())
    QApplication.sendEvent(view, mouse_move(view, spot + QPointF(40, -60), NoModifier))
    assert design.workspace.titled is not before
    driver.bot.keyClick(view, Key.Key_Escape)
    driver.bot.mouseRelease(view, Left, pos=spot.toPoint())
    assert design.workspace.titled is before
    assert design.workspace.history.undo_name is None


def test_a_board_is_dragged_up_the_wall(driver: Driver, design: DesignWindow) -> None:
    view, before = design.wall_view, shown(design)
    spot = view._target_rect(edits.placed_targets(design.workspace.titled)[0]).center()
    to = view.pixel(view.place(spot) + np.array([-1.0, 1.5]))
    drag(driver, view, spot, to)
    along, off, up = design.workspace.titled.wall.wall_coordinates(plan(design).targets[0].centre)
    assert (along, off, up) == pytest.approx((-1.8, 0.0, 6.5), abs=0.11)
    assert shown(design) == predicted(design)
    assert shown(design)[1] < before[1], "boards farther apart show pitch better"


def test_a_plan_is_edited_by_keys_alone(driver: Driver, design: DesignWindow) -> None:
    view, bot = design.plan_view, driver.bot
    view.setFocus()
    bot.keyClick(view, Key.Key_PageDown)
    assert design.workspace.line == 1
    bot.keyClick(view, Key.Key_Up)
    bot.keyClick(view, Key.Key_Up, Shift)
    assert plan(design).lines[1].distance == pytest.approx(16.1)
    bot.keyClick(view, Key.Key_Z, Control)
    assert plan(design).lines[1].distance == 15.0, "nudges after each other are one step"
    bot.keyClick(view, Key.Key_Right)
    assert plan(design).lines[1].heading_deg == 185.0
    bot.keyClick(view, Key.Key_Insert)
    assert [line.heading_deg for line in plan(design).lines][1:3] == [185.0, 5.0]
    assert plan(design).lines[2].starboard, "the vessel stays on the water"
    bot.keyClick(view, Key.Key_D, Control)
    assert len(plan(design).lines) == 8
    bot.keyClick(view, Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert design.workspace.line == 2
    for _ in range(8):
        bot.keyClick(view, Key.Key_Delete)
    assert plan(design).lines == ()
    wait_for_plan(design)
    assert design.results.sigma["yaw"].text() == "–"
    bot.waitUntil(lambda: "Add a target and at least two lines" in design.results.messages.text())
    bot.keyClick(view, Key.Key_Insert)
    assert len(plan(design).lines) == 1
    wall = design.wall_view
    wall.setFocus()
    bot.keyClick(wall, Key.Key_Insert)
    bot.keyClick(wall, Key.Key_Up)
    assert [t.name for t in plan(design).targets] == ["T1", "T2", "T3"]
    assert plan(design).targets[2].centre[2] == pytest.approx(5.1)
    for _ in range(3):
        bot.keyClick(wall, Key.Key_Delete)
    assert plan(design).targets == ()
    assert design.plan_view.grab().width() > 0, "an empty site is drawn too"


def test_boards_of_one_orientation_give_a_warning(driver: Driver, design: DesignWindow) -> None:
    design.tabs.setCurrentWidget(design.targets)
    editor = type_cell(driver, design.targets.table, 1, 4, "90")
    driver.bot.keyClick(editor, Key.Key_Return)
    driver.bot.waitUntil(lambda: "the same orientation" in design.results.messages.text())
    assert design.results.messages.property("role") == "warning"


def test_surveyed_control_is_edited_and_its_effect_is_shown(
    driver: Driver, design: DesignWindow
) -> None:
    design.tabs.setCurrentWidget(design.targets)
    column = next(k for k, each in enumerate(TARGET_FIELDS) if each.name == "control_sigma")
    editor = type_cell(driver, design.targets.table, 0, column, "3")
    driver.bot.keyClick(editor, Key.Key_Return)
    sigmas = [0.003, None]
    driver.bot.waitUntil(lambda: [each.control_sigma for each in plan(design).targets] == sigmas)
    wait_for_plan(design)
    driver.bot.waitUntil(
        lambda: is_shown("plan_survey.control_gain", design.results.messages.text())
    )
    editor = type_cell(driver, design.targets.table, 0, column, "")
    driver.bot.keyClick(editor, Key.Key_Delete)
    driver.bot.keyClick(editor, Key.Key_Return)
    driver.bot.waitUntil(lambda: plan(design).surveyed_targets == ())


def test_an_invalid_number_is_reported_while_typing_and_not_accepted(
    driver: Driver, design: DesignWindow
) -> None:
    table, before = design.lines.table, design.workspace.titled
    editor = type_cell(driver, table, 2, 2, "1e")
    assert editor.property("wrong")
    assert is_shown("window.not_a_number_in", design.error_label.text())
    assert "“1e”" in design.error_label.text()
    driver.bot.keyClick(editor, Key.Key_Return)
    assert table.findChild(QLineEdit) is editor, "it stays open until it is right"
    assert design.workspace.titled is before
    editor.selectAll()
    driver.bot.keyClicks(editor, "20000")
    assert "1 to 200 m" in design.error_label.text()
    editor.selectAll()
    driver.bot.keyClicks(editor, "20,5")
    assert design.error_label.text() == ""
    driver.bot.keyClick(editor, Key.Key_Return)
    driver.bot.waitUntil(lambda: plan(design).lines[2].distance == 20.5)
    assert design.workspace.line == 2


def test_the_pos_and_the_stochastic_model_are_edited(driver: Driver, design: DesignWindow) -> None:
    design.tabs.setCurrentWidget(design.system)
    system, before = design.system, shown(design)
    assert system.grade.currentText() == "user-defined"
    system.grade.setFocus()
    driver.bot.keyClick(system.grade, Key.Key_Up)
    assert system.grade.currentText() == "tactical, RTK"
    assert shown(design) == predicted(design)
    assert shown(design)[2] > 1.5 * before[2]
    assert system.position[0].value() == 30.0
    field = system.attitude[2]
    field.setFocus()
    field.selectAll()
    driver.bot.keyClicks(field, "0.01")
    assert np.degrees(plan(design).system.pos.sigma_attitude[2]) == pytest.approx(0.01)
    assert system.grade.currentText() == "user-defined"
    system.model.setFocus()
    driver.bot.keyClick(system.model, Key.Key_Down)
    assert plan(design).system.pos_errors == "independent"
    assert shown(design) == predicted(design)


@LONG
def test_a_plan_is_saved_and_opened_and_unsaved_changes_are_asked_about(
    driver: Driver, design: DesignWindow, tmp_path
) -> None:
    work, dialogs = design.workspace, driver.dialogs
    driver.bot.keyClick(design.plan_view, Key.Key_Up)
    dialogs.path = tmp_path / "quay.toml"
    driver.bot.keyClick(design, Key.Key_S, Control)
    assert not design.isWindowModified()
    assert read_plan(dialogs.path).plan.lines[0].distance == 16.0
    dialogs.path = tmp_path / "page.pdf"
    driver.bot.keyClick(design, Key.Key_E, Control)
    driver.bot.waitUntil(
        lambda: not driver.window.site_design.field_plan_runner.active, timeout=WAIT_MS
    )
    assert dialogs.path.read_bytes().startswith(b"%PDF")
    dialogs.path = tmp_path / "page.pdf" / "page.pdf"
    driver.bot.keyClick(design, Key.Key_E, Control)
    driver.bot.waitUntil(lambda: len(dialogs.errors) == 1, timeout=20_000)
    assert "page.pdf" in str(dialogs.errors.pop())
    sigma = shown(design)
    dialogs.requests.clear()
    driver.bot.keyClick(design, Key.Key_N, Control)
    assert plan(design).lines[0].distance == 15.0
    assert dialogs.requests == []
    driver.bot.keyClick(design.plan_view, Key.Key_Up)
    dialogs.path, dialogs.save_choice = tmp_path / "quay.toml", "cancel"
    driver.bot.keyClick(design, Key.Key_O, Control)
    assert dialogs.requests == [work.titled.title], "what is not saved is asked about"
    dialogs.save_choice = "discard"
    driver.bot.keyClick(design, Key.Key_O, Control)
    assert plan(design).lines[0].distance == 16.0
    assert shown(design) == sigma
    (tmp_path / "bad.toml").write_text("lines = 3\n")
    dialogs.path = tmp_path / "bad.toml"
    driver.bot.keyClick(design, Key.Key_O, Control)
    (error,) = dialogs.errors
    assert "bad.toml" in str(error)
    assert plan(design).lines[0].distance == 16.0


def test_a_target_is_moved_by_handles_and_clicks_in_3d(
    driver: Driver, design: DesignWindow
) -> None:
    design.views.setCurrentIndex(1)
    viewport = design.view3d.viewport
    station = viewport.station
    viewport.set_station((0.0, 0.0, 0.0))
    driver.bot.keyClick(design, Key.Key_0, Control)
    assert viewport.station == station
    assert {"wall", "line 0", "line 5", "target 1"} <= set(viewport.sketches)
    assert len(viewport.sketches["target 0"].handles) == 3
    wall = design.workspace.titled.wall
    before = shown(design)
    viewport.signals.handle_moved.emit("target 0", 2, 0.25)
    viewport.signals.handle_moved.emit("target 0", 2, 0.25)
    assert wall.wall_coordinates(plan(design).targets[0].centre) == pytest.approx((-0.8, 0.5, 5.0))
    assert shown(design) != before or predicted(design) == before
    viewport.signals.handle_released.emit("target 0")
    assert str(design.workspace.history.undo_name) == "Move T1"
    viewport.signals.seed_clicked.emit(PickedPoint("targets", plan(design).targets[1].centre))
    assert (design.workspace.target, str(design.workspace.history.undo_name)) == (1, "Move T1")
    viewport.signals.seed_clicked.emit(PickedPoint("targets", plan(design).targets[0].centre))
    viewport.signals.seed_clicked.emit(PickedPoint("wall", wall.local_point(3.02, 0.0, 7.98)))
    assert wall.wall_coordinates(plan(design).targets[0].centre) == pytest.approx((3.0, 0.5, 8.0))
    corners = np.array(viewport.sketches["target 0"].points)
    assert np.linalg.norm(corners[0] - corners[1]) == pytest.approx(1.23)
    driver.bot.keyClick(design, Key.Key_L, Control)
    assert "line 6" in viewport.sketches
    driver.bot.keyClick(design, Key.Key_Z, Control)
    assert "line 6" not in viewport.sketches


def test_closing_the_design_window_keeps_the_plan_and_quitting_asks(
    driver: Driver, design: DesignWindow
) -> None:
    driver.bot.keyClick(design.plan_view, Key.Key_Up)
    driver.bot.keyClick(design, Key.Key_W, Control)
    assert not design.isVisible()
    driver.dialogs.save_choice = "cancel"
    assert not driver.window.close()
    assert driver.dialogs.requests == [design.workspace.titled.title]
    driver.window.activateWindow()
    press(driver, Key.Key_D, Control | Shift)
    assert plan(design).lines[0].distance == 16.0


def test_every_field_has_a_tooltip_and_an_accessible_name(
    driver: Driver, design: DesignWindow
) -> None:
    for kind in (QAbstractSpinBox, QComboBox, QLineEdit):
        for field in design.centralWidget().findChildren(kind):
            if field.objectName().startswith("qt_"):
                continue
            assert field.toolTip(), field.objectName()
            assert field.accessibleName(), field.objectName()


def test_the_targets_and_sigmas_turn_with_the_wall() -> None:
    """The sigmas stay, because the POS errors are equal in north and east."""
    titled = edits.default_plan()
    turned = edits.with_wall_facing(titled, 30.0)
    assert turned.wall.facing_deg == 30.0
    before, after = (predict(each.plan).sigma for each in (titled, turned))
    assert after == pytest.approx(before, rel=1e-6)
    for one, other in zip(edits.placed_targets(titled), edits.placed_targets(turned), strict=True):
        assert (one.along, one.off, one.up, one.lean) == pytest.approx(
            (other.along, other.off, other.up, other.lean), abs=1e-9
        )
