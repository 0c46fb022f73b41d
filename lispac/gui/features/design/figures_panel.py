"""Figures of the scenarios, the search and the simulated surveys."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QStackedWidget, QVBoxLayout, QWidget

from lispac.design.monte_carlo import MonteCarloResult
from lispac.design.plan_search import ReductionStep
from lispac.design.scenarios import OF_THE_THESIS, ScenarioOutcome
from lispac.gui import widgets
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.language import N_, LazyText, gettext

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NO_FIGURES = N_(
    "There are no figures yet. Press F9 to predict the precision while one quantity varies, or "
    "F10 to check the prediction with simulated surveys."
)
TRADE_OFF = N_("precision and time on site")
SIMULATED_ERRORS = N_("errors of simulated surveys")
THESIS_SCENARIO = N_("{scenario} (for the wall and boards of Shahraji's thesis)")


class FiguresPanel(QWidget):
    """List of figures, in which a new figure replaces the one of the same name."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("design_pictures")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        self.empty = widgets.label(gettext(NO_FIGURES), "muted", wrap=True)
        self.which = widgets.ChoiceBox(
            "design_picture", [gettext(TRADE_OFF)], gettext("Figure to show")
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
            title = LazyText(THESIS_SCENARIO, {"scenario": LazyText(name, {})})
            title = title if name in OF_THE_THESIS else LazyText(name, {})
            self._add_figure(name, title, lambda figure, own=own: scenario_figure(own, figure))
        self.which.setCurrentIndex(0)

    def show_front(self, front: Sequence[ReductionStep], label: str) -> None:
        """Show the precision against the time on site."""
        from lispac.report.design_figures import pareto_front_figure

        self._add_figure(
            TRADE_OFF,
            LazyText(TRADE_OFF, {}),
            lambda figure: pareto_front_figure(front, label, figure),
        )
        self.which.setCurrentIndex(self.which.findData(TRADE_OFF))

    def show_errors(self, result: MonteCarloResult) -> None:
        """Show the errors of simulated surveys."""
        from lispac.report.design_figures import simulated_errors_figure

        self._add_figure(
            SIMULATED_ERRORS,
            LazyText(SIMULATED_ERRORS, {}),
            lambda figure: simulated_errors_figure(result, figure),
        )
        self.which.setCurrentIndex(self.which.findData(SIMULATED_ERRORS))

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
            draw(canvas.figure)
            canvas.draw_idle()
