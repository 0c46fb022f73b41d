"""Rows of numbers under roll, pitch and yaw, and sentences: what a campaign or a survey gave."""

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QVBoxLayout, QWidget

from lispac.adjustment.result import ANGLES
from lispac.design.plan import Plan
from lispac.gui import theme
from lispac.gui.language import say
from lispac.gui.panels import widgets

Rows = tuple[str, Sequence[Sequence[str]], Sequence[str], Plan]
"""What is shown: heading, rows, sentences, and the plan it is of."""
EARLIER = "The plan has been changed since: this is of the plan as it was."


class AnglesTable(QWidget):
    """Empty, with a hint what to do, until something is shown."""

    def __init__(self, name: str, hint: str) -> None:
        super().__init__()
        self.setObjectName(name)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.head = widgets.label("", "heading", wrap=True, name=f"{name}_head")
        self.hint = widgets.label(hint, "muted", wrap=True)
        self.words = widgets.label("", "hint", wrap=True, name=f"{name}_words")
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(18)
        self._grid.setVerticalSpacing(3)
        self._grid.setColumnStretch(len(ANGLES) + 1, 1)
        layout.addWidget(self.head)
        layout.addWidget(self.hint)
        layout.addLayout(self._grid)
        layout.addWidget(self.words)
        layout.addStretch(1)
        self.stale = widgets.label(EARLIER, "warning", wrap=True, name=f"{name}_stale")
        layout.insertWidget(1, self.stale)
        for each in (self.head, self.stale, self.words):
            each.hide()
        self._plan: Plan | None = None
        self._rows: Rows | None = None

    def follow(self, plan: Plan) -> None:
        """Say of an answer that it is not this plan's."""
        self.stale.setVisible(self._plan is not None and self._plan is not plan)

    def show_rows(
        self, head: str, rows: Sequence[Sequence[str]], words: Sequence[str], plan: Plan
    ) -> None:
        """Show an answer for a plan in place of the one before."""
        self._clear()
        self._plan, self._rows = plan, (head, rows, words, plan)
        self.head.setText(say(head))
        for row, (name, *cells) in enumerate([("", *ANGLES), *rows]):
            self._grid.addWidget(widgets.label(name, "muted"), row, 0)
            for column, (angle, cell) in enumerate(zip(ANGLES, cells, strict=True), start=1):
                shown = widgets.label(cell.replace("-", "−"), "" if row else "muted")
                shown.setFont(theme.tabular(shown.font()))
                if row:
                    shown.setAccessibleName(f"{say(name)}, {say(angle)}")
                self._grid.addWidget(shown, row, column, Qt.AlignmentFlag.AlignRight)
        self.words.setText(say("\n".join(words)))
        self.hint.hide()
        for each in (self.head, self.words):
            each.show()

    def take_over(self, former: "AnglesTable") -> None:
        """Show what another one shows, where it does."""
        if former._rows is not None:
            self.show_rows(*former._rows)

    @property
    def cells(self) -> list[list[str]]:
        """What is shown, row by row, names first."""
        found: dict[int, list[str]] = {}
        for k in range(self._grid.count()):
            row = self._grid.getItemPosition(k)[0]
            found.setdefault(row, []).append(self._grid.itemAt(k).widget().text())
        return [found[row] for row in sorted(found)]

    def _clear(self) -> None:
        while self._grid.count():
            widget = self._grid.takeAt(0).widget()
            widget.hide()
            widget.deleteLater()
