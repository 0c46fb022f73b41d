"""Action of the survey design."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("design", N_("&Design a survey…"),
        N_("Plan boards and lines, and predict the precision before the survey"), ("Adjust", 2, 5),
        keys="Ctrl+Shift+D"),
)  # fmt: skip
