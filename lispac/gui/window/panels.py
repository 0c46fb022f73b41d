"""The panels of the window."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime

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
from lispac.gui.window.workflow_panel import WorkflowPanel
from lispac.language import N_, gettext

MAX_LOG_LINES = 2000
"""Largest number of lines of the log; older ones are removed."""
EMPTY_LOG_TEXT = N_(
    "Actions, assumptions and errors of the program are listed here with their time."
)


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
    """Panels of the window except those of the tools; the first five are workflow steps."""

    data: DataPanel = field(default_factory=DataPanel)
    targets: TargetsPanel = field(default_factory=TargetsPanel)
    adjust: AdjustPanel = field(default_factory=AdjustPanel)
    validate: ValidatePanel = field(default_factory=ValidatePanel)
    report: ReportPanel = field(default_factory=ReportPanel)
    workflow: WorkflowPanel = field(init=False)
    results: ResultsPanel = field(default_factory=ResultsPanel)
    log: LogPanel = field(default_factory=LogPanel)
    warnings: WarningsPanel = field(default_factory=WarningsPanel)
    convention: ConventionPanel = field(default_factory=ConventionPanel)
    table: SightingsTable = field(default_factory=SightingsTable)
    histograms: HistogramsPanel = field(default_factory=HistogramsPanel)
    diagnostics: DiagnosticsPanel = field(default_factory=DiagnosticsPanel)

    def __post_init__(self) -> None:
        steps = (self.data, self.targets, self.adjust, self.validate, self.report)
        self.workflow = WorkflowPanel(steps)

    def docks(self, tools: Mapping[str, tuple[QWidget, Area]]) -> dict[str, tuple[QWidget, Area]]:
        """Panels by title with their sides, in the order of their tabs, including ``tools``."""
        left, right = Area.LeftDockWidgetArea, Area.RightDockWidgetArea
        below = Area.BottomDockWidgetArea
        return {
            WORKFLOW: (self.workflow, left),
            RESULTS: (self.results, right),
            CONVENTION: (self.convention, right),
            SIGHTINGS: (self.table, below),
            DIAGNOSTICS: (self.diagnostics, below),
            HISTOGRAMS: (self.histograms, below),
            **tools,
            WARNINGS: (self.warnings, below),
            LOG: (self.log, below),
        }
