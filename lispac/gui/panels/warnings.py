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

from lispac.gui import theme
from lispac.gui.language import say, say_with_capital
from lispac.gui.panels import widgets
from lispac.workflow.warnings import Concern, Severity

TITLE = "Warnings"
ENTERS = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)

LOOKS: dict[Severity, tuple[str, str, str]] = {
    "serious": ("alert-octagon", "error", "Serious"),
    "caution": ("alert", "warning", "Look at this"),
    "note": ("information-outline", "muted", "Taken for granted"),
}
"""Icon, colour and word; the shapes differ too, for colours alone do not tell everybody."""

TURN_S = 0.015
"""Sentences take a millisecond each to be said in another language."""

NO_PROJECT = "Open or make a project: its warnings appear here."
NOTHING = "Nothing to warn of. What the files, picks and figures give cause for appears here."
GO = "Click one, or press Enter on it, to go to its cause."
WAITING = "Estimating again; these are the warnings from before the change."


def count_words(concerns: Sequence[Concern]) -> str:
    """``2 serious, 3 to look at``, of what there is, in the user's language."""
    serious, caution, note = (
        sum(each.severity == key for each in concerns) for key in ("serious", "caution", "note")
    )
    words = (
        f"{serious} serious" if serious else "",
        f"{caution} to look at" if caution else "",
        f"{note} assumptions" if note else "",
    )
    return ", ".join(say(each) for each in words if each)


class WarningsPanel(QWidget):
    """The list, or why there is none."""

    followed = Signal(object)
    """The `Cause` that the user wants to see."""

    def __init__(self) -> None:
        super().__init__()
        self.concerns: tuple[Concern, ...] = ()
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
        self._kept: Concern | None = None
        self._said: dict[str, str] = {}
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
        self.concerns = ()
        self.list.clear()
        self._say(NO_PROJECT)

    def show_waiting(self) -> None:
        """The list is no longer that of the project: a result is on its way."""
        self.head.setText(say(WAITING))

    def show_concerns(self, concerns: Sequence[Concern]) -> None:
        """Show the list; what was current stays so where it still is there."""
        current = self.list.currentRow()
        kept = self.concerns[current] if 0 <= current < len(self.concerns) else None
        self.concerns = tuple(concerns)
        self.list.clear()
        self._kept = kept
        if not concerns:
            self._say(NOTHING)
            return
        self._fill()
        counts = count_words(concerns)
        self.head.setText(f"{counts[:1].upper()}{counts[1:]}. {say(GO)}")
        self._pages.setCurrentIndex(1)

    @property
    def is_filled(self) -> bool:
        """Whether every sentence stands in the list."""
        return self.list.count() == len(self.concerns)

    def _fill(self) -> None:
        """Say as many sentences as one does not notice, and the others in the next turn."""
        until = time.monotonic() + TURN_S
        said = self._said
        while not self.is_filled and time.monotonic() < until:
            concern = self.concerns[self.list.count()]
            if concern.text not in said:
                said[concern.text] = say_with_capital(concern.text)
            self.list.addItem(_item(concern, said[concern.text]))
            if concern == self._kept:
                self.list.setCurrentRow(self.list.count() - 1)
        if not self.is_filled:
            self._turn.start()
        elif len(said) > len(self.concerns):
            self._said = {each.text: said[each.text] for each in self.concerns}

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
        if 0 <= row < len(self.concerns):
            self.followed.emit(self.concerns[row].cause)


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


def _item(concern: Concern, text: str) -> QListWidgetItem:
    icon, colour, word = LOOKS[concern.severity]
    said = say(word)
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
        self.show_concerns(None)

    def show_concerns(self, concerns: Sequence[Concern] | None) -> None:
        """Count what is more than a note; None where no project is open."""
        self.setVisible(concerns is not None)
        told = [each for each in concerns or () if each.severity != "note"]
        worst: Severity = "note"
        if told:
            worst = "serious" if any(each.severity == "serious" for each in told) else "caution"
        icon, colour, _ = LOOKS[worst] if told else ("check-circle-outline", "done", "")
        self.setIcon(theme.icon(icon, theme.colour(colour).name()))
        words = (
            "1 warning" if len(told) == 1 else f"{len(told)} warnings" if told else "No warnings"
        )
        self.setText(say(words))
        counts = f"{count_words(concerns)}. " if concerns else ""
        self.setToolTip(f"{counts}{say('Click to see them all (F12)')}")
        self.setAccessibleName(say(words))
