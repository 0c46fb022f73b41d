"""Tests that a dialogue has the text of its menu entry as its title."""

import ast
from collections import Counter
from pathlib import Path

import pytest

import lispac.gui
from lispac.gui.app.actions import dialog_title
from lispac.gui.window.actions import ALL_ACTIONS, MENUS
from lispac.language import LANGUAGES, in_language

WITHOUT_OWN_TITLE = {
    "lines",
    "targets",
    "trajectory",
    "corrected_trajectory",
    "add_lines",
    "section_picture",
    "design",
}
"""Actions whose dialogue has another title: the exported data, the project, the picture of the view
or the survey plan."""


def titled() -> set[str]:
    """Names of the actions whose texts are used as dialogue titles."""
    names = set()
    for path in Path(lispac.gui.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "dialog_title":
                names |= {
                    a.slice.value
                    for a in node.args
                    if isinstance(a, ast.Subscript) and isinstance(a.slice, ast.Constant)
                }
    return names


def test_entries_with_an_ellipsis_are_dialogue_titles() -> None:
    asking = {name for name, each in ALL_ACTIONS.items() if each.texts[0].endswith("…")}
    assert len(asking) > 15
    assert asking - titled() == WITHOUT_OWN_TITLE
    assert titled() <= set(ALL_ACTIONS)


@pytest.mark.parametrize("code", LANGUAGES)
def test_a_title_has_neither_mnemonic_nor_ellipsis(code: str) -> None:
    with in_language(code):
        titles = [dialog_title(each) for each in ALL_ACTIONS.values()]
    assert not [title for title in titles if "&" in title or "…" in title or title != title.strip()]


def test_each_position_in_a_menu_has_one_entry() -> None:
    places = [each.menu for each in ALL_ACTIONS.values()]
    places += [(each.menu, each.group, each.position) for each in MENUS.values() if each.menu]
    assert [place for place, count in Counter(places).items() if count > 1] == []
    assert {place[0] for place in places} <= set(MENUS)
