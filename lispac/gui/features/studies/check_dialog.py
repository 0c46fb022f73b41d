"""Dialogues of the check against a reference: the request and its result."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtWidgets import QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.gui.widgets.surveyed_file_dialog import SurveyedFileDialog
from lispac.language import gettext
from lispac.present.checking.absolute import LINE_CHECKS_TABLE, AbsoluteCheckValues, lines_and_all
from lispac.present.tables import title_text
from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.checking.absolute_check import DEFAULT_SIGMA, SEARCH_DISTANCE


@dataclass(frozen=True)
class CheckRequest:
    """Reference of a check and the options of the comparison.

    Attributes
    ----------
    crs, height : coordinate systems as in `lispac check`; empty for those of the file
    sigma : float, metres
        Standard deviation of the reference if the file contains none.
    search_distance : float, metres
        Search distance for points of a line around the reference.
    """

    path: Path
    crs: str
    height: str
    sigma: float
    search_distance: float


class CheckDialog(SurveyedFileDialog):
    """Dialogue for a reference: file, coordinate system and standard deviation."""

    def __init__(
        self, project: Project, trajectory: LocalTrajectory, parent: QWidget | None = None
    ) -> None:
        super().__init__(
            project, trajectory,
            name="check",
            introduction=gettext(
                "The lines are compared with a static scan of the site or with surveyed "
                "points. Each row of a point list has a name, three coordinates (in the local "
                "frame north, west, up) and, optionally, a standard deviation and the name of "
                "the plane of the point."
            ),
            label=gettext("Reference"),
            browse_title=gettext("Choose the reference file"),
            parent=parent,
        )  # fmt: skip
        self.setObjectName("check_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["check"]))
        self.sigma = widgets.number(
            "check_sigma", suffix=" mm", decimals=1, low=0, high=1000, step=1,
            tip=gettext(
                "Standard deviation of the reference. For a scan: error common to all points, "
                "from registration and control. For a point list: value for points without their "
                "own standard deviation."
            ),
        )  # fmt: skip
        self.sigma.setValue(1000 * DEFAULT_SIGMA)
        self.search_distance = widgets.number(
            "check_reach", suffix=" m", decimals=2, low=0.05, high=20, step=0.25,
            tip=gettext(
                "Largest distance at which a line is compared with the reference. It must exceed "
                "the displacement caused by the error of the prior boresight."
            ),
        )  # fmt: skip
        self.search_distance.setValue(SEARCH_DISTANCE)
        self.form.addRow(gettext("Reference uncertainty (1 σ)"), self.sigma)
        self.form.addRow(gettext("Search distance"), self.search_distance)
        self.add_buttons(widgets.button(gettext("Run check"), "check_run", primary=True))

    @property
    def request(self) -> CheckRequest:
        """The check as filled in."""
        return CheckRequest(
            self.path, *self.systems, self.sigma.value() / 1000, self.search_distance.value()
        )


class CheckResultDialog(StudyDialog):
    """Distances of each line from the reference, before and after calibration."""

    def __init__(self, values: AbsoluteCheckValues, parent: QWidget | None = None) -> None:
        from lispac.report.absolute_figure import reference_distance_figure

        table = DiagnosticsTable(
            "check_table", title_text(LINE_CHECKS_TABLE.title), window_columns(LINE_CHECKS_TABLE)
        )
        super().__init__(
            "checked", gettext("Check against {reference}", reference=values.reference),
            gettext(
                "The table shows the distances of the lines from the reference along the normal "
                "of the reference, positive towards the vessel. The report contains the same "
                "values."
            ),
            table, parent,
        )  # fmt: skip
        self.show_rows(
            window_rows(
                LINE_CHECKS_TABLE,
                lines_and_all(values),
                marked=lambda row: row.after.mean_significant,
            )
        )
        not_compared = [
            gettext("Not compared: {reason}", reason=message_text(reason))
            for reason in values.not_compared
        ]
        self.message_label.setText("\n".join([*map(message_text, values.messages), *not_compared]))
        reference_distance_figure(values, self.figure())
        self.resize(1000, 760)
