"""Tests of the section of the report on surveyed control."""

import json
from pathlib import Path

import pytest

from lispac.report.content import ReportContent
from lispac.report.document import undrawn_document
from lispac.report.document_blocks import Table
from lispac.report.html import html_text
from lispac.report.json_report import write_json
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from tests.support.control_sample import SOURCE, with_control
from tests.support.message_codes import codes
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project


@pytest.fixture
def content(tmp_path: Path) -> ReportContent:
    return sample_content(with_control(sample_project(tmp_path / "harbour"), w=9.0))


def tables(content: ReportContent, options: ReportOptions) -> dict[str, Table]:
    document = undrawn_document(content, {}, options)
    blocks = [*document.summary, *(b for s in document.sections for b in s.blocks)]
    return {block.title: block for block in blocks if isinstance(block, Table)}


def test_the_full_report_shows_residuals_and_both_estimates(content: ReportContent) -> None:
    found = tables(content, FULL_REPORT)
    points = found["Surveyed control"]
    assert [row[0] for row in points.plain_rows] == ["C1", "C2", "C3"]
    assert points.plain_rows[1][5] == "+2.2"
    both = found["Estimates with and without the control"]
    assert [row[0] for row in both.plain_rows][:3] == ["Roll", "Pitch", "Yaw"]
    assert both.plain_rows[3][3] == "not determined"
    assert found["Files of the control"].plain_rows[0][0] == SOURCE
    page = html_text(content, {}, FULL_REPORT)
    assert "contradicts the survey" in page


def test_the_short_report_shows_both_estimates(content: ReportContent) -> None:
    found = tables(content, DEFAULT_OPTIONS)
    assert "Estimates with and without the control" in found
    assert "Surveyed control" not in found


def test_a_report_without_control_has_no_section(tmp_path: Path) -> None:
    plain = sample_content(sample_project(tmp_path / "harbour"))
    titles = [section.title for section in undrawn_document(plain, {}, FULL_REPORT).sections]
    assert "Surveyed control" not in titles


def test_json_and_warnings_contain_the_control(content: ReportContent, tmp_path: Path) -> None:
    path = tmp_path / "report.json"
    write_json(content, path)
    control = json.loads(path.read_text(encoding="utf-8"))["control"]
    assert [each["contradicts"] for each in control["points"]] == [False, True, None]
    assert control["points"][2]["reason"]["code"] == "control.beside_targets"
    assert control["files"][0]["common_sigma_m"] == 0.002
    assert [each.role for each in content.files].count("Control") == 1
    assert "adjustment.control_contradicts" in codes(content.warnings)


def test_a_translation_is_reported_instead_of_its_points(tmp_path: Path) -> None:
    project = with_control(sample_project(tmp_path / "h"), w=9.0, translation=(0.01, 0.02, 0.3))
    found = codes(sample_content(project).warnings)
    assert "adjustment.control_translated" in found
    assert "adjustment.control_contradicts" not in found
