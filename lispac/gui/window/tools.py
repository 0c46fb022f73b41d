"""Tools for inspection: sections, measurements, clip box, lasso, comparison, patch test."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QWidget

from lispac.gui.app.docks import raise_panel
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.features.inspect.before_after_wipe import BeforeAfterWipe
from lispac.gui.features.inspect.clipping import ClipBoxController
from lispac.gui.features.inspect.clipping_panel import TITLE as CLIPPING
from lispac.gui.features.inspect.measurements import Measurements
from lispac.gui.features.inspect.picture_export import PictureExport
from lispac.gui.features.inspect.section_panel import TITLE as SECTION
from lispac.gui.features.inspect.sections import SectionTool
from lispac.gui.features.patch_test.controller import PatchTestController
from lispac.gui.features.patch_test.panel import TITLE as PATCH_TEST
from lispac.gui.features.pick_targets.hover_preview import HoverPreview, PreviewSettings
from lispac.gui.features.pick_targets.lasso import Lasso
from lispac.gui.features.pick_targets.target_actions import TargetRoles

if TYPE_CHECKING:
    from lispac.gui.window.main_window import MainWindow


class InspectionTools(QObject):
    """Creates the tools and connects them with the window."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        view, actions, note = window.viewport, window.actions_, window.controller.logged.emit
        self.mouse_tool = MouseTool(view, actions)
        self.measurements = Measurements(view, actions, self.mouse_tool, note)
        self.sections = SectionTool(
            window.document,
            window.runner,
            window.scene,
            view,
            actions,
            self.mouse_tool,
            raise_panel,
        )
        self.curtain = BeforeAfterWipe(
            window.document, window.scene, window.computations, view, actions, note
        )
        self.clipping = ClipBoxController(window.scene, view, actions, raise_panel, note)
        self.patch_test_controller = PatchTestController(window, raise_panel)
        self.lasso = Lasso(
            window.document, window.scene, view, actions, self.mouse_tool,
            lambda: self.clipping.box, note, window.controller.refused.emit,
        )  # fmt: skip
        self.hover_preview = HoverPreview(
            window.document, window.runner, view, actions, self._preview_settings, window.controller
        )
        self.pictures = PictureExport(
            window.document, window.runner, view, self.sections.panel, actions, window.dialogs,
            note,
        )  # fmt: skip
        self.roles = TargetRoles(
            window.document, window.scene, actions, note, window.controller.refused.emit
        )
        window.scene.which_changed.connect(lambda _which: self.measurements.restart())
        window.document.opened.connect(self.mouse_tool.end)
        window.document.about_to_open.connect(self.clipping.reset)

    def _preview_settings(self) -> PreviewSettings:
        targets = self._window.targets
        return PreviewSettings(targets.threshold, targets.radius, targets.shape == "plane")

    @property
    def panels(self) -> dict[str, tuple[QWidget, Qt.DockWidgetArea]]:
        """Panels of the tools by their titles, and the sides they are on."""
        below = Qt.DockWidgetArea.BottomDockWidgetArea
        return {
            SECTION: (self.sections.panel, below),
            PATCH_TEST: (self.patch_test_controller.panel, below),
            CLIPPING: (self.clipping.panel, below),
        }
