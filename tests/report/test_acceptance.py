"""Tests of the judgement by acceptance criteria, and of its presentation in reports."""

import json
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.acceptance import NO_CRITERIA, AcceptanceCriteria, Verdict, planes_to_show
from lispac.adjustment.model.parameters import mounting_value_name
from lispac.adjustment.result import CrossCheck, CrossChecks
from lispac.errors import InputError, ProjectError
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.language import LANGUAGES, ShownUnit, in_language, use_units
from lispac.message_texts import message_text
from lispac.messages import Level, note
from lispac.present.calibration.adjustment_fit import chi_square_facts
from lispac.present.checking.acceptance import (
    LIMIT_COLUMN,
    MEASURED_COLUMN,
    AcceptanceValues,
    calibration_verdict_text,
    criterion_results,
    failed_texts,
    verdict_scope_text,
)
from lispac.present.checking.validation import ValidationPlane
from lispac.present.tables import cell_text
from lispac.project import Project
from lispac.report.content import ReportContent
from lispac.report.document import undrawn_document
from lispac.report.document_blocks import Block, Paragraph, Table
from lispac.report.json_report import json_text
from lispac.report.options import ReportOptions
from lispac.report.validation_warnings import probable_causes
from lispac.validation.comparison_results import LineShift
from lispac.warning_causes import Cause
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project

HALVES_CODE = "acceptance.halves_differ"
SIGMA_DEG = (0.0163, 0.0291, 0.0376)
"""Standard deviations of the angles of the sample project."""


@pytest.fixture
def project(tmp_path: Path) -> Project:
    return sample_project(tmp_path)


def verdict(project: Project, **criteria: float | None) -> Verdict:
    return project.with_acceptance(AcceptanceCriteria(**criteria)).judgement.verdict


def test_a_smaller_rms_than_before_is_not_a_pass(project: Project) -> None:
    assert all(plane.after.rms < plane.before.rms for plane in project.validation)
    assert project.judgement.verdict == "not judged"
    assert project.judgement.verdict_on(project.validation[0].name) == "not judged"
    assert verdict(project, rms=0.9 * max(p.after.rms for p in project.validation)) == "fail"


def test_angles_are_judged_by_their_standard_deviations(project: Project) -> None:
    names = ("roll_sigma_deg", "pitch_sigma_deg", "yaw_sigma_deg")
    for name, sigma in zip(names, SIGMA_DEG, strict=True):
        assert verdict(project, **{name: 1.001 * sigma}) == "pass"
        assert verdict(project, **{name: 0.999 * sigma}) == "fail"
        (check,) = project.with_acceptance(AcceptanceCriteria(**{name: 1.0})).judgement.checks
        assert check.value == pytest.approx(sigma)


def test_each_plane_is_judged_by_its_rms_and_its_largest_offset(project: Project) -> None:
    planes = project.validation
    worst = max(planes, key=lambda plane: plane.after.rms)
    others = [plane for plane in planes if plane is not worst]
    limit = (worst.after.rms + max(plane.after.rms for plane in others)) / 2
    judged = project.with_acceptance(AcceptanceCriteria(rms=limit)).judgement
    assert judged.verdict_on(worst.name) == "fail"
    assert {judged.verdict_on(plane.name) for plane in others} == {"pass"}

    judged = project.with_acceptance(AcceptanceCriteria(offset=1.0)).judgement
    for check in judged.checks:
        plane = next(plane for plane in planes if plane.name == check.plane)
        offsets = {
            (pair.line_a, pair.line_b): abs(pair.after.signed.median)
            for pair in plane.pairs
            if pair.after.signed
        }
        judged_lines = {line for pair in offsets for line in pair}
        all_lines = {line for pair in plane.pairs for line in (pair.line_a, pair.line_b)}
        if check.value is None:
            assert judged_lines != all_lines or not offsets
        elif offsets:
            assert check.value == max(offsets.values()) == offsets[check.lines]
        else:
            assert check.verdict == "not judged"


def test_halves_that_differ_more_than_a_criterion_are_noted(project: Project) -> None:
    """Only differences above the criterion and above their own 95 % interval count."""
    assert project.result is not None
    unit = np.radians(0.001)
    difference = np.array([-9.0, 9.0, 9.0]) * unit
    significance = difference / (np.array([3.0, 3.0, 6.0]) * unit)
    half = CrossCheck("half", "first", project.result.boresight, project.result.sigma)
    second = replace(half, part="second", difference=difference, significance=significance)
    checked = project.with_cross_checks(CrossChecks((half, second)))

    def angles(project: Project, **limits: float) -> list[str]:
        judged = project.with_acceptance(AcceptanceCriteria(**limits))
        found = [each for each in sample_content(judged).warnings if each.code == HALVES_CODE]
        assert all(each.level is Level.NOTE for each in found)
        assert all(message_text(each) for each in found)
        return [item.params["angle"].code for each in found for item in each.params["items"]]

    names = [mounting_value_name(angle).code for angle in ("roll", "pitch", "yaw")]
    limits = {"roll_sigma_deg": 0.008, "pitch_sigma_deg": 0.01, "yaw_sigma_deg": 0.008}
    assert angles(checked, **limits) == names[:1]  # pitch is within its limit, yaw uncertain
    assert angles(checked, pitch_sigma_deg=0.0089) == names[1:2]
    assert angles(checked) == []
    assert angles(replace(project, cross_checks=None), **limits) == []
    undetermined = replace(second, difference=None, significance=None)
    assert angles(checked.with_cross_checks(CrossChecks((half, undetermined))), **limits) == []


def test_a_negative_difference_is_not_written_like_its_interval() -> None:
    """The magnitude exceeds the interval, although both round to 0.0493."""
    item = note(
        "item.half_difference", angle=mounting_value_name("yaw"),
        difference=np.radians(-0.049312), interval=np.radians(0.049304), limit=np.radians(0.02),
    )  # fmt: skip
    assert "0.04931° ± 0.04930°" in message_text(item)


def test_each_plane_is_judged_by_its_95_percent(project: Project) -> None:
    worst = max(project.validation, key=lambda plane: plane.after.p95)
    assert verdict(project, p95=1.001 * worst.after.p95) == "pass"
    failed = project.with_acceptance(AcceptanceCriteria(p95=0.999 * worst.after.p95))
    assert failed.judgement.verdict_on(worst.name) == "fail"
    found = failed_criteria(sample_content(failed))["acceptance_failure.p95"]
    assert found["planes"] == (worst.name,)
    assert found["value"] == worst.after.p95
    without = failed.with_validation((), {"V9": note("project.single_target")})
    assert without.judgement.verdict == "not judged"


def test_a_line_without_a_known_offset_prevents_a_pass(project: Project) -> None:
    plane = next(p for p in project.validation if all(pair.after.signed for pair in p.pairs))
    assert len({line for pair in plane.pairs for line in (pair.line_a, pair.line_b)}) > 1
    line = plane.pairs[0].line_a

    def without(known: bool) -> Project:
        pairs = tuple(
            pair if known or line not in (pair.line_a, pair.line_b)
            else replace(pair, after=replace(pair.after, signed=None))
            for pair in plane.pairs
        )  # fmt: skip
        return project.with_validation((replace(plane, pairs=pairs),), {})

    assert verdict(without(True), offset=1.0) == "pass"
    assert verdict(without(False), offset=1.0) == "not judged"


def test_a_plane_that_was_not_compared_prevents_a_pass_but_not_a_fail(project: Project) -> None:
    partly = project.with_validation(project.validation, {"V9": note("project.single_target")})
    assert verdict(partly, rms=1.0) == "not judged"
    assert verdict(partly, rms=1e-5) == "fail"
    assert verdict(partly, yaw_sigma_deg=1.0) == "pass"  # does not depend on planes
    judged = partly.with_acceptance(AcceptanceCriteria(rms=1.0)).judgement
    assert judged.verdict_on("V9") == "not judged"
    assert judged.verdict_on(project.validation[0].name) == "pass"


def test_without_result_or_validation_nothing_is_judged(project: Project) -> None:
    assert verdict(replace(project, result=None), roll_sigma_deg=1.0) == "not judged"
    assert verdict(replace(project, validation=()), rms=1.0) == "not judged"
    assert verdict(replace(project, validation=()), rms=1.0, yaw_sigma_deg=1e-5) == "fail"


@pytest.mark.parametrize(
    ("criterion", "code"),
    [
        ({"rms": 0.0}, "settings.length_out_of_range"),
        ({"offset": -0.01}, "settings.length_out_of_range"),
        ({"rms": 30.0}, "settings.length_out_of_range"),
        ({"rms": float("nan")}, "settings.length_out_of_range"),
        ({"roll_sigma_deg": 20.0}, "settings.angle_out_of_range"),
        ({"source": "two\nlines"}, "identity.several_lines"),
        ({"source": "x" * 201}, "identity.too_long"),
    ],
)
def test_impossible_criteria_are_refused(criterion: dict[str, object], code: str) -> None:
    with pytest.raises(InputError) as raised:
        NO_CRITERIA.changed(**criterion)
    assert raised.value.code == code


def test_criteria_are_saved_and_keep_results(project: Project) -> None:
    criteria = NO_CRITERIA.changed(yaw_sigma_deg=0.05, rms=0.03, source=" Contract 4.2 ")
    assert criteria.source == "Contract 4.2"
    project = project.with_acceptance(criteria)
    assert project.result is not None
    assert project.validation
    write_project(project)
    again = read_project(project.folder)
    assert again.acceptance == criteria
    assert again.judgement == project.judgement
    content = json.loads((project.folder / PROJECT_FILE_NAME).read_text())
    content["acceptance"]["rms"] = -1.0
    (project.folder / PROJECT_FILE_NAME).write_text(json.dumps(content))
    with pytest.raises(ProjectError) as raised:
        read_project(project.folder)
    assert raised.value.code == "project.invalid_value"


# -- causes ----------------------------------------------------------------------------------------


def causes_of(project: Project, shifts: tuple[LineShift, ...], **limits: float) -> dict[str, Cause]:
    """Codes and subjects of the causes, with these shifts on the first plane and no other plane."""
    plane = replace(project.validation[0], shifts=shifts)
    judged = replace(project, validation=(plane,)).with_acceptance(AcceptanceCriteria(**limits))
    values = AcceptanceValues.of(judged.judgement)
    return {
        each.code: each.subject for each in probable_causes(values, [ValidationPlane.of(plane)])
    }


def test_the_probable_cause_of_a_failure_depends_on_the_shifts_of_the_lines(
    project: Project,
) -> None:
    plane = project.validation[0]
    limit = {"rms": 0.5 * plane.after.rms, "offset": 1e-5}
    lines = tuple(dict.fromkeys(name for p in plane.pairs for name in (p.line_a, p.line_b)))
    within = LineShift(lines[:1], lines[1:], 0.01, 0.004)
    beyond = LineShift(lines[:1], lines[1:], 0.1, 0.01)
    opposite = replace(beyond, lines=lines[:2], others=lines[2:], reciprocal=True)
    assert causes_of(project, (within,), rms=1.0) == {}
    assert causes_of(project, (within,), **limit) == {
        "acceptance.cause_pos": Cause.of_field("position_sigma")
    }
    judged = replace(project, validation=(replace(plane, shifts=(within,)),))
    values = AcceptanceValues.of(judged.with_acceptance(AcceptanceCriteria(**limit)).judgement)
    (cause,) = probable_causes(values, [ValidationPlane.of(judged.validation[0])])
    (shifts,) = cause.params["planes"]
    assert shifts.params["target"] == plane.name
    (shift,) = shifts.params["lines"]
    assert shift.params == {"line": lines[0], "shift": 0.01}
    assert cause.params["ratio"] == 2.5
    assert causes_of(project, (within, beyond), **limit) == {
        "validation.line_shifted": Cause.of_line(lines[0])
    }
    assert causes_of(project, (opposite,), **limit) == {
        "validation.directions_shifted": Cause.of_page("Cross-checks")
    }
    assert set(causes_of(project, (), **limit)) == {"acceptance.cause_unknown"}
    assert causes_of(project, (within,), yaw_sigma_deg=1e-5) == {
        "acceptance.cause_geometry": Cause.of_step("Targets")
    }


def test_an_rms_without_offsets_is_caused_by_the_scatter_of_the_points(project: Project) -> None:
    plane = project.validation[0]
    signed = plane.pairs[0].after.signed
    pairs = tuple(
        replace(pair, after=replace(pair.after, signed=replace(signed, median=1e-4)))
        for pair in plane.pairs
    )
    changed = replace(project, validation=(replace(plane, pairs=pairs), *project.validation[1:]))
    shift = LineShift(("L1",), ("L2",), 1e-4, 1e-3)
    assert causes_of(changed, (shift,), rms=0.5 * plane.after.rms) == {
        "acceptance.cause_scatter": Cause.of_target(plane.name)
    }


# -- report ----------------------------------------------------------------------------------------


def failed_criteria(content: ReportContent) -> dict[str, Mapping[str, Any]]:
    """Parameters of each criterion in the warning about those that are not met, by their codes."""
    (message,) = [each for each in content.warnings if each.code == "acceptance.not_met"]
    return {each.code: each.params for each in message.params["criteria"]}


def content_with(project: Project, **criteria: object) -> ReportContent:
    return sample_content(project.with_acceptance(NO_CRITERIA.changed(**criteria)))


def test_a_report_fails_with_the_criterion_the_value_and_the_limit(project: Project) -> None:
    rms = max(plane.after.rms for plane in project.validation)
    content = content_with(project, rms=rms / 2, yaw_sigma_deg=0.02, source="Contract 4.2")
    found = failed_criteria(content)
    assert set(found) == {"acceptance_failure.angle", "acceptance_failure.rms"}
    assert found["acceptance_failure.angle"]["value"] == pytest.approx(np.radians(SIGMA_DEG[2]))
    assert found["acceptance_failure.angle"]["limit"] == pytest.approx(np.radians(0.02))
    failing = {plane.name for plane in project.validation if plane.after.rms > rms / 2}
    assert set(found["acceptance_failure.rms"]["planes"]) == failing
    assert found["acceptance_failure.rms"]["value"] == rms
    (message,) = [each for each in content.warnings if each.code == "acceptance.not_met"]
    assert message.is_serious
    document = undrawn_document(content, {}, FULL_REPORT)
    assert document.status == "bad"
    french = undrawn_document(content, {}, ReportOptions(language="fr", extent="full"))
    assert french.status == "bad"
    values = json.loads(json_text(content))["acceptance"]
    assert values["verdict"] == "fail"
    assert values["criteria"]["source"] == "Contract 4.2"
    assert {each["unit"] for each in values["checks"]} == {"deg", "m"}
    assert len(values["planes"]) == len(project.validation)


def test_warnings_and_table_give_a_value_with_the_same_decimals(project: Project) -> None:
    content = content_with(project, rms=1.23456e-3, offset=3e-5, yaw_sigma_deg=0.00123)
    failed = [each for each in content.acceptance.checks if each.verdict == "fail"]
    assert {each.quantity for each in failed} == {"rms", "offset", "yaw"}
    texts = [message_text(each) for each in content.warnings if each.code.startswith("acceptance.")]
    for check in failed:
        # The warning gives the largest value of each criterion
        if check.value != max(x.value for x in failed if x.quantity == check.quantity):
            continue
        numbers = [
            cell_text(column, check).replace("\u00a0", " ")
            for column in (MEASURED_COLUMN, LIMIT_COLUMN)
        ]
        assert any(all(number in text for number in numbers) for text in texts), numbers
        assert not cell_text(LIMIT_COLUMN, check).startswith("0.0\u00a0mm")


def test_the_table_of_planes_gives_the_largest_offset_and_its_lines(project: Project) -> None:
    plane = project.validation[0]
    first, *others = plane.pairs
    assert first.after.signed is not None
    lines = f"{first.line_a} / {first.line_b}"
    signed = replace(first.after.signed, median=-0.04321)
    far = replace(first, after=replace(first.after, signed=signed))
    judged = replace(project, validation=(replace(plane, pairs=(far, *others)),)).with_acceptance(
        AcceptanceCriteria(offset=0.01)
    )
    for options in (FULL_REPORT, ReportOptions()):
        summary = undrawn_document(sample_content(judged), {}, options).summary
        (table,) = (
            each for each in summary if isinstance(each, Table) and "Validation:" in each.title
        )
        (row,) = table.rows
        assert {"43.2", lines, "fail"} <= set(row)


def test_a_pass_by_some_criteria_says_how_many_are_given(project: Project) -> None:
    some = project.with_acceptance(AcceptanceCriteria(rms=1.0, offset=1.0))
    every = AcceptanceCriteria(1.0, 1.0, 1.0, 1.0, 1.0, 1.0)
    assert "2 OF 6" in undrawn_document(sample_content(some), {}, FULL_REPORT).verdict
    full = undrawn_document(sample_content(project.with_acceptance(every)), {}, FULL_REPORT)
    assert "OF 6" not in full.verdict
    assert calibration_verdict_text(AcceptanceValues.of(some.judgement)).startswith("pass (2 of 6")
    passed = AcceptanceValues.of(project.with_acceptance(every).judgement)
    assert calibration_verdict_text(passed) == "pass"


def test_one_criterion_is_singular_in_french(project: Project) -> None:
    with in_language("fr"):
        for criteria, words in (({"rms": 1.0}, "critère"), ({"rms": 1.0, "p95": 1.0}, "critères")):
            judged = project.with_acceptance(AcceptanceCriteria(**criteria))
            text = verdict_scope_text(AcceptanceValues.of(judged.judgement))
            assert words in text.split()


def test_a_criterion_has_its_largest_value_and_the_planes_that_meet_it(project: Project) -> None:
    rms = {plane.name: plane.after.rms for plane in project.validation}
    least, *_, most = sorted(rms, key=lambda name: rms[name])
    for limit, failing in (
        (0.5 * rms[least], set(rms)),
        (0.5 * (rms[least] + rms[most]), {x for x in rms if 2 * rms[x] > rms[least] + rms[most]}),
        (2.0 * rms[most], set()),
    ):
        values = content_with(project, rms=limit).acceptance
        (result,) = criterion_results(values)
        assert (result.value, result.place, result.limit) == (rms[most], most, limit)
        assert result.verdict == ("fail" if failing else "pass")
        assert set(result.planes) == (failing or {most})
        assert (result.planes_met, result.planes_judged) == (len(rms) - len(failing), len(rms))
        assert {name for name in rms if failed_texts(values, name)} == failing
        for name in failing if limit < rms[least] else ():
            (text,) = failed_texts(values, name)
            assert f"{1e3 * rms[name]:.1f}\u00a0mm" in text
            assert f"{1e3 * limit:.1f}\u00a0mm" in text


def test_the_table_of_criteria_has_one_row_each(project: Project) -> None:
    criteria = {"rms": 1e-3, "p95": 1e-3, "offset": 1e-3, "yaw_sigma_deg": 1.0}
    for options in (FULL_REPORT, ReportOptions()):
        summary = undrawn_document(content_with(project, **criteria), {}, options).summary
        table = _table(summary, "Acceptance criteria")
        assert [row[-1] for row in table.rows] == ["pass", "fail", "fail", "fail"]
        assert [row[-2] for row in table.rows] == ["", *[f"0 of {len(project.validation)}"] * 3]


def test_each_value_beyond_its_limit_is_marked_in_the_table_of_the_planes(project: Project) -> None:
    rms = [plane.after.rms for plane in project.validation]
    limit = 0.5 * (min(rms) + max(rms))
    for criteria, expected in (
        ({}, set()),
        ({"rms": 1.0}, set()),
        ({"rms": limit}, {(k, "RMS\nafter") for k, value in enumerate(rms) if value > limit}),
        ({"p95": 1e-4}, {(k, "95 %\nafter") for k in range(len(rms))}),
    ):
        summary = undrawn_document(content_with(project, **criteria), {}, ReportOptions()).summary
        table = _table(summary, "Validation:")
        marked = {(row, table.columns[column].title) for row, column in table.marked}
        assert marked == expected
        legends = [b for b in summary if isinstance(b, Paragraph) and b.text.startswith("* ")]
        assert len(legends) == bool(expected)
        assert not any("*" in cell for row in table.plain_rows for cell in row)


def test_the_cause_is_below_the_criteria_that_are_not_met(project: Project) -> None:
    for options in (FULL_REPORT, ReportOptions()):
        content = content_with(project, rms=1e-4)
        codes = [each.code for each in content.warnings]
        causes = [each for each in content.warnings if each.code.startswith("acceptance.cause_")]
        assert causes, "the sample has no shifts, so the cause is not known"
        assert "acceptance.not_met" in codes
        document = undrawn_document(content, {}, options)
        failure = next(each for each in content.warnings if each.code == "acceptance.not_met")
        place = document.warnings.index(message_text(failure))
        assert document.warnings[place + 1 : place + 1 + len(causes)] == tuple(
            map(message_text, causes)
        )
        assert not set(document.notes) & set(map(message_text, causes))


def _table(blocks: Iterable[Block], title: str) -> Table:
    (table,) = (each for each in blocks if isinstance(each, Table) and each.title.startswith(title))
    return table


def test_only_a_pass_without_messages_is_good(project: Project) -> None:
    passed = content_with(project, rms=1.0, yaw_sigma_deg=1.0)
    not_judged = content_with(project)
    assert passed.acceptance.verdict == "pass"
    assert not_judged.acceptance.verdict == "not judged"
    assert not any(each.code.startswith("acceptance.") for each in not_judged.warnings)
    status = [
        undrawn_document(replace(content, warnings=()), {}, FULL_REPORT).status
        for content in (passed, not_judged)
    ]
    assert status == ["good", "fair"]


def test_a_criterion_that_could_not_be_judged_has_a_note(project: Project) -> None:
    content = content_with(replace(project, validation=()), rms=0.03)
    assert "acceptance.not_judged" in {each.code for each in content.warnings}
    partly = project.with_validation(project.validation, {"V9": note("project.single_target")})
    (found,) = [
        each
        for each in content_with(partly, rms=1.0).warnings
        if each.code == "acceptance.planes_not_judged"
    ]
    assert list(found.params["planes"]) == ["V9"]
    assert not found.is_serious


def test_planes_that_failed_are_shown_before_planes_with_a_larger_rms() -> None:
    rms = {"V1": 0.03, "V2": 0.05, "V3": 0.01, "V4": 0.04}
    assert planes_to_show(rms, {"V3"}, 2) == {"V3", "V2"}
    assert planes_to_show(rms, (), 3) == {"V1", "V2", "V4"}
    assert planes_to_show(rms, (), 9) == set(rms)


def test_a_verdict_names_the_number_of_excluded_planes(project: Project) -> None:
    names = [target.name for target in project.targets_of_role("validation")][:2]
    left = tuple(each for each in project.validation if each.name not in names)
    targets = tuple(replace(each, used=each.name not in names) for each in project.targets)
    limits = AcceptanceCriteria(1.0, 1.0, 1.0, 1.0, 1.0, 1.0)
    every = replace(project.with_acceptance(limits), targets=targets, validation=left)
    content = sample_content(every)
    assert content.acceptance.excluded_planes == tuple(names)
    document = undrawn_document(content, {}, FULL_REPORT)
    assert "2 VALIDATION PLANES EXCLUDED" in document.verdict
    assert document.status != "good"
    assert "2 validation planes excluded" in calibration_verdict_text(content.acceptance)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_failed_value_is_never_written_like_its_limit(project: Project, language: str) -> None:
    plane = project.validation[0]
    first, *others = plane.pairs
    assert first.after.signed is not None
    signed = replace(first.after.signed, median=0.030031)
    near = replace(first, after=replace(first.after, signed=signed))
    after = replace(plane.after, rms=0.0300004, p95=0.05)
    judged = replace(
        project, validation=(replace(plane, pairs=(near, *others), after=after),)
    ).with_acceptance(
        AcceptanceCriteria(roll_sigma_deg=SIGMA_DEG[0] - 1e-6, rms=0.03, p95=0.05, offset=0.03)
    )
    content = sample_content(judged)
    shown = {
        check.quantity: tuple(
            cell_text(column, check).replace("\u00a0", " ")
            for column in (MEASURED_COLUMN, LIMIT_COLUMN)
        )
        for check in content.acceptance.checks
        if check.plane in ("", plane.name)
    }
    assert shown == {
        "roll": ("0.016300°", "0.016299°"),
        "rms": ("30.0004 mm", "30.0000 mm"),
        "p95": ("50.0 mm", "50.0 mm"),  # equal to its limit, and passed
        "offset": ("30.03 mm", "30.00 mm"),
    }
    with in_language(language):
        texts = [
            message_text(each) for each in content.warnings if each.code.startswith("acceptance.")
        ]
        limits = [("0.016300", "0.016299"), ("30.0004", "30.0000"), ("30.03", "30.00")]
        for numbers in limits:
            expected = {n.replace(".", "," if language == "fr" else ".") for n in numbers}
            assert any(all(number in text for number in expected) for text in texts), numbers
    (failed,) = [text for text in failed_texts(content.acceptance, plane.name) if "30.03" in text]
    assert "30.00\u00a0mm" in failed


def test_a_value_beyond_its_limit_differs_in_the_units_of_the_window(project: Project) -> None:
    message = note("acceptance_failure.rms", planes=("V1",), value=0.03048004, limit=0.03048)
    use_units({"mm": ShownUnit("ft", 1 / 304.8, finer=2)})
    try:
        assert "0.1000001" in message_text(message)
        assert "0.1000000" in message_text(message)
    finally:
        use_units({})


def test_a_test_statistic_beyond_its_bound_is_not_written_like_the_bound(project: Project) -> None:
    adjustment = sample_content(project).adjustment
    assert adjustment is not None
    degrees = adjustment.degrees_of_freedom
    test = replace(adjustment.chi_square, statistic=1100.04, lower=900.0, upper=1100.01)
    beyond = replace(adjustment, chi_square=test, variance_factor=1100.04 / degrees)
    factor, interval, statistic, _ = (fact.text for fact in chi_square_facts(beyond))
    assert "1,100.04" in statistic
    assert "1,100.01" in statistic
    number, upper = factor.split()[0], interval.split()[-1]
    assert float(number) > float(upper)
