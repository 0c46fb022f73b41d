"""Tests of the design window in the complete program: 3D view, change of language and theme."""

import gc
from pathlib import Path

import numpy as np
from PySide6.QtWidgets import QLineEdit

from lispac.design.objective import PlanObjective
from lispac.gui.features.design.search import SearchResult
from lispac.gui.features.design.window import DesignWindow
from lispac.language import gettext, gettext_lazy
from lispac.present.planning.design_results import SimulationValues
from tests.gui.by_hand import Hands, choose, open_menu
from tests.gui.design_support import opened_by_keys, plan, wait_for_plan
from tests.gui.features.design.test_gui_design_surveys import surveyed_once
from tests.gui.support import WAIT_MS, Control, Key, Left, in_front


def turn_to(hands: Hands, tabs, page: int) -> None:
    """Click on a tab."""
    bar = tabs.tabBar()
    hands.bot.mouseClick(bar, Left, pos=bar.tabRect(page).center())
    assert tabs.currentIndex() == page


def change_by_menu(hands: Hands, menu: str, *entries: str) -> DesignWindow:
    """Change a setting in the main window's menu, and return the new design window.

    An unexpected question is a failure.
    """
    choose(hands.bot, open_menu(hands.bot, hands.window, menu), *entries)
    hands.to_next_window()
    design = hands.window.site_design.window
    assert design is not None
    assert design.isVisible()
    hands.until(lambda: in_front(design))
    wait_for_plan(design)
    return design


def test_the_site_is_drawn_in_3d(hands: Hands) -> None:
    design = opened_by_keys(hands)
    turn_to(hands, design.views, 1)
    view = design.view3d
    assert view is not None
    hands.bot.waitUntil(
        lambda: view.viewport.drawn_near("wall", np.zeros(3), 1e6).size > 0, timeout=WAIT_MS
    )


def test_a_plan_stays_open_in_another_language_and_theme(hands: Hands, tmp_path: Path) -> None:
    design = opened_by_keys(hands)
    titled = design.workspace.titled
    for key in (Key.Key_L, Key.Key_B, Key.Key_Z):
        hands.bot.keyClick(design, key, Control)
    edited = design.workspace.titled
    turn_to(hands, design.tabs, 3)
    turn_to(hands, design.views, 1)
    lists = design.search.limits.lists
    for name, text in (("along", "-2.5, 4"), ("heights", "high")):
        lists[name].selectAll()
        hands.bot.keyClicks(lists[name], text)
    design.resize(1300, 800)

    french = change_by_menu(hands, "View", "Langue", "ran")
    assert french.windowTitle() == f"Site[*] – {gettext('Survey design')} – LISPAC"
    assert "levé" in french.windowTitle()
    assert french.isWindowModified()
    assert french.workspace.titled is edited
    assert (french.tabs.currentIndex(), french.views.currentIndex()) == (3, 1)
    assert (french.width(), french.height()) == (1300, 800)
    lists = french.search.limits.lists
    assert (lists["along"].text(), lists["heights"].text()) == ("-2,5; 4", "high")
    assert hands.settings.language == "fr"

    dark = change_by_menu(hands, "Affichage", "hème", "Sombre")
    assert hands.settings.theme == "dark"
    assert dark.workspace.titled is edited
    hands.bot.keyClick(dark, Key.Key_Y, Control)
    assert len(plan(dark).targets) == len(edited.plan.targets) + 1
    for _ in range(2):
        hands.bot.keyClick(dark, Key.Key_Z, Control)
    assert dark.workspace.titled is titled
    assert not dark.isWindowModified()
    assert dark.grab().save(str(tmp_path / "dark.png"))
    del design, french
    gc.collect()
    assert [each for each in gc.get_objects() if type(each) is DesignWindow] == [dark]


def test_results_of_a_plan_survive_a_change_of_theme(hands: Hands) -> None:
    design = opened_by_keys(hands)
    found = surveyed_once()
    values = SimulationValues.of(found)
    head = gettext_lazy("Simulate surveys")
    design.surveys.result_table.show_result(head, values, plan(design))
    design.pictures.show_errors(found)
    design.search.show_found(SearchResult(0.0363, PlanObjective(), 250, all_evaluated=True))
    hands.bot.keyClick(design, Key.Key_L, Control)

    dark = change_by_menu(hands, "View", "heme", "Dark")
    result_table = dark.surveys.result_table
    assert result_table.head.text() == str(head)
    assert [row[0] for row in result_table.cells[1:]] == [row.name for row in values.rows]
    assert result_table.outdated.isVisibleTo(dark.surveys)  # the result belongs to an earlier plan
    assert dark.pictures.which.count() == 1
    turn_to(hands, dark.views, 2)
    figure = dark.pictures.pages.currentWidget().figure
    hands.bot.waitUntil(lambda: len(figure.axes) == 3, timeout=WAIT_MS)
    assert "0.0363" in dark.search.message_label.text()
    assert "250" in dark.search.message_label.text()


def test_the_theme_changes_while_a_closed_window_has_a_wrong_number(hands: Hands) -> None:
    design = opened_by_keys(hands)
    titled = design.workspace.titled
    table = design.lines.table
    table.setFocus()
    table.setCurrentCell(0, 2)
    hands.bot.keyClicks(table, "-5")
    assert table.findChild(QLineEdit).property("wrong")
    design.close()
    choose(hands.bot, open_menu(hands.bot, hands.window, "View"), "heme", "Dark")
    hands.to_next_window()
    assert opened_by_keys(hands).workspace.titled is titled
    del design, table
    gc.collect()  # an exception while the editor is destroyed fails the test


def test_a_plan_in_a_closed_window_survives_a_change_of_theme(hands: Hands) -> None:
    design = opened_by_keys(hands)
    hands.bot.keyClick(design, Key.Key_L, Control)
    edited = design.workspace.titled
    design.close()
    choose(hands.bot, open_menu(hands.bot, hands.window, "View"), "heme", "Dark")
    hands.to_next_window()
    assert not hands.window.site_design.window.isVisible()
    assert opened_by_keys(hands).workspace.titled is edited
