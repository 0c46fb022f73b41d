"""Tests of the sections across validation planes in the report."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.project import Project
from lispac.report.document import undrawn_document
from lispac.report.options import ReportOptions
from lispac.report.plane_sections import section_figure_of
from lispac.report.report_values import ReportContent
from lispac.report.short_report import MAX_PICTURED_PLANES
from tests.support.report_sample import sample_content, sample_project, undrawn_pictures


@pytest.fixture
def content(tmp_path: Path) -> ReportContent:
    return sample_content(sample_project(tmp_path))


def _sectioned_planes(content: ReportContent) -> list[str]:
    sections = undrawn_document(content, {}, ReportOptions()).sections
    return [
        each.values[0].plane  # type: ignore[attr-defined]
        for section in sections
        for each in undrawn_pictures(section.blocks)
        if each.draw is section_figure_of
    ]


def test_the_planes_that_fail_or_have_the_largest_rms_have_a_section(
    content: ReportContent,
) -> None:
    assert _sectioned_planes(content) == [plane.name for plane in content.validation]
    first, plane = content.plane_sections[0], content.validation[0]
    many = replace(
        content,
        validation=tuple(
            replace(plane, name=f"V{k}", after=replace(plane.after, rms_m=0.001 * k))
            for k in range(1, 8)
        ),
        plane_sections=tuple(replace(first, plane=f"V{k}") for k in range(1, 8)),
    )
    assert _sectioned_planes(many) == ["V5", "V6", "V7"]
    assert len(_sectioned_planes(many)) == MAX_PICTURED_PLANES
    assert _sectioned_planes(replace(content, plane_sections=())) == []


def test_a_section_is_drawn_before_and_after_with_the_colours_of_the_lines(
    content: ReportContent,
) -> None:
    section = content.plane_sections[0]
    panels = section_figure_of(section).axes
    assert len(panels) == 2
    for axes, state in zip(panels, ("before", "after"), strict=True):
        assert len(axes.lines) == len(section.lines)
        for drawn, line in zip(axes.lines, section.lines, strict=True):
            points = np.array(getattr(line, f"{state}_m"))
            assert np.asarray(drawn.get_ydata()) == pytest.approx(1000.0 * points[:, 1])
        colours = {drawn.get_color() for drawn in axes.lines}
        assert len(colours) == len(section.lines)
    (before, after) = (np.ptp(axes.get_ylim()) for axes in panels)
    assert before > 5 * after, "each state has its own scale"


def test_a_section_without_points_of_a_line_is_drawn(content: ReportContent) -> None:
    section = content.plane_sections[0]
    empty = replace(section, lines=tuple(replace(x, before_m=()) for x in section.lines))
    assert len(section_figure_of(empty).axes) == 2


def test_a_project_without_a_result_has_no_section(tmp_path: Path) -> None:
    project: Project = sample_project(tmp_path)
    bare = sample_content(replace(project, result=None, validation=()))
    assert bare.plane_sections == ()
