"""List of all warnings; a click or Enter goes to the cause."""

import time
from collections.abc import Sequence

from PySide6.QtCore import (
    QEvent,
    QModelIndex,
    QPersistentModelIndex,
    QSize,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QFrame,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QStackedWidget,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from lispac.duplicate_targets import NOISE_ACTIONS
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.language import N_, Plural, gettext
from lispac.message_texts import action_text
from lispac.messages import Action, Level, Message, is_routine
from lispac.warning_causes import RESULT_CAUSE
from lispac.workflow.importing.input_file_messages import CHECK_SIGN_CODE

_Index = QModelIndex | QPersistentModelIndex
TITLE = N_("Messages")
ACTIVATE_KEYS = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)

LEVEL_STYLES: dict[Level, tuple[str, str, str]] = {
    Level.ERROR: ("alert-octagon", "error", N_("Error")),
    Level.WARNING: ("alert", "warning", N_("Warning")),
    Level.NOTE: ("information-outline", "muted", N_("Note")),
}
"""Icon, colour and name of each level; the shapes also differ, for colour-blind users."""

ACTION_LINE = "\N{NO-BREAK SPACE}"
"""Last line of a message with actions: the place of its buttons."""
BUTTON_INDENT_PX, BUTTON_HEIGHT_PX = 4, 18
"""Left edge and height of the buttons of a message, in the last line of its text."""
BUTTON_GAP_PX = 10
"""Additional height of a message with buttons, half of which is above its buttons."""
MAX_SLICE_S = 0.015
"""Time for which texts are added before events are processed; a text takes a millisecond."""

NO_PROJECT_TEXT = N_("Open or create a project to see the messages about it.")
NO_WARNINGS_TEXT = N_("No warnings about the files, the targets or the result.")
CLICK_HINT = N_("Click a message, or press Enter on it, to go to its cause.")
INCOMPLETE_TEXT = N_("{counts} so far; not all sightings are rated yet")
WAITING_TEXT = N_("A new estimate is running. These messages are from before the change.")


LEVEL_COUNT_TEXTS = {
    Level.ERROR: Plural("{count:n} error", "{count:n} errors"),
    Level.WARNING: Plural("{count:n} warning", "{count:n} warnings"),
    Level.NOTE: Plural("{count:n} note", "{count:n} notes"),
}


ROUTINE_COUNT_TEXT = Plural("{count:n} routine note", "{count:n} routine notes")


def level_counts_text(messages: Sequence[Message], *, is_complete: bool = True) -> str:
    """Text of the number of messages of each level: ``2 warnings, 3 notes, 8 routine notes``.

    Parameters
    ----------
    is_complete : whether all sightings are rated, so that no note on them is missing
    """
    routine = sum(map(is_routine, messages))
    counts = {level: sum(each.level is level for each in messages) for level in Level}
    counts[Level.NOTE] -= routine
    texts = [
        gettext(LEVEL_COUNT_TEXTS[level], count=count) for level, count in counts.items() if count
    ]
    if routine:
        texts.append(gettext(ROUTINE_COUNT_TEXT, count=routine))
    text = ", ".join(texts) or gettext("No messages")
    return text if is_complete else gettext(INCOMPLETE_TEXT, counts=text)


class WarningsPanel(QWidget):
    """List of warnings, or the reason why there is none; routine notes are shown on request."""

    cause_activated = Signal(object)
    """The `Cause` to show."""
    action_requested = Signal(object)
    """The `Action` of a message whose button was pressed."""

    def __init__(self) -> None:
        super().__init__()
        self.messages: tuple[Message, ...] = ()
        self.head = widgets.label("", "muted", wrap=True, name="warnings_head")
        self.list = _WarningListWidget()
        self.list.itemClicked.connect(lambda item: self._emit_cause(self.list.row(item)))
        self.list.entered_.connect(self._emit_cause)
        self.routine = QCheckBox(gettext("Show routine notes"))
        self.routine.setObjectName("show_routine_notes")
        self.routine.setToolTip(
            gettext(
                "Notes for the record: how the files were read, lines without a target, sightings "
                "of doubtful quality"
            )
        )
        self.routine.toggled.connect(self._show_routine)
        self.empty = widgets.label("", "muted", wrap=True, name="warnings_empty")
        self.empty.setMargin(4)
        self.empty.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        filled = QWidget()
        column = QVBoxLayout(filled)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        top = QHBoxLayout()
        top.addWidget(self.head, 1)
        top.addWidget(self.routine, 0, Qt.AlignmentFlag.AlignTop)
        column.addLayout(top)
        column.addWidget(self.list, 1)
        self._current_message: Message | None = None
        self._texts: dict[Message, str] = {}
        self._fill_timer = QTimer(self)
        self._fill_timer.setSingleShot(True)
        self._fill_timer.timeout.connect(self._fill)
        self._pages = QStackedWidget()
        self._pages.addWidget(self.empty)
        self._pages.addWidget(filled)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(8, 6, 8, 0)
        outer.addWidget(self._pages)
        self.show_nothing()

    def show_nothing(self) -> None:
        """Show that no project is open."""
        self.messages = ()
        self.list.clear()
        self._show_empty(NO_PROJECT_TEXT)

    def show_waiting(self) -> None:
        """Show that the list is out of date and a new result is being computed."""
        self.head.setText(gettext(WAITING_TEXT))

    def show_warnings(self, messages: Sequence[Message], *, is_complete: bool = True) -> None:
        """Show the list; the current message remains current if it is still in the list.

        Parameters
        ----------
        is_complete : whether all sightings are rated
        """
        current = self.list.currentRow()
        current_message = self.messages[current] if 0 <= current < len(self.messages) else None
        self.messages = tuple(messages)
        self.list.clear()
        self._current_message = current_message
        # Without other messages there would be an empty list
        routine = [is_routine(each) for each in messages]
        self.routine.setVisible(any(routine) and not all(routine))
        if not messages:
            self._show_empty(NO_WARNINGS_TEXT)
            return
        self._fill()
        counts = level_counts_text(messages, is_complete=is_complete)
        self.head.setText(f"{counts}. {gettext(CLICK_HINT)}")
        self._pages.setCurrentIndex(1)

    @property
    def is_filled(self) -> bool:
        """Whether all messages are in the list."""
        return self.list.count() == len(self.messages)

    def _fill(self) -> None:
        """Add messages for a short time, and the rest in later turns of the event loop."""
        until = time.monotonic() + MAX_SLICE_S
        texts = self._texts
        while not self.is_filled and time.monotonic() < until:
            message = self.messages[self.list.count()]
            if message not in texts:
                texts[message] = message_text(message)
            self.list.addItem(_message_item(message, texts[message]))
            if actions := _possible_actions(message):
                item = self.list.item(self.list.count() - 1)
                self.list.setItemWidget(item, self._action_buttons(actions))
            self.list.setRowHidden(self.list.count() - 1, self._is_hidden(message))
            if message == self._current_message:
                self.list.setCurrentRow(self.list.count() - 1)
        if not self.is_filled:
            self._fill_timer.start()
        elif len(texts) > len(self.messages):
            self._texts = {each: texts[each] for each in self.messages}

    def _is_hidden(self, message: Message) -> bool:
        has_choice = not self.routine.isHidden()
        return has_choice and not self.routine.isChecked() and is_routine(message)

    def _show_routine(self) -> None:
        """Show or hide the routine notes."""
        for row in range(self.list.count()):
            self.list.setRowHidden(row, self._is_hidden(self.messages[row]))

    def _action_buttons(self, actions: Sequence[Action]) -> QWidget:
        """Buttons of a message, below its text."""
        made = QWidget()
        row = QHBoxLayout(made)
        row.setContentsMargins(BUTTON_INDENT_PX, 0, 4, 0)
        for action in actions:
            button = widgets.button(action_text(action), f"message_{action.code}")
            button.setStyleSheet("padding: 0px 8px;")
            button.setFixedHeight(BUTTON_HEIGHT_PX)
            button.clicked.connect(lambda _=False, action=action: self._emit_action(action))
            row.addWidget(button, 0, Qt.AlignmentFlag.AlignBottom)
        row.addStretch(1)
        return made

    def _emit_action(self, action: Action) -> None:
        self.action_requested.emit(action)

    def focus_list(self) -> None:
        """Give the list the keyboard focus."""
        if self.list.count():
            if self.list.currentRow() < 0:
                self.list.setCurrentRow(0)
            self.list.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def _show_empty(self, text: str) -> None:
        self.empty.setText(gettext(text))
        self._pages.setCurrentIndex(0)

    def _emit_cause(self, row: int) -> None:
        if 0 <= row < len(self.messages):
            self.cause_activated.emit(self.messages[row].subject or RESULT_CAUSE)


class _WarningListWidget(QListWidget):
    """List with wrapped texts, in which Enter and Space act like a click."""

    entered_ = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("warnings_list")
        self.setAccessibleName(gettext(TITLE))
        self.setWordWrap(True)
        self.setTextElideMode(Qt.TextElideMode.ElideNone)
        self.setResizeMode(QListWidget.ResizeMode.Adjust)
        self.setLayoutMode(QListWidget.LayoutMode.Batched)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setIconSize(QSize(18, 18))
        self.setStyleSheet("QListWidget { border: none; } QListWidget::item { padding: 4px; }")
        self.setItemDelegate(_ButtonSpace(self))

    def event(self, event: QEvent) -> bool:
        # Elsewhere in the window Enter accepts the candidate.
        pressed = event.type() == QEvent.Type.ShortcutOverride
        if pressed and isinstance(event, QKeyEvent) and event.key() in ACTIVATE_KEYS:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in ACTIVATE_KEYS and self.currentRow() >= 0:
            self.entered_.emit(self.currentRow())
        else:
            super().keyPressEvent(event)


class _ButtonSpace(QStyledItemDelegate):
    """Delegate that makes messages with buttons higher than their text."""

    def sizeHint(self, option: QStyleOptionViewItem, index: _Index) -> QSize:
        hint = super().sizeHint(option, index)
        has_buttons = index.data().endswith(ACTION_LINE)
        return hint + QSize(0, BUTTON_GAP_PX) if has_buttons else hint


def _possible_actions(message: Message) -> tuple[Action, ...]:
    """Actions that the window can carry out; others on files belong to the import."""
    possible = (*NOISE_ACTIONS, CHECK_SIGN_CODE)
    return tuple(action for action in message.actions if action.code in possible)


def _message_item(message: Message, text: str) -> QListWidgetItem:
    icon, colour, level = LEVEL_STYLES[message.level]
    shown = f"{text}\n{ACTION_LINE}" if _possible_actions(message) else text
    made = QListWidgetItem(theme.icon(icon, theme.colour(colour).name()), shown)
    action = gettext("Click, or press Enter, to go to the cause")
    made.setToolTip(widgets.plain_tip(f"{gettext(level)}\n{action}"))
    made.setData(
        Qt.ItemDataRole.AccessibleTextRole,
        gettext("{level}: {message}", level=gettext(level), message=text),
    )
    return made


class WarningsButton(QPushButton):
    """Number of warnings in the status bar; a click opens the list."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("warnings_button")
        self.setStyleSheet("padding: 1px 8px;")
        self.show_warnings(None)

    def show_warnings(
        self, messages: Sequence[Message] | None, *, is_complete: bool = True
    ) -> None:
        """Show the number of messages of each level; None if no project is open.

        Parameters
        ----------
        is_complete : whether all sightings are rated
        """
        self.setVisible(messages is not None)
        worst = next(
            (level for level in Level if any(m.level is level for m in messages or ())), None
        )
        icon, colour = LEVEL_STYLES[worst][:2] if worst else ("check-circle-outline", "done")
        self.setIcon(theme.icon(icon, theme.colour(colour).name()))
        text = level_counts_text(messages or ())
        # The status bar has little space; the panel counts the routine notes too
        important = [each for each in messages or () if not is_routine(each)]
        short = level_counts_text(important or messages or ())
        self.setText(short if is_complete else f"{short} …")
        if (bar := self.parentWidget()) is not None and (layout := bar.layout()) is not None:
            layout.activate()  # the bar may paint the text before the next layout
        tip = gettext("Click to see them all (F12)")
        if not is_complete:
            text = level_counts_text(messages or (), is_complete=False)
            tip = f"{text}. {tip}"
        self.setToolTip(tip)
        self.setAccessibleName(text)
