"""Actions of the patch test."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("patch_test", N_("LiDAR &patch test"),
        N_("Estimate the boresight by aligning the lines on objects, as an alternative method"),
        ("Calibrate", 2, 4), keys="Ctrl+T"),
    ActionRecord("patch_point", N_("Add object &for the patch test"),
        N_("Put a patch-test box around the next point that you click"), ("Inspect", 3, 2),
        keys="Ctrl+Shift+T", toggles=True),
)  # fmt: skip
