"""Tests of the layout: share of the 3D view in each state, panels that open and stay closed."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QSize, Qt
from PySide6.QtGui import QAction, QHelpEvent, QMouseEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QLabel,
    QMenu,
    QScrollArea,
    QToolBar,
    QToolButton,
    QToolTip,
    QWidget,
)
from pytestqt.qtbot import QtBot

from lispac.acceptance import AcceptanceCriteria
from lispac.gui.app.docks import SIDE_WIDTH_PX
from lispac.gui.app.language import set_language
from lispac.gui.app.panel_window import PanelWindow
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.unavailable import Unavailable
from lispac.gui.appearance import theme
from lispac.gui.features.validate.histograms_panel import PAIRS_VIEW
from lispac.gui.project.status import ADJUST, DATA, VALIDATE
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.widgets import Button
from lispac.gui.window.session import Session
from lispac.language import LANGUAGES
from lispac.project import Project
from tests.gui.by_hand import choose, open_menu
from tests.gui.design_support import opened_by_keys
from tests.gui.support import (
    Control,
    Demo,
    Driver,
    Key,
    Left,
    click,
    estimate,
    finish_layouts,
    in_front,
    open_step,
    press,
    seed,
    sentence,
    show_panel,
)
from tests.support.long_runs import LONG, others_long

SIZES = {(1920, 1080): 0.55, (1600, 1000): 0.55, (1366, 768): 0.45}
"""Smallest share of the view by the size of the window, pixels."""
SMALLEST = min(SIZES)
SOON_MS = 10_000
MOVES = {"keep_picture", "fit", "view", "view_along", "step_view"}
"""Calls of the viewport that keep or move the scene."""


def shown_docks(driver: Driver) -> set[str]:
    return {title for title, dock in driver.window.docks.items() if dock.isVisible()}


def is_in_front(driver: Driver, title: str) -> bool:
    return not driver.window.docks[title].visibleRegion().isEmpty()


def view_share(driver: Driver) -> float:
    """Area of the 3D view, or of the start page, relative to the window."""
    window = driver.window
    driver.rest()
    view = window.viewport.widget if window.document.project else window.central_widget.start
    assert view.isVisible()
    return view.width() * view.height() / (window.width() * window.height())


# -- share of the view -----------------------------------------------------------------------


@pytest.fixture(params=LANGUAGES)
def language(request: pytest.FixtureRequest) -> Iterator[str]:
    """Language of the windows that are created during the test."""
    set_language(request.param)
    yield request.param
    set_language("en")


@pytest.mark.usefixtures("language")
@pytest.mark.parametrize(
    "size", [pytest.param(size, marks=() if size == SMALLEST else LONG) for size in SIZES]
)
def test_the_toolbar_shows_all_its_buttons(driver: Driver, size: tuple[int, int]) -> None:
    driver.window.resize(*size)
    driver.rest()
    (toolbar,) = driver.window.findChildren(QToolBar, "toolbar")
    assert all(button.isVisible() for button in toolbar.findChildren(QAbstractButton)[1:])


@pytest.mark.parametrize(
    "size", [pytest.param(size, marks=() if size == SMALLEST else LONG) for size in SIZES]
)
def test_the_view_has_most_of_the_window_in_every_state(
    language: str, driver: Driver, demo: Demo, estimated: Project, validated: Project,
    size: tuple[int, int],
) -> None:  # fmt: skip
    window, document = driver.window, driver.window.document
    shares = {}

    def measure(state: str) -> None:
        window.resize(*size)
        shares[state] = view_share(driver)
        assert (window.width(), window.height()) == size, state

    measure("start")
    document.open(demo.project, demo.survey)
    measure("import done")
    assert shown_docks(driver) == {"Workflow"}
    document.open(demo.picked, demo.survey)
    measure("picked")
    assert shown_docks(driver) == {"Workflow", "Targets by line"}
    document.open(estimated, demo.survey)
    measure("estimated")
    assert shown_docks(driver) == {"Workflow", "Targets by line", "Results"}
    document.open(validated, demo.survey)
    measure("validated")
    assert shown_docks(driver) == {"Workflow", "Targets by line", "Results", "Histograms"}
    exceeded = AcceptanceCriteria(rms=1e-6, p95=1e-6, offset=1e-6)
    document.edit("criteria", replace(validated, acceptance=exceeded))
    measure("criteria exceeded")
    window.workflow.open(ADJUST)
    for group in (window.adjust.also, window.adjust.advanced):
        group.open()
    measure("options unfolded")
    assert window.docks["Workflow"].width() == SIDE_WIDTH_PX
    show_panel(window, "Histograms")
    histograms = window.histograms
    choice = histograms.plot.mapToGlobal(QPoint())
    histograms.plot.setCurrentIndex(PAIRS_VIEW)
    measure("pairs of lines")
    assert histograms.plot.mapToGlobal(QPoint()) == choice
    click(driver, histograms.enlarge)
    driver.rest()
    above = histograms.plot.mapTo(histograms, QPoint())
    click(driver, histograms.enlarge)
    measure("pairs of lines, reduced again")
    assert histograms.plot.mapTo(histograms, QPoint()) == above
    assert shares["pairs of lines, reduced again"] == pytest.approx(shares["validated"], abs=0.002)
    histograms.plot.setCurrentIndex(0)
    window._select("T1", "")
    press(driver, Key.Key_S)
    driver.bot.waitUntil(lambda: is_in_front(driver, "Section"), timeout=SOON_MS)
    measure("section")
    press(driver, Key.Key_T, Control)
    assert window.panel_windows["Patch test"].isVisible()
    measure("patch test")
    press(driver, Key.Key_D, Control)
    assert window.panel_windows["Diagnostics"].isVisible()
    measure("diagnostics")
    press(driver, Key.Key_D, Control | Qt.KeyboardModifier.ShiftModifier)
    driver.bot.waitUntil(lambda: window.site_design.window is not None, timeout=SOON_MS)
    measure("design")
    assert min(shares.values()) >= SIZES[size], (language, shares)
    print(language, size, {state: round(share, 2) for state, share in shares.items()})
    assert shares["start"] >= 0.6
    assert shares["import done"] >= 0.6


@pytest.mark.parametrize("size", [(1366, 768), pytest.param((1600, 1000), marks=LONG)])
@pytest.mark.parametrize("again", others_long(["new window", "next start"]))
def test_a_layout_without_lower_panels_leaves_the_view_its_share(
    session: Session, qtbot: QtBot, demo: Demo, estimated: Project, size: tuple[int, int],
    again: str,
) -> None:  # fmt: skip
    """The height of panels that were never shown is not stored as that of the user."""
    window = session.window
    window.resize(*size)
    qtbot.wait(200)
    if again == "new window":
        window.settings.theme = "dark"
        session.rebuild_window()
        window = session.window
    else:
        window.save_layout()
        window.discard()
        window = session.window = session._create_window(None)
    qtbot.waitUntil(lambda: in_front(window), timeout=SOON_MS)
    window.document.open(estimated, demo.survey)
    qtbot.waitUntil(lambda: not window.runner.active, timeout=SOON_MS)
    qtbot.waitUntil(window.docks["Results"].isVisible, timeout=SOON_MS)
    finish_layouts()
    view = window.viewport.widget
    screen = window.screen().size()
    if size == (screen.width(), screen.height()):
        # Qt makes a restored window smaller, because its frame would be outside the screen
        assert (window.width(), window.height()) < size
    else:
        assert (window.width(), window.height()) == size
    assert view.width() * view.height() >= SIZES[size] * window.width() * window.height()


def test_the_steps_with_assumed_noise_fit_into_the_initial_width(
    language: str, driver: Driver, demo: Demo
) -> None:
    settings = replace(demo.project.settings, lidar_beam_sigma=None)
    driver.window.document.open(replace(demo.project, settings=settings), demo.survey)
    driver.rest()
    open_step(driver, DATA)
    assert driver.window.data.angle_sigma.isVisibleTo(driver.window.data)
    assert driver.window.docks["Workflow"].minimumSizeHint().width() <= SIDE_WIDTH_PX, language


@pytest.mark.usefixtures("language")
@pytest.mark.parametrize("height", others_long([1000, *range(900, 1030, 9)]))
def test_no_row_of_the_angles_is_cut(
    driver: Driver, demo: Demo, validated: Project, height: int
) -> None:
    driver.window.resize(1600, height)
    driver.window.document.open(validated, demo.survey)
    show_panel(driver.window, "Results")
    driver.rest()
    (area,) = driver.window.results.findChildren(QScrollArea)
    table, limit = driver.window.results.angles, area.viewport().height()
    top = table.viewport().mapTo(area.viewport(), QPoint()).y()
    rows = [
        (start := top + table.rowViewportPosition(row), start + table.rowHeight(row))
        for row in range(table.rowCount())
    ]
    assert rows[1][1] <= limit, "the estimated angles are visible"
    assert not [each for each in rows if each[0] < limit < each[1]]
    assert height < 1000 or rows[-1][1] <= limit, "the whole table is visible"


# -- panels that open by themselves ----------------------------------------------------------


@LONG
def test_tables_and_results_open_when_there_is_something_to_show(opened: Driver) -> None:
    assert shown_docks(opened) == {"Workflow"}
    for name in ("T1", "T2", "V1"):
        seed(opened, name)
        press(opened, Key.Key_Return)
        opened.rest()
    assert shown_docks(opened) == {"Workflow"}
    press(opened, Key.Key_F9)
    opened.rest()
    opened.bot.waitUntil(lambda: is_in_front(opened, "Results"), timeout=SOON_MS)
    assert shown_docks(opened) == {"Workflow", "Results", "Targets by line"}
    press(opened, Key.Key_F10)
    opened.rest()
    opened.bot.waitUntil(lambda: is_in_front(opened, "Histograms"), timeout=SOON_MS)


@LONG
def test_the_scene_stays_in_place_when_a_target_is_accepted(opened: Driver) -> None:
    """No panel opens while targets are picked; the results keep the scene where it is."""
    opened.window.resize(1600, 1000)
    opened.rest()
    calls, view = opened.viewport.calls, opened.viewport.widget
    size = view.size()
    for name in ("T1", "T2"):
        seed(opened, name)
        calls.clear()
        press(opened, Key.Key_Return)
        opened.rest()
        assert view.size() == size
        assert [name for name, _ in calls if name in MOVES] == []
    estimate(opened)
    assert is_in_front(opened, "Results")
    assert [name for name, _ in calls if name in MOVES] == ["keep_picture"]
    assert view_share(opened) >= SIZES[1600, 1000]


@pytest.mark.parametrize("size", [(1366, 768), pytest.param((1920, 1080), marks=LONG)])
def test_tables_show_several_rows(
    driver: Driver, demo: Demo, validated: Project, size: tuple[int, int]
) -> None:
    window = driver.window
    window.resize(*size)
    driver.rest()
    window.document.open(validated, demo.survey)
    driver.rest()
    show_panel(window, "Targets by line")
    driver.rest()
    table = window.table
    heading = table.sightings.headerData(0, Qt.Orientation.Horizontal, Qt.ItemDataRole.DisplayRole)
    assert "RMS" in heading, "the numbers of the cells are named"
    tip = table.sightings.headerData(0, Qt.Orientation.Horizontal, Qt.ItemDataRole.ToolTipRole)
    assert "quality" in tip
    assert table.viewport().height() >= 5 * table.rowHeight(0)
    show_panel(window, "Histograms")
    driver.rest()
    planes = window.histograms.table
    space = window.histograms.height() - planes.horizontalHeader().height()
    assert space >= 5 * planes.rowHeight(0)


@LONG
def test_a_panel_that_the_user_closed_stays_closed(
    driver: Driver, demo: Demo, estimated: Project, qtbot: QtBot, tmp_path: Path
) -> None:
    window = driver.window
    window.document.open(estimated, demo.survey)
    driver.rest()
    close = window.docks["Results"].findChild(QAbstractButton, "qt_dockwidget_closebutton")
    click(driver, close)
    estimate(driver)
    assert not window.docks["Results"].isVisible()
    window.document.open(replace(estimated, result=None, cross_checks=None), demo.survey)
    window.document.open(estimated, demo.survey)
    driver.rest()
    assert shown_docks(driver) == {"Workflow", "Targets by line"}
    window.close()
    later = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        later.window.document.open(estimated, demo.survey)
        later.rest()
        assert shown_docks(later) == {"Workflow", "Targets by line"}
        choose(qtbot, open_menu(qtbot, later.window, "View"), "Panels", "Results")
        qtbot.waitUntil(lambda: is_in_front(later, "Results"), timeout=SOON_MS)
        later.window.document.open(demo.project, demo.survey)
        assert shown_docks(later) == {"Workflow"}
        later.window.document.open(estimated, demo.survey)
        assert "Results" in shown_docks(later), "opened again by the user"
    finally:
        later.leave()


def drag_separator(driver: Driver, dock: QWidget, higher: int) -> None:
    """Drag the separator above a panel with the mouse, by a number of pixels."""
    window, bot = driver.window, driver.bot
    top = dock.geometry().top()
    column = [QPoint(dock.geometry().center().x(), y) for y in range(top, top - 60, -1)]
    start = next(each for each in column if window.isSeparator(each))  # above the tabs
    bot.mousePress(window, Left, pos=start)
    for k in range(1, 5):  # `mouseMove` would press no button
        place = QPointF(start - QPoint(0, round(k * higher / 4)))
        moved = QMouseEvent(
            QEvent.Type.MouseMove, place, QPointF(window.mapToGlobal(place.toPoint())), Left, Left,
            Qt.KeyboardModifier.NoModifier,
        )  # fmt: skip
        QApplication.sendEvent(window, moved)
        bot.wait(50)
    bot.mouseRelease(window, Left, pos=start - QPoint(0, higher))
    driver.rest()


@LONG
def test_the_height_of_the_panels_is_kept(
    driver: Driver, demo: Demo, estimated: Project, qtbot: QtBot, tmp_path: Path
) -> None:
    window = driver.window
    window.document.open(estimated, demo.survey)
    driver.rest()
    before = window.docks["Results"].height()
    drag_separator(driver, window.docks["Results"], 290 - before)
    window.document.open(demo.project, demo.survey)
    driver.rest()
    assert shown_docks(driver) == {"Workflow"}
    window.document.open(estimated, demo.survey)
    driver.rest()
    height = window.docks["Results"].height()
    assert height == pytest.approx(290, abs=30)
    window.close()
    later = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        assert shown_docks(later) == {"Workflow"}
        later.window.document.open(estimated, demo.survey)
        later.rest()
        assert later.window.docks["Results"].height() == height
    finally:
        later.leave()


@LONG
def test_tools_and_enlarged_panels_leave_the_view_to_another_project(
    driver: Driver, demo: Demo, estimated: Project, qtbot: QtBot, tmp_path: Path
) -> None:
    window = driver.window
    window.document.open(estimated, demo.survey)
    driver.rest()
    initial = view_share(driver)
    window._select("T1", "")
    press(driver, Key.Key_X)
    press(driver, Key.Key_S)
    qtbot.waitUntil(lambda: is_in_front(driver, "Section"), timeout=SOON_MS)
    click(driver, window.tools.sections.panel.enlarge)
    qtbot.waitUntil(lambda: view_share(driver) < 0.8 * initial, timeout=SOON_MS)
    window.document.open(demo.project, demo.survey)
    assert shown_docks(driver) == {"Workflow"}
    assert view_share(driver) >= 0.6
    seed(driver, "T1")
    press(driver, Key.Key_Return)
    driver.rest()
    assert shown_docks(driver) == {"Workflow"}
    window._select("T1", "")
    press(driver, Key.Key_S)
    qtbot.waitUntil(lambda: is_in_front(driver, "Section"), timeout=SOON_MS)
    assert view_share(driver) == pytest.approx(initial, abs=0.01)
    click(driver, window.tools.sections.panel.enlarge)
    qtbot.waitUntil(lambda: view_share(driver) < 0.8 * initial, timeout=SOON_MS)
    window.close()
    later = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        later.window.document.open(estimated, demo.survey)
        later.rest()
        assert shown_docks(later) == {"Workflow", "Targets by line", "Results"}
        assert view_share(later) == pytest.approx(initial, abs=0.01)
    finally:
        later.leave()


@pytest.mark.parametrize("maximised", others_long([False, True]))
def test_a_tool_stays_open_in_a_new_window_of_the_same_project(
    session: Session, demo: Demo, qtbot: QtBot, maximised: bool
) -> None:
    window = session.window
    window.document.open(demo.picked, demo.survey)
    show_panel(window, "Section")
    assert not window.docks["Section"].visibleRegion().isEmpty()
    if maximised:
        qtbot.keyClick(window, Key.Key_F11)
    session.rebuild_window()
    later = session.window
    assert later is not window
    qtbot.waitUntil(lambda: in_front(later), timeout=SOON_MS)
    if maximised:
        assert not later.docks["Section"].isVisible()
        qtbot.keyClick(later, Key.Key_F11)
    section = later.docks["Section"]
    qtbot.waitUntil(lambda: not section.visibleRegion().isEmpty(), timeout=SOON_MS)


# -- maximised view --------------------------------------------------------------------------


def geometry(driver: Driver) -> dict[str, QRect | None]:
    docks = driver.window.docks
    return {t: docks[t].geometry() if is_in_front(driver, t) else None for t in docks}


@LONG
def test_one_key_maximises_the_view_and_restores_the_former_state(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    window = driver.window
    window.document.open(validated, demo.survey)
    driver.rest()
    show_panel(window, "Targets by line")
    window.docks["Workflow"].setFloating(True)
    driver.rest()
    before = geometry(driver)
    press(driver, Key.Key_F11)
    assert shown_docks(driver) == set()
    assert not window.findChild(QToolBar).isVisible()
    assert view_share(driver) > 0.9
    assert window.actions_["maximise"].isChecked()
    press(driver, Key.Key_F11)
    driver.bot.waitUntil(lambda: geometry(driver) == before, timeout=SOON_MS)
    assert window.findChild(QToolBar).isVisible()
    assert not window.actions_["maximise"].isChecked()


def test_a_panel_that_is_opened_ends_the_maximised_view(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    window = driver.window
    window.document.open(validated, demo.survey)
    driver.rest()
    press(driver, Key.Key_F11)
    press(driver, Key.Key_F12)
    docks = {"Workflow", "Results", "Targets by line", "Histograms", "Messages"}
    driver.bot.waitUntil(lambda: shown_docks(driver) == docks, timeout=SOON_MS)
    driver.bot.waitUntil(lambda: is_in_front(driver, "Messages"), timeout=SOON_MS)
    assert not window.actions_["maximise"].isChecked()


@LONG
def test_a_maximised_view_is_not_stored(
    driver: Driver, demo: Demo, estimated: Project, qtbot: QtBot, tmp_path: Path
) -> None:
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    press(driver, Key.Key_F11)
    driver.window.close()
    later = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        later.window.document.open(estimated, demo.survey)
        later.rest()
        assert shown_docks(later) == {"Workflow", "Targets by line", "Results"}
    finally:
        later.leave()


# -- windows of panels -----------------------------------------------------------------------


def test_a_panel_window_closes_with_its_keys_and_with_the_main_window(
    driver: Driver, qtbot: QtBot
) -> None:
    own = driver.window.panel_windows["Patch test"]
    for key, modifier in ((Key.Key_Escape, Qt.KeyboardModifier.NoModifier), (Key.Key_W, Control)):
        press(driver, Key.Key_T, Control)
        qtbot.waitUntil(own.isActiveWindow, timeout=SOON_MS)
        qtbot.keyClick(own, key, modifier)
        assert not own.isVisible()
        driver.window.activateWindow()
        qtbot.waitUntil(driver.window.isActiveWindow, timeout=SOON_MS)
    press(driver, Key.Key_T, Control)
    driver.window.close()
    assert not own.isVisible()


@pytest.mark.parametrize("title", ["Diagnostics", "Patch test"])
def test_a_panel_window_stays_above_the_main_window(driver: Driver, title: str) -> None:
    key = {"Diagnostics": Key.Key_D, "Patch test": Key.Key_T}[title]
    window, own = driver.window, driver.window.panel_windows[title]
    press(driver, key, Control)
    driver.bot.waitUntil(own.isActiveWindow, timeout=SOON_MS)
    # The window system keeps dialogues above the window that they belong to, and no other windows
    assert own.windowType() == Qt.WindowType.Dialog
    assert own.windowHandle().transientParent() is window.windowHandle()
    assert own.windowModality() == Qt.WindowModality.NonModal
    window.activateWindow()
    click(driver, window.workflow.headers[VALIDATE])
    assert own.isVisible()
    driver.bot.waitUntil(window.isActiveWindow, timeout=SOON_MS)
    press(driver, key, Control)
    driver.bot.waitUntil(own.isActiveWindow, timeout=SOON_MS)


def test_the_design_window_comes_back_with_its_key(driver: Driver) -> None:
    window, design = driver.window, opened_by_keys(driver)
    for hide in (lambda: None, design.showMinimized):
        hide()
        window.activateWindow()
        driver.bot.waitUntil(window.isActiveWindow, timeout=SOON_MS)
        click(driver, window.workflow.headers[VALIDATE])
        assert opened_by_keys(driver) is design
        assert not design.isMinimized()


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_panel_window_first_opens_beside_the_view(
    qtbot: QtBot, tmp_path: Path, side: str
) -> None:
    main, view, settings = QWidget(), QLabel(), AppSettings(tmp_path / "settings.ini")
    qtbot.addWidget(main)
    screen = main.screen().availableGeometry()
    width, free = screen.width(), 3 * screen.width() // 8
    main.setGeometry(screen.adjusted(0, 0, 0, -screen.height() // 4))
    view.setParent(main)
    view.setGeometry(free if side == "left" else 0, 0, width - free, main.height())
    main.show()
    own = PanelWindow("Patch test", QLabel(), QSize(width // 4, 200), main, settings, view)
    own.bring_to_front()
    view_rect = QRect(view.mapToGlobal(QPoint()), view.size())
    assert not own.geometry().intersects(view_rect)


@pytest.mark.parametrize("size", [(1366, 740), (1600, 1000)])
def test_the_patch_test_covers_little_of_the_view(driver: Driver, size: tuple[int, int]) -> None:
    """It first opens over the workflow panel, without scroll bars."""
    window, own = driver.window, driver.window.panel_windows["Patch test"]
    screen = window.screen().availableGeometry()
    window.setGeometry(QRect(screen.topLeft(), QSize(*size)))
    driver.rest()
    press(driver, Key.Key_T, Control)
    driver.bot.waitUntil(own.isActiveWindow, timeout=SOON_MS)
    driver.rest()
    view = window.central_widget
    rect = QRect(view.mapToGlobal(QPoint()), view.size())
    covered = own.geometry().intersected(rect)
    assert covered.width() * covered.height() < 0.12 * rect.width() * rect.height()
    panel = window.panels["patch_test"]
    panel.show_objects(["O1", "O2"], (), "O1")
    driver.rest()
    (area,) = panel.findChildren(QScrollArea, options=Qt.FindChildOption.FindDirectChildrenOnly)
    assert area.horizontalScrollBar().maximum() == area.verticalScrollBar().maximum() == 0
    assert panel.picture.y() < panel.curve.y() or size[1] < 800


@LONG
def test_the_patch_test_opens_where_the_user_has_put_it(
    driver: Driver, qtbot: QtBot, tmp_path: Path
) -> None:
    window, own = driver.window, driver.window.panel_windows["Patch test"]
    press(driver, Key.Key_T, Control)
    qtbot.waitUntil(own.isActiveWindow, timeout=SOON_MS)
    own.resize(600, 400)
    own.move(own.screen().availableGeometry().topLeft() + QPoint(37, 60))
    place = own.geometry()
    qtbot.keyClick(own, Key.Key_Escape)
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=SOON_MS)
    window.close()
    later = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        press(later, Key.Key_T, Control)
        own = later.window.panel_windows["Patch test"]
        qtbot.waitUntil(own.isVisible, timeout=SOON_MS)
        assert own.geometry() == place
    finally:
        later.leave()


def test_the_keys_of_the_main_window_work_in_a_panel_window(picked: Driver, qtbot: QtBot) -> None:
    picked.window.controller.remove("V1")
    press(picked, Key.Key_T, Control)
    own = picked.window.panel_windows["Patch test"]
    qtbot.waitUntil(own.isActiveWindow, timeout=SOON_MS)
    assert len(picked.project.targets) == 2
    qtbot.keyClick(own, Key.Key_Z, Control)
    assert len(picked.project.targets) == 3


def test_a_click_tool_of_a_panel_window_continues_in_the_main_window(
    opened: Driver, qtbot: QtBot
) -> None:
    press(opened, Key.Key_T, Control)
    own = opened.window.panel_windows["Patch test"]
    qtbot.waitUntil(own.isActiveWindow, timeout=SOON_MS)
    click(opened, opened.window.panels["patch_test"].point)
    qtbot.waitUntil(opened.window.isActiveWindow, timeout=SOON_MS)
    qtbot.keyClick(opened.window, Key.Key_Escape)
    assert opened.window.tools.mouse_tool.tool == ""
    assert own.isVisible()


# -- menus and reasons -----------------------------------------------------------------------


def entries(menu: QWidget) -> list[QAction]:
    """All entries of a menu bar or menu and of its submenus."""
    found = []
    for action in menu.actions():
        if not action.isSeparator():
            found += [action, *(entries(action.menu()) if action.menu() else [])]
    return found


def states(demo: Demo, estimated: Project) -> dict[str, Project | None]:
    return {
        "no project": None, "no targets": demo.project, "picked": demo.picked,
        "estimated": estimated,
    }  # fmt: skip


def test_there_are_at_most_seven_menus(driver: Driver) -> None:
    assert len(driver.window.menuBar().actions()) <= 7


@LONG
def test_every_disabled_entry_gives_its_reason(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    actions, document = driver.window.actions_, driver.window.document
    texts = [each.text for each in Unavailable]
    for state, project in states(demo, estimated).items():
        document.open(project, None if project is None else demo.survey)
        driver.rest()
        disabled = [each for each in entries(driver.window.menuBar()) if not each.isEnabled()]
        assert disabled, state
        for action in disabled:
            assert any(text in action.toolTip() for text in texts), (state, action.text())
        for action in entries(driver.window.menuBar()):
            if action.isEnabled() and action in actions.all:
                assert not any(text in action.toolTip() for text in texts), action.text()
    document.open(None, None)
    reasons = {name: actions.reason(name) for name in ("save", "estimate", "validate", "budget")}
    assert set(reasons.values()) == {Unavailable.NO_PROJECT}
    document.open(demo.project, demo.survey)
    driver.rest()
    assert actions.reason("estimate") is Unavailable.NO_TARGET
    assert actions.reason("validate") is Unavailable.NO_PLANE
    document.open(demo.picked, demo.survey)
    driver.rest()
    assert actions.reason("estimate") is None
    assert actions.reason("validate") is Unavailable.NO_RESULT
    assert actions.reason("save") is Unavailable.SAVED
    document.open(estimated, demo.survey)
    driver.rest()
    assert actions.reason("validate") is None


def test_every_disabled_button_of_the_steps_gives_its_reason(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    texts = [each.text for each in Unavailable]
    window = driver.window
    for state, project in states(demo, estimated).items():
        window.document.open(project, None if project is None else demo.survey)
        driver.rest()
        buttons = [
            each
            for panel in (window.targets, window.adjust, window.validate, window.report)
            for each in panel.findChildren(Button)
            if each.tip and not each.isEnabled()
        ]
        assert buttons or state == "estimated"
        for button in buttons:
            if button.objectName() not in ("cancel_estimate", "show_after"):
                assert any(text in button.toolTip() for text in texts), (state, button.text())


@LONG
def test_commands_that_open_a_project_are_disabled_while_one_is_opened(
    driver: Driver, picked_folder: Path
) -> None:
    window = driver.window
    window.open_project(picked_folder)
    for name in ("new", "open", "demo"):
        assert window.actions_.reason(name) is Unavailable.BUSY
        link = window.central_widget.start.links[name]
        assert not link.isEnabled()
        assert Unavailable.BUSY.text in link.toolTip()
    advice = window.central_widget.start.findChild(QLabel, "start_advice")
    task, opening = advice.text(), sentence(driver, DATA)
    driver.rest()
    assert window.document.project is not None
    assert window.actions_["new"].isEnabled()
    assert sentence(driver, DATA) != opening
    window.central_widget.start.show_task("")
    assert advice.text() != task


@LONG
def test_the_steps_say_that_the_validation_is_running(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    window = driver.window
    window.document.open(estimated, demo.survey)
    driver.rest()
    before = window.report.advice.text()
    press(driver, Key.Key_F10)
    assert window.runner.current.key == "validate"
    running = window.report.advice.text(), sentence(driver, VALIDATE)
    assert running[0] != before
    driver.rest()
    assert driver.project.validation
    assert window.report.advice.text() not in (before, running[0])
    assert sentence(driver, VALIDATE) != running[1]


def tip_at(bot: QtBot, widget: QWidget, place: QPoint) -> str:
    """Text of the tip after the mouse has rested at a place."""
    QToolTip.hideText()
    bot.mouseMove(widget, place)
    QApplication.sendEvent(
        widget, QHelpEvent(QEvent.Type.ToolTip, place, widget.mapToGlobal(place))
    )
    return QToolTip.text()


def test_the_reason_is_the_tip_in_the_menu_and_in_the_toolbar(driver: Driver, qtbot: QtBot) -> None:
    window = driver.window
    menu: QMenu = open_menu(qtbot, window, "Calibrate")
    action = window.actions_["estimate"]
    assert Unavailable.NO_PROJECT.text in tip_at(qtbot, menu, menu.actionGeometry(action).center())
    menu.close()
    button = window.findChild(QToolBar).widgetForAction(action)
    assert Unavailable.NO_PROJECT.text in tip_at(qtbot, button, button.rect().center())
    qtbot.mouseClick(button, Left)
    assert not window.runner.active


@pytest.mark.usefixtures("language")
def test_buttons_without_a_place_in_the_toolbar_are_in_a_visible_menu(
    driver: Driver, qtbot: QtBot
) -> None:
    driver.window.resize(900, 700)
    driver.rest()
    (toolbar,) = driver.window.findChildren(QToolBar, "toolbar")
    more = toolbar.findChild(QToolButton, theme.EXTENSION_NAME)
    hidden = [
        action
        for action in toolbar.actions()
        if not action.isSeparator() and not toolbar.widgetForAction(action).isVisible()
    ]
    assert hidden
    assert toolbar.rect().contains(more.geometry())
    picture = more.grab().toImage()
    colours = {picture.pixel(x, y) for x in range(picture.width()) for y in range(picture.height())}
    assert len(colours) > 2, "the arrow is painted"
    qtbot.mouseClick(more, Left)
    qtbot.waitUntil(lambda: all(toolbar.widgetForAction(each).isVisible() for each in hidden))
