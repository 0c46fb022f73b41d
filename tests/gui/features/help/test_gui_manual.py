"""Tests of Help > Manual: the page that is opened, and the tables of fields and keys."""

import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QApplication

from lispac import caches
from lispac.workflow.output import manual
from tests.documents.manual_tables import folder, tables
from tests.gui.support import Control, Driver, Key, open_step, press
from tests.support.long_runs import others_long


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Cache folder, into which the first test copies the built manual."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(autouse=True)
def _built_once(manual_pages: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Do not build the manual, which takes long and is tested elsewhere."""

    def copied(_sources: Path, output: Path, **_options: object) -> None:
        shutil.copytree(manual_pages, output, dirs_exist_ok=True)

    monkeypatch.setattr(manual, "build_manual", copied)


@pytest.mark.parametrize("language", others_long(["en", "fr"]))
def test_the_manual_is_opened_in_the_language_of_the_window(
    driver: Driver, language: str, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[QUrl] = []
    monkeypatch.setattr(caches, "default_folder", lambda: cache)
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url) or True)
    monkeypatch.setattr("lispac.gui.features.help.manual.current_language", lambda: language)
    press(driver, Key.Key_F1, Qt.KeyboardModifier.ShiftModifier)
    driver.rest()
    for step in range(5):
        open_step(driver, step)
        press(driver, Key.Key_F1, Control)
        driver.rest()
    assert driver.dialogs.errors == []
    first, *parts = opened
    page = Path(first.toLocalFile())
    assert page.parts[-2:] == (language, "index.html")
    assert "LISPAC" in page.read_text(encoding="utf-8")
    panels = page.with_name("panels.html")
    text = panels.read_text(encoding="utf-8")
    for step, url in enumerate(parts, start=1):
        assert (url.toLocalFile(), url.fragment()) == (str(panels), f"step-{step}")
        assert f'id="step-{step}"' in text


@pytest.mark.parametrize("language", ["en", "fr"])
def test_the_tables_of_the_manual_agree_with_window_and_readers(
    qapp: QApplication, language: str
) -> None:
    """The tables are up to date; `python -m tests.documents` writes them."""
    kept = {file.name: file.read_text(encoding="utf-8") for file in folder(language).iterdir()}
    made = tables(language)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert kept == made


def test_a_key_keeps_its_letter_in_french() -> None:
    rows = (folder("fr") / "keys.md").read_text(encoding="utf-8").splitlines()
    assert any(row.startswith("| W | vue partagée avant et après") for row in rows)
    assert len([row for row in rows if row.startswith("| O |")]) == 1
