"""Preview of the report: its pages as they are printed."""

from collections.abc import Callable, Sequence

from PySide6.QtCore import QBuffer, QByteArray, QEvent, QObject, Qt
from PySide6.QtGui import QImageReader, QKeyEvent, QPaintEvent, QPixmap
from PySide6.QtWidgets import QDialog, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.language import gettext


class PreviewDialog(QDialog):
    """Dialogue with the pages of the report, which can be saved as PDF.

    Parameters
    ----------
    pages : pictures of the pages, PNG
    save : function that asks for a file, saves it, and returns a text; empty if nothing was saved
    """

    def __init__(
        self, pages: Sequence[bytes], save: Callable[[], str], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("preview_dialog")
        self.setWindowTitle(gettext("Preview of the report"))
        self._save = save
        self._pages = [_Page(data, k + 1, self.devicePixelRatioF()) for k, data in enumerate(pages)]
        desk = QWidget()
        desk.setStyleSheet(f"background: {theme.DESK}")
        stack = QVBoxLayout(desk)
        stack.setContentsMargins(16, 16, 16, 16)
        stack.setSpacing(16)
        for page in self._pages:
            stack.addWidget(page, 0, Qt.AlignmentFlag.AlignHCenter)
        self.area = QScrollArea()
        self.area.setObjectName("preview_pages")
        self.area.setWidgetResizable(True)
        self.area.setWidget(desk)
        self.area.installEventFilter(self)
        self.place = widgets.label("", "muted", name="preview_place")
        self.message_label = widgets.label("", "muted", name="preview_message")
        keep = widgets.button(
            gettext("Save as PDF…"), "preview_save", icon="content-save", primary=True
        )
        keep.setAutoDefault(False)
        keep.clicked.connect(self._save_pdf)
        close = widgets.button(gettext("Close"), "preview_close")
        close.setAutoDefault(False)
        close.clicked.connect(self.accept)
        row = QHBoxLayout()
        row.setSpacing(theme.SPACING)
        row.addWidget(self.place)
        row.addWidget(self.message_label, 1)
        row.addWidget(keep)
        row.addWidget(close)
        layout = widgets.vertical_layout(self, 12)
        layout.addWidget(self.area, 1)
        layout.addLayout(row)
        bar = self.area.verticalScrollBar()
        bar.valueChanged.connect(self._show_page_number)
        bar.rangeChanged.connect(self._show_page_number)
        widest = max((page.sizeHint().width() for page in self._pages), default=600)
        screen = self.screen().availableGeometry()
        self.resize(min(widest + 80, screen.width()), min(1000, screen.height() - 60))
        self.area.setFocus()
        self._show_page_number()

    @property
    def page(self) -> int:
        """Number of the page at the centre of the visible area, counted from 1."""
        middle = self.area.verticalScrollBar().value() + self.area.viewport().height() / 2
        above = [k for k, page in enumerate(self._pages) if page.geometry().top() <= middle]
        return above[-1] + 1 if above else 1

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Go to the first or last page with Home and End."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            bar = self.area.verticalScrollBar()
            ends = {Qt.Key.Key_Home: bar.minimum(), Qt.Key.Key_End: bar.maximum()}
            if event.key() in ends:
                bar.setValue(ends[event.key()])
                return True
        return super().eventFilter(watched, event)

    def _save_pdf(self) -> None:
        if text := self._save():
            self.message_label.setText(text)

    def _show_page_number(self) -> None:
        self.place.setText(
            gettext("Page {page:n} of {total:n}", page=self.page, total=len(self._pages))
        )


class _Page(QLabel):
    """Page of the report, whose picture is decoded when it is first visible."""

    def __init__(self, data: bytes, number: int, ratio: float) -> None:
        super().__init__()
        self.setObjectName(f"preview_page_{number}")
        self.setAccessibleName(gettext("Page {page:n}", page=number))
        self._data, self._ratio = QByteArray(data), ratio
        buffer = QBuffer(self._data)
        self.setFixedSize(QImageReader(buffer, QByteArray(b"PNG")).size() / ratio)

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.pixmap().isNull():
            pixmap = QPixmap()
            pixmap.loadFromData(self._data, "PNG")
            pixmap.setDevicePixelRatio(self._ratio)
            self.setPixmap(pixmap)
        super().paintEvent(event)
