"""Colours, fonts, icons and style sheet of the window, light or dark.

``theme.TEXT``, ``theme.MUTED`` and so on are the colours of the scheme in use (`ColourScheme.text`,
`ColourScheme.muted`). They change with the scheme, so modules must read them when they paint and
must not store or import them by name.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache

import qtawesome
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QIcon, QPalette, QPixmap
from PySide6.QtWidgets import QApplication, QStyleFactory

from lispac.gui.appearance.colour_schemes import (
    DARK_SCHEME,
    LIGHT_SCHEME,
    SCHEMES,
    Colour,
    ColourScheme,
)
from lispac.installation_paths import resource_path

TARGET_COLOUR: Colour = (220, 20, 90)
VALIDATION_COLOUR: Colour = (130, 84, 232)
CANDIDATE_COLOUR: Colour = (255, 196, 0)
UNUSED_COLOUR: Colour = (130, 138, 146)
"""Colour of unused points in the view, on light and dark backgrounds."""

SPACING = 8
"""Spacing between neighbouring widgets, pixels; the margins of a panel are twice as wide."""

_scheme: ColourScheme = LIGHT_SCHEME
_is_applied = False
"""Whether a theme was applied to the application."""


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


STYLE_NAME = "fusion"
"""Name of the style of Qt, as `QStyle.name` returns it."""
EXTENSION_NAME = "qt_toolbar_ext_button"
"""Name that Qt gives to the button for the actions that have no place in a toolbar."""
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


def apply_theme(
    application: QApplication, choice: str = "light", *, is_window_next: bool = False
) -> None:
    """Apply Fusion style, palette and style sheet of a theme to the application.

    Parameters
    ----------
    choice : one of `settings.THEMES`
    is_window_next : bool
        Whether a window is built next, at the end of which `without_style_sheet` applies a new
        style sheet. Existing widgets get it once then.
    """
    global _scheme, _is_applied
    scheme_of_theme = {"light": Qt.ColorScheme.Light, "dark": Qt.ColorScheme.Dark}
    # Also applies to the frame of the window and to dialogues of the system.
    application.styleHints().setColorScheme(scheme_of_theme.get(choice, Qt.ColorScheme.Unknown))
    _scheme = choose_scheme(application, choice)
    if application.styleSheet() == style_sheet(_scheme):
        return
    # With a style sheet, Qt would apply it to all widgets again after each of these changes
    application.setStyleSheet("")
    if application.style().name() != STYLE_NAME:
        application.setStyle(QStyleFactory.create(STYLE_NAME))
    application.setPalette(palette(_scheme))
    for name in FRAMED_CLASSES:
        application.setPalette(framed_palette(_scheme), name)
    application.setFont(_window_font(application.font()))
    _is_applied = True
    if not is_window_next:
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
        application.setStyleSheet(style_sheet(_scheme) if _is_applied else sheet)


def _window_font(default: QFont) -> QFont:
    families = set(QFontDatabase.families())
    preferred = ("Segoe UI", "SF Pro Text", "Inter", "Noto Sans", "Open Sans", "DejaVu Sans")
    family = next((name for name in preferred if name in families), default.family())
    font = QFont(family)
    font.setPixelSize(13)
    return font


def palette(scheme: ColourScheme) -> QPalette:
    """Palette of a scheme with all roles set, so that none comes from the system."""
    role, group = QPalette.ColorRole, QPalette.ColorGroup
    shade = (QColor(scheme.edge), QColor(scheme.window))
    result = QPalette()
    for which, colour in {
        role.Window: scheme.window,
        role.WindowText: scheme.text,
        role.Base: scheme.paper,
        role.AlternateBase: scheme.alternate,
        role.Text: scheme.text,
        role.Button: scheme.bar,
        role.ButtonText: scheme.text,
        role.BrightText: scheme.error,
        role.ToolTipBase: scheme.paper,
        role.ToolTipText: scheme.text,
        role.Highlight: scheme.fill,
        role.HighlightedText: scheme.on_fill,
        role.Accent: scheme.accent,
        role.Link: scheme.accent,
        role.LinkVisited: scheme.accent,
        role.PlaceholderText: scheme.placeholder,
        role.Light: shade[1].lighter(130).name() if scheme.is_dark else "#ffffff",
        role.Midlight: shade[1].lighter(115).name() if scheme.is_dark else scheme.bar,
        role.Mid: scheme.border,
        role.Dark: scheme.edge_strong,
        role.Shadow: "#000000" if scheme.is_dark else scheme.muted,
    }.items():
        result.setColor(which, QColor(colour))
    for which in (role.WindowText, role.Text, role.ButtonText, role.HighlightedText):
        result.setColor(group.Disabled, which, QColor(scheme.disabled))
    result.setColor(group.Disabled, role.Base, QColor(scheme.disabled_ground))
    for which in (role.Highlight, role.Accent):
        result.setColor(group.Disabled, which, QColor(scheme.disabled_fill))
    return result


FRAMED_CLASSES = (
    "QCheckBox", "QRadioButton", "QMenu", "QLineEdit", "QAbstractSpinBox", "QComboBox",
    "QAbstractItemView",
)  # fmt: skip
"""Classes of check boxes, menus with check boxes, and input widgets."""


def framed_palette(scheme: ColourScheme) -> QPalette:
    """Palette of the widgets named in `FRAMED_CLASSES`.

    The Fusion style draws their frames 1.4 times darker than the colour of the window, or 1.25
    times darker than the highlight if they have the focus; both would be invisible in a dark
    window. These widgets use the colour of the window for nothing else, so it is changed here.
    """
    result = palette(scheme)
    group, role = QPalette.ColorGroup, QPalette.ColorRole
    result.setColor(role.Window, QColor(scheme.frame).lighter(140))
    for which in (group.Active, group.Inactive):
        result.setColor(which, role.Highlight, QColor(scheme.accent))
        result.setColor(which, role.HighlightedText, QColor(scheme.on_accent))
    return result


def _dock_icons(scheme: ColourScheme) -> str:
    """Style rules with light icons for docks in the dark scheme, as the icons of Qt are black."""
    if scheme is not DARK_SCHEME:
        return ""
    icons = [resource_path(f"icons/dock-{name}-dark.png").as_posix() for name in ("close", "float")]
    return f'titlebar-close-icon: url("{icons[0]}"); titlebar-normal-icon: url("{icons[1]}");'


def style_sheet(scheme: ColourScheme) -> str:
    """Style sheet of the application."""
    s = scheme
    return f"""
QToolTip {{ color: {s.text}; background: {s.paper}; border: 1px solid {s.border}; padding: 4px; }}
QMainWindow::separator {{ background: {s.window}; width: 5px; height: 5px; }}
QMainWindow::separator:hover {{ background: {s.chosen_edge}; }}
QDockWidget {{ font-weight: 600; {_dock_icons(scheme)} }}
QDockWidget::title {{ background: {s.title}; padding: 2px 8px 1px 8px;
    border-bottom: 1px solid {s.border}; }}
QToolBar {{ background: {s.bar}; border: none; border-bottom: 1px solid {s.border};
    padding: 1px 6px; spacing: 2px; }}
QToolBar QToolButton {{ padding: 1px 6px; border: 1px solid transparent; border-radius: 5px; }}
QToolBar QToolButton#{EXTENSION_NAME} {{ padding: 0px; border-radius: 2px; }}
QToolBar QToolButton:hover {{ background: {s.hover}; }}
QToolBar QToolButton:checked {{ background: {s.chosen}; border-color: {s.chosen_edge}; }}
QToolBar QToolButton:checked:disabled {{ background: transparent;
    border-color: transparent; }}
QToolBar QToolButton:focus {{ border-color: {s.accent}; }}
QToolBar::separator {{ background: {s.border}; width: 1px; margin: 6px 5px; }}
QStatusBar {{ background: {s.bar}; border-top: 1px solid {s.border}; }}
QStatusBar::item {{ border: none; }}
QPushButton {{ padding: 5px 12px; border: 1px solid {s.edge}; border-radius: 5px;
    background: {s.paper}; color: {s.text}; }}
QPushButton:hover {{ background: {s.hover}; border-color: {s.edge_strong}; }}
QPushButton:pressed {{ background: {s.pressed}; }}
QPushButton:focus {{ border: 2px solid {s.accent}; padding: 4px 11px;
    outline: none; }}
QPushButton:disabled {{ background: {s.disabled_ground}; border-color: {s.border};
    color: {s.disabled}; }}
QPushButton[primary="true"] {{ background: {s.fill}; border-color: {s.fill}; color: {s.on_fill};
    font-weight: 600; }}
QPushButton[primary="true"]:hover {{ background: {s.fill_hover}; }}
QPushButton[primary="true"]:focus {{ border: 2px solid {s.fill_edge}; padding: 4px 11px; }}
QPushButton[primary="true"]:disabled {{ background: {s.disabled_fill};
    border-color: {s.disabled_fill}; color: {s.muted if not s.is_dark else s.disabled}; }}
QPushButton[segment="true"] {{ padding: 5px 8px; }}
QPushButton[segment="true"]:focus {{ padding: 4px 7px; }}
QPushButton[segment="true"]:checked {{ background: {s.chosen}; border-color: {s.accent};
    color: {s.on_chosen}; }}
QPushButton[segment="true"]:checked:disabled {{ background: transparent; border-color: {s.border};
    color: {s.disabled}; }}
QPushButton[step="true"] {{ text-align: left; padding: 0; border: none; border-radius: 0;
    border-bottom: 1px solid {s.border}; background: {s.bar}; }}
QPushButton[step="true"]:hover {{ background: {s.hover}; }}
QPushButton[step="true"]:checked {{ background: {s.current}; }}
QPushButton[step="true"]:focus {{ border: 2px solid {s.accent}; padding: 0; }}
QLabel[role="muted"] {{ color: {s.muted}; }}
QLabel[role="heading"] {{ font-weight: 600; }}
QLabel[role="error"] {{ color: {s.error}; }}
QLabel[role="success"] {{ color: {s.done}; }}
QLabel[role="warning"] {{ color: {s.warning_text}; background: {s.warning_ground};
    border: 1px solid {s.warning_edge}; border-radius: 5px; padding: 7px 9px; }}
QLabel[role="hint"] {{ color: {s.hint_text}; background: {s.hint_ground};
    border: 1px solid {s.hint_edge}; border-radius: 5px; padding: 7px 9px; }}
QFrame[role="drop"] {{ background: {s.paper}; border: 2px dashed {s.edge_strong};
    border-radius: 10px; }}
QTabWidget::pane {{ border: 1px solid {s.border}; background: {s.bar}; top: -1px; }}
QTabWidget > QTabBar::tab {{ padding: 6px 14px; background: transparent; border: none;
    border-bottom: 3px solid transparent; color: {s.muted}; }}
QTabWidget > QTabBar::tab:selected {{ color: {s.text}; border-bottom-color: {s.accent}; }}
QTabWidget > QTabBar::tab:hover {{ background: {s.hover}; }}
QTabWidget > QTabBar::tab:focus {{ color: {s.accent}; }}

QLineEdit[wrong="true"] {{ background: {s.wrong_ground}; border: 1px solid {s.error};
    border-radius: 2px; }}
QDoubleSpinBox[assumed="true"] {{ color: {s.muted}; font-style: italic; }}
QDoubleSpinBox[wrong="true"] {{ background: {s.wrong_ground}; color: {s.error}; }}
QAbstractSpinBox {{ min-height: 1.15em; }}
QPlainTextEdit, QTextEdit {{ border: 1px solid {s.edge_strong}; }}
QPlainTextEdit:focus, QTextEdit:focus {{ border-color: {s.accent}; }}
QAbstractScrollArea::corner {{ background: {s.window}; border: none; }}
QFrame[role="candidate"] {{ background: {s.hint_ground};
    border: 1px solid {s.hint_edge}; border-radius: 5px; }}
QTableView, QListView {{ border: 1px solid {s.border}; gridline-color: {s.grid};
    selection-background-color: {s.chosen}; selection-color: {s.text}; }}
QTableView[rows="true"] {{ outline: none; }}
QTableView:focus, QListView:focus {{ border-color: {s.accent}; }}
QTableCornerButton::section {{ background: {s.header}; border: none; }}
QHeaderView {{ background: {s.header}; }}
QHeaderView::section {{ background: {s.header}; border: none; border-right: 1px solid {s.border};
    border-bottom: 1px solid {s.border}; padding: 4px 6px; font-weight: 600; color: {s.text}; }}
QProgressBar {{ border: 1px solid {s.border}; border-radius: 4px; background: {s.paper};
    text-align: center; min-height: 16px; max-height: 16px; color: {s.text}; }}
QProgressBar::chunk {{ background: {s.progress}; border-radius: 3px; }}
QMainWindow > QTabBar::tab {{ padding: 2px 14px 2px 14px; min-height: 17px; background: transparent;
    border: none; border-bottom: 3px solid transparent; color: {s.muted}; }}
QMainWindow > QTabBar::tab:selected {{ color: {s.text}; border-bottom-color: {s.accent}; }}
QMainWindow > QTabBar::tab:focus {{ color: {s.accent}; }}
QMainWindow > QTabBar::tab:hover {{ background: {s.hover}; }}
QDialogButtonBox {{ dialogbuttonbox-buttons-have-icons: 0; }}
QScrollArea {{ border: none; background: transparent; }}
"""
