"""Menus and actions of the main window, including the actions of all features."""

from PySide6.QtGui import QKeySequence

from lispac.gui.app.actions import ActionRecord, Menu, by_name
from lispac.gui.project.status import STEP_TITLES
from lispac.gui.window.features import FEATURES
from lispac.language import N_

MENUS = {
    "File": Menu(N_("&File")),
    "Recent": Menu(N_("Open &recent"), "File", 1, 4),
    "Edit": Menu(N_("&Edit")),
    "View": Menu(N_("&View")),
    "Linked views": Menu(N_("Lin&ked views"), "View", 1, 5),
    "Look from": Menu(N_("&Look from"), "View", 2, 3),
    "Colour by": Menu(N_("&Colour by"), "View", 3, 3),
    "Steps": Menu(N_("S&teps"), "View", 5, 2),
    "Panels": Menu(N_("&Panels"), "View", 5, 3),
    "Theme": Menu(N_("T&heme"), "View", 5, 4),
    "Language": Menu(N_("Lan&guage · Langue"), "View", 5, 5),
    "Inspect": Menu(N_("&Inspect")),
    "Targets": Menu(N_("&Targets")),
    "Calibrate": Menu(N_("&Calibrate")),
    "Help": Menu(N_("&Help")),
}
"""Menus and submenus by name; those of the menu bar in their order."""

STEP_ACTIONS = by_name(
    *(
        ActionRecord(
            f"step_{k}",
            title,
            N_("Go to step {number:n} of the workflow"),
            ("Steps", 1, k),
            keys=f"Ctrl+{k}",
            number=k,
        )
        for k, title in enumerate(STEP_TITLES, 1)
    )
)
"""Actions that open the steps, in the order of the steps."""

ACTIONS = by_name(
    ActionRecord("undo", N_("&Undo"), N_("Undo the last edit"), ("Edit", 1, 1), toolbar=(2, 1),
        short=N_("Undo"), icon="undo", keys=QKeySequence.StandardKey.Undo),
    ActionRecord("redo", N_("&Redo"), N_("Redo the edit that was undone"), ("Edit", 1, 2),
        toolbar=(2, 2), short=N_("Redo"), icon="redo", keys=("Ctrl+Y", "Ctrl+Shift+Z")),
    ActionRecord("cancel", N_("&Cancel the running task"),
        N_("Cancel the running task; the project stays unchanged"), ("Calibrate", 5, 1),
        icon="close-circle-outline", keys="Ctrl+."),
    ActionRecord("arrange", N_("&Restore default layout"),
        N_("Restore the default layout of all panels"), ("Panels", 2, 1)),
    ActionRecord("maximise", N_("Ma&ximise the 3D view"),
        N_("Hide all panels and the toolbar; the same key restores them"), ("View", 2, 5),
        icon="fullscreen", keys="F11", toggles=True),
    ActionRecord("quit", N_("&Quit"), N_("Quit the program"), ("File", 6, 1),
        keys=QKeySequence.StandardKey.Quit),
)  # fmt: skip

ALL_ACTIONS = {
    **{name: each for feature in FEATURES for name, each in feature.actions.items()},
    **STEP_ACTIONS,
    **ACTIONS,
}
"""All actions by name; the place of each in the menus is in its record."""
