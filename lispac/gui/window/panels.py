"""The panels of the window."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from datetime import datetime
from typing import Any, Protocol, runtime_checkable

from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from lispac.gui.app.docks import HISTOGRAMS, LOG, RESULTS, SIGHTINGS, WORKFLOW, Area
from lispac.gui.features.conventions.convention_panel import TITLE as CONVENTION
from lispac.gui.features.conventions.convention_panel import ConventionPanel
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
from lispac.gui.project.status import ProjectState
from lispac.gui.window.workflow_panel import WorkflowPanel
from lispac.language import N_, gettext

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


def _dock(title: str, area: Area) -> dict[str, Any]:
    """Metadata of a field of `Panels`: English title and side of the dock.

    Docks of one side are tabs, in the order of the fields.
    """
    return {"title": title, "area": area}


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
    """Panels of the window, except those of the tools. A panel that is added here is complete.

    The fields without a dock are the panels of the workflow steps.
    """

    data: DataPanel = field(default_factory=DataPanel)
    targets: TargetsPanel = field(default_factory=TargetsPanel)
    adjust: AdjustPanel = field(default_factory=AdjustPanel)
    validate: ValidatePanel = field(default_factory=ValidatePanel)
    report: ReportPanel = field(default_factory=ReportPanel)
    workflow: WorkflowPanel = field(init=False, metadata=_dock(WORKFLOW, Area.LeftDockWidgetArea))
    results: ResultsPanel = field(
        default_factory=ResultsPanel, metadata=_dock(RESULTS, Area.RightDockWidgetArea)
    )
    convention: ConventionPanel = field(
        default_factory=ConventionPanel, metadata=_dock(CONVENTION, Area.RightDockWidgetArea)
    )
    table: SightingsTable = field(
        default_factory=SightingsTable, metadata=_dock(SIGHTINGS, Area.BottomDockWidgetArea)
    )
    diagnostics: DiagnosticsPanel = field(
        default_factory=DiagnosticsPanel, metadata=_dock(DIAGNOSTICS, Area.BottomDockWidgetArea)
    )
    histograms: HistogramsPanel = field(
        default_factory=HistogramsPanel, metadata=_dock(HISTOGRAMS, Area.BottomDockWidgetArea)
    )
    warnings: WarningsPanel = field(
        default_factory=WarningsPanel, metadata=_dock(WARNINGS, Area.BottomDockWidgetArea)
    )
    log: LogPanel = field(default_factory=LogPanel, metadata=_dock(LOG, Area.BottomDockWidgetArea))

    def __post_init__(self) -> None:
        steps = (self.data, self.targets, self.adjust, self.validate, self.report)
        self.workflow = WorkflowPanel(steps)

    def show_state(self, state: ProjectState) -> None:
        """Show the open project in all panels."""
        for each in fields(self):
            panel = getattr(self, each.name)
            if isinstance(panel, ProjectPanel):
                panel.show_state(state)

    def docks(self, tools: Mapping[str, tuple[QWidget, Area]]) -> dict[str, tuple[QWidget, Area]]:
        """Panels by title with their sides, in the order of their tabs, including ``tools``."""
        docks = {
            each.metadata["title"]: (getattr(self, each.name), each.metadata["area"])
            for each in fields(self)
            if each.metadata
        }
        last = {title: docks.pop(title) for title in (WARNINGS, LOG)}
        return {**docks, **tools, **last}
