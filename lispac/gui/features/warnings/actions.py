"""Action of the list of warnings."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("warnings", N_("Sho&w messages"),
        N_("List all errors, warnings and notes; click a message to go to its cause"),
        ("View", 5, 1),
        icon="alert-outline", keys="F12"),
)  # fmt: skip
