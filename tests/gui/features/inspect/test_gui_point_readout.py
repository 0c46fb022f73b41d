"""Tests of the values of the point under the mouse, and of the answers to a click in the view."""

import threading
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtGui import QColor, QGuiApplication, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFormLayout, QMenu, QToolTip, QWidget
from pytestqt.exceptions import TimeoutError as WaitTimeoutError

from lispac.gui.app.language import set_language
from lispac.gui.app.status_bar import FIELD_SEPARATOR
from lispac.gui.appearance import theme, units
from lispac.gui.features.inspect.point_readout import (
    NO_POINT_TEXT,
    READ_DELAY_MS,
    TOOLTIP_DELAY_MS,
    tooltip_corner,
)
from lispac.gui.features.pick_targets.seed_coordinates import SeedCoordinatesDialog
from lispac.gui.viewport.base import Marker, PickedPoint
from lispac.gui.viewport.overlay import AXIS_LABELS, MARGIN_PX
from lispac.gui.viewport.point_picker import PICK_RADII_PX
from lispac.language import LANGUAGES, gettext
from lispac.picked_targets import Target
from lispac.progress import Progress
from lispac.project import Project
from lispac.workflow.calibration import picking
from lispac.workflow.planning.demo import demo_seeds
from tests.gui.features.pick_targets.test_gui_seed_coordinates import find
from tests.gui.support import (
    WAIT_MS,
    Control,
    Demo,
    Driver,
    Key,
    Left,
    press,
    seed,
    use_next_dialog,
)
from tests.support.long_runs import LONG, others_long
from tests.support.topocentric import east_north_up_by_proj, local_by_proj

Right, NoModifier = Qt.MouseButton.RightButton, Qt.KeyboardModifier.NoModifier
EMPTY, FOOT = QPoint(3, 3), 0.3048
SOON_MS = 5_000
"""Limit of waits for the end of a tooltip, which otherwise ends after 10 s."""
MAX_MOVES = 120
"""Largest number of times that the mouse is moved to a point."""


@pytest.fixture
def board(real: Driver, demo: Demo, estimated: Project) -> Driver:
    """A window that shows target T1 at a large scale."""
    real.window.document.open(estimated, demo.survey)
    real.rest()
    real.window._select("T1", "")
    real.viewport.prepare()
    return real


def board_pixel(driver: Driver) -> QPoint:
    """Pixel of a point near the middle of T1."""
    points = np.concatenate(list(driver.window.scene.selected_points.values()))
    middle = points[np.argmin(np.linalg.norm(points - points.mean(axis=0), axis=1))]
    x, y = driver.viewport.to_pixels(middle[None])[0]
    return QPoint(round(x), round(y))


def hover(driver: Driver, place: QPoint) -> dict[str, str]:
    """Rest the mouse at a pixel of the view; the values that are then shown.

    A late drawing of the lines discards the point under a resting mouse, which then moves again.
    """
    readout = driver.window.tools.point_readout
    for _ in range(MAX_MOVES):
        QTest.mouseMove(driver.viewport.canvas, place + QPoint(7, 0))
        QTest.mouseMove(driver.viewport.canvas, place)
        with suppress(WaitTimeoutError):
            driver.bot.waitUntil(lambda: bool(readout.values), timeout=WAIT_MS // MAX_MOVES)
            driver.bot.wait(5 * READ_DELAY_MS)  # the first values may be those of the first place
            if readout.values:
                break
    assert readout.values
    return dict(readout.values)


def leave_points(driver: Driver) -> None:
    """Move the mouse to a place of the view without points."""
    driver.viewport.view("isometric")
    QTest.mouseMove(driver.viewport.canvas, EMPTY)
    readout = driver.window.tools.point_readout
    driver.bot.waitUntil(lambda: not readout.values, timeout=WAIT_MS)


def number(text: str) -> float:
    return float(text.split("\N{NO-BREAK SPACE}")[0].replace("−", "-").replace("°", " ").split()[0])


def test_the_status_bar_shows_the_point_under_the_mouse(board: Driver) -> None:
    values = hover(board, board_pixel(board))
    cloud = board.window.scene.clouds[values["Line"]]
    place = [number(values[axis]) for axis in ("East", "North", "Up")]
    frame = board.window.document.survey.trajectory.frame
    distances = np.linalg.norm(east_north_up_by_proj(cloud.sample, frame) - place, axis=1)
    index = int(np.argmin(distances))
    assert distances[index] < 1e-3  # shown with millimetres
    points_lidar, time = cloud.sample_lidar(np.array([index]))
    assert number(values["Range"]) == pytest.approx(np.linalg.norm(points_lidar), abs=6e-4)
    assert number(values["Time"]) == pytest.approx(time[0], abs=6e-4)
    assert number(values["Intensity"]) == cloud.sample_intensity[index]
    target = board.project.target("T1")
    own = cloud[target.sighting(values["Line"]).indices]
    normal = np.linalg.svd(own - own.mean(axis=0), full_matrices=False)[2][2]
    beam = cloud.sample[index] - cloud.place(np.zeros((1, 3)), time)[0]
    angle = np.degrees(np.arccos(abs(normal @ beam) / np.linalg.norm(beam)))
    assert number(values["Incidence"]) == pytest.approx(angle, abs=2.0)
    shown = board.window.task_bar.point
    assert shown.isVisible()
    assert all(text in shown.text() for text in values.values())
    for width in range(200, 1600, 50):
        shown.resize(width, shown.height())
        # fields are omitted, never cut
        fields = shown.shown_text.split(FIELD_SEPARATOR)
        assert fields == shown.text().split(FIELD_SEPARATOR)[: len(fields)]
    leave_points(board)
    assert shown.text() == ""


@pytest.fixture(params=others_long(LANGUAGES, lambda code: code == "fr"))
def language(request: pytest.FixtureRequest) -> Iterator[str]:
    """Language of the window."""
    set_language(request.param)
    yield request.param
    set_language("en")


@LONG
def test_the_whole_point_is_shown_in_a_narrow_window(language: str, board: Driver) -> None:
    window = board.window
    window.resize(1366, 768)
    board.rest()
    values = hover(board, board_pixel(board))
    assert window.width() == 1366
    promised = ("East", "North", "Up", "Line", "Range", "Incidence", "Intensity", "Time")
    shown = window.task_bar.point
    assert shown.isVisible()
    fields = shown.shown_text.split(FIELD_SEPARATOR)
    names = {gettext(name) for name in promised}
    assert {gettext("{name}: {text}", name=n, text=values[n]) for n in names} <= set(fields)
    board.bot.waitUntil(QToolTip.isVisible, timeout=WAIT_MS)
    degrees = values[gettext("Incidence")].partition("°")[0].replace(",", ".")
    assert f"{float(degrees):.0f}°" in QToolTip.text()


@LONG
def test_ctrl_c_and_the_menu_copy_the_point(board: Driver) -> None:
    clipboard, canvas = QGuiApplication.clipboard(), board.viewport.canvas
    place = board_pixel(board)
    values = hover(board, place)
    clipboard.clear()
    canvas.setFocus()
    board.bot.keyClick(canvas, Key.Key_C, Control)
    copied = clipboard.text()
    assert dict(line.split("\t") for line in copied.splitlines()) == values
    clipboard.clear()
    board.bot.mouseClick(canvas, Right, NoModifier, place)
    menu = board.viewport.widget.findChild(QMenu, "point_menu")
    board.bot.waitUntil(menu.isVisible, timeout=WAIT_MS)
    board.bot.mouseClick(menu, Left, pos=menu.actionGeometry(menu.actions()[0]).center())
    assert clipboard.text() == copied
    board.bot.waitUntil(lambda: board.viewport.widget.findChild(QMenu, "point_menu") is None)
    clipboard.clear()
    leave_points(board)
    board.bot.keyClick(canvas, Key.Key_C, Control)
    assert clipboard.text() == ""
    before = board.viewport.camera
    board.bot.mousePress(canvas, Right, NoModifier, place)
    QTest.mouseMove(canvas, place + QPoint(60, 10))
    board.bot.mouseRelease(canvas, Right, NoModifier, place + QPoint(60, 10))
    assert board.viewport.camera is not before
    assert board.viewport.widget.findChild(QMenu, "point_menu") is None, "a drag pans"


@LONG
@pytest.mark.parametrize("length", others_long(["feet", "metres"]))
def test_a_copied_point_is_pasted_as_a_seed(board: Driver, length: str) -> None:
    clipboard, canvas = QGuiApplication.clipboard(), board.viewport.canvas
    units.set_units("degrees", length)
    try:
        values = hover(board, board_pixel(board))
        canvas.setFocus()
        board.bot.keyClick(canvas, Key.Key_C, Control)
        shown: list[list[str]] = []

        def use_dialog(dialog: SeedCoordinatesDialog) -> None:
            board.bot.keyClick(dialog.focusWidget(), Key.Key_V, Control)
            form = dialog.findChild(QFormLayout)
            shown.append([form.labelForField(field).text() for field in dialog.fields])
            shown.append([field.text() for field in dialog.fields])
            board.bot.mouseClick(find(dialog), Left)

        use_next_dialog(use_dialog)
        press(board, Key.Key_F3)
        board.rest()
    finally:
        units.set_units("degrees", "metres")
    clipboard.clear()
    names, texts = shown
    assert names == ["East (m)", "North (m)", "Up (m)"]
    assert texts == [values[axis] for axis in ("East", "North", "Up")]
    candidate, survey = board.window.controller.candidate, board.window.document.survey
    assert candidate is not None
    factor = FOOT if length == "feet" else 1.0
    place = np.array([[number(text) * factor for text in texts]])
    expected = local_by_proj(place, survey.trajectory.frame)[0]
    assert candidate.seed == pytest.approx(expected, abs=1e-6)
    cloud = board.window.scene.clouds[values["Line"]]
    assert np.linalg.norm(cloud.sample - candidate.seed, axis=1).min() < 1e-3


@LONG
def test_the_axes_point_as_the_coordinates_grow(board: Driver) -> None:
    """A point farther east, north or up is drawn in the direction of the axis of that name."""
    for key in (Key.Key_1, Key.Key_2, Key.Key_3):
        press(board, key)
        board.rest()
        assert_axes_point_as_the_coordinates_grow(board)


def assert_axes_point_as_the_coordinates_grow(board: Driver) -> None:
    view, frame = board.viewport, board.window.document.survey.trajectory.frame
    focal, right = view.camera.focal, view.camera.axes[0]
    length, start = 0.1, east_north_up_by_proj(focal, frame)
    across = np.ptp(view.to_pixels(np.array([focal, focal + length * right])), axis=0)
    picture = view.widget.overlay.grab().toImage()
    centre = np.array([MARGIN_PX + 42.0, view.widget.overlay.height() - MARGIN_PX - 42.0])
    assert [name for name, _ in AXIS_LABELS] == ["E", "N", "Up"]
    drawn = 0
    for axis, (_, colour) in zip(np.eye(3), AXIS_LABELS, strict=True):
        ends = local_by_proj(np.vstack([start, start + length * axis]), frame)
        share = np.subtract(*view.to_pixels(ends)[::-1]) / np.hypot(*across)
        if np.hypot(*share) > 0.3:  # else the axis points at the viewer
            places = [centre + 28.0 * part * share for part in (0.5, 0.7, 0.9)]
            assert all(has_colour(picture, each, theme.colour(colour)) for each in places), colour
            drawn += 1
    assert drawn >= 2


def has_colour(picture: QImage, place: np.ndarray, colour: QColor) -> bool:
    """Whether a pixel of a colour is within one pixel of a place on the widget."""
    x, y = (picture.devicePixelRatio() * place).round().astype(int).tolist()
    near = [picture.pixelColor(x + dx, y + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
    return any(each.rgb() == colour.rgb() for each in near)


@LONG
def test_the_values_have_the_unit_of_the_user_and_a_tooltip(board: Driver) -> None:
    place = board_pixel(board)
    metres = hover(board, place)
    board.bot.waitUntil(QToolTip.isVisible, timeout=WAIT_MS)
    brief = ("East", "North", "Up", "Line", "Range", "Intensity", "Time")
    assert all(metres[name] in QToolTip.text() for name in brief)
    assert QToolTip.text().count("<br>") < 5
    assert metres["Coordinate system"] not in QToolTip.text()
    leave_points(board)
    board.window._select("T1", "")
    board.rest()
    units.set_units("degrees", "feet")
    try:
        feet = hover(board, board_pixel(board))
    finally:
        units.set_units("degrees", "metres")
    assert feet["Range"].endswith("ft")
    place_m = np.array([number(feet[axis]) for axis in ("East", "North", "Up")]) * FOOT
    cloud = board.window.scene.clouds[feet["Line"]]
    frame = board.window.document.survey.trajectory.frame
    distances = np.linalg.norm(east_north_up_by_proj(cloud.sample, frame) - place_m, axis=1)
    index = int(np.argmin(distances))
    assert distances[index] < 1e-3
    points_lidar, _ = cloud.sample_lidar(np.array([index]))
    assert number(feet["Range"]) * FOOT == pytest.approx(np.linalg.norm(points_lidar), abs=6e-4)


@LONG
def test_the_tooltip_ends_with_a_move_and_with_picking(board: Driver) -> None:
    canvas, place = board.viewport.canvas, board_pixel(board)

    def show() -> None:
        hover(board, place)
        board.bot.waitUntil(QToolTip.isVisible, timeout=WAIT_MS)

    def tip() -> QWidget:
        return next(
            each for each in QApplication.topLevelWidgets()
            if each.inherits("QTipLabel") and each.isVisible()
        )  # fmt: skip

    show()
    assert not tip().geometry().adjusted(-40, -40, 40, 40).contains(canvas.mapToGlobal(place))
    near = QRect(canvas.mapToGlobal(place), QSize(1, 1)).adjusted(-90, -90, 90, 90)
    assert tip().geometry().intersects(near), "beside the mouse"
    with board.bot.waitSignal(tip().destroyed, timeout=SOON_MS):
        QTest.mouseMove(canvas, place + QPoint(40, 0))
    show()
    with board.bot.waitSignal(tip().destroyed, timeout=SOON_MS):
        QTest.keyPress(canvas, Key.Key_Control)
    QTest.keyRelease(canvas, Key.Key_Control)
    press(board, Key.Key_M)
    assert board.window.tools.mouse_tool.tool
    hover(board, place)
    board.bot.wait(2 * TOOLTIP_DELAY_MS)
    assert not QToolTip.isVisible()


@pytest.mark.parametrize("x", [0.02, 0.5, 0.98])
@pytest.mark.parametrize("y", [0.02, 0.5, 0.98])
def test_the_tooltip_is_beside_the_mouse_and_in_the_view(x: float, y: float) -> None:
    view, size = QRect(300, 80, 900, 600), QSize(320, 110)
    mouse = view.topLeft() + QPoint(round(x * view.width()), round(y * view.height()))
    tip = QRect(tooltip_corner(mouse, size, view), size)
    assert view.contains(tip)
    assert not tip.adjusted(-40, -15, 40, 15).contains(mouse)
    assert tip.intersects(QRect(mouse, QSize(1, 1)).adjusted(-60, -60, 60, 60))


@LONG
def test_no_tooltip_covers_the_view_while_a_candidate_waits(board: Driver) -> None:
    place = board_pixel(board)
    board.window.controller.set_candidate(replace(board.project.target("T1"), name="T9"))
    board.rest()
    hover(board, place)
    board.bot.wait(2 * TOOLTIP_DELAY_MS)
    assert not QToolTip.isVisible()
    press(board, Key.Key_Escape)
    hover(board, place + QPoint(3, 0))
    board.bot.waitUntil(QToolTip.isVisible, timeout=WAIT_MS)


@LONG
def test_the_point_is_read_again_after_a_movement_of_the_view(board: Driver) -> None:
    values = hover(board, board_pixel(board))
    board.bot.keyClick(board.viewport.canvas, Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    readout = board.window.tools.point_readout
    board.bot.waitUntil(lambda: dict(readout.values) not in ({}, values), timeout=WAIT_MS)
    press(board, Key.Key_B)  # before the adjustment, the points are elsewhere
    assert readout.values == []


@LONG
def test_a_clicked_seed_is_marked_while_its_target_is_searched(
    board: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    find_target, progress_seen = picking.find_target, threading.Event()

    def slow_search(*args: object, progress: Progress, **options: object) -> Target:
        progress(0.25)
        assert progress_seen.wait(WAIT_MS / 1000)
        return find_target(*args, progress=progress, **options)

    monkeypatch.setattr(picking, "find_target", slow_search)
    window, view = board.window, board.viewport
    place = board_pixel(board)
    window.document.edit("removal of T1", board.project.without_target("T1"))
    board.rest()
    drawn: list[tuple[str, tuple]] = []
    show_markers = view.show_markers

    def record(markers: Sequence[Marker]) -> None:
        drawn[:] = [(each.label, each.position) for each in markers]
        if any("25" in label for label, _ in drawn):
            progress_seen.set()
        show_markers(markers)

    monkeypatch.setattr(view, "show_markers", record)
    board.bot.mouseClick(view.canvas, Left, Control, place)
    name, searched = next(each for each in drawn if each[0].startswith("T1"))
    assert name != "T1?", "before the search has begun"
    offset = view.to_pixels(np.array([searched]))[0] - (place.x(), place.y())
    assert np.hypot(*offset) < max(PICK_RADII_PX) + 1
    board.rest()
    assert progress_seen.is_set()
    assert "T1?" in dict(drawn)
    press(board, Key.Key_Return)
    board.rest()
    assert "T1" in dict(drawn)


def test_the_mark_of_a_seed_ends_with_a_cancelled_or_failed_search(opened: Driver) -> None:
    view, line = opened.viewport, opened.window.document.survey.lines[0]
    view.signals.seed_clicked.emit(PickedPoint(line, demo_seeds()["T1"][1]))
    assert len(view.markers) == 1
    press(opened, Key.Key_Period, Control)
    assert view.markers == []
    opened.rest()
    assert opened.window.controller.candidate is None
    view.signals.seed_clicked.emit(PickedPoint(line, (0.0, 0.0, 500.0)))
    assert len(view.markers) == 1
    opened.rest()
    assert len(opened.dialogs.errors) == 1
    assert view.markers == []
    seed(opened, "T2")
    assert [marker.label for marker in view.markers] == ["T1?"]
    press(opened, Key.Key_Escape)
    opened.rest()
    assert view.markers == []


@LONG
def test_a_click_beside_the_points_is_answered_at_the_mouse(board: Driver) -> None:
    canvas, window = board.viewport.canvas, board.window
    board.viewport.view("isometric")
    for tool in (None, Key.Key_M):
        QToolTip.hideText()
        board.bot.waitUntil(lambda: not QToolTip.isVisible(), timeout=WAIT_MS)
        if tool is None:
            board.bot.mouseClick(canvas, Left, Control, EMPTY)
        else:
            press(board, tool)
            board.bot.mouseClick(canvas, Left, NoModifier, EMPTY)
        board.bot.waitUntil(QToolTip.isVisible, timeout=WAIT_MS)
        assert QToolTip.text() == NO_POINT_TEXT
    assert window.tools.mouse_tool.tool == "measure_distance"
    assert window.controller.candidate is None


@LONG
def test_the_note_at_the_mouse_stays_after_ctrl_is_released(board: Driver) -> None:
    canvas = board.viewport.canvas
    board.viewport.view("isometric")
    QTest.keyPress(canvas, Key.Key_Control)
    board.bot.mouseClick(canvas, Left, Control, EMPTY)
    board.bot.waitUntil(QToolTip.isVisible, timeout=WAIT_MS)
    QTest.keyRelease(canvas, Key.Key_Control)
    board.bot.wait(700)  # Qt hides a tooltip 0.3 s after a request
    assert QToolTip.isVisible()
    assert QToolTip.text() == NO_POINT_TEXT
    QTest.keyPress(canvas, Key.Key_Control)
    board.bot.waitUntil(lambda: not QToolTip.isVisible(), timeout=WAIT_MS)
    QTest.keyRelease(canvas, Key.Key_Control)


@LONG
def test_a_click_beside_the_points_names_the_surface_to_pick(board: Driver) -> None:
    canvas, notes = board.viewport.canvas, board.window.task_bar
    board.viewport.view("isometric")
    pictures, texts = [], []
    for key in (Key.Key_F6, Key.Key_F7):
        press(board, key)
        pictures.append(board.viewport.widget.overlay.grab().toImage())
        board.bot.mouseClick(canvas, Left, Control, EMPTY)
        texts.append(notes.currentMessage())
    assert pictures[0] != pictures[1]
    assert texts[0] != texts[1]
    assert "validation plane" in texts[1]


@LONG
def test_the_help_on_the_mouse_fades_after_its_first_use(board: Driver) -> None:
    overlay, settings = board.viewport.widget.overlay, board.window.settings
    assert overlay.help_opacity == 1.0
    assert not settings.has_used_mouse
    with_help = board.viewport.widget.overlay.grab().toImage()
    place = board_pixel(board)
    board.bot.mousePress(board.viewport.canvas, Left, NoModifier, place)
    QTest.mouseMove(board.viewport.canvas, place + QPoint(30, 10))
    board.bot.mouseRelease(board.viewport.canvas, Left, NoModifier, place + QPoint(30, 10))
    assert settings.has_used_mouse
    board.bot.waitUntil(lambda: overlay.help_opacity == 0.0, timeout=WAIT_MS)
    assert overlay.grab().toImage() != with_help
    made = Driver(board.bot, type(board.viewport)(), settings.folder)
    try:
        assert made.window.settings.has_used_mouse
        assert made.viewport.widget.overlay.help_opacity == 0.0
    finally:
        made.window.close()
        made.window.deleteLater()


def _click(driver: Driver, name: str) -> None:
    """Ctrl+click on a target without waiting for its search."""
    line = driver.window.document.survey.lines[0]
    driver.viewport.signals.seed_clicked.emit(PickedPoint(line, demo_seeds()[name][1]))


def _marks(driver: Driver) -> list[tuple]:
    return [marker.position for marker in driver.viewport.markers]


def test_seeds_clicked_during_a_search_are_marked_and_searched_in_turn(opened: Driver) -> None:
    seeds = demo_seeds()
    for name in ("T1", "T2"):
        _click(opened, name)
    assert _marks(opened) == [seeds["T1"][1], seeds["T2"][1]], "marked at once"
    assert opened.window.task_bar.currentMessage()
    opened.rest()
    assert opened.window.controller.candidate.name == "T1"
    assert seeds["T2"][1] in _marks(opened), "waits for the answer of the user"
    press(opened, Key.Key_Return)
    opened.bot.waitUntil(lambda: opened.window.controller.candidate is not None, timeout=WAIT_MS)
    opened.rest()
    candidate = opened.window.controller.candidate
    assert candidate.name == "T2"
    assert np.linalg.norm(np.subtract(candidate.seed, seeds["T2"][1])) < 0.1
    press(opened, Key.Key_Return)
    opened.rest()
    assert [target.name for target in opened.project.targets] == ["T1", "T2"]
    assert opened.window.controller.candidate is None


def test_a_cancelled_or_failed_search_and_its_waiting_seeds(opened: Driver) -> None:
    _click(opened, "T1")
    _click(opened, "T2")
    press(opened, Key.Key_Period, Control)
    opened.rest()
    assert _marks(opened) == [], "cancelled with the search"
    line = opened.window.document.survey.lines[0]
    opened.viewport.signals.seed_clicked.emit(PickedPoint(line, (0.0, 0.0, 500.0)))
    _click(opened, "T2")
    opened.rest()
    assert len(opened.dialogs.errors) == 1
    opened.bot.waitUntil(lambda: opened.window.controller.candidate is not None, timeout=WAIT_MS)
    assert opened.window.controller.candidate.name == "T1", "the next free name"


def test_a_seed_clicked_while_lines_are_georeferenced_is_refused_visibly(
    opened: Driver,
) -> None:
    settings = replace(opened.project.settings, boresight_deg=(0.1, 0.0, 0.0))
    opened.window.controller.change_settings(settings)
    _click(opened, "T1")
    assert QToolTip.text()
    assert _marks(opened) == []
    opened.rest()
    assert opened.window.controller.candidate is None
