"""The window in which a site is designed: views, tables, what is expected, and long work."""

from collections.abc import Callable, Sequence

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import (
    QMainWindow,
    QScrollArea,
    QSplitter,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import theme
from lispac.gui.design.angles_table import AnglesTable
from lispac.gui.design.lists import LinesList, TargetsList
from lispac.gui.design.pictures import PicturesPanel
from lispac.gui.design.plan_view import PlanView
from lispac.gui.design.results import ResultsPanel
from lispac.gui.design.search import SearchPanel
from lispac.gui.design.surveys import SurveysPanel
from lispac.gui.design.system import SystemPanel
from lispac.gui.design.view3d import View3D
from lispac.gui.design.wall_view import WallView
from lispac.gui.design.workspace import Workspace
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.statusbar import TaskBar
from lispac.gui.viewport.base import Viewport
from lispac.io.plan_file import TitledPlan
from lispac.workflow.replay import Replay

COMPARE = (
    "After the survey: open its project in the main window, and this plan here, and compare (F11). "
    "Targets go by their names, lines by their headings."
)
NOTE_MS = 6000
Keys = QKeySequence.StandardKey

# name: (text, short text, icon, keys, tip)
ACTIONS: dict[str, tuple[str, str, str, object, str]] = {
    "new": ("&New plan", "New", "file-outline", Keys.New, "Begin with the thesis's plan"),
    "open": ("&Open plan…", "Open", "folder-open-outline", Keys.Open, "Open a plan"),
    "save": ("&Save plan", "Save", "content-save-outline", Keys.Save, "Save the plan"),
    "save_as": ("Save plan &as…", "Save as", "", Keys.SaveAs, "Save the plan in another file"),
    "page": ("&Field plan…", "Field plan", "file-document-outline", "Ctrl+E",
             "Write a page for the field as PDF: drawing, boards, lines in their order"),
    "close": ("&Close", "Close", "", Keys.Close, "Close this window; the plan stays"),
    "undo": ("&Undo", "Undo", "undo", Keys.Undo, "Take the last edit back"),
    "redo": ("&Redo", "Redo", "redo", ("Ctrl+Y", "Ctrl+Shift+Z"), "Make the edit again"),
    "add_line": ("Add &line", "Line", "plus", "Ctrl+L",
                 "Add the selected line the other way round"),
    "duplicate": ("&Duplicate line", "Duplicate", "content-copy", "Ctrl+D",
                  "Sail the selected line again"),
    "earlier": ("Line &earlier", "Earlier", "", "Alt+Up", "Sail the selected line a turn earlier"),
    "later": ("Line la&ter", "Later", "", "Alt+Down", "Sail the selected line a turn later"),
    "add_board": ("Add &board", "Board", "square-outline", "Ctrl+B", "Hang one more board"),
    "add_ball": ("Add b&all", "Ball", "circle-outline", "Ctrl+Shift+B", "Put up one more ball"),
    "fit": ("&Fit the 3D view", "Fit view", "fit-to-page-outline", "Ctrl+0",
            "Look at all of the site in 3D again"),
    "scenarios": ("Sc&enarios", "Scenarios", "chart-bar", "F9",
                  "Change one thing at a time, in both stochastic models"),
    "surveys": ("Simulate &surveys…", "Surveys", "dice-multiple-outline", "F10",
                "Sail this plan many times in the simulator: do the sigmas hold?"),
    "compare": ("Compare with the &open project", "Compare", "compare-horizontal", "F11",
                "Foretold and obtained sigmas of the survey in the main window"),
    "cancel": ("&Cancel the running task", "Cancel", "close-circle-outline", "Ctrl+.",
               "Stop; nothing is changed"),
    "keys": ("&Mouse and keys", "Keys", "keyboard-outline", "F1", "What mouse and keys do"),
}  # fmt: skip
MENUS = {
    "&File": ("new", "open", "", "save", "save_as", "", "page", "", "close"),
    "&Edit": (
        "undo", "redo", "", "add_line", "duplicate", "earlier", "later", "", "add_board",
        "add_ball",
    ),
    "&View": ("fit",),
    "&Work": ("scenarios", "surveys", "compare", "", "cancel"),
    "&Help": ("keys",),
}  # fmt: skip
TOOLBAR = (
    "new", "open", "save", "page", "", "undo", "redo", "", "add_line", "duplicate", "add_board",
    "add_ball", "", "scenarios",
)  # fmt: skip


class DesignWindow(QMainWindow):
    """Views of one workspace; closing it keeps the plan.

    Parameters
    ----------
    make_viewport : makes the 3D view when it is first looked at
    """

    closed = Signal()

    def __init__(
        self, workspace: Workspace, make_viewport: Callable[[], Viewport], parent: QWidget
    ) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setObjectName("design_window")
        self.workspace, self._make_viewport = workspace, make_viewport
        self.view3d: View3D | None = None
        self.actions_ = {name: self._action(name) for name in ACTIONS}
        self._build()
        workspace.changed.connect(self._show)
        workspace.refused.connect(self.note)
        for name, slot in {
            "close": self.close, "undo": workspace.undo, "redo": workspace.redo,
            "add_line": workspace.add_line, "add_board": workspace.add_target,
            "duplicate": lambda: workspace.add_line(again=True),
            "earlier": lambda: workspace.sail_line(True),
            "later": lambda: workspace.sail_line(False),
            "add_ball": lambda: workspace.add_target(ball=True), "fit": self.fit,
            "surveys": self.ask_surveys,
        }.items():  # fmt: skip
            self.actions_[name].triggered.connect(lambda _=False, slot=slot: slot())
        self._show()

    def sizeHint(self) -> QSize:
        """The size it likes best, in pixels."""
        return QSize(1480, 920)

    def _build(self) -> None:
        # From the outside in: with each new parent Qt looks up the style of all that is inside
        both = QSplitter(Qt.Orientation.Horizontal)
        self.setCentralWidget(both)
        left, above = QSplitter(Qt.Orientation.Vertical), QSplitter(Qt.Orientation.Horizontal)
        both.addWidget(left)
        left.addWidget(above)
        work = self.workspace
        self.plan_view, self.wall_view = PlanView(work), WallView(work)
        above.addWidget(_titled("From above", self.plan_view))
        self.views = _tabs("design_views")
        above.addWidget(self.views)
        above.setSizes([500, 500])
        self._stage, self.pictures = QWidget(), PicturesPanel()
        QVBoxLayout(self._stage).setContentsMargins(0, 0, 0, 0)
        _fill(self.views, (
            ("Wall from the water", self.wall_view), ("3D", self._stage),
            ("Figures", self.pictures),
        ))  # fmt: skip
        self.views.currentChanged.connect(self._view_chosen)
        self.tabs = _tabs("design_tabs")
        left.addWidget(self.tabs)
        left.setStretchFactor(0, 3)
        left.setStretchFactor(1, 2)
        left.setSizes([520, 330])
        self.lines, self.targets = LinesList(work), TargetsList(work)
        self.system, self.search = SystemPanel(work), SearchPanel(work)
        self.surveys = SurveysPanel()
        self.compared = AnglesTable("design_compared", COMPARE)
        _fill(self.tabs, (
            ("Lines", self.lines), ("Targets", self.targets), ("POS and scanner", self.system),
            ("Find the best plan", self.search), ("Simulate surveys", self.surveys),
            ("Compare", _scrolled(self.compared)),
        ))  # fmt: skip
        self.results = ResultsPanel(work)
        both.addWidget(self.results)
        both.setStretchFactor(0, 1)
        both.setSizes([1100, 360])
        for splitter in (above, left, both):
            splitter.setChildrenCollapsible(False)
        self.task_bar = TaskBar()
        self.mistake = widgets.label("", "error", name="design_mistake")
        self.task_bar.addWidget(self.mistake, 1)
        self.setStatusBar(self.task_bar)
        for table in (self.lines.table, self.targets.table):
            table.mistake.connect(lambda text: self.mistake.setText(say(text)))
        for title, names in MENUS.items():
            menu = self.menuBar().addMenu(say(title))
            for name in names:
                menu.addAction(self.actions_[name]) if name else menu.addSeparator()
        bar = self.addToolBar(say("Toolbar"))
        bar.setObjectName("design_toolbar")
        bar.setMovable(False)
        bar.setIconSize(QSize(20, 20))
        bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        for name in TOOLBAR:
            bar.addAction(self.actions_[name]) if name else bar.addSeparator()
        screen = self.screen().availableGeometry()
        self.resize(min(1480, screen.width()), min(920, screen.height() - 30))

    def _action(self, name: str) -> QAction:
        text, short, icon, keys, tip = ACTIONS[name]
        action = QAction(say(text), self)
        action.setObjectName(f"design_{name}")
        action.setIconText(say(short))
        if icon:
            action.setIcon(theme.icon(icon))
        if isinstance(keys, tuple):
            action.setShortcuts([QKeySequence(key) for key in keys])
        else:
            action.setShortcut(QKeySequence(keys))
        shown = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        action.setToolTip(f"{say(tip)} ({shown})" if shown else say(tip))
        action.setStatusTip(say(tip))
        return action

    # -- what is shown -----------------------------------------------------------------------

    def _show(self) -> None:
        history = self.workspace.history
        for name, words in (("undo", history.to_undo), ("redo", history.to_redo)):
            action = self.actions_[name]
            action.setEnabled(bool(words))
            action.setText(say(f"&{name.capitalize()} {words}".strip()))
            action.setIconText(say(name.capitalize()))
        for answer in (self.surveys.answer, self.compared):
            answer.follow(self.workspace.titled.plan)
        self.setWindowTitle(say(f"{self.workspace.titled.title}[*] – design of a site – LISPAC"))
        self.setWindowModified(history.changed)
        self.actions_["save"].setEnabled(history.changed)

    def show_busy(self, busy: bool) -> None:
        """Whether long work runs."""
        self.search.show_busy(busy)
        self.surveys.show_busy(busy)
        for name in ("scenarios", "compare"):
            self.actions_[name].setEnabled(not busy)
        self.actions_["cancel"].setEnabled(busy)

    def note(self, text: str) -> None:
        """Say something in passing."""
        self.task_bar.showMessage(say(text), NOTE_MS)

    def show_pictures(self) -> None:
        """Bring what long work found to the front, but for a drag it would take the view from."""
        if self.workspace.dragging:
            self.note("Done: the figures are beside the views")
        else:
            self.views.setCurrentWidget(self.pictures)

    def ask_surveys(self) -> None:
        """Bring what asks for simulated surveys to the front."""
        self.tabs.setCurrentWidget(self.surveys)
        self.surveys.surveys.setFocus()
        self.surveys.surveys.selectAll()

    def show_compared(self, found: Replay, project: str, titled: TitledPlan) -> None:
        """Show the survey of a project against a plan."""
        head = f"{project} against {titled.title}: 1 sigma, deg"
        self.compared.show_rows(head, found.rows, found.words, titled.plan)
        self.compared.follow(self.workspace.titled.plan)
        self.tabs.setCurrentIndex(self.tabs.count() - 1)

    def fit(self) -> None:
        """Look at all of it in 3D, which comes to the front."""
        if self.views.currentWidget() is self._stage and self.view3d is not None:
            self.view3d.fit()
        else:
            self.views.setCurrentWidget(self._stage)

    def _view_chosen(self, index: int) -> None:
        if self.views.widget(index) is not self._stage:
            return
        if self.view3d is None:
            viewport = self._make_viewport()
            viewport.widget.setMinimumSize(200, 160)
            self._stage.layout().addWidget(viewport.widget)
            self.view3d = View3D(self.workspace, viewport)
            viewport.widget.setToolTip(
                say(
                    "Ctrl+click on a target selects it, on the wall hangs the selected "
                    "one there; drag "
                    "a dot beside it to move it along the wall, up, or off it"
                )
            )
        self.view3d.show()
        self.view3d.fit()

    # -- one after the other -----------------------------------------------------------------

    def take_over(self, former: "DesignWindow") -> None:
        """Show what another window of the same plan shows, where it does and as large."""
        self.search.take_over(former.search)
        self.surveys.take_over(former.surveys)
        self.compared.take_over(former.compared)
        self.pictures.take_over(former.pictures)
        self._show()
        self.restoreGeometry(former.saveGeometry())
        # Both are made of the same parts in the same order
        for kind, take in (
            (QSplitter, lambda own, other: own.restoreState(other.saveState())),
            (QTabWidget, lambda own, other: own.setCurrentIndex(other.currentIndex())),
        ):
            for own, other in zip(self.findChildren(kind), former.findChildren(kind), strict=True):
                take(own, other)

    # -- the end -----------------------------------------------------------------------------

    def release(self) -> None:
        """Let timers and graphics go, before the program ends."""
        self.results.stop()
        if self.view3d is not None:
            self.view3d.viewport.close()
        self.close()

    def closeEvent(self, event) -> None:
        """Say that it was closed."""
        self.closed.emit()
        event.accept()


def _tabs(name: str) -> QTabWidget:
    tabs = QTabWidget()
    tabs.setObjectName(name)
    tabs.setDocumentMode(True)
    return tabs


def _fill(tabs: QTabWidget, pages: Sequence[tuple[str, QWidget]]) -> None:
    for title, page in pages:
        tabs.addTab(page, say(title))


def _scrolled(page: QWidget) -> QScrollArea:
    area = QScrollArea()
    area.setWidgetResizable(True)
    page.setContentsMargins(12, 12, 12, 12)
    area.setWidget(page)
    return area


def _titled(title: str, view: QWidget) -> QTabWidget:
    """One page with a tab of its own, so that it stands level with its neighbours."""
    tabs = _tabs(f"{view.objectName()}_tab")
    _fill(tabs, ((title, view),))
    return tabs
