"""Tests that window, report and command line agree in words, units and limits."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.diagnostics.excess_scatter import with_raised_sigmas
from lispac.adjustment.diagnostics.findings import critical_test_value, variance_component_finding
from lispac.adjustment.model.parameters import OUTPUT_UNITS, PARAMETER_DISPLAYS, ParameterEstimate
from lispac.adjustment.result import (
    SIGMA_GROUPS,
    AdjustmentResult,
    CrossChecks,
    SigmaGroup,
    VarianceComponent,
)
from lispac.cli.calibration.result_output import adjustment_output, print_result
from lispac.gui.appearance import units
from lispac.gui.features.estimate import result_texts
from lispac.gui.features.estimate.adjust_parameters import MOUNTING_PARAMETERS
from lispac.gui.features.estimate.result_texts import variance_component_texts
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import LANGUAGES, gettext, in_language, number
from lispac.message_texts import english_text
from lispac.messages import note
from lispac.present.calibration.cross_checks import cross_check_values, subset_rows
from lispac.present.calibration.parameters import PARAMETERS_TABLE, parameter_values
from lispac.present.json_values import json_values
from lispac.present.tables import Format
from lispac.present.targets.sightings import LARGEST_W_COLUMN, SIGHTINGS_TABLE, sighting_values
from lispac.present.targets.targets import target_finding, target_values
from lispac.present.text_format import (
    fixed_number,
    grouped_number,
    quantity_text,
    shortest_number,
)
from lispac.report.document import report_document
from lispac.report.document_blocks import Table
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project

Sample = tuple[AdjustmentResult, CrossChecks]


@pytest.fixture
def sample(tmp_path: Path) -> Sample:
    project = sample_project(tmp_path)
    assert project.result is not None
    assert project.cross_checks is not None
    return project.result, project.cross_checks


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("lever_y", 0.0376581, "+0.0377 m"),
        ("range_offset", -0.02, "-0.0200 m"),
        ("scan_angle_offset", np.radians(0.12345), "+0.1235 deg"),
        ("latency", 0.0021, "+2.10 ms"),
    ],
)
def test_a_value_is_shown_equally_everywhere(
    capsys: pytest.CaptureFixture[str], sample: Sample, name: str, value: float, words: str
) -> None:
    result = replace(sample[0], parameters=(ParameterEstimate(name, 0.0, None, value, 0.1, 3.0),))
    print_result(result, None)
    printed = capsys.readouterr().out.splitlines()
    (row,) = [line for line in printed if line.startswith(f"  {PARAMETER_DISPLAYS[name].title} ")]
    assert f"  {words}  " in row
    printed = words.replace("-", "−")
    in_window = printed.replace(" deg", "°").replace(" ", "\u00a0")
    assert MOUNTING_PARAMETERS[name].amount(value) == in_window
    shown_text = quantity_text(name, value * OUTPUT_UNITS[name][0], sign=True)
    assert shown_text == in_window


def test_two_surface_sigmas_are_shown_where_there_are_two(sample: Sample, tmp_path: Path) -> None:
    project = sample_project(tmp_path / "report")
    assert project.result is not None
    for offset, words in (
        (None, "0.4\u00a0mm"),
        (0.0032, "offsets 3.2\u00a0mm, tilts 0.4\u00a0mm"),
    ):
        result = replace(project.result, offset=offset)
        assert result_texts.form_error_text(result) == words
        values = json_values(adjustment_output(result, None))
        assert (values["surface_sigma_m"], values["offset_sigma_m"]) == (0.0004, offset)
        content = sample_content(replace(project, result=result))
        assert content.settings.offset_sigma_m == offset
        blocks = [
            block for s in report_document(content, {}, FULL_REPORT).sections for block in s.blocks
        ]
        cells = [cell for b in blocks if b.kind == "table" for row in b.rows for cell in row]
        assert any(str(cell).startswith(f"{words}, estimated from the data") for cell in cells)


def test_json_keeps_metres_degrees_and_seconds(sample: Sample) -> None:
    latency = ParameterEstimate("latency", 0.0, None, 0.0021, 0.0001, 21.0)
    output = adjustment_output(replace(sample[0], parameters=(latency,)), None)
    values = json_values(output.parameters[0])
    assert (values["unit"], values["value"], values["sigma"]) == ("s", 0.0021, 0.0001)


def test_sightings_that_disagree_in_the_report_are_marked(sample: Sample) -> None:
    result = sample[0]
    critical = critical_test_value(result)
    assert critical is not None
    assert critical > 3.1
    first, second, *rest = result.reliability
    near = replace(first, w=critical - 0.01, rejected=False, outliers=0)
    beyond = replace(second, w=-critical - 0.01, rejected=False, outliers=0)
    values = sighting_values(replace(result, reliability=(near, beyond, *rest)))
    assert [each.status for each in values[:2]] == ["agrees", "disagrees"]
    rows = window_rows(SIGHTINGS_TABLE, values, marked=lambda row: row.is_marked)
    assert [row.marked for row in rows[:2]] == [False, True]
    assert [row.cells[2].text for row in rows[:2]] == ["agrees", "disagrees"]
    assert all(len(row.cells) == len(window_columns(SIGHTINGS_TABLE)) for row in rows)


def test_halves_are_reported_once(capsys: pytest.CaptureFixture[str], sample: Sample) -> None:
    result, checks = sample
    odd = tuple(
        replace(part, significance=np.array([9.0, 0.0, 0.0])) if part.kind == "half" else part
        for part in checks.parts
    )
    checks = replace(checks, parts=odd)
    print_result(result, checks)
    printed = capsys.readouterr().out
    assert printed.count("half") == 1
    assert "second minus first half of the data (roll " in printed
    names = [row.name for row in subset_rows(cross_check_values(checks))]
    assert [name for name in names if "half" in name] == ["Second minus first half"]


def test_only_the_stated_sigma_is_given_beside_the_note_that_it_was_raised(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    project = sample_project(tmp_path)
    assert project.result is not None
    formal = f"{np.degrees(project.result.sigma[1]):.4f}"
    raised = with_raised_sigmas(project.result, np.array([1.0, 3.7, 1.0]))
    project = replace(project, result=raised)
    print_result(raised, project.cross_checks)
    assert capsys.readouterr().out.count(formal) == 1
    document = report_document(sample_content(project), {}, FULL_REPORT)
    cells = [
        cell
        for section in document.sections
        for block in section.blocks
        if isinstance(block, Table)
        for row in block.rows
        for cell in row
    ]
    assert f"{np.degrees(raised.sigma[1]):.4f}" in cells
    assert formal not in cells


def test_halves_are_compared_only_if_both_have_a_result(sample: Sample) -> None:
    checks = sample[1]
    first, second = (part for part in checks.parts if part.kind == "half")
    lone = replace(
        second, boresight=None, difference=None, reason=note("cross_check.no_common_target")
    )
    for halves, names in (
        ((first, lone), ["First half of the lines only", "Second half of the lines only"]),
        ((), []),
    ):
        rows = subset_rows(cross_check_values(replace(checks, parts=halves)))
        assert [row.name for row in rows] == names


def test_singular_and_plural_are_correct(
    capsys: pytest.CaptureFixture[str], sample: Sample
) -> None:
    result = sample[0]
    one = replace(
        result, targets=result.targets[:1], sightings=result.sightings[:1],
        reliability=result.reliability[:1], excluded_outliers=1,
    )  # fmt: skip
    print_result(one, None)
    printed = capsys.readouterr().out
    assert "; 1 outlier excluded from the averages\n" in printed


@pytest.mark.parametrize(
    ("component", "assumed", "code"),
    [
        # Increased by the data, although the given sigma is within the interval
        (VarianceComponent("POS position", 2.4, 0.9, 7.2, applied=True), (), "component.larger"),
        (VarianceComponent("POS attitude", 2.4, 0.2, 29.0, applied=True), (), "component.larger"),
        (VarianceComponent("LiDAR", 0.5, 0.4, 0.6, applied=True), (), "component.smaller"),
        (VarianceComponent("LiDAR", 1.0, 0.01, 100.0), (), "component.not_determined"),
        (VarianceComponent("LiDAR", 0.9, 0.7, 1.2), (), "component.as_given"),
        (VarianceComponent("LiDAR", 1.04, 1.01, 1.07), (), "component.too_small"),
        (
            VarianceComponent("LiDAR", 0.4, 0.38, 0.42, applied=True),
            SIGMA_GROUPS,
            "component.replaces_assumed",
        ),
        (VarianceComponent("LiDAR", 1.0, 0.97, 1.03), SIGMA_GROUPS, "component.confirms_assumed"),
        (
            VarianceComponent("POS attitude", 1.0, 0.01, 100.0, is_determined=False),
            SIGMA_GROUPS,
            "component.not_determined",
        ),
    ],
)
def test_a_variance_component_is_reported_equally_everywhere(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    component: VarianceComponent,
    assumed: tuple[SigmaGroup, ...],
    code: str,
) -> None:
    project = sample_project(tmp_path)
    assert project.result is not None
    result = replace(project.result, components=(component,), assumed_sigmas=assumed)
    finding = variance_component_finding(component, is_assumed=bool(assumed))
    assert finding == note(code)
    print_result(result, None)
    assert f"  {english_text(finding)}\n" in capsys.readouterr().out
    (shown,) = variance_component_texts(replace(project, result=result), result)
    assert shown.endswith(english_text(finding))
    content = sample_content(replace(project, result=result))
    assert content.adjustment is not None
    (reported,) = content.adjustment.components
    assert reported.applied == component.applied
    assert reported.text == finding
    tables = [
        b
        for s in report_document(content, {}, FULL_REPORT).sections
        for b in s.blocks
        if b.kind == "table"
    ]
    (row,) = [row for table in tables for row in table.rows if english_text(finding) in row]
    assert all(cell in shown for cell in row)


@pytest.mark.parametrize(
    ("units", "significant"), [(1.95, False), (-1.97, True), (2.5, True), (3.1, True)]
)
def test_the_limit_of_significance_is_the_same_everywhere(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, units: float, significant: bool
) -> None:
    project = sample_project(tmp_path)
    assert project.result is not None
    estimate = ParameterEstimate("lever_x", 0.0, None, 0.1, 0.05, units)
    result = replace(project.result, parameters=(estimate,))
    words = "significant" if significant else "not significant"
    assert estimate.significant is significant
    print_result(result, None)
    assert f"  {words}\n" in capsys.readouterr().out
    assert adjustment_output(result, None).parameters[0].significant is significant
    (row,) = window_rows(PARAMETERS_TABLE, parameter_values(result))
    assert row.cells[-1].text == words
    assert f"prior 0.0000\u00a0m, {words}<" in result_texts.parameters_html(result)
    content = sample_content(replace(project, result=result))
    assert content.adjustment is not None
    assert content.adjustment.parameters[0].significant is significant


def test_a_value_without_a_number_has_no_significance() -> None:
    assert (
        ParameterEstimate("lever_z", 0.0, None, reason=note("parameter.kept")).significant is None
    )


def test_the_point_with_the_largest_residual_has_its_time_everywhere(
    sample: Sample, tmp_path: Path
) -> None:
    result = sample[0]
    first, second, *rest = result.reliability
    far = replace(first, largest_w=12.34, largest_at=416012.5)
    old = replace(second, largest_at=None)  # a result of an earlier version
    result = replace(result, reliability=(far, old, *rest))
    sightings = json_values(adjustment_output(result, None))["sightings"]
    assert (sightings[0]["largest_w"], sightings[0]["largest_w_time_s"]) == (12.34, 416012.5)
    assert sightings[1]["largest_w_time_s"] is None
    place = [column.title for column in SIGHTINGS_TABLE.columns].index(LARGEST_W_COLUMN.title)
    cells = [
        row.cells[place : place + 2]
        for row in window_rows(SIGHTINGS_TABLE, sighting_values(result))
    ]
    assert [(cell.text, cell.value) for cell in cells[0]] == [
        ("12.3", 12.34),
        ("416012.500", 416012.5),
    ]
    assert [cell.text for cell in cells[1]] == ["2.9", "\u2013"]
    content = sample_content(replace(sample_project(tmp_path / "report"), result=result))
    tables = [
        b
        for s in report_document(content, {}, FULL_REPORT).sections
        for b in s.blocks
        if b.kind == "table"
    ]
    (points,) = [table for table in tables if table.title == "Tests of single points"]
    assert points.rows[0][-2:] == ("12.3", "416012.500")
    assert points.rows[1][-2:] == ("2.9", "\u2013")


@pytest.mark.parametrize("value", [-0.0, -4e-5, -1e-12, 4e-5])
@pytest.mark.parametrize("sign", [False, True])
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_number_that_rounds_to_zero_has_no_sign(value: float, sign: bool, language: str) -> None:
    form = Format("m", 4, is_signed=sign)
    plus = "+" if sign else ""
    with in_language(language):
        texts = {
            number(0.0, 4, sign=sign), number(value, 4, sign=sign),
            fixed_number(value, 4, sign=sign), form.text(value),
            units.local_figure(value, "m", f"{plus}.4f"),
            gettext("{value:x.4+}" if sign else "{value:x.4}", value=value),
        }  # fmt: skip
        assert len(texts) == 1
        (text,) = texts
        assert text.strip("0.,") == ""
        assert form.plain_text(value) == "0.0000"
        assert grouped_number(value, 4).strip("0.,") == ""
    assert units.figure(value, "m", f"{plus}.4f") == "0.0000"
    assert shortest_number(-0.0) == "0"


@pytest.mark.parametrize(
    ("before", "after", "has_finding"), [(0.0031, 0.0166, True), (0.0031, 0.0033, False)]
)
def test_a_target_that_the_calibration_makes_worse_is_pointed_out(
    sample: Sample, before: float, after: float, has_finding: bool
) -> None:
    (first, *others) = sample[0].targets
    first = replace(first, rms_before=before, rms_after=after, noise=1.0)
    result = replace(sample[0], targets=(first, *others), sightings=())
    (values, *_) = target_values(result)
    assert bool(target_finding(values)) == has_finding
