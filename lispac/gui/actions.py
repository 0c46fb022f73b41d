"""Menus, toolbar and keys: every action of the window by its name."""

from collections.abc import Iterable

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu, QToolBar

from lispac.gui import theme
from lispac.gui.language import say
from lispac.gui.viewing_actions import (
    COLOURED,
    INSPECT_ACTIONS,
    INSPECT_MENU,
    STEP_ACTIONS,
    SWITCHES,
    THEMED,
    VIEW_ACTIONS,
    VIEW_MENU,
    Menu,
)

Keys = QKeySequence.StandardKey

# name: (text, short text for the toolbar, icon, keys, tip)
_ACTIONS: dict[str, tuple[str, str, str, object, str]] = {
    "new": ("&New project…", "New", "folder-plus-outline", Keys.New,
            "Make a project from a trajectory and raw lines"),
    "open": ("&Open project…", "Open", "folder-open-outline", Keys.Open, "Open a project"),
    "demo": ("Open &demo survey", "Demo", "ferry", "", "Open the built-in simulated survey"),
    "add_lines": ("Add &lines…", "Add lines", "file-plus-outline", "",
                  "Add more lines to the open project"),
    "save": ("&Save", "Save", "content-save-outline", Keys.Save, "Save the project"),
    "save_as": ("Save &as…", "Save as", "", Keys.SaveAs,
                "Save the project in another folder and go on there"),
    "report": ("&Export report…", "Report", "file-document-outline", "Ctrl+E",
               "Write the report as PDF, HTML, JSON or tables (CSV in a ZIP)"),
    "lines": ("Export &georeferenced lines…", "Lines", "export-variant", "Ctrl+Shift+E",
              "Write every line as LAZ or LAS in a coordinate system of your choice"),
    "targets": ("Export &targets…", "Targets", "", "",
                "Write the points of targets and validation planes, or plane files"),
    "trajectory": ("Export tra&jectory…", "Trajectory", "", "",
                   "Write the trajectory as SBET or text"),
    "script": ("S&cript of this project…", "Script", "", "",
               "Show the Python that makes this project again from its raw files"),
    "settings": ("Sett&ings…", "Settings", "cog-outline", "Ctrl+,",
                 "Language, view, report, and the library of sensors"),
    "quit": ("&Quit", "Quit", "", Keys.Quit, "Close the program"),
    "undo": ("&Undo", "Undo", "undo", Keys.Undo, "Take the last edit back"),
    "redo": ("&Redo", "Redo", "redo", ("Ctrl+Y", "Ctrl+Shift+Z"), "Make the edit again"),
    "seed_target": ("Seed an adjustment &target", "Target", "target", "F6",
                    "The next Ctrl+click picks an adjustment target"),
    "seed_validation": ("Seed a &validation plane", "Validation", "shield-check-outline", "F7",
                        "The next Ctrl+click picks a validation plane"),
    "seed_at": ("Seed at &coordinates…", "Coordinates", "crosshairs-gps", "F3",
                "Type the coordinates of a seed, in the local frame or on the map"),
    "seed_list": ("Seeds &from a file…", "Seed list", "format-list-bulleted", "Shift+F3",
                  "Pick all targets of a list of coordinates, from a total station for example"),
    "propose": ("&Propose targets", "Propose", "auto-fix", "F5",
                "Find flat surfaces on all lines and propose targets and validation planes"),
    "find_again": ("F&ind again with other settings…", "Find again", "refresh", "Shift+F5",
                   "Seek the selected target with another threshold or search radius"),
    "accept": ("&Accept the plane found", "Accept", "check-bold", ("Return", "Enter"),
               "Accept the detected plane"),
    "reject": ("Re&ject the plane found", "Reject", "close", "Esc",
               "Discard the detected plane"),
    "estimate": ("&Estimate boresight", "Estimate", "calculator-variant-outline", "F9",
                 "Adjust boresight and planes together"),
    "validate": ("&Validate", "Validate", "check-decagram-outline", "F10",
                 "Compare the lines on the validation planes"),
    "check": ("Check against a &reference…", "Check", "", "Shift+F10",
              "Compare the lines with a static scan or surveyed points"),
    "line_quality": ("&Differences between lines…", "Differences", "", "Ctrl+F10",
                     "How far every two lines are apart where the scene is flat, as shown"),
    "budget": ("Error &budget…", "Budget", "", "",
               "What each source of error does to a point at a distance"),
    "history": ("Calibrations over the &years…", "History", "", "F11",
                "All calibrations of a vessel's system: has its mounting moved?"),
    "patch_test": ("LiDAR &patch test", "Patch test", "", "Ctrl+T",
                   "Align lines on objects: an alternative method for the boresight"),
    "subsampling": ("&Subsampling study…", "Subsampling", "", "Shift+F9",
                    "Adjust with points nearer together and farther apart, and compare"),
    "methods": ("Compare with other &methods…", "Methods", "", "Ctrl+F9",
                "What the validation planes and the scene itself say of the boresight"),
    "visibility": ("&Visibility of errors…", "Visibility", "", "",
                   "Which board and which lines show which systematic error"),
    "design": ("&Design a site…", "Design", "", "Ctrl+Shift+D",
               "Which boards, where, and which lines: see what they will give before surveying"),
    "cancel": ("&Cancel the running task", "Cancel", "close-circle-outline", "Ctrl+.",
               "Stop; nothing is changed"),
    "before": ("&Before (prior boresight)", "Before", "history", "",
               "Show the lines placed with the prior boresight"),
    "after": ("&After (estimated boresight)", "After", "check-all", "",
              "Show the lines placed with the estimated boresight"),
    "toggle": ("&Switch before / after", "Switch", "swap-horizontal", "B",
               "Switch the view between prior and estimated boresight"),
    "warnings": ("&Warnings", "Warnings", "alert-outline", "F12",
                 "All there is to be warned of; each leads to its cause"),
    **STEP_ACTIONS,
    **VIEW_ACTIONS,
    **INSPECT_ACTIONS,
    "manual": ("Ma&nual", "Manual", "book-open-outline", "Shift+F1",
               "The manual in the browser; it needs no network"),
    "manual_step": ("This &step in the manual", "This step", "", "Ctrl+F1",
                    "What the manual says of the step that is open"),
    "keys": ("&Mouse and keys", "Keys", "keyboard-outline", "F1", "What mouse and keys do"),
    "english": ("&English", "English", "", "", "The window in English"),
    "french": ("&Français", "Français", "", "", "La fenêtre en français"),
    "tour": ("Three-minute &tour", "Tour", "compass-outline", "",
             "Calibrate the built-in survey, led step by step"),
    "log_file": ("Open the &log file", "Log file", "", "",
                 "What happened and when, with the details of every error"),
    "about": ("&About LISPAC", "About", "information-outline", "", "Version and conventions"),
}  # fmt: skip

_CHECKABLE = (
    ("seed_target", "seed_validation"), ("before", "after"), tuple(COLOURED.values()),
    ("english", "french"), tuple(THEMED.values()),
)  # fmt: skip
_MENUS: dict[str, Menu] = {
    "&File": (
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
    "&Edit": ("undo", "redo"),
    "&View": VIEW_MENU,
    "&Inspect": INSPECT_MENU,
    "&Targets": (
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
    "&Adjust": (
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
    "Va&lidate": ("validate", "check", "line_quality", "", "budget", "history"),
    "&Help": ("tour", "manual", "manual_step", "keys", "", "log_file", "about"),
}
_TOOLBAR = (
    "new", "open", "save", "", "undo", "redo", "", "seed_target", "seed_validation", "", "estimate",
    "validate", "report", "", "before", "after", "", "fit", "isometric", "top", "front",
    "left",
)  # fmt: skip


class Actions(QObject):
    """The window's actions, by name."""

    def __init__(self, window: QMainWindow, stack: QUndoStack) -> None:
        super().__init__(window)
        self._window = window
        self.recent = QMenu(say("Open &recent"), window)
        self.recent.setObjectName("recent_menu")
        self._by_name = {name: self._made(name) for name in _ACTIONS}
        for pair in _CHECKABLE:
            group = QActionGroup(window)
            for name in pair:
                self[name].setCheckable(True)
                group.addAction(self[name])
            self[pair[0]].setChecked(True)
        for name in SWITCHES:
            self[name].setCheckable(True)
        stack.canUndoChanged.connect(self["undo"].setEnabled)
        stack.canRedoChanged.connect(self["redo"].setEnabled)
        stack.undoTextChanged.connect(self._name_undo)
        stack.redoTextChanged.connect(self._name_redo)
        self["undo"].triggered.connect(stack.undo)
        self["redo"].triggered.connect(stack.redo)
        # A window made anew begins with the steps of the former one
        self["undo"].setEnabled(stack.canUndo())
        self["redo"].setEnabled(stack.canRedo())
        self._name_undo(stack.undoText())
        self._name_redo(stack.redoText())

    def __getitem__(self, name: str) -> QAction:
        return self._by_name[name]

    def fill_menus(self, docks: Iterable[QAction]) -> None:
        """Build the menu bar."""
        self._docks = list(docks)
        for title, names in _MENUS.items():
            self._fill(self._window.menuBar().addMenu(say(title)), names)

    def _fill(self, menu: QMenu, names: Menu) -> None:
        for name in names:
            if isinstance(name, tuple):
                self._fill(menu.addMenu(say(name[0])), name[1])
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
        bar = QToolBar(say("Toolbar"), self._window)
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

    def _name_undo(self, text: str) -> None:
        self["undo"].setText(say(f"&Undo {text}".strip()))
        self["undo"].setIconText(say("Undo"))

    def _name_redo(self, text: str) -> None:
        self["redo"].setText(say(f"&Redo {text}".strip()))
        self["redo"].setIconText(say("Redo"))

    def _made(self, name: str) -> QAction:
        text, short, icon, keys, tip = _ACTIONS[name]
        action = QAction(say(text), self._window)
        action.setObjectName(f"action_{name}")
        action.setIconText(say(short))
        if icon:
            action.setIcon(theme.icon(icon))
        if isinstance(keys, tuple):
            action.setShortcuts([QKeySequence(key) for key in keys])
        elif keys:
            action.setShortcut(QKeySequence(keys))
        shown = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        action.setToolTip(f"{say(tip)} ({shown})" if shown else say(tip))
        action.setStatusTip(say(tip))
        return action
