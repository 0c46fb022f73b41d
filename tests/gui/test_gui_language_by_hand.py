"""Another language, chosen in the settings by mouse and keyboard alone, and the former again."""

from pathlib import Path

from PySide6.QtWidgets import QApplication, QMenu, QMenuBar

from lispac.gui.dialogs.settings import SettingsDialog
from lispac.gui.settings import AppSettings
from tests.gui.by_hand import Hands, choose, open_by_keys, open_menu, rename, shows_something
from tests.gui.support import Control, Demo, Key, Left, click, press

TABS = 40
"""More than there are fields on the page."""


def speak_by_keys(hands: Hands, menu: str, entry: str, wanted: str) -> None:
    """Choose a language in the settings: the menu by mouse, the box by keys, and Keep."""

    def act(dialog: SettingsDialog) -> bool:
        box = dialog.language
        for _ in range(TABS):
            if box.hasFocus():
                break
            hands.bot.keyClick(QApplication.focusWidget(), Key.Key_Tab)
        assert box.hasFocus()
        hands.bot.keyClick(box, Key.Key_Home)
        for _ in range(box.count()):
            if box.currentText() != wanted:
                hands.bot.keyClick(box, Key.Key_Down)
        assert box.currentText() == wanted
        hands.bot.mouseClick(dialog.keep, Left)
        return True

    hands.answers.foresee(SettingsDialog, act)
    choose(hands.bot, open_menu(hands.bot, hands.window, menu), entry)
    hands.answered()
    hands.to_next_window()


def words(menu: QMenu | QMenuBar) -> list[str]:
    """Of the entries, and of the menus below."""
    found = []
    for action in menu.actions():
        found.append(action.text().replace("&", ""))
        if action.menu() is not None:
            found += words(action.menu())
    return found


def test_the_language_is_chosen_and_chosen_back(
    hands: Hands, demo: Demo, picked_folder: Path, tmp_path: Path
) -> None:
    kept = tmp_path / "settings.ini"
    open_by_keys(hands, picked_folder)
    click(hands, hands.window.workflow.headers[1])
    rename(hands, 0, "North wall")
    english = words(hands.window.menuBar())
    assert {"File", "Settings…", "Undo"} <= {word.split(" ")[0] for word in english}

    speak_by_keys(hands, "File", "Settings", "Français")
    assert AppSettings(kept).language_chosen == "fr"
    french = words(hands.window.menuBar())
    assert len(french) == len(english)
    assert {"Fichier", "Édition", "Affichage", "Préférences…"} <= set(french)
    assert hands.project.targets[0].name == "North wall"
    assert hands.window.isWindowModified()
    shows_something(hands, tmp_path / "french.png")
    press(hands, Key.Key_Z, Control)
    assert not hands.window.isWindowModified()
    press(hands, Key.Key_Y, Control)

    speak_by_keys(hands, "Fichier", "Préférences", "English")
    assert AppSettings(kept).language_chosen == "en"
    assert words(hands.window.menuBar()) == english
    assert hands.window.isWindowModified()
    shows_something(hands, tmp_path / "english.png")
