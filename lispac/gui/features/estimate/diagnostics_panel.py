"""Diagnostics of the adjustment: figures and tables, one page each."""

from PySide6.QtCore import Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QListWidget,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.features.estimate.diagnostics_pages import (
    PAGE_CLASSES,
    DiagnosticsPage,
    SightingsPage,
    TargetsPage,
)
from lispac.gui.project.status import ProjectState
from lispac.language import N_, gettext
from lispac.project import Project

TITLE = N_("Diagnostics")


class DiagnosticsPanel(QWidget):
    """A list of pages; only the visible page is filled."""

    row_activated = Signal(str, str)
    """Target and line (or "") whose points are to be shown."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumHeight(216)
        self._project: Project | None = None
        self._outdated: set[DiagnosticsPage] = set()
        self.list = QListWidget()
        self.list.setObjectName("diagnostics_list")
        self.list.setAccessibleName(gettext("Pages of the diagnostics"))
        self.list.setStyleSheet("QListWidget { border: none; } QListWidget::item { padding: 3px; }")
        self._stack = QStackedWidget()
        self.pages: dict[str, DiagnosticsPage] = {}
        for kind in PAGE_CLASSES:
            page = kind()
            self.pages[page.title] = page
            self.list.addItem(gettext(page.title))
            self._stack.addWidget(page)
            table = getattr(page, "table", None)
            if table is not None:
                table.row_activated.connect(self.row_activated)
        self.list.setFixedWidth(max(128, self.list.sizeHintForColumn(0) + 8))
        self._waiting = widgets.label(
            gettext("Estimation in progress. These values are from before the change."), "hint",
            wrap=True,
        )  # fmt: skip
        self._waiting.hide()
        right = QWidget()
        column = QVBoxLayout(right)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(self._waiting)
        column.addWidget(self._stack, 1)
        row = QHBoxLayout(self)
        row.setContentsMargins(4, 4, 0, 0)
        row.setSpacing(4)
        row.addWidget(self.list)
        row.addWidget(right, 1)
        self._outdated = set(self.pages.values())
        self.list.currentRowChanged.connect(self._show_page)
        self.list.setCurrentRow(0)

    @property
    def current(self) -> DiagnosticsPage:
        """The page in front."""
        page = self._stack.currentWidget()
        assert isinstance(page, DiagnosticsPage)
        return page

    def show_state(self, state: ProjectState) -> None:
        """Show the result of the project; while a new one is computed, disable the last one."""
        project = state.project
        had_result = self._project is not None and self._project.result is not None
        greyed = state.is_waiting and had_result
        self._waiting.setVisible(greyed)
        self._stack.setEnabled(not greyed)
        if greyed or not self._has_new_result(project):
            return
        self._project = project
        self._outdated = set(self.pages.values())
        self._fill()

    def select(self, target: str, line: str) -> None:
        """Select the rows of a sighting and of its target."""
        for page in (SightingsPage, TargetsPage):
            self.pages[page.title].select(target, line)

    def open(self, title: str) -> None:
        """Bring a page to the front."""
        self.list.setCurrentRow(list(self.pages).index(title))

    def showEvent(self, event: QShowEvent) -> None:
        """Fill the page that is now visible."""
        super().showEvent(event)
        self._fill()

    def _has_new_result(self, project: Project | None) -> bool:
        if project is None or self._project is None:
            return project is not self._project
        old = self._project
        return project.result is not old.result or project.cross_checks is not old.cross_checks

    def _show_page(self, row: int) -> None:
        self._stack.setCurrentIndex(row)
        self._fill()

    def _fill(self) -> None:
        page = self.current
        if self.isVisible() and page in self._outdated:
            self._outdated.discard(page)
            page.show_project(self._project)
