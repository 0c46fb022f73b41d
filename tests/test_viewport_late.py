"""A viewport that is made when it is needed is, once made, as if it had been there always."""

import inspect

import numpy as np
import pytest
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QMainWindow, QStackedWidget, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.viewport.base import Viewport, ViewportSignals
from lispac.gui.viewport.lazy_viewport import CALLS_BY_NAME, CALLS_WITH_VALUE, LazyViewport
from lispac.gui.viewport.recording_viewport import RecordingViewport
from tests.gui.support import WAIT_MS, in_front

CLOUDS = {"A": np.zeros((3, 3)), "B": np.ones((2, 3))}
COLOURS = {"A": (255, 0, 0), "B": (0, 0, 255)}


class Made:
    """Makes recording viewports and keeps them."""

    def __init__(self) -> None:
        self.all: list[RecordingViewport] = []

    def __call__(self) -> RecordingViewport:
        self.all.append(RecordingViewport())
        return self.all[-1]


@pytest.fixture
def made() -> Made:
    return Made()


@pytest.fixture
def late(made: Made, qtbot: QtBot) -> LazyViewport:
    view = LazyViewport(made)
    qtbot.addWidget(view.widget)
    return view


def test_nothing_is_made_before_there_is_something_to_see(late: LazyViewport, made: Made) -> None:
    late.set_point_size(3)
    late.show_clouds({}, {})
    late.show_markers([])
    late.clear()
    late.close()
    assert made.all == []


def test_what_was_asked_before_holds(late: LazyViewport, made: Made) -> None:
    late.set_point_size(3)
    late.set_line_visible("A", False)
    late.set_line_visible("B", False)
    late.set_line_visible("A", True)
    late.set_point_size(5)
    late.show_clouds(CLOUDS, COLOURS)
    late.set_parallel(True)
    (view,) = made.all
    assert view.calls == [
        ("set_line_visible", ("B", False)),
        ("set_line_visible", ("A", True)),
        ("set_point_size", (5,)),
        ("show_clouds", view.calls[3][1]),
        ("set_parallel", (True,)),
    ]
    assert set(view.clouds) == set(CLOUDS)


def test_it_is_made_when_it_is_seen(late: LazyViewport, made: Made, qtbot: QtBot) -> None:
    late.set_station((1.0, 2.0, 3.0))
    late.widget.resize(300, 200)
    late.widget.show()
    qtbot.waitExposed(late.widget)
    (view,) = made.all
    assert view.widget.isVisible()
    assert view.widget.size() == late.widget.size()
    assert view.calls == [("set_station", ((1.0, 2.0, 3.0),))]


def test_it_is_made_for_an_answer(late: LazyViewport, made: Made) -> None:
    late.set_line_visible("A", False)
    assert late.is_line_hidden("A")
    assert len(made.all) == 1
    late.close()
    assert made.all[0].calls[-1] == ("close", ())


def test_the_window_stays_the_same_and_in_front(qtbot: QtBot, shown: object) -> None:
    """A window that gets its first OpenGL when it is shown already is made anew by Qt."""
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    window = QMainWindow()
    qtbot.addWidget(window)
    views = [LazyViewport(VtkViewport, window)]
    window.setCentralWidget(QStackedWidget())
    for page in (QWidget(), views[0].widget):
        window.centralWidget().addWidget(page)
    window.resize(400, 300)
    window.show()
    qtbot.waitUntil(lambda: in_front(window), timeout=WAIT_MS)
    before, handle = window.winId(), window.windowHandle()
    window.centralWidget().setCurrentIndex(1)
    views[0].show_clouds(CLOUDS, COLOURS)
    qtbot.wait(200)
    assert window.isActiveWindow()
    assert (window.winId(), window.windowHandle()) == (before, handle)
    views.pop().close()


def test_every_signal_is_passed_on(late: LazyViewport, made: Made) -> None:
    heard = []
    names = [name for name, each in vars(ViewportSignals).items() if isinstance(each, Signal)]
    assert len(names) == 7
    for name in names:
        getattr(late.signals, name).connect(lambda *_values, name=name: heard.append(name))
    late.show_clouds(CLOUDS, COLOURS)
    signals: QObject = made.all[0].signals
    for name in names:
        values = {"missed": (), "handle_moved": ("box", 1, 0.5), "handle_released": ("box",)}
        getattr(signals, name).emit(*values.get(name, (None,)))
    assert heard == names


def test_every_question_has_an_answer() -> None:
    asked = {
        name
        for name, each in vars(Viewport).items()
        if inspect.isfunction(each) and inspect.signature(each).return_annotation is not None
    }
    theirs = asked - set(vars(LazyViewport))
    assert {name for name in theirs if not name.startswith("_")} <= CALLS_WITH_VALUE
    assert set(vars(Viewport)) > CALLS_BY_NAME
