"""Tools for inspection: sections, measurements, clip box, lasso, comparison."""

from collections.abc import Callable

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from lispac.gui.app.actions import Actions
from lispac.gui.app.docks import raise_panel
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.features.inspect.before_after_wipe import BeforeAfterWipe
from lispac.gui.features.inspect.clipping import ClipBoxController
from lispac.gui.features.inspect.clipping_panel import TITLE as CLIPPING
from lispac.gui.features.inspect.dialogs import PictureDialogs
from lispac.gui.features.inspect.linked_views import LinkedViews
from lispac.gui.features.inspect.measurements import Measurements
from lispac.gui.features.inspect.picture_export import PictureExport
from lispac.gui.features.inspect.point_readout import PointReadout
from lispac.gui.features.inspect.section_panel import TITLE as SECTION
from lispac.gui.features.inspect.sections import SectionTool
from lispac.gui.features.pick_targets.hover_preview import HoverPreview, HoverPreviewSettings
from lispac.gui.features.pick_targets.lasso import Lasso
from lispac.gui.features.pick_targets.target_actions import TargetRoles
from lispac.gui.project.computations import Computations
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Viewport


class InspectionTools(QObject):
    """Creates the tools and connects them with the window."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        viewport: Viewport,
        computations: Computations,
        controller: Controller,
        dialogs: PictureDialogs,
        actions: Actions,
        preview_settings: Callable[[], HoverPreviewSettings],
    ) -> None:
        super().__init__(actions)
        note, refuse = controller.logged.emit, controller.refused.emit
        self.mouse_tool = MouseTool(viewport, actions)
        self.measurements = Measurements(viewport, actions, self.mouse_tool, note)
        self.sections = SectionTool(
            document, runner, scene, viewport, actions, self.mouse_tool, raise_panel,
            lambda: self.linked_views.count > 1,
        )  # fmt: skip
        self.before_after_wipe = BeforeAfterWipe(
            document, scene, computations, viewport, actions, note
        )
        self.linked_views = LinkedViews(
            document, scene, computations, viewport, actions, self.mouse_tool,
            lambda: self.sections.section, note,
        )  # fmt: skip
        self.sections.moved.connect(self.linked_views.update)
        self.clipping = ClipBoxController(scene, viewport, actions, raise_panel, note)
        self.lasso = Lasso(
            document, scene, viewport, actions, self.mouse_tool, lambda: self.clipping.box, note,
            refuse,
        )  # fmt: skip
        self.hover_preview = HoverPreview(
            document, runner, viewport, actions, preview_settings, controller
        )
        self.point_readout = PointReadout(
            document, scene, viewport, actions["copy_picture"], note,
            lambda: bool(self.mouse_tool.tool) or actions["hover"].isChecked(),
        )  # fmt: skip
        self.pictures = PictureExport(
            document, runner, viewport, self.sections.panel, actions, dialogs, note
        )
        self.roles = TargetRoles(document, scene, actions, note, refuse)
        scene.which_changed.connect(lambda _which: self.measurements.restart())
        document.opened.connect(self.mouse_tool.end)
        document.about_to_open.connect(self.clipping.reset)

    @property
    def panels(self) -> dict[str, QWidget]:
        """Docked panels of the tools by title."""
        return {SECTION: self.sections.panel, CLIPPING: self.clipping.panel}
