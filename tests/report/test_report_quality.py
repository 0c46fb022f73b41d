"""Tests of the report's texts on parameters, reliability and cross-checks of the adjustment."""

import json
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.adjustment.model.parameters import ParameterEstimate, mounting_value_name
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult, VarianceComponent
from lispac.message_texts import message_text
from lispac.messages import Level, error, note
from lispac.present.targets.sightings import POS_ERRORS_TABLE
from lispac.present.text_format import UNKNOWN_TEXT
from lispac.project import Project
from lispac.report import figures
from lispac.report.content import ReportContent, report_content
from lispac.report.document import report_document
from lispac.report.document_blocks import Bullets, Document, Paragraph, Table, report_table
from lispac.report.json_report import json_text
from lispac.report.options import ReportOptions
from lispac.report.pdf import write_pdf
from lispac.targets.sighting_quality import SightingQuality
from tests.support.long_runs import LONG
from tests.support.report_sample import (
    FULL_REPORT,
    LARGEST_INCREASES,
    MADE,
    sample_content,
    sample_project,
)
from tests.targets.test_quality import board, quality_of

FORM_ERROR = "Form error of the targets from line to line (1 sigma)"
Changed = Callable[..., ReportContent]


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("quality") / "harbour")


@pytest.fixture
def changed(project: Project) -> Changed:
    """Return a function that makes the content of the sample with changed results."""

    def content(**values: Any) -> ReportContent:
        assert project.result is not None
        return sample_content(replace(project, result=replace(project.result, **values)))

    return content


def _result(project: Project) -> AdjustmentResult:
    assert project.result is not None
    return project.result


def _warning(content: ReportContent, code: str) -> Mapping[str, Any]:
    """Return the parameters of the only warning with this code."""
    found = [each.params for each in content.warnings if each.code == code]
    assert len(found) == 1, (code, [message.code for message in content.warnings])
    return found[0]


def _tables(document: Document) -> dict[str, Table]:
    blocks = [*document.summary, *(b for section in document.sections for b in section.blocks)]
    return {block.title: block for block in blocks if isinstance(block, Table)}


def _words(document: Document, title: str) -> str:
    section = next(section for section in document.sections if section.title == title)
    texts: list[str] = []
    for block in section.blocks:
        if isinstance(block, Paragraph):
            texts.append(block.text)
        elif isinstance(block, Bullets):
            texts += block.items
        elif isinstance(block, Table):
            texts += [cell for row in block.rows for cell in row]
    return "\n".join(texts)


def _settings(content: ReportContent) -> dict[str, str]:
    return dict(_tables(report_document(content, {}, FULL_REPORT))["Stochastic model"].rows)  # type: ignore[arg-type]


def test_stochastic_model_is_described(project: Project, changed: Changed) -> None:
    rows = _settings(sample_content(project))
    assert rows["POS errors"].startswith("Correlated in time. All points of one sighting share")
    assert rows["Correlation times (position, attitude)"] == "300 s, 600 s (default values)"
    assert rows[FORM_ERROR].startswith("0.4\u00a0mm, estimated from the data")
    assert rows["LiDAR noise, 1 sigma"] == "5.0 mm on each axis (assumed, not given)"
    assert rows["Estimated LiDAR noise"] == "not larger than the noise used on any target"
    first, second = _result(project).targets
    noisy = changed(
        targets=(first, replace(second, noise=1.42)),
        model=StochasticModel(surface=0.0004, loss="tukey"),
    )
    rows = _settings(noisy)
    assert rows["Estimated LiDAR noise"].startswith(
        "T2: 1.42\u00a0times the noise used; the sigmas"
    )
    assert "T1" not in rows["Estimated LiDAR noise"]
    assert rows[FORM_ERROR].startswith("0.4\u00a0mm, as given")
    assert "beyond 4.7 standard deviations" in rows["Outliers"]
    assert "adjustment.noise" not in {message.code for message in noisy.warnings}
    noisier = _warning(changed(targets=(first, replace(second, noise=2.4))), "adjustment.noise")
    assert (noisier["targets"], noisier["factor"]) == (("T2",), 2.4)


def test_pos_accuracies_and_the_lever_arm_have_their_sources(
    project: Project, changed: Changed
) -> None:
    first, *others = _result(project).reliability
    content = changed(reliability=(replace(first, pos_sigma=2 * first.pos_sigma), *others))
    rows = _settings(content)
    assert rows["Position sigma (north, east, down)"] == (
        "0.012 to 0.024, 0.012 to 0.024, 0.020 to 0.040 m at the sightings of the targets (from "
        "the accuracy file)"
    )
    assert rows["Attitude sigma (roll, pitch, heading)"].startswith("0.0080 to 0.0160, ")
    assert rows["Lever-arm sigma (forward, left, up)"].startswith("not used")
    model = replace(_result(project).model, position_time=120.0)
    rows = _settings(changed(model=model))
    assert rows["Correlation times (position, attitude)"] == "120 s, 600 s (given)"
    uncertain = replace(_result(project).model, lever_arm_sigma=(0.005, 0.006, 0.007))
    rows = _settings(changed(model=uncertain))
    assert rows["Lever-arm sigma (forward, left, up)"].startswith("0.005, 0.006, 0.007 m (given")


def test_the_interval_of_the_variance_factor_is_that_of_its_test(project: Project) -> None:
    result = _result(project)
    test = result.chi_square
    tables = _tables(report_document(sample_content(project), {}, FULL_REPORT))
    facts = dict(tables["Fit of the adjustment"].rows)  # type: ignore[arg-type]
    low, high = map(float, facts["Expected interval at 95 %"].split(" to "))
    assert low == pytest.approx(test.lower / result.degrees_of_freedom, abs=5e-5)
    assert high == pytest.approx(test.upper / result.degrees_of_freedom, abs=5e-5)
    factor = float(facts["Variance factor"].split()[0])
    assert (low <= factor <= high) == test.passed


def test_the_table_of_planes_states_the_pairs_of_its_values(project: Project) -> None:
    content = sample_content(project)
    plane = content.validation[0]
    only = replace(plane, name="V9", pooled_from="all pairs")
    document = report_document(replace(content, validation=(plane, only)), {}, FULL_REPORT)
    (table,) = (table for title, table in _tables(document).items() if "Validation:" in title)
    place = [column.title for column in table.columns].index("Pairs\nof lines")
    reciprocal = sum(pair.reciprocal for pair in plane.pairs)
    assert [row[place] for row in table.rows] == [
        f"reciprocal: {reciprocal} of {len(plane.pairs)}", str(len(plane.pairs)),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("settings", "shown"),
    [
        ({"lidar_beam_sigma": (0.006, 0.02)}, "range 6.0 mm, beam direction 0.0200° (given)"),
        ({"lidar_sigma_xyz": (0.003, 0.004, 0.005)}, "x 3.0 mm, y 4.0 mm, z 5.0 mm (given)"),
    ],
)
def test_given_lidar_noise_is_reported(
    project: Project, settings: dict[str, Any], shown: str
) -> None:
    other = replace(project, settings=replace(project.settings, **settings))
    assert _settings(sample_content(other))["LiDAR noise, 1 sigma"] == shown


def test_points_are_averaged_or_selected(project: Project, tmp_path: Path) -> None:
    for content, word in (
        (sample_content(project), "averaged"),
        (sample_content(sample_project(tmp_path / "p", model="independent")), "thinned"),
    ):
        facts = dict(_tables(report_document(content, {}, FULL_REPORT))["System and points"].rows)  # type: ignore[arg-type]
        assert facts["Point spacing"].startswith(word)


def test_variance_components_are_reported_with_their_intervals(changed: Changed) -> None:
    found = (
        VarianceComponent("LiDAR", 0.82, 0.78, 0.87, applied=True),
        VarianceComponent("POS position", 1.3, 0.6, 2.9, applied=True),
        VarianceComponent("POS attitude", 1.3, 0.6, 2.9),
    )
    table = _tables(report_document(changed(components=found), {}, FULL_REPORT))[
        "Variance components: ratio of estimated to given or assumed sigmas"
    ]
    assert table.rows[0] == (
        "LiDAR",
        "0.82",
        "0.78 to 0.87",
        message_text(note("component.smaller")),
    )
    assert table.rows[1][2:] == ("0.60 to 2.90", message_text(note("component.larger")))
    assert table.rows[2][2:] == (
        "0.60 to 2.90",
        message_text(note("component.as_given")),
    )


def test_extra_parameters_are_reported(project: Project, changed: Changed) -> None:
    document = report_document(sample_content(project), {}, FULL_REPORT)
    row = _tables(document)["Parameters estimated together with the boresight"].rows[0]
    assert row == (
        "Lever arm X", "\u22120.1856\u00a0m", "not given", "\u22120.2017\u00a0m", "0.0048\u00a0m",
        "\u22123.4", "significant",
    )  # fmt: skip
    first_page = [block.text for block in document.summary if isinstance(block, Paragraph)]
    assert any("lever arm X \u22120.2017" in text for text in first_page)
    late = ParameterEstimate("latency", 0.0, 0.002, 0.0011, 0.0008, 0.6)
    turned = ParameterEstimate("scan_angle_offset", 0.0, None, reason=note("parameter.kept"))
    content = changed(parameters=(*_result(project).parameters, turned, late))
    assert _warning(content, "report.parameter_not_significant") == {
        "parameter": note("quantity.latency"), "change": note("change.ms", value=0.0011),
    }  # fmt: skip
    assert _warning(content, "report.parameter_not_seen") == {
        "parameter": note("quantity.scan_angle_offset"), "reason": note("parameter.kept"),
    }  # fmt: skip
    rows = _tables(report_document(content, {}, FULL_REPORT))[
        "Parameters estimated together with the boresight"
    ].rows
    assert rows[1][-1] == "not estimated, given value used"
    assert rows[2][2] == "2.00\u00a0ms"


def test_heat_map_is_shown_only_with_extra_parameters(project: Project, tmp_path: Path) -> None:
    def captions(content: ReportContent) -> list[str]:
        blocks = report_document(content, {}, FULL_REPORT).sections[0].blocks
        return [block.caption for block in blocks if block.kind == "picture"]

    assert len(captions(sample_content(project))) == 1
    assert captions(sample_content(sample_project(tmp_path / "p", model="independent"))) == []


def test_rejected_sighting_is_named_on_page_one(project: Project, changed: Changed) -> None:
    first, second, *rest = _result(project).reliability
    rejected = replace(first, rejected=True, shift=0.0483, w=9.34)
    content = changed(reliability=(rejected, replace(second, w=-4.2), *rest))
    assert _warning(content, "adjustment.released")["sightings"] == (
        note("item.sighting_shifted", target="T1", line="L1", shift=0.0483, w=9.34),
    )
    (other,) = _warning(content, "adjustment.sighting_disagrees")["sightings"]
    assert (other.params["target"], other.params["line"]) == ("T1", "L2")
    rows = _tables(report_document(content, {}, FULL_REPORT))["Agreement of the sightings"].rows
    assert [row[-1] for row in rows[:3]] == ["rejected", "disagrees", "agrees"]


def test_sighting_without_a_check_has_no_numbers(project: Project, changed: Changed) -> None:
    first, *rest = _result(project).reliability
    document = report_document(
        changed(reliability=(replace(first, detectable=1e5), *rest)), {}, FULL_REPORT
    )
    row = _tables(document)["Agreement of the sightings"].rows[0]
    assert row[2:8] == ("\u2013",) * 6
    assert row[-1] == "not checked"
    assert "T1 on line L1" in _words(document, "Reliability of the sightings")


def test_more_outliers_than_expected_by_chance_give_a_warning(
    project: Project, changed: Changed
) -> None:
    reliability = _result(project).reliability
    few = tuple(replace(item, outliers=1) for item in reliability[:3]) + reliability[3:]
    codes = {message.code for message in changed(reliability=few).warnings}
    assert not any(code.startswith("adjustment.strays") for code in codes)
    many = (*reliability[:-1], replace(reliability[-1], outliers=60))
    found = _warning(changed(reliability=many), "adjustment.strays_full_weight")
    assert (found["count"], found["target"], found["line"]) == (60, "T2", "L6")


def test_cross_checks_that_disagree_give_a_warning(project: Project) -> None:
    checks = project.cross_checks
    assert checks is not None
    plain = _tables(report_document(sample_content(project), {}, FULL_REPORT))
    rows = plain["Results of subsets of the data: differences from the full adjustment"].rows
    assert [row[0] for row in rows[-3:]] == [
        "Without target T1", "Without target T2", "Second minus first half",
    ]  # fmt: skip
    assert rows[-3][-1] == "no result"
    words = _words(report_document(sample_content(project), {}, FULL_REPORT), "Cross-checks")
    reason = message_text(error("adjustment.parallel_planes"))
    assert f"Without target T1: {reason}" in words
    sigma = np.array([-0.2, 4.1, 1.0])
    odd = replace(checks.parts[1], significance=sigma, difference=np.radians([0.0, 0.1512, 0.0]))
    wide = replace(checks, parts=(checks.parts[0], odd, *checks.parts[2:]))
    content = sample_content(replace(project, cross_checks=wide))
    (part,) = _warning(content, "adjustment.cross_check_uncovered")["parts"]
    assert (part.code, part.params["name"]) == ("item.without_line", "L2")
    assert part.params["angle"] == note("quantity.pitch")
    assert np.degrees(part.params["difference"]) == pytest.approx(0.1512)
    assert part.params["ratio"] == pytest.approx(4.1)


def test_failed_chi_square_is_a_warning_only_in_the_classical_model(
    project: Project, changed: Changed
) -> None:
    test = replace(_result(project).chi_square, statistic=1e6)
    for model, level, code in (
        ("correlated", Level.NOTE, "report.chi_square_high"),
        ("independent", Level.WARNING, "report.chi_square_high_classical"),
    ):
        content = changed(chi_square=test, model=StochasticModel(model))  # type: ignore[arg-type]
        assert [
            (c.level, c.code) for c in content.warnings if c.code.startswith("report.chi_square")
        ] == [(level, code)]


def test_spheres_are_named_as_such_in_the_report(project: Project, changed: Changed) -> None:
    first, second = _result(project).targets
    ball = replace(second, sphere=True, plane=np.array([1.0, 2.0, 3.0, 0.1004]))
    content = changed(targets=(first, ball))
    targets = tuple(
        replace(target, shape="sphere", sphere_radius=0.1) if target.name == "T2" else target
        for target in project.targets
    )
    picked = sample_content(replace(project, targets=targets))
    shown = _tables(report_document(content, {}, FULL_REPORT))[
        "Fit of each target to one surface, all lines together"
    ]
    assert shown.rows[1][1] == "sphere, radius\u00a0100.4\u00a0mm"
    shown = _tables(report_document(picked, {}, FULL_REPORT))[
        "Targets and validation planes (position from the origin of the local frame)"
    ]
    assert shown.rows[1][2] == "sphere, radius\u00a0100.0\u00a0mm"


def test_classical_model_has_no_reliability(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p", model="independent")
    content = sample_content(replace(project, cross_checks=None))
    document = report_document(content, {}, FULL_REPORT)
    (reliability,) = (each for each in document.sections if each.title.startswith("Reliability"))
    assert [type(block) for block in reliability.blocks] == [Paragraph]  # no table of tests
    assert message_text(LARGEST_INCREASES) in _words(document, "Boresight and its uncertainty")
    data = json.loads(json_text(content))
    assert {each["status"] for each in data["adjustment"]["sightings"]} == {"not tested"}
    assert data["cross_checks"] is None
    assert data["settings"]["surface_sigma_m"] is None
    write_pdf(content, tmp_path / "thesis.pdf", {}, FULL_REPORT)


def test_sections_on_checks_are_omitted_without_a_result(project: Project) -> None:
    content = sample_content(replace(project, result=None, cross_checks=None))
    titles = {section.title for section in report_document(content, {}, FULL_REPORT).sections}
    assert titles.isdisjoint({"Reliability of the sightings", "Cross-checks"})
    roughness = _settings(content)[FORM_ERROR]
    assert roughness.startswith("to be estimated from the data")


def test_pos_error_figure_marks_errors_beyond_the_prior(changed: Changed, project: Project) -> None:
    first, *rest = _result(project).reliability
    error = np.array([0.03, 0.04, 0, 0, 0, 0])  # north, west
    checks = changed(reliability=(replace(first, pos_error=error), *rest)).adjustment
    assert checks is not None
    (figure,) = figures.pos_error_figures_of(checks.sightings)
    titles = ["East", "North", "Up", "Roll", "Pitch", "Heading"]
    assert [axes.get_title() for axes in figure.axes] == titles
    for axes, expected in zip(figure.axes, (-40.0, 30.0), strict=False):
        red = [line for line in axes.lines if line.get_color() == "#bb2222"]
        assert [list(np.asarray(line.get_xdata())) for line in red] == [[pytest.approx(expected)]]
    row = report_table(POS_ERRORS_TABLE, checks.sightings[:1]).rows[0]
    assert [cell.replace("\u2212", "-") for cell in row[2:4]] == ["-40.0", "+30.0"]
    many = checks.sightings * 5
    for draw in (figures.pos_error_figures_of, figures.residual_figures_of):
        parts = draw(many)
        assert len(parts) == 3
        assert len({tuple(np.round(part.axes[0].get_xlim(), 9)) for part in parts}) == 1


def test_a_component_of_the_pos_error_without_information_is_not_determined(
    changed: Changed, project: Project
) -> None:
    first, *rest = _result(project).reliability
    after = first.pos_sigma * [1.0, 0.9, 0.9, 0.9, 0.9, 0.9]
    checks = changed(reliability=(replace(first, pos_sigma_after=after), *rest)).adjustment
    assert checks is not None
    row = report_table(POS_ERRORS_TABLE, checks.sightings[:1]).rows[0]
    assert [cell == UNKNOWN_TEXT for cell in row[2:]] == [False, True, *[False] * 4]
    (figure,) = figures.pos_error_figures_of(checks.sightings)
    points = [
        np.concatenate([line.get_ydata() for line in axes.lines if line.get_marker() == "o"])
        for axes in figure.axes
    ]
    everything = set(range(len(checks.sightings)))
    for title, drawn in zip([axes.get_title() for axes in figure.axes], points, strict=True):
        assert set(drawn) == everything - ({0} if title == "North" else set())


def test_a_large_sigma_gives_a_warning_with_its_cause(project: Project, changed: Changed) -> None:
    result = _result(project)
    large = result.covariance_all.copy()
    large[0, 0] = np.radians(0.5) ** 2
    reason = note("parameter.kept_uncertain")
    unseen = ParameterEstimate("scan_angle_offset", 0.0, np.radians(0.5), reason=reason)
    content = changed(covariance_all=large, parameters=(unseen,))
    (message,) = [c for c in content.warnings if c.code == "adjustment.large_sigma_unseen"]
    angle = note("item.angle_sigma", angle=mounting_value_name("roll"), sigma=large[0, 0] ** 0.5)
    assert message.params["angles"] == [angle]
    assert message.params["parameters"] == (mounting_value_name("scan_angle_offset"),)
    assert not [c for c in changed().warnings if "large_sigma" in c.code]


def test_noise_is_reported_only_where_it_was_found(project: Project, changed: Changed) -> None:
    result = _result(project)
    failed = replace(result.chi_square, statistic=result.chi_square.upper * 2)
    noiseless = tuple(replace(target, noise=1.0) for target in result.targets)
    noisy = tuple(replace(target, noise=2.0) for target in result.targets)
    model = StochasticModel("correlated")
    for targets, code in ((noiseless, "chi_square_high"), (noisy, "chi_square_high_noise")):
        content = changed(chi_square=failed, targets=targets, model=model)
        assert f"report.{code}" in {each.code for each in content.warnings}


def test_noise_that_differs_between_targets_blames_no_given_sigma(
    project: Project, changed: Changed
) -> None:
    """One target has more noise, and the others that which was given or estimated from all."""
    result = _result(project)
    failed = replace(result.chi_square, statistic=result.chi_square.upper * 1.01)
    first, *others = result.targets
    targets = (replace(first, noise=1.18), *(replace(each, noise=1.0) for each in others))
    explained = 1 + (1.18**2 - 1) * first.points / sum(each.points for each in result.targets)
    codes = {"noise_differs", "noise_differs_given", "chi_square_high_noise"}
    for is_applied, variance_factor, code in (
        (True, 2.0, "noise_differs"),
        (False, explained - 1e-6, "noise_differs_given"),
        (False, explained + 1e-6, "chi_square_high_noise"),
    ):
        content = changed(
            components=(VarianceComponent("LiDAR", 0.73, 0.72, 0.74, applied=is_applied),),
            chi_square=failed, targets=targets, variance_factor=variance_factor,
            model=StochasticModel("correlated"),
        )  # fmt: skip
        (message,) = [
            each for each in content.warnings if each.code.removeprefix("report.") in codes
        ]
        assert (message.code, message.level) == (f"report.{code}", Level.NOTE)
        if code != "chi_square_high_noise":
            assert message.params["targets"] == [first.target]
            assert message.params["factor"] == 1.18


def test_a_single_plane_gives_a_warning(project: Project, changed: Changed) -> None:
    result = _result(project)
    first = result.targets[0]
    assert _warning(changed(targets=(first,)), "adjustment.one_target") == {"target": first.target}
    assert not [
        c
        for c in changed().warnings
        if c.code in ("adjustment.one_target", "adjustment.one_facing")
    ]


def test_planes_of_a_single_orientation_give_a_warning(project: Project, changed: Changed) -> None:
    first, second = _result(project).targets
    content = changed(targets=(first, replace(second, plane=first.plane)))
    levels = [c.level for c in content.warnings if c.code == "adjustment.one_facing"]
    assert levels == [Level.WARNING]


def test_accepted_single_orientation_is_shown(project: Project) -> None:
    for accepted in (False, True):
        other = replace(
            project, settings=replace(project.settings, accept_single_orientation=accepted)
        )
        content = sample_content(other)
        shown = dict(_tables(report_document(content, {}, FULL_REPORT))["System and points"].rows)  # type: ignore[arg-type]
        assert ("Targets of a single orientation" in shown) == accepted
        assert json.loads(json_text(content))["settings"]["accept_single_orientation"] == accepted


def test_sightings_edited_by_hand_are_named(project: Project) -> None:
    target = project.targets[0]
    first, second, *others = target.sightings
    edited = replace(target, sightings=(first, replace(second, by_hand=True), *others))
    quality = replace(quality_of(board()), visible_share=0.512)
    content = report_content(
        project.with_target(edited), headings_deg={}, counts={}, track_local={}, notes=(),
        qualities={(target.name, line): quality for line in (first.line, second.line)},
        generated=MADE,
    )  # fmt: skip
    table = _tables(report_document(content, {}, FULL_REPORT))[
        "Quality of each sighting of targets and validation planes"
    ]
    assert [row[-1].endswith("were edited manually.") for row in table.rows] == [
        False, True,
    ]  # fmt: skip
    assert [row[-2] for row in table.rows] == ["51", "51"]
    qualities = json.loads(json_text(content))["qualities"]
    assert [each["visible_share"] for each in qualities] == [0.512, 0.512]
    assert [each["edited_by_hand"] for each in qualities] == [False, True]


@LONG
def test_page_one_counts_sightings_that_are_not_good(project: Project) -> None:
    few = (note("quality.few_points", count=7), note("quality.curved", sagitta=0.004))
    first, second = project.targets[:2]
    good = replace(quality_of(board()), rating="good", reasons=())
    oblique = [
        replace(
            good, rating="doubtful", incidence=np.radians(deg),
            reasons=(note("quality.oblique", angle=np.radians(deg)),),
        )
        for deg in (73, 75)
    ]  # fmt: skip
    rough = replace(good, rating="poor", reasons=few)

    def content(*sightings: tuple[str, str, SightingQuality]) -> ReportContent:
        return report_content(
            project, headings_deg={}, counts={}, track_local={}, notes=(),
            qualities={(target, line): quality for target, line, quality in sightings},
            generated=MADE,
        )  # fmt: skip

    one, two, three = (s.line for s in first.sightings[:3])
    assert first.role == second.role == "target"
    fine = content((first.name, one, good), (first.name, two, good))
    assert "report.sightings" not in {message.code for message in fine.warnings}
    some = (first.name, one, oblique[0]), (first.name, two, oblique[1]), (first.name, three, good)
    assert _warning(content(*some), "report.sightings") == {
        "targets": 3, "planes": 0, "poor": 0, "doubtful": 2, "target": first.name, "line": two,
        "reasons": oblique[1].reasons,
        "sightings": (note("item.target_sightings", count=3),),
        "ratings": (note("item.doubtful", count=2),),
    }  # fmt: skip
    worse = content(*some, (second.name, one, rough))
    assert _warning(worse, "report.sightings") == {
        "targets": 4, "planes": 0, "poor": 1, "doubtful": 2, "target": second.name, "line": one,
        "reasons": few,
        "sightings": (note("item.target_sightings", count=4),),
        "ratings": (note("item.doubtful", count=2), note("item.poor", count=1)),
    }  # fmt: skip
    french = report_document(worse, {}, ReportOptions(language="fr", extent="full")).notes
    assert any("4 observations de cibles" in t and "que 7 points" in t for t in french)
    # A sighting that is not used is not counted.
    excluded = replace(first, sightings=tuple(replace(s, used=False) for s in first.sightings))
    out = report_content(
        project.with_target(excluded), headings_deg={}, counts={}, track_local={}, notes=(),
        qualities={(first.name, one): rough}, generated=MADE,
    )  # fmt: skip
    assert "report.sightings" not in {message.code for message in out.warnings}
