"""Navigation from a warning to its cause: opens the panel, selects and focuses the cause."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QScrollArea, QWidget

from lispac.gui.app.docks import raise_panel
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.project.status import ADJUST, DATA, STEP_KEYS, TARGETS, VALIDATE
from lispac.gui.viewport.base import Viewport
from lispac.gui.widgets.foldable_group import FoldableGroup
from lispac.gui.window.panels import Panels
from lispac.warning_causes import Cause


class CauseNavigation(QObject):
    """Goes to the causes of warnings.

    Parameters
    ----------
    select : function that selects a target and a line (or "")
    """

    def __init__(
        self,
        document: Document,
        scene: Scene,
        viewport: Viewport,
        panels: Panels,
        select: Callable[[str, str], None],
    ) -> None:
        super().__init__(scene)
        self._document, self._scene, self._viewport = document, scene, viewport
        self._panels, self._select = panels, select

    def show_cause(self, cause: Cause) -> None:
        """Go to the cause of a warning: open, select and focus it."""
        functions = {
            "line": self._go_to_line,
            "target": self._go_to_sighting,
            "sighting": self._go_to_sighting,
            "parameter": self._go_to_parameter,
            "field": self._go_to_field,
            "page": self._go_to_page,
            "step": self._go_to_step,
            "result": self._go_to_result,
        }
        functions[cause.kind](cause)

    def go_to_acceptance_criteria(self) -> None:
        """Open step 4, and focus the field of the first acceptance criterion."""
        self._open_step(VALIDATE)
        _focus_widget(next(iter(self._panels.validate.acceptance.fields.values())))

    def go_to_noise_model(self) -> None:
        """Open the fields of a LiDAR noise with several values in step 3."""
        self._open_step(ADJUST)
        _focus_widget(self._panels.adjust.model.noise)

    def _go_to_line(self, cause: Cause) -> None:
        data, scene = self._panels.data, self._scene
        self._open_step(DATA)
        if data.select_line(cause.name):
            _focus_widget(data.lines)
        cloud = scene.clouds.get(cause.name)
        if cloud is not None:
            scene.focused.emit(cloud.sample[::50], cause.name)
            self._viewport.fit(cloud.sample)

    def _go_to_sighting(self, cause: Cause) -> None:
        project = self._document.project
        if project is None or cause.name not in {target.name for target in project.targets}:
            return
        panels = self._panels
        self._select(cause.name, cause.line)
        if cause.kind == "target":
            self._open_step(TARGETS)
            _focus_widget(panels.targets.table)
        else:
            raise_panel(panels.table)
            panels.table.go_to(cause.name, cause.line)
            _focus_widget(panels.table)

    def _go_to_parameter(self, cause: Cause) -> None:
        switch = self._panels.adjust.parameters.switches.get(cause.name)
        if switch is None:
            self._go_to_result(cause)
        else:
            self._open_step(ADJUST)
            _focus_widget(switch)

    def _go_to_field(self, cause: Cause) -> None:
        data, adjust = self._panels.data, self._panels.adjust
        model, is_one_noise = adjust.model, data.lidar_sigma.isVisibleTo(data)
        longest = max(data.lever_arm.fields, key=lambda field: abs(field.value()))
        step, field = {
            "lever_arm": (DATA, longest),
            "boresight_deg": (DATA, data.boresight.fields[0]),
            "lidar_sigma": (DATA, data.lidar_sigma) if is_one_noise else (ADJUST, model.noise),
            "position_sigma": (DATA, data.pos_sigmas.position.fields[0]),
            "attitude_sigma_deg": (DATA, data.pos_sigmas.attitude.fields[0]),
            "pos_errors": (ADJUST, adjust.chosen_model),
            "surface": (ADJUST, model.surface),
            "position_time": (ADJUST, model.position_time),
        }[cause.name]
        self._open_step(step)
        _focus_widget(field)

    def _go_to_page(self, cause: Cause) -> None:
        diagnostics = self._panels.diagnostics
        raise_panel(diagnostics)
        diagnostics.open(cause.name)
        _focus_widget(diagnostics.list)

    def _go_to_step(self, cause: Cause) -> None:
        self._panels.workflow.go_to(STEP_KEYS.index(cause.name))

    def _go_to_result(self, _cause: Cause) -> None:
        raise_panel(self._panels.results)
        _focus_widget(self._panels.results.angles)

    def _open_step(self, step: int) -> None:
        raise_panel(self._panels.workflow)
        self._panels.workflow.open(step)


def _focus_widget(widget: QWidget) -> None:
    """Give a widget the focus, unfold the groups around it and scroll to it."""
    parent, areas = widget.parentWidget(), []
    while parent is not None:
        if isinstance(parent, FoldableGroup):
            parent.open()
        if isinstance(parent, QScrollArea):
            areas.append(parent)
        parent = parent.parentWidget()
    widget.setFocus(Qt.FocusReason.OtherFocusReason)
    for area in areas:
        area.ensureWidgetVisible(widget)
