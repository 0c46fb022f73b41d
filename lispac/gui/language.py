"""What the window shows, in the language of the user.

Texts are made in English, here and in the core, and said in the user's language where they are
shown: `say` goes around what a widget is given. The language changes while the program runs: the
window is made anew then, around the same document.
"""

import re
from collections.abc import Iterable
from datetime import datetime
from typing import TYPE_CHECKING

from PySide6.QtCore import QLibraryInfo, QLocale, QTranslator
from PySide6.QtWidgets import QApplication

from lispac.language import N_, gettext, is_translated, short_datetime, use_language
from lispac.messages import Message
from lispac.project import Project
from lispac.reverse_translation.catalogue import catalogue_of
from lispac.reverse_translation.messages import translated_text
from lispac.reverse_translation.translation import Translator

if TYPE_CHECKING:
    from lispac.design.plan import Plan

_PIECE = re.compile(r"(\n|<br>|</?(?:p|h\d|ul|ol|li|table|tr|td|th)\b[^>]*>)")
_own = Translator(catalogue_of("en"), spoken_numbers=True)
_of_project: frozenset[str] = frozenset()
_of_plan: frozenset[str] = frozenset()
_qt: list[QTranslator] = []

LACKING = {
    "QFileDialog": (N_("&Look in:"), N_("Files of &type:")),
    "QAbstractFileIconProvider": (
        N_("Drive"), N_("Folder"), N_("File Folder"), N_("Shortcut"), N_("Alias"), N_("Unknown"),
    ),
}  # fmt: skip
"""Texts of Qt's file dialogue that its own translation has not, by their contexts."""


class _Rest(QTranslator):
    """Says what Qt's own translation lacks; it is asked after that one."""

    def isEmpty(self) -> bool:
        """Qt asks none that is."""
        return False

    def translate(
        self, context: str, source: str, disambiguation: str | None = None, n: int = -1
    ) -> str | None:
        """The text in the user's language; None where it is not one of these."""
        return gettext(source) if source in LACKING.get(context, ()) else None


def speak(code: str) -> None:
    """Use a language from now on, for our texts, for those of Qt and for numbers typed in.

    Raises
    ------
    InputError
        Where the language is not known.
    """
    global _own
    _own = Translator(catalogue_of(code), _own.names, spoken_numbers=True)
    use_language(code)
    # English as numbers are written in files and reports, with a point and no grouping by habit
    QLocale.setDefault(QLocale(code) if code != "en" else QLocale.c())
    application = QApplication.instance()
    if application is None:
        return
    while _qt:
        application.removeTranslator(_qt.pop())
    if code == "en":
        return
    qtbase, folder = QTranslator(application), QLibraryInfo.LibraryPath.TranslationsPath
    qtbase.load(f"qtbase_{code}", QLibraryInfo.path(folder))
    _qt.extend((_Rest(application), qtbase))
    for each in _qt:  # the last is asked first
        application.installTranslator(each)


def language() -> str:
    """Code of the language in use."""
    return _own.catalogue.code


def leave_alone(project: Project | None) -> None:
    """Names of the project are no words: they stay as they are."""
    global _of_project
    _of_project = frozenset(() if project is None else _names(project))
    _own.names = _of_project | _of_plan


def leave_plan_alone(plan: "Plan") -> None:
    """Nor are the names of the targets and lines of the plan that is designed."""
    global _of_plan
    courses = plan.courses if plan.targets else ()
    _of_plan = frozenset(each.name for each in (*plan.targets, *courses))
    _own.names = _of_project | _of_plan


def _names(project: Project) -> Iterable[str]:
    yield project.name
    for line in project.lines:
        yield from (line.name, line.path.name)
    for path in (project.trajectory, project.accuracy):
        if path is not None:
            yield path.name
    for target in project.targets:
        yield target.name


def say(text: str) -> str:
    """The text in the user's language; names, and what is not known, stay as they are."""
    if not text or language() == "en" or is_translated(text):
        return text
    if "\n" in text and (whole := _own.with_its_lines(text)) is not None:
        return whole
    return "".join(piece if k % 2 else _said(piece) for k, piece in enumerate(_PIECE.split(text)))


def say_message(message: Message) -> str:
    """Text of a message in the user's language."""
    return translated_text(message, say)


def say_with_capital(text: str) -> str:
    """The text, which begins as large as in English: with a file's name, it may not."""
    said = say(text)
    return f"{said[:1].upper()}{said[1:]}" if text[:1].isupper() else said


def say_sentences(texts: Iterable[str]) -> list[str]:
    """Phrases that begin small and end without a full stop, as sentences."""
    return [f"{said[:1].upper()}{said[1:].rstrip('.')}." for said in map(say, texts)]


def pieces(text: str) -> list[str]:
    """The parts of a text that are said by themselves: its lines, paragraphs and cells."""
    return [bare for piece in _PIECE.split(text)[::2] if (bare := piece.strip(" "))]


def _said(piece: str) -> str:
    bare = piece.strip(" ")
    return piece.replace(bare, _own.cell(bare)) if bare else piece


def say_moment(seconds: float) -> str:
    """A time of this computer, seconds since 1970, as the user's language writes it."""
    return short_datetime(datetime.fromtimestamp(seconds))


def say_all(texts: Iterable[str]) -> list[str]:
    """Each of the texts in the user's language."""
    return [say(each) for each in texts]


def unsaid() -> tuple[str, ...]:
    """Texts that stayed English so far, for the tests."""
    return _own.unknown
