"""Action and panel of the conventions of other programs."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.gui.features.conventions.convention_panel import TITLE, ConventionPanel
from lispac.gui.features.conventions.dialogs import ConventionDialogs
from lispac.gui.features.conventions.installation_export import InstallationExport
from lispac.gui.project.features import Feature, PanelRecord, WindowParts, WindowPlace
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("convention", N_("&Angles in another program"),
        N_("Convert the boresight to the convention of another program, in a window"),
        ("Calibrate", 4, 1)),
)  # fmt: skip


def _connect(panel: ConventionPanel, window: WindowParts[ConventionDialogs]) -> InstallationExport:
    return InstallationExport(
        window.document, window.runner, window.controller, window.dialogs, window.actions, panel
    )


FEATURE = Feature(
    ACTIONS,
    ConventionDialogs,
    panels=(
        PanelRecord(
            "convention", WindowPlace(TITLE, 460, 720, "convention"), ConventionPanel, _connect
        ),
    ),
)
