"""Tests of what a rebuilt window keeps: states of fields, patch test, windows above it, focus."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QApplication, QScrollArea, QScrollBar, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.project.status import DATA, REPORT
from lispac.gui.widgets.optional_number import OptionalNumber
from lispac.gui.window.main_window import MainWindow
from lispac.gui.window.session import Session
from lispac.project import Project
from tests.gui.support import Demo, Key, finish_layouts, in_front, show_panel
from tests.support.long_runs import LONG, others_long

SOON_MS = 20_000
CHANGES = {"theme": "dark", "language": "fr"}


def rebuilt(session: Session, qtbot: QtBot, setting: str, value: str) -> MainWindow:
    """Change the theme or the language, and return the new window."""
    former = session.window
    setattr(former.settings, setting, value)
    former.rebuild_window()
    qtbot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    qtbot.waitUntil(lambda: in_front(session.window), timeout=SOON_MS)
    finish_layouts()
    return session.window


@LONG
def test_an_assumed_value_stays_assumed(
    session: Session, qtbot: QtBot, demo: Demo, estimated: Project
) -> None:
    settings = replace(
        estimated.settings, lidar_sigma=None, lidar_sigma_xyz=None, lidar_beam_sigma=None,
        position_sigma=None, attitude_sigma_deg=None,
    )  # fmt: skip
    assert "LiDAR" in settings.assumed_sigmas
    session.window.document.open(replace(estimated, settings=settings), demo.survey)
    for setting, value in CHANGES.items():
        data = rebuilt(session, qtbot, setting, value).data
        assert data.lidar_sigma.is_assumed
        assert data.lidar_sigma.property("assumed")
    window = session.window
    window.workflow.open(DATA)
    field = window.data.lever_arm_sigma.fields[0]
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "0.02")
    qtbot.keyClick(field, Key.Key_Return)
    project = window.document.project
    assert project.settings.lever_arm_sigma == (0.02, 0.0, 0.0)
    assert "LiDAR" in project.settings.assumed_sigmas
    assert project.result is estimated.result


@LONG
def test_a_number_being_typed_is_not_applied(session: Session, qtbot: QtBot, demo: Demo) -> None:
    """It neither gets lost nor becomes a value of the panel that the project does not have."""
    window = session.window
    window.document.open(demo.picked, demo.survey)
    window.workflow.open(DATA)
    before = demo.picked.settings.lever_arm
    field = window.data.lever_arm.fields[2]
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "2.5")
    assert field.is_typing
    session.rebuild_window()
    window = session.window
    qtbot.waitUntil(lambda: in_front(window), timeout=SOON_MS)
    field = window.data.lever_arm.fields[2]
    assert field.is_typing
    assert field.hasFocus()
    assert window.document.project.settings.lever_arm == before
    qtbot.keyClicks(field, "5")
    qtbot.keyClick(field, Key.Key_Return)
    assert window.document.project.settings.lever_arm == (*before[:2], 2.55)
    qtbot.keyClick(window, Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert window.document.project.settings.lever_arm == before


@LONG
def test_a_typed_text_keeps_its_unit(session: Session, qtbot: QtBot, demo: Demo) -> None:
    window = session.window
    window.document.open(demo.picked, demo.survey)
    window.workflow.open(DATA)
    field = window.data.lever_arm.fields[0]
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "1.5")
    window.settings.units = ("degrees", "feet")
    session.rebuild_window()
    field = session.window.data.lever_arm.fields[0]
    assert field.suffix() == " ft"
    assert field.commit()
    assert session.window.document.project.settings.lever_arm[0] == pytest.approx(1.5, abs=1e-9)


@LONG
def test_a_typed_criterion_and_its_source_are_kept(
    session: Session, qtbot: QtBot, demo: Demo
) -> None:
    session.window.document.open(demo.picked, demo.survey)
    acceptance = session.window.validate.acceptance
    rms, source = acceptance.fields["rms"], acceptance.source
    qtbot.keyClicks(rms, "12")
    rms._pending.begin()
    qtbot.keyClicks(source, "contract")
    assert rms.is_typing
    window = rebuilt(session, qtbot, "language", "fr")
    acceptance = window.validate.acceptance
    rms, source = acceptance.fields["rms"], acceptance.source
    assert isinstance(rms, OptionalNumber)
    assert (rms.text(), source.text()) == ("12", "contract")
    assert window.document.project.acceptance.rms is None
    assert rms.commit()
    assert source.commit()
    assert window.document.project.acceptance.rms == pytest.approx(0.012)
    assert window.document.project.acceptance.source == "contract"


@LONG
def test_typed_angles_of_another_program_are_kept(
    session: Session, qtbot: QtBot, demo: Demo, estimated: Project
) -> None:
    matrix = "1 0 0\n0 1 0\n0 0 1"
    session.window.document.open(estimated, demo.survey)
    panel = session.window.panels["convention"]
    assert panel.inputs.covariance is not None
    panel.current.known.setChecked(True)
    panel.current.as_matrix.setChecked(True)
    panel.current.matrix.setPlainText(matrix)
    panel = rebuilt(session, qtbot, "theme", "dark").panels["convention"]
    assert panel.current.matrix.toPlainText() == matrix
    assert panel.inputs.covariance is not None
    panel.inputs.boresight.fields[0].setValue(1.0)
    panel.inputs.boresight.fields[0].setValue(float(np.degrees(estimated.result.boresight[0])))
    text = panel.inputs.source.text()
    panel = rebuilt(session, qtbot, "theme", "light").panels["convention"]
    assert panel.inputs.source.text() == text
    assert panel.inputs.covariance is None


@LONG
def test_the_curve_of_the_patch_test_is_kept(session: Session, qtbot: QtBot, demo: Demo) -> None:
    window = session.window
    window.document.open(demo.project, demo.survey)
    qtbot.waitUntil(lambda: not window.runner.active, timeout=SOON_MS)
    show_panel(window, "Patch test")
    panel = window.panels["patch_test"]
    qtbot.mouseClick(panel.propose, Qt.MouseButton.LeftButton)

    def has_curve() -> bool:
        controller = session.window.panel_controllers["patch_test"]
        curve = session.window.panels["patch_test"].curve
        is_busy = session.window.runner.active or controller.is_curve_pending
        return not is_busy and len(curve._values) > 0

    qtbot.waitUntil(has_curve, timeout=3 * SOON_MS)
    field = panel.angles.fields[0]
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "0.12")
    qtbot.keyClick(field, Key.Key_Return)
    qtbot.waitUntil(has_curve, timeout=3 * SOON_MS)
    before, minimum, title = panel.curve._values, panel.curve.minimum, panel.curve._title
    later = rebuilt(session, qtbot, "theme", "dark").panels["patch_test"]
    qtbot.wait(500)
    qtbot.waitUntil(has_curve, timeout=3 * SOON_MS)
    np.testing.assert_array_equal(later.curve._values, before)
    assert later.curve.minimum == minimum
    assert later.curve._title == title
    assert later.angles.boresight[0] == pytest.approx(np.radians(0.12), abs=1e-12)


class ShowRecorder(QObject):
    """Event filter that records which windows are shown, in order."""

    def __init__(self) -> None:
        super().__init__()
        self.shown: list[QObject] = []

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show and isinstance(watched, QWidget) and watched.isWindow():
            self.shown.append(watched)
        return False


@LONG
@pytest.mark.parametrize("title", others_long(["Patch test", "Diagnostics"]))
def test_an_open_window_stays_above(
    session: Session, qtbot: QtBot, qapp: QApplication, title: str
) -> None:
    """A window manager keeps it above its parent only if it is shown after it."""
    show_panel(session.window, title)
    for setting, value in CHANGES.items():
        recorder = ShowRecorder()
        qapp.installEventFilter(recorder)
        former = session.window
        setattr(former.settings, setting, value)
        former.rebuild_window()
        qtbot.waitUntil(lambda former=former: session.window is not former, timeout=SOON_MS)
        qapp.removeEventFilter(recorder)
        window = session.window
        own = window.panel_windows[title]
        qtbot.waitUntil(own.isVisible, timeout=SOON_MS)
        assert own.windowHandle().transientParent() is window.windowHandle()
        later = [each for each in recorder.shown if each in (window, own)]
        assert later[-2:] == [window, own]


@LONG
def test_the_header_of_the_open_step_has_the_focus(
    session: Session, qtbot: QtBot, demo: Demo
) -> None:
    session.window.document.open(demo.picked, demo.survey)
    session.window.workflow.go_to(REPORT)
    for setting, value in CHANGES.items():
        window = rebuilt(session, qtbot, setting, value)
        qtbot.wait(200)
        assert window.workflow.opened == REPORT
        focused = QApplication.focusWidget()
        assert focused is window.workflow.headers[REPORT], focused.objectName()


@LONG
def test_the_open_step_stays_scrolled(session: Session, qtbot: QtBot, demo: Demo) -> None:
    window = session.window
    window.document.open(demo.picked, demo.survey)
    window.resize(1366, 768)
    window.workflow.go_to(DATA)
    finish_layouts()

    def bar() -> QScrollBar:
        area = session.window.workflow.findChild(QScrollArea, "area_data")
        assert area.isVisible()
        return area.verticalScrollBar()

    bar().setValue(bar().maximum() // 2)
    before = bar().value()
    assert before > 0
    for setting, value in CHANGES.items():
        rebuilt(session, qtbot, setting, value)
        assert bar().value() == before


@pytest.mark.parametrize("is_active", others_long([True, False]))
def test_the_focus_follows_a_step_that_opens_by_itself(
    session: Session, qtbot: QtBot, demo: Demo, is_active: bool
) -> None:
    window = session.window
    window.document.open(demo.picked, demo.survey)
    window.workflow.go_to(DATA)
    if not is_active:
        show_panel(window, "Patch test")
        qtbot.waitUntil(window.panel_windows["Patch test"].isActiveWindow, timeout=SOON_MS)
    assert window.focusWidget() is window.workflow.headers[DATA]
    window.workflow.open(REPORT)
    assert window.focusWidget() is window.workflow.headers[REPORT]
