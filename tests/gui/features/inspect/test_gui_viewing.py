"""Tests of standard views, projection and views of the selection, by keys and menus."""

import numpy as np
from PySide6.QtWidgets import QLabel

from lispac.gui.features.help.dialogs import shortcuts_box
from lispac.gui.features.inspect.actions import VIEWS
from lispac.gui.features.inspect.view_menu import NOTHING_SELECTED_TEXT
from tests.gui.support import Driver, Key, press

SHIFT = Key.Key_Shift


def calls_of(driver: Driver, name: str) -> list[tuple[object, ...]]:
    return [arguments for called, arguments in driver.viewport.calls if called == name]


def test_keys_choose_the_standard_views(opened: Driver) -> None:
    opened.viewport.calls.clear()
    for key in (Key.Key_1, Key.Key_2, Key.Key_3, Key.Key_4, Key.Key_5, Key.Key_6):
        press(opened, key)
    assert [name for (name,) in calls_of(opened, "view")] == [
        "isometric", "top", "front", "left", "back", "right",
    ]  # fmt: skip
    assert set(VIEWS) == {name for (name,) in calls_of(opened, "view")}


def test_o_switches_between_orthographic_and_perspective(opened: Driver) -> None:
    press(opened, Key.Key_O)
    assert opened.viewport.parallel
    assert opened.window.actions_["orthographic"].isChecked()
    press(opened, Key.Key_O)
    assert not opened.viewport.parallel


def test_the_selected_target_is_fitted_and_viewed_along_its_normal(picked: Driver) -> None:
    window = picked.window
    notes: list[str] = []
    window.controller.logged.connect(notes.append)
    press(picked, Key.Key_7)
    window.actions_["fit_selection"].trigger()
    assert notes == [NOTHING_SELECTED_TEXT] * 2
    window._select("T1", "")
    picked.viewport.calls.clear()
    press(picked, Key.Key_7)
    ((direction, points),) = calls_of(picked, "view_along")
    target = picked.project.target("T1")
    groups = [window.scene.clouds[s.line][s.indices] for s in target.sightings]
    for group in groups:
        spread = np.linalg.svd(group - group.mean(axis=0))[2][2]
        assert abs(direction @ spread) > np.cos(np.radians(4))
    assert len(points) == sum(map(len, groups))
    line = target.sightings[1].line
    window._select("T1", line)
    picked.viewport.calls.clear()
    window.actions_["fit_selection"].trigger()
    np.testing.assert_array_equal(calls_of(picked, "fit")[0][0], groups[1])
    window.controller.remove("T1")
    window.actions_["fit_selection"].trigger()
    assert notes[-1] == NOTHING_SELECTED_TEXT


def test_every_action_is_in_the_menus_and_every_key_in_the_list(opened: Driver) -> None:
    def within(menu):
        for action in menu.actions():
            if action.menu() is not None:
                yield from within(action.menu())
            elif not action.isSeparator():
                yield action

    window = opened.window
    bar = {a.objectName() for top in window.menuBar().actions() for a in within(top.menu())}
    actions = window.actions_._by_name
    assert {action.objectName() for action in actions.values()} <= bar
    box = shortcuts_box(window)
    listed = "".join(label.text() for label in box.findChildren(QLabel))
    for name in actions:
        for key in actions[name].shortcuts():
            words = key.toString().replace("+", " + ") if len(key.toString()) > 1 else None
            if name in ("new", "open", "save", "quit", "keys", "cancel") or words is None:
                continue
            shown = words.replace("Return", "Enter").replace("Shift + Z", "Y")
            assert shown.split(" + ")[-1] in listed, name
    box.deleteLater()
