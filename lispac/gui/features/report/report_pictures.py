"""Pictures of the view for the report, before and after, taken without blocking the window."""

from collections.abc import Callable
from contextlib import ExitStack

from PySide6.QtCore import QObject
from PySide6.QtGui import QImage

from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance import units
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import PriorOrEstimated, Scene
from lispac.gui.viewport.base import Viewport
from lispac.language import N_, gettext
from lispac.project import Project

CAPTIONS: dict[PriorOrEstimated, str] = {
    "prior": N_("Lines georeferenced with the prior boresight"),
    "estimated": N_("Lines georeferenced with the estimated boresight"),
}
"""English captions, which the report translates into its own language."""


class ReportPictures(QObject):
    """Takes pictures of the lines before and after with one camera and one colour scale."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        scene: Scene,
        viewport: Viewport,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._runner, self._controller = document, runner, controller
        self._scene, self._viewport = scene, viewport
        self._restoration = ExitStack()
        for ended in (runner.stopped, runner.idle):
            ended.connect(self._restore_view)

    def capture(self, project: Project, then: Callable[[dict[str, QImage]], None]) -> None:
        """Take both pictures and call ``then`` with them, by caption.

        The lines must already be georeferenced with both boresights. Showing the lines, loading the
        detail and taking the picture are separate steps of the event loop, so that the window stays
        responsive. An edit of the project or a cancellation ends the process.
        """
        pictures: dict[str, QImage] = {}

        def prepare(which: PriorOrEstimated) -> None:
            self._show_lines(which)  # the user may have switched
            self._scene.draw_due()
            self._viewport.prepare()

        def capture(which: PriorOrEstimated) -> None:
            prepare(which)  # no effect if nothing has changed
            with units.standard_units():
                pictures[CAPTIONS[which]] = self._viewport.picture()

        steps: list[tuple[Callable[[PriorOrEstimated], None], PriorOrEstimated]] = [
            (act, which) for which in CAPTIONS for act in (self._show_lines, prepare, capture)
        ]

        def step(_nothing: None) -> None:
            act, which = steps.pop(0)
            act(which)
            if self._document.project is not project:
                self._restore_view()
            elif steps:
                self._run_step(step)
            else:
                self._restore_view()
                then(pictures)

        self._restoration.enter_context(self._scene.common_residual_scale())
        self._run_step(step)

    def _run_step(self, step: Callable[[None], None]) -> None:
        task = self._runner.run(
            gettext("Taking pictures of the view"), lambda _progress: None, step
        )
        self._controller.cancel_on_edit(task)

    def _show_lines(self, which: PriorOrEstimated) -> None:
        with units.standard_units():
            self._scene.show(which)

    def _restore_view(self) -> None:
        """Restore the view as it was before."""
        self._restoration.close()
