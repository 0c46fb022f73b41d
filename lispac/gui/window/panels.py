"""The panels of the window."""

from dataclasses import dataclass, field

from lispac.gui.features.conventions.convention_panel import ConventionPanel
from lispac.gui.features.estimate.adjust_panel import AdjustPanel
from lispac.gui.features.estimate.diagnostics_panel import DiagnosticsPanel
from lispac.gui.features.estimate.results_panel import ResultsPanel
from lispac.gui.features.open_project.data_panel import DataPanel
from lispac.gui.features.pick_targets.sightings_table import SightingsTable
from lispac.gui.features.pick_targets.targets_panel import TargetsPanel
from lispac.gui.features.report.report_panel import ReportPanel
from lispac.gui.features.validate.histograms_panel import HistogramsPanel
from lispac.gui.features.validate.validate_panel import ValidatePanel
from lispac.gui.features.warnings.warnings_panel import WarningsPanel
from lispac.gui.window.log_panel import LogPanel
from lispac.gui.window.workflow_panel import WorkflowPanel


@dataclass(eq=False)
class Panels:
    """The panels besides those of the tools; the first five are in the panel of the workflow."""

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
