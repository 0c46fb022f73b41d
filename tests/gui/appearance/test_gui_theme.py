"""Tests of the light and dark themes, chosen in the menu or by the system."""

from itertools import pairwise, product
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QGuiApplication, QIcon, QImage, QPalette, QPixmap
from PySide6.QtWidgets import QApplication, QDialog, QMenu, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import theme
from lispac.gui.appearance.colour_schemes import DARK_SCHEME, LIGHT_SCHEME, ColourScheme, luminance
from lispac.gui.features.design import edits
from lispac.gui.features.help.dialogs import about_box
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.project.status import DATA
from lispac.gui.widgets.chart import Chart, with_inverted_lightness
from lispac.gui.window.session import THEME_DELAY_MS, Session
from lispac.project import Project
from tests.gui.app.test_gui_language import SOON_MS, choose, open_menu
from tests.gui.support import Demo, Driver, in_front, open_step, show_panel
from tests.support.long_runs import LONG, others_long
from tests.support.view_scenes import array_of, count

Scheming = Qt.ColorScheme
BOTH_SCHEMES = pytest.mark.parametrize(
    "scheme", [LIGHT_SCHEME, DARK_SCHEME], ids=lambda scheme: scheme.name
)


def contrast(one: str, other: str) -> float:
    """Contrast ratio of WCAG 2.2, 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


# -- colours -----------------------------------------------------------------------------------


@pytest.mark.parametrize("mode", list(QIcon.Mode), ids=lambda mode: mode.name)
def test_a_swatch_has_the_colour_of_the_line_in_selected_rows_too(
    qapp: QApplication, mode: QIcon.Mode
) -> None:
    picture = theme.swatch((12, 200, 100)).pixmap(12, 12, mode).toImage()
    assert picture.pixelColor(6, 6).getRgb()[:3] == (12, 200, 100)


def test_swatches_in_the_list_of_lines_have_the_colours_of_the_scene(opened: Driver) -> None:
    open_step(opened, DATA)
    table = opened.window.data.lines
    names = [table.item(row, 0).text() for row in range(table.rowCount())]
    assert set(names) == set(opened.viewport.colours)
    for row, name in enumerate(names):
        place = table.visualItemRect(table.item(row, 0))
        pictures = [table.viewport().grab(place).toImage()]
        opened.bot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=place.center())
        assert table.currentRow() == row
        pictures.append(table.viewport().grab(place).toImage())
        assert pictures[0] != pictures[1], "selected"
        for picture in pictures:
            assert count(array_of(picture), opened.viewport.colours[name]) >= 100


def test_luminance_is_that_of_the_standard() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    # An example of WCAG that is just sufficient.
    assert contrast("#767676", "#ffffff") == pytest.approx(4.54, abs=0.005)


@BOTH_SCHEMES
def test_texts_have_enough_contrast_on_every_background(scheme: ColourScheme) -> None:
    grounds = ("window", "paper", "bar", "alternate", "header")
    words = ("text", "muted", "placeholder", "accent", "done", "warning", "error")
    pairs = [
        *product(words, grounds),
        *product(("text", "muted"), ("title", "hover", "current", "hint_ground")),
        ("text", "chosen"), ("text", "pressed"), ("text", "note"), ("text", "wrong_ground"),
        ("text", "progress"), ("text", "positive"), ("text", "negative"),
        ("on_chosen", "chosen"), ("on_fill", "fill"), ("on_accent", "accent"),
        ("on_fill", "fill_hover"),
        ("warning_text", "warning_ground"), ("hint_text", "hint_ground"),
    ]  # fmt: skip
    ratios = {pair: contrast(getattr(scheme, pair[0]), getattr(scheme, pair[1])) for pair in pairs}
    assert {pair: ratio for pair, ratio in ratios.items() if ratio < 4.5} == {}


@BOTH_SCHEMES
def test_focus_frames_and_marks_have_enough_contrast(scheme: ColourScheme) -> None:
    pairs = [
        *product(("accent", "frame", "doubtful", "waiting"), ("window", "paper", "bar")),
        *product(("warning", "error", "done"), ("chosen",)),
        ("accent", "current"), ("fill", "paper"), ("fill_edge", "window"),
        *product(("axis_x", "axis_y", "axis_z", "body_axis", "wall", "moved"), ("paper",)),
        *product(("before", "after"), ("paper", "ground", "sky")),
    ]  # fmt: skip
    ratios = {pair: contrast(getattr(scheme, pair[0]), getattr(scheme, pair[1])) for pair in pairs}
    ratios |= {(each, "paper"): contrast(each, scheme.paper) for each in scheme.series}
    assert {pair: ratio for pair, ratio in ratios.items() if ratio < 3.0} == {}


@BOTH_SCHEMES
@pytest.mark.parametrize("blindness", ["protan", "deutan"])
def test_neighbouring_lines_differ_for_the_colour_blind(
    scheme: ColourScheme, blindness: str
) -> None:
    colours = [perceived_lab(colour, blindness) for colour in scheme.lines]
    apart = [float(np.linalg.norm(one - other)) for one, other in pairwise(colours)]
    assert min(apart) > CLEAR_DIFFERENCE


CLEAR_DIFFERENCE = 10.0
"""CIE 1976 colour difference that is clearly visible; about 2.3 is just noticeable."""
COLOUR_BLINDNESS = {
    "protan": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "deutan": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
}
"""Machado, Oliveira and Fernandes (2009), severity 1, on linear RGB."""
XYZ = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
WHITE = [0.9505, 1.0, 1.089]


def perceived_lab(colour: tuple[int, int, int], blindness: str) -> np.ndarray:
    """L*, a*, b* of a colour as seen with a type of colour blindness."""
    linear = [luminance(f"#{value:02x}{value:02x}{value:02x}") for value in colour]
    mixed = np.clip(np.array(COLOUR_BLINDNESS[blindness]) @ linear, 0.0, 1.0)
    share = np.array(XYZ) @ mixed / WHITE
    x, y, z = np.where(share > 0.008856, np.cbrt(share), 7.787 * share + 16 / 116)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


@BOTH_SCHEMES
def test_a_palette_sets_every_colour_role(scheme: ColourScheme) -> None:
    from lispac.gui.appearance.theme import palette

    made = palette(scheme)
    roles = [role for role in QPalette.ColorRole if role.name not in ("NoRole", "NColorRoles")]
    assert [r for r in roles if not made.isBrushSet(QPalette.ColorGroup.Active, r)] == []


def test_colour_names_refer_to_the_current_scheme() -> None:
    assert theme.current_scheme().muted == theme.MUTED
    with theme.paper_colours():
        assert theme.PAPER == "#ffffff"
    with pytest.raises(AttributeError, match="NO_COLOUR"):
        _ = theme.NO_COLOUR


# -- the window --------------------------------------------------------------------------------


def choose_theme(session: Session, bot: QtBot, *names: str) -> None:
    """Choose a theme in the menu, and wait for the new window."""
    former = session.window
    choose(bot, open_menu(bot, former, "View"), "heme", *names)
    bot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    bot.waitUntil(session.window.isActiveWindow, timeout=SOON_MS)


@LONG
def test_dark_and_light_are_chosen_and_nothing_is_lost(
    session: Session, qtbot: QtBot, demo: Demo
) -> None:
    session.window.document.open(demo.picked, demo.survey)
    session.window.controller.rename("T1", "North wall")
    edited = session.window.document.project
    choose_theme(session, qtbot, "Dark")
    dark = session.window
    assert theme.current_scheme() is DARK_SCHEME
    assert dark.settings.theme == "dark"
    assert dark.actions_["theme_dark"].isChecked()
    assert dark.document.project is edited
    assert dark.document.undo_stack.canUndo()
    assert background_colour(dark).lightnessF() < 0.2
    choose_theme(session, qtbot, "Light")
    assert theme.current_scheme() is LIGHT_SCHEME
    assert background_colour(session.window).lightnessF() > 0.9
    assert AppSettings(Path(session.window.settings._store.fileName())).theme == "light"


def background_colour(widget: QWidget) -> QColor:
    """Background colour of a window, taken from its status bar at the lower edge."""
    picture = widget.grab().toImage()
    return picture.pixelColor(picture.width() // 2, picture.height() - 6)


def test_the_window_follows_the_system(
    session: Session, qtbot: QtBot, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    choose_theme(session, qtbot, "System default")
    window, other = session.window, not theme.current_scheme().is_dark
    # Simulates a change of the system's theme, which a virtual screen does not have.
    monkeypatch.setattr(theme, "is_system_dark", lambda _application: other)
    scheme_changed = qapp.styleHints().colorSchemeChanged
    menu = open_menu(qtbot, window, "File")
    scheme_changed.emit(Scheming.Dark if other else Scheming.Light)
    qtbot.wait(3 * THEME_DELAY_MS)
    assert session.window is window  # not replaced while a menu is open
    menu.close()
    qtbot.waitUntil(lambda: session.window is not window, timeout=SOON_MS)
    assert theme.current_scheme() is (DARK_SCHEME if other else LIGHT_SCHEME)


@LONG
def test_the_design_window_follows_the_system_and_stays_in_front(
    session: Session, qtbot: QtBot, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    choose_theme(session, qtbot, "System default")
    window, other = session.window, not theme.current_scheme().is_dark
    window.site_design.open()
    design = window.site_design.window
    qtbot.waitUntil(lambda: in_front(design), timeout=SOON_MS)
    monkeypatch.setattr(theme, "is_system_dark", lambda _application: other)
    design.workspace.drag(edits.default_plan(90.0))
    qapp.styleHints().colorSchemeChanged.emit(Scheming.Dark if other else Scheming.Light)
    qtbot.wait(3 * THEME_DELAY_MS)
    assert session.window is window  # not replaced during a drag
    design.workspace.cancel_drag()
    qtbot.waitUntil(lambda: session.window is not window, timeout=SOON_MS)
    heir = session.window.site_design.window
    qtbot.waitUntil(heir.isActiveWindow, timeout=SOON_MS)
    assert theme.current_scheme() is (DARK_SCHEME if other else LIGHT_SCHEME)


def test_a_chosen_theme_does_not_follow_the_system(
    session: Session, qtbot: QtBot, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = session.window
    monkeypatch.setattr(theme, "is_system_dark", lambda _application: True)
    qapp.styleHints().colorSchemeChanged.emit(Scheming.Dark)
    qtbot.wait(3 * THEME_DELAY_MS)
    assert session.window is window
    assert theme.current_scheme() is LIGHT_SCHEME


@pytest.mark.parametrize("choice", others_long(["light", "dark"]))
def test_texts_of_windows_have_enough_contrast(
    session: Session, qtbot: QtBot, demo: Demo, estimated, choice: str
) -> None:
    session.window.document.open(estimated, demo.survey)
    if choice == "dark":
        choose_theme(session, qtbot, "Dark")
    window = session.window
    window.settings.theme = choice
    box, dialog = about_box(window), ImportDialog(window.settings, window)
    for each in (window, box, dialog):
        each.ensurePolished()
        assert low_contrast_widgets(each) == []
    for each in (box, dialog):
        assert isinstance(each, QDialog)
        each.deleteLater()


def low_contrast_widgets(window: QWidget) -> list[str]:
    """Widgets whose palettes give too little contrast between text and background."""
    found = []
    for widget in (window, *window.findChildren(QWidget)):
        if isinstance(widget, QMenu) and not widget.actions():
            continue
        colours = widget.palette()
        for words, on in (("WindowText", "Base"), ("Text", "Base"), ("ButtonText", "Button"),
                          ("HighlightedText", "Highlight"), ("ToolTipText", "ToolTipBase"),
                          ("PlaceholderText", "Base")):  # fmt: skip
            role = QPalette.ColorRole
            group = QPalette.ColorGroup.Active
            text = colours.color(group, role[words]).name()
            below = colours.color(group, role[on]).name()
            # A transparent background shows the parent, which is checked as well.
            if colours.color(group, role[on]).alpha() and contrast(text, below) < 4.5:
                kind = type(widget).__name__
                found.append(f"{kind} {widget.objectName()}: {words} {text} on {below}")
    return found


# -- charts ------------------------------------------------------------------------------------


def corner_colour(picture: QImage | QPixmap) -> str:
    """Background colour of a picture of a chart."""
    image = picture if isinstance(picture, QImage) else picture.toImage()
    assert image.width() > 100
    return image.pixelColor(2, 2).name()


def picture_in_front(session: Session, bot: QtBot, dock: str, chart: Chart) -> QPixmap:
    """Raise the dock of a chart, wait until it is drawn, and return its picture."""
    drawn: list[object] = []
    connection = chart.mpl_connect("draw_event", drawn.append)
    show_panel(session.window, dock)
    chart.draw_idle()
    bot.waitUntil(lambda: bool(drawn) and not chart.is_drawing, timeout=SOON_MS)
    chart.mpl_disconnect(connection)
    return chart.grab()


def clipboard_image(bot: QtBot) -> QImage:
    """Wait for an image in the clipboard and return it."""
    clipboard = QGuiApplication.clipboard()
    bot.waitUntil(lambda: not clipboard.image().isNull(), timeout=SOON_MS)
    return clipboard.image()


@LONG
@pytest.mark.parametrize("choice", others_long(["Light", "Dark"], lambda choice: choice == "Dark"))
def test_charts_have_the_theme_of_the_window_and_are_copied_on_white(
    session: Session, qtbot: QtBot, demo: Demo, validated: Project, tmp_path: Path, choice: str
) -> None:
    if choice == "Dark":
        choose_theme(session, qtbot, "Dark")
    window, ground = session.window, theme.PAPER
    assert ground == (DARK_SCHEME if choice == "Dark" else LIGHT_SCHEME).paper
    window.document.open(validated, demo.survey)
    show_panel(window, "Histograms")
    qtbot.waitUntil(lambda: not window.runner.active, timeout=SOON_MS)
    qtbot.waitUntil(lambda: window.histograms.canvas is not None, timeout=SOON_MS)
    pictures = {}
    histograms = window.histograms
    pictures["histogram"] = picture_in_front(session, qtbot, "Histograms", histograms.canvas)
    QGuiApplication.clipboard().clear()
    qtbot.mouseClick(histograms.copy_picture, Qt.MouseButton.LeftButton)
    assert corner_colour(clipboard_image(qtbot)) == "#ffffff"
    assert corner_colour(histograms.canvas.grab()) == ground

    window._select("T1", "")
    qtbot.keyClick(window, Qt.Key.Key_S)
    section = window.tools.sections.panel
    qtbot.waitUntil(lambda: section.has_section and not window.runner.active, timeout=SOON_MS)
    pictures["section"] = picture_in_front(session, qtbot, "Section", section.canvas)
    QGuiApplication.clipboard().clear()
    qtbot.mouseClick(section.copy_picture, Qt.MouseButton.LeftButton)
    assert corner_colour(clipboard_image(qtbot)) == "#ffffff"

    pages = window.diagnostics
    show_panel(window, "Diagnostics")
    row = pages.list.visualItemRect(pages.list.item(list(pages.pages).index("Convergence")))
    qtbot.mouseClick(pages.list.viewport(), Qt.MouseButton.LeftButton, pos=row.center())
    chart = pages.current.canvas
    pictures["diagnostics"] = picture_in_front(session, qtbot, "Diagnostics", chart)
    for name, picture in pictures.items():
        assert picture.save(str(tmp_path / f"{name}.png"))
        assert corner_colour(picture) == ground, name
    if choice == "Dark":
        assert window.grab().save(str(tmp_path / "window.png"))


@pytest.mark.parametrize(
    "colour", [*LIGHT_SCHEME.series, LIGHT_SCHEME.before, LIGHT_SCHEME.after, LIGHT_SCHEME.text]
)
def test_inverted_colours_keep_their_hue_and_have_enough_contrast(
    monkeypatch: pytest.MonkeyPatch, colour: str
) -> None:
    monkeypatch.setattr(theme, "_scheme", DARK_SCHEME)
    on_white = QColor(colour)
    pixel = np.array([[[*on_white.getRgb()]]], dtype=np.uint8)
    shown = QColor(*(int(each) for each in with_inverted_lightness(pixel)[0, 0]))
    assert contrast(shown.name(), DARK_SCHEME.paper) > 4.5
    if on_white.saturationF() > 0.5:
        assert abs(shown.hue() - on_white.hue()) < 12
