"""Completion of typed texts with a list that closes at a click beside it."""

from collections.abc import Iterable

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QCompleter, QLineEdit


class Completer(QCompleter):
    """Completer of a field; a click beside its list goes to the widget under the mouse.

    `QCompleter` only closes its list at such a click, and the next typed text would get into the
    field that the user has left.
    """

    def __init__(self, texts: Iterable[str], field: QLineEdit) -> None:
        super().__init__(list(texts), field)
        self.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        field.setCompleter(self)
        popup = self.popup()
        popup.setAttribute(Qt.WidgetAttribute.WA_NoMouseReplay)  # else twice on some systems
        popup.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Close the list at a click beside it, and repeat the click."""
        popup = self.popup()
        if (
            watched is popup
            and isinstance(event, QMouseEvent)
            and event.type() == QEvent.Type.MouseButtonPress
            and not popup.rect().contains(popup.mapFromGlobal(event.globalPosition().toPoint()))
        ):
            popup.hide()
            press = event.clone()
            QTimer.singleShot(0, self, lambda: _press_below(press))
            return True
        return super().eventFilter(watched, event)


def _press_below(press: QMouseEvent) -> None:
    """Send a press of the mouse to the widget at its position."""
    place = press.globalPosition()
    widget = QApplication.widgetAt(place.toPoint())
    modal = QApplication.activeModalWidget()
    if widget is None or (modal is not None and widget.window() is not modal):
        return
    if press.button() == Qt.MouseButton.LeftButton and (
        widget.focusPolicy() & Qt.FocusPolicy.ClickFocus
    ):
        widget.setFocus(Qt.FocusReason.MouseFocusReason)
    QCoreApplication.postEvent(
        widget,
        QMouseEvent(
            press.type(), widget.mapFromGlobal(place), place, press.button(), press.buttons(),
            press.modifiers(),
        ),
    )  # fmt: skip
