"""Language of the window: of the message catalogues, of the texts of Qt and of typed numbers.

The language can be changed while the program runs; the window is then rebuilt with the same
document.
"""

from datetime import datetime

from PySide6.QtCore import QLibraryInfo, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

from lispac.language import N_, gettext, short_datetime, use_language

_qt_translators: list[QTranslator] = []

TEXTS_MISSING_IN_QT = {
    "QFileDialog": (N_("&Look in:"), N_("Files of &type:")),
    "QAbstractFileIconProvider": (
        N_("Drive"), N_("Folder"), N_("File Folder"), N_("Shortcut"), N_("Alias"), N_("Unknown"),
    ),
}  # fmt: skip
"""Texts of the file dialogue of Qt that are missing in its translation, by context."""


class _MissingTexts(QTranslator):
    """Translator for the texts that Qt's own translation lacks."""

    def isEmpty(self) -> bool:
        """Return False, since Qt ignores empty translators."""
        return False

    def translate(
        self, context: str, source: str, disambiguation: str | None = None, n: int = -1
    ) -> str | None:
        """Text in the user's language; None if it is not one of these texts."""
        return gettext(source) if source in TEXTS_MISSING_IN_QT.get(context, ()) else None


def set_language(code: str) -> None:
    """Use a language for the texts of LISPAC and Qt, and for numbers that are typed.

    Raises
    ------
    ValueError
        If the language is not known.
    """
    use_language(code)
    # For English, numbers as in files and reports: decimal point, no grouping
    QLocale.setDefault(QLocale(code) if code != "en" else QLocale.c())
    application = QApplication.instance()
    if application is None:
        return
    while _qt_translators:
        application.removeTranslator(_qt_translators.pop())
    if code == "en":
        return
    qtbase, folder = QTranslator(application), QLibraryInfo.LibraryPath.TranslationsPath
    qtbase.load(f"qtbase_{code}", QLibraryInfo.path(folder))
    _qt_translators.extend((_MissingTexts(application), qtbase))
    for each in _qt_translators:  # Qt searches the last one first
        application.installTranslator(each)


def local_datetime(seconds: float) -> str:
    """Text of a local time, seconds since 1970, in the language of the window."""
    return short_datetime(datetime.fromtimestamp(seconds))
