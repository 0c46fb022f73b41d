"""Tab order of the window, limited to visible widgets, and Enter on focused buttons.

In Qt, a dock hidden behind another one counts as visible, so that its fields would receive the
focus unseen. A scroll area does not show the focus, and can be scrolled with the keys from the
widgets in it. Outside dialogues, Qt presses a focused button with Space only and ignores Enter.
"""

from collections.abc import Iterable
from itertools import pairwise
from typing import TypeVar

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QDockWidget,
    QMainWindow,
    QPushButton,
    QScrollArea,
    QTabBar,
    QToolButton,
    QWidget,
)

from lispac.gui.widgets.number_input import commit_focused_field

WidgetType = TypeVar("WidgetType", bound=QWidget)
Reason = Qt.FocusReason
ENTER_KEYS = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


def focus_next(window: QMainWindow, forward: bool) -> bool:
    """Move the focus to the next or previous widget; return whether there is one.

    The typed value is committed first, since widgets may be replaced or disabled by it.
    """
    commit_focused_field()
    found = _next_stop(window, forward)
    if found is None:
        return False
    # Only the final widget gets the focus: a list would select its first row
    found.setFocus(Reason.TabFocusReason if forward else Reason.BacktabFocusReason)
    _scroll_to(found)
    return True


def focus_dock_content(dock: QDockWidget) -> None:
    """Move the focus to the first widget of a panel that accepts it."""
    window = dock.parentWidget()
    each = dock.nextInFocusChain()
    while each != dock and not (dock.isAncestorOf(each) and _is_stop(each, window)):
        each = each.nextInFocusChain()
    if each != dock:
        each.setFocus(Reason.TabFocusReason)


def set_tab_order(first: QWidget, others: Iterable[QWidget]) -> None:
    """Set the tab order from one widget to others that were created later."""
    for before, after in pairwise([first, *others]):
        QWidget.setTabOrder(before, after)


def press_focused_button(window: QMainWindow, event: QKeyEvent) -> bool:
    """Press the focused button on Enter; return whether it was pressed."""
    focused = window.focusWidget()
    pressed = (
        event.key() in ENTER_KEYS
        and not event.isAutoRepeat()
        and isinstance(focused, QPushButton | QToolButton)
        and focused.isEnabled()
    )
    if pressed:
        focused.click()
    return pressed


def _next_stop(window: QMainWindow, forward: bool) -> QWidget | None:
    step = QWidget.nextInFocusChain if forward else QWidget.previousInFocusChain
    start = window.focusWidget() or window
    each = step(start)
    while each != start:
        if _is_stop(each, window):
            return each
        each = step(each)
    return None


def _is_stop(widget: QWidget, window: QMainWindow) -> bool:
    """Whether Tab moves the focus to a widget: as in Qt, but not in a hidden dock."""
    return (
        _takes_tab(widget)
        and widget.isVisible()
        and widget.window() == window
        and _is_in_front(_ancestor(widget, QDockWidget))
        # Qt keeps the tab bars of closed docks, outside the window
        and not (isinstance(widget, QTabBar) and widget.visibleRegion().isEmpty())
        and not (isinstance(widget, QScrollArea) and _needs_no_focus(widget))
    )


def _takes_tab(widget: QWidget) -> bool:
    policy = widget.focusPolicy() & Qt.FocusPolicy.TabFocus
    return bool(policy) and widget.focusProxy() is None and widget.isEnabled()


def _is_in_front(dock: QWidget | None) -> bool:
    return dock is None or not dock.visibleRegion().isEmpty()


def _needs_no_focus(area: QScrollArea) -> bool:
    """Whether an area needs no focus: nothing to scroll, or it contains tab stops."""
    bars = area.verticalScrollBar(), area.horizontalScrollBar()
    return not any(bar.maximum() for bar in bars) or any(
        _takes_tab(each) and each.isVisible() for each in area.widget().findChildren(QWidget)
    )


def _scroll_to(widget: QWidget) -> None:
    area = _ancestor(widget, QScrollArea)
    while area is not None:
        area.ensureWidgetVisible(widget)
        area = _ancestor(area, QScrollArea)


def _ancestor(widget: QWidget, kind: type[WidgetType]) -> WidgetType | None:
    parent = widget.parentWidget()
    while parent is not None and not isinstance(parent, kind):
        parent = parent.parentWidget()
    return parent
