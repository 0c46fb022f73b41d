"""Dialogue with the boresight at several point spacings (thesis table 4.3)."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from lispac.gui import units
from lispac.gui.dialogs.study import StudyDialog, angle_columns
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.language import gettext
from lispac.workflow.subsampling import Subsampled


class SubsamplingDialog(StudyDialog):
    """A row for each point spacing."""

    def __init__(
        self, found: Sequence[Subsampled], used: float, parent: QWidget | None = None
    ) -> None:
        title = gettext("Subsampling study")
        table = DiagnosticsTable("subsampling_table", title, _columns())
        super().__init__(
            "subsampling", title,
            gettext(
                "The same sightings adjusted with different point spacings. Points of a sighting "
                "share the POS errors: where the standard deviations no longer decrease, more "
                "points only take time. The project is not changed."
            ),
            table, parent,
        )  # fmt: skip
        self.show_rows([_row(each, each.distance == used) for each in found])
        self.said.setText(
            gettext(
                "Highlighted: point spacing of the project settings, {spacing} {unit}.",
                spacing=units.localised(units.figure(used, "m", ".2f")),
                unit=units.unit("m").sign,
            )
        )
        self.said.setVisible(any(each.distance == used for each in found))
        self.resize(860, 330)


def _columns() -> list[Column]:
    return [
        Column(
            gettext("Point spacing (m)"),
            gettext("Points of a sighting that are closer than this are averaged"),
            base="m",
        ),
        Column(gettext("Points"), gettext("Points used; averaged points count once")),
        *angle_columns(),
        Column(
            gettext("Time (s)"),
            gettext("Duration of the adjustment, without the selection of points"),
        ),
    ]


def _row(each: Subsampled, used: bool) -> Row:
    cells = [
        number(each.distance, ".2f") if each.distance else Cell(gettext("all points"), 0.0),
        number(each.points, ",.0f"),
    ]
    for angle, sigma in zip(np.degrees(each.boresight), np.degrees(each.sigma), strict=True):
        cells += [number(angle, "+.4f"), number(sigma, ".4f")]
    return Row((*cells, number(each.seconds, ".2f")), marked=used)
