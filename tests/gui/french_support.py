"""Collect the texts of a window, and find those that are still English."""

import re
from collections.abc import Iterator

from matplotlib.figure import Figure
from matplotlib.text import Text
from PySide6.QtCore import QAbstractItemModel, QAbstractListModel, QModelIndex, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QDoubleSpinBox,
    QGroupBox,
    QLabel,
    QLineEdit,
    QMenu,
    QPlainTextEdit,
    QTabBar,
    QWidget,
)

from tests.support.french_catalogue import FRENCH

FRENCH_TEXTS = {*FRENCH.values()}
_PIECE = re.compile(r"(\n|<br>|</?(?:p|h\d|ul|ol|li|table|tr|td|th)\b[^>]*>)")
_TAG = re.compile(r"<[^>]*>|&nbsp;|\S*/\S+")
"""Tags and paths."""
_ENGLISH = re.compile(r"\b(the|of|and|is|are|was|to|with|from|by|not|that|it|its)\b")
_ROLES = (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole)


def english(top: QWidget) -> set[str]:
    """English texts of a window: untranslated catalogue texts and texts with English words."""
    found = set()
    for text in texts(top):
        for piece in pieces(text):
            known = piece in FRENCH and piece not in FRENCH_TEXTS
            if known or _ENGLISH.search(_TAG.sub(" ", piece)):
                found.add(text)
    return found


def pieces(text: str) -> list[str]:
    """Split a text into its lines, paragraphs and cells."""
    return [bare for piece in _PIECE.split(text)[::2] if (bare := piece.strip(" "))]


def texts(top: QWidget) -> Iterator[str]:
    """Every text of a window, its actions and its widgets, visible or not."""
    for action in top.findChildren(QAction):
        yield from (action.text(), action.iconText(), action.toolTip(), action.statusTip())
    for widget in (top, *top.findChildren(QWidget)):
        yield from (widget.windowTitle(), widget.toolTip(), widget.statusTip())
        yield widget.accessibleDescription()
        yield from _of(widget)


def _of(widget: QWidget) -> Iterator[str]:
    if isinstance(widget, QLabel | QAbstractButton):
        yield widget.text()
    if isinstance(widget, QGroupBox | QMenu):
        yield widget.title()
    if isinstance(widget, QLineEdit):
        yield widget.placeholderText()
    if isinstance(widget, QAbstractSpinBox):
        yield widget.specialValueText()
    if isinstance(widget, QDoubleSpinBox):
        yield widget.suffix()
    if isinstance(widget, QPlainTextEdit):
        yield from (widget.toPlainText(), widget.placeholderText())
    if isinstance(widget, QTabBar):
        for k in range(widget.count()):
            yield from (widget.tabText(k), widget.tabToolTip(k))
    if isinstance(widget, QComboBox):
        yield from _cells(widget.model())
    if isinstance(widget, QAbstractItemView) and widget.model() is not None:
        yield from _cells(widget.model())
        yield from _heads(widget.model())
    if isinstance(figure := getattr(widget, "figure", None), Figure):
        for each in figure.findobj(Text):
            yield each.get_text()


def _cells(model: QAbstractItemModel) -> Iterator[str]:
    for row in range(model.rowCount(QModelIndex())):
        for column in range(_columns(model)):
            for role in _ROLES:
                yield _word(model.data(model.index(row, column), role))


def _heads(model: QAbstractItemModel) -> Iterator[str]:
    for side, count in (
        (Qt.Orientation.Horizontal, _columns(model)),
        (Qt.Orientation.Vertical, model.rowCount(QModelIndex())),
    ):
        for k in range(count):
            for role in _ROLES:
                yield _word(model.headerData(k, side, role))


def _columns(model: QAbstractItemModel) -> int:
    return 1 if isinstance(model, QAbstractListModel) else model.columnCount(QModelIndex())


def _word(value: object) -> str:
    return value if isinstance(value, str) else ""
