"""Menus, toolbar and shortcuts: all actions of the window by name."""

from collections.abc import Callable, Iterable, Mapping

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu, QToolBar

from lispac.gui.app.view_actions import (
    COLOUR_ACTIONS,
    INSPECT_ACTIONS,
    INSPECT_MENU,
    STEP_ACTIONS,
    THEME_ACTIONS,
    TOGGLES,
    VIEW_ACTIONS,
    VIEW_MENU,
    ActionSpec,
    Menu,
)
from lispac.gui.appearance import theme
from lispac.language import N_, gettext

Keys = QKeySequence.StandardKey

_ACTIONS: dict[str, ActionSpec] = {
    "new": (N_("&New project…"), N_("New"), "folder-plus-outline", Keys.New,
            N_("Create a project from a trajectory and lines")),
    "open": (N_("&Open project…"), N_("Open"), "folder-open-outline", Keys.Open,
             N_("Open a project")),
    "demo": (N_("Open &demo survey"), "", "ferry", "", N_("Open the built-in simulated survey")),
    "add_lines": (N_("Add &lines…"), "", "file-plus-outline", "",
                  N_("Add lines to the open project")),
    "save": (N_("&Save"), N_("Save"), "content-save-outline", Keys.Save, N_("Save the project")),
    "save_as": (N_("Save &as…"), "", "", Keys.SaveAs,
                N_("Save the project in another folder and continue to work on the copy")),
    "report": (N_("&Export report…"), N_("Report"), "file-document-outline", "Ctrl+E",
               N_("Write the report as PDF, HTML, JSON or tables (CSV in a ZIP file)")),
    "lines": (N_("Export &georeferenced lines…"), "", "export-variant", "Ctrl+Shift+E",
              N_("Write the lines as LAZ or LAS in a coordinate system of your choice")),
    "targets": (N_("Export &targets…"), "", "", "",
                N_("Write the points of the targets and validation planes, or files with the "
                   "parameters of the planes")),
    "trajectory": (N_("Export tra&jectory…"), "", "", "",
                   N_("Write the trajectory as SBET or text")),
    "script": (N_("Python s&cript of this project…"), "", "", "",
               N_("Show the Python script that creates this project from its input files")),
    "settings": (N_("Sett&ings…"), "", "cog-outline", "Ctrl+,",
                 N_("Set the language, the view, the report and the sensor library")),
    "quit": (N_("&Quit"), "", "", Keys.Quit, N_("Quit the program")),
    "undo": (N_("&Undo"), N_("Undo"), "undo", Keys.Undo, N_("Undo the last edit")),
    "redo": (N_("&Redo"), N_("Redo"), "redo", ("Ctrl+Y", "Ctrl+Shift+Z"),
             N_("Redo the edit that was undone")),
    "seed_target": (N_("Pick an adjustment &target"), N_("Target"), "target", "F6",
                    N_("The next Ctrl+click in the view picks an adjustment target")),
    "seed_validation": (N_("Pick a &validation plane"), N_("Validation"), "shield-check-outline",
                        "F7", N_("The next Ctrl+click in the view picks a validation plane")),
    "seed_at": (N_("Enter seed &coordinates…"), "", "crosshairs-gps", "F3",
                N_("Enter the coordinates of a seed point in the local frame or in map "
                   "projection, and detect its target")),
    "seed_list": (N_("Read seeds &from a file…"), "", "format-list-bulleted", "Shift+F3",
                  N_("Read seed coordinates from a file, for example from a total station, and "
                     "detect their targets")),
    "propose": (N_("&Propose targets"), "", "auto-fix", "F5",
                N_("Find flat surfaces in all lines and propose targets and validation planes")),
    "find_again": (N_("Search aga&in with other settings…"), "", "refresh", "Shift+F5",
                   N_("Search for the selected target with another threshold or search radius")),
    "accept": (N_("&Accept detected target"), "", "check-bold", ("Return", "Enter"),
               N_("Add the detected target or validation plane to the project")),
    "reject": (N_("Re&ject detected target"), "", "close", "Esc",
               N_("Discard the detected target or validation plane")),
    "estimate": (N_("&Estimate boresight"), N_("Estimate"), "calculator-variant-outline", "F9",
                 N_("Adjust boresight and targets together by least squares")),
    "validate": (N_("&Validate"), N_("Validate"), "check-decagram-outline", "F10",
                 N_("Compare the lines on the validation planes")),
    "check": (N_("Check against a &reference…"), "", "", "Shift+F10",
              N_("Compare the lines with a static scan or surveyed points")),
    "line_quality": (N_("&Differences between lines…"), "", "", "Ctrl+F10",
                     N_("Compute the distances between each two lines on flat areas of the "
                        "scene, with the boresight used in the view")),
    "budget": (N_("Error &budget…"), "", "", "",
               N_("Compute the effect of each error source on a point at a given range")),
    "history": (N_("Calibrations over the &years…"), "", "", "F11",
                N_("Compare all calibrations of a vessel’s system to detect a change of its "
                   "mounting")),
    "patch_test": (N_("LiDAR &patch test"), "", "", "Ctrl+T",
                   N_("Estimate the boresight by aligning the lines on objects, as an "
                      "alternative method")),
    "subsampling": (N_("Point &spacing study…"), "", "", "Shift+F9",
                    N_("Repeat the adjustment with smaller and larger point spacings, and "
                       "compare the results")),
    "methods": (N_("Compare with other &methods…"), "", "", "Ctrl+F9",
                N_("Estimate the boresight from the validation planes and from the scene "
                   "without targets, and compare the results")),
    "visibility": (N_("&Visibility of errors…"), "", "", "",
                   N_("Show for each systematic error the boards and lines that make it visible")),
    "design": (N_("&Design a survey…"), "", "", "Ctrl+Shift+D",
               N_("Plan boards and lines, and predict the precision before the survey")),
    "cancel": (N_("&Cancel the running task"), "", "close-circle-outline", "Ctrl+.",
               N_("Cancel the running task; the project stays unchanged")),
    "before": (N_("&Before (prior boresight)"), N_("Before"), "history", "",
               N_("Show the lines georeferenced with the prior boresight")),
    "after": (N_("&After (estimated boresight)"), N_("After"), "check-all", "",
              N_("Show the lines georeferenced with the estimated boresight")),
    "toggle": (N_("&Switch before / after"), "", "swap-horizontal", "B",
               N_("Switch the view between prior and estimated boresight")),
    "warnings": (N_("&Warnings"), "", "alert-outline", "F12",
                 N_("List all warnings; click a warning to go to its cause")),
    **STEP_ACTIONS,
    **VIEW_ACTIONS,
    **INSPECT_ACTIONS,
    "manual": (N_("Ma&nual"), "", "book-open-outline", "Shift+F1",
               N_("Open the manual in the browser, without a network")),
    "manual_step": (N_("This &step in the manual"), "", "", "Ctrl+F1",
                    N_("Open the manual at the step shown in the window")),
    "keys": (N_("&Mouse and keys"), "", "keyboard-outline", "F1",
             N_("List the actions of the mouse and the keyboard")),
    "english": ("&English", "", "", "", N_("Switch the window to English")),
    "french": ("&Français", "", "", "", "Fenêtre en français"),
    "tour": (N_("Three-minute &tour"), "", "compass-outline", "",
             N_("Calibrate the demo survey step by step")),
    "log_file": (N_("Open the &log file"), "", "", "",
                 N_("Open the file with all events, their times and the details of each error")),
    "about": (N_("&About LISPAC"), "", "information-outline", "",
              N_("Show the version and the conventions of the program")),
}  # fmt: skip
"""Each action by its name; the languages are named in themselves."""

_CHECKABLE = (
    ("seed_target", "seed_validation"), ("before", "after"), tuple(COLOUR_ACTIONS.values()),
    ("english", "french"), tuple(THEME_ACTIONS.values()),
)  # fmt: skip
_MENUS: dict[str, Menu] = {
    N_("&File"): (
        "new",
        "open",
        "demo",
        "RECENT",
        "",
        "add_lines",
        "save",
        "save_as",
        "",
        "report",
        "lines",
        "targets",
        "trajectory",
        "",
        "script",
        "",
        "settings",
        "",
        "quit",
    ),
    N_("&Edit"): ("undo", "redo"),
    N_("&View"): VIEW_MENU,
    N_("&Inspect"): INSPECT_MENU,
    N_("&Targets"): (
        "seed_target",
        "seed_validation",
        "seed_at",
        "seed_list",
        "",
        "propose",
        "",
        "accept",
        "reject",
        "",
        "find_again",
        "hover",
        "",
        "change_role",
        "lasso_add",
        "lasso_remove",
    ),
    N_("&Adjust"): (
        "estimate",
        "",
        "patch_test",
        "methods",
        "subsampling",
        "visibility",
        "design",
        "",
        "cancel",
    ),
    N_("Va&lidate"): ("validate", "check", "line_quality", "", "budget", "history"),
    N_("&Help"): ("tour", "manual", "manual_step", "keys", "", "log_file", "about"),
}
_TOOLBAR = (
    "new", "open", "save", "", "undo", "redo", "", "seed_target", "seed_validation", "", "estimate",
    "validate", "report", "", "before", "after", "", "fit", "isometric", "top", "front",
    "left",
)  # fmt: skip


def action_texts(name: str) -> tuple[str, str]:
    """Menu text and tip of an action in the language of the window."""
    text, _, _, _, tip = _ACTIONS[name]
    if name in STEP_ACTIONS:
        number = list(STEP_ACTIONS).index(name) + 1
        return f"&{gettext(text)}", gettext(tip, number=number)
    return gettext(text), gettext(tip)


def dialog_title(name: str) -> str:
    """Title of the dialogue that an action opens: its menu text without mnemonic and ellipsis."""
    return action_texts(name)[0].replace("&", "").removesuffix("…").rstrip()


class Actions(QObject):
    """Actions of the window, by name."""

    def __init__(self, window: QMainWindow, stack: QUndoStack) -> None:
        super().__init__(window)
        self._window = window
        self.recent = QMenu(gettext("Open &recent"), window)
        self.recent.setObjectName("recent_menu")
        self._by_name = {name: self._create_action(name) for name in _ACTIONS}
        for pair in _CHECKABLE:
            group = QActionGroup(window)
            for name in pair:
                self[name].setCheckable(True)
                group.addAction(self[name])
            self[pair[0]].setChecked(True)
        for name in TOGGLES:
            self[name].setCheckable(True)
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
        """Build the menu bar."""
        self._docks = list(docks)
        for title, names in _MENUS.items():
            self._fill_menu(self._window.menuBar().addMenu(gettext(title)), names)

    def _fill_menu(self, menu: QMenu, names: Menu) -> None:
        for name in names:
            if isinstance(name, tuple):
                self._fill_menu(menu.addMenu(gettext(name[0])), name[1])
            elif name == "RECENT":
                menu.addMenu(self.recent)
            elif name == "DOCKS":
                menu.addActions(self._docks)
            elif name:
                menu.addAction(self[name])
            else:
                menu.addSeparator()

    def fill_toolbar(self) -> QToolBar:
        """Build the toolbar."""
        bar = QToolBar(gettext("Toolbar"), self._window)
        bar.setObjectName("toolbar")
        bar.setMovable(False)
        bar.setIconSize(QSize(20, 20))
        bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        for name in _TOOLBAR:
            if name:
                bar.addAction(self[name])
            else:
                bar.addSeparator()
        return bar

    def _set_undo_text(self, edit: str) -> None:
        self["undo"].setText(gettext("&Undo {edit}", edit=edit) if edit else gettext("&Undo"))
        self["undo"].setIconText(gettext("Undo"))

    def _set_redo_text(self, edit: str) -> None:
        self["redo"].setText(gettext("&Redo {edit}", edit=edit) if edit else gettext("&Redo"))
        self["redo"].setIconText(gettext("Redo"))

    def _create_action(self, name: str) -> QAction:
        _, short, icon, keys, _ = _ACTIONS[name]
        text, tip = action_texts(name)
        action = QAction(text, self._window)
        action.setObjectName(f"action_{name}")
        if short:
            action.setIconText(gettext(short))
        if icon:
            action.setIcon(theme.icon(icon))
        if isinstance(keys, tuple):
            action.setShortcuts([QKeySequence(key) for key in keys])
        elif keys:
            action.setShortcut(QKeySequence(keys))
        shown = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        action.setToolTip(f"{tip} ({shown})" if shown else tip)
        action.setStatusTip(tip)
        return action
