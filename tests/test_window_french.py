"""The window in French: every text that its modules can show has a translation."""

from pathlib import Path

import pytest

from tests.said import covered
from tests.told import told

ROOT = Path(__file__).resolve().parents[1] / "lispac"

MODULES = [
    "gui/docks.py",
    "gui/logbook.py",
    "gui/notifying.py",
    "gui/dialogs/questions.py",
    "gui/safekeeping.py",
]
"""Where texts of the window are made."""

NOT_SAID: set[str] = set()
"""Strings of these modules that nobody is shown."""


@pytest.mark.parametrize("module", MODULES)
def test_what_the_window_shows_can_be_said_in_french(module: str) -> None:
    texts = [text for _, text in told(ROOT / module)]
    assert [text for text in texts if text not in NOT_SAID and not covered(text)] == []
