"""Colours, fonts and the light look of the window."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

import qtawesome
from PySide6.QtGui import QColor, QFont, QFontDatabase, QIcon, QPalette, QPixmap
from PySide6.QtWidgets import QApplication, QStyleFactory

if TYPE_CHECKING:
    from lispac.gui.viewport.base import Colour

ACCENT = "#1f5fa8"
TEXT = "#1c2733"
MUTED = "#586573"
BORDER = "#d3dae1"
WINDOW = "#f3f5f8"
DONE = "#1e7f4f"
WARNING = "#a85508"
ERROR = "#b3261e"
BEFORE = "#0072b2"
AFTER = "#8c510a"

# Okabe and Ito's colours without black and yellow, then dark ones of Tol's muted set: any two
# neighbours in the list are told apart with every common kind of colour blindness.
_LINE_COLOURS: tuple["Colour", ...] = (
    (0, 114, 178),
    (230, 159, 0),
    (0, 158, 115),
    (204, 121, 167),
    (86, 180, 233),
    (213, 94, 0),
    (51, 34, 136),
    (153, 153, 51),
    (136, 34, 85),
    (17, 119, 51),
)
TARGET_COLOUR: "Colour" = (220, 20, 90)
VALIDATION_COLOUR: "Colour" = (110, 60, 200)
CANDIDATE_COLOUR: "Colour" = (255, 196, 0)
UNUSED_COLOUR: "Colour" = (130, 138, 146)

SPACE = 8
"""Pixels between neighbours; margins of a panel are twice that."""


def line_colours(lines: Sequence[str]) -> dict[str, "Colour"]:
    """A colour for each line, by its place in the project."""
    return {line: _LINE_COLOURS[k % len(_LINE_COLOURS)] for k, line in enumerate(lines)}


def swatch(colour: "Colour", size: int = 12) -> QIcon:
    """A filled square of that colour."""
    pixmap = QPixmap(size, size)
    pixmap.fill(QColor(*colour))
    return QIcon(pixmap)


LIGHTS = {
    "good": ("check-circle", DONE), "doubtful": ("alert-circle", "#d97a00"),
    "poor": ("close-circle", ERROR),
}  # fmt: skip
"""Traffic lights differ in shape as well: colours alone do not tell everybody."""


def light(which: str) -> QIcon:
    """The traffic light of a quality: good, doubtful or poor."""
    return icon(*LIGHTS[which])


def icon(name: str, colour: str = TEXT) -> QIcon:
    """An icon of the Material Design set by its name."""
    return qtawesome.icon(f"mdi6.{name}", color=colour, color_disabled="#a9b3bd")


def tabular(font: QFont, *, bold: bool = False) -> QFont:
    """The same font with digits of one width, for columns of numbers."""
    numbers = QFont(font)
    numbers.setFeature(QFont.Tag("tnum"), 1)
    numbers.setBold(bold)
    return numbers


def apply_theme(application: QApplication) -> None:
    """Dress the application, once: Fusion style, a light palette and a few rules."""
    if application.styleSheet() == _STYLE:
        return
    application.setStyle(QStyleFactory.create("Fusion"))
    application.setPalette(_palette())
    application.setFont(_font(application.font()))
    application.setStyleSheet(_STYLE)


@contextmanager
def undressed() -> Iterator[None]:
    """Without the rules while a window is put together, and with them in one go after that.

    Qt would apply them anew to all that a widget holds whenever it is put into another one.
    """
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    rules = application.styleSheet()
    application.setStyleSheet("")
    try:
        yield
    finally:
        application.setStyleSheet(rules)


def _font(default: QFont) -> QFont:
    families = set(QFontDatabase.families())
    wanted = ("Segoe UI", "SF Pro Text", "Inter", "Noto Sans", "Open Sans", "DejaVu Sans")
    family = next((name for name in wanted if name in families), default.family())
    font = QFont(family)
    font.setPixelSize(13)
    return font


def _palette() -> QPalette:
    role = QPalette.ColorRole
    palette = QPalette()
    for which, colour in {
        role.Window: WINDOW,
        role.WindowText: TEXT,
        role.Base: "#ffffff",
        role.AlternateBase: "#f7f9fb",
        role.Text: TEXT,
        role.Button: "#fbfcfd",
        role.ButtonText: TEXT,
        role.ToolTipBase: "#ffffff",
        role.ToolTipText: TEXT,
        role.Highlight: ACCENT,
        role.HighlightedText: "#ffffff",
        role.Link: ACCENT,
        role.PlaceholderText: "#8a96a3",
        role.Mid: BORDER,
    }.items():
        palette.setColor(which, QColor(colour))
    for which in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, which, QColor("#93a0ac"))
    palette.setColor(QPalette.ColorGroup.Disabled, role.Highlight, QColor("#c5ced8"))
    return palette


_STYLE = f"""
QToolTip {{ color: {TEXT}; background: #ffffff; border: 1px solid {BORDER}; padding: 4px; }}
QMainWindow::separator {{ background: {WINDOW}; width: 5px; height: 5px; }}
QMainWindow::separator:hover {{ background: #b9cbe0; }}
QDockWidget {{ font-weight: 600; }}
QDockWidget::title {{ background: #e7ebf0; padding: 5px 8px; border-bottom: 1px solid {BORDER}; }}
QToolBar {{ background: #fbfcfd; border: none; border-bottom: 1px solid {BORDER};
    padding: 2px 6px; spacing: 2px; }}
QToolBar QToolButton {{ padding: 3px 6px; border: 1px solid transparent; border-radius: 5px; }}
QToolBar QToolButton:hover {{ background: #e8eef5; }}
QToolBar QToolButton:checked {{ background: #d6e4f4; border-color: #a9c4e2; }}
QToolBar QToolButton:focus {{ border-color: {ACCENT}; }}
QToolBar::separator {{ background: {BORDER}; width: 1px; margin: 6px 5px; }}
QStatusBar {{ background: #fbfcfd; border-top: 1px solid {BORDER}; }}
QStatusBar::item {{ border: none; }}
QPushButton {{ padding: 5px 12px; border: 1px solid #c3ccd5; border-radius: 5px;
    background: #ffffff; }}
QPushButton:hover {{ background: #eef3f9; border-color: #9fb4ca; }}
QPushButton:pressed {{ background: #dfe9f4; }}
QPushButton:focus {{ border-color: {ACCENT}; }}
QPushButton:disabled {{ background: #f1f3f5; border-color: #dfe4e9; color: #93a0ac; }}
QPushButton[primary="true"] {{ background: {ACCENT}; border-color: {ACCENT}; color: #ffffff;
    font-weight: 600; }}
QPushButton[primary="true"]:hover {{ background: #2a6fbd; }}
QPushButton[primary="true"]:focus {{ border: 2px solid #0b325f; padding: 4px 11px; }}
QPushButton[primary="true"]:disabled {{ background: #c3d0de; border-color: #c3d0de;
    color: #f7f9fb; }}
QPushButton[segment="true"] {{ padding: 5px 8px; }}
QPushButton[segment="true"]:checked {{ background: #d6e4f4; border-color: {ACCENT};
    color: #0b325f; font-weight: 600; }}
QPushButton[step="true"] {{ text-align: left; padding: 0; border: none; border-radius: 0;
    border-bottom: 1px solid {BORDER}; background: #fbfcfd; }}
QPushButton[step="true"]:hover {{ background: #eef3f9; }}
QPushButton[step="true"]:checked {{ background: #e3edf8; }}
QPushButton[step="true"]:focus {{ border: 1px solid {ACCENT}; }}
QLabel[role="muted"] {{ color: {MUTED}; }}
QLabel[role="heading"] {{ font-weight: 600; }}
QLabel[role="error"] {{ color: {ERROR}; }}
QLabel[role="warning"] {{ color: #6d3703; background: #fdf1e3; border: 1px solid #eccfa6;
    border-radius: 5px; padding: 7px 9px; }}
QLabel[role="hint"] {{ color: #123f72; background: #e9f1fa; border: 1px solid #cfe0f2;
    border-radius: 5px; padding: 7px 9px; }}
QFrame[role="drop"] {{ background: #ffffff; border: 2px dashed #9fb4ca; border-radius: 10px; }}
QTabWidget::pane {{ border: 1px solid {BORDER}; background: #fbfcfd; top: -1px; }}
QTabWidget > QTabBar::tab {{ padding: 6px 14px; background: transparent; border: none;
    border-bottom: 3px solid transparent; color: {MUTED}; }}
QTabWidget > QTabBar::tab:selected {{ color: {TEXT}; border-bottom-color: {ACCENT}; }}
QTabWidget > QTabBar::tab:hover {{ background: #e8eef5; }}
QTabWidget > QTabBar::tab:focus {{ color: {ACCENT}; }}
QLineEdit[wrong="true"] {{ background: #fdeceb; border: 1px solid {ERROR}; border-radius: 2px; }}
QFrame[role="candidate"] {{ background: #fff8df; border: 1px solid #e6c65c; border-radius: 5px; }}
QTableView, QListView {{ border: 1px solid {BORDER}; gridline-color: #e6eaee;
    selection-background-color: #d6e4f4; selection-color: {TEXT}; }}
QTableView:focus, QListView:focus {{ border-color: {ACCENT}; }}
QHeaderView::section {{ background: #eef1f5; border: none; border-right: 1px solid #e0e5ea;
    border-bottom: 1px solid {BORDER}; padding: 4px 6px; font-weight: 600; }}
QProgressBar {{ border: 1px solid {BORDER}; border-radius: 4px; background: #ffffff;
    text-align: center; min-height: 16px; max-height: 16px; }}
QProgressBar::chunk {{ background: #7fb0e2; border-radius: 3px; }}
QMainWindow > QTabBar::tab {{ padding: 4px 14px 4px 14px; min-height: 17px; background: transparent;
    border: none; border-bottom: 3px solid transparent; color: {MUTED}; }}
QMainWindow > QTabBar::tab:selected {{ color: {TEXT}; border-bottom-color: {ACCENT}; }}
QMainWindow > QTabBar::tab:hover {{ background: #e8eef5; }}
QScrollArea {{ border: none; background: transparent; }}
"""
