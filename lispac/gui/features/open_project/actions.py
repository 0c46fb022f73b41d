"""Actions on the project."""

from PySide6.QtGui import QKeySequence

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("new", N_("&New project…"), N_("Create a project from a trajectory and lines"),
        ("File", 1, 1), toolbar=(1, 1), short=N_("New"), icon="folder-plus-outline",
        keys=QKeySequence.StandardKey.New),
    ActionRecord("open", N_("&Open project…"), N_("Open a project"), ("File", 1, 2), toolbar=(1, 2),
        short=N_("Open"), icon="folder-open-outline", keys=QKeySequence.StandardKey.Open),
    ActionRecord("demo", N_("Open &demo survey"), N_("Open the built-in simulated survey"),
        ("File", 1, 3), icon="ferry"),
    ActionRecord("add_lines", N_("Add &lines…"), N_("Add lines to the open project"),
        ("File", 2, 1), icon="file-plus-outline"),
    ActionRecord("save", N_("&Save"), N_("Save the project"), ("File", 2, 2), toolbar=(1, 3),
        short=N_("Save"), icon="content-save-outline", keys=QKeySequence.StandardKey.Save,
        uses_values=True),
    ActionRecord("save_as", N_("Save &as…"),
        N_("Save the project in another folder and continue to work on the copy"), ("File", 2, 3),
        keys=QKeySequence.StandardKey.SaveAs, uses_values=True),
    ActionRecord("close_project", N_("Close &project"),
        N_("Close the project and show the start page"), ("File", 2, 4)),
)  # fmt: skip
