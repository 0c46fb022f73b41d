"""What other methods say of the boresight, beside the targets (as the thesis's table 4.4)."""

from collections.abc import Mapping, Sequence

import numpy as np
from PySide6.QtWidgets import QWidget

from lispac.adjustment.result import ANGLES
from lispac.gui.dialogs.study import StudyDialog
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.methods import WANTED, Answer, sentences
from lispac.opinions import Method

COLUMNS = (
    Column("Method", "What the boresight was found with", words=True),
    Column("Lines", "That the answer rests on"),
    Column("Surfaces", "Targets, planes, natural surfaces or objects that it rests on"),
    *(
        Column(f"{angle.capitalize()}{what}{unit}", f"{tip} of {angle}{of}", base=base)
        for angle in ANGLES
        for what, unit, tip, of, base in (
            ("", " (deg)", "Estimated value", ", degrees", "°"),
            (" ±", " (deg)", "1 sigma", ", degrees", "°"),
            (" off", " (sigma)", "Difference", " from the first row, over its sigma", None),
        )
    ),
)
BLANK = Cell("\N{EN DASH}")


class MethodsDialog(StudyDialog):
    """A row for each method, those that were not asked too.

    Attributes
    ----------
    asks : whether the missing ones are to be asked when it has closed
    """

    def __init__(
        self,
        found: Sequence[Answer],
        absent: Sequence[Method],
        refused: Mapping[str, str],
        parent: QWidget | None = None,
    ) -> None:
        table = DiagnosticsTable("methods_table", "Answers of other methods", COLUMNS)
        super().__init__(
            "methods", "Comparison with other methods",
            "What other methods say of the same lines; the targets take part in none of them. An "
            "answer that two methods give can be trusted more. The answers are kept with the "
            "project and stand in the report.",
            table, parent,
        )  # fmt: skip
        self.asks = False
        self.show_rows([*(_row(each) for each in found), *(_unasked(each) for each in absent)])
        told = [*sentences(tuple(found)), *(f"{k.capitalize()}: {v}" for k, v in refused.items())]
        told += [f"{each.method.capitalize()}: {said}" for each in found for said in each.remarks]
        self.said.setText("\n".join(say(each) for each in told))
        self.said.setVisible(bool(told))
        self.ask = widgets.button(
            "Run other methods", "methods_ask",
            tip="Adjust the validation planes and the surfaces of the scene, and do a patch test "
            "on objects looked for; one undo step",
        )  # fmt: skip
        self.ask.setEnabled(any(each not in refused for each in absent))
        self.ask.clicked.connect(self._ask)
        self._buttons.insertWidget(self._buttons.count() - 1, self.ask)
        self.resize(940, 360)

    def _ask(self) -> None:
        self.asks = True
        self.accept()


def _row(each: Answer) -> Row:
    said, against = each.calibration, each.against
    cells = [
        Cell(each.method.capitalize()), number(each.lines, ".0f"), number(each.surfaces, ".0f")
    ]  # fmt: skip
    over = [None] * 3 if against is None else against.significance.tolist()
    for angle, sigma, off in zip(
        np.degrees(said.boresight), np.degrees(said.sigma), over, strict=True
    ):
        cells += [number(angle, "+.4f"), number(sigma, ".4f")]
        cells.append(BLANK if off is None else number(off, "+.1f"))
    return Row(cells, marked=against is not None and against.differ, tip="; ".join(each.remarks))


def _unasked(method: Method) -> Row:
    cells = [Cell(method.capitalize()), *[BLANK] * (len(COLUMNS) - 1)]
    return Row(cells, tip=f"Not asked yet: {WANTED[method]}")
