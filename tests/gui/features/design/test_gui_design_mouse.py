"""Tests of the mouse in the design window: drags while the plan changes, and in 3D."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF
from PySide6.QtWidgets import QApplication

from lispac.gui.features.design import edits
from lispac.gui.features.design.window import DesignWindow
from lispac.io.config.plan_file import read_plan
from tests.gui.design_support import (
    NoModifier,
    middle_of,
    mouse_move,
    opened_by_keys,
    plan,
    wait_until_designed,
)
from tests.gui.features.design.test_gui_design_work import SITE
from tests.gui.support import WAIT_MS, Control, Driver, Key, Left, click


def start_search(driver: Driver, design: DesignWindow, folder: Path) -> None:
    """Start a search that evaluates 250 plans."""
    driver.dialogs.path = folder / "pier.toml"
    driver.dialogs.path.write_text(SITE)
    design.tabs.setCurrentWidget(design.search)
    click(driver, design.search.read)
    click(driver, design.search.find)


@pytest.mark.parametrize("which", [pytest.param("plan_view", marks=pytest.mark.long), "wall_view"])
def test_a_search_that_ends_during_a_drag_ends_the_drag(
    driver: Driver, design: DesignWindow, tmp_path: Path, which: str
) -> None:
    view = getattr(design, which)
    if which == "plan_view":
        spot = middle_of(view, 5)
    else:
        spot = view._target_rect(edits.placed_targets(design.workspace.titled)[1]).center()
    before = design.workspace.titled
    start_search(driver, design, tmp_path)
    driver.bot.mousePress(view, Left, pos=spot.toPoint())
    QApplication.sendEvent(view, mouse_move(view, spot + QPointF(20, -30), NoModifier))
    assert design.workspace.is_dragging
    wait_until_designed(driver)
    found = design.workspace.titled
    assert len(plan(design).lines) == 3
    for to in (QPointF(40, -60), QPointF(60, -90)):
        QApplication.sendEvent(view, mouse_move(view, spot + to, NoModifier))
        assert design.workspace.titled is found, "what was dragged is in this plan no more"
    driver.bot.mouseRelease(view, Left, pos=(spot + QPointF(60, -90)).toPoint())
    assert design.workspace.titled is found
    assert str(design.workspace.history.undo_name) == "best survey design"
    driver.bot.keyClick(design, Key.Key_Z, Control)
    assert design.workspace.titled is before


def test_a_view_that_is_hidden_during_a_drag_ends_the_drag(
    driver: Driver, design: DesignWindow
) -> None:
    view, before = design.wall_view, design.workspace.titled
    spot = view._target_rect(edits.placed_targets(before)[0]).center()
    driver.bot.mousePress(view, Left, pos=spot.toPoint())
    QApplication.sendEvent(view, mouse_move(view, spot + QPointF(30, -40), NoModifier))
    assert design.workspace.is_dragging
    design.show_figures()
    assert design.views.currentWidget() is view, "figures do not take the view away"
    design.views.setCurrentWidget(design.pictures)
    assert not design.workspace.is_dragging
    assert design.workspace.titled is before


def test_saving_during_a_drag_saves_the_plan_before_it(
    driver: Driver, design: DesignWindow, tmp_path: Path
) -> None:
    view, before = design.wall_view, design.workspace.titled
    spot = view._target_rect(edits.placed_targets(before)[0]).center()
    driver.dialogs.path = tmp_path / "quay.toml"
    driver.bot.mousePress(view, Left, pos=spot.toPoint())
    QApplication.sendEvent(view, mouse_move(view, spot + QPointF(30, -40), NoModifier))
    design.actions_["save_as"].trigger()
    driver.bot.keyClick(view, Key.Key_Escape)
    driver.bot.mouseRelease(view, Left, pos=spot.toPoint())
    assert design.workspace.titled is before
    saved = read_plan(driver.dialogs.path).plan
    assert saved.targets[0].centre == pytest.approx(before.plan.targets[0].centre, abs=1e-6)
    assert not design.isWindowModified()


def open_3d_view(real: Driver) -> DesignWindow:
    """The design window with its 3D view in front."""
    design = opened_by_keys(real)
    real.bot.keyClick(design, Key.Key_0, Control)
    assert design.view3d is not None
    real.bot.wait(400)
    design.activateWindow()  # the 3D view took the focus, and no window manager gives it back
    real.bot.waitUntil(design.isActiveWindow, timeout=WAIT_MS)
    return design


def pixel(design: DesignWindow, place) -> QPoint:
    x, y = design.view3d.viewport.to_pixels(np.array([place]))[0][:2]
    return QPoint(round(x), round(y))


def test_ctrl_click_on_the_bare_wall_adds_a_board(real: Driver) -> None:
    design = open_3d_view(real)
    viewport, wall = design.view3d.viewport, design.workspace.titled.wall
    for _ in range(2):
        design.workspace.remove_target()
    assert design.workspace.target == -1
    real.bot.wait(400)
    real.bot.mouseClick(
        viewport.canvas, Left, Control, pixel(design, wall.local_point(2.0, -0.05, 3.0))
    )
    (board,) = plan(design).targets
    assert wall.wall_coordinates(board.centre) == pytest.approx((2.0, 0.0, 3.0), abs=0.3)
    assert design.workspace.target == 0
    real.bot.keyClick(design, Key.Key_Z, Control)
    assert plan(design).targets == (), "one click is one step"


def test_a_handle_is_dragged_until_the_plan_is_replaced(real: Driver, tmp_path: Path) -> None:
    design = open_3d_view(real)
    work, viewport = design.workspace, design.view3d.viewport
    before = edits.placed_targets(work.titled)[0]
    start = pixel(design, viewport._sketch_layer._sketches["target 0"].handles[1].position)
    aim = np.array(plan(design).targets[0].centre) + [0.0, 0.0, 2.0]
    by = pixel(design, aim) - pixel(design, plan(design).targets[0].centre)

    def move(share: float) -> None:
        at = QPointF(start) + share * QPointF(by)
        QApplication.sendEvent(viewport.canvas, mouse_move(viewport.canvas, at, NoModifier))

    real.bot.mousePress(viewport.canvas, Left, pos=start)
    move(0.5)
    move(1.0)
    real.bot.mouseRelease(viewport.canvas, Left, pos=start + by)
    now = edits.placed_targets(work.titled)[0]
    assert (now.along, now.off) == (before.along, before.off)
    assert now.up == pytest.approx(before.up + 2.0, abs=0.2)
    assert str(work.history.undo_name) == "Move T1"
    real.bot.keyClick(design, Key.Key_Z, Control)

    start_search(real, design, tmp_path)
    real.bot.mousePress(viewport.canvas, Left, pos=start)
    move(0.5)
    assert work.is_dragging
    wait_until_designed(real)
    found = work.titled
    assert len(plan(design).lines) == 3
    move(1.0)
    assert work.titled is found
    real.bot.mouseRelease(viewport.canvas, Left, pos=start + by)
    assert work.titled is found
