"""Tests of the colours of points by their attributes."""

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QImage, QRegion, QWheelEvent
from PySide6.QtWidgets import QApplication, QWidget

from lispac.gui.app.point_colours import (
    COLOUR_SCALES,
    COLOURINGS,
    LEGEND_TITLES,
    Scale,
    point_shading,
    set_colour_scale,
)
from lispac.gui.appearance import theme
from lispac.gui.appearance.colour_schemes import DARK_SCHEME, LIGHT_SCHEME
from lispac.gui.features.inspect.actions import ACTIONS, COLOUR_ACTIONS
from lispac.gui.project.residuals import LEGEND_TITLE as RESIDUAL_TITLE
from lispac.gui.project.residuals import colour_limit_for
from lispac.gui.project.status import TARGETS
from lispac.language import LANGUAGES, gettext, in_language
from lispac.picked_targets import Target
from lispac.project import Project
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import Demo, Driver, Key, Left, open_step, press, wait_until_idle
from tests.support.view_scenes import count, picture


def test_colours_depend_on_the_values(demo: Demo) -> None:
    clouds = demo.survey.clouds
    assert point_shading("line", clouds) is None
    for colouring in COLOURINGS[1:-1]:
        shaded = point_shading(colouring, clouds)
        assert shaded is not None
        for name, cloud in clouds.items():
            assert shaded.colours[name].shape == (len(cloud.sample), 3)
            assert shaded.colours[name].dtype == np.uint8
    height = point_shading("height", clouds)
    places = {tuple(colour): k for k, colour in enumerate(height.scale.tolist())}
    name = demo.survey.lines[0]
    up = clouds[name].sample[:, 2]
    order = [places[tuple(colour)] for colour in height.colours[name].tolist()]
    assert (np.diff(np.array(order)[np.argsort(up, kind="stable")]) >= 0).all()
    low, high = float(height.low), float(height.high)
    everything = np.concatenate([cloud.sample[:, 2] for cloud in clouds.values()])
    assert everything.min() <= low + 0.5
    assert low < high <= everything.max() + 0.5
    time = point_shading("time", clouds)
    assert float(time.low) == 0


@pytest.mark.parametrize("scale", COLOUR_SCALES)
def test_a_scale_is_visible_on_light_and_dark_backgrounds(demo: Demo, scale: Scale) -> None:
    """No colour of the scale is close to the background of the view, light or dark."""
    set_colour_scale(scale)
    try:
        shaded = point_shading("height", demo.survey.clouds)
    finally:
        set_colour_scale("viridis")
    assert shaded is not None
    colours = shaded.scale.astype(float)
    assert len(np.unique(shaded.scale, axis=0)) > 100  # a grey scale has no more distinct values
    for scheme in (LIGHT_SCHEME, DARK_SCHEME):
        for ground in (scheme.ground, scheme.sky):
            away = np.array(QColor(ground).getRgb()[:3], dtype=float)
            assert np.linalg.norm(colours - away, axis=1).min() > 25


def test_keys_and_menu_change_the_colours(opened: Driver) -> None:
    for colouring in (*COLOURINGS[1:-1], "line"):
        press(opened, Key.Key_C)
        assert opened.window.scene.colouring == colouring
        assert opened.window.actions_[COLOUR_ACTIONS[colouring]].isChecked()
        assert (opened.viewport.shading is None) == (colouring == "line")
    opened.window.actions_["colour_range"].trigger()
    assert opened.viewport.shading.title == "Range (m)"
    line = opened.window.document.survey.lines[0]
    assert len(opened.viewport.shading.colours[line]) == len(opened.viewport.clouds[line])


def test_targets_have_the_colours_of_their_lines_and_keep_their_halos(picked: Driver) -> None:
    plain = {each.key: each for each in picked.viewport.highlights}
    assert all(each.shades is None for each in plain.values())
    survey = picked.window.document.survey
    assert len(survey.lines) > 1
    targets = {target.name: target for target in picked.window.document.project.targets}
    for colouring in COLOURINGS[1:-1]:
        picked.window.actions_[COLOUR_ACTIONS[colouring]].trigger()
        picked.rest()
        shading = picked.viewport.shading
        assert len(picked.viewport.highlights) == len(plain)
        for each in picked.viewport.highlights:
            name, line = each.key
            sighting = next(s for s in targets[name].sightings if s.line == line)
            assert each.halo == plain[each.key].halo
            # All points of the demo are in the sample of their line, in the same order.
            np.testing.assert_array_equal(each.shades, shading.colours[line][sighting.indices])


def test_residuals_of_a_sighting_are_within_a_round_scale() -> None:
    rng = np.random.default_rng(5)
    agreeing = {("T1", str(k)): rng.normal(0.0, 0.002, 1000) for k in range(40)}
    assert colour_limit_for(agreeing) == pytest.approx(0.005)
    noisy = {key: 8.0 * values for key, values in agreeing.items()}
    assert colour_limit_for(noisy) == pytest.approx(0.05)
    shifted = agreeing | {("V1", str(k)): rng.normal(0.041, 0.002, 20) for k in range(3)}
    assert colour_limit_for(shifted) == pytest.approx(0.05)
    single = agreeing | {("V1", "0"): np.full(20, 3.0)}
    assert colour_limit_for(single) == pytest.approx(0.005)


def test_lines_without_intensities_are_reported_and_skipped(
    opened: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    survey = opened.window.document.survey
    name, cloud = survey.lines[1], survey.clouds[survey.lines[1]]
    bare = SimpleNamespace(
        sample=cloud.sample, sample_range=cloud.sample_range, sample_time=cloud.sample_time,
        sample_intensity=None,
    )  # fmt: skip
    with pytest.raises(ValueError, match="no intensities"):
        point_shading("intensity", {name: bare})
    monkeypatch.setattr(type(opened.window.scene), "clouds", {name: bare})
    opened.window.actions_["colour_intensity"].trigger()
    assert opened.window.scene.colouring == "line"
    assert opened.window.actions_["colour_line"].isChecked()
    press(opened, Key.Key_C)
    press(opened, Key.Key_C)
    assert opened.window.scene.colouring == "range"


@pytest.mark.parametrize("code", LANGUAGES)
def test_menu_and_legend_have_the_same_name_for_a_colouring(code: str) -> None:
    titles = {**LEGEND_TITLES, "residual": RESIDUAL_TITLE}
    assert set(titles) == set(COLOURINGS) - {"line"}
    with in_language(code):
        for colouring, title in titles.items():
            name = ACTIONS[COLOUR_ACTIONS[colouring]].texts[0].replace("&", "").split()[-1]
            assert gettext(title).partition("(")[0].split()[0].lower() == name.lower()


def click_target(driver: Driver, row: int) -> Target:
    """Click a row of the list of targets, and zoom to the selection with its key."""
    open_step(driver, TARGETS)
    table = driver.window.targets.table
    place = table.visualItemRect(table.item(row, 0)).center()
    driver.bot.mouseClick(table.viewport(), Left, pos=place)
    press(driver, Key.Key_F, Qt.KeyboardModifier.ShiftModifier)
    wait_until_idle(driver)
    return driver.project.target(table.item(row, 0).text())


def packed(colours: np.ndarray) -> np.ndarray:
    """Colours (..., 3) as one number each."""
    return colours.astype(int) @ (1 << 16, 1 << 8, 1)


def turn_wheel(driver: Driver, at: QPoint, notches: int) -> None:
    canvas, where = driver.viewport.canvas, QPointF(at)
    angle = 120 if notches > 0 else -120
    for _ in range(abs(notches)):
        turned = QWheelEvent(
            where, QPointF(canvas.mapToGlobal(at)), QPoint(), QPoint(0, angle),
            Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase,
            False,
        )  # fmt: skip
        QApplication.sendEvent(canvas, turned)
    driver.bot.wait(300)


def test_colours_of_lines_and_residuals_are_visible_on_a_selected_target(
    real: Driver, demo: Demo, estimated: Project
) -> None:
    window, view = real.window, real.viewport
    window.document.open(estimated, demo.survey)
    wait_until_idle(real)
    target = click_target(real, 0)
    assert window.scene.selected == (target.name, "")
    colours = theme.line_colours([line.name for line in real.project.lines])
    image = picture(view)
    seen = {each.line: count(image, colours[each.line]) for each in target.used_sightings}
    assert len(seen) > 1
    assert min(seen.values()) > 100, seen

    choose(real.bot, open_menu(real.bot, window, "View"), "Colour by", "residual")
    wait_until_idle(real)
    # Synthetic clicks sometimes leave the menu open
    while (popup := QApplication.activePopupWidget()) is not None:
        real.bot.keyClick(popup, Key.Key_Escape)
    action, shading = window.actions_["colour_residual"], view.widget.overlay.shading
    assert action.isChecked()
    name = action.text().replace("&", "").split()[-1]
    assert shading.title.split()[0].lower() == name.lower()
    points = np.concatenate(list(window.scene.selected_points.values()))
    shades = packed(np.vstack([shading.scale[:110], shading.scale[-110:]]))  # blue and red

    def size_and_shaded() -> tuple[float, int]:
        """Width of the target, and number of its pixels that are blue or red."""
        places = view.to_pixels(points)[:, :2]
        (left, top), (right, bottom) = places.min(axis=0), places.max(axis=0)
        rows = slice(max(0, int(top)), int(np.ceil(bottom)) + 1)
        columns = slice(max(0, int(left)), int(np.ceil(right)) + 1)
        return right - left, int(np.isin(packed(picture(view)[rows, columns]), shades).sum())

    middle = QPoint(*view.to_pixels(points.mean(axis=0)[None])[0][:2].astype(int).tolist())
    seen_at = []
    for notches in (4, -12, -8):
        turn_wheel(real, middle, notches)
        seen_at.append(size_and_shaded())
    (near, near_shaded), _, (far, far_shaded) = seen_at
    assert near > 10 * far, seen_at
    assert near_shaded > 5000, seen_at
    assert far_shaded > 20, seen_at

    press(real, Key.Key_F)
    press(real, Key.Key_M)
    wait_until_idle(real)
    overlay = view.widget.overlay
    assert overlay.hint
    assert overlay.markers
    painted = QImage(overlay.size(), QImage.Format.Format_ARGB32)
    painted.fill(0)
    overlay.render(painted, QPoint(), QRegion(), QWidget.RenderFlag.DrawChildren)
    alpha = np.frombuffer(painted.constBits(), np.uint8).reshape(painted.height(), -1, 4)[..., 3]
    inked = alpha > 0
    assert inked.any()
    for box in overlay.label_boxes:
        at = box.toAlignedRect().adjusted(-20, -20, 20, 20)
        inked[max(0, at.top()) : at.bottom(), max(0, at.left()) : at.right()] = False
    for x, y in view.to_pixels(np.array([each.position for each in overlay.markers]))[:, :2]:
        inked[max(0, int(y) - 12) : int(y) + 13, max(0, int(x) - 12) : int(x) + 13] = False
    height, width = inked.shape
    assert not inked[height // 5 : -height // 5, width // 5 : -width // 5].any()
