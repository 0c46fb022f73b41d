"""Colours, fonts and the theme of the window, light or dark.

``theme.TEXT``, ``theme.MUTED`` and so on are the colours of the scheme in use (`Scheme.text`,
`Scheme.muted`): they are looked up whenever they are read, so a module reads them where it paints
and never keeps one under a name of its own.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from typing import TYPE_CHECKING

import qtawesome
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QIcon, QPixmap
from PySide6.QtWidgets import QApplication, QStyleFactory

from lispac.gui.schemes import LIGHT, SCHEMES, Scheme
from lispac.gui.style import FRAMED, framed, palette, rules

if TYPE_CHECKING:
    from lispac.gui.viewport.base import Colour

TARGET_COLOUR: "Colour" = (220, 20, 90)
VALIDATION_COLOUR: "Colour" = (130, 84, 232)
CANDIDATE_COLOUR: "Colour" = (255, 196, 0)
UNUSED_COLOUR: "Colour" = (130, 138, 146)
"""In the view on both grounds."""

SPACE = 8
"""Pixels between neighbours; margins of a panel are twice that."""

_used: Scheme = LIGHT


def __getattr__(name: str) -> str:
    """``theme.TEXT`` is the text colour of the scheme in use."""
    if name.isupper():
        value = getattr(_used, name.lower(), None)
        if isinstance(value, str):
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def scheme() -> Scheme:
    """The scheme in use."""
    return _used


def colour(name: str, opacity: float = 1.0) -> QColor:
    """A colour of the scheme in use by the name of its field, 0 to 1 opaque."""
    made = QColor(getattr(_used, name))
    made.setAlphaF(opacity)
    return made


def rgb(name: str) -> "Colour":
    """The same for the view."""
    red, green, blue, _ = colour(name).getRgb()
    return red, green, blue


@contextmanager
def on_paper() -> Iterator[None]:
    """Light for a while: what is saved, copied or printed goes onto white paper."""
    global _used
    before, _used = _used, LIGHT
    try:
        yield
    finally:
        _used = before


def line_colours(lines: Sequence[str]) -> dict[str, "Colour"]:
    """A colour for each line, by its place in the project."""
    return {line: _used.lines[k % len(_used.lines)] for k, line in enumerate(lines)}


def swatch(colour: "Colour", size: int = 12) -> QIcon:
    """A filled square of that colour."""
    pixmap = QPixmap(size, size)
    pixmap.fill(QColor(*colour))
    return QIcon(pixmap)


LIGHTS = {
    "good": ("check-circle", "done"), "doubtful": ("alert-circle", "doubtful"),
    "poor": ("close-circle", "error"),
}  # fmt: skip
"""Symbols of quality; they differ in shape too, for colour-blind users."""
PICTURES_PX = (16, 20, 24, 28, 32, 48, 64)
"""So that there is one for each scaling of the screen."""


def light(which: str) -> QIcon:
    """Colour and symbol of a quality: good, doubtful or poor."""
    name, said = LIGHTS[which]
    return _painted(name, getattr(_used, said))


@cache
def _painted(name: str, colour: str) -> QIcon:
    """An icon as pictures: a table shows a hundred, and a letter of a font is painted each time."""
    written = icon(name, colour)
    pictures = QIcon()
    for size in PICTURES_PX:
        pictures.addPixmap(written.pixmap(QSize(size, size), 1.0))
    return pictures


def icon(name: str, colour: str = "") -> QIcon:
    """An icon of the Material Design set by its name, in the colour of the text or another."""
    return qtawesome.icon(
        f"mdi6.{name}", color=colour or _used.text, color_disabled=_used.disabled_icon
    )


def tabular(font: QFont, *, bold: bool = False) -> QFont:
    """The same font with digits of one width, for columns of numbers."""
    numbers = QFont(font)
    numbers.setFeature(QFont.Tag("tnum"), 1)
    numbers.setBold(bold)
    return numbers


def system_is_dark(application: QApplication) -> bool:
    """Whether the theme of the system is dark; light if it has none."""
    return application.styleHints().colorScheme() == Qt.ColorScheme.Dark


def wanted(application: QApplication, choice: str) -> Scheme:
    """The scheme of a choice, which may leave it to the system."""
    if choice == "system":
        return SCHEMES["dark" if system_is_dark(application) else "light"]
    return SCHEMES[choice]


def apply_theme(application: QApplication, choice: str = "light") -> None:
    """Dress the application: Fusion style, palette and rules of a scheme.

    Parameters
    ----------
    choice : one of `settings.THEMES`
    """
    global _used
    asked = {"light": Qt.ColorScheme.Light, "dark": Qt.ColorScheme.Dark}
    # The frame of the window and the system's own dialogues follow.
    application.styleHints().setColorScheme(asked.get(choice, Qt.ColorScheme.Unknown))
    _used = wanted(application, choice)
    if application.styleSheet() == rules(_used):
        return
    application.setStyle(QStyleFactory.create("Fusion"))
    application.setPalette(palette(_used))
    for name in FRAMED:
        application.setPalette(framed(_used), name)
    application.setFont(_font(application.font()))
    application.setStyleSheet(rules(_used))


@contextmanager
def undressed() -> Iterator[None]:
    """Without the rules while a window is put together, and with them in one go after that.

    Qt would apply them anew to all that a widget holds whenever it is put into another one.
    """
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    sheet = application.styleSheet()
    application.setStyleSheet("")
    try:
        yield
    finally:
        application.setStyleSheet(sheet)


def _font(default: QFont) -> QFont:
    families = set(QFontDatabase.families())
    wanted = ("Segoe UI", "SF Pro Text", "Inter", "Noto Sans", "Open Sans", "DejaVu Sans")
    family = next((name for name in wanted if name in families), default.family())
    font = QFont(family)
    font.setPixelSize(13)
    return font
