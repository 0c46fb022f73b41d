"""Lasso: adds points inside a drawn outline to the selected target, or removes them."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject

from lispac.errors import LispacError
from lispac.gui.app.actions import Actions
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Array, Viewport
from lispac.gui.viewport.clipping import Box
from lispac.language import N_, Plural, gettext
from lispac.workflow.calibration.point_edits import with_points, without_points

TOOLS = ("lasso_add", "lasso_remove")
NOTHING_SELECTED_TEXT = N_("Select a target first, then draw around its points.")
EDIT_NAMES = {
    "lasso_add": Plural(
        "addition of {count:n} point to {sighting}", "addition of {count:n} points to {sighting}"
    ),
    "lasso_remove": Plural(
        "removal of {count:n} point from {sighting}", "removal of {count:n} points from {sighting}"
    ),
}
"""Names of the edits."""
EDIT_NOTES = {
    "lasso_add": Plural(
        "{count:n} point was added to {sighting}", "{count:n} points were added to {sighting}"
    ),
    "lasso_remove": Plural(
        "{count:n} point was removed from {sighting}",
        "{count:n} points were removed from {sighting}",
    ),
}


class Lasso(QObject):
    """Edits the selected sighting, or a target in all lines shown; one undo step per outline."""

    def __init__(
        self,
        document: Document,
        scene: Scene,
        viewport: Viewport,
        actions: Actions,
        mouse_tool: MouseTool,
        clip_box: Callable[[], Box | None],
        note: Callable[[str], None],
        refuse: Callable[[LispacError], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._scene, self._viewport = document, scene, viewport
        self._mouse_tool, self._clip_box = mouse_tool, clip_box
        self._actions, self._note, self._refuse = actions, note, refuse
        for tool in TOOLS:
            actions[tool].triggered.connect(lambda on, tool=tool: self._toggle_tool(tool, on))
        scene.selection_changed.connect(self._show_hint)

    def _toggle_tool(self, tool: str, on: bool) -> None:
        if not on:
            self._mouse_tool.end()
        elif not self._scene.selected_points:
            self._actions[tool].setChecked(False)
            self._note(gettext(NOTHING_SELECTED_TEXT))
        else:
            self._mouse_tool.begin(tool, "", outlined=self._edit_points, ended=lambda: None)
            self._show_hint()

    def _show_hint(self) -> None:
        tool, selected = self._mouse_tool.tool, self._scene.selected
        if tool not in TOOLS or selected is None:
            return
        if tool == "lasso_add":
            template = N_("Draw around points to add them to {sighting}")
        else:
            template = N_("Draw around points to remove them from {sighting}")
        self._mouse_tool.hint(gettext(template, sighting=_sighting_text(*selected)), "outline")

    def _edit_points(self, corners: Array) -> None:
        project, selected = self._document.project, self._scene.selected
        if project is None or selected is None or not self._scene.selected_points:
            self._note(gettext(NOTHING_SELECTED_TEXT))
            return
        name, line = selected
        tool = self._mouse_tool.tool
        edit = with_points if tool == "lasso_add" else without_points
        shown = {
            each: cloud
            for each, cloud in self._scene.clouds.items()
            if not self._viewport.is_line_hidden(each)
        }
        try:
            target, changed = edit(
                project.target(name),
                shown,
                lambda points: self._points_in_outline(points, corners),
                line,
            )
        except LispacError as error:
            self._refuse(error)
            return
        sighting = _sighting_text(name, line)
        if not changed:
            template = N_("No points of {sighting} inside the outline")
            self._note(gettext(template, sighting=sighting))
            return
        self._document.edit(
            EDIT_NAMES[tool],
            project.with_target(target),
            recompute=True,
            count=changed,
            sighting=sighting,
        )
        self._note(gettext(EDIT_NOTES[tool], count=changed, sighting=sighting))

    def _points_in_outline(self, points: Array, corners: Array) -> NDArray[np.bool_]:
        from matplotlib.path import Path

        inside = np.zeros(len(points), dtype=bool)
        pixels = self._viewport.to_pixels(points)
        is_in_front = np.isfinite(pixels).all(axis=1)
        inside[is_in_front] = Path(corners).contains_points(pixels[is_in_front])
        box = self._clip_box()
        if box is not None:
            boxed = np.zeros(len(points), dtype=bool)
            boxed[box.inside(points)] = True
            inside &= boxed
        return inside


def _sighting_text(target: str, line: str) -> str:
    return f"{target} · {line}" if line else target
