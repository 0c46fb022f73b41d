"""Tests of edits of targets: use, names, roles, and the results that each edit clears."""

from pathlib import Path

import pytest

from lispac.errors import ProjectError
from lispac.project import Project
from lispac.workflow.calibration.edits import (
    set_line_use,
    set_sighting_use,
    set_target_use,
    with_renamed_target,
    with_switched_role,
)
from tests.support.report_sample import sample_project


@pytest.fixture
def project(tmp_path: Path) -> Project:
    return sample_project(tmp_path)


def unused_sightings(project: Project) -> set[tuple[str, str]]:
    return {(t.name, s.line) for t in project.targets for s in t.sightings if not s.used}


def test_excluding_a_line_affects_all_targets_and_no_validation_plane(project: Project) -> None:
    without = set_line_use(project, "L3", False)
    assert unused_sightings(without) == {("T1", "L3"), ("T2", "L3")}
    assert without.result is None
    again = set_line_use(without, "L3", True)
    assert unused_sightings(again) == set()
    assert [t.name for t in again.targets] == [t.name for t in project.targets]


def test_an_edit_without_change_keeps_the_result(project: Project) -> None:
    assert set_target_use(project, "T1", True) is project
    assert set_sighting_use(project, "T1", "L1", True) is project
    assert set_sighting_use(project, "T1", "no such line", False) is project
    assert set_line_use(project, "no such line", False) is project
    without_target = set_target_use(project, "T1", False)
    assert without_target.target("T1").used_sightings == ()
    assert without_target.result is None


def test_a_renamed_target_keeps_its_position(project: Project) -> None:
    renamed = with_renamed_target(project, "T1", "  north board ")
    assert [t.name for t in renamed.targets] == ["north board", "T2", "V1", "V2", "V3"]
    assert renamed.result is None
    plane = with_renamed_target(project, "V2", "tower")
    assert [t.name for t in plane.targets] == ["T1", "T2", "V1", "tower", "V3"]
    assert plane.result is project.result  # not used in the adjustment
    assert [each.name for each in plane.validation] == ["V1", "tower", "V3"]
    assert plane.judgement.planes == ("V1", "tower", "V3")


def test_an_edit_of_a_plane_keeps_the_comparisons_of_the_others(project: Project) -> None:
    compared = {each.name: each for each in project.validation}
    without = set_target_use(project, "V2", False)
    assert without.validation == (compared["V1"], compared["V3"])
    assert dict(without.not_compared) == {}
    again = set_target_use(without, "V2", True)
    assert again.validation == project.validation
    assert dict(again.not_compared) == {}
    line = project.target("V2").sightings[0].line
    edited = set_target_use(set_sighting_use(without, "V2", line, False), "V2", True)
    assert edited.validation == without.validation
    assert {name: each.code for name, each in edited.not_compared.items()} == {
        "V2": "validation.plane_edited"
    }
    assert project.without_target("V2").validation == without.validation
    last = edited.without_target("V1").without_target("V3")
    assert last.validation == ()  # nothing to compare with is the same as no validation
    assert dict(last.not_compared) == {}
    line = project.target("V1").sightings[0].line
    assert set(set_sighting_use(project, "V1", line, False).not_compared) == {"V1"}


@pytest.mark.parametrize(("name", "code"), [(" ", "edit.no_name"), ("V2", "edit.name_taken")])
def test_empty_and_used_names_are_refused(project: Project, name: str, code: str) -> None:
    with pytest.raises(ProjectError) as caught:
        with_renamed_target(project, "T1", name)
    assert caught.value.code == code


def test_a_role_can_be_changed_and_changed_back(project: Project) -> None:
    changed = with_switched_role(project, "T2")
    assert changed.target("T2").role == "validation"
    assert with_switched_role(changed, "T2").target("T2").role == "target"
