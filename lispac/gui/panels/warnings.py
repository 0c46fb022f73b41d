"""All there is to be warned of, in one list: a click, or Enter, goes to the cause."""

import time
from collections.abc import Sequence

from PySide6.QtCore import QEvent, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from lispac.causes import RESULT
from lispac.gui import theme
from lispac.gui.language import say, say_message
from lispac.gui.panels import widgets
from lispac.language import N_, Plural, gettext
from lispac.messages import Level, Message

TITLE = "Warnings"
ENTERS = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)

LOOKS: dict[Level, tuple[str, str, str]] = {
    Level.ERROR: ("alert-octagon", "error", N_("Error")),
    Level.WARNING: ("alert", "warning", N_("Warning")),
    Level.NOTE: ("information-outline", "muted", N_("Note")),
}
"""Icon, colour and word; the shapes differ too, for colours alone do not tell everybody."""

TURN_S = 0.015
"""Sentences take a millisecond each to be said in another language."""

NO_PROJECT = "Open or make a project: its warnings appear here."
NOTHING = "Nothing to warn of. What the files, picks and figures give cause for appears here."
GO = "Click one, or press Enter on it, to go to its cause."
WAITING = "Estimating again; these are the warnings from before the change."


COUNTS = {
    Level.ERROR: Plural("{count:n} error", "{count:n} errors"),
    Level.WARNING: Plural("{count:n} warning", "{count:n} warnings"),
    Level.NOTE: Plural("{count:n} note", "{count:n} notes"),
}


def count_words(messages: Sequence[Message]) -> str:
    """``2 warnings, 3 notes``, of what there is, in the user's language."""
    counts = {level: sum(each.level is level for each in messages) for level in Level}
    return ", ".join(
        gettext(COUNTS[level], count=count) for level, count in counts.items() if count
    )


class WarningsPanel(QWidget):
    """The list, or why there is none."""

    followed = Signal(object)
    """The `Cause` that the user wants to see."""

    def __init__(self) -> None:
        super().__init__()
        self.messages: tuple[Message, ...] = ()
        self.head = widgets.label("", "muted", wrap=True, name="warnings_head")
        self.list = _List()
        self.list.itemClicked.connect(lambda item: self._follow(self.list.row(item)))
        self.list.entered_.connect(self._follow)
        self.empty = widgets.label("", "muted", wrap=True, name="warnings_empty")
        self.empty.setMargin(4)
        self.empty.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        filled = QWidget()
        column = QVBoxLayout(filled)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addWidget(self.head)
        column.addWidget(self.list, 1)
        self._kept: Message | None = None
        self._said: dict[Message, str] = {}
        self._turn = QTimer(self)
        self._turn.setSingleShot(True)
        self._turn.timeout.connect(self._fill)
        self._pages = QStackedWidget()
        self._pages.addWidget(self.empty)
        self._pages.addWidget(filled)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(8, 6, 8, 0)
        outer.addWidget(self._pages)
        self.show_nothing()

    def show_nothing(self) -> None:
        """No project is open."""
        self.messages = ()
        self.list.clear()
        self._say(NO_PROJECT)

    def show_waiting(self) -> None:
        """The list is no longer that of the project: a result is on its way."""
        self.head.setText(say(WAITING))

    def show_warnings(self, messages: Sequence[Message]) -> None:
        """Show the list; what was current stays so where it still is there."""
        current = self.list.currentRow()
        kept = self.messages[current] if 0 <= current < len(self.messages) else None
        self.messages = tuple(messages)
        self.list.clear()
        self._kept = kept
        if not messages:
            self._say(NOTHING)
            return
        self._fill()
        counts = count_words(messages)
        self.head.setText(f"{counts[:1].upper()}{counts[1:]}. {say(GO)}")
        self._pages.setCurrentIndex(1)

    @property
    def is_filled(self) -> bool:
        """Whether every sentence stands in the list."""
        return self.list.count() == len(self.messages)

    def _fill(self) -> None:
        """Say as many sentences as one does not notice, and the others in the next turn."""
        until = time.monotonic() + TURN_S
        said = self._said
        while not self.is_filled and time.monotonic() < until:
            message = self.messages[self.list.count()]
            if message not in said:
                said[message] = say_message(message)
            self.list.addItem(_item(message, said[message]))
            if message == self._kept:
                self.list.setCurrentRow(self.list.count() - 1)
        if not self.is_filled:
            self._turn.start()
        elif len(said) > len(self.messages):
            self._said = {each: said[each] for each in self.messages}

    def take_focus(self) -> None:
        """Let the keyboard go through the list."""
        if self.list.count():
            if self.list.currentRow() < 0:
                self.list.setCurrentRow(0)
            self.list.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def _say(self, words: str) -> None:
        self.empty.setText(say(words))
        self._pages.setCurrentIndex(0)

    def _follow(self, row: int) -> None:
        if 0 <= row < len(self.messages):
            self.followed.emit(self.messages[row].subject or RESULT)


class _List(QListWidget):
    """Sentences as tall as they need to be; Enter and Space act like a click."""

    entered_ = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("warnings_list")
        self.setAccessibleName(say(TITLE))
        self.setWordWrap(True)
        self.setTextElideMode(Qt.TextElideMode.ElideNone)
        self.setResizeMode(QListWidget.ResizeMode.Adjust)
        self.setLayoutMode(QListWidget.LayoutMode.Batched)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setIconSize(QSize(18, 18))
        self.setStyleSheet("QListWidget { border: none; } QListWidget::item { padding: 4px; }")

    def event(self, event: QEvent) -> bool:
        # Enter keeps a candidate elsewhere in the window.
        pressed = event.type() == QEvent.Type.ShortcutOverride
        if pressed and isinstance(event, QKeyEvent) and event.key() in ENTERS:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in ENTERS and self.currentRow() >= 0:
            self.entered_.emit(self.currentRow())
        else:
            super().keyPressEvent(event)


def _item(message: Message, text: str) -> QListWidgetItem:
    icon, colour, word = LOOKS[message.level]
    said = gettext(word)
    made = QListWidgetItem(theme.icon(icon, theme.colour(colour).name()), text)
    made.setToolTip(
        widgets.plain_tip(f"{said}\n{say('Click, or press Enter, to go to the cause')}")
    )
    made.setData(Qt.ItemDataRole.AccessibleTextRole, f"{said}: {text}")
    return made


class WarningsButton(QPushButton):
    """How many warnings there are, in the status bar; opens the list."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("warnings_button")
        self.setStyleSheet("padding: 1px 8px;")
        self.show_warnings(None)

    def show_warnings(self, messages: Sequence[Message] | None) -> None:
        """Count the messages of the highest level; None where no project is open."""
        self.setVisible(messages is not None)
        worst = next(
            (level for level in Level if any(m.level is level for m in messages or ())), None
        )
        icon, colour = LOOKS[worst][:2] if worst else ("check-circle-outline", "done")
        self.setIcon(theme.icon(icon, theme.colour(colour).name()))
        words = (
            count_words([each for each in messages or () if each.level is worst])
            if worst
            else say("No warnings")
        )
        self.setText(words)
        counts = f"{count_words(messages)}. " if messages else ""
        self.setToolTip(f"{counts}{say('Click to see them all (F12)')}")
        self.setAccessibleName(words)
