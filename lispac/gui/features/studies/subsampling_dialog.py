"""Dialogue with the boresight at several point spacings (thesis table 4.3)."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance import units
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog, angle_columns
from lispac.gui.widgets.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number_cell
from lispac.language import gettext
from lispac.workflow.checking.subsampling import SubsamplingResult


class SubsamplingDialog(StudyDialog):
    """Dialogue with a row for each point spacing."""

    def __init__(
        self, results: Sequence[SubsamplingResult], used: float, parent: QWidget | None = None
    ) -> None:
        title = dialog_title(ACTIONS["subsampling"])
        table = DiagnosticsTable("subsampling_table", title, _columns())
        super().__init__(
            "subsampling", title,
            gettext(
                "Each row is an adjustment of the same sightings with another point spacing. "
                "Points of a sighting share the POS errors, so below some spacing more points "
                "take time but do not reduce the standard deviations. The project is not changed."
            ),
            table, parent,
        )  # fmt: skip
        self.show_rows([_spacing_row(each, each.distance == used) for each in results])
        self.message_label.setText(
            gettext(
                "The highlighted row has the point spacing of the project settings, {spacing} "
                "{unit}.",
                spacing=units.localised(units.figure(used, "m", ".2f")),
                unit=units.shown_unit("m").sign,
            )
        )
        self.message_label.setVisible(any(each.distance == used for each in results))
        self.resize(860, 330)


def _columns() -> list[Column]:
    return [
        Column(
            gettext("Point spacing (m)"),
            gettext(
                "Points of a sighting that are closer together than this distance are averaged"
            ),
            base="m",
        ),
        Column(
            gettext("Points"), gettext("Number of points used; averaged points count as one point")
        ),
        *angle_columns(),
        Column(
            gettext("Computing time (s)"),
            gettext("Computing time of the adjustment, without the selection of points"),
        ),
    ]


def _spacing_row(each: SubsamplingResult, used: bool) -> Row:
    cells = [
        number_cell(each.distance, ".2f") if each.distance else Cell(gettext("all points"), 0.0),
        number_cell(each.points, ",.0f"),
    ]
    for angle, sigma in zip(np.degrees(each.boresight), np.degrees(each.sigma), strict=True):
        cells += [number_cell(angle, "+.4f"), number_cell(sigma, ".4f")]
    return Row((*cells, number_cell(each.seconds, ".2f")), marked=used)
