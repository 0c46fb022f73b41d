"""Find texts of a window in metric units."""

import re
from collections.abc import Iterator

from matplotlib.figure import Figure
from matplotlib.text import Text
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QComboBox,
    QGroupBox,
    QLabel,
    QLineEdit,
    QTableView,
    QTabWidget,
    QWidget,
)

METRIC = re.compile(
    r"""\d[\s\u00a0]?(?:mm|cm|m)\b(?![²³'’-])    # 12.5 m
    |[(,\s](?:mm|cm|m)(?:/s)?(?:[),;.]|$)               # (mm), or: Height, m
    |\b(?:milli|centi)?metres?\b
    """,
    re.VERBOSE,
)
Role = Qt.ItemDataRole


def metric_words(window: QWidget) -> dict[str, set[str]]:
    """Return texts with a metric unit by the name of their widget or action."""
    found: dict[str, set[str]] = {}
    for name, text in _texts(window):
        if METRIC.search(re.sub(r"<[^>]*>|&nbsp;", " ", text)):
            found.setdefault(name, set()).add(text)
    return found


def _texts(window: QWidget) -> Iterator[tuple[str, str]]:
    for action in window.findChildren(QAction):
        for text in (action.text(), action.toolTip(), action.statusTip()):
            yield _name(action), text
    for widget in (window, *window.findChildren(QWidget)):
        name = _name(widget)
        for text in (
            widget.toolTip(), widget.statusTip(), widget.whatsThis(), widget.accessibleName(),
            widget.accessibleDescription(),
        ):  # fmt: skip
            yield name, text
        for text in _shown(widget):
            yield name, text


def _shown(widget: QWidget) -> Iterator[str]:
    if isinstance(widget, QLabel | QAbstractButton | QAbstractSpinBox):
        yield widget.text()
    elif isinstance(widget, QLineEdit):
        yield from (widget.text(), widget.placeholderText())
    elif isinstance(widget, QGroupBox):
        yield widget.title()
    elif isinstance(widget, QComboBox):
        yield from (widget.itemText(k) for k in range(widget.count()))
    elif isinstance(widget, QTabWidget):
        yield from (widget.tabText(k) for k in range(widget.count()))
    elif isinstance(widget, QTableView):
        yield from _of_table(widget)
    figure = getattr(widget, "figure", None)
    if isinstance(figure, Figure):
        yield from (text.get_text() for text in figure.findobj(Text))


def _of_table(table: QTableView) -> Iterator[str]:
    model = table.model()
    if model is None:
        return
    roles = (Role.DisplayRole, Role.ToolTipRole)
    for column in range(model.columnCount()):
        for role in roles:
            yield str(model.headerData(column, Qt.Orientation.Horizontal, role) or "")
        for row in range(model.rowCount()):
            yield from (str(model.index(row, column).data(role) or "") for role in roles)


def _name(thing: QWidget | QAction) -> str:
    """Return the name of an object or of its nearest named parent."""
    while thing is not None and not thing.objectName():
        thing = thing.parent()
    return "" if thing is None else thing.objectName()
