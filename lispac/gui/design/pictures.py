"""What long work found, in figures: one for each scenario, and what less time costs."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QStackedWidget, QVBoxLayout, QWidget

from lispac.design.monte_carlo import Scatter
from lispac.design.scenarios import OF_THE_THESIS, Outcome
from lispac.design.search import Step
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.turns import Turn

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NOTHING = (
    "Scenarios (F9) change one thing at a time: lines, inclination, size and combination of boards "
    "as the thesis does, and with this plan distance, height, repeated lines, speed and POS. "
    "Simulated surveys (F10) show whether the sigmas hold."
)
LESS_TIME = "less time on site"
ERRORS = "errors of simulated surveys"


class PicturesPanel(QWidget):
    """A list to choose a figure from; later ones take the place of those of the same name."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("design_pictures")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        self.empty = widgets.label(NOTHING, "muted", wrap=True)
        self.which = widgets.Choice("design_picture", [LESS_TIME], "Which figure is shown")
        self.which.setAccessibleName(say("Which figure is shown"))
        self.which.clear()
        self.which.hide()
        self.pages = QStackedWidget()
        layout.addWidget(self.empty)
        layout.addWidget(self.which)
        layout.addWidget(self.pages, 1)
        self._drawings: dict[str, Callable[[Figure], object]] = {}
        """Of each title."""
        self._waiting: dict[QWidget, Callable[[Figure], object]] = {}
        self._due = Turn(self._draw, self)
        self.which.currentIndexChanged.connect(self.pages.setCurrentIndex)
        self.pages.currentChanged.connect(lambda _index: self._due.start())

    def show_outcomes(self, found: Sequence[Outcome]) -> None:
        """One figure for each scenario."""
        from lispac.report.design_figures import scenario_figure

        names = list(dict.fromkeys(each.scenario for each in found))
        for name in names:
            own = [each for each in found if each.scenario == name]
            title = f"{name} (thesis's wall and boards)" if name in OF_THE_THESIS else name
            self._put(title, lambda figure, own=own: scenario_figure(own, figure, say))
        self.which.setCurrentIndex(0)

    def show_front(self, front: Sequence[Step], label: str) -> None:
        """What less time costs."""
        from lispac.report.design_figures import front_figure

        self._put(LESS_TIME, lambda figure: front_figure(front, label, figure, say))
        self.which.setCurrentIndex(self.which.findData(LESS_TIME))

    def show_errors(self, found: Scatter) -> None:
        """How the answers of simulated surveys scatter."""
        from lispac.report.design_figures import errors_figure

        self._put(ERRORS, lambda figure: errors_figure(found, figure, say))
        self.which.setCurrentIndex(self.which.findData(ERRORS))

    def take_over(self, former: "PicturesPanel") -> None:
        """Show the figures of another one, drawn anew: each in the language and looks in use."""
        for title, draw in former._drawings.items():
            self._put(title, draw)
        self.which.setCurrentIndex(former.which.currentIndex())

    def _put(self, title: str, draw: "Callable[[Figure], object]") -> None:
        from lispac.gui.panels.chart import Chart

        canvas = Chart(280, 200)
        canvas.setAccessibleName(say(f"Figure: {title}"))
        self._drawings[title] = self._waiting[canvas] = draw
        at = self.which.findData(title)
        if at >= 0:
            old = self.pages.widget(at)
            self.pages.removeWidget(old)
            self._waiting.pop(old, None)
            old.deleteLater()
            self.pages.insertWidget(at, canvas)
            self.pages.setCurrentIndex(self.which.currentIndex())
        else:
            self.pages.addWidget(canvas)
            self.which.addItem(say(title), title)
        self.empty.hide()
        self.which.show()
        self._due.start()

    def _draw(self) -> None:
        """Draw the figure that is shown, if it is not yet; all at once would hold up the window."""
        canvas = self.pages.currentWidget()
        draw = self._waiting.pop(canvas, None)
        if draw is not None:
            draw(canvas.figure)
            canvas.draw_idle()
