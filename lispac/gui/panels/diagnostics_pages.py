"""The pages of the diagnostics; each is filled when it is shown."""

from collections.abc import Callable, Sequence
from html import escape

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QScrollArea,
    QSizePolicy,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from lispac.adjustment.result import AdjustmentResult
from lispac.gui import theme, units
from lispac.gui.language import say
from lispac.gui.panels import diagnostics_rows as rows
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Column, DiagnosticsTable, Row
from lispac.project import Project

NOTHING = "Nothing estimated yet: press Estimate in step 3, and {what} here."
THESIS = (
    "Not available with uncorrelated POS errors. Choose “Correlated in time” in step 3 and "
    "estimate."
)


class Page(QWidget):
    """Content, or a sentence that says what to do for it."""

    title = ""
    what = ""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName(f"diagnostics_{self.title.lower().replace(' ', '_').replace('-', '_')}")
        self._stack = QStackedLayout(self)
        self._empty = widgets.label("", "muted", wrap=True)
        self._empty.setMargin(14)
        self._empty.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self._stack.addWidget(self._empty)
        self.content = QWidget()
        self._stack.addWidget(self.content)

    @property
    def advice(self) -> str:
        """What the page says where it has nothing to show; empty where it has."""
        return self._empty.text() if self._stack.currentIndex() == 0 else ""

    def show_project(self, project: Project | None) -> None:
        """Show the result, or say what is lacking."""
        result = None if project is None else project.result
        if project is None or result is None:
            self._say(NOTHING.format(what=self.what))
            return
        lacking = self.lacks(project, result)
        if lacking:
            self._say(lacking)
            return
        self.fill(project, result)
        self._stack.setCurrentIndex(1)

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """What to do where the result has nothing for this page."""
        return ""

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Show the result; every page has its own way (Qt's metaclass admits no abstract one)."""
        raise TypeError(f"{type(self).__name__} does not say how it shows a result")

    def select(self, target: str, line: str) -> None:
        """Select the row about a sighting or target."""

    def _say(self, words: str) -> None:
        self._empty.setText(say(words))
        self._stack.setCurrentIndex(0)


class FigurePage(Page):
    """One figure."""

    draws = ""
    """Name of the function in `diagnostic_figures`."""

    def __init__(self) -> None:
        super().__init__()
        self.canvas: QWidget | None = None
        self._row = QHBoxLayout(self.content)
        self._row.setContentsMargins(4, 4, 4, 4)

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Draw the figure."""
        self.draw(result)

    def draw(self, result: AdjustmentResult) -> None:
        """Draw into the canvas, made on first use."""
        # Imported here, so that the start of the window does not wait for it.
        from lispac.gui.panels import diagnostic_figures
        from lispac.gui.panels.chart import Chart

        if self.canvas is None:
            self.canvas = Chart(200, 120, theme.PAPER)
            self.canvas.setObjectName(f"{self.objectName()}_canvas")
            self.canvas.setAccessibleName(say(self.title))
            self._row.addWidget(self.canvas, 1)
        getattr(diagnostic_figures, self.draws)(result, self.canvas.figure)
        self.canvas.draw_idle()


class Convergence(FigurePage):
    """How each angle came to its last value."""

    title, draws = "Convergence", "convergence"
    what = "the way of each angle to its last value appears"

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """Whether there was but one iteration."""
        return "" if len(result.path) > 1 else "The adjustment took one iteration: nothing to plot."


class Correlations(FigurePage):
    """Correlations between all estimated values."""

    title, draws = "Correlations", "correlations"
    what = "the correlations between all estimated values appear"


class PosErrors(FigurePage):
    """The estimated POS error of each sighting."""

    title, draws = "POS error", "pos_errors"
    what = "the estimated POS error of each sighting appears, against its prior sigma,"

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """Whether the mode or the estimate has no tests of sightings."""
        return _no_reliability(result)


class Observability(FigurePage):
    """How well lines and targets see the angles."""

    title, draws = "Observability", "directions"
    what = "how well lines and targets see the angles appears"

    def __init__(self) -> None:
        super().__init__()
        self.words = widgets.label("", wrap=True, name="observability_words", rich=True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._row.setContentsMargins(8, 6, 4, 4)
        self._row.addWidget(_scrolled(self.words), 1)

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """Whether it was not worked out."""
        return "" if result.observability else "Not worked out: press Estimate for it."

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Say it in words, and draw the directions."""
        seen = result.observability
        assert seen is not None
        sigma = np.degrees(seen.eigenvalues**-0.5)
        paragraphs = [
            *seen.sentences,
            f"Condition number {seen.condition:.1f}: the strongest direction is known "
            f"{sigma[0] / sigma[2]:.1f} times as well as the weakest.",
        ]
        self.words.setText(
            "".join(f"<p style='margin:0 0 6px 0'>{escape(say(p))}</p>" for p in paragraphs)
        )
        self.draw(result)


class TablePage(Page):
    """One table."""

    name = ""
    columns: Sequence[Column] = ()
    content_of: Callable[[AdjustmentResult], list[Row]]

    def __init__(self) -> None:
        super().__init__()
        self.table = DiagnosticsTable(self.name, self.title, self.columns)
        layout = QVBoxLayout(self.content)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.addWidget(self.table)

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Fill the table."""
        self.table.show_rows(type(self).content_of(result))

    def select(self, target: str, line: str) -> None:
        """Select the row about a sighting."""
        self.table.select(target, line)


class Sightings(TablePage):
    """Residuals and tests of every sighting."""

    title, name, columns = "Sightings", "diagnostics_sightings_table", rows.SIGHTINGS
    content_of = staticmethod(rows.sighting_rows)
    what = "the residuals and tests of every sighting appear"


class Targets(TablePage):
    """Residuals of every target."""

    title, name, columns = "Targets", "diagnostics_targets_table", rows.TARGETS
    content_of = staticmethod(rows.target_rows)
    what = "the residuals of every target appear"

    def select(self, target: str, line: str) -> None:
        """Select the row about a target."""
        self.table.select(target, "")


class Parameters(TablePage):
    """Every estimated value with its prior and its significance."""

    title, name, columns = "Parameters", "diagnostics_parameters_table", rows.PARAMETERS
    content_of = staticmethod(rows.parameter_rows)
    what = "every estimated value appears with its prior and its significance"


class Checks(Page):
    """What parts of the data say by themselves."""

    title = "Cross-checks"
    what = "what parts of the data say by themselves appears"

    def __init__(self) -> None:
        super().__init__()
        self.table = DiagnosticsTable("diagnostics_checks_table", self.title, rows.CHECKS)
        self.spread = widgets.label("", name="cross_check_spread", rich=True)
        self.spread.setToolTip(
            say(
                "The formal sigma, and the spread of the answers when one line, or one "
                "target, at a "
                "time is left out; it needs three parts at least that each give an answer"
            )
        )
        self.spread.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.spread.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Preferred)
        layout = QHBoxLayout(self.content)
        layout.setContentsMargins(4, 4, 8, 4)
        layout.setSpacing(12)
        layout.addWidget(self.table, 1)
        layout.addWidget(self.spread)

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """What to do where nothing was cross-checked."""
        if project.cross_checks is not None:
            return ""
        return (
            "Not cross-checked. Tick “Cross-check” in step 3 and press Estimate; after that it "
            "follows each tick in the table by itself, a moment after the angles."
        )

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Fill the table, and say the spread."""
        assert project.cross_checks is not None
        self.table.show_rows(rows.check_rows(project.cross_checks))
        self.spread.setText(
            units.signs(say(rows.spread_words(project.cross_checks)), "°", figures=False)
        )


PAGES: tuple[type[Page], ...] = (
    Sightings, Targets, Convergence, Correlations, PosErrors, Observability, Checks, Parameters,
)  # fmt: skip


def _no_reliability(result: AdjustmentResult) -> str:
    if not result.model.correlated:
        return THESIS
    return "" if result.reliability else "Not worked out: press Estimate for it."


def _scrolled(widget: QWidget) -> QScrollArea:
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidget(widget)
    return area
