"""Tests of the commands for the design of a site: predict, scenarios, design, compare-plan."""

import csv
import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from lispac.design.objective import PlanObjective
from lispac.design.plan_search import DesignResult, ReductionStep
from lispac.design.prediction import predict
from lispac.design.site import Site
from lispac.io.config.plan_file import read_plan
from lispac.message_texts import message_text
from lispac.messages import error, note
from lispac.project import Project
from lispac.workflow.planning.demo import calibrate_demo
from lispac.workflow.planning.plan_checks import write_design
from lispac.workflow.project.projects import open_project
from tests.cli.test_cli import run, run_json
from tests.support.command_errors import command_error, refused_with
from tests.support.narrow_site import narrow_site

PORT = Path(__file__).parents[1] / "data" / "port-plan.toml"
QUAY = Path(__file__).parents[2] / "resources" / "sites" / "quay.toml"


def printed_by(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    """Output of a command that succeeds."""
    code, out, err = run(capsys, *words)
    assert code == 0, err
    return out


def test_predict(capsys: pytest.CaptureFixture[str]) -> None:
    found = run_json(capsys, "predict", PORT)
    assert found["determined"]
    assert len(found["points"]) == 12
    sigma = {"roll": 0.0126, "pitch": 0.0282, "yaw": 0.0241}
    assert found["sigma_deg"] == pytest.approx(sigma, abs=0.0002)
    assert set(found["largest_sigma_without_deg"]) == {"T1", "T2", *(f"L{k}" for k in range(1, 7))}
    printed = printed_by(capsys, "predict", PORT)
    assert "Least precisely determined: pitch" in printed
    assert "roll-pitch" in printed


def test_undetermined_plans_are_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    text = PORT.read_text()
    one_way = tmp_path / "one-way.toml"
    one_way.write_text(text.replace("inclination_deg = 45\n", ""))
    assert message_text(note("plan_survey.one_orientation")) in printed_by(
        capsys, "predict", one_way
    )
    one_line = tmp_path / "one-line.toml"
    one_line.write_text(text[: text.index("[[lines]]", text.index("[[lines]]") + 1)])
    found = run_json(capsys, "predict", one_line)
    assert found["sigma_deg"] is None
    assert [each["code"] for each in found["messages"]] == ["design.undetermined"]
    missing = command_error("predict", tmp_path / "none.toml")
    assert missing.message == error(
        "file.not_found", file=str(tmp_path / "none.toml"), kind=note("file.kind_plan")
    )


def test_scenarios(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    folder = tmp_path / "out"
    printed = printed_by(capsys, "scenarios", "--only", "lines", "size", "--output", folder)
    assert "all six" in printed
    assert "not determined" in printed
    with (folder / "scenarios.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 2 * (11 + 4)
    outcomes = run_json(capsys, "scenarios", "--only", "lines", "size")["outcomes"]
    for row, each in zip(rows, outcomes, strict=True):
        sigma = each.pop("sigma_deg") or dict.fromkeys(("roll", "pitch", "yaw"))
        for angle, value in sigma.items():
            assert row.pop(f"{angle}_deg") == ("" if value is None else f"{value:.6f}")
        assert row == {key: str(value) for key, value in each.items()}
    assert {path.name for path in folder.iterdir()} == {"scenarios.csv", "lines.svg", "size.svg"}
    # The scenarios of the thesis have their own boards, wherever the wall of the plan is
    assert run(capsys, "scenarios", PORT, "--only", "size")[1].count("not determined") == 0
    found = run_json(capsys, "scenarios", PORT, "--only", "distance")
    assert {each["scenario"] for each in found["outcomes"]} == {"distance"}


def test_design(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    site, folder = tmp_path / "site.toml", tmp_path / "out"
    site.write_text(narrow_site({"up_m = [2, 5, 8]": "up_m = [2, 8]"}))
    found = run_json(capsys, "design", site, "--workers", 1, "--output", folder)
    assert found["exact"]
    assert found["plans_evaluated"] == 28 * 27
    assert {path.name for path in folder.iterdir()} == {
        "plan.toml", "field-plan.pdf", "front.svg", "front.csv",
    }  # fmt: skip
    again = run_json(capsys, "predict", folder / "plan.toml")
    assert again["sigma_deg"] == pytest.approx(found["sigma_deg"], rel=1e-6)
    assert run_json(capsys, "design", site, "--workers", 2) == found
    printed = printed_by(capsys, "design", site, "--workers", 1, "--for", "yaw")
    assert "smallest standard deviation of yaw" in printed
    assert "all that are possible" in printed
    assert (folder / "field-plan.pdf").read_bytes().startswith(b"%PDF")


def test_names_in_the_table_of_a_design_are_text(tmp_path: Path) -> None:
    plan = read_plan(PORT).plan
    name = '=1+1, "a"'
    plan = plan.with_targets([replace(plan.targets[0], name=name), *plan.targets[1:]])
    design = DesignResult(
        plan, predict(plan), 1e-3, True, 1, (), (ReductionStep(plan, 45.0, 1e-3),)
    )
    write_design(tmp_path, "Port", Site((0.0, -15.0, 0.0), 270.0), design, PlanObjective())
    with (tmp_path / "front.csv").open(newline="") as file:
        (row,) = csv.DictReader(file)
    assert row["targets"] == f"'{name} T2"
    assert row["lines"] == "6"
    assert [each.name for each in read_plan(tmp_path / "plan.toml").plan.targets] == [name, "T2"]


def test_invalid_limits_are_refused(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    site = tmp_path / "site.toml"
    site.write_text(QUAY.read_text().replace("on_site_min = 60", "on_site_min = 5"))
    refused_with("design.too_long", "design", site, available=5.0)


@pytest.mark.long
def test_replay_of_the_built_in_survey(
    whole_demo: Project, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """With the surveyed points and motion, the estimated sigmas agree with the predicted ones."""
    folder = tmp_path / "port"
    shutil.copytree(whole_demo.folder, folder)
    calibrate_demo(open_project(folder))
    found = run_json(capsys, "compare-plan", folder, "--plan", PORT)
    adjusted, predicted = (
        found["obtained_sigma_deg"],
        found["surveyed_with_form_error_sigma_deg"],
    )
    assert adjusted == pytest.approx(predicted, rel=0.05)


def test_a_survey_is_compared_with_plans(
    copy: Project, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """With its own plan, and with plans of another line, board, distance and other names."""
    folder = copy.folder
    found = run_json(capsys, "compare-plan", folder, "--plan", PORT)
    assert found["missing_lines"] == []
    assert found["missing_targets"] == []
    more = tmp_path / "more.toml"
    further = '[[lines]]\nheading_deg = 20\ndistance_m = 30\nsite_on = "starboard"\n'
    board = '[[boards]]\nname = "T9"\nalong_m = 4\nup_m = 12\n'
    more.write_text(PORT.read_text() + further + board)
    larger = run_json(capsys, "compare-plan", folder, "--plan", more)
    (unsurveyed,) = larger["missing_lines"]
    assert re.findall(r"\d+", unsurveyed) == ["020", "30"]
    assert larger["missing_targets"] == ["T9"]
    assert {each["code"] for each in larger["messages"]} == {"plan_survey.smaller_sigma"}
    smaller = [each["params"] for each in larger["messages"]]
    assert [each["sigma"] < each["without"] for each in smaller] == [True, True]
    far = tmp_path / "far.toml"
    far.write_text(PORT.read_text().replace("distance_m = 15", "distance_m = 30", 1))
    off = run_json(capsys, "compare-plan", folder, "--plan", far)
    (message,) = off["messages"]
    assert message["code"] == "plan_survey.other_distance"
    assert message["params"]["line"] == 1
    assert message["params"]["planned"] == 30
    assert message["params"]["distance"] == pytest.approx(15, abs=0.5)
    assert off["surveyed_sigma_deg"] == pytest.approx(found["surveyed_sigma_deg"], rel=0.02)
    strange = tmp_path / "strange.toml"
    text = PORT.read_text().replace('"T1"', '"A"').replace('"T2"', '"B"')
    strange.write_text(text)
    refusal = command_error("compare-plan", folder, "--plan", strange)
    assert refusal.code == "plan_survey.no_target_measured"
    assert read_plan(strange).plan.targets[0].name == "A"
