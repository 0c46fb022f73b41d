"""Where the cache lies, how large it is, and emptying it."""

from pathlib import Path

from PySide6.QtCore import QLockFile
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QMessageBox, QVBoxLayout, QWidget

from lispac import caches
from lispac.errors import InputError
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.safekeeping import LOCK_NAME

OPEN = "The demo survey is open; close it, then empty the cache."


class CacheBox(QWidget):
    """The choice counts when the settings are kept; emptying counts at once."""

    def __init__(self) -> None:
        super().__init__()
        self._folder: Path | None = None
        self.place = widgets.label("", wrap=True, name="settings_cache")
        self.size = widgets.label("", "muted", name="settings_cache_size")
        self.said = widgets.label("", "error", wrap=True, name="settings_cache_said")
        self.choose = widgets.button(
            "Choose…", "settings_cache_choose",
            tip="Another folder for the demo survey, compiled code and lists of fonts; projects "
            "stay where they are, and what lies in the former folder too",
        )  # fmt: skip
        self.usual = widgets.button(
            "Usual folder", "settings_cache_usual", tip="The folder for caches of the system"
        )
        self.empty = widgets.button(
            "Empty the cache…", "settings_cache_empty",
            tip="Remove what the program can make again",
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
        layout.addWidget(self.said)
        self.choose.clicked.connect(self._choose)
        self.usual.clicked.connect(lambda: self.show_folder(None))
        self.empty.clicked.connect(self._empty)
        self.show_folder(None)

    @property
    def folder(self) -> Path | None:
        """The folder that is chosen; None for the usual one."""
        return self._folder

    def show_folder(self, folder: Path | None) -> None:
        """Show another place and what lies there."""
        self._folder = folder
        place = caches.place_in(folder)
        self.place.setText(str(place))
        self.usual.setEnabled(folder is not None)
        self._show_size(place)
        self._say("")

    def take(self, folder: Path) -> None:
        """Choose a folder, or say why it does not serve."""
        try:
            caches.require_writable(folder)
        except InputError as error:
            self._say(str(error))
        else:
            self.show_folder(folder)

    def _choose(self) -> None:
        start = self._folder or caches.usual_folder()
        found = QFileDialog.getExistingDirectory(self, say("Folder for the cache"), str(start))
        if found:
            self.take(Path(found))

    def _empty(self) -> None:
        place = caches.place_in(self._folder)
        lock = QLockFile(str(place / caches.DEMO / LOCK_NAME))
        lock.setStaleLockTime(0)
        if not lock.tryLock(0) and lock.error() == QLockFile.LockError.LockFailedError:
            self._say(OPEN)
            return
        lock.unlock()
        if not self._sure(place):
            return
        try:
            caches.empty(place)
        except InputError as error:
            self._say(str(error))
        else:
            self._say("")
        self._show_size(place)

    def _sure(self, place: Path) -> bool:
        box = widgets.MessageBox(
            QMessageBox.Icon.Question, "LISPAC", say("Empty the cache?"),
            QMessageBox.StandardButton.Cancel, self,
        )  # fmt: skip
        box.setObjectName("empty_cache")
        box.setInformativeText(
            say(
                "The demo survey goes, with what was picked in it, and code that is compiled again "
                "when it is needed. Projects, settings and sensors stay."
            )
        )
        remove = box.addButton(say("Empty"), QMessageBox.ButtonRole.DestructiveRole)
        box.exec()
        chosen = box.clickedButton()
        box.deleteLater()
        return chosen is remove

    def _show_size(self, place: Path) -> None:
        found = caches.size(place)
        self.size.setText(say(f"{found / 1e6:,.1f} MB" if found else "empty"))
        self.empty.setEnabled(found > 0)

    def _say(self, words: str) -> None:
        self.said.setText(say(words))
        self.said.setVisible(bool(words))
