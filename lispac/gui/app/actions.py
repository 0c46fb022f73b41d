"""Actions of a window: records from which menus, toolbar and shortcuts are created."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from PySide6.QtCore import QObject, QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu, QToolBar, QToolButton, QWidget

from lispac.errors import InputError
from lispac.gui.app.unavailable import Reason, Unavailable, first_reason
from lispac.gui.appearance import theme
from lispac.gui.widgets.number_input import commit_focused_field, first_input_error
from lispac.language import gettext
from lispac.messages import Message

Keys = QKeySequence.StandardKey
Key = str | QKeySequence.StandardKey


@dataclass(frozen=True)
class ActionRecord:
    """Description of one action; `Actions.connect_slots` connects its function.

    Attributes
    ----------
    name : name of the action
    text, tip : menu text and tip, marked with `N_`
    menu : name of the menu, number of the group in it and position in the group
    toolbar : number of the group in the toolbar and position in it; None if it is not in the
        toolbar
    short : text in the toolbar
    icon : name of a Material icon
    keys : shortcut, or several
    toggles : whether it can be switched on and off, independently of others
    choice : name of a group of exclusive actions, of which the first is on initially
    number : number of the workflow step, shown in the tip
    uses_values : whether it is refused while a typed value is not accepted
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
    uses_values: bool = False

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


def by_name(*records: ActionRecord) -> dict[str, ActionRecord]:
    """Actions by their names."""
    return {each.name: each for each in records}


def dialog_title(record: ActionRecord) -> str:
    """Title of the dialogue that an action opens: its menu text without mnemonic and ellipsis."""
    return record.texts[0].replace("&", "").removesuffix("…").rstrip()


def menu_groups(
    menu: str, records: Mapping[str, ActionRecord], menus: Mapping[str, Menu]
) -> list[list[str]]:
    """Names of the actions and submenus of a menu, in groups divided by separators."""
    places = [(*each.menu[1:], name) for name, each in records.items() if each.menu[0] == menu]
    places += [
        (each.group, each.position, name) for name, each in menus.items() if each.menu == menu
    ]
    groups: dict[int, list[str]] = {}
    for group, _, name in sorted(places):
        groups.setdefault(group, []).append(name)
    return list(groups.values())


class Actions(QObject):
    """Actions of a window, by name, with its menus and its toolbar.

    Parameters
    ----------
    records, menus : descriptions of the actions and menus, by name
    prefix : beginning of the object names of the actions
    """

    refused = Signal(object)
    """The error because of which an action was not started."""
    stepped = Signal(str)
    """Text on the edit that was undone or redone."""

    def __init__(
        self,
        window: QMainWindow,
        records: Mapping[str, ActionRecord],
        menus: Mapping[str, Menu],
        prefix: str = "action",
    ) -> None:
        super().__init__(window)
        self._window, self._records, self._menus = window, records, menus
        self._prefix = prefix
        self.find_input_error: Callable[[], Message | None] = lambda: None
        """Function that returns why a typed value is not accepted, or None."""
        self.submenus = {
            name: QMenu(gettext(each.title), window) for name, each in menus.items() if each.menu
        }
        self._reasons: dict[str, Reason] = {}
        self._by_name = {name: self._create_action(each) for name, each in records.items()}
        for name in records:
            self.set_reason(name, None)
        for menu in self.submenus.values():
            menu.setToolTipsVisible(True)
        self._create_choices()

    def __getitem__(self, name: str) -> QAction:
        return self._by_name[name]

    @property
    def all(self) -> list[QAction]:
        """All actions."""
        return list(self._by_name.values())

    def set_reason(self, name: str, reason: Reason) -> None:
        """Disable an action or a submenu, with the reason in its tip; None enables it.

        No other code enables or disables actions of menus.
        """
        if name in self._reasons and self._reasons[name] == reason:
            return  # all actions are updated after every change
        self._reasons[name] = reason
        menu = self.submenus.get(name)
        action = self[name] if menu is None else menu.menuAction()
        action.setEnabled(reason is None)
        tip = "" if menu is not None else self._tip(name)
        added = [] if reason is None else [reason.text]
        action.setToolTip("\n".join([tip, *added] if tip else added))
        status = self._records[name].texts[1] if tip else ""
        if status and added:  # in one line, unlike the tool tip
            status = f"{status.removesuffix('.')}."
        action.setStatusTip(" ".join([status, *added] if status else added))

    def reason(self, name: str) -> Reason:
        """Reason why an action or a submenu is disabled; None if it is enabled."""
        return self._reasons.get(name)

    def _tip(self, name: str) -> str:
        """Tip of an action with its shortcut."""
        tip = self._records[name].texts[1]
        shown = self[name].shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        return f"{tip} ({shown})" if shown else tip

    def connect_slots(self, slots: Mapping[str, Callable[[], object]]) -> None:
        """Call each function, without arguments, when the action of that name is triggered."""
        for name, slot in slots.items():
            guarded = self.guarded(slot) if self._records[name].uses_values else slot
            self[name].triggered.connect(lambda _=False, slot=guarded: slot())

    def guarded(
        self, slot: Callable[..., object], fields: QWidget | None = None
    ) -> Callable[..., None]:
        """Function that calls ``slot`` with committed values, or is refused if one is wrong.

        Parameters
        ----------
        fields : QWidget, optional
            Widget with the fields that ``slot`` uses, instead of those of all actions.
        """

        def call(*arguments: object) -> None:
            commit_focused_field()
            problem = self.find_input_error() if fields is None else first_input_error(fields)
            if problem is None:
                slot(*arguments)
            else:
                self.refused.emit(InputError(problem))

        return call

    def connect_undo_stack(self, stack: QUndoStack) -> None:
        """Connect the actions ``undo`` and ``redo``, with the name of the edit in their texts."""
        stack.canUndoChanged.connect(self._enable_undo)
        stack.canRedoChanged.connect(self._enable_redo)
        stack.undoTextChanged.connect(self._set_undo_text)
        stack.redoTextChanged.connect(self._set_redo_text)
        self.connect_slots({"undo": lambda: self._undo(stack), "redo": lambda: self._redo(stack)})
        # A rebuilt window keeps the undo steps of the former one
        self._enable_undo(stack.canUndo())
        self._enable_redo(stack.canRedo())
        self._set_undo_text(stack.undoText())
        self._set_redo_text(stack.redoText())

    def _undo(self, stack: QUndoStack) -> None:
        edit = stack.undoText()
        stack.undo()
        self.stepped.emit(gettext("Undone: {edit}", edit=edit))

    def _redo(self, stack: QUndoStack) -> None:
        edit = stack.redoText()
        stack.redo()
        self.stepped.emit(gettext("Redone: {edit}", edit=edit))

    def _enable_undo(self, enabled: bool) -> None:
        self.set_reason("undo", first_reason((not enabled, Unavailable.NO_EDIT)))

    def _enable_redo(self, enabled: bool) -> None:
        self.set_reason("redo", first_reason((not enabled, Unavailable.NOTHING_UNDONE)))

    def _set_undo_text(self, edit: str) -> None:
        self["undo"].setText(gettext("&Undo {edit}", edit=edit) if edit else gettext("&Undo"))
        self["undo"].setIconText(gettext("Undo"))

    def _set_redo_text(self, edit: str) -> None:
        self["redo"].setText(gettext("&Redo {edit}", edit=edit) if edit else gettext("&Redo"))
        self["redo"].setIconText(gettext("Redo"))

    def fill_menus(self, panels: Iterable[QAction] = ()) -> None:
        """Build the menu bar; ``panels`` are the first actions of the menu "Panels"."""
        for action in panels:
            self.submenus["Panels"].addAction(action)
        for name, menu in self._menus.items():
            if not menu.menu:
                made = self._window.menuBar().addMenu(gettext(menu.title))
                made.setToolTipsVisible(True)
                self._fill_menu(made, name)

    def _fill_menu(self, menu: QMenu, name: str) -> None:
        for group in menu_groups(name, self._records, self._menus):
            if not menu.isEmpty():
                menu.addSeparator()
            for entry in group:
                if entry in self._menus:
                    menu.addMenu(self.submenus[entry])
                    self._fill_menu(self.submenus[entry], entry)
                else:
                    menu.addAction(self[entry])

    def create_toolbar(self, name: str) -> QToolBar:
        """Add the toolbar to the window."""
        bar = self._window.addToolBar(gettext("Toolbar"))
        bar.setObjectName(name)
        bar.setMovable(False)
        bar.setIconSize(QSize(20, 20))
        bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        shown = sorted((each.toolbar, each.name) for each in self._records.values() if each.toolbar)
        former = shown[0][0]
        for place, action in shown:
            if place[0] != former[0]:
                bar.addSeparator()
            former = place
            bar.addAction(self[action])
        more = bar.findChild(QToolButton, theme.EXTENSION_NAME)
        assert isinstance(more, QToolButton)
        # The arrow of Qt has no place beside the padding of the style sheet
        more.setIcon(theme.icon("chevron-double-right"))
        more.setIconSize(QSize(12, 20))
        more.setToolTip(gettext("More buttons"))
        more.setAccessibleName(gettext("More buttons"))
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

    def _create_action(self, record: ActionRecord) -> QAction:
        action = QAction(record.texts[0], self._window)
        action.setObjectName(f"{self._prefix}_{record.name}")
        if record.short:
            action.setIconText(gettext(record.short))
        if record.icon:
            action.setIcon(theme.icon(record.icon))
        if isinstance(record.keys, tuple):
            action.setShortcuts([QKeySequence(key) for key in record.keys])
        elif record.keys:
            action.setShortcut(QKeySequence(record.keys))
        return action
