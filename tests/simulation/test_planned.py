"""Tests of the simulation of a plan: its survey has the predicted precision."""

from pathlib import Path

import numpy as np
import pytest

from lispac.simulation.scene import Sphere
from lispac.workflow.planning.plan_simulation import is_plan, simulation_of_plan
from lispac.workflow.project.projects import open_project
from tests.cli.test_cli import run, run_json, run_refused
from tests.support.message_codes import is_shown

PORT_PLAN = Path(__file__).parents[1] / "data" / "port-plan.toml"


def test_a_simulated_plan_has_the_predicted_sigmas(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    folder = tmp_path / "sailed"
    made = run_json(
        capsys, "simulate", PORT_PLAN, "--output", folder, "--points-per-second", 60_000,
        "--seed", 4, "--boresight", 0.5, -0.8, 0.4,
    )  # fmt: skip
    assert len(made["points"]) == 6
    assert run(capsys, "pick", folder, "--seeds", made["seeds"])[0] == 0
    assert run(capsys, "estimate", folder)[0] == 0
    project = open_project(folder)
    assert project.result is not None
    assert project.truth_deg == pytest.approx((0.5, -0.8, 0.4))
    off = np.degrees(project.result.boresight) - project.truth_deg
    assert (np.abs(off) < 3.5 * np.degrees(project.result.sigma)).all(), off
    found = run_json(capsys, "compare-plan", folder, "--plan", PORT_PLAN)
    assert found["missing_lines"] == []
    # The plan has two and a half times as many points, which has little effect
    obtained, predicted = (
        np.array(list(found[name].values()))
        for name in ("obtained_sigma_deg", "surveyed_with_form_error_sigma_deg")
    )
    ratio = obtained / predicted
    assert ((ratio > 0.9) & (ratio < 1.35)).all(), ratio


def test_simulated_boards_and_lines_are_those_of_the_plan() -> None:
    simulation = simulation_of_plan(PORT_PLAN)
    setup = simulation.setup
    assert setup.targets == ("T1", "T2")
    leaning = setup.scene["T2"]
    assert leaning.centre == pytest.approx([-1.1, 0.62, 6.4])
    assert leaning.normal == pytest.approx([0.0, np.sqrt(0.5), np.sqrt(0.5)])
    assert [leg.starboard for leg in setup.motion_source.legs] == [True, False] * 3
    assert simulation.lever_arm == pytest.approx((-0.242, 0.061, 2.173))


def test_files_that_are_not_plans_and_wrong_options_are_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert is_plan(PORT_PLAN)
    assert not is_plan(tmp_path / "none.toml")
    assert not is_plan(Path("port"))
    outcome = run(capsys, "simulate", PORT_PLAN, "--output", tmp_path / "a", "--scanner", "zf-9012")
    assert outcome[0] == 2
    assert "a survey plan contains its scanner and lines" in outcome[2]
    refused = run_refused(
        capsys, "simulate", PORT_PLAN, "--output", tmp_path / "a", "--vessel", "raft"
    )
    assert is_shown("simulate.no_vessel", refused)


def test_a_planned_ball_is_simulated_as_a_sphere(tmp_path: Path) -> None:
    """Its centre is that of a board with the same numbers."""
    ball = '[[balls]]\nname = "B1"\nalong_m = 1.1\noff_m = 0.62\nup_m = 6.4\nradius_m = 0.145\n'
    path = tmp_path / "plan.toml"
    path.write_text(PORT_PLAN.read_text().replace("[[lines]]", f"{ball}[[lines]]", 1))
    setup = simulation_of_plan(path).setup
    assert setup.targets == ("T1", "T2", "B1")
    found = setup.scene["B1"]
    assert isinstance(found, Sphere)
    assert found.radius == 0.145
    assert found.centre == pytest.approx(setup.scene["T2"].centre)
