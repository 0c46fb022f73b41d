"""Tests of changing the language in the settings by mouse and keyboard alone."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QFileDialog,
    QLabel,
    QMenu,
    QMenuBar,
    QTreeView,
)

from lispac.gui.app.settings import AppSettings
from lispac.gui.features.preferences.dialogs import SettingsDialog
from tests.gui.by_hand import Hands, choose, open_by_keys, open_menu, rename, shows_something
from tests.gui.support import Control, Demo, Key, Left, click, press

MAX_TABS = 40
"""More than the fields of the page."""


def choose_language_by_keys(hands: Hands, menu: str, entry: str, language: str) -> None:
    """Choose a language in the settings: menu by mouse, choice and Keep by keys."""

    def act(dialog: SettingsDialog) -> bool:
        box = dialog.language
        for _ in range(MAX_TABS):
            if box.hasFocus():
                break
            hands.bot.keyClick(QApplication.focusWidget(), Key.Key_Tab)
        assert box.hasFocus()
        hands.bot.keyClick(box, Key.Key_Home)
        for _ in range(box.count()):
            if box.currentText() != language:
                hands.bot.keyClick(box, Key.Key_Down)
        assert box.currentText() == language
        hands.bot.mouseClick(dialog.keep, Left)
        return True

    hands.answers.expect(SettingsDialog, act)
    choose(hands.bot, open_menu(hands.bot, hands.window, menu), entry)
    hands.until_dialogs_used()
    hands.to_next_window()


def dialog_texts(dialog: QFileDialog) -> set[str]:
    """Labels, buttons, column headings and file types of the first rows of a file dialogue."""
    tree = dialog.findChild(QTreeView)
    model, root = tree.model(), tree.rootIndex()
    heads = {model.headerData(k, Qt.Orientation.Horizontal) for k in range(model.columnCount())}
    kinds = {model.index(k, 2, root).data() for k in range(model.rowCount(root))}
    labels = {each.text() for each in dialog.findChildren(QLabel)}
    return heads | kinds | labels | {each.text() for each in dialog.findChildren(QAbstractButton)}


def words(menu: QMenu | QMenuBar) -> list[str]:
    """Texts of the entries of a menu and its submenus."""
    found = []
    for action in menu.actions():
        found.append(action.text().replace("&", ""))
        if action.menu() is not None:
            found += words(action.menu())
    return found


@pytest.mark.long
def test_the_language_is_changed_and_changed_back(
    hands: Hands, demo: Demo, picked_folder: Path, tmp_path: Path
) -> None:
    kept = tmp_path / "settings.ini"
    open_by_keys(hands, picked_folder)
    click(hands, hands.window.workflow.headers[1])
    rename(hands, 0, "North wall")
    english = words(hands.window.menuBar())
    assert {"File", "Settings…", "Undo"} <= {word.split(" ")[0] for word in english}

    choose_language_by_keys(hands, "File", "Settings", "Français")
    assert AppSettings(kept).chosen_language == "fr"
    french = words(hands.window.menuBar())
    assert len(french) == len(english)
    assert {"Fichier", "Édition", "Affichage", "Préférences…"} <= set(french)
    assert hands.project.targets[0].name == "North wall"
    assert hands.window.isWindowModified()
    shows_something(hands, tmp_path / "french.png")
    press(hands, Key.Key_Z, Control)
    assert not hands.window.isWindowModified()
    press(hands, Key.Key_Y, Control)

    choose_language_by_keys(hands, "Fichier", "Préférences", "English")
    assert AppSettings(kept).chosen_language == "en"
    assert words(hands.window.menuBar()) == english
    assert hands.window.isWindowModified()
    shows_something(hands, tmp_path / "english.png")


def test_file_dialogues_are_in_the_language_of_the_window(
    hands: Hands, picked_folder: Path, tmp_path: Path
) -> None:
    (tmp_path / "here").mkdir()
    texts: list[set[str]] = []

    def inspect_dialog(dialog: QFileDialog) -> bool:
        dialog.setDirectory(str(tmp_path))
        if not {"Folder", "Dossier"} & dialog_texts(dialog):
            return False  # Qt reads the folder in its own thread
        texts.append(dialog_texts(dialog))
        dialog.grab().save(str(tmp_path / f"files-{len(texts)}.png"))
        hands.bot.keyClick(dialog, Key.Key_Escape)
        return True

    def open_dialog() -> None:
        hands.answers.expect(QFileDialog, inspect_dialog)
        press(hands, Key.Key_O, Control)
        hands.until_dialogs_used()

    english = {"&Look in:", "Files of &type:", "File &name:", "Folder", "Name", "&Open", "Cancel"}
    open_dialog()
    assert english <= texts[0]
    choose_language_by_keys(hands, "File", "Settings", "Français")
    open_dialog()
    assert not english & texts[1]
    french = {"&Regarder dans\u00a0:", "Fichiers de &type\u00a0:", "Dossier", "Nom", "Annuler"}
    assert french <= texts[1]
    choose_language_by_keys(hands, "Fichier", "Préférences", "English")
    open_dialog()
    assert english <= texts[2]
