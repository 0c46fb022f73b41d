"""Action of the surveyed control."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("control", N_("Surveyed c&ontrol…"),
        N_("Use surveyed points or a static scan as observations of the adjustment, and show their "
           "residuals"), ("Calibrate", 1, 5), uses_values=True),
)  # fmt: skip
