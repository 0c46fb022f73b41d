"""``lispac compare`` on projects: the answer, the words, and what is refused."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.io.project_file import write_project
from lispac.project import Project
from tests.report_sample import sample_project
from tests.test_cli import answer, refused, run


def surveyed_again(folder: Path, off_deg: tuple[float, float, float]) -> Project:
    """Another survey with the same mounting, its answer off by so much."""
    project = sample_project(folder)
    result = project.result
    assert result is not None
    mounting = result.mounting.with_boresight(result.boresight + np.radians(off_deg))
    project = replace(project, result=replace(result, mounting=mounting))
    write_project(project)
    return project


def test_three_surveys(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    first = surveyed_again(tmp_path / "july", (0.0, 0.0, 0.0))
    surveyed_again(tmp_path / "august", (0.01, -0.01, 0.02))
    surveyed_again(tmp_path / "october", (0.0, 0.2, 0.0))
    projects = [tmp_path / name for name in ("july", "august", "october")]
    found = answer(capsys, "compare", *projects)
    assert [each["name"] for each in found["calibrations"]] == ["july", "august", "october"]
    close, bumped = found["differences"]
    assert close["angles_deg"] == pytest.approx([0.01, -0.01, 0.02])
    assert not close["differ"]
    assert bumped["differ"]
    assert bumped["significant"] == [False, True, False]
    assert first.result is not None
    assert bumped["sigma_deg"] == pytest.approx(
        np.degrees(np.sqrt(2) * first.result.sigma).tolist()
    )
    assert bumped["displacement_m"] == pytest.approx(np.radians(0.2) * np.array([10, 50, 100]))
    assert found["together"]["differ"]
    assert found["remarks"] == []
    code, out, _ = run(capsys, "compare", *projects)
    assert code == 0
    assert "+0.2000" in out
    assert "DIFFER" in out
    assert "a point moves 3.5 cm at 10 m, 17.5 cm at 50 m, 34.9 cm at 100 m" in out
    assert "scatter MORE than their sigmas explain" in out


def test_what_the_two_share_is_told(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    first = surveyed_again(tmp_path / "a", (0.0, 0.0, 0.0))
    other = replace(
        first, folder=tmp_path / "b", settings=replace(first.settings, lever_arm=(0.0, 0.0, 2.0))
    )
    (tmp_path / "b").mkdir()
    write_project(other)
    shutil.copytree(tmp_path / "a" / "sightings", tmp_path / "b" / "sightings", dirs_exist_ok=True)
    remarks = answer(capsys, "compare", tmp_path / "a", tmp_path / "b")["remarks"]
    assert any("b rests on lines of a" in remark for remark in remarks)
    assert any("another lever arm than a" in remark for remark in remarks)


def test_what_cannot_be_compared(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    project = surveyed_again(tmp_path / "a", (0.0, 0.0, 0.0))
    assert "at least two calibrations" in refused(capsys, "compare", project.folder)
    assert "given twice" in refused(capsys, "compare", project.folder, project.folder)
    write_project(replace(project, folder=tmp_path / "bare", result=None, validation=()))
    assert "bare: there is no answer yet; estimate first" in refused(
        capsys, "compare", project.folder, tmp_path / "bare"
    )
