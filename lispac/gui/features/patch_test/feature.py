"""Actions and panel of the patch test."""

from lispac.gui.app.actions import ActionRecord, by_name
from lispac.gui.app.questions import Questions
from lispac.gui.features.patch_test.controller import PatchTestController
from lispac.gui.features.patch_test.panel import PatchTestPanel
from lispac.gui.project.features import Feature, PanelRecord, WindowParts, WindowPlace
from lispac.language import N_

ACTIONS = by_name(
    ActionRecord("patch_test", N_("LiDAR &patch test"),
        N_("Estimate the boresight by aligning the lines on objects, as an alternative method"),
        ("Calibrate", 2, 4), keys="Ctrl+T"),
    ActionRecord("patch_point", N_("Add object &for the patch test"),
        N_("Put a patch-test box around the next point that you click"), ("Inspect", 3, 2),
        keys="Ctrl+Shift+T", toggles=True),
)  # fmt: skip


def _connect(panel: PatchTestPanel, window: WindowParts[Questions]) -> PatchTestController:
    return PatchTestController(
        window.document, window.runner, window.scene, window.viewport, window.controller,
        window.actions, window.mouse_tool, window.clip_box, panel,
    )  # fmt: skip


FEATURE = Feature(
    ACTIONS,
    panels=(
        PanelRecord(
            "patch_test",
            WindowPlace(
                N_("Patch test"), 830, 520, "patch_test", spares_view=True, narrow_width=456
            ),
            PatchTestPanel,
            _connect,
        ),
    ),
)
