"""Tests of acceptance criteria on the command line and in scripts."""

from dataclasses import replace
from pathlib import Path

import pytest

import lispac
from lispac.acceptance import NO_CRITERIA, AcceptanceCriteria
from lispac.cli.main import main
from lispac.io.project.project_file import read_project, write_project
from lispac.project import Project
from lispac.workflow.output.script import script_of
from tests.cli.test_cli import run, run_json
from tests.support.command_errors import refused_with
from tests.support.long_runs import LONG
from tests.support.report_sample import sample_project


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    project = sample_project(tmp_path / "harbour")
    write_project(project)
    return project.folder


def test_criteria_are_set_shown_and_removed(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    first = run_json(
        capsys, "acceptance", folder, "--roll-sigma", 0.02, "--rms", 1, "--offset", 1,
        "--source", "Contract 4.2",
    )  # fmt: skip
    assert first["verdict"] == "pass"
    assert {each["verdict"] for each in first["planes"]} == {"pass"}
    assert read_project(folder).acceptance == AcceptanceCriteria(
        roll_sigma_deg=0.02, rms=1.0, offset=1.0, source="Contract 4.2"
    )
    second = run_json(capsys, "acceptance", folder, "--yaw-sigma", 0.001, "--rms", "none")
    assert second["verdict"] == "fail"
    assert second["criteria"]["rms_m"] is None
    (failed,) = [each for each in second["checks"] if each["verdict"] == "fail"]
    assert failed["quantity"] == "yaw"
    assert failed["value"] > failed["limit"] == 0.001
    before = (folder / "project.json").read_bytes()
    assert run_json(capsys, "acceptance", folder) == second
    assert (folder / "project.json").read_bytes() == before


def test_the_exit_code_depends_on_the_verdict_only_if_required(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    assert run(capsys, "acceptance", folder)[0] == 0
    refused_with("cli.acceptance_not_judged", "acceptance", folder, "--require-pass")
    assert run(capsys, "acceptance", folder, "--rms", 0.0001)[0] == 0
    refused_with("cli.not_accepted", "acceptance", folder, "--require-pass")
    assert main(["acceptance", str(folder), "--require-pass"]) == 1
    assert main(["acceptance", str(folder), "--rms", "1", "--require-pass"]) == 0


@pytest.mark.parametrize("word", ["0", "-1", "nan", "much"])
def test_a_limit_that_is_not_positive_is_wrong_usage(folder: Path, word: str) -> None:
    with pytest.raises(SystemExit) as raised:
        main(["acceptance", str(folder), f"--rms={word}"])
    assert raised.value.code == 2
    assert read_project(folder).acceptance == NO_CRITERIA


@LONG
def test_validate_prints_the_verdict_and_its_warnings(
    capsys: pytest.CaptureFixture[str],
    denser_calibrated: tuple[Project, object],
    denser_copy: Project,
) -> None:
    two_planes = denser_copy.targets_of_role("validation")[:2]
    few = replace(denser_copy, targets=(*denser_copy.targets_of_role("target"), *two_planes))
    write_project(few.with_acceptance(NO_CRITERIA.changed(rms=0.005)))
    found = run_json(capsys, "validate", denser_copy.folder)
    assert found["acceptance"]["verdict"] == "fail"
    (message,) = [each for each in found["warnings"] if each["code"] == "acceptance.not_met"]
    (failure,) = message["params"]["criteria"]
    assert failure["code"] == "acceptance_failure.rms"
    assert failure["params"]["planes"] == [each["name"] for each in found["validation"]]
    assert len(found["validation"]) == len(two_planes)
    # The demonstration survey has no errors beyond its given accuracies.
    assert not any(each["code"].startswith("validation.") for each in found["warnings"])
    for plane in found["validation"]:
        assert plane["shifts"]
        for shift in plane["shifts"]:
            assert abs(shift["offset_m"]) < 4 * shift["sigma_m"]
        assert [pair["modes"] for pair in plane["pairs"]] == [None] * len(plane["pairs"])


def test_scripts_set_criteria_and_the_script_of_a_project_contains_them(
    demo_project: Project,
) -> None:
    quay = lispac.open(demo_project.folder)
    judgement = quay.acceptance(rms=0.03, source="Contract 4.2")
    assert judgement.verdict == "not judged"
    assert quay.project.acceptance == lispac.AcceptanceCriteria(rms=0.03, source="Contract 4.2")
    text = script_of(quay.project, quay.survey).text
    assert "project.acceptance(rms=0.03, source='Contract 4.2')" in text
