"""What the plan would give: cautions at once, sigmas in a drag, sentences and worths later."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QScrollArea, QSizePolicy, QWidget

from lispac.adjustment.result import ANGLES
from lispac.design.search import Worth
from lispac.gui import theme, units
from lispac.gui.design import told
from lispac.gui.design.following import Following, Said
from lispac.gui.design.told import Told
from lispac.gui.design.workspace import Workspace
from lispac.gui.language import leave_plan_alone, say
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row
from lispac.workflow.designing import cautions

HEADS = ("", "this plan", "thesis")
LOOKING = "Looking at this plan …"
PAIRS = ("roll–pitch", "roll–yaw", "pitch–yaw")
WORTH = (
    Column("Without", "Target or line that is left out", words=True),
    Column("Largest σ (deg)", "Largest of the three sigmas without it", base="°"),
    Column("Factor", "That many times as large as with it"),
)


class ResultsPanel(QScrollArea):
    """Sigmas beside the thesis's, correlations, sentences, points, worths."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.setObjectName("design_results")
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMinimumWidth(330)
        self._work = workspace
        self.following = Following(workspace, self)
        self._told = Told(workspace.titled.plan, None, True)
        body = QWidget()
        layout = widgets.column(body, 12)
        head = widgets.label("Expected sigmas (deg, 1 sigma)", "heading")
        head.setText(units.signs(head.text(), "°", figures=False))
        layout.addWidget(head)
        grid = QGridLayout()
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(4)
        for column, head in enumerate(HEADS):
            grid.addWidget(widgets.label(head, "muted"), 0, column, Qt.AlignmentFlag.AlignRight)
        self.sigma: dict[str, QLabel] = {}
        self.thesis: dict[str, QLabel] = {}
        for row, angle in enumerate(ANGLES, start=1):
            grid.addWidget(widgets.label(angle), row, 0)
            for column, (held, size) in enumerate(((self.sigma, 20), (self.thesis, 14)), start=1):
                shown = widgets.label("", name=f"design_{HEADS[column].split()[-1]}_{angle}")
                font = theme.tabular(shown.font(), bold=column == 1)
                font.setPixelSize(size)
                shown.setFont(font)
                # There is room for the first numbers before they come
                shown.setMinimumWidth(QFontMetrics(font).horizontalAdvance("0.0000") + 4)
                shown.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                named = say(f"Sigma of {angle}, {HEADS[column]}, degrees")
                shown.setAccessibleName(units.signs(named, "°", figures=False))
                grid.addWidget(shown, row, column, Qt.AlignmentFlag.AlignRight)
                held[angle] = shown
        grid.setColumnStretch(3, 1)
        layout.addLayout(grid)
        self.correlation = widgets.label("", "muted", wrap=True, name="design_correlation")
        self.correlation.setToolTip(
            say("Correlations; near 1 or −1 two angles are hardly told apart")
        )
        layout.addWidget(self.correlation)
        self.minutes = widgets.label("", "muted", wrap=True, name="design_minutes")
        layout.addWidget(self.minutes)
        self.cautions = widgets.label("", "warning", wrap=True, name="design_cautions")
        layout.addWidget(self.cautions)
        self.words = widgets.label("", "hint", wrap=True, name="design_words")
        self.words.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
        layout.addWidget(self.words)
        layout.addWidget(widgets.label("Points per sighting", "heading"))
        self.points = widgets.label("", name="design_points", rich=True)
        self.points.setAccessibleName(say("Points per sighting"))
        self._beside = QScrollArea()
        self._beside.setFrameShape(QFrame.Shape.NoFrame)
        self._beside.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._beside.setWidgetResizable(True)
        self._beside.setWidget(self.points)
        layout.addWidget(self._beside)
        layout.addWidget(widgets.label("What each is worth", "heading"))
        self.worth = DiagnosticsTable("design_worth", "What each target and line is worth", WORTH)
        self.worth.setMinimumHeight(170)
        layout.addWidget(self.worth, 1)
        self.setWidget(body)
        self.following.foretold.connect(self._show_sigmas)
        self.following.said.connect(self._show_said)
        self.following.weighed.connect(self._show_worths)
        self.following.late.connect(self._show_late)
        workspace.changed.connect(self._show)
        self._show()
        self.following.start()

    def _show(self) -> None:
        """What costs nothing."""
        titled = self._work.titled
        leave_plan_alone(titled.plan)
        self.minutes.setText(say(f"On site: {told.minutes(titled)}"))
        said = "\n".join(cautions(titled))
        self.cautions.setText(say(said))
        self.cautions.setVisible(bool(said))

    def _show_late(self) -> None:
        """Numbers of an earlier plan are not this plan's."""
        if self.following.behind:
            for label in self.sigma.values():
                label.setStyleSheet(f"color: {theme.MUTED};")
        if not self.following.has_said:
            self.words.setText(say(LOOKING))
        self.worth.show_rows([])

    def _show_sigmas(self, found: Told) -> None:
        """The numbers, which follow a drag."""
        self._told = found
        for angle, said in zip(ANGLES, self._told.sigmas, strict=True):
            self.sigma[angle].setText(say(said))
            self.sigma[angle].setStyleSheet(f"color: {theme.ERROR};" if self._told.refused else "")
        pairs = zip(PAIRS, self._told.correlations, strict=True)
        self.correlation.setText(say(f"Correlation: {', '.join(f'{p} {c}' for p, c in pairs)}"))
        self._show_points()

    def _show_points(self) -> None:
        found, plan = self._told.prediction, self._told.plan
        counts = {} if found is None else found.points
        lines = [course.name for course in plan.courses] if plan.targets else []
        names = [target.name for target in plan.targets]
        # More targets than lines are rare: lines run down, as in the table of lines.
        head = "".join(f"<td align='right'>&nbsp;&nbsp;<b>{name}</b></td>" for name in names)
        rows = "".join(
            f"<tr><td>{line}</td>"
            + "".join(f"<td align='right'>&nbsp;&nbsp;{_count(counts, name, line)}</td>"
                      for name in names)
            + "</tr>"
            for line in lines
        )  # fmt: skip
        self.points.setText(f"<table><tr><td></td>{head}</tr>{rows}</table>")
        size = self.points.sizeHint()
        bar = self._beside.horizontalScrollBar().sizeHint().height()
        self._beside.setFixedHeight(size.height() + bar)

    def _show_said(self, said: Said) -> None:
        refused = self._told.refused
        self.words.setProperty("role", "warning" if refused else "hint")
        self.words.style().unpolish(self.words)
        self.words.style().polish(self.words)
        self.words.setText(say("\n".join(said.sentences)))
        for angle, sigma in zip(ANGLES, said.thesis.sigmas, strict=True):
            self.thesis[angle].setText(say(sigma))

    def _show_worths(self, worths: tuple[Worth, ...]) -> None:
        known = self._told.prediction is not None and self._told.prediction.determined
        largest = float(np.degrees(self._told.prediction.sigma.max())) if known else np.nan
        rows = []
        for each in worths:
            without = float(np.degrees(each.without))
            times = without / largest if known and np.isfinite(without) else None
            cells = [
                Cell(each.name, named=True), _sigma(without),
                Cell("" if times is None else f"{times:.2f}", times),
            ]  # fmt: skip
            rows.append(Row(cells))
        self.worth.show_rows(rows)

    def stop(self) -> None:
        """Compute nothing any more."""
        self.following.stop()


def _sigma(degrees: float) -> Cell:
    if not np.isfinite(degrees):
        return Cell(told.OPEN, degrees)
    form = told.form(degrees)
    return Cell(f"{degrees:{form}}", degrees, figure=(form, 1.0))


def _count(counts, target: str, line: str) -> str:
    found = counts.get((target, line))
    return say(f"{found:,.0f}") if found is not None else told.UNKNOWN
