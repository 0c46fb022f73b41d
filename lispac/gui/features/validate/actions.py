"""Actions of the validation."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("validate", N_("&Validate"), N_("Compare the lines on the validation planes"),
        ("Calibrate", 1, 2), toolbar=(4, 2), short=N_("Validate"), icon="check-decagram-outline",
        keys="F10", uses_values=True),
    ActionRecord("acceptance_criteria", N_("Accep&tance criteria"),
        N_("Enter the limits by which the calibration is judged, in step 4"), ("Calibrate", 1, 4)),
)  # fmt: skip
