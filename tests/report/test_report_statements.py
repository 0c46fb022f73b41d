"""Tests of statements of the report: variance factor, offsets, origin, histograms, summaries."""

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from lispac.adjustment.result import VarianceComponent
from lispac.alternative_methods import AlternativeResult
from lispac.messages import Level
from lispac.present.calibration.adjustment import TOO_SMALL_ESTIMATED_TEXT, adjustment_values
from lispac.present.calibration.adjustment_fit import fit_facts
from lispac.present.calibration.cross_checks import halves_sigma_deg
from lispac.present.calibration.settings import settings_used, system_facts
from lispac.present.checking.validation import (
    PLANE_DISTANCES_TABLE,
    LineShiftValues,
    PairStateValues,
    ValidationPlane,
)
from lispac.present.survey.survey_data import planes_table
from lispac.present.targets.sightings import (
    POS_ERROR_CAPTION,
    POS_ERROR_WITHIN_CAPTION,
    pos_error_caption,
)
from lispac.present.text_format import localised_number
from lispac.project import Project
from lispac.report.distance_profiles import MIN_PROFILE_SPAN_M, profile_figure_of
from lispac.report.document import undrawn_document
from lispac.report.document_blocks import Block, Paragraph, Table, report_table
from lispac.report.histograms import small_histograms_figure_of
from lispac.report.options import ReportOptions
from lispac.report.report_values import ReportContent
from lispac.report.sections import measuring_system_table
from lispac.report.validation_warnings import (
    larger_distances_messages,
    offset_notes,
    peak_notes,
    shift_limit,
)
from tests.support.report_sample import sample_content, sample_project, undrawn_pictures

ORIGIN = (45.50172282, -73.55116054, -24.99)


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("sample"))


@pytest.fixture(scope="module")
def content(project: Project) -> ReportContent:
    return sample_content(project)


def _blocks(content: ReportContent, extent: str) -> list[Block]:
    document = undrawn_document(content, {}, ReportOptions(extent=extent))  # type: ignore[arg-type]
    return [*document.summary, *(b for section in document.sections for b in section.blocks)]


def _cell(blocks: list[Block], name: str) -> list[str]:
    """Texts of the rows of tables of facts that start with a name."""
    return [
        row[1]
        for block in blocks
        if isinstance(block, Table)
        for row in block.rows
        if len(row) == 2 and row[0] == name
    ]


# -- variance factor -------------------------------------------------------------------------


def _conservative(project: Project, **changes: Any) -> Project:
    result = project.result
    assert result is not None
    test = replace(result.chi_square, statistic=result.chi_square.lower * 0.9)
    return replace(project, result=replace(result, chi_square=test, **changes))


def test_a_low_factor_with_an_estimated_lidar_noise_is_not_blamed_on_given_sigmas(
    project: Project,
) -> None:
    estimated = VarianceComponent("LiDAR", 0.68, 0.67, 0.69, applied=True, used=0.68)
    changed = _conservative(project, components=(estimated,), assumed_sigmas=("LiDAR",))
    codes = [each.code for each in sample_content(changed).warnings]
    assert "report.chi_square_low_estimated" in codes
    assert "report.chi_square_low" not in codes
    assert changed.result is not None
    values = adjustment_values(changed.result)
    assert TOO_SMALL_ESTIMATED_TEXT in str(values.chi_square.text)
    without = adjustment_values(_conservative(project).result)  # type: ignore[arg-type]
    (named,), (plain,) = (
        [fact.text for fact in fit_facts(each) if fact.name == "Variance factor"]
        for each in (values, without)
    )
    assert "LiDAR" in named
    assert named != plain


# -- origin and positions --------------------------------------------------------------------


@pytest.mark.parametrize("extent", ["short", "full"])
def test_both_reports_give_the_position_of_the_origin(content: ReportContent, extent: str) -> None:
    settings = replace(content.settings, origin_deg_m=ORIGIN)
    (text,) = _cell(
        _blocks(replace(content, settings=settings), extent), "Origin of the local frame"
    )
    for value in ("45.50172282", "73.55116054", "24.990"):
        assert value in text


def test_positions_are_east_north_up(content: ReportContent) -> None:
    table = report_table(planes_table(6), content.planes)
    titles = [column.title.split()[0] for column in table.columns]
    place = titles.index("East")
    assert titles[place : place + 3] == ["East", "North", "Up"]
    geometry = content.planes[0].geometry
    assert geometry is not None
    north, west, up = geometry.centre_local_m
    expected = [localised_number(f"{value:.2f}") for value in (-west, north, up)]
    assert list(table.plain_rows[0][place : place + 3]) == expected


@pytest.mark.parametrize("extent", ["short", "full"])
def test_both_reports_give_the_geometry_of_targets_and_validation_planes(
    content: ReportContent, extent: str
) -> None:
    first, *others = content.planes
    assert first.geometry is not None
    level = replace(first.geometry, inclination_deg=2.0, azimuth_deg=None)
    planes = (replace(first, geometry=level), *(replace(each, geometry=None) for each in others))
    for shown, expected in (
        (content.planes, [["2.40 × 1.20", "90", "90"]] * len(planes)),
        (planes, [["2.40 × 1.20", "2", "–"], *[["–", "–", "–"]] * len(others)]),
    ):
        (table,) = (
            each
            for each in _blocks(replace(content, planes=shown), extent)
            if isinstance(each, Table) and "validation planes (position" in each.title
        )
        titles = [column.title.split()[0] for column in table.columns]
        place = titles.index("Width")
        assert [list(row[place : place + 3]) for row in table.rows] == expected
        assert ("Threshold" in titles) == (extent == "full")


# -- validation ------------------------------------------------------------------------------


def _with_offsets(
    plane: ValidationPlane, before: float, after: float, shifts: tuple[LineShiftValues, ...] = ()
) -> ValidationPlane:
    def moved(state: PairStateValues, offset: float) -> PairStateValues:
        assert state.signed is not None
        return replace(state, signed=replace(state.signed, median_m=offset))

    first = plane.pairs[0]
    changed = replace(first, before=moved(first.before, before), after=moved(first.after, after))
    return replace(plane, pairs=(changed, *plane.pairs[1:]), shifts=shifts)


def test_the_offsets_before_and_after_are_those_of_the_same_lines(
    content: ReportContent,
) -> None:
    plane = _with_offsets(content.validation[0], -0.0392, -0.0415)
    assert plane.largest_offset_lines == "L1 / L2"
    assert plane.former_offset_m == 0.0392
    assert plane.largest_offset_m == 0.0415
    row = report_table(PLANE_DISTANCES_TABLE, [plane]).plain_rows[0]
    assert [*row[-3:]] == ["41.5", "L1 / L2", "39.2"]


@pytest.mark.parametrize(
    ("places", "counts", "peaks"),
    [
        ((0.012, 0.030), 40_000, (0.012, 0.030)),
        ((0.0, 0.030), 40_000, (0.0, 0.030)),  # the sign is lost, and half of the peak folded
        ((0.012, 0.018), 40_000, None),  # closer than two peaks of this scatter can be
        ((0.012, 0.030), 10, None),  # too few distances
    ],
)
def test_pooled_distances_with_several_peaks_are_noted(
    content: ReportContent,
    places: tuple[float, float],
    counts: int,
    peaks: tuple[float, float] | None,
) -> None:
    scatter, edges = 0.003, np.arange(0.0, 0.0605, 0.0005)
    generator = np.random.default_rng(38)
    pooled = np.abs(generator.normal(0, scatter, (counts, 2)) + places)
    first = content.validation[0].pairs[0]
    assert first.after.signed is not None
    pairs = tuple(
        replace(
            first,
            after=replace(
                first.after,
                signed=replace(first.after.signed, median_m=place),
                distances=replace(first.after.distances, rms_m=float(np.hypot(place, scatter))),
            ),
        )
        for place in places
    )
    plane = replace(
        content.validation[0],
        pooled_from="all pairs",
        pairs=pairs,
        bin_edges_m=tuple(edges.tolist()),
        counts_after=tuple(np.histogram(pooled, edges)[0].tolist()),
    )
    for sigma, code in ((0.01, "several_peaks"), (None, "several_peaks_unknown"), (0.001, "")):
        shifts = () if sigma is None else (LineShiftValues(("L1",), ("L2",), 0.02, sigma, False),)
        found = list(peak_notes([replace(plane, shifts=shifts)]))
        if peaks is None or not code:  # a significant shift has a warning of its own
            assert found == []
            continue
        assert [each.code for each in found] == [f"validation.{code}"]
        (item,) = found[0].params["items"]
        measured = (item.params["smaller"], item.params["larger"])
        assert measured == pytest.approx(peaks, abs=0.001)


def test_a_largest_offset_that_did_not_decrease_is_noted(content: ReportContent) -> None:
    plane = content.validation[0]

    def code(before: float, after: float, *sigmas: float) -> list[str]:
        shifts = tuple(LineShiftValues(("L1",), ("L2",), 0.02, s, False) for s in sigmas)
        return [each.code for each in offset_notes([_with_offsets(plane, before, after, shifts)])]

    limit = shift_limit(
        [_with_offsets(plane, 0, 0, (LineShiftValues(("L1",), ("L2",), 0, 1, False),))]
    )
    assert code(-0.0412, -0.0375, 0.02) == []
    assert code(-0.002, 0.003, 0.02) == []  # below the smallest offset that matters
    assert code(-0.0392, -0.0415, 1.1 * 0.02 / limit) == ["validation.offset_not_smaller"]
    assert code(-0.0392, -0.0415, 0.9 * 0.02 / limit) == ["validation.offset_not_smaller_shifted"]
    assert code(-0.0392, -0.0415) == ["validation.offset_not_smaller_unknown"]


def test_larger_distances_are_a_warning_only_if_their_cause_is_not_explained(
    content: ReportContent,
) -> None:
    plane = content.validation[0]

    def found(factor: float, *ratios: float) -> list[tuple[str, Level]]:
        after = replace(plane.before, rms_m=factor * plane.before.rms_m)
        shifts = tuple(LineShiftValues(("L1",), ("L2",), 0.01 * r, 0.01, False) for r in ratios)
        changed = replace(plane, after=after, shifts=shifts)
        return [(each.code, each.level) for each in larger_distances_messages([changed])]

    limit = shift_limit([replace(plane, shifts=(LineShiftValues(("L1",), ("L2",), 0, 1, False),))])
    assert found(0.99, 2 * limit) == found(1.0, 2 * limit) == []
    explained = [("report.validation_worse_explained", Level.NOTE)]
    assert found(1.01, 0.5, 0.99 * limit) == explained
    unexplained = [("report.validation_worse", Level.WARNING)]
    assert found(1.01, 0.5, 1.01 * limit) == found(1.01) == unexplained


def test_a_given_lever_arm_has_the_decimals_of_its_digits(project: Project) -> None:
    def text(*lever_arm: float) -> str:
        settings = replace(project.settings, lever_arm=lever_arm)
        used = settings_used(replace(project, settings=settings), None)
        return system_facts(used, None)[0].text

    assert text(-0.186, 0.038, 2.419) == "−0.186, 0.038, 2.419 m"
    assert text(-0.1864, 0.038, 2.419) == "−0.1864, 0.0380, 2.4190 m"


def test_the_source_of_the_lever_arm_is_below_it(content: ReportContent) -> None:
    identity = replace(content.identity, lever_arm_origin="dock survey")
    table = measuring_system_table(replace(content, identity=identity))
    names = [row[0] for row in table.plain_rows]
    (place,) = (k for k, row in enumerate(table.plain_rows) if row[1] == "dock survey")
    assert names[place - 1].lower().endswith("lever arm (forward, left, up)")


def test_red_pos_errors_are_explained_only_if_there_are_any(content: ReportContent) -> None:
    assert content.adjustment is not None
    first = next(each for each in content.adjustment.sightings if each.pos_error is not None)
    assert first.pos_error is not None
    within = replace(first.pos_error, error_m=(0.0, 0.0, 0.0), error_deg=(0.0, 0.0, 0.0))
    up = 2.01 * first.pos_error.sigma_m[2]
    beyond = replace(within, error_m=(0.0, 0.0, up))
    assert pos_error_caption([replace(first, pos_error=within)]) == POS_ERROR_WITHIN_CAPTION
    assert pos_error_caption([replace(first, pos_error=beyond)]) == POS_ERROR_CAPTION


def test_a_profile_over_a_few_centimetres_is_omitted(content: ReportContent) -> None:
    plane = content.validation[0]
    assert plane.by_height is not None
    edges = np.linspace(0.0, 0.9 * MIN_PROFILE_SPAN_M, len(plane.by_height.edges_m))
    flat = replace(plane, by_height=replace(plane.by_height, edges_m=tuple(edges.tolist())))
    assert len(profile_figure_of(plane).axes) == 2
    assert len(profile_figure_of(flat).axes) == 1


def test_the_short_report_has_histograms_of_the_planes_with_maps(content: ReportContent) -> None:
    drawn = [
        each
        for each in undrawn_pictures(_blocks(content, "short"))
        if getattr(each.draw, "func", None) is small_histograms_figure_of
    ]
    (one,) = drawn
    (planes,) = one.values
    assert [plane.name for plane in planes] == ["V1", "V2", "V3"]  # type: ignore[attr-defined]
    figure = one.draw(*one.values)
    assert [axes.get_title() for axes in figure.axes] == ["V1", "V2", "V3"]
    for axes, plane in zip(figure.axes, content.validation, strict=True):
        assert axes.get_xlim()[1] == pytest.approx(1000 * plane.bin_edges_m[-1])


# -- cross-checks and summaries --------------------------------------------------------------


def test_the_sigma_of_the_difference_of_the_halves_is_printed(content: ReportContent) -> None:
    checks = content.cross_checks
    assert checks is not None
    sigma = halves_sigma_deg(checks)
    assert sigma is not None
    half = [each for each in checks.parts if each.kind == "half"][-1]
    assert half.difference_deg is not None
    assert half.significance is not None
    assert np.array(sigma) * [*half.significance] == pytest.approx([*half.difference_deg])
    texts = [b.text for b in _blocks(content, "full") if isinstance(b, Paragraph)]
    assert any(all(f"{each:.4f}" in text for each in sigma) for text in texts)


def test_long_sections_start_with_their_numbers(content: ReportContent) -> None:
    document = undrawn_document(content, {}, ReportOptions(extent="full"))
    first: Mapping[str, Block] = {each.title: each.blocks[0] for each in document.sections}
    assert content.adjustment is not None
    largest_w = max(abs(each.w or 0.0) for each in content.adjustment.sightings)
    offset = max(plane.largest_offset_m or 0.0 for plane in content.validation)
    rms = max(each.rms_after_m for each in content.adjustment.sightings)
    for title, number in (
        ("Boresight and its uncertainty", f"{content.adjustment.sigma_deg.yaw:.4f}"),
        (
            "Targets and residuals",
            f"{1000 * rms:.1f}",
        ),
        ("Reliability of the sightings", f"{largest_w:.2f}"),
        ("Validation", f"{1000 * offset:.1f}"),
    ):
        block = first[title]
        assert isinstance(block, Paragraph)
        assert number in block.text


def test_the_short_report_compares_each_alternative_method_with_the_adjustment(
    project: Project,
) -> None:
    assert not _cell(_blocks(sample_content(project), "short"), "Patch test")
    assert project.result is not None
    for off_deg, differs in ((0.004, False), (0.9, True)):
        angles = project.result.boresight + np.radians([off_deg, 0.0, -0.01])
        covariance = np.array(project.result.covariance)
        patch = AlternativeResult("patch test", angles, covariance, ("L1", "L2"), 3, ())
        content = sample_content(project.with_alternative_result(patch))
        (_, row) = content.methods
        assert row.differ == differs
        (text,) = _cell(_blocks(content, "short"), "Patch test")
        numbers = [float(each) for each in re.findall(r"[+-]?\d+\.\d+", text.replace("−", "-"))]
        expected = [
            round(value, digits)
            for pair in zip(row.difference_deg, row.significance, strict=True)
            for value, digits in zip(pair, (4, 1), strict=True)
        ]
        assert numbers == pytest.approx(expected, abs=1e-9)
        assert ("no significant difference" in text) == (not differs)
