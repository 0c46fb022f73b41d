"""Action of the validation."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("validate", N_("&Validate"), N_("Compare the lines on the validation planes"),
        ("Calibrate", 1, 2), toolbar=(4, 2), short=N_("Validate"), icon="check-decagram-outline",
        keys="F10", uses_values=True),
)  # fmt: skip
