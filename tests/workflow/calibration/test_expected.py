"""Tests of the expected size and inclination of targets: storage and comparison."""

import json
from math import pi, radians

import pytest

from lispac.cli.main import main
from lispac.errors import ProjectError
from lispac.io.project.project_file import read_project, write_project
from lispac.project import Project
from lispac.targets.expected_target import ExpectedTarget
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.sighting_assessment import assess_target, unexpected_deviations
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.survey import Survey
from tests.support.command_errors import command_error
from tests.support.message_codes import codes

BOARD = ExpectedTarget(1.23, 1.22, pi / 2)


def test_a_board_of_unexpected_size_is_reported(
    denser_calibrated: tuple[Project, Survey],
) -> None:
    project, survey = denser_calibrated
    _, seed = demo_seeds()["T1"]
    found = find_target(project, survey, seed, name="T9", expected=BOARD)
    assert found.expected == BOARD
    assert unexpected_deviations(found, survey) == {}
    other = ExpectedTarget(2.0, 1.22, radians(45))
    wrong = find_target(project, survey, seed, name="T9", expected=other)
    assert set(unexpected_deviations(wrong, survey)) == {
        sighting.line for sighting in wrong.sightings
    }
    for quality in assess_target(project, survey, wrong).values():
        assert quality.rating != "good"
        assert {"quality.narrower", "quality.steeper"} <= set(codes(quality.reasons))


def test_the_command_compares_and_stores_the_expected_size(
    copy: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    _, seed = demo_seeds()["T1"]
    place = ["pick", str(copy.folder), "--seed", *map(str, seed), "--name", "T1"]
    assert main([*place, "--expected", "1.23", "1.22", "45", "--json"]) == 0
    lines = json.loads(capsys.readouterr().out)["lines"]
    for values in lines.values():
        assert "quality.steeper" in [each["code"] for each in values["quality"]["reasons"]]
    expected = read_project(copy.folder).target("T1").expected
    assert expected == ExpectedTarget(1.23, 1.22, radians(45))
    refusal = command_error(*place, "--expected", "0", "1.22", "45")
    assert refusal.code == "finder.expected_size"
    assert main([*place, "--shape", "sphere", "--expected", "1", "1", "45"]) != 0
    assert "--expected applies to planes only" in capsys.readouterr().err


def test_a_project_file_may_omit_the_expected_size_and_a_wrong_one_is_refused(
    copy: Project,
) -> None:
    path = copy.folder / "project.json"
    write_project(copy)
    content = json.loads(path.read_text())
    for target in content["targets"]:
        assert target.pop("expected") is None
    path.write_text(json.dumps(content))
    assert read_project(copy.folder).targets[0].expected is None
    content["targets"][0]["expected"] = {"width": -1.0, "height": 1.0, "inclination": None}
    path.write_text(json.dumps(content))
    with pytest.raises(ProjectError):
        read_project(copy.folder)
