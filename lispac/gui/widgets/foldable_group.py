"""Group of widgets that can be folded."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QSizePolicy,
    QStyleOptionToolButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.language import gettext

ARROW_MARGIN_PX = 12
"""Width of a header beside its arrow and its text, pixels."""


class _Header(QToolButton):
    """Button with an arrow and a text, which is cut at its end if it is too long."""

    def initStyleOption(self, option: QStyleOptionToolButton) -> None:
        """Cut the text of the option; the style would cut it in the middle."""
        super().initStyleOption(option)
        width = self.width() - option.iconSize.width() - ARROW_MARGIN_PX
        option.text = option.fontMetrics.elidedText(
            self.text(), Qt.TextElideMode.ElideRight, max(width, 0)
        )


class FoldableGroup(QWidget):
    """Group with a heading that folds it and shows a summary of its settings.

    Parameters
    ----------
    title : in the user's language
    """

    folded = Signal(bool)

    def __init__(self, title: str, name: str, body: QWidget) -> None:
        super().__init__()
        self._title = title
        self.head = _Header()
        self.head.setObjectName(name)
        self.head.setCheckable(True)
        self.head.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.head.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.head.setStyleSheet(
            "QToolButton { border: none; font-weight: 600; padding: 3px 0; background: transparent;"
            f" text-align: left; }} QToolButton:hover, QToolButton:focus {{ color: {theme.ACCENT}; "
            "}"
        )
        self.head.toggled.connect(self._show)
        self.body = body
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.head)
        layout.addWidget(body)
        self.set_summary("")
        self._show(False)

    def set_summary(self, summary: str) -> None:
        """Show a summary of the settings in the header; if it is empty, show only the title."""
        text = gettext("{title}: {summary}", title=self._title, summary=summary)
        self.head.setText(text if summary else self._title)
        self.head.setToolTip(widgets.plain_tip(self.head.text()))

    def open(self, unfolded: bool = True) -> None:
        """Unfold or fold the group."""
        self.head.setChecked(unfolded)

    def _show(self, unfolded: bool) -> None:
        self.head.setArrowType(Qt.ArrowType.DownArrow if unfolded else Qt.ArrowType.RightArrow)
        self.body.setVisible(unfolded)
        self.folded.emit(not unfolded)
