"""Tests of ``lispac control`` and of ``lispac estimate`` with control."""

from pathlib import Path

import numpy as np
import pytest

from lispac.project import Project
from lispac.workflow.project.projects import open_project, save_project
from tests.cli.test_cli import run, run_json
from tests.support.command_errors import refused_with
from tests.support.static_scans import on_plane

SIGMA = 0.002


def control_list(path: Path, wrong: float = 0.0) -> Path:
    """Four points on each target; the last one is displaced westwards by `wrong` metres."""
    generator, rows = np.random.default_rng(2), ["name,north,west,up,sigma,plane"]
    for board in ("T1", "T2"):
        corners = 0.4 * np.array([[-1, -1, 1, 1], [-1, 1, -1, 1]])
        places = on_plane(board, *corners) + SIGMA * generator.normal(size=(4, 3))
        places[-1, 1] += wrong * (board == "T2")
        for k, (north, west, up) in enumerate(places, start=1):
            rows.append(f"{board}.{k},{north:.5f},{west:.5f},{up:.5f},{SIGMA},{board}")
    path.write_text("\n".join(rows) + "\n")
    return path


def test_control_is_imported_excluded_and_removed(
    copy: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, path = copy.folder, control_list(tmp_path / "control.csv")
    found = run_json(capsys, "control", folder, path)
    assert [each["target"] for each in found["points"]] == ["T1"] * 4 + ["T2"] * 4
    assert found["files"][0]["used_points"] == 8
    assert found["comparison"] == []  # the result is out of date
    found = run_json(capsys, "control", folder, "--exclude", "T1.1", "T1.2")
    assert [each["name"] for each in found["points"] if not each["used"]] == ["T1.1", "T1.2"]
    found = run_json(capsys, "control", folder, "--use", "T1.1")
    assert [each["name"] for each in found["points"] if not each["used"]] == ["T1.2"]
    assert run_json(capsys, "control", folder) == found
    assert run_json(capsys, "control", folder, "--remove", path.name)["points"] == []


def test_an_estimate_contains_the_control(
    copy: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = control_list(tmp_path / "control.csv", wrong=0.1)
    run_json(capsys, "control", copy.folder, path)
    found = run_json(capsys, "estimate", copy.folder, "--no-cross-checks")
    control = found["control"]
    assert [row["name"] for row in control["comparison"]] == ["roll", "pitch", "yaw"]
    assert all(row["sigma_without_control"] > 0 for row in control["comparison"])
    wrong = {each["name"] for each in control["points"] if each["contradicts"]}
    assert "T2.4" in wrong
    warned = [each["params"]["name"] for each in found["warnings"]
              if each["code"] == "adjustment.control_contradicts"]  # fmt: skip
    assert warned[0] == "T2.4"
    code, out, _ = run(capsys, "control", copy.folder)
    assert code == 0
    assert "T2.4" in out


def test_control_is_listed_with_targets_added_since(
    copy: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The list shows the assignment that the next estimate uses."""
    folder, late = copy.folder, copy.target("T2")
    project = open_project(folder)
    save_project(project.without_target("T2"))
    found = run_json(capsys, "control", folder, control_list(tmp_path / "control.csv"))
    assert [each["target"] for each in found["points"]] == ["T1"] * 4 + [None] * 4
    save_project(open_project(folder).with_target(late))
    found = run_json(capsys, "control", folder)
    assert [each["target"] for each in found["points"]] == ["T1"] * 4 + ["T2"] * 4
    assert [each["used"] for each in found["points"]] == [True] * 8
    found = run_json(capsys, "estimate", folder, "--no-cross-checks")
    assert all(each["residual_m"] is not None for each in found["control"]["points"])


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (("--exclude", "A"), "control.unknown_point"),
        (("--remove", "A"), "control.unknown_file"),
    ],
)
def test_unknown_names_are_refused(copy: Project, words: tuple[str, ...], code: str) -> None:
    refused_with(code, "control", copy.folder, *words)


def test_a_point_cannot_be_used_and_excluded(
    copy: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _, _ = run(capsys, "control", copy.folder, "--use", "A", "--exclude", "A")
    assert code == 2
