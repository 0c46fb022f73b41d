"""Tests of the display units: they apply to the window only; files and projects are metric."""

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QLineEdit
from pytestqt.qtbot import QtBot

from lispac.gui import widgets
from lispac.gui.app.language import set_language
from lispac.gui.app.point_colours import point_shading
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import units
from lispac.gui.features.inspect.measurements import Measurements, distance_text
from lispac.gui.features.validate.histograms_panel import histogram_text
from lispac.gui.features.validate.planes_table import RMS
from lispac.gui.project.residuals import residual_shading
from lispac.gui.viewport.base import PickedPoint
from lispac.gui.viewport.overlay import legend_texts, length_text, scale_bar_length
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.viewport.sketches import label_text
from lispac.gui.widgets.number_field import NumberField
from lispac.gui.widgets.optional_number import OptionalNumber
from lispac.gui.window.session import Session
from lispac.project import Project
from tests.gui.design_support import wait_for_plan
from tests.gui.metric import METRIC, metric_words
from tests.gui.support import Demo, Driver, ScriptedDialogs, finish_layouts, show_panel
from tests.support.long_runs import LONG, others_long

FOOT, SURVEY_FOOT = 0.3048, 1200 / 3937
"""International foot (1959) and US survey foot (1893) in metres."""
MRAD, MINUTE = 180 / math.pi / 1000, 1 / 60
"""Milliradian and minute of arc in degrees."""
SOON_MS = 20_000
ALWAYS_METRIC = (
    "with the middle of the targets [.\\d]+ m to (port|starboard)",  # messages of the core
    "no points within [.\\d]+ m of the chosen point",
    "^Lever arm in that program, from the POS centre: ",  # values for a metric program
    "4x4 with the lever arm in metres$",
)
"""Patterns of the texts that are metric in all display units."""


@pytest.fixture
def imperial() -> Iterator[None]:
    """Set feet and milliradians for the duration of the test."""
    units.set_units("milliradians", "feet")
    yield
    units.set_units("degrees", "metres")


@pytest.fixture
def program(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Session]:
    """A session with an English window in feet and milliradians."""
    kept = AppSettings(tmp_path / "settings.ini")
    kept.language, kept.units = "en", ("milliradians", "feet")
    made = Session(qapp, RecordingViewport, kept, ScriptedDialogs())
    qtbot.waitUntil(made.window.isActiveWindow, timeout=SOON_MS)
    yield made
    made.window.stop_and_hide()
    made.window.deleteLater()
    made.deleteLater()
    units.set_units("degrees", "metres")
    set_language("en")


def field(suffix: str, decimals: int) -> NumberField:
    return widgets.number(
        "field", suffix=suffix, decimals=decimals, low=-1000, high=1000, step=0.01,
        tip="A thing, metres, usually 10 mm",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("code", "lengths", "angles"),
    others_long(
        product(["en", "fr"], units.LENGTH_UNITS, units.ANGLE_UNITS),
        lambda each: each in (("en", "feet", "degrees"), ("fr", "survey feet", "milliradians")),
    ),
)
@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(value=st.floats(-990, 990), suffix=st.sampled_from([" m", " mm", " °"]))
@example(value=-1.19e-7, suffix=" m")  # shown as zero in feet
def test_values_that_are_not_edited_keep_all_digits(
    qapp: QApplication, code: str, lengths: str, angles: str, value: float, suffix: str
) -> None:
    value = round(value, 9)
    set_language(code)
    units.set_units(angles, lengths)
    try:
        shown = field(suffix, 4)
        shown.setValue(value)
        shown.interpretText()  # called by Qt on Enter
        assert shown.value() == value
        typed = field(suffix, 4)
        typed.lineEdit().setText(shown.text())
        typed.interpretText()
        factor = units.shown_unit(suffix.strip()).factor
        half = 0.5 * 10.0 ** -shown.decimals() / factor
        assert typed.value() == pytest.approx(value, abs=1.001 * half + 1e-12)
        assert typed.text() == shown.text()
    finally:
        units.set_units("degrees", "metres")
        set_language("en")


@pytest.mark.parametrize(
    ("angles", "lengths", "suffix", "text", "value"),
    [
        ("degrees", "feet", " m", "10", 10 * FOOT),
        ("degrees", "feet", " mm", "0.01", 10 * FOOT),
        ("degrees", "survey feet", " m", "10", 10 * SURVEY_FOOT),
        ("degrees", "survey feet", " mm", "0.01", 10 * SURVEY_FOOT),
        ("milliradians", "metres", " °", "2.5", 2.5 * MRAD),
        ("minutes", "metres", " °", "-90", -90 * MINUTE),
        ("milliradians", "feet", " s", "2.5", 2.5),
    ],
)
def test_typed_values_are_converted(
    qapp: QApplication, angles: str, lengths: str, suffix: str, text: str, value: float
) -> None:
    units.set_units(angles, lengths)
    try:
        typed = field(suffix, 4)
        typed.lineEdit().setText(text)
        typed.interpretText()
        assert typed.value() == pytest.approx(value, abs=1e-12)
        assert typed.cleanText() == f"{float(text):.{typed.decimals()}f}".replace("-", "−")
    finally:
        units.set_units("degrees", "metres")


def test_a_tooltip_names_the_unit_of_its_field_and_keeps_other_figures(
    qapp: QApplication, imperial: None
) -> None:
    assert field(" m", 4).toolTip() == "A thing, ft, usually 10 mm"
    assert field(" m", 4).suffix() == " ft"


@pytest.mark.parametrize(
    ("code", "texts"),
    [
        ("en", ("−1,234.5\u00a0mm", "+0.0120°", "2e−05\u00a0m", "0.001°")),
        ("fr", ("−1\u202f234,5\u00a0mm", "+0,0120°", "2e−05\u00a0m", "0,001°")),
    ],
)
def test_numbers_are_formatted_in_the_language(code: str, texts: tuple[str, ...]) -> None:
    set_language(code)
    try:
        assert texts == (
            units.local_amount(-1234.5, "mm", ".1f"),
            units.local_amount(0.012, "°", "+.4f"),
            units.local_amount(2e-5, "m", "g"),
            units.local_sign("m°"),
        )
    finally:
        set_language("en")


def test_an_optional_field_keeps_the_digits_of_a_shown_value(
    qapp: QApplication, imperial: None
) -> None:
    sigma = OptionalNumber("s", "Sigma", "mm", 1e3, "not known", "How well")
    assert sigma.value() is None
    sigma.show_value(0.00123456789)
    assert sigma.value() == 0.00123456789
    sigma.setText("0.01")
    assert sigma.value() == pytest.approx(0.01 * FOOT)
    assert sigma.toolTip().startswith("How well, in ft")
    assert "not known" in sigma.toolTip()


@LONG
def test_the_window_shows_one_unit_and_the_project_stays_metric(
    program: Session, demo: Demo, estimated: Project, qtbot: QtBot
) -> None:
    window = program.window
    lever_arm = (-0.185596123, 0.037658456, 2.419063789)
    project = estimated.with_settings(
        replace(estimated.settings, lever_arm=lever_arm, range_offset=0.001234567)
    )
    project = replace(project, result=estimated.result)
    window.document.open(project, demo.survey)
    qtbot.waitUntil(lambda: not window.runner.active, timeout=SOON_MS)
    assert window.document.project is not None

    arm = window.data.lever_arm.fields
    assert [f.text() for f in arm] == [f"{v / FOOT:.4f} ft".replace("-", "−") for v in lever_arm]
    for each in window.findChildren(NumberField):
        each.interpretText()
    assert window.document.project is project
    assert window.adjust.settings() == project.settings
    assert not window.document.is_modified

    angles = window.results.angles
    assert estimated.result is not None
    for column, value in enumerate(np.degrees(estimated.result.boresight)):
        shown = float(angles.item(1, column).text().replace("−", "-"))
        assert shown == pytest.approx(value / MRAD, abs=6e-4)
    fit = window.results.findChild(object, "result_rms").text()
    assert f"{estimated.result.rms_after / FOOT:.4f} ft" in fit.replace("\u00a0", " ")

    for page in window.diagnostics.findChildren(object):
        if hasattr(page, "as_text"):
            head = page.as_text().split("\n")[0]
            assert "(mm)" not in head
            assert "°" not in head

    arm[0].setFocus()
    arm[0].selectAll()
    qtbot.keyClicks(arm[0], "1")
    qtbot.keyClick(arm[0], Qt.Key.Key_Tab)
    lever_arm_shown = window.document.project.settings.lever_arm
    assert lever_arm_shown == (pytest.approx(FOOT, abs=1e-12), *lever_arm[1:])


def test_no_placeholder_of_the_adjustment_is_in_metric_units(program: Session) -> None:
    for each in program.window.adjust.findChildren(QLineEdit):
        assert "mm" not in each.placeholderText()
        assert "°" not in each.placeholderText()


def test_a_distance_is_measured_in_feet(imperial: None) -> None:
    words = distance_text(np.zeros(3), np.array([3.0, 0.0, -4.0]))
    words = words.replace("\u00a0", " ")
    assert words.split("\n")[0] == f"Slope distance {5 / FOOT:.3f} ft"
    assert words.split("\n")[2] == f"Vertical −{4 / FOOT:.3f} ft"
    assert words.endswith("°")  # azimuths are always in degrees


def test_the_scale_bar_is_round_in_feet_and_metric_in_files(imperial: None) -> None:
    assert length_text(scale_bar_length(0.01, 150)) == "2 ft"
    with units.standard_units():
        assert length_text(scale_bar_length(0.01, 150)) == "1 m"
    assert length_text(scale_bar_length(0.01, 150)) == "2 ft"


@LONG
def test_comparisons_are_in_feet_and_copied_in_millimetres(
    driver: Driver, demo: Demo, estimated: Project, imperial: None
) -> None:
    from lispac.workflow.checking.validation import validate

    validated = validate(estimated, demo.survey)
    driver.window.document.open(validated, demo.survey)
    dock = show_panel(driver.window, "Histograms")
    panel, first = driver.window.histograms, validated.validation[0]

    def has_legend() -> bool:
        """Whether the plot has got the height at which it has a legend, and is drawn."""
        driver.window.resizeDocks([dock], [400], Qt.Orientation.Vertical)
        finish_layouts()
        driver.rest()
        return bool(panel.canvas.figure.legends)

    driver.bot.waitUntil(has_legend)
    assert panel.table.item(0, RMS).text().replace("\u00a0", " ") == (
        f"{first.before.rms / FOOT:.4f} → {first.after.rms / FOOT:.4f}"
    )
    axes = panel.canvas.figure.axes[0]
    assert "(ft)" in axes.get_xlabel()
    ticks = axes.xaxis.get_major_locator()()
    shown = [float(axes.xaxis.get_major_formatter()(tick)) for tick in ticks]
    assert shown == pytest.approx([tick / 1000 / FOOT for tick in ticks], rel=1e-5)
    (legend,) = panel.canvas.figure.legends
    assert f"RMS {first.before.rms / FOOT:.4f}" in legend.get_texts()[0].get_text()
    assert histogram_text(first, 0.1, 10).startswith("From (mm)\tTo (mm)")


@LONG
def test_another_unit_rebuilds_the_window(program: Session, qtbot: QtBot, demo: Demo) -> None:
    former = program.window
    former.document.open(demo.picked, demo.survey)
    project = former.document.project
    former.settings.units = ("minutes", "survey feet")
    former.rebuild_window()
    qtbot.waitUntil(lambda: program.window is not former, timeout=SOON_MS)
    assert program.window.document.project is project
    assert program.window.data.lever_arm.fields[0].suffix() == " ftUS"
    assert program.window.data.boresight.fields[0].suffix() == " ′"


def test_a_measurement_is_metric_in_a_saved_picture(opened: Driver, imperial: None) -> None:
    measuring = opened.window.findChild(Measurements)
    opened.window.actions_["measure_distance"].trigger()
    for place in ((0.0, 0.0, 0.0), (3.0, 0.0, -4.0)):
        measuring._add_point(PickedPoint(opened.project.lines[0].name, place))
    sketch = opened.viewport.sketches["measure"]
    assert label_text(sketch).startswith(f"Slope distance {5 / FOOT:.3f}\u00a0ft")
    with units.standard_units():
        assert label_text(sketch).startswith("Slope distance 5.000\u00a0m")


def test_the_colour_scale_is_in_feet_and_metric_in_files(
    demo: Demo, estimated: Project, imperial: None
) -> None:
    clouds = demo.survey.placed(estimated, "estimated")
    reach = 0.0256
    in_feet, _ = residual_shading(estimated, demo.survey, clouds, colour_limit=reach)
    end = f"{reach / FOOT:.3f}"
    assert legend_texts(in_feet) == (
        "Residual (ft), positive: nearer to the vessel",
        f"−{end}",
        f"+{end}",
    )
    heights, seconds = point_shading("height", clouds), point_shading("time", clouds)
    assert heights is not None
    assert seconds is not None
    ups = np.concatenate([cloud.sample[:, 2] for cloud in clouds.values()])
    title, low, high = legend_texts(heights)
    assert title == "Height (ft)"
    assert (float(low), float(high)) == pytest.approx(np.percentile(ups, [2, 98]) / FOOT, abs=0.5)
    with units.standard_units():
        assert legend_texts(in_feet)[1:] == ("−26", "+26")
        low, high = legend_texts(heights)[1:]
        assert (float(low), float(high)) == pytest.approx(np.percentile(ups, [2, 98]), abs=0.5)
    assert legend_texts(seconds) == (seconds.title, seconds.low, seconds.high)


def test_a_window_in_feet_has_no_metric_texts(
    program: Session, demo: Demo, estimated: Project, qtbot: QtBot
) -> None:
    from lispac.workflow.checking.validation import validate

    window = program.window
    window.document.open(validate(estimated, demo.survey), demo.survey)
    for title in (*window.docks, *window.panel_windows):
        show_panel(window, title)
    window.scene.select("T1")
    show_panel(window, "Section")
    for page in range(window.diagnostics.list.count()):
        window.diagnostics.list.setCurrentRow(page)
    panel = window.tools.sections.panel
    qtbot.waitUntil(lambda: panel.has_section and not window.runner.active, timeout=SOON_MS)
    for system in range(window.panels["convention"].system.count()):
        window.panels["convention"].system.setCurrentIndex(system)
    window.actions_["design"].trigger()
    design = window.site_design.window
    for tabs in (design.tabs, design.views):
        for page in range(tabs.count()):
            tabs.setCurrentIndex(page)
    wait_for_plan(design)
    assert window.isAncestorOf(design) or design.parent() is window
    known = re.compile("|".join(ALWAYS_METRIC))
    metric_by_name = {
        name: {t for t in texts if not known.search(t)}
        for name, texts in metric_words(window).items()
    }
    assert {name: texts for name, texts in metric_by_name.items() if texts} == {}
    assert design.close()
    assert window.site_design.leave()


@pytest.mark.parametrize(
    ("text", "metric"),
    [
        ("12.5 m", True), ("Noise (mm)", True), ("Height, m", True), ("3 cm wide", True),
        ("in metres", True), ("0.061\u00a0m to port", True), ("points per m²", False),
        ("(m/s)", True), ("L1_000", False), ("5 min", False), ("12.5 ft", False),
        ("2 mrad", False), ("Bow up", False), ("m", False),
    ],
)  # fmt: skip
def test_metric_texts_are_recognised(text: str, metric: bool) -> None:
    assert bool(METRIC.search(text)) is metric
