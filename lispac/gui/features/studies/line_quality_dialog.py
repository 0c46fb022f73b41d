"""Dialogue with the differences between lines: table and map."""

from PySide6.QtWidgets import QWidget

from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number_cell
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.validation.line_differences import Facing
from lispac.workflow.checking.line_quality import DifferenceStatistics, LineQuality
from lispac.workflow.output.georeferencing import BoresightChoice

STATISTIC_COLUMNS = (
    (
        N_("Median (mm)"),
        N_(
            "Median difference along the normal, positive if the second line is nearer to the "
            "vessel"
        ),
    ),
    (N_("RMSD (mm)"), N_("Root mean square of the differences")),
    (
        N_("Robust σ (mm)"),
        N_("Robust standard deviation: 1.4826 times the median absolute deviation from the median"),
    ),
    (N_("95th percentile (mm)"), N_("95th percentile of the absolute differences")),
    (N_("Maximum (mm)"), N_("Largest absolute difference")),
)
"""Titles and tips of the columns of differences, in millimetres."""
FACING_TEXTS: dict[Facing, str] = {
    "all": N_("all surfaces"),
    "level": N_("horizontal surfaces"),
    "upright": N_("vertical surfaces"),
    "sloped": N_("inclined surfaces"),
}
INTRODUCTIONS: dict[BoresightChoice, str] = {
    "prior": N_(
        "The table shows the differences between each pair of lines on flat surfaces, along the "
        "surface normal and with the prior boresight. The project is not changed."
    ),
    "estimated": N_(
        "The table shows the differences between each pair of lines on flat surfaces, along the "
        "surface normal and with the estimated boresight. The project is not changed."
    ),
}


class LineQualityDialog(StudyDialog):
    """Dialogue with a row for each pair of lines and surface orientation, and a map."""

    def __init__(self, quality: LineQuality, parent: QWidget | None = None) -> None:
        title = dialog_title(ACTIONS["line_quality"])
        table = DiagnosticsTable("line_quality_table", title, _columns())
        super().__init__(
            "line_quality", title, gettext(INTRODUCTIONS[quality.which]), table, parent
        )
        self.show_rows([_row(*row) for row in quality.rows()])
        self.message_label.setText("\n".join(map(message_text, quality.not_compared)))
        self.message_label.setVisible(bool(quality.not_compared))
        self._draw(quality)
        self.resize(900, 760)

    def _draw(self, quality: LineQuality) -> None:
        # Matplotlib is imported late, so that the window starts without it.
        from lispac.report.line_map import line_difference_map

        line_difference_map(quality.pairs, self.figure())
        self.canvas.draw_idle()
        self.canvas.setAccessibleName(gettext("Map of the differences between lines"))


def _columns() -> list[Column]:
    return [
        Column(gettext("First line"), gettext("Line whose surface normals are used"), is_text=True),
        Column(gettext("Second line"), gettext("Line compared with the first line"), is_text=True),
        Column(
            gettext("Orientation"),
            gettext(
                "Orientation of the surfaces: horizontal or vertical within 10°, inclined, or all"
            ),
            is_text=True,
        ),
        Column(gettext("Compared places"), gettext("Number of flat places observed in both lines")),
        *(Column(gettext(title), gettext(tip), base="mm") for title, tip in STATISTIC_COLUMNS),
    ]


def _row(first: str, second: str, facing: Facing, figures: DifferenceStatistics) -> Row:
    same = first == second
    names = [Cell(gettext("all lines"))] * 2 if same else [Cell(first), Cell(second)]
    sizes = (figures.rmsd, figures.robust_sigma, figures.p95, figures.largest)
    return Row(
        (
            *names, Cell(gettext(FACING_TEXTS[facing])),
            number_cell(figures.places, ",.0f"), number_cell(figures.median, "+.1f", 1000),
            *(number_cell(size, ".1f", 1000) for size in sizes),
        )
    )  # fmt: skip
