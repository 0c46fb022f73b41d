"""List of warnings, collected and displayed after each change.

They are collected in a separate thread, so that the list is also updated while an adjustment runs.
"""

from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor

from PySide6.QtCore import QObject, QTimer, Signal

from lispac.gui.app.actions import Actions
from lispac.gui.app.docks import close_panel, raise_panel
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.features.warnings.warnings_panel import WarningsButton, WarningsPanel
from lispac.gui.project.document import Document
from lispac.messages import Message
from lispac.targets.sighting_quality import SightingQuality
from lispac.workflow.checking.warnings import warnings_of

DEBOUNCE_MS = 60
"""Delay after a change, so that several changes in a row cause one update."""

CollectedWarnings = tuple[int, tuple[Message, ...], bool]
"""Number of the request, its messages, and whether all sightings were rated."""


class WarningList(QObject):
    """Collects the warnings of the project and shows them.

    Parameters
    ----------
    storage_problem : function that returns why no recovery copy is written, or None
    """

    shown = Signal(object)
    """The list is up to date; its messages."""
    _collected = Signal(object)

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        panel: WarningsPanel,
        button: WarningsButton,
        actions: Actions,
        storage_problem: Callable[[], Message | None],
    ) -> None:
        super().__init__(actions)
        self._document, self._runner = document, runner
        self._panel, self._button, self._storage_problem = panel, button, storage_problem
        self._worker = ThreadPoolExecutor(1, "lispac-warnings")
        self._qualities: Mapping[tuple[str, str], SightingQuality] = {}
        self._requested = self._shown_request = 0
        self._debounce = QTimer(self)
        self._debounce.setSingleShot(True)
        self._debounce.setInterval(DEBOUNCE_MS)
        self._debounce.timeout.connect(self._collect_warnings)
        self._collected.connect(self._show)
        document.changed.connect(self.update)
        actions.connect_slots({"warnings": self.open})
        button.clicked.connect(self._toggle)
        self.update()

    @property
    def is_current(self) -> bool:
        """Whether the list is up to date."""
        return self._requested == self._shown_request and not self._debounce.isActive()

    def open(self) -> None:
        """Bring the list to the front and give it the focus."""
        raise_panel(self._panel)
        self._panel.focus_list()

    def _toggle(self) -> None:
        if self._panel.visibleRegion().isEmpty():  # closed, or behind another panel
            self.open()
        else:
            close_panel(self._panel)

    def stop(self) -> None:
        """Stop the worker."""
        self._debounce.stop()
        self._requested += 1
        self._worker.shutdown(wait=True)

    # -- collection ------------------------------------------------------------------------------

    def set_qualities(self, qualities: Mapping[tuple[str, str], SightingQuality]) -> None:
        """Set the quality of each sighting, by target and line, and update the list."""
        self._qualities = qualities
        self.update()

    def update(self) -> None:
        """Collect the warnings again."""
        if self._document.project is None:
            self._debounce.stop()
            self._requested += 1
            self._shown_request = self._requested
            self._panel.show_nothing()
            self._button.show_warnings(None)
            self.shown.emit(())
            return
        if self._document.awaits_result:
            self._panel.show_waiting()  # the former list is kept until then
        else:
            self._debounce.start()

    def _collect_warnings(self) -> None:
        document = self._document
        project, refusal = document.project, document.refusal
        refused_since = document.refused_since
        survey = document.survey if document.is_survey_current else None
        qualities, storage = self._qualities, self._storage_problem()
        outdated = document.is_result_outdated
        targets = () if project is None else project.targets
        is_complete = len(qualities) == sum(len(target.sightings) for target in targets)
        if project is None or document.awaits_result:
            return
        self._requested += 1
        requested = self._requested

        def work() -> CollectedWarnings:
            if requested != self._requested:
                return requested, (), False  # superseded by a later change
            found = warnings_of(
                project, survey, qualities, refusal=refusal, refused_since=refused_since,
                outdated=outdated, storage=storage,
            )  # fmt: skip
            return requested, found, is_complete

        self._worker.submit(work).add_done_callback(self._emit_result)

    def _emit_result(self, future: "Future[CollectedWarnings]") -> None:
        """Emit the result from the worker thread."""
        if (error := future.exception()) is not None:
            self._runner.failed.emit(error)
        else:
            self._collected.emit(future.result())

    def _show(self, collected: CollectedWarnings) -> None:
        requested, found, is_complete = collected
        if requested == self._requested:
            self._shown_request = requested
            self._panel.show_warnings(found, is_complete=is_complete)
            self._button.show_warnings(found, is_complete=is_complete)
            self.shown.emit(found)
