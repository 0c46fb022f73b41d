"""Objects of the patch test: detected, or placed at a click, a target or the clip box."""

from collections.abc import Callable
from itertools import count

import numpy as np
from PySide6.QtCore import QObject, Signal

from lispac.errors import LispacError
from lispac.gui.app.actions import Actions
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.features.patch_test.panel import PatchTestPanel
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Array, PickedPoint
from lispac.gui.viewport.clipping import Box as ClipBox
from lispac.gui.widgets.error_box import exception_text
from lispac.language import N_, gettext
from lispac.patchtest.object_boxes import MIN_SIDE, ObjectBox, object_of_box
from lispac.progress import Progress
from lispac.workflow.calibration.patch_test import PlacedObjects, place_objects, propose_objects

CLICK_HINT = N_("Click an object that is visible in two lines, to place a box around it")
POINT_BOX_SIZE_M = (2.0, 2.0, 3.0)
"""Sides of the box about a clicked point, metres."""
TARGET_BOX_MARGIN_M = 0.5
"""Margin of the box around a target on every side, metres."""
USER_BOX_PREFIX = "H"
"""First letter of the names of objects added by the user; those detected have another letter."""


class PatchObjects(QObject):
    """Places boxes around objects in the worker and emits `objects_placed`.

    Parameters
    ----------
    clip_box : function that returns the clip box, or None if there is none
    present : function that returns the current objects, or None if there are none
    """

    objects_placed = Signal(object, str)
    """All objects, and the name of the one to show, or ""."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        controller: Controller,
        actions: Actions,
        mouse_tool: MouseTool,
        clip_box: Callable[[], ClipBox | None],
        panel: PatchTestPanel,
        present: Callable[[], PlacedObjects | None],
    ) -> None:
        super().__init__(actions)
        self._mouse_tool, self._clip_box, self._present = mouse_tool, clip_box, present
        self._document, self._runner, self._scene = document, runner, scene
        self._controller = controller
        actions["patch_point"].triggered.connect(self._toggle_tool)
        panel.propose_requested.connect(self.propose)
        panel.point_requested.connect(actions["patch_point"].trigger)
        panel.target_requested.connect(self._add_target)
        panel.box_requested.connect(self._add_clip_box)

    def propose(self) -> None:
        """Detect objects in the worker."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        task = self._runner.run(
            gettext("Detecting objects"),
            lambda progress: propose_objects(project, survey, progress=progress),
            self._replace_detected,
        )
        self._controller.cancel_on_edit(task)

    def _replace_detected(self, placed_objects: PlacedObjects) -> None:
        """Replace the objects detected earlier; boxes placed by the user are kept."""
        before = self._present()
        own = (
            []
            if before is None
            else [o.name for o in before.objects if o.name[0] == USER_BOX_PREFIX]
        )
        if before is not None and own:
            placed_objects = before.select_objects(own).joined_with(placed_objects)
        self.objects_placed.emit(placed_objects, "")

    def _toggle_tool(self, on: bool) -> None:
        if not on:
            self._mouse_tool.end()
            return
        self._mouse_tool.begin(
            "patch_point", gettext(CLICK_HINT), pointed=self._add_point, ended=lambda: None
        )

    def _add_point(self, point: PickedPoint) -> None:
        self._mouse_tool.end()
        self._add_box(ObjectBox(np.array(point.position), np.array(POINT_BOX_SIZE_M)))

    def _add_target(self) -> None:
        groups = self._scene.selected_points
        if not groups:
            self._controller.logged.emit(gettext("Select a target to place a box around it."))
            return
        points = np.concatenate(list(groups.values()))
        ahead = points.mean(axis=0) - self._vessel_position()
        self._add_box(_patch_box(ClipBox.around(points, ahead, TARGET_BOX_MARGIN_M)))

    def _add_clip_box(self) -> None:
        box = self._clip_box()
        if box is None:
            self._controller.logged.emit(
                gettext("Switch on the clip box (X) and place it around an object.")
            )
            return
        self._add_box(_patch_box(box))

    def _vessel_position(self) -> Array:
        survey = self._document.survey
        assert survey is not None
        times = np.array([line.first_time for line in survey.scans.values()])
        return np.asarray(survey.trajectory.at(times).position.mean(axis=0))

    def _add_box(self, box: ObjectBox) -> None:
        """Place a box around points of the displayed lines."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        before = self._present()
        taken = set() if before is None else {each.name for each in before.objects}
        name = next(n for k in count(1) if (n := f"{USER_BOX_PREFIX}{k}") not in taken)
        shown = next(iter(self._scene.clouds.values())).place.mounting.boresight

        def work(progress: Progress) -> PlacedObjects | str:
            try:
                found = place_objects(
                    project, survey, [object_of_box(name, box)], shown, progress=progress
                )
            except LispacError as error:
                return exception_text(error)
            if not found.sample.observed:
                return gettext(
                    "Fewer than two lines have points in the box. Place it around an object "
                    "that is visible in two lines."
                )
            return found

        def done(result: PlacedObjects | str) -> None:
            if isinstance(result, str):
                self._controller.logged.emit(result)
                return
            self.objects_placed.emit(result if before is None else before.joined_with(result), name)

        task = self._runner.run(gettext("Placing a box"), work, done)
        self._controller.cancel_on_edit(task)


def _patch_box(box: ClipBox) -> ObjectBox:
    ahead = box.axes[0]
    turn = float(np.arctan2(-ahead[1], ahead[0]))
    return ObjectBox(np.array(box.centre), np.maximum(2 * box.half, MIN_SIDE), turn)
