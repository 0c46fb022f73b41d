"""Table of roll, pitch and yaw with messages: result of simulated surveys or of a comparison."""

from collections.abc import Sequence
from typing import Protocol

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QVBoxLayout, QWidget

from lispac.design.plan import Plan
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.language import N_, LazyText, gettext

OUT_OF_DATE = N_(
    "This result is out of date because the survey plan was changed. Run the computation again."
)


ANGLE_NAMES = N_("roll"), N_("pitch"), N_("yaw")


class AnglesResult(Protocol):
    """Result with rows of a title and three angles, and with messages."""

    @property
    def rows(self) -> Sequence[Sequence[str]]:
        """Title, roll, pitch and yaw of each row."""

    @property
    def summary_texts(self) -> Sequence[str]:
        """Texts of the messages."""


class AnglesTable(QWidget):
    """Table of roll, pitch and yaw; shows a hint until there is a result."""

    def __init__(self, name: str, hint: str) -> None:
        super().__init__()
        self.setObjectName(name)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.head = widgets.label("", "heading", wrap=True, name=f"{name}_head")
        self.hint = widgets.label(hint, "muted", wrap=True)
        self.messages = widgets.label("", "hint", wrap=True, name=f"{name}_words")
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(18)
        self._grid.setVerticalSpacing(3)
        self._grid.setColumnStretch(len(ANGLE_NAMES) + 1, 1)
        layout.addWidget(self.head)
        layout.addWidget(self.hint)
        layout.addLayout(self._grid)
        layout.addWidget(self.messages)
        layout.addStretch(1)
        self.outdated = widgets.label(
            gettext(OUT_OF_DATE), "warning", wrap=True, name=f"{name}_out_of_date"
        )
        layout.insertWidget(1, self.outdated)
        for each in (self.head, self.outdated, self.messages):
            each.hide()
        self._plan: Plan | None = None
        self._shown: tuple[LazyText, AnglesResult, Plan] | None = None

    def set_current_plan(self, plan: Plan) -> None:
        """Mark the result as out of date if it belongs to another plan."""
        self.outdated.setVisible(self._plan is not None and self._plan is not plan)

    def show_result(self, head: LazyText, result: AnglesResult, plan: Plan) -> None:
        """Show the result for a plan under a heading."""
        self._clear()
        self._plan, self._shown = plan, (head, result, plan)
        self.head.setText(str(head))
        angles = tuple(map(gettext, ANGLE_NAMES))
        for row, (name, *cells) in enumerate([("", *angles), *result.rows]):
            self._grid.addWidget(widgets.label(name, "muted"), row, 0)
            for column, (angle, cell) in enumerate(zip(angles, cells, strict=True), start=1):
                shown = widgets.label(cell.replace("-", "−"), "" if row else "muted")
                shown.setFont(theme.tabular_font(shown.font()))
                if row:
                    shown.setAccessibleName(f"{name}, {angle}")
                self._grid.addWidget(shown, row, column, Qt.AlignmentFlag.AlignRight)
        self.messages.setText("\n".join(result.summary_texts))
        self.hint.hide()
        for each in (self.head, self.messages):
            each.show()

    def copy_state_from(self, former: "AnglesTable") -> None:
        """Copy the result of another table."""
        if former._shown is not None:
            self.show_result(*former._shown)

    @property
    def cells(self) -> list[list[str]]:
        """Texts of the cells, row by row, with their titles."""
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
