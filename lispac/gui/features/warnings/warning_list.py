"""List of warnings: collected after each change, displayed, and linked to their causes.

They are collected in a thread of their own, so that the list is up to date also while an adjustment
runs.
"""

from collections.abc import Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QScrollArea, QWidget

from lispac.gui.app.docks import raise_panel
from lispac.gui.project.status import ADJUST, DATA, STEPS, TARGETS
from lispac.gui.widgets.fields import FoldableGroup
from lispac.messages import Message
from lispac.targets.sighting_quality import SightingQuality
from lispac.warning_causes import Cause
from lispac.workflow.checking.warnings import warnings_of

if TYPE_CHECKING:
    from lispac.gui.window.main_window import MainWindow

DEBOUNCE_MS = 60
"""Several changes in a row make one list."""

CollectedWarnings = tuple[int, tuple[Message, ...]]


class WarningList(QObject):
    """Collects the warnings of the project and opens the cause of one that is clicked."""

    selected = Signal(str, str)
    """Target and line (or "") to select."""
    shown = Signal()
    """The list is up to date."""
    _collected = Signal(object)

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window, self._document = window, window.document
        self._panel, self._button = window.warnings, window.warnings_button
        self._worker = ThreadPoolExecutor(1, "lispac-warnings")
        self._qualities: Mapping[tuple[str, str], SightingQuality] = {}
        self._requested = self._shown_request = 0
        self._had_result = False
        self._debounce = QTimer(self)
        self._debounce.setSingleShot(True)
        self._debounce.setInterval(DEBOUNCE_MS)
        self._debounce.timeout.connect(self._collect_warnings)
        self._collected.connect(self._show)
        window.document.opened.connect(self._on_project_opened)
        window.document.changed.connect(self._on_project_changed)
        window.target_work.quality_computation.qualities_changed.connect(self._on_qualities_changed)
        window.recovery_copies.problem_changed.connect(self._on_project_changed)
        window.actions_["warnings"].triggered.connect(lambda _=False: self.open())
        self._button.clicked.connect(self.open)
        self._panel.cause_activated.connect(self.show_cause)
        self._on_project_changed()

    @property
    def is_current(self) -> bool:
        """Whether the list is up to date."""
        return self._requested == self._shown_request and not self._debounce.isActive()

    def open(self) -> None:
        """Bring the list to the front and give it the focus."""
        raise_panel(self._panel)
        self._panel.focus_list()

    def stop(self) -> None:
        """Stop the worker."""
        self._debounce.stop()
        self._requested += 1
        self._worker.shutdown(wait=True)

    # -- gathering -------------------------------------------------------------------------------

    def _on_qualities_changed(self, qualities: Mapping[tuple[str, str], SightingQuality]) -> None:
        self._qualities = qualities
        self._on_project_changed()

    def _on_project_opened(self) -> None:
        """Reset the flag of an earlier result when another project is opened."""
        self._had_result = False

    def _on_project_changed(self) -> None:
        if self._document.project is None:
            self._debounce.stop()
            self._requested += 1
            self._shown_request = self._requested
            self._panel.show_nothing()
            self._button.show_warnings(None)
            return
        self._had_result |= self._document.project.result is not None
        if self._document.awaits_result:
            self._panel.show_waiting()  # those from before stay until the result is there
        else:
            self._debounce.start()

    def _collect_warnings(self) -> None:
        document = self._document
        project, refusal = document.project, document.refusal
        refused_since = document.refused_since
        survey = document.survey if document.survey_is_current else None
        qualities, storage = self._qualities, self._window.recovery_copies.problem
        outdated = self._had_result
        if project is None or document.awaits_result:
            return
        self._requested += 1
        requested = self._requested

        def work() -> CollectedWarnings:
            if requested != self._requested:
                return requested, ()  # there was another change meanwhile
            found = warnings_of(
                project, survey, qualities, refusal=refusal, refused_since=refused_since,
                outdated=outdated, storage=storage,
            )  # fmt: skip
            return requested, found

        self._worker.submit(work).add_done_callback(self._emit_result)

    def _emit_result(self, future: "Future[CollectedWarnings]") -> None:
        """Pass on the result; called in the worker."""
        if (error := future.exception()) is not None:
            self._window.runner.failed.emit(error)
        else:
            self._collected.emit(future.result())

    def _show(self, collected: CollectedWarnings) -> None:
        requested, found = collected
        if requested == self._requested:
            self._shown_request = requested
            self._panel.show_warnings(found)
            self._button.show_warnings(found)
            self.shown.emit()

    # -- causes ----------------------------------------------------------------------------------

    def show_cause(self, cause: Cause) -> None:
        """Go to the cause of a warning: open, select and focus it."""
        go = {
            "line": self._go_to_line,
            "target": self._go_to_sighting,
            "sighting": self._go_to_sighting,
            "parameter": self._go_to_parameter,
            "field": self._go_to_field,
            "page": self._go_to_page,
            "step": self._go_to_step,
            "result": self._go_to_result,
        }
        go[cause.kind](cause)

    def _go_to_line(self, cause: Cause) -> None:
        data, scene = self._window.data, self._window.scene
        self._open_step(DATA)
        if data.select_line(cause.name):
            _focus_widget(data.lines)
        cloud = scene.clouds.get(cause.name)
        if cloud is not None:
            scene.focused.emit(cloud.sample[::50], cause.name)
            self._window.viewport.fit(cloud.sample)

    def _go_to_sighting(self, cause: Cause) -> None:
        project = self._document.project
        if project is None or cause.name not in {target.name for target in project.targets}:
            return
        window = self._window
        self.selected.emit(cause.name, cause.line)
        if cause.kind == "target":
            self._open_step(TARGETS)
            _focus_widget(window.targets.table)
        else:
            raise_panel(window.table)
            window.table.go_to(cause.name, cause.line)
            _focus_widget(window.table)

    def _go_to_parameter(self, cause: Cause) -> None:
        switch = self._window.adjust.parameters.switches.get(cause.name)
        if switch is None:
            self._go_to_result(cause)
        else:
            self._open_step(ADJUST)
            _focus_widget(switch)

    def _go_to_field(self, cause: Cause) -> None:
        data, adjust = self._window.data, self._window.adjust
        longest = max(data.lever_arm.fields, key=lambda field: abs(field.value()))
        step, field = {
            "lever_arm": (DATA, longest),
            "boresight_deg": (DATA, data.boresight.fields[0]),
            "pos_errors": (ADJUST, adjust.chosen_model),
            "surface": (ADJUST, adjust.model.surface),
            "position_time": (ADJUST, adjust.model.position_time),
        }[cause.name]
        self._open_step(step)
        _focus_widget(field)

    def _go_to_page(self, cause: Cause) -> None:
        diagnostics = self._window.diagnostics
        raise_panel(diagnostics)
        diagnostics.open(cause.name)
        _focus_widget(diagnostics.list)

    def _go_to_step(self, cause: Cause) -> None:
        self._window.workflow.go_to(STEPS.index(cause.name))

    def _go_to_result(self, _cause: Cause) -> None:
        raise_panel(self._window.results)
        _focus_widget(self._window.results.angles)

    def _open_step(self, step: int) -> None:
        raise_panel(self._window.workflow)
        self._window.workflow.open(step)


def _focus_widget(widget: QWidget) -> None:
    """Give a widget the focus, unfold the groups around it and scroll to it."""
    above, areas = widget.parentWidget(), []
    while above is not None:
        if isinstance(above, FoldableGroup):
            above.open()
        if isinstance(above, QScrollArea):
            areas.append(above)
        above = above.parentWidget()
    widget.setFocus(Qt.FocusReason.OtherFocusReason)
    for area in areas:
        area.ensureWidgetVisible(widget)
