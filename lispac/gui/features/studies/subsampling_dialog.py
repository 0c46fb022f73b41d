"""Dialogue with the boresight at several point spacings (thesis table 4.3)."""

from collections.abc import Sequence

from PySide6.QtWidgets import QWidget

from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance import units
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import gettext
from lispac.present.subsampling import SUBSAMPLING_TABLE, SubsamplingValues


class SubsamplingDialog(StudyDialog):
    """Dialogue with a row for each point spacing."""

    def __init__(
        self, results: Sequence[SubsamplingValues], used: float, parent: QWidget | None = None
    ) -> None:
        title = dialog_title(ACTIONS["subsampling"])
        table = DiagnosticsTable("subsampling_table", title, window_columns(SUBSAMPLING_TABLE))
        super().__init__(
            "subsampling", title,
            gettext(
                "Each row is an adjustment of the same sightings with another point spacing. "
                "Points of a sighting share the POS errors, so below some spacing more points "
                "take time but do not reduce the standard deviations. The project is not changed."
            ),
            table, parent,
        )  # fmt: skip
        self.show_rows(
            window_rows(SUBSAMPLING_TABLE, results, marked=lambda row: row.distance_m == used)
        )
        self.message_label.setText(
            gettext(
                "The highlighted row has the point spacing of the project settings, {spacing} "
                "{unit}.",
                spacing=units.localised(units.figure(used, "m", ".2f")),
                unit=units.shown_unit("m").sign,
            )
        )
        self.message_label.setVisible(any(each.distance_m == used for each in results))
        self.resize(860, 330)
