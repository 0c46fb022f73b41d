"""Tests of ``lispac compare`` on projects: its result, its notes and its refusals."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.result import ANGLES
from lispac.io.project.project_file import write_project
from lispac.messages import note
from lispac.present.json_values import json_values
from lispac.project import Project
from lispac.workflow.checking.repeated_surveys import comparability_notes
from lispac.workflow.project.shared_lines import shared_lines
from tests.cli.test_cli import run, run_json
from tests.support.command_errors import command_error
from tests.support.message_codes import is_shown
from tests.support.report_sample import sample_project, with_lines_of_its_own


def surveyed_again(folder: Path, off_deg: tuple[float, float, float]) -> Project:
    """Another survey with the same mounting; its boresight is off by ``off_deg``."""
    project = with_lines_of_its_own(sample_project(folder))
    result = project.result
    assert result is not None
    mounting = result.mounting.with_boresight(result.boresight + np.radians(off_deg))
    project = replace(project, result=replace(result, mounting=mounting))
    write_project(project)
    return project


def by_angle(values: dict[str, float]) -> list[float]:
    return [values[name] for name in ANGLES]


def test_three_surveys_are_compared(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    first = surveyed_again(tmp_path / "july", (0.0, 0.0, 0.0))
    surveyed_again(tmp_path / "august", (0.01, -0.01, 0.02))
    surveyed_again(tmp_path / "october", (0.0, 0.2, 0.0))
    projects = [tmp_path / name for name in ("july", "august", "october")]
    found = run_json(capsys, "compare", *projects)
    assert [each["name"] for each in found["calibrations"]] == ["july", "august", "october"]
    close, bumped = found["differences"]
    assert by_angle(close["difference_deg"]) == pytest.approx([0.01, -0.01, 0.02])
    assert not close["differ"]
    assert bumped["differ"]
    assert bumped["significant_angles"] == ["pitch"]
    assert first.result is not None
    assert by_angle(bumped["sigma_deg"]) == pytest.approx(
        np.degrees(np.sqrt(2) * first.result.sigma).tolist()
    )
    assert bumped["displacement_m"] == pytest.approx(np.radians(0.2) * np.array([10, 50, 100]))
    assert found["combined"]["differ"]
    assert found["messages"] == []
    code, out, _ = run(capsys, "compare", *projects)
    assert code == 0
    assert "+0.2000" in out
    (row,) = (line.split() for line in out.splitlines() if line.split()[-1:] == ["yes"])
    assert [row[0], *row[-5:]] == ["october", "3.5", "17.5", "34.9", "0.000", "yes"]
    assert "scatter MORE than expected from their sigmas" in out


def test_shared_lines_and_lever_arms_are_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    first = surveyed_again(tmp_path / "a", (0.0, 0.0, 0.0))
    other = replace(
        first, folder=tmp_path / "b", settings=replace(first.settings, lever_arm=(0.0, 0.0, 2.0))
    )
    (tmp_path / "b").mkdir()
    write_project(other)
    shutil.copytree(tmp_path / "a" / "sightings", tmp_path / "b" / "sightings", dirs_exist_ok=True)
    messages = run_json(capsys, "compare", tmp_path / "a", tmp_path / "b")["messages"]
    for found in (
        note("repeat.same_lines", name="b", other="a"),
        note("repeat.lever_arm", name="b", other="a"),
    ):
        assert json_values(found) in messages
    part = replace(
        first, folder=tmp_path / "c", lines=surveyed_again(tmp_path / "c", (0, 0, 0)).lines
    )
    write_project(replace(part, lines=(first.lines[0], *part.lines[1:])))
    messages = run_json(capsys, "compare", tmp_path / "a", tmp_path / "c")["messages"]
    found = note("repeat.shared_lines", name="c", other="a", count=1)
    assert json_values(found) in messages


def test_copies_count_once(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    first = surveyed_again(tmp_path / "a", (0.0, 0.0, 0.0))
    shutil.copytree(tmp_path / "a", tmp_path / "b")
    surveyed_again(tmp_path / "c", (0.01, 0.0, 0.0))
    assert first.result is not None
    sigma = np.degrees(first.result.sigma)
    two = run_json(capsys, "compare", tmp_path / "a", tmp_path / "b")["combined"]
    assert two["counted"] == ["a"]
    assert by_angle(two["sigma_deg"]) == pytest.approx(sigma.tolist())
    assert two["spread_deg"] is None
    three = run_json(capsys, "compare", *(tmp_path / name for name in "abc"))["combined"]
    assert three["counted"] == ["a", "c"]
    assert by_angle(three["sigma_deg"]) == pytest.approx((sigma / np.sqrt(2)).tolist())
    _, out, err = run(capsys, "compare", tmp_path / "a", tmp_path / "b")
    assert "spread" not in out
    assert is_shown("repeat.same_lines", err)


def test_copies_of_lines_are_the_same_lines(tmp_path: Path) -> None:
    first = surveyed_again(tmp_path / "a", (0.0, 0.0, 0.0))
    copied = replace(
        first,
        lines=tuple(
            replace(line, path=Path(shutil.copy(line.path, tmp_path / f"copy-{k}.laz")))
            for k, line in enumerate(first.lines)
        ),
    )
    assert shared_lines(first, copied) == [line.name for line in first.lines]
    copied.lines[0].path.write_bytes(b"!" + first.lines[0].path.read_bytes()[1:])
    assert shared_lines(first, copied) == [line.name for line in first.lines[1:]]
    copied.lines[1].path.unlink()
    assert len(shared_lines(first, copied)) == len(first.lines) - 2


def test_projects_that_cannot_be_compared_are_refused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    project = surveyed_again(tmp_path / "a", (0.0, 0.0, 0.0))
    assert command_error("compare", project.folder, project.folder).code == "repeat.given_twice"
    write_project(replace(project, folder=tmp_path / "bare", result=None, validation=()))
    refusal = command_error("compare", project.folder, tmp_path / "bare")
    assert refusal.code == "estimate.needed"
    assert "bare" in str(refusal)


def test_the_nearest_point_accepts_no_radius(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    code, _, error = run(capsys, "validate", tmp_path, "--distance-to", "point", "--radius", "1")
    assert code == 2
    assert "do not apply to --distance-to point" in error


def test_differences_that_limit_a_comparison_are_reported(tmp_path: Path) -> None:
    first, second = (sample_project(tmp_path / name) for name in ("a", "b"))
    assert (
        comparability_notes(("a", "b"), (first, second)) == []
    )  # the same lines are reported elsewhere
    settings = replace(first.settings, pos_errors="independent", lever_arm=(0.0, 0.0, 1.0))
    other = replace(second, settings=settings, lines=second.lines[:2])
    first.lines[0].path.unlink()
    changed = replace(first, lines=first.lines[:3])
    notes = comparability_notes(("a", "b"), (changed, other))
    assert notes == [
        note("repeat.shared_lines", name="b", other="a", count=1),
        note("repeat.lever_arm", name="b", other="a"),
        note("repeat.pos_errors", name="b", other="a"),
    ]
