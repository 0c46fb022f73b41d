"""List of the messages about files, each with buttons for its suggested actions."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QFont, QFontMetrics
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.language import N_, gettext
from lispac.message_texts import action_text, action_tip
from lispac.messages import Action, Level, Message

_LEVEL_STYLES = {
    Level.ERROR: ("close-octagon-outline", "error", N_("Error")),
    Level.WARNING: ("alert-outline", "warning", N_("Warning")),
    Level.NOTE: ("information-outline", "muted", N_("Note")),
}
"""Icon, role of its colour and label of each level."""
MAX_HEIGHT_PX = 150


class MessageList(QScrollArea):
    """List that is as tall as its messages up to a limit, beyond which it scrolls."""

    action_chosen = Signal(object, int)
    """An `Action`, and the index of its message."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAccessibleName(gettext("Warnings and notes"))
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self._shown: tuple[Message, ...] | None = None
        self._body = QWidget()
        self._rows = QVBoxLayout(self._body)
        self._rows.setContentsMargins(0, 0, 4, 0)
        self._rows.setSpacing(4)
        self.setWidget(self._body)
        # A scroll area gives its widget the colour of the window instead of the page.
        self._body.setAutoFillBackground(False)
        self.buttons: list[widgets.Button] = []

    def show_messages(self, messages: Sequence[Message], fine: str) -> None:
        """Show messages, or the text ``fine`` if there are none."""
        if self._shown == tuple(messages) and messages:
            return
        self._shown = tuple(messages)
        self.buttons = []
        while (item := self._rows.takeAt(0)) is not None:
            if (row := item.widget()) is not None:
                # Deleted later, since its button may be the one just clicked.
                row.hide()
                row.deleteLater()
        if not messages and fine:
            self._add_row(_message_row("check-circle-outline", "done", N_("OK"), fine)[0])
        for place, message in enumerate(messages):
            row, layout = _message_row(*_LEVEL_STYLES[message.level], message_text(message))
            for action in message.actions:
                button = self._create_button(action, message, place)
                layout.addWidget(button, 0, Qt.AlignmentFlag.AlignTop)
            self._add_row(row)
        self._rows.addStretch(1)
        self._fit_height()
        # The heights of buttons are known only after their style is applied.
        QTimer.singleShot(0, self, self._fit_height)

    def _add_row(self, row: QWidget) -> None:
        self._rows.addWidget(row)
        # A row has no height until the layout shows it.
        row.show()

    def _create_button(self, action: Action, message: Message, place: int) -> widgets.Button:
        name = f"message_action_{len(self.buttons)}"
        made = widgets.button(action_text(action), name, tip=action_tip(action))
        made.setAutoDefault(False)
        made.setAccessibleDescription(message_text(message))
        made.clicked.connect(lambda: self.action_chosen.emit(action, place))
        self.buttons.append(made)
        return made

    def showEvent(self, event) -> None:
        """Fit the height after the first layout."""
        super().showEvent(event)
        QTimer.singleShot(0, self, self._fit_height)

    def resizeEvent(self, event) -> None:
        """Fit the height to the new width."""
        super().resizeEvent(event)
        self._fit_height()

    def _fit_height(self) -> None:
        self._rows.invalidate()
        needed = self._rows.totalHeightForWidth(self.viewport().width())
        self.setFixedHeight(min(max(needed, 26), MAX_HEIGHT_PX))
        # The minimum height of wrapped text in Qt is too large and would cause a scroll bar.
        policy = Qt.ScrollBarPolicy
        self.setVerticalScrollBarPolicy(
            policy.ScrollBarAsNeeded if needed > MAX_HEIGHT_PX else policy.ScrollBarAlwaysOff
        )


def _message_row(icon: str, kind: str, label: str, text: str) -> tuple[QWidget, QHBoxLayout]:
    colour = theme.colour(kind).name()
    row = QWidget()
    layout = QHBoxLayout(row)
    layout.setContentsMargins(0, 1, 0, 1)
    mark = QLabel()
    mark.setPixmap(theme.icon(icon, colour).pixmap(16, 16))
    mark.setFixedWidth(18)
    head = widgets.label(gettext(label))
    head.setStyleSheet(f"color: {colour}; font-weight: 600;")
    bold = QFont(head.font())
    bold.setBold(True)
    labels = (gettext(each) for *_, each in _LEVEL_STYLES.values())
    head.setFixedWidth(max(map(QFontMetrics(bold).horizontalAdvance, labels)) + 8)
    message_label = widgets.label(text, wrap=True)
    # Setting a policy after the wrapping resets its dependence of the height on the width.
    policy = message_label.sizePolicy()
    policy.setHeightForWidth(True)
    message_label.setSizePolicy(policy)
    message_label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    top = Qt.AlignmentFlag.AlignTop
    layout.addWidget(mark, 0, top)
    layout.addWidget(head, 0, top)
    layout.addWidget(message_label, 1, top)
    return row, layout
