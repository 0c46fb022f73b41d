"""Tests of the layout on a small screen: no horizontal scrolling, no truncated choices."""

from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QApplication, QComboBox, QPushButton, QScrollArea, QStyle
from PySide6.QtWidgets import QStyleOptionComboBox as ComboOption
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.appearance import theme
from lispac.gui.features.conventions.convention_panel import TITLE as CONVENTION
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.language import LANGUAGES
from lispac.present.angles import Angles
from tests.gui.support import WAIT_MS, Control, Demo, Driver, Key, press, show_panel

NARROW_WINDOW, SMALL_WINDOW = (950, 600), (1366, 740)


@pytest.fixture(params=LANGUAGES)
def small(
    qtbot: QtBot, qapp: QApplication, tmp_path: Path, demo: Demo, request: pytest.FixtureRequest
) -> Iterator[Driver]:
    """The demo survey in a small window, in each language."""
    set_language(request.param)
    theme.apply_theme(qapp)
    made = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        made.window.resize(*SMALL_WINDOW)
        made.window.document.open(demo.picked, demo.survey)
        made.rest()
        yield made
    finally:
        made.leave()
        set_language("en")


def test_the_patch_test_needs_no_horizontal_scrolling(small: Driver) -> None:
    window = small.window.panel_windows["Patch test"]
    panel = small.window.panels["patch_test"]
    press(small, Key.Key_T, Control)
    panel.show_objects(["O1", "O2"], (), "O1")
    angle, sigma, misalignment = Angles(0.57, -0.57, 0.57), Angles(0.1, 0.1, 0.1), Angles(1, 1, 1)
    panel.angles.show_found(
        SimpleNamespace(boresight_deg=angle, sigma_deg=sigma, misalignment_m=misalignment)
    )
    area = panel.findChild(QScrollArea)
    for size in (NARROW_WINDOW, SMALL_WINDOW, NARROW_WINDOW):
        window.resize(*size)
        small.bot.waitUntil(lambda: window.width() == size[0], timeout=WAIT_MS)  # noqa: B023
        small.bot.waitUntil(lambda: area.horizontalScrollBar().maximum() == 0, timeout=WAIT_MS)
        small.rest()
        for each in (panel.picture, panel.curve, *panel.findChildren(QPushButton)):
            left = each.mapTo(area.viewport(), each.rect().topLeft()).x()
            assert 0 <= left < left + each.width() <= area.viewport().width(), each.text()
            assert each.width() >= each.minimumSizeHint().width()


def test_the_axis_choices_of_the_convention_are_not_cut_off(small: Driver) -> None:
    window = small.window
    show_panel(window, CONVENTION)
    small.bot.waitUntil(window.panels["convention"].isVisible, timeout=WAIT_MS)
    small.rest()
    combo = window.panels["convention"].scanner
    for index in range(combo.count()):
        assert combo.fontMetrics().horizontalAdvance(combo.itemText(index)) <= text_width(combo)


def text_width(combo: QComboBox) -> int:
    """Width available for the text of a choice, pixels."""
    option = ComboOption()
    combo.initStyleOption(option)
    part = QStyle.SubControl.SC_ComboBoxEditField
    return (
        combo.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, part, combo).width()
    )
