"""Tests that mnemonics of menus are unique, in both languages."""

from collections import Counter
from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QMenu, QMenuBar

from lispac.gui.app.language import set_language
from lispac.language import LANGUAGES
from tests.gui.design_support import opened_by_keys
from tests.gui.support import Demo, Driver


@pytest.fixture(params=LANGUAGES)
def code(request: pytest.FixtureRequest) -> Iterator[str]:
    """A language that is active while the window is created."""
    set_language(request.param)
    yield request.param
    set_language("en")


def mnemonic(text: str) -> str:
    """Return the letter after the first single &, or an empty string."""
    at = text.replace("&&", "  ").find("&")
    return text[at + 1 : at + 2].lower() if at >= 0 else ""


def twice(menu: QMenu | QMenuBar, name: str) -> list[str]:
    """Return letters used more than once in a menu or its submenus."""
    texts = [action.text() for action in menu.actions() if action.text()]
    letters = Counter(letter for text in texts if (letter := mnemonic(text)))
    found = [f"{name}: {letter} {texts}" for letter, count in letters.items() if count > 1]
    for action in menu.actions():
        if action.menu() is not None:
            found += twice(action.menu(), f"{name} > {action.text()}")
    return found


def test_mnemonics_are_unique_in_each_menu(code: str, driver: Driver, demo: Demo) -> None:
    driver.window.document.open(demo.picked, demo.survey)
    driver.window.controller.rename("T1", "North wall")
    driver.rest()
    bar = driver.window.menuBar()
    assert len(bar.actions()) >= 7
    assert twice(bar, "main") == []
    design = opened_by_keys(driver)
    design.workspace.add_line()
    assert twice(design.menuBar(), "design") == []
