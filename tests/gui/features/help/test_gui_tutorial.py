"""Tests that follow the tutorial of the manual literally in the real window."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.project.status import STEP_NAMES
from lispac.gui.window.actions import ALL_ACTIONS, MENUS
from lispac.gui.window.main_window import MainWindow
from lispac.gui.window.session import Session
from lispac.language import gettext
from lispac.workflow.project.projects import open_project
from tests.gui.reader import Reader, StepError
from tests.gui.support import WAIT_MS
from tests.support.french_catalogue import FRENCH
from tests.support.long_runs import LONG, others_long
from tests.support.tutorial_steps import Step, page, steps_of

REPORTS = {"en": "boresight.pdf", "fr": "etalonnage.pdf"}

_PLACE = re.compile(r"\{(\w+)[^}]*\}")


@pytest.fixture
def program(
    qtbot: QtBot, qapp: QApplication, tmp_path: Path, request: pytest.FixtureRequest
) -> Iterator[MainWindow]:
    """Window of the first start of the program, in a language."""
    if qapp.platformName() == "offscreen":
        pytest.skip("OpenGL needs a screen, if only a virtual one")
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    settings = AppSettings(tmp_path / "settings.ini")
    settings.language, settings.theme = request.param, "light"
    session = Session(qapp, VtkViewport, settings)
    session.window.setGeometry(0, 0, 1280, 800)
    qtbot.waitUntil(session.window.isActiveWindow, timeout=WAIT_MS)
    yield session.window
    session.window.document.undo_stack.setClean()
    session.window.stop_and_hide()
    session.window.deleteLater()
    session.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    set_language("en")


@LONG
@pytest.mark.parametrize(
    "program", ["en", pytest.param("fr", marks=pytest.mark.long)], indirect=True
)
def test_the_tutorial_leads_to_a_report(
    program: MainWindow, demo_copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Follow the tutorial as a user, with an existing demo survey of a third of the points."""
    monkeypatch.setattr("lispac.gui.project.controller.demo_folder", lambda: demo_copy)
    language = program.settings.language
    source = page(language, "tutorial")
    pictures: list[str] = []

    def check_picture(_front: QWidget, picture: str) -> None:
        assert (source.parent / picture).is_file()
        pictures.append(picture)

    Reader(program, steps_of(source.read_text(encoding="utf-8")), check_picture).follow()
    assert len(pictures) == 7
    assert (demo_copy / REPORTS[language]).read_bytes().startswith(b"%PDF")
    kept = open_project(demo_copy)
    assert [target.name for target in kept.targets] == ["T1", "T2", "V1"]
    assert (kept.identity.surveyor, kept.identity.vessel) == ("E. Tremblay", "Saucier")
    assert kept.validation
    assert kept.result is not None
    assert (np.abs(np.degrees(kept.result.boresight) - kept.truth_deg) < 0.1).all()
    assert not program.isWindowModified()


def test_the_french_page_has_the_same_steps_with_french_names() -> None:
    english, french = (
        steps_of(page(language, "tutorial").read_text(encoding="utf-8")) for language in REPORTS
    )
    assert [step.kind for step in french] == [step.kind for step in english]
    texts = [each.text for each in ALL_ACTIONS.values()]
    texts += [menu.title for menu in MENUS.values() if not menu.menu]
    numbered = [f"{k + 1} {name}" for k, name in enumerate(STEP_NAMES)]
    set_language("fr")
    try:
        names = {_bare(text): _bare(gettext(text)) for text in texts}
        names |= {"English": "Français"}  # language of the report
        names |= {each: f"{each[:2]}{gettext(each[2:])}" for each in numbered}
        for one, other in zip(english, french, strict=True):
            if one.kind == "menu":
                translated = " > ".join(names[part] for part in one.text.split(" > "))
            elif one.kind in ("click", "see"):
                translated = names.get(one.text) or _bare(gettext(one.text))
                if translated == one.text != other.text:  # a text that contains names or numbers
                    assert other.text in _translations(one.text)
                    continue
            else:
                continue
            assert other.text == translated, f"line {other.line} of the French page"
    finally:
        set_language("en")


def _translations(text: str) -> set[str]:
    """French translations of the catalogue texts that match a text with inserted values."""
    found = set()
    for english, french in FRENCH.items():
        names = _PLACE.findall(english)
        pattern = "(.+)".join(map(re.escape, _PLACE.sub("\0", english).split("\0")))
        if names and (match := re.fullmatch(pattern, text)):
            values = dict(zip(names, match.groups(), strict=True))
            found.add(_bare(_PLACE.sub(lambda place, v=values: v[place.group(1)], french)))
    return found


def _bare(text: str) -> str:
    return " ".join(text.replace("&", "").split())


@pytest.mark.parametrize("program", ["en"], indirect=True)
@pytest.mark.parametrize(
    ("step", "problem"),
    others_long(
        [
            (Step("click", "Four-minute tour", 3), "is not there to be clicked"),
            (Step("click", "Undo", 3), "is greyed"),
            (Step("menu", "File > Send", 3), "no menu has 'Send'"),
            (Step("see", "Tour, step 1 of 8", 3), "is not seen"),
            (Step("type", "Saucier", 3), "nothing is there to type"),
        ]
    ),
)
def test_a_page_that_names_missing_widgets_fails(
    program: MainWindow, step: Step, problem: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.gui.reader.TIMEOUT_S", 0.5)
    with pytest.raises(StepError, match=problem) as refused:
        Reader(program, [step], lambda _front, _picture: None).follow()
    assert "at line 3 of the page" in refused.value.__notes__[0]


def test_the_steps_of_a_page_are_parsed_from_its_markup() -> None:
    text = (
        "1. Click {guilabel}`A` or\n{menuselection}`File > Save`, press {kbd}`F9`, type\n"
        "{typed}`x y`, see **It\n is done**.\n\n![Picture](pictures/a.png)\n"
    )
    assert steps_of(text) == [
        Step("click", "A", 1), Step("menu", "File > Save", 2), Step("press", "F9", 2),
        Step("type", "x y", 3), Step("see", "It is done", 3), Step("look", "pictures/a.png", 6),
    ]  # fmt: skip
    with pytest.raises(ValueError, match="line 1: samp is none of"):
        steps_of("{samp}`x`")
