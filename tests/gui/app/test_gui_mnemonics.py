"""Tests that the mnemonics of each menu are unique, in both languages."""

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
    """Code of a language, which is set while the window is made."""
    set_language(request.param)
    yield request.param
    set_language("en")


def mnemonic(text: str) -> str:
    """Letter after the first single &; empty if there is none."""
    at = text.replace("&&", "  ").find("&")
    return text[at + 1 : at + 2].lower() if at >= 0 else ""


def repeated_mnemonics(menu: QMenu | QMenuBar, name: str) -> list[str]:
    """Mnemonics that occur more than once in a menu or in one of its submenus."""
    texts = [action.text() for action in menu.actions() if action.text()]
    letters = Counter(letter for text in texts if (letter := mnemonic(text)))
    found = [f"{name}: {letter} {texts}" for letter, count in letters.items() if count > 1]
    for action in menu.actions():
        if action.menu() is not None:
            found += repeated_mnemonics(action.menu(), f"{name} > {action.text()}")
    return found


def test_no_mnemonic_occurs_twice(code: str, driver: Driver, demo: Demo) -> None:
    driver.window.document.open(demo.picked, demo.survey)
    driver.window.controller.rename("T1", "North wall")
    driver.rest()
    bar = driver.window.menuBar()
    assert len(bar.actions()) >= 7
    assert repeated_mnemonics(bar, "main") == []
    design = opened_by_keys(driver)
    design.workspace.add_line()
    assert repeated_mnemonics(design.menuBar(), "design") == []
