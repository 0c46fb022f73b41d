"""Actions of the View menu: before and after, standard views, size and colours of the points."""

import numpy as np
from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.app.point_colours import COLOURINGS, Colouring
from lispac.gui.app.settings import POINT_SIZES_PX, AppSettings
from lispac.gui.app.unavailable import Unavailable, first_reason
from lispac.gui.features.inspect.actions import COLOUR_ACTIONS, VIEWS
from lispac.gui.project.computations import Computations
from lispac.gui.project.controller import Controller
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Array, Viewport
from lispac.gui.widgets.error_box import exception_text
from lispac.language import N_, gettext
from lispac.targets.cross_section import common_normal

NOTHING_SELECTED_TEXT = N_("Select a target first, in the list of targets or in the table.")


def with_help_until_used(viewport: Viewport, settings: AppSettings) -> Viewport:
    """Viewport that shows the help on the mouse until its first use on this computer."""
    viewport.show_help(not settings.has_used_mouse)
    viewport.signals.help_used.connect(lambda: setattr(settings, "has_used_mouse", True))
    return viewport


class ViewMenu(QObject):
    """Connects the actions of the View menu with the viewport."""

    def __init__(
        self,
        viewport: Viewport,
        scene: Scene,
        controller: Controller,
        computations: Computations,
        actions: Actions,
        settings: AppSettings,
    ) -> None:
        super().__init__(actions)
        self._viewport, self._scene, self._controller = viewport, scene, controller
        self._actions, self._settings = actions, settings
        viewport.set_point_size(settings.point_size)
        with_help_until_used(viewport, settings)
        slots = {
            "before": lambda: computations.show("prior"),
            "after": lambda: computations.show("estimated"),
            "toggle": lambda: computations.show(
                "prior" if scene.which == "estimated" else "estimated"
            ),
            "fit": viewport.fit,
            "previous_view": lambda: viewport.step_view(-1),
            "next_view": lambda: viewport.step_view(+1),
            "larger": lambda: self._resize_points(+1),
            "smaller": lambda: self._resize_points(-1),
            "colour_next": self._colour_by_next,
            "fit_selection": self._fit_selection,
            "normal": self._view_along_normal,
            "orthographic": lambda: viewport.set_parallel(actions["orthographic"].isChecked()),
        }
        for name in VIEWS:
            slots[name] = lambda name=name: viewport.view(name)
        for name in COLOURINGS:
            slots[COLOUR_ACTIONS[name]] = lambda name=name: self._colour_by(name)
        actions.connect_slots(slots)
        scene.colouring_changed.connect(lambda name: actions[COLOUR_ACTIONS[name]].setChecked(True))
        viewport.signals.history_changed.connect(self._enable_history)
        self._enable_history(False, False)

    def _enable_history(self, has_previous: bool, has_next: bool) -> None:
        for name, has_view, missing in (
            ("previous_view", has_previous, Unavailable.FIRST_VIEW),
            ("next_view", has_next, Unavailable.LAST_VIEW),
        ):
            self._actions.set_reason(name, first_reason((not has_view, missing)))

    def _resize_points(self, change: int) -> None:
        pixels = min(max(self._settings.point_size + change, POINT_SIZES_PX[0]), POINT_SIZES_PX[-1])
        self._settings.point_size = pixels
        self._viewport.set_point_size(pixels)

    def _fit_selection(self) -> None:
        if groups := self._selected_points():
            self._viewport.fit(np.concatenate(groups))

    def _view_along_normal(self) -> None:
        if groups := self._selected_points():
            self._viewport.view_along(common_normal(groups), np.concatenate(groups))

    def _selected_points(self) -> list[Array]:
        groups = list(self._scene.selected_points.values())
        if not groups:
            self._controller.logged.emit(gettext(NOTHING_SELECTED_TEXT))
        return groups

    def _colour_by(self, colouring: Colouring) -> bool:
        try:
            self._scene.colour_by(colouring)
        except ValueError as error:
            self._controller.logged.emit(exception_text(error))
        self._actions[COLOUR_ACTIONS[self._scene.colouring]].setChecked(True)
        return self._scene.colouring == colouring

    def _colour_by_next(self) -> None:
        current = COLOURINGS.index(self._scene.colouring)
        for k in range(1, len(COLOURINGS)):
            if self._colour_by(COLOURINGS[(current + k) % len(COLOURINGS)]):
                return
