"""Sentences about a file, one under the other, each with the buttons of what would mend it."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from lispac.gui import theme
from lispac.gui.language import say, say_message
from lispac.gui.panels import widgets
from lispac.message_texts import action_text, action_tip
from lispac.messages import Action, Level, Message

_MARKS = {
    Level.ERROR: ("close-octagon-outline", "error", "Error"),
    Level.WARNING: ("alert-outline", "warning", "Doubt"),
    Level.NOTE: ("information-outline", "muted", "Note"),
}
TALLEST = 150


class RemarksView(QScrollArea):
    """As tall as its sentences, up to a point; beyond, it scrolls."""

    remedy_chosen = Signal(object, int)
    """An `Action`, and the index of its message."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAccessibleName(say("What there is to look at"))
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self._shown: tuple[Message, ...] | None = None
        self._body = QWidget()
        self._rows = QVBoxLayout(self._body)
        self._rows.setContentsMargins(0, 0, 4, 0)
        self._rows.setSpacing(4)
        self.setWidget(self._body)
        # A scroll area gives its widget the window's colour, which is not that of the page.
        self._body.setAutoFillBackground(False)
        self.buttons: list[widgets.Button] = []

    def show_remarks(self, remarks: Sequence[Message], fine: str) -> None:
        """Show sentences, or ``fine`` where there are none."""
        if self._shown == tuple(remarks) and remarks:
            return
        self._shown = tuple(remarks)
        self.buttons = []
        while (item := self._rows.takeAt(0)) is not None:
            if (row := item.widget()) is not None:
                # Its button may be the one that was just clicked.
                row.hide()
                row.deleteLater()
        if not remarks and fine:
            self._put(_row("check-circle-outline", "done", "OK", fine)[0])
        for place, message in enumerate(remarks):
            row, layout = _row(*_MARKS[message.level], say_message(message))
            for action in message.actions:
                button = self._button(action, message, place)
                layout.addWidget(button, 0, Qt.AlignmentFlag.AlignTop)
            self._put(row)
        self._rows.addStretch(1)
        self._fit()
        # Buttons know their height once their style has been settled, which comes later.
        QTimer.singleShot(0, self, self._fit)

    def _put(self, row: QWidget) -> None:
        self._rows.addWidget(row)
        # A layout shows what is added to it later on; until then it has no height.
        row.show()

    def _button(self, action: Action, message: Message, place: int) -> widgets.Button:
        name = f"remedy_{len(self.buttons)}"
        made = widgets.button(action_text(action), name, tip=action_tip(action))
        made.setAutoDefault(False)
        made.setAccessibleDescription(say_message(message))
        made.clicked.connect(lambda: self.remedy_chosen.emit(action, place))
        self.buttons.append(made)
        return made

    def showEvent(self, event) -> None:
        """Fit the height once it is laid out."""
        super().showEvent(event)
        QTimer.singleShot(0, self, self._fit)

    def resizeEvent(self, event) -> None:
        """Fit the height to the new width."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        self._rows.invalidate()
        needed = self._rows.totalHeightForWidth(self.viewport().width())
        self.setFixedHeight(min(max(needed, 26), TALLEST))
        # The least height of wrapped words is guessed too large, which would show a useless bar.
        policy = Qt.ScrollBarPolicy
        self.setVerticalScrollBarPolicy(
            policy.ScrollBarAsNeeded if needed > TALLEST else policy.ScrollBarAlwaysOff
        )


def _row(icon: str, kind: str, word: str, text: str) -> tuple[QWidget, QHBoxLayout]:
    colour = theme.colour(kind).name()
    row = QWidget()
    layout = QHBoxLayout(row)
    layout.setContentsMargins(0, 1, 0, 1)
    mark = QLabel()
    mark.setPixmap(theme.icon(icon, colour).pixmap(16, 16))
    mark.setFixedWidth(18)
    head = widgets.label(word)
    head.setStyleSheet(f"color: {colour}; font-weight: 600;")
    head.setFixedWidth(46)
    said = widgets.label(text, wrap=True)
    # A policy that is set after the wrapping forgets that the height depends on the width.
    policy = said.sizePolicy()
    policy.setHeightForWidth(True)
    said.setSizePolicy(policy)
    said.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    top = Qt.AlignmentFlag.AlignTop
    layout.addWidget(mark, 0, top)
    layout.addWidget(head, 0, top)
    layout.addWidget(said, 1, top)
    return row, layout
