"""Tests of the list of all warnings of a project and their causes."""

import json
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.diagnostics.warnings import outdated_result_warning, result_warnings
from lispac.cli.main import main
from lispac.language import in_language, to_plain_text
from lispac.message_texts import message_text
from lispac.message_texts.former_codes import former_code
from lispac.messages import Level, Message, error, note, plain_params, warning
from lispac.project import PickedSighting, Project, Target
from lispac.report.json_report import json_text
from lispac.survey.lever_arm_warnings import lever_arm_warnings
from lispac.targets.sighting_quality import undetermined_quality
from lispac.warning_causes import Cause
from lispac.workflow.calibration.sighting_assessment import sighting_qualities
from lispac.workflow.checking.warnings import SUMMARY_CODES, warnings_of
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey
from tests.support.few_lines import picked
from tests.support.report_sample import sample_content, sample_project


def messages_by_code(project: Project, **named) -> dict[str, Message]:
    """Return the last message of each code."""
    return {each.code: each for each in warnings_of(project, None, **named)}


def with_all_warnings(tmp_path: Path) -> Project:
    """A project with an excluded target, one on a single line, a failed test and no validation."""
    project = sample_project(tmp_path)
    assert project.result is not None
    one, two, *others = project.targets
    alone = tuple(replace(s, used=k == 0) for k, s in enumerate(two.sightings))
    test = replace(project.result.chi_square, statistic=1e9)
    return replace(
        project,
        targets=(replace(one, used=False), replace(two, sightings=alone), *others),
        result=replace(project.result, chi_square=test),
        validation=(),
        truth_deg=(0.0, 0.0, 0.0),
    )


def test_the_list_has_the_messages_of_the_report(tmp_path: Path) -> None:
    """Only summaries of its own items are excluded."""
    project = with_all_warnings(tmp_path)
    found = warnings_of(project, None)
    codes = set()
    for message in sample_content(project).warnings:
        if message.code not in SUMMARY_CODES:
            codes.add(message.code)
            assert message in found
    expected = {
        "report.left_out_target", "targets.single_line_targets", "report.not_validated",
        "report.simulated", "report.chi_square_high",
    }  # fmt: skip
    assert expected <= codes


def test_every_warning_about_a_result_has_its_cause(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    assert project.result is not None
    result = replace(project.result, model=replace(project.result.model, pos_errors="independent"))
    thesis = replace(project, result=result)
    found = result_warnings(result, thesis.cross_checks)
    assert found
    assert set(found) <= set(warnings_of(thesis, None))
    mode = next(each for each in found if each.code == "adjustment.independent_pos_errors")
    assert mode.subject == Cause.of_field("pos_errors")


def test_warnings_come_before_notes(tmp_path: Path) -> None:
    project = with_all_warnings(tmp_path)
    order = list(Level)
    found = warnings_of(project, None, refusal="none left")
    ranks = [order.index(each.level) for each in found]
    assert ranks == sorted(ranks)
    assert len(set(ranks)) > 1
    assert found[0] == warning(
        "project.refused", reason="none left", subject=Cause.of_step("Adjust")
    )


def test_a_refused_estimate_leads_to_its_possible_cause(tmp_path: Path) -> None:
    cause = Cause.of_field("lever_arm")
    reason = error("estimate.possible_cause", reason="none", cause="lever arm", subject=cause)
    found = warnings_of(sample_project(tmp_path), None, refusal=reason)
    assert found[0] == warning("project.refused", reason=reason, subject=cause)


def test_a_result_out_of_date_after_a_refused_estimate_is_reported(tmp_path: Path) -> None:
    reason = "All targets face one way."
    by_code = messages_by_code(sample_project(tmp_path), refused_since=reason)
    assert by_code["adjustment.refused_since"] == outdated_result_warning(reason)
    assert outdated_result_warning(reason) == warning(
        "adjustment.refused_since", reason=reason, subject=Cause("result")
    )


def test_a_line_without_the_target_is_named_with_the_reason(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    target = project.targets[0]
    line = project.lines[0].name
    without = replace(
        target,
        sightings=tuple(s for s in target.sightings if s.line != line),
        missing={line: error("finder.line_no_points", radius=4.5)},
    )
    assert messages_by_code(project.with_target(without))["project.not_found_on_line"] == note(
        "project.not_found_on_line",
        target=target.name, line=line, reason=error("finder.line_no_points", radius=4.5),
        subject=Cause.of_sighting(target.name, line),
    )  # fmt: skip


def test_lines_without_the_target_for_one_reason_are_one_note(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    target = project.targets[0]
    reason, other = error("finder.line_no_points", radius=4.5), error("finder.no_plane")
    without = replace(target, sightings=(), missing={"A": reason, "B": other, "C": reason})
    notes = [
        (each.code, each.params.get("lines", each.params.get("line")))
        for each in warnings_of(project.with_target(without), None)
        if each.params.get("target") == target.name and "reason" in each.params
    ]
    assert notes == [
        ("project.not_found_on_lines", ("A", "C")),
        ("project.not_found_on_line", "B"),
    ]


def test_doubtful_sightings_of_a_target_are_one_note(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    target = project.targets[0]
    first, *_, last = (sighting.line for sighting in target.used_sightings)
    rated = replace(
        undetermined_quality(90, 0.004, note("quality.few_points", count=90)), rating="doubtful"
    )
    worse = replace(rated, reasons=(*rated.reasons, note("quality.oblique", angle=1.2)))
    qualities = {(target.name, first): rated, (target.name, last): worse}
    (found,) = [each for each in warnings_of(project, None, qualities) if "doubtful" in each.code]
    assert found == note(
        "project.doubtful_sightings",
        target=target.name, lines=(first, last), line=last, reasons=worse.reasons,
        subject=Cause.of_sighting(target.name, last),
    )  # fmt: skip
    sparse = replace(rated, reasons=(note("quality.sparse", share=0.5),), coverage=0.5)
    fuller = replace(sparse, coverage=0.6, incidence=0.8)
    qualities = {(target.name, first): sparse, (target.name, last): fuller}
    (found,) = [each for each in warnings_of(project, None, qualities) if "doubtful" in each.code]
    assert found.params["line"] == first, "the incidence is no reason here"


def test_duplicate_points_have_the_place_as_cause(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    numbers = np.arange(500)
    duplicates = [
        Target(
            name, "target", (0.0, 0.0, 0.0), 0.01, 1.0,
            (PickedSighting(project.lines[1].name, numbers, 0.003),),
        )
        for name in ("A", "B")
    ]  # fmt: skip
    edited = replace(project, targets=())
    for each in duplicates:
        edited = edited.with_target(each)
    found = messages_by_code(edited)["targets.counted_twice"]
    assert found.subject == Cause.of_sighting("A", project.lines[1].name)


def test_warnings_about_saving_come_first(tmp_path: Path) -> None:
    words = "The project could not be saved: the disk is full."
    first = warnings_of(sample_project(tmp_path), None, storage=words)[0]
    assert first == warning("project.storage", reason=words, subject=Cause.of_step("Data"))


@pytest.mark.parametrize(
    ("is_outdated", "estimated"), [(True, False), (False, False), (True, True)]
)
def test_a_result_dropped_by_an_edit_is_reported(
    tmp_path: Path, is_outdated: bool, estimated: bool
) -> None:
    """Only after there was a result, and until there is another."""
    project = sample_project(tmp_path)
    project = project if estimated else replace(project, result=None, validation=())
    found = messages_by_code(project, outdated=is_outdated).get("project.out_of_date")
    expected = note("project.out_of_date", subject=Cause.of_step("Adjust"))
    assert found == (expected if is_outdated and not estimated else None)


def test_a_single_target_is_reported_before_it_is_adjusted(tmp_path: Path) -> None:
    project = replace(sample_project(tmp_path), result=None, validation=())
    code = "project.single_target"
    assert code not in messages_by_code(project)
    alone = replace(
        project, targets=(replace(project.targets[0], used=False), *project.targets[1:])
    )
    assert messages_by_code(alone)[code] == note(code, subject=Cause.of_target("T2"))


def test_planes_that_could_not_be_compared_are_reported_with_the_reason(
    tmp_path: Path,
) -> None:
    project = sample_project(tmp_path)
    reasons = {name: error("finder.unknown_line", line=name) for name in ("V4", "V5")}
    found = warnings_of(project.with_validation(project.validation, reasons), None)
    for name, reason in reasons.items():
        expected = note("report.not_compared", reason=reason, subject=Cause.of_target(name))
        assert expected in found


def test_gaps_of_the_trajectory_that_are_not_bridged_are_reported() -> None:
    project, survey = picked()
    time = survey.trajectory.time.copy()
    time[len(time) // 2 :] += 7.0
    with_gap = replace(survey, trajectory=replace(survey.trajectory, time=time))
    code = "project.trajectory_gaps"
    (gap,) = [each for each in warnings_of(project, with_gap) if each.code == code]
    assert (gap.level, gap.subject) == (Level.NOTE, Cause.of_step("Data"))
    assert (gap.params["count"], gap.params["limit"]) == (1, 1.5)
    assert gap.params["longest"] == pytest.approx(7.0, abs=0.1)
    bridging = project.with_settings(replace(project.settings, longest_gap=10.0))
    assert code not in [each.code for each in warnings_of(bridging, with_gap)]


def test_a_sighting_that_is_not_good_has_its_place_as_cause() -> None:
    project, survey = picked()
    found = dict(sighting_qualities(project, survey))
    where = ("T2", "L3")
    found = {key: replace(each, rating="good", reasons=()) for key, each in found.items()}
    found[where] = replace(
        found[where], rating="poor", reasons=(note("quality.oblique", angle=1.41),)
    )
    code = "project.poor_sighting"
    (message,) = [each for each in warnings_of(project, survey, found) if each.code == code]
    assert message.params["reasons"] == found[where].reasons
    assert message.subject == Cause.of_sighting(*where)


@pytest.mark.parametrize(
    ("lever_arm", "words"),
    [
        ((0.0, 0.0, 0.0), ["is zero"]),
        ((1.2, 0.3, -2.1), ["2.10 m below"]),
        ((0.3, -0.2, -0.4), []),  # of a drone
        ((1.2, 0.3, 2.1), []),
        ((1200.0, 300.0, -2100.0), ["2,100.00 m below", "m long"]),  # typed in millimetres
        ((-28.0, 4.0, 12.0), ["30.7 m long"]),
    ],
)
def test_an_improbable_lever_arm_gives_a_warning(tmp_path: Path, lever_arm, words) -> None:
    found = lever_arm_warnings(lever_arm)
    assert len(found) == len(words)
    for message, part in zip(found, words, strict=True):
        assert part in message_text(message)
    project = sample_project(tmp_path)
    edited = project.with_settings(replace(project.settings, lever_arm=lever_arm))
    field = Cause.of_field("lever_arm")
    assert tuple(each for each in warnings_of(edited, None) if each.subject == field) == found


def test_the_command_prints_the_list(
    demo_project: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    project, survey = open_project(demo_project.folder), load_survey(demo_project)
    found = warnings_of(project, survey, sighting_qualities(project, survey))
    assert main(["warnings", str(demo_project.folder)]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed == [f"{each.level}: {to_plain_text(message_text(each))}" for each in found]
    assert main(["warnings", str(demo_project.folder), "--json"]) == 0
    values = json.loads(capsys.readouterr().out)["warnings"]
    subjects = [each.subject for each in found]
    assert [each["subject"] and each["subject"]["kind"] for each in values] == [
        each and each.kind for each in subjects
    ]
    assert [each["code"] for each in values] == [each.code for each in found]
    assert [each["level"] for each in values] == [each.level for each in found]
    assert main(["warnings", str(demo_project.folder / "nowhere")]) == 1


def test_json_report_has_code_severity_text_and_parameters(tmp_path: Path) -> None:
    """Texts are always in English."""
    content = sample_content(with_all_warnings(tmp_path))
    with in_language("fr"):
        warnings = json.loads(json_text(content))["warnings"]
    assert warnings
    for each, message in zip(warnings, content.warnings, strict=True):
        assert each == {
            "code": message.code,
            "former_code": former_code(message),
            "level": message.level,
            "text": message_text(message),
            "params": plain_params(message),
            "subject": None if message.subject is None else asdict(message.subject),
            "actions": [asdict(action) for action in message.actions],
        }
