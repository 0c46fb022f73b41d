"""Tests of `SlicedCalculation` and of charts that are drawn in slices."""

import threading
import time
from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from lispac.gui.widgets.chart import Chart, SlicedCalculation


@pytest.fixture(autouse=True)
def _no_thread_remains() -> Iterator[None]:
    yield
    assert not [each for each in threading.enumerate() if each.name == "slices"]


def test_a_calculation_pauses_and_resumes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lispac.gui.widgets.chart.CALCULATION_SLICE_S", 0.0)
    steps, did = SlicedCalculation(), []

    def work() -> None:
        for k in range(3):
            did.append(k)
            steps.pause()

    assert not steps.is_running
    assert steps.resume()
    steps.begin(work)
    assert did == []
    done_at_pauses = []
    while not steps.resume():
        assert steps.is_running
        done_at_pauses.append(list(did))
    assert done_at_pauses == [[0], [0, 1], [0, 1, 2]]
    assert not steps.is_running


def test_a_short_calculation_does_not_pause() -> None:
    steps = SlicedCalculation()
    steps.begin(steps.pause)
    assert steps.resume()


def test_an_abandoned_calculation_ends_at_its_pause(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lispac.gui.widgets.chart.CALCULATION_SLICE_S", 0.0)
    steps, did = SlicedCalculation(), []

    def work() -> None:
        try:
            while True:
                steps.pause()
        finally:
            did.append("tidied")

    steps.begin(work)
    assert not steps.resume()
    steps.abandon()
    assert did == ["tidied"]
    assert not steps.is_running
    steps.begin(lambda: did.append("never"))
    steps.abandon()
    assert did == ["tidied"]
    steps.begin(lambda: did.append("again"))
    assert steps.resume()
    assert did == ["tidied", "again"]


def test_errors_are_raised_in_the_caller() -> None:
    steps = SlicedCalculation()
    steps.begin(lambda: 1 // 0)
    with pytest.raises(ZeroDivisionError):
        steps.resume()
    assert not steps.is_running


@pytest.fixture
def chart(qapp: QApplication, monkeypatch: pytest.MonkeyPatch) -> Iterator[Chart]:
    monkeypatch.setattr("lispac.gui.widgets.chart.CALCULATION_SLICE_S", 0.0)
    made = chart_with_plots(3)
    yield made
    if isValid(made):
        remove(made)


def chart_with_plots(count: int) -> Chart:
    chart = Chart(400, 300)
    chart.resize(400, 300)
    for k, axes in enumerate(np.atleast_1d(chart.figure.subplots(1, count))):
        axes.plot(np.arange(100) ** k)
        axes.set(xlabel="Distance (m)", ylabel="Points", title=f"Line {k}")
    return chart


def remove(chart: Chart) -> None:
    chart.deleteLater()
    QCoreApplication.sendPostedEvents(chart, QEvent.Type.DeferredDelete)


def pixels(chart: Chart) -> np.ndarray:
    return np.array(chart.buffer_rgba())


def test_a_plot_is_the_same_drawn_in_slices_and_at_once(chart: Chart, qtbot: QtBot) -> None:
    drawn: list[object] = []
    chart.mpl_connect("draw_event", drawn.append)
    chart.show()
    qtbot.waitUntil(lambda: bool(drawn))
    other = chart_with_plots(3)
    other.show()
    other.draw()
    assert (pixels(chart) == pixels(other)).all()
    assert len(np.unique(pixels(chart))) > 10
    remove(other)


def test_a_constantly_changing_plot_is_drawn(chart: Chart, qtbot: QtBot) -> None:
    """The changes come faster than the layout takes, as while zooming or dragging."""
    drawn: list[object] = []
    chart.mpl_connect("draw_event", drawn.append)
    chart.show()
    until, k = time.monotonic() + 20, 1
    while len(drawn) < 3:
        assert time.monotonic() < until
        chart.figure.axes[0].set_xlim(0, k)
        chart.draw_idle()
        k += 1
        qtbot.wait(10)


def test_a_plot_can_be_resized_or_deleted_during_its_layout(chart: Chart, qtbot: QtBot) -> None:
    chart.show()
    qtbot.waitUntil(lambda: chart.is_drawing)
    chart.resize(500, 320)
    assert not chart.is_drawing
    qtbot.waitUntil(lambda: chart.is_drawing)
    remove(chart)
    assert not isValid(chart)


def test_a_cleared_plot_is_blank(chart: Chart, qtbot: QtBot) -> None:
    drawn: list[object] = []
    chart.mpl_connect("draw_event", drawn.append)
    chart.show()
    qtbot.waitUntil(lambda: len(drawn) == 1)
    chart.figure.clear()
    chart.draw_idle()
    qtbot.waitUntil(lambda: len(drawn) == 2)
    assert (pixels(chart) == 255).all()
