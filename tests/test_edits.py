"""Edits of targets: what takes part, names, roles, and which results each of them drops."""

from pathlib import Path

import pytest

from lispac.errors import ProjectError
from lispac.project import Project
from lispac.workflow.calibration.edits import (
    with_renamed_target,
    with_switched_role,
    with_use_of_line,
    with_use_of_sighting,
    with_use_of_target,
)
from tests.report_sample import sample_project


@pytest.fixture
def project(tmp_path: Path) -> Project:
    return sample_project(tmp_path)


def unused(project: Project) -> set[tuple[str, str]]:
    return {(t.name, s.line) for t in project.targets for s in t.sightings if not s.used}


def test_a_line_is_excluded_from_all_targets_and_from_no_validation_plane(project: Project) -> None:
    without = with_use_of_line(project, "L3", False)
    assert unused(without) == {("T1", "L3"), ("T2", "L3")}
    assert without.result is None
    again = with_use_of_line(without, "L3", True)
    assert unused(again) == set()
    assert [t.name for t in again.targets] == [t.name for t in project.targets]


def test_what_is_so_already_keeps_the_answer(project: Project) -> None:
    assert with_use_of_target(project, "T1", True) is project
    assert with_use_of_sighting(project, "T1", "L1", True) is project
    assert with_use_of_sighting(project, "T1", "no such line", False) is project
    assert with_use_of_line(project, "no such line", False) is project
    left_out = with_use_of_target(project, "T1", False)
    assert left_out.target("T1").used_sightings == ()
    assert left_out.result is None


def test_a_new_name_stands_in_the_old_place(project: Project) -> None:
    renamed = with_renamed_target(project, "T1", "  north board ")
    assert [t.name for t in renamed.targets] == ["north board", "T2", "V1", "V2", "V3"]
    assert renamed.result is None
    plane = with_renamed_target(project, "V2", "tower")
    assert [t.name for t in plane.targets] == ["T1", "T2", "V1", "tower", "V3"]
    assert plane.result is project.result  # no part in the adjustment
    assert plane.validation == ()


@pytest.mark.parametrize(("name", "code"), [(" ", "edit.no_name"), ("V2", "edit.name_taken")])
def test_names_that_cannot_be_given_are_refused(project: Project, name: str, code: str) -> None:
    with pytest.raises(ProjectError) as caught:
        with_renamed_target(project, "T1", name)
    assert caught.value.code == code


def test_a_role_is_changed_to_and_fro(project: Project) -> None:
    changed = with_switched_role(project, "T2")
    assert changed.target("T2").role == "validation"
    assert with_switched_role(changed, "T2").target("T2").role == "target"
