"""The panels of the window."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from datetime import datetime
from typing import Protocol, runtime_checkable

from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from lispac.gui.app.docks import HISTOGRAMS, LOG, RESULTS, SIGHTINGS, WORKFLOW, Area
from lispac.gui.features.estimate.adjust_panel import AdjustPanel
from lispac.gui.features.estimate.diagnostics_panel import TITLE as DIAGNOSTICS
from lispac.gui.features.estimate.diagnostics_panel import DiagnosticsPanel
from lispac.gui.features.estimate.results_panel import ResultsPanel
from lispac.gui.features.open_project.data_panel import DataPanel
from lispac.gui.features.pick_targets.sightings_table import SightingsTable
from lispac.gui.features.pick_targets.targets_panel import TargetsPanel
from lispac.gui.features.report.report_panel import ReportPanel
from lispac.gui.features.validate.histograms_panel import HistogramsPanel
from lispac.gui.features.validate.validate_panel import ValidatePanel
from lispac.gui.features.warnings.warnings_panel import TITLE as WARNINGS
from lispac.gui.features.warnings.warnings_panel import WarningsPanel
from lispac.gui.project.features import DockPlace, Place, WindowPlace
from lispac.gui.project.status import ProjectState
from lispac.gui.window.features import panel_records
from lispac.gui.window.workflow_panel import WorkflowPanel
from lispac.language import N_, gettext

BOTTOM_AREA = Area.BottomDockWidgetArea
MAX_LOG_LINES = 2000
"""Largest number of lines of the log; older ones are removed."""
EMPTY_LOG_TEXT = N_(
    "Actions, assumptions and errors of the program are listed here with their time."
)


@runtime_checkable
class ProjectPanel(Protocol):
    """A panel that shows the open project."""

    def show_state(self, state: ProjectState) -> None:
        """Show the project after a change."""


def _always(_state: ProjectState) -> bool:
    return True


def _has_project(state: ProjectState) -> bool:
    return state.project is not None


def _has_targets(state: ProjectState) -> bool:
    return state.project is not None and bool(state.project.targets)


def _has_result(state: ProjectState) -> bool:
    return state.project is not None and state.project.result is not None


def _has_validation(state: ProjectState) -> bool:
    return state.project is not None and bool(state.project.validation)


def _place(place: Place) -> dict[str, Place]:
    """Metadata of a field of `Panels`."""
    return {"place": place}


class LogPanel(QPlainTextEdit):
    """Log messages with their times."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("log")
        self.setAccessibleName(gettext("Log"))
        self.setReadOnly(True)
        self.setPlaceholderText(gettext(EMPTY_LOG_TEXT))
        self.setMaximumBlockCount(MAX_LOG_LINES)
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.setFrameShape(QPlainTextEdit.Shape.NoFrame)

    def copy_state_from(self, former: "LogPanel") -> None:
        """Copy the messages of the log of a former window."""
        self.setPlainText(former.toPlainText())

    def note(self, text: str) -> None:
        """Add a message with the time."""
        self.appendPlainText(f"{datetime.now():%H:%M:%S}  {text}")


@dataclass(eq=False)
class Panels:
    """Panels of the window, except those of the tools.

    The fields are the panels that `MainWindow` connects with others; those without a place are the
    steps of the workflow. The other panels are registered by their features (`FEATURES`).
    """

    data: DataPanel = field(default_factory=DataPanel)
    targets: TargetsPanel = field(default_factory=TargetsPanel)
    adjust: AdjustPanel = field(default_factory=AdjustPanel)
    validate: ValidatePanel = field(default_factory=ValidatePanel)
    report: ReportPanel = field(default_factory=ReportPanel)
    workflow: WorkflowPanel = field(
        init=False,
        metadata=_place(DockPlace(WORKFLOW, Area.LeftDockWidgetArea, _always, opens=True)),
    )
    results: ResultsPanel = field(
        default_factory=ResultsPanel,
        metadata=_place(DockPlace(RESULTS, BOTTOM_AREA, _has_result, opens=True)),
    )
    table: SightingsTable = field(
        default_factory=SightingsTable,
        metadata=_place(
            DockPlace(SIGHTINGS, BOTTOM_AREA, _has_targets, opens=True, accompanies=True)
        ),
    )
    histograms: HistogramsPanel = field(
        default_factory=HistogramsPanel,
        metadata=_place(DockPlace(HISTOGRAMS, BOTTOM_AREA, _has_validation, opens=True)),
    )
    warnings: WarningsPanel = field(
        default_factory=WarningsPanel,
        metadata=_place(DockPlace(WARNINGS, BOTTOM_AREA, _has_project)),
    )
    log: LogPanel = field(
        default_factory=LogPanel, metadata=_place(DockPlace(LOG, BOTTOM_AREA, _always))
    )
    diagnostics: DiagnosticsPanel = field(
        default_factory=DiagnosticsPanel,
        metadata=_place(WindowPlace(DIAGNOSTICS, 1280, 440, "diagnostics")),
    )

    def __post_init__(self) -> None:
        steps = (self.data, self.targets, self.adjust, self.validate, self.report)
        self.workflow = WorkflowPanel(steps)
        self._of_features = {each.name: each.create() for each in panel_records()}

    def __getitem__(self, name: str) -> QWidget:
        """Panel that a feature has registered with this name."""
        return self._of_features[name]

    def show_state(self, state: ProjectState) -> None:
        """Show the open project in all panels."""
        fixed = [getattr(self, each.name) for each in fields(self)]
        for panel in (*fixed, *self._of_features.values()):
            if isinstance(panel, ProjectPanel):
                panel.show_state(state)

    def docks(self, tools: Mapping[str, QWidget]) -> dict[str, tuple[QWidget, Area]]:
        """Panels by title with their sides, in the order of their tabs, including ``tools``."""
        docks = {
            place.title: (self._panel(name), place.area)
            for name, place in _places().items()
            if isinstance(place, DockPlace)
        }
        last = {title: docks.pop(title) for title in (WARNINGS, LOG)}
        return {**docks, **{title: (panel, BOTTOM_AREA) for title, panel in tools.items()}, **last}

    def windows(self) -> list[tuple[QWidget, WindowPlace]]:
        """Panels with a window of their own."""
        return [
            (self._panel(name), place)
            for name, place in _places().items()
            if isinstance(place, WindowPlace)
        ]

    def _panel(self, name: str) -> QWidget:
        return self._of_features[name] if name in self._of_features else getattr(self, name)


def automatic_docks() -> list[str]:
    """Titles of the docks that open by themselves."""
    return [each.title for each in _dock_places() if each.opens]


def accompanying_docks() -> list[str]:
    """Titles of the docks that open only with another dock or with a project."""
    return [each.title for each in _dock_places() if each.accompanies]


def filled_docks(state: ProjectState) -> list[str]:
    """Titles of the docks that have something to show.

    Those of the tools are not among them: in another project, they are empty until they are used.
    """
    return [each.title for each in _dock_places() if each.has_content(state)]


def _dock_places() -> list[DockPlace]:
    return [each for each in _places().values() if isinstance(each, DockPlace)]


def _places() -> dict[str, Place]:
    """Places of the panels by the names of the panels."""
    fixed = {
        each.name: each.metadata["place"] for each in fields(Panels) if "place" in each.metadata
    }
    return {**fixed, **{each.name: each.place for each in panel_records()}}
