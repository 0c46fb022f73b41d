"""Window for survey design: views of the site, tables, predicted precision, long computations."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QMainWindow,
    QScrollArea,
    QSplitter,
    QStackedWidget,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.design.monte_carlo import MonteCarloResult
from lispac.design.plan_search import ReductionStep
from lispac.design.scenarios import THESIS_SCENARIOS, ScenarioOutcome
from lispac.gui import widgets
from lispac.gui.app.actions import Actions
from lispac.gui.app.status_bar import TaskStatusBar
from lispac.gui.app.unavailable import Unavailable, first_reason
from lispac.gui.features.design.actions import WINDOW_ACTIONS, WINDOW_MENUS
from lispac.gui.features.design.plan_tables import LinesList, TargetsList
from lispac.gui.features.design.plan_view import PlanView
from lispac.gui.features.design.prediction_panel import PredictionPanel
from lispac.gui.features.design.search import SearchPanel
from lispac.gui.features.design.surveys import AnglesTable, SurveysPanel
from lispac.gui.features.design.system import SystemPanel
from lispac.gui.features.design.view3d import View3D
from lispac.gui.features.design.wall_view import WallView
from lispac.gui.features.design.workspace import Workspace
from lispac.gui.viewport.base import Viewport
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.gui.widgets.number_input import first_input_error
from lispac.io.config.plan_file import TitledPlan
from lispac.language import N_, LazyText, degree_signs, gettext, gettext_lazy
from lispac.present.planning.design_results import PlanComparison

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NO_FIGURES_TEXT = N_(
    "There are no figures yet. Press F9 to predict the precision while one quantity varies, or "
    "F10 to check the prediction with simulated surveys."
)
TRADE_OFF_TITLE = N_("precision and time on site")
SIMULATED_ERRORS_TITLE = N_("errors of simulated surveys")
THESIS_SCENARIO_TITLE = N_("{scenario} (for the wall and boards of Shahraji's thesis)")


class FiguresPanel(QWidget):
    """List of figures, in which a new figure replaces the one of the same name."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("design_pictures")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        self.empty = widgets.label(gettext(NO_FIGURES_TEXT), "muted", wrap=True)
        self.which = widgets.ChoiceBox(
            "design_picture", [gettext(TRADE_OFF_TITLE)], gettext("Figure to show")
        )
        self.which.setAccessibleName(gettext("Figure to show"))
        self.which.clear()
        self.which.hide()
        self.pages = QStackedWidget()
        layout.addWidget(self.empty)
        layout.addWidget(self.which)
        layout.addWidget(self.pages, 1)
        self._drawings: dict[str, tuple[LazyText, Callable[[Figure], object]]] = {}
        """Title and drawing function of each figure."""
        self._waiting: dict[QWidget, Callable[[Figure], object]] = {}
        self._due = IdleTask(self._draw, self)
        self.which.currentIndexChanged.connect(self.pages.setCurrentIndex)
        self.pages.currentChanged.connect(lambda _index: self._due.start())

    def show_outcomes(self, outcomes: Sequence[ScenarioOutcome]) -> None:
        """Show one figure for each scenario."""
        from lispac.report.design_figures import scenario_figure

        names = list(dict.fromkeys(each.scenario for each in outcomes))
        for name in names:
            own = [each for each in outcomes if each.scenario == name]
            title = LazyText(THESIS_SCENARIO_TITLE, {"scenario": LazyText(name, {})})
            title = title if name in THESIS_SCENARIOS else LazyText(name, {})
            self._add_figure(name, title, lambda figure, own=own: scenario_figure(own, figure))
        self.which.setCurrentIndex(0)

    def show_front(self, front: Sequence[ReductionStep], label: str) -> None:
        """Show the precision against the time on site."""
        from lispac.report.design_figures import pareto_front_figure

        self._add_figure(
            TRADE_OFF_TITLE,
            LazyText(TRADE_OFF_TITLE, {}),
            lambda figure: pareto_front_figure(front, label, figure),
        )
        self.which.setCurrentIndex(self.which.findData(TRADE_OFF_TITLE))

    def show_errors(self, result: MonteCarloResult) -> None:
        """Show the errors of simulated surveys."""
        from lispac.report.design_figures import simulated_errors_figure

        self._add_figure(
            SIMULATED_ERRORS_TITLE,
            LazyText(SIMULATED_ERRORS_TITLE, {}),
            lambda figure: simulated_errors_figure(result, figure),
        )
        self.which.setCurrentIndex(self.which.findData(SIMULATED_ERRORS_TITLE))

    def copy_state_from(self, former: "FiguresPanel") -> None:
        """Copy the figures of another panel, redrawn in the language and theme in use."""
        for key, (title, draw) in former._drawings.items():
            self._add_figure(key, title, draw)
        self.which.setCurrentIndex(former.which.currentIndex())

    def _add_figure(self, key: str, title: LazyText, draw: "Callable[[Figure], object]") -> None:
        from lispac.gui.widgets.chart import Chart

        canvas = Chart(280, 200)
        canvas.setAccessibleName(gettext("Figure: {title}", title=title))
        self._drawings[key], self._waiting[canvas] = (title, draw), draw
        at = self.which.findData(key)
        if at >= 0:
            old = self.pages.widget(at)
            self.pages.removeWidget(old)
            self._waiting.pop(old, None)
            old.deleteLater()
            self.pages.insertWidget(at, canvas)
            self.pages.setCurrentIndex(self.which.currentIndex())
        else:
            self.pages.addWidget(canvas)
            self.which.addItem(str(title), key)
        self.empty.hide()
        self.which.show()
        self._due.start()

    def _draw(self) -> None:
        """Draw the figure that is shown; drawing all at once would block the window."""
        canvas = self.pages.currentWidget()
        draw = self._waiting.pop(canvas, None)
        if draw is not None:
            with degree_signs():
                draw(canvas.figure)
            canvas.draw_idle()


COMPARISON_HINT = N_(
    "After the survey, open the project in the main window and the survey plan in this window, "
    "then press F11 to compare them. Targets are matched by name, lines by heading."
)
NOTE_DURATION_MS = 6000


class DesignWindow(QMainWindow):
    """Window with the views of one workspace; closing it keeps the plan.

    Parameters
    ----------
    make_viewport : makes the 3D view when it is first shown
    """

    closed = Signal()

    def __init__(
        self, workspace: Workspace, make_viewport: Callable[[], Viewport], parent: QWidget
    ) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setObjectName("design_window")
        self.workspace, self._make_viewport = workspace, make_viewport
        self.view3d: View3D | None = None
        self.actions_ = Actions(self, WINDOW_ACTIONS, WINDOW_MENUS, "design")
        self._build()
        workspace.changed.connect(self._show)
        workspace.refused.connect(self.note)
        self.actions_.find_input_error = lambda: first_input_error(self)
        self.actions_.connect_slots({
            "close": self.close, "undo": self._undo, "redo": self._redo,
            "add_line": workspace.add_line, "add_board": workspace.add_target,
            "duplicate": lambda: workspace.add_line(duplicate=True),
            "earlier": lambda: workspace.move_line_in_order(True),
            "later": lambda: workspace.move_line_in_order(False),
            "add_ball": lambda: workspace.add_target(ball=True), "fit": self.fit,
            "surveys": self.open_surveys_tab,
        })  # fmt: skip
        self._show()

    def sizeHint(self) -> QSize:
        """Preferred size, in pixels."""
        return QSize(1480, 920)

    def _build(self) -> None:
        # Built from the outside in, since Qt restyles all children with each new parent
        both = QSplitter(Qt.Orientation.Horizontal)
        self.setCentralWidget(both)
        left, above = QSplitter(Qt.Orientation.Vertical), QSplitter(Qt.Orientation.Horizontal)
        both.addWidget(left)
        left.addWidget(above)
        work = self.workspace
        self.plan_view, self.wall_view = PlanView(work), WallView(work)
        above.addWidget(_single_tab(N_("Plan view"), self.plan_view))
        self.views = _tab_widget("design_views")
        above.addWidget(self.views)
        above.setSizes([500, 500])
        self._view3d_page, self.pictures = QWidget(), FiguresPanel()
        QVBoxLayout(self._view3d_page).setContentsMargins(0, 0, 0, 0)
        _add_tabs(self.views, (
            (N_("Wall, seen from the water"), self.wall_view), (N_("3D"), self._view3d_page),
            (N_("Figures"), self.pictures),
        ))  # fmt: skip
        self.views.currentChanged.connect(self._on_view_changed)
        self.tabs = _tab_widget("design_tabs")
        left.addWidget(self.tabs)
        left.setStretchFactor(0, 3)
        left.setStretchFactor(1, 2)
        left.setSizes([520, 330])
        self.lines, self.targets = LinesList(work), TargetsList(work)
        self.system, self.search = SystemPanel(work), SearchPanel(work)
        self.surveys = SurveysPanel()
        self.compared = AnglesTable("design_compared", gettext(COMPARISON_HINT))
        _add_tabs(self.tabs, (
            (N_("Lines"), self.lines), (N_("Targets"), self.targets),
            (N_("POS and scanner"), self.system), (N_("Find the best plan"), self.search),
            (N_("Simulate surveys"), self.surveys), (N_("Compare"), _scroll_area(self.compared)),
        ))  # fmt: skip
        self.results = PredictionPanel(work)
        both.addWidget(self.results)
        both.setStretchFactor(0, 1)
        both.setSizes([1100, 360])
        for splitter in (above, left, both):
            splitter.setChildrenCollapsible(False)
        self.task_bar = TaskStatusBar()
        self.error_label = widgets.label("", "error", name="design_mistake")
        self.task_bar.addWidget(self.error_label, 1)
        self.setStatusBar(self.task_bar)
        for table in (self.lines.table, self.targets.table):
            table.input_error.connect(self.error_label.setText)
        self.actions_.fill_menus()
        self.actions_.create_toolbar("design_toolbar")
        screen = self.screen().availableGeometry()
        self.resize(min(1480, screen.width()), min(920, screen.height() - 30))

    # -- display -----------------------------------------------------------------------------

    def _show(self) -> None:
        history = self.workspace.history
        for name, title, edit, missing in (
            ("undo", N_("&Undo: {edit}"), history.undo_name, Unavailable.NO_EDIT),
            ("redo", N_("&Redo: {edit}"), history.redo_name, Unavailable.NOTHING_UNDONE),
        ):
            action, record = self.actions_[name], WINDOW_ACTIONS[name]
            self.actions_.set_reason(name, first_reason((edit is None, missing)))
            action.setText(gettext(record.text) if edit is None else gettext(title, edit=str(edit)))
            action.setIconText(gettext(record.short))
        for table in (self.surveys.result_table, self.compared):
            table.set_current_plan(self.workspace.titled.plan)
        design = gettext("Survey design")
        self.setWindowTitle(f"{self.workspace.titled.title}[*] – {design} – LISPAC")
        self.setWindowModified(history.is_modified)
        self.actions_.set_reason("save", first_reason((not history.is_modified, Unavailable.SAVED)))

    def show_busy(self, busy: bool) -> None:
        """Enable or disable the controls while a task runs."""
        self.search.show_busy(busy)
        self.surveys.show_busy(busy)
        for name in ("scenarios", "compare"):
            self.actions_.set_reason(name, first_reason((busy, Unavailable.BUSY)))
        self.actions_.set_reason("cancel", first_reason((not busy, Unavailable.NO_TASK)))

    def note(self, text: str) -> None:
        """Show a text in the status bar for some seconds."""
        self.task_bar.showMessage(text, NOTE_DURATION_MS)

    def _undo(self) -> None:
        edit = self.workspace.history.undo_name
        self.workspace.undo()
        self.note(gettext("Undone: {edit}", edit=str(edit)))

    def _redo(self) -> None:
        edit = self.workspace.history.redo_name
        self.workspace.redo()
        self.note(gettext("Redone: {edit}", edit=str(edit)))

    def show_figures(self) -> None:
        """Bring the tab of the figures to the front, unless something is being dragged."""
        if self.workspace.is_dragging:
            self.note(gettext("The figures are ready. Open the tab Figures to see them."))
        else:
            self.views.setCurrentWidget(self.pictures)

    def open_surveys_tab(self) -> None:
        """Bring the tab of the simulated surveys to the front."""
        self.tabs.setCurrentWidget(self.surveys)
        self.surveys.surveys.setFocus()
        self.surveys.surveys.selectAll()

    def show_comparison(self, comparison: PlanComparison, project: str, titled: TitledPlan) -> None:
        """Show the comparison of a plan with the survey of a project."""
        head = gettext_lazy(
            "Standard deviations (°) of the project {project} compared with the survey plan "
            "{plan}",
            project=project, plan=titled.title,
        )  # fmt: skip
        self.compared.show_result(head, comparison, titled.plan)
        self.compared.set_current_plan(self.workspace.titled.plan)
        self.tabs.setCurrentIndex(self.tabs.count() - 1)

    def fit(self) -> None:
        """Bring the 3D view to the front and the whole site into view."""
        if self.views.currentWidget() is self._view3d_page and self.view3d is not None:
            self.view3d.fit()
        else:
            self.views.setCurrentWidget(self._view3d_page)

    def _on_view_changed(self, index: int) -> None:
        if self.views.widget(index) is not self._view3d_page:
            return
        if self.view3d is None:
            viewport = self._make_viewport()
            viewport.widget.setMinimumSize(200, 160)
            self._view3d_page.layout().addWidget(viewport.widget)
            self.view3d = View3D(self.workspace, viewport)
            viewport.widget.setToolTip(
                gettext(
                    "Ctrl+click a target to select it. To move the selected target, Ctrl+click "
                    "the wall or drag a handle of the target."
                )
            )
        self.view3d.show()
        self.view3d.fit()

    # -- replacement -------------------------------------------------------------------------

    def copy_state_from(self, former: "DesignWindow") -> None:
        """Copy results, size, splitters and selected tabs of another window of the same plan."""
        self.search.copy_state_from(former.search)
        self.surveys.copy_state_from(former.surveys)
        self.compared.copy_state_from(former.compared)
        self.pictures.copy_state_from(former.pictures)
        self._show()
        self.restoreGeometry(former.saveGeometry())
        # Both windows have the same splitters in the same order
        for kind, copy_state in (
            (QSplitter, lambda own, other: own.restoreState(other.saveState())),
            (QTabWidget, lambda own, other: own.setCurrentIndex(other.currentIndex())),
        ):
            for own, other in zip(self.findChildren(kind), former.findChildren(kind), strict=True):
                copy_state(own, other)

    # -- closing -----------------------------------------------------------------------------

    def release(self) -> None:
        """Stop timers and release the graphics before the program ends."""
        self.results.stop()
        if self.view3d is not None:
            self.view3d.viewport.close()
        self.close()

    def closeEvent(self, event) -> None:
        """Emit `closed`."""
        self.closed.emit()
        event.accept()


def _tab_widget(name: str) -> QTabWidget:
    tabs = QTabWidget()
    tabs.setObjectName(name)
    tabs.setDocumentMode(True)
    return tabs


def _add_tabs(tabs: QTabWidget, pages: Sequence[tuple[str, QWidget]]) -> None:
    for title, page in pages:
        tabs.addTab(page, gettext(title))


def _scroll_area(page: QWidget) -> QScrollArea:
    area = QScrollArea()
    area.setWidgetResizable(True)
    page.setContentsMargins(12, 12, 12, 12)
    area.setWidget(page)
    return area


def _single_tab(title: str, view: QWidget) -> QTabWidget:
    """Tab widget with one page, so that it is aligned with its neighbours."""
    tabs = _tab_widget(f"{view.objectName()}_tab")
    _add_tabs(tabs, ((title, view),))
    return tabs
