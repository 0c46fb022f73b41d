"""The window in French: every text that its modules can show has a translation."""

import re
from pathlib import Path

import pytest

from lispac.gui.actions import texts
from lispac.gui.language import pieces, say, speak
from lispac.gui.status import STEPS
from lispac.gui.viewing_actions import STEP_ACTIONS
from tests.said import covered
from tests.told import told

ROOT = Path(__file__).resolve().parents[1] / "lispac"

ELSEWHERE = {
    "gui/app.py",  # the command line, before there is a window
    "gui/theme.py",  # fonts and the style sheet
    "gui/viewport/recording.py",  # refuses what a test asks wrongly
}
MODULES = sorted(
    module
    for path in (ROOT / "gui").rglob("*.py")
    if (module := path.relative_to(ROOT).as_posix()) not in ELSEWHERE
)
"""Where texts of the window are made."""

NOT_SAID = {
    # of Matplotlib
    "axes fraction", "center left", "lower center", "lower left", "offset points",
    "outside right center",
    # of types, and of a page that does not say how it shows a result
    "Quality | None", "str | tuple[str, Menu]", "7 does not say how it shows a result",
    # keys of facts about a file
    "Position north", "Position west", "Position up",
    # of names and numbers in a table
    "<td align='right'>&nbsp;&nbsp;<b>7</b></td>", "<td align='right'>&nbsp;&nbsp;7</td>",
}  # fmt: skip
"""Strings of these modules that nobody is shown."""


_TAG = re.compile(r"<[^>]*>")
_TWO_WORDS = re.compile(r"[^\W\d_]{2,} .*[^\W\d_]{2,}")


def _shown(text: str) -> bool:
    """Whether it is no style sheet, and more than tags."""
    if text in NOT_SAID or text.endswith((";", "}")):
        return False
    return _TWO_WORDS.search(_TAG.sub("", text)) is not None


@pytest.mark.parametrize("module", MODULES)
def test_what_the_window_shows_can_be_said_in_french(module: str) -> None:
    texts = [piece for _, text in told(ROOT / module) for piece in pieces(text)]
    assert [text for text in texts if _shown(text) and not covered(text)] == []


def test_the_menu_calls_the_steps_what_their_headers_are_called() -> None:
    speak("fr")
    try:
        for k, name in enumerate(STEP_ACTIONS):
            assert texts(name)[0].replace("&", "") == say(f"{k + 1}  {STEPS[k]}")
    finally:
        speak("en")
