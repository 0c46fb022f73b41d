"""Tests of the tools: measurements, sections, clip box, comparison and preview of a click."""

import re
from dataclasses import replace
from itertools import pairwise, product

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from lispac.gui.features.inspect.section_figure import draw_section
from lispac.gui.features.inspect.section_panel import EMPTY_TEXT
from lispac.gui.features.inspect.section_titles import AHEAD_LABEL, HEIGHT_LABEL
from lispac.gui.features.inspect.sections import DRAG_UPDATE_MS, section_box_sketch
from lispac.gui.project.status import VALIDATE
from lispac.gui.viewport.base import PickedPoint
from lispac.gui.window.main_window import MainWindow
from lispac.language import LANGUAGES, in_language
from lispac.present.checking.validation import WINDOW_PAIRS_TABLE
from lispac.project import Project
from lispac.warning_causes import Cause
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import (
    WAIT_MS,
    Demo,
    Driver,
    Key,
    Left,
    click,
    open_step,
    press,
    seed,
    show_panel,
    type_into,
    wait_until_idle,
)
from tests.support.long_runs import LONG, others_long

SHIFT = Qt.KeyboardModifier.ShiftModifier


def points(driver: Driver, *numbers: int) -> list[np.ndarray]:
    """Click points of the first line, and return their coordinates."""
    line = driver.window.document.survey.lines[0]
    for number in numbers:
        driver.viewport.point_at(line, number)
    return [driver.viewport.clouds[line][number] for number in numbers]


def test_two_clicks_measure_a_distance_and_escape_ends_the_tool(opened: Driver) -> None:
    window, view = opened.window, opened.viewport
    press(opened, Key.Key_M)
    assert window.actions_["measure_distance"].isChecked()
    assert view.mouse_mode == "point"
    assert "first point" in view.hint
    first, second = points(opened, 100, 4000)
    sketch = view.sketches["measure"]
    slope = np.linalg.norm(second - first)
    level = np.hypot(*(second - first)[:2])
    assert f"Slope distance {slope:.3f}\u00a0m" in sketch.label
    assert f"Horizontal {level:.3f}\u00a0m" in sketch.label
    assert f"{abs(second[2] - first[2]):.3f}\u00a0m" in sketch.label
    assert sketch.edges == ((0, 1),)
    assert f"Slope distance {slope:.3f} m" in window.log.toPlainText()
    points(opened, 7)  # the next click starts a new measurement
    assert view.sketches["measure"].label == ""
    assert len(view.sketches["measure"].points) == 1
    press(opened, Key.Key_Escape)
    assert view.mouse_mode == "navigate"
    assert "measure" not in view.sketches
    assert not window.actions_["measure_distance"].isChecked()
    with pytest.raises(RuntimeError):
        points(opened, 5)


def test_three_clicks_measure_an_angle_and_the_shortcut_ends_the_tool(opened: Driver) -> None:
    view = opened.viewport
    press(opened, Key.Key_M)
    press(opened, Key.Key_M, SHIFT)
    assert not opened.window.actions_["measure_distance"].isChecked()
    first, corner, second = points(opened, 100, 2000, 4000)
    sides = first - corner, second - corner
    cosine = sides[0] @ sides[1] / np.linalg.norm(sides[0]) / np.linalg.norm(sides[1])
    assert f"Angle {np.degrees(np.arccos(cosine)):.2f}°" in view.sketches["measure"].label
    press(opened, Key.Key_M, SHIFT)
    assert view.mouse_mode == "navigate"
    press(opened, Key.Key_M, SHIFT)
    points(opened, 100, 100, 4000)
    assert "to measure an angle" in opened.window.log.toPlainText()
    assert "measure" not in view.sketches
    press(opened, Key.Key_Escape)


def test_escape_ends_the_tool_before_it_rejects_the_candidate(opened: Driver) -> None:
    seed(opened, "T1")
    assert opened.window.controller.candidate is not None
    press(opened, Key.Key_M)
    press(opened, Key.Key_Escape)
    assert opened.viewport.mouse_mode == "navigate"
    assert opened.window.controller.candidate is not None
    press(opened, Key.Key_Escape)
    assert opened.window.controller.candidate is None


def test_the_section_follows_the_selected_target(adjusted: Driver) -> None:
    window, panel = adjusted.window, adjusted.window.tools.sections.panel
    press(adjusted, Key.Key_S)
    adjusted.rest()
    window.resizeDocks([window.docks["Section"]], [420], Qt.Orientation.Vertical)
    assert panel.text_label.text() == EMPTY_TEXT
    assert panel.canvas is None
    window._select("T1", "")
    adjusted.rest()
    assert panel.through.text() == "Across T1"
    exaggerate(adjusted, "1")
    axes = panel.canvas.figure.axes
    assert [each.get_title(loc="left").split(":")[0] for each in axes] == ["Before", "After"]
    for each in axes:
        assert each.get_aspect() == 1.0
        lines = {drawn.get_gid() for drawn in each.lines}
        assert lines == set(window.document.survey.lines)
    cuts = window.tools.sections._cuts
    assert adjusted.viewport.sketches["section"] == section_box_sketch(
        cuts[1].section, has_ends=False
    )  # after
    panel.orientation.setCurrentIndex(1)
    adjusted.rest()
    assert panel.canvas.figure.axes[0].get_xlabel() == "From the middle to the right (m)"
    panel.size.setValue(5.0)
    adjusted.rest()
    assert panel.canvas.figure.axes[0].get_xlim() == (-2.5, 2.5)
    window._select("V1", "")
    adjusted.rest()
    assert panel.through.text() == "Across V1"
    window.computations.show("estimated")
    adjusted.rest()
    cuts = window.tools.sections._cuts
    assert adjusted.viewport.sketches["section"] == section_box_sketch(
        cuts[1].section, has_ends=False
    )
    show_panel(window, "Log")
    adjusted.bot.waitUntil(lambda: "section" not in adjusted.viewport.sketches, timeout=WAIT_MS)
    window.controller.remove("V1")
    press(adjusted, Key.Key_S)
    wait_until_idle(adjusted)
    assert panel.text_label.text() == EMPTY_TEXT
    assert not panel.canvas.isVisible()


@LONG
def test_the_section_gives_the_offsets_of_the_table_of_pairs(
    demo: Demo, validated: Project, driver: Driver
) -> None:
    """The titles give the largest offset before and after, and its lines."""
    window = driver.window
    window.document.open(validated, demo.survey)
    wait_until_idle(driver)
    panel = window.tools.sections.panel
    press(driver, Key.Key_S)
    driver.rest()
    window._select("V1", "")
    driver.rest()
    (plane,) = [each for each in validated.validation if each.name == "V1"]
    histograms = window.histograms
    columns = [column.value for column in WINDOW_PAIRS_TABLE.columns]
    pairs = {
        state: max(plane.pairs, key=lambda each: abs(getattr(each, state).signed.median))
        for state in ("before", "after")
    }
    texts = [
        [histograms.pairs.item(row, column).text() for column in range(len(columns))]
        for row in range(histograms.pairs.rowCount())
    ]
    for height in (420, 150):
        window.resizeDocks([window.docks["Section"]], [height], Qt.Orientation.Vertical)
        driver.rest()
        for axes, (state, pair) in zip(panel.canvas.figure.axes, pairs.items(), strict=True):
            offset = f"{1000 * abs(getattr(pair, state).signed.median):.1f}"
            title = axes.get_title(loc="left")
            assert offset in title
            assert f"{pair.line_a} / {pair.line_b}" in " ".join(title.split())
            column = columns.index(f"{state}.signed.median_m")
            lines = {pair.line_a, pair.line_b}
            (row,) = [each for each in texts if lines <= set(each[0].split())]
            assert row[column].strip("+−-") == offset
    window._select("T1", "")
    driver.rest()
    titles = [each.get_title(loc="left") for each in panel.canvas.figure.axes]
    assert not any("mm" in title for title in titles), "a target has not been compared"


def exaggerate(driver: Driver, factor: str) -> None:
    """Choose a factor in the panel of the section with the keys."""
    choice = driver.window.tools.sections.panel.exaggeration_choice
    choice.setFocus()
    driver.bot.keyClick(choice, Key.Key_Home)
    for _ in range(choice.findText(factor)):
        driver.bot.keyClick(choice, Key.Key_Down)
    assert choice.currentText() == factor


@LONG
@pytest.mark.parametrize("name", others_long(["T1", "T2"], lambda name: name == "T2"))
def test_distances_between_lines_are_drawn_larger(adjusted: Driver, name: str) -> None:
    """T1 is vertical and T2 leans; both are then drawn upright, by their distances."""
    window, panel = adjusted.window, adjusted.window.tools.sections.panel
    press(adjusted, Key.Key_S)
    adjusted.rest()
    window.resizeDocks([window.docks["Section"]], [420], Qt.Orientation.Vertical)
    window._select(name, "")
    adjusted.rest()
    before, after = panel.canvas.figure.axes
    cuts = window.tools.sections._cuts
    for axes, cut in zip((before, after), cuts, strict=True):
        factor = 1 / axes.get_aspect()
        width = np.ptp(axes.get_xlim())
        assert factor > 1
        assert axes.xaxis_inverted() == (cut.normal[0] < 0), "the vessel stays on its side"
        assert axes.get_ylim() == pytest.approx(np.array([-0.5, 0.5]) * panel.size.value())
        title = f"Across the surface, + towards the vessel, enlarged {factor:.0f} times (m)"
        assert axes.get_xlabel() == title
        assert cut.spread < width
        for drawn in axes.lines:
            points = cut.points[drawn.get_gid()] @ cut.normal / np.linalg.norm(cut.normal)
            assert drawn.get_xdata() == pytest.approx(points)
    assert cuts[1].spread * panel.size.value() / np.ptp(after.get_xlim()) > 0.1
    exaggerate(adjusted, "50")
    for axes, cut in zip(panel.canvas.figure.axes, window.tools.sections._cuts, strict=True):
        assert axes.get_aspect() == 1 / 50
        low, high = sorted(axes.get_xlim())
        middles = [np.median(drawn.get_xdata()) for drawn in axes.lines]
        outside = sum(not low <= middle <= high for middle in middles)
        assert outside < len(middles), "at least one line is in the picture"
        texts = [each.get_text() for each in axes.texts if each.get_gid() == "outside"]
        assert bool(texts) == bool(outside), cut.which
        if outside:
            assert texts[0].startswith(f"{outside} of {len(middles)}")
    exaggerate(adjusted, "1")
    label = panel.canvas.figure.axes[0].get_xlabel()
    assert label == "From the middle, away from the vessel (m)"
    far = replace(cuts[0], spread=10.0)
    assert far.automatic_exaggeration() == 1
    colours = {line.name: (0, 0, 0) for line in adjusted.project.lines}
    figure = Figure()
    draw_section([far, cuts[1]], colours, ("Distance", "Height"), {}, figure)
    before, after = figure.axes
    assert before.get_xlabel().endswith("towards the vessel (m)")
    assert "enlarged" in after.get_xlabel()
    assert before.get_ylabel() == after.get_ylabel()
    near, nearer = replace(cuts[1], spread=0.09), replace(cuts[1], spread=0.03)
    assert near.automatic_exaggeration() < nearer.automatic_exaggeration()
    draw_section([near, nearer], colours, ("Distance", "Height"), {}, figure)
    before, after = figure.axes
    assert 1 > before.get_aspect() == after.get_aspect()
    assert before.get_xlim() == after.get_xlim()
    draw_section([near, near], colours, ("Distance", "Height"), {}, figure)
    assert figure.axes[0].get_aspect() == before.get_aspect(), "the smaller factor for both"
    for size in ((9.0, 1.8), (14.0, 2.2)):  # low and wide, as the panel is
        figure = Figure(figsize=size, layout="constrained")
        FigureCanvasAgg(figure)
        draw_section(cuts, colours, ("Distance", "Height"), {}, figure)
        figure.canvas.draw()
        for axes in figure.axes:
            box = axes.get_window_extent()
            assert box.width > 2.5 * box.height, "it fills the space between its titles"
            labels = [
                each.get_window_extent() for each in axes.get_xticklabels() if each.get_visible()
            ]
            labels = [
                each for each in labels if box.x0 - 1 <= 0.5 * (each.x0 + each.x1) <= box.x1 + 1
            ]
            assert len(labels) > 1
            labels.sort(key=lambda each: each.x0)
            assert all(a.x1 < b.x0 for a, b in pairwise(labels))
    flat = replace(near, normal=np.array([0.0, 1.0]))
    for language, height in product(LANGUAGES, (2.4, 3.0)):
        figure = Figure(figsize=(8.0, height), layout="constrained")
        FigureCanvasAgg(figure)
        with in_language(language):
            draw_section([flat, flat], colours, ("Distance", "Height"), {}, figure)
        figure.canvas.draw()
        label = figure.axes[0].yaxis.label.get_window_extent()
        assert 0 <= label.y0 < label.y1 <= figure.bbox.height, "not cut off"


FIGURE_SIZES = ((5.5, 1.5), (9.0, 1.5), (12.0, 1.5), (12.0, 3.0), (6.0, 6.0))


def test_the_whole_section_is_shown_in_a_figure_of_any_size(adjusted: Driver) -> None:
    """Along the surface the whole section, and across it all lines, in the width of the plot."""
    press(adjusted, Key.Key_S)
    adjusted.rest()
    adjusted.window._select("T1", "")
    adjusted.rest()
    cuts = adjusted.window.tools.sections._cuts
    flat = [
        replace(
            cut, normal=np.array([0.0, 1.0]),
            points={line: points[:, ::-1] for line, points in cut.points.items()},
        )
        for cut in cuts
    ]  # fmt: skip
    colours = {line.name: (0, 0, 0) for line in adjusted.project.lines}
    half = 0.5 * cuts[0].section.width
    for size, (shown, across) in product(FIGURE_SIZES, ((cuts, 0), (flat, 1))):
        figure = Figure(figsize=size, layout="constrained")
        FigureCanvasAgg(figure)
        draw_section(
            shown, colours, (AHEAD_LABEL, HEIGHT_LABEL), {}, figure, labelled=size[1] > 2.0
        )
        figure.canvas.draw()
        for axes, cut in zip(figure.axes, shown, strict=True):
            limits = axes.get_xlim(), axes.get_ylim()
            assert limits[1 - across] == pytest.approx((-half, half))
            normal = cut.normal / np.linalg.norm(cut.normal)
            for points in cut.points.values():
                middle = abs(float(np.median(points @ normal)))
                assert middle < max(limits[across])
            box = axes.get_window_extent()
            slot = figure.bbox.width / len(shown)
            assert box.width > 0.5 * slot or box.height > 0.5 * figure.bbox.height
        lengths = (box.width, box.height)  # the last picture is that after the adjustment
        drawn_px = 0.02 * lengths[across] / np.ptp(limits[across])
        assert drawn_px > 0.1 * figure.dpi, "2 cm between lines are visible"


@LONG
@pytest.mark.parametrize("factor", others_long(["automatic", "1", "50"]))
@pytest.mark.parametrize("language", others_long(LANGUAGES, lambda code: code == "fr"))
def test_a_low_section_has_separate_numbers_and_titles_of_one_line(
    adjusted: Driver, factor: str, language: str
) -> None:
    press(adjusted, Key.Key_S)
    adjusted.rest()
    adjusted.window._select("T1", "")
    adjusted.rest()
    cuts = adjusted.window.tools.sections._cuts
    flat = [replace(cut, normal=np.array([0.0, 1.0])) for cut in cuts]
    colours = {line.name: (0, 0, 0) for line in adjusted.project.lines}
    for shown, upward, size in product(
        (cuts, flat), (HEIGHT_LABEL, AHEAD_LABEL), ((5.5, 1.5), (7.0, 1.6), (9.0, 1.8))
    ):
        figure = Figure(figsize=size, layout="constrained")
        FigureCanvasAgg(figure)
        with in_language(language):
            draw_section(
                shown, colours, (AHEAD_LABEL, upward), {}, figure, labelled=False,
                exaggeration=None if factor == "automatic" else int(factor),
            )  # fmt: skip
            figure.canvas.draw()
        title = figure.axes[0].yaxis.label
        assert title.get_text()
        assert "\n" not in title.get_text()
        box = title.get_window_extent()
        assert 0 <= box.y0 < box.y1 <= figure.bbox.height, "not cut off"
        for axes in figure.axes:
            frame = axes.get_window_extent()
            across = [
                box
                for each in axes.get_xticklabels()
                if frame.x0 - 1
                <= np.mean((box := each.get_window_extent()).intervalx)
                <= frame.x1 + 1
            ]
            upward_boxes = [
                box
                for each in axes.get_yticklabels()
                if frame.y0 - 1
                <= np.mean((box := each.get_window_extent()).intervaly)
                <= frame.y1 + 1
            ]
            assert across
            assert upward_boxes
            across.sort(key=lambda each: each.x0)
            upward_boxes.sort(key=lambda each: each.y0)
            assert all(a.x1 + 2 < b.x0 for a, b in pairwise(across))
            assert all(a.y1 < b.y0 for a, b in pairwise(upward_boxes))
        before, after = figure.axes
        if before.get_shared_x_axes().joined(before, after):
            assert list(before.get_xticks()) == list(after.get_xticks())
            assert list(before.get_yticks()) == list(after.get_yticks())


@LONG
def test_an_accepted_target_is_selected_and_has_its_section(opened: Driver) -> None:
    window, panel = opened.window, opened.window.tools.sections.panel
    press(opened, Key.Key_S)
    opened.rest()
    words = panel.text_label
    assert words.isVisible()
    assert words.height() >= words.heightForWidth(words.width()), "all of it is seen"
    seed(opened, "T1")
    press(opened, Key.Key_Return)
    fits = [call for call in opened.viewport.calls if call[0] == "fit"]
    assert window.targets.current == "T1"
    press(opened, Key.Key_S)
    opened.rest()
    assert panel.through.text() == "Across T1"
    assert not words.isVisible()
    seed(opened, "T2")
    press(opened, Key.Key_Return)
    assert window.targets.current == "T2"
    assert [call for call in opened.viewport.calls if call[0] == "fit"] == fits, "it stays there"
    window.targets.line_choice.setCurrentIndex(1)
    window.targets.table.clearSelection()
    seed(opened, "V1")
    press(opened, Key.Key_Return)
    assert window.targets.current is None, "a click on that line seeks a new one"
    assert window.scene.selected == ("V1", "")


def test_a_section_is_cut_between_two_points(picked: Driver) -> None:
    window, panel = picked.window, picked.window.tools.sections.panel
    press(picked, Key.Key_S)
    click(picked, panel.points)
    first, second = points(picked, 100, 4000)
    picked.rest()
    assert picked.viewport.mouse_mode == "navigate"
    assert panel.through.text() == "Between two points"
    assert not panel.orientation.isEnabled()
    (axes,) = panel.canvas.figure.axes
    length = np.hypot(*(second - first)[:2])
    assert axes.get_xlim() == pytest.approx((0.0, length))
    cut = window.tools.sections._cuts[0]
    drawn = {each.get_gid(): each.get_xdata() for each in axes.lines}
    line = max(cut.points, key=lambda each: len(cut.points[each]))
    assert drawn[line] == pytest.approx(cut.points[line][:, 0] + length / 2)
    assert np.ptp(axes.get_ylim()) == pytest.approx(panel.size.value())
    window._select("T1", "")
    assert not panel.canvas.isVisible(), "not the former section below the new selection"
    picked.rest()
    assert panel.canvas.isVisible()
    assert panel.through.text() == "Across T1"
    press(picked, Key.Key_S, SHIFT)
    points(picked, 5)
    press(picked, Key.Key_Escape)
    picked.rest()
    assert panel.through.text() == "Across T1"


def drag_handle(driver: Driver, handle: int, metres: float) -> None:
    """Drag a dot of the section along its axis with the mouse, in two steps."""
    view = driver.viewport
    dot = view._sketch_layer._sketches["section"].handles[handle]
    start, end = (
        QPoint(*np.round(view.to_pixels(np.array([dot.position]) + share * np.array(dot.axis))[0])
               .astype(int))
        for share in (0.0, metres)
    )  # fmt: skip
    driver.bot.mousePress(view.canvas, Qt.MouseButton.LeftButton, pos=start)
    for place in ((start + end) / 2, end):
        driver.bot.mouseMove(view.canvas, place)
    driver.bot.wait(DRAG_UPDATE_MS + 50)
    driver.bot.waitUntil(lambda: not driver.window.runner.active, timeout=20_000)
    assert driver.window.tools.sections.panel.canvas.isVisible()
    driver.bot.mouseRelease(view.canvas, Qt.MouseButton.LeftButton, pos=end)
    wait_until_idle(driver)


@LONG
def test_the_section_is_dragged_through_the_scene_and_stepped_by_keys(
    real: Driver, demo: Demo
) -> None:
    window, sections = real.window, real.window.tools.sections
    window.document.open(demo.picked, demo.survey)
    wait_until_idle(real)
    press(real, Key.Key_S)
    window._go_to("T1", "")
    wait_until_idle(real)
    camera, first = real.viewport.camera, sections.section
    drawn = sections._cuts
    drag_handle(real, 0, 0.4)
    moved = sections.section
    distance = float((moved.centre - first.centre) @ first.across)
    assert distance == pytest.approx(0.4, abs=0.05)
    np.testing.assert_allclose(moved.centre, first.centre + distance * first.across, atol=1e-9)
    assert real.viewport.camera is camera
    for line, points in sections._cuts[0].points.items():
        np.testing.assert_array_equal(points, moved.cut_points(window.scene.clouds[line]))
    assert sections._cuts is not drawn
    for key, expected in ((Key.Key_Up, 0.2), (Key.Key_Down, 0.0), (Key.Key_Down, -0.2)):
        press(real, key, Qt.KeyboardModifier.AltModifier)
        wait_until_idle(real)
        shift = float((sections.section.centre - moved.centre) @ first.across)
        assert shift == pytest.approx(expected, abs=1e-9)
    window._select("T2", "")
    window._select("T1", "")
    wait_until_idle(real)
    np.testing.assert_allclose(sections.section.centre, first.centre)
    half = 0.5 * first.width * first.right
    sections._ends = [first.centre - half, first.centre + half]
    sections._update_section()
    wait_until_idle(real)
    drag_handle(real, 2, 0.5)
    longer = sections.section
    assert longer.width == pytest.approx(first.width + 0.5, abs=0.05)
    np.testing.assert_allclose(
        longer.centre - 0.5 * longer.width * longer.right, first.centre - half, atol=1e-9
    )


def test_the_section_is_zoomed_and_moved_with_the_mouse(picked: Driver) -> None:
    window, panel = picked.window, picked.window.tools.sections.panel
    press(picked, Key.Key_S)
    window._select("T1", "")
    picked.rest()
    canvas = panel.canvas
    canvas.draw()
    (axes,) = canvas.figure.axes
    whole = np.ptp(axes.get_xlim())
    left, low, right, high = axes.bbox.extents / canvas.devicePixelRatioF()
    spot = QPoint(round((left + right) / 2), round(canvas.height() - (low + high) / 2))
    wheel = QWheelEvent(
        QPointF(spot), QPointF(canvas.mapToGlobal(spot)), QPoint(), QPoint(0, 120),
        Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase,
        False,
    )  # fmt: skip
    QApplication.sendEvent(canvas, wheel)
    assert np.ptp(axes.get_xlim()) == pytest.approx(0.8 * whole)
    middle = np.mean(axes.get_xlim())
    picked.bot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=spot)
    picked.bot.mouseMove(canvas, spot + QPoint(20, 0))
    picked.bot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=spot + QPoint(20, 0))
    metres = 20 * 0.8 * whole / (right - left) * (-1 if axes.xaxis_inverted() else 1)
    assert middle - np.mean(axes.get_xlim()) == pytest.approx(metres, rel=0.05)
    assert axes.xaxis_inverted(), "the board is to the right of the vessel"
    picked.bot.mouseDClick(canvas, Qt.MouseButton.LeftButton, pos=spot)
    assert np.ptp(axes.get_xlim()) == pytest.approx(whole)


def test_the_clip_box_encloses_the_target_and_is_changed_by_fields_and_handles(
    picked: Driver,
) -> None:
    window, view, clipping = picked.window, picked.viewport, picked.window.tools.clipping
    window._select("T1", "")
    press(picked, Key.Key_X)
    assert window.actions_["clip"].isChecked()
    box = view.box
    points = np.concatenate(list(window.scene.selected_points.values()))
    along_axes = np.abs((points - box.centre) @ box.axes.T)
    np.testing.assert_allclose(box.half - along_axes.max(axis=0), 0.5, atol=1e-9)
    depth = clipping.panel.fields[0]
    assert depth.value() == pytest.approx(2 * box.half[0], abs=0.006)
    type_into(picked, depth, "3.00")
    picked.bot.keyClick(depth, Key.Key_Return)
    assert 2 * view.box.half[0] == pytest.approx(3.0)
    np.testing.assert_array_equal(view.box.centre, box.centre)
    was = view.box
    handle = view.sketches["clip"].handles[5]  # the upper side
    assert handle.axis == pytest.approx((0, 0, 1))
    view.signals.handle_moved.emit("clip", 5, 0.4)
    assert view.box is was, "the points follow when the handle is let go"
    assert view.sketches["clip"].handles[5].position[2] == pytest.approx(handle.position[2] + 0.4)
    view.signals.handle_released.emit("clip")
    assert view.box.half[2] == pytest.approx(was.half[2] + 0.2)
    assert view.box.centre[2] - view.box.half[2] == pytest.approx(was.centre[2] - was.half[2])
    click(picked, clipping.panel.reset)
    assert view.box is None
    assert "clip" not in view.sketches
    assert not window.actions_["clip"].isChecked()
    choose(picked.bot, open_menu(picked.bot, window, "Inspect"), "Clip box")
    assert view.box is not None
    window.document.open(None, None)
    assert view.box is None


def test_the_clip_box_moves_to_a_hidden_target(picked: Driver) -> None:
    window, view = picked.window, picked.viewport
    window._select("T1", "")
    press(picked, Key.Key_X)
    box = view.box
    window._select("T1", picked.project.lines[0].name)
    assert view.box is box  # the sighting is inside the box
    window._go_to("T2", "")
    points = np.concatenate(list(window.scene.selected_points.values()))
    assert len(view.box.inside(points)) == len(points)
    assert not len(box.inside(points))
    assert "T2" in window.task_bar.currentMessage()
    window.cause_navigation.show_cause(Cause.of_line(picked.project.lines[1].name))
    sample = window.scene.clouds[picked.project.lines[1].name].sample[::50]
    assert len(view.box.inside(sample)) > 0.99 * len(sample)


def lit(window: MainWindow) -> set[str]:
    """Choices of the lines shown that are switched on, in the menu and in the panel."""
    panel = {"panel before": window.validate.before, "panel after": window.validate.after}
    return {name for name in ("before", "after", "wipe") if window.actions_[name].isChecked()} | {
        name for name, button in panel.items() if button.isChecked()
    }


def test_before_and_after_are_compared_in_one_picture(adjusted: Driver) -> None:
    window, view = adjusted.window, adjusted.viewport
    press(adjusted, Key.Key_W)
    adjusted.rest()
    assert window.scene.which == "estimated"
    line = window.document.survey.lines[0]
    np.testing.assert_array_equal(
        view.wipe_clouds[line], window.document.survey.clouds[line].sample
    )
    assert not np.array_equal(view.wipe_clouds[line], view.clouds[line])
    targets = {target.name: target for target in adjusted.project.targets}
    prior = window.document.survey.clouds
    assert {each.key for each in view.wipe_highlights} == {each.key for each in view.highlights}
    for (name, line), points in ((each.key, each.points) for each in view.wipe_highlights):
        sighting = next(each for each in targets[name].sightings if each.line == line)
        np.testing.assert_array_equal(points, prior[line][sighting.indices])
    assert lit(window) == {"wipe"}
    press(adjusted, Key.Key_W)
    assert view.wipe_clouds is None
    assert window.scene.which == "estimated"
    assert lit(window) == {"after", "panel after"}
    for button, shown in ((window.validate.after, "after"), (window.validate.before, "before")):
        press(adjusted, Key.Key_W)
        adjusted.rest()
        assert lit(window) == {"wipe"}
        open_step(adjusted, VALIDATE)
        adjusted.bot.mouseClick(button, Left)
        adjusted.rest()
        assert view.wipe_clouds is None
        assert lit(window) == {shown, f"panel {shown}"}
    press(adjusted, Key.Key_W)
    adjusted.rest()
    assert view.wipe_clouds is not None
    press(adjusted, Key.Key_B)  # the view of the lines before ends the comparison
    adjusted.rest()
    assert view.wipe_clouds is None
    assert not window.actions_["wipe"].isChecked()


def test_a_comparison_without_a_result_is_disabled_with_a_reason(picked: Driver) -> None:
    action = picked.window.actions_["wipe"]
    assert not action.isEnabled()
    assert action.toolTip() != ""
    press(picked, Key.Key_W)
    assert picked.viewport.wipe_clouds is None
    assert not picked.window.actions_["wipe"].isChecked()


def test_a_preview_shows_the_plane_that_a_click_would_pick(picked: Driver) -> None:
    window, view = picked.window, picked.viewport
    sighting = picked.project.target("T1").sightings[0]
    board = window.scene.clouds[sighting.line][sighting.indices]
    north, west, up = (float(v) for v in board[np.argmin(np.linalg.norm(
        board - board.mean(axis=0), axis=1))])  # fmt: skip
    view.signals.hovered.emit(PickedPoint(sighting.line, (north, west, up)))
    assert "hover" not in view.sketches
    press(picked, Key.Key_H)
    picked.rest()
    view.signals.hovered.emit(PickedPoint(sighting.line, (north, west, up)))
    sketch = view.sketches["hover"]
    assert re.fullmatch(rf"Plane of about 1\.[12] × 1\.[12] m in {sighting.line}", sketch.label)
    outline = np.array(sketch.points)
    # The outline agrees with the plane picked there.
    np.testing.assert_allclose(outline.min(axis=0), board.min(axis=0), atol=0.08)
    np.testing.assert_allclose(outline.max(axis=0), board.max(axis=0), atol=0.08)
    view.signals.hovered.emit(None)
    assert "hover" not in view.sketches
    view.signals.hovered.emit(PickedPoint(sighting.line, (north, west, up)))
    view.signals.hovered.emit(PickedPoint(sighting.line, (north, west, up + 300.0)))
    assert "hover" not in view.sketches
    # No preview on the candidate, because it would hide the candidate's label.
    there = PickedPoint(sighting.line, (north, west, up))
    view.signals.hovered.emit(there)
    view.signals.seed_clicked.emit(there)
    picked.rest()
    assert window.controller.candidate is not None
    assert "hover" not in view.sketches
    view.signals.hovered.emit(there)
    assert "hover" not in view.sketches
    press(picked, Key.Key_Escape)
    view.signals.hovered.emit(there)
    assert "hover" in view.sketches
    press(picked, Key.Key_H)
    view.signals.hovered.emit(there)
    assert "hover" not in view.sketches
