"""The pages of the diagnostics; each is filled when it becomes visible."""

from collections.abc import Callable, Sequence
from html import escape

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
from lispac.gui import theme
from lispac.gui.panels import diagnostics_rows as rows
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Column, DiagnosticsTable, Row
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.project import Project

NOT_COMPUTED = N_("Not computed. Press Estimate to compute it.")
NOT_WITH_CLASSICAL = N_(
    "Not available with uncorrelated POS errors. Choose “POS errors correlated in time” in "
    "step 3 and press Estimate."
)


class Page(QWidget):
    """A page with its content, or with a text on how to obtain it."""

    title = ""
    without_result = ""
    """English text that is shown before an estimation."""

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
        """The text that is shown instead of the content; empty where there is content."""
        return self._empty.text() if self._stack.currentIndex() == 0 else ""

    def show_project(self, project: Project | None) -> None:
        """Show the result, or why there is nothing to show."""
        result = None if project is None else project.result
        if project is None or result is None:
            self._show_advice(gettext(self.without_result))
            return
        lacking = self.lacks(project, result)
        if lacking:
            self._show_advice(gettext(lacking))
            return
        self.fill(project, result)
        self._stack.setCurrentIndex(1)

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """English text on what to do where the result has nothing for this page."""
        return ""

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Show the result; each page overrides this (Qt's metaclass allows no abstract method)."""
        raise TypeError(f"{type(self).__name__} does not say how it shows a result")

    def select(self, target: str, line: str) -> None:
        """Select the row of a sighting or target."""

    def _show_advice(self, text: str) -> None:
        self._empty.setText(text)
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
            self.canvas.setAccessibleName(gettext(self.title))
            self._row.addWidget(self.canvas, 1)
        getattr(diagnostic_figures, self.draws)(result, self.canvas.figure)
        self.canvas.draw_idle()


class Convergence(FigurePage):
    """Convergence of each angle."""

    title, draws = N_("Convergence"), "convergence"
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the convergence of each angle."
    )

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """Whether there was only one iteration."""
        if len(result.path) > 1:
            return ""
        return N_("The adjustment converged in one iteration. There is nothing to plot.")


class Correlations(FigurePage):
    """Correlations between all estimated values."""

    title, draws = N_("Correlations"), "correlations"
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the correlations between all "
        "estimated values."
    )


class PosErrors(FigurePage):
    """The estimated POS error of each sighting."""

    title, draws = N_("POS error"), "pos_errors"
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the estimated POS error of each "
        "sighting with its prior standard deviation."
    )

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """Whether the model or the result has no tests of sightings."""
        return _no_reliability(result)


class Observability(FigurePage):
    """How well lines and targets determine the angles."""

    title, draws = N_("Observability"), "directions"
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see how well lines and targets "
        "determine the angles."
    )

    def __init__(self) -> None:
        super().__init__()
        self.words = widgets.label("", wrap=True, name="observability_words", rich=True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._row.setContentsMargins(8, 6, 4, 4)
        self._row.addWidget(_scrolled(self.words), 1)

    def lacks(self, project: Project, result: AdjustmentResult) -> str:
        """Whether it was not computed."""
        return "" if result.observability else NOT_COMPUTED

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Describe the directions, and draw them."""
        observability = result.observability
        assert observability is not None
        sigma = observability.eigenvalues**-0.5
        paragraphs = [
            *map(message_text, observability.remarks),
            gettext(
                "Condition number {condition:x.1}: the σ of the weakest direction is {ratio:x.1} "
                "times that of the strongest.",
                condition=observability.condition, ratio=sigma[0] / sigma[2],
            ),
        ]  # fmt: skip
        self.words.setText(
            "".join(f"<p style='margin:0 0 6px 0'>{escape(each)}</p>" for each in paragraphs)
        )
        self.draw(result)


class TablePage(Page):
    """One table."""

    name = ""
    columns: Callable[[], Sequence[Column]]
    content_of: Callable[[AdjustmentResult], list[Row]]

    def __init__(self) -> None:
        super().__init__()
        self.table = DiagnosticsTable(self.name, gettext(self.title), type(self).columns())
        layout = QVBoxLayout(self.content)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.addWidget(self.table)

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Fill the table."""
        self.table.show_rows(type(self).content_of(result))

    def select(self, target: str, line: str) -> None:
        """Select the row of a sighting."""
        self.table.select(target, line)


class Sightings(TablePage):
    """Residuals and tests of every sighting."""

    title, name = N_("Sightings"), "diagnostics_sightings_table"
    columns = staticmethod(rows.sighting_columns)
    content_of = staticmethod(rows.sighting_rows)
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the residuals and tests of each "
        "sighting."
    )


class Targets(TablePage):
    """Residuals of every target."""

    title, name = N_("Targets"), "diagnostics_targets_table"
    columns = staticmethod(rows.target_columns)
    content_of = staticmethod(rows.target_rows)
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the residuals of each target."
    )

    def select(self, target: str, line: str) -> None:
        """Select the row of a target."""
        self.table.select(target, "")


class Parameters(TablePage):
    """Every estimated value with its prior and its significance."""

    title, name = N_("Parameters"), "diagnostics_parameters_table"
    columns = staticmethod(rows.parameter_columns)
    content_of = staticmethod(rows.parameter_rows)
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see each estimated value with its "
        "prior and its significance."
    )


class Checks(Page):
    """Results from parts of the data."""

    title = N_("Cross-checks")
    without_result = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the results from subsets of "
        "the data."
    )

    def __init__(self) -> None:
        super().__init__()
        self.table = DiagnosticsTable(
            "diagnostics_checks_table", gettext(self.title), rows.check_columns()
        )
        self.spread = widgets.label("", name="cross_check_spread", rich=True)
        self.spread.setToolTip(
            gettext(
                "Formal σ compared with the spread of the results with one line or one target "
                "omitted at a time. The spread needs at least three results."
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
        """Whether there are no cross-checks."""
        if project.cross_checks is not None:
            return ""
        return N_(
            "Not cross-checked. Tick “Cross-check with subsets of the data” in step 3 and "
            "press Estimate. The cross-checks are then repeated after each change of the "
            "sightings."
        )

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Fill the table, and show the spread."""
        assert project.cross_checks is not None
        self.table.show_rows(rows.check_rows(project.cross_checks))
        self.spread.setText(rows.spread_words(project.cross_checks))


PAGES: tuple[type[Page], ...] = (
    Sightings, Targets, Convergence, Correlations, PosErrors, Observability, Checks, Parameters,
)  # fmt: skip


def _no_reliability(result: AdjustmentResult) -> str:
    if not result.model.correlated:
        return NOT_WITH_CLASSICAL
    return "" if result.reliability else NOT_COMPUTED


def _scrolled(widget: QWidget) -> QScrollArea:
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidget(widget)
    return area
