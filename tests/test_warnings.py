"""The list of everything to be warned of: what is in it, and where its causes lie."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.doubts import doubts
from lispac.adjustment.older import refused_since
from lispac.adjustment.shown import plain
from lispac.causes import Cause
from lispac.cli.main import main
from lispac.project import PickedSighting, Project, Target
from lispac.report.cautions import cautions_of
from lispac.survey.lever_arm import lever_arm_doubts
from lispac.workflow.projects import open_project
from lispac.workflow.qualities import qualities
from lispac.workflow.survey import load_survey
from lispac.workflow.warnings import SINGLE, STALE, TOLD_ONE_BY_ONE, concerns
from tests.few_passes import picked
from tests.report_sample import sample_content, sample_project


def said(project: Project, **named) -> dict[str, tuple[str, Cause]]:
    return {each.text: (each.severity, each.cause) for each in concerns(project, None, **named)}


def full_of_cautions(tmp_path: Path) -> Project:
    """A target left out, one on a single line, a failed test, no validation, a truth."""
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


def test_it_says_what_the_report_says_in_its_words(tmp_path: Path) -> None:
    """Every caution of the report is in the list, but for sums of what stands in it one by one."""
    project = full_of_cautions(tmp_path)
    told = said(project)
    codes = set()
    for caution in sample_content(project).cautions:
        if caution.code not in TOLD_ONE_BY_ONE:
            codes.add(caution.code)
            assert told[caution.text][0] == caution.severity, caution
    expected = {"left_out", "single_line_targets", "not_validated", "simulated", "chi_square_high"}
    assert expected <= codes


def test_every_doubt_about_an_answer_is_in_it_with_its_cause(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    assert project.result is not None
    result = replace(project.result, model=replace(project.result.model, pos_errors="independent"))
    thesis = replace(project, result=result)
    found = {doubt.text: doubt for doubt in doubts(result, thesis.cross_checks)}
    told = said(thesis)
    assert found
    for text, doubt in found.items():
        assert told[text] == ("serious" if doubt.serious else "caution", doubt.cause)
    mode = next(doubt for doubt in found.values() if doubt.code == "independent_pos_errors")
    assert mode.cause == Cause.of_field("pos_errors")


def test_serious_things_come_first(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    order = ["serious", "caution", "note"]
    found = concerns(project, None, refusal="No target is left.")
    ranks = [order.index(each.severity) for each in found]
    assert ranks == sorted(ranks)
    assert found[0].text == "No target is left."
    assert found[0].cause == Cause.of_step("Adjust")


def test_an_answer_older_than_a_refused_estimate_is_told_of(tmp_path: Path) -> None:
    told = said(sample_project(tmp_path), refused_since="All targets face one way.")
    doubt = refused_since("All targets face one way.")
    assert told[doubt.text] == ("serious", Cause("result"))
    assert doubt.code == "refused_since"
    assert "was refused: All targets face one way. The angles are those of" in doubt.text


def test_a_line_without_the_target_is_named_with_the_reason(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    target = project.targets[0]
    line = project.lines[0].name
    without = replace(
        target,
        sightings=tuple(s for s in target.sightings if s.line != line),
        missing={line: "The line has no points there."},
    )
    severity, cause = said(project.with_target(without))[
        f"{target.name} on {line}: The line has no points there."
    ]
    assert (severity, cause) == ("note", Cause.of_sighting(target.name, line))


def test_the_same_points_twice_lead_to_where_they_are(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    numbers = np.arange(500)
    twins = [
        Target(
            name, "target", (0.0, 0.0, 0.0), 0.01, 1.0,
            (PickedSighting(project.lines[1].name, numbers, 0.003),),
        )
        for name in ("A", "B")
    ]  # fmt: skip
    edited = replace(project, targets=())
    for each in twins:
        edited = edited.with_target(each)
    causes = [c for text, (_, c) in said(edited).items() if "points in common" in text]
    assert causes == [Cause.of_sighting("A", project.lines[1].name)]


def test_what_is_known_of_the_keeping_comes_first_as_serious(tmp_path: Path) -> None:
    words = "The project could not be saved: the disk is full."
    first = concerns(sample_project(tmp_path), None, storage=words)[0]
    assert (first.severity, first.text, first.cause) == ("serious", words, Cause.of_step("Data"))


@pytest.mark.parametrize(("stale", "estimated"), [(True, False), (False, False), (True, True)])
def test_an_answer_that_an_edit_has_dropped_is_missed(
    tmp_path: Path, stale: bool, estimated: bool
) -> None:
    """Until there is another one, and not before there was any."""
    project = sample_project(tmp_path)
    project = project if estimated else replace(project, result=None, validation=())
    told = said(project, stale=stale)
    assert (STALE in told) == (stale and not estimated)
    if STALE in told:
        assert told[STALE] == ("caution", Cause.of_step("Adjust"))


def test_a_single_target_is_told_before_it_is_adjusted(tmp_path: Path) -> None:
    project = replace(sample_project(tmp_path), result=None, validation=())
    assert SINGLE not in said(project)
    alone = replace(
        project, targets=(replace(project.targets[0], used=False), *project.targets[1:])
    )
    assert said(alone)[SINGLE] == ("caution", Cause.of_target("T2"))


def test_planes_that_could_not_be_compared_are_each_told_with_the_reason(tmp_path: Path) -> None:
    project = sample_project(tmp_path)
    reasons = {"V4": "V4: no two lines share a place.", "V5": "V5: one line only."}
    told = said(project.with_validation(project.validation, reasons))
    for name, reason in reasons.items():
        assert told[reason] == ("caution", Cause.of_target(name))


def test_gaps_of_the_trajectory_are_told_where_they_are_not_bridged() -> None:
    project, survey = picked()
    time = survey.trajectory.time.copy()
    time[len(time) // 2 :] += 7.0
    torn = replace(survey, trajectory=replace(survey.trajectory, time=time))
    told = {each.text: (each.severity, each.cause) for each in concerns(project, torn)}
    sentence = (
        "The trajectory has 1 gap longer than 1.5 s, the longest 7.0 s; points in gaps cannot be "
        "used."
    )
    assert told[sentence] == ("caution", Cause.of_step("Data"))
    patient = project.with_settings(replace(project.settings, longest_gap=10.0))
    assert not any("gap" in each.text for each in concerns(patient, torn))


def test_a_sighting_that_is_not_good_is_told_where_it_is() -> None:
    project, survey = picked()
    found = dict(qualities(project, survey))
    where = ("T2", "L3")
    found = {key: replace(each, light="good", reasons=()) for key, each in found.items()}
    found[where] = replace(found[where], light="poor", reasons=("It is seen at 81 deg.",))
    told = [each for each in concerns(project, survey, found) if each.cause.kind == "sighting"]
    assert [each.text for each in told] == [f"T2 on L3: {found[where].words}"]
    assert told[0].cause == Cause.of_sighting(*where)


@pytest.mark.parametrize(
    ("lever_arm", "words"),
    [
        ((0.0, 0.0, 0.0), ["is zero"]),
        ((1.2, 0.3, -2.1), ["2.10 m below"]),
        ((0.3, -0.2, -0.4), []),  # of a drone
        ((1.2, 0.3, 2.1), []),
        ((1200.0, 300.0, -2100.0), ["2100.00 m below", "m long"]),  # typed in millimetres
        ((-28.0, 4.0, 12.0), ["30.7 m long"]),
    ],
)
def test_a_lever_arm_that_is_hardly_ever_true_is_doubted(tmp_path: Path, lever_arm, words) -> None:
    found = lever_arm_doubts(lever_arm)
    assert len(found) == len(words)
    for sentence, part in zip(found, words, strict=True):
        assert part in sentence
    project = sample_project(tmp_path)
    edited = project.with_settings(replace(project.settings, lever_arm=lever_arm))
    told = [c for c in concerns(edited, None) if c.cause == Cause.of_field("lever_arm")]
    assert tuple(each.text for each in told) == found


def test_the_command_prints_the_list(
    demo_project: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    project, survey = open_project(demo_project.folder), load_survey(demo_project)
    found = concerns(project, survey, qualities(project, survey))
    assert main(["warnings", str(demo_project.folder)]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed == [f"{each.severity}: {plain(each.text)}" for each in found]
    assert main(["warnings", str(demo_project.folder), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)["warnings"]
    assert [each["cause"]["kind"] for each in told] == [each.cause.kind for each in found]
    assert main(["warnings", str(demo_project.folder / "nowhere")]) == 1


def test_a_report_keeps_its_cautions_as_they_were(tmp_path: Path) -> None:
    """What a report holds of them is code, severity and text: its schema knows no cause."""
    content = sample_content(full_of_cautions(tmp_path))
    found = cautions_of(content, ())
    assert found
    assert all(set(vars(each)) == {"code", "severity", "text"} for each in found)
