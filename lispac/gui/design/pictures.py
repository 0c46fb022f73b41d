"""Figures of the scenarios, the search and the simulated surveys."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QStackedWidget, QVBoxLayout, QWidget

from lispac.design.monte_carlo import Scatter
from lispac.design.scenarios import OF_THE_THESIS, Outcome
from lispac.design.search import Step
from lispac.gui.idle_tasks import IdleTask
from lispac.gui.panels import widgets
from lispac.language import N_, LazyText, gettext

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NOTHING = N_(
    "There are no figures yet. Press F9 to predict the precision while one quantity varies, or "
    "F10 to check the prediction with simulated surveys."
)
LESS_TIME = N_("precision and time on site")
ERRORS = N_("errors of simulated surveys")
OF_THESIS = N_("{scenario} (for the wall and boards of the thesis)")


class PicturesPanel(QWidget):
    """List of figures; a new figure replaces the one of the same name."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("design_pictures")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        self.empty = widgets.label(gettext(NOTHING), "muted", wrap=True)
        self.which = widgets.Choice(
            "design_picture", [gettext(LESS_TIME)], gettext("Figure to show")
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

    def show_outcomes(self, found: Sequence[Outcome]) -> None:
        """Show one figure for each scenario."""
        from lispac.report.design_figures import scenario_figure

        names = list(dict.fromkeys(each.scenario for each in found))
        for name in names:
            own = [each for each in found if each.scenario == name]
            title = LazyText(OF_THESIS, {"scenario": LazyText(name, {})})
            title = title if name in OF_THE_THESIS else LazyText(name, {})
            self._put(name, title, lambda figure, own=own: scenario_figure(own, figure))
        self.which.setCurrentIndex(0)

    def show_front(self, front: Sequence[Step], label: str) -> None:
        """Show the precision against the time on site."""
        from lispac.report.design_figures import front_figure

        self._put(
            LESS_TIME,
            LazyText(LESS_TIME, {}),
            lambda figure: front_figure(front, label, figure),
        )
        self.which.setCurrentIndex(self.which.findData(LESS_TIME))

    def show_errors(self, found: Scatter) -> None:
        """Show the errors of simulated surveys."""
        from lispac.report.design_figures import errors_figure

        self._put(ERRORS, LazyText(ERRORS, {}), lambda figure: errors_figure(found, figure))
        self.which.setCurrentIndex(self.which.findData(ERRORS))

    def take_over(self, former: "PicturesPanel") -> None:
        """Show the figures of another panel, drawn again in the language and theme in use."""
        for key, (title, draw) in former._drawings.items():
            self._put(key, title, draw)
        self.which.setCurrentIndex(former.which.currentIndex())

    def _put(self, key: str, title: LazyText, draw: "Callable[[Figure], object]") -> None:
        from lispac.gui.panels.chart import Chart

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
