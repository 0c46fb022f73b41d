"""Actions of the window: one record each, from which menus, toolbar and shortcuts are made."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu, QToolBar

from lispac.gui.appearance import theme
from lispac.language import N_, gettext

Keys = QKeySequence.StandardKey
Key = str | QKeySequence.StandardKey


@dataclass(frozen=True)
class ActionRecord:
    """One action. Its function is connected by `Actions.connect_slots`.

    Attributes
    ----------
    name : name of the action; that of the Qt object begins with ``action_``
    text, tip : menu text and tip, marked with `N_`
    menu : name of the menu, number of the group in it and position in the group
    toolbar : number of the group in the toolbar and position in it; None where it is not there
    short : text in the toolbar
    icon : name of a Material icon
    keys : shortcut, or several
    toggles : whether it is on or off by itself
    choice : name of a choice, one action of which is on; the first at first
    number : of a step of the workflow, in the tip
    """

    name: str
    text: str
    tip: str
    menu: tuple[str, int, int]
    toolbar: tuple[int, int] | None = None
    short: str = ""
    icon: str = ""
    keys: Key | tuple[Key, ...] = ""
    toggles: bool = False
    choice: str = ""
    number: int = 0

    @property
    def texts(self) -> tuple[str, str]:
        """Menu text and tip in the language of the window."""
        if self.number:
            return f"&{gettext(self.text)}", gettext(self.tip, number=self.number)
        return gettext(self.text), gettext(self.tip)


@dataclass(frozen=True)
class Menu:
    """A menu, or a submenu with its place in a menu."""

    title: str
    menu: str = ""
    group: int = 0
    position: int = 0


MENUS = {
    "File": Menu(N_("&File")),
    "Recent": Menu(N_("Open &recent"), "File", 1, 4),
    "Edit": Menu(N_("&Edit")),
    "View": Menu(N_("&View")),
    "Look from": Menu(N_("&Look from"), "View", 2, 3),
    "Colour by": Menu(N_("&Colour by"), "View", 3, 3),
    "Steps": Menu(N_("S&teps"), "View", 5, 2),
    "Panels": Menu(N_("&Panels"), "View", 5, 3),
    "Theme": Menu(N_("T&heme"), "View", 5, 4),
    "Language": Menu(N_("Lan&guage · Langue"), "View", 5, 5),
    "Inspect": Menu(N_("&Inspect")),
    "Targets": Menu(N_("&Targets")),
    "Adjust": Menu(N_("&Adjust")),
    "Validate": Menu(N_("Va&lidate")),
    "Help": Menu(N_("&Help")),
}
"""Menus and submenus by name; those of the menu bar in their order."""


def by_name(*records: ActionRecord) -> dict[str, ActionRecord]:
    """Actions by their names."""
    return {each.name: each for each in records}


def dialog_title(record: ActionRecord) -> str:
    """Title of the dialogue that an action opens: its menu text without mnemonic and ellipsis."""
    return record.texts[0].replace("&", "").removesuffix("…").rstrip()


def menu_groups(menu: str, records: Iterable[ActionRecord]) -> list[list[str]]:
    """Names of the actions and submenus of a menu, in the groups that lines divide."""
    places = [(*each.menu[1:], each.name) for each in records if each.menu[0] == menu]
    places += [
        (each.group, each.position, name) for name, each in MENUS.items() if each.menu == menu
    ]
    groups: dict[int, list[str]] = {}
    for group, _, name in sorted(places):
        groups.setdefault(group, []).append(name)
    return list(groups.values())


class Actions(QObject):
    """Actions of the window, by name."""

    def __init__(
        self, window: QMainWindow, stack: QUndoStack, records: Mapping[str, ActionRecord]
    ) -> None:
        super().__init__(window)
        self._window, self._records = window, records
        recent = MENUS["Recent"]
        self.recent = QMenu(gettext(recent.title), window)
        self.recent.setObjectName("recent_menu")
        self._by_name = {name: self._create_action(each) for name, each in records.items()}
        self._create_choices()
        stack.canUndoChanged.connect(self["undo"].setEnabled)
        stack.canRedoChanged.connect(self["redo"].setEnabled)
        stack.undoTextChanged.connect(self._set_undo_text)
        stack.redoTextChanged.connect(self._set_redo_text)
        self["undo"].triggered.connect(stack.undo)
        self["redo"].triggered.connect(stack.redo)
        # A window made anew begins with the steps of the former one
        self["undo"].setEnabled(stack.canUndo())
        self["redo"].setEnabled(stack.canRedo())
        self._set_undo_text(stack.undoText())
        self._set_redo_text(stack.redoText())

    def __getitem__(self, name: str) -> QAction:
        return self._by_name[name]

    def connect_slots(self, slots: Mapping[str, Callable[[], object]]) -> None:
        """Call a function without arguments when the action of its name is triggered."""
        for name, slot in slots.items():
            self[name].triggered.connect(lambda _=False, slot=slot: slot())

    def fill_menus(self, docks: Iterable[QAction]) -> None:
        """Build the menu bar; ``docks`` are the actions of the panels."""
        self._docks = list(docks)
        for name, menu in MENUS.items():
            if not menu.menu:
                self._fill_menu(self._window.menuBar().addMenu(gettext(menu.title)), name)

    def _fill_menu(self, menu: QMenu, name: str) -> None:
        groups = menu_groups(name, self._records.values())
        if name == "Panels":
            menu.addActions(self._docks)
            menu.addSeparator()
        for k, group in enumerate(groups):
            if k:
                menu.addSeparator()
            for entry in group:
                if entry == "Recent":
                    menu.addMenu(self.recent)
                elif entry in MENUS:
                    self._fill_menu(menu.addMenu(gettext(MENUS[entry].title)), entry)
                else:
                    menu.addAction(self[entry])

    def fill_toolbar(self) -> QToolBar:
        """Build the toolbar."""
        bar = QToolBar(gettext("Toolbar"), self._window)
        bar.setObjectName("toolbar")
        bar.setMovable(False)
        bar.setIconSize(QSize(20, 20))
        bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        shown = sorted(
            (each.toolbar, each.name) for each in self._records.values() if each.toolbar is not None
        )
        group = shown[0][0][0]
        for place, name in shown:
            if place[0] != group:
                bar.addSeparator()
            group = place[0]
            bar.addAction(self[name])
        return bar

    def _create_choices(self) -> None:
        """Make the actions of each choice exclude each other."""
        groups: dict[str, QActionGroup] = {}
        for name, record in self._records.items():
            action = self[name]
            action.setCheckable(record.toggles or bool(record.choice))
            if record.choice:
                if record.choice not in groups:
                    groups[record.choice] = QActionGroup(self._window)
                    action.setChecked(True)
                groups[record.choice].addAction(action)

    def _set_undo_text(self, edit: str) -> None:
        self["undo"].setText(gettext("&Undo {edit}", edit=edit) if edit else gettext("&Undo"))
        self["undo"].setIconText(gettext("Undo"))

    def _set_redo_text(self, edit: str) -> None:
        self["redo"].setText(gettext("&Redo {edit}", edit=edit) if edit else gettext("&Redo"))
        self["redo"].setIconText(gettext("Redo"))

    def _create_action(self, record: ActionRecord) -> QAction:
        text, tip = record.texts
        action = QAction(text, self._window)
        action.setObjectName(f"action_{record.name}")
        if record.short:
            action.setIconText(gettext(record.short))
        if record.icon:
            action.setIcon(theme.icon(record.icon))
        if isinstance(record.keys, tuple):
            action.setShortcuts([QKeySequence(key) for key in record.keys])
        elif record.keys:
            action.setShortcut(QKeySequence(record.keys))
        shown = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        action.setToolTip(f"{tip} ({shown})" if shown else tip)
        action.setStatusTip(tip)
        return action
