"""Tests of the plots of the validation planes: read off values, zoom and copy."""

import csv
from dataclasses import replace
from io import StringIO
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backend_bases import MouseEvent
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QGuiApplication, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QWidget
from pytestqt.qtbot import QtBot

from lispac.acceptance import largest_offset
from lispac.gui.app.language import set_language
from lispac.gui.appearance import theme, units
from lispac.gui.features.validate.histograms_panel import (
    PAIRS_HINT,
    PAIRS_VIEW,
    PROFILE_PLOT,
    ZOOM_HINT,
    HistogramsPanel,
)
from lispac.gui.features.validate.pairs_table import OFFSET_AFTER, RMS_AFTER
from lispac.gui.features.validate.planes_table import OFFSET, PAIRS, RMS
from lispac.gui.project.status import VALIDATE
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.widgets import TIP_LENGTH
from lispac.language import LANGUAGES
from lispac.project import Project
from tests.gui.support import (
    WAIT_MS,
    Control,
    Demo,
    Driver,
    Key,
    click,
    finish_layouts,
    open_step,
    press,
    show_panel,
    type_into,
)
from tests.support.long_runs import LONG, others_long

Left = Qt.MouseButton.LeftButton


@pytest.fixture
def panel(driver: Driver, demo: Demo, validated: Project) -> HistogramsPanel:
    """The histograms panel in front, with V1 drawn."""
    window = driver.window
    window.document.open(validated, demo.survey)
    show_panel(window, "Histograms")
    driver.rest()
    shown = window.histograms
    shown.select("V1")
    driver.bot.waitUntil(shown.canvas.isVisible, timeout=WAIT_MS)
    return shown


def place(panel: HistogramsPanel, axes: int, x: float, y: float) -> QPoint:
    """Position of a data point of a plot on its canvas, logical pixels."""
    at = panel.canvas.figure.axes[axes].transData.transform((x, y))
    ratio = panel.canvas.devicePixelRatioF()
    return QPoint(round(at[0] / ratio), round(panel.canvas.height() - at[1] / ratio))


def wheel(panel: HistogramsPanel, at: QPoint, notches: int) -> None:
    where = QPointF(at)
    event = QWheelEvent(
        where, QPointF(panel.canvas.mapToGlobal(at)), QPoint(), QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase,
        False,
    )  # fmt: skip
    QApplication.sendEvent(panel.canvas, event)


@LONG
def test_another_number_of_points_says_that_the_comparison_is_of_the_former(
    driver: Driver, panel: HistogramsPanel
) -> None:
    step = driver.window.validate
    open_step(driver, VALIDATE)
    show_panel(driver.window, "Histograms")
    used = driver.project.validation[0].model.neighbours
    notes = (step.model_difference, panel.model_difference)
    assert [each.isVisible() for each in notes] == [False, False]
    click(driver, step.comparison.head)
    type_into(driver, step.neighbours, "60")
    driver.bot.keyClick(step.neighbours, Key.Key_Return)
    driver.rest()
    assert [each.isVisible() for each in notes] == [True, True]
    assert all(str(used) in each.text() for each in notes)
    type_into(driver, step.neighbours, str(used))
    driver.bot.keyClick(step.neighbours, Key.Key_Return)
    driver.rest()
    assert [each.isVisible() for each in notes] == [False, False]
    type_into(driver, step.neighbours, "60")
    press(driver, Key.Key_F10)
    driver.rest()
    assert driver.project.validation[0].model.neighbours == 60
    assert [each.isVisible() for each in notes] == [False, False]
    press(driver, Key.Key_Z, Control)
    driver.rest()
    assert step.neighbours.value() == driver.project.validation[0].model.neighbours == used
    assert [each.isVisible() for each in notes] == [False, False]


def test_a_hidden_plot_is_drawn_once_when_it_becomes_visible(
    driver: Driver, panel: HistogramsPanel
) -> None:
    drawn = []
    show_panel(driver.window, "Log")
    driver.bot.waitUntil(lambda: panel.canvas.visibleRegion().isEmpty())
    finish_layouts()
    driver.rest()
    panel.canvas.mpl_connect("draw_event", lambda _event: drawn.append(1))
    for choice in (1, PROFILE_PLOT, 0, PROFILE_PLOT):
        panel.plot.setCurrentIndex(choice)
    driver.bot.wait(100)
    assert not drawn
    show_panel(driver.window, "Histograms")
    driver.bot.waitUntil(lambda: bool(drawn))
    driver.bot.wait(100)
    assert len(drawn) == 1
    panel.plot.setCurrentIndex(0)
    whole = panel.canvas.picture().toImage()  # a copied picture is drawn at once
    assert len(drawn) == 2
    driver.bot.wait(100)
    assert len(drawn) == 2
    assert panel.canvas.grab().toImage() == whole


def test_the_values_of_a_bar_are_shown_under_the_mouse(
    driver: Driver, panel: HistogramsPanel
) -> None:
    panel.canvas.draw()
    axes = panel.canvas.figure.axes[0]
    drawn = axes.patches[2].get_data()  # after
    highest = int(np.argmax(drawn.values))
    middle = drawn.edges[highest : highest + 2].mean()
    driver.bot.mouseMove(panel.canvas, QPoint(2, 2))
    driver.bot.mouseMove(panel.canvas, place(panel, 0, middle, drawn.values[highest] / 2))
    driver.bot.waitUntil(lambda: "after" in panel.reading.text())
    assert f"{drawn.values[highest]:,.0f} points after" in panel.reading.text()


@pytest.mark.parametrize(
    "lengths", others_long(["metres", "feet"], lambda lengths: lengths == "feet")
)
def test_distances_by_height_and_range_are_shown_under_the_mouse(
    panel: HistogramsPanel, lengths: str
) -> None:
    units.set_units("degrees", lengths)
    try:
        panel.plot.setCurrentIndex(PROFILE_PLOT)
        panel.canvas.draw()
        for axes, title in zip(panel.canvas.figure.axes, ("Height", "Range"), strict=True):
            middle = (np.mean(axes.get_xlim()), np.mean(axes.get_ylim()))
            x, y = axes.transData.transform(middle)
            event = MouseEvent("motion_notify_event", panel.canvas, x, y)
            panel.canvas.callbacks.process(event.name, event)
            assert panel.reading.text().startswith(title)
            assert f"\u00a0{units.shown_unit('m').sign}: " in panel.reading.text()
    finally:
        units.set_units("degrees", "metres")


def test_the_wheel_zooms_to_finer_bars_and_a_double_click_resets(
    driver: Driver, panel: HistogramsPanel
) -> None:
    panel.canvas.draw()
    axes = panel.canvas.figure.axes[0]
    whole, coarse = axes.get_xlim(), axes.patches[0].get_data()
    bottom = place(panel, 0, 0.02 * whole[1], 0.5 * axes.get_ylim()[1])
    wheel(panel, bottom, 8)
    fine = axes.patches[0].get_data()
    assert axes.get_xlim()[1] - axes.get_xlim()[0] < 0.3 * (whole[1] - whole[0])
    assert axes.get_ylim()[0] == 0.0
    assert np.diff(fine.edges)[0] < np.diff(coarse.edges)[0]
    assert fine.values.sum() == coarse.values.sum()
    driver.bot.mouseDClick(panel.canvas, Left, pos=bottom)
    assert axes.get_xlim() == whole


def test_no_distance_below_zero_is_shown(driver: Driver, panel: HistogramsPanel) -> None:
    panel.canvas.draw()
    axes = panel.canvas.figure.axes[0]
    bottom = place(panel, 0, 0.3 * axes.get_xlim()[1], 0.5 * axes.get_ylim()[1])
    furthest = 1000 * panel.table.current_comparison.bin_edges[-1]
    wheel(panel, bottom, 4)
    right = bottom + QPoint(300, 0)
    driver.bot.mousePress(panel.canvas, Left, pos=bottom)
    driver.bot.mouseMove(panel.canvas, right)
    driver.bot.mouseRelease(panel.canvas, Left, pos=right)
    assert axes.get_xlim()[0] == 0.0
    wheel(panel, bottom, -60)
    assert axes.get_xlim() == pytest.approx((0.0, furthest))
    panel.plot.setCurrentIndex(PROFILE_PLOT)
    panel.canvas.draw()
    profile = panel.canvas.figure.axes[0]
    whole = profile.get_xlim()
    wheel(panel, place(panel, 0, sum(whole) / 2, sum(profile.get_ylim()) / 2), -10)
    assert profile.get_xlim() == pytest.approx(whole)


def test_the_hint_on_zooming_is_only_shown_with_a_plot(panel: HistogramsPanel) -> None:
    assert panel.reading.text().startswith("Wheel")
    panel.plot.setCurrentIndex(PAIRS_VIEW)
    assert panel.reading.text() == PAIRS_HINT
    panel.plot.setCurrentIndex(0)
    assert panel.reading.text().startswith("Wheel")


def colours_of(widget: QWidget) -> set[int]:
    image = widget.grab().toImage()
    return {
        image.pixel(x, y)
        for x in range(0, image.width(), 3)
        for y in range(0, image.height(), 3)
    }  # fmt: skip


@LONG
def test_no_picture_of_another_plane_or_plot_is_shown(
    driver: Driver, panel: HistogramsPanel
) -> None:
    panel.canvas.draw()
    assert len(colours_of(panel.canvas)) > 2
    panel.plot.setCurrentIndex(PROFILE_PLOT)
    assert len(colours_of(panel.canvas)) == 1
    panel.canvas.draw()
    (plane,) = driver.project.validation
    two = replace(plane), replace(plane, name="V9")
    driver.window.document.edit("again", driver.project.with_validation(two, {}))
    assert len(colours_of(panel.canvas)) == 1
    driver.rest()
    panel.canvas.draw()
    panel.select("V9")
    assert len(colours_of(panel.canvas)) == 1


def test_choice_and_buttons_stay_at_their_place(panel: HistogramsPanel) -> None:
    places = set()
    for index in range(panel.plot.count()):
        panel.plot.setCurrentIndex(index)
        finish_layouts()
        assert not panel.plot.is_cut
        controls = (panel.plot, panel.copy_picture, panel.copy_numbers, panel.enlarge)
        places.add(tuple(each.mapTo(panel, QPoint()).toTuple() for each in controls))
    assert len(places) == 1


def test_no_tip_is_one_long_line(panel: HistogramsPanel) -> None:
    heads = [panel.table.horizontalHeaderItem(k) for k in range(panel.table.columnCount())]
    heads += [panel.pairs.horizontalHeaderItem(k) for k in range(panel.pairs.columnCount())]
    for each in (*heads, panel.table.item(0, 0), panel.plot):
        assert 0 < max(map(len, each.toolTip().split("\n"))) <= TIP_LENGTH


def test_the_shares_of_all_bars_sum_to_one(panel: HistogramsPanel) -> None:
    panel.plot.setCurrentIndex(1)
    for patch in panel.canvas.figure.axes[0].patches:
        bars = patch.get_data()
        assert (bars.values * np.diff(bars.edges)).sum() == pytest.approx(100.0)


def test_numbers_and_picture_are_copied(
    driver: Driver, panel: HistogramsPanel, validated: Project
) -> None:
    driver.bot.mouseClick(panel.copy_numbers, Left)
    rows = list(csv.reader(StringIO(QGuiApplication.clipboard().text()), delimiter="\t"))
    assert rows[0] == [
        "From (mm)",
        "To (mm)",
        "Points before calibration",
        "Points after calibration",
    ]
    assert [row[1] for row in rows[1:]] == [*(row[0] for row in rows[2:]), "and beyond"]
    points = validated.validation[0].before.n
    assert [sum(int(row[k]) for row in rows[1:]) for k in (2, 3)] == [points, points]
    driver.bot.mouseClick(panel.copy_picture, Left)
    picture = QGuiApplication.clipboard().pixmap()
    assert picture.size() == panel.canvas.size() * panel.canvas.devicePixelRatioF()
    panel.plot.setCurrentIndex(PROFILE_PLOT)
    assert panel.reading.text() == ZOOM_HINT
    driver.bot.mouseClick(panel.copy_numbers, Left)
    text = QGuiApplication.clipboard().text()
    height = validated.validation[0].by_height
    assert height is not None
    first = next(k for k in range(len(height.n)) if np.isfinite(height.median_after[k]))
    assert f"{1000 * height.median_after[first]:.3f}" in text


def test_pairs_of_lines_are_listed_beside_the_plane(
    panel: HistogramsPanel, validated: Project
) -> None:
    pairs = validated.validation[0].pairs
    assert panel.pairs.rowCount() == len(pairs)
    names = panel.pairs.item(0, 0).text()
    assert pairs[0].line_a in names
    assert "⇄" in names
    assert panel.pairs.item(0, 2).text() == f"{1000 * pairs[0].after.distances.rms:.1f}"
    signed = pairs[0].after.signed
    assert signed is not None
    shown = panel.pairs.item(0, 4).text().replace("−", "-")
    assert shown == f"{1000 * signed.median:+.1f}"


def test_pairs_over_a_limit_and_pairs_that_became_worse_are_marked(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    (plane,) = validated.validation
    first, second, *others = plane.pairs
    distances = first.after.distances
    worse = replace(
        first, before=replace(first.before, distances=replace(distances, rms=0.5 * distances.rms))
    )
    assert second.after.signed is not None
    far = replace(
        second,
        before=replace(second.before, distances=replace(distances, rms=1.0)),
        after=replace(second.after, signed=replace(second.after.signed, median=-0.4)),
    )
    plane = replace(plane, pairs=(worse, far, *others))
    window = driver.window
    window.document.open(replace(validated, validation=(plane,)), demo.survey)
    show_panel(window, "Histograms")
    driver.rest()
    panel, pairs = window.histograms, window.histograms.pairs
    driver.bot.keyClick(panel.plot, Qt.Key.Key_End)
    assert panel.plot.currentIndex() == PAIRS_VIEW
    for row, marked in ((0, [RMS_AFTER]), (1, [])):
        bold = [k for k in range(pairs.columnCount()) if pairs.item(row, k).font().bold()]
        assert bold == marked
        assert pairs.item(row, 0).icon().isNull() == (not marked)
    field = window.validate.acceptance.fields["offset"]
    window.workflow.open(VALIDATE)
    driver.rest()
    driver.bot.mouseClick(field, Left)
    field.selectAll()
    QTest.keyClicks(field, "300")
    QTest.keyClick(field, Qt.Key.Key_Return)
    driver.rest()
    offset, tip = pairs.item(1, OFFSET_AFTER), pairs.item(1, OFFSET_AFTER).toolTip()
    assert offset.font().bold()
    assert offset.foreground().color() == theme.colour("error")
    assert "400" in tip
    assert "300" in tip
    assert not pairs.item(1, 0).icon().isNull()
    assert not pairs.item(0, OFFSET_AFTER).font().bold()
    window.resize(1600, 1000)
    for is_large in (True, False):
        driver.bot.mouseClick(panel.enlarge, Left)
        driver.rest()
        assert pairs.horizontalScrollBar().maximum() == 0 or not is_large, "no column is cut"
        beside = pairs.mapTo(panel, QPoint()).x() > panel.table.mapTo(panel, QPoint()).x()
        assert beside != is_large
    driver.bot.keyClick(panel.plot, Qt.Key.Key_Home)
    driver.rest()
    assert panel.canvas.mapTo(panel, QPoint()).x() >= panel.table.width()


@LONG
def test_the_worst_plane_is_selected_after_the_validation(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    window, (plane,) = driver.window, validated.validation
    rms = {"V1": 0.02, "V2": 0.01, "V3": 0.04, "V4": 0.03}
    planes = tuple(
        replace(plane, name=name, after=replace(plane.after, rms=value))
        for name, value in rms.items()
    )
    window.document.open(replace(validated, validation=planes), demo.survey)
    show_panel(window, "Histograms")
    driver.rest()
    panel = window.histograms
    assert panel.current == "V3"
    assert window.scene.selected == ("V3", "")
    item = panel.table.item(panel.table.currentRow(), 0)
    assert panel.table.viewport().rect().contains(panel.table.visualItemRect(item).center())
    spot = panel.table.visualItemRect(item).center()
    driver.bot.mouseClick(panel.table.viewport(), Left, pos=spot)
    assert window.scene.selected == ("V3", "")
    window._select("T1", "")
    driver.bot.mouseClick(panel.table.viewport(), Left, pos=spot)
    assert window.scene.selected == ("V3", "")
    # A plane that fails later is selected too, unless another failing plane is selected.
    window._select("V2", "")
    field = window.validate.acceptance.fields["rms"]
    for limit_mm, selected in ((35, "V3"), (15, "V1")):
        field.selectAll()
        QTest.keyClicks(field, str(limit_mm))
        QTest.keyClick(field, Qt.Key.Key_Return)
        driver.rest()
        assert panel.current == selected
        assert window.scene.selected == (selected, "")
        window._select("V1", "")


@pytest.mark.parametrize("size", [(1366, 768), pytest.param((1600, 1000), marks=LONG)])
def test_all_planes_and_their_failed_values_are_visible_beside_a_large_histogram(
    driver: Driver, demo: Demo, validated: Project, size: tuple[int, int]
) -> None:
    window, (plane,) = driver.window, validated.validation
    window.resize(*size)
    driver.rest()
    planes = tuple(replace(plane, name=f"V{k}") for k in range(1, 6))
    window.document.open(replace(validated, validation=planes), demo.survey)
    show_panel(window, "Histograms")
    window.workflow.open(VALIDATE)
    driver.rest()
    panel, offset = window.histograms, 1000 * largest_offset(plane)[0]
    for name, limit in (("rms", 1e6), ("offset", 0.5 * offset)):
        field = window.validate.acceptance.fields[name]
        field.selectAll()
        QTest.keyClicks(field, f"{limit:.3f}")
        QTest.keyClick(field, Qt.Key.Key_Return)
    driver.rest()
    table = panel.table
    assert table.verticalScrollBar().maximum() == table.horizontalScrollBar().maximum() == 0
    for row in range(5):
        assert table.visualRect(table.model().index(row, 0)).bottom() <= table.viewport().height()
        assert table.item(row, OFFSET).text() == f"{offset:.1f}"
        assert table.item(row, OFFSET).font().bold()
        assert not table.item(row, RMS).font().bold()
        assert f"{offset:.1f}" in table.item(row, OFFSET).toolTip()
    colours = panel.findChild(QLabel, "comparison_colours")
    assert colours.width() >= colours.sizeHint().width()
    assert panel.canvas.width() >= 0.3 * size[0]
    assert panel.canvas.height() >= (130 if size[1] >= 1000 else 100)


def test_a_double_click_on_a_plane_moves_the_view_to_it(
    driver: Driver, panel: HistogramsPanel
) -> None:
    def moves() -> int:
        return sum(name == "fit" for name, _ in driver.viewport.calls)

    before, table = moves(), panel.table
    middle = table.visualRect(table.model().index(0, 0)).center()
    driver.bot.mouseClick(table.viewport(), Left, pos=middle)
    assert moves() == before
    driver.bot.mouseDClick(table.viewport(), Left, pos=middle)
    assert moves() == before + 1
    assert driver.window.scene.selected == (panel.current, "")


@LONG
def test_the_plot_is_enlarged_and_restored(driver: Driver, panel: HistogramsPanel) -> None:
    window = driver.window
    window.resize(1600, 1000)
    driver.rest()
    low = panel.height()
    driver.bot.mouseClick(panel.enlarge, Left)
    driver.bot.waitUntil(lambda: panel.height() >= 0.4 * window.height())
    show_panel(window, "Section")
    section = window.tools.sections.panel
    assert section.enlarge.isChecked()
    driver.bot.mouseClick(section.enlarge, Left)
    driver.bot.waitUntil(lambda: section.height() < 0.3 * window.height())
    show_panel(window, "Histograms")
    driver.rest()
    assert panel.height() <= max(low, 0.3 * window.height())
    assert not panel.enlarge.isChecked()


@LONG
def test_the_button_does_not_cover_the_legend_after_enlarging(
    driver: Driver, panel: HistogramsPanel
) -> None:
    window = driver.window
    window.resize(1600, 1000)
    driver.rest()
    colours = panel.findChild(QLabel, "comparison_colours")
    for _ in range(2):
        driver.bot.mouseClick(panel.enlarge, Left)
        driver.rest()
    assert colours.isVisible()
    assert not colours.geometry().intersects(panel.enlarge.geometry())
    assert colours.width() >= colours.sizeHint().width()


@LONG
def test_the_section_follows_the_plane_of_the_histograms(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    window, (plane,) = driver.window, validated.validation
    planes = (plane, replace(plane, name="T1"))
    window.document.open(replace(validated, validation=planes), demo.survey)
    show_panel(window, "Section")
    driver.rest()
    section = window.tools.panels["Section"]
    assert "V1" in section.through.text()
    show_panel(window, "Histograms")
    driver.rest()
    table = window.histograms.table
    spot = table.visualRect(table.model().index(1, 0)).center()
    driver.bot.mouseClick(table.viewport(), Left, pos=spot)
    show_panel(window, "Section")
    driver.rest()
    assert "T1" in section.through.text()


def test_a_selected_plane_is_marked_in_the_view_and_zoomed_to_on_request(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    """The view stays until the user asks for the plane, by the button or a double-click."""
    window, view = driver.window, driver.viewport
    window.document.open(replace(validated), demo.survey)
    driver.rest()
    show_panel(window, "Histograms")
    driver.rest()
    view.calls.clear()
    table = window.histograms.table
    spot = table.visualRect(table.model().index(0, 0)).center()
    driver.bot.mouseClick(table.viewport(), Left, pos=spot)
    assert view.selected == ("V1", "")
    assert [each.label for each in view.markers if each.is_selected] == ["V1"]
    assert not [call for call in view.calls if call[0] == "fit"]
    plane = validated.target("V1")
    total = sum(len(sighting.indices) for sighting in plane.sightings)
    driver.bot.mouseClick(window.histograms.zoom, Left)
    driver.bot.mouseDClick(table.viewport(), Left, pos=spot)
    fits = [call[1] for call in view.calls if call[0] == "fit"]
    assert [len(points) for (points,) in fits] == [total, total]


def test_the_table_states_how_many_pairs_its_numbers_cover(
    panel: HistogramsPanel, validated: Project
) -> None:
    for row, plane in enumerate(validated.validation):
        assert panel.table.item(row, PAIRS).text() == str(len(plane.pairs))
    first = validated.validation[0]
    reciprocal = sum(pair.reciprocal for pair in first.pairs)
    assert 0 < reciprocal < len(first.pairs)
    panel.table.show_planes([replace(first, pooled_from="reciprocal pairs")])
    shown = panel.table.item(0, PAIRS)
    assert shown.text() == f"reciprocal: {reciprocal} of {len(first.pairs)}"


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("width", others_long([1366, 1600]))
def test_pairs_are_compared_before_and_after_without_scrolling(
    qtbot: QtBot, qapp: QApplication, tmp_path: Path, demo: Demo, validated: Project,
    language: str, width: int,
) -> None:  # fmt: skip
    set_language(language)
    theme.apply_theme(qapp)
    driver = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        driver.window.resize(width, 740)
        driver.window.document.open(validated, demo.survey)
        panel = driver.window.histograms
        show_panel(driver.window, "Histograms")
        driver.rest()
        assert panel.table.horizontalScrollBar().maximum() == 0
        panel.plot.setFocus()
        QTest.keyClick(panel.plot, Qt.Key.Key_End)
        driver.rest()
        assert panel.pairs.isVisible()
        assert not panel.copy_picture.isEnabled()
        last = 4  # offset after
        right = panel.pairs.columnViewportPosition(last) + panel.pairs.columnWidth(last)
        assert right <= panel.pairs.viewport().width()
    finally:
        driver.leave()
        set_language("en")


def test_sorting_the_pairs_does_not_widen_their_columns(
    driver: Driver, panel: HistogramsPanel
) -> None:
    panel.plot.setCurrentIndex(PAIRS_VIEW)
    driver.rest()
    header = panel.pairs.horizontalHeader()
    widths = [header.sectionSize(column) for column in range(header.count())]
    place = QPoint(header.sectionViewportPosition(1) + 5, header.height() // 2)
    driver.bot.mouseClick(header.viewport(), Left, pos=place)
    driver.rest()
    assert header.sortIndicatorSection() == 1
    assert [header.sectionSize(column) for column in range(header.count())] == widths


def test_the_distances_before_do_not_flatten_those_after(
    driver: Driver, panel: HistogramsPanel, validated: Project
) -> None:
    panel.plot.setCurrentIndex(PROFILE_PLOT)
    driver.rest()
    axes = panel.canvas.figure.axes[0]
    assert axes.get_yscale() == "log"
    low, high = axes.get_ylim()
    for profile in (validated.validation[0].by_height, validated.validation[0].by_range):
        for values in (profile.median_after, profile.p95_before):
            shown = 1000 * values[np.isfinite(values)]
            assert low <= shown.min() <= shown.max() <= high
