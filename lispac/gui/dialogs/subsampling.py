"""The answer with points nearer together and farther apart (thesis table 4.3)."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from lispac.adjustment.result import ANGLES
from lispac.gui import units
from lispac.gui.dialogs.study import StudyDialog
from lispac.gui.language import say
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.workflow.subsampling import Subsampled

COLUMNS = (
    Column("Point spacing (m)", "Points of a sighting nearer together are averaged", base="m"),
    Column("Points", "That took part; averaged ones count once"),
    *(
        Column(f"{angle.capitalize()}{what} (deg)", f"{tip} of {angle}, degrees", base="°")
        for angle in ANGLES
        for what, tip in (("", "Estimated value"), (" ±", "1 sigma"))
    ),
    Column("Time (s)", "Of the adjustment, without the selection of the points"),
)


class SubsamplingDialog(StudyDialog):
    """A row for each distance."""

    def __init__(
        self, found: Sequence[Subsampled], used: float, parent: QWidget | None = None
    ) -> None:
        table = DiagnosticsTable("subsampling_table", "Subsampling study", COLUMNS)
        super().__init__(
            "subsampling", "Subsampling study",
            "The same sightings adjusted with points nearer together and farther apart. Points of "
            "one sighting share the errors of the POS: where the sigmas no longer shrink, more "
            "points only take time. The project stays as it is.",
            table, parent,
        )  # fmt: skip
        self.show_rows([_row(each, each.distance == used) for each in found])
        said = say(f"In orange: the {units.figure(used, 'm', '.2f')} m of the project's settings.")
        self.said.setText(units.signs(said, "m"))
        self.said.setVisible(any(each.distance == used for each in found))
        self.resize(860, 330)


def _row(each: Subsampled, used: bool) -> Row:
    cells = [
        number(each.distance, ".2f") if each.distance else Cell("all points", 0.0),
        number(each.points, ",.0f"),
    ]
    for angle, sigma in zip(np.degrees(each.boresight), np.degrees(each.sigma), strict=True):
        cells += [number(angle, "+.4f"), number(sigma, ".4f")]
    return Row((*cells, number(each.seconds, ".2f")), marked=used)
