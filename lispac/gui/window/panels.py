"""The panels of the window."""

from collections.abc import Callable, Mapping
from dataclasses import Field, dataclass, field, fields
from datetime import datetime
from typing import Any, Protocol, runtime_checkable

from PySide6.QtCore import QSize
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


Content = Callable[[ProjectState], bool]
"""Whether a panel has something to show."""


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


def _dock(
    title: str, area: Area, content: Content, *, opens: bool = False, accompanies: bool = False
) -> dict[str, Any]:
    """Metadata of a field of `Panels`: English title, side and content of the dock.

    Docks of one side are tabs, in the order of the fields. A dock with ``opens`` opens by itself
    when it has something to show; one with ``accompanies`` as well waits until another one opens.
    """
    return {
        "title": title, "area": area, "content": content, "opens": opens,
        "accompanies": accompanies,
    }  # fmt: skip


def _window(title: str, width: int, height: int, action: str) -> dict[str, Any]:
    """Metadata of a field of `Panels` with a window of its own, which an action opens.

    Parameters
    ----------
    title : English title
    width, height : first size, pixels
    action : name of the action
    """
    return {"window": title, "size": QSize(width, height), "action": action}


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
    workflow: WorkflowPanel = field(
        init=False, metadata=_dock(WORKFLOW, Area.LeftDockWidgetArea, _always, opens=True)
    )
    results: ResultsPanel = field(
        default_factory=ResultsPanel, metadata=_dock(RESULTS, BOTTOM_AREA, _has_result, opens=True)
    )
    table: SightingsTable = field(
        default_factory=SightingsTable,
        metadata=_dock(SIGHTINGS, BOTTOM_AREA, _has_targets, opens=True, accompanies=True),
    )
    histograms: HistogramsPanel = field(
        default_factory=HistogramsPanel,
        metadata=_dock(HISTOGRAMS, BOTTOM_AREA, _has_validation, opens=True),
    )
    warnings: WarningsPanel = field(
        default_factory=WarningsPanel, metadata=_dock(WARNINGS, BOTTOM_AREA, _has_project)
    )
    log: LogPanel = field(default_factory=LogPanel, metadata=_dock(LOG, BOTTOM_AREA, _always))
    diagnostics: DiagnosticsPanel = field(
        default_factory=DiagnosticsPanel, metadata=_window(DIAGNOSTICS, 1000, 620, "diagnostics")
    )
    convention: ConventionPanel = field(
        default_factory=ConventionPanel, metadata=_window(CONVENTION, 460, 720, "convention")
    )

    def __post_init__(self) -> None:
        steps = (self.data, self.targets, self.adjust, self.validate, self.report)
        self.workflow = WorkflowPanel(steps)

    def show_state(self, state: ProjectState) -> None:
        """Show the open project in all panels."""
        for each in fields(self):
            panel = getattr(self, each.name)
            if isinstance(panel, ProjectPanel):
                panel.show_state(state)

    def docks(self, tools: Mapping[str, QWidget]) -> dict[str, tuple[QWidget, Area]]:
        """Panels by title with their sides, in the order of their tabs, including ``tools``."""
        docks = {
            each.metadata["title"]: (getattr(self, each.name), each.metadata["area"])
            for each in _dock_fields()
        }
        last = {title: docks.pop(title) for title in (WARNINGS, LOG)}
        return {**docks, **{title: (panel, BOTTOM_AREA) for title, panel in tools.items()}, **last}

    def windows(self) -> dict[str, tuple[QWidget, QSize]]:
        """Panels with a window of their own by title, with the first size of the window."""
        return {
            each.metadata["window"]: (getattr(self, each.name), each.metadata["size"])
            for each in fields(self)
            if "window" in each.metadata
        }

    def opened_by_actions(self) -> dict[str, QWidget]:
        """Panels with a window of their own by the name of the action that opens it."""
        return {
            each.metadata["action"]: getattr(self, each.name)
            for each in fields(self)
            if "action" in each.metadata
        }


def automatic_docks() -> list[str]:
    """Titles of the docks that open by themselves."""
    return [each.metadata["title"] for each in _dock_fields() if each.metadata["opens"]]


def accompanying_docks() -> list[str]:
    """Titles of the docks that open only with another dock or with a project."""
    return [each.metadata["title"] for each in _dock_fields() if each.metadata["accompanies"]]


def filled_docks(state: ProjectState) -> list[str]:
    """Titles of the docks that have something to show.

    Those of the tools are not among them: in another project, they are empty until they are used.
    """
    return [each.metadata["title"] for each in _dock_fields() if each.metadata["content"](state)]


def _dock_fields() -> list[Field[Any]]:
    return [each for each in fields(Panels) if "title" in each.metadata]
