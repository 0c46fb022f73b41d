"""Tests of the sketch of the mounting: signs and axes agree with the georeferencing."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QScrollArea, QWidget

from lispac.gui.appearance import theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.widgets.mounting_sketch import (
    SKETCH_HEIGHT_PX,
    VIEWS,
    MountingSketch,
    length_with_unit,
)
from lispac.messages import warning
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses
from tests.gui.support import Control, Driver, Key, finish_layouts, open_step, press, type_into
from tests.support.long_runs import LONG, others_long

RIGHT_UP = {"above": (lambda n, w, u: -w, lambda n, w, u: n),
            "starboard": (lambda n, w, u: n, lambda n, w, u: u)}  # fmt: skip
"""Right and up of each view from north, west, up, for a level vessel heading north."""


def scanner_axes_placed(lever_arm, boresight_deg) -> np.ndarray:
    """Scanner centre and tips of its axes by the georeferencing, shape (4, 3).

    Offsets north, west and up from the POS centre, for a level vessel heading north.
    """
    points = np.vstack([np.zeros(3), np.eye(3)])
    level = Poses(np.zeros((4, 3)), np.zeros((4, 3)))
    return place_points(points, level, Mounting(np.array(lever_arm), np.radians(boresight_deg)))


def offsets(sketch: MountingSketch, view: str) -> np.ndarray:
    """Drawn offset of the scanner from the POS centre, metres to the right and up."""
    way = sketch.pixel_of(view, sketch.lever_arm) - sketch.pixel_of(view, (0.0, 0.0, 0.0))
    return np.array([way.x(), -way.y()]) / sketch.pixels_per_metre


def dot_in_picture(sketch: MountingSketch, view: str, colour: str) -> np.ndarray:
    """Drawn centre of the scanner's dot, pixels to the right and up of the POS centre."""
    picture = sketch.grab().toImage()
    dot_colour = QColor(colour)
    half = picture.width() // 2
    columns = range(half) if view == "above" else range(half, picture.width())
    scale = picture.devicePixelRatio()
    found = [
        (x, y)
        for x in columns
        for y in range(picture.height())
        if picture.pixelColor(x, y) == dot_colour
        and all(
            picture.pixelColor(x + d, y + e) == dot_colour for d, e in ((2, 0), (0, 2), (-2, 0))
        )
    ]
    assert found, f"no dot from {view}"
    origin = sketch.pixel_of(view, (0.0, 0.0, 0.0))
    middle = np.mean(found, axis=0) / scale
    return np.array([middle[0] + 0.5 - origin.x(), origin.y() - middle[1] - 0.5])


def type_mounting(driver: Driver, lever_arm, boresight=("0", "0", "0")) -> MountingSketch:
    """Type lever arm and boresight without Enter, and return the sketch."""
    open_step(driver, 0)
    data = driver.window.data
    for field, text in zip((*data.lever_arm.fields, *data.boresight.fields),
                           (*lever_arm, *boresight), strict=True):  # fmt: skip
        type_into(driver, field, text)
    sketch = data.mounting.sketch
    driver.bot.waitUntil(
        lambda: sketch.isVisible() and sketch.height() == SKETCH_HEIGHT_PX
    )  # laid out
    return sketch


@pytest.mark.parametrize(
    "lever_arm",
    [
        ("1.2", "0.35", "-2.1"),
        ("-0.24", "-0.9", "1.5"),
        *(
            pytest.param(arm, marks=LONG)
            for arm in [("1.2", "0.35", "2.1"), ("-1.2", "0.35", "2.1"), ("1.2", "-0.35", "2.1")]
        ),
    ],
)
def test_a_typed_lever_arm_is_drawn_where_georeferencing_places_it(
    opened: Driver, lever_arm
) -> None:
    sketch = type_mounting(opened, lever_arm)
    north, west, up = scanner_axes_placed([float(each) for each in lever_arm], (0.0, 0.0, 0.0))[0]
    for view in VIEWS:
        right, above = (axis(north, west, up) for axis in RIGHT_UP[view])
        assert offsets(sketch, view) == pytest.approx([right, above], abs=1e-9)
        colour = theme.WARNING if up < -1 else theme.ACCENT
        dot = dot_in_picture(sketch, view, colour) / sketch.pixels_per_metre
        assert dot == pytest.approx([right, above], abs=1.6 / sketch.pixels_per_metre)
    assert opened.project.settings.lever_arm == tuple(map(float, lever_arm))


def test_a_changed_sign_moves_the_scanner_to_the_other_side_while_typing(opened: Driver) -> None:
    sketch = type_mounting(opened, ("0.5", "1.2", "2"))
    port = dot_in_picture(sketch, "above", theme.ACCENT)
    field = opened.window.data.lever_arm.fields[1]
    field.setFocus()
    field.lineEdit().setCursorPosition(0)
    opened.bot.keyClicks(field, "-")
    assert field.value() == -1.2
    starboard = dot_in_picture(sketch, "above", theme.ACCENT)
    assert port[0] < -5 < 5 < starboard[0]
    assert port[1] == pytest.approx(starboard[1], abs=0.6)
    words = opened.window.data.mounting.text_label.text()
    assert "1.200\u00a0m to starboard of" in words
    assert sketch.accessibleDescription() == words


@pytest.mark.parametrize(
    "boresight",
    [
        (35.0, -60.0, 120.0),
        *(
            pytest.param(angles, marks=LONG)
            for angles in [(0.0, 0.0, 90.0), (0.0, 90.0, 0.0), (90.0, 0.0, 0.0), (180.0, 0.0, 0.0)]
        ),
    ],
)
def test_the_drawn_scanner_axes_agree_with_the_georeferencing(opened: Driver, boresight) -> None:
    sketch = type_mounting(opened, ("1", "0.4", "2"), [str(each) for each in boresight])
    assert sketch.factor == 1
    local = scanner_axes_placed((1.0, 0.4, 2.0), boresight)
    drawn, expected = [], []
    for axis in range(3):
        north, west, up = local[1 + axis] - local[0]
        for view in VIEWS:
            start, tip = sketch.axis_ends(view, axis)
            drawn.append((tip.x() - start.x(), start.y() - tip.y()))
            expected.append([way(north, west, up) for way in RIGHT_UP[view]])
    pixels = np.vdot(drawn, expected) / np.vdot(
        expected, expected
    )  # of an axis in the picture plane
    assert pixels > 15
    assert np.array(drawn) == pytest.approx(pixels * np.array(expected), abs=1e-9)


def test_a_small_rotation_is_drawn_in_its_direction(opened: Driver) -> None:
    """The rotation is exaggerated, but a turn to starboard is still drawn to starboard."""
    for yaw in ("0.4", "-0.4"):
        sketch = type_mounting(opened, ("1", "0", "2"), ("0", "0", yaw))
        assert sketch.factor > 1
        local = scanner_axes_placed((1.0, 0.0, 2.0), (0.0, 0.0, float(yaw)))
        start, tip = sketch.axis_ends("above", 0)
        assert np.sign(tip.x() - start.x()) == np.sign(-(local[1] - local[0])[1])
        assert abs(tip.x() - start.x()) > 2


def test_a_field_stays_in_place_while_a_value_is_typed(opened: Driver) -> None:
    opened.window.resize(1366, 768)
    type_mounting(opened, ("1", "0.4", "2"))
    area = opened.window.workflow.findChild(QScrollArea)
    field = opened.window.data.lever_arm.fields[0]
    area.verticalScrollBar().setValue(0)
    finish_layouts()
    place = field.mapToGlobal(QPoint(0, 0))
    type_into(opened, field, "1.5")
    finish_layouts()
    assert field.mapToGlobal(QPoint(0, 0)) == place


def test_a_scanner_far_below_gives_a_warning(opened: Driver) -> None:
    view = opened.window.data.mounting
    type_mounting(opened, ("1.2", "0.35", "-2.1"))
    assert view.warnings_label.isVisible()
    below = warning("mounting.lever_arm_below", below=2.10)
    assert message_text(below) in view.warnings_label.text()
    type_mounting(opened, ("1.2", "0.35", "2.1"))
    assert not view.warnings_label.isVisible()


@pytest.mark.parametrize(
    ("height", "lever_arm"), others_long([(768, "-42"), (768, "-2.1"), (1000, "-2.1")])
)
def test_a_warning_is_fully_visible_while_typing(opened: Driver, height, lever_arm) -> None:
    opened.window.resize(1366, height)
    view, field = opened.window.data.mounting, opened.window.data.lever_arm.fields[2]
    type_mounting(opened, ("1.2", "0.35", "2.1"))
    type_into(opened, field, lever_arm)
    opened.bot.waitUntil(lambda: is_whole(view.warnings_label))
    assert is_whole(field)


def is_whole(widget: QWidget) -> bool:
    """Whether a widget is entirely visible and high enough for its text."""
    return (
        widget.isVisible()
        and widget.visibleRegion().boundingRect() == widget.rect()
        and widget.height() >= widget.heightForWidth(widget.width())
    )


def test_undo_draws_the_former_lever_arm(opened: Driver) -> None:
    before = opened.project.settings.lever_arm
    sketch = type_mounting(opened, ("1.2", "0.35", "2.1"))
    for _ in range(3):
        press(opened, Key.Key_Z, Control)
    assert tuple(sketch.lever_arm) == pytest.approx(before)
    assert opened.project.settings.lever_arm == before


@pytest.mark.parametrize("size", [(262, 220), (330, 220), (620, 220)])
def test_the_sketch_stays_inside_its_widget_at_every_size(qtbot, size) -> None:
    sketch = MountingSketch()
    qtbot.addWidget(sketch)
    sketch.resize(*size)
    for longest in (0.01, 0.3, 1.7, 2.4, 9.0, 33.0, 99.0):
        for sign in (-1.0, 1.0):
            sketch.show_mounting((sign * longest, sign * longest, sign * longest), (0, 0, 0))
            for k, view in enumerate(VIEWS):
                dot = sketch.pixel_of(view, sketch.lever_arm)
                assert k * size[0] / 2 < dot.x() - 5 < dot.x() + 5 < (k + 1) * size[0] / 2
                assert 0 < dot.y() - 5 < dot.y() + 5 < size[1]


def test_distances_are_in_the_chosen_unit() -> None:
    assert length_with_unit(2.1, ".2f") == "2.10\u00a0m"
    units.set_units("degrees", "feet")
    try:
        assert length_with_unit(2.1, ".2f").replace("\u00a0", " ") == f"{2.1 / 0.3048:.2f} ft"
    finally:
        units.set_units("degrees", "metres")


def test_the_import_dialogue_also_draws_the_sketch(filled: ImportDialog, qtbot) -> None:
    page = filled.mounting
    page.lever_arm.fields[1].setFocus()
    page.lever_arm.fields[1].selectAll()
    qtbot.keyClicks(page.lever_arm.fields[1], "-0.8")
    assert offsets(page.view.sketch, "above")[0] == pytest.approx(0.8)
    assert "0.800\u00a0m to starboard" in page.view.text_label.text()


@pytest.mark.parametrize("size", [(1326, 708), pytest.param((1240, 840), marks=LONG)])
def test_the_import_dialogue_shows_warnings_on_every_page(
    filled: ImportDialog, qtbot, size
) -> None:
    filled.resize(*size)
    page, field = filled.mounting, filled.mounting.lever_arm.fields[2]
    filled.tabs.setCurrentWidget(page)
    for typed_in, file_warnings, suffix in (
        ("-2.419", 1, ""),
        ("-42.419", 2, " for this and 1 more warning"),
    ):
        field.setFocus()
        field.selectAll()
        qtbot.keyClicks(field, typed_in)
        warnings = page.view.warnings_label.text().splitlines()
        assert len(warnings) == file_warnings
        assert filled.reason.text() == "", "shown once"
        qtbot.waitUntil(lambda: is_whole(page.view.warnings_label))
        filled.tabs.setCurrentIndex(0)
        assert filled.reason.text() == f"{warnings[0]} See the tab Mounting and accuracies{suffix}."
        qtbot.waitUntil(lambda: is_whole(filled.reason))
        filled.tabs.setCurrentWidget(page)
    field.selectAll()
    qtbot.keyClicks(field, "2.419")
    assert filled.reason.text() == ""
    assert not page.view.warnings_label.isVisible()
