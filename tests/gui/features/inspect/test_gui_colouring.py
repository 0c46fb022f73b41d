"""Tests of the colours of points by their attributes."""

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtGui import QColor

from lispac.gui.app.point_colours import (
    COLOUR_SCALES,
    COLOURINGS,
    LEGEND_TITLES,
    Scale,
    point_shading,
    set_colour_scale,
)
from lispac.gui.appearance.colour_schemes import DARK_SCHEME, LIGHT_SCHEME
from lispac.gui.features.inspect.actions import ACTIONS, COLOUR_ACTIONS
from lispac.gui.project.residuals import LEGEND_TITLE as RESIDUAL_TITLE
from lispac.gui.project.residuals import colour_limit_for
from lispac.language import LANGUAGES, gettext, in_language
from tests.gui.support import Demo, Driver, Key, press


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


@pytest.mark.parametrize("colouring", COLOURINGS[1:-1])
def test_targets_have_the_colours_of_their_lines_and_keep_their_halos(
    picked: Driver, colouring: str
) -> None:
    plain = {each.key: each for each in picked.viewport.highlights}
    assert all(each.shades is None for each in plain.values())
    picked.window.actions_[COLOUR_ACTIONS[colouring]].trigger()
    picked.rest()
    shading, survey = picked.viewport.shading, picked.window.document.survey
    targets = {target.name: target for target in picked.window.document.project.targets}
    assert len(picked.viewport.highlights) == len(plain)
    for each in picked.viewport.highlights:
        name, line = each.key
        sighting = next(s for s in targets[name].sightings if s.line == line)
        assert each.halo == plain[each.key].halo
        # All points of the demo are in the sample of their line, in the same order.
        np.testing.assert_array_equal(each.shades, shading.colours[line][sighting.indices])
    assert len(survey.lines) > 1


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
