"""Actions about the program."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("tour", N_("Three-minute &tour"), N_("Calibrate the demo survey step by step"),
        ("Help", 1, 1), icon="compass-outline"),
    ActionRecord("manual", N_("Ma&nual"), N_("Open the manual in the browser, without a network"),
        ("Help", 1, 2), icon="book-open-outline", keys="Shift+F1"),
    ActionRecord("manual_step", N_("This &step in the manual"),
        N_("Open the manual at the step shown in the window"), ("Help", 1, 3), keys="Ctrl+F1"),
    ActionRecord("keys", N_("&Mouse and keys"),
        N_("List the actions of the mouse and the keyboard"), ("Help", 1, 4),
        icon="keyboard-outline", keys="F1"),
    ActionRecord("log_file", N_("Open the &log file"),
        N_("Open the file with all events, their times and the details of each error"),
        ("Help", 2, 1)),
    ActionRecord("about", N_("&About LISPAC"),
        N_("Show the version and the conventions of the program"), ("Help", 2, 2),
        icon="information-outline"),
)  # fmt: skip
