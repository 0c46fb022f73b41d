"""Dialogues about the report."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QEvent, QObject, Qt, QUrl
from PySide6.QtGui import QDesktopServices, QImageReader, QKeyEvent, QPaintEvent, QPixmap
from PySide6.QtWidgets import (
    QDialog,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.appearance import theme
from lispac.gui.features.report.actions import ACTIONS
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.identity import Identity
from lispac.language import N_, gettext

REPORT_FILTERS = {
    "PDF (*.pdf)": ".pdf",
    "HTML (*.html)": ".html",
    N_("Results as JSON (*.json)"): ".json",
    N_("Tables as CSV in a ZIP file (*.zip)"): ".zip",
}
"""Ending of each file type of the report."""


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


class ReportDialogs(Questions):
    """Dialogues about the report."""

    def report_file(self, start: Path) -> Path | None:
        """Ask for the file of the report; its suffix, or the chosen filter, sets the format."""
        filters = {gettext(text): ending for text, ending in REPORT_FILTERS.items()}
        saved = self.file_to_save(dialog_title(ACTIONS["report"]), start, filters)
        return None if saved is None else saved[0]

    def pdf_file(self, start: Path) -> Path | None:
        """Ask for the PDF file of the previewed report."""
        title = gettext("Save the report as PDF")
        saved = self.file_to_save(title, start, {"PDF (*.pdf)": ".pdf"})
        return None if saved is None else saved[0]

    def preview(self, pages: Sequence[bytes], save: Callable[[], str]) -> None:
        """Show the pages of the report; ``save`` saves them and returns a text about it."""
        run_dialog(PreviewDialog(pages, save, self.parent))

    def report_template(self, start: Path) -> Path | None:
        """Ask for the report template of a company."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, gettext("Open report template"), str(start),
            gettext("Report template (*.toml)"),
        )  # fmt: skip
        return Path(name) if name else None

    def open_file(self, path: Path) -> bool:
        """Open a file in the program that the system uses for it; False if there is none."""
        return QDesktopServices.openUrl(QUrl.fromLocalFile(str(path)))

    def identity(
        self,
        identity: Identity,
        dates: Callable[[], str] | None,
        companies: Mapping[str, Mapping[str, str]],
        suggestions: Mapping[str, str],
        missing: Sequence[str] = (),
        equipment: Mapping[str, Sequence[str]] | None = None,
        continues: bool = False,
    ) -> Identity | None:
        """Ask for the details of the report; the parameters are those of `IdentityDialog`."""
        dialog = IdentityDialog(
            identity, dates, companies, suggestions, self.parent, missing=missing,
            equipment=equipment, continues=continues,
        )  # fmt: skip
        return dialog.identity if run_dialog(dialog) else None
