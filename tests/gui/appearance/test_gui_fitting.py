"""Tests of layout: texts are not cut off, and dialogues fit on a small screen."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text
from PySide6.QtCore import QEvent, QPoint, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QHelpEvent, QPolygonF
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QDialogButtonBox,
    QMenu,
    QMessageBox,
    QPushButton,
    QScrollArea,
    QSpinBox,
    QStyle,
    QStyleOptionDockWidget,
    QTableWidget,
    QToolTip,
    QWidget,
)
from pytestqt.qtbot import QtBot

from lispac.gui import widgets
from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import theme
from lispac.gui.features.design.number_table import NumberTable
from lispac.gui.features.design.window import DesignWindow
from lispac.gui.features.inspect.clipping_panel import ClippingPanel
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.patch_test.panel import PatchTestPanel
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.gui.features.studies.visibility_dialog import VisibilityDialog
from lispac.gui.viewport.clipping import Box
from lispac.gui.viewport.overlay import free_label_place, has_right_neighbour
from lispac.gui.widgets import ChoiceBox
from lispac.gui.widgets.error_box import error_box
from lispac.gui.widgets.foldable_group import FoldableGroup
from lispac.gui.widgets.mounting_sketch import MountingSketch
from lispac.identity import Identity
from lispac.language import LANGUAGES
from lispac.project import Project
from lispac.simulation.visibility_study import VisibilityStudy
from tests.gui.import_support import drop, raw
from tests.gui.import_support import rest as import_rest
from tests.gui.support import WAIT_MS, Demo, Driver, Key, finish_layouts, press, show_panel
from tests.support.long_runs import LONG, others_long

SMALL_WINDOW = (1366, 740)
LOW_SCREEN = QSize(1326, 728)
"""Size available for a dialogue on a screen of 1366 × 768."""


@pytest.fixture(
    params=[pytest.param(code, marks=LONG if code == "en" else ()) for code in LANGUAGES]
)
def language(qapp: QApplication, request: pytest.FixtureRequest) -> Iterator[str]:
    """Code of each language, with the theme of the program applied; French texts are longer."""
    theme.apply_theme(qapp)
    set_language(request.param)
    yield request.param
    set_language("en")


@pytest.fixture
def dark(qapp: QApplication) -> Iterator[None]:
    """The dark theme."""
    theme.apply_theme(qapp, "dark")
    yield
    theme.apply_theme(qapp)


def test_the_titles_of_panels_are_not_cut_off(driver: Driver, qapp: QApplication) -> None:
    theme.apply_theme(qapp)
    for title, dock in driver.window.docks.items():
        show_panel(driver.window, title)
        driver.rest()
        option = QStyleOptionDockWidget()
        dock.initStyleOption(option)
        part = QStyle.SubElement.SE_DockWidgetTitleBarText
        area = dock.style().subElementRect(part, option, dock)
        assert area.height() >= QFontMetricsF(dock.font()).height(), title


def test_letters_of_a_number_field_are_not_cut_off_below(qtbot: QtBot, qapp: QApplication) -> None:
    theme.apply_theme(qapp)
    for field in (
        widgets.number("size", suffix=" m", decimals=2, low=0, high=9, step=1, tip="Size"),
        QSpinBox(),
    ):
        qtbot.addWidget(field)
        field.resize(field.sizeHint())
        field.show()
        line = field.lineEdit()
        assert line.height() >= line.fontMetrics().height() + 2


def test_the_corner_between_scroll_bars_has_the_colour_of_the_window(
    qtbot: QtBot, dark: None
) -> None:
    """The corner used to have the lighter colour of the frames of tables."""
    table = QTableWidget(40, 40)
    qtbot.addWidget(table)
    table.resize(300, 200)
    table.show()
    bar = table.verticalScrollBar()
    corner = QPoint(bar.geometry().center().x(), 0) + bar.mapTo(table, QPoint(0, 0))
    picture = table.grab().toImage()
    corner = QPoint(table.width() - 4, table.height() - 4)
    assert picture.pixelColor(corner * picture.devicePixelRatio()) == QColor(theme.WINDOW)


def test_the_frame_of_a_check_box_in_a_menu_is_visible(qtbot: QtBot, dark: None) -> None:
    menu = QMenu()
    qtbot.addWidget(menu)
    menu.addAction("Orthographic").setCheckable(True)
    menu.resize(menu.sizeHint())
    picture = menu.grab().toImage()
    middle, width = picture.height() // 2, menu.fontMetrics().height() + 8  # left of the text
    lightness = [picture.pixelColor(x, middle).lightness() for x in range(2, width)]
    assert max(lightness) > min(lightness) + 60


class _LowScreenDialog(VisibilityDialog):
    """Visibility dialogue on a low screen."""

    @property
    def available_size(self) -> QSize:
        return LOW_SCREEN


def test_a_study_fits_a_low_screen(
    qtbot: QtBot, language: str, visibility_studies: list[VisibilityStudy]
) -> None:
    """The buttons used to be below the edge of the screen, and the last heading was cut off."""
    dialog = _LowScreenDialog(visibility_studies)
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitUntil(lambda: dialog.canvas.isVisible(), timeout=WAIT_MS)
    for site in range(dialog.site.count()):
        dialog.site.setCurrentIndex(site)
        finish_layouts()
        assert dialog.height() <= LOW_SCREEN.height()
        assert dialog.width() <= LOW_SCREEN.width()
        close = dialog.findChild(QPushButton, "visibility_close")
        assert close.mapTo(dialog, close.rect().bottomRight()).y() < LOW_SCREEN.height()
        assert dialog.canvas.height() >= 150
        header = dialog.table.horizontalHeader()
        assert dialog.table.horizontalScrollBar().maximum() == 0
        for section in range(header.count()):
            assert header.sectionSize(section) >= header.sectionSizeHint(section)


def test_comparisons_are_read_without_scrolling_on_a_small_screen(
    driver: Driver, demo: Demo, validated: Project, language: str
) -> None:
    window = driver.window
    window.resize(*SMALL_WINDOW)
    window.document.open(validated, demo.survey)
    show_panel(window, "Histograms")
    driver.rest()
    driver.bot.waitUntil(window.histograms.table.isVisible, timeout=WAIT_MS)
    assert window.width() == SMALL_WINDOW[0]
    assert window.histograms.table.horizontalScrollBar().maximum() == 0


def test_the_curve_of_the_patch_test_is_beside_the_picture_from_the_start(
    qtbot: QtBot, qapp: QApplication
) -> None:
    """The curve used to be below the picture until the panel was resized."""
    theme.apply_theme(qapp)
    panel = PatchTestPanel()
    qtbot.addWidget(panel)
    panel.resize(1240, 252)
    panel.show()
    finish_layouts()
    panel._middle.setCurrentIndex(1)
    finish_layouts()
    assert panel.curve.x() > panel.picture.x()


def test_buttons_are_in_the_order_of_the_system(qtbot: QtBot) -> None:
    standard = QDialogButtonBox.StandardButton
    system = QDialogButtonBox(standard.Ok | standard.Cancel)
    qtbot.addWidget(system)
    system.show()
    dialog = IdentityDialog(Identity(), str, {}, {})
    qtbot.addWidget(dialog)
    dialog.show()
    keep, cancel = (
        dialog.findChild(QPushButton, f"identity_{name}") for name in ("keep", "cancel")
    )
    first = system.button(standard.Ok).x() < system.button(standard.Cancel).x()
    assert (keep.x() < cancel.x()) == first


def test_enter_closes_an_error_message(qtbot: QtBot) -> None:
    """Close is the default button, not Details."""
    box = error_box(None, ZeroDivisionError("by zero"))
    qtbot.addWidget(box)
    assert box.defaultButton() is box.button(QMessageBox.StandardButton.Close)


def test_no_line_crosses_the_letters_of_the_sketch(qtbot: QtBot, qapp: QApplication) -> None:
    """With the scanner at the POS centre the body's axes lie below the scanner's."""
    theme.apply_theme(qapp)
    sketch = MountingSketch()
    qtbot.addWidget(sketch)
    sketch.resize(sketch.sizeHint())
    sketch.show_mounting((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    picture = sketch.grab().toImage()
    _, tip = sketch.axis_ends("above", 0)  # the forward axis points up in the picture, in the hull
    hull = QColor(theme.HULL)
    grey = [
        (x, y)
        for x in range(round(tip.x()) - 6, round(tip.x()) + 7)
        for y in range(round(tip.y()) - 13, round(tip.y()) - 2)
        if (pixel := picture.pixelColor(x, y)).lightness() < hull.lightness() - 20
        and max(pixel.red(), pixel.green(), pixel.blue()) - min(pixel.red(), pixel.green()) < 30
    ]
    assert not grey


def test_side_labels_of_the_sketch_do_not_overlap_the_hull(language: str) -> None:
    sketch = MountingSketch()
    sketch.resize(sketch.minimumSizeHint())
    for place, words in sketch.side_labels("above").items():
        for other, others in sketch.side_labels("above").items():
            assert place == other or not words.intersects(others), (place, other)
        assert not sketch.hull("above").intersects(QPolygonF(words)), place


def test_no_lengths_are_shown_without_a_clip_box(qtbot: QtBot) -> None:
    panel = ClippingPanel()
    qtbot.addWidget(panel)
    assert [field.text() for field in panel.fields] == ["–"] * 3
    panel.show_box(Box(np.zeros(3), np.eye(3), np.full(3, 0.5)))
    assert {field.text() for field in panel.fields} == {"1.00 m"}
    panel.show_box(None)
    assert [field.text() for field in panel.fields] == ["–"] * 3


def test_lines_to_the_labels_of_two_targets_do_not_cross(qapp: QApplication) -> None:
    metrics, occupied, boxes = QFontMetricsF(qapp.font()), [], []
    spots = np.array([[300.0, 200.0], [318.0, 202.0], [600.0, 200.0]])
    for k, spot in enumerate(spots):
        leftwards = has_right_neighbour(spots, k)
        place = QPoint(round(spot[0]), round(spot[1])).toPointF()
        boxes.append(free_label_place(place, metrics, f"T{k}", occupied, leftwards=leftwards))
        occupied.append(boxes[-1])
    assert boxes[0].right() < spots[0, 0]
    assert boxes[1].left() > spots[1, 0]
    assert boxes[2].left() > spots[2, 0]


def test_headings_of_the_design_tables_are_aligned_with_their_numbers(
    qtbot: QtBot, tmp_path: Path, design: DesignWindow
) -> None:
    for table in design.findChildren(NumberTable):
        for column in range(table.columnCount()):
            side = table.horizontalHeaderItem(column).textAlignment()
            if table.rowCount():
                assert side == table.item(0, column).textAlignment()
            assert side & (Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignRight)


def cut_choices(window: QWidget) -> list[str]:
    """Names of the visible combo boxes that do not show the whole chosen item."""
    boxes = [each for each in window.findChildren(QComboBox) if each.isVisible()]
    assert boxes
    return [each.objectName() for each in boxes if _is_cut(each)]


def _is_cut(box: QComboBox) -> bool:
    """Whether an item is wider than its box, or the box than the area that scrolls it."""
    area = box.parentWidget()
    while area is not None and not isinstance(area, QScrollArea):
        area = area.parentWidget()
    right = 0 if area is None else box.mapTo(area.viewport(), QPoint(box.width(), 0)).x()
    is_beyond = area is not None and right > area.viewport().width()
    return is_beyond or (isinstance(box, ChoiceBox) and box.is_cut)


def test_no_chosen_item_is_cut_in_the_window(
    language: str, driver: Driver, demo: Demo, validated: Project
) -> None:
    window = driver.window
    window.resize(*SMALL_WINDOW)
    window.document.open(validated, demo.survey)
    driver.rest()
    for step in (1, 2, 3, 4):
        window.workflow.open(step)
        for group in window.workflow.findChildren(FoldableGroup):
            group.open()
        driver.rest()
        # The panel becomes as wide as its content
        driver.bot.waitUntil(lambda: not cut_choices(window.workflow), timeout=WAIT_MS)
    for title in ("Histograms", "Section"):
        show_panel(window, title)
        driver.rest()
        assert cut_choices(window.docks[title]) == [], (language, title)


def test_no_chosen_item_is_cut_in_the_import(
    language: str, qtbot: QtBot, demo: Demo, tmp_path: Path
) -> None:
    dialog = ImportDialog(AppSettings(tmp_path / "settings.ini"))
    qtbot.addWidget(dialog)
    dialog.resize(LOW_SCREEN)
    dialog.show()
    drop(dialog, raw(demo))
    import_rest(qtbot, dialog)
    for row in range(dialog.table.rowCount()):
        dialog.table.selectRow(row)
        finish_layouts()
        assert cut_choices(dialog) == [], (language, row)
    dialog.done(0)


def test_the_list_of_a_narrow_box_shows_whole_items(qtbot: QtBot) -> None:
    box = ChoiceBox("narrow", ["short", "an item that is much wider than its combo box"], "Tip")
    qtbot.addWidget(box)
    box.setFixedWidth(80)
    box.show()
    assert not box.is_cut
    box.setCurrentIndex(1)
    assert box.is_cut
    help_event = QHelpEvent(QEvent.Type.ToolTip, QPoint(5, 5), box.mapToGlobal(QPoint(5, 5)))
    QApplication.sendEvent(box, help_event)
    assert box.currentText() in QToolTip.text()
    qtbot.mouseClick(box, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(box.view().isVisible, timeout=WAIT_MS)
    assert box.view().viewport().width() >= box.view().sizeHintForColumn(0)
    box.hidePopup()


@pytest.mark.parametrize("size", [(1366, 740), pytest.param((1600, 960), marks=LONG)])
@pytest.mark.parametrize("height", others_long([160, 380]))
def test_the_titles_of_a_section_do_not_overlap(
    driver: Driver, demo: Demo, estimated: Project, language: str, size: tuple[int, int],
    height: int,
) -> None:  # fmt: skip
    window = driver.window
    window.resize(*size)
    window.document.open(estimated, demo.survey)
    driver.rest()
    window._select("V1", "")
    press(driver, Key.Key_S)
    driver.rest()
    window.resizeDocks([window.docks["Section"]], [height], Qt.Orientation.Vertical)
    driver.rest()
    canvas = window.tools.sections.panel.canvas
    canvas.draw()
    titles = [
        next(
            text.get_window_extent() for text in axes.findobj(Text)
            if text.get_text() == axes.get_title(loc="left")
        )
        for axes in canvas.figure.axes
    ]  # fmt: skip
    assert len(titles) == 2
    assert titles[0].x1 < titles[1].x0
    assert titles[1].x1 <= canvas.figure.bbox.x1
