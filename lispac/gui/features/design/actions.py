"""Actions of the survey design, in the main window and in the design window."""

from lispac.gui.app.actions import ActionRecord, Keys, Menu, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("design", N_("&Design a survey…"),
        N_("Plan boards and lines, and predict the precision before the survey"),
        ("Calibrate", 4, 3), keys="Ctrl+Shift+D"),
)  # fmt: skip

WINDOW_MENUS = {
    "File": Menu(N_("&File")),
    "Edit": Menu(N_("&Edit")),
    "View": Menu(N_("&View")),
    "Tools": Menu(N_("&Tools")),
    "Help": Menu(N_("&Help")),
}
WINDOW_ACTIONS = by_name(
    ActionRecord("new", N_("&New survey plan"),
        N_("Create a survey plan with the targets and lines of Shahraji's thesis"), ("File", 1, 1),
        toolbar=(1, 1), short=N_("New"), icon="file-outline", keys=Keys.New),
    ActionRecord("open", N_("&Open survey plan…"), N_("Open a survey plan"), ("File", 1, 2),
        toolbar=(1, 2), short=N_("Open"), icon="folder-open-outline", keys=Keys.Open),
    ActionRecord("save", N_("&Save survey plan"), N_("Save the survey plan"), ("File", 2, 1),
        toolbar=(1, 3), short=N_("Save"), icon="content-save-outline", keys=Keys.Save,
        uses_values=True),
    ActionRecord("save_as", N_("Save survey plan &as…"), N_("Save the survey plan in another file"),
        ("File", 2, 2), short=N_("Save as"), keys=Keys.SaveAs, uses_values=True),
    ActionRecord("page", N_("&Field plan…"),
        N_("Save the field plan as PDF: one page with a drawing, the targets and the order of "
           "the lines"), ("File", 3, 1), toolbar=(1, 4), short=N_("Field plan"),
        icon="file-document-outline", keys="Ctrl+E", uses_values=True),
    ActionRecord("close", N_("&Close"), N_("Close this window without discarding the survey plan"),
        ("File", 4, 1), short=N_("Close"), keys=Keys.Close),
    ActionRecord("undo", N_("&Undo"), N_("Undo the last edit"), ("Edit", 1, 1), toolbar=(2, 1),
        short=N_("Undo"), icon="undo", keys=Keys.Undo),
    ActionRecord("redo", N_("&Redo"), N_("Redo the edit that was undone"), ("Edit", 1, 2),
        toolbar=(2, 2), short=N_("Redo"), icon="redo", keys=("Ctrl+Y", "Ctrl+Shift+Z")),
    ActionRecord("add_line", N_("Add &line"),
        N_("Add a line in the direction opposite to the selected line"), ("Edit", 2, 1),
        toolbar=(3, 1), short=N_("Add line"), icon="plus", keys="Ctrl+L"),
    ActionRecord("duplicate", N_("&Duplicate line"), N_("Add a copy of the selected line"),
        ("Edit", 2, 2), toolbar=(3, 2), short=N_("Duplicate"), icon="content-copy", keys="Ctrl+D"),
    ActionRecord("earlier", N_("Move line &earlier"),
        N_("Move the selected line one position earlier in the survey order"), ("Edit", 2, 3),
        short=N_("Move earlier"), keys="Alt+Up"),
    ActionRecord("later", N_("Move line la&ter"),
        N_("Move the selected line one position later in the survey order"), ("Edit", 2, 4),
        short=N_("Move later"), keys="Alt+Down"),
    ActionRecord("add_board", N_("Add &board"), N_("Add a flat target board"), ("Edit", 3, 1),
        toolbar=(3, 3), short=N_("Add board"), icon="square-outline", keys="Ctrl+B"),
    ActionRecord("add_ball", N_("Add &sphere"), N_("Add a spherical target"), ("Edit", 3, 2),
        toolbar=(3, 4), short=N_("Add sphere"), icon="circle-outline", keys="Ctrl+Shift+B"),
    ActionRecord("fit", N_("&Fit the 3D view"), N_("Show the whole site in the 3D view"),
        ("View", 1, 1), short=N_("Fit view"), icon="fit-to-page-outline", keys="Ctrl+0"),
    ActionRecord("scenarios", N_("Sc&enarios"),
        N_("Predict the precision while one quantity varies, with correlated and with "
           "uncorrelated POS errors"), ("Tools", 1, 1), toolbar=(4, 1), short=N_("Scenarios"),
        icon="chart-bar", keys="F9", uses_values=True),
    ActionRecord("surveys", N_("Simulate &surveys…"),
        N_("Simulate this survey many times to check the predicted standard deviations"),
        ("Tools", 1, 2), short=N_("Simulate surveys"), icon="dice-multiple-outline", keys="F10"),
    ActionRecord("compare", N_("Compare with the &open project"),
        N_("Compare the standard deviations of the open project with those predicted for the "
           "survey plan"), ("Tools", 1, 3), short=N_("Compare"), icon="compare-horizontal",
        keys="F11", uses_values=True),
    ActionRecord("cancel", N_("&Cancel the running task"),
        N_("Cancel the running task; the project stays unchanged"), ("Tools", 2, 1),
        short=N_("Cancel"), icon="close-circle-outline", keys="Ctrl+."),
    ActionRecord("keys", N_("&Mouse and keys"), N_("Show the mouse and keyboard actions"),
        ("Help", 1, 1), short=N_("Mouse and keys"), icon="keyboard-outline", keys="F1"),
)  # fmt: skip
"""Menus and actions of the design window."""
