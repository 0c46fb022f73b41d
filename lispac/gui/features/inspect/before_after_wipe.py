"""Split view of the lines before and after, with a divider that is dragged."""

from collections.abc import Callable

from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.project.computations import Computations
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Viewport
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.language import gettext


class BeforeAfterWipe(QObject):
    """Split view, which ends when it is chosen again or another choice of lines is made."""

    def __init__(
        self,
        document: Document,
        scene: Scene,
        computing: Computations,
        viewport: Viewport,
        actions: Actions,
        note: Callable[[str], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._scene, self._computations = document, scene, computing
        self._viewport, self._note = viewport, note
        self._action = actions["wipe"]
        self._single = {"prior": actions["before"], "estimated": actions["after"]}
        self._is_on = False
        self._action.triggered.connect(self._toggle_tool)
        for action in (*self._single.values(), actions["two_views"], actions["four_views"]):
            action.triggered.connect(self._stop_wipe)
        self._due = IdleTask(self._show_wipe, self)
        scene.drawn.connect(self._due.start)
        scene.targets_drawn.connect(self._due.start)
        document.opened.connect(self._stop_wipe)

    def _toggle_tool(self) -> None:
        project = self._document.project
        if self._is_on:
            self._stop_wipe()
        elif project is None or project.result is None:
            self._stop_wipe()
            self._note(
                gettext("Estimate the boresight first, to compare the lines before and after.")
            )
        else:
            self._is_on = True
            if self._scene.which == "estimated":
                self._show_wipe()
            else:
                self._computations.show("estimated")

    def _show_wipe(self) -> None:
        survey = self._document.survey
        if not self._is_on or self._scene.awaits_lines:  # `drawn` follows
            return
        if self._scene.which == "prior" or survey is None:
            self._stop_wipe()
            return
        self._action.setChecked(True)
        samples = {name: cloud.sample for name, cloud in survey.clouds.items()}
        self._viewport.show_wipe(samples, self._scene.highlights("prior"))

    def _stop_wipe(self) -> None:
        self._is_on = False
        if self._action.isChecked():
            self._single[self._scene.which].setChecked(True)
        self._viewport.show_wipe(None)
