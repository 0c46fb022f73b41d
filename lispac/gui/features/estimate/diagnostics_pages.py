"""Pages of the diagnostics; each is filled when it becomes visible."""

from html import escape
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QBoxLayout,
    QFrame,
    QHBoxLayout,
    QScrollArea,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from lispac.adjustment.result import AdjustmentResult
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable, Row
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import N_, gettext
from lispac.present.calibration.cross_checks import (
    WINDOW_SUBSETS_TABLE,
    cross_check_values,
    subset_rows,
)
from lispac.present.calibration.parameters import (
    WINDOW_PARAMETERS_TABLE,
    angle_parameters,
    parameter_values,
)
from lispac.present.tables import Table
from lispac.present.targets.sightings import (
    POS_ERROR_CAPTION,
    SIGHTINGS_TABLE,
    UNDETERMINED_POS_ERRORS_TEXT,
    has_undetermined_pos_errors,
    sighting_values,
)
from lispac.present.targets.targets import TARGETS_TABLE, target_values
from lispac.project import Project

ROW_HINT = N_("Double-click or press Enter to show the points of this row in the view")
NOT_COMPUTED_ADVICE = N_("Not computed. Press Estimate to compute it.")
UNCORRELATED_ERRORS_ADVICE = N_(
    "Not available with uncorrelated POS errors. Choose “POS errors correlated in time” in "
    "step 3 and press Estimate."
)


class DiagnosticsPage(QWidget):
    """Page that shows its content, or advice on how to obtain it."""

    title = ""
    empty_text = ""
    """English text that is shown before an adjustment."""

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
        """Text shown instead of the content; empty if there is content."""
        return self._empty.text() if self._stack.currentIndex() == 0 else ""

    def show_project(self, project: Project | None) -> None:
        """Show the result, or advice if there is nothing to show."""
        result = None if project is None else project.result
        if project is None or result is None:
            self._show_advice(gettext(self.empty_text))
            return
        advice = self.empty_page_advice(project, result)
        if advice:
            self._show_advice(gettext(advice))
            return
        self.fill(project, result)
        self._stack.setCurrentIndex(1)

    def empty_page_advice(self, project: Project, result: AdjustmentResult) -> str:
        """Advice, in English, for a page without content; empty if the result has content."""
        return ""

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Show the result; each page overrides this (Qt's metaclass allows no abstract method)."""
        raise TypeError(f"{type(self).__name__} does not say how it shows a result")

    def select(self, target: str, line: str) -> None:
        """Select the row of a sighting or target."""

    def _show_advice(self, text: str) -> None:
        self._empty.setText(text)
        self._stack.setCurrentIndex(0)


class FigurePage(DiagnosticsPage):
    """Page with one figure."""

    draw_function = ""
    """Name of the function in `diagnostic_figures`."""
    is_of_report = False
    """Whether the figure is that of the report, for white paper."""

    def __init__(self) -> None:
        super().__init__()
        self.canvas: QWidget | None = None
        self._row = QHBoxLayout(self.content)
        self._row.setContentsMargins(4, 4, 4, 4)

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Draw the figure."""
        self.draw(result)

    def draw(self, result: AdjustmentResult) -> None:
        """Draw into the canvas, which is created on first use."""
        # Imported here, so that the start of the window does not wait for it.
        from lispac.gui.features.estimate import diagnostic_figures
        from lispac.gui.widgets.chart import WHITE, Chart

        if self.canvas is None:
            self.canvas = Chart(200, 120, WHITE if self.is_of_report else theme.PAPER)
            self.canvas.setObjectName(f"{self.objectName()}_canvas")
            self.canvas.setAccessibleName(gettext(self.title))
            shown = _scroll_area(self.canvas) if self.is_of_report else self.canvas
            self._row.addWidget(shown, 1)
        getattr(diagnostic_figures, self.draw_function)(result, self.canvas.figure)
        self.canvas.draw_idle()


class ConvergencePage(FigurePage):
    """Page with the convergence of each angle."""

    title, draw_function = N_("Convergence"), "draw_convergence"
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the convergence of each angle."
    )

    def empty_page_advice(self, project: Project, result: AdjustmentResult) -> str:
        """Advice if there was only one iteration."""
        if len(result.path) > 1:
            return ""
        return N_("The adjustment converged in one iteration. There is nothing to plot.")


class CorrelationsPage(FigurePage):
    """Page with the correlations of all estimated values."""

    title, draw_function, is_of_report = N_("Correlations"), "draw_correlations", True
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the correlations between all "
        "estimated values."
    )


class PosErrorsPage(FigurePage):
    """Page with the estimated POS error of each sighting."""

    title, draw_function, is_of_report = N_("POS error"), "draw_pos_errors", True
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the estimated POS error of each "
        "sighting with its prior standard deviation."
    )

    def __init__(self) -> None:
        super().__init__()
        self._row.setDirection(QBoxLayout.Direction.TopToBottom)
        self._row.addWidget(widgets.label(gettext(POS_ERROR_CAPTION), "muted", wrap=True))
        self.undetermined = widgets.label(
            gettext(UNDETERMINED_POS_ERRORS_TEXT),
            "muted",
            wrap=True,
            name="undetermined_pos_errors",
        )
        self._row.addWidget(self.undetermined)

    def empty_page_advice(self, project: Project, result: AdjustmentResult) -> str:
        """Advice if no POS error of a sighting was estimated."""
        return _reliability_advice(result)

    def draw(self, result: AdjustmentResult) -> None:
        """Draw into a canvas that is high enough for the names of all sightings."""
        from lispac.report.figures import pos_errors_height

        super().draw(result)
        assert self.canvas is not None
        drawn = [each for each in sighting_values(result) if each.pos_error is not None]
        self.undetermined.setVisible(has_undetermined_pos_errors(drawn))
        height = pos_errors_height(len(result.reliability)) * self.canvas.figure.dpi
        self.canvas.setMinimumHeight(round(height / self.canvas.devicePixelRatioF()))


class ObservabilityPage(FigurePage):
    """Page on how well lines and targets determine the angles."""

    title, draw_function = N_("Observability"), "draw_directions"
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see how well lines and targets "
        "determine the angles."
    )

    def __init__(self) -> None:
        super().__init__()
        self.text_label = widgets.label("", wrap=True, name="observability_text", rich=True)
        self.text_label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.text_label.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._row.setContentsMargins(8, 6, 4, 4)
        self._row.addWidget(_scroll_area(self.text_label), 1)

    def empty_page_advice(self, project: Project, result: AdjustmentResult) -> str:
        """Advice if the observability was not computed."""
        return "" if result.observability else NOT_COMPUTED_ADVICE

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Describe the directions, and draw them."""
        observability = result.observability
        assert observability is not None
        sigma = observability.eigenvalues**-0.5
        paragraphs = [
            *map(message_text, observability.messages),
            gettext(
                "Condition number {condition:x.1}: the σ of the weakest direction is {ratio:x.1} "
                "times that of the strongest.",
                condition=observability.condition, ratio=sigma[0] / sigma[2],
            ),
        ]  # fmt: skip
        self.text_label.setText(
            "".join(f"<p style='margin:0 0 6px 0'>{escape(each)}</p>" for each in paragraphs)
        )
        self.draw(result)


class TablePage(DiagnosticsPage):
    """Page with one table."""

    name, explanation = "", ""
    """Object name of the table, and English text above it."""
    results: Table[Any]

    def __init__(self) -> None:
        super().__init__()
        self.table = DiagnosticsTable(self.name, gettext(self.title), window_columns(self.results))
        layout = QVBoxLayout(self.content)
        layout.setContentsMargins(4, 4, 4, 4)
        self.explanation_label = widgets.label(
            gettext(self.explanation), "muted", wrap=True, name=f"{self.name}_explanation"
        )
        layout.addWidget(self.explanation_label)
        if not self.explanation:
            self.explanation_label.hide()
        layout.addWidget(self.table)

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Fill the table."""
        self.table.show_rows(self.rows_of(result))

    def rows_of(self, result: AdjustmentResult) -> list[Row]:
        """Rows of the table; each page overrides this."""
        raise TypeError(f"{type(self).__name__} has no rows")

    def select(self, target: str, line: str) -> None:
        """Select the row of a sighting."""
        self.table.select(target, line)


class SightingsPage(TablePage):
    """Page with residuals and tests of every sighting."""

    title, name = N_("Sightings"), "diagnostics_sightings_table"
    results = SIGHTINGS_TABLE
    explanation = N_(
        "RMS contains the POS error of the line; Shift is without the estimated POS error. A "
        "sighting can therefore have a large RMS and agree with the others."
    )
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the residuals and tests of each "
        "sighting."
    )

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Fill the table; the explanation applies only to correlated POS errors."""
        super().fill(project, result)
        self.explanation_label.setVisible(
            any(s.shift_m is not None for s in sighting_values(result))
        )

    def rows_of(self, result: AdjustmentResult) -> list[Row]:
        """A row for each sighting."""
        return window_rows(
            self.results, sighting_values(result), key=lambda row: (row.target, row.line),
            marked=lambda row: row.is_marked, tip=lambda row: gettext(ROW_HINT),
        )  # fmt: skip


class TargetsPage(TablePage):
    """Page with residuals of every target."""

    title, name = N_("Targets"), "diagnostics_targets_table"
    results = TARGETS_TABLE
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the residuals of each target."
    )

    def rows_of(self, result: AdjustmentResult) -> list[Row]:
        """A row for each target."""
        return window_rows(
            self.results, target_values(result), key=lambda row: (row.target, ""),
            marked=lambda row: bool(row.rejected_lines), tip=lambda row: gettext(ROW_HINT),
        )  # fmt: skip

    def select(self, target: str, line: str) -> None:
        """Select the row of a target."""
        self.table.select(target, "")


class ParametersPage(TablePage):
    """Page with every estimated value, its prior and its significance."""

    title, name = N_("Parameters"), "diagnostics_parameters_table"
    results = WINDOW_PARAMETERS_TABLE
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see each estimated value with its "
        "prior and its significance."
    )

    def rows_of(self, result: AdjustmentResult) -> list[Row]:
        """A row for each angle and for each other parameter."""
        return window_rows(
            self.results, [*angle_parameters(result), *parameter_values(result)],
            marked=lambda row: row.value is None,
            tip=lambda row: message_text(row.reason) if row.reason else "",
        )  # fmt: skip


class CrossChecksPage(TablePage):
    """Page with the results from subsets of the data."""

    title, name = N_("Cross-checks"), "diagnostics_checks_table"
    results = WINDOW_SUBSETS_TABLE
    empty_text = N_(
        "Nothing estimated yet. Press Estimate in step 3 to see the results from subsets of "
        "the data."
    )

    def empty_page_advice(self, project: Project, result: AdjustmentResult) -> str:
        """Advice if there are no cross-checks."""
        if project.cross_checks is not None:
            return ""
        return N_(
            "Not cross-checked. Tick “Cross-check with subsets of the data” in step 3 and "
            "press Estimate. The cross-checks are then repeated after each change of the "
            "sightings."
        )

    def fill(self, project: Project, result: AdjustmentResult) -> None:
        """Fill the table."""
        assert project.cross_checks is not None
        checks = cross_check_values(project.cross_checks)
        self.table.show_rows(
            window_rows(
                self.results, subset_rows(checks), marked=lambda row: row.subset.disagrees,
                tip=lambda row: message_text(row.subset.reason) if row.subset.reason else "",
            )
        )  # fmt: skip


PAGE_CLASSES: tuple[type[DiagnosticsPage], ...] = (
    SightingsPage,
    TargetsPage,
    ConvergencePage,
    CorrelationsPage,
    PosErrorsPage,
    ObservabilityPage,
    CrossChecksPage,
    ParametersPage,
)


def _reliability_advice(result: AdjustmentResult) -> str:
    if not result.model.correlated:
        return UNCORRELATED_ERRORS_ADVICE
    return "" if result.reliability else NOT_COMPUTED_ADVICE


def _scroll_area(widget: QWidget) -> QScrollArea:
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidget(widget)
    return area
