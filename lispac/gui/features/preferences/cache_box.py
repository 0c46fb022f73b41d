"""Settings of the cache: folder, size, and a button to empty it."""

from pathlib import Path

from PySide6.QtCore import QLockFile
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QMessageBox, QVBoxLayout, QWidget

from lispac import caches
from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.project.recovery_copies import LOCK_NAME
from lispac.gui.widgets.error_box import exception_text
from lispac.language import N_, gettext

DEMO_OPEN = N_("The demo survey is open. Close it, then empty the cache.")


class CacheBox(QWidget):
    """Box to choose the folder of the cache, and to empty it at once."""

    def __init__(self) -> None:
        super().__init__()
        self._folder: Path | None = None
        self.place = widgets.label("", wrap=True, name="settings_cache")
        self.size = widgets.label("", "muted", name="settings_cache_size")
        self.message_label = widgets.label("", "error", wrap=True, name="settings_cache_message")
        self.choose = widgets.button(
            gettext("Choose…"), "settings_cache_choose",
            tip=gettext(
                "Choose another folder for the demo survey, compiled code and font lists. "
                "Projects and the contents of the former folder are not moved."
            ),
        )  # fmt: skip
        self.usual = widgets.button(
            gettext("Default folder"), "settings_cache_usual",
            tip=gettext("Use the cache folder of the system"),
        )  # fmt: skip
        self.empty = widgets.button(
            gettext("Empty cache…"), "settings_cache_empty",
            tip=gettext("Delete files that the program can create again"),
        )  # fmt: skip
        row = QHBoxLayout()
        for each in (self.choose, self.usual, self.empty):
            each.setAutoDefault(False)
            row.addWidget(each)
        row.addWidget(self.size)
        row.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.place)
        layout.addLayout(row)
        layout.addWidget(self.message_label)
        self.choose.clicked.connect(self._choose)
        self.usual.clicked.connect(lambda: self.show_folder(None))
        self.empty.clicked.connect(self._empty_cache)
        self.show_folder(None)

    @property
    def folder(self) -> Path | None:
        """The chosen folder; None for the default one."""
        return self._folder

    def show_folder(self, folder: Path | None) -> None:
        """Show a folder and the size of its cache; None for the default folder."""
        self._folder = folder
        place = caches.cache_folder_in(folder)
        self.place.setText(str(place))
        self.usual.setEnabled(folder is not None)
        self._show_size(place)
        self._show_problem("")

    def choose_folder(self, folder: Path) -> None:
        """Choose a folder, or show why it cannot be used."""
        try:
            caches.require_writable(folder)
        except InputError as error:
            self._show_problem(exception_text(error))
        else:
            self.show_folder(folder)

    def _choose(self) -> None:
        start = self._folder or caches.default_folder()
        found = QFileDialog.getExistingDirectory(self, gettext("Folder for the cache"), str(start))
        if found:
            self.choose_folder(Path(found))

    def _empty_cache(self) -> None:
        place = caches.cache_folder_in(self._folder)
        lock = QLockFile(str(place / caches.DEMO / LOCK_NAME))
        lock.setStaleLockTime(0)
        if not lock.tryLock(0) and lock.error() == QLockFile.LockError.LockFailedError:
            self._show_problem(gettext(DEMO_OPEN))
            return
        lock.unlock()
        if not self._confirm_deletion(place):
            return
        try:
            caches.empty_cache(place)
        except InputError as error:
            self._show_problem(exception_text(error))
        else:
            self._show_problem("")
        self._show_size(place)

    def _confirm_deletion(self, place: Path) -> bool:
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC", gettext("Empty the cache?"),
            QMessageBox.StandardButton.Cancel, self,
        )  # fmt: skip
        box.setObjectName("empty_cache")
        box.setInformativeText(
            gettext(
                "This deletes compiled code and the demo survey with its picked targets. Projects, "
                "settings and sensors are kept."
            )
        )
        remove = box.addButton(gettext("Empty cache"), QMessageBox.ButtonRole.DestructiveRole)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        return chosen is remove

    def _show_size(self, place: Path) -> None:
        found = caches.cache_size(place)
        self.size.setText(
            gettext("{size:mb.1} MB", size=found) if found else gettext("The cache is empty")
        )
        self.empty.setEnabled(found > 0)

    def _show_problem(self, text: str) -> None:
        self.message_label.setText(text)
        self.message_label.setVisible(bool(text))
