"""Dialogue that compares the boresights of alternative methods (thesis table 4.4)."""

from collections.abc import Mapping, Sequence

from PySide6.QtWidgets import QWidget

from lispac.alternative_methods import Method
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.study_dialog import StudyDialog
from lispac.gui.widgets.diagnostics_table import Cell, DiagnosticsTable, Row
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.method_comparison import MethodResult, comparison_messages
from lispac.present.calibration.methods import METHOD_TITLES, WINDOW_METHODS_TABLE, MethodValues
from lispac.present.tables import title_text
from lispac.present.text_format import UNKNOWN_TEXT

NOT_RUN_TIPS: dict[Method, str] = {
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
    "correspondences": N_(
        "This method has not been run yet. It estimates the boresight from a file of pairs of "
        "points of the same place."
    ),
}
"""Tips for the rows of methods without a result."""


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
        table = DiagnosticsTable(
            "methods_table",
            title_text(WINDOW_METHODS_TABLE.title),
            window_columns(WINDOW_METHODS_TABLE),
        )
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
            [
                *window_rows(
                    WINDOW_METHODS_TABLE,
                    map(MethodValues.of, results),
                    marked=lambda row: bool(row.differ),
                    tip=lambda row: "\n".join(map(message_text, row.messages)),
                ),
                *(_row_not_run(each) for each in absent),
            ]
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
            gettext("Run the methods that have no result yet"), "methods_ask",
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


def _method_name(method: str) -> str:
    return gettext(METHOD_TITLES[method])


def _with_method_name(method: str, message: Message) -> str:
    """Text of a message on a method, preceded by the name of the method."""
    return gettext("{method}: {text}", method=_method_name(method), text=message_text(message))


def _row_not_run(method: Method) -> Row:
    cells = [
        Cell(_method_name(method)),
        *[Cell(UNKNOWN_TEXT)] * (len(WINDOW_METHODS_TABLE.columns) - 1),
    ]
    return Row(cells, tip=gettext(NOT_RUN_TIPS[method]))
