"""Clip box: only points inside it are drawn, picked and measured."""

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.features.inspect.clipping_panel import ClippingPanel
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Colour, DragHandle, Sketch, Viewport
from lispac.gui.viewport.clipping import BOX_EDGES, Array, Box
from lispac.gui.viewport.decimation import trimmed_points
from lispac.language import gettext
from lispac.targets.cross_section import common_normal

SKETCH_COLOUR: Colour = (255, 170, 0)
SKETCH_NAME = "clip"
BOX_MARGIN_M = 0.5
"""Margin of the box around a target, metres."""


class ClipBoxController(QObject):
    """Holds the clip box, which is changed by handles on its sides and by the panel."""

    def __init__(
        self,
        scene: Scene,
        viewport: Viewport,
        actions: Actions,
        bring: Callable[[QObject], None],
        note: Callable[[str], None],
    ) -> None:
        super().__init__(actions)
        self._scene, self._viewport, self._actions = scene, viewport, actions
        self._bring, self._note = bring, note
        self.panel = ClippingPanel()
        self.box: Box | None = None
        actions["clip"].triggered.connect(lambda on: self.begin() if on else self.reset())
        self.panel.lengths_changed.connect(
            lambda lengths: self._set_box(self.box and self.box.with_lengths(lengths))
        )
        self.panel.fit_requested.connect(self.begin)
        self.panel.reset_requested.connect(self.reset)
        scene.focused.connect(self.show)
        viewport.signals.handle_moved.connect(self._move_side)
        viewport.signals.handle_released.connect(self._on_handle_released)

    def begin(self) -> None:
        """Place the box around the selected target, or around everything."""
        groups = list(self._scene.selected_points.values())
        if groups:
            box = Box.around(np.concatenate(groups), common_normal(groups), BOX_MARGIN_M)
        else:
            samples = [cloud.sample[::50] for cloud in self._scene.clouds.values()]
            if not samples:
                self._actions["clip"].setChecked(False)
                return
            everything = trimmed_points(np.concatenate(samples), 1.0)
            box = Box.around(everything, np.array([1.0, 0.0, 0.0]), 0.0)
        self._set_box(box)
        self._bring(self.panel)

    def show(self, points: Array, name: str) -> None:
        """Move the box to the given points (n, 3) if it hides most of them."""
        if self.box is None or 2 * len(self.box.inside(points)) >= len(points):
            return
        self._set_box(Box.around(points, common_normal([points]), BOX_MARGIN_M))
        self._note(
            gettext("{name} was outside the clip box. The clip box was moved around it.", name=name)
        )

    def reset(self) -> None:
        """Remove the box, so that everything is drawn."""
        if self.box is not None:
            self._set_box(None)
        self._actions["clip"].setChecked(False)

    def copy_state_from(self, former: "ClipBoxController") -> None:
        """Take over the box of a former window."""
        if former.box is not None:
            self._set_box(former.box)

    def _set_box(self, box: Box | None) -> None:
        self.box = box
        self._actions["clip"].setChecked(box is not None)
        self._show()
        self._viewport.clip(box)

    def _show(self) -> None:
        self.panel.show_box(self.box)
        self._viewport.show_sketch(SKETCH_NAME, None if self.box is None else _box_sketch(self.box))

    def _move_side(self, name: str, side: int, metres: float) -> None:
        if name == SKETCH_NAME and self.box is not None:
            self.box = self.box.with_side_moved(side, metres)
            self._show()  # the points are clipped when the handle is released

    def _on_handle_released(self, name: str) -> None:
        if name == SKETCH_NAME and self.box is not None:
            self._viewport.clip(self.box)


def _box_sketch(box: Box) -> Sketch:
    def place(point: np.ndarray) -> tuple[float, float, float]:
        return float(point[0]), float(point[1]), float(point[2])

    handles = tuple(DragHandle(place(middle), place(out)) for middle, out in box.sides)
    return Sketch(tuple(map(place, box.corners)), BOX_EDGES, SKETCH_COLOUR, handles=handles)
