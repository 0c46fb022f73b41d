"""Where Tab leads in the window: to what is in sight, or comes into sight.

Qt keeps a dock that lies behind another visible and only moves it away, so that its fields would
take keys unseen. An area that scrolls shows no focus, and scrolls by the keys of what is in it.
"""

from typing import TypeVar

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QScrollArea, QWidget

Kind = TypeVar("Kind", bound=QWidget)
Reason = Qt.FocusReason


def go_on(window: QMainWindow, forward: bool) -> bool:
    """Give the focus to the next widget, or the one before; whether there is one."""
    found = _next(window, forward)
    if found is None:
        return False
    # Chosen before it is given: a list that is only passed would select its first row
    found.setFocus(Reason.TabFocusReason if forward else Reason.BacktabFocusReason)
    _scroll_to(found)
    return True


def _next(window: QMainWindow, forward: bool) -> QWidget | None:
    step = QWidget.nextInFocusChain if forward else QWidget.previousInFocusChain
    start = window.focusWidget() or window
    each = step(start)
    while each != start:
        if _is_stop(each, window):
            return each
        each = step(each)
    return None


def _is_stop(widget: QWidget, window: QMainWindow) -> bool:
    """Whether Tab stops there: as Qt has it, but not behind another dock."""
    return (
        _takes_tab(widget)
        and widget.isVisible()
        and widget.window() == window
        and _is_in_front(_above(widget, QDockWidget))
        and not (isinstance(widget, QScrollArea) and _is_led_through(widget))
    )


def _takes_tab(widget: QWidget) -> bool:
    policy = widget.focusPolicy() & Qt.FocusPolicy.TabFocus
    return bool(policy) and widget.focusProxy() is None and widget.isEnabled()


def _is_in_front(dock: QWidget | None) -> bool:
    return dock is None or not dock.visibleRegion().isEmpty()


def _is_led_through(area: QScrollArea) -> bool:
    """Whether there is nothing to scroll, or Tab stops within: its keys scroll the area."""
    bars = area.verticalScrollBar(), area.horizontalScrollBar()
    return not any(bar.maximum() for bar in bars) or any(
        _takes_tab(each) and each.isVisible() for each in area.widget().findChildren(QWidget)
    )


def _scroll_to(widget: QWidget) -> None:
    area = _above(widget, QScrollArea)
    while area is not None:
        area.ensureWidgetVisible(widget)
        area = _above(area, QScrollArea)


def _above(widget: QWidget, kind: type[Kind]) -> Kind | None:
    above = widget.parentWidget()
    while above is not None and not isinstance(above, kind):
        above = above.parentWidget()
    return above
