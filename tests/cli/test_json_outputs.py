"""Tests of the JSON of all commands: it follows the published schema and agrees with the report."""

import argparse
import json
import re
import shutil
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import replace
from importlib import import_module
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jsonschema import Draft202012Validator, ValidationError

from lispac.cli.json_outputs import OUTPUTS, ImportedLineOutput
from lispac.cli.main import main
from lispac.cli.parser import COMMANDS
from lispac.cli.planning import demo
from lispac.project import Project
from lispac.simulation.thesis_site import MARINE_SITE
from lispac.workflow.calibration.proposals import Proposal
from lispac.workflow.project.projects import save_project
from lispac.workflow.project.survey import Survey
from tests.cli.test_cli import import_workflow, run, run_json
from tests.documents.schemas import COMMANDS_PATH, commands_schema_text, followed_output
from tests.support.long_runs import LONG, others_long

import_workflow()
PLAN = Path(__file__).parents[1] / "data" / "port-plan.toml"
Words = Callable[[Project, Path], tuple[object, ...]]


def seed_list(folder: Path) -> Path:
    path = folder / "seeds.csv"
    path.write_text("name,x,y,z,role\nS1,1.15,-14.7,8.1,target\n")
    return path


def check_points(folder: Path) -> Path:
    path = folder / "points.csv"
    path.write_text("name,x,y,z\nP1,1.15,-14.7,8.1\nP2,-1.1,-14.38,7.7\nP3,29.75,-24.6,5.0\n")
    return path


def twin(project: Project) -> Path:
    """Copy of a project under another name."""
    folder = project.folder.with_name("twin")
    shutil.copytree(project.folder, folder)
    return folder


def few_lines(project: Project, count: int = 3) -> Path:
    """Reduce a project to some lines without targets; return its folder."""
    lines = project.lines[:count]
    few = replace(project, lines=lines, targets=(), result=None, cross_checks=None, validation=())
    save_project(few)
    return few.folder


def few_targets(project: Project) -> Path:
    """Reduce a calibrated project to two targets and a validation plane; return its folder."""
    targets = [*project.targets_of_role("target")[:2], *project.targets_of_role("validation")[:1]]
    save_project(replace(project, targets=tuple(targets), validation=()))
    return project.folder


WORDS: dict[str, Words] = {
    "simulate": lambda p, f: ("marine", "--output", f / "s", "--points-per-second", 5_000),
    "simulate --list": lambda p, f: ("--list",),
    "sensors": lambda p, f: (),
    "inspect": lambda p, f: (p.trajectory,),
    "inspect a line": lambda p, f: (p.lines[0].path,),
    "import": lambda p, f: (p.folder, "--lines", p.lines[0].name),
    "pick a list": lambda p, f: (p.folder, "--seeds", seed_list(f)),
    "propose": lambda p, f: (few_lines(p),),
    "control": lambda p, f: (p.folder, check_points(f), "--sigma", 0.01),
    "check": lambda p, f: (p.folder, "--reference", check_points(f), "--reference-sigma", 0.02),
    "compare": lambda p, f: (p.folder, twin(p)),
    "compare methods": lambda p, f: (p.folder,),
    "targetless": lambda p, f: (few_lines(p, 2),),
    "history": lambda p, f: (p.folder,),
    "budget": lambda p, f: (p.folder,),
    "georeference": lambda p, f: (
        p.folder, "--output", f / "g", "--crs", "EPSG:32619", "--lines", p.lines[0].name,
    ),
    "trajectory": lambda p, f: (
        p.folder, "--output", f / "c.sbet", "--corrections", f / "c.csv",
    ),
    "export": lambda p, f: ("--what", "targets", p.folder, "--output", f / "t"),
    "identity": lambda p, f: (p.folder, "--vessel", "Saucier"),
    "acceptance": lambda p, f: (p.folder, "--rms", 0.02),
    "script": lambda p, f: (few_lines(p),),
    "batch": lambda p, f: (few_targets(p),),
    "angles": lambda p, f: (p.folder, "--to", "qinsy"),
    "angles with current settings": lambda p, f: (
        1, 2, 3, "--to", "qinsy", "--current", 1.1, 2.1, 3.1,
    ),
    "angles of all systems": lambda p, f: (),
    "visibility": lambda p, f: ("marine", "--output", f / "v", "--error", "roll"),
    "predict": lambda p, f: (PLAN,),
    "scenarios": lambda p, f: (PLAN, "--only", "speed"),
    "compare-plan": lambda p, f: (p.folder, "--plan", PLAN),
}  # fmt: skip
"""Words after each command, for a project and a folder for files; more than a word names a case."""

RUN_ELSEWHERE = {
    "pick": "cli/test_cli.py", "new": "cli/test_cli.py", "subsample": "cli/test_cli.py",
    "estimate": "cli/test_json_outputs.py", "validate": "cli/test_json_outputs.py",
    "warnings": "cli/test_cli_small.py", "design": "cli/test_cli_design.py",
    "campaign": "design/test_campaign.py", "patchtest": "patchtest/test_patch_test.py",
    "correspondences": "workflow/calibration/test_correspondences.py",
    "quality": "validation/test_line_quality.py",
}  # fmt: skip
"""Files of the tests that run a long command by `run_json`, which checks the schema too."""


def commands_with_json() -> set[str]:
    """Names of the commands with the option ``--json``."""
    found = set()
    for each in COMMANDS:
        parser = argparse.ArgumentParser()
        import_module(each.module).add_arguments(parser)
        if "--json" in parser.format_help():
            found.add(each.name)
    return found


def test_each_command_with_json_has_a_schema_and_is_run_here() -> None:
    assert set(OUTPUTS) == commands_with_json()
    run_here = {case.split()[0] for case in WORDS} | {"demo"}
    assert run_here | set(RUN_ELSEWHERE) == set(OUTPUTS)
    assert run_here & set(RUN_ELSEWHERE) == {"pick"}  # here with a list of seeds
    for command, file in RUN_ELSEWHERE.items():
        text = (Path(__file__).parents[1] / file).read_text(encoding="utf-8")
        assert re.search(rf'run_json\(\s*capsys, (\*new_words|\*words|"{command}")', text), command
        assert f'"{command}"' in text or command == "new", command


def test_published_schema_is_up_to_date() -> None:
    instruction = "an output of a command has changed: run `python -m tests.documents`"
    assert COMMANDS_PATH.read_text(encoding="utf-8") == commands_schema_text(), instruction


@pytest.mark.parametrize("case", WORDS)
def test_output_follows_the_schema(
    case: str,
    copy: Project,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    few = replace(MARINE_SITE, inclinations=(0.0, 0.8, 1.5))
    monkeypatch.setattr("lispac.simulation.thesis_site.SITES", {"marine": few})
    if case == "history":
        save_project(copy.with_identity(copy.identity.changed(dates="2026-03-04")))
    assert run_json(capsys, case.split()[0], *WORDS[case](copy, tmp_path))


def test_output_of_the_demo_follows_the_schema(
    calibrated: tuple[Project, Survey],
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("lispac.workflow.planning.demo.run_demo", lambda *_, **__: calibrated)
    monkeypatch.setattr("lispac.workflow.output.export.write_report", lambda *_: None)
    monkeypatch.setattr(demo, "rms_with_truth", lambda *_: {"V1": 0.0123})
    found = run_json(capsys, "demo", "--output", tmp_path, "--no-window")
    assert found["project"] == str(calibrated[0].folder)


@pytest.fixture(scope="module")
def printed_warnings(
    calibrated: tuple[Project, Survey], tmp_path_factory: pytest.TempPathFactory
) -> str:
    """Output of `lispac warnings --json`."""
    folder = tmp_path_factory.mktemp("warnings") / "copy"
    shutil.copytree(calibrated[0].folder, folder)
    with redirect_stdout(StringIO()) as out:
        assert main(["warnings", str(folder), "--json"]) == 0
    return out.getvalue()


@pytest.mark.parametrize(
    "change",
    others_long(
        [
            lambda data: data.pop("warnings"),
            lambda data: data.update(warnings=None),
            lambda data: data.update(others=[]),
            lambda data: data["warnings"][0].pop("code"),
            lambda data: data["warnings"][0].update(level="grave"),
        ]
    ),
)
def test_other_outputs_are_refused(
    change: Callable[[dict[str, Any]], object], printed_warnings: str
) -> None:
    data = followed_output("warnings", printed_warnings)
    assert data["warnings"]
    change(data)
    with pytest.raises(ValidationError):
        followed_output("warnings", json.dumps(data))


@pytest.mark.parametrize("command", OUTPUTS)
def test_each_command_prints_its_schema(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, command, "--schema")
    assert (code, err) == (0, "")
    schema = json.loads(out)
    Draft202012Validator.check_schema(schema)
    assert schema["title"] == f"lispac {command} --json"
    published = json.loads(COMMANDS_PATH.read_text(encoding="utf-8"))
    assert published["properties"][command].items() <= schema.items()
    assert schema["$defs"].items() <= published["$defs"].items()


def test_printed_schema_has_all_definitions_that_it_uses_and_no_others(
    capsys: pytest.CaptureFixture[str],
) -> None:
    schema = json.loads(run(capsys, "import", "--schema")[1])
    assert set(schema["$defs"]) == {"ImportOutput", ImportedLineOutput.__name__}
    line = {
        "folder": "L1", "points": 5, "excluded_points": 0, "bytes": 7, "seconds": 0.5,
        "assumptions": ["metres"],
    }  # fmt: skip
    output = {"schema_version": 1, "lines": {"L1": line}}
    Draft202012Validator(schema).validate(output)
    for other in (
        {**output, "lines": {"L1": {**line, "points": "5"}}},
        {**output, "schema_version": 2},
        {"lines": {"L1": line}},
    ):
        with pytest.raises(ValidationError):
            Draft202012Validator(schema).validate(other)


def test_a_proposal_that_does_not_determine_the_angles_has_no_sigma(
    copy: Project, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    found = Proposal((), {}, lambda names: np.array([0.001, np.inf, np.inf]), (), ())
    monkeypatch.setattr(
        "lispac.workflow.calibration.proposals.propose_targets", lambda *_, **__: found
    )
    assert run_json(capsys, "propose", copy.folder)["sigma_deg"] is None
    out = run(capsys, "propose", copy.folder)[1]
    assert out.splitlines()[2].split() == ["all", "targets", *["not", "determined"] * 3]


def report_of(folder: Path, capsys: pytest.CaptureFixture[str]) -> dict[str, Any]:
    path = folder / "of-the-report.json"
    code, _, err = run(capsys, "report", folder, "--output", path)
    assert code == 0, err
    return json.loads(path.read_text(encoding="utf-8"))  # type: ignore[no-any-return]


def test_estimate_prints_the_values_of_the_report(
    copy: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    sighting = copy.targets[0].sightings[0]
    by_hand = replace(copy.targets[0], sightings=(
        replace(sighting, by_hand=True), *copy.targets[0].sightings[1:],
    ))  # fmt: skip
    save_project(copy.with_target(by_hand))
    printed = run_json(capsys, "estimate", copy.folder)
    report = report_of(copy.folder, capsys)
    adjustment = {key: printed[key] for key in report["adjustment"]}
    assert adjustment == report["adjustment"]
    settings = ("subsample_m", "standard_deviations", "origin_deg_m")
    assert {key: printed[key] for key in settings} == {
        key: report["settings"][key] for key in settings
    }
    assert printed["cross_checks"] == report["cross_checks"]
    assert printed["qualities"] == report["qualities"]
    assert [each["edited_by_hand"] for each in report["qualities"]].count(True) == 1
    for each in printed["warnings"]:
        assert each in report["warnings"]
    assert printed["control"] == report["control"]
    others = {"schema_version", "elapsed_s", "cross_checks", "qualities", "warnings", "control"}
    assert set(printed) == {*report["adjustment"], *others, *settings}


@LONG
def test_validate_prints_the_values_of_the_report(
    copy: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    (first, *_) = copy.targets_of_role("validation")
    once = replace(first, name="V9", sightings=first.sightings[:1])
    project = replace(copy, acceptance=copy.acceptance.changed(rms=0.001)).with_target(once)
    save_project(project)
    printed = run_json(capsys, "validate", copy.folder)
    report = report_of(copy.folder, capsys)
    for key in ("validation", "not_compared", "acceptance"):
        assert printed[key] == report[key], key
    assert printed["validation"]
    assert [each["params"]["plane"] for each in printed["not_compared"]] == ["V9"]
    for each in printed["warnings"]:
        assert each in report["warnings"]
    assert set(printed) - set(report) == {"rms_truth_m"}
