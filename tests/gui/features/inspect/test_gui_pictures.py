"""Tests of pictures of the view and of the section, of keys of the view, and of its labels."""

import re
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QFontMetricsF, QGuiApplication, QImage, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from lispac.gui.appearance import units
from lispac.gui.features.help.dialogs import shortcuts_box
from lispac.gui.features.inspect.picture_export import NO_SECTION_TEXT
from lispac.gui.features.pick_targets.sightings_table import EDITED_SYMBOL
from lispac.gui.viewport.base import Marker, PointColouring
from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.overlay import (
    OverlaidPicture,
    OverlaidView,
    free_label_place,
    leader_line,
)
from lispac.project import Project
from tests.gui.support import Control, Demo, Driver, Key, click, press, wait_until_idle
from tests.support.long_runs import LONG
from tests.support.view_scenes import scene

SHIFT = Qt.KeyboardModifier.ShiftModifier


def section(driver: Driver, surface: str = "T1"):
    press(driver, Key.Key_S)
    window = driver.window
    window.resizeDocks([window.docks["Section"]], [420], Qt.Orientation.Vertical)
    window._select(surface, "")
    wait_until_idle(driver)
    return window.tools.sections.panel


def test_p_saves_the_view_and_shift_p_copies_it(picked: Driver, tmp_path: Path) -> None:
    window = picked.window
    picked.dialogs.path = tmp_path / "view.png"
    press(picked, Key.Key_P)
    wait_until_idle(picked)
    assert picked.dialogs.requests[-1] == f"{picked.project.name}-view.png"
    assert not QImage(str(tmp_path / "view.png")).isNull()
    assert f"Wrote {tmp_path / 'view.png'}" in window.log.toPlainText()
    QGuiApplication.clipboard().clear()
    press(picked, Key.Key_P, SHIFT)
    assert QGuiApplication.clipboard().image().size() == picked.viewport.widget.size()
    picked.dialogs.path = Path("/dev/null/view.png")
    press(picked, Key.Key_P)
    wait_until_idle(picked)
    assert picked.dialogs.errors[-1].code == "file.not_writable"


@LONG
def test_the_section_is_saved_and_copied_as_it_is_shown(picked: Driver, tmp_path: Path) -> None:
    press(picked, Key.Key_S)
    panel = picked.window.tools.sections.panel
    assert not panel.save_picture.isEnabled()
    assert not panel.copy_picture.isEnabled()
    picked.dialogs.path = tmp_path / "section.png"
    press(picked, Key.Key_P, Control)
    wait_until_idle(picked)
    press(picked, Key.Key_P, Control | SHIFT)
    assert picked.window.log.toPlainText().count(NO_SECTION_TEXT) == 2
    assert not (tmp_path / "section.png").exists()
    panel = section(picked)
    shown = panel.canvas.figure.axes[0].get_xlim()
    click(picked, panel.save_picture)
    wait_until_idle(picked)
    assert picked.dialogs.requests[-1] == f"{picked.project.name}-section-across-t1.png"
    saved = QImage(str(tmp_path / "section.png"))
    inches = panel.canvas.figure.get_size_inches()
    assert saved.width() == pytest.approx(200 * inches[0], abs=2)
    for kind, begins in (("svg", b"<?xml"), ("pdf", b"%PDF")):
        picked.dialogs.path = tmp_path / f"section.{kind}"
        press(picked, Key.Key_P, Control)
        wait_until_idle(picked)
        assert picked.dialogs.path.read_bytes().startswith(begins)
    QGuiApplication.clipboard().clear()
    click(picked, panel.copy_picture)
    wait_until_idle(picked)
    assert QGuiApplication.clipboard().image().size() == saved.size()
    # Saving changes nothing in the panel.
    assert panel.canvas.figure.axes[0].get_xlim() == shown
    assert panel.canvas.figure.get_suptitle() == ""
    picked.dialogs.path = Path("/dev/null/section.png")
    press(picked, Key.Key_P, Control)
    wait_until_idle(picked)
    assert len(picked.dialogs.errors) == 1


@LONG
def test_a_section_in_feet_is_saved_in_metres(
    demo: Demo, validated: Project, driver: Driver, tmp_path: Path
) -> None:
    driver.window.document.open(validated, demo.survey)
    wait_until_idle(driver)
    units.set_units("degrees", "feet")
    try:
        panel = section(driver, "V1")
        first = panel.canvas.figure.axes[0]
        assert first.get_xlabel().startswith("Across the surface, ")
        assert first.get_xlabel().endswith(" towards the vessel, enlarged 5 times (ft)")
        assert first.get_ylabel() == "Along the surface, upwards (ft)"
        assert "\N{NO-BREAK SPACE}ft" in first.get_title(loc="left")
        first.set_xlim(-0.25, 0.5)
        driver.dialogs.path = tmp_path / "section.svg"
        press(driver, Key.Key_P, Control)
        wait_until_idle(driver)
        saved = driver.dialogs.path.read_text()  # texts are outlines, with the words as comments
        assert "<!-- Along the surface, upwards (m) -->" in saved
        assert re.search(r"\d mm .*-->", saved.replace("\N{NO-BREAK SPACE}", " "))
        assert "(ft)" not in saved
        assert first.get_xlim() == (-0.25, 0.5)
        assert first.get_ylabel() == "Along the surface, upwards (ft)"
    finally:
        units.set_units("degrees", "metres")


def test_a_sighting_edited_by_hand_is_marked_in_the_table(picked: Driver) -> None:
    table, project = picked.window.table.sightings, picked.project
    target = project.target("T1")
    index = table.index(0, 2)
    assert EDITED_SYMBOL not in index.data()
    second = replace(target.sightings[1], by_hand=True)
    edited = replace(target, sightings=(target.sightings[0], second, *target.sightings[2:]))
    picked.window.document.edit("a change", project.with_target(edited))
    assert index.data().endswith(EDITED_SYMBOL)
    assert "lasso" in index.data(Qt.ItemDataRole.ToolTipRole)
    assert EDITED_SYMBOL not in table.index(0, 1).data()


def test_the_list_of_keys_fits_on_a_small_screen(opened: Driver) -> None:
    box = shortcuts_box(opened.window)
    box.show()
    assert box.height() < 700
    assert box.width() < 1280
    for column in box.findChildren(QLabel):
        assert column.width() >= column.sizeHint().width(), "nothing is cut off"
    box.close()
    box.deleteLater()


def test_arrows_and_pages_move_the_view(viewport) -> None:
    viewport.show_clouds(*scene())
    canvas = viewport.canvas
    canvas.setFocus()
    before = viewport.camera
    QTest.keyClick(canvas, Key.Key_Right)
    turned = viewport.camera
    assert np.degrees(turned.azimuth - before.azimuth) % 360 == pytest.approx(24 * 0.35)
    QTest.keyClick(canvas, Key.Key_Left)
    assert np.cos(viewport.camera.azimuth - before.azimuth) == pytest.approx(1.0)
    point = viewport._navigator.coarse["red"][0]
    x, y = viewport.to_pixels(point[None])[0]
    QTest.keyClick(canvas, Key.Key_Up, SHIFT)
    moved = viewport.to_pixels(point[None])[0]
    assert moved[0] == pytest.approx(x, abs=1.0)
    assert moved[1] < y - 10
    far = viewport.camera.distance
    QTest.keyClick(canvas, Key.Key_PageUp)
    assert viewport.camera.distance == pytest.approx(0.85 * far, rel=0.3)
    assert viewport.camera.distance < far
    QTest.keyClick(canvas, Key.Key_PageDown)
    assert viewport._view_detail.is_due, "the detail follows"


def test_control_and_arrows_move_the_line_between_before_and_after(viewport) -> None:
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    QTest.keyClick(viewport.canvas, Key.Key_Left, Control)
    assert viewport._sketch_layer.share == 0.5
    viewport.show_wipe(clouds)
    QTest.keyClick(viewport.canvas, Key.Key_Left, Control)
    assert viewport._sketch_layer.share == pytest.approx(0.5 - 24 / viewport.canvas.width())


def test_labels_of_adjacent_targets_do_not_overlap(qapp) -> None:
    metrics = QFontMetricsF(qapp.font())
    occupied: list[QRectF] = []
    for step in range(4):
        occupied.append(
            free_label_place(QPointF(300.0 + step, 200.0), metrics, f"T{step}", occupied)
        )
    assert occupied[0].left() > 300.0
    assert occupied[0].bottom() < 200.0
    for k, box in enumerate(occupied):
        assert not any(box.intersects(other) for other in occupied[:k])
    for step in range(4, 12):  # in a crowd, labels are farther from their points
        occupied.append(
            free_label_place(QPointF(300.0, 200.0 + step), metrics, f"T{step}", occupied)
        )
        assert not any(occupied[-1].intersects(other) for other in occupied[:-1])


def test_labels_stay_in_the_picture(qapp) -> None:
    metrics, picture = QFontMetricsF(qapp.font()), QRectF(0.0, 0.0, 400.0, 300.0)
    for spot in (QPointF(3.0, 3.0), QPointF(397.0, 3.0), QPointF(397.0, 297.0)):
        assert picture.contains(free_label_place(spot, metrics, "V12", [], picture))


def test_only_points_in_the_picture_have_labels_and_these_are_whole(qapp) -> None:
    stage, size = OverlaidView(), ViewportSize(400.0, 300.0)
    overlay = stage.overlay
    picture = QRectF(0.0, 0.0, size.width, size.height)
    camera = Camera(np.zeros(3), 0.0, 0.0, 20.0, parallel=True)
    overlay.pictures = [OverlaidPicture(picture, camera)]
    image = QImage(400, 300, QImage.Format.Format_RGB32)

    def boxes(pixels: list[tuple[float, float]]) -> list[QRectF]:
        overlay.markers = [
            Marker(f"Target {k}", tuple(camera.point_at(x, y, 20.0, size)), (200, 0, 0))
            for k, (x, y) in enumerate(pixels)
        ]
        painter = QPainter(image)
        overlay.paint(painter, scale=1.0)
        painter.end()
        return list(overlay.label_boxes)

    corners = [(2.0, 2.0), (398.0, 2.0), (398.0, 298.0), (2.0, 298.0)]
    middle = [(200.0 + 3.0 * k, 4.0) for k in range(12)]
    found = boxes([*corners, *middle])
    assert len(found) == 16
    assert all(picture.contains(box) for box in found)
    assert boxes([(-4.0, 150.0), (404.0, 150.0), (200.0, -4.0), (200.0, 304.0)]) == []


HARBOUR_TARGETS = {
    "T1": (-9.1, -3.8, 4.2), "T2": (-9.0, -1.1, 4.0), "T3": (-17.5, -3.4, 36.1),
    "T4": (-20.0, -13.5, 40.1), "V1": (-9.4, -2.6, 0.6), "V2": (-11.7, -3.0, 43.2),
    "V3": (-20.7, 10.9, 21.1), "V4": (-20.7, -17.1, 20.8), "V5": (-22.1, 7.0, 38.5),
}  # fmt: skip
"""East, north and up of targets of a harbour, some of them above others, metres."""


@pytest.mark.parametrize("pixels_per_metre", [2, 3, 4, 5, 6, 7, 8, 10, 15])
def test_labels_do_not_overlap_in_a_top_view(qapp, pixels_per_metre: int) -> None:
    stage, size = OverlaidView(), ViewportSize(1000.0, 560.0)
    overlay = stage.overlay
    picture = QRectF(0.0, 0.0, size.width, size.height)
    camera = Camera(np.zeros(3), 0.0, 0.0, 20.0, parallel=True)
    overlay.pictures = [OverlaidPicture(picture, camera)]
    overlay.markers = [
        Marker(
            name,
            tuple(
                camera.point_at(
                    600.0 + pixels_per_metre * east, 280.0 - pixels_per_metre * north, 99.0 - up,
                    size,
                )
            ),
            (200, 0, 0),
        )
        for name, (east, north, up) in HARBOUR_TARGETS.items()
    ]  # fmt: skip
    image = QImage(1000, 560, QImage.Format.Format_RGB32)
    painter = QPainter(image)
    overlay.paint(painter, scale=1.0)
    painter.end()
    assert len(overlay.label_boxes) == len(HARBOUR_TARGETS)
    assert not any(a.intersects(b) for a, b in combinations(overlay.label_boxes, 2))


def test_labels_of_targets_do_not_overlap_the_colour_scale(qapp) -> None:
    stage = OverlaidView()
    overlay = stage.overlay
    size = ViewportSize(640.0, 480.0)
    without_scale = overlay.occupied(size)
    overlay.shading = PointColouring({}, "Distance (mm)", "-1", "+1", np.zeros((3, 3), np.uint8))
    (scale,) = (box for box in overlay.occupied(size) if box not in without_scale)
    metrics = QFontMetricsF(qapp.font())
    spot = QPointF(scale.left() + 30.0, scale.bottom() + 10.0)
    assert free_label_place(spot, metrics, "V3", []).intersects(scale)
    assert not free_label_place(spot, metrics, "V3", [scale]).intersects(scale)


def test_the_label_of_a_candidate_gives_way_to_those_of_targets(qapp) -> None:
    stage, size = OverlaidView(), ViewportSize(400.0, 300.0)
    overlay = stage.overlay
    camera = Camera(np.zeros(3), 0.0, 0.0, 20.0, parallel=True)
    overlay.pictures = [OverlaidPicture(QRectF(0.0, 0.0, size.width, size.height), camera)]
    image = QImage(400, 300, QImage.Format.Format_RGB32)

    def paint(*markers: Marker) -> list[QRectF]:
        overlay.markers = markers
        painter = QPainter(image)
        overlay.paint(painter, scale=1.0)
        painter.end()
        return list(overlay.label_boxes)

    def place(x: float, y: float, depth: float) -> tuple[float, float, float]:
        east, north, up = camera.point_at(x, y, depth, size)
        return east, north, up

    first = Marker("T1", place(190.0, 150.0, 20.0), (200, 0, 0))
    second = Marker("T2", place(212.0, 148.0, 20.0), (200, 0, 0))
    for x in range(150, 260, 5):
        for y in range(120, 190, 5):
            nearer = place(x, y, 15.0)
            candidate = Marker("T5?", nearer, (0, 200, 0), is_provisional=True)
            (*targets, box) = paint(first, second, candidate)
            assert not any(box.intersects(other) for other in targets)
            leader = leader_line(QPointF(x, y), box)
            samples = [leader.pointAt(share) for share in np.linspace(0.0, 1.0, 100)]
            assert not any(each.contains(at) for each in targets for at in samples), (x, y)
