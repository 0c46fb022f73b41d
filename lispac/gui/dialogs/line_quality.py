"""How well the lines fit each other, as they are placed: a table and the map."""

from PySide6.QtWidgets import QWidget

from lispac.gui.dialogs.study import StudyDialog
from lispac.gui.language import say
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.workflow.line_quality import Figures, LineQuality

COLUMNS = (
    Column("First", "The line whose normals are taken", words=True),
    Column("Second", "The line that is compared with it", words=True),
    Column("Facing", "Level: within 10 deg of the horizontal; upright: of the vertical",
           words=True),
    Column("Places", "Flat places that both lines saw"),
    Column("Median (mm)", "Along the normal, positive where the second is nearer to the vessel",
           base="mm"),
    Column("RMSD (mm)", "Root mean square of the differences", base="mm"),
    Column("Robust (mm)", "1.4826 times the median absolute deviation from the median", base="mm"),
    Column("95 % (mm)", "Of the differences without their signs", base="mm"),
    Column("Largest (mm)", "Of the differences without their signs", base="mm"),
)  # fmt: skip
BY = {
    "prior": "the prior boresight",
    "estimated": "the estimated boresight",
}


class LineQualityDialog(StudyDialog):
    """A row for each two lines and way of facing; below it all places from above."""

    def __init__(self, found: LineQuality, parent: QWidget | None = None) -> None:
        table = DiagnosticsTable("line_quality_table", "Differences between lines", COLUMNS)
        super().__init__(
            "line_quality", "Differences between lines",
            "How far every two lines are apart where the scene is flat, measured along the normal, "
            f"with the lines placed by {BY[found.which]}. Nothing is changed by it.",
            table, parent,
        )  # fmt: skip
        self.show_rows([_row(*row) for row in found.rows()])
        self.said.setText("\n".join(say(reason) for reason in found.not_compared))
        self.said.setVisible(bool(found.not_compared))
        self._draw(found)
        self.resize(900, 760)

    def _draw(self, found: LineQuality) -> None:
        # Imported here, so that the start of the window does not wait for Matplotlib.
        from lispac.report.line_map import line_map

        line_map(found.pairs, self.figure(), say)
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(say("Places where lines are apart, from above"))


def _row(first: str, second: str, facing: str, figures: Figures) -> Row:
    named = first != second  # else all of them together
    sizes = (figures.rmsd, figures.robust_sigma, figures.p95, figures.largest)
    return Row(
        (
            Cell(first, named=named), Cell(second, named=named), Cell(facing),
            number(figures.places, ",.0f"), number(figures.median, "+.1f", 1000),
            *(number(size, ".1f", 1000) for size in sizes),
        )
    )  # fmt: skip
