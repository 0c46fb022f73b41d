"""Actions of the adjustment."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("estimate", N_("&Estimate boresight"),
        N_("Adjust boresight and targets together by least squares"), ("Calibrate", 1, 1),
        toolbar=(4, 1), short=N_("Estimate"), icon="calculator-variant-outline", keys="F9",
        uses_values=True),
    ActionRecord("diagnostics", N_("Dia&gnostics"),
        N_("Show figures and tables of the adjustment in a window"), ("Calibrate", 1, 3),
        icon="chart-bar", keys="Ctrl+D"),
)  # fmt: skip
