"""Label that is as high as its longest text, so that nothing below it moves."""

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QLabel, QSizePolicy


class ReservedLabel(QLabel):
    """Wrapped label whose height does not change with its text, nor when it is hidden.

    Parameters
    ----------
    role : role of labels in the style sheet
    texts : longest texts that the label shows, in the language of the window
    lines : number of lines to reserve, if more than the texts need
    """

    def __init__(
        self, role: str = "", name: str = "", *, texts: Sequence[str] = (), lines: int = 1
    ) -> None:
        super().__init__()
        self._lines = "\n".join(["0"] * lines)
        self._texts = (*texts, self._lines)
        self._heights: dict[tuple[int, str], int] = {}
        _style(self, role)
        self.setObjectName(name)
        # Set after the wrapping, which resets the policy
        policy = QSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
        policy.setHeightForWidth(True)
        policy.setRetainSizeWhenHidden(True)
        self.setSizePolicy(policy)

    def reserve(self, texts: Sequence[str]) -> None:
        """Use other longest texts."""
        self._texts = (*texts, self._lines)
        self._heights.clear()
        self.updateGeometry()

    def heightForWidth(self, width: int) -> int:
        """Height of the longest text, or of the present one if it is longer."""
        return max(super().heightForWidth(width), self._reserved_height(width))

    def sizeHint(self) -> QSize:
        """Size with the reserved height."""
        hint = super().sizeHint()
        return QSize(hint.width(), max(hint.height(), self._reserved_height(hint.width())))

    def _reserved_height(self, width: int) -> int:
        self.ensurePolished()
        key = width, self.font().key()
        if key not in self._heights:
            # Another label, since a text cannot be measured without showing it
            measured = QLabel()
            _style(measured, self.property("role"))
            measured.ensurePolished()
            heights = []
            for text in self._texts:
                measured.setText(text)
                heights.append(measured.heightForWidth(width))
            self._heights[key] = max(heights)
        return self._heights[key]


def _style(label: QLabel, role: str) -> None:
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setProperty("role", role)
    label.setWordWrap(True)
    label.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
    label.setIndent(0)  # by default, a label with a frame would be indented from its top
