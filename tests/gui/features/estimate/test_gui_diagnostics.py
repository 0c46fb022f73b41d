"""Tests of the diagnostics: each page, its empty state, and the points shown for a row."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QPushButton, QTableWidget

from lispac.adjustment.result import CrossCheck
from lispac.design.further_line_advice import further_line_advice
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.estimate.diagnostics_pages import PAGE_CLASSES, SightingsPage
from lispac.gui.viewport.base import SELECTED_HALO_PIXELS, dimmed_colour
from lispac.language import gettext
from lispac.messages import note
from lispac.present.calibration.cross_checks import cross_check_values, subset_rows
from lispac.present.targets.sightings import has_undetermined_pos_errors, sighting_values
from lispac.project import Project
from tests.gui.support import (
    WAIT_MS,
    Control,
    Demo,
    Driver,
    Key,
    Left,
    click,
    click_check,
    double_click,
    show_panel,
    wait_until_idle,
)
from tests.support.long_runs import LONG, others_long


@pytest.fixture
def shown(driver: Driver, demo: Demo, estimated: Project) -> Driver:
    """The estimated demo survey with the diagnostics in front."""
    driver.window.document.open(estimated, demo.survey)
    show_panel(driver.window, "Diagnostics")
    driver.rest()
    assert driver.window.diagnostics.isVisible()
    return driver


def turn_to(driver: Driver, title: str):
    """Click a page in the list."""
    pages = driver.window.diagnostics.list
    item = next(pages.item(k) for k in range(pages.count()) if pages.item(k).text() == title)
    driver.bot.mouseClick(pages.viewport(), Left, pos=pages.visualItemRect(item).center())
    page = driver.window.diagnostics.current
    assert page.title == title
    assert page.isVisible()
    return page


def test_rms_and_shift_are_explained_above_the_table(
    shown: Driver, demo: Demo, estimated: Project
) -> None:
    page = turn_to(shown, "Sightings")
    explanation, table = page.explanation_label, page.table
    assert explanation.isVisible()
    assert explanation.text() == gettext(SightingsPage.explanation)
    bottom = explanation.mapTo(page, explanation.rect().bottomLeft()).y()
    assert bottom < table.mapTo(page, QPoint()).y()
    heads = [table.horizontalHeaderItem(k) for k in range(table.columnCount())]
    tips = {head.text().replace("\n", " ").split(" (")[0]: head.toolTip() for head in heads}
    assert "Shift" in tips["RMS before"]
    assert "Shift" in tips["RMS after"]
    assert "RMS" in tips["Shift"]
    assert not turn_to(shown, "Targets").explanation_label.isVisible()
    assert estimated.result is not None
    thesis = replace(
        estimated.result,
        model=replace(estimated.result.model, pos_errors="independent"), reliability=(),
    )  # fmt: skip
    shown.window.document.open(replace(estimated, result=thesis), demo.survey)
    shown.rest()
    page = turn_to(shown, "Sightings")
    assert page.table.isVisible()
    assert not page.explanation_label.isVisible()


def test_the_results_lead_to_the_cross_checks(shown: Driver) -> None:
    turn_to(shown, "Sightings")
    show_panel(shown.window, "Results")
    link = shown.window.results.findChild(QPushButton, "result_checks")
    rows = len(subset_rows(cross_check_values(shown.project.cross_checks)))
    assert f" of {rows} " in link.text()
    click(shown, link)
    shown.rest()
    assert shown.window.diagnostics.current.title == "Cross-checks"
    assert shown.window.diagnostics.isVisible()


def column(table: QTableWidget, title: str) -> int:
    count = table.columnCount()
    heads = [table.horizontalHeaderItem(k).text().replace("\n", " ") for k in range(count)]
    return heads.index(title)


def texts(table: QTableWidget, title: str) -> list[str]:
    k = column(table, title)
    return [table.item(row, k).text() for row in range(table.rowCount())]


def test_every_page_without_a_result_shows_what_to_do(picked: Driver):
    show_panel(picked.window, "Diagnostics")
    for kind in PAGE_CLASSES:
        page = turn_to(picked, kind.title)
        assert page.advice == kind.empty_text
        assert page.advice.startswith("Nothing estimated yet. Press Estimate in step 3 to see ")
        assert getattr(page, "canvas", None) is None


def test_no_figure_is_made_before_its_page_is_opened(shown: Driver):
    figures = [kind.title for kind in PAGE_CLASSES if hasattr(kind, "draw_function")]
    assert len(figures) == 4
    for k, title in enumerate(figures):
        panel = shown.window.diagnostics
        made = [name for name in figures if panel.pages[name].canvas is not None]
        assert made == figures[:k]
        turn_to(shown, title)
        assert panel.pages[title].canvas is not None


def test_the_figures_show_the_result(shown: Driver, estimated: Project):
    result = estimated.result
    (axes,) = turn_to(shown, "Convergence").canvas.figure.axes
    assert axes.get_yscale() == "log"
    roll = axes.lines[0].get_ydata()
    away = np.degrees(np.abs([result.prior_boresight[0], result.path[0, 0]] - result.boresight[0]))
    assert list(roll[:2]) == pytest.approx(list(away))
    assert list(axes.lines[0].get_xdata()[:2]) == [0, 1]
    heat = turn_to(shown, "Correlations").canvas.figure.axes[0]
    assert (heat.images[0].get_array() == result.correlation_all).all()
    numbers = [text.get_text() for text in heat.texts]
    assert numbers[1] == f"{result.correlation_all[0, 1]:+.2f}".replace("-", "−")
    assert [t.get_text() for t in heat.get_xticklabels()] == ["Roll", "Pitch", "Yaw"]
    panels = turn_to(shown, "POS error").canvas.figure.axes
    titles = ["East", "North", "Up", "Roll", "Pitch", "Heading"]
    assert [axes.get_title() for axes in panels] == titles
    assert [axes.get_xlabel() for axes in panels] == ["mm"] * 3 + ["0.001°"] * 3
    item = result.reliability[0]
    is_determined = item.pos_sigma_after < 0.995 * item.pos_sigma
    assert any(is_determined[:2])
    for k, place, scale in ((0, 1, -1000), (1, 0, 1000), (5, 5, np.degrees(1000))):
        drawn = [x for line in panels[k].lines for x in np.asarray(line.get_xdata())]
        error = item.pos_error[place] * scale
        assert any(x == pytest.approx(error) for x in drawn) == is_determined[place]
        band, half = panels[k].patches[0], 2 * item.pos_sigma[place] * abs(scale)
        assert band.get_x() == pytest.approx(-half)
        assert band.get_width() == pytest.approx(2 * half)
    page = turn_to(shown, "POS error")
    has_gap = any(
        (each.pos_sigma_after >= 0.995 * each.pos_sigma).any() for each in result.reliability
    )
    assert page.undetermined.isVisible() == has_gap
    assert page.undetermined.text().startswith("A component without a value or a point is not")
    sightings = sighting_values(result)
    known = replace(
        sightings[0].pos_error, sigma_after_m=(0.0, 0.0, 0.0), sigma_after_deg=(0.0, 0.0, 0.0)
    )
    determined = [replace(each, pos_error=known) for each in sightings]
    assert has_undetermined_pos_errors(sightings) == has_gap
    assert not has_undetermined_pos_errors(determined)
    words = turn_to(shown, "Observability").text_label.text()
    for message in result.observability.messages:
        assert message_text(message) in words
    assert f"Condition number {result.observability.condition:.1f}" in words


def test_the_first_columns_of_the_tables_fit_in_the_window(shown: Driver) -> None:
    window = shown.window.panel_windows["Diagnostics"]
    assert window.width() <= 1366 - 24
    assert window.height() <= 480
    for page, title in (
        ("Sightings", "Finding"),
        ("Sightings", "Outliers"),
        ("Targets", "Outliers"),
    ):
        table = turn_to(shown, page).table
        header, k = table.horizontalHeader(), column(table, title)
        end = header.sectionViewportPosition(k) + header.sectionSize(k)
        assert end <= table.viewport().width()
        needed = max(header.sectionSizeHint(k), table.sizeHintForColumn(k))
        assert header.sectionSize(k) <= needed + 20, "not stretched"


def presented_w(project: Project) -> list[float]:
    """Test values of the sightings, positive if nearer to the vessel."""
    sides = {each.target: each.vessel_side for each in project.result.targets}
    return [-sides[each.sighting.target] * each.w for each in project.result.reliability]


def test_the_tables_show_the_result(shown: Driver, estimated: Project):
    result, checks = estimated.result, estimated.cross_checks
    table = turn_to(shown, "Sightings").table
    assert texts(table, "RMS after (mm)") == [f"{s.rms_after * 1000:.1f}" for s in result.sightings]
    assert texts(table, "Incidence (°)") == [
        f"{np.degrees(s.incidence):.0f}" for s in result.sightings
    ]
    assert texts(table, "w") == [f"{w:+.2f}".replace("-", "−") for w in presented_w(estimated)]
    table = turn_to(shown, "Targets").table
    assert texts(table, "Target") == ["T1", "T2"]
    assert texts(table, "Noise factor") == [f"{t.noise:.2f}" for t in result.targets]
    page = turn_to(shown, "Cross-checks")
    assert page.table.rowCount() == 6 + 2 + 1
    first = next(check for check in checks.parts if check.difference is not None)
    row = checks.parts.index(first)
    difference = f"{np.degrees(first.difference[2]):+.4f}".replace("-", "−")
    assert texts(page.table, "Yaw difference (°)")[row] == difference
    table = turn_to(shown, "Parameters").table
    assert texts(table, "Parameter") == ["Roll", "Pitch", "Yaw"]


def test_all_angles_of_the_cross_checks_are_visible_in_a_small_window(shown: Driver):
    shown.window.resize(1366, 768)
    page = turn_to(shown, "Cross-checks")
    head = page.table.horizontalHeader()
    yaw = column(page.table, "Yaw difference (°)")
    shown.bot.waitUntil(lambda: page.table.viewport().width() > 300)
    right = head.sectionViewportPosition(yaw) + head.sectionSize(yaw)
    assert right <= page.table.viewport().width()


def test_a_heading_sorts_by_value(shown: Driver, estimated: Project):
    table = turn_to(shown, "Sightings").table
    head, place = table.horizontalHeader(), column(table, "w")
    at = QPoint(head.sectionViewportPosition(place) + 8, head.height() // 2)
    values = sorted(presented_w(estimated))
    assert values != presented_w(estimated)
    shown.bot.mouseClick(head.viewport(), Left, pos=at)
    assert texts(table, "w") == [f"{v:+.2f}".replace("-", "−") for v in values]


def test_a_row_shows_its_points_by_mouse_and_by_key(shown: Driver, estimated: Project):
    table = turn_to(shown, "Sightings").table
    double_click(shown, table, 2)
    sighting = estimated.result.sightings[2].sighting
    assert shown.viewport.selected == (sighting.target, sighting.line)
    drawn = shown.viewport.highlight_styles
    colours = shown.viewport.colours
    chosen = drawn.pop((sighting.target, sighting.line))
    assert (chosen.colour, chosen.halo_pixels) == (colours[sighting.line], SELECTED_HALO_PIXELS)
    others = {line: drawn[name, line] for name, line in drawn if name == sighting.target}
    assert len(others) > 1
    for line, style in others.items():
        assert (style.colour, style.halo_pixels) == (dimmed_colour(colours[line]), 0)
    name, (points,) = shown.viewport.calls[-1]
    assert name == "fit"
    assert len(points) == len(estimated.target(sighting.target).sighting(sighting.line).indices)
    table.setFocus()
    shown.bot.keyClick(table, Key.Key_Down)
    shown.bot.keyClick(table, Key.Key_Return)
    sighting = estimated.result.sightings[3].sighting
    assert shown.viewport.selected == (sighting.target, sighting.line)
    assert shown.window.targets.current == sighting.target
    double_click(shown, turn_to(shown, "Targets").table, 1)
    assert shown.viewport.selected == ("T2", "")


def test_findings_are_marked_with_text_and_colour(shown: Driver, estimated: Project):
    result, checks = estimated.result, estimated.cross_checks
    bad = replace(result.reliability[1], rejected=True, shift=0.05, w=9.0)
    doubtful = replace(result, reliability=(result.reliability[0], bad, *result.reliability[2:]))
    line = bad.sighting.line
    away = np.radians([0.1, 0.0, 0.0])
    odd = CrossCheck("line", line, result.boresight + away, result.sigma, away, away / 1e-4)
    none = CrossCheck("target", "T1", reason=note("cross_check.no_common_target"))
    marked = estimated.with_result(doubtful).with_cross_checks(replace(checks, parts=(odd, none)))
    shown.window.document.edit("estimate", marked)
    table = turn_to(shown, "Sightings").table
    assert texts(table, "Finding")[1] == "rejected"
    assert table.item(1, 0).background().color().name() == theme.WARNING_GROUND
    assert table.item(0, 0).background().color().name() != theme.WARNING_GROUND
    assert texts(turn_to(shown, "Targets").table, "Finding")[0] == f"rejected in {line}"
    table = turn_to(shown, "Cross-checks").table
    assert texts(table, "Finding") == ["disagrees", "no result"]
    assert texts(table, "Reason")[1] == message_text(note("cross_check.no_common_target"))
    assert table.item(0, 0).background().color().name() == theme.WARNING_GROUND
    shown_text = shown.window.results.warnings.text()
    assert f"T1 on line {line} (displaced by " in shown_text
    assert f"without line {line}" in shown_text


@LONG
def test_the_result_of_a_check_box_is_shown_and_then_cross_checked(
    shown: Driver, estimated: Project
):
    table = turn_to(shown, "Sightings").table
    show_panel(shown.window, "Targets by line")
    ticks = shown.window.table
    click_check(shown, ticks, ticks.sightings.index(0, 2))
    assert not table.isEnabled()
    wait_until_idle(shown)
    show_panel(shown.window, "Diagnostics")
    assert table.isEnabled()
    assert table.rowCount() == len(estimated.result.sightings) - 1
    shown.bot.waitUntil(lambda: shown.project.cross_checks is not None, timeout=WAIT_MS)
    assert turn_to(shown, "Cross-checks").advice == ""
    assert len(shown.project.cross_checks.parts) == len(estimated.cross_checks.parts)
    assert shown.project.cross_checks is not estimated.cross_checks
    shown.bot.keyClick(shown.window, Key.Key_Z, Control)
    shown.rest()
    assert turn_to(shown, "Sightings").table.rowCount() == len(estimated.result.sightings)
    assert turn_to(shown, "Cross-checks").advice == ""


@LONG
@pytest.mark.parametrize("checked", others_long([True, False]))
def test_a_further_line_is_searched_after_the_results_of_a_check_box(
    shown: Driver, estimated: Project, monkeypatch: pytest.MonkeyPatch, checked: bool
):
    """The search takes half as long as the adjustment, so the results are shown before it."""
    searched = []

    def advised(observations, result):
        searched.append(shown.project.result is not None)
        return further_line_advice(observations, result)

    def shown_text():
        result = shown.project.result
        return result is not None and result.observability.messages[-1].code.startswith(
            "further_line."
        )

    monkeypatch.setattr("lispac.workflow.calibration.estimation.further_line_advice", advised)
    monkeypatch.setattr(shown.window.estimation, "_cross_check", checked)
    show_panel(shown.window, "Targets by line")
    ticks = shown.window.table
    click_check(shown, ticks, ticks.sightings.index(0, 2))
    shown.bot.waitUntil(shown_text, timeout=WAIT_MS)
    assert searched == [True]
    assert shown.window.scene.has_estimated
    shown.rest()
    assert (shown.project.cross_checks is not None) == checked
    assert searched == [True]


def test_the_classical_model_names_the_diagnostics_it_does_not_compute(
    shown: Driver, estimated: Project
):
    result = estimated.result
    thesis = replace(result, model=replace(result.model, pos_errors="independent"), reliability=())
    shown.window.document.edit("estimate", estimated.with_result(thesis))
    assert turn_to(shown, "POS error").advice.startswith("Not available with uncorrelated")
    assert set(texts(turn_to(shown, "Sightings").table, "Finding")) == {"not tested"}


def test_columns_fit_their_texts_after_a_table_is_filled_again(shown: Driver) -> None:
    table = turn_to(shown, "Sightings").table
    rows = list(table._rows)
    wide = [
        replace(row, cells=[replace(row.cells[0], text="W" * 60), *row.cells[1:]]) for row in rows
    ]
    before = table.columnWidth(0)
    table.show_rows(wide)
    assert table.columnWidth(0) > before + 200
    table.show_rows(rows)
    assert table.columnWidth(0) == before


def test_the_numbers_of_the_contributions_are_inside_their_bars(shown: Driver) -> None:
    canvas = turn_to(shown, "Observability").canvas
    canvas.draw()
    (axes,) = canvas.figure.axes
    bars = [bar.get_window_extent() for bar in axes.patches]
    assert axes.texts
    for text in axes.texts:
        box = text.get_window_extent()
        assert any(
            bar.x0 <= box.x0 and box.x1 <= bar.x1 and bar.y0 <= box.y0 and box.y1 <= bar.y1
            for bar in bars
        ), text.get_text()
    (legend,) = canvas.figure.legends
    assert [each.get_text() for each in legend.get_texts()] == ["Roll", "Pitch", "Yaw"]
