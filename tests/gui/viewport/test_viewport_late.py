"""Tests of a viewport that is created on demand and then has the state requested before."""

import inspect

import numpy as np
import pytest
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QMainWindow, QStackedWidget, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.viewport.base import Viewport, ViewportSignals
from lispac.gui.viewport.lazy_viewport import METHODS_BY_OBJECT, METHODS_WITH_RESULT, LazyViewport
from lispac.gui.viewport.recording_viewport import RecordingViewport
from tests.gui.support import WAIT_MS, in_front

CLOUDS = {"A": np.zeros((3, 3)), "B": np.ones((2, 3))}
COLOURS = {"A": (255, 0, 0), "B": (0, 0, 255)}


class ViewportFactory:
    """Factory of recording viewports that keeps them."""

    def __init__(self) -> None:
        self.all: list[RecordingViewport] = []

    def __call__(self) -> RecordingViewport:
        self.all.append(RecordingViewport())
        return self.all[-1]


@pytest.fixture
def made() -> ViewportFactory:
    return ViewportFactory()


@pytest.fixture
def late(made: ViewportFactory, qtbot: QtBot) -> LazyViewport:
    view = LazyViewport(made)
    qtbot.addWidget(view.widget)
    return view


def test_no_viewport_is_created_for_an_empty_view(
    late: LazyViewport, made: ViewportFactory
) -> None:
    late.set_point_size(3)
    late.show_clouds({}, {})
    late.show_markers([])
    late.clear()
    late.close()
    assert made.all == []


def test_earlier_calls_are_applied_on_creation(late: LazyViewport, made: ViewportFactory) -> None:
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


def test_viewport_is_created_when_shown(
    late: LazyViewport, made: ViewportFactory, qtbot: QtBot
) -> None:
    late.set_station((1.0, 2.0, 3.0))
    late.widget.resize(300, 200)
    late.widget.show()
    qtbot.waitExposed(late.widget)
    (view,) = made.all
    assert view.widget.isVisible()
    assert view.widget.size() == late.widget.size()
    assert view.calls == [("set_station", ((1.0, 2.0, 3.0),))]


def test_viewport_is_created_for_a_return_value(late: LazyViewport, made: ViewportFactory) -> None:
    late.set_line_visible("A", False)
    assert late.is_line_hidden("A")
    assert len(made.all) == 1
    late.close()
    assert made.all[0].calls[-1] == ("close", ())


def test_the_window_is_not_recreated_and_stays_in_front(qtbot: QtBot, shown: object) -> None:
    """Qt recreates a visible window that gets its first OpenGL widget."""
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


def test_every_signal_is_forwarded(late: LazyViewport, made: ViewportFactory) -> None:
    emitted = []
    names = [name for name, each in vars(ViewportSignals).items() if isinstance(each, Signal)]
    assert len(names) == 11
    for name in names:
        getattr(late.signals, name).connect(lambda *_values, name=name: emitted.append(name))
    late.show_clouds(CLOUDS, COLOURS)
    signals: QObject = made.all[0].signals
    for name in names:
        values = {
            "menu_requested": (None, None),
            "copy_requested": (),
            "help_used": (),
            "handle_moved": ("box", 1, 0.5),
            "handle_released": ("box",),
            "history_changed": (True, False),
        }
        getattr(signals, name).emit(*values.get(name, (None,)))
    assert emitted == names


def test_every_query_returns_a_value() -> None:
    queries = {
        name
        for name, each in vars(Viewport).items()
        if inspect.isfunction(each) and inspect.signature(each).return_annotation is not None
    }
    theirs = queries - set(vars(LazyViewport))
    assert {name for name in theirs if not name.startswith("_")} <= METHODS_WITH_RESULT
    assert set(vars(Viewport)) > METHODS_BY_OBJECT


def test_a_method_taken_before_the_creation_acts_on_the_viewport(
    late: LazyViewport, made: ViewportFactory
) -> None:
    """Actions and signals are connected to methods before the viewport exists."""
    fit, set_line_visible = late.fit, late.set_line_visible
    late.show_clouds(CLOUDS, COLOURS)
    (view,) = made.all
    view.calls.clear()
    fit()
    set_line_visible("A", False)
    assert view.calls == [("fit", (None,)), ("set_line_visible", ("A", False))]
