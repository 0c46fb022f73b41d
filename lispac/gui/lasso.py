"""Points of the selected target added or taken away inside an outline drawn over the view."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject

from lispac.errors import LispacError
from lispac.gui.actions import Actions
from lispac.gui.clipping import Clipping
from lispac.gui.document import Document
from lispac.gui.pointing import Pointing
from lispac.gui.scene import Scene
from lispac.gui.viewport.base import Array, Viewport
from lispac.workflow.editing import with_points, without_points

HINTS = {
    "lasso_add": "Draw around points to add to {}",
    "lasso_remove": "Draw around points to take from {}",
}
NOTHING_SELECTED = "Select a target first; then draw around points of it"


class Lasso(QObject):
    """Each outline is one undo step; Esc ends.

    What is selected is edited: one sighting, or a target on all lines that are shown.
    """

    def __init__(
        self,
        document: Document,
        scene: Scene,
        viewport: Viewport,
        actions: Actions,
        pointing: Pointing,
        clipping: Clipping,
        note: Callable[[str], None],
        refuse: Callable[[LispacError], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._scene, self._viewport = document, scene, viewport
        self._pointing, self._clipping = pointing, clipping
        self._actions, self._note, self._refuse = actions, note, refuse
        for tool in HINTS:
            actions[tool].triggered.connect(lambda on, tool=tool: self._switch(tool, on))
        scene.selection_changed.connect(self._hint)

    def _switch(self, tool: str, on: bool) -> None:
        if not on:
            self._pointing.end()
        elif not self._scene.selected_points:
            self._actions[tool].setChecked(False)
            self._note(NOTHING_SELECTED)
        else:
            self._pointing.begin(tool, "", outlined=self._take, ended=lambda: None)
            self._hint()

    def _hint(self) -> None:
        tool, selected = self._pointing.tool, self._scene.selected
        if tool in HINTS and selected is not None:
            what = " on ".join(part for part in selected if part)
            self._pointing.hint(HINTS[tool].format(what), "outline")

    def _take(self, corners: Array) -> None:
        project, selected = self._document.project, self._scene.selected
        if project is None or selected is None or not self._scene.selected_points:
            self._note(NOTHING_SELECTED)
            return
        name, line = selected
        adding = self._pointing.tool == "lasso_add"
        edit = with_points if adding else without_points
        shown = {
            each: cloud
            for each, cloud in self._scene.clouds.items()
            if not self._viewport.hides(each)
        }
        try:
            target, changed = edit(
                project.target(name), shown, lambda points: self._inside(points, corners), line
            )
        except LispacError as error:
            self._refuse(error)
            return
        where = f" on {line}" if line else ""
        if not changed:
            self._note(f"{name}{where}: no points of it there")
            return
        done = "added to" if adding else "taken from"
        what = f"{'adding' if adding else 'removal of'} {changed:,} points, {name}{where}"
        self._document.edit(what, project.with_target(target), follows=True)
        self._note(f"{changed:,} points {done} {name}{where}")

    def _inside(self, points: Array, corners: Array) -> NDArray[np.bool_]:
        from matplotlib.path import Path

        inside = np.zeros(len(points), dtype=bool)
        pixels = self._viewport.to_pixels(points)
        seen = np.isfinite(pixels).all(axis=1)
        inside[seen] = Path(corners).contains_points(pixels[seen])
        if self._clipping.box is not None:
            boxed = np.zeros(len(points), dtype=bool)
            boxed[self._clipping.box.inside(points)] = True
            inside &= boxed
        return inside
