"""Dialogue that compares the boresights of alternative methods (thesis table 4.4)."""

from collections.abc import Mapping, Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from lispac.alternative_methods import Method
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog, angle_columns
from lispac.gui.widgets.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number_cell
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.method_comparison import MethodResult, comparison_messages

METHODS = {
    "targets": N_("Targets"),
    "natural planes": N_("Natural planes"),
    "targetless": N_("Targetless"),
    "patch test": N_("Patch test"),
}
"""Names of the methods at the start of a row or line."""
NOT_RUN: dict[Method, str] = {
    "natural planes": N_(
        "This method has not been run yet. It estimates the boresight from the validation planes "
        "instead of the targets."
    ),
    "targetless": N_(
        "This method has not been run yet. It estimates the boresight from natural surfaces of "
        "the scene."
    ),
    "patch test": N_(
        "This method has not been run yet. It estimates the boresight by rotating the lines until "
        "they match on detected objects."
    ),
}
"""Tips of the rows of methods without a result."""
DIFFERENCE_COLUMNS = (
    (
        N_("Δ roll (σ)"),
        N_(
            "Roll minus the roll of the first row, divided by the standard deviation of the "
            "difference"
        ),
    ),
    (
        N_("Δ pitch (σ)"),
        N_(
            "Pitch minus the pitch of the first row, divided by the standard deviation of the "
            "difference"
        ),
    ),
    (
        N_("Δ yaw (σ)"),
        N_(
            "Yaw minus the yaw of the first row, divided by the standard deviation of the "
            "difference"
        ),
    ),
)
"""Titles and tips of the columns of differences."""
BLANK_CELL = Cell("\N{EN DASH}")
COLUMN_COUNT = 12


class MethodsDialog(StudyDialog):
    """Dialogue with a row for each method, with or without a result.

    Attributes
    ----------
    runs_missing : whether to run the missing methods after the dialogue is closed
    """

    def __init__(
        self,
        results: Sequence[MethodResult],
        absent: Sequence[Method],
        refused: Mapping[str, Message],
        parent: QWidget | None = None,
    ) -> None:
        table = DiagnosticsTable("methods_table", gettext("Results of all methods"), _columns())
        super().__init__(
            "methods", dialog_title(ACTIONS["methods"]),
            gettext(
                "The alternative methods estimate the boresight from the same lines without the "
                "targets. If the results agree, they are more reliable. They are saved in the "
                "project and shown in the report."
            ),
            table, parent,
        )  # fmt: skip
        self.runs_missing = False
        self.show_rows(
            [*(_method_row(each) for each in results), *(_row_not_run(each) for each in absent)]
        )
        messages = [
            *refused.items(),
            *((each.method, message) for each in results for message in each.messages),
        ]
        texts = [
            *map(message_text, comparison_messages(tuple(results))),
            *(_with_method_name(*each) for each in messages),
        ]
        self.message_label.setText("\n".join(texts))
        self.message_label.setVisible(bool(texts))
        self.run_missing = widgets.button(
            gettext("Run the methods without a result"), "methods_ask",
            tip=gettext(
                "Run the adjustments on validation planes and on natural surfaces, and the patch "
                "test on detected objects. One undo step removes all results."
            ),
        )  # fmt: skip
        self.run_missing.setEnabled(any(each not in refused for each in absent))
        self.run_missing.clicked.connect(self._request_missing)
        self._buttons.insertWidget(self._buttons.count() - 1, self.run_missing)
        self.resize(940, 360)

    def _request_missing(self) -> None:
        self.runs_missing = True
        self.accept()


def _columns() -> list[Column]:
    angles = angle_columns()
    columns = [
        Column(gettext("Method"), gettext("Method of estimation"), is_text=True),
        Column(gettext("Lines"), gettext("Number of lines used")),
        Column(
            gettext("Surfaces"),
            gettext("Number of targets, planes, natural surfaces or objects used"),
        ),
    ]
    for k, (title, tip) in enumerate(DIFFERENCE_COLUMNS):
        columns += [*angles[2 * k : 2 * k + 2], Column(gettext(title), gettext(tip))]
    return columns


def _method_name(method: str) -> str:
    return gettext(METHODS[method])


def _with_method_name(method: str, message: Message) -> str:
    """Message on a method, preceded by its name."""
    return gettext("{method}: {text}", method=_method_name(method), text=message_text(message))


def _method_row(each: MethodResult) -> Row:
    found, against = each.calibration, each.against
    cells = [
        Cell(_method_name(each.method)),
        number_cell(each.lines, ".0f"),
        number_cell(each.surfaces, ".0f"),
    ]
    differences = [None] * 3 if against is None else against.significance.tolist()
    for angle, sigma, difference in zip(
        np.degrees(found.boresight), np.degrees(found.sigma), differences, strict=True
    ):
        cells += [number_cell(angle, "+.4f"), number_cell(sigma, ".4f")]
        cells.append(BLANK_CELL if difference is None else number_cell(difference, "+.1f"))
    tip = "\n".join(map(message_text, each.messages))
    return Row(cells, marked=against is not None and against.differ, tip=tip)


def _row_not_run(method: Method) -> Row:
    cells = [Cell(_method_name(method)), *[BLANK_CELL] * (COLUMN_COUNT - 1)]
    return Row(cells, tip=gettext(NOT_RUN[method]))
