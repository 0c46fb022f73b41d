"""Action and panel of the conventions of other programs."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.gui.features.conventions.convention_panel import TITLE, ConventionPanel
from lispac.gui.project.features import Feature, PanelRecord, WindowPlace
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("convention", N_("&Angles in another program"),
        N_("Convert the boresight to the convention of another program, in a window"),
        ("Calibrate", 4, 1)),
)  # fmt: skip

FEATURE = Feature(
    ACTIONS,
    panels=(
        PanelRecord("convention", WindowPlace(TITLE, 460, 720, "convention"), ConventionPanel),
    ),
)
