"""Tests of a change of language: the window is rebuilt around the same project."""

import gc
import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.widgets import VerticalScrollArea
from lispac.gui.widgets.optional_number import OptionalNumber
from lispac.gui.window.main_window import MainWindow
from lispac.gui.window.session import Session
from lispac.language import current_language, gettext
from lispac.progress import Progress
from lispac.project import Project
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import Demo, show_panel
from tests.support.long_runs import LONG

SOON_MS = 20_000


@LONG
def test_the_tour_continues_in_another_language(
    session: Session, qtbot: QtBot, demo_copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("lispac.gui.project.controller.demo_folder", lambda: demo_copy)
    english = session.window
    qtbot.mouseClick(english.central_widget.start.links["tour"], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: english.tour.is_running and not english.runner.active, timeout=SOON_MS)
    choose(qtbot, open_menu(qtbot, english, "View"), "Langue", "ran")
    qtbot.waitUntil(lambda: session.window is not english, timeout=SOON_MS)
    french = session.window
    assert french.tour.is_running
    assert french.central_widget.card.isVisible()
    assert french.central_widget.card.head.text() == "Visite, étape 1 sur 7"


def test_the_language_changes_and_nothing_is_lost(
    session: Session, qtbot: QtBot, demo: Demo
) -> None:
    english = session.window
    english.document.open(demo.picked, demo.survey)
    english.controller.rename("T1", "North wall")
    english.controller.rename("T2", "South wall")
    english.document.undo_stack.undo()
    edited = english.document.project
    assert english.isWindowModified()

    choose(qtbot, open_menu(qtbot, english, "View"), "Langue", "ran")
    qtbot.waitUntil(lambda: session.window is not english, timeout=SOON_MS)
    french = session.window
    qtbot.waitUntil(french.isActiveWindow, timeout=SOON_MS)
    assert current_language() == "fr"
    assert french.docks["Results"].windowTitle() == gettext("Results") == "Résultats"
    assert french.document.project is edited
    assert french.isWindowModified()
    assert french.document.survey is demo.survey
    stack = french.document.undo_stack
    assert (stack.canUndo(), stack.canRedo()) == (True, True)
    for name in ("undo", "redo"):
        assert french.actions_[name].isEnabled()
        assert french.actions_[name].text().endswith("T1" if name == "undo" else "T2")
    stack.redo()
    assert {target.name for target in french.document.project.targets} >= {"South wall"}
    stack.undo()
    stack.undo()
    assert {target.name for target in french.document.project.targets} >= {"T1", "T2"}
    assert not french.isWindowModified()
    assert [w for w in QApplication.topLevelWidgets() if w.isVisible()] == [french]


@LONG
def test_a_rebuilt_window_shows_the_lines_at_once(
    session: Session, qtbot: QtBot, demo: Demo
) -> None:
    english = session.window
    english.document.open(demo.picked, demo.survey)
    qtbot.waitUntil(lambda: english.scene.is_drawn, timeout=SOON_MS)
    session.rebuild_window()
    viewport = session.window.viewport
    assert isinstance(viewport, RecordingViewport)
    assert set(viewport.clouds) == {line.name for line in demo.picked.lines}
    assert {marker.label for marker in viewport.markers} >= {"T1", "T2"}
    assert session.window.scene.is_drawn


@LONG
def test_the_former_window_is_deleted_with_its_viewport(session: Session, qtbot: QtBot) -> None:
    for code in ("fr", "en"):
        former = session.window
        former.settings.language = code
        former.rebuild_window()
        qtbot.waitUntil(lambda former=former: session.window is not former, timeout=SOON_MS)
    del former
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QCoreApplication.processEvents()
    gc.collect()
    alive = [each for each in gc.get_objects() if type(each) in (MainWindow, RecordingViewport)]
    assert [type(each).__name__ for each in alive].count("MainWindow") == 1
    assert [type(each).__name__ for each in alive].count("RecordingViewport") == 1


@LONG
def test_a_saved_project_stays_saved(session: Session, qtbot: QtBot, demo: Demo) -> None:
    english = session.window
    english.document.open(demo.picked, demo.survey)
    english.controller.rename("T1", "North wall")
    english.document.mark_saved(english.document.file_digest)
    english.controller.rename("T2", "South wall")
    english.settings.language = "fr"
    english.rebuild_window()
    qtbot.waitUntil(lambda: session.window is not english, timeout=SOON_MS)
    document = session.window.document
    assert document.is_modified
    document.undo_stack.undo()
    assert not document.is_modified
    document.undo_stack.undo()
    assert document.is_modified


def rebuild_window(session: Session, qtbot: QtBot, code: str) -> MainWindow:
    """Rebuild the window in another language and return it."""
    former = session.window
    former.settings.language = code
    former.rebuild_window()
    qtbot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    return session.window


@LONG
def test_the_open_step_stays_open(session: Session, qtbot: QtBot, demo: Demo) -> None:
    session.window.document.open(demo.picked, demo.survey)
    assert session.window.workflow.opened == 2
    session.window.workflow.headers[1].click()
    assert rebuild_window(session, qtbot, "fr").workflow.opened == 1


@LONG
def test_typed_texts_that_are_not_accepted_are_kept(
    session: Session, qtbot: QtBot, demo: Demo
) -> None:
    english = session.window
    english.document.open(demo.picked, demo.survey)
    lever_arm = demo.picked.settings.lever_arm
    english.data.lever_arm.fields[2].lineEdit().setText("2.5.")
    english.targets.shape_choice.setCurrentIndex(1)
    for fold in (english.adjust.also, english.adjust.advanced):
        fold.open()
    english.adjust.unit.setCurrentIndex(1)
    english.adjust.distance.setValue(0.25)
    QTest.mouseClick(english.adjust.parameters.switches["latency"], Qt.MouseButton.LeftButton)
    optional = {each.objectName(): each for each in english.adjust.findChildren(OptionalNumber)}
    number, wrong = "surface", "sigma_latency"
    optional[number].setText("0.125")
    optional[wrong].setText("0,1 2")
    applied = english.document.project
    french = rebuild_window(session, qtbot, "fr")
    assert french.document.project is applied
    assert french.data.lever_arm.value() == lever_arm
    assert french.data.lever_arm.fields[2].cleanText() == "2.5."
    assert french.data.lever_arm.fields[2].property("wrong")
    assert french.targets.shape_choice.currentIndex() == 1
    assert french.adjust.also.head.isChecked()
    assert french.adjust.subsample == 0.25
    assert french.adjust.parameters.switches["latency"].isChecked()
    fields = {each.objectName(): each for each in french.adjust.findChildren(OptionalNumber)}
    assert fields[number].text() == "0,125"
    assert fields[wrong].text() == "0,1 2"
    assert not french.adjust.is_valid


@LONG
def test_a_pending_candidate_is_kept(session: Session, qtbot: QtBot, demo: Demo) -> None:
    session.window.document.open(demo.project, demo.survey)
    found = demo.picked.target("T1")
    session.window.controller.set_candidate(found)
    french = rebuild_window(session, qtbot, "fr")
    assert french.controller.candidate is found
    assert french.targets.candidate.isVisible()
    QTest.mouseClick(french.targets.candidate.accept, Qt.MouseButton.LeftButton)
    assert [target.name for target in french.document.project.targets] == ["T1"]


class ShowRecorder(QObject):
    """Event filter that records the names of windows in the order in which they are shown."""

    def __init__(self) -> None:
        super().__init__()
        self.names: list[str] = []

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show and isinstance(watched, QWidget) and watched.isWindow():
            self.names.append(watched.objectName())
        return False


@LONG
def test_floating_panels_are_shown_after_the_window(
    session: Session, qtbot: QtBot, qapp: QApplication
) -> None:
    """A window manager puts a new window on top, so the main window must be shown first."""
    show_panel(session.window, "Log")
    session.window.docks["Log"].setFloating(True)
    shown = ShowRecorder()
    qapp.installEventFilter(shown)
    try:
        french = rebuild_window(session, qtbot, "fr")
    finally:
        qapp.removeEventFilter(shown)
    assert french.docks["Log"].isFloating()
    assert french.docks["Log"].isVisible()
    assert shown.names[-2:] == ["main_window", "dock_log"]
    french.stop_and_hide()
    assert [each for each in QApplication.topLevelWidgets() if each.isVisible()] == []


@LONG
def test_a_report_is_in_the_language_of_the_window_until_another_is_chosen(
    session: Session, qtbot: QtBot
) -> None:
    def chosen_text() -> str:
        return session.window.report.language.currentText()

    def written() -> str:
        return session.window.report.options().language

    assert (chosen_text(), written()) == ("Same as window", "en")
    rebuild_window(session, qtbot, "fr")
    assert (chosen_text(), written()) == ("Comme la fenêtre", "fr")
    QTest.keyClick(session.window.report.page, Qt.Key.Key_Down)
    assert session.window.settings.report_choice().page == "letter"
    assert written() == "fr"
    for _ in "window", "English":
        QTest.keyClick(session.window.report.language, Qt.Key.Key_Down)
    assert written() == "fr"  # chosen explicitly, though it is the language of the window
    rebuild_window(session, qtbot, "en")
    assert (chosen_text(), written()) == ("Français", "fr")
    QTest.keyClick(session.window.report.language, Qt.Key.Key_Home)
    assert written() == "en"
    rebuild_window(session, qtbot, "fr")
    assert (chosen_text(), written()) == ("Comme la fenêtre", "fr")


@LONG
def test_a_change_of_language_waits_for_a_plan_search(session: Session, qtbot: QtBot) -> None:
    """A cancelled search checks its flag only now and then, which would block the window."""
    former = session.window
    former.site_design.open()
    goes_on, ended = threading.Event(), []

    def work(_progress: Progress) -> None:
        goes_on.wait(20)

    former.site_design.runner.run("Finding the best plan", work, ended.append)
    former.settings.language = "fr"
    former.rebuild_window()
    qtbot.wait(200)
    assert session.window is former
    assert "takes effect when it has ended" in former.log.toPlainText()
    goes_on.set()
    qtbot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    assert ended == [None]


@LONG
def test_the_log_is_kept(session: Session, qtbot: QtBot) -> None:
    former = session.window
    former.log.note("Something happened")
    log_text = former.log.toPlainText()
    former.rebuild_window()
    qtbot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    assert session.window.log.toPlainText().startswith(log_text)


def test_no_text_is_cut_off_in_a_small_french_window(
    session: Session, qtbot: QtBot, demo: Demo, estimated: Project
) -> None:
    english = session.window
    english.settings.language = "fr"
    english.rebuild_window()
    qtbot.waitUntil(lambda: session.window is not english, timeout=SOON_MS)
    window = session.window
    window.setGeometry(0, 0, 1366, 768)
    window.document.open(estimated, demo.survey)
    qtbot.waitUntil(lambda: not window.runner.active, timeout=SOON_MS)
    for step in range(5):
        window.workflow.open(step)
        areas = [
            area
            for panel in (window.results, window.workflow)
            for area in panel.findChildren(VerticalScrollArea)
            if area.isVisible()
        ]
        # The docks get their width from an event that follows the opening of the step
        qtbot.waitUntil(
            lambda areas=areas: all(a.width() >= a.minimumSizeHint().width() for a in areas),
            timeout=SOON_MS,
        )
    assert window.width() == 1366


@LONG
def test_the_qualities_of_the_sightings_are_kept(
    session: Session, qtbot: QtBot, demo: Demo
) -> None:
    english = session.window
    english.document.open(demo.picked, demo.survey)
    sightings = sum(len(target.sightings) for target in demo.picked.targets)
    qtbot.waitUntil(lambda: len(english.document.qualities) == sightings, timeout=SOON_MS)
    shown: list[int] = []
    french = rebuild_window(session, qtbot, "fr")
    french.target_actions.quality_computation.qualities_changed.connect(
        lambda qualities: shown.append(len(qualities))
    )
    french.document.changed.emit()
    assert shown == [sightings]
    qtbot.waitUntil(lambda: not french.runner.active, timeout=SOON_MS)
    assert set(shown) == {sightings}
