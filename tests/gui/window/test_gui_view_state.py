"""Tests that another theme or language changes nothing of what the user has in the window."""

from collections.abc import Iterator, Mapping
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from lispac.gui.app.docks import raise_panel
from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance.theme import apply_theme
from lispac.gui.features.studies.study_dialog import LineQualityDialog
from lispac.gui.window.actions import ALL_ACTIONS
from lispac.gui.window.session import Session
from lispac.messages import note
from lispac.project import Project
from lispac.workflow.calibration.proposals import Proposal
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import WAIT_MS, Control, Demo, Key, Left, ScriptedDialogs, in_front
from tests.support.long_runs import LONG, others_long

SOON_MS = 20_000
Alt = Qt.KeyboardModifier.AltModifier


@pytest.fixture(autouse=True)
def _english() -> Iterator[None]:
    """English after each test."""
    yield
    set_language("en")


def choose_theme(session: Session, bot: QtBot, theme: str) -> None:
    """Choose a theme in the menu, and wait for the new window."""
    former = session.window
    choose(bot, open_menu(bot, former, "View"), "heme", theme)
    bot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    bot.waitUntil(lambda: in_front(session.window), timeout=SOON_MS)


@LONG
def test_the_same_lines_are_shown_in_another_theme(
    session: Session,
    qtbot: QtBot,
    demo: Demo,
    estimated: Project,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Lines after, or before and after in one picture; no line is georeferenced again."""
    session.window.document.open(estimated, demo.survey)
    wait_until_idle(session, qtbot)
    assert session.window.actions_["after"].isChecked()  # a project with a result
    qtbot.keyClick(session.window, Key.Key_B)
    wait_until_idle(session, qtbot)
    before = dict(session.window.viewport.clouds)
    for key in (Key.Key_B, Key.Key_C):
        qtbot.keyClick(session.window, key)
    wait_until_idle(session, qtbot)
    after, shading = session.window.viewport.clouds, session.window.viewport.shading
    assert not same(after, before)
    assert shading is not None
    monkeypatch.setattr(type(demo.survey), "displayed_clouds", None)
    for theme in ("Dark", "Light"):
        choose_theme(session, qtbot, theme)
        window = session.window
        wait_until_idle(session, qtbot)
        assert same(window.viewport.clouds, after)
        assert window.viewport.shading.title == shading.title
        wiped = theme == "Light"
        assert window.actions_["colour_height"].isChecked()
        assert window.actions_["after"].isChecked() == (not wiped)
        assert window.validate.after.isChecked() == (not wiped)
        assert (
            (window.viewport.wipe_clouds is not None)
            == window.actions_["wipe"].isChecked()
            == wiped
        )
        if not wiped:
            qtbot.keyClick(window, Key.Key_W)
    assert same(window.viewport.wipe_clouds, before)
    qtbot.keyClick(window, Key.Key_B)
    wait_until_idle(session, qtbot)
    assert same(window.viewport.clouds, before)
    assert not window.actions_["wipe"].isChecked()
    choose_theme(session, qtbot, "Dark")
    wait_until_idle(session, qtbot)
    assert same(session.window.viewport.clouds, before)
    assert session.window.actions_["before"].isChecked()


def wait_until_idle(session: Session, bot: QtBot) -> None:
    """Wait until no task is active and the lines are drawn."""
    bot.waitUntil(
        lambda: not session.window.runner.active and session.window.scene.is_drawn, timeout=SOON_MS
    )
    bot.wait(100)


def same(one: Mapping[str, np.ndarray], other: Mapping[str, np.ndarray]) -> bool:
    return one.keys() == other.keys() and all(np.array_equal(one[k], other[k]) for k in one)


def choose_language(session: Session, bot: QtBot, language: str) -> None:
    """Choose a language in the menu, and wait for the new window."""
    former = session.window
    menu = "View" if language == "Français" else "Affichage"
    choose(bot, open_menu(bot, former, menu), "Lang", language)
    bot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    bot.waitUntil(lambda: in_front(session.window), timeout=SOON_MS)


@pytest.fixture(params=others_long([False, True]), ids=lambda each: "theme" if each else "")
def with_theme(request: pytest.FixtureRequest) -> bool:
    """Whether the theme changes too; both changes build a new window in the same way."""
    return request.param


def changes(session: Session, bot: QtBot, *, with_theme: bool = False) -> Iterator[None]:
    """Change the theme, if asked for, and the language; wait each time until all is drawn."""
    if with_theme:
        choose_theme(session, bot, "Dark")
        wait_until_idle(session, bot)
        yield
    choose_language(session, bot, "Français")
    wait_until_idle(session, bot)
    yield


@LONG
def test_selection_view_panels_and_undo_steps_are_kept(
    session: Session, qtbot: QtBot, demo: Demo, validated: Project, with_theme: bool
) -> None:
    window = session.window
    window.document.open(validated, demo.survey)
    wait_until_idle(session, qtbot)
    for key in (Key.Key_B, Key.Key_O):
        qtbot.keyClick(window, key)
    table, lines = window.table, window.data.lines
    raise_panel(table)
    place = table.visualRect(table.sightings.index(1, 1)).center() + QPoint(20, 0)
    qtbot.mouseClick(table.viewport(), Left, pos=place)
    qtbot.keyClick(window, Key.Key_X)
    qtbot.keyClick(window, Key.Key_1, Control)
    place = lines.visualItemRect(lines.item(2, 0))
    qtbot.mouseClick(lines.viewport(), Left, pos=QPoint(place.left() + 10, place.center().y()))
    qtbot.keyClick(window, Key.Key_D, Control)
    qtbot.keyClick(window.diagnostics.list, Key.Key_Down)
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=SOON_MS)
    qtbot.keyClick(window, Key.Key_S)
    section = window.tools.sections.panel
    section.thickness.setFocus()
    section.thickness.selectAll()
    qtbot.keyClicks(section.thickness, "0.35")
    qtbot.keyClick(section.thickness, Key.Key_Tab)
    window.controller.rename("V1", "Quay")
    wait_until_idle(session, qtbot)
    hidden, box = set(window.viewport.hidden), window.tools.clipping.box
    assert len(hidden) == 1
    for _ in changes(session, qtbot, with_theme=with_theme):
        window = session.window
        assert window.actions_["before"].isChecked()
        assert same(window.viewport.clouds,
                    {name: cloud.sample for name, cloud in demo.survey.clouds.items()})  # fmt: skip
        assert window.viewport.parallel
        assert window.actions_["orthographic"].isChecked()
        assert window.viewport.hidden == hidden
        assert window.scene.selected == ("T2", demo.project.lines[0].name)
        assert window.viewport.selected == window.scene.selected
        current = window.table.currentIndex()
        assert (current.row(), current.column()) == (1, 1)
        assert window.tools.clipping.box is box
        assert window.viewport.box is box
        assert window.workflow.opened == 0
        assert window.diagnostics.isVisible()
        assert window.diagnostics.list.currentRow() == 1
        section = window.tools.sections.panel
        assert section.isVisible()
        assert not section.visibleRegion().isEmpty(), "in front"
        assert section.thickness.value() == pytest.approx(0.35)
        assert window.tools.sections.section.thickness == pytest.approx(0.35)
        assert window.document.undo_stack.count() == 1
        assert window.document.is_modified
    qtbot.keyClick(window, Key.Key_Z, Control)
    assert "V1" in window.targets.names


def test_objects_and_angles_of_the_patch_test_are_kept(
    session: Session, qtbot: QtBot, demo: Demo, with_theme: bool
) -> None:
    window = session.window
    window.document.open(demo.picked, demo.survey)
    wait_until_idle(session, qtbot)
    window._select("T1", "")
    qtbot.keyClick(window, Key.Key_T, Control)
    panel = window.panels["patch_test"]
    qtbot.mouseClick(panel.target, Left)
    wait_until_idle(session, qtbot)
    assert panel.objects.count() == 1
    place = panel.pairs.visualItemRect(panel.pairs.item(3))
    qtbot.mouseClick(panel.pairs.viewport(), Left,
                     pos=QPoint(place.left() + 10, place.center().y()))  # fmt: skip
    panel.of.setFocus()
    qtbot.keyClick(panel.of, Key.Key_Down)
    slider = panel.angles.sliders[1]
    slider.setFocus()
    for _ in range(3):
        qtbot.keyClick(slider, Key.Key_PageUp)
    wait_until_idle(session, qtbot)
    objects = window.panel_controllers["patch_test"]._placed_objects
    angles, pairs = panel.angles.boresight, panel.ticked_pairs
    assert angles[1] == pytest.approx(np.radians(0.03))
    assert len(pairs) == panel.pairs.count() - 1
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=SOON_MS)
    for _ in changes(session, qtbot, with_theme=with_theme):
        controller = session.window.panel_controllers["patch_test"]
        panel = controller.panel
        assert panel.isVisible()
        assert controller._placed_objects is objects
        assert panel.objects.count() == 1
        assert panel.shown == objects.objects[0].name
        np.testing.assert_array_equal(panel.angles.boresight, angles)
        assert panel.angles.fields[1].value() == pytest.approx(0.03)
        assert panel.ticked_pairs == pairs
        assert panel.of.currentIndex() == 1
        assert panel.picture.isVisible()
        assert "patch" in session.window.viewport.sketches


def test_a_waiting_proposal_is_kept_with_its_ticks_and_its_row(
    session: Session, qtbot: QtBot, demo: Demo, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The proposed targets are those of the demo, because a search takes ten seconds."""
    targets = demo.picked.targets
    reasons = {each.name: note("propose.target_needed", lines=6) for each in targets}
    proposal = Proposal(targets, reasons, lambda _names: np.radians([0.01, 0.02, 0.03]))
    monkeypatch.setattr(
        "lispac.workflow.calibration.proposals.propose_targets", lambda *_, **__: proposal
    )
    window = session.window
    window.document.open(demo.project, demo.survey)
    wait_until_idle(session, qtbot)
    qtbot.keyClick(window, Key.Key_F5)
    qtbot.waitUntil(window.targets.proposal.isVisible, timeout=WAIT_MS)
    wait_until_idle(session, qtbot)
    table = window.targets.proposal.table
    for key in (Key.Key_Space, Key.Key_Down, Key.Key_Down):
        qtbot.keyClick(table, key)
    ticked = window.targets.proposal.ticked_entries
    current, emphasised = window.targets.proposal.current, window.viewport.selected
    labels = sorted(marker.label for marker in window.viewport.markers)
    assert len(ticked) == table.rowCount() - 1
    assert emphasised is not None
    for _ in changes(session, qtbot):
        window = session.window
        panel = window.targets.proposal
        assert panel.isVisible()
        assert panel.ticked_entries == ticked
        assert panel.current == current
        assert current in panel.reason.text()
        assert window.viewport.selected == emphasised
        assert sorted(marker.label for marker in window.viewport.markers) == labels
    qtbot.mouseClick(panel.accept_button, Left)
    assert [target.name for target in window.document.project.targets] == list(ticked)


@LONG
def test_the_differences_between_lines_are_kept(
    session: Session, qtbot: QtBot, demo: Demo, estimated: Project, with_theme: bool
) -> None:
    """The dialogue beside the view, with its order, its selected row and the marked places."""
    window = session.window
    window.document.open(estimated, demo.survey)
    wait_until_idle(session, qtbot)
    window.actions_["line_quality"].trigger()
    qtbot.waitUntil(lambda: window.findChild(LineQualityDialog) is not None, timeout=WAIT_MS)
    wait_until_idle(session, qtbot)
    dialog = window.findChild(LineQualityDialog)
    dialog.table.sortItems(5, Qt.SortOrder.DescendingOrder)
    place = dialog.table.visualItemRect(dialog.table.item(2, 0)).center()
    qtbot.mouseClick(dialog.table.viewport(), Left, pos=place)
    row, marked = dialog.table.selected_row, window.viewport.sketches["line_differences"].points
    size, quality = dialog.size(), dialog.quality
    for _ in changes(session, qtbot, with_theme=with_theme):
        (dialog,) = session.window.findChildren(LineQualityDialog)
        assert dialog.isVisible()
        assert dialog.size() == size
        assert dialog.quality is quality
        assert (dialog.table.selected_row, dialog.table.currentRow()) == (row, 2)
        assert session.window.viewport.sketches["line_differences"].points == marked
    shown = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
    assert set(shown) == {session.window, dialog}


def test_linked_views_and_a_measurement_are_kept(
    session: Session, qtbot: QtBot, demo: Demo, estimated: Project
) -> None:
    window = session.window
    window.document.open(estimated, demo.survey)
    wait_until_idle(session, qtbot)
    qtbot.keyClick(window, Key.Key_2, Qt.KeyboardModifier.AltModifier)
    wait_until_idle(session, qtbot)
    qtbot.keyClick(window, Key.Key_M)
    line = demo.project.lines[0].name
    for index in (100, 4000):
        window.viewport.point_at(line, index)
    measured = window.viewport.sketches["measure"]
    for _ in changes(session, qtbot):
        viewport = session.window.viewport
        assert [each.direction for each in viewport.linked] == ["same", "same"]
        assert session.window.tools.mouse_tool.tool == "measure_distance"
        assert viewport.mouse_mode == "point"
        assert viewport.sketches["measure"].points == measured.points
    qtbot.keyClick(session.window, Key.Key_Escape)
    qtbot.keyClick(session.window, Key.Key_Escape)
    assert session.window.viewport.linked == ()


@pytest.fixture
def drawn(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Session]:
    """A session in English and in the light theme whose viewport draws."""
    if qapp.platformName() == "offscreen":
        pytest.skip("OpenGL needs a screen, if only a virtual one")
    from lispac.gui.viewport.lazy_viewport import LazyViewport
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    settings = AppSettings(tmp_path / "settings.ini")
    settings.language, settings.theme = "en", "light"
    made = Session(qapp, lambda: LazyViewport(VtkViewport), settings, ScriptedDialogs())
    qtbot.waitUntil(made.window.isActiveWindow, timeout=SOON_MS)
    yield made
    made.window.stop_and_hide()
    made.window.deleteLater()
    made.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    apply_theme(qapp)


@LONG
def test_the_camera_and_the_former_views_are_kept(drawn: Session, qtbot: QtBot, demo: Demo) -> None:
    window = drawn.window
    window.document.open(demo.picked, demo.survey)
    wait_until_idle(drawn, qtbot)
    qtbot.keyClick(window, Key.Key_2)
    top = window.viewport.camera
    canvas = window.viewport.canvas
    qtbot.mousePress(canvas, Left, pos=QPoint(300, 200))
    qtbot.mouseMove(canvas, QPoint(340, 230))
    qtbot.mouseRelease(canvas, Left, pos=QPoint(340, 230))
    camera = window.viewport.camera
    choose_theme(drawn, qtbot, "Dark")
    wait_until_idle(drawn, qtbot)
    window = drawn.window
    assert window.viewport.camera is not None
    np.testing.assert_allclose(window.viewport.camera.position, camera.position)
    assert window.viewport.camera.azimuth == camera.azimuth
    assert window.viewport.camera.elevation == camera.elevation
    qtbot.keyClick(window, Key.Key_Left, Alt)
    assert window.viewport.camera.elevation == top.elevation


APPEARANCE_ACTIONS = {"theme_light", "theme_dark", "english", "french"}
VIEW_KEYS = {
    "before": [(Key.Key_B, None)],
    "after": [],
    "split": [(Key.Key_W, None)],
    "two views": [(Key.Key_2, Alt)],
    "four views": [(Key.Key_4, Alt)],
}
"""Keys, with modifiers, that lead from the lines after the adjustment to a choice of views."""


def shown_views(session: Session) -> object:
    """What the viewport draws: titles, parts, points, colours and sightings of its pictures."""
    view = session.window.viewport._real_viewport()
    return (
        [
            (
                pane.picture.part,
                pane.picture.direction,
                {line: (len(points), points.sum()) for line, points in pane.layer.clouds.items()},
                sorted(pane.layer.visible),
                pane.layer.shading is None,
                [each.key for each in pane.sightings.highlights],
            )
            for pane in view._panes
        ],
        view._wipe_layer is None or {line: p.sum() for line, p in view._wipe_layer.visible.items()},
        [each.key for each in view._wipe_sightings.highlights],
        view._sketch_layer.share,
        sorted(marker.label for marker in view._overlay.markers),
    )


def move_dividing_line(session: Session, bot: QtBot) -> None:
    """Drag the dividing line from the middle of the picture to its right part."""
    canvas = session.window.viewport.canvas
    start = canvas.rect().center()
    end = start + QPoint(canvas.width() // 4, 0)
    bot.mouseMove(canvas, start)
    bot.mousePress(canvas, Left, pos=start)
    bot.mouseMove(canvas, end)
    bot.mouseRelease(canvas, Left, pos=end)
    assert session.window.viewport._real_viewport()._sketch_layer.share > 0.7


def checked_actions(session: Session) -> set[str]:
    """Names of the chosen actions."""
    return {name for name in ALL_ACTIONS if session.window.actions_[name].isChecked()}


@pytest.mark.parametrize(
    ("views", "colours"),
    others_long(
        product(VIEW_KEYS, [None, Key.Key_C]),
        lambda case: case == ("four views", Key.Key_C),  # other tests have a split view
    ),
)
def test_the_drawn_views_are_kept(
    drawn: Session,
    qtbot: QtBot,
    demo: Demo,
    estimated: Project,
    views: str,
    colours: Key | None,
) -> None:
    """Single, split and linked views, with a clip box, in another theme and language."""
    window = drawn.window
    window.document.open(estimated, demo.survey)
    wait_until_idle(drawn, qtbot)
    if colours is not None:
        qtbot.keyClick(window, colours)
        window._select("T1", "")
        qtbot.keyClick(window, Key.Key_X)
    for key, modifier in VIEW_KEYS[views]:
        qtbot.keyClick(window, key, modifier or Qt.KeyboardModifier.NoModifier)
    wait_until_idle(drawn, qtbot)
    if views == "split":
        move_dividing_line(drawn, qtbot)
    if colours is not None:
        qtbot.keyClick(window, Key.Key_F11)
        wait_until_idle(drawn, qtbot)
    expected, count = shown_views(drawn), window.tools.linked_views.count
    checked = checked_actions(drawn)
    assert (count, "wipe" in checked) == (
        {"two views": 2, "four views": 4}.get(views, 1), views == "split"
    )  # fmt: skip
    for _ in changes(drawn, qtbot, with_theme=True):
        window = drawn.window
        assert shown_views(drawn) == expected
        assert window.tools.linked_views.count == count
        assert window.dock_layout.is_maximised == (colours is not None)
        assert checked_actions(drawn) ^ checked <= {
            "theme_light",
            "theme_dark",
            "english",
            "french",
        }
        assert drawn._dialogs.errors == []
    assert window.document.project is estimated
