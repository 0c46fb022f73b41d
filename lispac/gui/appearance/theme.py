"""Colours, fonts and icons of the window, light or dark.

``theme.TEXT``, ``theme.MUTED`` and so on are the colours of the scheme in use (`ColourScheme.text`,
`ColourScheme.muted`). They change with the scheme, so modules must read them when they paint and
must not store or import them by name.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache

import qtawesome
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QIcon, QPixmap
from PySide6.QtWidgets import QApplication, QStyleFactory

from lispac.gui.appearance.colour_schemes import LIGHT_SCHEME, SCHEMES, Colour, ColourScheme
from lispac.gui.appearance.style import FRAMED_CLASSES, framed_palette, palette, style_sheet

TARGET_COLOUR: Colour = (220, 20, 90)
VALIDATION_COLOUR: Colour = (130, 84, 232)
CANDIDATE_COLOUR: Colour = (255, 196, 0)
UNUSED_COLOUR: Colour = (130, 138, 146)
"""Colour of unused points in the view, on light and dark backgrounds."""

SPACING = 8
"""Spacing between neighbouring widgets, pixels; the margins of a panel are twice as wide."""

_scheme: ColourScheme = LIGHT_SCHEME


def __getattr__(name: str) -> str:
    """Colour of the scheme in use by upper-case name, such as ``theme.TEXT``."""
    if name.isupper():
        value = getattr(_scheme, name.lower(), None)
        if isinstance(value, str):
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def current_scheme() -> ColourScheme:
    """Colour scheme in use."""
    return _scheme


def colour(name: str, opacity: float = 1.0) -> QColor:
    """Colour of the scheme in use by field name, with an opacity from 0 to 1."""
    result = QColor(getattr(_scheme, name))
    result.setAlphaF(opacity)
    return result


def rgb(name: str) -> Colour:
    """Colour of the scheme in use by field name, as red, green, blue."""
    red, green, blue, _ = colour(name).getRgb()
    return red, green, blue


@contextmanager
def paper_colours() -> Iterator[None]:
    """Context with the light scheme, for pictures on white paper."""
    global _scheme
    former, _scheme = _scheme, LIGHT_SCHEME
    try:
        yield
    finally:
        _scheme = former


def line_colours(lines: Sequence[str]) -> dict[str, Colour]:
    """Colour of each line, by its place in the project."""
    return {line: _scheme.lines[k % len(_scheme.lines)] for k, line in enumerate(lines)}


def swatch(colour: Colour, size: int = 12) -> QIcon:
    """Icon of a square filled with a colour, which a selected row does not change."""
    pixmap = QPixmap(size, size)
    pixmap.fill(QColor(*colour))
    icon = QIcon()
    for mode in QIcon.Mode:
        icon.addPixmap(pixmap, mode)
    return icon


QUALITY_ICONS = {
    "good": ("check-circle", "done"), "doubtful": ("alert-circle", "doubtful"),
    "poor": ("close-circle", "error"),
}  # fmt: skip
"""Symbols of quality; they differ in shape too, for colour-blind users."""
ICON_SIZES_PX = (16, 20, 24, 28, 32, 48, 64)
"""Sizes of icons for the various scale factors of screens, pixels."""


def quality_icon(quality: str) -> QIcon:
    """Traffic-light icon of a quality: good, doubtful or poor."""
    name, colour = QUALITY_ICONS[quality]
    return _pixmap_icon(name, getattr(_scheme, colour))


@cache
def _pixmap_icon(name: str, colour: str) -> QIcon:
    """Icon painted to pixmaps once, which is faster in tables than a font icon."""
    written = icon(name, colour)
    pictures = QIcon()
    for size in ICON_SIZES_PX:
        pictures.addPixmap(written.pixmap(QSize(size, size), 1.0))
    return pictures


def icon(name: str, colour: str = "") -> QIcon:
    """Material Design icon by name, in the colour of the text or another."""
    return qtawesome.icon(
        f"mdi6.{name}", color=colour or _scheme.text, color_disabled=_scheme.disabled_icon
    )


def tabular_font(font: QFont, *, bold: bool = False) -> QFont:
    """Font with digits of equal width, for columns of numbers."""
    numbers = QFont(font)
    numbers.setFeature(QFont.Tag("tnum"), 1)
    numbers.setBold(bold)
    return numbers


def is_system_dark(application: QApplication) -> bool:
    """Whether the system uses a dark theme; False if it has none."""
    return application.styleHints().colorScheme() == Qt.ColorScheme.Dark


def choose_scheme(application: QApplication, choice: str) -> ColourScheme:
    """Colour scheme of a chosen theme; "system" gives the scheme of the system."""
    if choice == "system":
        return SCHEMES["dark" if is_system_dark(application) else "light"]
    return SCHEMES[choice]


def apply_theme(application: QApplication, choice: str = "light") -> None:
    """Apply Fusion style, palette and style sheet of a theme to the application.

    Parameters
    ----------
    choice : one of `settings.THEMES`
    """
    global _scheme
    scheme_of_theme = {"light": Qt.ColorScheme.Light, "dark": Qt.ColorScheme.Dark}
    # Also applies to the frame of the window and to dialogues of the system.
    application.styleHints().setColorScheme(scheme_of_theme.get(choice, Qt.ColorScheme.Unknown))
    _scheme = choose_scheme(application, choice)
    if application.styleSheet() == style_sheet(_scheme):
        return
    application.setStyle(QStyleFactory.create("Fusion"))
    application.setPalette(palette(_scheme))
    for name in FRAMED_CLASSES:
        application.setPalette(framed_palette(_scheme), name)
    application.setFont(_window_font(application.font()))
    application.setStyleSheet(style_sheet(_scheme))


@contextmanager
def without_style_sheet() -> Iterator[None]:
    """Context without style sheet while a window is built; it is applied once at the end.

    Otherwise, Qt applies the style sheet to all children of a widget again each time the widget
    gets a new parent.
    """
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    sheet = application.styleSheet()
    application.setStyleSheet("")
    try:
        yield
    finally:
        application.setStyleSheet(sheet)


def _window_font(default: QFont) -> QFont:
    families = set(QFontDatabase.families())
    preferred = ("Segoe UI", "SF Pro Text", "Inter", "Noto Sans", "Open Sans", "DejaVu Sans")
    family = next((name for name in preferred if name in families), default.family())
    font = QFont(family)
    font.setPixelSize(13)
    return font
