"""Help > Manual: the page that the browser is given."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices

from lispac import caches
from tests.gui.support import Driver, Key, press


@pytest.mark.parametrize("spoken", ["en", "fr"])
def test_it_is_opened_in_the_language_of_the_window(
    driver: Driver, spoken: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[QUrl] = []
    monkeypatch.setattr(caches, "usual_folder", lambda: tmp_path)
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url) or True)
    monkeypatch.setattr("lispac.gui.manual.language", lambda: spoken)
    press(driver, Key.Key_F1, Qt.KeyboardModifier.ShiftModifier)
    driver.rest()
    assert driver.dialogs.errors == []
    (url,) = opened
    page = Path(url.toLocalFile())
    assert page.parts[-2:] == (spoken, "index.html")
    assert "LISPAC" in page.read_text(encoding="utf-8")
