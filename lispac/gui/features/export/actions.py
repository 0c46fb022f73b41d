"""Actions that export data."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("lines", N_("Export &georeferenced lines…"),
        N_("Write the lines as LAZ or LAS in a coordinate system of your choice"), ("File", 3, 2),
        icon="export-variant", keys="Ctrl+Shift+E", uses_values=True),
    ActionRecord("targets", N_("Export &targets…"),
        N_("Write the points of the targets and validation planes, or files with the parameters "
           "of the planes"), ("File", 3, 3), uses_values=True),
    ActionRecord("trajectory", N_("Export tra&jectory…"),
        N_("Write the trajectory as SBET or text"), ("File", 3, 4), uses_values=True),
    ActionRecord("corrected_trajectory", N_("Export corrected trajector&y…"),
        N_("Write the trajectory corrected by the adjustment, with its accuracies and corrections"),
        ("File", 3, 5), uses_values=True),
    ActionRecord("script", N_("Python s&cript of this project…"),
        N_("Show the Python script that creates this project from its input files"),
        ("File", 4, 1), uses_values=True),
)  # fmt: skip
